"""Yoked races: whom they meet, that they resume, and which races they cannot replay."""

import shutil
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from matrixworld import rollout
from matrixworld._util.files import DamagedFileError
from matrixworld.coevolution import TEAMS, SavedRun, available, finish
from tiny_race import StopAt, alternating, directory_in_memory, results, tiny_race
from yoked_races import YokedRace

SEED = tiny_race().seed


@pytest.fixture(scope="module")
def real() -> Iterator[SavedRun]:
    """A finished race."""
    with directory_in_memory() as directory:
        yield finish(alternating("uniform"), directory / "real", threads=1)


def yoked_to(run: SavedRun, directory: Path, *, seed: int = SEED + 1, **options: Any) -> YokedRace:
    """Return a race of another seed that is yoked to a run."""
    return YokedRace(replace(run.settings, seed=seed), directory, run, threads=1, **options)


def test_teams_meet_the_generations_of_the_other_race(real: SavedRun, tmp_path: Path) -> None:
    met = []

    def play(config: Any, pursuers: Any, evaders: Any, matches: Any, **options: Any) -> Any:
        met.append((pursuers.genomes, evaders.genomes))
        return rollout(config, pursuers, evaders, matches, **options)

    run = yoked_to(real, tmp_path / "run", play=play)
    for stage in range(run.n_stages):
        met.clear()
        run.learn(stage)
        team, other = TEAMS[stage % 2], 1 - stage % 2
        theirs = real.teams[TEAMS[other]].genomes[: available(team, 1 + stage // 2)]
        assert len(met) > 1  # epochs
        assert all(np.array_equal(genomes[other], theirs) for genomes in met)
        assert not (run.archive[team][-1] == real.teams[team].genomes).all(axis=1).any()


@pytest.mark.parametrize("call", [0, 7])
def test_a_stopped_race_ends_as_if_never_stopped(real: SavedRun, tmp_path: Path, call: int) -> None:
    yoked_to(real, tmp_path / "straight").run()
    with pytest.raises(KeyboardInterrupt):
        yoked_to(real, tmp_path / "run", play=StopAt(call)).run()
    yoked_to(real, tmp_path / "run").run()
    assert results(tmp_path / "run") == results(tmp_path / "straight")


def test_what_is_replayed_must_not_change_on_the_way(real: SavedRun, tmp_path: Path) -> None:
    with pytest.raises(KeyboardInterrupt):
        yoked_to(real, tmp_path / "run", play=StopAt(9)).run()
    again = finish(replace(real.settings, seed=SEED + 2), tmp_path / "again")
    with pytest.raises(DamagedFileError, match=r"again: expected the race that .* got another"):
        yoked_to(again, tmp_path / "run")


@pytest.mark.parametrize("changes", [{"seed": SEED}, {"world.rows": 7}])
def test_a_race_that_does_not_fit_is_refused(
    real: SavedRun, tmp_path: Path, changes: dict[str, Any]
) -> None:
    settings = real.settings.changed({"seed": SEED + 1, **changes})
    with pytest.raises(ValueError, match="real: expected a finished race of these settings"):
        YokedRace(settings, tmp_path / "run", real)
    shutil.copytree(real.path, tmp_path / "unfinished")
    (tmp_path / "unfinished/summary.json").unlink()
    with pytest.raises(ValueError, match="unfinished: expected a finished race"):
        yoked_to(SavedRun(tmp_path / "unfinished"), tmp_path / "run")
    assert not (tmp_path / "run").exists()
