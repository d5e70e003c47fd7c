"""Learners and samplers of your own: names as data, what an import finds, and kept promises."""

import pickle
import sys

import numpy as np
import pytest
from matrixworld.coevolution.runs import check_own_code

from matrixworld.coevolution import (
    CmaEs,
    EvolutionStrategy,
    GeneticAlgorithm,
    NoiseTable,
    OwnLearnerSettings,
    OwnOpponents,
    PluginError,
    RaceSettings,
    check_learner,
    check_sampler,
    opponents,
)
from own_code import Crash, Fails, Fixed, Hardest, HillClimber, ReturnsViews
from tiny_race import tiny_race


@pytest.fixture
def folder(tmp_path, monkeypatch):
    """A folder from which `mine` is imported; a test of another file may have its own."""
    monkeypatch.syspath_prepend(tmp_path)
    monkeypatch.delitem(sys.modules, "mine", raising=False)
    yield tmp_path
    sys.modules.pop("mine", None)


# Names as data


def test_settings_import_nothing():
    settings = RaceSettings.of(
        {"learner": "no.such:Learner", "schedule": "alternating", "schedule.evaders_meet": "no:S"}
    )
    assert settings.learner.code == "no.such:Learner"
    assert settings.schedule.evaders_meet.code == "no:S"
    assert "no" not in sys.modules


@pytest.mark.parametrize("name", ["gaa", "mine.Hill", ":Hill", "mine:", "my pkg:Hill", "1:H", ""])
def test_a_name_that_cannot_be_one_is_refused(name):
    for path in ("learner", "schedule.pursuers_meet"):
        with pytest.raises(ValueError, match=f"^{path}: expected one of .*, or module:object, got"):
            RaceSettings.of({path: name})


def test_a_class_stands_for_its_name():
    given = {"sigma": np.float32(0.5), "shrink": 1}
    named = OwnLearnerSettings(code="own_code:HillClimber", settings=given)
    assert OwnLearnerSettings(code=HillClimber, settings={"shrink": 1, "sigma": 0.5}) == named
    assert RaceSettings(learner=HillClimber) == RaceSettings.of({"learner": "own_code:HillClimber"})
    met = RaceSettings.of({"schedule.evaders_meet": Fixed}).schedule.evaders_meet
    assert met == OwnOpponents(code=Fixed)
    given["sigma"] = 7.0
    assert named.to_json()["settings"] == {"shrink": 1, "sigma": 0.5}
    with pytest.raises(ValueError, match="^code: expected a class or function of a module, got <c"):
        OwnLearnerSettings(code=climber())  # no import finds it again


@pytest.mark.parametrize(
    "given",
    ["sigma=0.1", {"sigma": [1]}, {"sigma": None}, {"sigma": float("nan")}, {1: 2}, {"my s": 2}],
)
def test_bad_settings_are_refused(given):
    with pytest.raises((TypeError, ValueError), match="^settings: expected "):
        OwnOpponents(code="own_code:HillClimber", settings=given)


# Imports


@pytest.mark.parametrize(
    ("name", "message"),
    [
        ("nowhere.at:all", r"got 'nowhere.at:all' \(No .*; install .* folder on PYTHONPATH$"),
        ("own_code.deeper:Hill", r"\(No module named 'own_code.deeper'; 'own_code' is not a pack"),
        ("own_code:HillClimber.Inner", "expected the name of an object in own_code, got 'HillC"),
        ("own_code:ANSWER", "expected a class with .*, or a function whose return .*, got own_c"),
        ("os:system", "return annotation is one, got os:system"),
        ("own_code:unannotated", "expected a class with .*, got own_code:unannotated"),
    ],
)
def test_what_cannot_be_found_is_said(name, message):
    for settings, field in [
        (tiny_race(learner=name), "learner"),
        (tiny_race(schedule="alternating", evaders_meet=name), "opponent sampler"),
    ]:
        with pytest.raises(ValueError, match=f"^{field}: .*{message}"):
            check_own_code(settings)


def test_a_module_or_a_constructor_that_fails_is_named_with_its_error(folder):
    (folder / "mine.py").write_text(
        "from own_code import Fixed\ndef make(count, *, n=1) -> Fixed:\n    return [][n]\n"
    )
    settings = tiny_race(schedule="alternating", evaders_meet="mine:make")
    with pytest.raises(PluginError, match="opponent sampler mine:make: IndexError: list index"):
        check_own_code(settings)
    del sys.modules["mine"]
    (folder / "mine.py").write_text("1 / 0\n")
    with pytest.raises(PluginError, match="mine:Hill: import: ZeroDivisionError: d") as caught:
        check_own_code(tiny_race(learner="mine:Hill"))
    assert isinstance(caught.value.__cause__, ZeroDivisionError)
    # Workers send it to the main process.
    assert pickle.loads(pickle.dumps(caught.value)).args == caught.value.args  # noqa: S301


def test_inner_classes_and_functions(folder):
    (folder / "mine.py").write_text(
        "import own_code\n"
        "class Box:\n    Hill = own_code.HillClimber\n"
        "def make(genome, samples, epochs, rng, tries: int) -> own_code.HillClimber:\n"
        "    assert (samples, epochs) == (4, 4), (samples, epochs)\n"
        "    return own_code.HillClimber(genome, samples, sigma=rng.random() + tries)\n"
    )
    check_own_code(tiny_race(learner="mine:Box.Hill"))
    check_own_code(tiny_race(learner="mine:make", settings={"tries": 2}, evader_epochs=2))
    with pytest.raises(ValueError, match=r"mine:make: .* \(tries\), got {} \(missing .* 'tries'\)"):
        check_own_code(tiny_race(learner="mine:make"))


