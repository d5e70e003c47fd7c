"""The compiled world against the slow one, on random small crowded worlds of all rules.

``pytest --slow --hypothesis-profile=long tests/contract/test_reference.py`` looks much longer.
"""

from __future__ import annotations

from itertools import combinations, product
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import matrixworld as mw
from reference import MOVES, ReferenceWorld, records
from scenes import FIELDS, TOGETHER, Scene, random_scene, scenes

World = mw.World | ReferenceWorld
WORLDS_PER_ROW = 4
WORLDS_OF_SHARED_CELLS = 1500
MANY = settings(max_examples=8 * settings().max_examples)
ARRAYS = (
    *("positions", "last_positions", "alive", "captured", "ever_captured", "captors"),
    *("involved", "fault"),
)
NUMBERS = ("steps", "terminated", "truncated")


def differences(reference: ReferenceWorld, world: mw.World, *, explained: bool) -> list[str]:
    """Whatever the two worlds do not agree on."""
    pairs: dict[str, tuple[Any, Any]] = {
        name: (getattr(reference, name), getattr(world, name)) for name in (*ARRAYS, *NUMBERS)
    }
    pairs["views"] = reference.views(), world.views()
    pairs["state"] = reference.state(), world.state()
    pairs["map"] = reference.map, world.map
    found = [
        f"{name}: expected\n{mine}\ngot\n{theirs}"
        for name, (mine, theirs) in pairs.items()
        if not np.array_equal(mine, theirs)
    ]
    if not np.allclose(reference.rewards, world.rewards, rtol=1e-6, atol=1e-6):
        found.append(f"rewards: expected {reference.rewards}, got {world.rewards}")
    if explained and (mine := records(reference.conflicts)) != (theirs := records(world.conflicts)):
        found.append(f"conflicts: expected\n{mine}\ngot\n{theirs}")
    return found


def compare(scene: Scene) -> None:
    """Plays a scene in both worlds and compares them at the start and after each step."""
    reference, world = scene.reference(), scene.engine()
    wrong = differences(reference, world, explained=False)
    assert not wrong, "\n".join([str(scene), "at the start", *wrong])
    for step, actions in enumerate(scene.actions, start=1):
        paid = world.step(actions, explain=True)
        reference.step(actions)
        wrong = differences(reference, world, explained=True)
        assert not wrong, "\n".join([str(scene), f"after step {step}", *wrong])
        assert np.array_equal(paid, world.rewards)  # which are compared above
        if reference.terminated or reference.truncated:
            break


@pytest.mark.parametrize("interaction", FIELDS["interaction"])
@MANY
@given(data=st.data())
def test_the_engine_agrees_with_the_slow_reading(interaction: str, data: st.DataObject) -> None:
    compare(data.draw(scenes(interaction=[interaction])))


@pytest.mark.parametrize("interaction", FIELDS["interaction"])
@pytest.mark.parametrize("adversary", FIELDS["adversary"])
def test_every_row_of_rules(adversary: str, interaction: str) -> None:
    names = ("obstacle", "teammate", "capture", "disappear")
    for values in product(*(FIELDS[name] for name in names)):
        fields = {"interaction": interaction, "adversary": adversary}
        fields |= dict(zip(names, values, strict=True))
        rng = np.random.default_rng([*"".join(map(str, fields.values())).encode()])
        for _ in range(WORLDS_PER_ROW):
            compare(random_scene(fields, rng))


@pytest.mark.slow
def test_links_that_share_a_cell() -> None:
    """Evaders that may share a cell and be held there one after another are rare elsewhere."""
    fields = {"obstacle": "B", "teammate": "R", "adversary": "BR", "capture": "surround"}
    rng = np.random.default_rng(0)
    for _ in range(WORLDS_OF_SHARED_CELLS):
        compare(random_scene(fields, rng))


# -- numbering ---------------------------------------------------------------------------------


def renumbered(scene: Scene, order: list[int]) -> Scene:
    """The scene in which agent ``i`` is the one that was ``order[i]``."""
    cells = [*scene.pursuers, *scene.evaders]
    moved = [cells[old] for old in order]
    n = len(scene.pursuers)
    actions = [[step[old] for old in order] for step in scene.actions]
    return Scene(scene.fields, scene.config, moved[:n], moved[n:], scene.obstacles, actions)


