"""One PettingZoo module per variant, made from the rules and a text instead of written by hand.

A row in `matrixworld.world.rules.VARIANTS` and a text below are enough: the module, its docstring,
its page in ``docs/variants`` and its registration for ``pettingzoo.make`` follow from them.
"""

from __future__ import annotations

import re
import sys
import textwrap
from collections.abc import Callable, Iterator, Mapping
from importlib.machinery import ModuleSpec
from types import MappingProxyType, ModuleType
from typing import Any, NamedTuple, TypeAlias

import gymnasium
from pettingzoo.env_registry.registration import register
from pettingzoo.utils.wrappers import AssertOutOfBoundsWrapper, OrderEnforcingWrapper
from typing_extensions import Unpack

from matrixworld.envs.single import EnvSettings, MatrixWorldAEC, MatrixWorldParallel
from matrixworld.envs.vector import VectorEnv
from matrixworld.world.config import WorldConfig
from matrixworld.world.rules import OUTCOME_TEXTS, Capture, Interaction, Rules

AECWrapper: TypeAlias = OrderEnforcingWrapper

COLUMNS = 98
"""Width of the paragraphs in a docstring."""

_MOVES = {
    Interaction.SIMULTANEOUS: "all at once",
    Interaction.SWARM_TURNS: "team by team",
    Interaction.AGENT_TURNS: "one after the other",
}
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
        The default is ``"O"``.
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
    return OrderEnforcingWrapper(AssertOutOfBoundsWrapper(MatrixWorldAEC(config, **settings)))


class VariantText(NamedTuple):
    """The prose about one variant, in Markdown.

    What the game models; when to choose it, and how it differs from its neighbours; a fact that
    shows in its episodes.
    """

    title: str
    models: str
    choose: str
    observe: str


