"""Held-out opponents, and the scores of runs and of any policy against them."""

import numpy as np
import pytest

import matrixworld as mw
from matrixworld.coevolution import TEAMS, create, held_out, open_run, score
from matrixworld.coevolution.evaluation import scores
from matrixworld.coevolution.evaluation.scores import best_scripts, knows, score_table
from matrixworld.coevolution.seeding import Phase, match_seed
from matrixworld.coevolution.types import other
from rows import config_of, random_team
from tiny_race import played, tiny_race, tiny_single

SCRIPTED = {
    "pursuer": ["random", "clumsy-chaser", "chaser", "hunter"],
    "evader": ["random", "still", "clumsy-fleer", "fleer", "dodger"],
}
CAREFUL = ["careful-chaser", "careful-clumsy-chaser", "careful-hunter"]
SURROUNDING = ["surrounder", "careful-team-surrounder"]
EVOLVED = ["evolved-1", "evolved-2"]
SHIPPED = [variant for variant in mw.VARIANTS if "evolved-1" in held_out("pursuer", variant)]
"""The variants whose genomes come with the package."""
FITTING = {"fov": 11, "rows": 7, "cols": 7, "hidden": (2,)}


@pytest.fixture(scope="module")
def race(tmp_path_factory):
    """A race whose views are those of the evolved opponents."""
    path = tmp_path_factory.mktemp("races") / "race"
    return played(tiny_race(**FITTING), path).path


def test_the_nine_variants_of_the_paper_have_shipped_genomes_of_their_own():
    assert {"D", "R", "B", "O", "S", "SB", "SD", "SDB", "TO"} <= set(SHIPPED)
    sets = [held_out(team, variant) for team in TEAMS for variant in SHIPPED]
    assert len({each["evolved-1"].genomes.tobytes() for each in sets}) == 2 * len(SHIPPED)


@pytest.mark.parametrize("variant", ["O", "SB"])
@pytest.mark.parametrize("team", TEAMS)
def test_the_held_out_opponents_are_scripts_and_genomes(team, variant):
    opponents = held_out(team, variant)
    more = SURROUNDING if (variant, team) == ("SB", "pursuer") else []
    assert list(opponents) == [*SCRIPTED[team], *more, *EVOLVED]
    assert all(name == each for name, each in opponents.items() if name not in EVOLVED)


def test_scores_are_those_of_the_matches(race):
    run = open_run(race)
    scores = score(run, episodes=4, threads=1)
    assert list(scores) == ["pursuer", "evader"]
    for team, found in scores.items():
        against = held_out(other(team), "O")
        assert found.opponents == tuple(against)
        assert found.generations == (2,)
        assert found.rates.shape == (1, len(against), 4)
        assert found.matches == 4 * len(against)
        assert found.left_out == ""
        own = mw.Population(run.teams[team].genomes[2], run.settings.evaluation_game.policies[team])
        for number, opponent in enumerate(against.values()):
            sides = (own, opponent) if team == "pursuer" else (opponent, own)
            match = mw.Matches.of(0, 0, np.uint64(match_seed(0, TEAMS.index(team), number, 4)))
            played = mw.rollout(run.settings.game.world, *sides, match, episodes=4)
            captured = played.capture_rate[0].astype(float)
            expected = captured if team == "pursuer" else 1 - captured
            assert np.array_equal(found.rates[0, number], expected)
        mean, random = found.mean(), found.against("random")
        assert mean.value == pytest.approx(found.rates[0].mean()) == found.means[0]
        assert random.value == pytest.approx(found.rates[0, 0].mean())
        assert random.high - random.low > mean.high - mean.low


def test_all_generations_are_a_curve_of_single_ones(race):
    run = open_run(race)
    curve = score(run, generation=None, episodes=3)["evader"]
    assert curve.generations == (0, 1, 2)
    for generation in range(-3, 3):
        one = score(run, generation=generation, episodes=3)["evader"]
        assert np.array_equal(one.rates[0], curve.rates[generation])
        assert one.generations == (generation % 3,)
    head, *lines = score_table([one]).splitlines()
    assert head == "evaders of generation 2: escape rate"
    estimates = {**{name: one.against(name) for name in one.opponents}, "mean": one.mean()}
    assert [line.split(maxsplit=1) for line in lines] == [
        [name, str(each)] for name, each in estimates.items()
    ]


@pytest.mark.parametrize(
    ("settings", "opponents", "why"),
    [
        (tiny_race(), SCRIPTED["pursuer"], "no evolved opponents: they have a view of 11 x 11 "),
        (
            tiny_single(team="evader", opponent="chaser"),
            ["random", "clumsy-chaser", "hunter"],
            "not chaser: the run trained against it; no ",
        ),
    ],
)
def test_opponents_that_do_not_fit_are_left_out(settings, opponents, why, tmp_path):
    create(settings, tmp_path / "run")
    scores = score(open_run(tmp_path / "run"), episodes=2)
    assert list(scores) == [*settings.learning_teams]
    assert [*scores["evader"].opponents] == opponents
    assert scores["evader"].left_out.startswith(why)


