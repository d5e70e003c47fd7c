"""Files are complete or refused: atomic writes and checksums."""

import contextlib
import os
import secrets
import stat
import sys
from pathlib import Path

import numpy as np
import pytest

import matrixworld as mw
from matrixworld import analysis
from matrixworld._util import files
from matrixworld._util.files import DamagedFileError
from matrixworld.episodes import replay

unix = pytest.mark.skipif(sys.platform == "win32", reason="needs links and permissions")


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
def test_every_cut_and_every_altered_byte_is_refused(tmp_path, save):
    path = tmp_path / "x"
    load = save(path)
    whole = path.read_bytes().rstrip()
    damaged = [whole[:length] for length in range(len(whole))]
    damaged += [
        whole[:position] + bytes([byte ^ 0x11]) + whole[position + 1 :]
        for position, byte in enumerate(whole)
        if byte > ord(" ") or save is saved_arrays  # white space carries no content in JSON
    ]
    for content in damaged:
        path.write_bytes(content)
        with pytest.raises(DamagedFileError, match=r"x: (cut|altered)"):
            load(path)


def test_failed_write_leaves_the_old_file(tmp_path, monkeypatch):
    path = tmp_path / "x.json"
    files.save_json(path, {"a": 1})

    def full(handle):
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(os, "fsync", full)  # disks often say so only now
    with pytest.raises(OSError, match="No space left"):
        files.save_json(path, {"a": 2})
    assert files.load_json(path) == {"a": 1}
    assert [item.name for item in tmp_path.iterdir()] == ["x.json"]


def test_an_error_while_writing_leaves_no_file(tmp_path):
    def interrupted():
        with files.replacing(tmp_path / "x") as file:
            file.write(b"half")
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        interrupted()
    assert not list(tmp_path.iterdir())


# Names that are not those of regular files:


SMALL = mw.WorldConfig(rows=4, cols=4, n_pursuers=1, n_evaders=1, max_steps=2)
EPISODE = mw.record(SMALL, "chaser", "fleer", seed=1)
WRITERS = {
    "save_arrays": lambda path: files.save_arrays(path, {"a": np.arange(3.0)}),
    "save_json": lambda path: files.save_json(path, {"a": 1}),
    "Episode.save": EPISODE.save,
    "replay.save": lambda path: replay.save(EPISODE, path.with_suffix(".png")),
    "locked": lambda path: files.locked(path).__enter__(),
}


@unix
@pytest.mark.parametrize("writer", WRITERS)
@pytest.mark.parametrize("kind", ["link", "broken link", "FIFO", "directory", "device"])
def test_only_regular_files_are_replaced(tmp_path, writer, kind):
    path, other = tmp_path / "x.png", tmp_path / "other"
    other.write_bytes(b"mine")
    made = {
        "link": lambda: path.symlink_to(other),
        "broken link": lambda: path.symlink_to(tmp_path / "missing"),
        "FIFO": lambda: os.mkfifo(path),
        "directory": path.mkdir,
        "device": lambda: path.symlink_to(os.devnull),
    }
    made[kind]()
    got = {"FIFO": "a FIFO", "directory": "a directory"}.get(kind, "a symbolic link")
    with pytest.raises(FileExistsError, match=f"x.png: expected a file, got {got}"):
        WRITERS[writer](path)
    assert other.read_bytes() == b"mine"
    assert sorted(os.listdir(tmp_path)) == ["other", "x.png"]


@unix
@pytest.mark.parametrize("device", ["/dev/null", "/dev/stdout"])
def test_devices_are_not_replaced(device):
    before = os.lstat(device)
    with pytest.raises(FileExistsError, match=f"{device}: expected a file, got a "):
        EPISODE.save(device)
    assert os.lstat(device).st_ino == before.st_ino


# Temporary names:


@unix
def test_temporary_names_are_new_each_time_and_not_guessed(tmp_path):
    names = set()
    for _ in range(20):
        with files.replacing(tmp_path / "x") as file:
            # A name that could be guessed could be a link of somebody else.
            names.add(Path(file.name).name)
            assert files.is_temporary(Path(file.name).name)
            assert str(os.getpid()) not in Path(file.name).name.split(".")
    assert len(names) == 20


