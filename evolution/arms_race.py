"""Arms races on a grid, written out: who learns, whom they meet, and what comes of it.

    python evolution/arms_race.py             specialists and generalists, some minutes
    python evolution/arms_race.py --quick     a small world, some seconds

This is the core of ``matrixworld evolve`` to be read and changed: an evolution strategy behind a
DEAP toolbox, two schedules, everybody against everybody, numbers and a figure. The command also
writes all to disk, resumes, and replays.
"""

from __future__ import annotations

import argparse
from dataclasses import dataclass, replace

import numpy as np
from deap import base
from tqdm import tqdm

import matrixworld as mw
from matrixworld import analysis, coevolution, plots
from matrixworld.coevolution import Candidates, EvolutionStrategy, NoiseTable, Schedule, Team

DEFAULTS = coevolution.RaceSettings()
CROWDING = 0.2  # what it costs evaders to stand on one another's cells


@dataclass(frozen=True)
class Budget:
    """The world in training, the epochs that each team learns in a generation, its samples."""

    world: mw.WorldConfig
    generations: int
    epochs: dict[Team, int]
    samples: int


FULL = Budget(mw.WorldConfig("O", max_steps=200), 30, {"pursuer": 60, "evader": 120}, 48)
SMALL = mw.WorldConfig("O", rows=14, cols=14, n_pursuers=3, n_evaders=6, max_steps=80)
QUICK = Budget(SMALL, 12, {"pursuer": 12, "evader": 12}, 16)


def score(
    team: Team, world: mw.WorldConfig, own: mw.Population, rival: mw.Population, seeds: np.ndarray
) -> np.ndarray:
    """Fitness of each candidate of a team: one match against one rival that stands still."""
    each = np.arange(len(own.genomes))
    if team == "pursuer":
        return mw.rollout(world, own, rival, mw.Matches.of(each, 0, seeds)).captured_fraction[:, 0]
    scores = mw.rollout(world, rival, own, mw.Matches.of(0, each, seeds))
    return (1 - scores.captured_fraction - CROWDING * scores.evader_overlap)[:, 0]


def toolbox_of(team: Team, budget: Budget, rng: np.random.Generator) -> base.Toolbox:
    """A DEAP toolbox that generates, evaluates and updates; ``champion`` is what it has learned."""
    network = mw.Network.for_config(budget.world)
    noise = NoiseTable(network.genome_size, rng, sigma=DEFAULTS.sigma)
    learner = EvolutionStrategy(network.initial(rng), noise, samples=budget.samples)

    def evaluate(candidates: Candidates, rival: np.ndarray, seeds: np.ndarray) -> np.ndarray:
        own, other = mw.Population(candidates.genomes, network), mw.Population(rival, network)
        return score(team, budget.world, own, other, seeds)

    def update(candidates: Candidates) -> None:
        learner.tell([candidate.fitness.values[0] for candidate in candidates])

    toolbox = base.Toolbox()
    toolbox.register("generate", lambda: Candidates(learner.ask(rng)))
    toolbox.register("evaluate", evaluate)
    toolbox.register("update", update)
    toolbox.register("champion", lambda: learner.genome)
    return toolbox


def race(name: str, schedule: Schedule, budget: Budget, seed: int) -> dict[Team, list[np.ndarray]]:
    """The archives of both teams: the champion of every generation, the untrained one first."""
    rng = np.random.default_rng(seed)
    toolboxes = {team: toolbox_of(team, budget, rng) for team in coevolution.TEAMS}
    samplers = {team: schedule.sampler(team) for team in coevolution.TEAMS}
    archive = {team: [toolbox.champion()] for team, toolbox in toolboxes.items()}
    rivals: dict[Team, Team] = {"pursuer": "evader", "evader": "pursuer"}
    for generation in tqdm(range(1, budget.generations + 1), desc=name, disable=None):
        for team, toolbox in toolboxes.items():
            for epoch in range(budget.epochs[team]):
                available = coevolution.available(team, generation)
                (met,) = samplers[team].sample(available, epoch, rng)
                candidates = toolbox.generate()
                pairs = rng.integers(2**63, size=budget.samples // 2)  # a mirrored pair, a seed
                values = toolbox.evaluate(candidates, archive[rivals[team]][met], np.tile(pairs, 2))
                for candidate, value in zip(candidates, values, strict=True):
                    candidate.fitness.values = (float(value),)
                toolbox.update(candidates)
            archive[team].append(toolbox.champion())
    return archive


def payoff(archive: dict[Team, list[np.ndarray]], budget: Budget, seed: int) -> np.ndarray:
    """Capture rates of every generation of pursuers (rows) against all of evaders (columns)."""
    network = mw.Network.for_config(budget.world)
    pursuers, evaders = (mw.Population(np.stack(genomes), network) for genomes in archive.values())
    world = replace(budget.world, max_steps=DEFAULTS.eval_steps)
    played = coevolution.tournament(
        world, pursuers, evaders, seed=seed, episodes=DEFAULTS.eval_episodes
    )
    return played.capture_rate


def main() -> None:
    """Race by each schedule that was asked for; print and draw what came of it."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--quick", action="store_true", help="a small world and few epochs")
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
    payoffs = {}
    for name in args.schedules:
        archive = race(name, coevolution.SCHEDULES[name], budget, args.seed)
        payoffs[name] = payoff(archive, budget, args.seed)
        print(f"\n{name}\n{analysis.describe(analysis.summarize(payoffs[name]))}\n")
    plots.comparison(payoffs).savefig(args.figure)
    print(f"Drawn: {args.figure}")


if __name__ == "__main__":
    main()
