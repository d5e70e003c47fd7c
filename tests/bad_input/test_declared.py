"""Bad values that follow from what is declared: of all settings, and of all options of commands.

A new setting or option is tried without a line here. What two settings or options mean together
is tested where that rule stands. Sizes that the machine cannot hold are refused, too.
"""

import math
import re
from collections.abc import Mapping
from functools import cache
from typing import get_args, get_origin

import click
import numpy as np
import pytest

import matrixworld as mw
from matrixworld._util import checks
from matrixworld._util.checks import INT_MAX, shown
from matrixworld._util.constraints import OneOf, Range, Whole
from matrixworld._util.sections import (
    HELP,
    NAMES,
    OWN,
    Section,
    UnknownSettingError,
    classes_of,
    constraint_of,
    hints_of,
    named_type,
    settings_of,
)
from matrixworld.cli import main
from matrixworld.cli.evolve import evolve_command, job_of
from matrixworld.cli.options import given
from matrixworld.cli.setting_options import PATHS
from matrixworld.coevolution import RaceSettings, SettingError, evolve
from matrixworld.coevolution.settings.race_settings import MOST_SEED
from tiny_race import tiny_race

HUGE = (10**400, -(10**400), 10**5000, -(2**70))
NOT_FINITE = (math.nan, math.inf, -math.inf, np.float32("nan"), np.float64("-inf"))
NO_NUMBERS = ("1", "nan", None, [1], {}, True, np.True_, 1j, b"1", np.array([1.0]), object())
NO_TEXTS = (1, None, ["relu"], {}, True, object(), b"relu", math.nan)
NO_BOOLS = (0, 1, None, "true", np.True_, {}, np.ma.array([0.5], mask=[True]))
NO_TUPLES = ("32", {}, math.nan, None, True, object())
NO_SECTIONS = (3, ["es"], True, math.nan, object(), 1j, int)


def wrong_numbers(constraint):
    """Return numbers that a constraint forbids, each with what is expected in its place."""
    if isinstance(constraint, Whole):
        yield from ((value, "an integer") for value in (*NO_NUMBERS, *NOT_FINITE, 1.5))
        low = f"an integer of at least {constraint.least}"
        high = f"an integer of at most {constraint.most}"
        below = [constraint.least - 1, np.int64(constraint.least - 1)]
        yield from ((value, low) for value in (*below, *HUGE) if value < constraint.least)
        yield from ((value, high) for value in (constraint.most + 1, *HUGE) if value > 0)
        return
    yield from ((value, "a number") for value in NO_NUMBERS)
    tall = [value for value in HUGE if abs(value) > 10**308]
    yield from ((value, "a finite number") for value in (*NOT_FINITE, *tall))
    lower = f"a number {'above' if constraint.open else 'at least'} {constraint.least:g}"
    least = [] if constraint.least == -math.inf else [constraint.least]
    below = least if constraint.open else []
    below = [*below, *(each - step for each in least for step in (1e-6, 1, 1e300))]
    below += [np.nextafter(each, -math.inf) for each in least]
    above = [] if constraint.most == math.inf else [constraint.most + step for step in (1e-6, 1)]
    yield from ((value, lower) for value in (*below, *above))


def wrong_values(item, hint):
    """Return values that a field must not have, each with the beginning of what is expected."""
    base = named_type(hint)
    if base is not None:
        found = [(value, "") for value in (*NO_SECTIONS, "no kind", {"kind": "none of these"})]
        return [*found, (None, "")]
    constraint = constraint_of(item, hint)
    if isinstance(constraint, Whole | Range):
        return [*wrong_numbers(constraint)]
    if isinstance(constraint, OneOf):
        expected = f"one of {', '.join(constraint.choices)}"
        return [(value, expected) for value in (*NO_TEXTS, "no choice", "")]
    if get_origin(hint) is tuple:
        values = [*NO_TUPLES]
        if int in get_args(hint):
            values += [(0,), (1.5,), (math.nan,), 0, (-1,), (10**400,), (True,), [None], [[1]]]
        elif str in get_args(hint):
            values += [(0,), 0, [None], [["a"]]]
        else:
            values += [3, (3,), [None], ["no world"], [{"nothing": 1}], [[]]]
        return [(value, "") for value in values]
    if get_origin(hint) is Mapping:
        names = ({1: 2}, {"my rate": 2})
        unfit = ({"rate": value} for value in (object(), [1], None, *NOT_FINITE, 1j))
        values = [(value, "values by name, such as") for value in (3, "text", None, [1])]
        values += [(value, "names such as sigma") for value in names]
        return [*values, *((value, "a finite number, text, True or False") for value in unfit)]
    if bool in {hint, *get_args(hint)}:
        return [(value, "True or False") for value in NO_BOOLS]
    return [(value, "a text") for value in NO_TEXTS]


