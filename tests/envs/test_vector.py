"""VectorEnv against single worlds and rollouts, Gymnasium's interface, and who owns the arrays."""

import copy
import itertools
import pickle

import gymnasium
import numpy as np
import pytest
from gymnasium.vector.utils import batch_space

import matrixworld as mw
from matrixworld.coevolution import TEAMS
from matrixworld.envs.vector import AutoresetMode
from rows import by_name, config_of, random_actions, random_team

SETTINGS = {"num_envs": 3, "rows": 12, "n_evaders": 2, "autoreset_mode": "SameStep"}
ENTRY_POINT = "vector_entry_point"


def make(name="O", n_worlds=4, **settings):
    # Short, so that resets happen soon.
    return mw.VectorEnv(config_of(name, max_steps=7), n_worlds, **settings)


@pytest.mark.parametrize("mode", AutoresetMode)
@pytest.mark.parametrize("name", ["SDB", "TO"])
@pytest.mark.parametrize(("observation", "seen"), [("views", "views"), ("named", "inputs")])
def test_its_arrays_are_those_of_a_batch(name, mode, observation, seen):
    env = make(name, autoreset_mode=mode, observation=observation)
    specs = mw.array_specs(env.config) | mw.episode_specs(env.config)
    written = {key: np.zeros((4, *shape), dtype) for key, (shape, dtype) in specs.items()}
    batch = mw.Batch(4, env.config, autoreset=mw.Autoreset[mode.name], buffers=written)
    final = f"final_{seen}" if mode is AutoresetMode.SAME_STEP else seen
    renamed = {"step": "steps", "episode_number": "episode", "final_obs": final}
    renamed |= {"_final_obs": "ended", "_episode": "ended"}
    env.reset(seed=5)
    batch.reset(5)
    for actions in random_actions(1, 5, 20, 4, env.config.n_agents):
        *results, infos = env.step(actions)
        batch.step(actions)
        expected = [written[key] for key in (seen, "rewards", "terminations", "truncations")]
        np.testing.assert_equal(results, expected)
        for key, told in infos.pop("episode").items():
            np.testing.assert_array_equal(told, written[f"episode_{key}"])
        for k, kind in enumerate(mw.COLLISION_KINDS):
            np.testing.assert_array_equal(infos.pop(f"cost_{kind}"), written["fault"][..., k])
        for key, told in infos.items():
            np.testing.assert_array_equal(told, written[renamed.get(key, key)], key)
        if mode is AutoresetMode.DISABLED and written["ended"].any():
            env.reset(options={"reset_mask": written["ended"]})
            batch.reset(mask=written["ended"])
    assert written["episode"].all()  # each world began anew at least once


def leaves(value):
    if not isinstance(value, dict):
        return [value]
    return [leaf for each in value.values() for leaf in leaves(each)]


@pytest.mark.parametrize("mode", AutoresetMode)
def test_what_was_returned_stays(mode):
    env = make(action_mask=True, autoreset_mode=mode)
    returned = [env.reset(seed=0)]
    for actions in random_actions(2, 5, 9, 4, env.config.n_agents):
        returned.append(env.step(actions))
        inside = (env.observations, env.rewards, env.terminations, env.truncations, env.infos)
        np.testing.assert_equal(returned[-1], inside)
    once = copy.deepcopy(returned)
    # Nothing returned shares memory with what is written next.
    kept = [leaf for each in returned for part in each for leaf in leaves(part)]
    inside = [env.actions, env.observations, env.rewards, *leaves(env.infos)]
    assert not any(np.shares_memory(array, own) for array in kept for own in inside)
    env.step(np.zeros((4, env.config.n_agents), int))
    env.reset(seed=5)
    np.testing.assert_equal(returned, once)
    assert any(not np.array_equal(one[0], other[0]) for one, other in itertools.pairwise(returned))


