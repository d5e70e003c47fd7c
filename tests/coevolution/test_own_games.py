"""Games of your own: kept promises, all learners and schedules, and runs that find their game."""

import importlib
import json
import linecache
import shutil
import sys
from dataclasses import replace

import numpy as np
import pytest

from matrixworld import coevolution as co
from matrixworld.coevolution.games.digest import digest_of
from own_games import chance, coins, fewer, higher, numbers
from scripts import python
from tiny_race import results, stopped, straight

IN_TURNS = {"schedule.generations": 4, "schedule.pursuer_epochs": 4, "schedule.evader_epochs": 4}
HALL = {"schedule": "hall-of-fame", "schedule.generations": 4, "schedule.joint_epochs": 4}
SAMPLED = {"schedule": "alternating", "schedule.opponents": 2, **IN_TURNS}
RACES = {
    "es": {"schedule": "generalist-generalist", **IN_TURNS, "learner.learning_rate": 0.3},
    "ga": {"schedule": "specialist-specialist", **IN_TURNS, "learner.mutation": 0.3},
    "cma": {"schedule": "psro", **IN_TURNS, "learner.sigma": 0.3, "match_episodes": 8},
    "hall": {**HALL, "learner": "ga", "learner.mutation": 0.3, "retest_episodes": 2},
    "sharing": {
        **HALL, "learner": "ga", "learner.mutation": 0.3, "learner.sharing": "competitive",
        "schedule.pursuers_meet": "shared-sampling", "schedule.hall_sample": 2,
    },
    "sampled": {
        **SAMPLED, "schedule.pursuers_meet": "prioritized",
        "schedule.evaders_meet": "newest-and-older",
        "learner": "ga", "learner.mutation": 0.3, "schedule.evader_learner": "es",
        "match_episodes": 2,
    },
}  # fmt: skip


def race(name="ga", game=coins, **changes):
    learner = {} if "learner" in RACES[name] else {"learner": name}
    population = {"learner.population": 8, "game": game, "seed": 3}
    return co.RaceSettings.of({**learner, **RACES[name], **population, **changes})


@pytest.mark.parametrize("name", RACES)
def test_all_learners_and_schedules_race_a_game_and_resume(name, tmp_path):
    settings, directory = race(name), tmp_path / "run"
    stopped(settings, directory, 3)
    run = co.finish(directory, threads=1)
    assert results(directory) == straight(settings)
    cats, mice = run.archive()["cats"], run.archive()["mice"]
    assert (cats.shape, mice.shape) == ((5, 3), (5, 2))
    for team in (cats, mice):
        assert np.abs(team[0]).max() < 0.2  # as the game says
        assert np.abs(team).max() <= 1.0
        assert team[-1].mean() > team[0].mean() + 0.1
    # Scores are those of the game: the coins of all pairs are independent.
    pairs = np.indices((5, 5)).reshape(2, -1)
    chances = chance(cats[pairs[0]], mice[pairs[1]])
    scores = run.payoff().scores.reshape(25, -1)
    error = np.sqrt(scores.shape[1] * (chances * (1 - chances)).sum())
    assert abs(scores.sum() - scores.shape[1] * chances.sum()) < 4 * error
    assert {*run.log()["team"]} == {"cats", "mice"}
    assert [*run.log()][-2:] == ["score", "matches"]


@pytest.mark.parametrize("team", ["pursuer", "evader"])
def test_a_team_alone_learns_against_the_last_generation_of_a_run(team, tmp_path):
    co.finish(co.create(race(), tmp_path / "race").path)
    alone = co.RaceSettings.of(
        {"game": coins, "schedule": "against", "schedule.team": team, "schedule.epochs": 12},
        {"schedule.opponent": str(tmp_path / "race"), "schedule.archive_every": 4},
        {"learner.population": 16},
    )
    run = co.finish(co.create(alone, tmp_path / "alone").path)
    opponents, own = ("mice", "cats") if team == "pursuer" else ("cats", "mice")
    archive, rival = run.archive(), co.open_run(tmp_path / "race").archive()[opponents][-1]
    np.testing.assert_array_equal(archive[opponents], [rival])
    assert archive[own].shape == (4, coins.genome_size(team))
    score = run.summary()["score"]
    expected = chance(*(archive[name][-1:] for name in ("cats", "mice")))[0]
    assert score == pytest.approx(expected, abs=4 * np.sqrt(0.25 / 200))
    other = co.RaceSettings.of({"schedule": "against", "schedule.opponent": str(tmp_path / "race")})
    with pytest.raises(ValueError, match="expected a run of pursuit, got one of own_games:coins"):
        co.create(other, tmp_path / "pursuit")


