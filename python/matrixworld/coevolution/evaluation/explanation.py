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
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from matrixworld import analysis
from matrixworld._util import checks
from matrixworld._util.readable import Parts, Readable, plain_values
from matrixworld.analysis import Estimate
from matrixworld.analysis.intervals import LEVEL, t_ends
from matrixworld.coevolution.evaluation.scores import (
    SCORE,
    opponents_in,
    opponents_of,
    score_policy,
)
from matrixworld.coevolution.progress import Progress, Report, silent
from matrixworld.coevolution.seeding import Phase, match_seed
from matrixworld.coevolution.storage import SavedRun
from matrixworld.coevolution.types import TEAMS, FloatArray, Team
from matrixworld.episodes.record import record
from matrixworld.play.policies import GenomePolicy, NetworkPolicy, RatingPolicy
from matrixworld.version import imported
from matrixworld.world.config import WorldConfig
from matrixworld.world.policy import Population, TeamPolicy
from matrixworld.world.rating import INPUTS
from matrixworld.world.rules import Action
from matrixworld.world.world import World

EPISODES = 40
"""Episodes against each opponent, if nothing else is asked for."""
DEPTHS = range(3, 7)
"""Depths of trees that can be read, and still imitate something."""
DEPTH = 4
STATES = 10_000
"""About the most states of agents that are kept of a rollout."""
POINTS = 5
"""Values of an input at which its partial dependence is told."""
ROUNDS = 2
"""Rollouts of a tree whose states the next tree learns, too."""
IMITATED = "A tree imitates the network; how well, its score tells rather than its agreement."
CLEAR, SLIGHT = 1 / 3, 1 / 10
"""Effects, in shares of the largest one, that a sentence tells, and that it tells as little."""
MOST_CLEAR, MOST_SLIGHT = 4, 2
"""The most of them that it tells."""
BLOCKS = 10
"""Length of the bar of the largest effect."""

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
    "crowd": ("avoids crowds of teammates", "gathers with teammates", "crowds of teammates"),
    "exits": ("enters narrow places", "prefers open cells", "narrow places"),
    "room": ("keeps to walls", "keeps off walls", "walls"),
    "must_yield": ("gives way to others", "takes the way of others", "right of way"),
    "stay": ("keeps moving", "likes to stay", "staying"),
    "ahead": ("keeps turning", "keeps its direction", "its direction"),
}  # fmt: skip
WORDS: dict[Team, dict[str, str]] = {
    "pursuer": {"foe": "evader", "seeks": "goes for", "flees": "keeps away from"},
    "evader": {"foe": "pursuer", "seeks": "goes towards", "flees": "runs from"},
}


class Term(NamedTuple):
    """What an input does in a policy that rates moves."""

    input: str
    weight: float | None
    """Its weight; None unless the rating is a weighted sum."""
    effect: float
    """How far the input moves a rating: the slope of `dependence`, multiplied by the standard
    deviation of the input among the moves that an agent can choose from."""
    dependence: dict[float, float]
    """Partial dependence: mean rating of the moves seen, if all had this value of the input."""
    cost: Estimate | None = None
    """Score lost if the input is left out: all weights that it enters by are 0."""


class Tree(NamedTuple):
    """A decision tree that imitates a network."""

    depth: int
    leaves: int
    agreement: float
    """Share of the states in new matches of the network in which both like the same move best."""
    score: Estimate
    cost: Estimate
    """Score of the network minus that of the tree."""


@dataclass(frozen=True, repr=False)
class Explanation(Readable):
    """What a team does: of what rates moves its `terms`, of a network a `tree` that imitates it."""

    team: Team
    generation: int
    score: Estimate
    """Its mean score against held-out opponents."""
    sentence: str
    text: str = ""
    """A program, or the rules of the tree."""
    terms: tuple[Term, ...] = ()
    tree: Tree | None = None

    def _parts(self) -> Parts:
        kind = SCORE[self.team]
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
        ]
        return [*told, *[[head, *rows]] * bool(rows), *[self.text] * bool(self.text)]

    def to_json(self) -> dict[str, Any]:
        """Return everything as values that JSON can hold."""
        plain: dict[str, Any] = plain_values(self)
        return plain


