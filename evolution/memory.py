"""What does it bring to remember? A corridor that only memory solves, evaders that flee, races.

    python evolution/memory.py                    hours on two cores; can be interrupted
    python evolution/memory.py --kinds corridor   a quarter of an hour
    python evolution/memory.py --quick            some seconds

**Corridor.** One pursuer sees one cell around it, and a still evader is somewhere in a corridor of
13 cells. A pursuer that remembers an end where nobody was goes to the other one, and captures
always. Without memory it decides in the middle of the corridor without knowing where it comes from:
cells there look alike. The best such policy goes east with some probability. Its capture rate is
computed exactly, as the largest over that probability and those of turning at the ends. (Nobody can
hide behind obstacles here, because agents see over them; so the evader is hidden by distance.)

**Fleers.** Pursuers train against evaders that flee, with and without memory and with equal numbers
of matches; all else is as in `catching_fleers.py`. Scripts stand beside them.

**Board.** The same on 6 x 6 cells, all of which agents see. This world is solved: what the best
pursuers capture tells "cannot be caught" from "was not learned".

**Races.** The three default races, with and without memory and with equal numbers of matches, by
the scores of both last generations against held-out opponents. Differences are those of the same
seeds.

``evolution/results/memory`` keeps what was found.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy import optimize

import catching_fleers
from catching_fleers import EVADERS, SCRIPTED, captures
from common import SMALL_RACE, Numbers, Runs, by_seed, experiment, kinds_in, markdown, mean
from course import chapter_10
from course.chapter_10 import CELLS, STEPS
from matrixworld.coevolution import TEAMS, RaceSettings, SavedRun, score
from matrixworld.solve import States, best_response, expected_payoff
from race_budgets import SCHEDULES

MEMORIES = ("none", "gru")
SEEDS, RACE_SEEDS = 5, 3
CORRIDOR = chapter_10.CORRIDOR.changed({"evaluation_episodes": 10_000})
QUICK = {
    "schedule.epochs": 2, "schedule.archive_every": 2, "learner.population": 4,
    "evaluation_episodes": 50,
}  # fmt: skip
BOARD = RaceSettings.of({
    "world.rows": 6, "world.cols": 6, "world.n_pursuers": 2, "world.n_evaders": 1,
    "world.max_steps": 20, "train_steps": 20, "match_episodes": 16,
    "schedule": "against", "schedule.epochs": 300, "schedule.archive_every": 300,
    "learner.population": 48, "learner.sigma": 0.2, "learner.learning_rate": 0.1,
    "evaluation_episodes": 10_000,
})  # fmt: skip
QUICK_RACES = {
    **SMALL_RACE, "learner.population": 4, "train_steps": 20, "world.max_steps": 30,
    "schedule.generations": 2, "evaluation_episodes": 2,
}  # fmt: skip
SIZES = {False: (8, 16, 32), True: (3, 6)}


def kinds(quick: bool) -> dict[str, RaceSettings]:
    """Return the settings of each part, with each memory."""
    few = QUICK if quick else {}
    bases = {
        "corridor": CORRIDOR.changed(few),
        "fleers": catching_fleers.BASES[quick],
        **{f"board, {each}": BOARD.changed({**few, "schedule.opponent": each}) for each in EVADERS},
        **{
            f"races, {each}": RaceSettings.of({"schedule": each, **(QUICK_RACES if quick else {})})
            for each in SCHEDULES
        },
    }
    return {
        f"{part}, {memory}": base.changed({"policy.memory": memory})
        for part, base in bases.items()
        for memory in MEMORIES
    }


# ---- The corridor, exactly -----------------------------------------------------------------------


def capture_rate(policy: NDArray[np.float64], cells: int = CELLS, steps: int = STEPS) -> float:
    """Return the capture rate of a pursuer that remembers nothing.

    `policy` has the probabilities of going east in the middle of the corridor, and of turning at
    its west and its east end. To stay would only lose time; an evader in view is captured at once.
    """
    east, turn_west, turn_east = policy
    moves = np.zeros((cells, cells))  # from a cell to a cell
    for cell in range(cells):
        chance = {0: turn_west, cells - 1: 1 - turn_east}.get(cell, east)
        moves[cell, min(cell + 1, cells - 1)] += chance
        moves[cell, max(cell - 1, 0)] += 1 - chance
    each = np.arange(cells)
    by_evader = np.repeat(moves[None], cells, axis=0)
    near = np.abs(each[:, None] - each) <= 1
    by_evader[near] = np.eye(cells)[np.nonzero(near)[0]]
    start = (1 - np.eye(cells)) / (cells - 1)
    found = start[:, None]
    for _ in range(steps):
        found = found @ by_evader
    return float(found[each, 0, each].mean())


def without_memory(cells: int = CELLS, steps: int = STEPS) -> float:
    """Return the largest capture rate without memory; of several local searches the best."""
    starts = np.stack(np.meshgrid(*3 * [[0.25, 0.5, 0.75]]), axis=-1).reshape(-1, 3)
    return max(
        -optimize.minimize(
            lambda policy: -capture_rate(policy, cells, steps), start, bounds=3 * [(0, 1)]
        ).fun
        for start in starts
    )


# ---- Numbers and tables --------------------------------------------------------------------------


def measured(runs: Runs, quick: bool) -> dict[str, Any]:
    """Return what the last pursuers and scripts capture, scores of races, and what is known."""
    sizes = SIZES[quick]

    def numbers_of(run: SavedRun) -> dict[str, Any]:
        if run.settings.schedule.name in SCHEDULES:
            scores = score(run)
            return {team: scores[team].means[-1] for team in TEAMS}
        if run.settings.world == catching_fleers.BASES[quick].world:
            return {"captured": captures(run.last("pursuer"), quick, sizes=sizes)}
        return {"captured": float(run.summary()["capture_rate"])}

    numbers = by_seed(runs, numbers_of)
    numbers |= {f"captured by {name}": captures(name, quick, sizes=sizes) for name in SCRIPTED}
    states = States(BOARD.world)
    for name in SCRIPTED:
        numbers[f"{name} on the board"] = [expected_payoff(states, name, each) for each in EVADERS]
    best = [best_response(states, each, "evader").value for each in EVADERS]
    return {**numbers, "sizes": sizes, "best": best, "without memory": without_memory()}


def corridor(numbers: Numbers) -> str:
    """Return the capture rates in the corridor."""
    rows = []
    for memory in MEMORIES:
        rates = numbers[f"corridor, {memory} / captured"]
        each = ", ".join(f"{rate:.3f}" for rate in rates)
        rows.append([f"memory: {memory}", share(rates), each])
    rows.append(["the best without memory, exactly", f"{numbers['without memory']:.3f} |"])
    return markdown(["corridor", "capture rate", "of each seed"], rows)


def board(numbers: Numbers) -> str:
    """Return the capture rates on the board by evader."""
    rows = [[name, *exactly(numbers[f"{name} on the board"])] for name in SCRIPTED]
    for memory in MEMORIES:
        rates = (numbers[f"board, {evaders}, {memory} / captured"] for evaders in EVADERS)
        rows.append([f"trained, memory: {memory}", *map(share, rates)])
    rows.append(["the best, exactly", *exactly(numbers["best"])])
    return markdown(["pursuers", *EVADERS], rows)


def share(rates: NDArray[np.float64]) -> str:
    """Return the mean of rates with its interval as text."""
    return mean(rates, 2, bounds=(0.0, 1.0))


def exactly(rates: NDArray[np.float64]) -> list[str]:
    """Return rates without intervals as text."""
    return [f"{rate:.3f}" for rate in rates]


def fleers(numbers: Numbers) -> str:
    """Return the capture rates of fleers and dodgers by team size."""
    names = {f"fleers, {each} / captured": f"{each} / captured" for each in MEMORIES}
    names["fleers, none / captured"] = "no memory / captured"
    trained = {short: numbers[name] for name, short in names.items()}
    others = {name: each for name, each in numbers.items() if " / " not in name}
    return catching_fleers.table({**trained, **others}, trained="trained, ")


def races(numbers: Numbers) -> str:
    """Return the held-out scores by schedule and memory."""
    rows = []
    for schedule in SCHEDULES:
        plain = [numbers[f"races, {schedule}, none / {team}"] for team in TEAMS]
        for memory in MEMORIES:
            scores = [numbers[f"races, {schedule}, {memory} / {team}"] for team in TEAMS]
            changes = ["", ""]
            if memory != "none":
                pairs = zip(scores, plain, strict=True)
                changes = [mean(each - before, 2, "+") for each, before in pairs]
            rows.append([schedule, memory, *map(share, scores), *changes])
    heads = ["memory", *(f"{team}s" for team in TEAMS), *(f"difference, {team}s" for team in TEAMS)]
    return markdown(["schedule", *heads], rows)


def table(numbers: Numbers) -> str:
    """Return the tables of all parts that have been played."""
    parts = {kind.split(",")[0] for kind in kinds_in(numbers)}
    tables = {"corridor": corridor, "fleers": fleers, "board": board, "races": races}
    return "\n\n".join(of(numbers) for part, of in tables.items() if part in parts)


if __name__ == "__main__":
    seeds = {kind: RACE_SEEDS if kind.startswith("races") else SEEDS for kind in kinds(False)}
    experiment(__doc__, kinds=kinds, measure=measured, table=table, seeds=seeds)
