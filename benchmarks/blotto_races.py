"""One co-evolution of Colonel Blotto by several libraries, each as its user would write it.

Every race is a function of the `Work` and a seed, and returns the matches that it has played and a
plan of each team. The populations meet in random order. A child has two parents with probability
1/2, mutates always, and replaces its parents; two elites stay. evosax and pyribs optimize vectors
by operators of their own, so their candidates are decoded into plans.
"""

from __future__ import annotations

import random
import tempfile
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cache, partial
from typing import Any

import numpy as np

import matrixworld as mw
from blotto import FIELDS, Plan, Rng, decoded, initial, mate, mutate, play
from matrixworld import coevolution as co

ELITES, TOURNAMENT, CROSSOVER = 2, 4, 0.5
SPREAD = 0.2
"""Standard deviation of mutations of vectors."""


@dataclass(frozen=True)
class Work:
    """How long a race is: epochs are in stages, after each of which matrixworld saves a run."""

    size: int
    contemporaries: int
    stages: int
    epochs: int

    @property
    def generations(self) -> int:
        """Generations of both populations."""
        return self.stages * self.epochs

    @property
    def matches(self) -> int:
        """Matches of the race."""
        return self.generations * self.size * self.contemporaries


Race = Callable[[Work, int], tuple[int, tuple[Plan, Plan]]]


# ---- matrixworld -------------------------------------------------------------------------------


def new_game() -> mw.Game:
    return mw.Game(
        play,
        teams=("attackers", "defenders"),
        initial=initial,
        mutate=mutate,
        mate=mate,
        deterministic=True,
    )


GAME = new_game()  # a global variable, by which a run finds it


def settings_of(work: Work, seed: int) -> co.RaceSettings:
    return co.RaceSettings.of(
        {
            "schedule": "hall-of-fame",
            "schedule.generations": work.stages,
            "schedule.joint_epochs": work.epochs,
            "schedule.contemporaries": work.contemporaries,
            "schedule.hall_sample": 0,
            "learner.population": work.size,
            "learner.tournament": TOURNAMENT,
            "learner.elites": ELITES,
            "learner.crossover": CROSSOVER,
            "learner.mutation": 1.0,
        },
        game=GAME,
        seed=seed,
    )


def by_evolve(work: Work, seed: int) -> tuple[int, tuple[Plan, Plan]]:
    with tempfile.TemporaryDirectory() as out:
        run = mw.evolve(settings_of(work, seed), out, threads=1)
        matches = run.summary()["training_matches"]
        one, other = (run.genomes(team, -1) for team in GAME.teams)
    return matches, (one, other)


def by_train(work: Work, seed: int) -> tuple[int, tuple[Plan, Plan]]:
    race = co.train(co.Training(settings_of(work, seed), threads=1))
    one, other = (genomes[-1][0] for genomes in race.archive.values())
    read = GAME.operators["pursuer"].genome
    return race.counts["matches"], (read(one), read(other))


# ---- By hand -----------------------------------------------------------------------------------


def meet(
    ones: Sequence[Plan], others: Sequence[Plan], work: Work, rng: Rng
) -> tuple[list[float], list[float]]:
    """Return the mean score of each plan of both teams."""
    first, second = [0.0] * len(ones), [0.0] * len(others)
    for _ in range(work.contemporaries):
        for one, other in enumerate(rng.permutation(len(others)).tolist()):
            score = play(ones[one], others[other])
            first[one] += score / work.contemporaries
            second[other] += (1 - score) / work.contemporaries
    return first, second


def by_deap(work: Work, seed: int, *, lean: bool = False) -> tuple[int, tuple[Plan, Plan]]:
    from deap import base, tools

    class Fitness(base.Fitness):  # type: ignore[misc]
        weights = (1.0,)

    class Individual(list[int]):
        def __init__(self, plan: Plan) -> None:
            super().__init__(plan)
            self.fitness = Fitness()

    def child(one: Any, other: Any) -> Any:
        plan = toolbox.clone(one)
        if rng.random() < CROSSOVER:
            plan[:] = mate(plan, other, rng)
        return mutate(plan, rng)

    random.seed(seed)
    rng = np.random.default_rng(seed)
    toolbox = base.Toolbox()
    toolbox.register("select", tools.selTournament, tournsize=TOURNAMENT)
    if lean:  # in place of DEAP's own, a deep copy
        toolbox.register("clone", Individual)
    teams = [[Individual(initial(rng)) for _ in range(work.size)] for _ in range(2)]
    for generation in range(work.generations):
        if generation:
            for number, team in enumerate(teams):
                parents = toolbox.select(team, 2 * (work.size - ELITES))
                children = [child(*pair) for pair in zip(parents[::2], parents[1::2], strict=True)]
                teams[number] = tools.selBest(team, ELITES) + children
        for team, fitness in zip(teams, meet(teams[0], teams[1], work, rng), strict=True):
            for individual, value in zip(team, fitness, strict=True):
                individual.fitness.values = (value,)
    one, other = (list(tools.selBest(team, 1)[0]) for team in teams)
    return work.matches, (one, other)


