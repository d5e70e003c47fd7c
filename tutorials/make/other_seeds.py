"""What other seeds say: the headline claims of the notebooks, on seeds that no notebook shows.

    python tutorials/make/other_seeds.py      an hour on one core; can be interrupted

A claim names an effect, which has a sign; `SOURCES` measure effects, one number for each seed. What
takes long is played here, in ``runs/other_seeds``, and kept in ``tutorials/course/data`` as
``other_seeds.npz``: for each effect an array (seeds,). The rest is played by the test
``tests/course/test_other_seeds.py``, which asks for the sign of each claim.
"""

from __future__ import annotations

import sys
from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cache
from pathlib import Path

import chapter_4
import chapter_6
import chapter_7
import numpy as np
from chapter_9 import EPISODES, evolve, evolve_masked, tested_masked
from races import DATA, finish
from tqdm import tqdm

import matrixworld as mw
from matrixworld import analysis, coevolution
from matrixworld._util.files import load_arrays, save_arrays
from matrixworld.coevolution import SavedRun

sys.path.append(str(Path(__file__).parents[1]))  # where the folder `course` lies


from course import chapter_3, toys
from course.chapter_5 import noisy_race

KEPT = DATA / "other_seeds.npz"
NOTEBOOKS = Path(__file__).parents[1]
PAPER = NOTEBOOKS.parent / "evolution" / "results" / "paper" / "paper_claims" / "numbers.npz"
PAPER_SCHEDULES = ("specialist-specialist", "generalist-specialist", "generalist-generalist")
RUNS = Path("runs/other_seeds")
Effects = dict[str, float]


# ---- Notebook 3 ----------------------------------------------------------------------------------


def chosen(seed: int) -> Effects:
    """The best of thousands of random genomes in four matches minus the same in new ones."""
    rng = np.random.default_rng(seed)
    genomes = [chapter_3.NETWORK.initial(rng, weight=0.2, head=0.5) for _ in range(3000)]

    def score(genomes: list[np.ndarray], seeds: range) -> np.ndarray:
        who, luck = np.repeat(range(len(genomes)), len(seeds)), np.tile(seeds, len(genomes))
        team = mw.Population(np.stack(genomes), chapter_3.NETWORK)
        played = mw.rollout(chapter_3.WORLD, team, "random", mw.Matches.of(who, 0, luck))
        return played.captured_fraction.reshape(len(genomes), len(seeds)).mean(axis=1)

    first = score(genomes, range(4))
    (again,) = score([genomes[first.argmax()]], range(1000, 1200))
    lost, left = first.max() - again, again - first.mean()
    return {"lost in new matches, less what is left": lost - left}


def race_by_hand(seed: int) -> Effects:
    payoff = chapter_3.all_against_all(chapter_3.race(seed, 12))
    return {"captured by first pursuers, last evaders minus first": payoff[0, -1] - payoff[0, 0]}


# ---- Notebooks 4 and 6: the numbers games --------------------------------------------------------

SHOWN = np.arange(0, 601, 20)


def numbers_games(seed: int) -> Effects:
    scalar, intransitive = (
        toys.numbers_game(name, seed).final_objective[0] for name in ("scalar", "intransitive")
    )
    return {"scalar minus intransitive": scalar - intransitive}


def nim(seed: int) -> Effects:
    """What the first player of the last generation scores in its race, and against perfect play."""
    first, second = toys.race_of_nim(seed)
    rivals = second, toys.perfect_players(100)
    inside, outside = (toys.all_against_all(toys.NIM, first[-1:], r).mean() for r in rivals)
    return {"in the race minus outside": inside - outside}


def tournament_gain(seed: int) -> Effects:
    race = toys.numbers_game("intransitive", seed)
    scores = race.scores(SHOWN, 25, np.random.default_rng(1)).mean(axis=2).mean(axis=1)
    ones = race.objective[SHOWN, 0].mean(axis=1)
    return {"ones of the picked generation": ones[scores.argmax()] - ones[-1]}


