"""How often is a diagnosis correct? A test on races in toy games, whose truth is known.

    python evolution/diagnosis_on_toys.py               40 seeds of each toy, some minutes
    python evolution/diagnosis_on_toys.py --quick       2 seeds of each toy, less than a minute
    python evolution/diagnosis_on_toys.py --calibrate   calibrate the diagnosis first

Method: `matrixworld.toys.labelled_races` describes the toys and how each race got its truth.
Calibration and test use different seeds. Each race is diagnosed from its episodes, and from its
payoff matrix only; five seeds of each toy are also diagnosed together. The calibration counts races
in bins of the strength of evidence and takes Laplace's rule of succession.

Look at false alarms and misses by condition, at the toys with wrong verdicts, and at the share of
correct verdicts by confidence. ``--results`` receives the tables and the counts behind them.
"""

from __future__ import annotations

import csv
import json
from collections import Counter
from collections.abc import Callable, Iterable, Sequence
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass
from functools import partial
from itertools import product
from pathlib import Path
from typing import TypeVar

import numpy as np
from matrixworld.analysis.calibration import ABSENT, CANNOT_TELL, PRESENT, Calibration, Numbers
from matrixworld.analysis.diagnosis import RESAMPLES
from tqdm import tqdm

from common import script_parser
from matrixworld import analysis, toys
from matrixworld.analysis import CONDITIONS
from matrixworld.analysis import calibration as calibrations
from matrixworld.analysis.evidence import numbers_of_run

FIRST_TEST_SEED = 1000  # calibration starts from seed 0
GROUP = 5
"""Number of seeds that are diagnosed together."""
EDGES = {
    "arms race": (0.0, 0.1, 0.2, 0.3),
    "cycling": (0.01, 0.03, 0.06, 0.1),
    "disengagement": (0.25, 0.5, 0.75),
    "forgetting": (0.02, 0.05, 0.1, 0.15, 0.2, 0.3),
    "stagnation": (0.05, 0.1, 0.15, 0.25),
}
"""Edges of the bins, in units of the number that decides each condition (`STRENGTHS`)."""
# Of the half widths: nine of ten calibration races have a narrower interval.
SLACK_QUANTILE = 0.9

Truth = dict[str, bool | None]
Result = TypeVar("Result")


# ---- Calibration ---------------------------------------------------------------------------------


@dataclass(frozen=True)
class Measured:
    """Numbers of a race whose truth is known.

    Parameters
    ----------
    truth : dict of str to bool or None
        Whether each condition is present; None: not known.
    episodes : dict of str to Estimate
        Numbers from its episodes.
    means : dict of str to Estimate
        Numbers from its payoff matrix only.
    """

    truth: Truth
    episodes: Numbers
    means: Numbers


def measure(name: str, seed: int) -> Measured:
    """Play a race and compute its numbers."""
    race = toys.labelled_race(name, seed)
    # As `diagnose` takes them: the same level and the same number of resamples.
    numbers = partial(
        numbers_of_run,
        race.scores.mean(axis=2),
        one_sided=None,
        level=0.95,
        resamples=RESAMPLES,
        rng=np.random.default_rng(0),
    )
    return Measured(race.truth, numbers(race.scores), numbers(None))


def counts_for(condition: str, truth: Truth) -> bool:
    """Return whether a race counts for a condition.

    As in `diagnose`, a disengaged race counts for disengagement only, and a race that cycles does
    not count for stagnation.
    """
    # Counting such races would calibrate cases that `diagnose` never judges.
    hidden = truth["disengagement"] and condition != "disengagement"
    moving = truth["cycling"] and condition == "stagnation"
    return truth[condition] is not None and not hidden and not moving


def calibrate(measured: Sequence[Measured], source: str) -> Calibration:
    """Count races by condition, strength of evidence and truth."""
    tables = {
        table: {
            condition: calibrations.tally(
                EDGES[condition],
                [
                    (calibrations.strength(condition, getattr(one, table)), one.truth[condition])
                    for one in measured
                    if counts_for(condition, one.truth)
                ],
            )
            for condition in CONDITIONS
        }
        for table in ("episodes", "means")
    }
    slack = {
        condition: round(
            float(np.quantile([half_width(condition, one) for one in measured], SLACK_QUANTILE)), 4
        )
        for condition in CONDITIONS
    }
    return Calibration(source, slack, tables["episodes"], tables["means"])


