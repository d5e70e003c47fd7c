"""``matrixworld explore --figures``: one figure or all, formats, figures of the game, baselines."""

from pathlib import Path

import numpy as np
import pytest

from command_line import matrixworld_command
from matrixworld import coevolution
from matrixworld.cli.figures import FORMATS, OF_GAME
from matrixworld.coevolution import open_run
from matrixworld.coevolution.evaluation.scores import scores_in_race, trained_team
from tiny_race import tiny_race, tiny_single

BEGINS = {"png": b"\x89PNG", "pdf": b"%PDF-", "svg": b"<?xml"}


def figures_command(*words, code=0):
    return matrixworld_command("explore", "--figures", *words, code=code)


@pytest.fixture(scope="module")
def runs(tmp_path_factory):
    """Two seeds of a race, and a baseline of each team: one for both seeds, one for each."""
    root = tmp_path_factory.mktemp("runs")
    for seed in (5, 6):
        coevolution.finish(tiny_race(seed=seed), root / "job" / f"seed-{seed}", threads=1)
        evaders = tiny_single(team="evader", seed=seed)
        coevolution.finish(evaders, root / "evaders" / f"seed-{seed}", threads=1)
    coevolution.finish(tiny_single(team="pursuer"), root / "pursuers", threads=1)
    return root


@pytest.fixture
def drawn(monkeypatch):
    """Figures that commands have drawn, by the names of the files; nothing is written."""
    found = {}

    def keep(figure, path):
        found[path.name] = figure

    monkeypatch.setattr("matrixworld.plots.save_figure", keep)
    return found


@pytest.mark.parametrize("name", OF_GAME)
def test_a_figure_of_the_game_needs_no_run(name):
    assert figures_command("--figure", name, "--format", "svg").output == f"{name}.svg\n"
    assert Path(f"{name}.svg").read_bytes().startswith(BEGINS["svg"])
    same = ["explore", "--figures", "--figure", name, "-o", f"{name}.svg"]
    # What the command has drawn is drawn again; a file of the user's is kept.
    assert matrixworld_command(*same).output == f"{name}.svg\n"
    Path(f"{name}.svg").write_text("mine")
    again = matrixworld_command(*same, code=2).stderr
    assert f"{name}.svg: exists; give --force to replace it" in again


@pytest.mark.parametrize("suffix", FORMATS)
def test_one_figure_of_a_run(runs, tmp_path, suffix):
    file = tmp_path / f"here.{suffix}"
    race = runs / "job" / "seed-5"
    said = matrixworld_command(
        "explore", "--figures", race, "--figure", "collisions", "--out", file
    )
    assert said.output == f"{file}\n"
    assert file.read_bytes().startswith(BEGINS[suffix])
    assert not list(race.glob(f"collisions.{suffix}"))


def test_all_figures_of_a_run_in_a_format(runs, drawn):
    figures_command(runs / "job" / "seed-5", "--format", "pdf")
    assert list(drawn) == [
        "training.pdf", "payoff.pdf", "generalization.pdf", "lag_profile.pdf", "collisions.pdf",
        "dynamics.pdf", "spinning_top.pdf",
    ]  # fmt: skip
    figures_command(runs / "pursuers", "--figure", "training")
    assert list(drawn)[-1] == "training.png"
    figures_command(runs / "pursuers", "--width", "3.35")
    assert drawn["training.png"].get_figwidth() == pytest.approx(3.35)


def mean_score(race, baseline):
    """Return the score of a baseline by the payoff matrix of the tournament."""
    team, champion = trained_team(open_run(baseline))
    scores = scores_in_race(open_run(race), team, champion)
    assert scores.shape == (3,)
    return float(np.mean(scores))


def test_baselines_are_drawn_in_the_generalization_of_a_race(runs, drawn):
    race = runs / "job" / "seed-6"
    matrixworld_command(
        "explore", race, "--figure", "generalization",
        "--baseline", f"alone={runs / 'pursuers'}", "--baseline", f"others={runs / 'evaders'}",
    )  # fmt: skip
    (axes,) = drawn["generalization.png"].axes
    lines = {line.get_label(): line.get_ydata()[0] for line in axes.lines[2:]}
    assert lines == {
        "alone": pytest.approx(mean_score(race, runs / "pursuers")),
        # The baseline with the seed of the race.
        "others": pytest.approx(mean_score(race, runs / "evaders" / "seed-6")),
    }


def test_baselines_have_intervals_over_seeds(runs, drawn):
    matrixworld_command(
        "explore", runs / "job", "--figure", "generalization",
        "--baseline", f"alone={runs / 'pursuers'}", "--baseline", f"others={runs / 'evaders'}",
    )  # fmt: skip
    assert list(drawn) == ["generalization.png"]
    (axes,) = drawn["generalization.png"].axes
    lines = {line.get_label(): line.get_ydata()[0] for line in axes.lines[2:]}
    expected = {
        name: np.mean(
            [mean_score(runs / "job" / f"seed-{s}", runs / path.format(s)) for s in (5, 6)]
        )
        for name, path in {"alone": "pursuers", "others": "evaders/seed-{}"}.items()
    }
    assert lines == {name: pytest.approx(value) for name, value in expected.items()}
    # One run for both seeds has no interval.
    assert len(axes.patches) == 1


def test_a_seed_without_its_baseline_is_named(runs, drawn, tmp_path):
    other = tmp_path / "evaders"
    for seed in (5, 7):
        coevolution.finish(tiny_single(team="evader", seed=seed), other / f"seed-{seed}", threads=1)
    said = matrixworld_command(
        "explore", "--figures", runs / "job", "--baseline", f"x={other}", code=2
    ).stderr
    assert "--baseline x: expected one run of seed 6, or one in all, got 0" in " ".join(
        said.split()
    )
