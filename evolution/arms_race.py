"""Do specialists cycle, and do generalists improve? An arms race on a grid in one short script.

    python evolution/arms_race.py             specialists and generalists, some minutes
    python evolution/arms_race.py --quick     a small world, some seconds

This is the core of ``matrixworld evolve``, to read and to change: an evolution strategy behind a
DEAP toolbox, two schedules of opponents, a payoff matrix of all generations, and a figure. The
command also writes all data to disk, resumes interrupted runs, and replays matches.

Method: Sun et al. (2023), "MatrixWorld", arXiv:2307.14854, for the schedules; Salimans et al.
(2017), "Evolution strategies as a scalable alternative to reinforcement learning", for the learner.

Look at the payoff matrices: specialists show stripes (who wins depends on the pairing), generalists
a gradient (later generations beat all earlier ones). The printed judgement says what the
data can tell.
"""

from __future__ import annotations

from dataclasses import replace
from typing import NamedTuple

import numpy as np
from deap import base
from tqdm import tqdm

import matrixworld as mw
from common import play, script_parser
from matrixworld import analysis, coevolution, plots
from matrixworld.coevolution import Alternating, EvolutionStrategy, NoiseTable, Team
from matrixworld.coevolution.types import other

DEFAULTS = coevolution.RaceSettings()
OVERLAP_PENALTY = 0.2  # for evaders that share cells


class Budget(NamedTuple):
    """World and length of a race."""

    world: mw.WorldConfig
    generations: int
    epochs: dict[Team, int]
    """Epochs in which each team learns in a generation."""
    samples: int
    """Candidates of the evolution strategy in each epoch."""


FULL = Budget(mw.WorldConfig("O", max_steps=200), 30, {"pursuer": 60, "evader": 120}, 48)
SMALL = mw.WorldConfig("O", rows=14, cols=14, n_pursuers=3, n_evaders=6, max_steps=80)
QUICK = Budget(SMALL, 12, {"pursuer": 12, "evader": 12}, 16)


def score(
    team: Team, world: mw.WorldConfig, own: mw.Population, rival: mw.Population, seeds: np.ndarray
) -> np.ndarray:
    """Return the fitness of each candidate from one match against one rival that does not learn."""
    statistics = play(world, team, own, rival, seeds)
    captured = statistics.captured_fraction[:, 0]
    if team == "pursuer":
        return captured
    return 1 - captured - OVERLAP_PENALTY * statistics.evader_overlap[:, 0]


def toolbox_of(team: Team, budget: Budget, rng: np.random.Generator) -> base.Toolbox:
    """Return a DEAP toolbox with generate, evaluate, update, and ``champion``: the mean genome."""
    # Samples are slices of one table, so an epoch draws no Gaussian noise.
    network = mw.Network.for_config(budget.world)
    noise = NoiseTable(network.genome_size, rng, sigma=DEFAULTS.learner.sigma)
    learner = EvolutionStrategy(network.initial(rng), noise, samples=budget.samples)

    def evaluate(candidates: np.ndarray, rival: np.ndarray, seeds: np.ndarray) -> np.ndarray:
        own, opponent = mw.Population(candidates, network), mw.Population(rival, network)
        return score(team, budget.world, own, opponent, seeds)

    # DEAP's ask-and-tell convention: generate asks the learner, update tells it the fitness.
    toolbox = base.Toolbox()
    toolbox.register("generate", learner.ask, rng)
    toolbox.register("evaluate", evaluate)
    toolbox.register("update", learner.tell)
    toolbox.register("champion", lambda: learner.genome)
    return toolbox


def race(
    name: str, schedule: Alternating, budget: Budget, seed: int
) -> dict[Team, list[np.ndarray]]:
    """Return the archives of both teams: the champion of every generation, untrained one first."""
    rng = np.random.default_rng(seed)
    toolboxes = {team: toolbox_of(team, budget, rng) for team in coevolution.TEAMS}
    samplers = {team: schedule.new_sampler(team) for team in coevolution.TEAMS}
    # Untrained champions first: generation 0 of the payoff matrix.
    archive = {team: [toolbox.champion()] for team, toolbox in toolboxes.items()}
    for generation in tqdm(range(1, budget.generations + 1), desc=name, disable=None):
        for team, toolbox in toolboxes.items():
            for epoch in range(budget.epochs[team]):
                available = coevolution.available(team, generation)
                (met,) = samplers[team].sample(available, epoch, rng)
                candidates = toolbox.generate()
                # Both samples of a mirrored pair play the same seed, so that their fitness differs
                # by their genomes only.
                pairs = rng.integers(2**63, size=budget.samples // 2)
                fitness = toolbox.evaluate(candidates, archive[other(team)][met], np.tile(pairs, 2))
                toolbox.update(fitness)
            archive[team].append(toolbox.champion())
    return archive


def payoff(archive: dict[Team, list[np.ndarray]], budget: Budget, seed: int) -> coevolution.Payoff:
    """Play all generations of pursuers (rows) against all generations of evaders (columns)."""
    network = mw.Network.for_config(budget.world)
    pursuers, evaders = (mw.Population(np.stack(genomes), network) for genomes in archive.values())
    # Short episodes are enough to learn; long ones distinguish trained teams better.
    world = replace(budget.world, max_steps=DEFAULTS.world.max_steps)
    return coevolution.tournament(
        world, pursuers, evaders, seed=seed, episodes=DEFAULTS.evaluation_episodes
    )


def main() -> None:
    """Run a race by each schedule, print the judgements and draw the payoff matrices."""
    parser = script_parser(__doc__, quick="a small world and few epochs")
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument(
        "--schedules",
        nargs="+",
        choices=coevolution.SCHEDULES,
        default=["specialist-specialist", "generalist-generalist"],
    )
    parser.add_argument("--figure", default="arms_race.png", help="file to draw to")
    args = parser.parse_args()
    budget = QUICK if args.quick else FULL
    payoffs, judgements = {}, {}
    for name in args.schedules:
        archive = race(name, coevolution.SCHEDULES[name], budget, args.seed)
        played = payoff(archive, budget, args.seed)
        payoffs[name] = played.capture_rate
        judgements[name] = analysis.judge(played.capture_rates, per_episode=True)
        print(f"\n{name}: {analysis.headline(judgements[name])}")
        print(f"{analysis.explain(judgements[name])}\n")
    plots.comparison(payoffs, judgements).savefig(args.figure)
    print(f"Drawn: {args.figure}")


if __name__ == "__main__":
    main()
