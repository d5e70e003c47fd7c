"""Malformed values of every parameter of public constructors: ValueError or TypeError, no files."""

import inspect
from collections.abc import Callable, Iterator
from enum import IntEnum
from fractions import Fraction
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import matrixworld as mw
from matrixworld import coevolution
from matrixworld.coevolution import opponents
from matrixworld.coevolution.sections import Section
from matrixworld.episodes import replay
from matrixworld.play.rollout import match_seed
from refusals import CONFIG, GENOME, NETWORK
from rows import random_walks
from tiny_race import tiny_race, tiny_single


class Seven(IntEnum):
    """An integer of another class."""

    VALUE = 7


MALFORMED = {
    "a huge integer": 10**400,
    "an integer that Python does not write": -(10**5000),
    "a huge fraction": Fraction(10**400),
    "nan": float("nan"),
    "infinity": float("inf"),
    "a NumPy infinity": np.float32("-inf"),
    "a complex number": 1j,
    "bytes": b"4",
    "an unhashable list": [[]],
    "a dict": {},
    "an array of objects": np.array([None, {}], object),
    "an object": object(),
    "a function": len,
    "text with a null": "\0",
    "a NumPy bool": np.True_,
}

TEAM = mw.Population(GENOME, NETWORK)
MATCH = mw.Matches.of(0, 0, 0)
EPISODE = random_walks(steps=3)
RNG = np.random.default_rng(0)
TABLE = coevolution.NoiseTable(4, RNG, sigma=1.0)
START = np.zeros(4, np.float32)
MONITOR = mw.SafetyMonitor()
MONITOR.add_episode(EPISODE)
SMALL = {"rows": 6, "cols": 6, "n_pursuers": 2, "n_evaders": 3}

GENETIC, GRADIENTS = coevolution.GeneticAlgorithmSettings(), coevolution.ActorCriticSettings()

SECTIONS = (*vars(tiny_race()).values(), tiny_single().schedule, GENETIC, GRADIENTS)
TEAMS = {"config": CONFIG, "pursuers": TEAM, "evaders": TEAM}
PICTURE = {"episode": EPISODE, "cell": 4, "trail": 2, "fov": 3}


def with_all(call: Callable[..., object]) -> partial[object]:
    """Return a call in which every parameter is tried; None stands for its default."""
    return partial(call, **dict.fromkeys(inspect.signature(call).parameters))


