"""Does competing teach what nobody learns alone? Races, and the same learner against a fixed crowd.

    python evolution/learning_or_competing.py --threads 2   all kinds, two hours of one core
    python evolution/learning_or_competing.py --quick       two seeds of short races, some seconds

"Became stronger" has two parts. A learner becomes stronger whomever it meets: that is its own
curve. In a race it meets opponents that answer, which may teach more. The control is the same
learner with the same number of epochs and matches, whose opponents do not answer:

- *script*: the best script of the other team, careful ones included;
- *mixture*: ratings that play like three scripts each, and none of them exactly;
- *last*: the last generation of the generalists' race of the next seed;
- *hall*: all 31 generations of that race, one by chance in each epoch;
- *yoked*: the generations of that race as they were at the same time (`yoked_races.py`).

In each of these runs both teams learn, each by itself. Races are those of *specialists*, who meet
the newest generation, *generalists*, who meet all earlier ones by chance, *halls of fame* and
*psro*. Learners are CMA-ES (cma), an evolution strategy with mirrored samples (es) and a genetic
algorithm (ga); policies rate moves by the usual inputs; in MW-25 without `ahead`, since exact play
follows no draws of an episode. A team learns from 14,400 matches in 30 generations, in a hall of
fame from 21,600. In MW-25 each world has two runs of a kind, and the units are worlds; elsewhere
they are seeds. In S and O of the paper a team learns from 7,200 matches, and only generalists and
three controls are played; es and ga are not played in park, and psro has three seeds there and in
courtyard.

Measured is a team's last fifth of generations, without a choice among them: against held-out
opponents (scripts, careful ones too, and evolved networks); against *champions*, generations 10, 20
and 30 of the generalists' races by cma of seeds that neither the run nor its control has met; in
MW-25 exactly, as the share of perfect play that is guaranteed. A *rise* is that of the last fifth
over generation 0. All runs are judged as `matrixworld judge` judges races.

Expected, before any of these races was played:

1. Against held-out opponents the generalists' race is not better than the mixture: the whole
   interval of the difference lies below .05, for both teams, with cma, in courtyard, thicket, park.
2. Against champions it is, for evaders: the interval lies above 0 in two of the three worlds.
3. Answers do not matter: race and yoked race are alike (within .05), for both teams, in the three
   worlds and for each learner.
4. At least 80 % of the rise of the race, against champions, is reached against the mixture.
5. The judgement finds an arms race in at least half of the runs of the mixture by es, in which
   nobody competes; and by cma in at most one of ten, race or mixture.
6. In MW-25 the races guarantee more than the teams that learned against a script: by .05 of perfect
   play, both teams.
7. Stated later, when parts of thicket were known: with half of the epochs (*slow es*, the settings
   by which `matrixworld evolve` played before) the judgement finds an arms race in at least half
   of the races, and in at least half of the runs of the mixture, in courtyard and thicket.

Differences are between runs of the same seed or world, with their 95 % interval (Student's t);
p-values are adjusted for the rows of a table (Holm). *Alike* means that the whole interval lies
within .05.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

import matrixworld as mw
from common import (
    Numbers,
    Runs,
    adjusted,
    experiment,
    kept,
    kinds_in,
    markdown,
    mean,
    scores_against,
)
from matrixworld import analysis
from matrixworld.coevolution import TEAMS, RaceSettings, Run, SavedRun, Team, Training, create
from matrixworld.coevolution import evolve as play_race
from matrixworld.coevolution.evaluation.held_out import opponents_of
from matrixworld.coevolution.evaluation.held_out_matches import play_held_out
from matrixworld.coevolution.types import other
from matrixworld.solver import best_response
from matrixworld.world.policy import CAREFUL, SCRIPTS
from yoked_races import YokedTraining, late, verdict

SPECIALISTS, GENERALISTS, HALLS, PSRO = "specialists", "generalists", "halls of fame", "psro"
SCHEDULES: dict[str, dict[str, Any]] = {
    SPECIALISTS: {"schedule": "specialist-specialist"},
    GENERALISTS: {
        "schedule": "alternating",
        "schedule.pursuers_meet": "uniform",
        "schedule.evaders_meet": "uniform",
    },
    HALLS: {"schedule": "hall-of-fame"},
    PSRO: {"schedule": "psro"},
}
SCRIPT, MIXTURE, LAST, HALL, YOKED = "script", "mixture", "last", "hall", "yoked"
FIXED = (SCRIPT, MIXTURE, LAST, HALL)
CONTROLS = (*FIXED, YOKED)

WORLDS = ("courtyard", "thicket", "park")
PAPER = {
    "S": {"world.rules": "S", "world.n_pursuers": 20, "world.n_evaders": 5},
    "O": {"world.rules": "O"},
}
SUITE = {f"MW-25 {number}": world for number, world in enumerate(mw.SUITE.worlds, start=1)}
BEST: dict[str, dict[Team, str]] = {
    "courtyard": {"pursuer": "careful-hunter", "evader": "careful-dodger"},
    "thicket": {"pursuer": "careful-hunter", "evader": "fleer"},
    "park": {"pursuer": "careful-hunter", "evader": "dodger"},
    "S": {"pursuer": "careful-team-surrounder", "evader": "fleer"},
    "O": {"pursuer": "careful-hunter", "evader": "dodger"},
}
"""The best script of each team against held-out opponents, careful ones included."""
LIKE_SCRIPTS: dict[Team, tuple[dict[str, float], ...]] = {
    "pursuer": (
        {"adversary": -1.0, "room": 0.1},
        {"unclaimed": -1.0, "adversary": -0.1},
        {"open_side": -1.0, "teammate": 0.1},
    ),
    "evader": (
        {"adversary": 1.0, "exits": 0.5},
        {"pressure": -1.0, "room": 0.1},
        {"adversary": 1.0, "teammate": 0.3},
    ),
}
"""Weights of the ratings of a mixture."""

RATINGS = {"policy": "rating", "policy.initial_weight": 0.2, "evaluation_episodes": 6}
LEARNERS: dict[str, dict[str, Any]] = {
    "cma": {"learner": "cma", "learner.population": 12, "match_episodes": 4},
    "es": {
        "learner": "es", "learner.population": 12, "learner.sigma": 0.3,
        "learner.learning_rate": 0.0025, "match_episodes": 1,
    },
    "slow es": {},
    "ga": {
        "learner": "ga", "learner.population": 12, "learner.mutation": 0.2, "match_episodes": 4,
    },
}  # fmt: skip
LEARNERS["slow es"] = LEARNERS["es"]
EPOCHS = {"cma": 10, "es": 40, "slow es": 20, "ga": 10}
"""Epochs of a team in a generation, in which it has 480 matches, by the slow strategy 240."""
SEEDS = {**dict.fromkeys(WORLDS, 10), **dict.fromkeys(SUITE, 2), **dict.fromkeys(PAPER, 3)}
QUICK = {"schedule.generations": 4, "learner.population": 4, "evaluation_episodes": 2}

CURVE = (0, 1, 2, 3, 5, 8, 12, 16, 20)
"""Generations that are measured, beside the last fifth."""
CHAMPIONS = (10, 20, 30)
"""Generations that other runs meet when they are measured."""
FOUND = ("arms race", "one-sided progress", "disengagement")
"""What the judgement may find; "arms race" is told as "both teams improved"."""
WORDS = {"race higher": "higher", "yoked higher": "lower"}
"""What is told of a difference, by the words of `yoked_races.verdict`."""
EPISODES = 8
"""Episodes against each champion, and against each held-out opponent."""


# Runs:


def settings_of(place: str, learner: str, schedule: str, quick: bool) -> RaceSettings:
    """Return the settings of a race in a place, by a learner, with a schedule."""
    epochs = 1 if quick else EPOCHS[learner]
    if place in PAPER:
        world = {**PAPER[place], "world.max_steps": 200, "train_steps": 200}
        epochs = -(-epochs // 2)
    elif place in SUITE:
        config = SUITE[place].config
        inputs = tuple(name for name in mw.Rating.inputs if name != "ahead")
        world = {"world": config, "train_steps": config.max_steps, "policy.inputs": inputs}
    else:
        world = {"world": place}
    changes = {**SCHEDULES[schedule], **RATINGS, **LEARNERS[learner], **world}
    if schedule == HALLS:
        changes["schedule.joint_epochs"] = -(-epochs // 2)
    else:
        changes |= {f"schedule.{team}_epochs": epochs for team in TEAMS}
    return RaceSettings.of(changes, QUICK if quick else {})


def kinds(quick: bool) -> dict[str, RaceSettings]:
    """Return the settings of the races of all places, learners and schedules."""
    found = {}
    for place in ("thicket", *[*SUITE][:1]) if quick else (*WORLDS, *SUITE, *PAPER):
        for learner in LEARNERS:
            for schedule in SCHEDULES:
                if schedule != GENERALISTS and (learner != "cma" or place in PAPER):
                    continue  # other schedules by cma alone
                if learner != "cma" and (place in PAPER or place == "park"):
                    continue
                if learner == "slow es" and place in SUITE:
                    continue
                settings = settings_of(place, learner, schedule, quick)
                found[f"{place}, {learner}, {schedule}"] = settings
    return found


def seeds_of(kind: str) -> int:
    """Return how many runs of a kind are played; psro takes many matches outside of learning."""
    place, _, schedule = kind.split(", ")
    return 3 if schedule == PSRO and place in ("courtyard", "park") else SEEDS[place]


@dataclass(frozen=True)
class Control:
    """A run in which both teams learn, each against opponents that do not answer."""

    settings: RaceSettings
    place: str
    control: str
    race: Path  # whose generations are met


class FixedTraining(Training):
    """Training in turns in which each team meets opponents that are `given`."""

    def __init__(self, *args: Any, given: Mapping[Team, Any], **options: Any) -> None:
        super().__init__(*args, **options)
        self.given = given

    def opponents(self, team: Team) -> Any:
        """Return whom a team meets."""
        return self.given[team]


def given(planned: Control) -> dict[Team, Any]:
    """Return whom each team meets in a control."""
    game = planned.settings.game
    found: dict[Team, Any] = {}
    for team in TEAMS:
        rival = other(team)
        if planned.control == SCRIPT:
            found[team] = best_script(planned.place, rival)
        elif planned.control == MIXTURE:
            like, policy = LIKE_SCRIPTS[rival], game.policy.policy(game.world, rival)
            weights = [[each.get(name, 0.0) for name in policy.inputs] for each in like]
            found[team] = mw.Population(np.array(weights, np.float32), policy)
        else:
            archive = SavedRun(planned.race).teams[rival]
            genomes = archive.genomes[-1:] if planned.control == LAST else archive.genomes
            found[team] = mw.Population(genomes, archive.policy)
    return found


def best_script(place: str, team: Team) -> str:
    """Return the best script of a team in a place; in MW-25 of those that count no steps."""
    if place not in SUITE:
        return BEST[place][team]
    scripts = SUITE[place].scripts(team)
    sign = 1 if team == "pursuer" else -1
    stepless = (name for name in scripts if not name.startswith(CAREFUL))
    return max(stepless, key=lambda name: sign * scripts[name])


def play(planned: RaceSettings | Control, directory: Path, *, threads: int) -> SavedRun:
    """Play what is left of a race, or of a control."""
    if isinstance(planned, RaceSettings):
        return play_race(planned, directory, threads=threads)
    create(planned.settings, directory)
    training: Any
    if planned.control == YOKED:
        training = partial(YokedTraining, replayed=SavedRun(planned.race).archive())
    else:
        training = partial(FixedTraining, given=given(planned))
    Run(directory, threads=threads, training=training).run()
    return SavedRun(directory)


def controls(runs: Runs, quick: bool) -> dict[str, list[Control]]:
    """Return the controls of all races of generalists that have been played."""
    found: dict[str, list[Control]] = {}
    for kind, races in runs.items():
        place, learner, schedule = kind.split(", ")
        if schedule != GENERALISTS:
            continue
        strange = [*races[1:], races[0]]
        for control in CONTROLS:
            if (learner != "cma" or place in PAPER) and control in (SCRIPT, HALL):
                continue
            if learner == "slow es" and control == LAST:
                continue
            found[f"{place}, {learner}, {control}"] = [
                Control(race.settings, place, control, met.path.absolute())
                for race, met in zip(races, strange, strict=True)
            ]
    return found


# Measures:


def measured(runs: Runs, quick: bool) -> dict[str, Any]:
    """Return the numbers of each kind by seed, and the judgement of all its seeds together.

    Whole curves stay in the files beside the runs.
    """
    numbers: dict[str, Any] = {}
    for kind, each in runs.items():
        place, _, _ = kind.split(", ")
        if place in SUITE:
            found = [kept_numbers(run, "guarantees", guarantees, place) for run in each]
        else:
            champions = runs.get(f"{place}, cma, {GENERALISTS}", each)
            found = [
                kept_numbers(run, "held_out", against_held_out)
                | kept_numbers(run, "champions", against_champions, seed, champions)
                | kept_numbers(run, "judged", judged)
                for seed, run in enumerate(each)
            ]
            scores = np.stack([run.payoff().scores for run in each])
            numbers[f"judgement of {kind}"] = present(scores)
        for name in (each for each in found[0] if not each.endswith("curve")):
            numbers[f"{kind} / {name}"] = np.array([of_run[name] for of_run in found])
    return numbers


def kept_numbers(run: SavedRun, name: str, measure: Any, *given: Any) -> dict[str, Any]:
    """Return the numbers of a run; a file beside it keeps them."""
    file = run.path.with_name(f"{run.path.name}.{name}.json")
    return kept(file, partial(measure, run, *given))


def measured_generations(run: SavedRun, team: Team) -> tuple[list[int], int]:
    """Return the generations that are measured, and how many of them are those at the end."""
    last = range(*late(run, team).indices(len(run.teams[team].genomes)))
    return [*(each for each in CURVE if each < last.start), *last], len(last)


def of_curve(name: str, curve: NDArray[np.float64], n_last: int) -> dict[str, Any]:
    """Return a curve, the mean of its last fifth, and the rise of this over generation 0."""
    end = float(np.mean(curve[-n_last:]))
    return {f"{name} curve": curve.tolist(), f"{name} end": end, f"{name} rise": end - curve[0]}


def against_held_out(run: SavedRun) -> dict[str, Any]:
    """Return the scores of both teams against held-out opponents."""
    world = run.settings.game.world
    found: dict[str, Any] = {}
    for team in TEAMS:
        chosen, n_last = measured_generations(run, team)
        own = run.teams[team]
        genomes = mw.Population(own.genomes[chosen], own.policy)
        opponents = held_out_of(team, world)
        rates = play_held_out(world, team, genomes, opponents, episodes=EPISODES, seed=0, threads=1)
        found |= of_curve(f"{team} held-out", rates.mean(axis=(1, 2)), n_last)
    return found


def held_out_of(team: Team, world: mw.WorldConfig) -> dict[str, Any]:
    """Return the held-out opponents of a team, and careful versions of the scripts among them."""
    opponents, _ = opponents_of(team, world)
    careful = (f"{CAREFUL}{name}" for name in opponents)
    return {**opponents, **{name: name for name in careful if name in SCRIPTS}}


def against_champions(run: SavedRun, seed: int, races: Sequence[SavedRun]) -> dict[str, Any]:
    """Return the scores of both teams against the champions of races of other seeds.

    Without the race of the next seed, whose generations a control meets.
    """
    strange = [race for number, race in enumerate(races) if (number - seed) % len(races) > 1]
    world = run.settings.game.world
    found: dict[str, Any] = {}
    for team in TEAMS:
        chosen, n_last = measured_generations(run, team)
        own = run.teams[team]
        rivals = [race.teams[other(team)] for race in strange or races]
        last = len(rivals[0].genomes) - 1
        met = [min(generation, last) for generation in CHAMPIONS]
        pool = np.concatenate([rival.genomes[met] for rival in rivals])
        teams = (mw.Population(own.genomes[chosen], own.policy), mw.Population(pool, own.policy))
        scores = scores_against(world, team, *teams, seed=seed, episodes=EPISODES)
        found |= of_curve(f"{team} champions", scores.mean(axis=1), n_last)
    return found


def guarantees(run: SavedRun, place: str) -> dict[str, Any]:
    """Return what share of perfect play both teams guarantee, exactly."""
    world = SUITE[place]
    found: dict[str, Any] = {}
    for team in TEAMS:
        chosen, n_last = measured_generations(run, team)
        own = run.teams[team]
        champions = (mw.Population(own.genomes[[each]], own.policy) for each in chosen)
        rates = np.array([best_response(world.perfect.states, c, team).value for c in champions])
        value = world.value
        shares = rates / value if team == "pursuer" else (1.0 - rates) / (1.0 - value)
        found |= of_curve(f"{team} exact", shares, n_last)
    return found


def present(scores: NDArray[np.float32]) -> list[str]:
    """Return what the judgement finds in whole races: (..., G, H, episodes)."""
    return [*analysis.judge(scores, per_episode=True).present("whole")]


def judged(run: SavedRun) -> dict[str, Any]:
    """Return what the judgement finds in a single run, as 1 or 0."""
    found = present(run.payoff().scores)
    return {name: float(name in found) for name in FOUND}


# Tables:


def of_team(numbers: Numbers, kind: str, number: str) -> NDArray[np.float64]:
    """Return a number of a kind, by seed; in MW-25 the means of worlds, by world."""
    place, rest = kind.split(", ", 1)
    if place != "MW-25":
        return numbers[f"{kind} / {number}"]
    every = [numbers.get(f"{each}, {rest} / {number}") for each in SUITE]
    return np.array([each.mean() for each in every if each is not None])


def rest_of(numbers: Numbers, place: str) -> list[str]:
    """Return the learners and kinds that have been measured in a place."""
    of_place = f"{place} " if place == "MW-25" else f"{place}, "
    found = [kind.split(", ", 1)[1] for kind in kinds_in(numbers) if kind.startswith(of_place)]
    return [*dict.fromkeys(found)]


def table_of_place(numbers: Numbers, place: str) -> str:
    """Return all kinds of a place, and how far each is from the generalists' race."""
    measures = ("exact",) if place == "MW-25" else ("held-out", "champions")
    values, differences = {}, {}
    for rest in rest_of(numbers, place):
        learner, arm = rest.split(", ")
        for measure in measures:
            for team in TEAMS:
                key = rest, measure, team
                values[key] = of_team(numbers, f"{place}, {rest}", f"{team} {measure} end")
                if arm != GENERALISTS:
                    race = f"{place}, {learner}, {GENERALISTS}"
                    than = of_team(numbers, race, f"{team} {measure} end")
                    differences[key] = values[key] - than[: len(values[key])]
    p_values = adjusted(differences)
    rows = []
    for rest in rest_of(numbers, place):
        cells = []
        for measure in measures:
            for team in TEAMS:
                key = rest, measure, team
                cells.append(mean(values[key], bounds=(0.0, 1.0)))
                if key in differences:
                    difference = analysis.interval_over_runs(differences[key])
                    said = WORDS.get(told := verdict(p_values[key], difference), told)
                    cells[-1] += f"; {mean(differences[key], sign='+')} {said}"
        rows.append([rest, *cells])
    units = len(values[next(iter(values))])
    heads = [f"{place}, {units} {'worlds' if place == 'MW-25' else 'seeds'}"]
    heads += [f"{team}s, {measure}" for measure in measures for team in TEAMS]
    return markdown(heads, rows)


