"""Games that show their matches: in words, in a picture, and not at all."""

import numpy as np
from scipy.special import expit

from matrixworld.coevolution import Game, RaceSettings


def toss(a, b, rng):
    """Return 1 or 0, by a coin that favours the larger sum."""
    return rng.random(len(a)) < expit(a.sum(axis=1) - b.sum(axis=1))


def higher(a, b, rng):
    """Return the chance of this coin."""
    return expit(a.sum(axis=1) - b.sum(axis=1))


def told(a, b):
    return f"{a.sum():.4f} <b>against</b> {b.sum():.4f}"


def drawn(a, b):
    """Return a row of three pixels for each genome."""
    grey = (255 * expit(np.stack([a, b]))).astype(np.uint8)
    return np.repeat(grey[:, :, np.newaxis], 3, axis=2)


words = Game(toss, genes=3, teams=("hosts", "parasites"), show=told)
pictures = Game(higher, genes=3, teams=("hosts", "parasites"), deterministic=True, show=drawn)
silent = Game(toss, genes=3, teams=("hosts", "parasites"))


def short_race(
    game: Game, generations: int = 3, schedule: str = "hall-of-fame", **changes: object
) -> RaceSettings:
    """Return the settings of a race that takes a fraction of a second."""
    race = RaceSettings(game=game, schedule=schedule, learner="ga")
    epochs = ("joint",) if schedule == "hall-of-fame" else ("pursuer", "evader")
    tiny = {"learner.population": 6, **{f"schedule.{each}_epochs": 2 for each in epochs}}
    return race.changed({**tiny, "schedule.generations": generations, **changes})
