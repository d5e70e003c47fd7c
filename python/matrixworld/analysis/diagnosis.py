"""What is the matter with a race? Five conditions, each with evidence, confidence and advice."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from matrixworld.analysis.advice import ADVICE, HIDDEN, LONGER, REASONS, describe_finding
from matrixworld.analysis.bootstrap import FEW_RUNS, LEVEL, Estimate, bootstrap_runs
from matrixworld.analysis.calibration import (
    ABSENT,
    CANNOT_TELL,
    CONDITIONS,
    PRESENT,
    STRENGTHS,
    SURE,
    calibration,
    strengths,
)
from matrixworld.analysis.evidence import (
    FEWEST_EPISODES,
    SUPPORT,
    numbers_of_run,
    one_sided_share,
    supporting,
)
from matrixworld.analysis.payoff import require
from matrixworld.analysis.sources import Payoffs, Source, read_payoffs
from matrixworld.analysis.summary import FEWEST_GENERATIONS

RESAMPLES = 100
"""Of the episodes of a run: enough for intervals of what is put into a few wide bins."""

Numbers = dict[str, Estimate]
Judgement = tuple[str, float, str]
"""Verdict, confidence and reason."""


@dataclass(frozen=True)
class Finding:
    """One condition."""

    name: str
    """Of `CONDITIONS`."""
    verdict: str
    """``"present"``, ``"absent"`` or ``"cannot tell"``."""
    confidence: float
    """Share, in [0, 1], of the toy races of the same strength of evidence for which the verdict was
    true, the least over the interval; 0 for "cannot tell"."""
    reason: str
    """Why, as a clause to follow "because"."""
    evidence: Mapping[str, Estimate]
    """The numbers behind it by name, the deciding one first."""
    by_run: tuple[str, ...]
    """The verdict of each run by itself."""
    advice: str
    """What to try, in a sentence."""

    def __str__(self) -> str:
        return describe_finding(self)


@dataclass(frozen=True)
class Diagnosis:
    """What was found; `str` gives it in words, `to_json` as plain values."""

    runs: int
    generations: tuple[int, int]
    """Of the pursuers and of the evaders."""
    findings: tuple[Finding, ...]
    """One of each condition, in the order of `CONDITIONS`."""
    source: str
    """What the confidences were measured on."""

    def __getitem__(self, name: str) -> Finding:
        """The finding of that name. KeyError for another one."""
        return {finding.name: finding for finding in self.findings}[name]

    @property
    def present(self) -> tuple[str, ...]:
        """Names of the conditions that are present."""
        return tuple(finding.name for finding in self.findings if finding.verdict == PRESENT)

    def to_json(self) -> dict[str, Any]:
        """The same as plain values that JSON can hold: NaN as None."""
        findings = [
            asdict(finding)
            | {"evidence": {name: _plain(one) for name, one in finding.evidence.items()}}
            for finding in self.findings
        ]
        return {
            "runs": self.runs,
            "generations": list(self.generations),
            "source": self.source,
            "findings": [one | {"by_run": list(one["by_run"])} for one in findings],
        }

    def __str__(self) -> str:
        n, m = self.generations
        runs = "A single run" if self.runs == 1 else f"{self.runs} runs"
        return "\n".join(
            [
                f"{runs}, {n} pursuer and {m} evader generations: "
                f"{', '.join(self.present) or 'nothing that can be named'}.",
                *map(str, self.findings),
                f"Confidences are hit rates on toy races ({self.source}).",
            ]
        )


def diagnose(
    source: Source,
    *,
    episodes: bool = False,
    half_steps: ArrayLike | None = None,
    level: float = LEVEL,
    rng: int = 0,
) -> Diagnosis:
    """Name what happened in a race, as far as its payoffs tell.

    - *arms race*: both teams keep getting better. In the last half, each does better against the
      earlier generations of the other than in the current matches (`rises`); measured by the lesser
      of the two.
    - *cycling*: who beats whom goes round. Checkerboards above the margin of `MEASURES`, as share
      of the possible ones in the last half.
    - *disengagement*: one team wins everything, and neither has anything to learn from: the share
      of the last half of the generations within stretches of `disengagements`.
    - *forgetting*: a team loses to opponents that an ancestor of its beat: `forgetting`, mean over
      the last half, of the team that forgets more; chosen and measured in different episodes where
      they are known (`held_out_forgetting`).
    - *stagnation*: matches are open, nothing goes round, and later generations do no better than
      earlier ones: neither team rises, or falls, by much.

    Conditions may come together: a race that goes round forgets. Stagnation is not told of a race
    that cycles, and of a disengaged race nothing else can be told.

    source : payoffs as `analyze` takes them: an array ``(n, m)`` or ``(runs, n, m)``, a ``.csv`` or
        ``.npz`` file, or a list of such files, one a run.
    episodes : the last dimension of the array holds the episodes of each cell.
    half_steps : capture rates ``(K, 2)`` after both team phases of every generation, from a
        training log, where the matrix has a part of the generations only; of a single run.
    level : of the intervals.
    rng : seed of the bootstrap. The same seed gives the same diagnosis.

    A verdict is what at least 80 % of the toy races had in common whose evidence was as strong
    (`calibration`), for every strength within the interval. The interval is over runs; of a single
    run over its episodes; and of one whose episodes are not known as wide as those of the toys.
    With fewer than five runs it spans them all, and runs that say the opposite of each other give
    no verdict. "cannot tell" is the answer to all else. A single run tells of itself, not of what
    its settings would do again.

    Raises ValueError, saying what was expected and what came, for other shapes, files, values or
    levels; TypeError for arrays of other than numbers; FileNotFoundError.
    """
    require(0.0 < level < 1.0, "a level in (0, 1)", level)
    payoffs = read_payoffs(source, episodes=episodes)
    runs, n, m = payoffs.matrices.shape
    require(half_steps is None or runs == 1, "team phases of a single run", f"{runs} runs")
    one_sided = None if half_steps is None else one_sided_share(half_steps)
    if min(n, m) < FEWEST_GENERATIONS:
        findings = _too_short(runs, min(n, m))
    else:
        findings = _Runs(payoffs, one_sided, level, rng).findings()
    return Diagnosis(runs, (n, m), findings, calibration().source)


class _Runs:
    """The runs of one diagnosis, and all numbers of each."""

    def __init__(self, payoffs: Payoffs, one_sided: float | None, level: float, rng: int) -> None:
        generator = np.random.default_rng(rng)
        self._numbers = [
            numbers_of_run(
                matrix, scores, one_sided, level=level, resamples=RESAMPLES, rng=generator
            )
            for matrix, scores in payoffs
        ]
        self._support = [supporting(matrix, scores) for matrix, scores in payoffs]
        self._level, self._rng = level, rng
        scores = payoffs.scores
        self._known = scores is not None and scores.shape[3] >= FEWEST_EPISODES
        self._bins = calibration().episodes if self._known else calibration().means

    def findings(self) -> tuple[Finding, ...]:
        """In the order of `CONDITIONS`."""
        everyone = range(len(self._numbers))
        alone = [self._judge("disengagement", [self._numbers[run]])[0] for run in everyone]
        engaged = [run for run in everyone if alone[run] != PRESENT]
        found: dict[str, Finding] = {}
        for name in CONDITIONS:
            told = list(everyone) if name == "disengagement" else engaged
            found[name] = self._finding(name, told, found.get("cycling"))
        return tuple(found[name] for name in CONDITIONS)

    def _finding(self, name: str, told: Sequence[int], cycling: Finding | None) -> Finding:
        numbers = [self._numbers[run] for run in told]
        by_run = [CANNOT_TELL] * len(self._numbers)
        for run in told:
            alone = self._judge(name, [self._numbers[run]])
            if name == "stagnation" and cycling is not None:
                alone = _unless_cycling(alone, cycling.by_run[run], cycling.confidence)
            by_run[run] = alone[0]
        judgement = self._judge(name, numbers) if told else (CANNOT_TELL, 0.0, HIDDEN)
        judgement = _agreed(judgement, by_run)
        if name == "stagnation" and cycling is not None:
            judgement = _unless_cycling(judgement, cycling.verdict, cycling.confidence)
        verdict, confidence, reason = judgement
        evidence = self._evidence(name, told or range(len(self._numbers)))
        advice = ADVICE[name][verdict]
        return Finding(name, verdict, confidence, reason, evidence, tuple(by_run), advice)

    def _judge(self, name: str, runs: Sequence[Numbers]) -> Judgement:
        key = STRENGTHS[name]
        over_runs = {key: self._over([one[key] for one in runs])}
        slack = calibration().slack[name]
        verdict, confidence = self._bins[name].judge(strengths(name, over_runs, slack))
        return verdict, confidence, REASONS[verdict]

    def _evidence(self, name: str, told: Sequence[int]) -> dict[str, Estimate]:
        keys = SUPPORT[name]
        runs = [self._numbers[run] | self._support[run] for run in told]
        return {key: self._over([one[key] for one in runs]) for key in keys if key in runs[0]}

    def _over(self, values: Sequence[Estimate]) -> Estimate:
        """Of a single run as it is; of several their mean and interval, of a few their range."""
        if len(values) == 1:
            return values[0]
        known = [one.value for one in values if math.isfinite(one.value)]
        if not known:
            return Estimate(math.nan, None, None, "nothing", 0, "not defined for any run")
        if len(known) < FEW_RUNS:
            mean = float(np.mean(known))
            return Estimate(mean, min(known), max(known), "runs", len(known), "range of few runs")
        return bootstrap_runs(known, level=self._level, rng=self._rng)


def _agreed(judgement: Judgement, by_run: Sequence[str]) -> Judgement:
    """No verdict where too many of the runs that tell anything say the opposite."""
    verdict = judgement[0]
    opposite = {PRESENT: ABSENT, ABSENT: PRESENT}.get(verdict)
    telling = [one for one in by_run if one != CANNOT_TELL]
    if opposite is not None and telling.count(opposite) > (1.0 - SURE) * len(telling):
        return (
            CANNOT_TELL,
            0.0,
            (
                f"{by_run.count(PRESENT)} of {len(by_run)} runs have it by themselves and "
                f"{by_run.count(ABSENT)} have not"
            ),
        )
    return judgement


def _unless_cycling(judgement: Judgement, cycling: str, confidence: float) -> Judgement:
    """What is said of stagnation, given the verdict on cycling and how sure it is."""
    if cycling == PRESENT:
        return ABSENT, confidence, "it goes round, which is a change"
    if cycling == CANNOT_TELL and judgement[0] == PRESENT:
        return CANNOT_TELL, 0.0, "there is no trend, but it may go round"
    return judgement


def _too_short(runs: int, generations: int) -> tuple[Finding, ...]:
    reason = f"it takes at least {FEWEST_GENERATIONS} generations and there are {generations}"
    return tuple(
        Finding(name, CANNOT_TELL, 0.0, reason, {}, (CANNOT_TELL,) * runs, LONGER)
        for name in CONDITIONS
    )


def _plain(estimate: Estimate) -> dict[str, Any]:
    return {
        key: None if isinstance(value, float) and not math.isfinite(value) else value
        for key, value in asdict(estimate).items()
    }
