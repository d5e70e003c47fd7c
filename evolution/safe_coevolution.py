"""What does it cost both teams to avoid collisions? Races with a price on them.

    python evolution/safe_coevolution.py             four prices, some minutes of one core
    python evolution/safe_coevolution.py --quick     a small world: some seconds

In variant B an agent that runs into a border or a teammate bounces; there is no other
consequence. In each race the fitness of a team is

    capture (pursuers) or escape (evaders)  -  price * own collisions at fault per agent-step

Afterwards each team plays against all opponents of all races, so that prices are compared on the
same opponents. The script prints and draws the score of each team and how often it is at fault.
(`safe_races.py` asks the same of a mask, with which no agent is at fault.)

Method: evolution strategies (Salimans et al., 2017) against random opponents of the past. The price
is the fixed weight of a constraint; see Altman (1999), "Constrained Markov decision processes".

Look at three things. How many collisions are there at price 0? Running into a wall is as good as
standing still there, so selection does not remove it. Does a small price lower the capture rate or
raise it? At which price does a team prefer not to move, so that it cannot collide?
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

import numpy as np
from matplotlib.figure import Figure
from tqdm import tqdm

import matrixworld as mw
from common import markdown, mean, play, script_parser
from matrixworld import coevolution
from matrixworld._util import colors
from matrixworld.coevolution import EvolutionStrategy, NoiseTable, Team
from matrixworld.coevolution.types import other

SIGMA = 0.1  # standard deviation of the evolution strategy's samples
MARKERS = "osD^v<>ph"  # one for each price


class Budget(NamedTuple):
    """Prices, world and length of the races; all races have the same number of matches."""

    prices: tuple[float, ...]
    """Prices of a collision at fault per agent-step."""
    seeds: int
    world: mw.WorldConfig
    generations: int
    epochs: int
    """Epochs of each team in a generation."""
    samples: int
    """Candidates of the evolution strategy in each epoch."""
    episodes: int
    """Episodes of each pair in the final evaluation."""

    @property
    def matches(self) -> int:
        """Training matches of each team in a race."""
        return self.generations * self.epochs * self.samples


WORLD = mw.WorldConfig("B", rows=14, cols=14, n_pursuers=4, n_evaders=6, max_steps=80)
SMALL = mw.WorldConfig("B", rows=8, cols=8, n_pursuers=3, n_evaders=3, max_steps=30)
FULL = Budget((0.0, 0.1, 1.0, 10.0), 5, WORLD, 10, 40, 32, 20)
QUICK = Budget((0.0, 1.0), 2, SMALL, 3, 8, 12, 10)


def fitness(statistics: mw.EpisodeStatistics, team: Team, price: float) -> np.ndarray:
    """Return capture or escape minus the price of own collisions; shape (matches,)."""
    t = coevolution.TEAMS.index(team)
    # Per agent-step, since captured evaders cannot collide any more.
    at_fault = statistics.faults[:, :, t].sum(axis=2) / statistics.agent_steps[:, :, t]
    captured = statistics.captured_fraction
    aim = captured if team == "pursuer" else 1 - captured
    return (aim - price * at_fault).mean(axis=1)


def race(price: float, budget: Budget, seed: int) -> dict[Team, np.ndarray]:
    """Return the last genomes of both teams; in each epoch a team meets one past opponent."""
    rng = np.random.default_rng(seed)
    network = mw.Network.for_config(budget.world)
    noise = NoiseTable(network.genome_size, rng, sigma=SIGMA)
    learners = {
        team: EvolutionStrategy(network.initial(rng), noise, samples=budget.samples)
        for team in coevolution.TEAMS
    }
    # Random past opponents instead of the newest one make cycling less likely.
    archive = {team: [learner.genome] for team, learner in learners.items()}
    for _ in range(budget.generations):
        for team, learner in learners.items():
            for _ in range(budget.epochs):
                past = archive[other(team)]
                rival = mw.Population(past[rng.integers(len(past))], network)
                candidates = mw.Population(learner.ask(rng), network)
                # Both samples of a mirrored pair play the same seed.
                pairs = rng.integers(2**63, size=budget.samples // 2)
                statistics = play(budget.world, team, candidates, rival, np.tile(pairs, 2))
                learner.tell(fitness(statistics, team, price))
            archive[team].append(learner.genome)
    return {team: learner.genome for team, learner in learners.items()}


class Evaluation(NamedTuple):
    """Means over all matches of one team's champions, by price and seed."""

    score: np.ndarray
    """Capture rate of pursuers, escape rate of evaders."""
    collisions: np.ndarray
    """Agent-steps per 1000 (last axis): at fault with obstacles, at fault with teammates, and
    involved with adversaries. Contact with adversaries is a capture here: no agent is at fault."""


