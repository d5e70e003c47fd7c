"""Toys, against their known answers."""

import numpy as np
import pytest

from course import synthetic_races, toys
from course.toys import (
    PAPER,
    ROCK,
    SCISSORS,
    History,
    Side,
    evolve,
    flip,
    mutate_biased,
    select_proportionate,
)
from matrices import ROCK_PAPER_SCISSORS
from matrixworld import analysis
from matrixworld.coevolution.opponents import HallOfFame, Latest, Prioritized, Uniform
from matrixworld.coevolution.types import TEAMS

# Rock-paper-scissors


def test_specialists_cycle_with_period_three():
    hands = toys.alternate("specialist-specialist", 30, 1)
    # By hand: paper beats rock, scissors beat paper, rock beats scissors, and so on.
    assert hands["pursuer"][:4] == [ROCK, PAPER, ROCK, SCISSORS]
    assert hands["evader"][:4] == [ROCK, SCISSORS, PAPER, ROCK]
    for team in hands:
        after_the_first = hands[team][1:]
        assert after_the_first[3:] == after_the_first[:-3]
        assert set(after_the_first[:3]) == {ROCK, PAPER, SCISSORS}


def test_generalists_do_not_cycle():
    """A player of average hands is nearly in equilibrium, unlike one of the last specialists."""

    def exploitability(hands):
        x, y = (np.bincount(hands[team], minlength=3) / len(hands[team]) for team in TEAMS)
        return analysis.exploitability(ROCK_PAPER_SCISSORS, x, y).total

    assert exploitability(toys.alternate("generalist-generalist", 200, 200)) < 0.1
    assert exploitability(toys.alternate("specialist-specialist", 2, 1)) > 0.3


def test_capture_probabilities():
    pure = np.eye(3)
    np.testing.assert_allclose(toys.capture_probabilities(pure, pure), ROCK_PAPER_SCISSORS)
    lucky = toys.capture_probabilities(pure, pure, luck=0.1)
    np.testing.assert_allclose(lucky[0], [0.5, 0.1, 0.9])
    np.testing.assert_allclose(
        toys.capture_probabilities(np.full((1, 3), 1 / 3), pure), [[0.5] * 3]
    )
    with pytest.raises(ValueError, match="luck: expected"):
        toys.capture_probabilities(pure, pure, luck=0.6)


# Numbers games


def test_games_by_hand():
    beats_where_farthest = toys.GAMES["focusing"].beats
    beats_where_nearest = toys.GAMES["intransitive"].beats
    a, b = np.array([[5, 1], [3, 3], [4, 2]]), np.array([[2, 3], [3, 3], [1, 1]])
    # a - b = (3, -2), (0, 0), (3, 1)
    assert toys.GAMES["scalar"].beats(a[:, :1], b[:, :1]).tolist() == [True, False, True]
    assert beats_where_farthest(a, b).tolist() == [True, False, True]
    assert beats_where_nearest(a, b).tolist() == [False, False, True]
    assert beats_where_nearest(b, a).tolist() == [True, False, False]
    # The intransitive game has circles: (0, 2) beats (4, 1) beats (3, 5) beats (0, 2).
    x, y, z = np.array([[0, 2]]), np.array([[4, 1]]), np.array([[3, 5]])
    assert [beats_where_nearest(*pair)[0] for pair in ((x, y), (y, z), (z, x))] == [True] * 3


@pytest.mark.parametrize(
    ("name", "flips", "expected", "tolerance"),
    # Four standard errors of four seeds around the means over 20 seeds; their standard deviations
    # are 0.2, 2.8, 20.4, 0.1, 3.0 and 26.1.
    [
        ("scalar", 0.005, 99.3, 0.4),
        ("focusing", 0.005, 85.6, 5.6),
        ("intransitive", 0.005, 53.2, 41.0),
        pytest.param("scalar", 0.0025, 99.7, 0.2, marks=pytest.mark.slow),
        pytest.param("focusing", 0.0025, 90.2, 6.0, marks=pytest.mark.slow),
        pytest.param("intransitive", 0.0025, 39.3, 52.0, marks=pytest.mark.slow),
    ],
)
def test_numbers_game(name, flips, expected, tolerance):
    finals = [toys.numbers_game(name, seed, flips=flips).final_objective for seed in range(4)]
    assert np.mean(finals) == pytest.approx(expected, abs=tolerance)


