"""Scores of any policy against held-out opponents, such as one that learned elsewhere."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from matrixworld._util import checks
from matrixworld.coevolution.evaluation.held_out import opponents_of
from matrixworld.coevolution.evaluation.held_out_matches import play_held_out
from matrixworld.coevolution.evaluation.scores import EPISODES, SEED, HeldOutScores
from matrixworld.coevolution.progress import Report, silent
from matrixworld.coevolution.types import TEAMS, Team, team_size
from matrixworld.play.matches import Plays
from matrixworld.play.policies import GenomePolicy
from matrixworld.world.config import WorldConfig
from matrixworld.world.policy import SCRIPTS, Population, TablePolicy
from matrixworld.world.rules import Rules


def score_policy(
    policy: Plays | GenomePolicy,
    team: Team,
    config: WorldConfig | Rules | str = "O",
    *,
    opponents: Mapping[str, Plays | GenomePolicy] | None = None,
    episodes: int = EPISODES,
    seed: int = SEED,
    threads: int | None = None,
    report: Report = silent,
) -> HeldOutScores:
    """Play a policy of one team against every held-out opponent, as ``matrixworld score`` does.

    In the result the policy is generation 0; the genomes of a population are generations 0, 1, ...

    Parameters
    ----------
    policy : callable, NetworkPolicy, RatingPolicy, Population, TablePolicy or str
        A function from observations, uint8 (n, 3, fov, fov), of n living agents of the team to
        their actions, integers (n,); or from the observation of one agent to its action. The agents
        may be of several episodes. What is no function is played inside the engine, such as a table
        of `solver.Solution.policy` or a script by its name.
    team : {"pursuer", "evader"}
        Team that it plays for.
    config : WorldConfig, Rules or str, optional
        The world. The default is "O".
    opponents : mapping of str to policy, optional
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
        If a policy does not fit the world, a function returns no legal actions, a script is
        unknown, or there are no opponents, or some of several genomes.
    TypeError
        If `policy` or an opponent cannot play, or a function returns no integers.

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
    population = _playable("policy", policy)
    rivals = {name: _playable("opponents", each) for name, each in opponents.items()}
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


def _playable(name: str, policy: Any) -> Plays:
    """Return a policy in the form that is played: that of a genome as a population of one."""
    if isinstance(policy, GenomePolicy):
        return policy.population()
    if isinstance(policy, str):
        checks.check_choice(name, policy, SCRIPTS)
    elif not callable(policy) and not isinstance(policy, Population | TablePolicy):
        expected = (
            "a function, a NetworkPolicy, RatingPolicy, Population or TablePolicy, or the name of "
            "a script"
        )
        raise TypeError(f"{name}: expected {expected}, got {checks.shown(policy)}")
    playable: Plays = policy
    return playable
