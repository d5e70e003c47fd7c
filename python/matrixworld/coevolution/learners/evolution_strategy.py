"""The evolution strategy of Salimans et al. 2017, with mirrored samples and ranks."""

from __future__ import annotations

from typing import ClassVar

import numpy as np

from matrixworld._util import checks
from matrixworld.coevolution.learners import learner
from matrixworld.coevolution.sections import by_race, section, setting
from matrixworld.coevolution.types import FloatArray, Genome, Genomes, Indices, Rng, State


def centred_ranks(fitness: FloatArray) -> FloatArray:
    """Return the ranks of fitness values (n,), scaled to [-0.5, 0.5]; equal ones share one."""
    in_order = np.sort(fitness)
    below = np.searchsorted(in_order, fitness, side="left")
    not_above = np.searchsorted(in_order, fitness, side="right")
    # Equal values take the places below .. not_above - 1; their rank is the middle of these.
    return (below + not_above - 1) / (2 * (len(fitness) - 1)) - 0.5


@section
class EvolutionStrategy(learner.Learner):
    """An evolution strategy with mirrored samples and ranks.

    ::

        ask:   for each pair i: e_i ~ N(0, 1);  candidates  m + s e_i  and  m - s e_i
        tell:  u = centred ranks of the fitness
               m = m + step( sum_i (u_i+ - u_i-) e_i / (n s) )

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

    kind: ClassVar[str] = "es"
    ignores: ClassVar[tuple[str, ...]] = ()
    steps: ClassVar[tuple[str, ...]] = ("learning_rate", "sigma")

    sigma: float = by_race(0.1, "standard deviation of the samples", positive=True)
    learning_rate: float = by_race(0.03, "learning rate of the optimizer", positive=True)
    momentum: float | None = setting(
        None, "coefficient of classical momentum, in [0, 1); default: Adam instead", most=1.0
    )
    relative_sigma: float = by_race(
        0.4, "least standard deviation, as a share of the root mean square of the genome"
    )
    anneal: bool = by_race(False, "reduce the learning rate linearly to a tenth over the run")

    def check(self) -> None:
        """Raise ValueError for an odd population or a momentum of 1."""
        n, momentum = self.population or 0, self.momentum or 0.0
        checks.expect(n % 2 == 0, "population", "an even number for es", n)
        checks.expect(momentum < 1.0, "momentum", "a number below 1", momentum)

    @property
    def seed_groups(self) -> Indices:
        """Both candidates of a mirrored pair are one group."""
        return np.tile(np.arange(self.population // 2), 2)

    def start(self, task: learner.Task) -> State:
        """Return the mean and the state of the optimizer."""
        genome = task.genomes(1)[0]
        velocity = {"velocity": np.zeros_like(genome), "updates": np.array(0)}
        return {
            "genome": genome,
            **({"epochs": np.array(task.epochs)} if self.anneal else {}),
            **task.noise_state(),
            **(learner.adam_state(genome.size) if self.momentum is None else velocity),
        }

    def scale(self, state: State) -> float:
        """Return the standard deviation s of the next samples, in times of `sigma`."""
        if not self.relative_sigma:
            return 1.0
        # Genes without noise do not count: those of a mask are larger than all others by far.
        free = state["genome"][~state["fixed"]] if "fixed" in state else state["genome"]
        length = float(np.sqrt(np.mean(np.square(free, dtype=np.float64))))
        return max(self.sigma, self.relative_sigma * length) / self.sigma

    @np.errstate(over="ignore", invalid="ignore")  # a run reports genes that are not finite
    def ask(self, state: State, rng: Rng) -> tuple[Genomes, State]:
        """Return the samples: half of them, then their mirror images in the same order."""
        genome, pairs = state["genome"], self.population // 2
        windows = learner.draw_windows(pairs, genome.size, rng)
        # Both halves are written into one array, which a rollout takes without another copy.
        candidates = np.empty((2, pairs, genome.size), dtype=np.float32)
        plus, minus = candidates
        scale = np.float32(self.scale(state))
        for i, vector in enumerate(learner.noise_of(state, windows, genome.size, self.sigma)):
            noise = vector if scale == 1.0 else scale * vector
            np.add(genome, noise, out=plus[i])
            np.subtract(genome, noise, out=minus[i])
        samples = candidates.reshape(self.population, -1)
        return learner.inside_bounds(state, samples), {**state, "windows": windows}

    @np.errstate(over="ignore", invalid="ignore")
    def tell(self, state: State, results: learner.Results) -> State:
        """Move the mean towards the better samples."""
        before = {name: value for name, value in state.items() if name != "windows"}
        genome, windows = state["genome"], state["windows"]
        fitness = learner.checked_fitness(results.fitness, 2 * len(windows))
        plus, minus = centred_ranks(fitness).reshape(2, -1)
        # The table's numbers are e_i times sigma, hence the square; with a larger s, too, so that
        # steps of momentum do not shrink as s grows. Those of Adam hardly change with it.
        weights = ((plus - minus) / (self.population * self.sigma**2)).astype(np.float32)
        gradient = np.zeros(genome.size, dtype=np.float32)
        # Term by term, not as a matrix product: the order in which BLAS adds, and with it the
        # rounding, depends on the machine.
        term = np.empty_like(gradient)
        noise = learner.noise_of(state, windows, genome.size, self.sigma)
        for weight, vector in zip(weights, noise, strict=True):
            np.multiply(weight, vector, out=term)
            gradient += term
        change, after = self._step(state, gradient)
        return {**before, **after, "genome": learner.inside_bounds(state, genome + change)}

    def _step(self, state: State, gradient: Genome) -> tuple[Genome, State]:
        """Return the change of the mean, and the state of the optimizer after it."""
        updates = int(state["updates"])
        share = learner.annealed(updates, int(state["epochs"])) if self.anneal else 1.0
        rate = self.learning_rate * share
        if self.momentum is None:
            return learner.adam(state, gradient, rate)
        kept: Genome = np.float32(self.momentum) * state["velocity"]
        velocity = kept + np.float32(rate) * gradient
        return velocity, {"velocity": velocity, "updates": np.array(updates + 1)}
