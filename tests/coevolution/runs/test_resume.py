"""Runs of every kind: stopped anywhere, they end as if never stopped; all matches are counted."""

from typing import Any

import numpy as np
import pytest
from matrixworld.coevolution.schedules import ARCHIVES, SAMPLERS

from matrixworld import coevolution, rollout
from matrixworld.analysis.games import META_SOLVERS
from tiny_race import (
    StopAt,
    alternating,
    check_resumes,
    hall_of_fame,
    results,
    straight,
    tiny_race,
    tiny_single,
)

ELITE: dict[str, Any] = {
    "learner": "ga", "elites": 3, "elite_episodes": 2, "population": 8, "match_episodes": 2,
}  # fmt: skip
LONGER = {"generations": 3, "train_steps": 20}
RETENTION = {"retention_episodes": 2, **LONGER}
CALLS = 13
"""Calls of `rollout` in a tiny race: one for each of 10 epochs and 3 rows of the payoff matrix."""

RUNS: dict[str, tuple[coevolution.RaceSettings, Any]] = {
    "race": (tiny_race(), range(CALLS)),
    "cma": (tiny_race(learner="cma"), [6]),
    "ga": (tiny_race(learner="ga"), [6]),
    "a learner for each team": (tiny_race(evader_learner={"kind": "ga", "population": 6}), [6]),
    "annealed momentum": (tiny_race(momentum=0.9, anneal=True), [6]),
    "hall of fame": (hall_of_fame(), [0, 3, 7]),
    "hall of fame of ga": (hall_of_fame(learner="ga"), [0, 3, 7]),
    "hall of fame of cma": (hall_of_fame(learner="cma"), [3]),
    "hall of fame alone": (hall_of_fame(contemporaries=0), [3]),
    "contemporaries alone": (hall_of_fame(hall_sample=0), [3]),
    "alone": (tiny_single(team="evader", learner="ga"), range(6)),
    **{f"in turns: {name}": (alternating(name), [7]) for name in SAMPLERS},
    **{f"joint: {name}": (hall_of_fame(name, generations=4), [7]) for name in SAMPLERS},
    "elite in turns": (alternating(**ELITE, **LONGER), [5, 8]),
    "elite of a hall of fame": (hall_of_fame(**ELITE, **LONGER), [5, 8]),
    "elite of archives": (
        alternating(**ELITE, **LONGER, pursuers_meet="ipca", evaders_meet="lapca"),
        [5, 8],
    ),
    "elite alone": (tiny_single(**ELITE, team="evader", train_steps=20), [5, 8]),
    "retention in turns": (alternating(**RETENTION, match_episodes=2), [5, 8]),
    "retention of cma": (alternating(**RETENTION, learner="cma", hidden=()), [5, 8]),
    "retention of a hall of fame": (hall_of_fame(**RETENTION), [5, 8]),
    "both": (alternating(**ELITE, **{**RETENTION, "retention_episodes": 1}), [5, 8]),
}
"""Settings of runs, and the calls of `rollout` at which they are stopped."""
STOPS = [(name, call) for name, (_, calls) in RUNS.items() for call in calls]


@pytest.mark.parametrize(("name", "call"), STOPS)
def test_a_stopped_run_ends_as_if_never_stopped(tmp_path, name, call):
    check_resumes(RUNS[name][0], call, tmp_path / "run")


@pytest.mark.parametrize("name", RUNS)
def test_matches_are_counted_predicted_and_logged(tmp_path, name):
    played = 0

    def counting(*args, **options):
        nonlocal played
        scores = rollout(*args, **options)
        played += scores.length.size
        return scores

    run = coevolution.start(RUNS[name][0], tmp_path / "run", play=counting)
    payoff = run.run()
    training = played - payoff.lengths.size
    summary, log = run.files.summary(), run.files.log()
    assert run.training.matches == summary["training_matches"] == training
    assert log["matches"][-1] == training
    assert log["steps"][-1] == summary["training_steps"]
    assert (np.diff(log["matches"]) >= 0).all()
    predicted = run.total_matches() - payoff.lengths.size
    # An archive does not play again what it knows.
    archives = any(archive in name for archive in ("archives", *ARCHIVES, *META_SOLVERS))
    assert training <= predicted if archives else training == predicted


@pytest.mark.parametrize("threads", [1, 3])
def test_threads_change_nothing(tmp_path, threads):
    coevolution.start(tiny_race(), tmp_path / "run", threads=threads).run()
    assert results(tmp_path / "run") == straight(tiny_race())


def test_another_seed_is_another_race():
    ours, theirs = straight(tiny_race(seed=6)), straight(tiny_race())
    assert all(ours[name] != theirs[name] for name in ours)


def test_finish_starts_continues_or_opens_a_run(tmp_path):
    settings, place = alternating("uniform"), tmp_path / "run"
    with pytest.raises(KeyboardInterrupt):
        coevolution.finish(settings, place, play=StopAt(5))
    run = coevolution.finish(settings, place, threads=1)
    assert results(place) == straight(settings)
    assert run.payoff().capture_rate.shape == (5, 5)
    # A finished run is opened, by all of them, and nothing is played.
    again = coevolution.finish(settings, place, play=StopAt(0))
    resumed = coevolution.resume(place, play=StopAt(0)).run()
    for payoff in (again.payoff(), resumed):
        assert np.array_equal(payoff.lengths, run.payoff().lengths)
    assert results(place) == straight(settings)
    with pytest.raises(ValueError, match="run: holds a run with other settings: seed$"):
        coevolution.finish(alternating("uniform", seed=9), place)
