"""Learners of the package beside those of other libraries, by ask and tell over the same rollouts.

    python benchmarks/bench_learners.py --quick        learners of the package, some seconds
    python benchmarks/bench_learners.py                default settings of what is installed here
    python benchmarks/bench_learners.py --tune         50 trials (Optuna) for each algorithm
    python benchmarks/bench_learners.py --tuned        the best settings of these trials

The libraries exclude each other: call the script once in an environment of each library. All calls
share the folder of results, ``runs/learners``, in which a file holds one run. A run that is there
is not played again.

One team learns alone, from an untrained genome and with equal numbers of matches. Its fitness is
that of races (the overlap penalty included). The genome that an algorithm would return is scored in
fresh worlds after equal parts of the matches; the area is the mean height of that curve. All
algorithms start from the same genomes and are scored in the same worlds; those of other libraries
play all candidates of an epoch in one world.
"""

from __future__ import annotations

import json
import time
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from importlib.metadata import version
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import click
import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.integrate import trapezoid

import matrixworld as mw
from ask_and_tell import Algorithm, cma_es, default_es, es, evosax, evotorch, ga, pycma, unpaired_es
from matrixworld.analysis.intervals import expanded_tail
from matrixworld.coevolution import Team, held_out
from timing import print_table

SEEDS, MATCHES, PARTS, FRESH = 10, 3600, 6, 100
TRIALS, TUNING_SEED = 50, 1000
TUNING = {"matches": 900, "parts": 3, "fresh": 50}
COMPILING = 3
"""First epochs, in which libraries compile; their time is kept apart."""
RANGES = {"sigma": (0.02, 1.0), "rate": (0.002, 0.5)}
POPULATIONS = (8, 16, 24, 32, 48, 64, 96)
WEIGHT, HEAD = 0.05, 0.1
"""Standard deviations of untrained weights, as in races."""
PENALTY = 0.2
"""Of evaders that share a cell, as in races of O."""

ROUNDS = 150
RACE = mw.WorldConfig("O", max_steps=ROUNDS)
# Smaller where matches take long, and where untrained pursuers never surround anybody.
FIELD = mw.WorldConfig("O", rows=24, cols=24, n_pursuers=4, n_evaders=12, max_steps=ROUNDS)
CROWD = mw.WorldConfig("SB", rows=10, cols=10, n_pursuers=16, n_evaders=4, max_steps=60)


@dataclass(frozen=True)
class Task:
    """A team that learns in a world, against a script or a held-out genome, by its name.

    `span` has the fitness without learning and about the best area of a default, between which an
    area is measured where several tasks count together.
    """

    world: mw.WorldConfig
    team: Team
    opponent: str
    span: tuple[float, float]
    hidden: tuple[int, ...] = (32,)

    @property
    def network(self) -> mw.Network:
        return mw.Network.for_config(self.world, self.hidden)

    def play(self, genomes: NDArray[np.float32], seeds: ArrayLike) -> NDArray[np.float64]:
        """Return the fitness (n,) of genomes (n, genes) in one match each."""
        own, each = mw.Population(genomes, self.network), np.arange(len(genomes))
        evolved = self.opponent.startswith("evolved")
        rival = held_out("pursuer", "O")[self.opponent] if evolved else self.opponent
        if self.team == "pursuer":
            matches = mw.Matches.of(each, 0, seeds)
            scores = mw.rollout(self.world, own, rival, matches, threads=1)
        else:
            matches = mw.Matches.of(0, each, seeds)
            scores = mw.rollout(self.world, rival, own, matches, threads=1)
        fraction = scores.captured_fraction.mean(axis=1, dtype=np.float64)
        if self.team == "pursuer":
            return fraction
        return 1 - fraction - PENALTY * scores.evader_overlap.mean(axis=1, dtype=np.float64)


