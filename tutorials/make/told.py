"""What the texts of the course tell: numbers that no notebook prints and no kept race holds.

    python tutorials/make/told.py      3 minutes of one core

Writes ``tutorials/course/data/told.npz``; `SOURCES` say what it holds, an array (seeds,) for each
name. ``claims.toml`` beside it says how digits of texts follow from kept numbers, some of them by
functions of this module.
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike
from races import DATA
from tqdm import tqdm

import matrixworld as mw
from matrixworld import analysis
from matrixworld._util.files import load_toml, save_arrays
from matrixworld.solver import States, best_response, expected_payoff

ROOT = Path(__file__).parents[2]
sys.path.append(str(ROOT / "tutorials"))  # where the folder `course` lies

from course import chapter_3, chapter_8, toys
from course.chapter_10 import agreement

Row = dict[str, Any]
Numbers = Mapping[str, Any]
SHOWN = np.arange(0, 601, 20)
"""Generations of the numbers games that notebook 4 scores."""


# ---- Numbers of one seed -------------------------------------------------------------------------


def best_of_many(seed: int) -> Row:
    """Return the best score of 3000 random genomes in four matches, and their mean (notebook 3)."""
    rng = np.random.default_rng(seed)
    drawn = [chapter_3.NETWORK.initial(rng, weight=0.2, head=0.5) for _ in range(3000)]
    who, luck = np.repeat(range(3000), 4), np.tile(range(4), 3000)
    team = mw.Population(np.stack(drawn), chapter_3.NETWORK)
    played = mw.rollout(chapter_3.WORLD, team, "random", mw.Matches.of(who, 0, luck))
    scores = played.captured_fraction.reshape(3000, 4).mean(axis=1)
    return {"best": scores.max(), "mean": scores.mean()}


def tournament(seed: int) -> Row:
    """Return the ones gained by the choice of a master tournament (notebook 4)."""
    race = toys.numbers_game("intransitive", seed)
    scores = race.scores(SHOWN, 25, np.random.default_rng(1)).mean(axis=2).mean(axis=1)
    ones = race.objective[SHOWN, 0].mean(axis=1)
    return {"gain": ones[scores.argmax()] - ones[-1]}


def last_generation(seed: int) -> Row:
    """Return held-out score and ones of the last generation of a race (notebook 4)."""
    race = toys.numbers_game("intransitive", seed)
    outside = np.random.default_rng(0).integers(0, 51, size=(200, 2))
    own = race.ones[-1, 0]
    pairs = np.repeat(own, 200, axis=0), np.tile(outside, (len(own), 1))
    return {
        "score": toys.beats(toys.GAMES["intransitive"], *pairs).mean(),
        "ones": race.final_objective[0],
    }


def nim(seed: int) -> Row:
    """Return what the last first player of Nim scores in its race, and outside (notebook 4)."""
    first, second = toys.race_of_nim(seed)
    rivals = {"inside": second, "outside": toys.perfect_players(100)}
    return {
        name: toys.all_against_all(toys.NIM, first[-1:], each).mean()
        for name, each in rivals.items()
    }


def programs(seed: int) -> Row:
    """Return lengths and scores of evolved and of random programs (notebook 8)."""
    new = range(10**6, 10**6 + 400)

    def again(program: np.ndarray) -> float:
        return float(chapter_8.score(program[None], new)[0])

    def retested(drawn: np.ndarray, scores: np.ndarray) -> np.ndarray:
        ten = drawn[np.argsort(scores)[-10:]]
        best: np.ndarray = ten[chapter_8.score(ten, range(150)).argmax()]
        return best

    _, _, history = chapter_8.evolve(seed)
    last, scores = history[-1]
    rng = np.random.default_rng(seed)
    drawn = np.stack([chapter_8.PROGRAM.initial(rng) for _ in range(1500)])
    return {
        "tokens": chapter_8.lengths(history)[-1],
        "four matches": scores.max(),
        "new matches": again(last[scores.argmax()]),
        "retested": again(retested(last, scores)),
        "random": again(retested(drawn, chapter_8.score(drawn, range(4)))),
    }


def chasers(_: int) -> Row:
    """Return what chasers capture of fleers, and of the best evader (notebook 10)."""
    small = load_toml(ROOT / "evolution" / "small_world.toml")["world"]
    names = ("rows", "cols", "n_pursuers", "n_evaders", "max_steps")
    states = States(mw.WorldConfig("TO", **{name: small[name] for name in names}))
    return {
        "of fleers": expected_payoff(states, "chaser", "fleer"),
        "of the best": best_response(states, "chaser", "pursuer").value,
    }


SOURCES: dict[str, tuple[Callable[[int], Row], range]] = {
    "best of many": (best_of_many, range(10)),
    "tournament": (tournament, range(20, 200)),
    "last generation": (last_generation, range(10)),
    "nim": (nim, range(100, 120)),
    "programs": (programs, range(20)),
    "chasers": (chasers, range(1)),
}


# ---- From kept numbers to digits -----------------------------------------------------------------


def difference(one: ArrayLike, other: ArrayLike) -> list[float | None]:
    """Return the mean of one minus another over seeds, and the ends of its 95 % interval."""
    found = analysis.difference_of_runs(one, other)
    return [found.value, found.low, found.high]


def lost_in_five(paper_races: Numbers) -> list[float]:
    """Return what specialists capture at lag 1 minus lag 5, of each race (notebook 5)."""
    rates = (paper_races["specialist_specialist"] / int(paper_races["evaders"])).mean(axis=3)
    profiles = [analysis.lag_profile(each) for each in rates]
    at = [dict(zip(each.lags.tolist(), each.means.tolist(), strict=True)) for each in profiles]
    return [means[1] - means[5] for means in at]


def escapes_of_others(cures: Numbers, *kinds: str) -> list[np.ndarray]:
    """Return how often last evaders of kinds escape from pursuers of other kinds (notebook 6)."""
    captured = cures["cross_play"] / int(cures["cross_evaders"])
    places = map(cures["samplers"].tolist().index, kinds)
    return [1 - np.delete(captured[:, :, k], k, axis=0).mean(axis=(0, 1)) for k in places]


def order(races: Numbers, team: str, measure: str, *, first: int = 0) -> list[float]:
    """Return rank correlations with the truth over generations from `first` on (notebook 10)."""
    late = {name: each[:, :, first:] for name, each in races.items() if each.ndim == 3}
    return agreement(late, team, measure)


def main() -> None:
    arrays = {}
    for name, (numbers, seeds) in SOURCES.items():
        rows = [numbers(seed) for seed in tqdm(seeds, desc=name)]
        arrays |= {f"{name}: {key}": np.array([row[key] for row in rows]) for key in rows[0]}
    save_arrays(DATA / "told.npz", arrays)


if __name__ == "__main__":
    main()
