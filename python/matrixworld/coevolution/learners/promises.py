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

from matrixworld._util.checks import check_instance, check_integer, shown
from matrixworld._util.plugins import PluginError, no_exit
from matrixworld.coevolution import states
from matrixworld.coevolution.games.game import Game
from matrixworld.coevolution.learners.learner import Learner, Results, Task, check_genomes
from matrixworld.coevolution.opponents import Opponents
from matrixworld.coevolution.states import State
from matrixworld.coevolution.types import TEAMS, FloatArray, Genomes

EPOCHS = 6  # of a check
SAVED_AFTER = 2  # epochs before the state from which a check goes on as from a file
GENES = 140  # length of the genomes of a check
# Genomes far apart, so that mutants of any usual size are better now and then: a learner shows what
# it does only where it moves.
OF_VECTORS = Game(lambda a, b, rng: np.full(len(a), 0.5), GENES, ("learners", "others"))
OF_TEXTS = Game(
    lambda one, other, rng: 0.5,
    teams=("learners", "others"),
    initial=lambda rng: [*rng.standard_normal(GENES)],
    mutate=lambda genome, rng: [*(np.array(genome) + 0.3 * rng.standard_normal(GENES))],
    mate=lambda one, other, rng: [*np.where(rng.random(GENES) < 0.5, one, other)],
)


def _numbers(game: Game, genomes: Genomes) -> FloatArray:
    """Return what genomes (n, ...) of one of the games above are, (n, GENES) float64."""
    if not game.texts:
        return np.asarray(genomes, np.float64)
    return np.array([game.operators[TEAMS[0]].genome(text) for text in genomes[:, 0].tolist()])


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
    if not learner.any_game:
        got = type(learner).__name__
        raise ValueError(f"learner: expected one that learns in any game (any_game), got {got}")
    game = OF_TEXTS if learner.texts else OF_VECTORS
    if game.texts:
        learner = replace(learner, operators=game.operators[TEAMS[0]])
    n = learner.population
    genes = game.genome_size(TEAMS[0])
    untrained = partial(learner.untrained, game, TEAMS[0])
    _expect_genomes("untrained", untrained(np.random.default_rng(0)), (genes,), game)
    task = Task(0, 0, EPOCHS, untrained, None, game)
    target = game.untrained(TEAMS[0], np.random.default_rng(1))[np.newaxis]
    groups = np.array(learner.seed_groups)
    numbers, sizes = np.unique(groups, return_counts=True)
    are_numbers = groups.shape == (n,) and groups.dtype.kind in "iu"
    if not are_numbers or len(set(sizes)) != 1 or not 0 <= numbers[0] <= numbers[-1] < n:
        expected = f"{n} numbers of groups from 0, all of one size"
        raise PluginError(f"seed_groups: expected {expected}, got {groups}")

    def step(state: State, epoch: int) -> tuple[list[NDArray[Any]], State]:
        candidates, asked = learner.ask(state, np.random.default_rng([0, epoch]))
        _expect_genomes("ask", candidates, (n, genes), game)
        # Equal values are usual at the start of a race, and a learner may then take another path.
        distance = ((_numbers(game, candidates) - _numbers(game, target)) ** 2).mean(axis=1)
        after = learner.tell(asked, Results(np.zeros(n) if epoch % 3 == 1 else -distance))
        genome = learner.genome(after)
        _expect_genomes("genome", genome, (genes,), game)
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
        most = min(count, available)
        chosen = sampler.sample(state, available, count, epoch, rng)
        if not _are_opponents(chosen, most, available):
            expected = f"1 to {most} different opponents from 0 to {available - 1}"
            raise PluginError(f"sample: expected {expected}, got {chosen}")
        return [chosen.copy()], sampler.tell(state, chosen, rng.random((4, len(chosen))))

    _check_steps(sampler.start, step)


def _are_opponents(chosen: Any, most: int, available: int) -> bool:
    """Return whether what a sampler has chosen are different opponents, and not too many."""
    if not isinstance(chosen, np.ndarray) or chosen.dtype.kind not in "iu" or chosen.ndim != 1:
        return False
    different = set(chosen.tolist()) & set(range(available))
    return len(different) == len(chosen) and 1 <= len(chosen) <= most


def _expect_genomes(name: str, array: Any, shape: tuple[int, ...], game: Game) -> None:
    check_genomes(name, array, shape, texts=game.texts)
    if not game.texts and not np.isfinite(array).all():
        raise PluginError(f"{name}: expected finite numbers, got {array}")


def _check_steps(start: Callable[[], State], step: Step) -> None:
    """Check that epochs repeat, that states stay as they were, and that files can hold them."""
    visited = [start()]
    copies = []
    decisions = []
    for epoch in range(EPOCHS):
        copies.append(_from_file(visited[-1]))
        decided, state = step(visited[-1], epoch)
        # Also what was decided: a learner may go on in arrays that it has returned.
        decisions.append(deepcopy(decided))
        visited.append(state)
    if not all(map(_equal, visited, copies)):
        raise PluginError(
            "state: expected arrays that stay as they were, got some that change afterwards"
        )
    beginnings = (
        (0, start(), "from equal generators"),
        (SAVED_AFTER, copies[SAVED_AFTER], "from a saved state"),
    )
    for first, state, when in beginnings:
        for epoch in range(first, EPOCHS):
            decided, state = step(state, epoch)
            if not all(map(np.array_equal, decided, decisions[epoch])):
                raise PluginError(
                    f"expected equal results {when}, got others in epoch {epoch}; random numbers "
                    f"must come from the generator that is passed, and the state must hold all "
                    f"that changes"
                )


def _equal(one: State, other: State) -> bool:
    first = states.flat(one)
    second = states.flat(other)
    return first.keys() == second.keys() and all(
        np.array_equal(first[name], second[name]) for name in first
    )


def _from_file(state: Any) -> State:
    """Return a state as it comes back from a file."""
    if not isinstance(state, dict) and not states.is_tuple(state):
        raise PluginError(f"state: expected a dict or named tuple of arrays, got {shown(state)}")
    for name in state if isinstance(state, dict) else state._fields:
        # A checkpoint holds the arrays of all parts of a run, by path.
        if not name.isidentifier():
            raise PluginError(f"state: expected names such as sigma, got {name!r}")
    arrays = states.flat(state)
    for path, value in arrays.items():
        if not isinstance(value, np.ndarray) or value.dtype.hasobject:
            expected = f"an array of numbers or text as {path}"
            raise PluginError(f"state: expected {expected}, got {shown(value)}")
    buffer = io.BytesIO()
    np.savez(buffer, **arrays)  # type: ignore[arg-type]
    buffer.seek(0)
    with np.load(buffer, allow_pickle=False) as loaded:
        return states.restored(state, {name: loaded[name] for name in loaded.files})
