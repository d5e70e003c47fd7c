"""Worlds drawn as text, so that a case of the rules can be read at a glance.

A drawing has its rows on lines or between slashes and its cells between spaces: ``.`` free,
``#`` obstacle, a letter for an agent.  ``A B C`` are pursuers 0, 1, 2 and ``a b c`` evaders
0, 1, 2; several on one cell are written together (``AB``, ``Aa``, ``#A``), and an agent that
is missing is gone.  Moves are ``"A> b^"``, or ``A↗`` on a diagonal; agents not named stay.
"""

import warnings
from collections import Counter
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
import pytest

import matrixworld as mw
from reference import KINDS, ReferenceWorld, records

Cell = tuple[int, int]
Cells = Sequence[Sequence[int]]
World = mw.World | ReferenceWorld
Start = Callable[[mw.WorldConfig, Cells, Cells, np.ndarray], World]

OUTCOMES = {"D": mw.Outcome.DISAPPEAR, "R": mw.Outcome.REACH, "B": mw.Outcome.BOUNCE}
CAPTURES = {"occupation": mw.Capture.OCCUPATION, "surround": mw.Capture.SURROUND}
INTERACTIONS = {
    "simultaneous": mw.Interaction.SIMULTANEOUS,
    "swarm turns": mw.Interaction.SWARM_TURNS,
    "agent turns": mw.Interaction.AGENT_TURNS,
}
ARROWS = {"^": 1, ">": 2, "v": 3, "<": 4, "↗": 5, "↘": 6, "↙": 7, "↖": 8}
# Numbers chosen so that sums of a few of them differ: a wrong sum shows which part is wrong.
UNITS = mw.Rewards(
    pursuer_capture=1000,
    evader_capture=-2000,
    pursuer_neighbor=3,
    evader_neighbor=-5,
    pursuer_collide=-70,
    evader_collide=-110,
    pursuer_step=-0.25,
    evader_step=-0.5,
)


def rules(
    interaction="simultaneous",
    *,
    obstacle="B",
    teammate="R",
    adversary="BR",
    capture="surround",
    disappear=False,
):
    """Return a row of rules; ``adversary`` is the evader's outcome, then the pursuer's."""
    return mw.Rules(
        interaction=INTERACTIONS[interaction],
        obstacle=OUTCOMES[obstacle],
        teammate=OUTCOMES[teammate],
        evader=OUTCOMES[adversary[0]],
        pursuer=OUTCOMES[adversary[1]],
        capture=CAPTURES[capture],
        captured_disappear=disappear,
    )


