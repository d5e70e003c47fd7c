"""A slow and obvious implementation of the rules, with which the engine is compared.

It checks every pair of agents, with sets and dictionaries, and has one short function for each
sentence of the rules.  ``p`` is where an agent stands, ``q`` where it intends to go.
"""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from itertools import combinations

import numpy as np

import matrixworld as mw
from matrixworld import Capture, Interaction, Outcome

BOUNCING = {Outcome.BOUNCE}
DISAPPEARING = {Outcome.DISAPPEAR}

Cell = tuple[int, int]
OBSTACLE, TEAMMATE, ADVERSARY = KINDS = ("obstacle", "teammate", "adversary")
AXIAL = [(-1, 0), (0, 1), (1, 0), (0, -1)]
DIAGONAL = [(-1, 1), (1, 1), (1, -1), (-1, -1)]
MOVES = [(0, 0), *AXIAL, *DIAGONAL]
GONE = (-1, -1)


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


def add(cell: Cell, move: Cell) -> Cell:
    """Return the cell one move away."""
    return cell[0] + move[0], cell[1] + move[1]


def records(conflicts: Iterable[Clash | mw.Conflict]) -> list[tuple]:
    """Return the conflicts of either world as sorted tuples."""
    return sorted(
        (
            c.turn,
            c.kind,
            c.form,
            tuple(c.agents),
            tuple(c.cell),
            *(tuple(sorted(group)) for group in (c.at_fault, c.held, c.doomed)),
        )
        for c in conflicts
    )


