"""Learners and samplers of one's own: names as data, what an import finds, and kept promises."""

import json
import pickle
import sys
from pathlib import Path

import numpy as np
import pytest

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
from matrixworld.coevolution.own_code import LEARNER, OPPONENT, Interface, OwnSettings, installed
from matrixworld.coevolution.runs.start import check_own_code
from own_code import Crash, Fails, Fixed, Hardest, HillClimber, ReturnsViews
from tiny_race import alternating, tiny_race


@pytest.fixture
def folder(tmp_path, monkeypatch):
    """A folder from which modules are imported; a test of another file may have its own."""
    monkeypatch.syspath_prepend(tmp_path)
    for name in [n for n in sys.modules if n.partition(".")[0] in ("mine", "mypkg")]:
        monkeypatch.delitem(sys.modules, name)  # an earlier test may have imported its own
    yield tmp_path
    for name in [n for n in sys.modules if n.partition(".")[0] in ("mine", "mypkg")]:
        del sys.modules[name]


@pytest.fixture
def package(folder):
    """An installed package with an entry point of each group."""
    (folder / "mypkg").mkdir()
    (folder / "mypkg" / "mine.py").write_text("from own_code import HillClimber, Hardest\n")
    return declare(
        folder, "mypkg", {LEARNER: "hill = {}:HillClimber", OPPONENT: "hard = {}:Hardest"}
    )


def declare(folder: Path, name: str, points: dict[Interface, str]) -> Path:
    """Write what an installer writes of a package with entry points."""
    info = folder / f"{name}-1.0.dist-info"
    info.mkdir(exist_ok=True)
    (info / "METADATA").write_text(f"Metadata-Version: 2.1\nName: {name}\nVersion: 1.0\n")
    lines = [f"[{kind.group}]\n{point.format(f'{name}.mine')}" for kind, point in points.items()]
    (info / "entry_points.txt").write_text("\n".join(lines))
    return folder


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


def test_settings_do_not_change_with_the_dictionary():
    given = {"sigma": 0.2}
    learner = OwnLearnerSettings(code="own_code:HillClimber", settings=given)
    given["sigma"] = 7.0
    assert learner.settings == {"sigma": 0.2}
    precise = OwnLearnerSettings(code="a:B", settings={"sigma": np.float32(0.5), "n": np.int8(3)})
    plain = RaceSettings(learner=precise).to_json()
    assert json.dumps(plain["learner"]["settings"]) == '{"n": 3, "sigma": 0.5}'
    # Else the hash of the settings could change.
    with pytest.raises(TypeError, match="does not support item assignment"):
        learner.settings["sigma"] = 7.0
    assert OwnSettings({"a": 1, "b": 2}) == OwnSettings({"b": 2, "a": 1})


@pytest.mark.parametrize("section", [OwnLearnerSettings, OwnOpponents])
@pytest.mark.parametrize(
    ("given", "error", "message"),
    [
        ("sigma=0.1", TypeError, "expected values by name, such as {'sigma': 0.1}, got 's"),
        ({"sigma": [1]}, TypeError, r"expected a number, text, True or False as sigma, got \[1\]"),
        ({"sigma": None}, TypeError, ".* as sigma, got None"),
        ({"sigma": float("nan")}, ValueError, "expected a finite number as sigma, got nan"),
        ({1: 2}, ValueError, "expected names such as sigma, got 1"),
        ({"my sigma": 2}, ValueError, "expected names such as sigma, got 'my sigma'"),
    ],
)
def test_bad_settings_are_refused(section, given, error, message):
    with pytest.raises(error, match=f"^settings: {message}"):
        section(code="own_code:HillClimber", settings=given)


# Imports


def test_entry_points(package):
    assert installed(LEARNER) == {"hill": ["mypkg.mine:HillClimber"]}
    settings = alternating("hard", learner="hill")
    assert "mypkg" not in sys.modules
    check_own_code(settings)
    check_learner("hill")
    check_sampler("hard")
    with pytest.raises(ValueError, match="one of es, ga, cma, actor-critic, hill, or module:obj"):
        tiny_race(learner="hil")


