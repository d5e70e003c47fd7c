"""Figures of several runs show the given numbers, at any number of groups and seeds."""

from __future__ import annotations

import io

import numpy as np
import pytest
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Rectangle

from matrixworld import analysis, plots
from matrixworld._util import colors
from matrixworld.analysis import CONDITIONS

RNG = np.random.default_rng(0)
EPISODES = RNG.binomial(1, 0.5, (11, 13, 13, 4)).astype(float)
"""Scores of 11 runs of 13 generations."""
MATRICES = EPISODES.mean(axis=3)


def judged(seeds: int) -> analysis.Judgement:
    return analysis.judge(EPISODES[:seeds], per_episode=True)


def saved(figure: Figure) -> None:
    figure.savefig(io.BytesIO(), format="png")


def thick(axes: Axes) -> list[np.ndarray]:
    """Return the heights of the mean curves: the thick lines."""
    return [
        np.asarray(line.get_ydata())
        for line in axes.lines
        if line.get_linewidth() > 1.0 and len(line.get_xdata()) > 2
    ]


def test_bands_show_means_and_intervals_over_seeds() -> None:
    figure = plots.seed_bands({"one": MATRICES[:4], "two": MATRICES[4:6]}, {"one": judged(4)})
    scores, other, strength, _, lags, _ = figure.axes
    bands = analysis.race_bands(MATRICES[:4])
    for axes, expected in (
        (scores, (bands["pursuer_generalization"], bands["evader_generalization"])),
        (strength, (bands["pursuer_ratings"], bands["evader_ratings"])),
        (lags, (bands["lag_profile"],)),
    ):
        # An empty band may follow, for the legend.
        for drawn, band, filled in zip(thick(axes), expected, axes.collections, strict=False):
            np.testing.assert_allclose(drawn, band.mean)
            heights = filled.get_paths()[0].vertices[:, 1]
            assert heights.min() == pytest.approx(band.low.min())
            assert heights.max() == pytest.approx(band.high.max())
    assert scores.get_title() == f"one\n4 seeds\n{analysis.headline(judged(4))}"
    assert other.get_title() == "two\n2 seeds"
    assert [axes.get_ylabel() for axes in figure.axes[::2]] == [
        "mean score", "Elo rating (points)", "mean capture rate",
    ]  # fmt: skip
    assert scores.get_xlabel() == "generation"
    assert strength.get_ylim() == figure.axes[3].get_ylim()
    saved(figure)


def test_single_seeds_are_thin_lines_if_there_are_few() -> None:
    few = plots.seed_bands({"few": MATRICES[:10]})
    many = plots.seed_bands({"many": MATRICES})
    assert len(few.axes[1].lines) == 2 + 2 * 10
    assert len(many.axes[1].lines) == 2
    texts = [[text.get_text() for text in f.legends[0].get_texts()] for f in (few, many)]
    assert ["single seed" in labels for labels in texts] == [True, False]


def test_a_single_seed_has_no_band_and_runs_may_differ_in_length() -> None:
    groups = {"alone": MATRICES[:1], "mixed": [MATRICES[0], MATRICES[1][:8, :8]]}
    figure = plots.seed_bands(groups)
    alone, mixed = figure.axes[:2]
    assert not alone.collections
    assert alone.get_title() == "alone\n1 seed: no band"
    assert len(thick(mixed)[0]) == 13
    saved(figure)


@pytest.mark.parametrize("groups", [1, 3, 6])
def test_all_groups_are_inside_the_figure(groups: int) -> None:
    names = [f"a schedule with a long name, number {n}" for n in range(groups)]
    figure = plots.seed_bands(dict.fromkeys(names, MATRICES[:2]), title="All of them")
    saved(figure)
    titles = [axes.title for axes in figure.axes if axes.get_title()]
    assert len(titles) == groups
    for box in (title.get_window_extent() for title in titles):
        assert box.x0 >= 0
        assert box.x1 <= figure.bbox.width
        assert box.y1 <= figure.bbox.height
    assert figure.get_suptitle() == "All of them"


def cells(axes: Axes) -> list[Rectangle]:
    return [patch for patch in axes.patches if isinstance(patch, Rectangle)]


def test_the_strip_has_a_cell_for_each_verdict() -> None:
    judgement = judged(3)
    figure = plots.verdict_strip({"a": judgement}, {"a": (2, 5, 9)}, {"a": (7,)})
    (axes,) = figure.axes
    findings = judgement.headline
    looks = {"present": colors.BLUE, "absent": colors.GRID, "cannot tell": colors.PAPER}
    drawn = {(round(c.get_x()), round(c.get_y())): c for c in cells(axes)}
    for column, run in ((0, 0), (1, 1), (3, 2)):
        for row, finding in enumerate(findings.values()):
            patch = drawn[column, row]
            expected = tuple(int(looks[finding.by_run[run]][k : k + 2], 16) for k in (1, 3, 5))
            assert tuple(round(255 * part) for part in patch.get_facecolor()[:3]) == expected
    assert all(drawn[2, row].get_hatch() for row in range(len(findings)))
    labels = [tick.get_text() for tick in axes.get_xticklabels()]
    assert labels == ["2", "5", "7", "9", "all together"]
    words = [text.get_text() for text in axes.texts]
    assert words[-len(findings) :] == [finding.verdict for finding in findings.values()]
    assert axes.get_title(loc="left") == f"a: {analysis.headline(judgement)}"
    legend = [text.get_text() for text in figure.legends[0].get_texts()]
    assert legend == ["present", "absent", "cannot tell", "not finished"]
    saved(figure)


