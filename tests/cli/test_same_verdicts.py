"""All commands come to the same judgement of the same run."""

from __future__ import annotations

from pathlib import Path

import pytest

from command_line import RACE, judged_in, matrixworld_command, words
from matrixworld import plots
from matrixworld._util.files import load_json
from matrixworld.analysis import headline, judge
from matrixworld.cli.figures import OF_GROUPS, planned
from matrixworld.cli.groups import groups_of

LONGER = {**RACE, "generations": 13, "eval_episodes": 5, "schedule": "specialist-specialist"}


@pytest.fixture
def run(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> tuple[Path, str]:
    """A race in the working directory, and what `evolve` printed."""
    monkeypatch.chdir(tmp_path)
    told = matrixworld_command("evolve", "run", *words(LONGER), "--threads", 1).stdout
    return Path("run/specialist-specialist/seed-5"), told


def test_all_commands_come_to_the_same_judgement(run):
    path, evolved = run
    [group] = groups_of([path])
    rates = group.runs[0].payoff.capture_rates
    expected = judge(rates, per_episode=True)
    assert expected.window == "last half"
    same = ["--seed", 5, "--episodes", 5, "--steps", 12]
    said = {
        "evolve": evolved,
        "resume": matrixworld_command("evolve", "--resume", path).stdout,
        "tournament": matrixworld_command("tournament", path, *same).stdout,
        "judge": matrixworld_command("judge", path, "--json", "d.json").stdout,
        "judge --all": matrixworld_command("judge", path, "--all", "--json", "a.json").stdout,
        "of the payoff's file": matrixworld_command("judge", path / "payoff.npz").stdout,
    }
    verdicts = {name: one.verdict for name, one in expected.headline.items()}
    for command, text in said.items():
        assert judged_in(text) == verdicts, command
        # Numbers, too.
        rows = said["evolve"].partition("condition ")[2].partition("\n  ")[0].splitlines()
        assert all(row in text for row in rows[1:7]), command

    plain = expected.to_json()
    [judged] = load_json(Path("d.json"))["groups"].values()
    [analyzed] = load_json(Path("a.json"))["groups"].values()
    assert judged == analyzed["judgement"] == plain
    assert group.runs[0].numbers["judgement"] == plain
    assert group.judgement.to_json() == plain

    payoff = planned([group], path)[path / "payoff.png"]().axes[0].get_title()
    assert payoff == f"specialist-specialist, seed 5\n{headline(expected)}"
    two = OF_GROUPS["comparison"]({"a": group, "b": group}, {})
    texts = [[text.get_text() for text in axes.texts] for axes in two.axes[:2]]
    assert all(headline(expected) in text for text in texts)
    assert plots.comparison({"a": rates.mean(axis=2)}).axes[0].texts[-1].get_text() == ""
