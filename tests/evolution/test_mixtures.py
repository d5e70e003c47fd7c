"""Mixtures that draw one champion an episode, against a recursion over all histories."""

import numpy as np
import pytest
from mixtures import mixture_bounds

import matrixworld as mw
from matrixworld.solve import States, best_response, solve


def states_of(variant: str, **changes: int) -> States:
    sizes = {"rows": 2, "cols": 3, "n_pursuers": 1, "n_evaders": 1, "max_steps": 2, **changes}
    return States(mw.WorldConfig(variant, **sizes))


def best_of_histories(states: States, mixture: list, team: str, steps: int) -> float:
    """Return what the best opponent gets that remembers all states of the episode."""
    played = [states.decisions(member, team) for _, member in mixture]
    best, axis = (min, 0) if team == "pursuer" else (max, 1)

    def value(state: int, weights: np.ndarray, turn: int, left: int) -> float:
        if left == 0:
            return float(weights.sum() * states.payoffs[state])
        last = turn + 1 == states.n_turns
        after = (0 if last else turn + 1, left - last)
        table = states.successors(turn)[state]
        each = [weight * moves[turn][state] for weight, moves in zip(weights, played, strict=True)]
        found = []
        for row in table.T if axis == 0 else table:  # one row for each reply
            sums = {s: [p[row == s].sum() for p in each] for s in np.unique(row).tolist()}
            found.append(sum(value(s, np.array(w), *after) for s, w in sums.items()))
        return best(found)

    weights = np.array([weight for weight, _ in mixture])
    return float(np.mean([value(s, weights, 0, steps) for s in states.starts.tolist()]))


@pytest.mark.parametrize(
    ("variant", "team", "changes"),
    [
        ("O", "evader", {}),
        ("TO", "pursuer", {}),
        pytest.param("O", "pursuer", {"max_steps": 3}, marks=pytest.mark.slow),
        pytest.param("O", "pursuer", {"n_pursuers": 2}, marks=pytest.mark.slow),
    ],
)
def test_bounds_hold_what_the_best_opponent_gets(
    variant: str, team: str, changes: dict[str, int]
) -> None:
    states = states_of(variant, **changes)
    names = ("chaser", "clumsy-chaser", "still") if team == "pursuer" else ("fleer", "still")
    network = mw.Network.for_config(states.config, hidden=(4,))
    genome = network.initial(np.random.default_rng(0), weight=3.0, head=3.0)
    members = [*names, mw.Population(genome[None], network)]
    mixture = [(1.0 / len(members), member) for member in members]
    low, high = mixture_bounds(states, mixture, team)
    exact = best_of_histories(states, mixture, team, states.config.max_steps)
    assert low - 1e-9 <= exact <= high + 1e-9
    assert high - low < 0.03
    # Better for the mixture than an opponent that is told before its first action.
    told = np.mean([best_response(states, member, team).value for member in members])
    assert low >= told - 1e-9 if team == "pursuer" else high <= told + 1e-9


def test_one_champion_has_equal_bounds_and_perfect_play_the_value() -> None:
    states = states_of("O", rows=3, n_pursuers=2)
    response = best_response(states, "chaser", "pursuer").value
    assert mixture_bounds(states, [(1.0, "chaser"), (0.0, "still")], "pursuer") == pytest.approx(
        (response, response), abs=1e-9
    )
    solution = solve(states)
    twice = [(0.3, solution), (0.7, solution)]
    assert mixture_bounds(states, twice, "evader") == pytest.approx((solution.value,) * 2, abs=1e-9)
    with pytest.raises(ValueError, match="champion: expected weights with the sum 1"):
        mixture_bounds(states, [(0.5, "chaser")], "pursuer")
