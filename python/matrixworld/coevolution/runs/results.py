"""The results of a run at its end: who plays the evaluation, and what summary.json holds."""

from __future__ import annotations

from typing import Any

import numpy as np

from matrixworld.analysis import disengagements, intervals
from matrixworld.analysis.progress import Disengagement
from matrixworld.coevolution.games.pursuit import PursuitSettings
from matrixworld.coevolution.games.tournament import tournament
from matrixworld.coevolution.progress import Report
from matrixworld.coevolution.settings.schedules import Against
from matrixworld.coevolution.training.training import Training
from matrixworld.coevolution.types import TEAMS, FloatArray, Payoff, Team, other


def evaluate(training: Training, known: Payoff | None, report: Report) -> Payoff:
    """Play the finalists of one team against those of the other, on episodes of their own.

    What is `known` of a race that was shorter is not played again.
    """
    finalists = finalists_of(training)
    pursuers, g = finalists["pursuer"]
    evaders, h = finalists["evader"]
    return tournament(
        training.settings.evaluation_game,
        pursuers,
        evaders,
        seed=training.settings.seed,
        episodes=training.settings.evaluation_episodes,
        threads=training.threads,
        generations=(g, h),
        known=known,
        report=report,
    )


def finalists_of(training: Training) -> dict[Team, tuple[Any, int]]:
    """Return who plays the evaluation for each team, and the generation of the first.

    Of a race all generations of both teams; of a team alone its last one, and all its opponents, or
    all its generations against the best response.
    """
    schedule = training.settings.schedule
    if not isinstance(schedule, Against):
        return {team: (training.population(team, training.genomes(team)), 0) for team in TEAMS}
    team = schedule.team
    first = 0 if training.settings.exact else schedule.n_stages
    own = training.population(team, training.genomes(team)[first:])
    return {team: (own, first), other(team): (training.opponents(team), 0)}


def disengagements_of(training: Training, stage_scores: list[float]) -> tuple[Disengagement, ...]:
    """Return the stretches of finished generations in which one team won everything."""
    game = training.settings.game
    if not training.settings.is_race or game.symmetric or game.general:
        return ()
    stages = training.settings.schedule.stages_per_generation
    finished = len(stage_scores) // stages
    rates = np.array(stage_scores[: finished * stages]).reshape(finished, stages)
    # If a stage is a generation, both phases have its rate.
    return disengagements(np.broadcast_to(rates, (finished, 2)))


def summary_of(training: Training, stage_scores: list[float], payoff: Payoff) -> dict[str, Any]:
    """Return the most important numbers of a run, which summary.json holds."""
    summary = {
        "stages": training.stage,
        **{f"training_{name}": count for name, count in training.counts.items()},
        "evaluation_matches": training.game.pairs_of(*payoff.matrix.shape) * payoff.scores.shape[2],
    }
    if not training.settings.is_race:
        return {**summary, **_means_of(training, payoff)}
    stretches = disengagements_of(training, stage_scores)
    teams = training.settings.teams
    return {**summary, "disengagement": [stretch.in_words(teams) for stretch in stretches]}


def _means_of(training: Training, payoff: Payoff) -> dict[str, Any]:
    """Return the last generation's mean score and, of episodes of pursuit, length, with intervals.

    The keys of a number are its name, and ``<name>_low``, ``<name>_high`` and ``<name>_std``.
    """
    score, *_ = training.game.columns
    pursuers = "pursuer" in training.settings.learning_teams
    last = np.s_[-1:] if pursuers else np.s_[:, -1:]
    rows = [(score, payoff.scores[last], 1.0)]
    if payoff.others is not None:
        rows.append(("other_score", payoff.others[last], 1.0))
    game = training.settings.game
    if isinstance(game, PursuitSettings) and not training.settings.exact:
        rows.append(("length", payoff.extras["lengths"][last], game.world.max_steps))
    means: dict[str, Any] = {}
    for name, episodes, most in rows:
        values = np.asarray(episodes, dtype=np.float64).ravel()
        low, high = _interval(values, most)
        means[name] = float(values.mean())
        means[f"{name}_low"] = low
        means[f"{name}_high"] = high
        means[f"{name}_std"] = float(values.std())
    return means


def _interval(values: FloatArray, most: float) -> tuple[float | None, float | None]:
    """Return the ends of Student's t interval of a mean, clipped to 0 and `most`.

    They are None if the values do not differ: such say nothing of their spread, and the interval
    would have a width of 0.
    """
    if intervals.does_not_vary(values):
        return None, None
    return intervals.t_ends(values, intervals.LEVEL, (0.0, most))
