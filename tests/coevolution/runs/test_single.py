"""Runs in which one team learns against fixed opponents."""

from dataclasses import replace

import numpy as np
import pytest

from matrixworld import coevolution
from matrixworld.coevolution import Race, SingleTeam, open_run
from matrixworld.coevolution.storage import last_generation
from matrixworld.world.policy import Network, Population
from tiny_race import StopAt, results, tiny_race, tiny_single


@pytest.mark.parametrize(("team", "against"), [("pursuer", "fleer"), ("evader", "random")])
def test_against_scripts(tmp_path, team, against):
    run = coevolution.start(tiny_single(team=team, opponent=against), tmp_path / "run")
    payoff = run.run()
    assert payoff.capture_rates.shape == (1, 1, 3)
    archive = run.files.archive()
    other = "evader" if team == "pursuer" else "pursuer"
    assert len(archive[team]) == 4
    assert len(archive[other]) == 0
    log = run.files.log()
    assert set(log["team"]) == {team}
    assert log["epoch"].tolist() == [0, 1, 2, 3, 4]
    saved = open_run(tmp_path / "run")
    assert saved.teams[other] == against
    assert saved.record(episode=2).length == payoff.lengths[0, 0, 2]
    summary = run.files.summary()
    assert summary["training_matches"] == 20
    assert summary["length"] == payoff.lengths.mean()
    assert summary["length_high"] is None or summary["length_high"] <= run.settings.world.max_steps
    assert summary["capture_rate_std"] == pytest.approx(payoff.capture_rates.std())


def test_the_interval_ends_at_possible_values_and_needs_different_episodes(tmp_path):
    run = SingleTeam(tiny_single(), tmp_path / "run")
    payoff = run.run()
    shape = (1, 1, 20)
    # 2.0930 is the 97.5% quantile of Student's t with 19 degrees of freedom, from a table.
    for rates, ends in (
        (np.arange(20).reshape(shape) == 0, (0.0, 0.05 + 2.0930 * 0.05)),
        (np.arange(20).reshape(shape) > 0, (0.95 - 2.0930 * 0.05, 1.0)),
    ):
        summary = run.summary(replace(payoff, capture_rates=rates.astype(np.float32)))
        got = summary["capture_rate_low"], summary["capture_rate_high"]
        assert got == pytest.approx(ends, rel=1e-4)
    for rates in (np.ones(shape), np.ones((1, 1, 1))):
        summary = run.summary(replace(payoff, capture_rates=rates.astype(np.float32)))
        assert (summary["capture_rate_low"], summary["capture_rate_high"]) == (None, None)


@pytest.fixture
def other_run(tmp_path):
    """A race with another network than that of the single runs."""
    race = Race(tiny_race(hidden=(3, 2), activation="tanh"), tmp_path / "race")
    race.run()
    return race


@pytest.mark.parametrize("team", ["pursuer", "evader"])
def test_against_a_run(tmp_path, other_run, team):
    other = "evader" if team == "pursuer" else "pursuer"
    settings = tiny_single(team=team, opponent=str(other_run.files.path))
    run = SingleTeam(settings, tmp_path / "run", play=StopAt(4))
    with pytest.raises(KeyboardInterrupt):
        run.run()
    straight = SingleTeam(settings, tmp_path / "straight")
    straight.run()
    for path in other_run.files.path.iterdir():  # a run is complete in itself
        path.unlink()
    resumed = coevolution.resume(tmp_path / "run")
    resumed.run()
    assert results(tmp_path / "run") == results(tmp_path / "straight")
    assert np.array_equal(resumed.genomes(other), other_run.genomes(other)[-1:])
    saved = open_run(tmp_path / "run")
    assert saved.teams[other].network == other_run.network
    assert saved.teams[team].network == settings.network
    lengths = saved.payoff().lengths
    assert [saved.record(episode=number).length for number in range(3)] == list(lengths.flat)


def test_several_opponents_take_turns(tmp_path):
    settings = tiny_single(team="evader")
    genomes = np.stack([settings.network.initial(np.random.default_rng(i)) for i in range(2)])
    opponents = Population(genomes, settings.network)
    run = SingleTeam(settings, tmp_path / "run", opponents=opponents)
    payoff = run.run()
    assert run.files.log()["opponent"].tolist() == [0, 1, 0, 1, 0]
    assert payoff.capture_rates.shape == (2, 1, 3)
    assert run.total_matches() == 5 * 4 + 2 * 3
    assert coevolution.resume(tmp_path / "run").settings.schedule.opponent == "given as genomes"


@pytest.mark.parametrize("learner", ["es", "ga"])
def test_warm_start(tmp_path, learner):
    first = SingleTeam(tiny_single(team="evader"), tmp_path / "first")
    first.run()
    champion = last_generation(tmp_path / "first", "evader").genomes[0]
    assert np.array_equal(champion, first.genomes("evader")[-1])
    changes = {"team": "evader", "learner": learner}
    if learner == "ga":
        changes["elites"] = 0  # elites may outlive the run
    settings = tiny_single(**changes, start=str(tmp_path / "first"))
    second = SingleTeam(settings, tmp_path / "second")
    assert np.array_equal(second.genomes("evader")[0], champion)
    second.run()
    given = tiny_single(**changes)
    third = SingleTeam(given, tmp_path / "third", start=champion)
    third.run()
    assert np.array_equal(second.genomes("evader"), third.genomes("evader"))
    assert not np.array_equal(second.genomes("evader")[-1], champion)


def test_bad_opponents_and_starts_are_refused(tmp_path, other_run):
    settings, run = tiny_single(), tmp_path / "run"
    with pytest.raises(FileNotFoundError, match="holds no run"):
        SingleTeam(tiny_single(opponent=str(tmp_path / "nowhere")), run)
    wide = Network(hidden=(4,), fov=5)
    others = Population(np.zeros((1, wide.genome_size), dtype=np.float32), wide)
    with pytest.raises(ValueError, match="^opponents: "):
        SingleTeam(settings, run, opponents=others)
    size = settings.network.genome_size
    for start in (np.zeros(size - 1), np.full(size, np.nan)):
        with pytest.raises(ValueError, match="^start: "):
            SingleTeam(settings, run, start=start)
    with pytest.raises(ValueError, match="^start: "):  # a genome of another network
        SingleTeam(tiny_single(start=str(other_run.files.path)), run)
    assert not run.exists()
    SingleTeam(settings, run).run()
    with pytest.raises(ValueError, match="genomes of evaders"):
        last_generation(run, "evader")
