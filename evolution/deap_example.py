"""How is co-evolution written as a DEAP program? Two populations evolve in turns.

    python evolution/deap_example.py             a minute or two
    python evolution/deap_example.py --quick     a small world, some seconds

Individuals, operators, statistics and the loop are those of DEAP, or written as DEAP users write
them; the evaluation is ``matrixworld.rollout``. To change the algorithm, register other operators
or call another function of ``deap.algorithms``. Three things are special in co-evolution:

- ``toolbox.map`` receives the whole population and plays all its matches in one call;
- each learning player meets several opponents, and all players meet the same ones with the same
  seeds;
- at the start of a turn the fitness values are deleted, because they come from other opponents.

`best_response` shows the opposite direction: a loop of DEAP drives a learner of matrixworld, or
your own class derived from ``coevolution.Learner``. It measures how far
the last champions can be beaten by an opponent that trains against them only. With
``docs/how_to_add.md`` a toolbox becomes a learner by name: ``evolve --learner ...``.

Method: Fortin et al. (2012), "DEAP: evolutionary algorithms made easy"; (mu + lambda) selection.

Look at the logbook (fitness of each team at the end of its turn), at the gain of the best
responses, and at the figure of all champions against each other.
"""

from __future__ import annotations

import random
from typing import NamedTuple

import numpy as np
from deap import algorithms, base, tools

import matrixworld as mw
from common import script_parser
from matrixworld import coevolution, plots
from matrixworld.coevolution import Team
from matrixworld.coevolution.types import other

OVERLAP_PENALTY = 0.2  # for evaders that share cells
SIGMA = 0.1  # standard deviation of mutations and of the evolution strategy's samples


class Budget(NamedTuple):
    """World and length of a race."""

    world: mw.WorldConfig
    turns: int
    """Turns of each team."""
    generations: int
    """Generations of DEAP's loop in a turn."""
    mu: int
    """Individuals of a population."""
    lambda_: int
    """Children in a generation."""
    met: int
    """Opponents of each player, the newest champion included."""
    response: int
    """Epochs of a best response."""


WORLD = mw.WorldConfig("O", rows=16, cols=16, n_pursuers=4, n_evaders=6, max_steps=100)
SMALL = mw.WorldConfig("O", rows=10, cols=10, n_pursuers=3, n_evaders=4, max_steps=40)
FULL = Budget(WORLD, turns=30, generations=4, mu=12, lambda_=24, met=8, response=500)
QUICK = Budget(SMALL, turns=4, generations=4, mu=6, lambda_=12, met=2, response=10)


class Fitness(base.Fitness):
    """One value that is maximized."""

    weights = (1.0,)


class Player:
    """A DEAP individual: any object with a fitness, here the weights of a network."""

    def __init__(self, genome: np.ndarray) -> None:
        self.genome = genome
        self.fitness = Fitness()


def mix(one: Player, two: Player, rng: np.random.Generator) -> tuple[Player, Player]:
    """Swap each gene with probability 1/2, in place (uniform crossover)."""
    swapped = rng.random(len(one.genome)) < 0.5
    one.genome[swapped], two.genome[swapped] = two.genome[swapped], one.genome[swapped]
    return one, two


def nudge(player: Player, rng: np.random.Generator) -> tuple[Player]:
    """Add Gaussian noise to all genes, in place."""
    player.genome += SIGMA * rng.standard_normal(len(player.genome), dtype=np.float32)
    return (player,)


def score(
    team: Team, world: mw.WorldConfig, own: np.ndarray, rivals: np.ndarray, seeds: np.ndarray
) -> np.ndarray:
    """Return the mean fitness (n,) of genomes (n, genes) over rivals (m, genes), seeds (n, m)."""
    network = mw.Network.for_config(world)
    learning, met = mw.Population(own, network), mw.Population(rivals, network)
    i, j = (axis.ravel() for axis in np.indices((len(own), len(rivals))))
    # The engine takes pursuers first, in the populations and in the matches.
    if team == "pursuer":
        sides, matches = (learning, met), mw.Matches.of(i, j, seeds.ravel())
    else:
        sides, matches = (met, learning), mw.Matches.of(j, i, seeds.ravel())
    statistics = mw.rollout(world, *sides, matches)
    values = statistics.captured_fraction
    if team == "evader":
        values = 1 - values - OVERLAP_PENALTY * statistics.evader_overlap
    return values.reshape(seeds.shape).mean(axis=1)


