"""One way to play, measure and tell an experiment; matches and statistics that several share."""

from __future__ import annotations

import argparse
import json
import re
import sys
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from concurrent.futures import Executor, ProcessPoolExecutor, as_completed
from contextlib import contextmanager
from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
from matplotlib.figure import Figure
from numpy.typing import ArrayLike, NDArray
from scipy import stats
from tqdm import tqdm

import matrixworld as mw
from matrixworld._util.checks import check_threads
from matrixworld._util.files import read_json, save_json
from matrixworld.analysis import Estimate, interval_over_runs
from matrixworld.cli.cluster import on_cluster
from matrixworld.coevolution import (
    RaceSettings,
    Run,
    SavedRun,
    Team,
    create,
    finish,
    open_run,
    tournament,
)
from matrixworld.coevolution.games.pursuit import OVERLAP_PENALTY, Pursuit
from matrixworld.coevolution.runs.places import find_runs
from matrixworld.plots import save_figure
from matrixworld.solver import Solution, best_response, solve

sys.path.append(str(Path(__file__).parents[1] / "tutorials"))  # where the folder `course` lies

SAME_STEPS = {"learner.relative_sigma": 0.0, "learner.learning_rate": 0.02}
"""Settings of an evolution strategy whose samples do not spread with the genome."""

SMALL_STEPS: Mapping[Team, Mapping[str, float]] = {
    "pursuer": {"learner.sigma": 0.15, "learner.learning_rate": 0.02},
    "evader": {"learner.sigma": 0.1, "learner.learning_rate": 0.02},
}
"""Steps of a team that learns alone that do not follow from its epochs, by team."""

PPO = {
    "learner": "actor-critic", "learner.population": 4, "learner.actor_rate": 0.003,
    "learner.clip": 0.2, "learner.actor_updates": 5, "policy.hidden": (32,),
    "world.rewards": "published",
}  # fmt: skip
"""Policy gradients with the clipped objective of PPO, and rewards of the authors' code."""

FIRST_TEST_SEED = 10**6
"""Test episodes have seeds of their own; those of training are hashes."""

SMALL_RACE = {
    "world.rows": 10, "world.cols": 10, "world.n_pursuers": 3, "world.n_evaders": 4,
    "world.max_steps": 60, "train_steps": 40, "learner.population": 8,
}  # fmt: skip
"""A world, and candidates, of ``--quick``."""


def long_race(schedule: str) -> dict[str, Any]:
    """Return the settings of a race with twice the matches of a default one, and `SAME_STEPS`."""
    in_turns = {"schedule.pursuer_epochs": 60, "schedule.evader_epochs": 120}
    epochs = {"schedule.joint_epochs": 90} if schedule == "hall-of-fame" else in_turns
    return {"schedule": schedule, **epochs, **SAME_STEPS}


class ScriptParser(argparse.ArgumentParser):
    """Options of a script. What a quick run writes lies in directories ``quick`` of their own."""

    directories: tuple[str, ...] = ()
    """Names of the options that are directories."""

    def parse_args(self, *given: Any, **options: Any) -> argparse.Namespace:  # type: ignore[override]
        """Return the options, with the directories of a quick run or of a full one."""
        args = super().parse_args(*given, **options)
        for name in self.directories if args.quick else ():
            setattr(args, name, getattr(args, name) / "quick")
        return args


def script_parser(
    doc: str | None, *, quick: str, runs: bool = False, results: bool = True, cluster: bool = False
) -> ScriptParser:
    """Return a parser with a script's docstring and ``--quick``, and with what else it asks for.

    Directories of runs and of results are named like the script.
    """
    # Docstrings are None under python -OO.
    parser = ScriptParser(description=(doc or "").split("\n", 1)[0])
    parser.add_argument("--quick", action="store_true", help=quick)
    name = Path(sys.argv[0]).stem
    places = {"runs": Path("runs", name)} if runs else {}
    places |= {"results": Path(name)} if results else {}
    for option, place in places.items():
        told = f"directory of {option}, of quick ones its directory quick; default: {place}"
        parser.add_argument(f"--{option}", type=Path, default=place, metavar="DIRECTORY", help=told)
    parser.directories = tuple(places)
    if cluster:
        parser.add_argument(
            "--cluster",
            metavar="auto|ADDRESS|FILE",
            help="play on a Dask cluster (docs/cluster.md); default: this machine's cores",
        )
    return parser


Numbers = Mapping[str, NDArray[Any]]
"""By ``"<kind> / <number>"``, the first axis is that of the seeds; others by names of their own."""
Runs = Mapping[str, list[SavedRun]]
"""Runs of each kind, by seed."""
Measure = Callable[[SavedRun], Mapping[str, ArrayLike]]
"""A run -> its numbers."""
Play = Callable[..., SavedRun]
"""As `play`: settings, directory and ``threads=`` -> the finished run."""


