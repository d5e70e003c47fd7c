"""Files are complete or refused: atomic writes, and damage that is found."""

import os
import stat
import sys
from pathlib import Path

import numpy as np
import pytest

import matrixworld as mw
from matrixworld import analysis
from matrixworld._util import files
from matrixworld._util.files import DamagedFileError
from rows import archive

unix = pytest.mark.skipif(sys.platform == "win32", reason="needs links and permissions")


def damaged(whole):
    """Yield every cut of a file's content, and the content with each byte altered."""
    yield from (whole[:length] for length in range(len(whole)))
    for position, byte in enumerate(whole):
        for pattern in (1, 128, 255):
            yield whole[:position] + bytes([byte ^ pattern]) + whole[position + 1 :]


def held(arrays):
    return {name: (each.dtype, each.shape, each.tobytes()) for name, each in arrays.items()}


def test_no_cut_or_altered_byte_changes_arrays(tmp_path):
    """Also in the directory of the archive, where a wrong length could make an array disappear."""
    path, refused = tmp_path / "x", 0
    arrays = {"genomes": np.ones((1, 5), np.float32), "log": b"a,b", "matches": 3, "steps": 0.5}
    files.save_arrays(path, arrays)
    expected, whole = held(files.load_arrays(path)), path.read_bytes()
    for content in damaged(whole):
        path.write_bytes(content)
        try:
            # Zip does not count what it has beside the content, such as the time of writing.
            assert held(files.load_arrays(path)) == expected
        except DamagedFileError as error:
            assert "x: " in str(error)  # noqa: PT017, it may be harmless as well
            refused += 1
    assert refused > len(whole) + 200


@pytest.mark.parametrize(
    ("content", "problem"),
    [
        (b"", "File is not a zip file"),
        (
            archive({"a": b"text"}).replace(b"PK\1\2\24\3\24\0\0", b"PK\1\2\24\3\24\0\1"),
            "is encrypted",
        ),
        (archive({"a.npy": b"\x93NUMPY\1\0\4\0(((("}), "EOF in multi-line statement"),
        (archive({"a": bytes(2**27)}), "expected at most .* bytes in it, got 134,217,728"),
    ],
)
def test_an_archive_that_is_none_is_refused_in_a_line(tmp_path, content, problem):
    (tmp_path / "x").write_bytes(content)
    with pytest.raises(DamagedFileError, match=rf"^\S*x: cut, altered or not an npz .*{problem}"):
        files.load_arrays(tmp_path / "x")


def test_every_cut_of_json_is_refused(tmp_path):
    path = tmp_path / "x"
    files.save_json(path, {"a": [1, 2.5], "b": "text"})
    whole = path.read_bytes().rstrip()
    for length in range(len(whole)):
        path.write_bytes(whole[:length])
        with pytest.raises(DamagedFileError, match=r"x: (cut|altered)"):
            files.read_json(path)


def test_failed_write_leaves_the_old_file(tmp_path, monkeypatch):
    path = tmp_path / "x.json"
    files.save_json(path, {"a": 1})

    def full(handle):
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(os, "fsync", full)  # disks often say so only now
    with pytest.raises(OSError, match="No space left"):
        files.save_json(path, {"a": 2})
    assert files.read_json(path) == {"a": 1}
    assert [item.name for item in tmp_path.iterdir()] == ["x.json"]


def test_objects_are_not_pickled(tmp_path):
    with pytest.raises(TypeError, match="things: expected"):
        files.save_arrays(tmp_path / "x.npz", {"things": np.array([{}])})
    assert not list(tmp_path.iterdir())


@unix
@pytest.mark.parametrize("made", [Path.mkdir, os.mkfifo, lambda path: path.symlink_to("other")])
def test_only_regular_files_are_replaced(tmp_path, made):
    made(tmp_path / "x")
    with pytest.raises(FileExistsError, match="x: expected"):
        files.save_json(tmp_path / "x", {"a": 1})
    assert os.listdir(tmp_path) == ["x"]


@unix
def test_permissions_are_those_of_a_plain_open_or_of_the_replaced_file(tmp_path):
    (tmp_path / "y").touch()
    files.save_json(tmp_path / "x", {"a": 1})
    assert (tmp_path / "x").stat().st_mode == (tmp_path / "y").stat().st_mode
    (tmp_path / "x").chmod(0o755)
    files.save_json(tmp_path / "x", {"a": 2})
    assert stat.S_IMODE((tmp_path / "x").stat().st_mode) == 0o755


READERS = {
    "x.map": mw.read_map,
    "x.json": files.read_json,
    "x.csv": analysis.read_payoffs,
    "x.npz": mw.Episode.load,
}


@pytest.mark.parametrize("content", [None, b"", b"\xff\xfe\x00{", b"PK\x05\x06" + bytes(18)])
@pytest.mark.parametrize("name", READERS)
def test_a_file_that_cannot_be_read_is_refused_by_its_name(tmp_path, name, content):
    path = tmp_path / name
    path.mkdir() if content is None else path.write_bytes(content)
    with pytest.raises(ValueError, match=f"{name}: "):
        READERS[name](path)
