"""Should policies read more inputs by default? Escapes, opposite and parity, in twelve places.

    python evolution/added_inputs.py --threads 1   half an hour of one core
    python evolution/added_inputs.py --quick       two seeds of short races, some seconds

Races as `matrixworld evolve` plays them, of generalists by CMA-ES: in the three worlds with names,
and in small worlds of the nine variants, those of `yoked_variants.py`. Policies read the nine usual
inputs, or all *twelve* with the three that say how pursuers hold an evader, or they are *split*:
pursuers read `escapes` and `opposite` in addition, evaders `parity`. The trials from which the
split follows were of the evolution strategy, with other seeds.

The number of a race is the held-out score of the best generation of each team, on other episodes
than those by which it was chosen (`SavedRun.best`). Each place has one race of a set, of the same
seed. Intervals are over ten places (Student's t): SD and SDB are left out, since with one evader
they are S and SB with other draws.

Stated before the races: a set becomes the default if the interval of the mean difference of both
teams lies above 0, and neither team loses more than .02 in the mean over the three worlds with
names.
"""

from __future__ import annotations

from typing import Any

import numpy as np

import matrixworld as mw
from common import Numbers, Runs, by_seed, experiment, kept, markdown, mean, play
from matrixworld._util.teams import PLURALS
from matrixworld.analysis import interval_over_runs
from matrixworld.coevolution import TEAMS, RaceSettings, SavedRun, default_race
from matrixworld.coevolution.evaluation.kept_scores import kept_scores
from matrixworld.coevolution.types import FloatArray
from yoked_variants import SIZES, TWINS

NEW = ("escapes", "opposite", "parity")
NINE, TWELVE, SPLIT = "nine", "twelve", "split"
SETS: dict[str, Any] = {
    NINE: mw.Rating.inputs,
    TWELVE: (*mw.Rating.inputs, *NEW),
    SPLIT: ((*mw.Rating.inputs, *NEW[:2]), (*mw.Rating.inputs, NEW[2])),
}
QUICK = {"schedule.generations": 4, "learner.population": 4, "evaluation_episodes": 2}
QUICK_PLACES = ("thicket", "SB")
MOST_LOST = 0.02


def worlds() -> dict[str, dict[str, Any]]:
    """Return the settings of the world of each place."""
    found: dict[str, dict[str, Any]] = {name: {"world": name} for name in mw.WORLDS}
    for name, rules in mw.VARIANTS.items():
        side, pursuers, evaders = SIZES[rules.capture]
        found[name] = {
            "world.rules": name, "world.rows": side, "world.cols": side, "world.obstacles": 0.0,
            "world.n_pursuers": pursuers, "world.n_evaders": evaders, "world.max_steps": 60,
            "train_steps": 60,
        }  # fmt: skip
    return found


def kinds(quick: bool) -> dict[str, RaceSettings]:
    """Return the settings of the races of each set in each place."""
    short = {**QUICK, **{f"schedule.{team}_epochs": 1 for team in TEAMS}} if quick else {}
    return {
        f"{place}: {name}": RaceSettings.of(
            default_race("generalist-generalist"), world, {"policy.inputs": inputs}, short
        )
        for place, world in worlds().items()
        if not quick or place in QUICK_PLACES
        for name, inputs in SETS.items()
    }


def scores_of(run: SavedRun) -> dict[str, float]:
    """Return the held-out scores of the best generations of both teams."""
    [scores] = kept_scores([run], threads=1)
    return {team: scores[PLURALS[team]]["best generation"][1] for team in TEAMS}


def measured(runs: Runs, quick: bool) -> dict[str, Any]:
    """Return the scores of all runs."""
    return by_seed(
        runs, lambda run: kept(run.path.with_suffix(".best.json"), lambda: scores_of(run))
    )


def differences(numbers: Numbers, name: str, places: list[str]) -> FloatArray:
    """Return the mean differences of a set from the nine inputs: (places, teams)."""
    return np.array(
        [
            [
                (numbers[f"{place}: {name} / {t}"] - numbers[f"{place}: {NINE} / {t}"]).mean()
                for t in TEAMS
            ]
            for place in places
        ]
    )


def table(numbers: Numbers) -> str:
    """Return scores and differences in each place, and what follows from the rule, in Markdown."""
    places = [place for place in worlds() if f"{place}: {NINE} / pursuer" in numbers]
    rows = []
    for place in places:
        cells = [f"{numbers[f'{place}: {NINE} / {team}'].mean():.3f}" for team in TEAMS]
        for name in (TWELVE, SPLIT):
            cells += [f"{value:+.3f}" for value in differences(numbers, name, [place])[0]]
        rows.append([place, *cells])
    different = [place for place in places if place not in TWINS]
    named = [place for place in places if place in mw.WORLDS]
    cells, told = ["", ""], []
    for name in (TWELVE, SPLIT):
        every = differences(numbers, name, different)
        cells += [mean(every[:, side], sign="+") for side in range(len(TEAMS))]
        both = interval_over_runs(every.mean(axis=1))
        least = differences(numbers, name, named).mean(axis=0).min()
        low = -1.0 if both.low is None else both.low
        does = "becomes" if low > 0.0 and least > -MOST_LOST else "does not become"
        told.append(
            f"*{name}* {does} the default: both teams {mean(every.mean(axis=1), sign='+')}; the "
            f"worse team in the worlds with names {least:+.3f}."
        )
    rows.append([f"mean of {len(different)} places", *cells])
    heads = ["place", *(f"{team}s, nine" for team in TEAMS)]
    heads += [f"{team}s, {name}" for name in (TWELVE, SPLIT) for team in TEAMS]
    seeds = len(numbers[f"{places[0]}: {NINE} / pursuer"])
    of_seeds = "one seed" if seeds == 1 else f"{seeds} seeds"
    first = f"Held-out scores of best generations, and differences from nine inputs: {of_seeds}."
    return "\n\n".join([first, markdown(heads, rows), *told])


if __name__ == "__main__":
    experiment(__doc__, kinds=kinds, measure=measured, table=table, seeds=1, play=play)
