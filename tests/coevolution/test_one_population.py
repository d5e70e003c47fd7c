"""Symmetric games, played by one population, and games with the scores of both teams."""

import json
import re
from dataclasses import replace

import numpy as np
import pytest
from PIL import Image

import matrixworld as mw
from command_line import matrixworld_command, run_together
from matrixworld import analysis
from matrixworld import coevolution as co
from matrixworld.coevolution.games.game import Scores
from matrixworld.coevolution.training.loops import pairings_within
from one_population import close, coins, dilemma, fists, ladder, larger, meeting, prisoners
from tiny_race import results, stopped, straight

TINY = {"learner.population": 6, "schedule.generations": 4, "seed": 3}
HALL = {**TINY, "schedule": "hall-of-fame", "schedule.joint_epochs": 3, "schedule.hall_sample": 2}
OF_ITSELF = {
    **TINY, "schedule": "self-play", "schedule.self_play_epochs": 3, "schedule.opponents": 2,
    "schedule.meet": "prioritized",
}  # fmt: skip
IN_TURNS = {
    **TINY, "schedule": "alternating", "schedule.pursuer_epochs": 2, "schedule.evader_epochs": 2,
    "schedule.pursuers_meet": "prioritized", "retest_episodes": 2,
}  # fmt: skip
GAMES = {"prisoners": prisoners, "ladder": ladder, "coins": coins, "fists": fists}
LEARNERS = {"prisoners": ("breeding",), "coins": ("ga", "es", "cma")}


def race(game, of, **changes):
    return co.RaceSettings.of({"game": game, **of, **changes})


@pytest.mark.parametrize("of", [HALL, OF_ITSELF], ids=["hall", "self-play"])
@pytest.mark.parametrize("name", GAMES)
def test_one_population_races_and_resumes_bit_for_bit(name, of, tmp_path):
    for learner in LEARNERS.get(name, ("ga",)):
        settings = race(GAMES[name], of, learner=learner)
        stopped(settings, tmp_path / learner)
        run = co.finish(tmp_path / learner)
        assert results(run.path) == straight(settings)
        [key] = run.archive()
        assert [*run.teams] == [key] == [*dict.fromkeys(settings.teams)]
        assert {*run.log()["team"]} == {key}
        assert len(run.genomes(key)) == 5
        first, second = run.sides
        assert first is second
        files = {path.name for path in run.path.iterdir()}
        assert {f"{key}.json", f"{key}.npy"} & files


def test_half_of_the_tournament_is_played_and_the_rest_is_its_other_side(tmp_path):
    run = co.evolve(race(coins, HALL), tmp_path / "coins")
    matrix = run.payoff().matrix
    np.testing.assert_allclose(matrix + matrix.T, 1.0, atol=1e-6)
    np.testing.assert_array_equal(np.diag(matrix), 0.5)
    # A pair that is played has the score of its seed.
    genomes = coins.population("pursuer", run.archive()["climbers"])
    seed = np.array([co.seeding.evaluation_seed(3, 1, 3)], np.uint64)
    played = coins.rollout(genomes, genomes, ([1], [3], seed), episodes=10, threads=1)
    np.testing.assert_array_equal(run.payoff().scores[1, 3], played.scores[0])
    both = co.evolve(race(prisoners, HALL), tmp_path / "prisoners").payoff()
    np.testing.assert_allclose(both.others.mean(axis=2), both.matrix.T, atol=1e-6)
    assert (both.matrix + both.others.mean(axis=2)).max() > 1.05  # no constant sum
    # A tournament of two different runs has no other half.
    other = co.evolve(race(coins, HALL, seed=4), tmp_path / "other")
    met = co.tournament(coins, run.sides[0], other.sides[0], seed=0, episodes=4)
    assert met.matrix.shape == (5, 5)
    assert not np.array_equal(np.diag(met.matrix), np.full(5, 0.5))


def test_a_race_of_one_population_can_become_longer(tmp_path):
    for name, of in (("ladder", HALL), ("prisoners", OF_ITSELF)):
        short = race(GAMES[name], {**of, "schedule.generations": 2})
        run = co.evolve(short, tmp_path / name).extend(4)
        assert results(run.path) == straight(race(GAMES[name], of))


