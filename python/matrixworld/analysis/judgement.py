"""Judgements: the findings on a race, and what they say in a sentence, a table and reasons.

`WORDS` holds what is said of a condition that is present. Sentences and reasons both have it from
`_happened`, so that they name the same teams in the same words.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import Any, NamedTuple

from matrixworld._util.checks import check_choice, check_instance
from matrixworld._util.readable import Parts, Readable, plain_values
from matrixworld._util.teams import BOTH
from matrixworld.analysis.intervals import RUNS_FOR_T, Estimate
from matrixworld.analysis.measures import MEASURES, Lead
from matrixworld.analysis.reasons import Reason, Why
from matrixworld.analysis.teams import keys_of, listed, names_of

PRESENT = "present"
ABSENT = "absent"
CANNOT_TELL = "cannot tell"

Estimates = Mapping[str, Estimate]
Findings = Mapping[str, "Finding"]


@dataclass(frozen=True)
class Finding:
    """Verdict on one condition in one window: ``"present"``, ``"absent"`` or ``"cannot tell"``."""

    verdict: str
    reason: Reason
    teams: tuple[str, ...] = ()  # those of which a condition is present
    estimates: Estimates = field(default_factory=dict)  # the numbers that decide, if all are known
    by_run: tuple[str, ...] = ()  # verdict on each single run
    learned: Mapping[str, tuple[int, ...]] = field(default_factory=dict)
    """Where strength does not change: the opponents' generations that a team learned to beat."""


@dataclass(frozen=True, repr=False)
class Judgement(Readable):
    """What happened in a race, or in several `runs` with the same settings.

    In `windows`, the whole race and its halves, are findings by condition, with intervals of a
    `level`. A run has generations of both `teams` (`shape`), and so many `episodes` behind each
    cell, if known; they are equal in an `exact` game, without chance. Conditions that have no
    meaning in such a game are `refused`, each for a reason. `extras` are means of other numbers of
    a game, in the first and in the last third of the generations, among contemporaries. `leads` say
    how much better late generations of a team are than its generation 0, and by which generation
    that was learned: `measures.Lead`. In so many runs the last generation of a team `failed`: it is
    far weaker than those before, and gains leave it out.
    """

    runs: int
    shape: tuple[int, int]
    episodes: int | None
    level: float
    windows: Mapping[str, Findings]
    teams: tuple[str, str] = BOTH
    exact: bool = False
    refused: Mapping[str, Reason] = field(default_factory=dict)
    extras: Mapping[str, tuple[float, float]] = field(default_factory=dict)
    leads: Mapping[str, Lead] = field(default_factory=dict)
    failed: Mapping[str, int] = field(default_factory=dict)

    def _parts(self) -> Parts:
        return [sentence(self), judgement_cells(self)]

    @property
    def findings(self) -> Findings:
        """The findings on the whole race."""
        return self.windows[WHOLE]

    def present(self, window: str = "whole") -> tuple[str, ...]:
        """Return the conditions that are present in a window."""
        check_choice("window", window, self.windows)
        findings = self.windows[window]
        return tuple(name for name, found in findings.items() if found.verdict == PRESENT)

    @property
    def one_population(self) -> bool:
        """Whether one population plays both sides."""
        return self.teams[0] == self.teams[1]

    @property
    def gains(self) -> Estimates:
        """The gains of the teams over the whole race, by name; empty if they are not known."""
        return _gains_in(self.findings)

    def to_json(self) -> dict[str, Any]:
        """Return plain values that JSON can represent."""
        plain: dict[str, Any] = plain_values(self)
        return plain


class Words(NamedTuple):
    """What is said of a condition that is present: who `did` what; it `implies` another one."""

    who: str
    did: str
    implies: str = ""


class Event(NamedTuple):
    """What happened in a window, in words: `who` `did` what."""

    who: str
    did: str


