"""Exact solutions of small worlds, against theory, an own trial and slow computations."""

import signal
import time
import warnings
from collections.abc import Callable, Iterator
from copy import copy
from dataclasses import replace
from functools import cache
from itertools import permutations, product
from typing import Any

import numpy as np
import pytest
from scipy.optimize import linprog

import matrixworld as mw
from matrixworld.coevolution import TEAMS
from matrixworld.solver import Solution, States, best_response, expected_payoff, solve
from reference import ReferenceWorld
from rows import CUSTOM, OCCUPATION, SURROUND, TOGETHER, B, D, R, random_team
from slow import quickly

ROWS = {**mw.VARIANTS, **CUSTOM}
HOLE = [[0, 0, 0, 0], [0, 1, 0, 0], [0, 0, 0, 0]]
CHAMPIONS = ("random", "still", "chaser", "fleer", "clumsy-chaser", "clumsy-fleer", "dodger")


def world(variant: mw.Rules | str = "O", **changes: object) -> mw.WorldConfig:
    sizes = {"rows": 4, "cols": 4, "n_pursuers": 2, "n_evaders": 1, "max_steps": 5}
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # rules that capture nobody are rules, too
        return mw.WorldConfig(variant, **{**sizes, **changes})


def test_two_pursuers_on_4_x_4_reach_what_regret_matching_found() -> None:
    solution = solve(world(), steps=10)
    after = [float(row[solution.states.starts].mean()) for row in solution.values[0]]
    assert after[5] == pytest.approx(0.838, abs=0.005)
    assert solution.value == pytest.approx(1.0, abs=1e-12)
    assert solution.gap < 1e-9


@pytest.mark.parametrize("changes", [{"diagonal": True}, {"n_evaders": 2}, {"rows": 6, "cols": 6}])
def test_strategies_of_large_games_guarantee_the_same(changes: dict[str, Any]) -> None:
    """Games of 81 x 9, 25 x 25 and 25 x 5 joint actions, most of them degenerate."""
    assert solve(world(**changes), steps=2).gap < 1e-10


# Mehrabian 2011, "The capture time of grids", Discrete Mathematics 311.
GRIDS = [(2, 6), (3, 3), (3, 7), (4, 5), (5, 5)]


def rounds_to_capture(config: mw.WorldConfig) -> float:
    """Return the capture time: pursuers choose the best cells first, then evaders theirs."""
    solution = solve(config, steps=40)
    won = solution.values[0][:, solution.states.starts] == 1.0
    times = np.where(won.any(axis=0), won.argmax(axis=0), np.inf)
    cells = solution.states.cells()[solution.states.starts, : config.n_pursuers]
    places = np.unique(cells, axis=0, return_inverse=True)[1].ravel()
    return min(times[places == place].max() for place in range(places.max() + 1))


@pytest.mark.parametrize(("rows", "cols"), GRIDS)
def test_two_cops_need_half_the_perimeter(rows: int, cols: int) -> None:
    assert rounds_to_capture(world("TO", rows=rows, cols=cols)) == (rows + cols) // 2 - 1


# Aigner and Fromme 1984, "A game of cops and robbers": three are enough on every planar graph.
def test_three_cops_win_among_obstacles() -> None:
    ground = mw.read_map([".....", ".#.#.", ".....", ".#.#.", "....."])
    times = [
        rounds_to_capture(mw.WorldConfig("TO", obstacles=ground, n_pursuers=n, n_evaders=1))
        for n in (1, 3)
    ]
    assert times[0] == np.inf
    assert times[1] < np.inf


@pytest.mark.parametrize("variant", ["O", "TO"])
def test_no_champion_is_better_than_perfect_play(variant: str) -> None:
    states = States(world(variant))
    solution = solve(states)
    value = solution.value
    kept = [best_response(states, champion, "pursuer").value for champion in CHAMPIONS]
    given = [best_response(states, champion, "evader").value for champion in CHAMPIONS]
    assert max(kept) <= value + 1e-12
    assert min(given) >= value - 1e-12
    # Nor is anything better against perfect play.
    for team in ("pursuer", "evader"):
        assert best_response(states, solution, team).value == pytest.approx(value, abs=1e-9)


