"""The files of a run: what each stage adds, what training continues from, and the results.

====================  ==========================================================================
config.json           format, package version, settings
stage-0007.npz        what stage 7 has added: genomes, rows of the log, counters
checkpoint-0007.npz   state of learners and opponent samplers after stage 7, for the newest two
payoff.npz            results of the archives against each other (see `Payoff`)
summary.json          the most important numbers of the run
log.csv, *.npy        log and genomes of all stages, for other programs
====================  ==========================================================================

Stage 0 is the run before training. A stage is saved in this order: its checkpoint, the stage
itself, and then the checkpoint two stages before is removed. The newest stage therefore has a
checkpoint, whenever the process is killed. Files are written under a temporary name, synced and
renamed: readers beside a writer see whole stages only, and need no lock. The results are written
when the training has ended; if payoff or summary are deleted, going on makes all again.

`SavedRun` reads these files, and `RunWriter` writes them.
"""

from __future__ import annotations

import csv
import io
import os
import re
import warnings
from collections.abc import Iterator, Mapping, Sequence
from contextlib import AbstractContextManager, contextmanager
from dataclasses import replace
from functools import cached_property
from pathlib import Path, PurePath
from tempfile import TemporaryDirectory
from typing import Any, cast

import numpy as np
from numpy.typing import NDArray

from matrixworld._util import files
from matrixworld._util.checks import check_choice, expect
from matrixworld._util.imports import no_attribute
from matrixworld._util.readable import html_of
from matrixworld.analysis import Judgement, judge
from matrixworld.coevolution.game import Game
from matrixworld.coevolution.progress import Report, silent
from matrixworld.coevolution.pursuit import Pursuit, acting
from matrixworld.coevolution.race import ALL_SCHEDULES, Against
from matrixworld.coevolution.seeding import evaluation_seed
from matrixworld.coevolution.settings import RaceSettings
from matrixworld.coevolution.types import TEAMS, Genome, Genomes, Payoff, State, Team
from matrixworld.episodes.episode import Episode
from matrixworld.version import __version__

FORMAT = 11  # version of the directory's layout; another one is refused

CONFIG, LOCK, LOG = "config.json", ".lock", "log.csv"
PAYOFF, SUMMARY = "payoff.npz", "summary.json"

MOST_NAMED = 5  # most names that a message lists
SEED = re.compile(r"seed-(\d+)")  # names of the directories of a job's runs

COLUMNS: dict[str, type] = {
    "stage": int, "generation": int, "team": str, "epoch": int, "opponent": int,
    "fitness_mean": float, "fitness_std": float, "fitness_best": float,
}  # fmt: skip
"""Columns of the log, one row per epoch, and their types, before those of the game
(`Game.columns`).

`stage` counts the stages of the run from 1; `opponent` is the opponent's generation (-1: several
opponents); `fitness_*` are over the candidates of the epoch; `capture_rate` or `score`, `length`
and `*_faults` (agent-steps at fault in a collision) are means over its episodes; `matches` and
`steps` are the training episodes and world steps played so far in the run. Matches after the last
epoch of a generation, which choose its champion, count in the row of that epoch.
"""
Row = dict[str, Any]
Archive = dict[str, Genomes]

OTHER_NAMES = {
    **dict.fromkeys(("payoff_matrix", "payoffs", "matrix"), "run.payoff()"),
    **dict.fromkeys(("resume", "continue_run", "train"), "run.extend(generations=60)"),
    **dict.fromkeys(("champion", "get_best"), 'run.best("pursuer")'),
    "genomes": 'run.teams["pursuer"].genomes',
}
"""What people call the parts of a run, and the right calls."""


class OtherVersionError(ValueError):
    """A file of a run is complete, but of another version of the package."""


