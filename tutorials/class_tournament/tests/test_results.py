"""Results of a class: ranks that are ranges where the episodes cannot tell more, and the page."""

import json
from pathlib import Path

import numpy as np
import pytest

from browser import DESKTOP, Browser, browser, data_of
from class_submissions import write_genomes
from class_tournament.results import ClassResult, class_page, rank_ranges
from class_tournament.round_robin import play_class
from class_tournament.submissions import Entry
from matrixworld import WorldConfig
from matrixworld.coevolution.types import TEAMS
from matrixworld.explorer.page import write_page

__all__ = ["browser"]


def noisy(means: list[float], seed: int = 0) -> np.ndarray:
    noise = np.random.default_rng(seed).normal(0.0, 0.05, (len(means), 5, 10))
    return np.clip(np.array(means)[:, None, None] + noise, 0.0, 1.0)


CERTAIN = np.zeros((2, 3, 40))
CERTAIN[0] = 1.0


@pytest.mark.parametrize(
    ("payoffs", "ranks"),
    [
        (noisy([0.9, 0.2, 0.5]), [(1, 1), (3, 3), (2, 2)]),
        (noisy([0.9, 0.5, 0.5, 0.1]), [(1, 1), (2, 3), (2, 3), (4, 4)]),
        (np.full((3, 2, 4), 0.5), [(1, 3)] * 3),
        (CERTAIN, [(1, 1), (2, 2)]),
        (noisy([0.3]), [(1, 1)]),
        (np.empty((0, 3, 4)), []),
    ],
    ids=["clear", "two alike", "all equal", "without variation", "single", "none"],
)
def test_entries_that_cannot_be_told_apart_share_a_range(
    payoffs: np.ndarray, ranks: list[tuple[int, int]]
) -> None:
    assert rank_ranges(payoffs) == ranks


RATES = np.tile([[[0.2, 0.3], [0.4, 0.5]], [[0.9, 0.9]] * 2, [[0.0, 0.0]] * 2], 10)
"""Of two students and a script against a student and a script, in 20 episodes."""


def test_standings_of_both_teams() -> None:
    names = {"pursuer": ("ann", "bo", "random"), "evader": ("cy", "random")}
    entries = {
        team: tuple(
            Entry(name, team, "script" if name == "random" else "program", "", name)
            for name in names[team]
        )
        for team in TEAMS
    }
    result = ClassResult(WorldConfig("O"), 0, 0, entries, (), RATES, np.ones(RATES.shape, int), {})
    bo, ann, random = result.standings["pursuer"]
    assert [(each.entry.name, each.rank) for each in (bo, ann, random)] == [
        ("bo", "1"), ("ann", "2"), ("random", "")
    ]  # fmt: skip
    assert ann.score.value == pytest.approx(0.35)
    assert (ann.best, ann.worst) == (1, 0)
    # All episodes of bo are equal: that is no certainty, and no interval.
    assert bo.score.low is None
    assert ann.score.low is not None
    cy, random = result.standings["evader"]  # scored by those that escape
    assert (cy.entry.name, random.entry.name) == ("cy", "random")
    assert cy.score.value == pytest.approx(1.0 - RATES[:, 0].mean())
    assert (cy.best, cy.worst) == (2, 1)


def test_a_class_may_hand_in_predictions_alone(tmp_path: Path) -> None:
    (tmp_path / "ada.jsonl").write_text('{"prediction": "4.a", "choice": "b"}\n')
    config = WorldConfig("O", rows=5, cols=5, n_pursuers=2, n_evaders=2, max_steps=4)
    result = play_class(tmp_path, config, episodes=2, seed=1)
    assert result.votes == {"4.a": {"b": 1}}
    assert {each.kind for team in TEAMS for each in result.entries[team]} == {"script"}
    assert "4.a" in class_page(result, title="")


# ---- The page in a real browser ------------------------------------------------------------------

HOSTILE = "<img src=x onerror=document.title='owned'>"


@pytest.fixture(scope="module")
def played(tmp_path_factory: pytest.TempPathFactory) -> ClassResult:
    """A class of genomes, of a game in which the teams take turns."""
    directory = tmp_path_factory.mktemp("class")
    write_genomes(directory, 3)
    (directory / f"{HOSTILE}.txt").write_text("no submission")
    vote = json.dumps({"prediction": "4.a", "choice": HOSTILE})
    (directory / "dee.jsonl").write_text(vote + '\n{"prediction": "4.b", "choice": "d"}\n')
    (directory / "genome 00.npz").rename(directory / f"{HOSTILE}.npz")
    config = WorldConfig("TO", rows=9, cols=9, n_pursuers=3, n_evaders=2, max_steps=12)
    return play_class(directory, config, episodes=3, seed=1)


@pytest.mark.slow
def test_the_page_plays_every_cell_again_and_shows_what_was_found(
    browser: Browser, played: ClassResult, tmp_path: Path
) -> None:
    write_page(tmp_path / "class.html", class_page(played, title=f"class {HOSTILE}"))
    browser.open(tmp_path / "class.html", DESKTOP)
    rows, columns, _ = played.capture_rates.shape
    browser.js("document.querySelector('.matrix').focus()")
    seen = set()
    for row in range(rows):
        for _ in range(columns):
            seen.add(browser.js("document.getElementById('match').dataset.played"))
            assert browser.js("document.querySelector('.check').dataset.equal") == "true"
            browser.press("\ue014" if row % 2 == 0 else "\ue012")  # right, left
        browser.press("\ue015")  # down
    assert seen == {f"{g} {h}" for g in range(rows) for h in range(columns)}
    text = browser.js("document.body.innerText")
    for standing in [*played.standings["pursuer"], *played.standings["evader"]]:
        assert f"{standing.score.value:.2f}" in text
    assert played.refusals[0].reason in text
    votes = browser.js("document.querySelector('.votes').innerText.split(/\\s*\\n\\s*/)")
    assert votes[-6:] == ["4.a", HOSTILE, "1 of 1", "4.b", "d", "1 of 1"]
    # Names are text, whatever they hold.
    assert HOSTILE in browser.js("document.querySelector('.standings').textContent")
    assert browser.js("document.title") == f"class {HOSTILE} - matrixworld"
    assert browser.js("document.images.length") == 0
    assert browser.errors() == []


@pytest.mark.nightly
def test_a_page_without_room_keeps_the_best_and_worst_matches(
    browser: Browser, played: ClassResult, tmp_path: Path
) -> None:
    page = tmp_path / "small.html"
    whole = sum(actions.size for actions in played.recordings.values())
    write_page(page, class_page(played, title="small", most=whole // 2))
    steps = data_of(page)["steps"]
    first = played.standings["pursuer"][0]
    assert steps[first.number][first.best] == len(played.recordings[first.number, first.best])
    g, h = next((g, h) for g, row in enumerate(steps) for h, n in enumerate(row) if n < 0)
    browser.open(page, DESKTOP)
    cell = f"document.querySelector('rect[data-pair=\"{g} {h}\"]')"
    x, y = browser.js(f"(box => [box.x + 2, box.y + 2])({cell}.getBoundingClientRect())")
    click = f"new MouseEvent('click', {{bubbles: true, clientX: {x}, clientY: {y}}})"
    browser.js(f"{cell}.dispatchEvent({click})")
    assert "holds no recording" in browser.js("document.body.innerText")
    assert browser.errors() == []
