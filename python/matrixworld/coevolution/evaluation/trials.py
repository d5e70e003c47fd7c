"""The matches by which a policy is explained: against held-out opponents, in new episodes."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any

from matrixworld import analysis
from matrixworld.analysis import Estimate, intervals
from matrixworld.coevolution import seeding
from matrixworld.coevolution.evaluation.policy_scores import score_policy
from matrixworld.coevolution.progress import Report, part_of, silent
from matrixworld.coevolution.types import FloatArray, Team
from matrixworld.play.policies import GenomePolicy
from matrixworld.world.config import WorldConfig
from matrixworld.world.policy import TeamPolicy

EPISODES = 100  # episodes against each opponent, if nothing else is asked for


@dataclass(frozen=True)
class Trials:
    """What plays for a team, against whom, in which episodes.

    Sets of matches are numbered: all policies play the same matches in a set.
    """

    policy: GenomePolicy
    team: Team
    world: WorldConfig
    opponents: Mapping[str, TeamPolicy]
    seed: int = 0
    episodes: int = EPISODES
    threads: int | None = None
    report: Report = silent

    def seed_of(self, number: int) -> int:
        """Return the seed of a set of matches."""
        return seeding.explanation_seed(self.seed, number)

    def part(self, number: int, count: int) -> Trials:
        """Return the same trials, which report one of `count` about equally long parts."""
        return replace(self, report=part_of(self.report, number, count))

    def scores(self, policy: Any, number: int, *, episodes: int | None = None) -> FloatArray:
        """Return the scores (genomes, opponents, episodes) of a policy in a set of matches.

        By default it has as many episodes as the trials.
        """
        return score_policy(
            policy,
            self.team,
            self.world,
            opponents=self.opponents,
            episodes=self.episodes if episodes is None else episodes,
            seed=self.seed_of(number),
            threads=self.threads,
            report=self.report,
        ).rates


def mean_score(rates: FloatArray) -> Estimate:
    """Return the mean of scores (opponents, episodes), with an interval over episodes."""
    return analysis.mean_over_episodes(rates.mean(axis=0))


def difference(one: FloatArray, another: FloatArray, level: float = intervals.LEVEL) -> Estimate:
    """Return the difference of two scores (opponents, episodes) in the same episodes."""
    by_episode = (one - another).mean(axis=0)
    low, high = intervals.t_ends(by_episode, level, (-1.0, 1.0))
    return Estimate(float(by_episode.mean()), low, high, "episodes", len(by_episode))
