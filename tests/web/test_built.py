"""The built engine is that of the sources: its digest, its tables and its fingerprint."""

from __future__ import annotations

import runpy
import shutil
import subprocess
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

import matrixworld as mw
from matrixworld.world.arrays import WORLD_FIELDS
from node import policy_json, run_node
from rows import random_actions, random_genome

ROOT = Path(__file__).parents[2]


def program(file: str) -> SimpleNamespace:
    """Return the names of a program of this repository."""
    return SimpleNamespace(**runpy.run_path(str(ROOT / file)))


def test_the_built_engine_is_not_older_than_its_sources() -> None:
    """If this fails, run ``python web/build_engine.py``."""
    build = program("web/build_engine.py")
    assert build.digest_of(build.BUILT) == build.digest()


def test_the_digest_knows_every_source_of_the_engine() -> None:
    build = program("web/build_engine.py")
    names = {path.relative_to(ROOT).as_posix() for path in build.sources()}
    assert {"cpp/game/world.cpp", "cpp/kernels/multiply_add.hpp", "web/engine/engine.cpp"} <= names
    assert not any(name.startswith(("cpp/bindings", "cpp/tests")) for name in names)


def test_the_built_engine_can_stand_in_a_page() -> None:
    """It ends no script element early, evaluates no text, and is one classic script."""
    text = program("web/build_engine.py").BUILT.read_text(encoding="utf-8")
    assert "</script" not in text.lower()
    assert "<!--" not in text
    assert "eval(" not in text
    assert "new Function" not in text
    assert "import.meta" not in text


def test_the_tables_are_those_of_the_package() -> None:
    """If this fails, run ``python web/write_tables.py``."""
    tables = program("web/write_tables.py")
    assert tables.TABLES.read_text(encoding="utf-8") == tables.text()


def test_multiply_add_rounds_once(tmp_path: Path) -> None:
    """The fused multiply-add of processors without one equals the standard library's."""
    compiler = shutil.which("c++")
    if compiler is None:
        pytest.skip("needs a C++ compiler")
    source = ROOT / "cpp/tests/multiply_add.cpp"
    options = ["-std=gnu++17", "-O2", "-ffp-contract=off", f"-I{ROOT / 'cpp'}"]
    built = tmp_path / "multiply_add"
    subprocess.run([compiler, *options, source, "-o", built], check=True)
    done = subprocess.run([built, "0.2"], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout
    assert "1085184 cases, 0 wrong" in done.stdout


def game(number: int, config: mw.WorldConfig, expected: SimpleNamespace) -> dict[str, Any]:
    """Return the episodes of one config as plain values."""
    shape = expected.STEPS, expected.N_WORLDS, config.n_agents
    network = mw.Network.for_config(config, (9, 7))
    return {
        "config": config.to_json(),
        "actions": random_actions(number, config.n_actions, *shape).tolist(),
        "team": policy_json(mw.Population(random_genome(network, 1), network)),
        "matches": [[str(seed), 2] for seed in range(6)],
    }


@pytest.mark.slow
def test_the_built_engine_has_the_fingerprint_of_the_extension() -> None:
    expected = program("tests/contract/test_fingerprint.py")
    moments = [name for name in expected.ARRAYS if WORLD_FIELDS[name].written == "moment"]
    given = {
        "worlds": expected.N_WORLDS,
        "steps": expected.STEPS,
        "cents": expected.CENTS,
        "arrays": {
            "all": expected.ARRAYS,
            "of_moment": moments,
            "of_step": [name for name in expected.ARRAYS if name not in moments],
        },
        "scores": expected.SCORES,
        "games": [game(*numbered, expected) for numbered in enumerate(expected.configs())],
    }
    assert run_node("fingerprint.mjs", given) == expected.FILE.read_text(encoding="ascii").strip()
