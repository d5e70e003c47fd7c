"""Best responses to the champions of many runs, evolved side by side."""

from __future__ import annotations

from collections.abc import Mapping
from concurrent.futures import Executor
from pathlib import Path
from typing import Any

from matrixworld.coevolution.jobs.evolve import evolve, silent
from matrixworld.coevolution.jobs.worker import LOCK_WAIT
from matrixworld.coevolution.progress import JobReport
from matrixworld.coevolution.runs.best_response import (
    BestResponse,
    best_response,
    champion_of,
    response_settings,
)
from matrixworld.coevolution.settings import RaceSettings
from matrixworld.coevolution.storage.saved_run import SavedRun
from matrixworld.coevolution.types import Team


def best_responses(
    runs: Mapping[str, SavedRun],
    team: Team,
    matches: int,
    directory: str | Path,
    *,
    executor: Executor | None = None,
    threads: int | None = None,
    report: JobReport = silent,
    lock_wait: float = LOCK_WAIT,
    **changes: Any,
) -> dict[str, BestResponse]:
    """Evolve a response to the last genome of `team` in each run, and measure its gain.

    Parameters
    ----------
    runs : mapping of str to SavedRun
        The runs of the champions, by the names that the responses get in `directory`.
    team : {"pursuer", "evader"}
        Team of the champions.
    matches : int
        Budget of each response.
    directory : str or Path
        Directory of all responses; the same call continues what is unfinished in it.
    executor, threads, report, lock_wait
        As in `evolve`.
    **changes
        Fields of `RaceSettings` of the responses, such as ``match_episodes=2``.

    Returns
    -------
    dict of str to BestResponse
        As `best_response` returns them, in the order of `runs`.

    Raises
    ------
    ValueError
        If `team` did not learn in a run, and as in `best_response`.

    Notes
    -----
    Other errors are those of `evolve`. The matches that measure the gains are played here.
    """
    evolve(
        settings_of_responses(runs, team, matches, **changes),
        directory,
        executor=executor,
        threads=threads,
        report=report,
        lock_wait=lock_wait,
    )
    return {
        name: best_response(run, team, matches, Path(directory) / name, threads=threads, **changes)
        for name, run in runs.items()
    }


def settings_of_responses(
    runs: Mapping[str, SavedRun], team: Team, matches: int, **changes: Any
) -> dict[str, RaceSettings]:
    """Return the settings of the responses by name; ValueError as `best_responses` raises it."""
    settings = {}
    for name, run in runs.items():
        champion_of(run, team)
        champion = str(run.files.path.absolute())
        settings[name] = response_settings(run, team, matches, opponent=champion, **changes)
    return settings
