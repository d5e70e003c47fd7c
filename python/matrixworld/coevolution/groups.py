"""Runs in groups: what differs in its seed only is judged, scored and shown together."""

from __future__ import annotations

import math
from collections.abc import Collection, Iterable, Sequence
from dataclasses import dataclass, replace
from functools import cached_property, partial
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from matrixworld import analysis
from matrixworld._util.callers import warn_caller
from matrixworld._util.readable import plain_values
from matrixworld._util.teams import PLURALS
from matrixworld.analysis import Estimate, Judgement
from matrixworld.analysis.judgement import clarity
from matrixworld.analysis.payoffs import Payoffs
from matrixworld.coevolution.evaluation.kept_scores import kept_scores
from matrixworld.coevolution.games.own_game import OwnGame
from matrixworld.coevolution.runs.places import SEED, find_runs, runs_in
from matrixworld.coevolution.runs.stored_files import OtherVersionError
from matrixworld.coevolution.saved_run import SavedRun
from matrixworld.coevolution.settings.race_settings import RaceSettings
from matrixworld.coevolution.types import TEAMS, Team, payoffs_of


@dataclass(frozen=True)
class RunGroup:
    """Finished `runs` by their seeds, in which alone they differ; a single run is a group of one.

    It is named by `paths`: the directory of all seeds, or those of the runs. Seeds of the same job
    that are not finished are `missing`.
    """

    paths: tuple[Path, ...]
    runs: tuple[SavedRun, ...]
    missing: tuple[int, ...] = ()

    @property
    def name(self) -> str:
        """What the group is called: its paths."""
        return ", ".join(map(str, self.paths))

    def inside(self, root: Path) -> RunGroup:
        """Return the same group with its paths inside the directory of its job."""
        return replace(self, paths=tuple(_inside(path, root) for path in self.paths))

    @property
    def seeds(self) -> tuple[int, ...]:
        """Seeds of the runs, in their order."""
        return tuple(run.settings.seed for run in self.runs)

    @property
    def several(self) -> bool:
        """Whether several seeds were asked for."""
        return len(self.runs) + len(self.missing) > 1

    @property
    def is_race(self) -> bool:
        """Whether both teams evolved."""
        return all(run.settings.is_race for run in self.runs)

    @cached_property
    def payoffs(self) -> Payoffs:
        """Payoffs of all runs."""
        return payoffs_of([run.payoff() for run in self.runs])

    @cached_property
    def judgement(self) -> Judgement:
        """The judgement of all of them together."""
        return analysis.judge(self.payoffs)

    @cached_property
    def singles(self) -> tuple[RunGroup, ...]:
        """Each run as a group of its own."""
        alone = (RunGroup((run.path,), (run,)) for run in self.runs)
        return tuple(alone) if self.several else (self,)

    @property
    def clarity(self) -> tuple[bool, float]:
        """How clearly a race shows who improved; runs of one team show nothing."""
        return clarity(self.judgement) if self.runs and self.is_race else (False, 0.0)

    def held_out(self, team: Team) -> NDArray[np.float64]:
        """Return the mean scores (seeds, opponents) of the last generation of a team.

        They are those of `score`, played once, and kept in the directories of the runs.
        """
        rows = []
        for scores in kept_scores(self.runs):
            against = scores[PLURALS[team]]["against"]
            # Estimates of one generation, the last one.
            rows.append([estimates[0]["value"] for estimates in against.values()])
        return np.array(rows)

    def best_held_out(self, team: Team) -> NDArray[np.float64]:
        """Return the mean scores (seeds,) of the best generations of a team, kept as well."""
        every = [scores[PLURALS[team]]["best generation"] for scores in kept_scores(self.runs)]
        return np.array([mean for _, mean in every])

    def means(self) -> dict[str, Estimate]:
        """Return the score, and of pursuit the length of episodes, of a team that evolved alone.

        Means over the seeds; those of a single run have their intervals over its episodes.
        """
        rows = [run.summary() for run in self.runs]
        game = self.runs[0].settings.known
        other = ("other_score",) if game.general else ()
        names = (next(iter(game.columns)), *other, *game.single)
        if len(rows) > 1:
            over_runs = partial(analysis.interval_over_runs, bounds=(0.0, math.inf))
            return {name: over_runs([row[name] for row in rows]) for name in names}
        [row] = rows
        count = row["evaluation_matches"]
        means = {}
        for name in names:
            low = row[f"{name}_low"]
            high = row[f"{name}_high"]
            means[name] = Estimate(row[name], low, high, "episodes", count)
        return means

    def to_json(self) -> dict[str, Any]:
        """Return what was measured and judged of all runs together, as values of JSON."""
        plain: dict[str, Any] = {"finished": list(self.seeds), "missing": list(self.missing)}
        if not self.runs:
            return plain
        plain |= self._measured()
        if not self.is_race or isinstance(self.runs[0].settings.game, OwnGame):
            return plain
        over_runs = partial(analysis.interval_over_runs, bounds=(0.0, 1.0))
        held_out = {}
        for team in TEAMS:
            scores = self.held_out(team)
            held_out[PLURALS[team]] = {
                "mean": over_runs(scores.mean(axis=1)),
                "interquartile mean": analysis.interquartile_mean(scores),
                "best generation": over_runs(self.best_held_out(team)),
            }
        return {**plain, "held_out": plain_values(held_out)}

    def _measured(self) -> dict[str, Any]:
        if not self.is_race:
            return {"measures": plain_values(self.means())}
        measures = plain_values(analysis.measure_all(self.payoffs))
        return {"judgement": self.judgement.to_json(), "measures": measures}

    def run_to_json(self) -> dict[str, Any]:
        """Return the summary of a single run, and of a race what was measured and judged."""
        [run] = self.runs
        if not self.is_race:
            return run.summary()
        plain = {**run.summary(), **self._measured()}
        if not isinstance(run.settings.game, OwnGame):
            plain["held_out"] = kept_scores(self.runs)[0]
        return plain


