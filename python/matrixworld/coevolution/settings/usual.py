"""Defaults that follow from other settings: all of them, in one function.

A section has defaults of its own. Some are other ones for a kind of race, learner or policy, and in
the race that ``matrixworld evolve`` plays if it is asked for nothing else (`COURTYARD`). Numbers
without a source are the best of some that were tried, in the paper's world and in the courtyard.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

from matrixworld.coevolution.games.guarantee import DRAWN
from matrixworld.coevolution.games.policies import Cells, Programs, Ratings
from matrixworld.coevolution.games.pursuit import BEST_RESPONSE
from matrixworld.coevolution.learners import (
    ActorCritic,
    CmaEs,
    EvolutionStrategy,
    GeneticAlgorithm,
    OwnLearner,
)
from matrixworld.coevolution.settings.schedules import Against, AtOnce, InTurns
from matrixworld.coevolution.types import Team

DEFAULTS = "defaults"
"""The path of the choice which defaults others follow; it is no setting of a run by itself."""
PAPER = "paper"
COURTYARD = "courtyard"
"""The defaults of the paper, and those of a balanced world: policies that one can read race in it,
and a race takes seconds."""

SCHEDULE = "generalist-generalist"
HALL = AtOnce.kind  # of games of one population
POLICY = {PAPER: "cells", COURTYARD: "rating"}
LEARNER = "es"
OF_RATINGS = "cma"  # of ratings in the courtyard
BREEDING = "breeding"  # of games whose genomes are objects
EPOCHS: dict[Team, int] = {"pursuer": 6000, "evader": 4000}
"""Epochs of a team that learns alone."""
GUARANTEED: dict[str, Any] = {
    "schedule.opponent": BEST_RESPONSE,
    "schedule.epochs": 60,
    "schedule.archive_every": 5,
    "evaluation_episodes": 1,
}
"""What is other if it learns on its guarantee, which has no chance."""
STEPLESS = tuple(name for name in Ratings.inputs if name not in ("must_yield", *DRAWN))
"""Inputs with which one table has all that a policy does in a world."""


class Kinds(NamedTuple):
    """What other defaults follow from, of what was chosen."""

    defaults: str  # those of the paper, or of the courtyard
    schedule: Any  # classes
    learner: Any
    policy: Any
    team: Team  # that learns, of one that learns alone
    epochs: int  # of a team that learns alone
    has_map: bool  # which has the size of the world, whatever a world with a name has
    own_game: bool
    exact: bool  # whether equal genomes of it always have equal scores
    texts: bool  # whether its genomes are objects
    symmetric: bool  # whether one population plays both sides
    guarantee: bool  # whether a team alone learns on what it guarantees


def usual_learner(defaults: str, policy: Any, *, texts: bool) -> str:
    """Return the name of the learner if no other one is chosen."""
    if texts:
        return BREEDING
    return OF_RATINGS if defaults == COURTYARD and issubclass(policy, Ratings) else LEARNER


def usual(kinds: Kinds) -> dict[str, Any]:
    """Return the defaults, by path, that follow from kinds."""
    values: dict[str, Any] = {}
    if issubclass(kinds.schedule, Against):
        values |= _of_one_team(kinds)
    if kinds.learner is ActorCritic:
        values |= _of_gradients(kinds)
    if kinds.defaults == COURTYARD:
        values |= _of_the_courtyard(kinds)
    if kinds.learner is not OwnLearner:
        values |= {f"learner.{name}": value for name, value in usual_of_learner(kinds).items()}
    if kinds.has_map:
        values |= {"world.rows": None, "world.cols": None}
    if not kinds.own_game:
        return values
    if kinds.exact:
        values["evaluation_episodes"] = 1
    if kinds.texts:
        values["learner"] = BREEDING
    if kinds.symmetric:
        values["schedule"] = HALL
    of_pursuit = ("world", "policy", "train_steps")
    return {path: v for path, v in values.items() if path.partition(".")[0] not in of_pursuit}


def usual_of_learner(kinds: Kinds) -> dict[str, Any]:
    """Return the defaults of a learner's fields that follow from kinds.

    Those of a class of your own are of the fields that it inherits.
    """
    if kinds.learner is ActorCritic:
        return {}
    values: dict[str, Any] = {}
    if issubclass(kinds.schedule, AtOnce):
        values["population"] = 24  # individuals of both teams share the matches
    if issubclass(kinds.schedule, Against):
        values["population"] = 24 if kinds.guarantee else 128
        if issubclass(kinds.learner, GeneticAlgorithm):
            values["mutation"] = 0.2
        if issubclass(kinds.learner, EvolutionStrategy):
            # Adam moves each gene by about the rate, mostly in random directions: n updates lead
            # sqrt(n) times as far as one. With a rate in proportion to 1 / sqrt(n) a genome goes
            # equally far in short runs and in long ones.
            rate = 1.25 / math.sqrt(kinds.epochs)
            values["learning_rate"] = rate
            values["sigma"] = math.sqrt(rate / 2.0)
            values["relative_sigma"] = 0.0
            values["anneal"] = True
    if kinds.defaults == COURTYARD and issubclass(kinds.learner, EvolutionStrategy):
        values |= {"population": 12, "sigma": 0.3, "learning_rate": 0.0025}
    if kinds.defaults == COURTYARD and issubclass(kinds.learner, CmaEs) and not kinds.guarantee:
        values |= {"population": 24, "sigma": 0.3}
    return values


def _of_one_team(kinds: Kinds) -> dict[str, Any]:
    """Return the defaults of one team alone."""
    pursuers = kinds.team == "pursuer"
    values: dict[str, Any] = {
        "schedule.epochs": EPOCHS[kinds.team],
        "train_steps": 500 if pursuers else 300,
        "evaluation_episodes": 200,
    }
    if kinds.policy is Cells:
        values["policy.initial_weight"] = 0.2 if pursuers else 0.05
        values["policy.initial_head"] = 0.09 if pursuers else 0.1
    if kinds.guarantee:
        values |= GUARANTEED
        if issubclass(kinds.policy, Ratings | Programs):
            values["policy.inputs"] = STEPLESS
    return values


def _of_gradients(kinds: Kinds) -> dict[str, Any]:
    """Return the defaults of actor-critic: those of the published implementation."""
    values: dict[str, Any] = {"train_steps": 500}
    if kinds.policy is Cells:
        values["policy.hidden"] = (400, 300)
    if issubclass(kinds.schedule, InTurns):
        values["schedule.pursuer_epochs"] = 400
        values["schedule.evader_epochs"] = 400
    if issubclass(kinds.schedule, AtOnce):
        values["schedule.joint_epochs"] = 400
    if issubclass(kinds.schedule, Against):
        values["schedule.epochs"] = 1200
    return values


def _of_the_courtyard(kinds: Kinds) -> dict[str, Any]:
    """Return the defaults of what ``matrixworld evolve`` plays.

    CMA-ES has few epochs of many matches, since it trusts each of its samples.
    """
    by_cma = issubclass(kinds.learner, CmaEs)
    in_turns, at_once = (5, 5) if by_cma else (20, 10)
    values: dict[str, Any] = {"world": COURTYARD, "policy": POLICY[COURTYARD]}
    if by_cma:
        values["learner"] = OF_RATINGS
    if by_cma and not kinds.guarantee:
        values["match_episodes"] = 4
    if kinds.policy is Ratings:
        values["policy.initial_weight"] = 0.2
    if issubclass(kinds.schedule, InTurns):
        values["schedule.pursuer_epochs"] = in_turns
        values["schedule.evader_epochs"] = in_turns
    if issubclass(kinds.schedule, AtOnce):
        values["schedule.joint_epochs"] = at_once
    if issubclass(kinds.schedule, Against) and by_cma and not kinds.guarantee:
        values |= {"schedule.epochs": 150, "schedule.archive_every": 5}
    return values
