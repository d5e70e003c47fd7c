"""Start, resume or finish a run of any kind."""

from __future__ import annotations

from pathlib import Path

from matrixworld._util.checks import shown
from matrixworld.coevolution.progress import OnEpoch, Report, silent
from matrixworld.coevolution.runs.race import HallOfFameRace, Race, YokedRace
from matrixworld.coevolution.runs.single import SingleTeam
from matrixworld.coevolution.schedules import RaceSchedule
from matrixworld.coevolution.sections import different_settings
from matrixworld.coevolution.settings import RaceSettings
from matrixworld.coevolution.storage import CONFIG, RunDirectory, SavedRun, open_run
from matrixworld.play.rollout import Rollout, rollout

AnyRun = Race | HallOfFameRace | YokedRace | SingleTeam

RUN_CLASSES: dict[str, type[Race] | type[HallOfFameRace] | type[YokedRace] | type[SingleTeam]] = {
    run.schedule_class.kind: run for run in (Race, HallOfFameRace, YokedRace, SingleTeam)
}


def start(
    settings: RaceSettings,
    directory: str | Path | RunDirectory,
    *,
    threads: int | None = None,
    play: Rollout = rollout,
) -> AnyRun:
    """Return a new run of the kind that the settings define; its method `run` trains and evaluates.

    Parameters
    ----------
    settings, directory, threads, play
        As in `Run`, whose errors this function raises.
    """
    if not isinstance(settings, RaceSettings):
        raise TypeError(f"settings: expected RaceSettings, got {shown(settings)}")
    return RUN_CLASSES[settings.schedule.kind](settings, directory, threads=threads, play=play)


def check_same(path: Path, found: RaceSettings, expected: RaceSettings) -> None:
    """Raise ValueError if a directory holds a run of other settings than expected."""
    different = different_settings(found, expected)
    if different:
        raise ValueError(f"{path}: holds a run with other settings: {', '.join(different)}")


def check_own_code(settings: RaceSettings) -> None:
    """Make the learners and samplers of a run once; ValueError or PluginError if one fails."""
    genomes, schedule = settings.learner.starting_genomes, settings.schedule
    for team in settings.learning_teams:
        settings.new_learner(team, settings.untrained(team, genomes))
        if isinstance(schedule, RaceSchedule):
            schedule.new_sampler(team)


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
        As in `Run`.
    report : callable, optional
        Called with the progress, as in `Run.run`.
    on_epoch : callable, optional
        Called after each epoch with a dict: the columns of ``log.csv`` (numbers, and the name of
        the ``team``), ``run`` (name of the directory) and ``seed``. The files of the run are the
        same with and without it. What it raises ends this call, which may be repeated to continue
        from the last finished stage; an epoch that is played again is told again.

    Raises
    ------
    ValueError
        If the directory holds a run of other settings. Other errors are those of `start` and
        `resume`.
    StopRun
        If `on_epoch` raises it, to end a run that is not worth its time.
    """
    # Without config.json the directory is empty, or holds a run that was never completely made.
    if (Path(directory) / CONFIG).exists():
        run = resume(directory, threads=threads, play=play)
        check_same(Path(directory), run.settings, settings)
    else:
        run = start(settings, directory, threads=threads, play=play)
    run.run(report, on_epoch)
    return open_run(directory)


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
    files = RunDirectory.open(directory)
    return start(files.settings, files, threads=threads, play=play)
