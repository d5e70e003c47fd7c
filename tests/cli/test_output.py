"""What commands print, as a whole: numbers are masked, which other tests compare."""

import re
import shutil
from pathlib import Path

import pytest
from click.testing import Result

from command_line import MAIN_JOB, RACE, WORLD, matrixworld_command, words

ONE = ["--schedule", MAIN_JOB[2]]
SEEDS = [*ONE, "--seeds", "5-7", *words({n: v for n, v in RACE.items() if n != "seed"})]
ALONE = words({"schedule": "against", "epochs": 3, **WORLD})
JOBS = {"seeds": SEEDS, "alone": ALONE}


def masked(text: str) -> str:
    """Return a text with a sign for each number, and without the widths of columns."""
    numbers = re.sub(r"(?<![\w-])[+-]?\d[\d,]*(\.\d+)?%?", "#", text)
    return "\n".join(re.sub(r"(?<=\S) +", " ", line) for line in numbers.splitlines())


@pytest.fixture(scope="module")
def said(tmp_path_factory: pytest.TempPathFactory, main_job: tuple[Path, Result]) -> dict[str, str]:
    """What `evolve` prints of some jobs; they lie in the working directory of the module."""
    with pytest.MonkeyPatch.context() as patch:
        patch.chdir(tmp_path_factory.mktemp("jobs"))
        outputs = {
            name: matrixworld_command("evolve", "--out", name, *options, "--threads", 1).stdout
            for name, options in JOBS.items()
        }
        directory, told = main_job
        shutil.copytree(directory, directory.name)
        return outputs | {directory.name: told.stdout, "directory": str(Path.cwd())}


@pytest.mark.parametrize("job", ["main job", *JOBS])
def test_evolve(said, snapshot, job):
    assert masked(said[job]) == snapshot


@pytest.mark.parametrize(
    "command",
    [
        ["evolve", "--variants"],
        ["judge", "seeds", "--explain"],
        ["score", f"main job/{MAIN_JOB[0]}", "--episodes", 4],
        ["score", "seeds", "--episodes", 4],
        ["score", "alone", "--episodes", 4, "--generation", "all"],
        ["tournament", f"main job/{MAIN_JOB[0]}", "--episodes", 4, "--force"],
        ["explore", "seeds", "--figures", "--force"],
    ],
    ids=lambda command: " ".join(map(str, command[:3])),
)
def test_commands(said, snapshot, monkeypatch, command):
    monkeypatch.chdir(said["directory"])
    assert masked(matrixworld_command(*command).stdout) == snapshot
