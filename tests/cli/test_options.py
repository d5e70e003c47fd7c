"""Options that commands share: declared once, existing outputs, malformed values."""

import json
import os
import shlex
import shutil
import subprocess
import sys
from collections import defaultdict
from collections.abc import Iterator
from pathlib import Path

import click
import numpy as np
import pytest
from click.shell_completion import ShellComplete
from click.testing import CliRunner
from PIL import Image

from command_line import matrixworld_command, words
from matrixworld.cli import main
from matrixworld.coevolution import open_run
from matrixworld.coevolution.settings import MOST_SEED

DIFFERENT = {"--episodes", "--explain", "--each", "--out", "--seconds", "--seed", "--generation"}
"""Options that differ between commands: `tournament` plays episodes, `judge` has to be told how
many there were; `judge` explains a judgement, `replay` the steps; `--each` judges or draws
each run; `--out` has another file by default. `class` limits the seconds of programs and
draws a seed that nobody knows, and `class export` takes one generation."""

BENCH = [word for each in ("rows=7", "cols=6") for word in ("--set", f"world.{each}")]


# Declared once


def commands() -> dict[str, click.Command]:
    """Return all commands, those of `class` by their own names."""
    groups = {name: each for name, each in main.commands.items() if isinstance(each, click.Group)}
    parts = {name: part for each in groups.values() for name, part in each.commands.items()}
    return {name: each for name, each in main.commands.items() if name not in groups} | parts


def test_options_of_one_name_are_equal_in_all_commands():
    found: dict[str, set[tuple[object, ...]]] = defaultdict(set)
    for command in commands().values():
        for option in command.params:
            if isinstance(option, click.Option):
                meaning = (option.help, repr(option.default), repr(option.type), option.multiple)
                found[option.opts[0]].add(meaning)
    assert {name for name, meanings in found.items() if len(meanings) > 1} == DIFFERENT


def test_summaries_fit_into_the_list_of_commands():
    summaries = {name: each.get_short_help_str(200) for name, each in main.commands.items()}
    assert {name: text for name, text in summaries.items() if len(text) > 45} == {}


def test_every_command_that_names_an_output_file_has_force():
    for name, command in commands().items():
        flags = {flag for param in command.params for flag in param.opts}
        # These name a directory; what the same command has begun goes on, and nothing is replaced.
        if flags & {"--json", "--out"} and name not in ("evolve", "exploit"):
            assert "--force" in flags, name


@pytest.mark.parametrize("seed", [-1, MOST_SEED + 1])
@pytest.mark.parametrize("command", [["evolve", "--out", "out"], ["replay", "O"]])
def test_the_range_of_seeds(command, seed):
    said = matrixworld_command(*command, "--seed", seed, code=2).stderr
    assert f"'--seed': expected 0 to {MOST_SEED}, got {seed}" in said
    assert not Path("out").exists()


# Existing outputs

TOURNAMENT = ["tournament", "run", "--episodes", 2]
OUTPUTS = {
    "replay": (["replay", "O", "--steps", 5, "--out", "new.png", "--out", "old.npz"], "old.npz"),
    "score": (["score", "run", "--episodes", 2, "--json", "old.json"], "old.json"),
    "judge": (["judge", "circle.csv", "--json", "old.json"], "old.json"),
    "tournament": ([*TOURNAMENT, "--out", "old.npz"], "old.npz"),
    "tournament's figure": ([*TOURNAMENT, "--out", "old.npz"], "old.png"),
    "tournament in the run": (TOURNAMENT, "run/tournament-2x12-seed0.npz"),
    "a page": (["explore", "run", "--no-open"], "run/explorer.html"),
    "figures": (["explore", "--figures", "run"], "run/training.png"),
    "a figure": (["explore", "run", "--figure", "payoff", "--out", "old.png"], "old.png"),
    "bench": (
        ["bench", *BENCH, "--seconds", 0.01, "--threads", 1, "--hidden", 2, "--json", "old.json"],
        "old.json",
    ),
}
"""Commands that write files, and one of these files."""


