"""Grades: which share of perfect play a player guarantees, in worlds that are solved exactly."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from matrixworld._util.readable import Parts, Readable, plain_values
from matrixworld._util.teams import PLURALS
from matrixworld.analysis.intervals import LEVEL, t_ends
from matrixworld.play.functions import Function
from matrixworld.play.player import Player, player, teams_of
from matrixworld.solver.guarantee import DRAWS, Guarantee, guarantee
from matrixworld.solver.losses import Loss, behaviour, losses, most_expensive
from matrixworld.solver.solution import best_response
from matrixworld.solver.suite import SUITE, Suite, SuiteWorld
from matrixworld.world.policy import Population, Team

LOSSES = 3
"""Positions that are shown."""
FEWEST_WORLDS = 5
"""Fewer worlds have no interval."""

READABLE: dict[Team, str] = {
    "pursuer": "max(0.6 * pressure, -adversary - 0.4 * unclaimed) - 0.1 * open_side",
    "evader": "adversary + 0.3 * exits",
}
"""For each team a program of one line as a mark. Neither was searched for in the suite's worlds."""


@dataclass(frozen=True)
class WorldGrade:
    """What a player guarantees in a world, in its own terms: captures, or escapes.

    Parameters
    ----------
    world : str
        Name of the world.
    in_turns : bool
        Whether agents or teams move in turns.
    perfect : float
        What perfect play guarantees.
    guarantees : float
        What the player guarantees against an opponent that knows it and sees the world.
    bounds : tuple of two float
        Bounds of `guarantees`: equal where it is exact.
    unread : float
        What it gets against perfect play that does not know it.
    """

    world: str
    in_turns: bool
    perfect: float
    guarantees: float
    bounds: tuple[float, float]
    unread: float

    @property
    def share(self) -> float:
        """The share of perfect play that it guarantees."""
        return self.guarantees / self.perfect


@dataclass(frozen=True)
class Mark:
    """A grade to compare with: of chance, of the best script, of a program of one line."""

    name: str
    share: float


@dataclass(frozen=True)
class TeamGrade:
    """What a player of a team guarantees in all worlds of a suite.

    Parameters
    ----------
    team : {"pursuer", "evader"}
        The team.
    kind : str
        What the player is.
    worlds : tuple of WorldGrade
        Its grade in each world.
    marks : tuple of Mark
        Shares of others.
    losses : tuple of Loss
        The positions in which it loses most, the most expensive one first.
    behaviour : str
        What it does, in a sentence.
    estimate : str
        Why it is an estimate; empty if it is exact.
    """

    team: Team
    kind: str
    worlds: tuple[WorldGrade, ...]
    marks: tuple[Mark, ...]
    losses: tuple[Loss, ...]
    behaviour: str
    estimate: str

    @property
    def share(self) -> float:
        """The mean share of perfect play that it guarantees: the grade."""
        return float(np.mean([each.share for each in self.worlds]))

    @property
    def interval(self) -> tuple[float, float] | None:
        """Student's 95 % interval of `share` over worlds, as if they were drawn; None for few."""
        if len(self.worlds) < FEWEST_WORLDS:
            return None
        return t_ends([each.share for each in self.worlds], LEVEL)

    @property
    def bounds(self) -> tuple[float, float]:
        """Mean shares of the bounds of the guarantees: equal if the grade is exact."""
        low, high = np.mean([np.array(each.bounds) / each.perfect for each in self.worlds], axis=0)
        return float(low), float(high)

    @property
    def in_turns(self) -> float | None:
        """The mean share in worlds in turns; None without any."""
        return _mean([each.share for each in self.worlds if each.in_turns])

    @property
    def at_once(self) -> float | None:
        """The mean share in worlds where all move at once; None without any."""
        return _mean([each.share for each in self.worlds if not each.in_turns])

    @property
    def unread(self) -> float:
        """The mean share that it gets against perfect play that does not know it."""
        return float(np.mean([each.unread / each.perfect for each in self.worlds]))

    def to_json(self) -> dict[str, Any]:
        """Return all of it as values that JSON can hold."""
        numbers = {
            name: getattr(self, name)
            for name in ("share", "interval", "bounds", "in_turns", "at_once", "unread")
        }
        plain: dict[str, Any] = plain_values({**numbers, **vars(self)})
        return plain


def _mean(values: list[float]) -> float | None:
    return float(np.mean(values)) if values else None


