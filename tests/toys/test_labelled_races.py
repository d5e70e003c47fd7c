"""Labelled races: the chances of toys, and what is true of them."""

from __future__ import annotations

import numpy as np
import pytest

from matrixworld import toys
from matrixworld.coevolution.opponents import Uniform
from matrixworld.coevolution.types import TEAMS
from matrixworld.toys.labelled_races import chances_of_history, truths_of_history
from matrixworld.toys.race_truths import CONDITIONS, WINDOWS, Truths


def held(found: Truths) -> dict[str, bool | None]:
    return {condition: truth.holds for condition, truth in found.items()}


# Rock-paper-scissors


def test_chances_of_hands_and_of_averages() -> None:
    pure = np.eye(3)
    np.testing.assert_allclose(
        toys.capture_probabilities(pure, pure), [[0.5, 0.0, 1.0], [1.0, 0.5, 0.0], [0.0, 1.0, 0.5]]
    )
    lucky = toys.capture_probabilities(pure, pure, luck=0.1)
    np.testing.assert_allclose(lucky[0], [0.5, 0.1, 0.9])
    np.testing.assert_allclose(toys.average_strategies([0, 1, 1, 2])[-1], [0.25, 0.5, 0.25])
    np.testing.assert_allclose(
        toys.capture_probabilities(np.full((1, 3), 1 / 3), pure), [[0.5] * 3]
    )
    with pytest.raises(ValueError, match=r"luck: expected a number in \[0, 0.5\], got 0.6"):
        toys.capture_probabilities(pure, pure, luck=0.6)


def test_averages_are_near_the_equilibrium_from_the_start() -> None:
    for seed in range(3):
        hands = toys.play_together({team: Uniform(None) for team in TEAMS}, 400, seed)
        for rounds in (100, 250, 400):
            so_far = {team: hands[team][: rounds + 1] for team in TEAMS}
            assert toys.exploitability(so_far) < 0.15
        truth = toys.labelled_race("rock-paper-scissors, its averages", seed).truths["last half"]
        assert [name for name, one in truth.items() if one.holds] == ["stagnation"]


def test_hands_cycle_without_an_arms_race() -> None:
    for name in ("specialists", "generalists", "fictitious play"):
        race = toys.labelled_race(f"rock-paper-scissors, {name}", 1)
        for window in WINDOWS:
            truth = held(race.truths[window])
            assert truth["cycling"] is True
            assert truth["arms race"] is truth["one-sided progress"] is False


# Populations of bits


def test_scores_of_a_history_by_hand() -> None:
    ones = np.array([[[[3], [3]], [[1], [1]]], [[[2], [2]], [[2], [2]]]])
    history = toys.History(toys.GAMES["scalar"], ones, np.zeros((1, 2, 2)))
    scores = history.scores([0, 1], 3, np.random.default_rng(0))
    assert scores.shape == (2, 2, 3)
    # 3 against 1 and 2; 2 against 1 and 2.
    assert scores.mean(axis=2).tolist() == [[1.0, 1.0], [1.0, 0.5]]
    assert chances_of_history(history, np.array([0, 1])).tolist() == [[1.0, 1.0], [1.0, 0.5]]
    assert history.objective.tolist() == [[[3, 3], [1, 1]], [[2, 2], [2, 2]]]


def test_scores_draw_individuals_at_random() -> None:
    ones = np.array([[[[0], [2]], [[1], [1]]]])  # one of two wins
    history = toys.History(toys.GAMES["scalar"], ones, np.zeros((0, 2, 2)))
    assert history.scores([0], 2000, np.random.default_rng(0)).mean() == pytest.approx(
        0.5, abs=0.05
    )


@pytest.mark.parametrize("game", ["scalar", "focusing", "intransitive"])
def test_chances_are_the_means_of_many_matches(game: str) -> None:
    history, picked = toys.numbers_game(game, 3, generations=60), np.array([0, 20, 40, 60])
    chances = chances_of_history(history, picked)
    scores = history.scores(picked, 4000, np.random.default_rng(1))
    np.testing.assert_allclose(scores.mean(axis=2), chances, atol=0.04)


def a_history(game: str, totals: np.ndarray) -> toys.History:
    """Return a history of pairs of individuals with `totals` ones, (k, dimensions)."""
    ones = np.repeat(np.repeat(totals[:, None, None, :], 2, axis=1), 2, axis=2)
    return toys.History(toys.GAMES[game], ones.astype(int), np.zeros((len(totals) - 1, 2, 2)))


def test_truths_of_histories_by_hand() -> None:
    every = np.arange(11)

    def whole(game: str, totals: np.ndarray, **options: bool) -> dict[str, bool | None]:
        return held(truths_of_history(a_history(game, totals), every, **options)["whole"])

    climbing = whole("scalar", 5 * every[:, None])
    # Later generations win all matches against earlier ones, and half against their own.
    assert climbing["arms race"] is True
    assert climbing["one-sided progress"] is climbing["cycling"] is False
    assert climbing["forgetting"] is climbing["stagnation"] is False
    assert whole("scalar", 5 * every[:, None], selected=False)["arms race"] is False
    still = whole("scalar", np.full((11, 1), 50))
    assert [name for name, holds in still.items() if holds] == ["stagnation"]
    lost = whole("scalar", 50 - every[:, None])
    assert lost["forgetting"] is True
    assert lost["arms race"] is lost["stagnation"] is False
    slow = whole("scalar", 50 + every[:, None] // 4)
    assert slow["arms race"] is None
    assert whole("focusing", np.full((11, 10), 5) + every[:, None])["arms race"] is None


def test_a_race_that_one_side_always_wins_is_disengaged() -> None:
    one_sided = a_history("scalar", np.full((11, 1), 50))
    one_sided.ones[:, 1] = 0
    found = held(truths_of_history(one_sided, np.arange(11))["last half"])
    assert found.pop("disengagement") is True
    assert set(found.values()) == {None}


def test_an_unlabelled_race_is_refused() -> None:
    with pytest.raises(ValueError, match="race: expected one of rock-paper-scissors, specialists"):
        toys.labelled_race("chess", 0)


@pytest.mark.parametrize("name", toys.RACES)
def test_labelled_races_name_every_condition(name: str) -> None:
    for seed in (0, 12):
        race = toys.labelled_race(name, seed)
        assert tuple(race.truths) == tuple(WINDOWS)
        assert all(tuple(found) == CONDITIONS for found in race.truths.values())
        assert race.scores.shape == (31, 31, 10 if seed == 0 else 40)
        assert set(np.unique(race.scores)) <= {0.0, 0.5, 1.0}


def test_labelled_races_follow_from_the_seed() -> None:
    for name in ("rock-paper-scissors, generalists", "virulence .75, climbing"):
        one, again, other = (toys.labelled_race(name, seed).scores for seed in (3, 3, 4))
        assert np.array_equal(one, again)
        assert not np.array_equal(one, other)


@pytest.mark.parametrize(
    ("name", "condition", "holds"),
    [
        ("scalar, climbing", "arms race", True),
        ("scalar, climbing", "cycling", False),
        ("scalar, at the top", "arms race", False),
        ("scalar, without mutation", "stagnation", True),
        ("intransitive", "cycling", True),
        ("virulence 1", "disengagement", True),
        ("virulence .75, climbing", "arms race", True),
        ("virulence .75, later", "disengagement", False),
        ("mutation without selection", "arms race", False),
    ],
)
def test_what_is_true_of_toys(name: str, condition: str, holds: bool) -> None:
    for seed in range(2):
        assert toys.labelled_race(name, seed).truths["last half"][condition].holds is holds
