"""``matrixworld judge``: what it prints and writes, and that all commands judge alike."""

import re
from pathlib import Path

import numpy as np
import pytest

from command_line import RACE, evolved, judged_in, matrixworld_command, run_together, words
from matrices import circular, logistic
from matrixworld._util.files import read_json
from matrixworld._util.readable import plain_values
from matrixworld.analysis import CONDITIONS, MEASURES, judge, measure_all, read_payoffs
from matrixworld.analysis.judgement import summary
from matrixworld.cli.evaluate import print_strip
from matrixworld.coevolution import evolve
from matrixworld.coevolution.groups import open_groups
from tiny_race import tiny_race

EVOLVED = {**RACE, "generations": 13, "evaluation_episodes": 5, "schedule": "specialist-specialist"}
LONGER = {"generations": 12, "pursuer_epochs": 1, "evader_epochs": 1, "evaluation_episodes": 4}


def means_of(kind: str, episodes: int = 30) -> np.ndarray:
    """Mean capture rates of a race whose truth is known."""
    # So clear that 30 episodes suffice.
    chance = circular(31) if kind == "circle" else logistic(31, 0.3)
    return np.random.default_rng(0).binomial(episodes, chance) / episodes


def judged(*words: object) -> tuple[str, dict]:
    """Return what the command prints, and what it writes of each group."""
    told = matrixworld_command("judge", *words, "--json", "found.json", "--force").stdout
    return told, read_json(Path("found.json"))["groups"]


def test_runs_of_several_seeds_and_files(tmp_path):
    races = [tiny_race(seed=seed, **LONGER) for seed in (0, 1)]
    evolve([*races, tiny_race(schedule="specialist-specialist", **LONGER)], tmp_path / "job")
    np.savez("file.npz", payoff=circular(7))
    told, found = judged("job", "file.npz", "--explain")
    several, single = open_groups("job")[::-1]
    assert [*found] == [single.name, several.name, "file.npz"]
    for group, after in ((single, several.name), (several, "file.npz")):
        expected = judge(group.payoffs.scores, per_episode=True)
        assert found[group.name] == expected.to_json()
        part = told.partition(f"\n{group.name}\n")[2].partition(f"\n{after}\n")[0]
        assert run_together(part).startswith(run_together("\n".join(summary(expected))))
        verdicts = {name: finding.verdict for name, finding in expected.findings.items()}
        assert judged_in(part) == verdicts
        for name in CONDITIONS:
            assert re.search(rf"{name.capitalize()}: (present|absent|cannot tell), because ", part)
        hides_cycling = "Short races of specialists may hide cycling" in part
        assert hides_cycling == (group.name == single.name)
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


def test_a_strip_of_many_seeds_is_in_parts(capsys):
    scores = np.random.default_rng(0).random((70, 4, 4, 2))  # too many seeds for one line
    judgement = judge(scores, per_episode=True)
    print_strip(judgement, [*range(70)], [70])
    lines = capsys.readouterr().out.splitlines()
    assert max(map(len, lines)) <= 100
    heads = [line.split() for line in lines if line.startswith("seed")]
    assert [int(word) for head in heads for word in head[1:] if word.isdigit()] == [*range(71)]
    assert ["together" in head for head in heads] == [False] * (len(heads) - 1) + [True]
    signs = {"present": "+", "absent": "-", "cannot tell": "?"}
    rows = [line for line in lines if line.startswith("cycling")]
    shown = [sign for row in rows for sign in re.findall(r"(?<=  )[-+?.](?=\s|$)", row)]
    assert shown == [*(signs[verdict] for verdict in judgement.findings["cycling"].by_run), "."]


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
    assert "2 runs, 31 pursuer" in told
    twice = np.array([means_of("race")] * 2)
    assert found == {"race.npz, again.npz": judge(twice, episodes=30).to_json()}
    np.savez("small.npz", capture_rates=np.random.default_rng(0).random((4, 4, 2)))
    small, _ = judged("small.npz")
    assert "It takes at least 4 episodes of each cell" in run_together(small)
    assert "It takes at least 6 generations of each team to judge a race" in run_together(small)


@pytest.mark.usefixtures("undrawn")
def test_all_commands_come_to_the_same_judgement():
    told_by_evolve = evolved("--out", "run", *words(EVOLVED), "--threads", 1).stdout
    path = Path("run/specialist-specialist/seed-5")
    [group] = open_groups(path)
    expected = judge(group.payoffs.scores, per_episode=True)
    assert expected.window == "last half"
    same = ["--seed", 5, "--episodes", 5, "--steps", 12]
    told = {
        "judge": judged(path)[0],
        "tournament": matrixworld_command("tournament", path, *same).stdout,
        "of the payoff's file": judged(path / "payoff.npz")[0],
    }
    rows = told["judge"].partition("condition ")[2].partition("\n  ")[0].splitlines()
    for text in told.values():
        assert all(row in text for row in rows[1:7])  # verdicts and numbers
    said = run_together("\n".join(summary(expected)))
    assert all(said in run_together(text) for text in (*told.values(), told_by_evolve))
    [reported] = read_json(Path("run/summary.json"))["runs"].values()
    assert reported["judgement"] == expected.to_json()
    assert set(reported["measures"]) == set(MEASURES)
