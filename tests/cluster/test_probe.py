"""What a process must have to share work, without a cluster."""

from dataclasses import replace
from pathlib import Path

import pytest

import matrixworld as mw
from killed import CONTEXT, start_server
from matrixworld.cluster import probe
from matrixworld.cluster.probe import Probe, posted, traits_here


def answer(asked: Probe) -> str:
    """The problem of another process."""
    start_server()
    with CONTEXT.Pool(1) as pool:
        return str(pool.apply(asked.problem))


def test_a_process_like_this_one_is_fit(tmp_path: Path) -> None:
    with posted(None, same_processors=True) as asked:
        assert asked.problem() == ""
    with posted(tmp_path, same_processors=True) as asked:
        assert answer(asked) == ""


@pytest.mark.parametrize(
    ("trait", "problem"),
    [
        ("version", "it has another version of matrixworld (expected other, got "),
        ("code", "it has other Python code of matrixworld (expected other, got "),
        ("engine", "it has another engine fingerprint (expected other, got "),
        ("numpy", "it has another version of NumPy (expected other, got "),
    ],
)
def test_other_traits_are_named(trait: str, problem: str) -> None:
    traits = {**traits_here(), trait: "other"}
    assert Probe(traits).problem().startswith(problem)


def test_processors_matter_only_where_results_depend_on_them() -> None:
    traits = {**traits_here(), "algebra": "openblas 0.3.7 Z80"}
    assert Probe(traits).problem() == ""
    assert "CMA-ES" in Probe(traits, same_processors=True).problem()


def test_the_fingerprint_changes_with_what_the_engine_does(monkeypatch: pytest.MonkeyPatch) -> None:
    before = probe.engine_fingerprint()

    def crowded(variant: str, **options: object) -> mw.WorldConfig:
        # As if the engine drew other obstacles.
        return mw.WorldConfig(variant, **{**options, "obstacles": 0.2})

    monkeypatch.setattr(probe, "WorldConfig", crowded)
    assert probe.engine_fingerprint() != before
    monkeypatch.undo()
    assert probe.engine_fingerprint() == before


def test_files_must_be_shared(tmp_path: Path) -> None:
    with posted(tmp_path / "seen") as asked:
        assert asked.sign is not None
        elsewhere = replace(asked, sign=tmp_path / "unseen" / asked.sign.name)
        problem = (
            f"it does not see the files in {tmp_path / 'unseen'}; the directory must be shared"
        )
        assert elsewhere.problem() == problem
        assert replace(asked, token="another").problem().startswith("it does not see")
    # The block has ended: another start has another file.
    assert asked.problem().startswith("it does not see")


def test_locks_must_hold(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    with posted(tmp_path) as asked:
        monkeypatch.setattr("matrixworld._util.files._lock", lambda handle: None)
        assert asked.problem().startswith(f"locks in {tmp_path} do not hold")

        def unsupported(handle: int) -> None:
            raise OSError(95, "Operation not supported")

        monkeypatch.setattr("matrixworld._util.files._lock", unsupported)
        expected = f"it cannot lock files in {tmp_path} (Operation not supported)"
        assert asked.problem() == expected


def test_nothing_is_left_behind(tmp_path: Path) -> None:
    new, used = tmp_path / "a" / "b", tmp_path / "used" / "c"
    with posted(new):
        [sign] = new.iterdir()
        assert sign.name.startswith(".")
    assert not (tmp_path / "a").exists()
    with posted(used):
        (used / "file").touch()
    assert [path.name for path in used.iterdir()] == ["file"]
