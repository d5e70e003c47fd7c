"""Checks of a learner or opponent sampler of one's own: run them before the first race."""

from __future__ import annotations

import io
from collections.abc import Callable, Mapping
from typing import Any, TypeVar

import numpy as np

from matrixworld.coevolution.own_code import (
    LEARNER,
    OPPONENT,
    CheckedLearner,
    CheckedSampler,
    PluginError,
    plugin_of,
)
from matrixworld.coevolution.sections import own_settings
from matrixworld.coevolution.types import FloatArray, Genomes, State

Part = TypeVar("Part", CheckedLearner, CheckedSampler)
Step = Callable[[Part, int], list[np.ndarray[Any, Any]]]
"""Plays one epoch with a part of a run, and returns copies of what the part decided."""

EPOCHS = 6
"""Epochs of a check; states are restored at the end of each."""


def check_learner(
    learner: str | Callable[..., Any],
    settings: Mapping[str, Any] | None = None,
    *,
    samples: int = 8,
    genes: int = 20,
    seed: int = 0,
) -> None:
    """Check that a learner of one's own has the interface `Learner` and keeps its promises.

    Shapes, dtypes and names; equal results from equal generators; a state that, written to a file
    and restored in a new or in a used learner, continues bit for bit. In some epochs all fitness
    values are equal.

    Parameters
    ----------
    learner : str or callable
        A class, a function that returns a learner, or its name as in the settings.
    settings : mapping of str to bool, int, float or str, optional
        Settings of its own.
    samples, genes : int, optional
        Candidates per epoch, and genes of a candidate.
    seed : int, optional
        Seed of genomes, generators and fitness.

    Raises
    ------
    PluginError
        If a check fails; the message says which.
    ValueError
        If the learner cannot be imported, or refuses its settings.

    Examples
    --------
    >>> from matrixworld import coevolution
    >>> coevolution.check_learner(coevolution.CmaEs, {"sigma": 0.1})
    """
    plugin = plugin_of(learner, LEARNER)
    genomes, target = np.random.default_rng(seed).normal(size=(2, samples, genes))
    own = own_settings("settings", settings or {})

    def new() -> CheckedLearner:
        rng = np.random.default_rng([seed, EPOCHS])
        return CheckedLearner(
            plugin,
            genomes.astype(np.float32),
            rng,
            samples=samples,
            epochs=EPOCHS,
            settings=own,
        )

    def step(part: CheckedLearner, epoch: int) -> list[np.ndarray[Any, Any]]:
        candidates = part.ask(np.random.default_rng([seed, epoch])).copy()
        part.tell(_fitness(candidates, target[0], epoch))
        return [candidates, part.genome.copy()]

    _check_part(new, step)
    _check_groups(new(), step)


def check_sampler(
    sampler: str | Callable[..., Any],
    settings: Mapping[str, Any] | None = None,
    *,
    count: int = 2,
    seed: int = 0,
) -> None:
    """Check that a sampler of one's own has the interface `OpponentSampler` and keeps its promises.

    As `check_learner`: numbers in range and without repetition; equal results from equal
    generators; a state that continues bit for bit.

    Parameters
    ----------
    sampler : str or callable
        A class, a function that returns a sampler, or its name as in the settings.
    settings : mapping of str to bool, int, float or str, optional
        Settings of its own.
    count : int, optional
        Opponents an epoch.
    seed : int, optional
        Seed of generators and scores.

    Raises
    ------
    PluginError
        If a check fails; the message says which.
    ValueError
        If the sampler cannot be imported, or refuses its settings.

    Examples
    --------
    >>> from matrixworld import coevolution
    >>> coevolution.check_sampler(coevolution.opponents.Prioritized, {"decay": 0.9})
    """
    plugin = plugin_of(sampler, OPPONENT)
    own = own_settings("settings", settings or {})

    def new() -> CheckedSampler:
        return CheckedSampler(plugin, count, own)

    def step(part: CheckedSampler, epoch: int) -> list[np.ndarray[Any, Any]]:
        rng = np.random.default_rng([seed, epoch])
        # Several epochs with the same opponents, then one more, as in a race.
        chosen = part.sample(1 + epoch // 2, epoch, rng)
        part.tell(chosen, rng.random((4, len(chosen))))
        return [chosen]

    _check_part(new, step)


def _fitness(candidates: Genomes, target: FloatArray, epoch: int) -> FloatArray:
    """Return a fitness (n,) that is higher near a target; all values are equal in some epochs."""
    # Equal values are usual at the start of a race, and a learner may then take another path.
    if epoch % 3 == 1:
        return np.zeros(len(candidates))
    distance: FloatArray = ((candidates - target) ** 2).mean(axis=1)
    return -distance


def _check_part(new: Callable[[], Part], step: Step[Part]) -> None:
    """Check that results repeat, and that states restore them."""
    first = new()
    expected, states = [], [_saved(first)]
    for epoch in range(EPOCHS):
        expected.append(step(first, epoch))
        states.append(_saved(first))
    _check_equal(first.title, step, new(), 0, expected, "from equal generators and results")
    for epoch, state in enumerate(states):
        # `first` has gone further: a run that is interrupted restores its learners in place.
        for part, which in ((new(), "new"), (first, "used")):
            part.restore(_copied(state))
            when = f"after restore in a {which} one"
            if not _same(state, _saved(part)):
                raise PluginError(f"{part.title}: state: expected an equal one {when}, got another")
            _check_equal(part.title, step, part, epoch, expected, when)


def _check_equal(
    title: str, step: Step[Part], part: Part, start: int, expected: list[Any], when: str
) -> None:
    for epoch in range(start, EPOCHS):
        found = step(part, epoch)
        same = (np.array_equal(a, b) for a, b in zip(found, expected[epoch], strict=True))
        if not all(same):
            raise PluginError(
                f"{title}: expected equal results {when}, got others in epoch {epoch}; random "
                f"numbers must come from the generator that is passed, and state() must return "
                f"all that changes"
            )


def _check_groups(learner: CheckedLearner, step: Step[CheckedLearner]) -> None:
    """Check that the groups of candidates are equal in all epochs."""
    groups = learner.seed_groups.copy()
    for epoch in range(EPOCHS):
        step(learner, epoch)
        if not np.array_equal(learner.seed_groups, groups):
            raise PluginError(
                f"{learner.title}: seed_groups: expected equal groups in all epochs, got "
                f"others after epoch {epoch}"
            )


def _saved(part: CheckedLearner | CheckedSampler) -> State:
    """Return the state of a part as it comes back from a file."""
    buffer = io.BytesIO()
    np.savez(buffer, **part.state())  # type: ignore[arg-type]
    buffer.seek(0)
    with np.load(buffer, allow_pickle=False) as arrays:
        return {name: arrays[name] for name in arrays.files}


def _copied(state: State) -> State:
    return {name: array.copy() for name, array in state.items()}


def _same(state: State, other: State) -> bool:
    return state.keys() == other.keys() and all(
        np.array_equal(array, other[name]) for name, array in state.items()
    )
