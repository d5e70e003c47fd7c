"""What commands share: options declared once, outputs, seeds, warnings, and text of others."""

import json
import warnings
from collections import defaultdict
from contextlib import nullcontext
from pathlib import Path

import click
import pytest

import matrixworld
from command_line import matrixworld_command
from matrixworld.cli import main
from matrixworld.cli.console import warnings_as_notes
from matrixworld.cli.options import seeds_of
from matrixworld.coevolution import DisengagementWarning
from scripts import python

DIFFERENT = {
    "--force", "--episodes", "--explain", "--each", "--out", "--generation", "--team", "--world",
}  # fmt: skip
"""Options that differ between commands: `tournament` plays episodes, `judge` has to be told how
many there were; `judge` explains a judgement, `replay` the steps; `--each` judges or draws each
run; `--out` has another file by default; `score` takes all generations, too; `grade` chooses among
the teams of its players, and worlds of its suite by number."""


def test_options_of_one_name_are_equal_in_all_commands():
    found = defaultdict(set)
    for command in main.commands.values():
        for option in command.params:
            if isinstance(option, click.Option):
                meaning = (option.help, repr(option.default), repr(option.type), option.multiple)
                found[option.opts[0]].add(meaning)
    assert {name for name, meanings in found.items() if len(meanings) > 1} == DIFFERENT


OUTPUTS = {
    "score": (["score", "run", "--episodes", 2, "--json", "old.json"], "old.json"),
    "tournament": (["tournament", "run", "--episodes", 2], "run/tournament-2-seed0.png"),
    "a page": (["explore", "run", "--no-open"], "run/explorer.html"),
    "figures": (["explore", "run", "--figures"], "run/training.png"),
    "replay": (["replay", "O", "--steps", 5, "--out", "old.npz"], "old.npz"),
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


def test_the_package_is_a_command_and_needs_no_docstrings():
    done = python("-OO", "-m", "matrixworld", "--version")
    assert done.stdout == f"matrixworld, version {matrixworld.__version__}\n"


@pytest.mark.parametrize(
    ("text", "seeds"),
    [
        ("0-9", tuple(range(10))),
        ("0,3,5-7", (0, 3, 5, 6, 7)),
        ("9,1", (9, 1)),
        ("0-3,7,2", (0, 1, 2, 3, 7)),
        *((bad, None) for bad in ["", "a", "1-", "-1", "1,,2", "1 2", "0-1-2", "1.5", "5-2"]),
        ("0-9223372036854775807", None),
    ],
)
def test_seeds_that_a_text_names(text, seeds):
    context = click.Context(click.Command("evolve")), click.Option(["--seeds"])
    with nullcontext() if seeds else pytest.raises(click.BadParameter, match="expected .*seeds"):
        assert seeds_of(*context, text) == seeds


def test_warnings_for_users_are_lines_of_their_own(capsys):
    with warnings_as_notes():
        warnings.warn("the pursuers win nearly everything", DisengagementWarning, stacklevel=1)
    assert capsys.readouterr().err == "Warning: the pursuers win nearly everything\n"


EVIL = "a\x1b]0;owned\x07\u202efdp.exe\x9b31m\udcff"
"""Sets the title of the terminal, rings, turns the direction of text round, has a color."""
SHOWN = r"a\x1b]0;owned\x07\u202efdp.exe\x9b31m\udcff"


def test_names_and_files_give_a_terminal_no_orders(run, tmp_path):
    evil = tmp_path / EVIL
    run.rename(evil)
    config = json.loads((evil / "config.json").read_text())
    told = matrixworld_command("judge", evil).output
    assert SHOWN in "".join(told.split("\n"))
    (evil / "config.json").write_text(json.dumps({**config, "format": EVIL}))
    told += matrixworld_command("judge", evil, code=1).output
    assert "".join(told.split("\n")).isprintable(), told
