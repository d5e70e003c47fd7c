"""How were the evolved held-out opponents made? Evolves them, or prints how good they are.

    python evolution/evolve_held_out.py                   held_out.npz, three minutes on one core
    python evolution/evolve_held_out.py --processes 2     the same file, faster
    python evolution/evolve_held_out.py --quick           a tiny file, some seconds
    python evolution/evolve_held_out.py --table FILE.npz  rates of the opponents in a file

There are two genomes of each team and variant. The first one evolves against a script. The second
one starts from the first and evolves against a more skilled script or, for pursuers that surround,
in a larger world. Both learn in small worlds, which are cheap; agents see the same neighbourhood
there as in large worlds. The same seed gives the same file. To use a new file, replace
``python/matrixworld/coevolution/held_out.npz``.

Method: an evolution strategy (Salimans et al., 2017) with a curriculum of two lessons (Bengio et
al., 2009, "Curriculum learning").

Look at the tables of ``--table``: first the rate against random opponents, then the mean rate
against all scripts. A useful opponent is better than a random walk and not the best of all.
"""

from __future__ import annotations

import tempfile
from functools import partial
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

import matrixworld as mw
from common import executor_of, finish_with_penalty_of_races, markdown, script_parser
from matrixworld import coevolution
from matrixworld._util.files import load_arrays, save_arrays
from matrixworld.coevolution import RaceSettings, Team, create
from matrixworld.coevolution.evaluation.held_out import NETWORK, held_out_scripts
from matrixworld.coevolution.types import other

LEARNER = {"learner.population": 32, "learner.learning_rate": 0.03, "learner.sigma": 0.15}
UNTRAINED = {"policy.initial_weight": 0.2, "policy.initial_head": 0.09}
QUICK_EPOCHS = 3
EPISODES = 50  # of each pair in the table


class Lesson(NamedTuple):
    """Training against a script in a small square world."""

    against: str
    epochs: int
    side: int
    """Rows and columns of the world."""
    pursuers: int
    evaders: int
    steps: int
    """Steps of an episode."""


# Occupation needs space to flee; surrounding needs many pursuers close to few evaders, or untrained
# pursuers never make a capture that selection could reward.
OPEN = partial(Lesson, side=20, pursuers=3, evaders=8, steps=120)
TIGHT = partial(Lesson, side=10, pursuers=10, evaders=3, steps=60)
MIDDLE = partial(Lesson, side=16, pursuers=12, evaders=3, steps=80)
HUNTED = partial(Lesson, side=20, pursuers=8, evaders=4, steps=120)

LESSONS: dict[tuple[mw.Capture, Team], tuple[Lesson, Lesson]] = {
    (mw.Capture.OCCUPATION, "pursuer"): (OPEN("random", 1500), OPEN("clumsy-fleer", 1500)),
    (mw.Capture.OCCUPATION, "evader"): (OPEN("clumsy-chaser", 1500), OPEN("hunter", 1500)),
    (mw.Capture.SURROUND, "pursuer"): (TIGHT("random", 2500), MIDDLE("random", 1500)),
    (mw.Capture.SURROUND, "evader"): (HUNTED("clumsy-chaser", 1000), HUNTED("surrounder", 1000)),
}


def evolve(
    variant: str, team: Team, lesson: Lesson, start: np.ndarray | None, seed: int
) -> np.ndarray:
    """Return a team's genome after a lesson, rounded to float16; `start` None: untrained."""
    settings = RaceSettings.of({
        "schedule": "against", "schedule.team": team, "schedule.opponent": lesson.against,
        "schedule.epochs": lesson.epochs, "schedule.archive_every": lesson.epochs,
        "world.rules": variant, "world.rows": lesson.side, "world.cols": lesson.side,
        "world.n_pursuers": lesson.pursuers, "world.n_evaders": lesson.evaders,
        "train_steps": lesson.steps, "evaluation_episodes": 1, "seed": seed, **LEARNER,
        **(UNTRAINED if start is None else {}),
    })  # fmt: skip
    # Only the last genome is kept; a run needs a directory for its checkpoints.
    with tempfile.TemporaryDirectory() as directory:
        create(settings, f"{directory}/run", start=start)
        run = finish_with_penalty_of_races(f"{directory}/run", threads=1)
        # Rounded already here: the next lesson starts from the genome that the file will hold.
        return run.teams[team].genomes[-1].astype(np.float16).astype(np.float32)