def open_groups(*directories: str | Path) -> list[RunGroup]:
    """Return runs in groups, in which they differ in their seed only.

    Parameters
    ----------
    *directories : str or Path
        Directories of runs, or of runs up to two levels below.

    Returns
    -------
    list of RunGroup
        Runs that are not finished are `RunGroup.missing`; a group may have no other ones.

    Raises
    ------
    FileNotFoundError, ValueError
        If a directory holds no run, or the same run is there twice.
    """
    paths = dict.fromkeys(path for each in directories for path in runs_in(Path(each)))
    return grouped(readable(map(SavedRun, paths)))


def readable(runs: Iterable[SavedRun]) -> list[SavedRun]:
    """Return the runs that this version reads, and warn of each other one.

    OtherVersionError if there are none but others.
    """
    read = []
    problems = []
    for run in runs:
        problem = _problem_of(run)
        if problem is None:
            read.append(run)
        else:
            problems.append(problem)
    if problems and not read:
        raise problems[0]
    for problem in problems:
        warn_caller(f"left out: {problem}")
    return read


def _problem_of(run: SavedRun) -> OtherVersionError | None:
    """Return why this version cannot read a run; None if it can."""
    try:
        run.settings  # noqa: B018, it is read now
    except OtherVersionError as error:
        return error
    return None


def by_clarity(groups: Sequence[RunGroup]) -> list[RunGroup]:
    """Return groups, those first that show most clearly who improved."""
    return sorted(groups, key=lambda group: group.clarity, reverse=True)


def grouped(runs: Iterable[SavedRun], finished: Collection[Path] | None = None) -> list[RunGroup]:
    """Return runs in groups; those of `finished` have their results, by default all that do.

    ValueError if two finished runs of a group have the same seed.
    """
    by_method: dict[RaceSettings, list[SavedRun]] = {}
    for run in runs:
        by_method.setdefault(run.settings.method, []).append(run)
    return [_group(same, finished) for same in by_method.values()]


def _group(runs: Sequence[SavedRun], finished: Collection[Path] | None) -> RunGroup:
    """Return runs of the same method as a group; see `grouped`."""
    by_seed: dict[int, SavedRun] = {}
    for run in runs:
        if not (run.finished if finished is None else run.path in finished):
            continue
        first = by_seed.setdefault(run.settings.seed, run)
        if first is not run:
            twice = f"the same run twice: {first.path}, {run.path}"
            raise ValueError(f"runs: expected different seeds, got {twice}")
    missing = sorted({run.settings.seed for run in runs} - by_seed.keys())
    return RunGroup(_paths_of(runs), tuple(by_seed.values()), tuple(missing))


def _paths_of(runs: Sequence[SavedRun]) -> tuple[Path, ...]:
    """Return the directory of all seeds if it has no others, else the directories of the runs."""
    paths = tuple(run.path for run in runs)
    if not all(SEED.fullmatch(path.name) for path in paths):
        return paths
    folder = paths[0].parent
    absolute = {path.absolute() for path in paths}
    return (folder,) if set(find_runs(folder.absolute())) <= absolute else paths


def _inside(path: Path, root: Path) -> Path:
    """Return a path as it is called inside a directory; one elsewhere stays absolute."""
    path = path.absolute()
    folder = root.absolute()
    if path == folder:
        return Path(path.name)
    return path.relative_to(folder) if path.is_relative_to(folder) else path


def group_of(name: str, source: Any) -> RunGroup | None:
    """Return runs as the group that they are; None for what holds no runs.

    They are a directory, a group, a run or a list of runs, in an argument that has a `name`.
    ValueError if they differ in more than their seed, or none is finished.
    """
    runs = source if isinstance(source, list | tuple) else [source]
    if isinstance(source, str | Path) and Path(source).is_dir():
        groups = open_groups(source)
    elif isinstance(source, RunGroup):
        groups = [source]
    elif runs and all(isinstance(run, SavedRun) for run in runs):
        groups = grouped(sorted(runs, key=lambda run: run.settings.seed))
    else:
        return None
    if len(groups) != 1 or not groups[0].runs:
        got = "; ".join(f"{group.name}, seeds {group.seeds}" for group in groups)
        raise ValueError(
            f"{name}: expected finished runs that differ in their seed only, got {got}"
        )
    return groups[0]
