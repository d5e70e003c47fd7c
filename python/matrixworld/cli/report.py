"""What ``matrixworld evolve`` draws, writes and prints when its runs are finished."""

from __future__ import annotations

import shlex
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from matrixworld._util.files import save_json
from matrixworld.analysis import Estimate, measure_all
from matrixworld.analysis.plain_values import plain_values
from matrixworld.cli.console import TERMS, command, print_wrapped, say
from matrixworld.cli.explore import write_explorer
from matrixworld.cli.figures import draw, planned
from matrixworld.cli.groups import Group, Result, grouped
from matrixworld.cli.score import play_held_out
from matrixworld.cli.tables import (
    measured,
    measured_of_one_team,
    print_claims,
    print_comparison,
    print_head,
    print_judged,
    print_missing,
    print_one_team,
)
from matrixworld.coevolution import Against, RunDirectory
from matrixworld.coevolution.jobs.evolve import Job
from matrixworld.coevolution.types import other
from matrixworld.explorer.runs_page import PAGE

SUMMARY = "summary.json"


def report(
    job: Job,
    results: Sequence[Result],
    root: Path,
    failed: Mapping[Path, str],
    threads: int | None = None,
) -> None:
    """Score and judge the finished runs of a job, draw figures, and print the results.

    `failed` says why the other runs of the job failed, by their directories.
    """
    groups = _groups(job, results, root)
    finished = [group for group in groups if group.runs]
    races = [group for group in finished if group.is_race]
    play_held_out([run for group in races for run in group.runs], threads)
    # Nothing is refused here: figures of an earlier report of the same runs are replaced.
    figures = planned(finished, root)
    draw(figures)
    if finished:
        write_explorer(finished, root / PAGE)
    estimates = {group.name: measured(group) for group in races}
    if races:
        print_comparison(races, estimates)
    for group in groups:
        _print(group)
    if races:
        print_claims(races)
        say(f"\n{TERMS}")
    for path, problem in failed.items():
        print_wrapped(f"Failed: {path}: {problem}")
    problems = {_inside(root, path): problem for path, problem in failed.items()}
    plain = {group.name: _plain(group, estimates.get(group.name)) for group in groups}
    singles = [single for group in finished for single in group.singles]
    runs = {_inside(root, one.runs[0].path): _plain_run(one) for one in singles}
    # The summary of a run that was started by itself lies in the same directory.
    if root not in [run.path for run in results]:
        save_json(root / SUMMARY, {"groups": plain, "runs": runs, "failed": problems})
    _print_files(root, [*figures], runs=[*runs])
    _print_next(finished, root)


def _groups(job: Job, results: Sequence[Result], root: Path) -> list[Group]:
    """Return the groups of all runs of a job, with names inside its directory."""
    finished = {run.path: run for run in results}
    runs = [
        finished.get(path) or Result(RunDirectory(path), settings, finished=False)
        for path, settings in ((root / name, each) for name, each in job.items())
    ]
    return [group.inside(root) for group in grouped(runs)]


def _inside(root: Path, path: Path) -> str:
    return path.relative_to(root).as_posix()


def _print(group: Group) -> None:
    if not group.runs:
        print_head(f"{group.name}: {group.finished_of_asked()} seeds finished")
        print_missing(group)
    elif group.is_race:
        print_judged(group)
    else:
        print_one_team(group)


def _plain(group: Group, estimates: Mapping[str, Estimate | None] | None) -> dict[str, Any]:
    """Return a group as plain values: its seeds, numbers and judgement."""
    plain: dict[str, Any] = {"finished": list(group.seeds), "missing": list(group.missing)}
    if not group.runs:
        return plain
    if estimates is None:
        return {**plain, "measures": plain_values(measured_of_one_team(group))}
    return {
        **plain,
        "measures": plain_values(estimates),
        "judgement": group.judgement.to_json(),
    }


def _plain_run(single: Group) -> dict[str, Any]:
    """Return the numbers of a run, and of a race what was measured and judged."""
    [run] = single.runs
    if not run.is_race:
        return run.numbers
    return {
        **run.numbers,
        "measures": plain_values(measure_all(single.payoffs)),
        "judgement": single.judgement.to_json(),
        "held_out": run.held_out,
    }


def _print_files(root: Path, figures: Sequence[Path], runs: Sequence[str]) -> None:
    say(f"\nAll files are in {root}:")
    if runs:
        say(f"  {PAGE}: open it in a browser; it plays every match of the payoff matrices")
    say(f"  {SUMMARY}: the numbers of each run, and of all seeds together")
    for folder in dict.fromkeys(figure.parent for figure in figures):
        place = "" if folder == root else f"{_inside(root, folder)}/: "
        names = ", ".join(figure.name for figure in figures if figure.parent == folder)
        say(f"  {place}{names}")
    if runs:
        data = "payoff.npz, *.npy (genomes), log.csv, summary.json, scores.json (of races)"
        say(f"  data of each run: {data}")


def _print_next(groups: Sequence[Group], root: Path) -> None:
    if not groups:
        return
    # The last run: of the default job the generalists, whose late pursuers are worth watching.
    last = groups[-1].runs[-1]
    path, settings = last.path, last.settings
    say("\nWhat to try next:")
    schedule = settings.schedule
    if isinstance(schedule, Against):
        commands = [
            command("replay", path, "--out match.gif"),
            command(
                "evolve --schedule against --set",
                f"schedule.opponent={shlex.quote(str(path))}",
                f"--set schedule.team={other(schedule.team)}",
            ),
        ]
    else:
        generation = schedule.entries - 1
        match = f"--pursuer {generation} --evader {generation // 2}"
        others = [group.runs[-1].path for group in groups[-2:-1] if group.is_race]
        commands = [
            command("replay", path, match),
            command("replay", path, match, "--out match.gif"),
            command("judge", root, "--explain"),
            command("judge", root, "--all"),
            command("score", root),
            command("tournament", path, *others),
            command("explore", root, "--figures --each --force"),
        ]
    for each in commands:
        say(f"  {each}")
