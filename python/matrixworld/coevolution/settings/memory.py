"""Memory that a run needs, estimated from its settings before anything is made."""

from __future__ import annotations

from matrixworld._util.memory import EPISODE_BYTES
from matrixworld.coevolution.opponents.registry import HALL_OF_FAME
from matrixworld.coevolution.settings.race import RaceSettings
from matrixworld.coevolution.settings.single import SingleSettings

COPIES = 4
"""Of candidates: samples or parents and children of both teams. Of views: for actor and critic."""


def run_memory(settings: RaceSettings | SingleSettings) -> dict[str, int]:
    """Return the bytes of a run's largest arrays, by what they hold."""
    genome, teams = 4 * settings.network.genome_size, len(settings.learning_teams)
    if isinstance(settings, SingleSettings):
        generations = 1 + settings.epochs // settings.archive_every
        matches, evaluated = settings.population, settings.eval_episodes
    else:
        generations = 1 + settings.generations
        # In a hall-of-fame race both teams meet each other and their own samples of the archive.
        met = (
            settings.contemporaries + 2 * settings.hall_sample
            if settings.schedule == HALL_OF_FAME
            else settings.opponents
        )
        matches, evaluated = settings.population * met, generations**2 * settings.eval_episodes
    episodes = matches * settings.worlds
    needed = {
        "candidates": COPIES * settings.population * genome,
        "archive": teams * generations * genome,
        "episodes": EPISODE_BYTES * max(episodes, evaluated),
    }
    learner = settings.built_in_learner
    if learner is not None and learner.by_gradients:
        world = settings.world(settings.train_steps)
        transitions = episodes * settings.train_steps * max(world.n_pursuers, world.n_evaders)
        needed["views"] = COPIES * transitions * settings.network.sizes[0]
    return needed
