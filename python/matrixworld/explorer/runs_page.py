"""The page of runs: payoff matrices whose matches it plays, and all that belongs to them.

Numbers and verdicts come from `matrixworld.analysis`, from the same functions that the command line
and the figures use; the page computes none of its own.

While runs go on, their page is written anew. Readers beside a run see whole stages and take no
lock, so a run has the same bytes with this page and without. The payoff matrix is made at the end
of a run only: the first episodes of the evaluation are played here, in each generation those of its
new cells.

>>> from matrixworld.explorer import explore
>>> explore("runs/courtyard-seed0")  # doctest: +SKIP
"""

from __future__ import annotations

import json
import os
import shlex
import time
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from matrixworld import analysis
from matrixworld._util.files import DamagedFileError
from matrixworld._util.readable import plain_values
from matrixworld._util.teams import PLURALS
from matrixworld.analysis.cycles import MARGIN, strongest_checkerboards
from matrixworld.analysis.intervals import mean_over_opponents
from matrixworld.analysis.payoffs import EPISODES_TO_JUDGE
from matrixworld.analysis.progress import triangle
from matrixworld.analysis.ratings import ELO_POINTS
from matrixworld.coevolution.evaluation.kept_scores import found_scores
from matrixworld.coevolution.games.own_game import OwnGame
from matrixworld.coevolution.games.pursuit import PursuitSettings
from matrixworld.coevolution.games.tournament import tournament
from matrixworld.coevolution.groups import RunGroup, by_clarity, grouped
from matrixworld.coevolution.saved_run import SavedRun, open_run, open_runs
from matrixworld.coevolution.seeding import evaluation_seed
from matrixworld.coevolution.settings.race_settings import RaceSettings
from matrixworld.coevolution.settings.usual import DEFAULTS, SCHEDULE
from matrixworld.coevolution.types import BOTH, TEAMS, Payoff, Team, team_size
from matrixworld.episodes.episode import scene
from matrixworld.explorer.page import mime_bundle, render_page, without_engine, write_page
from matrixworld.explorer.playground import page_data, playground_page
from matrixworld.explorer.teams import MOST_BYTES, plain_game, plain_team, step_of
from matrixworld.version import __version__
from matrixworld.world.render import png
from matrixworld.world.rules import REWARDS, variant_name

PAGE = "explorer.html"  # name of the page in a run directory, or beside several
MOST_RUNS = 12  # the most runs of a page
CHANGED = "The source of the game {} has changed since it was raced."


@dataclass(frozen=True, repr=False)
class Explorer:
    """A page at `path`; notebooks show it in a frame, or its `picture`, the bytes of a PNG file."""

    path: Path
    picture: bytes = b""

    def __repr__(self) -> str:
        return f"<Explorer: {self.path}>"

    def _repr_mimebundle_(self, include: object = None, exclude: object = None) -> dict[str, str]:
        return mime_bundle(self.path.read_text(encoding="utf-8"), self.path.name, self.picture)


def explore(
    *runs: str | os.PathLike[str], file: str | os.PathLike[str] | None = None, force: bool = False
) -> Explorer:
    """Write the page of finished runs; the last expression of a notebook's cell shows it.

    Parameters
    ----------
    *runs : str or path
        1 to 12 directories of runs, or of jobs: then all their finished runs.
    file : str or path, optional
        The page. The default is ``explorer.html`` in the directory that holds all of the runs.
    force : bool, optional
        Whether an older file may be replaced. The default is False.

    Returns
    -------
    Explorer
        The page, which a notebook shows.

    Raises
    ------
    ValueError, FileNotFoundError, DamagedFileError
        For other numbers of runs, none in a directory, or a damaged one.
    FileExistsError
        If the file exists.
    """
    paths = [Path(run) for run in runs]
    saved = [run for path in paths for run in open_runs(path) or [open_run(path)]]
    if not 1 <= len(saved) <= MOST_RUNS:
        raise ValueError(f"runs: expected 1 to {MOST_RUNS} finished runs, got {len(saved)}")
    page = _common(paths) / PAGE if file is None else Path(file)
    write_page(page, explorer_page(saved), force=force)
    first = saved[0]
    shows_world = isinstance(first.settings.game, PursuitSettings)
    return Explorer(page, png(scene(first.record())) if shows_world else b"")


def _common(paths: Sequence[Path]) -> Path:
    """Return the directory that holds all of them."""
    return Path(os.path.commonpath([path.absolute() for path in paths]))