WORDS: Mapping[str, Words] = {
    "disengagement": Words("{teams}", "won nearly all matches"),
    "arms race": Words("{teams}", "improved", "rise"),
    "one-sided progress": Words("only {teams}", "improved", "rise"),
    "rise": Words("{teams}", "ended stronger{too}"),
    "intransitivity": Words("no order of strength", "explains who beats whom"),
    "cycling": Words("{teams}", "went back to old strategies", "intransitivity"),
    "forgetting": Words("{teams}", "lost old skills ({sizes})", "intransitivity"),
    "stagnation": Words("neither team", "ended stronger or weaker{but}"),
}
"""All conditions by name, in the order of tables."""

CONDITIONS = tuple(WORDS)
"""Names of the conditions of a race of two teams, of which one wins what the other loses."""

OTHER_WORDS: Mapping[str, Words] = {
    "joint rise": Words("the mean of both sides", "rose by {joint} against contemporaries"),
    "joint fall": Words("the mean of both sides", "fell by {joint} against contemporaries"),
    "progress": Words("{teams}", "improved", "rise"),
}
"""Conditions of other games: with scores of both teams, and of one population."""
ORDER = (*OTHER_WORDS, *CONDITIONS)
"""Names of all conditions, in the order of tables."""

PROGRESS = ("progress", "arms race", "one-sided progress")
_OF_STRENGTH = frozenset(
    ("joint rise", "joint fall", "disengagement", *PROGRESS, "rise", "stagnation")
)
"""Conditions that say whether a team improved, or why that is not known."""
WHOLE = "whole"
HALVES = ("first half", "last half")
BOTH_HALVES = "both halves"
"""Where a sentence tells what is present in either half, and not known of the whole race."""
LEAST_LEAD = 0.05
"""A team has learned if its late generations are better than generation 0 by more than this."""


def sentence(judgement: Judgement) -> str:
    """Return what happened by a `judgement` in plain words: who improved, and what was lost.

    Such as ``"Both teams improved. From generation 15 on, the pursuers lost old skills (0.06)."``.
    It speaks of the whole race, and of a half where that surely differs. Where nobody is known to
    have improved it says first who had learned after few generations. Terminal, page, figures and
    reports all print it.
    """
    check_instance("judgement", judgement, Judgement)
    reason = next(iter(judgement.findings.values())).reason
    if reason.why is Why.TOO_SHORT:
        return f"Too short to be judged: {reason}."
    events = _events(judgement)
    told = {name for names in events.values() for name in names} & _OF_STRENGTH
    early = "" if told - {"stagnation"} else _learned_early(judgement)
    if early:  # in the first half
        if "stagnation" in events[BOTH_HALVES]:
            events[HALVES[1]]["stagnation"] = events[BOTH_HALVES].pop("stagnation")
        events[HALVES[0]].pop("stagnation", None)
    clauses = [
        _beginning(judgement, each) + _clause(events[each]) for each in events if events[each]
    ]
    if early and "stagnation" in events[WHOLE]:
        clauses[0] = f"{early}; after that {clauses[0]}"
    elif early and "stagnation" in events[HALVES[1]]:
        clauses = [early, *clauses]
    elif early:
        clauses = [f"{early}; after that {_no_progress(replace(judgement, runs=1))}", *clauses]
    elif told:
        clauses[0] = _of_runs(judgement) + clauses[0]
    elif clauses:
        clauses[0] = f"{_no_progress(judgement)}: {clauses[0]}"
    else:
        clauses = [_no_progress(judgement) + _are_better(judgement)]
    if told - {"stagnation"}:
        clauses += _failures(judgement)
    return " ".join(f"{clause[0].upper()}{clause[1:]}." for clause in clauses)


def clarity(judgement: Judgement) -> tuple[bool, float]:
    """Return how clearly a race shows who improved, for an order: the clearest is the largest.

    Whether anything of that is known, then the least gain that the worse team surely has.
    """
    is_known = any(
        not _OF_STRENGTH.isdisjoint(judgement.present(window)) for window in judgement.windows
    )
    gains = judgement.gains.values()
    return is_known, min((gain.low or 0.0 for gain in gains), default=0.0)


