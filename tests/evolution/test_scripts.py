"""The scripts in evolution/ run, and their numbers are correct."""

import re
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import catching_fleers
import deap_example
import evolve_held_out
import generalization
import matrixworld as mw
import memory
import safe_coevolution
from evolution_scripts import DOCS, read, rows, run_quickly, run_script
from matrixworld import coevolution
from matrixworld.world.policy import GATES


def quick(name: str, place: Path, *options: str) -> str:
    """Return what a script prints; it also draws a figure of its own name."""
    told = run_quickly(name, place, *options)
    assert (place / f"{name}.png").read_bytes().startswith(b"\x89PNG")
    return told


@pytest.mark.slow
def test_arms_race_runs_and_draws(tmp_path: Path) -> None:
    told = quick("arms_race", tmp_path)
    for schedule in ("specialist-specialist", "generalist-generalist"):
        assert re.search(rf"^{schedule}: ([A-Z]|cannot tell)", told, re.M)
    assert told.count("Cycling: ") == 2
    assert [path.name for path in tmp_path.iterdir()] == ["arms_race.png"]


def test_an_unknown_schedule_is_refused(tmp_path: Path) -> None:
    done = run_script("arms_race", tmp_path, "--schedules", "tit-for-tat")
    assert done.returncode == 2
    assert "invalid choice: 'tit-for-tat'" in done.stderr
    assert list(tmp_path.iterdir()) == []


@pytest.mark.slow
def test_generalization_compares_at_equal_matches_and_reuses_its_runs(tmp_path: Path) -> None:
    told = quick("generalization", tmp_path)
    table = rows(told)
    assert [row[0] for row in table] == ["pursuers"] * 2 + ["evaders"] * 3
    for team in ("pursuers", "evaders"):
        assert len({row[2] for row in table if row[0] == team}) == 1
    for row in table:
        home, mean, worst, strange, worst_strange = map(float, row[3:])
        assert 0 <= home <= 1
        assert 0 <= worst <= mean <= 1
        assert 0 <= worst_strange <= strange <= 1

    runs = tmp_path / "runs" / "generalization" / "quick-0"
    race = coevolution.open_run(runs / "generalist-generalist")
    payoff = race.payoff().capture_rate
    assert float(table[0][3]) == pytest.approx(payoff[-1].mean(), abs=0.005)
    assert float(table[2][3]) == pytest.approx(1 - payoff[:, -1].mean(), abs=0.005)
    for k in (0, 2):  # the same pairs in other episodes
        assert float(table[k][4]) == pytest.approx(float(table[k][3]), abs=0.12)
    played = race.summary()["training_matches"]
    assert played == sum(int(table[k][2].replace(",", "")) for k in (0, 2))
    taught = coevolution.open_run(runs / "evaders-against-trained")
    halfway = coevolution.open_run(runs / "evaders-against-random-half").teams["evader"]
    teachers = coevolution.open_run(runs / "pursuers-against-random").teams["pursuer"]
    escaped = 1 - taught.summary()["capture_rate"]
    assert float(table[4][3]) == pytest.approx(escaped, abs=0.005)
    assert (taught.teams["evader"].genomes[0] == halfway.genomes[-1]).all()
    assert (taught.teams["pursuer"].genomes == teachers.genomes[-1:]).all()

    written = {path: path.stat().st_mtime_ns for path in runs.rglob("payoff.npz")}
    assert len(written) == 6
    assert quick("generalization", tmp_path) == told
    assert {path: path.stat().st_mtime_ns for path in written} == written


def test_generalization_refuses_runs_of_other_settings(tmp_path: Path) -> None:
    coevolution.start(generalization.QUICK, tmp_path / "race")
    with pytest.raises(ValueError, match="race: holds a run with other settings"):
        generalization.played(generalization.FULL, tmp_path / "race")


@pytest.mark.slow
def test_the_deap_example_is_determined_by_its_seed(tmp_path: Path) -> None:
    told = quick("deap_example", tmp_path)
    assert [path.name for path in tmp_path.iterdir()] == ["deap_example.png"]
    assert re.search(r"^4 +\t108 ", told, re.M)  # 6 + 4 x 12 players, against 2 rivals
    assert "a best response to these evaders captures 0." in told
    assert quick("deap_example", tmp_path) == told
    assert quick("deap_example", tmp_path, "--seed", "1") != told


