"""Make the kept results of notebook 7: races in which one team may give up.

    python tutorials/make/chapter_7.py      2 minutes of one core; can be interrupted

Plays three kinds of races of ten seeds each, and writes ``tutorials/course/data/chapter_7.npz``.
"""

from __future__ import annotations

import sys
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
from tqdm import tqdm

from matrixworld._util.files import save_arrays
from matrixworld.coevolution import EvolutionStrategy, RaceSettings, SavedRun
from matrixworld.coevolution.types import TEAMS, FloatArray

sys.path.append(str(Path(__file__).parents[1]))  # where the folder `course` lies
from races import DATA, SMALL, counts, penalised

from course.toys import reduced_virulence

RUNS = Path("runs/chapter_7")
SEEDS = range(10)
EPISODES = 30
"""Episodes of each pair that are kept, of 40, so that the file stays small."""
EVEN = RaceSettings.of({
    **SMALL, "schedule.generations": 14, "schedule.evader_epochs": 40, "world.rows": 12,
    "world.cols": 12, "world.n_pursuers": 4, "world.n_evaders": 8, "world.fov": 9,
    "world.max_steps": 300, "train_steps": 80, "learner.population": 24, "evaluation_episodes": 40,
})  # fmt: skip
FEW = EVEN.changed({"schedule.evader_epochs": 2})
RACES = {"even": EVEN, "few evader epochs": FEW, "restrained pursuers": FEW}
"""Settings of the races by name, without their seeds."""


class Restrained(EvolutionStrategy):
    """A learner that is selected by reduced virulence."""

    def fitness(self, *matches: Any) -> FloatArray:
        """Return the fitness (n,) of the candidates."""
        return reduced_virulence(super().fitness(*matches), 0.75)


def race(name: str, seed: int, runs: Path) -> SavedRun:
    """Return one of `RACES`; play it if it is missing in the directory `runs`."""
    directory = runs / name.replace(" ", "-") / str(seed)
    run = penalised(replace(RACES[name], seed=seed), directory, 0.5)
    if name == "restrained pursuers":
        run.training.learners["pursuer"] = Restrained(**vars(run.settings.learner))
    run.run()
    return SavedRun(directory)


def spread(run: SavedRun) -> np.ndarray:
    """Return the standard deviation of the candidates' fitness, float32 (generations, 2 teams)."""
    log = run.log()
    found = [
        log["fitness_std"][(log["generation"] == generation) & (log["team"] == team)].mean()
        for generation in range(1, EVEN.schedule.entries)
        for team in TEAMS
    ]
    return np.array(found, np.float32).reshape(-1, len(TEAMS))


def captures(run: SavedRun) -> np.ndarray:
    """Return the evaders captured in each episode, uint8 of shape (n, n, episodes)."""
    return counts(run.payoff().scores[..., :EPISODES], EVEN.game.world.n_evaders)


def main() -> None:
    arrays: dict[str, np.ndarray] = {"evaders": np.array(EVEN.game.world.n_evaders)}
    for name in RACES:
        played = [race(name, seed, RUNS) for seed in tqdm(SEEDS, desc=name)]
        arrays[f"captured: {name}"] = np.stack([captures(run) for run in played])
        arrays[f"spread of fitness: {name}"] = np.stack([spread(run) for run in played])
    save_arrays(DATA / "chapter_7.npz", arrays)


if __name__ == "__main__":
    main()
