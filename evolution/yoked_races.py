"""Do the teams of a race need each other's answers? Races, and yoked races of the same seeds.

    python evolution/yoked_races.py             ten seeds of each kind, six minutes of one core
    python evolution/yoked_races.py --quick     two seeds of tiny races, some seconds

In a yoked race the opponents are replayed from the race of the next seed: they change as in a race,
but do not answer (docs/coevolution.md). Both kinds begin with the same genomes and get the same
judgement. Runs are kept in ``--runs``; an interrupted script continues where it stopped.

In the payoff matrix of a yoked race strangers meet, in that of a race the teams that trained with
each other. Other numbers compare like with like. Gains against the opponents that were *met*, which
are those of the replayed race for a yoked one. Rises against *common* opponents: the races of all
seeds that neither the race nor the yoked one has met. In the world *turns*, exact payoffs against
perfect play and against the best response (docs/ground_truth.md).

Worlds: *turns* is that of ``small_world.toml``; *small* and *medium* are -O, 2 pursuers against 1
evader on 6 x 6 cells for 8 steps, and 3 against 5 on 12 x 12 cells for 50 steps.

Look at the last columns: the difference of each seed, race minus yoked race, with its interval over
seeds and its p-value, adjusted for the rows of a table (Holm). *Alike* means that the whole
interval lies within .05, the margin of the judgement. ``--results`` receives the tables, and the
numbers of each race.
"""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from tqdm import tqdm

import matrixworld as mw
from common import SIGNIFICANCE, finish_all, holm, p_value, script_parser, shown_p, written
from matrixworld import analysis
from matrixworld._util.files import load_toml
from matrixworld.coevolution import (
    SCHEDULES,
    TEAMS,
    RaceSettings,
    SavedRun,
    Team,
    Yoked,
    tournament,
)
from matrixworld.coevolution.types import other
from matrixworld.solve import Solution, best_response, expected_payoff, solve

RACE, YOKED = "race", "yoked race"
EVERY = 5
"""Generations are compared with common opponents, and with perfect play, at this distance."""
EPISODES = 10
"""Episodes of each pair of a generation and a common opponent."""
MARGIN = 0.05
"""A smaller difference does not matter; that of the judgement."""

SMALL = RaceSettings.of(
    {
        "world.rows": 6,
        "world.cols": 6,
        "world.n_pursuers": 2,
        "world.n_evaders": 1,
        "world.max_steps": 8,
        "train_steps": 8,
        "match_episodes": 4,
        "learner.relative_sigma": 0.0,
        "learner.learning_rate": 0.05,
        "schedule.pursuer_epochs": 60,
        "schedule.evader_epochs": 60,
        "evaluation_episodes": 40,
    }
)
MEDIUM = SMALL.changed(
    {
        "world.rows": 12,
        "world.cols": 12,
        "world.n_pursuers": 3,
        "world.n_evaders": 5,
        "world.max_steps": 50,
        "train_steps": 50,
        "match_episodes": 1,
        "schedule.generations": 20,
        "evaluation_episodes": 20,
    }
)


@dataclass(frozen=True)
class Experiment:
    """Races of one schedule in one world; with `exact` numbers where the world can be solved."""

    base: RaceSettings
    schedule: str
    exact: bool = False

    def settings(self, seed: int) -> RaceSettings:
        """Return the settings of the race of a seed."""
        meet = SCHEDULES[self.schedule]
        changes = {"pursuers_meet": meet.pursuers_meet, "evaders_meet": meet.evaders_meet}
        return replace(self.base, seed=seed, schedule=replace(self.base.schedule, **changes))


GENERALISTS = "generalist-generalist"
TURNS = RaceSettings.of(load_toml(Path(__file__).with_name("small_world.toml"))).changed(
    {
        "match_episodes": 8,
        "learner.relative_sigma": 0.0,
        "learner.learning_rate": 0.05,
        "schedule.pursuer_epochs": 30,
        "schedule.evader_epochs": 30,
        "evaluation_episodes": 40,
    }
)
FULL = {
    "turns, generalists": Experiment(TURNS, GENERALISTS, exact=True),
    "small, generalists": Experiment(SMALL, GENERALISTS),
    "medium, generalists": Experiment(MEDIUM, GENERALISTS),
}
TINY = TURNS.changed(
    {
        "world.rows": 4,
        "world.cols": 4,
        "match_episodes": 4,
        "learner.population": 8,
        "schedule.generations": 11,
        "schedule.pursuer_epochs": 2,
        "schedule.evader_epochs": 2,
    }
)
QUICK = {"tiny, generalists": Experiment(TINY, GENERALISTS, exact=True)}

Row = dict[str, float]
"""Numbers of one race by name."""
Kinds = dict[str, dict[str, Any]]
"""By kind: ``"rows"``, one for each seed, and ``"judgement"`` of all of them, by condition."""

