"""The page of finished runs: payoff matrices whose matches it plays, and all that belongs to them.

Numbers and verdicts come from `matrixworld.analysis`, from the same functions that the command line
and the figures use; the page computes none of its own.

>>> from matrixworld.explorer import explore
>>> explore("runs/O-seed0")  # doctest: +SKIP
"""

from __future__ import annotations

import io
import json
import os
import zlib
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from matrixworld import analysis
from matrixworld.analysis.cycles import MARGIN, strongest_checkerboards
from matrixworld.analysis.payoffs import EPISODES_TO_JUDGE
from matrixworld.analysis.plain_values import plain_values
from matrixworld.analysis.report import headline_numbers
from matrixworld.coevolution.schedules import Against, HallOfFame, Yoked, curve_window
from matrixworld.coevolution.sections import leaves
from matrixworld.coevolution.seeding import evaluation_seed
from matrixworld.coevolution.settings import RaceSettings
from matrixworld.coevolution.storage import SavedRun, open_run, open_runs
from matrixworld.coevolution.types import TEAMS, Genomes, Payoff, Team
from matrixworld.envs.variants import VARIANT_TEXTS
from matrixworld.episodes import replay
from matrixworld.explorer.guided_minute import guided_minute
from matrixworld.explorer.page import mime_bundle, render_page, without_engine, write_page
from matrixworld.explorer.playground import Playground, page_data
from matrixworld.version import __version__
from matrixworld.world.policy import Population, TeamPolicy
from matrixworld.world.rules import variant_name

PAGE = "explorer.html"
"""Name of the page in a run directory, or beside several."""
MOST_RUNS = 12
"""The most runs of a page."""

Path_ = str | os.PathLike[str]


@dataclass(frozen=True, repr=False)
class Explorer:
    """A page that was written; notebooks show it in a frame.

    Parameters
    ----------
    path : Path
        The file.
    picture : bytes, optional
        A match as a PNG file: what a notebook shows where it shows no frame. The default is none.
    """

    path: Path
    picture: bytes = b""

    def __repr__(self) -> str:
        return f"<Explorer: {self.path}>"

    def _repr_mimebundle_(self, include: object = None, exclude: object = None) -> dict[str, str]:
        return mime_bundle(self.path.read_text(encoding="utf-8"), self.path.name, self.picture)


def explore(*runs: Path_, file: Path_ | None = None, force: bool = False) -> Explorer:
    """Write the page of finished runs; the last expression of a notebook's cell shows it.

    Parameters
    ----------
    *runs : str or path
        Directories of runs, or of jobs: then all their finished runs. At least one run and at most
        12.
    file : str or path, optional
        The page. The default is ``explorer.html`` in the directory, or in the one that holds all of
        them.
    force : bool, optional
        Whether to replace a file that exists. The default is False.

    Raises
    ------
    ValueError
        If the number of runs is another one.
    FileNotFoundError
        If a directory holds no finished run.
    FileExistsError
        If the file exists.
    DamagedFileError
        If a file of a run is cut or altered.
    """
    paths = [Path(run) for run in runs]
    saved = [run for path in paths for run in open_runs(path) or [open_run(path)]]
    if not 1 <= len(saved) <= MOST_RUNS:
        raise ValueError(f"runs: expected 1 to {MOST_RUNS} finished runs, got {len(saved)}")
    # By default beside what it shows.
    common = Path(os.path.commonpath([path.absolute() for path in paths]))
    page = common / PAGE if file is None else Path(file)
    if page.exists() and not force:
        raise FileExistsError(f"{page}: exists; force=True replaces it")
    write_page(page, explorer_page(saved))
    # Three moments of the match of the last generations.
    picture = io.BytesIO()
    replay.contact_sheet(saved[0].record(), rows=1).save(picture, "PNG")
    return Explorer(page, picture.getvalue())


