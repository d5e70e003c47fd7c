"""New runs: all that can be wrong is checked, and then the directory is made."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from matrixworld._util import checks
from matrixworld._util.plugins import no_exit
from matrixworld.coevolution import types
from matrixworld.coevolution.games.operators import are_texts, as_genome
from matrixworld.coevolution.games.pursuit import Player, Pursuit, PythonFile, player
from matrixworld.coevolution.runs.places import new_directory
from matrixworld.coevolution.runs.stored import StoredRun, last_generation
from matrixworld.coevolution.runs.writer import RunWriter
from matrixworld.coevolution.settings.race_settings import RaceSettings
from matrixworld.coevolution.settings.schedules import GIVEN, Against
from matrixworld.coevolution.training.training import Training
from matrixworld.coevolution.types import Genome, Team


@no_exit("create")
def create(
    settings: RaceSettings,
    directory: str | Path,
    *,
    opponents: Any = None,
    start: ArrayLike | None = None,
) -> StoredRun:
    """Make the directory of a run, as of its stage 0: nothing is played yet.

    Parameters
    ----------
    settings : RaceSettings
        Settings of the run.
    directory : str or Path
        A new or empty directory; one that holds a run of the same settings is left as it is.
    opponents : population or player, optional
        Opponents of a team that learns alone, in place of `schedule.opponent`. In pursuit genomes,
        or what `matrixworld.player` takes that a run can keep: a script, a file, a line of text.
    start : array_like of float32 or object, optional
        Genome (genes,) that such a team starts from, in place of `schedule.start`; an object, or
        its text as an array (1,), in a game whose genomes are objects.

    Returns
    -------
    StoredRun
        The files of the run.

    Raises
    ------
    TypeError
        If `settings` are no `RaceSettings`, or `start` is no array of numbers.
    FileExistsError, FileNotFoundError, ValueError, PluginError
        If the directory holds anything else, a directory of the settings holds no run, opponents or
        the genome to start from do not fit the game, or code of your own fails or refuses its
        settings. Nothing is written in any of these cases.
    """
    if not isinstance(settings, RaceSettings):
        raise TypeError(f"settings: expected RaceSettings, got {checks.shown(settings)}")
    path = Path(directory)
    if isinstance(opponents, Player) and isinstance(settings.schedule, Against):
        opponents = player(opponents, types.other(settings.schedule.team))
        if opponents.options.fov is not None:
            got = f"fov {opponents.options.fov}"
            raise ValueError(f"opponents: expected a player without a view of its own, got {got}")
    named = getattr(opponents, "given", opponents)  # what a player was made of
    if isinstance(named, str | Path) and not settings.is_race:
        settings, opponents = settings.changed({"schedule.opponent": str(named)}), None
    arrays = {"opponent": opponents, "start": start}
    replaced = [name for name, array in arrays.items() if array is not None]
    if settings.is_race and replaced:
        raise ValueError(f"{replaced[0]}: expected None in a race, whose teams meet each other")
    if StoredRun(path).exists and not replaced:
        check_same(StoredRun(path), settings)
        return StoredRun(path)
    # Everything that can be wrong is checked before the directory is made.
    begin: Genome | None = None
    rivals: Any = None
    more: dict[str, Any] = {}
    if isinstance(settings.schedule, Against):
        rivals = load_opponents(settings, opponents)
        begin = load_start(settings, start)
        # config.json must not name opponents that were not used.
        settings = settings.changed({f"schedule.{name}": GIVEN for name in replaced})
        if shape := settings.evaluation_game.shape_of(rivals):
            more["opponent_policy"] = shape
        if isinstance(text := getattr(rivals, "given", None), PythonFile):
            more["opponent_program"] = text._asdict()
    training = Training(settings, begin=begin, rivals=lambda team: rivals)
    archive: dict[Team, Any] = dict(training.archive)
    if isinstance(settings.schedule, Against) and hasattr(rivals, "genomes"):
        archive[types.other(settings.schedule.team)] = rivals.genomes
    with new_directory(path) as place:
        RunWriter(place).begin(settings, archive, training.parts(), **more)
    return StoredRun(path)


def load_opponents(settings: RaceSettings, opponents: Any = None) -> Any:
    """Return the opponents of a team that learns alone, by default those of its settings.

    FileNotFoundError or ValueError if there are none, or they do not fit the game.
    """
    schedule = settings.schedule
    game = settings.evaluation_game
    assert isinstance(schedule, Against)
    team = types.other(schedule.team)
    is_run = schedule.opponent == GIVEN or Path(schedule.opponent).is_dir()
    if opponents is None and isinstance(game, Pursuit) and not is_run:
        try:
            opponents = game.opponent_named(team, schedule.opponent)
        except (TypeError, ValueError) as error:
            raise ValueError(f"schedule.opponent: {error}") from error
    elif opponents is None:
        opponents = _last(settings, schedule.opponent, team)
    elif isinstance(game, Pursuit):
        opponents = game.opponent_kept(team, opponents)
    game.check_opponents(team, opponents)
    return opponents


def load_start(settings: RaceSettings, start: ArrayLike | None = None) -> Genome | None:
    """Return the genome that a team which learns alone starts from; None for an untrained one.

    By default it is that of the settings. TypeError, FileNotFoundError or ValueError if it is no
    genome, or does not fit the game.
    """
    schedule = settings.schedule
    game = settings.evaluation_game
    assert isinstance(schedule, Against)
    if start is None and schedule.start is not None:
        population = _last(settings, schedule.start, schedule.team)
        game.check_start(schedule.team, population)
        start = population.genomes[0]
    if start is None:
        return None
    if game.texts:
        if are_texts(start, (1,)):
            return np.asarray(start)
        return as_genome(game.operators[schedule.team].text(start, "start"))
    genome = checks.check_floats("start", start, np.float32)
    shape = (game.genome_size(schedule.team),)
    if genome.shape != shape:
        raise ValueError(f"start: expected a genome of shape {shape}, got {genome.shape}")
    if not np.isfinite(genome).all():
        wrong = genome[~np.isfinite(genome)][0]
        raise ValueError(f"start: expected finite genes, got {wrong}")
    return genome


def _last(settings: RaceSettings, directory: str, team: Team) -> Any:
    """Return the last genome of a team in a run of the same game; ValueError for another one."""
    if directory == GIVEN:
        raise ValueError(f"schedule: expected a run directory, got {GIVEN!r}, without the genomes")
    game = StoredRun(directory).settings.game
    if game.source != settings.game.source:
        expected = f"a run of {settings.game.source}"
        raise ValueError(f"{directory}: expected {expected}, got one of {game.source}")
    return last_generation(directory, team)


def check_same(run: StoredRun, expected: RaceSettings) -> None:
    """Raise ValueError if a run has other settings than expected."""
    if run.settings == expected:
        return
    theirs = run.settings.values()
    asked = expected.values()
    different = [path for path in {**theirs, **asked} if theirs.get(path) != asked.get(path)]
    raise ValueError(f"{run.path}: holds a run with other settings: {', '.join(different)}")