def curves(numbers: Numbers) -> str:
    """Return which share of the race's rise each control reaches, and what is found in the runs."""
    rows = []
    for kind in kinds_in(numbers):
        place, learner, _ = kind.split(", ")
        if place in SUITE:
            continue
        shares = []
        for team in TEAMS:
            own = numbers[f"{kind} / {team} champions rise"]
            race = numbers[f"{place}, {learner}, {GENERALISTS} / {team} champions rise"]
            shares.append(f"{own.mean():.3f} ({own.mean() / race.mean():.0%})")
        single = [f"{numbers[f'{kind} / {name}'].sum():.0f}" for name in FOUND]
        together = ", ".join(numbers[f"judgement of {kind}"]) or "cannot tell"
        rows.append([kind, *shares, f"{len(own)}", " / ".join(single), together])
    heads = ["", *(f"rise of {team}s (share of the race's)" for team in TEAMS), "seeds"]
    heads += [f"found in single runs: {' / '.join(FOUND)}", "in all together"]
    return markdown(heads, rows).replace("|  |", "| |", 1)


def table(numbers: Numbers) -> str:
    """Return what all kinds reach in each place, rises, and what is found, in Markdown."""
    places = [place for place in (*WORLDS, *PAPER, "MW-25") if rest_of(numbers, place)]
    parts = [
        "Means of the last fifth of generations [95 %]; then differences from the generalists' "
        "race by the same learner, with Holm's adjustment over the table.",
        *(table_of_place(numbers, place) for place in places),
        "Rises against champions, and what the judgement finds:",
        curves(numbers),
    ]
    return "\n\n".join(parts)


