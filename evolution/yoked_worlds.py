"""Does an arms race need an answering opponent? Races of tables and yoked ones, in 30 worlds.

    python evolution/yoked_worlds.py             30 worlds, 20 seeds of each race, ten minutes
    python evolution/yoked_worlds.py --quick     four small worlds and three seeds, some seconds

In a yoked race each team meets the opponents of the race of the next seed, in their order: they
change as in a race, but do not answer. `yoked_races.py` finds no difference in one solved world, by
one learner. Here are the 30 worlds of `perfect_learners.py`, whose guarantees are exact, four
learners and two schedules (`tabular.py`), 32 generations, 20 seeds. Worlds are played in the order
in which they were drawn; numbers are kept by world, and an interrupted script goes on.

*Answers pay* is how much lower the NashConv of the race is than that of the yoked race with the
same first tables and seed. The unit is the newest generation where teams or agents take turns, and
the equilibrium mixture of all generations, in the scores against those met, where all move at once.

Decided before the worlds were played:

1.  Over the worlds of a kind, by learner and schedule: answers *pay* or *cost* if the mean over
    worlds is told from 0 (Student's t, Holm over all rows). *Alike* if the whole 95 % interval lies
    within .05. Else the table says: cannot tell.
2.  In single worlds: the same over seeds, Holm over all worlds of a row. Neighbours in the ring of
    seeds share a race, so that these differences are not quite independent.
3.  Does a property of the exact game predict in which world answers pay? Spearman's rank
    correlation over all worlds of a learner and schedule with each of `PROPERTIES`, Holm over all
    of them.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.figure import Figure
from scipy import stats

import common
from matrixworld.analysis import interval_over_runs
from matrixworld.coevolution import TEAMS, Team
from matrixworld.coevolution.types import other
from perfect_learners import KINDS, MARGIN, of_kind, play_worlds
from tabular import (
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

SEEDS, GENERATIONS = {False: 20, True: 3}, {False: 32, True: 4}
"""Full length, or with ``--quick``."""
LEARNS = ("perfect", "perfect where it plays", "10 % of the changes", "improves what it meets")
MEETS = (SPECIALISTS, GENERALISTS)
KIND = [f"{learner}; {schedule}" for learner in LEARNS for schedule in MEETS]
SAMPLE = 32
"""Tables of each team, drawn by chance, from which spread and intransitivity are computed."""
PROPERTIES = {
    "value": "capture rate of perfect play",
    "mixing": "worth of moving second",
    "depth": "turns of an episode",
    "states": "states",
    "spread": "standard deviation of the scores of random tables",
    "intransitivity": "share of the variance of best responses that is no team's strength",
}


class YokedRace(Race):
    """A race whose opponents are replayed from another one, generation by generation."""

    def __init__(self, replayed: Race, *race: Any) -> None:
        super().__init__(*race)
        self.replayed = replayed

    def opponents(self, team: Team) -> list[Table]:
        """Return as many generations of the other race as this one has itself."""
        return self.replayed.tables[other(team)][: len(self.tables[other(team)])]


def properties(game: Game) -> dict[str, float]:
    """Return properties of the exact game; `PROPERTIES` says what they are."""
    rng = np.random.default_rng(0)
    drawn = {team: [game.random(team, rng) for _ in range(SAMPLE)] for team in TEAMS}
    answers = {
        team: [
            game.respond(team, game.mixed(other(team), [each], np.ones(1)))[0]
            for each in drawn[other(team)]
        ]
        for team in TEAMS
    }
    return {
        "value": game.value, "mixing": game.mixing, "depth": game.rounds * len(game.succ),
        "states": game.states.total,
        "spread": float(game.scores(drawn["pursuer"], drawn["evader"]).std()),
        "intransitivity": interaction(game.scores(answers["pursuer"], answers["evader"])),
    }  # fmt: skip


def interaction(matrix: Floats) -> float:
    """Return the share of the variance of a matrix that rows and columns do not explain."""
    rows, columns = matrix.mean(axis=1, keepdims=True), matrix.mean(axis=0, keepdims=True)
    rest = matrix - rows - columns + matrix.mean()
    return float(rest.var() / matrix.var()) if matrix.var() > 1e-12 else 0.0


def shortfalls(race: Race, unit: str) -> list[float]:
    """Return by how much what the unit of each team guarantees falls short of the value."""
    value = race.game.value
    pursuers, evaders = (race.game.guarantee(team, race.chosen(team, unit)) for team in TEAMS)
    return [round(value - pursuers, 6), round(evaders - value, 6)]


def measured(world: str, quick: bool) -> dict[str, Any]:
    """Return the properties of a world, and the shortfalls of all races in it."""
    game = Game(config_of(world))
    unit = KINDS["at once" if game.together else "in turns"]
    found: dict[str, Any] = {"world": world, "together": game.together, **properties(game)}
    for learner in LEARNS:
        for schedule in MEETS:
            settings = SCHEDULES[schedule], LEARNERS[learner]
            races = [
                Race(game, *settings, seed).run(GENERATIONS[quick]) for seed in range(SEEDS[quick])
            ]
            yoked = [
                YokedRace(replayed, game, *settings, seed).run(GENERATIONS[quick])
                for seed, replayed in enumerate([*races[1:], races[0]])
            ]
            kind = f"{learner}; {schedule}"
            for name, of_name in (("race", races), ("yoked", yoked)):
                found[f"{kind} / {name}"] = [shortfalls(each, unit) for each in of_name]
    return found


# Tables


def pay(numbers: common.Numbers, kind: str) -> Floats:
    """Return how much lower the NashConv of races is than that of yoked ones, (worlds, seeds)."""
    yoked, race = (numbers[f"{kind} / {name}"].sum(axis=2) for name in ("yoked", "race"))
    return np.asarray(yoked - race)


def verdict(values: Floats, p: float) -> str:
    """Return what answers do, by the mean over worlds, its interval and its adjusted p-value."""
    found = interval_over_runs(values)
    if p < common.SIGNIFICANCE:
        return "pay" if found.value > 0.0 else "cost"
    ends = [abs(each) for each in (found.low, found.high, found.value) if each is not None]
    return "alike" if max(ends) < MARGIN else "cannot tell"


def single_worlds(values: Floats) -> tuple[int, int]:
    """Return in how many worlds (worlds, seeds) answers pay, and in how many they cost."""
    told = common.holm([common.p_value(np.round(each, 6)) for each in values]) < common.SIGNIFICANCE
    means = values.mean(axis=1)
    return int((told & (means > 0)).sum()), int((told & (means < 0)).sum())


def table_of_pay(numbers: common.Numbers) -> str:
    """Return what answers bring, by kind of world, learner and schedule."""
    keys = [(of, kind) for of in KINDS for kind in KIND]
    values = {(of, kind): pay(numbers, kind)[of_kind(numbers, of)] for of, kind in keys}
    adjusted = common.adjusted({key: each.mean(axis=1) for key, each in values.items()})
    rows = []
    for (of, kind), each in values.items():
        means = [
            f"{numbers[f'{kind} / {name}'][of_kind(numbers, of)].sum(axis=2).mean():.3f}"
            for name in ("race", "yoked")
        ]
        of_worlds, p = each.mean(axis=1), adjusted[of, kind]
        more, less = single_worlds(each)
        rows.append([
            of, *kind.split("; "), *means, common.mean(of_worlds, sign="+"), common.shown_p(p),
            f"**{verdict(of_worlds, p)}**", f"{more}, {less} of {len(each)}",
        ])  # fmt: skip
    heads = ["worlds", "learner", "schedule", "NashConv of the race", "of the yoked race",
             "answers pay", "Holm", "", "worlds in which they pay, cost"]  # fmt: skip
    return common.markdown(heads, rows).replace("|  |", "| |")


def correlations(numbers: common.Numbers) -> dict[tuple[str, str], tuple[float, float]]:
    """Return rank correlations of what answers bring with properties, and p-values (Holm)."""
    found = {}
    for kind in KIND:
        brings = np.round(pay(numbers, kind).mean(axis=1), 6)
        for name in PROPERTIES:
            flat = np.ptp(brings) == 0.0 or np.ptp(numbers[name]) == 0.0
            tested = (0.0, 1.0) if flat else stats.spearmanr(numbers[name], brings)
            found[kind, name] = float(tested[0]), float(tested[1])
    adjusted = common.holm([p for _, p in found.values()])
    return {
        key: (rank, float(p)) for (key, (rank, _)), p in zip(found.items(), adjusted, strict=True)
    }


def table_of_properties(numbers: common.Numbers) -> str:
    """Return which property of the game says where answers pay."""
    found = correlations(numbers)
    rows = [
        [
            *kind.split("; "),
            *(
                f"{rank:+.2f}" + "\\*" * (p < common.SIGNIFICANCE)
                for rank, p in (found[kind, name] for name in PROPERTIES)
            ),
        ]
        for kind in KIND
    ]
    return common.markdown(["learner", "schedule", *PROPERTIES.values()], rows)


def table_of_worlds(numbers: common.Numbers) -> str:
    """Return what answers bring in each world, for the two learners that are not perfect."""
    kinds = [kind for kind in KIND if not kind.startswith("perfect;")]
    brings = {kind: pay(numbers, kind) for kind in kinds}
    rows = [
        [world, *(common.mean(each[place], sign="+") for each in brings.values())]
        for place, world in enumerate(numbers["world"])
    ]
    return common.markdown(["world", *kinds], rows)


def table(numbers: common.Numbers) -> str:
    """Return all tables in Markdown."""
    count, seeds = numbers[f"{KIND[0]} / race"].shape[:2]
    parts = [
        f"{count} worlds, {seeds} seeds. Answers pay: NashConv of the yoked race minus that of the "
        "race, mean over worlds with its 95 % interval.",
        table_of_pay(numbers),
        "### Which property of a game says where answers pay?",
        "Spearman's rank correlation over worlds; * if told from 0 (Holm, over this table).",
        table_of_properties(numbers),
        "### Worlds",
        "Answers pay, mean over seeds with its 95 % interval.",
        table_of_worlds(numbers),
    ]
    return "\n\n".join(parts)


def figure(numbers: common.Numbers) -> Figure:
    """Draw what answers bring: one point for each world, by kind of world and of race."""
    found = Figure(figsize=(8, 3.6), layout="constrained")
    axis = found.subplots()
    rng = np.random.default_rng(0)
    colors = {"in turns": "tab:blue", "at once": "tab:orange"}
    for side, (of, color) in enumerate(colors.items()):
        for place, kind in enumerate(KIND):
            values = pay(numbers, kind)[of_kind(numbers, of)].mean(axis=1)
            at = place + 0.2 * (2 * side - 1)
            axis.plot(
                at + rng.uniform(-0.08, 0.08, len(values)), values, ".", color=color, alpha=0.6
            )
            axis.plot([at - 0.15, at + 0.15], [values.mean()] * 2, color=color, linewidth=3)
        axis.plot([], [], color=color, linewidth=3, label=f"worlds {of}: mean, and each world")
    axis.axhline(0.0, color="black", linewidth=0.8)
    axis.set_xticks(range(len(KIND)), [kind.replace("; ", ":\n") for kind in KIND], fontsize=7,
                    rotation=25, ha="right")  # fmt: skip
    axis.set_ylabel("answers pay (NashConv)\nabove 0: the race ends closer to perfect", fontsize=8)
    axis.legend(frameon=False, fontsize=8)
    axis.spines[["top", "right"]].set_visible(False)
    return found


if __name__ == "__main__":
    play_worlds(__doc__, measured, table, figure)
