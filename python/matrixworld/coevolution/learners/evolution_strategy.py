"""The evolution strategy of Salimans et al. 2017, with mirrored samples and ranks."""

from __future__ import annotations

from typing import ClassVar, NamedTuple

import numpy as np
from numpy.typing import NDArray

from matrixworld._util.constraints import Range
from matrixworld._util.sections import SettingError, section, setting
from matrixworld.coevolution.games.game import clipped
from matrixworld.coevolution.learners import learner
from matrixworld.coevolution.learners.noise import Noise, draw_windows, noise_of
from matrixworld.coevolution.learners.optimizers import Adam, Momentum, annealed
from matrixworld.coevolution.types import FloatArray, Genome, Genomes, Indices, Rng


def centred_ranks(fitness: FloatArray) -> FloatArray:
    """Return the ranks of fitness values (n,), scaled to [-0.5, 0.5]; equal ones share one."""
    in_order = np.sort(fitness)
    below = np.searchsorted(in_order, fitness, side="left")
    not_above = np.searchsorted(in_order, fitness, side="right")
    # Equal values take the places below .. not_above - 1; their rank is the middle of these.
    return (below + not_above - 1) / (2 * (len(fitness) - 1)) - 0.5


class State(NamedTuple):
    """The mean of the samples, and the state of its optimizer."""

    genome: Genome
    optimizer: Adam | Momentum
    noise: Noise
    bounds: learner.Bounds | None
    epochs: NDArray[np.int64] | None  # in which the learning rate falls
    windows: Indices | None = None  # of the noise of the samples that are played


@section("es")
class EvolutionStrategy(learner.Evolutionary):
    """An evolution strategy with mirrored samples and ranks.

    ::

        ask:   for each pair i: e_i ~ N(0, 1);  candidates  m + s e_i  and  m - s e_i
        tell:  u = centred ranks of the fitness
               m = m + step( sum_i (u_i+ - u_i-) e_i / (n sigma) )

    The genome is the mean m. Both candidates of a pair are scored on the same match seed, so that
    the luck of the match cancels out. One standard deviation s serves all genes: `sigma`, or a
    share of the root mean square of m if that is more. In a long race the genome grows with the
    root of the updates, mostly by chance; a constant s becomes small beside it, and tells less of
    the candidates than luck does. Steps are divided by `sigma` in any case. They are those of Adam,
    or of classical momentum: ``v = momentum * v + rate * gradient`` (Polyak 1964), whose length
    follows that of the gradient. There is no weight decay.

    Salimans et al. 2017, "Evolution strategies as a scalable alternative to reinforcement
    learning", arXiv:1703.03864, algorithm 1 with mirrored sampling.
    """

    keeps_mask: ClassVar[bool] = True
    steps: ClassVar[tuple[str, ...]] = ("learning_rate", "sigma")

    sigma: float = setting(0.1, "standard deviation of the samples", Range(open=True))
    learning_rate: float = setting(0.03, "learning rate of the optimizer", Range(open=True))
    momentum: float | None = setting(
        None, "coefficient of classical momentum, in [0, 1); default: Adam instead", Range(most=1.0)
    )
    relative_sigma: float = setting(
        0.4, "least standard deviation, as a share of the root mean square of the genome"
    )
    anneal: bool = setting(False, "reduce the learning rate linearly to a tenth over the run")

    def check(self) -> None:
        """Raise SettingError for an odd population or a momentum of 1."""
        super().check()
        if self.population % 2:
            raise SettingError("population", "an even number for es", str(self.population))
        if self.momentum == 1.0:
            raise SettingError("momentum", "a number below 1", "1.0")

    @property
    def seed_groups(self) -> Indices:
        """Both candidates of a mirrored pair are one group."""
        return np.tile(np.arange(self.population // 2), 2)

    def start(self, task: learner.Task) -> State:
        """Return the mean and the state of the optimizer."""
        genome = task.genomes(1)[0]
        optimizer = Adam if self.momentum is None else Momentum
        return State(
            genome,
            optimizer.start(genome.size),
            task.noise(),
            task.bounds(),
            epochs=np.array(task.epochs) if self.anneal else None,
        )

    def scale(self, state: State) -> float:
        """Return the standard deviation s of the next samples, in times of `sigma`."""
        if not self.relative_sigma:
            return 1.0
        # Genes without noise do not count: those of a mask are larger than all others by far.
        fixed = state.noise.fixed
        free = state.genome if fixed is None else state.genome[~fixed]
        length = float(np.sqrt(np.mean(np.square(free, dtype=np.float64))))
        return max(self.sigma, self.relative_sigma * length) / self.sigma

    @np.errstate(over="ignore", invalid="ignore")  # a run reports genes that are not finite
    def ask(self, state: State, rng: Rng) -> tuple[Genomes, State]:
        """Return the samples: half of them, then their mirror images in the same order."""
        genome = state.genome
        pairs = self.population // 2
        windows = draw_windows(pairs, genome.size, rng)
        # Both halves are written into one array, which a rollout takes without another copy.
        candidates = np.empty((2, pairs, genome.size), dtype=np.float32)
        plus, minus = candidates
        scale = np.float32(self.scale(state))
        vectors = noise_of(state.noise, windows, genome.size, self.sigma)
        for i, vector in enumerate(vectors):
            noise = vector if scale == 1.0 else scale * vector
            np.add(genome, noise, out=plus[i])
            np.subtract(genome, noise, out=minus[i])
        samples = clipped(candidates.reshape(self.population, -1), state.bounds)
        return samples, state._replace(windows=windows)

    @np.errstate(over="ignore", invalid="ignore")
    def tell(self, state: State, results: learner.Results) -> State:
        """Move the mean towards the better samples."""
        if state.windows is None:
            raise learner.not_asked()
        size = state.genome.size
        fitness = learner.checked_fitness(results.fitness, 2 * len(state.windows))
        plus, minus = centred_ranks(fitness).reshape(2, -1)
        # The table's numbers are e_i times sigma, hence the square; with a larger s, too, so that
        # steps of momentum do not shrink as s grows. Those of Adam hardly change with it.
        weights = ((plus - minus) / (self.population * self.sigma**2)).astype(np.float32)
        gradient = np.zeros(size, dtype=np.float32)
        # Term by term, not as a matrix product: the order in which BLAS adds, and with it the
        # rounding, depends on the machine.
        term = np.empty_like(gradient)
        noise = noise_of(state.noise, state.windows, size, self.sigma)
        for weight, vector in zip(weights, noise, strict=True):
            np.multiply(weight, vector, out=term)
            gradient += term
        change, optimizer = self._step(state, gradient)
        genome = clipped(state.genome + change, state.bounds)
        return state._replace(genome=genome, optimizer=optimizer, windows=None)

    def _step(self, state: State, gradient: Genome) -> tuple[Genome, Adam | Momentum]:
        """Return the change of the mean, and the state of the optimizer after it."""
        rate = self.learning_rate
        if state.epochs is not None:
            rate *= annealed(int(state.optimizer.updates), int(state.epochs))
        if isinstance(state.optimizer, Momentum):
            assert self.momentum is not None
            return state.optimizer.step(gradient, rate, self.momentum)
        return state.optimizer.step(gradient, rate)