def test_actions_are_written_into_the_arrays_of_the_teams():
    envs, twin = (mw.VectorEnv("O", 2, rows=6, cols=6, n_pursuers=2, n_evaders=2) for _ in "ab")
    for each in (envs, twin):
        each.reset(seed=0)
    envs.actions[:, envs.pursuers], envs.actions[:, envs.evaders] = [[1, 2], [2, 1]], 3
    expected = [[1, 2, 3, 3], [2, 1, 3, 3]]
    np.testing.assert_array_equal(envs.actions, expected)
    np.testing.assert_array_equal(envs.step()[0], twin.step(expected)[0])
    with pytest.raises(AttributeError):
        envs.actions = expected
    world, batch = mw.World("O"), mw.Batch(1)
    with pytest.raises(AttributeError, match="^positions: expected no assignment"):
        world.positions = world.positions + 1
    with pytest.raises(AttributeError, match="buffers"):
        batch.buffers = {}


def test_seeds():
    env, other = make(), make()
    with pytest.raises(RuntimeError, match="^call reset"):
        env.step(np.zeros((4, 7), int))
    first = env.reset(seed=9)[0]
    np.testing.assert_array_equal(other.reset(seed=[9, 10, 11, 12])[0], first)
    second = env.reset()[0]
    assert not np.array_equal(first, second)
    np.testing.assert_array_equal(other.reset()[0], second)
    np.testing.assert_array_equal(env.reset(seed=9, options={"episode": 1})[0], second)
    with pytest.raises(TypeError, match="^seed: expected an integer, got None"):
        env.reset(seed=[None, 1])  # of two worlds


@pytest.mark.parametrize("variant", mw.VARIANTS)
def test_make_vec(variant):
    name = f"matrixworld/pursuit_evasion_{variant.lower()}_v0"  # as `gymnasium.make` spells it
    env = gymnasium.make_vec(name, **SETTINGS)
    assert isinstance(env, mw.VectorEnv)
    assert env.n_worlds == 3
    assert env.config.rules == mw.VARIANTS[variant]
    assert (env.config.rows, env.config.n_evaders) == (12, 2)
    assert env.spec is not None
    assert "kwargs" in env.spec.to_json()
    twins = [
        gymnasium.make_vec(env.spec),
        gymnasium.make_vec(f"matrixworld:{name}", **SETTINGS, vectorization_mode=ENTRY_POINT),
    ]
    for twin in twins:
        np.testing.assert_array_equal(env.reset(seed=5)[0], twin.reset(seed=5)[0])


@pytest.mark.parametrize("team", [None, "pursuer"])
@pytest.mark.parametrize("given", [{}, {"flatten": True}, {"observation": "named"}])
def test_spaces_are_those_that_gymnasium_would_make(team, given):
    worlds = make(**given, dtype="float32", autoreset_mode="SameStep")
    env = mw.AgentVectorEnv(worlds, team) if team else worlds
    for kind in ("observation_space", "action_space"):
        whole, single = getattr(env, kind), getattr(env, f"single_{kind}")
        expected = batch_space(single, env.num_envs)
        assert whole == expected == pickle.loads(pickle.dumps(whole))  # noqa: S301
        whole.seed(1)
        expected.seed(1)
        np.testing.assert_array_equal(whole.sample(), expected.sample())
    env.reset(seed=1)
    for _ in range(9):
        assert env.observation_space.contains(env.step(env.action_space.sample())[0])
    env.close()


def chosen(envs, policy):
    """Return what a policy chooses for the caller's team, with the random numbers of a rollout."""
    actions = np.zeros((envs.n_worlds, envs.config.n_agents), np.int64)
    envs._batch.decide([policy], np.zeros(envs.n_worlds, int), envs.agents, actions)
    return actions[:, envs.agents.start : envs.agents.stop]


