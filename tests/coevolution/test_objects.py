"""Genomes that are objects: races, files, operators, and what is refused."""

import importlib
import itertools
import json
import linecache
import random
import shutil
import sys
from dataclasses import replace
from typing import ClassVar

import numpy as np
import pytest

import matrixworld as mw
from matrixworld import coevolution as co
from matrixworld._util import files
from matrixworld._util.sections import section, setting
from matrixworld.coevolution.games.digest import digest_of
from matrixworld.coevolution.learners import Breeding
from matrixworld.coevolution.learners.learner import Learner
from object_games import guessing, guessing_at_once, sort, sorting, trees
from own_games import numbers, short_race
from scripts import python
from tiny_race import results, stopped, straight

GAMES = {"sorting": sorting, "guessing": guessing, "at once": guessing_at_once, "trees": trees}
TINY = {"learner.population": 6, "schedule.generations": 4, "seed": 3}
HALL = {**TINY, "schedule": "hall-of-fame", "schedule.joint_epochs": 2}
TURNS = {**TINY, "schedule.pursuer_epochs": 2, "schedule.evader_epochs": 3}
RACES = {
    "hall": {**HALL, "schedule.hall_sample": 2, "learner.sharing": "competitive"},
    "turns": {**TURNS, "schedule": "alternating", "schedule.opponents": 2},
    "psro": {**TURNS, "schedule": "psro", "retest_episodes": 2},
}


def race(game, name="hall", **changes):
    return co.RaceSettings.of({"game": game, **RACES[name], **changes})


@pytest.mark.parametrize("game", GAMES)
@pytest.mark.parametrize("name", RACES)
def test_races_of_objects_resume_bit_for_bit(game, name, tmp_path):
    settings = race(GAMES[game], name)
    assert settings.learner.kind == "breeding"
    stopped(settings, tmp_path / "run")
    run = co.finish(tmp_path / "run")
    assert results(tmp_path / "run") == straight(settings)
    one, other = run.archive().values()
    assert one.shape == other.shape == (5, 1)
    assert one.dtype.kind == other.dtype.kind == "U"
    run.judge()


def test_a_payoff_is_what_the_game_says_of_the_objects(tmp_path):
    run = co.evolve(race(sorting), tmp_path / "run")
    sorters, tests = run.genomes("sorters"), run.genomes("tests")
    expected = [[sort(net, case) for case in tests] for net in sorters]
    np.testing.assert_allclose(run.payoff().matrix, expected, atol=1e-6)
    assert run.genomes("sorters", -1) == sorters[-1]
    assert json.loads((run.path / "tests.json").read_text())["genomes"] == [
        json.dumps(each) for each in tests
    ]
    assert sorters[0] != sorters[-1]


def test_a_race_that_becomes_longer_and_seeds_side_by_side_are_equal(tmp_path):
    longer = race(trees)
    run = co.evolve(race(trees, **{"schedule.generations": 2}), tmp_path / "run").extend(4)
    assert results(run.path) == straight(longer)
    first, _ = co.evolve([longer, longer.changed({"seed": 4})], tmp_path / "job", threads=2)
    assert results(first.path) == straight(longer)


def test_vectors_are_genomes_too(tmp_path):
    run = co.evolve(short_race(numbers), tmp_path / "run")
    np.testing.assert_array_equal(run.genomes("hosts"), run.archive()["hosts"])
    np.testing.assert_array_equal(run.genomes("hosts", 2), run.archive()["hosts"][2])
    with pytest.raises(ValueError, match="team: expected"):
        run.genomes("nobody")


@pytest.mark.parametrize("start", [[[0, 1], [2, 3]], None])
def test_a_team_alone_learns_objects(start, tmp_path):
    first = co.evolve(race(sorting), tmp_path / "race")
    alone = co.RaceSettings.of(
        {"game": sorting, "schedule": "against", "schedule.epochs": 6, "schedule.team": "pursuer"},
        {"schedule.opponent": str(first.path), "schedule.archive_every": 2},
        {"learner.population": 6, "schedule.start": None if start else str(first.path)},
    )
    run = co.finish(co.create(alone, tmp_path / "alone", start=start).path)
    assert run.genomes("sorters", 0) == (start or first.genomes("sorters", -1))
    assert run.genomes("tests") == [first.genomes("tests", -1)]
    with pytest.raises(TypeError, match="start: expected a genome, got \\(3,\\)"):
        co.create(alone, tmp_path / "other", start=(3,))