def _events(judgement: Judgement) -> dict[str, dict[str, Event]]:
    """Return what a sentence tells: of each window the conditions, and who did what."""
    events: dict[str, dict[str, Event]] = {w: {} for w in (WHOLE, BOTH_HALVES, *HALVES)}
    judged = judgement.findings
    for name in sorted(judged, key=lambda condition: condition not in _OF_STRENGTH):
        windows = _windows_of(judgement, name)
        told = [_happened(judgement, window, name) for window in windows]
        if len(told) == 2 and told[0] == told[1]:
            windows = [BOTH_HALVES]
            told = told[:1]
        for window, event in zip(windows, told, strict=True):
            events[window][name] = event
    return events


def _windows_of(judgement: Judgement, name: str) -> list[str]:
    """Return the windows of which a sentence tells a condition, if it is present there."""
    halves = [half for half in HALVES if name in _not_implied(judgement, half)]
    if name not in _not_implied(judgement, WHOLE):
        return halves
    # A half speaks for itself if the other one surely differs.
    verdicts = {judgement.windows[half][name].verdict for half in HALVES}
    return halves if halves and verdicts == {PRESENT, ABSENT} else [WHOLE]


def _not_implied(judgement: Judgement, window: str) -> list[str]:
    """Return the conditions that are present in a window, but those that another one implies.

    A team that improved is not said to have ended stronger, too.
    """
    implied: dict[str, set[str]] = {}
    for part, findings in judgement.windows.items():
        for name in judgement.present(part):
            implied.setdefault(_words(name).implies, set()).update(findings[name].teams)
    found = judgement.windows[window]
    return [
        name
        for name in judgement.present(window)
        if name not in implied or not implied[name].issuperset(found[name].teams)
    ]


def _words(name: str) -> Words:
    """Return what is said of a condition."""
    return WORDS[name] if name in WORDS else OTHER_WORDS[name]


def _happened(judgement: Judgement, window: str, name: str) -> Event:
    """Return in words who did what."""
    finding = judgement.windows[window][name]
    words = {
        **names_of(judgement.teams),
        "teams": _named(finding.teams, judgement.teams),
        "sizes": _sizes(finding, name),
        "but": _learned_to_beat(finding, judgement),
        "too": _in_a_jump(finding, judgement),
        "joint": _joint_size(finding),
    }
    if name == "stagnation" and judgement.one_population:
        did = "ended neither stronger nor weaker{but}"
        return Event(f"the {judgement.teams[0]}", did.format(**words))
    said = _words(name)
    return Event(said.who.format(**words), said.did.format(**words))


def _joint_size(finding: Finding) -> str:
    """Return by how much the mean of both sides changed; empty of another condition."""
    change = finding.estimates.get("joint_change")
    return "" if change is None else f"{abs(change.value):.2f}"


def _gains_in(findings: Findings) -> Estimates:
    """Return the gains that the findings on a window rest on, by name."""
    names = keys_of("gain").values()
    return {
        name: found.estimates[name]
        for found in findings.values()
        for name in names
        if name in found.estimates
    }


def _named(members: tuple[str, ...], teams: tuple[str, str]) -> str:
    """Return some of the teams as the subject of a sentence, in the words of a game."""
    if len(members) == 2:
        return "both teams"
    return listed(members, teams) if members else "one team"


def _sizes(finding: Finding, name: str) -> str:
    """Return the numbers of a condition for the teams of which it is present."""
    keys = keys_of(name)
    sizes = [finding.estimates.get(keys[team]) for team in finding.teams]
    return " and ".join(f"{size.value:.2f}" for size in sizes if size is not None)


def _learned_to_beat(finding: Finding, judgement: Judgement) -> str:
    """Return which opponents teams learned to beat, as the end of a clause; or ""."""
    names = names_of(judgement.teams)
    clauses = []
    for team, opponents in finding.learned.items():
        others = names["evaders" if team == "pursuers" else "pursuers"]
        whom = f"some generations of {others}"
        if len(opponents) == 1:
            whom = f"the {others} of generation {opponents[0]}"
        elif opponents:
            whom = f"{len(opponents)} generations of {others}"
        clauses.append(f"the {names[team]} learned to beat {whom}")
    return f", but {' and '.join(clauses)}" if clauses else ""


