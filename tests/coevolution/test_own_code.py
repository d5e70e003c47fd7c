"""Learners and samplers of your own: names as data, what an import finds, and kept promises."""

import os
import pickle
import sys
from dataclasses import dataclass
from functools import partial

import numpy as np
import pytest

from matrixworld import coevolution as co
from matrixworld.coevolution import opponents
from matrixworld.coevolution.learners import OwnLearner
from matrixworld.coevolution.opponents import OwnOpponents
from own_code import Crash, Exits, Fails, Hardest, HillClimber, InPlace, Oldest
from tiny_race import alternating, played, tiny_race


@pytest.fixture
def folder(tmp_path, monkeypatch):
    """A folder from which `mine` is imported; a test of another file may have its own."""
    monkeypatch.syspath_prepend(tmp_path)
    monkeypatch.delitem(sys.modules, "mine", raising=False)
    yield tmp_path
    sys.modules.pop("mine", None)


def test_a_run_is_read_without_its_code(folder):
    imported = folder / "imported"
    (folder / "mine.py").write_text(
        f"from pathlib import Path\nPath({str(imported)!r}).touch()\n"
        "from own_code import Hardest, HillClimber\n"
    )
    settings = alternating(learner="mine:HillClimber", evaders_meet="mine:Hardest", generations=1)
    assert not imported.exists()
    played(settings, folder / "run")
    assert imported.exists()
    del sys.modules["mine"]
    os.remove(imported)
    (folder / "run" / "summary.json").unlink()
    run = co.open_run(folder / "run")
    assert len(run.log()["epoch"]) == 5
    run.payoff(), run.record(), run.policy("evader"), co.score(run, episodes=2), repr(run)
    co.create(settings, folder / "run")  # the same: it is left as it is
    assert run.settings.learner == OwnLearner(code="mine:HillClimber")
    assert "mine" not in sys.modules
    assert not imported.exists()
    co.finish(folder / "run")
    assert imported.exists()


@pytest.mark.parametrize("name", ["gaa", "mine.Hill", ":Hill", "mine:", "my pkg:Hill", "1:H", ""])
def test_a_name_that_cannot_be_one_is_refused(name):
    for path in ("learner", "schedule.pursuers_meet"):
        with pytest.raises(ValueError, match=f"^{path}: expected one of .*, or module:object, got"):
            co.RaceSettings.of({path: name})


@dataclass(frozen=True)
class Bred(co.GeneticAlgorithm):
    population: int = 8
    bits: int = 1


def test_a_class_and_an_instance_stand_for_their_name_and_settings():
    given = {"sigma": np.float32(0.5), "shrink": 1}
    named = OwnLearner(code="own_code:HillClimber", settings=given)
    by_name = co.RaceSettings.of({"learner": "own_code:HillClimber"})
    assert co.RaceSettings(learner=HillClimber) == by_name
    made = co.RaceSettings(learner=HillClimber(sigma=0.5)).learner
    assert made.settings == {"population": 4, "shrink": 0.9, "sigma": 0.5}
    assert made.load() == HillClimber(sigma=0.5)
    derived = co.RaceSettings(learner=Bred(bits=3)).learner  # not the built-in one, without bits
    assert isinstance(derived, OwnLearner)
    assert derived.load() == Bred(bits=3)
    for met in (Oldest, Oldest(), "own_code:Oldest"):
        settings = co.RaceSettings.of({"schedule.evaders_meet": met})
        assert settings.schedule.evaders_meet == OwnOpponents(code="own_code:Oldest")
    given["sigma"] = 7.0
    assert named.to_json()["settings"] == {"shrink": 1, "sigma": 0.5}

    class Inside(HillClimber):
        """No import finds it again."""

    with pytest.raises(ValueError, match="code: expected a class of a module, got <c"):
        co.RaceSettings(learner=Inside)