def quiet_config(**fields):
    """Return a config with ``UNITS`` as rewards, without a warning if it cannot capture."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        return mw.WorldConfig(**{"rewards": UNITS, **fields})


def conflict(kind_and_form, agents, cell, *, held="", doomed="", fault="", turn=0):
    """Return an expected conflict; ``kind_and_form`` is like ``"teammate vertex"``."""
    kind, form = kind_and_form.split()
    return turn, kind, form, agents, cell, fault, held, doomed


@dataclass(frozen=True)
class Play:
    """One step and its expected results; ``None`` is not checked.

    ``fault`` and ``involved`` are like ``"obstacle A; teammate AB"``, ``paid`` is like
    ``"A: capture step; a: step"`` (agents left out earn nothing), ``captors`` like ``"a2 b1"``.
    ``ever`` is by default all evaders captured in the plays so far.
    """

    moves: str
    after: str
    captured: str = ""
    ever: str | None = None
    captors: str | None = None
    fault: str | None = None
    involved: str | None = None
    conflicts: list[tuple] | None = None
    paid: str | None = None
    ended: bool = False


@dataclass(frozen=True)
class Case:
    name: str
    rules: mw.Rules | str
    before: str
    plays: tuple[Play, ...]
    changes: dict[str, Any] = field(default_factory=dict)


def case(name, rules, before, *plays, **changes):
    return Case(name, rules, before, plays, changes)


def table(*cases):
    return pytest.mark.parametrize("case", [pytest.param(c, id=c.name) for c in cases])


class Drawing:
    """A parsed drawing: ``obstacles`` and the cell of each letter."""

    def __init__(self, text):
        lines = text.replace("/", "\n").strip().splitlines()
        rows = [line.split() for line in lines]
        self.obstacles = np.array([["#" in token for token in row] for row in rows])
        self.cells = {
            letter: (r, c)
            for r, row in enumerate(rows)
            for c, token in enumerate(row)
            for letter in token
            if letter.isalpha()
        }
        # capital letters sort first, as pursuers come first
        self.letters = "".join(sorted(self.cells))
        self.pursuers = [self.cells[a] for a in self.letters if a.isupper()]
        self.evaders = [self.cells[a] for a in self.letters if a.islower()]

    def __str__(self):
        return draw(self.cells, self.obstacles)


def draw(cells, obstacles):
    rows = []
    for r, row in enumerate(obstacles):
        here = ["".join(sorted(a for a in cells if cells[a] == (r, c))) for c in range(len(row))]
        walls = ["#" if wall else "" for wall in row]
        rows.append(" ".join(wall + who or "." for wall, who in zip(walls, here, strict=True)))
    return "\n" + "\n".join(rows)


def actions_of(moves, letters):
    """Return the actions of ``"A> b^"`` for all agents."""
    chosen = {move[0]: ARROWS[move[1:]] for move in moves.split()}
    assert set(chosen) <= set(letters), f"{moves} names an agent that is not in {letters}"
    return [chosen.get(letter, 0) for letter in letters]


def begin(start, case):
    drawing = Drawing(case.before)
    config = quiet_config(
        rules=case.rules,
        rows=drawing.obstacles.shape[0],
        cols=drawing.obstacles.shape[1],
        n_pursuers=len(drawing.pursuers),
        n_evaders=len(drawing.evaders),
        **case.changes,
    )
    world = start(config, drawing.pursuers, drawing.evaders, drawing.obstacles)
    return world, drawing.letters


def check(start, case):
    """Play a case and compare the results with all that its plays state."""
    world, letters = begin(start, case)
    ever = ""
    for play in case.plays:
        world.step(actions_of(play.moves, letters), explain=True)
        ever = "".join(sorted(set(ever + play.captured))) if play.ever is None else play.ever
        seen = look(world, letters)
        wanted = expectation(play, letters, ever)
        other = {what: seen[what] for what, value in wanted.items() if seen[what] != value}
        wrong = [f"{what}: expected {wanted[what]}, got {got}" for what, got in other.items()]
        assert not wrong, "\n".join([f"{case.name}, {play.moves!r}:", *wrong])


def expectation(play, letters, ever):
    pictured = Drawing(play.after)
    wanted = {
        "after": str(pictured),
        "alive": pictured.letters,
        "captured": play.captured,
        "ever": ever,
        "ended": play.ended,
        "captors": play.captors,
        "fault": read_marks(play.fault),
        "involved": read_marks(play.involved),
        "conflicts": None if play.conflicts is None else sorted(play.conflicts),
        "paid": read_paid(play.paid, letters),
    }
    return {what: value for what, value in wanted.items() if value is not None}


def look(world, letters):
    evaders = [letter for letter in letters if letter.islower()]
    cells = dict(zip(letters, map(tuple, np.asarray(world.positions).tolist()), strict=True))
    captors = zip(evaders, np.asarray(world.captors).tolist(), strict=True)
    return {
        "after": draw(cells, world.map),
        "alive": pick(letters, world.alive),
        "captured": pick(evaders, world.captured),
        "ever": pick(evaders, world.ever_captured),
        "ended": bool(world.terminated),
        "captors": " ".join(f"{e}{n}" for e, n in captors if n),
        "fault": marks(letters, world.fault),
        "involved": marks(letters, world.involved),
        "conflicts": sorted(spell(record, letters) for record in records(world.conflicts)),
        "paid": dict(zip(letters, np.asarray(world.rewards).tolist(), strict=True)),
    }


def pick(letters, chosen):
    return "".join(letter for letter, yes in zip(letters, chosen, strict=True) if yes)


def marks(letters, table):
    """Return the letters of each kind, without kinds that have none."""
    found = {kind: pick(letters, np.asarray(table)[:, k]) for k, kind in enumerate(KINDS)}
    return {kind: who for kind, who in found.items() if who}


def read_marks(text):
    return None if text is None else dict(part.split() for part in text.split(";") if part)


def read_paid(text, letters):
    if text is None:
        return None
    paid = Counter(dict.fromkeys(letters, 0.0))
    for part in text.split(";"):
        letter, fields = (piece.strip() for piece in part.split(":"))
        team = "pursuer" if letter.isupper() else "evader"
        paid[letter] += sum(getattr(UNITS, f"{team}_{field}") for field in fields.split())
    return dict(paid)


def spell(record, letters):
    """Return a record of a conflict with letters for agents."""
    turn, kind, form, agents, cell, *groups = record
    named = ("".join(letters[a] for a in group) for group in (agents, *groups))
    return turn, kind, form, next(named), cell, *named
