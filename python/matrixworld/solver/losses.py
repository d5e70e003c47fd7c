"""The positions in which a player loses most, and what it does, in words."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from itertools import islice
from typing import Any
from weakref import WeakKeyDictionary

import numpy as np
from numpy.typing import NDArray

from matrixworld._core import Interaction
from matrixworld.solver.guarantee import Guarantee
from matrixworld.solver.suite import SuiteWorld
from matrixworld.solver.visits import Visit
from matrixworld.world.policy import Team
from matrixworld.world.rating import INPUTS
from matrixworld.world.rules import Action
from matrixworld.world.states import States

LEAST = 1e-9
"""Losses below are rounding."""
LIKELY = 0.005
"""Moves with a smaller probability are not named."""


@dataclass(frozen=True)
class Loss:
    """A position in which a player loses something, with its mirror images.

    Parameters
    ----------
    world : str
        Name of the world.
    board : str
        The board as lines of text: P, Q, R are pursuers, E, F evaders, # obstacles.
    steps_left : int
        Steps of the episode that are left, with the present one.
    plays : str
        What the player does there: its moves, with their probabilities if there are several.
    better : str
        A move that loses nothing, the nearest one to what the player does; at once, what perfect
        play does.
    loss : float
        By how much the value of perfect play falls each time, for the player's team.
    how_often : float
        In which share of the episodes it comes about, against an opponent that knows the player.
    """

    world: str
    board: str
    steps_left: int
    plays: str
    better: str
    loss: float
    how_often: float

    def __str__(self) -> str:
        steps = "1 step" if self.steps_left == 1 else f"{self.steps_left} steps"
        told = [f"plays {self.plays}: loses {self.loss:.3f}", f"loses nothing: {self.better}"]
        board = self.board.splitlines()
        lines = [f"{self.world}; {steps} left; in {self.how_often:.1%} of the games"]
        for row, line in enumerate(board + [""] * (len(told) - len(board))):
            lines.append(f"  {line:<{len(board[0])}}   {told[row] if row < len(told) else ''}")
        return "\n".join(line.rstrip() for line in lines)


def losses(found: Guarantee, world: SuiteWorld, team: Team) -> Iterator[tuple[float, Loss]]:
    """Yield the positions in which a player loses, with what each takes from its share of perfect.

    The most expensive ones come first. Mirror images are one position.
    """
    sign = 1 if team == "pursuer" else -1
    scale = world.value if team == "pursuer" else 1 - world.value
    states = found.perfect.states
    images = _Images(states)
    groups: dict[tuple[object, ...], list[tuple[float, Visit, int]]] = {}
    for visit in found.visits:
        if not states.members(visit.turn, team):
            continue
        before = visit.reach * found.perfect.before(visit.rounds, visit.turn)
        lost = sign * (before - visit.after)
        for state in np.flatnonzero(lost > LEAST).tolist():
            key = visit.rounds, visit.turn, images.key(visit.turn, state)
            groups.setdefault(key, []).append((float(lost[state]), visit, state))
    ordered = sorted(groups.values(), key=lambda group: -sum(lost for lost, _, _ in group))
    for group in ordered:
        total = sum(lost for lost, _, _ in group)
        _, visit, state = max(group, key=lambda one: one[0])
        reach = sum(float(visit.reach[state]) for _, visit, state in group)
        yield total / scale, _told(found, world, team, visit, state, total / reach, reach)


def _told(
    found: Guarantee,
    world: SuiteWorld,
    team: Team,
    visit: Visit,
    state: int,
    loss: float,
    reach: float,
) -> Loss:
    states = found.perfect.states
    members = states.members(visit.turn, team)
    alive = [agent for agent in members if states.cells(visit.turn)[state, agent] >= 0]
    play = visit.play[state] / visit.reach[state]
    best = _lossless(found, team, visit, state, play)

    def in_words(probabilities: NDArray[np.float64]) -> str:
        named = [j for j in np.argsort(-probabilities, kind="stable") if probabilities[j] > LIKELY]
        texts: dict[str, float] = {}
        for number in named:
            text = _moves_in_words(int(number), members, alive, states)
            texts[text] = texts.get(text, 0.0) + float(probabilities[number])
        if len(texts) == 1:
            return next(iter(texts))
        shown = [f"{text} ({share:.2f})" for text, share in [*texts.items()][:3]]
        return " or ".join(shown) + (" or others" if len(texts) > 3 else "")

    board = board_of(states, visit.turn, state)
    words = in_words(play), in_words(best)
    return Loss(world.name, board, visit.rounds, *words, loss, reach)


def _lossless(
    found: Guarantee, team: Team, visit: Visit, state: int, play: NDArray[np.float64]
) -> NDArray[np.float64]:
    """Return probabilities of joint actions that lose nothing: one action where that is known."""
    perfect = found.perfect
    following = perfect.states.successors(visit.turn)[state]
    rows = following if team == "pursuer" else following.T
    if rows.shape[1] > 1:  # at once: it can take chance to lose nothing
        return np.asarray(perfect.probabilities(team, visit.rounds, visit.turn)[state])
    values = perfect.after(visit.rounds, visit.turn)[rows[:, 0]]
    before = perfect.before(visit.rounds, visit.turn)[state]
    good = np.flatnonzero(np.abs(values - before) <= LEAST)
    n = perfect.states.config.n_actions
    usual = _digits(int(play.argmax()), n, len(play))
    changed = [(_digits(int(j), n, len(play)) != usual).sum() for j in good]
    return np.asarray(np.eye(len(play))[good[int(np.argmin(changed))]])


def _digits(number: int, base: int, size: int) -> NDArray[np.int64]:
    """Return the actions of all members in a joint action, of `size` joint actions."""
    digits = []
    while size > 1:
        digits.append(number % base)
        number, size = number // base, size // base
    return np.array(digits[::-1], np.int64)


def _moves_in_words(
    number: int, members: Sequence[int], alive: Sequence[int], states: States
) -> str:
    config = states.config
    actions = _digits(number, config.n_actions, config.n_actions ** len(members))
    words = [
        f"{letter_of(agent, states)} {Action(action).name.lower().replace('_', ' ')}"
        for agent, action in zip(members, actions.tolist(), strict=True)
        if agent in alive
    ]
    return ", ".join(words)


def letter_of(agent: int, states: States) -> str:
    """Return the letter of an agent on boards: P, Q, R, ... for pursuers, E, F, ... for evaders."""
    pursuers = states.config.n_pursuers
    return chr(ord("P") + agent) if agent < pursuers else chr(ord("E") + agent - pursuers)


def board_of(states: States, turn: int, state: int) -> str:
    """Return a state as lines of text, with the letters of its agents."""
    config = states.config
    walls = np.zeros((config.rows, config.cols), bool) if config.map is None else config.map
    rows = [["#" if wall else "." for wall in row] for row in walls]
    for agent, cell in enumerate(states.cells(turn)[state].tolist()):
        if cell >= 0:
            row, col = divmod(cell, config.cols)
            rows[row][col] = rows[row][col].strip(".") + letter_of(agent, states)
    width = max(len(text) for row in rows for text in row)
    return "\n".join(" ".join(text.ljust(width) for text in row).rstrip() for row in rows)


class _Images:
    """Mirror images and turns of a world's board that leave the board as it is."""

    def __init__(self, states: States) -> None:
        config = states.config
        self._states = states
        self._cells = [states.cells(turn) for turn in range(states.n_turns)]
        self._captured = [states.captured(turn) for turn in range(states.n_turns)]
        in_order = config.rules.interaction is Interaction.AGENT_TURNS
        self._sorted = not in_order and not states.numbered
        numbers = np.arange(config.rows * config.cols).reshape(config.rows, config.cols)
        walls = np.zeros(numbers.shape, bool) if config.map is None else config.map
        self._places = []
        for turns in range(4):
            for mirrored in (False, True):
                image = np.rot90(numbers.T if mirrored else numbers, turns)
                turned = np.rot90(walls.T if mirrored else walls, turns)
                if image.shape == numbers.shape and (turned == walls).all():
                    # A cell is where its number stands in the image; gone agents stay gone.
                    self._places.append(np.append(np.argsort(image.ravel()), -1))

    def key(self, turn: int, state: int) -> tuple[object, ...]:
        """Return what is the same for all images of a state."""
        pursuers = self._states.config.n_pursuers
        cells, captured = (each[turn][state] for each in (self._cells, self._captured))
        keys = []
        for places in self._places:
            moved = places[cells].tolist()
            hunters = moved[:pursuers]
            hunted = list(zip(moved[pursuers:], captured.tolist(), strict=True))
            if self._sorted:
                hunters, hunted = sorted(hunters), sorted(hunted)
            keys.append((*hunters, *hunted))
        return min(keys)