# A title and three paragraphs for each variant. Links lead to the pages of others.
_TEXTS = """
# -D: Drones: every contact destroys

A swarm of drones or vehicles in the open. No agent survives a collision: an agent that flies into
a wall, a teammate or an adversary is lost, and so is the agent that it hits. An evader counts as
captured when a collision with a pursuer destroys it. That pursuer is destroyed too, so each
success makes its team smaller.

This is the only variant in which a mistake is final: no agent bounces off a wall. Choose it where
safety means survival, and look at `survival_rate` and at the share of episodes without a
collision. The same policy in [-R](r.md), where collisions remove no agent, shows what its
mistakes cost here.

Random walkers die out. Nine in ten are gone by the end of an episode, most of them through walls
and teammates.

# -R: Targets to be reached, cells to be shared

Agents that may share a cell, as in multi-agent path finding with common goals and in the
predator-prey task of the multi-agent particle environments. Evaders are targets, and reaching one
is what counts. No agent disappears: a target that was reached stays on the grid and moves on.

This is the gentlest variant: only obstacles make an agent bounce. Choose it for coverage, search
and assignment of targets, or as a baseline without safety constraints. [-B](b.md) is the same
game without collisions among teammates; in [-O](o.md) an evader that was reached disappears.

`capture_rate` counts every evader that was reached at some time. The episode ends when all of
them have been.

# -B: Path finding: teammates must not collide

Multi-agent path finding: two teammates may neither enter the same cell nor swap their cells.
Agents that would do so stay where they are, and so does the queue behind them. Evaders are the
places to go to; pursuers and evaders do not stop each other.

Choose it to study congestion, priorities and deadlocks in one team while the other merely moves
about. It is [-R](r.md) without the vertex and edge conflicts of path finding among teammates.
Adversaries do not block the way here; in [-SB](sb.md) they do.

Two teammates head to head in a corridor wait for each other for ever, and both are at fault.

# -O: Predators and prey: reached is caught

Predators hunt prey that is weaker than they are: on contact the prey disappears and the predator
does not. Teammates may share a cell, and walls stop every agent. The game also models a search
for targets scattered in space.

This is the standard game of the paper and the default of this package: captures are fast, evaders
are many, and an arms race can be measured within minutes. Choose it for co-evolution and for
first experiments. [-TO](to.md) is the same game by turns; in [-D](d.md) the pursuers die on
contact as well.

A fleeing evader is as fast as its pursuer. A single pursuer seldom catches it in the open, but
often at the border.

# -S: Surround it: the pursuit of Benda

The classical pursuit problem of Benda, Jagannathan and Dodhiawala (1986) in the form of Sun et
al. (2023). Prey is captured when it cannot move: each of its four sides has a pursuer, an
obstacle or the border. This takes four pursuers in the open, three at the border and two in a
corner.

Pursuers may share a cell, so they do not block each other. They cannot enter the cell of the
prey: an agent that tries bounces back. A capture lasts only as long as the ring is closed; when
it opens, the evader is free again. Choose it to study cooperation. [-SB](sb.md) forbids
collisions of teammates, [-SD](sd.md) removes captured evaders.

`capture_rate` can fall again: it counts the evaders that are surrounded at this moment.
`ever_capture_rate` counts those that were surrounded at some time.

# -SB: Surround it, without collisions

Predators as solid bodies. Prey is captured by being surrounded, as in [-S](s.md), and no two
agents may share a cell: teammates that would collide bounce back, and so do a pursuer and an
evader.

This is the strictest game of coordination: agents that block each other on the way have to close
the ring. Choose it to study safe cooperation: after a step no two living agents share a cell and
none have swapped cells. In [-SDB](sdb.md) a captured evader makes room.

When several agents follow an agent that has to stay, all of them bounce. Such a chain is spelled
out by a step with `explain=True`.

# -SD: Surround and remove

Hunting in a pack: prey that is surrounded is removed from the grid, and the pack goes on to the
next. As in [-S](s.md) teammates may share a cell, and the cell of the prey cannot be entered.

A capture is final: success is counted once, and the pursuers are free for more. Choose it where
the pursuers' work should end the episode. This is the only difference from [-S](s.md);
[-SDB](sdb.md) forbids collisions of teammates as well.

Captures are judged all at once. Two evaders side by side do not count as walls for each other.

# -SDB: Surround and remove, without collisions

A pack of solid bodies. As in [-SB](sb.md) no two agents may share a cell; as in [-SD](sd.md) a
surrounded evader is removed and its cell becomes free.

It combines all the constraints: cooperation to surround, safety on the way, and a population of
evaders that shrinks. Choose it where all of these matter.

After a capture the captors stand around an empty cell. Those that enter it together bounce.

# -TO: Cops and robbers: one after the other

Agents take turns: pursuers by number, then evaders by number, each on the board that the others
have left. This is the game of cops and robbers, or vertex pursuit, on a grid (Quilliot 1978;
Nowakowski and Winkler 1983; Bonato and Nowakowski 2011), and the interaction of PettingZoo's
pursuit. Contact is as in [-O](o.md): the evader disappears.

No two agents move at the same time, so no two can swap cells, and an agent sees what earlier
agents did. Choose it for games on graphs, and to see what simultaneous moves change. The AEC
environment is its natural form; the parallel one plays a round with actions that were all chosen
before it.

The scripts chaser and fleer make more captures here than in [-O](o.md). In its own turn a chaser
reaches the cell that its prey is on; when all move at once it reaches the cell that its prey has
just left.
"""


def _texts() -> Iterator[tuple[str, VariantText]]:
    for section in re.split("^# -", _TEXTS, flags=re.MULTILINE)[1:]:
        head, *paragraphs = section.strip().split("\n\n")
        name, title = head.split(": ", 1)
        yield name, VariantText(title, *paragraphs)


VARIANT_TEXTS: Mapping[str, VariantText] = MappingProxyType(dict(_texts()))
"""The texts by the names of `matrixworld.VARIANTS`."""


