"""What commands print: warnings, and text that others have written."""

import json
import warnings

from command_line import matrixworld_command
from matrixworld.cli.console import warnings_as_notes
from matrixworld.coevolution import DisengagementWarning


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
