"""What is installed and what it says: distribution, docstrings, and includes of the C++ tree."""

import doctest
import importlib
import inspect
import json
import re
import subprocess
import sys
from importlib import metadata
from pathlib import Path

import pettingzoo
import pytest

import matrixworld
from matrixworld.version import DISTRIBUTION, install_hint

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib

ROOT = Path(__file__).parents[2]

# Distribution

PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
HEAVY = ["click", "deap", "matplotlib", "scipy", "threadpoolctl", "tqdm"]
LIBRARIES = [*HEAVY, "gymnasium", "numpy", "pettingzoo"]
LEFT_OUT = {
    "import matrixworld; from matrixworld import World, rollout": LIBRARIES[:-2],
    "import gymnasium, matrixworld as mw; mw.parallel_env(evaders='fleer')": [
        *HEAVY, "matrixworld.coevolution",
    ],
    "import matrixworld.coevolution": ["click", "gymnasium", "matplotlib", "pettingzoo", "scipy"],
    "from matrixworld.cli import main; main(['--help'], standalone_mode=False)": [
        each for each in LIBRARIES if each != "click"
    ],
}  # fmt: skip
"""Modules that lines of Python do not import."""
# The distribution `matrixworld` of the package index is another project.
OTHER_PROJECT = re.compile(
    r"pip install [^&;|`\n]*(?<![\w./-])matrixworld(?![\w./-])"
    r"|\b(requires|version)\([\"']matrixworld[\"']\)"
)


@pytest.fixture
def installed():
    """The package as it is installed; absent where the tests import it from a folder."""
    try:
        return metadata.distribution(DISTRIBUTION)
    except metadata.PackageNotFoundError:
        pytest.skip(f"{DISTRIBUTION} is not installed")


def texts():
    """Files of the repository that tell a reader or a tool what to install."""
    folders = [".ci", ".github", "benchmarks", "docs", "evolution", "python", "tests", "tutorials"]
    inside = [path for folder in folders for path in (ROOT / folder).rglob("*")]
    return [
        path
        for path in [*ROOT.iterdir(), *inside]
        if path.suffix in {".ipynb", ".md", ".py", ".toml", ".yaml", ".yml"} or path.name == "run"
        if path.is_file()
    ]


def test_no_file_installs_the_other_project():
    found = [
        f"{path.relative_to(ROOT)}: {match[0]}"
        for path in texts()
        if path != Path(__file__)
        for match in OTHER_PROJECT.finditer(path.read_text(encoding="utf-8"))
    ]
    assert found == [], f"expected {DISTRIBUTION}"


def test_the_package_knows_the_name_and_the_extras_of_its_distribution():
    assert PROJECT["project"]["name"] == DISTRIBUTION
    assert install_hint("video") == "pip install 'matrixworld-pursuit[video]'"
    source = "".join(path.read_text(encoding="utf-8") for path in (ROOT / "python").rglob("*.py"))
    named = set(re.findall(r'imported\("[\w.]+", "([\w-]+)"\)', source))
    assert named
    assert named <= set(PROJECT["project"]["optional-dependencies"])


def test_the_licence_names_those_of_all_compiled_code():
    bill = json.loads((ROOT / "licenses/sbom.cdx.json.in").read_text(encoding="utf-8"))
    given = [each for part in bill["components"] for each in part["licenses"]]
    texts = [each.get("expression") or each["license"]["id"] for each in given]
    named = {name for text in texts for name in text.split(" AND ")}
    assert {"MIT", *named} == set(PROJECT["project"]["license"].split(" AND "))
    recipe = (ROOT / ".ci/recipe.yaml").read_text(encoding="utf-8")
    assert f"  license: {PROJECT['project']['license']}\n" in recipe


def test_links_on_the_page_of_the_index_are_absolute(installed):
    page = str(installed.metadata["Description"])
    assert page.startswith("# matrixworld")
    links = re.findall(r"\]\(([^)]*)\)", page)
    assert links
    assert [link for link in links if not link.startswith("https://")] == []


@pytest.mark.parametrize(
    "order", ["matrixworld.envs, gymnasium, pettingzoo", "pettingzoo, gymnasium, matrixworld"]
)
def test_environments_are_registered_with_the_package_or_its_environments(order):
    name, in_parallel = "'matrixworld/pursuit_evasion_o_v0'", hasattr(pettingzoo, "make")
    code = f"import {order}; gymnasium.make({name})"
    code += f"; pettingzoo.make('parallel', {name})" * in_parallel  # from PettingZoo 1.27 on
    subprocess.run([sys.executable, "-c", code], check=True)


@pytest.mark.parametrize("line", LEFT_OUT)
def test_imports_leave_out_what_they_do_not_need(line):
    found = f"found = sys.modules.keys() & {LEFT_OUT[line]}"
    code = f"import sys\n{line}\n{found}\nassert not found, found"
    subprocess.run([sys.executable, "-c", code], check=True)


