"""The page of runs that go on: what it shows, that nothing else is served, and how it ends."""

import http.client
import json
import os
import re
import socket
import time
import urllib.request
from collections.abc import Iterator
from contextlib import ExitStack, suppress
from pathlib import Path
from typing import Any
from urllib.parse import urlsplit

import numpy as np
import pytest

from browser import DESKTOP, READY, Browser
from matrixworld.coevolution import TEAMS, SavedRun, evolve, open_run, start
from matrixworld.coevolution.progress import Progress
from matrixworld.explorer import explore
from matrixworld.explorer.live import EPISODES, HOST, MOST_CONNECTIONS, LivePage, extended
from matrixworld.world.policy import Population
from tiny_race import tiny_race, tiny_single

JOB = {
    "specialists/seed-5": tiny_race(schedule="specialist-specialist"),
    "hall/seed-5": tiny_race(schedule="hall-of-fame"),
    "alone/seed-5": tiny_single(team="evader", opponent="chaser"),
}


@pytest.fixture(scope="module")
def job(tmp_path_factory: pytest.TempPathFactory) -> Path:
    root = tmp_path_factory.mktemp("jobs") / "job"
    for name, settings in JOB.items():
        start(settings, root / name, threads=1).run()
    return root


@pytest.fixture
def live(job: Path) -> Iterator[LivePage]:
    with LivePage(job, [*JOB]) as page:
        yield page


def get(url: str, method: str = "GET", **headers: str) -> int:
    """Return the status of an answer."""
    parts = urlsplit(url)
    connection = http.client.HTTPConnection(HOST, parts.port, timeout=20)
    connection.request(method, parts.path, headers=headers)
    return connection.getresponse().status


def asked(page: LivePage) -> dict[str, Any]:
    """Return what the page asks for."""
    with urllib.request.urlopen(f"{page.url}progress") as answer:
        found: dict[str, Any] = json.loads(answer.read())
    return found


def until_shown(page: LivePage, least: int = 1) -> None:
    """Wait until so many looks have found something new."""
    for _ in range(400):
        if int(asked(page)["version"]) >= least:
            return
        time.sleep(0.05)
    raise AssertionError("expected the runs on the page, got none")


def test_only_the_page_is_served_and_only_to_this_machine(live: LivePage, job: Path) -> None:
    until_shown(live)
    assert live._server.server_address[0] == HOST == "127.0.0.1"
    assert [get(live.url), get(f"{live.url}progress")] == [200, 200]
    root, token = f"http://{urlsplit(live.url).netloc}", urlsplit(live.url).path
    inside = ["job.json", "../job.json", "specialists/seed-5/config.json", "%2e%2e/", "progress/"]
    others = ["/", "/progress", f"/{'x' * (len(token) - 2)}/", f"/{job / 'job.json'}", token[:-1]]
    for path in [*(token + each for each in inside), *others]:
        assert get(root + path) == 404, path
    # A web site whose name points to this machine; and requests that would change something.
    assert get(live.url, Host="example.org") == 404
    assert {get(live.url, method) for method in ("POST", "PUT", "DELETE", "OPTIONS")} == {501}
    with LivePage(job, [*JOB]) as other:
        assert urlsplit(other.url).path != token


def test_the_page_tells_phases_share_rate_and_time_left(live: LivePage) -> None:
    work = {"hall": Progress("generation 2 of 3: evaders", 25, 50)}
    progress = Progress("<1 of 2> runs", 25, 100, runs=work)
    live.report(progress)
    shown = asked(live)
    assert shown["share"] == 0.25
    assert re.fullmatch(
        r"<1 of 2> runs, hall: generation 2 of 3: evaders:  25%  \d\d:\d\d left, .*matches/s",
        shown["text"],
    )
    with LivePage(Path("not begun"), []) as page:
        page.report(progress)
        waiting = page.answer(urlsplit(page.url).path)
    assert re.search("<p>&lt;1 of 2&gt;.* 25%", str(waiting))


@pytest.mark.slow
def test_connections_that_ask_nothing_take_no_files_from_the_run(live: LivePage) -> None:
    """Nor do slow ones, and the page is still there for others."""
    until_shown(live)
    port, before = urlsplit(live.url).port, len(os.listdir("/proc/self/fd"))
    with ExitStack() as stack:
        for _ in range(100):
            idle = stack.enter_context(socket.create_connection((HOST, port), 5))
            with suppress(ConnectionError):
                idle.send(b"G")
        assert get(live.url) == 200
        served = len(os.listdir("/proc/self/fd")) - 100 - before
        assert served <= MOST_CONNECTIONS + 1


def test_untrained_teams_are_shown_before_anything_is_learned(tmp_path: Path) -> None:
    start(tiny_race(), tmp_path / "run")
    with LivePage(tmp_path, ["run"]) as page:
        until_shown(page)
        assert '"live":"' in str(page.answer(urlsplit(page.url).path))


def bytes_of(root: Path) -> dict[Path, bytes]:
    files = (file for file in root.rglob("*") if file.is_file() and file.name != "explorer.html")
    return {file.relative_to(root): file.read_bytes() for file in files}


@pytest.mark.slow
def test_runs_have_the_same_bytes_with_a_page_beside_them(job: Path, tmp_path: Path) -> None:
    root = tmp_path / "job"
    with LivePage(root, [*JOB]) as page:
        assert b"first run begins" in urllib.request.urlopen(page.url).read()
        evolve(JOB, root, threads=1)
        until_shown(page)
        assert b'"live":"' in urllib.request.urlopen(page.url).read()
    for name in JOB:
        assert bytes_of(root / name) == bytes_of(job / name)


@pytest.mark.parametrize("name", JOB)
def test_cells_are_the_first_episodes_of_the_evaluation_however_they_grew(
    job: Path, name: str
) -> None:
    run = open_run(job / name)
    known = None
    for pursuers, evaders in ((1, 1), (2, 1), (2, 3), (3, 3), (9, 9)):
        parts = zip(TEAMS, (pursuers, evaders), strict=True)
        teams = {team: first_of(run.teams[team], most) for team, most in parts}
        grown = SavedRun(run.path)
        grown.teams = teams
        known = extended(grown, known, lambda played: None)
    final = run.payoff()
    shape = final.capture_rate.shape  # of one team alone, the last generation only
    for field in ("capture_rates", "lengths"):
        shown = getattr(known, field)[-shape[0] :, -shape[1] :]
        np.testing.assert_array_equal(shown, getattr(final, field)[:, :, :EPISODES])


def first_of(team: Population | str, most: int) -> Population | str:
    return team if isinstance(team, str) else Population(team.genomes[:most], team.network)


@pytest.mark.nightly
def test_a_browser_follows_the_runs_and_ends_with_the_finished_page(
    browser: Browser, live: LivePage, job: Path
) -> None:
    until_shown(live, len(JOB))
    browser.resize(*DESKTOP)
    browser.driver.get(live.url)
    browser.wait(READY)
    assert browser.js("document.querySelector('.note').textContent").startswith("The runs go on.")
    assert browser.js("document.querySelectorAll('.race').length") == len(JOB)
    browser.wait("document.querySelector('#match').dataset.played === '0 2 2 0 '")
    live.finish(explore(*(job / name for name in JOB), force=True).path)
    browser.wait("document.readyState === 'complete' && document.querySelector('.diagnosis')")
    assert browser.js("document.querySelector('.note')") is None
    assert browser.errors() == []
