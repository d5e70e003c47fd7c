"""Kinds of races: whom teams meet and on which seeds, champions, and one team alone."""

import numpy as np
import pytest

from matrixworld import Matches, Population, rollout
from matrixworld.analysis import interval_over_runs
from matrixworld.analysis.games import nash_averaging
from matrixworld.coevolution import TEAMS, Run, available, evolve, open_run
from matrixworld.coevolution.games.game import Scores
from matrixworld.coevolution.runs.stored import last_generation
from matrixworld.coevolution.seeding import Phase, training_seeds
from matrixworld.coevolution.training.loops import pairings
from matrixworld.coevolution.training.training import Training
from matrixworld.coevolution.types import other
from matrixworld.world.policy import Network
from tiny_race import (
    Listening,
    StopAt,
    alternating,
    begun,
    hall_of_fame,
    played,
    results,
    tiny_race,
    tiny_single,
)


def test_training_matches_are_those_of_the_log(tmp_path):
    listening = Listening()
    # Two, so that worlds and matches are told apart.
    run = played(tiny_race(match_episodes=2), tmp_path / "run", play=listening)
    archive, log = run.archive(), run.log()
    rows = zip(log["generation"], log["team"], log["opponent"], listening.calls, strict=False)
    for generation, team, opponent, call in rows:
        config, pursuers, evaders, matches, scores = call
        learning, still = (pursuers, evaders) if team == "pursuer" else (evaders, pursuers)
        assert (config.max_steps, scores.length.shape[1], learning.genomes.shape[0]) == (8, 2, 4)
        met = matches.evader if team == "pursuer" else matches.pursuer
        assert set(met.tolist()) == {opponent}
        assert np.array_equal(still.genomes, archive[other(team)][: len(still.genomes)])
        assert len(still.genomes) == available(team, generation)
        assert np.array_equal(matches.seed[:2], matches.seed[2:])  # mirrored pairs
    seeds = [[seed for *_, m, _ in calls for seed in set(m.seed)] for calls in (
        listening.calls[:10], listening.calls[10:]
    )]  # fmt: skip
    assert len(set(seeds[0] + seeds[1])) == 2 * 10 + 9
    assert len(listening.calls) == 10 + 3  # the evaluation plays a row at a time


def test_candidates_play_against_every_sampled_opponent(tmp_path):
    settings = alternating("round-robin", opponents=3, learner="ga", match_episodes=2)
    listening = Listening()
    run = played(settings, tmp_path / "run", play=listening)
    # The last epoch of the last generation's evaders, before the evaluation of 5 rows.
    _, pursuers, _, matches, _ = listening.calls[-6]
    assert np.array_equal(pursuers.genomes, run.archive()["pursuer"])
    epoch = settings.schedule.evader_epochs - 1
    met = [(3 * epoch + turn) % 5 for turn in range(3)]
    assert matches.pursuer.tolist() == met * 4
    assert matches.evader.tolist() == [candidate for candidate in range(4) for _ in met]
    for turn, g in enumerate(met):
        seeds = training_seeds(settings.seed, g, 4, Phase.EVADERS_LEARN, epoch, 1)
        assert set(matches.seed[turn::3].tolist()) == set(seeds.tolist())


def test_each_team_can_have_a_learner_of_its_own(tmp_path):
    usual, same, mixed = (
        played(tiny_race(**changes), tmp_path / name).archive()
        for name, changes in {
            "usual": {},
            "es": {"evader_learner": {"kind": "es", "population": 4}},
            "ga": {"evader_learner": {"kind": "ga", "population": 4}},
        }.items()
    )
    assert all(np.array_equal(same[team], usual[team]) for team in TEAMS)
    # The first pursuers have met the same untrained evaders; what these learned differs.
    assert np.array_equal(mixed["pursuer"][:2], usual["pursuer"][:2])
    equal = (mixed["evader"] == usual["evader"]).all(axis=1)
    assert equal.tolist() == [True, False, False]


@pytest.mark.parametrize("make", [alternating, hall_of_fame])
def test_sharing_changes_what_evolves(make, tmp_path):
    same = {"learner": "ga", "population": 8, "generations": 4}
    if make is alternating:
        same |= {"opponents": 4, "evader_epochs": 6}
    one, another = (
        played(make("uniform", **same, sharing=sharing), tmp_path / sharing).archive()["evader"]
        for sharing in ("none", "competitive")
    )
    assert not np.array_equal(one, another)


