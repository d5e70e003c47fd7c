"""Policies outside of rollouts act as they do inside, with the same random numbers."""

import numpy as np
import pytest

import matrixworld as mw
from rows import config_of, random_team


@pytest.mark.parametrize("name", ["D", "SB", "TO", "agents-R"])
def test_worlds_of_a_batch_decide_as_single_worlds(name: str) -> None:
    """Each with the policy that was chosen for it, for any number of threads."""
    config = config_of(name, obstacles=0.1, max_steps=9)
    league = [
        "hunter",
        random_team(config, 1),
        None,
        random_team(config, 2, sampled=False),
        "random",
        random_team(config, 3, memory="gru"),
    ]
    n_worlds = 60  # ten for each of the league
    place = np.random.default_rng(0).integers(len(league), size=n_worlds)
    batches = [mw.Batch(n_worlds, config, threads=threads) for threads in (1, 3)]
    for batch in batches:
        batch.reset(5)
    agents = range(config.n_pursuers, config.n_agents)
    for _ in range(11):  # two steps more than an episode has
        expected = np.full((n_worlds, config.n_agents), 7)
        for world, row in enumerate(expected):
            if league[place[world]] is not None:
                batches[0].world(world).decide(league[place[world]], agents, row)
        for batch in batches:
            # No legal action: what is not written stays visible.
            actions = np.full_like(expected, 7)
            batch.decide(league, place, agents, actions)
            assert np.array_equal(actions, expected)
            assert (actions[:, : config.n_pursuers] == 7).all()
            batch.step(actions % 5)
    assert (expected == 7).all()  # nobody decides in an episode that has ended
