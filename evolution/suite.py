"""Which 25 solved worlds make the suite MW-25? Their values, what scripts reach, and the games.

    python evolution/suite.py                     solve them all, and write them; some seconds
    python evolution/suite.py --check             compare what is written with what is computed
    python evolution/suite.py --table             print the tables of docs/suite.md
    python evolution/suite.py --fixture DIRECTORY games as JSON that other programs can read
    python evolution/suite.py --quick             check the three smallest worlds

The suite grades players of both teams (docs/suite.md). The package holds it as
``python/matrixworld/solver/mw25.json``; a version never changes its meaning. Of each world: the
settings, its value, what it is worth to the pursuers to move second, and what scripts guarantee.

The worlds are small: at most 4,000 states, at most 4,000 different views of a team, five moves,
2 to 8 steps, values of .1 to .9. In each of them at most half of 40 test players of each team had
the same grade to three decimals. At once it is worth .02 or more to move second.

A fixture is a game without its rules: what follows each joint action, and the share of evaders that
are captured in each state. It also says what uniformly drawn joint actions guarantee exactly, so
that an implementation of best responses can be checked.
"""

from __future__ import annotations

import json
import sys
from collections.abc import Iterable, Sequence
from contextlib import suppress
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

import matrixworld as mw
import tabular
from common import markdown, script_parser
from matrixworld._util.files import read_json, save_json
from matrixworld._util.teams import PLURALS
from matrixworld.analysis import interval_over_runs
from matrixworld.coevolution import TEAMS, Team
from matrixworld.coevolution.evaluation.held_out import scripts_for
from matrixworld.solver import States, best_response, solve

NAME, VERSION = "MW-25", 1
WORLDS = """\
agents in turns, occupied; 1 v 1; 3 x 4 with walls .#../..../.#..; 7 steps
teams in turns, occupied; 1 v 1; 3 x 5 with walls ...../...../#..#.; 4 steps
agents in turns, surrounded; 1 v 2; 3 x 3 with walls .#./.../#..; 5 steps
teams in turns, surrounded; 2 v 1; 3 x 4 with walls ..../.#../.#..; 5 steps
teams in turns, D; 2 v 2; 3 x 3 with walls #../.../.#.; 3 steps
agents in turns, surrounded; 2 v 1; 3 x 4 with walls #..#/..../.#.#; 2 steps
teams in turns, surrounded; 3 v 1; 2 x 5 with walls ...../.#..#; 2 steps
teams in turns, occupied; 2 v 1; 4 x 4 with walls .#../.#.#/..../....; 4 steps
agents in turns, occupied; 1 v 2; 3 x 4 with walls ##../..../.#..; 6 steps
teams in turns, occupied; 1 v 2; 3 x 5 with walls ..#../...../.#...; 5 steps
teams in turns, occupied; 2 v 1; 4 x 4 with walls ..../...#/..../....; 3 steps
TO; 2 v 1; 3 x 4 with walls ..../..../..#.; 3 steps
O; 1 v 2; 3 x 3 with walls #../.../#.#; 5 steps
B; 1 v 2; 3 x 3 with walls #../#.#/...; 5 steps
B; 1 v 2; 3 x 3 with walls .../..#/#.#; 3 steps
O; 2 v 1; 3 x 3 with walls .../..#/...; 3 steps
B; 2 v 1; 3 x 4 with walls #.../..#./...#; 4 steps
R; 1 v 2; 3 x 3 with walls .../#.#/#..; 4 steps
SDB; 2 v 2; 3 x 3 with walls #../.../..#; 6 steps
R; 2 v 1; 2 x 5 with walls ...../.#...; 3 steps
O; 2 v 1; 3 x 4 with walls ..##/..../#...; 3 steps
S; 2 v 1; 3 x 3; 2 steps
O; 2 v 1; 3 x 4; 3 steps
B; 3 v 1; 3 x 4 with walls .#../..../...#; 2 steps
B; 1 v 2; 3 x 4 with walls .#../..#./....; 6 steps
""".splitlines()
"""Rules, teams, board and steps: 12 worlds in turns, then 13 at once, by their number of states."""
FOV = 11
EXAMPLE = "teams in turns, surrounded; 2 v 1; 3 x 4 with walls ..../.#../.#..; 5 steps"
"""The world whose game stands beside the page."""
ROOT = Path(__file__).parents[1]
FILE = ROOT / "python/matrixworld/solver/mw25.json"
EXAMPLE_FILE = ROOT / "docs/mw25_example.json"
TOLERANCE = 1e-12
QUICK = 3

