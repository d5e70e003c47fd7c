"""What ``matrixworld evolve`` draws, writes and prints when its runs are finished.

It prints what a newcomer asks first; tables and intervals are those of ``judge`` and ``score``.
"""

from __future__ import annotations

import textwrap
import time
from collections.abc import Mapping, Sequence
from pathlib import Path

from tqdm import tqdm

from matrixworld._util.files import save_json
from matrixworld.analysis import headline
from matrixworld.analysis.words import headline_numbers
from matrixworld.cli.console import WIDEST, command, print_table, print_wrapped, progress, say
from matrixworld.cli.pages import write_explorer
from matrixworld.cli.runs import print_missing, seeds_finished
from matrixworld.coevolution import Against, Progress, SavedRun
from matrixworld.coevolution.evaluation.scores import kept_scores
from matrixworld.coevolution.groups import RunGroup, grouped
from matrixworld.coevolution.jobs import Job
from matrixworld.coevolution.types import TEAMS, other
from matrixworld.explorer.runs_page import PAGE

SUMMARY = "summary.json"
WIDEST_NAME = 28
"""Longer names of groups have a line of their own."""
HELD_OUT = "\nAgainst opponents nobody trained on (1 = best)"


def report(
    job: Job,
    results: Sequence[SavedRun],
    root: Path,
    failed: Mapping[Path, str],
    threads: int | None = None,
    *,
    began: float | None = None,
    again: str = "",
) -> None:
    """Score and judge the finished runs of a job, draw figures, and print the results.

    `failed` says why the other runs of the job failed, by their directories; `began` is when the
    job began, by `time.monotonic`, `again` the command that plays more seeds.
    """
    runs = {root / name: settings for name, settings in job.items()}
    groups = grouped(runs, finished=[run.path for run in results])
    groups = [group.inside(root) for group in groups]
    finished = [group for group in groups if group.runs]
    races = [group for group in finished if group.is_race]
    with progress() as bar:
        kept_scores([run for g in races for run in g.runs], threads=threads, report=bar)
    if finished:
        draw(finished, root)
    # The summary of a run that was started by itself lies in the same directory.
    if root not in [run.path for run in results]:
        _save(groups, root, failed)
    what = "races" if len(races) == len(finished) else "runs"
    done = f"1 {what[:-1]} done" if len(results) == 1 else f"{len(results)} {what} done"
    took = "" if began is None else f" in {tqdm.format_interval(time.monotonic() - began)}"
    page = f" Open {root / PAGE}" if finished else ""
    say(f"{done}{took}.{page}\n", bold=True)
    _print_groups(groups)
    if races:
        say(HELD_OUT, bold=True)
        print_table([("", "pursuers", "evaders"), *map(_held_out_row, races)], "<>>")
    for path, problem in failed.items():
        print_wrapped(f"Failed: {path}: {problem}")
    if finished:
        say()
        _print_hints(_hints(finished, root, again))


def draw(groups: Sequence[RunGroup], root: Path) -> None:
    """Draw the figures and write the page; figures of an earlier report are replaced."""
    from matrixworld import plots
    from matrixworld.plots.saved import figures_of

    files = figures_of(groups, root)
    with progress("files") as bar:
        for number, (file, figure) in enumerate(files.items()):
            bar(Progress("figures, page", number, len(files) + 1))
            plots.save_figure(figure(), file)
        write_explorer(groups, root / PAGE)
        bar(Progress("figures, page", len(files) + 1, len(files) + 1))


# What is printed:


def _print_groups(groups: Sequence[RunGroup]) -> None:
    width = max([len(each.name) for each in groups if len(each.name) <= WIDEST_NAME], default=0)
    for group in groups:
        lines = [part for line in _lines(group) for part in textwrap.wrap(line, WIDEST - width - 2)]
        if len(group.name) > width:
            lines = ["", *lines]
        for number, line in enumerate(lines):
            say(f"{group.name * (number == 0):{width}}  {line}".rstrip())
        print_missing(group)


def _lines(group: RunGroup) -> list[str]:
    if not group.runs:
        return [seeds_finished(group)]
    if group.is_race:
        return [headline(group.judgement), *headline_numbers(group.judgement)]
    schedule, means = group.runs[0].settings.schedule, group.means()
    assert isinstance(schedule, Against)  # one team evolved
    return [
        f"capture rate {means['capture_rate']}",
        f"{schedule.team}s after {schedule.epochs:,} epochs against {schedule.opponent}",
        f"an episode takes {means['length'].value:.0f} steps",
    ]


def _held_out_row(group: RunGroup) -> tuple[str, ...]:
    return group.name, *(f"{group.held_out(team).mean():.2f}" for team in TEAMS)


def _hints(groups: Sequence[RunGroup], root: Path, again: str) -> list[tuple[str, str]]:
    last = groups[-1].runs[-1]
    schedule = last.settings.schedule
    path = root if sum(len(group.runs) for group in groups) == 1 else last.path
    if isinstance(schedule, Against):
        team = f"--set schedule.team={other(schedule.team)}"
        opponent = command("evolve --schedule against", team, f"--set schedule.opponent={path}")
        return [("Watch it:", command("replay", path)), ("Its opponent learns:", opponent)]
    more = ("Verdict on each seed:", command("judge --each", root))
    if not any(group.several for group in groups):
        more = ("One seed proves little:", again or command("evolve --seeds 0-9"))
    return [more, ("Reasons and intervals:", command("judge --explain", root))]


def _print_hints(hints: Sequence[tuple[str, str]]) -> None:
    width = max(len(why) for why, _ in hints)
    # A long command stands alone, so that it can be copied.
    short = all(width + 2 + len(typed) <= WIDEST for _, typed in hints)
    for why, typed in hints:
        say(f"{why:{width}}  {typed}" if short else f"{why}\n  {typed}")


def _save(groups: Sequence[RunGroup], root: Path, failed: Mapping[Path, str]) -> None:
    singles = [single for group in groups if group.runs for single in group.singles]
    values = {
        "groups": {group.name: group.to_json() for group in groups},
        "runs": {
            one.runs[0].path.relative_to(root).as_posix(): one.run_to_json() for one in singles
        },
        "failed": {path.relative_to(root).as_posix(): problem for path, problem in failed.items()},
    }
    save_json(root / SUMMARY, values)
