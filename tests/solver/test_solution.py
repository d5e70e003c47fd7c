"""Exact solutions of small worlds, against theory, an own trial and slow computations."""

import signal
import time
import warnings
from dataclasses import replace
from itertools import product

import numpy as np
import pytest

import matrixworld as mw
from matrixworld.coevolution import TEAMS
from matrixworld.solver import States, best_response, expected_payoff, solve
from rows import CUSTOM, OCCUPATION, SURROUND, TOGETHER, B, D, R, random_team

ROWS = {**mw.VARIANTS, **CUSTOM}
HOLE = [[0, 0, 0, 0], [0, 1, 0, 0], [0, 0, 0, 0]]
CHAMPIONS = ("random", "still", "chaser", "fleer", "clumsy-chaser", "clumsy-fleer", "dodger")


def world(variant="O", **changes):
    sizes = {"rows": 4, "cols": 4, "n_pursuers": 2, "n_evaders": 1, "max_steps": 5}
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # rules that capture nobody are rules, too
        return mw.WorldConfig(variant, **{**sizes, **changes})


def test_two_pursuers_on_4_x_4_reach_what_regret_matching_found():
    solution = solve(world(), steps=10)
    after = [float(row[solution.states.starts].mean()) for row in solution.values[0]]
    assert after[5] == pytest.approx(0.838, abs=0.005)
    assert solution.value == pytest.approx(1.0, abs=1e-12)
    assert solution.gap < 1e-9


@pytest.mark.parametrize(
    "changes", [{"diagonal": True}, {"n_evaders": 2, "rows": 3}, {"rows": 5, "cols": 6}]
)
def test_strategies_of_large_games_guarantee_the_same(changes):
    """Games of 81 x 9, 25 x 25 and 25 x 5 joint actions, most of them degenerate."""
    assert solve(world(**changes), steps=2).gap < 1e-10


# Mehrabian 2011, "The capture time of grids", Discrete Mathematics 311.
GRIDS = [(2, 6), (3, 3), (3, 7), (4, 5), (5, 5)]


def rounds_to_capture(config):
    """Return the capture time: pursuers choose the best cells first, then evaders theirs."""
    solution = solve(config, steps=40)
    won = solution.values[0][:, solution.states.starts] == 1.0
    times = np.where(won.any(axis=0), won.argmax(axis=0), np.inf)
    cells = solution.states.cells()[solution.states.starts, : config.n_pursuers]
    places = np.unique(cells, axis=0, return_inverse=True)[1].ravel()
    return min(times[places == place].max() for place in range(places.max() + 1))


@pytest.mark.parametrize(("rows", "cols"), GRIDS)
def test_two_cops_need_half_the_perimeter(rows, cols):
    assert rounds_to_capture(world("TO", rows=rows, cols=cols)) == (rows + cols) // 2 - 1


# Aigner and Fromme 1984, "A game of cops and robbers": three are enough on every planar graph.
def test_three_cops_win_among_obstacles():
    ground = mw.read_map([".....", ".#.#.", "....."])
    times = [
        rounds_to_capture(mw.WorldConfig("TO", obstacles=ground, n_pursuers=n, n_evaders=1))
        for n in (1, 3)
    ]
    assert times[0] == np.inf
    assert times[1] < np.inf


@pytest.mark.parametrize("variant", ["O", "TO"])
def test_no_champion_is_better_than_perfect_play(variant):
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


def assert_comes_to(config, pursuers, evaders, expected):
    """Compare a payoff with that of many matches."""
    matches = mw.Matches.of(0, 0, 1)
    found = mw.rollout(config, pursuers, evaders, matches, episodes=3000).capture_rate
    error = 4.5 * found.std() / np.sqrt(found.size) + 1e-3
    assert found.mean() == pytest.approx(expected, abs=error)


@pytest.mark.parametrize("name", ROWS)
def test_a_pair_gets_exactly_what_its_matches_come_to(name):
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
def test_best_responses_to_networks_that_see_less_are_exact(name):
    config = world(name, obstacles=np.array(HOLE, bool), rows=3, max_steps=6, fov=3)
    champion = random_team(config, 0)
    to_pursuers, to_evaders = (best_response(config, champion, team) for team in TEAMS)
    assert_comes_to(config, champion, to_pursuers.policy("evader"), to_pursuers.value)
    assert_comes_to(config, to_evaders.policy("pursuer"), champion, to_evaders.value)


def test_the_time_to_capture_is_the_sum_over_rounds_of_what_is_free():
    # With one evader that stays captured, E[min(time, T)] is a sum of escape rates under any play.
    states = States(world())
    pair = {"pursuers": "clumsy-chaser", "evaders": "random"}
    rates = [expected_payoff(states, **pair, steps=t) for t in range(1, 6)]
    time = expected_payoff(states, **pair, steps=6, payoff="capture-time")
    assert time == pytest.approx(1 + sum(1 - rate for rate in rates))
    assert solve(states, steps=6, payoff="capture-time").value <= 6


