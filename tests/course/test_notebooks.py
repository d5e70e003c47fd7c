"""What notebooks say is true: of their small worlds, of learning, and of kept races."""

from functools import partial
from itertools import combinations, permutations, product

import numpy as np
import pytest

import matrixworld as mw
from course import check, kept
from course.boards import random_pack
from course.chapter_1 import MAZE, SHORTEST
from course.chapter_2 import JAM, JAM_ACTIONS, true_cells
from matrixworld import Action, analysis
from matrixworld.explorer.playground import drawn_world
from notebooks import NOTEBOOKS, cells, source
from student_functions import by_index

STAY, NORTH, EAST, SOUTH = list(Action)[:4]


def test_there_is_one_shortest_way() -> None:
    # So that `np.roll` leads nobody round the border.
    walls = np.pad(drawn_world("O", MAZE).map, 1, constant_values=True)
    ways = np.zeros(walls.shape, int)
    ways[1, 1] = 1
    for moves in range(1, SHORTEST + 1):
        # Each way goes on in four directions.
        ways = sum(np.roll(ways, by, axis) for by in (1, -1) for axis in (0, 1)) * ~walls
        assert bool(ways[4, 5]) is (moves == SHORTEST)
    assert ways[4, 5] == 1


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


def test_renumbering_changes_most_steps_by_index_and_none_of_the_world() -> None:
    """2.e and 2.f, in crowds that the notebook does not draw."""
    rng = np.random.default_rng(7)
    at_once = partial(true_cells, side=10)
    changed = {by_index: 0, at_once: 0}
    for _ in range(60):
        here, there = random_pack(rng, 10, 30)  # dense: most agents have a neighbour to depend on
        order = rng.permutation(30)
        for resolver in changed:
            result = resolver(here, there)
            again = resolver([here[a] for a in order], [there[a] for a in order])
            changed[resolver] += again != [result[a] for a in order]
    assert changed[by_index] > 40  # of 60
    assert changed[at_once] == 0


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