@pytest.mark.parametrize("mode", AutoresetMode)
@pytest.mark.parametrize("team", TEAMS)
@pytest.mark.parametrize("name", ["D", "R", "SB"])
def test_episodes_are_those_of_rollouts(name, team, mode):
    config = config_of(name, obstacles=0.1, max_steps=12)
    networks = random_team(config, 1), random_team(config, 2)
    for mine, theirs in [("clumsy-chaser", "hunter"), networks]:
        envs = mw.VectorEnv(config, 4, autoreset_mode=mode, **{f"{team}s": theirs})
        sides = (theirs, mine) if team == "pursuer" else (mine, theirs)
        matches = mw.Matches.of(0, 0, np.arange(30, 34))
        statistics = vars(mw.rollout(config, *sides, matches, episodes=3))
        by_team = {
            key: np.stack([statistics[f"{side}_{key}"] for side in TEAMS], axis=-1)
            for key in ("return", "survivors")
        }
        counted = {**statistics, **by_team, "opponent": np.zeros((4, 3))}
        _, infos = envs.reset(seed=30)
        played = np.zeros(4, int)
        while (played < 3).any():
            _, _, _, _, infos = envs.step(chosen(envs, mine))
            for world in infos["_episode"].nonzero()[0]:
                if played[world] < 3:  # worlds with short episodes play more of them
                    for key, told in infos["episode"].items():
                        expected = counted[key][world, played[world]]
                        np.testing.assert_array_equal(told[world], expected)
                played[world] += 1
            if mode is AutoresetMode.DISABLED and infos["_episode"].any():
                envs.reset(options={"reset_mask": infos["_episode"]})


@pytest.mark.parametrize("team", TEAMS)
@pytest.mark.parametrize("name", ["TO", "D"])
def test_worlds_are_those_of_parallel_environments(name, team):
    """Also where the rules take turns: all agents choose before the round."""
    config = config_of(name, obstacles=0.1)
    settings = {f"{team}s": ["hunter", random_team(config, 1, memory="gru")]}
    envs = mw.VectorEnv(config, 3, autoreset_mode="Disabled", **settings)
    singles = [mw.parallel_env(config, **settings) for _ in range(3)]
    seen, infos = envs.reset(seed=8)
    for world, single in enumerate(singles):
        single.reset(seed=8 + world)
        assert infos["opponent"][world] == single.opponent  # drawn by the seed, in both alike
    for actions in random_actions(1, 5, 12, 3, len(envs.agents)):
        running = [bool(single.agents) for single in singles]
        seen, rewards, *_ = envs.step(actions)
        for world in np.flatnonzero(running):
            single = singles[world]
            observations, paid, *_ = single.step(by_name(single, actions[world]))
            for agent, reward in paid.items():
                place = single.possible_agents.index(agent)
                assert reward == rewards[world, place]
                assert np.array_equal(observations[agent], seen[world, place])


def test_a_league_changes_from_episode_to_episode():
    config = config_of("R", max_steps=5)
    envs = mw.VectorEnv(config, 40, evaders=["still", "fleer", "random"])
    stay = np.zeros((40, 3), int)
    _, infos = envs.reset(seed=0)
    first = infos["opponent"].copy()
    assert set(first) == {0, 1, 2}  # 40 worlds: all three are met
    envs.opponents = ["still", lambda seen: np.ones(len(seen), int)]
    assert len(envs.opponents) == 2
    for _ in range(5):  # steps of an episode
        *_, infos = envs.step(stay)
        assert (infos["opponent"] == first).all()
    ended = infos["_episode"]
    assert (infos["episode"]["opponent"] == first)[ended].all()
    *_, infos = envs.step(stay)
    second = mw.VectorEnv(config, 40, evaders=["still", "random"])
    _, expected = second.reset(seed=0, options={"episode": 1})
    assert (infos["opponent"] == expected["opponent"])[ended].all()
    # A reset of some worlds changes the opponents of these.
    kept, some = infos["opponent"].copy(), np.arange(40) < 20
    envs.opponents = "random"
    _, infos = envs.reset(options={"reset_mask": some})
    assert (infos["opponent"] == np.where(some, 0, kept)).all()


@pytest.mark.parametrize("mode", AutoresetMode)
def test_functions_are_asked_for_agents_that_act_only(mode):
    asked = []

    class Still(list):  # iterable, as modules of PyTorch can be
        def __call__(self, seen):
            asked.append(len(seen))
            return np.zeros(len(seen), int)

    config = config_of("D", max_steps=6)
    envs = mw.VectorEnv(config, 5, autoreset_mode=mode, evaders=Still())
    both = mw.VectorEnv(config, 5, autoreset_mode=mode)
    for each in (envs, both):
        each.reset(seed=1)
    for actions in random_actions(4, 5, 20, 5, 3):
        before = sum(asked)
        envs.step(actions)
        *_, infos = both.step(np.concatenate([actions, np.zeros((5, 4), int)], axis=1))
        assert sum(asked) - before == infos["acted"][:, 3:].sum()
