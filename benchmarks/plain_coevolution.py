"""Co-evolution with NumPy and DEAP only, as it is written without an engine.

The game is O. Agents move simultaneously. An agent whose way is blocked by an obstacle or the
border stays on its cell. An evader is captured and disappears if a pursuer moves to the same cell
or swaps cells with it.
"""

from __future__ import annotations

import random
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial

import numpy as np
from deap import algorithms, base, creator, tools
from numpy.lib.stride_tricks import sliding_window_view
from numpy.typing import NDArray

import matrixworld as mw

MOVES = np.array([(0, 0), (-1, 0), (0, 1), (1, 0), (0, -1)])
EVADER, PURSUER, OBSTACLE = range(3)  # channels of a view

creator.create("Fitness", base.Fitness, weights=(1.0,))
creator.create("Individual", np.ndarray, fitness=creator.Fitness)

Genome = NDArray[np.float32]


# ---- The world -------------------------------------------------------------------------------


class PlainWorld:
    """One world of P pursuers and E evaders: positions (P + E, 2), and who is alive (P + E,).

    An evader that was captured keeps its last position.
    """

    def __init__(self, config: mw.WorldConfig) -> None:
        self.config = config
        self.reach = config.fov // 2
        # A margin as wide as a view, so that every view is a window of the padded planes.
        padded = (config.rows + 2 * self.reach, config.cols + 2 * self.reach)
        self.planes = np.zeros((3, *padded), np.bool_)
        self.inside = self.planes[:, self.reach : -self.reach, self.reach : -self.reach]
        self.windows = sliding_window_view(self.planes, (config.fov, config.fov), axis=(1, 2))

    def place(self, positions: NDArray[np.int32], obstacles: NDArray[np.bool_]) -> None:
        """Start an episode with all agents at `positions`."""
        self.planes[OBSTACLE] = True
        self.inside[OBSTACLE] = obstacles
        self.positions = positions.astype(np.int64)
        self.alive = np.ones(len(positions), np.bool_)
        self._draw()

    def place_at_random(self, rng: np.random.Generator) -> None:
        """Start an episode on distinct random cells, without obstacles."""
        rows, cols = self.config.rows, self.config.cols
        cells = rng.choice(rows * cols, self.config.n_agents, replace=False)
        self.place(np.stack(np.divmod(cells, cols), axis=1), np.zeros((rows, cols), np.bool_))

    def _draw(self) -> None:
        rows, cols = self.positions.T
        p = self.config.n_pursuers
        living = p + np.flatnonzero(self.alive[p:])
        self.inside[:OBSTACLE] = False
        self.inside[PURSUER, rows[:p], cols[:p]] = True
        self.inside[EVADER, rows[living], cols[living]] = True

    def views(self, agents: NDArray[np.intp], channel: int) -> NDArray[np.bool_]:
        """Return views (n, 3, fov, fov) of living agents of one team."""
        rows, cols = self.positions[agents].T
        views = self.windows[:, rows, cols].swapaxes(0, 1)
        cells = rows * self.config.cols + cols
        # An agent does not see itself; its own cell shows whether a teammate shares it.
        views[:, channel, self.reach, self.reach] = np.bincount(cells)[cells] > 1
        return views

    def step(self, actions: NDArray[np.int64]) -> None:
        """Move all agents by actions (P + E,)."""
        here, p = self.positions, self.config.n_pursuers
        there = here + MOVES[actions]
        blocked = self.planes[OBSTACLE, there[:, 0] + self.reach, there[:, 1] + self.reach]
        there[blocked | ~self.alive] = here[blocked | ~self.alive]
        old, new = (cells[:, 0] * self.config.cols + cells[:, 1] for cells in (here, there))
        # All pairs at once, (P, E): cheaper in NumPy than a dictionary of cells.
        meet = new[:p, None] == new[p:]
        swap = (new[:p, None] == old[p:]) & (old[:p, None] == new[p:])
        self.alive[p:] &= ~(meet | swap).any(axis=0)
        self.positions = there
        self._draw()


# ---- A match ---------------------------------------------------------------------------------


def act(
    network: mw.Network, genome: Genome, views: NDArray[np.bool_], rng: np.random.Generator
) -> NDArray[np.int64]:
    """Return actions (n,) drawn from the softmax of the network's outputs."""
    x = views.reshape(len(views), -1).astype(np.float32)
    *hidden, (weights, bias) = network.layers(genome)
    for inner, shift in hidden:
        x = np.maximum(x @ inner + shift, 0)
    logits = x @ weights + bias
    # Inverse transform sampling: count the cumulative probabilities below a uniform number.
    total = np.cumsum(np.exp(logits - logits.max(axis=1, keepdims=True)), axis=1)
    return (rng.random((len(x), 1)) * total[:, -1:] > total[:, :-1]).sum(axis=1)


