"""How often are verdicts wrong with scores of both teams, or of one population? A benchmark.

    python evolution/validation/general_sum.py           72 races of each family, five minutes
    python evolution/validation/general_sum.py --quick   two races of each family, seconds

Races are synthetic, and no constant of the judgement was chosen on them. Times t run from 0 to 1,
g and h are generations of the first and of the second team:

- *two teams*: scores ``.5 + a[g] + b[h] + style[g, h]`` of the first, ``.5 + c[h] + d[g] + style'``
  of the second team, clipped to [0, 1]: own skills a and c, and what the other one gives, b and d
  (in a dilemma a side gains and takes more than that; in an escalation both take, and have less);
- *one population, constant sum*: ``m[g, h] = .5 + s[g] - s[h] + style``, clipped, where ``m[h, g]``
  is one minus ``m[g, h]`` in the same episodes, and 1/2 on the diagonal;
- *one population, both scores*: ``m[g, h] = .5 + a[g] + d[h] + style``, clipped; the other one has
  ``m[h, g]``.

A group has 1, 3 or 8 runs, whose parameters are alike, of 12 or 30 generations; a pair has 4 or 10
episodes, won or lost or with smooth noise, or one exact score. The scores of both sides in an
episode are independent, alike or opposed. These settings take turns, so that each family has all.

What is true comes from the scores without noise, by no part of the judgement but its fit of an
order of strength, over the whole race:

===============  ================================================================================
joint rise       the mean of both sides against contemporaries (generation k against k, k - 1, and
                 k - 1 against k) changes by more than .05 (slope times length); fall: by less than
                 -.05
rise             of a team: its mean score against all opponents changes by more than .05
forgetting       of a team: mean drop below its best ancestors, in the later half, above .05
cycling          by construction: styles rotate 1.5 to 4 times; false in all other families
progress         of a team: by construction its skill has a drift, and it rises; false of random
                 walks, fluctuation, jumps, falls, rotation, new styles and no change; else open
intransitivity   root mean square deviation from the nearest order above .05, and 1 % of the
                 quadruples are checkerboards; false: deviation of .05 at most
stagnation       a change of .05 at most, and no intransitivity; open if there is a drift
===============  ================================================================================

Of 8 runs it is true of the mean of the numbers, as played. Of 3 runs it is true if it is of each
run, false if it is of none, else open. What is open is not counted. Progress, rises and forgetting
are counted for each team: a verdict that names the other team only is "cannot tell" of this one.

``--results`` (or ``--out``) receives counts.csv, and table.md, which follows from it.
"""

from __future__ import annotations

import argparse
import zlib
from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from functools import partial
from itertools import product
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from scipy.stats import beta
from tqdm import tqdm

import _paths  # noqa: F401
from common import markdown, script_parser
from judgement_races import Draws, coin, moment, time
from judgement_tables import Row, read_counts, totals, write_counts
from matrixworld.analysis import checkerboards, judge, read_payoffs
from matrixworld.analysis.cycles import MARGIN, squared_intransitivity
from matrixworld.analysis.judgement import Finding
from matrixworld.analysis.payoffs import Payoffs
from matrixworld.coevolution.types import FloatArray

RACES, QUICK_RACES = 72, 2
SEED = 70_000
"""Seed of the published races."""
MARGIN_OF_CHANGE, MARGIN_OF_DEVIATION, LEAST_BOARDS = 0.05, 0.05, 0.01
FEW = 3
"""Up to so many runs, a condition has to hold in each."""
EXACT = "exact"
SETTINGS = {
    "generations": ("12", "30"),
    "runs": ("1", "3", "8"),
    "episodes": ("4", "10", EXACT),
    "noise": ("win or loss", "smooth"),
}
TEAMS = ("pursuers", "evaders")
TWO, ONE, ONE_GENERAL = "two teams", "one population, constant sum", "one population, both scores"
OWN, SAME, CONSTANT = "own rules", "own rules, same races", "constant sum"
"""Rules: those of the game; the same on the races that are also judged by the first team's scores
alone, as if the second team lost what the first one wins."""
SECOND = ", second"
"""A condition of the second team."""
RISE_OF_SECOND, LOSS_OF_SECOND = f"rise{SECOND}", f"forgetting{SECOND}"
OF_TEAMS = ("progress", "rise", "forgetting")
PRESENT, ABSENT, CANNOT_TELL = "present", "absent", "cannot tell"


