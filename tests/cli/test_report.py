"""The report of ``evolve``, and groups of seeds in other commands."""

import re
import shutil
from pathlib import Path

import pytest
from scipy import stats

from command_line import matrixworld_command, run_together
from matrixworld._util.files import read_json
from matrixworld.analysis.judgement import summary
from matrixworld.cli.evolve import report
from matrixworld.coevolution import SavedRun, finish, open_run, score
from matrixworld.coevolution.groups import RunGroup, open_groups
from matrixworld.coevolution.jobs import create_job, job_of
from matrixworld.coevolution.types import TEAMS
from tiny_race import tiny_race

FIRST, SECOND = SCHEDULES = ("specialist-specialist", "generalist-generalist")
SEEDS, ASKED = (0, 1, 2), (0, 1, 2, 3)  # one has not begun
LONG = {"generations": 12, "pursuer_epochs": 1, "evader_epochs": 1, "evaluation_episodes": 4}
JOB = job_of([tiny_race(schedule=name, seed=seed, **LONG) for name in SCHEDULES for seed in ASKED])


@pytest.fixture(scope="module")
def made(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Two schedules with four seeds each, of which the last one has not begun."""
    root = tmp_path_factory.mktemp("made") / "job"
    create_job(JOB, root)
    for name, settings in JOB.items():
        if settings.seed in SEEDS:
            finish(root / name, threads=1)
    return root


@pytest.fixture
def job(made: Path) -> Path:
    """A copy of the job in the working directory."""
    return Path(shutil.copytree(made, "job"))


def results(root: Path) -> list[SavedRun]:
    return [run for group in open_groups(root) for run in group.runs]


def test_the_end_has_headlines_and_held_out_scores_in_few_columns(job, capsys, undrawn):
    report(JOB, job, results(job), {}, 0.0, threads=1)
    said = capsys.readouterr().out
    assert max(map(len, said.splitlines())) <= 80
    assert len(said.splitlines()) <= 24  # seen at once
    table = said.partition("nobody trained on")[2]
    written = read_json(job / "summary.json")
    groups: dict[str, RunGroup] = {each.inside(job).name: each for each in open_groups(job)}
    assert [*groups] == [*SCHEDULES]
    for name, group in groups.items():
        told = run_together(said[said.index(f"\n{name}") :])
        assert told.startswith(run_together("\n".join([name, *summary(group.judgement)])))
        scores = {team: group.held_out(team) for team in TEAMS}
        means = [f"{each.mean():.2f}" for each in scores.values()]
        assert re.search(rf"^{name} +{means[0]} +{means[1]}$", table, re.MULTILINE)
        kept = written["groups"][name]
        assert (kept["finished"], kept["missing"]) == ([0, 1, 2], [3])
        assert kept["judgement"] == group.judgement.to_json()
        middle = kept["held_out"]["evaders"]["interquartile mean"]
        assert middle["value"] == pytest.approx(stats.trim_mean(scores["evader"], 0.25, axis=None))
    assert said.count("Not finished: seeds 3.") == 2
    assert [*written["runs"]] == [f"{name}/seed-{seed}" for name in SCHEDULES for seed in SEEDS]
    one, run = written["runs"][f"{FIRST}/seed-1"], open_run(job / FIRST / "seed-1")
    assert one.items() >= run.summary().items()
    assert one["held_out"]["pursuers"] == score(run, threads=1)["pursuer"].to_json()


def test_missing_and_failed_seeds_are_named(job, capsys, undrawn):
    failed = job / FIRST / "seed-1"
    asked = {name: each for name, each in JOB.items() if FIRST in name}
    report(asked, job, results(job)[:1], {failed: "payoff.npz: cut or altered"}, 0.0, 1)
    said = capsys.readouterr().out
    assert "Not finished: seeds 1, 2, 3." in said
    assert f"Failed: {failed}: payoff.npz: cut or altered" in run_together(said)
    kept = read_json(job / "summary.json")["failed"]
    assert kept == {f"{FIRST}/seed-1": "payoff.npz: cut or altered"}
    Path("none").mkdir()
    report(asked, Path("none"), [], {}, 0.0)
    assert f"{FIRST}\n  0 of 4 seeds finished" in capsys.readouterr().out


def test_a_schedule_of_which_no_seed_is_finished_is_named(job):
    for seed in SEEDS:
        (job / SECOND / f"seed-{seed}" / "summary.json").unlink()
    said = run_together(matrixworld_command("judge", job).stderr)
    assert f"{job / SECOND}: no seed is finished yet, and it is left out" in said
