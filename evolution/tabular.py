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

IN_TURNS = {
    "agents in turns": {"interaction": Interaction.AGENT_TURNS},
    "teams in turns": {"interaction": Interaction.SWARM_TURNS},
}
CAPTURES = {"occupied": {}, "surrounded": {"evader": Outcome.BOUNCE, "capture": Capture.SURROUND}}
BOARDS = ((3, 3), (3, 4), (4, 4), (3, 5), (4, 5), (5, 5))
TEAMS_OF = ((1, 1), (2, 1), (1, 2))
"""Pursuers and evaders, of two worlds one after the other."""
MOST_WALLS = 3
STEPS = (3, 4, 5, 6, 7, 8)
WORK = 200_000
"""Most entries of all tables of successors, times steps: a response takes about a millisecond."""
FAIR = 0.1, 0.9
"""Values of the worlds: in others one team wins nearly always."""
MIXING = 0.02
"""What it is worth at least, where all move at once, to move second: else nobody has to mix."""


@dataclass(frozen=True)
class World:
    """A world, as drawn. Worlds that are `like` each other differ in steps or collisions alone."""

    name: str
    like: str
    config: mw.WorldConfig

    @property
    def together(self) -> bool:
        """Whether all agents move at once, so that it can be best to mix."""
        return self.config.rules.interaction is Interaction.SIMULTANEOUS


def drawn_worlds(count: int, seed: int, work: int = WORK) -> list[World]:
    """Return worlds drawn by chance, in turns and at once in alternation, none like another.

    Each choice is drawn evenly: rules, board, walls, steps, and in one of four worlds moves in
    eight directions; the teams are those of `TEAMS_OF` in their order. Worlds with values out of
    `FAIR`, with more than `WORK`, or in which all move at once and `mixing` is worth less than
    `MIXING`, are drawn anew.
    """
    rng, found = np.random.default_rng(seed), dict[str, World]()
    while len(found) < count:
        pair, at_once = divmod(len(found), 2)
        each = _drawn(rng, TEAMS_OF[pair % len(TEAMS_OF)], bool(at_once))
        if each is None or each.like in found or _work(each.config) > work:
            continue
        game = Game(each.config)
        fair = FAIR[0] <= game.value <= FAIR[1]
        if fair and (not each.together or game.mixing >= MIXING):
            found[each.like] = each
    return list(found.values())


def _drawn(rng: np.random.Generator, teams: tuple[int, int], at_once: bool) -> World | None:
    def one(choices: Any) -> Any:
        return choices[int(rng.integers(len(choices)))]

    if at_once:
        variant = one(("R", "B", "O", "S", "SB", "SD", "SDB"))
        rules = mw.VARIANTS[variant]
    else:
        moves, capture = one([*IN_TURNS]), one([*CAPTURES])
        rules = Rules(**{"interaction": Interaction.AGENT_TURNS, **CAPTURES[capture]})
        rules = replace(rules, **IN_TURNS[moves])
        variant = f"{moves}, {capture}"
    (rows, cols), (pursuers, evaders) = one(BOARDS), teams
    walls, steps = int(rng.integers(MOST_WALLS + 1)), one(STEPS)
    diagonal = bool(rng.integers(4) == 0)
    blocked = np.zeros(rows * cols, bool)
    blocked[rng.choice(rows * cols, walls, replace=False)] = True
    if not _connected(blocked.reshape(rows, cols)):
        return None
    lines = ["".join(".#"[cell] for cell in row) for row in blocked.reshape(rows, cols).astype(int)]
    shown = f"{rows} x {cols}" + (f" with walls {'/'.join(lines)}" if walls else "")
    name = f"{variant}; {pursuers} v {evaders}; {shown}; {steps} steps" + ", 8 ways" * diagonal
    config = mw.WorldConfig(
        rules, rows=rows, cols=cols, n_pursuers=pursuers, n_evaders=evaders, max_steps=steps,
        diagonal=diagonal, obstacles=lines if walls else None, fov=2 * max(rows, cols) - 1,
    )  # fmt: skip
    capture = rules.capture.name.lower()
    like = f"{rules.interaction.name}; {capture}; {pursuers} v {evaders}; {shown}; {diagonal}"
    return World(name, like, config)


def _connected(blocked: NDArray[np.bool_]) -> bool:
    free = {(int(row), int(col)) for row, col in np.argwhere(~blocked)}
    seen, left = set[tuple[int, int]](), [min(free)]
    while left:
        row, col = left.pop()
        if (row, col) in free and (row, col) not in seen:
            seen.add((row, col))
            left += [(row + 1, col), (row - 1, col), (row, col + 1), (row, col - 1)]
    return seen == free


def _work(config: mw.WorldConfig) -> float:
    from matrixworld.solver.states import size_of, turn_sizes

    if size_of(config)[1] > 1e8:
        return np.inf
    return config.max_steps * sum(count * p * q for count, p, q in turn_sizes(config))


# Games


class Game:
    """A solved world as arrays, with exact responses and payoffs of tables."""

    def __init__(self, config: mw.WorldConfig) -> None:
        self.config, self.rounds = config, config.max_steps
        self.states = States(config, threads=1)
        self.succ = [self.states.successors(k).astype(np.intp) for k in range(self.states.n_turns)]
        self.starts = self.states.starts.astype(np.intp)
        self.payoffs = np.asarray(self.states.captured().mean(axis=1), np.float64)

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


