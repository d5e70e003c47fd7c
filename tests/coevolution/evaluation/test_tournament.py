"""Tournaments in rows, which an executor plays anywhere, are equal to those of one process."""

import multiprocessing
from concurrent.futures import Executor, Future, ProcessPoolExecutor, ThreadPoolExecutor

import pytest

from executors import Reversed
from matrixworld.coevolution import tournament
from matrixworld.world.policy import Population
from tiny_race import tiny_race

SETTINGS = tiny_race()


def population(team, count):
    return Population(SETTINGS.task(team).genomes(count), SETTINGS.evaluation_game.policy)


def played(pursuers=None, **options):
    """Return the payoff of a small tournament, as bytes by name."""
    sides = pursuers or population("pursuer", 7), population("evader", 5)
    world = SETTINGS.world
    # Not (0, 0), so that the seeds show which generations play.
    payoff = tournament(world, *sides, seed=3, episodes=4, generations=(2, 1), **options)
    return {
        name: (each.dtype, each.shape, each.tobytes()) for name, each in payoff.arrays().items()
    }


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
