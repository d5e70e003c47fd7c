"""Named inputs and the policies that rate moves by them, against slow versions in Python."""

import copy
import warnings

import numpy as np
import pytest

import matrixworld as mw
from inputs import OBSTACLES, all_slow_inputs
from matrixworld import _core
from matrixworld.solver import expected_payoff
from reference import MOVES
from right_of_way import ROWS
from rows import NAMES, config_of, random_actions

VIEWS = (1, 3, 5, 7, 9, 11)


def check_inputs(world):
    """Check all inputs but search, which follows a plan, bit by bit."""
    found = named(world.inputs())
    for name, expected in all_slow_inputs(world).items():
        np.testing.assert_array_equal(found[name], expected, name)


@pytest.mark.parametrize("obstacles", [0.0, 0.15])
@pytest.mark.parametrize("name", NAMES)
def test_inputs_are_those_of_the_slow_version(name, obstacles):
    """In all variants, with and without diagonal moves, in views of all sizes."""
    for number, fov in enumerate(VIEWS):
        config = config_of(name, obstacles=obstacles, fov=fov, diagonal=number % 2 == 0)
        world = mw.World(config)
        world.reset(NAMES.index(name), episode=number)
        for actions in random_actions(number, config.n_actions, 4, config.n_agents):
            check_inputs(world)
            if world.terminated or world.truncated:
                break
            world.step(actions)


def test_inputs_among_many_agents():
    """More agents than a view is compared with at once, and than fit two words of bits."""
    for name, n in (("R", 40), ("B", 30), ("S", 90)):
        config = config_of(name, rows=20, cols=21, n_pursuers=n, n_evaders=60, obstacles=0.1, fov=7)
        world = mw.World(config)
        for actions in random_actions(n, 5, 4, config.n_agents):
            check_inputs(world)
            world.step(actions)


def test_how_an_evader_is_held_by_hand():
    """An evader in a corner, and a pursuer two cells away along each wall."""
    world = mw.World("O", rows=5, cols=5, n_pursuers=2, n_evaders=1)
    world.reset(pursuers=[(0, 2), (2, 0)], evaders=[(0, 0)])
    found = named(world.inputs())
    stay, east, west = 0, 2, 4
    pursuer, _, evader = range(3)
    # It may stay in the corner; after a move east also in (1, 1), and the pursuers see it so.
    assert found["escapes"][evader, [stay, east]].tolist() == np.float32([0.2, 0.4]).tolist()
    assert found["escapes"][pursuer, [stay, west]].tolist() == np.float32([0.2, 0]).tolist()
    np.testing.assert_allclose(found["opposite"][evader, [stay, west]], [0.5, 0.5 - 0.5 / 5**0.5])
    np.testing.assert_allclose(found["opposite"][pursuer, [stay, west, east]], 0.5)
    assert found["parity"][evader, [stay, east]].tolist() == [0, 1]
    assert found["parity"][pursuer, [stay, west]].tolist() == [0, 1]


