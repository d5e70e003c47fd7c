"""What each variant models, when to choose it, and what to observe in it.

These texts open the docstrings of the modules ``matrixworld.envs.pursuit_evasion_*_v0`` and the
pages in ``docs/variants``. `matrixworld.envs.variants` adds the tables of facts and rules.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType


@dataclass(frozen=True)
class VariantText:
    """The prose about one variant, in Markdown. Links lead to the pages of other variants.

    Parameters
    ----------
    title : str
        A few words.
    models : str
        What the game models.
    choose : str
        When to choose it, and how it differs from its neighbours.
    observe : str
        A fact that shows in its episodes.
    """

    title: str
    models: str
    choose: str
    observe: str


VARIANT_TEXTS: Mapping[str, VariantText] = MappingProxyType(
    {
        "D": VariantText(
            title="Drones: every contact destroys",
            models="""
                A swarm of drones or vehicles in the open. No agent survives a collision: an agent
                that flies into a wall, a teammate or an adversary is lost, and so is the agent
                that it hits. An evader counts as captured when a collision with a pursuer destroys
                it. That pursuer is destroyed too, so each success makes its team smaller.
            """,
            choose="""
                This is the only variant in which a mistake is final: no agent bounces off a wall.
                Choose it where safety means survival, and look at `survival_rate` and at the share
                of episodes without a collision. The same policy in [-R](r.md), where collisions
                remove no agent, shows what its mistakes cost here.
            """,
            observe="""
                Random walkers die out. Nine in ten are gone by the end of an episode, most of them
                through walls and teammates.
            """,
        ),
        "R": VariantText(
            title="Targets to be reached, cells to be shared",
            models="""
                Agents that may share a cell, as in multi-agent path finding with common goals and
                in the predator-prey task of the multi-agent particle environments. Evaders are
                targets, and reaching one is what counts. No agent disappears: a target that was
                reached stays on the grid and moves on.
            """,
            choose="""
                This is the gentlest variant: only obstacles make an agent bounce. Choose it for
                coverage, search and assignment of targets, or as a baseline without safety
                constraints. [-B](b.md) is the same game without collisions among teammates; in
                [-O](o.md) an evader that was reached disappears.
            """,
            observe="""
                `capture_rate` counts every evader that was reached at some time. The episode ends
                when all of them have been.
            """,
        ),
        "B": VariantText(
            title="Path finding: teammates must not collide",
            models="""
                Multi-agent path finding: two teammates may neither enter the same cell nor swap
                their cells. Agents that would do so stay where they are, and so does the queue
                behind them. Evaders are the places to go to; pursuers and evaders do not stop each
                other.
            """,
            choose="""
                Choose it to study congestion, priorities and deadlocks in one team while the other
                merely moves about. It is [-R](r.md) without the vertex and edge conflicts of path
                finding among teammates. Adversaries do not block the way here; in [-SB](sb.md) they
                do.
            """,
            observe="""
                Two teammates head to head in a corridor wait for each other for ever, and both are
                at fault.
            """,
        ),
        "O": VariantText(
            title="Predators and prey: reached is caught",
            models="""
                Predators hunt prey that is weaker than they are: on contact the prey disappears and
                the predator does not. Teammates may share a cell, and walls stop every agent. The
                game also models a search for targets scattered in space.
            """,
            choose="""
                This is the standard game of the paper and the default of this package: captures are
                fast, evaders are many, and an arms race can be measured within minutes. Choose it
                for co-evolution and for first experiments. [-TO](to.md) is the same game by turns;
                in [-D](d.md) the pursuers die on contact as well.
            """,
            observe="""
                A fleeing evader is as fast as its pursuer. A single pursuer seldom catches it in
                the open, but often at the border.
            """,
        ),
        "S": VariantText(
            title="Surround it: the pursuit of Benda",
            models="""
                The classical pursuit problem of Benda, Jagannathan and Dodhiawala (1986) in the
                form of Sun et al. (2023). Prey is captured when it cannot move: each of its four
                sides has a pursuer, an obstacle or the border. This takes four pursuers in the
                open, three at the border and two in a corner.
            """,
            choose="""
                Pursuers may share a cell, so they do not block each other. They cannot enter the
                cell of the prey: an agent that tries bounces back. A capture lasts only as long as
                the ring is closed; when it opens, the evader is free again. Choose it to study
                cooperation. [-SB](sb.md) forbids collisions of teammates, [-SD](sd.md) removes
                captured evaders.
            """,
            observe="""
                `capture_rate` can fall again: it counts the evaders that are surrounded at this
                moment. `ever_capture_rate` counts those that were surrounded at some time.
            """,
        ),
        "SB": VariantText(
            title="Surround it, without collisions",
            models="""
                Predators as solid bodies. Prey is captured by being surrounded, as in [-S](s.md),
                and no two agents may share a cell: teammates that would collide bounce back, and so
                do a pursuer and an evader.
            """,
            choose="""
                This is the strictest game of coordination: agents that block each other on the way
                have to close the ring. Choose it to study safe cooperation: after a step no two
                living agents share a cell and none have swapped cells. In [-SDB](sdb.md) a captured
                evader makes room.
            """,
            observe="""
                When several agents follow an agent that has to stay, all of them bounce. Such a
                chain is spelled out by a step with `explain=True`.
            """,
        ),
        "SD": VariantText(
            title="Surround and remove",
            models="""
                Hunting in a pack: prey that is surrounded is removed from the grid, and the pack
                goes on to the next. As in [-S](s.md) teammates may share a cell, and the cell of
                the prey cannot be entered.
            """,
            choose="""
                A capture is final: success is counted once, and the pursuers are free for more.
                Choose it where the pursuers' work should end the episode. This is the only
                difference from [-S](s.md); [-SDB](sdb.md) forbids collisions of teammates as well.
            """,
            observe="""
                Captures are judged all at once. Two evaders side by side do not count as walls for
                each other.
            """,
        ),
        "SDB": VariantText(
            title="Surround and remove, without collisions",
            models="""
                A pack of solid bodies. As in [-SB](sb.md) no two agents may share a cell; as in
                [-SD](sd.md) a surrounded evader is removed and its cell becomes free.
            """,
            choose="""
                It combines all the constraints: cooperation to surround, safety on the way, and a
                population of evaders that shrinks. Choose it where all of these matter.
            """,
            observe="""
                After a capture the captors stand around an empty cell. Those that enter it together
                bounce.
            """,
        ),
        "TO": VariantText(
            title="Cops and robbers: one after the other",
            models="""
                Agents take turns: pursuers by number, then evaders by number, each on the board
                that the others have left. This is the game of cops and robbers, or vertex pursuit,
                on a grid (Quilliot 1978; Nowakowski and Winkler 1983; Bonato and Nowakowski 2011),
                and the interaction of PettingZoo's pursuit. Contact is as in [-O](o.md): the evader
                disappears.
            """,
            choose="""
                No two agents move at the same time, so no two can swap cells, and an agent sees
                what earlier agents did. Choose it for games on graphs, and to see what simultaneous
                moves change. The AEC environment is its natural form; the parallel one plays a
                round with actions that were all chosen before it.
            """,
            observe="""
                The scripts chaser and fleer make more captures here than in [-O](o.md). In its own
                turn a chaser reaches the cell that its prey is on; when all move at once it reaches
                the cell that its prey has just left.
            """,
        ),
    }
)
"""The texts by the names of `matrixworld.VARIANTS`."""