def half_width(condition: str, measured: Measured) -> float:
    """Return half the width of the interval over episodes of the deciding number."""
    one = measured.episodes[calibrations.STRENGTHS[condition]]
    return 0.0 if one.low is None or one.high is None else (one.high - one.low) / 2.0


# ---- Test ----------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Judged:
    """A verdict on one condition of a race, or of five races, whose truth is known.

    Parameters
    ----------
    toy : str
        Name of the toy.
    by : str
        Evidence: the episodes, the matrix, or five races.
    condition : str
        One of `CONDITIONS`.
    truth : bool
        Whether the condition is present.
    verdict : str
        Verdict of the diagnosis.
    confidence : float
        Confidence of the diagnosis.
    """

    toy: str
    by: str
    condition: str
    truth: bool
    verdict: str
    confidence: float

    @property
    def right(self) -> bool | None:
        """Whether the verdict is correct; None for "cannot tell"."""
        if self.verdict == CANNOT_TELL:
            return None
        return (self.verdict == PRESENT) == self.truth


BY_EPISODES, BY_MATRIX, FIVE = "one race, its episodes", "one race, its matrix", "five races"


def judge(name: str, seeds: Sequence[int]) -> list[Judged]:
    """Diagnose races one by one, and all of them together if there are `GROUP` of them."""
    races = [toys.labelled_race(name, seed) for seed in seeds]
    found: list[Judged] = []
    for race in races:
        by_episodes = analysis.diagnose(race.scores, episodes=True)
        found += compared(name, BY_EPISODES, race.truth, by_episodes)
        found += compared(name, BY_MATRIX, race.truth, analysis.diagnose(race.scores.mean(axis=2)))
    # The last group may be smaller if the number of seeds is no multiple of GROUP.
    if len(races) == GROUP:
        together = analysis.diagnose(np.array([race.scores for race in races]), episodes=True)
        found += compared(name, FIVE, shared_truth([race.truth for race in races]), together)
    return found


def shared_truth(truths: Sequence[Truth]) -> Truth:
    """Return the truth that all races share; None where they differ or one is not known."""
    return {
        name: truths[0][name] if len({truth[name] for truth in truths}) == 1 else None
        for name in CONDITIONS
    }


def compared(toy: str, by: str, truth: Truth, found: analysis.Diagnosis) -> list[Judged]:
    """Return the verdicts on conditions whose truth is known."""
    return [
        Judged(toy, by, one.name, known, one.verdict, one.confidence)
        for one in found.findings
        if (known := truth[one.name]) is not None
    ]


# ---- Tables --------------------------------------------------------------------------------------


def report(judged: Sequence[Judged], seeds: range, source: str) -> str:
    """Return all tables in Markdown."""
    return "\n".join(
        [
            f"# `diagnose` on toys, seeds {seeds[0]} to {seeds[-1]}",
            "",
            f"Calibrated on other seeds ({source}). A *judgement* is a verdict on one condition of "
            "one race. Conditions whose truth is not known (`matrixworld.toys.labelled_races`) are "
            "left out.",
            "",
            "## By condition",
            "",
            *by_condition(judged),
            "",
            'Hit: the verdict "present" is correct. False alarm: the verdict "present" is wrong.',
            "",
            f"## By toy ({BY_EPISODES})",
            "",
            *by_toy([one for one in judged if one.by == BY_EPISODES]),
            "",
            "## By confidence",
            "",
            *by_confidence(judged),
            "",
        ]
    )


def table(heads: Sequence[str], rows: Iterable[Sequence[object]]) -> list[str]:
    """Return the lines of a Markdown table."""
    lines = [heads, ["---"] * len(heads), *rows]
    return [f"| {' | '.join(map(str, line))} |" for line in lines]


def by_condition(judged: Sequence[Judged]) -> list[str]:
    """Return hit and false alarm rates of each condition and kind of evidence."""
    rows = []
    for condition, by in product(CONDITIONS, (BY_EPISODES, BY_MATRIX, FIVE)):
        of = [one for one in judged if (one.condition, one.by) == (condition, by)]
        row: list[object] = [condition, by]
        for truth in (True, False):
            known = [one for one in of if one.truth is truth]
            row += [
                len(known),
                *(rate(known, verdict) for verdict in (PRESENT, ABSENT, CANNOT_TELL)),
            ]
        rows.append(row)
    heads = (
        "condition", "by", "true", "hit", "missed", "cannot tell",
        "not true", "false alarm", "correctly absent", "cannot tell",
    )  # fmt: skip
    return table(heads, rows)


