"""Bad values that follow from what is declared: of all settings, and of all options of commands.

A new setting or option is tried without a line here. What two settings or options mean together
is tested where that rule stands. Sizes that the machine cannot hold are refused, too.
"""

import math
from collections.abc import Mapping
from dataclasses import fields
from typing import get_args, get_origin

import click
import numpy as np
import pytest

import matrixworld as mw
from matrixworld._util import checks
from matrixworld.cli import main
from matrixworld.coevolution import RaceSettings, evolve
from matrixworld.coevolution.sections import hints_of, sections_in
from matrixworld.world.config import WorldConfig
from tiny_race import tiny_race

NO_NUMBERS = ("1", None, [1], {}, True, np.True_, 1j, b"1")
NO_INTEGERS = (*NO_NUMBERS, 1.5, math.nan, math.inf, 10**400)
NO_FLOATS = (*NO_NUMBERS, math.nan, math.inf, -math.inf, 10**400)
NO_TEXTS = (1, None, ["relu"], {}, True, object())
NO_BOOLS = (0, 1, None, "true", np.True_, np.ma.array([0.5], mask=[True]))


def sections(cls=RaceSettings):
    """Yield the classes of all sections that settings can hold."""
    yield cls
    for hint in hints_of(cls).values():
        for part in dict.fromkeys(sections_in(hint).values()):
            yield from sections(part)


def beyond(item, step):
    """Return the numbers next to the declared limits of a field, outside of them."""
    least, most, positive = item.metadata["limits"]
    low = least if positive and least == 0 else least - step
    return [low] + ([most + step] if most != math.inf else [])


def wrong_values(item, hint):
    """Return values that a field must not have, by its type, limits and choices."""
    accepted = {hint, *get_args(hint)}
    if sections_in(hint):
        wrong = [3, ["es"], {"kind": "none of these"}, {"none of these": 1}, "no kind"]
    elif hint is WorldConfig:
        wrong = ["O", 3, {"none of these": 1}]
    elif get_origin(hint) is tuple and str in get_args(hint):
        wrong = ["32", (0,), 0, {}, math.nan]
    elif get_origin(hint) is tuple:
        wrong = ["32", (0,), (1.5,), 0, {}, math.nan]
    elif get_origin(hint) is Mapping:
        unfit = (object(), [1], None, math.nan)
        wrong = [3, "text", {1: 2}, {"my rate": 2}, *({"rate": each} for each in unfit)]
    elif bool in accepted:
        wrong = [*NO_BOOLS]
    elif int in accepted:
        wrong = [*NO_INTEGERS, *beyond(item, 1)]
    elif float in accepted:
        wrong = [*NO_FLOATS, *beyond(item, 1e-6)]
    else:
        wrong = [*NO_TEXTS, *(["no choice", ""] if item.metadata["choices"] else [])]
    if type(None) in accepted or item.metadata["by_race"]:
        wrong = [value for value in wrong if value is not None]  # the default
    return wrong


FIELDS = [
    pytest.param(cls, item, id=f"{cls.__name__}.{item.name}")
    for cls in dict.fromkeys(sections())
    for item in fields(cls)
]


@pytest.mark.parametrize(("cls", "item"), FIELDS)
def test_a_bad_setting_is_refused_by_its_name(cls, item):
    needed = {"code": "module:object"} if "code" in hints_of(cls) else {}
    wrong = wrong_values(item, hints_of(cls)[item.name])
    assert len(wrong) > 2
    for value in wrong:
        with pytest.raises((TypeError, ValueError)) as caught:
            cls(**{**needed, item.name: value})
        assert type(caught.value) in (TypeError, ValueError)
        told = str(caught.value)
        assert told.startswith(item.name), (value, told)
        assert ": expected " in told, (value, told)


@pytest.mark.parametrize("name", [item.name for item in fields(RaceSettings)])
def test_the_message_begins_with_the_path(name):
    kinds = sections_in(hints_of(RaceSettings)[name])
    for kind, cls in kinds.items():
        for item in fields(cls) if kind != "own" else ():
            [value, *_] = wrong_values(item, hints_of(cls)[item.name])
            values = {name: kind} if kind else {}
            with pytest.raises((TypeError, ValueError), match=rf"^{name}\.{item.name}.*: expected"):
                RaceSettings.of({**values, f"{name}.{item.name}": value})


def wrong_words(kind):
    """Return words that a parameter of a type must not have."""
    if isinstance(kind, click.Choice):
        return ["no choice", ""]
    if not isinstance(kind, click.types.IntParamType | click.types.FloatParamType):
        return []
    wrong = ["x", "", "1,5", "0x1"]
    step = 1 if isinstance(kind, click.types.IntParamType) else 1e-6
    wrong += ["1.5", "nan", "inf"] if step == 1 else []
    for end, is_open, sign in (("min", "min_open", -1), ("max", "max_open", 1)):
        limit = getattr(kind, end, None)
        if limit is not None:
            wrong.append(str(limit if getattr(kind, is_open) else limit + sign * step))
    return wrong


PARAMETERS = [
    pytest.param(command, param, id=f"{name} {param.opts[0]}")
    for name, command in main.commands.items()
    for param in command.params
    if wrong_words(param.type)
]


@pytest.mark.parametrize(("command", "param"), PARAMETERS)
def test_a_bad_word_is_refused_by_the_name_of_its_option(command, param):
    for word in wrong_words(param.type):
        words = ["--", word] if isinstance(param, click.Argument) else [f"{param.opts[0]}={word}"]
        with pytest.raises(click.UsageError) as caught:
            command.make_context("command", words)
        assert getattr(caught.value, "param", None) is param, (word, caught.value)
        told = caught.value.format_message()
        assert f"'{param.opts[0]}'" in told, (word, told)
        assert word in told, (word, told)


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
