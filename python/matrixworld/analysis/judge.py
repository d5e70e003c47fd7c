"""The judgement of a race: which conditions are present, in which part of it, and how surely.

All commands, figures and pages take their verdicts from `judge`.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from typing import NamedTuple

from matrixworld.analysis.intervals import LEVEL, RUNS_FOR_T, Estimate, check_level
from matrixworld.analysis.judgement import (
    ABSENT,
    CANNOT_TELL,
    ORDER,
    PRESENT,
    WHOLE,
    Estimates,
    Finding,
    Findings,
    Judgement,
)
from matrixworld.analysis.measures import (
    MEASURES,
    ends_of_extras,
    failed_at_last,
    leads_of,
    learned_in_all,
    learned_to_beat,
)
from matrixworld.analysis.payoffs import GENERATIONS_TO_JUDGE, Payoffs, Source, Window, read_payoffs
from matrixworld.analysis.progress import PURSUERS_WIN
from matrixworld.analysis.reasons import Reason, Why
from matrixworld.analysis.teams import keys_of

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

GAINS = keys_of("gain")
CHANGES = keys_of("change")
DROPS = keys_of("forgetting")
RECURRENCES = keys_of("recurrence")
INTERACTIONS = keys_of("squared_interaction")


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
    also be one of the mean course, and remain without one jump of each run. "Rise" says that a
    team ended stronger in what was played; "arms race" and "one-sided progress" say that it
    improved: no random walk explains it. Runs that are disengaged are left out of the other
    conditions, if four others remain.
    In a game with the scores of both teams, and of one population, other conditions are judged, and
    `Judgement.refused` says why the rest have no meaning. docs/analysis.md defines the conditions;
    evolution/results/judgement has how often verdicts are wrong.
    """
    payoffs = read_payoffs(source, per_episode=per_episode, episodes=episodes)
    check_level(level)
    is_long = payoffs.windows[WHOLE].generations >= GENERATIONS_TO_JUDGE
    return Judgement(
        len(payoffs),
        payoffs.shape,
        payoffs.episodes,
        level,
        _judge_windows(payoffs, level),
        payoffs.teams,
        payoffs.exact,
        refused_of(payoffs),
        ends_of_extras(payoffs),
        leads_of(payoffs, level) if is_long else {},
        failed_at_last(payoffs) if is_long else {},
    )


def _judge_windows(payoffs: Payoffs, level: float) -> dict[str, Findings]:
    """Return the findings on a single run, what each of a few shows, or those over many runs."""
    windows = payoffs.windows
    if len(payoffs) == 1:
        found = {name: _findings(payoffs, window, level) for name, window in windows.items()}
        return {name: _complete(each, [each]) for name, each in _agreeing(found).items()}
    singles = [_judge_windows(run, level) for run in payoffs.runs]
    by_run = {name: [single[name] for single in singles] for name in windows}
    together = _over_runs if len(payoffs) >= RUNS_FOR_T else _shared
    found = {
        name: together(payoffs, window, level, by_run[name]) for name, window in windows.items()
    }
    # What each of a few runs shows agrees with its whole race already.
    agreed = _agreeing(found) if len(payoffs) >= RUNS_FOR_T else found
    return {name: _complete(each, by_run[name]) for name, each in agreed.items()}


def _complete(findings: Findings, singles: Sequence[Findings]) -> Findings:
    """Return findings in the order of tables, with the verdict on each single run."""
    return {
        name: replace(findings[name], by_run=tuple(single[name].verdict for single in singles))
        for name in ORDER
        if name in findings
    }


def _over_runs(
    payoffs: Payoffs, window: Window, level: float, singles: Sequence[Findings]
) -> Findings:
    """Return the findings on the mean of runs: disengagement of all, the rest of engaged ones."""
    findings = _findings(payoffs, window, level)
    engaged = [run for run, single in enumerate(singles) if not _is_one_sided(single)]
    if _is_one_sided(findings) or len(engaged) == len(payoffs):
        return findings
    if len(engaged) >= RUNS_FOR_T:
        others = _findings(payoffs.select(engaged), window, level)
    else:
        reason = Reason(Why.FEW_ENGAGED, RUNS_FOR_T)
        others = {name: _cannot_tell(finding, reason) for name, finding in findings.items()}
    return {**others, "disengagement": findings["disengagement"]}


