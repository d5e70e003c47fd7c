"""Where the time of the main job goes: rollouts, and everything else.

    python benchmarks/bench_evolve.py [--generations 3] [--learner es] [--threads 2]

Plays races of the default settings as `matrixworld evolve` does, payoff matrix and figures
included, on two cores, to which the process binds itself where the system can. Functions of the
package are timed by wrapping them. The races are short unless told otherwise: what happens once a
race weighs more in them than in one of 30 generations. Before anything is timed, a short race is
played with the wrappers and without, and must end with the same bytes.
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
from matrixworld.cli.jobs import create_runs, play_runs
from matrixworld.cli.report import report
from matrixworld.coevolution import (
    EvolutionStrategy,
    GeneticAlgorithm,
    Race,
    RaceSettings,
    RunDirectory,
)
from matrixworld.coevolution.runs import team_phase
from matrixworld.coevolution.runs.training import Training
from parts import Functions, Parts
from timing import bind, print_table

LEARNERS = {"es": "evolution strategy", "ga": "genetic algorithm"}
SCHEDULES = ("specialist-specialist", "generalist-generalist")
RESULTS = ("archive.npz", "payoff.npz", "log.csv")

PARTS: dict[str, Functions] = {
    "rollouts": [(_core, "rollout")],
    "seeds and matches": [
        (team_phase, "training_seeds"),
        (team_phase, "keyed_generator"),
        (Matches, "of"),
    ],
    "ask: variation": [(EvolutionStrategy, "ask"), (GeneticAlgorithm, "ask")],
    "tell: selection and update": [(EvolutionStrategy, "tell"), (GeneticAlgorithm, "tell")],
    "validation": [(Population, "__post_init__")],
    "fitness and log": [(Training, "fitness"), (Training, "record")],
    "checkpoints and disk": [
        (Race, "_save"),
        (Race, "_restore"),
        (RunDirectory, "write_config"),
        (RunDirectory, "save_payoff"),
        (RunDirectory, "save_summary"),
    ],
    "payoff matrix": [(Race, "evaluate"), (Race, "summary")],
}
FIGURES, OTHER = "figures and report", "other"


@contextmanager
def silence() -> Iterator[None]:
    """Let nothing be printed."""
    with open(os.devnull, "w") as nowhere, redirect_stdout(nowhere), redirect_stderr(nowhere):
        yield


def race(settings: RaceSettings, threads: int, parts: Parts) -> dict[str, bytes]:
    """Play a race as the command line does; returns the bytes that it has come to."""
    with TemporaryDirectory() as directory, silence():
        root = Path(directory)
        with parts.timed(OTHER):
            results = play_runs(create_runs([settings], root, threads))
        with parts.timed(FIGURES):
            report(results, root)
        return {name: (root / name).read_bytes() for name in RESULTS}


def check(learner: str, threads: int) -> None:
    """Wrappers change nothing."""
    settings = RaceSettings(learner=learner, generations=2, pursuer_epochs=2, evader_epochs=2)
    plain, parts = race(settings, threads, Parts()), Parts()
    with parts.wrapping(PARTS):
        assert race(settings, threads, parts) == plain
    assert set(parts.seconds) == {*PARTS, FIGURES, OTHER}


def measure(settings: RaceSettings, threads: int) -> Mapping[str, float]:
    """Seconds of a race by part."""
    parts = Parts()
    with parts.wrapping(PARTS):
        race(settings, threads, parts)
    return parts.seconds


def print_shares(learner: str, seconds: Mapping[str, Mapping[str, float]]) -> None:
    """Print a table of seconds by part and race, as shares of the whole."""
    whole = {name: sum(parts.values()) for name, parts in seconds.items()}
    rows: list[tuple[Any, ...]] = [
        (part, *(f"{100 * parts[part] / whole[name]:.1f}" for name, parts in seconds.items()))
        for part in (*PARTS, FIGURES, OTHER)
    ]
    rows.append(("seconds in all", *(f"{total:.1f}" for total in whole.values())))
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
@click.option("--generations", default=3, show_default=True, help="of a race")
@click.option("--epochs", type=int, help="of a generation, in place of a race's own")
@click.option("--threads", default=2, show_default=True, help="of the rollouts")
def main(learners: tuple[str, ...], generations: int, epochs: int | None, threads: int) -> None:
    """Print a table in Markdown for each learner."""
    bind(threads)
    changes: dict[str, Any] = {"generations": generations}
    if epochs is not None:
        changes |= {"pursuer_epochs": epochs, "evader_epochs": epochs}
    for learner in learners:
        check(learner, threads)
        settings = {
            name: RaceSettings(schedule=name, learner=learner, **changes) for name in SCHEDULES
        }
        print_shares(learner, {name: measure(each, threads) for name, each in settings.items()})


if __name__ == "__main__":
    main()
