"""What ``matrixworld evolve`` draws, writes and prints at the end of a job of several seeds."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from matrixworld._util.files import save_json
from matrixworld.analysis import interval_over_runs
from matrixworld.analysis.plain_values import plain_values
from matrixworld.cli.console import TERMS, command, print_table, print_wrapped
from matrixworld.cli.explore import write_explorer
from matrixworld.cli.held_out import held_out_scores
from matrixworld.cli.judgements import print_head
from matrixworld.cli.race_groups import Group, group_of_runs
from matrixworld.cli.run_groups import by_settings
from matrixworld.cli.seed_figures import draw_seeds
from matrixworld.cli.seed_tables import (
    STRIP_LEGEND,
    finished_of_asked,
    measured,
    print_missing,
    print_seed_table,
    print_strip,
    shown,
    verdict_counts,
)
from matrixworld.coevolution.jobs.job import group_of
from matrixworld.explorer.runs_page import PAGE

if TYPE_CHECKING:
    from matrixworld.cli.held_out import Scores
    from matrixworld.cli.jobs import Result

SUMMARY = "summary.json"
SINGLE = {"capture_rate": ("capture rate", ".3f"), "length": ("length in steps", ".1f")}
"""Numbers of a run in which one team evolved: label and form."""

Asked = Mapping[str, Sequence[int]]


def report_seeds(
    results: Sequence[Result],
    asked: Asked,
    root: Path,
    failed: Mapping[Path, str] = {},
    threads: int | None = None,
) -> None:
    """Print a table, verdicts and figures over the seeds of a job, and write its numbers.

    Parameters
    ----------
    results : sequence of Result
        The finished runs.
    asked : mapping of str to sequence of int
        Seeds that were asked for, by schedule or other name of a group of runs.
    root : Path
        Directory of the job.
    failed : mapping of Path to str, optional
        Why runs failed, by their directories.
    threads : int, optional
        Threads that play matches. By default all cores.
    """
    of_group, asked = _by_group(results, asked, root)
    races = {name: runs for name, runs in of_group.items() if runs and runs[0].is_race}
    others = {name: runs for name, runs in of_group.items() if name not in races}
    scores = held_out_scores([run for runs in races.values() for run in runs], threads)
    groups = [
        group_of_runs(name, runs, _missing(asked[name], runs)) for name, runs in races.items()
    ]
    estimates = {group.name: measured(group, scores) for group in groups}
    plain = {group.name: _plain(group, estimates[group.name]) for group in groups}
    plain |= {name: _plain_of_one_team(runs, asked[name]) for name, runs in others.items()}
    problems = {_inside(root, path): why for path, why in failed.items()}
    runs = {_inside(root, run.path): _plain_run(run, scores) for run in results}
    save_json(root / SUMMARY, {"groups": plain, "runs": runs, "failed": problems})
    drawn = draw_seeds(groups, scores, root) if groups else []
    if groups:
        print_seed_table(groups, estimates)
        _print_verdicts(groups)
    for name, of_team in others.items():
        _print_one_team(name, of_team, asked[name])
    for path, problem in failed.items():
        print_wrapped(f"Failed: {path}: {problem}")
    if results:
        write_explorer(results, root / PAGE)
    _print_files(root, drawn, page=bool(results))


def _inside(root: Path, path: Path) -> str:
    return path.relative_to(root).as_posix()


def _plain_run(run: Result, scores: Mapping[Path, Scores]) -> dict[str, Any]:
    return {**run.numbers, **({"held_out": scores[run.path]} if run.is_race else {})}


def _by_group(
    results: Sequence[Result], asked: Asked, root: Path
) -> tuple[dict[str, list[Result]], Asked]:
    """Return the runs of each group of the same settings, and the seeds that were asked for."""
    of_group: dict[str, list[Result]] = {}
    seeds: dict[str, Sequence[int]] = {}
    for name in asked:
        runs = _runs_of(name, results, root)
        parts = by_settings(runs)
        # A directory of a job that was made in Python may hold runs of several settings.
        for part in parts if len(parts) > 1 else []:
            own = ", ".join(_inside(root, run.path) for run in part)
            of_group[own], seeds[own] = part, [run.settings.seed for run in part]
        missing = _missing(asked[name], runs)
        if len(parts) < 2 or missing:
            of_group[name] = runs if len(parts) < 2 else []
            seeds[name] = asked[name] if len(parts) < 2 else missing
    return of_group, seeds


def _runs_of(name: str, results: Sequence[Result], root: Path) -> list[Result]:
    """Return the runs of a group, in the order of their seeds."""
    found = [each for each in results if group_of(_inside(root, each.path)) == name]
    return sorted(found, key=lambda run: run.settings.seed)


def _missing(asked: Sequence[int], runs: Sequence[Result]) -> list[int]:
    return sorted({*asked} - {run.settings.seed for run in runs})


def _plain(group: Group, estimates: Mapping[str, Any]) -> dict[str, Any]:
    """Return the aggregate of a group as plain values."""
    return {
        "finished": list(group.seeds),
        "missing": list(group.missing),
        "measures": plain_values(estimates),
        "verdicts": verdict_counts(group),
        "judgement": group.judgement.to_json(),
    }


def _plain_of_one_team(runs: Sequence[Result], asked: Sequence[int]) -> dict[str, Any]:
    return {
        "finished": [run.settings.seed for run in runs],
        "missing": _missing(asked, runs),
        "measures": {name: plain_values(_over_seeds(runs, name)) for name in SINGLE if runs},
    }


def _over_seeds(runs: Sequence[Result], name: str) -> Any:
    return interval_over_runs([run.numbers[name] for run in runs], bounds=(0.0, float("inf")))


def _print_verdicts(groups: Sequence[Group]) -> None:
    for group in groups:
        print_head(f"{group.name}: {finished_of_asked(group)} seeds finished")
        print_strip(group)
        print_missing(group)
    click.echo()
    print_wrapped(STRIP_LEGEND)
    click.echo(f"\n{TERMS}")


def _print_one_team(name: str, runs: Sequence[Result], asked: Sequence[int]) -> None:
    print_head(f"{name}: {len(runs)} of {len(asked)} seeds finished")
    if runs:
        rows = [("seed", *(label for label, _ in SINGLE.values()))]
        for run in runs:
            cells = (format(run.numbers[key], form) for key, (_, form) in SINGLE.items())
            rows.append((str(run.settings.seed), *cells))
        means = (shown(_over_seeds(runs, key), form) for key, (_, form) in SINGLE.items())
        print_table([*rows, ("mean", *means)], "<<<")
        print_wrapped("In brackets: 95% interval of the mean over seeds; one seed has none.")
    missing = _missing(asked, runs)
    if missing:
        print_wrapped(f"Not finished: seeds {', '.join(map(str, missing))}.")


def _print_files(root: Path, drawn: Sequence[Path], *, page: bool) -> None:
    click.echo(f"\nAll files are in {root}:")
    if page:
        click.echo(f"  {PAGE}: open it in a browser; it plays the matches of the runs")
    if drawn:
        click.echo(f"  {', '.join(file.name for file in drawn)}: the figures")
    click.echo(f"  {SUMMARY}: the numbers of each seed and of all together")
    if drawn:
        click.echo("\nWhat to try next:")
        click.echo(f"  {command('diagnose', root, '--explain')}")
        click.echo(f"  {command('analyze', root)}")
        click.echo(f"  {command('plot', root, '--each', '--force')}")