def test_psro_solves_the_game_of_the_matches_that_were_played(tmp_path):
    """All payoffs of the last generation, played again match by match; and their mixture."""
    settings = tiny_race(schedule="psro", generations=3).changed(
        {"schedule.pursuers_meet.episodes": 2, "schedule.evaders_meet.episodes": 2}
    )
    played(settings, tmp_path / "run")
    training = Run(tmp_path / "run").training
    policies = settings.evaluation_game.policies
    pursuers, evaders = (Population(training.genomes(team), policies[team]) for team in TEAMS)
    for team, shape in (("pursuer", (3, 3)), ("evader", (3, 4))):
        state = training.memories[team]
        expected = np.zeros(shape)
        for own, opponent in np.ndindex(shape):
            g, h = (own, opponent) if team == "pursuer" else (opponent, own)
            seeds = training_seeds(settings.seed, g, h, Phase.ARCHIVE, 0, 2)
            scores = rollout(
                settings.training_game.world, pursuers, evaders, Matches.of(g, h, seeds)
            )
            caught = float(scores.capture_rate.mean(dtype=float))
            expected[own, opponent] = caught if team == "pursuer" else 1 - caught
        np.testing.assert_allclose(state["payoffs"], expected, atol=1e-7)
        mixture = nash_averaging(state["payoffs"]).evaders  # of the opponents, as columns
        np.testing.assert_allclose(state["weights"], mixture, atol=1e-6)


@pytest.fixture
def crowned(monkeypatch):
    """Of each champion: among whom it was chosen, and by which matches."""
    seen = []
    champion = Training.champion

    def watched(self, team, generation, candidates, played):
        chosen = champion(self, team, generation, candidates, played)
        genome = self.learners[team].genome(self.states[team])
        best = candidates[np.argsort(-played.fitness, kind="stable")[:2]]
        seen.append((team, generation, [genome, *best], played.opponents, played.met, chosen))
        return chosen

    monkeypatch.setattr(Training, "champion", watched)
    return seen


@pytest.mark.parametrize(
    "settings",
    [
        alternating(learner="es", retest_episodes=2, learning_rate=0.5, train_steps=20),
        alternating(learner="ga", retest_episodes=2, population=8, train_steps=20),
        hall_of_fame(learner="ga", retest_episodes=2, population=8, train_steps=20),
        tiny_single(learner="ga", retest_episodes=3, population=8, train_steps=20, team="evader"),
    ],
    ids=["es", "ga", "hall-of-fame", "single"],
)
def test_champions_are_the_best_of_new_matches(settings, tmp_path, crowned):
    """The mean fitness of the learner's genome and of the fittest two, match by match."""
    run = begun(settings, tmp_path / "run", threads=1)
    run.run()
    number = []
    for team, generation, genomes, opponents, met, chosen in crowned:
        episodes, means = settings.retest_episodes, []
        key = (settings.seed, generation, generation, Phase.RETEST, TEAMS.index(team))
        seeds = training_seeds(*key, len(met) * episodes).reshape(len(met), episodes)
        for genome in genomes:
            own, values = (
                Population(genome[np.newaxis], settings.evaluation_game.policies[team]),
                [],
            )
            for opponent, e in np.ndindex(seeds.shape):
                rival = 0 if isinstance(opponents, str) else met[opponent]
                sides, pair = (own, opponents), (0, rival)
                if team == "evader":
                    sides, pair = sides[::-1], pair[::-1]
                match = Matches.of(*pair, seeds[opponent, e])
                scores = rollout(settings.training_game.world, *sides, match)
                game, measure = settings.training_game, settings.learner.measure
                found = Scores(scores.capture_rate, vars(scores))
                values.append(game.values(found, team, measure).mean())
            means.append(np.mean(values))
        number.append(int(np.argmax(means)))
        assert np.array_equal(chosen, genomes[number[-1]])
        assert np.array_equal(run.training.archive[team][generation], chosen)
    of_a_stage = 2 if settings.schedule.kind == "hall-of-fame" else 1
    assert len(number) == of_a_stage * settings.schedule.n_stages
    assert len(set(number)) > 1  # not always the learner's own


