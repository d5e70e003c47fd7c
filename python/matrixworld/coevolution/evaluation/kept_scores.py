"""Scores of the last generations of runs, which are played once and kept in their directories."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from matrixworld._util import files
from matrixworld._util.teams import PLURALS
from matrixworld.coevolution.evaluation.held_out import HELD_OUT_VERSION
from matrixworld.coevolution.evaluation.scores import (
    BESIDE_EPISODES,
    EPISODES,
    SEED,
    HeldOutScores,
    best_generations,
    best_scripts,
    score,
    score_runs,
)
from matrixworld.coevolution.progress import Report, silent
from matrixworld.coevolution.runs.stored import StoredRun
from matrixworld.coevolution.types import Team
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
    played = score_runs(missing, report=report, threads=threads)
    for run, scores in zip(missing, played, strict=True):
        files.save_json(run.path / SCORES, {**PLAYED_BY, **_with_others(run, scores, threads)})
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


def _with_others(
    run: StoredRun, scores: Mapping[Team, HeldOutScores], threads: int | None
) -> dict[str, Any]:
    """Return the scores of a run's teams as values of JSON, and those that they stand beside."""
    scripts = best_scripts(run.pursuit.world, episodes=EPISODES)
    first = score(run, generation=0, episodes=BESIDE_EPISODES, threads=threads)
    generations = best_generations(run, threads=threads)
    best = score(run, generation=generations, threads=threads)
    plain = {}
    for team, of_team in scores.items():
        plain[PLURALS[team]] = {
            **of_team.to_json(),
            "untrained": float(first[team].means[0]),
            "best script": [*scripts[team]],
            "best generation": [generations[team], float(best[team].means[0])],
        }
    return plain
