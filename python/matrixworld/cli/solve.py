"""``matrixworld solve``: perfect play in a small world, and how far teams of runs are from it."""

from __future__ import annotations

import time
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any, NamedTuple

import click

from matrixworld.analysis import interval_over_runs
from matrixworld.cli import console, options
from matrixworld.cli.setting_options import usage_errors
from matrixworld.coevolution import ProgressBar, RunGroup, SavedRun, Team
from matrixworld.coevolution.evaluation.scores import SCORE
from matrixworld.coevolution.types import other
from matrixworld.solver import States, best_response, expected_payoff, solve
from matrixworld.world.config import WorldConfig

SOLVE_LEGEND = (
    "Both teams see everything and choose for all their members together. The "
    "mean is over all starts on distinct free cells."
)
RUN_LEGEND = (
    "All numbers are exact. Gain: score of the best response minus that of the champion's last "
    "opponent in its own run. Exploitability: score of the best response minus that under perfect "
    "play of both teams. In brackets: 95% interval of the mean over the seeds."
)

GAME: dict[str, Any] = {"variant": "O", "steps": 20, "n_pursuers": 2, "n_evaders": 1}
"""The game where options do not say otherwise."""
SIZE = {"rows": 6, "cols": 6}
"""Its grid, if no map gives one."""


@click.command("solve")
@options.shared("variant", "rows", "cols", "n_pursuers", "n_evaders", "steps")
@options.shared("diagonal", "obstacles")
@click.option(
    "--run",
    "run",
    type=click.Path(exists=True, file_okay=False, path_type=Path),
    metavar="RUN",
    help="solve the world of this run, or of the runs of a job, and tell what the best opponents "
    "do to their last generations",
)
@options.shared("json", "force", "threads")
def solve_command(
    run: Path | None, json_file: Path | None, force: bool, threads: int | None, **world: Any
) -> None:
    """Solve a small world exactly.

    The value is the capture rate after the last step when both teams play perfectly, as a mean over
    all starts on distinct free cells.

    By default 2 pursuers play against 1 evader on 6 x 6 cells. All states must fit into memory:
    about 3 pursuers and 2 evaders on a small board.
    docs/ground_truth.md says how it is done.

    With --run the best responses to the last generations of a run are computed, which no other can
    surpass. Its networks must see the whole board.

    \b
    Examples:
      matrixworld solve --rows 4 --cols 4 --steps 5
      matrixworld solve --variant TO --rows 8 --cols 8
      matrixworld solve --rows 4 --cols 4 --n-pursuers 2 --n-evaders 1 --steps 5 --json -
      matrixworld solve --run runs/small-race
    """
    options.check_outputs(json_file, force=force)
    chosen = options.given(world)
    if run is not None:
        options.refuse_beside("--run", chosen, ": the run has a world")
    with console.warnings_as_notes(), usage_errors():
        if run is None:
            numbers = _solve_world(chosen, threads)
        else:
            groups = options.finished_groups([run], unfinished=True)
            with ProgressBar(after=1.0) as bar:
                of_groups = {group.name: _solve_runs(group, threads, bar) for group in groups}
            numbers = {"groups": of_groups}
    console.print_wrapped(SOLVE_LEGEND if run is None else f"\n{RUN_LEGEND}")
    options.write_json(json_file, numbers)


def _solve_world(chosen: Mapping[str, Any], threads: int | None) -> dict[str, Any]:
    """Print the exact numbers of a small world; return them as JSON has them."""
    size = {} if "obstacles" in chosen else SIZE  # a map has its own
    world = {**size, **GAME, **chosen}
    variant = world.pop("variant")
    config = WorldConfig(variant, max_steps=world.pop("steps"), **world)
    began = time.perf_counter()
    with ProgressBar(after=1.0) as bar:
        solution = solve(States(config, threads=threads, report=bar.share))
    seconds = time.perf_counter() - began
    cells = f"{config.rows} x {config.cols} cells"
    console.print_head(f"{variant}, {cells}, {config.n_pursuers} against {config.n_evaders}")
    console.say(solution)
    console.say(f"It took {seconds:.2f} seconds.\n")
    return {
        "world": config.to_json(),
        "value": solution.value,
        "value_by_step": solution.means.tolist(),
        "states": solution.states.total,
        "gap": solution.gap,
        "seconds": seconds,
    }


class ExactScores(NamedTuple):
    """Scores of the opponents of a champion, by the names that JSON has for them."""

    met: float
    best: float
    gain: float
    exploitability: float


def _solve_runs(group: RunGroup, threads: int | None, bar: ProgressBar) -> dict[str, Any]:
    """Print exact scores of the opponents of each team of a group; return them as JSON has them."""
    states = States(group.runs[0].pursuit.world, threads=threads, report=bar.share)
    value = solve(states).value
    plain: dict[str, Any] = {"value": value, "seeds": list(group.seeds)}
    for champion in group.runs[0].settings.learning_teams:
        scores = [_exact_scores(states, run, champion, value) for run in group.runs]
        columns: dict[str, list[float]] = {name: [] for name in ExactScores._fields}
        for of_run in scores:
            for name, number in of_run._asdict().items():
                columns[name].append(number)
        plain[f"{champion}s"] = columns
        rate = SCORE[other(champion)]
        console.print_head(f"{group.name}: exact {rate} against the last {champion}s")
        console.print_table(_score_rows(group, champion, scores), ">>><<")
        perfect = _score(value, champion)
        console.print_wrapped(f"Under perfect play of both teams the {rate} is {perfect:.3f}.")
    console.print_missing(group)
    return plain


def _exact_scores(states: States, run: SavedRun, champion: Team, value: float) -> ExactScores:
    """Return the scores against the last generation of a run; `value` is that of perfect play."""
    best = _score(best_response(states, run.last(champion), champion).value, champion)
    met = best
    if not run.settings.exact:  # there the best response is what it met
        last = expected_payoff(states, run.last("pursuer"), run.last("evader"))
        met = _score(last, champion)
    return ExactScores(met, best, best - met, best - _score(value, champion))


def _score_rows(group: RunGroup, champion: Team, scores: Sequence[ExactScores]) -> list[list[str]]:
    """Return the table of the scores against the champions of a group, a row for each seed."""
    rows = [["seed", f"the {other(champion)}s of the run", "the best", "gain", "exploitability"]]
    for seed, of_run in zip(group.seeds, scores, strict=True):
        rows.append([str(seed), *map(_three_digits, of_run)])
    if len(scores) > 1:
        gain = interval_over_runs([of_run.gain for of_run in scores])
        exploitability = interval_over_runs([of_run.exploitability for of_run in scores])
        rows.append(["mean", "", "", str(gain), str(exploitability)])
    return rows


def _three_digits(number: float) -> str:
    # Adding 0.0 turns the -0.0 of a rounding error into 0.0.
    return f"{round(number, 3) + 0.0:.3f}"


def _score(captured: float, champion: Team) -> float:
    """Return a capture rate as the score of the champion's opponent."""
    return captured if champion == "evader" else 1.0 - captured
