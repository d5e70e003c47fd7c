"""Which kind of policy learns in seconds? Cells, ratings and programs, beside scripts and chance.

    python evolution/policies.py             ten seeds of each kind, two hours of one core
    python evolution/policies.py --quick     two small worlds and two seeds, some seconds

Short hall-of-fame races in the default worlds of all nine variants, with about the same matches
for all kinds: networks over *cells*, *ratings* without and with a hidden layer, and *programs*. The
settings of a kind hold for all variants; they follow from pilots of fifteen races with seed 0,
other budgets and fewer episodes, in O, S, SB and R. Beside them stand

- the *scripts* that make sense for a team, and their careful versions; the best one counts;
- the *best of 250 random programs* of each team. They play half of the matches of a race against
  each other, the best 16 of each team the other half; the best of these counts.

The score of a team is that of its last generation against held-out opponents, in episodes that
nobody has learned from, the same for all. In two worlds that are solved exactly, what a team
guarantees stands in its place. Seconds are processor time: of the whole race, or of the choice
among random programs.

Stated before the runs:

- A kind *beats the scripts* of a team in a variant if its score is above that of the best script in
  every seed. The best script is known only after all have been scored, which favours scripts.
- Goal: in every variant and team where the best script is not perfect (a score below 0.995),
  ratings or programs beat the scripts, in at most 20 seconds of one core. A variant and team in
  which no kind does is named.
- Seeds are 0, 1, ... . All kinds and variants play one seed before the next one begins, so that
  what is finished at any time is a fair sample.
"""

from __future__ import annotations

import shutil
from functools import partial
from pathlib import Path
from time import process_time
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

import matrixworld as mw
from common import SMALL_RACE, Numbers, Runs, by_seed, experiment, kept, markdown, mean, solved
from matrixworld.coevolution import TEAMS, RaceSettings, SavedRun, Team, create, finish
from matrixworld.coevolution.evaluation.held_out import scripts_for
from matrixworld.coevolution.games.pursuit import Pursuit
from matrixworld.coevolution.types import FloatArray
from matrixworld.solver import best_response

RACE: dict[str, Any] = {
    "schedule": "hall-of-fame", "schedule.generations": 8, "evaluation_episodes": 2,
}  # fmt: skip
CELLS, RATING, HIDDEN, PROGRAM = "cells", "rating", "rating, 8 hidden", "program"
RATINGS = {
    "policy": "rating", "learner": "cma", "learner.population": 12, "schedule.joint_epochs": 16,
}  # fmt: skip
KINDS: dict[str, dict[str, Any]] = {
    CELLS: {"learner": "es", "learner.population": 24, "schedule.joint_epochs": 8},
    RATING: RATINGS,
    HIDDEN: {**RATINGS, "policy.hidden": (8,)},
    PROGRAM: {
        "policy": "program", "learner": "gp", "learner.population": 60, "schedule.joint_epochs": 3,
        "retest_episodes": 4,
    },
}  # fmt: skip
CONTROL = "best of random programs"
SHOWN = (CELLS, CONTROL, RATING, HIDDEN, PROGRAM)
READABLE = (RATING, HIDDEN, PROGRAM)

SOLVED_SIDE = 6
"""Worlds up to this side are solved exactly."""
SMALL = {"rules": "TO", "n_pursuers": 2, "n_evaders": 1}
SOLVED: dict[str, dict[str, Any]] = {
    "TO 4 x 4": {**SMALL, "rows": 4, "cols": 4, "fov": 7, "max_steps": 4},
    "TO 6 x 6": {**SMALL, "rows": 6, "cols": 6, "fov": 11, "max_steps": 5},
}
"""The worlds of convergence.py and of small_world.toml."""
STEPLESS = tuple(name for name in mw.Rating.inputs if name not in ("must_yield", "ahead"))
"""Inputs that do not count steps, as solved worlds need them."""

EPISODES = 40
"""Episodes against each held-out opponent."""
RANDOM, BEST = 250, 16
"""Random programs of a team, and how many of them play the second half of the matches."""
PERFECT, SECONDS = 0.995, 20
"""Scores from here on count as perfect; seconds of the goal."""
DEFAULT_RACES = Path(__file__).parent / "results" / "race_budgets" / "numbers.npz"


