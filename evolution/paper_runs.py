"""The runs behind the paper's claims, and the numbers of them.

`paper_claims.py` says what follows from the numbers.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np

import matrixworld as mw
from common import (
    FIRST_TEST_SEED,
    SAME_STEPS,
    SMALL_STEPS,
    Runs,
    finish_with_penalty_of_races,
    long_race,
    pairs,
    scores_against,
    slug,
)
from matrixworld import coevolution
from matrixworld.analysis import team_phase_rates
from matrixworld.coevolution.types import other

SPECIALISTS, GENERALISTS = "specialist-specialist", "generalist-generalist"
MIXED = "generalist-specialist"
PURSUERS_ALONE = "pursuers against random"
EVADERS_ALONE, EVADERS_TAUGHT = "evaders against random", "evaders against trained"
IN_TENTHS = "evaders in tenths"
FEW_EPOCHS = "generalist-generalist with few epochs"
SURROUNDING = {
    "rewards": "surrounding for rewards",
    "captured-fraction": "surrounding for captures",
}
RACES = (SPECIALISTS, MIXED, GENERALISTS)
LONG = {race: f"long, {race}" for race in (SPECIALISTS, GENERALISTS)}
"""Kinds of the races of more generations, by schedule."""
CANDIDATES: dict[coevolution.Team, tuple[str, ...]] = {
    "pursuer": (*RACES, PURSUERS_ALONE),
    "evader": (*RACES, EVADERS_ALONE, EVADERS_TAUGHT),
}
"""Runs whose last generation is tested, by team."""
FEWER = 20
"""The race with few epochs has so many times fewer of them in each generation."""

Numbers = dict[str, np.ndarray]


TINY = {
    "world.rows": 12, "world.cols": 12, "world.max_steps": 60, "train_steps": 40,
    "learner.population": 8,
}  # fmt: skip
QUICK_RACE = {
    **SAME_STEPS, **TINY, "world.n_pursuers": 3, "world.n_evaders": 6, "schedule.generations": 6,
    "schedule.pursuer_epochs": 4, "schedule.evader_epochs": 4,
}  # fmt: skip
SURROUND = coevolution.RaceSettings.of({
    "schedule": "against", "schedule.epochs": 1200, "schedule.archive_every": 200,
    "world.rules": "S", "learner.population": 48, **SMALL_STEPS["pursuer"],
})  # fmt: skip
QUICK_SURROUND = {
    **TINY, "schedule.epochs": 20, "schedule.archive_every": 5, "world.n_pursuers": 8,
    "world.n_evaders": 2, "evaluation_episodes": 5,
}  # fmt: skip
GENERATIONS = {False: 100, True: 9}
EVERY, EPISODES = {False: 5, True: 1}, {False: 10, True: 4}
"""Generations of the long races; distance of the generations of a race that are opponents in the
cross-play, and episodes of each pair; with ``--quick`` or not."""


def kinds(quick: bool) -> dict[str, coevolution.RaceSettings]:
    """Return the settings of each kind of run."""
    race = coevolution.RaceSettings.of(QUICK_RACE if quick else long_race(GENERALISTS))
    surround = SURROUND.changed(QUICK_SURROUND if quick else {})
    few = {
        f"schedule.{team}_epochs": max(1, race.schedule.epochs(team) // FEWER)
        for team in CANDIDATES
    }
    evaders = alone(race, "evader")
    tenth = evaders.schedule.epochs // 10
    return {
        **{name: race.changed({"schedule": name}) for name in RACES},
        PURSUERS_ALONE: alone(race, "pursuer"),
        EVADERS_ALONE: evaders,
        **{name: surround.changed({"learner.measure": aim}) for aim, name in SURROUNDING.items()},
        **{
            name: race.changed({"schedule": each, "schedule.generations": GENERATIONS[quick]})
            for each, name in LONG.items()
        },
        IN_TENTHS: evaders.changed({"schedule.archive_every": tenth}),
        FEW_EPOCHS: race.changed(few).changed({"schedule": GENERALISTS}),
    }


def alone(race: coevolution.RaceSettings, team: coevolution.Team) -> coevolution.RaceSettings:
    """Return the settings of a baseline, with the matches and all settings of the race."""
    epochs = race.schedule.total_epochs(team)
    return replace(
        race, schedule=coevolution.Against(team=team, epochs=epochs, archive_every=epochs // 2)
    )


def teach(runs: Runs) -> list[coevolution.SavedRun]:
    """Return evaders after half of their baseline, then trained against trained pursuers."""
    found = []
    for begun, rival in pairs(runs, EVADERS_ALONE, PURSUERS_ALONE):
        directory = begun.path.parents[1] / slug(EVADERS_TAUGHT) / str(begun.settings.seed)
        if not coevolution.SavedRun(directory).exists:
            half = begun.settings.schedule.archive_every
            settings = begun.settings.changed({"schedule.epochs": half})
            genome = begun.teams["evader"].genomes[1]
            coevolution.create(settings, directory, opponents=rival.last("pursuer"), start=genome)
        found.append(finish_with_penalty_of_races(directory))
    return found


def last_of(team: coevolution.Team, runs: Runs) -> mw.Population:
    """Return the last generation of each kind of `CANDIDATES` and seed as one population."""
    last = [run.last(team) for kind in CANDIDATES[team] for run in runs[kind]]
    return mw.Population(np.concatenate([each.genomes for each in last]), last[0].policy)


def cross_play(team: coevolution.Team, runs: Runs, quick: bool) -> np.ndarray:
    """Play a team's candidates against the opponents of all races.

    Returns the payoff (kinds, seeds, races, seeds, generations) of each kind of `CANDIDATES` and
    seed against every so many generations of each race and seed.
    """
    rivals = [run.teams[other(team)] for race in RACES for run in runs[race]]
    # One population of all candidates and one of all opponents: a single tournament.
    opponents = np.concatenate([each.genomes[:: EVERY[quick]] for each in rivals])
    met = mw.Population(opponents, rivals[0].policy)
    world, seeds = runs[RACES[0]][0].settings.game.world, len(runs[RACES[0]])
    own, episodes = last_of(team, runs), EPISODES[quick]
    payoff = scores_against(world, team, own, met, seed=0, episodes=episodes)
    return payoff.reshape(len(CANDIDATES[team]), seeds, len(RACES), seeds, -1)


# What is measured of the runs, in the dtypes in which it is written:


def captured(runs: Runs, quick: bool) -> Numbers:
    """Return ``captured NAME``, uint8 (seeds, n, n, episodes), of all races but the long ones.

    These are the evaders captured in each episode of the payoff matrix.
    """
    numbers = {}
    for name in (*RACES, FEW_EPOCHS):
        if name in runs:
            rates = np.stack([run.payoff().scores for run in runs[name]])
            captured = np.rint(rates * runs[name][0].settings.game.world.n_evaders)
            numbers[f"captured {name}"] = captured.astype(np.uint8)
    return numbers


def _phases(runs: Runs, quick: bool) -> Numbers:
    """Return ``phases RACE`` (seeds, generations, 2): capture rates after both team phases."""
    return {
        f"phases {race}": np.array(
            [team_phase_rates(run.payoff().matrix) for run in runs[name]], np.float32
        )
        for race, name in LONG.items()
    }


def generalization(runs: Runs, quick: bool) -> Numbers:
    """Return ``cross-play of TEAM``, and ``held-out of TEAM`` (kinds, seeds), its mean payoff."""
    runs, numbers = {**runs, EVADERS_TAUGHT: teach(runs)}, {}
    for team, kinds in CANDIDATES.items():
        # float32 halves the file and keeps far more digits than ten episodes give.
        numbers[f"cross-play of {team}s"] = cross_play(team, runs, quick).astype("f4")
        own, world = last_of(team, runs), runs[EVADERS_ALONE][0].settings.game.world
        scores = coevolution.score_policy(own, team, world, episodes=10 * EPISODES[quick])
        numbers[f"held-out of {team}s"] = scores.means.reshape(len(kinds), -1).astype("f4")
    return numbers


def _surrounding(runs: Runs, quick: bool) -> Numbers:
    """Return capture rates and collisions of archived surrounding teams, 100 episodes each.

    For each fitness of `SURROUNDING` ``captured``, and ``collisions`` between pursuers per 1000 of
    their agent-steps, both (seeds, entries of the archive).
    """
    numbers = {}
    for name in SURROUNDING.values():
        captured, collisions = [], []
        for run in runs[name]:
            pursuers = run.teams["pursuer"]
            each = np.arange(len(pursuers.genomes))
            matches = mw.Matches.of(each, 0, each)
            scores = mw.rollout(run.settings.game.world, pursuers, "random", matches, episodes=100)
            captured.append(scores.capture_rate.mean(axis=1))
            steps = scores.agent_steps[:, :, 0].sum(axis=1)
            collisions.append(1000 * scores.collisions[:, :, 0, 1].sum(axis=1) / steps)
        numbers[f"{name}: captured"] = np.array(captured, np.float32)
        numbers[f"{name}: collisions"] = np.array(collisions, np.float32)
    return numbers


def _tenths(runs: Runs, quick: bool) -> Numbers:
    """Return ``plateau: OPPONENTS`` (seeds, entries): escape rates after each tenth of the epochs.

    Opponents are the pursuers of the training, which move at random, and held-out ones.
    """
    world, episodes = runs[IN_TENTHS][0].settings.game.world, 10 * EPISODES[quick]
    found: dict[str, list[np.ndarray]] = {"random": [], "held-out": []}
    for run in runs[IN_TENTHS]:
        evaders = run.teams["evader"]
        each = mw.Matches.of(0, np.arange(len(evaders.genomes)), FIRST_TEST_SEED)
        scores = mw.rollout(world, "random", evaders, each, episodes=episodes)
        found["random"].append(1.0 - scores.capture_rate.mean(axis=1))
        against = coevolution.score_policy(evaders, "evader", world, episodes=episodes)
        found["held-out"].append(against.means)
    return {f"plateau: {name}": np.array(rates, np.float32) for name, rates in found.items()}


def _safety(runs: Runs, quick: bool) -> Numbers:
    """Return how surrounding teams collide in training and in tests, and what they earn.

    For each fitness of `SURROUNDING`: ``rewards`` (seeds, 2), the mean return of the untrained and
    of the last team; ``colliding`` (seeds,), the share of episodes in which teammates of the last
    team collide; ``faults`` (seeds, 2), collisions at fault of pursuers per 1000 agent-steps in
    the last tenth of the training, and of the last team in tests. Tests are 100 new episodes.
    """
    numbers = {}
    for name in SURROUNDING.values():
        rewards, colliding, faults = [], [], []
        for run in runs[name]:
            world, log, teams = run.settings.game.world, run.log(), run.teams["pursuer"]
            ends = mw.Matches.of([0, len(teams.genomes) - 1], 0, FIRST_TEST_SEED)
            tested = mw.rollout(world, teams, "random", ends, episodes=100)
            rewards.append(tested.pursuer_return.mean(axis=1))
            colliding.append((tested.collisions[1, :, 0, 1] > 0).mean())
            last = slice(-max(1, len(log["epoch"]) // 10), None)
            # All pursuers of S live to the end.
            steps = world.n_pursuers * log["length"][last].sum()
            in_test = tested.faults[1, :, 0].sum() / tested.agent_steps[1, :, 0].sum()
            faults.append([log["pursuer_faults"][last].sum() / steps, in_test])
        numbers[f"{name}: rewards"] = np.array(rewards, np.float32)
        numbers[f"{name}: colliding"] = np.array(colliding, np.float32)
        numbers[f"{name}: faults"] = np.array(1000 * np.array(faults), np.float32)
    return numbers


MEASURED: tuple[tuple[tuple[str, ...], Callable[[Runs, bool], Numbers]], ...] = (
    ((), captured),
    ((*RACES, PURSUERS_ALONE, EVADERS_ALONE), generalization),
    (tuple(SURROUNDING.values()), _surrounding),
    (tuple(LONG.values()), _phases),
    ((IN_TENTHS,), _tenths),
    (tuple(SURROUNDING.values()), _safety),
)
"""Kinds of runs, and what is measured of them."""


def measured(runs: Runs, quick: bool) -> Numbers:
    """Return the numbers of the kinds that have been played, and ``evaders``, those of a race."""
    evaders = kinds(quick)[GENERALISTS].game.world.n_evaders
    numbers: Numbers = {"evaders": np.array(evaders)}
    for needed, measure in MEASURED:
        if all(kind in runs for kind in needed):
            numbers |= measure(runs, quick)
    return numbers
