"""The runs behind the paper's claims, and the numbers of them, in parts (see `PARTS`).

`paper_claims.py` says what follows from the numbers.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

import matrixworld as mw
from common import SAME_STEPS, SMALL_STEPS, finish_all, long_race
from matrixworld.analysis import team_phase_rates
from matrixworld.coevolution import (
    Against,
    RaceSettings,
    SavedRun,
    SingleTeam,
    Team,
    open_run,
    resume,
    score_policy,
    tournament,
)
from matrixworld.coevolution.types import other

SPECIALISTS, GENERALISTS = "specialist-specialist", "generalist-generalist"
MIXED = "generalist-specialist"
PURSUERS_ALONE = "pursuers against random"
EVADERS_ALONE, EVADERS_TAUGHT = "evaders against random", "evaders against trained"
EVADERS_IN_TENTHS = "evaders against random in tenths"
FEW_EPOCHS = "generalist-generalist with few epochs"
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
FEWER = 20
"""The race with few epochs has so many times fewer of them in each generation."""

Runs = Sequence[Mapping[str, SavedRun]]
"""Runs of each seed by name."""
Numbers = dict[str, np.ndarray]


@dataclass(frozen=True)
class Plan:
    """Settings of all runs, without their seeds.

    Parameters
    ----------
    race : RaceSettings
        Settings of the races, except for the schedule.
    pursuers, evaders : RaceSettings
        Baselines, with as many matches as the team plays in a race.
    few : RaceSettings
        A race with few epochs in each generation.
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
    few: RaceSettings
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

    few = race.changed(
        {
            f"schedule.{team}_epochs": max(1, race.schedule.epochs(team) // FEWER)
            for team in CANDIDATES
        }
    )
    return Plan(race, alone("pursuer"), alone("evader"), few, surround, long, every, episodes)


FULL = plan(
    RaceSettings.of(long_race("generalist-generalist")),
    RaceSettings.of(
        {
            "schedule": "against",
            "world.rules": "S",
            "learner.population": 48,
            "schedule.epochs": 1200,
            "schedule.archive_every": 200,
            **SMALL_STEPS["pursuer"],
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
            **SAME_STEPS,
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
    seeds: Mapping[str, range],
    root: Path,
    threads: int | None,
    where: str | None = None,
) -> dict[str, Runs]:
    """Return the finished runs of some parts; play the missing ones side by side.

    Parameters
    ----------
    plan : Plan
        Settings of the runs.
    seeds : mapping of str to range
        Training seeds of each part of `PARTS` that is wanted.
    root : Path
        Directory of all runs.
    threads : int or None
        Threads; None: one for each core.
    where : str, optional
        Value of ``--cluster``.

    Returns
    -------
    dict of str to sequence of dict of str to SavedRun
        Runs by name, for each part and seed.
    """
    settings = {part: PARTS[part].settings(plan) for part in seeds}
    planned = {
        place(name, seed): replace(each, seed=seed)
        for part, of_part in seeds.items()
        for seed in of_part
        for name, each in settings[part].items()
    }
    played = finish_all(planned, root, threads=threads, where=where)
    runs = {
        part: [{name: played[place(name, seed)] for name in settings[part]} for seed in of_part]
        for part, of_part in seeds.items()
    }
    # These continue from two of the runs above. There is one a seed.
    for seed, of_seed in zip(seeds.get(CROSS_PLAY, ()), runs.get(CROSS_PLAY, ()), strict=True):
        directory = root / place(EVADERS_TAUGHT, seed)
        of_seed[EVADERS_TAUGHT] = teach(plan, seed, of_seed, directory, threads)
    return dict(runs)


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


def cross_play(plan: Plan, team: Team, runs: Runs, threads: int | None) -> np.ndarray:
    """Play a team's candidates against the opponents of all races.

    Parameters
    ----------
    plan : Plan
        Settings of the runs.
    team : {"pursuer", "evader"}
        Team of the candidates.
    runs : Runs
        Runs of each seed.
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


def held_out(plan: Plan, team: Team, runs: Runs, threads: int | None) -> np.ndarray:
    """Return the mean payoff (kinds, seeds) of a team's candidates against held-out opponents."""
    own = [of_seed[kind].teams[team] for kind in CANDIDATES[team] for of_seed in runs]
    candidates = mw.Population(np.stack([each.genomes[-1] for each in own]), own[0].network)
    world = plan.race.world
    scores = score_policy(candidates, team, world, episodes=10 * plan.episodes, threads=threads)
    return scores.means.reshape(len(CANDIDATES[team]), len(runs))


# What is measured of the runs of a part, in the dtypes in which it is written:


def _captured(plan: Plan, runs: Runs, threads: int | None) -> Numbers:
    """Return ``captured NAME``, uint8 (seeds, n, n, episodes), of all races in the runs.

    These are the evaders captured in each episode of the payoff matrix.
    """
    numbers = {}
    for name in runs[0]:
        rates = np.stack([of_seed[name].payoff().capture_rates for of_seed in runs])
        captured = np.rint(rates * plan.race.world.n_evaders)
        numbers[f"captured {name}"] = captured.astype(np.uint8)
    return numbers


def _phases(plan: Plan, runs: Runs, threads: int | None) -> Numbers:
    """Return ``phases RACE`` (seeds, generations, 2): capture rates after both team phases."""
    return {
        f"phases {race}": np.array(
            [team_phase_rates(of_seed[name].payoff().capture_rate) for of_seed in runs], np.float32
        )
        for race, name in LONG.items()
    }


def _generalization(plan: Plan, runs: Runs, threads: int | None) -> Numbers:
    """Return ``cross-play of TEAM`` and ``held-out of TEAM``; see `cross_play` and `held_out`."""
    numbers = {}
    for team in CANDIDATES:
        # float32 halves the file and keeps far more digits than ten episodes give.
        numbers[f"cross-play of {team}s"] = cross_play(plan, team, runs, threads).astype("f4")
        numbers[f"held-out of {team}s"] = held_out(plan, team, runs, threads).astype("f4")
    return numbers


def _surrounding(plan: Plan, runs: Runs, threads: int | None) -> Numbers:
    """Return for each fitness of `SURROUNDING` ``captured`` and ``collisions``."""
    numbers = {}
    for name in SURROUNDING.values():
        both = surrounding(plan, [of_seed[name] for of_seed in runs], threads)
        for what, values in zip(("captured", "collisions"), both, strict=True):
            numbers[f"{name}: {what}"] = values.astype(np.float32)
    return numbers


def _tenths(plan: Plan, runs: Runs, threads: int | None) -> Numbers:
    """Return ``plateau: OPPONENTS`` (seeds, entries): escape rates after each tenth of the epochs.

    Opponents are the pursuers of the training, which move at random, and held-out ones.
    """
    world, episodes = plan.race.world, 10 * plan.episodes
    found: dict[str, list[np.ndarray]] = {"random": [], "held-out": []}
    for of_seed in runs:
        evaders = of_seed[EVADERS_IN_TENTHS].teams["evader"]
        each = mw.Matches.of(0, np.arange(len(evaders.genomes)), FIRST_TEST_SEED)
        scores = mw.rollout(world, "random", evaders, each, episodes=episodes, threads=threads)
        found["random"].append(1.0 - scores.capture_rate.mean(axis=1))
        against = score_policy(evaders, "evader", world, episodes=episodes, threads=threads)
        found["held-out"].append(against.means)
    return {f"plateau: {name}": np.array(rates, np.float32) for name, rates in found.items()}


def _safety(plan: Plan, runs: Runs, threads: int | None) -> Numbers:
    """Return how surrounding teams collide in training and in tests, and what they earn.

    For each fitness of `SURROUNDING`: ``rewards`` (seeds, 2), the mean return of the untrained and
    of the last team; ``colliding`` (seeds,), the share of episodes in which teammates of the last
    team collide; ``faults`` (seeds, 2), collisions at fault of pursuers per 1000 agent-steps in
    the last tenth of the training, and of the last team in tests. Tests are 100 new episodes.
    """
    world, numbers = plan.surround.world, {}
    for name in SURROUNDING.values():
        rewards, colliding, faults = [], [], []
        for of_seed in runs:
            log, teams = of_seed[name].log(), of_seed[name].teams["pursuer"]
            ends = mw.Matches.of([0, len(teams.genomes) - 1], 0, FIRST_TEST_SEED)
            tested = mw.rollout(world, teams, "random", ends, episodes=100, threads=threads)
            rewards.append(tested.pursuer_return.mean(axis=1))
            colliding.append((tested.collisions[1, :, 0, 1] > 0).mean())
            last = slice(-max(1, len(log["epoch"]) // 10), None)
            # All pursuers of -S live to the end.
            steps = world.n_pursuers * log["length"][last].sum()
            in_test = tested.faults[1, :, 0].sum() / tested.agent_steps[1, :, 0].sum()
            faults.append([log["pursuer_faults"][last].sum() / steps, in_test])
        numbers[f"{name}: rewards"] = np.array(rewards, np.float32)
        numbers[f"{name}: colliding"] = np.array(colliding, np.float32)
        numbers[f"{name}: faults"] = np.array(1000 * np.array(faults), np.float32)
    return numbers


FIRST_TEST_SEED = 10**6
"""Test episodes have seeds of their own; those of training are hashes."""


@dataclass(frozen=True)
class Part:
    """Runs of each seed, and what is measured of them.

    Parameters
    ----------
    settings : callable
        Plan -> settings of the runs of a seed by name, without the seed.
    measure : callable
        Plan, runs and threads -> numbers by name.
    seeds : int, optional
        Training seeds in the full size.
    """

    settings: Callable[[Plan], dict[str, RaceSettings]]
    measure: Callable[[Plan, Runs, int | None], Numbers]
    seeds: int = 20


def _races(plan: Plan) -> dict[str, RaceSettings]:
    return {race: plan.race.changed({"schedule": race}) for race in RACES}


def _surrounds(plan: Plan) -> dict[str, RaceSettings]:
    return {
        name: plan.surround.changed({"fitness.measure": aim}) for aim, name in SURROUNDING.items()
    }


def _long_races(plan: Plan) -> dict[str, RaceSettings]:
    return {
        name: plan.race.changed({"schedule": race, "schedule.generations": plan.long})
        for race, name in LONG.items()
    }


def _alone_in_tenths(plan: Plan) -> dict[str, RaceSettings]:
    every = plan.evaders.schedule.epochs // 10
    return {EVADERS_IN_TENTHS: plan.evaders.changed({"schedule.archive_every": every})}


CROSS_PLAY = "cross-play"
PARTS = {
    "races": Part(_races, _captured),
    CROSS_PLAY: Part(
        lambda plan: {
            **_races(plan), PURSUERS_ALONE: plan.pursuers, EVADERS_ALONE: plan.evaders,
        },
        _generalization,
    ),
    "surrounding": Part(_surrounds, _surrounding),
    "long": Part(_long_races, _phases, seeds=5),
    "plateau": Part(_alone_in_tenths, _tenths),
    "few-epochs": Part(
        lambda plan: {FEW_EPOCHS: plan.few.changed({"schedule": GENERALISTS})}, _captured
    ),
    "safety": Part(_surrounds, _safety),
}  # fmt: skip
"""The parts of the measurement by name. Parts share the runs that they have in common."""


def measured(plan: Plan, runs: Mapping[str, Runs], threads: int | None) -> Numbers:
    """Return the numbers of some parts by name, and ``evaders``, their number in a race."""
    numbers: Numbers = {"evaders": np.array(plan.race.world.n_evaders)}
    for part, of_part in runs.items():
        numbers |= PARTS[part].measure(plan, of_part, threads)
    return numbers
