"""Every figure can be saved without a display, shows the given numbers, or is refused."""

import re
from pathlib import Path

import numpy as np
import pytest
from matplotlib.colors import to_hex

from matrices import circular, logistic
from matrixworld import analysis, plots
from matrixworld._util import colors
from matrixworld.analysis.intervals import UNIT, generalization_over_episodes
from matrixworld.plots.race import collision_rates, training_curve
from matrixworld.plots.runs import LOOKS
from matrixworld.plots.style import FORMATS

RACE, CYCLE = logistic(31), circular(31)  # 30 generations and the untrained one, as in races
RNG = np.random.default_rng(0)
SINGLE = np.random.default_rng(1).binomial(1, CYCLE[..., None], (31, 31, 6)).astype(float)


def check_band(drawn, band):
    heights = drawn.get_paths()[0].vertices[:, 1]
    ends = np.nanmin(band.low), np.nanmax(band.high)
    assert (heights.min(), heights.max()) == pytest.approx(ends)


def legend_texts(figure):
    return [text.get_text() for legend in figure.legends for text in legend.get_texts()]


def test_heatmap_shows_the_matrix_with_pursuers_upwards():
    axes, _ = plots.payoff_heatmap(RACE).axes
    (image,) = axes.images
    np.testing.assert_array_equal(image.get_array(), RACE)
    assert (image.origin, image.get_clim()) == ("lower", (0.0, 1.0))
    assert (axes.get_xlabel(), axes.get_ylabel()) == ("evader generation", "pursuer generation")
    above, below = (line.get_xydata() for line in axes.lines)
    np.testing.assert_array_equal(above, below[:, ::-1])
    # Corners of cells only: no line crosses a cell of equal generations.
    assert set(above[:, 1] - above[:, 0]) == {0.0, 1.0}
    np.testing.assert_array_equal(above % 1, 0.5)


def test_generalization_has_intervals_over_episodes():
    axes = plots.comparison({"race": analysis.read_payoffs(SINGLE, per_episode=True)}).axes[2]
    expected = generalization_over_episodes(SINGLE)
    for line, drawn, band in zip(axes.lines, axes.collections, expected, strict=False):
        np.testing.assert_allclose(line.get_ydata(), band.mean)
        check_band(drawn, band)


def test_lag_profile_is_solid_where_it_rests_on_enough_cells():
    axes = plots.comparison({"race": RACE}).axes[1]
    faint, solid, _ = axes.lines
    profile = analysis.lag_profile(RACE)
    np.testing.assert_array_equal(faint.get_xydata(), np.transpose([profile.lags, profile.means]))
    np.testing.assert_array_equal(solid.get_xdata(), np.arange(-26, 27))  # at least 5 cells each


def test_training_curve_is_shaded_by_the_team_that_learns():
    rates, learners = np.array([0.5, 0.9, 0.2, 0.8]), np.array([0, 0, 1, 0])
    figure = training_curve(rates, learners, generations=[1, 1, 1, 2])
    (axes,) = figure.axes
    (curve,) = axes.lines
    np.testing.assert_array_equal(curve.get_xydata(), [[1, 0.5], [2, 0.9], [3, 0.2], [4, 0.8]])
    # From half an epoch before the evaders' one to half an epoch after it.
    _, evaders = axes.collections
    assert {*evaders.get_paths()[0].vertices[:, 0]} <= {2.5, 3.0, 3.5}
    assert legend_texts(figure) == ["pursuers learn", "evaders learn"]
    (top,) = axes.child_axes
    assert list(top.get_xticks()) == [1, 4]
    assert [tick.get_text() for tick in top.get_xticklabels()] == ["1", "2"]


def test_differences_have_a_line_at_0_and_an_interval_each():
    found = {"a minus b": analysis.Estimate(0.1, -0.02, 0.2), "a minus c": analysis.Estimate(0.3)}
    figure = plots.differences({"gain": found}, label="difference of gains")
    (axes,) = figure.axes
    zero, interval, mean, alone, _ = axes.lines
    assert set(zero.get_xdata()) == {0.0}
    assert list(interval.get_xdata()) == [-0.02, 0.2]
    assert (mean.get_xdata(), alone.get_xdata()) == ([0.1], [0.3])
    assert axes.get_xlabel() == "difference of gains"
    with pytest.raises(ValueError, match="at least one difference to draw, got none"):
        plots.differences({"gain": {}}, label="difference")