def explorer_page(
    runs: Sequence[SavedRun],
    *,
    note: str = "",
    so_far: Mapping[Path, Payoff] | None = None,
    groups: Sequence[RunGroup] | None = None,
) -> str:
    """Return the page of runs as HTML: the clearest race first, and what all seeds together show.

    The page of runs that go on has their payoffs `so_far`, by directory, and loads itself again.
    `groups` are those that the runs belong to, by default of these runs.
    """
    together: tuple[str, ...] = ()
    if so_far is None:
        every = groups or grouped(runs, finished=[run.path for run in runs])
        runs, together = zip(*_in_order(runs, every), strict=True)
    paths = [run.path.absolute() for run in runs]
    common = _common(paths)
    # Each by its path below the directory that holds all of them.
    names = [path.name if path == common else path.relative_to(common).as_posix() for path in paths]
    title = names[0] if len(names) == 1 else common.name
    named = [*zip(names, runs, strict=True)]
    plain, blobs = runs_data(named, so_far=so_far)
    for one, told in zip(plain, together, strict=False):
        one["together"] = told
    games = {run.settings.game for run in runs}
    own = [game for game in games if isinstance(game, OwnGame)]
    notes = [note, *(CHANGED.format(game.code) for game in own if game.changed())]
    pursuit = len(own) < len(games)
    if pursuit:
        blobs["playground"] = without_engine(playground_page()).encode()
    data = {
        "version": __version__,
        "title": title,
        "heading": heading(runs),
        "note": " ".join(filter(None, notes)),
        "growing": so_far is not None,
        "playground": page_data() if pursuit else None,
        "runs": plain,
    }
    opens, head = ["playground"] if pursuit else [], f"{title} - matrixworld"
    return render_page("explorer", head, data, blobs, opens=opens, engine=pursuit)


def _in_order(
    runs: Sequence[SavedRun], groups: Sequence[RunGroup]
) -> Iterator[tuple[SavedRun, str]]:
    """Yield runs, the clearest races first, with what all seeds of a group show together."""
    chosen = {run.path for run in runs}
    for group in by_clarity(groups):
        told = ""
        if len(group.runs) > 1 and group.is_race:
            name = group.runs[0].settings.schedule.name
            told = f"{name.capitalize()}: {analysis.sentence(group.judgement)}"
        yield from (
            (each.runs[0], told)
            for each in by_clarity(group.singles)
            if each.runs and each.runs[0].path in chosen
        )


def heading(runs: Sequence[SavedRun]) -> str:
    """Return what a page shows in words, such as "3 races of pursuers and evaders, variant O"."""
    settings = [run.settings for run in runs]
    kind = "race" if all(each.is_race for each in settings) else "run"
    words = f"{len(runs)} {kind}{'s' if len(runs) > 1 else ''} of "
    teams = {each.teams for each in settings}
    games = {each.game.variant for each in settings}
    if len(teams) > 1:
        return f"{words}{len(games)} games"
    words += " and ".join(dict.fromkeys(*teams))
    what = "game" if isinstance(settings[0].game, OwnGame) else "variant"
    names = games - {"own-rules"}
    return f"{words}, {what} {names.pop()}" if len(names) == 1 else words


# ---- Runs ----------------------------------------------------------------------------------------

MOST_POINTS = 6000
"""The most points of a training curve; a longer one has means of neighbouring epochs."""


def runs_data(
    runs: Sequence[tuple[str, SavedRun]],
    *,
    most: int = MOST_BYTES,
    so_far: Mapping[Path, Payoff] | None = None,
) -> tuple[list[dict[str, Any]], dict[str, bytes]]:
    """Return what a page shows of runs, given with their names, and genomes by identifier.

    There are genomes of as many generations as fit into `most` bytes.
    """
    step = step_of([run for _, run in runs], most)
    plain = []
    genomes: dict[str, bytes] = {}
    own_games = sum(isinstance(run.settings.game, OwnGame) for _, run in runs)
    for n, (name, run) in enumerate(runs):
        shown = run_data(name, run, (so_far or {}).get(run.path))
        teams = {
            team: plain_team(each, f"genomes-{n}-{team}", step, genomes)
            for team, each in zip(TEAMS, run.sides, strict=True)
        }
        for team, told in (what_evolved(run) if so_far is None else {}).items():
            teams[team]["evolved"] = told
        game = plain_game(run, own_games, ended=so_far is None)
        plain.append({**shown, "teams": teams, "game": game})
    return plain, genomes


def what_evolved(run: SavedRun) -> dict[Team, Any]:
    """Return what the best generation of each team does, in words, as far as its scores are kept.

    `matrixworld evolve` keeps them at the end of a job; a page plays none of these matches.
    """
    scores = found_scores(run) or {}
    told: dict[Team, Any] = {}
    for team in TEAMS:
        evolved = scores.get(PLURALS[team], {}).get("evolved")
        if evolved:
            told[team] = {name: evolved[name] for name in ("generation", "sentence")}
    return told


