"""What a team does, in words and numbers: what each input is worth, or a tree that imitates it.

A policy that rates moves is told by its inputs: how far each moves the rating, and what leaving it
out costs in matches. A network over cells is told by a decision tree, which imitates it (DAgger:
Ross, Gordon and Bagnell 2011, "A reduction of imitation learning and structured prediction to
no-regret online learning"). Matches are against held-out opponents, in episodes of their own.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from itertools import count
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from matrixworld import analysis, version
from matrixworld._util import checks, readable
from matrixworld.analysis import Estimate, intervals
from matrixworld.coevolution import seeding, storage
from matrixworld.coevolution.evaluation import scores
from matrixworld.coevolution.progress import Report, part_of, silent
from matrixworld.coevolution.types import FloatArray, Genome, Team
from matrixworld.episodes.record import record
from matrixworld.play.policies import GenomePolicy, NetworkPolicy, RatingPolicy
from matrixworld.world.config import WorldConfig
from matrixworld.world.policy import Population, TeamPolicy
from matrixworld.world.rating import INPUTS
from matrixworld.world.rules import Action
from matrixworld.world.world import World

EPISODES = 40  # episodes against each opponent, if nothing else is asked for
DEPTHS = range(3, 7)  # depths of trees that can be read, and still imitate something
DEPTH = 4
NO_LOSS, MOST_PARTS, FIRST_PRUNED = 0.01, 40, 100
"""Loss of score below which a part of a program is worth nothing, the most shorter programs of a
trial, and the number of the first matches that try them."""
STATES = 10_000  # about the most states of agents that are kept of a rollout
POINTS = 5  # values of an input at which its partial dependence is told
ROUNDS = 2  # rollouts of a tree whose states the next tree learns, too
IMITATED = "A tree imitates the network; how well, its score tells rather than its agreement."
CLEAR, SLIGHT = 1 / 3, 1 / 10
"""Effects, in shares of the largest one, that a sentence tells, and that it tells as little."""
MOST_CLEAR, MOST_SLIGHT = 4, 2  # the most of them that it tells
BLOCKS = 10  # length of the bar of the largest effect

# By input: what an agent does whose rating falls with it, and rises with it; and what it minds.
PHRASES: dict[str, tuple[str, str, str]] = {
    "adversary": ("{seeks} the nearest {foe}", "{flees} the nearest {foe}", "the nearest {foe}"),
    "pressure": ("{flees} all {foe}s in view", "{seeks} all {foe}s in view", "all {foe}s in view"),
    "unclaimed": (
        "{seeks} {foe}s that no teammate is nearer to",
        "{flees} {foe}s that no teammate is nearer to",
        "{foe}s that no teammate is nearer to",
    ),
    "open_side": (
        "{seeks} the free sides of {foe}s", "{flees} the free sides of {foe}s", "sides of {foe}s",
    ),
    "teammate": ("keeps close to a teammate", "keeps apart from teammates", "teammates"),
    "exits": ("enters narrow places", "prefers open cells", "narrow places"),
    "room": ("keeps to walls", "keeps off walls", "walls"),
    "must_yield": ("gives way to others", "takes the way of others", "right of way"),
    "ahead": ("keeps turning", "keeps its direction", "its direction"),
    "search": ("leaves its way of searching", "searches the grid", "its way of searching"),
}  # fmt: skip
WORDS: dict[Team, dict[str, str]] = {
    "pursuer": {"foe": "evader", "seeks": "goes for", "flees": "keeps away from"},
    "evader": {"foe": "pursuer", "seeks": "goes towards", "flees": "runs from"},
}


class Term(NamedTuple):
    """What an input does in a policy that rates moves."""

    input: str
    weight: float | None  # its weight; None unless the rating is a weighted sum
    effect: float
    """How far the input moves a rating: the slope of `dependence`, multiplied by the standard
    deviation of the input among the moves that an agent can choose from."""
    dependence: tuple[tuple[float, float], ...]
    """Partial dependence: values of the input, and the mean rating of the moves seen, if all had
    this value."""
    cost: Estimate | None = None
    """Score lost if the input is left out: all weights that it enters by are 0."""


class Tree(NamedTuple):
    """A decision tree that imitates a network."""

    depth: int
    leaves: int
    agreement: float
    """Share of the states in new matches of the network in which both like the same move best."""
    score: Estimate
    cost: Estimate  # score of the network minus that of the tree


@dataclass(frozen=True, repr=False)
class Explanation(readable.Readable):
    """What a team does: of what rates moves its `terms`, of a network a `tree` that imitates it."""

    team: Team
    generation: int
    score: Estimate  # its mean score against held-out opponents
    sentence: str
    text: str = ""  # a program, or the rules of the tree
    terms: tuple[Term, ...] = ()
    tree: Tree | None = None

    def _parts(self) -> readable.Parts:
        kind = scores.SCORE[self.team]
        told = [self.sentence, f"{kind.capitalize()} against held-out opponents: {self.score}"]
        if self.tree:
            depth, leaves, agreement, score, cost = self.tree
            told += [
                f"{kind.capitalize()} of the tree: {score}; network minus tree: {_told(cost)}",
                f"In {agreement:.2f} of the states both like the same move best. Of the tree, "
                f"depth {depth} with {leaves} leaves, the likeliest moves and their shares:",
            ]
        largest = max((abs(term.effect) for term in self.terms), default=0.0) or 1.0
        linear = all(term.weight is not None for term in self.terms)
        head = ("input", "weight" if linear else "rating", "effect", "", f"{kind} lost without it")
        rows = [
            (
                name,
                _curve(dependence) if weight is None else f"{weight:.3f}",
                f"{effect:.3f}",
                ("-" if effect < 0 else "+") + "█" * round(BLOCKS * abs(effect) / largest),
                _told(cost) if cost else "",
            )
            for name, weight, effect, dependence, cost in self.terms
            if effect or (cost and cost.value)
        ]
        return [*told, *[[head, *rows]] * bool(rows), *[self.text] * bool(self.text)]

    def to_json(self) -> dict[str, Any]:
        """Return everything as values that JSON can hold."""
        return dict(readable.plain_values(self))


def _curve(dependence: Sequence[tuple[float, float]]) -> str:
    """Return how a rating goes as an input grows, as bars of eight heights."""
    ratings = [rating for _, rating in dependence]
    low, wide = min(ratings), (max(ratings) - min(ratings)) or 1.0
    return "".join("▁▂▃▄▅▆▇█"[round(7 * (rating - low) / wide)] for rating in ratings)


def _told(cost: Estimate) -> str:
    return f"{cost}{'' if cost.sign else ', cannot tell'}"


def sentence(team: Team, effects: Mapping[str, float]) -> str:
    """Return in a sentence what an agent does by the effects of its inputs."""
    words, largest = WORDS[team], max(map(abs, effects.values()))
    by_size = sorted(effects, key=lambda name: -abs(effects[name]))
    share = {name: abs(effects[name]) / largest if largest else 0.0 for name in by_size}
    clear = [name for name in by_size if share[name] >= CLEAR][:MOST_CLEAR]
    told = [PHRASES[name][effects[name] > 0] for name in clear]
    little = [PHRASES[name][2] for name in by_size if SLIGHT <= share[name] < CLEAR]
    told += [f"minds {_listed(little[:MOST_SLIGHT])} little"] * bool(little)
    article = "A" if team == "pursuer" else "An"
    does = _listed(told) or "takes any move that is allowed"
    return f"{article} {team} {does}.".format(**words)


def _listed(parts: Sequence[str]) -> str:
    *before, last = parts or [""]
    return f"{', '.join(before)} and {last}" if before else last


# The matches:


@dataclass(frozen=True)
class _Matches:
    """What plays for a team, against whom, and how; `number` tells sets of matches apart."""

    acts: GenomePolicy
    team: Team
    world: WorldConfig
    opponents: Mapping[str, TeamPolicy]
    seed: int
    depth: int
    play: Mapping[str, Any]
    report: Report

    def seed_of(self, number: int) -> int:
        """Return the seed of a set of matches; no other matches of the package have it."""
        return seeding.match_seed(self.seed, int(seeding.Phase.EXPLAIN), number)

    def rates(
        self, policy: Any, number: int, part: int = 0, of: int = 1, **play: Any
    ) -> FloatArray:
        """Return scores (genomes, opponents, episodes): a part of the whole work."""
        how = {"seed": self.seed_of(number), "report": part_of(self.report, part, of)}
        play = {**self.play, "opponents": self.opponents, **how, **play}
        return scores.score_policy(policy, self.team, self.world, **play).rates


def _score(rates: FloatArray) -> Estimate:
    return analysis.mean_over_episodes(rates.mean(axis=0))


def _difference(one: FloatArray, another: FloatArray) -> Estimate:
    """Return the difference of two scores (opponents, episodes) in the same episodes."""
    each = (one - another).mean(axis=0)
    ends = intervals.t_ends(each, intervals.LEVEL, (-1.0, 1.0))
    return Estimate(float(each.mean()), *ends, "episodes", len(each))


# What rates moves:


def _inputs_seen(matches: _Matches) -> NDArray[np.float32]:
    """Return inputs (n, moves, inputs) of living agents, of one episode against each opponent."""
    world, seen, first = World(matches.world), [], matches.team == "pursuer"
    n = matches.world.n_pursuers
    agents = slice(n) if first else slice(n, None)
    for number, opponent in enumerate(matches.opponents.values()):
        sides: Any = matches.acts, opponent
        match: Any = {"seed": matches.seed_of(1), "episode": number}
        episode = record(world.config, *sides[:: 1 if first else -1], **match)
        world.reset(**match)
        for actions in episode.actions:
            seen.append(world.inputs()[agents][world.alive[agents]])
            world.step(actions)
    every = np.concatenate(seen)
    return every[np.random.default_rng(matches.seed_of(1)).permutation(len(every))[:STATES]]


def terms_of(acts: RatingPolicy, seen: NDArray[np.float32]) -> list[Term]:
    """Return what the inputs of a policy do to the ratings of moves seen, the largest first."""
    policy, allowed, terms = acts.policy, acts.allowed(seen), []
    moves = allowed.sum(axis=1)
    linear = getattr(policy, "sizes", ()) == (len(policy.inputs), 1)
    for place, name in enumerate(policy.inputs):
        column = list(INPUTS).index(name)
        x = seen[..., column].astype(np.float64)
        mean = (x * allowed).sum(axis=1) / moves
        variance = ((x - mean[:, None]) ** 2 * allowed).sum(axis=1) / moves
        spread, ends = float(np.sqrt(variance.mean())), (x[allowed].min(), x[allowed].max())
        points: list[tuple[float, float]] = []
        for value in np.linspace(*ends, POINTS) if spread else ends[:1]:
            changed = seen.copy()
            changed[..., column] = value
            points.append((float(value), float(acts.rate(changed)[allowed].mean(dtype=float))))
        values, ratings = np.transpose(points)
        slope = float(np.polyfit(values, ratings, 1)[0]) if np.ptp(ratings) else 0.0
        weight = float(acts.genome[place]) if linear else None
        terms.append(Term(name, weight, slope * spread, tuple(points)))
    return sorted(terms, key=lambda term: -abs(term.effect))


def _terms(matches: _Matches) -> tuple[list[Term], str]:
    """Return what the inputs of a policy do in matches, and the sentence of it."""
    acts = matches.acts
    assert isinstance(acts, RatingPolicy)
    terms = terms_of(acts, _inputs_seen(matches))
    return terms, sentence(matches.team, {term.input: term.effect for term in terms})


def pruned(matches: _Matches) -> tuple[Genome, Estimate | None]:
    """Return a program without parts that are worth nothing, and what is lost by it, if any."""
    # A shorter program is taken if its loss against the whole one is below `NO_LOSS` by the bound
    # of an interval, and in new matches once more: of many that are tried some are lucky.
    acts = matches.acts
    whole = code = acts.genome
    lost, numbers = None, count(FIRST_PRUNED)
    shorter = acts.policy.shorter(code)[:MOST_PARTS]

    def loss(codes: list[Genome]) -> list[Estimate]:
        team = Population(np.stack([whole, *codes]), acts.policy)
        own, *others = matches.rates(team, next(numbers))
        return [_difference(own, other) for other in others]

    while shorter:
        tried = zip(shorter, loss(shorter), strict=True)
        promising = (each for each, found in tried if found.ends[1] < NO_LOSS)
        taken = next(((c, e) for c in promising for e in loss([c]) if e.ends[1] < NO_LOSS), None)
        if taken is None:
            break
        code, lost = taken
        shorter = acts.policy.shorter(code)[:MOST_PARTS]
    return code, lost


def _by_program(matches: _Matches) -> dict[str, Any]:
    """Explain a program by its inputs, and without the parts that are worth nothing."""
    code, lost = pruned(matches)
    found = _by_inputs(matches, costs=False)
    if lost is not None:
        short = matches.acts.policy.expression(code)
        found["text"] += f"\nWithout parts that are worth nothing: {short}\n(score lost: {lost})\n"
    return found


def sentence_of(run: storage.SavedRun, team: Team) -> str:
    """Return in a sentence what the last generation of a team does, if it rates moves; else ""."""
    if run.settings.game or run.settings.policy.kind == "cells":
        return ""
    policy, world = run.policy(team, seed=0), run.pursuit.world
    opponents, _ = scores.opponents_in(run, team, world)
    _, told = _terms(_Matches(policy, team, world, opponents, 0, 0, {}, silent))
    shape: Any = policy.policy
    code = f" rating = {shape.expression(policy.genome)}" if shape.kind == "program" else ""
    return told + code


def _by_inputs(matches: _Matches, *, costs: bool) -> dict[str, Any]:
    """Explain what rates moves; with `costs` of leaving inputs out."""
    acts: Any = matches.acts
    terms, told = _terms(matches)
    left_out = [acts.policy.without(acts.genome, term.input) for term in terms if costs]
    team = Population(np.stack([acts.genome, *left_out]), acts.policy)
    own, *others = matches.rates(team, 0)
    for number, other in enumerate(others):
        terms[number] = terms[number]._replace(cost=_difference(own, other))
    found = {"score": _score(own), "sentence": told, "terms": tuple(terms)}
    return found if costs else {**found, "text": acts.to_python()}


# Networks over cells:


def features(views: NDArray[Any], team: Team) -> dict[str, NDArray[np.float32]]:
    """Return what a tree knows of views (n, 3, fov, fov): by name one number of each, (n,).

    Without anybody in view places are 0, and the moves are as many as the view is wide.
    """
    own, foes = (1, 0) if team == "pursuer" else (0, 1)
    n, fov, half = len(views), views.shape[-1], views.shape[-1] // 2
    south, east = (axis.ravel() for axis in np.mgrid[-half : half + 1, -half : half + 1])
    moves = abs(south) + abs(east)
    found: dict[str, NDArray[Any]] = {}
    for channel, name, many in ((foes, "adversary", "adversaries"), (own, "teammate", "teammates")):
        seen = views[:, channel].reshape(n, -1) > 0
        seen = seen & (moves > 0) if channel == own else seen  # without the agent itself
        nearest, some = np.where(seen, moves, fov).argmin(axis=1), seen.any(axis=1)
        found[f"{name} south"] = south[nearest] * some
        found[f"{name} east"] = east[nearest] * some
        found[f"{name} moves"] = np.where(some, moves[nearest], fov)
        found[many] = seen.sum(axis=1)
    column, row = views[:, 2, :, half] > 0, views[:, 2, half] > 0
    rays = {
        "north": column[:, :half][:, ::-1], "east": row[:, half + 1 :],
        "south": column[:, half + 1 :], "west": row[:, :half][:, ::-1],
    }  # fmt: skip
    for direction, ray in rays.items():
        ends = np.pad(ray, ((0, 0), (0, 1)), constant_values=True)  # where the view does
        found[f"free cells {direction}"] = ends.argmax(axis=1)
    return {name: each.astype(np.float32) for name, each in found.items()}


def _by_tree(matches: _Matches) -> dict[str, Any]:
    """Explain a network by a tree that imitates it, also where only the tree would go."""
    trees: Any = version.imported("sklearn.tree", "explain")
    acts, team, world = matches.acts, matches.team, matches.world
    assert isinstance(acts, NetworkPolicy)
    if acts.policy.memory != "none":
        raise ValueError("policy: expected one without memory, which no tree imitates, got gru")
    tree = trees.DecisionTreeClassifier(
        max_depth=matches.depth, min_samples_leaf=20, random_state=0
    )
    rng, n_actions, parts = np.random.default_rng(matches.seed_of(1)), world.n_actions, ROUNDS + 4
    # Of each rollout about as many states are kept, whatever the size of the world.
    agents = world.n_pursuers if team == "pursuer" else world.n_evaders
    share = STATES / (2 * len(matches.opponents) * world.max_steps * agents)

    def table(views: NDArray[Any]) -> NDArray[np.float32]:
        return np.stack([*features(views, team).values()], axis=1)

    def wanted(views: NDArray[Any]) -> NDArray[Any]:
        chances = acts.probabilities(views)
        return chances if acts.policy.sampled else np.eye(n_actions)[chances.argmax(axis=1)]

    def imitate(views: NDArray[Any]) -> NDArray[np.int64]:
        chances = tree.predict_proba(table(views))
        if not acts.policy.sampled:
            return np.asarray(chances.argmax(axis=1))
        drawn = chances.cumsum(axis=1) < rng.random((len(chances), 1))
        return np.asarray(drawn.sum(axis=1).clip(0, n_actions - 1))

    def states(policy: Callable[..., Any], number: int) -> NDArray[Any]:
        kept = []

        def watched(views: NDArray[Any]) -> Any:
            kept.append(views[rng.random(len(views)) < share])
            return policy(views)

        matches.rates(watched, 1 + number, number, parts, episodes=2)
        return np.concatenate(kept)

    def fit(data: NDArray[Any]) -> None:
        rows = np.repeat(table(data), n_actions, axis=0)
        moves = np.tile(np.arange(n_actions), len(data))
        tree.fit(rows, moves, sample_weight=wanted(data).ravel())

    data = states(acts, 0)
    for number in range(1, ROUNDS + 1):
        fit(data)
        data = np.concatenate([data, states(imitate, number)])
    fit(data)
    tests = states(acts, ROUNDS + 1)
    same = tree.predict_proba(table(tests)).argmax(axis=1) == wanted(tests).argmax(axis=1)
    [own] = matches.rates(acts, 0, parts - 2, parts)
    [its] = matches.rates(imitate, 0, parts - 1, parts)
    size = int(tree.get_depth()), int(tree.get_n_leaves())
    found = Tree(*size, float(same.mean()), _score(its), _difference(own, its))
    rules, _ = _rules(tree.tree_, [*features(tests[:1], team)])
    return {"score": _score(own), "sentence": IMITATED, "tree": found, "text": "\n".join(rules)}


def _rules(tree: Any, names: Sequence[str], node: int = 0) -> tuple[list[str], set[int]]:
    """Return the likeliest moves of a tree as lines, with their shares, and as a set."""
    # Splits that do not change the likeliest move are left out.
    chances = tree.value[node][0]
    best = int(chances.argmax())
    share = chances[best] / chances.sum()
    leaf = [f"{Action(best).name.lower()} ({share:.2f})"], {best}
    children = int(tree.children_left[node]), int(tree.children_right[node])
    if children[0] < 0:
        return leaf
    (low, first), (high, second) = (_rules(tree, names, child) for child in children)
    if len(first | second) == 1:
        return leaf[0], first
    test = f"if {names[tree.feature[node]]} <= {tree.threshold[node]:g}:"
    rest = [f"el{high[0]}", *high[1:]] if len(high) > 1 else ["else:", f"    {high[0]}"]
    return [test, *(f"    {line}" for line in low), *rest], first | second


KINDS: dict[str, Callable[..., dict[str, Any]]] = {
    "cells": _by_tree,
    "rating": partial(_by_inputs, costs=True),
    "program": _by_program,
}
"""What explains a kind of policy."""


def explain(
    policy: GenomePolicy,
    team: Team,
    config: WorldConfig,
    *,
    generation: int = 0,
    opponents: Mapping[str, TeamPolicy] | None = None,
    episodes: int = EPISODES,
    seed: int = 0,
    depth: int = DEPTH,
    threads: int | None = None,
    report: Report = silent,
) -> Explanation:
    """Explain what a policy does for a team; arguments as those of `SavedRun.explain`."""
    checks.check_integer("seed", seed, 0, checks.SEED_MAX)
    checks.check_integer("depth", depth, DEPTHS[0], DEPTHS[-1])
    against = scores.opponents_of(team, config)[0] if opponents is None else opponents
    play = {"episodes": checks.check_integer("episodes", episodes, 2), "threads": threads}
    matches = _Matches(policy, team, config, against, seed, depth, play, report)
    return Explanation(team, generation, **KINDS[policy.policy.kind](matches))
