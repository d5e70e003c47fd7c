"""The runs behind the paper's claims: races, baselines and surrounding, and the numbers of them.

`paper_claims.py` says what follows from the numbers.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

import matrixworld as mw
from common import finish_all
from matrixworld.analysis import team_phase_rates
from matrixworld.coevolution import (
    Against,
    RaceSettings,
    SavedRun,
    SingleTeam,
    Team,
    open_run,
    resume,
    tournament,
)
from matrixworld.coevolution.evaluation.scores import score_population
from matrixworld.coevolution.types import other

SPECIALISTS, GENERALISTS = "specialist-specialist", "generalist-generalist"
MIXED = "generalist-specialist"
PURSUERS_ALONE = "pursuers against random"
EVADERS_ALONE, EVADERS_TAUGHT = "evaders against random", "evaders against trained"
SURROUNDING = {
    "rewards": "surrounding for rewards",
    "captured-fraction": "surrounding for captures",
}
RACES = (SPECIALISTS, MIXED, GENERALISTS)
LONG = {race: f"long {race}" for race in (SPECIALISTS, GENERALISTS)}
"""Races of more generations, by schedule."""
CANDIDATES: dict[Team, tuple[str, ...]] = {
    "pursuer": (*RACES, PURSUERS_ALONE),
    "evader": (*RACES, EVADERS_ALONE, EVADERS_TAUGHT),
}
"""Runs whose last generation is tested, by team."""


@dataclass(frozen=True)
class Plan:
    """Settings of all runs, without their seeds.

    Parameters
    ----------
    race : RaceSettings
        Settings of the races, except for the schedule.
    pursuers, evaders : RaceSettings
        Baselines, with as many matches as the team plays in a race.
    surround : RaceSettings
        Surrounding runs, one for each fitness of `SURROUNDING`.
    long : int
        Generations of the long races.
    every : int
        Distance of the generations of a race that are test opponents.
    episodes : int
        Episodes of each pair in the cross-play.
    """

    race: RaceSettings
    pursuers: RaceSettings
    evaders: RaceSettings
    surround: RaceSettings
    long: int
    every: int
    episodes: int


def plan(
    race: RaceSettings, surround: RaceSettings, *, long: int, every: int, episodes: int
) -> Plan:
    """Return a plan whose baselines have the world, the budget and the settings of the race."""

    def alone(team: Team) -> RaceSettings:
        # As many epochs as the team has in a race, and every other setting of the race: the same
        # number of matches, training steps, step sizes and penalties.
        epochs = race.schedule.total_epochs(team)
        # The penalty is one of evaders; pursuers take no such setting.
        penalty = race.overlap_penalty if team == "evader" else None
        return replace(
            race,
            schedule=Against(team=team, epochs=epochs, archive_every=epochs // 2),
            fitness=replace(race.fitness, overlap_penalty=penalty),
        )

    return Plan(race, alone("pursuer"), alone("evader"), surround, long, every, episodes)


FULL = plan(
    RaceSettings(),
    RaceSettings.of(
        {
            "schedule": "against",
            "world.rules": "S",
            "learner.population": 48,
            "schedule.epochs": 1200,
            "schedule.archive_every": 200,
        }
    ),
    long=100,
    every=5,
    episodes=10,
)
TINY = {
    "world.rows": 12, "world.cols": 12, "learner.population": 8, "train_steps": 40,
    "world.max_steps": 60,
}  # fmt: skip
QUICK = plan(
    RaceSettings.of(
        {
            "world.n_pursuers": 3,
            "world.n_evaders": 6,
            "schedule.generations": 6,
            "schedule.pursuer_epochs": 4,
            "schedule.evader_epochs": 4,
            **TINY,
        }
    ),
    RaceSettings.of(
        {
            "schedule": "against",
            "world.rules": "S",
            "world.n_pursuers": 8,
            "world.n_evaders": 2,
            "schedule.epochs": 20,
            "schedule.archive_every": 5,
            "evaluation_episodes": 5,
            **TINY,
        }
    ),
    long=9,
    every=1,
    episodes=4,
)


def play(
    plan: Plan,
    seeds: Sequence[int],
    root: Path,
    threads: int | None,
    *,
    long: Collection[int] = (),
    where: str | None = None,
) -> list[dict[str, SavedRun]]:
    """Return the finished runs of each seed; play the missing ones side by side.

    Parameters
    ----------
    plan : Plan
        Settings of the runs.
    seeds : sequence of int
        Training seeds.
    root : Path
        Directory of all runs.
    threads : int or None
        Threads; None: one for each core.
    long : collection of int, optional
        Seeds of the long races.
    where : str, optional
        Value of ``--cluster``.

    Returns
    -------
    list of dict of str to SavedRun
        Runs by name, for each seed.
    """
    planned = {
        (name, seed): replace(settings, seed=seed)
        for seed in seeds
        for name, settings in planned_runs(plan, long=seed in long).items()
    }
    played = finish_all(
        {place(*key): settings for key, settings in planned.items()},
        root,
        threads=threads,
        where=where,
    )
    runs: list[dict[str, SavedRun]] = [
        {name: played[place(name, seed)] for name, each in planned if each == seed}
        for seed in seeds
    ]
    # These continue from two of the runs above. There is one a seed.
    for seed, of_seed in zip(seeds, runs, strict=True):
        directory = root / place(EVADERS_TAUGHT, seed)
        of_seed[EVADERS_TAUGHT] = teach(plan, seed, of_seed, directory, threads)
    return runs


def planned_runs(plan: Plan, *, long: bool) -> dict[str, RaceSettings]:
    """Return the settings of all runs of a seed that need no other run, by name."""
    planned: dict[str, RaceSettings] = {
        **{name: plan.race.changed({"schedule": name}) for name in RACES},
        PURSUERS_ALONE: plan.pursuers,
        EVADERS_ALONE: plan.evaders,
        **{
            name: plan.surround.changed({"fitness.measure": aim})
            for aim, name in SURROUNDING.items()
        },
    }
    if long:
        planned |= {
            name: plan.race.changed({"schedule": race, "schedule.generations": plan.long})
            for race, name in LONG.items()
        }
    return planned


def place(name: str, seed: int) -> str:
    """Return the path of a run in the directory of all runs."""
    return f"{name.replace(' ', '-')}/{seed}"


def teach(
    plan: Plan, seed: int, runs: Mapping[str, SavedRun], directory: Path, threads: int | None
) -> SavedRun:
    """Return evaders after half of their baseline, then trained against trained pursuers."""
    if not (directory / "config.json").exists():
        half = plan.evaders.schedule.archive_every
        settings = plan.evaders.changed({"seed": seed, "schedule.epochs": half})
        genome = runs[EVADERS_ALONE].teams["evader"].genomes[1]
        rivals = runs[PURSUERS_ALONE].teams["pursuer"]
        champion = mw.Population(rivals.genomes[-1:], rivals.network)
        SingleTeam(settings, directory, opponents=champion, start=genome)
    resume(directory, threads=threads).run()
    return open_run(directory)


def cross_play(
    plan: Plan, team: Team, runs: Sequence[Mapping[str, SavedRun]], threads: int | None
) -> np.ndarray:
    """Play a team's candidates against the opponents of all races.

    Parameters
    ----------
    plan : Plan
        Settings of the runs.
    team : {"pursuer", "evader"}
        Team of the candidates.
    runs : sequence of mapping of str to SavedRun
        Runs of each seed by name.
    threads : int or None
        Threads; None: one for each core.

    Returns
    -------
    ndarray of float64, shape (kinds, seeds, races, seeds, generations)
        Payoff of each kind of `CANDIDATES` and seed against every so many generations of each race
        and seed.
    """
    own = [of_seed[kind].teams[team] for kind in CANDIDATES[team] for of_seed in runs]
    rivals = [of_seed[race].teams[other(team)] for race in RACES for of_seed in runs]
    # One population of all candidates and one of all opponents: a single tournament.
    candidates = mw.Population(np.stack([each.genomes[-1] for each in own]), own[0].network)
    opponents = np.concatenate([each.genomes[:: plan.every] for each in rivals])
    met = mw.Population(opponents, rivals[0].network)
    pursuers, evaders = (candidates, met) if team == "pursuer" else (met, candidates)
    world = plan.race.world
    played = tournament(
        world, pursuers, evaders, seed=0, episodes=plan.episodes, threads=threads
    ).capture_rate
    payoff = played if team == "pursuer" else 1.0 - played.T
    return payoff.reshape(len(CANDIDATES[team]), len(runs), len(RACES), len(runs), -1)


def surrounding(
    plan: Plan, runs: Sequence[SavedRun], threads: int | None
) -> tuple[np.ndarray, np.ndarray]:
    """Return capture rate, and collisions between pursuers per 1000 of their agent-steps.

    Both have the shape (seeds, entries of the archive); 100 episodes each.
    """
    captured, collisions = [], []
    for run in runs:
        pursuers = run.teams["pursuer"]
        each = np.arange(len(pursuers.genomes))
        world = plan.surround.world
        scores = mw.rollout(
            world, pursuers, "random", mw.Matches.of(each, 0, each), episodes=100, threads=threads
        )
        captured.append(scores.capture_rate.mean(axis=1))
        steps = scores.agent_steps[:, :, 0].sum(axis=1)
        collisions.append(1000 * scores.collisions[:, :, 0, 1].sum(axis=1) / steps)
    return np.array(captured), np.array(collisions)


def held_out(
    plan: Plan, team: Team, runs: Sequence[Mapping[str, SavedRun]], threads: int | None
) -> np.ndarray:
    """Return the mean payoff (kinds, seeds) of a team's candidates against held-out opponents."""
    own = [of_seed[kind].teams[team] for kind in CANDIDATES[team] for of_seed in runs]
    candidates = mw.Population(np.stack([each.genomes[-1] for each in own]), own[0].network)
    world = plan.race.world
    scores = score_population(world, team, candidates, episodes=10 * plan.episodes, threads=threads)
    return scores.means.reshape(len(CANDIDATES[team]), len(runs))


