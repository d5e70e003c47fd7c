"""``matrixworld replay``, ``tournament`` and ``score``: what is played, shown and written."""

import json
import shutil
from pathlib import Path

import numpy as np
import pytest

from command_line import GIF, PNG, matrixworld_command, run_together
from matrixworld import Episode, WorldConfig, record
from matrixworld._util.teams import PLURALS
from matrixworld.coevolution import create, open_run, score
from matrixworld.coevolution.evaluation.scores import best_scripts, score_table
from matrixworld.coevolution.seeding import evaluation_seed
from matrixworld.episodes import replay
from matrixworld.play import save_genome
from matrixworld.world import render
from tiny_race import tiny_race

STILL = ["O", "--pursuer", "still", "--evader", "still"]


def replayed(*words):
    return matrixworld_command("replay", *words).stdout


def played(*words):
    return matrixworld_command("tournament", *words).stdout


def test_an_episode_of_the_payoff_is_played_again(race):
    match = ["--pursuer", 2, "--evader", -3, "--episode", 1]
    replayed(race.parent, *match, "--out", "match.gif")
    said = replayed(race.parent, *match, "--out", "match.npz")
    payoff, episode = open_run(race).payoff(), Episode.load("match.npz")
    assert episode.length == payoff.extras["lengths"][2, 0, 1]
    assert episode.capture_rate == pytest.approx(payoff.scores[2, 0, 1])
    assert Path("match.gif").read_bytes().startswith(GIF)
    caught = int(episode.counted[-1].sum())
    told = f"{caught} of 3 evaders captured, {episode.length} steps"
    assert said == f"{told}  match.npz\n"
    again = replayed("match.npz")
    assert again.startswith(f"step {episode.length} of {episode.length}")
    assert again.endswith(f"\n{told}\n")
    assert replayed(race) == replayed(race, "--pursuer", 2, "--evader", 2, "--episode", 0)


def test_a_genome_of_a_file_plays_as_in_its_run(race):
    run = open_run(race)
    save_genome(Path("champion.npz"), "pursuer", run.policy("pursuer"))
    replayed(race, "--pursuer", "champion.npz", "--out", "again.npz")
    again = Episode.load("again.npz")
    expected = record(
        run.settings.game.world,
        run.policy("pursuer").population(),
        run.teams["evader"],
        seed=evaluation_seed(run.settings.seed, 0, 2),
        evader=2,
    )
    assert np.array_equal(again.positions, expected.positions)


def test_a_variant_is_a_game_of_scripts():
    world = ["--rows", 12, "--cols", 9, "--obstacles", 0.1, "--steps", 40, "--seed", 7]
    game = ["pursuit-evasion-sb", "--episode", 2, "--evader", "random", *world]
    replayed(*game, "--out", "a.npz")
    replayed(*game, "--numbers", "--step", 3, "--out", "a.PNG")
    config = WorldConfig("SB", rows=12, cols=9, obstacles=0.1, max_steps=40)
    expected = record(config, "chaser", "random", seed=7, episode=2)
    assert np.array_equal(Episode.load("a.npz").positions, expected.positions)
    replay.save(expected, "b.png", numbers=True, step=3)
    assert Path("a.PNG").read_bytes() == Path("b.png").read_bytes()


def test_every_step_or_one_is_explained():
    game = ["SB", "--rows", 7, "--cols", 7, "--steps", 20, "--seed", 3, "--explain"]
    episode = record(WorldConfig("SB", rows=7, cols=7, max_steps=20), "chaser", "fleer", seed=3)
    lines = [f"step {t}  {text}" for t in range(1, 21) for text in episode.explain(t)]
    assert replayed(*game).splitlines()[:-1] == lines
    drawn = render.ansi(replay.scene(episode, 17), color=False).splitlines()
    of_one = [line for line in lines if line.startswith("step 17 ")]
    assert replayed(*game, "--step", -4).splitlines()[:-1] == drawn + of_one
    assert replayed(*STILL, "--steps", 2, "--explain").startswith("no conflicts\n")


def test_a_tournament_with_the_run_s_settings_is_its_payoff(run):
    said = played(run, "--episodes", 3, "--seed", 5, "--threads", 1)
    made = run / "tournament-3-seed5.npz"
    with np.load(made) as again, np.load(run / "payoff.npz") as payoff:
        assert again.files == payoff.files
        assert all(np.array_equal(again[name], payoff[name]) for name in payoff.files)
    assert made.with_suffix(".png").read_bytes().startswith(PNG)
    assert str(open_run(run).payoff()) in said
    # Of several races each has its tournament.
    shutil.copytree(run, "job/a")
    create(tiny_race(seed=6), Path("job/b"))
    shown = matrixworld_command("replay", "job", "--step", 1)
    assert "job/a: the first of 2 races; --race chooses another: a, b\n" in shown.stderr
    assert shown.stdout == replayed("job/a", "--step", 1)
    said = played("job", "--episodes", 2)
    assert "\njob/a\n" in said
    assert "\njob/b\n" in said


def test_no_tournament_is_played_if_the_file_of_another_one_exists(run):
    shutil.copytree(run, "job/a")
    shutil.copytree(run, "job/b")
    file = Path("job/b/tournament-2-seed0.npz")
    file.write_bytes(b"precious")
    refused = matrixworld_command("tournament", "job", "--episodes", 2, code=2)
    assert f"Error: {file}: exists; give --force to replace it\n" in refused.stderr
    assert [*Path("job").glob("*/tournament-*")] == [file]


def test_scores_of_a_run_are_those_of_the_package(race):
    printed = matrixworld_command("score", race, "--episodes", 4).stdout
    for scores in score(open_run(race), episodes=4).values():
        assert score_table([scores]) in printed
        assert run_together(f"Left out: {scores.left_out}.") in run_together(printed)


def test_scores_beside_the_best_scripts(race):
    printed = matrixworld_command(
        "score", race, "--scripts", "--episodes", 4, "--seed", 2, "--json", "found.json"
    ).stdout
    assert "O, 2 pursuers and 3 evaders: 4 episodes against each opponent" in printed
    [plain] = json.loads(Path("found.json").read_text())["groups"].values()
    for team, best in best_scripts(open_run(race).pursuit.world, episodes=4, seed=2).items():
        told = f"{best.score:.3f} {best.name}, of {best.among} that can play"
        assert f"the best script of {PLURALS[team]}: {told}" in printed
        assert plain[PLURALS[team]]["best script"] == best._asdict()