def test_flips_change_as_many_ones_as_zeros():
    bits = np.arange(100_000) % 2 == 0
    changed = flip(bits, np.random.default_rng(0), probability=0.1) != bits
    assert [changed[0::2].mean(), changed[1::2].mean()] == pytest.approx([0.1, 0.1], abs=0.01)


def test_same_seed_same_history():
    samplers = HallOfFame(newest=1, sampled=2), Uniform(3)
    once, again, other = (
        toys.numbers_game("intransitive", seed, generations=20, samplers=samplers)
        for seed in (1, 1, 2)
    )
    assert np.array_equal(once.ones, again.ones)
    assert np.array_equal(once.wins, again.wins)
    assert not np.array_equal(once.ones, other.ones)
    assert once.objective.shape == (21, 2, 25)
    assert once.wins.shape == (20, 2, 25)


def test_champions_are_played_besides_the_living():
    # A side with 15 living opponents and up to 3 champions can win at most 18 matches.
    samplers = HallOfFame(newest=1, sampled=2), HallOfFame(newest=1, sampled=0)
    wins = toys.numbers_game("scalar", 0, generations=60, samplers=samplers).wins
    assert wins[:, 0].max() == 18  # so it meets all of them, and no more
    assert wins[:, 1].max() == 16
    assert toys.numbers_game("scalar", 0, generations=60).wins.max() == 15


def all_zeros_or_ones(samplers):
    """Five generations in which children of side 0 are all zeros, and those of side 1 all ones."""

    def all_are(value):
        return Side(
            fitness=lambda wins: wins,
            select=select_proportionate,
            mutate=lambda bits, rng: np.full_like(bits, value),
        )

    sides, rng = (all_are(False), all_are(True)), np.random.default_rng(0)
    game = toys.GAMES["scalar"]
    return evolve(game, sides, rng, generations=5, opponents=2, samplers=samplers)


def test_champions_are_those_of_the_other_side():
    # From the second generation on, all of side 1 and its champions are ones, those of side 0
    # zeros: side 1 beats its two living opponents and one champion of side 0.
    wins = all_zeros_or_ones((Latest(), Latest())).wins
    assert (wins[1:, 1] == 3).all()
    assert (wins[:, 0] == 0).all()
    assert (wins[0] == 0).all()


def test_samplers_get_the_scores_against_champions():
    # There is no champion in the first generation, when all are zeros. Later side 1 beats every
    # champion; side 0 draws with the first champion of side 1 and loses to the others. The fifth
    # champions have played no match.
    samplers = Prioritized(count=9, decay=1.0), Prioritized(count=9, decay=1.0)
    all_zeros_or_ones(samplers)
    assert samplers[1].win_rates(5).tolist() == [1, 1, 1, 1, 0.5]
    assert samplers[0].win_rates(5).tolist() == [0.5, 0, 0, 0, 0.5]


def test_selection_in_proportion_to_fitness():
    rng = np.random.default_rng(0)
    counts = np.bincount(select_proportionate(np.array([0.0, 1.0, 3.0]), 4000, rng), minlength=3)
    assert counts.tolist() == [0, pytest.approx(1000, rel=0.1), pytest.approx(3000, rel=0.1)]
    counts = np.bincount(select_proportionate(np.zeros(2), 4000, rng))
    assert counts.tolist() == [pytest.approx(2000, rel=0.1)] * 2


