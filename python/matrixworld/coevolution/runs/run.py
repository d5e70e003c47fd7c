"""A run: stages of learning with a checkpoint after each, then an evaluation.

Subclasses define what a stage is. Everything that a stage changes (learners, archive, counters,
log) is saved at its end. A run that is stopped within a stage, even by a power cut, repeats that
stage when it is resumed, and ends bit for bit as if it had never been stopped.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from pathlib import Path
from typing import Any, ClassVar, Generic, TypeVar

import numpy as np

from matrixworld._util.checks import check_threads
from matrixworld._util.memory import check_memory
from matrixworld._util.reading import DamagedFileError
from matrixworld.coevolution.learners.learner import Learner
from matrixworld.coevolution.learners.registry import new_learner, starting_genomes, untrained
from matrixworld.coevolution.payoff import Payoff
from matrixworld.coevolution.progress import Report, silent
from matrixworld.coevolution.runs.training import Training
from matrixworld.coevolution.settings.memory import run_memory
from matrixworld.coevolution.settings.race import RaceSettings
from matrixworld.coevolution.settings.single import SingleSettings
from matrixworld.coevolution.settings.training import settings_to_json
from matrixworld.coevolution.storage.run_directory import Checkpoint, RunDirectory
from matrixworld.coevolution.types import TEAMS, Genome, Genomes, State, Stateful, Team
from matrixworld.play.rollout import Rollout, rollout
from matrixworld.world.policy import Network

AnySettings = TypeVar("AnySettings", RaceSettings, SingleSettings)
AnyRun = TypeVar("AnyRun", bound="Run[Any]")


class Run(ABC, Generic[AnySettings]):
    """A run in a directory; see `Race`, `HallOfFameRace` and `SingleTeam`.

    Parameters
    ----------
    settings : RaceSettings or SingleSettings
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
    training : Training
        Plays the training matches, and counts matches and steps.

    Raises
    ------
    FileExistsError
        If a directory for a new run is not empty.
    TypeError, ValueError
        If this kind of run cannot have these settings, or if the run needs more memory than the
        machine has available (`matrixworld.coevolution.settings.memory.run_memory`).
    """

    kind: ClassVar[str]
    settings_class: ClassVar[type[Any]]

    def __init__(
        self,
        settings: AnySettings,
        directory: str | Path | RunDirectory,
        *,
        threads: int | None = None,
        play: Rollout = rollout,
    ) -> None:
        # Everything that can be wrong is checked before the directory is made.
        self.settings: AnySettings = settings
        self.check_settings()
        check_threads(threads)
        check_memory("run", **run_memory(settings))
        self.training: Training = Training(settings, play, threads)
        self.network: Network = self.training.network
        self.stage: int = 0
        self.stage_capture_rates: list[float] = []
        count = starting_genomes(settings)
        self.learners: dict[Team, Learner] = {
            team: new_learner(settings, team, self.first_population(team, count))
            for team in self.learning_teams()
        }
        self.archive: dict[Team, list[Genome]] = self.first_archive()
        self.set_up()
        self._report: Report = silent
        self._total_matches: int = 0
        self.files: RunDirectory
        if isinstance(directory, RunDirectory):
            self.files = directory
            with self.files.lock():
                self._restore()
        else:
            config = settings_to_json(self.settings)
            self.files = RunDirectory.create(directory, self.kind, config, **self.extra_config())
            self._write_new()

    @classmethod
    def resume(
        cls: type[AnyRun],
        directory: str | Path,
        *,
        threads: int | None = None,
        play: Rollout = rollout,
    ) -> AnyRun:
        """Return the run in a directory, as of its last checkpoint.

        Parameters
        ----------
        directory : str or Path
            The run directory.
        threads, play
            As for a new run.

        Returns
        -------
        Run
            Its method `run` continues the training.

        Raises
        ------
        ValueError
            If the run is of another kind or version.
        LockedError
            If another process runs it.
        """
        files = RunDirectory.open(directory)
        config = files.config()
        if config["kind"] != cls.kind:
            raise ValueError(f"{directory}: expected a {cls.kind} run, got {config['kind']!r}")
        return cls(files.settings(), files, threads=threads, play=play)

    # Each kind of run defines the following methods:

    @property
    @abstractmethod
    def n_stages(self) -> int:
        """The number of stages."""

    @abstractmethod
    def learning_teams(self) -> tuple[Team, ...]:
        """Return the teams that learn."""

    @abstractmethod
    def learn(self, stage: int) -> None:
        """Run one stage: improve learners, extend the archive, record each epoch."""

    @abstractmethod
    def evaluate(self) -> Payoff:
        """Return the payoff of the archive."""

    @abstractmethod
    def total_matches(self) -> int:
        """Return the number of episodes in the whole run, including the evaluation."""

    # Each kind of run may replace the following methods:

    def first_population(self, team: Team, count: int) -> Genomes:
        """Return `count` genomes from which a learner starts; the first one is generation 0."""
        return untrained(self.settings, team, count)

    def first_archive(self) -> dict[Team, list[Genome]]:
        """Return the archive of a new run."""
        return {team: [self.learners[team].genome] for team in TEAMS}

    def set_up(self) -> None:
        """Make what else the run needs; called when learners and archive exist."""

    def stateful_parts(self) -> dict[str, Stateful]:
        """Return the parts of the run that a checkpoint saves and restores, by name."""
        return dict(self.learners.items())

    def extra_config(self) -> dict[str, Any]:
        """Return the entries of config.json besides the settings."""
        return {}

    def check_settings(self) -> None:
        """Raise TypeError or ValueError if this kind of run cannot have these settings."""
        if not isinstance(self.settings, self.settings_class):
            expected, got = self.settings_class.__name__, type(self.settings).__name__
            raise TypeError(f"settings: expected {expected}, got {got}")

    def warn(self) -> None:
        """Warn of problems in training; called after each stage."""

    # The following methods are the same for all kinds:

    def run(self, report: Report = silent) -> Payoff:
        """Continue from the last checkpoint to the end; save and return the payoff.

        Parameters
        ----------
        report : callable, optional
            Called often with the progress (see `ProgressBar`).

        Returns
        -------
        Payoff
            Results of the evaluation.

        Notes
        -----
        After KeyboardInterrupt or any other error the files hold the last finished stage, from
        which `run` or `resume` continues.
        """
        self._report = report
        with self.files.lock():
            # Also if this object has just been made: an interrupted stage has changed learners, and
            # another process may have continued the run.
            self._restore()
            self._total_matches = self.total_matches()
            while self.stage < self.n_stages:
                self.learn(self.stage)
                self._end_stage()
            if not self.files.finished:
                return self._finish()
            self.files.summary()  # only to raise an error if it is damaged
            return self.payoff()

    def payoff(self) -> Payoff:
        """Return the saved payoff; FileNotFoundError before the run has finished."""
        return Payoff.from_arrays(self.files.payoff())

    def genomes(self, team: Team) -> Genomes:
        """Return a team's archive as one array (generations, genes) float32."""
        archive = self.archive[team]
        return np.stack(archive) if archive else np.empty((0, self.network.genome_size), np.float32)

    def report(self, activity: str, evaluated: int = 0) -> None:
        """Report the progress: the current activity, and evaluation episodes played so far."""
        self._report(activity, self.training.matches + evaluated, self._total_matches)

    def summary(self, payoff: Payoff) -> dict[str, Any]:
        """Return the most important numbers of the run, which summary.json holds."""
        return {
            "stages": self.stage,
            "training_matches": self.training.matches,
            "training_steps": self.training.steps,
            "training_agent_steps": self.training.agent_steps,
            "evaluation_matches": int(payoff.lengths.size),
        }

    def _end_stage(self) -> None:
        # In the second half of the epochs the team has mostly adapted to its opponents.
        rows = self.training.rows
        rates = [row["capture_rate"] for row in rows[len(rows) // 2 :]]
        self.stage_capture_rates.append(float(np.mean(rates)))
        self.stage += 1
        self._save()
        self.warn()

    def _finish(self) -> Payoff:
        payoff = self.evaluate()
        # The summary is the last file: a run is finished when it exists.
        self.files.save_payoff(payoff.arrays())
        self.files.save_summary(self.summary(payoff))
        return payoff

    def _write_new(self) -> None:
        with self.files.lock():
            self.files.clear()
            self._save()
            # Last: a directory without config.json holds no run, and may be used again.
            self.files.write_config()

    def _save(self) -> None:
        state: dict[str, Any] = {
            "stage": self.stage,
            "matches": self.training.matches,
            "steps": self.training.steps,
            "agent_steps": self.training.agent_steps,
            "stage_capture_rates": np.array(self.stage_capture_rates, dtype=np.float64),
        }
        for part, stateful in self.stateful_parts().items():
            state |= {f"{part}.{name}": value for name, value in stateful.state().items()}
        self.files.save(self.archive, self.training.rows, state)
        self.training.rows = []

    def _restore(self) -> None:
        checkpoint = self.files.restore()
        try:
            self._take(checkpoint)
        except DamagedFileError:
            raise
        except (IndexError, KeyError, OverflowError, TypeError, ValueError) as error:
            # Its checksum was correct: it is from other learners, or forged.
            problem = f"expected the state of a run of these settings ({error!r})"
            raise DamagedFileError(self.files.path / "checkpoint.npz", problem) from error

    def _take(self, checkpoint: Checkpoint) -> None:
        state = checkpoint.state
        self.stage = int(state["stage"])
        self.stage_capture_rates = state["stage_capture_rates"].tolist()
        for counter in ("matches", "steps", "agent_steps"):
            setattr(self.training, counter, int(state[counter]))
        self.training.rows = []
        for team in TEAMS:
            # In place, because other objects hold these lists.
            self.archive[team][:] = checkpoint.archive[team]
        for part, stateful in self.stateful_parts().items():
            stateful.restore(_state_of(part, state))


def _state_of(part: str, state: State) -> State:
    """Return the arrays of one part, by their names in it."""
    # "pursuer.x" belongs to the part "pursuer", "pursuer.sampler.x" to the part "pursuer.sampler".
    keys = (key.rpartition(".") for key in state)
    return {name: state[f"{part}.{name}"] for prefix, _, name in keys if prefix == part}
