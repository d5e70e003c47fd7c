"""How far each input moves the ratings of a policy, and what it is worth to its score."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import count
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from matrixworld.analysis import Estimate
from matrixworld.coevolution.evaluation.trials import Trials, difference, mean_score
from matrixworld.coevolution.types import Genome, Team
from matrixworld.episodes.record import record
from matrixworld.play.policies import RatingPolicy
from matrixworld.world.policy import Population
from matrixworld.world.rating import INPUTS
from matrixworld.world.world import World

NO_LOSS = 0.01  # loss of score below which a part of a program is worth nothing
MOST_PARTS = 40  # the most shorter programs of a trial
FIRST_PRUNED = 100  # number of the first matches that try shorter programs
STATES = 10_000  # the most states of agents in which ratings are looked at
POINTS = 5  # values of an input at which its partial dependence is told
CLEAR = 1 / 3  # least effect, as a share of the largest one, that a sentence tells
SLIGHT = 1 / 10  # least effect that it tells as little
MOST_CLEAR = 4  # the most effects that a sentence tells
MOST_SLIGHT = 2  # the most of them that it tells as little


class Phrase(NamedTuple):
    """What an agent does whose rating falls with an input, and rises with it; what it minds."""

    falls: str
    rises: str
    minded: str


PHRASES: dict[str, Phrase] = {
    "adversary": Phrase(
        "{seeks} the nearest {foe}", "{flees} the nearest {foe}", "the nearest {foe}"
    ),
    "pressure": Phrase(
        "{flees} all {foe}s in view", "{seeks} all {foe}s in view", "all {foe}s in view"
    ),
    "unclaimed": Phrase(
        "{seeks} {foe}s that no teammate is nearer to",
        "{flees} {foe}s that no teammate is nearer to",
        "{foe}s that no teammate is nearer to",
    ),
    "open_side": Phrase(
        "{seeks} the free sides of {foe}s", "{flees} the free sides of {foe}s", "sides of {foe}s"
    ),
    "teammate": Phrase("keeps close to a teammate", "keeps apart from teammates", "teammates"),
    "exits": Phrase("enters narrow places", "prefers open cells", "narrow places"),
    "room": Phrase("keeps to walls", "keeps off walls", "walls"),
    "must_yield": Phrase("gives way to others", "takes the way of others", "right of way"),
    "ahead": Phrase("keeps turning", "keeps its direction", "its direction"),
    "search": Phrase("leaves its way of searching", "searches the grid", "its way of searching"),
    "escapes": Phrase("{opens} ways out", "{closes} ways out", "ways out"),
    "opposite": Phrase("stands {opposite}", "stands {aside}", "opposite sides"),
    "parity": Phrase("keeps odd distances", "keeps even distances", "odd distances"),
}
WORDS: dict[Team, dict[str, str]] = {
    "pursuer": {
        "foe": "evader",
        "seeks": "goes for",
        "flees": "keeps away from",
        "opens": "leaves evaders",
        "closes": "closes evaders'",
        "opposite": "opposite a teammate",
        "aside": "on the same side as a teammate",
    },
    "evader": {
        "foe": "pursuer",
        "seeks": "goes towards",
        "flees": "runs from",
        "opens": "keeps",
        "closes": "gives up",
        "opposite": "between pursuers",
        "aside": "on one side of pursuers",
    },
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


def sentence(team: Team, effects: Mapping[str, float]) -> str:
    """Return in a sentence what an agent does by the effects of its inputs."""
    names = sorted(effects, key=lambda name: -abs(effects[name]))
    largest = abs(effects[names[0]]) or 1.0
    shares = {name: abs(effects[name]) / largest for name in names}
    clear = [name for name in names if shares[name] >= CLEAR]
    slight = [name for name in names if SLIGHT <= shares[name] < CLEAR]
    clauses = []
    for name in clear[:MOST_CLEAR]:
        phrase = PHRASES[name]
        clauses.append(phrase.rises if effects[name] > 0 else phrase.falls)
    if slight:
        objects = [PHRASES[name].minded for name in slight[:MOST_SLIGHT]]
        clauses.append(f"minds {_listed(objects)} little")
    article = "A" if team == "pursuer" else "An"
    does = _listed(clauses) if clauses else "takes any move that is allowed"
    return f"{article} {team} {does}.".format(**WORDS[team])


def _listed(parts: Sequence[str]) -> str:
    """Return parts as "a, b and c"."""
    if len(parts) == 1:
        return parts[0]
    return f"{', '.join(parts[:-1])} and {parts[-1]}"


def inputs_seen(trials: Trials) -> NDArray[np.float32]:
    """Return inputs (n, moves, inputs) of living agents, of one episode against each opponent."""
    world = World(trials.world)
    pursues = trials.team == "pursuer"
    n_pursuers = trials.world.n_pursuers
    agents = slice(n_pursuers) if pursues else slice(n_pursuers, None)
    seed = trials.seed_of(1)
    seen = []
    for number, opponent in enumerate(trials.opponents.values()):
        pursuers: Any = trials.policy if pursues else opponent
        evaders: Any = opponent if pursues else trials.policy
        episode = record(world.config, pursuers, evaders, seed=seed, episode=number)
        world.reset(seed=seed, episode=number)
        for actions in episode.actions:
            seen.append(world.inputs()[agents][world.alive[agents]])
            world.step(actions)
    inputs = np.concatenate(seen)
    return inputs[np.random.default_rng(seed).permutation(len(inputs))[:STATES]]


def terms_of(policy: RatingPolicy, seen: NDArray[np.float32]) -> list[Term]:
    """Return what the inputs of a policy do to the ratings of moves seen, the largest first."""
    shape = policy.policy
    is_weighted_sum = getattr(shape, "sizes", ()) == (len(shape.inputs), 1)
    allowed = policy.allowed(seen)
    terms = []
    for place, name in enumerate(shape.inputs):
        weight = float(policy.genome[place]) if is_weighted_sum else None
        terms.append(_term(policy, seen, allowed, name, weight))
    return sorted(terms, key=lambda term: -abs(term.effect))


def _term(
    policy: RatingPolicy,
    seen: NDArray[np.float32],
    allowed: NDArray[np.bool_],
    name: str,
    weight: float | None,
) -> Term:
    """Return what one input does to the ratings of moves seen that are allowed."""
    column = list(INPUTS).index(name)
    x = seen[..., column].astype(np.float64)
    # Over the moves that an agent can choose from.
    moves = allowed.sum(axis=1)
    mean = (x * allowed).sum(axis=1) / moves
    variance = ((x - mean[:, None]) ** 2 * allowed).sum(axis=1) / moves
    spread = float(np.sqrt(variance.mean()))
    low = x[allowed].min()
    high = x[allowed].max()
    points: list[tuple[float, float]] = []
    for value in np.linspace(low, high, POINTS) if spread else [low]:
        changed = seen.copy()
        changed[..., column] = value
        points.append((float(value), float(policy.rate(changed)[allowed].mean(dtype=float))))
    values, ratings = np.transpose(points)
    slope = float(np.polyfit(values, ratings, 1)[0]) if np.ptp(ratings) else 0.0
    return Term(name, weight, slope * spread, tuple(points))


def sentence_and_terms(trials: Trials) -> tuple[str, list[Term]]:
    """Return in a sentence what a policy does that rates moves, and the terms behind it."""
    assert isinstance(trials.policy, RatingPolicy)
    terms = terms_of(trials.policy, inputs_seen(trials))
    return sentence(trials.team, {term.input: term.effect for term in terms}), terms


def without_each(trials: Trials, terms: Sequence[Term]) -> tuple[Estimate, list[Term]]:
    """Return the score of a policy, and its terms with the costs of leaving their inputs out."""
    policy: Any = trials.policy
    left_out = [policy.policy.without(policy.genome, term.input) for term in terms]
    team = Population(np.stack([policy.genome, *left_out]), policy.policy)
    own, *others = trials.scores(team, 0)
    costs = [difference(own, rates) for rates in others]
    return mean_score(own), [
        term._replace(cost=cost) for term, cost in zip(terms, costs, strict=True)
    ]


def pruned(trials: Trials) -> tuple[Genome, Estimate | None]:
    """Return a program without parts that are worth nothing, and what is lost by it, if any."""
    policy: Any = trials.policy
    numbers = count(FIRST_PRUNED)
    code: Genome = policy.genome
    loss: Estimate | None = None

    def losses(codes: list[Genome]) -> list[Estimate]:
        team = Population(np.stack([policy.genome, *codes]), policy.policy)
        own, *others = trials.scores(team, next(numbers))
        return [difference(own, rates) for rates in others]

    def shortened(code: Genome) -> tuple[Genome, Estimate] | None:
        """Return a shorter program that loses nothing; None if there is no other one."""
        shorter = policy.policy.shorter(code)[:MOST_PARTS]
        if not shorter:
            return None
        for candidate, first in zip(shorter, losses(shorter), strict=True):
            if first.ends[1] >= NO_LOSS:
                continue
            # In new matches once more: of many that are tried some are lucky.
            [again] = losses([candidate])
            if again.ends[1] < NO_LOSS:
                return candidate, again
        return None

    while (shorter := shortened(code)) is not None:
        code, loss = shorter
    return code, loss