World = dict[str, Any]
"""A world as `FILE` holds it."""


# Worlds


def config_of(name: str) -> mw.WorldConfig:
    """Return the world of a name; in turns, a variant may stand in place of a way to capture."""
    rules, _, rest = name.partition("; ")
    turns, _, variant = rules.partition(", ")
    if variant not in mw.VARIANTS:
        return replace(tabular.config_of(name), fov=FOV)
    in_turns = replace(mw.VARIANTS[variant], interaction=tabular.TURNS[turns])
    return replace(tabular.config_of(f"{variant}; {rest}"), rules=in_turns, fov=FOV)


def guarantees(states: States, team: Team) -> dict[str, float]:
    """Return what scripts guarantee, careful ones, too: all that can be graded exactly."""
    found = {}
    for script in scripts_for(team, states.config):
        with suppress(ValueError):  # a script that searches
            found[script] = best_response(states, script, team).value
    return found


def described(name: str) -> World:
    """Return the settings of a world, and what is known of it."""
    config = config_of(name)
    states = States(config)
    return {
        "name": name,
        "in_turns": states.n_turns > 1,
        "world": config.to_json(),
        "value": solve(states).value,
        "second": tabular.Game(config).mixing,
        "scripts": {team: guarantees(states, team) for team in TEAMS},
    }


def described_all(names: Iterable[str]) -> dict[str, Any]:
    """Return a suite as `FILE` holds it."""
    return {"name": NAME, "version": VERSION, "worlds": [described(name) for name in names]}


def differences(ours: Any, theirs: Any, place: str = "") -> list[str]:
    """Return the places in which values of JSON differ; numbers do by more than the tolerance."""
    if isinstance(ours, dict) and isinstance(theirs, dict) and ours.keys() == theirs.keys():
        pairs = [(f"{place} / {key}", ours[key], theirs[key]) for key in ours]
    elif isinstance(ours, list) and isinstance(theirs, list) and len(ours) == len(theirs):
        pairs = [(f"{place} / {n}", *pair) for n, pair in enumerate(zip(ours, theirs, strict=True))]
    elif isinstance(ours, float) and isinstance(theirs, float):
        return [] if abs(ours - theirs) <= TOLERANCE else [f"{place}: {ours!r}, not {theirs!r}"]
    else:
        return [] if ours == theirs else [f"{place}: {ours!r}, not {theirs!r}"]
    return [each for name, mine, other in pairs for each in differences(mine, other, name)]


# Games


def game(name: str) -> dict[str, Any]:
    """Return a world as a game without rules: states, successors, captures; and its exact values.

    States are numbered by turn; what follows the last turn of a round are states of the first.
    """
    config = config_of(name)
    states = States(config)
    turns = range(states.n_turns)
    # If each member draws uniformly, so does the team among its joint actions.
    uniform = {team: best_response(states, "random", team).value for team in TEAMS}
    return {
        "suite": NAME,
        "version": VERSION,
        "name": name,
        "steps": config.max_steps,
        "turns": states.n_turns,
        "states": [states.count(turn) for turn in turns],
        "starts": states.starts.tolist(),
        "captured": states.captured().mean(axis=1).tolist(),
        "successors": [states.successors(turn).tolist() for turn in turns],
        "value": solve(states).value,
        "guarantees": {f"uniform {PLURALS[team]}": value for team, value in uniform.items()},
    }


def uniform_guarantees(game: dict[str, Any]) -> dict[str, float]:
    """Return what uniformly drawn joint actions guarantee, from nothing but the game."""
    pursuers = evaders = np.array(game["captured"])
    for _ in range(game["steps"]):
        for successors in map(np.array, reversed(game["successors"])):
            pursuers = pursuers[successors].mean(axis=1).min(axis=1)
            evaders = evaders[successors].mean(axis=2).max(axis=1)
    both = {"uniform pursuers": pursuers, "uniform evaders": evaders}
    return {name: float(values[game["starts"]].mean()) for name, values in both.items()}


def write_game(name: str, path: Path) -> None:
    """Write the game of a world, once the solver and NumPy agree on what is guaranteed in it."""
    found = game(name)
    if wrong := differences(uniform_guarantees(found), found["guarantees"], name):
        raise ArithmeticError("\n".join(wrong))
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(json.dumps(found, separators=(",", ":")) + "\n", encoding="utf-8")


