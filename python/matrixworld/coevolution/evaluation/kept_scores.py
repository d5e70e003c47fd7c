"""Scores of runs, and what their teams do: played once and kept in the directories of the runs."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from matrixworld._util import files
from matrixworld._util.readable import plain_values
from matrixworld._util.teams import PLURALS
from matrixworld.coevolution.evaluation.explanation import in_short
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

PARTS = 5  # of the progress of a run
SCORES = "scores.json"  # the file in the directory of a run
PLAYED_BY = {
    "format": 4,  # of the file
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
    best script, and of its "best generation", which has been chosen on other episodes; and with
    what that generation does ("evolved"; see `in_short`). ValueError for runs of another game than
    pursuit and evasion.
    """
    missing = [run for run in runs if found_scores(run) is None]
    for number, run in enumerate(missing):
        place = f"[{number + 1}/{len(missing)}] " if len(missing) > 1 else ""
        of_run = part_of(report, number, len(missing), place)
        # A reader of its own: the archives of all runs together may be large.
        found = _with_others(StoredRun(run.path), threads, of_run)
        files.save_json(run.path / SCORES, {**PLAYED_BY, **found})
    return [files.read_json(run.path / SCORES) for run in runs]


def found_scores(run: StoredRun) -> dict[str, Any] | None:
    """Return what `kept_scores` returns of a run, if it has been kept; nothing is played."""
    try:
        saved: dict[str, Any] = files.read_json(run.path / SCORES)
    except (FileNotFoundError, files.DamagedFileError):
        return None
    if not saved.items() >= PLAYED_BY.items():
        return None
    # A race that has gone on has other last generations.
    archive = run.archive()
    for team in run.settings.learning_teams:
        last = len(archive[run.key_of(team)]) - 1
        if saved.get(PLURALS[team], {}).get("generations") != [last]:
            return None
    return saved


def _with_others(run: StoredRun, threads: int | None, report: Report) -> dict[str, Any]:
    """Return the scores of a run's teams as values of JSON, and those that they stand beside."""
    generations = best_generations(run, threads=threads, report=part_of(report, 0, PARTS))
    best = score(run, generation=generations, threads=threads, report=part_of(report, 1, PARTS))
    evolved = {
        team: in_short(run, team, best_one, threads=threads, report=part_of(report, part, PARTS))
        for part, (team, best_one) in enumerate(generations.items(), start=2)
    }
    scores = score(run, threads=threads, report=part_of(report, PARTS - 1, PARTS))
    first = score(run, generation=0, episodes=BESIDE_EPISODES, threads=threads)
    scripts = best_scripts(run.pursuit.world, episodes=EPISODES, threads=threads)
    plain = {}
    for team, of_team in scores.items():
        plain[PLURALS[team]] = {
            **of_team.to_json(),
            "untrained": float(first[team].means[0]),
            "best script": scripts[team]._asdict(),
            "best generation": [generations[team], float(best[team].means[0])],
            "evolved": plain_values(evolved[team]),
        }
    return plain
