"""Wall time of a race by part: rollouts, and everything else.

    python benchmarks/bench_evolve.py [--generations 3] [--learner es] [--threads 2]

The benchmark plays races of the default settings as `matrixworld evolve` does, including payoff
matrix and figures. The process is bound to two cores if the system supports it. Functions of the
package are wrapped to time them. The default races are short, so work that is done once in a race
has a larger share than in a race of 30 generations. Before the measurement, a short race is played
with and without the wrappers; both must give the same bytes.
"""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping
from contextlib import contextmanager, redirect_stderr, redirect_stdout
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import click

from matrixworld import Matches, Population, _core
from matrixworld.cli.evolve import play_runs, report
from matrixworld.coevolution import (
    EvolutionStrategy,
    GeneticAlgorithm,
    Race,
    RaceSettings,
)
from matrixworld.coevolution.jobs import job_of
from matrixworld.coevolution.runs import run
from matrixworld.coevolution.runs.training_matches import TrainingMatches
from matrixworld.coevolution.storage import RunWriter
from parts import Functions, Parts
from timing import bind, print_table

LEARNERS = {"es": "evolution strategy", "ga": "genetic algorithm"}
SCHEDULES = ("specialist-specialist", "generalist-generalist")
# The files that hold what a race has computed.
RESULTS = ("pursuers.npy", "evaders.npy", "payoff.npz", "log.csv")

PARTS: dict[str, Functions] = {
    "rollouts": [(_core, "rollout")],
    "seeds and matches": [
        (run, "training_seeds"),
        (run, "keyed_generator"),
        (Matches, "of"),
    ],
    "ask: variation": [(EvolutionStrategy, "ask"), (GeneticAlgorithm, "ask")],
    "tell: selection and update": [(EvolutionStrategy, "tell"), (GeneticAlgorithm, "tell")],
    "validation": [(Population, "__post_init__")],
    "fitness and log": [(TrainingMatches, "fitness_of_epoch")],
    "checkpoints and disk": [
        (Race, "_save"),
        (Race, "_restore"),
        (RunWriter, "save_results"),
    ],
    "payoff matrix": [(Race, "evaluate"), (Race, "summary")],
}
FIGURES, OTHER = "figures and report", "other"


@contextmanager
def silence() -> Iterator[None]:
    """Discard everything that is printed."""
    with open(os.devnull, "w") as nowhere, redirect_stdout(nowhere), redirect_stderr(nowhere):
        yield


def race(settings: RaceSettings, threads: int, parts: Parts) -> dict[str, bytes]:
    """Play a race as the command line does, and return the bytes of its result files."""
    with TemporaryDirectory() as directory, silence():
        root = Path(directory)
        with parts.timed(OTHER):
            job = job_of(settings)
            [result], _ = play_runs(job, root, threads, new=True)
        with parts.timed(FIGURES):
            report(job, [result], root, {})
        return {name: (result.path / name).read_bytes() for name in RESULTS}


def check(learner: str, threads: int) -> None:
    """Check that the wrappers do not change the results."""
    settings = RaceSettings.of(
        {
            "learner": learner,
            "schedule.generations": 2,
            "schedule.pursuer_epochs": 2,
            "schedule.evader_epochs": 2,
        }
    )
    plain, parts = race(settings, threads, Parts()), Parts()
    with parts.wrapping(PARTS):
        assert race(settings, threads, parts) == plain
    # A part without time is a function that the package no longer calls.
    assert set(parts.seconds) == {*PARTS, FIGURES, OTHER}


def measure(settings: RaceSettings, threads: int) -> Mapping[str, float]:
    """Return the seconds of a race by part."""
    # Parts and total come from the same run, so the shares add up to 100 %.
    parts = Parts()
    with parts.wrapping(PARTS):
        race(settings, threads, parts)
    return parts.seconds


def print_shares(learner: str, seconds: Mapping[str, Mapping[str, float]]) -> None:
    """Print the seconds by part and race, as percentages of the total."""
    whole = {name: sum(parts.values()) for name, parts in seconds.items()}
    rows: list[tuple[Any, ...]] = [
        (part, *(f"{100 * parts[part] / whole[name]:.1f}" for name, parts in seconds.items()))
        for part in (*PARTS, FIGURES, OTHER)
    ]
    rows.append(("total seconds", *(f"{total:.1f}" for total in whole.values())))
    print_table((f"{LEARNERS[learner]}, % of wall time", *seconds), rows)


@click.command()
@click.option(
    "--learner",
    "learners",
    type=click.Choice(list(LEARNERS)),
    multiple=True,
    default=list(LEARNERS),
    show_default=True,
    help="may be given several times",
)
@click.option("--generations", default=3, show_default=True, help="generations of a race")
@click.option("--epochs", type=int, help="epochs of each team in a generation")
@click.option("--threads", default=2, show_default=True, help="threads of the rollouts")
def main(learners: tuple[str, ...], generations: int, epochs: int | None, threads: int) -> None:
    """Print a table in Markdown for each learner."""
    bind(threads)
    changes: dict[str, Any] = {"schedule.generations": generations}
    if epochs is not None:
        changes |= {"schedule.pursuer_epochs": epochs, "schedule.evader_epochs": epochs}
    for learner in learners:
        check(learner, threads)
        settings = {
            name: RaceSettings.of({"schedule": name, "learner": learner, **changes})
            for name in SCHEDULES
        }
        print_shares(learner, {name: measure(each, threads) for name, each in settings.items()})


if __name__ == "__main__":
    main()
