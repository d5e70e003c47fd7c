"""PettingZoo's environments agree with their worlds; keyword arguments of all environments."""

import inspect
import itertools

import numpy as np
import pytest
from pettingzoo.utils.conversions import aec_to_parallel

import matrixworld as mw
from matrixworld.envs.single import MatrixWorldAEC
from matrixworld.world.config import WorldSettings
from rows import NAMES, by_name, config_of, play_turns, random_actions

GIVEN = [
    *((name, {}) for name in NAMES),
    *itertools.product(
        ("O", "TO", "SDB"), ({"flatten": True, "dtype": "float32"}, {"observation": "named"})
    ),
]
"""Rules, and how agents observe."""


def check_seen(env, agent, seen, world):
    """Compare what an agent sees with views or inputs of the world."""
    number, space = env.possible_agents.index(agent), env.observation_space(agent)
    whole = world.inputs() if space.dtype == np.float32 and len(space.shape) == 2 else world.views()
    np.testing.assert_array_equal(seen, whole[number].reshape(space.shape))
    assert space.contains(seen)


@pytest.mark.parametrize(("name", "given"), GIVEN)
def test_a_step_is_a_round_of_the_world(name, given):
    config = config_of(name, obstacles=0.1)
    env, world = mw.make(config, **given), mw.World(config)
    world.reset(8)
    observations, infos = env.reset(seed=8)
    first = infos["pursuer_0"]
    alive = np.ones(config.n_agents, bool)
    for row in random_actions(3, config.n_actions, config.max_steps, config.n_agents):
        acted = [agent for agent, lives in zip(env.possible_agents, alive, strict=True) if lives]
        assert env.agents == acted
        observations, rewards, terminations, truncations, infos = env.step(by_name(env, row))
        world.step(row)
        for part in (observations, rewards, terminations, truncations, infos):
            assert list(part) == acted
        over = world.terminated or world.truncated
        for i, agent in enumerate(env.possible_agents):
            if not alive[i]:
                continue
            check_seen(env, agent, observations[agent], world)
            assert rewards[agent] == world.rewards[i]
            assert terminations[agent] == (world.terminated or not world.alive[i])
            assert truncations[agent] == (world.truncated and not terminations[agent])
            info = infos[agent]
            assert info.keys() == first.keys()
            assert {type(value) for value in info.values()} == {bool, float, int}
            assert (info["cost"], info["step"]) == (world.cost[i], world.steps)
            for k, kind in enumerate(mw.COLLISION_KINDS):
                assert info[f"fault_{kind}"] == world.fault[i, k] == info[f"cost_{kind}"]
                assert info[f"involved_{kind}"] == world.involved[i, k]
            for name in ("capture_rate", "ever_capture_rate"):
                assert info[name] == getattr(world, name)
            if i >= config.n_pursuers:
                evader = i - config.n_pursuers
                assert info["captured"] == world.captured[evader]
                assert info["captors"] == world.captors[evader]
        np.testing.assert_array_equal(env.state(), world.state())
        for field in vars(env.status):  # of all agents, also of those that are gone
            np.testing.assert_array_equal(getattr(env.status, field), world.read(field)[field])
        alive = world.alive
        if over:
            assert env.agents == []
            break
    assert over


def test_options():
    env = mw.parallel_env("R", rows=3, cols=3, n_pursuers=1, n_evaders=1)
    ground = np.eye(3, dtype=bool)
    env.reset(options={"pursuers": [[0, 1]], "evaders": [[2, 0]], "obstacles": ground})
    np.testing.assert_array_equal(env.status.positions, [[0, 1], [2, 0]])
    np.testing.assert_array_equal(env.state()[2], ground)
    with pytest.warns(UserWarning, match="expected some of .*'evaders'.*, ignored 'evader'"):
        env.reset(options={"evader": [[2, 0]]})
    env.reset(options={"episode": 5}, seed=9)
    assert (env.world.seed, env.world.episode) == (9, 5)