class Race(NamedTuple):
    """Scores (n, n) without noise, and what is known by construction; None is open."""

    first: FloatArray
    second: FloatArray
    cycles: bool = False
    drifts: bool | None = False


# ---- Courses and styles --------------------------------------------------------------------------

Course = Callable[[int, Draws], FloatArray]
"""Generations and draws -> a skill (n,), or what is given."""


def rise(n: int, draws: Draws, low: float = 0.05, high: float = 0.35) -> FloatArray:
    """``x t^p - x / 2``: an even rise by x, or one that becomes slower or faster."""
    pace = draws.shared.uniform(0.6, 1.6)
    return np.asarray(draws.size(low, high) * (time(n) ** pace - 0.5))


def small_rise(n: int, draws: Draws) -> FloatArray:
    """Return a `rise` by .03 to .25."""
    return rise(n, draws, 0.03, 0.25)


def small_fall(n: int, draws: Draws) -> FloatArray:
    """Return a fall by .03 to .25."""
    return -small_rise(n, draws)


def still(n: int, draws: Draws) -> FloatArray:
    """Return a constant, which differs between runs."""
    return np.full(n, draws.own.normal(0.0, 0.05))


def fluctuation(n: int, draws: Draws) -> FloatArray:
    """Return an autoregressive course without trend: of any generation N(0, .02 to .08)."""
    keeps, course = draws.shared.uniform(0.0, 0.8), draws.own.normal(size=n)
    for g in range(1, n):
        course[g] = keeps * course[g - 1] + np.sqrt(1.0 - keeps**2) * course[g]
    return np.asarray(draws.size(0.02, 0.08) * course)


def walk(n: int, draws: Draws) -> FloatArray:
    """Return a random walk without drift, whose end is N(0, .1 to .3)."""
    steps = draws.own.normal(size=n) * draws.size(0.1, 0.3) / np.sqrt(n - 1)
    return np.asarray(steps.cumsum() - steps[0])


def jump(n: int, draws: Draws) -> FloatArray:
    """Return a course that goes up or down by .1 to .3 in one generation."""
    up = 1.0 if coin(draws) else -1.0
    return np.asarray(up * draws.size(0.1, 0.3) * ((time(n) >= moment(draws, 0.2, 0.8)) - 0.5))


def regress(n: int, draws: Draws) -> FloatArray:
    """Return a course that rises by .1 to .35 to a peak, and loses .5 to 1.2 of that again."""
    peak, lost = moment(draws, 0.3, 0.6), draws.size(0.5, 1.2)
    shape = np.interp(time(n), (0.0, peak, 1.0), (0.0, 1.0, 1.0 - lost))
    return np.asarray(draws.size(0.1, 0.35) * (shape - 0.5))


Styles = tuple[FloatArray, FloatArray]
"""Vectors (n, k) of both sides, whose products are what styles give."""


def rotation(n: int, draws: Draws, low: float, high: float, *, sides: int) -> Styles:
    """Return places on a circle, which both sides go round `low` to `high` times."""
    turns = draws.shared.uniform(low, high) * draws.shared.choice((-1.0, 1.0))
    begin = draws.own.uniform(0.0, 2.0 * np.pi)
    lag = draws.own.normal(0.0, 0.5) if sides == 2 else 0.0
    places = [begin + 2.0 * np.pi * turns * time(n) + shift for shift in (0.0, lag)]
    first, second = (np.stack([np.cos(at), np.sin(at)], axis=1) for at in places)
    return first, second


returns = partial(rotation, low=1.5, high=4.0)
half_turn = partial(rotation, low=0.1, high=0.45)


def line(n: int, draws: Draws, *, sides: int) -> Styles:
    """Return styles that go on along a line, 2 to 8 times the width at which they match."""
    length, lag = draws.size(2.0, 8.0), draws.own.normal(0.0, 0.3) if sides == 2 else 0.0
    at = length * time(n)
    middles = np.linspace(-3.0, length + 3.0, 60)
    # Places as bumps, whose product falls with the square of the distance.
    first, second = (np.exp(-((place[:, None] - middles) ** 2)) for place in (at, at + lag))
    scale = np.sqrt((first**2).sum(axis=1).max())
    return first / scale, second / scale