class SavedRun:
    """A run in a directory, finished or still training.

    `open_run` returns one whose files are checked. Methods read what the files hold at that moment;
    `teams` stay as they were when they were first read.

    Its directory is the `path`. The keys of `teams` are ``pursuer`` and ``evader``, or the names
    that a game of your own has.
    """

    def __init__(self, path: str | Path) -> None:
        self.path: Path = Path(path)

    def __getattr__(self, name: str) -> Any:
        raise no_attribute(self, "a run", name, OTHER_NAMES)

    def _sizes(self) -> dict[str, str]:
        """Return the size of each team's archive by the team's name, or its script."""
        script = getattr(self.settings.schedule, "opponent", "")
        archive = zip(self.settings.teams, self.archive().values(), strict=True)
        return {name: str(len(each) or script) for name, each in archive}

    def __repr__(self) -> str:
        """Return directory, kind and seed of the run, and the size of each team's archive."""
        sizes = ", ".join(f"{name}: {size}" for name, size in self._sizes().items())
        kind, seed = self.settings.schedule.name, self.settings.seed
        return f"{type(self).__name__}({str(self.path)!r}, {kind}, seed {seed}, {sizes})"

    def _repr_html_(self) -> str:
        world, state = self.settings.world, "finished" if self.finished else "not finished"
        cells = f", {world.rows} x {world.cols} cells" if world else ""
        rows = [
            ("run", f"{self.title}, {state}"),
            ("game", f"{self.settings.variant}{cells}"),
            *((f"generations of the {name}", size) for name, size in self._sizes().items()),
        ]
        if self.finished:
            payoff = self.payoff()
            rate = f"{payoff.matrix[-1, -1]:.2f}"
            rows.append((f"{payoff.words} of the last generations", rate))
        return html_of([("", str(self.path)), *rows])

    @cached_property
    def config(self) -> dict[str, Any]:
        """The content of config.json; OtherVersionError if it has another format."""
        if not self.exists:
            raise FileNotFoundError(f"{self.path}: holds no run, expected a file {CONFIG}")
        values = files.read_json(self.path / CONFIG)
        # Before any other entry is read: another format may not have it.
        found, version = values.get("format"), values.get("matrixworld", "unknown")
        got = files.one_line(f"{found} (written by matrixworld {version})")
        expect(found == FORMAT, f"{self.path / CONFIG}", f"format {FORMAT}", got, OtherVersionError)
        return values

    @cached_property
    def settings(self) -> RaceSettings:
        """Settings of the run; OtherVersionError if this version cannot read them."""
        try:
            return RaceSettings.of(self.config["settings"])
        except (AttributeError, KeyError, OverflowError, TypeError, ValueError) as error:
            if isinstance(error, files.DamagedFileError | OtherVersionError):
                raise
            got = f"those of {self.config.get('matrixworld', 'unknown')}: {error}"
            expected = f"{self.path / CONFIG}: expected settings of matrixworld {__version__}"
            raise OtherVersionError(f"{expected}, got {files.one_line(got)}") from error

    @property
    def title(self) -> str:
        """What the run is called, with its schedule and its seed."""
        path = self.path.absolute()
        # In a job the directory is that of the seed.
        name = path.parent.name if path.name == f"seed-{self.settings.seed}" else path.name
        if self.settings.is_race and self.settings.schedule.name != name:
            name = f"{name} ({self.settings.schedule.name})"
        return f"{name}, seed {self.settings.seed}"

    @property
    def exists(self) -> bool:
        """Whether the directory holds a run."""
        return (self.path / CONFIG).is_file()

    @property
    def finished(self) -> bool:
        """Whether the run has its results."""
        exist = (self.path / SUMMARY).exists() and (self.path / PAYOFF).exists()
        # A race that was made longer has results of its first stages.
        return exist and bool(self.summary()["stages"] >= self.settings.schedule.n_stages)

    # What the files hold:

    def archive(self) -> Archive:
        """Return the genomes (generations, genes) float32 of each team in all finished stages.

        Raises DamagedFileError if the file of a stage is damaged or missing.
        """
        archive = _archive_of(self._stages())
        return dict(zip(self.settings.keys, archive.values(), strict=True))

    @property
    def columns(self) -> dict[str, type]:
        """Columns of the log, and their types."""
        return {**COLUMNS, **self.settings.kind_of_game.columns}

    def log(self) -> dict[str, NDArray[Any]]:
        """Return the columns of the log (see `columns`) as arrays; errors as `archive`."""
        rows = self.rows(0)
        return {
            name: np.array([row[name] for row in rows], dtype=kind)
            for name, kind in self.columns.items()
        }

    def rows(self, after: int) -> list[Row]:
        """Return the rows of the log of all finished stages after one; errors as `archive`."""
        rows = csv.DictReader(io.StringIO(self._log_of(self._stages(after + 1)), newline=""))
        return [{name: kind(row[name]) for name, kind in self.columns.items()} for row in rows]

    def _log_of(self, stages: Sequence[files.Arrays]) -> str:
        lines = "".join(stage["log"].item().decode() for stage in stages)
        return f"{','.join(self.columns)}\n{lines}"

    def payoff(self) -> Payoff:
        """Return the payoff; FileNotFoundError while the run is not finished."""
        arrays, settings = self._load(PAYOFF), self.settings
        kind, exact = settings.kind_of_game, bool(settings.game and settings.game.deterministic)
        names = (*(f"{name}s" for name in kind.single), *kind.means)
        extras = {name: arrays[name] for name in names}
        return Payoff(arrays["scores"], extras, settings.teams, exact, kind.score_words[0])

    def judge(self) -> Judgement:
        """Return the judgement of a race; FileNotFoundError while the run is not finished."""
        return judge(self.payoff().payoffs())

    def summary(self) -> dict[str, Any]:
        """Return summary.json; FileNotFoundError while the run is not finished."""
        values = files.read_json(self.path / SUMMARY)
        if not isinstance(values.get("stages"), int):
            raise files.DamagedFileError(self.path / SUMMARY, "expected the number of its stages")
        return values

    def newest(self) -> int:
        """Return the number of the newest stage, 0 before the first."""
        return max(self.numbers("stage"), default=0)

    def numbers(self, kind: str) -> list[int]:
        """Return the stages of which there is a file of a kind, such as a checkpoint."""
        names = [path.stem.removeprefix(f"{kind}-") for path in self.path.glob(f"{kind}-*.npz")]
        return [int(name) for name in names if name.isdigit()]

    def _load(self, name: str) -> files.Arrays:
        return files.load_arrays(self.path / name)

    def _stages(self, first: int = 0) -> list[files.Arrays]:
        """Return what finished stages have added; DamagedFileError if one is missing."""
        # The summary first: beside a writer, all stages that it counts are there afterwards.
        least = self.summary()["stages"] if (self.path / SUMMARY).exists() else 0
        return [self._stage(number) for number in range(first, max(least, self.newest()) + 1)]

    def _stage(self, number: int) -> files.Arrays:
        try:
            return self._load(_name("stage", number))
        except FileNotFoundError as error:
            problem = "missing, expected the files of all stages"
            raise files.DamagedFileError(self.path / _name("stage", number), problem) from error

    # Teams that can play:

    @property
    def game(self) -> Game:
        """The game that is raced; a game of your own is imported.

        ValueError or PluginError if that is not possible, or if it is another game. If only its
        source has changed, a warning says so.
        """
        if self.settings.game and (changed := self.settings.game.changed()):
            warnings.warn(f"{self.path}: {changed}", stacklevel=2)
        return self.settings.evaluation_game

    @property
    def pursuit(self) -> Pursuit:
        """The game, if it is pursuit and evasion; ValueError for another one."""
        own = self.settings.game
        expected, got = "a run of pursuers and evaders", f"one of the game {own and own.code}"
        expect(not own, str(self.path), expected, got)
        return cast(Pursuit, self.game)

    @cached_property
    def teams(self) -> Mapping[str, Any]:
        """For each team its archive as a population, a genome a generation, or its script."""
        _ = self.game  # a game of your own that has changed is told now
        archive = self.archive()
        parts = zip(TEAMS, archive.items(), strict=True)
        return {key: self.as_policy(team, genomes) for team, (key, genomes) in parts}

    def as_policy(self, team: Team, genomes: Genomes) -> Any:
        """Return genomes of a team as a population; without any, the script that plays for it."""
        settings = self.settings
        if not len(genomes):
            return cast(Against, settings.schedule).opponent  # a script
        if team in settings.learning_teams:
            return settings.evaluation_game.population(team, genomes)
        # Opponents of a single team may come from a run with other hidden layers.
        shape = self.config.get("opponent_policy", {})
        return settings.evaluation_game.opponents(team, genomes, shape)

    def key_of(self, team: str) -> str:
        """Return the key of a team in `teams`, of its key or name; ValueError for another one."""
        names, keys = self.settings.teams, self.settings.keys
        if team in keys:
            return team
        check_choice("team", team, names)
        return keys[names.index(team)]

    def last(self, team: str) -> Any:
        """Return the last generation of a team, as a population of one genome, or its script."""
        each = self.teams[self.key_of(team)]
        return each if isinstance(each, str) else replace(each, genomes=each.genomes[-1:])

    def generation_at(self, team: str, matches: int) -> int:
        """Return the newest generation of `team` after so many training matches of both teams.

        To compare runs at equal budgets: ``teams[team].genomes[generation_at(team, n)]``.
        """
        key, ends = self.key_of(team), dict[int, int]()
        for row in self.rows(0):
            if row["team"] == key:  # counts never fall
                ends[row["generation"]] = row["matches"]
        return sum(end <= matches for end in ends.values())

    def record(self, pursuer: int = -1, evader: int = -1, episode: int = 0) -> Episode:
        """Play one episode of the evaluation again and record every step.

        Parameters
        ----------
        pursuer, evader : int, optional
            Generations; negative numbers count from the end. A script ignores them.
        episode : int, optional
            Number of the episode.

        Raises
        ------
        IndexError
            If there is no such generation.
        """
        pursuit = self.pursuit
        g, h = self.generation("pursuer", pursuer), self.generation("evader", evader)
        seed = evaluation_seed(self.settings.seed, g, h)
        return pursuit.record(*self.teams.values(), seed=seed, pursuer=g, evader=h, episode=episode)

    def policy(
        self,
        team: Team,
        generation: int = -1,
        *,
        sampled: bool | None = None,
        seed: int | None = None,
    ) -> Any:
        """Return a genome of the run as a policy, which also plays as a team of an environment.

        Parameters
        ----------
        team : {"pursuer", "evader"}
            Team of the genome.
        generation : int, optional
            Its generation; negative numbers count from the end.
        sampled, seed : bool and int, optional
            As for the policies; `sampled` for networks alone.

        Returns
        -------
        NetworkPolicy or RatingPolicy
            What plays.

        Raises
        ------
        IndexError, ValueError
            If there is no such generation or team, or a script plays for the team.
        """
        _ = self.pursuit
        check_choice("team", team, TEAMS)
        policy = self.teams[team]
        if isinstance(policy, str):
            raise ValueError(f"team: expected one that learned, got {team}: {policy} plays for it")
        genome = policy.genomes[self.generation(team, generation, "generation")]
        return acting(policy.policy, genome, sampled=sampled, seed=seed)

    def extend(
        self, generations: int, *, threads: int | None = None, report: Report = silent
    ) -> SavedRun:
        """Return the run of a race that goes on until it has so many generations.

        It is the same, bit for bit, as if the race had had them from the beginning. A run that is
        stopped goes on by the same call, or as any other.

        Parameters
        ----------
        generations : int
            Generations of the whole race.
        threads, report
            As in `evolve`.

        Returns
        -------
        SavedRun
            The finished run.

        Raises
        ------
        ValueError
            If it cannot go on: fewer generations than it has, one team alone, a learner that
            anneals over the whole run, no checkpoint, or a game that has changed.
        """
        from matrixworld.coevolution import run

        run.lengthen(self.path, generations)
        return run.finish(self.path, threads=threads, report=report)

    def best(self, team: str, *, sampled: bool | None = None, seed: int | None = None) -> Any:
        """Return the policy of a team that is best against held-out opponents.

        It is chosen by episodes of its own, which no score is from. They are played once.

        Parameters
        ----------
        team, sampled, seed
            As in `policy`.

        Returns
        -------
        NetworkPolicy or RatingPolicy
            What plays. In a game of your own, which has no held-out opponents, it is the last
            generation, as `last` returns it.
        """
        if self.settings.game:
            return self.last(team)
        check_choice("team", team, TEAMS)
        side = cast(Team, team)
        return self.policy(side, self._best.get(side, -1), sampled=sampled, seed=seed)

    @cached_property
    def _best(self) -> dict[Team, int]:
        from matrixworld.coevolution.evaluation import scores

        return scores.best_generations(self)

    def explain(self, team: Team, generation: int = -1, **options: Any) -> Any:
        """Return what a generation of a team does, in words and numbers.

        Of a policy that rates moves it tells what its inputs do and cost; of a network over cells
        it has a decision tree that imitates it (extra ``explain``).

        Parameters
        ----------
        team, generation
            As in `policy`.
        **options
            ``episodes`` against each held-out opponent, at least 2, by default 40; a ``seed``, by
            default 0, whose matches no other call plays; the ``depth`` of a tree, 3 to 6, by
            default 4; and ``threads`` and ``report`` as in `evolve`.

        Returns
        -------
        Explanation
            What the team does; it prints as sentences and a table.

        Raises
        ------
        IndexError, ValueError, MissingExtraError
            If there is no such generation or team, a script plays for it, it has memory, or a tree
            needs scikit-learn.
        """
        from matrixworld.coevolution.evaluation import explanation, scores

        policy = self.policy(team, generation, seed=options.get("seed", 0))
        world, number = self.pursuit.world, self.generation(team, generation)
        options |= {"opponents": scores.opponents_in(self, team, world)[0], "generation": number}
        return explanation.explain(policy, team, world, **options)

    def generation(self, team: str, index: int, name: str = "") -> int:
        """Return a generation from 0 on, of an index that may count from the end; 0 of a script.

        Raises
        ------
        IndexError
            If there is no such generation; the message begins with `name` or the team.
        """
        count = len(self.archive()[self.key_of(team)]) or 1  # a script has one
        expected = f"a generation from 0 to {count - 1}"
        expect(-count <= index < count, name or team, expected, index, IndexError)
        return index % count