SHARES = ("arms race", "rise")
"""Conditions: 1 if the judgement of a single race finds it in the whole race, else 0."""
NAMES = {
    "pursuer_gain": "gain of the pursuers in its matrix",
    "evader_gain": "gain of the evaders in its matrix",
    "pursuer_met": "gain of the pursuers against those met",
    "evader_met": "gain of the evaders against those met",
    "arms race": "seeds with an arms race",
    "rise": "seeds with a rise",
    "pursuer_common": "rise of the pursuers against common ones",
    "evader_common": "rise of the evaders against common ones",
    "pursuer_perfect": "rise of the pursuers against perfect play",
    "evader_perfect": "rise of the evaders against perfect play",
    "pursuer_guaranteed": "rise of what the pursuers guarantee",
    "evader_guaranteed": "rise of what the evaders guarantee",
}


def play(
    experiment: Experiment, name: str, seeds: int, root: Path, threads: int | None
) -> dict[str, list[SavedRun]]:
    """Return the finished runs of both kinds by seed, playing the missing ones."""
    world, _, _ = name.partition(",")

    def place(each: RaceSettings, seed: int) -> str:
        return f"{world}-{each.schedule.name}/seed-{seed}"

    races = {place(each, each.seed): each for each in map(experiment.settings, range(seeds))}
    yoked = {}
    for each in races.values():
        race = root.absolute() / place(each, (each.seed + 1) % seeds)
        schedule = Yoked(**vars(each.schedule), race=str(race))
        control = replace(each, schedule=schedule)
        yoked[place(control, control.seed)] = control
    return {
        kind: [*finish_all(settings, root, threads=threads).values()]
        for kind, settings in ((RACE, races), (YOKED, yoked))
    }


def numbers(
    experiment: Experiment, runs: Mapping[str, Sequence[SavedRun]], threads: int | None
) -> Kinds:
    """Return the numbers of all races, and the judgement of each kind."""
    found: Kinds = {}
    for kind, each in runs.items():
        rates = np.stack([run.payoff().capture_rates for run in each])
        judged = analysis.judge(rates, per_episode=True).windows["whole"]
        rows = []
        for seed in tqdm(range(len(each)), unit=" races", desc=kind, disable=None):
            row = {f"{team}_gain": gain(rates[seed], team) for team in TEAMS}
            for name in SHARES:
                row[name] = float(judged[name].by_run[seed] == "present")
            met = each[seed] if kind == RACE else runs[RACE][(seed + 1) % len(each)]
            for team in TEAMS:
                row[f"{team}_met"] = gain_against_met(team, each[seed], met, threads)
                row[f"{team}_common"] = against_common(team, seed, each[seed], runs[RACE], threads)
                if experiment.exact:
                    row |= exactly(team, each[seed])
            rows.append(row)
        verdicts = {name: finding.verdict for name, finding in judged.items()}
        found[kind] = {"rows": rows, "judgement": verdicts}
    return found


def gain(rates: NDArray[np.float32], team: Team) -> float:
    """Return a team's gain in the whole race, from single episodes (n, m, episodes)."""
    payoffs = analysis.read_payoffs(rates, per_episode=True)
    return float(analysis.MEASURES[f"{team}_gain"].of(payoffs, "whole").value)


def gain_against_met(team: Team, run: SavedRun, met: SavedRun, threads: int | None) -> float:
    """Return a team's gain against the other team of the race that it met in training."""
    teams = {team: run.teams[team], other(team): met.teams[other(team)]}
    rates = tournament(
        run.settings.world,
        teams["pursuer"],
        teams["evader"],
        seed=run.settings.seed,
        episodes=run.settings.evaluation_episodes,
        threads=threads,
    ).capture_rates
    return gain(rates, team)


