"""Vector environments that play one team themselves."""

from typing import Any

import numpy as np
import pytest

import matrixworld as mw
from matrixworld.coevolution import TEAMS
from matrixworld.envs.vector import AutoresetMode
from rows import by_name, config_of, random_actions, random_team


def chosen(envs: mw.VectorEnv, policy: Any) -> np.ndarray:
    """Return what a policy chooses for the caller's team, with the random numbers of a rollout."""
    actions = np.zeros((envs.n_worlds, envs.config.n_agents), np.int64)
    envs._batch.decide([policy], np.zeros(envs.n_worlds, int), envs.agents, actions)
    return actions[:, envs.agents.start : envs.agents.stop]


@pytest.mark.parametrize("mode", AutoresetMode)
@pytest.mark.parametrize("team", TEAMS)
@pytest.mark.parametrize("name", ["D", "R", "SB"])
def test_episodes_are_those_of_rollouts(name: str, team: str, mode: AutoresetMode) -> None:
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
def test_worlds_are_those_of_parallel_environments(name: str, team: str) -> None:
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


def test_a_league_changes_from_episode_to_episode() -> None:
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
def test_functions_are_asked_for_agents_that_act_only(mode: AutoresetMode) -> None:
    asked = []

    class Still(list):  # iterable, as modules of PyTorch can be
        def __call__(self, seen: np.ndarray) -> np.ndarray:
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
