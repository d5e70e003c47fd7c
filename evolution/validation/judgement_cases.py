"""Races for the benchmark of the judgement: what it gets to see, and what is true of it."""

from __future__ import annotations

import zlib
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import NamedTuple

import numpy as np

from common import SAME_STEPS, SMALL_RACE
from judgement_races import (
    HARD,
    KINDS,
    LIMITS,
    OUTLIERS,
    Draws,
    SyntheticRace,
    play_episodes,
    synthetic_races,
)
from judgement_toys import RACES
from judgement_truths import WINDOWS, Truth, Truths, change_of_strength, truths_of_group
from matrixworld.analysis import CONDITIONS
from matrixworld.coevolution import RaceSettings, evolve

SIZES = (8, 15, 31, 60)
RUNS = (1, 1, 1, 2, 3, 5, 10)
"""Three of seven races are single runs."""
OF_GROUPS = ("shared trend", *(kind for kind in HARD if kind.startswith("one lucky run")))
"""Kinds of groups alone."""
EFFECTS = (0.25, 0.5, 1.0, 2.0)


class Noise(NamedTuple):
    """How matches of known capture rates turn out; see `judgement_races.play_episodes`."""

    episodes: int
    evaders: int = 1
    matchups: float = 0.0


NOISES: Mapping[str, Noise] = {
    **{f"win or loss, {n}": Noise(n) for n in (1, 2, 4, 10, 50, 200)},
    **{f"30 evaders, {n}": Noise(n, evaders=30) for n in (2, 10, 50)},
    "win or loss, 10, matchups": Noise(10, matchups=0.02),
    "30 evaders, 10, matchups": Noise(10, evaders=30, matchups=0.02),
}
"""Noises by name, with the episodes of each pair."""
POWER_NOISES = (
    "win or loss, 2", "win or loss, 10", "win or loss, 50", "win or loss, 200",
    "30 evaders, 2", "30 evaders, 10",
)  # fmt: skip
PER_EPISODE, NUMBER, UNKNOWN = "each episode", "number of episodes", "unknown"
MOST_VALUES = 2_000_000
"""Above that, single episodes are not handed over, but their means and their number."""

FROZEN, SHUFFLED = "learners that cannot learn", "opponents in random order"
REAL = RaceSettings.of({
    **SMALL_RACE, **SAME_STEPS, "schedule.generations": 14, "schedule.pursuer_epochs": 4,
    "schedule.evader_epochs": 4,
})  # fmt: skip
NO_LEARNING = REAL.changed({
    "schedule.pursuer_epochs": 1, "schedule.evader_epochs": 1, "learner.population": 2,
    "learner.sigma": 1e-6, "learner.learning_rate": 1e-9,
})  # fmt: skip


@dataclass(frozen=True)
class Case:
    """Matches that a judgement gets to see, and what is true of them."""

    scores: np.ndarray
    """Capture rates, shape (n, n), (runs, n, n), or with a last axis of episodes."""
    per_episode: bool
    """Whether the last axis holds episodes."""
    episodes: int | None
    """Episodes behind each mean, if they are told."""
    truths: dict[str, Truths]
    """By window and condition."""
    setting: dict[str, str]
    """How the race was played, for tables."""
    changes: dict[str, list[float | None]]
    """By window, the true change of the strength of both teams; None where it is open."""


# ---- Sources -------------------------------------------------------------------------------------


def synthetic_case(kind: str, seed: int) -> Case:
    """Return a synthetic race; the seed draws how it is played, too."""
    # Another key than that of the race's parameters; a checksum, as hash() differs between runs.
    rng = np.random.default_rng([seed, 2, zlib.crc32(kind.encode())])
    noise, n, runs = str(rng.choice(list(NOISES))), int(rng.choice(SIZES)), int(rng.choice(RUNS))
    if kind in OF_GROUPS:
        runs = int(rng.choice(RUNS[3:]))
    known, effect = str(rng.choice((PER_EPISODE, NUMBER, UNKNOWN))), float(rng.choice(EFFECTS))
    races = synthetic_races(kind, n, seed, effect=effect, runs=runs)
    return _play(races, noise, known, rng, {"effect": f"{effect:g}"})


