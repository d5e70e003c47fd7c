"""Scripts in evolution/ that measure over many runs: their runs, verdicts, tables and files."""

import json
import re
from collections.abc import Callable
from dataclasses import replace
from functools import partial
from pathlib import Path

import numpy as np
import pytest

import actor_critic_baselines as baselines
import actor_critic_races as races
import common
import ground_truth
import hall_of_fame
import interval_coverage as coverage
import judgement_tables
import learned_exploitability as learned
import matrixworld as mw
import paper_claims
import paper_surrounding
import psro
import race_budgets
import safe_learning
import scripted_pursuit
import yoked_races
from evolution_scripts import DOCS, RESULTS, read, run_quickly, run_script
from matrixworld.analysis import MEASURES, interval_over_runs, read_payoffs
from matrixworld.analysis.judge import RULES
from matrixworld.coevolution import open_run

# What is published follows from the numbers beside it

NUMBER = r"-?\d+\.\d+"
TABLES: dict[str, Callable[[Path], str]] = {
    "actor_critic/baselines.md": lambda at: baselines.table(
        baselines.FULL, dict(np.load(at / "baselines.npz"))
    ),
    "actor_critic/races.md": lambda at: races.table(dict(np.load(at / "races.npz"))),
    "coverage/coverage.md": lambda at: coverage.table(coverage.read_counts(at / "coverage.csv")),
    "ground_truth/measures.md": lambda at: ground_truth.report(
        json.loads(read(at / "races.json")), RESULTS / "judgement"
    ),
    "hall_of_fame/comparison.md": lambda at: hall_of_fame.table(
        hall_of_fame.read_races(at / "races.csv")
    ),
    "judgement/errors.md": judgement_tables.report_of,
    "learned_exploitability/table.md": lambda at: learned.table(
        json.loads(read(at / "numbers.json"))
    ),
    "yoked_races/comparison.md": lambda at: yoked_races.report(
        json.loads(read(at / "numbers.json"))
    ),
    "psro/table.md": lambda at: psro.table(json.loads(read(at / "numbers.json"))),
    "race_budgets/table.md": lambda at: race_budgets.table(json.loads(read(at / "numbers.json"))),
    "safe_learning/table.md": lambda at: safe_learning.table(dict(np.load(at / "numbers.npz"))),
    "paper_surrounding/table.md": lambda at: paper_surrounding.tables(
        dict(np.load(at / "numbers.npz"))
    ),
    "scripted_pursuit/table.md": lambda at: scripted_pursuit.table(
        {
            name: [row and scripted_pursuit.Row(*row) for row in rows]
            for name, rows in json.loads(read(at / "numbers.json")).items()
        }
    ),
}
"""Published tables, and how they are made from the other files of their directory."""


def assert_follows(told: str, published: str) -> None:
    """Compare all but the numbers exactly.

    Another processor or SciPy may round otherwise, so that ties fall the other way and samples
    differ: numbers change a little.
    """
    texts = (told.strip(), published.strip())
    told_words, published_words = (re.sub(NUMBER, "#", text) for text in texts)
    assert told_words == published_words
    values, expected = ([*map(float, re.findall(NUMBER, text))] for text in texts)
    assert values == pytest.approx(expected, rel=0.05, abs=0.011)


@pytest.mark.parametrize("name", TABLES)
def test_a_published_table_follows_from_published_numbers(name: str) -> None:
    told, published = TABLES[name]((RESULTS / name).parent), read(RESULTS / name)
    if name == "ground_truth/measures.md":  # has correlations of ranks with ties
        assert_follows(told, published)
    else:
        assert told.strip() == published.strip()


def test_published_claims_follow_from_published_numbers() -> None:
    file = RESULTS / "paper_claims" / "claims.md"
    told = paper_claims.tables(dict(np.load(file.with_name("numbers.npz"))))
    assert_follows(told, read(file))


@pytest.mark.parametrize("name", ["baselines", "races"])
def test_the_page_on_actor_critic_shows_the_published_tables(name: str) -> None:
    assert read(RESULTS / "actor_critic" / f"{name}.md") in read(DOCS / "actor_critic.md")


