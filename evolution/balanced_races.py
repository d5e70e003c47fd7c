"""What do ratings learn in balanced worlds in seconds? Champions beside every script, ten seeds.

    python evolution/balanced_races.py --threads 1   an hour of one core
    python evolution/balanced_races.py --quick       two seeds of short races, some seconds

Ten seeds of three schedules in the worlds with names, which `balance.py` has chosen. Policies rate
moves by named inputs and evolve by CMA-ES, as in `matrixworld evolve`. Schedules in turns have the
same number of training matches, halls of fame nearly twice as many.

Each race is judged by itself, and each group of ten together, as `matrixworld judge` does: in both
halves of the generations, and in the whole race. The payoffs are kept, so that a new table follows
the rules of its day. A *champion* is the best generation of a team as
`SavedRun.best` chooses it, on other episodes against held-out opponents. It is *above* a script if
the 95 % interval of the difference, over 1,000 episodes that both play against each held-out
opponent, lies above 0. All scripts that make sense for the team are asked, careful ones, too. None
of the opponents is met in training.

Stated before these races were played: the settings stand if champions of both teams are above every
script in at least nine of ten seeds of each schedule in each world. Seeds are 20 to 29: settings
were chosen in pilots with seeds 100 to 206. Halls of fame had three joint epochs at first, with
which champions of the pursuers failed in two of ten seeds of courtyard; with five they were played
again, with seeds 30 to 39. And the races of the evolution strategy, by which these worlds were
chosen, had seeds 10 to 19.
"""

from __future__ import annotations

from functools import cache, partial
from typing import Any

import numpy as np
from numpy.typing import NDArray

from common import Numbers, Runs, experiment, kept, kinds_in, markdown, mean, payoffs_of, rates
from matrixworld import WORLDS, WorldConfig, analysis
from matrixworld.coevolution import TEAMS, RaceSettings, SavedRun, Team, default_race
from matrixworld.coevolution.evaluation.held_out import opponents_of, scripts_for
from matrixworld.coevolution.evaluation.held_out_matches import play_held_out
from matrixworld.coevolution.evaluation.scores import best_scripts
from matrixworld.coevolution.types import FloatArray
from race_budgets import SCHEDULES

QUICK = {"schedule.generations": 8, "learner.population": 4, "evaluation_episodes": 4}
WINDOWS = ("first half", "last half", "whole")
SHOWN = ("arms race", "one-sided progress", "intransitivity", "forgetting", "disengagement")
SEEDS, FIRST_SEED, FIRST_OF_HALLS = 10, 20, 30
EPISODES, QUICK_EPISODES = 1000, 4
COMMON = 10**6
"""The seed of the episodes that champions and scripts play."""


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
    return found


def judged(payoffs: FloatArray) -> tuple[dict[str, str], NDArray[np.int64]]:
    """Return what is found in races (seeds, G, H, episodes), by the rules of today.

    In all together, by window, and in how many single ones (windows, `SHOWN`).
    """
    together = analysis.judge(payoffs, per_episode=True)
    single = [analysis.judge(each, per_episode=True) for each in payoffs]
    found = {each: ", ".join(together.present(each)) or "nothing" for each in WINDOWS}
    counts = [
        [sum(name in each.present(window) for each in single) for name in SHOWN]
        for window in WINDOWS
    ]
    return found, np.array(counts)


def against_all(world: WorldConfig, team: Team, plays: Any, episodes: int) -> FloatArray:
    """Return the mean score of who plays against held-out opponents, by episode: (episodes,)."""
    opponents, _ = opponents_of(team, world)
    rates = play_held_out(world, team, plays, opponents, episodes=episodes, seed=COMMON, threads=1)
    return np.asarray(rates[0].mean(axis=0))


@cache
def of_scripts(world: WorldConfig, team: Team, episodes: int) -> dict[str, FloatArray]:
    """Return the same of all scripts of a team, by name."""
    scripts = scripts_for(team, world)
    return {name: against_all(world, team, name, episodes) for name in scripts}