def run_data(name: str, run: SavedRun, so_far: Payoff | None = None) -> dict[str, Any]:
    """Return what a page shows of a run, without its teams; a race that goes on is not judged."""
    settings = run.settings
    payoff = so_far or run.payoff()
    shape = tuple(map(team_size, run.sides))
    limits = ""
    judged = None
    if settings.is_race:
        limits = too_few_episodes(payoff)
        judged = findings(payoff, ended=so_far is None)
    world = None
    if isinstance(settings.game, PursuitSettings):
        world = settings.game.world.to_json()
    return {
        "name": name,
        "schedule": settings.schedule.name if settings.is_race else "one team",
        "learning": list(settings.learning_teams),
        "seed": str(settings.seed),
        "world": world,
        "settings": plain_settings(settings),
        "command": command_of(settings),
        "training": training_curve(run.log(), settings),
        "payoff": plain_payoff(payoff, shape),
        # As text: a number of JavaScript holds 53 of the 64 bits.
        "seeds": [
            [str(evaluation_seed(settings.seed, g, h)) for h in range(shape[1])]
            for g in range(shape[0])
        ],
        "findings": judged,
        "limits": limits,
    }


def plain_payoff(payoff: Payoff, shape: tuple[int, ...]) -> dict[str, Any]:
    """Return the results of all cells, and of which generations the first cell is."""
    # Results of a single team are of its last generation.
    first = [count - played for count, played in zip(shape, payoff.matrix.shape, strict=True)]
    return {
        "first": first,
        "shape": list(shape),
        "episodes": payoff.scores.shape[2],
        "capture_rate": payoff.matrix.tolist(),
        # Nine digits identify every float32.
        "capture_rates": [
            [[float(f"{rate:.9g}") for rate in cell] for cell in row]
            for row in payoff.scores.tolist()
        ],
        "lengths": payoff.extras.get("lengths", np.empty(0)).tolist(),
        "others": None if payoff.others is None else payoff.others.mean(axis=2).tolist(),
        "extras": {
            name: values.tolist() for name, values in payoff.extras.items() if values.ndim == 2
        },
    }


