"""A team that learns on what it guarantees: its scores, what it needs, and its runs."""

from functools import cache

import numpy as np
import pytest

import matrixworld as mw
from matrixworld import coevolution as co
from matrixworld.explorer.teams import plain_game
from matrixworld.solver import best_response
from tiny_race import played, results, settings_of, stopped

SIDE, STEPS = 3, 3
SMALL = {
    "rules": "TO",
    "rows": SIDE,
    "cols": SIDE,
    "n_pursuers": 1,
    "n_evaders": 1,
    "fov": 5,
    "max_steps": STEPS,
    "schedule": "against",
    "learner": "cma",
    "learner.measure": "guarantee",
    "policy": "rating",
    "population": 4,
    "epochs": 5,
    "archive_every": 2,
    "seed": 3,
}
CELLS = [(row, column) for row in range(SIDE) for column in range(SIDE)]
MOVES = [(0, 0), (-1, 0), (0, 1), (1, 0), (0, -1)]


def guaranteed(**changes):
    return settings_of(**{**SMALL, **changes})


def moves_from(cell):
    """The cells of all moves inside the board; staying is one."""
    return [to for y, x in MOVES if (to := (cell[0] + y, cell[1] + x)) in CELLS]


def best_moves(own, adversary, weights):
    """The cells of the moves that a rating of ``adversary`` and ``exits`` takes, equally likely."""

    def rating(cell):
        distance = abs(cell[0] - adversary[0]) + abs(cell[1] - adversary[1])
        free = sum(to != cell for to in moves_from(cell)) / 4
        return weights[0] * distance / 2.5 + weights[1] * free

    ratings = {cell: rating(cell) for cell in moves_from(own)}
    return [cell for cell in ratings if ratings[cell] > max(ratings.values()) - 1e-6]


def capture_rate(team, weights):
    """Follow every answer of the other team from every start, by the rules of TO alone."""

    @cache
    def value(pursuer, evader, left):
        if pursuer == evader:
            return 1.0
        if not left:
            return 0.0
        return pursuer_moves(pursuer, evader, left)

    def pursuer_moves(pursuer, evader, left):
        def after(cell):
            return 1.0 if cell == evader else evader_moves(cell, evader, left)

        if team == "pursuer":
            return np.mean([after(cell) for cell in best_moves(pursuer, evader, weights)])
        return max(map(after, moves_from(pursuer)))

    def evader_moves(pursuer, evader, left):
        def after(cell):
            return value(pursuer, cell, left - 1)

        if team == "evader":
            return np.mean([after(cell) for cell in best_moves(evader, pursuer, weights)])
        return min(map(after, moves_from(evader)))

    starts = [(p, e) for p in CELLS for e in CELLS if p != e]
    return float(np.mean([value(p, e, STEPS) for p, e in starts]))


@pytest.mark.parametrize("team", ["pursuer", "evader"])
def test_scores_are_those_of_every_answer_followed_by_hand(team):
    inputs = ("adversary", "exits")
    game = guaranteed(team=team, inputs=inputs).training_game
    sign = -1.0 if team == "pursuer" else 1.0
    genomes = np.array([(1, 0), (1, 0.2), (1, -0.2), (1, 3), (0.3, -1)], np.float32) * sign
    own = np.array([0, 1, 2, 3, 4, 1])
    matches = (own, 0 * own, own) if team == "pursuer" else (0 * own, own, own)
    population = game.population(team, genomes)
    sides = (population, "best-response") if team == "pursuer" else ("best-response", population)
    scores = game.rollout(*sides, matches, episodes=1, threads=1)
    by_hand = [capture_rate(team, tuple(genomes[n].tolist())) for n in own]
    assert scores.scores[:, 0] == pytest.approx(by_hand)
    assert len(set(by_hand)) > 1
    fitness = game.values(scores, team, "guarantee")[:, 0]
    assert fitness == pytest.approx(by_hand if team == "pursuer" else 1 - np.array(by_hand))


