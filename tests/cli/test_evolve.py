"""``matrixworld evolve``: options, jobs, seeds, interruptions, failures, and progress."""

import json
import os
import re
import shlex
import signal
import subprocess
import sys
from pathlib import Path

import click
import numpy as np
import pytest

import balanced_races
import matrixworld as mw
from command_line import FIGURES, MAIN_JOB, PLACES, PNG, RACE, WORLD, evolved, words
from matrixworld.cli import options as cli_options
from matrixworld.cli.evolve import evolve_command, job_of
from matrixworld.cli.setting_options import settings_of
from matrixworld.coevolution import SCHEDULES, TEAMS, RaceSettings, Run, create, evolve, open_run
from matrixworld.coevolution.jobs import play as jobs_module
from matrixworld.coevolution.jobs.job import found_job
from matrixworld.coevolution.runs.places import find_runs
from matrixworld.coevolution.settings.race_settings import default_race
from matrixworld.coevolution.types import other
from scripts import group_lives, wait_until
from slow import quickly
from tiny_race import StopAt, playing, results, tiny_race, tiny_single


def results_of(directory):
    """Return the files of a run: config.json without what was chosen, and what thus follows."""
    config = json.loads((directory / "config.json").read_text())
    del config["settings"]["chosen"]
    return {**results(directory), "config.json": config}


def test_values_that_were_edited_in_the_file_of_a_run_are_taken(tmp_path):
    run = create(RaceSettings.of(schedule="hall-of-fame", seed=5, defaults="courtyard"), "run")
    config = json.loads((run.path / "config.json").read_text())
    config["settings"]["seed"] = 77
    config["settings"]["learner"]["sigma"] = 0.5
    assert "learner.sigma" not in config["settings"]["chosen"]
    (tmp_path / "edited.json").write_text(json.dumps(config))
    with evolve_command.make_context("evolve", ["--config", str(tmp_path / "edited.json")]) as ctx:
        [settings] = job_of(cli_options.given(ctx.params)).values()
    assert settings == run.settings.changed({"seed": 77, "learner.sigma": 0.5})


def test_the_help_of_all_settings_has_every_one_with_its_default():
    shown = " ".join(evolved("--help-all").output.split())
    # Lines may end at a hyphen.
    shown = shown.replace("- ", "-")
    for kind in ("es", "ga", "cma", "actor-critic", "own"):
        assert f" learner={kind}: " in shown
    for schedule in ("alternating", "hall-of-fame", "against"):
        settings = RaceSettings.of(schedule=schedule)
        for path in settings.values():
            if path not in ("learner", "schedule") and not path.endswith("s_meet"):
                assert f"{path.replace('evaders_meet', 'pursuers_meet')} " in shown
    for default in (
        "learner.population INTEGER candidates per epoch [default: 48; ",
        "other defaults, schedule=hall-of-fame: learner.population 24",
        "learner=actor-critic: train_steps 500 policy.hidden 400,300 schedule.pursuer_epochs 400",
    ):
        assert default in shown


def test_options_become_settings():
    more = {"anneal": "true", "diagonal": "true", "activation": "tanh", "sigma": ".2"}
    more |= {"hidden": "5,4", "obstacles": "0.1", "schedule": "generalist-specialist"}
    typed = [*words({**RACE, **more}), "--variant", "sb"]
    with evolve_command.make_context("evolve", typed) as context:
        assert settings_of(cli_options.given(context.params)) == [
            tiny_race(
                schedule="generalist-specialist", anneal=True, diagonal=True, activation="tanh",
                rules="SB", sigma=0.2, hidden=(5, 4), obstacles=0.1,
            )
        ]  # fmt: skip


def test_the_default_job_is_the_one_that_was_judged():
    """Of kept results; ``--paper`` and files start from the settings without any."""
    kept = balanced_races.kinds(quick=False)
    for options, world in (({}, "courtyard"), ({"world": "park"}, "park")):
        assert settings_of(options) == [kept[f"{world}; {name}"] for name in MAIN_JOB]
    of_paper = [RaceSettings.of(schedule=name) for name in MAIN_JOB]
    assert settings_of({"paper": True}) == of_paper
    assert settings_of({"config": {}}) == settings_of({"paper": True})
    changed = RaceSettings.of(default_race("hall-of-fame"), {"learner": "ga", "world.rows": 9})
    assert settings_of({"schedule": ("hall-of-fame",), "learner": "ga", "rows": 9}) == [changed]
    # With a genome to start from, an initial weight that nobody has given is not refused.
    started = {"schedule.team": "evader", "schedule.start": "run"}
    assert RaceSettings.of(default_race("against"), started).schedule.start == "run"