def explorer_page(
    runs: Sequence[SavedRun],
    *,
    judgements: Mapping[Path, analysis.Judgement] | None = None,
    note: str = "",
    live: str | None = None,
) -> str:
    """Return the page of finished runs as HTML, in this order.

    By run directory, `judgements` has those that are known; other races are judged here. A `note`
    says what the page does not show, such as further runs of the job. FileNotFoundError if a run is
    not finished. A page that is `live` (see `matrixworld.explorer.live`) has this version, and no
    judgement.
    """
    paths = [run.files.path.absolute() for run in runs]
    common = Path(os.path.commonpath(paths))
    # Each by its path below the directory that holds all of them.
    names = [path.name if path == common else path.relative_to(common).as_posix() for path in paths]
    archives = archives_of(runs)
    known = judgements or {}
    plain = [
        {
            **run_data(name, run, known.get(run.files.path), step=archives.step, live=live),
            "teams": teams,
        }
        for name, run, teams in zip(names, runs, archives.teams, strict=True)
    ]
    title = names[0] if len(names) == 1 else common.name
    data = {
        "version": __version__,
        "title": title,
        "heading": heading(runs),
        "note": note,
        "live": live,
        "playground": page_data(),
        "runs": plain,
    }
    playground = without_engine(Playground().html()).encode()
    blobs = {**archives.blobs, "playground": playground}
    return render_page(
        "explorer",
        f"{title} - matrixworld",
        data,
        blobs,
        opens=["playground"],
        asks=live is not None,
    )


# fmt: off
NUMBERS = (
    "One", "Two", "Three", "Four", "Five", "Six", "Seven", "Eight", "Nine", "Ten", "Eleven",
    "Twelve",
)
# fmt: on


def heading(runs: Sequence[SavedRun]) -> str:
    """Return what a page shows in words, such as "Three races: predators and prey"."""
    kind = "race" if all(run.settings.is_race for run in runs) else "run"
    words = f"{NUMBERS[len(runs) - 1]} {kind}{'s' if len(runs) > 1 else ''}"
    games = {variant_name(run.settings.world.rules) for run in runs}
    if len(games) > 1 or not games <= VARIANT_TEXTS.keys():
        return words
    title = VARIANT_TEXTS[games.pop()].title.partition(":")[0]
    return f"{words}: {title[0].lower()}{title[1:]}"


# ---- A run ---------------------------------------------------------------------------------------

MOST_POINTS = 6000
"""The most points of a training curve; a longer one has means of neighbouring epochs."""


def run_data(
    name: str,
    run: SavedRun,
    judgement: analysis.Judgement | None = None,
    *,
    step: int = 1,
    live: str | None = None,
) -> dict[str, Any]:
    """Return what a page shows of a run, without its teams.

    A race without `judgement` is judged here, unless the page is `live`. The page holds the genomes
    of every generation by a `step`.
    """
    settings, payoff = run.settings, run.payoff()
    teams = [run.teams[team] for team in TEAMS]
    shape = tuple(1 if isinstance(team, str) else len(team.genomes) for team in teams)
    race = settings.is_race
    return {
        "name": name,
        "schedule": settings.schedule.name if race else "one team",
        "learning": list(settings.learning_teams),
        "seed": str(settings.seed),
        "world": settings.world.to_json(),
        "settings": plain_settings(settings),
        "training": training_curve(run.files.log(), settings),
        "payoff": plain_payoff(payoff, shape),
        # As text: a number of JavaScript holds 53 of the 64 bits.
        "seeds": [
            [str(evaluation_seed(settings.seed, g, h)) for h in range(shape[1])]
            for g in range(shape[0])
        ],
        "findings": findings(payoff, judgement, step=step, live=live) if race else None,
        "limits": too_few_episodes(payoff) if race else "",
    }


def plain_payoff(payoff: Payoff, shape: tuple[int, ...]) -> dict[str, Any]:
    """Return the results of all cells, placed in a matrix of all generations of the archives.

    ``first`` are the generations of the first cell that was played: the results of a single team
    are of its last generation.
    """
    first = [count - played for count, played in zip(shape, payoff.capture_rate.shape, strict=True)]
    return {
        "first": first,
        "shape": list(shape),
        "episodes": payoff.capture_rates.shape[2],
        "capture_rate": payoff.capture_rate.tolist(),
        # Nine digits identify every float32.
        "capture_rates": [
            [[float(f"{rate:.9g}") for rate in cell] for cell in row]
            for row in payoff.capture_rates.tolist()
        ],
        "lengths": payoff.lengths.tolist(),
    }