def new(n: int, draws: Draws, *, sides: int) -> Styles:
    """Return a new style in each generation: a direction in six dimensions."""
    styles = draws.own.normal(size=(sides, n, 6))
    styles /= np.linalg.norm(styles, axis=2, keepdims=True)
    return styles[0], styles[-1]


# ---- Families ------------------------------------------------------------------------------------


def two_teams(
    n: int,
    draws: Draws,
    *,
    own: Course = still,
    given: Course | None = still,
    takes: float = 0.0,
    styles: Callable[..., Styles] | None = None,
    signs: tuple[float, float] = (1.0, 1.0),
    cycles: bool = False,
    drifts: bool | None = False,
) -> Race:
    """Return a race; without `given`, a side takes its own skill, times `takes`, from the other.

    Styles that match add to the scores of both sides, times `signs`.
    """
    a, c = own(n, draws), own(n, draws)
    if given is None:
        share = draws.size(takes, 1.7 * takes) if takes != 1.0 else 1.0
        b, d = -share * c, -share * a
    else:
        b, d = given(n, draws), given(n, draws)
    first, second = a[:, None] + b, d[:, None] + c
    if styles is not None:
        one, other = styles(n, draws, sides=2)
        for scores, sign in zip((first, second), signs, strict=True):
            scores += sign * draws.size(0.1, 0.4) * (one @ other.T)
    return Race(_clipped(first), _clipped(second), cycles, drifts)


def one_constant(
    n: int,
    draws: Draws,
    *,
    own: Course = still,
    styles: Callable[..., Styles] | None = None,
    cycles: bool = False,
    drifts: bool | None = False,
) -> Race:
    """Return a race of one population, in which styles beat each other as in a circle."""
    skill = own(n, draws)
    scores = skill[:, None] - skill
    if styles is not None:
        place, _ = styles(n, draws, sides=1)
        ahead = np.concatenate([place[:, 1::2], -place[:, ::2]], axis=1)
        behind = np.concatenate([place[:, ::2], place[:, 1::2]], axis=1)
        scores += draws.size(0.1, 0.4) * (ahead @ behind.T)
    first = _clipped(scores)
    return Race(first, 1.0 - first, cycles, drifts)


def one_general(
    n: int,
    draws: Draws,
    *,
    own: Course = still,
    given: Course | None = still,
    takes: float = 1.2,
    styles: Callable[..., Styles] | None = None,
    cycles: bool = False,
    drifts: bool | None = False,
) -> Race:
    """Return a race of one population with the scores of both sides; see `two_teams`."""
    a = own(n, draws)
    d = -draws.size(takes, 1.7 * takes) * a if given is None else given(n, draws)
    scores = a[:, None] + d
    if styles is not None:
        one, other = styles(n, draws, sides=1)
        scores += draws.size(0.1, 0.4) * (one @ other.T)
    first = _clipped(scores)
    return Race(first, first.T, cycles, drifts)


def _clipped(scores: FloatArray) -> FloatArray:
    return np.clip(0.5 + scores, 0.0, 1.0)


CHANCE: Mapping[str, Mapping[str, Course]] = {
    "no change": {},
    "fluctuation": {"own": fluctuation, "given": fluctuation},
    "random walks": {"own": walk, "given": walk},
    "jumps": {"own": jump, "given": jump},
}
_TRADE = {"own": small_rise, "given": None, "takes": 1.2, "drifts": True}
_BOTH_RISE = {"own": small_rise, "given": small_rise, "drifts": True}
_RETURN, _PENNIES = {"styles": returns, "cycles": True}, {"signs": (1.0, -1.0)}
_HALF, _ON = {"styles": half_turn, "drifts": None}, {"styles": line, "drifts": None}
OPTIONS: Mapping[str, Mapping[str, Mapping[str, Any]]] = {
    TWO: {
        "constant sum": {"own": rise, "given": None, "takes": 1.0, "drifts": True},
        "common interest": _BOTH_RISE,
        "dilemma": _TRADE,
        "escalation": {"own": small_fall, "given": small_fall},
        **CHANCE,
        "regress": {"own": regress, "drifts": None},
        "coordination, styles return": _RETURN,
        "pennies, styles return": {**_RETURN, **_PENNIES},
        "rise, styles return": {**_BOTH_RISE, **_RETURN},
        "styles go on": _ON,
        "pennies, half a turn": {**_HALF, **_PENNIES},
        "new styles": {"styles": new},
    },
    ONE: {
        "rise": {"own": rise, "drifts": True},
        **{name: {"own": courses.get("own", still)} for name, courses in CHANCE.items()},
        "regress": {"own": regress, "drifts": None},
        "styles return": _RETURN,
        "rise, styles return": {"own": rise, "drifts": True, **_RETURN},
        "half a turn": _HALF,
        "new styles": {"styles": new},
    },
    ONE_GENERAL: {
        "common interest": _BOTH_RISE,
        "dilemma": _TRADE,
        **CHANCE,
        "regress": {"own": regress, "drifts": None},
        "styles return": _RETURN,
        "rise, styles return": {**_BOTH_RISE, **_RETURN},
        "styles go on": _ON,
        "half a turn": _HALF,
        "new styles": {"styles": new},
    },
}
"""Options of each family of races, by game and name."""
MAKE: Mapping[str, Callable[..., Race]] = {
    TWO: two_teams,
    ONE: one_constant,
    ONE_GENERAL: one_general,
}