# Checks before the first run: what passes, and what is found


def strategy(genome, samples, rng, epochs, *, momentum=None):
    noise = NoiseTable(genome.size, rng, sigma=0.1)
    return EvolutionStrategy(genome, noise, samples=samples, anneal_over=epochs, momentum=momentum)


def algorithm(genomes, rng, *, elites=2, mutation=0.05):
    noise = NoiseTable(genomes.shape[1], rng, sigma=mutation)
    return GeneticAlgorithm(genomes, noise, elites=elites)


def climber(base=HillClimber, **methods):
    class Changed(base):
        pass

    for name, method in methods.items():
        setattr(Changed, name, method)
    return Changed


@pytest.mark.parametrize(
    ("learner", "settings"),
    [
        ("own_code:HillClimber", {"sigma": 0.3, "shrink": 0.5}),
        (CmaEs, {"sigma": 0.1}),
        (strategy, {"momentum": 0.9}),
        (lambda genome, samples, **own: HillClimber(genome, samples, **own), {"sigma": 1}),
        (algorithm, {"elites": 1}),
    ],
)
def test_a_learner_that_keeps_all_promises(learner, settings):
    # With numbers from the global generator a run would not be repeated by its seed.
    before = np.random.get_state()[1].copy()  # noqa: NPY002
    check_learner(learner, settings)
    assert np.array_equal(np.random.get_state()[1], before)  # noqa: NPY002


@pytest.mark.parametrize(
    ("sampler", "settings"),
    [
        ("own_code:Hardest", {"forget": 0.2}),
        (opponents.Uniform, {}),
        (opponents.SharedSampling, {}),
        (opponents.Prioritized, {"decay": 0.9}),
        (lambda count: opponents.ArchiveSampler(opponents.IPCA(), count), {}),
    ],
)
@pytest.mark.parametrize("count", [1, 3])
def test_a_sampler_that_keeps_all_promises(sampler, settings, count):
    check_sampler(sampler, settings, count=count)


def asks(change):
    return climber(ask=lambda self, rng: change(HillClimber.ask(self, rng)))


def states(change):
    return climber(state=lambda self: HillClimber.state(self) | change(self))


def tell_and_regroup(self, fitness):
    HillClimber.tell(self, fitness)
    self.seed_groups = np.arange(len(fitness))


def begin_unevenly(self, genome, samples):
    HillClimber.__init__(self, genome, samples)
    self.seed_groups[0] = 1


OTHER_NOISE = climber(ask=lambda self, rng: HillClimber.ask(self, np.random.default_rng()))
FORGETS_SIGMA = climber(
    state=lambda self: {"genome": self.genome},
    restore=lambda self, state: setattr(self, "genome", state["genome"]),
)


@pytest.mark.parametrize(
    ("learner", "message"),
    [
        (OTHER_NOISE, "expected equal results from equal generators and results"),
        (FORGETS_SIGMA, "expected equal results after restore in a (new|used) one"),
        (ReturnsViews, "state: expected copies, got arrays that change afterwards"),
        (asks(lambda asked: asked.astype(float)), r"ask: .*, got float64 \(8, 20\)"),
        (asks(lambda asked: asked.repeat(2, axis=0)), r"ask: .*, got float32 \(16, 20\)"),
        (asks(lambda asked: asked + np.float32(np.inf)), "ask: expected finite numbers"),
        (states(lambda self: {"self": np.array([self])}), "state: expected an array of numbers"),
        (states(lambda self: {"a.mean": np.zeros(1)}), "state: expected names such as sigma"),
        (climber(tell=tell_and_regroup), r"seed_groups: expected \[0 .* in all epochs, got"),
        (climber(__init__=begin_unevenly), "seed_groups: expected 8 numbers of groups from 0"),
    ],
)
def test_a_broken_promise_of_a_learner_is_named(learner, message):
    with pytest.raises(PluginError, match=f"^{message}"):
        check_learner(learner)


def samples(*chosen):
    return type("Chosen", (Fixed,), {"sample": lambda *_: np.array(chosen, np.intp)})


UNSAVED = type("Unsaved", (Hardest,), {"state": lambda _: {}, "restore": lambda *_: None})


@pytest.mark.parametrize(
    ("sampler", "message"),
    [
        (samples(1), r"sample: expected 1 to 1 different opponents from 0 to 0, got \[1\]"),
        (samples(0, 0), r"sample: expected 1 to 1 different opponents from 0 to 0, got \[0 0\]"),
        (samples(), r"sample: expected .* got \[\]"),
        (UNSAVED, "expected equal results after restore in a (new|used) one"),
    ],
)
def test_a_broken_promise_of_a_sampler_is_named(sampler, message):
    with pytest.raises(PluginError, match=f"^{message}"):
        check_sampler(sampler)


def test_an_error_in_the_code_is_raised_as_it_is():
    with pytest.raises(ZeroDivisionError, match="^no luck$"):
        check_learner(Fails)
    with pytest.raises(KeyError, match="generation"):
        check_sampler(Crash)


@pytest.mark.parametrize(
    ("learner", "settings", "message"),
    [
        (HillClimber, {"sgima": 0.1}, r"expected its settings \(sigma, shrink\), got {'sg"),
        (HillClimber, {"samples": 9}, "expected its settings .* 'samples'"),
        (HillClimber, {"sigma": -1}, "expected settings that it accepts, got"),
        (CmaEs, {}, r"expected its settings \(sigma\), got {} \(missing .* 'sigma'\)"),
    ],
)
def test_settings_are_those_of_the_signature(learner, settings, message):
    with pytest.raises(ValueError, match=f"^learner {learner.__name__}: {message}"):
        check_learner(learner, settings)
