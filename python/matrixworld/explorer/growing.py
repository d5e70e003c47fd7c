"""The page of runs that go on, written anew while they do.

Readers beside a run see whole stages and take no lock, so a run has the same bytes with this page
and without. The payoff matrix is made at the end of a run only: the first episodes of the
evaluation are played here, in each generation those of its new cells.
"""

from __future__ import annotations

import time
from collections.abc import Sequence
from functools import partial
from pathlib import Path

import numpy as np

from matrixworld._util.files import DamagedFileError
from matrixworld.coevolution.evaluation.tournament import team_size, tournament
from matrixworld.coevolution.storage import SavedRun, open_run
from matrixworld.coevolution.types import TEAMS, Payoff
from matrixworld.explorer.page import write_page
from matrixworld.explorer.runs_page import PAGE, explorer_page
from matrixworld.world.policy import Population, TeamPolicy

EPISODES = 2
"""Episodes of each cell while a run goes on, the first ones of the evaluation."""
SECONDS = 3.0
"""The least time between two pages."""
SHARE = 0.1
"""The most of the time that the page may take from the runs."""
NOTE = (
    "The runs go on. This page shows what there was at {time}, and loads itself again when nobody "
    "uses it. A run that has not ended has {episodes} episodes of each cell, and no judgement."
)


class GrowingPage:
    """The page of the runs with these names in the directory of a job; they need not exist yet."""

    def __init__(self, root: Path, names: Sequence[str]) -> None:
        self._root, self._names = root, names
        self._runs: dict[str, SavedRun] = {}
        self._payoffs: dict[Path, Payoff] = {}  # of the runs that go on
        self._seen: dict[str, tuple[int, bool]] = {}
        self._due = time.monotonic() + SECONDS

    def write(self) -> None:
        """Write the page if there are new generations and enough time has passed."""
        began = time.monotonic()
        if began < self._due:
            return
        grown = [self._look(name) for name in self._names]
        if any(grown):
            runs = [self._runs[name] for name in self._names if name in self._runs]
            note = NOTE.format(time=time.strftime("%H:%M:%S"), episodes=EPISODES)
            write_page(self._root / PAGE, explorer_page(runs, note=note, so_far=self._payoffs))
        ended = time.monotonic()
        self._due = ended + max(SECONDS, (ended - began) / SHARE)

    def _look(self, name: str) -> bool:
        """Play what a run has added since the last look; return whether it has added anything."""
        path = self._root / name
        state = len([*path.glob("stage-*.npz")]), SavedRun(path).finished
        if state in ((0, False), self._seen.get(name)):
            return False
        try:
            run = open_run(path)
        except (OSError, DamagedFileError):
            return False  # it is being made or mended; the end of the job tells what is damaged
        known = self._payoffs.pop(path, None)
        if not state[1]:
            self._payoffs[path] = extended(run, known)
        self._runs[name], self._seen[name] = run, state
        return True


def extended(run: SavedRun, known: Payoff | None) -> Payoff:
    """Return the payoff of all generations of a run; what is known of them is not played again."""
    pursuers, evaders = (run.teams[team] for team in TEAMS)
    settings = run.settings
    episodes = min(EPISODES, settings.evaluation_episodes)
    play = partial(tournament, settings.world, seed=settings.seed, episodes=episodes, threads=1)
    if known is None:
        return play(pursuers, evaders)
    g, h = known.capture_rate.shape
    if h < team_size(evaders):
        known = _joined(known, play(_part(pursuers, 0, g), _part(evaders, h), first=(0, h)), 1)
    if g < team_size(pursuers):
        known = _joined(known, play(_part(pursuers, g), evaders, first=(g, 0)), 0)
    return known


def _joined(known: Payoff, new: Payoff, axis: int) -> Payoff:
    old, more = known.arrays(), new.arrays()
    return Payoff.from_arrays(
        {name: np.concatenate([old[name], more[name]], axis=axis) for name in old}
    )


def _part(team: TeamPolicy, first: int, last: int | None = None) -> TeamPolicy:
    return team if isinstance(team, str) else Population(team.genomes[first:last], team.network)