def accepts_none(hint):
    return type(None) in get_args(hint)


def check_refused(make, path, value, expected):
    """Check the error that a call raises for a value: what it is, and what it says."""
    with pytest.raises(SettingError) as caught:
        make()
    error = caught.value
    assert isinstance(error, ValueError)
    assert isinstance(error, TypeError)
    told = str(error)
    # Of a sequence or a mapping the message may tell which part is bad.
    assert re.match(rf"{re.escape(path)}(\.\w+)*: expected \S", told), (value, told)
    assert f": expected {expected}" in told, (value, told)
    assert len(told) < 700, told
    if isinstance(error, UnknownSettingError):
        return
    assert ", got " in told, (value, told)
    if expected:  # else a part of the value is told alone
        plain = value.tolist() if isinstance(value, np.ndarray) else value
        given = (shown(as_python(value)), shown(plain))
        assert told.partition(", got ")[2].startswith(given), (value, told)
    if "at least" in told and expected:
        for most in (MOST_SEED, INT_MAX):
            assert str(most) not in told.partition(", got ")[0], told


def as_python(value):
    """Return a value, and those of a mapping, as files hold them."""
    if isinstance(value, dict):
        return {name: as_python(part) for name, part in value.items()}
    return value.item() if isinstance(value, np.number) else value


# ---- Sections that are made by themselves --------------------------------------------------------


@cache
def sections(cls=RaceSettings):
    """Return the classes of all sections that settings can hold."""
    found = {cls: None}
    for hint in hints_of(cls).values():
        base = named_type(hint)
        if base is not None and issubclass(base, Section):
            found |= dict.fromkeys(part for each in classes_of(base) for part in sections(each))
    return [*found]


FIELDS = [
    pytest.param(cls, item, id=f"{cls.__name__}.{item.name}")
    for cls in sections()
    for item in settings_of(cls)
]


def test_all_sections_are_found():
    """Also those that this module does not know by name."""
    found = {cls.kind for cls in sections()}
    for base, names in NAMES.items():
        if issubclass(base, Section):
            assert {named.make.kind for named in names.values()} <= found, base
    assert len(FIELDS) > 80


@pytest.mark.parametrize(("cls", "item"), FIELDS)
def test_a_bad_setting_is_refused_by_its_name(cls, item):
    needed = {"code": "module:object"} if "code" in hints_of(cls) else {}
    hint = hints_of(cls)[item.name]
    wrong = wrong_values(item, hint)
    assert len(wrong) > 2
    for value, expected in wrong:
        if value is None and accepts_none(hint):
            continue
        values = {**needed, item.name: value}
        check_refused(lambda values=values: cls(**values), item.name, value, expected)


# ---- The same values in settings of a race -------------------------------------------------------


def paths(cls=RaceSettings, path="", chosen=()):
    """Yield path, choices that a setting needs, class and field of all settings of a race."""
    for item in settings_of(cls):
        here = f"{path}{item.name}"
        yield here, dict(chosen), item, hints_of(cls)[item.name]
        base = named_type(hints_of(cls)[item.name])
        if base is None or not issubclass(base, Section):
            continue
        for kind in classes_of(base):
            name = "module:object" if kind.kind == OWN else kind.kind
            if here == "game":
                inner, more = ("", ()) if kind.kind != OWN else (None, ())
            else:
                inner, more = f"{here}.", ((here, name),)
            if inner is not None:  # a game of your own is imported when its name is known
                yield from paths(kind, inner, (*chosen, *more))


ALL = [pytest.param(*each, id=" ".join([each[0], *map(str, each[1].values())])) for each in paths()]


