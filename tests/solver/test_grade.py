"""Grades in the suite, against what is computed by hand and by a slow walk through the game."""

import json

import numpy as np
import pytest

import matrixworld as mw
from matrixworld.solver import best_response, guarantee, solve
from matrixworld.solver.losses import losses
from rows import random_team

SMALL = mw.SUITE.worlds[1].config  # in turns, 1 v 1
AT_ONCE = mw.SUITE.worlds[12].config


def north(view):
    return 1


def test_a_grade_is_the_mean_share_of_perfect_play():
    found = mw.grade("chaser", "pursuer", worlds=[SMALL, AT_ONCE]).teams["pursuer"]
    shares = []
    for config, of_world in zip((SMALL, AT_ONCE), found.worlds, strict=True):
        perfect, reached = solve(config).value, best_response(config, "chaser", "pursuer").value
        assert of_world.guarantees == pytest.approx(reached, abs=1e-12)
        assert of_world.bounds == (of_world.guarantees, of_world.guarantees)
        shares.append(reached / perfect)
    assert found.share == pytest.approx(np.mean(shares), abs=1e-12)
    assert (found.in_turns, found.at_once) == pytest.approx(tuple(shares), abs=1e-12)
    assert not found.estimate
    assert found.unread >= found.share


def test_evaders_are_graded_by_their_escapes():
    [of_world] = mw.grade(north, "evader", worlds=SMALL).teams["evader"].worlds
    reached = best_response(SMALL, north, "evader").value
    assert of_world.perfect == pytest.approx(1 - solve(SMALL).value, abs=1e-12)
    assert of_world.guarantees == pytest.approx(1 - reached, abs=1e-12)


def test_perfect_play_has_the_grade_1_and_loses_nothing():
    for config in (SMALL, AT_ONCE):
        for team in ("pursuer", "evader"):
            found = mw.grade("solved", team, worlds=config).teams[team]
            assert found.share == pytest.approx(1, abs=1e-9)
            assert found.unread == pytest.approx(1, abs=1e-9)
            assert not found.losses


def test_the_interval_is_that_of_student_over_worlds():
    found = mw.grade("fleer", "evader").teams["evader"]
    shares = np.array([each.share for each in found.worlds])
    half = 2.0639 * shares.std(ddof=1) / 5  # t of 24 degrees of freedom
    ends = shares.mean() - half, shares.mean() + half
    assert found.interval == pytest.approx(ends, abs=1e-4)


@pytest.mark.parametrize("player", ["chaser", "-adversary", north])
def test_a_position_is_lost_as_a_walk_through_the_game_says(player):
    """The first position: its loss, and that its better move loses nothing, from the values."""
    world = mw.SUITE.worlds[1]
    perfect = world.perfect
    found = guarantee(perfect, player, "pursuer")
    share, first = next(losses(found, world, "pursuer"))
    row, col = np.argwhere(np.array([line.split() for line in first.board.splitlines()]) == "P")[0]
    pursuer = row * world.config.cols + col
    row, col = np.argwhere(np.array([line.split() for line in first.board.splitlines()]) == "E")[0]
    evader = row * world.config.cols + col
    [state] = np.flatnonzero((perfect.states.cells(0) == [pursuer, evader]).all(axis=1))
    moves = ("stay", "north", "east", "south", "west")
    values = perfect.after(first.steps_left, 0)[perfect.states.successors(0)[state, :, 0]]
    before = perfect.before(first.steps_left, 0)[state]
    assert values[moves.index(first.better.split()[-1])] == pytest.approx(before, abs=1e-12)
    assert values.max() == pytest.approx(before, abs=1e-12)
    if " or " not in first.plays:
        assert before - values[moves.index(first.plays.split()[-1])] == pytest.approx(first.loss)
    assert share == pytest.approx(first.loss * first.how_often / world.value)


def test_mirror_images_are_one_position():
    """Without walls a position comes about in up to eight images, equally often."""
    config = mw.WorldConfig("TO", rows=3, cols=3, n_pursuers=1, n_evaders=1, max_steps=3, fov=11)
    found = mw.grade("still", "pursuer", worlds=config).teams["pursuer"].losses
    boards = {(min(_images(loss.board)), loss.steps_left) for loss in found}
    assert len(boards) == len(found) == 3


