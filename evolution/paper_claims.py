"""Which claims of the paper hold? Races, baselines and surrounding over twenty training seeds.

    python evolution/paper_claims.py              about three hours on two cores; can be interrupted
    python evolution/paper_claims.py --quick      a small world and two seeds, less than a minute

Method: the experiments of Sun et al. (2023), "MatrixWorld", arXiv:2307.14854, with two differences:
the policy is a small network, and it learns by evolution strategies instead of policy gradients.
Baselines have the matches, the training steps and all settings of the races.

Each claim is one number with an interval over seeds and a threshold, both chosen before the runs
were played. It is reproduced if the interval lies on the claimed side, not reproduced if it lies on
the other side, and else undecided. Numbers of a race in time are those of `analysis.judge`.

``--results`` receives the table of claims, the scores below it, and the numbers behind both;
``--runs`` keeps the runs.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from pathlib import Path

import numpy as np

from common import script_parser, written
from matrixworld import analysis
from matrixworld.analysis.judge import DROPS, LEAST_AMPLITUDE
from matrixworld.coevolution import Team
from paper_runs import (
    CANDIDATES,
    EVADERS_ALONE,
    EVADERS_TAUGHT,
    FULL,
    GENERALISTS,
    MIXED,
    PURSUERS_ALONE,
    QUICK,
    RACES,
    SPECIALISTS,
    SURROUNDING,
    measured,
    play,
)

CLEARLY = 0.05
"""Difference of capture rates above which co-evolved pursuers would be clearly better."""
PUBLISHED_SURROUNDING = 0.58
"""Capture rate of the published -S after training; half of it counts as reproduced."""

AGREEING = 10
"""Seeds with exactly the same number that decide on a claim."""

Numbers = Mapping[str, np.ndarray]


AMPLITUDE = "squared_cyclic_amplitude"


@dataclass(frozen=True)
class Claim:
    """A statement of the paper as one number over seeds.

    Parameters
    ----------
    says : str
        The statement.
    measured : str
        Name of the number.
    estimate : Estimate
        Mean over seeds with its interval.
    side : {"above", "below"}
        Side of the threshold on which the number lies if the statement is true.
    than : float, optional
        The threshold.
    published : str, optional
        What the paper's authors measured, if they published it.
    """

    says: str
    measured: str
    estimate: analysis.Estimate
    side: str
    than: float = 0.0
    published: str = ""

    @property
    def verdict(self) -> str:
        """Verdict: reproduced, not reproduced or undecided."""
        low, high = self.estimate.low, self.estimate.high
        if low is None or high is None:
            # Seeds that all agree have no interval; few of them say nothing about others.
            if self.estimate.samples < AGREEING:
                return "undecided"
            low = high = self.estimate.value
            if low == self.than:
                return "not reproduced"
        above, below = low > self.than, high < self.than
        if not (above or below):
            return "undecided"
        return "reproduced" if above == (self.side == "above") else "not reproduced"


@dataclass(frozen=True)
class Races:
    """The races of one schedule over seeds, and what `judge` says of them.

    Parameters
    ----------
    scores : ndarray of float64, shape (seeds, n, n, episodes)
        Capture rates.
    """

    scores: np.ndarray

    @cached_property
    def together(self) -> analysis.Judgement:
        """The judgement of all seeds together."""
        return analysis.judge(self.scores, per_episode=True)

    @cached_property
    def _singles(self) -> list[analysis.Judgement]:
        return [analysis.judge(scores, per_episode=True) for scores in self.scores]

    def numbers(self, condition: str, *names: str) -> np.ndarray:
        """Return the mean of some numbers of a condition for each seed, shape (seeds,)."""
        estimates = [each.headline[condition].estimates for each in self._singles]
        return np.array([np.mean([one[name].value for name in names]) for one in estimates])

    def swing(self, first: int, last: int) -> np.ndarray:
        """Return the mean swing of generations `first` to `last` for each seed."""
        rates = [analysis.team_phase_rates(scores.mean(axis=2)) for scores in self.scores]
        return swing_between(np.array(rates), first, last)


def swing_between(phases: np.ndarray, first: int, last: int) -> np.ndarray:
    """Return the mean difference between team phases (seeds, generations, 2), shape (seeds,)."""
    # Row k - 1 belongs to generation k.
    part = phases[:, first - 1 : last]
    return np.abs(part[..., 0] - part[..., 1]).mean(axis=1)


def races_of(numbers: Numbers) -> dict[str, Races]:
    """Return the races of each schedule, from the numbers of `measured`."""
    evaders = float(numbers["evaders"])
    return {race: Races(numbers[f"captured {race}"] / evaders) for race in RACES}


def claims(numbers: Numbers) -> list[Claim]:
    """Return the claims of the paper with their estimates, from the numbers of `measured`."""
    races = races_of(numbers)
    return [
        *_on_progress(races, numbers),
        *_on_cycles(races),
        *_on_generalization(numbers),
        *_on_surrounding(numbers),
    ]


def _on_progress(races: Mapping[str, Races], numbers: Numbers) -> list[Claim]:
    gains = races[GENERALISTS].together.windows["whole"]["arms race"].estimates
    last = races[GENERALISTS].scores.shape[1] - 1
    tenth = max(1, last // 3)
    swings = [
        np.mean([each.swing(*part) for each in races.values()], axis=0)
        for part in ((1, tenth), (last - tenth + 1, last))
    ]
    found = [
        Claim(
            f"Generalist {team}s improve over the generations",
            "gain against all opponents, whole race", gains[f"{team}_gain"], "above",
        )
        for team in ("pursuer", "evader")
    ]  # fmt: skip
    found.append(
        Claim(
            "The variation by adaptation converges within 30 generations",
            "swing, last third minus first third", over_seeds(swings[1] - swings[0]), "below",
        )
    )  # fmt: skip
    longer = [numbers[f"phases {race}"].astype(np.float64) for race in (SPECIALISTS, GENERALISTS)]
    if len(longer[0]) >= 2:
        end = longer[0].shape[1]
        late, early = (
            np.mean([swing_between(each, *part) for each in longer], axis=0)
            for part in ((end - tenth + 1, end), (last - tenth + 1, last))
        )
        found.append(
            Claim(
                f"With {end} generations it diverges again",
                f"swing, last {tenth} generations minus the {tenth} before {last + 1}",
                over_seeds(late - early), "above",
            )
        )  # fmt: skip
    return found


def _on_cycles(races: Mapping[str, Races]) -> list[Claim]:
    squares = {race: each.numbers("cycling", AMPLITUDE) for race, each in races.items()}
    drops = {race: each.numbers("forgetting", *DROPS) for race, each in races.items()}
    amplitude = "cyclic amplitude, last half"
    return [
        Claim(
            "Specialists against specialists cycle", amplitude,
            amplitude_of(races[SPECIALISTS]), "above", LEAST_AMPLITUDE,
        ),
        Claim(
            "Generalist pursuers against specialists cycle less",
            f"squared {amplitude}, difference to specialists",
            over_seeds(squares[MIXED] - squares[SPECIALISTS]), "below",
        ),
        Claim(
            "Generalists against generalists do not cycle", amplitude,
            amplitude_of(races[GENERALISTS]), "below", LEAST_AMPLITUDE,
        ),
        Claim(
            "Generalists forget less than specialists", "forgetting, difference to specialists",
            over_seeds(drops[GENERALISTS] - drops[SPECIALISTS]), "below",
        ),
    ]  # fmt: skip


def amplitude_of(races: Races) -> analysis.Estimate:
    """Return the cyclic amplitude of all seeds together, in units of the capture rate."""
    found = races.together.headline["cycling"].estimates[AMPLITUDE]
    # `judge` has its square, which noise may turn negative.
    value, low, high = (max(0.0, end or 0.0) ** 0.5 for end in (found.value, found.low, found.high))
    return replace(found, value=value, low=low, high=high)


OPPONENTS = ("all generations", "early generations", "late generations", "held-out opponents")
"""Opponents of the candidates; generations are those of races of other seeds."""


def standings(numbers: Numbers, team: Team) -> dict[str, dict[str, np.ndarray]]:
    """Return the mean payoff (seeds,) of each kind of candidates against each of `OPPONENTS`."""
    payoff = numbers[f"cross-play of {team}s"].astype(np.float64)
    third = max(1, payoff.shape[-1] // 3)
    found = {
        "all generations": against_other_seeds(payoff),
        "early generations": against_other_seeds(payoff[..., :third]),
        "late generations": against_other_seeds(payoff[..., -third:]),
        "held-out opponents": numbers[f"held-out of {team}s"].astype(np.float64),
    }
    return {
        opponents: dict(zip(CANDIDATES[team], values, strict=True))
        for opponents, values in found.items()
    }


def against_other_seeds(payoff: np.ndarray) -> np.ndarray:
    """Return the mean payoff (kinds, seeds) against the opponents of races of other seeds."""
    # Opponents of the own seed have trained against the candidates of the races.
    others = ~np.eye(payoff.shape[1], dtype=bool)
    # Mean over races and generations of the opponents.
    by_pair = payoff.mean(axis=(2, 4))
    return (by_pair * others).sum(axis=2) / others.sum(axis=1)


COMPARED: tuple[tuple[str, Team, str, str, str, float, str], ...] = (
    (
        "Co-evolved evaders are better than those trained against random pursuers",
        "evader", GENERALISTS, EVADERS_ALONE, "above", 0.0, "+0.93 against co-evolved, one episode",
    ),
    (
        "Co-evolved evaders are better than those trained against trained pursuers",
        "evader", GENERALISTS, EVADERS_TAUGHT, "above", 0.0,
        "+0.17 against co-evolved, one episode",
    ),
    (
        "Evaders trained against trained pursuers are better than those against random pursuers",
        "evader", EVADERS_TAUGHT, EVADERS_ALONE, "above", 0.0,
        "+0.77 against co-evolved, one episode",
    ),
    (
        "Co-evolved pursuers are not clearly better than those trained against random evaders",
        "pursuer", GENERALISTS, PURSUERS_ALONE, "below", CLEARLY, "",
    ),
)  # fmt: skip
"""Statement, team, two kinds of candidates, and on which side of a threshold the first one minus
the second one lies if the statement is true; what was published."""


def _on_generalization(numbers: Numbers) -> list[Claim]:
    scores = {team: standings(numbers, team) for team in CANDIDATES}
    payoff = {"pursuer": "capture", "evader": "escape"}
    return [
        Claim(
            says, f"difference of {payoff[team]} rates, {opponents}",
            over_seeds(scores[team][opponents][one] - scores[team][opponents][two]),
            side, than, published,
        )
        for says, team, one, two, side, than, published in COMPARED
        for opponents in OPPONENTS
    ]  # fmt: skip


def _on_surrounding(numbers: Numbers) -> list[Claim]:
    collided = "collisions with teammates per 1000 agent-steps"
    found = []
    for name in SURROUNDING.values():
        captured = numbers[f"{name}: captured"].astype(np.float64)
        collisions = numbers[f"{name}: collisions"].astype(np.float64)
        found += [
            Claim(
                f"{name}: capture improves", "capture rate, last minus untrained",
                over_seeds(captured[:, -1] - captured[:, 0]), "above",
            ),
            Claim(
                f"{name}: capture reaches half of what was published", "capture rate, last",
                over_seeds(captured[:, -1]), "above", PUBLISHED_SURROUNDING / 2,
                f"{PUBLISHED_SURROUNDING}",
            ),
            Claim(
                f"{name}: collisions of teammates remain", collided,
                over_seeds(collisions[:, -1]), "above", 0.0, "in 60 % of the episodes",
            ),
            Claim(
                f"{name}: collisions increase", f"{collided}, last minus untrained",
                over_seeds(collisions[:, -1] - collisions[:, 0]), "above",
            ),
        ]  # fmt: skip
    return found


def over_seeds(
    values: np.ndarray, bounds: tuple[float, float] = (-np.inf, np.inf)
) -> analysis.Estimate:
    """Return the mean of one number for each seed, with Student's t interval."""
    return analysis.interval_over_runs(values, bounds=bounds)


