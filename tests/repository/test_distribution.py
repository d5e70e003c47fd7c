"""What is installed: name, version, licences, page on the index, and what an import loads."""

from __future__ import annotations

import re
import subprocess
import sys
from importlib import metadata
from pathlib import Path
from typing import Any

import pytest

from matrixworld.version import DISTRIBUTION, __version__, install_hint

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib

ROOT = Path(__file__).parents[2]
PROJECT: dict[str, Any] = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
HEAVY = ["click", "deap", "matplotlib", "scipy", "threadpoolctl", "tqdm"]
# The distribution `matrixworld` of the package index is another project.
OTHER_PROJECT = re.compile(
    r"pip install [^&;|`\n]*(?<![\w./-])matrixworld(?![\w./-])"
    r"|\b(requires|version)\([\"']matrixworld[\"']\)"
)


@pytest.fixture
def installed() -> metadata.Distribution:
    """The package as it is installed; absent where the tests import it from a folder."""
    try:
        return metadata.distribution(DISTRIBUTION)
    except metadata.PackageNotFoundError:
        pytest.skip(f"{DISTRIBUTION} is not installed")


def texts() -> list[Path]:
    """Files of the repository that tell a reader or a tool what to install."""
    folders = [".ci", ".github", "benchmarks", "docs", "evolution", "python", "tests", "tutorials"]
    inside = [path for folder in folders for path in (ROOT / folder).rglob("*")]
    return [
        path
        for path in [*ROOT.iterdir(), *inside]
        if path.suffix in {".ipynb", ".md", ".py", ".toml", ".yaml", ".yml"} or path.name == "run"
        if path.is_file()
    ]


@pytest.mark.parametrize(
    ("text", "wrong"),
    [
        ("pip install matrixworld", True),
        ("pip install 'matrixworld[video]'", True),
        ('requires("matrixworld")', True),
        ("pip install 'matrixworld-pursuit[video]'", False),
        ("pip install . && .venv/bin/matrixworld evolve", False),
        ("`pip install .`, then `matrixworld evolve`", False),
    ],
)
def test_the_name_of_the_other_project_is_found(text: str, wrong: bool) -> None:
    assert bool(OTHER_PROJECT.search(text)) == wrong


def test_no_file_installs_the_other_project() -> None:
    found = [
        f"{path.relative_to(ROOT)}: {match[0]}"
        for path in texts()
        if path != Path(__file__)
        for match in OTHER_PROJECT.finditer(path.read_text(encoding="utf-8"))
    ]
    assert found == [], f"expected {DISTRIBUTION}"


def test_the_package_knows_the_name_and_the_extras_of_its_distribution() -> None:
    assert PROJECT["project"]["name"] == DISTRIBUTION
    assert install_hint("video") == "pip install 'matrixworld-pursuit[video]'"
    source = "".join(path.read_text(encoding="utf-8") for path in (ROOT / "python").rglob("*.py"))
    named = set(re.findall(r"install_hint\(['\"](\w+)['\"]\)", source))
    assert named
    assert named <= set(PROJECT["project"]["optional-dependencies"])


def test_the_version_has_one_source() -> None:
    assert "version" in PROJECT["project"]["dynamic"]
    source = PROJECT["tool"]["scikit-build"]["metadata"]["version"]["input"]
    assert f'\n__version__ = "{__version__}"\n' in (ROOT / source).read_text(encoding="utf-8")
    citation = (ROOT / "CITATION.cff").read_text(encoding="utf-8")
    assert re.findall(r"^version: (.+)$", citation, re.MULTILINE) == [__version__]


def test_the_installed_version_is_the_one_of_the_package(
    installed: metadata.Distribution,
) -> None:
    assert installed.version == __version__


def test_licences_of_compiled_in_code_are_installed(installed: metadata.Distribution) -> None:
    assert installed.metadata["License-Expression"] == "MIT AND BSD-3-Clause AND MPL-2.0"
    assert installed.metadata.get_all("License-File") == [
        "LICENSE",
        "licenses/eigen.txt",
        "licenses/pybind11.txt",
    ]
    texts = {
        path.name: path.read_text() for path in installed.files or [] if "licenses" in str(path)
    }
    assert "MIT License" in texts["LICENSE"]
    assert "Mozilla Public License Version 2.0" in texts["eigen.txt"]
    assert "Wenzel Jakob" in texts["pybind11.txt"]


def test_links_on_the_page_of_the_index_are_absolute(installed: metadata.Distribution) -> None:
    page = str(installed.metadata["Description"])
    assert page.startswith("# matrixworld")
    links = re.findall(r"\]\(([^)]*)\)", page)
    assert links
    assert [link for link in links if not link.startswith("https://")] == []


@pytest.mark.parametrize("module", ["matrixworld", "matrixworld.envs"])
def test_environments_load_no_part_that_they_do_not_need(module: str) -> None:
    code = f"import sys, {module}; print(*sorted(sys.modules.keys() & {HEAVY}))"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.split() == []