def test_a_pair_of_a_game_without_chance_is_played_once_and_is_exact(tmp_path):
    run = co.finish(co.create(race(game=numbers), tmp_path / "run").path)
    payoff, (hosts, parasites) = run.payoff(), run.archive().values()
    assert payoff.exact
    assert payoff.scores.shape == (5, 5, 1)
    expected = 1 / (1 + np.exp(parasites.sum(axis=1) - hosts.sum(axis=1)[:, np.newaxis]))
    np.testing.assert_allclose(payoff.matrix, expected, atol=1e-6)
    for name in ("evaluation_episodes", "match_episodes"):
        with pytest.raises(ValueError, match=f"^{name}: expected no value in a game that is det"):
            race(game=numbers, **{name: 2})


@pytest.fixture
def own(tmp_path, monkeypatch):
    """Write a module with a game, and return a function that writes it anew."""
    monkeypatch.syspath_prepend(tmp_path)

    def write(text):
        sys.modules.pop("mine", None)
        (tmp_path / "mine.py").unlink(missing_ok=True)
        if text:
            (tmp_path / "mine.py").write_text(text)
        # Two writes in a second, of the same size, would otherwise be one module.
        shutil.rmtree(tmp_path / "__pycache__", ignore_errors=True)
        linecache.clearcache()
        importlib.invalidate_caches()

    yield write
    sys.modules.pop("mine", None)


GAME = """
from matrixworld.coevolution import Game
SLOPE = 4
def play(a, b, rng):
    return 0.5 + 0.5 * (a.mean(1) > b.mean(1) + 0 * SLOPE)
def show(a, b):
    return "shown"
game = Game(play, genes=3, teams=("hosts", "parasites"), deterministic=True, show=show)
"""
OTHERS = {
    "": "^mine:game: expected a module that can be imported",
    "game = 3\n": "^mine:game: expected a Game, got 3",
    GAME.replace("genes=3", "genes=4"): r"game with genes \(3, 3\), got \(4, 4\)",
    GAME.replace('"hosts"', '"cats"'): r"game with teams \('hosts', .*\), got \('cats', 'paras",
    GAME.replace("True", "False"): "game with deterministic True, got False",
    GAME.replace("SLOPE = 4", "SLOPE = 5"): "expected the source of the game as it was, got a chan",
}


@pytest.mark.parametrize("source", OTHERS, ids=range(len(OTHERS)))
def test_a_run_of_a_game_goes_on_with_no_other_one(source, own, tmp_path):
    own(GAME)
    settings, directory = race(game="mine:game"), tmp_path / "run"
    stopped(settings, directory, 3)
    before = results_of(directory)
    own(source)
    with pytest.raises(ValueError, match=OTHERS[source]):
        co.finish(directory)
    assert results_of(directory) == before
    # What needs no game is there: log and genomes.
    assert co.open_run(directory).archive()["hosts"].shape == (3, 3)
    own(GAME)
    co.finish(directory)
    assert results(directory) == straight(settings)


PARTS = """
from functools import partial
import numpy as np
from matrixworld.coevolution import Game
class Player:
    def __init__(self, level):
        self.level = level
    def __call__(self, a, b, rng):
        return HELPERS["half"](a) * self.level
def half(a, factor):
    return np.full(len(a), factor)
HELPERS = {"half": partial(half, factor=0.5)}
play = Player(1.0)
game = Game(play, genes=3, teams=("ones", "others"))
"""
CHANGES = [("a) * self", "b) * self"), ("len(a)", "len(a) + 0"), ("0.5", "0.25"), ("1.0", "0.9")]


@pytest.mark.parametrize("change", [*CHANGES, ("genes=3", "genes=2")])
def test_a_digest_is_of_all_that_a_game_is_made_of(change, own):
    def digest(text):
        own(text)
        return digest_of(importlib.import_module("mine").game)

    assert digest(PARTS) == digest(PARTS)  # other objects, at other addresses
    assert digest(PARTS.replace(*change)) != digest(PARTS)


