"""Pages: their examples run and print what is shown, their links lead somewhere, names exist."""

import ast
import json
import os
import re
import runpy
import subprocess
import sys
from collections.abc import Sequence
from dataclasses import replace
from importlib.util import find_spec
from pathlib import Path
from typing import NamedTuple

import click
import numpy as np
import pettingzoo
import pytest

import matrixworld as mw
from course.questions import Exercise, exercises
from matrixworld import analysis, plots
from matrixworld.cli import main
from matrixworld.cli.pages import OF_GAME
from matrixworld.coevolution import SCHEDULES, RaceSettings, start
from matrixworld.coevolution.schedules import ALL_SCHEDULES, SAMPLERS, Maps
from matrixworld.coevolution.storage import COLUMNS
from matrixworld.plots.saved import OF_RUN
from tiny_race import path_of, tiny_race

ROOT = Path(__file__).parents[2]
DOCS = ROOT / "docs"
NUMBER = r"-?\d+\.?\d*"
RATE = r"0\.\d+ \(0\.\d+ to 0\.\d+\)"


def read(name: str) -> str:
    return (ROOT / name).read_text(encoding="utf-8")


def page_id(page: Path) -> str:
    return str(page.relative_to(ROOT))


# Examples

FENCE = re.compile(r"^```python\n(.*?)^```$(?:\n\n```text\n(.*?)^```$)?", re.M | re.S)
RUN = {
    "README.md": None,
    "docs/README.md": None,
    "docs/analysis.md": None,
    "docs/coevolution.md": (
        r"specialist-specialist 0\..*", r"generalist-generalist 0\..*",
        r"\{'hall': \d, 'archive': \d\}", "True", r"\[0, 1, 2\]",
    ),
    "docs/figures.md": None,
    "docs/ground_truth.md": None,
    "docs/integrations.md": None,
    "docs/maps.md": (r"\(3, 4, 4, 4\) \[.*\]",),
    "docs/primer.md": None,
    "docs/live.md": None,
    "docs/opponents.md": (RATE, RATE, r"\[(.|\n)*"),
    "docs/safety.md": None,
}  # fmt: skip
"""Pages whose examples run, one after the other, and patterns of lines that are not shown."""
ELSEWHERE = {
    "docs/browser.md": "needs a browser; tests/repository/test_browser.py",
    "docs/class.md": "tests/classroom/test_class.py",
    "docs/cluster.md": "needs several processes; tests/cli/test_cluster.py",
    "docs/explorer.md": "needs a run; tests/explorer/test_runs_page.py",
    "docs/files.md": "one line for a run of the reader's",
    "docs/held_out.md": "needs a run; tests/coevolution/evaluation",
    "docs/how_to_add.md": "tests/repository/test_how_to_add.py",
    "docs/play.md": "needs a browser; tests/explorer/test_playground.py",
    "docs/playground.md": "tests/explorer/test_playground.py",
}
CLIENTS = sorted((DOCS / "clients").glob("*.md"))
NOTEBOOKS = sorted((ROOT / "tutorials").glob("[0-9]*.ipynb"))


class Example(NamedTuple):
    """Python code of a page, and the text below it that it prints."""

    code: str
    shown: str


def examples_of(page: str) -> list[Example]:
    return [Example(*found) for found in FENCE.findall(read(page))]


def missing_modules(code: str) -> list[str]:
    """Return modules that code imports and that are not installed."""
    statements = list(ast.walk(ast.parse(code)))
    names = [a.name for each in statements if isinstance(each, ast.Import) for a in each.names]
    parts = [each for each in statements if isinstance(each, ast.ImportFrom)]
    names += [each.module or "" for each in parts]
    # Its functions have the names of the libraries that they need.
    ours = [each for each in parts if each.module == "matrixworld.integrations.metrics"]
    names += [a.name.removesuffix("_writer") for each in ours for a in each.names]
    if "pettingzoo.make(" in code and not hasattr(pettingzoo, "make"):
        return ["PettingZoo 1.27"]
    return [name for name in names if find_spec(name.partition(".")[0]) is None]