def test_a_setting_of_one_schedule_of_a_job_is_left_out_of_the_others():
    """Epochs of turns are for two races, joint epochs and living opponents for the third."""
    every = [("learner.sigma", 0.2)]
    in_turns = [("schedule.evader_epochs", 5)]
    joint = [("schedule.joint_epochs", 7), ("schedule.contemporaries", 3)]
    assert settings_of({"paper": True, "sets": [*every, *in_turns, *joint]}) == [
        RaceSettings.of(
            {"schedule": name, **dict(every), **dict(joint if "hall" in name else in_turns)}
        )
        for name in MAIN_JOB
    ]
    with pytest.raises(click.UsageError, match="schedule.epochs: .* a setting of schedule=against"):
        settings_of({"sets": [("schedule.epochs", 2)]})


def test_settings_from_a_file(undrawn, tmp_path):
    plain = {
        "seed": 3, "learner": {"kind": "ga", "mutation": 0.2},
        "schedule": {"kind": "hall-of-fame", "generations": 2}, "world": {"rules": "SB", "rows": 7},
    }  # fmt: skip
    assert settings_of({"config": plain}) == [
        RaceSettings.of(
            {
                "learner": "ga", "learner.mutation": 0.2, "schedule": "hall-of-fame", "seed": 3,
                "schedule.generations": 2, "world.rules": "SB", "world.rows": 7,
            }
        )
    ]  # fmt: skip
    # Options come after the file; a schedule of another kind keeps what it has, too.
    options = {"schedule": ("alternating",), "rows": 9, "sets": [("learner.elites", 3)]}
    (race,) = settings_of({**options, "config": plain})
    kept = {"schedule": "alternating", "learner": "ga", "schedule.generations": 2}
    assert race.schedule == RaceSettings.of(kept).schedule
    assert (race.game.world.rows, race.learner.mutation, race.learner.elites) == (9, 0.2, 3)
    plain["schedule"]["joint_epochs"] = 7
    with pytest.raises(click.UsageError, match="joint_epochs: .* setting of schedule=hall-of-fame"):
        settings_of({**options, "config": plain})

    create(tiny_race(learner="ga", mutation=1 / 3), tmp_path / "run")
    evolved("--out", "again", "--config", "run/config.json", "--seed", 6)
    again = open_run("again/generalist-generalist/seed-6").settings
    assert again == tiny_race(learner="ga", mutation=1 / 3, seed=6)


def test_worlds_with_names_are_told():
    told = [line.split() for line in evolved("--worlds").output.splitlines()]
    assert ["park", "TO", "28", "x", "28", "4", "4", "10%", "200"] in told
    assert {*mw.WORLDS} <= {line[0] for line in told if line}
    assert "'lake' is not one of" in evolved("--world", "lake", code=2).output


@pytest.mark.parametrize(
    ("options", "name"),
    [
        ({"seeds": (0, 1), "schedule": ("against",)}, "courtyard-pursuer-against-random-seeds0-1"),
        ({"variant": "SB", "seeds": (4,)}, "SB-seed4"),
        ({"seeds": (0, 3, 9)}, "courtyard-seeds0,3,9"),
        ({"schedule": ("alternating",), "seed": 3, "paper": True}, "O-seed3"),
        ({"world": "park"}, "park-seed0"),
        ({"world": "park", "n_evaders": 5}, "TO-seed0"),
    ],
)
def test_the_default_directory_is_named_after_world_and_seeds(options, name):
    assert jobs_module.default_directory(job_of(options)) == Path("runs") / name


def test_the_main_job_writes_figures_and_numbers(main_job):
    output, _ = main_job
    names = {path.name for path in output.iterdir()}
    written = {"comparison.png", "summary.json", "explorer.html"}
    assert names == {*MAIN_JOB, *written}
    for place in PLACES:
        assert {path.name for path in (output / place).glob("*.png")} == FIGURES
    for path in output.rglob("*.png"):
        assert path.read_bytes().startswith(PNG)
    runs = json.loads((output / "summary.json").read_text())["runs"]
    assert list(runs) == PLACES


