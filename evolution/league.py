"""What does a league hide? Scores in a league, exact grades, and what brings the two closer.

    python evolution/league.py --results evolution/results/league     ten minutes of one core
    python evolution/league.py --quick                                some seconds

Some hundred players of each team (``league_players.py``) meet in 24 small worlds that were used to
choose nothing. The *grade* of a player in a world is what it guarantees: its result against a best
response (docs/ground_truth.md). Its *score* in a league is its mean result against opponents. All
expected results are computed exactly; a league of so many episodes draws from them. The measure is
the share of pairs of players, of those whose grades differ, that the league orders otherwise; ties
in the league count a half. What is compared, and what counts, was written down before anything was
played: ``results/league/registered.md``.

Worlds that are finished stay in ``--runs``.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from functools import partial
from itertools import pairwise
from pathlib import Path
from typing import Any, TypeAlias

import numpy as np
from matplotlib.figure import Figure
from numpy.typing import ArrayLike, NDArray
from scipy import stats
from tqdm import tqdm

import league_players
import tabular
from common import Numbers, adjusted, markdown, script_parser, shown_p, write
from league_worlds import Floats, different, draw_worlds, played
from matrixworld._util.colors import BLUE, VERMILLION
from matrixworld.coevolution import TEAMS, Team
from matrixworld.coevolution.types import other
from matrixworld.plots import save_figure

PLAYERS = Path(__file__).parent / "results/league/players.npz"

REPEATS, QUICK_REPEATS = 20, 2
"""Leagues of each kind, drawn anew: opponents and episodes."""
OPPONENTS = (10, 25, 50, 100, 200)
CLASS = 25
"""Opponents in the league of a class."""
WORST, TOP, STRONG, FEWEST_PAIRS = 5, 12, 10, 100
"""Worst opponents; top of a table; strong opponents; ordered pairs that a world needs to count."""
TIE, CLEAR = 1e-9, 0.05
"""Grades, as shares: equal if they differ by at most the one, clear if by more than the other."""
RESAMPLED, INTERVAL_SEED = 10_000, 7
SIMULATED, QUICK_SIMULATED = 4_000, 16
"""Data sets for each error rate."""
HALVES = 100
"""Halves of the worlds that are drawn."""
GROUPS, QUICK_GROUPS = 20, 3
"""Class leagues of `REPEATS` each that are compared with each other."""
LEVEL, MARGIN = 0.95, 0.01
"""Differences whose interval lies within the margin are of no use."""
WIDER = 1.3
"""Factor of all intervals. Without it up to 14 % of simulated ones are wrong, where 7 % may be."""


# Leagues


class Results:
    """What a team's different tables get in a world, as its own payoffs in [0, 1].

    `row` says for each player which of the tables it is. Opponents are players.
    """

    def __init__(
        self, found: Mapping[str, NDArray[Any]], team: Team, kept: Mapping[Team, NDArray[np.intp]]
    ) -> None:
        means, squares = found["means"], found["squares"]
        grades, perfect = found[f"{team} grade"], found[f"{team} against perfect play"]
        self.best = float(found["value"])
        if team == "evader":
            means, squares = 1.0 - means.T, 1.0 - 2.0 * means.T + squares.T
            grades, perfect, self.best = 1.0 - grades, 1.0 - perfect, 1.0 - self.best
        own, self.row = np.unique(found[f"{team} table"][kept[team]], return_inverse=True)
        opponents = found[f"{other(team)} table"][kept[other(team)]]
        self.means, self.squares = (each[own][:, opponents] for each in (means, squares))
        self.grades, self.against_perfect = grades[own], perfect[own]

    def drawn(self, opponents: NDArray[np.intp], episodes: float, rng: Any) -> Floats:
        """Return the results (tables, opponents) in so many episodes, or expected ones."""
        means, squares = self.means[:, opponents], self.squares[:, opponents]
        if episodes == np.inf:
            return means
        count = int(episodes)
        all_won = np.clip(2.0 * squares - means, 0.0, 1.0)
        half_won = np.clip(4.0 * (means - squares), 0.0, 1.0 - all_won)  # one of two evaders
        wins = rng.binomial(count, all_won)
        shares = np.divide(half_won, 1.0 - all_won, out=np.zeros_like(means), where=all_won < 1.0)
        halves = rng.binomial(count - wins, np.clip(shares, 0.0, 1.0))
        return np.asarray((wins + 0.5 * halves) / count)


def league(opponents: float, episodes: float = np.inf) -> str:
    """Return the name of a league."""
    who = "all" if opponents == np.inf else f"{opponents:.0f}"
    return f"{who} opponents, {'expected results' if episodes == np.inf else told(episodes)}"


def told(episodes: float) -> str:
    """Return a number of episodes as text."""
    return f"{episodes:.0f} episode{'s' * (episodes > 1)}"


ENDLESS, CLASS_LEAGUE = league(np.inf), league(CLASS, 10)
QUARTER, BEST_QUARTER = "a quarter of the opponents", "the best quarter of the opponents"
STRONGEST = f"the {STRONG} best opponents"
THE_WORST, WORST_FEW = "the worst opponent", f"the {WORST} worst opponents, mean"
IN_CLASS = " of the class league"
WORST_OFTEN = f"the worst of {CLASS} opponents, 100 episodes"
WORST_EXPECTED = f"the worst of {CLASS} opponents, expected results"
PERFECT = "perfect play"
LONG, WIDE = league(CLASS, 80), league(200, 10)
COMPARISONS: Mapping[str, tuple[str, str]] = {
    **{
        f"a: {told(few)} to {'expected results' if many == np.inf else f'{many:.0f}'}": (
            league(CLASS, many), league(CLASS, few)
        )
        for few, many in ((1, 10), (10, 100), (10, np.inf))
    },
    **{
        f"b: {few} opponents to {many}": (league(many), league(few))
        for few, many in pairwise(OPPONENTS)
    },
    "ab: 80 episodes, 25 opponents; not 10 and 200": (LONG, WIDE),
    f"c: the {STRONG} best, not {STRONG} drawn": (STRONGEST, league(STRONG)),
    "c: the best quarter, not a quarter drawn": (BEST_QUARTER, QUARTER),
    "d: the worst, not the mean": (THE_WORST, ENDLESS),
    f"d: the {WORST} worst, not the mean": (WORST_FEW, ENDLESS),
    "d': the worst of a class, not the mean": (THE_WORST + IN_CLASS, CLASS_LEAGUE),
    f"d': the {WORST} worst of a class, not the mean": (WORST_FEW + IN_CLASS, CLASS_LEAGUE),
    "e: perfect play, not the league": (PERFECT, ENDLESS),
}  # fmt: skip
"""What is compared with what: a league, and the one that it is held against."""
CLEARLY = CLASS_LEAGUE, ENDLESS, THE_WORST, PERFECT
"""Leagues of which pairs whose grades differ clearly are told, too."""


def worst(results: Floats, count: int) -> Floats:
    """Return the means of the worst results against so many opponents."""
    return np.sort(results, axis=1)[:, :count].mean(axis=1)


def scores_of(
    results: Results, order: NDArray[np.intp], best: NDArray[np.intp], rng: Any
) -> dict[str, Floats]:
    """Return the scores of the tables in all leagues, drawn once.

    Opponents are drawn in an `order`; another one begins with the `best`.
    """
    quarter, few = len(order) // 4, order[:CLASS]
    drawn = partial(results.drawn, rng=rng)
    once, often, in_class = (drawn(few, count) for count in (1, 100, 10))
    found = {league(CLASS, 1): once.mean(axis=1), league(CLASS, 100): often.mean(axis=1)}
    found |= {
        CLASS_LEAGUE: in_class.mean(axis=1),
        THE_WORST + IN_CLASS: worst(in_class, 1),
        WORST_FEW + IN_CLASS: worst(in_class, WORST),
        LONG: drawn(few, 80).mean(axis=1),
        WIDE: drawn(order[:200], 10).mean(axis=1),
        WORST_OFTEN: worst(often, 1),
        WORST_EXPECTED: worst(results.means[:, few], 1),
        QUARTER: results.means[:, order[:quarter]].mean(axis=1),
        BEST_QUARTER: results.means[:, best[:quarter]].mean(axis=1),
        STRONGEST: results.means[:, best[:STRONG]].mean(axis=1),
        ENDLESS: results.means.mean(axis=1),
        THE_WORST: worst(results.means, 1),
        WORST_FEW: worst(results.means, WORST),
        PERFECT: results.against_perfect,
    }
    return found | {
        league(count): results.means[:, order[:count]].mean(axis=1) for count in OPPONENTS
    }


def otherwise(
    grades: Floats, scores: Floats, fewest: int = FEWEST_PAIRS, least: float = TIE
) -> float:
    """Return the share of pairs with different grades that scores order otherwise, or NaN."""
    first, second = np.triu_indices(len(grades), 1)
    by_grade = grades[first] - grades[second]
    differ = np.abs(by_grade) > least
    if differ.sum() < fewest:
        return np.nan
    by_score = (scores[first] - scores[second])[differ] * np.sign(by_grade[differ])
    return float(np.mean((by_score < -TIE) + 0.5 * (np.abs(by_score) <= TIE)))


def top(grades: Floats, scores: Floats, fewest: int = 10) -> float:
    """Return the share of pairs ordered otherwise among those with the largest scores."""
    chosen = np.argsort(-scores, kind="stable")[:TOP]
    return otherwise(grades[chosen], scores[chosen], fewest)


def surely_wrong(grades: Floats, scores: Floats) -> tuple[int, int]:
    """Return how many pairs have surely different mean grades, and how many scores have wrong.

    Grades and scores are (worlds, players).
    """
    first, second = np.triu_indices(grades.shape[1], 1)
    by_grade = grades[:, first] - grades[:, second]
    means, errors = by_grade.mean(axis=0), stats.sem(by_grade, axis=0)
    sure = np.abs(means) > np.maximum(errors * stats.t.ppf(0.975, len(grades) - 1), TIE)
    by_score = (scores[:, first] - scores[:, second]).mean(axis=0)
    return int(sure.sum()), int((sure & (means * by_score < 0.0)).sum())


def halves(grades: Floats, scores: Floats) -> tuple[float, float]:
    """Return how many pairs the other half of the worlds orders otherwise: by grade, by score.

    Of grades that are averaged over a half of the worlds (worlds, players), which is drawn.
    """
    rng = np.random.default_rng(INTERVAL_SEED)
    found = []
    for _ in range(HALVES):
        one, another = np.array_split(rng.permutation(len(grades)), 2)
        mean = grades[one].mean(axis=0)
        found.append([otherwise(mean, each[another].mean(axis=0)) for each in (grades, scores)])
    by_grade, by_score = np.mean(found, axis=0)
    return float(by_grade), float(by_score)


def said_of(name: str) -> list[tuple[str, float]]:
    """Return of which pairs a league is told: names, and how much their grades differ at least."""
    clear = [(f"{name}; clear", CLEAR)] if name in CLEARLY else []
    return [(name, TIE), *clear]


def measured(
    found: list[dict[str, NDArray[Any]]], kept: Mapping[Team, Any], quick: bool
) -> dict[str, Any]:
    """Return what the leagues of all worlds have otherwise than the grades."""
    numbers: dict[str, Any] = {}
    of = {team: [Results(each, team, kept) for each in found] for team in TEAMS}
    shares = {
        team: np.stack([(each.grades / each.best)[each.row] for each in of[team]]) for team in TEAMS
    }
    repeats, groups = (QUICK_REPEATS, QUICK_GROUPS) if quick else (REPEATS, GROUPS)
    dozen = np.arange(len(found)) < len(found) // 2
    for team in TEAMS:
        rivals = shares[other(team)]
        best = [np.argsort(-rivals[dozen != mine].mean(axis=0), kind="stable") for mine in dozen]
        grades = shares[team].mean(axis=0)
        of_world: dict[str, list[list[float]]] = {}
        over_all: dict[str, list[float]] = {}
        for repeat in tqdm(range(repeats), desc=team, unit=" leagues", disable=None):
            common_rng = np.random.default_rng([repeat, TEAMS.index(team)])
            common_order, totals = common_rng.permutation(rivals.shape[1]), {}
            for place, results in enumerate(of[team]):
                rng = np.random.default_rng([repeat, TEAMS.index(team), place + 1])
                order, own = rng.permutation(rivals.shape[1]), results.grades / results.best
                for name, scores in scores_of(results, order, best[place], rng).items():
                    for told, least in said_of(name):
                        worlds = of_world.setdefault(told, [[] for _ in found])
                        worlds[place].append(otherwise(own, scores, least=least))
                same = scores_of(results, common_order, best[place], common_rng)
                for name, scores in same.items():
                    share = scores[results.row] / results.best / len(found)
                    totals[name] = totals.get(name, 0.0) + share
            for name, scores in totals.items():
                for told, least in said_of(name):
                    over_all.setdefault(told, []).append(otherwise(grades, scores, least=least))
        for name, worlds in of_world.items():
            numbers[f"{team} / {name}"] = np.mean(worlds, axis=1)
            numbers[f"{team} over all worlds / {name}"] = np.mean(over_all[name])
        endless = np.stack([(each.means.mean(axis=1) / each.best)[each.row] for each in of[team]])
        numbers[f"{team} grades"] = np.float32(shares[team])
        numbers[f"{team} scores"] = np.float32(endless)
        numbers[f"{team} top"] = [top(each.grades, each.means.mean(axis=1)) for each in of[team]]
        numbers[f"{team} tau"] = [
            stats.kendalltau(each.grades, each.means.mean(axis=1)).statistic for each in of[team]
        ]
        numbers[f"{team} tau over all worlds"] = stats.kendalltau(
            shares[team].mean(axis=0), endless.mean(axis=0)
        ).statistic
        means = shares[team].mean(axis=0), endless.mean(axis=0)
        numbers[f"{team} top over all worlds"] = top(*means)
        numbers[f"{team} surely different, wrong"] = surely_wrong(shares[team], endless)
        chosen = np.argsort(-means[1], kind="stable")[:TOP]
        numbers[f"{team} top surely different, wrong"] = surely_wrong(
            shares[team][:, chosen], endless[:, chosen]
        )
        numbers[f"{team} halves"] = halves(shares[team], endless)
        numbers[f"{team} differs from itself"] = itself(of[team], len(rivals.T), groups, repeats)
    return {**numbers, **errors(numbers, QUICK_SIMULATED if quick else SIMULATED)}


# Intervals and their errors


def interval(differences: ArrayLike, wider: float = WIDER) -> tuple[Floats, Floats]:
    """Return the ends of intervals of means, from (worlds, ...).

    Percentiles of a bootstrap, widened for few worlds (Hesterberg 2015, "What teachers should know
    about the bootstrap"), and by the factor.
    """
    values = np.asarray(differences, np.float64)
    n = len(values)
    rng = np.random.default_rng(INTERVAL_SEED)
    counts = rng.multinomial(n, np.full(n, 1.0 / n), RESAMPLED) / n
    far = np.sqrt(n / (n - 1)) * stats.t.ppf(0.5 + LEVEL / 2, n - 1)
    tail = stats.norm.cdf(-wider * far)
    low, high = np.quantile(np.tensordot(counts, values, 1), [tail, 1.0 - tail], axis=0)
    return low, high


def compared(numbers: Numbers, team: Team, comparison: str) -> Floats:
    """Return how much more pairs a league orders otherwise than the one it is held against."""
    more, less = (numbers[f"{team} / {name}"] for name in COMPARISONS[comparison])
    return (more - less)[~np.isnan(more)]


def error_rates(drawn: Floats, wider: float) -> tuple[float, float]:
    """Return how often intervals of (worlds, data sets) are wrong whose true means are 0.

    They are if they exclude 0; and if, with 1 point more, they lie within the margin.
    """
    parts = [interval(part, wider) for part in np.array_split(drawn, 16, axis=1)]
    low, high = (np.concatenate(side) for side in zip(*parts, strict=True))
    inside = (low + MARGIN >= -MARGIN) & (high + MARGIN <= MARGIN)
    return float(np.mean((low > 0.0) | (high < 0.0))), float(np.mean(inside))


def errors(numbers: Numbers, simulated: int) -> dict[str, Any]:
    """Return how often intervals of simulated differences are wrong, by comparison."""
    rng = np.random.default_rng(INTERVAL_SEED)
    found: dict[str, Any] = {}
    for team in TEAMS:
        for comparison in COMPARISONS:
            differences = compared(numbers, team, comparison)
            if np.ptp(differences) < TIE:
                continue
            n = len(differences)
            drawn = (differences - differences.mean())[rng.integers(n, size=(n, simulated))]
            found[f"{team}, {comparison} / errors"] = [
                wrong for wider in (1.0, WIDER) for wrong in error_rates(drawn, wider)
            ]
    return found


def itself(worlds: list[Results], n_opponents: int, groups: int, repeats: int) -> tuple[int, int]:
    """Return pairs of class leagues that differ in draws alone, and how many differ 'surely'."""
    shares = np.empty((len(worlds), groups, repeats))
    for place, results in enumerate(worlds):
        rng = np.random.default_rng([INTERVAL_SEED, place])
        for at in np.ndindex(groups, repeats):
            opponents = rng.permutation(n_opponents)[:CLASS]
            scores = results.drawn(opponents, 10, rng).mean(axis=1)
            shares[(place, *at)] = otherwise(results.grades, scores)
    means = shares.mean(axis=2)
    means = means[~np.isnan(means).any(axis=1)]
    first, second = np.triu_indices(groups, 1)
    low, high = interval(means[:, first] - means[:, second])
    return len(first), int(((low > 0.0) | (high < 0.0)).sum())


def verdict(low: float, high: float, p: float) -> str:
    """Return what a difference of pairs ordered otherwise says."""
    small = low >= -MARGIN and high <= MARGIN
    if p < 1.0 - LEVEL and (high < 0.0 or low > 0.0):
        return ("helps" if high < 0.0 else "harms") + (", below the margin" if small else "")
    return "no useful effect" if small else "cannot tell"


# What is told


def shown(values: ArrayLike, digits: int = 1, sign: str = "") -> str:
    """Return the mean over worlds and its interval, in percent."""
    known = np.asarray(values)[~np.isnan(values)]
    ends = (known.mean(), *interval(known)) if np.ptp(known) > TIE else (known.mean(),)
    value, *rest = (f"{round(100 * end, digits) + 0.0:{sign}.{digits}f}" for end in ends)
    return f"{value} [{', '.join(rest)}]" if rest else value


def p_values(numbers: Numbers) -> dict[tuple[str, Team], float]:
    """Return the p-value of each comparison and team, adjusted for all of them."""
    return adjusted(
        {(name, team): compared(numbers, team, name) for name in COMPARISONS for team in TEAMS}
    )


Ends: TypeAlias = tuple[float, float]


def ends(values: ArrayLike) -> Ends:
    """Return the interval of a mean over the worlds that count."""
    known = np.asarray(values)[~np.isnan(values)]
    low, high = interval(known)
    return float(low), float(high)


def above(bound: float, values: ArrayLike) -> str:
    """Return whether a mean is above a bound."""
    low, high = ends(values)
    return "yes" if low > bound else "no" if high < bound else "cannot tell"


def begins(*names: str) -> list[str]:
    """Return comparisons whose names begin so."""
    return [each for each in COMPARISONS if each.startswith(names)]


SMALL = "no useful effect", "helps, below the margin", "harms, below the margin"
EXPECTED: Mapping[str, tuple[list[str], tuple[str, ...]]] = {
    "4. The worst opponent helps": (begins("d: the worst"), ("helps", SMALL[1])),
    "5. Expected results instead of 10 episodes have no useful effect": (
        begins("a: 10 episodes to expected"), SMALL
    ),
    "7. More than 50 opponents have no useful effect": (begins("b: 50", "b: 100"), SMALL),
}  # fmt: skip
"""Hypotheses: comparisons, and the verdicts that they expect."""


def hypotheses(numbers: Numbers) -> list[list[str]]:
    """Return the registered hypotheses, what is measured, and the verdicts."""
    p, rows = p_values(numbers), []

    def tell(what: str, team: str, found: Iterable[Any], said: str) -> None:
        measured = "; ".join(shown(each, sign="" if what[0] == "1" else "+") for each in found)
        rows.append([f"{what}{team and f': {team}s'}", measured, said])

    endless = {team: numbers[f"{team} / {ENDLESS}"] for team in TEAMS}
    more = endless["evader"] - endless["pursuer"]
    tell("2. Evaders are ordered worse than pursuers", "", [more], above(0.0, more))
    for team in TEAMS:
        found = endless[team]
        tell("1. More than 5 % of pairs are otherwise", team, [found], above(0.05, found))
        more = numbers[f"{team} top"] - found
        tell(f"3. The top {TOP} of a world are ordered worse", team, [more], above(0.0, more))
        for what, (names, wanted) in EXPECTED.items():
            effects = {name: compared(numbers, team, name) for name in names}
            verdicts = [verdict(*ends(each), p[name, team]) for name, each in effects.items()]
            agree = {each in wanted for each in verdicts if each != "cannot tell"}
            said = "no" if False in agree else "cannot tell" if "cannot tell" in verdicts else "yes"
            tell(what, team, effects.values(), said)
        gains = [-compared(numbers, team, name) for name in begins("c")]
        below = [above(-MARGIN, -each) for each in gains]
        said = "no" if "no" in below else "cannot tell" if "cannot tell" in below else "yes"
        told = "6. Stronger opponents gain less than 1 point"
        tell(told, team, [-each for each in gains], said)
    return sorted(rows)


def leagues(numbers: Numbers) -> list[list[str]]:
    """Return what each league has otherwise."""
    names = [name for pair in COMPARISONS.values() for name in pair[::-1]]
    return [
        [
            name,
            *(shown(numbers[f"{team} / {name}"]) for team in TEAMS),
            *(f"{100 * numbers[f'{team} over all worlds / {name}']:.1f}" for team in TEAMS),
        ]
        for name in dict.fromkeys(
            [*names, WORST_OFTEN, WORST_EXPECTED, *(f"{name}; clear" for name in CLEARLY)]
        )
    ]


def effects(numbers: Numbers) -> list[list[str]]:
    """Return what each comparison says."""
    p, rows = p_values(numbers), []
    for name in COMPARISONS:
        rows.append([name])
        for team in TEAMS:
            found = compared(numbers, team, name)
            said = verdict(*ends(found), p[name, team])
            rows[-1] += [shown(found, sign="+"), f"{said} ({shown_p(p[name, team])})"]
    return rows


def further(numbers: Numbers) -> dict[str, list[str]]:
    """Return what else is told of the endless league, and the errors of the intervals."""
    found: dict[str, list[str]] = {}

    def add(what: str, value: str) -> None:
        found.setdefault(what, []).append(value)

    for team in TEAMS:
        endless, tau = numbers[f"{team} / {ENDLESS}"], numbers[f"{team} tau"]
        add("different players", str(numbers[f"{team} grades"].shape[1]))
        add("worlds that count", str(int((~np.isnan(endless)).sum())))
        add("pairs otherwise in worlds in turns, %", shown(endless[0::2]))
        add("pairs otherwise in worlds at once, %", shown(endless[1::2]))
        add(f"pairs otherwise among the top {TOP} of a world, %", shown(numbers[f"{team} top"]))
        add("worlds that count for it", str(int((~np.isnan(numbers[f"{team} top"])).sum())))
        add(
            "Kendall's tau in a world, mean (least)",
            f"{np.nanmean(tau):.2f} ({np.nanmin(tau):.2f})",
        )
        all_worlds = numbers[f"{team} top over all worlds"]
        add(f"pairs otherwise among the top {TOP} over all worlds, %", f"{100 * all_worlds:.1f}")
        add("Kendall's tau over all worlds", f"{numbers[f'{team} tau over all worlds']:.2f}")
        for what, of in (
            ("pairs with surely different grades that the league has wrong", team),
            (f"the same among its top {TOP} over all worlds", f"{team} top"),
        ):
            sure, wrong = numbers[f"{of} surely different, wrong"].tolist()
            add(what, f"{wrong:,} of {sure:,} ({wrong / max(sure, 1):.1%})")
        for what, rate in zip(("grade", "score"), numbers[f"{team} halves"], strict=True):
            add(
                f"grades of half of the worlds, otherwise by {what} in the others, %",
                f"{100 * rate:.1f}",
            )
        names = (f"{team}, {name} / errors" for name in COMPARISONS)
        rates = np.array([numbers[name] for name in names if name in numbers]).T
        for what, rate in zip(ERRORS, rates, strict=True):
            add(f"{what}: mean over comparisons (most)", f"{rate.mean():.1%} ({rate.max():.1%})")
        all_pairs, differ = numbers[f"{team} differs from itself"].tolist()
        add(
            "the class league against itself: interval excludes 0", f"{differ} of {all_pairs} pairs"
        )
    return found


ERRORS = (
    "not widened: no difference, and the interval excludes 0",
    "not widened: 1 point, and the interval is in the margin",
    "no difference, and the interval excludes 0",
    "1 point, and the interval is in the margin",
)


def table(numbers: Numbers) -> str:
    """Return what the numbers say, in Markdown."""
    both = "pursuers", "evaders"
    parts = {
        f"Pairs ordered otherwise than by grade, percent (95 % over worlds, widened by {WIDER}). "
        f"*Clear*: grades that differ by more than {100 * CLEAR:.0f} points. The last rows, from "
        f"*{WORST_OFTEN}* on, were not registered.": markdown(
            ["league", *both, *(f"{team}, over all worlds" for team in both)], leagues(numbers)
        ),
        "Differences, percentage points; p-values are adjusted for all of this table.": markdown(
            ["", "pursuers", "verdict", "evaders", "verdict"], effects(numbers)
        ),
        "Hypotheses (percent, or points).": markdown(
            ["", "measured", "verdict"], hypotheses(numbers)
        ),
        "The endless league, and errors of the intervals.": markdown(
            ["", *both], [[what, *told] for what, told in further(numbers).items()]
        ),
    }
    told = "\n\n".join(f"{what}\n\n{part}" for what, part in parts.items())
    return told.replace("|  |", "| |")


DRAWN = {
    league(CLASS, 1): "25 opponents, 1 episode",
    CLASS_LEAGUE: "25 opponents, 10 episodes",
    league(CLASS, 100): "25 opponents, 100 episodes",
    league(CLASS): "25 opponents, expected results",
    ENDLESS: "all opponents, expected results",
    STRONGEST: "the 10 best opponents, expected results",
    PERFECT: "a perfect opponent, expected results",
    THE_WORST + IN_CLASS: "worst of 25, 10 episodes",
    WORST_OFTEN: "worst of 25, 100 episodes",
    WORST_EXPECTED: "worst of 25, expected results",
    THE_WORST: "worst of all, expected results",
}
"""Leagues of the figure, and what it calls them."""


def draw(numbers: Numbers) -> Figure:
    """Draw what leagues have otherwise, with intervals."""
    figure = Figure((7.0, 4.0), layout="constrained")
    axes = figure.subplots()
    for shift, team, color, marker in (
        (-0.13, "pursuer", BLUE, "o"),
        (0.13, "evader", VERMILLION, "s"),
    ):
        for place, name in enumerate(DRAWN):
            values = 100 * numbers[f"{team} / {name}"]
            values = values[~np.isnan(values)]
            low, high = interval(values)
            axes.plot([low, high], [place + shift] * 2, color=color, lw=1.5)
            label = f"{team}s" if place == 0 else None
            axes.plot(values.mean(), place + shift, marker, color=color, ms=6, label=label)
    axes.set_yticks(range(len(DRAWN)), DRAWN.values())
    axes.invert_yaxis()
    axes.set_xlim(0, None)
    axes.set_xlabel("pairs ordered otherwise than by grade, %")
    axes.grid(axis="x", alpha=0.3)
    axes.spines[["top", "right"]].set_visible(False)
    axes.legend(frameon=False)
    return figure


def results_of(
    worlds: list[str], players: Mapping[Team, list[Any]], runs: Path
) -> list[dict[str, NDArray[Any]]]:
    """Return the results in all worlds; play what is left."""
    found = []
    runs.mkdir(parents=True, exist_ok=True)
    for place, name in enumerate(tqdm(worlds, unit=" worlds", disable=None)):
        file = runs / f"{place}.npz"
        if not file.exists():
            part = file.with_suffix(".part.npz")
            np.savez_compressed(part, **played(name, players))
            part.rename(file)
        with np.load(file) as kept:
            found.append(dict(kept))
    return found


def main() -> None:
    """Play what is left of the worlds, and compare leagues with grades."""
    told = "few players in worlds of another list, some seconds"
    args = script_parser(__doc__, quick=told, runs=True).parse_args()
    players = {team: [*found.items()] for team, found in league_players.load(PLAYERS).items()}
    worlds = draw_worlds()
    if args.quick:
        players = {team: found[::12] for team, found in players.items()}
        worlds = [*tabular.WORLDS[:8:2], *tabular.WORLDS[5:16:5]]
    given = {team: [player for _, player in named] for team, named in players.items()}
    found = results_of(worlds, given, args.runs)
    numbers: dict[str, Any] = {"worlds": worlds}
    kept = {}
    for team, named in players.items():
        tables = np.stack([each[f"{team} table"] for each in found], axis=1)
        kept[team], _ = different([[row] for row in tables])
        numbers[f"{team} names"] = [named[place][0] for place in kept[team]]
    numbers |= measured(found, kept, args.quick)
    write(args.results, numbers, table)
    save_figure(draw(numbers), args.results / "figure.png")


if __name__ == "__main__":
    main()
