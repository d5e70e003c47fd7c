"""Runs of every kind: stopped anywhere, they end as if never stopped; what they log and report."""

import numpy as np
import pytest

from matrixworld import Matches, Population, rollout
from matrixworld import coevolution as co
from matrixworld._util.files import load_arrays
from matrixworld._util.sections import names_in
from matrixworld.coevolution.learners.learner import DivergedError
from matrixworld.coevolution.seeding import evaluation_seed
from tiny_race import (
    WORLDS,
    Listening,
    StopAt,
    alternating,
    check_resumes,
    hall_of_fame,
    played,
    playing,
    results,
    straight,
    tiny_race,
    tiny_single,
)

SAMPLERS = names_in(co.opponents.Opponents)
IN_WORLDS = {
    "in turns": tiny_race(training_worlds=WORLDS),
    "psro": tiny_race(training_worlds=WORLDS, schedule="psro", retest_episodes=1),
    "at once": tiny_race(training_worlds=WORLDS, schedule="hall-of-fame"),
    "alone": tiny_single(training_worlds=WORLDS, learner="cma"),
}
RETEST = {"retest_episodes": 2, "match_episodes": 2, "train_steps": 20}
GA = {"learner": "ga", "elites": 3, "population": 8}
OWN = {"learner": "own_code:HillClimber", "learner.settings": {"sigma": 0.2}}
OWN_MEET = {
    "pursuers_meet": {"kind": "own", "code": "own_code:Hardest", "settings": {"forget": 0.25}},
    "evaders_meet": "own_code:Oldest",
}

RUNS = {
    "race": (tiny_race(), [0, 1, 4, 9, 11]),
    "cma": (tiny_race(learner="cma"), [6]),
    "ga": (tiny_race(learner="ga"), [6]),
    "a learner for each team": (tiny_race(evader_learner={"kind": "ga", "population": 6}), [6]),
    "annealed momentum": (tiny_race(momentum=0.9, anneal=True), [6]),
    "memory": (tiny_race(memory="gru"), [6]),
    "mask": (tiny_race(mask="obstacles"), [6]),
    "hall of fame": (hall_of_fame(), [0, 3, 8]),
    "hall of fame of ga": (hall_of_fame(learner="ga"), [3]),
    "hall of fame of cma": (hall_of_fame(learner="cma"), [3]),
    "hall of fame alone": (hall_of_fame(contemporaries=0), [3]),
    "contemporaries alone": (hall_of_fame(hall_sample=0), [3]),
    "alone": (tiny_single(team="evader", learner="ga"), [0, 3, 5]),
    **{f"worlds of training: {name}": (each, [1, 4]) for name, each in IN_WORLDS.items()},
    **{f"in turns: {name}": (alternating(name), [7]) for name in SAMPLERS},
    **{f"joint: {name}": (hall_of_fame(name, generations=4), [7]) for name in SAMPLERS},
    "retest in turns": (alternating(**RETEST, **GA), [5]),
    "retest of es": (alternating(**RETEST), [8]),
    "retest of a hall of fame": (hall_of_fame(**RETEST, **GA), [5]),
    "retest alone": (tiny_single(**RETEST, **GA, team="evader"), [8]),
    "own code in turns": (alternating(**OWN, **OWN_MEET, generations=2), [0, 5, 10]),
    "own code in a hall of fame": (hall_of_fame(**OWN, **OWN_MEET, generations=2), [2, 5]),
    "retest of own code": (tiny_race(**OWN, retest_episodes=2), [4, 9, 14]),
    "own code alone": (tiny_single(team="evader", **OWN), [1, 4]),
}
"""Settings of runs, and the calls of `rollout` at which they are stopped. A tiny race has 10 epochs
and 3 rows of the payoff matrix, each of which is a call."""
STOPS = [(name, call) for name, (_, calls) in RUNS.items() for call in calls]


@pytest.mark.parametrize(("name", "call"), STOPS)
def test_a_stopped_run_ends_as_if_never_stopped(name, call, tmp_path):
    settings = RUNS[name][0]
    check_resumes(settings, call, tmp_path / "run")
    archive = co.open_run(tmp_path / "run").archive()
    for team in settings.learning_teams:
        # An elite may stay the champion of a genetic algorithm.
        assert len(np.unique(archive[team], axis=0)) > 1 or settings.learner.kind == "ga"


