"""Groups of seeds: the report of ``evolve``, and what judge, score and explore make of them."""

from __future__ import annotations

import re
import shutil
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest
from scipy import stats

from command_line import PNG, judged_in, matrixworld_command, run_together
from matrixworld import analysis
from matrixworld._util.files import load_json
from matrixworld.cli.groups import Group, groups_of, open_result, place_of
from matrixworld.cli.report import report
from matrixworld.cli.tables import print_strip
from matrixworld.coevolution import open_run, open_runs, score, start
from matrixworld.coevolution.jobs.job import job_of, open_job, save_job
from tiny_race import StopAt, tiny_race, tiny_single

SCHEDULES = ("specialist-specialist", "generalist-generalist")
SEEDS = (0, 1, 2)
ASKED = (0, 1, 2, 3)
LONGER = {"generations": 12, "pursuer_epochs": 1, "evader_epochs": 1, "evaluation_episodes": 4}


def settings_of(schedule: str, seed: int):
    return tiny_race(schedule=schedule, seed=seed, **LONGER)


@pytest.fixture(scope="module")
def made(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Two schedules with four seeds each, of which the last one has not begun."""
    root = tmp_path_factory.mktemp("made")
    save_job(root, job_of([settings_of(name, seed) for name in SCHEDULES for seed in ASKED]))
    for name in SCHEDULES:
        for seed in SEEDS:
            start(settings_of(name, seed), root / name / f"seed-{seed}", threads=1).run()
    report(*told(root), {}, threads=1)
    return root


@pytest.fixture
def job(made: Path) -> Path:
    """A copy of the job in the working directory."""
    return Path(shutil.copytree(made, "job"))


def told(root: Path):
    """Return what `evolve` gives to the report."""
    results = [open_result(root / name / f"seed-{seed}") for name in SCHEDULES for seed in SEEDS]
    return open_job(root), results, root


def payoffs(root: Path, schedule: str, seeds=SEEDS) -> np.ndarray:
    runs = [open_run(root / schedule / f"seed-{seed}") for seed in seeds]
    return np.stack([run.payoff().capture_rates for run in runs])


def held_out_of(root: Path, schedule: str, team: str) -> np.ndarray:
    kept = [scores_of(root / schedule / f"seed-{seed}")[team]["against"] for seed in SEEDS]
    return np.array([[one["value"] for [one] in each.values()] for each in kept])


def scores_of(path: Path):
    """Return the scores of a run by ``matrixworld score`` without options, as plain values."""
    scores = score(open_run(path), threads=1)
    return {f"{team}s": each.to_json() for team, each in scores.items()}


def interval(values, form: str) -> str:
    """Return a mean and its t interval, computed with SciPy."""
    mean = np.mean(values)
    low, high = stats.t.interval(0.95, len(values) - 1, mean, stats.sem(values))
    return f"{mean:{form}} ({max(0, low):{form}} to {min(1, high):{form}})"


def test_the_table_has_the_numbers_of_the_runs(job, capsys):
    report(*told(job), {}, threads=1)
    said = capsys.readouterr().out
    rows = {line[:20].strip(): re.split(r"  +", line[22:].strip()) for line in said.splitlines()}
    assert rows["seeds finished"] == ["3 of 4", "3 of 4"]
    for column, name in enumerate(SCHEDULES):
        judgement = analysis.judge(payoffs(job, name), per_episode=True)
        gain = judgement.headline["arms race"].estimates["evader_gain"]
        shown = f"{gain.value:+.2f} ({gain.low:+.2f} to {gain.high:+.2f})"
        assert rows["gain of the evaders"][column] == shown
        means = payoffs(job, name).mean(axis=3)
        share = analysis.MEASURES["transitive_share"].of(means)
        assert (
            rows["transitive share"][column]
            == f"{share.value:.2f} ({share.low:.2f} to {share.high:.2f})"
        )
        scores = held_out_of(job, name, "pursuers")
        assert rows["held-out, pursuers"][column] == interval(scores.mean(axis=1), ".2f")
        assert rows["training matches"][column] == "96"
    steps = [run.files.summary()["training_agent_steps"] for run in open_runs(job / SCHEDULES[0])]
    assert rows["training agent-steps"][0].startswith(f"{np.mean(steps):,.0f} (")
    assert said.count("Not finished: seeds 3.") == 2


def test_the_strip_has_the_verdict_on_each_seed(job, capsys):
    report(*told(job), {}, threads=1)
    said = capsys.readouterr().out.split(f"\n{SCHEDULES[0]}: 3 runs")[1]
    judgement = analysis.judge(payoffs(job, SCHEDULES[0]), per_episode=True)
    signs = {"present": "+", "absent": "-", "cannot tell": "?"}
    lines = said[said.index("seed  ") :].splitlines()[:7]
    assert lines[0].split() == ["seed", *map(str, ASKED), "together", "(seeds:", "+,", "-,", "?)"]
    for line, (name, finding) in zip(lines[1:], judgement.headline.items(), strict=True):
        counts = ", ".join(str(finding.by_run.count(verdict)) for verdict in signs)
        cells = [*(signs[verdict] for verdict in finding.by_run), "."]
        assert line == f"{name:18}  {'  '.join(cells)}  {finding.verdict} ({counts})"


def test_summary_json_keeps_each_seed_and_the_aggregate(job):
    summary = load_json(job / "summary.json")
    assert [*summary["runs"]] == [f"{name}/seed-{seed}" for name in SCHEDULES for seed in SEEDS]
    one = summary["runs"][f"{SCHEDULES[0]}/seed-1"]
    run = job / SCHEDULES[0] / "seed-1"
    assert one.items() >= open_run(run).files.summary().items()
    assert one["held_out"]["pursuers"] == scores_of(run)["pursuers"]
    group = summary["groups"][SCHEDULES[0]]
    assert (group["finished"], group["missing"]) == ([0, 1, 2], [3])
    judgement = analysis.judge(payoffs(job, SCHEDULES[0]), per_episode=True)
    assert group["judgement"] == judgement.to_json()
    cycling = judgement.headline["cycling"]
    assert group["verdicts"]["cycling"]["together"] == cycling.verdict
    assert [*group["verdicts"]["cycling"]["by_seed"].values()] == [*cycling.by_run]
    scores = held_out_of(job, SCHEDULES[0], "evaders")
    middle = group["measures"]["evader_held_out_iqm"]
    assert middle["value"] == pytest.approx(stats.trim_mean(scores, 0.25, axis=None))
    assert (middle["low"], middle["note"]) == (None, "no interval below 6 runs")
    for name in ("seeds", "verdicts", "held_out"):
        assert (job / f"{name}.png").read_bytes().startswith(PNG)


def test_a_single_finished_seed_has_intervals_over_its_episodes(job, capsys):
    _, [first, *_], _ = told(job)
    asked = job_of([settings_of(SCHEDULES[0], seed) for seed in ASKED])
    failed = {job / SCHEDULES[0] / "seed-1": "payoff.npz: cut or altered"}
    report(asked, [first], job, failed, 1)
    said = capsys.readouterr().out
    mean = first.held_out["pursuers"]["mean"][0]
    shown = f"{mean['value']:.2f} ({mean['low']:.2f} to {mean['high']:.2f})"
    assert re.search(rf"held-out, pursuers +{re.escape(shown)}\n", said)
    assert re.search(r"seeds finished +1 of 4\n", said)
    assert "Not finished: seeds 1, 2, 3." in said
    assert f"Failed: {job / SCHEDULES[0] / 'seed-1'}: payoff.npz: cut or altered" in run_together(
        said
    )
    assert load_json(job / "summary.json")["failed"] == {
        f"{SCHEDULES[0]}/seed-1": "payoff.npz: cut or altered"
    }


def test_a_job_of_which_nothing_is_finished_says_so(capsys):
    Path("none").mkdir()
    report(job_of([settings_of(SCHEDULES[0], seed) for seed in (0, 1)]), [], Path("none"), {})
    said = capsys.readouterr().out
    assert f"{SCHEDULES[0]}: 0 of 2 seeds finished" in said
    assert "Not finished: seeds 0, 1." in said
    assert not list(Path("none").glob("*.png"))


def test_runs_of_several_settings_in_one_directory_are_groups_of_their_own(capsys):
    runs = {
        "a/short": tiny_race(generations=1),
        "a/long": tiny_race(),
        "a/later": tiny_race(seed=9),
    }
    for name, settings in list(runs.items())[:2]:
        start(settings, f"mixed/{name}", threads=1).run()
    results = [open_result(Path("mixed") / name) for name in ("a/short", "a/long")]
    report(job_of(runs), results, Path("mixed"), {}, threads=1)
    groups = load_json(Path("mixed/summary.json"))["groups"]
    assert [*groups] == ["a/short", "a/long, a/later"]
    assert [groups[name]["missing"] for name in groups] == [[], [9]]
    said = capsys.readouterr().out
    assert "Not finished: seeds 9." in said
    # A race of one generation has no gain.
    assert re.search(r"gain of the pursuers  -  ", said)


def test_seeds_of_one_team_have_their_own_table(capsys):
    results, name = [], "pursuer-against-random"
    for seed in (0, 1, 2):
        start(tiny_single(seed=seed), f"alone/{name}/seed-{seed}", threads=1).run()
        results.append(open_result(Path(f"alone/{name}/seed-{seed}")))
    job = job_of([run.settings for run in results])
    report(job, results, Path("alone"), {}, threads=1)
    said = capsys.readouterr().out
    assert f"{name}, 3 of 3 seeds finished" in said
    rates = [run.numbers["capture_rate"] for run in results]
    assert re.search(rf"mean +{np.mean(rates):.4f} \(", said)
    summary = load_json(Path("alone/summary.json"))
    assert summary["groups"][name]["measures"]["capture_rate"]["value"] == np.mean(rates)
    said = matrixworld_command("score", "alone", "--episodes", 2, "--threads", 1).stdout
    assert f"alone/{name}: 3 of 3 seeds finished" in said
    assert "evaders of generation" not in said


def test_judge_takes_each_group_with_its_strip(job):
    result = matrixworld_command("judge", job, "--all", "--json", "found.json")
    heads = [line for line in result.stdout.splitlines() if ": 3 runs, " in line]
    assert [head.split(":")[0] for head in heads] == [str(job / name) for name in SCHEDULES]
    assert result.stdout.count("together (seeds: +, -, ?)") == 2
    assert result.stdout.count("Not finished: seeds 3.") == 2
    assert result.stdout.count("Mean (95% interval over runs; few runs make it wide):") == 2
    found = load_json(Path("found.json"))["groups"]
    for name in SCHEDULES:
        expected = analysis.read_payoffs(payoffs(job, name), per_episode=True)
        judgement = {"judgement": analysis.judge(expected).to_json()}
        assert found[str(job / name)] == judgement | analysis.all_results(expected)
    alone = matrixworld_command("judge", job / SCHEDULES[1], "--json", "one.json")
    [one] = load_json(Path("one.json"))["groups"].values()
    assert one == found[str(job / SCHEDULES[1])]["judgement"]
    assert judged_in(alone.stdout) == judged_in(result.stdout.split(str(job / SCHEDULES[1]))[1])
    one = matrixworld_command("judge", job / SCHEDULES[1] / "seed-0").stdout
    assert "together" not in one


def test_score_gives_mean_and_interval_over_seeds(job):
    options = ["--episodes", 4, "--threads", 1, "--json", "found.json"]
    said = matrixworld_command("score", job, *options).stdout
    found = load_json(Path("found.json"))["groups"][str(job / SCHEDULES[0])]
    assert (found["seeds"], found["missing"]) == ([0, 1, 2], [3])
    runs = open_runs(job / SCHEDULES[0])
    scores = [score(run, episodes=4, threads=1)["pursuer"] for run in runs]
    [over] = found["pursuers"]["estimates"]
    assert over["mean"]["value"] == pytest.approx(np.mean([each.means for each in scores]))
    against = [each.rates[0, 0].mean() for each in scores]
    assert over[scores[0].opponents[0]]["value"] == pytest.approx(np.mean(against))
    assert found["pursuers"]["by_seed"]["1"] == scores[1].to_json()
    assert f"mean                {interval([each.means[0] for each in scores], '.3f')}" in said
    every = matrixworld_command("score", job / SCHEDULES[0], *options, "--generation", "all",
                                "--force").stdout  # fmt: skip
    assert "pursuers by generation: mean capture rate" in every
    assert len(load_json(Path("found.json"))["groups"][str(job / SCHEDULES[0])]["evaders"]
               ["estimates"]) == 13  # fmt: skip


def test_figures_of_the_groups_and_of_single_runs_with_each(job):
    for file in job.glob("*.png"):
        file.unlink()
    said = matrixworld_command("explore", "--figures", job).stdout.split()
    assert [Path(file).name for file in said] == ["seeds.png", "verdicts.png", "held_out.png"]
    assert not list(job.glob("*/*/*.png"))
    assert "seeds.png: exists" in matrixworld_command("explore", "--figures", job, code=2).stderr
    one = matrixworld_command("explore", "--figures", job / SCHEDULES[0], "--each").stdout
    assert (job / SCHEDULES[0] / "verdicts.png").read_bytes().startswith(PNG)
    assert (job / SCHEDULES[0] / "seed-2" / "payoff.png").read_bytes().startswith(PNG)
    assert one.count("payoff.png") == 3
    assert not (job / "comparison.png").exists()


def test_figures_of_a_job_of_one_schedule_go_into_the_directory_of_the_job(job):
    paths = [run.path for run in told(job)[1]]
    assert place_of(paths) == job
    assert place_of(paths[:3]) == (job / SCHEDULES[0]).absolute()
    assert place_of(paths[:1]) == paths[0]


def test_unfinished_seeds_are_named_and_left_out(job):
    shutil.rmtree(job / SCHEDULES[0] / "seed-1")
    race = start(settings_of(SCHEDULES[0], 1), job / SCHEDULES[0] / "seed-1", play=StopAt(2))
    with pytest.raises(KeyboardInterrupt):
        race.run()
    said = matrixworld_command("judge", job / SCHEDULES[0]).stdout
    assert "2 runs, 13 pursuer" in said
    assert "Not finished: seeds 1, 3." in said
    refused = matrixworld_command("judge", job / SCHEDULES[0] / "seed-1", code=2).stderr
    assert "expected a finished run" in refused


@pytest.mark.parametrize(
    "command",
    [
        ("judge",),
        ("score", "--episodes", 2),
        ("explore", "--figures", "--force"),
        ("exploit", "--champion", "evader", "--matches", 48, "--episodes", 2),
    ],
    ids=lambda command: command[0],
)
def test_a_schedule_of_which_no_seed_has_begun_is_named(job, command):
    shutil.rmtree(job / SCHEDULES[1])
    name, *options = command
    words = f"{job / SCHEDULES[1]}: no seed is finished yet, and it is left out"
    told = run_together(matrixworld_command(name, job, *options).stderr)
    assert told.count(words) == 1


def test_seeds_that_the_user_left_out_are_not_missing(job):
    chosen = [job / SCHEDULES[0] / f"seed-{seed}" for seed in (0, 2)]
    [group] = groups_of(chosen)
    assert (group.name, group.missing) == (", ".join(map(str, chosen)), ())


def test_a_strip_of_many_seeds_is_in_parts(capsys):
    rng = np.random.default_rng(0)
    scores = rng.random((70, 4, 4, 2))
    runs = tuple(
        SimpleNamespace(
            settings=SimpleNamespace(seed=seed), payoff=SimpleNamespace(capture_rates=rates)
        )
        for seed, rates in enumerate(scores)
    )
    print_strip(Group((Path("many"),), runs))
    lines = capsys.readouterr().out.splitlines()
    assert max(map(len, lines)) <= 100
    heads = [line.split() for line in lines if line.startswith("seed")]
    assert [int(word) for head in heads for word in head[1:] if word.isdigit()] == [*range(70)]
    assert [len([word for word in head if word == "together"]) for head in heads][-1] == 1


def test_open_runs_finds_the_runs_of_a_job(job):
    runs = open_runs(job)
    places = [run.files.path.relative_to(job).as_posix() for run in runs]
    assert places == [f"{name}/seed-{seed}" for name in sorted(SCHEDULES) for seed in SEEDS]
    assert [run.settings.seed for run in open_runs(job / SCHEDULES[0] / "seed-2")] == [2]
    with pytest.raises(FileNotFoundError, match="expected a directory that holds runs, got none"):
        open_runs("nothing")
