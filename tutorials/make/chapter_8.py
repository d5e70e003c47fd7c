"""Make the kept results of notebook 8: what a team learns from different sequences of opponents.

    python tutorials/make/chapter_8.py RUNS

Trains ten seeds in the directory RUNS (about 8 minutes of one core), tests all teams against the
same opponents, and writes ``tutorials/course/data/chapter_8.npz``. What is finished is not
played again.
"""

from __future__ import annotations

import sys
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np
from penalised import finish
from tqdm import tqdm

import matrixworld as mw
from matrixworld._util.files import save_arrays
from matrixworld.coevolution import Against, RaceSettings, SavedRun, Team, held_out
from matrixworld.coevolution.types import TEAMS, other
from matrixworld.world.policy import TeamPolicy

DATA = Path(__file__).parents[1] / "course" / "data"
SEEDS = range(10)
RACE = RaceSettings.of(
    {
        "world.rows": 20,
        "world.cols": 20,
        "world.n_pursuers": 3,
        "world.n_evaders": 8,
        "policy.hidden": (16,),
        "learner.population": 32,
        "schedule.generations": 20,
        "schedule.pursuer_epochs": 50,
        "schedule.evader_epochs": 50,
        "learner.relative_sigma": 0.0,
        "learner.learning_rate": 0.02,
        "train_steps": 100,
        "world.max_steps": 100,
    }
)
LADDERS: dict[Team, tuple[str, ...]] = {
    "pursuer": ("random", "clumsy-fleer", "fleer", "dodger"),
    "evader": ("random", "clumsy-chaser", "chaser", "hunter"),
}
"""Opponents of each team, from easy to hard."""
STAGES = 4
EPISODES, EPISODES_OF_RACES = 100, 20
"""Episodes against each test opponent, and against the team of each race."""


def orders(team: Team) -> dict[str, tuple[str, ...]]:
    """Return the opponents of each stage, by the name of the sequence."""
    ladder = LADDERS[team]
    return {"random only": ladder[:1] * STAGES, "easy to hard": ladder}


def alone(team: Team) -> RaceSettings:
    """Return the settings of one stage: a quarter of the epochs of the race, else the same."""
    epochs = RACE.schedule.total_epochs(team) // STAGES
    return replace(RACE, schedule=Against(team=team, epochs=epochs, archive_every=epochs))


def taught(team: Team, name: str, seed: int, runs: Path) -> np.ndarray:
    """Return the genomes (stages + 1, genes) of a team after each stage of a sequence."""
    genomes, before = [], None
    for stage, opponent in enumerate(orders(team)[name]):
        directory = runs / team / name.replace(" ", "-") / str(seed) / str(stage)
        start = None if before is None else str(before)
        # A seed of its own for each stage: otherwise all stages would play the same matches.
        settings = alone(team).changed(
            {"seed": STAGES * seed + stage, "schedule.opponent": opponent, "schedule.start": start}
        )
        run = finish(settings, directory, RACE.training_game.penalty)
        archive = run.teams[team].genomes
        genomes += [archive[-1]] if genomes else [archive[0], archive[-1]]
        before = directory
    return np.stack(genomes)


def tested(team: Team, genomes: np.ndarray, opponent: TeamPolicy, episodes: int) -> np.ndarray:
    """Return the evaders that each genome (n, genes) captures, or saves, per 1000: uint16 (n,)."""
    own, index = mw.Population(genomes, RACE.evaluation_game.policy), np.arange(len(genomes))
    world = RACE.world
    if team == "pursuer":
        scores = mw.rollout(
            world, own, opponent, mw.Matches.of(index, 0, 0), episodes=episodes, threads=1
        )
        rates = scores.capture_rate
    else:
        scores = mw.rollout(
            world, opponent, own, mw.Matches.of(0, index, 0), episodes=episodes, threads=1
        )
        rates = 1.0 - scores.capture_rate
    return np.rint(1000 * rates.mean(axis=1)).astype(np.uint16)


def main(runs: Path) -> None:
    races: list[SavedRun] = [
        finish(replace(RACE, seed=seed), runs / "races" / str(seed), RACE.training_game.penalty)
        for seed in tqdm(SEEDS, desc="races")
    ]
    arrays: dict[str, np.ndarray] = {}
    for team in TEAMS:
        learned = {
            name: np.stack([taught(team, name, s, runs) for s in tqdm(SEEDS, f"{team}s, {name}")])
            for name in orders(team)
        }
        last = {name: genomes[:, -1] for name, genomes in learned.items()}
        last["co-evolution"] = np.stack([race.teams[team].genomes[-1] for race in races])
        arrays |= examined(team, last, races, ~np.eye(len(SEEDS), dtype=bool))
        if team == "evader":  # the films
            arrays["evaders: genomes"] = np.stack([each[0] for each in last.values()]).astype("f2")
        else:  # what is forgotten on the way
            arrays["pursuers: ladder"] = climbed(learned["easy to hard"])
    save_arrays(DATA / "chapter_8.npz", arrays)


def climbed(genomes: np.ndarray) -> np.ndarray:
    """Return the scores (seeds, stages + 1, scripts) of pursuers after each stage."""
    flat = genomes.reshape(-1, RACE.evaluation_game.policy.genome_size)
    scores = [tested("pursuer", flat, script, EPISODES) for script in LADDERS["pursuer"]]
    return np.stack(scores, axis=-1).reshape(len(SEEDS), STAGES + 1, STAGES)


def examined(
    team: Team, last: dict[str, np.ndarray], races: list[SavedRun], strangers: np.ndarray
) -> dict[str, np.ndarray]:
    """Return the mean scores (schools, seeds) of all teams with each sort of examiners.

    `strangers` (seeds, races) says which races a team has not met: the others are left out.
    """
    genomes = np.concatenate(list(last.values()))
    fixed = held_out(other(team), "O")
    evolved = [policy for name, policy in fixed.items() if name.startswith("evolved")]
    rivals = [race.teams[other(team)] for race in races]
    teams = [mw.Population(each.genomes[-1:], each.policy) for each in rivals]

    def rates(opponents: Sequence[TeamPolicy], episodes: int) -> np.ndarray:
        scores = [tested(team, genomes, each, episodes) / 1000 for each in opponents]
        return np.stack(scores, axis=-1).reshape(len(last), -1, len(opponents))

    return {
        f"{team}s: kinds": np.array([*last]),
        f"{team}s: scripts": rates(LADDERS[team], EPISODES).mean(axis=2),
        f"{team}s: evolved strangers": rates(evolved, EPISODES).mean(axis=2),
        f"{team}s: co-evolved rivals": (rates(teams, EPISODES_OF_RACES) * strangers).sum(axis=2)
        / strangers.sum(axis=1),
    }


if __name__ == "__main__":
    main(Path(sys.argv[1]))
