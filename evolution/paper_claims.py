"""Which claims of the paper hold? Races, baselines and surrounding over ten training seeds.

    python evolution/paper_claims.py              about an hour on two cores; can be interrupted
    python evolution/paper_claims.py --quick      a small world and two seeds, less than a minute

Method: the experiments of Sun et al. (2023), "MatrixWorld", arXiv:2307.14854, with two differences:
the policy is a small network, and it learns by evolution strategies instead of policy gradients.
Each claim becomes one number for each seed and a threshold. It is reproduced if the interval over
seeds lies on the claimed side, not reproduced if it lies on the other side, and else undecided.

Look at the table of claims, and at the scores below it, which show how much is due to the seed.
``--results`` receives both tables and the numbers behind them; ``--runs`` keeps the runs.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, fields, replace
from functools import partial
from pathlib import Path

import numpy as np
from tqdm import tqdm

import matrixworld as mw
from common import script_parser
from matrixworld import analysis
from matrixworld.coevolution import (
    RaceSettings,
    SavedRun,
    SingleSettings,
    SingleTeam,
    Team,
    open_run,
    resume,
    start,
    tournament,
)
from matrixworld.coevolution.types import other

SPECIALISTS, GENERALISTS = "specialist-specialist", "generalist-generalist"
MIXED = "generalist-specialist"
PURSUERS_ALONE = "pursuers against random"
EVADERS_ALONE, EVADERS_TAUGHT = "evaders against random", "evaders against trained"
SURROUNDING = {
    "rewards": "surrounding for rewards",
    "captured-fraction": "surrounding for captures",
}
RACES = (SPECIALISTS, MIXED, GENERALISTS)
CANDIDATES: dict[Team, tuple[str, ...]] = {
    "pursuer": (*RACES, PURSUERS_ALONE),
    "evader": (*RACES, EVADERS_ALONE, EVADERS_TAUGHT),
}
"""Runs whose last generation is tested, by team."""


@dataclass(frozen=True)
class Plan:
    """Settings of all runs, without their seeds.

    Parameters
    ----------
    race : RaceSettings
        Settings of the races, except for the schedule.
    pursuers, evaders : SingleSettings
        Baselines, with as many matches as the team plays in a race.
    surround : SingleSettings
        Surrounding runs, one for each fitness of `SURROUNDING`.
    every : int
        Distance of the generations of a race that are test opponents.
    episodes : int
        Episodes of each pair in the cross-play.
    """

    race: RaceSettings
    pursuers: SingleSettings
    evaders: SingleSettings
    surround: SingleSettings
    every: int
    episodes: int


def plan(race: RaceSettings, surround: SingleSettings, *, every: int, episodes: int) -> Plan:
    """Return a plan whose baselines have the world and the budget of the race."""

    def alone(team: Team) -> SingleSettings:
        # As many epochs as the team has in a race, and every other setting of the race: the same
        # number of matches, training steps, step sizes and penalties.
        epochs = race.total_epochs(team)
        same = {item.name for item in fields(race)} & {item.name for item in fields(SingleSettings)}
        settings = {name: getattr(race, name) for name in same}
        # The penalty is one of evaders; pursuers take no such setting.
        settings["overlap_penalty"] = race.resolved_overlap_penalty if team == "evader" else None
        return SingleSettings(team=team, epochs=epochs, archive_every=epochs // 2, **settings)

    return Plan(race, alone("pursuer"), alone("evader"), surround, every, episodes)


FULL = plan(
    RaceSettings(),
    SingleSettings(variant="S", population=48, epochs=1200, archive_every=200),
    every=5,
    episodes=10,
)
TINY = {"rows": 12, "cols": 12, "population": 8, "train_steps": 40, "eval_steps": 60}
QUICK = plan(
    RaceSettings(
        pursuers=3, evaders=6, generations=6, pursuer_epochs=4, evader_epochs=4, **TINY
    ),
    SingleSettings(
        variant="S", pursuers=8, evaders=2, epochs=20, archive_every=5, eval_episodes=5, **TINY
    ),
    every=3,
    episodes=2,
)  # fmt: skip


def play(plan: Plan, seed: int, root: Path, threads: int | None) -> dict[str, SavedRun]:
    """Return the finished runs of one seed; start or continue them if necessary."""
    runs: dict[str, SavedRun] = {}

    def played(name: str, begin: Callable[[Path], object]) -> None:
        place = root / name.replace(" ", "-") / str(seed)
        # A run that has begun is resumed, whether or not it has finished.
        if not (place / "config.json").exists():
            begin(place)
        run = resume(place, threads=threads)
        with tqdm(desc=f"seed {seed}: {name}", unit=" matches", disable=None, leave=False) as bar:

            def report(what: str, done: int, total: int) -> None:
                bar.total = total
                bar.update(done - bar.n)

            run.run(report)
        runs[name] = open_run(place)

    def taught(place: Path) -> None:
        """Start evaders after half of their baseline, now against trained pursuers."""
        half = plan.evaders.archive_every
        settings = replace(plan.evaders, seed=seed, epochs=half)
        genome = runs[EVADERS_ALONE].teams["evader"].genomes[1]
        rivals = runs[PURSUERS_ALONE].teams["pursuer"]
        champion = mw.Population(rivals.genomes[-1:], rivals.network)
        SingleTeam(settings, place, opponents=champion, start=genome)

    planned: dict[str, RaceSettings | SingleSettings] = {
        **{name: replace(plan.race, schedule=name) for name in RACES},
        PURSUERS_ALONE: plan.pursuers,
        EVADERS_ALONE: plan.evaders,
        **{name: replace(plan.surround, fitness=aim) for aim, name in SURROUNDING.items()},
    }
    # In this order: trained evaders continue from two of the runs before them.
    for name, settings in planned.items():
        played(name, partial(start, replace(settings, seed=seed)))
    played(EVADERS_TAUGHT, taught)
    return runs


def cross_play(
    plan: Plan, team: Team, runs: Sequence[Mapping[str, SavedRun]], threads: int | None
) -> np.ndarray:
    """Play a team's candidates against the opponents of all races.

    Parameters
    ----------
    plan : Plan
        Settings of the runs.
    team : {"pursuer", "evader"}
        Team of the candidates.
    runs : sequence of mapping of str to SavedRun
        Runs of each seed by name.
    threads : int or None
        Threads; None: one for each core.

    Returns
    -------
    ndarray of float64, shape (kinds, seeds, races, seeds, generations)
        Payoff of each kind of `CANDIDATES` and seed against every so many generations of each race
        and seed.
    """
    own = [of_seed[kind].teams[team] for kind in CANDIDATES[team] for of_seed in runs]
    rivals = [of_seed[race].teams[other(team)] for race in RACES for of_seed in runs]
    # One population of all candidates and one of all opponents: a single tournament.
    candidates = mw.Population(np.stack([each.genomes[-1] for each in own]), own[0].network)
    opponents = np.concatenate([each.genomes[:: plan.every] for each in rivals])
    met = mw.Population(opponents, rivals[0].network)
    pursuers, evaders = (candidates, met) if team == "pursuer" else (met, candidates)
    world = plan.race.world(plan.race.eval_steps)
    played = tournament(
        world, pursuers, evaders, seed=0, episodes=plan.episodes, threads=threads
    ).capture_rate
    payoff = played if team == "pursuer" else 1.0 - played.T
    return payoff.reshape(len(CANDIDATES[team]), len(runs), len(RACES), len(runs), -1)


def against_other_seeds(payoff: np.ndarray) -> np.ndarray:
    """Return the mean payoff (kinds, seeds) against the opponents of races of other seeds."""
    # Opponents of the own seed have trained against the candidates of the races.
    others = ~np.eye(payoff.shape[1], dtype=bool)
    # Mean over races (specialists and generalists) and generations of the opponents.
    by_pair = payoff.mean(axis=(2, 4))
    return (by_pair * others).sum(axis=2) / others.sum(axis=1)


def surrounding(
    plan: Plan, runs: Sequence[SavedRun], threads: int | None
) -> tuple[np.ndarray, np.ndarray]:
    """Return capture rate, and collisions between pursuers per 1000 of their agent-steps.

    Both have the shape (seeds, entries of the archive); 100 episodes each.
    """
    captured, collisions = [], []
    for run in runs:
        pursuers = run.teams["pursuer"]
        each = np.arange(len(pursuers.genomes))
        world = plan.surround.world(plan.surround.eval_steps)
        scores = mw.rollout(
            world, pursuers, "random", mw.Matches.of(each, 0, each), worlds=100, threads=threads
        )
        captured.append(scores.capture_rate.mean(axis=1))
        steps = scores.agent_steps[:, :, 0].sum(axis=1)
        collisions.append(1000 * scores.collisions[:, :, 0, 1].sum(axis=1) / steps)
    return np.array(captured), np.array(collisions)


@dataclass(frozen=True)
class Claim:
    """A statement of the paper as one number for each seed.

    Parameters
    ----------
    says : str
        The statement.
    measured : str
        Name of the number.
    values : ndarray of float64, shape (seeds,)
        The number for each seed.
    side : {"above", "below"}
        Side of the threshold on which the number lies if the claim is true.
    than : float, optional
        The threshold.
    """

    says: str
    measured: str
    values: np.ndarray
    side: str
    than: float = 0.0

    @property
    def estimate(self) -> analysis.Estimate:
        """Mean over the seeds with an interval."""
        return analysis.bootstrap_runs(self.values)

    @property
    def verdict(self) -> str:
        """Verdict: reproduced, not reproduced or undecided."""
        low, high = self.estimate.low, self.estimate.high
        # Below a threshold is above the negative one.
        if self.side == "below":
            low, high, than = -high, -low, -self.than
        else:
            than = self.than
        if low > than:
            return "reproduced"
        return "not reproduced" if high <= than else "undecided"


SOME_CHECKERBOARDS = 0.01
"""Checkerboard share of a race that cycles; an additive matrix with the noise of ten episodes has
none."""
CLEARLY = 0.05
"""Difference of capture rates above which co-evolved pursuers would be clearly better."""


def measured(
    plan: Plan, runs: Sequence[Mapping[str, SavedRun]], threads: int | None
) -> dict[str, np.ndarray]:
    """Return all numbers behind the claims by name, as float32 arrays, as they are written."""
    numbers = {
        f"payoff {race}": np.stack([of_seed[race].payoff().capture_rate for of_seed in runs])
        for race in RACES
    }
    for team in CANDIDATES:
        numbers[f"cross-play of {team}s"] = cross_play(plan, team, runs, threads)
    for name in SURROUNDING.values():
        both = surrounding(plan, [of_seed[name] for of_seed in runs], threads)
        numbers[f"{name}: captured"], numbers[f"{name}: collisions"] = both
    # float32 halves the file and keeps far more digits than ten episodes give.
    return {name: each.astype(np.float32) for name, each in numbers.items()}


def standings(numbers: Mapping[str, np.ndarray], team: Team) -> dict[str, np.ndarray]:
    """Return the mean payoff (seeds,) of each kind of `CANDIDATES` against other seeds."""
    payoff = numbers[f"cross-play of {team}s"].astype(np.float64)
    return dict(zip(CANDIDATES[team], against_other_seeds(payoff), strict=True))


def claims(numbers: Mapping[str, np.ndarray]) -> list[Claim]:
    """Return the claims of the paper with the numbers of each seed, from those of `measured`."""
    # From a file the numbers come as float32; a fresh run is rounded in the same way.
    numbers = {name: each.astype(np.float64) for name, each in numbers.items()}

    def of(measure: str, race: str) -> np.ndarray:
        matrices = numbers[f"payoff {race}"]
        return np.array([analysis.MEASURES[measure].of(matrix) for matrix in matrices])

    def forgotten(race: str) -> np.ndarray:
        return (of("pursuer_forgetting", race) + of("evader_forgetting", race)) / 2

    pursuers, evaders = standings(numbers, "pursuer"), standings(numbers, "evader")
    boards = analysis.MEASURES["checkerboards"].label
    escape, capture = "difference of escape rates", "difference of capture rates"
    return [
        Claim(
            "Specialists against specialists cycle",
            boards, of("checkerboards", SPECIALISTS), "above", SOME_CHECKERBOARDS,
        ),
        Claim(
            "Generalists against generalists do not",
            boards, of("checkerboards", GENERALISTS), "below", SOME_CHECKERBOARDS,
        ),
        Claim(
            "Specialists forget more than generalists",
            "forgetting, specialists minus generalists",
            forgotten(SPECIALISTS) - forgotten(GENERALISTS), "above",
        ),
        Claim(
            "Co-evolved evaders generalise better than those trained against random pursuers",
            escape, evaders[GENERALISTS] - evaders[EVADERS_ALONE], "above",
        ),
        Claim(
            "Co-evolved evaders generalise better than those trained against trained pursuers",
            escape, evaders[GENERALISTS] - evaders[EVADERS_TAUGHT], "above",
        ),
        Claim(
            "Co-evolved pursuers are not clearly better than those trained against random evaders",
            capture, pursuers[GENERALISTS] - pursuers[PURSUERS_ALONE], "below", CLEARLY,
        ),
        *(
            claim
            for name in SURROUNDING.values()
            for claim in _of_surrounding(
                name, numbers[f"{name}: captured"], numbers[f"{name}: collisions"]
            )
        ),
    ]  # fmt: skip


def _of_surrounding(name: str, captured: np.ndarray, collisions: np.ndarray) -> list[Claim]:
    gained, more = captured[:, -1] - captured[:, 0], collisions[:, -1] - collisions[:, 0]
    collided = "collisions with teammates per 1000 agent-steps"
    return [
        Claim(f"{name}: capture improves", "capture rate, last minus untrained", gained, "above"),
        Claim(f"{name}: collisions of teammates remain", collided, collisions[:, -1], "above"),
        Claim(f"{name}: collisions increase", f"{collided}, last minus untrained", more, "above"),
    ]


def printed(estimate: analysis.Estimate) -> str:
    """Return a mean and its interval as text."""
    return f"{estimate.value:.3f} [{estimate.low:.3f}, {estimate.high:.3f}]"


def tables(numbers: Mapping[str, np.ndarray]) -> str:
    """Return the claims, and the scores against races of other seeds, as tables in Markdown."""
    lines = ["| the paper's claim | measured | mean [95%] | claimed | |", "|---|---|---|---|---|"]
    for claim in claims(numbers):
        side = f"{claim.side} {claim.than:g}"
        cells = (claim.says, claim.measured, printed(claim.estimate), side)
        lines.append(f"| {' | '.join(cells)} | **{claim.verdict}** |")
    lines += ["", "| trained | team | score against races of other seeds |", "|---|---|---|"]
    for team in CANDIDATES:
        for kind, values in standings(numbers, team).items():
            lines.append(f"| {kind} | {team}s | {printed(analysis.bootstrap_runs(values))} |")
    return "\n".join(lines)


def main() -> None:
    """Play missing runs, test the claims, print and write the results."""
    parser = script_parser(__doc__, quick="a small world and two seeds")
    parser.add_argument("--seeds", type=int, help="training seeds; default 10, or 2 with --quick")
    parser.add_argument("--runs", type=Path, default=Path("runs/paper_claims"))
    parser.add_argument("--results", type=Path, default=Path("paper_claims"))
    parser.add_argument("--threads", type=int, help="default: one for each core")
    args = parser.parse_args()
    plan = QUICK if args.quick else FULL
    seeds = range(args.seeds or (2 if args.quick else 10))
    runs = [play(plan, seed, args.runs, args.threads) for seed in seeds]
    numbers = measured(plan, runs, args.threads)
    text = tables(numbers)
    print(text)
    args.results.mkdir(parents=True, exist_ok=True)
    (args.results / "claims.md").write_text(text + "\n", encoding="utf-8")
    np.savez_compressed(args.results / "numbers.npz", **numbers)
    print(f"Written: {args.results}/claims.md, {args.results}/numbers.npz")


if __name__ == "__main__":
    main()