def test_the_page_on_safe_learning_shows_the_published_numbers() -> None:
    page = read(DOCS / "safe_learning.md")
    table = read(RESULTS / "safe_learning/table.md")

    def rows(text: str) -> list[list[str]]:
        lines = [line for line in text.splitlines() if line.startswith(("| grad", "| evol"))]
        return [[cell.strip() for cell in line.strip("|").split("|")] for line in lines]

    in_s, in_sb = (rows(part) for part in table.split("| -SB | capture"))
    expected = [[*one[:4], *other[1:4]] for one, other in zip(in_s, in_sb, strict=True)]
    assert [row[0] for row in in_s] == [row[0] for row in in_sb]
    assert rows(page) == expected
    assert table[table.index("| difference of") :] in page


# Halls of fame, archives, held-out opponents


@pytest.mark.slow
def test_race_budgets_compares_default_races_with_longer_ones(tmp_path: Path) -> None:
    printed = run_quickly("race_budgets", tmp_path)
    numbers = json.loads(read(tmp_path / "race_budgets" / "numbers.json"))
    for schedule in race_budgets.SCHEDULES:
        names = (race_budgets.key(kind, schedule) for kind in race_budgets.QUICK_EPOCHS)
        long, default = (numbers[name] for name in names)
        cells = 9 * 9 * 10
        assert long["matches"] - cells == 2 * (default["matches"] - cells)
        assert f"{np.mean(default['evader']) - np.mean(long['evader']):+.2f} [" in printed
    assert run_quickly("race_budgets", tmp_path) == printed


@pytest.mark.slow
def test_hall_of_fame_compares_two_kinds_of_race(tmp_path: Path) -> None:
    printed = run_quickly("hall_of_fame", tmp_path)
    assert "| living opponents only | halls of fame | difference | Holm | |" in printed
    assert {path.name for path in tmp_path.iterdir()} == {"runs", "hall_of_fame"}
    results = tmp_path / "hall_of_fame"
    assert {path.name for path in results.iterdir()} == {"races.csv", "comparison.md", "seed_0.png"}
    assert printed.startswith(read(results / "comparison.md"))
    matches = [
        open_run(tmp_path / "runs/hall_of_fame" / kind / "0").log()["matches"][-1]
        for kind in ("living-opponents-only", "halls-of-fame")
    ]
    assert matches[0] == matches[1] == 8 * 3 * 8 * 4
    # Read from the files: nothing is played again.
    assert run_quickly("hall_of_fame", tmp_path) == printed


def test_both_kinds_of_published_races_have_the_same_seeds() -> None:
    found = hall_of_fame.read_races(RESULTS / "hall_of_fame" / "races.csv")
    seeds = [[row["seed"] for row in rows] for rows in found.values()]
    assert seeds[0] == seeds[1] == list(range(len(seeds[0])))


@pytest.mark.parametrize(
    ("p", "difference", "expected", "verdict"),
    [
        (0.01, -0.1, -1, "as expected"),
        (0.01, -0.1, 1, "the opposite"),
        (0.05, 0.1, 1, "as expected"),
        (0.06, 0.1, 1, "cannot tell"),
    ],
)
def test_verdict_on_halls_of_fame(p: float, difference: float, expected: int, verdict: str) -> None:
    assert hall_of_fame.verdict(p, difference, expected) == verdict


# Yoked races


@pytest.mark.slow
def test_yoked_races_are_compared_with_races_of_the_same_seeds(tmp_path: Path) -> None:
    printed = run_quickly("yoked_races", tmp_path)
    assert printed.startswith(read(tmp_path / "yoked_races/comparison.md"))
    runs = tmp_path / "runs/yoked_races"
    for seed in range(2):
        yoked = open_run(runs / f"tiny-yoked-generalist-generalist/seed-{seed}")
        race = open_run(runs / f"tiny-generalist-generalist/seed-{seed}")
        assert Path(yoked.settings.schedule.race) == race.path.with_name(f"seed-{1 - seed}")
        assert (yoked.teams["pursuer"].genomes[0] == race.teams["pursuer"].genomes[0]).all()
    # Read from the files: nothing is played again.
    assert run_quickly("yoked_races", tmp_path) == printed


@pytest.mark.parametrize(
    ("p", "ends", "verdict"),
    [
        (0.01, (0.01, 0.03), "race higher"),
        (0.01, (-0.09, -0.01), "yoked higher"),
        (0.06, (-0.04, 0.049), "alike"),
        (0.06, (-0.04, 0.051), "cannot tell"),
        (1.0, (None, None), "cannot tell"),
    ],
)
def test_verdict_on_yoked_races(p: float, ends: tuple[float | None, ...], verdict: str) -> None:
    value = sum(ends) / 2 if None not in ends else 0.0
    difference = replace(interval_over_runs([0.0, 1.0]), value=value, low=ends[0], high=ends[1])
    assert yoked_races.verdict(p, difference) == verdict