def assert_comes_to(config: mw.WorldConfig, pursuers: Any, evaders: Any, expected: float) -> None:
    """Compare a payoff with that of many matches."""
    matches = mw.Matches.of(0, 0, 1)
    found = mw.rollout(config, pursuers, evaders, matches, episodes=5000).capture_rate
    error = 4.5 * found.std() / np.sqrt(found.size) + 1e-3
    assert found.mean() == pytest.approx(expected, abs=error)


@pytest.mark.parametrize("name", ROWS)
def test_a_pair_gets_exactly_what_its_matches_come_to(name: str) -> None:
    config = world(ROWS[name], rows=3, obstacles=np.array(HOLE, bool), max_steps=6)
    states = States(config)
    solution, pursuers = solve(states), random_team(config, 0)
    response = best_response(states, pursuers, "pursuer")
    assert solution.gap < 1e-10
    perfect = solution.policy("pursuer")
    payoff = expected_payoff(states, pursuers, "clumsy-fleer")
    assert_comes_to(config, pursuers, "clumsy-fleer", payoff)
    assert_comes_to(config, pursuers, response.policy("evader"), response.value)
    assert_comes_to(config, perfect, solution.policy("evader"), solution.value)
    assert_comes_to(config, perfect, "random", expected_payoff(states, solution, "random"))


@pytest.mark.parametrize("name", ["O", "TO"])
def test_best_responses_to_networks_that_see_less_are_exact(name: str) -> None:
    config = world(name, obstacles=np.array(HOLE, bool), rows=3, max_steps=6, fov=3)
    champion = random_team(config, 0)
    to_pursuers, to_evaders = (best_response(config, champion, team) for team in TEAMS)
    assert_comes_to(config, champion, to_pursuers.policy("evader"), to_pursuers.value)
    assert_comes_to(config, to_evaders.policy("pursuer"), champion, to_evaders.value)


def test_the_time_to_capture_is_the_sum_over_rounds_of_what_is_free() -> None:
    # With one evader that stays captured, E[min(time, T)] is a sum of escape rates under any play.
    states = States(world())
    pair = {"pursuers": "clumsy-chaser", "evaders": "random"}
    rates = [expected_payoff(states, **pair, steps=t) for t in range(1, 6)]
    time = expected_payoff(states, **pair, steps=6, payoff="capture-time")
    assert time == pytest.approx(1 + sum(1 - rate for rate in rates))
    assert solve(states, steps=6, payoff="capture-time").value <= 6


def test_a_solved_team_plays_in_all_places() -> None:
    config = world(max_steps=6)
    solution = solve(config)
    pursuers, evaders = solution.policy("pursuer"), solution.policy("evader")
    episode = mw.record(config, pursuers, evaders, seed=3)
    world_ = mw.World(config)
    world_.reset(3)
    actions = np.zeros(3, np.int64)
    world_.decide(pursuers, range(1), actions)  # one member alone: the same draw
    world_.decide(pursuers, range(1, 2), actions)
    assert actions[:2].tolist() == episode.actions[0][:2].tolist()
    [solved] = mw.parallel_env(config, evaders="solved").opponents
    assert type(solved) is type(evaders)
    scores = mw.score_policy(pursuers, "pursuer", config, opponents={"perfect": evaders})
    assert scores.mean().value == pytest.approx(solution.value, abs=0.2)


