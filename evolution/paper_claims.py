"""Which claims of the paper hold? Races, baselines and surrounding over twenty training seeds.

    python evolution/paper_claims.py              six hours on two cores; can be interrupted
    python evolution/paper_claims.py --quick      a small world and two seeds, a minute
    python evolution/paper_claims.py --kinds long --seeds 3      some of the runs

Method: the experiments of Sun et al. (2023), "MatrixWorld", arXiv:2307.14854, with two differences:
the policy is a small network, and it learns by evolution strategies instead of policy gradients.
Baselines have the matches, the training steps and all settings of the races.

Each claim is one number of each seed and a threshold. Its p-value is that of Student's t over the
seeds, adjusted for the tests of the same table (Holm); an interval speaks of its number alone.
A claim is reproduced if the number lies on the claimed side of the threshold, and not reproduced if
it lies on the other side, both told from chance at 5 %. Else the table cannot tell. A published
number of another learner, network and reward is not comparable. Claims on races
are tested in the whole race and in its halves; numbers of a race in time are those of
`analysis.MEASURES`.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from pathlib import Path

import numpy as np

import paper_surrounding
from common import (
    SIGNIFICANCE,
    Numbers,
    experiment,
    holm,
    markdown,
    mean,
    p_value,
    shown_p,
    written,
)
from matrixworld import analysis
from matrixworld.analysis import MEASURES, read_payoffs
from matrixworld.analysis.judge import DROPS, LEAST_INTRANSITIVITY, LEAST_RECURRENCE
from matrixworld.analysis.payoffs import Payoffs
from matrixworld.coevolution import TEAMS, Team
from paper_runs import (
    CANDIDATES,
    EVADERS_ALONE,
    EVADERS_TAUGHT,
    FEW_EPOCHS,
    FEWER,
    GENERALISTS,
    LONG,
    MIXED,
    PURSUERS_ALONE,
    RACES,
    SPECIALISTS,
    SURROUNDING,
    kinds,
    measured,
)

CLEARLY = 0.05
"""Difference of rates below which a team is not clearly better."""
PUBLISHED_SURROUNDING = 0.53
"""Evaders captured in the last step of the published -S, mean of the last 500 of 5,000 epochs; half
of it would count as reproduced."""
LEAST_COLLISIONS = 1.0
"""Collisions per 1000 agent-steps that count as some: ten of a team of 20 in 500 steps."""

AT_ITS_SIZE = Path(__file__).parent / "results" / "paper_surrounding" / "numbers.npz"
ASSURANCE = """Rewards do not make pursuers safe in -S, and the paper asks for assurance. These
learned at the paper's size by policy gradients, as `paper_surrounding.py` plays it."""

ByColumn = Mapping[str, np.ndarray]
"""One number for each seed, shape (seeds,), by the column of the table."""


@dataclass(frozen=True)
class Claim:
    """A statement of the paper as one number of each seed."""

    says: str
    measured: str
    """Name of the number."""
    values: ByColumn
    """By a part of the race, for example; NaN where the number is not defined."""
    side: str
    """On which side of the threshold it lies if the statement is true: "above" or "below"."""
    than: float = 0.0
    published: str = ""
    """What the paper's authors measured, if they published it."""
    squared: bool = False
    """Whether number and threshold are squares, whose roots are printed."""
    comparable: bool = True
    """Whether learner, network and rewards are those behind the published number. If not, the
    number is shown and not tested."""

    def tested(self) -> str:
        """Return statement, number, threshold and seeds as a cell in two lines."""
        than = self.than**0.5 if self.squared else self.than
        seeds = len(next(iter(self.values.values())))
        published = f"; published: {self.published}" if self.published else ""
        return f"{self.says}<br>*{self.measured} {self.side} {than:g}{published}; {seeds} seeds*"

    def p_value(self, column: str) -> float:
        """Return the p-value of the number in a column, not adjusted."""
        values = self.values[column]
        return 1.0 if np.isnan(values).any() else p_value(values, self.than)

    def verdict(self, column: str, p: float) -> str:
        """Return the verdict by an adjusted p-value: reproduced, not reproduced or cannot tell."""
        if not self.comparable:
            return "not comparable"
        if p > SIGNIFICANCE:
            return "cannot tell"
        above = self.values[column].mean() > self.than
        return "reproduced" if above == (self.side == "above") else "not reproduced"

    def shown(self, column: str) -> str:
        """Return mean and interval over seeds as text."""
        if np.isnan(self.values[column]).any():
            return "not defined"
        found = analysis.interval_over_runs(self.values[column])
        if self.squared:
            # Noise is subtracted from a square, so it may be negative.
            ends = (end and max(0.0, end) ** 0.5 for end in (found.value, found.low, found.high))
            found = analysis.Estimate(*ends)  # type: ignore[arg-type]  # the value is a number
        return written(found, digits=0 if abs(found.value) > 1000 else 3)


