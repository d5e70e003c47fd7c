"""``matrixworld grade``: what players guarantee in solved worlds, and where they lose most."""

from __future__ import annotations

import os
import sys
import threading
import time
from collections.abc import Sequence
from dataclasses import dataclass
from multiprocessing import get_context
from multiprocessing.connection import Connection
from pathlib import Path
from typing import Any

import click

from matrixworld._util.alarms import busy_for
from matrixworld._util.files import one_line
from matrixworld.cli import console, options
from matrixworld.cli.setting_options import usage_errors
from matrixworld.coevolution import Progress, ProgressBar
from matrixworld.coevolution.runs.places import find_runs
from matrixworld.play.player import PythonFile, is_folder
from matrixworld.solver.grade import Grade, grade
from matrixworld.solver.suite import SUITE, Suite
from matrixworld.world.policy import SCRIPTS, TEAMS, Team

WHAT = "What the numbers mean: docs/suite.md."
BEAT = 1.0
"""Seconds between signs of life of the process that runs programs."""
SILENT = 15.0
"""Seconds without one after which it is ended: a call has been made that nothing interrupts."""
GRACE = 3.0
"""Seconds after the longest time of a call in which its program can end it."""
LONGEST = 900.0
"""Seconds after which the grading of a program is ended, whatever it does."""


@click.command("grade", context_settings={"ignore_unknown_options": True})
@click.argument("players", nargs=-1, required=True, metavar="PLAYER...")
@click.option(
    "--team",
    type=click.Choice(TEAMS),
    help="grade it for this team only; default: each team that it has",
)
@click.option(
    "--world",
    "chosen",
    multiple=True,
    metavar="NUMBER",
    help=f"grade in this world of {SUITE.name} only, 1 to {len(SUITE.worlds)}; may be given again",
)
@click.option("--fov", type=int, help="side of the view that functions get, odd; default: 11")
@options.integer(
    "--seconds", "longest time of one call of a program, in seconds", most=3600, default=5
)
@options.shared("json", "force")
def grade_command(
    players: tuple[str, ...],
    team: Team | None,
    chosen: tuple[str, ...],
    fov: int | None,
    seconds: int,
    json_file: Path | None,
    force: bool,
) -> None:
    """Say what share of perfect play players guarantee, and where they lose most.

    PLAYER is a file of Python with a function pursue or evade, a file of play.save_genome (.npz), a
    line of text or a file of one (.txt), a script, or a run directory (its last generation). Files
    of Python are run, with your rights: grade those that you trust.

    Each is graded in 25 small solved worlds (docs/suite.md): against an opponent that knows the
    player and sees everything, so that no other opponent can do better. The numbers are exact, but
    for functions whose draws cannot be followed, which are estimated and said to be.

    \b
    Examples:
      matrixworld grade anna.py
      matrixworld grade "0.3 * teammate - adversary" --team pursuer
      matrixworld grade anna.py ben.py chaser --json grades.json
    """
    options.check_outputs(json_file, force=force)
    suite = _suite_of(chosen)
    for given in players:
        if given and given not in SCRIPTS and is_folder(given) and not find_runs(Path(given)):
            raise click.UsageError(
                f"{given}: expected a file, a line of text or a run directory, got a directory "
                "without a run; name the files in it one by one"
            )
    grades: dict[str, Grade] = {}
    failures: list[str] = []
    with (
        console.warnings_as_notes(),
        usage_errors(),
        ProgressBar(after=1.0) as bar,
        _Programs(suite, team, fov, seconds) as programs,
    ):
        for number, given in enumerate(players):

            def report(name: str, done: int, total: int, number: int = number) -> None:
                parts = total * len(players)
                bar(Progress(f"grading {name}", number * total + done, parts))

            try:
                grades[given] = _graded(given, suite, team, fov, programs, report)
            except (OSError, TypeError, ValueError, _ProgramError) as error:
                name, told = one_line(given), str(error)
                failures.append(told if Path(name).name in told else f"{name}: {told}")
                if len(players) > 1:
                    console.note(failures[-1])
    if len(players) == 1:
        for found in grades.values():
            console.say(f"\n{found}")
    elif grades:
        _print_table(list(grades.values()))
    if grades:
        console.say(f"\n{WHAT}")
        plain = [found.to_json() for found in grades.values()]
        options.write_json(json_file, {"grades": plain})
    if len(players) == 1 and failures:
        raise click.ClickException(failures[0])
    if failures:
        count = f"{len(failures)} of {len(players)} players"
        raise click.ClickException(f"{count} have no grade: see above")


def _suite_of(chosen: Sequence[str]) -> Suite:
    """Return the suite, or the worlds of it that are chosen by their numbers."""
    if not chosen:
        return SUITE
    worlds = []
    for text in chosen:
        if not text.isdecimal() or not 1 <= int(text) <= len(SUITE.worlds):
            expected = f"a number from 1 to {len(SUITE.worlds)}"
            raise click.UsageError(f"--world: expected {expected}, got {text}")
        worlds.append(SUITE.worlds[int(text) - 1])
    return Suite(f"{len(worlds)} of the worlds of {SUITE.name}", SUITE.version, tuple(worlds))


