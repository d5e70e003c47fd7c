"""Small worlds solved exactly: values, perfect play, and best responses to a champion.

A team is one player here: it sees the whole world and chooses for all its members together. Small
means that all states fit into memory, such as 2 pursuers and an evader on 8 x 8 cells::

    from matrixworld import WorldConfig, record
    from matrixworld.solver import best_response, solve

    config = WorldConfig("O", rows=4, cols=4, n_pursuers=2, n_evaders=1, max_steps=5)
    solution = solve(config)
    solution.value  # 0.839: the capture rate when both teams play perfectly
    best_response(solution.states, "chaser", "pursuer").value  # the same against chasers
    record(config, "chaser", solution.policy("evader"), seed=0)

``docs/ground_truth.md`` says how it is done and what the numbers mean.
"""

from __future__ import annotations

from matrixworld.play.draws import NotExactError
from matrixworld.play.tables import Table, table
from matrixworld.solver.guarantee import Guarantee, guarantee
from matrixworld.solver.solution import Solution, best_response, expected_payoff, solve
from matrixworld.world.states import States

__all__ = [
    "Guarantee",
    "NotExactError",
    "Solution",
    "States",
    "Table",
    "best_response",
    "expected_payoff",
    "guarantee",
    "solve",
    "table",
]
