"""Do the teams of a race need each other's answers? Races, and yoked races of the same seeds.

    python evolution/yoked_races.py             ten seeds of each kind, six minutes of one core
    python evolution/yoked_races.py --quick     two seeds of tiny races, some seconds

In a yoked race the opponents are replayed from the race of the next seed: they change as in a race,
but do not answer, a yoked control (Held and Hein 1963). Both kinds begin with the same genomes.
Payoffs are kept, so that a new table judges them by the rules of its day. Runs are kept in
``--runs``; an interrupted script continues where it stopped.

In the payoff matrix of a yoked race strangers meet, in that of a race the teams that trained with
each other. Other numbers compare like with like. Gains against the opponents that were *met*, which
are those of the replayed race for a yoked one. Rises against *common* opponents: the races of all
seeds that neither the race nor the yoked one has met. In the world *turns*, exact payoffs against
perfect play and against the best response (docs/ground_truth.md).

Worlds: *turns* is that of ``small_world.toml``; *small* is O, 2 pursuers against 1 evader on 6 x 6
cells for 8 steps.

Look at the last columns: the difference of each seed, race minus yoked race, with its interval over
seeds and its p-value, adjusted for the rows of a table (Holm). *Alike* means that the whole
interval lies within .05, the margin of the judgement.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

import matrixworld as mw
from common import (
    SIGNIFICANCE,
    Numbers,
    Runs,
    adjusted,
    experiment,
    kinds_in,
    markdown,
    payoffs_of,
    rates,
    scores_against,
    shown_p,
    solved,
    written,
)
from matrixworld import analysis
from matrixworld._util.files import load_toml
from matrixworld.coevolution import (
    SCHEDULES,
    TEAMS,
    RaceSettings,
    Run,
    SavedRun,
    Team,
    Training,
    create,
    evolve,
    tournament,
)
from matrixworld.coevolution.types import Genomes, other
from matrixworld.solver import best_response, expected_payoff

RACE, YOKED = "race", "yoked race"
EVERY = 5
"""Generations are compared with common opponents, and with perfect play, at this distance."""
EPISODES = 10
"""Episodes of each pair of a generation and a common opponent."""
MARGIN = 0.05
"""A smaller difference does not matter; that of the judgement."""

MEET = {
    f"schedule.{name}": getattr(SCHEDULES["generalist-generalist"], name)
    for name in ("pursuers_meet", "evaders_meet")
}
SMALL = RaceSettings.of({
    "world.rows": 6, "world.cols": 6, "world.n_pursuers": 2, "world.n_evaders": 1,
    "world.max_steps": 8, "train_steps": 8, "match_episodes": 4, "evaluation_episodes": 40,
    "learner.relative_sigma": 0.0, "learner.learning_rate": 0.05,
    "schedule.pursuer_epochs": 60, "schedule.evader_epochs": 60, **MEET,
})  # fmt: skip
TURNS = RaceSettings.of(load_toml(Path(__file__).with_name("small_world.toml"))).changed({
    "match_episodes": 8, "evaluation_episodes": 40,
    "learner.relative_sigma": 0.0, "learner.learning_rate": 0.05,
    "schedule.pursuer_epochs": 30, "schedule.evader_epochs": 30, **MEET,
})  # fmt: skip
WORLDS = {"turns": TURNS, "small": SMALL}
TINY = TURNS.changed({
    "world.rows": 4, "world.cols": 4, "match_episodes": 4, "learner.population": 8,
    "schedule.generations": 11, "schedule.pursuer_epochs": 2, "schedule.evader_epochs": 2,
})  # fmt: skip
EXACT = {"turns", "tiny"}
"""Worlds that are solved."""

NAMES = {
    "pursuer_gain": "gain of the pursuers in its matrix",
    "evader_gain": "gain of the evaders in its matrix",
    "pursuer_met": "gain of the pursuers against those met",
    "evader_met": "gain of the evaders against those met",
    "pursuer_common": "rise of the pursuers against common ones",
    "evader_common": "rise of the evaders against common ones",
    "pursuer_perfect": "rise of the pursuers against perfect play",
    "evader_perfect": "rise of the evaders against perfect play",
    "pursuer_guaranteed": "rise of what the pursuers guarantee",
    "evader_guaranteed": "rise of what the evaders guarantee",
}


class YokedTraining(Training):
    """A race in turns whose opponents are `replayed` from the archive of another one.

    ::

        P, E the archives of the other race; all else as in `InTurns`
        p[k] = p[k-1], improved for some epochs against evaders that its sampler chooses in E
        e[k] = e[k-1], improved for some epochs against pursuers that its sampler chooses in P
    """

    def __init__(self, *args: Any, replayed: Mapping[str, Genomes], **options: Any) -> None:
        super().__init__(*args, **options)
        self.replayed = replayed

    def opponents(self, team: Team) -> mw.Population:
        """Return as many generations of the other race as this one has itself."""
        rival = other(team)
        return self.population(rival, self.replayed[rival][: len(self.archive[rival])])


def begun(
    settings: RaceSettings, directory: str | Path, replayed: SavedRun, *, threads: int | None = None
) -> Run:
    """Return a race before it goes on whose opponents are those of a finished race.

    The settings are those of the other race, but for the seed.
    """
    expected = replace(replayed.settings, seed=settings.seed)
    if not replayed.finished or settings != expected or settings == replayed.settings:
        why = "expected a finished race of these settings with another seed"
        raise ValueError(f"{replayed.path}: {why}")
    create(settings, directory)
    training = partial(YokedTraining, replayed=replayed.archive())
    return Run(directory, threads=threads, training=training)


@dataclass(frozen=True)
class Yoked:
    """A race, and the directory of another one that it replays."""

    settings: RaceSettings
    race: Path


def play(planned: RaceSettings | Yoked, directory: Path, *, threads: int) -> SavedRun:
    """Play what is left of a race, or of a yoked one."""
    if isinstance(planned, RaceSettings):
        return evolve(planned, directory, threads=threads)
    begun(planned.settings, directory, SavedRun(planned.race), threads=threads).run()
    return SavedRun(directory)


def kinds(quick: bool) -> dict[str, RaceSettings]:
    """Return the settings of the races of each world."""
    worlds = {"tiny": TINY} if quick else WORLDS
    return {f"{world}, generalists, {RACE}": settings for world, settings in worlds.items()}


def yoked(runs: Runs, quick: bool) -> dict[str, list[Yoked]]:
    """Return races whose opponents are those of the race of the next seed."""
    return {
        kind.removesuffix(RACE) + YOKED: [
            Yoked(race.settings, replayed.path.absolute())
            for race, replayed in zip(races, [*races[1:], races[0]], strict=True)
        ]
        for kind, races in runs.items()
    }


def measured(runs: Runs, quick: bool) -> dict[str, Any]:
    """Return the numbers of `NAMES` of each kind of race by seed."""
    numbers: dict[str, Any] = {}
    for kind, each in runs.items():
        world = kind.split(",")[0]
        races = runs[kind.removesuffix(YOKED).removesuffix(RACE) + RACE]
        numbers |= payoffs_of(kind, each)
        met = [*races[1:], races[0]] if kind.endswith(YOKED) else races
        for team in TEAMS:
            of_team = {
                "gain": [gain(scores, team) for scores in rates(numbers, kind)],
                "met": [gain_against_met(team, *pair) for pair in zip(each, met, strict=True)],
                "common": [against_common(team, seed, run, races) for seed, run in enumerate(each)],
            }
            if world in EXACT:
                rises = np.array([exact_rises(team, run) for run in each])
                of_team |= {"perfect": rises[:, 0], "guaranteed": rises[:, 1]}
            numbers |= {f"{kind} / {team}_{name}": of_team[name] for name in of_team}
    return numbers


def gain(rates: NDArray[np.float32], team: Team) -> float:
    """Return a team's gain in the whole race, from single episodes (n, m, episodes)."""
    payoffs = analysis.read_payoffs(rates, per_episode=True)
    return float(analysis.MEASURES[f"{team}_gain"].of(payoffs, "whole").value)


