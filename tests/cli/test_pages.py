"""``matrixworld explore`` and ``playground``, and the page at the end of ``evolve``."""

from pathlib import Path

import pytest
from click.testing import Result

from browser import data_of
from command_line import MAIN_JOB, PLACES, matrixworld_command, run_together
from matrixworld.cli import pages
from matrixworld.coevolution import finish
from matrixworld.coevolution.groups import open_groups
from matrixworld.explorer import Playground
from tiny_race import tiny_race


@pytest.fixture(autouse=True)
def opened(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """Open no browser; return what would have been opened."""
    addresses: list[str] = []
    monkeypatch.setattr(pages.webbrowser, "open", lambda url: addresses.append(url) or True)
    return addresses


def test_evolve_ends_with_a_page_of_all_its_races(main_job: tuple[Path, Result]) -> None:
    root, told = main_job
    assert f"Open {root.name}/explorer.html" in run_together(told.stdout)
    data = data_of(root / "explorer.html")
    assert data["title"] == "main job"
    assert [run["name"] for run in data["runs"]] == PLACES


def test_a_page_of_some_races_is_written_and_opened(
    main_job: tuple[Path, Result], opened: list[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    runs = [main_job[0] / name for name in MAIN_JOB[:2]]
    result = matrixworld_command("explore", *runs, "-o", "page.html")
    page = Path("page.html").absolute()
    assert result.output == "page.html\n"
    assert opened == [page.as_uri()]
    assert [run["name"] for run in data_of(page)["runs"]] == PLACES[:2]
    monkeypatch.setattr(pages.webbrowser, "open", lambda url: False)
    # What the package has drawn is drawn again.
    told = matrixworld_command("playground", "-o", "page.html").output
    assert "No browser was found here" in told
    assert page.read_text(encoding="utf-8") == Playground().html()


def test_many_seeds_show_some_of_each_group_and_say_so(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    names = [f"{name}/seed-{n}" for name in MAIN_JOB[:2] for n in range(3)]
    for name in names:
        schedule, _, seed = name.partition("/seed-")
        finish(tiny_race(schedule=schedule, seed=int(seed)), tmp_path / name, threads=1)
    monkeypatch.setattr(pages, "MOST_RUNS", 4)
    groups = open_groups(tmp_path)
    pages.write_explorer(groups, tmp_path / "page.html")
    data = data_of(tmp_path / "page.html")
    assert [run["name"] for run in data["runs"]] == [n for n in names if n[-1] in "01"]
    assert data["note"].startswith("The page shows 4 of 6 runs")
    assert "The page shows 4 of 6 runs" in capsys.readouterr().out
    every = pages.first_seeds([group.runs for group in groups], 6)
    assert [run.path for run in every] == [tmp_path / name for name in names]