# Several tests


def test_p_values_of_several_tests_are_adjusted_step_down() -> None:
    # 3 * 0.01, 2 * 0.02, and 0.03, which takes the value before it.
    np.testing.assert_allclose(common.holm([0.01, 0.03, 0.02]), [0.03, 0.04, 0.04])
    np.testing.assert_allclose(common.holm([0.5, 0.001, 0.9]), [1.0, 0.003, 1.0])


def test_p_value_of_seeds() -> None:
    # t = 0.3 / (0.1 / sqrt(3)) with two degrees of freedom.
    assert common.p_value([0.2, 0.3, 0.4]) == pytest.approx(0.035, abs=0.001)
    assert common.p_value([0.2, 0.3, 0.4], 0.3) == pytest.approx(1.0)
    # Without spread there is no t: signs are counted.
    assert common.p_value([0.1] * 6) == 2 * 0.5**6
    assert common.p_value([0.1] * 6, 0.1) == 1.0


@pytest.mark.slow
def test_archives_are_compared_at_one_budget(tmp_path: Path) -> None:
    printed = run_quickly("archives", tmp_path, "--samplers", "latest", "maxsolve")
    budget = int(printed.split(" matches")[0].rsplit(" ", 1)[-1].replace(",", ""))
    ends = [
        open_run(tmp_path / "runs/archives" / name / "0").log()["matches"][-1]
        for name in ("latest", "maxsolve")
    ]
    assert budget == min(ends) < max(ends)
    assert printed.count("\n| latest |") == printed.count("\n| maxsolve |") == 1


@pytest.mark.slow
def test_psro_is_compared_at_one_budget(tmp_path: Path) -> None:
    printed = run_quickly("psro", tmp_path)
    assert {path.name for path in (tmp_path / "psro").iterdir()} == {
        "numbers.json", "table.md", "curves.png",
    }  # fmt: skip
    assert printed.startswith(read(tmp_path / "psro" / "table.md"))
    found = json.loads(read(tmp_path / "psro" / "numbers.json"))
    assert list(found["races"]) == list(psro.KINDS)
    for rows in found["races"].values():
        assert [row["seed"] for row in rows] == [0, 1]
        # An opponent that is told whom it meets gains no less than the best one.
        assert all(0.0 <= gain <= 1.0 for row in rows for gain in row["mixture"])
    budget, reached = psro.at_budget(found["races"])
    assert budget == min(row["matches"][-1] for rows in found["races"].values() for row in rows)
    assert (reached["PSRO, Nash"]["generation"] < 3).all()  # its matrix has a price
    # Read from the files: nothing is played or solved again.
    assert run_quickly("psro", tmp_path) == printed


def test_mixtures_of_a_race_are_equilibria_of_its_generations() -> None:
    matrix = np.array([[0.5, 0.0, 1.0], [1.0, 0.5, 0.0], [0.0, 1.0, 0.5]])
    first, whole = psro.mixtures(matrix, 1)[0], psro.mixtures(matrix, 2)[0]
    np.testing.assert_allclose(first, [0.0, 1.0, 0.0], atol=1e-9)  # paper beats rock
    np.testing.assert_allclose(whole, [1 / 3] * 3, atol=1e-9)


@pytest.mark.slow
def test_learned_exploitability_is_compared_at_equal_matches(tmp_path: Path) -> None:
    printed = run_quickly("learned_exploitability", tmp_path)
    results = tmp_path / "learned_exploitability"
    assert {path.name for path in results.iterdir()} == {"numbers.json", "table.md", "curves.png"}
    assert printed.startswith(read(results / "table.md"))
    numbers = json.loads(read(results / "numbers.json"))
    assert numbers["points"] == [64, 128, 192]
    assert (numbers["matches"], numbers["longer_matches"]) == (32, 128)
    assert list(numbers["races"]) == list(learned.KINDS)
    assert {row["generation"][-1] for row in numbers["races"]["generalists"]} == {3}
    # Its matrix has a price.
    assert all(row["generation"][-1] < 3 for row in numbers["races"]["PSRO, Nash"])
    for row in [*numbers["races"]["MaxSolve"], *numbers["longer"]["generalists"]]:
        scores = [*row["newest"].values(), *row["mixture"].values()]
        assert {len(each) for each in scores} == {len(row["generation"])}
        assert 0.0 <= np.min(scores) < np.max(scores) <= 1.0
    # Read from the files: nothing is played again.
    assert run_quickly("learned_exploitability", tmp_path) == printed


