"""One team learns for some epochs while its opponents stand still."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass

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
        numbers = iter(epochs)
        toolbox = generate_update_toolbox(
            self.learner,
            lambda candidates: self.score(candidates, next(numbers)),
            self._generators(epochs),
        )
        algorithms.eaGenerateUpdate(toolbox, ngen=len(epochs), verbose=False)

    def score(self, candidates: Candidates, epoch: int) -> NDArray[np.float64]:
        """Return the fitness (n,) of an epoch's candidates against the opponent of that epoch."""
        met, opponent = self.meet(epoch)
        scores = self.training.play_candidates(
            self.team, candidates.genomes, opponent, self._seeds(met, epoch)
        )
        values = self.training.fitness(scores, self.team)
        self.training.record(
            scores,
            values,
            team=self.team,
            generation=self.generation,
            epoch=epoch,
            opponent=met,
        )
        self.on_epoch()
        return values

    def _seeds(self, met: int, epoch: int) -> Seeds:
        match = self.learner.match_of_candidate
        own, seed = self.generation, self.training.settings.seed
        generations = (own, met) if self.team == "pursuer" else (met, own)
        count = int(match.max()) + 1
        return training_seeds(seed, *generations, learning_phase(self.team), epoch, count)[match]

    def _generators(self, epochs: range) -> Iterator[np.random.Generator]:
        key = (TEAMS.index(self.team), self.generation)
        for epoch in epochs:
            yield keyed_generator(self.training.settings.seed, Purpose.LEARN, *key, epoch)