def red_queen(seed: int) -> Effects:
    """Changes of specialists in the world of notebook 4."""
    run = finish(chapter_4.settings(seed), RUNS / "chapter_4" / str(seed))
    pursuers, evaders = (each[[0, 2, 8]] for each in chapter_4.scores(run, np.arange(0, 25, 3)))
    diagonal = np.diag(run.payoff().matrix)[[0, 6, 24]]
    return {
        "diagonal at first": diagonal[1] - diagonal[0],
        "diagonal later": diagonal[2] - diagonal[1],
        "pursuers at first": pursuers[1] - pursuers[0],
        "pursuers later": pursuers[2] - pursuers[1],
        "pursuers, whole race": pursuers[2] - pursuers[0],
        "evaders at first": evaders[1] - evaders[0],
        "evaders, whole race": evaders[2] - evaders[0],
    }


# ---- Notebooks 5 and 6: the paper's races --------------------------------------------------------


@cache
def paper_races() -> dict[str, np.ndarray]:
    """Return the captured fractions (20 seeds, n, n, episodes) of each schedule."""
    with np.load(PAPER) as file:
        return {name: file[f"captured {name}"] / int(file["evaders"]) for name in PAPER_SCHEDULES}


def paper_race(seed: int) -> Effects:
    rates = {name: each[seed].mean(axis=2) for name, each in paper_races().items()}
    special, mixed, general = rates.values()
    late = {name: analysis.last_half(each) for name, each in rates.items()}
    rises = {
        f"{name}: rise of {team} in the last half": curve[-5:].mean() - curve[:5].mean()
        for name, each in late.items()
        for team, curve in zip(("pursuers", "evaders"), analysis.generalization(each), strict=True)
    }
    share, boards = (analysis.MEASURES[m].of for m in ("transitive_share", "checkerboards"))
    return rises | {
        "specialists: lag 5 minus lag 1": _at_lag(special, 5) - _at_lag(special, 1),
        "generalists: lag 5 minus lag 1": _at_lag(general, 5) - _at_lag(general, 1),
        "checkerboards: specialists minus mixed": boards(special).value - boards(mixed).value,
        "transitive share: specialists minus mixed": share(special).value - share(mixed).value,
    }


def _at_lag(rates: np.ndarray, lag: int) -> float:
    profile = analysis.lag_profile(rates)
    return float(profile.means[profile.lags == lag][0])


def noise(seed: int) -> Effects:
    """Whether a simple rule of notebook 5 is fooled by a race without change."""
    curves = analysis.generalization(noisy_race("noise only, .5", seed).mean(axis=2))
    alarm = all(curve[-1] > curve[0] for curve in curves)
    return {"false alarm, less one in ten": alarm - 0.1, "four in ten, less it": 0.4 - alarm}


# ---- Notebook 6: cures ---------------------------------------------------------------------------


@cache
def cure(name: str, seed: int) -> SavedRun:
    place = RUNS / "chapter_6" / name / str(seed)
    return finish(chapter_6.race(name, seed), place)


def cures(seed: int) -> Effects:
    """Cures minus specialists. All evaders meet the last pursuers of all kinds and seeds."""
    of = analysis.MEASURES["transitive_share"].of
    share = {name: of(cure(name, seed).payoff().matrix).value for name in chapter_6.SAMPLERS}
    kinds, seeds = chapter_6.SAMPLERS, SOURCES["cures"].others
    pursuers, evaders = (
        mw.Population(
            np.stack(
                [cure(kind, each).teams[team].genomes[-1] for kind in kinds for each in of_team]
            ),
            cure(kinds[0], seed).teams[team].policy,
        )
        for team, of_team in (("pursuer", seeds), ("evader", (seed,)))
    )
    payoff = coevolution.tournament(
        chapter_6.WORLD, pursuers, evaders, seed=0, episodes=chapter_6.CROSS_EPISODES, threads=1
    )
    escape = dict(zip(kinds, 1 - payoff.matrix.mean(axis=0), strict=True))
    return {
        f"{what} of {name}": found[name] - found["latest"]
        for what, found in (("transitive share", share), ("escapes", escape))
        for name in ("round-robin", "uniform")
    }


