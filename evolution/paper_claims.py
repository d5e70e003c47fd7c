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

import re
from collections import Counter
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
    play_with_penalty_of_races,
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
"""Evaders captured in the last step of the published S, mean of the last 500 of 5,000 epochs; half
of it would count as reproduced."""
LEAST_COLLISIONS = 1.0
"""Collisions per 1000 agent-steps that count as some: ten of a team of 20 in 500 steps."""

AT_ITS_SIZE = Path(__file__).parent / "results" / "paper" / "paper_surrounding" / "numbers.npz"
ASSURANCE = """Rewards do not make pursuers safe in S, and the paper asks for assurance. These
learned at the paper's size by policy gradients, as `paper_surrounding.py` plays it."""

VERDICTS = ("reproduced", "not reproduced", "cannot tell")
PARTS = ("whole", "first half", "last half")
OPPONENTS = ("all generations", "early generations", "late generations", "held-out opponents")
"""Opponents of the candidates; generations are those of races of other seeds."""


@dataclass(frozen=True)
class Claim:
    """A statement of the paper as one number of each seed."""

    says: str
    measured: str
    """Name of the number."""
    values: np.ndarray
    """In each column of the table, such as a part of the race: (columns, seeds), or (seeds,); NaN
    where the number is not defined."""
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
        published = f"; published: {self.published}" if self.published else ""
        seeds = self.values.shape[-1]
        return f"{self.says}<br>*{self.measured} {self.side} {than:g}{published}; {seeds} seeds*"

    @property
    def columns(self) -> np.ndarray:
        """The values, shape (columns, seeds)."""
        return np.atleast_2d(self.values).astype(np.float64)

    def p_values(self) -> list[float]:
        """Return the p-value of each column, not adjusted; none if it is not tested."""
        if not self.comparable:
            return []
        return [1.0 if np.isnan(each).any() else p_value(each, self.than) for each in self.columns]

    def shown(self, values: np.ndarray) -> str:
        """Return mean and interval over seeds as text."""
        if np.isnan(values).any():
            return "not defined"
        found = analysis.interval_over_runs(values)
        if self.squared:
            # Noise is subtracted from a square, so it may be negative.
            ends = (end and max(0.0, end) ** 0.5 for end in (found.value, found.low, found.high))
            found = analysis.Estimate(*ends)  # type: ignore[arg-type]  # the value is a number
        return written(found, digits=0 if abs(found.value) > 1000 else 3)

    def cell(self, values: np.ndarray, p: float) -> str:
        """Return verdict, mean, interval and adjusted p-value of a column."""
        if not self.comparable:
            return f"**not comparable**<br>{self.shown(values)}"
        agrees = (values.mean() > self.than) == (self.side == "above")
        verdict = VERDICTS[2 if p > SIGNIFICANCE else 0 if agrees else 1]
        return f"**{verdict}**<br>{self.shown(values)}<br>{shown_p(p)}"


# Races, in parts of them:


def in_parts(captured: np.ndarray, number: Callable[[Payoffs, str], float]) -> np.ndarray:
    """Return a number (parts, seeds) of races (seeds, n, n, episodes) in each of `PARTS`."""
    races = [read_payoffs(scores, per_episode=True) for scores in captured]
    return np.array([[number(race, part) for race in races] for part in PARTS])


def measure(name: str, race: Payoffs, part: str) -> float:
    """Return one of `analysis.MEASURES` in a part of a race."""
    return MEASURES[name].of(race, part).value


def forgetting(race: Payoffs, part: str) -> float:
    """Return the forgetting in a part of a race, mean of both teams."""
    return float(np.mean([measure(name, race, part) for name in DROPS.values()]))


def phase(team: Team, race: Payoffs, part: str) -> float:
    """Return the mean change of the capture rate while one team learns, in a part of a race."""
    matrix = race.matrices[0][race.windows[part].cells]
    k = np.arange(1, len(matrix))
    pursuers_learned, before, after = matrix[k, k - 1], matrix[k - 1, k - 1], matrix[k, k]
    changes = pursuers_learned - before if team == "pursuer" else after - pursuers_learned
    return float(changes.mean())