def _shared(
    payoffs: Payoffs, window: Window, level: float, singles: Sequence[Findings]
) -> Findings:
    """Return what each of a few runs shows: a verdict, and the teams, that all of them share."""
    found = {}
    for name, first in singles[0].items():
        of_runs = [single[name] for single in singles]
        shared = [team for team in first.teams if all(team in one.teams for one in of_runs)]
        alike = len({(one.verdict, bool(one.teams)) for one in of_runs}) == 1
        if not alike or bool(shared) != bool(first.teams):
            finding = Finding(CANNOT_TELL, Reason(Why.RUNS_DIFFER))
        else:
            same = all(one.reason == first.reason for one in of_runs)
            reason = first.reason if same else Reason(Why.EACH_RUN)
            finding = Finding(first.verdict, reason, tuple(shared))
        learned = learned_in_all([one.learned for one in of_runs])
        estimates = {}
        for key in first.estimates:
            estimate = MEASURES[key].estimated(payoffs, window, level)
            # A number that not all runs have decided nothing.
            if finding.verdict == CANNOT_TELL or math.isfinite(estimate.value):
                estimates[key] = estimate
        found[name] = replace(finding, estimates=estimates, learned=learned)
    return found


def _cannot_tell(finding: Finding, reason: Reason) -> Finding:
    return replace(finding, verdict=CANNOT_TELL, reason=reason, teams=(), learned={})


def _findings(payoffs: Payoffs, window: Window, level: float) -> Findings:
    """Return the verdict on each condition; later rules may use earlier verdicts."""
    findings: dict[str, Finding] = {}
    for name, condition in rules_of(payoffs).items():
        if window.generations < GENERATIONS_TO_JUDGE:
            missing = Why.TOO_SHORT
        else:
            missing = condition.missing(payoffs)
        if missing is not Why.NOTHING:
            findings[name] = Finding(CANNOT_TELL, Reason(missing))
            continue
        estimates = {
            key: MEASURES[key].estimated(payoffs, window, level) for key in condition.measures
        }
        if name != "disengagement" and _is_one_sided(findings):
            finding = Finding(CANNOT_TELL, Reason(Why.HIDDEN))
        else:
            finding = condition.rule(estimates, findings)
        if name == "stagnation" and finding.verdict == PRESENT:
            finding = replace(finding, learned=learned_to_beat(payoffs, window, level))
        findings[name] = replace(finding, estimates=finding.estimates or estimates)
    return findings


def _is_one_sided(findings: Findings) -> bool:
    """Return whether one team won nearly all matches, be they enough for a verdict or not."""
    finding = findings.get("disengagement")  # none in some games
    rate = finding.estimates.get("one_sidedness") if finding else None
    return rate is not None and rate.value > PURSUERS_WIN


def _agreeing(windows: Mapping[str, Findings]) -> dict[str, Findings]:
    """Return findings whose halves show no progress that the whole race speaks against."""
    whole = windows[WHOLE]
    return {
        name: found if name == WHOLE else _as_sure(found, whole) for name, found in windows.items()
    }


def _as_sure(half: Findings, whole: Findings) -> Findings:
    """Return the findings on a half, which shows no progress that the whole race speaks against.

    Any smooth curve rises in some half, and any circle does: both teams have to have risen over the
    whole race, too, without circles; or the same is present there.
    """
    if "arms race" not in whole:
        return _as_sure_alone(half, whole)
    circles = whole["intransitivity"].verdict == PRESENT
    both_rose = len(whole["rise"].teams) == 2 and not circles
    findings = dict(half)
    for name, agrees in (("arms race", both_rose), ("one-sided progress", False)):
        only_here = half[name].verdict == PRESENT and whole[name].verdict != PRESENT
        if only_here and not agrees:
            findings[name] = _cannot_tell(half[name], Reason(Why.ONE_HALF))
    return findings


