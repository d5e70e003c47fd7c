"""Synthetic races: their formulas, what is true of them, and the noise of their matches."""

from __future__ import annotations

from itertools import combinations

import numpy as np
import pytest

from matrixworld import analysis
from matrixworld.toys.race_formulas import SyntheticRace
from matrixworld.toys.race_truths import (
    CONDITIONS,
    NOISES,
    WINDOWS,
    Noise,
    play_episodes,
    truths,
    truths_of_group,
)
from matrixworld.toys.synthetic_races import KINDS, synthetic_races


def what_holds(kind: str, window: str = "whole", **options: float) -> list[set[bool | None]]:
    """Return, for each condition, what is true of ten races of a kind."""
    found = [truths(synthetic_races(kind, 40, seed, **options)[0], window) for seed in range(10)]
    return [{one[condition].holds for one in found} for condition in CONDITIONS]


T, F, OPEN = {True}, {False}, {None}


@pytest.mark.parametrize(
    ("kind", "window", "expected"),
    [
        ("pure race", "whole", [T, F, F, F, F, F]),
        ("slow race", "last half", [T, F, F, F, F, F]),
        ("two skills", "last half", [T, F, F, F, F, F]),
        ("only pursuers rise", "first half", [F, T, F, F, F, F]),
        ("only evaders rise", "whole", [F, T, F, F, F, F]),
        ("cycle", "whole", [F, F, F, T, T, F]),
        ("rock-paper-scissors", "last half", [F, F, F, T, T, F]),
        ("cycle on a climb", "whole", [T, F, F, T, T, F]),
        ("wave, then race", "last half", [T, F, F, F, F, F]),
        ("noise only, .1", "whole", [F, F, T, F, F, F]),
        ("early stagnation", "first half", [T, F, F, F, F, F]),
        ("early stagnation", "last half", [F, F, T, F, F, F]),
        ("late stagnation", "whole", [T, F, F, F, F, F]),
        ("disengagement, .95", "last half", [F, F, T, F, F, F]),
        ("disengagement, .985", "last half", [OPEN, OPEN, OPEN, OPEN, OPEN, T]),
        ("disengagement, .995", "whole", [OPEN, OPEN, OPEN, OPEN, OPEN, T]),
    ],
)
def test_what_is_true_of_kinds(kind: str, window: str, expected: list[set[bool | None]]) -> None:
    held = dict(zip(CONDITIONS, what_holds(kind, window), strict=True))
    for (condition, found), wanted in zip(held.items(), expected, strict=True):
        # Nuisance parameters may leave a few races open, and never turn the truth round.
        assert wanted <= found <= wanted | OPEN, condition


def test_losses_are_forgetting_and_no_arms_race() -> None:
    for kind in ("decline", "collapse"):
        arms, one_sided, _, cycling, forgetting, _ = what_holds(kind, "last half")
        assert (arms, one_sided, cycling, forgetting) == (F, T, F, T)
    assert True in what_holds("forgetting", "last half", effect=2.0)[4]


def test_a_jump_and_chance_are_no_arms_race() -> None:
    for kind in ("single jump", "drift", "fluctuation"):
        arms, one_sided, _, cycling, *_ = what_holds(kind)
        assert (arms, one_sided, cycling) == (F, F, F)


def checkerboard_share(rates: np.ndarray, margin: float) -> float:
    """Count checkerboards by looking at all quadruples, one after the other."""
    found, possible = 0, 0
    for p, q in combinations(range(len(rates)), 2):
        for a, b in combinations(range(len(rates)), 2):
            wins = (rates[p, a], rates[q, b]), (rates[p, b], rates[q, a])
            found += any(min(x) - max(y) > margin for x, y in (wins, wins[::-1]))
            possible += 1
    return found / possible


@pytest.mark.parametrize("kind", ["cycle", "forgetting", "two skills", "saturating race", "drift"])
def test_share_of_checkerboards(kind: str) -> None:
    race = synthetic_races(kind, 12, 3)[0]
    truth = truths(race, "whole")["cycling"]
    share = checkerboard_share(race.rates, 0.1)
    assert truth.size == pytest.approx(share)
    slightest = checkerboard_share(race.rates, 0.02)
    assert truth.holds is (True if share >= 0.02 else None if slightest else False)


def test_truth_of_a_rise_by_hand() -> None:
    level = np.full(8, 0.5)
    even, jump, burst = (
        np.arange(8.0),
        (np.arange(8) >= 4) * 4.0,
        np.array([0, 1, 1, 1, 1, 5, 6, 7]),
    )

    def arms_race(course: np.ndarray) -> bool | None:
        rates = level[:, None] + (course[:, None] - course) / 20
        return truths(SyntheticRace(rates, course, course), "whole")["arms race"].holds

    assert [arms_race(course) for course in (even, jump, burst, -even, 0 * even)] == [
        True,
        False,
        None,
        False,
        False,
    ]


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


def test_kinds_are_enough_and_some_are_held_back() -> None:
    development = {name for name, kind in KINDS.items() if kind.development}
    assert len(KINDS) >= 18
    assert len(development) < len(KINDS) / 2
    assert {"pure race", "cycle", "drift", "forgetting", "early stagnation"} <= development


def test_bad_input_is_refused() -> None:
    with pytest.raises(ValueError, match="kind: expected one of pure race; .*, got 'chess'"):
        synthetic_races("chess", 20, 0)
    with pytest.raises(ValueError, match="n: expected at least 4 generations, got 3"):
        synthetic_races("cycle", 3, 0)


def test_later_generations_are_never_worse_where_skill_is_transitive() -> None:
    for kind in ("pure race", "two skills", "saturating race", "late stagnation"):
        rates = synthetic_races(kind, 30, 1)[0].rates
        assert (np.diff(rates, axis=0) >= 0).all()
        assert (np.diff(rates, axis=1) <= 0).all()


@pytest.mark.parametrize("name", NOISES)
def test_mean_and_variance_of_matches(name: str) -> None:
    noise, rng = NOISES[name], np.random.default_rng(1)
    means = play_episodes(np.full(40_000 // noise.episodes, 0.3), noise, rng).mean(axis=-1)
    # Binomial variance with evaders that share their fate to 1/5, and that of the matchups.
    one = 0.3 * 0.7 * (1 + (noise.evaders - 1) / 5) / noise.evaders
    expected = one / noise.episodes + noise.matchups**2
    assert means.mean() == pytest.approx(0.3, abs=0.03)
    assert means.var() == pytest.approx(expected, rel=0.35)


def test_certain_matches_end_as_they_must() -> None:
    rng = np.random.default_rng(0)
    assert play_episodes(np.ones(3), Noise(5), rng).tolist() == [[1.0] * 5] * 3
    assert play_episodes(np.zeros(3), Noise(5, evaders=30), rng).max() == 0.0
    assert analysis.checkerboards(np.eye(2)).count == 1
