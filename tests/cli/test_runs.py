"""The table of variants, and the commands that work on runs: tournament, replay, figures."""

import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import matrixworld
from command_line import FIGURES, GIF, MAIN_JOB, PNG, judged_in, matrixworld_command
from matrixworld import VARIANTS, Episode, WorldConfig, record
from matrixworld.cli.figures import collisions_per_1000, planned, run_title
from matrixworld.cli.groups import groups_of
from matrixworld.coevolution import open_run, start
from matrixworld.coevolution.seeding import evaluation_seed
from matrixworld.episodes import render, replay
from matrixworld.play.rollout import Matches, rollout
from rows import random_walks
from tiny_race import StopAt, tiny_race


def test_a_tournament_with_the_run_s_settings_is_its_payoff(run):
    same = ["--episodes", 3, "--steps", 12, "--seed", 5]
    result = matrixworld_command("tournament", run, *same, "--threads", 1)
    made = run / "tournament-3x12-seed5.npz"
    with np.load(made) as again, np.load(run / "payoff.npz") as payoff:
        assert again.files == payoff.files
        assert all(np.array_equal(again[name], payoff[name]) for name in payoff.files)
        matrix = payoff["capture_rate"]
    assert made.with_suffix(".png").read_bytes().startswith(PNG)
    assert f"mean capture rate                           {matrix.mean():.3f}" in result.stdout
    assert f"all evaders, capture  {matrix[-1].mean():.3f}" in result.stdout
    assert f"all pursuers, escape   {1 - matrix[:, -1].mean():.3f}" in result.stdout
    assert set(judged_in(result.stdout).values()) == {"cannot tell"}


def test_cross_play_of_two_runs(race):
    start(tiny_race(schedule=MAIN_JOB[0]), "other", threads=1).run()
    result = matrixworld_command(
        "tournament", race, "other", "--episodes", 2, "--steps", 9, "--seed", 3,
        "--out", "cross.npz",
    )  # fmt: skip
    assert not judged_in(result.stdout)  # nobody trained against the other there
    played = np.load("cross.npz")["capture_rates"]
    ours = open_run(race)
    scores = rollout(
        replace(ours.settings.world, max_steps=9),
        ours.teams["pursuer"],
        open_run("other").teams["evader"],
        Matches.of(2, 1, np.uint64(evaluation_seed(3, 2, 1))),
        episodes=2,
    )
    assert np.array_equal(played[2, 1], scores.capture_rate[0])


def test_cross_play_needs_one_world(race):
    start(tiny_race(rows=7), "other")
    result = matrixworld_command("tournament", race, "other", code=2)
    assert "expected two runs in the same world, got rows 6 and 7" in result.stderr


def test_a_tournament_of_an_unfinished_run():
    race = start(tiny_race(), "begun", threads=1, play=StopAt(3))
    with pytest.raises(KeyboardInterrupt):
        race.run()
    matrixworld_command("tournament", "begun", "--out", "begun.npz")
    assert np.load("begun.npz")["capture_rates"].shape == (2, 1, 100)


def test_replay_plays_the_episode_of_the_payoff(race):
    result = matrixworld_command(
        "replay", race, "--pursuer", 2, "--evader", -3, "--episode", 1,
        "--out", "match.gif", "--out", "match.npz",
    )  # fmt: skip
    payoff, episode = open_run(race).payoff(), Episode.load("match.npz")
    assert episode.length == payoff.lengths[2, 0, 1]
    assert episode.capture_rate == pytest.approx(payoff.capture_rates[2, 0, 1])
    assert Path("match.gif").read_bytes().startswith(GIF)
    caught = int(episode.counted[-1].sum())
    told = f"{caught} of 3 evaders captured, {episode.length} steps"
    assert result.stdout == f"{told}  match.gif, match.npz\n"
    last = ["--pursuer", 2, "--evader", 2, "--episode", 0]
    usual = matrixworld_command("replay", race).stdout
    assert usual == matrixworld_command("replay", race, *last).stdout
    again = matrixworld_command("replay", "match.npz").stdout
    assert again.startswith(f"step {episode.length} of {episode.length}")
    assert again.endswith(f"\n{told}\n")


