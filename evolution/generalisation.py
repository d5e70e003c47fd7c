"""Who generalises: co-evolved teams beside teams trained in plain ways, at equal matches.

    python evolution/generalisation.py             some minutes; can be interrupted
    python evolution/generalisation.py --quick     a small world, some seconds

The comparison of Sun et al. 2023, "MatrixWorld", arXiv:2307.14854. Beside a race there are three
baselines: pursuers that learn against random evaders, evaders that learn against random pursuers,
and evaders that do so for half their time and then learn against well-trained pursuers. Each
plays as many matches as its team plays in the race. Then all of them meet every generation of the
race's opponents. The mean score is their generalisation, drawn for every generation of the race;
the worst is what is left of it before an opponent that knows where to look. Beside it stands what
a team scores at home, against those it has learned against: look how far a baseline falls.

The race's own teams are at home with the race's opponents, the baselines meet them for the first
time. So there is a second race, of the next seed, whose opponents are strangers to all. And one
race is one draw of luck: try another ``--seed``, or ``paper_claims.py``, which asks ten of them.

Runs lie in ``--runs`` and are taken up where they were interrupted. A further schedule costs no
more than its races: the baselines are there already.
"""

from __future__ import annotations

import argparse
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

import matrixworld as mw
from matrixworld import coevolution, plots
from matrixworld.coevolution import RaceSettings, SavedRun, SingleSettings, Team

FULL = RaceSettings(rows=30, cols=30, pursuers=6, evaders=12, generations=20)
QUICK = RaceSettings(
    rows=12, cols=12, pursuers=3, evaders=6, population=12,
    generations=8, pursuer_epochs=10, evader_epochs=20, train_steps=60, eval_steps=80,
)  # fmt: skip
SAME = ("rows", "cols", "pursuers", "evaders", "population", "train_steps", "eval_steps", "seed")
"""What the baselines share with the race."""

CHASING, FLEEING = "pursuers-against-random", "evaders-against-random"
HALFWAY, TAUGHT = "evaders-against-random-half", "evaders-against-trained"
BASELINES: dict[Team, dict[str, tuple[str, ...]]] = {
    "pursuer": {"against random evaders": (CHASING,)},
    "evader": {
        "against random pursuers": (FLEEING,),
        "against trained pursuers": (HALFWAY, TAUGHT),
    },
}
"""The baselines of each team, and the runs that each consists of."""
RIVALS: dict[Team, Team] = {"pursuer": "evader", "evader": "pursuer"}
EPISODES = 50
"""Of each pair in the comparison."""


def another(race: RaceSettings) -> str:
    """The name of the race whose opponents are strangers to all."""
    return f"{race.schedule}-of-next-seed"


def plans(race: RaceSettings, root: Path) -> dict[str, RaceSettings | SingleSettings]:
    """The settings of all runs by name, each after those that it builds on."""
    same = {name: getattr(race, name) for name in SAME}
    chasing = SingleSettings(team="pursuer", epochs=race.total_epochs("pursuer"), **same)
    fleeing = SingleSettings(team="evader", epochs=race.total_epochs("evader"), **same)
    halfway = replace(fleeing, epochs=fleeing.epochs // 2)
    teacher, pupil = str(root / CHASING), str(root / HALFWAY)
    taught = replace(halfway, against=teacher, start=pupil, anneal=False)
    return {
        race.schedule: race,
        another(race): replace(race, seed=race.seed + 1),
        CHASING: chasing,
        FLEEING: fleeing,
        HALFWAY: halfway,
        TAUGHT: taught,
    }


def played(settings: RaceSettings | SingleSettings, place: Path) -> SavedRun:
    """The finished run at a place: begun if there is none, and taken up where it stopped."""
    with coevolution.ProgressBar() as bar:
        return coevolution.finish(settings, place, report=bar)


def matches(team: Team, runs: list[SavedRun]) -> int:
    """The matches in which a team has learned in these runs."""
    epochs = (int(np.sum(run.files.log()["team"] == team)) for run in runs)
    return sum(count * run.settings.population for count, run in zip(epochs, runs, strict=True))


@dataclass(frozen=True)
class Standing:
    """How a team's last generation does that was trained in one way."""

    team: Team
    way: str
    matches: int
    home: float
    """Mean score against those it has learned against."""
    scores: np.ndarray
    """Against each generation of the race's opponents: (generations,), in [0, 1]."""
    strange: np.ndarray
    """The same against the opponents of another race."""

    def __str__(self) -> str:
        numbers = (f"{each.mean():.2f} | {each.min():.2f}" for each in (self.scores, self.strange))
        cells = (f"{self.team}s", self.way, f"{self.matches:,}", f"{self.home:.2f}", *numbers)
        return f"| {' | '.join(cells)} |"


def standings(team: Team, race: RaceSettings, runs: dict[str, SavedRun]) -> list[Standing]:
    """The standing of a team by each way of training, that of the race first."""
    world = race.world(race.eval_steps)

    def of_last(payoff: coevolution.Payoff) -> np.ndarray:
        rates = payoff.capture_rate
        return rates[-1] if team == "pursuer" else 1 - rates[:, -1]

    def scores(own: mw.Population, rivals: mw.Population) -> np.ndarray:
        sides = (own, rivals) if team == "pursuer" else (rivals, own)
        return of_last(coevolution.tournament(world, *sides, seed=race.seed, episodes=EPISODES))

    told, races = [], (race.schedule, another(race))
    for way, names in {"in the race": (race.schedule,), **BASELINES[team]}.items():
        parts = [runs[name] for name in names]
        learned = parts[-1].teams[team]
        last = mw.Population(learned.genomes[-1:], learned.network)
        met = [scores(last, runs[name].teams[RIVALS[team]]) for name in races]
        home = of_last(parts[-1].payoff()).mean()
        told.append(Standing(team, way, matches(team, parts), float(home), *met))
    return told


def main() -> None:
    """Play what is missing; print and draw what came of it."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--quick", action="store_true", help="a small world and few epochs")
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument(
        "--schedule", choices=coevolution.SCHEDULES, default="generalist-generalist"
    )
    parser.add_argument("--runs", type=Path, default=Path("runs/generalisation"))
    parser.add_argument("--figure", default="generalisation.png", help="file to draw to")
    args = parser.parse_args()
    race = replace(QUICK if args.quick else FULL, schedule=args.schedule, seed=args.seed)
    root = args.runs / f"{'quick' if args.quick else 'full'}-{args.seed}"
    runs = {name: played(settings, root / name) for name, settings in plans(race, root).items()}

    told = {team: standings(team, race, runs) for team in coevolution.TEAMS}
    print("| | trained | matches | at home | the race's opponents | worst | strangers | worst |")
    print("|---|---|---|---|---|---|---|---|")
    print(*told["pursuer"], *told["evader"], sep="\n")
    lines = {
        f"{team}_baselines": {f"{team}s {each.way}": each.scores.mean() for each in standing[1:]}
        for team, standing in told.items()
    }
    payoff = runs[race.schedule].payoff().capture_rate
    title = f"Generalisation: {race.schedule}, and baselines"
    plots.generalization_curves(payoff, **lines, title=title).savefig(args.figure)
    print(f"Drawn: {args.figure}. Runs: {root}")


if __name__ == "__main__":
    main()