@pytest.mark.parametrize(
    ("refused", "said"),
    [
        (lambda: solve(world(obstacles=0.1)), "expected none or a map"),
        (lambda: solve(world(rows=60, cols=60)), "cells would fit"),
        (lambda: solve(world(), steps=0), "steps"),
        (
            lambda: best_response(world(), random_team(world(), 0, memory="gru"), "pursuer"),
            "without mem",
        ),
        (lambda: best_response(world(fov=3), "hunter", "pursuer"), "hunter"),
        (lambda: best_response(world(), solve(world()), "pursuer"), "the same States"),
        (lambda: longer_reply(solve(world())), "steps: expected 1 to 5, got 9"),
        (lambda: play(world("R")), "expected the world that it was solved for"),
        (lambda: play(world(), swapped=True), "expected to play for its own team"),
    ],
)
def test_what_is_refused(refused: Callable[[], object], said: str) -> None:
    with pytest.raises((TypeError, ValueError), match=said):
        refused()


def longer_reply(champion: Solution) -> Solution:
    return best_response(champion.states, champion, "pursuer", steps=9)


def play(config: mw.WorldConfig, swapped: bool = False) -> object:
    policy = solve(world()).policy("pursuer")
    teams = ("still", policy) if swapped else (policy, "still")
    return mw.record(config, *teams, seed=0)


class SlowSolver:
    """Recursion over the slow reading of the rules, whose agents keep their numbers.

    States are dictionaries, and every game is a linear programme of SciPy.
    """

    def __init__(self, config: mw.WorldConfig) -> None:
        self.config = config
        self.value = cache(self.value)
        self.after: dict[tuple, list[list[tuple]]] = {}

    def mean(self, steps: int) -> float:
        return float(np.mean([self.value(start, 0, steps) for start in self.starts()]))

    def starts(self) -> Iterator[tuple]:
        ground = np.zeros((self.config.rows, self.config.cols), bool)
        ground = ground if self.config.map is None else self.config.map
        free = [tuple(map(int, cell)) for cell in np.argwhere(~ground)]
        for cells in permutations(free, self.config.n_agents):
            yield tuple(enumerate(cells)), frozenset(), frozenset(), frozenset()

    def world(self, state: tuple) -> ReferenceWorld:
        where, ever, taken, now = state
        world = ReferenceWorld(self.config)
        cells = [(0, 0)] * self.config.n_agents
        n = self.config.n_pursuers
        world.place(cells[:n], cells[n:], self.config.map)
        world.where, world.been = dict(where), dict(where)
        world.ever, world.taken, world.now = set(ever), set(taken), {e: {0} for e in now}
        return world

    def moment(self, world: ReferenceWorld) -> tuple:
        sets = (frozenset(each) for each in (world.ever, world.taken, world.now))
        return (tuple(sorted(world.where.items())), *sets)

    def value(self, state: tuple, turn: int, steps: int) -> float:
        """What the pursuers get from a moment before a turn, with so many rounds left."""
        world = self.world(state)
        if world.has_ended() or steps == 0:
            surround = self.config.rules.capture is mw.Capture.SURROUND
            captured = set(world.now) | world.taken if surround else world.ever
            return len(captured) / self.config.n_evaders
        turns = list(world.turns())
        last = turn + 1 == len(turns)
        following = (turn + 1) % len(turns), steps - last
        table = self.successors(state, turn)
        return game_value(np.array([[self.value(s, *following) for s in row] for row in table]))

    def successors(self, state: tuple, turn: int) -> list[list[tuple]]:
        """What follows each joint action of pursuers (rows) and evaders (columns)."""
        if (state, turn) not in self.after:
            world = self.world(state)
            number, agents = list(world.turns())[turn]
            teams = [[a for a in agents if (a in world.evaders) == evaders] for evaders in (0, 1)]
            moves = [list(product(range(self.config.n_actions), repeat=len(t))) for t in teams]
            actors = teams[0] + teams[1]
            self.after[state, turn] = [
                [
                    self.play(world, number, dict(zip(actors, mine + theirs, strict=True)))
                    for theirs in moves[1]
                ]
                for mine in moves[0]
            ]
        return self.after[state, turn]

    def play(self, world: ReferenceWorld, number: int, actions: dict[int, int]) -> tuple:
        world = copy(world)
        world.where, world.ever, world.taken = dict(world.where), set(world.ever), set(world.taken)
        acting = {a for a in actions if a in world.where}
        if acting:
            world.begin_round()
            world.play(number, acting, actions)
        return self.moment(world)