def test_members_of_a_mixture_have_shares_next_to_the_weights() -> None:
    weights = np.array([0.0, 0.53, 0.12, 0.35])
    shares = np.bincount(learned.members(weights), minlength=4) / learned.PARTS
    assert shares.sum() == 1.0
    assert shares[0] == 0.0
    np.testing.assert_allclose(shares, weights, atol=1 / learned.PARTS)


def test_learned_exploitability_is_what_responses_gain() -> None:
    row = {"newest": {"met": [0.4], "pursuer": [0.7], "evader": [0.8]}}
    found = learned.gains(row, "newest")
    # The evaders of the race escape in .6, the response in .8; .3 is gained against evaders.
    np.testing.assert_allclose([found[side][0] for side in learned.SIDES], [0.2, 0.3, 0.5])


@pytest.mark.slow
def test_held_out_opponents_are_the_same_for_any_number_of_processes(tmp_path: Path) -> None:
    evolve = partial(run_quickly, "evolve_held_out", tmp_path)
    assert "O done\nSB done\nWritten: held_out.npz" in evolve()
    evolve("--processes", "2", "--output", "again.npz")
    assert (tmp_path / "held_out.npz").read_bytes() == (tmp_path / "again.npz").read_bytes()
    lines = evolve("--table", "held_out.npz").splitlines()
    assert "| pursuers | O | SB |" in lines
    rows = [line.split(" | ") for line in lines if line.startswith("| evolved-")]
    assert len(rows) == 4
    assert all(len(row) == 3 for row in rows)


# Claims of the paper


@pytest.mark.slow
def test_paper_claims_are_measured_in_parts_and_put_together(tmp_path: Path) -> None:
    new = ("few-epochs", "plateau", "safety")
    printed = run_quickly("paper_claims", tmp_path, "--seeds", "1", "--parts", *new)
    assert "Not measured: races, cross-play, surrounding, long (`--parts`)." in printed
    file = tmp_path / "paper_claims/numbers.npz"
    first = dict(np.load(file))
    assert first["captured generalist-generalist with few epochs"].shape == (1, 7, 7, 10)
    assert first["plateau: held-out"].shape == (1, 13)
    assert first["surrounding for rewards: faults"].shape == (1, 2)
    # The last team and its training are those of the run.
    run = open_run(tmp_path / "runs/paper_claims/surrounding-for-captures/0")
    log, world = run.log(), run.settings.world
    in_training = 1000 * log["pursuer_faults"][-2:].sum() / log["length"][-2:].sum()
    told = first["surrounding for captures: faults"][0, 0]
    assert told == pytest.approx(in_training / world.n_pursuers)

    others = [part for part in paper_claims.PARTS if part not in new]
    printed = run_quickly("paper_claims", tmp_path, "--parts", *others)
    table = read(tmp_path / "paper_claims/claims.md")
    assert table in printed
    _, _, races, generalization, single, _, scores, *at_its_size = table.strip().split("\n\n")
    assert at_its_size[-1].startswith("| training | seeds | captured ")
    lines = [len(each.splitlines()) - 2 for each in (races, generalization, single, scores)]
    assert lines == [15 + 2, 5, 2 + 4 + 8 + 6, 9]
    numbers = dict(np.load(file))
    assert {name: len(each) for name, each in numbers.items() if name in first and each.ndim} == {
        name: 1 for name, each in first.items() if each.ndim
    }
    assert numbers["captured generalist-generalist"].shape == (2, 7, 7, 10)
    assert numbers["phases specialist-specialist"].shape == (2, 9, 2)
    assert numbers["cross-play of evaders"].shape == (5, 2, 3, 2, 7)
    assert numbers["held-out of pursuers"].shape == (4, 2)

    # Numbers of another size are not put beside these, and nothing is played.
    refused = run_script("paper_claims", tmp_path, "--parts", "long")
    assert refused.returncode == 2
    assert "expected numbers of races with 30 evaders, got 6" in refused.stderr


