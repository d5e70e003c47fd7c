"""Disengagement over generations, and within one."""

from __future__ import annotations

import numpy as np
import pytest

from matrixworld import analysis
from matrixworld.analysis.engagement import Disengagement

# Rates in sixteenths: their complements are exact.

WON, LOST, OPEN, HALF_WON = (0.98, 0.99), (0.02, 0.0), (0.7, 0.3), (0.99, 0.5)


@pytest.mark.parametrize(
    ("rates", "expected"),
    [
        (np.empty((0, 2)), ()),
        ([OPEN] * 5, ()),
        ([WON] * 2, ()),
        ([WON] * 3, (Disengagement("pursuers", 1, 3),)),
        ([LOST] * 3 + [OPEN], (Disengagement("evaders", 1, 3),)),
        ([OPEN, *[LOST] * 4], (Disengagement("evaders", 2, 5),)),
        ([WON, WON, OPEN, WON, WON], ()),
        ([HALF_WON] * 9, ()),
        ([WON, WON, LOST, LOST], ()),
        ([(0.99, 0.01)] * 6, ()),
        ([(0.97, 0.97)] * 6, ()),
        ([(0.03, 0.03)] * 6, ()),
        ([WON] * 3 + [LOST] * 4, (Disengagement("pursuers", 1, 3), Disengagement("evaders", 4, 7))),
    ],
)
def test_disengagement_takes_both_team_phases_three_generations_in_a_row(
    rates: list[tuple[float, float]], expected: tuple[Disengagement, ...]
) -> None:
    assert analysis.disengagements(rates) == expected


def test_a_disengagement_names_the_team_that_needs_more_epochs() -> None:
    stretch = Disengagement("pursuers", 4, 9)
    assert str(stretch).startswith("generations 4 to 9: the pursuers win nearly all matches")
    assert str(stretch).endswith("give the evaders more epochs")
    assert str(Disengagement("evaders", 1, 3)).endswith("give the pursuers more epochs")


# ---- within a generation ------------------------------------------------------------------------


def test_variance_of_fitness_within_each_generation() -> None:
    np.testing.assert_allclose(
        analysis.fitness_variance([[0.0, 1.0], [3.0, 3.0], [-1.0, 5.0]]), [0.25, 0.0, 9.0]
    )


def test_opponents_beaten_by_all_or_by_none_are_undecided() -> None:
    # Opponent 0 is beaten by both, 1 and 4 by none (a draw is not a win), 2 and 3 by one.
    outcomes = [[0.9, 0.1, 0.8, 0.2, 0.5], [0.7, 0.0, 0.3, 1.0, 0.5]]
    found = analysis.undecided_opponents(outcomes)
    assert found.beaten_by_all.tolist() == [0.2]
    assert found.beaten_by_none.tolist() == [0.4]
    np.testing.assert_allclose(found.share, [0.6])
    both = analysis.undecided_opponents([outcomes, np.ones((2, 5))])
    np.testing.assert_allclose(both.share, [0.6, 1.0])
    assert analysis.undecided_opponents(outcomes, level=0.4).beaten_by_all.tolist() == [0.4]