def training_curve(log: Mapping[str, NDArray[Any]], settings: RaceSettings) -> dict[str, Any]:
    """Return the capture rate over training, in lists of equal lengths.

    The learner is 0 for the pursuers, 1 for the evaders and 2 for both. A point is the mean of so
    many ``epochs``; ``window`` has the points of a moving average.
    """
    learner = (log["team"] == "evader").astype(int)
    schedule = settings.schedule
    both = isinstance(schedule, HallOfFame)
    if both:
        # Both teams learn from the same matches, and each logs a row of them.
        log = {name: column[learner == 0] for name, column in log.items()}
        learner = np.full(len(log["team"]), 2)
    every = -(-len(learner) // MOST_POINTS)
    starts = np.arange(0, len(learner), every)
    counts = np.diff([*starts, len(learner)])
    return {
        "capture_rate": np.round(np.add.reduceat(log["capture_rate"], starts) / counts, 4).tolist(),
        "generation": log["generation"][starts].tolist(),
        "learner": learner[starts].tolist(),
        "epochs": every,
        "window": max(1, round(curve_window(schedule) / every)),
        "matches": int(log["matches"][-1]) if len(learner) else 0,
    }


def plain_settings(settings: RaceSettings) -> list[dict[str, Any]]:
    """Return path, value and meaning of each setting that differs from the default."""
    usual = {leaf.path: leaf.value for leaf in leaves(_usual(settings))}
    return [
        {"name": leaf.path, "value": _shown(plain_values(leaf.value)), "help": leaf.help}
        for leaf in leaves(settings)
        if leaf.value != usual.get(leaf.path)
    ]


def _usual(settings: RaceSettings) -> RaceSettings:
    """Return the settings without options, of the same seed and schedule or opponent."""
    schedule = settings.schedule
    if isinstance(schedule, Against):
        alone = Against(team=schedule.team, opponent=schedule.opponent)
        return RaceSettings(schedule=alone, seed=settings.seed)
    played = schedule.replayed if isinstance(schedule, Yoked) else schedule
    named: Any = played.name  # a text stands for a section
    return RaceSettings(schedule=named, seed=settings.seed)


def _shown(value: Any) -> str:
    if isinstance(value, str):
        return value
    if value is None:
        return "default"
    return json.dumps(value)


# ---- What the analysis says ----------------------------------------------------------------------

BOARDS = 12
"""The most checkerboards on a page: the strongest ones."""
OF_GAME = (
    "weakest_intransitivity", "middle_intransitivity", "strongest_intransitivity",
    "effective_diversity",
)  # fmt: skip
"""Measures beside the spinning top."""


def findings(
    payoff: Payoff,
    judgement: analysis.Judgement | None = None,
    *,
    step: int = 1,
    live: str | None = None,
) -> dict[str, Any]:
    """Return judgement, headline numbers and curves of a race of at least 2 x 2 generations."""
    if live is not None:
        last = min(payoff.capture_rate.shape) - 1
        return {
            "headline": f"generation {last} so far",
            "table": [],
            "guided_minute": [],
            **curves(payoff),
        }
    matrix = payoff.capture_rate
    boards = strongest_checkerboards(matrix, count=BOARDS, margin=MARGIN)
    rows, columns = (kept_generations(size, step) for size in matrix.shape)
    judgement = judgement or analysis.judge(payoff.capture_rates, per_episode=True)
    return {
        "headline": analysis.headline(judgement),
        "numbers": headline_numbers(judgement),
        "table": [list(row) for row in analysis.judgement_table(judgement)],
        "reasons": analysis.explain(judgement).splitlines(),
        "checkerboards": plain_values(boards),
        "guided_minute": [
            stop._asdict() for stop in guided_minute(matrix, judgement, boards, (rows, columns))
        ],
        "margin": MARGIN,
        "game": game_numbers(payoff),
        **curves(payoff),
    }


def game_numbers(payoff: Payoff) -> list[str]:
    """Return what the race is as a game, with intervals, a line for each measure."""
    scores = analysis.read_payoffs(payoff.capture_rates, per_episode=True)
    rows = (analysis.MEASURES[name] for name in OF_GAME)
    return [f"{row.label}: {row.shown(row.of(scores))}" for row in rows]


def curves(payoff: Payoff) -> dict[str, Any]:
    """Return what is drawn of a race and claims nothing."""
    matrix, several = payoff.capture_rate, payoff.capture_rates.shape[2] >= 2
    ratings = analysis.elo(matrix)
    return {
        "spinning_top": plain_values(analysis.spinning_top(payoff.capture_rates))
        if several
        else None,
        "generalization": _with_bands(
            analysis.generalization(matrix), analysis.generalization_over_episodes, payoff
        ),
        # The triangles are the two halves of the payoff, which the page has.
        "ciao": {
            team: {
                "fading": plain_values(triangle.fading),
                "stripes": triangle.stripes,
                "period": triangle.period,
            }
            for team, triangle in zip(("pursuers", "evaders"), analysis.ciao(matrix), strict=True)
        },
        "ratings": {
            "offset": ratings.offset * analysis.ELO_POINTS,
            **_with_bands(ratings, analysis.elo_over_episodes, payoff, analysis.ELO_POINTS),
        },
    }


def _with_bands(
    means: Any, over_episodes: Callable[..., Any], payoff: Payoff, unit: float = 1.0
) -> dict[str, Any]:
    """Return means of both teams in a unit, with intervals where episodes allow them."""
    curves: dict[str, Any] = {
        team: {"mean": plain_values(getattr(means, team) * unit), "low": None, "high": None}
        for team in ("pursuers", "evaders")
    }
    if payoff.capture_rates.shape[2] >= 2:
        for curve, band in zip(curves.values(), over_episodes(payoff.capture_rates), strict=True):
            mean, low, high = (np.ravel(ends) for ends in (band.mean, band.low, band.high))
            # Where a band has no interval, it is as thin as the line.
            curve["low"] = plain_values(np.fmin(low, mean))
            curve["high"] = plain_values(np.fmax(high, mean))
    return curves


def too_few_episodes(payoff: Payoff) -> str:
    """Return what a small number of episodes means for the judgement; empty if they are enough."""
    episodes = payoff.capture_rates.shape[2]
    if episodes >= EPISODES_TO_JUDGE:
        return ""
    return (
        f"Each cell has {episodes} episode{'' if episodes == 1 else 's'}; it takes at least "
        f"{EPISODES_TO_JUDGE} to tell all conditions from noise."
    )


# ---- Teams ---------------------------------------------------------------------------------------

MOST_BYTES = 48 * 2**20
"""Genomes of a page, in bytes; base64 adds a third. A default race has 2.9 MB."""


class Archives(NamedTuple):
    """The teams of the runs of a page, as plain values that name their genomes in the blobs.

    A blob holds genomes as `packed` does, generation after generation. Every `step` generations
    have a genome on the page.
    """

    teams: tuple[dict[Team, dict[str, Any]], ...]
    blobs: dict[str, bytes]
    step: int


def archives_of(runs: Sequence[SavedRun], most: int = MOST_BYTES) -> Archives:
    """Return the teams of runs, with the genomes of as many generations as fit into so many bytes.

    The first and the last generation of each team are always there.
    """
    learned = [team for run in runs for team in run.teams.values() if isinstance(team, Population)]
    longest = max(len(team.genomes) for team in learned)

    def size(step: int) -> int:
        return sum(
            len(kept_generations(len(team.genomes), step)) * team.genomes[0].nbytes
            for team in learned
        )

    step = 1
    # The step is the same for all runs, so that linked generations exist everywhere.
    while size(step) > most and step < longest:
        step += 1
    blobs: dict[str, bytes] = {}
    teams = tuple(
        {team: _plain_team(run.teams[team], f"genomes-{n}-{team}", step, blobs) for team in TEAMS}
        for n, run in enumerate(runs)
    )
    return Archives(teams, blobs, step)


def kept_generations(count: int, step: int) -> list[int]:
    """Return every generation by a step, and the last one."""
    return sorted({*range(0, count, step), count - 1})


def _plain_team(
    team: TeamPolicy, identifier: str, step: int, blobs: dict[str, bytes]
) -> dict[str, Any]:
    """Return a team as plain values, and add its genomes to the blobs."""
    if isinstance(team, str):
        return {"script": team, "network": None, "kept": [0], "genomes": ""}
    network, kept = team.network, kept_generations(len(team.genomes), step)
    blobs[identifier] = packed(team.genomes[kept])
    return {
        "script": None,
        "network": {**plain_values(network), "genome_size": network.genome_size},
        "kept": kept,
        "genomes": identifier,
    }


def packed(genomes: Genomes) -> bytes:
    """Return genomes (generations, genes) as bytes from which a page makes the very same numbers.

    A generation differs from the one before it in the low bits of its numbers. So each is joined by
    exclusive or with that one, equal places of the float32 come together, and are compressed.
    """
    bits = np.ascontiguousarray(genomes, dtype="<f4").view("<u4")
    bits = np.concatenate([bits[:1], bits[1:] ^ bits[:-1]])
    planes = bits.view(np.uint8).reshape(-1, bits.itemsize).T
    return zlib.compress(planes.tobytes(), 9)
