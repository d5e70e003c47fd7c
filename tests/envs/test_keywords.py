"""Keyword arguments of worlds and environments: their types, and unknown ones."""

from __future__ import annotations

import inspect
import warnings
from typing import Any

import pytest

import matrixworld as mw
from matrixworld.envs.single import EnvSettings, MatrixWorldBase
from matrixworld.world.config import WorldSettings

DOORS = {
    "WorldConfig.of": mw.WorldConfig.of,
    "World": mw.World,
    "Batch": lambda *args, **settings: mw.Batch(1, *args, **settings),
    "VectorEnv": mw.VectorEnv,
    "parallel_env": mw.parallel_env,
    "aec_env": mw.aec_env,
}


def annotations_of(typed_dict: Any) -> dict[str, str]:
    """Return the annotations of a TypedDict as they are written."""
    return {name: each.__forward_arg__ for name, each in typed_dict.__annotations__.items()}


def keywords_of(made: Any) -> dict[str, str]:
    parameters = inspect.signature(made).parameters.values()
    return {each.name: each.annotation for each in parameters if each.kind is each.KEYWORD_ONLY}


def test_settings_are_those_of_the_world() -> None:
    assert annotations_of(WorldSettings) == keywords_of(mw.WorldConfig)
    assert not WorldSettings.__required_keys__


def test_settings_are_those_of_the_environments() -> None:
    own = annotations_of(EnvSettings).items() - annotations_of(WorldSettings).items()
    assert dict(own) == keywords_of(MatrixWorldBase)


@pytest.mark.parametrize("door", DOORS)
def test_a_keyword_that_is_like_none_is_answered_with_all(door: str) -> None:
    for wrong in ("xyz", "rules"):
        with pytest.raises(
            TypeError, match=f"^keywords: expected some of .*cols, .*, got {wrong}$"
        ):
            DOORS[door](mw.WorldConfig("O"), **{wrong: 3})


@pytest.mark.parametrize(
    ("door", "wrong", "nearest"),
    [
        *((door, "n_pursuer", "n_pursuers") for door in DOORS),
        ("VectorEnv", "autoreset", "autoreset_mode"),
        ("VectorEnv", "num_worlds", "n_worlds"),
        ("parallel_env", "rendermode", "render_mode"),
        ("aec_env", "max_cycle", "max_cycles"),
        ("Batch", "thread", "threads"),
    ],
)
def test_an_unknown_keyword_names_the_nearest_one(door: str, wrong: str, nearest: str) -> None:
    with pytest.raises(TypeError, match=f"got {wrong}; did you mean {nearest}\\?"):
        DOORS[door]("O", **{wrong: 1})


@pytest.mark.parametrize("door", DOORS)
def test_all_settings_arrive(door: str) -> None:
    changes: WorldSettings = {
        "rows": 5,
        "cols": 6,
        "n_pursuers": 2,
        "n_evaders": 1,
        "fov": 3,
        "diagonal": True,
        "max_steps": 4,
        "obstacles": 0.1,
        "rewards": mw.Rewards.published(),
    }
    assert changes.keys() == WorldSettings.__annotations__.keys()
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        made = DOORS[door]("O", **changes)
    made = getattr(made, "unwrapped", made)
    config = getattr(made, "config", made)
    assert {name: getattr(config, name) for name in changes} == changes
