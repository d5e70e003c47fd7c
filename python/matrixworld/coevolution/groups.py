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
from matrixworld._util import checks
from matrixworld._util.readable import Parts, Readable, plain_values
from matrixworld.analysis import Estimate, Judgement, intervals
from matrixworld.analysis.judgement import CANNOT_TELL, clarity
from matrixworld.analysis.payoffs import Payoffs
from matrixworld.coevolution.evaluation.scores import SCORE, kept_scores, score
from matrixworld.coevolution.settings import RaceSettings
from matrixworld.coevolution.storage import SEED, SavedRun, find_runs, runs_in
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
        """Return the scores (seeds, opponents) of the last generation of a team, as `score` does.

        They are played once, and kept in the directories of the runs.
        """
        of_runs = [each[f"{team}s"]["against"].values() for each in kept_scores(self.runs)]
        return np.array([[last["value"] for [last] in against] for against in of_runs])

    def means(self) -> dict[str, Estimate]:
        """Return the score, and of pursuit the length of episodes, of a team that evolved alone.

        Means over the seeds; those of a single run have their intervals over its episodes.
        """
        rows = [run.summary() for run in self.runs]
        kind = self.runs[0].settings.kind_of_game
        names = (next(iter(kind.columns)), *kind.single)
        if len(rows) > 1:
            over_runs = partial(analysis.interval_over_runs, bounds=(0.0, math.inf))
            return {name: over_runs([row[name] for row in rows]) for name in names}
        [row] = rows
        count = row["evaluation_matches"]
        return {
            n: Estimate(row[n], row[f"{n}_low"], row[f"{n}_high"], "episodes", count) for n in names
        }

    def to_json(self) -> dict[str, Any]:
        """Return what was measured and judged of all runs together, as values of JSON."""
        plain: dict[str, Any] = {"finished": list(self.seeds), "missing": list(self.missing)}
        if not self.runs:
            return plain
        plain |= self._measured()
        if not self.is_race or self.runs[0].settings.game:
            return plain
        over_runs, held_out = partial(analysis.interval_over_runs, bounds=(0.0, 1.0)), {}
        for team in TEAMS:
            scores = self.held_out(team)
            held_out[f"{team}s"] = {
                "mean": over_runs(scores.mean(axis=1)),
                "interquartile mean": analysis.interquartile_mean(scores),
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
        held_out = {} if run.settings.game else {"held_out": kept_scores(self.runs)[0]}
        return {**run.summary(), **self._measured(), **held_out}


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
    return grouped(map(SavedRun, paths))


def by_clarity(groups: Sequence[RunGroup]) -> list[RunGroup]:
    """Return groups, those first that show most clearly who improved."""
    return sorted(groups, key=lambda group: group.clarity, reverse=True)


def grouped(runs: Iterable[SavedRun], finished: Collection[Path] | None = None) -> list[RunGroup]:
    """Return runs in groups; those of `finished` have their results, by default all that do."""
    methods: dict[RaceSettings, list[SavedRun]] = {}
    for run in runs:
        methods.setdefault(run.settings.method, []).append(run)
    groups = []
    for of_method in methods.values():
        seeds: dict[int, SavedRun] = {}
        for run in of_method:
            if run.finished if finished is None else run.path in finished:
                first = seeds.setdefault(run.settings.seed, run)
                got = f"the same run twice: {first.path}, {run.path}"
                checks.expect(first is run, "runs", "different seeds", got)
        missing = sorted({run.settings.seed for run in of_method} - seeds.keys())
        paths = _named([run.path for run in of_method])
        groups.append(RunGroup(paths, tuple(seeds.values()), tuple(missing)))
    return groups


def _named(paths: Sequence[Path]) -> tuple[Path, ...]:
    """Return the directory of seeds if all of them are there, else the paths."""
    folder, absolute = paths[0].parent, {path.absolute() for path in paths}
    of_seeds = all(SEED.fullmatch(path.name) for path in paths)
    of_seeds = of_seeds and {*find_runs(folder.absolute())} <= absolute
    return (folder,) if of_seeds else tuple(paths)


def _inside(path: Path, root: Path) -> Path:
    path, folder = path.absolute(), root.absolute()
    if path == folder:
        return Path(path.name)
    return path.relative_to(folder) if path.is_relative_to(folder) else path


# Judged and compared:


def judge(source: Any, **known: Any) -> Judgement:
    """Judge a race, or several with the same settings; see `analysis.judge`.

    Parameters
    ----------
    source : SavedRun, list of SavedRun, RunGroup, str or Path, or payoffs
        Finished runs that differ in their seed only, or a directory that holds such runs; or
        payoffs as `analysis.judge` takes them.
    **known
        Other arguments of `analysis.judge`, for payoffs.

    Returns
    -------
    Judgement
        What happened in the races.

    Raises
    ------
    ValueError
        If runs differ in more than their seed, or none is finished.
    """
    group = _group_of("source", source)
    return analysis.judge(source if group is None else group.payoffs, **known)


@dataclass(frozen=True, repr=False)
class Comparison(Readable):
    """What tells one group of runs from another one: `means` of both, and their `differences`."""

    means: dict[str, tuple[float, float]]
    differences: dict[str, Estimate]

    def verdict(self, name: str) -> str:
        """Return "higher" or "lower", as the first group is, or "cannot tell"."""
        return (CANNOT_TELL, "higher", "lower")[self.differences[name].sign]

    def _parts(self) -> Parts:
        rows = [
            (name, *(f"{mean:.3f}" for mean in self.means[name]), str(each), self.verdict(name))
            for name, each in self.differences.items()
        ]
        return [[("", "first", "second", "difference", ""), *rows]]


def compare(one: Any, other: Any, *, level: float = intervals.LEVEL) -> Comparison:
    """Compare two groups of runs, or two runs, or the payoffs of any races.

    Teams are compared by the scores of their last generations against held-out opponents, races by
    the measures that a judgement rests on. Groups with the same seeds are compared pair by pair.
    Two single runs have scores only, with intervals over episodes, not over seeds.

    Parameters
    ----------
    one, other
        As `source` of `judge`; payoffs have no scores.
    level : float, optional
        Level of each interval, in (0, 1); who asks many questions takes a higher one.

    Returns
    -------
    Comparison
        Means of both groups, and their differences.

    Raises
    ------
    ValueError
        If the worlds of the runs differ: scores are of a world.
    """
    groups = [_group_of("one", one), _group_of("other", other)]
    runs = [group for group in groups if group is not None]
    values: dict[str, list[NDArray[np.float64]]] = {}
    single = len(runs) == 2 and not any(group.several for group in runs)
    if len(runs) == 2:
        first, second = (group.runs[0].settings for group in runs)
        same = (first.world, first.game) == (second.world, second.game)
        checks.expect(same, "other", "runs in the same world or game as one", "another")
        both = [team for team in first.learning_teams if team in second.learning_teams]
        for team in both if first.game is None else ():
            name = f"{team}s against held-out opponents, {SCORE[team]}"
            values[name] = [
                score(each.runs[0])[team].rates[-1].mean(axis=0)
                if single
                else each.held_out(team).mean(axis=1)
                for each in runs
            ]
    single = single and bool(values)
    if all(group.is_race for group in runs) and not single:
        payoffs = [
            analysis.read_payoffs(source) if group is None else group.payoffs
            for group, source in zip(groups, (one, other), strict=True)
        ]
        for measure in (each for each in analysis.MEASURES.values() if each.short):
            found = [np.array([measure.of(run).value for run in each.runs]) for each in payoffs]
            if np.isfinite(np.concatenate(found)).all():
                values[measure.label()] = found
    paired = len(runs) == 2 and runs[0].seeds == runs[1].seeds
    over_runs = partial(analysis.difference_of_runs, paired=paired)
    difference = intervals.difference_over_episodes if single else over_runs
    return Comparison(
        {name: (float(a.mean()), float(b.mean())) for name, (a, b) in values.items()},
        {name: difference(*pair, level=level) for name, pair in values.items()},
    )


def _group_of(name: str, source: Any) -> RunGroup | None:
    """Return runs as the group that they are; None for what holds no runs."""
    several = source if isinstance(source, list | tuple) else [source]
    if isinstance(source, str | Path) and Path(source).is_dir():
        groups = open_groups(source)
    elif isinstance(source, RunGroup):
        groups = [source]
    elif several and all(isinstance(each, SavedRun) for each in several):
        groups = grouped(sorted(several, key=lambda run: run.settings.seed))
    else:
        return None
    got = "; ".join(f"{each.name}, seeds {each.seeds}" for each in groups)
    is_one = len(groups) == 1 and groups[0].runs
    checks.expect(is_one, name, "finished runs that differ in their seed only", got)
    return groups[0]
