"""Runs with a learner and samplers of one's own: all schedules, interruptions, errors."""

import sys

import numpy as np
import pytest
from matrixworld.coevolution.schedules import ArchivedOpponents

from matrixworld.coevolution import (
    TEAMS,
    OwnOpponents,
    PluginError,
    resume,
    start,
)
from own_code import HillClimber
from tiny_race import StopAt, alternating, check_resumes, hall_of_fame, tiny_race, tiny_single

LEARNER = {"learner": "own_code:HillClimber", "settings": {"sigma": 0.2}}
SAMPLERS_OF_BOTH = {
    "pursuers_meet": OwnOpponents(code="own_code:Hardest", settings={"forget": 0.25}),
    "evaders_meet": "own_code:Fixed",
}
RUNS = {
    "in turns": alternating(**LEARNER, **SAMPLERS_OF_BOTH, generations=2),
    "hall of fame": hall_of_fame(**LEARNER, **SAMPLERS_OF_BOTH, generations=2),
    "a genome changed in place": tiny_race(
        retention_episodes=2, learner="own_code:InPlace", settings={"sigma": 0.2}
    ),
    "evaders alone": tiny_single(team="evader", **LEARNER),
}


@pytest.mark.parametrize("kind", RUNS)
def test_each_interruption_is_resumed_bit_for_bit(kind, tmp_path):
    """Stopped at every call of `rollout`."""
    calls = StopAt(1000)
    run = start(RUNS[kind], tmp_path / "counted", play=calls)
    run.run()
    for team in run.settings.learning_teams:
        assert isinstance(run.learners[team], HillClimber)
        genomes = run.genomes(team)
        assert np.isfinite(genomes).all()
        assert len(np.unique(genomes, axis=0)) > 1
    for call in range(1000 - calls.left):
        check_resumes(RUNS[kind], call, tmp_path / str(call))
    assert call >= 4


@pytest.mark.parametrize(
    ("own", "built_in"),
    [
        (
            alternating(evaders_meet="matrixworld.coevolution.opponents:Latest"),
            alternating(evaders_meet="latest"),
        ),
        (
            # A function that makes an `ArchiveSampler`: the archive plays its matches.
            alternating(evaders_meet=OwnOpponents(code="own_code:layered", settings={"layers": 2})),
            alternating(evaders_meet=ArchivedOpponents(archive="lapca", size=2)),
        ),
        (
            tiny_race(learner="matrixworld.coevolution:CmaEs", settings={"sigma": 0.1}, hidden=()),
            tiny_race(learner="cma", sigma=0.1, hidden=()),
        ),
    ],
    ids=["sampler", "archive", "learner"],
)
def test_a_class_of_the_package_by_its_path_gives_the_same_run(own, built_in, tmp_path):
    runs = [start(own, tmp_path / "own"), start(built_in, tmp_path / "built-in")]
    assert runs[0].total_matches() == runs[1].total_matches()
    for run in runs:
        run.run()
    logs = [(tmp_path / name / "log.csv").read_bytes() for name in ("own", "built-in")]
    assert logs[0] == logs[1]
    for team in TEAMS:
        assert np.array_equal(runs[0].genomes(team), runs[1].genomes(team))


def test_an_error_in_a_learner_is_raised_as_it_is(tmp_path):
    run = start(tiny_race(learner="own_code:Fails"), tmp_path / "run", threads=1)
    with pytest.raises(ZeroDivisionError, match="^no luck") as caught:
        run.run()
    if sys.version_info >= (3, 11):
        assert caught.value.__notes__ == [f"in stage 1 of the run {tmp_path / 'run'}"]
    # The files hold the last finished stage, as after any other error.
    assert resume(tmp_path / "run").stage == 0


def test_a_learner_that_exits_does_not_end_the_program(tmp_path):
    run = start(tiny_race(learner="own_code:Exits"), tmp_path / "run", threads=1)
    with pytest.raises(PluginError, match="called exit"):
        run.run()
    assert resume(tmp_path / "run").stage == 0
