"""The judgement of a race: which conditions are present, in which part of it, and how surely.

All commands, figures and pages take their verdicts from `judge`.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from matrixworld.analysis.engagement import PURSUERS_WIN
from matrixworld.analysis.evidence import (
    CHECKERBOARDS,
    CYCLIC,
    EVADER_CHANGE,
    EVADER_GAIN,
    EVADERS_FORGET,
    FEWEST_EPISODES,
    FEWEST_GENERATIONS,
    ONE_SIDEDNESS,
    PURSUER_CHANGE,
    PURSUER_GAIN,
    PURSUERS_FORGET,
    RunEvidence,
    Window,
    estimates_of,
    windows_of,
)
from matrixworld.analysis.intervals import LEVEL, Estimate
from matrixworld.analysis.payoff import require
from matrixworld.analysis.plain_values import plain_values
from matrixworld.analysis.sources import Payoffs, Source, read_payoffs

PRESENT, ABSENT, CANNOT_TELL = "present", "absent", "cannot tell"
CONDITIONS = (
    "disengagement", "arms race", "one-sided progress", "cycling", "forgetting", "stagnation",
)  # fmt: skip
"""Names of the conditions, in the order in which they are judged."""

LEAST_GAIN = 0.05
"""Stagnation: both teams' strengths change by less than this over the window."""
LEAST_AMPLITUDE = 0.05
"""Cycling: capture rates deviate from every order of strength by more than this (root mean
square)."""
LEAST_CHECKERBOARDS = 0.01
"""Cycling: at least this share of checkerboards, so that generations beat each other in a circle
and do not only forget."""
LEAST_FORGETTING = 0.05
"""Forgetting: mean drop below the best ancestors above this."""

HIDDEN = "one team wins nearly all matches, which hides this condition"
NO_EPISODES = (
    f"it takes the number of episodes of each pair, at least {FEWEST_EPISODES}, to tell it from "
    "noise"
)
NO_SINGLE_EPISODES = (
    f"it takes the single episodes of each pair, at least {FEWEST_EPISODES}, to tell it from noise"
)
TOO_SHORT = f"it takes at least {FEWEST_GENERATIONS} generations of each team"
ALL_DISENGAGED = "fewer than two of the runs are engaged, and the others hide this condition"

Estimates = Mapping[str, Estimate]
Verdict = tuple[str, str]
"""Verdict and its reason, as a clause after "because"."""


@dataclass(frozen=True)
class Finding:
    """Verdict on one condition in one window.

    Parameters
    ----------
    condition : str
        One of `CONDITIONS`.
    verdict : str
        ``"present"``, ``"absent"`` or ``"cannot tell"``.
    reason : str
        Reason of the verdict, as a clause after "because".
    estimates : mapping of str to Estimate
        The numbers that decide, by name.
    by_run : tuple of str
        Verdict on each single run.
    """

    condition: str
    verdict: str
    reason: str
    estimates: Estimates
    by_run: tuple[str, ...]


@dataclass(frozen=True)
class WindowJudgement:
    """Findings on one part of a race.

    Parameters
    ----------
    window : Window
        The part.
    gains : mapping of str to Estimate
        Change of the strength of the ``"pursuer"`` and of the ``"evader"`` team over the window, in
        mean payoff against all opponents of the race; empty if the window is too short.
    findings : mapping of str to Finding
        By condition.
    """

    window: Window
    gains: Estimates
    findings: Mapping[str, Finding]

    def __getitem__(self, condition: str) -> Finding:
        return self.findings[condition]

    @property
    def present(self) -> tuple[str, ...]:
        """Conditions that are present."""
        return tuple(name for name in CONDITIONS if self.findings[name].verdict == PRESENT)


