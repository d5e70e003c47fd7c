"""Checks of learners and opponent samplers of your own, before the first run."""

from __future__ import annotations

import io
from collections.abc import Callable
from copy import deepcopy
from dataclasses import replace
from functools import partial
from typing import Any

import numpy as np
from numpy.typing import NDArray

from matrixworld._util.checks import check_instance, check_integer, expect
from matrixworld.coevolution.game import Game
from matrixworld.coevolution.learners.learner import Learner, Results, Task, check_genomes
from matrixworld.coevolution.opponents import Opponents
from matrixworld.coevolution.sections import PluginError, filled, no_exit
from matrixworld.coevolution.types import TEAMS, State

EPOCHS, GENES = 6, 140  # epochs of a check, and length of its genomes
Step = Callable[[State, int], tuple[list[NDArray[Any]], State]]
"""Plays one epoch from a state; returns what was decided, and the next state."""


@no_exit("check_learner")
def check_learner(learner: Learner) -> None:
    """Check that a `learner` of your own keeps the promises of its base `Learner`.

    Shapes and dtypes; equal results from equal generators; a state that does not change when the
    next one is made, and that continues bit for bit from a file. PluginError says what fails; an
    error in the learner's own code is raised as it is.

    Examples
    --------
    >>> from matrixworld import coevolution
    >>> coevolution.check_learner(coevolution.EvolutionStrategy(sigma=0.2, population=8))
    """
    check_instance("learner", learner, Learner)
    # Genomes far apart, so that mutants of any usual size are better now and then: a learner shows
    # what it does only where it moves.
    game = Game(lambda a, b, rng: np.full(len(a), 0.5), GENES, ("learners", "others"))
    n = learner.population or 8
    learner = replace(filled(learner, {}, "learner"), population=n)
    untrained = partial(game.untrained, TEAMS[0])
    task = Task(0, 0, EPOCHS, untrained, None, game)
    target = untrained(np.random.default_rng(1))
    groups = np.array(learner.seed_groups)
    numbers, sizes = np.unique(groups, return_counts=True)
    kept = groups.shape == (n,) and groups.dtype.kind in "iu" and len(set(sizes)) == 1
    kept = kept and 0 <= numbers[0] <= numbers[-1] < n
    expected = f"{n} numbers of groups from 0, all of one size"
    expect(kept, "seed_groups", expected, groups, PluginError)

    def step(state: State, epoch: int) -> tuple[list[NDArray[Any]], State]:
        candidates, asked = learner.ask(state, np.random.default_rng([0, epoch]))
        _expect_genomes("ask", candidates, (n, GENES))
        # Equal values are usual at the start of a race, and a learner may then take another path.
        distance = ((candidates - target) ** 2).mean(axis=1, dtype=np.float64)
        after = learner.tell(asked, Results(np.zeros(n) if epoch % 3 == 1 else -distance))
        genome = learner.genome(after)
        _expect_genomes("genome", genome, (GENES,))
        return [candidates, genome], after

    _check_steps(lambda: learner.start(task), step)


@no_exit("check_sampler")
def check_sampler(sampler: Opponents, *, count: int = 2) -> None:
    """Check that a `sampler` of your own keeps the promises of its base `Opponents`.

    Numbers of `count` opponents an epoch, in range and without repetition; else as `check_learner`.

    Examples
    --------
    >>> from matrixworld import coevolution
    >>> coevolution.check_sampler(coevolution.opponents.Prioritized(decay=0.9))
    """
    check_instance("sampler", sampler, Opponents)
    check_integer("count", count, 1)

    def step(state: State, epoch: int) -> tuple[list[NDArray[Any]], State]:
        rng = np.random.default_rng([0, epoch])
        # Several epochs with the same opponents, then one more, as in a race.
        available = 1 + epoch // 2
        most, chosen = min(count, available), sampler.sample(state, available, count, epoch, rng)
        kept = isinstance(chosen, np.ndarray) and chosen.dtype.kind in "iu" and chosen.ndim == 1
        kept = kept and len({*chosen.tolist()} & {*range(available)}) == len(chosen)
        expected = f"1 to {most} different opponents from 0 to {available - 1}"
        expect(kept and 1 <= len(chosen) <= most, "sample", expected, chosen, PluginError)
        return [chosen.copy()], sampler.tell(state, chosen, rng.random((4, len(chosen))))

    _check_steps(sampler.start, step)


def _expect_genomes(name: str, array: Any, shape: tuple[int, ...]) -> None:
    check_genomes(name, array, shape)
    expect(np.isfinite(array).all(), name, "finite numbers", array, PluginError)


def _check_steps(start: Callable[[], State], step: Step) -> None:
    """Check that epochs repeat, that states stay as they were, and that files can hold them."""
    states, copies, decisions = [start()], [], []
    for epoch in range(EPOCHS):
        copies.append(_from_file(states[-1]))
        decided, state = step(states[-1], epoch)
        # Also what was decided: a learner may go on in arrays that it has returned.
        decisions.append(deepcopy(decided))
        states.append(state)
    stay, got = all(map(_equal, states, copies)), "some that change afterwards"
    expect(stay, "state", "arrays that stay as they were", got, PluginError)
    again = start()
    for state, when in ((again, "from equal generators"), (copies[2], "from a saved state")):
        first = 0 if state is again else 2
        for epoch in range(first, EPOCHS):
            decided, state = step(state, epoch)
            if not all(map(np.array_equal, decided, decisions[epoch])):
                raise PluginError(
                    f"expected equal results {when}, got others in epoch {epoch}; random numbers "
                    f"must come from the generator that is passed, and the state must hold all "
                    f"that changes"
                )


def _equal(one: State, other: State) -> bool:
    return one.keys() == other.keys() and all(np.array_equal(one[n], other[n]) for n in one)


def _from_file(state: Any) -> State:
    """Return a state as it comes back from a file."""
    expect(isinstance(state, dict), "state", "a dict of arrays", state, PluginError)
    for name, value in state.items():
        # A checkpoint holds the arrays of all parts of a run, as part.name.
        expect(name.isidentifier(), "state", "names such as sigma", repr(name), PluginError)
        is_plain = isinstance(value, np.ndarray) and not value.dtype.hasobject
        expect(is_plain, "state", f"an array of numbers or text as {name}", value, PluginError)
    buffer = io.BytesIO()
    np.savez(buffer, **state)
    buffer.seek(0)
    with np.load(buffer, allow_pickle=False) as arrays:
        return {name: arrays[name] for name in arrays.files}
