"""Races of policies that are tables, in solved worlds: schedules, learners, and exact NashConv.

A team is one player that sees the whole world. Its policy is a table: one joint action for each
turn, number of rounds left, and state. A *mixture* of policies draws one of them in every turn
anew (`matrixworld.solver.Champion`): it is again a policy, a random one, so that the best response
to it and its NashConv are exact. A mixture that draws once an episode would be another opponent,
which can be recognised by how it plays; the best table against that one is hard to compute
(Steimle, Kaufman and Denton, "Multi-model Markov decision processes": NP-hard).
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property, partial
from itertools import product
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import linprog

import matrixworld as mw
from matrixworld import Capture, Interaction, Outcome, Rules
from matrixworld.coevolution import TEAMS, Team
from matrixworld.coevolution.types import other
from matrixworld.solver import States, solve

CHOICES = ("newest", "average", "mixture")
"""What of all generations of a race is told of: `Race.chosen`."""
Table: TypeAlias = list[NDArray[np.int16]]
"""A policy: by turn, the joint action (rounds, S). The first axis is the rounds left, minus 1."""
Play: TypeAlias = list[NDArray[np.float64]]
"""A random policy: by turn, the probabilities (rounds, S, joint actions)."""
Floats: TypeAlias = NDArray[np.float64]
TIE = 1e-9
"""Values closer than this are equal."""
RIDGE, EQUAL = 1e-6, 1e-6
"""What is added to squares of features to fit a rating, and ratings that count as equal."""


# Worlds

WORLDS = """\
agents in turns, occupied; 1 v 1; 3 x 4 with walls .#../..../.#..; 7 steps
R; 1 v 1; 4 x 5; 4 steps, 8 ways
teams in turns, surrounded; 2 v 1; 3 x 3 with walls ##./.../...; 3 steps
R; 2 v 1; 3 x 3; 3 steps
agents in turns, surrounded; 1 v 2; 3 x 3 with walls .#./.../#..; 5 steps
O; 1 v 2; 3 x 3 with walls #../.../#.#; 5 steps
agents in turns, occupied; 1 v 1; 3 x 5 with walls ...../..#../#....; 5 steps
O; 1 v 1; 3 x 3 with walls #../.../...; 3 steps, 8 ways
agents in turns, surrounded; 2 v 1; 3 x 4 with walls ..../..../##..; 5 steps
SD; 2 v 1; 3 x 3; 4 steps
teams in turns, occupied; 1 v 2; 3 x 4; 4 steps
R; 1 v 2; 3 x 3 with walls .../#.#/#..; 4 steps
teams in turns, occupied; 1 v 1; 3 x 5; 3 steps
O; 1 v 1; 4 x 5 with walls #..../...../...../#..#.; 3 steps, 8 ways
teams in turns, occupied; 2 v 1; 4 x 4 with walls .#../.#.#/..../....; 4 steps
O; 2 v 1; 3 x 4 with walls ..##/..../#...; 3 steps
agents in turns, occupied; 1 v 2; 3 x 4 with walls ##../..../.#..; 6 steps
B; 1 v 2; 3 x 3 with walls #../#.#/...; 5 steps
teams in turns, occupied; 1 v 1; 3 x 5 with walls ...../...../#..#.; 4 steps
O; 1 v 1; 3 x 3 with walls .##/.../#..; 4 steps, 8 ways
teams in turns, occupied; 2 v 1; 4 x 4 with walls ..../...#/..../....; 3 steps
O; 2 v 1; 3 x 3 with walls .../..#/...; 3 steps
agents in turns, occupied; 1 v 2; 3 x 4 with walls ..../.#../....; 5 steps, 8 ways
B; 1 v 2; 3 x 3 with walls .../..#/#.#; 3 steps
agents in turns, occupied; 1 v 1; 3 x 3 with walls #../.../...; 6 steps
B; 1 v 1; 3 x 3 with walls .#./.../#.#; 6 steps, 8 ways
teams in turns, surrounded; 2 v 1; 4 x 4 with walls ...#/#.../...#/....; 6 steps
B; 2 v 1; 3 x 4 with walls #.../..#./...#; 4 steps
teams in turns, occupied; 1 v 2; 3 x 5 with walls ..#../...../.#...; 5 steps
B; 1 v 2; 3 x 3 with walls ..#/.../#.#; 5 steps
""".splitlines()
"""The worlds in the order in which they were drawn by chance (commit 4fd12303, seed 66).

