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
from dataclasses import dataclass, replace
from functools import cached_property, partial
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import linprog

import matrixworld as mw
from matrixworld import Capture, Interaction, Outcome, Rules
from matrixworld.coevolution import TEAMS, Team
from matrixworld.coevolution.types import other
from matrixworld.solver import States, solve

CHOICES = ("newest", "chosen", "average", "mixture")
"""What of all generations of a race is told of: `Race.chosen`."""
Table: TypeAlias = list[NDArray[np.int16]]
"""A policy: by turn, the joint action (rounds, S). The first axis is the rounds left, minus 1."""
Play: TypeAlias = list[NDArray[np.float64]]
"""A random policy: by turn, the probabilities (rounds, S, joint actions)."""
Floats: TypeAlias = NDArray[np.float64]
TIE = 1e-9
"""Values closer than this are equal."""


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

    @property
    def mixing(self) -> float:
        """How much more is captured if pursuers move second, in all rounds, than if evaders do."""
        second, first = self.payoffs, self.payoffs
        for _ in range(self.rounds):
            for succ in reversed(self.succ):
                second = second[succ].max(axis=1).min(axis=1)
                first = first[succ].min(axis=2).max(axis=1)
        return float(second[self.starts].mean() - first[self.starts].mean())

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
        play = [np.zeros(shape) for shape in self.shapes(team)]
        for weight, table in zip(weights, tables, strict=True):
            if weight > 0.0:
                for shares, actions in zip(play, table, strict=True):
                    places = np.arange(actions.size) * shares.shape[2] + actions.ravel()
                    shares.reshape(-1)[places] += weight
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

    def scores(self, pursuers: list[Table], evaders: list[Table]) -> Floats:
        """Return the exact capture rates (n, m) of tables that meet each other."""
        first = [np.stack(each)[:, None] for each in zip(*pursuers, strict=True)]
        second = [np.stack(each)[None] for each in zip(*evaders, strict=True)]
        return self.played(first, second, self.starts)

    def played(
        self, first: list[NDArray[Any]], second: list[NDArray[Any]], starts: NDArray[np.intp]
    ) -> Floats:
        """Return the mean capture rates of tables (n, m, rounds, S), one episode a start."""
        n, m = first[0].shape[0], second[0].shape[1]
        now = np.broadcast_to(starts, (n, m, len(starts)))
        rows, columns = np.arange(n)[:, None, None], np.arange(m)[None, :, None]
        for left in reversed(range(self.rounds)):
            for turn, succ in enumerate(self.succ):
                p = first[turn][rows, 0, left, now] if self.acts(turn, "pursuer") else 0
                e = second[turn][0, columns, left, now] if self.acts(turn, "evader") else 0
                now = succ[now, p, e]
        return np.asarray(self.payoffs[now].mean(axis=2))

    def guarantee(self, team: Team, play: Play) -> float:
        """Return the capture rate of a team's play against the best response."""
        return self.respond(other(team), play)[1]


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


def hard(count: int, scores: Scores) -> Floats:
    """Return weights by how often the newest generation loses, squared (Vinyals et al. 2019)."""
    losses = (1.0 - scores()[-1]) ** 2
    return losses / losses.sum() if losses.sum() > TIE else every(count, scores)


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
    "prioritised": Schedule(hard, hard),
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


def sampled(task: Task, count: int) -> Table:
    """Return the best response, on the way, to some opponents drawn by their weights."""
    drawn = task.rng.choice(len(task.past), count, p=task.weights)
    shares = np.bincount(drawn, minlength=len(task.past)) / count
    return on_the_way(replace(task, weights=shares))


def noisy(task: Task, share: float) -> Table:
    """Return the best response, on the way, of which a share of the met states acts at random."""
    tables = zip(task.game.random(task.team, task.rng), task.best, strict=True)
    return task.changed(
        [np.where(task.rng.random(b.shape) < share, wrong, b) for wrong, b in tables]
    )


def slow(task: Task, share: float) -> Table:
    """Change each state that the best response meets to its action with a probability."""
    tables = zip(on_the_way(task), task.own, strict=True)
    return [np.where(task.rng.random(b.shape) < share, b, o) for b, o in tables]


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


