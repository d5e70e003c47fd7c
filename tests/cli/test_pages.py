"""``matrixworld explore`` and ``playground``, and the page at the end of ``evolve``."""

from pathlib import Path

from browser import data_of
from command_line import MAIN_JOB, PLACES, matrixworld_command
from matrixworld.cli import pages
from matrixworld.explorer import Playground


def test_pages_are_written_and_opened(main_job, monkeypatch):
    root, _ = main_job
    data = data_of(root / "explorer.html")  # that of evolve
    assert data["title"] == "main job"
    assert [run["name"] for run in data["runs"]] == PLACES
    opened = []
    monkeypatch.setattr(pages.webbrowser, "open", opened.append)
    runs = [root / name for name in MAIN_JOB[:2]]
    told = matrixworld_command("explore", *runs, "-o", "page.html").output
    page = Path("page.html").absolute()
    assert told.startswith("page.html\n")
    assert "No browser was found here" in told
    assert opened == [page.as_uri()]
    assert [run["name"] for run in data_of(page)["runs"]] == PLACES[:2]
    for _ in range(2):  # a page without a name is written anew
        matrixworld_command("playground", "--no-open")
    assert Path("playground.html").read_text(encoding="utf-8") == Playground().html()


def test_many_seeds_show_some_of_each_group_and_say_so(main_job, monkeypatch):
    assert pages.first_seeds(["abc", "d", "efg"], 5) == [*"abdef"]
    monkeypatch.setattr(pages.runs_page, "MOST_RUNS", 2)
    told = matrixworld_command("explore", main_job[0], "-o", "page.html", "--no-open").output
    data = data_of(Path("page.html"))
    assert [run["name"] for run in data["runs"]] == PLACES[:2]
    assert data["note"].startswith("The page shows 2 of 3 runs")
    assert "The page shows 2 of 3 runs" in told