_DIRECTIONS: WeakKeyDictionary[States, dict[tuple[int, int], Any]] = WeakKeyDictionary()


def _directions(
    states: States, turn: int, agent: int
) -> tuple[NDArray[np.int8], NDArray[np.bool_]]:
    """Return what `_found_directions` does, which is computed once for states."""
    known = _DIRECTIONS.setdefault(states, {})
    if (turn, agent) not in known:
        known[turn, agent] = _found_directions(states, turn, agent)
    found: tuple[NDArray[np.int8], NDArray[np.bool_]] = known[turn, agent]
    return found


def _found_directions(
    states: States, turn: int, agent: int
) -> tuple[NDArray[np.int8], NDArray[np.bool_]]:
    """Return where the moves of an agent lead, in each state of a turn, (S, n_actions).

    The first array says whether a move leads towards the nearest adversary (1), away from it (-1)
    or neither (0), the second whether it leads into an obstacle or the border.
    """
    names = list(INPUTS)
    cells = states.cells(turn)
    [alive] = np.nonzero(cells[:, agent] >= 0)
    inputs = states.core.look(turn, agent, 0, 0, alive.astype(np.int32))
    distance = inputs[..., names.index("adversary")]
    shape = len(cells), states.config.n_actions
    towards, blocked = np.zeros(shape, np.int8), np.zeros(shape, np.bool_)
    towards[alive] = np.sign(distance[:, :1] - distance)
    blocked[alive] = inputs[..., names.index("room")] == 0
    return towards, blocked


