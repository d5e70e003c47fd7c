"""The page on which a race evolves: one file, and a race that can be watched and changed."""

import json
import webbrowser
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from threading import Thread

import numpy as np
import pytest

from browser import LAPTOP, PHONE
from command_line import matrixworld_command
from matrixworld import Matches, Population, Rating, WorldConfig, rollout
from matrixworld.explorer.evolve_page import PAGE, evolve_page

DOCS = Path(__file__).parents[2] / "docs"
MOST = 1_000_000
"""Bytes of the page."""
SMALL = "#world=meadow&policy=cells&population=8&steps=30&pursuers=2&evaders=2&seed=3&walls=60.61"
"""A race of networks that takes a second."""
QUICK = "#world=courtyard&population=8&steps=30&seed=3"
"""One of ratings."""


def test_the_page_is_small_and_that_of_docs_is_the_present_one():
    page = evolve_page()
    assert len(page.encode()) <= MOST
    assert (DOCS / PAGE).read_text(encoding="utf-8") == page, "run python docs/make_pages.py"


def test_evolve_writes_and_names_it(tmp_path, monkeypatch):
    monkeypatch.setattr(webbrowser, "open", lambda address: True)
    monkeypatch.chdir(tmp_path)
    assert matrixworld_command("evolve", "--page").output == f"{PAGE}\n"
    assert Path(PAGE).read_text(encoding="utf-8") == evolve_page()


STATE = "document.body.dataset.state"
LANE = "matrixworldEvolve.lanes[0]"
NEWEST = f"{LANE}.newestGeneration"
GENOMES = f"""JSON.stringify(['pursuer', 'evader'].map((team) =>
    {LANE}.run.genomes[team].map((genome) => Array.from(genome))))"""
ENDED = f"{STATE} === 'ended' && {LANE}.outcome"
FACTS = "document.querySelector('.facts').textContent"
TOLD = "document.querySelector('.told').textContent"
LINK = "document.querySelector('.doings input').value"


@pytest.fixture(scope="module")
def page(tmp_path_factory):
    file = tmp_path_factory.mktemp("evolve") / PAGE
    file.write_text(evolve_page(), encoding="utf-8")
    return file


def opened(browser, page, settings, size=LAPTOP):
    browser.resize(*size)
    browser.driver.get("about:blank")  # another address after the # loads no page
    browser.driver.get(page.as_uri() + settings)
    browser.wait("document.body.dataset.ready === 'true'")


def press(browser, text):
    """Press the button that begins with a text."""
    script = "[...document.querySelectorAll('button')].find((button) => button.offsetParent"
    browser.driver.execute_script(f"{script} && button.textContent.startsWith('{text}')).click()")


def choose(browser, name, value):
    browser.driver.execute_script(
        """const field = [...document.querySelectorAll(".field")].find((each) =>
          each.firstChild.textContent === arguments[0]).querySelector("select, input");
        if (field.type === "checkbox") return field.click();
        field.value = arguments[1];
        field.dispatchEvent(new Event("change"));""",
        name,
        value,
    )


@pytest.mark.slow
def test_a_race_is_its_link_goes_on_and_is_not_lost(browser, friend, firefox, page):
    """Bit for bit in other browsers: with changes on the way, stopped, and at its end."""
    opened(browser, page, QUICK.replace("30", "60"))  # slow enough to be stopped
    assert "of the evaders are caught" in browser.js(FACTS)
    browser.click(".evolve")
    browser.wait(f"{NEWEST} >= 1")
    choose(browser, "Evaders", "2")
    browser.wait(f"{NEWEST} >= 2")
    press(browser, "Stop")
    browser.wait(f"{STATE} === 'stopped' && {LANE}.outcome")
    told = {}
    for pursuers, until in (("5", "stopped"), ("4", "ended")):
        if until == "ended":
            press(browser, "Go on")
        changes = browser.js(f"{LANE}.changed.length")
        choose(browser, "Pursuers", pursuers)
        browser.wait(f"{STATE} === '{until}' && {LANE}.changed.length > {changes}", 60)
        browser.wait(f"{FACTS} === {LANE}.outcome?.sentence", 60)
        press(browser, "Link")
        told[browser.js(LINK)] = browser.js(GENOMES), browser.js(FACTS), until
    for link, (genomes, facts, until) in told.items():
        opened(friend, page, "#" + link.partition("#")[2])
        friend.wait(f"{STATE} === '{until}' && {FACTS} === {LANE}.outcome?.sentence", 60)
        assert friend.js(GENOMES) == genomes
        assert friend.js(FACTS) == facts
    last = browser.js("location.hash"), browser.js(GENOMES)
    firefox.open(page.as_uri() + last[0])
    firefox.wait(f"document.body.dataset.ready && {ENDED}")
    assert firefox.js(GENOMES) == last[1]
    browser.wait("document.querySelector('.shelf').hidden")
    browser.reload()
    assert (browser.js("location.hash"), browser.js(GENOMES)) == last
    press(browser, "Again, with seed 4")
    browser.wait("sessionStorage.length === 3", 60)  # it is kept when it has ended
    browser.driver.back()
    browser.wait(f"location.hash === '{last[0]}' && document.body.dataset.ready === 'true'")
    assert browser.js(GENOMES) == last[1]
    assert "courtyard, seed 4" in browser.js("document.querySelector('.shelf').textContent")
    press(browser, "15 more")  # the worker of the page before is gone: it plays the race again
    browser.wait(f"{NEWEST} === 30 && {ENDED}", 90)
    assert browser.js(GENOMES).startswith(last[1].split("]],")[0])
    assert browser.errors() == friend.errors() == []


