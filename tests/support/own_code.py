"""Learners and opponent samplers as users write them, and some that fail."""

import os
import signal
from dataclasses import dataclass
from pathlib import Path
from typing import ClassVar

import numpy as np

from matrixworld.coevolution import EvolutionStrategy, GeneticAlgorithm, Learner
from matrixworld.coevolution.opponents import Opponents


@dataclass(frozen=True)
class HillClimber(Learner):
    """A (1 + lambda) hill climber whose step size shrinks while no mutant is better."""

    population: int = 4
    sigma: float = 0.1
    shrink: float = 0.9

    def check(self):
        if self.sigma <= 0:
            raise ValueError(f"sigma: expected a number above 0, got {self.sigma}")

    def start(self, task):
        return {"genome": task.genomes(1)[0], "sigma": np.array(self.sigma)}

    def ask(self, state, rng):
        genome = state["genome"]
        noise = rng.standard_normal((self.population, genome.size), np.float32)
        noise[0] = 0.0
        candidates = genome + np.float32(state["sigma"]) * noise
        return candidates, {**state, "candidates": candidates}

    def tell(self, state, results):
        best = int(np.argmax(results.fitness))
        sigma = state["sigma"] * (self.shrink if best == 0 else 1.0)
        return {"genome": state["candidates"][best].copy(), "sigma": np.array(sigma)}


@dataclass(frozen=True)
class Bred(GeneticAlgorithm):
    """A genetic algorithm with a setting more."""

    bits: int = 1


@dataclass(frozen=True)
class Steps(EvolutionStrategy):
    """An evolution strategy with a setting more."""

    longest: float = 1.0


@dataclass(frozen=True)
class Hardest(Opponents):
    """Half of the time the opponents with the lowest scores so far, else random ones."""

    forget: float = 0.5

    def start(self):
        return {"scores": np.zeros(0)}

    def sample(self, state, available, count, epoch, rng):
        size = min(count, available)
        if rng.random() < 0.5:
            return rng.choice(available, size=size, replace=False)
        return np.argsort(self.known(state, available), kind="stable")[:size]

    def tell(self, state, opponents, scores):
        known = self.known(state, int(opponents.max()) + 1).copy()
        kept = (1 - self.forget) * known[opponents]
        known[opponents] = kept + self.forget * np.mean(scores, axis=0)
        return {"scores": known}

    def known(self, state, available):
        return np.pad(state["scores"], (0, max(0, available - len(state["scores"]))))


@dataclass(frozen=True)
class Oldest(Opponents):
    def sample(self, state, available, count, epoch, rng):
        return np.arange(min(count, available))


@dataclass(frozen=True)
class InPlace(HillClimber):
    def tell(self, state, results):
        before, after = state["genome"], super().tell(state, results)
        before[:] = after["genome"]
        return {**after, "genome": before}


@dataclass(frozen=True)
class Fails(HillClimber):
    """It fails in the second call of tell."""

    told: ClassVar[int] = 0

    def tell(self, state, results):
        Fails.told += 1
        if Fails.told == 2:
            raise ZeroDivisionError("no luck")
        return super().tell(state, results)


@dataclass(frozen=True)
class Exits(HillClimber):
    def ask(self, state, rng):
        raise SystemExit


@dataclass(frozen=True)
class TooFew(HillClimber):
    def ask(self, state, rng):
        candidates, asked = super().ask(state, rng)
        return candidates[1:], asked


@dataclass(frozen=True)
class Dies(HillClimber):
    """It ends its process by a signal in the second stage, once if there is a marker."""

    marker: str = ""

    def tell(self, state, results):
        told = int(state.get("told", 0)) + 1
        if told == 3 and not (self.marker and Path(self.marker).exists()):
            if self.marker:
                Path(self.marker).touch()
            os.kill(os.getpid(), signal.SIGKILL)
        return {**super().tell(state, results), "told": np.array(told)}


@dataclass(frozen=True)
class Crash(Oldest):
    """It fails in every call of sample."""

    def sample(self, state, available, count, epoch, rng):
        raise KeyError("generation")


ANSWER = 42