def training_curve(log: Mapping[str, NDArray[Any]], settings: RaceSettings) -> dict[str, Any]:
    """Return the score of the first team over training, in lists of equal lengths.

    The learner is 0 for the pursuers, 1 for the evaders and 2 for both. A point is the mean of so
    many ``epochs``; ``window`` has the points of a moving average.
    """
    first, second = settings.keys
    learner = ((log["team"] == second) & (first != second)).astype(int)
    score, *_ = settings.game.known.columns
    if settings.schedule.at_once and first != second:
        # Both teams learn from the same matches, and each logs a row of them.
        log = {name: column[learner == 0] for name, column in log.items()}
        learner = np.full(len(log["team"]), 2)
    every = max(1, -(-len(learner) // MOST_POINTS))
    starts = np.arange(0, len(learner), every)
    counts = np.diff([*starts, len(learner)])
    return {
        "capture_rate": np.round(np.add.reduceat(log[score], starts) / counts, 4).tolist(),
        "generation": log["generation"][starts].tolist(),
        "learner": learner[starts].tolist(),
        "epochs": every,
        "window": max(1, round(settings.schedule.curve_window / every)),
        "matches": int(log["matches"][-1]) if len(learner) else 0,
    }


def plain_settings(settings: RaceSettings) -> list[dict[str, Any]]:
    """Return path, value and meaning of each setting that was chosen, but for schedule and seed."""
    help_texts = {**settings.help(), "world.rules": "game variant, or its rules one by one"}
    choices = settings.choices()
    if isinstance(settings.game, PursuitSettings):
        world = settings.game.world
        rewards = next((name for name, each in REWARDS.items() if each == world.rewards), "")
        for path, name in (("world.rules", variant_name(world.rules)), ("world.rewards", rewards)):
            parts = [part for part in choices if part == path or part.startswith(f"{path}.")]
            if name and parts:
                choices = {part: value for part, value in choices.items() if part not in parts}
                choices[path] = name
    chosen = []
    for path, value in choices.items():
        if path in ("schedule", "seed", DEFAULTS) or path.startswith("game."):
            continue
        shown = value if isinstance(value, str) else json.dumps(value)
        chosen.append({"name": path, "value": shown, "help": help_texts.get(path, "")})
    return chosen


def command_of(settings: RaceSettings) -> str:
    """Return the command that plays a run again: by its own file, if options cannot say all."""
    choices = settings.choices()
    sets = [f"{each['name']}={each['value']}" for each in plain_settings(settings)]
    if any("={" in each or "[{" in each for each in sets):
        return "matrixworld evolve --config config.json"
    words = ["matrixworld", "evolve"]
    if isinstance(settings.game, PursuitSettings) and DEFAULTS not in choices:
        words.append("--paper")
    words += ["--schedule", choices.get("schedule", SCHEDULE), "--seed", str(settings.seed)]
    for each in sets:
        words += ["--set", each]
    return shlex.join(words)


# ---- What the analysis says ----------------------------------------------------------------------

BOARDS = 12  # the most checkerboards on a page: the strongest ones


def findings(payoff: Payoff, *, ended: bool = True) -> dict[str, Any]:
    """Return curves of a race of at least 2 x 2 generations, and its judgement if it has ended."""
    if not ended:
        sentence = f"Generation {min(payoff.matrix.shape) - 1} so far."
        return {"sentence": sentence, "table": [], **curves(payoff)}
    payoffs = payoff.payoffs()
    boards: Sequence[Any] | None = None
    if not payoffs.general:  # of an order of strength, which such games need not have
        boards = strongest_checkerboards(payoff.matrix, count=BOARDS, margin=MARGIN)
    judgement = analysis.judge(payoffs)
    return {
        "sentence": analysis.sentence(judgement),
        "table": [list(row) for row in analysis.judgement_table(judgement)],
        "reasons": analysis.explain(judgement).splitlines(),
        "refused": {name: why.in_words(judgement.teams) for name, why in judgement.refused.items()},
        "checkerboards": plain_values(boards),
        "margin": MARGIN,
        **curves(payoff),
    }


def curves(payoff: Payoff) -> dict[str, Any]:
    """Return what is drawn of a race and claims nothing."""
    payoffs = payoff.payoffs()
    has_episodes = payoff.scores.shape[2] >= 2
    sides = {team: payoffs.side(team) for team in BOTH}
    triangles = {team: triangle(side.matrices[0]) for team, side in sides.items()}
    found: dict[str, Any] = {
        "generalization": {
            team: _curve(
                side.matrices[0].mean(axis=1),
                mean_over_opponents(side.scores[0])
                if has_episodes and side.scores is not None
                else None,
            )
            for team, side in sides.items()
        },
        # The triangles are the two halves of the payoff, which the page has.
        "ciao": {
            team: {
                "fading": plain_values(each.fading),
                "stripes": each.stripes,
                "period": each.period,
            }
            for team, each in triangles.items()
        },
        "ratings": None,
        "joint": None,
    }
    if payoffs.general:
        mean = analysis.joint_scores(payoffs)
        found["joint"] = _curve(mean.mean, mean if has_episodes else None)
        return found
    ratings = analysis.elo(payoff.matrix)
    bands = analysis.elo_over_episodes(payoff.scores) if has_episodes else (None, None)
    found["ratings"] = {
        "offset": ratings.offset * ELO_POINTS,
        **{
            team: _curve(getattr(ratings, team) * ELO_POINTS, band)
            for team, band in zip(BOTH, bands, strict=True)
        },
    }
    return found


def _curve(mean: Any, band: Any) -> dict[str, Any]:
    """Return means, with an interval where episodes allow one."""
    curve = {"mean": plain_values(mean), "low": None, "high": None}
    if band is not None:
        middle, low, high = (np.ravel(ends) for ends in (band.mean, band.low, band.high))
        # Where a band has no interval, it is as thin as the line.
        curve["low"] = plain_values(np.fmin(low, middle))
        curve["high"] = plain_values(np.fmax(high, middle))
    return curve


def too_few_episodes(payoff: Payoff) -> str:
    """Return what a small number of episodes means for the judgement; empty if they are enough."""
    episodes = payoff.scores.shape[2]
    if episodes >= EPISODES_TO_JUDGE or payoff.exact:
        return ""
    return (
        f"Each cell has {episodes} episode{'' if episodes == 1 else 's'}; it takes at least "
        f"{EPISODES_TO_JUDGE} to tell all conditions from noise."
    )


# ---- While runs go on ----------------------------------------------------------------------------

SO_FAR = 2  # episodes of each cell while a run goes on, the first ones of the evaluation
SECONDS = 3.0  # the least time between two pages
SHARE = 0.1  # the most of the time that the page may take from the runs
NOTE = (
    "The runs go on. This page shows what there was at {time}, and loads itself again when nobody "
    "uses it. A run that has not ended has at most {episodes} episodes a cell, and no judgement."
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
            note = NOTE.format(time=time.strftime("%H:%M:%S"), episodes=SO_FAR)
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
    pursuers, evaders = run.sides
    settings = run.settings
    episodes = min(SO_FAR, settings.evaluation_episodes)
    play: Any = {"seed": settings.seed, "episodes": episodes, "threads": 1, "known": known}
    return tournament(settings.evaluation_game, pursuers, evaders, **play)