@pytest.mark.parametrize("team", TEAMS)
@pytest.mark.parametrize("name", ["O", "swarm-D"])
def test_a_function_has_the_scores_of_the_genome_that_it_plays(name, team):
    config = config_of(name, obstacles=0.1, max_steps=12)
    team_of_one = random_team(config, 1, hidden=(6,), sampled=False)
    policy = mw.NetworkPolicy(team_of_one.policy, team_of_one.genomes[0], seed=0)
    calls = []

    def play(observations):
        calls.append(observations.shape)
        return policy(observations)

    scores = mw.score_policy(play, team, config, episodes=7, seed=3)
    expected = mw.score_policy(team_of_one, team, config, episodes=7, seed=3)
    assert np.array_equal(scores.rates, expected.rates)
    assert scores.opponents == expected.opponents
    assert scores.left_out == expected.left_out != ""
    # Never asked for nobody.
    assert all(shape[1:] == (3, 5, 5) and shape[0] >= 1 for shape in calls)


def test_the_best_generation_is_chosen_on_episodes_that_no_score_is_from(race, monkeypatch):
    monkeypatch.setattr(scores, "CHOICE", ((4, 1.0), (6, 0.5)))
    monkeypatch.setattr(scores, "LEAST_LEFT", 1)
    run = open_run(race)
    first = score(run, generation=None, episodes=4, seed=2**64 - 1)  # others have smaller seeds
    second = score(run, generation=None, episodes=6, seed=2**64 - 2)
    for team, each in first.items():
        n = len(each.means)
        half = np.sort(np.argsort(each.means, kind="stable")[-round(n / 2) :])
        means = (4 * each.means + 6 * second[team].means)[half]
        number = half[np.flatnonzero(np.isclose(means, means.max()))[-1]]
        np.testing.assert_array_equal(run.best(team).genome, run.teams[team].genomes[number])


def test_the_best_script_of_a_team_meets_what_a_run_meets():
    world = mw.WorldConfig("O", size=9, n_pursuers=2, n_evaders=3, max_steps=30)
    found, scores = best_scripts(world, episodes=6), {}
    for script in ("random", "clumsy-chaser", "chaser", "hunter", "careful-random", *CAREFUL):
        rates = []
        for number, opponent in enumerate(held_out("evader", "O").values()):
            seed = match_seed(0, 0, number, int(Phase.HELD_OUT))
            matches = mw.Matches.of(0, 0, np.array([seed], np.uint64))
            rates.append(mw.rollout(world, script, opponent, matches, episodes=6).capture_rate)
        scores[script] = float(np.mean(rates))
    best = max(scores, key=lambda script: scores[script])
    assert found["pursuer"] == (best, pytest.approx(scores[best]), len(scores))
    assert found["evader"][0].removeprefix("careful-") in ("fleer", "dodger")


def test_what_players_know_beyond_their_views():
    assert knows("chaser") == knows(mw.Network()) == ()
    assert knows("careful-team-surrounder") == ("right of way", "a plan of their team")
    ratings = mw.Rating(inputs=("adversary", "ahead", "must_yield"))
    assert knows(ratings) == ("a direction for 12 steps", "right of way")
    assert knows(mw.Rating(inputs=("adversary",), mask="right-of-way")) == ("right of way",)
    assert knows(mw.Network(hidden=(8,), memory="gru")) == ("their past",)


@pytest.mark.parametrize(
    ("bad", "kind", "message"),
    [
        (
            {"policy": 5},
            TypeError,
            "policy: expected the name of a script, .* or a function, got 5",
        ),
        ({"policy": "nobody"}, ValueError, "policy: expected one of random, "),
        ({"opponents": {"a": 5}}, TypeError, "opponents: expected the name of a script, "),
        ({"opponents": {}}, ValueError, "opponents: expected at least one, got none"),
    ],
)
def test_what_cannot_play_is_refused(bad, kind, message):
    arguments = {"policy": "chaser", "team": "pursuer", "config": "O", "episodes": 2}
    with pytest.raises(kind, match=message):
        mw.score_policy(**{**arguments, **bad})


def test_an_opponent_is_a_single_genome():
    world = mw.WorldConfig("O", rows=7, cols=7, n_pursuers=2, n_evaders=2, max_steps=5)
    one = random_team(world, 1, hidden=())
    two = mw.Population(np.repeat(one.genomes, 2, axis=0), one.policy)
    with pytest.raises(ValueError, match="opponents: expected a single genome, got 2"):
        mw.score_policy("chaser", "pursuer", world, opponents={"two": two}, episodes=2)