def test_without_output_the_directory_is_told_and_not_used_twice(undrawn):
    one = [*words(RACE), "--schedule", "specialist-specialist"]
    first = evolved(*one).stderr
    assert first.splitlines()[:2] == [
        "runs/O-seed5/explorer.html shows the runs while they go on.",
        "O, 2 pursuers and 3 evaders, 1 race, in runs/O-seed5",
    ]
    assert "1 race, in runs/O-seed5-2" in evolved(*one).stderr  # never the same one again
    third = evolved(*one, "--out", "runs/O-seed5", code=2).stderr
    assert "--out: expected a new or empty directory, got 'runs/O-seed5'; " in third
    assert "matrixworld evolve --resume runs/O-seed5 continues the run" in third


def test_the_runs_of_a_job_are_in_the_order_of_their_schedules():
    job = job_of({"schedule": ("hall-of-fame", *SCHEDULES), "seeds": (10, 2)})
    schedules = [MAIN_JOB[0], "generalist-specialist", *MAIN_JOB[1:]]
    assert [*job] == [f"{name}/seed-{seed}" for name in schedules for seed in (10, 2)]


def test_one_team_alone_against_a_script_and_then_against_the_result():
    # So small that some evaders are still captured.
    steps = {"sigma": 0.1, "learning_rate": 0.02}
    alone = {**WORLD, "schedule": "against", "epochs": 5, "archive_every": 2, **steps}
    result = evolved("--out", "first", *words({**alone, "team": "evader"}))
    evolve(tiny_single(team="evader", **steps), "again")
    first = Path("first/evader-against-random/seed-5")
    assert results_of(first) == results_of(Path("again"))
    numbers = open_run(first).summary()
    rate, low, high = (numbers[f"capture_rate{end}"] for end in ("", "_low", "_high"))
    assert f"  capture rate {rate:.3f} ({low:.3f} to {high:.3f})\n" in result.stdout
    assert f"an episode takes {numbers['length']:.0f} steps\n" in result.stdout
    assert (first / "training.png").read_bytes().startswith(PNG)
    # The directory of a job of one run stands for the run.
    evolved("--out", "next", *words({**alone, "opponent": "first"}))
    archive = open_run("next/pursuer-against-evader-against-random/seed-5").archive()
    last = open_run(first).archive()["evader"][-1]
    assert np.array_equal(archive["evader"], last[None])


def asked(*typed):
    """Return the settings of the one run that options ask for."""
    with evolve_command.make_context("evolve", [str(word) for word in typed]) as context:
        [settings] = job_of(cli_options.given(context.params)).values()
    return settings


SMALL = (
    "--set", "schedule.epochs=2", "--set", "learner.population=4", "--set", "train_steps=5",
    "--set", "evaluation_episodes=2",
)  # fmt: skip
ALONE = {
    "the courtyard": (),
    "the paper's world": ("--paper",),
    "another world": ("--world", "park", "--n-pursuers", 3),
    "a map": ("--paper", "--set", "world.obstacles=map.map", "--set", "world.fov=5"),
    "another learner": ("--learner", "ga", "--set", "learner.mutation=0.1"),
    "other steps": ("--set", "learner.sigma=0.2", "--seed", 7),
    "other epochs": ("--set", "schedule.epochs=50", "--set", "schedule.archive_every=5"),
    "gradients": ("--paper", "--learner", "actor-critic"),
}


def against(team, *options):
    return ["--schedule", "against", "--set", f"schedule.team={team}", *options]


@pytest.mark.parametrize("team", TEAMS)
@pytest.mark.parametrize("start", [(), ("--paper",)], ids=["courtyard", "paper"])
def test_the_opponent_of_a_run_learns_by_the_command_that_it_prints(team, start, undrawn):
    told = evolved("--out", "first", *against(team, *start, *SMALL)).stdout
    [typed] = re.findall(r"Its opponent learns:\n  matrixworld evolve (.+)", told)
    opponent = other(team)
    first = Path(f"first/{team}-against-random/seed-0")
    assert typed.split() == [
        "--config", str(first / "config.json"), "--set", f"schedule.team={opponent}",
        "--set", "schedule.opponent=first",
    ]  # fmt: skip
    found = asked(*shlex.split(typed))
    afresh = against(opponent, "--set", "schedule.opponent=first", *start, *SMALL)
    assert found == asked(*afresh)
    # The other team learns from what it meets, as the first one from the script.
    evolved("--out", "second", *shlex.split(typed))
    second = open_run(f"second/{opponent}-against-{team}-against-random/seed-0")
    assert second.settings == found
    met = second.archive()[team]
    np.testing.assert_array_equal(met, open_run(first).archive()[team][-1:])


