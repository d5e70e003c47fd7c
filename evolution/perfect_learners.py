"""Which schedule converges if learning is perfect? Exact best responses, then poorer learners.

    python evolution/perfect_learners.py             30 worlds, twenty minutes of one core
    python evolution/perfect_learners.py --quick     four small worlds, some seconds

`convergence.py` compares schedules by one learner in one world. Here the learner is the exact best
response to the mixture of past opponents that a schedule says (`tabular.py`), in 30 solved worlds;
then it is degraded step by step. In half of the worlds agents or teams take turns, in the other
half all move at once, and to move second is worth at least .02. Worlds are drawn by chance (seed
66; trials were in worlds of seed 65), and played in this order: whatever is finished is a fair
sample. Each generation has one response of each team; the first tables are drawn by chance, the
same ones for all schedules and learners of a world. Numbers are kept by world; an interrupted
script goes on. Two earlier starts, with larger worlds, were stopped for time, unseen.

The *NashConv* of a pair is what the best responses of both teams gain, exactly: 0 is perfect play.
It is told of the newest generations; of those *chosen*, with the highest mean score in the matrix
of the race; of the *average* of all generations; and of the *mixture*, the equilibrium of the
matrix. Averages and mixtures draw a generation in every turn anew. Where all move at once no
single generation guarantees anything: there the unit is the mixture, else the newest generation.

Decided before the worlds were played, of the NashConv of the unit after 64 generations:

1.  A perfect learner converges in turns under each schedule: at most .01 in each world. Proof for
    specialists: a generation that answers in all states plays one turn more, from the end,
    perfectly. The others are measured.
2.  Where all move at once, no schedule of a perfect learner converges by its newest generation, and
    mixtures of PSRO are closer to perfect than those of specialists.
3.  Schedules *matter* for a learner if Friedman's test over the worlds (blocks) tells the seven
    schedules apart, p < .05 after Holm's adjustment for all learners and both kinds of worlds, and
    the means of two schedules differ by .05 or more. They *do not matter* if all differences of
    pairs of schedules have 95 % intervals within .05. Else the table says: cannot tell.
4.  A race *forgets* if its newest generation was within .01 of perfect play and ends above .05.

Worlds are the units of all tests and intervals (Student's t).
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import partial
from itertools import combinations
from typing import Any

import numpy as np
from matplotlib.figure import Figure
from numpy.typing import NDArray
from scipy import stats
from tqdm import tqdm

import common
from matrixworld.analysis import interval_over_runs
from matrixworld.plots import save_figure
from tabular import (
    CHOICES,
    GENERALISTS,
    LEARNERS,
    SCHEDULES,
    SPECIALISTS,
    WORLDS,
    Game,
    Race,
    config_of,
)

QUICK_WORLDS = 4
GENERATIONS = {False: 64, True: 4}
"""Full length, or with ``--quick``."""
CLOSE, FAR, MARGIN = 0.01, 0.05, 0.05
PSRO, RETAIN, PERFECT = "PSRO, Nash", "specialists that retain", "perfect"
KINDS = {"in turns": "newest", "at once": "mixture"}
"""Kinds of worlds, and whose NashConv is the unit there."""


def watched(generations: int) -> list[int]:
    """Return after which generations the newest are measured: eight, then each fourth."""
    return [k for k in range(generations + 1) if k <= 8 or k % 4 == 0]


def told_at(generations: int) -> list[int]:
    """Return the generations after which all choices are measured: powers of two."""
    return [2**k for k in range(generations.bit_length()) if 2**k <= generations]


def measured(world: str, quick: bool) -> dict[str, Any]:
    """Return the numbers of all races in a world."""
    game, seed, generations = Game(config_of(world)), WORLDS.index(world), GENERATIONS[quick]
    found: dict[str, Any] = {
        "world": world, "together": game.together, "value": game.value,
        "mixing": game.mixing, "states": game.states.total,
        "watched": watched(generations),
    }  # fmt: skip
    for learner, learns in LEARNERS.items():
        for schedule, meets in SCHEDULES.items():
            race = Race(game, meets, learns, seed)
            newest, told = [race.nash_conv()], []
            for generation in range(1, generations + 1):
                race.go()
                if generation in watched(generations):
                    newest.append(race.nash_conv())
                if generation in told_at(generations):
                    told.append({choice: race.nash_conv(choice) for choice in CHOICES[1:]})
            kind = f"{learner}; {schedule}"
            found[f"{kind} / newest"] = np.round(newest, 6).tolist()
            for choice in CHOICES[1:]:
                found[f"{kind} / {choice}"] = [round(each[choice], 6) for each in told]
    return found


def stacked(of_worlds: list[dict[str, Any]]) -> dict[str, NDArray[Any]]:
    """Return the numbers of all worlds by name; the first axis is that of the worlds."""
    found = {name: np.array([each[name] for each in of_worlds]) for name in of_worlds[0]}
    return {name: np.round(a, 4) if a.dtype == np.float64 else a for name, a in found.items()}


# Tables

Ends = Mapping[str, NDArray[np.float64]]
"""By schedule, the NashConv of the unit at the end (worlds,)."""


def of_kind(numbers: common.Numbers, kind: str) -> NDArray[np.bool_]:
    """Return which worlds are of a kind."""
    return np.asarray(numbers["together"] == (kind == "at once"))


def ends(numbers: common.Numbers, learner: str, kind: str, choice: str = "") -> Ends:
    """Return the NashConv after the last generation, by schedule."""
    chosen, worlds = choice or KINDS[kind], of_kind(numbers, kind)
    return {
        schedule: numbers[f"{learner}; {schedule} / {chosen}"][worlds, -1] for schedule in SCHEDULES
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


def verdict(found: Ends, p: float) -> str:
    """Return whether schedules matter, by the adjusted p-value and all differences of pairs."""
    if p < common.SIGNIFICANCE and spread(found) >= MARGIN:
        return "matter"
    intervals = [interval_over_runs(a - b) for a, b in combinations(found.values(), 2)]
    # Worlds that all agree have no interval: their difference is the same everywhere.
    bounds = [abs(end) for each in intervals for end in (each.low, each.high, each.value)
              if end is not None]  # fmt: skip
    return "do not matter" if max(bounds) < MARGIN else "cannot tell"


def verdicts(numbers: common.Numbers) -> dict[tuple[str, str], tuple[float, float, str]]:
    """Return p-value, spread and verdict by learner and kind of world."""
    found = {
        (learner, kind): ends(numbers, learner, kind) for learner in LEARNERS for kind in KINDS
    }
    adjusted = common.holm([friedman(each) for each in found.values()])
    return {
        key: (float(p), spread(each), verdict(each, float(p)))
        for (key, each), p in zip(found.items(), adjusted, strict=True)
    }


def table_of_ladder(numbers: common.Numbers, kind: str) -> str:
    """Return the mean NashConv of the unit by learner and schedule, and whether these matter."""
    heads = ["learner", *SCHEDULES, "largest difference", "Friedman, Holm", "schedules"]
    rows = []
    for (learner, of), (p, apart, said) in verdicts(numbers).items():
        if of == kind:
            means = [f"{each.mean():.3f}" for each in ends(numbers, learner, kind).values()]
            rows.append([learner, *means, f"{apart:.3f}", common.shown_p(p), f"**{said}**"])
    return common.markdown(heads, rows)


def table_of_perfect(numbers: common.Numbers, kind: str) -> str:
    """Return what each schedule of the perfect learner comes to."""
    worlds = of_kind(numbers, kind)
    differences = {
        (schedule, choice): found[schedule] - found[SPECIALISTS]
        for choice in ("newest", "average", "mixture")
        for found in [ends(numbers, PERFECT, kind, choice)]
        for schedule in SCHEDULES
        if schedule != SPECIALISTS
    }
    adjusted = common.adjusted(differences)
    rows = []
    for schedule in SCHEDULES:
        of_choices = [ends(numbers, PERFECT, kind, choice)[schedule] for choice in CHOICES]
        cells = [schedule, *map(common.mean, of_choices)]
        unit = ends(numbers, PERFECT, kind)[schedule]
        curve = numbers[f"{PERFECT}; {schedule} / newest"][worlds]
        settled = settles(curve, numbers["watched"][0])
        said = "never" if np.isnan(settled).all() else f"{np.nanmedian(settled):.0f}"
        cells += [f"{(unit <= CLOSE).sum()} of {len(unit)}", said]
        key = (schedule, KINDS[kind])
        if key in adjusted:
            told = common.mean(differences[key], sign="+")
            cells.append(f"{told}, {common.shown_p(adjusted[key])}")
        else:
            cells.append("")
        rows.append(cells)
    heads = ["perfect learner", *CHOICES, f"{KINDS[kind]} within .01", "newest settles at",
             f"{KINDS[kind]}, minus specialists; Holm"]  # fmt: skip
    return common.markdown(heads, rows).replace("|  |", "| |")


def settles(curves: NDArray[np.float64], generations: NDArray[np.int64]) -> NDArray[np.float64]:
    """Return from which of some generations on each curve stays close; NaN if it ends far."""
    far = curves > CLOSE
    first = curves.shape[1] - far[:, ::-1].argmax(axis=1)  # after the last one that is far
    first = np.where(far.any(axis=1), first, 0)
    return np.where(far[:, -1], np.nan, generations[np.minimum(first, len(generations) - 1)])


def table_of_forgetting(numbers: common.Numbers) -> str:
    """Return in how many races the newest generations were close to perfect, and ended far."""
    rows = []
    for learner in LEARNERS:
        cells = [learner]
        for schedule in SCHEDULES:
            curve = numbers[f"{learner}; {schedule} / newest"][of_kind(numbers, "in turns")]
            found = curve.min(axis=1) <= CLOSE
            forgot = found & (curve[:, -1] > FAR)
            cells.append(f"{forgot.sum()} of {found.sum()}")
        rows.append(cells)
    return common.markdown(["forgot, of those that found it", *SCHEDULES], rows)


def table_of_progress(numbers: common.Numbers, kind: str) -> str:
    """Return by how much the NashConv of the unit fell since the first response."""
    worlds, unit = of_kind(numbers, kind), KINDS[kind]
    first = 1 if unit == "newest" else 0  # the newest are told of generation 0, too
    falls = {
        (learner, schedule): curve[worlds, first] - curve[worlds, -1]
        for learner in LEARNERS
        for schedule in SCHEDULES
        for curve in [numbers[f"{learner}; {schedule} / {unit}"]]
    }
    adjusted = common.adjusted(falls)
    rows = []
    for learner in LEARNERS:
        cells = [learner]
        for schedule in SCHEDULES:
            fall = falls[learner, schedule]
            told = adjusted[learner, schedule] < common.SIGNIFICANCE
            cells.append(f"{fall.mean():+.3f}" + "\\*" * told)
        rows.append(cells)
    return common.markdown(["learner", *SCHEDULES], rows)


def table_of_worlds(numbers: common.Numbers) -> str:
    """Return all worlds in the order in which they were played."""
    names = ("states", "value", "mixing")
    rows = [
        [world, f"{states:,}", f"{value:.3f}", f"{mixing:.3f}"]
        for world, states, value, mixing in zip(
            numbers["world"], *(numbers[name] for name in names), strict=True
        )
    ]
    return common.markdown(["world", "states", "value", "worth of moving second"], rows)


def table(numbers: common.Numbers) -> str:
    """Return all tables in Markdown."""
    counts = {kind: int(of_kind(numbers, kind).sum()) for kind in KINDS}
    last = numbers["watched"][0, -1]
    told = "means over worlds, with 95 % intervals in brackets."
    parts = [f"NashConv after {last} generations; {told}"]

    for kind, unit in KINDS.items():
        what = "newest generations" if unit == "newest" else "mixtures of the matrix"
        parts += [
            f"### {counts[kind]} worlds {kind}",
            f"Perfect learner. The last column compares the {what}.",
            table_of_perfect(numbers, kind),
            f"Learners from perfect to poor; NashConv of the {what}.",
            table_of_ladder(numbers, kind),
            f"Fall of it since generation 1, of the {what}; * if told from 0 (Holm, this table).",
            table_of_progress(numbers, kind),
        ]
    parts += [
        "### Found and forgotten",
        "Worlds in turns: races whose newest generations came within .01, and ended above .05.",
        table_of_forgetting(numbers),
        "### Worlds",
        table_of_worlds(numbers),
    ]
    return "\n\n".join(parts)


# Figure

COLORS = {
    SPECIALISTS: "tab:red", RETAIN: "tab:orange", GENERALISTS: "tab:blue", PSRO: "tab:green",
}  # fmt: skip


def figure(numbers: common.Numbers) -> Figure:
    """Draw the mean NashConv of the unit by learner, one line for each schedule."""
    found = Figure(figsize=(10, 4), layout="constrained")
    axes = found.subplots(1, 2, sharey=True)
    told = verdicts(numbers)
    for axis, (kind, unit) in zip(axes, KINDS.items(), strict=True):
        places = np.arange(len(LEARNERS))
        for schedule in SCHEDULES:
            means = [ends(numbers, learner, kind)[schedule].mean() for learner in LEARNERS]
            main = schedule in COLORS
            axis.plot(
                places, means, marker="o", markersize=5 if main else 3,
                color=COLORS.get(schedule, "0.75"), linewidth=2 if main else 1,
                zorder=3 if main else 2, label=schedule if main else None,
            )  # fmt: skip
        for place, learner in enumerate(LEARNERS):
            if told[learner, kind][2] == "matter":
                axis.axvspan(place - 0.5, place + 0.5, color="0.94", zorder=0, linewidth=0)
        count = int(of_kind(numbers, kind).sum())
        what = "newest generation" if unit == "newest" else "mixture of all generations"
        axis.set_title(f"{count} worlds {kind}: {what}", fontsize=10)
        axis.set_xticks(places, [*LEARNERS], rotation=40, ha="right", fontsize=8)
        axis.set(ylim=(-0.02, 1.03))
        axis.spines[["top", "right"]].set_visible(False)
    axes[0].set_ylabel("NashConv (0: perfect play)")
    axes[0].plot([], [], color="0.75", marker="o", markersize=3, label="three other schedules")
    axes[0].plot([], [], color="0.9", linewidth=8, label="here schedules matter")
    axes[0].legend(frameon=False, fontsize=8, loc="lower right")
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
