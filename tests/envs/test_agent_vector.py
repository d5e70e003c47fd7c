"""Agents as sub-environments of a vector, and one agent as an environment of Gymnasium."""

import warnings

import gymnasium
import numpy as np
import pytest
from gymnasium.utils.env_checker import check_env

import matrixworld as mw
from matrixworld.envs.vector import AutoresetMode
from rows import config_of, random_actions

TEAMS = (None, "pursuer", "evader")


def worlds_of(name="D", n_worlds=3, **settings):
    return mw.VectorEnv(config_of(name, max_steps=9), n_worlds, **settings)


def actions_of(env, steps):
    return random_actions(3, env.single_action_space.n, steps, env.num_envs)


@pytest.mark.parametrize("mode", AutoresetMode)
@pytest.mark.parametrize("team", TEAMS)
@pytest.mark.parametrize("copied", [True, False])
def test_they_are_the_arrays_of_the_worlds(team, mode, copied):
    settings = {"autoreset_mode": mode, "flatten": True, "dtype": "float32", "action_mask": True}
    env = mw.AgentVectorEnv(worlds_of(copy=copied, **settings), team)
    worlds, n = env.worlds, env.num_envs // 3
    agents = {None: slice(0, 7), "pursuer": slice(0, 3), "evader": slice(3, 7)}[team]
    keys = {"alive", "acted", "positions", "involved", "fault", "cost", "action_mask"}
    keys |= {"final_obs", *(f"cost_{kind}" for kind in mw.COLLISION_KINDS)}
    for actions in [None, *actions_of(env, 12)]:
        seen, *results, infos = env.reset(seed=4) if actions is None else env.step(actions)
        ended = worlds.infos["terminated"] | worlds.infos["truncated"]
        parts = [worlds.rewards, worlds.terminations & ended[:, None], worlds.truncations]
        expected = [worlds.observations, *parts[: len(results)], *(worlds.infos[k] for k in keys)]
        for flat, whole in zip([seen, *results, *map(infos.pop, keys)], expected, strict=True):
            by_world = whole[:, agents].reshape(env.num_envs, *whole.shape[2:])
            np.testing.assert_array_equal(flat, by_world)
            assert flat.dtype == whole.dtype
        np.testing.assert_array_equal(infos.pop("_final_obs"), worlds.infos["_final_obs"].repeat(n))
        assert not infos


def test_the_other_team_plays_the_worlds_actions():
    env, twin = mw.AgentVectorEnv(worlds_of(), "pursuer"), worlds_of()
    env.reset(seed=1)
    twin.reset(seed=1)
    for row in random_actions(6, 5, 6, 3, 7):
        env.worlds.actions[:, env.worlds.evaders] = row[:, 3:]
        env.step(row[:, :3].ravel())
        twin.step(row)
        np.testing.assert_array_equal(env.worlds.observations, twin.observations)


@pytest.mark.parametrize("mode", ["NextStep", "SameStep"])
def test_masked_transitions_end_where_agents_disappear(mode):
    """Of the steps of an episode in which an agent acted, the last one is its end, and no other."""
    env = mw.AgentVectorEnv(worlds_of(autoreset_mode=mode))
    env.reset(seed=2)
    ends = {}
    for actions in actions_of(env, 60):
        episode = env.worlds.infos["episode_number"].repeat(7)
        _, _, terminations, truncations, infos = env.step(actions)
        is_end = terminations | truncations | ~infos["alive"]
        for agent in np.flatnonzero(infos["acted"]):
            ends.setdefault((int(agent), int(episode[agent])), []).append(bool(is_end[agent]))
    whole = [steps for (agent, number), steps in ends.items() if (agent, number + 1) in ends]
    assert all(steps == [False] * (len(steps) - 1) + [True] for steps in whole)
    assert len({len(steps) for steps in whole}) > 5  # some agents disappeared earlier than others
    assert len(whole) > 3 * env.num_envs


