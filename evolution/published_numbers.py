"""Do the commands of docs/published.md reach the published numbers? By evolution, over seeds.

    python evolution/published_numbers.py             half an hour on two cores
    python evolution/published_numbers.py --quick     a small world, some seconds

`matrixworld evolve --paper --schedule against` as the page prints it: one team of O learns, by an
evolution strategy. Evaders that learn further start from those that learned against random
pursuers with the same seed, and meet the pursuers of that seed. After training each team plays 200
new episodes; a result is *reached* as `actor_critic_baselines.py` says.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from actor_critic_baselines import (
    AFTERWARDS,
    GAMES,
    HIDE,
    HUNT,
    QUICK,
    STATIC,
    TAUGHT,
    capture_rate,
    numbers_of,
)
from common import Numbers, Runs, experiment, markdown, of_each, pairs, written
from matrixworld.coevolution import RaceSettings

COMMANDS: dict[str, dict[str, Any]] = {
    HUNT: {},
    STATIC: {"schedule.opponent": "still"},
    HIDE: {"schedule.team": "evader"},
    TAUGHT: {"schedule.team": "evader", **AFTERWARDS, "schedule.epochs": 1200},
}
"""What each command changes in `evolve --paper --schedule against`, but for paths of runs."""


def settings_of(game: str, quick: bool) -> RaceSettings:
    """Return the settings of a command."""
    small = QUICK if quick else {}
    return RaceSettings.of({"schedule": "against", **COMMANDS[game], **small})


def kinds(quick: bool) -> dict[str, RaceSettings]:
    """Return the settings of the commands that begin untrained."""
    return {game: settings_of(game, quick) for game in COMMANDS if game != TAUGHT}


def taught(runs: Runs, quick: bool) -> dict[str, list[RaceSettings]]:
    """Return the settings of evaders that learn further, by seed."""
    return {
        TAUGHT: [
            settings_of(TAUGHT, quick).changed(
                {
                    "seed": begun.settings.seed,
                    "schedule.start": str(begun.path),
                    "schedule.opponent": str(rival.path),
                }
            )
            for begun, rival in pairs(runs, HIDE, HUNT)
        ]
    }


def table(numbers: Numbers) -> str:
    """Return what each command reaches as a table in Markdown."""
    rows = []
    for game in GAMES:
        captures, lengths, seconds = (
            numbers[f"{game.name} / {name}"] for name in ("captures", "lengths", "seconds")
        )
        found = capture_rate(captures)
        rows.append([
            game.name,
            written(found),
            ", ".join(f"{mean:.4f}" for mean in captures.mean(axis=1)),
            ", ".join(f"{mean:.0f}" for mean in lengths.mean(axis=1)),
            f"{game.capture:g} +- {game.spread:g}",
            game.length,
            f"**{game.verdict(found)}**",
            f"{np.median(seconds) / 60:.0f}",
        ])  # fmt: skip
    heads = [
        "game", "capture rate [95 % over seeds]", "of each seed", "length of each seed",
        "published capture rate", "published length", "", "minutes",
    ]  # fmt: skip
    return markdown(heads, rows)


if __name__ == "__main__":
    experiment(__doc__, kinds=kinds, then=taught, measure=of_each(numbers_of), table=table, seeds=3)
