"""Players as tables of small worlds, against the engine's players and against matches."""

import numpy as np
import pytest

import matrixworld as mw
from matrixworld.play import capture_rates
from matrixworld.play.functions import Function, PlayerError
from matrixworld.solver import NotExactError, States, best_response, expected_payoff, solve, table
from rows import random_team

HOLE = np.array([[0, 0, 0, 0], [0, 1, 0, 0], [0, 0, 0, 0]], bool)
SIZES = {"rows": 3, "cols": 4, "obstacles": HOLE, "n_evaders": 1, "n_pursuers": 2, "max_steps": 4}
OWN = np.random.default_rng(0)
MOVES = np.array([(0, 0), (-1, 0), (0, 1), (1, 0), (0, -1)])


def flees(view, rng):
    """Do as the script fleer does, in plain Python."""
    middle = view.shape[1] // 2
    pursuers = np.argwhere(view[1]) - middle
    if not len(pursuers):
        return rng.integers(5)
    free = [a for a in range(5) if a == 0 or not view[2][tuple(MOVES[a] + middle)]]
    apart = [np.abs(pursuers - MOVES[a]).sum(axis=1).min() for a in free]
    return rng.choice([a for a, far in zip(free, apart, strict=True) if far == max(apart)])


def clumsily_flees(view, rng):
    """Do so in half of the steps."""
    return flees(view, rng) if rng.random() < 0.5 else int(rng.permutation(5)[0])


def tells_probabilities(view):
    """Return the probabilities of clumsy fleeing, instead of drawing by them."""
    return sum(
        share * np.eye(5)[flees(view, _First(place))] / 2 for place, share in _PLACES
    ) + np.full(5, 0.1)


class _First:
    """A generator that takes the item at a place, of those that there are."""

    def __init__(self, place):
        self.place = place

    def choice(self, items):
        return items[int(self.place * len(items))]

    def integers(self, n):
        return int(self.place * n)


_PLACES = [((place + 0.5) / 60, 1 / 60) for place in range(60)]  # 60: each share is a whole number


def same(found, expected, config, atol=1e-12):
    """Assert that tables are equal but for ends, in which nobody plays."""
    ends = config.n_evaders + 1
    assert len(found.steps) == len(expected.steps)
    for own, theirs in zip(found.steps, expected.steps, strict=True):
        for turn, other in zip(own, theirs, strict=True):
            np.testing.assert_allclose(turn[ends:], other[ends:], atol=atol)


@pytest.mark.parametrize("variant", ["O", "TO", "D", "R", mw.Rules("agent-turns")])
@pytest.mark.parametrize(
    ("function", "script"),
    [(flees, "fleer"), (clumsily_flees, "clumsy-fleer"), (tells_probabilities, "clumsy-fleer")],
)
def test_a_function_has_the_table_of_a_script_that_does_the_same(variant, function, script):
    states = States(mw.WorldConfig(variant, **SIZES, fov=11))
    same(table(states, function, "evader"), table(states, script, "evader"), states.config)
    response = best_response(states, function, "evader").value
    assert response == pytest.approx(best_response(states, script, "evader").value, abs=1e-12)


@pytest.mark.parametrize("variant", ["S", "TO", "D", mw.Rules("agent-turns")])
@pytest.mark.parametrize("mask", ["none", "obstacles", "right-of-way"])
def test_what_to_python_writes_has_the_table_of_its_genome(variant, mask):
    """The inputs of tables and their masks are those of the engine, in each step."""
    states = States(mw.WorldConfig(variant, **SIZES, fov=11))
    inputs = ("adversary", "teammate", "exits", "must_yield")
    rating = mw.Rating(inputs=inputs[: None if mask == "right-of-way" else 3], mask=mask)
    genome = rating.initial(np.random.default_rng(3))
    found = {}
    exec(rating.to_python(genome), found)
    expected = table(states, mw.RatingPolicy(rating, genome), "pursuer")
    same(table(states, found["choose"], "pursuer"), expected, states.config)
    assert expected.by_step == (mask == "right-of-way")


@pytest.mark.parametrize("player", ["careful-chaser", "-adversary - 9 * must_yield"])
@pytest.mark.parametrize("variant", ["O", "R", "TO"])
def test_players_that_count_steps_have_a_table_of_each(variant, player):
    config = mw.WorldConfig(variant, **SIZES, fov=11)
    assert table(States(config), player, "pursuer").by_step
    payoff = expected_payoff(config, player, "clumsy-fleer")
    played = capture_rates(config, player, "clumsy-fleer", seed=1, episodes=4000)
    assert played.mean() == pytest.approx(payoff, abs=4.5 * played.std() / 4000**0.5 + 1e-3)


def test_a_table_plays_in_the_engine_as_its_player_does():
    config = mw.WorldConfig("O", **SIZES, fov=11)
    payoff = expected_payoff(config, "chaser", clumsily_flees)
    matches = mw.Matches.of(0, 0, range(40))
    played = mw.rollout(config, "chaser", clumsily_flees, matches, episodes=100).capture_rate
    assert played.mean() == pytest.approx(payoff, abs=4.5 * float(played.std()) / 4000**0.5)