# ---- Matches -------------------------------------------------------------------------------------


class Setting(NamedTuple):
    """How a group of races is played; see `SETTINGS`."""

    generations: str
    runs: str
    episodes: str
    noise: str


ALL_SETTINGS = tuple(map(Setting._make, product(*SETTINGS.values())))


def drawn(rates: FloatArray, luck: FloatArray, noise: str) -> FloatArray:
    """Return scores (n, n, episodes) with means `rates` (n, n), of uniform luck."""
    means = rates[..., None]
    if noise == "win or loss":
        return (luck < means).astype(float)
    width = np.minimum(0.2, np.minimum(means, 1.0 - means))
    return np.clip(means + width * (1.0 - 2.0 * luck), 0.0, 1.0)


def play(game: str, races: Sequence[Race], setting: Setting, rng: np.random.Generator) -> Payoffs:
    """Return the payoffs of the runs of a group, as the judgement gets to see them."""
    # How the luck of both sides is tied: alike, opposed, or not at all.
    tie = str(rng.choice(("alike", "opposed", "independent")))
    both = [_play_one(game, race, setting, tie, rng) for race in races]
    scores, others = (np.stack(side) for side in zip(*both, strict=True))
    return read_payoffs(
        scores,
        per_episode=True,
        exact=setting.episodes == EXACT,
        teams=TEAMS if game == TWO else ("players", "players"),
        others=None if game == ONE else others,
    )


def _play_one(
    game: str, race: Race, setting: Setting, tie: str, rng: np.random.Generator
) -> tuple[FloatArray, FloatArray]:
    if setting.episodes == EXACT:
        return race.first[..., None], race.second[..., None]
    shape = (*race.first.shape, int(setting.episodes))
    luck = rng.random(shape)
    # What one wins the other loses, if the sum of both scores is always 1.
    opposed = tie == "opposed" or bool(np.allclose(race.first + race.second, 1.0))
    of_second = 1.0 - luck if opposed else luck if tie == "alike" else rng.random(shape)
    if game == TWO:
        return drawn(race.first, luck, setting.noise), drawn(race.second, of_second, setting.noise)
    # A match of g and h is one of h and g.
    upper = np.triu(np.ones(shape[:2], bool), 1)[..., None]
    luck = np.where(upper, luck, of_second.swapaxes(0, 1))
    scores = drawn(race.first, luck, setting.noise)
    if game == ONE:
        lower = upper.swapaxes(0, 1)
        scores = np.where(upper, scores, np.where(lower, 1.0 - scores.swapaxes(0, 1), 0.5))
    return scores, scores.swapaxes(0, 1)


# ---- What is true --------------------------------------------------------------------------------


def change(course: FloatArray) -> float:
    """Return the least-squares slope of a course (n,), times its length ``n - 1``."""
    return float(np.polyfit(np.arange(len(course)), course, 1)[0] * (len(course) - 1))


def joint_course(race: Race) -> FloatArray:
    """Return the mean (n,) of both sides against contemporaries."""
    both = (race.first + race.second) / 2.0
    near = [[both[k, k], both[k, k - 1], both[k - 1, k]] for k in range(1, len(both))]
    return np.array([both[0, 0], *np.mean(near, axis=1)])


