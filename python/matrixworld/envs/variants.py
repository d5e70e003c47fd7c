"""One PettingZoo module per variant, made from the rules and a text instead of written by hand.

A row in `matrixworld.world.rules.VARIANTS` and a text in ``variants.toml`` are enough: the module,
its docstring, its page in ``docs/variants`` and its registrations follow.
"""

from __future__ import annotations

import sys
import textwrap
from collections.abc import Callable, Iterator
from importlib.machinery import ModuleSpec
from pathlib import Path
from types import ModuleType
from typing import TYPE_CHECKING, Any, NamedTuple

import gymnasium
from pettingzoo.utils.wrappers import AssertOutOfBoundsWrapper, OrderEnforcingWrapper
from typing_extensions import Unpack

from matrixworld._util.files import load_toml
from matrixworld.envs.agent import AgentEnv
from matrixworld.envs.single import EnvSettings, Info, MatrixWorldAEC, MatrixWorldParallel, View
from matrixworld.envs.vector import VectorEnv
from matrixworld.world.config import WorldConfig, with_limit
from matrixworld.world.rules import INTERACTION_TEXTS, OUTCOME_TEXTS, Capture, Rules

try:
    from pettingzoo.env_registry.registration import register
except ImportError:  # before PettingZoo 1.27
    register = None

if TYPE_CHECKING:  # PettingZoo has no types

    class AECWrapper(MatrixWorldAEC):
        """An AEC environment in wrappers, which pass on what it has."""

        unwrapped: MatrixWorldAEC

        def last(self, observe: bool = True) -> tuple[View | None, float, bool, bool, Info]:
            """Return observation, reward, termination, truncation and info of the next agent."""

        def agent_iter(self, max_iter: int = 2**63) -> Iterator[str]:
            """Yield the agents in the order in which they act."""

else:
    AECWrapper = OrderEnforcingWrapper

_CAPTURES = {
    Capture.OCCUPATION: "a pursuer reaches it",
    Capture.SURROUND: "pursuers, obstacles or the border are on its four sides",
}
_CLOSING = """\
All variants share their observations, actions, rewards, infos and arguments:
see `matrixworld.envs`.

Versions: v0, the first."""


def parallel_env(
    config: WorldConfig | Rules | str = "O", **settings: Unpack[EnvSettings]
) -> MatrixWorldParallel:
    """Make an environment of PettingZoo's parallel API: all agents act at once.

    Where the rules take turns, a step plays a whole round with actions that were all chosen before
    it.

    Parameters
    ----------
    config : WorldConfig, Rules or str, optional
        The world, its rules, or the name of a variant such as ``"O"`` or ``"pursuit-evasion-o"``.
    **settings
        Arguments of `MatrixWorldParallel`, and fields of `WorldConfig` to change.
    """
    return MatrixWorldParallel(config, **settings)


def aec_env(config: WorldConfig | Rules | str = "O", **settings: Unpack[EnvSettings]) -> AECWrapper:
    """Make an environment of PettingZoo's AEC API: one agent acts after the other.

    Where the rules take turns, this is the game itself: an agent observes what earlier agents did.
    Where they do not, agents only choose one after the other; the round is played when the last
    agent has chosen. The environment is in the usual wrappers of PettingZoo, which refuse actions
    out of range and calls out of order.

    Parameters
    ----------
    config, **settings
        As for `parallel_env`.
    """
    env: AECWrapper = OrderEnforcingWrapper(
        AssertOutOfBoundsWrapper(MatrixWorldAEC(config, **settings))
    )
    return env


class VariantText(NamedTuple):
    """The prose about one variant, in Markdown."""

    title: str
    models: str  # what the game models
    choose: str  # when to choose it, and how it differs from its neighbours
    observe: str  # a fact that shows in its episodes


_TEXTS = load_toml(Path(__file__).with_name("variants.toml"))
VARIANT_TEXTS = {name: VariantText(**text) for name, text in _TEXTS.items()}
"""The texts by the names of `matrixworld.VARIANTS`."""


class VariantModule(ModuleType):
    """A module with the environments of one variant, as PettingZoo's own modules have them.

    `env`, `raw_env` and `parallel_env` are `aec_env`, `MatrixWorldAEC` and `parallel_env` with the
    rules of the variant; they take the other arguments. So do `agent_env`, which makes a
    `matrixworld.AgentEnv`, and `vector_env`, a `matrixworld.VectorEnv` of ``num_envs`` worlds.
    """

    __all__: list[str]
    env: Callable[..., AECWrapper]
    raw_env: Callable[..., MatrixWorldAEC]
    parallel_env: Callable[..., MatrixWorldParallel]
    agent_env: Callable[..., AgentEnv]
    vector_env: Callable[..., VectorEnv]


def _vector_env(
    variant: str, num_envs: int = 1, max_episode_steps: int | None = None, **settings: Any
) -> VectorEnv:
    """Make many worlds with Gymnasium's interface; see `matrixworld.VectorEnv`."""
    limited = with_limit("max_episode_steps", max_episode_steps, settings)
    return VectorEnv(variant, num_envs, **limited)


