"""Races with opponent samplers, archives and fitness sharing."""

from __future__ import annotations

import numpy as np
import pytest

from matrixworld import Matches, Population, coevolution, rollout
from matrixworld.coevolution.fitness import mean_over_opponents, shared_fitness
from matrixworld.coevolution.schedules import ArchivedOpponents
from matrixworld.coevolution.seeding import Phase, training_seeds
from tiny_race import alternating, hall_of_fame


def test_runs_are_compared_at_equal_budgets(tmp_path):
    race = coevolution.start(alternating("latest", opponents=1, match_episodes=2), tmp_path / "run")
    race.run()
    run = coevolution.open_run(tmp_path / "run")
    # Generations of 2 pursuer epochs and 3 evader epochs of 4 candidates in 2 worlds: 16, then 24.
    at = {n: tuple(run.generation_at(t, n) for t in coevolution.TEAMS) for n in (15, 16, 39, 40)}
    assert at == {15: (0, 0), 16: (1, 0), 39: (1, 0), 40: (1, 1)}
    assert run.generation_at("pursuer", 10**6) == run.generation_at("evader", 160) == 4
    assert run.generation_at("evader", 159) == 3


def test_candidates_play_against_every_sampled_opponent(tmp_path):
    settings = alternating("round-robin", opponents=3, learner="ga", match_episodes=2)
    race = coevolution.start(settings, tmp_path / "run")
    calls = []

    def listening(config, pursuers, evaders, matches, **options):
        calls.append((pursuers, evaders, matches))
        return rollout(config, pursuers, evaders, matches, **options)

    race.training.rollout = listening
    race.run()
    # The last epoch of the last generation's evaders, before the evaluation of 5 rows.
    pursuers, _, matches = calls[-6]
    assert np.array_equal(pursuers.genomes, race.genomes("pursuer"))
    epoch = settings.schedule.evader_epochs - 1
    met = [(3 * epoch + turn) % 5 for turn in range(3)]
    assert matches.pursuer.tolist() == met * settings.learner.population
    assert matches.evader.tolist() == np.repeat(np.arange(settings.learner.population), 3).tolist()
    for turn, g in enumerate(met):
        seeds = training_seeds(settings.seed, g, 4, Phase.EVADERS_LEARN, epoch, 1)
        assert set(matches.seed[turn::3].tolist()) == set(seeds.tolist())


@pytest.mark.parametrize("name", ["maxsolve", "ipca", "lapca"])
def test_archives_hold_the_results_of_the_matches(tmp_path, name):
    size = None if name == "ipca" else 3
    met = ArchivedOpponents(archive=name, size=size, episodes=2)
    settings = alternating(name, pursuers_meet=met, evaders_meet=met, generations=5, seed=4)
    race = coevolution.start(settings, tmp_path / "run")
    race.run()
    pursuers, evaders = (Population(race.genomes(t), race.network) for t in coevolution.TEAMS)
    held = 0
    for team in coevolution.TEAMS:
        archive = race.samplers[team].archive
        for i, own in enumerate(archive.candidates.astype(int)):
            for j, opponent in enumerate(archive.tests.astype(int)):
                g, h = (own, opponent) if team == "pursuer" else (opponent, own)
                seeds = training_seeds(settings.seed, g, h, Phase.ARCHIVE, 0, 2)
                scores = rollout(
                    settings.training_world,
                    pursuers,
                    evaders,
                    Matches.of(g, h, seeds),
                )
                caught = round(3 * float(scores.capture_rate.sum()))  # of 3 evaders in 2 matches
                won = np.sign(caught - 3) * (1 if team == "pursuer" else -1)
                assert archive.payoffs[i, j] == (1 + won) / 2
                held += 1
    assert held


def test_sharing_by_hand():
    nan = np.nan
    payoff = np.array([[1.0, 0.0, nan], [1.0, nan, 0.5], [0.0, 0.0, nan]])
    # Opponent 0 is shared by two, opponent 2 belongs to individual 1; n / m = 3 / 3.
    shared = shared_fitness(payoff - 0.2, payoff, sharing="competitive", virulence=None)
    assert shared == pytest.approx([0.5 - 0.2, 1.5 - 0.2, 0.0 - 0.2])
    # Wins 1, 1.5 and 0: shares 2/3, 1 and 0 of the best; v = 3/4.
    eased = shared_fitness(payoff, payoff, sharing="none", virulence=0.75)
    assert eased == pytest.approx([1 - (1 / 9) ** 2, 1 - (1 / 3) ** 2, 0.0])
    plain = shared_fitness(payoff - 0.2, payoff, sharing="none", virulence=None)
    assert plain == pytest.approx([0.3, 0.55, -0.2])
    assert mean_over_opponents(payoff).tolist() == [0.5, 0.75, 0.0]
    assert mean_over_opponents(np.array([[1.0, 3.0]])).tolist() == [2.0]


@pytest.mark.parametrize(
    "changes", [{"sharing": "competitive"}, {"evader_virulence": 0.6, "pursuer_virulence": 1.0}]
)
@pytest.mark.parametrize("make", [alternating, hall_of_fame])
def test_sharing_changes_what_evolves(tmp_path, make, changes):
    same = {"learner": "ga", "population": 8, "generations": 4}
    if make is alternating:
        same |= {"opponents": 4, "evader_epochs": 6}
    plain, shared = make("uniform", **same), make("uniform", **same, **changes)
    archives = []
    for number, settings in enumerate((plain, shared)):
        race = coevolution.start(settings, tmp_path / str(number))
        race.run()
        archives.append(race.genomes("evader"))
    assert not np.array_equal(*archives)
