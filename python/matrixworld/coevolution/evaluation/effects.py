"""How far each input moves the ratings of a policy, and what it is worth to its score."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from itertools import count
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from matrixworld.analysis import Estimate, intervals
from matrixworld.coevolution.evaluation.trials import Trials, difference, mean_score
from matrixworld.coevolution.types import Genome, Team
from matrixworld.episodes.record import record
from matrixworld.play.policies import RatingPolicy
from matrixworld.world.policy import Population
from matrixworld.world.program import Program
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
ANY_MOVE = "takes any move that is allowed"


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
    "escapes": Phrase("{closes} ways out", "{opens} ways out", "ways out"),
    "opposite": Phrase("{aside}", "{opposite}", "opposite sides"),
    "parity": Phrase("keeps even distances", "keeps odd distances", "odd distances"),
}
WORDS: dict[Team, dict[str, str]] = {
    "pursuer": {
        "A": "A",
        "foe": "evader",
        "seeks": "goes for",
        "flees": "keeps away from",
        "opens": "leaves evaders",
        "closes": "closes evaders'",
        "opposite": "stands opposite a teammate",
        "aside": "stands on the same side as a teammate",
    },
    "evader": {
        "A": "An",
        "foe": "pursuer",
        "seeks": "goes towards",
        "flees": "runs from",
        "opens": "keeps",
        "closes": "gives up",
        "opposite": "stands between pursuers",
        "aside": "keeps pursuers on one side",
    },
}


class Term(NamedTuple):
    """What an input does in a policy that rates moves."""

    input: str
    weight: float | None  # its weight; None unless the rating is a weighted sum
    effect: float
    """How far the rating rises with the input, less how far it falls."""
    dependence: tuple[tuple[float, float], ...]
    """Partial dependence: values of the input, and the mean rating of the moves seen, if all had
    this value."""
    rises: float
    falls: float
    """How far the rating of a move changes with the input, from its mean over the moves that an
    agent can choose from to its value: the root of the mean square over the moves seen, apart for
    those whose rating goes the way of the input and those whose rating goes against it. In a
    weighted sum one of them is 0, and the other one is the size of the weight multiplied by the
    standard deviation of the input among these moves."""
    lost: Estimate | None = None
    """Score lost if the input is left out: all weights that it enters by are 0."""

    @property
    def does(self) -> str:
        """What an agent does by the input, for `in_words`."""
        return _by_input(self.input, Effect(self.rises, self.falls))


class Effect(NamedTuple):
    """How far ratings rise with an input, and how far they fall; as in `Term`, 0 or more."""

    rises: float
    falls: float


def sentence(team: Team, does: str) -> str:
    """Return in a sentence what an agent does: a `deed`."""
    return in_words(team, f"{{A}} {team} {does or ANY_MOVE}.")


def in_words(team: Team, text: str) -> str:
    """Return a text with the words of a team."""
    return text.format(**WORDS[team])


def deed(effects: Mapping[str, Effect]) -> str:
    """Return what an agent does by the effects of its inputs, for `in_words`; empty for nothing."""
    names = sorted(effects, key=lambda name: -max(effects[name]))
    largest = max(effects[names[0]]) if names else 0.0
    if not largest:
        return ""
    shares = {name: Effect(*(size / largest for size in effects[name])) for name in names}
    clear = [name for name in names if max(shares[name]) >= CLEAR]
    slight = [name for name in names if SLIGHT <= max(shares[name]) < CLEAR]
    clauses = [_by_input(name, shares[name], CLEAR) for name in clear[:MOST_CLEAR]]
    if slight:
        objects = [PHRASES[name].minded for name in slight[:MOST_SLIGHT]]
        clauses.append(f"minds {listed(objects)} little")
    return listed(clauses)


def _by_input(name: str, effect: Effect, least: float | None = None) -> str:
    """Return what an agent does by an input: both ways if both effects are at least so large.

    The `least` is by default `CLEAR` of the larger one.
    """
    phrase = PHRASES[name]
    if min(effect) >= (CLEAR * max(effect) if least is None else least) > 0.0:
        return f"now {phrase.falls}, now {phrase.rises}"
    return phrase.rises if effect.rises > effect.falls else phrase.falls


def sentence_of_worth(team: Team, score: str, terms: Sequence[Term]) -> str:
    """Return in sentences what an agent does that is worth something, and what costs nothing.

    Its `terms` know what is `lost` without each, most first; the score of a team is called `score`.
    """
    losses = {term: term.lost for term in terms if term.lost is not None}
    worth = [(term, lost.value) for term, lost in losses.items() if lost.sign > 0]
    harm = [(term, -lost.value) for term, lost in losses.items() if lost.sign < 0]
    other = {term.input: lost.ends[1] for term, lost in losses.items() if lost.sign == 0}
    deeds = [f"{term.does} ({value:.3f})" for term, value in worth]
    deeds[:1] = [f"{term.does} (worth {value:.3f} of {score})" for term, value in worth[:1]]
    told = f"{{A}} {team} {listed(deeds)}." if deeds else "No input is worth something by itself."
    if other:
        most = max(other.values())
        upto = f", or at most {math.ceil(1000 * most) / 1000:.3f}" if most > 0.0 else ""
        words = "By itself this costs" if len(other) == 1 else "By themselves these cost"
        told += f" {words} nothing{upto}: {listed([*other])}."
    if harm:
        without = [f"{term.input} ({value:.3f})" for term, value in reversed(harm)]
        told += f" Scores better without {listed(without)}."
    return in_words(team, told)


def listed(parts: Sequence[str]) -> str:
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
    weights = weights_of(policy)
    allowed = policy.allowed(seen)
    terms = []
    for name in shape.inputs:
        effect = effect_of(policy.rate, seen, allowed, name)
        weight = None if weights is None else weights.get(name, 0.0)
        points = _dependence(policy.rate, seen, allowed, name)
        terms.append(Term(name, weight, effect.rises - effect.falls, points, *effect))
    return sorted(terms, key=lambda term: -max(term.rises, term.falls))


def weights_of(policy: RatingPolicy) -> Mapping[str, float] | None:
    """Return the weights of inputs whose sum a rating is; None if it is no weighted sum."""
    shape = policy.policy
    if isinstance(shape, Program):
        return shape.weights(policy.genome)
    if shape.hidden:
        return None
    return dict(zip(shape.inputs, map(float, policy.genome), strict=True))


def effect_of(
    rate: Callable[[NDArray[np.float32]], NDArray[np.float32]],
    seen: NDArray[np.float32],
    moves: NDArray[np.bool_],
    name: str,
) -> Effect:
    """Return how far ratings change with an input over moves (n, moves) of those seen."""
    column = list(INPUTS).index(name)
    x = seen[..., column].astype(np.float64)
    counts = moves.sum(axis=1)
    mean = np.divide((x * moves).sum(axis=1), counts, out=np.zeros(len(x)), where=counts > 0)
    changed = seen.copy()
    changed[..., column] = mean[:, None]
    # What a rating changes when the input goes from the mean to its value. It may be infinite.
    greatest = np.finfo(np.float32).max
    own, at_mean = (
        np.clip(rate(inputs), -greatest, greatest).astype(np.float64) for inputs in (seen, changed)
    )
    change = own - at_mean
    change *= np.sign(seen[..., column] - changed[..., column])
    share = moves / np.maximum(counts, 1)[:, None] / max(np.count_nonzero(counts), 1)
    squares = share * change**2
    return Effect(*(float(np.sqrt(squares[way].sum())) for way in (change > 0, change < 0)))


def _dependence(
    rate: Callable[[NDArray[np.float32]], NDArray[np.float32]],
    seen: NDArray[np.float32],
    moves: NDArray[np.bool_],
    name: str,
) -> tuple[tuple[float, float], ...]:
    """Return values of an input, and the mean ratings of moves seen if all had these values."""
    column = list(INPUTS).index(name)
    low, high = np.quantile(seen[..., column][moves], (0, 1))
    points = []
    for value in np.linspace(low, high, POINTS) if low < high else [low]:
        changed = seen.copy()
        changed[..., column] = value
        points.append((float(value), float(rate(changed)[moves].mean(dtype=float))))
    return tuple(points)


def without_each(trials: Trials, terms: Sequence[Term]) -> tuple[Estimate, list[Term]]:
    """Return the score of a policy, and its terms with what is lost without each, most first.

    The intervals hold for all inputs together at the usual level: each has Bonferroni's.
    """
    policy: Any = trials.policy
    left_out = [policy.policy.without(policy.genome, term.input) for term in terms]
    team = Population(np.stack([policy.genome, *left_out]), policy.policy)
    own, *others = trials.scores(team, 0)
    level = intervals.level_of_each(len(terms))
    lost = [difference(own, rates, level) for rates in others]
    order = sorted(range(len(terms)), key=lambda place: -lost[place].value)
    return mean_score(own), [terms[place]._replace(lost=lost[place]) for place in order]


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
