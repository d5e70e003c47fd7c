"""Exact solutions of small worlds, against theory, an own trial and slow computations."""

from __future__ import annotations

import numpy as np
import pytest

import matrixworld as mw
from matrixworld.solve import States, best_response, expected_payoff, nash_conv, solve

CHAMPIONS = ("random", "still", "chaser", "fleer", "clumsy-chaser", "clumsy-fleer", "dodger")


def world(variant: mw.Rules | str = "O", **changes: object) -> mw.WorldConfig:
    sizes = {"rows": 4, "cols": 4, "n_pursuers": 2, "n_evaders": 1, "max_steps": 5}
    return mw.WorldConfig(variant, **{**sizes, **changes})


def test_two_pursuers_on_4_x_4_reach_what_regret_matching_found() -> None:
    solution = solve(world(), steps=10)
    after = [float(row[solution.states.starts].mean()) for row in solution.values[0]]
    assert after[5] == pytest.approx(0.838, abs=0.005)
    assert solution.value == pytest.approx(1.0, abs=1e-12)
    assert solution.gap < 1e-9


# Mehrabian 2011, "The capture time of grids", Discrete Mathematics 311.
GRIDS = [(2, 6), (3, 3), (3, 7), (4, 4), (4, 5), (5, 5), (6, 6)]


@pytest.mark.parametrize(("rows", "cols"), GRIDS)
def test_two_cops_need_half_the_perimeter(rows: int, cols: int) -> None:
    solution = solve(world("TO", rows=rows, cols=cols), steps=1)
    assert solution.capture_time == (rows + cols) // 2 - 1


def test_one_cop_needs_the_diagonals() -> None:
    assert solve(world("TO", n_pursuers=1)).capture_time == np.inf
    assert solve(world("TO", n_pursuers=1, diagonal=True)).capture_time < np.inf


@pytest.mark.parametrize("variant", ["O", "TO"])
def test_no_champion_is_better_than_perfect_play(variant: str) -> None:
    states = States(world(variant))
    value = solve(states).value
    for champion in CHAMPIONS:
        assert best_response(states, champion, "pursuer").value <= value + 1e-12
        assert best_response(states, champion, "evader").value >= value - 1e-12
        for other in CHAMPIONS:
            assert nash_conv(states, champion, other) >= -1e-12


@pytest.mark.parametrize("variant", ["O", "TO"])
def test_nothing_is_better_against_perfect_play_than_perfect_play(variant: str) -> None:
    states = States(world(variant))
    solution = solve(states)
    for team in ("pursuer", "evader"):
        response = best_response(states, solution, team)
        assert response.value == pytest.approx(solution.value, abs=1e-9)
    assert nash_conv(states, solution, solution) == pytest.approx(0.0, abs=1e-9)


def test_a_pair_gets_exactly_what_its_matches_come_to() -> None:
    config = world(max_steps=8)
    states, seen = States(config), mw.Matches.of(0, 0, 1)
    solution = solve(states)
    network = mw.Network.for_config(config)
    genome = network.initial(np.random.default_rng(0), weight=0.5, head=0.5)
    pursuers = mw.Population(genome, network)
    pairs = [
        (pursuers, "clumsy-fleer", expected_payoff(states, pursuers, "clumsy-fleer")),
        (solution.policy("pursuer"), solution.policy("evader"), solution.value),
        (pursuers, best_response(states, pursuers, "pursuer").policy("evader"), None),
    ]
    for one, other, expected in pairs:
        if expected is None:
            expected = best_response(states, pursuers, "pursuer").value
        rates = mw.rollout(config, one, other, seen, episodes=40_000).capture_rate
        error = 4 * np.sqrt(expected * (1 - expected) / rates.size) + 1e-9
        assert rates.mean() == pytest.approx(expected, abs=error)
