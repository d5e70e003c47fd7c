"""Notebook 3: its match in plain Python."""

from __future__ import annotations

import numpy as np
import pytest

import matrixworld as mw
from notebooks import NOTEBOOKS, cells, source


@pytest.mark.parametrize("seed", range(3))
@pytest.mark.parametrize(
    "size", [{}, {"rows": 5, "cols": 5, "max_steps": 30}, {"n_pursuers": 1, "n_evaders": 9}]
)
def test_the_python_match_is_that_of_rollout(seed: int, size: dict) -> None:
    """For other networks and other worlds than those of the notebook."""
    fields = {"rows": 12, "cols": 12, "n_pursuers": 3, "n_evaders": 6, "fov": 5, "max_steps": 60}
    world = mw.WorldConfig("O", **{**fields, **size})
    network = mw.Network.for_config(world, (8,), sampled=False)
    names = {"world": world, "network": network, "np": np}
    for text in map(source, cells(NOTEBOOKS[2], "code")):
        if text.startswith(("SIDE", "def play(")):
            exec(text, names)
    genome = network.initial(np.random.default_rng(seed), 0.3, 0.5)
    team = mw.Population(genome, network)
    matches = mw.Matches.of(0, 0, np.arange(12))
    statistics = mw.rollout(world, team, "random", matches)
    captures = np.rint(statistics.capture_rate[:, 0] * world.n_evaders)
    for match in range(12):
        episode = mw.record(world, team, "random", seed=match)
        starts = [tuple(cell) for cell in episode.positions[0].tolist()]
        moves = episode.actions[:, world.n_pursuers :].tolist()
        found = names["play"](genome, starts, moves)
        assert found == (captures[match], statistics.length[match, 0])
