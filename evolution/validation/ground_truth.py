"""Which measure tells the truth? Races in a world whose perfect play is known.

    python evolution/validation/ground_truth.py           ten seeds of each schedule, half an hour
    python evolution/validation/ground_truth.py --quick   two seeds of tiny races, some seconds

The world is that of ``small_world.toml``. The truth about a generation is what it *guarantees*: its
score (capture rate of pursuers, escape rate of evaders) against the best response, computed exactly
(docs/ground_truth.md). Beside it stands what the package's measures say. Three questions:

- *generations*: which of two generations of a race is better? Spearman's correlation over the
  generations of a race, mean over the races of a seed; numbers have four digits, and a race whose
  generations all guarantee the same does not count;
- *champions*: which of two races has the better last generation? Correlation over races;
- *changes*: in which of two races did a team improve more? Correlation over races, of linear
  changes (slope times length, as a gain is).

Intervals are over seeds, which are independent; races of a seed begin with the same genomes, and
generations follow from each other. For correlations over races they come from a jackknife that
leaves out one seed after the other. Each interval speaks of its own row.

Judgement. A team *rises* in a window if its guaranteed score changes by ``RISES`` or more
(linearly), and does not rise if it changes by ``STAYS`` at most; in between the truth is open, and
the race is not counted. Arms race: both teams rise; it is false if one does not. One-sided
progress: one rises, the other does not; false if both or none rise. Rise: a team rises; false if
none does. Stagnation: no team changes by more than ``STAYS``; false if one changes by ``RISES``.
The thresholds were set when one race of each schedule had been seen. The judgement is about scores
against the opponents of the race, so an error here is an error of the reader who takes it for more.

Best responses to the champions of generalists are learned, too, and compared with the exact ones.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import cache, partial
from pathlib import Path
from typing import Any

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.figure import Figure
from scipy import stats

import _paths  # noqa: F401
import matrixworld as mw
from common import (
    SMALL_STEPS,
    Numbers,
    Runs,
    by_seed,
    experiment,
    kept,
    kinds_in,
    long_race,
    markdown,
    mean,
    scores_against,
    written,
)
from judgement_tables import RATE_HEADS, count_verdicts, errors_of, read_counts
from judgement_truths import WINDOWS
from matrixworld import analysis
from matrixworld._util.files import load_toml
from matrixworld.coevolution import (
    TEAMS,
    RaceSettings,
    SavedRun,
    Team,
    best_responses,
    open_run,
    score,
)
from matrixworld.coevolution.types import FloatArray, other
from matrixworld.solve import States, expected_payoff, guarantees

SMALL = load_toml(Path(__file__).parents[1] / "small_world.toml")
SHORT = {"match_episodes": 4, "schedule.generations": 20}
"""Races shorter than those of the file, of which many are needed."""
QUICK = {
    "world.rows": 3, "world.cols": 3, "world.max_steps": 2, "learner.population": 4,
    "schedule.generations": 8,
}  # fmt: skip
SCHEDULES = (
    "specialist-specialist", "generalist-specialist", "generalist-generalist", "hall-of-fame",
    "psro",
)  # fmt: skip
BUDGETS = (2_000, 5_000, 20_000, 200_000)
"""Matches of learned responses."""
RESPONSES_TO = "generalist-generalist"
"""Schedule to whose champions responses are learned."""
HELD_OUT_EPISODES = 100
RISES, STAYS = 0.02, 0.005

MEASURES = {
    "current": "the opponent of the same generation",
    "ancestors": "all earlier opponents (CIAO)",
    "all": "all opponents of the race (gain)",
    "worst": "worst opponent of the race",
    "nash": "Nash mixture of the race's opponents",
    "elo": "Elo rating within the race",
    "held_out": "held-out opponents",
    "others": "champions of other seeds",
    "response": "learned response",
}
"""What a generation is scored against; numbers (seeds, teams, generations), as ``truth``."""
JUDGED = ("arms race", "one-sided progress", "rise", "stagnation")
"""Conditions whose truth is known; ``verdicts`` (seeds, windows, conditions) are those on them."""


# ---- Races and their numbers ---------------------------------------------------------------------


def kinds(quick: bool) -> dict[str, RaceSettings]:
    """Return the settings of a race of each schedule."""
    found = {}
    for schedule in SCHEDULES:
        found[schedule] = RaceSettings.of(SMALL | long_race(schedule)).changed(SHORT)
        if quick:
            epochs = [name for name in vars(found[schedule].schedule) if name.endswith("_epochs")]
            few = {f"schedule.{name}": 2 for name in epochs}
            found[schedule] = found[schedule].changed(QUICK | few)
    return found


@cache
def states_of(world: mw.WorldConfig) -> States:
    """Return the states of a world, which all races share."""
    return States(world)


def numbers_of(run: SavedRun) -> dict[str, Any]:
    """Return truth, measures and verdicts of a race that need no other race."""
    truth, payoff = guarantees(states_of(run.settings.world), run.teams), run.payoff()
    held_out = score(run, generation=None, episodes=HELD_OUT_EPISODES)
    windows = analysis.judge(payoff.capture_rates, per_episode=True).windows
    each = [measures_of(payoff.capture_rate, team) for team in TEAMS]
    return {
        "truth": [truth.pursuers.tolist(), (1 - truth.evaders).tolist()],
        **{name: [of_team[name].tolist() for of_team in each] for name in each[0]},
        "held_out": [held_out[team].rates.mean(axis=(1, 2)).tolist() for team in TEAMS],
        "verdicts": [
            # A race may be too short for a window.
            [windows[name][c].verdict if name in windows else "cannot tell" for c in JUDGED]
            for name in WINDOWS
        ],
        "value": truth.value,
    }


def measures_of(capture_rate: FloatArray, team: Team) -> dict[str, FloatArray]:
    """Return the measures of each generation of a team that follow from the payoff matrix."""
    own = capture_rate if team == "pursuer" else 1 - capture_rate.T
    return {
        "current": np.diag(own),
        "ancestors": np.array([row[: k + 1].mean() for k, row in enumerate(own)]),
        "all": own.mean(axis=1),
        "worst": own.min(axis=1),
        "nash": np.asarray(getattr(analysis.nash_averaging(capture_rate), f"{team}_averages")),
        "elo": np.asarray(getattr(analysis.elo(capture_rate), f"{team}s")),
    }


def against_others(runs: Runs, run: SavedRun) -> list[FloatArray]:
    """Return the scores of each generation of a race against champions of all other seeds."""
    world, seed = run.settings.world, run.settings.seed
    by_seeds = zip(*runs.values(), strict=True)
    strangers = [each for n, of_seed in enumerate(by_seeds) for each in of_seed if n != seed]
    found = []
    for team in TEAMS:
        met = [each.teams[other(team)] for each in strangers]
        champions = mw.Population(np.stack([p.genomes[-1] for p in met]), met[0].network)
        rates = scores_against(world, team, run.teams[team], champions, seed=seed, episodes=10)
        found.append(rates.mean(axis=1))
    return found


def responses(runs: Sequence[SavedRun], budgets: Sequence[int]) -> FloatArray:
    """Return exact scores of responses to the champions of races (seeds, teams, 1 + budgets).

    First that of the champion's last opponent; then those of learned responses, by matches.
    """
    found = np.zeros((len(runs), len(TEAMS), 1 + len(budgets)))
    champions = {f"seed-{run.settings.seed}": run for run in runs}
    states, root = states_of(runs[0].settings.world), runs[0].path.parents[1] / "responses"
    for t, team in enumerate(TEAMS):
        met = [{each: run.last(each) for each in TEAMS} for run in runs]
        found[:, t, 0] = [exact(states, teams, team) for teams in met]
        steps = SMALL_STEPS[other(team)]
        learner = RaceSettings.of({"learner.population": 48, **steps}).learner
        for b, budget in enumerate(budgets, 1):
            where = root / f"responses-to-{team}s-{budget}"
            learned = best_responses(champions, team, budget, where, learner=learner, threads=1)
            for seed, each in enumerate(learned.values()):
                last = open_run(each.directory).last(other(team))
                found[seed, t, b] = exact(states, met[seed] | {other(team): last}, team)
    return found


def exact(states: States, teams: dict[Team, mw.Population], champion: Team) -> float:
    """Return the exact score of a champion's opponent."""
    captured = expected_payoff(states, teams["pursuer"], teams["evader"])
    return captured if champion == "evader" else 1 - captured


