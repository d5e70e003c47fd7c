"""A run: stages of learning, each saved at its end, and then an evaluation.

This module tells what all kinds of runs share: how a run is made, continued and saved (`Run`), and
how one team learns for some epochs (`TeamPhase`). What a stage is, each kind of run says itself:
a phase of one team or a generation of both teams (`race`), or some epochs of a team that learns
alone (`single`).

Everything that a stage changes (learners, samplers, archive, counters, log) is saved at its end. A
run that is stopped within a stage, even by a power cut, repeats that stage when it is resumed, and
ends bit for bit as if it had never been stopped.
"""

from __future__ import annotations

import sys
from abc import ABC, abstractmethod
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path
from typing import Any, ClassVar, NamedTuple

import numpy as np

from matrixworld._util.checks import check_memory, check_threads, shown
from matrixworld._util.files import DamagedFileError
from matrixworld.coevolution.evaluation.tournament import tournament
from matrixworld.coevolution.fitness import win_rates
from matrixworld.coevolution.learners.learner import Learner
from matrixworld.coevolution.opponents.samplers import OpponentSampler, Stateless
from matrixworld.coevolution.progress import OnEpoch, Progress, Report, silent
from matrixworld.coevolution.runs.training_matches import TrainingMatches
from matrixworld.coevolution.schedules import Schedule
from matrixworld.coevolution.seeding import Purpose, keyed_generator, learning_phase, training_seeds
from matrixworld.coevolution.settings import RaceSettings, run_memory
from matrixworld.coevolution.storage import SEVERAL, Restored, RunDirectory
from matrixworld.coevolution.types import (
    TEAMS,
    FloatArray,
    Genome,
    Genomes,
    Indices,
    Payoff,
    Seeds,
    Stateful,
    Team,
)
from matrixworld.play.rollout import Rollout, rollout
from matrixworld.world.policy import Network, TeamPolicy


