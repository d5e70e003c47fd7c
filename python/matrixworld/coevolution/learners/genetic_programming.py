"""Genetic programming: trees of DEAP over named inputs, which rate the moves of an agent.

A genome is the code of a program (see `matrixworld.Program`). Trees, their types and their nodes
are those of `deap.gp`; the operators take an explicit generator, where DEAP's own draw from
Python's global `random`.
"""

from __future__ import annotations

import json
from functools import lru_cache
from typing import Any, ClassVar, TypeAlias

import numpy as np
from deap import gp

from matrixworld.coevolution.learners import learner
from matrixworld.coevolution.learners.learner import fittest, select_tournament
from matrixworld.coevolution.pursuit import OPERATIONS, Program, policy_of
from matrixworld.coevolution.sections import section, setting
from matrixworld.coevolution.types import FloatArray, Genome, Genomes, Indices, Rng, State

Tree: TypeAlias = gp.PrimitiveTree

DEPTH = 2  # most operations one inside the other in a part that is drawn


@lru_cache(maxsize=8)
def primitives_of(policy: Program) -> gp.PrimitiveSetTyped:
    """Return the typed primitives of programs: operations, and inputs by name.

    A comparison is a bool, which only the first argument of ``where`` takes.
    """
    primitives = gp.PrimitiveSetTyped("rating", [float] * len(policy.inputs), float)
    primitives.renameArguments(**{f"ARG{i}": name for i, name in enumerate(policy.inputs)})
    for name, arguments in OPERATIONS.items():
        kinds: list[type] = [float] * arguments
        if name == "where":
            kinds[0] = bool
        primitives.addPrimitive(None, kinds, bool if name == "less" else float, name=name)
    return primitives


def tree_of(policy: Program, genome: Genome) -> Tree:
    """Return a genome as a tree. A number that is tested becomes a comparison, and the reverse."""
    named = primitives_of(policy).mapping
    stack: list[list[Any]] = []
    for token in policy.tokens(genome):
        if isinstance(token, float):
            stack.append([_number(token)])
            continue
        first = len(stack) - OPERATIONS.get(token, 0)
        kinds = getattr(named[token], "args", [])
        parts = [_typed(p, k, named) for p, k in zip(stack[first:], kinds, strict=True)]
        stack[first:] = [[named[token], *(node for part in parts for node in part)]]
    return Tree(_typed(stack[0], float, named))


def _typed(part: list[Any], kind: type, named: dict[str, Any]) -> list[Any]:
    """Return the nodes of a part of a tree as those of a type: ``a > 0`` is ``0 < a``."""
    if part[0].ret is kind:
        return part
    if kind is bool:
        return [named["less"], _number(0.0), *part]
    return [named["where"], *part, _number(1.0), _number(0.0)]


def _number(value: float) -> gp.Terminal:
    return gp.Terminal(float(np.float32(value)), False, float)


def place_in(tree: Tree, rng: Rng, kind: type | None = None) -> int | None:
    """Return a random node of a tree, of a type if one is given; None without any."""
    places = [i for i, node in enumerate(tree) if kind is None or node.ret is kind]
    return places[rng.integers(len(places))] if places else None


def mate(tree: Tree, other: Tree, rng: Rng) -> Tree:
    """Return a tree of which a part is replaced by a part of the same type of another tree."""
    place = place_in(tree, rng)
    assert place is not None
    source = place_in(other, rng, tree[place].ret)
    if source is None:
        return tree
    child = Tree(tree)
    child[tree.searchSubtree(place)] = other[other.searchSubtree(source)]
    return child