def best_of(task: Task, candidates: int, opponents: int = 4, starts: int = 64) -> Table:
    """Return the best of some random changes of the own table, itself included.

    Opponents are drawn by their weights and meet all candidates from some starts. A candidate
    changes each action with a probability between .001 and .1, drawn evenly in its logarithm.
    """
    game, rng = task.game, task.rng
    rates = np.append(0.0, 10.0 ** rng.uniform(-3, -1, candidates - 1))
    tried = [np.repeat(each[None], candidates, axis=0) for each in task.own]
    for each, (rounds, count, actions) in zip(tried, game.shapes(task.team), strict=True):
        if actions > 1:
            for place, rate in enumerate(rates):
                n = rng.binomial(rounds * count, rate)
                where = rng.integers(rounds * count, size=n)
                each[place].reshape(-1)[where] = rng.integers(actions, size=n)
    drawn = rng.choice(len(task.past), opponents, p=task.weights)
    rivals = [np.stack([task.past[k][turn] for k in drawn]) for turn in range(len(task.own))]
    begun = rng.choice(game.starts, min(starts, len(game.starts)), replace=False)
    sides = (tried, rivals) if task.team == "pursuer" else (rivals, tried)
    rates = game.played(
        [each[:, None] for each in sides[0]], [each[None] for each in sides[1]], begun
    )
    mean = rates.mean(axis=1) if task.team == "pursuer" else 1.0 - rates.mean(axis=0)
    best = int(mean.argmax())
    return [each[best] for each in tried]


LEARNERS: Mapping[str, Learner] = {
    "perfect": perfect,
    "perfect where it plays": on_the_way,
    "against 3 of the past": partial(sampled, count=3),
    "against 1 of the past": partial(sampled, count=1),
    "10 % wrong": partial(noisy, share=0.1),
    "30 % wrong": partial(noisy, share=0.3),
    "10 % of the changes": partial(slow, share=0.1),
    "2 % of the changes": partial(slow, share=0.02),
    "improves what it meets": improved,
    "best of 32 changes": partial(best_of, candidates=32),
}


# Races


class Race:
    """Tables of both teams, generation by generation, and their scores."""

    def __init__(self, game: Game, schedule: Schedule, learner: Learner, seed: int) -> None:
        self.game, self.schedule, self.learner = game, schedule, learner
        first, self.rng = (np.random.default_rng([seed, k]) for k in range(2))
        self.tables: dict[Team, list[Table]] = {team: [game.random(team, first)] for team in TEAMS}
        self.rates: dict[Team, Floats] = {team: np.empty((0, 0)) for team in TEAMS}

    def opponents(self, team: Team) -> list[Table]:
        """Return the past policies that a team meets."""
        return self.tables[other(team)]

    def scores(self, team: Team) -> Floats:
        """Return the scores of a team's generations against the past policies that it meets."""
        own, met, known = self.tables[team], self.opponents(team), self.rates[team]
        rows, columns = known.shape
        known = np.vstack([known, self._scores(team, own[rows:], met[:columns])])
        known = np.hstack([known, self._scores(team, own, met[columns:])])
        self.rates[team] = known
        return known

    def _scores(self, team: Team, own: list[Table], met: list[Table]) -> Floats:
        if not own or not met:
            return np.empty((len(own), len(met)))
        if team == "pursuer":
            return self.game.scores(own, met)
        return 1.0 - self.game.scores(met, own).T

    def go(self) -> None:
        """Add a generation: pursuers answer the evaders so far, then evaders the pursuers."""
        for team in TEAMS:
            own, past = self.tables[team], self.opponents(team)
            weights = self.schedule.meets(team)(len(past), partial(self.scores, team))
            answer = self.learner(Task(self.game, team, own[-1], past, weights, self.rng))
            if self.schedule.keeps:
                new, old = self._scores(team, [answer, own[-1]], past).mean(axis=1)
                answer = answer if new >= old - TIE else own[-1]
            own.append(answer)

    def run(self, generations: int) -> Race:
        """Add so many generations; return the race."""
        for _ in range(generations):
            self.go()
        return self

    def chosen(self, team: Team, choice: str) -> Play:
        """Return the newest generation, the one of the highest mean score, or a mixture of all."""
        count = len(self.tables[team])
        if choice == "newest":
            weights = np.eye(count)[-1]
        elif choice == "average":
            weights = np.full(count, 1.0 / count)
        elif choice == "mixture":
            weights = equilibrium(self.scores(team))[0]
        else:
            means = self.scores(team).mean(axis=1)
            weights = np.eye(count)[np.flatnonzero(means >= means.max() - TIE)[-1]]
        return self.game.mixed(team, self.tables[team], weights)

    def nash_conv(self, choice: str = "newest") -> float:
        """Return the NashConv of a choice: what the best responses of both teams gain."""
        p, e = (self.game.guarantee(team, self.chosen(team, choice)) for team in TEAMS)
        return e - p
