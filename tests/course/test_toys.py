"""Toys and synthetic races, against their known answers."""

from functools import partial

import numpy as np
import pytest

from course import toys
from judgement_races import play_episodes
from matrixworld.coevolution import check_game


def test_games_by_hand():
    focusing, intransitive = (
        partial(toys.beats, toys.GAMES[n]) for n in ("focusing", "intransitive")
    )
    a, b = np.array([[5, 1], [3, 3], [4, 2]]), np.array([[2, 3], [3, 3], [1, 1]])
    # a - b = (3, -2), (0, 0), (3, 1)
    assert toys.SCALAR.play(a[:, :1], b[:, :1], None).tolist() == [1.0, 0.5, 1.0]
    assert focusing(a, b).tolist() == [True, False, True]
    assert intransitive(a, b).tolist() == [False, False, True]
    assert intransitive(b, a).tolist() == [True, False, False]
    # The intransitive game has circles: (0, 2) beats (4, 1) beats (3, 5) beats (0, 2).
    x, y, z = np.array([[0, 2]]), np.array([[4, 1]]), np.array([[3, 5]])
    assert [intransitive(*pair)[0] for pair in ((x, y), (y, z), (z, x))] == [True] * 3


@pytest.mark.parametrize(
    ("name", "expected", "tolerance"),
    # Means over 20 seeds, and four standard errors of four.
    [
        ("scalar", 99.3, 0.4),
        pytest.param("focusing", 85.6, 5.6, marks=pytest.mark.slow),
        pytest.param("intransitive", 53.2, 41.0, marks=pytest.mark.slow),
    ],
)
def test_numbers_game(name, expected, tolerance):
    finals = [toys.numbers_game(name, seed).final_objective for seed in range(2)]
    assert np.mean(finals) == pytest.approx(expected, abs=tolerance)


def test_each_individual_meets_as_many_opponents_and_wins_breed():
    """Children of hosts are all zeros, and those of parasites all ones, in five generations."""
    learner = toys.Bits(redrawn=1.0, host_bias=0.0, parasite_bias=1.0)
    found = toys.evolve(toys.SCALAR, learner, 0, generations=5, opponents=2)
    assert (found.wins[:, 0] == 0).all()
    assert (found.wins[0] == 0).all()  # all begin with zeros
    assert (found.wins[1:, 1] == 2).all()
    assert found.final_objective.tolist() == [0, 100]


def test_games_keep_their_promises():
    for game in (toys.HANDS, *toys.GAMES.values()):
        check_game(game)


@pytest.mark.parametrize(
    ("virulence", "engaged", "hosts"),
    # Known: engaged in 10 % of generations, hosts at 50; in nearly all, hosts at 93. Spread over
    # seeds: 5 %, and 3 ones.
    [(1.0, 0.1, 50), (0.75, 0.995, 93)],
)
def test_virulence_disengages_the_hosts(virulence, engaged, hosts):
    race = toys.hosts_and_parasites(virulence, 0)
    assert race.engaged.mean() == pytest.approx(engaged, abs=0.1)
    assert race.objective[-50:, 0].mean() == pytest.approx(hosts, abs=6)


# tests/evolution/test_judgement_benchmark.py looks at each kind of synthetic race.


@pytest.mark.parametrize("evaders", [1, 30])
@pytest.mark.parametrize(("episodes", "matchups"), [(1, 0.0), (50, 0.0), (10, 0.02)])
def test_mean_and_variance_of_matches(evaders, episodes, matchups):
    rng, rates = np.random.default_rng(1), np.full(40_000 // episodes, 0.3)
    means = play_episodes(rates, episodes, rng, evaders=evaders, matchups=matchups).mean(axis=-1)
    # Binomial variance with evaders that share their fate to 1/5, and that of the matchups.
    expected = 0.3 * 0.7 * (1 + (evaders - 1) / 5) / evaders / episodes + matchups**2
    assert means.mean() == pytest.approx(0.3, abs=0.03)
    assert means.var() == pytest.approx(expected, rel=0.35)
