"""Games as users write them: exact, by chance, with teams that differ, and with what they show."""

import numpy as np
from scipy.special import expit

from matrixworld.coevolution import Game, RaceSettings


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


def told(a, b):
    return f"{a.sum():.4f} <b>against</b> {b.sum():.4f}"


def drawn(a, b):
    """Return a row of three pixels for each genome."""
    grey = (255 * expit(np.stack([a, b]))).astype(np.uint8)
    return np.repeat(grey[:, :, np.newaxis], 3, axis=2)


HOSTS = ("hosts", "parasites")
numbers = Game(higher, genes=5, teams=HOSTS, deterministic=True)
fewer = Game(higher, genes=3, teams=HOSTS, deterministic=True)
coins = Game(toss, genes=(3, 2), teams=("cats", "mice"), initial=middle, bounds=(-1, 1))
words = Game(toss, genes=3, teams=HOSTS, show=told)
pictures = Game(higher, genes=3, teams=HOSTS, deterministic=True, show=drawn)
silent = Game(toss, genes=3, teams=HOSTS)


def short_race(game, generations=3, schedule="hall-of-fame", **changes):
    """Return the settings of a race that takes a fraction of a second."""
    race = RaceSettings.of(game=game, schedule=schedule, learner="ga")
    epochs = ("joint",) if schedule == "hall-of-fame" else ("pursuer", "evader")
    tiny = {"learner.population": 6, **{f"schedule.{each}_epochs": 2 for each in epochs}}
    return race.changed({**tiny, "schedule.generations": generations, **changes})
