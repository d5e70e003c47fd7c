"""Genomes as files: written and read, and whatever else a stranger may hand in is refused."""

import io
import json
import os
import signal
import struct
import sys
import tracemalloc
import zipfile
from collections.abc import Callable, Iterator, Mapping
from contextlib import suppress
from pathlib import Path

import numpy as np
import pytest

from class_tournament.submissions import (
    MOST_OWN,
    MOST_UNPACKED,
    read_file,
    read_genome,
    read_submissions,
)
from class_tournament.votes import count_votes
from course import predict
from course.questions import EDITION
from matrixworld.coevolution import DamagedFileError
from matrixworld.play import NetworkPolicy, save_genome
from matrixworld.play.policies import acting
from matrixworld.world.policy import Network, Population
from matrixworld.world.rating import Rating

LITTLE_MEMORY = 100 * 2**20
SECONDS = 20

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="needs FIFOs")


def load(path: Path) -> tuple[str, Population]:
    return read_genome(path, read_file(path)[1])


@pytest.mark.parametrize(
    "policy",
    [
        Network(),
        Network((), fov=3),
        Network((7, 5), activation="tanh", fov=5, n_actions=9, sampled=False),
        Network((3,), fov=3, memory="gru"),
        Rating(),
        Rating(("room", "ahead"), (4,), mask="none", fov=5, n_actions=9),
    ],
)
def test_a_genome_is_read_as_it_was(policy: Network | Rating, tmp_path: Path) -> None:
    acts = acting(policy, policy.initial(np.random.default_rng(1)))
    save_genome(tmp_path / "a.npz", "evader", acts)
    team, population = load(tmp_path / "a.npz")
    assert (team, population.policy) == ("evader", policy)
    np.testing.assert_array_equal(population.genomes[0], acts.genome)


def test_names_of_learning_platforms_become_those_of_students(tmp_path: Path) -> None:
    """Unless two students would have one name."""
    files = {
        "Anna Müller_1203_assignsubmission_file_/mine.py": "Anna Müller",
        "Bo_Li_1204_assignsubmission_file_hunt.py": "Bo_Li",
        "carterdee_LATE_10234_889231_pursue-2.py": "carterdee",
        "carterdee_10234_889232_evade.py": "carterdee",
        "300412-91823 - Dan O'Hara - Nov 20, 2026 1012 AM/a.npz": "Dan O'Hara",
        "Project 2_eve17_attempt_2026-11-20-10-12-59_e.py": "eve17",
        "Fay Ng_1300_assignsubmission_file_/a.py": "Fay Ng_1300_assignsubmission_file_",
        "Fay Ng_1301_assignsubmission_file_/a.py": "Fay Ng_1301_assignsubmission_file_",
        "run_2_3_best.py": "run_2_3_best",
        "gus.py": "gus",
        "gus.npz": "gus",
    }
    for file in files:
        (tmp_path / file).parent.mkdir(exist_ok=True)
        (tmp_path / file).write_text("")
    submissions, refusals = read_submissions(tmp_path)
    assert {each.file: each.name for each in submissions} == files
    assert refusals == []


