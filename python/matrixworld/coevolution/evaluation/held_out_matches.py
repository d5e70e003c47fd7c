"""Matches against held-out opponents: the same episodes for whatever is scored."""

from __future__ import annotations

from collections.abc import Mapping
from concurrent.futures import Executor
from functools import partial
from typing import Any

import numpy as np

from matrixworld._util.teams import PLURALS
from matrixworld.coevolution import seeding
from matrixworld.coevolution.games.tournament import each_genome, play_blocks
from matrixworld.coevolution.progress import Progress, Report, silent
from matrixworld.coevolution.types import TEAMS, FloatArray, Team, team_size
from matrixworld.play.functions import Function
from matrixworld.play.matches import capture_rates
from matrixworld.play.player import Plays
from matrixworld.play.rollout import Matches, rollout
from matrixworld.world.config import WorldConfig


def play_held_out(
    config: WorldConfig,
    team: Team,
    policy: Plays,
    opponents: Mapping[str, Plays],
    *,
    episodes: int,
    seed: int,
    threads: int | None = None,
    report: Report = silent,
    executor: Executor | None = None,
) -> FloatArray:
    """Return the scores (G, N, episodes) of the G genomes of a team against N opponents.

    An `executor` plays the opponents side by side; `report` is called after each of them.
    """
    blocks = []
    for number, opponent in enumerate(opponents.values()):
        # The generation is not part of the key: all genomes play the same episodes.
        match = seeding.match_seed(seed, TEAMS.index(team), number, int(seeding.Phase.HELD_OUT))
        blocks.append(partial(_capture_rates, config, team, policy, opponent, match, episodes))
    scores = np.empty((team_size(policy), len(opponents), episodes))
    done = 0
    for number, captured in play_blocks(blocks, threads, executor):
        scores[:, number] = captured if team == "pursuer" else 1.0 - captured
        done += captured.size
        report(Progress(f"{PLURALS[team]} against held-out opponents", done, scores.size))
    return scores


def _capture_rates(
    config: WorldConfig,
    team: Team,
    policy: Plays,
    opponent: Plays,
    seed: int,
    episodes: int,
    *,
    threads: int | None,
) -> FloatArray:
    """Return the capture rates (G, episodes) of the genomes of a team against an opponent."""
    if isinstance(policy, Function) or isinstance(opponent, Function):
        rates = []
        for genome in each_genome(policy):
            teams = _in_order(team, genome, opponent)
            rates.append(capture_rates(config, *teams, seed=seed, episodes=episodes))
        return np.stack(rates)
    numbers = np.arange(team_size(policy))
    matches = Matches.of(*_in_order(team, numbers, 0), np.full(len(numbers), seed, np.uint64))
    teams = _in_order(team, policy, opponent)
    statistics = rollout(config, *teams, matches, episodes=episodes, threads=threads)
    return statistics.capture_rate.astype(np.float64)


def _in_order(team: Team, own: Any, others: Any) -> tuple[Any, Any]:
    """Return what is of a team and of its opponents as what is of pursuers and of evaders."""
    return (own, others) if team == "pursuer" else (others, own)