@pytest.mark.parametrize("texts", [["", "aé日", "𝄞" * 9], [], ["a"]])
def test_files_hold_texts_without_gaps(texts, tmp_path):
    arrays = {
        "texts": np.array(texts, np.str_).reshape(-1, 1),
        "one": np.array("é"),
        "x": np.ones(2),
    }
    files.save_arrays(tmp_path / "a.npz", arrays)
    read = files.load_arrays(tmp_path / "a.npz")
    assert {*read} == {*arrays}
    for name, array in arrays.items():
        np.testing.assert_array_equal(read[name], array)
        assert read[name].shape == array.shape


@pytest.mark.parametrize("lengths", [[[4]], [[2], [2]], [[-1], [4]]])
def test_altered_texts_are_damage(lengths, tmp_path):
    parts = {"t.utf8": np.frombuffer(b"abc", np.uint8), "t.utf8.lengths": np.array(lengths)}
    files.save_arrays(tmp_path / "a.npz", parts)
    with pytest.raises(files.DamagedFileError, match="expected texts in t"):
        files.load_arrays(tmp_path / "a.npz")


# Operators:


def test_operators_get_fresh_objects_and_draw_from_the_rng_alone():
    """Global random numbers that DEAP draws from are as they were before."""
    random.seed(5)
    np.random.seed(5)  # noqa: NPY002
    expected = random.random(), np.random.random()  # noqa: NPY002
    random.seed(5)
    np.random.seed(5)  # noqa: NPY002
    genomes = [trees.untrained("pursuer", np.random.default_rng(seed)) for seed in (1, 1, 2)]
    assert genomes[0] == genomes[1] != genomes[2]
    children = [
        trees.operators["pursuer"].child(
            np.stack(genomes[1:]), np.random.default_rng(3), mutates=True
        )
        for _ in range(2)
    ]
    assert children[0] == children[1]
    assert (random.random(), np.random.random()) == expected  # noqa: NPY002


def test_crossover_and_mutation_are_those_of_the_learner():
    marked = mw.Game(
        lambda one, other: 0.5,
        teams=("ones", "others"),
        initial=lambda rng: [int(rng.integers(10**9))],
        mutate=lambda genome, rng: [*genome, "mutated"],
        mate=lambda one, other, rng: [*one, *other],
        deterministic=True,
    )
    population = [marked.untrained("pursuer", np.random.default_rng(n)) for n in range(40)]
    texts = np.stack(population)
    for crossover, mutation, length, mutants in (
        (1.0, 0.0, 2, 0), (1.0, 1.0, 3, 38), (0.0, 0.0, 2, 38),
    ):  # fmt: skip
        learner = Breeding(40, crossover=crossover, mutation=mutation, tournament=2)
        learner = replace(learner, operators=marked.operators["pursuer"])
        state = learner.start(_Start(texts))._replace(fitness=np.arange(40.0))
        candidates, _ = learner.ask(state, np.random.default_rng(0))
        genomes = [json.loads(text) for text in candidates[:, 0]]
        assert candidates[:2, 0].tolist() == texts[[39, 38], 0].tolist()
        assert {len(genome) for genome in genomes[2:]} == {length}
        assert sum(genome[-1] == "mutated" for genome in genomes) == mutants
        # Tournaments prefer the fittest: of two entrants the mean rank is 26.
        ranks = [texts[:, 0].tolist().index(json.dumps(genome[:1])) for genome in genomes[2:]]
        assert 21 < np.mean(ranks) < 32


class _Start:
    def __init__(self, texts):
        self.texts = texts

    def genomes(self, count):
        return self.texts[:count]


PLAIN = {
    "teams": ("ones", "others"), "initial": lambda rng: 1, "mutate": lambda g, rng: g,
    "deterministic": True,
}  # fmt: skip

# What is refused:


def ones(rng):
    return rng.integers(0, 9, 4).tolist()


def mutant(genome, rng):
    genome[rng.integers(4)] = int(rng.integers(9))
    return genome


def larger(one, other):
    return float(sum(one) > sum(other))


def game(**changes):
    usual = {"initial": ones, "mutate": mutant, "deterministic": True, "teams": ("ones", "others")}
    return mw.Game(**{"play": larger, **usual, **changes})


def sorts(one, other):
    one.sort()
    return float(one[0] > other[0])


def draws_from_random(genome, rng):
    genome[0] = random.randrange(10**6)
    return genome


