"""A run as plain values for a page: settings, training, results and findings."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import fields
from typing import Any

import numpy as np
from numpy.typing import NDArray

from matrixworld.analysis.plain_values import plain_values
from matrixworld.coevolution.opponents.registry import HALL_OF_FAME
from matrixworld.coevolution.payoff import Payoff
from matrixworld.coevolution.seeding import evaluation_seed
from matrixworld.coevolution.settings.race import RaceSettings
from matrixworld.coevolution.settings.single import SingleSettings
from matrixworld.coevolution.settings.training import settings_to_json
from matrixworld.coevolution.storage.saved_run import SavedRun
from matrixworld.coevolution.types import TEAMS
from matrixworld.explorer.archives import generations_of
from matrixworld.explorer.findings import findings, too_few_episodes

Settings = RaceSettings | SingleSettings

MOST_POINTS = 6000
"""The most points of a training curve; a longer one has means of neighbouring epochs."""
WINDOWS, LONGEST = 4, 100
"""As in the figures: windows of the moving average in a team phase, and in a run of one team."""


def run_data(name: str, run: SavedRun, held_out: Mapping[str, Any] | None = None) -> dict[str, Any]:
    """Return what a page shows of a finished run.

    Parameters
    ----------
    name : str
        Name of the run on the page.
    run : SavedRun
        The run.
    held_out : mapping, optional
        ``HeldOutScores.to_json()`` of the last ``"pursuers"`` and of the last ``"evaders"``.

    Returns
    -------
    dict
        Plain values that JSON can hold, without the genomes.
    """
    settings, payoff = run.settings, run.payoff()
    shape = tuple(generations_of(run.teams[team]) for team in TEAMS)
    race = isinstance(settings, RaceSettings)
    return {
        "name": name,
        "race": race,
        "schedule": settings.schedule if isinstance(settings, RaceSettings) else "one team",
        "learning": list(settings.learning_teams),
        "seed": str(settings.seed),
        "world": settings.world(settings.eval_steps).to_json(),
        "settings": plain_settings(settings),
        "training": training_curve(run.files.log(), settings),
        "payoff": plain_payoff(payoff, shape),
        # As text: a number of JavaScript holds 53 of the 64 bits.
        "seeds": [
            [str(evaluation_seed(settings.seed, g, h)) for h in range(shape[1])]
            for g in range(shape[0])
        ],
        "findings": findings(payoff) if race else None,
        "limits": too_few_episodes(payoff) if race else "",
        "held_out": held_out and {f"{team}s": held_out.get(f"{team}s") for team in TEAMS},
    }


def plain_payoff(payoff: Payoff, shape: tuple[int, ...]) -> dict[str, Any]:
    """Return the results of all cells, placed in a matrix of all generations.

    Parameters
    ----------
    payoff : Payoff
        Results; those of a single team are of its last generation.
    shape : tuple of int
        Pursuer and evader generations of the archives.

    Returns
    -------
    dict
        ``first``, the generations of the first cell that was played; its shape; and lists of rows:
        capture rate, and episode by episode capture rates and lengths.
    """
    first = [count - played for count, played in zip(shape, payoff.capture_rate.shape, strict=True)]
    return {
        "first": first,
        "shape": list(shape),
        "episodes": payoff.capture_rates.shape[2],
        "capture_rate": payoff.capture_rate.tolist(),
        # Nine digits identify every float32.
        "capture_rates": [
            [[float(f"{rate:.9g}") for rate in cell] for cell in row]
            for row in payoff.capture_rates.tolist()
        ],
        "lengths": payoff.lengths.tolist(),
    }


def training_curve(log: Mapping[str, NDArray[Any]], settings: Settings) -> dict[str, Any]:
    """Return the capture rate over training.

    Parameters
    ----------
    log : mapping of str to ndarray
        Columns of the log.
    settings : RaceSettings or SingleSettings
        Settings of the run.

    Returns
    -------
    dict
        Lists of equal lengths: ``capture_rate``, ``generation`` and ``learner`` (0 the pursuers, 1
        the evaders, 2 both); ``epochs`` of a point, and ``window``, the points of a moving average.
    """
    learner = (log["team"] == "evader").astype(int)
    both = isinstance(settings, RaceSettings) and settings.schedule == HALL_OF_FAME
    if both:
        # Both teams learn from the same matches, and each logs a row of them.
        log = {name: column[learner == 0] for name, column in log.items()}
        learner = np.full(len(log["team"]), 2)
    phases = [settings.total_epochs(team) for team in settings.learning_teams]
    windows = WINDOWS * settings.generations if isinstance(settings, RaceSettings) else LONGEST
    window = max(1, min(phases) // windows)
    every = -(-len(learner) // MOST_POINTS)
    starts = np.arange(0, len(learner), every)
    counts = np.diff([*starts, len(learner)])
    return {
        "capture_rate": np.round(np.add.reduceat(log["capture_rate"], starts) / counts, 4).tolist(),
        "generation": log["generation"][starts].tolist(),
        "learner": learner[starts].tolist(),
        "epochs": every,
        "window": max(1, round(window / every)),
        "matches": int(log["matches"][-1]) if len(learner) else 0,
    }


def plain_settings(settings: Settings) -> list[dict[str, Any]]:
    """Return name, value and meaning of each setting, and whether it differs from the default."""
    values, usual = settings_to_json(settings), _usual(settings)
    return [
        {
            "name": item.name,
            "value": _shown(plain_values(values[item.name])),
            "help": item.metadata["help"],
            "changed": getattr(settings, item.name) != getattr(usual, item.name),
        }
        for item in fields(settings)
    ]


def _usual(settings: Settings) -> Settings:
    """Return the settings without options, of the same seed and schedule or opponent."""
    if isinstance(settings, RaceSettings):
        return RaceSettings(schedule=settings.schedule, seed=settings.seed)
    return SingleSettings(team=settings.team, against=settings.against, seed=settings.seed)


def _shown(value: Any) -> str:
    if isinstance(value, str):
        return value
    if value is None:
        return "default"
    return json.dumps(value)
