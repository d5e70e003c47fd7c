"""Trees of DEAP with a toolbox as in any program of DEAP: seekers copy the curves of hiders.

``pip install deap``. Tried with DEAP 1.4.4. `from_string` evaluates the text of a tree as Python,
so read only runs of people whom you trust.
"""

import numpy as np
from deap import base, gp, tools

import matrixworld as mw

primitives = gp.PrimitiveSet("MAIN", 1)
for function, arity in ((np.add, 2), (np.subtract, 2), (np.multiply, 2), (np.sin, 1)):
    primitives.addPrimitive(function, arity)
primitives.addTerminal(1.0)
primitives.renameArguments(ARG0="x")
toolbox = base.Toolbox()
toolbox.register("expr", gp.genHalfAndHalf, pset=primitives, min_=1, max_=3)
toolbox.register("individual", tools.initIterate, gp.PrimitiveTree, toolbox.expr)
toolbox.register("mate", gp.cxOnePoint)
toolbox.register("mutate", gp.mutUniform, expr=toolbox.expr, pset=primitives)
for name in ("mate", "mutate"):
    toolbox.decorate(name, gp.staticLimit(key=len, max_value=40))


def play(seeker, hider):
    """Return how near two curves are on [-1, 1]."""
    x = np.linspace(-1, 1, 21)
    one, other = (np.tanh(gp.compile(tree, primitives)(x)) for tree in (seeker, hider))
    return 1 - float(np.mean(abs(one - other))) / 2


text = {"write": str, "read": lambda text: gp.PrimitiveTree.from_string(text, primitives)}
operators = mw.coevolution.by_toolbox(toolbox)
trees = mw.Game(play, teams=("seekers", "hiders"), **operators, **text, deterministic=True)
if __name__ == "__main__":
    mw.check_game(trees)
    run = mw.evolve(game=trees, schedule="hall-of-fame", generations=8)
    print(mw.judge(run), *(run.genomes(team, -1) for team in trees.teams), sep="\n")