def _curve(dependence: Mapping[float, float]) -> str:
    """Return how a rating goes as an input grows, as bars of eight heights."""
    low, high = min(dependence.values()), max(dependence.values())
    steps = (round(7 * (y - low) / (high - low)) if high > low else 0 for y in dependence.values())
    return "".join("▁▂▃▄▅▆▇█"[step] for step in steps)


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
    """What plays for a team, against whom, and what is counted of the work."""

    acts: GenomePolicy
    team: Team
    world: WorldConfig
    opponents: Mapping[str, TeamPolicy]
    episodes: int
    seed: int
    threads: int | None
    report: Report

    def seed_of(self, number: int) -> int:
        """Return the seed of a set of matches; no other matches of the package have it."""
        return match_seed(self.seed, int(Phase.EXPLAIN), number)

    def rates(
        self, policy: Any, number: int, part: tuple[int, int] = (0, 1), episodes: int = 0
    ) -> FloatArray:
        """Return scores of a policy (genomes, opponents, episodes) in a set of matches."""

        def told(one: Progress) -> None:
            done = part[0] * one.total + one.done
            self.report(Progress(f"{self.team}s explained", done, part[1] * one.total))

        play: Any = {"opponents": self.opponents, "threads": self.threads, "report": told}
        play |= {"episodes": episodes or self.episodes, "seed": self.seed_of(number)}
        return score_policy(policy, self.team, self.world, **play).rates

    @property
    def agents(self) -> int:
        """Agents of the team."""
        return self.world.n_pursuers if self.team == "pursuer" else self.world.n_evaders


def _score(rates: FloatArray) -> Estimate:
    return analysis.mean_over_episodes(rates.mean(axis=0))


def _difference(one: FloatArray, another: FloatArray) -> Estimate:
    """Return the difference of two scores (opponents, episodes) in the same episodes."""
    each = (one - another).mean(axis=0)
    ends = t_ends(each, LEVEL, (-1.0, 1.0))
    return Estimate(float(each.mean()), *ends, "episodes", len(each))


# What rates moves:


def _inputs_seen(matches: _Matches) -> NDArray[np.float32]:
    """Return inputs (n, moves, inputs) of living agents, of one episode against each opponent."""
    world, seen = World(matches.world), []
    first = 0 if matches.team == "pursuer" else matches.world.n_pursuers
    agents = slice(first, first + matches.agents)
    for number, opponent in enumerate(matches.opponents.values()):
        sides = matches.acts.population(), opponent
        played: Any = {"seed": matches.seed_of(1), "episode": number}
        episode = record(world.config, *sides[:: 1 if first == 0 else -1], **played)
        world.reset(**played)
        for actions in episode.actions:
            seen.append(world.inputs()[agents][world.alive[agents]])
            world.step(actions)
    every = np.concatenate(seen)
    kept = np.random.default_rng(matches.seed_of(1)).permutation(len(every))[:STATES]
    return every[np.sort(kept)]


def terms_of(acts: RatingPolicy, seen: NDArray[np.float32]) -> list[Term]:
    """Return what the inputs of a policy do to the ratings of moves seen, the largest first."""
    policy, allowed, terms = acts.policy, acts.allowed(seen), []
    count = allowed.sum(axis=1)
    linear = getattr(policy, "sizes", ()) == (len(policy.inputs), 1)
    for place, name in enumerate(policy.inputs):
        column = list(INPUTS).index(name)
        x = seen[..., column].astype(np.float64)
        mean = (x * allowed).sum(axis=1) / count
        variance = ((x - mean[:, None]) ** 2 * allowed).sum(axis=1) / count
        spread, ends = float(np.sqrt(variance.mean())), (x[allowed].min(), x[allowed].max())
        dependence = {}
        for value in np.linspace(*ends, POINTS) if spread else ends[:1]:
            changed = seen.copy()
            changed[..., column] = value
            dependence[float(value)] = float(acts.rate(changed)[allowed].mean(dtype=np.float64))
        curve = [*dependence], [*dependence.values()]
        slope = float(np.polyfit(*curve, 1)[0]) if spread else 0.0
        weight = float(acts.genome[place]) if linear else None
        terms.append(Term(name, weight, slope * spread, dependence))
    return sorted(terms, key=lambda term: -abs(term.effect))


