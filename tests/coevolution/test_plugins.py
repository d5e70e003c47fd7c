"""Names of learners and samplers: what is accepted as data, and what an import finds."""

from __future__ import annotations

import json
import pickle
import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import own_code
from matrixworld.coevolution import (
    NoEffectError,
    PluginError,
    RaceSettings,
    check_learner,
    check_own_code,
    check_sampler,
)
from matrixworld.coevolution.plugins import (
    LEARNER,
    OPPONENT,
    Interface,
    OwnSettings,
    SavedName,
    find,
    installed,
)
from matrixworld.coevolution.settings import settings_from_json, settings_to_json
from tiny_race import tiny_race, tiny_single

OWN = {
    "schedule": "alternating",
    "learner": "own_code:HillClimber",
    "pursuers_meet": "own_code:Hardest",
}
SETTINGS = {"learner_settings": {"sigma": 0.2}, "pursuers_meet_settings": {"forget": 1}}


@pytest.fixture
def folder(tmp_path, monkeypatch):
    """A folder from which modules are imported."""
    monkeypatch.syspath_prepend(tmp_path)
    forget_modules()  # a test of another file may have imported its own
    yield tmp_path
    forget_modules()


def forget_modules():
    """Forget what tests of own code import."""
    for name in [n for n in sys.modules if n.partition(".")[0] in ("mine", "mypkg")]:
        del sys.modules[name]


@pytest.fixture
def package(folder):
    """An installed package with an entry point of each group."""
    (folder / "mypkg").mkdir()
    (folder / "mypkg" / "__init__.py").write_text("")
    (folder / "mypkg" / "mine.py").write_text("from own_code import HillClimber, Hardest\n")
    return declare(folder, "mypkg", {LEARNER: "hill", OPPONENT: "hardest"})


def declare(folder: Path, name: str, points: dict[Interface, str]) -> Path:
    """Write what an installer writes of a package with entry points."""
    objects = {"hill": "HillClimber", "hardest": "Hardest"}
    info = folder / f"{name}-1.0.dist-info"
    info.mkdir()
    (info / "METADATA").write_text(f"Metadata-Version: 2.1\nName: {name}\nVersion: 1.0\n")
    lines = [
        f"[{kind.group}]\n{point} = {name}.mine:{objects[point]}" for kind, point in points.items()
    ]
    (info / "entry_points.txt").write_text("\n".join(lines))
    return folder


# Names as data


def test_settings_import_nothing():
    settings = RaceSettings(learner="no.such:Learner", schedule="alternating", evaders_meet="no:S")
    assert settings.learner_name == "no.such:Learner"
    assert settings.sampler_name("evader") == "no:S"
    assert "no" not in sys.modules


@pytest.mark.parametrize(
    "name", ["gaa", "mine.Hill", ":Hill", "mine:", "my pkg:Hill", "1:H", "", 3, []]
)
def test_a_name_that_cannot_be_one_is_refused(name):
    with pytest.raises(
        ValueError, match="learner: expected one of es, ga, cma, actor-critic, or module:object"
    ):
        RaceSettings(learner=name)
    with pytest.raises(ValueError, match="pursuers_meet: expected one of latest, .* or module:obj"):
        RaceSettings(schedule="alternating", pursuers_meet=name)


def test_settings_of_own_code_are_compared_hashed_pickled_and_saved():
    settings = tiny_race(**OWN, **SETTINGS, evaders_meet="own_code:Fixed")
    values = json.loads(json.dumps(settings_to_json(settings)))
    assert values["learner_settings"] == {"sigma": 0.2}
    again = settings_from_json(RaceSettings, values)
    for same in (again, pickle.loads(pickle.dumps(settings)), replace(settings, seed=5)):  # noqa: S301
        assert same == settings
        assert hash(same) == hash(settings)
        assert repr(same) == repr(settings)
    assert replace(settings, learner_settings={"sigma": 0.3}) != settings


def test_settings_do_not_change_with_the_dictionary():
    given = {"sigma": 0.2}
    settings = tiny_single(learner="own_code:HillClimber", learner_settings=given)
    given["sigma"] = 7.0
    assert settings.learner_settings == {"sigma": 0.2}
    precise = tiny_single(
        learner="own_code:HillClimber", learner_settings={"sigma": np.float32(0.5), "n": np.int8(3)}
    )
    assert json.dumps(settings_to_json(precise)["learner_settings"]) == '{"n": 3, "sigma": 0.5}'
    with pytest.raises(TypeError, match="does not support item assignment"):
        settings.learner_settings["sigma"] = 7.0
    assert OwnSettings({"a": 1, "b": 2}) == OwnSettings({"b": 2, "a": 1})


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
def test_bad_settings_are_refused(given, error, message):
    with pytest.raises(error, match=f"^learner_settings: {message}"):
        tiny_race(learner="own_code:HillClimber", learner_settings=given)
    with pytest.raises(error, match=f"^pursuers_meet_settings: {message}"):
        tiny_race(**{**OWN, "pursuers_meet_settings": given})


