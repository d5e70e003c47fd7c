"""One team against any player: what a run keeps of it, and that it goes on without the file."""

import warnings

import pytest

import matrixworld as mw
from matrixworld.coevolution import RaceSettings, create, finish
from matrixworld.coevolution.evaluation.scores import best_scripts, met_in_training, opponents_in
from matrixworld.explorer.teams import plain_game, plain_team
from matrixworld.play.player import PythonFile
from tiny_race import Listening, check_resumes, played, results, tiny_single

PROGRAM = """
def evade(view, rng):
    return rng.integers(1, 5)
"""
SMALL = {"obstacles": 0.0, "rows": 4, "cols": 4, "n_pursuers": 2, "n_evaders": 1}


@pytest.fixture
def file(tmp_path):
    path = tmp_path / "anna.py"
    path.write_text(PROGRAM)
    return path


def settings(opponent, **changes):
    return tiny_single(opponent=str(opponent), **SMALL | changes)


def raced(settings, path, **given):
    create(settings, path, **given)
    return finish(path)


def test_a_run_goes_on_without_the_file_of_its_opponent(file, tmp_path):
    whole = raced(settings(file), tmp_path / "whole")
    create(settings(file), tmp_path / "parts")
    file.unlink()
    parts = finish(tmp_path / "parts")
    assert (whole.archive()["pursuer"] == parts.archive()["pursuer"]).all()
    assert (whole.payoff().scores == parts.payoff().scores).all()
    opponent = parts.teams["evader"]
    assert isinstance(opponent, mw.Player)
    assert opponent.given == PythonFile("anna.py", PROGRAM)
    with pytest.raises(ValueError, match="expected a run with genomes of evaders, got none"):
        mw.player(tmp_path / "parts", "evader")


def test_a_run_of_somebody_else_runs_no_program_before_a_match(file, tmp_path):
    marked = tmp_path / "marked"
    run = raced(settings(file), tmp_path / "run")
    text = f"open({str(marked)!r}, 'w').close()\n{PROGRAM}"
    config = run.path / "config.json"
    run.config["opponent_program"]["text"] = text
    config.write_text(__import__("json").dumps(run.config))
    opened = mw.open_run(tmp_path / "run")
    assert "anna" in str(opened.teams["evader"])
    plain_game(opened, ended=False)
    assert not marked.exists()
    opened.record()
    assert marked.exists()


@pytest.mark.parametrize("opponent", ["adversary - exits", "evolved-1", "solved", "careful-fleer"])
def test_opponents_without_a_file(opponent, tmp_path):
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        run = raced(settings(opponent, fov=11), tmp_path / "run")
    last = run.last("evader")
    assert hasattr(last, "genomes") == (opponent not in ("solved", "careful-fleer"))
    assert run.record().length


def test_in_a_large_world_a_program_is_asked_and_this_is_said_once(file, tmp_path):
    with pytest.warns(UserWarning, match="anna.py is asked in every step, which is slow") as told:
        raced(settings(file, rows=30, cols=30), tmp_path / "run")
    assert len(told) <= 2  # for its training and its evaluation


def test_a_page_shows_a_recorded_match_of_a_program(file, tmp_path):
    run = raced(settings(file), tmp_path / "run")
    game = plain_game(run)
    last = len(run.archive()["pursuer"]) - 1
    assert game["shows"][f"{last} 0"]["image"].startswith("data:image/gif;base64,")
    assert plain_team(run.teams["evader"], "it", 1, {})["script"] == "anna.py"


def test_a_function_is_not_kept(tmp_path):
    with pytest.raises(TypeError, match="expected what a run keeps, genomes or a file of Python"):
        create(settings("random"), tmp_path / "run", opponents=lambda views: [0] * len(views))
    assert not (tmp_path / "run").exists()


@pytest.mark.parametrize(
    ("opponent", "said"),
    [
        ("nobody", "schedule.opponent: expected one of random, "),
        ("adversary +", "schedule.opponent: 'adversary [+]': expected a line such as"),
        ("evolved-9", "schedule.opponent: evolved-9: expected an evolved opponent of these rules"),
    ],
)
def test_what_is_refused(opponent, said, tmp_path):
    with pytest.raises(ValueError, match=said):
        create(settings(opponent, fov=11), tmp_path / "run")
    assert not (tmp_path / "run").exists()


def test_settings_are_found_from_everywhere(file, monkeypatch):
    monkeypatch.chdir(file.parent)
    named = RaceSettings.of({"schedule": "against", "schedule.opponent": "anna.py"})
    assert named.with_absolute_paths().schedule.opponent == str(file)
    line = named.changed({"schedule.opponent": "0.3 * teammate - adversary"})
    assert line.with_absolute_paths() == line


SCRIPTS = ("random", "still")
EXACT = {"learner.measure": "guarantee", "schedule.opponent": "best-response", "train_steps": 200}


def test_a_team_learns_against_scripts_in_turn_and_is_evaluated_against_the_opponent(tmp_path):
    play = Listening()
    alone = tiny_single(opponent="fleer", training_opponents=SCRIPTS)
    run = played(alone, tmp_path / "run", play)
    assert [evaders for _, _, evaders, *_ in play.calls] == [
        "random", "still", "random", "still", "random", "fleer",
    ]  # fmt: skip
    assert RaceSettings.from_json(run.settings.to_json()) == alone
    told, left_out = opponents_in(run, "pursuer", run.settings.game.world)
    assert not {*SCRIPTS} & {*told}
    assert "fleer" in told
    assert "not random: the run trained against it" in left_out
    # A script that is best beside the run meets the same opponents.
    every = best_scripts(run.settings.game.world, episodes=2)["pursuer"]
    same = best_scripts(run.settings.game.world, met_in_training(run), episodes=2)["pursuer"]
    assert every.score != same.score


def test_a_single_script_of_training_is_the_opponent(tmp_path):
    played(tiny_single(), tmp_path / "plain")
    played(tiny_single(training_opponents=("random",)), tmp_path / "one")
    plain, one = results(tmp_path / "plain"), results(tmp_path / "one")
    assert plain.pop("config.json") != one.pop("config.json")
    assert plain == one


@pytest.mark.parametrize("call", [2, 3])
def test_scripts_of_training_go_on_in_turn_after_a_stop(call, tmp_path):
    check_resumes(tiny_single(training_opponents=SCRIPTS), call, tmp_path / "run")


@pytest.mark.parametrize(
    ("changes", "said"),
    [
        ({"training_opponents": ("nobody",)}, "a sequence of names of scripts, got "),
        ({"training_opponents": ("careful-fleer",)}, "schedule.training_opponents: expected "),
        ({"training_opponents": SCRIPTS, "evaluation_episodes": 1, **EXACT, **SMALL}, "no effect"),
    ],
)
def test_scripts_of_training_that_are_refused(changes, said):
    with pytest.raises(ValueError, match=said):
        tiny_single(**changes)
