"""Which maps should teams learn on? By exact regret, by its estimates, novel ones, or any.

    python evolution/map_races.py             ten seeds, about three hours of one core
    python evolution/map_races.py --quick     two seeds of tiny races, half a minute

Races of 2 pursuers against 1 evader on 6 x 6 cells, in turns (TO), on maps that evolve
(evolution/maps/README.md). They differ in what maps are selected by. The world can be solved, so
that regret, which others estimate, is known. Episodes have 6 rounds, in which perfect pursuers
capture from about two thirds of all starts. In 20 they always do, and evaders have nothing to
regret.

Agents see two cells around them, and meet the newest opponents. With a view of the whole map, or
with opponents from all generations, the evaders of every pilot learned to stand still, and no map
taught them anything else, though scripts that flee escape more often.

*Ranks.* Fresh random maps are ranked by each estimate and by exact regret, for the last generations
of the races without selection. As many matches are played on each map as in a race. Look at the
rank correlation (Spearman) with its interval over seeds: an estimate is to be trusted for a team if
the whole interval is above 0.5, and to be refused if it is not above 0.

*Held-out maps.* All races are compared at the same number of matches, the smallest that one played,
on rooms, mazes and caves on which none has learned. Look at exact regret of each team, and at how
often pursuers capture, and evaders escape from, the last generations of the races without selection
by other seeds. A fitness helps a team if its difference from `none`, seed by seed, has an adjusted
p-value (Holm, over the rows of a column) below 0.05. The same is asked of 4 pursuers against 4
evaders on 16 x 16 cells. Regret is not known there, so only captures and escapes are compared.

All this was decided when two seeds of five kinds, and one of `none` with these settings, had been
seen.
"""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy import stats

import matrixworld as mw
from common import Numbers, Runs, adjusted, by_seed, experiment, kinds_in, markdown, mean, shown_p
from maps.archive import BOTH, MAP_FITNESS, MAP_TEAMS, NONE, Trial, random_map
from maps.held_out import held_out_maps, regrets
from maps.race import MapSettings, play
from matrixworld.coevolution import TEAMS, RaceSettings, SavedRun, Team

SIDE, STEPS = 6, 6
BASE = RaceSettings.of({
    "schedule": "alternating", "schedule.generations": 20, "schedule.pursuer_epochs": 50,
    "schedule.evader_epochs": 50, "schedule.pursuers_meet": "latest",
    "schedule.evaders_meet": "latest", "learner": "es", "learner.population": 64,
    "learner.sigma": 0.1, "learner.relative_sigma": 0.3, "learner.learning_rate": 0.03,
    "policy.hidden": [16], "world.rules": "TO", "world.rows": SIDE, "world.cols": SIDE,
    "world.n_pursuers": 2, "world.n_evaders": 1, "world.fov": 5,
    "world.max_steps": STEPS, "world.obstacles": 0.2, "train_steps": STEPS, "match_episodes": 32,
    "evaluation_episodes": 10,
})  # fmt: skip
MAPS, SELECTION = 8, {"children": 4, "fresh": 1}
MATCHES, WALLS = 4, 0.2
"""On each map, for an estimate; share of walls in random maps."""
LARGE = "16 x 16, "
LARGE_WORLD = {
    "world.rows": 16, "world.cols": 16, "world.n_pursuers": 4, "world.n_evaders": 4,
    "world.fov": 7, "world.max_steps": 40, "train_steps": 40, "learner.population": 32,
    "match_episodes": 8,
}  # fmt: skip
"""Their agents see three cells around them."""
QUICK = {
    "schedule.generations": 2, "schedule.pursuer_epochs": 2, "schedule.evader_epochs": 2,
    "world.rows": 4, "world.cols": 4, "world.max_steps": 8,
    "train_steps": 8, "learner.population": 4, "evaluation_episodes": 2,
}  # fmt: skip
RANKED = {False: 32, True: 6}
HELD_OUT = {False: 15, True: 3}
"""Maps, a multiple of the kinds: rooms, mazes and caves."""
EPISODES = 50
"""On each held-out map, against each opponent."""
SCORES = ("regret", "wins")