def test_collisions_have_a_panel_a_team_and_a_line_a_kind():
    rates = np.arange(4 * 2 * 3, dtype=float).reshape(4, 2, 3)
    figure = collision_rates(rates, title="collisions")
    for team, axes in enumerate(figure.axes):
        for kind, (line, color) in enumerate(zip(axes.lines, colors.CONFLICTS, strict=True)):
            assert to_hex(line.get_color()) == color.lower()
            np.testing.assert_array_equal(line.get_ydata(), rates[:, team, kind])
    assert legend_texts(figure) == ["with obstacle", "with teammate", "with adversary"]


def test_comparison_puts_races_and_what_was_judged_side_by_side():
    races = {"specialists": CYCLE, "generalists": RACE}
    figure = plots.comparison(races, {"generalists": analysis.judge(RACE, episodes=100)})
    maps, lags, scores = np.array(figure.axes[:6]).reshape(3, 2)
    for column, (name, matrix) in enumerate(races.items()):
        np.testing.assert_array_equal(maps[column].images[0].get_array(), matrix)
        assert maps[column].get_title() == name
        profile = analysis.lag_profile(matrix)
        np.testing.assert_array_equal(lags[column].lines[0].get_ydata(), profile.means)
        for line, curve in zip(scores[column].lines, analysis.generalization(matrix), strict=True):
            np.testing.assert_allclose(line.get_ydata(), curve, rtol=1e-12)
        assert not scores[column].collections  # means alone have no interval
    assert [axes.texts[0].get_text() for axes in maps] == ["", "Both teams improved."]


def test_plots_need_neither_pyplot_nor_a_display():
    for file in Path(plots.__file__).parent.glob("*.py"):
        assert not re.search("import.*pyplot", file.read_text(encoding="utf-8")), file


EPISODES = RNG.binomial(1, 0.5, (4, 9, 9, 4)).astype(float)
"""Scores of 4 runs of 9 generations."""
MATRICES = EPISODES.mean(axis=3)


def judged_seeds(seeds):
    return analysis.judge(EPISODES[:seeds], per_episode=True)


def thick(axes):
    """Return the heights of the mean curves: the thick lines."""
    lines = [line for line in axes.lines if line.get_linewidth() > 1.0]
    return [np.asarray(line.get_ydata()) for line in lines if len(line.get_xdata()) > 2]


def test_bands_show_means_and_intervals_over_seeds():
    groups = {"one": analysis.read_payoffs(MATRICES), "two": analysis.read_payoffs(MATRICES[:1])}
    figure = plots.comparison(groups, {"one": judged_seeds(4), "two": judged_seeds(1)})
    (maps, _), (lags, _), (scores, single) = np.reshape(figure.axes[:6], (3, 2))
    np.testing.assert_array_equal(maps.images[0].get_array(), MATRICES.mean(axis=0))
    profiles = [analysis.lag_profile(matrix) for matrix in MATRICES]
    means = analysis.band_over_runs([each.means for each in profiles], bounds=UNIT)
    teams = zip(*map(analysis.generalization, MATRICES), strict=True)
    bands = [analysis.band_over_runs(curves, bounds=UNIT) for curves in teams]
    check_band(lags.collections[0], means)
    # An empty band may follow, for the legend.
    for drawn, band, filled in zip(thick(scores), bands, scores.collections, strict=False):
        np.testing.assert_allclose(drawn, band.mean)
        check_band(filled, band)
    assert len(scores.lines) == 2 * (1 + 4) + 1  # and for the legend
    assert not single.collections


