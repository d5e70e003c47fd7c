"""Do co-evolved teams generalise better? A race and three baselines, at equal matches.

    python evolution/generalization.py             some minutes; can be interrupted
    python evolution/generalization.py --quick     a small world, some seconds

There are three baselines beside a race: pursuers that learn against random evaders, evaders that
learn against random pursuers, and evaders that learn against random pursuers for half of their
matches and then against trained pursuers. Each baseline plays as many matches as its team plays in
the race. Then the race's teams and the baselines meet all generations of the race's opponents.

The race's own teams have trained against these opponents; the baselines have not. Therefore a
second race with the next seed provides opponents that are new to all teams.

Method: the comparison of Sun et al. (2023), "MatrixWorld", arXiv:2307.14854.

Look at the mean score, which is the generalization, and at the worst score, which is what remains
against the most difficult opponent. Compare both with the score against the training opponents: it
shows how much a baseline loses against new ones. A single race depends on its seed: try another
``--seed``, or ``paper_claims.py``, which runs twenty seeds.

Runs are kept in ``--runs``; an interrupted script continues where it stopped. A second schedule
takes its own races only, since the baselines exist already.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

import matrixworld as mw
from common import SAME_STEPS, SMALL_STEPS, long_race, markdown, script_parser
from matrixworld import coevolution, plots
from matrixworld.coevolution import RaceSettings, SavedRun, Team
from matrixworld.coevolution.types import other

FULL = RaceSettings.of({
    **long_race("generalist-generalist"), "schedule.generations": 20,
    "world.rows": 30, "world.cols": 30, "world.n_pursuers": 6, "world.n_evaders": 12,
})  # fmt: skip
QUICK = RaceSettings.of({
    "world.rows": 12, "world.cols": 12, "world.n_pursuers": 3, "world.n_evaders": 6,
    "world.max_steps": 80, "train_steps": 60, **SAME_STEPS, "learner.population": 12,
    "schedule.generations": 8, "schedule.pursuer_epochs": 10, "schedule.evader_epochs": 20,
})  # fmt: skip

CHASING, FLEEING = "pursuers-against-random", "evaders-against-random"
HALFWAY, TAUGHT = "evaders-against-random-half", "evaders-against-trained"
BASELINES: dict[Team, dict[str, tuple[str, ...]]] = {
    "pursuer": {"against random evaders": (CHASING,)},
    "evader": {
        "against random pursuers": (FLEEING,),
        "against trained pursuers": (HALFWAY, TAUGHT),
    },
}
"""The baselines of each team, and the consecutive runs of each baseline."""
EPISODES = 50
"""Episodes of each pair in the comparison."""


def another(race: RaceSettings) -> str:
    """Return the name of the race whose opponents are new to all teams."""
    return f"{race.schedule.name}-of-next-seed"


def plans(race: RaceSettings, root: Path) -> dict[str, RaceSettings]:
    """Return the settings of all runs by name; a run comes after the runs that it builds on."""
    # Baselines differ from the race in their opponents and in nothing else.
    chasing, fleeing = (
        RaceSettings.of(
            {
                "schedule": "against",
                "schedule.team": team,
                "schedule.epochs": race.schedule.total_epochs(team),
                **SMALL_STEPS[team],
                "world": race.world,
                "learner.population": race.learner.population,
                "train_steps": race.train_steps,
                "seed": race.seed,
            }
        )
        for team in coevolution.TEAMS
    )
    # A run of its own rather than a part of `fleeing`, since its learning rate falls sooner.
    halfway = fleeing.changed({"schedule.epochs": fleeing.schedule.epochs // 2})
    teacher, pupil = str(root / CHASING), str(root / HALFWAY)
    # A constant learning rate, as in the race.
    taught = halfway.changed(
        {"schedule.opponent": teacher, "schedule.start": pupil, "learner.anneal": False}
    )
    return {
        race.schedule.name: race,
        another(race): replace(race, seed=race.seed + 1),
        CHASING: chasing,
        FLEEING: fleeing,
        HALFWAY: halfway,
        TAUGHT: taught,
    }


def played(settings: RaceSettings, place: Path) -> SavedRun:
    """Return the finished run at a place; start or continue it if necessary."""
    with coevolution.ProgressBar() as bar:
        return coevolution.finish(settings, place, report=bar)


def matches(team: Team, runs: list[SavedRun]) -> int:
    """Return the number of matches in which a team has learned in these runs."""
    epochs = (int(np.sum(run.log()["team"] == team)) for run in runs)
    return sum(
        count * run.settings.learner.population for count, run in zip(epochs, runs, strict=True)
    )


@dataclass(frozen=True)
class Standing:
    """Scores of a team's last generation after one kind of training."""

    team: Team
    training: str
    matches: int
    """Training matches."""
    in_training: float
    """Mean score against the training opponents."""
    scores: np.ndarray
    """Score against each generation of the race's opponents, in [0, 1]."""
    new: np.ndarray
    """Score against each generation of another race's opponents."""

    def cells(self) -> list[str]:
        """Return a line of the table."""
        ends = (
            each for scores in (self.scores, self.new) for each in (scores.mean(), scores.min())
        )
        trained = [f"{self.team}s", self.training, f"{self.matches:,}", f"{self.in_training:.2f}"]
        return [*trained, *(f"{end:.2f}" for end in ends)]