# Races, in parts of them:


def in_parts(captured: np.ndarray, number: Callable[[Payoffs, str], float]) -> ByColumn:
    """Return a number of each race (seeds, n, n, episodes) in the whole race and in its halves."""
    races = [read_payoffs(scores, per_episode=True) for scores in captured]
    return {part: np.array([number(race, part) for race in races]) for part in races[0].windows}


def measure(name: str, race: Payoffs, part: str) -> float:
    """Return one of `analysis.MEASURES` in a part of a race."""
    return MEASURES[name].of(race, part).value


def forgetting(race: Payoffs, part: str) -> float:
    """Return the forgetting in a part of a race, mean of both teams."""
    return float(np.mean([measure(name, race, part) for name in DROPS]))


def phase(team: Team, race: Payoffs, part: str) -> float:
    """Return the mean change of the capture rate while one team learns, in a part of a race."""
    matrix = race.matrices[0][race.windows[part].cells]
    k = np.arange(1, len(matrix))
    pursuers_learned, before, after = matrix[k, k - 1], matrix[k - 1, k - 1], matrix[k, k]
    changes = pursuers_learned - before if team == "pursuer" else after - pursuers_learned
    return float(changes.mean())


def difference(one: ByColumn, other: ByColumn) -> ByColumn:
    """Return the difference of two numbers of the same seeds."""
    return {column: one[column] - other[column] for column in one}


def captured_by(numbers: Numbers) -> dict[str, np.ndarray]:
    """Return the capture rates (seeds, n, n, episodes) of all kinds of races, by name."""
    return {
        name.removeprefix("captured "): captured / float(numbers["evaders"])
        for name, captured in numbers.items()
        if name.startswith("captured ")
    }


PAIRINGS = {
    SPECIALISTS: "specialists against specialists",
    MIXED: "generalist pursuers, specialist evaders",
    GENERALISTS: "generalists against generalists",
}