@dataclass(frozen=True, repr=False)
class Grade(Readable):
    """What a player guarantees, for each team that it plays for; ``print`` shows all of it.

    Parameters
    ----------
    player : str
        What the player is called.
    suite : str
        Name of the suite.
    version : int
        Its version; 0 for worlds of your own.
    teams : dict of str to TeamGrade
        The grades.
    """

    player: str
    suite: str
    version: int
    teams: dict[Team, TeamGrade] = field(default_factory=dict)

    def __repr__(self) -> str:
        shares = ", ".join(f"{PLURALS[team]} {each.share:.3f}" for team, each in self.teams.items())
        return f"<Grade of {self.player} in {self.suite}: {shares}>"

    def to_json(self) -> dict[str, Any]:
        """Return all of it as values that JSON can hold."""
        teams = {team: each.to_json() for team, each in self.teams.items()}
        return {"player": self.player, "suite": self.suite, "version": self.version, "teams": teams}

    def _parts(self) -> Parts:
        parts: list[Any] = []
        for each in self.teams.values():
            parts += _parts_of(self, each)
        return parts


def _parts_of(grade: Grade, of: TeamGrade) -> Parts:
    """Return what is shown of a team's grade: losses first, since they teach most."""
    version = f", version {grade.version}" if grade.version else ""
    title = f"{grade.player}, {of.kind}, as {PLURALS[of.team]} in {grade.suite}{version}"
    parts: list[Any] = [title, ""]
    if of.losses:
        parts.append(
            "Where it loses most of the capture rate, against an opponent that knows it (P, Q, R: "
            "pursuers; E, F: evaders):"
        )
        parts += [f"\n{number}. {loss}" for number, loss in enumerate(of.losses, 1)]
    else:
        parts.append("It plays perfectly: no position was found in which it loses.")
    parts += ["", of.behaviour, ""]
    numbers = {world.name: number for number, world in enumerate(SUITE.worlds, 1)}
    head = ["", "guarantees", "of", "share", "unread"]
    rows = []
    for each in of.worlds:
        shares = each.share, each.unread / each.perfect
        cells = [f"{number:.3f}" for number in (each.guarantees, each.perfect)]
        cells += [f"{share:.0%}" for share in shares]
        rows.append([f"{numbers.get(each.world, '')} {each.world}".strip(), *cells])
    parts += [[head, *rows], "", *_summary(of)]
    return parts


def _summary(of: TeamGrade) -> Iterator[str]:
    """Yield lines about the mean over all worlds."""
    ends = "" if of.interval is None else f" [{of.interval[0]:.3f}, {of.interval[1]:.3f}]"
    apart = [
        f"{words} {share:.3f}"
        for words, share in (("in turns", of.in_turns), ("all at once", of.at_once))
        if share is not None
    ]
    worlds = f"{len(of.worlds)} worlds" if len(of.worlds) > 1 else "1 world"
    how = "exactly"
    if of.estimate:
        how = f"estimated, without a bound ({of.estimate})"
    yield (
        f"Grade {of.share:.3f}{ends}: the share of perfect play that it guarantees against an "
        f"opponent that knows it, as a mean of {worlds}, {how}: {', '.join(apart)}."
    )
    yield f"Against perfect opponents that do not know it: {of.unread:.3f} of perfect play."
    yield "For comparison: " + ", ".join(f"{mark.share:.3f} {mark.name}" for mark in of.marks) + "."


Report = Callable[[str, int, int], None]
"""Called with what is graded, how many worlds are done, and of how many."""