In turns and at once in alternation, with one against one, two against one and one against two, one
pair after the other; rules, one of six boards up to 5 x 5, 0 to 3 walls, 3 to 8 steps, and in one
of four worlds eight directions, evenly. Drawn anew: values outside of .1 and .9, tables of
successors with more than 200,000 entries times steps, worlds at once in which it is worth less than
.02 to move second, and those that differ from another one in steps or collisions alone.
"""
TURNS = {"agents in turns": Interaction.AGENT_TURNS, "teams in turns": Interaction.SWARM_TURNS}
CAPTURES = {"occupied": {}, "surrounded": {"evader": Outcome.BOUNCE, "capture": Capture.SURROUND}}


def config_of(name: str) -> mw.WorldConfig:
    """Return the world of a name, as those in `WORLDS`."""
    rules, teams, board, steps = name.split("; ")
    turns, _, capture = rules.partition(", ")
    size, *walls = board.split(" with walls ")
    (pursuers, evaders), (rows, cols) = teams.split(" v "), size.split(" x ")
    return mw.WorldConfig(
        Rules(TURNS[turns], **CAPTURES[capture]) if capture else rules,
        rows=int(rows), cols=int(cols), n_pursuers=int(pursuers), n_evaders=int(evaders),
        max_steps=int(steps.split()[0]), diagonal=steps.endswith("8 ways"),
        obstacles=walls[0].split("/") if walls else None, fov=2 * max(int(rows), int(cols)) - 1,
    )  # fmt: skip


# Games


class Game:
    """A solved world as arrays, with exact responses and payoffs of tables."""

    def __init__(self, config: mw.WorldConfig) -> None:
        self.config, self.rounds = config, config.max_steps
        self.states = States(config, threads=1)
        self.succ = [self.states.successors(k).astype(np.intp) for k in range(self.states.n_turns)]
        self.starts = self.states.starts.astype(np.intp)
        self.payoffs = np.asarray(self.states.captured().mean(axis=1), np.float64)

    @property
    def together(self) -> bool:
        """Whether all agents move at once, so that it can be best to mix."""
        return self.config.rules.interaction is Interaction.SIMULTANEOUS

    @cached_property
    def value(self) -> float:
        """The capture rate of perfect play."""
        return solve(self.states).value

    @cached_property
    def of_tables(self) -> tuple[float, float]:
        """The best that tables guarantee: captures of pursuers, and captures that evaders concede.

        Whoever answers a table knows its action in each state, as if it moved second: no table of
        the pursuers guarantees more than the first number, none of the evaders concedes less than
        the second, and the actions chosen here are tables that do so in all states. So the NashConv
        of a pair of tables is at least `mixing`, their difference, which some pair has. It is 0
        where agents or teams take turns.
        """
        first, second = self.payoffs, self.payoffs
        for _ in range(self.rounds):
            for succ in reversed(self.succ):
                first = first[succ].min(axis=2).max(axis=1)
                second = second[succ].max(axis=1).min(axis=1)
        return float(first[self.starts].mean()), float(second[self.starts].mean())

    @property
    def mixing(self) -> float:
        """How much more is captured if pursuers move second, in all rounds, than if evaders do."""
        return self.of_tables[1] - self.of_tables[0]

    @cached_property
    def features(self) -> list[Floats]:
        """What a linear rating knows of each state, by turn (S, features): counts.

        Of the agents of each team by cell, of pairs of a pursuer and an evader by the rows and
        columns between them, and of captured evaders. Agents that are gone are in no count.
        """
        rows, cols, first = self.config.rows, self.config.cols, self.config.n_pursuers
        found = []
        for turn, succ in enumerate(self.succ):
            cells, counts = self.states.cells(turn), np.zeros((3, len(succ), rows * cols))

            def count(kind: int, there: NDArray[np.bool_], what: NDArray[Any]) -> None:
                np.add.at(counts[kind], (np.flatnonzero(there), what[there]), 1.0)  # noqa: B023

            for agent, at in enumerate(cells.T):
                count(int(agent >= first), at >= 0, at)
            for p, e in product(cells.T[:first], cells.T[first:]):
                apart = abs(p // cols - e // cols) * cols + abs(p % cols - e % cols)
                count(2, (p >= 0) & (e >= 0), apart)
            captured = self.states.captured(turn).sum(axis=1, keepdims=True)
            found.append(np.hstack([*counts, captured]))
        return found

    @cached_property
    def prospects(self) -> dict[tuple[Team, int], tuple[Floats, Floats]]:
        """What joint actions of a team lead to in a turn: features (S, actions, features).

        Means over all actions of the other team, minus the mean over those of the team. And
        their products, summed over the actions (S, features, features).
        """
        found = {}
        for turn, succ in enumerate(self.succ):
            after = self.features[(turn + 1) % len(self.succ)][succ]
            for axis, team in enumerate(TEAMS):
                if self.acts(turn, team):
                    means = after.mean(axis=2 - axis)
                    known = means - means.mean(axis=1, keepdims=True)
                    found[team, turn] = known, known.transpose(0, 2, 1) @ known
        return found

    def shapes(self, team: Team) -> Iterator[tuple[int, int, int]]:
        """Yield the rounds, states and joint actions of a team in each turn."""
        for succ in self.succ:
            yield self.rounds, len(succ), succ.shape[1 + TEAMS.index(team)]

    def random(self, team: Team, rng: np.random.Generator) -> Table:
        """Return a table whose actions are drawn evenly."""
        return [
            rng.integers(actions, size=(rounds, count), dtype=np.int16)
            for rounds, count, actions in self.shapes(team)
        ]

    def mixed(self, team: Team, tables: list[Table], weights: Floats) -> Play:
        """Return the mixture of tables, which draws one of them in every turn anew."""
        total: dict[int, float] = {}  # a table that comes again is the same object
        for table, weight in zip(tables, weights, strict=True):
            total[id(table)] = total.get(id(table), 0.0) + float(weight)
        shares = {key: weight for key, weight in total.items() if weight > 0.0}
        drawn = [next(each for each in tables if id(each) == key) for key in shares]
        play = []
        for turn, shape in enumerate(self.shapes(team)):
            if shape[2] == 1:
                play.append(np.ones(shape))
                continue
            size = shape[0] * shape[1]
            places = np.stack([each[turn].ravel() for each in drawn]) + np.arange(size) * shape[2]
            spread = np.repeat([*shares.values()], size)
            counts = np.bincount(places.ravel(), spread, size * shape[2])
            play.append(counts.reshape(shape))
        return play

    def gains(self, turn: int, left: int, after: Floats, team: Team, opponents: Play) -> Floats:
        """Return what each joint action of a team leads to on average, (S, joint actions)."""
        games = after[self.succ[turn]]
        if team == "pursuer":
            if games.shape[2] == 1:
                return games[:, :, 0]
            return np.matmul(games, opponents[turn][left][:, :, None])[:, :, 0]
        if games.shape[1] == 1:
            return games[:, 0]
        return np.matmul(opponents[turn][left][:, None, :], games)[:, 0]

    def respond(self, team: Team, opponents: Play, own: Table | None = None) -> tuple[Table, float]:
        """Return the best response of a team in all states, and the capture rate.

        Of actions that are equally good it takes that of its `own` table if it is one of them, else
        the first.
        """
        sign, after = (1.0 if team == "pursuer" else -1.0), self.payoffs
        table = [np.zeros(shape[:2], np.int16) for shape in self.shapes(team)]
        for left in range(self.rounds):
            for turn in reversed(range(len(self.succ))):
                if not self.acts(turn, team):
                    after = self.averaged(turn, left, after, opponents, other(team))
                    continue
                gains = sign * self.gains(turn, left, after, team, opponents)
                chosen = gains.argmax(axis=1)
                best = gains[np.arange(len(gains)), chosen]
                if own is not None:
                    now = own[turn][left]
                    stays = gains[np.arange(len(gains)), now] >= best - TIE
                    chosen = np.where(stays, now, chosen)
                table[turn][left] = chosen
                after = sign * best
        return table, float(after[self.starts].mean())

    def acts(self, turn: int, team: Team) -> bool:
        """Return whether a team acts in a turn."""
        return self.succ[turn].shape[1 + TEAMS.index(team)] > 1

    def averaged(self, turn: int, left: int, after: Floats, play: Play, team: Team) -> Floats:
        """Return the values (S,) before a turn in which only one team acts, by its play."""
        succ = self.succ[turn]
        games = after[succ[:, :, 0] if team == "pursuer" else succ[:, 0]]
        return np.asarray((games * play[turn][left]).sum(axis=1))

    def reached(self, team: Team, own: Table, opponents: Play) -> list[Floats]:
        """Return how often each state is met, by turn (rounds, S), if a table meets a mixture."""
        found = [np.zeros(shape[:2]) for shape in self.shapes(team)]
        now = np.bincount(self.starts, minlength=len(self.succ[0])) / len(self.starts)
        for left in reversed(range(self.rounds)):
            for turn, succ in enumerate(self.succ):
                found[turn][left] = now
                met = np.flatnonzero(now)
                actions = own[turn][left][met]
                after = succ[met, actions] if team == "pursuer" else succ[met, :, actions]
                shares = opponents[turn][left][met] * now[met, None]
                count = len(self.succ[(turn + 1) % len(self.succ)])
                now = np.bincount(after.ravel(), shares.ravel(), count)
        return found

    def met(self, pursuers: Play, evaders: Play) -> list[NDArray[np.bool_]]:
        """Return which states random policies can reach, by turn (rounds, S)."""
        found = [np.zeros((self.rounds, len(succ)), np.bool_) for succ in self.succ]
        found[0][-1, self.starts] = True
        for left in reversed(range(self.rounds)):
            for turn, succ in enumerate(self.succ):
                now = np.flatnonzero(found[turn][left])
                p, e = (play[turn][left, now] > 0.0 for play in (pursuers, evaders))
                after = succ[now][p[:, :, None] & e[:, None]]
                if turn + 1 < len(self.succ):
                    found[turn + 1][left, after] = True
                elif left > 0:
                    found[0][left - 1, after] = True
        return found

    def scores(self, pursuers: list[Table], evaders: list[Table]) -> Floats:
        """Return the exact capture rates (n, m) of tables that meet each other."""
        if not pursuers or not evaders:
            return np.empty((len(pursuers), len(evaders)))
        rows, columns = ({id(each): each for each in of} for of in (pursuers, evaders))
        found = self._played([*rows.values()], [*columns.values()])
        at = [
            [[*of].index(id(each)) for each in tables]
            for of, tables in ((rows, pursuers), (columns, evaders))
        ]
        return found[np.ix_(*at)]

    def _played(self, pursuers: list[Table], evaders: list[Table]) -> Floats:
        first, second = (
            [np.stack(each) for each in zip(*tables, strict=True)] for tables in (pursuers, evaders)
        )
        n, m = len(pursuers), len(evaders)
        now = np.broadcast_to(self.starts, (n, m, len(self.starts)))
        rows, columns = np.arange(n)[:, None, None], np.arange(m)[None, :, None]
        for left in reversed(range(self.rounds)):
            for turn, succ in enumerate(self.succ):
                count, _, actions = succ.shape
                place = now * (succ.shape[1] * actions)
                if self.acts(turn, "pursuer"):
                    place += first[turn][:, left].take(now + rows * count).astype(np.intp) * actions
                if self.acts(turn, "evader"):
                    place += second[turn][:, left].take(now + columns * count)
                now = succ.take(place)
        return np.asarray(self.payoffs.take(now).mean(axis=2))

    def guarantee(
        self, team: Team, play: Play, kept: list[NDArray[np.bool_]] | None = None
    ) -> float:
        """Return the capture rate of a team's play against the best response.

        If some states are `kept`, by turn (rounds, S), it plays there what it plays, and in all
        others as well as it can then. It guarantees no less than by its own play.
        """
        if kept is None:
            return self.respond(other(team), play)[1]
        after, rival = self.payoffs, other(team)
        for left in range(self.rounds):
            for turn in reversed(range(len(self.succ))):
                free = self.states.core.backup(turn, after, None, None, False, 1, None)[0]
                gains = self.gains(turn, left, after, rival, play)
                own = gains.max(axis=1) if rival == "pursuer" else gains.min(axis=1)
                after = np.where(kept[turn][left], own, free)
        return float(after[self.starts].mean())


# Schedules: with which weights the next response of a team meets the past policies of the other


Scores = Callable[[], Floats]
"""The scores of a team's generations against its opponents so far, if they are wanted."""
Weights = Callable[[int, Scores], Floats]
"""How many opponents there are, and the scores -> their weights."""