@pytest.mark.parametrize("fov", [3, 11])
@pytest.mark.parametrize("variant", ["S", "TO"])
def test_the_views_are_those_of_worlds(variant, fov):
    config = mw.WorldConfig(variant, **SIZES, fov=fov)
    states = States(config)
    views, places = states.views("pursuer")
    inputs = states.inputs("pursuer", places)
    assert len(np.unique(views.reshape(len(views), -1), axis=0)) == len(views)
    world = mw.World(config)
    for state in states.starts[::37]:
        cells = np.stack(np.divmod(states.cells()[state], config.cols), axis=1)
        world.reset(pursuers=cells[:2], evaders=cells[2:])
        members = states.members(0, "pursuer")
        np.testing.assert_array_equal(views[places[0][state]], world.views()[members])
        lasting = [i for i, name in enumerate(mw.INPUTS) if name not in ("ahead", "search")]
        np.testing.assert_array_equal(
            inputs[places[0][state]][..., lasting], world.inputs()[members][..., lasting]
        )


@pytest.mark.parametrize("variant", ["O", "D", "SB", "TO", mw.Rules("swarm-turns")])
def test_functions_of_many_views_and_genomes_as_policies_are_players(variant):
    config = mw.WorldConfig(variant, **SIZES, fov=5)
    states = States(config)
    network = random_team(config, 0)
    policy = mw.NetworkPolicy(network.policy, network.genomes[0], sampled=False)
    found = table(states, lambda views: policy(views), "pursuer")
    same(found, table(states, policy, "pursuer"), config)
    as_function = best_response(states, lambda views: policy(views), "pursuer").value
    as_policy = best_response(states, policy, "pursuer").value
    assert as_function == pytest.approx(as_policy, abs=1e-12)
    payoff = expected_payoff(states, lambda views: policy(views), "fleer")
    played = capture_rates(config, policy, "fleer", seed=1, episodes=2000)
    assert played.mean() == pytest.approx(payoff, abs=4.5 * played.std() / 2000**0.5 + 1e-3)


@pytest.mark.parametrize("variant", ["O", "TO"])
def test_a_solution_its_policy_and_its_table_are_the_same_player(variant):
    config = mw.WorldConfig(variant, **SIZES)
    solution = solve(config)
    for team in ("pursuer", "evader"):
        policy = solution.policy(team)
        for given in (solution, policy, table(States(config), policy, team)):
            response = best_response(config, given, team).value
            assert response == pytest.approx(solution.value, abs=1e-9)
    pair = solution.policy("pursuer"), solution.policy("evader")
    assert expected_payoff(config, *pair) == pytest.approx(solution.value, abs=1e-9)


def test_a_function_of_a_small_view_plays_by_the_middle_of_a_large_one():
    small, large = (States(mw.WorldConfig("O", **SIZES, fov=fov)) for fov in (3, 11))
    expected = table(small, flees, "evader")
    same(table(large, mw.player(flees, "evader", fov=3), "evader"), expected, large.config)
    with pytest.raises(ValueError, match="flees: expected a world with fov 5 or more, got 3"):
        table(small, mw.player(flees, "evader", fov=5), "evader")


def draws_by_itself(view):
    return int(OWN.integers(5))


def draws_normal_numbers(view, rng):
    return int(rng.normal() > 0)


def calculates_with_a_draw(view, rng):
    return int(rng.random() * 5)


def draws_without_end(view, rng):
    while rng.integers(2) == 0:
        pass
    return 0


@pytest.mark.parametrize(
    ("function", "said"),
    [
        (draws_by_itself, "draws_by_itself: it answers differently when it is asked again"),
        (draws_normal_numbers, r"draws_normal_numbers: rng.normal: its results cannot all"),
        (calculates_with_a_draw, "calculates_with_a_draw: rng.random: expected a comparison"),
        (draws_without_end, "draws_without_end: draws: expected at most 40 in a decision"),
        (lambda view, rng: sum(rng.permutation(8)) % 5, "expected at most 5,000 results"),
        (lambda view, rng, memory: 0, "it has a memory"),
        (random_team(mw.WorldConfig("O", **SIZES), 0, memory="gru"), "got memory 'gru'"),
    ],
)
def test_what_is_not_exact_is_refused_with_its_reason(function, said):
    with pytest.raises(NotExactError, match=said):
        table(States(mw.WorldConfig("O", **SIZES)), function, "evader")


def fails(view):
    return 1 // int(view[1].sum() > 5)


