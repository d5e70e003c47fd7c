"""Results of a class: ranks that are ranges where the episodes cannot tell more, and the page."""

import json
from pathlib import Path

import numpy as np
import pytest

from browser import DESKTOP, PHONE, Browser, browser, data_of
from class_submissions import write_genomes
from matrixworld import WorldConfig
from matrixworld.classroom import play_class, standings
from matrixworld.classroom.page import Tables, class_page, digits, pack_actions
from matrixworld.classroom.standings import payoffs_of, rank_ranges
from matrixworld.classroom.submissions import Entry
from matrixworld.classroom.tournament import ClassResult
from matrixworld.coevolution.types import TEAMS
from matrixworld.explorer.page import write_page

__all__ = ["browser"]


def noisy(
    means: list[float], *, opponents: int = 5, episodes: int = 10, seed: int = 0
) -> np.ndarray:
    rng = np.random.default_rng(seed)
    noise = rng.normal(0.0, 0.05, (len(means), opponents, episodes))
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


def test_ranges_rarely_miss_the_true_ranks() -> None:
    """Of equal entries every rank is true, so a range that is not the whole is a miss."""
    missed = [
        sum(found != (1, 6) for found in rank_ranges(noisy([0.5] * 6, seed=seed)))
        for seed in range(60)
    ]
    assert np.mean(missed) / 6 < 0.05


def result(rates: np.ndarray) -> ClassResult:
    names = {"pursuer": ("ann", "bo", "random"), "evader": ("cy", "random")}
    entries = {
        team: tuple(
            Entry(name, team, "script" if name == "random" else "program", "", name)
            for name in names[team]
        )
        for team in names
    }
    return ClassResult(WorldConfig("O"), 0, entries, (), rates, np.ones(rates.shape, int), {})


EPISODES = [
    [[0.2, 0.4], [0.9, 0.9], [0.0, 0.0]],
    [[0.3, 0.5], [0.9, 0.9], [0.0, 0.0]],
]
RATES = np.moveaxis(EPISODES * 10, 0, 2)


def test_scripts_are_in_the_table_and_have_no_rank() -> None:
    found = standings(result(RATES), "pursuer")
    assert [(each.entry.name, each.rank) for each in found] == [
        ("bo", "1"), ("ann", "2"), ("random", "")
    ]  # fmt: skip
    assert found[1].score.value == pytest.approx(0.35)
    assert (found[1].best, found[1].worst) == (1, 0)
    # All episodes of bo are equal: that is no certainty, and no interval.
    assert found[0].score.low is None
    assert found[1].score.low is not None


def test_evaders_are_scored_by_those_that_escape() -> None:
    found = standings(result(RATES), "evader")
    assert [each.entry.name for each in found] == ["cy", "random"]
    np.testing.assert_allclose(payoffs_of(result(RATES), "evader")[0], 1.0 - RATES[:, 0])
    assert found[0].score.value == pytest.approx(1.0 - RATES[:, 0].mean())
    assert (found[0].best, found[0].worst) == (2, 1)


