"""Races whose truth is known: what is true of formulas and toys, by hand and by counting."""

from __future__ import annotations

import numpy as np
import pytest

from judgement_races import KINDS, synthetic_races
from judgement_toys import RACES, chances_of_history, fictitious_play, truths_of_history
from judgement_truths import WINDOWS, Truths, truths, truths_of_group
from matrices import ROCK_PAPER_SCISSORS, quadruples
from matrixworld import analysis, toys
from matrixworld.analysis import CONDITIONS
from matrixworld.coevolution.types import TEAMS
from matrixworld.toys.bit_strings import History
from matrixworld.toys.synthetic_races import SyntheticRace


def held(found: Truths) -> dict[str, bool | None]:
    return {condition: truth.holds for condition, truth in found.items()}


# Formulas


def what_holds(kind: str, window: str = "whole", **options: float) -> list[set[bool | None]]:
    """Return, for each condition, what is true of ten races of a kind."""
    found = [truths(synthetic_races(kind, 40, seed, **options)[0], window) for seed in range(10)]
    return [{one[condition].holds for one in found} for condition in CONDITIONS]


T, F, OPEN = {True}, {False}, {None}


@pytest.mark.parametrize(
    ("kind", "window", "expected"),
    [
        ("pure race", "whole", [F, T, F, F, F, F, F]),
        ("slow race", "last half", [F, T, F, F, F, F, F]),
        ("two skills", "last half", [F, T, F, F, F, F, F]),
        ("only pursuers rise", "first half", [F, F, T, F, F, F, F]),
        ("only evaders rise", "whole", [F, F, T, F, F, F, F]),
        ("cycle", "whole", [F, F, F, T, T, T, F]),
        ("rock-paper-scissors", "whole", [F, F, F, T, T, T, F]),
        ("cycle on a climb", "whole", [F, T, F, T, T, T, F]),
        ("wave, then race", "last half", [F, T, F, F, F, F, F]),
        ("noise only, .1", "whole", [F, F, F, F, F, F, T]),
        ("early stagnation", "first half", [F, T, F, F, F, F, F]),
        ("early stagnation", "last half", [F, F, F, F, F, F, T]),
        ("late stagnation", "whole", [F, T, F, F, F, F, F]),
        ("disengagement, .95", "last half", [F, F, F, F, F, F, T]),
        ("disengagement, .985", "last half", [T, OPEN, OPEN, OPEN, OPEN, OPEN, OPEN]),
        ("disengagement, .995", "whole", [T, OPEN, OPEN, OPEN, OPEN, OPEN, OPEN]),
    ],
)
def test_what_is_true_of_kinds(kind: str, window: str, expected: list[set[bool | None]]) -> None:
    # Whether the played strength rises in a steady way depends on the nuisance parameters.
    held = dict(zip(CONDITIONS, what_holds(kind, window), strict=True))
    del held["rise"]
    for (condition, found), wanted in zip(held.items(), expected, strict=True):
        # Nuisance parameters may leave a few races open, and never turn the truth round.
        assert wanted <= found <= wanted | OPEN, condition


def test_losses_are_forgetting_and_no_arms_race() -> None:
    for kind in ("decline", "collapse"):
        _, arms, one_sided, _, circles, cycling, forgetting, _ = what_holds(kind, "last half")
        assert (arms, one_sided, circles, cycling, forgetting) == (F, T, F, F, T)
    assert True in what_holds("forgetting", "last half", effect=2.0)[6]


def test_a_jump_and_chance_are_no_arms_race() -> None:
    for kind in ("single jump", "common jump", "drift", "fluctuation"):
        _, arms, one_sided, _, *circles = what_holds(kind)
        assert (arms, one_sided, *circles[:2]) == (F, F, F, F)


@pytest.mark.parametrize("kind", ["switch of style", "three styles", "slow turn", "new styles"])
def test_what_does_not_return_is_no_cycle(kind: str) -> None:
    circles, cycling = what_holds(kind)[4:6]
    assert True not in cycling
    assert kind == "slow turn" or True in circles <= T | OPEN
    assert what_holds("period 2")[4:6] == [T, T]


def test_truth_of_a_return_by_hand() -> None:
    # Both teams change sides: after one generation the opposite, after two the same.
    sign = np.array([1.0, -1.0] * 4)
    still = np.zeros(8)
    race = SyntheticRace(0.5 + 0.3 * np.outer(sign, sign), still, still)
    assert truths(race, "whole")["cycling"] == (True, pytest.approx(1.0))


@pytest.mark.parametrize("kind", ["cycle", "forgetting", "two skills", "saturating race", "drift"])
def test_share_of_checkerboards(kind: str) -> None:
    race = synthetic_races(kind, 12, 3)[0]
    truth = truths(race, "whole")["intransitivity"]
    margins = np.array([min(won) - max(lost) for won, lost, _ in quadruples(race.rates)])
    # Each quadruple is there twice: the first pursuer may beat the one evader or the other.
    share, slightest = 2 * np.mean(margins > 0.1), (margins > 0.02).any()
    assert truth.size == pytest.approx(share)
    assert truth.holds is (True if share >= 0.02 else None if slightest else False)


