"""Several runs as one job: created or resumed together, played one after the other."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any

import click

from matrixworld.analysis import Judgement, Summary, judge, summarize
from matrixworld.cli.arguments import UNMADE, place_in_job, resume_command
from matrixworld.cli.console import note, progress
from matrixworld.coevolution import (
    Payoff,
    RaceSettings,
    Report,
    Run,
    RunDirectory,
    SingleSettings,
    check_own_code,
    resume,
    start,
)
from matrixworld.coevolution.settings.memory import check_run_memory

RUNS = Path("runs")
"""Parent directory of runs for which no directory is given."""

Settings = RaceSettings | SingleSettings


@dataclass(frozen=True)
class Result:
    """A finished run. The payoff is held, so that figures and report need not read it again.

    Parameters
    ----------
    files : RunDirectory
        The run's directory.
    settings : RaceSettings or SingleSettings
        The run's settings.
    payoff : Payoff
        The content of payoff.npz.
    """

    files: RunDirectory
    settings: Settings
    payoff: Payoff

    @property
    def path(self) -> Path:
        """The run's directory."""
        return self.files.path

    @property
    def is_race(self) -> bool:
        """Whether both teams evolved."""
        return not isinstance(self.settings, SingleSettings)

    @cached_property
    def numbers(self) -> dict[str, Any]:
        """The content of summary.json."""
        return self.files.summary()

    @cached_property
    def summary(self) -> Summary:
        """The headline numbers of a race's payoff matrix."""
        return summarize(self.payoff.capture_rate)

    @cached_property
    def judgement(self) -> Judgement:
        """The judgement of a race, from the payoff that is held."""
        # Not from summary.json, which another version of the package may have written.
        return judge(self.payoff.capture_rates, per_episode=True)


def open_result(path: Path) -> Result:
    """Read a finished run; click.UsageError if it is not finished."""
    files = RunDirectory.open(path)
    settings = files.settings()
    if not files.finished:
        raise click.UsageError(
            f"{path}: expected a finished run; {resume_command(path)} continues it"
        )
    return Result(files, settings, Payoff.from_arrays(files.payoff()))


def default_directory(settings: Settings) -> Path:
    """Return the directory named after a run's variant and seed, such as ``runs/O-seed0``."""
    # Rules made in Python have no name.
    variant = settings.variant if isinstance(settings.variant, str) else "own-rules"
    # `against` may be the path of a run: its last part is the name.
    what = ""
    if isinstance(settings, SingleSettings):
        what = f"-{settings.team}-against-{Path(settings.against).name}"
    return RUNS / f"{variant}{what}-seed{settings.seed}"


def create_runs(settings: Sequence[Settings], output: Path, threads: int | None) -> list[Run[Any]]:
    """Create new runs: a single one in `output` itself, several in directories inside it.

    Nothing is written if a run needs too much memory, or a learner or sampler of the user's own is
    bad.
    """
    for each in settings:
        check_run_memory(each, threads)
        check_own_code(each)
    if len(settings) == 1:
        return [start(settings[0], output, threads=threads)]
    races = [each for each in settings if isinstance(each, RaceSettings)]
    # The order in which --resume finds them, so that it prints and draws the same.
    races.sort(key=lambda each: place_in_job(each.schedule))
    output.mkdir(parents=True, exist_ok=True)
    # The marker tells an incomplete job from a complete one: --resume must not play only some of
    # the runs that were asked for.
    (output / UNMADE).touch()
    runs: list[Run[Any]] = [start(each, output / each.schedule, threads=threads) for each in races]
    (output / UNMADE).unlink()
    return runs


def resume_runs(paths: Sequence[Path], threads: int | None) -> list[Run[Any]]:
    """Restore runs from their directories."""
    return [resume(path, threads=threads) for path in paths]


def play_runs(runs: Sequence[Run[Any]]) -> list[Result]:
    """Play each run to its end, with one progress bar for all."""
    # The bar needs the matches of the whole job before the first run starts.
    counts = [_matches(run) for run in runs]
    whole = sum(total for _, total in counts)
    results = []
    with progress() as report:
        for number, run in enumerate(runs):
            place = f"[{number + 1}/{len(runs)}] " if len(runs) > 1 else ""
            # Runs before this one are finished; later ones may have been resumed half-way.
            before = sum(total for _, total in counts[:number])
            after = sum(done for done, _ in counts[number + 1 :])
            if counts[number][0] < counts[number][1]:
                note(f"{place}{run.files.path}")
            # A finished run plays nothing, and returns its payoff from the file.
            payoff = run.run(part_of_job(report, place, before + after, whole))
            results.append(Result(run.files, run.settings, payoff))
    return results


def part_of_job(report: Report, place: str, others: int, whole: int) -> Report:
    """Return a report of one run as part of a job, in which other runs have played `others`."""
    return lambda what, done, total: report(place + what, others + done, whole)


def _matches(run: Run[Any]) -> tuple[int, int]:
    """Return the matches that a run has played, and all of them."""
    total = run.total_matches()
    # `training.matches` does not count those of the evaluation, which a finished run has played.
    return total if run.files.finished else run.training.matches, total