@pytest.mark.parametrize(("command", "output"), OUTPUTS.values(), ids=OUTPUTS)
def test_an_existing_output_is_replaced_with_force_only(run, command, output):
    shutil.copytree(run, "run2")
    rates = np.random.default_rng(0).random((14, 14))
    np.savetxt("circle.csv", rates, delimiter=",")
    file = Path(output)
    file.write_bytes(b"precious")
    before = {path: path.read_bytes() for path in Path().rglob("*") if path.is_file()}

    refused = matrixworld_command(*command, code=2)
    assert f"Error: {file}: exists; give --force to replace it\n" in refused.stderr
    assert refused.stdout == ""  # it is refused before anything is played
    assert {path: path.read_bytes() for path in Path().rglob("*") if path.is_file()} == before

    matrixworld_command(*command, "--force")
    assert file.read_bytes() != b"precious"
    for kept in ("config.json", "pursuers.npy", "payoff.npz", "summary.json", "stage-0001.npz"):
        assert (run / kept).read_bytes() == before[run / kept]


@pytest.mark.skipif(not Path("/proc").exists(), reason="needs a directory that takes no files")
def test_a_directory_that_takes_no_files_is_refused_first(run):
    said = matrixworld_command("score", "run", "--json", "/proc/scores.json", code=2)
    assert "expected a directory in which files can be made, got '/proc'" in said.stderr
    assert said.stdout == ""


def test_numbers_on_standard_output(run):
    for command in (["judge", "run"], ["score", "run", "--episodes", 2]):
        done = matrixworld_command(*command, "--json", "-")
        assert [*json.loads(done.stdout)["groups"]] == ["run"]
        assert "run" in done.stderr
    assert not Path("-").exists()


@pytest.mark.parametrize("suffix", ["gif", "mp4", "png"])
def test_a_picture_of_an_episode_is_drawn_again_and_a_user_s_is_kept(suffix):
    if suffix == "mp4":
        pytest.importorskip("imageio_ffmpeg")
    draw = ["replay", "O", "--pursuer", "random", "--steps", 9, "--out", f"it.{suffix}"]
    matrixworld_command(*draw)
    drawn = Path(f"it.{suffix}").read_bytes()
    matrixworld_command(*draw, "--seed", 1)
    assert Path(f"it.{suffix}").read_bytes() != drawn
    Image.new("RGB", (8, 8)).save("mine.png")
    Path(f"it.{suffix}").write_bytes(Path("mine.png").read_bytes())
    assert "give --force to replace it" in matrixworld_command(*draw, code=2).stderr


@pytest.mark.parametrize("force", [[], ["--force"]])
def test_a_directory_is_never_replaced(run, force):
    shutil.copytree(run, "old.json")
    said = matrixworld_command("score", "run", "--json", "old.json", *force, code=2).stderr
    assert "old.json: expected a file, got a directory" in said
    assert open_run("old.json").files.finished


def test_a_payoff_goes_to_an_npz_file(run):
    said = matrixworld_command("tournament", "run", "--out", "payoff.png", code=2).stderr
    assert "--out: expected a name that ends in .npz, got payoff.png" in said


# Ctrl-C


@pytest.mark.parametrize("words", [words for words, _ in OUTPUTS.values()], ids=OUTPUTS)
def test_ctrl_c_prints_the_command_that_starts_again(run, monkeypatch, words):
    def stopped(**options: object) -> None:
        raise KeyboardInterrupt

    shutil.copytree(run, "run2")
    np.savetxt("circle.csv", np.full((6, 6), 0.5), delimiter=",")
    # Whatever it does, it is stopped at once.
    monkeypatch.setattr(main.commands[words[0]], "callback", stopped)
    said = matrixworld_command(*words, code=130).stderr
    assert said.endswith(f"To start again:\n  {shlex.join(['matrixworld', *map(str, words)])}\n")
    assert "Aborted" not in said


# Environment variables


@pytest.mark.parametrize(
    ("variable", "message"),
    [
        ("MATRIXWORLD_KERNELS", "MATRIXWORLD_KERNELS: expected base, x86-64-v3 or"),
        ("MPLBACKEND", "MPLBACKEND: 'wrong' is not a valid value"),
    ],
)
def test_a_wrong_environment_variable_is_told_in_a_sentence(variable: str, message: str):
    done = started("playground", {variable: "wrong"})
    assert (done.returncode, done.stdout) == (1, "")
    assert done.stderr.startswith(f"Error: {message}")
    assert len(done.stderr.splitlines()) == 1
    assert list(Path().iterdir()) == []