def _as_sure_alone(half: Findings, whole: Findings) -> Findings:
    """Return the same where teams are judged alone: they have to have risen over the whole race."""
    circles = [name for name in ("intransitivity", "cycling") if name in whole]
    rose = whole["rise"].verdict == PRESENT
    rose = rose and all(whole[name].verdict != PRESENT for name in circles)
    only_here = half["progress"].verdict == PRESENT and whole["progress"].verdict != PRESENT
    if only_here and not rose:
        return {**half, "progress": _cannot_tell(half["progress"], Reason(Why.ONE_HALF))}
    return half


def _against(estimate: Estimate, margin: float, above: Reason, below: Reason) -> Finding:
    """Return present above the margin, absent below it, and "cannot tell" if it is inside."""
    low, high = estimate.ends
    if low > margin:
        return Finding(PRESENT, above)
    if high < margin:
        return Finding(ABSENT, below)
    return Finding(CANNOT_TELL, Reason(Why.MARGIN_INSIDE))


def _against_all(
    estimates: Estimates, keys: Mapping[str, str], margin: float, below: Why
) -> Finding:
    """Return absent if the numbers of both teams are below the margin, else "cannot tell"."""
    if all(estimates[key].ends[1] < margin for key in _asked(estimates, keys).values()):
        return Finding(ABSENT, Reason(below, margin))
    return Finding(CANNOT_TELL, Reason(Why.MARGIN_INSIDE))


def _disengagement(estimates: Estimates, earlier: Findings) -> Finding:
    finding = _against(
        estimates["one_sidedness"],
        PURSUERS_WIN,
        Reason(Why.ONE_SIDED, PURSUERS_WIN),
        Reason(Why.NOT_ONE_SIDED, PURSUERS_WIN),
    )
    if finding.verdict != PRESENT:
        return finding
    rate = estimates["capture_rate"].value
    if 1.0 - rate < CLOSE:
        return replace(finding, teams=("pursuers",))
    if rate < CLOSE:
        return replace(finding, teams=("evaders",))
    return finding


def _arms_race(estimates: Estimates, earlier: Findings) -> Finding:
    improved, still, unknown = _by_gain(estimates)
    if len(improved) == len(GAINS):
        if _may_be_a_circle(estimates, earlier):
            return Finding(CANNOT_TELL, Reason(Why.CIRCLE))
        return Finding(PRESENT, Reason(Why.BOTH_IMPROVED), improved)
    if still:
        return Finding(ABSENT, Reason(Why.NOT_IMPROVED, LEAST_GAIN, still))
    return Finding(CANNOT_TELL, Reason(Why.RANDOM_WALK, teams=unknown))


def _one_sided_progress(estimates: Estimates, earlier: Findings) -> Finding:
    improved, still, unknown = _by_gain(estimates)
    if earlier["arms race"].verdict == PRESENT:
        return Finding(ABSENT, Reason(Why.BOTH_DID))
    if len(still) == len(GAINS):
        return Finding(ABSENT, Reason(Why.NOT_IMPROVED, LEAST_GAIN, still))
    if unknown:
        return Finding(CANNOT_TELL, Reason(Why.RANDOM_WALK, teams=unknown))
    if _may_be_a_circle(estimates, earlier):
        return Finding(CANNOT_TELL, Reason(Why.CIRCLE))
    [other] = still
    if estimates[GAINS[other]].value <= -LEAST_GAIN:
        return Finding(CANNOT_TELL, Reason(Why.MAY_FALL, LEAST_GAIN, still))
    return Finding(PRESENT, Reason(Why.ONE_IMPROVED), improved)


def _progress(estimates: Estimates, earlier: Findings) -> Finding:
    """Return which teams rise by more than a random walk would, each by its own scores."""
    improved, still, unknown = _by_gain(estimates)
    if improved and _may_be_a_circle(estimates, earlier):
        return Finding(CANNOT_TELL, Reason(Why.CIRCLE))
    if improved:
        return Finding(PRESENT, Reason(Why.IMPROVED), improved)
    if not unknown:
        return Finding(ABSENT, Reason(Why.NOT_IMPROVED, LEAST_GAIN, still))
    return Finding(CANNOT_TELL, Reason(Why.RANDOM_WALK, teams=unknown))