def kinds(quick: bool) -> dict[str, MapSettings]:
    """Return the settings of races by the fitness of maps, of exact regret by team, and of size."""
    base = BASE.changed(QUICK if quick else {})
    large = base.changed(LARGE_WORLD | ({"world.max_steps": 8, "train_steps": 8} if quick else {}))
    maps: dict[str, Any] = {"maps": 3 if quick else MAPS, "matches": MATCHES, "walls": WALLS}
    fitness = {
        name: MapSettings(base, name, **maps, **(SELECTION if name != NONE else {}))
        for name in MAP_FITNESS
    }
    return {
        **fitness,
        **{f"regret of {team}s": replace(fitness["regret"], team=team) for team in TEAMS},
        **{
            LARGE + name: replace(each, race=large)
            for name, each in fitness.items()
            if not MAP_FITNESS[name].exact
        },
    }


def last(run: SavedRun, team: Team, budget: int) -> mw.Population:
    """Return the newest genome of a team within a budget of matches."""
    policy = run.teams[team]
    newest = run.generation_at(team, budget)
    return mw.Population(policy.genomes[newest : newest + 1], policy.policy)


def ranks(run: SavedRun, quick: bool) -> dict[str, float]:
    """Return the rank correlation of each estimate with exact regret, by team."""
    settings, rng = run.settings, np.random.default_rng(run.settings.seed)
    shape, agents = (
        (settings.game.world.rows, settings.game.world.cols),
        settings.game.world.n_agents,
    )
    maps = np.array([random_map(shape, WALLS, agents, rng) for _ in range(RANKED[quick])])
    champions = {team: run.last(team) for team in TEAMS}
    matches = mw.Matches.of(0, 0, rng.integers(2**62, size=MATCHES))

    def play_on(world: mw.WorldConfig) -> mw.EpisodeStatistics:
        return mw.rollout(world, *champions.values(), matches, episodes=settings.match_episodes)

    values, best = np.full(len(maps), np.nan), np.full((len(maps), 2), -np.inf)
    exact, found = {}, {}
    for team in MAP_TEAMS:  # both as the last: the sum
        trial = Trial(maps, settings.training_game.world, champions, team, play_on, values, best)
        exact[team] = sum(exact.values()) if team == BOTH else MAP_FITNESS["regret"].of(trial)
        for name, fitness in MAP_FITNESS.items():
            if name not in ("regret", NONE):
                estimated = fitness.of(trial)
                spread = np.ptp(estimated) > 0 and np.ptp(exact[team]) > 0
                rank = stats.spearmanr(estimated, exact[team]).statistic if spread else 0.0
                found[f"{name}, {team}"] = float(rank)
    return found


def wins(
    run: SavedRun, team: Team, own: mw.Population, others: mw.Population, quick: bool
) -> float:
    """Return how often a team captures, or escapes, on held-out maps."""
    world, rates = run.settings.game.world, []
    matches = len(others.genomes)
    teams = (own, others) if team == "pursuer" else (others, own)
    met = (0, np.arange(matches)) if team == "pursuer" else (np.arange(matches), 0)
    for walls in held_out_maps(world.rows, world.cols, HELD_OUT[quick]):
        config = replace(world, obstacles=walls)
        played = mw.rollout(
            config, *teams, mw.Matches.of(*met, np.arange(matches)), episodes=EPISODES
        )
        rates.append(played.capture_rate.mean(dtype=np.float64))
    captured = float(np.mean(rates))
    return captured if team == "pursuer" else 1.0 - captured


