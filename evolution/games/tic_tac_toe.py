"""Tic-tac-toe on the board of PettingZoo; nobody wins against perfect play.

A genome is a linear policy: the value of each square is a weighted sum of the own and the other
marks, and the free square of the highest value is taken. A draw has a score of 1/2.
"""

from __future__ import annotations

import numpy as np
from pettingzoo.classic.tictactoe.board import Board

from matrixworld.coevolution import Game
from matrixworld.coevolution.types import FloatArray, Genome, Genomes, Rng

SQUARES = 9
GENES = SQUARES * (2 * SQUARES + 1)


def move(genome: Genome, board: Board, player: int) -> int:
    """Return the square that a player, 0 or 1, takes."""
    marks = np.array(board.squares)
    seen = np.concatenate([marks == 1 + player, marks == 2 - player, [True]])
    values = genome.reshape(SQUARES, -1) @ seen
    return int(np.argmax(np.where(marks == 0, values, -np.inf)))


def won(board: Board, player: int) -> bool:
    """Return whether a player has three in a row."""
    return any({board.squares[i] for i in row} == {1 + player} for row in board.winning_combinations)


def match(a: Genome, b: Genome) -> tuple[float, Board]:
    """Return the score of a, which begins, and the board at the end."""
    board = Board()
    for turn in range(SQUARES):
        player = turn % 2
        board.play_turn(player, move((a, b)[player], board, player))
        if won(board, player):
            return 1.0 - player, board
    return 0.5, board


def play(a: Genomes, b: Genomes, rng: Rng) -> FloatArray:
    """Return the scores of a."""
    return np.array([match(*pair)[0] for pair in zip(a, b, strict=True)])


def show(a: Genome, b: Genome) -> str:
    """Return the board at the end."""
    marks = np.array([*".XO"])[match(a, b)[1].squares].reshape(3, 3)
    return "\n".join("".join(row) for row in marks.T)


tic_tac_toe = Game(play, GENES, teams=("crosses", "noughts"), deterministic=True, show=show)
