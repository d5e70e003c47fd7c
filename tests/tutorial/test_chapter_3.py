"""Replies of notebook 3 to right and wrong answers, and its match in plain Python."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

import matrixworld as mw
from matrixworld.tutorial import check, hint

NOTEBOOK = Path(__file__).parents[2] / "tutorials" / "03_can_a_chase_evolve.ipynb"


def reply(name: str, answer: object) -> str:
    found = check(name, answer)
    assert found.right is False
    return found.text


@pytest.mark.parametrize("name", ["3.1", "3.2", "3.3", "3.4"])
@pytest.mark.parametrize("answer", [None, 653, "text", [1, 2], np.zeros(3)])
def test_a_wrong_type_gets_a_sentence(name: str, answer: object) -> None:
    assert "Expected a" in reply(name, answer)


def test_hints_get_more_explicit() -> None:
    assert hint("3.1").text.startswith("Hint 1 of 3")
    assert "bias" in [hint("3.1").text for _ in range(2)][-1]


# Genome size


def test_biases_are_missed() -> None:
    text = reply("3.1", lambda side, hidden, moves: 3 * side**2 * hidden + hidden * moves)
    assert "counts the weights" in text
    assert "bias" not in text


def test_a_view_has_three_layers() -> None:
    text = reply("3.1", lambda side, hidden, moves: (side**2 + 1) * hidden + (hidden + 1) * moves)
    assert "How many layers" in text


def test_one_right_number_is_not_enough() -> None:
    assert "Expected another number" in reply("3.1", lambda side, hidden, moves: 653)


# Standard error


def test_the_square_is_missed() -> None:
    assert "more than twice" in reply("3.2", lambda spread, error: spread / error)


def test_the_number_of_matches_is_whole_and_enough() -> None:
    assert "whole number" in reply("3.2", lambda spread, error: int((spread / error) ** 2))
    assert "Expected a number" in reply("3.2", lambda spread, error: None)


# Overlap


def test_the_first_agent_on_a_cell_is_not_counted() -> None:
    text = reply("3.3", lambda cells, n: sum(cells.count(cell) > 1 for cell in cells) / n)
    assert "the first on each is not counted" in text


def test_the_share_is_of_the_whole_team() -> None:
    def share_of_living(cells, team_size):
        return (len(cells) - len(set(cells))) / max(1, len(cells))

    assert "share of the living" in reply("3.3", share_of_living)


def test_an_empty_team_is_asked_for() -> None:
    assert check("3.3", lambda cells, n: (len(cells) - len({*cells})) / n).right
    assert "Expected another number" in reply("3.3", lambda cells, n: len({*cells}) / n)


# Learners


class Climber:
    """A hill climber."""

    sigma = 0.05

    def __init__(self, genome, rng):
        self.genome = genome

    def ask(self, rng):
        noise = rng.standard_normal((20, len(self.genome)), dtype=np.float32)
        self.candidates = self.genome + np.float32(self.sigma) * noise
        return self.candidates

    def tell(self, fitness):
        self.genome = self.candidates[np.argmax(fitness)].copy()


def test_a_hill_climber_is_enough() -> None:
    assert check("3.4", Climber).right


@pytest.mark.parametrize(
    ("change", "expected"),
    [
        ({"sigma": 2.0}, "neither tiny nor huge"),
        ({"tell": lambda self, fitness: None}, "Does `genome` move"),
        ({"ask": lambda self, rng: self.genome}, "expected the shape"),
        ({"ask": lambda self, rng: np.zeros((4, 60))}, "expected the dtype float32"),
        ({"ask": lambda self, rng: [1.0]}, "expected an array"),
        ({"ask": None}, "no method 'ask'"),
        ({"__init__": lambda self, genome, rng: None}, "no attribute `genome`"),
    ],
)
def test_learners_that_do_not_learn(change: dict, expected: str) -> None:
    assert expected in reply("3.4", type("Other", (Climber,), change))


def test_the_worst_candidate_is_taken() -> None:
    class Faller(Climber):
        def tell(self, fitness):
            self.genome = self.candidates[np.argmin(fitness)].copy()

    assert "best candidate" in reply("3.4", Faller)


# The match in plain Python


def cells_with(*beginnings: str) -> list[str]:
    cells = json.loads(NOTEBOOK.read_text("utf-8"))["cells"]
    code = ["".join(cell["source"]) for cell in cells if cell["cell_type"] == "code"]
    return [cell for cell in code if cell.startswith(beginnings)]


@pytest.mark.parametrize("seed", range(3))
@pytest.mark.parametrize(
    "size", [{}, {"rows": 5, "cols": 5, "max_steps": 30}, {"n_pursuers": 1, "n_evaders": 9}]
)
def test_the_python_match_is_that_of_rollout(seed: int, size: dict) -> None:
    """For other networks and other worlds than those of the notebook."""
    fields = {"rows": 12, "cols": 12, "n_pursuers": 3, "n_evaders": 6, "fov": 5, "max_steps": 60}
    world = mw.WorldConfig("O", **{**fields, **size})
    network = mw.Network.for_config(world, (8,), sampled=False)
    names = {"world": world, "network": network, "np": np}
    for cell in cells_with("SIDE", "def play("):
        exec(cell, names)
    genome = network.initial(np.random.default_rng(seed), 0.3, 0.5)
    team = mw.Population(genome, network)
    matches = mw.Matches.of(0, 0, np.arange(12))
    statistics = mw.rollout(world, team, "random", matches)
    captures = np.rint(statistics.capture_rate[:, 0] * world.n_evaders)
    for match in range(12):
        episode = mw.record(world, team, "random", seed=match)
        cells = [tuple(cell) for cell in episode.positions[0].tolist()]
        moves = episode.actions[:, world.n_pursuers :].tolist()
        found = names["play"](genome, cells, moves)
        assert found == (captures[match], statistics.length[match, 0])
