"""How do programs evolve that one can read? DEAP alone: gp, tools, algorithms, on both sides.

    python evolution/readable.py             a minute; --quick: some seconds

A tree rates each move by named inputs of the cell that it leads to; an agent takes the best move.
Two lines tie DEAP to matrixworld: ``genome(str(tree))`` makes a tree playable, and ``toolbox.map``
receives the whole population, so that ``mw.rollout`` plays all matches in one call. The teams learn
in turns, against champions of earlier turns. In the end new matches choose among all champions:
what won few matches was often lucky. (Koza 1992, "Genetic Programming"; Luke & Panait 2002,
"Fighting bloat with nonparametric parsimony pressure".)
"""

from __future__ import annotations

import random
from functools import partial

import numpy as np
from deap import algorithms, base, gp, tools

import matrixworld as mw
from common import script_parser

TEAMS = ("pursuer", "evader")
WORLD = mw.WorldConfig("O", size=20, n_pursuers=4, n_evaders=4, obstacles=0.1, max_steps=100)
PROGRAM = mw.Program.for_config(WORLD)


class Fitness(base.Fitness):
    """Mean score over the matches; larger is better."""

    weights = (1.0,)


class Tree(gp.PrimitiveTree):
    """A program with a fitness."""

    def __init__(self, nodes):
        super().__init__(nodes)
        self.fitness = Fitness()


def primitives():
    """Return the operations and inputs of trees."""
    found = gp.PrimitiveSet("rating", len(PROGRAM.inputs))
    found.renameArguments(**{f"ARG{i}": name for i, name in enumerate(PROGRAM.inputs)})
    for name in ("add", "subtract", "multiply", "min", "max"):
        found.addPrimitive(max, 2, name=name)  # trees are played by the engine, not called
    found.addPrimitive(abs, 1, name="negate")
    found.addTerminal(1.0)
    return found


def play(team, trees, *, rivals, seeds):
    """Return the mean scores (n,) of trees against all rivals, in a match for each seed."""
    if not len(trees):  # no child of this generation is new
        return np.empty(0)
    both = [
        mw.Population(np.stack([PROGRAM.genome(str(tree)) for tree in side]), PROGRAM)
        for side in (trees, rivals)
    ]
    own, other, seed = (each.ravel() for each in np.indices((len(trees), len(rivals), len(seeds))))
    sides, numbers = (both, (own, other)) if team == "pursuer" else (both[::-1], (other, own))
    matches = mw.Matches.of(*numbers, np.asarray(seeds)[seed])
    caught = mw.rollout(WORLD, *sides, matches).captured_fraction.reshape(len(trees), -1)
    return caught.mean(axis=1) if team == "pursuer" else 1 - caught.mean(axis=1)


def toolbox_of(team, rivals, seeds):
    """Return the operators of one team, which meets these rivals."""
    toolbox, trees = base.Toolbox(), primitives()
    toolbox.register("expr", gp.genHalfAndHalf, pset=trees, min_=1, max_=3)
    toolbox.register("individual", tools.initIterate, Tree, toolbox.expr)
    toolbox.register("population", tools.initRepeat, list, toolbox.individual)
    toolbox.register("map", lambda evaluate, players: [(s,) for s in evaluate(players)])
    toolbox.register("evaluate", play, team, rivals=rivals, seeds=seeds)
    sizes = {"fitness_size": 4, "parsimony_size": 1.4, "fitness_first": True}
    toolbox.register("select", tools.selDoubleTournament, **sizes)
    toolbox.register("mate", gp.cxOnePoint)
    toolbox.register("mutate", gp.mutUniform, expr=partial(gp.genGrow, min_=0, max_=2), pset=trees)
    for name in ("mate", "mutate"):
        toolbox.decorate(name, gp.staticLimit(key=len, max_value=PROGRAM.length))
    return toolbox


def co_evolve(turns, generations, size):
    """Return the champions of both teams, one for each turn."""
    champions = {team: toolbox_of(team, [], []).population(1) for team in TEAMS}
    populations = {team: toolbox_of(team, [], []).population(size) for team in TEAMS}
    for turn in range(turns):
        for team, other in (TEAMS, TEAMS[::-1]):
            # The newest champion, and two of all.
            rivals = [champions[other][-1], *random.choices(champions[other], k=2)]
            seeds, best = range(8 * turn, 8 * turn + 8), tools.HallOfFame(1)
            toolbox = toolbox_of(team, rivals, seeds)
            for tree in populations[team]:
                del tree.fitness.values  # it comes from other rivals
            populations[team], _ = algorithms.eaSimple(
                populations[team], toolbox, 0.6, 0.3, generations, halloffame=best, verbose=False
            )
            champions[team].append(best[0])
    return champions


def main():
    """Evolve programs, and print those that do best in new matches, with their scores."""
    parser = script_parser(__doc__, quick="few and short turns", results=False)
    parser.add_argument("--seed", type=int, default=0)
    args = parser.parse_args()
    random.seed(args.seed)  # DEAP uses Python's global generator
    champions = co_evolve(*((3, 3, 20) if args.quick else (10, 8, 60)))
    for team, other in (TEAMS, TEAMS[::-1]):
        again = play(team, champions[team], rivals=champions[other], seeds=range(10**6, 10**6 + 16))
        genome = PROGRAM.genome(str(champions[team][np.argmax(again)]))
        score = mw.score_policy(mw.Population(genome, PROGRAM), team, WORLD, episodes=50)
        print(f"{team} ({score.means[0]:.2f}): {PROGRAM.expression(PROGRAM.simplified(genome))}")


if __name__ == "__main__":
    main()