class ReferenceWorld:
    """A world with the attributes of ``mw.World``; agents are pursuers first, then evaders."""

    def __init__(self, config: mw.WorldConfig) -> None:
        self.config = config
        self.rules = mw.VARIANTS[config.rules] if isinstance(config.rules, str) else config.rules
        self.directions = AXIAL + (DIAGONAL if config.diagonal else [])

    def place(
        self,
        pursuers: Sequence[Sequence[int]],
        evaders: Sequence[Sequence[int]],
        map: np.ndarray | None = None,
    ) -> None:
        """Begin an episode with given cells and obstacles (bool of shape (rows, cols))."""
        shape = (self.config.rows, self.config.cols)
        self.map = np.zeros(shape, bool) if map is None else np.array(map, bool)
        self.setting = Setting(self.rules, self.map, len(pursuers))
        cells = [(int(row), int(col)) for row, col in [*pursuers, *evaders]]
        self.where: dict[int, Cell] = dict(enumerate(cells))
        self.been = dict(self.where)  # last positions: also of agents that are gone
        self.agents, self.evaders = range(len(cells)), range(len(pursuers), len(cells))
        self.ever: set[int] = set()
        self.taken: set[int] = set()  # evaders that disappeared in a capture
        self.steps, self.terminated = 0, False
        self.begin_round()

    # -- a round ---------------------------------------------------------------------------

    def begin_round(self) -> None:
        self.now: dict[int, set[int]] = {}  # captured evader -> its captors
        self.paid: set[int] = set()  # evaders whose capture was paid in this round
        self.last: dict[int, set[int]] = {}  # captors of the evaders that disappeared in this round
        self.conflicts: list[Clash] = []
        self.rewards = np.zeros(len(self.agents))

    def step(self, actions: Sequence[int], *, explain: bool = True) -> np.ndarray:
        """Play one round; the conflicts are always kept."""
        if self.terminated or self.truncated:
            raise RuntimeError("the episode has ended")
        for a in sorted(self.where):
            if not 0 <= actions[a] <= len(self.directions):
                raise ValueError(f"agent {a}: no action {actions[a]}")
        self.begin_round()
        self.steps += 1
        for number, agents in self.turns():
            acting = {a for a in agents if a in self.where}
            if acting and not self.terminated:
                self.play(number, acting, actions)
        self.pay_collisions()
        return self.rewards

    def turns(self) -> Iterator[tuple[int, list[int]]]:
        if self.rules.interaction == Interaction.SIMULTANEOUS:
            yield 0, list(self.agents)
        elif self.rules.interaction == Interaction.SWARM_TURNS:
            yield 0, [a for a in self.agents if a not in self.evaders]
            yield 1, list(self.evaders)
        else:
            yield from ((a, [a]) for a in self.agents)

    def play(self, number: int, acting: set[int], actions: Sequence[int]) -> None:
        """Play one turn: intentions, then the five stages."""
        p = dict(self.where)
        q = {a: add(cell, MOVES[actions[a]]) if a in acting else cell for a, cell in p.items()}
        turn = Turn(self.setting, number, acting, p, q)
        turn.judge()
        self.settle(turn)

    # -- stage 5 ---------------------------------------------------------------------------

    def settle(self, turn: Turn) -> None:
        self.been |= {a: turn.q.get(a, cell) for a, cell in self.where.items()}
        self.where = {a: cell for a, cell in turn.q.items() if a not in turn.doomed}
        self.conflicts += turn.clashes
        self.now = self.captures(turn)
        self.pay_captures()
        self.ever |= set(self.now)
        if self.rules.capture == Capture.SURROUND and self.rules.captured_disappear:
            self.where = {a: cell for a, cell in self.where.items() if a not in self.now}
        self.last |= {e: captors for e, captors in self.now.items() if e not in self.where}
        self.taken |= set(self.last)
        self.pay_turn(turn)
        self.terminated = self.has_ended()

    def captures(self, turn: Turn) -> dict[int, set[int]]:
        """Return the captors of every evader that is captured in this turn."""
        surround = self.rules.capture == Capture.SURROUND
        found = {
            e: self.surrounding(e) if surround else self.occupying(turn, e) for e in self.evaders
        }
        return {e: captors for e, captors in found.items() if captors}

    def occupying(self, turn: Turn, e: int) -> set[int]:
        both_reach = self.rules.evader == self.rules.pursuer == Outcome.REACH
        if self.rules.evader not in DISAPPEARING and not both_reach:
            return set()
        met = {a for c in turn.clashes if c.kind == ADVERSARY and e in c.agents for a in c.agents}
        shared = self.pursuers_on(self.where[e]) if both_reach and e in self.where else set()
        return met - {e} | shared

    def surrounding(self, e: int) -> set[int]:
        if e not in self.where:
            return set()
        around = [add(self.where[e], move) for move in self.directions]
        if not all(self.setting.blocked(cell) or self.pursuers_on(cell) for cell in around):
            return set()
        return {a for cell in around for a in self.pursuers_on(cell)}

    def pursuers_on(self, cell: Cell) -> set[int]:
        return {a for a, at in self.where.items() if at == cell and a not in self.evaders}

    def has_ended(self) -> bool:
        over = self.ever if self.rules.capture == Capture.OCCUPATION else set(self.now)
        pursuers = [a for a in self.where if a not in self.evaders]
        at_large = [a for a in self.where if a in self.evaders and a not in over]
        return not pursuers or not at_large

    # -- rewards ---------------------------------------------------------------------------

    def reward_of(self, name: str, a: int) -> float:
        team = "evader" if a in self.evaders else "pursuer"
        return float(getattr(self.config.rewards, f"{team}_{name}"))

    def pay_captures(self) -> None:
        """Pay captures once per evader and episode, or once per round if captures repeat."""
        already = self.paid if self.config.rewards.capture_repeats else self.ever
        for e in set(self.now) - already:
            for a in {e} | self.now[e]:
                self.rewards[a] += self.reward_of("capture", a)
        self.paid |= set(self.now)

    def pay_turn(self, turn: Turn) -> None:
        """Pay the agents of this turn for acting, and for adversaries beside them."""
        for a in turn.acting:
            self.rewards[a] += self.reward_of("step", a)
            if a in self.where and self.adversary_beside(a):
                self.rewards[a] += self.reward_of("neighbor", a)

    def adversary_beside(self, a: int) -> bool:
        beside = [add(self.where[a], move) for move in AXIAL]
        return any(
            cell in beside and not self.setting.same_team(a, b) for b, cell in self.where.items()
        )

    def pay_collisions(self) -> None:
        for a in self.agents:
            self.rewards[a] += self.reward_of("collide", a) * self.fault[a].sum()

    # -- results ---------------------------------------------------------------------------

    @property
    def truncated(self) -> bool:
        return self.steps >= self.config.max_steps

    @property
    def positions(self) -> np.ndarray:
        return np.array([self.where.get(a, GONE) for a in self.agents])

    @property
    def last_positions(self) -> np.ndarray:
        return np.array([self.been[a] for a in self.agents])

    @property
    def alive(self) -> np.ndarray:
        return np.array([a in self.where for a in self.agents])

    @property
    def captured(self) -> np.ndarray:
        """Whether each evader is captured now, or was when it disappeared."""
        return np.array([e in self.now or e in self.taken for e in self.evaders])

    @property
    def ever_captured(self) -> np.ndarray:
        return np.array([e in self.ever for e in self.evaders])

    @property
    def captors(self) -> np.ndarray:
        """Number of captors now, or when the evader disappeared in this round."""
        return np.array([len((self.last | self.now).get(e, ())) for e in self.evaders])

    @property
    def involved(self) -> np.ndarray:
        return self.marks({(a, c.kind) for c in self.conflicts for a in c.agents})

    @property
    def fault(self) -> np.ndarray:
        return self.marks({(a, c.kind) for c in self.conflicts for a in c.at_fault})

    def marks(self, pairs: set[tuple[int, str]]) -> np.ndarray:
        return np.array([[(a, kind) in pairs for kind in KINDS] for a in self.agents])

    def state(self) -> np.ndarray:
        """Return the whole world in the channels evaders, pursuers, obstacles."""
        seen = np.zeros((3, self.config.rows, self.config.cols), np.uint8)
        seen[2] = self.map
        for a, cell in self.where.items():
            seen[(0 if a in self.evaders else 1, *cell)] = 1
        return seen

    def views(self) -> np.ndarray:
        return np.array([self.view(a) for a in self.agents])

    def view(self, a: int) -> np.ndarray:
        """Return what one agent sees: a window around it, without itself."""
        fov = self.config.fov
        seen = np.zeros((3, fov, fov), np.uint8)
        if a not in self.where:
            return seen
        top, left = add(self.where[a], (-(fov // 2), -(fov // 2)))
        for row, col in np.ndindex(fov, fov):
            seen[2, row, col] = self.setting.blocked((top + row, left + col))
        for b, (row, col) in self.where.items():
            if b != a and 0 <= row - top < fov and 0 <= col - left < fov:
                seen[0 if b in self.evaders else 1, row - top, col - left] = 1
        return seen
