"""Kinds of players, and the calls that take them: each pair is tried.

``python tests/support/doors.py`` prints the table of ``docs/players.md``.
"""

from __future__ import annotations

import sys
import tempfile
import warnings
from collections.abc import Callable
from functools import cache
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import numpy as np

import matrixworld as mw
from matrixworld.coevolution import RaceSettings, create, finish, tournament
from matrixworld.play import capture_rates, save_genome
from matrixworld.solver import States, best_response, expected_payoff, solve, table

CONFIG = mw.WorldConfig("O", rows=3, cols=3, n_pursuers=2, n_evaders=1, max_steps=3, fov=11)
LARGE = mw.WorldConfig("O", rows=9, cols=9, n_pursuers=3, n_evaders=3, max_steps=3, fov=11)
PROGRAM = "def evade(view, rng):\n    return rng.integers(5)\n"
MATCHES = mw.Matches.of(0, 0, range(2))
RACE = {
    "schedule": "against", "schedule.team": "pursuer", "schedule.epochs": 1,
    "schedule.archive_every": 1, "learner.population": 2, "train_steps": 3,
    "match_episodes": 1, "evaluation_episodes": 2, "world.rules": "O", "world.rows": 3,
    "world.cols": 3, "world.n_pursuers": 2, "world.n_evaders": 1, "world.max_steps": 3,
    "training_worlds": (),
}  # fmt: skip


def _genome(**shape: Any) -> mw.Population:
    network = mw.Network((3,), fov=11, **shape)
    return mw.Population(network.initial(np.random.default_rng(0)), network)


def _choose(x, allowed, rng):
    return int(np.flatnonzero(allowed)[np.argmax(x["adversary"][allowed])])


def _module() -> Any:
    import torch

    return torch.nn.Sequential(torch.nn.Flatten(), torch.nn.Linear(363, 5))


def _rating(**shape: Any) -> mw.RatingPolicy:
    rating = mw.Rating(inputs=("adversary", "must_yield"), **shape)
    return mw.RatingPolicy(rating, np.float32([1, -9]))


@cache
def _folder() -> Path:
    """Return a folder with files of players and a run."""
    path = Path(tempfile.mkdtemp())
    (path / "anna.py").write_text(PROGRAM)
    (path / "anna.txt").write_text("adversary\n")
    save_genome(
        path / "anna.npz", "evader", mw.RatingPolicy(mw.Rating(("adversary",)), np.ones(1, "f4"))
    )
    settings = RaceSettings.of({**RACE, "schedule.team": "evader", "policy": "cells"})
    create(settings, path / "run")
    finish(path / "run")
    return path


KINDS: dict[str, Callable[[], Any]] = {
    '`"fleer"`': lambda: "fleer",
    '`"careful-fleer"`': lambda: "careful-fleer",
    '`"adversary - must_yield"`': lambda: "adversary - must_yield",
    "`Population`": _genome,
    "`NetworkPolicy`": lambda: mw.NetworkPolicy(_genome().policy, _genome().genomes[0]),
    "... with memory": lambda: _genome(memory="gru"),
    "`RatingPolicy`": _rating,
    '`"anna.py"`': lambda: str(_folder() / "anna.py"),
    '`"anna.npz"`': lambda: str(_folder() / "anna.npz"),
    '`"anna.txt"`': lambda: str(_folder() / "anna.txt"),
    "run directory": lambda: str(_folder() / "run"),
    '`"solved"`': lambda: "solved",
    "`Solution`": lambda: solve(CONFIG),
    "`Solution.policy`": lambda: solve(CONFIG).policy("evader"),
    "`Table`": lambda: table(States(CONFIG), "fleer", "evader"),
    "`f(views)`": lambda: lambda views: np.ones(len(views), int),
    "`f(view)`": lambda: lambda view: [0.5, 0.5, 0.0, 0.0, 0.0],
    "`f(view, rng)`": lambda: lambda view, rng: rng.integers(5),
    "`f(view, rng, memory)`": lambda: lambda view, rng, memory: len(memory),
    "`choose(x, allowed, rng)`": lambda: _choose,
    "torch module": _module,
}
"""By what the table calls it: what makes a player of evaders."""


def _raced(player: Any) -> None:
    with tempfile.TemporaryDirectory() as folder:
        given = {"schedule.opponent": player} if isinstance(player, str) else {}
        settings = RaceSettings.of(RACE | given)
        path = Path(folder) / "run"
        create(settings, path, opponents=None if given else player)
        finish(path)
        mw.open_run(path).record(0, 0)


def _environments(player: Any) -> None:
    env = mw.parallel_env(CONFIG, evaders=player)
    env.reset(seed=0)
    env.step(dict.fromkeys(env.agents, 1))
    vector = mw.VectorEnv(CONFIG, n_worlds=2, evaders=player)
    vector.reset(seed=0)
    vector.step(np.ones((2, 2), int))


DOORS: dict[str, Callable[[Any], Any]] = {
    "`rollout`": lambda player: mw.rollout(CONFIG, "chaser", player, MATCHES),
    "`record`": lambda player: mw.record(CONFIG, "chaser", player),
    "`capture_rates`": lambda player: capture_rates(CONFIG, "chaser", player, seed=0, episodes=2),
    "`score_policy`": lambda player: mw.score_policy(player, "evader", CONFIG, episodes=2),
    "... `opponents=`": lambda player: mw.score_policy(
        "chaser", "pursuer", CONFIG, opponents={"it": player}, episodes=2
    ),
    "environments": _environments,
    "`tournament`": lambda player: tournament(CONFIG, "chaser", player, seed=0, episodes=2),
    "races": _raced,
    "`best_response`": lambda player: best_response(CONFIG, player, "evader"),
    "`expected_payoff`": lambda player: expected_payoff(CONFIG, "chaser", player),
    "`grade`": lambda player: mw.grade(player, "evader", worlds=CONFIG),
}
"""By its name, what takes a player."""

REASONS: dict[str, str] = {
    "whose choices depend on the present state alone": "memory",
    "it has a memory": "memory",
    "expected at most 200,000 moments": "too many moments",
    "expected what a run keeps": "not kept",
}
"""By words of a refusal: the reason as the table says it."""


def tried(kind: str, door: str) -> str:
    """Return "yes", or the reason why a call refuses a player."""
    player = KINDS[kind]()
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", UserWarning)
        try:
            DOORS[door](player)
        except (TypeError, ValueError) as error:
            for words, reason in REASONS.items():
                if words in str(error):
                    return reason
            raise
    return "yes"


def available(kind: str) -> bool:
    """Return whether a kind of players can be made here."""
    return kind != "torch module" or find_spec("torch") is not None


def row(kind: str) -> str:
    """Return the row of a kind of players in the table."""
    return f"| {kind} | " + " | ".join(tried(kind, door) for door in DOORS) + " |"


HEAD = f"|  | {' | '.join(DOORS)} |\n|---|{'---|' * len(DOORS)}"


if __name__ == "__main__":
    rows = (row(kind) for kind in KINDS if available(kind))
    sys.stdout.write("\n".join([HEAD, *rows]) + "\n")