def test_the_strip_has_a_cell_for_each_verdict():
    judgement = judged_seeds(3)
    figure = plots.verdict_strip({"a": judgement}, {"a": (2, 5, 9)}, {"a": (7,)})
    (axes,) = figure.axes
    findings = judgement.findings
    (mesh,) = axes.collections
    kinds, cells = [*LOOKS], np.array(mesh.get_array()).reshape(len(findings), 4)
    for row, finding in enumerate(findings.values()):
        drawn = [kinds[int(cell)] for cell in cells[row]]
        assert drawn == [*finding.by_run[:2], "not finished", finding.by_run[2]]
    names = [tick.get_text() for tick in axes.get_xticklabels()]
    assert names == ["2", "5", "7", "9"]
    rows = [tick.get_text() for tick in axes.get_yticklabels()]
    assert rows == [f"{name}: {finding.verdict}" for name, finding in findings.items()]


def test_dots_are_the_runs_and_the_diamond_is_their_mean():
    groups = {"one": RNG.random(7), "two": RNG.random(4)}
    figure = plots.run_dots(groups, label="score", levels={"untrained": 0.3}, title="a title")
    (axes,) = figure.axes
    for values, dots in zip(groups.values(), axes.collections, strict=False):
        np.testing.assert_allclose(np.asarray(dots.get_offsets())[:, 0], values)
    lines = [line for line in axes.lines if len(line.get_xdata()) and line.get_label()[0] == "_"]
    for values, ends, mean in zip(groups.values(), lines[::2], lines[1::2], strict=True):
        found = analysis.interval_over_runs(values)
        np.testing.assert_allclose(ends.get_xdata(), [found.low, found.high])
        np.testing.assert_allclose(mean.get_xdata(), [found.value])


def test_curves_have_means_and_bands():
    groups = {"one": RNG.random((5, 9)), "two": RNG.random((3, 9))}
    places, bounds = np.arange(0, 90, 10), (0.0, 0.9)
    figure = plots.run_curves(groups, label="score", places=places, along="epoch", bounds=bounds)
    (axes,) = figure.axes
    assert analysis.band_over_runs(groups["two"]).high.max() > 0.9  # of 3 runs, so it is cut
    for (name, curves), filled in zip(groups.items(), axes.collections, strict=False):
        band = analysis.band_over_runs(curves, bounds=bounds)
        (mean,) = [line for line in axes.lines if line.get_label() == name]
        np.testing.assert_allclose(mean.get_ydata(), band.mean)
        np.testing.assert_allclose(mean.get_xdata(), places)
        check_band(filled, band)


@pytest.mark.parametrize("suffix", FORMATS)
def test_figures_are_files_of_their_suffix(suffix, tmp_path):
    begins = {"png": b"\x89PNG\r\n\x1a\n", "pdf": b"%PDF-", "svg": b"<?xml"}
    figure = plots.run_curves({"race": RACE}, label="score")
    content = plots.save_figure(figure, tmp_path / f"figure.{suffix}").read_bytes()
    assert content.startswith(begins[suffix])
    assert b"<image" not in content  # vectors only
    assert b"Date" not in content


SQUARE = np.full((7, 7), 0.5)
HIDDEN = np.ma.array(np.full((2, 2, 3), 0.5), mask=np.ones((2, 2, 3)))
scores = analysis.judge([SQUARE] * 3)


@pytest.mark.parametrize(
    ("draw", "message"),
    [
        (lambda: plots.verdict_strip({"a": scores}, {"a": (0, 1)}), "seeds: expected 3 of a"),
        (lambda: plots.save_figure(plots.payoff_heatmap(RACE), "x.bmp"), r"ends in \.png"),
        (lambda: plots.comparison({}), "expected at least one race to draw, got none"),
        (lambda: plots.run_dots({"a": HIDDEN[0, 0]}, label="score"), "masked cell"),
        (lambda: plots.run_curves({"a": HIDDEN[0]}, label="score"), "masked cell"),
    ],
)
def test_what_cannot_be_drawn_is_refused(draw, message):
    with pytest.raises(ValueError, match=message):
        draw()


def test_no_group_and_no_level_is_left_out():
    """More than there are looks: they come again."""
    levels = {f"level {n}": n / 10 for n in range(7)}
    (axes,) = plots.run_dots({"a": [0.1, 0.2, 0.4]}, label="score", levels=levels).axes
    assert {*levels} <= {line.get_label() for line in axes.lines}
    groups = {f"group {n}": RNG.random((2, 3)) for n in range(23)}
    figure = plots.run_curves(groups, label="score")
    assert {*groups} <= {*legend_texts(figure)}
