"""How often is the judgement of a race wrong? A benchmark of races whose truth is known.

    python evolution/validation/judgement_errors.py --seeds 16   the published tables, 20 minutes
    python evolution/validation/judgement_errors.py --quick         small samples, a minute

Three sources of races, none of which uses the judgement:

- synthetic races (`judgement_races.py`): 57 kinds by formula, each seed with its own nuisance
  parameters, effect size, noise, number of generations and number of runs. Constants of the
  judgement may have been set on kinds marked *development*, with seeds below 1000; all others are
  *held back*;
- toy games (`judgement_toys.py`);
- small real races with a known manipulation: learners that cannot learn, and finished races whose
  opponents are put in random order.

`judgement_cases.py` plays the races, `judgement_truths.py` says what is true of them, and
`judgement_tables.py` counts verdicts, writes tables and draws at which gain half of the arms races
are found, on races of their own. Progress is judged a second time with outlying generations.

Look at false alarms first (a condition is called present and is not), by kind and window; then at
hits, and at "cannot tell". Judgements are appended to ``judgements.jsonl`` in ``--results``; an
interrupted script continues there. Another version of the judgement needs a new file.
"""

from __future__ import annotations

import hashlib
import json
import math
from collections.abc import Iterable, Iterator
from concurrent.futures import as_completed
from contextlib import closing
from functools import cache, partial
from pathlib import Path
from typing import Any, NamedTuple
from unittest import mock

import numpy as np
from tqdm import tqdm

import _paths  # noqa: F401
import judgement_cases
import judgement_races
import judgement_toys
import judgement_truths
from common import executor_of, script_parser
from course import toys
from judgement_cases import SOURCES
from judgement_races import ALL_KINDS
from judgement_tables import PROGRESS, write_tables
from matrixworld import analysis
from matrixworld.analysis import strength

FIRST_SEED = 10_000
"""Published seeds start here; seeds below 1000 are for setting constants."""
SEEDS = 60


class Task(NamedTuple):
    """One race or group of races: its source, the kind and the seed."""

    source: str
    kind: str
    seed: int


def judged(task: Task) -> dict[str, Any]:
    """Play a task, judge it, and return truth and verdicts as plain values.

    Progress is judged a second time with outlying generations, which a judgement leaves out.
    """
    case = SOURCES[task.source].case(task.kind, task.seed)
    judge = partial(
        analysis.judge, case.scores, per_episode=case.per_episode, episodes=case.episodes
    )
    judgement = judge()
    with mock.patch.object(strength, "without_outliers", lambda scores, noise: scores):
        with_outliers = judge()
    found, found_with_outliers, changes = [], [], []
    for window, truths in case.truths.items():
        findings = judgement.windows[window]
        for condition, truth in truths.items():
            size = round(truth.size, 4)
            found.append([window, condition, truth.holds, size, findings[condition].verdict])
        found_with_outliers += [
            [window, name, truths[name].holds, with_outliers.windows[window][name].verdict]
            for name in PROGRESS
        ]
        estimates = findings["rise"].estimates
        changes += list(_changes(window, case.changes.get(window, []), estimates))
    return task._asdict() | {
        "setting": case.setting,
        "found": found,
        "with_outliers": found_with_outliers,
        "changes": changes,
    }


def _changes(
    window: str, true: list[float | None], estimates: Any
) -> Iterator[tuple[str, str, float, float, float]]:
    """Yield window, team, true change, and the ends of its interval, where both are known."""
    # A window that is too short has no estimates.
    for (name, estimate), change in zip(estimates.items(), true, strict=False):
        team = name.removesuffix("_change")
        if change is not None and np.isfinite([estimate.low, estimate.high]).all():
            yield window, team, change, float(estimate.low), float(estimate.high)


@cache
def version() -> str:
    """Return a checksum of everything that a judgement or a synthetic race depends on."""
    # Once: files that change while the script runs are not those that it imported.
    modules = toys, judgement_cases, judgement_races, judgement_toys
    files = sorted(Path(analysis.__file__).parent.glob("*.py"))
    files += [Path(each.__file__) for each in (*modules, judgement_truths)]
    return hashlib.sha256(b"".join(file.read_bytes() for file in files)).hexdigest()[:16]


def judge_all(
    tasks: Iterable[Task], file: Path, processes: int, where: str | None = None
) -> list[dict[str, Any]]:
    """Judge all tasks that the file does not hold, append them, and return those asked for."""
    wanted = list(tasks)
    done = read_judgements(file)
    missing = [task for task in wanted if task not in done]
    with (
        file.open("a", encoding="utf-8") as out,
        closing(_results(missing, processes, where)) as results,
    ):
        for result in tqdm(results, total=len(missing), unit=" races", disable=None):
            # One line at a time, so that an interruption loses unfinished races only.
            out.write(json.dumps(result) + "\n")
            out.flush()
    found = read_judgements(file)
    return [found[task] for task in wanted]


def _results(tasks: list[Task], processes: int, where: str | None) -> Iterator[dict[str, Any]]:
    if processes == 1 and where is None:
        yield from map(judged, tasks)
        return
    with executor_of(where, processes) as pool:
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


def chosen_tasks(seeds: int, *, development: bool) -> Iterator[Task]:
    """Yield the tasks of all sources, or those for development only."""
    for name, source in SOURCES.items():
        # Seeds outside: an interrupted script has judged as many of each kind.
        for seed in range(FIRST_SEED, FIRST_SEED + math.ceil(source.share * seeds)):
            for kind in source.kinds:
                if not development or (kind in ALL_KINDS and ALL_KINDS[kind].development):
                    yield Task(name, kind, seed)


def main() -> None:
    """Judge all races, and write tables and a figure."""
    parser = script_parser(__doc__, quick="one seed of each kind", cluster=True)
    parser.add_argument("--seeds", type=int, help=f"of each synthetic kind; default {SEEDS}")
    parser.add_argument("--development", action="store_true", help="kinds for development only")
    parser.add_argument("--processes", type=int, default=1)
    args = parser.parse_args()
    args.results.mkdir(parents=True, exist_ok=True)
    seeds = args.seeds or (1 if args.quick else SEEDS)
    tasks = list(chosen_tasks(seeds, development=args.development))
    judgements = judge_all(tasks, args.results / "judgements.jsonl", args.processes, args.cluster)
    print(write_tables(judgements, args.results))
    print(
        f"Written: {args.results}/errors.md, counts.csv, settings.csv, changes.csv, power.csv, .png"
    )


if __name__ == "__main__":
    main()
