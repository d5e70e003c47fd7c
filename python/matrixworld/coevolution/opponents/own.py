"""Opponent samplers from outside the package: made from a class or function, results checked."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from matrixworld.coevolution.opponents.archive_sampler import ArchiveSampler
from matrixworld.coevolution.opponents.samplers import OpponentSampler
from matrixworld.coevolution.plugin_checks import (
    PluginError,
    check_methods,
    checked_state,
    errors_of,
)
from matrixworld.coevolution.plugins import OPPONENT, OwnSettings, Plugin
from matrixworld.coevolution.types import Indices, State


class CheckedSampler:
    """An opponent sampler whose errors name it and whose results are checked.

    Parameters
    ----------
    plugin : Plugin
        Where the sampler comes from.
    sampler : OpponentSampler
        The sampler.
    count : int
        Largest number of opponents in an epoch.

    Raises
    ------
    PluginError
        Here if the sampler lacks a method; from each method if that of the sampler fails, or
        returns what `OpponentSampler` does not allow.
    """

    def __init__(self, plugin: Plugin, sampler: OpponentSampler, count: int) -> None:
        self.title, self.sampler, self.count = plugin.title, sampler, count
        check_methods(self.title, sampler, OPPONENT.methods)

    def sample(self, available: int, epoch: int, rng: np.random.Generator) -> Indices:
        """Return the opponents of an epoch."""
        with errors_of(self.title, "sample"):
            found = np.asarray(self.sampler.sample(available, epoch, rng))
        most = min(self.count, available)
        numbers = found.dtype.kind in "iu" and found.ndim == 1 and 1 <= len(found) <= most
        if not numbers or len(np.unique(found)) < len(found) or not _within(found, available):
            raise PluginError(
                f"{self.title}: sample: expected 1 to {most} different opponents from 0 to "
                f"{available - 1}, got {found.tolist()}"
            )
        return found.astype(np.intp)

    def tell(self, opponents: Indices, scores: ArrayLike) -> None:
        """Tell it the scores of the candidates."""
        with errors_of(self.title, "tell"):
            self.sampler.tell(opponents.copy(), scores)

    def state(self) -> State:
        """Return its state."""
        with errors_of(self.title, "state"):
            state = self.sampler.state()
        return checked_state(self.title, state)

    def restore(self, state: State) -> None:
        """Restore a state returned by `state()`."""
        with errors_of(self.title, "restore"):
            self.sampler.restore(state)


def _within(found: Indices, available: int) -> bool:
    return bool(found.min() >= 0 and found.max() < available)


def new_own_sampler(plugin: Plugin, count: int, settings: OwnSettings) -> CheckedSampler:
    """Return a new sampler of a class or function from outside the package.

    Parameters
    ----------
    plugin : Plugin
        The class or function.
    count : int
        Opponents an epoch.
    settings : OwnSettings
        Settings of its own.

    Returns
    -------
    CheckedSampler
        The sampler.
    """
    return CheckedSampler(plugin, plugin.make({"count": count}, settings), count)


def archive_of(sampler: OpponentSampler) -> ArchiveSampler | None:
    """Return the archive sampler that a sampler is, inside its checks or without; None if not."""
    inner = sampler.sampler if isinstance(sampler, CheckedSampler) else sampler
    return inner if isinstance(inner, ArchiveSampler) else None
