"""Held-out scores of finished races: played once, and kept in the run directory."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

from matrixworld._util.files import DamagedFileError, json_digest, load_json, save_json
from matrixworld.cli.console import part_of_job, progress
from matrixworld.cli.jobs import Result
from matrixworld.coevolution import open_run, score
from matrixworld.coevolution.evaluation.held_out_opponents import fitting_opponents
from matrixworld.coevolution.types import TEAMS
from matrixworld.version import __version__

SCORES = "scores.json"
"""File in the run directory."""
EPISODES = 100
"""Episodes of each pair. They and the seed are the defaults of ``matrixworld score``."""
SEED = 0

ENDS = ("value", "low", "high")

Scores = dict[str, Any]
"""``HeldOutScores.to_json()`` of the last ``"pursuers"`` and of the last ``"evaders"``."""


def held_out_scores(races: Sequence[Result], threads: int | None) -> dict[Path, Scores]:
    """Return the scores of the last generations of races, and play those that are missing.

    Parameters
    ----------
    races : sequence of Result
        Finished races.
    threads : int or None
        Threads that play matches; None for all cores.

    Returns
    -------
    dict of Path to dict
        Scores by run directory. They are those of ``matrixworld score`` without options.
    """
    missing = [race for race in races if kept_scores(race) is None]
    counts = [_matches(race) for race in missing]
    if missing:
        with progress() as report:
            for number, race in enumerate(missing):
                place = f"[{number + 1}/{len(missing)}] " if len(missing) > 1 else ""
                part = part_of_job(report, place, sum(counts[:number]), sum(counts))
                saved = open_run(race.path)
                found = score(saved, episodes=EPISODES, seed=SEED, threads=threads, report=part)
                _keep(race, {f"{team}s": each.to_json() for team, each in found.items()})
    return {race.path: kept_scores(race) or {} for race in races}


def _matches(race: Result) -> int:
    world = race.settings.world(race.settings.eval_steps)
    return EPISODES * sum(len(fitting_opponents(team, world)[0]) for team in TEAMS)


def _keep(race: Result, scores: Scores) -> None:
    values = {"matrixworld": __version__, "episodes": EPISODES, "seed": SEED, **scores}
    save_json(race.path / SCORES, values, owner=_owner(race))


def kept_scores(race: Result) -> Scores | None:
    """Return the scores in the run directory; None if none are kept there, or other ones."""
    try:
        kept = load_json(race.path / SCORES, owner=_owner(race))
    except (FileNotFoundError, DamagedFileError):
        return None
    # Other versions may have other held-out opponents.
    played = kept.get("matrixworld"), kept.get("episodes"), kept.get("seed")
    return kept if played == (__version__, EPISODES, SEED) and _holds_means(kept) else None


def _holds_means(kept: Scores) -> bool:
    """Return whether scores have what is printed and drawn of them."""
    try:
        teams = [kept[f"{team}s"] for team in TEAMS]
        found = [mean[end] for each in teams for [mean] in [each["mean"]] for end in ENDS]
        found += [one["value"] for each in teams for [one] in each["against"].values()]
    except (AttributeError, KeyError, TypeError, ValueError):
        return False
    return all(type(number) is float for number in found)


def _owner(race: Result) -> str:
    # As the other files of a run: scores of another run are not taken for those of this one.
    return f"{json_digest(race.files.config())}/{SCORES}"
