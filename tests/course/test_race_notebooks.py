"""Notebooks 3 to 9: what their texts say of learning, races and results that are kept is true."""

from collections.abc import Callable
from itertools import combinations, permutations, product
from typing import Any

import numpy as np
import pytest

import matrixworld as mw
from course import check, kept, toys
from course.chapter_9 import WORLD, Mask, play_masked
from matrixworld import analysis
from matrixworld.world.arrays import MOVES
from matrixworld.world.masks import action_masks, forbidding_cells
from notebooks import NOTEBOOKS, cells, source
from student_functions import left_waits
from student_functions import right_of_way as as_on_a_road

# ---- Notebook 3 ----------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "size", [{}, {"rows": 5, "cols": 5, "max_steps": 30}, {"n_pursuers": 1, "n_evaders": 9}]
)
def test_the_match_step_by_step_is_that_of_rollout(size: dict) -> None:
    """For other networks and other worlds than those of the notebook."""
    fields = {"rows": 12, "cols": 12, "n_pursuers": 3, "n_evaders": 6, "fov": 5, "max_steps": 60}
    world = mw.WorldConfig("O", **{**fields, **size})
    network = mw.Network.for_config(world, (8,), sampled=False)
    names = {"mw": mw, "world": world, "network": network}
    for text in map(source, cells(NOTEBOOKS[2], "code")):
        if text.startswith("def play("):
            exec(text, names)
    genome = network.initial(np.random.default_rng(0), 0.3, 0.5)
    team = mw.Population(genome, network)
    matches = mw.Matches.of(0, 0, np.arange(12))
    statistics = mw.rollout(world, team, "random", matches)
    for match in range(12):
        moves = mw.record(world, team, "random", seed=match).actions[:, world.n_pursuers :]
        found = names["play"](genome, match, moves)
        assert found == (statistics.capture_rate[match, 0], statistics.length[match, 0])


# ---- Notebook 5 ----------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("schedule", "race", "cycling"),
    [
        ("specialist_specialist", "cannot tell", "present"),
        ("generalist_specialist", "present", "absent"),
        ("generalist_generalist", "present", "absent"),
    ],
)
def test_verdicts_on_ten_seeds(schedule: str, race: str, cycling: str) -> None:
    races = kept("paper_races")
    found = analysis.judge(races[schedule] / int(races["evaders"]), per_episode=True).findings
    assert (found["arms race"].verdict, found["cycling"].verdict) == (race, cycling)


EVADERS, PURSUERS, OBSTACLES = range(3)  # channels of views


# ---- Notebook 9: safety --------------------------------------------------------------------------


def test_conventions_that_stop_no_group_are_the_orders_of_the_moves() -> None:
    """Of the 64 in which exactly one of two goes first."""
    moves = range(1, 5)
    pairs = [*combinations(moves, 2)]
    orders = {tuple(o.index(a) < o.index(b) for a, b in pairs) for o in permutations(moves)}
    for firsts in product((True, False), repeat=len(pairs)):
        table = dict(zip(pairs, firsts, strict=True))
        table |= {(b, a): not first for (a, b), first in table.items()}
        reply = check("9.4", lambda own, other, table=table: table[own, other])
        assert reply.right is (firsts in orders)
        assert reply.right or "exactly one goes first, so nobody collides" in reply.text


def mask_of(goes_first: Callable[[int, int], bool]) -> Mask:
    """Return the mask of a convention: moves to free cells before all teammates that could enter.

    `goes_first` takes the moves, 1 to 4, by which a pursuer and a teammate can enter one cell.
    """

    def mask(views: np.ndarray) -> np.ndarray:
        allowed, middle = np.ones((len(views), WORLD.n_actions), bool), views.shape[-1] // 2
        for own in range(1, 5):
            row, col = middle + MOVES[own]
            allowed[:, own] = ~views[:, :, row, col].any(axis=1)
            for other in range(1, 5):
                if other != own and not goes_first(own, other):
                    row, col = middle + MOVES[own] - MOVES[other]
                    allowed[:, own] &= views[:, PURSUERS, row, col] == 0
        return allowed

    return mask


def test_the_mask_of_the_package_is_that_of_right_before_left() -> None:
    views = (np.random.default_rng(0).random((2000, 3, 11, 11)) < 0.1).astype(np.uint8)
    allowed = action_masks(views, forbidding_cells(WORLD, "right-of-way", "pursuer"))
    np.testing.assert_array_equal(allowed.astype(bool), mask_of(as_on_a_road)(views))


def test_nobody_is_at_fault_where_one_of_two_goes_first() -> None:
    greedy = [6, 20, 0, 0, 0, 0]
    for rule in (as_on_a_road, lambda own, other: own < other, lambda own, other: own > other):
        safety, _ = play_masked(greedy, mask_of(rule), episodes=100, seed=92)
        assert not safety.summary().fault_rate[0].any()
    both_go, _ = play_masked(greedy, mask_of(left_waits), episodes=100, seed=92)
    assert both_go.summary().fault_rate[0, 1] > 0


# ---- Notebooks 4 and 10 --------------------------------------------------------------------------


def test_perfect_players_of_nim_lose_to_nobody_who_errs() -> None:
    """First players win exactly if they leave a multiple of four each time; told by search."""

    def wins(genome: np.ndarray, left: int) -> bool:
        """Return whether a first player, to move, wins against every reply."""
        left -= int(toys.taken(genome[None], np.array([left]))[0])
        return not left or all(left > k and wins(genome, left - k) for k in (1, 2, 3) if k <= left)

    genomes = np.random.default_rng(0).normal(size=(3000, 39)).astype(np.float32)
    genomes[::3] = toys.perfect_players(1000)
    perfect = toys.perfect_players(200)
    scores = toys.all_against_all(toys.NIM, genomes, perfect).mean(axis=1)
    assert (scores[::3] == 1).all()
    for genome, score in zip(genomes, scores, strict=True):
        assert bool(score == 1) is wins(genome, 13)


def test_answers_to_the_newest_never_improve_and_those_to_the_nash_mixture_do() -> None:
    names: dict[str, Any] = {"np": np, "analysis": analysis}
    for text in map(source, cells(NOTEBOOKS[-1], "code")):
        if text.startswith("def newest"):
            exec(text, names)
    for seed in (100, 101):
        own, other = np.random.default_rng(seed).normal(size=(2, 200, 3))
        game = 1 / (1 + np.exp(-own @ other.T))
        newest, nash = (names["respond"](game, names[n], 12)[-1] for n in ("newest", "nash"))
        assert newest > 0.95
        assert nash < 0.4
