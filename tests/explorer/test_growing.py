"""The page of runs that go on: what it shows, what it leaves alone, and how it ends."""

import time

import numpy as np
import pytest

from browser import DESKTOP, READY, data_of
from matrixworld.coevolution import TEAMS, SavedRun, create, evolve, open_run
from matrixworld.explorer import explore, runs_page
from matrixworld.explorer.runs_page import SO_FAR, GrowingPage, extended
from matrixworld.world.policy import Population
from tiny_race import tiny_race, tiny_single

JOB = {
    "hall/seed-5": tiny_race(schedule="hall-of-fame"),
    "alone/seed-5": tiny_single(team="evader", opponent="chaser"),
}
NAMES = [*JOB]


@pytest.fixture(scope="module")
def job(tmp_path_factory):
    root = tmp_path_factory.mktemp("jobs") / "job"
    evolve(JOB, root, threads=1)
    return root


@pytest.fixture
def _at_once(monkeypatch):
    """Pages are written whenever there is more to show."""
    monkeypatch.setattr(runs_page, "SECONDS", 0.0)
    monkeypatch.setattr(runs_page, "SHARE", np.inf)


@pytest.mark.usefixtures("_at_once")
def test_runs_have_the_same_bytes_with_a_page_that_grows(job, tmp_path):
    root, page = tmp_path / "job", GrowingPage(tmp_path / "job", NAMES)
    page.write()
    assert not root.exists()
    shapes = []

    def look(progress):
        page.write()
        shown = data_of(root / "explorer.html")
        assert shown["growing"]
        assert shown["note"].startswith("The runs go on.")
        shapes.append([run["payoff"]["shape"] for run in shown["runs"]])

    for name, settings in JOB.items():
        evolve(settings, root / name, threads=1, report=look)
    assert shapes[0] == [[1, 1]]  # untrained teams, before anything is learned
    assert shapes[-1] == [[3, 3], [1, 4]]
    page.write()
    ended = data_of(root / "explorer.html")
    assert [run["findings"] and bool(run["findings"]["table"]) for run in ended["runs"]] == [
        True, None,
    ]  # fmt: skip
    for name in NAMES:
        files = [file.name for file in (job / name).iterdir() if file.is_file()]
        for file in files:
            assert (root / name / file).read_bytes() == (job / name / file).read_bytes()


@pytest.mark.parametrize("name", JOB)
def test_cells_are_the_first_episodes_of_the_evaluation(job, name):
    run = open_run(job / name)
    known = None
    for pursuers, evaders in ((1, 1), (2, 1), (2, 3), (3, 3), (9, 9)):
        parts = zip(TEAMS, (pursuers, evaders), strict=True)
        teams = {team: first_of(run.teams[team], most) for team, most in parts}
        grown = SavedRun(run.path)
        grown.teams = teams
        known = extended(grown, known)
    final = run.payoff()
    shape = final.matrix.shape  # of one team alone, the last generation only
    for field in ("scores", "lengths"):
        shown = known.arrays()[field][-shape[0] :, -shape[1] :]
        np.testing.assert_array_equal(shown, final.arrays()[field][:, :, :SO_FAR])


def first_of(team, most):
    return team if isinstance(team, str) else Population(team.genomes[:most], team.policy)


@pytest.mark.nightly
@pytest.mark.usefixtures("_at_once")
def test_a_browser_follows_the_runs_to_the_finished_page(browser, tmp_path):
    run = tmp_path / "run"
    create(tiny_race(max_steps=20), run)
    page = GrowingPage(tmp_path, ["run"])
    page.write()
    browser.open(tmp_path / "explorer.html", DESKTOP)
    browser.wait("document.querySelector('#match').dataset.played === '0 0 0 0 '")
    assert browser.js("document.querySelector('.note').textContent").startswith("The runs go on.")
    evolve(tiny_race(max_steps=20), run, threads=1)
    page.write()
    browser.wait("document.querySelector('#match').dataset.played === '0 2 2 0 '", 60)
    browser.js("(location.hash = '#run=0&pursuers=1&evaders=0&episode=1')")
    browser.wait("document.querySelector('#match').dataset.played === '0 1 0 1 '")
    explore(run, file=tmp_path / "explorer.html", force=True)
    browser.wait(f"document.querySelector('.note') === null && {READY}", 60)
    browser.wait("document.querySelector('#match').dataset.played === '0 1 0 1 '")
    browser.driver.execute_script("window.kept = true")
    time.sleep(6)
    assert browser.js("window.kept")  # the finished page stays as it is
    assert browser.errors() == []
