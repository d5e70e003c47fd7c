"""All commands come to the same judgement of the same run."""

from __future__ import annotations

from pathlib import Path

import pytest

from command_line import RACE, judged_in, matrixworld_command, words
from matrixworld import plots
from matrixworld._util.files import load_json
from matrixworld.analysis import headline, judge
from matrixworld.cli import figures
from matrixworld.cli.jobs import open_result

LONGER = {**RACE, "generations": 13, "eval_episodes": 5, "schedule": "specialist-specialist"}


@pytest.fixture
def run(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> tuple[Path, str]:
    """A race in the working directory, and what `evolve` printed."""
    monkeypatch.chdir(tmp_path)
    told = matrixworld_command("evolve", "run", *words(LONGER), "--threads", 1).stdout
    return Path("run/specialist-specialist/seed-5"), told


def test_all_commands_come_to_the_same_judgement(run, monkeypatch):
    path, evolved = run
    result = open_result(path)
    expected = judge(result.payoff.capture_rates, per_episode=True)
    assert expected.window == "last half"
    same = ["--seed", 5, "--episodes", 5, "--steps", 12]
    said = {
        "evolve": evolved,
        "resume": matrixworld_command("evolve", "--resume", path).stdout,
        "tournament": matrixworld_command("tournament", path, *same).stdout,
        "diagnose": matrixworld_command("diagnose", path, "--json", "d.json").stdout,
        "analyze": matrixworld_command("analyze", path, "--json", "a.json").stdout,
        "of the payoff's file": matrixworld_command("diagnose", path / "payoff.npz").stdout,
    }
    verdicts = {name: one.verdict for name, one in expected.headline.items()}
    for command, text in said.items():
        assert judged_in(text) == verdicts, command
        # Numbers, too.
        rows = said["evolve"].partition("condition ")[2].partition("\n  ")[0].splitlines()
        assert all(row in text for row in rows[1:7]), command

    plain = expected.to_json()
    assert load_json(Path("d.json")) == plain
    assert load_json(Path("a.json"))["judgement"] == plain
    assert result.numbers["judgement"] == plain
    assert result.judgement.to_json() == plain

    drawn = []
    monkeypatch.setattr(figures, "save_figure", lambda figure, path: drawn.append(figure) or path)
    figures.draw_comparison({"a": result, "b": result}, Path("x.png"))
    assert all(
        headline(expected) in [text.get_text() for text in axes.texts] for axes in drawn[0].axes[:2]
    )
    figures.draw_run(result)
    titles = {axes.get_title() for figure in drawn for axes in figure.axes}
    assert f"specialist-specialist, seed 5\n{headline(expected)}" in titles
    assert plots.comparison({"a": result.payoff.capture_rate}).axes[0].texts[-1].get_text() == ""