LARGE = {
    "pursuers, random": Task(RACE, "pursuer", "random", (0.18, 0.4)),
    "pursuers, clumsy-fleer": Task(FIELD, "pursuer", "clumsy-fleer", (0.02, 0.08)),
    "evaders, evolved-2": Task(RACE, "evader", "evolved-2", (0.55, 0.9)),
    "SB pursuers, random": Task(CROWD, "pursuer", "random", (0.01, 0.1)),
}
"""Networks of 11,813 genes."""
SMALL = {
    f"small {name}": replace(task, world=mw.WorldConfig.of(task.world, fov=5), hidden=())
    for name, task in LARGE.items()
    if task.opponent != "evolved-2"  # which has a view of 11 x 11
}
SMALL["small evaders, hunter"] = Task(
    mw.WorldConfig.of(RACE, fov=5), "evader", "hunter", (0.4, 0.6), ()
)
"""Views of 5 x 5 and no hidden layer: 380 genes, which have a covariance matrix."""


@dataclass(frozen=True)
class Entry:
    """An algorithm, its library, default settings, and tasks."""

    play: Algorithm
    library: str
    settings: Mapping[str, Any]
    tasks: Mapping[str, Task] = field(default_factory=lambda: LARGE)


SIZED, FREE = {"population": 48, "sigma": 0.1}, {"sigma": 0.1}
MOVED = {**SIZED, "rate": 0.02}
IN_RACES = {**SIZED, "rate": 0.03, "relative": 0.4}
ENTRIES = {
    "OpenAI-ES": Entry(es, "matrixworld", MOVED),
    "OpenAI-ES of races": Entry(es, "matrixworld", IN_RACES),
    "OpenAI-ES of a team alone": Entry(default_es, "matrixworld", {}),
    "GA of races": Entry(ga, "matrixworld", {"population": 48, "sigma": 0.05}),
    "GA of a team alone": Entry(ga, "matrixworld", {"population": 48, "sigma": 0.2}),
    "Open-ES (evosax)": Entry(evosax("Open_ES"), "evosax", MOVED),
    "LM-MA-ES (evosax)": Entry(evosax("LM_MA_ES"), "evosax", SIZED),
    "PGPE (EvoTorch)": Entry(evotorch("PGPE"), "evotorch", {**SIZED, "rate": 0.1 / 30}),
    "SNES (EvoTorch)": Entry(evotorch("SNES"), "evotorch", FREE),
    "Sep-CMA-ES (pycma)": Entry(pycma, "cma", FREE),
}
ON_SMALL = {
    "OpenAI-ES": Entry(es, "matrixworld", MOVED, SMALL),
    "CMA-ES": Entry(cma_es, "matrixworld", {"population": 48, "sigma": 0.8}, SMALL),
    "CMA-ES, narrower": Entry(cma_es, "matrixworld", SIZED, SMALL),
    "CMA-ES (evosax)": Entry(evosax("CMA_ES"), "evosax", SIZED, SMALL),
    "XNES (EvoTorch)": Entry(evotorch("XNES"), "evotorch", FREE, SMALL),
    "CMA-ES (pycma)": Entry(pycma, "cma", FREE, SMALL),
    "CMA-ES (pycma), wider": Entry(pycma, "cma", {"sigma": 0.8}, SMALL),
}
FAST = {"population": 24, "sigma": 0.3, "rate": 0.1}
SHARED = {
    "pairs share a world": Entry(es, "matrixworld", FAST),
    "a world for each candidate": Entry(es, "matrixworld", {**FAST, "worlds": "own"}),
    "one world for all": Entry(es, "matrixworld", {**FAST, "worlds": "one"}),
    "one world, no pairs, no table": Entry(unpaired_es, "matrixworld", FAST),
    "2 matches each": Entry(es, "matrixworld", {**FAST, "population": 12, "matches": 2}),
    "4 matches each": Entry(es, "matrixworld", {**FAST, "population": 6, "matches": 4}),
}
"""What candidates share, one change at a time, with steps from which they learn fast."""
GROUPS = {"large": ENTRIES, "small": ON_SMALL, "shared": SHARED}


# ---- A run -----------------------------------------------------------------------------------


