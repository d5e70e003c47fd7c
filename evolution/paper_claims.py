"""What the paper claims, put to the test: races, baselines and surrounding, over training seeds.

    python evolution/paper_claims.py              about an hour on two cores; can be interrupted
    python evolution/paper_claims.py --quick      a small world and two seeds, less than a minute

Sun et al. 2023, "MatrixWorld", arXiv:2307.14854. A claim is reproduced where its whole interval
over the seeds lies on the right side, not reproduced where it lies on the wrong one, and undecided
otherwise. Runs lie in ``--runs`` and are taken up where they were interrupted; ``--results`` gets
a table and the numbers behind it. A small policy, and evolution strategies for policy gradients.
"""

from __future__ import annotations

import argparse
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path

import numpy as np
from tqdm import tqdm

import matrixworld as mw
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

SPECIALISTS, GENERALISTS = "specialist-specialist", "generalist-generalist"
PURSUERS_ALONE, EVADERS_ALONE = "pursuers against random", "evaders against random"
EVADERS_TAUGHT = "evaders against trained"
SURROUNDING = {
    "rewards": "surrounding for rewards",
    "captured-fraction": "surrounding for captures",
}
RACES = (SPECIALISTS, GENERALISTS)
CANDIDATES: dict[Team, tuple[str, ...]] = {
    "pursuer": (*RACES, PURSUERS_ALONE),
    "evader": (*RACES, EVADERS_ALONE, EVADERS_TAUGHT),
}
"""The runs of which the last generation is put to the test, by team."""


@dataclass(frozen=True)
class Plan:
    """Settings of all runs but for their seeds; a baseline plays as many matches as its rival."""

    race: RaceSettings
    pursuers: SingleSettings
    evaders: SingleSettings
    surround: SingleSettings
    """Played once for each fitness of `SURROUNDING`."""
    every: int
    """Of so many generations of a race, one is among the test opponents."""
    episodes: int
    """Of each pair of the cross-play."""


def plan(race: RaceSettings, surround: SingleSettings, *, every: int, episodes: int) -> Plan:
    """A plan whose baselines have the world and the budget of a race."""

    def alone(team: Team) -> SingleSettings:
        epochs = race.total_epochs(team)
        same = ("variant", "rows", "cols", "pursuers", "evaders", "population", "eval_steps")
        return SingleSettings(
            team=team,
            epochs=epochs,
            archive_every=epochs // 2,
            **{name: getattr(race, name) for name in same},
        )

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
    """The finished runs of one seed, those of them played that are not there yet."""
    runs: dict[str, SavedRun] = {}

    def played(name: str, begin: Callable[[Path], object]) -> None:
        place = root / name.replace(" ", "-") / str(seed)
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
        """Evaders that have learned from random pursuers go on with pursuers that have learned."""
        half = plan.evaders.archive_every
        settings = replace(plan.evaders, seed=seed, epochs=half, anneal=False, overlap_penalty=0.2)
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
    for name, settings in planned.items():
        played(name, partial(start, replace(settings, seed=seed)))
    played(EVADERS_TAUGHT, taught)
    return runs


def cross_play(
    plan: Plan, team: Team, runs: Sequence[Mapping[str, SavedRun]], threads: int | None
) -> np.ndarray:
    """Payoff of a team's candidates against the opponents of all races, by seed of both.

    Shape (kinds, seeds, races, seeds, generations), float64: each kind of `CANDIDATES` and seed,
    against every so many generations of every race of every seed.
    """
    rival: Team = "evader" if team == "pursuer" else "pursuer"
    own = [of_seed[kind].teams[team] for kind in CANDIDATES[team] for of_seed in runs]
    rivals = [of_seed[race].teams[rival] for race in RACES for of_seed in runs]
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


def against_strangers(payoff: np.ndarray) -> np.ndarray:
    """Mean payoff (kinds, seeds) against the opponents of races of other seeds."""
    strange = ~np.eye(payoff.shape[1], dtype=bool)
    by_pair = payoff.mean(axis=(2, 4))
    return (by_pair * strange).sum(axis=2) / strange.sum(axis=1)


