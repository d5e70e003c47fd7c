"""Extra matches at the end of a generation: which genome represents a team.

Both options cost matches, which count towards the budget of the run.

================  ================================================================================
`crown_elite`     the champion of the genetic algorithm is the best elite in new matches, not the
                  luckiest one of the last epoch
`generalizes`     whether a new genome is at least as good as the previous one against all archived
                  opponents
================  ================================================================================
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from matrixworld.coevolution.learners.genetic_algorithm import GeneticAlgorithm
from matrixworld.coevolution.learners.learner import Learner
from matrixworld.coevolution.runs.training import Table, Training
from matrixworld.coevolution.seeding import Phase, training_seeds
from matrixworld.coevolution.settings.training import TrainingSettings
from matrixworld.coevolution.types import TEAMS, FloatArray, Genome, Genomes, Indices, Team
from matrixworld.play.rollout import EpisodeStatistics
from matrixworld.world.policy import Population, TeamPolicy

Fitness = Callable[[EpisodeStatistics, Team, Table], FloatArray]


def crown_elite(
    training: Training,
    learner: Learner,
    team: Team,
    generation: int,
    opponents: TeamPolicy,
    met: Indices,
) -> None:
    """Name the champion of a genetic algorithm by new matches of its elite, if the settings say so.

    Parameters
    ----------
    training : Training
        Plays and counts the matches.
    learner : Learner
        Learner of the team.
    team : {"pursuer", "evader"}
        The team.
    generation : int
        Generation that ends.
    opponents : Population or str
        Opponents of the team, or the name of a script.
    met : ndarray of int, shape (c,)
        Opponents that the fittest individual has met in the last epoch.
    """
    episodes = training.settings.elite_episodes
    if episodes and isinstance(learner, GeneticAlgorithm):
        # The run's own fitness, with sharing and virulence: only the luck of the epoch is new.
        again = _fitness_again(
            training, team, generation, learner.elite_genomes(), opponents, met,
            phase=Phase.ELITE, episodes=episodes, fitness=training.fitness,
        )  # fmt: skip
        learner.crown(again)


def elite_matches(settings: TrainingSettings, met: int) -> int:
    """Return the matches of `crown_elite` against `met` opponents."""
    # The product is 0 for other learners, whose setting is 0.
    return settings.elite_episodes * settings.elites * met


def generalizes(
    training: Training,
    team: Team,
    generation: int,
    genome: Genome,
    previous: Genome,
    opponents: Population,
    episodes: int,
) -> bool:
    """Return whether a new genome is not worse than the previous one against all opponents.

    Parameters
    ----------
    training : Training
        Plays and counts the matches.
    team : {"pursuer", "evader"}
        Team of both genomes.
    generation : int
        Generation of the new genome.
    genome, previous : ndarray of float32, shape (genes,)
        The new genome, and that of the generation before.
    opponents : Population
        All archived opponents; each has the same weight.
    episodes : int
        Matches of each genome against each opponent; both play with the same seeds.

    Returns
    -------
    bool
        Whether the mean fitness of the new genome is at least that of the previous one.

    References
    ----------
    Simione & Nolfi 2021, "Long-term progress and behavior complexification in competitive
    coevolution", Artificial Life 26(4): variations that gain against current opponents and lose
    against others are filtered out.
    """
    new, old = _fitness_again(
        training, team, generation, np.stack([genome, previous]), opponents,
        np.arange(len(opponents.genomes)),
        phase=Phase.RETENTION, episodes=episodes, fitness=training.mean_fitness,
    )  # fmt: skip
    return bool(new >= old)


def _fitness_again(
    training: Training,
    team: Team,
    generation: int,
    genomes: Genomes,
    opponents: TeamPolicy,
    indices: Indices,
    *,
    phase: Phase,
    episodes: int,
    fitness: Fitness,
) -> FloatArray:
    """Return the fitness (n,) of genomes in new matches, all with the same seeds."""
    n, c = len(genomes), len(indices)
    key = (training.settings.seed, generation, generation, phase, TEAMS.index(team))
    seeds = np.tile(training_seeds(*key, c * episodes), (n, 1))
    scores = training.play_candidates(team, genomes, opponents, np.repeat(indices, episodes), seeds)
    training.recount_last_epoch()
    return fitness(scores, team, lambda values: values.reshape(n, c, episodes).mean(axis=2))