def test_the_deap_example_scores_each_player_against_each_rival() -> None:
    world, rng = deap_example.SMALL, np.random.default_rng(0)
    network = mw.Network.for_config(world)
    own, rivals = (np.stack([network.initial(rng) for _ in range(n)]) for n in (3, 2))
    seeds = rng.integers(2**63, size=(3, 2))
    for team in coevolution.TEAMS:
        expected = np.zeros(3)
        for i, j in np.ndindex(3, 2):
            sides = (own[i], rivals[j]) if team == "pursuer" else (rivals[j], own[i])
            pursuer, evader = (mw.Population(genome, network) for genome in sides)
            match = mw.Matches.of(0, 0, seeds[i, j])
            scores = mw.rollout(world, pursuer, evader, match)
            captured = float(scores.captured_fraction[0, 0])
            escaped = 1 - captured - 0.2 * float(scores.evader_overlap[0, 0])
            expected[i] += (captured if team == "pursuer" else escaped) / 2
        np.testing.assert_allclose(
            deap_example.score(team, world, own, rivals, seeds), expected, rtol=1e-5
        )


def test_the_deap_example_evolves_a_response_that_wins() -> None:
    world = mw.WorldConfig("O", rows=8, cols=8, n_pursuers=2, n_evaders=4, max_steps=40, fov=7)
    budget = deap_example.Budget(world, 1, 1, 1, 24, 1, response=100)
    network, rng = mw.Network.for_config(world), np.random.default_rng(0)
    rival, naive = network.initial(rng), network.initial(rng)
    escaper = deap_example.best_response("evader", rival, budget, rng)
    before, after = deap_example.capture_rates(budget, rival, np.stack([naive, escaper]))[0]
    assert after < before - 0.1


@pytest.mark.slow
def test_safe_coevolution_prices_and_forbids_collisions(tmp_path: Path) -> None:
    *table, _, free_race, masked, change = rows(quick("safe_coevolution", tmp_path))
    assert {path.name for path in tmp_path.iterdir()} == {"safe_coevolution.png", "runs"}
    # Right of way: nobody is at fault in the last generation, nor in all of training.
    assert [free_race[0], masked[0]] == ["none", "right-of-way"]
    assert masked[3:] == ["0.0", "0.0", "0"]
    assert int(change[5].replace(",", "")) == -int(free_race[5].replace(",", "")) < 0
    assert [row[:2] for row in table] == [
        ["pursuers", "0"], ["pursuers", "1"], ["evaders", "0"], ["evaders", "1"],
    ]  # fmt: skip
    assert {row[-1] for row in table} == {"288"}
    score, obstacle, teammate = (
        [float(row[column].split()[0]) for row in table] for column in (2, 3, 4)
    )
    # All pursuers met all evaders: captures and escapes add up.
    assert sum(score[:2]) == pytest.approx(2 - sum(score[2:]), abs=0.03)
    for free, priced in ((0, 1), (2, 3)):
        assert obstacle[priced] + teammate[priced] < obstacle[free] + teammate[free]


def test_safe_coevolution_charges_each_team_for_its_own_faults() -> None:
    world = safe_coevolution.SMALL
    scores = mw.rollout(world, "random", "random", mw.Matches.of(0, 0, [1, 2]), episodes=3)
    for t, team in enumerate(coevolution.TEAMS):
        for match in range(2):
            each = []
            for episode in range(3):
                captured = scores.captured_fraction[match, episode]
                aim = captured if team == "pursuer" else 1 - captured
                faults = sum(int(n) for n in scores.faults[match, episode, t])
                each.append(aim - 0.5 * faults / scores.agent_steps[match, episode, t])
            assert safe_coevolution.fitness(scores, team, 0.5)[match] == pytest.approx(
                np.mean(each)
            )