def test_all_public_names_are_listed_and_can_be_used():
    names = {*matrixworld.__all__, "analysis", "coevolution", "envs", "plots", "solver"}
    assert names <= set(dir(matrixworld))
    assert [name for name in names if not hasattr(matrixworld, name)] == []
    with pytest.raises(AttributeError, match="module 'matrixworld' has no attribute 'Word'"):
        matrixworld.Word  # noqa: B018


# Docstrings

PACKAGE = Path(matrixworld.__file__).parent
WITH_EXAMPLES = sorted(
    ".".join(("matrixworld", *file.relative_to(PACKAGE).with_suffix("").parts))
    for file in PACKAGE.rglob("*.py")
    if ">>> " in file.read_text(encoding="utf-8")
)


@pytest.mark.parametrize("name", WITH_EXAMPLES)
def test_examples_in_docstrings_print_what_they_show(name):
    result = doctest.testmod(importlib.import_module(name.removesuffix(".__init__")))
    assert result.attempted > 0  # `>>>` in another kind of text would be no example
    assert result.failed == 0


PUBLIC = (
    "matrixworld",
    "matrixworld.analysis",
    "matrixworld.coevolution",
    "matrixworld.coevolution.opponents",
    "matrixworld.envs",
    "matrixworld.envs.stable_baselines3",
    "matrixworld.plots",
    "matrixworld.episodes.replay",
    "matrixworld.solver",
)
SECTION = re.compile(
    r"^(?:Parameters|Other Parameters|Attributes)\n-{3,}\n(.*?)(?=^\w[^\n]*\n-{3,}$|\Z)",
    re.M | re.S,
)
"""A section of a docstring in numpydoc's form; each of its lines at the margin begins an entry."""


def public_objects():
    for module_name in PUBLIC:
        module = importlib.import_module(module_name)
        public = getattr(module, "__all__", None)
        for name in public or [n for n in vars(module) if not n.startswith("_")]:
            found = getattr(module, name)
            place = getattr(found, "__module__", "")
            ours = place.startswith("matrixworld") if public else place == module_name
            is_enum = hasattr(found, "__members__")  # whose members document themselves
            if callable(found) and ours and not is_enum:
                yield found


def parameters_of(found):
    if inspect.isclass(found) and issubclass(found, Exception):
        return set()
    if getattr(found, "_is_protocol", False):  # nobody calls it
        return set()
    return set(inspect.signature(found).parameters) - {"self", "args", "kwargs"}


def documented_by(found):
    """Return the parameters and attributes that one docstring describes, in a section or a text."""
    text = inspect.getdoc(found) or ""
    entries = re.findall(r"^\S.*", "".join(SECTION.findall(text)), re.M)
    names = ",".join(entry.partition(" :")[0] for entry in entries).split(",")
    return {*(name.strip().lstrip("*") for name in names), *re.findall(r"`(\w+)`", text)}


def test_all_parameters_are_documented():
    missing = {}
    for found in public_objects():
        # A class may leave the parameters that it inherits to its base class.
        classes = inspect.getmro(found) if inspect.isclass(found) else (found,)
        ours = [each for each in classes if each.__module__.startswith("matrixworld")]
        missing[found.__qualname__] = parameters_of(found).difference(*map(documented_by, ours))
    assert {name: parameters for name, parameters in missing.items() if parameters} == {}


# Includes

CPP = ROOT / "cpp"
# Which rooms the files of a room may include, besides their own.
ALLOWED = {
    "grid": set(),
    "kernels": {"grid"},
    "game": {"grid"},
    "observe": {"grid", "kernels", "game"},
    "play": {"grid", "kernels", "game", "observe"},
    "solve": {"grid", "kernels", "game", "observe", "play"},
    "bindings": {"grid", "kernels", "game", "observe", "play", "solve"},
    "tests": {"grid", "kernels", "game", "observe", "play", "solve", "bindings"},
}
INCLUDE = re.compile(r'^#include "(?:(\w+)/)?([\w.]+)"', re.MULTILINE)


def includes(file):
    """Return (room, header) of every quoted include; without a room it is the file's own."""
    own = file.relative_to(CPP).parts[0]
    return [(room or own, header) for room, header in INCLUDE.findall(file.read_text())]


def test_includes_run_one_way():
    """grid <- game <- observe <- play <- solve <- bindings, with kernels beside game."""
    found = {path.name: set() for path in CPP.iterdir() if path.is_dir()}
    for file in CPP.rglob("*.[ch]pp"):
        room = file.relative_to(CPP).parts[0]
        found[room] |= {other for other, _ in includes(file)} - {room}
    assert found.keys() == ALLOWED.keys()
    assert {room: more for room in found if (more := found[room] - ALLOWED[room])} == {}


def test_kernels_include_plain_data_only():
    """Inline functions in kernels.cpp could replace those of the base instruction set."""
    headers = {
        f"{room}/{header}"
        for file in (CPP / "kernels").iterdir()
        for room, header in includes(file)
        if room != "kernels"
    }
    assert headers == {"grid/compiler.hpp", "grid/positions.hpp"}
    assert not any(includes(CPP / header) for header in headers)
    # See above; `compiler.hpp` has an unnamed namespace, which is another one in each file.
    assert "inline" not in re.sub(r"//.*", "", (CPP / "grid" / "positions.hpp").read_text())