@unix
def test_a_link_with_the_temporary_name_is_not_followed(tmp_path, monkeypatch):
    other = tmp_path / "other"
    other.write_bytes(b"mine")
    monkeypatch.setattr(secrets, "token_hex", lambda size: "0" * 2 * size)
    with files.replacing(tmp_path / "x") as file:
        link = Path(file.name)
    link.symlink_to(other)
    with pytest.raises(FileExistsError, match="x"), files.replacing(tmp_path / "x"):
        pass
    assert other.read_bytes() == b"mine"
    assert link.is_symlink()


def test_a_name_of_the_greatest_length(tmp_path):
    # The temporary name may not be longer than 255.
    files.save_json(tmp_path / ("x" * 250), {"a": 1})
    assert files.load_json(tmp_path / ("x" * 250)) == {"a": 1}


@unix
@pytest.mark.parametrize("mask", [0o022, 0o077])
def test_permissions_are_those_of_a_plain_open(tmp_path, mask):
    before = os.umask(mask)
    try:
        files.save_json(tmp_path / "x", {"a": 1})
        (tmp_path / "y").touch()
    finally:
        os.umask(before)
    assert (tmp_path / "x").stat().st_mode == (tmp_path / "y").stat().st_mode


@unix
@pytest.mark.parametrize("mode", [0o600, 0o664, 0o755])
def test_permissions_of_a_replaced_file_are_kept(tmp_path, mode):
    files.save_json(tmp_path / "x", {"a": 1})
    (tmp_path / "x").chmod(mode)
    files.save_json(tmp_path / "x", {"a": 2})
    assert stat.S_IMODE((tmp_path / "x").stat().st_mode) == mode


@unix
def test_only_temporary_files_are_removed(tmp_path):
    kept = [".x.tmp.d", "x.tmp", ".hidden"]
    for name in [*kept, ".a.tmp", ".archive.npz.123.tmp"]:
        (tmp_path / name).touch()
    (tmp_path / ".directory.tmp").mkdir()
    (tmp_path / ".link.tmp").symlink_to(tmp_path / "x.tmp")
    files.remove_temporary_files(tmp_path)
    assert sorted(os.listdir(tmp_path)) == sorted([*kept, ".directory.tmp"])


# Files that are no files, or damaged:


def pickled(path):
    np.savez(path.with_suffix(".npz"), capture_rates=np.array([{}], dtype=object))
    path.with_suffix(".npz").replace(path)


BAD = {
    "directory": Path.mkdir,
    "FIFO": os.mkfifo if sys.platform != "win32" else Path.mkdir,
    "device": lambda path: path.symlink_to("/dev/zero"),  # reading it would never end
    "empty": Path.touch,
    "text": lambda path: path.write_bytes(b"\xff\xfe\x00{"),
    "nested": lambda path: path.write_bytes(b'{"a": ' + b"[" * 100_000 + b"]" * 100_000 + b"}"),
    "zip": lambda path: path.write_bytes(b"PK\x05\x06" + bytes(18)),
    "pickled": pickled,
}
READERS = {
    "read_map": ("x.map", mw.read_map),
    "read_json": ("x.json", files.read_json),
    "read_payoffs of csv": ("x.csv", analysis.read_payoffs),
    "read_payoffs of npz": ("x.npz", analysis.read_payoffs),
    "Episode.load": ("x.npz", mw.Episode.load),
}


@unix
@pytest.mark.parametrize("bad", BAD)
@pytest.mark.parametrize("reader", READERS)
def test_a_file_that_cannot_be_read_is_refused_by_its_name_in_one_line(tmp_path, reader, bad):
    name, read = READERS[reader]
    BAD[bad](tmp_path / name)
    with pytest.raises(ValueError, match=f"{name}: ") as refused:
        read(tmp_path / name)
    assert len(str(refused.value).splitlines()) == 1


@pytest.mark.parametrize("seed", range(100))
def test_altered_archives_are_refused_or_read(tmp_path, seed):
    """Random bytes, also in headers and in the directory of the archive."""
    path, rng = tmp_path / "x.npz", np.random.default_rng(seed)
    np.savez(path, payoff=np.zeros((3, 3)))
    content = bytearray(path.read_bytes())
    for place in rng.integers(len(content), size=rng.integers(1, 4)):
        content[place] = rng.integers(256)
    path.write_bytes(bytes(content))
    with contextlib.suppress(DamagedFileError):
        files.read_npz(path)
