"""The built engine of the pages plays the episodes of the fingerprint."""

from __future__ import annotations

import importlib.util
from pathlib import Path
from types import ModuleType
from typing import Any

import pytest

import matrixworld as mw
from matrixworld.world.arrays import WORLD_FIELDS
from node import policy_json, run_node
from rows import random_actions, random_genome

CONTRACT = Path(__file__).parents[1] / "contract/test_fingerprint.py"


def contract() -> ModuleType:
    """Return the module with the episodes and the number of the extension."""
    spec = importlib.util.spec_from_file_location("fingerprint_of_the_extension", CONTRACT)
    assert spec
    assert spec.loader
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def game(number: int, config: mw.WorldConfig, expected: ModuleType) -> dict[str, Any]:
    """Return the episodes of one config as plain values."""
    shape = expected.STEPS, expected.N_WORLDS, config.n_agents
    network = mw.Network.for_config(config, (9, 7))
    return {
        "config": config.to_json(),
        "actions": random_actions(number, config.n_actions, *shape).tolist(),
        "team": policy_json(mw.Population(random_genome(network, 1), network)),
        "matches": [[str(seed), 2] for seed in range(6)],
    }


@pytest.mark.slow
def test_the_built_engine_has_the_fingerprint_of_the_extension() -> None:
    expected = contract()
    moments = [name for name in expected.ARRAYS if WORLD_FIELDS[name].written == "moment"]
    given = {
        "worlds": expected.N_WORLDS,
        "steps": expected.STEPS,
        "cents": expected.CENTS,
        "arrays": {
            "all": expected.ARRAYS,
            "of_moment": moments,
            "of_step": [name for name in expected.ARRAYS if name not in moments],
        },
        "scores": expected.SCORES,
        "games": [game(*numbered, expected) for numbered in enumerate(expected.configs())],
    }
    assert run_node("fingerprint.mjs", given) == expected.FILE.read_text(encoding="ascii").strip()