def test_pages_are_written_without_docstrings():
    done = started("playground", {"PYTHONOPTIMIZE": "2"})
    assert done.returncode == 0, done.stderr
    assert Path("playground.html").exists()


@pytest.mark.parametrize(
    ("typed", "offered"),
    [
        (["evolve", "--variant", "s"], ["S", "SB", "SD", "SDB"]),
        (["evolve", "--learner", "c"], ["cma"]),
        (["evolve", "--schedule", "h"], ["hall-of-fame"]),
        (["bench", "t"], ["TO"]),
    ],
)
def test_a_shell_completes_names(typed: list[str], offered: list[str]):
    *words, incomplete = typed
    found = ShellComplete(main, {}, "matrixworld", "").get_completions(words, incomplete)
    assert [item.value for item in found] == offered


def started(command: str, environment: dict[str, str]) -> subprocess.CompletedProcess[str]:
    """Run a command in a process of its own."""
    return subprocess.run(
        [sys.executable, "-m", "matrixworld", command],
        env={**os.environ, "PYTHONPATH": os.pathsep.join(sys.path), **environment},
        capture_output=True,
        text=True,
        check=False,
    )


# ---- Malformed values of every option: a message, no traceback, and nothing written ----


LONG = "1" + "0" * 5000
MALFORMED = ("", "nan", "-inf", "1e400", "-1", "2.5e-3x", "1" + "0" * 400, LONG)
"""Values of an option; none is a size, or a name of something that exists."""

ARGUMENTS = {
    "evolve": ["--out", "new", *words({"generations": 1, "pursuer_epochs": 1, "evader_epochs": 1})],
    "tournament": ["run", "--episodes", "2"],
    "score": ["run", "--episodes", "2"],
    "exploit": ["run", "--champion", "pursuer", "--matches", "50", "--episodes", "2"],
    "replay": ["run", "--out", "new.png"],
    "explore": ["run", "--figures"],
    "bench": ["--set", "world.rows=6", "--set", "world.cols=6", "--seconds", "0.01"],
}
"""Arguments that make a command valid."""
LEGAL = {(name, "-1") for name in ("--pursuer", "--evader", "--generation", "--step")}
"""The last generation or step."""
FILES = {"--json", "--out"}
"""Options that take any name of a file that can exist."""


def options() -> Iterator[pytest.ParameterSet]:
    """Yield every option that takes a value, of every command above."""
    for name in ARGUMENTS:
        for param in main.commands[name].params:
            if not getattr(param, "is_flag", True):
                yield pytest.param(name, param.opts[0], id=f"{name}{param.opts[0]}")


def contents() -> dict[Path, tuple[int, bytes]]:
    """Return all files below the working directory, with times and contents."""
    files = [path for path in Path().rglob("*") if path.is_file()]
    return {path: (path.stat().st_mtime_ns, path.read_bytes()) for path in files}


@pytest.mark.usefixtures("run")
@pytest.mark.parametrize(("command", "option"), list(options()))
def test_a_malformed_value_is_refused_and_nothing_is_written(command: str, option: str) -> None:
    before = contents()
    # No file can have a name of 5001 characters.
    for value in (LONG,) if option in FILES else MALFORMED:
        if (option, value) in LEGAL:
            continue
        result = CliRunner().invoke(main, [command, *ARGUMENTS[command], option, value])
        assert isinstance(result.exception, SystemExit), (value[:20], result.exception)
        assert result.exit_code in (1, 2)
        assert "Error: " in result.stderr
        assert contents() == before, value[:20]
        assert {path.name for path in Path().iterdir()} == {"run"}


def test_the_arguments_are_valid_without_a_malformed_value(run: Path) -> None:
    for command, arguments in ARGUMENTS.items():
        if command in ("tournament", "score", "replay"):
            assert CliRunner().invoke(main, [command, *arguments]).exit_code == 0, command
