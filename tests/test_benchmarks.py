"""The benchmarks run, and assert their answers; how fast is not looked at."""

from __future__ import annotations

import importlib.util
import sys
from pathlib import Path

import pytest
from click.testing import CliRunner

BENCHMARKS = sorted((Path(__file__).parents[1] / "benchmarks").glob("bench_*.py"))


@pytest.mark.parametrize("path", BENCHMARKS, ids=[path.stem for path in BENCHMARKS])
def test_benchmark_runs(path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    spec = importlib.util.spec_from_file_location(path.stem, path)
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    monkeypatch.setitem(sys.modules, path.stem, module)  # dataclasses look their module up
    spec.loader.exec_module(module)
    monkeypatch.setattr(module, "bind", lambda cores: None)
    monkeypatch.setattr(module.os, "sched_setaffinity", lambda *given: None, raising=False)
    result = CliRunner().invoke(module.main, ["--seconds", "0.001", "--repeats", "1"])
    assert result.exception is None
    lines = result.output.splitlines()
    assert lines[1].startswith("|---")
    assert len(lines) > 7
