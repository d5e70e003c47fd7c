"""Runs with a learner and samplers of one's own: all schedules, interruptions, reading."""

from __future__ import annotations

import os
import subprocess
import sys
import traceback

import numpy as np
import pytest

import own_code
from matrixworld.coevolution import (
    ArchivedOpponents,
    OwnOpponents,
    PluginError,
    finish,
    resume,
    start,
)
from matrixworld.coevolution.schedules import ALL_SCHEDULES, ALTERNATING, HALL_OF_FAME
from tiny_race import StopAt, check_resumes, directory_in_memory, tiny_race, tiny_single

LEARNER = {"learner": "own_code:HillClimber", "settings": {"sigma": 0.2}}
SAMPLERS_OF_BOTH = {
    "pursuers_meet": OwnOpponents(code="own_code:Hardest", settings={"forget": 0.25}),
    "evaders_meet": "own_code:Fixed",
}
MORE = {
    ALTERNATING: {**SAMPLERS_OF_BOTH, "opponents": 2},
    HALL_OF_FAME: {**SAMPLERS_OF_BOTH, "contemporaries": 1, "hall_sample": 2},
}
RUNS = {
    **{name: tiny_race(schedule=name, **LEARNER, **MORE.get(name, {})) for name in ALL_SCHEDULES},
    "retention": tiny_race(retention_episodes=2, **LEARNER),
    "arrays changed in place": tiny_race(
        retention_episodes=2, learner="own_code:ReturnsViews", settings={"sigma": 0.2}
    ),
    "pursuers alone": tiny_single(**LEARNER),
    "evaders alone": tiny_single(team="evader", **LEARNER),
}
every_run = pytest.mark.parametrize("kind", RUNS)


@pytest.fixture
def tmp_path():
    """A directory for many files, which are all synced."""
    with directory_in_memory() as directory:
        yield directory


@every_run
def test_each_interruption_is_resumed_bit_for_bit(kind, tmp_path):
    """Stopped at every call of `rollout`."""
    calls = StopAt(1000)
    start(RUNS[kind], tmp_path / "counted", play=calls).run()
    for call in range(1000 - calls.left):
        check_resumes(RUNS[kind], call, tmp_path / str(call))
    assert call >= 4


@every_run
def test_the_learner_learns_by_its_own_rule(kind, tmp_path):
    run = start(RUNS[kind], tmp_path / "run", threads=1)
    run.run()
    for team in run.settings.learning_teams:
        assert isinstance(run.learners[team].made, own_code.HillClimber)
        genomes = run.genomes(team)
        assert np.isfinite(genomes).all()
        assert len(np.unique(genomes, axis=0)) > 1
    assert (tmp_path / "run" / "config.json").read_text().count(run.settings.learner.code) == 1


def test_the_package_s_own_class_by_its_path_gives_the_same_run(tmp_path):
    """Built-in samplers and those of one's own go the same way."""
    alternating = {"schedule": ALTERNATING, "opponents": 2, "evaders_meet": "latest"}
    archives = [
        start(tiny_race(pursuers_meet=name, **alternating), tmp_path / name, threads=1).run()
        for name in ("latest", "matrixworld.coevolution.opponents:Latest")
    ]
    assert np.array_equal(archives[0].capture_rates, archives[1].capture_rates)


def test_an_archive_of_ones_own(tmp_path):
    """A function that makes an `ArchiveSampler`: the archive plays its matches."""
    race = {"schedule": ALTERNATING, "opponents": 2, "generations": 4}
    own = {"evaders_meet": OwnOpponents(code="own_code:layered", settings={"layers": 2})}
    built_in = {"evaders_meet": ArchivedOpponents(archive="lapca", size=2)}
    runs = [
        start(tiny_race(**race, **changes), tmp_path / name, threads=1)
        for name, changes in {"own": own, "lapca": built_in}.items()
    ]
    first, second = (run.run() for run in runs)
    assert np.array_equal(first.capture_rates, second.capture_rates)
    assert runs[0].total_matches() == runs[1].total_matches()
    logs = [(tmp_path / name / "log.csv").read_bytes() for name in ("own", "lapca")]
    assert logs[0] == logs[1]