def named(world: World, order: list[int]) -> list[tuple]:
    """The conflicts with the old numbers; a swap has no cell, as that depends on the numbers."""
    found = []
    for turn, kind, form, agents, cell, *groups in records(world.conflicts):
        old = [order[a] for a in agents]
        who = tuple(old if form == "chain" else sorted(old))
        sets = [tuple(sorted(order[a] for a in group)) for group in groups]
        found.append((turn, kind, form, who, () if form == "edge" else cell, *sets))
    return sorted(found)


@MANY
@given(scenes(interaction=TOGETHER), st.randoms(use_true_random=False))
def test_renumbering_agents_renumbers_the_result(scene: Scene, random: Any) -> None:
    n, total = len(scene.pursuers), scene.config.n_agents
    order = random.sample(range(n), n) + random.sample(range(n, total), total - n)
    evaders = [old - n for old in order[n:]]
    one, other = scene.engine(), renumbered(scene, order).engine()
    for actions in scene.actions:
        one.step(actions, explain=True)
        other.step([actions[old] for old in order], explain=True)
        for name in ("positions", "alive", "involved", "fault", "rewards"):
            np.testing.assert_array_equal(getattr(one, name)[order], getattr(other, name))
        for name in ("captured", "ever_captured", "captors"):
            np.testing.assert_array_equal(getattr(one, name)[evaders], getattr(other, name))
        np.testing.assert_array_equal(one.views()[order], other.views())
        assert named(one, list(range(total))) == named(other, order)
        assert (one.terminated, one.truncated) == (other.terminated, other.truncated)
        if one.terminated or one.truncated:
            break


# -- what no step may break --------------------------------------------------------------------


def living(world: World) -> dict[int, tuple[int, ...]]:
    cells = np.asarray(world.positions).tolist()
    return {a: tuple(cells[a]) for a in np.flatnonzero(world.alive).tolist()}


def assert_apart(before: dict, after: dict, pairs: list[tuple[int, int]]) -> None:
    """No two of the pairs that are still alive share a cell or have swapped."""
    for a, b in pairs:
        if a in after and b in after:
            assert after[a] != after[b], f"{a} and {b} share {after[a]}"
            swapped = after[a] == before[b] and after[b] == before[a]
            assert not swapped, f"{a} and {b} swapped"


@pytest.mark.slow
@MANY
@given(scenes(teammate=["B"]))
def test_teammates_that_bounce_stay_apart(scene: Scene) -> None:
    n, total = len(scene.pursuers), scene.config.n_agents
    pairs = [(a, b) for a, b in combinations(range(total), 2) if (a < n) == (b < n)]
    for before, after, _, _ in played(scene):
        assert_apart(before, after, pairs)


@pytest.mark.slow
@MANY
@given(scenes(adversary=[pair for pair in FIELDS["adversary"] if pair != "RR"]))
def test_adversaries_stay_apart_unless_both_reach(scene: Scene) -> None:
    n, total = len(scene.pursuers), scene.config.n_agents
    pairs = list(product(range(n), range(n, total)))
    for before, after, _, _ in played(scene):
        assert_apart(before, after, pairs)


@MANY
@given(scenes())
def test_an_agent_stays_or_does_what_it_set_out_to_do(scene: Scene) -> None:
    for before, after, actions, _ in played(scene):
        assert after.keys() <= before.keys(), "nobody comes back"
        for a, (row, col) in after.items():
            moved = row - before[a][0], col - before[a][1]
            assert moved in ((0, 0), MOVES[actions[a]])
            assert 0 <= row < scene.config.rows
            assert 0 <= col < scene.config.cols
            if scene.fields["obstacle"] != "R":
                assert not scene.obstacles[row, col]


@pytest.mark.slow
@MANY
@given(scenes())
def test_the_reports_agree_with_each_other(scene: Scene) -> None:
    n = len(scene.pursuers)
    for before, after, _, world in played(scene):
        assert not (world.fault & ~world.involved).any()
        assert not (world.captured & ~world.ever_captured).any()
        captured = {n + int(e) for e in np.flatnonzero(world.captured)}
        with_captors = {n + int(e) for e in np.flatnonzero(world.captors)}
        assert with_captors == captured & before.keys()
        doomed = {a for conflict in world.conflicts for a in conflict.doomed}
        disappears = scene.fields["capture"] == "surround" and scene.fields["disappear"]
        assert before.keys() - after.keys() == doomed | (with_captors if disappears else set())


def played(scene: Scene):
    """The steps of a scene in the compiled world: cells before and after, actions, world."""
    world = scene.engine()
    for actions in scene.actions:
        before = living(world)
        world.step(actions, explain=True)
        yield before, living(world), actions, world
        if world.terminated or world.truncated:
            break