def _by_gain(estimates: Estimates) -> tuple[tuple[str, ...], tuple[str, ...], tuple[str, ...]]:
    """Return the teams that improved, those that did not, and those of which it is not known."""
    ends = {team: estimates[key].ends for team, key in _asked(estimates, GAINS).items()}
    improved = tuple(team for team, (low, _) in ends.items() if low > 0.0)
    # A small gain that is told from 0 is no evidence of standstill.
    still = tuple(team for team, (low, high) in ends.items() if low <= 0.0 and high < LEAST_GAIN)
    unknown = tuple(team for team in ends if team not in (*improved, *still))
    return improved, still, unknown


def _may_be_a_circle(gains: Estimates, earlier: Findings) -> bool:
    # Where strategies return, the circle is complete, and what remains of the gains is progress.
    asked = _asked(gains, GAINS).values()
    all_fall_back = all(gains[key].note.why is Why.FALLS_BACK for key in asked)
    return all_fall_back and earlier["cycling"].verdict != PRESENT


def _joint(estimates: Estimates, *, sign: float) -> Finding:
    """Return whether the mean of both sides rose, or fell, by more than the margin."""
    change = estimates["joint_change"]
    low, high = change.ends
    low, high = (low, high) if sign > 0.0 else (-high, -low)
    if low > LEAST_GAIN:
        if change.note.why is Why.NOT_SUSTAINED:
            return Finding(CANNOT_TELL, Reason(Why.JOINT_JUMP))
        return Finding(PRESENT, Reason(Why.JOINT_CHANGE, LEAST_GAIN))
    if high < LEAST_GAIN:
        did_not = Why.NO_JOINT_RISE if sign > 0.0 else Why.NO_JOINT_FALL
        return Finding(ABSENT, Reason(did_not, LEAST_GAIN))
    return Finding(CANNOT_TELL, Reason(Why.MARGIN_INSIDE))


def _joint_rise(estimates: Estimates, earlier: Findings) -> Finding:
    return _joint(estimates, sign=1.0)


def _joint_fall(estimates: Estimates, earlier: Findings) -> Finding:
    return _joint(estimates, sign=-1.0)


def _rise(estimates: Estimates, earlier: Findings) -> Finding:
    gains = earlier["progress" if "progress" in earlier else "arms race"].estimates
    if _may_be_a_circle(gains, earlier):
        return Finding(CANNOT_TELL, Reason(Why.CIRCLE))
    rose = _above(estimates, CHANGES, LEAST_GAIN)
    # A trend is no jump, however unevenly it goes.
    improved, *_ = _by_gain(gains)
    jumped = tuple(
        team
        for team in rose
        if estimates[CHANGES[team]].note.why is Why.NOT_SUSTAINED and team not in improved
    )
    if rose == jumped != ():
        return Finding(CANNOT_TELL, Reason(Why.STRONGER_IN_A_JUMP, LEAST_GAIN, jumped))
    if rose:
        why = Why.STRONGER_BUT if jumped else Why.STRONGER
        teams = tuple(team for team in rose if team not in jumped)
        return Finding(PRESENT, Reason(why, LEAST_GAIN, jumped), teams)
    return _against_all(estimates, CHANGES, LEAST_GAIN, Why.NOT_STRONGER)


def _intransitivity(estimates: Estimates, earlier: Findings) -> Finding:
    finding = _against(
        estimates["squared_intransitivity"],
        LEAST_INTRANSITIVITY**2,
        Reason(Why.NO_ORDER),
        Reason(Why.ORDER),
    )
    if finding.verdict == PRESENT and estimates["checkerboards"].value < LEAST_CHECKERBOARDS:
        return Finding(CANNOT_TELL, Reason(Why.FEW_CHECKERBOARDS))
    return finding


