"""Learners from outside the package: made from a class or function, with checked results."""

from __future__ import annotations

from collections.abc import Collection
from functools import partial
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from matrixworld.coevolution.learners.learner import Learner, LearnerEntry, RunSettings
from matrixworld.coevolution.plugin_checks import (
    PluginError,
    check_array,
    check_methods,
    checked_state,
    errors_of,
)
from matrixworld.coevolution.plugins import LEARNER, OwnSettings, Plugin, find
from matrixworld.coevolution.types import Genome, Genomes, Indices, State, Team


class CheckedLearner:
    """A learner whose errors name it and whose results are checked.

    Parameters
    ----------
    plugin : Plugin
        Where the learner comes from.
    learner : Learner
        The learner.
    samples, genes : int
        Shape of its candidates.

    Raises
    ------
    PluginError
        Here if the learner lacks a method; from each method if that of the learner fails, or
        returns what `Learner` does not allow.
    """

    def __init__(self, plugin: Plugin, learner: Learner, samples: int, genes: int) -> None:
        self.title, self.learner = plugin.title, learner
        self.samples, self.genes = samples, genes
        check_methods(self.title, learner, ("genome", "match_of_candidate", *LEARNER.methods))

    @property
    def genome(self) -> Genome:
        """The genome of the learner."""
        with errors_of(self.title, "genome"):
            genome = self.learner.genome
        check_array(self.title, "genome", genome, (self.genes,), np.float32)
        # A copy: the archive keeps it, and the learner may change its own array in place.
        return np.array(genome)

    @property
    def match_of_candidate(self) -> Indices:
        """The groups of its candidates."""
        with errors_of(self.title, "match_of_candidate"):
            groups = np.asarray(self.learner.match_of_candidate)
        numbers = groups.shape == (self.samples,) and groups.dtype.kind in "iu"
        within = numbers and groups.min() >= 0 and groups.max() < self.samples
        if not within or len(set(np.bincount(groups).tolist())) != 1:
            raise PluginError(
                f"{self.title}: match_of_candidate: expected {self.samples} numbers of groups "
                f"from 0, all of one size, got {groups.tolist()}"
            )
        return groups

    def ask(self, rng: np.random.Generator) -> Genomes:
        """Return its candidates."""
        with errors_of(self.title, "ask"):
            candidates = self.learner.ask(rng)
        check_array(self.title, "ask", candidates, (self.samples, self.genes), np.float32)
        return candidates

    def tell(self, fitness: ArrayLike) -> None:
        """Tell it the fitness of its candidates."""
        with errors_of(self.title, "tell"):
            self.learner.tell(fitness)

    def state(self) -> State:
        """Return its state."""
        with errors_of(self.title, "state"):
            state = self.learner.state()
        return checked_state(self.title, state)

    def restore(self, state: State) -> None:
        """Restore a state returned by `state()`."""
        with errors_of(self.title, "restore"):
            self.learner.restore(state)


def new_own_learner(
    plugin: Plugin,
    genomes: Genomes,
    rng: np.random.Generator,
    *,
    samples: int,
    epochs: int,
    settings: OwnSettings,
) -> CheckedLearner:
    """Return a new learner of a class or function from outside the package.

    Parameters
    ----------
    plugin : Plugin
        The class or function.
    genomes : ndarray of float32, shape (n, genes)
        Genomes to start from; one, unless the signature names `genomes`.
    rng : numpy.random.Generator
        Generator for what the learner draws once, such as a table of noise.
    samples : int
        Candidates per epoch.
    epochs : int
        Epochs of the whole run in which the team learns.
    settings : OwnSettings
        Settings of its own.

    Returns
    -------
    CheckedLearner
        The learner.
    """
    # Copies: a learner that changes its genome in place must not change generation 0.
    run = {
        "genome": genomes[0].copy(),
        "genomes": genomes.copy(),
        "samples": samples,
        "epochs": epochs,
        "rng": rng,
    }
    return CheckedLearner(plugin, plugin.make(run, settings), samples, genomes.shape[1])


def _new(
    plugin: Plugin, settings: RunSettings, team: Team, genomes: Genomes, rng: np.random.Generator
) -> Learner:
    return new_own_learner(
        plugin,
        genomes,
        rng,
        samples=settings.population,
        epochs=settings.total_epochs(team),
        settings=settings.learner_settings,
    )


def _no_check(settings: RunSettings) -> Any:
    """Check nothing: the class checks its settings itself."""


def own_learner(name: str, builtin: Collection[str]) -> LearnerEntry:
    """Return the entry of a learner from outside the package; imports it.

    Parameters
    ----------
    name : str
        Entry point or ``module:object``.
    builtin : collection of str
        Names in the package, for messages.

    Returns
    -------
    LearnerEntry
        It reads no fields of the settings besides `population` and `learner_settings`.
    """
    plugin = find("learner", name, builtin, LEARNER)
    return LearnerEntry(
        title=name,
        settings={},
        check=_no_check,
        new=partial(_new, plugin),
        starts_from_population="genomes" in plugin.parameters,
    )