def champions(run: SavedRun, episodes: int) -> dict[str, float]:
    """Return the scores of both champions, and how far they surely are above the best script.

    ``above`` is the least lower end of the intervals of the differences from all scripts.
    """
    world = run.settings.game.world
    found: dict[str, Any] = {}
    for team in TEAMS:
        own = against_all(world, team, run.best(team).population(), episodes)
        found[team] = float(own.mean())
        found[f"{team} last"] = float(against_all(world, team, run.last(team), episodes).mean())
        lows = [
            analysis.interval_over_runs(own - theirs).low  # of episodes, here
            for theirs in of_scripts(world, team, episodes).values()
        ]
        found[f"{team} above"] = min(-1.0 if low is None else low for low in lows)
    return found


def measured(runs: Runs, quick: bool) -> dict[str, Any]:
    """Return scores, matches and what is found of each kind, and the best scripts of the worlds."""
    episodes = QUICK_EPISODES if quick else EPISODES
    numbers: dict[str, Any] = {}
    for kind, each in runs.items():
        found = [
            kept(run.path.with_suffix(".champions.json"), partial(champions, run, episodes))
            for run in each
        ]
        numbers |= {f"{kind} / {n}": np.array([one[n] for one in found]) for n in found[0]}
        numbers |= payoffs_of(kind, each)
        played = numbers[f"captured in {kind}"][0].size
        numbers[f"matches of {kind}"] = each[0].log()["matches"][-1] + played
    for world in dict.fromkeys(kind.split("; ")[0] for kind in runs):
        best = best_scripts(WorldConfig.of(world), episodes=QUICK_EPISODES if quick else EPISODES)
        for team, script in best.items():
            numbers[f"{world}: {team}"] = np.array([script.name, f"{script.score:.3f}"])
    return numbers


def cell_of_scores(numbers: Numbers, kind: str, team: Team) -> str:
    """Return the score of the champions of a team, of its last generations, and who is above."""
    scores = numbers[f"{kind} / {team}"]
    above = int((numbers[f"{kind} / {team} above"] > 0.0).sum())
    last = mean(numbers[f"{kind} / {team} last"], bounds=(0.0, 1.0))
    told = mean(scores, bounds=(0.0, 1.0))
    return f"{told}; above all scripts {above} of {len(scores)}; last {last}"


def table(numbers: Numbers) -> str:
    """Return what races are in each world, in Markdown."""
    rows = []
    for world in WORLDS:
        kinds = [each for each in kinds_in(numbers) if each.startswith(f"{world}; ")]
        if not kinds:
            continue
        best = [" ".join(reversed(numbers[f"{world}: {team}"])) for team in TEAMS]
        rows.append([f"{world}; best scripts", "", "", *best, "", "", ""])
        for kind in kinds:
            found, single = judged(rates(numbers, kind))
            counts = [" / ".join(map(str, each)) for each in (single[:, 0], single[-1, 1:])]
            scores = [cell_of_scores(numbers, kind, team) for team in TEAMS]
            count = str(len(numbers[f"{kind} / pursuer"]))
            matches = f"{numbers[f'matches of {kind}']:,}"
            rows.append([kind, count, matches, *scores, " / ".join(found.values()), *counts])
    windows = " / ".join(WINDOWS)
    heads = ["races", "seeds", "matches", *(f"{team}s" for team in TEAMS), f"found: {windows}"]
    heads += [f"arms races: {windows}", f"in single whole races: {' / '.join(SHOWN[1:])}"]
    return markdown(heads, rows)


if __name__ == "__main__":
    experiment(
        __doc__,
        kinds=kinds,
        measure=measured,
        table=table,
        seeds=SEEDS,
        first_seed={
            kind: FIRST_OF_HALLS if kind.endswith("hall-of-fame") else FIRST_SEED
            for kind in kinds(False)
        },
    )
