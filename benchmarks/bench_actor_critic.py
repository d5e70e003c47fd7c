"""Does it pay to multiply only the ones of a view? An epoch of actor-critic learned both ways.

    python benchmarks/bench_actor_critic.py [--repeats 5]

CPU seconds in which the learner learns from the transitions of one epoch, on one core: with the
sparse products of the package, and with dense ones in the same process, in turn. The least of some
repeats counts: other programs can only add to it. Before the measurement, both ways have to give
the same weights. Needs PyTorch.
"""

from __future__ import annotations

import time
from typing import Any

import click
import numpy as np

from matrixworld.coevolution import RaceSettings, Team
from matrixworld.coevolution.learners import actor_critic
from matrixworld.coevolution.learners.transitions import experience
from matrixworld.world.policy import Population
from timing import bind, print_table

SMALL = {"policy.hidden": (32,), "learner.actor_updates": 5}
SURROUND = {"world.rules": "S", "world.n_pursuers": 20, "world.n_evaders": 5}
ROWS: dict[str, tuple[Team, dict[str, Any]]] = {
    "8 pursuers, 400-300, 1 of 500 steps: the defaults": ("pursuer", {}),
    "30 evaders, 400-300, 1 of 500 steps: the defaults": ("evader", {}),
    "20 pursuers of S, 400-300, 1 of 500 steps: as published": ("pursuer", SURROUND),
    "20 pursuers of S, 64, 2 of 500 steps, 12 updates of a quarter": (
        "pursuer",
        {
            **SURROUND, "policy.hidden": (64,), "learner.population": 2, "learner.minibatches": 4,
            "learner.actor_updates": 12, "learner.critic_updates": 12,
        },
    ),
    "8 pursuers, 32, 4 of 200 steps, 5 actor updates": (
        "pursuer", {**SMALL, "learner.population": 4, "train_steps": 200},
    ),
    "6 pursuers on 8 x 8 cells, 32, 16 of 60 steps, 5 actor updates": (
        "pursuer",
        {
            **SMALL, "learner.population": 16, "train_steps": 60, "world.n_pursuers": 6,
            "world.n_evaders": 1, "world.rows": 8, "world.cols": 8, "world.fov": 7,
        },
    ),
}  # fmt: skip
"""Team and settings of each row: network, matches of an epoch."""


class DenseInputs:
    """Rows (n, in) multiplied as a dense matrix, in the place of `actor_critic.Inputs`."""

    def __init__(self, rows: Any, torch: Any, device: Any) -> None:
        self.rows = len(rows)
        self._kept = torch.from_numpy(rows.copy())

    def __call__(self, weights: Any) -> Any:
        """Return the products (n, out) with weights (in, out)."""
        return self._kept.float() @ weights


WAYS = {"sparse": actor_critic.Inputs, "dense": DenseInputs}


def learned(team: Team, changes: dict[str, Any], way: str) -> tuple[float, Any]:
    """Return the CPU seconds of an epoch's learning, and the genome that it leads to."""
    alone = {"schedule": "against", "schedule.team": team, "learner": "actor-critic"}
    settings = RaceSettings.of({**alone, **changes})
    learner: Any = settings.new_learner(team, settings.untrained(team, 1))
    matches = settings.learner.population
    seen = experience(
        settings.training_world, team, Population(learner.genome, settings.network), "random",
        np.zeros(matches, int), np.arange(matches, dtype=np.uint64), threads=1,
    )  # fmt: skip
    actor_critic.Inputs = WAYS[way]  # type: ignore[misc, assignment]
    start = time.process_time()
    try:
        learner.learn(seen)
    finally:
        actor_critic.Inputs = WAYS["sparse"]  # type: ignore[misc, assignment]
    return time.process_time() - start, learner.genome


@click.command(help=(__doc__ or "").split("\n", 1)[0])
@click.option("--repeats", default=5, help="Repeats; the least counts.")
def main(repeats: int) -> None:
    bind(1)
    rows = []
    for name, (team, changes) in ROWS.items():
        genomes = [learned(team, changes, way)[1] for way in WAYS]
        np.testing.assert_allclose(*genomes, rtol=1e-3, atol=1e-5)
        taken: dict[str, list[float]] = {way: [] for way in WAYS}
        for _ in range(repeats):
            for way, times in taken.items():
                times.append(learned(team, changes, way)[0])
        sparse, dense = (min(times) for times in taken.values())
        rows.append([name, f"{sparse:.3f}", f"{dense:.3f}", f"{dense / sparse:.1f}"])
    print_table(["CPU seconds to learn from an epoch", "sparse", "dense", "ratio"], rows)


if __name__ == "__main__":
    main()
