"""Leagues in small worlds: exact results of all pairs, and what a league orders otherwise."""

import numpy as np
import pytest

import league
import league_players
import league_worlds
from matrixworld.coevolution import TEAMS
from matrixworld.solver import States, best_response, expected_payoff, solve

WORLDS = (
    "agents in turns, occupied; 1 v 1; 3 x 4 with walls .#../..../.#..; 4 steps",
    "O; 1 v 2; 3 x 3 with walls #../.../#.#; 3 steps",
    "SB; 2 v 2; 3 x 3 with walls .../#../#.#; 3 steps",
)


@pytest.fixture(scope="module")
def players():
    found = league_players.load(league.PLAYERS)
    return {team: [*found[team].values()][::50] for team in TEAMS}


@pytest.mark.parametrize("name", WORLDS)
def test_all_results_of_a_world_are_those_of_single_pairs(name, players):
    found = league_worlds.played(name, players)
    states = States(league_worlds.config_of(name), threads=1)
    solution = solve(states)
    numbers = [found[f"{team} table"] for team in TEAMS]
    for p, pursuer in enumerate(players["pursuer"]):
        for e, evader in enumerate(players["evader"]):
            expected = expected_payoff(states, pursuer, evader)
            assert found["means"][numbers[0][p], numbers[1][e]] == pytest.approx(expected)
        against = found["pursuer against perfect play"][numbers[0][p]]
        assert against == pytest.approx(expected_payoff(states, pursuer, solution))
        grade = best_response(states, pursuer, "pursuer").value
        assert found["pursuer grade"][numbers[0][p]] == pytest.approx(grade)
    both = np.asarray(found["means"]), np.asarray(found["squares"])
    assert (both[1] <= both[0] + 1e-12).all()
    assert (both[1] >= both[0] ** 2 - 1e-12).all()


@pytest.mark.parametrize("name", WORLDS)
@pytest.mark.parametrize("team", TEAMS)
def test_drawn_results_approach_expected_ones(name, team, players):
    found = {key: np.asarray(value) for key, value in league_worlds.played(name, players).items()}
    kept = {each: np.arange(len(players[each])) for each in TEAMS}
    results = league.Results(found, team, kept)
    opponents, rng = np.arange(results.means.shape[1]), np.random.default_rng(0)
    drawn = results.drawn(opponents, 4000, rng)
    np.testing.assert_allclose(drawn, results.means, atol=0.05)
    once = np.mean([results.drawn(opponents, 1, rng) ** 2 for _ in range(4000)], axis=0)
    np.testing.assert_allclose(once, results.squares, atol=0.05)


def test_ties_of_a_league_count_a_half_and_equal_grades_nothing():
    grades = np.array([0.0, 0.5, 0.5, 1.0])
    assert league.otherwise(grades, grades, fewest=1) == 0.0
    assert league.otherwise(grades, -grades, fewest=1) == 1.0
    assert league.otherwise(grades, np.zeros(4), fewest=1) == 0.5
    assert league.otherwise(grades, np.array([0.0, 2.0, 0.0, 1.0]), fewest=1) == 1.5 / 5
    assert np.isnan(league.otherwise(grades, grades, fewest=6))


def test_worlds_are_drawn_by_their_rule():
    names = league_worlds.draw_worlds()
    assert names == np.load(league.PLAYERS.parent / "numbers.npz")["worlds"].tolist()
    assert all(("in turns" in name) == (place % 2 == 0) for place, name in enumerate(names))
