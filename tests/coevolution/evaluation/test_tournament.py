"""Tournaments in rows, which an executor plays anywhere, are equal to those of one process."""

import multiprocessing
from concurrent.futures import Executor, Future, ProcessPoolExecutor, ThreadPoolExecutor

import numpy as np
import pytest

from executors import Reversed
from matrixworld.coevolution import tournament
from matrixworld.world.policy import Population
from own_games import numbers
from tiny_race import tiny_race

SETTINGS = tiny_race()
ONES = np.ones((4, 5), np.float32)


def population(team, count):
    return Population(SETTINGS.task(team).genomes(count), SETTINGS.evaluation_game.policies[team])


def played(pursuers=None, **options):
    """Return the payoff of a small tournament, as bytes by name."""
    sides = pursuers or population("pursuer", 7), population("evader", 5)
    world = SETTINGS.game.world
    # Not (0, 0), so that the seeds show which generations play.
    payoff = tournament(world, *sides, seed=3, episodes=4, generations=(2, 1), **options)
    return {
        name: (each.dtype, each.shape, each.tobytes()) for name, each in payoff.arrays().items()
    }


def test_a_team_without_members_is_refused():
    teams = numbers.population("pursuer", np.zeros((0, 5))), numbers.population("evader", ONES)
    for sides, shape in ((teams, r"\(0, 4\)"), (teams[::-1], r"\(4, 0\)")):
        with pytest.raises(ValueError, match=f"^tournament: expected members .*, got {shape}"):
            tournament(numbers, *sides, seed=3, episodes=4)


def test_a_payoff_is_an_array_of_new_means_and_compared_as_an_object():
    teams = population("pursuer", 2), population("evader", 3)
    payoff = tournament(SETTINGS.game.world, *teams, seed=3, episodes=4)
    assert np.array_equal(np.asarray(payoff), payoff.matrix)
    assert np.asarray(payoff, np.float32).dtype == np.float32
    assert payoff == payoff in {payoff}
    with pytest.raises(ValueError, match="^copy: expected True or None"):
        payoff.__array__(copy=False)


@pytest.mark.parametrize("executor", [ThreadPoolExecutor(2), Reversed(7)])
def test_rows_in_any_order_give_the_same_bytes(executor):
    counts = []
    assert played(executor=executor, report=lambda now: counts.append(now.done)) == played()
    assert counts == [20 * row for row in range(8)]


def test_other_processes_and_scripts():
    context = multiprocessing.get_context("spawn")
    with ProcessPoolExecutor(1, mp_context=context) as executor:
        assert played(executor=executor) == played()
        one = {"pursuers": "hunter"}
        assert played(executor=executor, **one) == played(**one)


def test_an_error_of_a_block_is_raised_and_the_others_are_cancelled():
    futures = []

    class Keeps(Executor):
        def submit(self, fn, /, *args, **kwargs):
            future = Future()
            futures.append(future)
            if len(futures) == 2:
                future.set_exception(ZeroDivisionError("no luck"))
            return future

    with pytest.raises(ZeroDivisionError, match="no luck"):
        played(executor=Keeps())
    assert len(futures) == 7
    assert all(future.cancelled() for future in futures[:1] + futures[2:])