def rate(judged: Sequence[Judged], verdict: str) -> str:
    """Return the share of judgements with a verdict, as text."""
    return f"{sum(one.verdict == verdict for one in judged) / len(judged):.0%}" if judged else "-"


def by_toy(judged: Sequence[Judged]) -> list[str]:
    """Return the number of right and wrong judgements of each toy."""
    rows = []
    for toy in toys.RACES:
        of = [one for one in judged if one.toy == toy]
        true = Counter(one.condition for one in of if one.truth)
        races = max(Counter(one.condition for one in of).values(), default=0)
        known = ", ".join(f"{name} ({count})" for name, count in true.items()) or "none known"
        outcomes = Counter(one.right for one in of)
        missed = Counter(one.condition for one in of if one.right is False)
        errors = ", ".join(f"{name} ({count})" for name, count in missed.items()) or "-"
        counts = (outcomes[True], outcomes[False], outcomes[None])
        rows.append([toy, known, races, len(of), *counts, errors])
    heads = (
        "toy", "true (races)", "races", "judgements", "right", "wrong", "cannot tell", "errors",
    )  # fmt: skip
    return table(heads, rows)


def by_confidence(judged: Sequence[Judged]) -> list[str]:
    """Return the share of correct verdicts by confidence and kind of evidence."""
    rows = []
    for low, high in ((0.8, 0.9), (0.9, 0.95), (0.95, 1.0)):
        for by in (BY_EPISODES, BY_MATRIX, FIVE):
            of = [
                one
                for one in judged
                if one.by == by and low <= one.confidence < high and one.right is not None
            ]
            right = f"{sum(bool(one.right) for one in of) / len(of):.1%}" if of else "-"
            rows.append([f"{low:.2f} to {high:.2f}", by, len(of), right])
    return table(("confidence", "by", "verdicts", "right"), rows)


def counts(judged: Sequence[Judged]) -> list[tuple[object, ...]]:
    """Return a table with a header: number of verdicts by toy, evidence, condition and truth."""
    keys = [(one.toy, one.by, one.condition, one.truth, one.verdict) for one in judged]
    heads = ("toy", "by", "condition", "truth", "verdict", "count")
    return [heads, *((*key, count) for key, count in Counter(keys).items())]


def spread(
    work: Callable[..., Result], tasks: Sequence[tuple[object, ...]], processes: int
) -> list[Result]:
    """Return the results of all tasks, in order, computed by several processes."""
    # Tasks have seeds of their own, so the results do not depend on the number of processes.
    with ProcessPoolExecutor(processes) as pool:
        return list(tqdm(pool.map(work, *zip(*tasks, strict=True)), total=len(tasks), disable=None))


def main() -> None:
    """Calibrate if requested, diagnose the test races, print and write the tables."""
    parser = script_parser(__doc__, quick="2 seeds of each toy")
    parser.add_argument("--seeds", type=int, help="of each toy; default 40, or 2 with --quick")
    parser.add_argument("--calibrate", action="store_true", help="write a new calibration.json")
    parser.add_argument("--results", type=Path, default=Path("diagnosis"))
    parser.add_argument("--processes", type=int, default=1)
    args = parser.parse_args()
    count = args.seeds or (2 if args.quick else 40)
    if args.calibrate:
        tasks = list(product(toys.RACES, range(count)))
        made = calibrate(
            spread(measure, tasks, args.processes), f"seeds 0 to {count - 1} of each toy"
        )
        # In the package itself: the diagnosis reads it from there.
        target = Path(calibrations.__file__).with_suffix(".json")
        target.write_text(json.dumps(made.to_json(), indent=1) + "\n", encoding="utf-8")
        calibrations.calibration.cache_clear()  # the test below uses the new file
        print(f"Written: {target}")
    seeds = range(FIRST_TEST_SEED, FIRST_TEST_SEED + count)
    # A group is one task, since its races are diagnosed alone and together.
    groups = [seeds[first : first + GROUP] for first in range(0, count, GROUP)]
    found = spread(judge, list(product(toys.RACES, groups)), args.processes)
    judged = [one for group in found for one in group]
    text = report(judged, seeds, calibrations.calibration().source)
    print(text)
    args.results.mkdir(parents=True, exist_ok=True)
    (args.results / "hit_rates.md").write_text(text, encoding="utf-8")
    with (args.results / "hit_rates.csv").open("w", newline="", encoding="utf-8") as file:
        csv.writer(file, lineterminator="\n").writerows(counts(judged))
    print(f"Written: {args.results}/hit_rates.md, {args.results}/hit_rates.csv")


if __name__ == "__main__":
    main()
