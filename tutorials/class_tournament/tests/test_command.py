"""The command: a tournament, a genome to hand in, and what is refused."""

import json
import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from class_submissions import honest_programs, problem_here, write_genomes, write_programs
from class_tournament.command import main
from command_line import run_command, run_together
from matrixworld.coevolution import open_run
from matrixworld.play import read_genome

WORLD = ("--rows", 8, "--cols", 8, "--n-pursuers", 2, "--n-evaders", 2, "--no-open")


@pytest.fixture(autouse=True)
def elsewhere(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Run commands in a temporary directory."""
    monkeypatch.chdir(tmp_path)


@pytest.fixture
def directory(tmp_path: Path) -> Path:
    path = tmp_path / "course A"
    path.mkdir()
    write_genomes(path, 3)
    return path


def class_command(directory: Path, *words: object, code: int = 0) -> str:
    # In episodes of a few steps two tournaments may happen to have equal lengths.
    steps = () if "--steps" in words else ("--steps", 40)
    return run_command(main, directory, *WORLD, *steps, *words, code=code).output


def test_a_class_of_genomes_and_the_secret_that_repeats_it(directory: Path) -> None:
    told = class_command(directory, "--json", "a.json")
    page = directory.with_name("course A.html")
    assert f"Written: {page}" in told
    assert "mean capture rate against all 4 opponents" in told
    before = page.read_text(encoding="utf-8")
    assert "<title>course A - matrixworld</title>" in before
    values = json.loads(Path("a.json").read_text())
    assert values["names"]["evader"] == ["genome 01", "random", "fleer", "dodger"]
    assert np.shape(values["capture_rates"]) == (5, 4, 10)
    [rank, *_] = [each["rank"] for each in values["standings"]["pursuer"] if each["rank"]]
    assert rank in ("1", "1 to 2")  # 10 episodes may leave the first two apart or not
    # The page is the only record, and not drawn again unasked.
    assert "exists; give --force to replace it" in class_command(directory, code=2)
    assert f"--seed {values['seed']} plays this tournament again." in told
    class_command(directory, "--seed", values["seed"], "--force")
    assert page.read_text(encoding="utf-8") == before
    class_command(directory, "--out", "b.html", "--json", "b.json")
    other = json.loads(Path("b.json").read_text())
    assert other["seed"] != values["seed"]
    assert other["lengths"] != values["lengths"]


def test_results_are_printed_though_the_page_cannot_be_written(
    directory: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def full(path: Path, text: str) -> None:
        raise OSError(28, "No space left on device", str(path))

    monkeypatch.setattr("class_tournament.command.write_page", full)
    told = class_command(directory, "--steps", 5, code=1)
    assert "mean capture rate against all 4 opponents" in told
    assert "no space left on device" in told


def test_programs_play_and_refusals_are_printed(directory: Path) -> None:
    if problem := problem_here():
        pytest.skip(problem)
    write_programs(directory, honest_programs(1) | {"bad": "def evade(view, rng): return 'up'"})
    told = class_command(directory, "--steps", 5, "--threads", 1)
    assert "student 00" in told
    assert "bad.py: evade returned a str, expected an action 0 to 4" in run_together(told)


def test_a_champion_is_exported_and_plays(race: Path, tmp_path: Path) -> None:
    folder = tmp_path / "class"
    folder.mkdir()
    for team in ("pursuer", "evader"):
        target = folder / f"{team}.npz"
        run_command(main, "export", race.parent, "--team", team, "-o", target)
        found, population = read_genome(target)
        assert found == team
        np.testing.assert_array_equal(population.genomes[0], open_run(race).policy(team).genome)
    fov = ("--fov", population.policy.fov)
    assert "genome" in class_command(folder, *fov, "--steps", 5, "--episodes", 2)


REFUSED = [
    (["empty", "--no-open"], 1, "expected a submission that can play, got none"),
    (["empty", "--seconds", 0], 2, "--seconds: expected 1 to 3600, got 0"),
    (["empty", "--wait", "nan"], 2, "--wait: expected a number above 0"),
    (["empty", "--memory", 1], 2, "--memory: expected 16 to 1048576, got 1"),
    (["no"], 2, "Directory 'no' does not exist"),
    (["export", "no", "--team", "evader", "--out", "a.npz"], 2, "no: no such file or directory"),
    (["export", "RUN", "--team", "evader", "--out", "a.txt"], 2, "ends in .npz"),
    (["export", "RUN", "--team", "evader", "--out", "a.npz", "--generation", 99], 2,
     "--generation: expected a generation from 0 to"),
]  # fmt: skip


@pytest.mark.parametrize(("words", "code", "message"), REFUSED)
def test_it_is_refused_in_a_sentence(
    race: Path, words: list[object], code: int, message: str
) -> None:
    Path("empty").mkdir()
    refused = run_command(main, *(race if word == "RUN" else word for word in words), code=code)
    assert message in run_together(refused.stderr)
    assert refused.stdout == ""
    assert os.listdir() == ["empty"]


def test_the_folder_is_the_command(tmp_path: Path) -> None:
    folder = Path(__file__).parents[1]
    words = [sys.executable, str(folder), str(tmp_path), "--no-open"]
    told = subprocess.run(words, capture_output=True, text=True, check=False)
    assert "expected a submission that can play, got none" in told.stderr, told.stderr
