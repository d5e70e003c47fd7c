"""``matrixworld class`` and ``matrixworld class export``."""

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from class_submissions import honest_programs, problem_here, write_genomes, write_programs
from command_line import RACE, matrixworld_command, run_together, words
from matrixworld.classroom.submissions import read_genome
from matrixworld.coevolution import open_run
from matrixworld.coevolution.storage import run_directories

WORLD = ("--rows", 8, "--cols", 8, "--n-pursuers", 2, "--n-evaders", 2, "--steps", 5, "--no-open")


@pytest.fixture
def directory(tmp_path: Path) -> Path:
    path = tmp_path / "course A"
    path.mkdir()
    write_genomes(path, 3)
    return path


def test_a_class_of_genomes(directory: Path, tmp_path: Path) -> None:
    result = matrixworld_command("class", directory, *WORLD, "--json", tmp_path / "a.json")
    assert f"Written: {tmp_path / 'course A.html'}" in result.output
    assert "mean capture rate against all 4 opponents" in result.output
    page = (tmp_path / "course A.html").read_text(encoding="utf-8")
    assert "<title>course A - matrixworld</title>" in page
    values = json.loads((tmp_path / "a.json").read_text())
    assert values["names"]["evader"] == ["genome 01", "random", "fleer", "dodger"]
    assert np.shape(values["capture_rates"]) == (5, 4, 10)
    [rank, *_] = [each["rank"] for each in values["standings"]["pursuer"] if each["rank"]]
    assert rank in ("1", "1 to 2")  # 10 episodes may leave the first two apart or not


def test_the_page_is_the_same_each_time_and_not_replaced_unasked(
    directory: Path, tmp_path: Path
) -> None:
    page = tmp_path / "page.html"
    matrixworld_command("class", directory, *WORLD, "-o", page, "--seed", 2)
    before = page.read_bytes()
    result = matrixworld_command("class", directory, *WORLD, "-o", page, code=2)
    assert "exists; give --force to replace it" in result.output
    assert page.read_bytes() == before
    matrixworld_command("class", directory, *WORLD, "-o", page, "--seed", 2, "--force")
    assert page.read_bytes() == before


def test_each_tournament_has_a_secret_that_repeats_it(directory: Path, tmp_path: Path) -> None:
    def play(name: str, *options: object) -> dict[str, Any]:
        file = tmp_path / f"{name}.json"
        # In episodes of a few steps two tournaments may happen to have equal lengths.
        words = (*WORLD, "--steps", 40, "--json", file, "-o", tmp_path / f"{name}.html", *options)
        result = matrixworld_command("class", directory, *words)
        values: dict[str, Any] = json.loads(file.read_text())
        assert f"--seed {values['seed']} plays this tournament again." in result.output
        return values

    one, other = play("a"), play("b")
    again = play("c", "--seed", one["seed"])
    assert len({one["seed"], other["seed"], one["match_seed"], other["match_seed"]}) == 4
    assert again["lengths"] == one["lengths"] != other["lengths"]


def test_a_directory_of_any_name_is_played(directory: Path, tmp_path: Path) -> None:
    """One that is no UTF-8, and would give the terminal orders."""
    odd = directory.rename(tmp_path / "a\x1b]0;b\x07\udcff")
    result = matrixworld_command("class", odd, *WORLD)
    assert r"a\x1b]0;b\x07\udcff.html" in run_together(result.output)
    assert "\x1b" not in result.output
    page = odd.with_name(f"{odd.name}.html").read_text(encoding="utf-8")
    assert r"<title>a\x1b]0;b\x07\udcff - matrixworld</title>" in page


def test_results_are_printed_though_the_page_cannot_be_written(
    directory: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def full(path: Path, text: str) -> None:
        raise OSError(28, "No space left on device", str(path))

    monkeypatch.setattr("matrixworld.cli.classroom.write_page", full)
    result = matrixworld_command("class", directory, *WORLD, code=1)
    assert "mean capture rate against all 4 opponents" in result.output
    assert "No space left on device" in result.output


@pytest.mark.parametrize(
    ("options", "message"),
    [
        (("--variant", "X"), "--variant: expected one of"),
        (("--fov", 4), "--fov"),
        (("--n-pursuers", 0), "--n-pursuers"),
        (("--seconds", 0), "--seconds: expected 1 to 3600, got 0"),
        (("--wait", "nan"), "--wait: expected a number above 0"),
        (("--clock", -1), "--clock: expected a number above 0"),
        (("--clock-in-all", "inf"), "--clock-in-all: expected a number above 0"),
        (("--memory", 1), "--memory: expected 16 to 1048576, got 1"),
        (("--episodes", 1), "--episodes"),
    ],
)
def test_wrong_options_are_refused_before_anything_is_played(
    directory: Path, tmp_path: Path, options: tuple[object, ...], message: str
) -> None:
    result = matrixworld_command("class", directory, *WORLD, *options, code=2)
    assert message in run_together(result.output)
    assert sorted(path.name for path in tmp_path.iterdir()) == ["course A"]


def test_a_directory_without_submissions(tmp_path: Path) -> None:
    (tmp_path / "empty").mkdir()
    result = matrixworld_command("class", tmp_path / "empty", *WORLD, code=1)
    assert "expected a submission that can play, got none" in result.output
    assert sorted(path.name for path in tmp_path.iterdir()) == ["empty"]


def test_programs_play_and_refusals_are_printed(directory: Path, tmp_path: Path) -> None:
    if problem := problem_here():
        pytest.skip(problem)
    write_programs(directory, honest_programs(1) | {"bad": "def evade(view, rng): return 'up'"})
    result = matrixworld_command("class", directory, *WORLD, "--threads", 1)
    assert "student 00" in result.output
    assert "bad.py: evade returned a str, expected an action 0 to 4" in run_together(result.output)


def test_a_champion_is_exported_and_plays(tmp_path: Path, undrawn: None) -> None:
    run = tmp_path / "run"
    schedule = "generalist-generalist"
    matrixworld_command(
        "evolve", "--out", run, "--schedule", schedule, *words(RACE), "--threads", 1
    )
    folder = tmp_path / "class"
    folder.mkdir()
    for team in ("pursuer", "evader"):
        target = folder / f"{team}.npz"
        matrixworld_command("class", "export", run, "--team", team, "-o", target)
        found, population = read_genome(target, target.read_bytes())
        policy = open_run(run_directories(run)[0]).policy(team)
        assert found == team
        np.testing.assert_array_equal(population.genomes[0], policy.genome)
    result = matrixworld_command(
        "class", folder, *WORLD, "--fov", population.network.fov, "--episodes", 2
    )
    assert "genome" in result.output
    again = ["class", "export", run, "--team", "evader"]
    refused = matrixworld_command(*again, "-o", target, code=2)
    assert "give --force" in refused.output
    wrong = matrixworld_command(*again, "--generation", 99, "-o", tmp_path / "a.npz", code=2)
    assert "--generation: expected a generation from 0 to" in wrong.output
    other = matrixworld_command(*again, "-o", tmp_path / "a.txt", code=2)
    assert "expected a name that ends in .npz" in other.output
