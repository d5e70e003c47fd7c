"""Best responses: how much a newly evolved opponent gains against a champion."""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, cast

import numpy as np
from numpy.typing import NDArray

from matrixworld._util.files import save_json
from matrixworld._util.short_repr import short_repr
from matrixworld.analysis import response_gain
from matrixworld.analysis.games import ResponseGain
from matrixworld.coevolution.evaluation.tournament import tournament
from matrixworld.coevolution.learners.evolution_strategy import EvolutionStrategySettings
from matrixworld.coevolution.progress import Report, silent
from matrixworld.coevolution.runs.single import SingleTeam
from matrixworld.coevolution.runs.start import resume
from matrixworld.coevolution.schedules import Against
from matrixworld.coevolution.sections import different_settings
from matrixworld.coevolution.settings import PolicySettings, RaceSettings
from matrixworld.coevolution.storage.run_directory import CONFIG
from matrixworld.coevolution.storage.saved_run import SavedRun
from matrixworld.coevolution.types import FloatArray, Team, other
from matrixworld.play.rollout import Rollout, rollout
from matrixworld.world.policy import Population, TeamPolicy
from matrixworld.world.rules import Rewards

RESPONSE = "best_response.json"
POPULATION = 48
"""Candidates per epoch: with few matches, many small steps learn more than few large ones."""


@dataclass(frozen=True)
class BestResponse:
    """Result of a best response to a champion.

    Parameters
    ----------
    team : {"pursuer", "evader"}
        Team of the champion.
    before : ndarray of float64, shape (episodes,)
        Score of the champion's last opponent in its own run: the capture rate, or for evaders 1
        minus it.
    after : ndarray of float64, shape (episodes,)
        Score of the response, in episodes that were not used in its training.
    gain : ResponseGain
        Difference of the two means, with an interval and the budget in matches.
    directory : Path
        Run directory of the response.
    """

    team: Team
    before: FloatArray
    after: FloatArray
    gain: ResponseGain
    directory: Path

    __repr__ = short_repr

    def to_json(self) -> dict[str, Any]:
        """Return the result as values that JSON can hold, without the single episodes."""
        gain = self.gain.gain
        return {
            "champion": self.team,
            "budget_matches": self.gain.budget,
            "evaluation_matches": len(self.before) + len(self.after),
            "before": float(self.before.mean()),
            "after": float(self.after.mean()),
            "gain": {"value": gain.value, "low": gain.low, "high": gain.high},
        }


