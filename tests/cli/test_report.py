"""Groups of seeds: the report of ``evolve``, and what judge, score and explore make of them."""

import io
import re
import shutil
from contextlib import redirect_stdout
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest
from scipy import stats

from command_line import PNG, judged_in, matrixworld_command, run_together
from matrixworld import analysis
from matrixworld._util.files import load_json
from matrixworld.analysis import CONDITIONS
from matrixworld.analysis.words import all_results, headline_numbers
from matrixworld.cli.groups import Group, groups_of, open_result, place_of
from matrixworld.cli.report import report
from matrixworld.cli.tables import print_strip
from matrixworld.coevolution import RaceSettings, open_run, open_runs, score, start
from matrixworld.coevolution.jobs import job_of, open_job, save_job
from matrixworld.coevolution.types import TEAMS
from tiny_race import StopAt, tiny_race, tiny_single

FIRST, SECOND = SCHEDULES = ("specialist-specialist", "generalist-generalist")
SEEDS, ASKED = (0, 1, 2), (0, 1, 2, 3)  # one has not begun
LONGER = {"generations": 12, "pursuer_epochs": 1, "evader_epochs": 1, "evaluation_episodes": 4}


def settings_of(schedule: str, seed: int) -> RaceSettings:
    return tiny_race(schedule=schedule, seed=seed, **LONGER)


@pytest.fixture(scope="module")
def made(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, str]:
    """Two schedules with four seeds each, of which the last one has not begun, and their report."""
    root = tmp_path_factory.mktemp("made")
    save_job(root, job_of([settings_of(name, seed) for name in SCHEDULES for seed in ASKED]))
    results = [
        played(root / name / f"seed-{seed}", settings_of(name, seed))
        for name in SCHEDULES
        for seed in SEEDS
    ]
    with redirect_stdout(io.StringIO()) as printed:
        report(open_job(root), results, root, {}, threads=1)
    return root, printed.getvalue()


def played(path: Path, settings: RaceSettings):
    """Play a run, and return it as the report reads it."""
    start(settings, path, threads=1).run()
    return open_result(path)


@pytest.fixture
def job(made: tuple[Path, str]) -> Path:
    """A copy of the job in the working directory."""
    return Path(shutil.copytree(made[0], "job"))


def payoffs(root: Path, schedule: str) -> np.ndarray:
    return np.stack([run.payoff().capture_rates for run in open_runs(root / schedule)])


def held_out_of(root: Path, schedule: str, team: str) -> np.ndarray:
    """Return the scores (seeds, opponents) of ``matrixworld score`` without options."""
    scores = [score(run, threads=1)[team] for run in open_runs(root / schedule)]
    return np.stack([each.rates[0].mean(axis=1) for each in scores])


def interval(values, form: str) -> str:
    """Return a mean and its t interval, computed with SciPy."""
    mean = np.mean(values)
    low, high = stats.t.interval(0.95, len(values) - 1, mean, stats.sem(values))
    return f"{mean:{form}} ({max(0, low):{form}} to {min(1, high):{form}})"


# The report


def test_the_end_has_headlines_and_held_out_scores_in_few_columns(made):
    root, said = made
    lines = said.splitlines()
    assert max(map(len, lines)) <= 80 or str(root) in max(lines, key=len)
    assert len(lines) <= 20  # seen at once
    table = said.partition("(1 = best)\n")[2]
    for name in SCHEDULES:
        judgement = analysis.judge(payoffs(root, name), per_episode=True)
        told = run_together(said[said.index(f"\n{name}") :])
        # The headline is wrapped beside the name.
        assert told.startswith(f"{name} {analysis.headline(judgement)}")
        assert all(numbers in said for numbers in headline_numbers(judgement))
        means = [f"{held_out_of(root, name, team).mean():.2f}" for team in TEAMS]
        assert re.search(rf"^{name} +{means[0]} +{means[1]}$", table, re.MULTILINE)
    assert said.count("Not finished: seeds 3.") == 2


def test_the_strip_has_the_verdict_on_each_seed(made):
    root, _ = made
    said = matrixworld_command("judge", root / FIRST).stdout
    judgement = analysis.judge(payoffs(root, FIRST), per_episode=True)
    signs = {"present": "+", "absent": "-", "cannot tell": "?"}
    lines = said[said.index("seed  ") :].splitlines()[: 1 + len(CONDITIONS)]
    assert lines[0].split() == ["seed", *map(str, ASKED), "together", "(seeds:", "+,", "-,", "?)"]
    for line, (name, finding) in zip(lines[1:], judgement.headline.items(), strict=True):
        counts = ", ".join(str(finding.by_run.count(verdict)) for verdict in signs)
        cells = [*(signs[verdict] for verdict in finding.by_run), "."]
        assert line == f"{name:18}  {'  '.join(cells)}  {finding.verdict} ({counts})"