def add_module(variant: str, package: str) -> None:
    """Make the module of a variant importable from `package`, and register its environments.

    ``gymnasium.make``, ``gymnasium.make_vec`` and, from PettingZoo 1.27 on, ``pettingzoo.make``
    know them by the same id.
    """
    name = f"pursuit_evasion_{variant.lower()}_v0"
    module = VariantModule(f"{package}.{name}", docstring(variant, name))
    # `import` and `importlib.util.find_spec` ask modules for it; there is nothing to load.
    module.__spec__ = ModuleSpec(module.__name__, loader=None, origin=package)
    module.__package__ = package
    makers: dict[str, Callable[..., Any]] = {
        "env": aec_env,
        "raw_env": MatrixWorldAEC,
        "parallel_env": parallel_env,
        "agent_env": AgentEnv,
        "vector_env": _vector_env,
    }
    module.__all__ = list(makers)
    for each, make in makers.items():
        setattr(module, each, _of_variant(make, variant, module.__name__, each))
    sys.modules[module.__name__] = module
    setattr(sys.modules[package], name, module)
    if register is not None:
        register("aec", f"matrixworld/{name}", module.env)
        register("parallel", f"matrixworld/{name}", module.parallel_env)
    # Texts, not the functions: Gymnasium writes its specifications as JSON. The name with hyphens
    # is that of the variant in all other calls.
    for each in (name, f"pursuit-evasion-{variant.lower()}"):
        gymnasium.register(
            f"matrixworld/{each}",
            entry_point=f"{module.__name__}:agent_env",
            vector_entry_point=f"{module.__name__}:vector_env",
        )


def _of_variant(
    make: Callable[..., Any], variant: str, module: str, name: str
) -> Callable[..., Any]:
    """Return a function that calls `make` with a variant, by a name that pickle can find."""

    def made(*args: Any, **settings: Any) -> Any:
        return make(variant, *args, **settings)

    made.__module__, made.__name__, made.__qualname__ = module, name, name
    made.__doc__ = (make.__doc__ or "").partition("\n")[0]
    return made


def docstring(variant: str, name: str) -> str:
    """Return the docstring of the module `name` in Markdown: texts, facts and rules."""
    config = WorldConfig(variant)
    text = VARIANT_TEXTS.get(variant)
    if text is None:  # the tests say which text is missing; the games work without it
        prose = [f"# {variant}"]
    else:
        paragraphs = (text.models, text.choose, f"To observe: {text.observe}")
        prose = [f"# {variant}: {text.title}", *map(_filled, paragraphs)]
    return "\n\n".join([*prose, _table(_facts(name, config)), _rules(config.rules), _CLOSING, ""])


def _filled(paragraph: str) -> str:
    words = " ".join(paragraph.split())
    return textwrap.fill(words, 98, break_long_words=False, break_on_hyphens=False)


def _facts(name: str, config: WorldConfig) -> dict[str, str]:
    """Return what PettingZoo's pages state first of an environment."""
    teams = (("pursuer", config.n_pursuers), ("evader", config.n_evaders))
    return {
        "Import": f"`from matrixworld.envs import {name}`",
        "Make": f'`pettingzoo.make("parallel", "matrixworld/{name}")`',
        "Actions": "Discrete",
        "Parallel API": "Yes",
        "AEC API": "Yes",
        "Number of agents": f"`{config.n_agents}`",
        "Agents": ", ".join(f"`{team}_0` ... `{team}_{n - 1}`" for team, n in teams),
        "Action Shape": "`()`",
        "Action Values": f"`Discrete({config.n_actions})`",
        "Observation Shape": f"`(3, {config.fov}, {config.fov})`",
        "Observation Values": "`0, 1`",
        "State Shape": f"`(3, {config.rows}, {config.cols})`",
        "State Values": "`0, 1`",
    }


def _rules(rules: Rules) -> str:
    if rules.removes_captured:
        captured = "disappears"
    elif rules.capture is Capture.SURROUND:
        captured = "stays, and is free again when the ring opens"
    else:
        captured = "stays and moves on"
    rows = {
        "agents move": INTERACTION_TEXTS[rules.interaction],
        "an agent that runs into an obstacle or the border": OUTCOME_TEXTS[rules.obstacle],
        "an agent that collides with a teammate": OUTCOME_TEXTS[rules.teammate],
        "an evader that collides with a pursuer": OUTCOME_TEXTS[rules.evader],
        "a pursuer that collides with an evader": OUTCOME_TEXTS[rules.pursuer],
        "an evader is captured when": _CAPTURES[rules.capture],
        "a captured evader": captured,
    }
    return _table(rows, head="rule")


def _table(rows: dict[str, str], head: str = "") -> str:
    first = f"| {head} | |" if head else "| | |"
    return "\n".join([first, "|---|---|", *(f"| {key} | {value} |" for key, value in rows.items())])