def test_a_name_is_of_one_package_and_of_no_built_in_learner(package):
    declare(package, "other", {LEARNER: "hill = {}:HillClimber"})
    with pytest.raises(ValueError, match="one installed package with 'hill', got mypkg.mine:.*, o"):
        check_own_code(tiny_race(learner="hill"))
    declare(package, "mypkg", {LEARNER: "es = {}:HillClimber"})  # a name of ours: ours wins
    check_own_code(tiny_race(learner="es"))
    assert "mypkg" not in sys.modules


@pytest.mark.parametrize(
    ("name", "message"),
    [
        ("nowhere.at:all", r"got 'nowhere.at:all' \(No .*; install .* folder on PYTHONPATH$"),
        ("own_code.deeper:Hill", r"\(No module named 'own_code.deeper'; 'own_code' is not a pack"),
        ("own_code:Hil", "expected the name of an object in own_code, got 'Hil'"),
        ("own_code:HillClimber.Inner", "expected the name of an object in own_code, got 'HillC"),
        ("own_code:ANSWER", "expected a class with .*, or a function whose return .*, got own_c"),
        ("os:system", "return annotation is one, got os:system"),
        ("pathlib:Path", "expected a class with .*, got pathlib:Path"),
        ("own_code:unannotated", "expected a class with .*, got own_code:unannotated"),
    ],
)
def test_what_cannot_be_found_is_said(name, message):
    for settings, field in [
        (tiny_race(learner=name), "learner"),
        (tiny_race(schedule="alternating", evaders_meet=name), "opponent sampler"),
    ]:
        with pytest.raises(ValueError, match=f"^{field}: .*{message}") as caught:
            check_own_code(settings)
        # That would blame their code, which was never reached.
        assert not isinstance(caught.value, PluginError)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("import torch_that_is_missing\n", "ModuleNotFoundError: No module named 'torch_that_is_m"),
        ("def Hill(:\n", "SyntaxError: "),
        ("1 / 0\n", "ZeroDivisionError: division by zero"),
    ],
)
def test_a_module_that_fails_is_named_with_its_error(folder, text, message):
    (folder / "mine.py").write_text(text)
    with pytest.raises(PluginError, match=f"learner mine:Hill: import: {message}") as caught:
        check_own_code(tiny_race(learner="mine:Hill"))
    assert caught.value.__cause__ is not None
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


def test_a_constructor_that_fails(folder):
    (folder / "mine.py").write_text(
        "from own_code import Fixed\ndef make(count, *, n=1) -> Fixed:\n    return [][n]\n"
    )
    settings = tiny_race(schedule="alternating", evaders_meet="mine:make")
    with pytest.raises(PluginError, match="opponent sampler mine:make: IndexError: list index"):
        check_own_code(settings)


# Checks before the first run: what passes, and what is found


def strategy(genome, samples, rng, epochs, *, momentum=None):
    noise = NoiseTable(genome.size, rng, sigma=0.1)
    return EvolutionStrategy(genome, noise, samples=samples, anneal_over=epochs, momentum=momentum)


def algorithm(genomes, rng, *, elites=2, mutation=0.05):
    noise = NoiseTable(genomes.shape[1], rng, sigma=mutation)
    return GeneticAlgorithm(genomes, noise, elites=elites)


def climber(base=HillClimber, **methods):
    return type("Changed", (base,), methods)


def tell_in_place(self, fitness):  # allowed: no copy of the array was handed out
    self.genome[:] = self.candidates[int(np.argmax(fitness))]


