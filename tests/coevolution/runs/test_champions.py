"""Matches that choose champions: re-evaluated elites, and the retention of new genomes."""

from typing import Any

import numpy as np
import pytest
from matrixworld.coevolution.runs.training_matches import TrainingMatches

from matrixworld import Matches, Population, coevolution, rollout
from matrixworld.coevolution.fitness import fitness
from matrixworld.coevolution.seeding import Phase, training_seeds
from tiny_race import alternating

LONGER = {"generations": 3, "train_steps": 20}
ELITE: dict[str, Any] = {
    "learner": "ga", "elites": 3, "elite_episodes": 2, "population": 8, **LONGER,
}  # fmt: skip


def mean_fitness(race, team, genomes, opponents, seeds):
    """Return the fitness of genomes against opponents, match by match."""
    settings = race.settings
    values = np.zeros((len(genomes), len(opponents), len(seeds[0])))
    for i, j, e in np.ndindex(values.shape):
        pair = {team: genomes[i : i + 1], coevolution.types.other(team): opponents[j : j + 1]}
        scores = rollout(
            settings.training_world,
            Population(pair["pursuer"], race.network),
            Population(pair["evader"], race.network),
            Matches.of([0], [0], [seeds[j][e]]),
            episodes=settings.match_episodes,
        )
        penalty = settings.overlap_penalty
        values[i, j, e] = fitness(
            scores, team, measure=settings.fitness.measure, overlap_penalty=penalty
        )[0]
    return values.mean(axis=(1, 2))


def test_a_genome_is_kept_unless_it_is_worse_against_all_archived_opponents(tmp_path, monkeypatch):
    """Every decision of a race, played again match by match."""
    settings = alternating(**LONGER, retention_episodes=3, learning_rate=0.5, pursuer_epochs=4)
    race = coevolution.start(settings, tmp_path / "run", threads=1)
    learned = []
    retain = race.retain

    def spy(team, generation, before):
        genome = race.learners[team].genome.copy()
        others = race.genomes(coevolution.types.other(team))
        retain(team, generation, before)
        learned.append((team, generation, genome, race.archive[team][-1], others))

    monkeypatch.setattr(race, "retain", spy)
    race.run()
    kept = []
    for team, generation, genome, previous, opponents in learned:
        key = (settings.seed, generation, generation, Phase.RETENTION)
        seeds = training_seeds(*key, coevolution.TEAMS.index(team), 3 * len(opponents))
        new, old = mean_fitness(
            race, team, np.stack([genome, previous]), opponents, seeds.reshape(-1, 3)
        )
        archived = race.archive[team][generation]
        kept.append(bool(new >= old))
        assert np.array_equal(archived, genome if new >= old else previous)
    assert set(kept) == {True, False}  # both decisions were seen
    assert len(kept) == 6


def test_a_discarded_generation_leaves_the_learner_as_before(tmp_path, monkeypatch):
    # No new genome is ever good enough.
    monkeypatch.setattr(TrainingMatches, "keeps", lambda *_: False)
    retention = {"retention_episodes": 1, "match_episodes": 2}
    for number, learner in enumerate((LONGER, ELITE)):
        settings = alternating(**learner, **retention)
        race = coevolution.start(settings, tmp_path / str(number), threads=1)
        before = {team: race.learners[team].state() for team in coevolution.TEAMS}
        race.run()
        for team in coevolution.TEAMS:
            assert (race.genomes(team) == race.genomes(team)[0]).all()
            after = race.learners[team].state()
            assert all(np.array_equal(after[key], value) for key, value in before[team].items())


def test_the_champion_is_the_best_elite_of_new_matches(tmp_path, monkeypatch):
    settings = alternating(**ELITE)
    race = coevolution.start(settings, tmp_path / "run", threads=1)
    learner = race.learners["evader"]
    crowned = []
    choose = learner.choose_champion
    monkeypatch.setattr(
        learner,
        "choose_champion",
        lambda again: crowned.append((learner.elite_genomes(), again)) or choose(again),
    )
    met = []
    sample = race.samplers["evader"].sample

    def spy(*args):
        met.append(sample(*args))
        return met[-1]

    object.__setattr__(race.samplers["evader"], "sample", spy)
    race.run()
    assert len(crowned) == 3
    for generation, (genomes, again) in enumerate(crowned, start=1):
        last = met[generation * settings.schedule.evader_epochs - 1]
        key = (settings.seed, generation, generation, Phase.ELITE, 1)
        seeds = training_seeds(*key, 2 * len(last)).reshape(-1, 2)
        expected = mean_fitness(race, "evader", genomes, race.genomes("pursuer")[last], seeds)
        assert again == pytest.approx(expected)
        assert np.array_equal(race.archive["evader"][generation], genomes[np.argmax(again)])
    # Not always the fittest of the last epoch, which is the first of the elite.
    assert any(np.argmax(again) for _, again in crowned)