def _in_a_jump(finding: Finding, judgement: Judgement) -> str:
    """Return who ended stronger, too, but not by a sustained change; or ""."""
    if finding.reason.why is not Why.STRONGER_BUT:
        return ""
    who = _named(finding.reason.teams, judgement.teams)
    return f" ({who}, too, but mostly in a jump or with a setback)"


def _clause(events: Mapping[str, Event]) -> str:
    """Return who did what, naming each once: "both teams improved, but lost old skills"."""
    clause = ""
    last = ""
    improved = False
    for name, event in events.items():
        if improved and name not in _OF_STRENGTH:
            clause += ", but "
        elif clause:
            clause += " and "
        clause += event.did if event.who == last else f"{event.who} {event.did}"
        last = event.who
        improved = name in _OF_STRENGTH
    return clause


def _learned_early(judgement: Judgement) -> str:
    """Return who had learned after few generations, and how much; or ""."""
    learned = {t: lead for t, lead in _leading(judgement).items() if lead.reached is not None}
    if not learned:
        return ""
    last = max(lead.reached or 0 for lead in learned.values())
    when = "in generation 1" if last == 1 else f"by generation {last}"
    who, sizes = _who_leads(judgement, learned)
    return f"{_of_runs(judgement)}{who} learned {when} ({sizes} better than generation 0)"


def _are_better(judgement: Judgement) -> str:
    """Return whose late generations are better than generation 0, as the end of a clause."""
    leading = _leading(judgement)
    if not leading:
        return ""
    who, sizes = _who_leads(judgement, leading)
    return f", but {who} are better than in generation 0 ({sizes})"


def _leading(judgement: Judgement) -> dict[str, Lead]:
    """Return the leads of teams whose late generations surely are better than generation 0."""
    leads = judgement.leads.items()
    return {team: lead for team, lead in leads if (lead.size.low or 0.0) > LEAST_LEAD}


def _who_leads(judgement: Judgement, leads: Mapping[str, Lead]) -> tuple[str, str]:
    """Return in words whose leads these are, and how large."""
    one = f"the {judgement.teams[0]}" if judgement.one_population else ""
    sizes = " and ".join(f"{lead.size.value:.2f}" for lead in leads.values())
    return one or _named(tuple(leads), judgement.teams), sizes


def _beginning(judgement: Judgement, window: str) -> str:
    """Return a window in words, as the beginning of a clause about it."""
    if window in (WHOLE, BOTH_HALVES):
        return "in both halves, " if window == BOTH_HALVES else ""
    pursuers, evaders = judgement.shape
    is_first = window == HALVES[0]
    # The last half begins with the middle generation; teams of different length share no number.
    middle, last = "the middle", pursuers // 2 - 1
    if pursuers == evaders:
        middle = f"generation {last + 1}"
    if not is_first:
        return f"from {middle} on, "
    return "until the middle, " if middle == "the middle" else f"in generations 0 to {last}, "


def _failures(judgement: Judgement) -> list[str]:
    """Return of which teams the last generation failed, in how many runs."""
    names = names_of(judgement.teams)
    return [
        ("" if judgement.runs == 1 else f"in {count} of {judgement.runs} runs, ")
        + f"the last generation of the {names[team]} is far weaker than those before"
        for team, count in judgement.failed.items()
    ]


def _of_runs(judgement: Judgement) -> str:
    """Return of which runs a sentence speaks: of the mean, or of each of a few."""
    if judgement.runs == 1:
        return ""
    if judgement.runs < RUNS_FOR_T:
        return f"in each of {judgement.runs} runs, "
    return f"on average over {judgement.runs} runs, "


