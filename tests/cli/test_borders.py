"""Every command with every option at its borders writes all that it announces, or nothing.

The cases follow from the commands themselves: a new one, or a new option, is tried without a line
here, at night. In-range values that would play for hours, such as 2^31 - 1 episodes, are left out.
"""

import json
import re
import shutil
import unicodedata
from contextlib import suppress
from pathlib import Path
from xml.etree import ElementTree

import click
import numpy as np
import pytest
from click.testing import CliRunner
from PIL import Image

from command_line import RACE
from matrixworld.cli import main
from matrixworld.cli.console import printable
from matrixworld.coevolution.settings.race_settings import paths_of

# ---- What makes a command small and complete -----------------------------------------------------

PLACES = {"runs": "RUN", "sources": "RUN/payoff.npz"}
"""Values of arguments; that of others that are required is RUN."""
SMALL = {
    "--config": "tiny.toml",
    "--episodes": "3",  # what the run has
    "--no-open": None,
    "--schedule": "generalist-generalist",
    "--threads": "1",
    **{("solve", option): "3" for option in ("--rows", "--cols", "--steps")},
}
"""Options that a command gets if it has them; None: a flag."""


def usual(command, param):
    """Return the words of a parameter that is not tried."""
    if isinstance(param, click.Argument):
        place = PLACES.get(param.name or "", "RUN" if param.required else None)
        return [place] if place else []
    for option in (*param.opts, *param.secondary_opts):
        if (key := (command.name, option)) in SMALL or (key := option) in SMALL:
            return [option] if SMALL[key] is None else [option, str(SMALL[key])]
    return []


NUMBERS = ["", "-1", "0", "1", "x", "inf", "-inf", "1e-320", "1" + 30 * "0"]
TEXTS = ["", "-", "0", "x", "-1", "nan", "\udcff", "\x1b]0;x\x07", "x" * 5000, "a=b", "="]
ENDINGS = ["", ".json", ".npz", ".html", ".png", ".csv", ".toml"]
BARE = ["missing/x", "file.txt/x", "/proc/x", "\udcff", "x" * 300, "directory", "old", "cut", "new"]
PATHS = ["", ".", "..", "-", "file.txt", "RUN", "/dev/null", "link", "empty", "RUN/payoff.npz"]


def borders(param):
    flag = isinstance(param, click.Option) and param.is_flag
    if flag:
        return [[option] for option in (*param.opts, *param.secondary_opts)]
    type_ = param.type
    values = list(TEXTS)
    if isinstance(type_, click.Choice):
        values += [*type_.choices][:1] + [*type_.choices][-1:]
    elif isinstance(type_, click.types.IntParamType | click.types.FloatParamType):
        least, most = (getattr(type_, end, None) for end in ("min", "max"))
        values = NUMBERS + [str(each) for each in (least, least and least - 1) if each is not None]
        values += [str(2**31 - 1 if most is None else most + 1)]
    elif isinstance(type_, click.Path) or re.search("RUN|FILE|DIR|PATH", param.metavar or ""):
        values = PATHS + [f"{file}{ending}" for file in BARE for ending in ENDINGS]
        values += [] if isinstance(type_, click.Path) else TEXTS
    values = list(dict.fromkeys(values))
    if isinstance(param, click.Argument):
        return [["--", value] for value in values]
    return [[param.opts[0], value] for value in values]


CASES = [(command, param) for command in main.commands.values() for param in command.params]


def make_template(race, root):
    """Make a directory with a run, and files of all kinds that are none."""
    shutil.copytree(race, root / "RUN")
    for name in ("directory", "empty"):
        (root / name).mkdir()
    tiny = {paths_of(name)[0]: json.dumps(n) for name, n in RACE.items() if name != "hidden"}
    tiny = {name: value for name, value in tiny.items() if not name.startswith("schedule.joint")}
    text = "".join(f"{name} = {value}\n" for name, value in tiny.items())
    (root / "tiny.toml").write_text(text)
    (root / "file.txt").write_text("precious")
    (root / "link").symlink_to("file.txt")
    for ending in ENDINGS:
        (root / f"old{ending}").write_bytes(b"precious \xff")
        (root / f"directory{ending}").mkdir(exist_ok=True)
    (root / "cut.npz").write_bytes((race / "payoff.npz").read_bytes()[:-20])
    (root / "cut.json").write_text('{"a": ')
    (root / "cut.csv").write_text("0.5,nan\n0.5")
    return root


