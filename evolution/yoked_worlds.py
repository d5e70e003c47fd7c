"""Does an arms race need an answering opponent? Races of tables and yoked ones, in 30 worlds.

    python evolution/yoked_worlds.py             30 worlds, two seeds of each race, three minutes
    python evolution/yoked_worlds.py --quick     four small worlds, some seconds

In a yoked race each team meets the opponents of the race of the next seed, in their order: they
change as in a race, but do not answer. `yoked_races.py` finds no difference in one solved world, by
one learner. Here are the 30 worlds of `perfect_learners.py`, whose guarantees are exact, four
learners and two schedules (`tabular.py`). Worlds are played in the order in which they were drawn;
numbers are kept by world, and an interrupted script goes on.

*Answers pay* is how much lower the NashConv of the race is than that of the yoked race with the
same first tables and seed.

What is measured, claimed and tested was fixed before the worlds were played:
results/yoked_worlds/registered.md.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from matplotlib.figure import Figure

import common
from matrixworld.coevolution import Team
from matrixworld.coevolution.types import other
from perfect_learners import DRAWS, FIRST_SEED, KINDS, MARGINS, farthest, of_kind, play_worlds
from tabular import (
    CHOICES,
    GENERALISTS,
    LEARNERS,
    SCHEDULES,
    SPECIALISTS,
    Floats,
    Game,
    Race,
    Table,
    config_of,
)

SEEDS, HORIZONS = 2, {False: (8, 32), True: (2, 4)}
"""Full length, or with ``--quick``."""
LEARNS = ("perfect", "perfect where it plays", "linear rating", "improves what it meets")
MEETS = (SPECIALISTS, GENERALISTS)
RACES = [f"{learner}; {schedule}" for learner in LEARNS for schedule in MEETS]
PARTS = ("all states", "met against any", "met against the same")
"""Where a NashConv is lost: `Race.nash_convs`."""


class YokedRace(Race):
    """A race whose opponents are replayed from another one, generation by generation."""

    def __init__(self, replayed: Race, *race: Any) -> None:
        super().__init__(*race)
        self.replayed = replayed

    def opponents(self, team: Team) -> list[Table]:
        """Return as many generations of the other race as this one has itself."""
        return self.replayed.tables[other(team)][: len(self.tables[other(team)])]


def played(race: Race, horizons: tuple[int, ...]) -> list[Any]:
    """Play a race; return its NashConvs at some horizons: (horizons, choices, parts)."""
    found, before = [], 0
    for horizon in horizons:
        race.run(horizon - before)
        before = horizon
        found.append([np.round(race.nash_convs(choice), 4).tolist() for choice in CHOICES])
    return found


def measured(world: str, quick: bool) -> dict[str, Any]:
    """Return the NashConvs of all races in a world: (seeds, horizons, choices, parts) each."""
    game, horizons = Game(config_of(world)), HORIZONS[quick]
    captures, concedes = game.of_tables
    found: dict[str, Any] = {
        "world": world, "together": game.together, "states": game.states.total,
        "pursuers": captures, "evaders": concedes, "horizons": horizons,
    }  # fmt: skip
    for learner in LEARNS:
        for schedule in MEETS:
            races = [
                Race(game, SCHEDULES[schedule], LEARNERS[learner], FIRST_SEED + seed)
                for seed in range(SEEDS)
            ]
            kind = f"{learner}; {schedule}"
            found[f"{kind} / race"] = [played(race, horizons) for race in races]
            found[f"{kind} / yoked"] = [
                played(
                    YokedRace(replayed, game, race.schedule, race.learner, FIRST_SEED + seed),
                    horizons,
                )
                for seed, (race, replayed) in enumerate(
                    zip(races, [*races[1:], races[0]], strict=True)
                )
            ]
    return found


# What is said

Row = tuple[str, str, str]
"""A kind of worlds, a choice, and a kind of race."""


def means(numbers: common.Numbers, row: Row, name: str, horizon: int, part: int = 0) -> Floats:
    """Return the NashConv of races or yoked ones in each world, means over seeds (worlds,)."""
    kind, choice, race = row
    found = numbers[f"{race} / {name}"][of_kind(numbers, kind, choice)]
    return np.asarray(found[:, :, horizon, CHOICES.index(choice), part].mean(axis=1))


def pay(numbers: common.Numbers, row: Row, horizon: int = -1, part: int = 0) -> Floats:
    """Return how much lower the NashConv of races is than that of yoked ones (worlds,)."""
    yoked, race = (means(numbers, row, name, horizon, part) for name in ("yoked", "race"))
    return np.round(yoked - race, 6)


def rows_of(numbers: common.Numbers, horizon: int = -1) -> dict[Row, Floats]:
    """Return what answers bring, of all comparisons."""
    rows = [(kind, choice, race) for kind, of in KINDS.items() for choice in of for race in RACES]
    return {row: pay(numbers, row, horizon) for row in rows}


def verdict(values: Floats, p: float, margin: float) -> str:
    """Return what answers do, by the mean over worlds, its interval and its adjusted p-value."""
    if p < common.SIGNIFICANCE and abs(values.mean()) >= margin:
        return "pay" if values.mean() > 0.0 else "cost"
    return "alike" if farthest(values) < margin else "cannot tell"


def verdicts(rows: Mapping[Row, Floats]) -> dict[Row, tuple[float, list[str]]]:
    """Return the p-value of each comparison, adjusted for all, and the verdict at each margin."""
    adjusted = common.adjusted(rows)
    return {
        row: (adjusted[row], [verdict(each, adjusted[row], margin) for margin in MARGINS])
        for row, each in rows.items()
    }


def table_of_pay(numbers: common.Numbers, kind: str, choice: str) -> str:
    """Return what answers bring, by learner and schedule."""
    told = {horizon: verdicts(rows_of(numbers, horizon)) for horizon in (-1, -2)}
    lines = []
    for race in RACES:
        row = (kind, choice, race)
        found = pay(numbers, row)
        p, said = told[-1][row]
        several = ", ".join(
            f"{(found > margin).sum()} / {(found < -margin).sum()}" for margin in MARGINS
        )
        lines.append([
            *race.split("; "),
            *(f"{means(numbers, row, name, -1).mean():.3f}" for name in ("race", "yoked")),
            common.mean(found, sign="+"), common.shown_p(p), f"**{' / '.join(said)}**",
            f"{common.mean(pay(numbers, row, -2), sign='+')}: {' / '.join(told[-2][row][1])}",
            several,
        ])  # fmt: skip
    early, _ = numbers["horizons"][0]
    margins = " / ".join(map(str, MARGINS))
    heads = ["learner", "schedule", "NashConv of the race", "of the yoked race", "answers pay",
             "Holm", f"margin {margins}", f"after {early} generations",
             f"worlds in which they pay / cost by {', '.join(map(str, MARGINS))}"]  # fmt: skip
    return common.markdown(heads, lines)


def summary(numbers: common.Numbers) -> str:
    """Return what answers bring, and the verdicts, in few columns, for the page."""
    rows = rows_of(numbers)
    told = verdicts(rows)
    panels = list(dict.fromkeys(row[:2] for row in rows))
    lines = [
        [race.replace("; ", ": "), *(
            f"{common.mean(rows[(*panel, race)], 2, '+')}, {' / '.join(told[(*panel, race)][1])}"
            for panel in panels
        )]
        for race in RACES
    ]  # fmt: skip
    return common.markdown(["learner: schedule", *map(", ".join, panels)], lines)


def counts_of_verdicts(numbers: common.Numbers) -> list[int]:
    """Return in how many comparisons answers pay, are alike, cannot be told; and how many are."""
    said = [each[-1] for _, each in verdicts(rows_of(numbers)).values()]
    return [*(said.count(word) for word in ("pay", "alike", "cannot tell")), len(said)]


def table_of_paths(numbers: common.Numbers, kind: str, choice: str) -> str:
    """Return where answers pay: in states that were met, or elsewhere."""
    rows = [(kind, choice, race) for race in RACES]
    rest = {row: pay(numbers, row) - pay(numbers, row, part=2) for row in rows}
    adjusted = common.adjusted(rest)
    lines = [
        [
            *row[2].split("; "),
            *(common.mean(pay(numbers, row, part=part), sign="+") for part in range(len(PARTS))),
            f"{common.mean(rest[row], sign='+')}, {common.shown_p(adjusted[row])}",
        ]
        for row in rows
    ]
    heads = ["learner", "schedule", *PARTS, "the rest: all minus the last, Holm"]
    return common.markdown(heads, lines)


def table_of_choices(numbers: common.Numbers) -> str:
    """Return by how much more answers pay by the average than by the mixture, at once."""
    average, mixture = (
        {race: pay(numbers, ("at once", choice, race)) for race in RACES} for choice in CHOICES[1:]
    )
    rows = {race: average[race] - mixture[race] for race in RACES}
    adjusted = common.adjusted(rows)
    lines = [
        [*race.split("; "), f"{common.mean(each, sign='+')}, {common.shown_p(adjusted[race])}"]
        for race, each in rows.items()
    ]
    return common.markdown(["learner", "schedule", "average minus mixture, Holm"], lines)


def repeats(numbers: common.Numbers, kind: str, race: str) -> tuple[int, int]:
    """Return in how many worlds yoked races end as the replayed ones do, and of how many."""
    worlds = of_kind(numbers, kind)
    own, yoked = (numbers[f"{race} / {name}"][worlds, :, -1, 0, 0] for name in ("race", "yoked"))
    same = abs(yoked - np.roll(own, -1, axis=1)).max(axis=1) < 0.001
    return int(same.sum()), len(same)


def table_of_repeats(numbers: common.Numbers) -> str:
    """Return the same of all learners and schedules, in both kinds of worlds."""
    lines = [
        [*race.split("; "), *("{} of {}".format(*repeats(numbers, kind, race)) for kind in KINDS)]
        for race in RACES
    ]
    return common.markdown(["learner", "schedule", *KINDS], lines)


def table_of_errors(numbers: common.Numbers) -> str:
    """Return how often each verdict is given though it is wrong."""
    rows, rng = rows_of(numbers), np.random.default_rng(0)
    false, missed = np.zeros(len(MARGINS)), []
    for _ in range(DRAWS):
        signs = {row[:2]: rng.choice([-1.0, 1.0], len(each)) for row, each in rows.items()}
        said = verdicts({row: each * signs[row[:2]] for row, each in rows.items()})
        false += np.isin([each for _, each in said.values()], ["pay", "cost"]).any(axis=0)
    for margin in MARGINS:
        shifted = [each - each.mean() + margin for each in rows.values() if np.ptp(each) > 0.0]
        drawn = [each[rng.integers(len(each), size=(DRAWS, len(each)))] for each in shifted]
        missed.append([np.mean([farthest(one) < margin for one in each]) for each in drawn])
    lines = [
        [str(margin), f"{wrong / DRAWS:.3f}", f"{np.mean(alike):.3f}; {np.max(alike):.3f}"]
        for margin, wrong, alike in zip(MARGINS, false, missed, strict=True)
    ]
    heads = ["margin", 'any "pay" or "cost" of all comparisons, if none does',
             '"alike" if answers pay by the margin: mean; worst comparison']  # fmt: skip
    return common.markdown(heads, lines)


def table(numbers: common.Numbers) -> str:
    """Return all tables in Markdown."""
    seeds, last = numbers[f"{RACES[0]} / race"].shape[1], numbers["horizons"][0, -1]
    parts = [
        f"{seeds} seeds, {last} generations. Answers pay: NashConv of the yoked race minus that of "
        "the race, mean over worlds with its 95 % interval (Student's t)."
    ]
    for kind, choices in KINDS.items():
        for choice in choices:
            count = int(of_kind(numbers, kind, choice).sum())
            parts += [f"### {count} worlds {kind}: {choice}", table_of_pay(numbers, kind, choice)]
        parts += [
            f"### Worlds {kind}: where answers pay, by the {choices[-1]}",
            "What answers bring to teams that keep their play only in states that they meet, and "
            f"play as well as they can in all others: against any opponent, or the {choices[-1]}.",
            table_of_paths(numbers, kind, choices[-1]),
        ]
    parts += [
        "### Worlds at once: average and mixture",
        "By how much more answers pay by the average.",
        table_of_choices(numbers),
        "### Do yoked races repeat the races that they replay?",
        "Worlds in which both end with the same newest NashConv, within 0.001, for all seeds. "
        "Added when the first results were known.",
        table_of_repeats(numbers),
        "### How often the verdicts are wrong",
        f"{DRAWS} simulated sets. For *pay* and *cost*, race and yoked race are exchanged by "
        "chance in each world. For *alike*, the mean is moved to the margin, and worlds are drawn "
        "anew.",
        table_of_errors(numbers),
    ]
    return "\n\n".join(parts)


STYLES = {("in turns", "newest"): ("tab:blue", "o"), ("at once", "average"): ("tab:orange", "s"),
          ("at once", "mixture"): ("black", "^")}  # fmt: skip


def figure(numbers: common.Numbers) -> Figure:
    """Draw what answers bring: one point for each world, by kind of world and of race."""
    found = Figure(figsize=(9, 4), layout="constrained")
    axis = found.subplots()
    rng = np.random.default_rng(0)
    for side, ((kind, choice), (color, marker)) in enumerate(STYLES.items()):
        for place, race in enumerate(RACES):
            values = pay(numbers, (kind, choice, race))
            at = place + 0.26 * (side - 1)
            axis.plot(at + rng.uniform(-0.06, 0.06, len(values)), values, marker, color=color,
                      markersize=3, alpha=0.5)  # fmt: skip
            axis.plot([at - 0.11, at + 0.11], [values.mean()] * 2, color=color, linewidth=2.5)
        axis.plot([], [], marker, color=color, label=f"{kind}, {choice}: worlds, and their mean")
    axis.axhline(0.0, color="black", linewidth=0.8)
    labels = [race.replace("; ", ":\n") for race in RACES]
    axis.set_xticks(range(len(RACES)), labels, fontsize=7, rotation=25, ha="right")
    axis.set_ylabel("answers pay (NashConv)\nabove 0: the race ends closer to perfect", fontsize=9)
    axis.legend(frameon=False, fontsize=8, loc="upper right")
    axis.spines[["top", "right"]].set_visible(False)
    return found


if __name__ == "__main__":
    play_worlds(__doc__, measured, table, figure)