def grade(
    given: Any,
    team: Team | None = None,
    *,
    worlds: Any = SUITE,
    name: str = "",
    fov: int | None = None,
    seconds: float | None = None,
    draws: int = DRAWS,
    seed: int = 0,
    report: Report | None = None,
) -> Grade:
    """Return what a player guarantees in solved worlds, as shares of perfect play.

    Parameters
    ----------
    given : player
        What `matrixworld.player` takes: a function, a file, a line of text, a genome, a script.
    team : {"pursuer", "evader"}, optional
        The team that is graded. The default is each that the player has: functions ``pursue`` and
        ``evade``, files and genomes say so; all others play for both.
    worlds : Suite or WorldConfig or sequence of them, optional
        The worlds. The default is `SUITE`, MW-25.
    name : str, optional
        What the player is called.
    fov : int, optional
        Side of the view that a function gets, odd. The default is that of the worlds. Genomes are
        graded with their own.
    seconds : float, optional
        Longest time of one call of a function, where alarm signals exist. The default is none.
    draws, seed : int, optional
        As for `solver.guarantee`, of functions that are estimated.
    report : callable, optional
        Called before each world with the player's name, how many worlds are done, and of how many.

    Returns
    -------
    Grade
        Guarantees of each team by world, the positions in which it loses most, and marks.

    Raises
    ------
    NotExactError, PlayerError, TypeError, ValueError
        As `player` and `solver.guarantee` do.

    Examples
    --------
    >>> import matrixworld as mw
    >>> found = mw.grade("-adversary", "pursuer")
    >>> print(f"{found.teams['pursuer'].share:.2f}")
    0.63
    """
    suite = Suite.of(worlds)
    teams = (team,) if team is not None else teams_of(given, seconds=seconds)
    players = {each: player(given, each, name=name, fov=fov, seconds=seconds) for each in teams}
    grades: dict[Team, TeamGrade] = {}
    done = 0
    for each, plays in players.items():
        found: list[tuple[Guarantee, SuiteWorld]] = []
        for world in suite.worlds:
            if report is not None:
                report(plays.name, done, len(players) * len(suite.worlds))
            placed = world.with_fov(_fov_in(plays, world))
            found.append((guarantee(placed.perfect, plays, each, draws=draws, seed=seed), placed))
            done += 1
        grades[each] = _graded(plays, found, suite)
    if report is not None:
        report(plays.name, done, done)
    return Grade(next(iter(players.values())).name, suite.name, suite.version, grades)


def _fov_in(plays: Player, world: SuiteWorld) -> int:
    """Return the view that a player has in a world: genomes have their own."""
    made = plays.made(world.config)
    fov: int = made.policy.fov if isinstance(made, Population) else world.config.fov
    return fov


def _kind_of(plays: Player, world: SuiteWorld) -> str:
    """Return what a player is; of a file, the function in it."""
    made = plays.at(world.config)
    return made.form if isinstance(made, Function) else plays.kind


def _graded(plays: Player, found: list[tuple[Guarantee, SuiteWorld]], suite: Suite) -> TeamGrade:
    team = plays.team
    of_worlds = tuple(_world_grade(one, world, team) for one, world in found)
    return TeamGrade(
        team,
        _kind_of(plays, found[0][1]),
        of_worlds,
        _marks(suite, team),
        tuple(most_expensive((losses(one, world, team) for one, world in found), LOSSES)),
        behaviour((one for one, _ in found), team),
        next((one.reason for one, _ in found if one.reason), ""),
    )


def _world_grade(one: Guarantee, world: SuiteWorld, team: Team) -> WorldGrade:
    captured = team == "pursuer"
    low, high = (one.low, one.high) if captured else (1 - one.high, 1 - one.low)
    perfect, unread = (world.value, one.unread) if captured else (1 - world.value, 1 - one.unread)
    if perfect <= 0:
        expected = f"worlds in which perfect {PLURALS[team]} get something"
        raise ValueError(f"worlds: expected {expected}, got {world.name}")
    return WorldGrade(world.name, world.in_turns, perfect, (low + high) / 2, (low, high), unread)


def _marks(suite: Suite, team: Team) -> tuple[Mark, ...]:
    """Return the shares of chance, of the best script and of the readable program."""
    if team not in suite.marks:
        shares: dict[str, list[float]] = {}
        for world in suite.worlds:
            line = READABLE[team]
            response = best_response(world.perfect.states, line, team).value
            for name, rate in {**world.scripts(team), f"'{line}'": response}.items():
                got = rate / world.value if team == "pursuer" else (1 - rate) / (1 - world.value)
                shares.setdefault(name, []).append(got)
        everywhere = {
            n: float(np.mean(s)) for n, s in shares.items() if len(s) == len(suite.worlds)
        }
        readable = everywhere.pop(f"'{READABLE[team]}'")
        best = max(everywhere, key=lambda name: everywhere[name])
        suite.marks[team] = (
            Mark("chance", everywhere["random"]),
            Mark(f"the best script ({best})", everywhere[best]),
            Mark(f"the line {READABLE[team]}", readable),
        )
    found: tuple[Mark, ...] = suite.marks[team]
    return found
