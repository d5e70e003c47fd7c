"""Best responses: how much newly evolved opponents gain against the champions of runs."""

from __future__ import annotations

from collections.abc import Mapping
from concurrent.futures import Executor
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, cast

import numpy as np
from numpy.typing import NDArray

from matrixworld._util.checks import check_choice, check_instance, shown
from matrixworld._util.files import save_json
from matrixworld._util.readable import Parts, Readable
from matrixworld.analysis.intervals import Estimate, difference_over_episodes
from matrixworld.coevolution.evaluation.tournament import tournament
from matrixworld.coevolution.jobs import evolve
from matrixworld.coevolution.learners.evolution_strategy import EvolutionStrategySettings
from matrixworld.coevolution.progress import Report, silent
from matrixworld.coevolution.schedules import Against
from matrixworld.coevolution.settings import PolicySettings, RaceSettings
from matrixworld.coevolution.storage import SavedRun
from matrixworld.coevolution.types import TEAMS, FloatArray, Team, other
from matrixworld.world.policy import Population
from matrixworld.world.rules import Rewards

POPULATION = 48
"""Candidates per epoch: with few matches, many small steps learn more than few large ones."""


@dataclass(frozen=True, repr=False)
class BestResponse(Readable):
    """Result of a best response to the champion of `team`."""

    team: Team
    before: FloatArray
    """Score (episodes,) of the champion's last opponent in its own run: the capture rate, or for
    evaders 1 minus it."""
    after: FloatArray
    """Score (episodes,) of the response, in episodes that were not used in its training."""
    gain: Estimate
    """Difference of the two means: the exploitability of the champion is at least that."""
    budget: int
    """Matches that were played to evolve the response."""
    directory: Path
    """Run directory of the response."""

    def _parts(self) -> Parts:
        means = f"{self.before.mean():.3f} before, {self.after.mean():.3f} after"
        return [
            f"{self.team}s' opponents score {means}: a best response evolved for "
            f"{self.budget:,} matches gains {self.gain}"
        ]

    def save(self) -> None:
        """Write the result, without the single episodes, into the directory of the response."""
        values = {
            "champion": self.team,
            "budget_matches": self.budget,
            "evaluation_matches": len(self.before) + len(self.after),
            "before": float(self.before.mean()),
            "after": float(self.after.mean()),
            "gain": {"value": self.gain.value, "low": self.gain.low, "high": self.gain.high},
        }
        save_json(self.directory / "best_response.json", values)


def best_responses(
    runs: Mapping[str, SavedRun],
    team: Team,
    matches: int,
    directory: str | Path,
    *,
    executor: Executor | None = None,
    threads: int | None = None,
    report: Report = silent,
    **changes: Any,
) -> dict[str, BestResponse]:
    """Evolve a response to the last genome of `team` in each run; measure its gain, by name.

    A response starts untrained and plays against the champion only. It is a run in `directory`,
    which the same call continues or, if it is finished, only reads. The gain is a lower bound of
    the champion's exploitability: a longer search may find more.

    Parameters
    ----------
    runs : mapping of str to SavedRun
        The runs of the champions, by the names that the responses get in `directory`.
    team : {"pursuer", "evader"}
        Team of the champions.
    matches : int
        Budget of each response. Only complete epochs are played; the result holds the budget used.
    directory : str or Path
        Directory of all responses.
    executor, threads, report
        As in `evolve`. The matches that measure the gains are played here.
    **changes
        Fields of `RaceSettings` of the responses, such as ``match_episodes=2``.

    Raises
    ------
    ValueError
        If the budget is smaller than one epoch, a setting is bad, `team` did not learn in a run, or
        the directory holds runs of other settings or against another champion. Other errors are
        those of `evolve`.
    """
    if not isinstance(runs, Mapping):
        raise TypeError(f"runs: expected runs by name, got {shown(runs)}")
    settings = {n: response_settings(run, team, matches, **changes) for n, run in runs.items()}
    found = evolve(settings, directory, executor=executor, threads=threads, report=report)
    pairs = zip(runs.items(), found, strict=True)
    return {name: _measured(run, team, response, threads) for (name, run), response in pairs}


def _measured(run: SavedRun, team: Team, response: SavedRun, threads: int | None) -> BestResponse:
    """Return the gain of a finished response to the last genome of `team` in a run."""
    settings = response.settings
    # The run may have gone on, or been made anew in the same place.
    champion, met = (cast(Population, each.last(team)) for each in (run, response))
    if not np.array_equal(champion.genomes, met.genomes):
        raise ValueError(f"{response.path}: holds a run against another champion")
    before = tournament(
        settings.world,
        run.last("pursuer"),
        run.last("evader"),
        seed=settings.seed,
        episodes=settings.evaluation_episodes,
        threads=threads,
    )
    old, new = (
        _scores(rates, team) for rates in (before.capture_rates, response.payoff().capture_rates)
    )
    gain, budget = difference_over_episodes(new, old), response.summary()["training_matches"]
    result = BestResponse(team, old, new, gain, budget, response.path)
    result.save()
    return result


def response_settings(run: SavedRun, team: Team, matches: int, **changes: Any) -> RaceSettings:
    """Return the settings of a response to the champion of `team` in a run.

    World, network, evaluation and seed are those of the run, and `epochs` is as large as the budget
    in matches allows. Training episodes are not longer than evaluation episodes. All other settings
    have their defaults, or the values in `changes`. Of a schedule only `archive_every` counts.
    """
    check_choice("team", team, TEAMS)
    check_instance("runs", run, SavedRun)
    path, policy = run.path, run.settings.policy
    if isinstance(run.teams[team], str):
        raise ValueError(f"team: expected one that learned in {path}, got {team!r}")
    # Rewards and mask of the champion's run are not taken over.
    chosen: dict[str, Any] = {
        "world": replace(run.settings.world, rewards=Rewards()),
        "policy": PolicySettings(
            hidden=policy.hidden, activation=policy.activation, memory=policy.memory
        ),
        "learner": EvolutionStrategySettings(population=POPULATION),
        "seed": run.settings.seed,
        **changes,
    }
    alone: Any = chosen.pop("schedule", Against())
    schedule = replace(alone, team=other(team), opponent=str(path.absolute()), epochs=1)
    one = RaceSettings(schedule=schedule, **chosen)
    chosen.setdefault("train_steps", min(one.train_steps, one.world.max_steps))
    one_epoch = one.learner.population * one.match_episodes
    if matches < one_epoch:
        raise ValueError(f"matches: expected at least {one_epoch} (one epoch), got {matches}")
    # Made anew: the steps of a learner follow from the epochs.
    return RaceSettings(schedule=replace(schedule, epochs=matches // one_epoch), **chosen)


def _scores(capture_rates: NDArray[np.float32], champion: Team) -> FloatArray:
    """Return the scores (episodes,) of the champion's opponent."""
    # The opponent of an evader is a pursuer, whose score is the capture rate.
    captured = capture_rates.astype(np.float64).ravel()
    return captured if champion == "evader" else 1.0 - captured