@pytest.mark.parametrize("team", TEAMS)
@pytest.mark.parametrize("start", ALONE.values(), ids=ALONE)
def test_its_settings_are_those_of_asking_afresh(team, start):
    """Of what nobody chose, such as epochs and steps, each team has what follows for it."""
    Path("map.map").write_text("type octile\nheight 12\nwidth 12\nmap\n" + ("." * 12 + "\n") * 12)
    if "actor-critic" in start:
        pytest.importorskip("torch")
    opponent = other(team)
    first = asked(*against(team, *start))
    path = create(first, "first").path  # nothing is played
    change = ("--set", f"schedule.team={opponent}", "--set", f"schedule.opponent={path}")
    found = asked("--config", path / "config.json", *change)
    afresh = asked(*against(opponent, *start, *change[2:]))
    assert found == afresh
    assert found.choices() == afresh.choices()
    assert found.values().keys() == first.values().keys()
    if "schedule.epochs" not in first.chosen and "actor-critic" not in start:
        by_cma = dict.fromkeys(TEAMS, 150)
        epochs = by_cma if first.learner.kind == "cma" else {"pursuer": 6000, "evader": 4000}
        assert (first.schedule.epochs, found.schedule.epochs) == (epochs[team], epochs[opponent])
        assert found.game.train_steps != first.game.train_steps
    # And back again, by its own file.
    again = create(found, "second").path
    change = ("--set", f"schedule.team={team}", "--set", "schedule.opponent=random")
    assert asked("--config", again / "config.json", *change) == first


def test_its_opponent_meets_the_team_and_not_those_that_the_team_met(undrawn):
    met = ("--set", 'schedule.training_opponents=["chaser", "hunter"]')
    told = evolved("--out", "first", *against("evader", *met, *SMALL)).stdout
    assert "against chaser and hunter" in told
    [typed] = re.findall(r"Its opponent learns:\n  matrixworld evolve (.+)", told)
    assert asked(*shlex.split(typed)).schedule.training_opponents == ()


def test_its_opponent_starts_untrained_unless_it_is_asked(undrawn):
    """A genome to start from is one of the team that learned."""
    create(asked(*against("pursuer")), "begin")
    start = ("--set", "schedule.start=begin")
    told = evolved("--out", "first", *against("pursuer", *start, *SMALL)).stdout
    [typed] = re.findall(r"Its opponent learns:\n  matrixworld evolve (.+)", told)
    found = asked(*shlex.split(typed))
    assert found == asked(*against("evader", "--set", "schedule.opponent=first", *SMALL))
    assert found.schedule.start is None


def test_ctrl_c_ends_cleanly_and_resume_ends_the_same(main_job, undrawn, monkeypatch):
    play = StopAt(7)  # in the middle of an epoch
    one = [*words(RACE), "--schedule", MAIN_JOB[2]]
    with monkeypatch.context() as patch:

        def stopped(path, *, threads, **told):
            playing(Run(path, threads=threads), play).run(**told)

        patch.setattr(jobs_module, "go_on", stopped)
        result = evolved("--out", "out", *one, code=130)
    assert "matrixworld evolve --resume out\n" in result.stderr
    resumed = evolved("--resume", "out")
    assert "1 race done" in resumed.stdout
    assert results(Path("out") / PLACES[2]) == results(main_job[0] / PLACES[2])


ONE = {name: value for name, value in RACE.items() if name != "seed"}