@dataclass(frozen=True)
class Judgement:
    """What happened in a race, or in several with the same settings.

    Parameters
    ----------
    runs : int
        Number of runs.
    shape : tuple of int
        Pursuer and evader generations of each run.
    episodes : int or None
        Episodes behind each cell; None if unknown.
    level : float
        Level of the intervals.
    windows : mapping of str to WindowJudgement
        Whole race, first half and last half.
    """

    runs: int
    shape: tuple[int, int]
    episodes: int | None
    level: float
    windows: Mapping[str, WindowJudgement]

    @property
    def window(self) -> str:
        """Name of the window that headlines speak of: the last half, of short races the whole."""
        late = self.windows["last half"].window
        return late.name if late.generations >= FEWEST_GENERATIONS else "whole"

    @property
    def headline(self) -> WindowJudgement:
        """The judgement of that window."""
        return self.windows[self.window]

    def to_json(self) -> dict[str, Any]:
        """Return plain values that JSON can represent."""
        plain: dict[str, Any] = plain_values(self)
        return plain


def judge(
    source: Source,
    *,
    per_episode: bool = False,
    episodes: int | None = None,
    level: float = LEVEL,
) -> Judgement:
    """Judge a race, or several with the same settings, from the payoffs of its generations.

    Parameters
    ----------
    source : array_like, path or list of paths
        Payoffs as an array of shape (n, m) or (runs, n, m), a ``.csv`` or ``.npz`` file, or a list
        of such files, one for each run; see `read_payoffs`.
    per_episode : bool, optional
        Whether the last dimension of the array holds the episodes of each cell.
    episodes : int, optional
        Number of episodes behind each cell of a matrix of means. Without it only the gains of the
        teams can be judged. Forgetting takes the single episodes.
    level : float, optional
        Level of the intervals, in (0, 1).

    Returns
    -------
    Judgement
        Findings on the whole race, its first half and its last half.

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
    The conditions, in a window of generations; every number has an interval (95 % by default):

    - *disengagement*: one team wins nearly all matches, so neither has anything to learn from. It
      gets more than 97 % of its payoff in half of the generations (`one_sidedness`). It hides all
      other conditions.
    - *arms race*: the strength of both teams increases: both lower ends of `strength_gain` are
      above 0. Absent if either team does not gain: its `strength_change` over the window is below
      .05 and not above 0.
    - *one-sided progress*: one team's strength increases, and the other one does not gain.
    - *cycling*: no order of strength explains the capture rates. They deviate from the nearest one
      by more than .05 after subtraction of the episode noise (`cyclic_amplitude`), and at least 1 %
      of the possible `checkerboards` exist, with the margin of `summarize`.
    - *forgetting*: a team falls more than .05 below the best of its ancestors, mean over
      generations and opponents (`mean_forgetting`).
    - *stagnation*: no team's strength changes by .05 or more over the window, and the race does not
      cycle. Both intervals of `strength_change` lie inside the margin: it takes evidence, not its
      absence.

    A verdict is "cannot tell" if an interval contains the margin. The interval of a single run is
    about this run: its episodes, and for gains the fluctuation between its generations. Several
    runs have Student's t interval over runs; a gain must also be a trend of the mean course. Runs
    that are disengaged are left out of the other conditions.

    How often verdicts are wrong: ``evolution/results/judgement`` of the repository.
    """
    payoffs = read_payoffs(source, per_episode=per_episode, episodes=episodes)
    return judge_payoffs(payoffs, level=level)


def judge_payoffs(payoffs: Payoffs, *, level: float = LEVEL) -> Judgement:
    """Judge payoffs that have been read; see `judge`."""
    require(0.0 < level < 1.0, "a level in (0, 1)", level)
    runs, n, m = payoffs.matrices.shape
    evidence = [RunEvidence(matrix, scores, payoffs.episodes, level) for matrix, scores in payoffs]
    windows = {window.name: _judge_window(window, evidence, level) for window in windows_of(n, m)}
    return Judgement(runs, (n, m), payoffs.episodes, level, windows)


