"""How often is the judgement of a race wrong? A benchmark of races whose truth is known.

    python evolution/judgement_errors.py --processes 2      the published tables, about 20 minutes
    python evolution/judgement_errors.py --quick            some seconds, small samples

Three sources of races, none of which uses the judgement:

- synthetic races (`matrixworld.toys.synthetic_races`): 28 kinds by formula, each seed with its own
  nuisance parameters, effect size, noise, number of generations and number of runs. Constants of
  the judgement may have been set on kinds marked *development*, with seeds below 1000; all others
  are *held back*;
- toy games (`matrixworld.toys.labelled_races`);
- small real races with a known manipulation: learners that cannot learn, and finished races whose
  opponents are put in random order.

Look at false alarms first (a condition is called present and is not), by kind and window; then at
hits, and at "cannot tell". Judgements are appended to ``judgements.jsonl`` in ``--results``; an
interrupted script continues there. Another version of the judgement needs a new file.
"""

from __future__ import annotations

import hashlib
import json
import zlib
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import ProcessPoolExecutor, as_completed
from contextlib import closing
from dataclasses import dataclass, replace
from functools import cache
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any, NamedTuple

import numpy as np
from tqdm import tqdm

from common import script_parser
from judgement_tables import write_tables
from matrixworld import analysis, toys
from matrixworld.coevolution import RaceSettings, finish
from matrixworld.toys.race_formulas import SyntheticRace
from matrixworld.toys.race_truths import (
    CONDITIONS,
    NOISES,
    WINDOWS,
    Truth,
    Truths,
    change_of_strength,
    play_episodes,
    truths_of_group,
)
from matrixworld.toys.synthetic_races import KINDS, synthetic_races

FIRST_SEED = 10_000
"""Published seeds start here; seeds below 1000 are for setting constants."""
SEEDS = 150
MOST_SEEDS = 30
"""Of toys and real races, which take longer."""

SIZES = (8, 15, 31, 60, 100)
RUNS = (1, 1, 1, 3, 5, 10)
"""Half of the races are single runs."""
EFFECTS = (0.25, 0.5, 1.0, 2.0)
PER_EPISODE, NUMBER, UNKNOWN = "each episode", "number of episodes", "unknown"
MOST_VALUES = 2_000_000
"""Above that, single episodes are not handed over, but their means and their number."""

FROZEN, SHUFFLED = "learners that cannot learn", "opponents in random order"
REAL = RaceSettings(
    rows=10, cols=10, pursuers=3, evaders=4, generations=14, pursuer_epochs=4, evader_epochs=4,
    population=8, train_steps=40, eval_steps=60,
)  # fmt: skip
NO_LEARNING = replace(
    REAL, pursuer_epochs=1, evader_epochs=1, population=2, sigma=1e-6, learning_rate=1e-9
)


@dataclass(frozen=True)
class Case:
    """Matches that a judgement gets to see, and what is true of them.

    Parameters
    ----------
    scores : ndarray of float64, shape (n, n), (runs, n, n), or with a last axis of episodes
        Capture rates.
    per_episode : bool
        Whether the last axis holds episodes.
    episodes : int or None
        Episodes behind each mean, if they are told.
    truths : dict of str to dict
        Window -> condition -> `Truth`.
    setting : dict of str to str
        How the race was played, for tables.
    gains : dict of str to list
        Window -> true change of the strength of pursuers and evaders; None where it is open.
    """

    scores: np.ndarray
    per_episode: bool
    episodes: int | None
    truths: dict[str, Truths]
    setting: dict[str, str]
    gains: dict[str, list[float | None]]


class Task(NamedTuple):
    """One race or group of races: its source, the kind and the seed."""

    source: str
    kind: str
    seed: int


# ---- Sources -------------------------------------------------------------------------------------


