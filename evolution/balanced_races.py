"""Are races of ratings in balanced worlds arms races? Beside those of networks, ten seeds each.

    python evolution/balanced_races.py --threads 1   an hour of one core
    python evolution/balanced_races.py --quick       two seeds of short races, some seconds

Ten seeds of three schedules in the worlds with names, which `balance.py` has chosen, and in the
paper's world. In the former, policies rate moves by named inputs and evolve by the evolution
strategy, as in `matrixworld evolve`; in the latter they are networks over cells, as in `evolve
--paper`. All schedules have the same number of training matches.

Each race is judged by itself, and each group of ten together, as `matrixworld judge` does: in both
halves of the generations, and in the whole race. Scores are those against held-out opponents; above
them stands the best script of each team in the same episodes.

Stated before the races were played: ratings in a world become the default job if, of their thirty
whole races, at least as many are arms races as of the thirty of the default job, which were the
paper's, and if the three races of a seed take at most 60 seconds of two cores. Seeds are 10 to 19:
the settings were chosen in pilots with seeds below 10.
"""

from __future__ import annotations

from functools import partial
from typing import Any

import numpy as np

from common import Numbers, Runs, by_seed, experiment, kinds_in, markdown, mean
from matrixworld import WORLDS, WorldConfig, analysis
from matrixworld.coevolution import TEAMS, RaceSettings, default_race
from matrixworld.coevolution.evaluation.scores import best_scripts
from matrixworld.coevolution.types import FloatArray
from race_budgets import SCHEDULES, scores_of

QUICK = {"schedule.generations": 8, "learner.population": 4, "evaluation_episodes": 4}
WINDOWS = ("first half", "last half", "whole")
SHOWN = ("arms race", "one-sided progress", "intransitivity", "forgetting", "disengagement")
SEEDS, FIRST_SEED = 10, 10
PAPER = "O"
"""The paper's world."""


def kinds(quick: bool) -> dict[str, RaceSettings]:
    """Return the settings of the races of each schedule in each world."""
    found = {}
    for world in WORLDS:
        for schedule in SCHEDULES:
            usual = default_race(schedule)
            epochs = [path for path in RaceSettings.of(usual).values() if path.endswith("epochs")]
            short = {**QUICK, **dict.fromkeys(epochs, 1)}
            found[f"{world}; {schedule}"] = RaceSettings.of(
                usual, {"world": world, **(short if quick else {})}
            )
    for schedule in () if quick else SCHEDULES:
        found[f"{PAPER}; {schedule}"] = RaceSettings.of({"schedule": schedule})
    return found


def found_in(payoffs: FloatArray) -> dict[str, Any]:
    """Return what is found in races (seeds, G, H, episodes): in all together, in how many."""
    together = analysis.judge(payoffs, per_episode=True)
    single = [*map(partial(analysis.judge, per_episode=True), payoffs)]
    found: dict[str, Any] = {}
    for window in WINDOWS:
        present = [each.present(window) for each in single]
        found[f"found, {window}"] = np.array(together.present(window), str)
        found[f"single, {window}"] = np.array(
            [[name in each for name in SHOWN] for each in present]
        )
    return found


def measured(runs: Runs, quick: bool) -> dict[str, Any]:
    """Return scores, matches and what is found of each kind, and the best scripts of the worlds."""
    numbers = by_seed(runs, scores_of)
    for kind, each in runs.items():
        every = np.stack([run.payoff().scores for run in each])
        numbers[f"matches of {kind}"] = each[0].log()["matches"][-1] + every[0].size
        numbers |= {f"{name} in {kind}": found for name, found in found_in(every).items()}
    for world in dict.fromkeys(kind.split("; ")[0] for kind in runs):
        best = best_scripts(WorldConfig.of(world), episodes=4 if quick else 100)
        for team, (script, score) in best.items():
            numbers[f"{world}: {team} {script}"] = score
    return numbers


def table(numbers: Numbers) -> str:
    """Return what races are in each world, in Markdown."""
    rows = []
    for world in (*WORLDS, PAPER):
        if best := [name for name in numbers if name.startswith(f"{world}: ")]:
            scripts = dict(name.removeprefix(f"{world}: ").split() for name in best)
            cells = [f"{numbers[f'{world}: {t} {scripts[t]}']:.3f} {scripts[t]}" for t in TEAMS]
            rows.append([f"{world}; best scripts", "", "", *cells, "", "", ""])
        for kind in (each for each in kinds_in(numbers) if each.startswith(f"{world}; ")):
            told = [
                ", ".join(numbers[f"found, {each} in {kind}"]) or "cannot tell" for each in WINDOWS
            ]
            single = np.array(
                [numbers[f"single, {each} in {kind}"].sum(axis=0) for each in WINDOWS]
            )
            counts = [" / ".join(map(str, each)) for each in (single[:, 0], single[-1, 1:])]
            scores = [mean(numbers[f"{kind} / {team}"], 3) for team in TEAMS]
            count = str(len(numbers[f"{kind} / pursuer"]))
            matches = f"{numbers[f'matches of {kind}']:,}"
            rows.append([kind, count, matches, *scores, " / ".join(told), *counts])
    windows = " / ".join(WINDOWS)
    heads = ["races", "seeds", "matches", *(f"{team}s" for team in TEAMS), f"found: {windows}"]
    heads += [f"arms races: {windows}", f"in single whole races: {' / '.join(SHOWN[1:])}"]
    return markdown(heads, rows)


if __name__ == "__main__":
    experiment(
        __doc__, kinds=kinds, measure=measured, table=table, seeds=SEEDS, first_seed=FIRST_SEED
    )
