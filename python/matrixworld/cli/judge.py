"""``matrixworld judge``: what happened in races."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import click

from matrixworld._util.readable import plain_values
from matrixworld.analysis import Judgement, explain, judge, measure_all, measure_table, read_payoffs
from matrixworld.analysis.judgement import ABSENT, CANNOT_TELL, PRESENT, judgement_cells, summary
from matrixworld.analysis.payoffs import EPISODES_TO_JUDGE, GENERATIONS_TO_JUDGE, Payoffs
from matrixworld.cli.console import TERMS, WIDEST, print_head, print_table, print_wrapped, say
from matrixworld.cli.options import check_exists, check_outputs, integer, options, write_json
from matrixworld.cli.runs import finished_groups, print_missing, unpacked
from matrixworld.cli.setting_options import usage_errors
from matrixworld.coevolution.groups import RunGroup
from matrixworld.coevolution.storage import find_runs

FILES = (".csv", ".npz")
SINGLE_RUN = "The intervals are about this run. Runs with other seeds may differ."
SIGNS = {PRESENT: "+", ABSENT: "-", CANNOT_TELL: "?"}
NOT_FINISHED = "."
STRIP_LEGEND = (
    f"{SIGNS[PRESENT]} present, {SIGNS[ABSENT]} absent, {SIGNS[CANNOT_TELL]} cannot tell, "
    f"{NOT_FINISHED} not finished. In brackets: number of seeds with each verdict."
)


def _sources(ctx: click.Context, param: click.Parameter, values: Sequence[str]) -> list[Path]:
    paths = [unpacked(Path(value)) for value in dict.fromkeys(values)]
    for path in paths:
        check_exists(path)
        if not _is_payoff_file(path) and not find_runs(path):
            expected = f"run directories, or {' or '.join(FILES)} files"
            raise click.BadParameter(f"expected {expected}, got {str(path)!r}")
    return paths


def _is_payoff_file(path: Path) -> bool:
    return path.suffix.lower() in FILES and path.is_file()


@click.command("judge")
@click.argument("sources", nargs=-1, required=True, metavar="RUN|FILE...", callback=_sources)
@click.option("--all", "everything", is_flag=True, help="all measures, after the judgement")
@click.option("--each", is_flag=True, help="judge each run and each file by itself")
@click.option("--explain", "explained", is_flag=True, help="the reasons in sentences, too")
@integer("--episodes", "episodes behind each cell of a file that holds means only")
@options("json", "force")
def judge_command(
    sources: list[Path],
    everything: bool,
    each: bool,
    explained: bool,
    episodes: int | None,
    json_file: Path | None,
    force: bool,
) -> None:
    """Say what happened in races.

    Each condition, such as an arms race or cycling, is present or absent, or the intervals cannot
    tell. RUN is the directory of a job or of a run. Runs that differ in their seed only are judged
    together, with the verdict on each seed.

    FILE is a payoff matrix of your own, .csv or .npz: pursuers in rows, evaders in columns, capture
    rates from 0 to 1; or one line for each pair, run and episode. Several files are judged
    together, as runs of one race.
    """
    check_outputs(json_file, force=force)
    files = [path for path in sources if _is_payoff_file(path)]
    runs = [path for path in sources if path not in files]
    if episodes is not None and not files:
        raise click.UsageError("--episodes: expected a FILE; runs know their episodes")
    with usage_errors():
        groups = finished_groups(runs) if runs else []
        if each:
            groups = [single for group in groups for single in group.singles]
        for one in groups:
            if not one.is_race:
                raise click.UsageError(f"{one.name}: expected a race, got a run of one team")
        judged: dict[str, tuple[Payoffs, RunGroup | None]] = {
            group.name: (group.payoffs, group) for group in groups
        }
        # One file may hold several runs; a list is of files of one run each.
        parts: list[Path | list[Path]] = [files] if len(files) > 1 and not each else [*files]
        for part in parts:
            name = ", ".join(map(str, part)) if isinstance(part, list) else str(part)
            judged[name] = read_payoffs(part, episodes=episodes), None
    for payoffs, _ in judged.values():
        if everything and min(payoffs.shape) < 2:
            rows, columns = payoffs.shape
            raise click.UsageError(
                f"--all: expected at least 2 x 2 generations, got {rows} x {columns}"
            )
    found = {}
    for name, (payoffs, group) in judged.items():
        judgement = judge(payoffs) if group is None else group.judgement
        _print(name, payoffs, judgement, group, everything=everything, explained=explained)
        found[name] = judgement.to_json()
        if everything:
            measures = plain_values(measure_all(payoffs))
            found[name] = {"judgement": found[name], "measures": measures}
    say(f"\n{TERMS}")
    write_json(json_file, {"groups": found})


def _print(
    name: str,
    payoffs: Payoffs,
    judgement: Judgement,
    group: RunGroup | None,
    *,
    everything: bool,
    explained: bool,
) -> None:
    print_head(name)
    print_judgement(judgement)
    if group is not None and group.several:
        say()
        print_strip(judgement, group.seeds, group.missing)
        print_missing(group)
        print_wrapped(STRIP_LEGEND)
    if judgement.runs == 1:
        print_wrapped(SINGLE_RUN)
    if group is not None:
        print_wrapped(group.runs[0].settings.schedule.limits)
    if explained:
        say()
        print_wrapped(explain(judgement))
    if everything:
        say(f"\n{measure_table(payoffs)}")


def counts(judgement: Judgement) -> str:
    """Return the numbers of runs, generations and episodes that were judged."""
    runs = "1 run" if judgement.runs == 1 else f"{judgement.runs} runs"
    pursuers, evaders = judgement.shape
    episodes = (
        "" if judgement.episodes is None else f", {judgement.episodes:,} episodes of each pair"
    )
    return f"{runs}, {pursuers} pursuer and {evaders} evader generations{episodes}"


def print_judgement(judgement: Judgement) -> None:
    """Print a judgement: in words, the numbers of what was judged, its table, what limits it."""
    for line in summary(judgement):
        print_wrapped(line)
    say(f"\n{counts(judgement)}")
    print_table(judgement_cells(judgement), "<<<<")
    if judgement.episodes is None:
        print_wrapped(
            "The payoffs do not say how many episodes are behind each cell, and without their "
            'noise some conditions have the verdict "cannot tell". Give the number with --episodes.'
        )
    elif judgement.episodes < EPISODES_TO_JUDGE:
        print_wrapped(
            f"It takes at least {EPISODES_TO_JUDGE} episodes of each cell to tell all conditions "
            "from noise; matrixworld tournament RUN --episodes NUMBER plays more."
        )
    if judgement.window == "whole":
        print_wrapped(
            f"It takes at least {GENERATIONS_TO_JUDGE} generations of each team to judge a race, "
            f"and {2 * GENERATIONS_TO_JUDGE} to judge its halves."
        )


def print_strip(judgement: Judgement, seeds: Sequence[int], missing: Sequence[int]) -> None:
    """Print the verdict on each seed in columns, and how many seeds have which verdict."""
    every = sorted([*seeds, *missing])
    beside = max(1, (WIDEST - 50) // (2 + max(len(str(seed)) for seed in every)))
    for first in range(0, len(every), beside):
        part, is_last = every[first : first + beside], first + beside >= len(every)
        together = f"together (seeds: {', '.join(SIGNS.values())})" if is_last else ""
        rows = [("seed", *map(str, part), together)]
        for name, finding in judgement.findings.items():
            found = dict(zip(seeds, finding.by_run, strict=True))
            signs = [SIGNS[found[seed]] if seed in found else NOT_FINISHED for seed in part]
            numbers = ", ".join(str(finding.by_run.count(verdict)) for verdict in SIGNS)
            rows.append((name, *signs, f"{finding.verdict} ({numbers})" if is_last else ""))
        print_table(rows, "<" + ">" * len(part) + "<")