def curriculum(variant: str, epochs: int | None, seed: int) -> dict[str, np.ndarray]:
    """Return the genomes (2, genes) float16 of both teams, by their names in the file."""
    taught = {}
    for team in coevolution.TEAMS:
        genomes: list[np.ndarray] = []
        for lesson in LESSONS[mw.VARIANTS[variant].capture, team]:
            lesson = lesson if epochs is None else lesson._replace(epochs=epochs)
            start = genomes[-1] if genomes else None
            genomes.append(evolve(variant, team, lesson, start, seed))
        taught[f"{variant}.{team}s"] = np.stack(genomes).astype(np.float16)
    return taught


def captured(team: Team, world: mw.WorldConfig | str, own: Any, rival: Any, episodes: int) -> float:
    """Return the score of a team in one match of many episodes, with the same seed for all."""
    sides = (own, rival) if team == "pursuer" else (rival, own)
    matches = mw.Matches.of(0, 0, np.uint64(0))
    rate = float(mw.rollout(world, *sides, matches, episodes=episodes).capture_rate.mean())
    return rate if team == "pursuer" else 1 - rate


def table(genomes: dict[str, np.ndarray], variants: list[str], episodes: int) -> str:
    """Return tables: capture or escape rates against random opponents and all scripts."""
    tables = []
    for team in coevolution.TEAMS:
        rows: dict[str, dict[str, str]] = {}
        for variant in variants:
            players: dict[str, Any] = {name: name for name in held_out_scripts(team, variant)}
            for number, genome in enumerate(genomes[f"{variant}.{team}s"].astype(np.float32), 1):
                players[f"evolved-{number}"] = mw.Population(genome, NETWORK)
            scripts = held_out_scripts(other(team), variant)
            for name, player in players.items():
                rates = [captured(team, variant, player, script, episodes) for script in scripts]
                cells = rows.setdefault(name, {})
                cells[variant] = f"{rates[0]:.2f}, {np.mean(rates):.2f}"
        # Variants differ in their scripts; the evolved ones come last.
        names = sorted(rows, key=lambda name: name.startswith("evolved"))
        lines = [[name, *(rows[name].get(each, "") for each in variants)] for name in names]
        tables.append(markdown([f"{team}s", *variants], lines))
    return "\n\n".join(tables)


def main() -> None:
    """Evolve and write the file, or print the table of a file."""
    parser = script_parser(__doc__, quick="a few epochs of two variants", cluster=True)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--processes", type=int, default=1)
    parser.add_argument("--table", type=Path, metavar="FILE", help="print this file's table only")
    args = parser.parse_args()
    variants = ["O", "SB"] if args.quick else list(mw.VARIANTS)
    if args.table is not None:
        print(table(load_arrays(args.table), variants, 2 if args.quick else EPISODES))
    else:
        epochs = QUICK_EPOCHS if args.quick else None
        teach = partial(curriculum, epochs=epochs, seed=args.seed)
        genomes = {}
        # Variants are independent and each has its own generator, so the number of processes does
        # not change the file.
        with executor_of(args.cluster, args.processes) as pool:
            for variant, evolved in zip(variants, pool.map(teach, variants), strict=True):
                genomes |= evolved
                print(f"{variant} done", flush=True)
        args.results.mkdir(parents=True, exist_ok=True)
        file = args.results / "held_out.npz"
        save_arrays(file, genomes)
        print(f"Written: {file}, {file.stat().st_size:,} bytes")


if __name__ == "__main__":
    main()