def _judge_window(window: Window, runs: Sequence[RunEvidence], level: float) -> WindowJudgement:
    if window.generations < FEWEST_GENERATIONS:
        return WindowJudgement(window, {}, _unknown(TOO_SHORT, len(runs)))
    evidence = [run.of(window) for run in runs]
    singles = [_verdicts(estimates_of([one], level)) for one in evidence]
    engaged = [
        one
        for one, verdicts in zip(evidence, singles, strict=True)
        if verdicts["disengagement"][0] != PRESENT
    ]
    together = estimates_of(evidence, level)
    verdicts = _verdicts(together)
    # Disengagement is judged over all runs, the other conditions over the engaged ones.
    if verdicts["disengagement"][0] != PRESENT and len(engaged) < len(evidence):
        enough = len(engaged) >= 2
        others = estimates_of(engaged, level) if enough else together
        found = _verdicts(others) if enough else _all_but_disengagement(ALL_DISENGAGED)
        verdicts = {**found, "disengagement": verdicts["disengagement"]}
        together = {**others, **{key: together[key] for key in (ONE_SIDEDNESS,)}}
    gains = {"pursuer": together[PURSUER_GAIN], "evader": together[EVADER_GAIN]}
    findings = {
        name: Finding(
            name,
            *verdicts[name],
            {key: together[key] for key in DECIDING[name] if key in together},
            tuple(single[name][0] for single in singles),
        )
        for name in CONDITIONS
    }
    return WindowJudgement(window, gains, findings)


def _unknown(reason: str, runs: int) -> dict[str, Finding]:
    return {
        name: Finding(name, CANNOT_TELL, reason, {}, (CANNOT_TELL,) * runs) for name in CONDITIONS
    }


def _all_but_disengagement(reason: str) -> dict[str, Verdict]:
    return dict.fromkeys(CONDITIONS[1:], (CANNOT_TELL, reason))


# ---- The rules -----------------------------------------------------------------------------------

Known = Mapping[str, Verdict]
"""Verdicts on the conditions before this one."""


def _verdicts(estimates: Estimates) -> dict[str, Verdict]:
    """Return the verdict on each condition; later rules may use earlier verdicts."""
    verdicts: dict[str, Verdict] = {}
    for name in CONDITIONS:
        if any(key not in estimates for key in DECIDING[name]):
            verdicts[name] = CANNOT_TELL, NOT_KNOWN[name]
        elif name != "disengagement" and verdicts["disengagement"][0] == PRESENT:
            verdicts[name] = CANNOT_TELL, HIDDEN
        else:
            verdicts[name] = RULES[name](estimates, verdicts)
    return verdicts


def _against(estimate: Estimate, margin: float, above: str, below: str) -> Verdict:
    """Return present above the margin, absent below it, and "cannot tell" if it is inside."""
    low, high = _ends(estimate)
    if low > margin:
        return PRESENT, above
    if high < margin:
        return ABSENT, below
    return CANNOT_TELL, "the interval contains the margin"


def _ends(estimate: Estimate) -> tuple[float, float]:
    assert estimate.low is not None
    assert estimate.high is not None
    return estimate.low, estimate.high


def _disengagement(estimates: Estimates, known: Known) -> Verdict:
    return _against(
        estimates[ONE_SIDEDNESS],
        PURSUERS_WIN,
        f"one team gets more than {PURSUERS_WIN:.0%} of its payoff in half of the generations",
        f"neither team gets {PURSUERS_WIN:.0%} of its payoff in half of the generations",
    )


def _arms_race(estimates: Estimates, known: Known) -> Verdict:
    if all(low > 0.0 for low, _ in _gains(estimates)):
        return PRESENT, "both teams become stronger"
    if any(_does_not_gain(change) for change in _changes(estimates)):
        return ABSENT, f"a team does not gain: its change is not above 0, and below {LEAST_GAIN}"
    return CANNOT_TELL, "the gain of at least one team cannot be told from 0"


def _one_sided_progress(estimates: Estimates, known: Known) -> Verdict:
    gains, changes = _gains(estimates), _changes(estimates)
    if known["arms race"][0] == PRESENT:
        return ABSENT, "both teams become stronger"
    if all(_does_not_gain(change) for change in changes):
        return ABSENT, "neither team gains"
    for (low, _), other in zip(gains, changes[::-1], strict=True):
        if low > 0.0 and _does_not_gain(other):
            return PRESENT, "one team becomes stronger, and the other does not gain"
    return CANNOT_TELL, "the gain of at least one team is not known well enough"


