"""``matrixworld judge`` and the report of ``evolve``: what they say, write, and judge alike."""

import re
import shutil
from pathlib import Path

import numpy as np
import pytest
from scipy import stats

from command_line import RACE, evolved, judged_in, matrixworld_command, run_together, words
from matrices import circular, logistic
from matrixworld._util.files import read_json
from matrixworld._util.readable import plain_values
from matrixworld.analysis import CONDITIONS, MEASURES, judge, measure_all, read_payoffs, sentence
from matrixworld.cli.report import report
from matrixworld.coevolution import evolve, open_run, score
from matrixworld.coevolution.groups import open_groups
from matrixworld.coevolution.jobs.job import found_job
from matrixworld.coevolution.types import TEAMS
from tiny_race import LONG, SCHEDULES, tiny_race

EVOLVED = {**RACE, "generations": 13, "evaluation_episodes": 5, "schedule": "specialist-specialist"}


def means_of(kind, episodes=30):
    # So clear that 30 episodes suffice.
    chance = circular(31) if kind == "circle" else logistic(31, 0.3)
    return np.random.default_rng(0).binomial(episodes, chance) / episodes


def judged(*words):
    """Return what the command prints, and what it writes of each group."""
    told = matrixworld_command("judge", *words, "--json", "found.json", "--force").stdout
    return told, read_json(Path("found.json"))["groups"]


def test_runs_of_several_seeds_and_files(tmp_path):
    races = [tiny_race(seed=seed, **LONG) for seed in (0, 1)]
    evolve([*races, tiny_race(schedule="specialist-specialist", **LONG)], tmp_path / "job")
    np.savez("file.npz", payoff=circular(7))
    told, found = judged("job", "file.npz", "--explain")
    several, single = open_groups("job")[::-1]
    assert [*found] == [single.name, several.name, "file.npz"]
    for group, after in ((single, several.name), (several, "file.npz")):
        expected = judge(group.payoffs.scores, per_episode=True)
        assert found[group.name] == expected.to_json()
        part = told.partition(f"\n{group.name}\n")[2].partition(f"\n{after}\n")[0]
        assert run_together(part).startswith(run_together(sentence(expected)))
        verdicts = {name: finding.verdict for name, finding in expected.findings.items()}
        assert judged_in(part) == verdicts
        for name in CONDITIONS:
            assert re.search(rf"{name.capitalize()}: (present|absent|cannot tell), because ", part)
    assert max(map(len, told.splitlines()[2:])) <= 100
    _, each = judged("job", "file.npz", "--each")
    alone = [name for name in each if each[name]["runs"] == 1]
    assert alone == [*each] == [single.name, *(str(run.path) for run in several.runs), "file.npz"]


def test_all_measures_come_after_the_judgement():
    np.savez("file.npz", payoff=circular(7))
    told, found = judged("file.npz", "--all")
    assert "condition" in told.partition("A single run: no intervals.")[0]
    payoffs = read_payoffs("file.npz")
    measures = plain_values(measure_all(payoffs))
    assert found["file.npz"] == {"judgement": judge(payoffs).to_json(), "measures": measures}
    share = MEASURES["transitive_share"].of(payoffs).value
    assert re.search(rf"    transitive share +{share:.3f}", told)


def test_files_of_means_need_their_number_of_episodes():
    np.savetxt("circle.csv", means_of("circle"), delimiter=",", header="x", comments="# ")
    np.savez("race.npz", payoff=means_of("race"))
    np.savez("again.npz", payoff=means_of("race"))
    unknown, _ = judged("circle.csv")
    assert judged_in(unknown)["cycling"] == judged_in(unknown)["forgetting"] == "cannot tell"
    assert "Give the number with --episodes." in run_together(unknown)
    known, found = judged("circle.csv", "--episodes", 30)
    assert judged_in(known)["intransitivity"] == "present"
    assert found["circle.csv"] == judge(means_of("circle"), episodes=30).to_json()
    assert "--episodes" not in known
    told, found = judged("race.npz", "again.npz", "--episodes", 30)
    assert "2 runs, 31 generations of pursuers" in told
    twice = np.array([means_of("race")] * 2)
    assert found == {"race.npz, again.npz": judge(twice, episodes=30).to_json()}
    np.savez("small.npz", scores=np.random.default_rng(0).random((4, 4, 2)))
    small, _ = judged("small.npz")
    assert "It takes at least 4 episodes of each cell" in run_together(small)
    assert "It takes at least 6 generations of each team to judge a race" in run_together(small)