def play(settings: RaceSettings, directory: Path, *, threads: int | None = None) -> SavedRun:
    """Return the finished run of these settings: begin it, go on with it, or only open it."""
    create(settings, directory)
    return finish(directory, threads=threads)


def finish_with_penalty_of_races(directory: str | Path, *, threads: int | None = None) -> SavedRun:
    """Play what is left of a run; evaders alone that share cells lose as much as in races."""
    run = Run(directory, threads=threads)
    game = run.training.game
    assert isinstance(game, Pursuit)
    run.training.game = replace(game, penalty=min(game.penalty, OVERLAP_PENALTY))
    run.run()
    return SavedRun(directory)


def play_with_penalty_of_races(
    settings: RaceSettings, directory: Path, *, threads: int | None = None
) -> SavedRun:
    """Begin a run and play it with the penalty of races."""
    create(settings, directory)
    return finish_with_penalty_of_races(directory, threads=threads)


def experiment(
    doc: str | None,
    *,
    kinds: Callable[[bool], Mapping[str, Any]],
    measure: Callable[[Runs, bool], Mapping[str, ArrayLike]],
    table: Callable[[Numbers], str],
    seeds: int | Mapping[str, int],
    first_seed: int | Mapping[str, int] = 0,
    fewest: int = 1,
    play: Play = play,
    then: Callable[[Runs, bool], Mapping[str, list[Any]]] | None = None,
    draw: Callable[[Numbers], Figure | None] | None = None,
) -> None:
    """Play runs of several kinds and seeds, measure them, and write what the numbers say.

    Numbers and table are written to a directory that is named like the script.

    Parameters
    ----------
    doc : str
        ``__doc__`` of the script, for ``--help``.
    kinds : callable
        Whether ``--quick`` is given -> settings of each kind: a dataclass that has a seed.
    measure : callable
        All runs, and whether ``--quick`` is given -> numbers, such as those of `by_seed`.
    table : callable
        Numbers -> what they say, in Markdown.
    seeds : int or mapping of str to int
        Runs of each kind, if ``--seeds`` does not say another number; two with ``--quick``.
    first_seed : int or mapping of str to int, optional
        The seed of the first run of each kind; of kinds that are not named, 0.
    fewest : int, optional
        Seeds that the measures need: two if a run meets teams of other seeds.
    play : callable, optional
        Plays a run of races that are the script's own: of whatever `kinds` and `then` return.
    then : callable, optional
        Runs of `kinds` -> settings by seed of further kinds, which build on them.
    draw : callable, optional
        Numbers -> the one figure of what they say, which goes to ``figure.png``, or None.
    """
    told = "a small world and two seeds, some seconds"
    parser = script_parser(doc, quick=told, runs=True, cluster=True)
    parser.add_argument("--kinds", nargs="+", metavar="KIND", help="beginnings of names")
    parser.add_argument("--seeds", type=int, help="runs of each kind")
    parser.add_argument("--threads", type=int, help="for training; default: one for each core")
    args = parser.parse_args()
    if args.seeds is not None and args.seeds < fewest:
        parser.error(f"argument --seeds: expected at least {fewest}, got {args.seeds}")

    def first_of(kind: str) -> int:
        return first_seed if isinstance(first_seed, int) else first_seed.get(kind, 0)

    planned = {}
    for kind, settings in _chosen(parser, kinds(args.quick), args.kinds).items():
        usual = seeds if isinstance(seeds, int) else seeds[kind]
        count = args.seeds or (2 if args.quick else usual)
        planned[kind] = [replace(settings, seed=first_of(kind) + run) for run in range(count)]

    def finished(planned: Mapping[str, list[Any]]) -> dict[str, list[SavedRun]]:
        # Seed by seed, so that what is finished at any time is a fair sample of the kinds.
        settings = {
            f"{slug(kind)}/{first_of(kind) + run}": of_kind[run]
            for run in range(max(map(len, planned.values()), default=0))
            for kind, of_kind in planned.items()
            if run < len(of_kind)
        }
        runs = finish_all(settings, args.runs, play=play, threads=args.threads, where=args.cluster)
        return {
            kind: [runs[f"{slug(kind)}/{first_of(kind) + run}"] for run in range(len(of_kind))]
            for kind, of_kind in planned.items()
            if of_kind
        }

    runs = finished(planned)
    if then is not None:
        runs |= finished(then(runs, args.quick))
    write(args.results, measure(runs, args.quick), table)
    if draw and (figure := draw(dict(np.load(args.results / "numbers.npz")))):
        save_figure(figure, args.results / "figure.png")


