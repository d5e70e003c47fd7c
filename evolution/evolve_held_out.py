"""The evolved half of the held-out opponents: how the genomes that come with the package were made.

    python evolution/evolve_held_out.py                   held_out.npz, three minutes of one core
    python evolution/evolve_held_out.py --processes 2     the same file, sooner
    python evolution/evolve_held_out.py --quick           a tiny file, some seconds
    python evolution/evolve_held_out.py --table FILE.npz  what the opponents of a file can do

For each variant two genomes a team. The first evolves against a script, the second goes on from it:
against a more skilled script, or, where pursuers surround, in a larger world. They learn in small
worlds, which are cheap, and see no farther there than in large ones. The same seed gives the same
file. A new file becomes the package's by taking the place of
``python/matrixworld/coevolution/held_out.npz``.
"""

from __future__ import annotations

import argparse
import tempfile
from collections.abc import Iterator
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path

import numpy as np

import matrixworld as mw
from matrixworld import coevolution
from matrixworld.coevolution import SingleSettings, SingleTeam, Team
from matrixworld.coevolution.evaluation.held_out import NETWORK, held_out_scripts
from matrixworld.coevolution.types import other
from matrixworld.files import load_arrays, save_arrays

LEARNER = {
    "population": 32,
    "learning_rate": 0.03,
    "sigma": 0.15,
    "initial_weight": 0.2,
    "initial_head": 0.09,
    "overlap_penalty": 0.2,
}
QUICK_EPOCHS = 3
EPISODES = 50  # of each cell of the table


@dataclass(frozen=True)
class Lesson:
    """Epochs against a script in a small square world."""

    against: str
    epochs: int
    side: int
    pursuers: int
    evaders: int
    steps: int


OPEN = partial(Lesson, side=20, pursuers=3, evaders=8, steps=120)
TIGHT = partial(Lesson, side=10, pursuers=10, evaders=3, steps=60)
MIDDLE = partial(Lesson, side=16, pursuers=12, evaders=3, steps=80)
HUNTED = partial(Lesson, side=20, pursuers=8, evaders=4, steps=120)

LESSONS: dict[tuple[mw.Capture, Team], tuple[Lesson, Lesson]] = {
    (mw.Capture.OCCUPATION, "pursuer"): (
        OPEN("random", 1500),
        OPEN("clumsy-fleer", 1500),
    ),
    (mw.Capture.OCCUPATION, "evader"): (
        OPEN("clumsy-chaser", 1500),
        OPEN("hunter", 1500),
    ),
    (mw.Capture.SURROUND, "pursuer"): (
        TIGHT("random", 2500),
        MIDDLE("random", 1500),
    ),
    (mw.Capture.SURROUND, "evader"): (
        HUNTED("clumsy-chaser", 1000),
        HUNTED("surrounder", 1000),
    ),
}


def evolve(
    variant: str, team: Team, lesson: Lesson, start: np.ndarray | None, seed: int
) -> np.ndarray:
    """What a team's genome (untrained without a `start`) is after a lesson, rounded to float16."""
    settings = SingleSettings(
        variant=variant,
        team=team,
        against=lesson.against,
        epochs=lesson.epochs,
        archive_every=lesson.epochs,
        rows=lesson.side,
        cols=lesson.side,
        pursuers=lesson.pursuers,
        evaders=lesson.evaders,
        train_steps=lesson.steps,
        eval_episodes=1,
        seed=seed,
        **LEARNER,
    )
    with tempfile.TemporaryDirectory() as directory:
        run = SingleTeam(settings, directory, start=start, threads=1)
        run.run()
        return run.genomes(team)[-1].astype(np.float16).astype(np.float32)


def curriculum(variant: str, epochs: int | None, seed: int) -> dict[str, np.ndarray]:
    """The genomes (2, genes) float16 of both teams, by the name that they have in the file."""
    taught = {}
    for team in coevolution.TEAMS:
        genomes: list[np.ndarray] = []
        for lesson in LESSONS[mw.VARIANTS[variant].capture, team]:
            lesson = lesson if epochs is None else replace(lesson, epochs=epochs)
            start = genomes[-1] if genomes else None
            genomes.append(evolve(variant, team, lesson, start, seed))
        taught[f"{variant}.{team}s"] = np.stack(genomes).astype(np.float16)
    return taught


def table(genomes: dict[str, np.ndarray], variants: list[str], episodes: int) -> Iterator[str]:
    """Markdown: rates, of capture or escape, against random opponents and against all scripts."""
    for team in coevolution.TEAMS:
        yield f"\n| {team}s | " + " | ".join(variants) + " |\n|---|" + "---|" * len(variants)
        names = dict.fromkeys(name for v in variants for name in held_out_scripts(team, v))
        for name in (*names, *(f"evolved-{number}" for number in (1, 2))):
            cells = (cell(genomes, team, name, variant, episodes) for variant in variants)
            yield f"| {name} | " + " | ".join(cells) + " |"


def cell(genomes: dict[str, np.ndarray], team: Team, name: str, variant: str, episodes: int) -> str:
    """Rate against random opponents, and mean rate against all scripts of the other team."""
    if not name.startswith("evolved"):
        if name not in held_out_scripts(team, variant):
            return ""
        player = name
    else:
        number = int(name.removeprefix("evolved-")) - 1
        player = mw.Population(genomes[f"{variant}.{team}s"][number].astype(np.float32), NETWORK)
    matches = mw.Matches.of(0, 0, np.uint64(0))
    rates = []
    for script in held_out_scripts(other(team), variant):
        sides = (player, script) if team == "pursuer" else (script, player)
        captured = mw.rollout(variant, *sides, matches, worlds=episodes).capture_rate.mean()
        rates.append(captured if team == "pursuer" else 1 - captured)
    return f"{rates[0]:.2f}, {np.mean(rates):.2f}"


def main() -> None:
    """Evolve and write the file, or print what a file's opponents can do."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--quick", action="store_true", help="a few epochs of two variants")
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--processes", type=int, default=1)
    parser.add_argument("--output", type=Path, default=Path("held_out.npz"))
    parser.add_argument("--table", type=Path, metavar="FILE", help="print this file's table only")
    args = parser.parse_args()
    variants = ["O", "SB"] if args.quick else list(mw.VARIANTS)
    if args.table is None:
        epochs = QUICK_EPOCHS if args.quick else None
        teach = partial(curriculum, epochs=epochs, seed=args.seed)
        genomes = {}
        with ProcessPoolExecutor(args.processes) as pool:
            for variant, evolved in zip(variants, pool.map(teach, variants), strict=True):
                genomes |= evolved
                print(f"{variant} done", flush=True)
        save_arrays(args.output, genomes)
        print(f"Written: {args.output}, {args.output.stat().st_size:,} bytes")
        return
    episodes = 2 if args.quick else EPISODES
    print(*table(load_arrays(args.table), variants, episodes), sep="\n")


if __name__ == "__main__":
    main()