def captured_by(numbers: Numbers, kind: str) -> np.ndarray:
    """Return the capture rates (seeds, n, n, episodes) of a kind of races."""
    return numbers[f"captured {kind}"] / float(numbers["evaders"])


PAIRINGS = {
    SPECIALISTS: "specialists against specialists",
    MIXED: "generalist pursuers, specialist evaders",
    GENERALISTS: "generalists against generalists",
}


def on_races(numbers: Numbers) -> list[Claim]:
    """Return the claims on races, in the parts of `PARTS`."""
    races = {race: captured_by(numbers, race) for race in RACES}

    def of(race: str, name: str) -> np.ndarray:
        return in_parts(races[race], partial(measure, name))

    def over_schedules(team: Team) -> np.ndarray:
        return np.mean([in_parts(each, partial(phase, team)) for each in races.values()], axis=0)

    cyclic = {race: of(race, "squared_intransitivity") for race in RACES}
    drops = {race: in_parts(races[race], forgetting) for race in (SPECIALISTS, GENERALISTS)}
    amplitude, least = "intransitivity", LEAST_INTRANSITIVITY**2
    return [
        *(
            Claim(
                f"The {team}s improve ({PAIRINGS[race]})", "linear change of the mean payoff",
                of(race, f"{team}_change"), "above",
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
            "Specialists against specialists are intransitive, as cycles are", amplitude,
            cyclic[SPECIALISTS], "above", least, squared=True,
        ),
        *(
            Claim(
                f"Skills of specialist {team}s return periodically", "recurrence in time",
                of(SPECIALISTS, f"{team}_recurrence"), "above", LEAST_RECURRENCE,
            )
            for team in TEAMS
        ),
        Claim(
            "Cycles give diverse policies of similar complexity (specialists)",
            "share of the variance that strength explains",
            of(SPECIALISTS, "transitive_share"), "below", 0.5,
        ),
        Claim(
            "Generalist pursuers against specialists are less intransitive",
            f"squared {amplitude}, difference to specialists",
            cyclic[MIXED] - cyclic[SPECIALISTS], "below",
        ),
        Claim(
            "Generalists against generalists are not intransitive", amplitude,
            cyclic[GENERALISTS], "below", least, squared=True,
        ),
        Claim(
            "Generalists forget less than specialists", "forgetting, difference to specialists",
            drops[GENERALISTS] - drops[SPECIALISTS], "below",
        ),
    ]  # fmt: skip


def _on_few_epochs(numbers: Numbers) -> list[Claim]:
    race = captured_by(numbers, FEW_EPOCHS)
    return [
        Claim(
            f"With too few epochs (1/{FEWER}) in a generation, {team}s cannot learn",
            "linear change of the mean payoff", in_parts(race, partial(measure, f"{team}_change")),
            "below", CLEARLY,
        )
        for team in TEAMS
    ]  # fmt: skip


# Single numbers:


def swing_between(phases: np.ndarray, first: int, last: int) -> np.ndarray:
    """Return the mean difference between team phases (seeds, generations, 2), shape (seeds,)."""
    # Row k - 1 belongs to generation k.
    part = phases[:, first - 1 : last]
    return np.abs(part[..., 0] - part[..., 1]).mean(axis=1)


def on_swings(numbers: Numbers) -> list[Claim]:
    """Return the claim on how far the capture rate goes up and down, single numbers."""
    matrices = [captured_by(numbers, race).mean(axis=3) for race in RACES]
    rates = [
        np.array([analysis.team_phase_rates(each) for each in of_kind]) for of_kind in matrices
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
            "swing, last third minus first third", late - early, "below",
        )
    ]  # fmt: skip