def response_settings(
    run: SavedRun, team: Team, matches: int, *, opponent: str = "random", **changes: Any
) -> RaceSettings:
    """Return the settings of a response to the champion of `team` in a run.

    World, network, evaluation and seed are those of the run, and `epochs` is as large as the budget
    in matches allows: ValueError if it is smaller than one epoch. Training episodes are not longer
    than evaluation episodes. All other settings have their defaults, or the values in `changes`,
    which are fields of `RaceSettings`. Of a schedule `Against` only `archive_every` counts.
    """
    # Rewards and mask of the champion's run are not taken over.
    chosen: dict[str, Any] = {
        "world": replace(run.settings.world, rewards=Rewards()),
        "policy": PolicySettings(
            hidden=run.settings.policy.hidden, activation=run.settings.policy.activation
        ),
        "learner": EvolutionStrategySettings(population=POPULATION),
        "seed": run.settings.seed,
        **changes,
    }
    alone: Any = chosen.pop("schedule", Against())
    schedule = replace(alone, team=other(team), opponent=opponent, epochs=None)
    usual = RaceSettings(schedule=schedule, learner=chosen["learner"]).train_steps
    chosen.setdefault("train_steps", min(usual, chosen["world"].max_steps))
    settings = RaceSettings(schedule=schedule, **chosen)
    one_epoch = settings.learner.population * settings.match_episodes
    if matches < one_epoch:
        raise ValueError(f"matches: expected at least {one_epoch} (one epoch), got {matches}")
    return replace(settings, schedule=replace(schedule, epochs=matches // one_epoch))


def start_response(
    run: SavedRun,
    team: Team,
    settings: RaceSettings,
    directory: str | Path,
    *,
    threads: int | None = None,
    play: Rollout = rollout,
) -> SingleTeam:
    """Return the run of a response to the champion of `team`: a new one, or one to continue.

    ValueError if the directory holds a run of other settings or against another champion, or if
    `team` did not learn in `run`.
    """
    champion = champion_of(run, team)
    path = Path(directory)
    if not (path / CONFIG).is_file():
        return SingleTeam(settings, path, opponents=champion, threads=threads, play=play)
    response = resume(path, threads=threads, play=play)
    if not isinstance(response, SingleTeam):
        raise ValueError(f"{path}: holds a race, expected a new directory")
    _check_same(response, settings, champion, path)
    return response


def champion_of(run: SavedRun, team: Team) -> Population:
    """Return the last genome of a team; ValueError if it did not learn in the run."""
    champion = _last(run.teams[team])
    if isinstance(champion, str):
        raise ValueError(f"team: expected one that learned in {run.files.path}, got {team!r}")
    return champion


def _check_same(
    response: SingleTeam, settings: RaceSettings, champion: Population, path: Path
) -> None:
    # The opponents' genomes are compared, wherever they came from.
    schedule = replace(cast(Against, settings.schedule), opponent=response.schedule.opponent)
    different = different_settings(response.settings, replace(settings, schedule=schedule))
    if different:
        raise ValueError(f"{path}: holds a run with other settings: {', '.join(different)}")
    opponents = response.opponents
    if isinstance(opponents, str) or not np.array_equal(opponents.genomes, champion.genomes):
        raise ValueError(f"{path}: holds a run against another champion, expected a new directory")


def best_response(
    run: SavedRun,
    team: Team,
    matches: int,
    directory: str | Path,
    *,
    threads: int | None = None,
    play: Rollout = rollout,
    report: Report = silent,
    **changes: Any,
) -> BestResponse:
    """Evolve a response to the last genome of `team` in a run, and measure its gain.

    The response starts untrained and plays against the champion only. It is a run of its own in
    `directory`: called again with the same arguments, the function continues an interrupted
    response, and only reads a finished one.

    Parameters
    ----------
    run : SavedRun
        The run of the champion.
    team : {"pursuer", "evader"}
        Team of the champion.
    matches : int
        Budget of the response. Only complete epochs are played; the result holds the budget used.
    directory : str or Path
        Directory of the response.
    threads, play
        As in `Run`.
    report : callable, optional
        Called with the progress, as in `Run.run`.
    **changes
        Fields of `RaceSettings` of the response, such as ``match_episodes=2``.

    Returns
    -------
    BestResponse
        Scores and gain.

    Raises
    ------
    ValueError
        If the budget is smaller than one epoch, a setting is bad, `team` did not learn in `run`, or
        the directory holds a run of other settings or against another champion.

    Notes
    -----
    The gain is a lower bound of the champion's exploitability (see `analysis.response_gain`): a
    longer search may find more.
    """
    settings = response_settings(run, team, matches, **changes)
    response = start_response(run, team, settings, directory, threads=threads, play=play)
    after = _score(response.run(report).capture_rates, team)
    before = _score(_before(run, team, settings, threads, play), team)
    gain = response_gain(before, after, budget=response.training.matches)
    result = BestResponse(team, before, after, gain, response.files.path)
    save_json(response.files.path / RESPONSE, result.to_json())
    return result


def _before(
    run: SavedRun, team: Team, settings: RaceSettings, threads: int | None, play: Rollout
) -> NDArray[np.float32]:
    """Play the last genomes of both teams of a run, on as many episodes as the response."""
    last = {name: _last(opponents) for name, opponents in run.teams.items()}
    return tournament(
        settings.world,
        last["pursuer"],
        last["evader"],
        seed=settings.seed,
        episodes=settings.evaluation_episodes,
        threads=threads,
        play=play,
    ).capture_rates


def _last(team: TeamPolicy) -> TeamPolicy:
    """Return the last genome of a team, or its script."""
    return team if isinstance(team, str) else Population(team.genomes[-1:], team.network)


def _score(capture_rates: NDArray[np.float32], champion: Team) -> FloatArray:
    """Return the scores (episodes,) of the champion's opponent."""
    # The opponent of an evader is a pursuer, whose score is the capture rate.
    captured = capture_rates.astype(np.float64).ravel()
    return captured if champion == "evader" else 1.0 - captured
