"""Scripted opponents, and what agents see when the rules take turns."""

from __future__ import annotations

import math
from itertools import pairwise

import numpy as np
import pytest
from scipy import stats

import matrixworld as mw
from rows import config_of

MOVES = [(0, 0), (-1, 0), (0, 1), (1, 0), (0, -1), (-1, 1), (1, 1), (1, -1), (-1, -1)]
CHASERS = ("chaser", "hunter", "surrounder")
SEARCHERS = ("hunter", "surrounder")
FLEERS = ("fleer", "dodger")
STRIDE = 12  # steps that a searcher walks on in one direction


def arena(rules: str, **changes: object) -> mw.WorldConfig:
    settings = {"rows": 10, "cols": 10, "n_pursuers": 3, "n_evaders": 4, "fov": 7, "max_steps": 40}
    return mw.WorldConfig(rules, **(settings | changes))


def distance(config: mw.WorldConfig, one: tuple[int, int], other: tuple[int, int]) -> int:
    """Least number of moves from one cell to another."""
    rows, cols = abs(one[0] - other[0]), abs(one[1] - other[1])
    return max(rows, cols) if config.diagonal else rows + cols


def goals_of(
    script: str,
    config: mw.WorldConfig,
    ground: np.ndarray,
    here: tuple[int, int],
    adversaries: list[tuple[int, int]],
    teammates: list[tuple[int, int]],
) -> list[tuple[int, int]]:
    """Goals of a script, from the cells of agents in view."""
    if script == "hunter":
        lead = {
            cell: min((distance(config, mate, cell) for mate in teammates), default=math.inf)
            for cell in adversaries
        }
        free = [cell for cell in adversaries if distance(config, here, cell) <= lead[cell]]
        return free or adversaries
    if script == "surrounder":
        beside = {
            (row + MOVES[move][0], col + MOVES[move][1])
            for row, col in adversaries
            for move in range(1, config.n_actions)
        }
        return [cell for cell in beside if is_free(config, ground, cell) and cell not in teammates]
    return adversaries


def is_free(config: mw.WorldConfig, ground: np.ndarray, cell: tuple[int, int]) -> bool:
    row, col = cell
    return 0 <= row < config.rows and 0 <= col < config.cols and not ground[row, col]


