"""Players that remember something, against the best response, which knows what they remember.

Moments, each a state and what every member of the team remembers, are followed from the starts
through the turns of an episode, and then solved backward.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Protocol, TypeAlias

import numpy as np
from numpy.typing import NDArray

from matrixworld.play.draws import NotExactError
from matrixworld.play.functions import ASKED_AGAIN, Function
from matrixworld.solver.solution import Solution
from matrixworld.solver.visits import Visit
from matrixworld.world.policy import Network, Population, Team
from matrixworld.world.states import States

MOST_MOMENTS = 200_000
"""The most moments of all turns together that are followed."""

Answers: TypeAlias = "list[tuple[NDArray[np.float64], bytes, float]]"
"""Probabilities of the actions, what is remembered then, and how likely both are."""

Moment: TypeAlias = "tuple[int, tuple[bytes, ...]]"
"""A state, and what each member of the team remembers; an end has no memories."""


class Mind(Protocol):
    """What remembers: a `Function` with a memory, or a recurrent network."""

    def followed(self, seen: NDArray[Any], memory: bytes, n_actions: int) -> Answers:
        """Return all answers to what one agent sees and remembers; at first nothing, no bytes."""


@dataclass(frozen=True, eq=False)
class Recurrent:
    """A genome of a recurrent network: its memory is the state of its units."""

    population: Population

    def followed(self, seen: NDArray[Any], memory: bytes, n_actions: int) -> Answers:
        """Return its only answer: a memory does not depend on the action that is drawn."""
        network: Network = self.population.policy
        [genome] = self.population.genomes
        before = np.frombuffer(memory, np.float32)[np.newaxis] if memory else None
        [logits], [after] = network.advance(genome, seen[np.newaxis], before)
        weights = np.exp(np.float64(logits) - np.float64(logits.max()))
        answer = weights / weights.sum() if network.sampled else np.eye(n_actions)[logits.argmax()]
        return [(answer, after.tobytes(), 1.0)]


def mind_of(plays: Any) -> Mind | None:
    """Return what a player in a world remembers by; None if it does not remember anything."""
    if isinstance(plays, Function) and plays.remembers:
        return plays
    if isinstance(plays, Population) and plays.policy.memory != "none":
        if len(plays.genomes) != 1:
            raise ValueError(f"champion: expected a single genome, got {len(plays.genomes)}")
        return Recurrent(plays)
    return None


def needs_numbers(states: States, team: Team) -> bool:
    """Return whether members of a team act at once, so that memories need their numbers."""
    return any(len(states.members(turn, team)) > 1 for turn in range(states.n_turns))


@dataclass(frozen=True, eq=False)
class _Layer:
    """The moments of a turn, and the ways (K,) that lead on from them.

    Way k begins in moment `of[k]` with a joint action of the team, and has a probability. It leads,
    if the other team plays its joint action q, to moment ``following[k, q]`` of the next turn.
    """

    moments: list[Moment]
    of: NDArray[np.intp]
    action: NDArray[np.intp]
    probability: NDArray[np.float64]
    following: NDArray[np.intp]

    def means(self, values: NDArray[np.float64]) -> NDArray[np.float64]:
        """Return what each joint action of the other team leads to, by the next moments' values."""
        means = np.zeros((len(self.moments), self.following.shape[1]))
        np.add.at(means, self.of, self.probability[:, np.newaxis] * values[self.following])
        return means


class _Followed:
    """What follows from moments of a player with memory, in `states`."""

    def __init__(self, states: States, mind: Mind, team: Team) -> None:
        config = states.config
        self._states = states
        self._mind = mind
        self._team = team
        pursuers = range(config.n_pursuers)
        self.agents = pursuers if team == "pursuer" else range(len(pursuers), config.n_agents)
        self._n_actions = config.n_actions
        self._n_ends = config.n_evaders + 1
        self._views, self._places = states.views(team)
        self._known: dict[tuple[int, bytes], Answers] = {}

    def layer(self, turn: int, moments: list[Moment]) -> tuple[_Layer, list[Moment]]:
        """Return what follows from the moments of a turn, and the moments of the next one."""
        successors = self._states.successors(turn)
        if self._team == "evader":
            successors = successors.swapaxes(1, 2)
        cells = self._states.cells((turn + 1) % self._states.n_turns)[:, self.agents]
        numbers: dict[Moment, int] = {}
        ways: list[tuple[int, int, float]] = []
        following: list[list[int]] = []
        for number, moment in enumerate(moments):
            for play, memories, share in self._answers(turn, moment):
                if len(numbers) > MOST_MOMENTS:
                    raise NotExactError(_too_many())
                for action in np.flatnonzero(play).tolist():
                    ways.append((number, action, share * float(play[action])))
                    following.append(
                        [
                            numbers.setdefault(self._moment(state, memories, cells), len(numbers))
                            for state in successors[moment[0], action].tolist()
                        ]
                    )
        of, action, probability = map(np.array, zip(*ways, strict=True))
        return _Layer(moments, of, action, probability, np.array(following)), list(numbers)

    def _answers(
        self, turn: int, moment: Moment
    ) -> list[tuple[NDArray[np.float64], tuple[bytes, ...], float]]:
        """Return the team's answers: joint actions, memories, and how likely both are."""
        state, memories = moment
        found = [(np.ones(1), memories, 1.0)]
        for column, agent in enumerate(self._states.members(turn, self._team)):
            view = int(self._places[turn][state, column])
            member = agent - self.agents.start
            answers: Answers = [(np.eye(self._n_actions)[0], b"", 1.0)]  # gone: action 0
            if view >= 0:
                key = view, memories[member]
                if key not in self._known:
                    self._known[key] = self._followed(view, memories[member])
                answers = self._known[key]
            found = [
                (
                    np.outer(play, answer).ravel(),
                    (*kept[:member], after, *kept[member + 1 :]),
                    share * likely,
                )
                for play, kept, share in found
                for answer, after, likely in answers
            ]
        return found

    def _followed(self, view: int, memory: bytes) -> Answers:
        """Return the answers in a view; NotExactError if others come when they are asked again."""
        seen = self._views[view]
        found = self._mind.followed(seen, memory, self._n_actions)
        if len(self._known) < ASKED_AGAIN:
            again = self._mind.followed(seen, memory, self._n_actions)
            if _plain(found) != _plain(again):
                raise NotExactError(
                    "memory: it answers differently when it is asked again: it remembers or draws "
                    "in other ways than by memory and rng"
                )
        return found

    def _moment(self, state: int, memories: tuple[bytes, ...], cells: NDArray[np.int32]) -> Moment:
        """Return a moment: an end has no memories, and the gone remember nothing."""
        if state < self._n_ends:
            return state, ()
        alive = cells[state] >= 0
        if alive.all():
            return state, memories
        return state, tuple(m if a else b"" for m, a in zip(memories, alive, strict=True))