def by_seed(runs: Runs, measure: Measure) -> dict[str, Any]:
    """Return the numbers of each run as ``"<kind> / <number>"``, stacked over the seeds."""
    numbers = {}
    for kind, of_kind in tqdm(runs.items(), unit=" kinds", desc="measured", disable=None):
        measured = [measure(run) for run in of_kind]
        for number in measured[0]:
            numbers[f"{kind} / {number}"] = np.stack([each[number] for each in measured])
    return numbers


def payoffs_of(kind: str, runs: list[SavedRun]) -> dict[str, Any]:
    """Return the payoffs of the races of a kind, to be judged by the rules of the day: `rates`."""
    scores = np.stack([run.payoff().scores for run in runs])
    evaders = runs[0].pursuit.world.n_evaders
    captured = np.rint(scores * evaders).astype(np.uint8)
    return {f"captured in {kind}": captured, f"evaders of {kind}": evaders}


def rates(numbers: Numbers, kind: str) -> NDArray[np.float32]:
    """Return the capture rates of single episodes of a kind, (seeds, G, H, episodes)."""
    return np.asarray(numbers[f"captured in {kind}"] / np.float32(numbers[f"evaders of {kind}"]))


def of_each(measure: Measure) -> Callable[[Runs, bool], Numbers]:
    """Return what `experiment` measures if each run is measured by itself."""
    return lambda runs, quick: by_seed(runs, measure)


def pairs(runs: Runs, *kinds: str) -> Iterator[tuple[SavedRun, ...]]:
    """Return the runs of several kinds seed by seed; none if a kind has not been played."""
    return zip(*(runs.get(kind, []) for kind in kinds), strict=False)


def _chosen(
    parser: argparse.ArgumentParser, kinds: Mapping[str, Any], names: list[str] | None
) -> Mapping[str, Any]:
    """Return the kinds whose names begin as ``--kinds`` says."""
    if names is None:
        return kinds
    for name in names:
        if not any(slug(kind).startswith(name) for kind in kinds):
            expected = ", ".join(map(slug, kinds))
            parser.error(f"--kinds: expected beginnings of {expected}, got {name}")
    return {kind: each for kind, each in kinds.items() if slug(kind).startswith(tuple(names))}


def slug(kind: str) -> str:
    """Return the name of a kind as the name of a directory."""
    return re.sub("[ /]+", "-", re.sub("[,:;]", "", kind))


def write(results: Path, numbers: Mapping[str, ArrayLike], table: Callable[[Numbers], str]) -> None:
    """Write numbers beside others that are kept, and what all of them say; print the table."""
    file = results / "numbers.npz"
    kept = dict(np.load(file)) if file.exists() else {}
    known = {**kept, **{name: np.asarray(values) for name, values in numbers.items()}}
    results.mkdir(parents=True, exist_ok=True)
    np.savez_compressed(file, **known)
    try:
        text = table(known)
    except KeyError as error:
        print(f"{file}: the table also needs {error}; --kinds plays other kinds")
        return
    (results / "table.md").write_text(text + "\n", encoding="utf-8")
    print(text)
    print(f"\nWritten: numbers.npz, table.md in {results}")


def write_json(results: Path, found: Any, text: str) -> None:
    """Write numbers of any shape to ``numbers.json``, and the table of them; print the table."""
    results.mkdir(parents=True, exist_ok=True)
    (results / "numbers.json").write_text(json.dumps(found) + "\n", encoding="utf-8")
    (results / "table.md").write_text(text + "\n", encoding="utf-8")
    print(text)
    print(f"\nWritten: numbers.json, table.md in {results}")


def kinds_in(numbers: Numbers) -> list[str]:
    """Return the kinds that have been measured, in their order."""
    return list(dict.fromkeys(name.split(" / ")[0] for name in numbers if " / " in name))


@contextmanager
def executor_of(where: str | None, processes: int) -> Iterator[Executor]:
    """Yield the executor that ``--cluster`` asks for, or without it one of so many processes."""
    with on_cluster(where) as given, given or ProcessPoolExecutor(processes) as executor:
        yield executor


def finish_all(
    settings: Mapping[str, Any],
    root: Path,
    *,
    play: Play = play,
    threads: int | None = None,
    where: str | None = None,
) -> dict[str, SavedRun]:
    """Return finished runs by the path of each in `root`; play the missing ones side by side.

    If runs failed, the error of one is raised after all others have ended.
    """
    missing = {name: each for name, each in settings.items() if not SavedRun(root / name).finished}
    cores = check_threads(threads)
    processes = max(1, min(cores, len(missing)))
    share = 1 if where else cores // processes
    with executor_of(where, processes) as executor:
        playing = {
            executor.submit(play, each, root / name, threads=share): name
            for name, each in missing.items()
        }
        for future in tqdm(as_completed(playing), total=len(playing), unit=" runs", disable=None):
            if future.exception() is not None:
                print(f"{root / playing[future]}: {future.exception()}", file=sys.stderr)
    for future in playing:
        future.result()
    return {name: SavedRun(root / name) for name in settings}