def _print_table(grades: Sequence[Grade]) -> None:
    """Print the grades of several players, the best ones first."""
    for team in TEAMS:
        of_team = [(each.player, each.teams[team]) for each in grades if team in each.teams]
        if not of_team:
            continue
        of_team.sort(key=lambda one: -one[1].share)
        rows = [["", "share of perfect play", "95 %", "in turns", "at once", "unread", ""]]
        for name, found in of_team:
            ends = "" if found.interval is None else "{:.3f} .. {:.3f}".format(*found.interval)
            means = (found.share, found.in_turns, found.at_once, found.unread)
            share, *others = ["" if mean is None else f"{mean:.3f}" for mean in means]
            rows.append([name, share, ends, *others, "estimated" if found.estimate else ""])
        console.print_head(f"{team}s, by what they guarantee")
        console.print_table(rows, "<>>>>><")
        marks = ", ".join(f"{mark.share:.3f} {mark.name}" for mark in of_team[0][1].marks)
        console.print_wrapped(f"For comparison: {marks}. Where one loses most: grade it alone.")


def _graded(
    given: str, suite: Suite, team: Team | None, fov: int | None, programs: _Programs, report: Any
) -> Grade:
    """Return the grade of a player; one that is a program is graded in a process of its own."""
    if Path(given).suffix == ".py" and not Path(given).is_dir():
        return programs.grade(PythonFile.read(given), report)
    return grade(given, team, worlds=suite, fov=fov, report=report)


# ---- Programs, which may hang or end Python ------------------------------------------------------


class _ProgramError(RuntimeError):
    """A program has ended the process that runs it, or has not come to an end."""


@dataclass
class _Programs:
    """What grades programs in another process, which is made anew if one of them ends it."""

    suite: Suite
    team: Team | None
    fov: int | None
    seconds: float
    _process: Any = None
    _connection: Connection | None = None
    _noted: bool = False

    def __enter__(self) -> _Programs:
        return self

    def __exit__(self, *error: object) -> None:
        self._end()

    def grade(self, file: PythonFile, report: Any) -> Grade:
        """Return the grade of a program; what it raises, or _ProgramError."""
        if not self._noted:
            console.note(f"{file.name}: its program is run on this machine, with your rights")
            self._noted = True
        if self._process is None:
            self._begin()
        assert self._connection is not None
        self._connection.send(file)
        began = time.monotonic()
        while True:
            if time.monotonic() - began > LONGEST:
                self._end()
                raise _ProgramError(f"{file.name}: expected a grade within {LONGEST:g} s, got none")
            kind, *answer = self._answer(file.name)
            if kind == "progress":
                report(*answer)
            elif kind == "failed":
                raise ValueError(*answer)
            elif kind == "ends":
                self._end()
                raise _ProgramError(*answer)
            elif kind == "graded":
                found: Grade = answer[0]
                return found

    def _answer(self, name: str) -> tuple[Any, ...]:
        """Return the next message of the process."""
        assert self._connection is not None
        if not self._connection.poll(SILENT):
            self._end()
            raise _ProgramError(
                f"{name}: expected an answer within {SILENT:g} s, got none: a call inside of it "
                "cannot be interrupted"
            )
        try:
            message: tuple[Any, ...] = self._connection.recv()
        except EOFError:
            self._process.join()
            code = self._process.exitcode
            self._end()
            raise _ProgramError(f"{name}: it has ended Python, with exit code {code}") from None
        return message

    def _begin(self) -> None:
        context = get_context("spawn")
        self._connection, theirs = context.Pipe()
        arguments = (theirs, [*map(SUITE.worlds.index, self.suite.worlds)], self.suite.name)
        rest = (self.team, self.fov, self.seconds)
        self._process = context.Process(target=_work, args=(*arguments, *rest), daemon=True)
        self._process.start()
        theirs.close()

    def _end(self) -> None:
        if self._process is not None:
            self._process.kill()
            self._process.join()
        self._process = self._connection = None


def _work(
    connection: Connection,
    worlds: list[int],
    name: str,
    team: Team | None,
    fov: int | None,
    seconds: float,
) -> None:
    """Grade programs, until the connection is closed."""
    os.dup2(sys.stderr.fileno(), sys.stdout.fileno())  # what programs print is no result
    suite = Suite(name, SUITE.version, tuple(SUITE.worlds[number] for number in worlds))
    sending = threading.Lock()
    name_of_file = ""

    def send(*message: Any) -> None:
        with sending:
            try:
                connection.send(message)
            except OSError:  # the command has ended
                os._exit(1)

    def beat() -> None:
        while True:
            time.sleep(BEAT)
            send("alive")
            if busy_for() > seconds + GRACE:
                frame = sys._current_frames()[threading.main_thread().ident or 0]
                while frame.f_back and frame.f_code.co_filename != name_of_file:
                    frame = frame.f_back
                told = f"expected an answer within {seconds:g} s, got none, and it goes on"
                send("ends", f"{name_of_file}, line {frame.f_lineno}: {told}")

    threading.Thread(target=beat, daemon=True).start()
    while True:
        try:
            file = connection.recv()
        except EOFError:
            return
        name_of_file = file.name
        try:
            found = grade(
                file, team, worlds=suite, fov=fov, seconds=seconds,
                report=lambda *progress: send("progress", *progress),
            )  # fmt: skip
        except (TypeError, ValueError) as error:
            send("failed", str(error))
        else:
            send("graded", found)