LAMBDAS = """
from matrixworld.coevolution import Game
half = lambda a: a.mean(1)
whole = lambda a: a.sum(1)
NAMES = {"half", "whole", "both"}
def play(a, b, rng):
    return 0.5 + 0 * half(a) + 0 * whole(b) + 0 * len(NAMES)
play_all = lambda a, b, rng: 0.5 + 0 * a[:, 0]
first = lambda rng: [0.1]
class Player:
    def __init__(self, level):
        self.level = level
    def play(self, a, b, rng):
        return self.level + 0 * a[:, 0]
game = Game(play, genes=3, teams=("ones", "others"))
method = Game(Player(0.7).play, genes=1, teams=("ones", "others"))
short = Game(play_all, genes=1, teams=("ones", "others"), initial=first)
"""
DIGESTS = """
import mine
from matrixworld.coevolution.games.digest import digest_of
print(digest_of(mine.game), digest_of(mine.short))
"""


def test_a_digest_is_the_same_in_every_process(own, tmp_path, monkeypatch):
    own(LAMBDAS)
    module = importlib.import_module("mine")
    expected = f"{digest_of(module.game)} {digest_of(module.short)}\n"
    for seed in ("1", "2", "3"):  # of the order of sets
        monkeypatch.setenv("PYTHONHASHSEED", seed)
        assert python("-c", DIGESTS, cwd=tmp_path).stdout == expected


@pytest.mark.parametrize(
    ("name", "change"),
    [
        ("game", ("a.mean", "a.min")),
        ("game", ("a.sum", "a.max")),
        ("game", ('"both"', '"none"')),
        ("short", ("[0.1]", "[0.2]")),
        ("short", ("0.5 + 0 * a[:, 0]", "0.6 + 0 * a[:, 0]")),
        ("method", ("0.7", "0.8")),
    ],
)
def test_a_change_of_any_part_is_noticed(name, change, own):
    def digest(text):
        own(text)
        return digest_of(getattr(importlib.import_module("mine"), name))

    assert digest(LAMBDAS.replace(*change)) != digest(LAMBDAS)


def results_of(directory):
    return {path.name: path.read_bytes() for path in directory.iterdir() if path.is_file()}


def test_a_run_of_a_game_is_no_chase(tmp_path):
    """What plays, records or scores pursuit refuses its genomes by name."""
    run = co.finish(co.create(race(), tmp_path / "run").path)
    refused = {
        lambda: run.policy("cats"): "`genomes` returns its genomes",
        lambda: co.score(run): "it has no held-out opponents, and `judge` says how",
    }
    for asked, instead in refused.items():
        expected = f"run of pursuers and evaders, got .* own_games:coins; {instead}"
        with pytest.raises(ValueError, match=expected):
            asked()
    with pytest.raises(ValueError, match="^show: expected a function of the game that shows a mat"):
        run.record()
    told = run.explain("mice", 1)
    expected = 1 - run.payoff().matrix[:, 1]
    np.testing.assert_allclose(told.scores, expected)
    assert str(told).splitlines()[1] == (
        f"Mean score against cats, 5 of them: {expected.mean():.3f}"
    )
    assert json.loads(json.dumps(told.to_json()))["generation"] == 1
    with pytest.raises(ValueError, match="^.*: holds a run with other settings: game"):
        co.evolve(race(game=numbers), tmp_path / "run")


def test_settings_that_a_game_has_not_are_refused():
    for name, value in {
        "world.rows": 5, "policy.mask": "obstacles", "train_steps": 9, "learner.measure": "rewards",
        "learner.cost_limit": 1.0,
    }.items():  # fmt: skip
        with pytest.raises(ValueError, match=f"^{name}: expected no value.* in a game of your own"):
            race(**{name: value})
    for learner in ("actor-critic", "gp"):
        with pytest.raises(ValueError, match="^learner: expected es, ga, cma or your own in "):
            co.RaceSettings.of({"game": coins, "learner": learner})


def changed(play=higher, genes=2, **fields):
    return co.Game(play, genes, **{"teams": ("ones", "others"), **fields})


def uses_the_global_generator(a, b, rng):
    return higher(a, b, rng) * np.random.random(len(a))  # noqa: NPY002


def counts_its_calls(a, b, rng, calls=[]):  # noqa: B006
    calls.append(1)
    return np.full(len(a), 1 / len(calls))


