"""In which worlds do good teams of both sides win about half? Scripts, and ratings that raced.

    python evolution/balance.py           four minutes of one core, or more
    python evolution/balance.py --quick   some worlds and short races, some seconds

A race needs a world in which neither team can win nearly all matches, whatever the other learns. In
a table of capture rates, pursuers in rows, a world lies between two *bounds*: what the best row is
sure of (maxmin), and what the best column concedes (minmax). It is balanced if both lie in `BAND`.

1. Screen: all worlds of `VARIANTS`, `SIDES`, `NUMBERS` and `OBSTACLES` with agents on 1 to 25 % of
   the cells; good scripts of each team against each other, 8 episodes of each pair, seed 0.
2. Retest: of each variant the eight worlds whose worse bound is nearest one half, 60 new episodes
   (seed 1), since the best of many worlds in few episodes are partly luck. The two best go on.
3. Race: two hall-of-fame races of ratings (`RACE`, seeds 0 and 1) in each. The last champions join
   the scripts, and all play all, 60 new episodes of each pair (seed 2).

The rule of choice, stated before the first run: of each of the `KINDS` of rules the balanced world
whose worse bound in the last table is nearest one half. Whether races there are arms races has no
part in it; `balanced_races.py` asks that. One addition was made when no world of surrounding had
turned out to be balanced: then the best world of a variant that has none yet is chosen, too.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import partial
from itertools import product
from pathlib import Path
from typing import Any

import numpy as np

from common import kept, markdown, play, script_parser, slug, write_json
from matrixworld import Matches, Population, WorldConfig, rollout
from matrixworld._util.checks import check_threads
from matrixworld.coevolution import TEAMS, RaceSettings

KINDS = {
    "occupation, nobody disappears but the captured": ("O", "TO"),
    "occupation, collisions bounce or remove": ("B", "R", "D"),
    "surrounding": ("S", "SB", "SD", "SDB"),
}
"""Variants by kind of their rules."""
VARIANTS = tuple(variant for each in KINDS.values() for variant in each)
SIDES = (10, 14, 20, 28)
NUMBERS = ((4, 2), (4, 4), (6, 3), (8, 2), (8, 4), (8, 8), (12, 6))
"""Pursuers and evaders; of a single evader a match says only yes or no."""
OBSTACLES = (0.0, 0.1, 0.2)
CHASERS, SURROUNDERS = ("chaser", "hunter"), ("hunter", "surrounder", "careful-team-surrounder")
ESCAPERS = ("fleer", "dodger")
BAND = (0.4, 0.6)
STEPS = 200
RACE = {
    "policy": "rating", "policy.hidden": (4,), "schedule": "hall-of-fame",
    "schedule.generations": 10, "schedule.joint_epochs": 12, "train_steps": STEPS,
    "evaluation_episodes": 1,
}  # fmt: skip
SEEDS = (0, 1)

World = Mapping[str, Any]
"""Keyword arguments of `WorldConfig`."""


def worlds(quick: bool) -> list[World]:
    """Return the worlds of the screen; few small ones if `quick`."""
    sides, numbers, obstacles = SIDES, NUMBERS, OBSTACLES
    if quick:
        sides, numbers, obstacles = (10,), ((4, 4),), (0.1,)
    found = []
    for variant, side, (pursuers, evaders), share in product(VARIANTS, sides, numbers, obstacles):
        if 0.01 <= (pursuers + evaders) / side**2 <= 0.25:
            numbers_of_teams = {"n_pursuers": pursuers, "n_evaders": evaders}
            sizes = {"rows": side, "cols": side, **numbers_of_teams}
            found.append({"rules": variant, **sizes, "obstacles": share, "max_steps": STEPS})
    return found


def scripts(world: World) -> tuple[dict[str, Any], dict[str, Any]]:
    """Return good scripts of both teams by name; careful ones are not among them."""
    surround = world["rules"] in KINDS["surrounding"]
    pursuers = SURROUNDERS if surround else CHASERS
    return {name: name for name in pursuers}, {name: name for name in ESCAPERS}


def captured(
    world: World, teams: Sequence[Mapping[str, Any]], seed: int, episodes: int
) -> list[list[float]]:
    """Return the mean capture rates of all pursuers (rows) against all evaders."""
    seeds = np.random.default_rng(seed).integers(2**60, size=episodes)
    config, matches = WorldConfig(**world), Matches.of(0, 0, seeds)
    rates = [
        [
            float(rollout(config, p, e, matches, threads=1).capture_rate.mean())
            for e in teams[1].values()
        ]
        for p in teams[0].values()
    ]
    return np.round(rates, 4).tolist()


def bounds(rates: Sequence[Sequence[float]]) -> tuple[float, float]:
    """Return what the best row is sure of, and what the best column concedes."""
    table = np.asarray(rates)
    return float(table.min(axis=1).max()), float(table.max(axis=0).min())


def imbalance(row: Mapping[str, Any]) -> float:
    """Return how far the worse bound of a table lies from one half."""
    return max(abs(each - 0.5) for each in bounds(row["rates"]))


def measured(world: World, seed: int, episodes: int) -> dict[str, Any]:
    """Return a world, and the capture rates of scripts in it."""
    return {"world": world, "rates": captured(world, scripts(world), seed, episodes)}


def best(rows: Sequence[dict[str, Any]], count: int) -> list[dict[str, Any]]:
    """Return of each variant the worlds that are best balanced, the best first."""
    found = []
    for variant in VARIANTS:
        of_variant = [row for row in rows if row["world"]["rules"] == variant]
        found += sorted(of_variant, key=imbalance)[:count]
    return found


def screen(quick: bool) -> dict[str, Any]:
    """Return the worlds that are balanced among scripts, and how many were looked at."""
    every = worlds(quick)
    rows = [measured(world, 0, 8) for world in every]
    inside = [row for row in rows if imbalance(row) <= BAND[1] - 0.5]
    again = [measured(row["world"], 1, 60) for row in best(rows, 8)]
    return {"worlds": len(every), "balanced": len(inside), "retested": again}


def race(world: World, runs: Path, quick: bool, threads: int) -> dict[str, Any]:
    """Return a world with the capture rates of scripts and of the champions of short races."""
    pursuers, evaders = scripts(world)
    settings = RaceSettings.of({f"world.{name}": value for name, value in world.items()}, RACE)
    if quick:
        settings = settings.changed({"schedule.generations": 2, "schedule.joint_epochs": 2})
    for seed in SEEDS:
        run = play(settings.changed({"seed": seed}), runs / f"seed-{seed}", threads=threads)
        archive = run.archive()
        champions = [
            Population(archive[team][-1], settings.evaluation_game.policies[team]) for team in TEAMS
        ]
        pursuers[f"rating {seed}"], evaders[f"rating {seed}"] = champions
    rates = captured(world, (pursuers, evaders), 2, 60)
    return {"world": world, "rates": rates, "pursuers": [*pursuers], "evaders": [*evaders]}


def name_of(world: World) -> str:
    """Return a world in words."""
    numbers = f"{world['n_pursuers']} v {world['n_evaders']}"
    share = f", {world['obstacles']:.0%} obstacles" if world["obstacles"] else ""
    return f"{world['rules']}, {world['rows']} x {world['cols']}, {numbers}{share}"


def chosen(raced: Sequence[Mapping[str, Any]]) -> list[Mapping[str, Any]]:
    """Return the balanced worlds that have names, by the rule of choice."""
    balanced = [row for row in raced if imbalance(row) <= BAND[1] - 0.5]
    balanced.sort(key=imbalance)
    found: list[Mapping[str, Any]] = []
    for variants in KINDS.values():
        found += [row for row in balanced if row["world"]["rules"] in variants][:1]
    for row in balanced:
        if len(found) < len(KINDS) and row["world"]["rules"] not in variants_of(found):
            found.append(row)
    return found


def variants_of(rows: Sequence[Mapping[str, Any]]) -> list[str]:
    """Return the variants of worlds."""
    return [row["world"]["rules"] for row in rows]


def table(found: Mapping[str, Any]) -> str:
    """Return what the search has found, in Markdown."""
    raced = found["raced"]
    among_scripts = {name_of(row["world"]): row["rates"] for row in found["retested"]}
    rows = []
    for row in sorted(raced, key=imbalance):
        n, m = (len(each) for each in scripts(row["world"]))
        rates, name = np.array(row["rates"]), name_of(row["world"])
        parts = (rates[n:, :m], rates[:n, m:], rates[n:, m:])
        shown = [
            " to ".join(f"{each:.2f}" for each in bounds(r)) for r in (among_scripts[name], rates)
        ]
        rows.append([name, *shown, *(f"{part.mean():.2f}" for part in parts)])
    heads = ["world", "bounds, scripts", "bounds, all", "ratings v scripts", "scripts v ratings"]
    told = f"{found['worlds']} worlds, {found['balanced']} balanced among scripts. Bounds:"
    told = f"{told} maxmin to minmax. Then mean capture rates."
    names = "\n".join(f"- {name_of(row['world'])}" for row in chosen(raced)) or "- none"
    return f"{told}\n\n{markdown([*heads, 'ratings v ratings'], rows)}\n\nChosen:\n\n{names}"


def main() -> None:
    """Search, and write what was found; what has been played is kept beside the races."""
    told = "some worlds and short races, some seconds"
    parser = script_parser(__doc__, quick=told, runs=True)
    parser.add_argument("--threads", type=int, help="for training; default: one for each core")
    args = parser.parse_args()
    threads = check_threads(args.threads)
    found = kept(args.runs / "screen.json", lambda: screen(args.quick))
    found["raced"] = []
    for row in best(found["retested"], 2):
        place = args.runs / slug(name_of(row["world"]))
        played = partial(race, row["world"], place, args.quick, threads)
        found["raced"].append(kept(place / "rates.json", played))
    write_json(args.results, found, table(found))


if __name__ == "__main__":
    main()