class Run:
    """The matches of one run, its curve, and processor time without that of rollouts."""

    def __init__(self, task: Task, seed: int, matches: int, parts: int, fresh: int) -> None:
        self.task, self.team, self.seed, self.matches = task, task.team, seed, matches
        self.world, self.network = task.world, task.network
        self.played, self.epochs = 0, 0
        self.curve: list[tuple[int, float]] = []
        self.due, self.fresh = list(np.linspace(0, matches, parts + 1)), fresh
        self.in_rollouts, self.began, self.first = 0.0, time.process_time(), 0.0

    def untrained(self, count: int) -> NDArray[np.float32]:
        rng = np.random.default_rng([self.seed, 0])
        return np.stack([self.network.initial(rng, weight=WEIGHT, head=HEAD) for _ in range(count)])

    def goes_on(self, genome: ArrayLike) -> bool:
        if self.epochs == COMPILING:
            self.first = self.elsewhere()
        # The next epoch has the size of the last one, and would exceed the matches.
        each = self.played // self.epochs if self.epochs else 0
        over = self.played + each > self.matches
        if over or self.played >= self.due[0]:
            self.due = [part for part in self.due if part > self.played] or [np.inf]
            self.curve.append((self.played, self.score(genome)))
        return not over

    def score(self, genome: ArrayLike) -> float:
        """Return the mean fitness of a genome in fresh worlds."""
        copies = np.tile(np.asarray(genome, np.float32), (self.fresh, 1))
        return float(self.timed(copies, seeds(self.seed, 1, self.fresh)).mean())

    def fitness(self, candidates: ArrayLike, groups: ArrayLike = 0) -> NDArray[np.float64]:
        genomes = np.ascontiguousarray(candidates, dtype=np.float32)
        group = np.broadcast_to(groups, len(genomes))
        self.epochs, self.played = self.epochs + 1, self.played + len(genomes)
        return self.timed(genomes, seeds(self.seed, 1 + self.epochs, group.max() + 1)[group])

    def timed(self, genomes: NDArray[np.float32], at: NDArray[np.uint64]) -> NDArray[np.float64]:
        start = time.process_time()
        values = self.task.play(genomes, at)
        self.in_rollouts += time.process_time() - start
        return values

    def elsewhere(self) -> float:
        return time.process_time() - self.began - self.in_rollouts

    def result(self) -> dict[str, Any]:
        later = (self.elsewhere() - self.first) / max(self.epochs - COMPILING, 1)
        return {
            "curve": self.curve, "area": area(self.curve, self.matches), "epochs": self.epochs,
            "rollouts": self.in_rollouts, "first": self.first, "epoch": later,
        }  # fmt: skip


def seeds(*key: int) -> NDArray[np.uint64]:
    """Return the seeds of an epoch (last number: how many)."""
    return np.random.SeedSequence(key[:-1]).generate_state(key[-1], np.uint64)


def area(curve: Sequence[tuple[int, float]], matches: int) -> float:
    """Return the mean height of a curve from 0 to `matches`; after its end it stays as it is."""
    at, scores = np.array([*curve, (matches, curve[-1][1])], dtype=float).T
    return float(trapezoid(scores, at) / matches)


# ---- Many runs -------------------------------------------------------------------------------


