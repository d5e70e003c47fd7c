"""What commands print while they work: progress as lines or as a bar, and warnings."""

import io
import json
import os
import re
import warnings
from collections.abc import Iterator
from pathlib import Path

import pytest
from tqdm import tqdm

from command_line import matrixworld_command
from matrixworld import cli
from matrixworld.cli.console import note, print_table, warnings_as_notes
from matrixworld.coevolution import DisengagementWarning, Progress, ProgressBar
from matrixworld.coevolution.progress import LAYOUT


class Terminal(io.StringIO):
    def isatty(self) -> bool:
        return True


def test_progress_lines_without_a_terminal():
    seconds: Iterator[float] = iter([0.0, 1.0, 2.0, 3.0, 4.0])
    out = io.StringIO()
    lines = ProgressBar(stream=out, clock=lambda: next(seconds))
    for done in (100, 150, 300, 350, 600):
        lines(Progress("evaders", done, 1000, 100))
    assert out.getvalue().splitlines() == [
        " 30%  300 of 1,000 matches, 100 a second, 00:07 left (evaders)",
        " 60%  600 of 1,000 matches, 125 a second, 00:03 left (evaders)",
    ]


def test_progress_lines_of_a_job():
    out = io.StringIO()
    lines = ProgressBar(stream=out)
    for done in range(0, 101, 5):
        runs = {"seed-1": Progress("generation 1", done, 200)}
        what = "1 of 4 runs, 1 failed" if done > 50 else "1 of 4 runs"
        lines(Progress(what, done, 100, 0, runs))
    said = out.getvalue().splitlines()
    assert len(said) == 10
    first = r" 10%  10 of 100 matches, .* left \(1 of 4 runs, seed-1 5%\)"
    assert re.fullmatch(first, said[0])
    assert "(1 of 4 runs, 1 failed, seed-1 50%)" in said[-1]


def test_bars_in_a_terminal_have_a_line_for_each_run_in_work():
    out = Terminal()
    with ProgressBar(stream=out) as bar:
        runs = {f"seed-{seed}": Progress("generation 1", 10, 100) for seed in range(2)}
        bar(Progress("0 of 3 runs", 20, 300, 0, runs))
        del runs["seed-0"]
        bar(Progress("1 of 3 runs", 150, 300, 0, runs))
    said = out.getvalue()
    assert "seed-0: generation 1" in said
    assert re.search(r" 50%\|[#█]{8} {8}\| .* left, .*matches/s, 150 of 300, 1 of 3 runs", said)


@pytest.mark.parametrize("columns", [60, 100])
def test_a_narrow_terminal_shows_bar_and_time_left(columns):
    meter = tqdm.format_meter(
        116_000,
        260_000,
        45.3,
        ncols=columns,
        prefix="[2/3] pursuers, generation 12 of 30",
        unit=" matches",
        unit_scale=True,
        bar_format=LAYOUT,
    )
    assert len(meter) <= columns
    assert re.match(r" 45%\|█{7}. {8}\| 00:56 left, 2.56k matches/s", meter)


def test_warnings_for_users_are_lines_of_their_own(capsys):
    with warnings_as_notes():
        warnings.warn("the pursuers win nearly everything", DisengagementWarning, stacklevel=1)
    assert capsys.readouterr().err == "Warning: the pursuers win nearly everything\n"
    with pytest.raises(DeprecationWarning), warnings_as_notes():
        warnings.warn("for developers", DeprecationWarning, stacklevel=1)


# Text that others have written:

EVIL = "a\x1b]0;owned\x07\u202efdp.exe\x9b31m\udcff"
"""Sets the title of the terminal, rings, turns the direction of text round, has a color."""
SHOWN = r"a\x1b]0;owned\x07\u202efdp.exe\x9b31m\udcff"


def test_names_and_files_give_a_terminal_no_orders(run: Path, tmp_path: Path) -> None:
    evil = tmp_path / EVIL
    run.rename(evil)
    scored = matrixworld_command("judge", evil)
    refused = matrixworld_command("explore", tmp_path / EVIL / EVIL, code=2)
    config = json.loads((evil / "config.json").read_text())
    (evil / "config.json").write_text(json.dumps({**config, "format": EVIL}))
    told = matrixworld_command("judge", evil, code=1)
    for output in (scored.output, refused.output, told.output):
        assert "".join(output.split("\n")).isprintable(), output
    assert SHOWN in "".join(refused.output.split("\n"))
    assert r"\x1b]0;owned" in told.output


def test_tables_and_notes_show_escapes_as_they_stand(capsys: pytest.CaptureFixture[str]) -> None:
    print_table([("name", "rank"), (EVIL, "1")], "<>")
    note(EVIL)
    out, err = capsys.readouterr()
    assert out.splitlines()[1] == f"{SHOWN}     1"
    assert err == f"{SHOWN}\n"


def test_one_function_prints() -> None:
    folder = Path(os.fspath(cli.__path__[0]))
    others = [path for path in folder.glob("*.py") if path.name != "console.py"]
    printing = re.compile(r"click\.s?echo|(?<![\w.])print\(|tqdm\.write|(out|err)\.write\(")
    assert [path.name for path in others if printing.search(path.read_text("utf-8"))] == []