def run_python(parts: Sequence[str], directory: Path, *options: str) -> list[str]:
    """Return what each part of a program prints."""
    mark = "-- the next example --"
    # With `-c` worker processes do not run the program themselves.
    program = f"\nprint({mark!r})\n".join(parts)
    command = [sys.executable, *options, "-c", program]
    own = {**os.environ, "MINARI_DATASETS_PATH": str(directory)}
    done = subprocess.run(
        command, cwd=directory, env=own, capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stderr
    return done.stdout.split(f"{mark}\n")


def check_nearly_same(printed: str, shown: str) -> None:
    """Compare text exactly and numbers nearly: another SciPy may resample differently."""
    assert re.sub(NUMBER, "#", printed.strip()) == re.sub(NUMBER, "#", shown.strip())
    ours, theirs = ([*map(float, re.findall(NUMBER, text))] for text in (printed, shown))
    assert ours == pytest.approx(theirs, abs=0.01)


def test_every_page_with_examples_is_tested() -> None:
    pages = {page_id(page) for page in [ROOT / "README.md", *DOCS.glob("*.md")]}
    assert {page for page in pages if "```python\n" in read(page)} <= {*RUN, *ELSEWHERE}


SLOW = ("docs/analysis.md", "docs/figures.md", "docs/integrations.md", "docs/opponents.md")
"""Pages whose examples take some seconds; one has races of several seconds each."""
MARKS = {**dict.fromkeys(SLOW, pytest.mark.slow), "docs/coevolution.md": pytest.mark.nightly}


@pytest.mark.parametrize("page", [pytest.param(page, marks=MARKS.get(page, ())) for page in RUN])
def test_examples_run_and_print_what_is_shown(page: str, tmp_path: Path) -> None:
    # The warnings of other libraries are not ours.
    strict = () if page == "docs/integrations.md" else ("-W", "error")
    missing = {example: missing_modules(example.code) for example in examples_of(page)}
    examples = [example for example, modules in missing.items() if not modules]
    told = run_python([example.code for example in examples], tmp_path, *strict)
    for printed, example in zip(told, examples, strict=True):
        if example.shown and page == "docs/analysis.md":
            check_nearly_same(printed, example.shown)
        elif example.shown:
            assert printed.strip() == example.shown.strip()
    if patterns := RUN[page]:
        assert re.fullmatch("\n".join(patterns), "".join(told).strip())
    # `.ci/run` installs torch and onnx before it runs slow tests.
    if absent := sorted({name for modules in missing.values() for name in modules}):
        pytest.skip(f"without {', '.join(absent)}; the other examples have run")


@pytest.mark.parametrize("page", CLIENTS, ids=lambda page: page.stem)
def test_learners_of_other_libraries_run_with_few_steps(page: Path, tmp_path: Path) -> None:
    assert f"](clients/{page.name}" in read("docs/integrations.md")
    for example in examples_of(page_id(page)):
        for module in missing_modules(example.code):
            pytest.importorskip(module, exc_type=ImportError)
        # One or two updates of the learner.
        short, count = re.subn(r"^STEPS = [\d_]+", "STEPS = 8_192", example.code, flags=re.M)
        assert count == 1  # else the example would take its full time
        (printed,) = run_python([short], tmp_path)  # in a directory of its own, where it may write
        for moment in ("before", "after"):
            assert re.search(rf"^{moment} {RATE}$", printed, re.M), printed


# Commands

WITH_COMMANDS = [
    *(ROOT / name for name in ("README.md", "CONTRIBUTING.md")),
    # The recipes of how_to_add.md add names of their own, and another test follows them.
    *sorted({*DOCS.glob("*.md")} - {DOCS / "how_to_add.md"}),
    *sorted((ROOT / "evolution").glob("*.md")),
    *NOTEBOOKS,
]
COMMAND = re.compile(r"matrixworld (?P<name>[a-z]+)(?P<rest>(?: [^\s`|\"\\]+)*)")


def shown_commands(page: Path) -> list[tuple[str, list[str]]]:
    """Return the commands of a page: their name and their options."""
    found = COMMAND.finditer(page.read_text(encoding="utf-8"))
    return [
        (match["name"], re.findall(r"(?<!\S)--[a-z-]+", match["rest"]))
        for match in found
        if match["name"] in main.commands
    ]


def visible_options(command: click.Command) -> set[str]:
    if isinstance(command, click.Group):
        return {name for part in command.commands.values() for name in visible_options(part)}
    options = (param for param in command.params if isinstance(param, click.Option))
    shown = (option for option in options if not option.hidden)
    return {"--help", *(name for each in shown for name in (*each.opts, *each.secondary_opts))}


@pytest.mark.parametrize("page", WITH_COMMANDS, ids=page_id)
def test_options_that_a_page_shows_exist(page: Path) -> None:
    for name, options in shown_commands(page):
        assert set(options) <= visible_options(main.commands[name]), name


# Links

ANCHOR = re.compile(r'<a id="([^"]+)"></a>')
ALL_PAGES = sorted({*DOCS.rglob("*.md"), *ROOT.glob("*.md"), *ROOT.glob("*/README.md"), *NOTEBOOKS})


def prose(page: Path) -> str:
    """Return the text of a page or of a notebook, without code."""
    text = page.read_text(encoding="utf-8")
    if page.suffix == ".ipynb":
        cells = [cell for cell in json.loads(text)["cells"] if cell["cell_type"] == "markdown"]
        text = "\n".join("".join(cell["source"]) for cell in cells)
    return re.sub(r"^```.*?^```$", "", text, flags=re.M | re.S)


def anchors(page: Path) -> set[str]:
    """Return the anchors of a page: headings as GitHub names them, and explicit ones."""
    headings = re.findall(r"^#+ (.+)$", prose(page), re.M)
    names = (re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-") for heading in headings)
    return {*names, *ANCHOR.findall(prose(page))}


@pytest.mark.parametrize("page", ALL_PAGES, ids=page_id)
def test_links_lead_somewhere(page: Path) -> None:
    links = re.findall(r"\]\(([^)\s]+)\)", prose(page))
    if page in NOTEBOOKS:
        assert "../docs/glossary.md" in {link.partition("#")[0] for link in links}
    for link in links:
        file, _, anchor = link.partition("#")
        target = (page.parent / file).resolve() if file else page
        if "://" not in link:
            assert target.exists(), link
            assert not anchor or target.suffix != ".md" or anchor in anchors(target), link


# Names in tables


def test_the_readme_has_the_rules_of_each_variant() -> None:
    moves = {
        mw.Interaction.SIMULTANEOUS: "all at once",
        mw.Interaction.SWARM_TURNS: "team by team",
        mw.Interaction.AGENT_TURNS: "one at a time",
    }
    captures = {mw.Capture.OCCUPATION: "occupation", mw.Capture.SURROUND: "surrounding"}
    for name, rules in mw.VARIANTS.items():
        outcomes = (rules.obstacle, rules.teammate, rules.evader, rules.pursuer)
        obstacle, teammate, evader, pursuer = (outcome.name[0] for outcome in outcomes)
        captured = "disappear" if rules.removes_captured else "stay"
        cells = (name, moves[rules.interaction], obstacle, teammate, f"{evader}, {pursuer}")
        row = f"| {' | '.join((*cells, captures[rules.capture], captured))} |\n"
        assert row in read("README.md"), f"README.md, The games: add the row {row}"


def test_names_of_measures() -> None:
    table = read("docs/analysis.md").split("| question |")[1].split("\n\n")[0]
    named = re.findall(r"`(\w+)`", table)
    assert len(named) > 15  # the pattern finds the table at all
    assert set(named) <= set(analysis.__all__)


def test_the_table_of_experiments_names_every_selection() -> None:
    table = read("docs/coevolution.md").split("| experiment | settings |")[1].split("\n\n")[0]
    values = set(re.findall(r'"([\w-]+)"', table))
    assert values == {*SAMPLERS, *ALL_SCHEDULES, Maps.kind, "competitive"} - {
        "latest",
        "round-robin",
    }
    named = set(re.findall(r"`(\w+)=", table))
    fields = RaceSettings.__dataclass_fields__
    assert all("." in path_of(name) or name in fields for name in named)
    assert len(named) > 8


def test_the_table_of_figures_names_them_and_their_functions() -> None:
    page = read("docs/figures.md")
    rows = re.findall(r"^\| [^|]+ \| `(matrixworld explore[^|]+)` \| (.+) \|$", page, re.M)
    named = {name for command, _ in rows for name in re.findall(r"--figure (\w+)", command)}
    # These are not in the paper.
    others = {"lag_profile", "dynamics", "worst_map", "spinning_top", "right_of_way"}
    assert named == {*OF_GAME, *OF_RUN} - others
    functions = [name for _, cell in rows for name in re.findall(r"`(\w+)`", cell)]
    assert set(functions) <= set(plots.__all__)
    pictures = re.findall(r"!\[[^]]+\]\(([^)]+)\)", page)
    assert {Path(each).stem for each in pictures} == set(OF_GAME)


def test_the_exercises_that_the_teachers_page_names_exist() -> None:
    named = re.findall(r"\b[1-9]\.[a-z1-9]\b", read("docs/teachers.md"))
    assert named
    for name in named:
        chapter, _, item = name.partition(".")
        assert isinstance(exercises(int(chapter))[name], Exercise) is item.isdigit(), name


# Answers for a class


def test_the_answers_for_a_class_are_what_dice_and_hands_do(
    capsys: pytest.CaptureFixture[str],
) -> None:
    runpy.run_path(str(DOCS / "class_material" / "simulate.py"), run_name="__main__")
    told = re.findall(r"\d+\.\d|\d+ %", capsys.readouterr().out)
    assert len(told) == 9
    answers = read("docs/class_material/answers.md")
    assert [number for number in told if number not in answers] == []


# The page for users of the published code

MIGRATION = read("docs/migration.md")


def test_names_of_the_package_that_replace_others() -> None:
    named = set(re.findall(r"`?mw\.(\w+(?:\.\w+)?)", MIGRATION))
    assert len(named) > 12
    for name in named:
        place = mw
        for part in name.split("."):
            place = getattr(place, part)


def test_infos_and_status_that_replace_others() -> None:
    infos = MIGRATION.split("## Infos")[1].split("## Experiments")[0]
    told = [row.strip("|").split("|") for row in infos.splitlines() if row.startswith("| ")][1:]
    keys = {key for row in told for key in re.findall(r"`(\w+)`", row[1])}
    # Outputs that were added later have no counterpart in the published code.
    env = mw.parallel_env("O", rows=4, cols=4, n_pursuers=1, n_evaders=1)
    told_by_us = env.reset(seed=0)[1]["pursuer_0"].keys()
    assert keys == told_by_us - {"cost", "evader_survival_rate", "pursuer_survival_rate"}
    fields = {name for row in told for name in re.findall(r"`(\w+)[`\[]", row[2])}
    assert fields <= set(vars(env.status))


def test_options_and_arguments_that_replace_others() -> None:
    ours = {row.split("|")[2] for row in MIGRATION.splitlines() if row.count("|") == 3}
    told = {flag for cell in ours for flag in re.findall(r"--[a-z][a-z-]+", cell)}
    assert len(told) >= 8
    assert told <= visible_options(main.commands["evolve"]) | {"--figures"}
    assert all(schedule in MIGRATION for schedule in SCHEDULES)
    for name in re.findall(r"`((?:pursuer|evader)_(?:capture|neighbor|collide|step))", MIGRATION):
        assert name in mw.Rewards.__dataclass_fields__


# The page on files

FILES = read("docs/files.md")


def named(heading: str) -> dict[str, str]:
    """Names in the first column of a section's table, and what stands in the second column."""
    section = FILES.split(f"{heading}\n")[1].split("\n#")[0]
    found = {}
    for line in re.findall(r"^\| (`.+)$", section, re.M):
        names, second = line.split(" | ")[:2]
        found |= dict.fromkeys(re.findall(r"`([^`]+)`", names), second)
    return found


def check_arrays(
    file: Path, heading: str, *, parts: bool = False, optional: frozenset[str] = frozenset()
) -> None:
    """Compare names, numbers of axes and dtypes with the table of a section."""
    stated = named(heading)
    with np.load(file) as arrays:
        names = {name for name in arrays.files if not (parts and "." in name)}
        assert names | optional == {name for name in stated if "." not in name}
        for name in names:
            shape, dtype = stated[name].rsplit(" ", 1)
            axes = [axis for axis in shape.strip("()").split(",") if axis]
            assert arrays[name].ndim == len(axes), name
            found = arrays[name].dtype
            assert dtype == {"U": "str", "S": "bytes"}.get(found.kind, found.name), name
        if parts:
            teams = {name.split(".")[0] for name in arrays.files if "." in name}
            assert {f"{team}.*" for team in teams} <= set(stated)


def test_the_files_of_a_run(tmp_path: Path) -> None:
    assert named("### `log.csv`") == {name: kind.__name__ for name, kind in COLUMNS.items()}
    run = tmp_path / "run"
    start(tiny_race(), run, threads=1).run()
    genomes = np.load(run / "pursuers.npy")
    assert genomes.ndim == 2
    assert f"(G, genes) and (H, genes) {genomes.dtype}" in FILES
    other_team = frozenset({"evaders"})  # one team learns in a stage of this race
    check_arrays(run / "stage-0003.npz", "### `stage-0007.npz`", optional=other_team)
    check_arrays(run / "checkpoint-0004.npz", "### `checkpoint-0007.npz`", parts=True)
    check_arrays(run / "payoff.npz", "### `payoff.npz`")
    summary = json.loads((run / "summary.json").read_bytes())
    assert set(summary) == set(named("### `summary.json` of a race"))
    stated = named("## A run directory")
    made = {path.name for path in run.iterdir() if not path.name.startswith(".")}
    by_command = {"scores.json", "*.png"}
    assert {re.sub(r"\d{4}", "0007", name) for name in made} == set(stated) - by_command


def test_a_recorded_episode(tmp_path: Path) -> None:
    played = replace(mw.record("O", "chaser", "fleer", seed=0), seat=3)
    played.save(tmp_path / "episode.npz")
    check_arrays(tmp_path / "episode.npz", "## A recorded episode")


def test_each_promise_of_the_security_page_has_a_test() -> None:
    rows = re.findall(r"^\| .+$", read("SECURITY.md"), re.M)
    promises = [row for row in rows if not row.startswith(("| Promise", "| ---"))]
    assert promises
    for promise in promises:
        named = re.findall(r"`(tests/[\w/]+\.py)(?:::(\w+))?`", promise)
        assert named, promise
        for file, test in named:
            assert f"def {test or 'test_'}" in read(file), (file, test)
