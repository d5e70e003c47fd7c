"""Make what notebook 5 keeps: the paper's three schedules, ten races of full size each.

    python tutorials/make/chapter_5.py                  one hour on two cores; can be interrupted
    python tutorials/make/chapter_5.py --from DIRECTORY seconds, with races that are finished

The races have twice the matches of default ones, and samples that do not spread with the genome.
``paper_races.npz`` holds ``evaders``, the number of evaders, and for each schedule, with ``_`` for
``-``, how many of them were captured in each episode of the payoff matrices: uint8, shape (10
seeds, 31 pursuer generations, 31 evader generations, 10 episodes).

``--from`` takes a directory with ``SCHEDULE/SEED/payoff.npz`` and ``config.json``, such as the
``--runs`` of ``evolution/paper_claims.py``. Runs of an older file format serve, too, if their
settings are the same: the same settings and seed give the same captures.
"""

from __future__ import annotations

import argparse
import json
from pathlib import Path

import numpy as np

from matrixworld._util.files import save_arrays
from matrixworld.coevolution import SCHEDULES, ProgressBar, RaceSettings, evolve

DATA = Path(__file__).parents[1] / "course" / "data"
SEEDS = range(10)
WITHOUT_EFFECT = ("joint_epochs", "contemporaries", "hall_sample")
"""Settings of simultaneous races: their defaults have changed, and these races do not use them."""
EVADERS = RaceSettings().world.n_evaders


def settings_of(schedule: str, seed: int) -> RaceSettings:
    """Return the settings of a race."""
    return RaceSettings.of(
        {
            "schedule": schedule,
            "schedule.pursuer_epochs": 60,
            "schedule.evader_epochs": 120,
            "learner.relative_sigma": 0.0,
            "learner.learning_rate": 0.02,
            "seed": seed,
        }
    )


def played(directory: Path, threads: int | None) -> dict[str, list[np.ndarray]]:
    """Return the capture rates of each schedule and seed; play the missing races."""
    settings = {
        f"{name}/seed-{seed}": settings_of(name, seed) for name in SCHEDULES for seed in SEEDS
    }
    with ProgressBar() as bars:
        runs = evolve(settings, directory, threads=threads, report=bars)
    rates: dict[str, list[np.ndarray]] = {name: [] for name in SCHEDULES}
    for run in runs:
        rates[run.settings.schedule.name].append(run.payoff().scores)
    return rates


def finished(directory: Path) -> dict[str, list[np.ndarray]]:
    """Return the capture rates of each schedule and seed from finished runs."""
    return {
        name: [read(directory / name / str(seed), name, seed) for seed in SEEDS]
        for name in SCHEDULES
    }


def read(directory: Path, schedule: str, seed: int) -> np.ndarray:
    """Return the capture rates of one run; ValueError if its settings are others."""
    found = json.loads((directory / "config.json").read_text("utf-8"))["settings"]
    wanted = settings_of(schedule, seed)
    for key, value in found.items():
        expected = getattr(wanted, key, value)
        # JSON has lists only.
        if (
            key not in WITHOUT_EFFECT
            and (tuple(value) if isinstance(value, list) else value) != expected
        ):
            raise ValueError(f"{directory}, {key}: expected {expected!r}, got {value!r}")
    with np.load(directory / "payoff.npz") as arrays:
        return np.asarray(arrays["capture_rates"])


def main() -> None:
    parser = argparse.ArgumentParser(description=(__doc__ or "").split("\n", 1)[0])
    parser.add_argument("--runs", type=Path, default=Path("runs/chapter_5"))
    parser.add_argument("--from", type=Path, dest="source", help="directory of finished races")
    parser.add_argument("--threads", type=int, help="default: one for each core")
    args = parser.parse_args()
    rates = finished(args.source) if args.source else played(args.runs, args.threads)
    captured = {
        name.replace("-", "_"): np.rint(np.stack(each) * EVADERS).astype(np.uint8)
        for name, each in rates.items()
    }
    path = DATA / "paper_races.npz"
    save_arrays(path, {"evaders": np.array(EVADERS), **captured})
    print(f"Written: {path}, {path.stat().st_size / 1e3:.0f} kB")


if __name__ == "__main__":
    main()
