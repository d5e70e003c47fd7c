"""``matrixworld diagnose``."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from command_line import matrixworld_command
from matrices import circular, logistic
from matrixworld.coevolution import start
from matrixworld.files import load_json
from tiny_race import StopAt, tiny_race, tiny_single


@pytest.fixture(autouse=True)
def elsewhere(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Run commands in a temporary directory."""
    monkeypatch.chdir(tmp_path)


@pytest.fixture(scope="module")
def job(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A directory of two finished races of twelve generations, with different seeds."""
    output = tmp_path_factory.mktemp("job")
    for seed in (1, 2):
        changes = {"generations": 12, "pursuer_epochs": 1, "evader_epochs": 1, "eval_episodes": 4}
        start(tiny_race(seed=seed, **changes), output / str(seed), threads=1).run()
    return output


def words(output: str) -> str:
    """Return the output without line breaks."""
    return " ".join(output.split())


def test_a_run_is_diagnosed_by_its_episodes(job):
    result = matrixworld_command("diagnose", job / "1", "--json", "found.json")
    text = words(result.output)
    assert "A single run, 13 pursuer and 13 evader generations:" in text
    assert "It does not show what the same settings do with another seed" in text
    for name in ("Arms race:", "Cycling:", "Disengagement:", "Forgetting:", "Stagnation:"):
        assert name in text
    assert max(map(len, result.output.splitlines())) <= 100
    assert text.endswith("Terms are explained in docs/glossary.md. Written: found.json")
    found = load_json(Path("found.json"))
    assert found["runs"] == 1
    evidence = found["findings"][0]["evidence"]
    assert evidence["least_rise"]["over"] == "episodes"
    assert evidence["least_rise"]["samples"] == 4


def test_several_runs_are_diagnosed_together(job):
    by_name = matrixworld_command("diagnose", job / "1", job / "2", "--json", "one.json").output
    again = matrixworld_command("diagnose", job, "--json", "one.json", "--force").output
    assert again == by_name
    assert "2 runs, 13 pursuer and 13 evader generations:" in words(by_name)
    assert "This is a single run" not in words(by_name)
    evidence = json.loads(Path("one.json").read_text())["findings"][1]["evidence"]
    assert evidence["checkerboards"]["over"] == "runs"


def test_files_of_payoffs():
    np.savetxt("circle.csv", circular(31), delimiter=",", header="x", comments="# ")
    np.savez("race.npz", payoff=logistic(31, 0.3))
    circle = words(matrixworld_command("diagnose", "circle.csv").output)
    assert "evader generations: cycling, forgetting." in circle
    assert "Cycling: present (confidence" in circle
    assert "a hall of fame" in circle
    race = words(matrixworld_command("diagnose", "race.npz").output)
    assert "evader generations: arms race." in race
    both = words(matrixworld_command("diagnose", "race.npz", "circle.csv").output)
    assert "Cycling: cannot tell" in both


def test_what_cannot_be_diagnosed_is_refused(job):
    Path("empty").mkdir()
    refused = matrixworld_command("diagnose", "empty", code=2).output
    assert "expected run directories, or .csv or .npz files, got 'empty'" in words(refused)
    Path("bad.csv").write_text("0.5,2\n0.5,0.5\n")
    refused = matrixworld_command("diagnose", "bad.csv", code=2).output
    assert "expected a capture rate in [0, 1], got 2" in words(refused)
    np.save("other.npy", circular(31))
    np.savez("small.npz", payoff=circular(12))
    refused = matrixworld_command("diagnose", job / "1", "small.npz", "--json", "x.json", code=2)
    assert "expected the generations of" in words(refused.output)
    assert "(13, 13), got (12, 12)" in words(refused.output)
    assert not Path("x.json").exists()
    assert "other.npy" in matrixworld_command("diagnose", "other.npy", code=2).output


def test_unfinished_runs_and_runs_of_one_team_are_refused():
    start(tiny_single(), "alone", threads=1).run()
    refused = matrixworld_command("diagnose", "alone", code=2).output
    assert "alone: expected a race, got a run in which one team evolved" in words(refused)
    race = start(tiny_race(), "stopped", threads=1, play=StopAt(2))
    with pytest.raises(KeyboardInterrupt):
        race.run()
    refused = matrixworld_command("diagnose", "stopped", code=2).output
    assert "expected a finished run; matrixworld evolve --resume stopped" in words(refused)


def test_damaged_runs_are_named(job, tmp_path):
    copy = tmp_path / "copy"
    copy.mkdir()
    for file in (job / "1").iterdir():
        (copy / file.name).write_bytes(file.read_bytes())
    content = (copy / "payoff.npz").read_bytes()
    (copy / "payoff.npz").write_bytes(content[: len(content) // 2])
    assert "payoff.npz" in matrixworld_command("diagnose", copy, code=1).output
