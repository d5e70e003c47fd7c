"""The rules that turn the numbers of a race into a verdict on each condition."""

from __future__ import annotations

from collections.abc import Callable, Mapping

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
)
from matrixworld.analysis.intervals import Estimate

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


Known = Mapping[str, Verdict]
"""Verdicts on the conditions before this one."""


def verdicts_of(estimates: Estimates) -> dict[str, Verdict]:
    """Return the verdict on each condition; later rules may use earlier verdicts.

    Parameters
    ----------
    estimates : mapping of str to Estimate
        Result of `estimates_of`: the numbers of a window, by name. Those that the payoffs cannot
        give are missing.

    Returns
    -------
    dict of str to (str, str)
        Verdict and reason by condition.
    """
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
