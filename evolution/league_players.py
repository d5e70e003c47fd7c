"""Who plays in the league? Champions of all schedules and learners, trees of DEAP, scripts.

    python evolution/league_players.py             ten minutes of one core
    python evolution/league_players.py --quick     few and short races, some seconds

Each schedule of races trains each kind of policy by each learner that it has, in each of five small
worlds, briefly: players of different strength are wanted. The last champion of each race becomes
a player, and of ratings and programs an early one, too. DEAP's own algorithms evolve more programs
(`readable.py`). Scripts of the package and honest programs of the class tournament's tests
complete the teams. Genomes of networks are rounded to float16; the rounded one is the player.

``league.py`` lets all of them meet in other worlds. The file ``players.npz`` in the results
holds them: by team, names, kinds, texts of programs, and genomes by kind.
"""

from __future__ import annotations

import random
import re
import warnings
from collections.abc import Callable, Iterator
from functools import partial
from pathlib import Path
from typing import Any, TypeAlias

import numpy as np
from tqdm import tqdm

import common
import matrixworld as mw
import readable
from matrixworld.coevolution import TEAMS, RaceSettings, SavedRun, Team
from matrixworld.coevolution.settings.schedules import ALL_SCHEDULES

FOV = 11
INPUTS = ("adversary", "pressure", "unclaimed", "open_side", "teammate", "exits", "room")
"""Inputs of ratings and programs: all that depend on nothing but the view."""
RATINGS: dict[str, mw.Rating] = {
    "rating": mw.Rating(inputs=INPUTS, fov=FOV),
    "rating of 4": mw.Rating(inputs=INPUTS, hidden=(4,), fov=FOV),
}
PROGRAM = mw.Program(inputs=INPUTS, fov=FOV)
NETWORK = mw.Network(hidden=(4,), fov=FOV)
POLICIES: dict[str, mw.Rating | mw.Network] = {**RATINGS, "network": NETWORK}

TRAINING_WORLDS: dict[str, dict[str, Any]] = {
    "O": {"rules": "O", "rows": 5, "cols": 5, "n_pursuers": 2, "n_evaders": 1, "max_steps": 7},
    "TO": {"rules": "TO", "rows": 4, "cols": 5, "n_pursuers": 2, "n_evaders": 1, "max_steps": 5},
    "B": {"rules": "B", "rows": 4, "cols": 4, "n_pursuers": 1, "n_evaders": 2, "max_steps": 7,
          "obstacles": [".#..", "....", "..#.", "...."]},
    "S": {"rules": "S", "rows": 4, "cols": 4, "n_pursuers": 2, "n_evaders": 2, "max_steps": 8},
    "R": {"rules": "R", "rows": 6, "cols": 6, "n_pursuers": 1, "n_evaders": 1, "max_steps": 10,
          "obstacles": ["......", ".##...", "......", "...##.", ".#....", "......"]},
}  # fmt: skip
RACE: dict[str, Any] = {
    "train_steps": 8, "match_episodes": 8, "evaluation_episodes": 1, "schedule.generations": 12,
    "learner.population": 16,
}  # fmt: skip
EPOCHS = 12
"""Epochs of a generation for each team; policy gradients have a quarter."""
RATING: dict[str, Any] = {"policy": "rating", "policy.inputs": INPUTS}
KINDS: dict[str, dict[str, Any]] = {
    "es, rating": {"learner": "es", **RATING},
    "ga, rating of 4": {"learner": "ga", **RATING, "policy.hidden": [4], "learner.mutation": 0.2},
    "cma, rating": {"learner": "cma", **RATING},
    "gp, program": {"learner": "gp", "policy": "program", "policy.inputs": INPUTS},
    "es, network": {"learner": "es", "policy": "cells", "policy.hidden": [4]},
    "ga, network": {"learner": "ga", "policy": "cells", "policy.hidden": [4]},
    "actor-critic, network": {
        "learner": "actor-critic", "policy": "cells", "policy.hidden": [4],
        "learner.actor_rate": 0.003,
    },
}  # fmt: skip
EARLY, EARLY_OF = 3, ("rating", "rating of 4", "program")
"""The generation whose champion is a player, too, and the kinds of policies of which it is."""
TREES = {"turns": 10, "generations": 6, "size": 40}
"""A race of DEAP's trees; every second champion is a player."""
SCRIPTS = (
    "random", "still", "chaser", "fleer", "clumsy-chaser", "hunter", "clumsy-fleer", "dodger",
)  # fmt: skip
CLASS: dict[Team, str] = {"pursuer": "chaser", "evader": "fleer"}
NOISES = (0.05, 0.1, 0.2, 0.4)
"""Shares of random moves of the programs of the class tournament's tests."""
PROGRAMS = Path(__file__).parents[1] / "tutorials/class_tournament/tests/class_submissions.py"
QUICK_RACE = {"schedule.generations": 3, "learner.population": 4, "match_episodes": 1}

Found: TypeAlias = dict[Team, list[tuple[str, str, str, Any]]]
"""By team: name, kind, text and genome; one of the last two is empty."""
FILE = "players.npz"


def settings_of(schedule: str, kind: str, world: str, quick: bool) -> RaceSettings:
    """Return the settings of a race."""
    given = RACE | {f"world.{name}": value for name, value in TRAINING_WORLDS[world].items()}
    given |= {"world.fov": FOV, "schedule": schedule, **KINDS[kind]}
    epochs = 1 if quick else EPOCHS // (4 if "actor" in kind else 1)
    names = ("joint",) if schedule == "hall-of-fame" else TEAMS
    given |= {f"schedule.{name}_epochs": epochs for name in names}
    seed = [*TRAINING_WORLDS].index(world)
    return RaceSettings.of(given | (QUICK_RACE if quick else {}) | {"seed": seed})


