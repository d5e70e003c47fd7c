"""The built engine is that of the sources, and its tables are those of the package."""

from __future__ import annotations

import importlib.util
import shutil
import subprocess
from pathlib import Path
from types import ModuleType

import pytest

ROOT = Path(__file__).parents[2]


def program(name: str) -> ModuleType:
    """Return a program of web/ as a module."""
    spec = importlib.util.spec_from_file_location(name, ROOT / f"web/{name}.py")
    assert spec
    assert spec.loader
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def test_the_built_engine_is_not_older_than_its_sources() -> None:
    """If this fails, run ``python web/build_engine.py``."""
    build = program("build_engine")
    assert build.digest_of(build.BUILT) == build.digest()


def test_the_digest_knows_every_source_of_the_engine() -> None:
    build = program("build_engine")
    names = {path.relative_to(ROOT).as_posix() for path in build.sources()}
    assert {"cpp/game/world.cpp", "cpp/kernels/multiply_add.hpp", "web/engine/engine.cpp"} <= names
    assert not any(name.startswith(("cpp/bindings", "cpp/tests")) for name in names)


def test_the_built_engine_can_stand_in_a_page() -> None:
    """It ends no script element early, evaluates no text, and is one classic script."""
    text = program("build_engine").BUILT.read_text(encoding="utf-8")
    assert "</script" not in text.lower()
    assert "<!--" not in text
    assert "eval(" not in text
    assert "new Function" not in text
    assert "import.meta" not in text


def test_the_tables_are_those_of_the_package() -> None:
    """If this fails, run ``python web/write_tables.py``."""
    tables = program("write_tables")
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