def test_replay_of_a_variant_is_a_game_of_scripts():
    world = ["--rows", 12, "--cols", 9, "--obstacles", 0.1, "--steps", 40]
    game = ["replay", "pursuit-evasion-sb", "--seed", 7, "--episode", 2, *world]
    result = matrixworld_command(*game, "--evader", "random", "--out", "a.npz", "--out", "a.PNG")
    episode = Episode.load("a.npz")
    config = WorldConfig("SB", rows=12, cols=9, obstacles=0.1, max_steps=40)
    expected = record(config, "chaser", "random", seed=7, episode=2)
    assert np.array_equal(episode.positions, expected.positions)
    replay.save(expected, "b.png")
    assert Path("a.PNG").read_bytes() == Path("b.png").read_bytes()
    matrixworld_command(
        "replay", "a.npz", "--out", "c.png", "--view", "evader_2", "--view", "pursuer_0"
    )
    replay.save(expected, "d.png", viewers=["evader_2", "pursuer_0"])
    assert Path("c.png").read_bytes() == Path("d.png").read_bytes() != Path("b.png").read_bytes()
    assert result.stdout.endswith(f"{episode.length} steps  a.npz, a.PNG\n")


def test_replay_explains_every_step_or_one():
    game = ["replay", "SB", "--rows", 7, "--cols", 7, "--steps", 20, "--seed", 3]
    episode = record(WorldConfig("SB", rows=7, cols=7, max_steps=20), "chaser", "fleer", seed=3)
    lines = [f"step {t}  {text}" for t in range(1, 21) for text in episode.explain(t)]
    every = matrixworld_command(*game, "--explain").stdout.splitlines()
    assert every[:-1] == lines
    drawn = render.ansi(replay.scene(episode, 17), color="none").splitlines()
    for step in (17, -4):  # of 20 steps the same one
        shown = matrixworld_command(*game, "--step", step, "--explain").stdout.splitlines()
        assert shown[:-1] == drawn + [line for line in lines if line.startswith("step 17 ")]
    result = matrixworld_command(*game, "--step", 0, "--explain", "--out", "x.png", "--numbers")
    assert result.stdout.startswith("step 0  no conflicts\n")
    replay.save(episode, "y.png", step=0, numbers=True)
    assert Path("x.png").read_bytes() == Path("y.png").read_bytes()
    still = ["replay", "O", "--pursuer", "still", "--evader", "still", "--steps", 2]
    assert matrixworld_command(*still, "--explain").stdout.startswith("no conflicts\n")


def test_replay_cannot_explain_a_recording_without_conflicts():
    random_walks().save("walks.npz")
    result = matrixworld_command("replay", "walks.npz", "--explain", code=2)
    assert "conflict_table: expected a recording with conflicts, got none" in result.stderr


@pytest.mark.parametrize(
    ("options", "code", "message"),
    [
        (["nothing"], 2, f"or a variant ({', '.join(VARIANTS)}), got 'nothing'"),
        (["several"], 2, "expected one of its 2 races, got none; --race NAME with 1, 2"),
        (["{race}", "--pursuer", "3"], 2, "a generation from 0 to 2, got 3"),
        (["{race}/log.csv"], 1, "cut, altered or not an npz file"),
        (["{race}/log.csv", "--episode", "1"], 2, "expected no --episode"),
        (["{race}", "--evader", "fleer"], 2, "a generation of the run, got"),
        (["{race}", "--seed", "1"], 2, "is a run: expected no --seed with it"),
        (["O", "--pursuer", "3"], 2, "--pursuer: expected one of random, still, chaser, fleer, "),
        (["O", "--rows", "1", "--cols", "3"], 2, "n_pursuers: expected 1 to 3, got 8"),
        (["O", "--obstacles", "many"], 2, "expected a density in [0, 1) or a .map file"),
        (["O", "--steps", "1", "--view", "pursuer_8", "--out", "x.png"], 1, "got 'pursuer_8'"),
        (["O", "--view", "pursuer_0"], 2, "--view: expected a picture to --out together with it"),
        (["O", "--numbers", "--out", "x.npz"], 2, "--numbers: expected a picture to --out"),
        (["O", "--step", "3", "--out", "x.gif"], 2, "--step: expected a .png to --out"),
        (["O", "--steps", "5", "--step", "6"], 2, "--step: expected -6 to 5, got 6"),
        (["O", "--out", "x.avi"], 2, "ends in .gif, .mp4, .png, .npz: x.avi"),
    ],
)
def test_replay_refuses(race, options, code, message):
    for name in "12":
        start(tiny_race(), f"several/{name}")
    args = [option.format(race=race) for option in options]
    assert message in matrixworld_command("replay", *args, code=code).stderr