def open_run(directory: str | Path) -> SavedRun:
    """Return the run in a directory, whether it is finished or not.

    Parameters
    ----------
    directory : str or Path
        Directory of the run.

    Returns
    -------
    SavedRun
        The run, whose files have been checked.

    Raises
    ------
    FileNotFoundError, DamagedFileError, OtherVersionError
        If the directory holds no run, a cut or altered one, or one of another version.
    """
    run = SavedRun(directory)
    # Read now: damage and other versions are told here. A game of your own is not imported yet.
    _ = run.archive() if run.settings.game else run.teams
    return run


def last_generation(directory: str | Path, team: Team) -> Any:
    """Return the last genome of a team in a run directory; ValueError if there is none."""
    run = open_run(directory)
    last = run.last(run.settings.keys[TEAMS.index(team)])
    expected = f"a run with genomes of {team}s"
    expect(not isinstance(last, str), str(directory), expected, "none")
    return last


def find_runs(path: Path) -> list[Path]:
    """Return `path` if it is a run, else those up to two levels below, by schedule and seed."""
    # config.json is the last file of a new run: without it the run was not completely created.
    if (path / CONFIG).is_file():
        return [path]
    found = [file.parent for depth in ("*", "*/*") for file in path.glob(f"{depth}/{CONFIG}")]
    return sorted(found, key=lambda run: place_in_job(run.relative_to(path)))