@pytest.mark.parametrize(
    ("learner", "settings"),
    [
        (HillClimber, {}),
        ("own_code:HillClimber", {"sigma": 0.3, "shrink": 0.5}),
        (climber(tell=tell_in_place), {}),
        (ReturnsViews, {}),
        (CmaEs, {"sigma": 0.1}),
        (strategy, {}),
        (strategy, {"momentum": 0.9}),
        (lambda genome, samples, **own: HillClimber(genome, samples, **own), {"sigma": 1}),
        (algorithm, {"elites": 1}),
    ],
)
def test_a_learner_that_keeps_all_promises(learner, settings):
    check_learner(learner, settings)


@pytest.mark.parametrize(
    ("sampler", "settings"),
    [
        (Hardest, {"forget": 0.2}),
        ("own_code:Fixed", {}),
        (opponents.Latest, {}),
        (opponents.Uniform, {}),
        (opponents.RoundRobin, {}),
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


class NoTell:
    genome, seed_groups = np.zeros(20, np.float32), np.zeros(8, np.intp)
    ask = HillClimber.ask


OTHER_NOISE = climber(ask=lambda self, rng: HillClimber.ask(self, np.random.default_rng()))
FORGETS_SIGMA = climber(
    state=lambda self: {"genome": self.genome},
    restore=lambda self, state: setattr(self, "genome", state["genome"]),
)
# It continues equally, but its state is that of before.
RESTORES_HALF = climber(ReturnsViews, restore=HillClimber.restore)


@pytest.mark.parametrize(
    ("learner", "message"),
    [
        (OTHER_NOISE, "expected equal results from equal generators and results"),
        (FORGETS_SIGMA, "expected equal results after restore in a (new|used) one"),
        (RESTORES_HALF, "state: expected an equal one after restore in a used one"),
        (asks(lambda asked: asked.astype(float)), r"ask: .*, got float64 \(8, 20\)"),
        (asks(lambda asked: asked.repeat(2, axis=0)), r"ask: .*, got float32 \(16, 20\)"),
        (asks(lambda asked: asked + np.float32(np.inf)), "ask: expected finite numbers"),
        (states(lambda self: {"self": np.array([self])}), "state: expected an array of numbers"),
        (states(lambda self: {"a.mean": np.zeros(1)}), "state: expected names such as sigma"),
        (climber(tell=tell_and_regroup), "seed_groups: expected equal groups in all epochs"),
        (climber(__init__=begin_unevenly), "seed_groups: expected 8 numbers of groups from 0"),
        (NoTell, "expected genome, seed_groups, ask, .*, got no tell"),
        (Fails, "tell: ZeroDivisionError: no luck"),
    ],
)
def test_a_broken_promise_of_a_learner_is_named(learner, message):
    with pytest.raises(PluginError, match=rf"^learner [\w.]+:{learner.__name__}: {message}"):
        check_learner(learner)


def samples(*chosen):
    return type("Chosen", (Fixed,), {"sample": lambda *_: np.array(chosen, np.intp)})


UNSAVED = type("Unsaved", (Hardest,), {"state": lambda _: {}, "restore": lambda *_: None})


@pytest.mark.parametrize(
    ("sampler", "message"),
    [
        (samples(1), r"sample: expected 1 to 1 different opponents from 0 to 0, got \[1\]"),
        (samples(0, 0), r"sample: expected 1 to 1 different opponents from 0 to 0, got \[0, 0\]"),
        (samples(), r"sample: expected .* got \[\]"),
        (UNSAVED, "expected equal results after restore in a (new|used) one"),
        (Crash, "sample: KeyError: 'generation'"),
    ],
)
def test_a_broken_promise_of_a_sampler_is_named(sampler, message):
    with pytest.raises(PluginError, match=f":{sampler.__name__}: {message}"):
        check_sampler(sampler)


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
    with pytest.raises(ValueError, match=f":{learner.__name__}: {message}"):
        check_learner(learner, settings)


def test_nothing_is_drawn_from_the_global_generator():
    # A run would not be repeated by its seed.
    before = np.random.get_state()[1].copy()  # noqa: NPY002
    check_learner(HillClimber)
    check_sampler(Hardest)
    assert np.array_equal(np.random.get_state()[1], before)  # noqa: NPY002
