"""The page on which a race of pursuers and evaders evolves, in the browser itself.

>>> from matrixworld.explorer.evolve_page import evolve_page
>>> html = evolve_page()
"""

from __future__ import annotations

from typing import Any

from matrixworld.coevolution.learners import EvolutionStrategy, GeneticAlgorithm
from matrixworld.coevolution.race import PAPER, AtOnce
from matrixworld.coevolution.settings import RaceSettings
from matrixworld.coevolution.storage import FORMAT
from matrixworld.coevolution.types import TEAMS
from matrixworld.explorer.page import render_page
from matrixworld.version import __version__
from matrixworld.world.config import WorldConfig
from matrixworld.world.masks import right_of_way_cells

PAGE = "evolve.html"
"""Name of the page."""

STEPS = 60
RACE: dict[str, Any] = {
    "world.rows": 12,
    "world.cols": 12,
    "world.n_pursuers": 3,
    "world.n_evaders": 4,
    "world.fov": 5,
    "world.max_steps": STEPS,
    "train_steps": STEPS,
    "policy.hidden": (),
    "schedule.generations": 15,
}
"""A race that takes some seconds in a browser, and in which both teams visibly learn: without
hidden layers a genome has so few numbers that few matches tell which ones are good."""
ES, GA = EvolutionStrategy.kind, GeneticAlgorithm.kind
LEARNERS: dict[str, dict[str, Any]] = {
    ES: {"learner": ES, "learner.sigma": 0.3, "learner.learning_rate": 0.2},
    GA: {"learner": GA, "learner.mutation": 0.2},
}
IN_TURNS = {"learner.population": 32, "schedule.pursuer_epochs": 30, "schedule.evader_epochs": 20}
AT_ONCE = {"learner.population": 16, "schedule.joint_epochs": 20}
SCHEDULES: dict[str, dict[str, Any]] = {
    **{name: {"schedule": name, **IN_TURNS} for name in PAPER},
    AtOnce.kind: {"schedule": AtOnce.kind, **AT_ONCE},
}


def race_of(schedule: str, learner: str = ES) -> RaceSettings:
    """Return the settings with which the page begins."""
    return RaceSettings.of({**LEARNERS[learner], **SCHEDULES[schedule], **RACE})


def masks_of(config: WorldConfig) -> dict[str, Any]:
    """Return the `right_of_way_cells` of each team."""
    return {team: right_of_way_cells(config, team) for team in TEAMS}


def evolve_data() -> dict[str, Any]:
    """Return what a page needs: races by learner and schedule, another policy, and masks."""
    races = {
        learner: {schedule: race_of(schedule, learner).to_json() for schedule in SCHEDULES}
        for learner in LEARNERS
    }
    masks = masks_of(race_of(next(iter(SCHEDULES))).world)
    ratings = RaceSettings.of(policy="rating").to_json()["policy"]
    return {
        "version": __version__,
        "format": FORMAT,
        "races": races,
        "ratings": ratings,
        "masks": masks,
    }


def evolve_page(title: str = "Evolve a chase - matrixworld") -> str:
    """Return the page as HTML."""
    return render_page("evolve", title, evolve_data(), works=True)