# ---- LEAP --------------------------------------------------------------------------------------


def by_leap(work: Work, seed: int) -> tuple[int, tuple[Plan, Plan]]:
    from leap_ec import Individual, ops
    from leap_ec.problem import ConstantProblem
    from toolz import pipe

    class Mate(ops.Crossover):  # type: ignore[misc]
        def recombine(self, one: Any, other: Any) -> tuple[Any, Any]:
            plans = one.genome, other.genome
            one.genome, other.genome = mate(*plans, rng), mate(*plans, rng)
            return one, other

    @ops.iteriter_op  # type: ignore[untyped-decorator]
    def mutated(individuals: Any) -> Any:
        for individual in individuals:
            individual.genome = mutate(individual.genome, rng)
            yield individual

    random.seed(seed)
    np.random.seed(seed)  # noqa: NPY002, the generator of its crossover
    rng = np.random.default_rng(seed)
    problem = ConstantProblem(maximize=True)
    teams = [
        [Individual(initial(rng), problem=problem) for _ in range(work.size)] for _ in range(2)
    ]
    for generation in range(work.generations):
        if generation:
            for number, team in enumerate(teams):
                children = pipe(
                    team,
                    ops.tournament_selection(k=TOURNAMENT),
                    ops.clone,
                    Mate(persist_children=True, p_xover=CROSSOVER),
                    mutated,
                    ops.pool(size=work.size - ELITES),
                )
                teams[number] = ops.truncation_selection(team, size=ELITES) + children
        plans = [[individual.genome for individual in team] for team in teams]
        for team, fitness in zip(teams, meet(plans[0], plans[1], work, rng), strict=True):
            for individual, value in zip(team, fitness, strict=True):
                individual.fitness = value
    one, other = (max(team).genome for team in teams)
    return work.matches, (one, other)


# ---- modular-coevolution -----------------------------------------------------------------------


def by_modular(work: Work, seed: int) -> tuple[int, tuple[Plan, Plan]]:
    from modularcoevolution.agents.baseevolutionaryagent import BaseEvolutionaryAgent
    from modularcoevolution.generators.evolutiongenerator import EvolutionGenerator
    from modularcoevolution.genotypes.basegenotype import BaseGenotype
    from modularcoevolution.managers.baseevolutionmanager import EvolutionEndedException
    from modularcoevolution.managers.coevolution import Coevolution

    class Soldiers(BaseGenotype):  # type: ignore[misc]
        def __init__(self, parameters: dict[str, Any]) -> None:
            super().__init__(parameters)
            self.plan = parameters.get("plan") or initial(rng)

        def mutate(self) -> None:
            self.plan = mutate(self.plan, rng)

        def recombine(self, donor: Any) -> None:
            if rng.random() < CROSSOVER:
                self.plan = mate(self.plan, donor.plan, rng)

        def clone(self) -> Any:
            return Soldiers({"plan": [*self.plan]})

        def __hash__(self) -> int:
            return hash(tuple(self.plan))

        def get_raw_genotype(self) -> dict[str, Any]:
            return {"plan": self.plan}

        def diversity_function(self, population: Any, *options: Any) -> float:
            return 0.0

    class Commander(BaseEvolutionaryAgent):  # type: ignore[misc]
        @classmethod
        def genotype_class(cls) -> Any:
            return Soldiers

        @classmethod
        def genotype_default_parameters(cls, agent_parameters: Any = None) -> dict[str, Any]:
            return {}

        def apply_parameters(self, parameters: dict[str, Any]) -> None:
            pass

        def get_parameters(self) -> dict[str, Any]:
            return {}

        def perform_action(self) -> Plan:
            plan: Plan = self.genotype.plan
            return plan

    random.seed(seed)
    rng = np.random.default_rng(seed)
    fitness = {
        "name": "fitness",
        "is_objective": True,
        "repeat_mode": "average",
        "log_history": False,
        "log_opponents": False,
        "automatic": True,
        "add_fitness_modifier": False,
    }
    teams = [
        EvolutionGenerator(
            Commander,
            name,
            initial_size=work.size // 2,  # the parents, of which the better half stays
            children_size=work.size - work.size // 2,
            mutation_fraction=1.0,
            tournament_size=TOURNAMENT,
            population_log_size=0,
        )
        for name in GAME.teams
    ]
    for team in teams:
        team.register_metric(fitness, "score")
    race = Coevolution(teams, (0, 1), work.generations, work.contemporaries)
    matches = 0
    while True:
        for number in race.get_remaining_evaluations():
            one, other = race.get_genotype_group(number)
            score = play(one.plan, other.plan)
            results = {one.id: {"score": score}, other.id: {"score": 1 - score}}
            race.submit_evaluation(number, results)
            matches += 1
        try:
            race.next_generation()
        except EvolutionEndedException:
            return matches, (teams[0].population[0].plan, teams[1].population[0].plan)


