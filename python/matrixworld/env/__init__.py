"""PettingZoo environments: `parallel_env`, `aec_env`, and `makers` for a module of one variant.

Importing this registers the nine variants with PettingZoo:
``pettingzoo.make("parallel", "matrixworld/pursuit_evasion_o_v0")``.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, TypeAlias

from pettingzoo.env_registry.registration import register
from pettingzoo.utils.wrappers import AssertOutOfBoundsWrapper, OrderEnforcingWrapper

from matrixworld.config import WorldConfig
from matrixworld.env.aec import MatrixWorldAEC
from matrixworld.env.parallel import MatrixWorldParallel
from matrixworld.env.shared import INFO_KEYS, OPTIONS, RENDER_MODES, Status
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
