"""Races that become longer."""

import numpy as np
import pytest

from matrixworld._util.files import DamagedFileError
from matrixworld.coevolution import Run, open_run
from matrixworld.coevolution.evaluation.kept_scores import kept_scores
from matrixworld.coevolution.runs.play import lengthen
from tiny_race import StopAt, alternating, played, playing, results, tiny_race, tiny_single

LONG = {
    "es": tiny_race(generations=4),
    "ga": tiny_race(generations=4, learner="ga"),
    "hall-of-fame": tiny_race(generations=4, schedule="hall-of-fame", hall_sample=1),
    "psro": tiny_race(generations=4, schedule="psro"),
    "prioritized": alternating("prioritized-hard", retest_episodes=1),
}


def shorter(settings):
    return settings.changed({"schedule.generations": 2})


@pytest.mark.parametrize("kind", LONG)
def test_a_longer_race_is_the_same_as_one_that_was_long_from_the_beginning(kind, tmp_path):
    played(LONG[kind], tmp_path / "long")
    short = played(shorter(LONG[kind]), tmp_path / "short")
    assert short.payoff().matrix.shape == (3, 3)
    assert short.extend(4, threads=1).payoff().matrix.shape == (5, 5)
    assert results(tmp_path / "short") == results(tmp_path / "long")
    short.extend(4)  # nothing is left to play
    assert results(tmp_path / "short") == results(tmp_path / "long")


def test_a_run_that_was_extended_stays_as_it_was_first_read(tmp_path):
    short = open_run(played(tiny_race(generations=1), tmp_path / "race").path)
    longer = short.extend(2, threads=1)
    for run, last in ((short, 1), (longer, 2)):
        assert run.generation("pursuer", -1) == last
        genomes = run.teams["pursuer"].genomes
        np.testing.assert_array_equal(run.policy("pursuer").genome, genomes[-1])
        assert run.generation_at("pursuer", 10**6) == last
        episode = run.record(evader=0)
        np.testing.assert_array_equal(episode.positions, longer.record(last, 0).positions)
        with pytest.raises(IndexError, match=f"expected a generation from 0 to {last}"):
            run.policy("pursuer", last + 1)
        assert run.payoff().matrix.shape == (3, 3)  # what the files hold now


def test_a_longer_race_can_be_stopped_and_plays_new_cells_only(tmp_path):
    played(LONG["es"], tmp_path / "long")
    path = played(shorter(LONG["es"]), tmp_path / "short").path
    lengthen(path, 4)
    assert not open_run(path).finished
    # 2 pursuer and 3 evader epochs of two generations; then 3 rows of 2 cells and 2 rows of 5.
    for call in (0, 4, 10):
        with pytest.raises(KeyboardInterrupt):
            playing(Run(path, threads=1), StopAt(call)).run()
    with pytest.raises(KeyboardInterrupt):
        playing(Run(path, threads=1), StopAt(4)).run()
    assert not open_run(path).finished
    playing(Run(path, threads=1), StopAt(5)).run()
    assert results(path) == results(tmp_path / "long")


def test_scores_that_are_kept_are_those_of_the_last_generation(tmp_path):
    race = played(tiny_race(generations=1), tmp_path / "race")
    [before] = kept_scores([race])
    [after] = kept_scores([race.extend(2, threads=1)])
    for team in ("pursuers", "evaders"):
        assert before[team]["generations"] == [1]
        assert after[team]["generations"] == [2]
    assert kept_scores([race]) == [after]  # not played again
    file = race.path / "scores.json"
    written = file.stat().st_mtime_ns
    kept_scores([open_run(race.path)])
    assert file.stat().st_mtime_ns == written


def test_races_that_cannot_become_longer(tmp_path):
    race = played(tiny_race(), tmp_path / "race")
    with pytest.raises(ValueError, match="expected at least the 2 of"):
        race.extend(1)
    annealed = played(tiny_race(anneal=True), tmp_path / "annealed")
    with pytest.raises(ValueError, match=r"learner\.anneal: expected false"):
        annealed.extend(3)
    with pytest.raises(ValueError, match="expected a race, got a run of one team"):
        played(tiny_single(), tmp_path / "single").extend(3)
    before = results(race.path)
    for file in race.path.glob("checkpoint-*.npz"):
        file.unlink()
    with pytest.raises(ValueError, match="expected the checkpoint of its last stage"):
        race.extend(3)
    assert {**before, **results(race.path)} == before  # nothing was changed
    assert played(tiny_race(), race.path).finished  # and it needs none to be finished
    (race.path / "summary.json").unlink()
    with pytest.raises(DamagedFileError, match="no intact stage to continue from"):
        played(tiny_race(), race.path)