def runs_in(path: Path) -> list[Path]:
    """Return what `find_runs` returns; FileNotFoundError if that is nothing."""
    runs = find_runs(path)
    expect(runs, str(path), "a directory that holds runs", "none", FileNotFoundError)
    return runs


def place_in_job(name: PurePath | str) -> list[tuple[int, int, str]]:
    """Return a sort key for the runs of one job, by the names of their directories."""
    places = []
    for part in PurePath(name).parts:
        seed = SEED.fullmatch(part)  # seed-2 comes before seed-10
        schedule = [*ALL_SCHEDULES, part].index(part)
        places.append((schedule, int(seed[1]) if seed else -1, part))
    return places


def open_runs(directory: str | Path) -> list[SavedRun]:
    """Return the finished runs in a directory, by schedule and seed.

    Parameters
    ----------
    directory : str or Path
        Directory of a run, or of runs up to two levels below.

    Returns
    -------
    list of SavedRun
        The runs that are finished.

    Raises
    ------
    FileNotFoundError
        If the directory holds no run; other errors are those of `open_run`.
    """
    return [open_run(path) for path in runs_in(Path(directory)) if SavedRun(path).finished]


# Writing:


class RunWriter(SavedRun):
    """A run that one process writes, under its lock; any number may read it meanwhile."""

    def __init__(self, path: str | Path) -> None:
        super().__init__(path)
        self._saved: dict[Team, int] = dict.fromkeys(TEAMS, 0)  # genomes in the stages so far

    def lock(self) -> AbstractContextManager[None]:
        """Hold the directory for writing; LockedError if another process does."""
        return files.locked(self.path / LOCK)

    def begin(
        self,
        settings: Mapping[str, Any],
        archive: Mapping[Team, Any],
        states: Mapping[str, State],
        **more: Any,
    ) -> None:
        """Write config.json, which holds `settings` and `more`, and stage 0."""
        head = {"format": FORMAT, "matrixworld": __version__}
        self.config = {**head, "settings": dict(settings), **more}
        files.save_json(self.path / CONFIG, self.config)
        counters = ("matches", *self.settings.kind_of_game.counters)
        self.save(0, archive, [], dict.fromkeys(counters, 0), states)

    def change(self, settings: RaceSettings) -> None:
        """Write config.json with other settings of the same run."""
        config = {**self.config, "settings": settings.to_json()}
        files.save_json(self.path / CONFIG, config)
        self.config, self.settings = config, settings

    def save(
        self,
        stage: int,
        archive: Mapping[Team, Genomes | Sequence[Genome]],
        rows: Sequence[Row],
        counters: Mapping[str, float],
        states: Mapping[str, State],
    ) -> None:
        """Save a stage and its checkpoint.

        `archive` holds all genomes of each team, `rows` the log of this stage alone.
        """
        new = {f"{team}s": archive[team][self._saved[team] :] for team in TEAMS}
        genomes = {name: np.asarray(each, np.float32) for name, each in new.items() if len(each)}
        log = self._as_csv(rows).encode()
        flat = {f"{p}.{name}": value for p, each in states.items() for name, value in each.items()}
        files.save_arrays(self.path / _name("checkpoint", stage), flat)
        added: dict[str, Any] = {**genomes, "log": log, **counters}
        files.save_arrays(self.path / _name("stage", stage), added)
        self._saved = {team: len(archive[team]) for team in TEAMS}
        (self.path / _name("checkpoint", stage - 2)).unlink(missing_ok=True)

    def restore(self) -> tuple[list[files.Arrays], Archive, dict[str, State]]:
        """Return all stages up to the newest intact one, their genomes, and the states after it.

        A damaged file is reported by a warning and renamed to ``*.damaged``.
        """
        files.remove_temporary_files(self.path)
        problems: dict[Path, files.DamagedFileError] = {}
        # A run that was killed may have a checkpoint of a stage that it has not saved.
        numbers = [number for number in self.numbers("checkpoint") if number <= self.newest()]
        for number in sorted(numbers, reverse=True):
            try:
                stages = [self._stage(each) for each in range(number + 1)]
                state = self._load(_name("checkpoint", number))
                break
            except files.DamagedFileError as error:
                problems[error.path] = error
        else:
            reasons = "; ".join(map(str, problems.values())) or "got no file checkpoint-*.npz"
            raise files.DamagedFileError(self.path, f"no intact stage to continue from: {reasons}")
        for problem in problems.values():
            warnings.warn(f"{problem}; continuing from the stage before it", stacklevel=3)
            if problem.path.exists():
                os.replace(problem.path, f"{problem.path}.damaged")
        for number in self.numbers("checkpoint"):
            if number < len(stages) - 2:
                (self.path / _name("checkpoint", number)).unlink()
        archive = _archive_of(stages)
        self._saved = {team: len(archive[team]) for team in TEAMS}
        parts = self.settings.learning_teams
        states: dict[str, State] = {n: {} for team in parts for n in (team, f"{team}.opponents")}
        for key, value in state.items():
            # "pursuer.opponents.x" belongs to the part "pursuer.opponents", not to "pursuer".
            part, _, name = key.rpartition(".")
            states.setdefault(part, {})[name] = value
        return stages, archive, states

    def save_results(self, payoff: Mapping[str, NDArray[Any]], summary: Mapping[str, Any]) -> None:
        """Write log and genomes for other programs, payoff.npz, and summary.json as the last."""
        stages = self._stages()
        with files.replacing(self.path / LOG) as file:
            file.write(self._log_of(stages).encode())
        archive = zip(self.settings.teams, _archive_of(stages).values(), strict=True)
        for name, genomes in archive:
            if len(genomes):  # those of a team that a script plays are none
                with files.replacing(self.path / f"{name}.npy") as file:
                    np.save(file, genomes)
        files.save_arrays(self.path / PAYOFF, payoff)
        files.save_json(self.path / SUMMARY, summary)

    def _as_csv(self, rows: Sequence[Row]) -> str:
        text = io.StringIO()
        # The same line ends on all systems, so that files are the same, too.
        writer = csv.DictWriter(text, self.columns, lineterminator="\n")
        for row in rows:
            # Nine digits identify every float32.
            writer.writerow({k: f"{v:.9g}" if isinstance(v, float) else v for k, v in row.items()})
        return text.getvalue()