def test_a_strip_of_many_seeds_is_in_parts(capsys):
    scores = np.random.default_rng(0).random((70, 4, 4, 2))  # too many seeds for one line
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
    assert ["together" in head for head in heads] == [False] * (len(heads) - 1) + [True]


def test_summary_json_keeps_each_seed_and_the_aggregate(made):
    root, _ = made
    summary = load_json(root / "summary.json")
    assert [*summary["runs"]] == [f"{name}/seed-{seed}" for name in SCHEDULES for seed in SEEDS]
    one, run = summary["runs"][f"{FIRST}/seed-1"], open_run(root / FIRST / "seed-1")
    assert one.items() >= run.files.summary().items()
    assert one["held_out"]["pursuers"] == score(run, threads=1)["pursuer"].to_json()
    group = summary["groups"][FIRST]
    assert (group["finished"], group["missing"]) == ([0, 1, 2], [3])
    judgement = analysis.judge(payoffs(root, FIRST), per_episode=True)
    assert group["judgement"] == judgement.to_json()
    middle = group["held_out"]["evaders"]["interquartile mean"]
    scores = held_out_of(root, FIRST, "evader")
    assert middle["value"] == pytest.approx(stats.trim_mean(scores, 0.25, axis=None))
    assert (middle["low"], middle["note"]) == (None, "no interval below 6 runs")
    for name in ("seeds", "verdicts", "held_out"):
        assert (root / f"{name}.png").read_bytes().startswith(PNG)


def test_missing_and_failed_seeds_are_named(job, capsys, undrawn):
    first, other = (job / FIRST / f"seed-{seed}" for seed in (0, 1))
    asked = job_of([settings_of(FIRST, seed) for seed in ASKED])
    report(asked, [open_result(first)], job, {other: "payoff.npz: cut or altered"}, 1)
    said = capsys.readouterr().out
    assert "Not finished: seeds 1, 2, 3." in said
    assert f"Failed: {other}: payoff.npz: cut or altered" in run_together(said)
    failed = load_json(job / "summary.json")["failed"]
    assert failed == {f"{FIRST}/seed-1": "payoff.npz: cut or altered"}


def test_a_job_of_which_nothing_is_finished_says_so(capsys):
    Path("none").mkdir()
    report(job_of([settings_of(FIRST, seed) for seed in (0, 1)]), [], Path("none"), {})
    said = capsys.readouterr().out
    assert f"{FIRST}  0 of 2 seeds finished" in said
    assert "Not finished: seeds 0, 1." in said
    assert not list(Path("none").glob("*.png"))


def test_runs_of_several_settings_in_one_directory_are_groups_of_their_own(capsys, undrawn):
    short, later = tiny_race(generations=1), tiny_race(seed=9)
    runs = {"a/short": short, "a/long": tiny_race(), "a/later": later}
    results = [played(Path("mixed") / name, runs[name]) for name in ("a/short", "a/long")]
    report(job_of(runs), results, Path("mixed"), {}, threads=1)
    groups = load_json(Path("mixed/summary.json"))["groups"]
    assert {name: groups[name]["missing"] for name in groups} == {
        "a/short": [],
        "a/long, a/later": [9],
    }
    assert "Not finished: seeds 9." in capsys.readouterr().out


def test_seeds_of_one_team_have_their_mean(capsys, undrawn):
    name = "pursuer-against-random"
    results = [played(Path(f"alone/{name}/seed-{n}"), tiny_single(seed=n)) for n in SEEDS]
    report(job_of([run.settings for run in results]), results, Path("alone"), {}, threads=1)
    said = capsys.readouterr().out
    mean = np.mean([run.numbers["capture_rate"] for run in results])
    assert f"{name}  capture rate {mean:.3f} (" in said
    summary = load_json(Path("alone/summary.json"))
    assert summary["groups"][name]["measures"]["capture_rate"]["value"] == mean
    said = matrixworld_command("score", "alone", "--episodes", 2, "--threads", 1).stdout
    assert f"alone/{name}: 3 of 3 seeds finished" in said
    assert "evaders of generation" not in said


# Commands on groups


