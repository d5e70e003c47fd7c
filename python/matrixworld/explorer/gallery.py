"""The examples of the playground: small scenes, each of which teaches one thing.

Scenes are drawn as text. Rows are separated by slashes and cells by spaces: ``.`` is free, ``#`` an
obstacle; ``A``, ``B``, ... are pursuers and ``a``, ``b``, ... evaders, in the order of their
numbers.
"""

from __future__ import annotations

import warnings
from dataclasses import dataclass

import numpy as np

from matrixworld.explorer.links import scene_link
from matrixworld.world.rules import Action, Rules
from matrixworld.world.world import World

ARROWS = {
    "^": Action.NORTH,
    ">": Action.EAST,
    "v": Action.SOUTH,
    "<": Action.WEST,
}


@dataclass(frozen=True)
class Example:
    """A scene of the gallery.

    Parameters
    ----------
    title : str
        A few words.
    text : str
        What it shows, and what to try.
    rules : str
        Name of the variant.
    drawing : str
        The board.
    moves : str
        What agents do next, such as ``"A> b^"``, or a script: ``"A=chaser"``. The others stay.
    compare : str, optional
        Name of a variant to compare with.
    """

    title: str
    text: str
    rules: str
    drawing: str
    moves: str
    compare: str | None = None

    @property
    def commands(self) -> list[int | str]:
        """What each agent does next."""
        letters = sorted(letter for letter in self.drawing if letter.isalpha())
        moves = {move[0]: move[1:] for move in self.moves.split()}
        return [_command(moves.get(letter, "")) for letter in letters]

    @property
    def scene(self) -> str:
        """The scene as it stands in a link."""
        world = drawn_world(self.rules, self.drawing)
        return scene_link(world, self.commands, compare=self.compare)


def _command(text: str) -> int | str:
    return text[1:] if text.startswith("=") else ARROWS.get(text, Action.STAY)


def drawn_world(rules: Rules | str, drawing: str) -> World:
    """Return the world of a drawing."""
    cells = [row.split() for row in drawing.split("/")]
    agents = {
        cell: (row, col)
        for row, line in enumerate(cells)
        for col, cell in enumerate(line)
        if cell.isalpha()
    }
    teams = [
        [agents[letter] for letter in sorted(agents) if letter.isupper() == upper]
        for upper in (True, False)
    ]
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # rules that capture no evader may be what a scene is about
        world = World(
            rules,
            n_pursuers=len(teams[0]),
            n_evaders=len(teams[1]),
            obstacles=np.array([[cell == "#" for cell in line] for line in cells]),
        )
    world.reset(0, pursuers=teams[0], evaders=teams[1])
    return world


GALLERY = (
    Example(
        "Two want one cell",
        "Two pursuers head for the same cell. Under -SB teammates bounce: both stay, and both "
        "are at fault. Press -S, and they share the cell; press -D, and both are lost.",
        "SB",
        ". . . . . / . A . B . / . . . . . / . . a . .",
        "A> B<",
    ),
    Example(
        "Share a cell?",
        "The same moves under two rules: -S lets teammates share a cell, -SB does not. They are "
        "at fault either way, so both boards pay the same penalty.",
        "S",
        "A . B . / . . . . / . C . a",
        "A> B< C^",
        compare="SB",
    ),
    Example(
        "Swap",
        "Two pursuers want to change places. That is a conflict on the edge between their "
        "cells: under -SB both bounce, under -S both pass.",
        "SB",
        ". . . . / . A B . / . . . a",
        "A> B<",
    ),
    Example(
        "Queue",
        "All move in one direction. A cell that its agent leaves is free for the next one, so "
        "there is no conflict.",
        "SB",
        ". . . . . . / A B C . . a / . . . . . .",
        "A> B> C>",
    ),
    Example(
        "Chain",
        "The first of a queue runs into an obstacle and bounces. The second cannot enter its "
        "cell, and so on to the last one.",
        "SB",
        ". . . . . . / A B C # . a / . . . . . .",
        "A> B> C>",
    ),
    Example(
        "Contact",
        "Under -O a pursuer captures an evader by reaching its cell. Here both head for the "
        "same one; contact of adversaries is the aim of the game, and nobody is at fault.",
        "O",
        ". . . . . / . A . a . / . . . . .",
        "A> a<",
        compare="R",
    ),
    Example(
        "Drones",
        "Under -D every contact destroys: the evader is captured, and its pursuer is lost with "
        "it. Another pursuer flies out of the board.",
        "D",
        ". . . B . / . A . a . / . . . . b",
        "A> a< B^",
    ),
    Example(
        "Surround",
        "Three pursuers stand around an evader and the fourth closes the ring. Under -SD the "
        "evader is removed, under -S it stays captured as long as the ring holds.",
        "SD",
        ". . A . . / . B a . C / . . D . . / b . . . .",
        "C<",
        compare="S",
    ),
    Example(
        "Walls help",
        "Obstacles and the border count as pursuers do: one pursuer is enough for an evader in "
        "a corner. Remove the obstacle (Build), and it is free.",
        "S",
        "a . A . / # . . . / . . . b",
        "A<",
    ),
    Example(
        "Bump",
        "Under -S an evader bounces off a pursuer, and so loses its move. Pursuers that enter "
        "its cell bounce as well: surround it instead.",
        "S",
        ". . . . . / . A a . . / . . B . .",
        "A> a<",
    ),
    Example(
        "Turns",
        "Under -TO agents move one after the other: the pursuer reaches the evader before it "
        "can leave. Under -O all move at once, and the evader escapes.",
        "TO",
        ". . . . . . / . A a . . . / . . . . . .",
        "A> a>",
        compare="O",
    ),
    Example(
        "Chase",
        "Scripts play: three hunters against two agents that flee. Press Run. Give an agent "
        "moves of your own at any time, or choose another script for it.",
        "O",
        "A . . . . . . . . / . . # # . . . . . / . . . # . . a . . / B . . . . . . . . / . . . "
        ". . # . . . / . . . . b # . . . / C . . . . . . . .",
        "A=hunter B=hunter C=hunter a=dodger b=fleer",
    ),
)
"""The examples, in the order of the page."""
