"""In a browser, without processes and threads, the package is imported and races run."""

from matrixworld.coevolution import evolve
from scripts import python
from tiny_race import results, tiny_race

EVOLVES = """
import like_a_browser
from pathlib import Path
import course
from matrixworld import cli, explorer, plots, solver
from matrixworld.coevolution import ProgressBar, evolve
from tiny_race import tiny_race

with ProgressBar() as bar:
    evolve([tiny_race(seed=1), tiny_race(seed=2)], Path({directory!r}), report=bar)
"""


def test_races_run_as_elsewhere(tmp_path):
    code = EVOLVES.format(directory=str(tmp_path / "browser"))
    python("-W", "error", "-c", code, check=True)
    for run in evolve([tiny_race(seed=1)], tmp_path / "here", threads=1):
        name = run.path.relative_to(tmp_path / "here")
        assert results(tmp_path / "browser" / name) == results(run.path)
