"""``matrixworld solve``: the value of a small world, exactly."""

from __future__ import annotations

import math
import time
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import click

from matrixworld.cli.console import print_head, print_wrapped, say
from matrixworld.cli.options import check_outputs, integer, options, write_json
from matrixworld.cli.setting_options import usage_errors
from matrixworld.solve import States, solve
from matrixworld.world.config import WorldConfig

EXAMPLES = """\b
Examples:
  matrixworld solve --rows 4 --cols 4 --steps 5
  matrixworld solve --variant TO --rows 8 --cols 8
  matrixworld solve --variant O --rows 4 --cols 4 --pursuers 2 --evaders 1 --steps 5 --json -
"""
LEGEND = (
    "Both teams play perfectly, see everything, and choose for all their members together. The "
    "mean is over all starts on distinct free cells."
)


@click.command("solve", epilog=EXAMPLES, short_help="Solve a small world exactly.")
@options("variant", "rows", "cols")
@integer("--pursuers", "n_pursuers", "number of pursuers; default: 2")
@integer("--evaders", "n_evaders", "number of evaders; default: 1")
@options("steps", "diagonal", "obstacles", "json", "force", "threads")
def solve_command(
    variant: str | None,
    steps: int | None,
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

    All states must fit into memory: about 3 pursuers and 2 evaders on a small board.
    docs/ground_truth.md says how it is done.
    """
    check_outputs(json_file, force=force)
    given = {name: value for name, value in world.items() if value is not None}
    board = {} if "obstacles" in given else {"rows": 6, "cols": 6}
    small = {"n_pursuers": 2, "n_evaders": 1, "max_steps": steps or 20}
    with usage_errors():
        config = WorldConfig(variant or "O", **board | small | given)
        began = time.perf_counter()
        solution = solve(States(config, threads=threads))
        found: dict[str, Any] = {
            "value": solution.value,
            "value_by_step": solution.means.tolist(),
            "states": solution.states.total,
            "gap": solution.gap,
        }
        if solution.states.n_turns > 1:
            rounds = solution.capture_time
            found["capture_time"] = None if math.isinf(rounds) else int(rounds)
        found["seconds"] = time.perf_counter() - began
    size = f"{config.rows} x {config.cols} cells"
    print_head(f"{variant or 'O'}, {size}, {config.n_pursuers} against {config.n_evaders}")
    _print(found, config.max_steps)
    write_json(json_file, {"world": config.to_json(), **found})


def _print(found: Mapping[str, Any], steps: int) -> None:
    rows = {f"capture rate after {steps} steps": f"{found['value']:.4f}"}
    if "capture_time" in found:
        # None is infinite.
        rounds = found["capture_time"] or "never: the evaders can escape"
        rows["rounds to capture from the best start"] = str(rounds)
    rows["states"] = f"{found['states']:,}"
    rows["largest gap between the guarantees of a step"] = f"{found['gap']:.1g}"
    rows["seconds"] = f"{found['seconds']:.2f}"
    width = max(map(len, rows))
    for name, value in rows.items():
        say(f"  {name:{width}}  {value}")
    say()
    print_wrapped(LEGEND)
