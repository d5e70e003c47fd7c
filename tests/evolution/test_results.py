"""What scripts in evolution/ have published follows from numbers beside it; verdicts by hand."""

import json
import re

import numpy as np
import pytest

import actor_critic_baselines as baselines
import actor_critic_claims
import added_inputs
import balance
import balanced_races
import convergence
import evolve_held_out
import ground_truth
import hall_of_fame
import input_worth
import interval_coverage as coverage
import judgement_tables
import league
import learned_exploitability as learned
import learning_or_competing
import liveness
import longer_races
import look_for_inputs
import map_races
import mask_price
import matrixworld as mw
import one_team
import page_races
import paper_claims
import paper_surrounding
import perfect_learners
import policies
import published_numbers
import race_budgets
import rating_inputs
import readable_price
import safe_learning
import scripted_pursuit
import yoked_races
import yoked_variants
import yoked_worlds
from evolution_scripts import RESULTS, read
from matrixworld import WORLDS, WorldConfig
from matrixworld.coevolution import TEAMS
from matrixworld.coevolution.evaluation.held_out import scripts_for

NUMBER = r"-?\d+\.\d+"


def of(table):
    """Return how a table is made from the numbers in its directory."""
    return lambda at: table(dict(np.load(at / "numbers.npz")))


OF_A_TABLE = (
    added_inputs, balanced_races, convergence, ground_truth, hall_of_fame, input_worth, league,
    learned, learning_or_competing, longer_races, page_races, perfect_learners, policies,
    map_races, race_budgets, rating_inputs, safe_learning, yoked_races, yoked_variants,
    yoked_worlds,
)  # fmt: skip
OF_SEVERAL = actor_critic_claims, paper_claims, paper_surrounding
TABLES = {
    **{f"{script.__name__}/table.md": of(script.table) for script in OF_A_TABLE},
    **{f"paper/{script.__name__}/table.md": of(script.tables) for script in OF_SEVERAL},
    "paper/actor_critic_baselines/table.md": of(baselines.table),
    "paper/published_numbers/table.md": of(published_numbers.table),
    "balance/table.md": lambda at: balance.table(json.loads(read(at / "numbers.json"))),
    "coverage/table.md": lambda at: coverage.table(coverage.read_counts(at / "coverage.csv")),
    "held_out/table.md": lambda at: evolve_held_out.table(json.loads(read(at / "numbers.json"))),
    "judgement/errors.md": judgement_tables.report_of,
    "liveness/table.md": lambda at: liveness.table(json.loads(read(at / "numbers.json"))),
    **{
        f"{script.__name__}/table.md": lambda at, script=script: script.table(
            json.loads(read(at / "numbers.json"))
        )
        for script in (look_for_inputs, readable_price)
    },
    "mask_price/table.md": lambda at: mask_price.table(json.loads(read(at / "numbers.json"))),
    "one_team/table.md": lambda at: one_team.table(one_team.read_rows(read(at / "numbers.json"))),
    "scripted_pursuit/table.md": lambda at: scripted_pursuit.table(
        scripted_pursuit.read_rows(read(at / "numbers.json"))
    ),
}
"""Published tables, and how they are made from the other files of their directory."""
ROUNDED = {
    "ground_truth/table.md",
    *(f"paper/{name}/table.md" for name in ("actor_critic_claims", "paper_claims")),
}
"""Tables with numbers that another processor or SciPy may round otherwise."""
LONG = ROUNDED | {
    "balanced_races/table.md", "coverage/table.md", "judgement/errors.md",
    "perfect_learners/table.md", "yoked_races/table.md",
}  # fmt: skip
"""Tables that take seconds."""


def test_worlds_with_names_are_those_that_the_search_has_chosen():
    found = balance.chosen(json.loads(read(RESULTS / "balance/numbers.json"))["raced"])
    assert [row["world"] for row in found] == [dict(world) for world in mw.WORLDS.values()]


@pytest.mark.parametrize(
    "name", [pytest.param(name, marks=[pytest.mark.slow] * (name in LONG)) for name in TABLES]
)
def test_a_published_table_follows_from_published_numbers(name):
    told, published = TABLES[name]((RESULTS / name).parent).strip(), read(RESULTS / name).strip()
    if name not in ROUNDED:
        assert told == published
        return
    told_words, published_words = (re.sub(NUMBER, "#", text) for text in (told, published))
    assert told_words == published_words
    values, expected = ([*map(float, re.findall(NUMBER, text))] for text in (told, published))
    assert values == pytest.approx(expected, rel=0.05, abs=0.011)


def test_the_best_script_of_a_result_is_of_all_scripts_that_can_play():
    """Careful ones are among them; whatever names the best script asks one function for them."""
    kept = np.load(RESULTS / "policies/numbers.npz")
    places = {kind.split(": ")[0]: each.game.world for kind, each in policies.kinds(False).items()}
    for place, world in places.items():
        for team in TEAMS:
            names = kept[f"scripts in {place}: {team}"].tolist()
            assert {*names} == {*scripts_for(team, world)}, (place, team)
            assert any(name.startswith("careful-") for name in names)
    kept = np.load(RESULTS / "balanced_races/numbers.npz")
    for place in WORLDS:
        for team in TEAMS:
            best, _ = kept[f"{place}: {team}"]
            assert best == learning_or_competing.BEST[place][team]
            assert best in scripts_for(team, WorldConfig.of(place))