def _cycling(estimates: Estimates, earlier: Findings) -> Finding:
    intransitivity = earlier["intransitivity"].verdict
    if intransitivity == ABSENT:
        decides = earlier["intransitivity"].estimates
        return Finding(ABSENT, Reason(Why.NO_CIRCLE), estimates=decides)
    for key in _asked(estimates, RECURRENCES).values():
        if estimates[key].low is None:
            return Finding(CANNOT_TELL, estimates[key].note)
    teams = _above(estimates, RECURRENCES, LEAST_RECURRENCE)
    if teams and intransitivity == CANNOT_TELL:
        return Finding(CANNOT_TELL, Reason(Why.RETURN_IN_ORDER))
    if teams:
        return Finding(PRESENT, Reason(Why.RETURN), teams)
    return _against_all(estimates, RECURRENCES, LEAST_RECURRENCE, Why.NO_RETURN)


def _return(estimates: Estimates, earlier: Findings) -> Finding:
    """Return whether strategies return, where no order of strength is asked for.

    What a team does against whom has to matter: it changes scores by more than a margin.
    """
    least = LEAST_INTRANSITIVITY**2
    decide = {key: estimates[key] for key in _asked(estimates, INTERACTIONS).values()}
    if all(interaction.ends[1] < least for interaction in decide.values()):
        reason = Reason(Why.NO_INTERACTION, LEAST_INTRANSITIVITY)
        return Finding(ABSENT, reason, estimates=decide)
    for key in _asked(estimates, RECURRENCES).values():
        if estimates[key].low is None:
            return Finding(CANNOT_TELL, estimates[key].note)
    returning = _above(estimates, RECURRENCES, LEAST_RECURRENCE)
    matters = _above(estimates, INTERACTIONS, least)
    teams = tuple(team for team in returning if team in matters)
    if teams:
        return Finding(PRESENT, Reason(Why.RETURN), teams)
    if returning:
        return Finding(CANNOT_TELL, Reason(Why.RETURN_IN_ORDER))
    return _against_all(estimates, RECURRENCES, LEAST_RECURRENCE, Why.NO_RETURN)


def _forgetting(estimates: Estimates, earlier: Findings) -> Finding:
    teams = _above(estimates, DROPS, LEAST_FORGETTING)
    if teams:
        return Finding(PRESENT, Reason(Why.FORGETS, LEAST_FORGETTING), teams)
    return _against_all(estimates, DROPS, LEAST_FORGETTING, Why.NOT_FORGETS)


def _stagnation(estimates: Estimates, earlier: Findings) -> Finding:
    for name, why in NO_STAGNATION.items():
        if name in earlier and earlier[name].verdict == PRESENT:
            return Finding(ABSENT, Reason(why))
    changes = [estimates[key].ends for key in _asked(estimates, CHANGES).values()]
    if any(low >= LEAST_GAIN or high <= -LEAST_GAIN for low, high in changes):
        return Finding(ABSENT, Reason(Why.CHANGES, LEAST_GAIN))
    if any(low <= -LEAST_GAIN or high >= LEAST_GAIN for low, high in changes):
        return Finding(CANNOT_TELL, Reason(Why.MAY_CHANGE, LEAST_GAIN))
    if earlier["intransitivity"].verdict == CANNOT_TELL:
        return Finding(CANNOT_TELL, Reason(Why.MAY_BE_INTRANSITIVE))
    return Finding(PRESENT, Reason(Why.NO_CHANGE, LEAST_GAIN))


def _above(estimates: Estimates, keys: Mapping[str, str], margin: float) -> tuple[str, ...]:
    """Return the teams whose numbers are above a margin."""
    asked = _asked(estimates, keys)
    return tuple(team for team, key in asked.items() if estimates[key].ends[0] > margin)


def _asked(estimates: Estimates, keys: Mapping[str, str]) -> dict[str, str]:
    """Return the numbers by team that a rule has: one population has those of the first team."""
    return {team: key for team, key in keys.items() if key in estimates}


class Rule(NamedTuple):
    """How a condition is decided: the `measures`, and the `rule` on these and on earlier findings.

    `missing` says what it would take to know them.
    """

    measures: tuple[str, ...]
    rule: Callable[[Estimates, Findings], Finding]
    missing: Callable[[Payoffs], Why] = lambda payoffs: Why.NOTHING


def _noise(payoffs: Payoffs) -> Why:
    return Why.NOTHING if payoffs.shows_noise else Why.EPISODES_UNKNOWN


