"""Make what notebook 6 keeps: races with three kinds of opponents.

    python tutorials/make/chapter_6.py        5 minutes on one core; can be interrupted

``cures.npz``: ten small races with each of `SAMPLERS`, which differ in the past opponents that the
teams meet and in nothing else. All meet one opponent in an epoch. ``captured`` holds the evaders
captured in each episode of the payoff matrices, uint8, shape (samplers, seeds, n, n, episodes), out
of ``evaders``; ``matches`` (samplers, seeds) the training matches; ``cross_play`` (samplers, seeds,
samplers, seeds) the evaders that the last pursuers captured from the last evaders, out of
``cross_evaders``. Champions are those after the smallest number of matches that a race played.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
from races import DATA, SMALL, counts, finish
from tqdm import tqdm

import matrixworld as mw
from matrixworld._util.files import save_arrays
from matrixworld.coevolution import TEAMS, RaceSettings, SavedRun, tournament

SAMPLERS = ("latest", "round-robin", "uniform")
RUNS = Path("runs/chapter_6")
SEEDS = range(10)
RACE = RaceSettings.of({
    **SMALL, "schedule": "alternating", "schedule.generations": 20, "schedule.evader_epochs": 40,
    "world.rows": 16, "world.cols": 16, "world.n_pursuers": 4, "world.n_evaders": 8, "world.fov": 9,
    "world.max_steps": 200, "train_steps": 100, "learner.population": 32,
})  # fmt: skip
WORLD = RACE.game.world
CROSS_EPISODES = 5


def race(sampler: str, seed: int) -> RaceSettings:
    """Return the settings of a race whose teams meet opponents that a sampler chooses."""
    return RACE.changed(
        {"schedule.pursuers_meet": sampler, "schedule.evaders_meet": sampler, "seed": seed}
    )


def races() -> list[SavedRun]:
    """Return the finished races, sampler by sampler; play the missing ones."""
    return [
        finish(race(name, seed), RUNS / name / f"seed-{seed}")
        for name in SAMPLERS
        for seed in tqdm(SEEDS, desc=name)
    ]


def numbers_of(runs: list[SavedRun]) -> dict[str, np.ndarray]:
    """Return the arrays of ``cures.npz``."""
    shape = (len(SAMPLERS), len(SEEDS))
    rates = np.stack([run.payoff().scores for run in runs])
    matches = np.array([run.log()["matches"][-1] for run in runs])
    return {
        "samplers": np.array(SAMPLERS),
        "evaders": np.array(WORLD.n_evaders),
        "captured": counts(rates, WORLD.n_evaders).reshape(*shape, *rates.shape[1:]),
        "matches": matches.reshape(shape),
        "cross_play": cross_play(runs, int(matches.min())).reshape(*shape, *shape),
        "cross_evaders": np.array(WORLD.n_evaders * CROSS_EPISODES),
    }


def cross_play(runs: list[SavedRun], budget: int) -> np.ndarray:
    """Return how many evaders each run's pursuers captured from those of each other run."""
    champions = {
        team: mw.Population(
            np.stack([run.teams[team].genomes[run.generation_at(team, budget)] for run in runs]),
            runs[0].teams[team].policy,
        )
        for team in TEAMS
    }
    played = tournament(WORLD, *champions.values(), seed=0, episodes=CROSS_EPISODES)
    return counts(played.matrix, WORLD.n_evaders * CROSS_EPISODES)


if __name__ == "__main__":
    save_arrays(DATA / "cures.npz", numbers_of(races()))