def _does_not_gain(change: tuple[float, float]) -> bool:
    # A small gain that is told from 0 is no evidence of standstill.
    low, high = change
    return low <= 0.0 and high < LEAST_GAIN


def _gains(estimates: Estimates) -> list[tuple[float, float]]:
    return [_ends(estimates[key]) for key in (PURSUER_GAIN, EVADER_GAIN)]


def _changes(estimates: Estimates) -> list[tuple[float, float]]:
    return [_ends(estimates[key]) for key in (PURSUER_CHANGE, EVADER_CHANGE)]


def _cycling(estimates: Estimates, known: Known) -> Verdict:
    low, high = _ends(estimates[CYCLIC])
    if high < LEAST_AMPLITUDE**2:
        return ABSENT, "an order of strength and episode noise explain the capture rates"
    if low <= LEAST_AMPLITUDE**2:
        return CANNOT_TELL, "the interval contains the margin"
    if estimates[CHECKERBOARDS].value < LEAST_CHECKERBOARDS:
        return (
            CANNOT_TELL,
            "no order of strength explains the capture rates, but checkerboards are rare",
        )
    return PRESENT, "neither an order of strength nor episode noise explains the capture rates"


def _forgetting(estimates: Estimates, known: Known) -> Verdict:
    drops = [_ends(estimates[key]) for key in (PURSUERS_FORGET, EVADERS_FORGET)]
    if any(low > LEAST_FORGETTING for low, _ in drops):
        return PRESENT, f"a team falls more than {LEAST_FORGETTING} below its best ancestors"
    if all(high < LEAST_FORGETTING for _, high in drops):
        return ABSENT, f"neither team falls {LEAST_FORGETTING} below its best ancestors"
    return CANNOT_TELL, "the interval contains the margin"


def _stagnation(estimates: Estimates, known: Known) -> Verdict:
    changes = _changes(estimates)
    for name in ("arms race", "one-sided progress", "cycling"):
        if known[name][0] == PRESENT:
            return ABSENT, f"{name} is present"
    if any(low >= LEAST_GAIN or high <= -LEAST_GAIN for low, high in changes):
        return ABSENT, f"the strength of a team changes by {LEAST_GAIN} or more"
    if any(low <= -LEAST_GAIN or high >= LEAST_GAIN for low, high in changes):
        return CANNOT_TELL, f"a change of {LEAST_GAIN} cannot be ruled out"
    if known["cycling"][0] == CANNOT_TELL:
        return CANNOT_TELL, "neither team gains, but the race may cycle"
    return PRESENT, f"neither team's strength changes by {LEAST_GAIN}, and the race does not cycle"


RULES: Mapping[str, Callable[[Estimates, Known], Verdict]] = {
    "disengagement": _disengagement,
    "arms race": _arms_race,
    "one-sided progress": _one_sided_progress,
    "cycling": _cycling,
    "forgetting": _forgetting,
    "stagnation": _stagnation,
}
DECIDING: Mapping[str, tuple[str, ...]] = {
    "disengagement": (ONE_SIDEDNESS,),
    "arms race": (PURSUER_GAIN, EVADER_GAIN),
    "one-sided progress": (PURSUER_GAIN, EVADER_GAIN, PURSUER_CHANGE, EVADER_CHANGE),
    "cycling": (CYCLIC, CHECKERBOARDS),
    "forgetting": (PURSUERS_FORGET, EVADERS_FORGET),
    "stagnation": (PURSUER_CHANGE, EVADER_CHANGE),
}
"""The numbers that decide on each condition."""
NOT_KNOWN: Mapping[str, str] = {
    **dict.fromkeys(CONDITIONS, NO_EPISODES),
    "forgetting": NO_SINGLE_EPISODES,
}
"""Why the numbers of a condition are not known."""