def held_out(runs: Runs, quick: bool) -> dict[str, Any]:
    """Return what teams of races in worlds of one size reach on held-out maps.

    The regret of each kind and team, where it is known, and how often the team wins.
    """
    budget = min(int(run.log()["matches"][-1]) for of_kind in runs.values() for run in of_kind)
    plain = next(of_kind for name, of_kind in runs.items() if name.endswith(NONE))

    def numbers_of(run: SavedRun) -> dict[str, Any]:
        world, found = run.settings.game.world, {}
        own = {team: last(run, team, budget) for team in TEAMS}
        if world.rows <= SIDE:
            maps = held_out_maps(world.rows, world.cols, HELD_OUT[quick])
            regret = regrets(own, world, maps)
            found |= {f"regret, {team}": regret[team].mean() for team in TEAMS}
        rivals = [each for each in plain if each.settings.seed != run.settings.seed]
        for team in TEAMS:
            theirs = [last(each, TEAMS[1 - TEAMS.index(team)], budget) for each in rivals]
            genomes = np.concatenate([each.genomes for each in theirs])
            others = mw.Population(genomes, theirs[0].policy)
            found[f"wins, {team}"] = wins(run, team, own[team], others, quick)
        return found

    size = LARGE if next(iter(runs)).startswith(LARGE) else ""
    return {**by_seed(runs, numbers_of), f"{size}budget": budget}


def measured(runs: Runs, quick: bool) -> dict[str, Any]:
    """Return ranks, and what is reached on held-out maps in both worlds."""
    numbers = by_seed({NONE: runs[NONE]}, lambda run: ranks(run, quick))
    numbers = {name.replace(NONE, "ranks", 1): each for name, each in numbers.items()}
    for large in (False, True):
        of_size = {n: of_kind for n, of_kind in runs.items() if n.startswith(LARGE) == large}
        numbers |= held_out(of_size, quick) if of_size else {}
    return numbers


def rank_table(numbers: Numbers) -> str:
    """Return the rank correlations by estimate and team."""
    names = [name for name in MAP_FITNESS if name not in ("regret", NONE)]
    rows = []
    for name in names:
        ranked = [numbers[f"ranks / {name}, {team}"] for team in MAP_TEAMS]
        rows.append([name, *(mean(each, 2, "+", bounds=(-1.0, 1.0)) for each in ranked)])
    heads = ["rank correlation with exact regret", *(f"of {team}s" for team in TEAMS), "of both"]
    return markdown(heads, rows)


def held_out_table(numbers: Numbers, size: str) -> str:
    """Return what each kind of a size reaches on held-out maps, and its difference from `none`."""
    columns = [
        column
        for column in (f"{score}, {team}" for team in TEAMS for score in SCORES)
        if f"{size}{NONE} / {column}" in numbers
    ]
    played = [
        name
        for name in kinds_in(numbers)
        if name.startswith(LARGE) == bool(size) and f"{name} / {columns[0]}" in numbers
    ]

    def differences(column: str) -> dict[str, NDArray[np.float64]]:
        plain = numbers[f"{size}{NONE} / {column}"]
        compared = (name for name in played if name != size + NONE)
        return {name: numbers[f"{name} / {column}"] - plain for name in compared}

    tests = {column: adjusted(differences(column)) for column in columns}
    rows = []
    for name in played:
        cells = []
        for column in columns:
            cells.append(mean(numbers[f"{name} / {column}"], bounds=(0.0, 1.0)))
            cells.append("" if name == size + NONE else shown_p(tests[column][name]))
        rows.append([name.removeprefix(size), *cells])
    heads = [head for column in columns for head in (column, "p, against none")]
    world = size.rstrip(", ") or f"{SIDE} x {SIDE}"
    told = f"{world}, after {int(numbers[f'{size}budget']):,} matches, on held-out maps:"
    return f"{told}\n\n{markdown(['maps by', *heads], rows)}"


def table(numbers: Numbers) -> str:
    """Return the rank correlations, and what each kind reaches in each world that was played."""
    sizes = [size for size in ("", LARGE) if f"{size}budget" in numbers]
    return "\n\n".join([rank_table(numbers), *(held_out_table(numbers, size) for size in sizes)])


if __name__ == "__main__":
    experiment(__doc__, kinds=kinds, play=play, measure=measured, table=table, seeds=10, fewest=2)