def _on_long_races(numbers: Numbers) -> list[Claim]:
    longer = [numbers[f"phases {race}"].astype(np.float64) for race in (SPECIALISTS, GENERALISTS)]
    end, last = longer[0].shape[1], captured_by(numbers, GENERALISTS).shape[1] - 1
    some = max(1, last // 3)
    late, early = (
        np.mean([swing_between(each, *part) for each in longer], axis=0)
        for part in ((end - some + 1, end), (last - some + 1, last))
    )
    return [
        Claim(
            f"With {end} generations it diverges again",
            f"swing, last {some} generations minus the {some} before {last + 1}",
            late - early, "above",
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
                rates[:, half] - rates[:, 0], "above",
            ),
            Claim(
                "... and then hardly any more",
                f"escape rate against {name}, last minus half of the epochs",
                rates[:, -1] - rates[:, half], "below", CLEARLY,
            ),
        ]  # fmt: skip
    return found


def _on_surrounding(numbers: Numbers) -> list[Claim]:
    collided = "collisions with teammates per 1000 agent-steps"
    found = []
    for name in SURROUNDING.values():
        captured, collisions = (
            numbers[f"{name}: {what}"].astype(np.float64) for what in ("captured", "collisions")
        )
        found += [
            Claim(
                f"{name}: capture improves", "capture rate, last minus untrained",
                captured[:, -1] - captured[:, 0], "above",
            ),
            Claim(
                f"{name}: capture reaches half of what was published", "capture rate, last",
                captured[:, -1], "above", PUBLISHED_SURROUNDING / 2, f"{PUBLISHED_SURROUNDING}",
                comparable=False,
            ),
            Claim(
                f"{name}: collisions of teammates remain", collided,
                collisions[:, -1], "above", LEAST_COLLISIONS,
            ),
            Claim(
                f"{name}: collisions increase", f"{collided}, last minus untrained",
                collisions[:, -1] - collisions[:, 0], "above",
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
                rewards[:, 1] - rewards[:, 0], "above",
            ),
            Claim(
                f"{name}: teammates collide in most episodes", "share of the test episodes",
                colliding, "above", 0.5, "0.6",
            ),
            Claim(
                f"{name}: collisions are worse in tests than in training",
                "at fault per 1000 agent-steps, tests minus last tenth of the training",
                faults[:, 1] - faults[:, 0], "above",
            ),
        ]  # fmt: skip
    return found


# Candidates against opponents of other runs:


def standings(numbers: Numbers, team: Team) -> dict[str, dict[str, np.ndarray]]:
    """Return the mean payoff (seeds,) of each kind of candidates against each of `OPPONENTS`."""
    payoff = numbers[f"cross-play of {team}s"].astype(np.float64)
    third = max(1, payoff.shape[-1] // 3)
    found = (
        against_other_seeds(payoff),
        against_other_seeds(payoff[..., :third]),
        against_other_seeds(payoff[..., -third:]),
        numbers[f"held-out of {team}s"].astype(np.float64),
    )
    return {
        opponents: dict(zip(CANDIDATES[team], values, strict=True))
        for opponents, values in zip(OPPONENTS, found, strict=True)
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


def on_generalization(numbers: Numbers) -> list[Claim]:
    """Return the claims on candidates against each of `OPPONENTS`."""
    scores = {team: standings(numbers, team) for team in CANDIDATES}
    payoff = {"pursuer": "capture", "evader": "escape"}

    def gains(team: Team, better: str, worse: str) -> np.ndarray:
        return np.array([each[better] - each[worse] for each in scores[team].values()])

    evaders = gains("evader", GENERALISTS, EVADERS_ALONE)
    pursuers = gains("pursuer", GENERALISTS, PURSUERS_ALONE)
    return [
        *(
            Claim(
                says, f"difference of {payoff[team]} rates", gains(team, better, worse),
                side, than, published,
            )
            for says, team, better, worse, side, than, published in COMPARED
        ),
        Claim(
            "Who learns passively gains more from co-evolution",
            "co-evolved minus alone (against random), evaders minus pursuers",
            evaders - pursuers, "above",
        ),
    ]  # fmt: skip


# The tables:

CROSS_PLAY, CAPTURED = "cross-play of evaders", f"captured {SPECIALISTS}"
SURROUNDED = SURROUNDING["rewards"]
CLAIMS: Mapping[tuple[str, ...], Mapping[Callable[[Numbers], list[Claim]], tuple[str, ...]]] = {
    PARTS: {on_races: (CAPTURED,), _on_few_epochs: (f"captured {FEW_EPOCHS}",)},
    OPPONENTS: {on_generalization: (CROSS_PLAY,)},
    ("found",): {
        on_swings: (CAPTURED,),
        _on_long_races: (CAPTURED, f"phases {SPECIALISTS}"),
        _on_plateau: ("plateau: random",),
        _on_surrounding: (f"{SURROUNDED}: captured",),
        _on_safety: (f"{SURROUNDED}: faults",),
    },
}
"""Columns of each table, its claims, and some of the numbers that they take."""


CELLS = """\
A cell holds the verdict, the mean over the seeds with its 95 % interval, and the p-value, adjusted
for all tests of the same table. The last table holds the scores of all candidates."""


def tables(numbers: Numbers) -> str:
    """Return the claims, and the scores of all candidates, as tables in Markdown."""
    parts, missing = ["# Claims of the paper", CELLS], []
    for columns, found in CLAIMS.items():
        claims: list[Claim] = []
        for claims_on, names in found.items():
            lacking = [name for name in names if name not in numbers]
            missing += lacking
            claims += [] if lacking else claims_on(numbers)
        if claims:
            parts.append(table(columns, claims))
    parts.append(counted(parts))
    if missing:
        parts.append(f"Not measured: {', '.join(dict.fromkeys(missing))} (`--kinds`).")
    if CAPTURED in numbers:
        parts.append(returns(numbers))
    if CROSS_PLAY in numbers:
        parts.append(scores(numbers))
    if f"{SURROUNDED}: captured" in numbers and AT_ITS_SIZE.exists():
        parts += [ASSURANCE, paper_surrounding.ends(dict(np.load(AT_ITS_SIZE)))]
    return "\n\n".join(parts)


def table(columns: Sequence[str], claims: Sequence[Claim]) -> str:
    """Return claims with the same columns as a table in Markdown, with p-values adjusted in it."""
    p_values = iter(holm([p for claim in claims for p in claim.p_values()]))
    rows = [
        [
            claim.tested(),
            *(
                claim.cell(each, next(p_values) if claim.comparable else 1.0)
                for each in claim.columns
            ),
        ]
        for claim in claims
    ]
    return markdown(["the paper's claim, and the number that tests it", *columns], rows)


def verdicts(text: str) -> list[int]:
    """Return how many claims in the tables of a text have each verdict in their first column."""
    found = Counter(re.findall(r"seeds\* \| \*\*(.+?)\*\*", text))
    return [found[verdict] for verdict in VERDICTS]


def counted(tables: Sequence[str]) -> str:
    """Return how many claims of these tables hold, each counted once, in a sentence."""
    counts = zip(verdicts("\n".join(tables)), VERDICTS, strict=True)
    told = ", ".join(f"{count} {verdict}" for count, verdict in counts)
    return (
        "Each claim counted once, in its first column (the whole race, all generations): "
        f"{told}. Rows share runs, and the columns of a row overlap."
    )


def returns(numbers: Numbers) -> str:
    """Return in how many seeds, each by itself, skills of specialists return, in a sentence."""
    races = [read_payoffs(each, per_episode=True) for each in captured_by(numbers, SPECIALISTS)]
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
    seeds = {kind: 7 if kind in LONG.values() else 20 for kind in kinds(False)}
    experiment(
        __doc__,
        kinds=kinds,
        play=play_with_penalty_of_races,
        measure=measured,
        table=tables,
        seeds=seeds,
        fewest=2,
    )