def late(run: SavedRun, team: Team) -> slice:
    """Return the last fifth of a team's generations."""
    count = len(run.teams[team].genomes)
    return slice(count - max(1, count // 5), count)


def against_common(
    team: Team, seed: int, run: SavedRun, races: Sequence[SavedRun], threads: int | None
) -> float:
    """Return how much a team's last fifth is better than generation 0, against other races.

    The opponents are every fifth generation of the races of other seeds, without the next seed,
    whose race the yoked one replays.
    """
    strange = [race for number, race in enumerate(races) if (number - seed) % len(races) > 1]
    pools = [race.teams[other(team)].genomes[::EVERY] for race in strange or races]
    own = run.teams[team]
    kept = np.concatenate([own.genomes[:1], own.genomes[late(run, team)]])
    met = {
        team: mw.Population(kept, own.network),
        other(team): mw.Population(np.concatenate(pools), own.network),
    }
    payoff = tournament(
        run.settings.world,
        met["pursuer"],
        met["evader"],
        seed=seed,
        episodes=EPISODES,
        threads=threads,
    ).capture_rate
    scores = payoff.mean(axis=1) if team == "pursuer" else 1 - payoff.mean(axis=0)
    return float(scores[1:].mean() - scores[0])


@cache
def solved(world: mw.WorldConfig) -> Solution:
    """Return the solution of a world, which all races in it share."""
    return solve(world)


def exactly(team: Team, run: SavedRun) -> Row:
    """Return how much a team's last fifth is better than generation 0, exactly.

    Against perfect play, and against the best response to each generation: what it guarantees.
    """
    solution, policy = solved(run.settings.world), run.teams[team]
    rates = []
    for genome in [policy.genomes[0], *policy.genomes[late(run, team)]]:
        champion = mw.Population(genome[np.newaxis], policy.network)
        pair = (champion, solution) if team == "pursuer" else (solution, champion)
        responded = best_response(solution.states, champion, team).value
        rates.append((expected_payoff(solution.states, *pair), responded))
    # Captures are what pursuers want, and evaders do not.
    rises = (np.mean(rates[1:], axis=0) - rates[0]) * (1 if team == "pursuer" else -1)
    return {f"{team}_perfect": float(rises[0]), f"{team}_guaranteed": float(rises[1])}


def verdict(p: float, difference: analysis.Estimate) -> str:
    """Return which kind is higher, by the adjusted p-value and the interval of a difference."""
    if p < SIGNIFICANCE:
        return "race higher" if difference.value > 0 else "yoked higher"
    if difference.low is None:  # seeds that all agree do not show how much others differ
        return "cannot tell"
    return "alike" if max(-difference.low, difference.high) < MARGIN else "cannot tell"


def table(name: str, found: Kinds) -> str:
    """Return the comparison of both kinds of an experiment in Markdown."""
    rows = {kind: each["rows"] for kind, each in found.items()}
    names = [key for key in NAMES if key in rows[RACE][0]]
    values = {
        kind: {key: np.array([row[key] for row in each]) for key in names}
        for kind, each in rows.items()
    }
    differences = {key: values[RACE][key] - values[YOKED][key] for key in names}
    adjusted = holm([p_value(each) for each in differences.values()])
    count = len(rows[RACE])
    lines = [
        f"### {name}",
        "",
        f"| mean over {count} seeds [95%] | {RACE} | {YOKED} | difference | Holm | |",
        "|---" * 6 + "|",
    ]
    for key, p in zip(names, adjusted, strict=True):
        low, high = (0.0, 1.0) if key in SHARES else (-1.0, 1.0)
        means = [
            analysis.interval_over_runs(values[kind][key], bounds=(low, high))
            for kind in (RACE, YOKED)
        ]
        difference = analysis.interval_over_runs(differences[key], bounds=(-1.0, 1.0))
        cells = [NAMES[key], *map(written, means), written(difference, sign="+"), shown_p(p)]
        lines.append(f"| {' | '.join([*cells, f'**{verdict(p, difference)}**'])} |")
    lines += ["", f"| judgement of all seeds, whole race | {RACE} | {YOKED} |", "|---" * 3 + "|"]
    for condition, said in found[RACE]["judgement"].items():
        lines.append(f"| {condition} | {said} | {found[YOKED]['judgement'][condition]} |")
    return "\n".join(lines)


def report(found: Mapping[str, Kinds]) -> str:
    """Return the tables of all experiments."""
    return "\n\n".join(table(name, kinds) for name, kinds in found.items())


def main() -> None:
    """Play missing runs, and print and write the comparison."""
    parser = script_parser(__doc__, quick="two seeds of tiny races")
    parser.add_argument("--seeds", type=int, help="races of each kind; default 10, or 2")
    parser.add_argument("--only", choices=FULL, nargs="+", help="some of the experiments")
    parser.add_argument("--runs", type=Path, default=Path("runs/yoked_races"))
    parser.add_argument("--results", type=Path, default=Path("yoked_races"))
    parser.add_argument("--threads", type=int, help="default: one for each core")
    args = parser.parse_args()
    experiments, few = (QUICK, 2) if args.quick else (FULL, 10)
    found = {}
    for name in args.only or experiments:
        experiment = experiments[name]
        runs = play(experiment, name, args.seeds or few, args.runs, args.threads)
        found[name] = numbers(experiment, runs, args.threads)
    args.results.mkdir(parents=True, exist_ok=True)
    file = args.results / "numbers.json"
    # Rounded first, so that the tables follow from the numbers that are kept.
    text = json.dumps(json.loads(json.dumps(found), parse_float=lambda x: round(float(x), 6)))
    file.write_text(text + "\n", encoding="utf-8")
    told = report(json.loads(file.read_text(encoding="utf-8")))
    (args.results / "comparison.md").write_text(told + "\n", encoding="utf-8")
    print(told)
    print(f"\nWritten: numbers.json and comparison.md in {args.results}")


if __name__ == "__main__":
    main()