def test_judge_takes_each_group_with_its_strip(job):
    said = matrixworld_command("judge", job, "--all", "--json", "found.json").stdout
    names = [str(job / name) for name in SCHEDULES]
    assert [line for line in said.splitlines() if line in names] == names
    for words in (
        "together (seeds: +, -, ?)",
        "Not finished: seeds 3.",
        "Mean (95% interval over runs; few runs make it wide):",
    ):
        assert said.count(words) == 2
    found = load_json(Path("found.json"))["groups"]
    for name in SCHEDULES:
        expected = analysis.read_payoffs(payoffs(job, name), per_episode=True)
        judgement = {"judgement": analysis.judge(expected).to_json()}
        assert found[str(job / name)] == judgement | all_results(expected)
    alone = matrixworld_command("judge", job / SECOND).stdout
    assert judged_in(alone) == judged_in(said.split(str(job / SECOND))[1])
    assert "together" not in matrixworld_command("judge", job / SECOND / "seed-0").stdout


def test_score_gives_mean_and_interval_over_seeds(job):
    options = ["--episodes", 4, "--threads", 1, "--json", "found.json"]
    said = matrixworld_command("score", job, *options).stdout
    found = load_json(Path("found.json"))["groups"][str(job / FIRST)]
    assert (found["seeds"], found["missing"]) == ([0, 1, 2], [3])
    scores = [score(run, episodes=4, threads=1)["pursuer"] for run in open_runs(job / FIRST)]
    [over] = found["pursuers"]["estimates"]
    assert over["mean"]["value"] == pytest.approx(np.mean([each.means for each in scores]))
    against = [each.rates[0, 0].mean() for each in scores]
    assert over[scores[0].opponents[0]]["value"] == pytest.approx(np.mean(against))
    assert found["pursuers"]["by_seed"]["1"] == scores[1].to_json()
    assert f"mean                {interval([each.means[0] for each in scores], '.3f')}" in said
    every = [*options, "--generation", "all", "--force"]
    said = matrixworld_command("score", job / FIRST, *every).stdout
    assert "pursuers by generation: mean capture rate" in said
    [found] = load_json(Path("found.json"))["groups"].values()
    assert len(found["evaders"]["estimates"]) == 13


@pytest.mark.slow
def test_figures_of_the_groups_and_of_single_runs_with_each(job):
    for file in job.glob("*.png"):
        file.unlink()
    said = matrixworld_command("explore", "--figures", job).stdout.split()
    assert [Path(file).name for file in said] == ["seeds.png", "verdicts.png", "held_out.png"]
    assert not list(job.glob("*/*/*.png"))
    one = matrixworld_command("explore", "--figures", job / FIRST, "--each").stdout
    assert (job / FIRST / "verdicts.png").read_bytes().startswith(PNG)
    assert (job / FIRST / "seed-2" / "payoff.png").read_bytes().startswith(PNG)
    assert one.count("payoff.png") == 3
    assert not (job / "comparison.png").exists()


def test_files_about_all_runs_of_a_job_go_into_its_directory(job):
    paths = [job / name / f"seed-{seed}" for name in SCHEDULES for seed in SEEDS]
    assert place_of(paths) == job
    assert place_of(paths[:3]) == (job / FIRST).absolute()
    assert place_of(paths[:1]) == paths[0]


def test_unfinished_seeds_are_named_and_left_out(job):
    shutil.rmtree(job / FIRST / "seed-1")
    race = start(settings_of(FIRST, 1), job / FIRST / "seed-1", play=StopAt(2))
    with pytest.raises(KeyboardInterrupt):
        race.run()
    said = matrixworld_command("judge", job / FIRST).stdout
    assert "2 runs, 13 pursuer" in said
    assert "Not finished: seeds 1, 3." in said
    # Seeds that the user has left out are not missing.
    chosen = [job / FIRST / f"seed-{seed}" for seed in (0, 2)]
    [group] = groups_of(chosen)
    assert (group.name, group.missing) == (", ".join(map(str, chosen)), ())


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
    shutil.rmtree(job / SECOND)
    name, *options = command
    words = f"{job / SECOND}: no seed is finished yet, and it is left out"
    assert run_together(matrixworld_command(name, job, *options).stderr).count(words) == 1


def test_open_runs_finds_the_runs_of_a_job(job):
    places = [run.files.path.relative_to(job).as_posix() for run in open_runs(job)]
    assert places == [f"{name}/seed-{seed}" for name in sorted(SCHEDULES) for seed in SEEDS]
    assert [run.settings.seed for run in open_runs(job / FIRST / "seed-2")] == [2]
    with pytest.raises(FileNotFoundError, match="expected a directory that holds runs, got none"):
        open_runs("nothing")
