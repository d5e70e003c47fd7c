"""Red and blue: two populations of programs; red wants to move as blue does, and blue otherwise.

A genome is a text in postfix: "you 1 +" moves one more than the other did. No program is best: with
`me` and `you` exchanged it makes all its moves for the other team, and with "1 +" at the end none.
"""

from matrixworld.coevolution import Game

TURNS, LONGEST = 24, 20
SIGNS = {"+": lambda b, a: a + b, "*": lambda b, a: a * b, "<": lambda b, a: a < b}
WORDS = ["t", "me", "you", "1", "2", "3", *SIGNS]


def change(text, rng):
    """Return a program in which up to two words are new, and perhaps one is gone."""
    words, at = text.split(), rng.integers(LONGEST)
    words[at : at + rng.integers(2)] = rng.choice(WORDS, rng.integers(3))
    return " ".join(words[:LONGEST]) or "1"


def move(program, **seen):
    """Return a move, 0 to 2: the last number when signs have taken two each, from many zeros on."""
    stack = [0] * (LONGEST + 1)
    for word in program.split():
        value = SIGNS[word](stack.pop(), stack.pop()) if word in SIGNS else seen.get(word, word)
        stack.append(int(value))
    return stack[-1] % 3


def play(red, blue):
    """Return in which share of the turns both make the same move."""
    r = b = same = 0
    for t in range(TURNS):
        r, b = move(red, t=t, me=r, you=b), move(blue, t=t, me=b, you=r)
        same += r == b
    return same / TURNS


operators = {"initial": lambda rng: " ".join(rng.choice(WORDS, 5)), "mutate": change}
red_and_blue = Game(play, teams=("red", "blue"), **operators, deterministic=True)
