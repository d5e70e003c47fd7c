"""Several runs as one job: made together, played one after the other."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import chain, count
from pathlib import Path

from matrixworld.cli.arguments import UNMADE
from matrixworld.cli.progress import note, progress
from matrixworld.coevolution import RaceSettings, Report, SingleSettings, resume, start

RUNS = Path("runs")
"""Where runs go that were given no place."""

Settings = RaceSettings | SingleSettings


def fresh_directory(settings: Settings) -> Path:
    """A directory that does not exist yet, named after the run: ``runs/O-seed0``."""
    variant = settings.variant if isinstance(settings.variant, str) else "own-rules"
    what = ""
    if isinstance(settings, SingleSettings):
        what = f"-{settings.team}-against-{Path(settings.against).name}"
    name = f"{variant}{what}-seed{settings.seed}"
    names = chain([name], (f"{name}-{number}" for number in count(2)))
    return next(RUNS / name for name in names if not (RUNS / name).exists())


def create_runs(settings: Sequence[Settings], output: Path, threads: int | None) -> list[Path]:
    """Make the directories of new runs, one that is `output` itself or several inside it."""
    if len(settings) == 1:
        start(settings[0], output, threads=threads)
        return [output]
    paths = [output / each.schedule for each in settings if isinstance(each, RaceSettings)]
    output.mkdir(parents=True, exist_ok=True)
    (output / UNMADE).touch()
    for each, path in zip(settings, paths, strict=True):
        start(each, path, threads=threads)
    (output / UNMADE).unlink()
    return paths


def play_runs(paths: Sequence[Path], threads: int | None) -> None:
    """Go on with each run to its end."""
    counts = [_matches(path) for path in paths]
    whole = sum(total for _, total in counts)
    with progress() as report:
        for number, path in enumerate(paths):
            place = f"[{number + 1}/{len(paths)}] " if len(paths) > 1 else ""
            before = sum(total for _, total in counts[:number])
            after = sum(done for done, _ in counts[number + 1 :])
            if counts[number][0] < counts[number][1]:
                note(f"{place}{path}")
            resume(path, threads=threads).run(_part(report, place, before + after, whole))


def _part(report: Report, place: str, others: int, whole: int) -> Report:
    """Reports of one run as reports of the job, in which others have played some matches."""
    return lambda what, done, total: report(place + what, others + done, whole)


def _matches(path: Path) -> tuple[int, int]:
    """The matches that a run has played, and all."""
    run = resume(path)
    total = run.total_matches()
    return total if run.files.finished else run.training.matches, total