# Tables


def shown(share: float) -> str:
    """Return a share with three decimals."""
    return f"{share:.3f}"


def table(worlds: Iterable[World]) -> str:
    """Return what is known of each world, in Markdown."""
    heads = (
        "", "rules", "board", "teams", "steps", "value", "second", "best script: pursuers",
        "best script: evaders",
    )  # fmt: skip
    rows = []
    for number, world in enumerate(worlds, start=1):
        rules, teams, board, steps = world["name"].split("; ")
        size, _, walls = board.partition(" with walls ")
        bests = [
            best(world["scripts"][team].items(), key=lambda item: item[1])
            for team, best in zip(TEAMS, (max, min), strict=True)
        ]
        rows.append([
            str(number), rules, f"{size} `{walls}`" if walls else size, teams, steps.split()[0],
            shown(world["value"]), "0" if world["in_turns"] else shown(world["second"]),
            *(f"{name} {shown(guarantee)}" for name, guarantee in bests),
        ])  # fmt: skip
    return markdown(heads, rows)


def share(guarantee: float, value: float, team: Team) -> float:
    """Return the share of perfect play that a guarantee is."""
    return guarantee / value if team == "pursuer" else (1.0 - guarantee) / (1.0 - value)


def shares(worlds: Sequence[World]) -> str:
    """Return the grades of the scripts that have guarantees in all worlds, in Markdown."""
    rows = []
    for team in TEAMS:
        known = [world["scripts"][team] for world in worlds]
        for script in known[0]:
            if not all(script in guarantees for guarantees in known):
                continue
            of_perfect = [
                share(guarantees[script], world["value"], team)
                for world, guarantees in zip(worlds, known, strict=True)
            ]
            found = interval_over_runs(of_perfect, bounds=(0.0, 1.0))
            if found.low is None or found.high is None:
                raise ArithmeticError(f"{script}: {found.note}")
            ends = f"{shown(found.low)} .. {shown(found.high)}"
            rows.append([f"`{script}`", PLURALS[team], shown(found.value), ends])
    return markdown(("script", "team", "grade", "95 % over worlds"), rows)


def main() -> None:
    """Do what the options say."""
    parser = script_parser(__doc__, quick="check the three smallest worlds", results=False)
    parser.add_argument("--check", action="store_true", help="compare; write nothing")
    parser.add_argument("--table", action="store_true", help="print the tables of docs/suite.md")
    parser.add_argument("--fixture", type=Path, metavar="DIRECTORY", help="write games as JSON")
    parser.add_argument("--world", type=int, metavar="NUMBER", help="of a fixture: only this one")
    args = parser.parse_args()
    chosen = range(1, len(WORLDS) + 1) if args.world is None else [args.world]
    if not 1 <= chosen[0] <= len(WORLDS):
        parser.error(f"argument --world: expected 1 to {len(WORLDS)}, got {args.world}")
    if args.fixture:
        for number in chosen:
            write_game(WORLDS[number - 1], args.fixture / f"{number:02}.json")
        print(f"Written: {len(chosen)} games in {args.fixture}")
        return
    if args.table:
        worlds = read_json(FILE)["worlds"]
        print(f"{table(worlds)}\n\n{shares(worlds)}")
        return
    if args.check or args.quick:
        known = read_json(FILE)
        if args.quick:
            small = sorted(WORLDS, key=lambda name: States(config_of(name)).total)[:QUICK]
            known["worlds"] = [each for each in known["worlds"] if each["name"] in small]
        names = [name for name in WORLDS if not args.quick or name in small]
        wrong = differences(described_all(names), known)
        if not args.quick:
            wrong += differences(game(EXAMPLE), read_json(EXAMPLE_FILE), EXAMPLE)
        print("\n".join(wrong) or f"{len(names)} worlds of {FILE.name} are as computed")
        sys.exit(bool(wrong))
    found = described_all(WORLDS)
    save_json(FILE, found)
    write_game(EXAMPLE, EXAMPLE_FILE)
    print(table(found["worlds"]))
    print(f"\nWritten: {FILE.relative_to(ROOT)}, {EXAMPLE_FILE.relative_to(ROOT)}")


if __name__ == "__main__":
    main()