def newest(count: int, scores: Scores) -> Floats:
    """Return the weights of specialists."""
    return np.eye(count)[-1]


def every(count: int, scores: Scores) -> Floats:
    """Return the weights of generalists; if they learn perfectly, this is fictitious play."""
    return np.full(count, 1.0 / count)


def hall(count: int, scores: Scores) -> Floats:
    """Return the weights of a hall of fame: two living opponents and one of the hall."""
    return 2 / 3 * newest(count, scores) + 1 / 3 * every(count, scores)


def nash(count: int, scores: Scores) -> Floats:
    """Return the opponents' weights in an equilibrium of the matrix (PSRO)."""
    return equilibrium(scores())[1]


def equilibrium(own: Floats) -> tuple[Floats, Floats]:
    """Return a pair of equilibrium mixtures of a matrix, rows maximizing, by one programme."""
    rows, columns = own.shape
    found = linprog(
        np.append(np.zeros(rows), -1.0),
        np.hstack([-own.T, np.ones((columns, 1))]), np.zeros(columns),
        np.append(np.ones(rows), 0.0)[None], [1.0],
        [(0.0, None)] * rows + [(None, None)], method="highs",
    )  # fmt: skip
    if found.status:
        raise RuntimeError(f"expected an equilibrium, got: {found.message}")
    mixtures = (np.maximum(each, 0.0) for each in (found.x[:rows], -found.ineqlin.marginals))
    first, second = (each / each.sum() for each in mixtures)
    return first, second


