"""What a team does, in words and numbers: what each input is worth, or a tree that imitates it.

A rating is told by what is lost in matches without each of its inputs (`effects`), a program by
what its parts do to the rating (`cases`), a network over cells by a decision tree (`imitation`).
Matches are against held-out opponents, in episodes of their own (`trials`).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from matrixworld._util import checks, readable
from matrixworld.analysis import Estimate
from matrixworld.coevolution.evaluation.cases import sentence_of_program
from matrixworld.coevolution.evaluation.effects import (
    Term,
    inputs_seen,
    pruned,
    sentence_of_worth,
    terms_of,
    without_each,
)
from matrixworld.coevolution.evaluation.held_out import opponents_of
from matrixworld.coevolution.evaluation.imitation import DEPTH, DEPTHS, Tree, imitated
from matrixworld.coevolution.evaluation.scores import SCORE, opponents_in
from matrixworld.coevolution.evaluation.trials import EPISODES, Trials, mean_score
from matrixworld.coevolution.progress import Report, silent
from matrixworld.coevolution.runs.stored import StoredRun
from matrixworld.coevolution.types import Team
from matrixworld.play.policies import GenomePolicy, RatingPolicy
from matrixworld.world.config import WorldConfig
from matrixworld.world.policy import TeamPolicy

IMITATED = "A tree imitates the network; how well, its score tells rather than its agreement."
TOGETHER = "The 95 % intervals hold for all inputs together."
BLOCKS = 10  # length of the bar of the largest effect


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
        kind = SCORE[self.team].capitalize()
        parts: list[Any] = [self.sentence, f"{kind} against held-out opponents: {self.score}"]
        if self.tree is not None:
            tree = self.tree
            cost = _in_words(tree.cost)
            parts += [
                f"{kind} of the tree: {tree.score}; network minus tree: {cost}",
                f"In {tree.agreement:.2f} of the states both like the same move best. Of the tree, "
                f"depth {tree.depth} with {tree.leaves} leaves, the likeliest moves and their "
                f"shares:",
            ]
        rows = self._rows()
        if rows:
            is_weighted_sum = all(term.weight is not None for term in self.terms)
            lost = f"{SCORE[self.team]} lost without it"
            head = ("input", "weight" if is_weighted_sum else "rating", "effect", "", lost)
            parts.append([head, *rows])
            if any(term.lost for term in self.terms):
                parts.append(TOGETHER)
        if self.text:
            parts.append(self.text)
        return parts

    def _rows(self) -> list[tuple[str, ...]]:
        """Return the terms that do anything as rows of a table."""
        largest = max((abs(term.effect) for term in self.terms), default=0.0) or 1.0
        rows: list[tuple[str, ...]] = []
        for term in self.terms:
            if not term.effect and not (term.lost and term.lost.value):
                continue
            blocks = round(BLOCKS * abs(term.effect) / largest)
            rows.append(
                (
                    term.input,
                    _curve(term.dependence) if term.weight is None else f"{term.weight:.3f}",
                    f"{term.effect:.3f}",
                    ("-" if term.effect < 0 else "+") + "█" * blocks,
                    _in_words(term.lost) if term.lost else "",
                )
            )
        return rows

    def to_json(self) -> dict[str, Any]:
        """Return everything as values that JSON can hold."""
        return dict(readable.plain_values(self))


def _curve(dependence: Sequence[tuple[float, float]]) -> str:
    """Return how a rating goes as an input grows, as bars of eight heights."""
    ratings = [rating for _, rating in dependence]
    low = min(ratings)
    range_of_ratings = (max(ratings) - low) or 1.0
    return "".join("▁▂▃▄▅▆▇█"[round(7 * (r - low) / range_of_ratings)] for r in ratings)


def _in_words(cost: Estimate) -> str:
    return str(cost) if cost.sign else f"{cost}, cannot tell"


def in_short(
    run: StoredRun,
    team: Team,
    generation: int,
    *,
    threads: int | None = None,
    report: Report = silent,
) -> Explanation | None:
    """Return what a generation of a team does, if that takes seconds to find.

    Of a rating it is all that `explain` says, of a program not what its parts are worth. None for
    networks over cells, which take a tree.
    """
    policy = run.policy(team, generation, seed=0)
    if policy.policy.kind == "cells":
        return None
    world = run.pursuit.world
    opponents, _ = opponents_in(run, team, world)
    trials = Trials(policy, team, world, opponents, threads=threads, report=report)
    if policy.policy.kind == "rating":
        return _of_rating(trials, generation)
    words, terms = _of_cases(trials)
    [own] = trials.scores(policy.population(), 0)
    text = f"rating = {policy.policy.expression(policy.genome)}"
    return Explanation(team, generation, mean_score(own), words, text, tuple(terms))


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
    """Explain what a policy does for a team; see `SavedRun.explain`.

    Its world is `config`, and the `opponents` are by default those held out. The `generation` is
    only told.
    """
    checks.check_integer("seed", seed, 0, checks.SEED_MAX)
    checks.check_integer("depth", depth, DEPTHS[0], DEPTHS[-1])
    checks.check_integer("episodes", episodes, 2)
    if opponents is None:
        opponents, _ = opponents_of(team, config)
    trials = Trials(policy, team, config, opponents, seed, episodes, threads, report)
    kind = policy.policy.kind
    if kind == "cells":
        score, tree, rules = imitated(trials, depth)
        return Explanation(team, generation, score, IMITATED, rules, tree=tree)
    if kind == "program":
        return _of_program(trials, generation)
    return _of_rating(trials, generation)


def _of_rating(trials: Trials, generation: int) -> Explanation:
    """Explain a rating by what is lost without each of its inputs."""
    policy = trials.policy
    assert isinstance(policy, RatingPolicy)
    score, terms = without_each(trials, terms_of(policy, inputs_seen(trials)))
    words = sentence_of_worth(trials.team, SCORE[trials.team], terms)
    return Explanation(trials.team, generation, score, words, terms=tuple(terms))


def _of_cases(trials: Trials) -> tuple[str, list[Term]]:
    """Return in a sentence what a program does, and what each input does in it."""
    policy = trials.policy
    assert isinstance(policy, RatingPolicy)
    seen = inputs_seen(trials)
    return sentence_of_program(trials.team, policy, seen), terms_of(policy, seen)


def _of_program(trials: Trials, generation: int) -> Explanation:
    """Explain a program by its inputs, and without the parts that are worth nothing."""
    policy: Any = trials.policy
    code, loss = pruned(trials)
    words, terms = _of_cases(trials)
    [own] = trials.scores(policy.population(), 0)
    text: str = policy.to_python()
    if loss is not None:
        short = policy.policy.expression(code)
        text += f"\nWithout parts that are worth nothing: {short}\n(score lost: {loss})\n"
    return Explanation(trials.team, generation, mean_score(own), words, text, tuple(terms))
