"""Who may play: every submission is read, loaded and tried before the tournament begins."""

from __future__ import annotations

from collections.abc import Sequence

from matrixworld._util.reading import DamagedFileError
from matrixworld.classroom.genome_file import genome_of
from matrixworld.classroom.match import FailedError
from matrixworld.classroom.policy_process import FUNCTIONS
from matrixworld.classroom.referee import Referee
from matrixworld.classroom.seat import RefusedError
from matrixworld.classroom.submissions import (
    Entry,
    Refusal,
    Submission,
    without_path,
    without_rivals,
)
from matrixworld.coevolution.progress import Report
from matrixworld.coevolution.types import TEAMS
from matrixworld.play import check_fits
from matrixworld.world.policy import Script

TRIAL_OPPONENT: Script = "random"
"""The script against which every program plays an episode first."""

Admitted = tuple[list[Entry], list[Refusal]]


def admit(submissions: Sequence[Submission], referee: Referee, report: Report) -> Admitted:
    """Return the entries of submissions, and what is refused.

    Parameters
    ----------
    submissions : sequence of Submission
        What was handed in.
    referee : Referee
        Plays the trials.
    report : callable
        Called as ``report(what, done, total)``.

    Returns
    -------
    entries : list of Entry
        At most one for each student and team, in the order of the submissions.
    refusals : list of Refusal
        Why the others do not play.
    """
    entries: list[Entry] = []
    refusals: list[Refusal] = []
    tried = referee.executor.map(lambda each: _entries_of(each, referee), submissions)
    for number, (found, refused) in enumerate(tried, 1):
        entries += found
        refusals += refused
        report("trials", number, len(submissions))
    kept, rivals = without_rivals(entries)
    return kept, refusals + rivals


def _entries_of(submission: Submission, referee: Referee) -> Admitted:
    """Return the entries of one submission, or why it is refused."""
    try:
        if submission.kind == "genome":
            return [_genome(submission, referee)], []
        return _program(submission, referee)
    except RefusedError as error:
        return [], [Refusal(submission.name, submission.file, str(error))]


def _genome(submission: Submission, referee: Referee) -> Entry:
    """Read a genome; RefusedError if it is damaged or does not fit the world."""
    try:
        team, population = genome_of(submission.path, submission.content)
        check_fits("genome", population.network, referee.config)
    except DamagedFileError as error:
        raise RefusedError(without_path(error)) from error
    except ValueError as error:
        raise RefusedError(str(error)) from error
    return Entry(submission.name, team, "genome", submission.file, population)


def _program(submission: Submission, referee: Referee) -> Admitted:
    """Load a program, and let it play for each team for which it has a function."""
    if referee.problem:
        raise RefusedError(f"programs are not played here: {referee.problem}")
    present = referee.functions(submission.content)
    if not any(present):
        raise RefusedError("expected a function pursue(view, rng) or evade(view, rng), got none")
    entries: list[Entry] = []
    refusals: list[Refusal] = []
    for team, is_present in zip(TEAMS, present, strict=True):
        if not is_present:
            continue
        entry = Entry(submission.name, team, "program", submission.file, submission.content)
        try:
            _try(entry, referee)
            entries.append(entry)
        except FailedError as error:
            refusals.append(Refusal(entry.name, entry.file, reason_of(entry, error)))
    return entries, refusals


def _try(entry: Entry, referee: Referee) -> None:
    """Play one episode; FailedError if the program fails."""
    opponents = {team: Entry(TRIAL_OPPONENT, team, "script", "", TRIAL_OPPONENT) for team in TEAMS}
    sides = {**opponents, entry.team: entry}
    referee.match(sides["pursuer"], sides["evader"], 1)


def reason_of(entry: Entry, error: FailedError) -> str:
    """Return why an entry is refused, beginning with its function."""
    text = str(error)
    function = FUNCTIONS[entry.team]
    return text if text.startswith(f"{function} ") else f"{function}: {text}"