def power_case(kind: str, seed: int) -> Case:
    """Return a single synthetic race of 31 generations with all its episodes, for power curves.

    Noises take turns, and the effect size is drawn log-uniformly.
    """
    rng = np.random.default_rng([seed, 4, zlib.crc32(kind.encode())])
    effect = float(np.exp(rng.uniform(np.log(LEAST_EFFECT), np.log(MOST_EFFECT))))
    race = KINDS[kind].make(31, effect, Draws(seed))
    return _play([race], POWER_NOISES[seed % len(POWER_NOISES)], PER_EPISODE, rng, {})


def _play(
    races: list[SyntheticRace],
    noise_name: str,
    known: str,
    rng: np.random.Generator,
    setting: dict[str, str],
) -> Case:
    noise, n, runs = NOISES[noise_name], len(races[0].rates), len(races)
    if known == PER_EPISODE and runs * n * n * noise.episodes > MOST_VALUES:
        known = NUMBER
    # Each run at once becomes means, unless its episodes are to be shown.
    show = np.asarray if known == PER_EPISODE else _means
    played = np.stack([show(_play_one(race, noise, rng)) for race in races])
    return Case(
        played[0] if runs == 1 else played,
        known == PER_EPISODE,
        noise.episodes if known == NUMBER else None,
        {window: truths_of_group(races, window) for window in WINDOWS},
        {"noise": noise_name, "generations": str(n), "episodes known": known, "runs": str(runs)}
        | setting,
        {window: _true_changes(races, window) for window in WINDOWS},
    )


def _play_one(race: SyntheticRace, noise: Noise, rng: np.random.Generator) -> np.ndarray:
    return play_episodes(
        race.rates, noise.episodes, rng, evaders=noise.evaders, matchups=noise.matchups
    )


def _means(scores: np.ndarray) -> np.ndarray:
    return np.asarray(scores.mean(axis=-1))


def _true_changes(races: list[SyntheticRace], window: str) -> list[float | None]:
    # The change that a group estimates is that of all possible runs, which is not known.
    return list(change_of_strength(races[0].rates, window)) if len(races) == 1 else [None, None]


def toy_case(kind: str, seed: int) -> Case:
    """Return a race in a toy game, with its episodes."""
    race = RACES[kind](seed)
    return Case(race.scores, True, None, dict(race.truths), {}, {})


def real_case(kind: str, seed: int) -> Case:
    """Return a small real race, with its episodes."""
    settings = NO_LEARNING if kind == FROZEN else REAL
    with TemporaryDirectory() as place:
        scores = evolve(replace(settings, seed=seed), Path(place) / "race").payoff().scores
    still = np.zeros(len(scores))
    if kind == FROZEN:
        # All generations are the same, so one rate holds for all pairs.
        race = SyntheticRace(np.full(scores.shape[:2], scores.mean()), still, still)
        found = {window: truths_of_group([race], window) for window in WINDOWS}
    else:
        scores = scores[:, np.random.default_rng([seed, 3]).permutation(len(scores))]
        found = {window: _only_no_arms_race() for window in WINDOWS}
    return Case(scores, True, None, found, {}, {})


def _only_no_arms_race() -> Truths:
    """Return what is known when the evaders are in random order: they gain nothing in time."""
    found = {condition: Truth(None, 0.0) for condition in CONDITIONS}
    return found | {"arms race": Truth(False, 0.0)}


POWER = "pure race"
"""The kind of the power curves."""
LEAST_EFFECT, MOST_EFFECT = 0.01, 2.0  # drawn log-uniformly for power curves


class Source(NamedTuple):
    """Where races come from."""

    case: Callable[[str, int], Case]
    """Kind and seed -> `Case`."""
    kinds: tuple[str, ...]
    share: float
    """Seeds of each kind, in units of ``--seeds``."""


SOURCES = {
    "hard": Source(synthetic_case, tuple(HARD), 3.0),
    "outliers": Source(synthetic_case, tuple(OUTLIERS), 3.0),
    "limits": Source(synthetic_case, tuple(LIMITS), 3.0),
    "synthetic": Source(synthetic_case, tuple(KINDS), 1.0),
    "power": Source(power_case, (POWER,), 45.0),
    "toy game": Source(toy_case, tuple(RACES), 0.25),
    "real race": Source(real_case, (FROZEN, SHUFFLED), 0.1),
}