def _single_episodes(payoffs: Payoffs) -> Why:
    if payoffs.has_episodes and payoffs.shows_noise:
        return Why.NOTHING
    return Why.NO_SINGLE_EPISODES


NO_STAGNATION = {
    "progress": Why.PROGRESS,
    "arms race": Why.ARMS_RACE,
    "one-sided progress": Why.ONE_SIDED_PROGRESS,
    "intransitivity": Why.INTRANSITIVITY,
}
"""Conditions without which a race stagnates."""

RULES: Mapping[str, Rule] = {
    "disengagement": Rule(("one_sidedness", "capture_rate"), _disengagement, _noise),
    "intransitivity": Rule(("squared_intransitivity", "checkerboards"), _intransitivity, _noise),
    "cycling": Rule(tuple(RECURRENCES.values()), _cycling, _noise),
    "arms race": Rule(tuple(GAINS.values()), _arms_race),
    "one-sided progress": Rule(tuple(GAINS.values()), _one_sided_progress),
    "rise": Rule(tuple(CHANGES.values()), _rise),
    "forgetting": Rule(tuple(DROPS.values()), _forgetting, _single_episodes),
    "stagnation": Rule(tuple(CHANGES.values()), _stagnation),
}
"""The rules of all `CONDITIONS`, in the order in which they are judged."""


def _of_one(keys: Mapping[str, str]) -> tuple[str, ...]:
    return (keys["pursuers"],)


RULES_OF_ONE: Mapping[str, Rule] = {
    "intransitivity": RULES["intransitivity"],
    "cycling": Rule(_of_one(RECURRENCES), _cycling, _noise),
    "progress": Rule(_of_one(GAINS), _progress),
    "rise": Rule(_of_one(CHANGES), _rise),
    "forgetting": Rule(_of_one(DROPS), _forgetting, _single_episodes),
    "stagnation": Rule(_of_one(CHANGES), _stagnation),
}
"""The rules of a race of one population, in a symmetric game."""

RULES_OF_BOTH: Mapping[str, Rule] = {
    "joint rise": Rule(("joint_change",), _joint_rise, _noise),
    "joint fall": Rule(("joint_change",), _joint_fall, _noise),
    "cycling": Rule((*RECURRENCES.values(), *INTERACTIONS.values()), _return, _noise),
    "progress": Rule(tuple(GAINS.values()), _progress),
    "rise": Rule(tuple(CHANGES.values()), _rise),
    "forgetting": Rule(tuple(DROPS.values()), _forgetting, _single_episodes),
}
"""The rules where both teams have scores of their own; one population has those of the first."""


def rules_of(payoffs: Payoffs) -> Mapping[str, Rule]:
    """Return the rules of the conditions that have a meaning in a game of this kind."""
    if not payoffs.general:
        return RULES_OF_ONE if payoffs.one_population else RULES
    if not payoffs.one_population:
        return RULES_OF_BOTH
    second = {keys["evaders"] for keys in (RECURRENCES, INTERACTIONS, CHANGES, GAINS, DROPS)}
    return {
        name: rule._replace(measures=tuple(key for key in rule.measures if key not in second))
        for name, rule in RULES_OF_BOTH.items()
    }


REFUSED_OF_ONE = {
    "disengagement": Why.ONE_POPULATION,
    "arms race": Why.NOTHING_TO_RACE_WITH,
    "one-sided progress": Why.NOTHING_TO_RACE_WITH,
}
REFUSED_OF_BOTH = dict.fromkeys(
    ("disengagement", "arms race", "one-sided progress", "intransitivity", "stagnation"),
    Why.NOT_CONSTANT_SUM,
)
"""Conditions without a meaning of one population, or with the scores of both teams, and why."""


def refused_of(payoffs: Payoffs) -> dict[str, Reason]:
    """Return the conditions that have no meaning in a game of this kind, and why."""
    refused: dict[str, Why] = {}
    if payoffs.general:
        refused |= REFUSED_OF_BOTH
    if payoffs.one_population:
        refused |= REFUSED_OF_ONE
    return {name: Reason(why) for name, why in refused.items()}