@pytest.fixture(scope="module")
def template(race, tmp_path_factory):
    return make_template(race, tmp_path_factory.mktemp("borders") / "here")


def tree(root):
    return {p.relative_to(root): None if p.is_dir() else p.read_bytes() for p in root.rglob("*")}


READERS = [
    lambda path: json.loads(path.read_text("utf-8")),
    lambda path: [*np.load(path).values()],
    np.load,
    lambda path: Image.open(path).verify(),
    ElementTree.parse,  # SVG
    lambda path: path.read_text("utf-8").index("</html>"),
    lambda path: np.loadtxt(path, str, delimiter=",", ndmin=2)[1],
]


def is_readable(path):
    """Return whether a file is whole, whatever its name; locks are empty."""
    for read in READERS:
        with suppress(Exception):
            read(path)
            return True
    return path.name.endswith(".lock") and not path.stat().st_size


def problem_of(words, root, before):
    """Return what a command does against its promise; empty if it keeps it."""
    done = CliRunner().invoke(main, words)
    after = tree(root)
    if not isinstance(done.exception, SystemExit | None):
        return f"raises {done.exception!r}"
    if done.exit_code:
        said = re.findall(r"^Error: .+", done.stderr, re.MULTILINE)
        if done.exit_code not in (1, 2) or len(said) != 1 or "Traceback" in done.output:
            return f"ends with {done.exit_code}: {done.output[-300:]!r}"
        if any(unicodedata.category(c) in ("Cc", "Cs", "Cf") for c in said[0]):
            return f"gives a terminal orders: {said[0]!r}"
        changed = sorted({*before.items()} ^ {*after.items()}, key=str)
        return f"fails, and changes {[str(path) for path, _ in changed]}" if changed else ""
    if lost := [path for path in before if after.get(path, 0) != before[path]]:
        return "" if "--force" in words else f"changes {lost}"
    new = [path for path in after.keys() - before.keys() if after[path] is not None]
    if broken := [path for path in new if not is_readable(root / path)]:
        return f"writes {broken}, which is not readable"
    names = {printable(path.name) for path in after}  # escapes are printed
    announced = [Path(name.split(", ")[0]) for name in re.findall("Written: (.+)", done.stdout)]
    missing = [path for path in announced if not path.exists() and path.name not in names]
    return f"announces {missing}" if missing else ""


@pytest.fixture
def here(template, tmp_path, monkeypatch):
    """The working directory, inside of one that must not change, either."""
    monkeypatch.setattr("webbrowser.open", lambda page: True)
    # Tables and figures at the end of a job take seconds, and have tests of their own.
    monkeypatch.setattr("matrixworld.cli.evolve.report", lambda *args, **options: None)
    shutil.copytree(template, root := tmp_path / "case" / "here", symlinks=True)
    monkeypatch.chdir(root)
    return root


@pytest.mark.usefixtures("here")
def test_the_usual_words_of_all_commands_are_valid():
    for command in main.commands.values():
        words = [command.name, *(w for param in command.params for w in usual(command, param))]
        done = CliRunner().invoke(main, words)
        assert done.exit_code == 0, f"{words}: {done.output}"


@pytest.mark.nightly
@pytest.mark.parametrize(
    ("command", "param"), CASES, ids=[f"{command.name} {param.opts[0]}" for command, param in CASES]
)
def test_all_is_written_or_nothing(command, param, template, here):
    others = [other for other in command.params if other is not param]
    rest = [word for other in others for word in usual(command, other)]
    root, before, problems = here.parent, tree(here.parent), []
    for words in borders(param):
        typed = [command.name, *rest, *words]
        if problem := problem_of(typed, root, before):
            problems.append(f"{typed} {problem}")
        if tree(root) != before:
            for entry in [*here.iterdir(), *({*root.iterdir()} - {here})]:
                shutil.rmtree(entry) if entry.is_dir() else entry.unlink()
            shutil.copytree(template, here, symlinks=True, dirs_exist_ok=True)
    assert not problems, "\n".join(problems)