def numpy_integer(genome, rng):
    genome[0] = rng.integers(9)
    return genome


COUNTER = itertools.count()
BROKEN = {
    "changed argument": ({"play": sorts}, "play: expected genomes that stay as they were"),
    "random initial": (
        {"initial": lambda rng: [random.random()] * 4},
        "initial: expected equal genomes from equal generators, got others; random numbers must",
    ),
    "random mutant": ({"mutate": draws_from_random}, "mutate: expected equal genomes from equal"),
    "random child": (
        {"mate": lambda one, other, rng: [random.random()] * 4},
        "mate: expected equal genomes from equal",
    ),
    "counter": ({"mutate": lambda g, rng: [*g, next(COUNTER)]}, "mutate: expected equal genomes"),
    "NumPy integer": (
        {"mutate": numpy_integer},
        r"write: expected to make text of what mutate made, \[np.int64.* int64 is not JSON",
    ),
    "None": ({"mutate": lambda g, rng: g.sort()}, "mutate: expected a genome, got None; return"),
    "tuple": (
        {"mutate": lambda g, rng: (g,)},
        r"mutate: expected a genome, got \(\[.*; return the",
    ),
    "tuple of a child": ({"mate": lambda a, b, rng: (a,)}, "mate: expected a genome, got"),
    "NaN": ({"initial": lambda rng: [np.nan]}, "write: expected to make text of what initial made"),
    "bytes": ({"write": bytes}, "write: expected text, a str, of what initial made"),
    "NUL": ({"write": lambda g: "\0", "read": str}, "write: expected text that a file holds"),
    "surrogate": ({"write": lambda g: "\ud800", "read": str}, "write: expected text that a file"),
    "unread": ({"write": lambda g: "{"}, "read: expected to read '{': Expecting"),
    "lossy": (
        {"write": lambda g: f"{len(g)}", "read": lambda text: [0] * (int(text) + 1)},
        "write: expected the same text of what read",
    ),
    "score": ({"play": lambda a, b: 2}, r"expected numbers in \[0, 1\], got 2"),
    "scores": ({"play": lambda a, b: [0.5]}, r"scores of the game: expected a number, got \(1,\)"),
    "no number": ({"play": lambda a, b: None}, "scores of the game: expected"),
}


@pytest.mark.parametrize("name", BROKEN)
def test_a_broken_promise_is_named(name):
    changes, message = BROKEN[name]
    before = random.getstate()
    with pytest.raises((TypeError, ValueError), match=message):
        mw.check_game(game(**changes))
    assert random.getstate() == before


@pytest.mark.parametrize("name", GAMES)
def test_games_that_keep_all_promises(name):
    mw.check_game(GAMES[name])


def test_few_matches_of_a_slow_game():
    calls = []

    def play(one, other, rng):
        calls.append(1)
        return rng.random()

    mw.check_game(game(play=play, deterministic=False), matches=4)
    assert len(calls) == (4 + 4 + 2) * 2


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        (
            {"genes": 4},
            "mutate: expected no value for vectors, which have genes, got mutate and ge",
        ),
        ({"initial": None}, "initial: expected a function of genomes that are objects, got none"),
        (
            {"mutate": None},
            "mutate: expected a function of genomes that are objects, got none; vec",
        ),
        ({"mutate": (mutant, None)}, "mutate: expected a function of genomes that are objects"),
        ({"mutate": (mutant,) * 3}, "mutate: expected a function of each team, got 3"),
        ({"mate": 3}, "mate: expected a function, got 3"),
        ({"bounds": (0, 1)}, "bounds: expected no value for genomes that are objects"),
        ({"many": 1}, "many: expected True or False, got 1"),
        ({"teams": ()}, "teams: expected those of two teams, got 0"),
    ],
)
def test_what_is_no_game_is_refused(changes, message):
    with pytest.raises((TypeError, ValueError), match=f"^{message}"):
        game(**changes)


def test_learners_of_vectors_and_of_objects():
    for learner in ("es", "ga", "cma", "gp", "actor-critic"):
        with pytest.raises(ValueError, match="^learner: expected breeding, or your own for text"):
            co.RaceSettings.of(game=sorting, learner=learner)
    with pytest.raises(ValueError, match="^learner: expected es, ga, cma or your own"):
        co.RaceSettings.of(game=numbers, learner="breeding")
    with pytest.raises(ValueError, match="^learner: expected a learner of vectors in pursuit"):
        co.RaceSettings.of(learner="breeding")
    with pytest.raises(TypeError, match="operators: expected those of a game"):
        Breeding().operators.initial(np.random.default_rng(0))