def toolbox_of(world: mw.WorldConfig, rng: np.random.Generator) -> base.Toolbox:
    """Return a toolbox with all operators that do not change from turn to turn."""
    network = mw.Network.for_config(world)
    toolbox = base.Toolbox()
    toolbox.register("individual", lambda: Player(network.initial(rng)))
    toolbox.register("population", tools.initRepeat, list, toolbox.individual)
    toolbox.register("mate", mix, rng=rng)
    toolbox.register("mutate", nudge, rng=rng)
    toolbox.register("select", tools.selBest)
    # DEAP maps the evaluation over individuals; here one call plays the matches of all of them.
    toolbox.register("map", lambda evaluate, players: evaluate(list(players)))
    return toolbox


def take_turn(
    team: Team,
    toolbox: base.Toolbox,
    population: list[Player],
    rivals: np.ndarray,
    budget: Budget,
    rng: np.random.Generator,
) -> tuple[list[Player], np.ndarray, dict[str, float]]:
    """Evolve one team while the other does not learn; return population, champion and record."""
    # One seed for each opponent: all players meet it in the same episode, so luck is shared.
    seeds = rng.integers(2**63, size=len(rivals))

    def evaluate(players: list[Player]) -> list[tuple[float]]:
        genomes = np.stack([player.genome for player in players])
        same = np.broadcast_to(seeds, (len(players), len(rivals)))
        return [(float(value),) for value in score(team, budget.world, genomes, rivals, same)]

    toolbox.register("evaluate", evaluate)
    statistics = tools.Statistics(lambda player: player.fitness.values[0])
    for name, number in {"mean": np.mean, "std": np.std, "max": np.max}.items():
        statistics.register(name, number)
    # DEAP compares individuals by ==, which a genome array answers element by element.
    best = tools.HallOfFame(1, similar=lambda a, b: np.array_equal(a.genome, b.genome))
    # Old fitness comes from other opponents; without it DEAP evaluates the parents again.
    for player in population:
        del player.fitness.values
    population, logbook = algorithms.eaMuPlusLambda(
        population, toolbox, budget.mu, budget.lambda_, cxpb=0.3, mutpb=0.7,
        ngen=budget.generations, stats=statistics, halloffame=best, verbose=False,
    )  # fmt: skip
    numbers = {name: round(float(n), 3) for name, n in statistics.compile(population).items()}
    # From DEAP's logbook: the parents once, then the children of each generation.
    played = sum(logbook.select("nevals")) * len(rivals)
    return population, best[0].genome, {"matches": played, **numbers}


def co_evolve(
    budget: Budget, rng: np.random.Generator
) -> tuple[dict[Team, np.ndarray], tools.Logbook]:
    """Return champions (turns + 1, genes) of both teams, untrained ones first, and a logbook."""
    toolboxes = {team: toolbox_of(budget.world, rng) for team in coevolution.TEAMS}
    populations = {team: box.population(n=budget.mu) for team, box in toolboxes.items()}
    champions = {team: [players[0].genome.copy()] for team, players in populations.items()}
    logbook = tools.Logbook()
    logbook.header = ["turn", *coevolution.TEAMS]
    for team in coevolution.TEAMS:
        logbook.chapters[team].header = ["matches", "mean", "std", "max"]
    for turn in range(1, budget.turns + 1):
        record = {}
        for team in coevolution.TEAMS:
            *past, newest = champions[other(team)]
            # The newest champion, and others at random: a small hall of fame against forgetting.
            drawn = rng.permutation(len(past))[: budget.met - 1]
            rivals = np.stack([newest, *(past[index] for index in drawn)])
            populations[team], champion, record[team] = take_turn(
                team, toolboxes[team], populations[team], rivals, budget, rng
            )
            champions[team].append(champion)
        logbook.record(turn=turn, **record)
    return {team: np.stack(genomes) for team, genomes in champions.items()}, logbook