def kinds(quick: bool) -> dict[str, RaceSettings]:
    """Return the settings of each kind of policy in each world."""
    small = {**SMALL_RACE, "schedule.generations": 2, "schedule.joint_epochs": 2} if quick else {}
    variants = ("O", "SB") if quick else mw.VARIANTS
    places = {name: {"world.rules": name} for name in variants}
    for name in list(SOLVED)[: 1 if quick else None]:
        world = {f"world.{field}": value for field, value in SOLVED[name].items()}
        places[name] = {**world, "train_steps": world["world.max_steps"], "match_episodes": 32}
    found = {}
    for place, world in places.items():
        for kind, changes in KINDS.items():
            blind = {"policy.inputs": STEPLESS} if place in SOLVED and kind != CELLS else {}
            found[f"{place}: {kind}"] = RaceSettings.of(RACE | changes | small | world | blind)
    return found


def episodes_of(quick: bool) -> int:
    """Return the episodes against each held-out opponent."""
    return 2 if quick else EPISODES


# ---- Results of one race, of random programs, of scripts -----------------------------------------


def result(world: mw.WorldConfig, team: Team, policy: Any, episodes: int) -> float:
    """Return the held-out score of a team; in a solved world the capture rate at worst, exactly."""
    if world.rows <= SOLVED_SIDE:
        return best_response(solved(world).states, policy, team).value
    scores = mw.score_policy(policy, team, world, episodes=episodes, threads=1)
    return float(scores.means[-1])


def race(settings: RaceSettings, directory: Path) -> dict[str, Any]:
    """Play a race; return its results, and what it took."""
    # A rest of a race would not tell the seconds of all of it.
    shutil.rmtree(directory, ignore_errors=True)
    begun = process_time()
    create(settings, directory)
    run = finish(directory, threads=1)
    seconds, last = process_time() - begun, {team: run.last(team) for team in TEAMS}
    return {
        **{
            t: result(settings.game.world, t, last[t], episodes_of(is_quick(settings)))
            for t in TEAMS
        },
        "seconds": seconds,
        "matches": run.log()["matches"][-1].item(),
        "genes": np.mean([genes(each) for each in last.values()]).item(),
    }


def is_quick(settings: RaceSettings) -> bool:
    """Return whether a race is one of ``--quick``."""
    return bool(settings.schedule.generations < RACE["schedule.generations"])


def genes(team: mw.Population) -> int:
    """Return the genes of a policy, of a program its instructions."""
    if isinstance(team.policy, mw.Program):
        return len(team.policy.tokens(team.genomes[0]))
    return team.policy.genome_size