def test_commands_take_the_directory_of_several_races(race):
    """Those that need one race choose it by its name; the others take each in turn."""
    for seed in (1, 2):
        start(tiny_race(seed=seed), f"job/hall/seed-{seed}", threads=1).run()
    one = ["--race", "hall/seed-2"]
    exported = ["class", "export", "job", *one, "--team", "pursuer", "--out", "champion.npz"]
    matrixworld_command(*exported)
    matrixworld_command("replay", "job", *one, "--out", "one.npz")
    matrixworld_command("replay", "job/hall/seed-2", "--out", "two.npz")
    assert Path("one.npz").read_bytes() == Path("two.npz").read_bytes()
    champion = ["--pursuer", "champion.npz"]
    # The last generation again, which meets the evader as generation 0 does.
    matrixworld_command("replay", "job", *one, *champion, "--out", "again.npz")
    seen = open_run("job/hall/seed-2")
    alone = replace(seen, teams={**seen.teams, "pursuer": seen.policy("pursuer").population()})
    assert Episode.load(Path("again.npz")).length == alone.record(pursuer=0).length
    refused = matrixworld_command("replay", "job", "--evader", "champion.npz", *one, code=2)
    assert "--evader: expected a file of evaders, got one of pursuers" in refused.stderr
    said = matrixworld_command("tournament", "job", "--episodes", 2).stdout
    assert [f"\njob/hall/seed-{seed}\n" in said for seed in (1, 2)] == [True, True]
    refused = matrixworld_command("tournament", "job", "--out", "x.npz", code=2)
    assert "--out: expected one race in RUN, got 2; --race NAME chooses one" in refused.stderr


def test_a_film_of_a_long_episode_takes_about_ten_seconds(monkeypatch):
    seen = {}
    monkeypatch.setattr(replay, "save", lambda *args, **look: seen.update(look))
    still = ["replay", "O", "--pursuer", "still", "--evader", "still", "--steps", 400]
    said = matrixworld_command(*still, "--out", "x.gif").stdout
    assert said.startswith("Every 4 steps are a frame, so that it takes about 10 seconds.\n")
    assert seen["every"] == 4
    assert "Every" not in matrixworld_command(*still, "--out", "x.gif", "--every", 1).stdout
    assert seen["every"] == 1


def test_all_figures_are_drawn_and_races_side_by_side(run):
    start(tiny_race(schedule=MAIN_JOB[0]), "other", threads=1).run()
    said = matrixworld_command("explore", "--figures", "run", "other").stdout.split()
    figures = [path for name in ("run", "other") for path in Path(name).glob("*.png")]
    assert sorted(Path(file).absolute() for file in said) == sorted(
        path.absolute() for path in [*figures, Path("comparison.png")]
    )
    assert sorted(path.name for path in figures) == sorted([*FIGURES] * 2)
    assert all(path.read_bytes().startswith(PNG) for path in figures)


def test_collisions_are_counted_per_1000_steps_of_an_agent(race):
    payoff = open_run(race).payoff()
    rates = collisions_per_1000(payoff)
    assert rates.shape == (3, 2, 3)
    row = sum(payoff.collisions[1, h, 0, 0] for h in range(3))
    assert rates[1, 0, 0] == pytest.approx(1000 * row / payoff.agent_steps[1, :, 0].sum())
    column = sum(payoff.collisions[g, 2, 1, 1] for g in range(3))
    assert rates[2, 1, 1] == pytest.approx(1000 * column / payoff.agent_steps[:, 2, 1].sum())
    # 2 pursuers, which never disappear in -O, and at most 3 evaders.
    assert payoff.agent_steps[..., 0] == pytest.approx(2 * payoff.length)
    assert (payoff.agent_steps[..., 1] <= 3 * payoff.length).all()


def test_the_package_is_a_command_too():
    command = [sys.executable, "-m", "matrixworld", "--version"]
    done = subprocess.run(command, capture_output=True, text=True, check=True)
    assert done.stdout == f"matrixworld, version {matrixworld.__version__}\n"


def test_titles_name_the_run_and_its_seed(run):
    groups = groups_of([run])
    [race] = groups[0].runs
    assert run_title(Path("generalist-generalist/seed-5"), race.settings) == (
        "generalist-generalist, seed 5"
    )
    for draw in planned(groups, run).values():
        figure = draw()
        title = figure.get_suptitle() or figure.axes[0].get_title()
        assert title.startswith("run (generalist-generalist), seed 5\n")