@pytest.mark.parametrize(
    ("values", "side", "verdict"),
    [
        ([0.2, 0.3, 0.4], "above", "reproduced"),
        ([0.2, 0.3, 0.4], "below", "not reproduced"),
        ([-0.2, 0.3, 0.1], "above", "cannot tell"),
        ([-0.2, -0.3, -0.4], "below", "reproduced"),
        ([0.0] * 10, "above", "cannot tell"),
        ([0.1] * 5, "above", "cannot tell"),
        ([0.1] * 10, "above", "reproduced"),
        ([0.1] * 9 + [np.nan], "above", "cannot tell"),
    ],
)
def test_verdict_on_a_claim(values: list[float], side: str, verdict: str) -> None:
    claim = paper_claims.Claim("it is so", "a number", {"": np.array(values)}, side)
    assert claim.verdict("", claim.p_value("")) == verdict


def test_phases_of_a_race_are_changes_while_one_team_learns() -> None:
    # The capture rate is the pursuers' generation minus that of the evaders, and 0.5.
    k = np.arange(6)
    rates = 0.5 + (0.05 * k[:, None] - 0.08 * k)[None, :, :, None] * np.ones(4)
    for team, change in (("pursuer", 0.05), ("evader", -0.08)):
        found = paper_claims.in_parts(rates, partial(paper_claims.phase, team))
        np.testing.assert_allclose([found["whole"], found["last half"]], change)


def test_who_learns_passively_is_a_difference_of_differences() -> None:
    numbers = dict(np.load(RESULTS / "paper_claims/numbers.npz"))
    scores = {team: paper_claims.standings(numbers, team) for team in ("pursuer", "evader")}
    gains = {
        team: each["held-out opponents"]["generalist-generalist"]
        - each["held-out opponents"][f"{team}s against random"]
        for team, each in scores.items()
    }
    thesis = paper_claims.claims(numbers)
    values = next(each.values for each in thesis if each.says.startswith("Who learns passively"))
    np.testing.assert_allclose(values["held-out opponents"], gains["evader"] - gains["pursuer"])


# Coverage of intervals

COVERAGE = RESULTS / "coverage" / "coverage.csv"
SCORES = read_payoffs(np.random.default_rng(0).random((14, 14, 9)), per_episode=True)


def test_normal_runs_are_covered_in_93_to_97_percent() -> None:
    counts = coverage.read_counts(COVERAGE)
    assert all(0 <= row.covered <= row.given <= row.repetitions for row in counts)
    # Equilibria take long: a quarter of the repetitions.
    assert {row.repetitions for row in counts} == {100, 400}
    for interval in ("mean of runs", "difference of runs"):
        rows = [row for row in counts if (row.interval, row.data) == (interval, "normal")]
        assert [row.samples for row in rows] == [2, 3, 5, 10, 20]
        covered, given = (sum(getattr(row, name) for row in rows) for name in ("covered", "given"))
        assert 0.93 < covered / given < 0.97


def test_intervals_over_episodes_cover_at_least_90_percent() -> None:
    counts = coverage.read_counts(COVERAGE)
    published = {row.interval for row in counts}
    # The measures of the evaders are those of the pursuers on the swapped matrix.
    decided = {name for row in RULES.values() for name in row.measures}
    unbiased = {
        name
        for name, one in MEASURES.items()
        if name not in decided and one.of(SCORES).across == "episodes"
    }
    assert {name.replace("evader", "pursuer") for name in unbiased} <= published
    for row in counts:
        # A flat matrix has no true transitive share, and hardly ever gets an interval.
        if (row.interval, row.data.split(",")[0]) == ("transitive_share", "flat"):
            assert row.given <= 0.1 * row.repetitions, row
        # One true equilibrium of many, and generations in the wrong order, as the page says.
        elif (row.interval.split("_")[-1], row.data[:5], row.size) in (
            ("diversity", "cycle", 8), ("intransitivity", "steps", 31),
        ):  # fmt: skip
            assert row.covered > 0.5 * row.given, row
        elif row.interval in unbiased and row.given >= 100:
            assert row.covered >= 0.9 * row.given, row


def test_aggregates_over_runs_are_withheld_below_six_and_cover_from_ten_on() -> None:
    counts = coverage.read_counts(COVERAGE)
    for interval in ("interquartile mean", "performance profile", "probability of improvement"):
        rows = [row for row in counts if row.interval == interval]
        assert {row.samples for row in rows} == {3, 5, 6, 10, 20}
        assert not any(row.given for row in rows if row.samples < 6)
        # Groups that hardly overlap are covered more rarely, as the page says.
        near = [row for row in rows if row.samples >= 10 and "far apart" not in row.data]
        assert len({row.data.split(", profile")[0] for row in near}) == 4
        assert all(row.covered >= 0.9 * row.given for row in near)
        assert all(row.given >= 0.85 * row.repetitions for row in rows if row.samples >= 6)