def random_programs(settings: RaceSettings) -> dict[str, Any]:
    """Return the results of the best of random programs, and what their choice took."""
    begun, rng = process_time(), np.random.default_rng(settings.seed)
    game = settings.training_game
    assert isinstance(game, Pursuit)
    teams = {t: np.stack([game.untrained(t, rng) for _ in range(RANDOM)]) for t in TEAMS}
    episodes, matches = settings.match_episodes, 0
    schedule, population = settings.schedule, settings.learner_of("pursuer").population
    # From a match of two living individuals both teams learn, from one against a hall of fame one.
    met = schedule.contemporaries + 2 * schedule.hall_sample
    raced = schedule.total_epochs("pursuer") * population * met
    # Three genomes of each team and generation are tested again.
    raced += 2 * schedule.generations * 3 * settings.retest_episodes * schedule.opponents_met
    half = raced // 2
    for count, rounds in ((RANDOM, half // RANDOM), (BEST, half // BEST)):
        own = np.tile(np.arange(count), max(1, rounds))
        rivals = np.concatenate([rng.permutation(count) for _ in range(max(1, rounds))])
        seeds = rng.integers(2**63, size=len(own), dtype=np.uint64)
        sides = (mw.Population(teams[team], game.policies[team]) for team in TEAMS)
        played = mw.rollout(
            game.world, *sides, mw.Matches.of(own, rivals, seeds), episodes=episodes, threads=1
        )
        matches += len(own) * episodes
        captured = played.captured_fraction.mean(axis=1)
        sums = np.bincount(own, captured), np.bincount(rivals, -captured)
        teams = {
            team: teams[team][np.argsort(-total, kind="stable")[:BEST]]
            for team, total in zip(TEAMS, sums, strict=True)
        }
    seconds = process_time() - begun
    best = {team: mw.Population(teams[team][0], game.policies[team]) for team in TEAMS}
    return {
        **{
            t: result(settings.game.world, t, best[t], episodes_of(is_quick(settings)))
            for t in TEAMS
        },
        "seconds": seconds,
        "matches": matches,
        "genes": np.mean([genes(each) for each in best.values()]).item(),
    }


def play(settings: RaceSettings, directory: Path, *, threads: int | None = None) -> SavedRun:
    """Play a race and what belongs to it, in one thread; files beside it keep the numbers."""
    numbers_of(settings, directory)
    if is_program(settings):
        control_of(settings, directory)
    return SavedRun(directory)


def is_program(settings: RaceSettings) -> bool:
    """Return whether the policies of a race are programs."""
    return settings.game.policy.kind == PROGRAM


def numbers_of(settings: RaceSettings, directory: Path) -> dict[str, Any]:
    """Return the numbers of a race."""
    return kept(directory.with_suffix(".race.json"), partial(race, settings, directory))


def control_of(settings: RaceSettings, directory: Path) -> dict[str, Any]:
    """Return the numbers of random programs in as many matches as a race."""
    return kept(directory.with_suffix(".random.json"), partial(random_programs, settings))


def script_results(world: mw.WorldConfig, episodes: int) -> dict[str, Any]:
    """Return the results of all scripts of each team by name."""
    return {
        team: {name: result(world, team, name, episodes) for name in scripts_for(team, world)}
        for team in TEAMS
    }


def measured(runs: Runs, quick: bool) -> dict[str, Any]:
    """Return the numbers of all races, of random programs, scripts, and values of solved worlds."""
    numbers = by_seed(runs, lambda run: numbers_of(run.settings, run.path))
    for kind, of_kind in runs.items():
        place, [first, *_] = kind.split(": ")[0], of_kind
        if not is_program(first.settings):
            continue
        control = {f"{place}: {CONTROL}": of_kind}
        numbers |= by_seed(control, lambda run: control_of(run.settings, run.path))
        world = first.settings.game.world
        file = first.path.parent.with_suffix(".scripts.json")
        scripts = kept(file, partial(script_results, world, episodes_of(quick)))
        for team, results in scripts.items():
            numbers[f"scripts in {place}: {team}"] = np.array(list(results))
            numbers[f"scores in {place}: {team}"] = np.array(list(results.values()))
        if place in SOLVED:
            numbers[f"value of {place}"] = solved(world).value
    if not quick:
        default = np.load(DEFAULT_RACES)
        numbers |= {f"default race: {t}": default[f"default; hall-of-fame / {t}"] for t in TEAMS}
    return numbers


# ---- Tables --------------------------------------------------------------------------------------


def best_script(numbers: Numbers, place: str, team: Team) -> tuple[str, float]:
    """Return the best script of a team and its result."""
    scores = numbers[f"scores in {place}: {team}"]
    # In a solved world evaders have what they concede.
    best = int(np.argmin(scores) if place in SOLVED and team == "evader" else np.argmax(scores))
    return str(numbers[f"scripts in {place}: {team}"][best]), float(scores[best])


def beating(numbers: Numbers, place: str, team: Team) -> dict[str, int]:
    """Return in how many seeds each kind is better than the best script."""
    sign = -1 if place in SOLVED and team == "evader" else 1
    best = best_script(numbers, place, team)[1]
    gains = {kind: sign * (numbers[f"{place}: {kind} / {team}"] - best) for kind in READABLE}
    return {kind: int((each > 0).sum()) for kind, each in gains.items()}


def verdict(numbers: Numbers, place: str, team: Team) -> str:
    """Return which kinds beat the scripts of a team."""
    if place not in SOLVED and best_script(numbers, place, team)[1] >= PERFECT:
        return "script perfect"
    seeds = len(numbers[f"{place}: {RATING} / {team}"])
    counts = beating(numbers, place, team)
    always = [kind for kind, count in counts.items() if count == seeds]
    most = max(counts.values())
    return "; ".join(always) or f"**none** (at most {most} of {seeds} seeds)"


def spread(values: ArrayLike, digits: int = 3) -> str:
    """Return the mean, and the least and the largest value, as text."""
    ends = np.mean(values), np.min(values), np.max(values)
    found, least, most = (f"{end:.{digits}f}" for end in ends)
    return f"{found} ({least} to {most})"


def row(numbers: Numbers, place: str, team: Team) -> list[str]:
    """Return a row of a table of results."""
    name, score = best_script(numbers, place, team)
    of_kinds = [numbers[f"{place}: {kind} / {team}"] for kind in SHOWN]
    seeds, results = str(len(of_kinds[0])), map(spread, of_kinds)
    return [place, seeds, f"{score:.3f} {name}", *results, verdict(numbers, place, team)]


def places_in(numbers: Numbers) -> list[str]:
    """Return the worlds that have been played."""
    found = {name.split(": ")[0]: None for name in numbers if f": {CONTROL} / seconds" in name}
    return list(found)


def table(numbers: Numbers) -> str:
    """Return scores, guarantees and costs as tables in Markdown."""
    places = places_in(numbers)
    variants = [place for place in places if place not in SOLVED]
    heads = ["", "seeds", "best script", *SHOWN, "beat the scripts in all seeds"]
    parts = ["Means over the seeds (least to most)."]
    for team in TEAMS:
        rows = [row(numbers, place, team) for place in variants]
        head = f"Held-out scores of {team}s in the default world of each variant"
        parts += [f"{head}:", markdown(heads, rows).replace("|  |", "| |", 1)]
    if "default race: pursuer" in numbers:
        default = [mean(numbers[f"default race: {team}"]) for team in TEAMS]
        parts.append(
            f"Networks over cells after a hall-of-fame race of `evolve --paper`, 133,450 matches "
            f"and ten seeds (race_budgets): pursuers {default[0]}, evaders {default[1]}."
        )
    for place in places:
        if place in SOLVED:
            value = float(numbers[f"value of {place}"])
            told = f"{place}, value {value:.3f}: what pursuers guarantee, and evaders concede:"
            rows = [[f"{team}s", *row(numbers, place, team)[1:]] for team in TEAMS]
            parts += [told, markdown(heads, rows).replace("|  |", "| |", 1)]
    compared = [(RATING, CELLS), (PROGRAM, CELLS), (HIDDEN, RATING), (RATING, CONTROL)]
    rows = [
        [f"{kind} minus {other}", mean(over(numbers, kind, other), sign="+")]
        for kind, other in [*compared, (PROGRAM, CONTROL)]
    ]
    heads = ["", "difference of held-out scores [95 % over seeds]"]
    parts += ["Means over the variants and teams:", markdown(heads, rows).replace("|  |", "| |", 1)]
    parts += ["What a race, or the choice of random programs, takes:", costs(numbers, variants)]
    return "\n\n".join(parts)


def over(numbers: Numbers, kind: str, other: str) -> FloatArray:
    """Return by how much scores of a kind are above those of another: means (seeds,)."""
    variants = [place for place in places_in(numbers) if place not in SOLVED]
    names = [(f"{place}: {{}} / {team}") for place in variants for team in TEAMS]
    return np.mean([numbers[n.format(kind)] - numbers[n.format(other)] for n in names], axis=0)


def costs(numbers: Numbers, variants: list[str]) -> str:
    """Return genes, matches and seconds of each kind."""
    rows = []
    for kind in SHOWN:
        genes, matches, seconds = (
            np.concatenate([numbers[f"{place}: {kind} / {name}"] for place in variants])
            for name in ("genes", "matches", "seconds")
        )
        sizes = f"{genes.mean():,.0f}", f"{matches.mean():,.0f}"
        rows.append([kind, *sizes, spread(seconds, 1)])
    heads = ["", "genes (of programs: instructions)", "matches", "seconds (least to most)"]
    return markdown(heads, rows).replace("|  |", "| |", 1)


if __name__ == "__main__":
    experiment(__doc__, kinds=kinds, measure=measured, table=table, seeds=10, play=play)