# Learners: (game, team, own newest table, opponents' tables, weights, rng) -> the next table

Learner = Callable[[Game, Team, Table, list[Table], Floats, np.random.Generator], Table]


def perfect(
    game: Game, team: Team, own: Table, past: list[Table], weights: Floats,
    rng: np.random.Generator,
) -> Table:  # fmt: skip
    """Return the best response in every state, also in those that are not met."""
    return game.respond(team, game.mixed(other(team), past, weights), own)[0]


def on_the_way(
    game: Game, team: Team, own: Table, past: list[Table], weights: Floats,
    rng: np.random.Generator,
) -> Table:  # fmt: skip
    """Return a best response that changes only states that it meets."""
    opponents = game.mixed(other(team), past, weights)
    best, _ = game.respond(team, opponents, own)
    met = game.reached(team, best, opponents)
    return [np.where(each > 0.0, b, o) for each, b, o in zip(met, best, own, strict=True)]


@dataclass(frozen=True)
class Sampled:
    """The best response, on the way, to some opponents drawn by their weights."""

    count: int

    def __call__(
        self, game: Game, team: Team, own: Table, past: list[Table], weights: Floats,
        rng: np.random.Generator,
    ) -> Table:  # fmt: skip
        """Return the next table."""
        drawn = rng.choice(len(past), self.count, p=weights)
        shares = np.bincount(drawn, minlength=len(past)) / self.count
        return on_the_way(game, team, own, past, shares, rng)


@dataclass(frozen=True)
class Noisy:
    """The best response, on the way, of which a share of the met states has random actions."""

    share: float

    def __call__(
        self, game: Game, team: Team, own: Table, past: list[Table], weights: Floats,
        rng: np.random.Generator,
    ) -> Table:  # fmt: skip
        """Return the next table."""
        opponents = game.mixed(other(team), past, weights)
        best, _ = game.respond(team, opponents, own)
        met = game.reached(team, best, opponents)
        return [
            np.where(
                each > 0.0, np.where(rng.random(each.shape) < self.share, wrong, right), before
            )
            for each, wrong, right, before in zip(
                met, game.random(team, rng), best, own, strict=True
            )
        ]


@dataclass(frozen=True)
class Slow:
    """Each state that the best response meets changes to its action with a probability."""

    share: float

    def __call__(
        self, game: Game, team: Team, own: Table, past: list[Table], weights: Floats,
        rng: np.random.Generator,
    ) -> Table:  # fmt: skip
        """Return the next table."""
        best = on_the_way(game, team, own, past, weights, rng)
        return [
            np.where(rng.random(b.shape) < self.share, b, o) for b, o in zip(best, own, strict=True)
        ]


def improved(
    game: Game, team: Team, own: Table, past: list[Table], weights: Floats,
    rng: np.random.Generator,
) -> Table:  # fmt: skip
    """Return one step of policy improvement in the states that the own table meets.

    The action changes to the best one, if the own table plays afterwards. States that it does not
    meet never change, nor does it learn what they are good for.
    """
    opponents = game.mixed(other(team), past, weights)
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


@dataclass(frozen=True)
class BestOf:
    """The best of some random changes of the own table, itself included.

    Opponents are drawn by their weights and meet all candidates from some starts. A candidate
    changes each action with a probability between .001 and .1, drawn evenly in its logarithm.
    """

    candidates: int
    opponents: int = 4
    starts: int = 64

    def __call__(
        self, game: Game, team: Team, own: Table, past: list[Table], weights: Floats,
        rng: np.random.Generator,
    ) -> Table:  # fmt: skip
        """Return the next table."""
        rates = np.append(0.0, 10.0 ** rng.uniform(-3, -1, self.candidates - 1))
        tried = [np.repeat(each[None], self.candidates, axis=0) for each in own]
        for each, (rounds, count, actions) in zip(tried, game.shapes(team), strict=True):
            if actions > 1:
                for place, rate in enumerate(rates):
                    n = rng.binomial(rounds * count, rate)
                    where = rng.integers(rounds * count, size=n)
                    each[place].reshape(-1)[where] = rng.integers(actions, size=n)
        drawn = rng.choice(len(past), self.opponents, p=weights)
        rivals = [np.stack([past[k][turn] for k in drawn]) for turn in range(len(own))]
        starts = rng.choice(game.starts, min(self.starts, len(game.starts)), replace=False)
        sides = (tried, rivals) if team == "pursuer" else (rivals, tried)
        rates = game.played(
            [each[:, None] for each in sides[0]], [each[None] for each in sides[1]], starts
        )
        mean = rates.mean(axis=1) if team == "pursuer" else 1.0 - rates.mean(axis=0)
        best = int(mean.argmax())
        return [each[best] for each in tried]


LEARNERS: Mapping[str, Learner] = {
    "perfect": perfect,
    "perfect where it plays": on_the_way,
    "against 3 of the past": Sampled(3),
    "against 1 of the past": Sampled(1),
    "10 % wrong": Noisy(0.1),
    "30 % wrong": Noisy(0.3),
    "10 % of the changes": Slow(0.1),
    "2 % of the changes": Slow(0.02),
    "improves what it meets": improved,
    "best of 32 changes": BestOf(32),
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
            answer = self.learner(self.game, team, own[-1], past, weights, self.rng)
            if self.schedule.keeps:
                new, old = self._scores(team, [answer, own[-1]], past).mean(axis=1)
                answer = answer if new >= old - TIE else own[-1]
            own.append(answer)

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