@pytest.mark.slow
def test_the_script_writes_counts_and_their_table(tmp_path: Path) -> None:
    printed = run_quickly("validation/interval_coverage", tmp_path, "--repetitions", "8")
    counts = coverage.read_counts(tmp_path / "coverage/coverage.csv")
    assert printed.startswith(coverage.table(counts))
    assert read(tmp_path / "coverage/coverage.md") == coverage.table(counts) + "\n"
    assert {row.repetitions for row in counts} == {2, 8}
    assert min(row.given for row in counts if row.interval == "mean of episodes") == 8


def test_a_table_lists_the_worst_case_and_exceptions() -> None:
    counts = [
        coverage.Count("mean", "even", 0, 5, 200, 200, 190),
        coverage.Count("mean", "odd", 8, 5, 200, 100, 80),
        coverage.Count("mean", "rare", 0, 5, 200, 10, 0),
    ]
    lines = coverage.table(counts).splitlines()
    assert lines[2] == "| mean | 5 | 52% | 87.1% | 80.0% | odd, 8 x 8 |"
    assert lines[-1] == "- mean, odd, 8 x 8: 80.0% at 5"
    assert "- " not in coverage.table(counts[:1]).split("Exceptions")[1]


# Policy gradients


def test_baselines_play_each_game_with_each_learner_and_continue(tmp_path: Path) -> None:
    pytest.importorskip("torch")
    told = run_quickly("actor_critic_baselines", tmp_path, "--processes", "1")
    results = tmp_path / "actor_critic"
    assert told.startswith(read(results / "baselines.md"))
    numbers = np.load(results / "baselines.npz")
    assert numbers["captures"].shape == (4, 3, 2, 4)
    root = tmp_path / "runs" / "actor_critic" / "quick"
    run = open_run(root / "evaders-against-random-pursuers" / "actor-critic" / "1")
    np.testing.assert_array_equal(numbers["captures"][2, 0, 1], run.payoff().capture_rates[-1, -1])
    # Taught evaders start from those of their own learner, and all meet the same pursuers.
    for learner in ("actor-critic", "evolution-equal-time"):
        taught = open_run(root / "evaders-against-those-pursuers" / learner / "1")
        begun = open_run(root / "evaders-against-random-pursuers" / learner / "1")
        rivals = open_run(root / "pursuers-against-random-evaders" / "actor-critic" / "1")
        genomes, pursuers = taught.teams["evader"].genomes, rivals.teams["pursuer"].genomes
        np.testing.assert_array_equal(genomes[0], begun.teams["evader"].genomes[-1])
        np.testing.assert_array_equal(taught.teams["pursuer"].genomes, pursuers[-1:])

    # A run without its time is played anew; the others are only read.
    lost = root / "pursuers-against-static-evaders" / "actor-critic" / "0"
    lost.with_suffix(".seconds").unlink()
    kept = {path: path.stat().st_mtime_ns for path in root.rglob("summary.json")}
    again = run_quickly("actor_critic_baselines", tmp_path, "--processes", "1")
    changed = [path for path, time in kept.items() if path.stat().st_mtime_ns != time]
    assert changed == [lost / "summary.json"]
    assert again.count("\n") == told.count("\n")


@pytest.mark.parametrize(
    ("team", "values", "verdict"),
    [
        ("pursuer", [0.9, 0.91, 0.92], "reached"),
        ("pursuer", [0.5, 0.51, 0.52], "not reached"),
        ("pursuer", [0.5, 0.95, 0.99], "cannot tell"),
        ("evader", [0.1, 0.11, 0.12], "reached"),
        ("evader", [0.97, 0.98, 0.99], "not reached"),
    ],
)
def test_verdicts_on_a_published_game(team: str, values: list[float], verdict: str) -> None:
    # The published interval is 0.8 +- 2.262 * 0.1 / sqrt(10) = 0.8 +- 0.072.
    game = baselines.Game("a game", team, "random", 0.8, 0.1)
    assert game.verdict(interval_over_runs(values, bounds=(0.0, 1.0))) == verdict