@pytest.mark.parametrize(
    ("name", "message"),
    [
        ("nowhere.at:all", r"expected a module .* \(No .*; install .* folder on PYTHONPATH$"),
        ("own_code.deeper:Hill", r"\(No module named 'own_code.deeper'; 'own_code' is not a pack"),
        ("own_code:HillClimber.Inner", "expected the name of an object in own_code$"),
        ("own_code:ANSWER", "expected a class derived from .*, got 42"),
        ("os:system", "expected a class derived from .*, got <built-in function system>"),
        ("own_code:np.ndarray", "expected a class derived from "),
    ],
)
def test_what_cannot_be_found_is_said(name, message, tmp_path):
    for settings in (tiny_race(learner=name), alternating(evaders_meet=name)):
        with pytest.raises(ValueError, match=f"^{name}: .*{message}"):
            co.create(settings, tmp_path / "run")
    assert not (tmp_path / "run").exists()


@pytest.mark.parametrize(
    ("value", "message"),
    [
        ({"sgima": 1}, "sgima: expected one of the settings population, sigma, shrink"),
        ({"sigma": -1}, "sigma: expected a number above 0, got -1"),
        ({"sigma": "x"}, "sigma: expected a number, got 'x'"),
    ],
)
def test_settings_are_those_of_the_fields(value, message):
    with pytest.raises(ValueError, match=f"^own_code:HillClimber: {message}"):
        OwnLearner(code="own_code:HillClimber", settings=value).load()


def test_a_mask_needs_a_learner_that_keeps_it(tmp_path):
    with pytest.raises(ValueError, match="^policy.mask: expected 'none' with HillClimber, got"):
        co.create(tiny_race(learner="own_code:HillClimber", mask="obstacles"), tmp_path / "run")
    assert not (tmp_path / "run").exists()


def test_a_module_or_a_class_that_fails_is_named_with_its_error(folder):
    (folder / "mine.py").write_text(
        "from own_code import HillClimber\n"
        "class Hill(HillClimber):\n    def check(self):\n        [][1]\n"
        "class Box:\n    Hill = HillClimber\n"
    )
    with pytest.raises(co.PluginError, match="^mine:Hill: IndexError: list index"):
        tiny_race(learner="mine:Hill").learner_of("pursuer")
    assert tiny_race(learner="mine:Box.Hill").learner_of("evader") == HillClimber()
    del sys.modules["mine"]
    (folder / "mine.py").write_text("1 / 0\n")
    with pytest.raises(co.PluginError, match="^mine:Hill: import: ZeroDivisionError: d") as caught:
        tiny_race(learner="mine:Hill").learner_of("pursuer")
    assert isinstance(caught.value.__cause__, ZeroDivisionError)
    (folder / "mine.py").write_text("import os\nos.no_such_name\n")
    with pytest.raises(co.PluginError, match="^mine:Hill: import: AttributeError: module 'os'"):
        tiny_race(learner="mine:Hill").learner_of("pursuer")
    # Workers send it to the main process.
    assert pickle.loads(pickle.dumps(caught.value)).args == caught.value.args  # noqa: S301


@pytest.mark.parametrize(
    "learner",
    [
        HillClimber(sigma=0.3),
        co.CmaEs(sigma=0.1),
        co.EvolutionStrategy(sigma=0.1, learning_rate=0.1, relative_sigma=0.4),
        co.EvolutionStrategy(sigma=0.1, learning_rate=0.1, relative_sigma=0.4, momentum=0.9),
        co.GeneticAlgorithm(elites=1, mutation=0.1),
    ],
)
def test_a_learner_that_keeps_all_promises(learner):
    # With numbers from the global generator a run would not be repeated by its seed.
    before = np.random.get_state()[1].copy()  # noqa: NPY002
    co.check_learner(learner)
    assert np.array_equal(np.random.get_state()[1], before)  # noqa: NPY002


@pytest.mark.parametrize("count", [1, 3])
def test_a_sampler_that_keeps_all_promises(count):
    for sampler in (
        Hardest(forget=0.2), opponents.Uniform(), opponents.SharedSampling(),
        opponents.Prioritized(decay=0.9), opponents.RoundRobin(), opponents.NewestAndOlder(),
    ):  # fmt: skip
        co.check_sampler(sampler, count=count)


EXITS = tiny_race(learner="own_code:Exits")


def changed(base=HillClimber, **methods):
    return dataclass(frozen=True)(type("Changed", (base,), methods))()


def asks(change):
    def ask(self, state, rng):
        candidates, asked = HillClimber.ask(self, state, rng)
        return change(candidates), asked

    return changed(ask=ask)


