"""Ranks of a class: a range where the episodes cannot tell more."""

from __future__ import annotations

import numpy as np
import pytest

from matrixworld import WorldConfig
from matrixworld.classroom.page import digits, pack_actions
from matrixworld.classroom.standings import payoffs_of, rank_ranges, standings
from matrixworld.classroom.submissions import Entry
from matrixworld.classroom.tournament import ClassResult


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