def _on_races(numbers: Numbers) -> list[Claim]:
    races = captured_by(numbers)
    cyclic, drops = (
        {race: in_parts(races[race], number) for race in RACES}
        for number in (partial(measure, "squared_intransitivity"), forgetting)
    )
    amplitude, least = "intransitivity", LEAST_INTRANSITIVITY**2

    def over_schedules(team: Team) -> ByColumn:
        each = [in_parts(races[race], partial(phase, team)) for race in RACES]
        return {part: np.mean([one[part] for one in each], axis=0) for part in each[0]}

    return [
        *(
            Claim(
                f"The {team}s improve ({PAIRINGS[race]})", "linear change of the mean payoff",
                in_parts(races[race], partial(measure, f"{team}_change")), "above",
            )
            for race in RACES for team in TEAMS
        ),
        Claim(
            "The capture rate rises while pursuers learn", "change, mean of the three schedules",
            over_schedules("pursuer"), "above",
        ),
        Claim(
            "The capture rate falls while evaders learn", "change, mean of the three schedules",
            over_schedules("evader"), "below",
        ),
        Claim(
            "Specialists against specialists cycle", amplitude,
            cyclic[SPECIALISTS], "above", least, squared=True,
        ),
        *(
            Claim(
                f"Skills of specialist {team}s return periodically", "recurrence in time",
                in_parts(races[SPECIALISTS], partial(measure, f"{team}_recurrence")),
                "above", LEAST_RECURRENCE,
            )
            for team in TEAMS
        ),
        Claim(
            "Cycles give diverse policies of similar complexity (specialists)",
            "share of the variance that strength explains",
            in_parts(races[SPECIALISTS], partial(measure, "transitive_share")), "below", 0.5,
        ),
        Claim(
            "Generalist pursuers against specialists cycle less",
            f"squared {amplitude}, difference to specialists",
            difference(cyclic[MIXED], cyclic[SPECIALISTS]), "below",
        ),
        Claim(
            "Generalists against generalists do not cycle", amplitude,
            cyclic[GENERALISTS], "below", least, squared=True,
        ),
        Claim(
            "Generalists forget less than specialists", "forgetting, difference to specialists",
            difference(drops[GENERALISTS], drops[SPECIALISTS]), "below",
        ),
    ]  # fmt: skip


def _on_few_epochs(numbers: Numbers) -> list[Claim]:
    race = captured_by(numbers)[FEW_EPOCHS]
    return [
        Claim(
            f"With too few epochs (1/{FEWER}) in a generation, {team}s cannot learn",
            "linear change of the mean payoff", in_parts(race, partial(measure, f"{team}_change")),
            "below", CLEARLY,
        )
        for team in TEAMS
    ]  # fmt: skip


# Single numbers:


def one(values: np.ndarray) -> ByColumn:
    """Return a number that has a single column."""
    return {"": np.asarray(values, dtype=np.float64)}


def swing_between(phases: np.ndarray, first: int, last: int) -> np.ndarray:
    """Return the mean difference between team phases (seeds, generations, 2), shape (seeds,)."""
    # Row k - 1 belongs to generation k.
    part = phases[:, first - 1 : last]
    return np.abs(part[..., 0] - part[..., 1]).mean(axis=1)


