"""``matrixworld class`` and ``matrixworld class export``."""

import json
from pathlib import Path

import numpy as np
import pytest

from class_submissions import honest_programs, problem_here, write_genomes, write_programs
from command_line import matrixworld_command, run_together
from matrixworld.classroom.submissions import read_genome
from matrixworld.coevolution import open_run

WORLD = ("--rows", 8, "--cols", 8, "--n-pursuers", 2, "--n-evaders", 2, "--no-open")


@pytest.fixture
def directory(tmp_path: Path) -> Path:
    path = tmp_path / "course A"
    path.mkdir()
    write_genomes(path, 3)
    return path


def class_command(directory: Path, *words: object, code: int = 0) -> str:
    # In episodes of a few steps two tournaments may happen to have equal lengths.
    steps = () if "--steps" in words else ("--steps", 40)
    return matrixworld_command("class", directory, *WORLD, *steps, *words, code=code).output


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

    monkeypatch.setattr("matrixworld.cli.classroom.write_page", full)
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
        matrixworld_command("class", "export", race.parent, "--team", team, "-o", target)
        found, population = read_genome(target, target.read_bytes())
        assert found == team
        np.testing.assert_array_equal(population.genomes[0], open_run(race).policy(team).genome)
    fov = ("--fov", population.network.fov)
    assert "genome" in class_command(folder, *fov, "--steps", 5, "--episodes", 2)
