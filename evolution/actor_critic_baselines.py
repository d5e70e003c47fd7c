"""Which of the paper's baselines are reached? Policy gradients and neuroevolution side by side.

    python evolution/actor_critic_baselines.py             half an hour on two cores
    python evolution/actor_critic_baselines.py --quick     a small world, some seconds

One team learns against opponents that do not: pursuers against random and static evaders, evaders
against random and against well-learned pursuers. The published numbers stand beside each. Three
learners train the same network in the same world:

- actor-critic (policy gradients with GAE and PPO's clip),
- an evolution strategy that plays as many agent-steps as the actor-critic,
- an evolution strategy that takes as much computing time as the actor-critic.

Epochs are chosen in advance, so that a run does not depend on the machine; the table has the
agent-steps and the seconds that each run needed. After training each team plays 200 new episodes.

A result is *reached* if its interval over seeds is nowhere worse than the interval of the published
mean over its ten episodes, *not reached* if it is worse everywhere; else the table cannot tell.
Published intervals are Student's t, or Gaffke's where all ten episodes were equal: it has a width.
Seeds that all agree have an interval over all of their episodes.

Look at the two rows of the evolution strategy in each game: gradients learn from far fewer steps,
and the engine plays candidates so fast that the same time decides otherwise.

The time of a run is that from its first to its last file, on one core of a machine that does
nothing else: an interruption would count.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from scipy.stats import t

from common import PPO, SMALL_STEPS, Numbers, Runs, experiment, markdown, of_each, pairs, written
from matrixworld.analysis import Estimate, interval_over_runs, mean_over_episodes
from matrixworld.coevolution import RaceSettings, SavedRun, Team

EPISODES = 10
"""Episodes of a published number."""


@dataclass(frozen=True)
class Game:
    """A baseline of the paper."""

    name: str
    """What learns against what."""
    team: Team
    against: str
    """The script that is met, at first."""
    capture: float
    spread: float
    """Published capture rate, and its standard deviation over ten episodes."""
    length: str = ""
    """Published length of an episode."""

    @property
    def worst(self) -> float:
        """The worse end of the interval of the published mean, for the team that learns."""
        if self.spread:
            half = float(t.ppf(0.975, EPISODES - 1)) * self.spread / np.sqrt(EPISODES)
            ends = self.capture - half, self.capture + half
        else:
            # Ten equal episodes show no spread, and do not make the mean certain.
            ends = mean_over_episodes(np.full(EPISODES, self.capture)).ends
        return ends[0] if self.team == "pursuer" else ends[1]

    def verdict(self, found: Estimate) -> str:
        """Return reached, not reached or cannot tell."""
        sign = 1 if self.team == "pursuer" else -1
        good = [sign * (end - self.worst) >= 0 for end in found.ends]
        return "reached" if all(good) else "cannot tell" if any(good) else "not reached"


HUNT, STATIC = "pursuers against random evaders", "pursuers against static evaders"
HIDE, TAUGHT = "evaders against random pursuers", "evaders against those pursuers"
GAMES = (
    Game(HUNT, "pursuer", "random", 1.0, 0.0, "117.2 +- 41.3"),
    Game(STATIC, "pursuer", "still", 0.990, 0.015, "264.6 +- 184.2"),
    Game(HIDE, "evader", "random", 0.0133, 0.0221),
    Game(TAUGHT, "evader", "random", 0.060, 0.047),
)
GRADIENTS, STEPS, TIME = "actor-critic", "evolution, equal agent-steps", "evolution, equal time"
LEARNERS = (GRADIENTS, STEPS, TIME)

LONG = {"learner.population": 2, "train_steps": 500}
"""Evaders that learn in short episodes are captured later in long ones."""
AFTERWARDS = {"learner.sigma": 0.8, "learner.learning_rate": 0.1}
"""Steps of evolution that fit the weights of trained evaders (docs/published.md)."""
LEARN: Mapping[str, Mapping[str, Any]] = {
    GRADIENTS: {**PPO, "train_steps": 200},
    STEPS: {"learner.population": 16, "train_steps": 200},
    TIME: {"learner.population": 48, "train_steps": 200},
}
CHANGES: Mapping[tuple[str, str], Mapping[str, Any]] = {
    (HIDE, GRADIENTS): LONG,
    (TAUGHT, GRADIENTS): LONG,
    (HIDE, TIME): {"train_steps": 300},
    (TAUGHT, STEPS): AFTERWARDS,
    (TAUGHT, TIME): {"train_steps": 300, **AFTERWARDS},
}
EPOCHS = {
    HUNT: {GRADIENTS: 150, STEPS: 20, TIME: 1400},
    STATIC: {GRADIENTS: 150, STEPS: 19, TIME: 1400},
    HIDE: {GRADIENTS: 100, STEPS: 28, TIME: 1500},
    TAUGHT: {GRADIENTS: 100, STEPS: 28, TIME: 1200},
}
QUICK = {
    "policy.hidden": (4,), "world.rows": 8, "world.cols": 8, "world.n_pursuers": 3,
    "world.n_evaders": 3, "world.fov": 5, "world.max_steps": 20, "train_steps": 15,
    "evaluation_episodes": 4, "schedule.epochs": 3, "schedule.archive_every": 3,
}  # fmt: skip


def settings_of(game: Game, learner: str, quick: bool) -> RaceSettings:
    """Return the settings of a learner in a game, against a script or random opponents."""
    epochs = EPOCHS[game.name][learner]
    return RaceSettings.of(
        {
            "schedule": "against",
            "schedule.team": game.team,
            "schedule.opponent": game.against,
            "schedule.epochs": epochs,
            "schedule.archive_every": epochs,
            "policy.hidden": (32,),
            "evaluation_episodes": 200,
            **({} if learner == GRADIENTS else SMALL_STEPS[game.team]),
            **LEARN[learner],
            **CHANGES.get((game.name, learner), {}),
            **(QUICK if quick else {}),
        }
    )


def kinds(quick: bool) -> dict[str, RaceSettings]:
    """Return the settings of each learner in the games that begin untrained."""
    return {
        f"{game.name}; {learner}": settings_of(game, learner, quick)
        for game in GAMES
        if game.name != TAUGHT
        for learner in LEARNERS
    }


def taught(runs: Runs, quick: bool) -> dict[str, list[RaceSettings]]:
    """Return the settings of evaders that meet the pursuers of the first game.

    They start from the evaders of their own learner that have met random pursuers.
    """
    return {
        f"{TAUGHT}; {learner}": [
            settings_of(GAMES[-1], learner, quick).changed(
                {
                    "seed": begun.settings.seed,
                    "schedule.start": str(begun.path),
                    "schedule.opponent": str(rival.path),
                }
            )
            for begun, rival in pairs(runs, f"{HIDE}; {learner}", f"{HUNT}; {GRADIENTS}")
        ]
        for learner in LEARNERS
    }


def numbers_of(run: SavedRun) -> dict[str, Any]:
    """Return captures and lengths of all test episodes of a run, and the costs of its training.

    Its seconds are those between its first and its last file.
    """
    payoff = run.payoff()
    first, last = (run.path / name for name in ("config.json", "summary.json"))
    return {
        "captures": payoff.scores[-1, -1].astype(np.float32),
        "lengths": payoff.extras["lengths"][-1, -1].astype(np.int32),
        "agent_steps": run.summary()["training_agent_steps"],
        "seconds": last.stat().st_mtime - first.stat().st_mtime,
    }


def capture_rate(captures: np.ndarray) -> Estimate:
    """Return the mean of capture rates (seeds, episodes) with its interval over seeds."""
    found = interval_over_runs(captures.mean(axis=1), bounds=(0.0, 1.0))
    # Seeds that all agree do not show how much others would vary; their episodes still do.
    return mean_over_episodes(captures.ravel()) if found.low is None else found


def table(numbers: Numbers) -> str:
    """Return the results as a table in Markdown."""
    rows = []
    for game in GAMES:
        published = f"{game.capture:g} +- {game.spread:g}"
        published += f"; length {game.length}" if game.length else ""
        for learner in LEARNERS:
            captures, lengths, steps, seconds = (
                numbers[f"{game.name}; {learner} / {name}"]
                for name in ("captures", "lengths", "agent_steps", "seconds")
            )
            found, first = capture_rate(captures), learner == LEARNERS[0]
            rows.append([
                game.name,
                learner,
                written(found),
                f"{lengths.mean():.0f}",
                f"{steps.mean() / 1e6:.1f}",
                f"{seconds.mean():.0f}",
                published if first else "",
                f"**{game.verdict(found)}**",
            ])  # fmt: skip
    heads = [
        "game", "learner", "capture rate [95 % over seeds]", "length", "million agent-steps",
        "seconds", "published", "",
    ]  # fmt: skip
    return markdown(heads, rows)


if __name__ == "__main__":
    experiment(__doc__, kinds=kinds, then=taught, measure=of_each(numbers_of), table=table, seeds=3)
