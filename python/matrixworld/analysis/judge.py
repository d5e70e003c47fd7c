"""The judgement of a race: which conditions are present, in which part of it, and how surely.

All commands, figures and pages take their verdicts from `judge`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field, replace
from typing import Any

from matrixworld._util.checks import check_choice
from matrixworld._util.readable import Parts, Readable, plain_values
from matrixworld.analysis.intervals import LEVEL, Estimate, check_level
from matrixworld.analysis.measures import MEASURES, NO_EPISODES, NOT_SUSTAINED, TOO_SHORT
from matrixworld.analysis.payoffs import GENERATIONS_TO_JUDGE, Payoffs, Source, Window, read_payoffs
from matrixworld.analysis.progress import PURSUERS_WIN

PRESENT, ABSENT, CANNOT_TELL = "present", "absent", "cannot tell"

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
LEAST_FORGETTING = 0.05
"""Forgetting: mean drop below the best ancestors above this."""

HIDDEN = "one team wins nearly all matches, which hides this condition"
NO_SINGLE_EPISODES = NO_EPISODES.replace("number of episodes", "single episodes")
ALL_DISENGAGED = "fewer than two of the runs are engaged, and the others hide this condition"

Estimates = Mapping[str, Estimate]
Findings = Mapping[str, "Finding"]


@dataclass(frozen=True)
class Finding:
    """Verdict on one condition in one window: ``"present"``, ``"absent"`` or ``"cannot tell"``.

    The `reason` is a clause after "because". The `estimates` are the numbers that decide, by their
    names in `MEASURES`; none if some are not known. `teams`: those of which a condition is present.
    `by_run`: verdict on each single run.
    """

    verdict: str
    reason: str
    teams: tuple[str, ...] = ()
    estimates: Estimates = field(default_factory=dict)
    by_run: tuple[str, ...] = ()


@dataclass(frozen=True, repr=False)
class Judgement(Readable):
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
    window : str
        Name of the window that headlines speak of: the last half, of short races the whole.
    windows : mapping of str to mapping of str to Finding
        Findings on the whole race, its first half and its last half, by condition.
    """

    runs: int
    shape: tuple[int, int]
    episodes: int | None
    level: float
    window: str
    windows: Mapping[str, Findings]

    def _parts(self) -> Parts:
        from matrixworld.analysis.words import judgement_cells, summary

        return [*summary(self), judgement_cells(self)]

    @property
    def findings(self) -> Findings:
        """The findings on the window that headlines speak of."""
        return self.windows[self.window]

    def present(self, window: str | None = None) -> tuple[str, ...]:
        """Return the conditions that are present in a window, by default that of headlines."""
        if window is not None:
            check_choice("window", window, self.windows)
        findings = self.windows[window or self.window]
        return tuple(name for name, found in findings.items() if found.verdict == PRESENT)

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

    A verdict is "cannot tell" if an interval contains the margin. The interval of a single run is
    about this run: its episodes, and for gains the fluctuation between its generations. Several
    runs have Student's t interval over runs; a gain must also be a trend of the mean course, and
    remain without one jump of each run. "Rise" says that a team became stronger in what was
    played; "arms race" and "one-sided progress" say that no random walk explains it. Runs that are
    disengaged are left out of the other conditions. docs/analysis.md defines the conditions;
    evolution/results/judgement has how often verdicts are wrong. Episodes of a pair are
    independent; pairs may share their worlds.

    Parameters
    ----------
    source : array_like, path, list of paths or Payoffs
        Payoffs; see `read_payoffs`.
    per_episode : bool, optional
        Whether the last dimension of the array holds the episodes of each cell.
    episodes : int, optional
        Number of episodes behind each cell of a matrix of means. Without it only the gains of the
        teams can be judged. Forgetting takes the single episodes.
    level : float, optional
        Level of the intervals, in (0, 1).
    """
    payoffs = read_payoffs(source, per_episode=per_episode, episodes=episodes)
    check_level(level)
    windows = {
        name: _judge_window(payoffs, window, level) for name, window in payoffs.windows.items()
    }
    return Judgement(
        len(payoffs), payoffs.shape, payoffs.episodes, level, payoffs.late.name, windows
    )


def _judge_window(payoffs: Payoffs, window: Window, level: float) -> Findings:
    by_run = [_findings(run, window, level) for run in payoffs.runs]
    found = _findings(payoffs, window, level) if len(payoffs) > 1 else by_run[0]
    # Disengagement is judged over all runs, the other conditions over the engaged ones.
    engaged = [run for run, each in enumerate(by_run) if not _is_disengaged(each)]
    if not _is_disengaged(found) and len(engaged) < len(by_run):
        if len(engaged) >= 2:
            others = _findings(payoffs.select(engaged), window, level)
        else:
            others = {
                name: replace(each, verdict=CANNOT_TELL, reason=ALL_DISENGAGED, teams=())
                for name, each in found.items()
            }
        found = {**others, "disengagement": found["disengagement"]}
    return {
        name: replace(each, by_run=tuple(one[name].verdict for one in by_run))
        for name, each in found.items()
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
        hidden = name != "disengagement" and _is_disengaged(found)
        decided = Finding(CANNOT_TELL, HIDDEN) if hidden else condition.rule(estimates, found)
        found[name] = replace(decided, estimates=estimates)
    return found


def _is_disengaged(findings: Findings) -> bool:
    return findings["disengagement"].verdict == PRESENT


# ---- The rules -----------------------------------------------------------------------------------


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
    return _against(
        estimates["one_sidedness"],
        PURSUERS_WIN,
        f"one team gets more than {PURSUERS_WIN:.0%} of its payoff in half of the generations",
        f"neither team gets {PURSUERS_WIN:.0%} of its payoff in half of the generations",
    )


def _arms_race(estimates: Estimates, known: Findings) -> Finding:
    gains = _ends(estimates, *GAINS)
    if all(low > 0.0 for low, _ in gains):
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
    for key, (low, _), other in zip(GAINS, gains, gains[::-1], strict=True):
        if low > 0.0 and _does_not_gain(other):
            reason = "only one team rises by more than a random walk with such steps would"
            return Finding(PRESENT, reason, _teams([key]))
    return Finding(CANNOT_TELL, "a random walk may explain the gain of at least one team")


def _rise(estimates: Estimates, known: Findings) -> Finding:
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


# ---- The table -----------------------------------------------------------------------------------


TWICE = "twice"
"""New value of a setting: twice the present one."""
ANY, IN_TURNS, NEWEST_ONLY, PAST_ONES = "any", "in turns", "newest only", "past ones"
ONE_GENOME, FULL_VIRULENCE = "samples around one genome in turns", "full virulence"
"""Situations of races, beside the names of schedules; `cli.judge` says which ones a race is in."""


@dataclass(frozen=True, eq=False)
class Change:
    """New values of settings, by path, that may help races in any of some situations, and why."""

    situations: tuple[str, ...]
    settings: Mapping[str, Any]
    why: str


@dataclass(frozen=True)
class Condition:
    """A condition of the judgement, in a row of `RULES`; nothing else has to know of it.

    `measures`: the numbers that decide, by their names in `MEASURES`. `rule`: the verdict from
    these, and from the findings on the rows above. `missing`: what it would take to know them,
    empty if they are known. `happened`: what a plain sentence says of its ``{teams}``. A headline
    leaves out the condition that this one `implies`. `numbers`: what its numbers are called in the
    line under a headline, which has one if it is present; empty for none. `advice`: what to try
    next where it is present, and `changes` the settings of a race that may do it.
    """

    measures: tuple[str, ...]
    rule: Callable[[Estimates, Findings], Finding]
    missing: Callable[[Payoffs], str]
    happened: str
    implies: str = ""
    numbers: str = ""
    advice: str = ""
    changes: tuple[Change, ...] = ()


def _nothing(payoffs: Payoffs) -> str:
    return ""


def _noise(payoffs: Payoffs) -> str:
    return "" if payoffs.shows_noise else NO_EPISODES


def _single_episodes(payoffs: Payoffs) -> str:
    return "" if payoffs.has_episodes and payoffs.shows_noise else NO_SINGLE_EPISODES


GAINS, CHANGES = ("pursuer_gain", "evader_gain"), ("pursuer_change", "evader_change")
DROPS = ("pursuer_forgetting", "evader_forgetting")
RECURRENCES = ("pursuer_recurrence", "evader_recurrence")

# What several conditions have in common:
NEWEST, GENERALISTS = ("specialist-specialist", "generalist-specialist"), "generalist-generalist"
PURSUERS_MEET, EVADERS_MEET = "schedule.pursuers_meet", "schedule.evaders_meet"
AGAINST_CYCLES: dict[str, Any] = {
    "advice": "let both teams meet opponents of all generations, or a hall of fame",
    "changes": (
        Change(NEWEST, {"schedule": GENERALISTS}, "both teams meet opponents of all generations"),
        Change(NEWEST, {"schedule": "hall-of-fame"},
               "both teams meet living opponents and champions of all generations"),
        Change((GENERALISTS,), {"schedule.opponents": 4},
               "candidates meet several opponents in each epoch"),
        Change((GENERALISTS,), {PURSUERS_MEET: "maxsolve", EVADERS_MEET: "maxsolve"},
               "an archive keeps the opponents that tell candidates apart"),
        Change((NEWEST_ONLY,), {PURSUERS_MEET: "uniform", EVADERS_MEET: "uniform"},
               "both teams meet opponents of all generations"),
        Change((PAST_ONES,), {"schedule.opponents": TWICE},
               "candidates meet more opponents in each epoch"),
        Change(("hall-of-fame",), {"schedule.hall_sample": TWICE},
               "candidates meet more members of the halls of fame"),
    ),
}  # fmt: skip
GO_ON: dict[str, Any] = {
    "advice": "more generations show how long it goes on",
    "changes": (
        Change((ANY,), {"schedule.generations": TWICE},
               "the race goes on; more generations show how long"),
    ),
}  # fmt: skip
MORE_EPOCHS = (
    Change((IN_TURNS,), {"schedule.pursuer_epochs": TWICE},
           "if pursuers are the weaker team or the one that does not gain"),
    Change((IN_TURNS,), {"schedule.evader_epochs": TWICE},
           "if evaders are the weaker team or the one that does not gain"),
)  # fmt: skip

RULES: Mapping[str, Condition] = {
    "disengagement": Condition(
        ("one_sidedness",), _disengagement, _noise,
        "one team often won nearly all matches",
        advice="make the weaker team stronger, or reward no candidate for winning everything",
        changes=(
            Change((FULL_VIRULENCE,), {"fitness.pursuer_virulence": 0.75},
                   "if pursuers win everything: candidates that win everything have no advantage"),
            Change((FULL_VIRULENCE,), {"fitness.evader_virulence": 0.75},
                   "the same for evaders, if they win everything"),
            *MORE_EPOCHS,
        ),
    ),
    "arms race": Condition(
        GAINS, _arms_race, _nothing, "{teams} improved",
        implies="rise", numbers="gains", **GO_ON
    ),
    "one-sided progress": Condition(
        GAINS, _one_sided_progress, _nothing, "only {teams} improved",
        implies="rise", numbers="gains",
        advice="give the team that does not gain more time to learn",
        changes=(
            *MORE_EPOCHS,
            Change(("hall-of-fame",), {"schedule.joint_epochs": TWICE},
                   "more time for the team that does not gain"),
        ),
    ),
    "rise": Condition(
        CHANGES, _rise, _nothing, "{teams} became stronger (perhaps by chance)",
        numbers="changes", **GO_ON
    ),
    "intransitivity": Condition(
        ("squared_intransitivity", "checkerboards"), _intransitivity, _noise,
        "some generations beat each other in a circle", **AGAINST_CYCLES
    ),
    "cycling": Condition(
        RECURRENCES, _cycling, _noise, "{teams} returned to earlier strategies",
        implies="intransitivity", **AGAINST_CYCLES
    ),
    "forgetting": Condition(
        DROPS, _forgetting, _single_episodes, "{teams} lost old skills",
        numbers="drops", **AGAINST_CYCLES
    ),
    "stagnation": Condition(
        CHANGES, _stagnation, _nothing, "neither team became stronger or weaker",
        advice="more candidates, another learner or a larger network",
        changes=(
            Change((ANY,), {"learner.population": TWICE},
                   "the fitness of more candidates is less noisy"),
            Change((ONE_GENOME,), {"learner": "ga"},
                   "a population of different genomes instead of samples around one"),
            Change((ANY,), {"policy.hidden": TWICE}, "a larger network"),
        ),
    ),
}  # fmt: skip
"""All conditions by name, in the order in which they are judged."""

CONDITIONS = tuple(RULES)
"""Names of the conditions."""
