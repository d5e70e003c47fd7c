"""Examples of pages run and print what is shown; commands and settings that pages name exist.

Examples of a page run one after the other. A block that needs a library says so in the line above
it, ``<!-- needs torch -->``: it runs where the library is installed. A block that cannot run alone
begins with ``python no-run``, one with a title is a recipe of ``test_how_to_add.py``.
"""

import json
import re
import shlex
import sys
import warnings
from functools import cache
from importlib import import_module
from importlib.util import find_spec
from types import ModuleType
from typing import NamedTuple

import click
import pytest
from click.testing import CliRunner

import matrixworld as mw
from matrixworld.cli import main
from matrixworld.coevolution import RaceSettings
from matrixworld.coevolution.settings.usual import COURTYARD, DEFAULTS
from notebooks import NOTEBOOKS
from pages import ROOT, page_id, read

ELSEWHERE = {
    "docs/cluster.md": "needs several processes; tests/cli/test_cluster.py",
    "docs/how_to_add.md": "tests/repository/test_how_to_add.py",
    "tutorials/class_tournament/README.md": "the tests beside it",
}
"""Pages whose examples another test runs."""
PAGES = sorted({ROOT / "README.md", *(ROOT / "docs").rglob("*.md"), *ROOT.glob("*/*/README.md")})

NUMBER = r"-?\d+\.?\d*"
FENCE = re.compile(
    r"^(?:<!-- needs (?P<needs>.+) -->\n)?```python(?P<rest>.*)\n(?P<code>(?:.*\n)*?)```$"
    r"(?:\n\n```text\n(?P<shown>(?:.*\n)*?)```$)?",
    re.M,
)


class Example(NamedTuple):
    """Python code of a page, libraries that it needs, and the text below it that it prints."""

    code: str
    needs: tuple[str, ...]
    shown: str


def examples_of(page):
    return [
        Example(found["code"], tuple((found["needs"] or "").split()), found["shown"] or "")
        for found in FENCE.finditer(read(page))
        if "no-run" not in found["rest"]
    ]


def is_absent(need):
    module, _, name = need.partition(".")
    return find_spec(module) is None or not (not name or hasattr(import_module(module), name))


def check_nearly_same(printed, shown):
    """Compare text exactly and numbers nearly: another SciPy may resample differently."""
    assert re.sub(NUMBER, "#", printed.strip()) == re.sub(NUMBER, "#", shown.strip())
    ours, theirs = ([*map(float, re.findall(NUMBER, text))] for text in (printed, shown))
    assert ours == pytest.approx(theirs, abs=0.01)


WITH_EXAMPLES = [page_id(page) for page in PAGES if examples_of(page_id(page))]


