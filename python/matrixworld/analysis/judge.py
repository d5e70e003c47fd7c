"""The judgement of a race: which conditions are present, in which part of it, and how surely.

All commands, figures and pages take their verdicts from `judge`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import replace
from typing import NamedTuple

from matrixworld.analysis.intervals import LEVEL, RUNS_FOR_T, Estimate, check_level
from matrixworld.analysis.judgement import (
    ABSENT,
    CANNOT_TELL,
    CONDITIONS,
    PRESENT,
    Estimates,
    Finding,
    Findings,
    Judgement,
)
from matrixworld.analysis.measures import (
    FALLS_BACK,
    MEASURES,
    NO_EPISODES,
    NOT_SUSTAINED,
    TOO_SHORT,
)
from matrixworld.analysis.payoffs import (
    GENERATIONS_TO_JUDGE,
    TEAMS,
    Payoffs,
    Source,
    Window,
    read_payoffs,
)
from matrixworld.analysis.progress import PURSUERS_WIN

LEAST_GAIN = 0.05
"""Rise and stagnation: strength changes by more, or by less, than this over the window."""
LEAST_INTRANSITIVITY = 0.05
"""Intransitivity: capture rates deviate from every order of strength by more than this (root mean
square)."""
LEAST_CHECKERBOARDS = 0.01
"""Intransitivity: at least this share of checkerboards, so that generations beat each other in a
circle and do not only forget."""
LEAST_RECURRENCE = 0.15
"""Cycling: a team becomes this similar to its past again. New styles in each generation are similar
by .03 to .12, by chance."""
LEAST_FORGETTING = 0.05  # Forgetting: mean drop below the best ancestors above this

CLOSE = 0.2  # capture rates so close to 1 or 0 over a window say which team wins nearly all matches

HIDDEN = "one team wins nearly all matches, which hides this condition"
NO_SINGLE_EPISODES = NO_EPISODES.replace("number of episodes", "single episodes")
ONE_HALF = "what rises in this half does not rise in the same way over the whole race"
CIRCLE = "both teams lose again what they gain, as in a circle, whose end is not seen"
FEW_ENGAGED = f"fewer than {RUNS_FOR_T} of the runs are engaged, the others hide this condition"


def judge(
    source: Source, *, per_episode: bool = False, episodes: int | None = None, level: float = LEVEL
) -> Judgement:
    """Judge a race, or several with the same settings, from the payoffs of its generations.

    Parameters
    ----------
    source : array_like, path, list of paths or Payoffs
        As in `read_payoffs`. Episodes of a pair are independent; pairs may share their worlds.
    per_episode : bool, optional
        Whether the last axis of an array holds the episodes of each cell. The default is False.
    episodes : int, optional
        How many episodes are behind each cell of a matrix of means. Without it only the gains of
        the teams can be judged, and forgetting takes the single episodes.
    level : float, optional
        Level of the intervals, in (0, 1). The default is 0.95.

    Returns
    -------
    Judgement
        A verdict on each condition in the whole race and in its halves.

    Notes
    -----
    A verdict is "cannot tell" if an interval contains the margin. The interval of a single run is
    about this run: its episodes, and for gains the fluctuation between its generations. Of 2 or 3
    runs each has to show what is present. More have Student's t interval over runs; a gain must
    also be a trend of the mean course, and remain without one jump of each run. "Rise" says that a
    team became stronger in what was played; "arms race" and "one-sided progress" say that no random
    walk explains it. Runs that are disengaged are left out of the other conditions.
    docs/analysis.md defines the conditions; evolution/results/judgement has how often verdicts are
    wrong.
    """
    payoffs = read_payoffs(source, per_episode=per_episode, episodes=episodes)
    check_level(level)
    windows: dict[str, Findings] = {}
    for name, window in payoffs.windows.items():
        found = _judge_window(payoffs, window, level)
        windows[name] = _as_sure(found, windows["whole"]) if windows else found
    return Judgement(
        len(payoffs), payoffs.shape, payoffs.episodes, level, windows, payoffs.teams, payoffs.exact
    )


def _judge_window(payoffs: Payoffs, window: Window, level: float) -> Findings:
    by_run = [_findings(run, window, level) for run in payoffs.runs]
    found = _findings(payoffs, window, level) if len(payoffs) > 1 else by_run[0]
    # Disengagement is judged over all runs, the other conditions over the engaged ones.
    engaged = [run for run, each in enumerate(by_run) if not _is_one_sided(each)]
    if not _is_one_sided(found) and len(engaged) < len(by_run):
        if len(engaged) >= RUNS_FOR_T:
            others = _findings(payoffs.select(engaged), window, level)
        else:
            others = {
                name: replace(each, verdict=CANNOT_TELL, reason=FEW_ENGAGED, teams=())
                for name, each in found.items()
            }
        found = {**others, "disengagement": found["disengagement"]}
    return {
        name: replace(found[name], by_run=tuple(one[name].verdict for one in by_run))
        for name in CONDITIONS
    }


def _findings(payoffs: Payoffs, window: Window, level: float) -> Findings:
    """Return the verdict on each condition; later rules may use earlier verdicts."""
    found: dict[str, Finding] = {}
    for name, condition in RULES.items():
        too_short = window.generations < GENERATIONS_TO_JUDGE
        missing = TOO_SHORT if too_short else condition.missing(payoffs)
        if missing:
            found[name] = Finding(CANNOT_TELL, missing)
            continue
        estimates = {
            key: MEASURES[key].estimate(payoffs, window, level) for key in condition.measures
        }
        hidden = name != "disengagement" and _is_one_sided(found)
        decided = Finding(CANNOT_TELL, HIDDEN) if hidden else condition.rule(estimates, found)
        found[name] = replace(decided, estimates=estimates)
    return found


def _is_one_sided(findings: Findings) -> bool:
    """Return whether one team won nearly all matches, be they enough for a verdict or not."""
    known = findings["disengagement"].estimates.get("one_sidedness")
    return known is not None and known.value > PURSUERS_WIN


def _as_sure(half: Findings, whole: Findings) -> Findings:
    """Return the findings on a half, which shows no progress that the whole race speaks against.

    Any smooth curve rises in some half, and any circle does: both teams have to have risen over the
    whole race, too, without circles; or the same is present there.
    """
    circles = whole["intransitivity"].verdict == PRESENT
    both_rose = len(whole["rise"].teams) == 2 and not circles
    found = dict(half)
    for name, known in (("arms race", both_rose), ("one-sided progress", False)):
        if half[name].verdict == PRESENT != whole[name].verdict and not known:
            found[name] = replace(half[name], verdict=CANNOT_TELL, reason=ONE_HALF, teams=())
    return found


def _against(estimate: Estimate, margin: float, above: str, below: str) -> Finding:
    """Return present above the margin, absent below it, and "cannot tell" if it is inside."""
    low, high = estimate.ends
    if low > margin:
        return Finding(PRESENT, above)
    if high < margin:
        return Finding(ABSENT, below)
    return Finding(CANNOT_TELL, "the interval contains the margin")


def _against_all(estimates: Estimates, keys: tuple[str, ...], margin: float, below: str) -> Finding:
    """Return absent if the numbers of both teams are below the margin, else "cannot tell"."""
    if all(high < margin for _, high in _ends(estimates, *keys)):
        return Finding(ABSENT, below.format(margin))
    return Finding(CANNOT_TELL, "the interval contains the margin")


def _disengagement(estimates: Estimates, known: Findings) -> Finding:
    found = _against(
        estimates["one_sidedness"],
        PURSUERS_WIN,
        f"one team gets more than {PURSUERS_WIN:.0%} of its payoff in half of the generations",
        f"neither team gets {PURSUERS_WIN:.0%} of its payoff in half of the generations",
    )
    rate, winners = estimates["capture_rate"].value, dict(zip(TEAMS, (1.0, 0.0), strict=True))
    teams = tuple(team for team, all_won in winners.items() if abs(rate - all_won) < CLOSE)
    return replace(found, teams=teams if found.verdict == PRESENT else ())


def _arms_race(estimates: Estimates, known: Findings) -> Finding:
    gains = _ends(estimates, *GAINS)
    if all(low > 0.0 for low, _ in gains):
        if _may_be_a_circle(estimates, known):
            return Finding(CANNOT_TELL, CIRCLE)
        reason = "both teams rise by more than a random walk with such steps would"
        return Finding(PRESENT, reason, _teams(GAINS))
    if any(_does_not_gain(gain) for gain in gains):
        reason = f"a team has no trend: its gain is not above 0, and below {LEAST_GAIN}"
        return Finding(ABSENT, reason)
    return Finding(CANNOT_TELL, "a random walk may explain the gain of at least one team")


def _one_sided_progress(estimates: Estimates, known: Findings) -> Finding:
    gains = _ends(estimates, *GAINS)
    if known["arms race"].verdict == PRESENT:
        return Finding(ABSENT, "both teams have a trend")
    if all(_does_not_gain(gain) for gain in gains):
        return Finding(ABSENT, "neither team has a trend")
    for key, other in zip(GAINS, GAINS[::-1], strict=True):
        still = _does_not_gain(estimates[other].ends) and estimates[other].value > -LEAST_GAIN
        if estimates[key].ends[0] > 0.0 and still:
            if _may_be_a_circle(estimates, known):
                return Finding(CANNOT_TELL, CIRCLE)
            reason = "one team rises by more than a random walk would, the other stands still"
            return Finding(PRESENT, reason, _teams([key]))
    return Finding(CANNOT_TELL, "a random walk may explain the gain of at least one team")


def _may_be_a_circle(estimates: Estimates, known: Findings) -> bool:
    # Where strategies return, the circle is complete, and what remains of the gains is progress.
    lost = all(estimates[key].note == FALLS_BACK for key in GAINS)
    return lost and known["cycling"].verdict != PRESENT


def _rise(estimates: Estimates, known: Findings) -> Finding:
    if _may_be_a_circle(known["arms race"].estimates, known):
        return Finding(CANNOT_TELL, CIRCLE)
    rose = [key for key in CHANGES if estimates[key].ends[0] > LEAST_GAIN]
    teams = _teams(key for key in rose if estimates[key].note != NOT_SUSTAINED)
    if teams:
        reason = f"{_listed(teams)} became stronger by more than {LEAST_GAIN} this time"
        return Finding(PRESENT, reason, teams)
    if rose:
        return Finding(
            CANNOT_TELL, "a team became stronger, but mostly in a jump or with a setback"
        )
    return _against_all(estimates, CHANGES, LEAST_GAIN, "neither team became {} stronger this time")


def _intransitivity(estimates: Estimates, known: Findings) -> Finding:
    found = _against(
        estimates["squared_intransitivity"],
        LEAST_INTRANSITIVITY**2,
        "neither an order of strength nor episode noise explains the capture rates",
        "an order of strength and episode noise explain the capture rates",
    )
    if found.verdict == PRESENT and estimates["checkerboards"].value < LEAST_CHECKERBOARDS:
        reason = "no order of strength explains the capture rates, but checkerboards are rare"
        return Finding(CANNOT_TELL, reason)
    return found


def _cycling(estimates: Estimates, known: Findings) -> Finding:
    verdict = known["intransitivity"].verdict
    if verdict == ABSENT:
        return Finding(ABSENT, "generations do not beat each other in a circle")
    unknown = [estimates[key].note for key in RECURRENCES if estimates[key].low is None]
    if unknown:
        return Finding(CANNOT_TELL, unknown[0])
    back = [key for key in RECURRENCES if estimates[key].ends[0] > LEAST_RECURRENCE]
    if back and verdict == CANNOT_TELL:
        return Finding(CANNOT_TELL, "strategies return, but an order of strength may explain them")
    if back:
        return Finding(PRESENT, f"strategies of {_listed(_teams(back))} return", _teams(back))
    return _against_all(estimates, RECURRENCES, LEAST_RECURRENCE, "no strategies return")


def _forgetting(estimates: Estimates, known: Findings) -> Finding:
    teams = _teams(key for key in DROPS if estimates[key].ends[0] > LEAST_FORGETTING)
    if teams:
        reason = f"a team falls more than {LEAST_FORGETTING} below its best ancestors"
        return Finding(PRESENT, reason, teams)
    below = "neither team falls {} below its best ancestors"
    return _against_all(estimates, DROPS, LEAST_FORGETTING, below)


def _stagnation(estimates: Estimates, known: Findings) -> Finding:
    changes = _ends(estimates, *CHANGES)
    for name in ("arms race", "one-sided progress", "intransitivity"):
        if known[name].verdict == PRESENT:
            return Finding(ABSENT, f"{name} is present")
    if any(low >= LEAST_GAIN or high <= -LEAST_GAIN for low, high in changes):
        return Finding(ABSENT, f"the strength of a team changes by {LEAST_GAIN} or more")
    if any(low <= -LEAST_GAIN or high >= LEAST_GAIN for low, high in changes):
        return Finding(CANNOT_TELL, f"a change of {LEAST_GAIN} cannot be ruled out")
    if known["intransitivity"].verdict == CANNOT_TELL:
        reason = "neither team becomes stronger, but the race may be intransitive"
        return Finding(CANNOT_TELL, reason)
    return Finding(PRESENT, f"neither team's strength changes by {LEAST_GAIN}, nor who beats whom")


def _does_not_gain(gain: tuple[float, float]) -> bool:
    # A small gain that is told from 0 is no evidence of standstill.
    low, high = gain
    return low <= 0.0 and high < LEAST_GAIN


def _ends(estimates: Estimates, *keys: str) -> list[tuple[float, float]]:
    return [estimates[key].ends for key in keys]


def _teams(keys: Iterable[str]) -> tuple[str, ...]:
    """Return the teams of some measures."""
    return tuple(f"{key.partition('_')[0]}s" for key in keys)


def _listed(teams: tuple[str, ...]) -> str:
    return " and ".join(f"the {team}" for team in teams)


class Rule(NamedTuple):
    """How a condition is decided: the `measures`, and the `rule` on these and on earlier findings.

    `missing` says what it would take to know them; empty if they are known.
    """

    measures: tuple[str, ...]
    rule: Callable[[Estimates, Findings], Finding]
    missing: Callable[[Payoffs], str] = lambda payoffs: ""


def _noise(payoffs: Payoffs) -> str:
    return "" if payoffs.shows_noise else NO_EPISODES


def _single_episodes(payoffs: Payoffs) -> str:
    return "" if payoffs.has_episodes and payoffs.shows_noise else NO_SINGLE_EPISODES


GAINS, CHANGES = ("pursuer_gain", "evader_gain"), ("pursuer_change", "evader_change")
DROPS = ("pursuer_forgetting", "evader_forgetting")
RECURRENCES = ("pursuer_recurrence", "evader_recurrence")

RULES: Mapping[str, Rule] = {
    "disengagement": Rule(("one_sidedness", "capture_rate"), _disengagement, _noise),
    "intransitivity": Rule(("squared_intransitivity", "checkerboards"), _intransitivity, _noise),
    "cycling": Rule(RECURRENCES, _cycling, _noise),
    "arms race": Rule(GAINS, _arms_race),
    "one-sided progress": Rule(GAINS, _one_sided_progress),
    "rise": Rule(CHANGES, _rise),
    "forgetting": Rule(DROPS, _forgetting, _single_episodes),
    "stagnation": Rule(CHANGES, _stagnation),
}
"""The rules of all `CONDITIONS`, in the order in which they are judged."""
