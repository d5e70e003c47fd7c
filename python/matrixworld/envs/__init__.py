"""The nine games as PettingZoo environments, one module each, with ``env``, ``raw_env``, ``parallel_env``.

``from matrixworld.envs import pursuit_evasion_o_v0; env = pursuit_evasion_o_v0.parallel_env()``

Each module's docstring says what its game models. What is common to all follows; rows of rules of
your own go to `matrixworld.parallel_env` and `matrixworld.aec_env`.

## Observation

``(3, fov, fov)`` uint8, 0 or 1: a window centred on the agent, in the channels evaders, pursuers,
obstacles. Outside the grid is obstacle; the agent itself is not drawn, a teammate on its cell is. An
agent that is gone sees zeros. ``state()`` is the whole world in the same channels, ``(3, rows, cols)``.

## Actions

0 stay, 1 north, 2 east, 3 south, 4 west; with ``diagonal=True`` also 5 north-east, 6 south-east,
7 south-west, 8 north-west.

## Rewards

| | pursuer | evader | paid |
|---|---|---|---|
| capture | +10 | -10 | to each captor and to the captured, once for each evader |
| neighbor | +0.1 | -0.1 | while an adversary is north, east, south or west of it |
| collide | -12 | -12 | for each kind of collision (obstacle, teammate, adversary) in which it is at fault |
| step | -0.05 | -0.05 | for each step |

``rewards=mw.Rewards(...)`` changes any of them, fines single kinds, says who is blamed, and pays lasting
captures at every step; ``mw.Rewards.published()`` are those of the code that the paper's authors
published.

## End

The world terminates when every evader is gone or captured (under ``R`` and ``B``: has been captured at
some time) or a team has nobody left; it is truncated after ``max_steps`` rounds. An agent that is gone
terminates in that step and leaves ``agents``.

## Infos

The same keys for every agent at every step, as plain values:

| key | |
|---|---|
| ``involved_obstacle``, ``involved_teammate``, ``involved_adversary`` | in a collision of this kind |
| ``fault_obstacle``, ``fault_teammate``, ``fault_adversary`` | and at fault in it |
| ``cost_obstacle``, ``cost_teammate``, ``cost_adversary``, ``cost`` | 1.0 where at fault; their sum |
| ``captured``, ``captors`` | an evader's capture at this moment; pursuers with part in it |
| ``capture_rate``, ``ever_capture_rate`` | shares of the evaders: captured (now under surround, at some time under occupation), ever captured |
| ``pursuer_survival_rate``, ``evader_survival_rate`` | shares that are alive |
| ``step`` | rounds played |

``env.status`` has the same for all agents at once, as arrays whose indices never shift.

## Arguments

``rows=40, cols=40, n_pursuers, n_evaders`` (8 and 30; where capture is by surrounding 20 and 5),
``fov=11, diagonal=False, max_steps=500`` (or ``max_cycles``), ``obstacles`` (a share of the cells, or a
map), ``rewards``, ``render_mode`` (``"human"``, ``"rgb_array"``, ``"ansi"``), ``fields_of_view``, ``record``.
``reset(seed=, options=)`` takes ``pursuers`` and ``evaders`` (positions), ``obstacles`` (a map) and
``episode``.
"""  # noqa: E501  (a table's row is one line)

from __future__ import annotations

from collections.abc import Callable
from typing import Any, TypeAlias

from pettingzoo.env_registry.registration import register
from pettingzoo.utils.wrappers import AssertOutOfBoundsWrapper, OrderEnforcingWrapper

from matrixworld.config import WorldConfig
from matrixworld.envs.aec import MatrixWorldAEC
from matrixworld.envs.base import INFO_KEYS, OPTIONS, RENDER_MODES, Status
from matrixworld.envs.parallel import MatrixWorldParallel
from matrixworld.rules import VARIANTS, Rules

__all__ = [
    "INFO_KEYS",
    "OPTIONS",
    "RENDER_MODES",
    "MatrixWorldAEC",
    "MatrixWorldParallel",
    "Status",
    "aec_env",
    "makers",
    "parallel_env",
    "raw_aec_env",
]

AECWrapper: TypeAlias = OrderEnforcingWrapper


def parallel_env(config: WorldConfig | Rules | str = "O", **settings: Any) -> MatrixWorldParallel:
    """All agents act at once: an environment of PettingZoo's parallel API.

    config: a `WorldConfig`, `Rules`, or the name of a variant (``"pursuit-evasion-o"``, ``"O"``)
    settings: as of `MatrixWorldParallel`, and fields of the config to change

    Where the rules take turns, a step plays a whole round with the actions committed before it.
    """
    return MatrixWorldParallel(config, **settings)


def raw_aec_env(config: WorldConfig | Rules | str = "O", **settings: Any) -> MatrixWorldAEC:
    """`aec_env` without PettingZoo's wrappers."""
    return MatrixWorldAEC(config, **settings)


def aec_env(config: WorldConfig | Rules | str = "O", **settings: Any) -> AECWrapper:
    """One agent acts after the other: an environment of PettingZoo's AEC API.

    config, settings: as of `parallel_env`

    Where the rules take turns, this is the game itself: an agent observes what was done before its
    turn. Where they do not, agents only commit one after the other, and the round is played when
    the last of them has. Wrapped, as PettingZoo's environments are: actions out of range and calls
    out of order are refused.
    """
    return OrderEnforcingWrapper(AssertOutOfBoundsWrapper(raw_aec_env(config, **settings)))


def makers(
    variant: str,
) -> tuple[
    Callable[..., AECWrapper], Callable[..., MatrixWorldAEC], Callable[..., MatrixWorldParallel]
]:
    """``env``, ``raw_env`` and ``parallel_env`` of a variant, as PettingZoo's modules have them."""

    def env(**settings: Any) -> AECWrapper:
        """The AEC environment, in PettingZoo's wrappers; see `matrixworld.aec_env`."""
        return aec_env(variant, **settings)

    def raw_env(**settings: Any) -> MatrixWorldAEC:
        """The AEC environment itself; see `matrixworld.aec_env`."""
        return raw_aec_env(variant, **settings)

    def parallel(**settings: Any) -> MatrixWorldParallel:
        """The parallel environment; see `matrixworld.parallel_env`."""
        return parallel_env(variant, **settings)

    return env, raw_env, parallel


for _variant in VARIANTS:  # for pettingzoo.make
    _module = f"pursuit_evasion_{_variant.lower()}_v0"
    register("aec", f"matrixworld/{_module}", f"matrixworld.envs.{_module}:env")
    register("parallel", f"matrixworld/{_module}", f"matrixworld.envs.{_module}:parallel_env")