def test_scores_of_a_history_by_hand() -> None:
    ones = np.array([[[[3], [3]], [[1], [1]]], [[[2], [2]], [[2], [2]]]])
    history = History(toys.GAMES["scalar"], ones, np.zeros((1, 2, 2)))
    scores = history.scores([0, 1], 3, np.random.default_rng(0))
    assert scores.shape == (2, 2, 3)
    # 3 against 1 and 2; 2 against 1 and 2.
    assert scores.mean(axis=2).tolist() == [[1.0, 1.0], [1.0, 0.5]]
    assert history.objective.tolist() == [[[3, 3], [1, 1]], [[2, 2], [2, 2]]]
    history.ones[0, 0] = [[0], [2]]  # one of two individuals wins, and each is drawn as often
    scores = history.scores([0], 2000, np.random.default_rng(0))
    assert scores.mean() == pytest.approx(0.5, abs=0.05)  # 4 standard errors


# Virulence


def test_bits_drift_to_their_bias():
    rng, bits = np.random.default_rng(0), np.zeros((200, 1, 100), dtype=bool)
    for _ in range(150):
        bits = mutate_biased(bits, rng, probability=0.03, bias=0.75)
    assert bits.mean() == pytest.approx(0.75 * (1 - 0.97**150), abs=0.01)


def test_full_virulence_disengages_the_hosts():
    races = [toys.hosts_and_parasites(1.0, seed) for seed in range(5)]
    # Known: engaged in 10 % of generations, hosts at 50. Spread over seeds: 5 %, and 3 ones.
    assert np.mean([race.engaged.mean() for race in races]) == pytest.approx(0.1, abs=0.07)
    hosts = np.mean([race.objective[-50:, 0].mean() for race in races])
    assert hosts == pytest.approx(50, abs=4)


def test_reduced_virulence_keeps_both_engaged():
    races = [toys.hosts_and_parasites(0.75, seed) for seed in range(5)]
    # Known: engaged in all generations (but the first ones, when all are zeros), hosts at 93.
    assert min(race.engaged.mean() for race in races) > 0.99
    hosts = np.mean([race.objective[-50:, 0].mean() for race in races])
    assert hosts == pytest.approx(93, abs=2)


def test_parasites_may_have_a_fitness_of_your_own():
    """It decides: a constant one is no selection, so that parasites drift to their bias."""
    given, named = (toys.hosts_and_parasites(v, 3, generations=40) for v in (lambda w: w, 1.0))
    assert np.array_equal(given.ones, named.ones)
    drifted = toys.hosts_and_parasites(np.zeros_like, 3, generations=200)
    assert drifted.objective[-50:, 1].mean() == pytest.approx(75, abs=5)


# Synthetic races: tests/evolution/test_judgement_benchmark.py looks at each kind


def test_an_unknown_kind_and_too_few_generations_are_refused():
    with pytest.raises(ValueError, match="kind: expected one of"):
        synthetic_races.synthetic_race("chess", 20, 0)
    with pytest.raises(ValueError, match="n: expected"):
        synthetic_races.synthetic_race("cycle", 3, 0)


@pytest.mark.parametrize("evaders", [1, 30])
@pytest.mark.parametrize(("episodes", "matchups"), [(1, 0.0), (10, 0.0), (50, 0.0), (10, 0.02)])
def test_mean_and_variance_of_matches(evaders, episodes, matchups):
    rng, rates = np.random.default_rng(1), np.full(40_000 // episodes, 0.3)
    played = synthetic_races.play_episodes(rates, episodes, rng, evaders=evaders, matchups=matchups)
    means = played.mean(axis=-1)
    # Binomial variance with evaders that share their fate to 1/5, and that of the matchups.
    expected = 0.3 * 0.7 * (1 + (evaders - 1) / 5) / evaders / episodes + matchups**2
    assert means.mean() == pytest.approx(0.3, abs=0.03)
    assert means.var() == pytest.approx(expected, rel=0.35)


def test_certain_matches_end_as_they_must():
    rng = np.random.default_rng(0)
    assert synthetic_races.play_episodes(np.ones(3), 5, rng).tolist() == [[1.0] * 5] * 3
    assert synthetic_races.play_episodes(np.zeros(3), 5, rng, evaders=30).max() == 0.0
