"""Notebook 6: the numbers of its text."""

from __future__ import annotations

import numpy as np
import pytest

from matrixworld import analysis
from matrixworld.toys import play_episodes
from matrixworld.tutorial import kept
from matrixworld.tutorial.chapter_6 import ROCK_PAPER_SCISSORS, WELL


def test_a_perfect_order_of_clear_wins_has_two_thirds() -> None:
    staircase = np.greater.outer(np.arange(16), np.arange(16)).astype(float)
    assert analysis.transitive_share(staircase) == pytest.approx(2 / 3, abs=0.01)
    assert analysis.checkerboards(staircase).count == 0


def test_noise_lowers_the_transitive_share_and_the_correction_removes_the_bias() -> None:
    strength = np.linspace(-1, 1, 16)
    truth = 0.5 + 0.2 * np.subtract.outer(strength, strength)
    shares = []
    for seed in range(20):
        race = play_episodes(truth, 1, np.random.default_rng(seed))
        shares.append(analysis.transitive_share(race.mean(axis=2)))
    assert np.mean(shares) < 0.4
    corrected = [
        analysis.transitive_share_over_episodes(
            play_episodes(truth, 10, np.random.default_rng(seed))
        ).value
        for seed in range(20)
    ]
    assert np.mean(corrected) == pytest.approx(1.0, abs=0.06)


def test_alpha_rank_looks_at_directions_and_nash_at_stakes() -> None:
    weighted = ROCK_PAPER_SCISSORS.copy()
    weighted[2, 1], weighted[1, 2] = 0.6, 0.4
    assert analysis.alpha_rank(weighted).pursuers == pytest.approx(np.full(3, 1 / 3), abs=1e-3)
    assert analysis.nash_averaging(weighted).pursuers[0] < 0.1
    assert analysis.nash_averaging(WELL).pursuers[0] == pytest.approx(0.0, abs=1e-6)
    assert analysis.alpha_rank(WELL).pursuers[0] > 0.1


def test_what_halls_of_fame_changed() -> None:
    ends = {
        name: analysis.difference_of_runs(with_halls, without, paired=True)
        for name, (without, with_halls) in kept("halls").items()
    }
    for name in ("pursuer_forgetting", "evader_forgetting", "checkerboards"):
        assert ends[name].high < 0.0
    assert ends["pursuer_score"].low > 0.0
    assert ends["evader_score"].low < 0.0 < ends["evader_score"].high


def test_the_numbers_game_shows_no_help() -> None:
    living, with_hall = kept("numbers_game")["ones"]
    difference = analysis.difference_of_runs(with_hall, living)
    assert difference.low < 0.0 < difference.high


def test_what_the_small_races_show() -> None:
    cures = kept("cures")
    names = [str(name) for name in cures["samplers"]]
    rates = dict(zip(names, cures["captured"] / int(cures["evaders"]), strict=True))
    specialists = analysis.judge(rates["latest"], per_episode=True).headline
    assert specialists["forgetting"].verdict == "present"
    assert specialists["cycling"].verdict == "cannot tell"
    generalists = analysis.judge(rates["round-robin"], per_episode=True).headline
    assert generalists["cycling"].verdict == "absent"
    extra = cures["matches"].mean(axis=1) / 38_400 - 1
    assert (extra[:3] == 0.0).all()
    assert (extra[3:] > 0.01).all()
    assert (extra[3:] < 0.04).all()


def test_the_specialists_evaders_escape_most_often() -> None:
    cures = kept("cures")
    cross = cures["cross_play"] / int(cures["cross_evaders"])
    others = ~np.eye(len(cross), dtype=bool)
    escape = [1 - cross[others[i], :, i].mean(axis=(0, 1)) for i in range(len(cross))]
    ends = [analysis.interval_over_runs(each) for each in escape]
    assert np.argmax([each.value for each in ends]) == 0
    assert all(ends[i].high < ends[0].low for i in (1, 2))
