"""Scores of any policy against held-out opponents, such as one that learned elsewhere."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from matrixworld._util import checks
from matrixworld.coevolution.evaluation.held_out import opponents_of
from matrixworld.coevolution.evaluation.held_out_matches import play_held_out
from matrixworld.coevolution.evaluation.scores import EPISODES, SEED, HeldOutScores
from matrixworld.coevolution.progress import Report, silent
from matrixworld.coevolution.types import TEAMS, Team, other, team_size
from matrixworld.play.player import placed
from matrixworld.world.config import WorldConfig
from matrixworld.world.rules import Rules


def score_policy(
    policy: Any,
    team: Team,
    config: WorldConfig | Rules | str = "O",
    *,
    opponents: Mapping[str, Any] | None = None,
    episodes: int = EPISODES,
    seed: int = SEED,
    threads: int | None = None,
    report: Report = silent,
) -> HeldOutScores:
    """Play a policy of one team against every held-out opponent, as ``matrixworld score`` does.

    In the result the policy is generation 0; the genomes of a population are generations 0, 1, ...

    Parameters
    ----------
    policy : player
        What `matrixworld.player` takes, such as a function of views, a file or a population.
        Functions are asked in every step; what is no function is played inside the engine.
    team : {"pursuer", "evader"}
        Team that it plays for.
    config : WorldConfig, Rules or str, optional
        The world. The default is "O".
    opponents : mapping of str to player, optional
        N opponents by name, each of a single genome. By default the held-out opponents of the
        world's rules that fit its views and actions.
    episodes : int, optional
        Episodes against each opponent, at least 2, by default as many as `score` plays.
    seed, threads, report
        As in `score`.

    Returns
    -------
    HeldOutScores
        The scores of G genomes of the policy, 1 unless it is a population, against N opponents.

    Raises
    ------
    ValueError
        If a policy does not fit the world, a function fails or returns no actions, a name is
        unknown, or there are no opponents, or some of several genomes.
    TypeError
        If `policy` or an opponent cannot play.

    Notes
    -----
    The opponents, the episodes and the random numbers of scripts are those of `score`: with the
    same world, seed and number of episodes, scores of policies and of runs can be compared. Where
    the rules take turns, functions are played turn by turn in Python, which is slower.

    Examples
    --------
    >>> import matrixworld as mw
    >>> config = mw.WorldConfig("O", rows=8, cols=8, n_pursuers=3, n_evaders=3, max_steps=20)
    >>> scores = mw.score_policy(lambda seen: [1] * len(seen), "pursuer", config, episodes=4)
    >>> scores.opponents
    ('random', 'still', 'clumsy-fleer', 'fleer', 'dodger', 'evolved-1', 'evolved-2')
    """
    config = WorldConfig.of(config)
    checks.check_choice("team", team, TEAMS)
    episodes = checks.check_integer("episodes", episodes, 2)
    seed = checks.check_integer("seed", seed, 0, checks.SEED_MAX)
    checks.check_threads(threads)
    left_out = ""
    if opponents is None:
        opponents, left_out = opponents_of(team, config)
    checks.check_instance("opponents", opponents, Mapping)
    population = placed("policy", policy, team, config)
    rivals = {
        name: placed("opponents", each, other(team), config) for name, each in opponents.items()
    }
    if not rivals:
        raise ValueError("opponents: expected at least one, got none")
    for rival in rivals.values():
        if team_size(rival) > 1:
            raise ValueError(f"opponents: expected a single genome, got {team_size(rival)}")
    rates = play_held_out(
        config,
        team,
        population,
        rivals,
        episodes=episodes,
        seed=seed,
        threads=threads,
        report=report,
    )
    generations = tuple(range(team_size(population)))
    return HeldOutScores(team, generations, tuple(rivals), rates, left_out)
