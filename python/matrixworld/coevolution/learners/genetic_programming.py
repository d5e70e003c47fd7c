"""Genetic programming: trees of DEAP over named inputs, which rate the moves of an agent.

A genome is the code of a program (see `matrixworld.Program`). Trees, their types and their nodes
are those of `deap.gp`; the operators take an explicit generator, where DEAP's own draw from
Python's global `random`.
"""

from __future__ import annotations

import json
from functools import lru_cache, partial
from typing import Any, ClassVar, NamedTuple, TypeAlias

import numpy as np
from deap import gp
from numpy.typing import NDArray

from matrixworld._util.constraints import Range, Whole
from matrixworld._util.sections import section, setting
from matrixworld.coevolution.games.pursuit import OPERATIONS, Program, Pursuit, policy_of
from matrixworld.coevolution.learners.generational import Generational, unscored
from matrixworld.coevolution.learners.learner import Task
from matrixworld.coevolution.learners.selection import fittest, select_tournament
from matrixworld.coevolution.types import TEAMS, FloatArray, Genome, Genomes, Indices, Rng

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
    """Return a tree after one mutation, which may leave it as it is.

    At a random node, in one of four ways: a new part is drawn; a part of the part replaces it; the
    node alone is changed; or it is changed unless it is an operation.
    """
    place = place_in(tree, rng)
    assert place is not None
    node = tree[place]
    part = tree.searchSubtree(place)
    child = Tree(tree)
    way = rng.integers(4)
    if way == 0:
        child[part] = _drawn_part(policy, node.ret, rng)
    elif way == 1:
        child[part] = _inner_part(Tree(tree[part]), rng)
    elif isinstance(node, gp.Terminal):  # two ways of four
        child[place] = _changed_terminal(policy, node, rng)
    elif way == 2:
        child[place] = _other_operation(policy, node, rng)
    return child


def _drawn_part(policy: Program, kind: type, rng: Rng) -> list[Any]:
    """Return the nodes of a new part of a type."""
    drawn = tree_of(policy, policy.initial(rng, DEPTH))
    return _typed(drawn, kind, primitives_of(policy).mapping)


def _inner_part(part: Tree, rng: Rng) -> list[Any]:
    """Return the nodes of a random part of a part, of the same type; it may be the part itself."""
    place = place_in(part, rng, part[0].ret)
    assert place is not None
    nodes: list[Any] = part[part.searchSubtree(place)]
    return nodes


def _changed_terminal(policy: Program, node: gp.Terminal, rng: Rng) -> gp.Terminal:
    """Return a number near that of a node, or in place of an input a new input or number."""
    if isinstance(node.value, float):
        return _number(round(node.value + rng.normal(0.0, 0.5), 2))
    [terminal] = tree_of(policy, policy.initial(rng, 0))
    return terminal


def _other_operation(policy: Program, node: gp.Primitive, rng: Rng) -> gp.Primitive:
    """Return a random operation with the types of a node; it may be the same one."""
    operations = primitives_of(policy).primitives[node.ret]
    same = [operation for operation in operations if operation.args == node.args]
    return same[rng.integers(len(same))]


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


class State(NamedTuple):
    """A population of programs and its fitness; that of a new one is empty."""

    population: Genomes
    fitness: FloatArray
    champion: NDArray[np.intp]
    policy: NDArray[np.str_]  # whose programs they are, as JSON
    candidates: Genomes | None = None


def _policy_in(state: State) -> Program:
    """Return the policy whose programs a state holds."""
    policy = policy_of(json.loads(str(state.policy)))
    assert isinstance(policy, Program)  # as written by `start`
    return policy


@section("gp")
class GeneticProgramming(Generational):
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

    policies: ClassVar[tuple[str, ...]] = ("program",)
    any_game: ClassVar[bool] = False

    tournament: int = setting(4, "individuals in a tournament by fitness", Whole(1))
    parsimony: float = setting(
        0.5,
        "probability that the shorter one of two winners becomes a parent; 0.5: length does not "
        "matter",
        Range(most=1.0),
    )
    crossover: float = setting(
        0.6, "share of children with a part of another parent", Range(most=1.0)
    )

    def start(self, task: Task) -> State:
        """Return a population that nobody has scored yet."""
        assert isinstance(task.game, Pursuit)  # as its `any_game` says
        policy = np.array(json.dumps(task.game.policies[TEAMS[task.team]].to_json()))
        return State(**unscored(task.genomes(self.population)), policy=policy)

    def genome(self, state: State) -> Genome:
        """Return the champion of the last scored population, simplified."""
        return _policy_in(state).simplified(super().genome(state))

    def offspring(self, state: State, rng: Rng) -> Genomes:
        """Return the next population: the elites unchanged, and then children."""
        population = state.population
        fitness = state.fitness
        policy = _policy_in(state)
        trees = [tree_of(policy, genome) for genome in population]
        count = len(population) - self.elites
        sizes = np.array([len(tree) for tree in trees])
        select = partial(
            select_twice, fitness, sizes, count, rng, size=self.tournament, parsimony=self.parsimony
        )
        parents = select()
        mates = select()
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