def _by_inputs(matches: _Matches, depth: int, *, costs: bool) -> dict[str, Any]:
    """Explain what rates moves; with `costs` of leaving inputs out."""
    acts = matches.acts
    assert isinstance(acts, RatingPolicy)
    terms = terms_of(acts, _inputs_seen(matches))
    left_out = [acts.policy.without(acts.genome, term.input) for term in terms if costs]
    team = Population(np.stack([acts.genome, *left_out]), acts.policy)
    full, *others = matches.rates(team, 0)
    if costs:
        each = zip(terms, others, strict=True)
        terms = [term._replace(cost=_difference(full, other)) for term, other in each]
    told = sentence(matches.team, {term.input: term.effect for term in terms})
    return {
        "score": _score(full),
        "sentence": told,
        "terms": tuple(terms),
        "text": "" if costs else acts.to_python(),
    }


# Networks over cells:


def features(views: NDArray[Any], team: Team) -> dict[str, NDArray[np.float32]]:
    """Return what a tree knows of views (n, 3, fov, fov): by name one number of each, (n,).

    Of the nearest adversary and the nearest teammate how far to the south and to the east it is,
    and in how many moves; how many are in view by direction; and free cells by direction. Without
    anybody in view the first two are 0, and the moves are as many as the view is wide.
    """
    own, foes = (1, 0) if team == "pursuer" else (0, 1)
    n, fov, half = len(views), views.shape[-1], views.shape[-1] // 2
    south, east = (axis.ravel() for axis in np.mgrid[-half : half + 1, -half : half + 1])
    moves = abs(south) + abs(east)
    sectors = {
        "north": (south < 0) & (abs(east) <= -south), "east": (east > 0) & (abs(south) <= east),
        "south": (south > 0) & (abs(east) <= south), "west": (east < 0) & (abs(south) <= -east),
    }  # fmt: skip
    found: dict[str, NDArray[Any]] = {}
    for channel, name, many in (
        (foes, "adversary", "adversaries"), (own, "teammate", "teammates"),
    ):  # fmt: skip
        seen = views[:, channel].reshape(n, -1) > 0
        seen = seen & (moves > 0) if channel == own else seen  # without the agent itself
        nearest, some = np.where(seen, moves, fov).argmin(axis=1), seen.any(axis=1)
        found[f"{name} south"] = south[nearest] * some
        found[f"{name} east"] = east[nearest] * some
        found[f"{name} moves"] = np.where(some, moves[nearest], fov)
        for direction, cells in sectors.items():
            found[f"{many} {direction}"] = seen[:, cells].sum(axis=1)
    centre = views[:, 2]
    rays = {
        "north": centre[:, half - 1 :: -1, half], "east": centre[:, half, half + 1 :],
        "south": centre[:, half + 1 :, half], "west": centre[:, half, half - 1 :: -1],
    }  # fmt: skip
    for direction, ray in rays.items():
        blocked = np.pad(ray[:, :half] > 0, ((0, 0), (0, 1)), constant_values=True)
        found[f"free cells {direction}"] = blocked.argmax(axis=1)
    return {name: each.astype(np.float32) for name, each in found.items()}


