"""Action masks: the moves that run into neither an obstacle nor the border."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import matrixworld as mw
from reference import MOVES
from rows import NAMES, config_of, play_turns


def expected_mask(position: Any, obstacles: np.ndarray, n_actions: int) -> list[int]:
    """Return the mask of one agent from the map, cell by cell."""
    if position[0] < 0:
        return [1] * n_actions
    mask = [1]
    for d_row, d_col in MOVES[1:n_actions]:
        row, col = position[0] + d_row, position[1] + d_col
        inside = 0 <= row < obstacles.shape[0] and 0 <= col < obstacles.shape[1]
        mask.append(int(inside and not obstacles[row, col]))
    return mask


@pytest.mark.parametrize("name", NAMES)
@pytest.mark.parametrize("diagonal", [False, True])
def test_masks_of_vector_environments(name: str, diagonal: bool) -> None:
    config = config_of(name, obstacles=0.2, diagonal=diagonal, max_steps=6)
    env = mw.VectorEnv(config, 5, state=True, action_mask=True, autoreset_mode="SameStep")
    _, infos = env.reset(seed=3)
    for _ in range(14):
        masks = infos["action_mask"]
        assert (masks.shape, masks.dtype) == ((5, config.n_agents, config.n_actions), np.int8)
        for w in range(5):
            ground = infos["state"][w, 2].astype(bool)
            for agent, position in enumerate(infos["positions"][w]):
                expected = expected_mask(position, ground, config.n_actions)
                assert masks[w, agent].tolist() == expected
        actions = [env.single_action_space.sample(mask=tuple(of_world)) for of_world in masks]
        *_, infos = env.step(actions)
        assert not infos["involved"][..., 0].any()


@pytest.mark.parametrize("name", ["O", "TO", "swarm-SD"])
def test_masks_in_turns(name: str) -> None:
    """An agent that is asked to act has the mask of the cell on which it stands."""
    env = mw.aec_env(config_of(name, obstacles=0.2), action_mask=True)
    env.reset(seed=2)
    inside = env.unwrapped

    def choose(agent: str, info: dict[str, Any]) -> int:
        position = inside.status.positions[inside.possible_agents.index(agent)]
        ground = env.state()[2].astype(bool)
        assert info["action_mask"].tolist() == expected_mask(position, ground, 5)
        return int(env.action_space(agent).sample(info["action_mask"]))

    play_turns(env, choose)
    assert inside.status.steps > 1


def test_without_the_option_there_is_no_mask() -> None:
    env = mw.parallel_env(config_of("O"))
    _, infos = env.reset(seed=1)
    assert "action_mask" not in infos["pursuer_0"]
    assert "action_mask" not in mw.VectorEnv("O").infos