def game_value(matrix: np.ndarray) -> float:
    """The value of a matrix game for the player of the rows."""
    n_rows, n_cols = matrix.shape
    low, high = matrix.min(axis=1).max(), matrix.max(axis=0).min()
    if low == high:  # most games; the rest takes long
        return float(low)
    solved = linprog(
        [*np.zeros(n_rows), -1.0],
        A_ub=np.hstack([-matrix.T, np.ones((n_cols, 1))]),
        b_ub=np.zeros(n_cols),
        A_eq=[[*np.ones(n_rows), 0.0]],
        b_eq=[1.0],
        bounds=[(0, None)] * n_rows + [(None, None)],
    )
    return -solved.fun


TABLES = list(product((D, R, B), repeat=3))  # of a teammate, an evader and a pursuer
STEPS = 3


def assert_same_values(config: mw.WorldConfig, steps: int) -> None:
    solution, slow = solve(config, steps=steps), SlowSolver(config)
    expected = [slow.mean(n) for n in range(steps + 1)]
    found = list(solution.means) + [solution.value] * (steps + 1 - len(solution.means))
    np.testing.assert_allclose(found, expected, atol=1e-8)


def on_ring(rules: mw.Rules, rows: int = 3, **changes: int) -> mw.WorldConfig:
    ground = np.array([[0, 0, 0], [0, 1, 0], [0, 0, 0]][:rows], bool)
    if not rules.captures:
        rules = replace(rules, capture=SURROUND)
    return world(rules, rows=rows, cols=3, obstacles=ground, **changes)


@pytest.mark.slow
@quickly("number", range(len(TABLES)), lambda number: number == 13)
def test_all_tables_of_collisions_on_3_x_3(number: int) -> None:
    teammate, evader, pursuer = TABLES[number]
    obstacle = (D, R, B)[number % 3]
    assert_same_values(
        on_ring(mw.Rules(TOGETHER, obstacle, teammate, evader, pursuer, OCCUPATION)), STEPS
    )


@pytest.mark.slow
@quickly("name", CUSTOM, lambda name: name == "swarm-SD")
def test_rules_with_turns(name: str) -> None:
    assert_same_values(on_ring(CUSTOM[name]), STEPS)


@pytest.mark.parametrize("rules", ["O", "swarm-SD", "agents-D"])
def test_two_evaders_as_the_slow_reading(rules: str) -> None:
    row = CUSTOM[rules] if rules in CUSTOM else mw.VARIANTS[rules]
    assert_same_values(on_ring(row, rows=2, n_pursuers=1, n_evaders=2), 2)


def test_a_long_call_stops_at_a_signal_and_tells_its_share() -> None:
    """In the middle of one call of the engine, on one thread, after half a second of its time."""

    def stop(*_: Any) -> None:
        raise TimeoutError

    told: dict[str, list[float]] = {}

    def tell(what: str, share: float) -> None:
        told.setdefault(what, []).append(share)

    def states(size: int) -> States:
        config = mw.WorldConfig("O", rows=size, cols=size, n_pursuers=2, n_evaders=1)
        return States(config, threads=1, report=tell)

    before, began = signal.signal(signal.SIGVTALRM, stop), time.process_time()
    try:
        signal.setitimer(signal.ITIMER_VIRTUAL, 0.5)
        with pytest.raises(TimeoutError):
            states(9)
        assert time.process_time() - began < 1.5
    finally:
        signal.setitimer(signal.ITIMER_VIRTUAL, 0.0)
        signal.signal(signal.SIGVTALRM, before)
    assert 0.0 < told["states"][-1] < 0.5
    solution = solve(states(4), steps=5)
    best_response(solution.states, "chaser", "pursuer", steps=5)
    for what in ("perfect play", "best responses"):
        assert told[what] == [0.0, 0.2, 0.4, 0.6, 0.8]