@pytest.mark.parametrize("name", RUNS)
def test_matches_and_epochs_are_counted_and_logged(name, tmp_path):
    settings, listening = RUNS[name][0], Listening()
    run = played(settings, tmp_path / "run", play=listening)
    evaluated = run.payoff().extras["lengths"].size
    games = sum(scores.length.size for *_, scores in listening.calls)
    training, summary, log = games - evaluated, run.summary(), run.log()
    assert (summary["training_matches"], summary["evaluation_matches"]) == (training, evaluated)
    assert log["matches"][-1] == training
    assert log["steps"][-1] == summary["training_steps"]
    assert (np.diff(log["matches"]) >= 0).all()
    assert len({*zip(log["stage"], log["epoch"], strict=True)}) == settings.schedule.epochs_until(
        settings.schedule.n_stages
    )


@pytest.mark.parametrize("settings", [tiny_race(), hall_of_fame(), alternating("nash")])
def test_a_race_in_memory_is_the_one_in_a_directory(settings, tmp_path):
    run, race = played(settings, tmp_path / "run"), co.Training(settings, threads=1)
    assert co.train(race) is race
    for team, genomes in run.archive().items():
        np.testing.assert_array_equal(race.genomes(team), genomes)
    fitness = [f"{row['fitness_mean']:.9g}" for row in race.rows]
    assert fitness == [f"{mean:.9g}" for mean in run.log()["fitness_mean"]]
    assert race.counts["matches"] == run.summary()["training_matches"]
    with pytest.raises(ValueError, match="expected those of a race, got those of one team alone"):
        co.Training(tiny_single())


def test_another_seed_is_another_race():
    ours, theirs = straight(tiny_race(seed=6)), straight(tiny_race())
    assert all(ours[name] != theirs[name] for name in ours)


def test_every_cell_can_be_replayed_alone(race):
    playing(co.Run(race), StopAt(0)).run()  # of a finished run nothing is played
    run = co.open_run(race)
    settings, payoff = run.settings, run.payoff()
    assert payoff.scores.shape == (3, 3, 3)
    teams = [
        Population(run.archive()[team], settings.evaluation_game.policies[team])
        for team in co.TEAMS
    ]
    for g, h in [(0, 2), (2, 0), (1, 1)]:
        seed = evaluation_seed(settings.seed, g, h)
        scores = rollout(settings.game.world, *teams, Matches.of(g, h, seed), episodes=3)
        assert np.array_equal(scores.capture_rate[0], payoff.scores[g, h])
        assert np.array_equal(scores.length[0], payoff.extras["lengths"][g, h])
        assert np.array_equal(scores.faults[0].mean(axis=0), payoff.extras["faults"][g, h])
        assert run.record(g, h, episode=1).length == payoff.extras["lengths"][g, h, 1]
    assert np.array_equal(run.record(-1, -3).positions, run.record(2, 0).positions)
    with pytest.raises(IndexError):
        run.record(0, 3)


def test_the_files_hold_means_and_deviations(race):
    arrays, payoff = load_arrays(race / "payoff.npz"), co.open_run(race).payoff()
    assert np.allclose(arrays["mean"], payoff.scores.mean(axis=2))
    assert np.allclose(arrays["std"], payoff.scores.std(axis=2), atol=1e-6)
    assert (arrays["collisions"] >= arrays["faults"]).all()


def test_runs_are_compared_at_equal_budgets(tmp_path):
    run = played(alternating("latest", opponents=1, match_episodes=2), tmp_path / "run")
    # Generations of 2 pursuer epochs and 3 evader epochs of 4 candidates in 2 worlds: 16, then 24.
    at = {n: tuple(run.generation_at(team, n) for team in co.TEAMS) for n in (15, 16, 39, 40)}
    assert at == {15: (0, 0), 16: (1, 0), 39: (1, 0), 40: (1, 1)}
    assert run.generation_at("pursuer", 10**6) == run.generation_at("evader", 160) == 4
    assert run.generation_at("evader", 159) == 3


def test_progress_is_reported_when_asked(tmp_path):
    seen = []
    played(tiny_race(), tmp_path / "run", report=seen.append)
    assert [each.done for each in seen] == [*range(1, 11), 10, 12, 14, 17]
    assert {(each.before, each.total) for each in seen} == {(0, 17)}
    assert (seen[0].what, seen[-1].what) == ("generation 1: pursuers", "tournament")