def evaluate(champions: Mapping[Team, np.ndarray], budget: Budget) -> dict[Team, Evaluation]:
    """Evaluate each champion (n, genes) of both teams against all n of the other team."""
    network, n = mw.Network.for_config(budget.world), len(champions["pursuer"])
    pursuers, evaders = (mw.Population(champions[team], network) for team in coevolution.TEAMS)
    # All champions meet all opponents: a price is judged by the same opponents as any other.
    pairs = np.indices((n, n)).reshape(2, -1)
    matches = mw.Matches.of(*pairs, np.arange(n * n))
    played = mw.rollout(budget.world, pursuers, evaders, matches, episodes=budget.episodes)

    # By pursuers and evaders, in place of matches.
    faults, contacts, steps, captured = (
        each.reshape(n, n, *each.shape[1:])
        for each in (played.faults, played.collisions, played.agent_steps, played.capture_rate)
    )
    # Champions are ordered by price, then seed.
    grid = (len(budget.prices), budget.seeds)
    evaluations = {}
    for t, team in enumerate(coevolution.TEAMS):
        rest = (1 - t, 2)  # opponents and episodes
        score = captured.mean(axis=rest)
        counts = [*faults[..., t, :2].sum(axis=rest).T, contacts[..., t, 2].sum(axis=rest)]
        rates = 1000 * np.stack(counts, axis=1) / steps[..., t].sum(axis=rest)[:, np.newaxis]
        score = score if team == "pursuer" else 1 - score
        evaluations[team] = Evaluation(score.reshape(grid), rates.reshape(*grid, 3))
    return evaluations


def table(evaluations: Mapping[Team, Evaluation], budget: Budget) -> str:
    """Return the evaluations in Markdown: means over seeds, with intervals over seeds."""
    told = (
        "Score: capture rate of pursuers, escape rate of evaders. Obstacles, teammates: steps at\n"
        "fault, adversaries: steps in contact, both per 1000 agent-steps. [95% over seeds]\n\n"
    )
    rows = []
    for team, evaluation in evaluations.items():
        for price, score, rates in zip(budget.prices, *evaluation, strict=True):
            means = (mean(rate, 0, bounds=(0.0, np.inf)) for rate in rates.T)
            score_mean = mean(score, 2, bounds=(0.0, np.inf))
            rows.append([f"{team}s", f"{price:g}", score_mean, *means, f"{budget.matches:,}"])
    heads = ["team", "price", "score", "obstacles", "teammates", "adversaries", "matches"]
    return told + markdown(heads, rows)


def figure(evaluations: Mapping[Team, Evaluation], budget: Budget) -> Figure:
    """Draw score over collisions at fault: small marks are seeds, large ones are means."""
    drawn = Figure(figsize=(9.0, 4.4), dpi=150, layout="constrained")
    panels = drawn.subplots(1, 2, sharex=True, sharey=True)
    teams = zip(evaluations.items(), panels, colors.TEAMS, ("capture", "escape"), strict=True)
    for (team, (score, collisions)), axes, color, aim in teams:
        at_fault = collisions[:, :, :2].sum(axis=2)
        for price, x, y, mark in zip(budget.prices, at_fault, score, MARKERS, strict=False):
            axes.plot(x, y, mark, color=color, markersize=4, alpha=0.6)
            ring = {"color": color, "markersize": 11, "fillstyle": "none"}
            axes.plot(x.mean(), y.mean(), mark, label=f"price {price:g}", **ring)
        axes.set(title=f"{team}s", xlabel="collisions at fault per 1000 agent-steps", ylim=(0, 1))
        axes.set_ylabel(f"{aim} rate")
        axes.grid(color=colors.GRID)
        axes.legend()
    return drawn


def main() -> None:
    """Run a race for each price and seed; print, write and draw what their champions do."""
    parser = script_parser(__doc__, quick="a small world, two prices and two seeds")
    parser.add_argument("--figure", default="safe_coevolution.png", help="file to draw to")
    args = parser.parse_args()
    budget = QUICK if args.quick else FULL
    races = [(price, seed) for price in budget.prices for seed in range(budget.seeds)]
    bar = tqdm(races, desc="races", disable=None)
    last = [race(price, budget, seed) for price, seed in bar]
    champions = {team: np.stack([each[team] for each in last]) for team in coevolution.TEAMS}
    evaluations = evaluate(champions, budget)
    print(table(evaluations, budget))
    figure(evaluations, budget).savefig(args.figure)
    print(f"\nDrawn: {args.figure}")


if __name__ == "__main__":
    main()
