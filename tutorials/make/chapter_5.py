"""Make what notebook 5 keeps: the paper's three schedules, ten races of full size each.

    python tutorials/make/chapter_5.py      one hour on two cores; can be interrupted

The races have twice the matches of default ones, and samples that do not spread with the genome.
``paper_races.npz`` holds ``evaders``, the number of evaders, and for each schedule, with ``_`` for
``-``, how many of them were captured in each episode of the payoff matrices: uint8, shape (10
seeds, 31 pursuer generations, 31 evader generations, 10 episodes).
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
from races import DATA, counts

from matrixworld._util.files import save_arrays
from matrixworld.coevolution import SCHEDULES, ProgressBar, RaceSettings, evolve

RUNS = Path("runs/chapter_5")
SEEDS = range(10)
EVADERS = RaceSettings().game.world.n_evaders


def settings_of(schedule: str, seed: int) -> RaceSettings:
    """Return the settings of a race."""
    return RaceSettings.of({
        "schedule": schedule, "schedule.pursuer_epochs": 60, "schedule.evader_epochs": 120,
        "learner.relative_sigma": 0.0, "learner.learning_rate": 0.02, "seed": seed,
    })  # fmt: skip


def main() -> None:
    wanted = {f"{name}/{seed}": settings_of(name, seed) for name in SCHEDULES for seed in SEEDS}
    with ProgressBar() as bars:
        runs = evolve(wanted, RUNS, report=bars)
    arrays = {"evaders": np.array(EVADERS)}
    for name in SCHEDULES:
        rates = [run.payoff().scores for run in runs if run.settings.schedule.name == name]
        arrays[name.replace("-", "_")] = counts(np.stack(rates), EVADERS)
    save_arrays(DATA / "paper_races.npz", arrays)


if __name__ == "__main__":
    main()