@pytest.mark.parametrize("team", ["pursuer", "evader"])
def test_it_tells_the_allowed_actions_and_attributes_of_each_agent(team):
    small = {"rows": 6, "cols": 6, "n_pursuers": 2, "n_evaders": 3}
    worlds = mw.VectorEnv("O", 3, action_mask="right-of-way", obstacles=0.2, **small)
    envs = mw.AgentVectorEnv(worlds, team)
    _, infos = envs.reset(seed=4)
    np.testing.assert_array_equal(envs.action_masks(), infos["action_mask"])
    assert envs.action_masks().dtype == bool
    assert envs.call("render_mode") == envs.call("render") == (None,) * envs.num_envs
    with pytest.raises(AttributeError, match="expected render, render_mode or spec, got 'color'"):
        envs.call("color")
    assert mw.AgentVectorEnv(mw.VectorEnv("O", 3), team).action_masks().all()


@pytest.mark.parametrize("team", ["pursuer", "evader"])
def test_named_inputs_beside_masks_and_functions_that_see_views(team):
    def stay(seen):
        assert (seen.shape[1:], seen.dtype) == ((3, 5, 5), np.uint8)
        return np.zeros(len(seen), int)

    opponent = {"pursuer": "evaders", "evader": "pursuers"}[team]
    settings = {"action_mask": "right-of-way", opponent: stay}
    envs = mw.AgentVectorEnv(worlds_of(observation="named", **settings), team)
    twin = mw.AgentVectorEnv(worlds_of(**settings), team)
    seen, infos = envs.reset(seed=4)
    told = twin.reset(seed=4)[1]
    for actions in actions_of(envs, 12):
        inputs = [twin.worlds.world(world).inputs()[twin.worlds.agents] for world in range(3)]
        np.testing.assert_array_equal(seen, np.concatenate(inputs))
        np.testing.assert_array_equal(infos["action_mask"], told["action_mask"])
        seen, *_, infos = envs.step(actions)
        told = twin.step(actions)[-1]


SMALL = {"rows": 8, "cols": 8, "n_pursuers": 3, "n_evaders": 2, "max_steps": 30}


@pytest.mark.parametrize("variant", mw.VARIANTS)
@pytest.mark.parametrize("agent", ["pursuer_1", "evader_0"])
def test_gymnasium_makes_and_checks_it(variant, agent):
    name = f"matrixworld/pursuit_evasion_{variant.lower()}_v0"
    given = {"observation": "named", "flatten": True} if agent == "evader_0" else {}
    env = gymnasium.make(name, agent=agent, action_mask=True, dtype="float32", **given, **SMALL)
    assert env.unwrapped.env.config.rules == mw.VARIANTS[variant]
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        warnings.filterwarnings("ignore", message=".*maximum value is infinity")  # as it is
        check_env(env.unwrapped, skip_render_check=True)


def test_mates_and_opponents_are_drawn_independently():
    env = mw.AgentEnv("O", pursuers=["chaser", "random"], evaders=["fleer", "random"], **SMALL)
    pairs = set()
    for seed in range(40):
        env.reset(seed=seed)
        pairs.add((int(env._mates.chosen[0]), env.env.opponent))
    assert len(pairs) == 4


def test_actions_and_resets_that_are_refused():
    env = mw.AgentVectorEnv(worlds_of())
    env.reset(seed=1)
    with pytest.raises(ValueError, match="^actions:"):
        env.step(np.zeros((3, 7), int))
    with pytest.raises(ValueError, match="^reset_mask: expected .*same value .* in world 1"):
        env.reset(options={"reset_mask": np.arange(21) == 8})
    env = mw.AgentEnv("O", **SMALL)
    with pytest.raises(RuntimeError, match=r"call reset\(\)"):
        env.step(0)
    env.reset(seed=0)
    with pytest.raises(TypeError, match="^action of pursuer_0: expected an int"):
        env.step(0.5)