@pytest.mark.parametrize("groups", [1, 3, 6])
def test_all_individuals_have_the_same_number_of_opponents(groups):
    group = np.tile(np.arange(groups), 6 // groups)
    pursuers, evaders, seeds = pairings(group, 3, (1, 2), np.random.default_rng(0))
    assert len(pursuers) == len(evaders) == len(seeds) == 6 * (3 + 1 + 2)
    for own, rivals, older in ((pursuers, evaders, [6, 7]), (evaders, pursuers, [6])):
        for individual in range(6):
            opponents = rivals[own == individual]
            assert sorted(opponents[opponents >= 6]) == older
            assert (opponents < 6).sum() == 3
    assert not ((pursuers >= 6) & (evaders >= 6)).any()
    # Each round of opponents has its own seeds: one for each group of individuals.
    assert np.array_equal(np.unique(seeds), np.arange(6 * groups))


@pytest.mark.parametrize(("team", "against"), [("pursuer", "fleer"), ("evader", "random")])
def test_against_scripts(team, against, tmp_path):
    saved = played(tiny_single(team=team, opponent=against), tmp_path / "run")
    payoff, archive, log, summary = saved.payoff(), saved.archive(), saved.log(), saved.summary()
    assert payoff.scores.shape == (1, 1, 3)
    assert (len(archive[team]), len(archive[other(team)])) == (4, 0)
    assert set(log["team"]) == {team}
    assert log["epoch"].tolist() == [0, 1, 2, 3, 4]
    assert saved.teams[other(team)] == against
    assert saved.record(episode=2).length == payoff.extras["lengths"][0, 0, 2]
    assert summary["length"] == payoff.extras["lengths"].mean()
    assert summary["length_high"] is None or summary["length_high"] <= 12
    interval = interval_over_runs(payoff.scores.ravel(), bounds=(0, 1))
    ends = [summary["capture_rate_low"], summary["capture_rate_high"]]
    assert ends == pytest.approx([interval.low, interval.high])


@pytest.fixture
def other_run(tmp_path):
    """A race with another network than that of the single runs."""
    return played(tiny_race(hidden=(3, 2), activation="tanh"), tmp_path / "race")


@pytest.mark.parametrize("team", TEAMS)
def test_against_a_run(team, other_run, tmp_path):
    settings = tiny_single(team=team, opponent=str(other_run.path))
    rivals = other_run.teams[other(team)]
    with pytest.raises(KeyboardInterrupt):
        played(settings, tmp_path / "run", play=StopAt(4))
    played(settings, tmp_path / "straight")
    for path in other_run.path.iterdir():  # a run is complete in itself
        path.unlink()
    saved = played(settings, tmp_path / "run")
    assert results(tmp_path / "run") == results(tmp_path / "straight")
    assert np.array_equal(saved.teams[other(team)].genomes, rivals.genomes[-1:])
    assert saved.teams[other(team)].policy == rivals.policy
    assert saved.teams[team].policy == settings.evaluation_game.policies[team]
    lengths = saved.payoff().extras["lengths"]
    assert [saved.record(episode=number).length for number in range(3)] == list(lengths.flat)


def test_several_opponents_take_turns(tmp_path):
    settings = tiny_single(team="evader")
    policy = settings.evaluation_game.policies["pursuer"]
    opponents = Population(settings.task("pursuer").genomes(2), policy)
    saved = begun(settings, tmp_path / "run", opponents=opponents).run()
    assert saved.log()["opponent"].tolist() == [0, 1, 0, 1, 0]
    assert saved.payoff().scores.shape == (2, 1, 3)
    again = open_run(tmp_path / "run").settings
    assert again.schedule.opponent == "given as genomes"
    before = results(tmp_path / "run")
    assert evolve(again, tmp_path / "run", threads=1).settings == again  # the text is no path
    assert results(tmp_path / "run") == before
    with pytest.raises(ValueError, match="expected a run directory, got 'given as genomes'"):
        evolve(again, tmp_path / "without them")


@pytest.mark.parametrize("learner", ["es", "ga", "actor-critic"])
def test_warm_start(learner, tmp_path):
    if learner == "actor-critic":
        pytest.importorskip("torch")
    first = played(tiny_single(team="evader"), tmp_path / "first")
    champion = last_generation(tmp_path / "first", "evader").genomes[0]
    assert np.array_equal(champion, first.archive()["evader"][-1])
    changes = {"team": "evader", "learner": learner}
    if learner == "ga":
        changes["elites"] = 0  # elites may outlive the run
    second = played(tiny_single(**changes, start=str(tmp_path / "first")), tmp_path / "second")
    third = begun(tiny_single(**changes), tmp_path / "third", start=champion).run()
    genomes = second.archive()["evader"]
    assert np.array_equal(genomes, third.archive()["evader"])
    assert np.array_equal(genomes[0], champion)
    assert not np.array_equal(genomes[-1], champion)


@pytest.mark.parametrize("argument", ["opponents", "start"])
def test_a_race_takes_no_opponents_and_no_start(argument, tmp_path):
    with pytest.raises(ValueError, match="expected None in a race"):
        begun(tiny_race(), tmp_path / "run", **{argument: np.zeros(3)})
    assert not (tmp_path / "run").exists()


def test_bad_opponents_and_starts_are_refused(other_run, tmp_path):
    settings, run = tiny_single(), tmp_path / "run"
    wide = Network(hidden=(4,), fov=5)
    others = Population(np.zeros((1, wide.genome_size), dtype=np.float32), wide)
    with pytest.raises(ValueError, match="^opponents: "):
        begun(settings, run, opponents=others)
    size = settings.evaluation_game.policies["pursuer"].genome_size
    for start, message in (
        (np.zeros(size - 1), rf"genome of shape \({size},\), got \({size - 1},\)"),
        (np.full(size, np.nan), "finite genes, got nan"),
    ):
        with pytest.raises(ValueError, match=f"^start: expected (a )?{message}$"):
            begun(settings, run, start=start)
    with pytest.raises(ValueError, match="^start: "):  # a genome of another network
        begun(tiny_single(start=str(other_run.path)), run)
    assert not run.exists()
    played(settings, run)
    with pytest.raises(ValueError, match="genomes of evaders"):
        last_generation(run, "evader")