def surrounding(
    plan: Plan, runs: Sequence[SavedRun], threads: int | None
) -> tuple[np.ndarray, np.ndarray]:
    """Capture rate, and collisions of pursuers with each other in 1000 of their steps.

    Both of shape (seeds, entries of the archive); 100 episodes each.
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
    """A statement of the paper as one number a seed, and the side of `than` it should lie on."""

    says: str
    measured: str
    values: np.ndarray
    """Shape (seeds,)."""
    side: str
    than: float = 0.0

    @property
    def estimate(self) -> analysis.Estimate:
        """Mean over the seeds with its interval."""
        return analysis.bootstrap_runs(self.values)

    @property
    def verdict(self) -> str:
        """Reproduced, not reproduced or undecided."""
        low, high = self.estimate.low, self.estimate.high
        if self.side == "below":
            low, high, than = -high, -low, -self.than
        else:
            than = self.than
        if low > than:
            return "reproduced"
        return "not reproduced" if high <= than else "undecided"


SOME_CHECKERBOARDS = 0.01
"""Share of the possible ones; an additive matrix with the noise of ten episodes has none."""
CLEARLY = 0.05
"""Capture rate by which co-evolved pursuers would be clearly better."""


def measured(
    plan: Plan, runs: Sequence[Mapping[str, SavedRun]], threads: int | None
) -> dict[str, np.ndarray]:
    """All numbers that the claims are tested by, as they are kept: float32, by name."""
    numbers = {
        f"payoff {race}": np.stack([of_seed[race].payoff().capture_rate for of_seed in runs])
        for race in RACES
    }
    for team in CANDIDATES:
        numbers[f"cross-play of {team}s"] = cross_play(plan, team, runs, threads)
    for name in SURROUNDING.values():
        seen = surrounding(plan, [of_seed[name] for of_seed in runs], threads)
        numbers[f"{name}: captured"], numbers[f"{name}: collisions"] = seen
    return {name: each.astype(np.float32) for name, each in numbers.items()}


def standings(numbers: Mapping[str, np.ndarray], team: Team) -> dict[str, np.ndarray]:
    """Mean payoff (seeds,) of each kind of `CANDIDATES` against races of other seeds."""
    payoff = numbers[f"cross-play of {team}s"].astype(np.float64)
    return dict(zip(CANDIDATES[team], against_strangers(payoff), strict=True))


def claims(numbers: Mapping[str, np.ndarray]) -> list[Claim]:
    """What the paper says, with the numbers of each seed; takes what `measured` returns."""
    numbers = {name: each.astype(np.float64) for name, each in numbers.items()}

    def of(measure: str, race: str) -> np.ndarray:
        matrices = numbers[f"payoff {race}"]
        return np.array([analysis.MEASURES[measure].of(matrix) for matrix in matrices])

    def forgotten(race: str) -> np.ndarray:
        return (of("pursuer_forgetting", race) + of("evader_forgetting", race)) / 2

    pursuers, evaders = standings(numbers, "pursuer"), standings(numbers, "evader")
    boards = "checkerboards, share of the possible, last half"
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
            "Generalists keep what they have learnt, specialists do not",
            "forgetting, specialists less generalists",
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
    met = "of 1000 agent-steps, in collisions with teammates"
    return [
        Claim(f"{name}: capture improves", "capture rate, last less untrained", gained, "above"),
        Claim(f"{name}: collisions of teammates remain", met, collisions[:, -1], "above"),
        Claim(f"{name}: collisions grow", f"{met}, last less untrained", more, "above"),
    ]


def told(estimate: analysis.Estimate) -> str:
    """A mean and its interval."""
    return f"{estimate.value:.3f} [{estimate.low:.3f}, {estimate.high:.3f}]"


def tables(numbers: Mapping[str, np.ndarray]) -> str:
    """The claims, and what the teams score against strangers, as tables in Markdown."""
    lines = ["| the paper's claim | measured | mean [95%] | wanted | |", "|---|---|---|---|---|"]
    for claim in claims(numbers):
        cells = (claim.says, claim.measured, told(claim.estimate), f"{claim.side} {claim.than:g}")
        lines.append(f"| {' | '.join(cells)} | **{claim.verdict}** |")
    lines += ["", "| trained | team | score against races of other seeds |", "|---|---|---|"]
    for team in CANDIDATES:
        for kind, values in standings(numbers, team).items():
            lines.append(f"| {kind} | {team}s | {told(analysis.bootstrap_runs(values))} |")
    return "\n".join(lines)


def main() -> None:
    """Play what is missing, test the claims, and write what came of it."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--quick", action="store_true", help="a small world and two seeds")
    parser.add_argument("--seeds", type=int, help="training seeds; default 10, or 2 with --quick")
    parser.add_argument("--runs", type=Path, default=Path("runs/paper_claims"))
    parser.add_argument("--results", type=Path, default=Path("paper_claims"))
    parser.add_argument("--threads", type=int, help="default: one a core")
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
