"""Diagnosis of a race: five conditions, each with verdict, confidence, evidence and advice."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike

from matrixworld.analysis.calibration import (
    ABSENT,
    CANNOT_TELL,
    CONDITIONS,
    PRESENT,
    STRENGTHS,
    SURE,
    Numbers,
    calibration,
    strength_interval,
)
from matrixworld.analysis.evidence import (
    FEWEST_EPISODES,
    SUPPORT,
    numbers_of_run,
    one_sided_share,
    supporting,
)
from matrixworld.analysis.findings import ADVICE, HIDDEN, LONGER, REASONS, Diagnosis, Finding
from matrixworld.analysis.intervals import FEW_RUNS, LEVEL, Estimate, interval_over_runs
from matrixworld.analysis.payoff import require
from matrixworld.analysis.sources import Payoffs, Source, read_payoffs
from matrixworld.analysis.summary import FEWEST_GENERATIONS

RESAMPLES = 100
"""Resamples of the episodes of a run: enough for intervals that are compared with a few wide
bins."""

Judgement = tuple[str, float, str]
"""Verdict, confidence and reason."""


def diagnose(
    source: Source,
    *,
    episodes: bool = False,
    team_phase_rates: ArrayLike | None = None,
    level: float = LEVEL,
    rng: int = 0,
) -> Diagnosis:
    """Diagnose a race from its payoffs.

    Parameters
    ----------
    source : array_like, path or list of paths
        Payoffs as an array of shape (n, m) or (runs, n, m), a ``.csv`` or ``.npz`` file, or a list
        of such files, one for each run; see `read_payoffs`.
    episodes : bool, optional
        Whether the last dimension of the array holds the episodes of each cell.
    team_phase_rates : array_like of float, shape (K, 2), optional
        Capture rates after both team phases of every generation, from a training log, if the matrix
        holds a part of the generations only. For a single run.
    level : float, optional
        Confidence level of the intervals, in (0, 1).
    rng : int, optional
        Seed of the bootstrap. The same seed gives the same diagnosis.

    Returns
    -------
    Diagnosis
        A finding for each condition.

    Raises
    ------
    ValueError
        If a shape, file, value or level is not as described.
    TypeError
        If an array does not hold numbers.
    FileNotFoundError
        If a file does not exist.

    Notes
    -----
    The conditions:

    - *arms race*: both teams keep improving. In the last half each team does better against earlier
      opponents than it did in their generation (`rises`); the smaller rise of the two decides.
    - *cycling*: the relation "beats" contains cycles. The share of checkerboards in the last half
      decides, with the margin of `MEASURES`.
    - *disengagement*: one team wins nearly all matches, so neither has anything to learn from. The
      share of the last half of the generations within `disengagements` decides.
    - *forgetting*: a team loses to opponents that its ancestors beat. Mean forgetting in the last
      half decides, of the team that forgets more; `held_out_forgetting` if the episodes are known,
      else `forgetting`.
    - *stagnation*: the race is neither disengaged nor cyclic, and later generations do no better
      than earlier ones: neither team rises or falls much.

    Several conditions may be present: a race that cycles forgets. A race that cycles does not
    stagnate. In a disengaged race no other condition can be judged.

    A verdict holds if at least 80 % of the calibration races with the same strength of evidence
    agree on it, for every strength within the interval; see `matrixworld.analysis.calibration`. The
    interval is over runs; for a single run over its episodes; and if these are not known, as wide
    as that of the calibration races. With fewer than five runs it is the range of the runs. Runs
    with opposite verdicts give no verdict. Otherwise the verdict is "cannot tell". The diagnosis of
    a single run is about that run, not about what its settings would give again.
    """
    require(0.0 < level < 1.0, "a level in (0, 1)", level)
    payoffs = read_payoffs(source, episodes=episodes)
    runs, n, m = payoffs.matrices.shape
    require(team_phase_rates is None or runs == 1, "team phases of a single run", f"{runs} runs")
    one_sided = None if team_phase_rates is None else one_sided_share(team_phase_rates)
    # The calibration races are longer; their counts say nothing about shorter ones.
    if min(n, m) < FEWEST_GENERATIONS:
        findings = _too_short(runs, min(n, m))
    else:
        findings = _Runs(payoffs, one_sided, level, rng).findings()
    return Diagnosis(runs, (n, m), findings, calibration().source)


class _Runs:
    """The runs of one diagnosis, with the numbers of each."""

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
        # Numbers of mean matrices contain the episode noise, so they have bins of their own.
        known = scores is not None and scores.shape[3] >= FEWEST_EPISODES
        self._bins = calibration().episodes if known else calibration().means

    def findings(self) -> tuple[Finding, ...]:
        """Return a finding for each condition, in the order of `CONDITIONS`."""
        every = range(len(self._numbers))
        single = [self._judge("disengagement", [self._numbers[run]])[0] for run in every]
        # A disengaged run says nothing about the other conditions.
        engaged = [run for run in every if single[run] != PRESENT]
        found: dict[str, Finding] = {}
        for name in CONDITIONS:
            judged = list(every) if name == "disengagement" else engaged
            # Cycling comes before stagnation in CONDITIONS, so its finding is known by then.
            found[name] = self._finding(name, judged, found.get("cycling"))
        return tuple(found[name] for name in CONDITIONS)

    def _finding(self, name: str, judged: Sequence[int], cycling: Finding | None) -> Finding:
        """Return the finding on a condition from the runs that can be judged."""
        numbers = [self._numbers[run] for run in judged]
        by_run = [CANNOT_TELL] * len(self._numbers)
        for run in judged:
            single = self._judge(name, [self._numbers[run]])
            if name == "stagnation" and cycling is not None:
                single = _unless_cycling(single, cycling.by_run[run], cycling.confidence)
            by_run[run] = single[0]
        # The mean over runs decides, not a vote of single verdicts.
        judgement = self._judge(name, numbers) if judged else (CANNOT_TELL, 0.0, HIDDEN)
        judgement = _agreed(judgement, by_run)
        if name == "stagnation" and cycling is not None:
            judgement = _unless_cycling(judgement, cycling.verdict, cycling.confidence)
        verdict, confidence, reason = judgement
        # If every run is disengaged, the evidence still shows the numbers of all.
        evidence = self._evidence(name, judged or range(len(self._numbers)))
        advice = ADVICE[name][verdict]
        return Finding(name, verdict, confidence, reason, evidence, tuple(by_run), advice)

    def _judge(self, name: str, runs: Sequence[Numbers]) -> Judgement:
        key = STRENGTHS[name]
        over_runs = {key: self._over([one[key] for one in runs])}
        slack = calibration().slack[name]
        verdict, confidence = self._bins[name].judge(strength_interval(name, over_runs, slack))
        return verdict, confidence, REASONS[verdict]

    def _evidence(self, name: str, judged: Sequence[int]) -> Numbers:
        keys = SUPPORT[name]
        runs = [self._numbers[run] | self._support[run] for run in judged]
        return {key: self._over([one[key] for one in runs]) for key in keys if key in runs[0]}

    def _over(self, values: Sequence[Estimate]) -> Estimate:
        """Return a single run's value, the mean and range of few runs, or mean and interval."""
        if len(values) == 1:
            return values[0]
        known = [one.value for one in values if math.isfinite(one.value)]
        if not known:
            return Estimate(math.nan, None, None, "nothing", 0, "not defined for any run")
        if len(known) < FEW_RUNS:
            # A bootstrap interval of so few runs is too narrow; their range is not.
            mean = float(np.mean(known))
            return Estimate(mean, min(known), max(known), "runs", len(known), "range of few runs")
        return interval_over_runs(known, level=self._level)


