"""Yoked races: whom they meet, that they resume, and which races they cannot replay."""

import shutil
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from matrixworld import rollout
from matrixworld._util.files import DamagedFileError
from matrixworld.coevolution import TEAMS, RaceSettings, Yoked, available, finish, resume, start
from matrixworld.coevolution.jobs import check_job
from matrixworld.coevolution.runs import race as races
from matrixworld.coevolution.schedules import DRAWN
from tiny_race import StopAt, alternating, check_resumes, directory_in_memory, tiny_race

SEED = tiny_race().seed


@pytest.fixture(scope="module")
def real():
    """A finished race, some of whose generations are discarded."""
    with directory_in_memory() as directory:
        yield finish(alternating("uniform", retention_episodes=1), directory / "real", threads=1)


def yoked_to(run: Any, **changes: Any) -> RaceSettings:
    """Return the settings of a race with another seed that is yoked to a run."""
    schedule = Yoked(**vars(run.settings.schedule), race=str(run.path))
    return replace(run.settings, **{"seed": SEED + 1, "schedule": schedule, **changes})


def test_a_race_yoked_to_itself_is_the_race(real, tmp_path, monkeypatch):
    """The opponents of each epoch, their order and all random numbers are those of a race."""
    monkeypatch.setattr(races, "race_to_replay", lambda settings: real)
    same = finish(yoked_to(real, seed=SEED), tmp_path / "same")
    for team in TEAMS:
        assert np.array_equal(same.teams[team].genomes, real.teams[team].genomes)
    assert np.array_equal(same.payoff().capture_rates, real.payoff().capture_rates)
    log, expected = same.log(), real.log()
    assert all(np.array_equal(log[name], expected[name]) for name in expected)


def test_teams_meet_the_generations_of_the_other_race(real, tmp_path):
    met = []

    def play(config, pursuers, evaders, matches, **options):
        met.append((pursuers.genomes, evaders.genomes))
        return rollout(config, pursuers, evaders, matches, **options)

    run = start(yoked_to(real), tmp_path / "run", play=play)
    for stage in range(run.n_stages):
        met.clear()
        run.learn(stage)
        team, other = TEAMS[stage % 2], 1 - stage % 2
        theirs = real.teams[TEAMS[other]].genomes[: available(team, 1 + stage // 2)]
        assert len(met) > 1  # epochs, and the comparison with the previous genome
        assert all(np.array_equal(genomes[other], theirs) for genomes in met)
        assert not (run.archive[team][-1] == real.teams[team].genomes).all(axis=1).any()


@pytest.mark.parametrize("call", [0, 7])
def test_a_stopped_race_ends_as_if_never_stopped(real, tmp_path, call):
    check_resumes(yoked_to(real), call, tmp_path / "run")


def test_what_is_replayed_must_not_change_on_the_way(real, tmp_path):
    source = Path(shutil.copytree(real.path, tmp_path / "source"))
    settings = yoked_to(real, schedule=replace(yoked_to(real).schedule, race=str(source)))
    with pytest.raises(KeyboardInterrupt):
        start(settings, tmp_path / "run", play=StopAt(9)).run()
    # Another race, of the same settings and a third seed, has taken its place.
    source.rename(tmp_path / "moved")
    finish(replace(real.settings, seed=SEED + 2), source)
    with pytest.raises(DamagedFileError, match=r"source: expected the race that .* got another"):
        resume(tmp_path / "run").run()
    shutil.rmtree(source)
    with pytest.raises(ValueError, match="race: expected a finished race to replay, got .*source"):
        check_job({"run": settings}, tmp_path, 1)
    (tmp_path / "moved").rename(source)
    payoff = resume(tmp_path / "run").run()
    shutil.rmtree(source)  # a finished race needs it no more
    assert np.array_equal(resume(tmp_path / "run").run().capture_rates, payoff.capture_rates)


@pytest.mark.parametrize(
    ("changes", "says"),
    [
        ({"seed": SEED}, f"expected a race of another seed than {SEED}, got .*real"),
        ({"world.rows": 7}, "expected a race with world.rows 7, as the yoked one, got 6 in .*real"),
        ({"policy.hidden": 3}, r"with policy.hidden \[3\], as the yoked one, got \[4\] in"),
        ({"schedule.generations": 9}, "with schedule.generations 9, as the yoked one, got 4 in"),
        ({"schedule.evaders_meet": "latest"}, "evaders_meet.rule latest, .* got uniform in"),
        ({"schedule.race": "elsewhere"}, "expected a finished race to replay, got elsewhere"),
    ],
)
def test_a_race_that_does_not_fit_is_refused(real, tmp_path, changes, says):
    settings = yoked_to(real).changed(changes)
    with pytest.raises(ValueError, match=rf"^schedule\.race: .*{says}"):
        start(settings, tmp_path / "run")
    with pytest.raises(ValueError, match=rf"^schedule\.race: .*{says}"):
        check_job({"run": settings}, tmp_path, 1)
    assert not (tmp_path / "run").exists()


@pytest.mark.parametrize("name", [*DRAWN, "maxsolve", "mypkg.mine:Sampler"])
def test_samplers_that_look_at_scores_are_refused(name):
    """Their choice would answer to the team that learns."""
    values = {"schedule": "yoked", "schedule.race": "x", "schedule.evaders_meet": name}
    if name in ("latest", "uniform", "round-robin", "hall-of-fame"):
        assert RaceSettings.of(values).schedule.name == "yoked-alternating"
    else:
        with pytest.raises(ValueError, match=rf"evaders_meet: .* without scores .* got {name}$"):
            RaceSettings.of(values)