@dataclass(frozen=True)
class Schedule:
    """Whom the next response of each team meets, and whether only better ones are kept."""

    pursuers: Weights
    evaders: Weights
    keeps: bool = False

    def meets(self, team: Team) -> Weights:
        """Return the weights of a team's opponents."""
        return self.pursuers if team == "pursuer" else self.evaders


SPECIALISTS, GENERALISTS = "specialists", "generalists"
SCHEDULES: Mapping[str, Schedule] = {
    SPECIALISTS: Schedule(newest, newest),
    "generalists v specialists": Schedule(every, newest),
    GENERALISTS: Schedule(every, every),
    "hall of fame": Schedule(hall, hall),
    "PSRO, Nash": Schedule(nash, nash),
    "specialists that retain": Schedule(newest, newest, keeps=True),
}
"""The first three are those of Sun et al. (2023). The last one answers the newest opponent, and
keeps the response only if its mean score against all past opponents is not below that of the newest
own generation, which stays otherwise."""


# Learners


@dataclass(frozen=True)
class Task:
    """A team, its newest table, and the tables of the other team that it meets, with weights."""

    game: Game
    team: Team
    own: Table
    past: list[Table]
    weights: Floats
    rng: np.random.Generator

    @cached_property
    def opponents(self) -> Play:
        """The mixture that is met."""
        return self.game.mixed(other(self.team), self.past, self.weights)

    @cached_property
    def best(self) -> Table:
        """The best response in every state, also in those that are not met."""
        return self.game.respond(self.team, self.opponents, self.own)[0]

    def changed(self, table: Table) -> Table:
        """Return the own table with the actions of another one where the best response leads."""
        met = self.game.reached(self.team, self.best, self.opponents)
        return [np.where(each > 0.0, b, o) for each, b, o in zip(met, table, self.own, strict=True)]