def test_settings_without_effect_are_refused():
    with pytest.raises(NoEffectError, match="sigma: .* only with the learner es or cma$"):
        tiny_race(learner="own_code:HillClimber", sigma=0.2)
    with pytest.raises(NoEffectError, match="learner_settings: .* with a learner of your own$"):
        tiny_race(learner="ga", learner_settings={"sigma": 0.2})
    with pytest.raises(
        NoEffectError, match="evaders_meet_settings: .* sampler of your own for the"
    ):
        tiny_race(**OWN, evaders_meet="latest", evaders_meet_settings={"forget": 1})
    with pytest.raises(NoEffectError, match="archive_episodes: .* the samplers maxsolve"):
        tiny_race(**OWN, archive_episodes=5)


def test_names_in_files_are_data():
    values = settings_to_json(tiny_race())
    read = settings_from_json(RaceSettings, {**values, "learner": "annealing"})
    assert read.learner == "annealing"
    assert isinstance(read.learner, SavedName)
    assert replace(read, seed=9).learner == "annealing"
    with pytest.raises(ValueError, match="learner: expected one of es, .*'annealing'; install the"):
        check_own_code(read)


def test_files_without_these_settings_are_refused():
    values = settings_to_json(tiny_race())
    older = {name: value for name, value in values.items() if not name.endswith("_settings")}
    missing = r"missing fields \['evaders_meet_settings', 'learner_settings', 'pursuers_meet_sett"
    with pytest.raises(ValueError, match=missing):
        settings_from_json(RaceSettings, older)


# Imports


def test_entry_points(package):
    assert installed(LEARNER) == {"hill": ["mypkg.mine:HillClimber"]}
    settings = tiny_race(
        schedule="alternating", learner="hill", pursuers_meet="hardest", evaders_meet="hardest"
    )
    assert "mypkg" not in sys.modules
    check_own_code(settings)
    check_learner("hill")
    check_sampler("hardest")
    with pytest.raises(
        ValueError, match="expected one of es, ga, cma, actor-critic, hill, or module:object, got"
    ):
        tiny_race(learner="hil")


def test_two_packages_with_one_name(package):
    declare(package, "other", {LEARNER: "hill"})
    with pytest.raises(
        ValueError, match="one installed package with 'hill', got mypkg.mine:.*, ot"
    ):
        check_own_code(tiny_race(learner="hill"))


def test_a_package_cannot_replace_a_built_in_learner(package):
    (package / "mypkg-1.0.dist-info" / "entry_points.txt").write_text(
        f"[{LEARNER.group}]\nes = mypkg.mine:HillClimber\n"
    )
    check_own_code(tiny_race(learner="es"))
    assert "mypkg" not in sys.modules


@pytest.mark.parametrize(
    ("name", "message"),
    [
        (
            "nowhere.at:all",
            r"module that can be imported, got 'nowhere.at:all' \(No module named 'n",
        ),
        ("nowhere.at:all", "; install the package that has it, or put its folder on PYTHONPATH$"),
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
        (tiny_race(schedule="alternating", evaders_meet=name), "evaders_meet"),
    ]:
        with pytest.raises(ValueError, match=f"^{field}: .*{message}") as caught:
            check_own_code(settings)
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
    check_own_code(tiny_race(learner="mine:make", learner_settings={"tries": 2}, evader_epochs=2))
    with pytest.raises(ValueError, match="learner_settings: expected a value of tries"):
        check_own_code(tiny_race(learner="mine:make"))


def test_a_constructor_that_fails(folder):
    (folder / "mine.py").write_text(
        "from own_code import Fixed\ndef make(count, *, n=1) -> Fixed:\n    return [][n]\n"
    )
    settings = tiny_race(schedule="alternating", evaders_meet="mine:make")
    with pytest.raises(PluginError, match="evaders_meet mine:make: IndexError: list index"):
        check_own_code(settings)
    assert find("evaders_meet", "mine:make", (), OPPONENT).parameters.keys() == {"count", "n"}
    assert own_code.ANSWER == 42
