"""How were the evolved held-out opponents made? Evolves them, or tells how good they are.

    python evolution/evolve_held_out.py                   held_out.npz, three minutes on one core
    python evolution/evolve_held_out.py --processes 2     the same file, faster
    python evolution/evolve_held_out.py --quick           a tiny file, some seconds
    python evolution/evolve_held_out.py --table FILE.npz  rates of the opponents in a file

There are two genomes of each team and variant. The first one evolves against a script. The second
one starts from the first and evolves against a more skilled script or, for pursuers that surround,
in a larger world. Both learn in small worlds, which are cheap; agents see the same neighbourhood
there as in large worlds. The same seed gives the same file. To use a new file, replace
``python/matrixworld/coevolution/evaluation/held_out.npz``.

Method: an evolution strategy (Salimans et al., 2017) with a curriculum of two lessons (Bengio et
al., 2009, "Curriculum learning").

Look at the tables of ``--table``, which ``--results`` receives: first the rate against random
opponents, then the mean rate against all scripts. A useful opponent is better than a random walk
and not the best of all.
"""

from __future__ import annotations

import tempfile
from functools import partial
from itertools import product
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from tqdm import tqdm

import matrixworld as mw
from common import executor_of, finish_with_penalty_of_races, markdown, script_parser, write_json
from matrixworld import coevolution
from matrixworld._util.files import load_arrays, save_arrays
from matrixworld.coevolution import RaceSettings, Team, create
from matrixworld.coevolution.evaluation.held_out import NETWORK, held_out_scripts
from matrixworld.coevolution.types import other

LEARNER = {"learner.population": 32, "learner.learning_rate": 0.03, "learner.sigma": 0.15}
UNTRAINED = {"policy.initial_weight": 0.2, "policy.initial_head": 0.09}
QUICK_EPOCHS = 3
EPISODES, MANY = 50, 1000  # of each pair in the variants' default worlds, and in `SMALL`
SMALL = mw.WorldConfig("O", rows=10, cols=10, n_pursuers=4, n_evaders=4, max_steps=50)
IN_SMALL = "O, 10 x 10 cells, 4 against 4, 50 steps; `chaser` as pursuers, `fleer` as evaders."
GOOD: dict[Team, mw.Script] = {"pursuer": "chaser", "evader": "fleer"}
TOLD: dict[Team, str] = {
    "pursuer": "Capture rates of pursuers", "evader": "Escape rates of evaders",
}  # fmt: skip

Row = dict[str, Any]


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


def players_of(genomes: dict[str, np.ndarray], team: Team, variant: str) -> dict[str, Any]:
    """Return the held-out opponents of a team in a variant, by name: scripts, then genomes."""
    players: dict[str, Any] = {name: name for name in held_out_scripts(team, variant)}
    for number, genome in enumerate(genomes[f"{variant}.{team}s"].astype(np.float32), 1):
        players[f"evolved-{number}"] = mw.Population(genome, NETWORK)
    return players


def rates_in(variants: list[str], genomes: dict[str, np.ndarray], episodes: int) -> list[Row]:
    """Return each player's capture or escape rates against all scripts of the other team."""
    rows = []
    for team, variant in product(coevolution.TEAMS, variants):
        players = players_of(genomes, team, variant)
        scripts = held_out_scripts(other(team), variant)
        for name, player in tqdm(players.items(), desc=f"{team}s, {variant}", disable=None):
            rates = {
                script: round(captured(team, variant, player, script, episodes), 4)
                for script in scripts
            }
            rows.append({"team": team, "variant": variant, "player": name, "rates": rates})
    return rows


def difficulties(genomes: dict[str, np.ndarray], episodes: int) -> list[Row]:
    """Return the score of a good script of the other team against each player, in `SMALL`."""
    return [
        {
            "team": team,
            "player": name,
            "score": round(captured(other(team), SMALL, GOOD[other(team)], player, episodes), 4),
        }
        for team in coevolution.TEAMS
        for name, player in players_of(genomes, team, "O").items()
    ]


def table(numbers: dict[str, list[Row]]) -> str:
    """Return tables: rates against random opponents and against all scripts, and difficulties."""
    rows = numbers["rates"]
    variants = list(dict.fromkeys(row["variant"] for row in rows))
    parts = []
    for team, told in TOLD.items():
        cells: dict[str, dict[str, str]] = {}
        for row in rows:
            if row["team"] == team:
                mean = np.mean([*row["rates"].values()])
                both = f"{row['rates']['random']:.2f}, {mean:.2f}"
                cells.setdefault(row["player"], {})[row["variant"]] = both
        # Variants differ in their scripts; the evolved ones come last.
        names = sorted(cells, key=lambda name: name.startswith("evolved"))
        lines = [[name, *(cells[name].get(each, "") for each in variants)] for name in names]
        parts += [f"{told}: against random opponents, and the mean against all scripts."]
        parts += [markdown([f"{team}s", *variants], lines)]
    lines = [[row["player"], f"{row['team']}s", f"{row['score']:.2f}"] for row in numbers["small"]]
    parts += [f"Difficulty: what a good script of the other team scores. {IN_SMALL}"]
    return "\n\n".join([*parts, markdown(["opponent", "team", "difficulty"], lines)])


def main() -> None:
    """Evolve and write the file, or print the table of a file."""
    parser = script_parser(__doc__, quick="a few epochs of two variants", cluster=True)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--processes", type=int, default=1)
    parser.add_argument("--table", type=Path, metavar="FILE", help="tell this file's rates only")
    args = parser.parse_args()
    variants = ["O", "SB"] if args.quick else list(mw.VARIANTS)
    if args.table is not None:
        genomes = load_arrays(args.table)
        episodes, many = (2, 2) if args.quick else (EPISODES, MANY)
        numbers = {
            "rates": rates_in(variants, genomes, episodes), "small": difficulties(genomes, many)
        }  # fmt: skip
        write_json(args.results, numbers, table(numbers))
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