def test_safe_coevolution_evaluates_each_champion_separately() -> None:
    network = mw.Network.for_config(safe_coevolution.SMALL)
    rng = np.random.default_rng(0)
    champions = {
        team: np.stack([network.initial(rng, head=head) for head in (0.01, 3.0)])
        for team in coevolution.TEAMS
    }
    budget = replace(safe_coevolution.QUICK, prices=(0.0,))
    told = safe_coevolution.evaluate(champions, budget)
    pursuers, evaders = (mw.Population(champions[team], network) for team in coevolution.TEAMS)
    for index in range(2):
        pairs = {"pursuer": [(index, 0), (index, 1)], "evader": [(0, index), (1, index)]}
        for t, team in enumerate(coevolution.TEAMS):
            collisions, steps, captured = np.zeros(3), 0, []
            for p, e in pairs[team]:
                match = mw.Matches.of(p, e, 2 * p + e)
                scores = mw.rollout(safe_coevolution.SMALL, pursuers, evaders, match, episodes=10)
                collisions[:2] += scores.faults[0, :, t, :2].sum(axis=0)
                collisions[2] += scores.collisions[0, :, t, 2].sum()
                steps += scores.agent_steps[0, :, t].sum()
                captured.append(scores.capture_rate.mean())
            score, rates = (each[0, index] for each in told[team])
            rate = np.mean(captured)
            assert score == pytest.approx(rate if team == "pursuer" else 1 - rate)
            np.testing.assert_allclose(rates, 1000 * collisions / steps, rtol=1e-9)


@pytest.mark.slow
def test_catching_fleers_tests_every_training_in_teams_of_several_sizes(tmp_path: Path) -> None:
    told = run_quickly("catching_fleers", tmp_path)
    table = {row[0]: row[1:] for row in rows(told)}
    plan = catching_fleers.QUICK
    assert len(table) == len(catching_fleers.SCRIPTED) + len(plan.changes)
    # Recorded episodes give the same captures as the script's rollouts.
    world = plan.base.world
    size = plan.teams[-1]
    episodes = [
        mw.record(
            mw.WorldConfig.of(world, n_pursuers=size), "chaser", "dodger", seed=0, episode=k
        ).capture_rate
        for k in range(plan.episodes)
    ]
    assert float(table["chaser"][-1]) == pytest.approx(np.mean(episodes), abs=0.005)
    assert run_quickly("catching_fleers", tmp_path) == told


@pytest.mark.slow
def test_memory_prints_all_tables_again(tmp_path: Path) -> None:
    told = run_quickly("memory", tmp_path)
    table = {row[0]: row[1:] for row in rows(told)}
    assert table["the best without memory, exactly"][0] == "0.617"
    assert {f"trained, {each}" for each in ("no memory", "elman", "gru")} <= table.keys()
    best = [float(rate) for rate in table["the best, exactly"]]
    for name in ("hunter", *(f"trained, memory: {each}" for each in GATES)):
        assert all(
            float(rate) <= most + 0.1
            for rate, most in zip(table[name][-len(best) :], best, strict=True)
        )
    assert [(row[0], row[1]) for row in rows(told)[-9:]] == [
        (schedule, each) for schedule in memory.SCHEDULES for each in GATES
    ]
    assert run_quickly("memory", tmp_path) == told


def test_the_corridor_without_memory_is_what_is_played_there() -> None:
    """A pursuer that goes east with some probability, and turns at the ends."""
    policy, rng = np.array([0.7, 0.9, 1.0]), np.random.default_rng(1)

    def choose(views: np.ndarray) -> np.ndarray:
        east = np.full(len(views), policy[0])
        seen = views[:, :, 1]  # channels, and the cells west and east
        east[seen[:, 2, 0] == 1] = policy[1]
        east[seen[:, 2, 2] == 1] = 1 - policy[2]
        east[seen[:, 0, 0] == 1] = 0.0
        east[seen[:, 0, 2] == 1] = 1.0
        moves = rng.random(len(views)) < east
        return np.where(moves, mw.Action.EAST, mw.Action.WEST)

    world = memory.CORRIDOR.world
    played = mw.score_policy(choose, "pursuer", world, opponents={"still": "still"}, episodes=400)
    # Three deviations of 400 episodes.
    assert played.mean().value == pytest.approx(memory.capture_rate(policy), abs=0.075)


def test_the_difficulty_of_opponents_is_what_the_page_says() -> None:
    measured: dict[str, list[float]] = {}
    for line in list(evolve_held_out.difficulty(300))[1:]:
        _, name, score = line.strip("| ").split(" | ")
        measured.setdefault(name, []).append(float(score))
    page = read(DOCS / "held_out.md")
    stated = dict(re.findall(r"^\| `([\w-]+)` \| [\w ]+ \| ([\d., ]+) \|", page, re.M))
    assert stated.keys() == measured.keys()
    for name, scores in measured.items():
        assert [*map(float, stated[name].split(", "))] == pytest.approx(scores, abs=0.06)