@section()
class Copies(Learner):
    """A learner of one's own that mutates one text, and keeps the best."""

    texts: ClassVar[bool] = True
    lengthens: bool = setting(False, "whether it returns something else")

    def start(self, task):
        return {"genome": task.genomes(1)[0], "candidates": task.genomes(self.population)}

    def ask(self, state, rng):
        parent = state["genome"][np.newaxis]
        texts = [self.operators.child(parent, rng, mutates=True) for _ in range(self.population)]
        candidates = np.array(texts).reshape(-1, 1)
        if self.lengthens:
            candidates = np.repeat(candidates, 2, axis=1)
        return candidates, {**state, "candidates": candidates}

    def tell(self, state, results):
        return {**state, "genome": state["candidates"][np.argmax(results.fitness)]}


def test_a_learner_of_ones_own_gets_texts_and_operators(tmp_path):
    co.check_learner(Copies())
    co.check_learner(Breeding(population=8))
    with pytest.raises(co.PluginError, match=r"ask: expected an array of text \(48, 1\), got"):
        co.check_learner(Copies(lengthens=True))
    short = {path: value for path, value in HALL.items() if path != "learner.population"}
    settings = co.RaceSettings.of(short, game=sorting, learner=Copies(population=6))
    stopped(settings, tmp_path / "run")
    co.finish(tmp_path / "run")
    assert results(tmp_path / "run") == straight(settings)


# Where a run finds its game, and whether that has changed:

LIBRARY = """
def duel(one, other):
    return float(one > other)
def draw(rng):
    return int(rng.integers(9))
def change(genome, rng):
    return (genome + 1) % 9
def make(step):
    def stepped(genome, rng):
        return (genome + step) % 9
    return stepped
"""
MINE = """
import enum
import functools
from collections import deque
from dataclasses import dataclass
from fractions import Fraction
import library
import numpy as np
import matrixworld as mw
from deap import base, gp, tools
TEAMS = ("red", "blue")
game = mw.Game(library.duel, teams=TEAMS, initial=library.draw, mutate=library.change)
half = mw.Game(library.duel, teams=TEAMS, initial=library.draw, mutate=library.make(1))
two = mw.Game(lambda a, b: 0.5, teams=TEAMS, initial=lambda rng: 1,
              mutate=lambda g, rng: g + 2)
BIG = 1 << 20000
DO = {"+": int.__add__}
@dataclass(frozen=True)
class Limits:
    most: int = 10
class Colour(enum.Enum):
    RED = 1
def corner(n):
    return n * 6
class Plain:
    def first(self):
        return corner(1)
class Board(Plain):
    size = 3
    bag = deque([1, 2])
HELD = [Limits(11), Colour.RED, range(12), Fraction(1, 3), np.array([{"deep": 13}], object)]
MEMO = {}
@functools.lru_cache
def cached(n):
    return n + 4
def play(one, other, most=5):
    MEMO[one] = other
    return min(one, most, BIG, len(DO) + len(HELD)) / (Board.size + cached(most))
nested = mw.Game(play, teams=TEAMS, initial=library.draw, mutate=library.change, deterministic=True)
primitives = gp.PrimitiveSet("MAIN", 1)
def double(x):
    return 2 * x
primitives.addPrimitive(double, 1)
toolbox = base.Toolbox()
toolbox.register("individual", tools.initRepeat, list, lambda: 1, 6)
toolbox.register("mutate", gp.mutUniform, expr=None, pset=primitives)
toolbox.decorate("mutate", gp.staticLimit(key=len, max_value=7))
deap = mw.Game(lambda a, b: 0.5, teams=TEAMS, **mw.coevolution.by_toolbox(toolbox))
"""
SEEN = [
    ("game", "library", ("one > other", "one < other")),
    ("game", "library", ("integers(9)", "integers(8)")),
    ("half", "mine", ("make(1)", "make(2)")),
    ("two", "mine", ("lambda rng: 1", "lambda rng: 3")),
    ("two", "mine", ("g + 2", "g + 3")),
    ("nested", "mine", ("int.__add__", "int.__sub__")),
    ("nested", "mine", ("1 << 20000", "1 << 20001")),
    ("nested", "mine", ("Limits(11)", "Limits(12)")),
    ("nested", "mine", ("RED = 1", "BLUE = 1")),
    ("nested", "mine", ("range(12)", "range(13)")),
    ("nested", "mine", ("Fraction(1, 3)", "Fraction(1, 4)")),
    ("nested", "mine", ('"deep": 13', '"deep": 14')),
    ("nested", "mine", ("n * 6", "n * 7")),
    ("nested", "mine", ("most=5", "most=6")),
    ("nested", "mine", ("size = 3", "size = 4")),
    ("nested", "mine", ("n + 4", "n + 5")),
    ("deap", "mine", ("lambda: 1, 6", "lambda: 1, 7")),
    ("deap", "mine", ("max_value=7", "max_value=8")),
    ("deap", "mine", ("2 * x", "3 * x")),
    ("deap", "mine", ("(double, 1)", '(double, 1, name="twice")')),
]
DIGESTS = """
import mine
from matrixworld.coevolution.games.digest import digest_of
print(*(digest_of(getattr(mine, name)) for name in ("game", "half", "two", "nested", "deap")))
"""


