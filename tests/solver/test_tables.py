"""Functions as tables of small worlds, against the engine's players and against matches."""

import numpy as np
import pytest

import matrixworld as mw
from matrixworld.play import capture_rates
from matrixworld.play.functions import NotExactError, probabilities_of
from matrixworld.solver import States, best_response, expected_payoff, solve, table
from rows import random_team

HOLE = np.array([[0, 0, 0, 0], [0, 1, 0, 0], [0, 0, 0, 0]], bool)
SIZES = {"rows": 3, "cols": 4, "obstacles": HOLE, "n_evaders": 1, "n_pursuers": 2, "max_steps": 4}
OWN = np.random.default_rng(0)
MOVES = np.array([(0, 0), (-1, 0), (0, 1), (1, 0), (0, -1)])


def flees(view, rng):
    """Do as the script fleer does, in plain Python."""
    middle = view.shape[1] // 2
    pursuers = np.argwhere(view[1]) - middle
    if not len(pursuers):
        return rng.integers(5)
    free = [a for a in range(5) if a == 0 or not view[2][tuple(MOVES[a] + middle)]]
    apart = [np.abs(pursuers - MOVES[a]).sum(axis=1).min() for a in free]
    return rng.choice([a for a, far in zip(free, apart, strict=True) if far == max(apart)])


def clumsily_flees(view, rng):
    """Do so in half of the steps."""
    return flees(view, rng) if rng.random() < 0.5 else int(rng.permutation(5)[0])


@pytest.mark.parametrize("variant", ["O", "TO", "D", "R", mw.Rules("agent-turns")])
@pytest.mark.parametrize(
    ("function", "script"), [(flees, "fleer"), (clumsily_flees, "clumsy-fleer")]
)
def test_a_function_has_the_table_of_a_script_that_does_the_same(variant, function, script):
    states = States(mw.WorldConfig(variant, **SIZES, fov=11))
    for found, expected in zip(
        table(states, function, "evader"), table(states, script, "evader"), strict=True
    ):
        ends = states.config.n_evaders + 1
        np.testing.assert_allclose(found[ends:], expected[ends:], atol=1e-12)
    response = best_response(states, function, "evader").value
    assert response == pytest.approx(best_response(states, script, "evader").value, abs=1e-12)


@pytest.mark.parametrize("fov", [3, 11])
@pytest.mark.parametrize("variant", ["S", "TO"])
def test_the_views_are_those_of_worlds(variant, fov):
    config = mw.WorldConfig(variant, **SIZES, fov=fov)
    states = States(config)
    views, places = states.views("pursuer")
    assert len(np.unique(views.reshape(len(views), -1), axis=0)) == len(views)
    world = mw.World(config)
    for state in states.starts[::37]:
        cells = np.stack(np.divmod(states.cells()[state], config.cols), axis=1)
        world.reset(pursuers=cells[:2], evaders=cells[2:])
        np.testing.assert_array_equal(
            views[places[0][state]], world.views()[states.members(0, "pursuer")]
        )


@pytest.mark.parametrize("variant", ["O", "D", "SB", "TO", mw.Rules("swarm-turns")])
def test_functions_of_many_views_and_genomes_as_policies_are_players(variant):
    config = mw.WorldConfig(variant, **SIZES, fov=5)
    states = States(config)
    network = random_team(config, 0)
    policy = mw.NetworkPolicy(network.policy, network.genomes[0], sampled=False)
    ends = config.n_evaders + 1
    tables = (table(states, player, "pursuer") for player in (lambda views: policy(views), policy))
    for found, expected in zip(*tables, strict=True):
        np.testing.assert_array_equal(found[ends:], expected[ends:])
    as_function = best_response(states, lambda views: policy(views), "pursuer").value
    as_policy = best_response(states, policy, "pursuer").value
    assert as_function == pytest.approx(as_policy, abs=1e-12)
    payoff = expected_payoff(states, lambda views: policy(views), "fleer")
    played = capture_rates(config, policy, "fleer", seed=1, episodes=2000)
    assert played.mean() == pytest.approx(payoff, abs=4.5 * played.std() / 2000**0.5 + 1e-3)
    assert as_policy <= solve(states).value + 1e-12


def compares_twice(view, rng):
    drawn = rng.random()
    return 1 if drawn < 0.5 else 2 if drawn < 0.75 else 3


@pytest.mark.parametrize(
    ("function", "chances"),
    [
        (lambda v, rng: rng.integers(1, 4), [0, 1 / 3, 1 / 3, 1 / 3, 0]),
        (lambda v, rng: rng.choice([0, 4], p=[0.25, 0.75]), [0.25, 0, 0, 0, 0.75]),
        (lambda v, rng: rng.choice([0, 9], p=[1, 0]), [1, 0, 0, 0, 0]),
        (lambda v, rng: 1 if np.float64(0.75) > rng.random() else 2, [0, 0.75, 0.25, 0, 0]),
        (lambda v, rng: rng.integers(1, 2, None, np.int8, True), [0, 0.5, 0.5, 0, 0]),
        (compares_twice, [0, 0.5, 0.25, 0.25, 0]),
        (lambda v, rng: 4 if rng.random() >= 0.9 else 0, [0.9, 0, 0, 0, 0.1]),
        (lambda v, rng: int(rng.permutation([3, 4])[0]), [0, 0, 0, 0.5, 0.5]),
    ],
)
def test_all_results_of_draws_are_followed(function, chances):
    views = np.zeros((2, 3, 5, 5), np.uint8)
    np.testing.assert_allclose(probabilities_of(function, views, 5), [chances] * 2, atol=1e-12)


@pytest.mark.parametrize(
    ("function", "error", "said"),
    [
        (lambda v, rng: int(rng.normal()), NotExactError, r"rng\.normal"),
        (lambda v, rng: int(5 * rng.random()), NotExactError, "got arithmetic"),
        (lambda v, rng: rng.integers(10**6) % 5, NotExactError, "at most 5,000 results"),
        (lambda v, rng: max(rng.integers(2) for _ in range(99)), NotExactError, "at most 40"),
        (lambda v, rng: 9, ValueError, "0 to 4, got 9"),
        (lambda v, rng: 0.5, TypeError, "action of the function"),
        (lambda v, rng: 0 if rng.random() < np.ones(2) else 1, NotExactError, "with a number"),
        (lambda v, rng: OWN.integers(5), NotExactError, "other answers for the same views"),
        (lambda v: OWN.integers(5, size=len(v)), NotExactError, "other answers"),
        (lambda v, rng: rng.integers(OWN.integers(1, 9)) % 5, NotExactError, "remembers"),
        (lambda v, rng, memory: 0, TypeError, "remembers"),
        (lambda v: v.sum() + 9, ValueError, "0 to 4"),
    ],
)
def test_what_cannot_be_followed_or_played_is_refused(function, error, said):
    with pytest.raises(error, match=said):
        table(States(mw.WorldConfig("O", **SIZES, fov=5)), function, "pursuer")