def test_cma_of_the_package_by_its_path(tmp_path):
    """The interface is that of the package's own classes."""
    small = {"hidden": (), "fov": 3}
    path = {"learner": "matrixworld.coevolution:CmaEs", "settings": {"sigma": 0.1}}
    own = finish(tiny_race(**small, **path), tmp_path / "own", threads=1)
    built_in = finish(tiny_race(**small, learner="cma", sigma=0.1), tmp_path / "cma", threads=1)
    for team in ("pursuer", "evader"):
        assert np.array_equal(own.teams[team].genomes, built_in.teams[team].genomes)


READ = """
import sys
from matrixworld.coevolution import open_run, resume
run = open_run(sys.argv[1])
assert run.settings.learner.code == "mine:Learner", run.settings
assert dict(run.settings.learner.settings) == {"sigma": 0.2}
assert run.record().length and run.payoff().capture_rate.size
assert "mine" not in sys.modules
try:
    resume(sys.argv[1])
except ValueError as error:
    print(error)
"""


def test_a_run_is_read_without_its_code(tmp_path, monkeypatch):
    monkeypatch.syspath_prepend(tmp_path)
    (tmp_path / "mine.py").write_text("from own_code import HillClimber as Learner\n")
    settings = tiny_race(learner="mine:Learner", settings={"sigma": 0.2})
    finish(settings, tmp_path / "run", threads=1)
    (tmp_path / "mine.py").unlink()
    before = {path.name: path.read_bytes() for path in (tmp_path / "run").iterdir()}
    command = [sys.executable, "-c", READ, tmp_path / "run"]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    assert done.stdout == (
        "learner: expected a module that can be imported, got 'mine:Learner' (No module named "
        "'mine'); install the package that has it, or put its folder on PYTHONPATH\n"
    )
    assert {path.name: path.read_bytes() for path in (tmp_path / "run").iterdir()} == before


def test_nothing_is_written_if_the_code_is_missing_or_refuses(tmp_path):
    for changes, message in [
        ({"learner": "nowhere:Learner"}, "learner: expected a module that can be imported"),
        (
            {**LEARNER, "settings": {"sigma": -1}},
            "learner own_code:HillClimber: expected settings that it",
        ),
        (
            {**LEARNER, "settings": {"seed": 1}},
            "learner own_code:HillClimber: expected its settings",
        ),
        (
            {**MORE[ALTERNATING], "schedule": ALTERNATING, "evaders_meet": "own_code:Fixd"},
            "opponent sampler: expected the name of an object in own_code, got 'Fixd'",
        ),
    ]:
        with pytest.raises(ValueError, match=message):
            start(tiny_race(**changes), tmp_path / "run")
    assert not os.listdir(tmp_path)


def test_an_error_in_a_learner_names_it_and_keeps_the_traceback(tmp_path):
    run = start(tiny_race(learner="own_code:Fails"), tmp_path / "run", threads=1)
    with pytest.raises(PluginError, match="^learner own_code:Fails: tell: Zero.* luck$") as caught:
        run.run()
    # The last frame is that of the learner's own code.
    assert traceback.extract_tb(caught.value.__cause__.__traceback__)[-1].name == "tell"
    # The files hold the last finished stage, as after any other error.
    assert resume(tmp_path / "run").stage == 0


def test_an_error_in_a_sampler_names_it(tmp_path):
    settings = tiny_race(schedule=ALTERNATING, pursuers_meet="own_code:Crash")
    with pytest.raises(
        PluginError, match="^opponent sampler own_code:Crash: sample: KeyError: 'gen"
    ):
        start(settings, tmp_path / "run", threads=1).run()
