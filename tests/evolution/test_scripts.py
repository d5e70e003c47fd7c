"""The scripts in evolution/ run, go on where they stopped, and their numbers are correct."""

import random
import sys
from pathlib import Path

import numpy as np
import pytest

import common
import readable
from evolution_scripts import RESULTS, SCRIPTS, read, run_quickly
from tiny_race import tiny_race

NAMES = sorted(
    path.relative_to(SCRIPTS).with_suffix("").as_posix()
    for path in SCRIPTS.rglob("*.py")
    if 'if __name__ == "__main__"' in read(path) and path.stem != "claims"  # no experiment
)
ONCE = {
    "evolve_held_out", "mask_price", "scripted_pursuit",
    "validation/interval_coverage", "validation/page_races",
}  # fmt: skip
"""Scripts that tell the time that they took, or keep nothing that makes a second run shorter."""


def stamps(place):
    """Return when each file below a directory was written."""
    return {path: path.stat().st_mtime_ns for path in place.rglob("*") if path.is_file()}


@pytest.mark.nightly
@pytest.mark.parametrize("name", NAMES)
def test_a_quick_run_writes_elsewhere_and_says_the_same_again(name, tmp_path):
    published = stamps(RESULTS)
    told = run_quickly(name, tmp_path)
    written = stamps(tmp_path)
    assert told
    assert written or "Written" not in told
    assert all("quick" in path.relative_to(tmp_path).parts for path in written)
    for file in tmp_path.rglob("table.md"):
        assert told.startswith(read(file))
    if name not in ONCE:
        assert run_quickly(name, tmp_path) == told
    runs = tmp_path.rglob("runs/**/payoff.npz")
    assert all(path.stat().st_mtime_ns == written[path] for path in runs)
    assert stamps(RESULTS) == published


def kinds(quick):
    return {
        f"races, {n} epochs": tiny_race().changed(epochs(n)) for n in ((1,) if quick else (1, 2))
    }


def epochs(n):
    return {"schedule.pursuer_epochs": n, "schedule.evader_epochs": n}


def later(runs, quick):
    begun = runs["races, 1 epochs"]
    return {"later": [run.settings.changed({"seed": run.settings.seed + 5}) for run in begun]}


def measure(runs, quick):
    def of_run(run):
        return {"seed": run.settings.seed, "rates": run.payoff().matrix}

    return {**common.by_seed(runs, of_run), "count": len(runs)}


def played(monkeypatch, *options, **others):
    monkeypatch.setattr(sys, "argv", ["place/script.py", "--threads", "1", *options])
    common.experiment(
        "What is asked?",
        kinds=kinds,
        measure=measure,
        table=lambda numbers: ", ".join(common.kinds_in(numbers)),
        **{"seeds": 2, **others},
    )


def test_an_experiment_keeps_numbers_by_kind_and_seed(tmp_path, monkeypatch, capsys, no_processes):
    monkeypatch.chdir(tmp_path)
    played(monkeypatch, "--kinds", "races-2")
    assert capsys.readouterr().out.startswith("races, 2 epochs\n")
    file = tmp_path / "script/numbers.npz"
    assert list(np.load(file)["races, 2 epochs / seed"]) == [0, 1]
    # Numbers of other kinds stay, and runs are not played again.
    ended = (tmp_path / "runs/script/races-2-epochs/1/payoff.npz").stat().st_mtime_ns
    played(monkeypatch, then=later, seeds={"races, 1 epochs": 2, "races, 2 epochs": 1})
    assert capsys.readouterr().out.startswith("races, 2 epochs, races, 1 epochs, later\n")
    numbers = dict(np.load(file))
    assert list(numbers["races, 2 epochs / seed"]) == [0]
    assert list(numbers["later / seed"]) == [5, 6]
    assert numbers["count"] == 3
    shape = np.shape(numbers["later / rates"][0])
    assert numbers["races, 1 epochs / rates"].shape == (2, *shape)
    again = (tmp_path / "runs/script/races-2-epochs/1/payoff.npz").stat().st_mtime_ns
    assert again == ended
    assert read(tmp_path / "script/table.md").startswith("races, 2 epochs")


def test_an_unknown_kind_is_refused(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    with pytest.raises(SystemExit):
        played(monkeypatch, "--kinds", "race-3")
    assert "races-1-epochs, races-2-epochs, got race-3" in capsys.readouterr().err
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize(("options", "fewest"), [((), 1), (("--quick",), 2)])
def test_too_few_seeds_are_refused(options, fewest, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    with pytest.raises(SystemExit):
        played(monkeypatch, "--seeds", str(fewest - 1), *options, fewest=fewest)
    assert f"--seeds: expected at least {fewest}, got {fewest - 1}" in capsys.readouterr().err
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize(("options", "below"), [((), ""), (("--quick",), "quick")])
def test_a_quick_run_has_directories_of_its_own(options, below, monkeypatch):
    monkeypatch.setattr(sys, "argv", ["place/script.py"])
    parser = common.script_parser("What?", quick="seconds", runs=True)
    usual = parser.parse_args(options)
    assert (usual.runs, usual.results) == (Path("runs/script", below), Path("script", below))
    assert parser.parse_args([*options, "--results", "kept"]).results == Path("kept", below)


def test_the_readable_example_evolves_programs_that_beat_untrained_ones():
    random.seed(2)
    champions = readable.co_evolve(3, 3, 20)
    for team, other in (readable.TEAMS, readable.TEAMS[::-1]):
        first, *_, last = champions[team]
        rivals = {"rivals": champions[other], "seeds": range(100, 116)}
        before, after = readable.play(team, [first, last], **rivals)
        assert after > before + 0.1
        assert len(last) <= readable.PROGRAM.length
