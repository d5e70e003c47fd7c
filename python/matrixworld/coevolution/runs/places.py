"""Places of runs: the directories that hold them, and new ones."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path, PurePath
from tempfile import TemporaryDirectory

from matrixworld.coevolution.settings.schedules import ALL_SCHEDULES

CONFIG = "config.json"  # name of the file that every run has

MOST_NAMED = 5  # most names that a message lists
SEED = re.compile(r"seed-(\d+)")  # names of the directories of a job's runs

ORDER = {name: number for number, name in enumerate(ALL_SCHEDULES)}
"""Numbers of the schedules in the order in which a job plays them."""


def find_runs(path: Path) -> list[Path]:
    """Return `path` if it is a run, else those up to two levels below, by schedule and seed."""
    # config.json is the last file of a new run: without it the run was not completely created.
    if (path / CONFIG).is_file():
        return [path]
    configs = [*path.glob(f"*/{CONFIG}"), *path.glob(f"*/*/{CONFIG}")]
    return sorted(
        (file.parent for file in configs), key=lambda run: place_in_job(run.relative_to(path))
    )


def runs_in(path: Path) -> list[Path]:
    """Return what `find_runs` returns; FileNotFoundError if that is nothing."""
    runs = find_runs(path)
    if not runs:
        raise FileNotFoundError(f"{path}: expected a directory that holds runs, got none")
    return runs


def place_in_job(name: PurePath | str) -> list[tuple[int, int, str]]:
    """Return a sort key for the runs of one job, by the names of their directories."""
    places = []
    for part in PurePath(name).parts:
        seed = SEED.fullmatch(part)  # seed-2 comes before seed-10
        schedule = ORDER.get(part, len(ORDER))  # what is no schedule comes last
        places.append((schedule, int(seed[1]) if seed else -1, part))
    return places


def abbreviated(names: Sequence[str]) -> str:
    """Return names as "a, b"; of more than `MOST_NAMED` the first ones, as "a, b, ..."."""
    shown = [*names[:MOST_NAMED]]
    if len(names) > MOST_NAMED:
        shown.append("...")
    return ", ".join(shown)


def check_empty(path: Path) -> None:
    """Raise FileExistsError if a directory is there and not empty."""
    names = sorted(item.name for item in path.iterdir()) if path.exists() else []
    if names:
        expected = "expected a new or empty directory for a new run"
        raise FileExistsError(f"{path}: {expected}, found {abbreviated(names)}")


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
