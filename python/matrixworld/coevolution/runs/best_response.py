"""A fresh best response, evolved against a frozen champion: how much can be taken from it?"""

from __future__ import annotations

from dataclasses import dataclass, fields, replace
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from matrixworld.analysis import ResponseGain, response_gain
from matrixworld.coevolution.evaluation.tournament import tournament
from matrixworld.coevolution.progress import Report, silent
from matrixworld.coevolution.runs.single import GIVEN, SingleTeam
from matrixworld.coevolution.settings import SINGLE_DEFAULTS, SingleSettings
from matrixworld.coevolution.storage.files import save_json
from matrixworld.coevolution.storage.run_directory import CONFIG
from matrixworld.coevolution.storage.saved_run import SavedRun
from matrixworld.coevolution.types import Team, other
from matrixworld.policy import Population, TeamPolicy
from matrixworld.rollout import Rollout, rollout

RESPONSE = "best_response.json"
POPULATION = 48
"""Candidates an epoch: with few matches many small steps learn more than few large ones."""

WORLD = ("variant", "rows", "cols", "pursuers", "evaders", "obstacles", "fov", "diagonal")
POLICY = ("hidden", "activation")
EVALUATION = ("eval_steps", "seed")


@dataclass(frozen=True)
class BestResponse:
    """What a best response to a champion came to.

    Attributes
    ----------
    team : the champion's.
    before : (episodes,) float64, what the opponent that the champion had scores against it: the
        capture rate, or for evaders one minus it.
    after : (episodes',) float64, the same of the response, in episodes that it was not evolved on.
    gain : difference of their means, with an interval and the budget in matches.
    directory : of the response's own run.
    """

    team: Team
    before: NDArray[np.float64]
    after: NDArray[np.float64]
    gain: ResponseGain
    directory: Path

    def to_json(self) -> dict[str, Any]:
        """Return the result as values that JSON can hold."""
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

    World, network, evaluation and seed are the run's; the rest are those of `SingleSettings`, but
    for `POPULATION` and episodes of training no longer than those of the evaluation. The epochs
    are as many as `matches` pay for.

    changes: other values of any setting but the epochs

    ValueError if `matches` do not pay for one epoch, or a setting is bad.
    """
    learner = other(team)
    theirs = {name: getattr(run.settings, name) for name in (*WORLD, *POLICY, *EVALUATION)}
    longest = min(int(SINGLE_DEFAULTS[learner]["train_steps"]), run.settings.eval_steps)
    chosen = {**theirs, "population": POPULATION, "train_steps": longest, **changes}
    one_epoch = int(chosen["population"]) * int(chosen.get("worlds", 1))
    if matches < one_epoch:
        raise ValueError(
            f"matches: expected at least {one_epoch}, those of an epoch, got {matches}"
        )
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
    """Return the run of a response to the champion of `team`: a new one, or one to go on with.

    ValueError if the directory holds a run of other settings or against another champion, or if
    `team` did not learn in `run`.
    """
    champion = _last(run.teams[team])
    if isinstance(champion, str):
        raise ValueError(f"team: expected one that learned in {run.files.path}, got {team!r}")
    path = Path(directory)
    if not (path / CONFIG).is_file():
        return SingleTeam(settings, path, opponents=champion, threads=threads, play=play)
    response = SingleTeam.resume(path, threads=threads, play=play)
    _check_same(response, settings, champion, path)
    return response


def _check_same(
    response: SingleTeam, settings: SingleSettings, champion: Population, path: Path
) -> None:
    expected = replace(settings, against=GIVEN)
    for name in (item.name for item in reversed(fields(SingleSettings))):  # its own ones first
        found, wanted = getattr(response.settings, name), getattr(expected, name)
        if found != wanted:
            raise ValueError(f"{path}: holds a run with {name} {found!r}, expected {wanted!r}")
    rivals = response.rivals
    if isinstance(rivals, str) or not np.array_equal(rivals.genomes, champion.genomes):
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
    """Evolve a response to the last genome of `team` in a run, and say what it gains.

    The response begins untrained and meets nobody but the champion. It is a run of its own in
    `directory`; with the same arguments an interrupted one goes on, and a finished one is read.
    What it gains is a lower bound of the champion's exploitability (see `analysis.response_gain`):
    a longer search may find more.

    Parameters
    ----------
    matches : the budget; whole epochs are played, the budget that they come to is in the result.
    report : called with the progress, as in `Run.run`.
    changes : settings of the response, such as ``population=128``.

    ValueError as in `response_settings` and `start_response`.
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
    """Play champion and opponent as the run left them, on as many episodes as the response."""
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
    return team if isinstance(team, str) else Population(team.genomes[-1:], team.network)


def _score(capture_rates: NDArray[np.float32], champion: Team) -> NDArray[np.float64]:
    """Return the scores (episodes,) of the champion's opponent."""
    captured = capture_rates.astype(np.float64).ravel()
    return captured if champion == "evader" else 1.0 - captured
