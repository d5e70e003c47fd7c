"""Any policy is scored as ``matrixworld score`` scores the genomes of a run."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import matrixworld as mw
from matrixworld.coevolution import TEAMS, score_population
from rows import config_of


def genome_of(config: mw.WorldConfig, **fields: Any) -> mw.NetworkPolicy:
    network = mw.Network.for_config(config, (6,), **fields)
    genome = network.initial(np.random.default_rng(1), 0.5, 1.0)
    return mw.NetworkPolicy(network, genome, seed=0)


@pytest.mark.parametrize("team", TEAMS)
@pytest.mark.parametrize("name", ["O", "SB", "TO", "swarm-D"])
def test_a_function_has_the_scores_of_the_genome_that_it_plays(name: str, team: Any) -> None:
    config = config_of(name, obstacles=0.1, max_steps=12)
    policy = genome_of(config, sampled=False)
    calls = []

    def play(observations: np.ndarray) -> np.ndarray:
        calls.append(observations.shape)
        return policy(observations)

    scores = mw.score_policy(play, team, config, episodes=7, seed=3)
    expected = score_population(config, team, policy.population(), episodes=7, seed=3)
    assert np.array_equal(scores.rates, expected.rates)
    assert scores.opponents == expected.opponents
    assert scores.left_out == expected.left_out != ""
    assert scores.mean() == expected.mean()
    assert all(shape[1:] == (3, 5, 5) and shape[0] >= 1 for shape in calls)
    inside = mw.score_policy(policy, team, config, episodes=7, seed=3)
    assert np.array_equal(inside.rates, expected.rates)


def test_opponents_can_be_functions_and_policies() -> None:
    config = config_of("R")
    opponents = {"north": lambda seen: [1] * len(seen), "net": genome_of(config), "still": "still"}
    scores = mw.score_policy(genome_of(config), "pursuer", config, opponents=opponents, episodes=3)
    assert scores.opponents == ("north", "net", "still")
    assert scores.rates.shape == (1, 3, 3)


@pytest.mark.parametrize(
    ("arguments", "error", "message"),
    [
        ({"policy": 3}, TypeError, "policy: expected a function, a NetworkPolicy or a Population"),
        ({"team": "both"}, ValueError, "team: expected one of pursuer, evader, got 'both'"),
        ({"episodes": 1}, ValueError, "episodes: expected at least 2, got 1"),
        ({"seed": -1}, ValueError, "seed: expected 0 to"),
        ({"policy": lambda seen: 1}, ValueError, "actions of the policy: expected shape"),
        ({"opponents": {"mad": "mad"}}, ValueError, "opponents: expected one of random"),
        (
            {"opponents": {"big": genome_of(mw.WorldConfig("R"))}},
            ValueError,
            "evaders: expected a network for fov 5 and 5 actions, got fov 11",
        ),
        ({"opponents": {}}, ValueError, "opponents: expected at least one, got none"),
    ],
)
def test_wrong_arguments_are_refused(
    arguments: dict[str, Any], error: type[Exception], message: str
) -> None:
    given = {"policy": lambda seen: [0] * len(seen), "team": "pursuer", "episodes": 2}
    with pytest.raises(error, match=message):
        mw.score_policy(config=config_of("R"), **{**given, **arguments})


def test_the_package_is_imported_without_co_evolution() -> None:
    import subprocess
    import sys

    code = (
        "import sys, matrixworld as mw; mw.parallel_env('O', evaders='fleer'); "
        "assert 'matrixworld.coevolution' not in sys.modules; mw.score_policy; "
        "assert 'matrixworld.coevolution' in sys.modules; from matrixworld import score_policy"
    )
    subprocess.run([sys.executable, "-c", code], check=True)
