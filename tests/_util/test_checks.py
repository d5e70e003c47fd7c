"""Checks of arguments: numbers, order, types. tests/analysis tries what is no number."""

import numpy as np
import pytest

from matrixworld._util.checks import check_floats, check_instance, check_sequence, shown


@pytest.mark.parametrize(
    "given", [[1, 2.5], np.float32([1, 2.5]), (1, np.float64(2.5)), np.ma.array([0.2, 0.3])]
)
def test_numbers_are_copied(given):
    found = check_floats("x", given)
    assert found.dtype == np.float64
    assert found.tolist() == [*map(float, given)]
    assert found is not given


def test_a_sequence_has_an_order():
    assert check_sequence("x", (n for n in [2, 1]), "ints") == (2, 1)
    for bad in ({1, 2}, {1: 2}, "12", 1):
        with pytest.raises(TypeError, match="^x: expected a sequence of ints, got "):
            check_sequence("x", bad, "ints")


def test_a_type_is_named_by_its_public_place():
    with pytest.raises(TypeError, match=r"^rng: expected a numpy\.random\.Generator, got 1$"):
        check_instance("rng", 1, np.random.Generator)
    assert "\n" not in shown(np.eye(2))