def measured(
    plan: Plan, runs: Sequence[Mapping[str, SavedRun]], threads: int | None
) -> dict[str, np.ndarray]:
    """Return all numbers behind the claims by name, in the dtypes in which they are written.

    Parameters
    ----------
    plan : Plan
        Settings of the runs.
    runs : sequence of mapping of str to SavedRun
        Runs of each seed by name.
    threads : int or None
        Threads; None: one for each core.

    Returns
    -------
    dict of str to ndarray
        ``captured RACE``, uint8, shape (seeds, n, n, episodes): evaders captured in each episode of
        the payoff matrix; ``evaders``: their number; ``phases RACE``, shape (seeds, generations,
        2): capture rates after both team phases of the long races; ``cross-play of TEAM``: see
        `cross_play`; ``held-out of TEAM``: see `held_out`; and for each fitness of `SURROUNDING`
        ``captured`` and ``collisions``, see `surrounding`.
    """
    evaders = plan.race.world.n_evaders
    numbers: dict[str, np.ndarray] = {"evaders": np.array(evaders)}
    for race in RACES:
        rates = np.stack([of_seed[race].payoff().capture_rates for of_seed in runs])
        numbers[f"captured {race}"] = np.rint(rates * evaders).astype(np.uint8)
    longer = [of_seed for of_seed in runs if set(LONG.values()) <= set(of_seed)]
    for race, name in LONG.items():
        phases = [team_phase_rates(of_seed[name].payoff().capture_rate) for of_seed in longer]
        numbers[f"phases {race}"] = np.array(phases, dtype=np.float32)
    # float32 halves the file and keeps far more digits than ten episodes give.
    for team in CANDIDATES:
        numbers[f"cross-play of {team}s"] = cross_play(plan, team, runs, threads).astype("f4")
        numbers[f"held-out of {team}s"] = held_out(plan, team, runs, threads).astype("f4")
    for name in SURROUNDING.values():
        both = surrounding(plan, [of_seed[name] for of_seed in runs], threads)
        for what, values in zip(("captured", "collisions"), both, strict=True):
            numbers[f"{name}: {what}"] = values.astype(np.float32)
    return numbers
