"""The figures of saved runs, and ``matrixworld explore --figures``."""

import re

import numpy as np
import pytest
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.text import Text

from command_line import matrixworld_command
from matrixworld import analysis
from matrixworld.coevolution import TEAMS, compare, evolve, open_groups
from matrixworld.plots import saved
from own_games import pictures, short_race, words
from tiny_race import tiny_race, tiny_single

SCORES = [
    "pursuers against held-out opponents, capture rate",
    "evaders against held-out opponents, escape rate",
]
TOGETHER = ["comparison", "verdicts", "held_out"]


@pytest.fixture(autouse=True)
def elsewhere(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)


@pytest.fixture(scope="module")
def runs(tmp_path_factory):
    """Two seeds of a race, another race, and a team that learns alone."""
    root = tmp_path_factory.mktemp("runs")
    for seed in (5, 6):
        evolve(tiny_race(seed=seed), root / "job" / f"seed-{seed}", threads=1)
    evolve(tiny_race(schedule="hall-of-fame"), root / "hall", threads=1)
    evolve(tiny_single(team="pursuer"), root / "pursuers", threads=1)
    return root


def files_of(root, *places, **chosen):
    groups = open_groups(*(root / place for place in places))
    figures = saved.figures_of([group.inside(root) for group in groups], root, **chosen)
    return [file.relative_to(root).as_posix() for file in figures]


def test_runs_have_their_own_figures_and_seeds_have_them_together(runs):
    of_run = [f"{name}.png" for name in saved.OF_RUN]
    assert files_of(runs, "hall") == [f"hall/{name}" for name in of_run]
    assert files_of(runs, "pursuers", suffix="pdf") == ["pursuers/training.pdf"]
    assert files_of(runs, "job") == [f"{name}.png" for name in TOGETHER]
    seeds = [f"job/seed-{seed}/{name}" for seed in (5, 6) for name in of_run]
    assert files_of(runs, "job", each=True) == [*seeds, *(f"{name}.png" for name in TOGETHER)]
    with pytest.raises(ValueError, match=r"expected one of .* got"):
        files_of(runs, "hall", suffix="bmp")
    both = [f"{place}/{name}" for place in ("hall", "job/seed-5") for name in of_run]
    assert files_of(runs, "hall", "job/seed-5") == [*both, "comparison.png"]


@pytest.fixture(scope="module")
def methods(tmp_path_factory):
    """Three seeds of two methods in one world, and of a third one in another world."""
    root = tmp_path_factory.mktemp("methods")
    other = {"hall": {"schedule": "hall-of-fame"}, "large": {"size": 9}, "special": {}}
    for name, changes in other.items():
        for seed in (1, 2, 3):
            evolve(tiny_race(seed=seed, **changes), root / name / f"seed-{seed}", threads=1)
    return root


def test_differences_of_methods_are_those_of_compare(methods):
    assert "differences.png" in files_of(methods, "hall", "special")
    assert "differences.png" not in files_of(methods, "hall", "special", "large")
    assert "differences.png" not in files_of(methods, "hall")
    groups = [group.inside(methods) for group in open_groups(methods / "hall", methods / "special")]
    figure = saved.figures_of(groups, methods)[methods / "differences.png"]()
    # Two intervals hold together.
    compared = compare(methods / "hall", methods / "special", level=0.975)
    for axes, (team, label) in zip(figure.axes, [*zip(TEAMS, SCORES, strict=True)], strict=True):
        expected = compared.differences[label]
        _, interval, mean = axes.lines[:3]
        np.testing.assert_allclose(interval.get_xdata(), expected.ends)
        assert mean.get_xdata() == [pytest.approx(expected.value)]
        one, other = (group.held_out(team).mean(axis=1) for group in groups)
        np.testing.assert_allclose(axes.collections[0].get_offsets()[:, 0], one - other)
        assert [text.get_text() for text in axes.texts] == ["hall minus special"]


def test_figures_of_a_column_fit_into_it(methods):
    figures = {
        file: draw
        for places in (("hall", "special"), ("hall/seed-1",))
        for file, draw in saved.figures_of(
            [g.inside(methods) for g in open_groups(*(methods / place for place in places))],
            methods,
            column=True,
        ).items()
    }
    assert {file.stem for file in figures} == {*saved.OF_RUN, *saved.OF_GROUPS}
    for file, draw in figures.items():
        figure = draw()
        width, _ = figure.get_size_inches()
        assert width <= 7.0 if file.stem == "comparison" else width == 3.4
        renderer = FigureCanvasAgg(figure).get_renderer()
        figure.draw(renderer)
        drawn = figure.get_tightbbox(renderer)  # in inches
        assert -0.02 <= drawn.x0 <= drawn.x1 <= width + 0.02, file
        assert min(text.get_fontsize() for text in figure.findobj(Text) if text.get_text()) >= 6


def test_titles_name_the_run_its_seed_and_what_was_judged(runs):
    [group] = open_groups(runs / "hall")
    figures = saved.figures_of([group], runs)
    for name in ("training", "payoff", "collisions"):
        figure = figures[runs / "hall" / f"{name}.png"]()
        title = figure.get_suptitle() or figure.axes[0].get_title()
        assert title.replace("\n", " ").startswith("hall (hall-of-fame), seed 5")
        if name == "payoff":
            said = figure.axes[0].texts[0].get_text().replace("\n", " ")
            assert said == analysis.sentence(group.judgement)


def test_figures_of_your_own_game_have_its_words(tmp_path):
    for seed in (0, 1):
        evolve(short_race(words, seed=seed), tmp_path / f"words/seed-{seed}", threads=1)
    evolve(short_race(pictures, schedule="alternating"), tmp_path / "pictures", threads=1)
    seen = []
    for places, each in ((("words",), True), (("pictures", "words/seed-0"), False)):
        figures = saved.figures_of(
            open_groups(*(tmp_path / p for p in places)), tmp_path, each=each
        )
        for file, draw in figures.items():
            texts = [t.get_text() for t in draw().findobj(Text)]
            assert not [t for t in texts if re.search("pursue|evade|captur|escap", t)], file
            assert any("hosts" in t for t in texts) or file.stem == "verdicts"
            seen.append(file.stem)
    assert {*seen} == {*saved.OF_RUN, "verdicts", "comparison"} - {*saved.OF_PURSUIT}


def test_collisions_are_counted_per_1000_steps_of_an_agent(race):
    [group] = open_groups(race)
    payoff, rates = group.runs[0].payoff(), saved.collisions_per_1000(group)
    collisions, steps = (payoff.extras[name] for name in ("collisions", "agent_steps"))
    row = sum(collisions[1, h, 0, 0] for h in range(3))
    assert rates[1, 0, 0] == pytest.approx(1000 * row / steps[1, :, 0].sum())
    column = sum(collisions[g, 2, 1, 1] for g in range(3))
    assert rates[2, 1, 1] == pytest.approx(1000 * column / steps[:, 2, 1].sum())


def test_figures_in_a_format(runs):
    race = runs / "job" / "seed-5"
    told = matrixworld_command("explore", race, "--figures", "--format", "pdf").output
    drawn = race / "collisions.pdf"
    assert f"{drawn}\n" in told
    assert drawn.read_bytes().startswith(b"%PDF-")
