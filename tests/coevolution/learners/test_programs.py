"""Genetic programming: typed trees, their operators, and a learner that finds a chaser."""

import numpy as np
import pytest

import matrixworld as mw
from matrixworld.coevolution import Programs, Pursuit
from matrixworld.coevolution.learners import genetic_programming as gp
from matrixworld.coevolution.learners.learner import Results, Task
from tiny_race import played, tiny_race

POLICY = mw.Program(fov=5, length=120)


def genomes(count, depth=5):
    rng = np.random.default_rng(0)
    return [POLICY.initial(rng, depth=depth) for _ in range(count)]


def rated(genome):
    inputs = np.zeros((40, 5, len(mw.INPUTS)), np.float32)
    read = [list(mw.INPUTS).index(name) for name in POLICY.inputs]
    inputs[..., read] = 2 * np.random.default_rng(1).random((40, 5, len(read)), np.float32)
    return POLICY.rate(genome, inputs)


def check_typed(tree):
    """Raise AssertionError unless each argument has the type that its operation takes."""
    stack = [[float]]
    for node in tree:
        expected = stack[-1].pop(0)
        assert node.ret is expected
        stack.append([*getattr(node, "args", [])])
        while stack and not stack[-1]:
            stack.pop()
    assert not stack


def test_trees_and_genomes_are_the_same_programs():
    for genome in genomes(200):
        tree = gp.tree_of(POLICY, genome)
        check_typed(tree)
        np.testing.assert_array_equal(rated(POLICY.genome(str(tree))), rated(genome))


def test_simplified_programs_are_shorter_and_rate_the_same_bit_by_bit():
    before = after = 0
    for genome in genomes(300):
        short = POLICY.simplified(genome)
        np.testing.assert_array_equal(rated(short), rated(genome))
        np.testing.assert_array_equal(POLICY.simplified(short), short)
        before += len(POLICY.tokens(genome))
        after += len(POLICY.tokens(short))
    assert after < 0.97 * before
    for long, short_text in {
        "--room": "room",
        "1 * room + 0": "room",
        "min(exits, exits)": "exits",
        "2 * 3 - 1": "5.0",
        "room if 1 > 0 else exits": "room",
        "exits if room > 0 else exits": "exits",
    }.items():
        assert POLICY.expression(POLICY.simplified(POLICY.genome(long))) == short_text


def test_shorter_programs_lack_one_operation():
    text = "min(room - 2 * adversary, exits) if pressure < ahead else teammate"
    shorter = {POLICY.expression(each) for each in POLICY.shorter(POLICY.genome(text))}
    assert {"teammate", "min(room, exits) if pressure < ahead else teammate"} <= shorter
    for genome in genomes(40):
        lengths = [len(POLICY.tokens(each)) for each in POLICY.shorter(genome)]
        assert lengths == sorted(lengths)
        assert max(lengths, default=0) < len(POLICY.tokens(genome))


def test_operators_keep_types_and_make_what_they_say():
    rng, trees = np.random.default_rng(2), [gp.tree_of(POLICY, each) for each in genomes(60)]
    changed = 0
    for number, tree in enumerate(trees):
        other, text = trees[number - 1], str(tree)
        child = gp.mate(tree, other, rng)
        check_typed(child)
        mutant = gp.mutate(POLICY, tree, rng)
        check_typed(mutant)
        changed += str(mutant) != text
        assert str(tree) == text  # the parent stays
    assert changed > 30


def test_double_tournaments_prefer_the_fit_and_then_the_short():
    rng, fitness, sizes = np.random.default_rng(3), np.arange(10.0), np.arange(10)[::-1] + 1
    fit = gp.select_twice(fitness, sizes, 4000, rng, size=5, parsimony=0.5)
    assert fit.mean() > fitness.mean() + 2
    equal = np.zeros(10)
    short = gp.select_twice(equal, sizes, 4000, rng, size=5, parsimony=1.0)
    long = gp.select_twice(equal, sizes, 4000, rng, size=5, parsimony=0.0)
    # The shorter of two at random: a third of the range from the end.
    assert sizes[short].mean() == pytest.approx(3.85, abs=0.15)
    assert sizes[long].mean() == pytest.approx(7.15, abs=0.15)


def test_the_learner_finds_programs_that_rate_as_wanted():
    game = Pursuit(world=mw.WorldConfig(fov=5), settings=Programs(length=120))
    learner = gp.GeneticProgramming(population=40)
    draw = np.random.default_rng
    untrained = lambda rng: game.untrained("pursuer", rng)  # noqa: E731
    state = learner.start(Task(0, 0, 30, untrained, None, game))
    wanted = rated(POLICY.genome("room - adversary * exits"))
    errors = []
    for epoch in range(30):
        candidates, state = learner.ask(state, draw([0, epoch]))
        error = [np.abs(rated(genome) - wanted).mean(dtype=float) for genome in candidates]
        state = learner.tell(state, Results(-np.array(error)))
        errors.append(min(error))
    assert errors == sorted(errors, reverse=True)  # elites are kept
    assert errors[-1] < 0.65 * errors[0]


def test_a_race_of_programs_is_played_and_other_learners_are_refused(tmp_path):
    settings = tiny_race(policy="program", learner="gp", population=6)
    run = played(settings, tmp_path / "run")
    assert run.payoff().matrix.shape == (3, 3)
    team = run.teams["pursuer"]
    assert team.policy == mw.Program(fov=3)
    assert team.policy.genome(team.policy.expression(team.genomes[-1])).any()
    for policy, learner in (("program", "es"), ("cells", "gp"), ("rating", "gp")):
        with pytest.raises(ValueError, match="policy: expected "):
            mw.coevolution.RaceSettings.of(policy=policy, learner=learner)
