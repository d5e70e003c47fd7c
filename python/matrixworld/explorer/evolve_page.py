"""The page on which a race of pursuers and evaders evolves, in the browser itself.

>>> from matrixworld.explorer.evolve_page import evolve_page
>>> html = evolve_page()
"""

from __future__ import annotations

from typing import Any

from matrixworld.coevolution.evaluation.explanation import PHRASES, WORDS
from matrixworld.coevolution.learners.evolution_strategy import EvolutionStrategy
from matrixworld.coevolution.learners.genetic_algorithm import GeneticAlgorithm
from matrixworld.coevolution.pursuit import Cells, Ratings
from matrixworld.coevolution.race import SCHEDULES, AtOnce
from matrixworld.coevolution.settings import RaceSettings
from matrixworld.coevolution.storage import FORMAT
from matrixworld.coevolution.types import TEAMS
from matrixworld.explorer.page import render_page
from matrixworld.version import __version__
from matrixworld.world.config import WORLDS, WorldConfig
from matrixworld.world.masks import right_of_way_cells

PAGE = "evolve.html"  # name of the page

FIELD = "meadow"  # the world of the page without walls, which is small enough for networks
STEPS = 120
"""Of a match in the worlds in balance: enough for a chase, and fewer than they have elsewhere."""
PLACES: dict[str, dict[str, Any]] = {
    **{name: {"world.kind": name, "world.max_steps": STEPS} for name in WORLDS},
    FIELD: {
        "world.rows": 12,
        "world.cols": 12,
        "world.n_pursuers": 3,
        "world.n_evaders": 4,
        "world.fov": 5,
        "world.max_steps": 60,
    },
}
"""Worlds of the page, the first one at its beginning."""
USUAL = "generalist-generalist"
RATING, CELLS = Ratings.kind, Cells.kind
ES, GA = EvolutionStrategy.kind, GeneticAlgorithm.kind
LEARNERS: dict[str, dict[str, Any]] = {
    ES: {"learner": ES, "learner.sigma": 0.3, "learner.learning_rate": 0.2},
    GA: {"learner": GA, "learner.mutation": 0.2},
}
IN_TURNS, AT_ONCE = (
    ("schedule.pursuer_epochs", "schedule.evader_epochs"),
    ("schedule.joint_epochs",),
)
POLICIES: dict[str, dict[str, Any]] = {
    RATING: {"policy": RATING, "evaluation_episodes": 20},
    CELLS: {"policy": CELLS, "policy.hidden": ()},
}
EPOCHS = {RATING: (16, (8, 8), 16, (8,)), CELLS: (32, (30, 20), 16, (20,))}
"""Candidates and epochs in turns, candidates and epochs at once: races of seconds in a browser, in
which both teams visibly learn. Without hidden layers a genome has so few numbers that few
matches tell which ones are good."""


def race_of(
    schedule: str = USUAL, learner: str = ES, policy: str = CELLS, place: str = FIELD
) -> RaceSettings:
    """Return the settings with which the page begins a race."""
    candidates, in_turns, candidates_at_once, at_once = EPOCHS[policy]
    epochs = dict(zip(IN_TURNS, in_turns, strict=True))
    if schedule == AtOnce.kind:
        candidates, epochs = candidates_at_once, dict(zip(AT_ONCE, at_once, strict=True))
    return RaceSettings.of({
        **LEARNERS[learner],
        **POLICIES[policy],
        **PLACES[place],
        **epochs,
        "learner.population": candidates,
        "schedule": schedule,
        "schedule.generations": 15,
        "train_steps": PLACES[place]["world.max_steps"],
    })  # fmt: skip


def masks_of(config: WorldConfig) -> dict[str, Any]:
    """Return the `right_of_way_cells` of each team."""
    return {team: right_of_way_cells(config, team) for team in TEAMS}


def evolve_data() -> dict[str, Any]:
    """Return what a page needs: worlds, races by policy, learner and schedule, masks, and words."""
    schedules = (*SCHEDULES, AtOnce.kind)
    return {
        "version": __version__,
        "format": FORMAT,
        "worlds": {name: race_of(place=name).to_json()["world"] for name in PLACES},
        "races": {
            policy: {
                learner: {
                    schedule: race_of(schedule, learner, policy).to_json() for schedule in schedules
                }
                for learner in LEARNERS
            }
            for policy in POLICIES
        },
        "masks": masks_of(race_of().world),
        "phrases": PHRASES,
        "words": WORDS,
    }


def evolve_page(title: str = "Evolve a chase - matrixworld") -> str:
    """Return the page as HTML."""
    return render_page("evolve", title, evolve_data(), works=True)