@pytest.mark.parametrize("page", sorted({*WITH_EXAMPLES} - {*ELSEWHERE}))
def test_examples_run_and_print_what_is_shown(page, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    script = ModuleType("__main__")  # as a program that runs
    monkeypatch.setitem(sys.modules, "__main__", script)
    missing = set()
    for example in examples_of(page):
        if absent := [*filter(is_absent, example.needs)]:
            missing |= {*absent}
            continue
        with warnings.catch_warnings():
            if example.needs:  # the warnings of other libraries are not ours
                warnings.simplefilter("ignore")
            exec(compile(example.code, page, "exec"), vars(script))
        printed = capsys.readouterr().out
        if example.shown and page == "docs/analysis.md":
            check_nearly_same(printed, example.shown)
        elif example.shown:
            assert printed.strip() == example.shown.strip()
    # `.ci/run` installs PyTorch, and then runs again what was skipped.
    if missing:
        pytest.skip(f"without {', '.join(sorted(missing))}; the other examples have run")


# Commands

WITH_COMMANDS = sorted(
    {*PAGES, *ROOT.glob("*.md"), *ROOT.glob("*/README.md"), *NOTEBOOKS}
    # The recipes of how_to_add.md add names of their own, and another test follows them.
    - {ROOT / "docs/how_to_add.md", ROOT / "CHANGELOG.md"}
)
SHELL = re.compile(r"^```sh\n((?:.*\n)*?)```$", re.M)
INLINE = re.compile(r"`(matrixworld [^`]+)`")


def commands_of(page):
    """Yield the commands of a page: lines of shell blocks, and code in sentences and tables."""
    text = page.read_text(encoding="utf-8")
    if page.suffix == ".ipynb":
        text = "\n".join("".join(cell["source"]) for cell in json.loads(text)["cells"])
        yield from re.findall(r"^!(matrixworld .+)$", text, re.M)
    for block in SHELL.findall(text):
        yield from block.replace("\\\n", " ").splitlines()
    yield from INLINE.findall(re.sub(r"^```.*?^```$", "", text, flags=re.M | re.S))


def arguments_of(line):
    """Return the arguments that a line of a shell gives to the command; None for another one."""
    words = [*shlex.split(line.replace("|", " "), comments=True)]
    names = [n for n, word in enumerate(words) if word.rpartition("/")[2] == "matrixworld"]
    if not names or (len(words) > 1 and words[0] in ("eval", "pip", "uvx", "sh")):
        return None
    return words[names[-1] + 1 :]


def parse(line, arguments):
    """Return the name of a command and its options, as click parses them; nothing runs."""
    if not arguments or arguments[0].startswith("-"):
        return "", {}
    command = main.commands.get(arguments[0])
    assert command is not None, line
    if isinstance(command, click.Group):
        return "", {}
    context = click.Context(command)
    given, rest, _ = command.make_parser(context).parse_args(arguments[1:])
    assert not rest, f"{line}: {rest} is too much"
    numbers = click.types.IntParamType, click.types.FloatParamType, click.Choice
    for param in command.params:
        texts = given.get(param.name or "")
        for text in texts if isinstance(texts, list) else [texts]:
            if isinstance(param.type, numbers) and isinstance(text, str):
                param.type.convert(text, param, context)
    return arguments[0], given


@pytest.mark.parametrize("page", WITH_COMMANDS, ids=page_id)
def test_commands_that_a_page_shows_exist(page):
    for line in commands_of(page):
        arguments = arguments_of(line)
        if arguments is None:
            continue
        name, given = parse(line, arguments)
        if name == "evolve":
            check_settings(line, given)


# Settings

OPTIONS = {
    "variant": "world.rules",
    **{name: f"world.{name}" for name in ("rows", "cols", "n_pursuers", "n_evaders")},
    "learner": "learner",
    "generations": "schedule.generations",
}
"""Options of `evolve` and the settings that they set."""
NESTED = ("world.rewards.", "world.rules.", "learner.settings.", "schedule.pursuers_meet.settings.")
NAMED = re.compile(r"`((?:policy|learner|schedule|fitness)\.[a-z_]+(?:\.[a-z_]+)*)(?:=[^`]*)?`")


@cache
def paths():
    told = CliRunner().invoke(main, ["evolve", "--help-all"], catch_exceptions=False).output
    told = told.partition("\nsettings:\n")[2]
    return {"policy", "learner", "schedule", *re.findall(r"^  ([a-z_.]+)(?: |$)", told, re.M)}


def exists(path):
    known = {*paths(), *(path.replace("pursuers_meet", "evaders_meet") for path in paths())}
    return path in known or path.startswith(NESTED) or f"{path}.rule" in known


def value_of(text):
    try:
        return json.loads(text)
    except ValueError:
        return text


def check_settings(line, given):
    """Check that settings of a command exist, and of a single race that it takes them."""
    sets = dict(text.split("=", 1) for text in given.get("sets") or ())
    assert [path for path in sets if not exists(path)] == [], line
    schedules = given.get("schedule") or []
    if len(schedules) == 1 and schedules[0].islower():
        values = {path: given[name] for name, path in OPTIONS.items() if given.get(name)}
        values |= {**sets, "schedule": schedules[0]}
        from_paper = any(given.get(name) for name in ("paper", "config", "game"))
        start = {} if from_paper else {DEFAULTS: COURTYARD}
        RaceSettings.of(start, {path: value_of(value) for path, value in values.items()})


@pytest.mark.parametrize("page", PAGES, ids=page_id)
def test_settings_that_a_page_names_exist(page):
    text = page.read_text(encoding="utf-8")
    named = {path for path in NAMED.findall(text) if not path.endswith(".py")}
    assert {path for path in named if not exists(path)} == set()
    of_worlds = set(re.findall(r"`world\.([a-z_]+)(?:=[^`]*)?`", text))
    world = {path.partition(".")[2] for path in paths() if path.startswith("world.")}
    assert {name for name in of_worlds - world if not hasattr(mw.World, name)} - {"py"} == set()
    for block in re.findall(r"^```toml\n((?:.*\n)*?)```$", text, re.M):
        if sys.version_info >= (3, 11):
            import tomllib

            RaceSettings.of(tomllib.loads(block))
