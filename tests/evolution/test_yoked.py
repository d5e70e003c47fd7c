"""Yoked races: whom they meet, that they resume, and which races they cannot replay."""

import shutil
from dataclasses import replace
from functools import partial
from itertools import islice

import numpy as np
import pytest

from matrixworld.coevolution import TEAMS, SavedRun, available
from tiny_race import Listening, alternating, played, playing, results, stop_and_continue, tiny_race
from yoked_races import begun

SEED = tiny_race().seed


@pytest.fixture(scope="module")
def real(tmp_path_factory):
    return played(alternating("uniform"), tmp_path_factory.mktemp("races") / "real")


def yoked_to(run, directory, *, seed=SEED + 1, **options):
    """Return a race of another seed that is yoked to a run."""
    return begun(replace(run.settings, seed=seed), directory, run, **options)


def test_teams_meet_the_generations_of_the_other_race(real, tmp_path):
    listening, schedule = Listening(), real.settings.schedule
    archive = playing(yoked_to(real, tmp_path / "run"), listening).run().archive()
    calls = iter(listening.calls)
    for stage in range(schedule.n_stages):
        team, other = TEAMS[stage % 2], 1 - stage % 2
        theirs = real.teams[TEAMS[other]].genomes[: available(team, 1 + stage // 2)]
        for call in islice(calls, schedule.epochs(team)):
            assert np.array_equal(call[1 + other].genomes, theirs)
        own = archive[team][1 + stage // 2]
        assert not (own == real.teams[team].genomes).all(axis=1).any()
    assert len([*calls]) == len(archive["pursuer"])  # rows of the evaluation


@pytest.mark.parametrize("call", [0, 7])
def test_a_stopped_race_ends_as_if_never_stopped(real, tmp_path, call):
    yoked_to(real, tmp_path / "straight").run()
    stop_and_continue(partial(yoked_to, real), call, tmp_path / "run")
    assert results(tmp_path / "run") == results(tmp_path / "straight")


@pytest.mark.parametrize("changes", [{"seed": SEED}, {"world.rows": 7}])
def test_a_race_that_does_not_fit_is_refused(real, tmp_path, changes):
    settings = real.settings.changed({"seed": SEED + 1, **changes})
    with pytest.raises(ValueError, match="real: expected a finished race of these settings"):
        begun(settings, tmp_path / "run", real)
    shutil.copytree(real.path, tmp_path / "unfinished")
    (tmp_path / "unfinished/summary.json").unlink()
    with pytest.raises(ValueError, match="unfinished: expected a finished race"):
        yoked_to(SavedRun(tmp_path / "unfinished"), tmp_path / "run")
    assert not (tmp_path / "run").exists()