Learner = Callable[[Task], Table]
"""The next table."""


def perfect(task: Task) -> Table:
    """Return the best response in every state."""
    return task.best


def on_the_way(task: Task) -> Table:
    """Return a best response that changes only states that it meets."""
    return task.changed(task.best)


def noisy(task: Task) -> Table:
    """Return the best response, on the way, of which a tenth of the met states acts at random."""
    tables = zip(task.game.random(task.team, task.rng), task.best, strict=True)
    return task.changed([np.where(task.rng.random(b.shape) < 0.1, wrong, b) for wrong, b in tables])


def improved(task: Task) -> Table:
    """Return one step of policy improvement in the states that the own table meets.

    The action changes to the best one, if the own table plays afterwards. States that it does not
    meet never change, nor does it learn what they are good for.
    """
    game, team, own, opponents = task.game, task.team, task.own, task.opponents
    sign, after = (1.0 if team == "pursuer" else -1.0), game.payoffs
    better, met = [each.copy() for each in own], game.reached(team, own, opponents)
    for left in range(game.rounds):
        for turn in reversed(range(len(game.succ))):
            if not game.acts(turn, team):
                after = game.averaged(turn, left, after, opponents, other(team))
                continue
            gains = sign * game.gains(turn, left, after, team, opponents)
            now = gains[np.arange(len(gains)), own[turn][left]]
            gainful = (gains.max(axis=1) > now + TIE) & (met[turn][left] > 0.0)
            better[turn][left] = np.where(gainful, gains.argmax(axis=1), own[turn][left])
            after = sign * now
    return better