def halls(seed: int) -> Effects:
    """Return what halls of fame change in the races of ``evolution/hall_of_fame.py``."""
    # Scripts of one directory import each other by their plain names.
    sys.path.append(str(NOTEBOOKS.parent / "evolution"))
    from common import slug
    from hall_of_fame import kinds

    forgetting, found = analysis.MEASURES["pursuer_forgetting"], []
    for name, settings in kinds(quick=False).items():
        folder = RUNS / "hall_of_fame" / slug(name) / str(seed)
        run = finish(replace(settings, seed=seed), folder, settings.training_game.penalty)
        found.append(forgetting.of(run.payoff().matrix, "whole").value)
    without, with_halls = found
    return {"pursuers forget": with_halls - without}


# ---- Notebook 7 ----------------------------------------------------------------------------------


def disengaged(name: str, seed: int) -> bool:
    """Return whether disengagement is present in the last half of a race."""
    captured = chapter_7.captures(chapter_7.race(name, seed, RUNS / "chapter_7"))
    rates = captured / chapter_7.EVEN.game.world.n_evaders
    judged = analysis.judge(rates, per_episode=True)
    return judged.windows["last half"]["disengagement"].verdict == "present"


def restraint(seed: int) -> Effects:
    """Return whether races with few evader epochs disengage, in spite of restraint, too."""
    few, restrained = (
        disengaged(name, seed) for name in ("few evader epochs", "restrained pursuers")
    )
    return {
        "few evader epochs, less one half": few - 0.5,
        "restrained, less four in ten": restrained - 0.4,
        "few evader epochs minus restrained": float(few) - restrained,
    }


# ---- Notebook 9 ----------------------------------------------------------------------------------


def penalty(seed: int) -> Effects:
    """How a run at the paper's penalty ends."""
    run = evolve(seed, 12.0)
    captured, unsafe = (share / EPISODES for share in (run["captured"], EPISODES - run["safe"]))
    return {
        "captures nothing": float(captured < 0.05),
        "captures": float(captured > 0.9),
        "captures and collides": float(captured > 0.9) * unsafe,
    }


def masks(seed: int) -> Effects:
    """Return what a mask from the start changes, against one afterwards."""
    free = evolve(seed, 0.0)
    late = tested_masked(free["weights"], seed)
    start = evolve_masked(seed)
    return {
        "captures": (start["captured"] - late["captured"]) / EPISODES,
        "steps": (start["steps"] - late["steps"]) / EPISODES,
    }


# ---- Claims --------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Source:
    """Where effects come from: a function of a seed, and seeds that no notebook shows.

    Without `kept` the test plays them itself.
    """

    effects: Callable[[int], Effects]
    others: range
    kept: bool = False


SOURCES = {
    "red queen": Source(red_queen, range(10, 20), kept=True),
    "penalty": Source(penalty, range(20, 40), kept=True),
    "masks": Source(masks, range(20, 30), kept=True),
    "cures": Source(cures, range(10, 20), kept=True),
    "halls": Source(halls, range(10, 20), kept=True),
    "restraint": Source(restraint, range(10, 50), kept=True),
    "chosen": Source(chosen, range(100, 106)),
    "race by hand": Source(race_by_hand, range(100, 110)),
    "numbers games": Source(numbers_games, range(200, 210)),
    "nim": Source(nim, range(100, 120)),
    "tournament": Source(tournament_gain, range(120, 200)),
    "paper": Source(paper_race, range(10, 20)),
    "noise": Source(noise, range(200, 400)),
}


def main() -> None:
    """Play what takes long; each source is kept once all of its seeds are played."""
    arrays = dict(load_arrays(KEPT)) if KEPT.exists() else {}
    for name, source in SOURCES.items():
        if source.kept and not any(key.startswith(f"{name}: ") for key in arrays):
            rows = [source.effects(seed) for seed in tqdm(source.others, desc=name)]
            arrays |= {f"{name}: {key}": np.array([row[key] for row in rows]) for key in rows[0]}
            save_arrays(KEPT, arrays)
    print(f"{KEPT.name}: {KEPT.stat().st_size / 1e3:.0f} kB")


if __name__ == "__main__":
    main()