def test_a_published_number_without_spread_has_an_interval_of_its_ten_episodes() -> None:
    game = baselines.Game("a game", "pursuer", "random", 1.0, 0.0)
    # Clopper and Pearson: 0.025 ** (1 / 10).
    assert game.worst == pytest.approx(0.692, abs=0.01)
    # Seeds that agree have the interval of their episodes.
    captures = np.ones((3, 200))
    assert game.verdict(baselines.capture_rate(captures)) == "reached"
    assert game.verdict(baselines.capture_rate(0.6 * captures)) == "not reached"


def test_actor_critic_races_are_judged_by_schedule(tmp_path: Path) -> None:
    pytest.importorskip("torch")
    told = run_quickly("actor_critic_races", tmp_path, "--threads", "1")
    assert told.startswith(read(tmp_path / "actor_critic" / "races.md"))
    for schedule in ("specialist-specialist", "generalist-specialist", "generalist-generalist"):
        assert f"| {schedule} | " in told
    assert len(list((tmp_path / "runs").rglob("summary.json"))) == 3 * 2
    assert run_quickly("actor_critic_races", tmp_path, "--threads", "1") == told


def test_the_hours_of_the_published_size_are_projected(tmp_path: Path) -> None:
    pytest.importorskip("torch")
    done = run_script("actor_critic_races", tmp_path, "--quick", "--project")
    assert "hours of training" in done.stdout, done.stderr
    assert list(tmp_path.iterdir()) == []


# Safe learning


def test_safe_learning_compares_methods_at_equal_agent_steps(tmp_path: Path) -> None:
    pytest.importorskip("torch")
    printed = run_quickly("safe_learning", tmp_path)
    results = tmp_path / "safe_learning"
    assert {path.name for path in results.iterdir()} == {
        "table.md", "numbers.npz", "training.png", "methods.png",
    }  # fmt: skip
    table = read(results / "table.md")
    assert printed.startswith(table)
    rows = [line for line in table.splitlines() if line.startswith(("| gradients", "| evolution"))]
    assert len(rows) == 5 + 4 + 5
    for row in rows:
        cells = [cell.strip() for cell in row.strip("|").split("|")]
        if "mask of obstacles" in cells[0]:
            assert cells[4] == "0.0"
        if "right of way" in cells[0]:
            assert cells[3:8] == ["0.0"] * 5  # of all kinds, in the test and while training
    assert "pursuers were at fault 0 times in " in table
    with np.load(results / "numbers.npz") as numbers:
        name = "SB gradients: right of way"
        assert numbers[f"{name} / fault"].shape == (2, 3, 3)
        assert not numbers[f"{name} / fault"].any()
        assert numbers["long test"][0] >= 1e4
        steps = numbers[f"{name} / agent-steps"]
        captures = numbers[f"{name} / capture rate"]
    # The numbers are those of the runs.
    run = open_run(tmp_path / "runs/safe_learning/SB-gradients-right-of-way/1")
    assert steps[1, -1] == 3 * run.log()["steps"][-1]
    settings, own = run.settings, run.teams["pursuer"]
    last = mw.Population(own.genomes[-1:], own.network)
    world = settings.world
    matches = mw.Matches.of(0, 0, 10**6)
    played = mw.rollout(world, last, "random", matches, episodes=5)
    assert captures[1, -1] == pytest.approx(played.capture_rate.mean())
    assert run_quickly("safe_learning", tmp_path) == printed


def test_methods_are_compared_at_the_last_generation_within_the_budget() -> None:
    steps = {"S a": [[0, 50, 100], [0, 40, 90]], "S b": [[0, 70, 95], [0, 60, 120]]}
    numbers = {}
    for name, of_seeds in steps.items():
        numbers[f"{name} / agent-steps"] = np.array(of_seeds)
        numbers[f"{name} / collisions"] = np.array(of_seeds) / 10
        numbers[f"{name} / capture rate"] = np.arange(6).reshape(2, 3) / 10
        numbers[f"{name} / length"] = np.arange(6).reshape(2, 3)
        numbers[f"{name} / fault"] = np.arange(18.0).reshape(2, 3, 3)
    found = safe_learning.judged(numbers, "S a", budget=90)
    np.testing.assert_allclose(found["capture rate"], [0.1, 0.5])
    np.testing.assert_allclose(found["all"], [3 + 4 + 5, 15 + 16 + 17])
    np.testing.assert_allclose(found["length"], [1, 5])
    np.testing.assert_allclose(found["teammate"], [4, 16])
    np.testing.assert_allclose(found["training"], [100, 100])
    np.testing.assert_allclose(found["agent-steps"], [50e-6, 90e-6])
    np.testing.assert_allclose(
        safe_learning.judged(numbers, "S b", budget=95)["capture rate"], [0.2, 0.4]
    )