def measured(runs: Runs, quick: bool) -> dict[str, Any]:
    """Return truth, `MEASURES` and verdicts of all races, and what responses get.

    Files beside the runs keep what needs no other race.
    """
    numbers = by_seed(
        runs, lambda run: kept(run.path.with_suffix(".json"), partial(numbers_of, run))
    )
    numbers |= by_seed(runs, lambda run: {"others": against_others(runs, run)})
    if RESPONSES_TO in runs:
        budgets = BUDGETS[: 1 if quick else None]
        learned = responses(runs[RESPONSES_TO], budgets)
        numbers |= {"budgets": budgets, "responses": learned}
        # Of the last generation only; as of the other measures, higher is better.
        numbers[f"{RESPONSES_TO} / response"] = 1 - learned[:, :, -1:]
    return {
        name: each if np.asarray(each).dtype.kind in "UTi" else np.round(each, 4)
        for name, each in numbers.items()
    }


def of_schedules(numbers: Numbers, name: str) -> dict[str, FloatArray]:
    """Return a number of the races of all schedules that have it."""
    names = {schedule: f"{schedule} / {name}" for schedule in kinds_in(numbers)}
    return {schedule: numbers[key] for schedule, key in names.items() if key in numbers}


# ---- Which measure tells the truth? --------------------------------------------------------------


