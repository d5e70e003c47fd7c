"""Do co-evolved teams generalise better? A race and three baselines, at equal matches.

    python evolution/generalization.py             some minutes; can be interrupted
    python evolution/generalization.py --quick     a small world, some seconds

There are three baselines beside a race: pursuers that learn against random evaders, evaders that
learn against random pursuers, and evaders that learn against random pursuers for half of their
matches and then against trained pursuers. Each baseline plays as many matches as its team plays in
the race. Then the race's teams and the baselines meet all generations of the race's opponents.

The race's own teams have trained against these opponents; the baselines have not. Therefore the
races of the other seeds provide opponents that are new to all teams.

Method: the comparison of Sun et al. (2023), "MatrixWorld", arXiv:2307.14854.

Look at the mean score, which is the generalization, and at the worst score, which is what remains
against the most difficult opponent. Compare both with the score against the training opponents: it
shows how much a baseline loses against new ones. Two seeds show little: try more ``--seeds`` (two
at least), or ``paper_claims.py``, which runs twenty.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.figure import Figure

from common import (
    SAME_STEPS,
    SMALL_STEPS,
    Numbers,
    Runs,
    experiment,
    long_race,
    markdown,
    pairs,
    scores_against,
)
from matrixworld import coevolution, plots
from matrixworld.coevolution import RaceSettings, SavedRun, Team
from matrixworld.coevolution.types import other

FULL = RaceSettings.of({
    **long_race("generalist-generalist"), "schedule.generations": 20,
    "world.rows": 30, "world.cols": 30, "world.n_pursuers": 6, "world.n_evaders": 12,
})  # fmt: skip
QUICK = RaceSettings.of({
    "world.rows": 12, "world.cols": 12, "world.n_pursuers": 3, "world.n_evaders": 6,
    "world.max_steps": 80, "train_steps": 60, **SAME_STEPS, "learner.population": 12,
    "schedule.generations": 8, "schedule.pursuer_epochs": 10, "schedule.evader_epochs": 20,
})  # fmt: skip

RACE = "generalist-generalist"
CHASING, FLEEING = "pursuers against random", "evaders against random"
HALFWAY, TAUGHT = "evaders against random, half", "evaders against trained"
TRAININGS: dict[Team, dict[str, tuple[str, ...]]] = {
    "pursuer": {"in the race": (RACE,), "against random evaders": (CHASING,)},
    "evader": {
        "in the race": (RACE,),
        "against random pursuers": (FLEEING,),
        "against trained pursuers": (HALFWAY, TAUGHT),
    },
}
"""How each team is trained, and in which consecutive runs."""
EPISODES = 50
"""Episodes of each pair in the comparison."""


def kinds(quick: bool) -> dict[str, RaceSettings]:
    """Return the settings of the race, and of the baselines that begin untrained."""
    race = QUICK if quick else FULL
    # Baselines differ from the race in their opponents and in nothing else.
    chasing, fleeing = (
        RaceSettings.of(
            {
                "schedule": "against",
                "schedule.team": team,
                "schedule.epochs": race.schedule.total_epochs(team),
                **SMALL_STEPS[team],
                "world": race.world,
                "learner.population": race.learner.population,
                "train_steps": race.train_steps,
            }
        )
        for team in coevolution.TEAMS
    )
    # A run of its own rather than a part of `fleeing`, since its learning rate falls sooner.
    halfway = fleeing.changed({"schedule.epochs": fleeing.schedule.epochs // 2})
    return {RACE: race, CHASING: chasing, FLEEING: fleeing, HALFWAY: halfway}


def taught(runs: Runs, quick: bool) -> dict[str, list[RaceSettings]]:
    """Return the settings of evaders that go on against trained pursuers."""
    # A constant learning rate, as in the race.
    return {
        TAUGHT: [
            pupil.settings.changed(
                {
                    "schedule.opponent": str(teacher.path),
                    "schedule.start": str(pupil.path),
                    "learner.anneal": False,
                }
            )
            for teacher, pupil in pairs(runs, CHASING, HALFWAY)
        ]
    }


def matches(team: Team, run: SavedRun) -> int:
    """Return the number of matches in which a team has learned in a run."""
    return int(np.sum(run.log()["team"] == team)) * run.settings.learner.population


def scores(team: Team, run: SavedRun, race: SavedRun) -> np.ndarray:
    """Return the scores of the last generation of a team against a race's other team."""
    own, rivals, world = run.last(team), race.teams[other(team)], race.settings.world
    [found] = scores_against(world, team, own, rivals, seed=run.settings.seed, episodes=EPISODES)
    return found


def in_training(team: Team, run: SavedRun) -> float:
    """Return the mean score of the last generation against its training opponents."""
    rates = run.payoff().capture_rate
    return float(rates[-1].mean() if team == "pursuer" else 1 - rates[:, -1].mean())


def measured(runs: Runs, quick: bool) -> dict[str, Any]:
    """Return matches and scores of the last generation of each team after each training.

    Scores against the training opponents (seeds,), against each generation of the race's opponents
    and of those of the next seed (seeds, generations).
    """
    races = runs[RACE]
    numbers: dict[str, Any] = {"payoff": races[0].payoff().capture_rate}
    for team, trainings in TRAININGS.items():
        for training, parts in trainings.items():
            name, trained = f"{team}s, {training}", runs[parts[-1]]
            numbers |= {
                f"{name} / matches": [
                    sum(matches(team, run) for run in of_seed) for of_seed in pairs(runs, *parts)
                ],
                f"{name} / training": [in_training(team, run) for run in trained],
                f"{name} / race": [
                    scores(team, run, race) for run, race in zip(trained, races, strict=True)
                ],
                f"{name} / new": [
                    scores(team, run, race)
                    for run, race in zip(trained, [*races[1:], races[0]], strict=True)
                ],
            }
    return numbers


def table(numbers: Numbers) -> str:
    """Return the means of all seeds in Markdown."""
    rows = []
    for team, trainings in TRAININGS.items():
        for training in trainings:
            name = f"{team}s, {training}"
            ends = [numbers[f"{name} / training"].mean()]
            for opponents in ("race", "new"):
                scores = numbers[f"{name} / {opponents}"]
                ends += [scores.mean(), scores.min(axis=1).mean()]
            count = f"{numbers[f'{name} / matches'].mean():,.0f}"
            rows.append([f"{team}s", training, count, *(f"{end:.2f}" for end in ends)])
    heads = ["team", "trained", "matches", "training", "race", "worst", "new", "worst"]
    told = (
        "Mean score against the training opponents; mean and worst score against the race's\n"
        "opponents and against new opponents, those of another race. Means over seeds.\n\n"
    )
    return told + markdown(heads, rows)


def figure(numbers: Numbers) -> Figure:
    """Draw the scores in the race of the first seed, and the baselines as lines."""
    title = f"Generalization: {RACE}, and baselines"
    lines = {
        f"{team}_baselines": {
            title: {
                f"{team}s {training}": [numbers[f"{team}s, {training} / race"][0].mean()]
                for training in trainings
                if training != "in the race"
            }
        }
        for team, trainings in TRAININGS.items()
    }
    return plots.generalization_curves({title: numbers["payoff"]}, **lines)


if __name__ == "__main__":
    experiment(
        __doc__,
        kinds=kinds,
        then=taught,
        measure=measured,
        table=table,
        seeds=2,
        figures={"generalization.png": figure},
    )
