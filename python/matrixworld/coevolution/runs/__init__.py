"""Runs: training from the first epoch to the evaluation, in a directory that can be resumed.

Read `run` first: what a stage is, how a team learns in it, and what is saved. Each kind of run says
how its stages are played: `race`, `map_race` and `single`. Here runs of any kind are started,
resumed and finished.
"""

from __future__ import annotations

from pathlib import Path

from matrixworld._util.checks import shown
from matrixworld.coevolution.progress import OnEpoch, Report, silent
from matrixworld.coevolution.runs.map_race import MapRace
from matrixworld.coevolution.runs.race import HallOfFameRace, Race, YokedRace
from matrixworld.coevolution.runs.single import SingleTeam
from matrixworld.coevolution.settings import RaceSettings
from matrixworld.coevolution.storage import SavedRun, check_empty, open_run
from matrixworld.play.rollout import Rollout, rollout

AnyRun = Race | HallOfFameRace | YokedRace | MapRace | SingleTeam

RUN_CLASSES: dict[str, type[AnyRun]] = {
    run.schedule_class.kind: run for run in (Race, HallOfFameRace, YokedRace, MapRace, SingleTeam)
}


def start(
    settings: RaceSettings,
    directory: str | Path,
    *,
    threads: int | None = None,
    play: Rollout = rollout,
) -> AnyRun:
    """Return a new run of the kind that the settings define; its method `run` trains and evaluates.

    Parameters
    ----------
    settings, directory, threads, play
        As in `Run`, whose errors this function raises, but the directory must be new or empty.
    """
    if Path(directory).exists():
        check_empty(Path(directory))
    return _run(settings, directory, threads, play)


def resume(directory: str | Path, *, threads: int | None = None, play: Rollout = rollout) -> AnyRun:
    """Return the run in a directory, as of its last finished stage.

    Parameters
    ----------
    directory : str or Path
        The run directory.
    threads, play
        As in `Run`.

    Raises
    ------
    FileNotFoundError
        If the directory holds no run.
    DamagedFileError
        If no stage is intact that has a checkpoint.
    OtherVersionError
        If the run is of another version of the package.
    LockedError
        If another process runs it.
    """
    return _run(SavedRun(directory).settings, directory, threads, play)


def finish(
    settings: RaceSettings,
    directory: str | Path,
    *,
    threads: int | None = None,
    play: Rollout = rollout,
    report: Report = silent,
    on_epoch: OnEpoch | None = None,
) -> SavedRun:
    """Return the finished run of these settings: start it, continue it, or only open it.

    A program that calls it for each of its runs can be interrupted and called again.

    Parameters
    ----------
    settings, directory, threads, play
        As in `Run`, whose errors this function raises.
    report : callable, optional
        Called with the progress, as in `Run.run`.
    on_epoch : callable, optional
        Called after each epoch with a dict: the columns of ``log.csv`` (numbers, and the name of
        the ``team``), ``run`` (name of the directory) and ``seed``. The files of the run are the
        same with and without it. What it raises ends this call, which may be repeated to continue
        from the last finished stage; an epoch that is played again is told again.

    Raises
    ------
    StopRun
        If `on_epoch` raises it, to end a run that is not worth its time.
    """
    _run(settings, directory, threads, play).run(report, on_epoch)
    return open_run(directory)


def _run(
    settings: RaceSettings, directory: str | Path, threads: int | None, play: Rollout
) -> AnyRun:
    if not isinstance(settings, RaceSettings):
        raise TypeError(f"settings: expected RaceSettings, got {shown(settings)}")
    return RUN_CLASSES[settings.schedule.kind](settings, directory, threads=threads, play=play)


def check_own_code(settings: RaceSettings) -> None:
    """Make the learners and samplers of a run once; ValueError or PluginError if one fails."""
    for team in settings.learning_teams:
        genomes = settings.learner_of(team).starting_genomes
        settings.new_learner(team, settings.untrained(team, genomes))
        settings.schedule.new_sampler(team)
