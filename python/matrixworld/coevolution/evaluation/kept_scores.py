"""Scores of the last generations of runs, which are played once and kept in their directories."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from matrixworld._util import files
from matrixworld._util.teams import PLURALS
from matrixworld.coevolution.evaluation.held_out import HELD_OUT_VERSION
from matrixworld.coevolution.evaluation.scores import (
    BESIDE_EPISODES,
    EPISODES,
    SEED,
    best_generations,
    best_scripts,
    score,
)
from matrixworld.coevolution.progress import Report, part_of, silent
from matrixworld.coevolution.runs.stored import StoredRun
from matrixworld.version import __version__

SCORES = "scores.json"  # the file in the directory of a run
PLAYED_BY = {
    "format": 3,  # of the file
    "matrixworld": __version__,
    "held_out": HELD_OUT_VERSION,
    "episodes": EPISODES,
    "seed": SEED,
}
"""What kept scores were played by. Files with anything else are made anew."""


def kept_scores(
    runs: Sequence[StoredRun], *, threads: int | None = None, report: Report = silent
) -> list[dict[str, Any]]:
    """Return the scores of the last generations as values of JSON, by "pursuers" and "evaders".

    They are played once and kept with the mean scores of generation 0 ("untrained"), of each team's
    best script, and of its "best generation", which has been chosen on other episodes. ValueError
    for runs of another game than pursuit and evasion.
    """
    missing = [run for run in runs if not _is_kept(run)]
    for number, run in enumerate(missing):
        place = f"[{number + 1}/{len(missing)}] " if len(missing) > 1 else ""
        of_run = part_of(report, number, len(missing), place)
        # A reader of its own: the archives of all runs together may be large.
        found = _with_others(StoredRun(run.path), threads, of_run)
        files.save_json(run.path / SCORES, {**PLAYED_BY, **found})
    return [files.read_json(run.path / SCORES) for run in runs]


def _is_kept(run: StoredRun) -> bool:
    """Return whether the scores of a run's last generations are in its directory."""
    try:
        saved = files.read_json(run.path / SCORES)
    except (FileNotFoundError, files.DamagedFileError):
        return False
    if not saved.items() >= PLAYED_BY.items():
        return False
    # A race that has gone on has other last generations.
    archive = run.archive()
    for team in run.settings.learning_teams:
        last = len(archive[run.key_of(team)]) - 1
        if saved.get(PLURALS[team], {}).get("generations") != [last]:
            return False
    return True


def _with_others(run: StoredRun, threads: int | None, report: Report) -> dict[str, Any]:
    """Return the scores of a run's teams as values of JSON, and those that they stand beside."""
    generations = best_generations(run, threads=threads, report=part_of(report, 0, 3))
    best = score(run, generation=generations, threads=threads, report=part_of(report, 1, 3))
    scores = score(run, threads=threads, report=part_of(report, 2, 3))
    first = score(run, generation=0, episodes=BESIDE_EPISODES, threads=threads)
    scripts = best_scripts(run.pursuit.world, episodes=EPISODES)
    plain = {}
    for team, of_team in scores.items():
        plain[PLURALS[team]] = {
            **of_team.to_json(),
            "untrained": float(first[team].means[0]),
            "best script": [*scripts[team]],
            "best generation": [generations[team], float(best[team].means[0])],
        }
    return plain