def test_a_solved_team_plays_in_all_places():
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
        (lambda: best_response(world(), random_team(world(), 0, memory="gru"), "pursuer"), "mem"),
        (lambda: best_response(world(fov=3), "hunter", "pursuer"), "hunter"),
        (lambda: best_response(world(), solve(world("R")), "pursuer"), "the same States"),
        (lambda: longer_reply(solve(world())), "steps: expected 1 to 5, got 9"),
        (lambda: play(world("R")), "expected the world that it was solved for"),
        (
            lambda: play(world(), swapped=True),
            "table: expected one of evaders, got one of pursuers",
        ),
    ],
)
def test_what_is_refused(refused, said):
    with pytest.raises((TypeError, ValueError), match=said):
        refused()


def longer_reply(champion):
    return best_response(champion.states, champion, "pursuer", steps=9)


def play(config, swapped=False):
    policy = solve(world()).policy("pursuer")
    teams = ("still", policy) if swapped else (policy, "still")
    return mw.record(config, *teams, seed=0)


def on_ring(rules, rows=3, **changes):
    ground = np.array([[0, 0, 0], [0, 1, 0], [0, 0, 0]][:rows], bool)
    if not rules.captures:
        rules = replace(rules, capture=SURROUND)
    return world(rules, rows=rows, cols=3, obstacles=ground, **changes)


GAMES = [
    *(on_ring(mw.Rules(TOGETHER, (D, R, B)[number % 3], *outcomes, OCCUPATION))
      for number, outcomes in enumerate(product((D, R, B), repeat=3))),
    *map(on_ring, CUSTOM.values()),
    *(on_ring(ROWS[name], rows=2, n_pursuers=1, n_evaders=2)
      for name in ("O", "swarm-SD", "agents-D")),
]  # fmt: skip
"""All outcomes of meetings on a ring of eight cells, other rules, and two evaders."""
VALUES = [
    (0, 0, 0), (0.0952381, 0.3333333, 0.8100529), (0.1428571, 0.4761905, 1), (0, 0, 0),
    (0.0952381, 0.3333333, 0.8100529), (0.1428571, 0.2857143, 0.5238095), (0, 0, 0),
    (0.0952381, 0.1428571, 0.1428571), (0.0952381, 0.1904762, 0.3571429), (0, 0, 0),
    (0.0952381, 0.3333333, 0.8148148), (0.1428571, 0.4761905, 1), (0, 0, 0),
    (0.0952381, 0.3333333, 0.8148148), (0.1428571, 0.2857143, 0.5238095), (0, 0, 0),
    (0.0952381, 0.1428571, 0.1428571), (0.0952381, 0.1904762, 0.3571429), (0, 0, 0),
    (0.0952381, 0.3333333, 0.8100529), (0.1428571, 0.4761905, 1), (0, 0, 0),
    (0.0952381, 0.3333333, 0.8100529), (0.1428571, 0.2857143, 0.5238095), (0, 0, 0),
    (0.0952381, 0.1428571, 0.1428571), (0.0952381, 0.1904762, 0.3571429),
    (0.5238095, 0.5238095, 0.5238095), (0.5238095, 0.7142857, 1), (0.1904762, 0.3809524, 0.6190476),
    (0.1904762, 0.2857143, 0.3809524), (0.5238095, 0.5238095, 0.5238095), (0.5238095, 0.7142857, 1),
    (0.1904762, 0.3809524, 0.6190476), (0.1904762, 0.2857143, 0.3809524),
    (0.0952381, 0.3333333, 0.8100529), (0.015873, 0.015873, 0.015873), (0, 0, 0),
    (0.1904762, 0.3809524, 0.6190476),
    (0.1, 0.2333333), (0.15, 0.15), (0.35, 0.35),
]  # fmt: skip
"""Values of one, two and three rounds. A recursion over the slow reading of the rules with a linear
programme of SciPy for each state, which stood here at commit 8e1a8000, has found them."""


def test_values_are_those_of_a_slow_solver():
    for config, expected in zip(GAMES, VALUES, strict=True):
        solution = solve(config, steps=len(expected))
        means = [*solution.means, *[solution.value] * len(expected)]  # fewer where play has ended
        np.testing.assert_allclose(means[1 : 1 + len(expected)], expected, atol=1e-7)


def test_a_long_call_stops_at_a_signal_and_tells_its_share():
    """In the middle of one call of the engine, on one thread, after half a second of its time."""

    def stop(*_):
        raise TimeoutError

    told = {}

    def tell(what, share):
        told.setdefault(what, []).append(share)

    def states(size):
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