def test_what_is_refused_changes_nothing():
    env = mw.parallel_env(config_of("O", max_steps=1))
    with pytest.raises(RuntimeError, match="call reset"):
        env.step({})
    env.reset(seed=1)
    stay, before = dict.fromkeys(env.agents, 0), env.state()
    for change, error in (
        ({"pursuer_0": None}, TypeError),
        ({"pursuer_0": np.array([1])}, TypeError),
        ({"pursuer_1": -(2**70)}, ValueError),
        ({"evader_9": 0}, ValueError),
    ):
        with pytest.raises(error, match="^action(s| of pursuer_[01]): expected .* got .*[^ ]"):
            env.step(stay | change)
    with pytest.raises(ValueError, match=r"none came for \['pursuer_1', "):
        env.step({"pursuer_0": 0})
    np.testing.assert_array_equal(env.state(), before)
    assert env.status.steps == 0
    kinds = itertools.cycle([np.uint64(0), np.int64(0), 0])
    env.step(dict(zip(env.agents, kinds, strict=False)))
    assert env.step({}) == ({}, {}, {}, {}, {})  # nobody is left to act
    with pytest.raises(RuntimeError, match="has ended"):
        env.step({"pursuer_0": 0})
    with pytest.raises(RuntimeError, match="record=True"):
        env.recorded  # noqa: B018


DOORS = {
    "WorldConfig.of": mw.WorldConfig.of,
    "World": mw.World,
    "Batch": lambda *args, **settings: mw.Batch(1, *args, **settings),
    "VectorEnv": mw.VectorEnv,
    "parallel_env": mw.parallel_env,
    "aec_env": mw.aec_env,
}


def annotations_of(typed_dict):
    return {name: each.__forward_arg__ for name, each in typed_dict.__annotations__.items()}


def keywords_of(made):
    parameters = inspect.signature(made).parameters.values()
    return {each.name: each.annotation for each in parameters if each.kind is each.KEYWORD_ONLY}


def test_settings_of_keywords_are_those_of_worlds():
    assert annotations_of(WorldSettings) == keywords_of(mw.WorldConfig)


@pytest.mark.parametrize(
    ("door", "wrong", "nearest"),
    [
        *((door, "n_pursuer", "n_pursuers") for door in DOORS),
        ("VectorEnv", "num_worlds", "n_worlds"),
        ("aec_env", "max_cycles", "max_steps"),
    ],
)
def test_an_unknown_keyword_names_the_nearest_one(door, wrong, nearest):
    with pytest.raises(TypeError, match=f"'{wrong}'; did you mean {nearest}\\?"):
        DOORS[door]("O", **{wrong: 1})


@pytest.mark.parametrize(("name", "given"), GIVEN)
def test_an_episode_agrees_with_the_world_turn_by_turn(name, given):
    """Agents see what was done before their turn."""
    config = config_of(name, obstacles=0.1, max_steps=30)
    env, world = MatrixWorldAEC(config, **given), mw.World(config)
    expected = np.zeros(config.n_agents)
    rows = random_actions(5, config.n_actions, config.max_steps, config.n_agents)
    env.reset(seed=6)
    world.reset(6)

    def play_turn():
        world.play_turn(rows[world.steps])
        if world.turn == 0:
            expected[:] += world.rewards

    def choose(agent, _):
        number = env.possible_agents.index(agent)
        while world.steps < env.status.steps or number not in world.actors:
            play_turn()
        check_seen(env, agent, env.observe(agent), world)
        np.testing.assert_array_equal(env.state(), world.state())
        return int(rows[world.steps, number])

    paid = play_turns(env, choose)
    while world.steps < env.status.steps:
        play_turn()
    assert world.terminated or world.truncated
    np.testing.assert_allclose(list(paid.values()), expected, atol=1e-3)
    np.testing.assert_array_equal(env.state(), world.state())
    assert env.agents == []


@pytest.mark.parametrize("name", NAMES)
def test_only_simultaneous_rules_are_parallelizable(name):
    env = mw.aec_env(config_of(name))
    at_once = env.unwrapped.config.rules.interaction is mw.Interaction.SIMULTANEOUS
    assert env.metadata["is_parallelizable"] == at_once
    assert mw.parallel_env(config_of(name)).metadata["is_parallelizable"]
    if not at_once:
        with pytest.raises(AssertionError, match="not generally safe"):
            aec_to_parallel(env)


def test_a_refused_turn_is_still_to_be_taken():
    env = MatrixWorldAEC(config_of("O"))
    with pytest.raises(RuntimeError, match="call reset"):
        env.step(0)
    env.reset(seed=1)
    for action, error in ((5, ValueError), (None, TypeError)):
        with pytest.raises(error, match="^action of pursuer_0:"):
            env.step(action)
    assert env.agent_selection == "pursuer_0"
    env.observe("pursuer_0")[:] = 9  # the caller's own
    assert env.observation_space("pursuer_0").contains(env.last()[0])