@pytest.mark.parametrize(
    ("game", "message"),
    [
        (changed(uses_the_global_generator), "play: expected equal scores from equal generators"),
        (changed(counts_its_calls), "play: expected equal scores from equal generators"),
        (changed(lambda a, b, rng: a), r"scores of the game: expected .*\(1,\), got \(1, 2\)"),
        (changed(lambda a, b, rng: a[:, 0] * np.nan), r"numbers in \[0, 1\], got nan"),
        (
            changed(lambda a, b, rng: 1.0 * (a[:, 0] > a[:, 0].mean()), deterministic=True),
            "play: expected scores of each match alone",
        ),
        (changed(initial=lambda rng: [0, np.inf]), "initial: expected 2 finite genes, got"),
    ],
)
def test_a_broken_promise_is_named(game, message):
    before = np.random.get_state()[1].copy()  # noqa: NPY002
    with pytest.raises(ValueError, match=message):
        co.check_game(game)
    assert np.array_equal(np.random.get_state()[1], before)  # noqa: NPY002


@pytest.mark.parametrize("game", [numbers, fewer, coins])
def test_a_game_that_keeps_all_promises(game):
    co.check_game(game)


@pytest.mark.parametrize(
    ("fields", "error", "message"),
    [
        ({"genes": 0}, ValueError, "genes: expected .*, got 0"),
        ({"genes": (2, 3, 4)}, ValueError, "genes: expected those of two teams, got 3"),
        ({"teams": ("big cats", "mice")}, ValueError, "teams: expected two different words"),
        ({"bounds": ([0, 0], [1, 1])}, ValueError, "bounds: expected one value, or one for"),
        ({"bounds": (1, 0)}, ValueError, "bounds: expected least < largest value"),
    ],
)
def test_what_is_no_game_is_refused(fields, error, message):
    with pytest.raises(error, match=f"^{message}"):
        replace(numbers, **fields)


def test_a_game_that_no_import_finds_is_refused():
    with pytest.raises(
        ValueError, match="^game: expected a global variable of the module that makes it"
    ):
        race(game=replace(numbers))


SCRIPT = """
from matrixworld.coevolution import Game, RaceSettings
def play(a, b, rng):
    return 0.5 + 0 * a[:, 0]
game = Game(play, genes=1, teams=("ones", "others"))
if __name__ == "__main__":
    print(RaceSettings.of({"game": game}).game.code)
"""


def test_a_script_that_runs_is_named_as_others_import_it(tmp_path):
    (tmp_path / "pack").mkdir()
    (tmp_path / "pack/race.py").write_text(SCRIPT)
    assert python("-m", "pack.race", cwd=tmp_path).stdout == "pack.race:game\n"


def test_matches_are_seen_by_nobody_else(tmp_path):
    """A match of a game with chance depends on its seed and players alone."""
    run = co.finish(co.create(race(), tmp_path / "run").path)
    teams = [*map(coins.population, ("pursuer", "evader"), run.archive().values())]
    seeds = np.arange(5, dtype=np.uint64)
    a, b = np.arange(5), np.arange(5)[::-1]
    scores = coins.rollout(*teams, (a, b, seeds), episodes=40, threads=1).scores
    alone = coins.rollout(*teams, (a[3:4], b[3:4], seeds[3:4]), episodes=40, threads=1).scores
    np.testing.assert_array_equal(scores[3:4], alone)
    assert not np.array_equal(scores[0], scores[4])
    assert co.Run(tmp_path / "run").training.counts["matches"] == run.summary()["training_matches"]


def test_matches_draw_from_all_64_bits_of_their_seeds():
    """The generators of two matches differ in their lowest bits, also of seeds above 2^63."""
    drawn = []

    def play(a, b, rng):
        rng.integers(10, dtype=np.uint32)  # half of a word stays for the next draw
        drawn.append(rng.random())
        return [drawn[-1]]

    game = co.Game(play, genes=1, teams=("ones", "others"))
    seeds = np.array([5, 2**63 + 1, 2**63 + 5, 2**64 - 1], np.uint64)
    both = game.population("pursuer", np.zeros((1, 1), np.float32))
    matches = np.zeros(4, int), np.zeros(4, int), seeds
    game.rollout(both, both, matches, episodes=2, threads=1)
    expected = []
    for seed in seeds:
        for episode in range(2):
            key = np.array([seed, episode], np.uint64)
            rng = np.random.Generator(np.random.Philox(key=key))
            rng.integers(10, dtype=np.uint32)
            expected.append(rng.random())
    assert drawn == expected
    assert len({*drawn}) == 8
