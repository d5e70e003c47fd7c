"""``matrixworld solve``: what it prints, and worlds that it refuses."""

import json

import pytest

from command_line import matrixworld_command

SMALL = ("--rows", 4, "--cols", 4, "--pursuers", 2, "--evaders", 1)


def test_the_numbers_of_two_pursuers_on_4_x_4():
    result = matrixworld_command("solve", "--variant", "O", *SMALL, "--steps", 5, "--json", "-")
    found = json.loads(result.stdout)
    assert found["value"] == pytest.approx(0.838, abs=0.005)
    assert found["value"] == found["value_by_step"][5]
    assert found["gap"] < 1e-9
    assert (found["states"], found["world"]["max_steps"]) == (1922, 5)
    assert "capture rate after 5 steps" in result.stderr
    assert "capture_time" not in found


@pytest.mark.parametrize(("pursuers", "time"), [(2, 3), (1, None)])
def test_cops_and_robbers(pursuers, time):
    options = (*SMALL[:5], pursuers, *SMALL[6:], "--json", "-")
    result = matrixworld_command("solve", "--variant", "to", *options)
    assert json.loads(result.stdout)["capture_time"] == time
    assert ("never: the evaders can escape" in result.stderr) == (time is None)


@pytest.mark.parametrize(
    ("options", "said"),
    [
        (("--rows", 30, "--cols", 30), "cells would fit"),
        ((*SMALL, "--obstacles", 0.1), "expected none or a map"),
        ((*SMALL, "--pursuers", 0), "--pursuers"),
        ((*SMALL, "--variant", "X"), "expected"),
    ],
)
def test_worlds_that_cannot_be_solved(options, said):
    result = matrixworld_command("solve", *options, code=2)
    assert said in result.stderr
    assert result.stdout == ""
