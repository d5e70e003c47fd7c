"""Games that processes play: equal scores for any number, and processes that die."""

import importlib
import os
import sys
import warnings
from concurrent.futures import BrokenExecutor
from multiprocessing import active_children

import numpy as np
import pytest

import matrixworld as mw
from matrixworld import coevolution as co
from matrixworld.coevolution.games.workers import Part, end_workers, parts_of
from matrixworld.coevolution.jobs.job import shares
from scripts import python
from tiny_race import results

SLOW = """
import os, pathlib
import matrixworld as mw
HERE = pathlib.Path(__file__).parent
def play(one, other, rng):
    (HERE / f"played-by-{os.getpid()}").touch()
    if (HERE / "kill").exists():
        if (HERE / "kill").read_text() == "once":
            (HERE / "kill").unlink()
        os._exit(3)
    if (HERE / "fail").exists():
        raise ArithmeticError("of the game")
    return float(rng.random() < one / (one + other))
game = mw.Game(play, teams=("hawks", "doves"), initial=lambda rng: int(rng.integers(1, 9)),
               mutate=lambda genome, rng: genome % 9 + 1, slow=True)
vectors = mw.Game(lambda a, b, rng: rng.random(len(a)), genes=2, teams=("a", "b"), slow=True)
"""
TINY = {
    "schedule": "hall-of-fame", "schedule.generations": 3, "schedule.joint_epochs": 2, "seed": 1,
    "learner.population": 6,
}  # fmt: skip


@pytest.fixture
def slow(tmp_path, monkeypatch):
    """A module with slow games."""
    (tmp_path / "slow_games.py").write_text(SLOW)
    monkeypatch.syspath_prepend(tmp_path)
    importlib.invalidate_caches()
    yield importlib.import_module("slow_games")
    del sys.modules["slow_games"]


def scores(game, threads, count=5, episodes=3):
    rng = np.random.default_rng(0)
    teams = [
        game.population(team, np.stack([game.untrained(team, rng) for _ in range(count)]))
        for team in co.TEAMS
    ]
    every = np.arange(count)
    matches = every, every[::-1], every.astype(np.uint64)
    return game.rollout(*teams, matches, episodes=episodes, threads=threads).scores


def players(path):
    return {int(each.name.rpartition("-")[2]) for each in path.glob("played-by-*")}


def test_processes_have_the_scores_of_one(slow, tmp_path):
    for game in (slow.game, slow.vectors):
        alone = scores(game, 1)
        for threads in (2, 3):
            np.testing.assert_array_equal(scores(game, threads), alone)
        # One match of many episodes is shared, too.
        np.testing.assert_array_equal(scores(game, 2, 1, 40), scores(game, 1, 1, 40))
    assert os.getpid() in players(tmp_path)
    assert len(players(tmp_path)) > 2


@pytest.mark.parametrize(("matches", "episodes"), [(1, 1), (1, 7), (3, 2), (20, 1), (2, 30)])
@pytest.mark.parametrize("count", [1, 2, 8])
def test_parts_are_all_matches_once(matches, episodes, count):
    numbers = np.arange(matches)
    whole = Part(numbers, numbers, numbers.astype(np.uint64), range(episodes))
    parts = parts_of(whole, count)
    played = [(int(m), n) for part in parts for m in part.seeds for n in part.episodes]
    assert sorted(played) == [(m, n) for m in range(matches) for n in range(episodes)]
    assert len(parts) >= min(count, matches * episodes)


def test_a_process_that_dies_is_told_and_its_matches_are_played_again(slow, tmp_path):
    expected = scores(slow.game, 1)
    (tmp_path / "kill").write_text("once")
    with pytest.warns(UserWarning, match="slow_games:game: a process has died; its matches are"):
        np.testing.assert_array_equal(scores(slow.game, 2), expected)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        np.testing.assert_array_equal(scores(slow.game, 2), expected)