@pytest.mark.parametrize(("n_actions", "count"), [(5, 3), (9, 2)])
def test_packed_actions_can_be_read(n_actions: int, count: int) -> None:
    actions = np.random.default_rng(0).integers(0, n_actions, (7, 4)).astype(np.uint8)
    packed = np.frombuffer(pack_actions(actions, n_actions), np.uint8)
    assert digits(n_actions) == count
    assert len(packed) == -(-actions.size // count)
    read = [int(packed[at // count]) // n_actions ** (at % count) % n_actions for at in range(28)]
    assert read == actions.ravel().tolist()


# ---- The page in a real browser ------------------------------------------------------------------

HOSTILE = "<img src=x onerror=document.title='owned'>"


@pytest.fixture(scope="module", params=["O", "TO"])
def played(
    request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory
) -> tuple[ClassResult, Tables]:
    """A class of genomes: of a game in one turn, and of one in which the teams take turns."""
    directory = tmp_path_factory.mktemp("class")
    write_genomes(directory, 3)
    (directory / f"{HOSTILE}.txt").write_text("no submission")
    vote = json.dumps({"prediction": "4.a", "choice": HOSTILE})
    (directory / "dee.jsonl").write_text(vote + '\n{"prediction": "4.b", "choice": "d"}\n')
    (directory / "genome 00.npz").rename(directory / f"{HOSTILE}.npz")
    config = WorldConfig(request.param, rows=9, cols=9, n_pursuers=3, n_evaders=2, max_steps=12)
    result = play_class(directory, config, episodes=3, seed=1)
    return result, {team: standings(result, team) for team in TEAMS}


@pytest.fixture(scope="module")
def page(played: tuple[ClassResult, Tables], tmp_path_factory: pytest.TempPathFactory) -> Path:
    file = tmp_path_factory.mktemp("page") / "class.html"
    write_page(file, class_page(*played, title=f"class {HOSTILE}"))
    return file


@pytest.mark.parametrize("size", [DESKTOP, PHONE])
def test_every_cell_is_played_again_as_in_the_tournament(
    browser: Browser, page: Path, played: tuple[ClassResult, Tables], size: tuple[int, int]
) -> None:
    browser.open(page, size)
    rows, columns, _ = played[0].capture_rates.shape
    assert browser.js("document.querySelectorAll('.matrix rect[data-pair]').length") == (
        rows * columns
    )
    browser.js("document.querySelector('.matrix').focus()")
    seen = set()
    for row in range(rows):
        for _ in range(columns):
            seen.add(browser.js("document.getElementById('match').dataset.played"))
            assert browser.js("document.querySelector('.check').dataset.equal") == "true"
            browser.press("\ue014" if row % 2 == 0 else "\ue012")  # right, left
        browser.press("\ue015")  # down
    assert seen == {f"{g} {h}" for g in range(rows) for h in range(columns)}
    assert browser.errors() == []
    # Nothing is wider than the window.
    assert browser.js("document.documentElement.scrollWidth <= innerWidth")


def test_tables_and_refusals_show_what_was_found(
    browser: Browser, page: Path, played: tuple[ClassResult, Tables]
) -> None:
    """And a click on an opponent in a table plays that match."""
    browser.open(page, DESKTOP)
    text = browser.js("document.body.innerText")
    for team in TEAMS:
        for standing in played[1][team]:
            assert f"{standing.score.value:.2f}" in text
    assert "expected a file that ends in .py or .npz or .jsonl" in text
    assert browser.js("document.querySelector('.votes').innerText.split(/\\s*\\n\\s*/)") == [
        "How the class voted",
        "Predictions of the course: the first choice of each student, before the experiment.",
        *("4.a", HOSTILE, "1 of 1", "4.b", "d", "1 of 1"),
    ]
    # Names are text, whatever they hold.
    assert HOSTILE in browser.js("document.querySelector('.standings').textContent")
    assert browser.js("document.title") == f"class {HOSTILE} - matrixworld"
    assert browser.js("document.images.length") == 0
    last = played[1]["evader"][-1]
    browser.js(
        "[...document.querySelectorAll('.standings')][1]"
        ".querySelector('tbody tr:last-child .to-match').click()"
    )
    pair = f"{last.best} {last.number}"
    assert browser.js("document.getElementById('match').dataset.played") == pair
    browser.wait("matrixworldClass.step > 0")
    assert browser.errors() == []


SMALL = WorldConfig("O", rows=5, cols=5, n_pursuers=2, n_evaders=2, max_steps=4)


def test_a_class_may_hand_in_predictions_alone(tmp_path: Path) -> None:
    (tmp_path / "ada.jsonl").write_text('{"prediction": "4.a", "choice": "b"}\n')
    result = play_class(tmp_path, SMALL, episodes=2, seed=1)
    assert result.votes == {"4.a": {"b": 1}}
    assert {each.kind for team in TEAMS for each in result.entries[team]} == {"script"}
    assert "4.a" in class_page(result, {team: standings(result, team) for team in TEAMS}, title="")


def test_a_page_without_room_keeps_the_best_and_worst_matches(
    played: tuple[ClassResult, Tables], browser: Browser, tmp_path: Path
) -> None:
    result, tables = played
    whole = sum(-(-actions.size // 3) for actions in result.recordings.values())
    page = tmp_path / "small.html"
    write_page(page, class_page(result, tables, title="small", most=whole // 2))
    steps = data_of(page)["steps"]
    first = tables["pursuer"][0]
    assert steps[first.number][first.best] == len(result.recordings[first.number, first.best])
    missing = [(g, h) for g, row in enumerate(steps) for h, n in enumerate(row) if n < 0]
    assert missing
    browser.open(page, DESKTOP)
    for g, h in [missing[0], (first.number, first.best)]:
        cell = f"document.querySelector('rect[data-pair=\"{g} {h}\"]')"
        x, y = browser.js(f"(box => [box.x + 2, box.y + 2])({cell}.getBoundingClientRect())")
        click = f"new MouseEvent('click', {{bubbles: true, clientX: {x}, clientY: {y}}})"
        browser.js(f"{cell}.dispatchEvent({click})")
        kept = (g, h) not in missing
        assert ("holds no recording" in browser.js("document.body.innerText")) is not kept
        if kept:
            assert browser.js("document.querySelector('.check').dataset.equal") == "true"
    assert browser.errors() == []


@pytest.mark.slow
def test_readers_with_disabilities_are_not_hindered(browser: Browser, page: Path) -> None:
    assert browser.hindrances(page) == {}