@pytest.mark.parametrize("groups", [np.zeros(7, int), np.repeat(np.arange(4), 2), np.arange(5)])
@pytest.mark.parametrize("contemporaries", [0, 1, 2, 3])
def test_individuals_meet_others_and_never_themselves(groups, contemporaries):
    n = len(groups)
    for seed in range(5):
        first, second, seeds = pairings_within(
            groups, contemporaries, 2, np.random.default_rng(seed)
        )
        living = second < n
        assert (first != second).all()
        assert (first < n).all()
        # As often on either side, and once against each member of the hall.
        for side in (first[living], second[living]):
            np.testing.assert_array_equal(np.bincount(side, minlength=n), contemporaries)
        assert sorted(zip(first[~living], second[~living], strict=True)) == [
            (i, n + member) for i in range(n) for member in (0, 1)
        ]
        # Members of a group, such as a mirrored pair, have the same seeds.
        for group in {*groups}:
            members = [sorted(seeds[first == i]) for i in np.flatnonzero(groups == group)]
            assert all(each == members[0] for each in members) or len({*groups}) == 1


def test_matches_from_both_sides():
    scores = Scores(np.array([[0.2]]), {"moves": np.array([[7]])}, np.array([[0.9]]))
    both = scores.from_both_sides()
    np.testing.assert_allclose(both.of("pursuer"), [[0.2], [0.9]])
    np.testing.assert_allclose(both.of("evader"), [[0.9], [0.2]])
    assert both.extras["moves"].tolist() == [[7], [7]]


# Scores of both teams:


@pytest.mark.parametrize("of", [HALL, IN_TURNS], ids=["hall", "turns"])
@pytest.mark.parametrize("learner", ["ga", "es"])
def test_scores_of_both_teams_resume_bit_for_bit(of, learner, tmp_path):
    settings = race(meeting, of, learner=learner)
    stopped(settings, tmp_path / "run")
    run = co.finish(tmp_path / "run")
    assert results(run.path) == straight(settings)
    guests, hosts = run.archive().values()
    pairs = np.indices((5, 5)).reshape(2, -1)
    expected, told = close(guests[pairs[0]], hosts[pairs[1]], None)
    payoff = run.payoff()
    np.testing.assert_allclose(payoff.matrix.ravel(), expected[:, 0], atol=1e-6)
    np.testing.assert_allclose(payoff.others.ravel(), expected[:, 1], atol=1e-6)
    np.testing.assert_allclose(payoff.extras["distance"].ravel(), told["distance"], rtol=1e-6)
    log = run.log()
    assert [*log][-4:] == ["score", "other_score", "distance", "matches"]
    np.testing.assert_allclose(log["other_score"], 0.5 * log["score"], rtol=1e-5)
    # Each team is selected by its own score: both want to be close.
    assert payoff.matrix[-1, -1] > payoff.matrix[0, 0]


def test_what_has_no_meaning_is_refused_by_name(tmp_path):
    with pytest.raises(
        ValueError, match="^schedule: expected no Nash mixtures in a game with the sc"
    ):
        race(meeting, {**TINY, "schedule": "psro", "learner": "ga"})
    with pytest.raises(
        ValueError, match="^schedule: expected hall-of-fame or self-play in a game of"
    ):
        race(ladder, {**IN_TURNS, "learner": "ga"})
    with pytest.raises(ValueError, match="^schedule: expected a race of two teams in pursuit"):
        co.RaceSettings.of(schedule="self-play")
    with pytest.raises(ValueError, match="^schedule: expected a schedule of two teams"):
        race(meeting, {**OF_ITSELF, "learner": "ga"})
    with pytest.raises(ValueError, match="^schedule.evaders_meet: expected no value"):
        race(ladder, {**HALL, "learner": "ga", "schedule.evaders_meet": "latest"})
    both = co.evolve(race(meeting, HALL, learner="ga"), tmp_path / "both").payoff()
    one = co.evolve(race(ladder, HALL, learner="ga"), tmp_path / "one").payoff()
    for name in ("game_value", "pursuer_rating", "squared_intransitivity", "one_sidedness"):
        with pytest.raises(ValueError, match=f"^{name}: expected a game in which one team wins"):
            analysis.MEASURES[name].of(both)
        assert name not in analysis.measure_all(both)
    for name in ("evader_gain", "one_sidedness"):
        with pytest.raises(ValueError, match=f"^{name}: expected a game of two teams"):
            analysis.MEASURES[name].of(one)
    with pytest.raises(ValueError, match="^joint_change: expected the scores of both teams"):
        analysis.MEASURES["joint_change"].of(one)


# What is judged:


def test_each_team_is_judged_by_its_own_scores():
    """Both gain against all opponents, while the mean of both falls, as in a dilemma."""
    k = 16
    own = np.linspace(0.0, 0.4, k)  # taking more
    scores = np.empty((k, k, 8))
    others = np.empty((k, k, 8))
    rng = np.random.default_rng(0)
    noise = rng.normal(0.0, 0.01, (2, k, k, 8))
    scores[:] = (0.4 + 0.5 * own[:, np.newaxis] - own)[..., np.newaxis] + noise[0]
    others[:] = (0.4 + 0.5 * own - own[:, np.newaxis])[..., np.newaxis] + noise[1]
    payoffs = analysis.read_payoffs(
        np.clip(scores, 0, 1), per_episode=True, others=np.clip(others, 0, 1),
        teams=("rows", "columns"),
    )  # fmt: skip
    judgement = analysis.judge(payoffs)
    findings = judgement.findings
    assert findings["joint fall"].verdict == "present"
    assert findings["joint rise"].verdict == "absent"
    assert findings["progress"].teams == findings["rise"].teams == ("pursuers", "evaders")
    expected = "The mean of both sides fell by 0.20 against contemporaries and both teams improved."
    assert analysis.sentence(judgement) == expected
    for name in ("arms race", "one-sided progress", "disengagement", "intransitivity"):
        assert name not in findings
        assert f"{name.capitalize()}: not judged, because what one team wins is not what" in (
            analysis.explain(judgement)
        )
    # From the first team's scores alone the second would have lost.
    alone = analysis.MEASURES["evader_change"].of(
        analysis.read_payoffs(scores.clip(0, 1), per_episode=True), "whole"
    )
    own_change = analysis.MEASURES["evader_change"].of(payoffs, "whole")
    assert alone.value == pytest.approx(0.4, abs=0.02)
    assert own_change.value == pytest.approx(0.2, abs=0.02)
    swapped = analysis.read_payoffs(
        others.clip(0, 1).swapaxes(0, 1), per_episode=True, others=scores.clip(0, 1).swapaxes(0, 1)
    )
    one, other = analysis.measure_all(payoffs), analysis.measure_all(swapped)
    assert one["pursuer_gain"].value == pytest.approx(other["evader_gain"].value)
    assert one["joint_change"].value == pytest.approx(other["joint_change"].value)


def test_one_population_is_judged_as_one(tmp_path):
    run = mw.evolve(
        game=ladder, out=tmp_path / "run", schedule="hall-of-fame", learner="ga", generations=12,
        joint_epochs=4, population=12,
    )  # fmt: skip
    judgement = run.judge()
    assert analysis.sentence(judgement) == "The climbers improved."
    assert (
        judgement.refused["arms race"].in_words(judgement.teams).startswith("one population has no")
    )
    told = run_together(matrixworld_command("judge", run.path, "--explain").stdout)
    assert "Arms race: not judged, because one population has no other one to race with." in told
    said = run_together(matrixworld_command("judge", run.path).stdout)
    assert "1 run, 13 generations of climbers, all episodes equal" in said
    assert not re.search("both|evader|pursuer", said.partition("what to do next")[0])
    assert str(run.payoff()).startswith("Scores of climbers (rows) against each other")


# The game itself:


@pytest.mark.parametrize("name", [*GAMES, "meeting"])
def test_games_that_keep_all_promises(name):
    mw.check_game({**GAMES, "meeting": meeting}[name], matches=12)


def first_wins(a, b, rng):
    return np.clip(larger(a, b, rng) + 0.1, 0, 1)


def first_wins_often(one, other, rng):
    return 1.0 * (rng.random(len(one)) < 0.8)


@pytest.mark.parametrize(
    ("fields", "message"),
    [
        ({"play": first_wins, "deterministic": True}, "play: expected a symmetric game, in which"),
        ({"play": first_wins_often}, "play: expected a symmetric game, in which both sides have"),
        ({"scores": "both", "play": larger}, r"scores of the game: expected shape \(1, 2\), got"),
        ({"extras": ("moves",)}, "play: expected scores, and a dict of moves, got"),
        (
            {"extras": ("moves",), "play": lambda a, b, rng: (larger(a, b, rng), {"steps": [1]})},
            "play: expected scores, and a dict of moves, got",
        ),
        (
            {
                "extras": ("moves",),
                "play": lambda a, b, rng: (larger(a, b, rng), {"moves": [np.nan]}),
            },
            "moves: expected finite numbers, got nan",
        ),
    ],
)
def test_a_broken_promise_is_named(fields, message):
    game = mw.Game(**{"play": larger, "genes": 2, "teams": ("ones",), "symmetric": True, **fields})
    with pytest.raises(ValueError, match=message):
        mw.check_game(game)


