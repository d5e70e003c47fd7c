"""Judgements: the findings on a race, and what they say in words and tables."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any, NamedTuple

from matrixworld._util.checks import check_choice, check_instance
from matrixworld._util.readable import Parts, Readable, plain_values
from matrixworld.analysis.intervals import Estimate
from matrixworld.analysis.measures import MEASURES
from matrixworld.analysis.payoffs import TEAMS, in_words_of

PRESENT, ABSENT, CANNOT_TELL = "present", "absent", "cannot tell"

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
    teams : tuple of str, optional
        What the teams are called.
    exact : bool, optional
        Whether the game has no chance: then the episodes are equal.
    """

    runs: int
    shape: tuple[int, int]
    episodes: int | None
    level: float
    window: str
    windows: Mapping[str, Findings]
    teams: tuple[str, str] = TEAMS
    exact: bool = False

    def _parts(self) -> Parts:
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


class Words(NamedTuple):
    """What is told of a condition that is present: in a sentence of its ``{teams}``, in numbers.

    A headline leaves out the condition that this one `implies`.
    """

    happened: str
    implies: str = ""
    numbers: str = ""


WORDS: Mapping[str, Words] = {
    "disengagement": Words("one team often won nearly all matches"),
    "arms race": Words("{teams} improved", "rise", "gains"),
    "one-sided progress": Words("only {teams} improved", "rise", "gains"),
    "rise": Words("{teams} became stronger (perhaps by chance)", numbers="changes"),
    "intransitivity": Words("some generations beat each other in a circle"),
    "cycling": Words("{teams} returned to earlier strategies", "intransitivity"),
    "forgetting": Words("{teams} lost old skills", numbers="drops"),
    "stagnation": Words("neither team became stronger or weaker"),
}
"""All conditions by name, in the order in which they are judged."""

CONDITIONS = tuple(WORDS)
"""Names of the conditions."""

TIMES = {"first half": "early", "last half": "late"}
"""Windows in a headline."""
OVERALL = "overall"
WHEN = {
    "first half": {ABSENT: "until {}", CANNOT_TELL: "at least until {}"},
    "last half": {ABSENT: "from {} on", CANNOT_TELL: "at least from {} on"},
}
"""When something happened in one half only, by the verdict on the other half."""
IMPROVEMENTS = ("arms race", "one-sided progress", "rise")
BETTER_OR_NOT = {"disengagement", "stagnation", *IMPROVEMENTS}
"""Conditions that say whether a team improved, or why that is not known."""


def summary(judgement: Judgement) -> list[str]:
    """Return what happened, in lines: `sentence`, `headline` and `headline_numbers`."""
    return [sentence(judgement), headline(judgement), *headline_numbers(judgement)]


def sentence(judgement: Judgement) -> str:
    """Return in one plain sentence who improved, until when, and what was lost.

    Such as ``"Both teams improved until generation 14; the pursuers lost old skills from
    generation 15 on."``. It says what the verdicts say, and no more: "until" if a condition is
    absent in the other half, "at least until" if this cannot be told.

    Parameters
    ----------
    judgement : Judgement
    """
    parts: dict[str, list[_Claim]] = {}
    for claim in _claims(judgement):
        parts.setdefault(claim.window, []).append(claim)
    # Whether a team improved comes first, then what holds for the whole race, then the halves.
    order = ["", "whole", "both", *TIMES]
    told = "; ".join(
        _part(parts[window])
        for window in sorted(
            parts, key=lambda each: (not any(c.better for c in parts[each]), order.index(each))
        )
    )
    if judgement.runs > 1:
        told = f"in the mean of {judgement.runs} runs, {told}"
    return in_words_of(judgement.teams, f"{told[0].upper()}{told[1:]}.")


class _Claim(NamedTuple):
    """What happened, in which window, and in words when; and whether it is about improvement."""

    what: str
    window: str
    when: str
    better: bool


def _part(claims: list[_Claim]) -> str:
    """Return what happened in a window as a part of a sentence."""
    (first, *others), [when, *different] = claims, dict.fromkeys(each.when for each in claims)
    if not others:
        return f"{first.what} {when}".rstrip()
    when = f"in the {first.window}" if different else when
    *listed, last = (each.what for each in claims)
    return f"{when}, {', '.join(listed)} and {last}".removeprefix(", ")


