"""``matrixworld judge``: what it judges, prints and refuses."""

import re
import shutil
from pathlib import Path

import numpy as np
import pytest

from command_line import RACE, judged_in, matrixworld_command, run_together, words
from matrices import circular, logistic
from matrixworld import plots
from matrixworld._util.files import load_json
from matrixworld.analysis import CONDITIONS, MEASURES, headline, judge
from matrixworld.analysis.words import headline_numbers
from matrixworld.cli.figures import group_figure, planned
from matrixworld.cli.groups import groups_of
from matrixworld.coevolution import open_run, start
from tiny_race import StopAt, tiny_race, tiny_single

LONGER = {"generations": 12, "pursuer_epochs": 1, "evader_epochs": 1, "evaluation_episodes": 4}


@pytest.fixture(scope="module")
def job(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Three finished races: two that differ in the seed only, and one of another schedule."""
    output = tmp_path_factory.mktemp("job")
    # The second one gives some defaults by their value, which makes no difference.
    given = {"overlap_penalty": 0.2, "learner": "es"}
    for seed, more in ((1, {}), (2, given)):
        start(tiny_race(seed=seed, **LONGER, **more), output / str(seed), threads=1).run()
    other = tiny_race(seed=3, schedule="specialist-specialist", sigma=0.2, **LONGER)
    start(other, output / "other", threads=1).run()
    return output


def means_of(kind: str, episodes: int = 30) -> np.ndarray:
    """Mean capture rates of a race whose truth is known."""
    # So clear that 30 episodes suffice.
    chance = circular(31) if kind == "circle" else logistic(31, 0.3)
    return np.random.default_rng(0).binomial(episodes, chance) / episodes


def write_files() -> None:
    np.savetxt("circle.csv", means_of("circle"), delimiter=",", header="x", comments="# ")
    np.savez("race.npz", payoff=means_of("race"))


# diagnose


def test_a_run_is_judged_by_its_episodes(job):
    result = matrixworld_command("judge", job / "1", "--json", "found.json")
    payoff = open_run(job / "1").payoff()
    expected = judge(payoff.capture_rates, per_episode=True)
    assert judged_in(result.stdout) == {
        name: finding.verdict for name, finding in expected.headline.items()
    }
    lines = result.stdout.splitlines()
    head = "1 run, 13 pursuer and 13 evader generations, 4 episodes of each pair"
    assert lines[1:4] == [str(job / "1"), headline(expected), head]
    assert re.match(r"condition +verdict +95% interval +window$", lines[4])
    assert max(map(len, lines[2:])) <= 80
    said = run_together(result.stdout)
    assert "because" not in said
    assert said.endswith("Terms are explained in docs/glossary.md. Written: found.json")
    assert load_json(Path("found.json"))["groups"] == {str(job / "1"): expected.to_json()}


def test_reasons_come_after_explain(job):
    said = run_together(matrixworld_command("judge", job / "1", "--explain").stdout)
    for name in CONDITIONS:
        assert re.search(rf"{name.capitalize()}: (present|absent|cannot tell), because ", said)


def test_runs_of_other_settings_and_files_are_groups_of_their_own(job):
    np.savez("file.npz", payoff=circular(31))
    sources = [job, "file.npz"]
    result = matrixworld_command("judge", *sources, "--json", "found.json")
    names = [f"{job / '1'}, {job / '2'}", f"{job / 'other'}", "file.npz"]
    assert [line for line in result.stdout.splitlines() if line in names] == names
    assert result.stdout.count("condition ") == 3
    found = load_json(Path("found.json"))["groups"]
    assert list(found) == names
    alone = matrixworld_command("judge", job / "other", "--json", "other.json")
    assert found[names[1]] == load_json(Path("other.json"))["groups"][names[1]]
    table = alone.stdout.partition("condition ")[2].partition("\n\n")[0]
    assert table in result.stdout


def test_each_judges_every_run_and_every_file(job):
    for name in ("a.npz", "b.npz"):
        np.savez(name, payoff=circular(31))
    sources = [job / "1", job / "2", "a.npz", "b.npz"]
    matrixworld_command("judge", *sources, "--each", "--json", "found.json")
    assert list(load_json(Path("found.json"))["groups"]) == [str(source) for source in sources]


def test_files_of_means_need_their_number_of_episodes():
    write_files()
    unknown = matrixworld_command("judge", "circle.csv").stdout
    assert judged_in(unknown)["cycling"] == judged_in(unknown)["forgetting"] == "cannot tell"
    assert "Give the number with --episodes." in run_together(unknown)
    known = matrixworld_command("judge", "circle.csv", "--episodes", 30).stdout
    assert judged_in(known)["intransitivity"] == "present"
    # Cycling and forgetting take the single episodes.
    assert judged_in(known)["cycling"] == judged_in(known)["forgetting"] == "cannot tell"
    assert "--episodes" not in known
    race = matrixworld_command("judge", "race.npz", "--episodes", 30).stdout
    assert judged_in(race)["arms race"] == "present"
    assert judged_in(race)["cycling"] == "absent"
    assert "What to try:\n  more generations" in race


def test_several_files_are_one_group():
    write_files()
    shutil.copy("race.npz", "again.npz")
    files = ["race.npz", "again.npz"]
    result = matrixworld_command("judge", *files, "--episodes", 30, "--json", "found.json")
    said = result.stdout.splitlines()
    assert (said[1], said[3][:18]) == ("race.npz, again.npz", "2 runs, 31 pursuer")
    means = np.array([means_of("race")] * 2)
    [found] = load_json(Path("found.json"))["groups"].values()
    assert found == judge(means, episodes=30).to_json()


BAD = [
    (["empty"], "expected run directories, or .csv or .npz files, got 'empty'"),
    (["bad.csv"], "expected a capture rate in [0, 1], got '2'"),
    (["small.npz", "large.npz"], "expected the shape of small.npz, (12, 12), got (14, 14)"),
    (["small.npz", "--all"], "", 0),
    (["one.npz", "--all"], "--all: expected at least 2 x 2 generations, got 1 x 3"),
    (["scores.npz", "--episodes", 6], "expected the 5 episodes of each cell that the payoffs hold"),
    (["scores.npz", "--episodes", 5], "", 0),
    (["race", "--episodes", 6], "expected the 4 episodes of each cell that the payoffs hold"),
    (["race", "copy"], "expected runs with different seeds, got the same run twice: race, copy"),
    (["alone"], "alone: expected a race, got a run in which one team evolved"),
    (["stopped"], "expected a finished run; matrixworld evolve --resume stopped"),
    (["damaged"], "payoff.npz: cut or altered", 1),
]


def test_what_cannot_be_judged_is_refused(job):
    Path("empty").mkdir()
    Path("bad.csv").write_text("0.5,2\n0.5,0.5\n")
    for name, size in (("small", 12), ("large", 14)):
        np.savez(f"{name}.npz", payoff=circular(size))
    np.savez("one.npz", payoff=np.full((1, 3), 0.5))
    np.savez("scores.npz", capture_rates=np.full((13, 13, 5), 0.5))
    start(tiny_single(), "alone", threads=1).run()
    with pytest.raises(KeyboardInterrupt):
        start(tiny_race(), "stopped", threads=1, play=StopAt(2)).run()
    for name in ("race", "copy", "damaged"):
        shutil.copytree(job / "1", name)
    Path("damaged/payoff.npz").write_bytes(Path("race/payoff.npz").read_bytes()[:99])
    for arguments, message, *code in BAD:
        [expected] = code or [2]
        refused = matrixworld_command("judge", *arguments, "--json", "x.json", code=expected)
        assert message in run_together(refused.stderr)
        assert Path("x.json").exists() == (expected == 0)
        Path("x.json").unlink(missing_ok=True)


def test_a_race_that_is_too_small_says_what_it_takes():
    np.savez("small.npz", capture_rates=np.random.default_rng(0).random((4, 4, 2)))
    told = matrixworld_command("judge", "small.npz").stdout
    said = run_together(told)
    assert set(judged_in(told).values()) == {"cannot tell"}
    assert "It takes at least 4 episodes of each cell" in said
    assert "It takes at least 6 generations of each team to judge a race, and 12 to " in said


# --all


def test_all_measures_come_after_the_judgement():
    write_files()
    options = ["--episodes", 30, "--all", "--json", "found.json"]
    result = matrixworld_command("judge", "circle.csv", *options)
    assert judged_in(result.stdout)["intransitivity"] == "present"
    table, measures = result.stdout.split("\nA single run (95% interval")
    assert "condition" in table
    share = MEASURES["transitive_share"].of(means_of("circle")).value
    assert re.search(rf"\n  last half\n(.*\n)+    transitive share +{share:.3f}", measures)
    assert "because" not in result.stdout
    [found] = load_json(Path("found.json"))["groups"].values()
    assert found["judgement"] == judge(means_of("circle"), episodes=30).to_json()
    assert found["measures"]["transitive_share"]["value"] == pytest.approx(share)


# One judgement of one run

EVOLVED = {**RACE, "generations": 13, "evaluation_episodes": 5, "schedule": "specialist-specialist"}


@pytest.fixture
def run(undrawn: None) -> tuple[Path, str]:
    """A race in the working directory, and what `evolve` printed."""
    told = matrixworld_command("evolve", "--out", "run", *words(EVOLVED), "--threads", 1).stdout
    return Path("run/specialist-specialist/seed-5"), told


def test_all_commands_come_to_the_same_judgement(run):
    path, evolved = run
    [group] = groups_of([path])
    rates = group.runs[0].payoff.capture_rates
    expected = judge(rates, per_episode=True)
    assert expected.window == "last half"
    for told in (evolved, matrixworld_command("evolve", "--resume", path).stdout):
        assert run_together(headline(expected)) in run_together(told)
        assert all(numbers in told for numbers in headline_numbers(expected))
    same = ["--seed", 5, "--episodes", 5, "--steps", 12]
    said = {
        "tournament": matrixworld_command("tournament", path, *same).stdout,
        "judge": matrixworld_command("judge", path, "--json", "d.json").stdout,
        "judge --all": matrixworld_command("judge", path, "--all", "--json", "a.json").stdout,
        "of the payoff's file": matrixworld_command("judge", path / "payoff.npz").stdout,
    }
    verdicts = {name: one.verdict for name, one in expected.headline.items()}
    for command, text in said.items():
        assert judged_in(text) == verdicts, command
        assert command == "tournament" or headline(expected) in text
        # Numbers, too.
        rows = said["judge"].partition("condition ")[2].partition("\n  ")[0].splitlines()
        assert all(row in text for row in rows[1:7]), command

    plain = expected.to_json()
    [judged] = load_json(Path("d.json"))["groups"].values()
    [analyzed] = load_json(Path("a.json"))["groups"].values()
    assert judged == analyzed["judgement"] == plain
    assert group.judgement.to_json() == plain
    [reported] = load_json(Path("run/summary.json"))["runs"].values()
    assert reported["judgement"] == plain
    assert set(reported["measures"]) == set(MEASURES)

    payoff = planned([group], path)[path / "payoff.png"]().axes[0].get_title()
    assert payoff == f"specialist-specialist, seed 5\n{headline(expected)}"
    two = group_figure("comparison", {"a": group, "b": group}, {})
    texts = [" ".join(text.get_text() for text in axes.texts) for axes in two.axes[:2]]
    assert all(headline(expected) in run_together(text) for text in texts)
    unjudged = plots.comparison({"a": rates.mean(axis=2)}).axes[0].texts[-1].get_text()
    assert run_together(unjudged).startswith("last half: transitive share")
