"""What notebooks say is true: of their small worlds, of learning, and of kept races."""

from itertools import combinations, permutations, product

import numpy as np
import pytest

import matrixworld as mw
from course import check, kept
from course.chapter_2 import JAM, JAM_ACTIONS
from matrixworld import Action, analysis
from matrixworld.explorer.playground import drawn_world
from notebooks import NOTEBOOKS, cells, source

STAY, NORTH, EAST, SOUTH = list(Action)[:4]


def test_every_single_change_that_frees_pursuer_0_is_right() -> None:
    """The engine decides; the answers are those that the solution sheet names."""
    free = []
    for agent, action in product(range(1, 5), list(Action)[:5]):
        actions = list(JAM_ACTIONS)
        if actions[agent] == action:
            continue
        actions[agent] = action
        world = drawn_world("SB", JAM)
        world.step(actions)
        right = world.positions[0].tolist() == [1, 1]
        assert check("2.1", actions).right is right
        if right:
            free.append((agent, action))
    assert free == [(1, NORTH), (1, SOUTH), (2, STAY), (2, NORTH), (2, EAST), (2, SOUTH)]


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