@dataclass(frozen=True)
class Plan:
    """Where results are kept, and how much is played."""

    root: Path
    seeds: int
    matches: int
    parts: int
    fresh: int
    entries: Mapping[str, Mapping[str, Entry]]

    def missing(self) -> list[str]:
        """Return the libraries that are not installed here."""
        used = {each.library for entries in self.entries.values() for each in entries.values()}
        return sorted(name for name in used if find_spec(name) is None)

    def result(
        self,
        kind: str | None,
        group: str,
        name: str,
        task: str,
        seed: int,
        settings: Mapping[str, Any],
    ) -> dict[str, Any] | None:
        """Return the result of a run; play it if it is missing and its library is installed."""
        entry = self.entries[group][name]
        path = self.root / kind / group / slug(task) / f"{slug(name)}-{seed}.json"
        if not path.exists():
            if find_spec(entry.library) is None:
                return None
            run = Run(entry.tasks[task], seed, self.matches, self.parts, self.fresh)
            entry.play(run, **settings)
            found = {**run.result(), "settings": settings, "version": version_of(entry.library)}
            path.parent.mkdir(parents=True, exist_ok=True)
            new = path.with_suffix(".new")
            new.write_text(json.dumps(found))
            new.rename(path)
        found = json.loads(path.read_text())
        if found["settings"] != settings:
            raise click.ClickException(f"{path}: holds a run with other settings; remove it")
        return dict(found)

    def best(self, group: str, name: str) -> dict[str, Any] | None:
        """Return the best settings of the trials, None before they have been played."""
        path = self.root / "tuned" / group / f"{slug(name)}.json"
        return dict(json.loads(path.read_text())) if path.exists() else None

    def tune(self, group: str, name: str) -> None:
        """Look for settings that serve all tasks together, and keep the best."""
        import optuna

        entry = self.entries[group][name]

        def trial_score(trial: Any) -> float:
            size = trial.suggest_int("size", 0, len(POPULATIONS) - 1)
            settings = {"population": POPULATIONS[size]}
            for name, (low, high) in RANGES.items():
                if name in entry.settings:
                    settings[name] = trial.suggest_float(name, low, high, log=True)
            trial.set_user_attr("settings", settings)
            total = 0.0
            for task in entry.tasks.values():
                # Five seeds in turn: a setting that serves one of them is no use.
                seed = TUNING_SEED + trial.number % 5
                run = Run(task, seed, **TUNING)
                entry.play(run, **{**entry.settings, **settings})
                low, high = task.span
                total += (area(run.curve, run.matches) - low) / (high - low)
            return total / len(entry.tasks)

        optuna.logging.set_verbosity(optuna.logging.WARNING)
        sampler = optuna.samplers.TPESampler(seed=0)
        study = optuna.create_study(direction="maximize", sampler=sampler)
        study.optimize(trial_score, n_trials=TRIALS)
        path = self.root / "tuned" / group / f"{slug(name)}.json"
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(json.dumps(study.best_trial.user_attrs["settings"]))

    def runs(self, kind: str | None, group: str) -> dict[str, dict[str, list[dict[str, Any]]]]:
        """Return the results of all seeds by algorithm and task, of algorithms that have them."""
        found: dict[str, dict[str, list[dict[str, Any]]]] = {}
        for name, entry in self.entries[group].items():
            settings = entry.settings if kind == "default" else self.best(group, name)
            if settings is None:
                continue
            every = {
                task: [
                    self.result(kind, group, name, task, seed, {**entry.settings, **settings})
                    for seed in range(self.seeds)
                ]
                for task in entry.tasks
            }
            if all(run is not None for runs in every.values() for run in runs):
                found[name] = every
        return found


def slug(name: str) -> str:
    return name.replace(",", "").replace("(", "").replace(")", "").replace(" ", "-").lower()


def version_of(library: str) -> str:
    return f"{library} {mw.__version__ if library == 'matrixworld' else version(library)}"


# ---- Tables ----------------------------------------------------------------------------------


def interval(values: ArrayLike) -> tuple[float, float]:
    """Return the bootstrap interval of a mean over seeds (95 %).

    Percentiles are expanded: for 10 normal values the interval contains the mean in 95 of 100
    cases, that of plain percentiles in 90.
    """
    data = np.asarray(values, dtype=float)
    drawn = np.random.default_rng(0).choice(data, (9999, len(data))).mean(axis=1)
    tail = expanded_tail(len(data), 0.95)
    return tuple(np.quantile(drawn, [tail, 1 - tail]))


def areas(runs: Sequence[Mapping[str, Any]]) -> NDArray[np.float64]:
    return np.array([run["area"] for run in runs])


def written(value: object) -> str:
    return f"{value:.2g}" if isinstance(value, float) else str(value)


Found = Mapping[str, Mapping[str, list[dict[str, Any]]]]
"""Results of all seeds by algorithm and task."""


