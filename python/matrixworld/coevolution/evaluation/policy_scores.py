"""Scores of any policy against held-out opponents: for policies that learned elsewhere."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from matrixworld._util.checks import SEED_MAX, check_choice, check_integer
from matrixworld.coevolution.evaluation.held_out_opponents import fitting_opponents
from matrixworld.coevolution.evaluation.held_out_scores import (
    HeldOutScores,
    held_out_seed,
)
from matrixworld.coevolution.progress import Report, silent
from matrixworld.coevolution.types import TEAMS, Team
from matrixworld.play import Callback, NetworkPolicy, Plays, capture_rates
from matrixworld.play.rollout import Matches, rollout
from matrixworld.world.config import WorldConfig
from matrixworld.world.policy import SCRIPTS, Population
from matrixworld.world.rules import Rules


def score_policy(
    policy: Callback | NetworkPolicy | Population,
    team: Team,
    config: WorldConfig | Rules | str = "O",
    *,
    opponents: Mapping[str, Plays] | None = None,
    episodes: int = 100,
    seed: int = 0,
    threads: int | None = None,
    report: Report = silent,
) -> HeldOutScores:
    """Play a policy of one team against every held-out opponent, as ``matrixworld score`` does.

    Parameters
    ----------
    policy : callable, NetworkPolicy or Population of one
        A function from observations, uint8 (n, 3, fov, fov), of n living agents of the team to
        their actions, integers (n,). The agents may be of several episodes. A network is played
        inside the engine.
    team : {"pursuer", "evader"}
        Team that it plays for.
    config : WorldConfig, Rules or str, optional
        The world. The default is "O".
    opponents : mapping of str to policy, optional
        N opponents by name. By default the held-out opponents of the world's rules that fit its
        views and actions.
    episodes : int, optional
        Episodes against each opponent, at least 2. The default is 100.
    seed : int, optional
        Seed of the episodes. The default is 0.
    threads : int, optional
        Threads of the engine. By default all cores. Results do not depend on it.
    report : callable, optional
        Called with the progress, as in `Run.run`.

    Returns
    -------
    HeldOutScores
        Scores of one policy, as generation 0, against N opponents.

    Raises
    ------
    ValueError, TypeError
        If there are fewer than 2 episodes, and if the policy returns something else than a legal
        action for each observation.

    Notes
    -----
    The opponents, the episodes and the random numbers of scripts are those of `score`: with the
    same world, seed and number of episodes, scores of policies and of runs can be compared. A
    function that chooses what a genome would choose gets the scores of the genome.

    All episodes against an opponent are played side by side. Where the rules take turns, they are
    played turn by turn in Python, which is slower.

    Examples
    --------
    >>> import matrixworld as mw
    >>> config = mw.WorldConfig("O", rows=8, cols=8, n_pursuers=3, n_evaders=3, max_steps=20)
    >>> scores = mw.score_policy(lambda seen: [1] * len(seen), "pursuer", config, episodes=4)
    >>> scores.opponents
    ('random', 'still', 'clumsy-fleer', 'fleer', 'dodger', 'evolved-1', 'evolved-2')
    """
    config = WorldConfig.of(config)
    check_choice("team", team, TEAMS)
    check_integer("episodes", episodes, 2)
    check_integer("seed", seed, 0, SEED_MAX)
    left_out = ""
    if opponents is None:
        opponents, left_out = fitting_opponents(team, config)
    mine = _plays(policy)
    theirs = {name: _plays(opponent) for name, opponent in opponents.items()}
    if not theirs:
        raise ValueError("opponents: expected at least one, got none")
    for opponent in theirs.values():
        if isinstance(opponent, str):
            check_choice("opponents", opponent, SCRIPTS)
    columns: list[NDArray[np.float64]] = []
    for number, opponent in enumerate(theirs.values()):
        match = held_out_seed(seed, team, number)
        sides = (mine, opponent) if team == "pursuer" else (opponent, mine)
        captured = _captured(config, *sides, seed=match, episodes=episodes, threads=threads)
        columns.append(captured if team == "pursuer" else 1.0 - captured)
        report(f"{team}s against held-out opponents", len(columns), len(opponents))
    return HeldOutScores(team, (0,), tuple(opponents), np.stack(columns)[None], left_out)


def _captured(
    config: WorldConfig,
    pursuers: Plays,
    evaders: Plays,
    *,
    seed: int,
    episodes: int,
    threads: int | None,
) -> NDArray[np.float64]:
    """Return the capture rate of each episode of a match, played by the engine if it can."""
    if callable(pursuers) or callable(evaders):
        return capture_rates(config, pursuers, evaders, seed=seed, episodes=episodes)
    match = Matches.of(0, 0, np.uint64(seed))
    scores = rollout(config, pursuers, evaders, match, episodes=episodes, threads=threads)
    return np.asarray(scores.capture_rate[0], np.float64)


def _plays(policy: Plays | NetworkPolicy) -> Plays:
    """Return a policy in the form that is played."""
    if isinstance(policy, NetworkPolicy):
        return policy.population()
    if isinstance(policy, Population) and len(policy.genomes) != 1:
        raise ValueError(f"policy: expected a single genome, got {len(policy.genomes)}")
    if callable(policy) or isinstance(policy, Population | str):
        return policy
    raise TypeError(f"policy: expected a function, a NetworkPolicy or a Population, got {policy!r}")
