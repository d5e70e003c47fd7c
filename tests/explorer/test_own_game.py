"""The page of races of games of your own: their words, and what they show of pairs."""

import base64
import io
import json
import re
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

import one_population
import own_games
from browser import PHONE, data_of
from matrixworld.coevolution import evolve
from matrixworld.explorer import explore, teams
from matrixworld.explorer.runs_page import explorer_page
from own_games import short_race
from tiny_race import tiny_race

OF_PURSUIT = re.compile("pursuer|evader|captur|escap|caught", re.IGNORECASE)
SHOWN = "document.querySelector('.shown').textContent"
PLAYED = "document.querySelector('#match').dataset.played"


@pytest.fixture(scope="module")
def job(tmp_path_factory):
    settings = {
        "pursuit": tiny_race(),
        "words": short_race(own_games.words, generations=15),
        "pictures": short_race(own_games.pictures),
        "silent": short_race(own_games.silent),
    }
    runs = evolve(settings, tmp_path_factory.mktemp("job"), threads=1)
    return dict(zip(settings, runs, strict=True))


def data(*runs):
    found = re.search(r'id="data">(.*?)</script>', explorer_page(runs))
    assert found
    return json.loads(found[1])


def test_what_is_shown_is_what_the_game_returns(job):
    run = job["words"]
    hosts, parasites = run.archive().values()
    [plain] = data(run)["runs"]
    told = plain["game"]["shows"]
    for key, shown in told.items():
        g, h = map(int, key.split())
        assert shown == {"text": own_games.told(hosts[g], parasites[h])}
    # 16 x 16 cells: the last 10 x 10, and a grid that reaches all corners.
    assert {f"{g} {h}" for g in range(6, 16) for h in range(6, 16)} <= told.keys()
    assert {"0 0", "0 15", "15 0"} <= told.keys()
    assert 100 < len(told) <= teams.MOST_SHOWN
    assert f"the page has {len(told)} pairs" in plain["game"]["missing"]
    drawn = data(job["pictures"])["runs"][0]["game"]["shows"]
    assert len(drawn) == 16  # of a small matrix all cells
    hosts, parasites = job["pictures"].archive().values()
    picture = base64.b64decode(drawn["3 1"]["image"].removeprefix("data:image/png;base64,"))
    with Image.open(io.BytesIO(picture)) as image:
        assert np.array_equal(np.asarray(image), own_games.drawn(hosts[3], parasites[1]))


def test_the_page_has_no_engine_no_genomes_and_no_playground(job):
    page = explorer_page([job["words"], job["pictures"]])
    for part in ("script-engine", "playground", "genomes-0-pursuer"):
        assert f'id="{part}"' not in page
    assert 'id="script-engine"' in explorer_page([job["words"], job["pursuit"]])


def test_headings_and_settings_name_the_game(job):
    plain = data(job["words"])
    assert plain["heading"] == "1 race of hosts and parasites, game words"
    shown = {each["name"]: each["value"] for each in plain["runs"][0]["settings"]}
    assert shown["game"] == "own_games:words"
    assert not [name for name in shown if re.search(r"game\.|world|policy|train_steps", name)]
    assert data(job["words"], job["silent"])["heading"] == "2 races of hosts and parasites"
    assert data(job["words"], job["pursuit"])["heading"] == "2 races of 2 games"
    curve = plain["runs"][0]["training"]
    log = job["words"].log()
    hosts = log["team"] == "hosts"
    np.testing.assert_allclose(curve["capture_rate"], log["score"][hosts], atol=1e-4)


def test_another_source_is_told_and_a_game_that_is_not_there_refused(tmp_path):
    run = evolve(short_race(own_games.words), tmp_path / "run", threads=1)
    config = tmp_path / "run" / "config.json"
    text = config.read_text(encoding="utf-8")
    assert run.settings.game
    config.write_text(text.replace(run.settings.game.digest, "0" * 16), encoding="utf-8")
    with pytest.warns(UserWarning, match="got a changed one"):
        page = explore(tmp_path / "run")
    assert data_of(page.path)["note"] == (
        "The source of the game own_games:words has changed since it was raced."
    )
    assert page._repr_mimebundle_().keys() == {"text/html"}  # no picture of a chase
    config.write_text(text.replace("own_games:", "no_such_games:"), encoding="utf-8")
    page.path.unlink()
    with pytest.raises(ValueError, match="no_such_games:words: expected a module"):
        explore(tmp_path / "run")
    assert not page.path.exists()