def _plain(answers: Answers) -> list[tuple[bytes, bytes, float]]:
    return [(play.tobytes(), kept, share) for play, kept, share in answers]


def _too_many() -> str:
    return (
        f"memory: expected at most {MOST_MOMENTS:,} moments, each a state and what is remembered "
        "in it, got more"
    )


def follow(states: States, mind: Mind, team: Team, steps: int) -> tuple[list[_Layer], list[Moment]]:
    """Return the moments of all turns of an episode, what follows from them, and those at its end.

    NotExactError, a ValueError, if there are more than `MOST_MOMENTS`.
    """
    followed = _Followed(states, mind, team)
    nothing = (b"",) * len(followed.agents)
    moments: list[Moment] = [(int(start), nothing) for start in states.starts]
    layers: list[_Layer] = []
    for _ in range(steps):
        for turn in range(states.n_turns):
            layer, moments = followed.layer(turn, moments)
            layers.append(layer)
            if sum(len(each.moments) for each in layers) + len(moments) > MOST_MOMENTS:
                raise NotExactError(_too_many())
    return layers, moments


def remembered(perfect: Solution, mind: Mind, team: Team) -> tuple[float, float, tuple[Visit, ...]]:
    """Return what a player with memory gets against the best response and perfect play.

    The last one is where it gets against the best response. Where `needs_numbers`, the states of
    the solution have to be numbered. NotExactError, a ValueError, if it reaches too many moments.
    """
    states = perfect.states
    rival: Team = "evader" if team == "pursuer" else "pursuer"
    layers, last = follow(states, mind, team, perfect.steps)
    captured = states.captured().mean(axis=1)
    values = unread = captured[[state for state, _ in last]]
    turns = [
        (rounds, turn) for rounds in range(perfect.steps, 0, -1) for turn in range(states.n_turns)
    ]
    responses = []
    for (rounds, turn), layer in zip(reversed(turns), reversed(layers), strict=True):
        means = layer.means(values)
        best = means.argmin(axis=1) if team == "pursuer" else means.argmax(axis=1)
        values = means[np.arange(len(best)), best]
        responses.append(best)
        play = perfect.probabilities(rival, rounds, turn)[[state for state, _ in layer.moments]]
        unread = (play * layer.means(unread)).sum(axis=1)
    visits = []
    reach = np.full(len(values), 1 / len(values))
    for (rounds, turn), layer, best in zip(turns, layers, reversed(responses), strict=True):
        visit, reach = _visit(perfect, team, rounds, turn, layer, best, reach)
        visits.append(visit)
    return float(values.mean()), float(unread.mean()), tuple(visits)


def _visit(
    perfect: Solution,
    team: Team,
    rounds: int,
    turn: int,
    layer: _Layer,
    best: NDArray[np.intp],
    reach: NDArray[np.float64],
) -> tuple[Visit, NDArray[np.float64]]:
    """Return how states come about in a turn, and how often the moments of the next one do."""
    successors = perfect.states.successors(turn)
    count = len(successors)
    place = np.array([state for state, _ in layer.moments])
    of, own, theirs = place[layer.of], layer.action, best[layer.of]
    likely = reach[layer.of] * layer.probability
    pursuers, evaders = (own, theirs) if team == "pursuer" else (theirs, own)
    worth = perfect.after(rounds, turn)[successors[of, pursuers, evaders]]
    played = np.zeros((count, successors.shape[1 if team == "pursuer" else 2]))
    np.add.at(played, (of, own), likely)
    after = np.bincount(of, likely * worth, count).astype(np.float64)
    following = layer.following[np.arange(len(theirs)), theirs]
    next_reach = np.bincount(following, likely, layer.following.max() + 1).astype(np.float64)
    met = np.bincount(place, reach, count).astype(np.float64)
    return Visit(rounds, turn, met, played, after), next_reach