# Surrounding at the paper's size


def test_surrounding_is_played_and_measured_by_one_command(tmp_path: Path) -> None:
    pytest.importorskip("torch")
    printed = run_quickly("paper_surrounding", tmp_path)
    results = tmp_path / "paper_surrounding"
    assert {path.name for path in results.iterdir()} == {
        "table.md", "numbers.npz", "training.png",
    }  # fmt: skip
    assert printed.startswith(read(results / "table.md"))
    with np.load(results / "numbers.npz") as numbers:
        assert numbers["published / fault"].shape == (2, 4)
        assert not numbers["right of way / fault"].any()
        assert not numbers["right of way / last fault"].any()
        assert numbers["no mask / fault"].any()
        captured = numbers["right of way / last captured"]
    run = open_run(tmp_path / "runs/paper_surrounding/right-of-way/1")
    own = run.teams["pursuer"]
    last = mw.Population(own.genomes[-1:], own.network)
    matches = mw.Matches.of(0, 0, 10**6 + 1)
    played = mw.rollout(run.settings.world, last, "random", matches, episodes=400)
    assert captured[1] == pytest.approx(played.capture_rate.mean())
    assert run_quickly("paper_surrounding", tmp_path) == printed


def test_the_authors_log_has_each_tenth_epoch() -> None:
    log = paper_surrounding.published_log()
    np.testing.assert_array_equal(log["epoch"], np.arange(0, 5000, 10))
    assert ((log["captured"] >= 0) & (log["captured"] <= 1)).all()
    # Captures of five evaders; collisions are counts.
    np.testing.assert_allclose(log["captured"] * 5, np.round(log["captured"] * 5), atol=1e-9)
    # Without captures the reward follows from the collisions and 500 steps, but for neighbours.
    early = log["epoch"] < 900
    collided = sum(log[kind] for kind in ("obstacle", "teammate", "adversary"))
    left = log["reward"] + 12 * collided / 20 + 0.05 * 500
    assert (left[early] > -0.5).all()
    assert (left[early] < 15).all()


def test_windows_are_means_of_epochs() -> None:
    values = np.arange(12.0).reshape(2, 6)
    np.testing.assert_allclose(paper_surrounding.windows(values, 2)[1], [6.5, 8.5, 10.5])
    np.testing.assert_allclose(paper_surrounding.windows(values, 4), [[1.5], [7.5]])


# Scripted pursuers


def test_scripted_pursuit_plays_its_smallest_rows(tmp_path: Path) -> None:
    printed = run_quickly("scripted_pursuit", tmp_path)
    rows = json.loads(read(tmp_path / "scripted_pursuit/numbers.json"))
    assert list(rows) == [kind.name for kind in scripted_pursuit.KINDS]
    for kind in scripted_pursuit.KINDS:
        small, larger, *rest = rows[kind.name]
        assert rest == [None] * 3
        for captured, steps, faults, _ in (small, larger):
            assert len(captured) == len(steps) == 2
            assert all(0 < n <= 500 for n in steps)
            assert (faults == 0) == (kind.name != "-SB, surrounder")
    assert printed.startswith("Evaders captured in the last step / steps")


def test_evaders_of_the_authors_move_to_free_cells_one_by_one() -> None:
    # A pursuer, and three evaders in a corner: the first one has no free side until another left.
    positions = np.array([[5, 5], [0, 0], [0, 1], [1, 0]])
    for seed in range(20):
        moves = scripted_pursuit.open_moves(positions, 1, np.random.default_rng(seed))
        assert moves[0] == 0
        assert moves[1] in (2, 3)  # east or south of (0, 1)
        assert moves[2] in (2, 3)
    found = list(scripted_pursuit.sides(positions, 1))
    assert found == [[], [2, 3], [2, 3]]


def test_the_page_on_scripted_pursuit_shows_the_published_table() -> None:
    table = read(RESULTS / "scripted_pursuit/table.md").strip()
    assert table in read(DOCS / "scripted_pursuit.md")