def _no_progress(judgement: Judgement) -> str:
    """Return that no team is known to have improved, and in which runs both did."""
    findings = judgement.findings
    runs = judgement.runs
    asked = [name for name in (*PROGRESS, "rise") if name in findings]
    nobody = f"the {judgement.teams[0]} did not improve"
    if not judgement.one_population:
        nobody = "neither team improved"
    if all(findings[name].verdict == ABSENT for name in asked):
        return f"{_of_runs(judgement)}{nobody}"
    if runs == 1:
        return "no clear progress"
    arms_race = findings.get("arms race")
    improved = arms_race.by_run.count(PRESENT) if arms_race else 0
    some = f" (in {improved} of them, both teams improved)" if improved else ""
    if runs < RUNS_FOR_T:
        return f"no clear progress that all {runs} runs share{some}"
    return f"no clear progress on average over {runs} runs{some}"


def judgement_table(judgement: Judgement) -> list[tuple[str, str, str, str]]:
    """Return the rows of a table of a `judgement`: condition, verdict, intervals, window.

    After the heads all findings on the whole race, then those that are present in a half only.
    """
    check_instance("judgement", judgement, Judgement)
    rows = [("condition", "verdict", f"{judgement.level:.0%} interval", "window")]
    for name, finding, window in _rows(judgement):
        numbers = ", ".join(
            f"{MEASURES[key].brief(judgement.teams)} {MEASURES[key].shown(estimate)}"
            for key, estimate in finding.estimates.items()
        )
        rows.append((name, finding.verdict, numbers, "whole race" if window == WHOLE else window))
    for name, (first, last) in judgement.extras.items():
        rows.append((name, "told", f"{first:.3g} at first, {last:.3g} in the end", "whole race"))
    if judgement.leads:
        rows.append(("lead over generation 0", "told", _leads(judgement), "whole race"))
    return rows


def _leads(judgement: Judgement) -> str:
    """Return the leads of both teams, and by which generation they were learned."""
    names, keys = names_of(judgement.teams), keys_of("lead")
    said = []
    for team, lead in judgement.leads.items():
        by = "" if lead.reached is None else f" by generation {lead.reached}"
        said.append(f"{names[team]} {MEASURES[keys[team]].shown(lead.size)}{by}")
    return ", ".join(said)


def _rows(judgement: Judgement) -> list[tuple[str, Finding, str]]:
    """Return condition, finding and window of what `judgement_table` lists."""
    in_whole = judgement.present(WHOLE)
    rows = [(name, finding, WHOLE) for name, finding in judgement.findings.items()]
    for half in HALVES:
        findings = judgement.windows[half]
        names = [name for name in judgement.present(half) if name not in in_whole]
        rows += [(name, findings[name], half) for name in names]
    return rows


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


def explain(judgement: Judgement) -> str:
    """Return the rows of `judgement_table` of a `judgement` as sentences, with reasons."""
    check_instance("judgement", judgement, Judgement)
    lines = []
    for name, finding, window in _rows(judgement):
        head = name.capitalize()
        if window != WHOLE:
            head += f" ({window})"
        reason = _reason(judgement, window, name)
        lines.append(f"{head}: {finding.verdict}, because {reason}.{_counts(finding.by_run)}")
    for name, why in judgement.refused.items():
        lines.append(f"{name.capitalize()}: not judged, because {why.in_words(judgement.teams)}.")
    return "\n".join(lines)


def _reason(judgement: Judgement, window: str, name: str) -> str:
    """Return why a verdict is what it is; of what is present who did what, and how much."""
    findings = judgement.windows[window]
    finding = findings[name]
    reason = finding.reason.in_words(judgement.teams)
    if finding.verdict == PRESENT:
        event = _happened(judgement, window, name)
        reason = f"{event.who} {event.did}: {reason}"
    if name != "rise":
        return reason
    improved = {team for each in PROGRESS if each in findings for team in findings[each].teams}
    rest = tuple(team for team in keys_of("gain") if team in improved - {*finding.teams})
    if not rest:
        return reason
    return f"{reason}; {_named(rest, judgement.teams)} improved, but perhaps by less"


def _counts(by_run: tuple[str, ...]) -> str:
    if len(by_run) == 1:
        return ""
    counts = ", ".join(
        f"{by_run.count(verdict)} {verdict}" for verdict in (PRESENT, ABSENT, CANNOT_TELL)
    )
    return f" Of the single runs: {counts}."
