"""Learners of the package that leave the range of float32: refused before the archive."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from command_line import RACE, matrixworld_command, words
from matrixworld.coevolution import TEAMS, open_run, resume, start
from matrixworld.coevolution.learners.learner import DivergedError
from tiny_race import hall_of_fame, tiny_race, tiny_single

ES: dict[str, Any] = {"learner": "es", "learning_rate": 1e39}
RUNS = {
    "es": (tiny_race(**ES), "learning_rate"),
    "momentum": (tiny_race(**ES, momentum=0.9), "learning_rate"),
    "later": (tiny_race(learner="es", learning_rate=1e38, generations=9), "learning_rate"),
    "hall of fame": (hall_of_fame(**ES), "learning_rate"),
    "one team": (tiny_single(**ES), "learning_rate"),
    "noise": (tiny_race(learner="es", sigma=1e300), "sigma"),
    "ga": (tiny_race(learner="ga", mutation=2e38), "mutation"),
}
ACTOR_CRITIC: list[dict[str, Any]] = [{"actor_rate": 1e30}, {"critic_rate": 1e30}]


def check_diverges(settings: Any, lower: str, directory: Any) -> None:
    run = start(settings, directory, threads=1)
    kind, value = settings.learner.kind, getattr(settings.learner, lower)
    with pytest.raises(DivergedError, match=f"^learner {kind}: .*lower ") as caught:
        run.run()
    assert f"learner.{lower} (now {value:g})" in str(caught.value)
    left = resume(directory, threads=1)
    for team in TEAMS:
        assert np.isfinite(left.genomes(team)).all()
    assert 0 <= left.stage < left.n_stages
    assert open_run(directory).teams["pursuer"].genomes.shape[0] >= 1
    with pytest.raises(DivergedError):
        left.run()


@pytest.mark.parametrize("kind", RUNS)
def test_the_run_stays_readable_to_its_last_good_generation(kind, tmp_path):
    check_diverges(*RUNS[kind], tmp_path / "run")


@pytest.mark.parametrize("changes", ACTOR_CRITIC, ids=str)
def test_actor_critic(changes, tmp_path):
    pytest.importorskip("torch")
    [(name, _)] = changes.items()
    settings = tiny_race(learner="actor-critic", population=2, generations=3, **changes)
    check_diverges(settings, name, tmp_path / "run")


def test_the_command_says_in_one_sentence_what_to_lower(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    options = {**RACE, "schedule": "generalist-generalist", "learning_rate": 1e39}
    said = matrixworld_command("evolve", "--out", "out", *words(options), code=1).stderr
    assert said.splitlines()[-1].startswith("Error: learner es: expected finite genes")
    assert "lower learner.learning_rate (now 1e+39)" in said
    assert "Traceback" not in said