def _images(board):
    rows = np.array([line.split() for line in board.splitlines()])
    turned = [np.rot90(each, n) for each in (rows, rows.T) for n in range(4)]
    return {"\n".join(" ".join(row) for row in each) for each in turned}


def test_what_a_player_does_is_told():
    found = mw.grade("chaser", "pursuer", worlds=SMALL).teams["pursuer"]
    assert "0% away from it" in found.behaviour
    runs = mw.grade(north, "evader", worlds=SMALL).teams["evader"]
    assert "stays in 0%" in runs.behaviour


def draws_normal_numbers(view, rng):
    return int(rng.normal() > 0)


def test_an_estimate_is_said_to_be_one():
    grade = mw.grade(draws_normal_numbers, "evader", worlds=[SMALL, AT_ONCE], draws=4)
    found = grade.teams["evader"]
    assert "rng.normal" in found.estimate
    assert found.bounds[0] < found.share < found.bounds[1]
    assert "estimated, without a bound" in str(grade)


def test_who_remembers_is_graded_exactly():
    def pursue(view, rng, memory):
        memory["steps"] = memory.get("steps", 0) + 1
        return 1 if memory["steps"] == 1 else 3

    grade = mw.grade(pursue, worlds=AT_ONCE)
    assert list(grade.teams) == ["pursuer"]
    assert not grade.teams["pursuer"].estimate


def test_genomes_are_graded_with_their_own_views():
    small = mw.WorldConfig("O", rows=3, cols=3, n_pursuers=2, n_evaders=1, max_steps=3, fov=3)
    network = random_team(small, 0)
    found = mw.grade(network, "evader", worlds=mw.WorldConfig(**_fields(small, fov=11)))
    expected = best_response(small, network, "evader").value
    [of_world] = found.teams["evader"].worlds
    assert of_world.guarantees == pytest.approx(1 - expected, abs=1e-12)


def _fields(config, **changed):
    names = ("rules", "rows", "cols", "n_pursuers", "n_evaders", "max_steps", "fov")
    return {name: getattr(config, name) for name in names} | changed


def test_grades_are_values_of_json_and_text():
    found = mw.grade("-adversary", worlds=[SMALL, AT_ONCE])
    plain = json.loads(json.dumps(found.to_json(), allow_nan=False))
    assert plain["teams"]["pursuer"]["share"] == found.teams["pursuer"].share
    text = str(found)
    assert text.index("Where it loses most") < text.index("\nGrade ")
    assert "% of the gap" not in text


def test_the_suite_has_worlds_of_both_kinds_and_teams_of_many_sizes():
    assert (mw.SUITE.name, mw.SUITE.version, len(mw.SUITE.worlds)) == ("MW-25", 1, 25)
    assert sum(world.in_turns for world in mw.SUITE.worlds) == 12
    sizes = {(w.config.n_pursuers, w.config.n_evaders) for w in mw.SUITE.worlds}
    assert sizes == {(1, 1), (2, 1), (1, 2), (2, 2), (3, 1)}
    for world in mw.SUITE.worlds:
        assert world.perfect.value == pytest.approx(world.value, abs=1e-12)


@pytest.mark.parametrize("number", range(25))
def test_the_suite_says_what_scripts_guarantee(number):
    world = mw.SUITE.worlds[number]
    for team in ("pursuer", "evader"):
        for script, rate in world.scripts(team).items():
            found = best_response(world.perfect.states, script, team).value
            assert found == pytest.approx(rate, abs=1e-12)


def test_bad_worlds_are_refused():
    with pytest.raises(ValueError, match="worlds: expected at least one, got none"):
        mw.grade("chaser", worlds=[])
    with pytest.raises(TypeError, match="worlds"):
        mw.grade("chaser", worlds=["O"])
    nothing = mw.WorldConfig("O", rows=3, cols=3, n_pursuers=1, n_evaders=1, max_steps=1)
    with pytest.raises(ValueError, match="expected worlds in which perfect pursuers get something"):
        mw.grade("chaser", "pursuer", worlds=nothing)
