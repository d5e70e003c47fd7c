"""Files are complete or refused: atomic writes and checksums."""

from __future__ import annotations

import os

import numpy as np
import pytest

from matrixworld import files
from matrixworld.files import DamagedFileError


def test_arrays_come_back(tmp_path):
    arrays = {"a": np.arange(6.0).reshape(2, 3), "text": np.array("abc"), "none": np.zeros((0, 4))}
    files.save_arrays(tmp_path / "x.npz", arrays)
    back = files.load_arrays(tmp_path / "x.npz")
    assert back.keys() == arrays.keys()
    for name, array in arrays.items():
        assert back[name].dtype == array.dtype
        assert np.array_equal(back[name], array)
    with np.load(tmp_path / "x.npz", allow_pickle=False) as plain:
        assert np.array_equal(plain["a"], arrays["a"])


def test_objects_are_not_pickled(tmp_path):
    with pytest.raises(TypeError, match="things: expected numbers or text"):
        files.save_arrays(tmp_path / "x.npz", {"things": np.array([{}])})
    assert not list(tmp_path.iterdir())


def saved_arrays(path):
    files.save_arrays(path, {"a": np.arange(4.0)})
    return files.load_arrays


def saved_json(path):
    files.save_json(path, {"a": [1, 2.5], "b": "text"})
    return files.load_json


@pytest.mark.parametrize("save", [saved_arrays, saved_json])
def test_every_cut_is_refused(tmp_path, save):
    path = tmp_path / "x"
    load = save(path)
    whole = path.read_bytes().rstrip()
    for length in range(len(whole)):
        path.write_bytes(whole[:length])
        with pytest.raises(DamagedFileError, match=r"x: (cut|altered)"):
            load(path)


@pytest.mark.parametrize("save", [saved_arrays, saved_json])
def test_every_altered_byte_is_refused(tmp_path, save):
    path = tmp_path / "x"
    load = save(path)
    whole = path.read_bytes()
    for position, byte in enumerate(whole):
        if byte > ord(" ") or save is saved_arrays:  # white space carries no content in JSON
            path.write_bytes(whole[:position] + bytes([byte ^ 0x11]) + whole[position + 1 :])
            with pytest.raises(DamagedFileError, match=r"x: (cut|altered)"):
                load(path)


def test_failed_write_leaves_the_old_file(tmp_path, monkeypatch):
    path = tmp_path / "x.json"
    files.save_json(path, {"a": 1})

    def full(handle):
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(os, "fsync", full)
    with pytest.raises(OSError, match="No space left"):
        files.save_json(path, {"a": 2})
    assert files.load_json(path) == {"a": 1}
    assert [item.name for item in tmp_path.iterdir()] == ["x.json"]


def test_a_file_is_kept_under_another_name_when_it_is_replaced(tmp_path):
    path, previous = tmp_path / "x", tmp_path / "x.previous"
    for content in (b"first", b"second", b"third"):
        with files.replacing(path, keep_as=previous) as file:
            file.write(content)
    assert path.read_bytes() == b"third"
    assert previous.read_bytes() == b"second"


def test_an_error_while_writing_leaves_no_file(tmp_path):
    def interrupted():
        with files.replacing(tmp_path / "x") as file:
            file.write(b"half")
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        interrupted()
    assert not list(tmp_path.iterdir())