def rated(task: Task) -> Table:
    """Return the table of a linear rating: it plays in all states as it learned in some.

    It rates the features of the states that an action leads to (`Game.prospects`), and takes the
    best rated one in each state, in all rounds. One rating for each turn of a round is fitted by
    least squares to what each action is worth if best responses follow, in the states that these
    meet.
    """
    game, team, opponents = task.game, task.team, task.opponents
    sign, after = (1.0 if team == "pursuer" else -1.0), game.payoffs
    met = game.reached(team, task.best, opponents)
    worth = [np.zeros(shape[1:]) for shape in game.shapes(team)]
    for left in range(game.rounds):
        for turn in reversed(range(len(game.succ))):
            if not game.acts(turn, team):
                after = game.averaged(turn, left, after, opponents, other(team))
                continue
            gains = sign * game.gains(turn, left, after, team, opponents)
            worth[turn] += met[turn][left][:, None] * gains
            after = sign * gains.max(axis=1)
    table = [each.copy() for each in task.own]
    for turn, sums in enumerate(worth):
        if game.acts(turn, team):
            (features, products), weights = game.prospects[team, turn], met[turn].sum(axis=0)
            squares = np.tensordot(weights, products, 1)
            sides = np.tensordot(sums, features, 2)
            rating = np.linalg.solve(squares + RIDGE * np.eye(len(squares)), sides)
            ratings = features @ rating
            best = ratings >= ratings.max(axis=1, keepdims=True) - EQUAL
            stays = best[np.arange(len(best)), table[turn]]
            table[turn] = np.where(stays, table[turn], best.argmax(axis=1)).astype(np.int16)
    return table


LEARNERS: Mapping[str, Learner] = {
    "perfect": perfect,
    "perfect where it plays": on_the_way,
    "10 % wrong": noisy,
    "linear rating": rated,
    "improves what it meets": improved,
}


# Races


