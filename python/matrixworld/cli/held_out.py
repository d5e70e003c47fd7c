"""Held-out scores of finished races: played once, and kept in the run directory."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from matrixworld._util.files import DamagedFileError, json_digest, load_json, save_json
from matrixworld.cli.console import progress
from matrixworld.coevolution import HeldOutScores, RunDirectory, Team, open_run, score
from matrixworld.version import __version__

if TYPE_CHECKING:
    from matrixworld.cli.groups import Result

SCORES = "scores.json"
"""File in the run directory."""
EPISODES = 100
"""Episodes of each pair. They and the seed are the defaults of ``matrixworld score``."""
SEED = 0

Scores = dict[str, Any]
"""``HeldOutScores.to_json()`` of the last ``"pursuers"`` and of the last ``"evaders"``."""


def score_all(paths: Sequence[Path], **options: Any) -> dict[Path, Mapping[Team, HeldOutScores]]:
    """Score runs one after the other, with one progress for all; options as those of `score`."""
    found: dict[Path, Mapping[Team, HeldOutScores]] = {}
    with progress() as report:
        for number, path in enumerate(paths):
            # Runs of a job play about equally many matches.
            def part(what: str, done: int, total: int, number: int = number) -> None:
                place = f"[{number + 1}/{len(paths)}] " if len(paths) > 1 else ""
                report(place + what, number * total + done, len(paths) * total)

            found[path] = score(open_run(path), report=part, **options)
    return found


def play_held_out(races: Sequence[Result], threads: int | None) -> None:
    """Play the scores of the last generations of races that have none, and keep them.

    They are those of ``matrixworld score`` without options.
    """
    missing = {race.path: race.files for race in races if kept_scores(race.files) is None}
    if not missing:
        return
    played = score_all([*missing], episodes=EPISODES, seed=SEED, threads=threads)
    for path, files in missing.items():
        teams = {f"{team}s": each.to_json() for team, each in played[path].items()}
        values = {"matrixworld": __version__, "episodes": EPISODES, "seed": SEED, **teams}
        save_json(path / SCORES, values, owner=_owner(files))


def kept_scores(files: RunDirectory) -> Scores | None:
    """Return the scores in the run directory; None if none are kept there, or other ones."""
    try:
        kept = load_json(files.path / SCORES, owner=_owner(files))
    except (FileNotFoundError, DamagedFileError):
        return None
    # Other versions may have other held-out opponents.
    played = kept.get("matrixworld"), kept.get("episodes"), kept.get("seed")
    return kept if played == (__version__, EPISODES, SEED) else None


def _owner(files: RunDirectory) -> str:
    # As the other files of a run: scores of another run are not taken for those of this one.
    return f"{json_digest(files.config())}/{SCORES}"