def linear_change(scores: FloatArray) -> FloatArray:
    """Return the least-squares slope of scores (..., generations), times the length."""
    generations = np.arange(scores.shape[-1])
    slope = np.apply_along_axis(lambda each: np.polyfit(generations, each, 1)[0], -1, scores)
    return np.asarray(slope * generations[-1])


def correlation(one: FloatArray, other: FloatArray) -> float:
    """Return Spearman's correlation; nan if one of both is constant."""
    if np.ptp(one) < 1e-9 or np.ptp(other) < 1e-9:
        return float("nan")
    return float(stats.spearmanr(one, other, axis=None).statistic)


def within_races(said: FloatArray, truth: FloatArray) -> analysis.Estimate | None:
    """Return how well a measure (schedules, seeds, generations) orders the generations of a race.

    Races whose generations do not differ do not count.
    """
    found = np.full(said.shape[:2], np.nan)
    for race in np.ndindex(found.shape):
        found[race] = correlation(said[race], truth[race])
    means = [np.nanmean(each) for each in found.T if not np.isnan(each).all()]
    return analysis.interval_over_runs(means, bounds=(-1.0, 1.0)) if len(means) > 1 else None


def between_races(said: FloatArray, truth: FloatArray) -> analysis.Estimate | None:
    """Return how well a number of a measure (schedules, seeds) orders races by the truth."""
    n = said.shape[1]
    if n < 3:
        return None
    whole = correlation(said, truth)
    without = np.array(
        [correlation(np.delete(said, k, axis=1), np.delete(truth, k, axis=1)) for k in range(n)]
    )
    # Pseudo-values of the jackknife (Tukey 1958).
    estimate = analysis.interval_over_runs(n * whole - (n - 1) * without)
    if estimate.low is None or estimate.high is None:
        return replace(estimate, value=whole)
    half = (estimate.high - estimate.low) / 2
    return replace(estimate, value=whole, low=max(whole - half, -1.0), high=min(whole + half, 1.0))


def table_of_measures(numbers: Numbers) -> str:
    """Return the correlations of all measures with the truth."""
    heads = ["score against"]
    heads += [f"{q}: {t}s" for q in ("generations", "champions", "changes") for t in TEAMS]
    rows = []
    for measure, label in MEASURES.items():
        if measured := of_schedules(numbers, measure):
            said = np.stack(list(measured.values()))  # (schedules, seeds, teams, generations)
            truth = np.stack([numbers[f"{schedule} / truth"] for schedule in measured])
            teams = [(said[:, :, t], truth[:, :, t]) for t in range(len(TEAMS))]
            # A learned response is one to the last generation.
            curves = teams if said.shape == truth.shape else []
            found = [
                *([within_races(*pair) for pair in curves] or [None, None]),
                *(between_races(each[..., -1], true[..., -1]) for each, true in teams),
                *([between_races(*map(linear_change, pair)) for pair in curves] or [None, None]),
            ]
            rows.append([label, *("-" if each is None else written(each, 2) for each in found)])
    return markdown(heads, rows)


def table_of_truth(numbers: Numbers) -> str:
    """Return where the teams of each schedule begin and end, and the NashConv of the last pair."""
    heads = ["schedule", *(f"{team}s: {when}" for team in TEAMS for when in ("first", "last"))]
    rows = []
    for schedule, truth in of_schedules(numbers, "truth").items():
        ends = [truth[:, t, when] for t in range(len(TEAMS)) for when in (0, -1)]
        ends.append(1 - truth[:, :, -1].sum(axis=1))
        rows.append([schedule, *(mean(each, bounds=(0.0, 1.0)) for each in ends)])
    return markdown([*heads, "NashConv: last"], rows)


def table_of_responses(numbers: Numbers) -> str:
    """Return how much of the gain of a best response the learned ones find, by matches."""
    met, *learned = np.moveaxis(numbers["responses"], 2, 0)  # (seeds, teams) each
    best = 1 - numbers[f"{RESPONSES_TO} / truth"][:, :, -1] - met
    rows = []
    for budget, each in zip(numbers["budgets"], learned, strict=True):
        gains = each - met
        columns = [
            column for t in range(len(TEAMS)) for column in (gains[:, t], (gains / best)[:, t])
        ]
        rows.append([f"{budget:,}", *(mean(column, 2) for column in columns)])
    heads = [f"{team}s: {what}" for team in TEAMS for what in ("gain", "share of the true gain")]
    return markdown(["matches", *heads], rows)


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