def tables(numbers: Numbers) -> str:
    """Return the claims, and the scores of all candidates, as tables in Markdown."""
    heads = ("the paper's claim", "measured", "mean [95 %]", "claimed", "published", "")
    lines = [f"| {' | '.join(heads)} |", "|---" * len(heads) + "|"]
    for claim in claims(numbers):
        side = f"{claim.side} {claim.than:g}"
        cells = (claim.says, claim.measured, written(claim.estimate), side, claim.published)
        lines.append(f"| {' | '.join(cells)} | **{claim.verdict}** |")
    lines += ["", f"| trained | team | {' | '.join(OPPONENTS)} |", "|---" * 6 + "|"]
    for team, kinds in CANDIDATES.items():
        scores = standings(numbers, team)
        for kind in kinds:
            cells = (
                written(over_seeds(scores[opponents][kind], (0.0, 1.0))) for opponents in OPPONENTS
            )
            lines.append(f"| {kind} | {team}s | {' | '.join(cells)} |")
    return "\n".join(lines)


def main() -> None:
    """Play missing runs, test the claims, print and write the results."""
    parser = script_parser(__doc__, quick="a small world and two seeds", cluster=True)
    parser.add_argument("--seeds", type=int, help="training seeds; default 20, or 2 with --quick")
    parser.add_argument("--long-seeds", type=int, help="seeds of the long races; default 5, or 2")
    parser.add_argument("--runs", type=Path, default=Path("runs/paper_claims"))
    parser.add_argument("--results", type=Path, default=Path("paper_claims"))
    parser.add_argument("--threads", type=int, help="default: one for each core")
    args = parser.parse_args()
    plan, few, fewer = (QUICK, 2, 2) if args.quick else (FULL, 20, 5)
    long = fewer if args.long_seeds is None else args.long_seeds
    seeds = range(args.seeds or few)
    runs = play(plan, seeds, args.runs, args.threads, long=range(long), where=args.cluster)
    numbers = measured(plan, runs, args.threads)
    text = tables(numbers)
    print(text)
    args.results.mkdir(parents=True, exist_ok=True)
    (args.results / "claims.md").write_text(text + "\n", encoding="utf-8")
    np.savez_compressed(args.results / "numbers.npz", **numbers)
    print(f"Written: {args.results}/claims.md, {args.results}/numbers.npz")


if __name__ == "__main__":
    main()
