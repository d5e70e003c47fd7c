"""Judgements: the findings on a race, and what they say in a sentence and a table."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any, NamedTuple

from matrixworld._util.checks import check_choice, check_instance
from matrixworld._util.readable import Parts, Readable, plain_values
from matrixworld.analysis.intervals import RUNS_FOR_T, Estimate
from matrixworld.analysis.measures import MEASURES, TOO_SHORT
from matrixworld.analysis.payoffs import TEAMS, in_words_of

PRESENT, ABSENT, CANNOT_TELL = "present", "absent", "cannot tell"

Estimates = Mapping[str, Estimate]
Findings = Mapping[str, "Finding"]


@dataclass(frozen=True)
class Finding:
    """Verdict on one condition in one window: ``"present"``, ``"absent"`` or ``"cannot tell"``."""

    verdict: str
    reason: str  # a clause after "because"
    teams: tuple[str, ...] = ()  # those of which a condition is present
    estimates: Estimates = field(default_factory=dict)  # the numbers that decide, if all are known
    by_run: tuple[str, ...] = ()  # verdict on each single run


@dataclass(frozen=True, repr=False)
class Judgement(Readable):
    """What happened in a race, or in several `runs` with the same settings.

    In `windows`, the whole race and its halves, are findings by condition, with intervals of a
    `level`. A run has generations of both `teams` (`shape`), and so many `episodes` behind each
    cell, if known; they are equal in an `exact` game, without chance.
    """

    runs: int
    shape: tuple[int, int]
    episodes: int | None
    level: float
    windows: Mapping[str, Findings]
    teams: tuple[str, str] = TEAMS
    exact: bool = False

    def _parts(self) -> Parts:
        return [sentence(self), judgement_cells(self)]

    @property
    def findings(self) -> Findings:
        """The findings on the whole race."""
        return self.windows[WHOLE]

    def present(self, window: str = "whole") -> tuple[str, ...]:
        """Return the conditions that are present in a window."""
        check_choice("window", window, self.windows)
        found = self.windows[window]
        return tuple(name for name in CONDITIONS if found[name].verdict == PRESENT)

    def to_json(self) -> dict[str, Any]:
        """Return plain values that JSON can represent."""
        plain: dict[str, Any] = plain_values(self)
        return plain


class Words(NamedTuple):
    """What is told of a condition that is present: who `did` what; it `implies` another one."""

    who: str
    did: str
    implies: str = ""


WORDS: Mapping[str, Words] = {
    "disengagement": Words("{teams}", "won nearly all matches"),
    "arms race": Words("{teams}", "improved", "rise"),
    "one-sided progress": Words("only {teams}", "improved", "rise"),
    "rise": Words("{teams}", "became stronger{doubt}"),
    "intransitivity": Words("no order of strength", "explains who beats whom"),
    "cycling": Words("{teams}", "went back to old strategies", "intransitivity"),
    "forgetting": Words("{teams}", "lost old skills ({sizes})", "intransitivity"),
    "stagnation": Words("neither team", "became stronger or weaker"),
}
"""All conditions by name, in the order of tables."""

CONDITIONS = tuple(WORDS)
"""Names of the conditions."""

PROGRESS = ("arms race", "one-sided progress")
OF_STRENGTH = ("disengagement", *PROGRESS, "rise", "stagnation")
"""Conditions that say whether a team improved, or why that is not known."""
NO_GAIN = Estimate(0.0)
WHOLE, *HALVES = ("whole", "first half", "last half")


def sentence(judgement: Judgement) -> str:
    """Return what happened by a `judgement` in plain words: who improved, and what was lost.

    Such as ``"Both teams improved. From generation 15 on, the pursuers lost old skills (0.06)."``.
    It speaks of the whole race, and of a half where that surely differs. Terminal, page, figures
    and reports all print it.
    """
    check_instance("judgement", judgement, Judgement)
    if judgement.findings["arms race"].reason == TOO_SHORT:
        return f"Too short to be judged: {TOO_SHORT}."
    told = {at: each for at in (WHOLE, *HALVES) if (each := _told(judgement, at))}
    parts = [_at(judgement, at) + _clause(each) for at, each in told.items()]
    if {*OF_STRENGTH} & {name for each in told.values() for name in each}:
        parts[0] = _of_runs(judgement) + parts[0]
    else:
        parts[:1] = [": ".join([_no_progress(judgement), *parts[:1]])]
    said = (f"{part[0].upper()}{part[1:]}." for part in parts)
    return in_words_of(judgement.teams, " ".join(said))


def clarity(judgement: Judgement) -> tuple[bool, float]:
    """Return how clearly a race shows who improved, for an order: the clearest is the largest.

    Whether anything of that is known, then the least gain that the worse team surely has.
    """
    told = any({*OF_STRENGTH} & {*judgement.present(window)} for window in judgement.windows)
    gains = judgement.findings["arms race"].estimates.values()
    return told, min((gain.low or 0.0 for gain in gains), default=0.0)


def _told(judgement: Judgement, window: str) -> dict[str, tuple[str, str]]:
    """Return what is told of a window: conditions, and who did what."""
    present = {at: _present(judgement, at) for at in judgement.windows}
    told = {}
    for name in sorted(CONDITIONS, key=lambda each: each not in OF_STRENGTH):
        halves = [half for half in HALVES if name in present[half]]
        verdicts = {judgement.windows[half][name].verdict for half in HALVES}
        if name in present[WHOLE]:
            # A half speaks for itself if the other one surely differs.
            places = halves if verdicts == {PRESENT, ABSENT} else [WHOLE]
        else:
            places = halves
        words = [_happened(judgement.windows[at], name) for at in places]
        if len({*words}) < len(words):  # the same in both halves
            places = [WHOLE]
        if window in places:
            told[name] = words[places.index(window)]
    return told


def _present(judgement: Judgement, window: str) -> list[str]:
    """Return the conditions that are present in a window and that nothing told implies."""
    every = {name for at in judgement.windows for name in judgement.present(at)}
    implied = {WORDS[name].implies for name in every}
    return [name for name in judgement.present(window) if name not in implied]


def _happened(findings: Findings, name: str) -> tuple[str, str]:
    """Return in words who did what."""
    finding, gains = findings[name], findings["arms race"].estimates
    sizes = [finding.estimates.get(f"{team[:-1]}_{name}") for team in finding.teams]
    known = {team: gains.get(f"{team[:-1]}_gain", NO_GAIN) for team in finding.teams}
    vague = tuple(team for team, gain in known.items() if (gain.low or 0.0) <= 0.0)
    doubt = "without a clear trend" if vague else ""
    if vague != finding.teams:
        doubt = doubt and f"({_named(vague)} {doubt})"
    words = {
        "teams": _named(finding.teams),
        "sizes": " and ".join(f"{size.value:.2f}" for size in sizes if size),
        "doubt": doubt and f" {doubt}",
    }
    return WORDS[name].who.format(**words), WORDS[name].did.format(**words)


def _named(teams: tuple[str, ...]) -> str:
    return "both teams" if len(teams) == 2 else f"the {teams[0]}" if teams else "one team"


def _clause(told: Mapping[str, tuple[str, str]]) -> str:
    """Return who did what, naming each once: "both teams improved, but lost old skills"."""
    clause, last, improved = "", "", False
    for name, (who, did) in told.items():
        joint = ", but " if improved and name not in OF_STRENGTH else " and " if clause else ""
        clause += f"{joint}{did if who == last else f'{who} {did}'}"
        last, improved = who, name in OF_STRENGTH
    return clause


def _at(judgement: Judgement, window: str) -> str:
    """Return a window in words, as the beginning of a clause about it."""
    pursuers, evaders = judgement.shape
    # The last half begins with the middle generation; teams of different length share no number.
    first = window == HALVES[0]
    middle = f"generation {pursuers // 2 - first}" if pursuers == evaders else "the middle"
    return "" if window == WHOLE else f"until {middle}, " if first else f"from {middle} on, "


def _of_runs(judgement: Judgement) -> str:
    """Return of which runs a sentence speaks: of the mean, or of each of a few."""
    if judgement.runs == 1:
        return ""
    each = judgement.runs < RUNS_FOR_T
    return f"{'in each of' if each else 'on average over'} {judgement.runs} runs, "


def _no_progress(judgement: Judgement) -> str:
    """Return that no team is known to have improved, and in which runs both did."""
    whole, runs = judgement.findings, judgement.runs
    if {whole[name].verdict for name in (*PROGRESS, "rise")} == {ABSENT}:
        return f"{_of_runs(judgement)}neither team improved"
    if runs == 1:
        return "no clear progress"
    improved = whole["arms race"].by_run.count(PRESENT)
    some = f" (in {improved} of them, both teams improved)" if improved else ""
    if runs < RUNS_FOR_T:
        return f"no clear progress that all {runs} runs share{some}"
    return f"no clear progress on average over {runs} runs{some}"


def judgement_table(judgement: Judgement) -> list[tuple[str, str, str, str]]:
    """Return the rows of a table of a `judgement`: condition, verdict, intervals, window.

    After the heads all findings on the whole race, then those that are present in a half only.
    """
    told = _rows(judgement)
    rows = [("condition", "verdict", f"{judgement.level:.0%} interval", "window")]
    for name, finding, window in told:
        numbers = ", ".join(
            f"{MEASURES[key].short or MEASURES[key].label} {MEASURES[key].shown(estimate)}"
            for key, estimate in finding.estimates.items()
        )
        numbers = in_words_of(judgement.teams, numbers)
        rows.append((name, finding.verdict, numbers, "whole race" if window == WHOLE else window))
    return rows


def _rows(judgement: Judgement) -> list[tuple[str, Finding, str]]:
    """Return condition, finding and window of what `judgement_table` lists."""
    check_instance("judgement", judgement, Judgement)
    return [
        (name, judgement.windows[at][name], at)
        for at in judgement.windows
        for name in (CONDITIONS if at == WHOLE else judgement.present(at))
        if at == WHOLE or name not in judgement.present()
    ]


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
    lines = "\n".join(
        f"{name.capitalize()}{'' if window == WHOLE else f' ({window})'}: "
        f"{finding.verdict}, because {finding.reason}.{_counts(finding.by_run)}"
        for name, finding, window in _rows(judgement)
    )
    return in_words_of(judgement.teams, lines)


def _counts(by_run: tuple[str, ...]) -> str:
    if len(by_run) == 1:
        return ""
    counts = ", ".join(f"{by_run.count(each)} {each}" for each in (PRESENT, ABSENT, CANNOT_TELL))
    return f" Of the single runs: {counts}."