def _name(kind: str, stage: int) -> str:
    return f"{kind}-{stage:04}.npz"


def some(names: Sequence[str]) -> str:
    """Return the first of several names, in a list."""
    return ", ".join([*names[:MOST_NAMED], *["..."] * (len(names) > MOST_NAMED)])


def check_empty(path: Path) -> None:
    """Raise FileExistsError if a directory is there and not empty."""
    found = sorted(item.name for item in path.iterdir()) if path.exists() else []
    if found:
        expected = "expected a new or empty directory for a new run"
        raise FileExistsError(f"{path}: {expected}, found {some(found)}")


@contextmanager
def new_directory(path: Path) -> Iterator[Path]:
    """Yield an empty directory that becomes `path` at the end of the block, whole or not at all."""
    check_empty(path)
    target = path.absolute()
    target.parent.mkdir(parents=True, exist_ok=True)
    with TemporaryDirectory(prefix=f".{target.name}-", dir=target.parent) as place:
        new = Path(place) / target.name
        new.mkdir()
        yield new
        if not target.exists():
            new.rename(target)
            return
        check_empty(path)
        # An empty directory may be the current one, and stays. Without config.json, which comes
        # last, it holds no run.
        for item in sorted(new.iterdir(), key=lambda item: item.name == CONFIG):
            item.rename(target / item.name)


def _archive_of(stages: Sequence[files.Arrays]) -> Archive:
    """Return the genomes that stages have added; (0, 0) for a team that a script plays."""

    def genomes(name: str) -> Genomes:
        added = [stage[name] for stage in stages if name in stage]
        return np.concatenate(added) if added else np.empty((0, 0), np.float32)

    return {team: genomes(f"{team}s") for team in TEAMS}