@pytest.mark.parametrize("team", ["pursuer", "evader"])
@pytest.mark.parametrize(
    "kind",
    [
        {},
        {"learner": "es"},
        {"learner": "ga"},
        {"learner": "gp", "policy": "program"},
        {"learner": "es", "policy": "cells", "hidden": (3,)},
    ],
)
def test_what_learns_so_and_the_results_of_its_run(team, kind, tmp_path):
    settings = guaranteed(team=team, **kind)
    run = played(settings, tmp_path / "one", threads=2)
    assert run.settings.schedule.name == f"{team}-against-best-response"
    rates = run.payoff().matrix.ravel()
    assert len(rates) == len(run.teams[team].genomes) == 4
    world = run.settings.game.world
    exact = [
        best_response(world, mw.Population(genome[None], run.teams[team].policy), team).value
        for genome in run.teams[team].genomes
    ]
    assert rates == pytest.approx(exact)
    assert run.summary()["capture_rate"] == pytest.approx(exact[-1])
    assert run.log()["matches"][-1] == 5 * 4
    expected = results(run.path)
    assert results(played(settings, tmp_path / "two", threads=1).path) == expected
    stopped(settings, tmp_path / "three", generation=2)
    assert results(co.finish(tmp_path / "three").path) == expected


def test_it_improves_and_its_run_is_scored_explained_and_shown(tmp_path):
    run = played(guaranteed(n_pursuers=2, epochs=20, max_steps=2), tmp_path / "run")
    rates = run.payoff().matrix.ravel()
    assert rates[-1] > rates[0]
    assert 0.0 < co.score(run, episodes=4)["pursuer"].mean().value <= 1.0
    assert run.explain("pursuer", episodes=4).terms
    episode = run.record()
    assert episode.length <= 2
    assert run.policy("pursuer").population().genomes.shape == (1, 7)
    with pytest.raises(ValueError, match="expected a race, got a run of one team"):
        run.extend(50)


def test_its_page_has_a_recorded_match_against_the_best_response(tmp_path):
    game = plain_game(played(guaranteed(), tmp_path / "run"))
    assert game["exact"]
    assert game["shows"]["3 0"]["image"].startswith("data:image/gif;base64,")
    assert "best-response plays, which the page cannot ask" in game["missing"]


def test_it_learns_by_inputs_that_do_not_count_steps():
    assert guaranteed().game.policy.inputs == (
        "adversary", "pressure", "unclaimed", "open_side", "teammate", "exits", "room",
    )  # fmt: skip
    assert guaranteed(inputs=("must_yield",)).game.policy.inputs == ("must_yield",)


@pytest.mark.parametrize(
    ("changes", "said"),
    [
        (
            {"rows": 40, "cols": 40, "n_pursuers": 4},
            "got more than 2.31 joint places for 4 against 1",
        ),
        ({"rows": 12, "cols": 12, "n_pursuers": 3, "n_evaders": 2}, "agents on 12 x 12 cells"),
        ({"obstacles": 0.2}, "world.obstacles: expected 0 or a map with the measure guarantee"),
        ({"schedule": "hall-of-fame"}, "schedule: expected against with learner.measure guarantee"),
        ({"opponent": "chaser"}, "schedule.opponent: expected best-response with learner.measure"),
        ({"learner.measure": "capture-rate", "opponent": "best-response"}, "without the measure"),
        ({"learner": "actor-critic", "opponent": "best-response"}, "learner.measure: expected one"),
        ({"inputs": ("adversary", "ahead")}, "inputs: expected inputs that no episode draws"),
        ({"policy": "cells", "hidden": (3,), "memory": "gru"}, "memory: expected none with the"),
        ({"match_episodes": 2}, "match_episodes: expected no value with the measure guarantee"),
        ({"train_steps": 2}, "train_steps: expected no value, got 2; it has no effect with the"),
        ({"cost_limit": 2.0}, "cost_limit: expected no value, got 2.0; it has no effect with the"),
        ({"training_worlds": [{"rows": 4}]}, "training_worlds: expected none with the measure"),
    ],
)
def test_what_is_refused(changes, said):
    values = {**SMALL, **changes}
    if changes.get("schedule"):
        del values["epochs"], values["archive_every"]
    with pytest.raises(ValueError, match=said):
        co.RaceSettings.of(**values)


def test_code_of_your_own_that_has_no_such_measure_is_refused(tmp_path):
    own = {k: v for k, v in SMALL.items() if k not in ("learner.measure", "population")}
    settings = co.RaceSettings.of(
        **{**own, "learner": "own_code:HillClimber", "opponent": "best-response", "policy": "cells"}
    )
    with pytest.raises(ValueError, match="without the measure guarantee, got best-response"):
        co.create(settings, tmp_path / "run")
    assert not (tmp_path / "run").exists()