def _claims(judgement: Judgement) -> list[_Claim]:
    """Return what is present, and whether a team improved if nothing present says it."""
    claims, present = [], _present(judgement)
    for name in sorted(present, key=lambda each: (each not in BETTER_OR_NOT, each)):
        by_teams: dict[tuple[str, ...], list[str]] = {}
        for window in _halves(present[name]):
            by_teams.setdefault(judgement.windows[window][name].teams, []).append(window)
        verdicts = {at: found[name].verdict for at, found in judgement.windows.items()}
        for teams, windows in by_teams.items():
            who = "both teams" if len(teams) == 2 else "".join(f"the {team}" for team in teams)
            time = _time(judgement, windows, verdicts)
            what = WORDS[name].happened.format(teams=who)
            claims.append(_Claim(what, *time, name in BETTER_OR_NOT))
    if not BETTER_OR_NOT & present.keys():
        claims.insert(0, _no_improvement(judgement))
    return claims


def _no_improvement(judgement: Judgement) -> _Claim:
    """Return where no team improved; if that is not known anywhere, so much."""
    verdicts = {
        at: PRESENT if {found[name].verdict for name in IMPROVEMENTS} == {ABSENT} else CANNOT_TELL
        for at, found in judgement.windows.items()
    }
    windows = _halves([at for at, verdict in verdicts.items() if verdict == PRESENT])
    if not windows:
        return _Claim("it cannot be told whether a team improved", "", "", True)
    return _Claim("neither team improved", *_time(judgement, windows, verdicts), True)


def _halves(windows: list[str]) -> list[str]:
    """Return the halves among windows, or else the whole race."""
    return [window for window in windows if window in TIMES] or windows


def _time(judgement: Judgement, windows: list[str], verdicts: Mapping[str, str]) -> tuple[str, str]:
    """Return the window in which something holds, and when it did in words."""
    if judgement.window not in TIMES:
        return "whole", ""  # too short to have halves
    if len(windows) == 2:
        return "both", "throughout the race"
    [window] = windows
    if window == "whole":
        return window, "over the whole race"
    [other] = TIMES.keys() - windows
    words = WHEN[window].get(verdicts[other], f"in the {window}")
    pursuers, evaders = judgement.shape
    # The last half begins with the middle generation; teams of different length share no number.
    middle = f"generation {pursuers // 2 - (window == 'first half')}"
    return window, words.format(middle if pursuers == evaders else "the middle of the race")


def headline(judgement: Judgement) -> str:
    """Return what is present, and when, in one sentence; commands, figures and pages share it.

    Such as ``"CYCLING early, FORGETTING late"``. "early" and "late" are the halves of a race. What
    is present in both halves, or only in the whole race, is so "overall", or has no time. "cannot
    tell" if nothing is present in any window and not everything is absent.

    Parameters
    ----------
    judgement : Judgement
    """
    at: dict[str, list[str]] = {time: [] for time in (OVERALL, *TIMES.values())}
    for name, windows in _present(judgement).items():
        halves = [TIMES[window] for window in windows if window in TIMES]
        at[halves[0] if len(halves) == 1 else OVERALL].append(name.upper())
    if not any(at.values()):
        verdicts = {each.verdict for found in judgement.windows.values() for each in found.values()}
        return CANNOT_TELL if CANNOT_TELL in verdicts else "no condition is present"
    if not (at["early"] or at["late"]):
        return ", ".join(at[OVERALL])
    parts = [f"{' and '.join(names)} {time}" for time, names in at.items() if names]
    if not (at["late"] or at[OVERALL]):
        early = (judgement.findings[name.lower()].verdict for name in at["early"])
        parts.append("later undecided" if CANNOT_TELL in early else "not later")
    return ", ".join(parts)


def _present(judgement: Judgement) -> dict[str, list[str]]:
    """Return the windows in which each condition is present and no other one implies it."""
    check_instance("judgement", judgement, Judgement)
    found: dict[str, list[str]] = {}
    for window in judgement.windows:
        present = judgement.present(window)
        implied = {WORDS[name].implies for name in present}
        for name in present:
            if name not in implied:
                found.setdefault(name, []).append(window)
    return found


