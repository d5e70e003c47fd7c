"""Make the kept results of notebook 7: races in which one team may give up.

    python tutorials/make/chapter_7.py RUNS

Plays three kinds of races of ten seeds each in the directory RUNS (about 2 minutes of one core),
and writes ``tutorials/course/data/chapter_7.npz``. Finished races are not played again.
"""

from __future__ import annotations

import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
from tqdm import tqdm

from matrixworld._util.files import save_arrays
from matrixworld.coevolution import EvolutionStrategy, NoiseTable, RaceSettings, SavedRun, finish
from matrixworld.coevolution.types import TEAMS, FloatArray, Genome

sys.path.append(str(Path(__file__).parents[1]))  # where the folder `course` lies
from course.toys import reduced_virulence

DATA = Path(__file__).parents[1] / "course" / "data"
SEEDS = range(10)
EPISODES = 30
"""Episodes of each pair that are kept, of 40, so that the file stays small."""
EVEN = RaceSettings.of(
    {
        "world.rows": 12,
        "world.cols": 12,
        "world.n_pursuers": 4,
        "world.n_evaders": 8,
        "world.fov": 9,
        "policy.hidden": (16,),
        "learner.population": 24,
        "schedule.generations": 14,
        "schedule.pursuer_epochs": 20,
        "schedule.evader_epochs": 40,
        "learner.relative_sigma": 0.0,
        "learner.learning_rate": 0.02,
        "fitness.overlap_penalty": 0.5,
        "train_steps": 80,
        "world.max_steps": 300,
        "evaluation_episodes": 40,
    }
)
RACES = {
    "even": EVEN,
    "few evader epochs": EVEN.changed({"schedule.evader_epochs": 2}),
    "restrained pursuers": EVEN.changed(
        {
            "schedule.evader_epochs": 2,
            "learner": "chapter_7:Restrained",
            "learner.population": 24,
            "evader_learner": vars(EVEN.learner) | {"kind": "es"},
        }
    ),
}
"""Settings of the races by name, without their seeds."""


class Restrained(EvolutionStrategy):
    """The evolution strategy of the other races, of virulence 0.75."""

    def __init__(self, genome: Genome, samples: int, rng: np.random.Generator) -> None:
        how = EVEN.learner
        noise = NoiseTable(genome.size, rng, sigma=how.sigma)
        super().__init__(
            genome,
            noise,
            samples=samples,
            learning_rate=how.learning_rate,
            relative_sigma=how.relative_sigma,
        )

    def tell(self, fitness: FloatArray) -> None:
        """Take the captured fractions (n,) of the candidates, and select by reduced virulence."""
        super().tell(reduced_virulence(fitness, 0.75))


def race(name: str, seed: int, runs: Path) -> SavedRun:
    """Return one of `RACES`; play it if it is missing in the directory `runs`."""
    settings = replace(RACES[name], seed=seed)
    return finish(settings, runs / name.replace(" ", "-") / str(seed), threads=1)


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
    rates = run.payoff().capture_rates[..., :EPISODES]
    return np.rint(rates * EVEN.world.n_evaders).astype(np.uint8)


def main(runs: Path) -> None:
    arrays: dict[str, np.ndarray] = {"evaders": np.array(EVEN.world.n_evaders)}
    for name in RACES:
        played = [race(name, seed, runs) for seed in tqdm(SEEDS, desc=name)]
        arrays[f"captured: {name}"] = np.stack([captures(run) for run in played])
        arrays[f"spread of fitness: {name}"] = np.stack([spread(run) for run in played])
    save_arrays(DATA / "chapter_7.npz", arrays)


if __name__ == "__main__":
    main(Path(sys.argv[1]))
