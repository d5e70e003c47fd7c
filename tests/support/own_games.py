"""Games as users write them: exact, by chance, and with teams that differ."""

from scipy.special import expit

from matrixworld.coevolution import Game


def higher(a, b, rng):
    """Return the scores of those whose numbers sum up to more."""
    return expit(a.sum(axis=1) - b.sum(axis=1))


def toss(a, b, rng):
    """Return 1 or 0, by a coin that favours the larger mean."""
    return rng.random(len(a)) < chance(a, b)


def chance(a, b):
    return expit(4 * (a.mean(axis=1) - b.mean(axis=1)))


def middle(rng, team):
    return rng.uniform(-0.1, 0.1, {"cats": 3, "mice": 2}[team])


numbers = Game(higher, genes=5, teams=("hosts", "parasites"), deterministic=True)
fewer = Game(higher, genes=3, teams=("hosts", "parasites"), deterministic=True)
coins = Game(toss, genes=(3, 2), teams=("cats", "mice"), initial=middle, bounds=(-1, 1))