def mutate(policy: Program, tree: Tree, rng: Rng) -> Tree:
    """Return a tree with one change: a part, a node or a number."""
    # A part is drawn anew or replaced by a part of itself, a node by another one with the same
    # arguments, or a number is moved.
    primitives, child = primitives_of(policy), Tree(tree)
    place = place_in(tree, rng)
    assert place is not None
    node, part = tree[place], tree.searchSubtree(place)
    way = rng.integers(4)
    if way == 0:
        drawn = tree_of(policy, policy.initial(rng, DEPTH))
        child[part] = _typed(drawn, node.ret, primitives.mapping)
    elif way == 1:
        inner = Tree(tree[part])
        source = place_in(inner, rng, node.ret)
        assert source is not None  # at least the part itself
        child[part] = inner[inner.searchSubtree(source)]
    elif way == 2 and isinstance(node, gp.Primitive):
        same = [p for p in primitives.primitives[node.ret] if p.args == node.args]
        child[place] = same[rng.integers(len(same))]
    elif isinstance(node, gp.Terminal):
        if isinstance(node.value, float):
            child[place] = _number(round(node.value + rng.normal(0.0, 0.5), 2))
        else:
            [child[place]] = tree_of(policy, policy.initial(rng, 0))
    return child


def select_twice(
    fitness: FloatArray, sizes: Indices, k: int, rng: Rng, *, size: int, parsimony: float
) -> Indices:
    """Return k parents by double tournament: Luke & Panait 2002, "Fighting bloat", PPSN VII.

    Of two winners by fitness the shorter one is taken with the probability `parsimony`.
    """
    pairs = np.stack([select_tournament(fitness, k, rng, size=size) for _ in range(2)])
    pairs = np.take_along_axis(pairs, np.argsort(sizes[pairs], axis=0, kind="stable"), axis=0)
    longer = (rng.random(k) >= parsimony).astype(int)
    chosen: Indices = pairs[longer, np.arange(k)]
    return chosen


@section
class GeneticProgramming(learner.Generational):
    """Genetic programming of rating programs.

    ::

        population = random trees
        in each epoch:
            scored
            next = the fittest, kept; then children: a part of a parent is replaced by a part of
                   another one, or changed at random; parents by double tournament

    Koza 1992, "Genetic Programming". Montana 1995, "Strongly typed genetic programming",
    Evolutionary Computation 3(2).
    """

    kind: ClassVar[str] = "gp"
    policies: ClassVar[tuple[str, ...]] = ("program",)
    any_game: ClassVar[bool] = False

    tournament: int = setting(4, "individuals in a tournament by fitness", least=1)
    parsimony: float = setting(
        0.5,
        "probability that the shorter one of two winners becomes a parent; 0.5: length does not "
        "matter",
        most=1.0,
    )
    crossover: float = setting(0.6, "share of children with a part of another parent", most=1.0)
    elites: int = setting(2, "fittest individuals kept unchanged")

    def start(self, task: learner.Task) -> State:
        """Return a population that nobody has scored yet."""
        policy: Any = getattr(task.game, "policy", None)
        population = learner.unscored(task.genomes(self.population))
        return {**population, "policy": np.array(json.dumps(policy.to_json()))}

    def genome(self, state: State) -> Genome:
        """Return the champion of the last scored population, simplified."""
        policy: Any = policy_of(json.loads(str(state["policy"])))
        genome: Genome = policy.simplified(super().genome(state))
        return genome

    def offspring(self, state: State, rng: Rng) -> Genomes:
        """Return the next population: the elites unchanged, and then children."""
        population, fitness = state["population"], state["fitness"]
        policy: Any = policy_of(json.loads(str(state["policy"])))
        trees = [tree_of(policy, genome) for genome in population]
        count = len(population) - self.elites
        parents, mates = (
            select_twice(
                fitness, np.array([*map(len, trees)]), count, rng,
                size=self.tournament, parsimony=self.parsimony,
            )
            for _ in range(2)
        )  # fmt: skip
        children = []
        for parent, other in zip(parents, mates, strict=True):
            if rng.random() < self.crossover:
                child = mate(trees[parent], trees[other], rng)
            else:
                child = mutate(policy, trees[parent], rng)
            # A child that is too long is its parent.
            fits = len(child) <= policy.length
            children.append(policy.genome(str(child)) if fits else population[parent])
        offspring: Genomes = np.stack([*population[fittest(fitness, self.elites)], *children])
        return offspring
