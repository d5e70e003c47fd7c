"""Which schedule converges if learning is perfect? Exact best responses, then poorer learners.

    python evolution/perfect_learners.py             30 worlds, three minutes of one core
    python evolution/perfect_learners.py --quick     four small worlds, some seconds

`convergence.py` compares schedules by one learner in one world. Here the learner is the exact best
response to the mixture of past opponents that a schedule says (`tabular.py`), in 30 solved worlds;
then it is degraded step by step. In half of the worlds agents or teams take turns, in the other
half all move at once. Each generation has one response of each team; the first tables are drawn by
chance, the same ones for all schedules and learners of a world. Numbers are kept by world; an
interrupted script goes on.

What is measured, claimed and tested was fixed before the worlds were played:
results/perfect_learners/registered.md.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from functools import partial
from itertools import combinations
from typing import Any

import numpy as np
from matplotlib.figure import Figure
from numpy.typing import NDArray
from scipy import stats
from tqdm import tqdm

import common
from matrixworld.plots import save_figure
from tabular import (
    CHOICES,
    GENERALISTS,
    LEARNERS,
    SCHEDULES,
    SPECIALISTS,
    WORLDS,
    Floats,
    Game,
    Race,
    config_of,
)

QUICK_WORLDS = 4
HORIZONS = {False: (1, 8, 32), True: (1, 2, 4)}
"""Generations after which all choices are measured: full length, or with ``--quick``."""
FIRST_SEED = 1000
"""The seed of the first tables of the first world; seeds below were played before."""
LEVELS = (0.01, 0.05)
"""What counts as perfect, strictly and loosely."""
MARGINS = (0.02, 0.05)
"""Which differences matter."""
PSRO, HALL, PERFECT = "PSRO, Nash", "hall of fame", "perfect"
ROOM = 0.05
"""How far the least NashConv of tables must be below 1, so that newest generations can differ."""
KINDS = {"in turns": ("newest",), "at once": CHOICES}
"""Kinds of worlds, and whose NashConv is tested there."""
DRAWS = 200
"""Sets of simulated numbers from which error rates are computed."""


def watched(generations: int) -> list[int]:
    """Return after which generations the newest are measured: eight, then each fourth."""
    return [k for k in range(generations + 1) if k <= 8 or k % 4 == 0]


def measured(world: str, quick: bool) -> dict[str, Any]:
    """Return the numbers of all races in a world."""
    game, seed, horizons = Game(config_of(world)), WORLDS.index(world), HORIZONS[quick]
    captures, concedes = game.of_tables
    found: dict[str, Any] = {
        "world": world, "together": game.together, "states": game.states.total,
        "value": game.value, "pursuers": captures, "evaders": concedes,
        "watched": watched(horizons[-1]), "horizons": horizons,
    }  # fmt: skip
    for learner, learns in LEARNERS.items():
        for schedule, meets in SCHEDULES.items():
            race = Race(game, meets, learns, FIRST_SEED + seed)
            curve, told = [race.nash_conv()], []
            for generation in range(1, horizons[-1] + 1):
                race.go()
                if generation in found["watched"]:
                    curve.append(race.nash_conv())
                if generation in horizons:
                    told.append([race.nash_convs(choice) for choice in CHOICES])
            kind = f"{learner}; {schedule}"
            found[f"{kind} / curve"] = np.round(curve, 4).tolist()
            for place, choice in enumerate(CHOICES):
                found[f"{kind} / {choice}"] = np.round([at[place] for at in told], 4).tolist()
    return found


def stacked(of_worlds: list[dict[str, Any]]) -> dict[str, NDArray[Any]]:
    """Return the numbers of all worlds by name; the first axis is that of the worlds."""
    return {name: np.array([each[name] for each in of_worlds]) for name in of_worlds[0]}


# What is said

Ends = Mapping[str, Floats]
"""By schedule, one number for each world (worlds,)."""
Row = tuple[str, str, str]
"""A kind of world, a choice, and a learner."""


def of_kind(numbers: common.Numbers, kind: str, choice: str = "") -> NDArray[np.bool_]:
    """Return which worlds of a kind count for a choice: those with `ROOM` for the newest."""
    found = numbers["together"] == (kind == "at once")
    if choice == "newest":
        found &= numbers["evaders"] - numbers["pursuers"] <= 1.0 - ROOM
    return np.asarray(found)


def bounds(numbers: common.Numbers, kind: str, choice: str) -> Floats:
    """Return the least NashConv of a choice: of tables, what it is worth to move second."""
    least = numbers["evaders"] - numbers["pursuers"] if choice == "newest" else 0 * numbers["value"]
    return np.asarray(least[of_kind(numbers, kind, choice)])


def ends(numbers: common.Numbers, learner: str, kind: str, choice: str, horizon: int = -1) -> Ends:
    """Return the NashConv above its least value at a horizon, by schedule."""
    least, worlds = bounds(numbers, kind, choice), of_kind(numbers, kind, choice)
    return {
        schedule: numbers[f"{learner}; {schedule} / {choice}"][worlds, horizon, 0] - least
        for schedule in SCHEDULES
    }


def rows_of(numbers: common.Numbers, horizon: int = -1) -> dict[Row, Ends]:
    """Return all comparisons of schedules at a horizon."""
    return {
        (kind, choice, learner): ends(numbers, learner, kind, choice, horizon)
        for kind, choices in KINDS.items()
        for choice in choices
        for learner in LEARNERS
    }


def friedman(found: Ends) -> float:
    """Return the p-value that schedules do not differ, over worlds; 1 if none does anywhere."""
    rows = np.round(np.stack([*found.values()]), 4)
    if len(rows[0]) < 2 or (np.ptp(rows, axis=0) == 0.0).all():
        return 1.0
    return float(stats.friedmanchisquare(*rows).pvalue)


def spread(found: Ends) -> float:
    """Return how far the means of two schedules are apart at most."""
    return float(np.ptp([each.mean() for each in found.values()]))


def farthest(differences: Floats) -> float:
    """Return the end farthest from 0 of the 95 % intervals (Student's t) of means (..., worlds)."""
    count = differences.shape[-1]
    if count < 2:
        return np.inf
    half = stats.t.ppf(0.975, count - 1) * differences.std(axis=-1, ddof=1) / np.sqrt(count)
    return float((abs(differences.mean(axis=-1)) + half).max())


def verdict(found: Ends, p: float, margin: float) -> str:
    """Return whether schedules matter, by the adjusted p-value and all differences of pairs."""
    if p < common.SIGNIFICANCE and spread(found) >= margin:
        return "matter"
    pairs = np.stack([a - b for a, b in combinations(found.values(), 2)])
    return "do not matter" if farthest(pairs) < margin else "cannot tell"


def verdicts(rows: Mapping[Row, Ends]) -> dict[Row, tuple[float, tuple[str, ...]]]:
    """Return the p-value of each comparison, adjusted for all, and the verdict at each margin."""
    adjusted = common.holm([friedman(each) for each in rows.values()])
    return {
        row: (float(p), tuple(verdict(each, p, margin) for margin in MARGINS))
        for (row, each), p in zip(rows.items(), adjusted, strict=True)
    }


def settles(curves: Floats, generations: NDArray[np.int64], level: float) -> Floats:
    """Return from which of some generations on each curve stays close; NaN if it ends far."""
    far = curves > level
    first = curves.shape[1] - far[:, ::-1].argmax(axis=1)  # after the last one that is far
    first = np.where(far.any(axis=1), first, 0)
    return np.where(far[:, -1], np.nan, generations[np.minimum(first, len(generations) - 1)])


# How often the rules are wrong


def without_difference(rows: Mapping[Row, Ends]) -> Iterator[dict[Row, Ends]]:
    """Yield numbers whose schedules are exchanged by chance within each world: none matters."""
    rng = np.random.default_rng(0)
    for _ in range(DRAWS):
        order = {
            row[:2]: rng.permuted(np.tile(np.arange(len(SCHEDULES)), (len(worlds), 1)), axis=1).T
            for row, each in rows.items()
            for worlds in [each[SPECIALISTS]]
        }
        exchanged = {
            row: np.take_along_axis(np.stack([*each.values()]), order[row[:2]], axis=0)
            for row, each in rows.items()
        }
        yield {row: dict(zip(SCHEDULES, each, strict=True)) for row, each in exchanged.items()}


def with_difference(found: Ends, margin: float) -> Iterator[Ends]:
    """Yield worlds drawn anew from those in which two schedules differ by a margin on average."""
    rng = np.random.default_rng(0)
    centred = np.stack([each - each.mean() for each in found.values()])
    centred[0] += margin
    for _ in range(DRAWS):
        drawn = centred[:, rng.integers(centred.shape[1], size=centred.shape[1])]
        yield dict(zip(SCHEDULES, drawn, strict=True))


def table_of_errors(numbers: common.Numbers) -> str:
    """Return how often each verdict is given though it is wrong."""
    rows = rows_of(numbers)
    false = np.zeros(len(MARGINS))
    for simulated in without_difference(rows):
        said = np.array([each for _, each in verdicts(simulated).values()])
        false += (said == "matter").any(axis=0)
    lines = []
    for place, margin in enumerate(MARGINS):
        missed = [
            np.mean([verdict(each, 1.0, margin) == "do not matter"
                     for each in with_difference(found, margin)])
            for found in rows.values()
            if spread(found) > 0.0
        ]  # fmt: skip
        lines.append([
            str(margin), f"{false[place] / DRAWS:.3f}",
            f"{np.mean(missed):.3f}; {np.max(missed):.3f}",
        ])  # fmt: skip
    heads = ["margin", "any \"matter\" of all comparisons, if none does",
             "\"do not matter\" if two differ by the margin: mean; worst comparison"]  # fmt: skip
    return common.markdown(heads, lines)


# Tables


def counts(values: Floats, level: float) -> str:
    """Return in how many worlds a number is at most some level."""
    return f"{(values <= level + 1e-6).sum()} of {len(values)}"


def table_of_perfect(numbers: common.Numbers, kind: str) -> str:
    """Return what each schedule of the perfect learner comes to."""
    worlds, marks = of_kind(numbers, kind, "newest"), numbers["horizons"][0]
    mixed = CHOICES[1:]
    tested = {
        (schedule, choice): found[schedule] - found[SPECIALISTS]
        for choice in mixed
        for found in [ends(numbers, PERFECT, kind, choice)]
        for schedule in SCHEDULES
        if schedule != SPECIALISTS
    }
    adjusted = common.adjusted(tested)
    rows = []
    for schedule in SCHEDULES:
        least = bounds(numbers, kind, "newest")
        curve = numbers[f"{PERFECT}; {schedule} / curve"][worlds] - least[:, None]
        cells = [schedule, common.mean(ends(numbers, PERFECT, kind, "newest")[schedule])]
        for level in LEVELS:
            at = [ends(numbers, PERFECT, kind, "newest", k)[schedule] for k in (-2, -1)]
            cells.append(", ".join(counts(each, level) for each in at))
        settled = settles(curve, numbers["watched"][0], LEVELS[0])
        cells.append("never" if np.isnan(settled).all() else
                     f"{np.nanmedian(settled):.0f} ({np.nanmax(settled):.0f})")  # fmt: skip
        for choice in mixed:
            cells.append(common.mean(ends(numbers, PERFECT, kind, choice)[schedule]))
            if kind == "at once":
                first = ends(numbers, PERFECT, kind, choice, 0)[schedule]
                fall = first - ends(numbers, PERFECT, kind, choice)[schedule]
                cells.append(common.mean(fall, sign="+"))
                cells.append("-" if schedule == SPECIALISTS else ", ".join([
                    common.mean(tested[schedule, choice], sign="+"),
                    common.shown_p(adjusted[schedule, choice]),
                ]))  # fmt: skip
        rows.append(cells)
    at = f"at {marks[-2]}, {marks[-1]}"
    heads = ["perfect learner", "newest", *(f"newest within {level} {at}" for level in LEVELS),
             f"stays within {LEVELS[0]} from, median (last)"]  # fmt: skip
    for choice in mixed:
        heads.append(choice)
        if kind == "at once":
            heads += [f"fall of the {choice} since 1", f"{choice} minus specialists, Holm"]
    return common.markdown(heads, rows)


def table_of_ladder(numbers: common.Numbers, kind: str, choice: str) -> str:
    """Return the mean by learner and schedule, and whether schedules matter at both horizons."""
    marks = numbers["horizons"][0]
    told = {k: verdicts(rows_of(numbers, k)) for k in (-1, -2)}
    lines = []
    for learner in LEARNERS:
        found = ends(numbers, learner, kind, choice)
        row = (kind, choice, learner)
        said = [" / ".join(told[k][row][1]) for k in (-1, -2)]
        lines.append([
            learner, *(f"{each.mean():.3f}" for each in found.values()), f"{spread(found):.3f}",
            common.shown_p(told[-1][row][0]), f"**{said[0]}**", said[1],
        ])  # fmt: skip
    margins = " / ".join(map(str, MARGINS))
    heads = ["learner", *SCHEDULES, "largest difference", "Friedman, Holm",
             f"schedules, margin {margins}", f"at {marks[-2]}"]  # fmt: skip
    return common.markdown(heads, lines)


def table_of_paths(numbers: common.Numbers, kind: str, choice: str) -> str:
    """Return how much of the NashConv is lost in states that were met."""
    lines, parts = [], {}
    for learner in LEARNERS:
        parts[learner] = np.mean([
            numbers[f"{learner}; {schedule} / {choice}"][of_kind(numbers, kind), -1]
            for schedule in SCHEDULES
        ], axis=0).T  # fmt: skip
    adjusted = common.adjusted({each: total - same for each, (total, _, same) in parts.items()})
    for learner, (total, against_any, same) in parts.items():
        cells = [common.mean(each) for each in (total, against_any, same)]
        cells += [common.mean(total - against_any, sign="+"), ", ".join([
            common.mean(total - same, sign="+"), common.shown_p(adjusted[learner])
        ]), common.mean(2 * same - total, sign="+")]  # fmt: skip
        lines.append([learner, *cells])
    met = f"met against the {choice}"
    heads = ["learner, mean of schedules", "NashConv", "met against any opponent", met,
             "not met against any", f"not {met}, Holm", f"{met} minus not"]  # fmt: skip
    return common.markdown(heads, lines)


def forgot(numbers: common.Numbers, kind: str, learner: str, schedule: str) -> tuple[int, int]:
    """Return how many races that came close to the best ended far, and how many came close."""
    curves = numbers[f"{learner}; {schedule} / curve"][of_kind(numbers, kind, "newest")]
    curves = curves - bounds(numbers, kind, "newest")[:, None]
    found = curves.min(axis=1) <= LEVELS[0] + 1e-6
    return int((found & (curves[:, -1] > LEVELS[1])).sum()), int(found.sum())


def forgotten(numbers: common.Numbers, kind: str, learner: str) -> list[int]:
    """Return the same of all schedules together."""
    return np.sum([forgot(numbers, kind, learner, each) for each in SCHEDULES], axis=0).tolist()


def table_of_forgetting(numbers: common.Numbers) -> str:
    """Return in how many races the newest generations were close to the best, and ended far."""
    lines = [
        [kind, learner, *(
            "{} of {}".format(*forgot(numbers, kind, learner, each)) for each in SCHEDULES
        )]
        for kind in KINDS
        for learner in LEARNERS
    ]  # fmt: skip
    return common.markdown(["worlds", "learner", *SCHEDULES], lines)


def summary(numbers: common.Numbers) -> str:
    """Return the end of a perfect learner in few columns, for the page."""
    lines = []
    for schedule in SCHEDULES:
        turns, once, average, mixture = (
            ends(numbers, PERFECT, kind, choice)[schedule]
            for kind, choices in KINDS.items()
            for choice in choices
        )
        cells = (counts(turns, LEVELS[0]), counts(once, LEVELS[0]))
        lines.append([schedule, *cells, common.mean(average), common.mean(mixture)])
    heads = ["perfect learner", "in turns, newest: perfect in", "at once, newest: at the bound in",
             "at once, average: NashConv", "at once, mixture: NashConv"]  # fmt: skip
    return common.markdown(heads, lines)


def summary_of_verdicts(numbers: common.Numbers) -> str:
    """Return for which learners schedules matter, for the page: differences, and verdicts."""
    rows = rows_of(numbers)
    told = verdicts(rows)
    panels = list(dict.fromkeys(row[:2] for row in rows))
    lines = [
        [learner, *(
            f"{spread(rows[(*panel, learner)]):.2f}: {' / '.join(told[(*panel, learner)][1])}"
            for panel in panels
        )]
        for learner in LEARNERS
    ]  # fmt: skip
    return common.markdown(["learner", *map(", ".join, panels)], lines)


def table_of_worlds(numbers: common.Numbers) -> str:
    """Return all worlds in the order in which they were played."""
    names = ("value", "pursuers", "evaders")
    rows = [
        [world, f"{states:,}", *(f"{each:.3f}" for each in of_world)]
        for world, states, *of_world in zip(
            numbers["world"], numbers["states"], *(numbers[name] for name in names), strict=True
        )
    ]
    heads = ["world", "states", "value", "best table of the pursuers", "of the evaders"]
    return common.markdown(heads, rows)


def table(numbers: common.Numbers) -> str:
    """Return all tables in Markdown."""
    last = numbers["horizons"][0, -1]
    parts = [
        f"NashConv after {last} generations, of newest generations minus the least NashConv of "
        "tables; means over worlds, with 95 % intervals (Student's t) in brackets."
    ]
    for kind, choices in KINDS.items():
        parts += [
            f"### {int(of_kind(numbers, kind).sum())} worlds {kind}: a perfect learner",
            f"Newest generations: {int(of_kind(numbers, kind, 'newest').sum())} worlds in which "
            f"tables can have a NashConv below {1 - ROOM}.",
            table_of_perfect(numbers, kind),
        ]
        for choice in choices:
            parts += [
                f"### Worlds {kind}, learners from perfect to poor: {choice}",
                table_of_ladder(numbers, kind, choice),
            ]
        parts += [
            f"### Worlds {kind}: where the {choices[-1]} loses",
            "What is left of the NashConv if a team keeps its play only in states that it meets, "
            "and plays as well as it can in all others. Nothing is subtracted here.",
            table_of_paths(numbers, kind, choices[-1]),
        ]
    parts += [
        "### Found and forgotten",
        f"Races whose newest generations came within {LEVELS[0]} of the least NashConv of tables, "
        f"and those of them that ended above {LEVELS[1]}.",
        table_of_forgetting(numbers),
        "### How often the verdicts on schedules are wrong",
        f"{DRAWS} simulated sets. For *matter*, schedules are exchanged by chance within each "
        "world. For *do not matter*, one schedule differs from all others by the margin on "
        "average, and worlds are drawn anew.",
        table_of_errors(numbers),
        "### Worlds",
        "Capture rates: of perfect play, and what the best tables guarantee.",
        table_of_worlds(numbers),
    ]
    return "\n\n".join(parts)


# Figure

MARKS = {
    SPECIALISTS: ("black", "s"), "specialists that retain": ("0.55", "s"),
    GENERALISTS: ("tab:blue", "o"), "generalists v specialists": ("0.55", "o"),
    HALL: ("tab:cyan", "^"), PSRO: ("tab:orange", "D"),
}  # fmt: skip


def figure(numbers: common.Numbers) -> Figure:
    """Draw the mean NashConv of each schedule, by learner."""
    panels = [(kind, choice) for kind, choices in KINDS.items() for choice in choices]
    found = Figure(figsize=(12, 4), layout="constrained")
    axes = found.subplots(1, len(panels), sharey=True)
    told = verdicts(rows_of(numbers))
    places = np.arange(len(LEARNERS))
    for axis, (kind, choice) in zip(axes, panels, strict=True):
        for side, (schedule, (color, marker)) in enumerate(MARKS.items()):
            means = [ends(numbers, each, kind, choice)[schedule].mean() for each in LEARNERS]
            at = places + 0.13 * (side - (len(MARKS) - 1) / 2)
            axis.plot(at, means, marker, markersize=5, color=color, label=schedule)
        for place, learner in enumerate(LEARNERS):
            if told[kind, choice, learner][1][-1] == "matter":
                axis.axvspan(place - 0.5, place + 0.5, color="0.93", zorder=0, linewidth=0)
        count = int(of_kind(numbers, kind, choice).sum())
        least = " minus bound" if (kind, choice) == ("at once", "newest") else ""
        axis.set_title(f"{count} worlds {kind}:\n{choice}{least}", fontsize=10)
        axis.set_xticks(places, [*LEARNERS], rotation=45, ha="right", fontsize=8)
        axis.set(ylim=(-0.02, 1.0))
        axis.spines[["top", "right"]].set_visible(False)
    axes[0].set_ylabel("NashConv (0: perfect play)")
    axes[0].plot([], [], color="0.88", linewidth=8, label=f"differ by {MARGINS[-1]} or more")
    handles, labels = axes[0].get_legend_handles_labels()
    found.legend(handles, labels, frameon=False, fontsize=8, loc="outside right center")
    return found


def play_worlds(
    doc: str | None,
    measure: Callable[[str, bool], dict[str, Any]],
    table: Callable[[common.Numbers], str],
    draw: Callable[[common.Numbers], Figure],
) -> None:
    """Play all worlds; write numbers, tables and figure of those that are finished.

    `measure` takes the name of a world and whether ``--quick`` is given. Numbers are kept by world.
    """
    told = "four worlds and few generations, some seconds"
    parser = common.script_parser(doc, quick=told, runs=True)
    parser.add_argument("--worlds", type=int, default=len(WORLDS), help="how many, in their order")
    args = parser.parse_args()
    if args.worlds < 2:  # one of each kind
        parser.error(f"argument --worlds: expected at least 2, got {args.worlds}")
    worlds = WORLDS[: QUICK_WORLDS if args.quick else None][: args.worlds]
    kept = [
        common.kept(args.runs / f"{place}.json", partial(measure, world, args.quick))
        for place, world in enumerate(tqdm(worlds, unit=" worlds", disable=None))
    ]
    common.write(args.results, stacked(kept), table)
    save_figure(draw(dict(np.load(args.results / "numbers.npz"))), args.results / "figure.png")


if __name__ == "__main__":
    play_worlds(__doc__, measured, table, figure)
