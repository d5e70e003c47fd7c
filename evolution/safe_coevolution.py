"""What does it cost both teams to avoid collisions? Races with a price on them, or with a mask.

    python evolution/safe_coevolution.py             prices and masks: half an hour of two cores
    python evolution/safe_coevolution.py --quick     a small world: some seconds

**Prices.** In variant B an agent that runs into a border or a teammate bounces; there is no other
consequence. In each race the fitness of a team is

    capture (pursuers) or escape (evaders)  -  price * own collisions at fault per agent-step

Afterwards each team plays against all opponents of all races, so that prices are compared on the
same opponents. The script prints and draws the score of each team and how often it is at fault.

**Masks.** Default races of generalists, and the same with right of way for both teams
(`policy.mask=right-of-way`), ten seeds each: scores against held-out opponents, and collisions.

Method: evolution strategies (Salimans et al., 2017) against random opponents of the past. The price
is the fixed weight of a constraint; see Altman (1999), "Constrained Markov decision processes".

Look at three things. How many collisions are there at price 0? Running into a wall is as good as
standing still there, so selection does not remove it. Does a small price lower the capture rate or
raise it? At which price does a team prefer not to move, so that it cannot collide? In the second
table, look at the differences: an interval around 0 says how much the mask may cost.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, NamedTuple

import numpy as np
from matplotlib.figure import Figure
from tqdm import tqdm

import matrixworld as mw
from common import SMALL_RACE, Numbers, Runs, experiment, markdown, mean, play, written
from matrixworld import analysis, coevolution
from matrixworld._util import colors
from matrixworld.coevolution import EvolutionStrategy, NoiseTable, RaceSettings, SavedRun, Team
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

    def champion(t: int, player: int) -> tuple[float, np.ndarray]:
        own, monitor = pairs[t] == player, mw.SafetyMonitor()
        fields = (played.collisions, played.faults, played.agent_steps, played.capture_rate)
        monitor.add(*(each[own] for each in fields))
        summary = monitor.summary()
        score = (summary.capture_rate, 1 - summary.capture_rate)[t]
        return score, np.array([*summary.fault_rate[t, :2], summary.involved_rate[t, 2]])

    # Champions are ordered by price, then seed.
    grid = (len(budget.prices), budget.seeds)
    evaluations = {}
    for t, team in enumerate(coevolution.TEAMS):
        score, rates = zip(*(champion(t, player) for player in range(n)), strict=True)
        evaluations[team] = Evaluation(np.reshape(score, grid), np.reshape(rates, (*grid, 3)))
    return evaluations


def price_table(evaluations: Mapping[Team, Evaluation], numbers: Numbers) -> str:
    """Return the evaluations in Markdown: means over seeds, with intervals over seeds."""
    told = (
        "Score: capture rate of pursuers, escape rate of evaders. Obstacles, teammates: steps at\n"
        "fault, adversaries: steps in contact, both per 1000 agent-steps. [95% over seeds]\n\n"
    )
    rows = []
    for team, evaluation in evaluations.items():
        for price, score, rates in zip(numbers["prices"], *evaluation, strict=True):
            means = (mean(rate, 0, bounds=(0.0, np.inf)) for rate in rates.T)
            score_mean = mean(score, 2, bounds=(0.0, np.inf))
            matches = f"{numbers['matches']:,}"
            rows.append([f"{team}s", f"{price:g}", score_mean, *means, matches])
    heads = ["team", "price", "score", "obstacles", "teammates", "adversaries", "matches"]
    return told + markdown(heads, rows)


def evaluations_in(numbers: Numbers) -> dict[Team, Evaluation]:
    """Return the evaluations that are kept."""
    return {
        team: Evaluation(numbers[f"{team} score"], numbers[f"{team} collisions"])
        for team in coevolution.TEAMS
    }


def together(runs: Runs, quick: bool) -> dict[str, Any]:
    """Run a race for each price and seed; return the evaluation of their champions."""
    budget = QUICK if quick else FULL
    races = [(price, seed) for price in budget.prices for seed in range(budget.seeds)]
    bar = tqdm(races, desc="races", disable=None)
    last = [race(price, budget, seed) for price, seed in bar]
    champions = {team: np.stack([each[team] for each in last]) for team in coevolution.TEAMS}
    numbers: dict[str, Any] = {"prices": budget.prices, "matches": budget.matches}
    for team, evaluation in evaluate(champions, budget).items():
        numbers |= {f"{team} score": evaluation.score, f"{team} collisions": evaluation.collisions}
    return numbers


def figure(numbers: Numbers) -> Figure:
    """Draw score over collisions at fault: small marks are seeds, large ones are means."""
    evaluations, prices = evaluations_in(numbers), numbers["prices"]
    drawn = Figure(figsize=(9.0, 4.4), dpi=150, layout="constrained")
    panels = drawn.subplots(1, 2, sharex=True, sharey=True)
    teams = zip(evaluations.items(), panels, colors.TEAMS, ("capture", "escape"), strict=True)
    for (team, (score, collisions)), axes, color, aim in teams:
        at_fault = collisions[:, :, :2].sum(axis=2)
        for price, x, y, mark in zip(prices, at_fault, score, MARKERS, strict=False):
            axes.plot(x, y, mark, color=color, markersize=4, alpha=0.6)
            ring = {"color": color, "markersize": 11, "fillstyle": "none"}
            axes.plot(x.mean(), y.mean(), mark, label=f"price {price:g}", **ring)
        axes.set(title=f"{team}s", xlabel="collisions at fault per 1000 agent-steps", ylim=(0, 1))
        axes.set_ylabel(f"{aim} rate")
        axes.grid(color=colors.GRID)
        axes.legend()
    return drawn


MASKS = ("none", "right-of-way")
QUICK_RACE = {
    **SMALL_RACE, "schedule.generations": 4, "schedule.pursuer_epochs": 2,
    "schedule.evader_epochs": 2,
}  # fmt: skip


def kinds(quick: bool) -> dict[str, RaceSettings]:
    """Return default races with each of `MASKS`."""
    base = RaceSettings.of(QUICK_RACE if quick else {})
    return {mask: base.changed({"policy.mask": mask}) for mask in MASKS}


def of_race(run: SavedRun, quick: bool) -> dict[str, list[float]]:
    """Return scores of both teams and collisions: late ones of both teams, and all of training."""
    scores, log = coevolution.score(run), run.log()
    late = log["generation"] == log["generation"].max()
    episodes = np.diff(log["matches"], prepend=0)
    collisions = [log[f"{team}_faults"] for team in coevolution.TEAMS]
    return {
        "scores": [float(scores[team].means[-1]) for team in coevolution.TEAMS],
        "late": [float(each[late].mean()) for each in collisions],
        "all": [float(sum(each @ episodes for each in collisions))],
    }


def mask_table(numbers: Numbers) -> str:
    """Return what the masks change, in Markdown: means over seeds, and differences of seeds."""
    found = {
        mask: np.hstack([numbers[f"{mask} / {name}"] for name in ("scores", "late", "all")])
        for mask in MASKS
    }
    found["right of way, minus none"] = np.subtract(*(found[mask] for mask in MASKS[::-1]))
    rows = []
    for label, columns in found.items():
        sign = "+" if "minus" in label else ""
        means = [analysis.interval_over_runs(column) for column in columns.T]
        digits = (2, 2, 1, 1)
        cells = [written(each, n, sign) for each, n in zip(means, digits, strict=False)]
        rows.append([label, *cells, format(means[4].value, f"{sign},.0f")])
    heads = [
        "mask", "score, pursuers", "score, evaders", "collisions, pursuers", "evaders",
        "in all of training",
    ]  # fmt: skip
    told = (
        "Scores of the last generations against held-out opponents; collisions: agent-steps at "
        "fault in an episode\nof the last generation's training, and in all of training. "
        "[95% over seeds]\n\n"
    )
    return told + markdown(heads, rows)


def table(numbers: Numbers) -> str:
    """Return both tables."""
    return f"{price_table(evaluations_in(numbers), numbers)}\n\n{mask_table(numbers)}"


if __name__ == "__main__":
    experiment(
        __file__,
        __doc__,
        kinds=kinds,
        measure=of_race,
        together=together,
        table=table,
        seeds=10,
        figures={"prices.png": figure},
    )
