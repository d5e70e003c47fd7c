"""Options that commands share: declared once, existing outputs, Ctrl-C, seeds, completion."""

import json
import os
import shlex
import subprocess
import sys
from collections import defaultdict
from pathlib import Path

import click
import pytest
from click.shell_completion import ShellComplete
from PIL import Image

import matrixworld
from command_line import matrixworld_command
from matrixworld.cli import main
from matrixworld.cli.options import seeds_of

DIFFERENT = {"--episodes", "--explain", "--each", "--out", "--seed", "--generation"}
"""Options that differ between commands: `tournament` plays episodes, `judge` has to be told how
many there were; `judge` explains a judgement, `replay` the steps; `--each` judges or draws
each run; `--out` has another file by default. `class` draws a seed that nobody knows, and
`class export` takes one generation."""


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


# Existing outputs

OUTPUTS = {
    "score": (["score", "run", "--episodes", 2, "--json", "old.json"], "old.json"),
    "tournament": (["tournament", "run", "--episodes", 2], "run/tournament-2x12-seed0.png"),
    "a page": (["explore", "run", "--no-open"], "run/explorer.html"),
    "figures": (["explore", "run", "--figures"], "run/training.png"),
    "replay": (["replay", "O", "--steps", 5, "--out", "new.png", "--out", "old.npz"], "old.npz"),
}
"""Commands that write files, and one of these files."""


@pytest.mark.parametrize(("command", "output"), OUTPUTS.values(), ids=OUTPUTS)
def test_an_existing_output_is_replaced_with_force_only(run, command, output):
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


@pytest.mark.parametrize("suffix", ["gif", "mp4", "png"])
def test_a_picture_of_an_episode_is_drawn_again_and_a_user_s_is_kept(suffix):
    if suffix == "mp4":
        pytest.importorskip("imageio_ffmpeg")

    def draw(*words: object, code: int = 0) -> str:
        game = ["replay", "O", "--pursuer", "random", "--steps", 9, "--out", f"it.{suffix}"]
        return matrixworld_command(*game, *words, code=code).stderr

    draw()
    drawn = Path(f"it.{suffix}").read_bytes()
    draw("--seed", 1)
    assert Path(f"it.{suffix}").read_bytes() != drawn
    Image.new("RGB", (8, 8)).save("mine.png")
    Path(f"it.{suffix}").write_bytes(Path("mine.png").read_bytes())
    assert "give --force to replace it" in draw(code=2)


def test_numbers_on_standard_output(run):
    done = matrixworld_command("judge", "run", "--json", "-")
    assert [*json.loads(done.stdout)["groups"]] == ["run"]
    assert "run" in done.stderr
    assert not Path("-").exists()


# Ctrl-C, processes, completion, seeds


def test_ctrl_c_prints_the_command_that_starts_again(monkeypatch):
    def stopped(**options: object) -> None:
        raise KeyboardInterrupt

    words = ["replay", "O", "--steps", 5, "--out", "my film.gif"]
    monkeypatch.setattr(main.commands["replay"], "callback", stopped)
    said = matrixworld_command(*words, code=130).stderr
    assert said.endswith(f"To start again:\n  {shlex.join(['matrixworld', *map(str, words)])}\n")


@pytest.mark.parametrize(
    ("words", "printed"),
    [(["--version"], f"matrixworld, version {matrixworld.__version__}\n"),
     (["playground", "--no-open"], "playground.html\n")],
)  # fmt: skip
def test_the_package_is_a_command_and_needs_no_docstrings(words, printed):
    environment = {"PYTHONPATH": os.pathsep.join(sys.path), "PYTHONOPTIMIZE": "2"}
    command = [sys.executable, "-m", "matrixworld", *words]
    done = subprocess.run(
        command, env=os.environ | environment, capture_output=True, text=True, check=True
    )
    assert done.stdout == printed


@pytest.mark.parametrize(
    ("typed", "offered"),
    [
        (["evolve", "--variant", "s"], ["S", "SB", "SD", "SDB"]),
        (["evolve", "--learner", "c"], ["cma"]),
        (["evolve", "--schedule", "h"], ["hall-of-fame"]),
    ],
)
def test_a_shell_completes_names(typed, offered):
    *words, incomplete = typed
    found = ShellComplete(main, {}, "matrixworld", "").get_completions(words, incomplete)
    assert [item.value for item in found] == offered


CONTEXT = click.Context(click.Command("evolve")), click.Option(["--seeds"])


@pytest.mark.parametrize(
    ("text", "seeds"),
    [
        ("0-9", tuple(range(10))),
        ("0,3,5-7", (0, 3, 5, 6, 7)),
        ("9,1", (9, 1)),
        ("9223372036854775807", (2**63 - 1,)),
        ("0-99999", tuple(range(100_000))),  # as many as are allowed
    ],
)
def test_seeds_that_a_text_names(text, seeds):
    assert seeds_of(*CONTEXT, text) == seeds


@pytest.mark.parametrize(
    ("text", "message"),
    [
        *((bad, "such as 0-9 or 0,3,5-7") for bad in ["", "a", "1-", "-1", "1,,2", "1 2", "0-1-2"]),
        ("1.5", "such as 0-9 or 0,3,5-7"),
        ("5-2", "the lower seed first, got 5-2"),
        ("0-3,7,2", "each seed once"),
        ("9223372036854775808", "seeds from 0 to 9223372036854775807, got 922"),
        ("0-9223372036854775807", "at most 100,000 seeds, got 9,223,372,036,8"),
    ],
)
def test_seeds_that_a_text_does_not_name(text, message):
    with pytest.raises(click.BadParameter, match=message):
        seeds_of(*CONTEXT, text)
