"""Checks of arguments: which arrays hold numbers, and in which order."""

import numpy as np
import pytest

from matrixworld._util.checks import check_floats, check_instance, check_sequence, shown

MASKED = np.ma.array([[0.9, 0.0], [0.2, 0.3]], mask=[[False, True], [False, False]])


@pytest.mark.parametrize("given", [[1, 2.5], np.float32([1, 2.5]), (1, np.float64(2.5)), MASKED[1]])
def test_numbers_are_copied(given: object) -> None:
    found = check_floats("x", given)
    assert found.dtype == np.float64
    assert found.tolist() == [*map(float, given)]
    assert found is not given


@pytest.mark.parametrize(
    "given",
    [{1.0, 2.0}, {1.0: 2.0}, "1", ["1"], b"1", [[1], [1, 2]], [1j], object(), (x for x in [1])],
)
def test_what_is_no_array_of_numbers_is_refused(given: object) -> None:
    with pytest.raises((TypeError, ValueError), match="^x: expected an array of numbers, got "):
        check_floats("x", given)


@pytest.mark.parametrize("given", [MASKED, [*MASKED]])
def test_a_masked_cell_is_named(given: object) -> None:
    with pytest.raises(ValueError, match=r"^x: .* got a masked cell at \(0, 1\)$"):
        check_floats("x", given)


def test_a_sequence_has_an_order() -> None:
    assert check_sequence("x", (n for n in [2, 1]), "ints") == (2, 1)
    for bad in ({1, 2}, {1: 2}, "12", 1):
        with pytest.raises(TypeError, match="^x: expected a sequence of ints, got "):
            check_sequence("x", bad, "ints")


def test_a_type_is_named_by_its_public_place() -> None:
    with pytest.raises(TypeError, match=r"^rng: expected a numpy\.random\.Generator, got 1$"):
        check_instance("rng", 1, np.random.Generator)
    assert "\n" not in shown(np.eye(2))
