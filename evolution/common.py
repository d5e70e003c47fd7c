"""Command-line options, runs and matches that several experiments share."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Callable, Iterator, Mapping
from concurrent.futures import Executor, ProcessPoolExecutor
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy import stats

import matrixworld as mw
from matrixworld._util.files import load_json, save_json
from matrixworld.analysis import Estimate
from matrixworld.cli.cluster import on_cluster
from matrixworld.coevolution import (
    FailedRunsError,
    ProgressBar,
    RaceSettings,
    SavedRun,
    Team,
    open_run,
)
from matrixworld.coevolution.jobs import job_of, play_job

sys.path.append(str(Path(__file__).parents[1] / "tutorials"))  # where the folder `course` lies

SAME_STEPS = {"learner.relative_sigma": 0.0, "learner.learning_rate": 0.02}
"""Settings of an evolution strategy whose samples do not spread with the genome."""

SMALL_STEPS: Mapping[Team, Mapping[str, float]] = {
    "pursuer": {"learner.sigma": 0.15, "learner.learning_rate": 0.02},
    "evader": {"learner.sigma": 0.1, "learner.learning_rate": 0.02},
}
"""Steps of a team that learns alone that do not follow from its epochs, by team."""


def long_race(schedule: str) -> dict[str, Any]:
    """Return the settings of a race with twice the matches of a default one, and `SAME_STEPS`."""
    in_turns = {"schedule.pursuer_epochs": 60, "schedule.evader_epochs": 120}
    epochs = {"schedule.joint_epochs": 90} if schedule == "hall-of-fame" else in_turns
    return {"schedule": schedule, **epochs, **SAME_STEPS}


def script_parser(doc: str | None, *, quick: str, cluster: bool = False) -> argparse.ArgumentParser:
    """Return a parser with the first line of a script's docstring and the option ``--quick``.

    Parameters
    ----------
    doc : str or None
        Docstring of the script.
    quick : str
        Help text of ``--quick``.
    cluster : bool, optional
        Whether the script takes ``--cluster``.

    Returns
    -------
    argparse.ArgumentParser
        The parser, for further options.
    """
    # Docstrings are None under python -OO.
    parser = argparse.ArgumentParser(description=(doc or "").split("\n", 1)[0])
    parser.add_argument("--quick", action="store_true", help=quick)
    if cluster:
        parser.add_argument(
            "--cluster",
            metavar="auto|ADDRESS|FILE",
            help="play on a Dask cluster (docs/cluster.md); default: this machine's cores",
        )
    return parser


@contextmanager
def executor_of(where: str | None, processes: int) -> Iterator[Executor]:
    """Yield the executor that ``--cluster`` asks for, or without it one of so many processes."""
    with on_cluster(where) as given, given or ProcessPoolExecutor(processes) as executor:
        yield executor


def finish_all(
    settings: Mapping[str, RaceSettings],
    root: Path,
    *,
    threads: int | None = None,
    where: str | None = None,
) -> dict[str, SavedRun]:
    """Return finished runs by name; play the missing ones side by side.

    Parameters
    ----------
    settings : mapping of str to RaceSettings
        Settings of each run, by the path of its directory in `root`.
    root : Path
        Directory of all runs. It may hold others, of earlier calls.
    threads : int, optional
        Threads in all, without a cluster. By default one for each core.
    where : str, optional
        Value of ``--cluster``.

    Raises
    ------
    FailedRunsError
        If runs failed, after all others have ended.
    """
    job = job_of(settings)
    with (
        on_cluster(where) as executor,
        ProgressBar() as bar,
    ):
        share = None if executor is not None else threads
        failures = play_job(job, root, keep=False, executor=executor, threads=share, report=bar)
    if failures:
        raise FailedRunsError({root / name: why for name, why in failures.items()})
    return {name: open_run(root / name) for name in settings}


def kept(file: Path, measure: Callable[[], Mapping[str, Any]]) -> dict[str, Any]:
    """Return the numbers that a file keeps; measure and keep them if it is missing."""
    if not file.exists():
        file.parent.mkdir(parents=True, exist_ok=True)
        save_json(file, measure())
    return load_json(file)


def play(
    world: mw.WorldConfig,
    team: Team,
    own: mw.Population,
    opponents: mw.Population,
    seeds: ArrayLike,
    *,
    own_genomes: ArrayLike | None = None,
    opponent_genomes: ArrayLike = 0,
) -> mw.EpisodeStatistics:
    """Play matches of one team's genomes, whichever team it is.

    Parameters
    ----------
    world : WorldConfig
        World of the matches.
    team : {"pursuer", "evader"}
        Team of `own`.
    own : Population
        Genomes of the team.
    opponents : Population
        Genomes of the other team.
    seeds : array_like of int, shape (matches,)
        Seed of each match.
    own_genomes : array_like of int, shape (matches,), optional
        Genome of `own` in each match. The default is one match of each genome.
    opponent_genomes : array_like of int, shape (matches,) or (), optional
        Genome of `opponents` in each match.

    Returns
    -------
    EpisodeStatistics
        One episode of each match.
    """
    each = np.arange(len(own.genomes)) if own_genomes is None else own_genomes
    # The engine takes pursuers first, in the populations and in the matches.
    if team == "pursuer":
        return mw.rollout(world, own, opponents, mw.Matches.of(each, opponent_genomes, seeds))
    return mw.rollout(world, opponents, own, mw.Matches.of(opponent_genomes, each, seeds))


SIGNIFICANCE = 0.05
"""Probability of any false verdict in a table, if no number differed from its threshold."""


def p_value(values: ArrayLike, than: float = 0.0) -> float:
    """Return the two-sided p-value that the mean of one number for each seed is `than`.

    Student's t test. Seeds that all agree have no spread; they take the sign test, which counts
    seeds on either side of `than`: two to the power of one minus the number of seeds.
    """
    distances = np.asarray(values, dtype=np.float64) - than
    if np.ptp(distances) > 1e-12:
        return float(stats.ttest_1samp(distances, 0.0).pvalue)
    return 2.0 ** (1 - len(distances)) if distances[0] else 1.0


def holm(p_values: ArrayLike) -> NDArray[np.float64]:
    """Return the p-values of several tests, adjusted so that one level holds for all together.

    Shape (tests,). The smallest of n p-values is multiplied by n, the next one by n - 1, and none
    becomes smaller than the one before (Holm 1979, "A simple sequentially rejective multiple test
    procedure"). The tests may depend on each other.
    """
    given = np.asarray(p_values, dtype=np.float64)
    order = np.argsort(given)
    adjusted = np.empty_like(given)
    adjusted[order] = np.maximum.accumulate(given[order] * np.arange(len(given), 0, -1))
    return np.minimum(adjusted, 1.0)


def shown_p(p: float) -> str:
    """Return a p-value as text."""
    return "p < 0.001" if p < 0.001 else f"p = {p:.3f}"


def written(found: Estimate, digits: int = 3, sign: str = "") -> str:
    """Return a number and its interval in brackets; seeds that all agree have none."""
    ends = [end for end in (found.value, found.low, found.high) if end is not None]
    # Adding 0.0 turns -0.0 into 0.0.
    value, *interval = (format(round(end, digits) + 0.0, f"{sign}.{digits}f") for end in ends)
    return f"{value} [{', '.join(interval)}]" if interval else value
