"""Games that come with the package: races of them are resumed, and judged as their answers say."""

from itertools import chain

import numpy as np
import pytest

from games import dilemma
from games import sorting_networks as sorting
from games.blotto import FIELDS, SOLDIERS, blotto
from games.nim import nim
from games.numbers_game import focusing, numbers, relativism
from games.red_and_blue import red_and_blue
from games.rock_paper_scissors import rock_paper_scissors
from games.sorting_networks import sorting_networks
from games.tic_tac_toe import tic_tac_toe
from matrixworld.analysis import judge, read_payoffs
from matrixworld.analysis.judgement import ABSENT
from matrixworld.coevolution import RaceSettings, RunGroup, check_game, create, finish
from pages import read
from tiny_race import directory_in_memory

pytestmark = pytest.mark.filterwarnings("ignore::matrixworld.coevolution.DisengagementWarning")

OBJECTS = {"red_and_blue": red_and_blue, "sorting": sorting_networks, "blotto": blotto}
GAMES = {
    "rock_paper_scissors": rock_paper_scissors, "numbers": numbers, "focusing": focusing,
    "relativism": relativism, "nim": nim, "tic_tac_toe": tic_tac_toe, **OBJECTS,
}  # fmt: skip
IN_TURNS = {
    "schedule": "specialist-specialist", "schedule.pursuer_epochs": 5, "schedule.evader_epochs": 5,
    "schedule.generations": 20,
}  # fmt: skip
LEARNERS = {
    "ga": {"learner": "ga", "learner.mutation": 0.5, "learner.population": 12},
    "es": {"learner": "es", "learner.learning_rate": 0.5, "learner.population": 12},
}
CLAIMS = {"arms race", "one-sided progress"}


def race(game, learner, schedule, seed):
    return RaceSettings.of({"game": game, "seed": seed, **LEARNERS[learner], **schedule})


@pytest.mark.parametrize("game", GAMES.values(), ids=GAMES)
def test_games_keep_their_promises(game):
    check_game(game)


def raced(*parts):
    """Return the payoff matrix, both archives and the judgement of a race."""
    with directory_in_memory() as place:
        create(race(*parts), place / "run")
        run = finish(place / "run")
        judgement = RunGroup((run.path,), (run,)).judgement
        return run.payoff().matrix, [*run.archive().values()], judgement


def test_teams_that_play_hands_cycle_and_do_not_improve():
    races = [raced(rock_paper_scissors, "ga", IN_TURNS, seed) for seed in range(3)]
    together = judge(read_payoffs(np.stack([matrix for matrix, _, _ in races]), exact=True))
    for judgement in (together, *(judgement for _, _, judgement in races)):
        assert {"intransitivity", "cycling"} <= {*judgement.present("whole")}
        assert not CLAIMS & {*chain(*map(judgement.present, judgement.windows))}
    for matrix, (left, right), _ in races:
        assert np.ptp(matrix) > 0.5
        # Nobody beats the equilibrium, whatever has evolved.
        scores = rock_paper_scissors.play(np.zeros_like(left), right, None)
        np.testing.assert_allclose(scores, 0.5, atol=1e-6)


@pytest.mark.parametrize("learner", LEARNERS)
def test_larger_numbers_are_an_arms_race_unless_one_team_runs_away(learner):
    matrix, archives, judgement = raced(numbers, learner, IN_TURNS, 0)
    if learner == "ga":  # its mutants differ so much that one team leads, and wins nearly all
        assert judgement.present() == ("disengagement",)
    for window, findings in judgement.windows.items() if learner == "es" else ():
        assert "arms race" in judgement.present(window)
        for condition in ("intransitivity", "cycling", "forgetting", "stagnation"):
            assert findings[condition].verdict == ABSENT
    hosts, parasites = (archive.sum(axis=1) for archive in archives)
    assert (matrix[1:, 1:] > 0.5).tolist() == np.greater.outer(hosts, parasites)[1:, 1:].tolist()
    assert min(hosts[-1], parasites[-1]) > 50


# Games of objects: red and blue, Blotto, and sorting networks.


def made(game, count, seed=0):
    """Return some genomes of the first team."""
    operators, rng = game.operators["pursuer"], np.random.default_rng(seed)
    return [operators.genome(operators.untrained(rng)) for _ in range(count)]


HAND_MADE = {
    ("1", "1"): 1, ("1", "2"): 0, ("t", "1"): 1 / 3, ("you", "1"): 23 / 24, ("you", "me 1 +"): 0,
    ("you 1 +", "me 1 +"): 1, ("t 12 <", "1"): 1 / 2, ("+", "3"): 1, ("1 2 <", "2 1 <"): 0,
    ("2 2 *", "1"): 1, ("me 1 +", "t 1 +"): 1,
}  # fmt: skip


def test_programs_play_what_they_say():
    for programs, score in HAND_MADE.items():
        assert red_and_blue.play(*programs) == pytest.approx(score)
    with pytest.raises(ValueError, match="exit"):
        red_and_blue.play("exit", "1")


