"""``matrixworld bench``: what it prints, writes and refuses. Speed itself is not tested."""

from pathlib import Path

import numpy as np
import pytest

import matrixworld as mw
from command_line import MAIN_JOB, matrixworld_command
from matrixworld._util.checks import processor_name
from matrixworld._util.files import load_json
from matrixworld.cli import bench
from matrixworld.cli.bench import Timing, lines_of, matches_of
from matrixworld.coevolution import RaceSettings, start

SMALL = {"rows": 7, "cols": 6, "n_pursuers": 2, "n_evaders": 3, "fov": 5}
WORLD = [word for name, n in SMALL.items() for word in ("--set", f"world.{name}={n}")]
QUICK = ["bench", *WORLD, "--seconds", 0.02, "--hidden", "4"]
STEPS = [*["step only"] * 2, *["step and views"] * 3]
STEPS += [*["VectorEnv"] * 3, *["VectorEnv, copy=False"] * 3]


@pytest.fixture(autouse=True)
def own_kernels(monkeypatch: pytest.MonkeyPatch) -> None:
    """Run commands with the processor's own kernels."""
    monkeypatch.delenv("MATRIXWORLD_KERNELS", raising=False)


def timing(what: str, threads: int, *rates: float) -> Timing:
    """A timing of calls that play 10 worlds or matches, of 500 agent-steps in all."""
    return Timing(what, 10, threads, lambda call: None, 500, 20, "matches" in what, [*rates])


# What it prints and writes


def test_it_prints_and_writes_the_machine_a_table_and_durations():
    options = ["--threads", 2, "--hidden", "[]", "--json", "a.json"]
    result = matrixworld_command(*QUICK, "sb", *options)
    head, processor, world, _, titles, *rows = result.stdout.splitlines()
    assert head.startswith(f"matrixworld {mw.__version__}, NumPy {np.__version__}, Python 3.")
    assert "; kernels for " in processor
    assert world == "SB: 7 x 6 cells, 2 pursuers against 3 evaders, views of 5 x 5"
    assert titles.split()[:3] == ["at", "once", "threads"]
    written = load_json(Path("a.json"))
    assert written["machine"]["kernels"] in ("base", "x86-64-v3", "x86-64-v4")
    assert written["world"] == mw.WorldConfig("SB", **SMALL).to_json()
    assert written["evolve_seconds"] > 0
    lines = written["lines"]
    names = [*STEPS, *["matches, hidden 4"] * 2, *["matches, hidden none"] * 2]
    assert [line["what"] for line in lines] == names
    sizes = {(line["at_once"], line["threads"]) for line in lines}
    assert sizes == {(1024, 1), (1, 1), (1024, 2), (48, 1), (48, 2)}
    for row, line in zip(rows, lines, strict=False):
        assert row.startswith(line["what"])
        cells = row.removeprefix(line["what"]).split()
        numbers = [float(cell.strip("%").replace(",", "")) for cell in cells]
        assert len(numbers) == 5 + ("matches" in row) + (line["threads"] == 2)
        assert numbers[2] == pytest.approx(line["agent_steps_per_second"] / 1e6, abs=0.006)
        assert numbers[3] == pytest.approx(line["world_steps_per_second"], abs=0.6)
        assert line["agent_steps_per_second"] > line["world_steps_per_second"] > 0
        assert (line["over_one_thread"] is None) == (line["threads"] == 1)
    text = " ".join(result.stdout.split())
    assert "An agent-step is one step of a living agent" in text
    assert "The matches of matrixworld evolve in this world (matches, hidden 4) take about" in text
    assert text.endswith("Written: a.json")
    assert "of 75 timings" in result.stderr


# The figures


def test_rates_are_medians_and_multiples_of_one_thread():
    lines = lines_of(
        (
            timing("VectorEnv", 1, 1.0, 4.0, 2.0),
            timing("VectorEnv", 4, 3.0, 3.5, 1.0),
            timing("matches, hidden 32", 1, 2.0),
        )
    )
    assert [line["agent_steps_per_second"] for line in lines] == [1000, 1500, 1000]
    assert [line["world_steps_per_second"] for line in lines] == [40, 60, 40]
    assert [line["matches_per_second"] for line in lines] == [None, None, 20]
    assert [line["over_one_thread"] for line in lines] == [None, 1.5, None]
    assert lines[0]["spread"] == 1.5


def test_how_long_evolve_takes(tmp_path):
    races = [RaceSettings(schedule=name) for name in MAIN_JOB]
    # Elites and archives play no matches with the default settings.
    started = [start(race, tmp_path / race.schedule.name) for race in races]
    training = sum(race.training_matches() for race in started)
    evaluation = sum(race.total_matches() for race in started) - training
    assert matches_of(races) == pytest.approx(training + 2.5 * evaluation)


def test_the_share_of_living_agents():
    config = mw.WorldConfig("SDB", rows=9, cols=9, n_pursuers=2, n_evaders=2, max_steps=20)
    assert bench.alive_share(config) > 0.9
    deadly = mw.WorldConfig("D", rows=4, cols=4, n_pursuers=4, n_evaders=4, max_steps=20)
    assert bench.alive_share(deadly) < 0.6


def test_large_views_mean_fewer_worlds():
    assert bench.many_worlds(mw.WorldConfig("O")) == 1024
    assert bench.many_worlds(mw.WorldConfig("O", fov=255)) == 36
    crowd = mw.WorldConfig("O", n_pursuers=700, n_evaders=700, fov=255)
    assert bench.many_worlds(crowd) == 1


def test_a_processor_without_a_name(tmp_path):
    cpuinfo = tmp_path / "cpuinfo"
    cpuinfo.write_text("processor : 0\nmodel name\t: Abacus 3\nmodel name\t: Abacus 3\n")
    assert processor_name(cpuinfo) == "Abacus 3"
    assert processor_name(tmp_path / "nothing")


# What it refuses


BAD = [
    (["Q"], "expected one of D, R, B, O, S, SB, SD, SDB, TO"),
    (["--hidden", "4,x"], "policy.hidden: expected a sequence of ints, got '4,x'"),
    (["--json", "no/a.json"], "no/a.json: expected a directory that exists, got 'no'"),
]


@pytest.mark.parametrize(("options", "message"), BAD, ids=[" ".join(bad[0]) for bad in BAD])
def test_bad_options_are_refused_before_anything_is_measured(options, message):
    result = matrixworld_command("bench", *options, code=2)
    assert message in result.stderr
    assert result.stdout == ""