def best_response(
    team: Team, rival: np.ndarray, budget: Budget, rng: np.random.Generator
) -> np.ndarray:
    """Evolve a response to one rival: an evolution strategy of matrixworld in a loop of DEAP."""
    network = mw.Network.for_config(budget.world)
    learner = coevolution.EvolutionStrategy(
        budget.lambda_, sigma=SIGMA, learning_rate=0.02, relative_sigma=0.0
    )
    start = coevolution.Task(
        seed=int(rng.integers(2**31)), team=coevolution.TEAMS.index(team), epochs=budget.response,
        untrained=network.initial, begin=None, game=coevolution.Pursuit(world=budget.world),
    )  # fmt: skip
    state = learner.start(start)

    def generate() -> list[Player]:
        nonlocal state
        candidates, state = learner.ask(state, rng)
        return [Player(genome) for genome in candidates]

    def evaluate(players: list[Player]) -> list[tuple[float]]:
        # Mirrored candidates share a match seed.
        seeds = rng.integers(2**63, size=budget.lambda_ // 2)[learner.seed_groups]
        genomes = np.stack([player.genome for player in players])
        values = score(team, budget.world, genomes, rival[np.newaxis], seeds[:, None])
        return [(float(value),) for value in values]

    def update(players: list[Player]) -> None:
        nonlocal state
        fitness = np.array([player.fitness.values[0] for player in players])
        state = learner.tell(state, coevolution.Results(fitness))

    toolbox = base.Toolbox()
    toolbox.register("generate", generate)
    toolbox.register("evaluate", evaluate)
    toolbox.register("map", lambda evaluate, players: evaluate(players))
    toolbox.register("update", update)
    algorithms.eaGenerateUpdate(toolbox, ngen=budget.response, verbose=False)
    return learner.genome(state)


def capture_rates(budget: Budget, pursuers: np.ndarray, evaders: np.ndarray) -> np.ndarray:
    """Return capture rates of all pairs, shape (pursuers, evaders)."""
    network = mw.Network.for_config(budget.world)
    teams = (mw.Population(genomes, network) for genomes in (pursuers, evaders))
    return coevolution.tournament(budget.world, *teams, seed=0, episodes=20).matrix


def main() -> None:
    """Co-evolve two populations, test the last champions, print and draw the results."""
    parser = script_parser(__doc__, quick="a small world and few turns")
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--figure", default="deap_example.png", help="file to draw to")
    args = parser.parse_args()
    budget = QUICK if args.quick else FULL
    random.seed(args.seed)  # the loops of DEAP use Python's global generator
    rng = np.random.default_rng(args.seed)
    champions, logbook = co_evolve(budget, rng)
    print(logbook)
    pursuers, evaders = champions["pursuer"], champions["evader"]
    hunter = best_response("pursuer", evaders[-1], budget, rng)
    escaper = best_response("evader", pursuers[-1], budget, rng)
    rates = capture_rates(
        budget, np.stack([pursuers[-1], hunter]), np.stack([evaders[-1], escaper])
    )
    print(f"\nBest responses, {budget.response * budget.lambda_:,} matches each:")
    print(f"the last pursuers capture {rates[0, 0]:.2f} of the last evaders;")
    print(f"a best response to these evaders captures {rates[1, 0]:.2f} of them;")
    print(f"the last pursuers capture {rates[0, 1]:.2f} of a best response to them.")
    payoff = capture_rates(budget, pursuers, evaders)
    plots.payoff_heatmap(payoff, title="Champions of every turn").savefig(args.figure)
    print(f"Drawn: {args.figure}")


if __name__ == "__main__":
    main()
