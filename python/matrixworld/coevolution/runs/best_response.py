"""Best responses: how much a newly evolved opponent gains against a champion."""

from __future__ import annotations

from dataclasses import dataclass, fields, replace
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from matrixworld._util.files import save_json
from matrixworld._util.short_repr import short_repr
from matrixworld.analysis import ResponseGain, response_gain
from matrixworld.coevolution.evaluation.tournament import tournament
from matrixworld.coevolution.progress import Report, silent
from matrixworld.coevolution.runs.single import SingleTeam
from matrixworld.coevolution.runs.start import resume
from matrixworld.coevolution.settings.single import SINGLE_DEFAULTS, SingleSettings
from matrixworld.coevolution.storage.run_directory import CONFIG
from matrixworld.coevolution.storage.saved_run import SavedRun
from matrixworld.coevolution.types import FloatArray, Team, other
from matrixworld.play.rollout import Rollout, rollout
from matrixworld.world.policy import Population, TeamPolicy

RESPONSE = "best_response.json"
POPULATION = 48
"""Candidates per epoch: with few matches, many small steps learn more than few large ones."""

# Settings that a response takes from the run of the champion.
WORLD = ("variant", "rows", "cols", "pursuers", "evaders", "obstacles", "fov", "diagonal")
POLICY = ("hidden", "activation")
EVALUATION = ("eval_steps", "seed")


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


def response_settings(run: SavedRun, team: Team, matches: int, **changes: Any) -> SingleSettings:
    """Return the settings of a response to the champion of `team` in a run.

    World, network, evaluation and seed are those of the run, and `epochs` is as large as the budget
    in matches allows: ValueError if it is smaller than one epoch. Training episodes are not longer
    than evaluation episodes. All other settings have their defaults, or the values in `changes`.
    """
    learner = other(team)
    same = {name: getattr(run.settings, name) for name in (*WORLD, *POLICY, *EVALUATION)}
    steps = min(int(SINGLE_DEFAULTS[learner]["train_steps"]), run.settings.eval_steps)
    chosen = {**same, "population": POPULATION, "train_steps": steps, **changes}
    one_epoch = int(chosen["population"]) * int(chosen.get("worlds", 1))
    if matches < one_epoch:
        raise ValueError(f"matches: expected at least {one_epoch} (one epoch), got {matches}")
    return SingleSettings(team=learner, epochs=matches // one_epoch, **chosen)


def start_response(
    run: SavedRun,
    team: Team,
    settings: SingleSettings,
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
    response: SingleTeam, settings: SingleSettings, champion: Population, path: Path
) -> None:
    # The opponents' genomes are compared, wherever they came from.
    expected = replace(settings, against=response.settings.against)
    # Reversed, so that a message names fields of `SingleSettings` itself before inherited ones.
    for name in (item.name for item in reversed(fields(SingleSettings))):
        found, wanted = getattr(response.settings, name), getattr(expected, name)
        if found != wanted:
            raise ValueError(f"{path}: holds a run with {name} {found!r}, expected {wanted!r}")
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
        Settings of the response, such as ``population=128``.

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
    run: SavedRun, team: Team, settings: SingleSettings, threads: int | None, play: Rollout
) -> NDArray[np.float32]:
    """Play the last genomes of both teams of a run, on as many episodes as the response."""
    last = {name: _last(opponents) for name, opponents in run.teams.items()}
    return tournament(
        settings.world(settings.eval_steps),
        last["pursuer"],
        last["evader"],
        seed=settings.seed,
        episodes=settings.eval_episodes,
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
