"""What policies do, in words and numbers, against answers found in another way."""

import json
import re
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from scipy import stats

import matrixworld as mw
from command_line import matrixworld_command
from matrixworld.analysis import Estimate
from matrixworld.analysis.intervals import level_of_each
from matrixworld.coevolution.evaluation import effects, explanation, imitation
from matrixworld.coevolution.evaluation.scores import SCORE
from matrixworld.coevolution.evaluation.trials import difference
from matrixworld.coevolution.seeding import explanation_seed
from matrixworld.coevolution.types import other
from tiny_race import played, tiny_race, tiny_single

NAMES = list(mw.INPUTS)
WORLD = mw.WorldConfig("O", rows=7, cols=7, n_pursuers=3, n_evaders=3, fov=7, max_steps=15)


def rating(genome, inputs, **fields):
    return mw.RatingPolicy(mw.Rating.for_config(WORLD, inputs=inputs, **fields), np.float32(genome))


def inputs_seen(count):
    """Return inputs of agents in new worlds, (count, moves, inputs)."""
    world, seen = mw.World(replace(WORLD, obstacles=0.1)), []
    for episode in range(count // WORLD.n_agents):
        world.reset(3, episode=episode)
        seen.append(world.inputs())
    return np.concatenate(seen)


# What rates moves:


def effects_of(**signed):
    """Return effects of inputs whose ratings go one way."""
    return {name: effects.Effect(max(size, 0.0), max(-size, 0.0)) for name, size in signed.items()}


SENTENCES = [
    ("pursuer", effects_of(adversary=-1), "A pursuer goes for the nearest evader."),
    ("evader", effects_of(adversary=1), "An evader runs from the nearest pursuer."),
    (
        "pursuer",
        effects_of(unclaimed=-1.0, open_side=-0.6, room=0.2),
        "A pursuer goes for evaders that no teammate is nearer to, goes for the free sides of "
        "evaders and minds walls little.",
    ),
    ("evader", effects_of(adversary=0.0), "An evader takes any move that is allowed."),
    (
        "evader",
        {"room": effects.Effect(0.5, 1.0), "exits": effects.Effect(0.8, 0.2)},
        "An evader now keeps to walls, now keeps off walls and prefers open cells.",
    ),
]


@pytest.mark.parametrize(("team", "moved", "expected"), SENTENCES)
def test_sentences(team, moved, expected):
    assert effects.sentence(team, effects.deed(moved)) == expected
    assert [*effects.PHRASES] == [*mw.INPUTS]


# The input, its weight, and what a pursuer and an evader do by it.
DEEDS = [
    ("exits", 1, "prefers open cells", "prefers open cells"),
    ("room", -1, "keeps to walls", "keeps to walls"),
    ("escapes", -1, "closes evaders' ways out", "gives up ways out"),
    ("escapes", 1, "leaves evaders ways out", "keeps ways out"),
    ("opposite", 1, "stands opposite a teammate", "stands between pursuers"),
    ("opposite", -1, "stands on the same side as a teammate", "keeps pursuers on one side"),
    ("parity", -1, "keeps even distances", "keeps even distances"),
    ("parity", 1, "keeps odd distances", "keeps odd distances"),
]


@pytest.mark.parametrize(("name", "weight", "pursuer", "evader"), DEEDS)
def test_what_is_said_is_done(name, weight, pursuer, evader):
    """The input of the cells that it moves to is less, or more, than that of other cells."""
    acts = rating([weight], (name,))
    seen = inputs_seen(600)
    moves = acts(seen)
    x = seen[..., NAMES.index(name)]
    mean = (x * acts.allowed(seen)).sum(axis=1) / acts.allowed(seen).sum(axis=1)
    of_moves = np.take_along_axis(x, moves[:, None], axis=1)[:, 0]
    assert weight * (of_moves - mean).mean() > 0.01
    for team, does in (("pursuer", pursuer), ("evader", evader)):
        [term] = explanation.explain(acts, team, WORLD, episodes=2).terms
        assert effects.in_words(team, term.does) == does


def term(name, effect, lost, low, high):
    lost = Estimate(lost, low, high, "episodes", 100)
    return effects.Term(name, effect, effect, (), max(effect, 0.0), max(-effect, 0.0), lost)


WORTH = [
    (
        [
            term("ahead", 0.1, 0.412, 0.4, 0.424),
            term("adversary", -3.0, 0.05, 0.01, 0.09),
            term("room", 9.0, 0.01, -0.001, 0.0211),
            term("exits", 0.0, 0.0, 0.0, 0.0),
            term("open_side", -4.0, -0.02, -0.03, -0.01),
            term("pressure", 5.0, -0.061, -0.08, -0.02),
        ],
        "A pursuer keeps its direction (worth 0.412 of capture rate) and goes for the nearest "
        "evader (0.050). By themselves these cost nothing, or at most 0.022: room and exits. "
        "Scores better without pressure (0.061) and open_side (0.020).",
    ),
    (
        [term("room", 9.0, 0.0, 0.0, 0.0)],
        "No input is worth something by itself. By itself this costs nothing: room.",
    ),
    (
        [term("teammate", -9.0, 0.3, 0.2, 0.4)],
        "A pursuer keeps close to a teammate (worth 0.300 of capture rate).",
    ),
]


@pytest.mark.parametrize(("terms", "expected"), WORTH)
def test_inputs_are_named_by_what_is_lost_without_them(terms, expected):
    """However far they move ratings."""
    assert effects.sentence_of_worth("pursuer", "capture rate", terms) == expected


def test_an_input_that_does_nothing_is_hardly_ever_named():
    """What is lost without it is chance alone; of several, none is named in 95 % of teams."""
    rng = np.random.default_rng(5)
    teams, count, false = 400, 9, 0
    level = level_of_each(count)
    for _ in range(teams):
        rates = rng.binomial(4, 0.6, size=(count + 1, 7, 100)) / 4  # opponents, episodes
        losses = [difference(rates[0], each, level) for each in rates[1:]]
        false += any(lost.sign for lost in losses)
    assert stats.binomtest(false, teams, 0.05).pvalue > 0.01 or false < 0.05 * teams


@pytest.mark.parametrize(("team", "weight", "said"), [("pursuer", -1, 0), ("evader", 1, 1)])
def test_a_chaser_and_a_fleer_are_told(team, weight, said):
    """Of two inputs, one of which does nothing."""
    told = explanation.explain(
        rating([weight, 0], ("adversary", "exits")), team, WORLD, episodes=12
    )
    adversary, exits = told.terms
    worth = f"(worth {adversary.lost.value:.3f} of {SCORE[team]})"
    does = f"{SENTENCES[said][2][:-1]} {worth}."
    assert told.sentence == f"{does} By itself this costs nothing: exits."
    assert (adversary.input, adversary.weight) == ("adversary", weight)
    assert np.sign(adversary.effect) == weight
    assert adversary.lost is not None
    assert adversary.lost.sign == 1  # without it, any move is as good
    assert exits.lost is not None
    assert exits.lost.ends == (0.0, 0.0)
    table = str(told).splitlines()[-2]
    assert re.match(rf"adversary +{weight}.000 .*[+-]█{{10}} ", table)


@pytest.mark.parametrize("hidden", [(), (3,)], ids=str)
def test_an_input_left_out_is_one_that_the_policy_does_not_have(hidden):
    """The same matches as by a policy of fewer inputs; the same ratings as if it were 0."""
    inputs = ("unclaimed", "teammate", "room")
    policy = mw.Rating.for_config(WORLD, inputs=inputs, hidden=hidden)
    acts = mw.RatingPolicy(policy, policy.initial(np.random.default_rng(2), 1.0))
    seen = inputs_seen(60)
    told = explanation.explain(acts, "pursuer", WORLD, episodes=6, seed=4)
    match = {"episodes": 6, "seed": explanation_seed(4, 0)}
    own = mw.score_policy(acts, "pursuer", WORLD, **match)
    assert told.score == own.mean()
    for place, name in enumerate(inputs):
        zeros = seen.copy()
        zeros[..., NAMES.index(name)] = 0
        rated = policy.rate(policy.without(acts.genome, name), seen)
        np.testing.assert_array_equal(rated, acts.rate(zeros))
        fewer = replace(policy, inputs=tuple(each for each in inputs if each != name))
        width = hidden[0] if hidden else 1
        genome = np.delete(acts.genome, slice(place * width, (place + 1) * width))
        other = mw.score_policy(mw.Population(genome, fewer), "pursuer", WORLD, **match)
        [term] = [term for term in told.terms if term.input == name]
        assert term.lost is not None
        assert term.lost.value == pytest.approx((own.means - other.means)[0])
        # Three intervals hold together at 95 %.
        differences = (own.rates - other.rates)[0].mean(axis=0)
        half = stats.t.ppf(1 - 0.05 / 3 / 2, 5) * stats.sem(differences)
        ends = np.clip(differences.mean() + half * np.array([-1, 1]), -1, 1)
        np.testing.assert_allclose(term.lost.ends, ends, rtol=1e-6)
        assert term.weight == (None if hidden else acts.genome[place])


def test_effects_are_weights_by_spread_and_dependence_is_a_mean():
    seen = inputs_seen(120)
    acts = rating([-2.0, 0.5], ("adversary", "exits"))
    allowed = seen[..., NAMES.index("room")] > 0
    for term in effects.terms_of(acts, seen):
        x = seen[..., NAMES.index(term.input)]
        spread = np.mean([np.var(row[free]) for row, free in zip(x, allowed, strict=True)]) ** 0.5
        assert term.effect == pytest.approx(term.weight * spread, rel=1e-3)
    policy = mw.Rating.for_config(WORLD, inputs=("exits", "room"), hidden=(4,))
    acts = mw.RatingPolicy(policy, policy.initial(np.random.default_rng(0), 1.0))
    [room] = [term for term in effects.terms_of(acts, seen) if term.input == "room"]
    assert len(room.dependence) == 5
    for value, mean in room.dependence:
        changed = seen.copy()
        changed[..., NAMES.index("room")] = value
        assert mean == pytest.approx(acts.rate(changed)[allowed].mean(), rel=1e-4)


# Networks:


def slow_features(view, team):
    half, found = len(view[0]) // 2, {}
    cells = [(r, c) for r in range(-half, half + 1) for c in range(-half, half + 1)]
    channels = (1, 0) if team == "evader" else (0, 1)
    for channel, name in zip(channels, ("adversary", "teammate"), strict=True):
        agents = [at for at in cells if view[channel, at[0] + half, at[1] + half]]
        agents = [at for at in agents if name == "adversary" or at != (0, 0)]
        nearest = min(agents, key=lambda at: abs(at[0]) + abs(at[1]), default=None)
        south, east = nearest or (0, 0)
        found[f"{name} south"], found[f"{name} east"] = south, east
        found[f"{name} moves"] = abs(south) + abs(east) if nearest else 2 * half + 1
        found["adversaries" if name == "adversary" else "teammates"] = len(agents)
    steps = {"north": (-1, 0), "east": (0, 1), "south": (1, 0), "west": (0, -1)}
    for direction, (r, c) in steps.items():
        free = [k for k in range(1, half + 1) if not view[2, half + k * r, half + k * c]]
        blocked = set(range(1, half + 2)) - set(free)
        found[f"free cells {direction}"] = min(blocked) - 1
    return found


@pytest.mark.parametrize("team", ["pursuer", "evader"])
def test_features_of_views(team):
    views = (np.random.default_rng(1).random((200, 3, 7, 7)) < 0.08).astype(np.uint8)
    found = imitation.features(views, team)
    for number, view in enumerate(views):
        slow = slow_features(view, team)
        assert {name: each[number] for name, each in found.items()} == slow


def test_a_tree_is_scored_by_its_own_matches():
    """Its rules are played as they are printed."""
    pytest.importorskip("sklearn")
    network = mw.Network.for_config(WORLD, (8,), sampled=False)
    genome = network.initial(np.random.default_rng(3), 0.3, 1.0)
    acts = mw.NetworkPolicy(network, genome)
    options = {"episodes": 5, "seed": 2, "depth": 5}
    told = explanation.explain(acts, "evader", WORLD, **options)
    assert told.tree is not None
    named = re.sub(r"if (.+) <= ", r'if x["\1"] <= ', told.text)
    rules = compile(re.sub(r"(\w+) \(\d\.\d+\)", r'move = "\1"', named), "rules", "exec")

    def by_rules(views):
        moves = []
        for view in views:
            names = {"x": slow_features(view, "evader")}
            exec(rules, names)
            moves.append(mw.Action[names["move"].upper()])
        return moves

    match = {"episodes": 5, "seed": explanation_seed(2, 0)}
    own, its = (mw.score_policy(each, "evader", WORLD, **match) for each in (acts, by_rules))
    assert (told.score, told.tree.score) == (own.mean(), its.mean())
    assert told.tree.cost.value == pytest.approx((own.means - its.means)[0])
    same = []

    def watched(views):
        moves = acts(views)
        same.extend(moves == by_rules(views))
        return moves

    mw.score_policy(watched, "evader", WORLD, episodes=2, seed=77)
    assert told.tree.agreement == pytest.approx(np.mean(same), abs=0.06)
    assert str(explanation.explain(acts, "evader", WORLD, **options)) == str(told)


# Of runs:


def test_the_command_says_what_the_run_says(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    run = played(tiny_race(policy="rating", hidden=()), Path("run"))
    command = ["explain", "run", "--generation", 1, "--episodes", 2, "--seed", 3]
    printed = matrixworld_command(*command, "--json", "told.json").stdout
    plain = json.loads(Path("told.json").read_text())
    for team in ("pursuer", "evader"):
        told = run.explain(team, 1, episodes=2, seed=3)
        assert str(told) in printed
        assert plain[f"{team}s"] == json.loads(json.dumps(told.to_json()))
        assert told.sentence in told._repr_html_()
    acts = run.policy("pursuer", 1, seed=0)
    assert isinstance(acts, mw.RatingPolicy)
    assert isinstance(run.best("evader"), mw.RatingPolicy)
    with pytest.raises(ValueError, match="sampled: expected no value for a rating policy, got Tru"):
        run.policy("pursuer", sampled=True)
    with pytest.raises(ValueError, match="depth: expected 3 to 6, got 7"):
        run.explain("pursuer", depth=7)


def test_what_no_tree_imitates_is_refused(tmp_path):
    pytest.importorskip("sklearn")
    run = played(tiny_single(memory="gru", hidden=(2,)), tmp_path / "run")
    with pytest.raises(ValueError, match="policy: expected one without memory"):
        run.explain(run.settings.learning_teams[0])
    with pytest.raises(ValueError, match="expected one that learned"):
        run.explain(other(run.settings.learning_teams[0]))


FIRST = "goes by the first case that holds for the cell of a move:"
PROGRAMS = [
    # Weighted sums are told as ratings are.
    (
        "pursuer",
        "room - 2 * adversary",
        "A pursuer goes for the nearest evader and keeps off walls.",
    ),
    ("evader", "adversary + 3", "An evader runs from the nearest pursuer."),
    ("evader", "2", "An evader takes any move that is allowed."),
    # Lists. An obstacle is at most 3 cells away, so `room` is at most 6 / 7.
    (
        "pursuer",
        "room if 0.6 < adversary else -open_side - 1",
        f"A pursuer {FIRST} (1) if no evader in view is within 2 moves, it keeps off walls; (2) "
        "otherwise, it goes for the free sides of evaders. Where it can choose "
        "between cases, it takes (1) in 100 % and (2) in 0 % of states.",
    ),
    (
        "evader",
        "-1 if adversary < 0.3 else 0",
        f"An evader {FIRST} (1) if the nearest pursuer in view is within 1 move, it rates all "
        "alike; (2) otherwise, it rates all alike. Where it can choose between cases, it "
        "takes (1) in 0 % and (2) in 100 % of states.",
    ),
    (
        "evader",
        "-4 + less(0, must_yield) * (teammate - 9) + (room if 0.9 < exits else pressure < 0.2)",
        f"An evader {FIRST} (1) if more than 3 cells around it are free and right of way "
        "forbids the move, it",
    ),
    # A case that has one move of a state compares states.
    (
        "pursuer",
        "-adversary if ahead > 0 else -pressure",
        f"A pursuer {FIRST} (1) if the move keeps its direction, it rates by -adversary; (2) "
        "otherwise, it keeps away from all evaders in view.",
    ),
    # What never decides is not told.
    ("pursuer", "min(5 + teammate, 0 - adversary)", "A pursuer goes for the nearest evader."),
    ("evader", "max(-room, exits) if room < 9 else ahead", "An evader prefers open cells."),
    # Ratings may be infinite, and equal then.
    ("evader", "3e38 * (9 + exits)", "An evader takes any move that is allowed."),
    # Neither is one way if there are two.
    (
        "pursuer",
        "-(adversary - 0.6) * (adversary - 0.6)",
        "A pursuer now goes for the nearest evader, now keeps away from the nearest evader.",
    ),
]


@pytest.mark.parametrize(("team", "expression", "expected"), PROGRAMS)
def test_programs_are_told_case_by_case(team, expression, expected):
    policy = mw.Program.for_config(WORLD)
    acts = mw.RatingPolicy(policy, policy.genome(expression))
    told = explanation.explain(acts, team, replace(WORLD, obstacles=0.1), episodes=2)
    assert told.sentence.startswith(expected)


def test_a_program_that_is_a_weighted_sum_has_the_terms_of_the_rating():
    """The same effects and weights as the rating of these inputs."""
    policy = mw.Program.for_config(WORLD, inputs=("adversary", "room"))
    program = mw.RatingPolicy(policy, policy.genome("room - 2 * adversary + 3"))
    acts = rating([-2, 1], ("adversary", "room"))
    told = explanation.explain(program, "pursuer", WORLD, episodes=2)
    expected = explanation.explain(acts, "pursuer", WORLD, episodes=2)
    moved = {each.input: effects.Effect(each.rises, each.falls) for each in expected.terms}
    assert told.sentence == effects.sentence("pursuer", effects.deed(moved))
    for one in told.terms:
        [other_one] = [each for each in expected.terms if each.input == one.input]
        assert (one.input, one.weight) == (other_one.input, other_one.weight)
        assert one.effect == pytest.approx(other_one.effect, rel=0.2)  # of other draws
    policy = mw.Program.for_config(WORLD)
    less = mw.RatingPolicy(policy, policy.genome("min(room, exits)"))
    told = explanation.explain(less, "pursuer", WORLD, episodes=2)
    assert {term.weight for term in told.terms} == {None}


LIMITS = [
    ("adversary < 0.3", "the nearest evader in view is within 1 move"),
    ("2 / 7 exactly < adversary", "no evader in view is within 1 move"),
    ("teammate < 0.9", "a teammate in view is within 3 moves"),
    ("room < 0.3", "an obstacle in its row or column is within 1 move"),
    ("0.5 < exits", "more than 2 cells around it are free"),
    ("must_yield", "right of way forbids the move"),
    ("ahead < 1", "the move leaves its direction"),
    ("escapes < 0.5", "at most 2 cells are ways out"),
    ("0.6 < escapes", "more than 3 cells are ways out"),
    ("parity", "the distance to the nearest evader is odd"),
]


@pytest.mark.parametrize(("test", "expected"), LIMITS)
def test_the_limits_of_cases_are_those_of_the_program(test, expected):
    """Its words hold for the very moves for which the test does: by numbers of moves and cells."""
    policy = mw.Program.for_config(WORLD, inputs=tuple(mw.INPUTS))
    test = test.replace("2 / 7 exactly", str(np.float32(2) / np.float32(7)))
    acts = mw.RatingPolicy(policy, policy.genome(f"where({test}, exits, room)"))
    world = replace(WORLD, obstacles=0.1)
    told = explanation.explain(acts, "pursuer", world, episodes=2).sentence
    assert f"(1) if {expected}, it" in told
    seen = inputs_seen(600)
    name = next(name for name in mw.INPUTS if name in test)
    x = seen[..., NAMES.index(name)].astype(float)
    units = {"exits": 4, "escapes": 5, "must_yield": 1, "ahead": 1, "parity": 1}
    counts = (units.get(name, 7 / 2) * x).round().astype(int)
    [number] = [int(word) for word in expected.split() if word.isdigit()] or [0]
    is_more = "no " in expected or "more" in expected
    is_more |= expected.endswith(("forbids the move", "odd"))
    holds = policy.rate(policy.genome(f"where({test}, 1, 0)"), seen) > 0
    np.testing.assert_array_equal(holds, (counts > number) == is_more)


def test_parts_of_a_program_that_are_worth_nothing_are_left_out():
    policy = mw.Program.for_config(WORLD, inputs=("adversary", "room", "teammate"))
    text = "min(5.0 + teammate, 0.0001 * room - 2.0 * adversary)"
    acts = mw.RatingPolicy(policy, policy.genome(text))
    told = explanation.explain(acts, "pursuer", WORLD, episodes=60).text
    [short] = re.findall("Without parts that are worth nothing: (.*)", told)
    assert "adversary" in short
    assert "teammate" not in short
    # What decides stays: a program of one input has no shorter one.
    chaser = mw.RatingPolicy(policy, policy.genome("-adversary"))
    assert "Without parts" not in explanation.explain(chaser, "pursuer", WORLD, episodes=60).text
