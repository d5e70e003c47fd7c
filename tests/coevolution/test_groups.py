"""Runs in groups that differ in their seed only: what belongs together, and kept scores."""

import shutil
from pathlib import Path

import numpy as np
import pytest

from matrixworld._util.files import read_json, save_json
from matrixworld.analysis import judge
from matrixworld.coevolution import compare, open_runs, score
from matrixworld.coevolution.evaluation.kept_scores import kept_scores
from matrixworld.coevolution.evaluation.scores import best_generations, estimates_of
from matrixworld.coevolution.groups import open_groups
from matrixworld.coevolution.runs.places import find_runs
from tiny_race import SCHEDULES, StopAt, played, tiny_race, tiny_single

FIRST, SECOND = SCHEDULES
SEEDS, ASKED = (0, 1, 2), (0, 1, 2, 3)  # one has not begun


@pytest.fixture
def job(seeds, tmp_path):
    return Path(shutil.copytree(seeds, tmp_path / "job"))


def test_a_job_has_a_group_for_each_schedule_and_knows_what_is_missing(seeds):
    groups = open_groups(seeds)
    assert [group.name for group in groups] == [str(seeds / name) for name in SCHEDULES]
    assert [group.inside(seeds).name for group in groups] == [*SCHEDULES]
    assert [(group.seeds, group.missing) for group in groups] == [(SEEDS, (3,))] * 2
    assert all(group.several and group.is_race for group in groups)
    assert [group.name for group in open_groups(seeds / FIRST)] == [str(seeds / FIRST)]
    [single] = open_groups(seeds / FIRST / "seed-1")
    assert (single.seeds, single.missing, single.several) == ((1,), (), False)
    assert single.singles == (single,)
    assert find_runs(seeds) == [seeds / name / f"seed-{n}" for name in SCHEDULES for n in ASKED]


def test_a_group_is_judged_and_scored_as_its_runs_together(seeds):
    group = open_groups(seeds / FIRST)[0]
    runs = open_runs(seeds / FIRST)
    rates = np.stack([run.payoff().scores for run in runs])
    assert group.judgement.to_json() == judge(rates, per_episode=True).to_json()
    assert [each.judgement.runs for each in group.singles] == [1, 1, 1]
    scores = [score(run, threads=1)["evader"] for run in runs]
    means = np.stack([each.rates[0].mean(axis=1) for each in scores])
    np.testing.assert_allclose(group.held_out("evader"), means)
    over = estimates_of(scores)
    assert over["mean"].value == pytest.approx(means.mean())
    assert over["mean"].across == "runs"
    assert over[scores[0].opponents[0]].value == pytest.approx(means[:, 0].mean())
    assert estimates_of(scores[:1])["mean"] == scores[0].mean()


def test_scores_are_kept_and_played_again_if_they_are_of_something_else(job):
    runs = open_runs(job / SECOND)
    told = []
    kept = kept_scores(runs, threads=1, report=told.append)
    assert told[-1].what.startswith("[3/3] evaders")
    played = score(open_runs(job / SECOND)[1])["pursuer"].to_json()
    assert kept[1]["pursuers"].items() >= played.items()
    beside = {"untrained", "best script", "best generation", "evolved"}
    assert {*kept[1]["pursuers"]} - {*played} == beside
    generation, mean = kept[1]["pursuers"]["best generation"]
    of_best = score(open_runs(job / SECOND)[1], generation=generation)["pursuer"]
    assert mean == pytest.approx(of_best.means[0])
    assert generation == best_generations(open_runs(job / SECOND)[1])["pursuer"]
    files = [run.path / "scores.json" for run in runs]
    before = [file.read_bytes() for file in files]
    told.clear()
    assert kept_scores(runs, report=told.append) == kept
    assert not told
    files[0].unlink()
    files[1].write_bytes(before[1][:-9])  # cut
    save_json(files[2], read_json(files[2]) | {"matrixworld": "0.0"})  # those of another version
    assert kept_scores(runs, threads=1, report=told.append) == kept
    assert told[-1].what.startswith("[3/3]")
    assert [file.read_bytes() for file in files] == before


def test_runs_of_several_settings_and_equal_runs(tmp_path):
    played(tiny_race(generations=1), tmp_path / "a/short")
    played(tiny_race(), tmp_path / "a/long")
    # A default, given by its value, makes no difference.
    with pytest.raises(KeyboardInterrupt):
        played(tiny_race(seed=9, sigma=0.1), tmp_path / "a/later", play=StopAt(2))
    groups = {group.name: group.missing for group in open_groups(tmp_path / "a")}
    later, long = (str(tmp_path / "a" / name) for name in ("later", "long"))
    assert groups == {f"{later}, {long}": (9,), str(tmp_path / "a/short"): ()}
    shutil.copytree(tmp_path / "a/long", tmp_path / "a/copy")
    with pytest.raises(ValueError, match=r"the same run twice: .*a/copy, .*a/long"):
        open_groups(tmp_path / "a")
    with pytest.raises(FileNotFoundError):
        open_groups(tmp_path / "nothing")


def test_one_team_alone_has_means_over_seeds_or_over_its_episodes(tmp_path):
    for seed in SEEDS:
        played(tiny_single(seed=seed), tmp_path / f"seed-{seed}")
    [group] = open_groups(tmp_path)
    rates = [run.summary()["capture_rate"] for run in group.runs]
    mean = group.means()["capture_rate"]
    assert (mean.value, mean.across) == (pytest.approx(np.mean(rates)), "runs")
    alone = group.singles[0].means()["length"]
    assert (alone.value, alone.across) == (group.runs[0].summary()["length"], "episodes")


def test_runs_of_different_teams_cannot_be_compared(tmp_path):
    one = played(tiny_single(team="pursuer"), tmp_path / "pursuers")
    other = played(tiny_single(team="evader"), tmp_path / "evaders")
    with pytest.raises(ValueError, match="other: expected runs in which the same team learns"):
        compare(one, other)