@pytest.mark.parametrize(
    ("fields", "message"),
    [
        ({"teams": ("ones", "others")}, "teams: expected one word in a symmetric game, got"),
        ({"genes": (2, 3)}, "genes: expected one number in a symmetric game, got"),
        ({"initial": (larger, larger)}, "initial: expected one function in a symmetric game"),
        ({"scores": "all"}, "scores: expected one of one, both, got"),
        ({"extras": ("score",)}, "extras: expected words other than scores"),
        ({"symmetric": 1}, "symmetric: expected True or False, got 1"),
    ],
)
def test_what_is_no_game_is_refused(fields, message):
    with pytest.raises((TypeError, ValueError), match=f"^{message}"):
        mw.Game(**{"play": larger, "genes": 2, "teams": ("ones",), "symmetric": True, **fields})


def film(a, b):
    return [np.full((4, 6, 3), 40 * n, np.uint8) for n in range(3)]


def test_a_film_is_a_gif(tmp_path):
    filmed = mw.Game(larger, 2, ("ones", "others"), deterministic=True, show=film)
    shown = filmed.shown(np.zeros(2), np.ones(2))
    (tmp_path / "film.gif").write_bytes(shown.content)
    with Image.open(tmp_path / "film.gif") as image:
        assert (shown.suffix, image.n_frames, image.size) == (".gif", 3, (6, 4))
    wrong = mw.Game(
        larger, 2, ("ones", "others"), deterministic=True,
        show=lambda a, b: [np.zeros((2, 2, 3), np.uint8), np.zeros((3, 2, 3), np.uint8)],
    )  # fmt: skip
    with pytest.raises(ValueError, match="show: expected frames of one size, got"):
        wrong.shown(np.zeros(2), np.ones(2))


def test_texts_are_shown_where_a_game_shows_nothing_else():
    shown = prisoners.shown(np.array(['"CCDDC"']), np.array(['"DDDDD"']))
    assert shown == 'prisoners: "CCDDC"\nprisoners: "DDDDD"'
    scores = dilemma("DDDDD", "CCCCC", np.random.default_rng(0))
    assert scores[0] > 0.75 > 0.25 > scores[1]
    assert json.loads(json.dumps(scores)) == list(scores)


def test_all_that_is_told_of_a_race_of_one_population_was_played(tmp_path):
    def play(a, b, rng):
        return larger(a, b, rng), {"moves": np.full(len(a), 10.0)}

    told = mw.Game(play, 4, ("climbers",), deterministic=True, symmetric=True, extras=("moves",))
    members = told.population("pursuer", np.random.default_rng(0).random((4, 4), np.float32))
    payoff = co.tournament(told, members, members, seed=0, episodes=1)
    np.testing.assert_array_equal(payoff.extras["moves"], 10.0)
    [alone] = [replace(members, genomes=members.genomes[:1])]
    assert co.tournament(ladder, alone, alone, seed=0, episodes=1).matrix.tolist() == [[0.5]]
    run = co.evolve(race(ladder, HALL, learner="ga"), tmp_path / "run")
    assert run.summary()["evaluation_matches"] == 10  # of five generations
    # The log has the matches with the hall of fame: among contemporaries the mean is 1/2.
    assert run.log()["score"][-1] > 0.55
    judged = analysis.judge(analysis.read_payoffs(run.path / "payoff.npz"))
    assert judged.teams == ("climbers", "climbers")


def test_a_team_alone_has_its_own_score(tmp_path):
    rivals = co.evolve(race(meeting, HALL, learner="ga"), tmp_path / "race")
    alone = co.RaceSettings.of(
        {"game": meeting, "schedule": "against", "schedule.team": "evader", "schedule.epochs": 4},
        {"schedule.opponent": str(rivals.path), "schedule.archive_every": 2, "learner": "ga"},
    )
    run = co.evolve(alone, tmp_path / "alone")
    summary = run.summary()
    assert summary["other_score"] == pytest.approx(0.5 * summary["score"])
    told = matrixworld_command("evolve", "--resume", run.path).stdout
    assert f"{summary['other_score']:.3f}" in told
    assert str(run.explain("hosts")).startswith("Hosts of generation 2: ")
    with pytest.raises(ValueError, match="generation: expected a generation whose matches the run"):
        run.explain("hosts", 0)