def behaviour(found: Iterable[Guarantee], team: Team) -> str:
    """Return in a sentence where a player's moves lead, against opponents that know it."""
    counts = np.zeros(5)  # towards, away, neither, stays, blocked
    for one in found:
        states = one.perfect.states
        n = states.config.n_actions
        for visit in one.visits:
            for place, agent in enumerate(states.members(visit.turn, team)):
                towards, blocked = _directions(states, visit.turn, agent)
                by_move = visit.play.reshape(len(visit.play), n**place, n, -1).sum(axis=(1, 3))
                by_move *= (states.cells(visit.turn)[:, agent] >= 0)[:, np.newaxis]
                kinds = np.select([blocked, towards > 0, towards < 0], [4, 0, 1], 2)
                kinds[:, 0] = 3
                counts += np.bincount(kinds.ravel(), by_move.ravel(), len(counts))
    shares = counts / (counts.sum() or 1.0)
    rival = "evader" if team == "pursuer" else "pursuer"
    return (
        f"Against opponents that know it, {shares[0]:.0%} of its moves lead towards the nearest "
        f"{rival} in view, {shares[1]:.0%} away from it and {shares[2]:.0%} neither; it stays in "
        f"{shares[3]:.0%}, and runs into an obstacle or the border in {shares[4]:.0%}."
    )


def most_expensive(of_worlds: Iterable[Iterator[tuple[float, Loss]]], count: int) -> list[Loss]:
    """Return the positions that take most from the share of perfect play, of all worlds."""
    first = [one for each in of_worlds for one in islice(each, count)]
    return [loss for _, loss in sorted(first, key=lambda one: -one[0])[:count]]