def synthetic_case(kind: str, seed: int) -> Case:
    """Return a synthetic race; the seed draws how it is played, too."""
    # Another key than that of the race's parameters; a checksum, as hash() differs between runs.
    rng = np.random.default_rng([seed, 2, zlib.crc32(kind.encode())])
    name, n, runs = str(rng.choice(list(NOISES))), int(rng.choice(SIZES)), int(rng.choice(RUNS))
    knowledge = str(rng.choice((PER_EPISODE, NUMBER, UNKNOWN)))
    effect, noise = float(rng.choice(EFFECTS)), NOISES[name]
    races = synthetic_races(kind, n, seed, effect=effect, runs=runs)
    if knowledge == PER_EPISODE and runs * n * n * noise.episodes > MOST_VALUES:
        knowledge = NUMBER
    # Each run at once becomes means, unless its episodes are to be shown.
    show = np.asarray if knowledge == PER_EPISODE else _means
    played = np.stack([show(play_episodes(race.rates, noise, rng)) for race in races])
    setting = {
        "noise": name,
        "generations": str(n),
        "episodes known": knowledge,
        "runs": str(runs),
        "effect": f"{effect:g}",
    }
    return Case(
        played[0] if runs == 1 else played,
        knowledge == PER_EPISODE,
        noise.episodes if knowledge == NUMBER else None,
        {window: truths_of_group(races, window) for window in WINDOWS},
        setting,
        {window: _true_gains(races, window) for window in WINDOWS},
    )


def _means(scores: np.ndarray) -> np.ndarray:
    return np.asarray(scores.mean(axis=-1))


def _true_gains(races: list[SyntheticRace], window: str) -> list[float | None]:
    # The change that a group estimates is that of all possible runs, which is not known.
    return list(change_of_strength(races[0].rates, window)) if len(races) == 1 else [None, None]


def toy_case(kind: str, seed: int) -> Case:
    """Return a race in a toy game, with its episodes."""
    race = toys.labelled_race(kind, seed)
    return Case(race.scores, True, None, dict(race.truths), {}, {})


def real_case(kind: str, seed: int) -> Case:
    """Return a small real race, with its episodes."""
    settings = NO_LEARNING if kind == FROZEN else REAL
    with TemporaryDirectory() as place:
        scores = finish(replace(settings, seed=seed), Path(place) / "race").payoff().capture_rates
    still = np.zeros(len(scores))
    if kind == FROZEN:
        # All generations are the same, so one rate holds for all pairs.
        race = SyntheticRace(np.full(scores.shape[:2], scores.mean()), still, still)
        found = {window: truths_of_group([race], window) for window in WINDOWS}
    else:
        scores = scores[:, np.random.default_rng([seed, 3]).permutation(len(scores))]
        found = {window: _only_no_arms_race() for window in WINDOWS}
    return Case(scores, True, None, found, {}, {})


def _only_no_arms_race() -> Truths:
    """Return what is known when the evaders are in random order: they gain nothing in time."""
    found = {condition: Truth(None, 0.0) for condition in CONDITIONS}
    return found | {"arms race": Truth(False, 0.0)}


SOURCES: dict[str, tuple[Callable[[str, int], Case], tuple[str, ...]]] = {
    "synthetic": (synthetic_case, tuple(KINDS)),
    "toy game": (toy_case, tuple(toys.RACES)),
    "real race": (real_case, (FROZEN, SHUFFLED)),
}


# ---- Judgements ----------------------------------------------------------------------------------


def judged(task: Task) -> dict[str, Any]:
    """Play a task, judge it, and return truth and verdicts as plain values."""
    case = SOURCES[task.source][0](task.kind, task.seed)
    judgement = analysis.judge(case.scores, per_episode=case.per_episode, episodes=case.episodes)
    found, gains = [], []
    for window, truths in case.truths.items():
        # A race may be too short for a window.
        findings = judgement.windows.get(window)
        for condition, truth in truths.items():
            verdict = findings[condition].verdict if findings is not None else "cannot tell"
            found.append([window, condition, truth.holds, round(truth.size, 4), verdict])
        if findings is not None:
            gains += list(_gains(window, case.gains.get(window, []), findings.gains))
    headline = {"headline": judgement.window, "found": found, "gains": gains}
    return task._asdict() | {"setting": case.setting} | headline


