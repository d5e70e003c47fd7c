"""The strongest checkerboards of a matrix."""

from __future__ import annotations

import itertools

import numpy as np
import pytest

from matrices import additive, circular, staircase
from matrixworld.analysis import checkerboards
from matrixworld.analysis.cycles import strongest_checkerboards


def margin_of(matrix: np.ndarray, p: int, q: int, a: int, b: int) -> float:
    better, worse = (matrix[p, a], matrix[q, b]), (matrix[p, b], matrix[q, a])
    return float(min(better) - max(worse))


def all_margins(matrix: np.ndarray) -> list[float]:
    rows, columns = matrix.shape
    pairs = itertools.combinations(range(rows), 2)
    orders = itertools.permutations(range(columns), 2)
    return [margin_of(matrix, p, q, a, b) for (p, q), (a, b) in itertools.product(pairs, orders)]


@pytest.mark.parametrize("seed", range(5))
def test_the_first_one_is_the_strongest_of_all(seed: int) -> None:
    matrix = np.random.default_rng(seed).random((5, 6))
    first = strongest_checkerboards(matrix)[0]
    assert first.margin == pytest.approx(max(all_margins(matrix)))
    assert first.margin == pytest.approx(margin_of(matrix, *first.pursuers, *first.evaders))


def test_margins_descend_and_boards_differ() -> None:
    boards = strongest_checkerboards(circular(12), count=8)
    margins = [board.margin for board in boards]
    assert len(boards) == 8
    assert margins == sorted(margins, reverse=True)
    for one, other in itertools.combinations(boards, 2):
        common = len(set(one.pursuers) & set(other.pursuers))
        assert common + len(set(one.evaders) & set(other.evaders)) <= 2


@pytest.mark.parametrize("matrix", [staircase(8), additive(6, 7)])
def test_an_order_of_strength_has_none(matrix: np.ndarray) -> None:
    assert strongest_checkerboards(matrix) == ()


@pytest.mark.parametrize("margin", [0.0, 0.3, 0.6])
def test_there_is_one_if_and_only_if_they_are_counted(margin: float) -> None:
    for seed in range(20):
        matrix = np.random.default_rng(seed).random((3, 3))
        counted = checkerboards(matrix, margin=margin, level=None).count > 0
        assert bool(strongest_checkerboards(matrix, margin=margin)) == counted


@pytest.mark.parametrize(("name", "value"), [("count", -1), ("margin", 1.0), ("margin", -0.1)])
def test_numbers_out_of_range_are_refused(name: str, value: float) -> None:
    with pytest.raises(ValueError, match=f"expected a {name}"):
        strongest_checkerboards(staircase(3), **{name: value})  # type: ignore[arg-type]
