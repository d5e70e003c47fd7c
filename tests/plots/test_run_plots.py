"""Figures of several runs and CIAO plots show the given numbers."""

from __future__ import annotations

import io

import numpy as np
import pytest
from matplotlib.figure import Figure

from matrixworld import analysis, plots

RNG = np.random.default_rng(3)


def saved(figure: Figure) -> None:
    figure.savefig(io.BytesIO(), format="png")


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
    figure = plots.run_dots({"alone": [0.4]}, label="score", each="one match")
    (axes,) = figure.axes
    assert all(len(line.get_xdata()) < 2 for line in axes.lines)
    assert "one match" in axes.get_legend_handles_labels()[1]
    saved(figure)


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


@pytest.mark.parametrize("draw", [plots.run_dots, plots.run_curves])
def test_no_groups_are_refused(draw) -> None:
    with pytest.raises(ValueError, match="expected at least one group of runs to draw, got none"):
        draw({}, label="score")