@pytest.mark.parametrize(
    ("function", "said"),
    [
        (fails, r"fails \(test_tables.py, line \d+\): ZeroDivisionError"),
        (lambda view: 9, r"test_tables.py, line \d+\): expected .*0 to 4, .*got 9"),
        (lambda view: -1, "got -1"),
        (lambda view: 1.5, "got 1.5"),
        (lambda view: "north", "got 'north'"),
        (lambda view: None, "got None"),
        (lambda view, rng: [0.5, 0.25, 0.23, 0, 0.0], "0.23, 0, 0, sum 0.98"),
        (lambda view, rng: [1.5, -0.5, 0, 0, 0.0], "sum to 1, got 1.5, -0.5"),
        (lambda view, rng: exit(), "SystemExit"),
    ],
)
def test_a_function_that_fails_is_named_with_its_line_and_what_came(function, said):
    with pytest.raises(PlayerError, match=said):
        table(States(mw.WorldConfig("O", **SIZES)), function, "evader")


def test_the_view_is_shown_that_a_function_fails_for():
    view = np.zeros((1, 3, 5, 5), np.uint8)
    view[0, 1, 2, 3] = view[0, 0, 1, 2] = view[0, 2, 2, 1] = 1
    view[0, 2, :, 0] = view[0, 2, 4] = 1
    with pytest.raises(PlayerError) as caught:
        Function(lambda view, rng: 7).probabilities(view, 5)
    shown = ["# . . . .", "# . E . .", "# # @ P .", "# . . . .", "# # # # #"]
    assert str(caught.value).splitlines()[1:] == shown


def test_a_function_that_hangs_is_stopped():
    def hangs(view, rng):
        while True:
            pass

    function = mw.player(hangs, "evader", seconds=0.2)
    with pytest.raises(PlayerError, match=r"test_tables.py, line \d+\): expected an answer within"):
        table(States(mw.WorldConfig("O", **SIZES)), function, "evader")


def test_rng_and_memory_stand_anywhere_and_a_view_is_odd():
    def flees_too(rng, view):
        return flees(view, rng)

    states = States(mw.WorldConfig("O", **SIZES, fov=11))
    same(table(states, flees_too, "evader"), table(states, flees, "evader"), states.config)
    with pytest.raises(ValueError, match="fov: expected an odd number, got 4"):
        mw.player(flees, "evader", fov=4)


def test_a_function_of_one_view_is_told_by_its_own_error():
    def crooked(view):
        down, _ = np.argwhere(view[1])[0] - 5
        return unknown + down  # noqa: F821

    with pytest.raises(PlayerError, match=r"NameError: .*unknown.*, for the view"):
        table(States(mw.WorldConfig("O", **SIZES, fov=11)), crooked, "evader")


@pytest.mark.parametrize(
    "function", [lambda: 0, lambda a, b, c, d: 0, lambda view, *, speed: 0, lambda **more: 0]
)
def test_functions_with_other_arguments_are_refused(function):
    with pytest.raises(TypeError, match=r"expected f\(views\), f\(view\), f\(view, rng\)"):
        mw.player(function, "evader")


def test_a_refused_draw_is_seen_also_if_the_function_catches_it():
    def hides(view, rng):
        try:
            return int(rng.normal() > 0)
        except Exception:  # noqa: BLE001, what a user writes
            return 0

    with pytest.raises(NotExactError, match="rng.normal"):
        table(States(mw.WorldConfig("O", **SIZES)), hides, "evader")


def test_probabilities_of_float32_are_as_exact_as_they_can_be():
    def chooses(view, rng):
        return rng.choice(5, p=np.float32([0.1, 0.2, 0.3, 0.2, 0.2]))

    config = mw.WorldConfig("O", **SIZES)
    found = table(States(config), chooses, "evader").steps[0][0][config.n_evaders + 1 :]
    np.testing.assert_allclose(found.sum(axis=1), 1, atol=1e-12)


def test_a_table_of_steps_plays_in_episodes_of_as_many_only():
    config = mw.WorldConfig("O", **SIZES, fov=11)
    policy = table(States(config), "careful-chaser", "pursuer").policy()
    short = mw.WorldConfig("O", **(SIZES | {"max_steps": 3}), fov=11)
    matches = mw.Matches.of(0, 0, 0)
    assert mw.rollout(config, policy, "fleer", matches).length
    for given in (policy, policy.play):
        with pytest.raises(ValueError, match="expected a world with max_steps 4, which it counts"):
            mw.rollout(short, given, "fleer", matches)


def test_long_lines_are_no_paths_and_players_can_be_made_anew():
    line = " + ".join(["adversary"] * 60)
    assert mw.player(line, "evader").kind == "program"
    wide = mw.player(flees, "evader")
    config = mw.WorldConfig("O", **SIZES, fov=11)
    narrow = mw.player(wide, "evader", fov=3, name="short-sighted")
    assert narrow.at(config).fov == 3
    assert narrow.name == "short-sighted"


def test_no_matches_have_no_statistics():
    def remembers(view, rng, memory):
        return 0

    config = mw.WorldConfig("O", **SIZES)
    with pytest.warns(UserWarning, match="remembers is asked in every step"):
        played = mw.rollout(config, "chaser", remembers, mw.Matches.of([], [], []), episodes=3)
    assert played.faults.shape == (0, 3, 2, 3)