def play(
    world: PlainWorld,
    network: mw.Network,
    pursuer: Genome,
    evader: Genome,
    rng: np.random.Generator,
) -> tuple[float, int]:
    """Play one match, and return captured fraction (see `EpisodeStatistics`) and decisions."""
    p, steps = world.config.n_pursuers, world.config.max_steps
    world.place_at_random(rng)
    pursuers, captured, decisions = np.arange(p), 0.0, 0
    for step in range(steps):
        evaders = p + np.flatnonzero(world.alive[p:])
        if len(evaders) == 0:
            return (captured + steps - step) / steps, decisions
        actions = np.zeros(world.config.n_agents, np.int64)
        actions[:p] = act(network, pursuer, world.views(pursuers, PURSUER), rng)
        actions[evaders] = act(network, evader, world.views(evaders, EVADER), rng)
        decisions += p + len(evaders)
        world.step(actions)
        captured += 1 - world.alive[p:].mean()
    return captured / steps, decisions


# ---- Co-evolution ----------------------------------------------------------------------------

Score = Callable[[str, list[Genome], Genome], tuple[Sequence[float], int]]
"""(team, its genomes, champion of the opponents) -> captured fraction of each match, decisions."""

MakeScore = Callable[[mw.WorldConfig, mw.Network, np.random.Generator], Score]


def plain_score(config: mw.WorldConfig, network: mw.Network, rng: np.random.Generator) -> Score:
    """Return a score function that plays matches one after the other in a `PlainWorld`."""
    world = PlainWorld(config)

    def score(team: str, genomes: list[Genome], rival: Genome) -> tuple[list[float], int]:
        pairs = [(own, rival) if team == "pursuer" else (rival, own) for own in genomes]
        played = [play(world, network, *pair, rng) for pair in pairs]
        return [captured for captured, _ in played], sum(decisions for _, decisions in played)

    return score


def rollout_score(config: mw.WorldConfig, network: mw.Network, rng: np.random.Generator) -> Score:
    """Return a score function that plays the matches by `matrixworld.rollout` on one thread."""

    def score(team: str, genomes: list[Genome], rival: Genome) -> tuple[NDArray[np.float32], int]:
        own, other = mw.Population(np.stack(genomes), network), mw.Population(rival, network)
        each, seeds = np.arange(len(genomes)), rng.integers(2**63, size=len(genomes))
        if team == "pursuer":
            scores = mw.rollout(config, own, other, mw.Matches.of(each, 0, seeds), threads=1)
        else:
            scores = mw.rollout(config, other, own, mw.Matches.of(0, each, seeds), threads=1)
        return scores.captured_fraction[:, 0], int(scores.agent_steps.sum())

    return score


def mate(one: Genome, other: Genome, rng: np.random.Generator) -> tuple[Genome, Genome]:
    """Swap each gene with probability 1/2, in place (uniform crossover)."""
    swapped = rng.random(len(one)) < 0.5
    one[swapped], other[swapped] = other[swapped], one[swapped]
    return one, other


def mutate(genome: Genome, rng: np.random.Generator) -> tuple[Genome]:
    """Add Gaussian noise to each gene, in place."""
    genome += np.float32(0.05) * rng.standard_normal(len(genome), dtype=np.float32)
    return (genome,)


@dataclass
class Coevolution:
    """Two populations, each evaluated against the champion of the other one.

    `score` plays the matches of a generation; the toolbox has operators select, mate and mutate.
    """

    score: Score
    populations: dict[str, list[Genome]]
    toolbox: base.Toolbox
    decisions: int = 0
    matches: int = 0

    def generation(self) -> None:
        """Select, vary and evaluate each team once, as DEAP's eaSimple does."""
        for team, rivals in (("pursuer", "evader"), ("evader", "pursuer")):
            # As in DEAP's eaSimple, children replace the whole population.
            parents = self.toolbox.select(self.populations[team], len(self.populations[team]))
            children = algorithms.varAnd(parents, self.toolbox, cxpb=0.5, mutpb=0.5)
            self.evaluate(team, children, tools.selBest(self.populations[rivals], 1)[0])
            self.populations[team] = children

    def evaluate(self, team: str, individuals: list[Genome], rival: Genome) -> None:
        """Play one match of each individual; old fitness is void, since the opponent changed."""
        captured, decisions = self.score(team, individuals, np.asarray(rival))
        for individual, share in zip(individuals, captured, strict=True):
            individual.fitness.values = (share if team == "pursuer" else 1 - share,)
        self.decisions += decisions
        self.matches += len(individuals)


def coevolution(score: Score, network: mw.Network, size: int, seed: int) -> Coevolution:
    """Return a race of two evaluated populations of `size` random genomes each."""
    random.seed(seed)  # DEAP's selection uses Python's global generator
    rng = np.random.default_rng(seed)
    toolbox = base.Toolbox()
    toolbox.register("select", tools.selTournament, tournsize=3)
    toolbox.register("mate", partial(mate, rng=rng))
    toolbox.register("mutate", partial(mutate, rng=rng))
    populations = {
        team: [creator.Individual(network.initial(rng)) for _ in range(size)]
        for team in ("pursuer", "evader")
    }
    race = Coevolution(score, populations, toolbox)
    for team, rivals in (("pursuer", "evader"), ("evader", "pursuer")):
        race.evaluate(team, populations[team], populations[rivals][0])
    return race