def test_a_directory_that_cannot_be_read_is_refused_by_its_name(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    for name in ("Ann Lee/deeper", "closed", "full"):
        (tmp_path / name).mkdir(parents=True)
    (tmp_path / "Ann Lee/a.py").touch()
    for number in range(MOST_OWN + 1):
        (tmp_path / "full" / f"{number}.py").touch()
    listed = os.scandir

    def scandir(path: Path) -> object:
        if path.name == "closed":
            raise PermissionError(13, "Permission denied")
        return listed(path)

    monkeypatch.setattr(os, "scandir", scandir)
    submissions, refusals = read_submissions(tmp_path)
    assert [each.file for each in submissions] == ["Ann Lee/a.py"]
    assert [(each.name, each.file, each.reason) for each in refusals] == [
        ("Ann Lee", "Ann Lee/deeper", "expected a file, got a directory"),
        ("closed", "closed", "cannot be read: Permission denied"),
        ("full", "full", "expected at most 20 files, got more"),
    ]


NOT_FILES: dict[str, Callable[[Path], Path | None]] = {
    "a FIFO": os.mkfifo,
    "a directory": Path.mkdir,
    "a symbolic link": lambda path: path.symlink_to("/dev/zero"),
    "a device": lambda path: Path("/dev/zero"),
}
"""Makes one under a name, or returns the path of one."""


@pytest.fixture(autouse=True)
def little_memory_and_time() -> Iterator[None]:
    """Fail instead of waiting for ever, or of taking all memory."""

    def late(number: int, frame: object) -> None:
        raise TimeoutError(f"expected an answer within {SECONDS} seconds")

    before = signal.signal(signal.SIGALRM, late)
    signal.alarm(SECONDS)
    tracemalloc.start()
    yield
    assert tracemalloc.get_traced_memory()[1] < LITTLE_MEMORY
    tracemalloc.stop()
    signal.alarm(0)
    signal.signal(signal.SIGALRM, before)


@pytest.mark.parametrize("found", NOT_FILES)
def test_what_is_no_file_is_not_opened(found: str, tmp_path: Path) -> None:
    path = NOT_FILES[found](tmp_path / "a.npz") or tmp_path / "a.npz"
    with pytest.raises(DamagedFileError, match=f"expected a file, got {found}$"):
        read_file(path)


# Archives that would expand, claim, or run something:


def npy(shape: object, dtype: str = "<f4", data: bytes = b"") -> bytes:
    """Return an npy file whose header claims a shape and a dtype."""
    text = f"{{'descr': {dtype!r}, 'fortran_order': False, 'shape': {shape}, }}"
    header = text.encode().ljust(117) + b"\n"
    return b"\x93NUMPY\x01\x00" + struct.pack("<H", len(header)) + header + data


def npz(members: Mapping[str, bytes], compression: int = zipfile.ZIP_DEFLATED) -> bytes:
    """Return an npz file of npy files."""
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w", compression, compresslevel=1) as archive:
        for member, content in members.items():
            archive.writestr(f"{member}.npy", content)
    return buffer.getvalue()


ARCHIVES: dict[str, tuple[bytes, str]] = {
    "empty": (b"", "not an npz file"),
    "begin of an archive": (b"PK\x05\x06", "not an npz file"),
    "zip bomb": (
        npz({"genome": npy((MOST_UNPACKED // 4,), data=bytes(MOST_UNPACKED))}),
        f"expected arrays of at most {MOST_UNPACKED:,} bytes",
    ),
    "header of 8 TB": (npz({"genome": npy((2 * 10**12,))}), "expected 0 bytes of numbers"),
    "header of 10**60 numbers": (npz({"genome": npy((10**30, 10**30))}), "got dtype float32"),
    "negative size": (npz({"genome": npy((-2,), data=bytes(24))}), "expected 24 bytes"),
    "long header": (npz({"genome": npy("-" * 9000 + "1")}), "not an npz file"),
    "nothing but dimensions": (npz({"genome": npy((10**18,), "|V0")}), "got dtype"),
    "pickled": (npz({"genome": npy((1,), "|O", b"\x80\x04N.")}), "got dtype object"),
    "dates": (npz({"genome": npy((1,), "<M8[s]", bytes(8))}), "got dtype datetime64"),
    "not an array": (npz({"genome": b"text"}), "not an npz file"),
    "lzma": (npz({"genome": npy((2,), data=bytes(8))}, zipfile.ZIP_LZMA), "no compression"),
    "2,000 members": (npz({str(n): b"" for n in range(2_000)}), "expected at most 100 arrays"),
    "no members": (npz({}), "expected an array 'genome'"),
}


@pytest.mark.parametrize("name", ARCHIVES)
def test_archives_that_hold_no_genome(name: str, tmp_path: Path) -> None:
    content, reason = ARCHIVES[name]
    (tmp_path / "a.npz").write_bytes(content)
    with pytest.raises(DamagedFileError, match=reason) as caught:
        load(tmp_path / "a.npz")
    assert len(str(caught.value).splitlines()) == 1


@pytest.fixture(scope="module")
def genome(tmp_path_factory: pytest.TempPathFactory) -> bytes:
    """A file that holds a genome."""
    path, network = tmp_path_factory.mktemp("genome") / "a.npz", Network((2,), fov=1)
    policy = NetworkPolicy(network, np.zeros(network.genome_size, "f4"))
    save_genome(path, "pursuer", policy)
    return path.read_bytes()


def test_a_genome_with_altered_bytes_is_read_or_refused(genome: bytes, tmp_path: Path) -> None:
    """Also in headers and in the directory of the archive."""
    for seed in range(60):
        rng, content = np.random.default_rng(seed), bytearray(genome)
        for place in rng.integers(len(content), size=rng.integers(1, 4)):
            content[place] = rng.integers(256)
        (tmp_path / "a.npz").write_bytes(content)
        with suppress(DamagedFileError):  # any other error fails
            load(tmp_path / "a.npz")


# ---- Predictions ---------------------------------------------------------------------------------


def test_votes_are_the_first_choices_of_students(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """As `predict` writes them, in files that learning platforms pack; damaged ones are refused."""
    for student, choices in {"ada": "ab", "bo": "b", "cy": "c"}.items():
        (tmp_path / student).mkdir()
        monkeypatch.chdir(tmp_path / student)
        for choice in choices:
            predict("4.a", choice)
        predict("9.a", "a")
        predict("1.a", "c")
    bad = {
        "text": b"x", "list": b"[]", "deep": b"[" * 9000, "name": b'{"prediction": "4.a<b>"}',
        "choice": b'{"prediction": "4.a", "choice": 1}', "bytes": b"\xff\x00",
        "long": json.dumps({"prediction": "4.a", "choice": "a" * 61}).encode(),
        "lines": b'{"prediction": "4.a", "choice": "a\\nb"}', "large": b"{}\n" * 2**15,
    }  # fmt: skip
    for name, content in bad.items():
        (tmp_path / f"{name}.jsonl").write_bytes(content)
    (tmp_path / "old.jsonl").write_bytes(b'{"prediction": "4.a", "choice": "a"}')
    submissions, refused = read_submissions(tmp_path)
    assert [each.name for each in refused] == ["large"]
    votes, spoilt = count_votes((each.name, each.file, each.content) for each in submissions)
    old = spoilt.pop("old.jsonl")
    assert old == f"expected edition {EDITION} of the course, as in other files, got none"
    assert votes == {"1.a": {"c": 3}, "4.a": {"a": 1, "b": 1, "c": 1}, "9.a": {"a": 3}}
    assert spoilt.keys() == {f"{name}.jsonl" for name in bad if name != "large"}
    assert {*spoilt.values()} == {"line 1: expected a prediction and its choice"}