def _agreed(judgement: Judgement, by_run: Sequence[str]) -> Judgement:
    """Return "cannot tell" if too many of the single runs have the opposite verdict."""
    verdict = judgement[0]
    opposite = {PRESENT: ABSENT, ABSENT: PRESENT}.get(verdict)
    # Runs without a verdict are no argument against one.
    decided = [one for one in by_run if one != CANNOT_TELL]
    if opposite is not None and decided.count(opposite) > (1.0 - SURE) * len(decided):
        reason = (
            f"the verdicts on single runs disagree: present in {by_run.count(PRESENT)}, absent in "
            f"{by_run.count(ABSENT)} of {len(by_run)}"
        )
        return CANNOT_TELL, 0.0, reason
    return judgement


def _unless_cycling(judgement: Judgement, cycling: str, confidence: float) -> Judgement:
    """Return the judgement on stagnation, given the verdict on cycling and its confidence."""
    if cycling == PRESENT:
        return ABSENT, confidence, "the race cycles, so it does change"
    if cycling == CANNOT_TELL and judgement[0] == PRESENT:
        return CANNOT_TELL, 0.0, "there is no trend, but the race may cycle"
    return judgement


def _too_short(runs: int, generations: int) -> tuple[Finding, ...]:
    reason = f"it takes at least {FEWEST_GENERATIONS} generations and there are {generations}"
    return tuple(
        Finding(name, CANNOT_TELL, 0.0, reason, {}, (CANNOT_TELL,) * runs, LONGER)
        for name in CONDITIONS
    )
