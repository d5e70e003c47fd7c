"""The scripts in evolution/ run, go on where they stopped, and their numbers are correct."""

import random
import re
import sys

import numpy as np
import pytest

import common
import readable
from evolution_scripts import SCRIPTS, read, run_quickly
from tiny_race import tiny_race

LIBRARIES = {"common", "paper_runs", "tabular"}
NAMES = sorted({path.stem for path in SCRIPTS.glob("*.py")} - LIBRARIES)
WITH_TORCH = re.compile("actor_critic|convergence|paper_surrounding|safe_learning")
ONCE = {"evolve_held_out", "scripted_pursuit"}
"""Scripts that tell the time that they took, or keep no runs."""


@pytest.mark.nightly
@pytest.mark.parametrize("name", NAMES)
def test_a_script_says_the_same_again_from_what_it_keeps(name, tmp_path):
    if WITH_TORCH.match(name):
        pytest.importorskip("torch")
    told = run_quickly(name, tmp_path)
    for file in tmp_path.rglob("table.md"):
        assert told.startswith(read(file))
    runs = {path: path.stat().st_mtime_ns for path in tmp_path.rglob("runs/**/payoff.npz")}
    if name not in ONCE:
        assert run_quickly(name, tmp_path) == told
    assert runs == {path: path.stat().st_mtime_ns for path in runs}


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


def test_the_readable_example_evolves_programs_that_beat_untrained_ones():
    random.seed(2)
    champions = readable.co_evolve(3, 3, 20)
    for team, other in (readable.TEAMS, readable.TEAMS[::-1]):
        first, *_, last = champions[team]
        rivals = {"rivals": champions[other], "seeds": range(100, 116)}
        before, after = readable.play(team, [first, last], **rivals)
        assert after > before + 0.1
        assert len(last) <= readable.PROGRAM.length
