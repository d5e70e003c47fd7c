"""How often a team is said to become stronger, and a race to cycle, by kind of race.

    python evolution/validation/judgement_gains.py           300 groups of each kind, 12 minutes
    python evolution/validation/judgement_gains.py --quick   a few groups, seconds

The share of teams whose gain over the whole race is above 0. Kinds in which nobody gains have the
size of the test, of which .05 is allowed; the others have its power. Matches are 30 evaders, 10
episodes of each pair. Seeds start at 500,000, which no other script uses.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
from tqdm import tqdm

import _paths  # noqa: F401
from common import markdown, script_parser
from judgement_races import synthetic_races
from matrixworld import analysis
from synthetic_races import play_episodes

FIRST_SEED = 500_000
GROUPS = 300
RUNS = (1, 2, 3, 5, 10)
GENERATIONS = (15, 31)
SIZE = dict.fromkeys((
    "noise only, .5", "drift", "fluctuation", "single jump", "common jump", "own jumps",
    "smooth wander",
), 1.0)  # fmt: skip
"""Kinds without a trend, and their effect."""
POWER = {"pure race": 0.2, "sigmoid": 0.6, "early dip": 0.6, "late onset": 0.6, "uneven pace": 0.3}
"""Kinds in which both teams gain, and their effect."""


def share_of_gains(kind: str, effect: float, n: int, runs: int, groups: int) -> float:
    """Return the share of teams with a gain above 0."""
    found = []
    for seed in range(FIRST_SEED, FIRST_SEED + groups):
        rng = np.random.default_rng([seed, 5, runs, n])
        races = synthetic_races(kind, n, seed, effect=effect, runs=runs)
        scores = np.stack([play_episodes(race.rates, 10, rng, evaders=30) for race in races])
        payoffs = analysis.read_payoffs(scores, per_episode=True)
        gains = (analysis.MEASURES[f"{team}_gain"] for team in ("pursuer", "evader"))
        found += [gain.of(payoffs, "whole").ends[0] > 0.0 for gain in gains]
    return float(np.mean(found))


RACES = 100
RETURN = ("cycle", "rock-paper-scissors", "cycle on a climb", "period 2")
NO_RETURN = ("switch of style", "three styles", "slow turn", "new styles", "forgetting", "drift")
"""Kinds whose strategies return, and kinds whose strategies do not; both with an effect of 1."""


def verdicts_on_circles(kind: str, n: int, races: int) -> list[str]:
    """Return the shares of intransitivity present, cycling present, and cycling absent."""
    found = []
    for seed in range(FIRST_SEED, FIRST_SEED + races):
        [race] = synthetic_races(kind, n, seed)
        scores = play_episodes(race.rates, 10, np.random.default_rng([seed, 6, n]), evaders=30)
        judged = analysis.judge(scores, per_episode=True).windows["whole"]
        cycling = judged["cycling"].verdict
        present = judged["intransitivity"].verdict == "present"
        found.append((present, cycling == "present", cycling == "absent"))
    return [f"{share:.0%}" for share in np.mean(found, axis=0)]


def circles(races: int) -> str:
    """Return the table of kinds that are intransitive, and of those that also cycle."""
    heads = ("strategies", "kind", "generations", "intransitivity present", "cycling present",
             "cycling absent")  # fmt: skip
    rows = [
        [what, kind, str(n), *verdicts_on_circles(kind, n, races)]
        for what, kinds in (("return", RETURN), ("do not return", NO_RETURN))
        for kind in tqdm(kinds, disable=None)
        for n in GENERATIONS
    ]
    text = f"# Races that are said to cycle\n\n{races} single races of each kind, over all of it."
    return f"{text}\n\n{markdown(heads, rows)}\n"


def main() -> None:
    """Write the tables."""
    parser = script_parser(__doc__, quick="3 groups of each kind")
    parser.add_argument("--results", type=Path, default=Path("judgement"))
    args = parser.parse_args()
    groups = 3 if args.quick else GROUPS
    cells = [
        (what, kind, effect, n)
        for what, kinds in (("nobody gains", SIZE), ("both gain", POWER))
        for kind, effect in kinds.items()
        for n in GENERATIONS
    ]
    rows = [
        [what, kind, f"{effect:g}", str(n)]
        + [f"{share_of_gains(kind, effect, n, runs, groups):.1%}" for runs in RUNS]
        for what, kind, effect, n in tqdm(cells, disable=None)
    ]
    heads = ("truth", "kind", "effect", "generations", *(f"runs: {runs}" for runs in RUNS))
    text = f"# Teams that are said to gain\n\n{__doc__.split(chr(10) * 2)[2]}\n\n"
    text += f"{groups} groups, {2 * groups} teams, in each cell.\n\n{markdown(heads, rows)}\n"
    text += f"\n{circles(3 if args.quick else RACES)}"
    args.results.mkdir(parents=True, exist_ok=True)
    (args.results / "gains.md").write_text(text, encoding="utf-8")
    print(text)


if __name__ == "__main__":
    main()
