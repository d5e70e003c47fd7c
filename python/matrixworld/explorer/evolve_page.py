"""The page on which a race of pursuers and evaders evolves, in the browser itself.

>>> from matrixworld.explorer.evolve_page import evolve_page
>>> html = evolve_page()
"""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from matrixworld._util.files import load_toml
from matrixworld.coevolution.evaluation.effects import PHRASES, WORDS
from matrixworld.coevolution.games.pursuit import PursuitSettings
from matrixworld.coevolution.runs.facts import Facts
from matrixworld.coevolution.runs.stored_files import FORMAT
from matrixworld.coevolution.settings.race_settings import RaceSettings
from matrixworld.coevolution.settings.schedules import SCHEDULES, AtOnce
from matrixworld.coevolution.types import TEAMS
from matrixworld.explorer.page import render_page
from matrixworld.version import __version__
from matrixworld.world.config import WorldConfig
from matrixworld.world.masks import right_of_way_cells

PAGE = "evolve.html"  # name of the page

PARTS: Mapping[str, Any] = load_toml(Path(__file__).with_name("evolve.toml"))
"""Parts of the settings of a race: of its world, its learner, its policy and its epochs."""
ES, GA = PARTS["learners"]


def race_of(
    schedule: str = "generalist-generalist",
    learner: str = ES,
    policy: str = "cells",
    place: str = "meadow",
) -> RaceSettings:
    """Return the settings with which the page begins a race."""
    world = PARTS["worlds"][place]
    return RaceSettings.of({
        **world,
        **PARTS["learners"][learner],
        **PARTS["policies"][policy],
        **PARTS["at_once" if schedule == AtOnce.kind else "in_turns"][policy],
        "schedule": schedule,
        "schedule.generations": 15,
        "train_steps": world["world.max_steps"],
    })  # fmt: skip


def plain_race(settings: RaceSettings) -> dict[str, Any]:
    """Return settings of a race as the page reads and changes them."""
    plain = settings.to_json()
    del plain["chosen"]  # the page chooses
    return plain


def world_of(place: str) -> WorldConfig:
    """Return a world of the page."""
    game = race_of(place=place).game
    assert isinstance(game, PursuitSettings)
    return game.world


def masks_of(config: WorldConfig) -> dict[str, Any]:
    """Return the `right_of_way_cells` of each team."""
    return {team: right_of_way_cells(config, team) for team in TEAMS}


def evolve_data() -> dict[str, Any]:
    """Return what a page needs: worlds, races by policy, learner and schedule, masks, and words."""
    schedules = (*SCHEDULES, AtOnce.kind)
    return {
        "version": __version__,
        "format": FORMAT,
        "game": Facts.of(race_of().game, race_of().known)._asdict(),
        "worlds": {name: world_of(name).to_json() for name in PARTS["worlds"]},
        "races": {
            policy: {
                learner: {
                    schedule: plain_race(race_of(schedule, learner, policy))
                    for schedule in schedules
                }
                for learner in PARTS["learners"]
            }
            for policy in PARTS["policies"]
        },
        "masks": masks_of(world_of("meadow")),
        "phrases": PHRASES,
        "words": WORDS,
    }


def evolve_page(title: str = "Evolve a chase - matrixworld") -> str:
    """Return the page as HTML."""
    return render_page("evolve", title, evolve_data(), works=True)
