"""The script team-surrounder: an independent slow reading, and no faults."""

import itertools

import numpy as np
import pytest

import matrixworld as mw
from matrixworld import _core
from reference import MOVES

Cell = tuple[int, int]
NAME = "careful-team-surrounder"
FORBIDDEN = -1000
DECIDE, WALK = 2, 3  # what random numbers are drawn for
SOUTH = 3


def plus(cell: Cell, move: int, steps: int = 1) -> Cell:
    return cell[0] + steps * MOVES[move][0], cell[1] + steps * MOVES[move][1]


def opposite(move: int) -> int:
    return MOVES.index((-MOVES[move][0], -MOVES[move][1]))


def right_of(move: int) -> int:
    return move % 4 + 1


def below(bits: int, n: int, width: int) -> int:
    return bits * n >> width


class Mind:
    """What one agent sees, and what it thinks of its moves."""

    def __init__(
        self, episode: mw.Episode, config: mw.WorldConfig, seed: int, step: int, agent: int
    ) -> None:
        self.config, self.step, self.agent = config, step, agent
        self.n, self.key = config.n_actions, [seed, 0]
        self.reach = min(config.fov // 2, 5)
        cells = [(int(r), int(c)) for r, c in episode.positions[step]]
        alive = episode.alive[step]
        self.pursues = agent < config.n_pursuers
        self.here = cells[agent]
        others = [a for a in range(config.n_agents) if a != agent and alive[a]]
        others = [a for a in others if self.far(cells[a]) <= self.reach]
        self.foes = {cells[a] for a in others if (a < config.n_pursuers) != self.pursues}
        self.mates = {cells[a] for a in others if (a < config.n_pursuers) == self.pursues}
        self.mates -= {self.here}
        row, col = self.here
        window = itertools.product(range(-self.reach, self.reach + 1), repeat=2)
        self.seen = {(row + r, col + c) for r, c in window}
        self.blocked = {cell for cell in self.seen if not self.is_free(cell, episode.map)}
        self.has_obstacles = bool(episode.map.any())
        self.loose = {mate for mate in self.mates if not self.foes & self.beside(mate)}
        block = _core.philox([agent // 8, step, DECIDE, 0], self.key)
        self.draw = block[agent % 8 // 2] >> 32 * (agent % 2) & 0xFFFFFFFF

    def is_free(self, cell: Cell, ground: np.ndarray) -> bool:
        inside = 0 <= cell[0] < self.config.rows and 0 <= cell[1] < self.config.cols
        return inside and not ground[cell]

    def far(self, cell: Cell) -> int:
        return max(abs(cell[0] - self.here[0]), abs(cell[1] - self.here[1]))

    def moves(self, one: Cell, two: Cell) -> int:
        rows, cols = abs(one[0] - two[0]), abs(one[1] - two[1])
        return max(rows, cols) if self.n == 9 else rows + cols

    def beside(self, cell: Cell) -> set[Cell]:
        """Neighbours that lie in the 11 x 11 cells around the agent."""
        return {plus(cell, m) for m in range(1, self.n) if self.far(plus(cell, m)) <= 5}

    def open_sides(self, foe: Cell) -> set[Cell]:
        return self.beside(foe) - self.blocked - self.foes - self.mates - {self.here}

    def happens(self, shift: int, of_256: int) -> bool:
        return (self.draw >> shift) % 256 < of_256

    def worth(self) -> list[int]:
        if self.foes & self.beside(self.here):
            return self.as_holder()
        paired = {foe for foe in self.foes if self.foes & self.beside(foe)}
        shut = {c for foe in paired for c in self.open_sides(foe) if len(self.open_sides(foe)) == 1}
        shut -= {cell for foe in self.foes - paired for cell in self.beside(foe)}
        sides = {foe: (self.open_sides(foe) & self.seen) - shut for foe in sorted(self.foes)}
        some = any(sides.values())
        side = self.allocate({foe: cells for foe, cells in sides.items() if cells})
        worth = self.way(side) if side else None
        if worth is None:
            drifts = some and self.happens(0, 128)
            worth = [0] + [1] * (self.n - 1) if drifts else self.search()
        for move in range(1, self.n):
            if plus(self.here, move) in shut:
                worth[move] = 2 * FORBIDDEN
        return worth

    def as_holder(self) -> list[int]:
        held = self.foes & self.beside(self.here)
        crowded = [f for f in held if self.foes & self.beside(f) and not self.open_sides(f)]
        if crowded and self.happens(0, 128):
            return [0] + [1] * (self.n - 1)
        worth = [0] + [FORBIDDEN] * (self.n - 1)
        for move in range(1, self.n):
            others = self.foes & self.beside(plus(self.here, move))
            if others <= held or any(self.foes & self.beside(foe) for foe in others):
                continue
            gain = len(others) - len(held)
            if self.happens(8, 128 if gain > 0 else 8 if gain == 0 else 2):
                worth[move] = 1 + len(others)
        return worth

    def nearest(self, cells: set[Cell], most: int) -> list[Cell]:
        return sorted(sorted(cells, key=lambda c: (self.moves(self.here, c), c))[:most])

    def allocate(self, sides: dict[Cell, set[Cell]]) -> Cell | None:
        foes = self.nearest(set(sides), 8)
        runners = self.nearest(self.loose | {self.here}, 16)
        members: dict[Cell, list[Cell]] = {foe: [] for foe in foes}
        while True:
            pairs = [
                (self.moves(foe, runner), foe, runner)
                for foe in foes
                for runner in runners
                if len(members[foe]) < len(sides[foe])
            ]
            if not pairs:
                break
            _, foe, runner = min(pairs)
            runners.remove(runner)
            members[foe].append(runner)
        mine = next((foe for foe in foes if self.here in members[foe]), None)
        if mine is None:
            return None
        return self.share(mine, sorted(sides[mine]), sorted(members[mine]))

    def share(self, foe: Cell, sides: list[Cell], members: list[Cell]) -> Cell:
        way_out = self.exit_of(foe)

        def cost(place: int, side: Cell) -> int:
            if place >= len(members):
                return 0
            one, two = np.subtract(members[place], foe), np.subtract(side, foe)
            through = self.n == 5 and one @ two < 0 and one[0] * two[1] == one[1] * two[0]
            moves = self.moves(members[place], side) + 2 * through
            exits = 8 * (side == plus(foe, way_out)) - 4 * (side == plus(foe, way_out, -1))
            return 4 * moves + int(exits)

        given = list(sides)
        better = True
        while better:
            better = False
            for i in range(len(given)):
                for j in range(i):
                    before = cost(i, given[i]) + cost(j, given[j])
                    if cost(i, given[j]) + cost(j, given[i]) < before:
                        given[i], given[j] = given[j], given[i]
                        better = True
        return given[members.index(self.here)]

    def exit_of(self, foe: Cell) -> int:
        for steps in range(1, 11):
            for move in range(1, 5):
                if plus(foe, move, steps) in self.blocked:
                    return move
        return SOUTH

    def way(self, side: Cell) -> list[int] | None:
        """Rate the moves by the moves that are left, by breadth-first search."""
        free = self.seen - self.blocked - self.foes - (self.mates - self.loose)
        left, wave = {side: 0}, [side]
        for moves in itertools.count(1):
            wave = [c for c in {c for at in wave for c in self.beside(at)} & free if c not in left]
            if not wave:
                break
            left |= dict.fromkeys(wave, moves)
        if self.here not in left:
            return None
        return [-left.get(plus(self.here, move), -FORBIDDEN) for move in range(self.n)]

    def is_border(self, move: int, steps: int) -> bool:
        there = plus(self.here, move, steps)
        row = [plus(there, right_of(move), aside) for aside in (-1, 0, 1)]
        return all(cell in self.blocked for cell in row if self.far(cell) <= 5)

    def search(self) -> list[int]:
        config = self.config
        team = config.n_pursuers if self.pursues else config.n_evaders
        few = team * (2 * self.reach + 1) ** 2 < 2 * config.rows * config.cols
        side = max(config.rows, config.cols)
        crossing = max(1, side - 2 * self.reach + 1)
        change = max(1, crossing - 3)
        over = self.step - (side - self.reach + 1) >= 2 * (crossing + change) and team >= self.n
        if few and not self.has_obstacles and not over:
            return self.line(side, crossing, change)
        return self.mow(side, crossing)

    def line(self, side: int, crossing: int, change: int) -> list[int]:
        own = self.agent - (0 if self.pursues else self.config.n_pursuers)
        team = own // (self.n - 1)

        def turned(move: int) -> int:
            mirrored = team // 4 % 2 == 1 and move % 2 == 1
            return ((opposite(move) if mirrored else move) - 1 + team) % 4 + 1

        time = self.step - (side - self.reach + 1)
        if time < 0:
            return self.queue(turned(4), turned(1))
        half, time = divmod(time % (2 * (crossing + change)), crossing + change)
        ahead = 4 if half else 2
        if time < crossing:
            return self.sweep(turned(ahead))
        return self.queue(turned(ahead), turned(1 if half else 3))

    def along(self, cell: Cell, move: int) -> int:
        return int(np.dot(np.subtract(cell, self.here), MOVES[move]))

    def queue(self, home: int, forward: int) -> list[int]:
        worth = [1] + [0] * (self.n - 1)
        if self.is_border(home, self.reach - 1):
            worth[opposite(home)] = 8
        if not self.is_border(home, self.reach):
            worth[home] = 8
            return worth
        ahead = [
            self.along(mate, forward)
            for mate in self.loose
            if abs(self.along(mate, home)) <= 2
            and (self.along(mate, forward), self.along(mate, home)) > (0, 0)
        ]
        gap = min(ahead, default=11)
        if self.is_border(forward, self.reach - 1) or gap < 3:
            worth[opposite(forward)] = 4
        elif not self.is_border(forward, self.reach) and gap > 3:
            worth[forward] = 4
        return worth

    def sweep(self, move: int) -> list[int]:
        worth = [1] + [0] * (self.n - 1)
        right = right_of(move)
        team = self.config.n_pursuers if self.pursues else self.config.n_evaders
        behind = [(-self.along(mate, move), mate) for mate in sorted(self.mates)]
        behind = [(lag, mate) for lag, mate in behind if 0 < lag < 5]
        if team < self.n and not self.foes and behind:
            lag, last = max(behind, key=lambda pair: pair[0])
            aside = self.along(last, right)
            if abs(aside) > 2:
                worth[right if aside > 0 else opposite(right)] = 4
            elif lag > 2:
                worth[opposite(move)] = 4
        elif not self.is_border(move, self.reach):
            hand = (self.agent + self.step // 8) % 2
            worth[move] = 4
            worth[right] = 3 if hand else 2
            worth[opposite(right)] = 2 if hand else 3
        elif self.is_border(move, self.reach - 1):
            worth[opposite(move)] = 4
        return worth

    def mow(self, side: int, crossing: int) -> list[int]:
        aside = 2 * self.reach + 1
        swaths = max(1, (side - 1) // aside)
        draws = _core.philox([self.agent, 0, WALK, 0], self.key)
        time = self.step + below(draws[0], 2 * swaths * (crossing + aside), 64)
        swath, time = divmod(time, crossing + aside)
        flags = [draws[1] >> bit & 1 for bit in range(3)]
        first, other = (1, 2) if flags[0] else (2, 1)
        ahead = first if (swath + flags[1]) % 2 else opposite(first)
        shift = other if (swath // swaths + flags[2]) % 2 else opposite(other)
        worth = [1] + [0] * (self.n - 1)
        for move in range(1, 5):
            if self.is_border(move, self.reach - 1):
                worth[opposite(move)] += 4
        if time < crossing and not self.is_border(ahead, self.reach):
            for move, more in ((ahead, 8), (shift, 3), (opposite(shift), 2)):
                worth[move] += more
        elif not self.is_border(shift, self.reach):
            worth[shift] += 8
        return worth

    def has_right_of_way(self, move: int) -> bool:
        """In a row that surrounds, for a pursuer."""
        cell = plus(self.here, move)
        if cell in self.blocked | self.foes | self.mates:
            return False
        order = (self.step + self.step // 8) % 8

        def place(m: int) -> int:
            return (m + order) % (self.n - 1)

        return not any(
            plus(cell, m, -1) in self.mates and place(m) < place(move) for m in range(1, self.n)
        )

    def choice(self) -> int:
        worth = self.worth()
        moves = [0] + [move for move in range(1, self.n) if self.has_right_of_way(move)]
        best = max(worth[move] for move in moves)
        best_moves = [move for move in moves if worth[move] == best]
        return best_moves[below(self.draw, len(best_moves), 32)]


def world_of(rules: object = "SB", **changes: object) -> mw.WorldConfig:
    usual = {"rows": 12, "cols": 14, "n_pursuers": 12, "n_evaders": 4, "max_steps": 60}
    return mw.WorldConfig(rules, **(usual | changes))


@pytest.mark.parametrize(
    "changes",
    [
        {"n_pursuers": 30, "n_evaders": 12, "max_steps": 30},  # a crowd
        {"n_pursuers": 16, "obstacles": 0.1, "fov": 7},
        {"diagonal": True, "n_pursuers": 24, "n_evaders": 3, "max_steps": 30},
        {"rows": 30, "cols": 30, "n_pursuers": 4, "n_evaders": 1, "max_steps": 150},  # one line
        {"rows": 50, "cols": 40, "n_pursuers": 11, "n_evaders": 3, "max_steps": 250, "fov": 9},
        {"rows": 40, "cols": 40, "n_pursuers": 40, "n_evaders": 2, "max_steps": 100},  # swaths
    ],
    ids=str,
)
def test_every_choice_is_that_of_a_slow_reading(changes: dict[str, object]) -> None:
    config = world_of(**changes)
    for seed in (0, 2**40 + 1):
        episode = mw.record(config, NAME, "random", seed=seed)
        for step in range(len(episode.actions)):
            expected = [
                Mind(episode, config, seed, step, agent).choice()
                for agent in range(config.n_pursuers)
            ]
            assert episode.actions[step, : config.n_pursuers].tolist() == expected, step


@pytest.mark.parametrize("diagonal", [False, True])
@pytest.mark.parametrize("rules", ["D", "R", "B", "O", "S", "SB", "SD", "SDB", "TO"])
def test_nobody_is_at_fault_in_any_variant(rules: str, diagonal: bool) -> None:
    for fov, rows in ((5, 12), (11, 12), (15, 3)):
        config = world_of(
            rules, diagonal=diagonal, fov=fov, rows=rows, obstacles=0.05, n_pursuers=9 + rows
        )
        played = mw.rollout(config, NAME, NAME, mw.Matches.of(0, 0, range(5)))
        assert not played.faults.any()


def test_it_captures_everybody_and_is_never_at_fault() -> None:
    for pursuers, evaders in ((4, 1), (64, 16)):
        config = mw.WorldConfig("SB", rows=40, cols=40, n_pursuers=pursuers, n_evaders=evaders)
        played = mw.rollout(config, NAME, "random", mw.Matches.of(0, 0, range(10)))
        assert played.capture_rate.min() == 1
        assert not played.faults[:, :, 0].any()
