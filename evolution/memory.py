"""What does it bring to remember? A corridor that only memory solves.

    python evolution/memory.py             five seeds of each kind, a quarter of an hour
    python evolution/memory.py --quick     some seconds

One pursuer sees one cell around it, and a still evader is somewhere in a corridor of 13 cells. A
pursuer that remembers an end where nobody was goes to the other one, and captures always. Without
memory it decides in the middle of the corridor without knowing where it comes from: cells there
look alike. The best such policy goes east with some probability. Its capture rate is computed
exactly, as the largest over that probability and those of turning at the ends. (Nobody can hide
behind obstacles here, because agents see over them; so the evader is hidden by distance.)

``evolution/results/memory`` keeps what was found.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy import optimize

from common import Numbers, Runs, by_seed, experiment, markdown, mean
from matrixworld.coevolution import RaceSettings

MEMORIES = ("none", "gru")
CELLS, STEPS = 13, 23
"""Of the corridor; the slowest search that goes to one end and then to the other takes 22 steps."""
CORRIDOR = RaceSettings.of(
    {
        "world": {"rules": "R", "rows": 1, "cols": CELLS, "fov": 3, "max_steps": STEPS},
        "world.n_pursuers": 1,
        "world.n_evaders": 1,
        "schedule": {"kind": "against", "opponent": "still", "epochs": 300, "archive_every": 300},
        "fitness.measure": "capture-rate",
        # Larger steps than the defaults, with which memory does not always learn the search.
        "learner": {"population": 64, "sigma": 0.2, "learning_rate": 0.1},
        "policy.hidden": (16,),
        "train_steps": STEPS,
        "match_episodes": 16,
        "evaluation_episodes": 10_000,
    }
)
QUICK = {
    "schedule.epochs": 2, "schedule.archive_every": 2, "learner.population": 4,
    "evaluation_episodes": 50,
}  # fmt: skip


def kinds(quick: bool) -> dict[str, RaceSettings]:
    """Return the settings with each memory."""
    base = CORRIDOR.changed(QUICK if quick else {})
    return {f"corridor, {each}": base.changed({"policy.memory": each}) for each in MEMORIES}


def capture_rate(policy: NDArray[np.float64]) -> float:
    """Return the capture rate of a pursuer that remembers nothing.

    `policy` has the probabilities of going east in the middle of the corridor, and of turning at
    its west and its east end. To stay would only lose time; an evader in view is captured at once.
    """
    east, turn_west, turn_east = policy
    moves = np.zeros((CELLS, CELLS))  # from a cell to a cell
    for cell in range(CELLS):
        chance = {0: turn_west, CELLS - 1: 1 - turn_east}.get(cell, east)
        moves[cell, min(cell + 1, CELLS - 1)] += chance
        moves[cell, max(cell - 1, 0)] += 1 - chance
    each = np.arange(CELLS)
    by_evader = np.repeat(moves[None], CELLS, axis=0)
    near = np.abs(each[:, None] - each) <= 1
    by_evader[near] = np.eye(CELLS)[np.nonzero(near)[0]]
    start = (1 - np.eye(CELLS)) / (CELLS - 1)
    found = start[:, None]
    for _ in range(STEPS):
        found = found @ by_evader
    return float(found[each, 0, each].mean())


def without_memory() -> float:
    """Return the largest capture rate without memory; of several local searches the best."""
    starts = np.stack(np.meshgrid(*3 * [[0.25, 0.5, 0.75]]), axis=-1).reshape(-1, 3)
    return max(
        -optimize.minimize(lambda policy: -capture_rate(policy), start, bounds=3 * [(0, 1)]).fun
        for start in starts
    )


def measured(runs: Runs, quick: bool) -> dict[str, Any]:
    """Return the capture rates of all runs, and the best one without memory."""
    rates = by_seed(runs, lambda run: {"captured": float(run.summary()["capture_rate"])})
    return {**rates, "without memory": without_memory()}


def table(numbers: Numbers) -> str:
    """Return the capture rates in Markdown."""
    rows = []
    for memory in MEMORIES:
        rates = numbers[f"corridor, {memory} / captured"]
        each = ", ".join(f"{rate:.3f}" for rate in rates)
        rows.append([f"memory: {memory}", mean(rates, 2, bounds=(0.0, 1.0)), each])
    rows.append(["the best without memory, exactly", f"{numbers['without memory']:.3f} |"])
    return markdown(["corridor", "capture rate", "of each seed"], rows)


if __name__ == "__main__":
    experiment(__doc__, kinds=kinds, measure=measured, table=table, seeds=5)
