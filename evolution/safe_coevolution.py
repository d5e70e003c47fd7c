"""Safe co-evolution: both teams pay for their own collisions, and what that costs them.

    python evolution/safe_coevolution.py             four prices, five seeds: some minutes
    python evolution/safe_coevolution.py --quick     two prices, a small world: some seconds

In variant B whoever runs into a border or a teammate bounces, and nothing else happens to it. In
each race both teams evolve for

    capture (pursuers) or escape (evaders)  -  price * own collisions at fault per agent-step

and afterwards every team meets all opponents of all races, so that prices are compared on the same
opponents. Printed and drawn: what each team scores, and how often it is at fault. Where agents
bounce, running into a wall is as good as standing still, and nothing but a price weeds it out. Look
how much of it there is at price 0, whether a small price costs captures or brings some, and from
which price on a team would rather do nothing than risk a collision.
"""

from __future__ import annotations

import argparse
from collections.abc import Mapping
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from matplotlib.figure import Figure
from tqdm import tqdm

import matrixworld as mw
from matrixworld import analysis, coevolution, colors
from matrixworld.coevolution import EvolutionStrategy, NoiseTable, Team

SIGMA = 0.1  # of the evolution strategy's samples
MARKERS = "osD^v<>ph"  # one a price


@dataclass(frozen=True)
class Budget:
    """The prices, the world, and how much is played: each race as many matches as any other."""

    prices: tuple[float, ...]
    seeds: int
    world: mw.WorldConfig
    generations: int
    epochs: int
    """Of each team in a generation."""
    samples: int
    episodes: int
    """Of each pair in the end."""

    @property
    def matches(self) -> int:
        """Played by each team of a race in training."""
        return self.generations * self.epochs * self.samples


WORLD = mw.WorldConfig("B", rows=14, cols=14, n_pursuers=4, n_evaders=6, max_steps=80)
SMALL = mw.WorldConfig("B", rows=8, cols=8, n_pursuers=3, n_evaders=3, max_steps=30)
FULL = Budget((0.0, 0.1, 1.0, 10.0), 5, WORLD, 10, 40, 32, 20)
QUICK = Budget((0.0, 1.0), 2, SMALL, 3, 8, 12, 10)


def play(
    world: mw.WorldConfig, team: Team, own: mw.Population, rival: mw.Population, seeds: np.ndarray
) -> mw.EpisodeStatistics:
    """One match of each candidate of a team against one rival."""
    each = np.arange(len(own.genomes))
    if team == "pursuer":
        return mw.rollout(world, own, rival, mw.Matches.of(each, 0, seeds))
    return mw.rollout(world, rival, own, mw.Matches.of(0, each, seeds))


def fitness(scores: mw.EpisodeStatistics, team: Team, price: float) -> np.ndarray:
    """What a team is after, less what its collisions cost; the mean over the worlds, (M,)."""
    t = coevolution.TEAMS.index(team)
    at_fault = scores.faults[:, :, t].sum(axis=2) / scores.agent_steps[:, :, t]
    captured = scores.captured_fraction
    aim = captured if team == "pursuer" else 1 - captured
    return (aim - price * at_fault).mean(axis=1)