def test_no_program_is_best():
    exchanged = {"me": "you", "you": "me"}
    for program in made(red_and_blue, 50):
        same = " ".join(exchanged.get(word, word) for word in program.split())
        assert red_and_blue.play(same, program) == 1
        assert red_and_blue.play(program, f"{same} 1 +") == 0


def test_no_distribution_of_soldiers_is_best():
    assert blotto.play([60, 0, 0, 0, 0, 0], [10] * 6) == pytest.approx(1 / 6)
    assert blotto.play([10, 20, 0, 10, 10, 10], [10] * 6) == pytest.approx(1 / 2)
    for army in made(blotto, 50):
        assert sum(army) == SOLDIERS
        largest = int(np.argmax(army))
        answer = [0 if field == largest else army[field] + 1 for field in range(FIELDS)]
        answer[largest] = SOLDIERS - sum(answer)
        assert min(answer) >= 0
        assert blotto.play(answer, army) >= (FIELDS - 1) / FIELDS


def every_input(wires):
    """Return all inputs of zeros and ones as cases."""
    bits = np.arange(2**wires) >> np.arange(wires)[:, np.newaxis] & 1
    return [int.from_bytes(np.packbits(row, bitorder="little"), "little") for row in bits]


def sorted_share(monkeypatch, network, wires):
    """Return the share of all inputs of zeros and ones that a network sorts."""
    with monkeypatch.context() as patch:
        patch.setattr(sorting, "WIRES", wires)
        patch.setattr(sorting, "CASES", 2**wires)
        return sorting_networks.play(network, every_input(wires)) + len(network) / 1000


def batcher(wires):
    """Return the network of Batcher's odd-even merge sort (Knuth, 5.3.4)."""
    network, p = [], wires // 2
    while p:
        q, r, d = wires // 2, 0, p
        while d:
            network += [[i, i + d] for i in range(wires - d) if i & p == r]
            d, q, r = q - p, q // 2, p
        p //= 2
    return network


def test_networks_that_are_known_to_sort_do_so(monkeypatch):
    optimal = [[0, 1], [2, 3], [0, 2], [1, 3], [1, 2]]
    assert sorted_share(monkeypatch, optimal, 4) == 1
    for gone in range(5):
        assert sorted_share(monkeypatch, optimal[:gone] + optimal[gone + 1 :], 4) < 1
    network = batcher(16)
    assert len(network) == 63
    assert sorted_share(monkeypatch, network, 16) == 1
    assert sorted_share(monkeypatch, network[:-1], 16) < 1
    line = np.random.default_rng(1).permutation(16).tolist()
    for i, j in network:
        line[i], line[j] = sorted((line[i], line[j]))
    assert line == sorted(line)


def test_shares_are_those_of_cases_sorted_one_by_one():
    rng = np.random.default_rng(2)
    operators = sorting_networks.operators["evader"]
    for network in made(sorting_networks, 20):
        cases = operators.genome(operators.untrained(rng))
        done = 0
        for case in range(sorting.CASES):
            line = [bits >> case & 1 for bits in cases]
            for i, j in network:
                line[i], line[j] = min(line[i], line[j]), max(line[i], line[j])
            done += line == sorted(line)
        expected = max(0.0, done / sorting.CASES - len(network) / 1000)
        assert sorting_networks.play(network, cases) == pytest.approx(expected)


def test_networks_learn_to_sort(monkeypatch):
    settings = {"schedule": "hall-of-fame", "schedule.generations": 2, "schedule.joint_epochs": 10}
    own = {"game": sorting_networks, "seed": 0, "learner.population": 16, **settings}
    with directory_in_memory() as place:
        create(RaceSettings.of(own), place / "run")
        networks = finish(place / "run").genomes("networks")
    shares = [sorted_share(monkeypatch, network, sorting.WIRES) for network in networks]
    assert shares[0] < shares[1] < shares[2]


def test_the_page_names_all_games():
    page = read("evolution/games/README.md")
    for name in GAMES:
        assert f":{name}`" in page or f":{name}_networks`" in page


def test_prisoners_that_defect_win_and_all_lose_together():
    rng = np.random.default_rng(0)

    def mean(one, other):
        return np.mean([dilemma.play(one, other, rng) for _ in range(50)], axis=0)

    cooperates, defects, repeats = "CCCCC", "DDDDD", "CCDCD"  # the last one: tit for tat
    assert mean(cooperates, cooperates) == pytest.approx([0.6, 0.6], abs=0.02)
    assert mean(defects, defects) == pytest.approx([0.2, 0.2], abs=0.03)
    assert mean(defects, cooperates) == pytest.approx([1.0, 0.0], abs=0.05)
    assert mean(repeats, defects)[0] == pytest.approx(0.2, abs=0.05)
    check_game(dilemma.dilemma, matches=16)
