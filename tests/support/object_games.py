"""Games whose genomes are objects, as users write them: lists, words, trees of DEAP."""

import operator

import numpy as np
from deap import base, gp, tools

from matrixworld.coevolution import Game, by_toolbox

# Networks of comparators against cases to be sorted (Hillis 1990), each with operators of its own.

WIRES, CASES = 4, 3


def network(rng):
    return [pair(rng) for _ in range(rng.integers(1, 7))]


def pair(rng):
    return sorted(rng.choice(WIRES, 2, replace=False).tolist())


def cases(rng):
    return [rng.permutation(WIRES).tolist() for _ in range(CASES)]


def change(net, rng):
    net[rng.integers(len(net))] = pair(rng)
    return net


def swap(tests, rng):
    (i, j), case = pair(rng), tests[rng.integers(CASES)]
    case[i], case[j] = case[j], case[i]
    return tests


def cross(one, other, rng):
    at = rng.integers(1, 4)
    return one[:at] + other[at:]


def sort(net, tests):
    """Return the share of the cases that a network sorts."""
    done = 0
    for case in tests:
        line = case[:]
        for i, j in net:
            if line[i] > line[j]:
                line[i], line[j] = line[j], line[i]
        done += line == sorted(line)
    return done / CASES


sorting = Game(
    sort,
    teams=("sorters", "tests"),
    initial=(network, cases),
    mutate=(change, swap),
    mate=(cross, None),
    deterministic=True,
)

# Words, by chance.


def word(rng):
    return "".join(rng.choice([*"aé日"], rng.integers(1, 6)))


def other_letter(text, rng):
    at = rng.integers(len(text))
    return text[:at] + str(rng.choice([*"aé日"])) + text[at + 1 :]


def guess(one, other, rng):
    """Return 1 if two letters that are drawn are equal."""
    return float(one[rng.integers(len(one))] == other[rng.integers(len(other))])


guessing = Game(
    guess, teams=("seekers", "hiders"), initial=word, mutate=other_letter, write=str, read=str
)


def guess_all(ones, others, seeds):
    return [
        float(one[0] == other[0] or seed % 3 == 0)
        for one, other, seed in zip(ones, others, seeds, strict=True)
    ]


guessing_at_once = Game(
    guess_all, teams=("seekers", "hiders"), initial=word, mutate=other_letter, many=True
)

# Trees, by a toolbox as in the documentation of DEAP.

primitives = gp.PrimitiveSet("MAIN", 1)
for function, arity in ((np.add, 2), (np.multiply, 2), (np.sin, 1)):
    primitives.addPrimitive(function, arity)
primitives.addTerminal(1.0)
toolbox = base.Toolbox()
toolbox.register("expr", gp.genHalfAndHalf, pset=primitives, min_=1, max_=3)
toolbox.register("individual", tools.initIterate, gp.PrimitiveTree, toolbox.expr)
toolbox.register("mate", gp.cxOnePoint)
toolbox.register("expr_mut", gp.genFull, min_=0, max_=2)
toolbox.register("mutate", gp.mutUniform, expr=toolbox.expr_mut, pset=primitives)
for name in ("mate", "mutate"):
    toolbox.decorate(name, gp.staticLimit(key=operator.attrgetter("height"), max_value=4))
X = np.linspace(-1, 1, 5)


def near(seeker, hider):
    one, other = (np.tanh(gp.compile(tree, primitives)(X)) for tree in (seeker, hider))
    return float(1 - np.mean(abs(one - other)) / 2)


trees = Game(
    near,
    teams=("seekers", "hiders"),
    **by_toolbox(toolbox),
    write=str,
    read=lambda text: gp.PrimitiveTree.from_string(text, primitives),
    deterministic=True,
)
