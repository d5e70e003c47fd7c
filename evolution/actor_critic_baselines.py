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

``--results`` receives the table and the numbers behind it; ``--runs`` keeps the finished runs. A
run that was interrupted is played anew, because its time is measured.
"""

from __future__ import annotations

import shutil
from collections.abc import Mapping
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass, field
from pathlib import Path
from time import process_time
from typing import Any

import numpy as np
from scipy.stats import t
from tqdm import tqdm

from common import SMALL_STEPS, script_parser, written
from matrixworld.analysis import Estimate, interval_over_runs, mean_over_episodes
from matrixworld.coevolution import RaceSettings, Team, finish, open_run

EPISODES = 10
"""Episodes of a published number."""


@dataclass(frozen=True)
class Game:
    """A baseline of the paper.

    Parameters
    ----------
    name : str
        What learns against what.
    team : {"pursuer", "evader"}
        Team that learns.
    against : str
        Name of a script, or of the game whose team, trained by actor-critic, is met.
    start : str, optional
        Game whose genome, by the same learner, is the start. By default it is untrained.
    capture, spread : float
        Published capture rate, and its standard deviation over ten episodes.
    length : str, optional
        Published length of an episode.
    """

    name: str
    team: Team
    against: str
    capture: float
    spread: float
    length: str = ""
    start: str | None = None

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
    Game(TAUGHT, "evader", HUNT, 0.060, 0.047, start=HIDE),
)
GRADIENTS, STEPS, TIME = "actor-critic", "evolution, equal agent-steps", "evolution, equal time"


@dataclass(frozen=True)
class Plan:
    """World, learners, and the length of each training.

    Parameters
    ----------
    world : mapping of str to object
        Settings of all runs.
    learners : mapping of str to mapping
        Settings of each learner.
    epochs : mapping of str to mapping
        Epochs of each game by learner.
    seeds : int
        Training seeds, from 0.
    changes : mapping of (str, str) to mapping
        Settings of one learner in one game.
    """

    world: Mapping[str, Any]
    learners: Mapping[str, Mapping[str, Any]]
    epochs: Mapping[str, Mapping[str, int]]
    seeds: int
    changes: Mapping[tuple[str, str], Mapping[str, Any]] = field(default_factory=dict)

    def settings(self, game: Game, learner: str, seed: int, root: Path) -> RaceSettings:
        """Return the settings of one run."""
        epochs = self.epochs[game.name][learner]
        chosen = RaceSettings.of(
            {
                "schedule": "against",
                "schedule.team": game.team,
                "schedule.epochs": epochs,
                "schedule.archive_every": epochs,
                "seed": seed,
                **self.world,
                **({} if learner == GRADIENTS else SMALL_STEPS[game.team]),
                **self.learners[learner],
                **self.changes.get((game.name, learner), {}),
            }
        )
        # These are the paths of runs that have been played before.
        if game.start is not None:
            chosen = chosen.changed(
                {"schedule.start": str(root / place(game.start, learner, seed))}
            )
        rival = game.against
        if rival in self.epochs:
            rival = str(root / place(rival, GRADIENTS, seed))
        return chosen.changed({"schedule.opponent": rival})


PPO = {
    "learner": "actor-critic",
    "learner.population": 4,
    "learner.actor_rate": 0.003,
    "learner.clip": 0.2,
    "learner.actor_updates": 5,
    "world.rewards": "published",
}
LONG = {"learner.population": 2, "train_steps": 500}
"""Evaders that learn in short episodes are captured later in long ones."""
AFTERWARDS = {"learner.sigma": 0.8, "learner.learning_rate": 0.1}
"""Steps of evolution that fit the weights of trained evaders (docs/published_numbers.md)."""
FULL = Plan(
    world={"policy.hidden": (32,), "evaluation_episodes": 200},
    learners={
        GRADIENTS: {**PPO, "train_steps": 200},
        STEPS: {"learner.population": 16, "train_steps": 200},
        TIME: {"learner.population": 48, "train_steps": 200},
    },
    changes={
        (HIDE, GRADIENTS): LONG,
        (TAUGHT, GRADIENTS): LONG,
        (HIDE, TIME): {"train_steps": 300},
        (TAUGHT, STEPS): AFTERWARDS,
        (TAUGHT, TIME): {"train_steps": 300, **AFTERWARDS},
    },
    epochs={
        HUNT: {GRADIENTS: 150, STEPS: 20, TIME: 1400},
        STATIC: {GRADIENTS: 150, STEPS: 19, TIME: 1400},
        HIDE: {GRADIENTS: 100, STEPS: 28, TIME: 1500},
        TAUGHT: {GRADIENTS: 100, STEPS: 28, TIME: 1200},
    },
    seeds=3,
)
QUICK = Plan(
    world={
        "policy.hidden": (4,),
        "world.rows": 8,
        "world.cols": 8,
        "world.n_pursuers": 3,
        "world.n_evaders": 3,
        "world.fov": 5,
        "train_steps": 15,
        "world.max_steps": 20,
        "evaluation_episodes": 4,
    },
    learners={
        GRADIENTS: {**PPO, "learner.population": 2},
        STEPS: {"learner.population": 4},
        TIME: {"learner.population": 8},
    },
    epochs={game.name: {GRADIENTS: 3, STEPS: 2, TIME: 4} for game in GAMES},
    seeds=2,
)


def place(game: str, learner: str, seed: int) -> str:
    """Return the path of a run in the directory of all runs."""
    return "/".join(
        [*(name.replace(",", "").replace(" ", "-") for name in (game, learner)), str(seed)]
    )


def timed(settings: RaceSettings, directory: Path) -> None:
    """Play a run that is missing, on one core, and write the seconds that it took beside it."""
    written = directory.with_suffix(".seconds")
    if written.exists():
        finish(settings, directory)  # only refuses a run of other settings
        return
    shutil.rmtree(directory, ignore_errors=True)
    before = process_time()
    finish(settings, directory, threads=1)
    written.write_text(f"{process_time() - before:.2f}\n", encoding="ascii")


def play(plan: Plan, root: Path, processes: int) -> None:
    """Play the runs that are missing, side by side; those that build on others come second."""
    first = [game for game in GAMES if game.start is None]
    second = [game for game in GAMES if game.start is not None]
    bar = tqdm(total=len(GAMES) * len(plan.learners) * plan.seeds, unit=" runs", disable=None)
    with bar, ProcessPoolExecutor(processes) as executor:
        for games in (first, second):
            begun = [
                executor.submit(
                    timed, plan.settings(game, learner, seed, root),
                    root / place(game.name, learner, seed),
                )
                for game in games for seed in range(plan.seeds) for learner in plan.learners
            ]  # fmt: skip
            for run in begun:
                run.result()
                bar.update()


def measured(plan: Plan, root: Path) -> dict[str, np.ndarray]:
    """Return the numbers of all runs.

    Returns
    -------
    dict of str to ndarray
        ``captures`` and ``lengths``, shape (games, learners, seeds, episodes); ``agent_steps`` and
        ``seconds`` of training and evaluation, shape (games, learners, seeds).
    """
    shape = (len(GAMES), len(plan.learners), plan.seeds)
    episodes = plan.world["evaluation_episodes"]
    captures, lengths = np.zeros((*shape, episodes)), np.zeros((*shape, episodes), np.int32)
    agent_steps, seconds = np.zeros(shape, np.int64), np.zeros(shape)
    names = [game.name for game in GAMES], list(plan.learners), range(plan.seeds)
    for at in np.ndindex(shape):
        path = root / place(*(each[k] for each, k in zip(names, at, strict=True)))  # type: ignore[arg-type]
        run = open_run(path)
        payoff = run.payoff()
        captures[at], lengths[at] = payoff.capture_rates[-1, -1], payoff.lengths[-1, -1]
        agent_steps[at] = run.summary()["training_agent_steps"]
        seconds[at] = float(path.with_suffix(".seconds").read_text(encoding="ascii"))
    return {
        "captures": captures.astype(np.float32),
        "lengths": lengths,
        "agent_steps": agent_steps,
        "seconds": seconds,
    }


def capture_rate(captures: np.ndarray) -> Estimate:
    """Return the mean of capture rates (seeds, episodes) with its interval over seeds."""
    found = interval_over_runs(captures.mean(axis=1), bounds=(0.0, 1.0))
    # Seeds that all agree do not show how much others would vary; their episodes still do.
    return mean_over_episodes(captures.ravel()) if found.low is None else found


def table(plan: Plan, numbers: Mapping[str, np.ndarray]) -> str:
    """Return the results as a table in Markdown."""
    heads = (
        "game", "learner", "capture rate [95 % over seeds]", "length", "million agent-steps",
        "seconds", "published", "",
    )  # fmt: skip
    lines = [f"| {' | '.join(heads)} |", "|---" * len(heads) + "|"]
    for g, game in enumerate(GAMES):
        published = f"{game.capture:g} +- {game.spread:g}"
        published += f"; length {game.length}" if game.length else ""
        for k, learner in enumerate(plan.learners):
            found = capture_rate(numbers["captures"][g, k])
            cells = (
                game.name if k == 0 else "", learner, written(found),
                f"{numbers['lengths'][g, k].mean():.0f}",
                f"{numbers['agent_steps'][g, k].mean() / 1e6:.1f}",
                f"{numbers['seconds'][g, k].mean():.0f}",
                published if k == 0 else "", f"**{game.verdict(found)}**",
            )  # fmt: skip
            lines.append(f"| {' | '.join(cells)} |")
    return "\n".join(lines)


def main() -> None:
    """Play missing runs, print and write the results."""
    parser = script_parser(__doc__, quick="a small world and two seeds")
    parser.add_argument("--runs", type=Path, default=Path("runs/actor_critic"))
    parser.add_argument("--results", type=Path, default=Path("actor_critic"))
    parser.add_argument("--processes", type=int, default=2, help="runs at one time; default: 2")
    args = parser.parse_args()
    plan, name = (QUICK, "quick") if args.quick else (FULL, "full")
    play(plan, args.runs / name, args.processes)
    numbers = measured(plan, args.runs / name)
    text = table(plan, numbers)
    print(text)
    args.results.mkdir(parents=True, exist_ok=True)
    (args.results / "baselines.md").write_text(text + "\n", encoding="utf-8")
    np.savez_compressed(args.results / "baselines.npz", **numbers)
    print(f"Written: {args.results}/baselines.md, {args.results}/baselines.npz")


if __name__ == "__main__":
    main()
