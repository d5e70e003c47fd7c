"""What players guarantee: memories against tables of steps, estimates against exact values."""

from itertools import product

import numpy as np
import pytest

import matrixworld as mw
from matrixworld.play.draws import NotExactError
from matrixworld.solver import Table, best_response, expected_payoff, guarantee, solve, table
from matrixworld.solver import memory as memory_module
from rows import random_team

SIZES = {"rows": 3, "cols": 3, "obstacles": [".#.", "...", "..#"], "max_steps": 4, "fov": 11}
WORLDS = {
    "O, 2 v 1": mw.WorldConfig("O", n_pursuers=2, n_evaders=1, **SIZES),
    "D, 1 v 2": mw.WorldConfig("D", n_pursuers=1, n_evaders=2, **SIZES),
    "teams, 2 v 1": mw.WorldConfig("TO", n_pursuers=2, n_evaders=1, **SIZES),
    "agents, 2 v 1": mw.WorldConfig(mw.Rules("agent-turns"), n_pursuers=2, n_evaders=1, **SIZES),
}
TEAMS = ("pursuer", "evader")


def towards(view, sign):
    """Return a step towards an adversary in view, or away from one."""
    middle = view.shape[1] // 2
    seen = np.argwhere(view[0] + view[1]) - middle
    if not len(seen):
        return 0
    down, right = sign * seen[0]
    if abs(down) > abs(right):
        return 3 if down > 0 else 1
    return 2 if right > 0 else 4


def forgets(view, rng, memory):
    """Remember the views, and choose by the present one alone."""
    memory["before"] = int(view.sum())
    return towards(view, 1) if rng.random() < 0.75 else 0


def forgetful(view, rng):
    return towards(view, 1) if rng.random() < 0.75 else 0


def flees(view, rng):
    return towards(view, -1) if rng.random() < 0.75 else int(rng.integers(5))


def rests_every_third_step(view, rng, memory):
    memory["steps"] = memory.get("steps", 0) + 1
    return 0 if memory["steps"] % 3 == 0 else towards(view, -1)


@pytest.mark.parametrize("team", TEAMS)
@pytest.mark.parametrize("name", WORLDS)
def test_a_memory_that_changes_nothing_changes_nothing(name, team):
    perfect = solve(WORLDS[name])
    found = guarantee(perfect, forgets, team)
    expected = guarantee(perfect, forgetful, team)
    for part in ("low", "high", "unread"):
        assert getattr(found, part) == pytest.approx(getattr(expected, part), abs=1e-12)
    response = best_response(perfect.states, forgetful, team)
    assert found.value == pytest.approx(response.value, abs=1e-12)
    assert not found.reason


@pytest.mark.parametrize("team", TEAMS)
@pytest.mark.parametrize("name", WORLDS)
def test_who_remembers_the_step_has_the_guarantee_of_a_table_of_steps(name, team):
    perfect = solve(WORLDS[name])
    states = perfect.states
    moves, rests = (
        table(states, lambda view, kind=kind: kind and towards(view, -1), team).steps[0]
        for kind in (1, 0)
    )
    by_step = Table(states, team, (moves, moves, rests, moves))
    found = guarantee(perfect, rests_every_third_step, team)
    assert found.value == pytest.approx(best_response(states, by_step, team).value, abs=1e-12)
    rival = ("evader", perfect) if team == "pursuer" else ("pursuer", perfect)
    pair = (by_step, rival[1]) if team == "pursuer" else (rival[1], by_step)
    assert found.unread == pytest.approx(expected_payoff(states, *pair), abs=1e-12)


def test_a_recurrent_network_is_followed_where_its_moments_are_few():
    config = mw.WorldConfig("TO", n_pursuers=1, n_evaders=1, **(SIZES | {"max_steps": 3}))
    perfect, network = solve(config), random_team(config, 0, memory="gru")
    found = guarantee(perfect, network, "evader")
    matches = mw.Matches.of(0, 0, range(100))
    played = mw.rollout(config, perfect.policy("pursuer"), network, matches, episodes=100)
    error = float(played.capture_rate.std()) / 100
    assert played.capture_rate.mean() == pytest.approx(found.unread, abs=4.5 * error)
    assert found.unread <= found.value + 1e-12


def test_too_many_moments_are_refused(monkeypatch):
    monkeypatch.setattr(memory_module, "MOST_MOMENTS", 1000)
    with pytest.raises(NotExactError, match="expected at most 1,000 moments"):
        guarantee(solve(WORLDS["agents, 2 v 1"]), rests_every_third_step, "pursuer")