def test_a_logger_is_told_where_a_run_is(tmp_path, caplog):
    caplog.set_level("INFO", logger="matrixworld")
    played(tiny_race(generations=1), tmp_path / "run")
    told = [record.getMessage().removeprefix(f"{tmp_path / 'run'}: ") for record in caplog.records]
    assert told == [
        "goes on from stage 0 of 2", "saved stage 1 of 2", "saved stage 2 of 2", "ended",
    ]  # fmt: skip


@pytest.mark.parametrize(
    "settings",
    [hall_of_fame(seed=2, generations=2), tiny_single(seed=3, learner="ga"), tiny_race(**RETEST)],
    ids=["hall-of-fame", "single", "retest"],
)
def test_a_callback_is_told_each_epoch_can_stop_the_run_and_changes_no_byte(settings, tmp_path):
    expected = played(settings, tmp_path / "without").rows(0)
    rows = []

    def on_epoch(row):
        rows.append(dict(row))
        row.clear()  # what the caller does with it is not the run's business
        if len(rows) == 3:
            raise co.StopRun

    with pytest.raises(co.StopRun):
        played(settings, tmp_path / "with", on_epoch=on_epoch)
    assert len(rows) == 3 < len(expected)
    assert not co.open_run(tmp_path / "with").finished
    played(settings, tmp_path / "with", on_epoch=on_epoch)
    by_epoch = {(row["stage"], row["team"], row["epoch"]): row for row in rows}
    # Matches that choose a champion are played, and counted, after the row was told.
    later = {"matches", "steps"} if settings.retest_episodes else set()
    for row, logged in zip(by_epoch.values(), expected, strict=True):
        assert (row.pop("run"), row.pop("seed")) == ("with", settings.seed)
        assert row.keys() == logged.keys()
        assert row["team"] == logged["team"]
        for name in row.keys() - later - {"team"}:
            assert row[name] == pytest.approx(logged[name], rel=1e-8), name
    assert results(tmp_path / "with") == results(tmp_path / "without")


def test_disengagement_causes_one_warning(tmp_path):
    def disengaged(*args, **options):
        scores = rollout(*args, **options)
        scores.capture_rate[:] = 1.0
        return scores

    with pytest.warns(
        co.DisengagementWarning, match="the pursuers win nearly all matches"
    ) as caught:
        run = played(tiny_race(generations=5), tmp_path / "run", play=disengaged)
    assert len(caught) == 1
    assert run.newest() == 10
    (sentence,) = run.summary()["disengagement"]
    assert sentence.startswith("generations 1 to 5")


# Learners that leave the range of float32: refused before the archive.

ES = {"learner": "es", "learning_rate": 1e39}
DIVERGING = {
    "evaders": (tiny_race(evader_learner={"kind": "ga", "mutation": 2e38}), "mutation"),
    "es": (tiny_race(**ES), "learning_rate"),
    "hall of fame": (hall_of_fame(**ES), "learning_rate"),
    "ga": (tiny_race(learner="ga", mutation=2e38), "mutation"),
    "cma": (tiny_race(learner="cma", sigma=1e300), "sigma"),
    "actor": (tiny_race(learner="actor-critic", population=2, actor_rate=1e30), "actor_rate"),
    "critic": (tiny_race(learner="actor-critic", population=2, critic_rate=1e30), "critic_rate"),
}


@pytest.mark.parametrize("kind", DIVERGING)
def test_the_run_stays_readable_to_its_last_good_generation(kind, tmp_path):
    settings, lower = DIVERGING[kind]
    if settings.learner.kind == "actor-critic":
        pytest.importorskip("torch")
    section = "schedule.evader_learner" if kind == "evaders" else "learner"
    learner = settings.learner_settings("evader" if kind == "evaders" else "pursuer")
    with pytest.raises(DivergedError, match=f"^{section} {learner.kind}: .*lower ") as told:
        played(settings, tmp_path / "run")
    assert f"{section}.{lower} (now {getattr(learner, lower):g})" in str(told.value)
    assert np.isfinite(co.open_run(tmp_path / "run").teams["pursuer"].genomes).all()
    left = co.Run(tmp_path / "run", threads=1)
    assert 0 <= left.training.stage < settings.schedule.n_stages
    with pytest.raises(DivergedError):
        left.run()