@pytest.mark.parametrize(("path", "choices", "item", "hint"), ALL)
def test_the_message_begins_with_the_path(path, choices, item, hint):
    for value, expected in wrong_values(item, hint):
        if value is None or isinstance(value, dict):
            continue  # None takes back a choice; parts of a mapping have paths of their own
        values = {**choices, path: value}
        check_refused(lambda values=values: RaceSettings.of(values), path, value, expected)


@pytest.mark.parametrize(("path", "choices", "item", "hint"), ALL)
def test_a_mapping_is_no_single_value(path, choices, item, hint):
    if named_type(hint) is not None:
        mappings = [{"kind": "none of these"}, {"nothing": 1}]
    elif get_origin(hint) is Mapping:
        mappings = [{"my rate": 2}, {"rate": object()}, {"rate": math.inf}, {"rate": 1j}]
    else:
        mappings = [{"a": 1}, {"a": {"b": 1}}]
    for value in mappings:
        with pytest.raises(SettingError) as caught:
            RaceSettings.of({**choices, path: value})
        assert str(caught.value).startswith(path), (value, caught.value)
        assert ": expected " in str(caught.value), (value, caught.value)


OF_WORLD = {
    "rules": ("Q", object(), math.nan, 1j, -1, [1]),
    "rewards": ("Q", object(), math.nan, 1j, -1, [1]),
    "diagonal": NO_BOOLS[:4],
    "obstacles": (object(), math.nan, 1.0, -0.5, 1j, 10**400, [[]], ["..", "."]),
}
NO_SIZES = (-1, 0, 1.5, "1", math.nan, math.inf, 1j, True, [1], object(), *HUGE)
"""Of all other fields of a world."""


@pytest.mark.parametrize("path", [f"world.{name}" for name in HELP[mw.WorldConfig]])
def test_fields_of_a_world_are_refused_by_their_paths(path):
    # Bad obstacles are told as those of a map, or as a density.
    where = "world" if path == "world.obstacles" else path
    for value in OF_WORLD.get(path.removeprefix("world."), NO_SIZES):
        if value is not None:
            check_refused(lambda value=value: RaceSettings.of({path: value}), where, value, "")


def accepted(choices):
    """Return whether settings are made of choices."""
    try:
        RaceSettings.of(choices)
    except SettingError:
        return False
    return True


def test_an_empty_mapping_is_refused_where_a_single_value_belongs():
    """It says nothing, and so it would be a mistake that nobody is told of."""
    single = [
        (path, choices)
        for path, choices, _, hint in paths()
        if named_type(hint) is None and get_origin(hint) is not Mapping
    ]
    assert {path for path, choices in single if accepted({**choices, path: {}})} == set()


UNKNOWN = (
    "nothing", "wrold.rows", "world.nothing", "learner.nothing", "learner.sigma.more", "schedule.x",
    "policy.nothing", "schedule.evader_learner.nothing", "schedule.pursuers_meet.nothing", "game.x",
)  # fmt: skip


@pytest.mark.parametrize("path", UNKNOWN)
@pytest.mark.parametrize("value", [3, {"a": 1}, "es"])
def test_unknown_paths_are_refused(path, value):
    with pytest.raises(SettingError, match="expected") as caught:
        RaceSettings.of({"schedule.evader_learner": "ga", path: value})
    told = caught.value.path
    assert path.startswith(told) or told.startswith(path)


def test_an_unknown_setting_is_told_with_all_that_there_are():
    with pytest.raises(SettingError) as caught:
        RaceSettings.of({"nothing": 3})
    named = re.findall(r"\w+", caught.value.expected)
    assert {path.partition(".")[0] for path in RaceSettings().values()} - {*named} == set()


@pytest.mark.parametrize("value", [None, {}])
def test_unknown_paths_are_refused_without_a_value(value):
    """None takes back a choice; of a path that is nowhere it is a mistake, too."""
    learner = {"schedule.evader_learner": "ga"}
    assert [path for path in UNKNOWN if accepted({**learner, path: value})] == []


# ---- Options of commands -------------------------------------------------------------------------


