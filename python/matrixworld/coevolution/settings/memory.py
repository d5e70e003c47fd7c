"""Memory that a run needs, estimated from its settings before anything is made."""

from __future__ import annotations

from matrixworld._util.memory import EPISODE, NUMBER, check_memory, matches_memory
from matrixworld.coevolution.learners.actor_critic import CHUNK
from matrixworld.coevolution.learners.noise import table_size
from matrixworld.coevolution.learners.registry import starting_genomes
from matrixworld.coevolution.opponents.registry import HALL_OF_FAME
from matrixworld.coevolution.settings.race import RaceSettings
from matrixworld.coevolution.settings.single import SingleSettings
from matrixworld.world.policy import CHANNELS

SAMPLED, BRED, JOINT = 2, 8, 4
"""Arrays of all candidates of a team at one time, measured: samples of two epochs; populations of
both teams with parents and children; and so many more where both teams learn at once."""
OF_LEARNER = 8
"""Genomes that a learner holds besides: its mean, gradient, optimizer and temporary arrays."""
COPIES_OF_VIEWS = 3
"""Views: of each step, of all steps, and with those of the ends of episodes for the critic."""
PER_TRANSITION = 8
"""Numbers beside a view: action, reward, cost, value, return, advantages."""
LAYERS = 3
"""Arrays of each layer's size, measured: outputs, activations and their gradients."""
COPIES_OF_ARCHIVE = 3
"""The archive, measured: a list of genomes, the arrays that the evaluation plays, and in a resumed
run the content of the files."""


def run_memory(
    settings: RaceSettings | SingleSettings, threads: int | None = None
) -> dict[str, int]:
    """Return the estimated memory of a run, in bytes, by what needs it.

    Parameters
    ----------
    settings : RaceSettings or SingleSettings
        Settings of the run.
    threads : int, optional
        Threads that play. By default one per core.

    Returns
    -------
    dict of str to int
        ``candidates``: the genomes of an epoch, as often as the learner holds them at one time.
        ``learners``: tables of noise and the genomes beside the candidates, of each team that
        learns. ``archive``: all generations, `COPIES_OF_ARCHIVE` times. ``matches``: the
        statistics of all episodes of an epoch, with worlds and networks of each thread; or of
        the evaluation, if they need more. ``experience``: what agents saw in an epoch, and a
        chunk of it in the networks, of learners that learn from it.

    Notes
    -----
    Not counted: opponents that are read from another run, rows of the log, and what Python and the
    libraries need themselves, about 100 MB.
    """
    genome, teams = NUMBER * settings.network.genome_size, len(settings.learning_teams)
    table = NUMBER * table_size(settings.network.genome_size)
    entries = _generations(settings) * teams
    return {
        "candidates": settings.population * genome * _copies(settings),
        "learners": teams * (OF_LEARNER * genome + table),
        "archive": entries * genome * COPIES_OF_ARCHIVE,
        "matches": _matches(settings, threads),
        "experience": _experience(settings),
    }


def check_run_memory(settings: RaceSettings | SingleSettings, threads: int | None) -> None:
    """Raise OutOfMemoryError if a run needs more memory than this machine has available."""
    check_memory("run", run_memory(settings, threads))


def _experience(settings: RaceSettings | SingleSettings) -> int:
    """Return the bytes of an epoch's transitions; 0 for learners that learn from fitness."""
    entry = settings.built_in_learner
    if entry is None or not entry.by_gradients:
        return 0
    world = settings.world(settings.train_steps)
    teams = {"pursuer": world.n_pursuers, "evader": world.n_evaders}
    steps = _meetings(settings) * settings.worlds * settings.train_steps
    transitions = steps * max(teams[team] for team in settings.learning_teams)
    sizes = settings.network.sizes
    seen = transitions * (sizes[0] + NUMBER * PER_TRANSITION) * COPIES_OF_VIEWS
    states = steps * CHANNELS * world.rows * world.cols if settings.central_critic else 0
    return seen + states * COPIES_OF_VIEWS + min(transitions, CHUNK) * sum(sizes) * NUMBER * LAYERS


def _copies(settings: RaceSettings | SingleSettings) -> int:
    joint = isinstance(settings, RaceSettings) and settings.schedule == HALL_OF_FAME
    return (BRED if starting_genomes(settings) > 1 else SAMPLED) + JOINT * joint


def _generations(settings: RaceSettings | SingleSettings) -> int:
    """Return the entries of a team's archive at the end of a run."""
    if isinstance(settings, SingleSettings):
        return 1 + -(-settings.epochs // settings.archive_every)
    return 1 + settings.generations


def _matches(settings: RaceSettings | SingleSettings, threads: int | None) -> int:
    steps = max(settings.train_steps, settings.eval_steps)
    played = matches_memory(
        settings.world(steps),
        [settings.network] * 2,
        matches=_meetings(settings),
        worlds=settings.worlds,
        threads=threads,
    )
    return max(played, EPISODE * _other_episodes(settings))


def _meetings(settings: RaceSettings | SingleSettings) -> int:
    """Return the matches of one epoch."""
    if isinstance(settings, SingleSettings):
        return settings.population
    if settings.schedule == HALL_OF_FAME:
        # Both teams meet each other and their own sample of the hall of fame.
        return settings.population * (settings.contemporaries + 2 * settings.hall_sample)
    return settings.population * settings.opponents


def _other_episodes(settings: RaceSettings | SingleSettings) -> int:
    """Return the most episodes outside training whose statistics are held at one time."""
    if isinstance(settings, SingleSettings):
        return settings.eval_episodes
    met = _generations(settings)
    return max(
        met**2 * settings.eval_episodes,
        2 * met * settings.retention_episodes,
        settings.elites * _meetings(settings) // settings.population * settings.elite_episodes,
        (settings.archive_size + 1) * met * settings.archive_episodes,
    )
