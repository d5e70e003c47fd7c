"""Learners and opponent samplers as users write them, and some that fail."""

import os
import signal
from pathlib import Path

import numpy as np

from matrixworld.coevolution.opponents import LAPCA, ArchiveSampler, Stateless


class HillClimber:
    """A (1 + lambda) hill climber whose step size shrinks while no mutant is better."""

    def __init__(self, genome, samples, *, sigma=0.1, shrink=0.9):
        if sigma <= 0:
            raise ValueError(f"sigma: expected a number above 0, got {sigma}")
        self.genome, self.sigma, self.shrink = genome, sigma, shrink
        self.seed_groups = np.zeros(samples, dtype=np.intp)
        self.candidates = None

    def ask(self, rng):
        noise = rng.standard_normal((len(self.seed_groups), self.genome.size), np.float32)
        noise[0] = 0.0
        self.candidates = self.genome + np.float32(self.sigma) * noise
        return self.candidates

    def tell(self, fitness):
        best = int(np.argmax(fitness))
        self.genome = self.candidates[best].copy()
        self.sigma *= self.shrink if best == 0 else 1.0

    def state(self):
        return {"genome": self.genome, "sigma": np.array(self.sigma)}

    def restore(self, state):
        self.genome, self.sigma = state["genome"], float(state["sigma"])


class Hardest:
    """Half of the time the opponents with the lowest scores so far, else random ones."""

    def __init__(self, count, *, forget=0.5):
        self.count, self.forget = count, forget
        self.scores = np.zeros(0)

    def sample(self, available, epoch, rng):
        self.scores = np.pad(self.scores, (0, max(0, available - len(self.scores))))
        size = min(self.count, available)
        if rng.random() < 0.5:
            return rng.choice(available, size=size, replace=False)
        return np.argsort(self.scores[:available], kind="stable")[:size]

    def tell(self, opponents, scores):
        kept = (1 - self.forget) * self.scores[opponents]
        self.scores[opponents] = kept + self.forget * np.mean(scores, axis=0)

    def state(self):
        return {"scores": self.scores.copy()}

    def restore(self, state):
        self.scores = state["scores"].copy()


def layered(count, *, layers) -> ArchiveSampler:
    """Return a sampler with an archive."""
    return ArchiveSampler(LAPCA(layers), count)


class Fixed(Stateless):
    """The oldest opponents."""

    def __init__(self, count):
        self.count = count

    def sample(self, available, epoch, rng):
        return np.arange(min(self.count, available))


class InPlace(HillClimber):
    """It changes its genome in place."""

    def tell(self, fitness):
        before = self.genome
        super().tell(fitness)
        before[:], self.genome = self.genome, before


class ReturnsViews(HillClimber):
    """It changes the arrays that it returned as its state."""

    def __init__(self, genome, samples, **settings):
        super().__init__(genome, samples, **settings)
        self.arrays = {"genome": genome, "sigma": np.array(self.sigma)}

    def tell(self, fitness):
        super().tell(fitness)
        self.arrays["genome"][:], self.arrays["sigma"][()] = self.genome, self.sigma

    def state(self):
        return self.arrays

    def restore(self, state):
        super().restore(state)
        self.arrays = state


class Fails(HillClimber):
    """It fails in the second call of tell."""

    told = 0

    def tell(self, fitness):
        self.told += 1
        if self.told == 2:
            raise ZeroDivisionError("no luck")
        super().tell(fitness)


class Exits(HillClimber):
    def ask(self, rng):
        raise SystemExit


class Dies(HillClimber):
    """It ends its process in the third call of tell; with a marker, once, by a signal."""

    told = 0

    def __init__(self, genome, samples, *, marker=None):
        super().__init__(genome, samples)
        self.marker = marker and Path(marker)

    def tell(self, fitness):
        self.told += 1
        if self.told == 3 and self.marker is None:
            os._exit(9)
        if self.told == 3 and not self.marker.exists():
            self.marker.touch()
            os.kill(os.getpid(), signal.SIGKILL)
        super().tell(fitness)


class Crash(Fixed):
    """It fails in every call of sample."""

    def sample(self, available, epoch, rng):
        raise KeyError("generation")


ANSWER = 42


def unannotated(genome, samples):
    return HillClimber(genome, samples)
