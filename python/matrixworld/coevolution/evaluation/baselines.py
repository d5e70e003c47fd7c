"""Scores of teams that were trained in another way, against the opponents of a race."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from matrixworld._util.checks import check_choice
from matrixworld.coevolution.evaluation.tournament import tournament
from matrixworld.coevolution.settings.single import SingleSettings
from matrixworld.coevolution.storage.saved_run import SavedRun
from matrixworld.coevolution.types import TEAMS, Team, other
from matrixworld.world.policy import Population, TeamPolicy


def scores_in_race(
    race: SavedRun,
    team: Team,
    policy: TeamPolicy,
    *,
    episodes: int | None = None,
    threads: int | None = None,
) -> NDArray[np.float64]:
    """Return the scores of a policy against each generation of a race's other team.

    Parameters
    ----------
    race : SavedRun
        A race.
    team : {"pursuer", "evader"}
        The team that the policy plays.
    policy : Population or str
        A population of one genome, or the name of a script.
    episodes : int, optional
        Episodes of each pair. By default as in the evaluation of the race.
    threads : int, optional
        Threads that play. By default all cores.

    Returns
    -------
    ndarray of float64, shape (generations,)
        Mean scores in [0, 1]: the capture rate for pursuers, 1 minus the capture rate for evaders.

    Raises
    ------
    ValueError
        If there is no such team, or the run is not a race.

    References
    ----------
    Sun et al. (2023), "MatrixWorld", arXiv:2307.14854: the baselines of its figure on
    generalization.
    """
    check_choice("team", team, TEAMS)
    settings = race.settings
    if isinstance(settings, SingleSettings):
        raise ValueError(f"race: expected a race, got a run of one team: {race.files.path}")
    rivals = race.teams[other(team)]
    sides = (policy, rivals) if team == "pursuer" else (rivals, policy)
    payoff = tournament(
        settings.world(settings.eval_steps),
        *sides,
        seed=settings.seed,
        episodes=episodes or settings.eval_episodes,
        threads=threads,
    )
    # A row or a column of generations.
    rates = payoff.capture_rate.ravel()
    return rates if team == "pursuer" else 1 - rates


def trained_team(run: SavedRun) -> tuple[Team, Population]:
    """Return the team that learned in a run of one team, and its last genome.

    Raises
    ------
    ValueError
        If both teams learned.
    """
    if not isinstance(run.settings, SingleSettings):
        raise ValueError(f"{run.files.path}: expected a run of one team, got a race")
    team = run.settings.team
    policy = run.teams[team]
    assert isinstance(policy, Population)  # the team that learned has genomes
    return team, Population(policy.genomes[-1:], policy.network)