@pytest.mark.slow
def test_a_friend_plays_the_match_of_a_challenge(browser, friend, page):
    opened(browser, page, QUICK, PHONE)
    browser.click(".evolve")
    browser.wait(ENDED, 60)
    assert browser.violations() == []
    press(browser, "Can you escape them?")
    browser.press(*"dsaw" * 8)
    browser.wait("document.querySelector('.play').dataset.state === 'ended'")
    score = browser.js("document.querySelector('#play-headline').textContent")
    press(browser, "Challenge a friend")
    link = browser.js("document.querySelector('.play-ending input').value")
    assert len(link) < 500
    opened(friend, page, "#" + link.partition("#")[2])
    told = friend.js("document.querySelector('.play-told').textContent")
    steps = int(next(filter(str.isdigit, score.split())))
    assert f"Your friend survived {steps} of 30 steps" in told
    friend.press(*"dsaw" * 8)  # the same moves from the same start
    friend.wait("document.querySelector('.play').dataset.state === 'ended'")
    assert "a draw" in friend.js("document.querySelector('.play-ending').textContent")
    press(friend, "Close")
    friend.wait(ENDED, 60)  # and how they evolved
    assert friend.js(GENOMES) == browser.js(GENOMES)
    assert browser.errors() == friend.errors() == []


@pytest.mark.slow
@pytest.mark.parametrize(
    ("address", "message"),
    [
        ("#world=mars&seed=7", "wrong, and left out: world=mars"),
        ("#race=abc&to=end&seed=7", "another version"),
        ("#race=abc&to=3_4&seed=7", "left out: to=3_4"),
        ("#play=1.0.4.9.80&pursuer=AAAA&evader=AAAA&seed=7", "left out: play=1.0.4.9.80"),
        ("#seed=7&then=" + "0" * 20_000, "too long"),
    ],
)
def test_what_is_wrong_with_a_link_is_said(browser, page, address, message):
    opened(browser, page, address)
    assert message in browser.js(TOLD)
    assert browser.js("document.querySelector('[type=number]').value") == (
        "0" if message == "too long" else "7"
    )
    assert browser.errors() == []


WORKERS = "script-src 'unsafe-inline' 'wasm-unsafe-eval'; worker-src 'none'"
ABSENT = "(document.querySelector('.absent, .problem')?.textContent ?? '')"


@pytest.mark.slow
@pytest.mark.parametrize(
    ("policy", "message"),
    [
        ("", ""),
        (WORKERS, ""),
        ("script-src 'unsafe-inline'", "'wasm-unsafe-eval' is missing"),
        ("script-src 'self'", "forbidden where it lies"),
    ],
)
def test_a_page_works_where_it_is_published_or_says_what_it_lacks(
    browser, firefox, page, policy, message
):
    """Over HTTP, with the policies of schools and hosts."""

    class Handler(SimpleHTTPRequestHandler):
        def end_headers(self):
            if policy:
                self.send_header("Content-Security-Policy", policy)
            super().end_headers()

        def log_message(self, *args):
            pass

    server = ThreadingHTTPServer(("127.0.0.1", 0), partial(Handler, directory=str(page.parent)))
    Thread(target=server.serve_forever, daemon=True).start()
    address = f"http://127.0.0.1:{server.server_port}/{page.name}{QUICK.replace('30', '10')}"
    browser.resize(*LAPTOP)
    browser.driver.get("about:blank")
    browser.driver.get(address)
    firefox.open(address)
    told = []
    for each in (browser, firefox):
        each.wait(f"{ABSENT} || window.matrixworldEvolve", 60)
        if message:
            each.wait(f"{ABSENT}.includes({json.dumps(message)})", 20)
        else:
            each.js("document.querySelector('.evolve').click()")
            each.wait(ENDED, 120)
            told.append(each.js(GENOMES))
    server.shutdown()
    server.server_close()
    assert not told or told[0] == told[1]
    browser.errors()


