"""Alternating races: matches, files, and equal results after an interruption."""

from __future__ import annotations

import numpy as np
import pytest

from matrixworld import coevolution
from matrixworld.coevolution import DisengagementWarning, Race, open_run
from matrixworld.coevolution.runs.race import HallOfFameRace
from matrixworld.coevolution.seeding import evaluation_seed
from matrixworld.play.rollout import Matches, rollout
from matrixworld.world.policy import Population
from tiny_race import constant_scores, hall_of_fame, tiny_race

EPOCHS = 2 * (2 + 3)
CALLS = EPOCHS + 3
"""Calls of `rollout` in a tiny race: one per epoch and one per row of the payoff matrix."""


@pytest.fixture(scope="module")
def straight(tmp_path_factory):
    """A tiny race that was never stopped."""
    race = Race(tiny_race(), tmp_path_factory.mktemp("straight") / "run", threads=1)
    race.run()
    return race


def test_archive_holds_every_generation(straight):
    for team, genomes in straight.files.archive().items():
        assert (genomes.shape, genomes.dtype) == ((3, straight.network.genome_size), np.float32)
        assert len(np.unique(genomes, axis=0)) == 3
        assert np.array_equal(straight.genomes(team), genomes)


def test_log_has_a_row_per_epoch_and_counts_matches(straight):
    log = straight.files.log()
    assert log["generation"].tolist() == [1] * 5 + [2] * 5
    assert log["team"].tolist() == (["pursuer"] * 2 + ["evader"] * 3) * 2
    assert log["epoch"].tolist() == [0, 1, 0, 1, 2] * 2
    assert log["opponent"].tolist() == [0, 0, 0, 1, 0, 0, 1, 0, 1, 2]
    assert log["matches"].tolist() == [4 * row for row in range(1, EPOCHS + 1)]
    steps = np.diff(log["steps"], prepend=0)
    assert np.allclose(steps, 4 * log["length"])
    assert straight.training.matches == straight.training_matches() == 4 * EPOCHS


def test_training_matches_are_those_of_the_log(tmp_path):
    played = []

    def play(config, pursuers, evaders, matches, **options):
        played.append((config.max_steps, pursuers, evaders, matches, options["episodes"]))
        return rollout(config, pursuers, evaders, matches, **options)

    race = Race(tiny_race(match_episodes=2), tmp_path / "run", play=play)
    race.run()
    archive = race.files.archive()
    log = race.files.log()
    rows = zip(log["generation"], log["team"], log["opponent"], strict=True)
    for call, (generation, team, opponent) in enumerate(rows):
        steps, pursuers, evaders, matches, episodes = played[call]
        learning, still = (pursuers, evaders) if team == "pursuer" else (evaders, pursuers)
        other = "evader" if team == "pursuer" else "pursuer"
        assert (steps, episodes, learning.genomes.shape[0]) == (8, 2, 4)
        met = matches.evader if team == "pursuer" else matches.pursuer
        assert set(met.tolist()) == {opponent}
        assert np.array_equal(still.genomes, archive[other][: len(still.genomes)])
        assert len(still.genomes) == coevolution.available(team, generation)
        assert np.array_equal(matches.seed[:2], matches.seed[2:])  # mirrored pairs
    training = [seed for *_, matches, _ in played[:EPOCHS] for seed in set(matches.seed)]
    evaluation = [seed for *_, matches, _ in played[EPOCHS:] for seed in set(matches.seed)]
    assert len(set(training + evaluation)) == 2 * EPOCHS + 9
    assert len(played) == CALLS


def test_every_cell_can_be_replayed_alone(straight):
    settings, archive, payoff = straight.settings, straight.files.archive(), straight.payoff()
    assert payoff.capture_rates.shape == (3, 3, 3)
    world = settings.world
    teams = [Population(archive[team], straight.network) for team in ("pursuer", "evader")]
    for g, h in [(0, 2), (2, 0), (1, 1)]:
        seed = evaluation_seed(settings.seed, g, h)
        scores = rollout(world, *teams, Matches.of(g, h, seed), episodes=3)
        assert np.array_equal(scores.capture_rate[0], payoff.capture_rates[g, h])
        assert np.array_equal(scores.length[0], payoff.lengths[g, h])
        assert np.array_equal(scores.faults[0].mean(axis=0), payoff.faults[g, h])
        episode = open_run(straight.files.path).record(g, h, episode=1)
        assert episode.length == payoff.lengths[g, h, 1]


def test_saved_run_counts_generations_from_both_ends(straight):
    saved = open_run(straight.files.path)
    assert np.array_equal(saved.record(-1, -3).positions, saved.record(2, 0).positions)
    with pytest.raises(IndexError, match="evader: expected a generation from 0 to 2, got 3"):
        saved.record(0, 3)


def test_the_files_hold_means_and_deviations_and_what_was_played(straight):
    arrays, payoff = straight.files.payoff(), straight.payoff()
    assert np.allclose(arrays["capture_rate"], payoff.capture_rates.mean(axis=2))
    assert np.allclose(arrays["capture_rate_std"], payoff.capture_rates.std(axis=2), atol=1e-6)
    assert np.allclose(arrays["length"], payoff.lengths.mean(axis=2))
    assert arrays["collisions"].shape == arrays["faults"].shape == (3, 3, 2, 3)
    assert (arrays["collisions"] >= arrays["faults"]).all()
    assert straight.files.summary()["evaluation_matches"] == 27
    assert straight.total_matches() == 4 * EPOCHS + 27


def test_progress_is_reported_when_asked(tmp_path):
    seen = []
    race = Race(tiny_race(), tmp_path / "run")
    race.run(seen.append)
    assert [each.done for each in seen] == [*range(4, 41, 4), 49, 58, 67]
    assert {(each.before, each.total) for each in seen} == {(0, 67)}
    assert (seen[0].what, seen[-1].what) == ("generation 1: pursuers", "tournament")


def test_bad_settings_leave_no_trace(tmp_path):
    with pytest.raises(ValueError, match="schedule: expected alternating, got hall-of-fame"):
        Race(hall_of_fame(), tmp_path / "run")
    with pytest.raises(ValueError, match="schedule: expected hall-of-fame, got alternating"):
        HallOfFameRace(tiny_race(), tmp_path / "run")
    with pytest.raises(TypeError, match="settings: expected RaceSettings, got {}"):
        Race({}, tmp_path / "run")
    assert not (tmp_path / "run").exists()


def disengaged(config, pursuers, evaders, matches, *, episodes=1, threads=None):
    """Return results in which all evaders are captured."""
    return constant_scores(1.0, (len(matches.seed), episodes))


def test_disengagement_causes_one_warning(tmp_path):
    race = Race(tiny_race(generations=5), tmp_path / "run", play=disengaged)
    with pytest.warns(DisengagementWarning, match="the pursuers win nearly all matches") as caught:
        race.run()
    assert len(caught) == 1
    assert race.stage == 10
    (sentence,) = race.files.summary()["disengagement"]
    assert sentence.startswith("generations 1 to 5")