def learned_in(directory: Path) -> list[mw.Population]:
    """Return the last pursuers of each run in a directory."""
    teams = [open_run(path).last("pursuer") for path in find_runs(directory)]
    if not teams:
        raise FileNotFoundError(f"{directory}: expected directories of finished runs, got none")
    return teams


def kept(file: Path, measure: Callable[[], Mapping[str, Any]]) -> dict[str, Any]:
    """Return the numbers that a file keeps; measure and keep them if it is missing."""
    if not file.exists():
        file.parent.mkdir(parents=True, exist_ok=True)
        save_json(file, measure())
    return read_json(file)


def scores_against(
    world: mw.WorldConfig,
    team: Team,
    own: mw.Population,
    opponents: mw.Population,
    *,
    seed: int,
    episodes: int,
) -> NDArray[np.float64]:
    """Return the mean scores of a team's genomes (own, opponents) in a tournament.

    The score is the capture rate of pursuers, and the escape rate of evaders.
    """
    sides = (own, opponents) if team == "pursuer" else (opponents, own)
    rates = tournament(world, *sides, seed=seed, episodes=episodes).matrix
    return rates if team == "pursuer" else 1.0 - rates.T


@cache
def solved(world: mw.WorldConfig) -> Solution:
    """Return the solution of a world, which all races in it share."""
    return solve(world)


def guaranteed(run: SavedRun, team: Team) -> NDArray[np.float64]:
    """Return the capture rate of each generation of a team against its best response, exactly."""
    states, policy = solved(run.settings.game.world).states, run.teams[team]
    champions = (mw.Population(genome[None], policy.policy) for genome in policy.genomes)
    return np.array([best_response(states, each, team).value for each in champions])


SIGNIFICANCE = 0.05
"""Probability of any false verdict in a table, if no number differed from its threshold."""


def p_value(values: ArrayLike, than: float = 0.0) -> float:
    """Return the two-sided p-value that the mean of one number for each seed is `than`.

    Student's t test. Seeds that all agree have no spread; they take the sign test, which counts
    seeds on either side of `than`: two to the power of one minus the number of seeds.
    """
    distances = np.asarray(values, dtype=np.float64) - than
    if np.ptp(distances) > 1e-12:
        return float(stats.ttest_1samp(distances, 0.0).pvalue)
    return 2.0 ** (1 - len(distances)) if distances[0] else 1.0


def holm(p_values: ArrayLike) -> NDArray[np.float64]:
    """Return the p-values of several tests, adjusted so that one level holds for all together.

    Shape (tests,). The smallest of n p-values is multiplied by n, the next one by n - 1, and none
    becomes smaller than the one before (Holm 1979, "A simple sequentially rejective multiple test
    procedure"). The tests may depend on each other.
    """
    given = np.asarray(p_values, dtype=np.float64)
    order = np.argsort(given)
    adjusted = np.empty_like(given)
    adjusted[order] = np.maximum.accumulate(given[order] * np.arange(len(given), 0, -1))
    return np.minimum(adjusted, 1.0)


def adjusted(values: Mapping[Any, ArrayLike]) -> dict[Any, float]:
    """Return the p-value of each number (seeds,), adjusted for all of them, by its key."""
    found = holm([p_value(each) for each in values.values()])
    return dict(zip(values, found.tolist(), strict=True))


def shown_p(p: float) -> str:
    """Return a p-value as text."""
    return "p < 0.001" if p < 0.001 else f"p = {p:.3f}"


def written(found: Estimate, digits: int = 3, sign: str = "") -> str:
    """Return a number and its interval in brackets; seeds that all agree have none."""
    ends = [end for end in (found.value, found.low, found.high) if end is not None]
    # Adding 0.0 turns -0.0 into 0.0.
    value, *interval = (format(round(end, digits) + 0.0, f"{sign}.{digits}f") for end in ends)
    return f"{value} [{', '.join(interval)}]" if interval else value


def mean(
    values: ArrayLike,
    digits: int = 3,
    sign: str = "",
    *,
    bounds: tuple[float, float] = (-np.inf, np.inf),
) -> str:
    """Return the mean over seeds and its interval as text."""
    return written(interval_over_runs(values, bounds=bounds), digits, sign)


def markdown(heads: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    """Return a table in Markdown. The last head may end with a bar, for a column without one."""
    head, *lines = (f"| {' | '.join(cells)} |" for cells in (heads, *rows))
    return "\n".join([head, "|---" * (head.count("|") - 1) + "|", *lines])