def standings(team: Team, race: RaceSettings, runs: dict[str, SavedRun]) -> list[Standing]:
    """Return the standing of a team after each kind of training, the race first."""
    world = race.world

    def of_last(payoff: coevolution.Payoff) -> np.ndarray:
        rates = payoff.capture_rate
        return rates[-1] if team == "pursuer" else 1 - rates[:, -1]

    def scores(own: mw.Population, rivals: mw.Population) -> np.ndarray:
        sides = (own, rivals) if team == "pursuer" else (rivals, own)
        return of_last(coevolution.tournament(world, *sides, seed=race.seed, episodes=EPISODES))

    found, races = [], (race.schedule.name, another(race))
    for training, names in {"in the race": (race.schedule.name,), **BASELINES[team]}.items():
        parts = [runs[name] for name in names]
        last = parts[-1].last(team)
        met = [scores(last, runs[name].teams[other(team)]) for name in races]
        # The run's own payoff matrix: its last genome against its training opponents.
        in_training = of_last(parts[-1].payoff()).mean()
        found.append(Standing(team, training, matches(team, parts), float(in_training), *met))
    return found


def main() -> None:
    """Play missing runs; print and draw the standings."""
    parser = script_parser(__doc__, quick="a small world and few epochs")
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument(
        "--schedule", choices=coevolution.SCHEDULES, default="generalist-generalist"
    )
    parser.add_argument("--runs", type=Path, default=Path("runs/generalization"))
    parser.add_argument("--figure", default="generalization.png", help="file to draw to")
    args = parser.parse_args()
    race = QUICK if args.quick else FULL.changed({"schedule": args.schedule, "seed": args.seed})
    # Quick and full runs, and different seeds, never share a directory.
    root = args.runs / f"{'quick' if args.quick else 'full'}-{args.seed}"
    runs = {name: played(settings, root / name) for name, settings in plans(race, root).items()}

    found = {team: standings(team, race, runs) for team in coevolution.TEAMS}
    print("Mean score against the training opponents; mean and worst score against the race's")
    print("opponents and against new opponents, those of another race.\n")
    heads = ["team", "trained", "matches", "training", "race", "worst", "new", "worst"]
    print(markdown(heads, [each.cells() for of_team in found.values() for each in of_team]))
    lines = {
        f"{team}_baselines": {
            f"{team}s {each.training}": each.scores.mean() for each in standing[1:]
        }
        for team, standing in found.items()
    }
    payoff = runs[race.schedule.name].payoff().capture_rate
    title = f"Generalization: {race.schedule.name}, and baselines"
    plots.generalization_curves(payoff, **lines, title=title).savefig(args.figure)
    print(f"Drawn: {args.figure}. Runs: {root}")


if __name__ == "__main__":
    main()