@pytest.mark.slow
def test_a_race_evolves_is_changed_and_plays_its_matches(browser, page):
    opened(browser, page, SMALL)
    assert browser.js(STATE) == "waiting"
    browser.wait(f"{LANE}.after.player.step > 2")  # a chase runs already
    browser.click(".evolve")
    browser.wait(ENDED, 120)
    assert browser.js(NEWEST) == 15
    browser.driver.execute_script("document.querySelector('.lane-more').open = true")
    assert "Collisions" in browser.js("document.querySelector('.measures').textContent")
    # A click on a cell plays its match.
    browser.driver.execute_script(
        "document.documentElement.style.scrollBehavior = 'auto';"
        "document.querySelector('.matrix').scrollIntoView()"
    )
    box = "document.querySelector('.matrix canvas').getBoundingClientRect()"
    browser.wait(f"{box}.width > 100")
    browser.drag(tuple(browser.js(f"(box => [box.left + 9, box.top + 9])({box})")))
    browser.wait("document.querySelector('.check').textContent === 'As in the evaluation'")
    assert browser.js("document.querySelector('.match-title').textContent").startswith(
        "Pursuers of generation 15 against evaders of generation 0"
    )
    browser.driver.execute_script("document.querySelector('dialog[open]').close()")
    # The mask ends all collisions at fault at once, and walls play the matrix again.
    choose(browser, "Right of way", "")
    numbers = "document.querySelector('.measures tbody tr:last-child').textContent"
    browser.wait(f"{numbers}.endsWith('newest generation0.00.0')")
    browser.driver.execute_script("scrollTo(0, 0)")
    press(browser, "Draw walls")
    told = "document.querySelector('.chase:last-child > [role=status]').textContent"
    box = "document.querySelector('.chase:last-child canvas').getBoundingClientRect()"
    same = f"window.seen === (window.seen = JSON.stringify({box}))"
    browser.wait(f"(window.still = {same} ? window.still + 1 : 0) >= 10")  # it has come to rest
    left, top, width = browser.js(f"(box => [box.left, box.top, box.width])({box})")
    cells = [(left + width * (column + 0.5) / 12, top + width * 2.5 / 12) for column in (3, 4, 5)]
    browser.drag(*cells)
    world = f"{LANE}.settings.world"
    browser.wait(f"{world}.obstacles[2] === '...###......'")
    assert browser.js(f"{world}.obstacles[5]") == "##.........."  # those of the link
    assert "walls:27.28.29.60.61" in browser.js("location.hash")
    for row, col in ((0, 1), (1, 0)):  # the second would wall in a corner
        browser.drag((left + width * (col + 0.5) / 12, top + width * (row + 0.5) / 12))
    browser.wait(f"{told}.startsWith('Nobody may be walled in')")
    browser.wait(f"{world}.obstacles[0] === '.#..........'")
    assert browser.errors() == []


@pytest.mark.slow
def test_agents_are_asked_and_weights_are_dragged(browser, page):
    """Without weights all allowed moves are equally good, in Python as on the page."""
    opened(browser, page, QUICK)
    browser.click(".evolve")
    browser.wait(ENDED, 60)
    press(browser, "Pause")
    browser.driver.execute_script(f"{LANE}.after.choose(0)")
    browser.wait("document.querySelectorAll('.asked .why tbody tr').length > 5")
    told = "document.querySelector('.weights-card [role=status]').textContent"
    evolved = browser.js(told)
    assert f"now catch {evolved.removesuffix(' are caught')} of" in browser.js(FACTS)
    browser.driver.execute_script(
        "for (const bar of document.querySelectorAll('.weights-card input')) {"
        " bar.value = 0; bar.dispatchEvent(new Event('input')); }"
    )
    world = WorldConfig.from_json(browser.js(f"{LANE}.settings.world"))
    seed = int(browser.js(f"(({{ seeds, best }}) => seeds[best.pursuer][best.evader])({LANE}.run)"))
    policy = Rating.for_config(world)
    team = Population(np.zeros(policy.genome_size, np.float32), policy)
    rate = rollout(world, team, team, Matches.of(0, 0, [seed]), episodes=20).capture_rate.mean()
    both = f"Yours: {int(100 * rate + 0.5)} % are caught; as evolved: {evolved.split(' are')[0]}"
    assert browser.js(told) == both
    assert browser.js("document.querySelector('.weights p').textContent") == (
        "A pursuer takes any move that is allowed."
    )
    press(browser, "As evolved")
    assert browser.js(told) == evolved
    assert browser.violations() == browser.errors() == []


@pytest.mark.nightly
def test_two_races_stand_side_by_side_without_motion(browser, page):
    browser.prefer(prefers_reduced_motion="reduce")
    opened(browser, page, SMALL + "&beside=hall-of-fame&learner=ga", PHONE)
    assert not browser.js(f"{LANE}.chases.runs")  # no motion unless asked for
    browser.click(".evolve")
    browser.wait(f"{STATE} === 'ended'", 240)
    assert browser.js("matrixworldEvolve.lanes.map((lane) => lane.newestGeneration)") == [15, 15]
    assert browser.js("document.documentElement.scrollWidth") <= PHONE[0]
    assert browser.errors() == []
    browser.prefer()
