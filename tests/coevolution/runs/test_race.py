"""Races in turns and at the same time: matches, files, opponents, sharing, and divergence."""

from typing import Any

import numpy as np
import pytest
from matrixworld.coevolution.runs.race import HallOfFameRace, pairings, table_of_individuals
from matrixworld.coevolution.schedules import ArchivedOpponents

from matrixworld import Matches, Population, coevolution, rollout
from matrixworld._util.files import load_arrays
from matrixworld.coevolution import TEAMS, DisengagementWarning, Race, open_run, resume, start
from matrixworld.coevolution.fitness import mean_over_opponents, shared_fitness
from matrixworld.coevolution.learners.learner import DivergedError
from matrixworld.coevolution.seeding import Phase, evaluation_seed, training_seeds
from tiny_race import alternating, constant_scores, hall_of_fame, tiny_race, tiny_single

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


def test_each_team_can_have_a_learner_of_its_own(straight, tmp_path):
    races = {}
    for kind in ("es", "ga"):
        settings = tiny_race(evader_learner={"kind": kind, "population": 4})
        races[kind] = Race(settings, tmp_path / kind, threads=1)
        races[kind].run()
    for team in TEAMS:
        assert np.array_equal(races["es"].genomes(team), straight.genomes(team))
    # The first pursuers have met the same untrained evaders; what these learned differs.
    same = {team: (races["ga"].genomes(team) == straight.genomes(team)).all(1) for team in TEAMS}
    assert same["pursuer"][:2].tolist() == [True, True]
    assert same["evader"].tolist() == [True, False, False]
    assert isinstance(races["ga"].learners["evader"], coevolution.GeneticAlgorithm)


def test_a_logger_is_told_where_a_run_is(tmp_path, caplog):
    caplog.set_level("INFO", logger="matrixworld")
    race = Race(tiny_race(generations=1), tmp_path / "run", threads=1)
    race.run()
    told = [record.getMessage().removeprefix(f"{tmp_path / 'run'}: ") for record in caplog.records]
    saved = [f"saved stage {n} of 2" for n in range(3)]
    assert told == [saved[0], "goes on from stage 0 of 2", *saved[1:], "ended"]


def test_log_has_a_row_per_epoch_and_counts_matches(straight):
    log = straight.files.log()
    assert log["generation"].tolist() == [1] * 5 + [2] * 5
    assert log["team"].tolist() == (["pursuer"] * 2 + ["evader"] * 3) * 2
    assert log["epoch"].tolist() == [0, 1, 0, 1, 2] * 2
    assert log["opponent"].tolist() == [0, 0, 0, 1, 0, 0, 1, 0, 1, 2]
    assert log["matches"].tolist() == [4 * row for row in range(1, EPOCHS + 1)]
    steps = np.diff(log["steps"], prepend=0)  # the log has sums since the beginning
    assert np.allclose(steps, 4 * log["length"])
    assert straight.training.matches == 4 * EPOCHS


def test_training_matches_are_those_of_the_log(tmp_path):
    played = []

    def play(config, pursuers, evaders, matches, **options):
        played.append((config.max_steps, pursuers, evaders, matches, options["episodes"]))
        return rollout(config, pursuers, evaders, matches, **options)

    # Two, so that worlds and matches are told apart.
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
    settings, archive, payoff = straight.settings, straight.files.archive(), straight.files.payoff()
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
    with pytest.raises(IndexError):
        saved.record(0, 3)


def test_the_files_hold_means_and_deviations_and_what_was_played(straight):
    arrays = load_arrays(straight.files.path / "payoff.npz")
    payoff = straight.files.payoff()
    assert np.allclose(arrays["capture_rate"], payoff.capture_rates.mean(axis=2))
    assert np.allclose(arrays["capture_rate_std"], payoff.capture_rates.std(axis=2), atol=1e-6)
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
    for kind, settings in ((Race, hall_of_fame()), (HallOfFameRace, tiny_race())):
        with pytest.raises(ValueError, match="^schedule: expected"):
            kind(settings, tmp_path / "run")
    with pytest.raises(TypeError):
        start({}, tmp_path / "run")
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


# Opponent samplers, archives and fitness sharing:


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
    shared = shared_fitness(payoff - 0.2, payoff, None)
    assert shared == pytest.approx([0.5 - 0.2, 1.5 - 0.2, 0.0 - 0.2])
    # Wins 1, 1.5 and 0: shares 2/3, 1 and 0 of the best; v = 3/4.
    eased = shared_fitness(payoff, payoff, 0.75)
    assert eased == pytest.approx([1 - (1 / 9) ** 2, 1 - (1 / 3) ** 2, 0.0])
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


# Simultaneous co-evolution with halls of fame:


@pytest.mark.parametrize("groups", [1, 3, 6])
def test_all_individuals_have_the_same_number_of_opponents(groups):
    pairs = pairings(np.tile(np.arange(groups), 6 // groups), 3, (1, 2), np.random.default_rng(0))
    assert len(pairs.pursuer) == len(pairs.evader) == len(pairs.group) == 6 * (3 + 1 + 2)
    for individual in range(6):
        opponents = pairs.evader[pairs.pursuer == individual]
        assert sorted(opponents[opponents >= 6]) == [6, 7]
        assert (opponents < 6).sum() == 3
        opponents = pairs.pursuer[pairs.evader == individual]
        assert sorted(opponents[opponents >= 6]) == [6]
        assert (opponents < 6).sum() == 3
    assert not ((pairs.pursuer >= 6) & (pairs.evader >= 6)).any()
    # Each round of opponents has its own seeds: one for each group of individuals.
    assert np.array_equal(np.unique(pairs.group), np.arange(6 * groups))


def test_mirrored_individuals_meet_the_same_opponents_on_the_same_seeds():
    mirrored = np.tile(np.arange(4), 2)  # 0 and 4 are a pair, 1 and 5, ...
    pairs = pairings(mirrored, 4, (1, 1), np.random.default_rng(3))

    def met(individual):
        chosen = pairs.pursuer == individual
        return sorted(zip(pairs.evader[chosen], pairs.group[chosen], strict=True))

    for one in range(4):
        first, second = met(one), met(one + 4)
        assert [evader for evader, _ in first] == [evader for evader, _ in second]
        assert {group for _, group in first} == {group for _, group in second}
        living = [evader for evader, _ in first if evader < 8]
        # Whole pairs of evaders, too.
        assert sorted((evader + 4) % 8 for evader in living) == living


def test_individuals_of_one_group_meet_opponents_of_their_own():
    pairs = pairings(np.zeros(6, dtype=int), 3, (0, 0), np.random.default_rng(0))
    rounds = pairs.evader.reshape(3, 6) - pairs.pursuer.reshape(3, 6)
    # Permutations, not rotations: in each round the distances differ.
    assert all(len(set(each % 6)) > 1 for each in rounds)


def test_matches_as_a_table_of_individuals():
    own, opponents = np.array([0, 1, 1, 3, 0, 0]), np.array([1, 0, 2, 1, 1, 3])
    values = np.array([1.0, 2.0, 4.0, 9.0, 5.0, 7.0])
    table = table_of_individuals(own, opponents, 2, values)
    assert np.array_equal(
        table, [[np.nan, 3.0, np.nan, 7.0], [2.0, np.nan, 4.0, np.nan]], equal_nan=True
    )


def test_race(tmp_path):
    race = coevolution.start(hall_of_fame(), tmp_path / "run")
    assert isinstance(race, HallOfFameRace)
    payoff = race.run()
    assert payoff.capture_rate.shape == (4, 4)
    archive = race.files.archive()
    assert archive["pursuer"].shape == archive["evader"].shape == (4, race.network.genome_size)
    log = race.files.log()
    assert log["team"].tolist() == ["pursuer", "evader"] * 6
    assert log["generation"].tolist() == [1] * 4 + [2] * 4 + [3] * 4
    per_epoch = [4 * (2 + 2 * hall) for hall in (1, 2, 2) for _ in range(2)]
    assert log["matches"][::2].tolist() == np.cumsum(per_epoch).tolist()


# ---- Learners that leave the range of float32: refused before the archive ----


ES: dict[str, Any] = {"learner": "es", "learning_rate": 1e39}
RUNS = {
    "es": (tiny_race(**ES), "learning_rate"),
    "momentum": (tiny_race(**ES, momentum=0.9), "learning_rate"),
    "later": (tiny_race(learner="es", learning_rate=1e38, generations=9), "learning_rate"),
    "hall of fame": (hall_of_fame(**ES), "learning_rate"),
    "one team": (tiny_single(**ES), "learning_rate"),
    "noise": (tiny_race(learner="es", sigma=1e300), "sigma"),
    "ga": (tiny_race(learner="ga", mutation=2e38), "mutation"),
}
ACTOR_CRITIC: list[dict[str, Any]] = [{"actor_rate": 1e30}, {"critic_rate": 1e30}]


def check_diverges(settings: Any, lower: str, directory: Any) -> None:
    run = start(settings, directory, threads=1)
    kind, value = settings.learner.kind, getattr(settings.learner, lower)
    with pytest.raises(DivergedError, match=f"^learner {kind}: .*lower ") as caught:
        run.run()
    assert f"learner.{lower} (now {value:g})" in str(caught.value)
    left = resume(directory, threads=1)
    for team in TEAMS:
        assert np.isfinite(left.genomes(team)).all()
    assert 0 <= left.stage < left.n_stages
    assert open_run(directory).teams["pursuer"].genomes.shape[0] >= 1
    with pytest.raises(DivergedError):
        left.run()


@pytest.mark.parametrize("kind", RUNS)
def test_the_run_stays_readable_to_its_last_good_generation(kind, tmp_path):
    check_diverges(*RUNS[kind], tmp_path / "run")


def test_the_learner_of_the_evaders_is_named_where_it_diverges(tmp_path):
    settings = tiny_race(evader_learner={"kind": "ga", "mutation": 2e38, "population": 4})
    with pytest.raises(DivergedError, match="^evader_learner ga: .*lower evader_learner.mutation"):
        start(settings, tmp_path / "run").run()


@pytest.mark.parametrize("changes", ACTOR_CRITIC, ids=str)
def test_actor_critic(changes, tmp_path):
    pytest.importorskip("torch")
    [(name, _)] = changes.items()
    settings = tiny_race(learner="actor-critic", population=2, generations=3, **changes)
    check_diverges(settings, name, tmp_path / "run")