def headline_numbers(judgement: Judgement) -> list[str]:
    """Return the numbers under a headline: gains, and how far teams fall below their best.

    Such as ``"gains: pursuers +0.42, evaders +0.70 (whole race)"``.
    """
    lines = []
    for name, window in _numbered(judgement):
        found, kind = judgement.windows[window][name], WORDS[name].numbers
        known = {MEASURES[key].short: each for key, each in found.estimates.items()}
        if kind == "drops":  # only of teams that are known to forget
            drops = [f"{team} {known[team].value:.2f}" for team in found.teams]
            lines.append(f"{', '.join(drops)} below their best ({_named(window)})")
        elif known:
            gains = [f"{team} {each.value:+.2f}" for team, each in known.items()]
            lines.append(f"{kind}: {', '.join(gains)} ({_named(window)})")
    return [in_words_of(judgement.teams, line) for line in lines]


def _numbered(judgement: Judgement) -> list[tuple[str, str]]:
    """Return the conditions whose numbers stand under a headline, each with a window."""
    present = _present(judgement)
    told = [name for name in CONDITIONS if name in present and WORDS[name].numbers]
    # A rise is a change in what was played; a gain would come again. One of them is enough.
    falling = [name for name in told if WORDS[name].numbers == "drops"]
    rising = [name for name in told if name not in falling][:1]
    numbered = []
    for name in rising + falling or ["arms race"]:
        halves = _halves(present.get(name, []))
        numbered.append((name, halves[0] if len(halves) == 1 else "whole"))
    return numbered


def _named(window: str) -> str:
    return "whole race" if window == "whole" else window


def judgement_table(judgement: Judgement) -> list[tuple[str, str, str, str]]:
    """Return the rows of a table: condition, verdict, numbers with intervals, window.

    After the heads all findings of the headline window; then those that are present in another
    window only, and those whose numbers stand under the headline.

    Parameters
    ----------
    judgement : Judgement
    """
    rows = [_row(judgement, *told) for told in _told(judgement)]
    return [("condition", "verdict", f"{judgement.level:.0%} interval", "window"), *rows]


def _told(judgement: Judgement) -> list[tuple[str, Finding, str]]:
    """Return condition, finding and window of what `judgement_table` lists."""
    check_instance("judgement", judgement, Judgement)
    told = [(name, found, judgement.window) for name, found in judgement.findings.items()]
    # A wave that is over belongs into the table, too.
    numbered = _numbered(judgement)
    for window, findings in judgement.windows.items():
        others = [each for each in judgement.present(window) if each not in judgement.present()]
        others += [name for name, at in numbered if at == window and name not in others]
        told += [(name, findings[name], window) for name in others if window != judgement.window]
    return told


def judgement_cells(judgement: Judgement) -> list[tuple[str, ...]]:
    """Return the rows of `judgement_table` for a terminal: numbers below each other, and once."""
    rows: list[tuple[str, ...]] = []
    first: dict[tuple[str, str], str] = {}
    for condition, verdict, numbers, window in judgement_table(judgement):
        # Numbers of an earlier row are named by its condition.
        owner = first.setdefault((numbers, window), condition)
        cell = f"as for {owner}" if numbers and owner != condition else numbers
        rows.append((condition, verdict, cell.replace(", ", "\n"), window))
    return rows


def _row(
    judgement: Judgement, condition: str, finding: Finding, window: str
) -> tuple[str, str, str, str]:
    numbers = ", ".join(
        f"{MEASURES[key].short or MEASURES[key].label} {MEASURES[key].shown(estimate)}"
        for key, estimate in finding.estimates.items()
    )
    return condition, finding.verdict, in_words_of(judgement.teams, numbers), _named(window)


def explain(judgement: Judgement) -> str:
    """Return the findings of `judgement_table` as sentences with reasons, a line for each.

    Parameters
    ----------
    judgement : Judgement
    """
    lines = "\n".join(
        f"{name.capitalize()}{'' if window == judgement.window else f' ({_named(window)})'}: "
        f"{finding.verdict}, because {finding.reason}.{_counts(finding.by_run)}"
        for name, finding, window in _told(judgement)
    )
    return in_words_of(judgement.teams, lines)


def _counts(by_run: tuple[str, ...]) -> str:
    if len(by_run) == 1:
        return ""
    counts = ", ".join(f"{by_run.count(each)} {each}" for each in (PRESENT, ABSENT, CANNOT_TELL))
    return f" Of the single runs: {counts}."