def drawn(world, agent):
    """Return the 32 random bits with which an agent decides in this step."""
    block = _core.philox([agent // 8, world.steps, 2, 0], [world.seed, world.episode])
    return (block[agent % 8 // 2] >> 32 * (agent % 2)) % 2**32


def allowed_moves(world, mask):
    """Return which moves a mask allows, bool (A, moves)."""
    config, inputs = world.config, named(world.inputs())
    allowed = np.ones((config.n_agents, config.n_actions), bool)
    if mask == "right-of-way":
        allowed = inputs["must_yield"] == 0
    elif mask == "obstacles":
        half = config.fov // 2
        for move, (row, col) in enumerate(MOVES[: config.n_actions]):
            allowed[:, move] = world.views()[:, OBSTACLES, half + row, half + col] == 0
        allowed[:, 0] = True
    return allowed


def named(inputs):
    return {name: inputs[..., i] for i, name in enumerate(mw.INPUTS)}


def random_policies(config, mask):
    """Yield policies of both kinds and several shapes, one random genome each."""
    rng = np.random.default_rng(config.fov)
    some = tuple(rng.permutation(list(mw.INPUTS))[:5].tolist())
    for hidden in ((), (3,), (9, 5)):
        for inputs in (some, tuple(mw.INPUTS)):
            rating = mw.Rating.for_config(config, inputs=inputs, hidden=hidden, mask=mask)
            yield mw.Population(rating.initial(rng), rating)
    # Whole numbers give ties, and huge ones what is no number.
    rating = mw.Rating.for_config(config, mask=mask, hidden=(2,))
    yield mw.Population(np.rint(2 * rating.initial(rng)), rating)
    yield mw.Population(np.float32(3e38) * np.sign(rating.initial(rng)), rating)
    for inputs in (some, tuple(mw.INPUTS)):
        program = mw.Program.for_config(config, inputs=inputs, mask=mask)
        for _ in range(4):
            yield mw.Population(program.initial(rng, depth=4), program)


@pytest.mark.parametrize("mask", ["none", "obstacles", "right-of-way"])
@pytest.mark.parametrize("name", ["O", "SB", "TO", "D", "wall-R"])
def test_choices_are_those_of_python(name, mask):
    """Ratings in NumPy and in the text of `to_python`, and the engine's choice of the best."""
    config = config_of(name, obstacles=0.1, diagonal=name in ("O", "TO"))
    world = mw.World(config)
    for number, team in enumerate(random_policies(config, mask)):
        world.reset(number)
        spoken = {}
        exec(team.policy.to_python(team.genomes[0]), spoken)
        for actions in random_actions(number, config.n_actions, 4, config.n_agents):
            if world.terminated:
                break
            inputs, allowed = world.inputs(), allowed_moves(world, mask)
            ratings = team.policy.rate(team.genomes[0], inputs)
            if np.abs(team.genomes).max() < 1e30:  # the text is for finite numbers
                np.testing.assert_array_equal(spoken["rate"](named(inputs)) + 0 * ratings, ratings)
            chosen = np.full(config.n_agents, -1)
            for agents in (range(config.n_pursuers), range(config.n_pursuers, config.n_agents)):
                world.decide(team, agents, chosen)
            for agent in np.flatnonzero(world.alive):
                row = np.where(allowed[agent], ratings[agent], -np.inf)
                best = np.flatnonzero(row == row.max())
                assert chosen[agent] == best[drawn(world, int(agent)) * len(best) >> 32]
            world.step(actions)


def test_scripts_written_as_ratings():
    """The chaser, the fleer and the dodger as weights play the very same matches."""
    config = mw.WorldConfig("O", rows=20, cols=20, n_pursuers=4, n_evaders=8, max_steps=60)
    matches = mw.Matches.of(0, 0, range(20))
    for script, name, weight in (
        ("chaser", "adversary", -1), ("fleer", "adversary", 1), ("dodger", "pressure", -1),
    ):  # fmt: skip
        rating = mw.Population(np.float32([weight]), mw.Rating(inputs=(name,)))
        program = mw.Program(inputs=(name,))
        code = mw.Population(program.genome(f"{weight} * {name}"), program)
        for other in ("random", "hunter"):
            played = [mw.rollout(config, team, other, matches) for team in (script, rating, code)]
            for found in played[1:]:
                np.testing.assert_array_equal(found.length, played[0].length)
                np.testing.assert_array_equal(found.pursuer_return, played[0].pursuer_return)


def test_right_of_way_keeps_ratings_from_fault():
    """In dense worlds of many rules, with any weights and any programs."""
    steps = 0
    for number, rules in enumerate(ROWS[::12]):
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", UserWarning)  # rows in which nobody can be captured
            config = mw.WorldConfig(
                rules, rows=8, cols=8, n_pursuers=12, n_evaders=10, max_steps=60, obstacles=0.1,
                diagonal=number % 2 == 0, fov=5 + 2 * (number % 4),
            )  # fmt: skip
        teams = list(random_policies(config, "right-of-way"))
        pursuers, evaders = teams[number % len(teams)], teams[(number * 7 + 3) % len(teams)]
        played = mw.rollout(config, pursuers, evaders, mw.Matches.of(0, 0, [1, 2]), episodes=3)
        assert not played.faults.any(), rules
        steps += int(played.agent_steps.sum())
    assert steps > 1e5


def test_what_is_no_policy_is_refused():
    program = mw.Program(length=3, inputs=("room", "exits"))
    for code, told in (
        ([[1, 2], [0, 0], [0, 0]], "genome 0, program: expected an input from 0 to 1"),
        ([[3, 0], [0, 0], [0, 0]], "expected 2 numbers on the stack for add"),
        ([[1, 0], [1, 1], [0, 0]], "expected code that leaves one number, got 2"),
        ([[1, 0], [0, 0], [1, 0]], "expected zeros after the end"),
    ):
        with pytest.raises(ValueError, match=f"^genomes, .*{told}"):
            mw.Population(np.float32(code).ravel(), program)
    for make in (mw.Rating, mw.Program):
        with pytest.raises(ValueError, match="^inputs: expected one of adversary"):
            make(inputs=("foe",))
        with pytest.raises(ValueError, match="^inputs: expected different ones"):
            make(inputs=("room", "room"))
        with pytest.raises(ValueError, match="^fov: expected at least 5 for the mask right-of-way"):
            make(fov=3, mask="right-of-way")
    for text in ("room / 2", "room(", "room if ahead else 1", "min(room, key=1)"):
        with pytest.raises(ValueError, match="^expression: expected"):
            program.genome(text)
    wide = mw.Population(np.float32([1]), mw.Rating(inputs=("room",), fov=7))
    with pytest.raises(ValueError, match="^pursuers: expected a policy for fov 11"):
        mw.rollout("O", wide, "random", mw.Matches.of(0, 0, 0))


def test_solved_worlds_take_ratings():
    """The value of a game of ratings is the mean of their matches."""
    config = mw.WorldConfig("TO", rows=4, cols=4, n_pursuers=2, n_evaders=1, max_steps=4, fov=5)
    inputs = ("adversary", "teammate", "room", "exits")
    rating = mw.Rating.for_config(config, inputs=inputs)
    team = mw.Population(np.float32([-1, 0.25, 0.5, -0.125]), rating)
    program = mw.Program.for_config(config)
    code = mw.Population(program.genome("adversary + min(room, exits)"), program)
    exact = expected_payoff(config, team, code)
    played = mw.rollout(config, team, code, mw.Matches.of(0, 0, range(50)), episodes=100)
    error = played.capture_rate.std() / 5000**0.5
    assert abs(played.capture_rate.mean() - exact) < 4 * error
    assert 0.1 < exact < 0.9
    for counts in (mw.Rating.for_config(config), mw.Rating.for_config(config, mask="right-of-way")):
        weights = np.ones(counts.genome_size, np.float32)
        with pytest.raises(
            ValueError, match="^champion: expected one that decides by what it sees .* ahead"
        ):
            expected_payoff(config, mw.Population(weights, counts), "random")


def test_policies_play_wherever_teams_play():
    """Recorded, in batches, as the team of an environment, and as copies."""
    config = config_of("O")
    rating = mw.Rating.for_config(config, hidden=(3,), mask="right-of-way")
    program = mw.Program.for_config(config, length=9)
    first = mw.Population(rating.initial(np.random.default_rng(1)), rating)
    second = mw.Population(program.genome("room - pressure * exits"), program)
    for policy in (rating, program):
        policy.core  # noqa: B018  # is not copied
        again = copy.deepcopy(policy)
        assert again == policy
        assert hash(again) == hash(policy)
    episode = mw.record(config, first, second, seed=3)
    played = mw.rollout(config, first, second, mw.Matches.of(0, 0, 3))
    assert episode.length == played.length[0, 0]
    batch = mw.Batch(2, config)
    batch.reset(np.uint64([3, 3]))
    chosen = np.zeros((2, config.n_agents), np.int64)
    batch.decide([first], [0, 0], range(config.n_pursuers), chosen)
    batch.decide([second], [0, 0], range(config.n_pursuers, config.n_agents), chosen)
    np.testing.assert_array_equal(chosen, [episode.actions[0]] * 2)
    env = mw.parallel_env(config, evaders=second)
    env.reset(seed=3)
    rewards = env.step({agent: int(episode.actions[0, i]) for i, agent in enumerate(env.agents)})[1]
    for i, agent in enumerate(rewards):
        assert rewards[agent] == episode.rewards[0, i]
