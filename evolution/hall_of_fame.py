"""Do halls of fame do what their literature says? Races with and without them, at equal matches.

    python evolution/hall_of_fame.py             ten seeds of each kind, half an hour on two cores
    python evolution/hall_of_fame.py --quick     a small world and two seeds, some seconds

Two populations evolve simultaneously. Without halls of fame, individuals meet living opponents
only. With halls of fame they also meet earlier champions. Both kinds of race play the same number
of matches.

Method: Rosin and Belew (1997), "New methods for competitive coevolution". They expect of a hall of
fame that less is forgotten, and that progress does not go in cycles.

Look at the last three columns: the difference that halls of fame make, with its interval over
seeds; its p-value; and whether it is the expected one. P-values are adjusted for the number of rows
(Holm), so that by chance any verdict of the table is wrong in 5 % of such tables; an interval
speaks of its own row alone.
"""

from __future__ import annotations

from typing import Any

import numpy as np

import common
from matrixworld import analysis
from matrixworld.coevolution import TEAMS, RaceSettings, SavedRun, score

FULL = RaceSettings.of(common.long_race("hall-of-fame"))
QUICK = {**common.SMALL_RACE, "schedule.generations": 8, "schedule.joint_epochs": 3}
LIVING, HALL = "living opponents only", "halls of fame"

MEASURES = {
    "pursuer_forgetting": ("forgetting of the pursuers", -1),
    "evader_forgetting": ("forgetting of the evaders", -1),
    "checkerboards": ("checkerboard share, last half", -1),
    "transitive_share": ("transitive share, last half", 1),
    "lag_rise": ("gain of later over earlier pursuers", 1),
    "pursuer_score": ("held-out score of the pursuers", 1),
    "evader_score": ("held-out score of the evaders", 1),
}
"""Numbers of a race in words, and whether halls of fame should raise (1) or lower (-1) them."""
WHOLE = dict.fromkeys(("pursuer_forgetting", "evader_forgetting"), "whole")
"""Windows of the measures that are not about that of tables."""


def kinds(quick: bool) -> dict[str, RaceSettings]:
    """Return the settings of both kinds of race, with the same number of matches."""
    base = FULL.changed(QUICK if quick else {})
    # A match between living opponents counts for both teams, a match against the hall for one.
    living = base.schedule.contemporaries + 2 * base.schedule.hall_sample
    return {
        LIVING: base.changed({"schedule.contemporaries": living, "schedule.hall_sample": 0}),
        HALL: base,
    }


def numbers_of(run: SavedRun) -> dict[str, Any]:
    """Return the numbers of `MEASURES` of one finished race."""
    matrix, scores = run.payoff().matrix, score(run)
    return {
        **{
            name: analysis.MEASURES[name].of(matrix, WHOLE.get(name)).value
            for name in MEASURES
            if name in analysis.MEASURES
        },
        **{f"{team}_score": float(scores[team].rates[-1].mean()) for team in TEAMS},
    }


def verdict(p: float, difference: float, expected: int) -> str:
    """Return whether a difference lies on the expected side of 0, by its adjusted p-value."""
    if p > common.SIGNIFICANCE:
        return "cannot tell"
    return "as expected" if np.sign(difference) == expected else "the opposite"


def table(numbers: common.Numbers) -> str:
    """Return the comparison of both kinds of race as a table in Markdown."""
    values = {name: [numbers[f"{kind} / {name}"] for kind in (LIVING, HALL)] for name in MEASURES}
    # Pairs of the same seed: both races start with the same genomes.
    differences = {name: hall - living for name, (living, hall) in values.items()}
    rows = []
    for name, p in common.adjusted(differences).items():
        label, expected = MEASURES[name]
        rows.append(
            [
                label,
                "higher" if expected > 0 else "lower",
                *map(common.mean, (*values[name], differences[name])),
                common.shown_p(p),
                f"**{verdict(p, differences[name].mean(), expected)}**",
            ]
        )
    count = len(differences["lag_rise"])
    heads = [f"mean over {count} seeds [95%]", "expected", LIVING, HALL, "difference", "Holm |"]
    return common.markdown(heads, rows)


if __name__ == "__main__":
    common.experiment(
        __doc__, kinds=kinds, measure=common.of_each(numbers_of), table=table, seeds=10
    )
