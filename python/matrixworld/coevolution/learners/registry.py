"""The learners by name, and how a run starts: new learners and untrained genomes.

A name that is not in `LEARNERS` is one of a learner from outside the package (see `plugins`), which
is imported when a run starts or continues. To add a learner to the package, write a class with the
interface `Learner` and a `LearnerEntry` in a file of its own, add its settings as fields of
`TrainingSettings`, and add a row to `LEARNERS`.
"""

from __future__ import annotations

import numpy as np

from matrixworld.coevolution.learners import (
    actor_critic,
    cma_es,
    evolution_strategy,
    genetic_algorithm,
)
from matrixworld.coevolution.learners.learner import Learner, LearnerEntry, RunSettings
from matrixworld.coevolution.learners.own import own_learner
from matrixworld.coevolution.learners.perceptron import orthogonal
from matrixworld.coevolution.seeding import Purpose, keyed_generator
from matrixworld.coevolution.types import TEAMS, Genomes, Team

LEARNERS: dict[str, LearnerEntry] = {
    "es": evolution_strategy.ENTRY,
    "ga": genetic_algorithm.ENTRY,
    "cma": cma_es.ENTRY,
    "actor-critic": actor_critic.ENTRY,
}
"""Learners by the name that `TrainingSettings.learner` takes."""


def learner_entry(name: str) -> LearnerEntry:
    """Return the entry of a learner, imported if it is not one of the package.

    Parameters
    ----------
    name : str
        A key of `LEARNERS`, an entry point or ``module:object``.

    Returns
    -------
    LearnerEntry
        Its settings, checks and factory.

    Raises
    ------
    ValueError
        If no such learner can be imported.
    PluginError
        If its module fails.
    """
    return LEARNERS.get(name) or own_learner(name, LEARNERS)


def check_learner_settings(settings: RunSettings) -> None:
    """Raise ValueError or TypeError if a setting of any learner of the package is bad.

    Parameters
    ----------
    settings : RaceSettings or SingleSettings
        Settings whose world has been checked already: the network's size follows from it.
    """
    # Of all learners, not only of the chosen one: a value out of range is never meant.
    for entry in LEARNERS.values():
        for name, check in entry.settings.items():
            check(name, getattr(settings, name))
    # One from outside the package is checked when it is made: settings import nothing.
    if settings.learner_name in LEARNERS:
        LEARNERS[settings.learner_name].check(settings)


def starting_genomes(settings: RunSettings) -> int:
    """Return the number of genomes from which the learner of the settings starts."""
    return settings.population if learner_entry(settings.learner_name).starts_from_population else 1


def new_learner(settings: RunSettings, team: Team, genomes: Genomes) -> Learner:
    """Return a new learner of the kind that the settings name.

    Parameters
    ----------
    settings : RaceSettings or SingleSettings
        Settings of the run.
    team : {"pursuer", "evader"}
        Team that learns.
    genomes : ndarray of float32, shape (n, genes)
        Genomes to start from, ``n = starting_genomes(settings)``.

    Returns
    -------
    Learner
        The learner.

    Raises
    ------
    ValueError
        If a learner from outside the package cannot be imported, or refuses its settings.
    PluginError
        If its code fails.
    """
    # The table is filled again from the same key when a run resumes, so no checkpoint holds it.
    rng = keyed_generator(settings.seed, Purpose.NOISE, TEAMS.index(team))
    mask = settings.mask_weights(team)
    if mask is not None:
        genomes = mask.write(genomes)
    return learner_entry(settings.learner_name).new(settings, team, genomes, rng)


def untrained(settings: RunSettings, team: Team, count: int) -> Genomes:
    """Return the first `count` untrained genomes (count, genes) of a team of a run."""
    rng = keyed_generator(settings.seed, Purpose.INITIAL, TEAMS.index(team))
    if learner_entry(settings.learner_name).by_gradients:
        # Gradients vanish or explode from other beginnings.
        sizes = settings.network.sizes
        return np.stack([orthogonal(sizes, rng, head=settings.initial_head) for _ in range(count)])
    weight, head = settings.initial_weight, settings.initial_head
    # One after the other from one generator: the first genomes do not depend on `count`.
    return np.stack([settings.network.initial(rng, weight=weight, head=head) for _ in range(count)])