@pytest.mark.slow
def test_a_click_shows_the_pair_in_the_words_of_the_game(browser, job, tmp_path):
    own = [job[name].path for name in ("words", "pictures", "silent")]
    hosts, parasites = job["words"].archive().values()
    page = explore(*own, file=tmp_path / "own.html").path
    browser.open(page)
    assert not OF_PURSUIT.search(browser.js("document.body.innerText"))
    # The clearest race comes first.
    order = [Path(each["name"]).name for each in data_of(Path(page))["runs"]]
    place = {name: f".race:nth-child({1 + order.index(name)})" for name in order}
    browser.js(f"location.hash = '#run={order.index('words')}&pursuers=15&evaders=15'")
    browser.wait(f"{PLAYED} === '{order.index('words')} 15 15 0 '")
    assert browser.js(SHOWN).startswith(own_games.told(hosts[15], parasites[15]))
    browser.js(f"location.hash = '#run={order.index('words')}&pursuers=1&evaders=2'")
    browser.wait(f"{SHOWN}.includes('was not computed')")
    browser.click(".shown button")  # the nearest pair that is
    browser.wait(f"!{SHOWN}.includes('was not computed')")
    g, h = map(int, browser.js(PLAYED).split()[1:3])
    assert browser.js(SHOWN).startswith(own_games.told(hosts[g], parasites[h]))
    browser.click(place["pictures"])
    browser.wait("document.querySelector('.shown img')?.naturalWidth === 3")
    browser.click(place["silent"])
    browser.wait(f"{SHOWN}.startsWith('The game has no function show(a, b)')")
    assert browser.errors() == []
    # Beside a race of pursuit, which the engine plays.
    browser.open(explore(job["pursuit"].path, own[0], file=tmp_path / "both.html").path, PHONE)
    browser.wait(f"{PLAYED} === '0 2 2 0 '")
    assert browser.js("document.querySelector('.scale-of-rates').textContent").startswith("0 all")
    assert browser.js("document.documentElement.scrollWidth") <= PHONE[0]
    assert browser.errors() == []


@pytest.fixture(scope="module")
def of_both(tmp_path_factory):
    """Races of one population, and of two teams, in which both sides have scores of their own."""
    folder = tmp_path_factory.mktemp("both")
    settings = {
        "one": short_race(one_population.coins, generations=6),
        "both": short_race(one_population.meeting, generations=6),
    }
    runs = evolve(settings, folder, threads=1)
    return dict(zip(settings, runs, strict=True))


def test_the_page_of_one_population_speaks_of_one(of_both):
    page = data(of_both["one"])
    [plain] = page["runs"]
    assert page["heading"] == "1 race of climbers, game coins"
    assert plain["game"]["teams"] == ["climbers", "climbers"]
    assert plain["learning"] == ["pursuer"]
    assert {*plain["training"]["learner"]} == {0}
    found = plain["findings"]
    assert found["refused"]["arms race"] == "one population has no other one to race with"
    first, second = found["generalization"].values()
    np.testing.assert_allclose(first["mean"], second["mean"])
    assert found["joint"] is None


def test_the_page_of_scores_of_both_has_both_sides(of_both):
    [plain] = data(of_both["both"])["runs"]
    payoff = of_both["both"].payoff()
    found = plain["findings"]
    assert found["ratings"] is found["checkerboards"] is None
    np.testing.assert_allclose(plain["payoff"]["others"], payoff.others.mean(axis=2), rtol=1e-6)
    np.testing.assert_allclose(plain["payoff"]["extras"]["distance"], payoff.extras["distance"])
    own = found["generalization"]["evaders"]["mean"]
    np.testing.assert_allclose(own, payoff.others.mean(axis=(0, 2)), rtol=1e-6)
    # Against contemporaries: the same generation, and the one before on either side.
    both = (payoff.matrix + payoff.others.mean(axis=2)) / 2
    near = [both[0, 0]] + [
        np.mean([both[k, k], both[k, k - 1], both[k - 1, k]]) for k in range(1, 7)
    ]
    np.testing.assert_allclose(found["joint"]["mean"], near, rtol=1e-6)
    assert "arms race" in found["refused"]


@pytest.mark.slow
def test_the_panels_of_both_sides_are_drawn(of_both, browser, tmp_path):
    for name, drawn in (("one", False), ("both", True)):
        browser.open(explore(of_both[name].path, file=tmp_path / f"{name}.html").path)
        assert not OF_PURSUIT.search(browser.js("document.body.innerText"))
        titles = browser.js("[...document.querySelectorAll('.panel h2')].map(e => e.textContent)")
        assert ("Both sides together" in titles) == drawn
        assert ("Checkerboards" in titles) == ("Ratings" in titles) == (not drawn)
        triangles = browser.js("document.querySelectorAll('.triangles > *').length")
        assert triangles == 1 + drawn
        assert "Not judged, because" in browser.js("document.body.innerText")
        assert browser.errors() == []
