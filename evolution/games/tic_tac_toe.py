"""Tic-tac-toe on the board of PettingZoo: nobody wins against perfect play.

A genome has weights of the own and the other marks for each square; the free one of the largest sum
is taken. Crosses begin; a draw is a score of 1/2.
"""

import numpy as np
from pettingzoo.classic.tictactoe.board import Board

from matrixworld.coevolution import Game

SQUARES, ROWS = 9, Board().winning_combinations


def match(a, b):
    """Return the score of a, and the board at the end."""
    board = Board()
    for mover in [0, 1] * 4 + [0]:
        marks = np.array(board.squares)
        seen = np.append([marks == 1 + mover, marks == 2 - mover], True)
        sums = (a, b)[mover].reshape(SQUARES, -1) @ seen
        board.play_turn(mover, int(np.argmax(np.where(marks == 0, sums, -np.inf))))
        if any({board.squares[i] for i in row} == {1 + mover} for row in ROWS):
            return 1.0 - mover, board
    return 0.5, board


def play(a, b, rng):
    """Return the scores of a."""
    return [match(*pair)[0] for pair in zip(a, b, strict=True)]


def show(a, b):
    """Return the board at the end."""
    marks = np.array([*".XO"])[match(a, b)[1].squares].reshape(3, 3)
    return "\n".join("".join(row) for row in marks.T)


TEAMS, GENES = ("crosses", "noughts"), SQUARES * (2 * SQUARES + 1)
tic_tac_toe = Game(play, GENES, teams=TEAMS, deterministic=True, show=show)
