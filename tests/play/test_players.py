"""Scripted opponents, and what agents see when the rules take turns."""

import math
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np
import pytest
from scipy import stats

import matrixworld as mw
from reference import MOVES
from rows import config_of

Cell = tuple[int, int]
CHASERS = ("chaser", "hunter", "surrounder")
SEARCHERS = ("hunter", "surrounder")
FLEERS = ("fleer", "dodger")
STRIDE = 12  # steps that a searcher walks on in one direction


def arena(rules: str, **changes: object) -> mw.WorldConfig:
    settings = {"rows": 10, "cols": 10, "n_pursuers": 3, "n_evaders": 4, "fov": 7, "max_steps": 40}
    return mw.WorldConfig(rules, **(settings | changes))


class Sight(NamedTuple):
    """What a script decides by: obstacles, the agent's own cell, and the cells of others."""

    config: mw.WorldConfig
    ground: np.ndarray
    here: Cell
    adversaries: list[Cell]
    teammates: list[Cell]

    def in_view(self, others: list[Cell]) -> list[Cell]:
        reach = self.config.fov // 2
        row, col = self.here
        return [c for c in {*others} if max(abs(c[0] - row), abs(c[1] - col)) <= reach]

    def is_free(self, cell: Cell) -> bool:
        row, col = cell
        inside = 0 <= row < self.config.rows and 0 <= col < self.config.cols
        return inside and not self.ground[row, col]

    def distance(self, one: Cell, other: Cell) -> int:
        """Least number of moves from one cell to another."""
        rows, cols = abs(one[0] - other[0]), abs(one[1] - other[1])
        return max(rows, cols) if self.config.diagonal else rows + cols

    def neighbors(self, cell: Cell) -> list[Cell]:
        """The cells that the actions lead to, beginning with the cell itself."""
        return [(cell[0] + row, cell[1] + col) for row, col in MOVES[: self.config.n_actions]]


def goals_of(script: str, sight: Sight) -> list[Cell]:
    adversaries, mates = sight.in_view(sight.adversaries), sight.in_view(sight.teammates)
    if script == "hunter":
        own = [
            cell
            for cell in adversaries
            if all(sight.distance(sight.here, cell) <= sight.distance(mate, cell) for mate in mates)
        ]
        return own or adversaries
    if script == "surrounder":
        beside = {cell for adversary in adversaries for cell in sight.neighbors(adversary)[1:]}
        return [cell for cell in beside if sight.is_free(cell) and cell not in mates]
    return adversaries


def worth(script: str, distances: list[int]) -> float:
    """Worth to a script of a cell with these distances to its goals."""
    if script == "dodger":
        return -sum(2**14 // (1 + moves) ** 2 for moves in distances)
    nearest = min(distances, default=0)
    return nearest if script == "fleer" else -nearest


def good_moves(script: str, sight: Sight) -> set[int] | None:
    """Moves that a script chooses from; None for a searcher without a goal."""
    goals = goals_of(script, sight)
    if script in SEARCHERS and not goals:
        return None
    value = {
        move: worth(script, [sight.distance(there, goal) for goal in goals])
        for move, there in enumerate(sight.neighbors(sight.here))
        if move == 0 or sight.is_free(there)
    }
    best = max(value.values())
    return {move for move, worth in value.items() if worth == best}


def cells(positions: np.ndarray, chosen: np.ndarray) -> list[Cell]:
    return [(int(row), int(col)) for row, col in positions[chosen]]


def choices_in(
    episode: mw.Episode, config: mw.WorldConfig, script: str, team: str, later: int = 0
) -> Iterator[tuple[int, set[int]]]:
    """Yield each action of a team, and the moves that a script with a goal would choose from.

    With `later` of 1 the other team has moved already when this one chooses.
    """
    agents = np.arange(config.n_agents)
    is_mine = (agents >= config.n_pursuers) == (team == "evader")
    for step, actions in enumerate(episode.actions):
        positions, alive = episode.positions[step], episode.alive[step + later]
        theirs = cells(episode.positions[step + later], ~is_mine & alive)
        for agent in np.flatnonzero(is_mine & alive):
            [here] = cells(positions, [agent])
            mates = cells(positions, is_mine & alive & (agents != agent))
            good = good_moves(script, Sight(config, episode.map, here, theirs, mates))
            if good is not None:
                yield actions[agent], good


def recorded(config: mw.WorldConfig, team: str, script: str, other: str, seed: int) -> mw.Episode:
    return mw.record(config, *((other, script) if team == "evader" else (script, other)), seed=seed)


def check_choices(config: mw.WorldConfig, script: str, team: str, seed: int) -> list[int]:
    """Check every choice of a team in an episode; return the numbers of moves to choose from."""
    episode = recorded(config, team, script, "random", seed)
    choices = list(choices_in(episode, config, script, team))
    assert all(action in good for action, good in choices)
    return [len(good) for _, good in choices]


@pytest.mark.parametrize("obstacles", [None, 0.2])
@pytest.mark.parametrize("diagonal", [False, True])
@pytest.mark.parametrize("team", ["pursuer", "evader"])
@pytest.mark.parametrize("script", [*CHASERS, *FLEERS])
def test_choices(script: str, team: str, diagonal: bool, obstacles: float | None) -> None:
    config = arena("O", diagonal=diagonal, obstacles=obstacles)
    choices = [n for seed in range(5) for n in check_choices(config, script, team, seed)]
    assert 1 in choices  # at times a single move is best
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


def test_random_players_take_every_action_equally_often() -> None:
    config = arena("S", diagonal=True, max_steps=2000)
    actions = mw.record(config, "random", "random", seed=1).actions
    assert stats.chisquare(np.bincount(actions.ravel(), minlength=9)).pvalue > 1e-3


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
    assert counts[0] == 0  # nobody searches by standing still
    assert stats.chisquare(counts[1:]).pvalue > 1e-3
    assert not np.array_equal(strides[0][:5, 0], strides[1][:5, 0])


@pytest.mark.parametrize(
    ("script", "sober"), [("clumsy-chaser", "chaser"), ("clumsy-fleer", "fleer")]
)
def test_clumsy_scripts_slip_in_half_of_their_steps(script: str, sober: str) -> None:
    """On an open grid one or few moves are good, and a slip is any of five moves."""
    team = "pursuer" if sober == "chaser" else "evader"
    config = arena("R", rows=9, cols=9, n_pursuers=4, n_evaders=4, fov=17, max_steps=60)
    expected = variance = hits = 0.0
    for seed in range(15):
        episode = recorded(config, team, script, "still", seed)
        for action, good in choices_in(episode, config, sober, team):
            chance = 0.5 + 0.5 * len(good) / config.n_actions
            expected += chance
            variance += chance * (1 - chance)
            hits += action in good
    assert variance > 250  # many slips: 4 deviations are then a few percent
    assert abs(hits - expected) < 4 * math.sqrt(variance)


@pytest.mark.parametrize("name", ["TO", "swarm-S"])
def test_fleers_flee_from_where_pursuers_went(name: str) -> None:
    """Pursuers act first; under these rules they never move or die in an evader's turn."""
    config = config_of(name, rows=9, cols=9, n_pursuers=3, n_evaders=4, fov=7, max_steps=30)
    clear = 0
    for seed in range(6):
        episode = mw.record(config, "random", "fleer", seed=seed)
        for action, good in choices_in(episode, config, "fleer", "evader", later=1):
            assert action in good
            clear += len(good) < config.n_actions
    assert clear > 100
