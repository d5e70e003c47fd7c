"""Which measure tells the truth? Races in a world whose perfect play is known.

    python evolution/validation/ground_truth.py           ten seeds of each schedule, 15 minutes
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

With ``--responses`` best responses to champions are learned, too, and compared with the exact ones.

Runs are kept in ``--runs``; an interrupted script continues there, and takes further schedules and
seeds. ``--results`` receives the numbers of each race, tables and a figure.
"""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from functools import cache, partial
from pathlib import Path
from typing import Any

import numpy as np
from scipy import stats
from tqdm import tqdm

import _paths  # noqa: F401
import matrixworld as mw
from common import SMALL_STEPS, finish_all, kept, long_race, mean, script_parser, written
from judgement_counts import count_verdicts, read_counts
from judgement_tables import RATE_HEADS, errors_of, table
from judgement_truths import WINDOWS
from matrixworld import analysis
from matrixworld._util.files import load_toml
from matrixworld.coevolution import (
    TEAMS,
    RaceSettings,
    SavedRun,
    Team,
    best_responses,
    score,
    tournament,
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
"""What a generation is scored against."""

Row = dict[str, Any]
"""Numbers of one race."""


# ---- Races and their numbers ---------------------------------------------------------------------


def settings_of(schedule: str, seed: int, quick: bool) -> RaceSettings:
    """Return the settings of a race."""
    base = RaceSettings.of(SMALL | long_race(schedule)).changed(SHORT | {"seed": seed})
    epochs = {"pursuer_epochs": 2, "evader_epochs": 2}
    epochs = {"joint_epochs": 2} if schedule == "hall-of-fame" else epochs
    few = {f"schedule.{name}": number for name, number in epochs.items()}
    return base.changed(QUICK | few) if quick else base


def place(schedule: str, seed: int) -> str:
    """Return the path of a race in the directory of all runs."""
    return f"{schedule}/seed-{seed}"


@cache
def states_of(world: mw.WorldConfig) -> States:
    """Return the states of a world, which all races share."""
    return States(world)


def numbers_of(run: SavedRun) -> Row:
    """Return truth, measures and verdicts of a race that need no other race."""
    truth = guarantees(states_of(run.settings.world), run.teams)
    payoff = run.payoff()
    held_out = score(run, generation=None, episodes=HELD_OUT_EPISODES)
    rates = {team: each.rates.mean(axis=(1, 2)) for team, each in held_out.items()}
    judgement = analysis.judge(payoff.capture_rates, per_episode=True)
    verdicts = {
        window: {name: finding.verdict for name, finding in findings.items()}
        for window, findings in judgement.windows.items()
    }
    return {
        "value": truth.value,
        "truth": {"pursuer": truth.pursuers.tolist(), "evader": (1 - truth.evaders).tolist()},
        "measures": {
            team: measures_of(payoff.capture_rate, team) | {"held_out": rates[team].tolist()}
            for team in TEAMS
        },
        "headline": judgement.window,
        "verdicts": verdicts,
    }


def measures_of(capture_rate: FloatArray, team: Team) -> dict[str, list[float]]:
    """Return the measures of each generation of a team that follow from the payoff matrix."""
    own = capture_rate if team == "pursuer" else 1 - capture_rate.T
    nash, ratings = analysis.nash_averaging(capture_rate), analysis.elo(capture_rate)
    found = {
        "current": np.diag(own),
        "ancestors": np.array([row[: k + 1].mean() for k, row in enumerate(own)]),
        "all": own.mean(axis=1),
        "worst": own.min(axis=1),
        "nash": getattr(nash, f"{team}_averages"),
        "elo": getattr(ratings, f"{team}s"),
    }
    return {name: np.asarray(each).tolist() for name, each in found.items()}


def against_others(runs: Mapping[tuple[str, int], SavedRun], key: tuple[str, int]) -> Row:
    """Return the scores of each generation of a race against champions of all other seeds."""
    run = runs[key]
    strangers = [each for (_, seed), each in runs.items() if seed != key[1]]
    found = {}
    for team in TEAMS:
        met = [each.teams[other(team)] for each in strangers]
        champions = mw.Population(np.stack([p.genomes[-1] for p in met]), met[0].network)
        sides = {team: run.teams[team], other(team): champions}
        rates = tournament(
            run.settings.world, sides["pursuer"], sides["evader"], episodes=10, seed=key[1]
        ).capture_rate
        own = rates if team == "pursuer" else 1 - rates.T
        found[team] = own.mean(axis=1).tolist()
    return found


def responses_of(
    runs: Mapping[str, SavedRun], budgets: Sequence[int], root: Path
) -> dict[str, Row]:
    """Return exact scores of learned responses to the champions of races: team -> budget -> score.

    `met` is the score of the champion's last opponent, `best` that of a best response.
    """
    found: dict[str, Row] = {name: {} for name in runs}
    for team in TEAMS:
        for budget in budgets:
            where = root / f"responses-to-{team}s-{budget}"
            learner = RaceSettings.of(
                {"learner.population": 48, **SMALL_STEPS[other(team)]}
            ).learner
            responses = best_responses(runs, team, budget, where, learner=learner, threads=1)
            for name, each in responses.items():
                states = states_of(runs[name].settings.world)
                teams = {t: runs[name].last(t) for t in TEAMS}
                learned = mw.coevolution.open_run(each.directory).last(other(team))
                row = found[name].setdefault(team, {"met": exact(states, teams, team)})
                row[str(budget)] = exact(states, teams | {other(team): learned}, team)
    return found


def exact(states: States, teams: Mapping[Team, mw.Population], champion: Team) -> float:
    """Return the exact score of a champion's opponent."""
    captured = expected_payoff(states, teams["pursuer"], teams["evader"])
    return captured if champion == "evader" else 1 - captured


def numbers_of_all(
    runs: Mapping[tuple[str, int], SavedRun], root: Path, budgets: Sequence[int]
) -> list[Row]:
    """Return the numbers of all races; those that need no other race are kept beside the runs."""
    found = []
    for (schedule, seed), run in tqdm(runs.items(), unit=" races", disable=None):
        file = root / "numbers" / f"{schedule}-{seed}.json"
        row = {"schedule": schedule, "seed": seed, **kept(file, partial(numbers_of, run))}
        for team, scores in against_others(runs, (schedule, seed)).items():
            row["measures"][team]["others"] = scores
        found.append(row)
    rows = [row for row in found if budgets and row["schedule"] == RESPONSES_TO]
    champions = {f"seed-{row['seed']}": runs[RESPONSES_TO, row["seed"]] for row in rows}
    learned = responses_of(champions, budgets, root / "responses") if rows else {}
    for row, each in zip(rows, learned.values(), strict=True):
        row["responses"] = each
        for team in TEAMS:
            # Of the last generation only; as of the other measures, higher is better.
            row["measures"][team]["response"] = [1 - each[team][str(budgets[-1])]]
    return found


def rounded(value: Any) -> Any:
    """Return numbers inside lists and mappings with four digits."""
    if isinstance(value, dict):
        return {key: rounded(each) for key, each in value.items()}
    if isinstance(value, list):
        return [rounded(each) for each in value]
    return round(value, 4) if isinstance(value, float) else value


# ---- Which measure tells the truth? --------------------------------------------------------------


def linear_change(scores: Sequence[float]) -> float:
    """Return the least-squares slope of scores, times the length."""
    return float(np.polyfit(np.arange(len(scores)), scores, 1)[0] * (len(scores) - 1))


def correlation(one: Sequence[float], other: Sequence[float]) -> float:
    """Return Spearman's correlation; nan if one of both is constant."""
    if np.ptp(one) < 1e-9 or np.ptp(other) < 1e-9:
        return float("nan")
    return float(stats.spearmanr(one, other).statistic)


def within_races(rows: Sequence[Row], team: Team, measure: str) -> analysis.Estimate | None:
    """Return how well a measure orders the generations of the races in which these differ."""
    by_seed: dict[int, list[float]] = {}
    for row in rows:
        said = row["measures"][team].get(measure, ())
        if len(said) == len(row["truth"][team]):
            by_seed.setdefault(row["seed"], []).append(correlation(said, row["truth"][team]))
    means = [np.nanmean(each) for each in by_seed.values() if not np.isnan(each).all()]
    return analysis.interval_over_runs(means, bounds=(-1.0, 1.0)) if len(means) > 1 else None


def between_races(
    rows: Sequence[Row], team: Team, measure: str, number: Any
) -> analysis.Estimate | None:
    """Return how well a number of a measure orders races by the same number of the truth."""
    pairs = [
        (row["seed"], number(row["measures"][team][measure]), number(row["truth"][team]))
        for row in rows
        if measure in row["measures"][team]
        and (number is last_of or len(row["measures"][team][measure]) > 1)
    ]
    seeds = sorted({seed for seed, _, _ in pairs})
    if len(seeds) < 3:
        return None

    def of(kept: Iterable[int]) -> float:
        inside = set(kept)
        said, true = zip(*[(m, t) for seed, m, t in pairs if seed in inside], strict=True)
        return correlation(said, true)

    n, whole = len(seeds), of(seeds)
    without = np.array([of(each for each in seeds if each != seed) for seed in seeds])
    # Pseudo-values of the jackknife (Tukey 1958).
    estimate = analysis.interval_over_runs(n * whole - (n - 1) * without)
    if estimate.low is None or estimate.high is None:
        return replace(estimate, value=whole)
    half = (estimate.high - estimate.low) / 2
    return replace(estimate, value=whole, low=max(whole - half, -1.0), high=min(whole + half, 1.0))


def last_of(scores: Sequence[float]) -> float:
    """Return the score of the last generation."""
    return scores[-1]


def table_of_measures(rows: Sequence[Row]) -> str:
    """Return the correlations of all measures with the truth."""
    heads = ["score against"]
    heads += [f"{q}: {t}s" for q in ("generations", "champions", "changes") for t in TEAMS]
    cells = []
    known = {name for row in rows for team in TEAMS for name in row["measures"][team]}
    for measure, label in MEASURES.items():
        if measure not in known:
            continue
        found = [within_races(rows, team, measure) for team in TEAMS]
        found += [between_races(rows, team, measure, last_of) for team in TEAMS]
        found += [between_races(rows, team, measure, linear_change) for team in TEAMS]
        cells.append([label, *("-" if each is None else written(each, 2) for each in found)])
    return table(heads, cells)


def table_of_truth(rows: Sequence[Row]) -> str:
    """Return where the teams of each schedule begin and end, and the NashConv of the last pair."""
    heads = ["schedule", *(f"{team}s: {when}" for team in TEAMS for when in ("first", "last"))]
    cells = []
    for schedule, several in by_schedule(rows).items():
        ends = [[row["truth"][team][when] for row in several] for team in TEAMS for when in (0, -1)]
        conv = [1 - sum(row["truth"][team][-1] for team in TEAMS) for row in several]
        cells.append([schedule, *(mean(each, bounds=(0.0, 1.0)) for each in (*ends, conv))])
    return table([*heads, "NashConv: last"], cells)


def by_schedule(rows: Sequence[Row]) -> dict[str, list[Row]]:
    """Return the races of each schedule."""
    names = dict.fromkeys(row["schedule"] for row in rows)
    return {name: [row for row in rows if row["schedule"] == name] for name in names}


def table_of_responses(rows: Sequence[Row]) -> str:
    """Return how much of the gain of a best response the learned ones find, by matches."""
    learned = [row for row in rows if "responses" in row]
    budgets = [key for key in learned[0]["responses"]["pursuer"] if key != "met"]
    cells = []
    for budget in budgets:
        line = [f"{int(budget):,}"]
        for team in TEAMS:
            gains, best = np.array([gains_of(row, team, budget) for row in learned]).T
            line += [mean(gains, 2), mean(gains / best, 2)]
        cells.append(line)
    heads = [f"{team}s: {what}" for team in TEAMS for what in ("gain", "share of the true gain")]
    return table(["matches", *heads], cells)


def gains_of(row: Row, team: Team, budget: str) -> tuple[float, float]:
    """Return what a learned response gains over the champion's last opponent, and the best one."""
    found = row["responses"][team]
    return found[budget] - found["met"], 1 - row["truth"][team][-1] - found["met"]


# ---- The judgement -------------------------------------------------------------------------------


def truths_of(row: Row, window: str) -> dict[str, tuple[bool | None, float]]:
    """Return what is true of a window of a race, by the thresholds above, and sizes."""
    n = len(row["truth"]["pursuer"])
    span = slice(*(int(share * n) for share in WINDOWS[window]))
    changes = [linear_change(row["truth"][team][span]) for team in TEAMS]
    rises = [True if c >= RISES else False if c <= STAYS else None for c in changes]
    known = None not in rises
    most = max(map(abs, changes))
    return {
        "arms race": (False if False in rises else True if known else None, min(changes)),
        "one-sided progress": (rises[0] is not rises[1] if known else None, max(changes)),
        "rise": (True if True in rises else False if known else None, max(changes)),
        "stagnation": (True if most <= STAYS else False if most >= RISES else None, most),
    }


def judgements_of(rows: Sequence[Row]) -> list[Row]:
    """Return verdicts and truths in the form of `judgement_errors.judged`."""
    return [
        {
            "source": HERE,
            "kind": row["schedule"],
            "seed": row["seed"],
            "found": [
                [window, name, holds, size, row["verdicts"][window][name]]
                for window in WINDOWS
                if window in row["verdicts"]
                for name, (holds, size) in truths_of(row, window).items()
            ],
        }
        for row in rows
    ]


HERE = "races of the small world"
OTHERS = ("held back", "toy game", "real race")


def table_of_errors(rows: Sequence[Row], toys: Path) -> str:
    """Return the errors of the judgement here, beside those of synthetic races and toys."""
    counts = count_verdicts(judgements_of(rows)) + read_counts(toys / "counts.csv")
    cells = [
        [name, sample, *errors_of(counts, condition=name, sample=sample)]
        for name in ("arms race", "one-sided progress", "rise", "stagnation")
        for sample in (HERE, *OTHERS)
    ]
    return table(("condition", "sample", *RATE_HEADS), cells)


def table_of_changes(rows: Sequence[Row]) -> str:
    """Return true changes and gains of both teams by schedule."""
    cells = []
    for schedule, several in by_schedule(rows).items():
        line = [schedule]
        for team in TEAMS:
            gains = [linear_change(row["measures"][team]["all"]) for row in several]
            guarantees = [linear_change(row["truth"][team]) for row in several]
            line += [mean(each, 3, "+") for each in (gains, guarantees)]
        said = [row["verdicts"]["whole"]["arms race"] for row in several]
        line.append(f"{said.count('present')} of {len(said)}")
        cells.append(line)
    heads = [f"{team}s: {what}" for team in TEAMS for what in ("gain", "guarantee")]
    return table(["schedule", *heads, "arms race present"], cells)


# ---- Files ---------------------------------------------------------------------------------------


def report(rows: Sequence[Row], toys: Path) -> str:
    """Return all tables."""
    seeds = len({row["seed"] for row in rows})
    parts = [
        "# Which measure tells the truth?",
        f"{len(rows)} races of {seeds} seeds; perfect play captures {rows[0]['value']:.3f}. "
        "Definitions: the docstring of `evolution/validation/ground_truth.py`. In brackets: 95 % "
        "intervals over seeds.",
        "## What the teams guarantee",
        table_of_truth(rows),
        "## Correlations with the truth",
        table_of_measures(rows),
        "## Changes over a race",
        table_of_changes(rows),
        "## Errors of the judgement",
        table_of_errors(rows, toys),
    ]
    if any("responses" in row for row in rows):
        parts += [
            "## Learned responses to the last generations",
            f"Champions: those of {RESPONSES_TO}. Gain: exact score of the response minus that of "
            "the champion's last opponent.",
            table_of_responses(rows),
        ]
    return "\n\n".join(parts) + "\n"


def draw(rows: Sequence[Row], file: Path) -> None:
    """Draw the truth beside two measures, by generation: means and intervals over seeds."""
    import matplotlib

    matplotlib.use("Agg")
    from matplotlib import pyplot as plt

    panels = {"all": "Score in the race", "held_out": "Held-out score", "truth": "Guaranteed score"}
    figure, axes = plt.subplots(2, 3, figsize=(11, 6), sharex=True, layout="constrained")
    for team, line in zip(TEAMS, axes, strict=True):
        for (name, title), axis in zip(panels.items(), line, strict=True):
            for schedule, several in by_schedule(rows).items():
                of = [(r["truth"] if name == "truth" else r["measures"][team]) for r in several]
                curves = np.array([each[team if name == "truth" else name] for each in of])
                ends = [analysis.interval_over_runs(each, bounds=(0.0, 1.0)) for each in curves.T]
                middle = curves.mean(axis=0)
                low = [m if e.low is None else e.low for m, e in zip(middle, ends, strict=True)]
                high = [m if e.high is None else e.high for m, e in zip(middle, ends, strict=True)]
                at = np.arange(len(middle))
                [drawn] = axis.plot(at, middle, label=schedule)
                axis.fill_between(at, low, high, color=drawn.get_color(), alpha=0.2)
            axis.set_title(title if team == "pursuer" else "")
        line[0].set_ylabel(f"{team}s")
        value = rows[0]["value"] if team == "pursuer" else 1 - rows[0]["value"]
        line[2].text(0.03, 0.95, f"perfect play: {value:.2f}", transform=line[2].transAxes,
                     ha="left", va="top")  # fmt: skip
    for axis in axes[1]:
        axis.set_xlabel("generation")
    figure.legend(*axes[0, 0].get_legend_handles_labels(), ncols=5, loc="outside lower center")
    figure.savefig(file, dpi=90)
    plt.close(figure)


def main() -> None:
    """Play missing races, and write numbers, tables and the figure."""
    parser = script_parser(__doc__, quick="two seeds of tiny races")
    parser.add_argument("--schedules", nargs="+", choices=SCHEDULES, default=list(SCHEDULES))
    parser.add_argument("--seeds", type=int, help="races of each schedule; default 10, or 2")
    parser.add_argument("--responses", action="store_true", help="learn responses, too")
    parser.add_argument("--runs", type=Path, default=Path("runs/ground_truth"))
    parser.add_argument("--results", type=Path, default=Path("ground_truth"))
    parser.add_argument("--threads", type=int, help="default: one for each core")
    args = parser.parse_args()
    # All schedules of a seed, then the next seed: an interrupted comparison is one of equals.
    keys = [
        (s, seed) for seed in range(args.seeds or (2 if args.quick else 10)) for s in args.schedules
    ]
    settings = {place(*key): settings_of(*key, args.quick) for key in keys}
    played = finish_all(settings, args.runs, threads=args.threads)
    runs = {key: played[place(*key)] for key in keys}
    budgets = BUDGETS[: 1 if args.quick else None] if args.responses else ()
    rows = rounded(numbers_of_all(runs, args.runs, budgets))
    args.results.mkdir(parents=True, exist_ok=True)
    lines = ",\n".join(map(json.dumps, rows))
    (args.results / "races.json").write_text(f"[{lines}]\n", encoding="utf-8")
    text = report(rows, Path(__file__).parents[1] / "results" / "judgement")
    (args.results / "measures.md").write_text(text, encoding="utf-8")
    draw(rows, args.results / "measures.png")
    print(text)
    print(f"Written: races.json, measures.md and measures.png in {args.results}")


if __name__ == "__main__":
    main()