def counted(text: str, word: str, *verdicts: str) -> tuple[int, int]:
    """Return how many differences of the table in `WORLDS` have one of some verdicts, of how many.

    Of the rows whose first cell is `word`, or begins or ends with it.
    """
    lines = text.split("| S, ")[0].splitlines()
    rows = [[each.strip() for each in line.strip("|").split("|")] for line in lines]
    of_word = [row[1:] for row in rows if f", {word}, " in f", {row[0]}, "]
    found = [each.split("] ")[-1] for row in of_word for each in row if ";" in each]
    return sum(each in verdicts for each in found), len(found)


def shares(numbers: Numbers, *learners: str) -> list[float]:
    """Return the shares of the race's rises against champions that mixtures bring in `WORLDS`."""
    return [
        float(numbers[f"{kind} / {team} champions rise"].mean() / race.mean())
        for kind in kinds_in(numbers)
        for place, learner, arm in [kind.split(", ")]
        if place in WORLDS and learner in learners and arm == MIXTURE
        for team in TEAMS
        for race in [numbers[f"{place}, {learner}, {GENERALISTS} / {team} champions rise"]]
    ]


def arms_races(numbers: Numbers, *kinds: str) -> tuple[int, int]:
    """Return in how many single runs of some kinds an arms race is found, of how many."""
    found = np.concatenate([numbers[f"{kind} / arms race"] for kind in kinds])
    return int(found.sum()), len(found)


if __name__ == "__main__":
    experiment(
        __doc__,
        kinds=kinds,
        then=controls,
        play=play,
        measure=measured,
        table=table,
        seeds={kind: seeds_of(kind) for kind in kinds(False)},
    )
