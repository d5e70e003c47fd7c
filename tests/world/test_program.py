"""Programs as trees: text, code and ratings of the same program, however deep it is."""

import numpy as np

import matrixworld as mw


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
