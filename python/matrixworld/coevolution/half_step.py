"""One team learns for some epochs while its opponents stand still."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from deap import algorithms
from numpy.typing import NDArray

from matrixworld.coevolution.keys import (
    TEAMS,
    Purpose,
    Seeds,
    Team,
    keyed_generator,
    learning_phase,
    training_seeds,
)
from matrixworld.coevolution.learners import Learner
from matrixworld.coevolution.toolbox import Candidates, generate_update_toolbox
from matrixworld.coevolution.tournament import Opponents
from matrixworld.coevolution.training import Training


class Meeting(NamedTuple):
    """Whom the candidates of an epoch meet: one opponent of some generation, on seeds (n,)."""

    epoch: int
    generation: int
    opponent: Opponents
    seeds: Seeds


@dataclass(frozen=True)
class HalfStep:
    """Epochs of one team in one generation.

    Parameters
    ----------
    training : plays, counts and logs.
    learner : of `team`; improved in place.
    generation : of `team`, the one that is being learned.
    meet : epoch -> (the opponent's generation, the opponent: scripted or a population of one).
    on_epoch : called after each epoch has been scored.
    """

    training: Training
    learner: Learner
    team: Team
    generation: int
    meet: Callable[[int], tuple[int, Opponents]]
    on_epoch: Callable[[], None]

    def run(self, epochs: range) -> None:
        """Let DEAP's generate-update loop drive the learner through `epochs`."""
        # All of them now: between matches, which leave nothing of it in the caches, this takes
        # several times as long.
        meetings = iter([self._meeting(epoch) for epoch in epochs])
        generators = [self._generator(epoch) for epoch in epochs]
        toolbox = generate_update_toolbox(
            self.learner,
            lambda candidates: self.score(candidates, next(meetings)),
            iter(generators),
        )
        algorithms.eaGenerateUpdate(toolbox, ngen=len(epochs), verbose=False)

    def score(self, candidates: Candidates, meeting: Meeting) -> NDArray[np.float64]:
        """Return the fitness (n,) of an epoch's candidates against the opponent of that epoch."""
        scores = self.training.play_candidates(
            self.team, candidates.genomes, meeting.opponent, meeting.seeds
        )
        values = self.training.fitness(scores, self.team)
        self.training.record(
            scores,
            values,
            team=self.team,
            generation=self.generation,
            epoch=meeting.epoch,
            opponent=meeting.generation,
        )
        self.on_epoch()
        return values

    def _meeting(self, epoch: int) -> Meeting:
        met, opponent = self.meet(epoch)
        match = self.learner.match_of_candidate
        own, seed = self.generation, self.training.settings.seed
        generations = (own, met) if self.team == "pursuer" else (met, own)
        count = int(match.max()) + 1
        seeds = training_seeds(seed, *generations, learning_phase(self.team), epoch, count)
        return Meeting(epoch, met, opponent, seeds[match])

    def _generator(self, epoch: int) -> np.random.Generator:
        key = (TEAMS.index(self.team), self.generation, epoch)
        return keyed_generator(self.training.settings.seed, Purpose.LEARN, *key)