def race(price: float, budget: Budget, seed: int) -> dict[Team, np.ndarray]:
    """The last genomes of both teams; in every epoch a team meets one of its rivals' past."""
    rng = np.random.default_rng(seed)
    network = mw.Network.for_config(budget.world)
    noise = NoiseTable(network.genome_size, rng, sigma=SIGMA)
    learners = {
        team: EvolutionStrategy(network.initial(rng), noise, samples=budget.samples)
        for team in coevolution.TEAMS
    }
    archive = {team: [learner.genome] for team, learner in learners.items()}
    rivals: dict[Team, Team] = {"pursuer": "evader", "evader": "pursuer"}
    for _ in range(budget.generations):
        for team, learner in learners.items():
            for _ in range(budget.epochs):
                met = archive[rivals[team]][rng.integers(len(archive[rivals[team]]))]
                candidates = mw.Population(learner.ask(rng), network)
                pairs = rng.integers(2**63, size=budget.samples // 2)  # a mirrored pair, a seed
                rival = mw.Population(met, network)
                scores = play(budget.world, team, candidates, rival, np.tile(pairs, 2))
                learner.tell(fitness(scores, team, price))
            archive[team].append(learner.genome)
    return {team: learner.genome for team, learner in learners.items()}


class Outcomes(NamedTuple):
    """Of one team, each price and seed; means over all of its matches."""

    score: np.ndarray
    """(prices, seeds), capture rate of pursuers, escape rate of evaders."""
    collisions: np.ndarray
    """(prices, seeds, 3), agent-steps per 1000: at fault with obstacles and with teammates, and
    involved with adversaries, which is nobody's fault where capture is by occupation."""


def outcomes(champions: Mapping[Team, np.ndarray], budget: Budget) -> dict[Team, Outcomes]:
    """How well and how safely each champion (n, genes) plays against all n of the other team."""
    network, n = mw.Network.for_config(budget.world), len(champions["pursuer"])
    pursuers, evaders = (mw.Population(champions[team], network) for team in coevolution.TEAMS)
    pairs = np.indices((n, n)).reshape(2, -1)
    matches = mw.Matches.of(*pairs, np.arange(n * n))
    scores = mw.rollout(budget.world, pursuers, evaders, matches, worlds=budget.episodes)

    def told(t: int, player: int) -> tuple[float, np.ndarray]:
        own, monitor = pairs[t] == player, mw.SafetyMonitor()
        fields = (scores.collisions, scores.faults, scores.agent_steps, scores.capture_rate)
        monitor.add(*(each[own] for each in fields))
        seen = monitor.summary()
        score = (seen.capture_rate, 1 - seen.capture_rate)[t]
        return score, np.array([*seen.fault_rate[t, :2], seen.involved_rate[t, 2]])

    grid = (len(budget.prices), budget.seeds)
    of_teams = {}
    for t, team in enumerate(coevolution.TEAMS):
        score, rates = zip(*(told(t, player) for player in range(n)), strict=True)
        of_teams[team] = Outcomes(np.reshape(score, grid), np.reshape(rates, (*grid, 3)))
    return of_teams


def table(of_teams: Mapping[Team, Outcomes], budget: Budget) -> str:
    """The outcomes in Markdown: means over seeds, with intervals over seeds."""

    def told(values: np.ndarray, digits: int) -> str:
        mean = analysis.bootstrap_runs(values)
        if mean.low is None:
            return f"{mean.value:.{digits}f}"
        return f"{mean.value:.{digits}f} [{mean.low:.{digits}f}, {mean.high:.{digits}f}]"

    lines = [
        "Score: capture rate of pursuers, escape rate of evaders. Agent-steps per 1000 at fault",
        "with obstacles and teammates, and in contact with adversaries. [95% over seeds]\n",
        "| team | price | score | obstacles | teammates | adversaries | matches |",
        "|---|---|---|---|---|---|---|",
    ]
    for team, seen in of_teams.items():
        for price, score, rates in zip(budget.prices, *seen, strict=True):
            numbers = (told(score, 2), *(told(rate, 0) for rate in rates.T))
            cells = (f"{team}s", f"{price:g}", *numbers, f"{budget.matches:,}")
            lines.append(f"| {' | '.join(cells)} |")
    return "\n".join(lines)


def figure(of_teams: Mapping[Team, Outcomes], budget: Budget) -> Figure:
    """What each team scores over how often it is at fault: small marks are seeds, large means."""
    drawn = Figure(figsize=(9.0, 4.4), dpi=150, layout="constrained")
    panels = drawn.subplots(1, 2, sharex=True, sharey=True)
    looks = zip(of_teams.items(), panels, colors.TEAMS, ("capture", "escape"), strict=True)
    for (team, seen), axes, color, aim in looks:
        at_fault = seen.collisions[:, :, :2].sum(axis=2)
        for price, x, y, mark in zip(budget.prices, at_fault, seen.score, MARKERS, strict=False):
            axes.plot(x, y, mark, color=color, markersize=4, alpha=0.6)
            ring = {"color": color, "markersize": 11, "fillstyle": "none"}
            axes.plot(x.mean(), y.mean(), mark, label=f"price {price:g}", **ring)
        axes.set(title=f"{team}s", xlabel="collisions at fault per 1000 agent-steps", ylim=(0, 1))
        axes.set_ylabel(f"{aim} rate")
        axes.grid(color=colors.GRID)
        axes.legend()
    return drawn


def main() -> None:
    """Race at every price from every seed; print and draw what came of it."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--quick", action="store_true", help="two prices and a small world")
    parser.add_argument("--figure", default="safe_coevolution.png", help="file to draw to")
    args = parser.parse_args()
    budget = QUICK if args.quick else FULL
    races = [(price, seed) for price in budget.prices for seed in range(budget.seeds)]
    bar = tqdm(races, desc="races", disable=None)
    last = [race(price, budget, seed) for price, seed in bar]
    champions = {team: np.stack([each[team] for each in last]) for team in coevolution.TEAMS}
    seen = outcomes(champions, budget)
    print(table(seen, budget))
    figure(seen, budget).savefig(args.figure)
    print(f"\nDrawn: {args.figure}")


if __name__ == "__main__":
    main()
