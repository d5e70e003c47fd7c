"""A race or a run in memory: all that its loop works with, from one stage to the next."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from functools import partial
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from matrixworld._util import checks
from matrixworld.coevolution import types
from matrixworld.coevolution.games.game import Game, Scores
from matrixworld.coevolution.games.pursuit import Pursuit, PursuitSettings, WorldConfig
from matrixworld.coevolution.learners.fitness import Table
from matrixworld.coevolution.learners.learner import Learner, Results, check_genomes
from matrixworld.coevolution.opponents import Opponents
from matrixworld.coevolution.seeding import Phase, Purpose, keyed_generator, training_seeds
from matrixworld.coevolution.settings.race_settings import RaceSettings
from matrixworld.coevolution.states import State, restored
from matrixworld.coevolution.types import (
    TEAMS,
    FloatArray,
    Genome,
    Genomes,
    Indices,
    Matches,
    Row,
    Seeds,
    Team,
    other,
)

OnRow = Callable[[Row], None]
"""Called with each row of the log."""
OnActivity = Callable[[str], None]
"""Called after each epoch with what is being done."""
OnStage = Callable[[], None]
"""Called at the end of each stage."""


def _nothing(*_: Any) -> None:
    """Do nothing."""


class Played(NamedTuple):
    """What a team has from the matches of an epoch."""

    fitness: FloatArray  # (n,) of its candidates
    opponents: Any  # all that they could meet
    met: Indices  # those whom the fittest candidate has met


class Training:
    """A race in memory.

    Parameters
    ----------
    settings : RaceSettings
        Settings of a race; of a team alone with `rivals`.
    threads : int, optional
        Threads that play its matches, by default one per usable core. Results do not depend on it.
    begin : ndarray of float32, optional
        Genome (genes,) that a team alone starts from, in place of an untrained one.
    rivals : callable, optional
        Returns what plays for a team that does not learn, by the team.
    on_row, on_activity, on_stage : callable, optional
        Called with each row of the log, after each epoch with what is being done, and at the end of
        each stage.

    Attributes
    ----------
    game : Game
        The game in which teams learn.
    learners, samplers : dict
        How each learning team learns, and chooses opponents.
    archive : dict of str to list of ndarray
        Genomes of each team by generation.
    states, memories : dict
        States of learners, and of samplers of opponents, by team.
    rows : list of dict
        Rows of the log since training began or went on.
    stage : int
        Number of finished stages.
    counts : dict of str to int
        Training episodes, ``matches``; of pursuit also ``steps`` and ``agent_steps``.
    """

    def __init__(
        self,
        settings: RaceSettings,
        *,
        threads: int | None = None,
        begin: Genome | None = None,
        rivals: Callable[[Team], Any] | None = None,
        on_row: OnRow = _nothing,
        on_activity: OnActivity = _nothing,
        on_stage: OnStage = _nothing,
    ) -> None:
        if not isinstance(settings, RaceSettings):
            raise TypeError(f"settings: expected RaceSettings, got {checks.shown(settings)}")
        checks.check_threads(threads)
        if not settings.is_race and rivals is None:
            raise ValueError("settings: expected those of a race, got those of one team alone")
        self.settings: RaceSettings = settings
        self.threads: int | None = threads
        self.game: Game = settings.training_game
        self._rivals = rivals
        self._on_row = on_row
        self.on_activity: OnActivity = on_activity
        self._on_stage = on_stage
        teams = settings.learning_teams
        schedule = settings.schedule
        self.learners: dict[Team, Learner] = {team: settings.learner_of(team) for team in teams}
        self.samplers: dict[Team, Opponents] = {team: schedule.sampler(team) for team in teams}
        self.states: dict[Team, State] = {
            team: learner.start(settings.task(team, begin))
            for team, learner in self.learners.items()
        }
        self.memories: dict[Team, State] = {
            team: sampler.start() for team, sampler in self.samplers.items()
        }
        self.archive: dict[Team, list[Genome]] = {team: [] for team in TEAMS}
        self._share_archive()
        for team, learner in self.learners.items():
            self.archive[team].append(learner.genome(self.states[team]))
        self.rows: list[Row] = []
        self.stage: int = 0
        self.counts: dict[str, int] = dict.fromkeys(("matches", *self.game.counters), 0)

    def _share_archive(self) -> None:
        """Let the one population of a symmetric game be both teams."""
        if self.settings.game.symmetric:
            self.archive["evader"] = self.archive["pursuer"]

    # Stages:

    def begin_stage(self) -> None:
        """Play in the settings' world: samplers play between epochs, each of which may draw one."""
        if isinstance(self.settings.training_game, Pursuit):
            self.play_in(self.settings.training_game.world)

    def end_stage(self) -> None:
        """Count a stage, and tell of it."""
        self.stage += 1
        self._on_stage()

    # What a checkpoint holds:

    def parts(self) -> dict[str, State]:
        """Return the states of learners and samplers, by their parts of a checkpoint."""
        learners = {f"{team}.learner": state for team, state in self.states.items()}
        samplers = {f"{team}.opponents": memory for team, memory in self.memories.items()}
        return learners | samplers

    def restore(
        self,
        stage: int,
        archive: Mapping[str, Genomes],
        counts: Mapping[str, int],
        arrays: Mapping[str, NDArray[Any]],
    ) -> None:
        """Take up a finished stage: its number, genomes and counts, and the arrays of `parts`."""
        self.stage = stage
        self.archive = {team: [*archive[team]] for team in TEAMS}
        self._share_archive()
        self.counts = {name: counts[name] for name in self.counts}
        self.rows = []
        for team in self.learners:
            self.states[team] = restored(self.states[team], arrays, f"{team}.learner")
            self.memories[team] = restored(self.memories[team], arrays, f"{team}.opponents")

    # Teams:

    def name_of(self, team: Team) -> str:
        """Return what the game calls a team."""
        return self.settings.teams[TEAMS.index(team)]

    def genomes(self, team: Team) -> Genomes:
        """Return a team's archive as one array (generations, genes)."""
        archive = self.archive[team]
        if not archive:
            return np.empty((0, self.game.genome_size(team)), np.float32)
        return np.stack(archive)

    def population(self, team: Team, genomes: Genomes) -> Any:
        """Return genomes (n, genes) of a team as what plays; DivergedError for too large genes."""
        expected = (len(genomes), self.game.genome_size(team))
        if np.shape(genomes) != expected:  # by a learner of your own
            raise ValueError(f"genomes: expected shape {expected}, got {np.shape(genomes)}")
        try:
            return self.game.population(team, genomes)
        except ValueError as error:  # genes that are not finite, or too large beside a mask
            path = self.settings.learner_path(team)
            raise self.learners[team].diverged(path, str(error)) from error

    def opponents(self, team: Team) -> Any:
        """Return whom a team can meet now: the other team's generations, or what plays for it."""
        rival = other(team)
        if rival in self.learners or self.settings.game.symmetric or self._rivals is None:
            return self.population(rival, self.genomes(rival))
        return self._rivals(rival)

    def archive_genome(self, team: Team, genome: Genome) -> None:
        """Add a genome to the archive of a team; DivergedError if it is not finite."""
        self.archive[team].extend(self.population(team, genome[np.newaxis].copy()).genomes)

    # Epochs:

    def generator(self, purpose: Purpose, team: Team, generation: int, epoch: int) -> types.Rng:
        """Return the random numbers of a team in an epoch."""
        return keyed_generator(self.settings.seed, purpose, TEAMS.index(team), generation, epoch)

    def begin_epoch(self, team: Team, generation: int, epoch: int) -> None:
        """Draw the world of an epoch; where both teams learn at once, `team` is the first."""
        pursuit = self.settings.game
        if isinstance(pursuit, PursuitSettings) and pursuit.training_worlds:
            rng = self.generator(Purpose.WORLD, team, generation, epoch)
            self.play_in(pursuit.drawn_world(rng))

    def play_in(self, world: WorldConfig) -> None:
        """Play the matches that follow in another world."""
        assert isinstance(self.game, Pursuit)
        self.game = replace(self.game, world=world)

    def ask(self, team: Team, generation: int, epoch: int) -> Genomes:
        """Return the candidates (n, genes) of a team."""
        rng = self.generator(Purpose.LEARN, team, generation, epoch)
        learner = self.learners[team]
        candidates, self.states[team] = learner.ask(self.states[team], rng)
        shape = len(learner.seed_groups), self.game.genome_size(team)
        name = f"ask of {self.settings.learner_path(team)} {learner.kind or type(learner).__name__}"
        check_genomes(name, candidates, shape, texts=self.game.texts)
        return candidates

    def tell(
        self, team: Team, fitness: FloatArray, opponents: Any, met: Indices, seeds: Seeds
    ) -> None:
        """Let a team learn from the fitness (n,) of its candidates.

        `met` and `seeds` (M,) are its matches against `opponents`; the learner may play them again.
        """

        def again(*, states: bool = False) -> Any:
            genome = self.learners[team].genome(self.states[team])
            population = self.population(team, genome[np.newaxis])
            worlds = self.settings.match_episodes
            return self.game.experience(
                team,
                population,
                opponents,
                met,
                seeds,
                worlds=worlds,
                states=states,
                threads=self.threads,
            )

        self.states[team] = self.learners[team].tell(self.states[team], Results(fitness, again))

    def update_sampler(self, team: Team, own: int, available: int) -> None:
        """Tell a sampler at the begin of a generation how many generations of both teams exist."""
        payoff = partial(self._payoff, team)
        memory = self.memories[team]
        self.memories[team] = self.samplers[team].update(memory, own, available, payoff)

    def sample(self, team: Team, available: int, count: int, epoch: int, rng: types.Rng) -> Indices:
        """Return the opponents (c,) of a team in an epoch."""
        return self.samplers[team].sample(self.memories[team], available, count, epoch, rng)

    def tell_sampler(self, team: Team, met: Indices, rates: FloatArray) -> None:
        """Tell a sampler the win rates (n, c) of n candidates against the opponents (c,)."""
        self.memories[team] = self.samplers[team].tell(self.memories[team], met, rates)

    # Matches:

    def play(self, pursuers: Any, evaders: Any, matches: Matches) -> Scores:
        """Play and count M matches; the arrays of the result have shape (M, episodes, ...)."""
        episodes = self.settings.match_episodes
        scores = self.game.rollout(
            pursuers, evaders, matches, episodes=episodes, threads=self.threads
        )
        for name, count in {"matches": scores.scores.size, **self.game.counted(scores)}.items():
            self.counts[name] += count
        return scores

    def play_candidates(
        self, team: Team, candidates: Genomes, opponents: Any, met: Indices, seeds: Seeds
    ) -> Scores:
        """Play each candidate (n, genes) of a team against the opponents of some indices (c,).

        Returns the statistics of n * c matches in the order of ``seeds.ravel()``, seeds (n, c): the
        matches of a candidate are adjacent. A script has no indices, and ignores them.
        """
        n, c = seeds.shape
        rivals = np.full((n, c), met if hasattr(opponents, "genomes") else 0, np.int32)
        own = np.repeat(np.arange(n, dtype=np.int32), c)
        learning = self.population(team, candidates)
        if team == "pursuer":
            return self.play(learning, opponents, (own, rivals.ravel(), seeds.ravel()))
        return self.play(opponents, learning, (rivals.ravel(), own, seeds.ravel()))

    def fitness(self, team: Team, scores: Scores, table: Table) -> FloatArray:
        """Return the fitness (n,) of a team's individuals, as its learner defines it."""
        return self.learners[team].fitness(self.game, scores, team, table)

    def log_fitness(
        self,
        team: Team,
        scores: Scores,
        table: Table,
        generation: int,
        epoch: int,
        opponent: int,
        told: Scores | None = None,
    ) -> FloatArray:
        """Return the fitness (n,) of a team's individuals, and log the epoch.

        The log has means of the `scores`, or of the matches that are `told`.
        """
        fitness = self.fitness(team, scores, table)
        row: Row = {
            "stage": self.stage + 1,
            "generation": generation,
            "team": self.settings.keys[TEAMS.index(team)],
            "epoch": epoch,
            "opponent": opponent,
            "fitness_mean": float(fitness.mean()),
            "fitness_std": float(fitness.std()),
            "fitness_best": float(fitness.max()),
            **self.game.row(scores if told is None else told),
            **self._logged_counts(),
        }
        self.rows.append(row)
        self._on_row(row)
        return fitness

    def champion(self, team: Team, generation: int, candidates: Genomes, played: Played) -> Genome:
        """Return the genome that enters the archive, from the last epoch of a generation.

        It is the learner's. With `retest_episodes` it is the best of that one and the two fittest
        candidates in new matches: the fittest candidate of the epoch may be the luckiest one.
        """
        genome = self.learners[team].genome(self.states[team])
        episodes = self.settings.retest_episodes
        if not episodes:
            return genome
        best = np.argsort(-played.fitness, kind="stable")[:2]
        genomes = np.stack([genome, *candidates[best]])
        n = len(genomes)
        c = len(played.met)
        key = (self.settings.seed, generation, generation, Phase.RETEST, TEAMS.index(team))
        seeds = np.tile(training_seeds(*key, c * episodes), (n, 1))
        met = np.repeat(played.met, episodes)
        scores = self.play_candidates(team, genomes, played.opponents, met, seeds)
        self.count_in_last_epoch()
        again = self.fitness(
            team, scores, lambda values: np.asarray(values.reshape(n, c, episodes).mean(axis=2))
        )
        champion: Genome = genomes[np.argmax(again)]
        return champion

    def count_in_last_epoch(self) -> None:
        """Count matches after an epoch in its rows: two where both teams learn at once."""
        last = self.rows[-1]["matches"]
        for row in self.rows:
            if row["matches"] == last:
                row |= self._logged_counts()

    def _logged_counts(self) -> dict[str, int]:
        """Return what the log has of the counts."""
        return {name: n for name, n in self.counts.items() if name in self.game.columns}

    def _payoff(self, team: Team, own: Indices, rivals: Indices) -> FloatArray:
        """Play generations (n,) of a team against opponents (m,), and return the payoffs (n, m)."""
        met = {team: own, other(team): rivals}
        episodes = getattr(self.samplers[team], "episodes", 1)
        # The order of the seeds: all episodes of a pair, which have seeds of their own, then the
        # next pair.
        pairs = [(int(g), int(h)) for g in met["pursuer"] for h in met["evader"]]
        seeds = [
            training_seeds(self.settings.seed, g, h, Phase.ARCHIVE, 0, episodes) for g, h in pairs
        ]
        pursuers = self.population("pursuer", self.genomes("pursuer"))
        evaders = self.population("evader", self.genomes("evader"))
        g, h = np.repeat(pairs, episodes, axis=0).T
        scores = self.play(pursuers, evaders, (g, h, np.concatenate(seeds)))
        shape = len(met["pursuer"]), len(met["evader"]), episodes

        others = scores.others if team == "evader" else None
        values = scores.scores if others is None else others
        rates: FloatArray = values.mean(axis=1, dtype=np.float64).reshape(shape).mean(axis=2)
        if team == "pursuer":
            return rates
        return np.asarray(1.0 - rates.T if others is None else rates.T)
