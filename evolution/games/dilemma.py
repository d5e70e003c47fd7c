"""The iterated prisoner's dilemma (Axelrod 1984): one population, whose members all want the most.

A genome is a text of five moves, C or D: the first one, and those after CC, CD, DC and DD, of which
the own move comes first. A move in fifty is a mistake. Both prisoners gain by defection against
whoever they meet, and both lose if all defect: what one wins is not what the other loses.
"""

from matrixworld.coevolution import Game

YEARS = {"CC": (3, 3), "CD": (0, 5), "DC": (5, 0), "DD": (1, 1)}  # of freedom, a round
SEEN = [*YEARS]
ROUNDS, MISTAKES = 30, 0.02


def strategy(rng):
    """Return five moves."""
    return "".join(rng.choice([*"CD"], 5))


def flip(moves, rng):
    """Change one move."""
    at = rng.integers(5)
    return moves[:at] + "CD"[moves[at] == "C"] + moves[at + 1 :]


def play(one, other, rng):
    """Return the mean freedom of both prisoners, as shares of the most."""
    moves, sums = [one[0], other[0]], [0, 0]
    for mistakes in (rng.random((ROUNDS, 2)) < MISTAKES).tolist():
        a, b = (
            "CD"[move == "C"] if wrong else move
            for move, wrong in zip(moves, mistakes, strict=True)
        )
        sums = [total + years for total, years in zip(sums, YEARS[a + b], strict=True)]
        moves = [one[1 + SEEN.index(a + b)], other[1 + SEEN.index(b + a)]]
    return sums[0] / (5 * ROUNDS), sums[1] / (5 * ROUNDS)


kind = {"symmetric": True, "scores": "both"}
dilemma = Game(play, teams=("prisoners",), initial=strategy, mutate=flip, **kind)
