"""The judgement of a race: which conditions are present, in which part of it, and how surely.

All commands, figures and pages take their verdicts from `judge`.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from matrixworld._util.short_repr import short_repr
from matrixworld.analysis.evidence import (
    EVADER_GAIN,
    FEWEST_GENERATIONS,
    ONE_SIDEDNESS,
    PURSUER_GAIN,
    RunEvidence,
    Window,
    estimates_of,
    windows_of,
)
from matrixworld.analysis.intervals import LEVEL
from matrixworld.analysis.payoff import require
from matrixworld.analysis.plain_values import plain_values
from matrixworld.analysis.sources import Payoffs, Source, read_payoffs
from matrixworld.analysis.verdicts import (
    ALL_DISENGAGED,
    CANNOT_TELL,
    CONDITIONS,
    DECIDING,
    PRESENT,
    TOO_SHORT,
    Estimates,
    Verdict,
    verdicts_of,
)


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

    __repr__ = short_repr

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
    singles = [verdicts_of(estimates_of([one], level)) for one in evidence]
    engaged = [
        one
        for one, verdicts in zip(evidence, singles, strict=True)
        if verdicts["disengagement"][0] != PRESENT
    ]
    together = estimates_of(evidence, level)
    verdicts = verdicts_of(together)
    # Disengagement is judged over all runs, the other conditions over the engaged ones.
    if verdicts["disengagement"][0] != PRESENT and len(engaged) < len(evidence):
        enough = len(engaged) >= 2
        others = estimates_of(engaged, level) if enough else together
        found = verdicts_of(others) if enough else _all_but_disengagement(ALL_DISENGAGED)
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
