"""Do races of policy gradients cycle or progress? The paper's three schedules, judged over seeds.

    python evolution/actor_critic_races.py             five seeds, some minutes on two cores
    python evolution/actor_critic_races.py --quick     a small world, some seconds

Both teams learn by policy gradients (actor-critic with GAE and PPO's clip) on a board of 20 x 20
cells. The schedules differ in the opponents that a team meets: the last generation of the other
team (specialist), or all of its generations in turn (generalist).

Each schedule is judged by `analysis.judge`, as races of neuroevolution are, over all seeds
together: the whole race, its first half and its last half. Gains are changes of mean capture or
escape over that part, against all opponents of the race.
"""

from __future__ import annotations

import numpy as np

from common import PPO, Numbers, Runs, by_seed, experiment, kinds_in, markdown, written
from matrixworld import analysis
from matrixworld.coevolution import SCHEDULES, RaceSettings

FULL = RaceSettings.of({
    **PPO, "world.rows": 20, "world.cols": 20, "world.n_pursuers": 3, "world.n_evaders": 8,
    "world.max_steps": 100, "train_steps": 100,
    "schedule.generations": 20, "schedule.pursuer_epochs": 10, "schedule.evader_epochs": 20,
})  # fmt: skip
QUICK = {
    "learner.population": 2, "policy.hidden": (4,),
    "world.rows": 8, "world.cols": 8, "world.n_evaders": 3, "world.fov": 5, "world.max_steps": 20,
    "train_steps": 15, "evaluation_episodes": 4,
    "schedule.generations": 8, "schedule.pursuer_epochs": 2, "schedule.evader_epochs": 2,
}  # fmt: skip


def kinds(quick: bool) -> dict[str, RaceSettings]:
    """Return the settings of a race of each schedule."""
    base = FULL.changed(QUICK if quick else {})
    return {schedule: base.changed({"schedule": schedule}) for schedule in SCHEDULES}


def measured(runs: Runs, quick: bool) -> Numbers:
    """Return the capture rates (n, n, episodes) of each race."""
    return by_seed(runs, lambda run: {"captured": run.payoff().scores.astype(np.float32)})


def table(numbers: Numbers) -> str:
    """Return gains and verdicts of each schedule in each window as a table in Markdown."""
    rows = []
    for schedule in kinds_in(numbers):
        judgement = analysis.judge(numbers[f"{schedule} / captured"], per_episode=True)
        for window, judged in judgement.windows.items():
            gains = (written(each, 2, "+") for each in judged["arms race"].estimates.values())
            verdicts = (judged[condition].verdict for condition in analysis.CONDITIONS)
            rows.append([schedule, window, *gains, *verdicts])
    heads = ["schedule", "part", "gain of pursuers", "gain of evaders", *analysis.CONDITIONS]
    return markdown(heads, rows)


if __name__ == "__main__":
    experiment(__doc__, kinds=kinds, measure=measured, table=table, seeds=5)