CALLS = [
    with_all(mw.Rules),
    with_all(mw.Rewards),
    partial(
        mw.WorldConfig, **SMALL, rules="O", fov=3, diagonal=False, max_steps=5, obstacles=0.1,
        rewards=None,
    ),
    partial(mw.World, config=CONFIG),
    partial(mw.World(CONFIG).reset, seed=1, episode=0, obstacles=None),
    partial(mw.Batch, n_worlds=2, config=CONFIG, threads=1, autoreset=None, buffers=None),
    partial(
        mw.VectorEnv, config=CONFIG, n_worlds=2, threads=1, copy=True, action_mask=False,
        autoreset_mode="NextStep", flatten=False, state=False, render_mode=None,
    ),
    partial(mw.parallel_env, config=CONFIG),
    partial(
        mw.Network, hidden=(4,), activation="relu", fov=3, n_actions=5, sampled=True, memory="gru"
    ),
    partial(mw.Population, genomes=GENOME, network=NETWORK),
    partial(mw.Matches.of, pursuer=0, evader=0, seed=0),
    partial(mw.rollout, **TEAMS, matches=MATCH, episodes=1, threads=1),
    partial(mw.record, **TEAMS, seed=0, pursuer=0, evader=0, episode=0),
    partial(match_seed, run_seed=0),
    partial(mw.Episode, **vars(EPISODE)),
    partial(MONITOR.summary, seed=0),
    partial(coevolution.RaceSettings, **vars(tiny_race())),
    *(partial(type(each), **vars(each)) for each in SECTIONS if isinstance(each, Section)),
    partial(coevolution.NoiseTable, rng=RNG, size=4, sigma=1.0),
    partial(
        coevolution.EvolutionStrategy, noise=TABLE, genome=START, samples=4, learning_rate=0.1,
        anneal_over=None, momentum=0.9, relative_sigma=0.1,
    ),
    partial(
        coevolution.GeneticAlgorithm, noise=TABLE, population=np.zeros((4, 4)), tournament=2,
        truncation=0.5, elites=1, crossover=0.0,
    ),
    partial(coevolution.CmaEs, genome=START, sigma=0.1, samples=4),
    *map(with_all, (opponents.Latest, opponents.Uniform, opponents.RoundRobin)),
    partial(opponents.HallOfFame, newest=1, sampled=1),
    partial(opponents.Prioritized, count=1, decay=0.5),
    partial(opponents.hard, power=2.0),
    partial(opponents.SharedSampling, count=1),
    partial(opponents.MaxSolve, size=3),
    partial(opponents.LAPCA, layers=3),
    partial(coevolution.start, settings=tiny_race(), directory="new", threads=1),
    partial(coevolution.tournament, **TEAMS, seed=0, episodes=1, threads=1),
    partial(
        coevolution.score_policy, policy=TEAM, team="pursuer", config=CONFIG, episodes=2,
        seed=0, threads=1,
    ),
    partial(replay.scene, episode=EPISODE, step=0, trail=2),
    partial(replay.save, **PICTURE, path="new.gif", fps=10.0, every=1, hold=1.0, step=-1),
    partial(replay.animation, **PICTURE, fps=10.0, every=1),
    partial(replay.contact_sheet, **PICTURE, rows=1, cols=1),
]  # fmt: skip
"""Calls with legal arguments; each is tried, but those that another object is made from."""
NOT_TRIED = ("rng", "noise", "archive")
ACCEPTED = {
    ("Batch", "buffers", "a dict"): "no arrays are written",
    ("Episode", "config", "a dict"): "no settings",
    ("Against", "opponent", "text with a null"): "read when the run starts",
    ("Against", "start", "text with a null"): "read when the run starts",
    ("ActorCriticSettings", "device", "text with a null"): "read when the run starts",
}
"""Values of the table that are legal, each with what they mean."""


ELSEWHERE = ("rollout(matches)", "start(directory)", "save(path)")
ELSEWHERE += ("EvolutionStrategy(genome)", "GeneticAlgorithm(population)", "CmaEs(genome)")
"""Parameters that Python or NumPy reads, and refuses in its own words."""
UNREADABLE = {"an integer that Python does not write", "an array of objects", "text with a null"}
"""Values that Python may refuse in its own words when it compares or writes them."""


def parameters() -> Iterator[Any]:
    for call in CALLS:
        for parameter in sorted(call.keywords.keys() - NOT_TRIED):
            name = call.func.__qualname__
            yield pytest.param(call, parameter, id=f"{name}({parameter})")


@pytest.mark.filterwarnings("ignore::UserWarning", "ignore::RuntimeWarning")
@pytest.mark.parametrize(("call", "parameter"), list(parameters()))
def test_a_malformed_value_is_a_value_or_type_error(
    call: partial[object], parameter: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    name = call.func.__qualname__
    # None: as if it were not given.
    others = {key: value for key, value in call.keywords.items() if value is not None}
    for what, wrong in MALFORMED.items():
        if (name, parameter, what) in ACCEPTED:
            continue
        with pytest.raises((TypeError, ValueError)) as caught:
            call.func(**{**others, parameter: wrong})
        if f"{name}({parameter})" not in ELSEWHERE and what not in UNREADABLE:
            assert "expected" in str(caught.value), what
        # `start` and `save` write files if they are not refused.
        assert list(tmp_path.iterdir()) == [], what


def test_numbers_of_other_classes_become_pythons_own() -> None:
    settings = tiny_race(
        rows=Seven.VALUE, cols=np.int16(6), sigma=np.float32(0.5), hidden=[Seven(7)]
    )
    assert type(settings.learner.sigma) is float
    assert type(settings.policy.hidden[0]) is int
    assert settings == tiny_race(rows=7, cols=6, sigma=0.5, hidden=(7,))
