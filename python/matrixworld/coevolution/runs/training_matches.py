"""The training matches of a run: played, counted and logged, and turned into fitness.

Besides the matches of the epochs there are some at the end of a generation, which decide which
genome represents a team (`TrainingMatches.choose_champion` and `TrainingMatches.keeps`). They count
towards the budget of the run.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from matrixworld.coevolution.fitness import (
    collisions,
    feasible_first,
    fitness,
    mean_over_opponents,
    shared_fitness,
)
from matrixworld.coevolution.learners.actor_critic import Experience, Views
from matrixworld.coevolution.learners.genetic_algorithm import (
    GeneticAlgorithm,
    GeneticAlgorithmSettings,
)
from matrixworld.coevolution.learners.learner import GradientLearner, Learner
from matrixworld.coevolution.seeding import Phase, training_seeds
from matrixworld.coevolution.settings import RaceSettings
from matrixworld.coevolution.storage import Row
from matrixworld.coevolution.types import (
    TEAMS,
    BoolArray,
    FloatArray,
    Genome,
    Genomes,
    Indices,
    Seeds,
    Team,
    other,
)
from matrixworld.play.rollout import EpisodeStatistics, Matches, Rollout
from matrixworld.world.arrays import array_specs, new_arrays
from matrixworld.world.batch import Batch
from matrixworld.world.config import WorldConfig
from matrixworld.world.policy import Network, Population, TeamPolicy

Table = Callable[[FloatArray], FloatArray]
"""Arranges one value of each match (M,) as a table (n, m) of individuals against opponents, with
NaN for pairs that did not play."""
Fitness = Callable[[EpisodeStatistics, Team, Table], FloatArray]

COUNTERS = ("matches", "steps", "agent_steps")
"""Episodes, world steps, and steps of living agents: what a run counts."""


class TrainingMatches:
    """Plays matches in the training world of a run, counts them, and keeps the log of epochs."""

    def __init__(self, settings: RaceSettings, play: Rollout, threads: int | None) -> None:
        self.settings: RaceSettings = settings
        self.network: Network = settings.network
        self.world: WorldConfig = settings.training_world
        self.overlap_penalty: float = settings.overlap_penalty
        # None for learners by gradients, which keep to a limit of their own.
        self.cost_limit: float | None = settings.fitness.cost_limit
        self.threads: int | None = threads
        self.matches: int = 0
        self.steps: int = 0
        self.agent_steps: int = 0
        self.rows: list[Row] = []
        self.on_row: Callable[[Row], None] | None = None
        self.rollout: Rollout = play

    def counters(self) -> dict[str, float]:
        """Return what has been counted so far, by name."""
        return {name: getattr(self, name) for name in COUNTERS}

    def restore(self, counters: Mapping[str, Any]) -> None:
        """Go on from counters that were saved, with an empty log."""
        for name in COUNTERS:
            setattr(self, name, int(counters[name]))
        self.rows = []

    # Playing:

    def population(self, genomes: Genomes) -> Population:
        """Return genomes (n, genes) as a population; DivergedError if one is not finite."""
        try:
            return Population(genomes, self.network)
        except ValueError as error:
            raise self.settings.learner.diverged() from error

    def play(
        self, pursuers: TeamPolicy, evaders: TeamPolicy, matches: Matches
    ) -> EpisodeStatistics:
        """Play and count M matches; the arrays of the result have shape (M, worlds)."""
        worlds, threads = self.settings.match_episodes, self.threads
        scores = self.rollout(
            self.world, pursuers, evaders, matches, episodes=worlds, threads=threads
        )
        self.matches += int(scores.length.size)
        self.steps += int(scores.length.sum())
        self.agent_steps += int(scores.agent_steps.sum())
        return scores

    def play_candidates(
        self, team: Team, candidates: Genomes, opponents: TeamPolicy, indices: Indices, seeds: Seeds
    ) -> EpisodeStatistics:
        """Play each candidate (n, genes) of a team against the opponents of some indices (c,).

        Returns the statistics of n * c matches in the order of ``seeds.ravel()``, seeds (n, c): the
        matches of a candidate are adjacent. A script has no indices, and ignores them.
        """
        n, c = seeds.shape
        others = 0 if isinstance(opponents, str) else indices
        own, met = np.repeat(np.arange(n, dtype=np.int32), c), np.full((n, c), others, np.int32)
        learning = self.population(candidates)
        if team == "pursuer":
            return self.play(learning, opponents, Matches(own, met.ravel(), seeds.ravel()))
        return self.play(opponents, learning, Matches(met.ravel(), own, seeds.ravel()))

    def teach(
        self, learner: Learner, team: Team, opponents: TeamPolicy, chosen: Indices, seeds: Seeds
    ) -> None:
        """Let a learner by gradients learn from matches (M,) that have been played and counted.

        They are played once more, step by step, by its genome against the opponents `chosen` (M,).
        """
        if isinstance(learner, GradientLearner):
            found = experience(
                self.world, team, self.population(learner.genome), opponents, chosen, seeds,
                worlds=self.settings.match_episodes, states=learner.sees_states,
                threads=self.threads,
            )  # fmt: skip
            learner.learn(found)

    # Fitness:

    def fitness(self, scores: EpisodeStatistics, team: Team, table: Table) -> FloatArray:
        """Return the fitness (n,) of a team's individuals, as the settings define it."""
        sharing, virulence = self.settings.fitness.sharing, self.settings.fitness.virulence(team)
        if sharing == "none" and virulence is None:
            return self.mean_fitness(scores, team, table)
        # Sharing is of results in [0, 1]; the penalty is subtracted afterwards.
        values, payoff = (table(self._values(scores, team, penalty=p)) for p in (True, False))
        shared = shared_fitness(values, payoff, sharing=sharing, virulence=virulence)
        return self._within_limit(shared, scores, team, table)

    def mean_fitness(self, scores: EpisodeStatistics, team: Team, table: Table) -> FloatArray:
        """Return the mean fitness (n,) over opponents, without sharing and virulence."""
        means = mean_over_opponents(table(self._values(scores, team, penalty=True)))
        return self._within_limit(means, scores, team, table)

    def _within_limit(
        self, fitness: FloatArray, scores: EpisodeStatistics, team: Team, table: Table
    ) -> FloatArray:
        """Return the fitness (n,), with candidates within the limit of collisions first."""
        if self.cost_limit is None:
            return fitness
        found = mean_over_opponents(table(collisions(scores, team)))
        return feasible_first(fitness, found - self.cost_limit)

    def _values(self, scores: EpisodeStatistics, team: Team, *, penalty: bool) -> FloatArray:
        overlap_penalty = self.overlap_penalty if penalty else 0.0
        return fitness(
            scores, team, measure=self.settings.fitness.measure, overlap_penalty=overlap_penalty
        )

    # The log:

    def fitness_of_epoch(
        self,
        scores: EpisodeStatistics,
        table: Table,
        *,
        team: Team,
        generation: int,
        epoch: int,
        opponent: int,
    ) -> FloatArray:
        """Return the fitness (n,) of a team's individuals, and log the epoch (see `COLUMNS`)."""
        fitness = self.fitness(scores, team, table)
        # (M, worlds, teams, kinds of collision) -> (teams,)
        faults = scores.faults.sum(axis=3).mean(axis=(0, 1))
        row: Row = {
            "generation": generation,
            "team": team,
            "epoch": epoch,
            "opponent": opponent,
            "fitness_mean": float(fitness.mean()),
            "fitness_std": float(fitness.std()),
            "fitness_best": float(fitness.max()),
            "capture_rate": float(scores.capture_rate.mean(dtype=np.float64)),
            "length": float(scores.length.mean()),
            "pursuer_faults": float(faults[0]),
            "evader_faults": float(faults[1]),
            "matches": self.matches,
            "steps": self.steps,
        }
        self.rows.append(row)
        if self.on_row is not None:
            self.on_row(row)
        return fitness

    def _recount_last_epoch(self) -> None:
        """Count the matches since the last epoch in the log of that epoch."""
        # Two rows in a hall-of-fame race, one of each team.
        last = self.rows[-1]["matches"]
        for row in self.rows:
            if row["matches"] == last:
                row |= {"matches": self.matches, "steps": self.steps}

    # The end of a generation:

    def choose_champion(
        self, learner: Learner, team: Team, generation: int, opponents: TeamPolicy, met: Indices
    ) -> None:
        """Make the best elite in new matches the champion of a genetic algorithm, if set so.

        The best candidate of the last epoch may be the luckiest one. The elite meets the opponents
        `met` (c,) that the fittest individual has met in that epoch.
        """
        settings = self.settings.learner
        if not isinstance(settings, GeneticAlgorithmSettings):
            return
        episodes = settings.elite_episodes
        if episodes and isinstance(learner, GeneticAlgorithm):
            # The run's own fitness, with sharing and virulence: only the luck of the epoch is new.
            again = self._fitness_again(
                team, generation, learner.elite_genomes(), opponents, met,
                phase=Phase.ELITE, episodes=episodes, fitness=self.fitness,
            )  # fmt: skip
            learner.choose_champion(again)

    def keeps(
        self,
        team: Team,
        generation: int,
        genome: Genome,
        previous: Genome,
        opponents: Population,
        episodes: int,
    ) -> bool:
        """Return whether a new genome is not worse than the previous one against all opponents.

        Both play the same `episodes` against each opponent, and all opponents have the same weight:
        variations that gain against current opponents and lose against others are filtered out
        (Simione & Nolfi 2021, "Long-term progress and behavior complexification in competitive
        coevolution", Artificial Life 26(4)).
        """
        new, old = self._fitness_again(
            team, generation, np.stack([genome, previous]), opponents,
            np.arange(len(opponents.genomes)),
            phase=Phase.RETENTION, episodes=episodes, fitness=self.mean_fitness,
        )  # fmt: skip
        return bool(new >= old)

    def _fitness_again(
        self,
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
        key = (self.settings.seed, generation, generation, phase, TEAMS.index(team))
        seeds = np.tile(training_seeds(*key, c * episodes), (n, 1))
        met = np.repeat(indices, episodes)
        scores = self.play_candidates(team, genomes, opponents, met, seeds)
        self._recount_last_epoch()
        return fitness(scores, team, lambda values: values.reshape(n, c, episodes).mean(axis=2))


# What agents saw, did and earned, for learners by gradients:

Player = tuple[range, list[TeamPolicy], NDArray[np.int32]]
"""Agents of a team, the policies that play for it, and the place of each match's policy."""

ARRAYS = ("views", "state", "rewards", "cost", "alive", "terminated", "truncated")
"""Output arrays that experience is taken from."""


def experience(
    config: WorldConfig,
    team: Team,
    policy: Population,
    opponents: TeamPolicy,
    chosen: Indices,
    seeds: Seeds,
    *,
    worlds: int = 1,
    states: bool = False,
    threads: int | None = None,
) -> Experience:
    """Play matches and return the transitions of one team, all of whose agents act at a time.

    The one genome of `policy` plays for the team in each match, against the opponent `chosen` (W,),
    with a seed (W,) and `worlds` episodes. The states of the worlds are kept if `states`.

    Policies decide in the engine with the random numbers of a rollout: the matches are those that
    `matrixworld.rollout` plays for these seeds, whatever the number of threads.
    """
    specs = array_specs(config)
    wanted = [name for name in ARRAYS if states or name != "state"]
    everywhere = np.repeat(seeds, worlds)
    buffers = new_arrays({name: specs[name] for name in wanted}, len(everywhere))
    batch = Batch(len(everywhere), config, threads=threads, buffers=buffers)
    for number in range(worlds):
        batch.reset(everywhere, episode=number, mask=np.arange(len(everywhere)) % worlds == number)
    everyone = {
        "pursuer": range(config.n_pursuers),
        "evader": range(config.n_pursuers, config.n_agents),
    }
    players: list[Player] = [
        (everyone[team], [policy], np.zeros(len(everywhere), np.int32)),
        (everyone[other(team)], *_opponents(opponents, np.repeat(chosen, worlds))),
    ]
    return _played(batch, everyone[team], players, config.max_steps)


def _opponents(
    opponents: TeamPolicy, chosen: Indices
) -> tuple[list[TeamPolicy], NDArray[np.int32]]:
    """Return the opponents that play, and the place of each match's opponent among them."""
    if isinstance(opponents, str):
        return [opponents], np.zeros(len(chosen), np.int32)
    met, places = np.unique(chosen, return_inverse=True)
    return (
        [Population(opponents.genomes[i], opponents.network) for i in met],
        places.astype(np.int32),
    )


def _played(batch: Batch, team: range, players: list[Player], most: int) -> Experience:
    """Play all episodes to their ends, at most so many steps; return what the team experienced."""
    buffers, part = batch.buffers, slice(team.start, team.stop)
    seen = {name: buffers[name][:, part] for name in ("views", "alive", "rewards", "cost")}
    seen |= {name: buffers[name] for name in ("state", "truncated") if name in buffers}
    # Everything is copied, and selected at the end: that is faster than to index in each step.
    # Memory of steps that are not played is never touched.
    kept = {name: np.empty((most + 1, *array.shape), array.dtype) for name, array in seen.items()}
    actions = np.zeros((most, *buffers["alive"].shape), np.int64)
    going = np.zeros((most + 1, batch.n_worlds), np.bool_)
    for t in range(most + 1):
        for name, array in seen.items():
            kept[name][t] = array
        np.logical_or(buffers["terminated"], buffers["truncated"], out=going[t])
        np.logical_not(going[t], out=going[t])
        if not going[t].any():
            break
        for agents, policies, places in players:
            batch.decide(policies, places, agents, actions[t])
        batch.step(actions[t])
    return _selected(kept, actions[:, :, part], going, t)


def _selected(
    kept: dict[str, NDArray[Any]], actions: NDArray[np.int64], going: BoolArray, steps: int
) -> Experience:
    """Return the transitions of the agents that acted, from what all agents saw in all steps."""
    # What was kept at t is what a step begins with, and what the step before ended with.
    before = {name: array[:steps] for name, array in kept.items()}
    after = {name: array[1 : steps + 1] for name, array in kept.items()}
    acted = before["alive"] & going[:steps, :, None]
    # An agent that is alive at the end of its time would have gone on.
    last = after["alive"] & (going[:steps] & after["truncated"])[:, :, None]
    return Experience(
        acted=acted,
        views=_flat(before["views"][acted]),
        actions=actions[:steps][acted],
        rewards=after["rewards"][acted],
        costs=after["cost"][acted],
        last=last,
        last_views=_flat(after["views"][last]),
        states=before["state"].reshape(*going[:steps].shape, -1) if "state" in kept else None,
        last_states=_flat(after["state"][-1]) if "state" in kept else None,
    )


def _flat(arrays: Views) -> Views:
    """Return arrays (n, ...) as rows (n, size)."""
    rows: Views = arrays.reshape(len(arrays), math.prod(arrays.shape[1:]))
    return rows
