"""``matrixworld solve``: perfect play in a small world, and how far teams of runs are from it."""

from __future__ import annotations

import math
import time
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import click

from matrixworld.analysis import interval_over_runs
from matrixworld.cli.console import print_head, print_table, print_wrapped, say, warnings_as_notes
from matrixworld.cli.options import (
    Existing,
    check_outputs,
    given_options,
    option_name,
    options,
    write_json,
)
from matrixworld.cli.runs import finished_groups, print_missing
from matrixworld.cli.setting_options import usage_errors
from matrixworld.coevolution import Team
from matrixworld.coevolution.groups import RunGroup
from matrixworld.coevolution.types import SCORE, other
from matrixworld.solve import States, best_response, expected_payoff, solve
from matrixworld.world.config import WorldConfig

SOLVE_EXAMPLES = """\b
Examples:
  matrixworld solve --rows 4 --cols 4 --steps 5
  matrixworld solve --variant TO --rows 8 --cols 8
  matrixworld solve --variant O --rows 4 --cols 4 --n-pursuers 2 --n-evaders 1 --steps 5 --json -
  matrixworld solve --run runs/small-race
"""
SOLVE_LEGEND = (
    "Both teams see everything and choose for all their members together. The "
    "mean is over all starts on distinct free cells."
)
RUN_LEGEND = (
    "All numbers are exact. Gain: score of the best response minus that of the champion's last "
    "opponent in its own run. Exploitability: score of the best response minus that under perfect "
    "play of both teams. In brackets: 95% interval of the mean over the seeds."
)
WORLD = ("variant", "rows", "cols", "n_pursuers", "n_evaders", "steps", "diagonal", "obstacles")


@click.command("solve", epilog=SOLVE_EXAMPLES)
@options(*WORLD)
@click.option(
    "--run",
    "run",
    type=Existing(file_okay=False),
    metavar="RUN",
    help="solve the world of this run, or of the runs of a job, and tell what the best opponents "
    "do to their last generations",
)
@options("json", "force", "threads")
def solve_command(
    variant: str | None,
    steps: int | None,
    run: Path | None,
    json_file: Path | None,
    force: bool,
    threads: int | None,
    **world: Any,
) -> None:
    """Solve a small world exactly.

    The value is the capture rate after the last step when both teams play perfectly, as a mean over
    all starts on distinct free cells. Where the teams take turns, the capture time is printed, too:
    the rounds that the pursuers need when they choose their cells first and the evaders then
    theirs, for as long as it takes.

    By default 2 pursuers play against 1 evader on 6 x 6 cells. All states must fit into memory:
    about 3 pursuers and 2 evaders on a small board.
    docs/ground_truth.md says how it is done.

    With --run the best responses to the last generations of a run are computed, which no other can
    surpass. Its networks must see the whole board.
    """
    check_outputs(json_file, force=force)
    given = given_options({"variant": variant, "steps": steps, **world})
    if run is not None and given:
        names = ", ".join(map(option_name, given))
        raise click.UsageError(f"--run: expected no {names} beside it: the run has a world")
    with warnings_as_notes(), usage_errors():
        if run is None:
            numbers = _solve_world(given, threads)
        else:
            groups = finished_groups([run], unfinished=True)
            numbers = {"groups": {group.name: _solve_runs(group, threads) for group in groups}}
    print_wrapped(SOLVE_LEGEND if run is None else f"\n{RUN_LEGEND}")
    write_json(json_file, numbers)


def _solve_world(given: Mapping[str, Any], threads: int | None) -> dict[str, Any]:
    """Print the exact numbers of a small world; return them as JSON has them."""
    options = {"variant": "O", "steps": 20, "n_pursuers": 2, "n_evaders": 1, **given}
    if "obstacles" not in given:  # which have a size
        options = {"rows": 6, "cols": 6, **options}
    variant, steps = options.pop("variant"), options.pop("steps")
    config = WorldConfig(variant, max_steps=steps, **options)
    began = time.perf_counter()
    solution = solve(States(config, threads=threads))
    needed = solution.capture_time if solution.states.n_turns > 1 else None
    seconds = time.perf_counter() - began
    size = f"{config.rows} x {config.cols} cells"
    print_head(f"{variant}, {size}, {config.n_pursuers} against {config.n_evaders}")
    say(solution)
    numbers: dict[str, Any] = {
        "world": config.to_json(),
        "value": solution.value,
        "value_by_step": solution.means.tolist(),
        "states": solution.states.total,
        "gap": solution.gap,
        "seconds": seconds,
    }
    if needed is not None:
        is_finite = not math.isinf(needed)
        rounds = int(needed) if is_finite else "never: the evaders can escape"
        say(f"rounds to capture from the best start: {rounds}")
        numbers["capture_time"] = int(needed) if is_finite else None
    say(f"It took {seconds:.2f} seconds.\n")
    return numbers


# The teams of runs:


def _solve_runs(group: RunGroup, threads: int | None) -> dict[str, Any]:
    """Print exact scores of the opponents of each team of a group; return them as JSON has them."""
    states = States(group.runs[0].settings.world, threads=threads)
    value = solve(states).value
    found: dict[str, Any] = {"value": value, "seeds": list(group.seeds)}
    for champion in group.runs[0].settings.learning_teams:
        perfect, rate = _score(value, champion), SCORE[other(champion)]
        numbers = []
        for run in group.runs:
            met = expected_payoff(states, run.last("pursuer"), run.last("evader"))
            best = best_response(states, run.last(champion), champion).value
            scores = _score(met, champion), _score(best, champion)
            numbers.append((*scores, scores[1] - scores[0], scores[1] - perfect))
        names = [f"the {other(champion)}s of the run", "the best", "gain", "exploitability"]
        rows = [["seed", *names]]
        for seed, each in zip(group.seeds, numbers, strict=True):
            # Adding 0.0 turns the -0.0 of a rounding error into 0.0.
            rows.append([str(seed), *(f"{round(number, 3) + 0.0:.3f}" for number in each)])
        if len(numbers) > 1:
            means = (interval_over_runs(each) for each in list(zip(*numbers, strict=True))[2:])
            rows.append(["mean", "", "", *map(str, means)])
        print_head(f"{group.name}: exact {rate} against the last {champion}s")
        print_table(rows, ">>><<")
        print_wrapped(f"Under perfect play of both teams the {rate} is {perfect:.3f}.")
        keys = ("met", "best", "gain", "exploitability")
        columns = zip(*numbers, strict=True)
        found[f"{champion}s"] = dict(zip(keys, map(list, columns), strict=True))
    print_missing(group)
    return found


def _score(captured: float, champion: Team) -> float:
    """Return a capture rate as the score of the champion's opponent."""
    return captured if champion == "evader" else 1.0 - captured