def worth(script: str, distances: list[int]) -> float:
    """Worth to a script of a cell with these distances to its goals."""
    if script == "dodger":
        return -sum(2**14 // (1 + moves) ** 2 for moves in distances)
    nearest = min(distances, default=0)
    return nearest if script == "fleer" else -nearest


def good_moves(
    script: str,
    config: mw.WorldConfig,
    ground: np.ndarray,
    here: tuple[int, int],
    adversaries: list[tuple[int, int]],
    teammates: list[tuple[int, int]],
) -> set[int] | None:
    """Moves that a script chooses from; None for a searcher without a goal."""
    reach = config.fov // 2

    def seen(others: list[tuple[int, int]]) -> list[tuple[int, int]]:
        return [c for c in {*others} if max(abs(c[0] - here[0]), abs(c[1] - here[1])) <= reach]

    goals = goals_of(script, config, ground, here, seen(adversaries), seen(teammates))
    if script in SEARCHERS and not goals:
        return None
    value = {}
    for move in range(config.n_actions):
        there = here[0] + MOVES[move][0], here[1] + MOVES[move][1]
        if move == 0 or is_free(config, ground, there):
            value[move] = worth(script, [distance(config, there, goal) for goal in goals])
    best = max(value.values())
    return {move for move, worth in value.items() if worth == best}


def cells(positions: np.ndarray, chosen: np.ndarray) -> list[tuple[int, int]]:
    return [(int(row), int(col)) for row, col in positions[chosen]]


def check_choices(config: mw.WorldConfig, script: str, team: str, seed: int) -> list[int]:
    """Check every choice of a team in an episode; return the numbers of moves to choose from."""
    sides = ("random", script) if team == "evader" else (script, "random")
    episode = mw.record(config, *sides, seed=seed)
    is_mine = (np.arange(config.n_agents) >= config.n_pursuers) == (team == "evader")
    choices = []
    for step in range(episode.length):
        positions, alive = episode.positions[step], episode.alive[step]
        theirs = cells(positions, ~is_mine & alive)
        for agent in np.flatnonzero(is_mine & alive):
            [here] = cells(positions, [agent])
            mates = cells(positions, is_mine & alive & (np.arange(config.n_agents) != agent))
            good = good_moves(script, config, episode.map, here, theirs, mates)
            if good is not None:
                assert episode.actions[step, agent] in good
                choices.append(len(good))
    return choices


@pytest.mark.parametrize("obstacles", [None, 0.2])
@pytest.mark.parametrize("diagonal", [False, True])
@pytest.mark.parametrize("team", ["pursuer", "evader"])
@pytest.mark.parametrize("script", [*CHASERS, *FLEERS])
def test_choices(script: str, team: str, diagonal: bool, obstacles: float | None) -> None:
    config = arena("O", diagonal=diagonal, obstacles=obstacles)
    choices = [n for seed in range(5) for n in check_choices(config, script, team, seed)]
    assert 1 in choices
    if script not in SEARCHERS:
        assert max(choices) == config.n_actions  # no agent in view and no obstacle beside
    surround = arena("SB", diagonal=diagonal, obstacles=obstacles, fov=5)
    assert check_choices(surround, script, team, 9)


def test_ties_are_broken_evenly() -> None:
    """Without agents in view all free moves are equally likely."""
    config = arena("O", rows=60, cols=60, n_pursuers=1, n_evaders=1, fov=1, max_steps=3000)
    episode = mw.record(config, "chaser", "still", seed=2)
    inside = (episode.positions[:-1, 0] > 0) & (episode.positions[:-1, 0] < 59)
    counts = np.bincount(episode.actions[inside.all(axis=1), 0], minlength=5)
    assert counts.sum() > 1000
    assert stats.chisquare(counts).pvalue > 1e-3


@pytest.mark.parametrize("diagonal", [False, True])
def test_random_players_take_every_action_equally_often(diagonal: bool) -> None:
    config = arena("S", diagonal=diagonal, max_steps=400)
    actions = mw.record(config, "random", "random", seed=1).actions
    assert len(actions) == 400
    for agent in range(config.n_agents):
        counts = np.bincount(actions[:, agent], minlength=config.n_actions)
        assert len(counts) == config.n_actions
        assert stats.chisquare(counts).pvalue > 1e-4


def test_still_players_stay() -> None:
    episode = mw.record(arena("SB"), "still", "still", seed=5)
    assert not episode.actions.any()
    assert (episode.positions == episode.positions[0]).all()


@pytest.mark.parametrize("script", [*CHASERS, *FLEERS])
def test_scripts_avoid_obstacles(script: str) -> None:
    config = arena("SB", obstacles=0.2)
    matches = mw.Matches.of(0, 0, np.arange(20))
    scores = mw.rollout(config, script, script, matches)
    assert not scores.collisions[..., 0].any()
    assert mw.rollout(config, "random", "random", matches).collisions[..., 0].all()


def lonely_strides(script: str, seed: int) -> np.ndarray:
    """Actions, one row for each stride, of a pursuer that sees no agent and no border."""
    config = arena("O", rows=300, cols=300, n_pursuers=1, n_evaders=1, fov=1, max_steps=120)
    episode = mw.record(config, script, "still", seed=seed)
    starts = episode.positions[:-1:STRIDE, 0]
    inside = ((starts >= STRIDE) & (starts < 300 - STRIDE)).all(axis=1)
    return episode.actions[:, 0].reshape(-1, STRIDE)[inside]


@pytest.mark.parametrize("script", SEARCHERS)
def test_searchers_walk_on_in_one_direction(script: str) -> None:
    strides = [lonely_strides(script, seed) for seed in range(40)]
    directions = np.concatenate(strides)
    assert (directions == directions[:, :1]).all()
    counts = np.bincount(directions[:, 0], minlength=5)
    assert counts[0] == 0
    assert stats.chisquare(counts[1:]).pvalue > 1e-3
    assert not np.array_equal(strides[0][:5, 0], strides[1][:5, 0])


@pytest.mark.parametrize(
    ("script", "sober"), [("clumsy-chaser", "chaser"), ("clumsy-fleer", "fleer")]
)
def test_clumsy_scripts_slip_in_half_of_their_steps(script: str, sober: str) -> None:
    """On an open grid one or few moves are good, and a slip is any of five moves."""
    team = "pursuer" if sober == "chaser" else "evader"
    config = arena("R", rows=9, cols=9, n_pursuers=4, n_evaders=4, fov=17, max_steps=60)
    sides = ("still", script) if team == "evader" else (script, "still")
    expected = variance = hits = 0.0
    for seed in range(30):
        episode = mw.record(config, *sides, seed=seed)
        for step in range(episode.length):
            positions = episode.positions[step]
            for agent in range(4, 8) if team == "evader" else range(4):
                [here] = cells(positions, [agent])
                theirs = cells(positions, np.arange(4) if team == "evader" else np.arange(4, 8))
                good = good_moves(sober, config, episode.map, here, theirs, [])
                assert good is not None
                chance = 0.5 + 0.5 * len(good) / config.n_actions
                expected += chance
                variance += chance * (1 - chance)
                hits += episode.actions[step, agent] in good
    assert variance > 500
    assert abs(hits - expected) < 4 * math.sqrt(variance)


def test_scripts_differ_in_skill() -> None:
    """In its games each script captures more than the script before it."""
    matches = mw.Matches.of(0, 0, np.arange(20))

    def caught(variant: str, pursuers: str, evaders: str) -> float:
        config = mw.WorldConfig(variant, max_steps=150)
        return float(mw.rollout(config, pursuers, evaders, matches).captured_fraction.mean())

    def rises(rates: list[float]) -> bool:
        return all(later > earlier + 0.03 for earlier, later in pairwise(rates))

    chasers = ["random", "clumsy-chaser", "chaser", "hunter"]
    assert rises([caught("O", chaser, "random") for chaser in chasers])
    evaders = ["fleer", "clumsy-fleer", "random"]
    assert rises([caught("O", "hunter", evader) for evader in evaders])
    for variant in ("S", "SD"):
        best = max(caught(variant, chaser, "random") for chaser in chasers)
        assert caught(variant, "surrounder", "random") > best + 0.3


# ---- Turns -----------------------------------------------------------------------------------


def first_moves(name: str) -> list[tuple[int, int]]:
    """First moves in a corridor in which agents see each other once the pursuer steps east.

    ``P . e .`` with a view of one cell on each side; the evader flees from what it sees.
    """
    config = config_of(name, rows=1, cols=4, n_pursuers=1, n_evaders=1, fov=3, max_steps=1)
    moves = []
    for seed in range(300):
        episode = mw.record(config, "chaser", "fleer", seed=seed)
        if episode.positions[0, :, 1].tolist() == [0, 2]:
            pursuer, evader = episode.actions[0]
            moves.append((int(pursuer), int(evader)))
    return moves


@pytest.mark.parametrize("name", ["TO", "agents-S", "swarm-S"])
def test_later_turns_see_what_earlier_ones_did(name: str) -> None:
    moves = first_moves(name)
    assert {pursuer for pursuer, _ in moves} == {mw.Action.STAY, mw.Action.EAST}
    after_approach = {evader for pursuer, evader in moves if pursuer == mw.Action.EAST}
    assert after_approach == {mw.Action.EAST}
    unseen = {evader for pursuer, evader in moves if pursuer == mw.Action.STAY}
    assert unseen == {mw.Action.STAY, mw.Action.EAST, mw.Action.WEST}


def test_simultaneous_agents_do_not_see_each_others_moves() -> None:
    moves = first_moves("O")
    after_approach = {evader for pursuer, evader in moves if pursuer == mw.Action.EAST}
    assert after_approach == {mw.Action.STAY, mw.Action.EAST, mw.Action.WEST}


def test_teammates_see_each_other_move_in_agent_turns() -> None:
    """Pursuer 1 goes east if pursuer 0 has left the cell east of it, and stays if it is there.

    With a network that reads one cell: "go east if no teammate is east of me, else stay".
    """
    config = config_of("TO", rows=1, cols=5, n_pursuers=2, n_evaders=1, fov=3, max_steps=1)
    network = mw.Network.for_config(config, (), sampled=False)
    genome = np.zeros(network.genome_size, np.float32)
    [(weights, bias)] = network.layers(genome)
    east_of_me = (1 * 3 + 1) * 3 + 2  # channel of pursuers, middle row, last column
    bias[mw.Action.EAST] = 1
    weights[east_of_me, mw.Action.EAST] = -2
    team = mw.Population(genome, network)
    seen = set()
    for seed in range(200):
        episode = mw.record(config, team, "still", seed=seed)
        columns = episode.positions[0, :, 1].tolist()
        if columns == [2, 1, 4]:  # ". 1 0 . e": 0 leaves before 1 looks
            assert episode.actions[0, :2].tolist() == [mw.Action.EAST, mw.Action.EAST]
            seen.add("follows")
        if columns == [1, 2, 4]:  # ". 0 1 . e": 0 sees 1, which is still there
            assert episode.actions[0, :2].tolist() == [mw.Action.STAY, mw.Action.EAST]
            seen.add("waits")
    assert seen == {"follows", "waits"}


@pytest.mark.parametrize("name", ["TO", "swarm-S"])
def test_fleers_flee_from_where_pursuers_went(name: str) -> None:
    """Pursuers act first; under these rules they never move or die in an evader's turn."""
    config = config_of(name, rows=9, cols=9, n_pursuers=3, n_evaders=4, fov=7, max_steps=30)
    n_pursuers = config.n_pursuers
    n_checked = 0
    for seed in range(6):
        episode = mw.record(config, "random", "fleer", seed=seed)
        for step in range(episode.length):
            pursuers = cells(episode.positions[step + 1], np.arange(n_pursuers))
            for agent in range(n_pursuers, config.n_agents):
                if not episode.alive[step + 1, agent]:
                    continue
                [here] = cells(episode.positions[step], [agent])
                good = good_moves("fleer", config, episode.map, here, pursuers, [])
                assert good is not None
                assert episode.actions[step, agent] in good
                n_checked += len(good) < config.n_actions
    assert n_checked > 100