class VariantModule(ModuleType):
    """A module with the environments of one variant, as PettingZoo's own modules have them.

    `env`, `raw_env` and `parallel_env` are `aec_env`, `MatrixWorldAEC` and `parallel_env` with the
    rules of the variant; they take the other arguments. So does `vector_env`, a
    `matrixworld.VectorEnv` of ``num_envs`` worlds.
    """

    __all__: list[str]
    env: Callable[..., AECWrapper]
    raw_env: Callable[..., MatrixWorldAEC]
    parallel_env: Callable[..., MatrixWorldParallel]
    vector_env: Callable[..., VectorEnv]

    def __init__(self, variant: str) -> None:
        name = f"pursuit_evasion_{variant.lower()}_v0"
        super().__init__(f"matrixworld.envs.{name}", docstring(variant, name))
        # `import` and `importlib.util.find_spec` ask modules for it; there is nothing to load.
        self.__spec__ = ModuleSpec(self.__name__, loader=None, origin=__name__)
        self.__package__ = "matrixworld.envs"
        self.__all__ = []
        self._add("env", aec_env, variant)
        self._add("raw_env", MatrixWorldAEC, variant)
        self._add("parallel_env", parallel_env, variant)
        self._add("vector_env", _vector_env, variant)

    def _add(self, name: str, make: Callable[..., Any], variant: str) -> None:
        def made(*args: Any, **settings: Any) -> Any:
            return make(variant, *args, **settings)

        # With these names pickle finds the function in another process.
        made.__module__, made.__name__, made.__qualname__ = self.__name__, name, name
        made.__doc__ = (make.__doc__ or "").partition("\n")[0]
        setattr(self, name, made)
        self.__all__.append(name)


def _vector_env(variant: str, num_envs: int = 1, **settings: Any) -> VectorEnv:
    """Make many worlds with Gymnasium's interface; see `matrixworld.VectorEnv`."""
    return VectorEnv(variant, num_envs, **settings)


def add_module(variant: str, package: str) -> VariantModule:
    """Make the module of a variant importable from `package`, and register its environments.

    ``pettingzoo.make`` and ``gymnasium.make_vec`` know them by the same id.
    """
    module = VariantModule(variant)
    name = module.__name__.rpartition(".")[2]
    sys.modules[module.__name__] = module
    setattr(sys.modules[package], name, module)
    register("aec", f"matrixworld/{name}", module.env)
    register("parallel", f"matrixworld/{name}", module.parallel_env)
    # A text, not the function: Gymnasium writes its specifications as JSON.
    gymnasium.register(f"matrixworld/{name}", vector_entry_point=f"{module.__name__}:vector_env")
    return module


def docstring(variant: str, name: str) -> str:
    """Return the docstring of the module `name` in Markdown: texts, facts and rules."""
    config = WorldConfig(variant)
    text = VARIANT_TEXTS.get(variant)
    if text is None:  # the tests say which text is missing; the games work without it
        prose = [f"# -{variant}"]
    else:
        paragraphs = (text.models, text.choose, f"To observe: {text.observe}")
        prose = [f"# -{variant}: {text.title}", *map(_filled, paragraphs)]
    return "\n\n".join([*prose, _table(_facts(name, config)), _rules(config.rules), _CLOSING, ""])


def _filled(paragraph: str) -> str:
    words = " ".join(paragraph.split())
    return textwrap.fill(words, COLUMNS, break_long_words=False, break_on_hyphens=False)


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
        "agents move": _MOVES[rules.interaction],
        "an agent that runs into an obstacle or the border": OUTCOME_TEXTS[rules.obstacle],
        "an agent that collides with a teammate": OUTCOME_TEXTS[rules.teammate],
        "an evader that collides with a pursuer": OUTCOME_TEXTS[rules.evader],
        "a pursuer that collides with an evader": OUTCOME_TEXTS[rules.pursuer],
        "an evader is captured when": _CAPTURES[rules.capture],
        "a captured evader": captured,
    }
    return _table(rows, head="rule")


def _table(rows: dict[str, str], head: str = "") -> str:
    """Return a Markdown table of two columns."""
    first = f"| {head} | |" if head else "| | |"
    return "\n".join([first, "|---|---|", *(f"| {key} | {value} |" for key, value in rows.items())])