def late_drop(scores: FloatArray) -> float:
    """Return the mean drop of the row team below its best ancestors, in the later half."""
    drops = np.maximum.accumulate(scores, axis=0) - scores
    return float(drops[len(drops) // 2 :].mean())


def truths(game: str, races: Sequence[Race]) -> dict[str, bool | None]:
    """Return what is true of the runs of a group, by condition; None is open."""
    found: dict[str, bool | None] = {"cycling": races[0].cycles}
    sides = {"": [race.first for race in races]}
    if game == TWO:
        sides[SECOND] = [race.second.T for race in races]
    for side, scores in sides.items():
        rises = _above([change(each.mean(axis=1)) for each in scores], MARGIN_OF_CHANGE)
        found[f"rise{side}"] = rises
        found[f"forgetting{side}"] = _above(list(map(late_drop, scores)), MARGIN_OF_CHANGE)
        drifts = races[0].drifts
        found[f"progress{side}"] = None if drifts and not rises else drifts
    if game == ONE:
        return found | _truths_of_one(races)
    joint = [change(joint_course(race)) for race in races]
    found["joint rise"] = _above(joint, MARGIN_OF_CHANGE)
    found["joint fall"] = _above([-one for one in joint], MARGIN_OF_CHANGE)
    return found


def _truths_of_one(races: Sequence[Race]) -> dict[str, bool | None]:
    deviations = [
        squared_intransitivity(race.first, np.zeros_like(race.first)).value for race in races
    ]
    circles = _above(deviations, MARGIN_OF_DEVIATION**2)
    boards = [checkerboards(race.first, margin=MARGIN, level=None).share for race in races]
    if circles and min(boards) < LEAST_BOARDS:
        circles = None
    changes = [change(race.first.mean(axis=1)) for race in races]
    moves = _above(_sizes(changes), MARGIN_OF_CHANGE)
    if circles or moves:
        stagnates: bool | None = False
    else:
        is_known = circles is moves is races[0].drifts is False
        stagnates = True if is_known else None
    return {"intransitivity": circles, "stagnation": stagnates}


def _sizes(changes: Sequence[float]) -> list[float]:
    """Return sizes of changes: of each of few runs, else that of their mean, for all of them."""
    if len(changes) <= FEW:
        return list(map(abs, changes))
    return [abs(float(np.mean(changes)))] * len(changes)


def _above(numbers: Sequence[float], margin: float) -> bool | None:
    if len(numbers) > FEW:
        return float(np.mean(numbers)) > margin
    above = {number > margin for number in numbers}
    return above.pop() if len(above) == 1 else None


# ---- Verdicts ------------------------------------------------------------------------------------


def said(finding: Finding, team: str | None = None) -> str:
    """Return a verdict, or what it says of a team."""
    if team is None or finding.verdict != PRESENT:
        return finding.verdict
    return PRESENT if team in finding.teams else CANNOT_TELL


def verdicts(findings: Mapping[str, Finding], conditions: Iterable[str]) -> dict[str, str]:
    """Return what findings say of conditions; ``", second"`` is of the second team."""
    found = {}
    for condition in conditions:
        name = condition.removesuffix(SECOND)
        of_team = TEAMS[name != condition] if name in OF_TEAMS else None
        found[condition] = said(findings[name], of_team)
    return found


def group(game: str, family: str, seed: int, setting: Setting) -> list[Race]:
    """Return the races of a group."""
    of_family = zlib.crc32(f"{game}, {family}".encode()) + seed
    n, options = int(setting.generations), OPTIONS[game][family]
    return [MAKE[game](n, Draws(of_family, run), **options) for run in range(int(setting.runs))]


def judged(
    game: str, family: str, seed: int, setting: Setting, *, compared: bool
) -> Iterator[tuple[str, str, bool, str]]:
    """Yield rules, condition, truth and verdict of a group, where the truth is known."""
    races = group(game, family, seed, setting)
    rng = np.random.default_rng([seed, 3, zlib.crc32(family.encode())])
    payoffs = play(game, races, setting, rng)
    known = {name: true for name, true in truths(game, races).items() if true is not None}
    told = verdicts(judge(payoffs).findings, known)
    for name, true in known.items():
        yield OWN, name, true, told[name]
    if not compared or payoffs.scores is None:
        return
    of_second = [name for name in known if name in (RISE_OF_SECOND, LOSS_OF_SECOND)]
    alone = verdicts(judge(payoffs.scores, per_episode=True).findings, of_second)
    for name in of_second:
        yield SAME, name, known[name], told[name]
        yield CONSTANT, name, known[name], alone[name]


def count(numbers: Sequence[int], seed: int) -> list[Row]:
    """Judge groups of each family, and return counts by family and by each setting alone.

    The numbers of the groups are 0, 1, ...; their settings take turns. Of every second turn, groups
    of two teams with several episodes are judged by the first team's scores, too.
    """
    counts: Counter[tuple[str, ...]] = Counter()
    families = [(game, family) for game, some in OPTIONS.items() for family in some]
    for number, (game, family) in tqdm(
        list(product(numbers, families)), unit=" groups", disable=None
    ):
        turn, place = divmod(number, len(ALL_SETTINGS))
        setting = ALL_SETTINGS[7 * place % len(ALL_SETTINGS)]  # steps of 7 mix them early
        compared = game == TWO and setting.episodes != EXACT and turn % 2 == 0
        for rules, condition, true, verdict in judged(
            game, family, seed + number, setting, compared=compared
        ):
            values = {"family": family} | (setting._asdict() if rules == OWN else {})
            if setting.episodes == EXACT:
                values.pop("noise", None)
            for by, value in values.items():
                counts[(game, rules, condition, by, value, str(true), verdict)] += 1
    heads = ("game", "rules", "condition", "by", "value", "truth")
    return [
        dict(zip(heads, key, strict=True))
        | {name: str(counts[(*key, name)]) for name in (PRESENT, ABSENT, CANNOT_TELL)}
        for key in sorted({key[:-1] for key in counts})
    ]


# ---- Tables --------------------------------------------------------------------------------------

CONDITIONS = {
    TWO: (
        "joint rise", "joint fall", "cycling", "progress", f"progress{SECOND}", "rise",
        RISE_OF_SECOND, "forgetting", LOSS_OF_SECOND,
    ),
    ONE: ("intransitivity", "cycling", "progress", "rise", "forgetting", "stagnation"),
    ONE_GENERAL: ("joint rise", "joint fall", "cycling", "progress", "rise", "forgetting"),
}  # fmt: skip
HEADS = ("has it not: groups", "false presents", "has it: groups", "false absents", "found")


def share(some: int, of: int) -> str:
    """Return a rate in percent with its 95 % interval (Clopper and Pearson 1934)."""
    if not of:
        return "-"
    low = float(beta.ppf(0.025, some, of - some + 1)) if some else 0.0
    high = float(beta.ppf(0.975, some + 1, of - some)) if some < of else 1.0
    return f"{some / of:.1%} ({100 * low:.1f} to {100 * high:.1f})"


def cells(rows: Iterable[Row], **wanted: str) -> list[str]:
    """Return the cells below `HEADS`."""
    rows = list(rows)
    untrue, true = (totals(rows, truth=truth, **wanted) for truth in ("False", "True"))
    lacks, has = sum(untrue.values()), sum(true.values())
    return [
        str(lacks), share(untrue[PRESENT], lacks), str(has), share(true[ABSENT], has),
        share(true[PRESENT], has),
    ]  # fmt: skip


def report(rows: Sequence[Row]) -> str:
    """Return all tables from the counts."""
    own = [row for row in rows if row["rules"] == OWN]
    parts = [INTRODUCTION, "## All families"]
    for game, conditions in CONDITIONS.items():
        table = [[name, *cells(own, game=game, condition=name, by="family")] for name in conditions]
        parts += [f"### {game[0].upper()}{game[1:]}", markdown(("condition", *HEADS), table)]
    parts += ["## By the scores of the first team alone", ALONE, _alone(rows)]
    parts += [f"## Families with more than {ALLOWED:.0%} false presents or absents", _worst(own)]
    parts += ["## By setting, one at a time", SETTING]
    for game in CONDITIONS:
        parts += [f"### {game[0].upper()}{game[1:]}, by setting", _by_setting(own, game)]
    parts += ["## By family"]
    for game in CONDITIONS:
        parts += [f"### {game[0].upper()}{game[1:]}, by family", _by_family(own, game)]
    return "\n\n".join(parts) + "\n"


ALLOWED = 0.05
INTRODUCTION = (
    "# Errors in games with the scores of both teams, and of one population\n\n"
    'A *false present* is the verdict "present" on a group of races that does not have the '
    'condition, a *false absent* the verdict "absent" on one that has it; the rest is found, or '
    '"cannot tell". Rates of groups whose truth is known, with 95 % intervals (Clopper and '
    "Pearson), over the whole race. Families and truths are defined in "
    "`evolution/validation/general_sum.py`; `counts.csv` holds the counts. A group is 1, 3 or 8 "
    "runs of 12 or 30 generations with 4 or 10 episodes a pair, or exact scores."
)
ALONE = (
    "The same races of two teams, judged by their own rules, and as if the second team lost what "
    "the first one wins. In a game with constant sums both see the same."
)
SETTING = (
    "False presents of groups that do not have the condition / found of those that have it, in %."
)


def _alone(rows: Sequence[Row]) -> str:
    found = []
    for name, family in product((RISE_OF_SECOND, LOSS_OF_SECOND), ("all", *OPTIONS[TWO])):
        of = {"condition": name} | ({} if family == "all" else {"value": family})
        alone, own = (cells(rows, rules=rules, **of) for rules in (CONSTANT, SAME))
        found.append([name, family, *alone[:2], own[1], *alone[2:4], own[3]])
    heads = (
        "condition", "family", "has it not: groups", "false presents", "own rules",
        "has it: groups", "false absents", "own rules",
    )  # fmt: skip
    return markdown(heads, found)


def _worst(rows: Sequence[Row]) -> str:
    found = []
    for game, conditions in CONDITIONS.items():
        for name, family in product(conditions, OPTIONS[game]):
            of = {"game": game, "condition": name, "by": "family", "value": family}
            untrue, true = (totals(rows, truth=truth, **of) for truth in ("False", "True"))
            rates = (untrue[PRESENT], sum(untrue.values())), (true[ABSENT], sum(true.values()))
            if any(wrong > ALLOWED * groups for wrong, groups in rates):
                found.append([game, name, family, *cells(rows, **of)])
    return markdown(("game", "condition", "family", *HEADS), found) if found else "None."


def _by_setting(rows: Sequence[Row], game: str) -> str:
    conditions = CONDITIONS[game]
    found = [
        [by, value, *(_both(rows, game=game, by=by, value=value, condition=c) for c in conditions)]
        for by, values in SETTINGS.items()
        for value in values
    ]
    return markdown(("setting", "value", *conditions), found)


def _both(rows: Sequence[Row], **of: str) -> str:
    parts = []
    for truth in ("False", "True"):
        counts = totals(rows, truth=truth, **of)
        groups = sum(counts.values())
        parts.append(f"{100 * counts[PRESENT] / groups:.0f}" if groups else "-")
    return " / ".join(parts)


def _by_family(rows: Sequence[Row], game: str) -> str:
    found = [
        [name, family, *cells(rows, game=game, condition=name, by="family", value=family)]
        for name, family in product(CONDITIONS[game], OPTIONS[game])
    ]
    return markdown(("condition", "family", *HEADS), found)


def report_of(results: Path) -> str:
    """Return the tables that follow from the counts in a directory."""
    return report(read_counts(results / "counts.csv"))


def main() -> None:
    """Judge all groups, and write counts and tables."""
    parser = script_parser(__doc__, quick=f"{QUICK_RACES} groups of each family")
    parser.add_argument("--races", type=int, help=f"groups of each family; default {RACES}")
    parser.add_argument("--seed", type=int, default=SEED, help=f"default {SEED}")
    told = "the same as --results"
    parser.add_argument("--out", dest="results", type=Path, default=argparse.SUPPRESS, help=told)
    args = parser.parse_args()
    races = args.races or (QUICK_RACES if args.quick else RACES)
    args.results.mkdir(parents=True, exist_ok=True)
    write_counts(count(range(races), args.seed), args.results / "counts.csv")
    text = report_of(args.results)
    (args.results / "table.md").write_text(text, encoding="utf-8")
    print(text)
    print(f"Written: {args.results}/counts.csv, table.md")


if __name__ == "__main__":
    main()
