"""What does right of way cost both teams? Races with the mask, beside the same without.

    python evolution/safe_races.py             ten seeds of each, half an hour of one core
    python evolution/safe_races.py --quick     a small world and two seeds, some seconds

Both teams of a race of generalists take the mask `policy.mask=right-of-way`, by which no agent is
ever at fault (docs/safety.md#right-of-way), or none. Opponents that are held out have no mask.

Look at the last row, the differences between races of the same seed: an interval around 0 says how
much the mask may cost.
"""

from __future__ import annotations

import numpy as np

from common import SMALL_RACE, Numbers, experiment, markdown, mean, of_each
from matrixworld.coevolution import TEAMS, RaceSettings, SavedRun, score

MASKS = ("none", "right-of-way")
QUICK = {
    **SMALL_RACE, "schedule.generations": 4, "schedule.pursuer_epochs": 2,
    "schedule.evader_epochs": 2,
}  # fmt: skip
COLUMNS = {
    "score, pursuers": 2, "score, evaders": 2, "collisions, pursuers": 1, "evaders": 1,
    "in all of training": 0,
}  # fmt: skip
"""Columns of the table, and their digits."""


def kinds(quick: bool) -> dict[str, RaceSettings]:
    """Return races with each of `MASKS`."""
    base = RaceSettings.of(QUICK if quick else {})
    return {mask: base.changed({"policy.mask": mask}) for mask in MASKS}


def numbers_of(run: SavedRun) -> dict[str, list[float]]:
    """Return scores of both teams and collisions: late ones of both teams, and all of training."""
    scores, log = score(run), run.log()
    late = log["generation"] == log["generation"].max()
    episodes = np.diff(log["matches"], prepend=0)
    collisions = [log[f"{team}_faults"] for team in TEAMS]
    return {
        "scores": [float(scores[team].means[-1]) for team in TEAMS],
        "late": [float(each[late].mean()) for each in collisions],
        "all": [float(sum(each @ episodes for each in collisions))],
    }


def table(numbers: Numbers) -> str:
    """Return what the masks change, in Markdown: means over seeds, and differences of seeds."""
    found = {
        mask: np.hstack([numbers[f"{mask} / {name}"] for name in ("scores", "late", "all")])
        for mask in MASKS
    }
    found["right of way, minus none"] = found["right-of-way"] - found["none"]
    rows = []
    for label, columns in found.items():
        sign = "+" if "minus" in label else ""
        each = zip(columns.T, COLUMNS.values(), strict=True)
        *cells, _ = (mean(column, digits, sign) for column, digits in each)
        rows.append([label, *cells, format(columns[:, -1].mean(), f"{sign},.0f")])
    told = (
        "Scores of the last generations against held-out opponents; collisions: agent-steps at "
        "fault in an episode\nof the last generation's training, and in all of training. "
        "[95% over seeds]\n\n"
    )
    return told + markdown(["mask", *COLUMNS], rows)


if __name__ == "__main__":
    experiment(__doc__, kinds=kinds, measure=of_each(numbers_of), table=table, seeds=10)
