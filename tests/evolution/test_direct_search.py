"""Inputs that scripts compute in solved worlds: as the engine and as a slow reading have them."""

from functools import cache

import numpy as np
import pytest

import look_for_inputs
import matrixworld as mw
import readable_price
from direct_search import TODAY, Place, search
from look_for_inputs import Input, Looks
from matrixworld.solver import best_response

NUMBERS = (2, 4, 10, 12, 16, 19)
"""Worlds of MW-25: teams in turns and agents in turns, one and two evaders, walls, at once."""


@cache
def place(number):
    return Place(mw.SUITE.worlds[number - 1])


@pytest.mark.parametrize("number", NUMBERS)
def test_ratings_guarantee_what_the_engine_plays(number):
    here = place(number)
    config = here.states.config
    shape = mw.Rating(inputs=TODAY, fov=config.fov, n_actions=config.n_actions)
    weights = np.random.default_rng(number).standard_normal((3, len(TODAY))).astype(np.float32)
    inputs = np.stack([here.today[name] for name in TODAY], axis=2)
    for genome in weights:
        engine = best_response(here.states, mw.Population(genome[None], shape), "pursuer").value
        ours = here.guarantee(inputs @ genome.astype(float))
        assert ours * here.world.value == pytest.approx(engine, abs=1e-9)


def reading(here, view, move):
    """Return the cells after a move: of this pursuer, its teammates, evaders; and who may stand."""
    rows, cols = here.board.shape
    agents = [int(cell) for cell in here.cells[view]]
    me = int(here.own[view])
    agents[me] = int(here.after[view, move])
    pursuers = [cell for cell in agents[: here.n_pursuers] if cell >= 0]
    evaders = [cell for cell in agents[here.n_pursuers :] if cell >= 0]

    def around(cell):
        y, x = divmod(cell, cols)
        cells = [(y, x), (y - 1, x), (y + 1, x), (y, x - 1), (y, x + 1)]
        return [
            y * cols + x
            for y, x in cells
            if 0 <= y < rows and 0 <= x < cols and not here.board[y, x]
        ]

    def apart(one, other):
        (y, x), (v, u) = divmod(one, cols), divmod(other, cols)
        return abs(y - v) + abs(x - u)

    return agents[me], pursuers, evaders, around, apart


@pytest.mark.parametrize("number", NUMBERS)
def test_what_the_grammar_says_is_what_a_slow_reading_says(number):
    here = place(number)
    looks = Looks(here)
    escapes = looks.values(look_for_inputs.BY_HAND["escapes"])
    parity = looks.values(look_for_inputs.BY_HAND["parity"])
    summed = looks.values(Input("distance", "nearest", "free", "next", "most", "sum"))
    opposite = look_for_inputs.opposite(here)
    rng = np.random.default_rng(0)
    for view in rng.choice(len(here.own), min(60, len(here.own)), replace=False):
        for move in np.flatnonzero(here.allowed[view]):
            me, pursuers, evaders, around, apart = reading(here, view, move)
            if not evaders:
                continue

            def nearest(cell, pursuers=pursuers, apart=apart):
                return min(apart(cell, pursuer) for pursuer in pursuers)

            shares = [np.mean([nearest(cell) > 1 for cell in around(e)]) for e in evaders]
            assert escapes[view, move] == pytest.approx(min(shares))
            assert parity[view, move] == min(apart(e, me) % 2 for e in evaders)
            far = sum(max(map(nearest, around(e))) for e in evaders)
            assert summed[view, move] == pytest.approx(far)
            assert 0.0 <= opposite[view, move] <= 1.0


@pytest.mark.parametrize("number", [2, 4, 12])
def test_what_a_policy_goes_by_does_not_tell_its_mistakes_from_best_moves(number):
    here = place(number)
    inputs = np.stack([here.today[name] for name in TODAY], axis=2)
    wrong = look_for_inputs.mistakes(here, -inputs[:, :, 0])
    assert wrong.sum() > 0
    assert look_for_inputs.separation(wrong, -inputs[:, :, 0]) <= 0
    assert look_for_inputs.separation(np.zeros_like(wrong), inputs[:, :, 0]) == 0.0


def test_an_input_of_the_grammar_says_itself_in_a_sentence():
    told = look_for_inputs.BY_HAND["escapes"].sentence
    assert told == (
        "Of the evader for which it is least: the mean, over the cells where the evader may be "
        "after its next move, of whether more than one move separates the nearest of all pursuers "
        "from the cell."
    )
    assert len({one.sentence for one in look_for_inputs.grammar(False)}) == len(
        look_for_inputs.grammar(False)
    )


def test_who_moves_second_anyway_loses_nothing_by_telling_first():
    assert readable_price.told_first(mw.SUITE.worlds[1]) == pytest.approx(1.0)
    assert readable_price.told_first(mw.SUITE.worlds[15]) < 1.0


def test_fewer_weights_are_a_part_of_more():
    here = place(4)
    columns = [here.today[name] for name in TODAY[:4]]
    found = readable_price.weights(here, columns, 60, 12)["by number"]
    assert [*found] == ["1", "2", "3", "4"]
    assert all(len(one["inputs"]) == int(k) for k, one in found.items())
    shares = [one["share"] for one in found.values()]
    assert shares == sorted(shares)


def test_a_search_finds_a_summit():
    best, at = search(lambda x: -float(((x - 2) ** 2).sum()), 3, 900, np.random.default_rng(0))
    assert best > -1e-3
    assert at == pytest.approx(np.full(3, 2.0), abs=0.05)
