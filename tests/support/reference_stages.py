"""Stages 1 to 4 of one turn: which agents are held or doomed, and by which conflicts.

Every pair of agents is checked; nothing is fast.  ``p`` is where an agent stands, ``q``
where it intends to go.  The rest of the world is in ``reference.py``.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field
from itertools import combinations

import numpy as np

import matrixworld as mw
from matrixworld import Capture, Outcome

BOUNCING = {Outcome.BOUNCE}
DISAPPEARING = {Outcome.DISAPPEAR}

Cell = tuple[int, int]
OBSTACLE, TEAMMATE, ADVERSARY = KINDS = ("obstacle", "teammate", "adversary")


@dataclass(frozen=True)
class Clash:
    """One conflict. In a chain the first agent is the one that enters, else the lower index."""

    turn: int
    kind: str
    form: str
    agents: tuple[int, ...]
    cell: Cell
    at_fault: tuple[int, ...]
    held: tuple[int, ...]
    doomed: tuple[int, ...]


@dataclass
class Setting:
    """What stays the same during an episode: rules, obstacles and teams."""

    rules: mw.Rules
    map: np.ndarray
    n_pursuers: int

    def is_pursuer(self, a: int) -> bool:
        return a < self.n_pursuers

    def same_team(self, a: int, b: int) -> bool:
        return self.is_pursuer(a) == self.is_pursuer(b)

    def outcome(self, a: int) -> Outcome:
        """Return the outcome of a collision with an adversary for ``a``."""
        return self.rules.pursuer if self.is_pursuer(a) else self.rules.evader

    def inside(self, cell: Cell) -> bool:
        rows, cols = self.map.shape
        return 0 <= cell[0] < rows and 0 <= cell[1] < cols

    def blocked(self, cell: Cell) -> bool:
        return not self.inside(cell) or bool(self.map[cell])


@dataclass
class Turn:
    """The living agents of one turn; ``judge`` computes the final ``q`` and ``doomed``."""

    setting: Setting
    number: int
    acting: set[int]
    p: dict[int, Cell]
    q: dict[int, Cell]
    doomed: set[int] = field(default_factory=set)
    clashes: list[Clash] = field(default_factory=list)

    def judge(self) -> None:
        self.obstacles()
        self.teammates()
        self.chains(links=self.adversaries())

    # -- terms of the rules ----------------------------------------------------------------

    def moving(self, a: int) -> bool:
        return self.q[a] != self.p[a]

    def hold(self, agents: Iterable[int]) -> None:
        for a in agents:
            self.q[a] = self.p[a]

    def form(self, a: int, b: int) -> str | None:
        """Return the form of the conflict of two agents on their present intentions, or None."""
        if not {a, b} & self.acting:
            return None
        if self.q[a] == self.q[b]:
            return "vertex"
        if self.q[a] == self.p[b] and self.q[b] == self.p[a]:
            return "edge"
        return None

    def conflicts(self, *, same_team: bool) -> list[tuple[int, int, str]]:
        """Return the pairs in conflict on the present intentions, the lower index first."""
        return [
            (a, b, form)
            for a, b in combinations(sorted(self.q), 2)
            if self.setting.same_team(a, b) == same_team and (form := self.form(a, b))
        ]

    def entering(self, stopped: set[int]) -> list[tuple[int, int]]:
        """Return the pairs of an agent and the stopped agent whose cell it intends to enter."""
        return [
            (a, b)
            for a in sorted(self.q)
            for b in sorted(stopped)
            if self.moving(a) and self.q[a] == self.p[b]
        ]

    def record(
        self,
        kind: str,
        form: str,
        agents: tuple[int, ...],
        fault: set[int],
        held: set[int],
        doomed: set[int],
    ) -> None:
        """Record one conflict; its cell is the one that the first agent headed for."""
        sets = (tuple(sorted(group)) for group in (fault, held, doomed))
        self.clashes.append(Clash(self.number, kind, form, agents, self.q[agents[0]], *sets))
        self.doomed |= doomed

    # -- stage 1 ---------------------------------------------------------------------------

    def obstacles(self) -> None:
        for a in sorted(self.acting):
            if self.moving(a) and self.setting.blocked(self.q[a]):
                self.bump(a)

    def bump(self, a: int) -> None:
        outcome = self.setting.rules.obstacle
        if outcome == Outcome.REACH and not self.setting.inside(self.q[a]):
            outcome = Outcome.BOUNCE
        held = {a} if outcome in BOUNCING else set()
        crashed = {a} if outcome in DISAPPEARING else set()
        self.record(OBSTACLE, "vertex", (a,), {a}, held, crashed)
        self.hold(held)
        for gone in crashed:
            del self.p[gone], self.q[gone]

    # -- stage 2 ---------------------------------------------------------------------------

    def teammates(self) -> None:
        stopped: set[int] = set()
        for a, b, form in self.conflicts(same_team=True):
            stopped |= self.meet_teammate(form, a, b, could_be_held={a, b})
        self.hold(stopped)
        while behind := [pair for pair in self.entering(stopped) if self.setting.same_team(*pair)]:
            for a, b in behind:
                stopped |= self.meet_teammate("chain", a, b, could_be_held={a})
            self.hold(stopped)

    def meet_teammate(self, form: str, a: int, b: int, could_be_held: set[int]) -> set[int]:
        """Return the agents that this conflict by itself holds."""
        outcome = self.setting.rules.teammate
        held = {x for x in could_be_held if outcome in BOUNCING and self.moving(x)}
        doomed = {a, b} if outcome in DISAPPEARING else set()
        self.record(TEAMMATE, form, (a, b), {a, b}, held, doomed)
        return held

    # -- stage 3 ---------------------------------------------------------------------------

    def adversaries(self) -> set[int]:
        """Return the agents that were held."""
        stopped: set[int] = set()
        for a, b, form in self.conflicts(same_team=False):
            stopped |= self.meet_adversary(form, a, b, standing=set())
        self.hold(stopped)
        return stopped

    def meet_adversary(self, form: str, a: int, b: int, standing: set[int]) -> set[int]:
        """Return the agents that this conflict by itself holds; ``standing`` agents do not move."""
        moving = {x for x in (a, b) if self.moving(x)} - standing
        held = {x for x, y in ((a, b), (b, a)) if x in moving and self.kept_from(x, y)}
        doomed = {x for x in (a, b) if self.setting.outcome(x) in DISAPPEARING}
        contact = set() if self.setting.rules.capture == Capture.OCCUPATION else moving
        self.record(ADVERSARY, form, (a, b), held or contact, held, doomed)
        return held

    def kept_from(self, a: int, b: int) -> bool:
        """Return whether meeting the adversary ``b`` cancels a move of ``a``."""
        mine, other = self.setting.outcome(a), self.setting.outcome(b)
        if mine == Outcome.REACH:
            return other in BOUNCING and self.p[b] == self.q[a]
        return mine in BOUNCING

    # -- stage 4 ---------------------------------------------------------------------------

    def chains(self, links: set[int]) -> None:
        """Find all links first; until then the intentions stay as stage 3 left them."""
        judged = {frozenset(clash.agents) for clash in self.clashes}
        links = set(links)
        while pairs := [ab for ab in self.entering(links) if frozenset(ab) not in judged]:
            for a, b in pairs:
                links |= self.meet_link(a, b)
                judged.add(frozenset((a, b)))
        self.hold(links)

    def meet_link(self, a: int, b: int) -> set[int]:
        """Return the agents held because ``a`` intends to enter the cell of the link ``b``."""
        if self.setting.same_team(a, b):
            return self.meet_teammate("chain", a, b, could_be_held={a})
        return self.meet_adversary("chain", a, b, standing={b})
