"""A run: stages of learning with a checkpoint after each, then an evaluation.

Subclasses say what a stage is. Everything that a stage changes (learners, archive, counters, log)
is saved when it ends; a run stopped inside a stage, however roughly, goes back to its beginning
and ends bit for bit as if it had never been stopped.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from pathlib import Path
from typing import Any, ClassVar, Generic, Protocol, TypeVar

import numpy as np

from matrixworld.coevolution.learners.registry import new_learner, starting_genomes, untrained
from matrixworld.coevolution.payoff import Payoff
from matrixworld.coevolution.progress import Report, silent
from matrixworld.coevolution.runs.training import Training
from matrixworld.coevolution.settings import RaceSettings, SingleSettings
from matrixworld.coevolution.settings_json import settings_to_json
from matrixworld.coevolution.storage.run_directory import RunDirectory
from matrixworld.coevolution.types import TEAMS, Genome, Genomes, State, Team
from matrixworld.policy import Network
from matrixworld.rollout import Rollout, rollout


class Stateful(Protocol):
    """What a checkpoint saves and restores: a learner, or a selection of opponents."""

    def state(self) -> State:
        """Return all that changes, as plain arrays."""

    def restore(self, state: State) -> None:
        """Take up a state that `state` returned."""


AnySettings = TypeVar("AnySettings", RaceSettings, SingleSettings)
AnyRun = TypeVar("AnyRun", bound="Run[Any]")


class Run(ABC, Generic[AnySettings]):
    """A run in a directory; see `Race`, `HallOfFameRace` and `SingleTeam`.

    Parameters
    ----------
    settings : what is run.
    directory : a new or empty directory; FileExistsError if it holds anything.
    threads : handed to `play`; None: all cores. Results do not depend on it.
    play : scores matches; a pure function with the arguments of `matrixworld.rollout`.

    Attributes
    ----------
    archive : per team the genomes (genes,) float32 of generations 0, 1, ...
    stage, n_stages : finished stages, and all.
    captures : mean capture rate in the second half of each finished stage.
    training : counts episodes and steps.
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
        self.settings: AnySettings = settings
        self.check_settings()
        self.training = Training(settings, play, threads)
        self.network: Network = self.training.network
        self.stage = 0
        self.captures: list[float] = []
        count = starting_genomes(settings)
        self.learners = {
            team: new_learner(settings, team, self.first_population(team, count))
            for team in self.learning_teams()
        }
        self.archive: dict[Team, list[Genome]] = self.first_archive()
        self.begin()
        self._report: Report = silent
        if isinstance(directory, RunDirectory):
            self.files = directory
            with self.files.lock():
                self._restore()
        else:
            config = settings_to_json(self.settings)
            self.files = RunDirectory.create(directory, self.kind, config, **self.more_config())
            self._write_new()

    @classmethod
    def resume(
        cls: type[AnyRun],
        directory: str | Path,
        *,
        threads: int | None = None,
        play: Rollout = rollout,
    ) -> AnyRun:
        """Return the run that a directory holds, as of its last checkpoint; `run` goes on.

        ValueError if it is of another kind or version, LockedError while another process runs it.
        """
        files = RunDirectory.open(directory)
        config = files.config()
        if config["kind"] != cls.kind:
            raise ValueError(f"{directory}: expected a {cls.kind} run, got {config['kind']!r}")
        return cls(files.settings(), files, threads=threads, play=play)

    # What each kind of run says:

    @property
    @abstractmethod
    def n_stages(self) -> int:
        """The number of stages."""

    @abstractmethod
    def learning_teams(self) -> tuple[Team, ...]:
        """Return the teams that learn."""

    @abstractmethod
    def learn(self, stage: int) -> None:
        """Do one stage: improve learners, extend the archive, record each epoch."""

    @abstractmethod
    def evaluate(self) -> Payoff:
        """Return what the archive scores."""

    @abstractmethod
    def total_matches(self) -> int:
        """Return the episodes of the whole run, evaluation included."""

    def first_population(self, team: Team, count: int) -> Genomes:
        """Return `count` genomes from which a learner starts; the first is generation 0."""
        return untrained(self.settings, team, count)

    def first_archive(self) -> dict[Team, list[Genome]]:
        """Return the archive of a run that has not begun."""
        return {team: [self.learners[team].genome] for team in TEAMS}

    def begin(self) -> None:
        """Set up what else the run needs, once there are learners and an archive."""

    def stateful(self) -> dict[str, Stateful]:
        """Return all that a checkpoint saves and restores, by name."""
        return dict(self.learners.items())

    def more_config(self) -> dict[str, Any]:
        """Return what config.json holds beside the settings."""
        return {}

    def check_settings(self) -> None:
        """Raise TypeError or ValueError if this kind of run cannot have these settings."""
        if not isinstance(self.settings, self.settings_class):
            expected, got = self.settings_class.__name__, type(self.settings).__name__
            raise TypeError(f"settings: expected {expected}, got {got}")

    def after_stage(self) -> None:
        """Look at the run after each stage; may warn."""

    # The run:

    def run(self, report: Report = silent) -> Payoff:
        """Go on from the last checkpoint to the end; return (and save) the payoff.

        `report` is called often with the progress (see `ProgressBar`). On KeyboardInterrupt, or
        any other error, the files hold the last finished stage; `run` or `resume` goes on.
        """
        self._report = report
        with self.files.lock():
            self._restore()
            while self.stage < self.n_stages:
                self.learn(self.stage)
                self._end_stage()
            if not self.files.finished:
                self._finish()
            self.files.summary()  # or an error, if it is damaged
        return self.payoff()

    def payoff(self) -> Payoff:
        """Return the saved payoff; FileNotFoundError before the run has finished."""
        return Payoff.from_arrays(self.files.payoff())

    def genomes(self, team: Team) -> Genomes:
        """Return a team's archive as one array (generations, genes) float32."""
        archive = self.archive[team]
        return np.stack(archive) if archive else np.empty((0, self.network.genome_size), np.float32)

    def report(self, what: str, evaluated: int = 0) -> None:
        """Report the progress: what is going on, and the episodes of the evaluation so far."""
        self._report(what, self.training.matches + evaluated, self.total_matches())

    def summary(self, payoff: Payoff) -> dict[str, Any]:
        """Return the run in a few numbers, as summary.json holds them."""
        return {
            "training_matches": self.training.matches,
            "training_steps": self.training.steps,
            "evaluation_matches": int(payoff.lengths.size),
        }

    def _end_stage(self) -> None:
        rows = self.training.rows
        rates = [row["capture_rate"] for row in rows[len(rows) // 2 :]]
        self.captures.append(float(np.mean(rates)))
        self.stage += 1
        self._save()
        self.after_stage()

    def _finish(self) -> None:
        payoff = self.evaluate()
        self.files.save_payoff(payoff.arrays())
        self.files.save_summary(self.summary(payoff))

    # Its files:

    def _write_new(self) -> None:
        with self.files.lock():
            self.files.clear()
            self._save()
            self.files.write_config()

    def _save(self) -> None:
        state: dict[str, Any] = {
            "stage": self.stage,
            "matches": self.training.matches,
            "steps": self.training.steps,
            "captures": np.array(self.captures, dtype=np.float64),
        }
        for owner, each in self.stateful().items():
            state |= {f"{owner}.{name}": value for name, value in each.state().items()}
        self.files.save({t: self.genomes(t) for t in TEAMS}, self.training.rows, state)
        self.training.rows = []

    def _restore(self) -> None:
        saved = self.files.restore()
        state = saved.state
        self.stage, self.captures = int(state["stage"]), state["captures"].tolist()
        self.training.matches, self.training.steps = int(state["matches"]), int(state["steps"])
        self.training.rows = []
        for team in TEAMS:  # in place: others hold the lists
            self.archive[team][:] = saved.archive[team]
        for owner, each in self.stateful().items():
            each.restore(_of_owner(owner, state))


def _of_owner(owner: str, state: dict[str, Any]) -> dict[str, Any]:
    """Return the state of one owner, without those whose names begin with its own."""
    split = (key.rpartition(".") for key in state)
    return {name: state[f"{owner}.{name}"] for prefix, _, name in split if prefix == owner}
