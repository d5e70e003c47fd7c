"""Sorting networks, lists of pairs of wires, against cases to sort (Hillis 1990, Physica D 42).

A pair puts the larger value on its second wire. Cases are an integer for each wire, whose bits are
the values that the cases have there: so they are compared all at once.
"""

from matrixworld.coevolution import Game

WIRES, CASES = 16, 32


def comparators(rng, count=4 * WIRES):
    """Return new comparators, which are pairs of wires."""
    return [sorted(rng.choice(WIRES, 2, replace=False).tolist()) for _ in range(count)]


def change(network, rng):
    """Take out a comparator, put in one, or both."""
    at = rng.integers(len(network) + 1)
    network[at : at + rng.integers(2)] = comparators(rng, rng.integers(2))
    return network


def play(network, cases):
    """Return the share of the cases that are sorted, less a thousandth for each comparator."""
    wires, wrong = cases[:], 0
    for i, j in network:
        wires[i], wires[j] = wires[i] & wires[j], wires[i] | wires[j]
    for n in range(WIRES - 1):
        wrong |= wires[n] & ~wires[n + 1]
    return max(0.0, 1 - wrong.bit_count() / CASES - len(network) / 1000)


functions = {
    "initial": (comparators, lambda rng: rng.integers(2**CASES, size=WIRES).tolist()),
    "mutate": (change, lambda cases, rng: [bits ^ 2 ** int(rng.integers(CASES)) for bits in cases]),
    "mate": (lambda one, other, rng: one[: len(one) // 2] + other[len(other) // 2 :], None),
    "show": lambda network, cases: f"{len(network)} comparators: {play(network, cases):.3f}",
}
sorting_networks = Game(play, teams=("networks", "cases"), **functions, deterministic=True)
