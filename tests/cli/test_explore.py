"""``matrixworld explore`` and ``playground``, and the page at the end of ``evolve``."""

from pathlib import Path

import pytest
from click.testing import Result

from browser import data_of
from command_line import MAIN_JOB, PLACES, matrixworld_command, run_together
from matrixworld.cli import explore
from matrixworld.cli.explore import first_seeds
from matrixworld.cli.groups import groups_of
from matrixworld.coevolution import start
from matrixworld.explorer import Playground
from tiny_race import tiny_race


@pytest.fixture(autouse=True)
def opened(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """Open no browser; return what would have been opened."""
    addresses: list[str] = []
    monkeypatch.setattr(explore.webbrowser, "open", lambda url: addresses.append(url) or True)
    return addresses


def test_evolve_ends_with_a_page_of_all_its_races(main_job: tuple[Path, Result]) -> None:
    root, told = main_job
    assert f"Open {root.name}/explorer.html" in run_together(told.stdout)
    data = data_of(root / "explorer.html")
    assert data["title"] == "main job"
    assert [run["name"] for run in data["runs"]] == PLACES


def test_a_page_is_written_beside_the_run_and_opened(run: Path, opened: list[str]) -> None:
    result = matrixworld_command("explore", run)
    page = run / "explorer.html"
    assert result.output.strip() == str(page)
    assert opened == [page.absolute().as_uri()]
    matrixworld_command("explore", run, "--force", "--no-open")
    assert len(opened) == 1


def test_a_machine_without_a_browser_gets_the_file(
    main_job: tuple[Path, Result], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(explore.webbrowser, "open", lambda url: False)
    runs = [main_job[0] / name for name in MAIN_JOB[:2]]
    result = matrixworld_command("explore", *runs, "-o", tmp_path / "page.html")
    assert "No browser was found here" in result.output
    assert [run["name"] for run in data_of(tmp_path / "page.html")["runs"]] == PLACES[:2]


def test_many_seeds_show_some_of_each_group_and_say_so(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    names = [f"{schedule}-{seed}" for schedule in ("generalist-specialist", "hall-of-fame")
             for seed in range(3)]  # fmt: skip
    for name in names:
        schedule, _, seed = name.rpartition("-")
        start(tiny_race(schedule=schedule, seed=int(seed)), tmp_path / name, threads=1).run()
    monkeypatch.setattr(explore, "MOST_RUNS", 4)
    result = matrixworld_command("explore", tmp_path, "--no-open")
    data = data_of(tmp_path / "explorer.html")
    shown = [name for name in names if name[-1] in "01"]
    assert sorted(run["name"] for run in data["runs"]) == sorted(shown)
    assert data["note"].startswith("The page shows 4 of 6 runs")
    assert "The page shows 4 of 6 runs" in result.output
    groups = groups_of([tmp_path / name for name in names])
    assert [run.path.name for run in first_seeds([group.runs for group in groups], 6)] == names


# The playground


def test_the_playground_is_written_and_opened(tmp_path: Path, opened: list[str]) -> None:
    result = matrixworld_command("playground")
    page = tmp_path / "playground.html"
    assert page.read_text(encoding="utf-8") == Playground().html()
    assert result.output == "playground.html\n"
    # The same page needs no --force.
    matrixworld_command("playground", "--no-open")
    assert opened == [page.as_uri()]


def test_another_file_than_a_playground_is_kept(tmp_path: Path, opened: list[str]) -> None:
    page = tmp_path / "page.html"
    page.write_text("mine")
    result = matrixworld_command("playground", "-o", page, code=2)
    assert "exists; give --force to replace it" in result.output
    assert (page.read_text(), opened) == ("mine", [])
    matrixworld_command("playground", "-o", page, "--force")
    assert page.read_text(encoding="utf-8") == Playground().html()
