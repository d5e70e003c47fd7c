"""Yoked races: whom they meet, that they resume, and which races they cannot replay."""

import shutil
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from matrixworld import rollout
from matrixworld.coevolution import TEAMS, SavedRun, available
from tiny_race import alternating, played, results, stop_and_continue, tiny_race
from yoked_races import YokedRace

SEED = tiny_race().seed


@pytest.fixture(scope="module")
def real(tmp_path_factory: pytest.TempPathFactory) -> SavedRun:
    """A finished race."""
    return played(alternating("uniform"), tmp_path_factory.mktemp("races") / "real")


def yoked_to(run: SavedRun, directory: Path, *, seed: int = SEED + 1, **options: Any) -> YokedRace:
    """Return a race of another seed that is yoked to a run."""
    return YokedRace(replace(run.settings, seed=seed), directory, run, **options)


class Watched(YokedRace):
    """A race that lists, stage by stage, the genomes of both teams in its matches."""

    def learn(self, stage: int) -> None:
        self.met: list[list[Any]] = [*getattr(self, "met", []), []]
        super().learn(stage)


def test_teams_meet_the_generations_of_the_other_race(real: SavedRun, tmp_path: Path) -> None:
    def play(config: Any, pursuers: Any, evaders: Any, matches: Any, **options: Any) -> Any:
        run.met[-1].append((pursuers.genomes, evaders.genomes))
        return rollout(config, pursuers, evaders, matches, **options)

    settings = replace(real.settings, seed=SEED + 1)
    run = Watched(settings, tmp_path / "run", real, threads=1, play=play)
    archive = run.run().archive()
    for stage, met in enumerate(run.met):
        team, other = TEAMS[stage % 2], 1 - stage % 2
        theirs = real.teams[TEAMS[other]].genomes[: available(team, 1 + stage // 2)]
        epochs = met[: real.settings.schedule.epochs(team)]
        assert all(np.array_equal(genomes[other], theirs) for genomes in epochs)
        own = archive[team][1 + stage // 2]
        assert not (own == real.teams[team].genomes).all(axis=1).any()
    assert stage + 1 == settings.schedule.n_stages


@pytest.mark.parametrize("call", [0, 7])
def test_a_stopped_race_ends_as_if_never_stopped(real: SavedRun, tmp_path: Path, call: int) -> None:
    yoked_to(real, tmp_path / "straight").run()
    stop_and_continue(partial(yoked_to, real), call, tmp_path / "run")
    assert results(tmp_path / "run") == results(tmp_path / "straight")


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