def test_a_directory_for_each_schedule_and_seed(undrawn):
    chosen = ["--schedule", MAIN_JOB[0], "--schedule", MAIN_JOB[2]]
    said = evolved("--out", "out", "--seeds", "2,10", *chosen, *words(ONE))
    names = [f"{name}/seed-{n}" for name in (MAIN_JOB[0], MAIN_JOB[2]) for n in (2, 10)]
    assert find_runs(Path("out")) == [Path("out") / name for name in names]
    assert find_runs(Path("out") / MAIN_JOB[2]) == [Path("out") / name for name in names[2:]]
    assert [*found_job(Path("out"))] == names
    evolve(tiny_race(seed=10, schedule=MAIN_JOB[2]), "alone")
    assert results_of(Path("out") / names[3]) == results_of(Path("alone"))
    assert "[4/4] pursuers" in said.stderr
    before = {path: path.read_bytes() for path in Path("out").rglob("*.*") if path.is_file()}
    again = evolved("--resume", "out")
    # The first line has the time.
    assert again.stdout.splitlines()[1:] == said.stdout.splitlines()[1:]
    assert {path: path.read_bytes() for path in before} == before
    part = evolved("--resume", f"out/{MAIN_JOB[0]}")
    assert part.stdout.startswith("2 races done")
    assert f"seed-2 {MAIN_JOB[2]}" not in part.stdout


def test_a_failed_run_is_named_and_the_others_are_reported(monkeypatch):
    reported = []

    def keep(job, root, finished, *rest):
        reported.append(finished)

    monkeypatch.setattr("matrixworld.cli.evolve.report", keep)
    evolved("--out", "out", "--seeds", "0-2", "--schedule", MAIN_JOB[2], *words(ONE))
    runs = find_runs(Path("out"))
    for name in ("payoff.npz", "summary.json"):
        (runs[1] / name).unlink()
    (runs[1] / "stage-0001.npz").write_bytes(b"PK")
    said = evolved("--resume", "out", code=1)
    assert f"Error: 1 of 3 runs failed:\n  {runs[1]}: " in said.stderr
    assert "To try them again:\n  matrixworld evolve --resume out\n" in said.stderr
    assert reported[-1] == [runs[0], runs[2]]


def process_of(*args):
    """Start a command in a process of its own, with a group that a terminal would stop."""
    return subprocess.Popen(
        [sys.executable, "-m", "matrixworld", "evolve", *map(str, args)],
        stderr=subprocess.PIPE,
        text=True,
        env={**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)},
        # In a background job SIGINT may be ignored, and child processes inherit that.
        preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL),
        start_new_session=True,
    )


@pytest.mark.slow
@pytest.mark.skipif(sys.platform == "win32", reason="needs signals")
@quickly("send", [os.killpg, os.kill], os.killpg.__eq__, lambda send: send.__name__)
def test_stopped_and_killed_and_resumed_ends_the_same(send, monkeypatch):
    """Ctrl-C, to all processes or the parent, leaves no process; a kill loses nothing."""
    monkeypatch.setattr("matrixworld.cli.evolve.report", lambda *args, **timed: None)
    longer = {**ONE, "generations": 4, "pursuer_epochs": 30, "evader_epochs": 30}
    chosen = ["--seeds", "0-2", "--schedule", MAIN_JOB[0], *words(longer)]
    process = process_of("--out", "out", *chosen)
    wait_until(lambda: [*Path("out").glob("*/*/stage-0001.npz")], "a stage")
    send(process.pid, signal.SIGINT)  # a terminal sends it to all
    _, errors = process.communicate(timeout=60)
    assert process.returncode == 130
    assert "matrixworld evolve --resume out\n" in errors
    assert "Traceback" not in errors
    wait_until(lambda: not group_lives(process.pid), "end of all processes", 10.0)
    assert {path.name for path in Path("out").iterdir()} <= {MAIN_JOB[0], "explorer.html"}

    process = process_of("--resume", "out")
    later = Path("out").glob  # a fast machine may end before the kill, which is no failure
    wait_until(lambda: [*later("*/*/stage-0004.npz")] or process.poll() is not None, "a stage")
    process.kill()
    process.communicate()
    wait_until(lambda: not group_lives(process.pid), "end of all processes", 10.0)
    evolved("--resume", "out")
    settings = tiny_race(**{**longer, "hidden": (4,)}, schedule=MAIN_JOB[0], seed=1)
    evolve(settings, "straight")
    assert results_of(Path(f"out/{MAIN_JOB[0]}/seed-1")) == results_of(Path("straight"))
