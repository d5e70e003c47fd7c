"""Environments of PettingZoo and Gymnasium: what all variants share.

`matrixworld.make` and `matrixworld.make_vec` make environments of one world and of many, from rules or the
name of a variant; `matrixworld.parallel_env` and `matrixworld.aec_env` those of PettingZoo. From
PettingZoo 1.27 on, ``pettingzoo.make("parallel", "matrixworld/pursuit_evasion_o_v0")`` knows each
variant, too. ``gymnasium.make`` makes a `matrixworld.AgentEnv`, the world of one agent, by the same id, and
``gymnasium.make_vec`` a `matrixworld.VectorEnv`.

## Observation

``(3, fov, fov)`` uint8, 0 or 1: a window centred on the agent, with the channels evaders, pursuers and
obstacles. Cells outside the grid are obstacles. The agent itself is not drawn; a teammate on its cell is.
An agent that is gone observes zeros. ``state()`` is the whole world in the same channels, ``(3, rows, cols)``.

With ``observation="named"`` an agent observes the named inputs of each move instead, ``(moves, inputs)``
float32, in the order of `matrixworld.INPUTS`. Functions that play a built-in team see views all the same.

## Actions

0 stay, 1 north, 2 east, 3 south, 4 west; with ``diagonal=True`` also 5 north-east, 6 south-east,
7 south-west, 8 north-west.

## Rewards

Those of the paper, as `matrixworld.Rewards` describes them; ``rewards=mw.Rewards(...)`` changes any of them,
and ``mw.Rewards.published()`` are those of the code that the paper's authors published.

## End

The world terminates when every evader is gone or captured (under ``R`` and ``B``: was captured at some
time), or when a team has no agents left. It is truncated after ``max_steps`` rounds. An agent that
disappears terminates in that step and leaves ``agents``.

## Infos

The same keys for every agent at every step, as plain values:

| key | |
|---|---|
| ``involved_obstacle``, ``involved_teammate``, ``involved_adversary`` | whether it was in a collision of this kind |
| ``fault_obstacle``, ``fault_teammate``, ``fault_adversary`` | whether it was at fault in it |
| ``cost_obstacle``, ``cost_teammate``, ``cost_adversary``, ``cost`` | 1.0 where at fault; their sum |
| ``captured``, ``captors`` | whether an evader is captured at this moment; the number of its captors |
| ``capture_rate``, ``ever_capture_rate`` | shares of the evaders: captured (now under surround, at some time under occupation); captured at some time |
| ``pursuer_survival_rate``, ``evader_survival_rate`` | shares of the team that are alive |
| ``step`` | rounds played |
| ``action_mask`` | only with an ``action_mask``: int8 of shape (n_actions,), 1 for allowed actions. ``True``: moves that run into neither an obstacle nor the border, and staying; ``"right-of-way"``: of these the moves that cannot put the agent at fault |

``env.status`` holds the same for all agents at once, as arrays in which an agent keeps its index.

Arguments are those of `parallel_env`; `World.reset` takes the ``options`` of a reset. The attribute
``opponents`` of an environment with a built-in team sets what plays for it in the episodes that begin then.
"""  # noqa: E501  (a table's row is one line)

from __future__ import annotations

from pathlib import Path

import gymnasium

from matrixworld._util.files import load_toml
from matrixworld.envs.single import aec_env, make, parallel_env
from matrixworld.envs.vector import make_vec
from matrixworld.world.rules import VARIANTS

try:
    from pettingzoo.env_registry.registration import register
except ImportError:  # before PettingZoo 1.27
    register = None

__all__ = ["aec_env", "make", "make_vec", "parallel_env"]

VARIANT_TEXTS = load_toml(Path(__file__).with_name("variants.toml"))
"""What the games of the variants model, in Markdown, by the names of `matrixworld.VARIANTS`."""

for _variant in VARIANTS:
    _name, _settings = f"pursuit_evasion_{_variant.lower()}_v0", {"config": _variant}
    if register is not None:
        register("aec", f"matrixworld/{_name}", aec_env, kwargs=_settings)
        register("parallel", f"matrixworld/{_name}", parallel_env, kwargs=_settings)
    # The name with hyphens is that of the variant in all other calls.
    for _each in (_name, f"pursuit-evasion-{_variant.lower()}"):
        gymnasium.register(
            f"matrixworld/{_each}",
            # Texts, not the functions: Gymnasium writes its specifications as JSON.
            entry_point="matrixworld.envs.single:AgentEnv",
            vector_entry_point="matrixworld.envs.vector:make_vec",
            kwargs=_settings,
        )