def tells(change):
    def tell(self, state, results):
        return change(HillClimber.tell(self, state, results))

    return changed(tell=tell)


def draws_otherwise(self, state, rng):
    return HillClimber.ask(self, state, np.random.default_rng())


def forgets(self, state, results):
    """Keep the step size in the class, as no checkpoint does."""
    type(self).kept = 0.9 * getattr(type(self), "kept", 0.1)
    return {**HillClimber.tell(self, state, results), "sigma": np.array(type(self).kept)}


def samples(*chosen):
    return changed(Oldest, sample=lambda *_: np.array(chosen, np.intp))


@pytest.mark.parametrize(
    ("broken", "message"),
    [
        (
            changed(ask=draws_otherwise),
            "expected equal results from equal generators, got others in ep",
        ),
        (changed(tell=forgets), "expected equal results from equal generators, got others in"),
        (InPlace(), "state: expected arrays that stay as they were, got some that change"),
        (asks(lambda asked: asked.astype(float)), r"ask: .*, got float64 \(4, "),
        (asks(lambda asked: asked.repeat(2, axis=0)), r"ask: .*, got float32 \(8, "),
        (asks(lambda asked: asked + np.float32(np.inf)), "ask: expected finite numbers"),
        (tells(lambda state: {**state, "x": np.array([{}])}), "state: expected an array of numb"),
        (tells(lambda state: {**state, "x": 3}), "state: expected an array of numbers or text"),
        (tells(lambda state: {**state, "a.x": np.zeros(1)}), "state: expected names such as sig"),
        (changed(genome=lambda self, state: state["genome"][:3]), "genome: expected an array of"),
        (changed(seed_groups=np.arange(4) // 3), "seed_groups: expected 4 numbers of groups fr"),
        (
            changed(untrained=lambda self, game, team, rng: np.zeros(140)),
            r"untrained: expected an array of float32 \(140,\), got float64",
        ),
        (changed(start=lambda self, task: [1]), "state: expected a dict or named tuple of arr"),
        (samples(1), r"sample: expected 1 to 1 different opponents from 0 to 0, got \[1\]"),
        (samples(0, 0), r"sample: expected 1 to 1 different opponents from 0 to 0, got \[0 0\]"),
        (samples(), r"sample: expected .* got \[\]"),
    ],
)
def test_a_broken_promise_is_named(broken, message):
    with pytest.raises(co.PluginError, match=f"^{message}"):
        (co.check_learner if isinstance(broken, HillClimber) else co.check_sampler)(broken)


@pytest.mark.parametrize("learner", [co.ActorCritic(), co.GeneticProgramming()])
def test_a_learner_of_pursuit_alone_is_not_checked(learner):
    expected = f"learner: expected one .*any_game.*, got {type(learner).__name__}"
    with pytest.raises(ValueError, match=f"^{expected}"):
        co.check_learner(learner)


def test_an_error_in_the_code_is_raised_as_it_is(monkeypatch, tmp_path):
    monkeypatch.setattr(Fails, "told", 0)
    with pytest.raises(ZeroDivisionError, match="^no luck$"):
        co.check_learner(Fails())
    with pytest.raises(KeyError, match="generation"):
        co.check_sampler(Crash())
    with pytest.raises(TypeError, match="^learner: expected a .*Learner, got 3"):
        co.check_learner(3)
    monkeypatch.setattr(Fails, "told", 0)
    with pytest.raises(ZeroDivisionError, match="^no luck") as caught:
        played(tiny_race(learner="own_code:Fails"), tmp_path / "run")
    if sys.version_info >= (3, 11):
        assert caught.value.__notes__ == [f"in stage 1 of the run {tmp_path / 'run'}"]
    assert co.Run(tmp_path / "run").training.stage == 0  # the last finished one
    for end in (partial(co.check_learner, Exits()), partial(played, EXITS, tmp_path / "exits")):
        with pytest.raises(co.PluginError, match="called exit"):  # it does not end the program
            end()
    with pytest.raises(
        co.PluginError, match=r"^ask of learner TooFew: .* float32 \(4, .* got .*\(3"
    ):
        played(tiny_race(learner="own_code:TooFew"), tmp_path / "few")