def test_many_seeds_have_cells_without_words() -> None:
    seeds = tuple(range(11))
    figure = plots.verdict_strip({"a": judged(11)}, {"a": seeds}, {"a": tuple(range(11, 40))})
    (axes,) = figure.axes
    assert len(axes.texts) == len(CONDITIONS)
    assert len(cells(axes)) == 41 * len(CONDITIONS)
    assert figure.get_figwidth() <= 16


def test_scores_show_profiles_and_interquartile_means() -> None:
    scores = {"a": {"pursuer": RNG.random((7, 5)), "evader": RNG.random((7, 5))},
              "b": {"pursuer": RNG.random((3, 5)), "evader": RNG.random((3, 5))}}  # fmt: skip
    figure = plots.seed_scores(scores)
    profiles, middles, _, evaders = figure.axes
    for line, of_group in zip(profiles.lines, scores.values(), strict=True):
        expected = analysis.performance_profile(of_group["pursuer"]).mean
        np.testing.assert_allclose(line.get_ydata(), expected)
    # Seven seeds have a band and an interval, three have neither.
    assert len(profiles.collections) == 1
    a = analysis.interquartile_mean(scores["a"]["pursuer"])
    bar, diamond, other = middles.lines
    np.testing.assert_allclose(bar.get_xdata(), [a.low, a.high])
    np.testing.assert_allclose(diamond.get_xdata(), a.value)
    b = analysis.interquartile_mean(scores["b"]["pursuer"])
    np.testing.assert_allclose(other.get_xdata(), b.value)
    dots = np.asarray(middles.collections[0].get_offsets())[:, 0]
    np.testing.assert_allclose(dots, scores["a"]["pursuer"].mean(axis=1))
    labels = [tick.get_text() for tick in middles.get_yticklabels()]
    assert labels == ["a (7 seeds)", "b (3 seeds)"]
    assert profiles.get_xlabel() == "threshold of the capture rate"
    assert evaders.get_xlabel() == "escape rate"
    saved(figure)


# ---- Dots, curves and CIAO plots -----------------------------------------------------------------


def test_dots_are_the_runs_and_the_diamond_is_their_mean() -> None:
    groups = {"one": RNG.random(7), "two": RNG.random(4)}
    figure = plots.run_dots(groups, label="score", levels={"untrained": 0.3}, title="a title")
    (axes,) = figure.axes
    for values, dots in zip(groups.values(), axes.collections, strict=False):
        np.testing.assert_allclose(np.asarray(dots.get_offsets())[:, 0], values)
    lines = [line for line in axes.lines if len(line.get_xdata()) and line.get_label()[0] == "_"]
    for values, (ends, mean) in zip(
        groups.values(), zip(lines[::2], lines[1::2], strict=True), strict=True
    ):
        found = analysis.interval_over_runs(values)
        np.testing.assert_allclose(ends.get_xdata(), [found.low, found.high])
        np.testing.assert_allclose(mean.get_xdata(), [found.value])
    assert [text.get_text() for text in axes.get_yticklabels()] == ["one", "two"]
    assert axes.get_xlabel() == "score"
    saved(figure)


def test_a_single_run_has_no_interval() -> None:
    (axes,) = plots.run_dots({"alone": [0.4]}, label="score", each="one match").axes
    assert all(len(line.get_xdata()) < 2 for line in axes.lines)
    assert "one match" in axes.get_legend_handles_labels()[1]


def test_curves_have_means_and_bands() -> None:
    groups = {"one": RNG.random((5, 9)), "two": RNG.random((3, 9))}
    places = np.arange(0, 90, 10)
    figure = plots.run_curves(groups, label="score", places=places, along="epoch")
    (axes,) = figure.axes
    for (name, curves), filled in zip(groups.items(), axes.collections, strict=False):
        band = analysis.band_over_runs(curves)
        (mean,) = [line for line in axes.lines if line.get_label() == name]
        np.testing.assert_allclose(mean.get_ydata(), band.mean)
        np.testing.assert_allclose(mean.get_xdata(), places)
        assert filled.get_paths()[0].vertices[:, 1].max() == pytest.approx(band.high.max())
    assert axes.get_xlabel() == "epoch"
    saved(figure)


def test_triangles_are_those_of_ciao() -> None:
    payoff = RNG.random((6, 6))
    figure = plots.ciao_triangles(payoff, names=("hunters", "prey"))
    found = analysis.ciao(payoff)
    for axes, triangle, name in zip(figure.axes[:2], found, ("hunters", "prey"), strict=True):
        drawn = np.ma.filled(axes.images[0].get_array(), np.nan)
        np.testing.assert_allclose(drawn, triangle.payoff.T)
        assert axes.get_xlabel() == f"generation of {name}"
    saved(figure)
