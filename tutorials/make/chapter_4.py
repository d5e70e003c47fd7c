"""The results that notebook 4 shows: ten small races of specialists, and their held-out scores.

    python tutorials/make/chapter_4.py      about 3 minutes on two idle cores; can be interrupted

Writes ``chapter_4.npz`` into ``tutorials/course/data``:

- ``captured`` (seeds, generations, generations): evaders captured in all episodes of a pair,
- ``evaders_met`` (): evaders in these episodes; the quotient is the payoff matrix,
- ``generations`` (k,): the generations that were scored,
- ``pursuer``, ``evader`` (seeds, k): their mean scores against the held-out opponents.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
from races import DATA, SMALL, counts, finish

import matrixworld as mw
from matrixworld._util.files import save_arrays
from matrixworld.coevolution import TEAMS, RaceSettings, SavedRun, score_policy

RUNS = Path("runs/chapter_4")
SEEDS = range(10)
EVERY = 3  # generations from one that is scored to the next
EPISODES = 40  # of each generation against each held-out opponent


def settings(seed: int) -> RaceSettings:
    """Return the settings of a race."""
    return RaceSettings.of({
        **SMALL, "schedule": "specialist-specialist", "schedule.generations": 24,
        "schedule.evader_epochs": 50, "world.rows": 20, "world.cols": 20, "world.n_pursuers": 4,
        "world.n_evaders": 10, "world.max_steps": 200, "train_steps": 100,
        "learner.population": 32, "seed": seed,
    })  # fmt: skip


def scores(run: SavedRun, generations: np.ndarray) -> list[np.ndarray]:
    """Return the mean held-out scores (k,) of both teams."""
    world = run.settings.game.world
    found = []
    for team in TEAMS:
        genomes = mw.Population(run.teams[team].genomes[generations], run.teams[team].policy)
        scored = score_policy(genomes, team, world, episodes=EPISODES)
        found.append(scored.means.astype(np.float32))
    return found


def main() -> None:
    captured, held_out = [], []
    for seed in SEEDS:
        print(f"seed {seed}", flush=True)
        run = finish(settings(seed), RUNS / str(seed))
        generations = np.arange(0, run.settings.schedule.generations + 1, EVERY)
        captured.append(counts(run.payoff().scores.sum(axis=2), run.settings.game.world.n_evaders))
        held_out.append(scores(run, generations))
    pursuer, evader = np.array(held_out).swapaxes(0, 1)
    met = run.settings.evaluation_episodes * run.settings.game.world.n_evaders
    arrays = {"captured": np.array(captured), "evaders_met": np.array(met)}
    arrays |= {"generations": generations, "pursuer": pursuer, "evader": evader}
    save_arrays(DATA / "chapter_4.npz", arrays)


if __name__ == "__main__":
    main()
