"""Recorded episodes: arrays, files, and refused input."""

import dataclasses
import os
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from matrixworld._util.files import DamagedFileError
from matrixworld.episodes.episode import Episode
from rows import random_walks

EPISODE = random_walks()
ARRAYS = [name for name, value in vars(EPISODE).items() if isinstance(value, np.ndarray)]


def test_round_trip(tmp_path: Path) -> None:
    episode, path = EPISODE, tmp_path / "an episode"
    episode.save(path)
    loaded, written = Episode.load(path), path.read_bytes()
    assert (loaded.n_pursuers, loaded.config) == (episode.n_pursuers, episode.config)
    for name in ARRAYS:
        np.testing.assert_array_equal(getattr(loaded, name), getattr(episode, name))
        assert getattr(loaded, name).dtype == getattr(episode, name).dtype
    episode.save(path)
    assert path.read_bytes() == written
    assert os.listdir(tmp_path) == [path.name]
    with pytest.raises(ValueError, match=r"^path: expected a name that ends in \.npz, got .*gif"):
        episode.save(tmp_path / "x.gif")


@pytest.mark.parametrize(
    "changes",
    [
        {"format": np.array("payoffs 1")},
        {"payoff": np.zeros(3)},
        {"seat": np.array(99)},
        {"map": np.array([{}], object)},
        {"alive": np.zeros((30, 12), bool)},
        {"positions": None},
        {"config": np.array("[]")},
        {"n_pursuers": np.array([1, 2])},
    ],
)
def test_foreign_archives_are_refused(changes: dict[str, Any], tmp_path: Path) -> None:
    EPISODE.save(tmp_path / "foreign.npz")
    with np.load(tmp_path / "foreign.npz") as stored:
        changed = {**stored, **changes}
    entries = {name: each for name, each in changed.items() if each is not None}
    np.savez(tmp_path / "foreign.npz", **entries)
    with pytest.raises(DamagedFileError, match=r"foreign\.npz: "):
        Episode.load(tmp_path / "foreign.npz")


@pytest.mark.parametrize("name", ARRAYS)
def test_wrong_dtypes_and_shapes_are_refused(name: str) -> None:
    array = getattr(EPISODE, name)
    for wrong in (array.astype(complex), array.tolist()):
        with pytest.raises(TypeError, match=f"^{name}: expected an array of"):
            dataclasses.replace(EPISODE, **{name: wrong})
    with pytest.raises(ValueError, match="expected shape"):
        dataclasses.replace(EPISODE, **{name: array[None]})


def explained(*rows: tuple[int, ...]) -> Episode:
    return dataclasses.replace(EPISODE, conflict_table=np.array(rows, np.int32).reshape(-1, 11))


def test_conflicts_are_kept_in_files_and_told_by_step(tmp_path: Path) -> None:
    episode = explained(
        (4, 0, 1, 0, 0, 3, 2, 5, 3, 3, 0), (4, 0, 0, 0, 7, -1, -1, 3, 1, 0, 1), (9,) + (0,) * 10
    )
    episode.save(tmp_path / "kept.npz")
    for each in (episode, Episode.load(tmp_path / "kept.npz")):
        assert list(map(str, each.explain(4))) == [
            "pursuer_0 and pursuer_3 both headed for (2, 5): both bounce",
            "evader_2 ran into the obstacle or border at (-1, 3): evader_2 disappears",
        ]
        assert each.explain(4) == each.explain(-27)
        assert each.explain(5) == []
    assert explained().explain() == []
    with pytest.raises(ValueError, match="^conflict_table: expected a recording with conflicts"):
        EPISODE.explain(3)