def wrong_words(kind):
    """Return words that a parameter of a type must not have, each with what is then said."""
    if isinstance(kind, click.Choice):
        return [("no choice", "is not one of"), ("", "is not one of")]
    if not isinstance(kind, click.types.IntParamType | click.types.FloatParamType):
        return []
    is_integer = isinstance(kind, click.types.IntParamType)
    no_number = "is not a valid integer" if is_integer else "is not a valid float"
    wrong = [(word, no_number) for word in ("x", "", "1,5", "0x1", "1j", "true")]
    if is_integer:
        wrong += [(word, no_number) for word in ("1.5", "nan", "inf", "1e3")]
    for end, is_open, sign, words in (
        ("min", "min_open", -1, "at least"),
        ("max", "max_open", 1, "at most"),
    ):
        limit = getattr(kind, end, None)
        if limit is not None:
            step = 1 if is_integer else 1e-6
            beyond = limit if getattr(kind, is_open) else limit + sign * step
            for value in (beyond, sign * 2**70, sign * 10**400):
                wrong.append((str(value), f"expected an integer of {words} {limit}"))
    return wrong


PARAMETERS = [
    pytest.param(command, param, id=f"{name} {param.opts[0]}")
    for name, command in main.commands.items()
    for param in command.params
    if wrong_words(param.type)
]


@pytest.mark.parametrize(("command", "param"), PARAMETERS)
def test_a_bad_word_is_refused_by_the_name_of_its_option(command, param):
    for word, expected in wrong_words(param.type):
        words = ["--", word] if isinstance(param, click.Argument) else [f"{param.opts[0]}={word}"]
        with pytest.raises(click.UsageError) as caught:
            command.make_context("command", words)
        assert getattr(caught.value, "param", None) is param, (word, caught.value)
        told = caught.value.format_message()
        assert f"'{param.opts[0]}'" in told, (word, told)
        assert word[:50] in told, (word, told)
        assert expected in told, (word, told)
        assert ("at least" in expected) <= (str(MOST_SEED) not in told), (word, told)


OF_SETTINGS = [
    param
    for param in evolve_command.params
    if param.name in PATHS and (param.type is click.INT or not wrong_words(param.type))
]
"""Options whose values are checked as those of settings."""


@pytest.mark.parametrize("param", OF_SETTINGS, ids=lambda param: param.opts[0])
def test_a_bad_value_of_a_setting_is_refused_by_the_name_of_its_option(param):
    is_number = param.type is click.INT
    words = ["-1", "0", str(-(10**400)), str(10**400)] if is_number else ["", "no choice", "nan"]
    for word in words:
        context = evolve_command.make_context("evolve", [f"{param.opts[0]}={word}"])
        with context, pytest.raises(click.UsageError) as caught:
            job_of(given(context.params))
        told = caught.value.format_message()
        begin = "learner" if param.name == "learner" else param.opts[0]
        assert told.startswith(f"{begin}: expected "), (word, told)
        # The name of a variant may be written in small letters.
        assert told.lower().partition(", got ")[2].strip("'").startswith(word[:50]), (word, told)
        assert (word.startswith("-")) <= (str(MOST_SEED) not in told), (word, told)


MANY = 2**31 - 1  # the largest number that is accepted where sizes are ints
GB = 10**9
TOO_LARGE = {
    "networks": tiny_race(hidden=(2**20, 2**20)),
    "population": tiny_race(population=2**31 - 2),
    "generations": tiny_race(generations=MANY),
    "episodes": tiny_race(evaluation_episodes=MANY),
}
"""Jobs by the setting to make smaller."""


@pytest.mark.parametrize("settings", TOO_LARGE.values(), ids=TOO_LARGE)
def test_a_job_that_is_too_large_is_refused_with_an_estimate(settings, tmp_path, monkeypatch):
    monkeypatch.setattr(checks, "available_memory", lambda: GB // 2)
    with pytest.raises(checks.OutOfMemoryError, match="expected .*at most 0.5 GB.* got .* GB"):
        evolve(settings, tmp_path / "job")
    assert list(tmp_path.iterdir()) == []
    monkeypatch.setattr(checks, "available_memory", lambda: None)
    checks.check_memory("all", bytes=10**30)  # where memory is unknown nothing is refused


def test_what_else_is_too_large_fails_as_in_numpy():
    giant = mw.Network((2**20, 2**20))
    with pytest.raises(MemoryError, match="Unable to allocate"):
        giant.initial(np.random.default_rng(0))
    with pytest.raises(MemoryError):
        mw.Batch(MANY, mw.WorldConfig(rows=60, cols=60))