# ---- evosax ------------------------------------------------------------------------------------


@cache  # each object is compiled anew
def simple_ga(size: int) -> Any:
    import optax
    from evosax.algorithms import SimpleGA

    narrow = optax.constant_schedule(SPREAD)
    return SimpleGA(size, np.zeros(FIELDS, np.float32), std_schedule=narrow)


def by_evosax(work: Work, seed: int) -> tuple[int, tuple[Plan, Plan]]:
    import jax

    rng = np.random.default_rng(seed)
    ga = simple_ga(work.size)
    params = ga.default_params.replace(crossover_rate=CROSSOVER)
    keys = jax.random.split(jax.random.key(seed), (work.generations, 2, 2))
    teams = [rng.standard_normal((work.size, FIELDS), np.float32) for _ in range(2)]
    states: list[Any] = [None, None]
    for generation in range(work.generations):
        if generation:
            for team, (key, _) in enumerate(keys[generation]):
                teams[team], states[team] = ga.ask(key, states[team], params)
        plans = [decoded(vectors) for vectors in teams]
        for team, fitness in enumerate(meet(plans[0], plans[1], work, rng)):
            losses, key = -np.array(fitness, np.float32), keys[generation, team, 1]
            if generation:
                states[team], _ = ga.tell(key, teams[team], losses, states[team], params)
            else:
                states[team] = ga.init(key, teams[team], losses, params)
    one, other = (decoded([ga.get_best_solution(state)])[0] for state in states)
    return work.matches, (one, other)


# ---- pyribs ------------------------------------------------------------------------------------


def by_pyribs(work: Work, seed: int) -> tuple[int, tuple[Plan, Plan]]:
    from ribs.archives import GridArchive
    from ribs.emitters import GaussianEmitter
    from ribs.schedulers import Scheduler

    rng = np.random.default_rng(seed)
    archives, teams = [], []
    for number in range(2):
        archive = GridArchive(
            solution_dim=FIELDS, dims=(10, 10), ranges=((0, 100), (0, 100)), seed=seed + number
        )
        emitter = GaussianEmitter(
            archive, sigma=SPREAD, x0=np.zeros(FIELDS), batch_size=work.size, seed=seed + number
        )
        archives.append(archive)
        teams.append(Scheduler(archive, [emitter]))
    for _ in range(work.generations):
        plans = [decoded(team.ask()) for team in teams]
        for number, fitness in enumerate(meet(plans[0], plans[1], work, rng)):
            # What the archive keeps apart: the largest field, and the soldiers of the first half.
            measures = [(max(plan), sum(plan[: FIELDS // 2])) for plan in plans[number]]
            teams[number].tell(fitness, measures)
    one, other = (decoded([archive.best_elite["solution"]])[0] for archive in archives)
    return work.matches, (one, other)


# ---- Who they are ------------------------------------------------------------------------------


@dataclass(frozen=True)
class Library:
    """A race, its package on the index, what its user has written, and what one gets.

    "by hand" is what the user would have to write.
    """

    race: Race
    package: str
    written: tuple[Callable[..., Any], ...]
    resumes: str = "by hand"
    judgement: str = "no"
    page: str = "no"
    files: str = "by hand"


LIBRARIES = {
    "DEAP by hand": Library(by_deap, "deap", (by_deap, meet)),
    "DEAP by hand, shallow copies": Library(partial(by_deap, lean=True), "deap", (by_deap, meet)),
    "matrixworld, files and log": Library(
        by_evolve, "matrixworld", (new_game, settings_of, by_evolve), "yes", "yes", "yes", "yes"
    ),
    "matrixworld in memory": Library(
        by_train, "matrixworld", (new_game, settings_of, by_train), "no", "no", "no", "no"
    ),
    "LEAP": Library(by_leap, "leap_ec", (by_leap, meet), files="yes"),
    "modular-coevolution": Library(by_modular, "modular-coevolution", (by_modular,), files="yes"),
    "evosax": Library(by_evosax, "evosax", (simple_ga, by_evosax, meet)),
    "pyribs": Library(by_pyribs, "ribs", (by_pyribs, meet)),
}