def test_processes_that_die_again_and_again_are_an_error(slow, tmp_path):
    (tmp_path / "kill").write_text("always")
    with (
        pytest.warns(UserWarning, match="died"),
        pytest.raises(BrokenExecutor, match="3 that died in success"),
    ):
        scores(slow.game, 2)
    (tmp_path / "kill").unlink()
    assert scores(slow.game, 2).shape == (5, 3)


def test_an_error_of_the_game_is_raised_as_it_is(slow, tmp_path):
    (tmp_path / "fail").touch()
    with pytest.raises(ArithmeticError, match="of the game"):
        scores(slow.game, 2)


def test_a_race_is_the_same_for_any_number_of_processes(slow, tmp_path):
    settings = co.RaceSettings.of(TINY, game=slow.game)
    mw.check_game(slow.game, matches=4)
    alone = co.finish(co.create(settings, tmp_path / "alone").path, threads=1)
    both = co.finish(co.create(settings, tmp_path / "both").path, threads=2)
    assert results(alone.path) == results(both.path)
    # A job of seeds divides the cores: two runs of two processes.
    job = co.evolve([settings, settings.changed({"seed": 2})], tmp_path / "job", threads=4)
    assert results(job[0].path) == results(alone.path)


def test_a_race_that_fails_leaves_no_processes(slow, tmp_path):
    settings = co.RaceSettings.of(TINY, game=slow.game)
    processes_before = set(active_children())

    def fails(epoch):
        assert set(active_children()) - processes_before
        raise OSError("no space")

    with pytest.raises(OSError, match="no space"):
        co.evolve(settings, tmp_path / "run", threads=2, on_epoch=fails)
    assert not set(active_children()) - processes_before


def test_a_match_that_kills_its_process_kills_no_run_of_a_job(slow, tmp_path):
    settings = [co.RaceSettings.of(TINY, game=slow.game, seed=seed) for seed in (1, 2)]
    expected = [results(co.evolve(each, tmp_path / f"{each.seed}").path) for each in settings]
    (tmp_path / "kill").write_text("once")
    with warnings.catch_warnings():
        warnings.simplefilter("error")  # of this process: the run's own plays the matches again
        runs = co.evolve(settings, tmp_path / "job", threads=2)
    assert [results(run.path) for run in runs] == expected
    assert not (tmp_path / "kill").exists()


def test_a_game_that_changed_after_the_import_is_refused(slow, tmp_path):
    scores(slow.game, 2)
    end_workers(slow.game)
    (tmp_path / "slow_games.py").write_text(SLOW.replace("% 9 + 1", "% 8 + 1 + 0"))
    with pytest.raises(ValueError, match="got one of another source"):
        scores(slow.game, 2)


NOTEBOOK = """
import matrixworld as mw, numpy as np
game = mw.Game(lambda one, other: 0.5, teams=("a", "b"), initial=lambda rng: 1,
               mutate=lambda genome, rng: 2, deterministic=True, slow=True)
both = game.population("pursuer", np.array([["1"], ["2"]]))
matches = np.arange(2), np.arange(2), np.zeros(2, np.uint64)
print(game.rollout(both, both, matches, episodes=1, threads=2).scores.ravel())
"""


def test_a_game_of_a_notebook_is_played_here_and_a_sentence_says_so(tmp_path):
    done = python("-c", NOTEBOOK, cwd=tmp_path)
    assert done.stdout == "[0.5 0.5]\n"
    assert "put it into a module" in done.stderr


@pytest.mark.parametrize(
    ("runs", "threads", "of_own_game", "of_pursuit"),
    [
        (2, 2, (2, 1), (1, 2)),
        (2, 8, (2, 4), (2, 4)),
        (20, 4, (4, 1), (4, 1)),
        (1, 2, (1, 2), (1, 2)),
    ],
)
def test_runs_of_a_game_of_ones_own_are_side_by_side(runs, threads, of_own_game, of_pursuit):
    assert shares(runs, threads, in_threads=False) == of_own_game
    assert shares(runs, threads) == of_pursuit