def gain_against_met(team: Team, run: SavedRun, met: SavedRun) -> float:
    """Return a team's gain against the other team of the race that it met in training."""
    settings, teams = run.settings, {team: run.teams[team], other(team): met.teams[other(team)]}
    sides, episodes = (teams["pursuer"], teams["evader"]), settings.evaluation_episodes
    payoff = tournament(settings.game.world, *sides, seed=settings.seed, episodes=episodes)
    return gain(payoff.scores, team)


def late(run: SavedRun, team: Team) -> slice:
    """Return the last fifth of a team's generations."""
    count = len(run.teams[team].genomes)
    return slice(count - max(1, count // 5), count)


def against_common(team: Team, seed: int, run: SavedRun, races: Sequence[SavedRun]) -> float:
    """Return how much a team's last fifth is better than generation 0, against other races.

    The opponents are every fifth generation of the races of other seeds, without the next seed,
    whose race the yoked one replays.
    """
    strange = [race for number, race in enumerate(races) if (number - seed) % len(races) > 1]
    pools = [race.teams[other(team)].genomes[::EVERY] for race in strange or races]
    own = run.teams[team]
    chosen = np.concatenate([own.genomes[:1], own.genomes[late(run, team)]])
    teams = (mw.Population(each, own.policy) for each in (chosen, np.concatenate(pools)))
    scores = scores_against(run.settings.game.world, team, *teams, seed=seed, episodes=EPISODES)
    first, *last = scores.mean(axis=1)
    return float(np.mean(last) - first)


def exact_rises(team: Team, run: SavedRun) -> NDArray[np.float64]:
    """Return how much a team's last fifth is better than generation 0, exactly (2,).

    Against perfect play, and against the best response to each generation: what it guarantees.
    """
    solution, policy = solved(run.settings.game.world), run.teams[team]
    rates = []
    for genome in [policy.genomes[0], *policy.genomes[late(run, team)]]:
        champion = mw.Population(genome[np.newaxis], policy.policy)
        pair = (champion, solution) if team == "pursuer" else (solution, champion)
        responded = best_response(solution.states, champion, team).value
        rates.append((expected_payoff(solution.states, *pair), responded))
    # Captures are what pursuers want, and evaders do not.
    rises = np.mean(rates[1:], axis=0) - rates[0]
    return rises if team == "pursuer" else -rises


def verdict(p: float, difference: analysis.Estimate) -> str:
    """Return which kind is higher, by the adjusted p-value and the interval of a difference."""
    if p < SIGNIFICANCE:
        return "race higher" if difference.value > 0 else "yoked higher"
    if difference.low is None:  # seeds that all agree do not show how much others differ
        return "cannot tell"
    return "alike" if max(-difference.low, difference.high) < MARGIN else "cannot tell"


def table(numbers: Numbers) -> str:
    """Return the comparison of both kinds of race in each world, in Markdown."""
    worlds = [kind.removesuffix(f", {RACE}") for kind in kinds_in(numbers)]
    return "\n\n".join(of_world(numbers, each) for each in worlds if not each.endswith(YOKED))


def of_world(numbers: Numbers, world: str) -> str:
    """Return the comparison of both kinds of race in a world."""
    names = [name for name in NAMES if f"{world}, {RACE} / {name}" in numbers]
    values = {
        kind: {name: numbers[f"{world}, {kind} / {name}"] for name in names}
        for kind in (RACE, YOKED)
    }
    differences = {name: values[RACE][name] - values[YOKED][name] for name in names}
    rows = []
    for name, p in adjusted(differences).items():
        means, (difference,) = (
            [analysis.interval_over_runs(each, bounds=(-1.0, 1.0)) for each in of]
            for of in ([values[kind][name] for kind in values], [differences[name]])
        )
        told = [written(difference, sign="+"), shown_p(p), f"**{verdict(p, difference)}**"]
        rows.append([NAMES[name], *map(written, means), *told])
    count = len(differences[names[0]])
    heads = [f"mean over {count} seeds [95%]", RACE, YOKED, "difference", "Holm |"]
    judged = {
        kind: analysis.judge(rates(numbers, f"{world}, {kind}"), per_episode=True).windows["whole"]
        for kind in (RACE, YOKED)
    }
    verdicts = [
        [name, *(
            f"{of_kind[name].verdict}; {of_kind[name].by_run.count('present')} of {count}"
            for of_kind in judged.values()
        )]
        for name in judged[RACE]
    ]  # fmt: skip
    told = "judgement of all seeds, whole race; seeds in which it is present"
    return "\n\n".join(
        [f"### {world}", markdown(heads, rows), markdown([told, RACE, YOKED], verdicts)]
    )


if __name__ == "__main__":
    experiment(__doc__, kinds=kinds, then=yoked, play=play, measure=measured, table=table, seeds=10)