@pytest.fixture
def modules(tmp_path, monkeypatch):
    """Write modules anew, and import the one that is called mine."""
    monkeypatch.syspath_prepend(tmp_path)

    def write(texts):
        for name, text in texts.items():
            sys.modules.pop(name, None)
            (tmp_path / f"{name}.py").write_text(text)
        # Two writes in a second, of the same size, would otherwise be one module.
        shutil.rmtree(tmp_path / "__pycache__", ignore_errors=True)
        linecache.clearcache()
        importlib.invalidate_caches()
        return importlib.import_module("mine")

    yield write
    for name in ("library", "mine"):
        sys.modules.pop(name, None)


@pytest.mark.parametrize(("name", "module", "change"), SEEN)
def test_a_change_of_what_a_game_is_made_of_is_seen(name, module, change, modules):
    def digest(changed):
        texts = {"library": LIBRARY, "mine": MINE}
        assert change[0] in texts[module]
        if changed:
            texts[module] = (
                texts[module]
                .replace(*change)
                .replace("Colour.RED", "Colour.BLUE" if "BLUE" in change[1] else "Colour.RED")
            )
        return digest_of(getattr(modules(texts), name))

    assert digest(changed=False) == digest(changed=False)
    assert digest(changed=True) != digest(changed=False)


def test_a_digest_is_the_same_in_every_process(modules, tmp_path, monkeypatch):
    modules({"library": LIBRARY, "mine": MINE})
    first = python("-c", DIGESTS, cwd=tmp_path).stdout
    for seed in range(4):  # of the order of sets; the first one has no compiled modules
        monkeypatch.setenv("PYTHONHASHSEED", str(seed))
        assert python("-c", DIGESTS, cwd=tmp_path).stdout == first
    assert len(set(first.split())) == 5


def test_a_game_is_found_where_it_was_made(modules):
    """`play` may come from a library; a game may be made by one."""
    maker = (
        f"{LIBRARY}\nimport matrixworld as mw\ndef make_game():\n"
        "    return mw.Game(duel, teams=('red', 'blue'), initial=draw, mutate=change)\n"
    )
    made = "import library\ngame = library.make_game()\n"
    for texts in ({"library": LIBRARY, "mine": MINE}, {"library": maker, "mine": made}):
        mine = modules(texts)
        assert co.RaceSettings.of(game=mine.game).game.code == "mine:game"


def test_a_game_of_objects_can_be_replaced_field_by_field():
    other = replace(sorting, mate=None, show=lambda net, tests: "shown")
    assert other.operators["pursuer"].mate is None
    assert other.sizes == sorting.sizes == (1, 1)
    assert other.shown(np.array(["[]"]), np.array(["[]"])) == "shown"


def test_what_play_keeps_to_be_faster_is_no_change(modules, tmp_path):
    mine = modules({"library": LIBRARY, "mine": MINE})
    settings = co.RaceSettings.of(HALL, game=mine.nested)
    run = co.evolve(settings, tmp_path / "run", threads=1)
    assert mine.MEMO
    assert results(run.extend(5).path) == straight(settings.changed({"schedule.generations": 5}))
    mw.check_game(mine.nested, matches=4)


def test_shared_collections_are_read_once():
    nested = []
    for _ in range(60):
        nested = [nested, nested]
    holds = mw.Game(lambda a, b: 0.5 * bool(nested), **PLAIN)
    assert holds.digest == mw.Game(holds.play, **PLAIN).digest
