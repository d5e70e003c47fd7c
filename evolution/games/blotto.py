"""Colonel Blotto: two armies are distributed over battlefields, and the larger one wins a field.

A genome has the soldiers on each field. No distribution is best: one that leaves its largest field
to it, and has a soldier more on each other field, wins all but one.
"""

from matrixworld.coevolution import Game

FIELDS, SOLDIERS = 6, 60


def army(rng):
    """Return soldiers that chose their fields by themselves."""
    return rng.multinomial(SOLDIERS, rng.dirichlet([1.0] * FIELDS)).tolist()


def march(army, rng):
    """Send some soldiers from one field to another."""
    source, target = rng.choice(FIELDS, 2, replace=False)
    going = int(rng.integers(army[source] + 1))
    army[source] -= going
    army[target] += going
    return army


def play(red, blue):
    """Return the share of the fields that red wins; equal armies share one."""
    return sum((a > b) + 0.5 * (a == b) for a, b in zip(red, blue, strict=True)) / FIELDS


blotto = Game(play, teams=("red", "blue"), initial=army, mutate=march, deterministic=True)
