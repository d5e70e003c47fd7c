"""The benchmarks run and check their results; times are not tested."""

from importlib import import_module
from pathlib import Path

import pytest
from click.testing import CliRunner

FOLDER = Path(__file__).parents[2] / "benchmarks"
SHORT = ["--seconds", "0.001", "--repeats", "1"]
FEW = {
    "bench_rollouts": [*SHORT, "--rounds", "20"],
    "bench_peers": [*SHORT, "--rounds", "20", "--size", "2"],
    "bench_scaling": [*SHORT, "--largest", "100"],
    "bench_start": ["--repeats", "1"],
    "bench_learners": ["--quick", "--results", "learners"],
    "bench_libraries": [*SHORT, "--matches", "2000", "--calls", "200"],
}
"""Options of each script for a short run."""


def test_all_benchmarks_are_tested():
    assert sorted(FEW) == sorted(path.stem for path in FOLDER.glob("bench_*.py"))


@pytest.mark.nightly
@pytest.mark.parametrize("name", FEW)
def test_benchmark_runs(name, monkeypatch, tmp_path):
    monkeypatch.chdir(tmp_path)
    module = import_module(name)
    monkeypatch.setattr(module, "bind", lambda cores: None, raising=False)
    result = CliRunner().invoke(module.main, FEW[name])
    assert result.exception is None
    lines = result.output.splitlines()
    assert lines[1].startswith("|---")
    assert len(lines) > 7
