"""Make what notebook 6b keeps: races with six kinds of opponents, and halls of fame compared.

    python tutorials/make/chapter_6.py        10 minutes on one core; can be interrupted

``cures.npz``: ten small races with each of `SAMPLERS`, which differ in the past opponents that the
teams meet and in nothing else. All meet one opponent in an epoch. ``captured`` holds the evaders
captured in each episode of the payoff matrices, uint8, shape (samplers, seeds, n, n, episodes), out
of ``evaders``; ``matches`` (samplers, seeds) the training matches, with those that archives play to
compare candidates; ``cross_play`` (samplers, seeds, samplers, seeds) the evaders that the last
pursuers captured from the last evaders, out of ``cross_evaders``. Champions are those after the
smallest number of matches that a race played.

``numbers_game.npz``: ``ones`` (2, 20) in the last generation of the intransitive numbers game, mean
of both populations, for 20 seeds; first with 15 living opponents, then with 10 living ones and 5
champions of earlier generations.

``halls.npz``: the numbers of each race in ``evolution/results/hall_of_fame/numbers.npz``, as
``python evolution/hall_of_fame.py`` has written them, float32, shape (2, seeds) each: first without
halls of fame, then with them.
"""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

import numpy as np
from tqdm import tqdm

import matrixworld as mw
from matrixworld._util.files import save_arrays
from matrixworld.coevolution import (
    TEAMS,
    ProgressBar,
    RaceSettings,
    SavedRun,
    evolve,
    tournament,
)
from matrixworld.coevolution.opponents import Uniform

sys.path.append(str(Path(__file__).parents[1]))  # where the folder `course` lies

from course import toys
from course.questions import DATA

SAMPLERS = ("latest", "round-robin", "uniform", "maxsolve", "ipca", "lapca")
SEEDS = range(10)
SMALL = RaceSettings.of(
    {
        "schedule": "alternating",
        "world.rows": 16,
        "world.cols": 16,
        "world.n_pursuers": 4,
        "world.n_evaders": 8,
        "world.fov": 9,
        "policy.hidden": (16,),
        "schedule.generations": 20,
        "schedule.pursuer_epochs": 20,
        "schedule.evader_epochs": 40,
        "learner.relative_sigma": 0.0,
        "learner.learning_rate": 0.02,
        "learner.population": 32,
        "fitness.overlap_penalty": 0.5,
        "train_steps": 100,
        "world.max_steps": 200,
    }
)
CROSS_EPISODES = 5
HALLS = Path(__file__).parents[2] / "evolution/results/hall_of_fame/numbers.npz"


def race(sampler: str, seed: int) -> RaceSettings:
    """Return the settings of a race whose teams meet opponents that a sampler chooses."""
    return SMALL.changed(
        {"schedule.pursuers_meet": sampler, "schedule.evaders_meet": sampler, "seed": seed}
    )


def races(directory: Path, threads: int | None) -> list[SavedRun]:
    """Return the finished races, sampler by sampler; play the missing ones."""
    settings = {f"{name}/seed-{seed}": race(name, seed) for name in SAMPLERS for seed in SEEDS}
    with ProgressBar() as bars:
        return evolve(settings, directory, threads=threads, report=bars)


def numbers_of(runs: list[SavedRun]) -> dict[str, np.ndarray]:
    """Return the arrays of ``cures.npz``."""
    shape = (len(SAMPLERS), len(SEEDS))
    rates = np.stack([run.payoff().capture_rates for run in runs])
    matches = np.array([run.log()["matches"][-1] for run in runs])
    return {
        "samplers": np.array(SAMPLERS),
        "evaders": np.array(SMALL.world.n_evaders),
        "captured": counts(rates, SMALL.world.n_evaders).reshape(*shape, *rates.shape[1:]),
        "matches": matches.reshape(shape),
        "cross_play": cross_play(runs, int(matches.min())).reshape(*shape, *shape),
        "cross_evaders": np.array(SMALL.world.n_evaders * CROSS_EPISODES),
    }


def cross_play(runs: list[SavedRun], budget: int) -> np.ndarray:
    """Return how many evaders each run's pursuers captured from those of each other run."""
    champions = {
        team: mw.Population(
            np.stack([run.teams[team].genomes[run.generation_at(team, budget)] for run in runs]),
            runs[0].teams[team].network,
        )
        for team in TEAMS
    }
    world = SMALL.world
    played = tournament(
        world, champions["pursuer"], champions["evader"], seed=0, episodes=CROSS_EPISODES
    )
    return counts(played.capture_rate, SMALL.world.n_evaders * CROSS_EPISODES)


def counts(rates: np.ndarray, evaders: int) -> np.ndarray:
    """Return capture rates as numbers of evaders."""
    return np.rint(rates * evaders).astype(np.uint8)


def numbers_games() -> dict[str, np.ndarray]:
    """Return the array of ``numbers_game.npz``."""
    living, hall = [], []
    for seed in tqdm(range(20), unit=" seeds", disable=None):
        living.append(toys.numbers_game("intransitive", seed, opponents=15))
        samplers = (Uniform(5), Uniform(5))
        hall.append(toys.numbers_game("intransitive", seed, opponents=10, samplers=samplers))
    ones = [[game.final_objective.mean() for game in games] for games in (living, hall)]
    return {"ones": np.array(ones, dtype=np.float32)}


def halls() -> dict[str, np.ndarray]:
    """Return the arrays of ``halls.npz``."""
    found: dict[str, list[np.ndarray]] = {}
    with np.load(HALLS) as numbers:
        for name in numbers.files:  # kind by kind
            _, number = name.split(" / ")
            found.setdefault(number, []).append(numbers[name])
    return {number: np.array(kinds, dtype=np.float32) for number, kinds in found.items()}


def main() -> None:
    parser = argparse.ArgumentParser(description=(__doc__ or "").split("\n", 1)[0])
    parser.add_argument("--runs", type=Path, default=Path("runs/chapter_6"))
    parser.add_argument("--threads", type=int, help="default: one for each core")
    args = parser.parse_args()
    save_arrays(DATA / "halls.npz", halls())
    save_arrays(DATA / "numbers_game.npz", numbers_games())
    save_arrays(DATA / "cures.npz", numbers_of(races(args.runs, args.threads)))
    for name in ("halls", "numbers_game", "cures"):
        print(f"Written: {DATA / name}.npz, {(DATA / f'{name}.npz').stat().st_size / 1e3:.0f} kB")


if __name__ == "__main__":
    main()