def _by_tree(matches: _Matches, depth: int) -> dict[str, Any]:
    """Explain a network by a tree that imitates it, also where only the tree would go."""
    trees: Any = imported("sklearn.tree", "explain")
    acts, team = matches.acts, matches.team
    assert isinstance(acts, NetworkPolicy)
    if acts.policy.memory != "none":
        raise ValueError("policy: expected one without memory, which no tree imitates, got gru")
    rng, n_actions = np.random.default_rng(matches.seed_of(1)), acts.policy.n_actions
    # Of each rollout about as many states are kept, whatever the size of the world.
    most = 2 * len(matches.opponents) * matches.world.max_steps * matches.agents
    share, parts = min(1.0, STATES / most), ROUNDS + 4
    tree = trees.DecisionTreeClassifier(max_depth=depth, min_samples_leaf=20, random_state=0)

    def table(views: NDArray[Any]) -> NDArray[np.float32]:
        return np.stack([*features(views, team).values()], axis=1)

    def wanted(views: NDArray[Any]) -> NDArray[Any]:
        chances = acts.probabilities(views)
        return chances if acts.policy.sampled else np.eye(n_actions)[chances.argmax(axis=1)]

    def imitate(views: NDArray[Any]) -> NDArray[np.int64]:
        chances = tree.predict_proba(table(views))
        drawn = chances.cumsum(axis=1) < rng.random((len(chances), 1))
        best = drawn.sum(axis=1).clip(0, n_actions - 1) if acts.policy.sampled else None
        return np.asarray(chances.argmax(axis=1) if best is None else best)

    def states(policy: Callable[..., Any], number: int) -> NDArray[Any]:
        kept = []

        def watched(views: NDArray[Any]) -> Any:
            kept.append(views[rng.random(len(views)) < share])
            return policy(views)

        matches.rates(watched, 1 + number, (number, parts), episodes=2)
        return np.concatenate(kept)

    def fit(data: NDArray[Any]) -> None:
        moves = np.tile(np.arange(n_actions), len(data))
        rows = np.repeat(table(data), n_actions, axis=0)
        tree.fit(rows, moves, sample_weight=wanted(data).ravel())

    data = states(acts, 0)
    for number in range(1, ROUNDS + 1):
        fit(data)
        data = np.concatenate([data, states(imitate, number)])
    fit(data)
    tests = states(acts, ROUNDS + 1)
    same = tree.predict_proba(table(tests)).argmax(axis=1) == wanted(tests).argmax(axis=1)
    [own] = matches.rates(acts, 0, (parts - 2, parts))
    [its] = matches.rates(imitate, 0, (parts - 1, parts))
    found = Tree(
        tree.get_depth(),
        tree.get_n_leaves(),
        float(same.mean()),
        _score(its),
        _difference(own, its),
    )
    rules, _ = _rules(tree.tree_, [*features(tests[:1], team)])
    return {"score": _score(own), "sentence": IMITATED, "tree": found, "text": "\n".join(rules)}


def _rules(tree: Any, names: Sequence[str], node: int = 0) -> tuple[list[str], set[int]]:
    """Return the likeliest moves of a tree as lines, with their shares, and which moves they are.

    Splits that do not change the likeliest move are left out.
    """
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
    inside = ([f"    {line}" for line in lines] for lines in (low, high))
    return [test, *next(inside), "else:", *next(inside)], first | second


KINDS: dict[str, Callable[..., dict[str, Any]]] = {
    "cells": _by_tree,
    "rating": partial(_by_inputs, costs=True),
    "program": partial(_by_inputs, costs=False),
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
    """Explain what a policy does for a team, as `SavedRun.explain` does.

    Parameters
    ----------
    policy : NetworkPolicy or RatingPolicy
        The policy. A network with memory is refused.
    team : {"pursuer", "evader"}
        The team that it plays for.
    config : WorldConfig
        The world.
    generation : int, optional
        A number to tell it by.
    opponents : mapping of str to policy, optional
        Opponents by name. By default the held-out opponents that fit the world.
    episodes, seed, depth, threads, report
        As in `SavedRun.explain`.
    """
    checks.check_instance("policy", policy, GenomePolicy)
    checks.check_choice("team", team, TEAMS)
    checks.check_integer("depth", depth, DEPTHS[0], DEPTHS[-1])
    checks.check_integer("seed", seed, 0, checks.SEED_MAX)
    against = opponents_of(team, config)[0] if opponents is None else opponents
    episodes = checks.check_integer("episodes", episodes, 2)
    matches = _Matches(policy, team, config, against, episodes, seed, threads, report)
    return Explanation(team, generation, **KINDS[policy.policy.kind](matches, depth))


def explain_run(run: SavedRun, team: Team, generation: int = -1, **options: Any) -> Explanation:
    """Explain a generation of a run: `SavedRun.explain`."""
    policy = run.policy(team, generation, seed=0)
    world = run.pursuit.world
    options["opponents"] = opponents_in(run, team, world)[0]
    number = run.generation(team, generation)
    return explain(policy, team, world, generation=number, **options)