HERE = "races of the small world"
OTHERS = ("held back", "toy game", "real race")
TOYS = Path(__file__).parents[1] / "results" / "judgement" / "counts.csv"


def table_of_errors(numbers: Numbers) -> str:
    """Return the errors of the judgement here, beside those of synthetic races and toys."""
    judged = []  # in the form of `judgement_errors.judged`
    for schedule, verdicts in of_schedules(numbers, "verdicts").items():
        for truth, of_seed in zip(numbers[f"{schedule} / truth"], verdicts, strict=True):
            found = [
                [window, name, holds, size, verdict]
                for window, said in zip(WINDOWS, of_seed, strict=True)
                for (name, (holds, size)), verdict in zip(
                    truths_of(truth, window).items(), said, strict=True
                )
            ]
            judged.append({"source": HERE, "kind": schedule, "found": found})
    counts = count_verdicts(judged) + read_counts(TOYS)
    rows = [
        [name, sample, *errors_of(counts, condition=name, sample=sample)]
        for name in JUDGED
        for sample in (HERE, *OTHERS)
    ]
    return markdown(("condition", "sample", *RATE_HEADS), rows)


def table_of_changes(numbers: Numbers) -> str:
    """Return true changes and gains of both teams by schedule."""
    rows = []
    for schedule, truth in of_schedules(numbers, "truth").items():
        gains, guaranteed = map(linear_change, (numbers[f"{schedule} / all"], truth))
        columns = [each[:, t] for t in range(len(TEAMS)) for each in (gains, guaranteed)]
        said = numbers[f"{schedule} / verdicts"][:, 0, JUDGED.index("arms race")]
        counted = f"{(said == 'present').sum()} of {len(said)}"
        rows.append([schedule, *(mean(column, 3, "+") for column in columns), counted])
    heads = [f"{team}s: {what}" for team in TEAMS for what in ("gain", "guarantee")]
    return markdown(["schedule", *heads, "arms race present"], rows)


# ---- Files ---------------------------------------------------------------------------------------


def table(numbers: Numbers) -> str:
    """Return all tables."""
    truth = of_schedules(numbers, "truth")
    races, seeds = sum(map(len, truth.values())), max(map(len, truth.values()))
    parts = [
        "# Which measure tells the truth?",
        f"{races} races of {seeds} seeds; perfect play captures {value_of(numbers):.3f}. "
        "Definitions: the docstring of `evolution/validation/ground_truth.py`. In brackets: 95 % "
        "intervals over seeds.",
        "## What the teams guarantee",
        table_of_truth(numbers),
        "## Correlations with the truth",
        table_of_measures(numbers),
        "## Changes over a race",
        table_of_changes(numbers),
        "## Errors of the judgement",
        table_of_errors(numbers),
    ]
    if "responses" in numbers:
        parts += [
            "## Learned responses to the last generations",
            f"Champions: those of {RESPONSES_TO}. Gain: exact score of the response minus that of "
            "the champion's last opponent.",
            table_of_responses(numbers),
        ]
    return "\n\n".join(parts)


def value_of(numbers: Numbers) -> float:
    """Return what perfect play captures, the same in all races."""
    return float(next(iter(of_schedules(numbers, "value").values()))[0])


def figure(numbers: Numbers) -> Figure:
    """Draw the truth beside two measures, by generation: means and intervals over seeds."""
    panels = {"all": "Score in the race", "held_out": "Held-out score", "truth": "Guaranteed score"}
    drawn, axes = plt.subplots(2, 3, figsize=(11, 6), sharex=True, layout="constrained", dpi=90)
    for t, (team, line) in enumerate(zip(TEAMS, axes, strict=True)):
        for (name, title), axis in zip(panels.items(), line, strict=True):
            for schedule, curves in of_schedules(numbers, name).items():
                band = analysis.band_over_runs(curves[:, t], bounds=(0.0, 1.0))
                [drawn_line] = axis.plot(band.mean, label=schedule)
                if band.low is not None:
                    at, color = np.arange(len(band.mean)), drawn_line.get_color()
                    axis.fill_between(at, band.low, band.high, color=color, alpha=0.2)
            axis.set_title(title if team == "pursuer" else "")
        line[0].set_ylabel(f"{team}s")
        value = value_of(numbers) if team == "pursuer" else 1 - value_of(numbers)
        told = f"perfect play: {value:.2f}"
        line[2].text(0.03, 0.95, told, transform=line[2].transAxes, ha="left", va="top")
    for axis in axes[1]:
        axis.set_xlabel("generation")
    drawn.legend(*axes[0, 0].get_legend_handles_labels(), ncols=5, loc="outside lower center")
    return drawn


if __name__ == "__main__":
    figures = {"measures.png": figure}
    experiment(__doc__, kinds=kinds, measure=measured, table=table, seeds=10, figures=figures)
