"""``matrixworld judge``: what happened in races."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any, NamedTuple

import click

from matrixworld import analysis
from matrixworld._util.readable import plain_values
from matrixworld.analysis.judgement import ABSENT, CANNOT_TELL, PRESENT, judgement_cells
from matrixworld.analysis.payoffs import EPISODES_TO_JUDGE, GENERATIONS_TO_JUDGE, Payoffs
from matrixworld.cli import console, options
from matrixworld.cli.setting_options import usage_errors
from matrixworld.coevolution import RunGroup
from matrixworld.coevolution.groups import by_clarity

SINGLE_RUN = "The intervals are about this run. Runs with other seeds may differ."
SIGNS = {PRESENT: "+", ABSENT: "-", CANNOT_TELL: "?"}
NOT_FINISHED = "."
STRIP_LEGEND = (
    f"{', '.join(f'{sign} {verdict}' for verdict, sign in SIGNS.items())}, {NOT_FINISHED} not "
    "finished. In brackets: number of seeds with each verdict."
)
BESIDE_SEEDS = 50
"""Columns of the terminal for what stands beside the verdicts on the seeds."""


class Race(NamedTuple):
    """What is judged together: its name and payoffs; runs are a group, files are none."""

    name: str
    payoffs: Payoffs
    group: RunGroup | None


@click.command("judge")
@options.runs(".csv", ".npz")
@click.option("--all", "everything", is_flag=True, help="all measures, after the judgement")
@click.option("--each", is_flag=True, help="judge each run and each file by itself")
@click.option("--explain", "explained", is_flag=True, help="the reasons in sentences, too")
@options.integer("--episodes", "episodes behind each cell of a file that holds means only")
@options.shared("json", "force")
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
    options.check_outputs(json_file, force=force)
    files = [path for path in sources if path.is_file()]
    runs = [path for path in sources if path not in files]
    if episodes is not None and not files:
        raise click.UsageError("--episodes: expected a FILE; runs know their episodes")
    with usage_errors():
        races = [*_races_of_runs(runs, each=each), *_races_of_files(files, episodes, each=each)]
    if everything:
        _check_measurable(races)
    plain: dict[str, Any] = {}
    for race in races:
        judgement = race.group.judgement if race.group else analysis.judge(race.payoffs)
        _print_race(race, judgement)
        if explained:
            console.say()
            console.print_wrapped(analysis.explain(judgement))
        plain[race.name] = judgement.to_json()
        if everything:
            console.say(f"\n{analysis.measure_table(race.payoffs)}")
            measures = plain_values(analysis.measure_all(race.payoffs))
            plain[race.name] = {"judgement": plain[race.name], "measures": measures}
    console.say(f"\n{console.TERMS}")
    options.write_json(json_file, {"groups": plain})


def _races_of_runs(directories: Sequence[Path], *, each: bool) -> list[Race]:
    """Return the races in directories, the clearest first; of `each` run if that is asked for."""
    races: list[Race] = []
    if not directories:
        return races
    for group in by_clarity(options.finished_groups(directories)):
        if not group.is_race:
            raise click.UsageError(f"{group.name}: expected a race, got a run of one team")
        judged = group.singles if each else (group,)
        races += [Race(part.name, part.payoffs, part) for part in judged]
    return races


def _races_of_files(files: Sequence[Path], episodes: int | None, *, each: bool) -> list[Race]:
    """Return the race in files, each of which has a run; or the race in `each` of them."""
    if len(files) > 1 and not each:
        name = ", ".join(map(str, files))
        return [Race(name, analysis.read_payoffs(files, episodes=episodes), None)]
    # A file alone may hold several runs.
    return [Race(str(file), analysis.read_payoffs(file, episodes=episodes), None) for file in files]


def _check_measurable(races: Sequence[Race]) -> None:
    """Raise click.UsageError for a race that is too short for all measures."""
    for race in races:
        if min(race.payoffs.shape) < 2:
            got = " x ".join(map(str, race.payoffs.shape))
            raise click.UsageError(f"--all: expected at least 2 x 2 generations, got {got}")


def _print_race(race: Race, judgement: analysis.Judgement) -> None:
    """Print the judgement of a race, and the verdict on each seed of several."""
    console.print_head(race.name)
    print_judgement(judgement)
    group = race.group
    if group and group.several:
        console.say()
        _print_strip(judgement, group.seeds, group.missing)
        console.print_missing(group)
        console.print_wrapped(STRIP_LEGEND)
    if judgement.runs == 1:
        console.print_wrapped(SINGLE_RUN)


def print_judgement(judgement: analysis.Judgement) -> None:
    """Print a judgement: its sentence, what was judged, its table, what limits it."""
    console.print_wrapped(analysis.sentence(judgement))
    console.say(f"\n{_what_was_judged(judgement)}")
    console.print_table(judgement_cells(judgement), "<<<<")
    if judgement.episodes is None:
        console.print_wrapped(
            "The payoffs do not say how many episodes are behind each cell, and without their "
            'noise some conditions have the verdict "cannot tell". Give the number with --episodes.'
        )
    elif judgement.episodes < EPISODES_TO_JUDGE:
        console.print_wrapped(
            f"It takes at least {EPISODES_TO_JUDGE} episodes of each cell to tell all conditions "
            "from noise; matrixworld tournament RUN --episodes NUMBER plays more."
        )
    if min(judgement.shape) < 2 * GENERATIONS_TO_JUDGE:
        console.print_wrapped(
            f"It takes at least {GENERATIONS_TO_JUDGE} generations of each team to judge a race, "
            f"and {2 * GENERATIONS_TO_JUDGE} to judge its halves."
        )


def _what_was_judged(judgement: analysis.Judgement) -> str:
    """Return in words what was judged: runs, generations and episodes."""
    rows, columns = judgement.shape
    first, second = judgement.teams
    others = "" if judgement.one_population else f" and {columns} of {second}"
    words = [
        console.counted(judgement.runs, "run"),
        f"{console.counted(rows, 'generation')} of {first}{others}",
    ]
    if judgement.exact:
        words.append("all episodes equal")
    elif judgement.episodes:
        words.append(f"{console.counted(judgement.episodes, 'episode')} of each pair")
    return ", ".join(words)


def _print_strip(
    judgement: analysis.Judgement, seeds: Sequence[int], missing: Sequence[int]
) -> None:
    """Print the verdict on each seed in columns, and how many seeds have which verdict."""
    every = sorted([*seeds, *missing])
    longest = max(len(str(seed)) for seed in every)
    beside = max(1, (console.width() - BESIDE_SEEDS) // (2 + longest))
    for first in range(0, len(every), beside):
        columns = every[first : first + beside]
        is_last = columns[-1] == every[-1]
        together = f"together (seeds: {', '.join(SIGNS.values())})" if is_last else ""
        rows = [("seed", *map(str, columns), together)]
        for name, finding in judgement.findings.items():
            verdicts = dict(zip(seeds, finding.by_run, strict=True))
            signs = [SIGNS[verdicts[s]] if s in verdicts else NOT_FINISHED for s in columns]
            numbers = ", ".join(str(finding.by_run.count(verdict)) for verdict in SIGNS)
            end = f"{finding.verdict} ({numbers})" if is_last else ""
            rows.append((name, *signs, end))
        console.print_table(rows, "<" + ">" * len(columns) + "<")
