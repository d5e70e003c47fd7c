"""Can a race be judged by its own matrix? Races in worlds whose perfect play is known.

    python evolution/validation/ground_truth.py           30 seeds of each race, three core-hours
    python evolution/validation/ground_truth.py --quick   two seeds of tiny races, some seconds

The truth about a generation is what it *guarantees*: its score (capture rate of pursuers, escape
rate of evaders) against the best response, computed exactly (docs/ground_truth.md). Beside it
stands what the package's measures say. The worlds:

- *chase* (two against one) and *split* (one against two): agents take turns, contact captures;
- *surround* (two against one): agents take turns, pursuers capture by surrounding;
- *together* (two against one): all move at once, as in O. There whoever knows the probabilities of
  a champion beats it nearly always, so that no champion guarantees anything: a control, in which
  no measure should find a rise;
- five worlds more, with turns and of one schedule, specialists, so that measures have an interval
  over worlds: *ring* (one against one around a block), *diagonal* (one against one, eight
  directions), *rooms* (two against one, two rooms and a door), *pairs* (two against two), *trio*
  (three against one, capture by surrounding). Their races keep their payoff matrices. Worlds,
  schedule and tables were decided before these races were played.

Questions, over the first three worlds:

- *rises*: did a team become better? It *rises* in a race if what it guarantees changes by `RISES`
  or more (least-squares slope times length), and does not if it changes by `STAYS` at most; in
  between the truth is open, and the race is not counted. A measure says so if it changes by
  `RISES` or more. Hits are of races that rise, false alarms of those that do not, also at the
  threshold at which each measure has `EQUAL_HITS`. The *area* under the curve of both, over all
  thresholds, is the probability that a race which rises has the larger change of the measure: 1 is
  perfect, 0.5 is chance.
- *worlds*: the area of each measure on evaders in each of the eight worlds with turns in which
  `ENOUGH` races rise and as many do not; its mean has an interval over worlds, and so has its
  difference from that of the mean over all opponents of the race. *Deviation ratings* and *Soft
  Condorcet* are computed from the payoff matrices of the five.
- *choice*: which generation of a race is best? *Lost* is what the best one guarantees minus what
  the generation guarantees to which a measure gives the highest score (of equals the latest).
- *generations*: Spearman's correlation with the truth over the generations of a race; races whose
  generations all guarantee the same do not count.
- *judgement*, in the five worlds: arms race: both teams rise; false if one does not. One-sided
  progress: one rises, the other does not; false if both or none rise. Rise: a team rises; false if
  none does. Stagnation: no team changes by more than `STAYS`; false if one changes by `RISES`. The
  judgement is about scores against the opponents of the race, so an error here is an error of the
  reader who takes it for more. Groups are ten races of the same settings; their truth is the mean
  course.

Numbers have four digits. Intervals are over seeds, whose races are independent: each seed gives one
number, over all its races. Areas have a jackknife that leaves out one seed after the other. Each
interval speaks of its own row. Worlds, thresholds and tables were decided when single races of
seed 0 had been seen.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from functools import partial
from typing import Any

import numpy as np
from matplotlib.figure import Figure
from scipy import optimize, special, stats

import _paths  # noqa: F401
import matrixworld as mw
from common import (
    Numbers,
    Runs,
    by_seed,
    experiment,
    guaranteed,
    kept,
    kinds_in,
    markdown,
    mean,
    scores_against,
    solved,
    written,
)
from judgement_tables import RATE_HEADS, count_verdicts, errors_of
from judgement_truths import WINDOWS
from matrixworld import Capture, Interaction, Outcome, Rules, analysis
from matrixworld.coevolution import TEAMS, RaceSettings, SavedRun, Team, score
from matrixworld.coevolution.types import BoolArray, FloatArray, other

SURROUND = Rules(Interaction.AGENT_TURNS, evader=Outcome.BOUNCE, capture=Capture.SURROUND)
WORLDS: dict[str, dict[str, Any]] = {
    "chase": {"rules": "TO", "rows": 5, "cols": 5, "n_pursuers": 2, "n_evaders": 1, "max_steps": 4},
    "split": {"rules": "TO", "rows": 5, "cols": 5, "n_pursuers": 1, "n_evaders": 2, "max_steps": 5},
    "surround": {
        "rules": SURROUND, "rows": 3, "cols": 3, "n_pursuers": 2, "n_evaders": 1, "max_steps": 4,
    },
    "together": {
        "rules": "O", "rows": 4, "cols": 4, "n_pursuers": 2, "n_evaders": 1, "max_steps": 5,
    },
    "ring": {
        "rules": "TO", "rows": 4, "cols": 4, "n_pursuers": 1, "n_evaders": 1, "max_steps": 5,
        "obstacles": ["....", ".##.", ".##.", "...."],
    },
    "diagonal": {
        "rules": "TO", "rows": 5, "cols": 5, "n_pursuers": 1, "n_evaders": 1, "max_steps": 5,
        "diagonal": True,
    },
    "rooms": {
        "rules": "TO", "rows": 5, "cols": 5, "n_pursuers": 2, "n_evaders": 1, "max_steps": 5,
        "obstacles": ["..#..", "..#..", ".....", "..#..", "..#.."],
    },
    "pairs": {"rules": "TO", "rows": 3, "cols": 4, "n_pursuers": 2, "n_evaders": 2, "max_steps": 4},
    "trio": {
        "rules": SURROUND, "rows": 3, "cols": 3, "n_pursuers": 3, "n_evaders": 1, "max_steps": 4,
    },
}  # fmt: skip
CONTROL = "together"
FIVE = ("ring", "diagonal", "rooms", "pairs", "trio")
SCHEDULES: dict[str, dict[str, Any]] = {
    "specialists": {"schedule": "specialist-specialist"},
    "generalists": {"schedule": "generalist-generalist"},
    "hall of fame": {"schedule": "hall-of-fame"},
    "PSRO": {"schedule": "psro"},
}
RACE = {
    "match_episodes": 16, "evaluation_episodes": 20, "policy.hidden": [16],
    "learner.population": 32, "learner.sigma": 0.3, "learner.relative_sigma": 1.0,
    "learner.learning_rate": 0.1, "schedule.generations": 30,
}  # fmt: skip
QUICK = {"learner.population": 4, "schedule.generations": 8, "match_episodes": 2}
EPOCHS = 30
HELD_OUT_EPISODES = 100
RISES, STAYS = 0.02, 0.005
ENOUGH = 3
EQUAL_HITS = 0.9
GROUP = 10
"""Races of a group."""

MEASURES = {
    "current": "the opponent of the same generation",
    "ancestors": "all earlier opponents (CIAO)",
    "all": "all opponents of the race (gain)",
    "worst": "worst opponent of the race",
    "nash": "Nash mixture of the race's opponents",
    "elo": "Elo rating within the race",
    "held_out": "held-out opponents",
    "others": "champions of other seeds",
}
RATINGS = {"deviation": "deviation ratings within the race", "condorcet": "Soft Condorcet ratings"}
"""What a generation is scored against; numbers (seeds, teams, generations), as ``truth``."""
JUDGED = ("arms race", "one-sided progress", "rise", "stagnation")
"""Conditions whose truth is known; ``verdicts`` (seeds, windows, conditions) are those on them, and
``of groups`` (groups, windows, conditions). If the judgement changes, `judged` makes both anew."""


# ---- Races and their numbers ---------------------------------------------------------------------


def kinds(quick: bool) -> dict[str, RaceSettings]:
    """Return the settings of a race of each schedule in each world."""
    return {
        f"{name}, {schedule}": settings(world, changes, quick)
        for name, world in WORLDS.items()
        for schedule, changes in SCHEDULES.items()
        if name not in FIVE or schedule == "specialists"
    }


def settings(world: dict[str, Any], schedule: dict[str, Any], quick: bool) -> RaceSettings:
    """Return the settings of a race; its networks see the whole world."""
    game = {f"world.{name}": value for name, value in world.items()}
    game |= {
        "world.fov": 2 * max(world["rows"], world["cols"]) - 1,
        "train_steps": world["max_steps"],
    }
    # In an epoch of both teams an individual meets three opponents, and not one.
    epochs = 2 if quick else EPOCHS
    alone = {f"schedule.{team}_epochs": epochs for team in TEAMS}
    together = {"schedule.joint_epochs": max(1, epochs // 2)}
    joint = schedule["schedule"] == "hall-of-fame"
    chosen = schedule | game | RACE | (together if joint else alone)
    return RaceSettings.of(chosen | (QUICK if quick else {}))


def numbers_of(run: SavedRun) -> dict[str, Any]:
    """Return truth and measures of a race that need no other race."""
    matrix = run.payoff().matrix
    sides = matrix, 1 - matrix.T
    pursuers, evaders = (guaranteed(run, team) for team in TEAMS)
    held_out = score(run, generation=None, episodes=HELD_OUT_EPISODES)
    each = [measures_of(matrix, team) for team in TEAMS]
    return {
        "truth": [pursuers.tolist(), (1 - evaders).tolist()],
        **{name: [of_team[name].tolist() for of_team in each] for name in each[0]},
        "deviation": [deviation_ratings(own).tolist() for own in sides],
        "condorcet": [soft_condorcet(own).tolist() for own in sides],
        "held_out": [held_out[team].rates.mean(axis=(1, 2)).tolist() for team in TEAMS],
        "value": solved(run.settings.game.world).value,
    }


def in_five(kind: str) -> bool:
    """Return whether a kind of races is of one of the worlds whose scores are kept."""
    return kind.split(", ")[0] in FIVE


def judged(numbers: Numbers) -> dict[str, Any]:
    """Return what the judgement says of each race of `FIVE`, and of groups, from kept scores."""
    found: dict[str, Any] = {}
    for kind in filter(in_five, kinds_in(numbers)):
        scores = numbers[f"{kind} / scores"]
        groups = [scores[k : k + GROUP] for k in range(0, len(scores), GROUP)]
        found[f"{kind} / verdicts"] = np.array([verdicts(race) for race in scores])
        found[f"{kind} / of groups"] = np.array([verdicts(group) for group in groups])
    return found


def verdicts(capture_rates: FloatArray) -> list[list[str]]:
    """Return what the judgement says of the race or races (windows, conditions)."""
    windows = analysis.judge(capture_rates, per_episode=True).windows
    return [
        # A race may be too short for a window.
        [windows[name][c].verdict if name in windows else "cannot tell" for c in JUDGED]
        for name in WINDOWS
    ]


def measures_of(capture_rate: FloatArray, team: Team) -> dict[str, FloatArray]:
    """Return the measures of each generation of a team that follow from the payoff matrix."""
    own = capture_rate if team == "pursuer" else 1 - capture_rate.T
    elo = np.asarray(getattr(analysis.elo(capture_rate), f"{team}s"))
    return {
        "current": np.diag(own),
        "ancestors": np.array([row[: k + 1].mean() for k, row in enumerate(own)]),
        "all": own.mean(axis=1),
        "worst": own.min(axis=1),
        "nash": np.asarray(getattr(analysis.nash_averaging(capture_rate), f"{team}_averages")),
        # As a score against an equal opponent.
        "elo": 1 / (1 + np.exp(-elo)),
    }


def deviation_ratings(scores: FloatArray) -> FloatArray:
    """Return the deviation ratings of rows, for scores (rows, opponents) in a zero-sum game.

    They are scores against a mixture of opponents, of the equilibrium that minimises the largest
    of them, then the second largest, and so on (Marris et al. 2025, "Deviation ratings: a general,
    clone-invariant rating method"). A row is settled if its bound has a price.
    """
    n, m = scores.shape
    ratings = np.full(n, np.nan)
    while (open_ := np.isnan(ratings)).any():
        found = optimize.linprog(
            np.append(np.zeros(m), 1.0),  # the largest score that is still open
            A_ub=np.column_stack([scores, -open_.astype(float)]),
            b_ub=np.where(open_, 0.0, ratings + 1e-5),
            A_eq=np.append(np.ones(m), 0.0)[None],
            b_eq=[1.0],
            bounds=[(0, None)] * m + [(None, None)],
        )
        ratings[open_ & (found.ineqlin.marginals < -1e-7)] = found.fun
    return ratings


def soft_condorcet(scores: FloatArray) -> FloatArray:
    """Return ratings of rows by the votes of opponents, for scores (rows, opponents).

    Each opponent prefers the row that scores more; the ratings minimise the sum of sigmoids over
    all preferences that they contradict (Lanctot et al. 2025, "Soft Condorcet optimization for
    ranking of general agents"). They lie in [0, 100].
    """
    wins = (scores[:, None] > scores[None]).mean(axis=-1)
    lead = wins - wins.T

    def loss(ratings: FloatArray) -> tuple[float, FloatArray]:
        against = special.expit(ratings[None] - ratings[:, None])
        return float((wins * against).sum()), -(lead * against * (1 - against)).sum(axis=1)

    start = np.full(len(scores), 50.0)
    return np.asarray(
        optimize.minimize(loss, start, jac=True, bounds=[(0.0, 100.0)] * len(scores)).x
    )


def against_others(runs: Runs, kind: str, run: SavedRun) -> list[FloatArray]:
    """Return the scores of each generation of a race against champions of all other seeds."""
    world, seed, place = run.settings.game.world, run.settings.seed, kind.split(", ")[0]
    of_world = [each for name, each in runs.items() if name.startswith(f"{place}, ")]
    strangers = [
        each
        for n, of_seed in enumerate(zip(*of_world, strict=True))
        for each in of_seed
        if n != seed
    ]
    found = []
    for team in TEAMS:
        met = [each.teams[other(team)] for each in strangers]
        champions = mw.Population(np.stack([p.genomes[-1] for p in met]), met[0].policy)
        rates = scores_against(world, team, run.teams[team], champions, seed=seed, episodes=10)
        found.append(rates.mean(axis=1))
    return found


def measured(runs: Runs, quick: bool) -> dict[str, Any]:
    """Return truth and `MEASURES` of all races; ratings, scores and verdicts of those of `FIVE`.

    Files beside the runs keep what needs no other race.
    """
    numbers = by_seed(
        runs, lambda run: kept(run.path.with_suffix(".json"), partial(numbers_of, run))
    )
    for kind, of_kind in runs.items():
        numbers |= by_seed(
            {kind: of_kind},
            lambda run, kind=kind: {"others": against_others(runs, kind, run)},  # type: ignore[misc]
        )
        if in_five(kind):
            numbers[f"{kind} / scores"] = np.stack(
                [run.payoff().scores.astype(np.float16) for run in of_kind]
            )
    numbers = {
        name: each if np.asarray(each).dtype.kind in "UTi" else np.round(each, 4)
        for name, each in numbers.items()
    }
    return numbers | judged(numbers)


def of_kinds(numbers: Numbers, name: str, world: str | None = None) -> dict[str, FloatArray]:
    """Return a number of the races of all kinds, in one world or in the first three."""
    return {
        kind: numbers[f"{kind} / {name}"]
        for kind in kinds_in(numbers)
        if (place := kind.split(", ")[0]) == world
        or (world is None and place not in (CONTROL, *FIVE))
    }


def stacked(numbers: Numbers, name: str, world: str | None = None) -> FloatArray:
    """Return a number of all races as (seeds, kinds, ...)."""
    return np.stack(list(of_kinds(numbers, name, world).values()), axis=1)


# ---- Which measure tells the truth? --------------------------------------------------------------


def linear_change(scores: FloatArray) -> FloatArray:
    """Return the least-squares slope of scores (..., generations), times the length."""
    generations = np.arange(scores.shape[-1]) - (scores.shape[-1] - 1) / 2
    slope = scores @ generations / (generations @ generations)
    return np.asarray(slope * (scores.shape[-1] - 1))


def share(said: BoolArray, counted: BoolArray) -> str:
    """Return the share of the counted races (seeds, kinds) of which it is said, and how many."""
    races = counted.sum(axis=1)
    shares = (said & counted).sum(axis=1)[races > 0] / races[races > 0]
    return mean(shares, 2, bounds=(0.0, 1.0)) if len(shares) > 1 else "-"


def area(said: FloatArray, rises: BoolArray, stays: BoolArray) -> float:
    """Return the probability that a race that rises has the larger change of a measure."""
    if not rises.any() or not stays.any():
        return float("nan")
    return float(
        stats.mannwhitneyu(said[rises], said[stays]).statistic / (rises.sum() * stays.sum())
    )


def jackknife(of: Callable[[slice | FloatArray], float], seeds: int) -> str:
    """Return a number of all seeds and its interval by leaving out one after the other.

    Pseudo-values of Tukey (1958).
    """
    every = np.arange(seeds)
    whole = of(every)
    pseudo = seeds * whole - (seeds - 1) * np.array([of(np.delete(every, k)) for k in every])
    if np.isnan(pseudo).any() or seeds < 3:
        return "-"
    spread = analysis.interval_over_runs(pseudo)
    if spread.low is None or spread.high is None:
        return f"{whole:.2f}"
    half = (spread.high - spread.low) / 2
    return f"{whole:.2f} [{max(whole - half, 0.0):.2f}, {min(whole + half, 1.0):.2f}]"


def table_of_rises(numbers: Numbers) -> str:
    """Return hits, false alarms and areas of all measures in the worlds with turns."""
    truth = linear_change(stacked(numbers, "truth"))  # (seeds, kinds, teams)
    rises, stays = truth >= RISES, truth <= STAYS
    rows = []
    for measure, label in MEASURES.items():
        said = linear_change(stacked(numbers, measure))
        cells = [label]
        for t in range(len(TEAMS)):
            each, up, flat = said[..., t], rises[..., t], stays[..., t]
            found = partial(_area_of, each, up, flat)
            equal = np.quantile(each[up], 1 - EQUAL_HITS) if up.any() else np.inf
            cells += [share(each >= RISES, up), share(each >= RISES, flat)]
            cells += [share(each >= equal, flat), jackknife(found, len(each))]
        rows.append(cells)
    heads = ["score against"]
    for t, team in enumerate(TEAMS):
        heads += [f"{team}s: hits of {rises[..., t].sum()}"]
        heads += [f"{team}s: false alarms of {stays[..., t].sum()}"]
        heads += [f"at {EQUAL_HITS:.0%} hits", f"{team}s: area"]
    return markdown(heads, rows)


def _area_of(said: FloatArray, rises: BoolArray, stays: BoolArray, seeds: Any) -> float:
    return area(said[seeds], rises[seeds], stays[seeds])


Known = tuple[BoolArray, BoolArray]
"""Which races rise, and which do not (seeds, kinds)."""


def worlds_of(numbers: Numbers, team: Team, *, both: bool) -> dict[str, Known]:
    """Return the worlds with turns in which enough races of a team do not rise, and rise."""
    found = {}
    for world in WORLDS:
        if world == CONTROL or not of_kinds(numbers, "truth", world):
            continue
        truth = linear_change(stacked(numbers, "truth", world))[..., TEAMS.index(team)]
        known = truth >= RISES, truth <= STAYS
        if known[1].sum() >= ENOUGH and (known[0].sum() >= ENOUGH or not both):
            found[world] = known
    return found


def in_worlds(
    numbers: Numbers,
    team: Team,
    worlds: dict[str, Known],
    number: Callable[[FloatArray, BoolArray, BoolArray], float],
) -> dict[str, FloatArray]:
    """Return a number of each measure in each world (worlds,), NaN where it is not known."""
    t = TEAMS.index(team)
    return {
        name: np.array(
            [
                number(linear_change(stacked(numbers, name, world))[..., t], *known)
                if name in MEASURES or world in FIVE
                else np.nan
                for world, known in worlds.items()
            ]
        )
        for name in MEASURES | RATINGS
    }


def alarms(said: FloatArray, rises: BoolArray, stays: BoolArray) -> float:
    """Return the share of false alarms of a measure."""
    return float((said[stays] >= RISES).mean())


def hits(said: FloatArray, rises: BoolArray, stays: BoolArray) -> float:
    """Return the share of hits of a measure; NaN without enough races that rise."""
    return float((said[rises] >= RISES).mean()) if rises.sum() >= ENOUGH else float("nan")


def over_worlds(worlds: dict[str, Known], found: dict[str, FloatArray]) -> str:
    """Return numbers by world as a table, with their means, and their differences from gains."""
    rows = []
    for name, each in found.items():
        known = np.isfinite(each)
        if known.sum() > 1:
            cells = (f"{a:.2f}" if a >= 0 else "-" for a in each)
            more = mean((each - found["all"])[known], 2, "+")
            average = mean(each[known], 2, bounds=(0.0, 1.0))
            rows.append([(MEASURES | RATINGS)[name], *cells, average, more])
    heads = [f"{world}: {up.sum()} / {flat.sum()}" for world, (up, flat) in worlds.items()]
    return markdown(["score against", *heads, "mean", "minus all opponents"], rows)


def table_of_worlds(numbers: Numbers) -> list[str]:
    """Return areas and false alarms on evaders by world, as paragraphs."""
    both, some = (worlds_of(numbers, "evader", both=each) for each in (True, False))
    if len(some) < 2:
        return []
    # Soft Condorcet ratings have no threshold in common with scores.
    of_scores = in_worlds(numbers, "evader", some, alarms)
    del of_scores["condorcet"]
    return [
        "Evaders; in the heads, races that rise / that do not. Areas:",
        over_worlds(both, in_worlds(numbers, "evader", both, area)),
        "False alarms, also where evaders never rise; added when the areas were known:",
        over_worlds(some, of_scores),
    ]


def figure(numbers: Numbers) -> Figure | None:
    """Draw false alarms and hits on evaders of two measures, by world; None without any."""
    worlds = worlds_of(numbers, "evader", both=False)
    if not worlds:
        return None
    wrong = in_worlds(numbers, "evader", worlds, alarms)
    order = np.argsort(wrong["all"])
    names = [list(worlds)[k] for k in order]
    found = Figure(figsize=(8, 0.3 * len(worlds) + 1.2), layout="constrained")
    for axis, head, shares in zip(
        found.subplots(1, 2, sharex=True, sharey=True),
        ("false alarms: evaders did not become better", "hits: evaders became better"),
        (wrong, in_worlds(numbers, "evader", worlds, hits)),
        strict=True,
    ):
        matrix, held_out = shares["all"][order], shares["held_out"][order]
        axis.hlines(names, matrix, held_out, color="lightgray", linewidth=3, zorder=0)
        for scores, label, color in (
            (matrix, "the race's own matrix", "tab:gray"),
            (held_out, "held-out opponents", "tab:blue"),
        ):
            axis.plot(scores, names, "o", color=color, label=label, clip_on=False)
        axis.set_title(head, fontsize=10)
        axis.set(xlim=(0.0, 1.0), xlabel='share said to be "better"')
        axis.spines[["top", "right", "left"]].set_visible(False)
        axis.tick_params(left=False)
    axis.legend(loc="center left", frameon=False)
    return found


def table_of_control(numbers: Numbers) -> str:
    """Return how often a measure rises where no champion can guarantee anything."""
    truth = linear_change(stacked(numbers, "truth", CONTROL))
    rows = [
        [label]
        + [share((said >= RISES)[..., t], truth[..., t] <= STAYS) for t in range(len(TEAMS))]
        for measure, label in MEASURES.items()
        for said in [linear_change(stacked(numbers, measure, CONTROL))]
    ]
    counts = (truth <= STAYS).sum(axis=(0, 1))
    heads = [f"{team}s: of {n}" for team, n in zip(TEAMS, counts, strict=True)]
    return markdown(["score against", *heads], rows)


def table_of_choices(numbers: Numbers) -> str:
    """Return what a choice by each measure loses, and its correlations over generations."""
    truth = stacked(numbers, "truth")  # (seeds, kinds, teams, generations)
    best, n = truth.max(axis=-1), truth.shape[-1]
    named = {
        "(the last generation)": np.broadcast_to(np.arange(n), truth.shape),
        **{label: stacked(numbers, measure) for measure, label in MEASURES.items()},
    }
    rows = []
    for label, said in named.items():
        chosen = n - 1 - np.argmax(said[..., ::-1], axis=-1)  # of equals the latest
        lost = best - np.take_along_axis(truth, chosen[..., None], -1)[..., 0]
        rows.append(
            [
                label,
                *(mean(lost[..., t].mean(axis=1), 3, bounds=(0.0, 1.0)) for t in range(len(TEAMS))),
                *(within_races(said[:, :, t], truth[:, :, t]) for t in range(len(TEAMS))),
            ]
        )
    heads = [f"{question}: {team}s" for question in ("lost", "generations") for team in TEAMS]
    return markdown(["score against", *heads], rows)


def within_races(said: FloatArray, truth: FloatArray) -> str:
    """Return how well a measure (seeds, kinds, generations) orders the generations of a race."""
    found = np.full(said.shape[:2], np.nan)
    for race in np.ndindex(found.shape):
        if min(np.ptp(said[race]), np.ptp(truth[race])) >= 1e-9:
            found[race] = stats.spearmanr(said[race], truth[race]).statistic
    means = [np.nanmean(each) for each in found if not np.isnan(each).all()]
    if len(means) < 2:
        return "-"
    return written(analysis.interval_over_runs(means, bounds=(-1.0, 1.0)), 2)


def table_of_truth(numbers: Numbers) -> str:
    """Return where the teams of each kind begin and end, and how often they rise or fall."""
    rows = []
    for kind in kinds_in(numbers):
        truth = numbers[f"{kind} / truth"]
        changes = linear_change(truth)
        cells = [kind, f"{numbers[f'{kind} / value'][0]:.3f}"]
        for t in range(len(TEAMS)):
            cells += [mean(truth[:, t, when], bounds=(0.0, 1.0)) for when in (0, -1)]
            counts = [(changes[:, t] >= RISES).sum(), (changes[:, t] <= -RISES).sum()]
            cells.append(" / ".join(map(str, counts)))
        rows.append(cells)
    heads = ["race", "value"]
    for team in TEAMS:
        heads += [f"{team}s: first", f"{team}s: last", f"{team}s: rise / fall"]
    return markdown(heads, rows)


# ---- The judgement -------------------------------------------------------------------------------


def truths_of(truth: FloatArray, window: str) -> dict[str, tuple[bool | None, float]]:
    """Return what is true of a window of a race (teams, generations), by the thresholds above."""
    n = truth.shape[1]
    changes = linear_change(
        truth[:, slice(*(int(share * n) for share in WINDOWS[window]))]
    ).tolist()
    rises = [True if c >= RISES else False if c <= STAYS else None for c in changes]
    known = None not in rises
    most = max(map(abs, changes))
    found = (
        (False if False in rises else True if known else None, min(changes)),
        (rises[0] is not rises[1] if known else None, max(changes)),
        (True if True in rises else False if known else None, max(changes)),
        (True if most <= STAYS else False if most >= RISES else None, most),
    )
    return dict(zip(JUDGED, found, strict=True))


SINGLE, GROUPS = "single races", f"groups of {GROUP}"


def table_of_errors(numbers: Numbers) -> str:
    """Return the errors of the judgement here; `judgement_errors.py` has those of other races."""
    judged: list[dict[str, Any]] = []  # in the form of `judgement_errors.judged`
    for source, name in ((SINGLE, "verdicts"), (GROUPS, "of groups")):
        for kind in filter(in_five, kinds_in(numbers)):
            said = numbers[f"{kind} / {name}"]
            truth = numbers[f"{kind} / truth"]
            size = -(-len(truth) // len(said))
            means = [truth[k : k + size].mean(axis=0) for k in range(0, len(truth), size)]
            judged += [
                {"source": source, "kind": kind, "found": list(_found(*pair))}
                for pair in zip(means, said, strict=True)
            ]
    counts = count_verdicts(judged)
    rows = [
        [name, sample, *errors_of(counts, condition=name, sample=sample)]
        for name in JUDGED
        for sample in (SINGLE, GROUPS)
    ]
    return markdown(("condition", "sample", *RATE_HEADS), rows)


def _found(truth: FloatArray, said: FloatArray) -> Iterable[list[Any]]:
    """Yield what is true and what is said of the windows of a race or group."""
    for window, of_window in zip(WINDOWS, said, strict=True):
        known = truths_of(truth, window).items()
        for (name, (holds, size)), verdict in zip(known, of_window, strict=True):
            yield [window, name, holds, size, verdict]


# ---- Files ---------------------------------------------------------------------------------------


def table(numbers: Numbers) -> str:
    """Return all tables."""
    truth = [numbers[f"{kind} / truth"] for kind in kinds_in(numbers)]
    parts = [
        "# Can a race be judged by its own matrix?",
        f"{sum(map(len, truth))} races of {max(map(len, truth))} seeds. Definitions: the docstring "
        "of `evolution/validation/ground_truth.py`. In brackets: 95 % intervals over seeds.",
        "## What the teams guarantee",
        table_of_truth(numbers),
        "## Did a team become better?",
        table_of_rises(numbers),
        "## In how many worlds?",
        *table_of_worlds(numbers),
        "## Which generation is best?",
        table_of_choices(numbers),
    ]
    if of_kinds(numbers, "truth", CONTROL):
        parts += [f"## False alarms of the control, {CONTROL}", table_of_control(numbers)]
    return "\n\n".join([*parts, "## Errors of the judgement", table_of_errors(numbers)])


if __name__ == "__main__":
    experiment(__doc__, kinds=kinds, measure=measured, table=table, seeds=30, fewest=2, draw=figure)