def test_truth_of_a_rise_by_hand() -> None:
    def arms_race(course: np.ndarray) -> bool | None:
        rates = 0.5 + (course[:, None] - course) / 20
        return truths(SyntheticRace(rates, course, course), "whole")["arms race"].holds

    even, jump = np.arange(8.0), (np.arange(8) >= 4) * 4.0
    burst = np.array([0, 1, 1, 1, 1, 5, 6, 7])
    found = [arms_race(course) for course in (even, jump, burst, -even, 0 * even)]
    assert found == [True, False, None, False, False]


def test_truth_of_a_drop_by_hand() -> None:
    rates = np.full((8, 8), 0.5)
    rates[6:] -= 0.2  # pursuers lose .2 in half of the later half
    race = SyntheticRace(rates, np.zeros(8), np.zeros(8))
    assert truths(race, "whole")["forgetting"] == (True, pytest.approx(0.1))
    assert truths(race, "first half")["forgetting"] == (False, 0.0)


def test_truth_of_a_group_is_open_where_its_runs_differ() -> None:
    runs = [synthetic_races(kind, 20, 0)[0] for kind in ("pure race", "only pursuers rise")]
    found = truths_of_group(runs, "whole")
    assert found["arms race"].holds is None
    assert found["cycling"].holds is False


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("n", [8, 15, 60])
def test_rates_are_rates_and_follow_from_the_seed(kind: str, n: int) -> None:
    for effect in (0.25, 2.0):
        runs = synthetic_races(kind, n, 5, effect=effect, runs=2)
        again = synthetic_races(kind, n, 5, effect=effect, runs=2)
        for run, other in zip(runs, again, strict=True):
            assert run.rates.shape == (n, n)
            assert run.pursuers.shape == run.evaders.shape == (n,)
            assert 0.0 <= run.rates.min() <= run.rates.max() <= 1.0
            assert np.array_equal(run.rates, other.rates)
        assert not np.array_equal(runs[0].rates, runs[1].rates)
        for window in WINDOWS:
            assert tuple(truths_of_group(runs, window)) == CONDITIONS


# Toys


def test_averages_are_near_the_equilibrium_from_the_start() -> None:
    for seed in range(3):
        hands = fictitious_play(400, seed)
        for rounds in (100, 250, 400):
            x, y = (np.bincount(hands[team][: rounds + 1]) / (rounds + 1) for team in TEAMS)
            assert analysis.exploitability(ROCK_PAPER_SCISSORS, x, y).total < 0.15
        truth = RACES["rock-paper-scissors, its averages"](seed).truths["last half"]
        assert [name for name, one in truth.items() if one.holds] == ["stagnation"]


def test_hands_cycle_without_an_arms_race() -> None:
    for name in ("specialists", "generalists", "fictitious play"):
        race = RACES[f"rock-paper-scissors, {name}"](1)
        for window in WINDOWS:
            truth = held(race.truths[window])
            assert truth["intransitivity"] is True
            assert truth["arms race"] is truth["one-sided progress"] is False


@pytest.mark.parametrize("game", ["scalar", "focusing", "intransitive"])
def test_chances_are_the_means_of_many_matches(game: str) -> None:
    history, picked = toys.numbers_game(game, 3, generations=60), np.array([0, 20, 40, 60])
    chances = chances_of_history(history, picked)
    scores = history.scores(picked, 4000, np.random.default_rng(1))
    np.testing.assert_allclose(scores.mean(axis=2), chances, atol=0.04)


def a_history(game: str, totals: np.ndarray) -> History:
    """Return a history of pairs of individuals with `totals` ones, (k, dimensions)."""
    ones = np.repeat(np.repeat(totals[:, None, None, :], 2, axis=1), 2, axis=2)
    return History(toys.GAMES[game], ones.astype(int), np.zeros((len(totals) - 1, 2, 2)))


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


@pytest.mark.parametrize("name", RACES)
def test_labelled_races_name_every_condition(name: str) -> None:
    for seed in (0, 12):
        race = RACES[name](seed)
        assert tuple(race.truths) == tuple(WINDOWS)
        assert all(tuple(found) == CONDITIONS for found in race.truths.values())
        assert race.scores.shape == (31, 31, 10 if seed == 0 else 40)
        assert set(np.unique(race.scores)) <= {0.0, 0.5, 1.0}


def test_labelled_races_follow_from_the_seed() -> None:
    for name in ("rock-paper-scissors, generalists", "virulence .75, climbing"):
        one, again, other = (RACES[name](seed).scores for seed in (3, 3, 4))
        assert np.array_equal(one, again)
        assert not np.array_equal(one, other)


@pytest.mark.parametrize(
    ("name", "condition", "holds"),
    [
        ("scalar, climbing", "arms race", True),
        ("scalar, climbing", "cycling", False),
        ("scalar, at the top", "arms race", False),
        ("scalar, without mutation", "stagnation", True),
        ("intransitive", "intransitivity", True),
        ("virulence 1", "disengagement", True),
        ("virulence .75, climbing", "arms race", True),
        ("virulence .75, later", "disengagement", False),
        ("mutation without selection", "arms race", False),
    ],
)
def test_what_is_true_of_toys(name: str, condition: str, holds: bool) -> None:
    for seed in range(2):
        assert RACES[name](seed).truths["last half"][condition].holds is holds
