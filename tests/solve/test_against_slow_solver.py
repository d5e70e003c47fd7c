"""Values of small worlds against a slow reading of the rules, for all kinds of collisions."""

import warnings
from itertools import product

import numpy as np
import pytest

import matrixworld as mw
from matrixworld.solve import solve
from rows import CUSTOM, OCCUPATION, SURROUND, TOGETHER, B, D, R
from slow import quickly
from slow_solver import SlowSolver

TABLES = list(product((D, R, B), repeat=3))  # of a teammate, an evader and a pursuer
STEPS = 3


def compare(config: mw.WorldConfig, steps: int) -> None:
    solution, slow = solve(config, steps=steps), SlowSolver(config)
    expected = [slow.mean(n) for n in range(steps + 1)]
    found = list(solution.means) + [solution.value] * (steps + 1 - len(solution.means))
    np.testing.assert_allclose(found, expected, atol=1e-8)


def world(rules: mw.Rules, rows: int = 3, **changes: int) -> mw.WorldConfig:
    ground = [[0, 0, 0], [0, 1, 0], [0, 0, 0]][:rows]
    if not rules.captures:
        rules = mw.Rules(
            rules.interaction, rules.obstacle, rules.teammate, rules.evader, rules.pursuer, SURROUND
        )
    sizes = {"n_pursuers": 2, "n_evaders": 1, **changes}
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # rules that capture nobody are rules, too
        return mw.WorldConfig(rules, obstacles=np.array(ground, bool), **sizes)


@pytest.mark.slow
@quickly("number", range(len(TABLES)), lambda number: number == 13)
def test_all_tables_of_collisions_on_3_x_3(number: int) -> None:
    teammate, evader, pursuer = TABLES[number]
    obstacle = (D, R, B)[number % 3]
    compare(world(mw.Rules(TOGETHER, obstacle, teammate, evader, pursuer, OCCUPATION)), STEPS)


@pytest.mark.slow
@quickly("name", CUSTOM, lambda name: name == "swarm-SD")
def test_rules_with_turns(name: str) -> None:
    compare(world(CUSTOM[name]), STEPS)


@pytest.mark.parametrize("rules", ["O", "SB", "swarm-SD", "agents-D", "agents-R"])
def test_two_evaders(rules: str) -> None:
    row = CUSTOM[rules] if rules in CUSTOM else mw.VARIANTS[rules]
    compare(world(row, rows=2, n_pursuers=1, n_evaders=2), 2)