@pytest.mark.usefixtures("undrawn")
def test_all_commands_come_to_the_same_judgement():
    told_by_evolve = evolved("--out", "run", *words(EVOLVED), "--threads", 1).stdout
    path = Path("run/specialist-specialist/seed-5")
    [group] = open_groups(path)
    expected = judge(group.payoffs.scores, per_episode=True)
    same = ["--seed", 5, "--episodes", 5]
    told = {
        "judge": judged(path)[0],
        "tournament": matrixworld_command("tournament", path, *same).stdout,
        "of the payoff's file": judged(path / "payoff.npz")[0],
    }
    rows = told["judge"].partition("condition ")[2].partition("\n  ")[0].splitlines()
    for text in told.values():
        assert all(row in text for row in rows[1:7])  # verdicts and numbers
    said = run_together(sentence(expected))
    assert all(said in run_together(text) for text in (*told.values(), told_by_evolve))
    [reported] = read_json(Path("run/summary.json"))["runs"].values()
    assert reported["judgement"] == expected.to_json()
    of_race = {name for name, measure in MEASURES.items() if measure.constant}
    assert set(reported["measures"]) == of_race


FIRST, SECOND = SCHEDULES
SEEDS = (0, 1, 2)


@pytest.fixture
def job(seeds):
    return Path(shutil.copytree(seeds, "job"))


def results(root):
    """Return the directories of finished runs."""
    return [run.path for group in open_groups(root) for run in group.runs]


def test_the_end_has_sentences_and_held_out_scores_in_few_columns(job, capsys, undrawn):
    for name in SCHEDULES:
        shutil.rmtree(job / name / "seed-2")  # which would take long
    report(found_job(job), job, results(job), {}, 0.0, threads=1)
    said = capsys.readouterr().out
    assert max(map(len, said.splitlines())) <= 80
    assert len(said.splitlines()) <= 26  # seen at once
    strangers = run_together(said.partition("score against strangers")[2])
    written = read_json(job / "summary.json")
    groups = {each.inside(job).name: each for each in open_groups(job)}
    assert [*groups] == [*SCHEDULES]
    for name, group in groups.items():
        told = run_together(said[said.index(f"\n{name}") :])
        assert told.startswith(run_together(f"{name}\n{sentence(group.judgement)}"))
        scores = {team: group.held_out(team) for team in TEAMS}
        cells = [each for t in TEAMS for each in (group.best_held_out(t), scores[t])]
        assert " ".join([name, *(f"{each.mean():.2f}" for each in cells)]) in strangers
        kept = written["groups"][name]
        assert (kept["finished"], kept["missing"]) == ([0, 1], [3])
        assert kept["judgement"] == group.judgement.to_json()
        middle = kept["held_out"]["evaders"]["interquartile mean"]
        assert middle["value"] == pytest.approx(stats.trim_mean(scores["evader"], 0.25, axis=None))
    assert "untrained teams" in said
    setting = "O, 2 pursuers and 3 evaders: 100 episodes against each of 5 and 4 opponents"
    assert f"{setting} (untrained: 20); the best of 4 and 5 scripts." in strangers
    assert said.count("Not finished: seed 3.") == 2
    assert [*written["runs"]] == [f"{name}/seed-{seed}" for name in SCHEDULES for seed in (0, 1)]
    one, run = written["runs"][f"{FIRST}/seed-1"], open_run(job / FIRST / "seed-1")
    assert one.items() >= run.summary().items()
    scored = score(run, threads=1)["pursuer"].to_json()
    assert one["held_out"]["pursuers"].items() >= scored.items()


def test_missing_and_failed_seeds_are_named(job, capsys, undrawn):
    failed = job / FIRST / "seed-1"
    asked = {name: each for name, each in found_job(job).items() if FIRST in name}
    report(asked, job, results(job)[:1], {failed: "payoff.npz: cut or altered"}, 0.0, 1)
    said = capsys.readouterr().out
    assert "Not finished: seeds 1, 2, 3." in said
    assert f"Failed: {failed}: payoff.npz: cut or altered" in run_together(said)
    kept = read_json(job / "summary.json")["failed"]
    assert kept == {f"{FIRST}/seed-1": "payoff.npz: cut or altered"}
    report(asked, job, [], {}, 0.0)
    assert f"{FIRST}\n  0 of 4 seeds finished" in capsys.readouterr().out


def test_a_schedule_of_which_no_seed_is_finished_is_named(job):
    for seed in SEEDS:
        (job / SECOND / f"seed-{seed}" / "summary.json").unlink()
    said = run_together(matrixworld_command("judge", job).stderr)
    assert f"{job / SECOND}: no seed is finished yet, and it is left out" in said
