"""Genomes as files: written, read, and refused."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from matrixworld._util.reading import DamagedFileError
from matrixworld.classroom import load_genome, save_genome
from matrixworld.play import NetworkPolicy
from matrixworld.world.policy import Network


@pytest.mark.parametrize(
    "network",
    [
        Network(),
        Network((), fov=3),
        Network((7, 5), activation="tanh", fov=5, n_actions=9, sampled=False),
    ],
)
def test_a_genome_is_read_as_it_was(network: Network, tmp_path: Path) -> None:
    policy = NetworkPolicy(network, network.initial(np.random.default_rng(1)))
    save_genome(tmp_path / "a.npz", "evader", policy)
    team, population = load_genome(tmp_path / "a.npz")
    assert (team, population.network) == ("evader", network)
    np.testing.assert_array_equal(population.genomes[0], policy.genome)


def test_numpy_writes_such_a_file_too(tmp_path: Path) -> None:
    network = Network((4,), fov=3)
    genome = network.initial(np.random.default_rng(0))
    np.savez_compressed(
        tmp_path / "a.npz", genome=genome, hidden=[4], activation="relu", fov=3, n_actions=5,
        sampled=True, team="pursuer",
    )  # fmt: skip
    assert load_genome(tmp_path / "a.npz")[1].network == network


def test_another_team_is_refused_before_a_file_is_made(tmp_path: Path) -> None:
    network = Network((), fov=1)
    policy = NetworkPolicy(network, np.zeros(network.genome_size, np.float32))
    with pytest.raises(ValueError, match="team: expected one of pursuer, evader, got 'both'"):
        save_genome(tmp_path / "a.npz", "both", policy)  # type: ignore[arg-type]
    assert list(tmp_path.iterdir()) == []


def test_an_altered_genome_is_refused(tmp_path: Path) -> None:
    (tmp_path / "a.npz").write_bytes(b"PK\x05\x06")
    with pytest.raises(DamagedFileError, match="not an npz file"):
        load_genome(tmp_path / "a.npz")