def print_areas(found: Found) -> None:
    """Print the mean areas; bold ones are not behind the best beyond the interval by seeds."""
    tasks = list(next(iter(found.values())))
    best = {
        task: max((areas(runs[task]) for runs in found.values()), key=np.mean) for task in tasks
    }
    rows = []
    for name, runs in found.items():
        cells = []
        for task in tasks:
            values = areas(runs[task])
            front = np.array_equal(values, best[task]) or interval(best[task] - values)[0] <= 0
            cells.append(shown(values, ".3f", "**" if front else ""))
        settings = runs[tasks[0]][0]["settings"]
        rows.append(
            (name, ", ".join(f"{key} {written(settings[key])}" for key in settings), *cells)
        )
    print_table(("area under the curve", "settings", *tasks), rows)


def print_differences(found: Found) -> None:
    """Print by how much the areas of the same seeds exceed those of the first algorithm."""
    first, *others = found
    rows = [
        (
            name,
            *(
                shown(areas(found[name][task]) - areas(runs), "+.3f")
                for task, runs in found[first].items()
            ),
        )
        for name in others
    ]
    print_table((f"area minus that of {first}", *found[first]), rows)


def shown(values: NDArray[np.float64], form: str, mark: str = "") -> str:
    low, high = interval(values)
    return f"{mark}{values.mean():{form}}{mark} [{low:{form}}, {high:{form}}]"


def print_curves(found: Found, matches: int) -> None:
    """Print the mean fitness after thirds of the matches, and the time besides rollouts."""
    tasks = list(next(iter(found.values())))
    rows = []
    for name, runs in found.items():
        cells = []
        for task in tasks:
            at = [matches / 3, 2 * matches / 3, matches]
            curves = [np.interp(at, *np.array(run["curve"]).T) for run in runs[task]]
            cells.append(" ".join(f"{value:.3f}" for value in np.mean(curves, axis=0)))
        every = [run for each in runs.values() for run in each]
        # Only the first run of a process compiles.
        per, first = np.median([run["epoch"] for run in every]), max(run["first"] for run in every)
        rollouts = np.mean([run["rollouts"] for run in every])
        times = (f"{1e3 * per:.1f}", f"{first:.2f}", f"{rollouts:.2f}")
        rows.append((name, every[0]["version"], *cells, *times))
    heads = ("ms an epoch", f"first {COMPILING} epochs, s", "rollouts, s")
    print_table(("fitness after thirds of the matches", "version", *tasks, *heads), rows)


@click.command()
@click.option("--results", default="runs/learners", type=Path, show_default=True)
@click.option("--quick", is_flag=True, help="few matches, and the learners of the package only")
@click.option("--tune", "kind", flag_value="tune", help="play the trials")
@click.option("--tuned", "kind", flag_value="tuned", help="the best settings of the trials")
@click.option("--group", multiple=True, type=click.Choice(list(GROUPS)), help="default: all")
@click.option("--only", multiple=True, help="algorithms; default: all")
def main(
    results: Path, quick: bool, kind: str | None, group: tuple[str, ...], only: tuple[str, ...]
) -> None:
    """Play what is missing and installed; print tables of what is there."""
    entries = {
        each: {
            name: entry
            for name, entry in GROUPS[each].items()
            if not (quick and entry.library != "matrixworld") and (not only or name in only)
        }
        for each in group or GROUPS
    }
    sizes = (results / "quick", 2, 96, 2, 2) if quick else (results, SEEDS, MATCHES, PARTS, FRESH)
    plan = Plan(*sizes, entries)
    for library in plan.missing():
        print(f"{library} is not installed here: only its results that are there are shown")
    for each in entries:
        if kind == "tune":
            for name, entry in entries[each].items():
                if find_spec(entry.library) and plan.best(each, name) is None:
                    plan.tune(each, name)
        elif found := plan.runs(kind or "default", each):
            print_areas(found)
            print_differences(found)
            print_curves(found, plan.matches)


if __name__ == "__main__":
    main()
