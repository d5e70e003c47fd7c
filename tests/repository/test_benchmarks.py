"""The benchmarks run and check their results; times are not tested."""

from importlib import import_module
from pathlib import Path

import pytest
from click.testing import CliRunner

import compare_builds
import matrixworld as mw
from cluster_projection import Costs, makespan, table

FOLDER = Path(__file__).parents[2] / "benchmarks"
SHORT = ["--seconds", "0.001", "--repeats", "1"]
FEW = {
    "bench_worlds": SHORT,
    "bench_rollouts": [*SHORT, "--rounds", "20"],
    "bench_peers": [*SHORT, "--rounds", "20", "--size", "2"],
    "bench_scaling": [*SHORT, "--largest", "100", "--out", "scaling.png"],
    "bench_evolve": ["--generations", "1", "--epochs", "2"],
    "bench_solve": ["--repeats", "1"],
    "bench_actor_critic": ["--repeats", "1"],
    "bench_learners": ["--quick", "--results", "learners"],
}
"""Options of each script for a short run."""


def test_all_benchmarks_are_tested() -> None:
    assert sorted(FEW) == sorted(path.stem for path in FOLDER.glob("bench_*.py"))


@pytest.mark.nightly
@pytest.mark.parametrize("name", FEW)
def test_benchmark_runs(name: str, monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    if name == "bench_actor_critic":
        pytest.importorskip("torch", reason="PyTorch is not installed")
    monkeypatch.chdir(tmp_path)
    module = import_module(name)
    monkeypatch.setattr(module, "bind", lambda cores: None, raising=False)
    result = CliRunner().invoke(module.main, FEW[name])
    assert result.exception is None
    lines = result.output.splitlines()
    assert lines[1].startswith("|---")
    assert len(lines) > 7
    assert (tmp_path / "scaling.png").exists() == (name == "bench_scaling")


def test_a_build_gives_the_results_of_itself() -> None:
    build = str(Path(mw.__file__).parents[1])
    options = ["--rounds", "1", "--seconds", "0.01", "--only", "views, 64 worlds"]
    result = CliRunner().invoke(compare_builds.main, [build, build, *options])
    assert result.exception is None
    assert result.output.splitlines()[-1].startswith("| step and views, 64 worlds | ")


def test_the_projection_of_a_cluster_follows_from_its_costs() -> None:
    free = Costs(alone=0.0, in_a_row=0.0, first=0.0, race=10.0, bytes=1)
    assert makespan(10, 10.0, 5, free) == 20.0
    assert makespan(11, 10.0, 5, free) == 30.0
    # One scheduler hands out one task after the other, to however many workers.
    slow = Costs(alone=0.0, in_a_row=0.01, first=0.0, race=1.0, bytes=1)
    assert makespan(10_000, 1.0, 10_000, slow) == pytest.approx(101.0)
    measured = Costs(alone=0.0065, in_a_row=0.0071, first=0.0, race=119, bytes=4_040_000)
    page = (FOLDER.parent / "docs" / "cluster.md").read_text(encoding="utf-8")
    assert table(measured, (1, 10, 100), 32) in page