class Race:
    """Tables of both teams, generation by generation, and their scores."""

    def __init__(self, game: Game, schedule: Schedule, learner: Learner, seed: int) -> None:
        self.game, self.schedule, self.learner = game, schedule, learner
        first, self.rng = (np.random.default_rng([seed, k]) for k in range(2))
        self.tables: dict[Team, list[Table]] = {team: [game.random(team, first)] for team in TEAMS}
        self._rates: dict[bool, Floats] = {}
        self._known: dict[bytes, Table] = {}

    def opponents(self, team: Team) -> list[Table]:
        """Return the past policies that a team meets."""
        return self.tables[other(team)]

    def scores(self, team: Team) -> Floats:
        """Return the scores of a team's generations against the past policies that it meets."""
        own, met, first = self.tables[team], self.opponents(team), team == "pursuer"
        pursuers, evaders = (own, met) if first else (met, own)
        # In a race both teams have the same matrix; where opponents are replayed each has its own.
        key = first or type(self) is Race
        known = self._rates.get(key, np.empty((0, 0)))
        rows, columns = known.shape
        known = np.vstack([known, self.game.scores(pursuers[rows:], evaders[:columns])])
        known = np.hstack([known, self.game.scores(pursuers, evaders[columns:])])
        self._rates[key] = known
        return known if first else 1.0 - known.T

    def _mean(self, team: Team, table: Table) -> float:
        own, met = [table], self.opponents(team)
        sides = (own, met) if team == "pursuer" else (met, own)
        rate = float(self.game.scores(*sides).mean())
        return rate if team == "pursuer" else 1.0 - rate

    def go(self) -> None:
        """Add a generation: pursuers answer the evaders so far, then evaders the pursuers."""
        for team in TEAMS:
            own, past = self.tables[team], self.opponents(team)
            weights = self.schedule.meets(team)(len(past), partial(self.scores, team))
            answer = self.learner(Task(self.game, team, own[-1], past, weights, self.rng))
            if self.schedule.keeps:
                new, old = (self._mean(team, each) for each in (answer, own[-1]))
                answer = answer if new >= old - TIE else own[-1]
            # What comes again is the same object: it is played and mixed only once.
            key = team.encode() + b"".join(each.tobytes() for each in answer)
            own.append(self._known.setdefault(key, answer))

    def run(self, generations: int) -> Race:
        """Add so many generations; return the race."""
        for _ in range(generations):
            self.go()
        return self

    def shares(self, team: Team, choice: str) -> tuple[Floats, Floats]:
        """Return how often a choice takes each generation of a team, and each of its opponents."""
        if choice == "mixture":
            return equilibrium(self.scores(team))
        weights = {"newest": newest, "average": every}[choice]
        known = partial(self.scores, team)
        return weights(len(self.tables[team]), known), weights(len(self.opponents(team)), known)

    def chosen(self, team: Team, choice: str) -> Play:
        """Return the newest generation, or a mixture of all."""
        return self.game.mixed(team, self.tables[team], self.shares(team, choice)[0])

    def nash_convs(self, choice: str) -> tuple[float, float, float]:
        """Return the NashConv of a choice, and how much of it is lost in states that were met.

        The first is what the best responses of both teams gain. The others are what is left of it
        if teams keep their play only in states that it can reach against all their opponents so
        far, or against the same choice of these, and play as well as they can in all other states.
        """
        game, found = self.game, []
        for team in TEAMS:
            own, same = self.shares(team, choice)
            play, rivals = game.mixed(team, self.tables[team], own), self.opponents(team)
            guarantees, every_one = [game.guarantee(team, play)], np.full(len(same), 1 / len(same))
            for shares in (every_one, same)[: 1 if choice == "average" else 2]:
                met = game.mixed(other(team), rivals, shares)
                kept = game.met(*((play, met) if team == "pursuer" else (met, play)))
                guarantees.append(game.guarantee(team, play, kept))
            if choice == "average":
                guarantees.append(guarantees[-1])
            found.append(guarantees)
        total, against_all, against_same = (e - p for p, e in zip(*found, strict=True))
        return total, against_all, against_same

    def nash_conv(self) -> float:
        """Return the NashConv of the newest generations."""
        p, e = (self.game.guarantee(team, self.chosen(team, "newest")) for team in TEAMS)
        return e - p