class Run(ABC):
    """A run in a directory; see `Race`, `HallOfFameRace` and `SingleTeam`.

    ::

        learners, archive (generation 0), stage = 0; saved
        while stage < n_stages:
            learn(stage); stage += 1; saved
        payoff = evaluate(); saved

    Parameters
    ----------
    settings : RaceSettings
        Settings of the run.
    directory : str, Path or RunDirectory
        A new or empty directory for a new run; a `RunDirectory` to continue the run in it.
    threads : int, optional
        Threads that `play` may use. By default all cores. Results do not depend on it.
    play : callable, optional
        Plays matches: a pure function with the arguments of `matrixworld.rollout`.

    Attributes
    ----------
    archive : dict of str to list of ndarray of float32, shape (genes,)
        Genomes of generations 0, 1, ... of each team.
    stage : int
        Number of finished stages.
    stage_capture_rates : list of float
        Mean capture rate in the second half of each finished stage.
    training : TrainingMatches
        Plays the training matches, and counts matches and steps.

    Raises
    ------
    FileExistsError
        If a directory for a new run is not empty.
    TypeError, ValueError
        If this kind of run cannot have these settings, or if the run needs more memory than the
        machine has available (`matrixworld.coevolution.settings.run_memory`).
    """

    schedule_class: ClassVar[type[Schedule]]
    stages_per_generation: ClassVar[int] = 1

    def __init__(
        self,
        settings: RaceSettings,
        directory: str | Path | RunDirectory,
        *,
        threads: int | None = None,
        play: Rollout = rollout,
    ) -> None:
        # Everything that can be wrong is checked before the directory is made.
        self.settings: RaceSettings = settings
        self.check_settings()
        self.schedule: Schedule = settings.schedule
        check_threads(threads)
        check_memory("run", **run_memory(settings))
        self.training: TrainingMatches = TrainingMatches(settings, play, threads)
        self.network: Network = self.training.network
        self.stage: int = 0
        self.stage_capture_rates: list[float] = []
        self.learners: dict[Team, Learner] = {
            team: settings.new_learner(team, self.first_population(team))
            for team in settings.learning_teams
        }
        self.archive: dict[Team, list[Genome]] = self.first_archive()
        self.set_up()
        self._report: Report = silent
        self._before: int = 0
        self._total_matches: int = 0
        self.files: RunDirectory
        if isinstance(directory, RunDirectory):
            self.files = directory
            with self.files.lock():
                self._restore()
        else:
            config = self.settings.to_json()
            self.files = RunDirectory.create(directory, config, **self.extra_config())
            self._write_new()

    @property
    def n_stages(self) -> int:
        """The number of stages: of each entry that the run adds to the archive of a team."""
        return self.stages_per_generation * (self.schedule.entries - 1)

    # Each kind of run defines the following methods:

    @abstractmethod
    def learn(self, stage: int) -> None:
        """Run one stage: improve learners, extend the archive, record each epoch."""

    @abstractmethod
    def finalists(self) -> dict[Team, tuple[TeamPolicy, int]]:
        """Return who plays the evaluation for each team, and the generation of the first."""

    @abstractmethod
    def total_matches(self) -> int:
        """Return the number of episodes in the whole run, including the evaluation."""

    # Each kind of run may replace the following methods:

    def first_population(self, team: Team) -> Genomes:
        """Return the genomes from which a learner starts; the first one is generation 0."""
        return self.settings.untrained(team, self.settings.learner.starting_genomes)

    def first_archive(self) -> dict[Team, list[Genome]]:
        """Return the archive of a new run."""
        # Copies here and below: a learner of the user's own may change its genome in place.
        return {team: [self.learners[team].genome.copy()] for team in TEAMS}

    def set_up(self) -> None:  # noqa: B027, optional
        """Make what else the run needs; called when learners and archive exist."""

    def stateful_parts(self) -> dict[str, Stateful]:
        """Return the parts of the run that a checkpoint saves and restores, by name."""
        return dict(self.learners.items())

    def extra_config(self) -> dict[str, Any]:
        """Return the entries of config.json besides the settings."""
        return {}

    # The following methods are the same for all kinds:

    def archive_genome(self, team: Team) -> None:
        """Add the genome of a team's learner to its archive; DivergedError if it is not finite."""
        genome = self.learners[team].genome.copy()
        self.archive[team].extend(self.training.population(genome).genomes)

    def check_settings(self) -> None:
        """Raise TypeError or ValueError if this kind of run cannot have these settings."""
        if not isinstance(self.settings, RaceSettings):
            raise TypeError(f"settings: expected RaceSettings, got {shown(self.settings)}")
        if not isinstance(self.settings.schedule, self.schedule_class):
            expected, got = self.schedule_class.kind, self.settings.schedule.kind
            raise ValueError(f"schedule: expected {expected}, got {got}")

    def run(self, report: Report = silent, on_epoch: OnEpoch | None = None) -> Payoff:
        """Continue from the last stage to the end; save and return the payoff.

        `report` is called often with the progress (see `ProgressBar`), and `on_epoch` with a row
        for each epoch (see `finish`). After KeyboardInterrupt or any other error, such as one that
        `on_epoch` raises, the files hold the last finished stage, from which `run` or `resume`
        continues.
        """
        self._report = report
        head = {"run": self.files.path.absolute().name, "seed": self.settings.seed}
        self.training.on_row = on_epoch and (
            lambda row: on_epoch({**head, "stage": self.stage + 1, **row})
        )
        with self.files.lock():
            # Also if this object has just been made: an interrupted stage has changed learners, and
            # another process may have continued the run.
            self._restore()
            self._before, self._total_matches = self.training.matches, self.total_matches()
            while self.stage < self.n_stages:
                try:
                    self.learn(self.stage)
                except Exception as error:
                    if sys.version_info >= (3, 11):
                        error.add_note(f"in stage {self.stage + 1} of the run {self.files.path}")
                    raise
                self.end_stage()
            if not self.files.finished:
                payoff = self.evaluate()
                self.files.save_results(payoff.arrays(), self.summary(payoff))
                return payoff
            self.files.summary()  # only to raise an error if it is damaged
            return self.files.payoff()

    def evaluate(self) -> Payoff:
        """Play the finalists of one team against those of the other, on episodes of their own."""
        settings = self.settings
        (pursuers, g), (evaders, h) = (self.finalists()[team] for team in TEAMS)
        return tournament(
            settings.world,
            pursuers,
            evaders,
            seed=settings.seed,
            episodes=settings.evaluation_episodes,
            threads=self.training.threads,
            play=self.training.rollout,
            first=(g, h),
            on_row=lambda played: self.report("tournament", played),
        )

    def genomes(self, team: Team) -> Genomes:
        """Return a team's archive as one array (generations, genes) float32."""
        archive = self.archive[team]
        return np.stack(archive) if archive else np.empty((0, self.network.genome_size), np.float32)

    def report(self, activity: str, evaluated: int = 0) -> None:
        """Report the progress: the current activity, and evaluation episodes played so far."""
        done = self.training.matches + evaluated
        self._report(Progress(activity, done, self._total_matches, self._before))

    def summary(self, payoff: Payoff) -> dict[str, Any]:
        """Return the most important numbers of the run, which summary.json holds."""
        counters = {f"training_{name}": n for name, n in self.training.counters().items()}
        return {"stages": self.stage, **counters, "evaluation_matches": int(payoff.lengths.size)}

    def end_stage(self) -> None:
        """Count and save a finished stage."""
        # In the second half of the epochs the team has mostly adapted to its opponents.
        rows = self.training.rows
        rates = [row["capture_rate"] for row in rows[len(rows) // 2 :]]
        self.stage_capture_rates.append(float(np.mean(rates)))
        self.stage += 1
        self._save()

    def _write_new(self) -> None:
        with self.files.lock():
            self.files.clear()
            self._save()
            # Last: a directory without config.json holds no run, and may be used again.
            self.files.write_config()

    def _save(self) -> None:
        counters = self.training.counters()
        if self.stage:
            counters["capture_rate"] = self.stage_capture_rates[-1]
        state = {
            f"{part}.{name}": value
            for part, stateful in self.stateful_parts().items()
            for name, value in stateful.state().items()
        }
        self.files.save(self.stage, self.archive, self.training.rows, counters, state)
        self.training.rows = []

    def _restore(self) -> None:
        restored = self.files.restore()
        try:
            self._take(restored)
        except DamagedFileError:
            raise
        except (IndexError, KeyError, OverflowError, TypeError, ValueError) as error:
            # Its checksum was correct: it is from other learners, or forged.
            problem = f"expected the state of a run of these settings ({error!r})"
            raise DamagedFileError(self.files.path, problem) from error

    def _take(self, restored: Restored) -> None:
        _, *stages = restored.stages  # stage 0 is before training
        self.stage = len(stages)
        self.stage_capture_rates = [float(each["capture_rate"]) for each in stages]
        self.training.restore(restored.stages[-1])
        for team in TEAMS:
            # In place, because other objects hold these lists.
            self.archive[team][:] = restored.archive[team]
        for part, stateful in self.stateful_parts().items():
            # "pursuer.sampler.x" belongs to the part "pursuer.sampler", not to "pursuer".
            keys = (key.rpartition(".") for key in restored.state)
            names = [name for prefix, _, name in keys if prefix == part]
            stateful.restore({name: restored.state[f"{part}.{name}"] for name in names})


# One team learns:


class Matchup(NamedTuple):
    """An epoch, its opponents (c,), and the match seed (n, c) of each candidate against each."""

    epoch: int
    opponents: Indices
    seeds: Seeds


@dataclass(frozen=True)
class TeamPhase:
    """Epochs in which one team learns a generation, against all available `opponents`.

    The learner is improved in place; the sampler chooses the opponents of each epoch, after which
    the run reports the `activity`.
    """

    run: Run
    team: Team
    generation: int
    opponents: TeamPolicy
    sampler: OpponentSampler
    activity: str

    def learn(self, epochs: range) -> None:
        """Let the team learn for `epochs`; each has its own random numbers."""
        learner = self.run.learners[self.team]
        for matchup in self._matchups(epochs):
            candidates = learner.ask(self._generator(Purpose.LEARN, matchup.epoch))
            learner.tell(self.evaluate(candidates, matchup))
            met = matchup.opponents
        training, opponents = self.run.training, self.opponents
        training.choose_champion(learner, self.team, self.generation, opponents, met)

    def evaluate(self, candidates: Genomes, matchup: Matchup) -> FloatArray:
        """Play and log the matches of an epoch; return the fitness (n,) of the candidates."""
        team, opponents, training = self.team, matchup.opponents, self.run.training
        scores = training.play_candidates(
            team, candidates, self.opponents, opponents, matchup.seeds
        )

        def table(values: FloatArray) -> FloatArray:
            return values.reshape(matchup.seeds.shape)

        # Win rates, not fitness: samplers expect numbers in [0, 1].
        if not isinstance(self.sampler, Stateless):
            self.sampler.tell(opponents, table(win_rates(scores, team)))
        fitness = training.fitness_of_epoch(
            scores,
            table,
            team=team,
            generation=self.generation,
            epoch=matchup.epoch,
            opponent=int(opponents[0]) if len(opponents) == 1 else SEVERAL,
        )
        learner, chosen = self.run.learners[team], np.tile(opponents, len(candidates))
        training.teach(learner, team, self.opponents, chosen, matchup.seeds.ravel())
        self.run.report(self.activity)
        return fitness

    def _matchups(self, epochs: range) -> Iterable[Matchup]:
        matchups = map(self._matchup, epochs)
        # A sampler without state can choose for all epochs ahead. Between matches, which fill the
        # caches with other data, the same work takes several times as long.
        return list(matchups) if isinstance(self.sampler, Stateless) else matchups

    def _matchup(self, epoch: int) -> Matchup:
        available = 1 if isinstance(self.opponents, str) else len(self.opponents.genomes)
        rng = self._generator(Purpose.OPPONENTS, epoch)
        opponents = self.sampler.sample(available, epoch, rng)
        # Candidates of the same match, such as a mirrored pair, differ in nothing but their genes.
        match = self.run.learners[self.team].seed_groups
        seeds = [self._seeds(int(opponent), epoch)[match] for opponent in opponents]
        return Matchup(epoch, opponents, np.stack(seeds, axis=1))

    def _seeds(self, opponent: int, epoch: int) -> Seeds:
        """Return the seeds of an epoch's matches against one opponent."""
        # Seeds depend on both generations, so that no two phases play the same episodes.
        own, seed = self.generation, self.run.settings.seed
        generations = (own, opponent) if self.team == "pursuer" else (opponent, own)
        count = int(self.run.learners[self.team].seed_groups.max()) + 1
        return training_seeds(seed, *generations, learning_phase(self.team), epoch, count)

    def _generator(self, purpose: Purpose, epoch: int) -> np.random.Generator:
        key = (TEAMS.index(self.team), self.generation, epoch)
        return keyed_generator(self.run.settings.seed, purpose, *key)
