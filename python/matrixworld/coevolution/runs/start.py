"""Start or take up a run of any kind."""

from __future__ import annotations

from pathlib import Path

from matrixworld.coevolution.opponents.registry import HALL_OF_FAME
from matrixworld.coevolution.progress import Report, silent
from matrixworld.coevolution.runs.alternating import Race
from matrixworld.coevolution.runs.hall_of_fame import HallOfFameRace
from matrixworld.coevolution.runs.single import SingleTeam
from matrixworld.coevolution.settings import RaceSettings, SingleSettings
from matrixworld.coevolution.storage.files import OtherVersionError
from matrixworld.coevolution.storage.run_directory import CONFIG, RunDirectory
from matrixworld.coevolution.storage.saved_run import SavedRun, open_run
from matrixworld.rollout import Rollout, rollout

AnyRun = Race | HallOfFameRace | SingleTeam

KINDS: dict[str, type[Race] | type[HallOfFameRace] | type[SingleTeam]] = {
    run.kind: run for run in (Race, HallOfFameRace, SingleTeam)
}


def start(
    settings: RaceSettings | SingleSettings,
    directory: str | Path,
    *,
    threads: int | None = None,
    play: Rollout = rollout,
) -> AnyRun:
    """Return a new run of the kind that the settings ask for (parameters as in `Run`)."""
    if isinstance(settings, SingleSettings):
        return SingleTeam(settings, directory, threads=threads, play=play)
    kind = HallOfFameRace if settings.schedule == HALL_OF_FAME else Race
    return kind(settings, directory, threads=threads, play=play)


def finish(
    settings: RaceSettings | SingleSettings,
    directory: str | Path,
    *,
    threads: int | None = None,
    play: Rollout = rollout,
    report: Report = silent,
) -> SavedRun:
    """Return the finished run of these settings: new, gone on with, or as it lies there.

    A program that calls it for each of its runs can be interrupted and called again. ValueError if
    the directory holds a run of other settings; otherwise raises as `start` and `resume` do.
    """
    if (Path(directory) / CONFIG).exists():
        run = resume(directory, threads=threads, play=play)
        if run.settings != settings:
            raise ValueError(f"{directory}: expected a run of {settings}, got {run.settings}")
    else:
        run = start(settings, directory, threads=threads, play=play)
    run.run(report)
    return open_run(directory)


def resume(directory: str | Path, *, threads: int | None = None, play: Rollout = rollout) -> AnyRun:
    """Return the run that a directory holds, as of its last checkpoint; its `run` goes on.

    FileNotFoundError if the directory holds no run, DamagedFileError if none of its checkpoints is
    whole, OtherVersionError if it is of another version, LockedError while another process runs it.
    """
    kind = RunDirectory.open(directory).config()["kind"]
    if kind not in KINDS:
        raise OtherVersionError(f"{directory}: expected a run of {', '.join(KINDS)}, got {kind!r}")
    return KINDS[kind].resume(directory, threads=threads, play=play)