def raced(run: SavedRun, kind: str) -> Iterator[tuple[Team, str, str, str, Any]]:
    """Yield team, generation, kind, text and genome of the champions of a race that play."""
    policy = kind.split(", ")[1]
    for team in TEAMS:
        genomes = run.teams[team].genomes
        for generation in (EARLY, len(genomes) - 1) if policy in EARLY_OF else (-1,):
            genome = genomes[generation]
            name = f"generation {generation % len(genomes)}"
            if policy == "program":
                yield team, name, policy, PROGRAM.expression(PROGRAM.simplified(genome)), None
            else:
                yield team, name, policy, "", genome


def races(root: Path, quick: bool) -> Iterator[tuple[Team, str, str, str, Any]]:
    """Yield the players of all races."""
    worlds = [*TRAINING_WORLDS][: 1 if quick else None]
    planned = [(w, s, k) for w in worlds for s in ALL_SCHEDULES for k in KINDS]
    for world, schedule, kind in tqdm(planned, unit=" races", disable=None):
        settings = settings_of(schedule, kind, world, quick)
        where = root / common.slug(f"{world} {schedule} {kind}")
        with warnings.catch_warnings():  # that one team wins nearly all matches is wanted
            warnings.simplefilter("ignore")
            run = common.play(settings, where, threads=1)
        for team, generation, policy, text, genome in raced(run, kind):
            yield team, f"{kind}; {schedule}; {world}; {generation}", policy, text, genome


def trees(quick: bool) -> Iterator[tuple[Team, str, str, str, Any]]:
    """Yield champions of DEAP's races of trees."""
    readable.PROGRAM = PROGRAM  # of the worlds here, in place of that of the example
    for place, (name, world) in enumerate(TRAINING_WORLDS.items()):
        if quick and place:
            return
        random.seed(place)  # DEAP uses Python's global generator
        readable.WORLD = mw.WorldConfig(**world, fov=FOV)
        size = dict.fromkeys(TREES, 2) | {"size": 8} if quick else TREES
        champions = readable.co_evolve(*size.values())
        for team in TEAMS:
            for turn in range(len(champions[team]) - 1, -1, -2):
                genome = PROGRAM.genome(str(champions[team][turn]))
                text = PROGRAM.expression(PROGRAM.simplified(genome))
                yield team, f"deap.gp; {name}; turn {turn}", "program", text, None


def programs() -> Iterator[tuple[Team, str, str, str, Any]]:
    """Yield honest programs of the tests of the class tournament, as text."""
    source = PROGRAMS.read_text(encoding="utf-8")
    for team, name in CLASS.items():
        [text] = re.findall(rf'^{name.upper()} = """\n(.*?)"""', source, re.M | re.S)
        for noise in NOISES:
            yield team, f"class, {name}; noise {noise}", "function", text.format(noise=noise), None


def all_players(root: Path, quick: bool) -> Found:
    """Return the players of both teams."""
    found: Found = {team: [] for team in TEAMS}
    for name in SCRIPTS:
        for team in TEAMS:
            found[team].append((f"script; {name}", "script", name, None))
    for team, name, kind, text, genome in (*programs(), *trees(quick), *races(root, quick)):
        found[team].append((name, kind, text, genome))
    return found


def save(found: Found, file: Path) -> None:
    """Write players to a file."""
    arrays: dict[str, Any] = {}
    for team, players in found.items():
        names, kinds, texts, genomes = zip(*players, strict=True)
        arrays |= {f"{team} names": names, f"{team} kinds": kinds, f"{team} texts": texts}
        for kind in POLICIES:
            of_kind = [g for k, g in zip(kinds, genomes, strict=True) if k == kind]
            dtype = np.float16 if kind == "network" else np.float32
            arrays[f"{team} {kind}"] = np.array(of_kind, dtype)
    file.parent.mkdir(parents=True, exist_ok=True)
    np.savez_compressed(file, **arrays)


def function_of(text: str, team: Team) -> Callable[..., Any]:
    """Return the function of a program."""
    names: dict[str, Any] = {}
    exec(text, names)
    function: Callable[..., Any] = names["pursue" if team == "pursuer" else "evade"]
    return function


def load(file: Path) -> dict[Team, dict[str, Any]]:
    """Return the players of each team by name: scripts, populations of one, and functions."""
    found: dict[Team, dict[str, Any]] = {}
    with np.load(file) as kept:
        for team in TEAMS:
            genomes = {kind: iter(kept[f"{team} {kind}"]) for kind in POLICIES}
            columns = (kept[f"{team} {column}"].tolist() for column in ("names", "kinds", "texts"))
            makers: dict[str, Callable[[str], Any]] = {
                "script": str,
                "function": partial(function_of, team=team),
                "program": lambda text: mw.Population(PROGRAM.genome(text), PROGRAM),
            }
            found[team] = {
                name: makers[kind](text)
                if kind in makers
                else mw.Population(np.float32(next(genomes[kind])), POLICIES[kind])
                for name, kind, text in zip(*columns, strict=True)
            }
    return found


def main() -> None:
    """Play what is left of the races, and write the players."""
    parser = common.script_parser(__doc__, quick="few and short races, some seconds", runs=True)
    args = parser.parse_args()
    found = all_players(args.runs, args.quick)
    save(found, args.results / FILE)
    for team, players in found.items():
        kinds = [kind for _, kind, _, _ in players]
        counts = ", ".join(f"{kinds.count(kind)} {kind}" for kind in dict.fromkeys(kinds))
        print(f"{len(players)} {team}s: {counts}")
    print(f"\nWritten: {FILE} in {args.results}")


if __name__ == "__main__":
    main()