def _gains(
    window: str, true: list[float | None], estimates: Any
) -> Iterator[tuple[str, str, float, float, float]]:
    """Yield window, team, true change, and the ends of its interval, where both are known."""
    for (team, estimate), change in zip(estimates.items(), true, strict=False):
        if change is not None and np.isfinite([estimate.low, estimate.high]).all():
            yield window, team, change, float(estimate.low), float(estimate.high)


@cache
def version() -> str:
    """Return a checksum of everything that a judgement or a synthetic race depends on."""
    # Once: files that change while the script runs are not those that it imported.
    package = Path(analysis.__file__).parent.parent
    files = sorted([*package.glob("analysis/*.py"), *package.glob("toys/*.py"), Path(__file__)])
    return hashlib.sha256(b"".join(file.read_bytes() for file in files)).hexdigest()[:16]


def judge_all(tasks: Iterable[Task], file: Path, processes: int) -> list[dict[str, Any]]:
    """Judge all tasks that the file does not hold, append them, and return those asked for."""
    wanted = list(tasks)
    done = read_judgements(file)
    missing = [task for task in wanted if task not in done]
    with file.open("a", encoding="utf-8") as out, closing(_results(missing, processes)) as results:
        for result in tqdm(results, total=len(missing), unit=" races", disable=None):
            # One line at a time, so that an interruption loses unfinished races only.
            out.write(json.dumps(result) + "\n")
            out.flush()
    found = read_judgements(file)
    return [found[task] for task in wanted]


def _results(tasks: list[Task], processes: int) -> Iterator[dict[str, Any]]:
    if processes == 1:
        yield from map(judged, tasks)
        return
    with ProcessPoolExecutor(processes) as pool:
        try:
            for future in as_completed([pool.submit(judged, task) for task in tasks]):
                yield future.result()
        finally:
            pool.shutdown(cancel_futures=True)


def read_judgements(file: Path) -> dict[Task, dict[str, Any]]:
    """Return the judgements of a file by task; a file that is missing is begun.

    ValueError if another version of the code wrote it.
    """
    head = json.dumps({"version": version()})
    text = file.read_text(encoding="utf-8") if file.exists() else ""
    # An interrupted script may leave a line that is cut: it goes.
    lines = text[: text.rfind("\n") + 1].splitlines() or [head]
    if lines[0] != head:
        raise ValueError(f"{file}: expected judgements of this version of the code; delete it")
    file.write_text("\n".join(lines) + "\n", encoding="utf-8")
    found = [json.loads(line) for line in lines[1:]]
    return {Task(one["source"], one["kind"], one["seed"]): one for one in found}


def main() -> None:
    """Judge all races, and write tables and a figure."""
    parser = script_parser(__doc__, quick="two seeds of each kind of synthetic race, one of others")
    parser.add_argument("--seeds", type=int, help=f"of each kind; default {SEEDS}")
    parser.add_argument("--first-seed", type=int, default=FIRST_SEED)
    parser.add_argument("--sources", nargs="+", choices=SOURCES, default=list(SOURCES))
    parser.add_argument("--development", action="store_true", help="kinds for development only")
    parser.add_argument("--results", type=Path, default=Path("judgement"))
    parser.add_argument("--processes", type=int, default=1)
    args = parser.parse_args()
    seeds, most = args.seeds or (2 if args.quick else SEEDS), 1 if args.quick else MOST_SEEDS
    args.results.mkdir(parents=True, exist_ok=True)
    tasks = [
        Task(source, kind, args.first_seed + i)
        # Seeds outside: an interrupted script has judged as many of each kind.
        for i in range(seeds)
        for source in args.sources
        for kind in SOURCES[source][1]
        if (source == "synthetic" or i < most)
        and (not args.development or (source == "synthetic" and KINDS[kind].development))
    ]
    judgements = judge_all(tasks, args.results / "judgements.jsonl", args.processes)
    print(write_tables(judgements, args.results))
    print(
        f"Written: {args.results}/errors.md, counts.csv, settings.csv, gains.csv, power.csv, .png"
    )


if __name__ == "__main__":
    main()