@pytest.mark.parametrize("team", TEAMS)
@pytest.mark.parametrize("name", WORLDS)
def test_losses_add_up_to_what_is_missing(name, team):
    """The values of perfect play fall, turn by turn, from the value to the guarantee."""
    perfect = solve(WORLDS[name])
    for player in (forgetful, rests_every_third_step, "random"):
        found = guarantee(perfect, player, team)
        solution = found.perfect
        fallen = sum(
            (visit.reach * solution.before(visit.rounds, visit.turn) - visit.after).sum()
            for visit in found.visits
        )
        assert fallen == pytest.approx(perfect.value - found.value, abs=1e-12)
        for visit in found.visits:
            assert visit.reach.sum() == pytest.approx(1)
            np.testing.assert_allclose(visit.play.sum(axis=1), visit.reach, atol=1e-12)


def flees_by_other_draws(view, rng):
    """Draw as `flees` does, by numbers whose results nobody can follow."""
    return towards(view, -1) if rng.uniform() < 0.75 else int(5 * rng.uniform())


@pytest.mark.parametrize("team", TEAMS)
def test_an_estimate_is_a_bracket_of_the_exact_value(team):
    perfect = solve(WORLDS["O, 2 v 1"])
    exact = guarantee(perfect, flees, team).value
    found = [guarantee(perfect, flees_by_other_draws, team, seed=seed) for seed in range(8)]
    assert all("rng.uniform" in each.reason for each in found)
    low, high = (np.array([getattr(each, end) for each in found]) for end in ("low", "high"))
    for ends, sign in ((low, 1), (high, -1)):  # on average over the draws
        error = ends.std(ddof=1) / len(ends) ** 0.5
        assert sign * (exact - ends.mean()) >= -3 * error
    assert (high - low).mean() < 0.2


@pytest.mark.parametrize("team", TEAMS)
@pytest.mark.parametrize("name", WORLDS)
def test_a_direction_that_agents_draw_is_known_to_the_best_response(name, team):
    """All directions are met equally often: beside matches against perfect play, and a memory."""
    perfect = solve(WORLDS[name])
    config = perfect.states.config
    rating = mw.Rating(inputs=("ahead",), mask="none")
    genome = mw.Population(np.float32([1]), rating)  # walks on, always
    found = guarantee(perfect, genome, team)

    def walks_on(view, rng, memory):
        if "way" not in memory:
            memory["way"] = int(rng.integers(1, 5))
        return memory["way"]

    later = guarantee(perfect, walks_on, team)  # its direction is known after its first move
    assert found.unread == pytest.approx(later.unread, abs=1e-12)
    assert (found.value - later.value) * (1 if team == "pursuer" else -1) <= 1e-12
    numbered = found.perfect.states
    n = config.n_pursuers if team == "pursuer" else config.n_evaders
    values = []
    for ways in product(range(1, 5), repeat=n):
        play = []
        for turn in range(numbered.n_turns):
            first = config.n_pursuers if team == "evader" else 0
            rows = np.ones((numbered.count(turn), 1))
            for agent in numbered.members(turn, team):
                own = np.where(numbered.cells(turn)[:, agent] >= 0, ways[agent - first], 0)
                rows = (rows[:, :, None] * np.eye(5)[own][:, None]).reshape(len(rows), -1)
            play.append(rows)
        values.append(best_response(numbered, Table(numbered, team, (tuple(play),)), team).value)
    assert found.value == pytest.approx(np.mean(values), abs=1e-12)
    fallen = sum(
        (visit.reach * found.perfect.before(visit.rounds, visit.turn) - visit.after).sum()
        for visit in found.visits
    )
    assert fallen == pytest.approx(perfect.value - found.value, abs=1e-12)
    with pytest.raises(ValueError, match="reads ahead, a direction that each agent draws"):
        best_response(config, genome, team)


def test_what_reads_ahead_is_graded_in_short_episodes_only():
    config = mw.WorldConfig("TO", n_pursuers=1, n_evaders=1, **(SIZES | {"max_steps": 13}))
    genome = mw.Population(np.float32([1]), mw.Rating(inputs=("ahead",)))
    with pytest.raises(NotExactError, match="expected at most 12 steps"):
        guarantee(solve(config), genome, "evader")


def test_a_memory_that_draws_by_itself_is_refused():
    own = np.random.default_rng(0)

    def evade(view, rng, memory):
        return int(own.integers(5))

    with pytest.raises(NotExactError, match="answers differently when it is asked again"):
        guarantee(solve(WORLDS["O, 2 v 1"]), evade, "evader")


def test_only_a_solution_of_both_teams_is_perfect():
    states = solve(WORLDS["O, 2 v 1"]).states
    for wrong in (solve(states, payoff="capture-time"), best_response(states, "chaser", "pursuer")):
        with pytest.raises(ValueError, match="perfect: expected a solution by solve"):
            guarantee(wrong, "fleer", "evader")