def _on_swings(numbers: Numbers) -> list[Claim]:
    races = captured_by(numbers)
    rates = [
        np.array([analysis.team_phase_rates(each) for each in races[race].mean(axis=3)])
        for race in RACES
    ]
    last = rates[0].shape[1]
    third = max(1, last // 3)
    early, late = (
        np.mean([swing_between(each, *part) for each in rates], axis=0)
        for part in ((1, third), (last - third + 1, last))
    )
    return [
        Claim(
            "The variation by adaptation converges within 30 generations",
            "swing, last third minus first third", one(late - early), "below",
        )
    ]  # fmt: skip


def _on_long_races(numbers: Numbers) -> list[Claim]:
    longer = [numbers[f"phases {race}"].astype(np.float64) for race in (SPECIALISTS, GENERALISTS)]
    end, last = longer[0].shape[1], captured_by(numbers)[GENERALISTS].shape[1] - 1
    some = max(1, last // 3)
    late, early = (
        np.mean([swing_between(each, *part) for each in longer], axis=0)
        for part in ((end - some + 1, end), (last - some + 1, last))
    )
    return [
        Claim(
            f"With {end} generations it diverges again",
            f"swing, last {some} generations minus the {some} before {last + 1}",
            one(late - early), "above",
        )
    ]  # fmt: skip


def _on_plateau(numbers: Numbers) -> list[Claim]:
    found = []
    for opponents, name in (("random", "random pursuers"), ("held-out", "held-out pursuers")):
        rates = numbers[f"plateau: {opponents}"].astype(np.float64)
        half = rates.shape[1] // 2
        found += [
            Claim(
                "Evaders alone, against random pursuers, improve at first",
                f"escape rate against {name}, half of the epochs minus untrained",
                one(rates[:, half] - rates[:, 0]), "above",
            ),
            Claim(
                "... and then hardly any more",
                f"escape rate against {name}, last minus half of the epochs",
                one(rates[:, -1] - rates[:, half]), "below", CLEARLY,
            ),
        ]  # fmt: skip
    return found


def _on_surrounding(numbers: Numbers) -> list[Claim]:
    collided = "collisions with teammates per 1000 agent-steps"
    found = []
    for name in SURROUNDING.values():
        captured = numbers[f"{name}: captured"].astype(np.float64)
        collisions = numbers[f"{name}: collisions"].astype(np.float64)
        found += [
            Claim(
                f"{name}: capture improves", "capture rate, last minus untrained",
                one(captured[:, -1] - captured[:, 0]), "above",
            ),
            Claim(
                f"{name}: capture reaches half of what was published", "capture rate, last",
                one(captured[:, -1]), "above", PUBLISHED_SURROUNDING / 2,
                f"{PUBLISHED_SURROUNDING}", comparable=False,
            ),
            Claim(
                f"{name}: collisions of teammates remain", collided,
                one(collisions[:, -1]), "above", LEAST_COLLISIONS,
            ),
            Claim(
                f"{name}: collisions increase", f"{collided}, last minus untrained",
                one(collisions[:, -1] - collisions[:, 0]), "above",
            ),
        ]  # fmt: skip
    return found


def _on_safety(numbers: Numbers) -> list[Claim]:
    found = []
    for name in SURROUNDING.values():
        rewards, colliding, faults = (
            numbers[f"{name}: {what}"].astype(np.float64)
            for what in ("rewards", "colliding", "faults")
        )
        found += [
            Claim(
                f"{name}: rewards improve", "return of the team in tests, last minus untrained",
                one(rewards[:, 1] - rewards[:, 0]), "above",
            ),
            Claim(
                f"{name}: teammates collide in most episodes", "share of the test episodes",
                one(colliding), "above", 0.5, "0.6",
            ),
            Claim(
                f"{name}: collisions are worse in tests than in training",
                "at fault per 1000 agent-steps, tests minus last tenth of the training",
                one(faults[:, 1] - faults[:, 0]), "above",
            ),
        ]  # fmt: skip
    return found


# Candidates against opponents of other runs:

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

    def gains(team: Team, better: str, worse: str) -> ByColumn:
        return {name: each[better] - each[worse] for name, each in scores[team].items()}

    found = [
        Claim(
            says, f"difference of {payoff[team]} rates", gains(team, better, worse),
            side, than, published,
        )
        for says, team, better, worse, side, than, published in COMPARED
    ]  # fmt: skip
    evaders = gains("evader", GENERALISTS, EVADERS_ALONE)
    pursuers = gains("pursuer", GENERALISTS, PURSUERS_ALONE)
    found.append(
        Claim(
            "Who learns passively gains more from co-evolution",
            "co-evolved minus alone (against random), evaders minus pursuers",
            difference(evaders, pursuers),
            "above",
        )
    )
    return found


# The tables:

CROSS_PLAY = "cross-play of evaders"
CLAIMS: tuple[tuple[tuple[str, ...], Callable[[Numbers], list[Claim]]], ...] = (
    ((f"captured {SPECIALISTS}",), _on_races),
    ((f"captured {FEW_EPOCHS}",), _on_few_epochs),
    ((CROSS_PLAY,), _on_generalization),
    ((f"captured {SPECIALISTS}",), _on_swings),
    ((f"captured {SPECIALISTS}", f"phases {SPECIALISTS}"), _on_long_races),
    (("plateau: random",), _on_plateau),
    ((f"{SURROUNDING['rewards']}: captured",), _on_surrounding),
    ((f"{SURROUNDING['rewards']}: faults",), _on_safety),
)
"""Some of the numbers that claims take, and the claims."""


HEAD = """# Claims of the paper

A cell holds the verdict, the mean over the seeds with its 95 % interval, and the p-value, adjusted
for all tests of the same table. The last table holds the scores of all candidates."""


def claims(numbers: Numbers) -> list[Claim]:
    """Return the claims whose numbers are measured."""
    return [
        claim
        for names, found in CLAIMS
        if all(name in numbers for name in names)
        for claim in found(numbers)
    ]


def tables(numbers: Numbers) -> str:
    """Return the claims, and the scores of all candidates, as tables in Markdown."""
    by_columns: dict[tuple[str, ...], list[Claim]] = {}
    for claim in claims(numbers):
        by_columns.setdefault(tuple(claim.values), []).append(claim)
    parts = [HEAD, *(table(columns, of_table) for columns, of_table in by_columns.items())]
    missing = {name: None for names, _ in CLAIMS for name in names if name not in numbers}
    if missing:
        parts.append(f"Not measured: {', '.join(missing)} (`--kinds`).")
    if f"captured {SPECIALISTS}" in numbers:
        parts.append(returns(numbers))
    if CROSS_PLAY in numbers:
        parts.append(scores(numbers))
    if f"{SURROUNDING['rewards']}: captured" in numbers and AT_ITS_SIZE.exists():
        parts += [ASSURANCE, paper_surrounding.ends(dict(np.load(AT_ITS_SIZE)))]
    return "\n\n".join(parts)


def table(columns: Sequence[str], of_table: Sequence[Claim]) -> str:
    """Return claims with the same columns as a table in Markdown, with p-values adjusted in it."""
    tested = [(k, col) for k, claim in enumerate(of_table) if claim.comparable for col in columns]
    found = holm([of_table[k].p_value(column) for k, column in tested])
    p_values = dict(zip(tested, found, strict=True))
    rows = [
        [
            claim.tested(),
            *(cell(claim, column, p_values.get((k, column), 1.0)) for column in columns),
        ]
        for k, claim in enumerate(of_table)
    ]
    heads = [each or "found" for each in columns]
    return markdown(["the paper's claim, and the number that tests it", *heads], rows)


def cell(claim: Claim, column: str, p: float) -> str:
    """Return verdict, mean, interval and adjusted p-value of a claim in a column."""
    told = f"**{claim.verdict(column, p)}**<br>{claim.shown(column)}"
    return f"{told}<br>{shown_p(p)}" if claim.comparable else told


def returns(numbers: Numbers) -> str:
    """Return in how many seeds, each by itself, skills of specialists return, in a sentence."""
    races = [read_payoffs(each, per_episode=True) for each in captured_by(numbers)[SPECIALISTS]]
    counts = []
    for team in TEAMS:
        of = MEASURES[f"{team}_recurrence"].of
        again = sum((of(race, "last half").low or 0.0) > LEAST_RECURRENCE for race in races)
        triangles = [getattr(analysis.ciao(race.matrices[0]), f"{team}s") for race in races]
        second = sum(triangle.period == 2 for triangle in triangles)
        counts.append(f"{team}s {again}, {second}")
    return (
        f"Of {len(races)} seeds of specialists against specialists, each by itself: in how many "
        "skills return beyond episode noise in the last half, and in how many the stripes of the "
        f"CIAO plot have period 2: {'; '.join(counts)}."
    )


def scores(numbers: Numbers) -> str:
    """Return the scores of all candidates as a table in Markdown."""
    rows = []
    for team, candidates in CANDIDATES.items():
        payoffs = standings(numbers, team)
        for kind in candidates:
            means = (mean(payoffs[name][kind], bounds=(0.0, 1.0)) for name in OPPONENTS)
            rows.append([kind, f"{team}s", *means])
    return markdown(["trained", "team", *OPPONENTS], rows)


if __name__ == "__main__":
    experiment(
        __file__,
        __doc__,
        kinds=kinds,
        together=measured,
        table=tables,
        seeds=20,
        fewer=dict.fromkeys(LONG.values(), 5),
        files=("numbers.npz", "claims.md"),
    )
