"""Programs as trees: text, code and ratings of the same program, however deep it is."""

import numpy as np

import matrixworld as mw
from matrixworld.world.program import cases_of


def test_programs_as_text_are_the_same_programs():
    program, rng = mw.Program(), np.random.default_rng(4)
    for _ in range(200):
        genome = program.initial(rng, depth=4)
        inputs = rng.random((5, len(mw.INPUTS)), np.float32)
        again = program.genome(program.expression(genome))
        np.testing.assert_array_equal(program.encode(program.tokens(genome)), genome)
        np.testing.assert_array_equal(program.rate(again, inputs), program.rate(genome, inputs))
        called = program.genome(program.expression(again))
        np.testing.assert_array_equal(called, again)


def test_a_program_may_be_deep():
    """A sum of a thousand terms is a thousand operations deep."""
    program = mw.Program(inputs=("room",), length=2001)
    total = program.encode(["room", *["room", "add"] * 1000])
    inputs = np.ones((5, len(mw.INPUTS)), np.float32)
    np.testing.assert_array_equal(program.rate(total, inputs), np.full(5, 1001))
    np.testing.assert_array_equal(program.simplified(total), total)
    negated = program.encode(["room", *["negate"] * 1001])
    assert program.tokens(program.simplified(negated)) == ["room", "negate"]


def test_all_programs_without_one_operation():
    """In a slow version: any operation is replaced by any of its arguments, in nested lists."""

    def without(node):
        if isinstance(node, list):
            name, *parts = node
            yield from parts
            for place, part in enumerate(parts):
                for shorter in without(part):
                    yield [name, *parts[:place], shorter, *parts[place + 1 :]]

    def tokens(node):
        if not isinstance(node, list):
            return [node]
        name, *parts = node
        return [*(token for part in parts for token in tokens(part)), name]

    tree = ["where", ["less", "room", ["min", "exits", 2.0]], ["add", "ahead", "room"], "exits"]
    program = mw.Program()
    genome = program.encode(tokens(tree))
    expected = {program.simplified(program.encode(tokens(one))).tobytes() for one in without(tree)}
    shorter = program.shorter(genome)
    assert {one.tobytes() for one in shorter} == expected
    lengths = [len(program.tokens(one)) for one in shorter]
    assert len(shorter) == len(expected)
    assert lengths == sorted(lengths)


def test_weights_are_those_of_a_weighted_sum():
    program = mw.Program(length=60)
    told = {
        "2 * (room - 3 * adversary) - -exits + 4": {"room": 2, "adversary": -6, "exits": 1},
        "room - room + 0 * exits": {},
        "3 * min(1, 2)": None,
        "room * adversary": None,
        "1e38 * (1e38 * room)": None,
    }
    for expression, expected in told.items():
        assert program.weights(program.genome(expression)) == expected, expression


def test_the_first_case_that_holds_is_the_program():
    """Of random programs, in float32, however many cases there may be."""
    rng = np.random.default_rng(5)
    program = mw.Program(length=200)
    inputs = rng.normal(size=(50, 5, len(mw.INPUTS))).astype(np.float32)
    numbers = set()
    for _ in range(60):
        genome = program.initial(rng, 6)
        for most in (1, 3, 6):
            cases = cases_of(program.tree(genome), most)
            assert len(cases) <= most
            rated, left = np.zeros((50, 5), np.float32), np.ones((50, 5), bool)
            for case in cases:
                holds = left.copy()
                for test in case.tests:
                    holds &= program.values(test, inputs) > 0
                rated[holds] = program.values(case.tree, inputs)[holds]
                left &= ~holds
            assert not left.any()
            np.testing.assert_array_equal(rated, program.rate(genome, inputs))
            numbers.add(len(cases))
    assert numbers == {1, 2, 3, 4, 5, 6}
