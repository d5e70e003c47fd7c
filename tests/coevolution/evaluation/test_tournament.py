"""Tournaments in blocks, which an executor plays anywhere, are equal to those of one process."""

import multiprocessing
from concurrent.futures import Executor, Future, ProcessPoolExecutor, ThreadPoolExecutor
from dataclasses import replace

import numpy as np
import pytest

from executors import Reversed
from matrixworld.coevolution import tournament
from matrixworld.coevolution.evaluation.tournament import Pairs
from matrixworld.play.rollout import rollout
from matrixworld.world.policy import Population
from tiny_race import tiny_race

SETTINGS = tiny_race()


def population(team, count):
    """Return so many different genomes."""
    return Population(SETTINGS.untrained(team, count), SETTINGS.network)


def played(pursuers=None, **options):
    """Return the payoff of a small tournament, as bytes by name."""
    sides = pursuers or population("pursuer", 7), population("evader", 5)
    world = SETTINGS.world
    # Not (0, 0), so that the seeds show which generations play.
    payoff = tournament(world, *sides, seed=3, episodes=4, first=(2, 1), **options)
    return {
        name: (array.dtype, array.shape, array.tobytes()) for name, array in payoff.arrays().items()
    }


# Below, at and above rows of 5, columns of 7, and all 35.
@pytest.mark.parametrize("pairs", [1, 2, 3, 5, 6, 9, 10, 12, 34, 35, 1000])
def test_blocks_of_any_size_give_the_same_bytes(pairs, monkeypatch):
    monkeypatch.setattr(Pairs, "seconds", lambda self: 1.0)
    counts = []
    with ThreadPoolExecutor(2) as executor:
        found = played(executor=executor, block_seconds=pairs, on_row=counts.append)
    assert found == played()
    assert counts == sorted(counts)
    assert counts[-1] == 7 * 5 * 4


def test_the_order_of_the_blocks_does_not_matter(monkeypatch):
    monkeypatch.setattr(Pairs, "seconds", lambda self: 1.0)
    assert played(executor=Reversed(7 * 5), block_seconds=1) == played()


def test_other_processes_and_scripts():
    context = multiprocessing.get_context("spawn")
    with ProcessPoolExecutor(1, mp_context=context) as executor:
        assert played(executor=executor, block_seconds=1e-9) == played()
        one = {"pursuers": "hunter"}
        assert played(executor=executor, **one) == played(**one)


def test_the_measured_block_takes_about_the_time_asked_for():
    sides = population("pursuer", 31), population("evader", 31)
    world, seeds = replace(SETTINGS.world, max_steps=500), np.zeros(31 * 31, np.uint64)
    assert 1e-6 < Pairs.all_of(world, *sides, seeds, 10, rollout).seconds() < 0.1


def test_no_genomes_travel_but_those_that_play():
    sides = population("pursuer", 4), population("evader", 5)
    pairs = Pairs.all_of(SETTINGS.world, *sides, np.arange(20, dtype=np.uint64), 1, rollout)
    part = pairs.part(slice(8, 12))  # pursuer 1 against evaders 3 and 4, pursuer 2 against 0 and 1
    assert np.array_equal(part.pursuers.genomes, sides[0].genomes[1:3])
    assert np.array_equal(part.evaders.genomes, sides[1].genomes[[0, 1, 3, 4]])
    assert part.matches.evader.tolist() == [2, 3, 0, 1]
    assert part.matches.seed.tolist() == [8, 9, 10, 11]


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
        played(executor=Keeps(), block_seconds=1e-9)
    assert len(futures) == 35
    assert all(future.cancelled() for future in futures[:1] + futures[2:])


@pytest.mark.parametrize("bad", [{"executor": 3}, {"block_seconds": 0}, {"block_seconds": -1.0}])
def test_bad_arguments(bad):
    with pytest.raises((TypeError, ValueError), match=next(iter(bad))):
        played(**bad)
