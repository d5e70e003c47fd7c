"""Sections of settings: frozen dataclasses whose fields check themselves, and their JSON.

A section is a part of `RaceSettings`, such as the settings of one learner. Each field is declared
once, by `setting`: its default, its help text and its limits. A field may hold one of several
sections, as a type such as ``EvolutionStrategySettings | GeneticAlgorithmSettings`` says; in files
the ``kind`` of a section tells them apart. A text stands for the section of that kind, a mapping
for one with these fields. A setting that would have no effect has no place there.
"""

from __future__ import annotations

import math
import os
import re
import sys
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import Field, dataclass, field, fields, replace
from functools import cache
from importlib import import_module
from inspect import cleandoc
from operator import attrgetter
from types import NoneType
from typing import Any, ClassVar, NamedTuple, TypeVar, get_args, get_origin, get_type_hints

import numpy as np
from typing_extensions import dataclass_transform

from matrixworld._util import checks

AnySection = TypeVar("AnySection", bound="Section")


class Plain(NamedTuple):
    """How a field holds a class that has `to_json`, but is no section; a text is its ``kind``."""

    read: Callable[[Mapping[str, Any]], Any]
    help: Mapping[str, str]  # by field


PLAIN: dict[type, Plain] = {}  # classes of fields that are no sections, such as worlds


def setting(
    default: Any,
    text: str,
    *,
    by_race: bool = False,
    choices: Collection[str] = (),
    least: float = 0,
    most: float = math.inf,
    positive: bool = False,
) -> Any:
    """Return a field of a section: its default, what it means, and its legal texts or numbers.

    One `by_race` is None until `RaceSettings` knows the kind of race and the learner.
    """
    metadata = {
        "help": text, "default": default, "by_race": by_race, "choices": choices,
        "limits": (least, most, positive),
    }  # fmt: skip
    if isinstance(default, dict):  # which has no hash: equal sections have equal ones nevertheless
        return field(default_factory=dict, hash=False, metadata=metadata)
    return field(default=None if by_race else default, metadata=metadata)


def by_race(default: Any, text: str, **limits: Any) -> Any:
    """Return a `setting` whose default may be another one, by kind of race and learner."""
    return setting(default, text, by_race=True, **limits)


@dataclass_transform(frozen_default=True)
def section(cls: type[AnySection]) -> type[AnySection]:
    """Make a class a frozen dataclass whose docstring has the help texts of its fields."""
    cls = dataclass(frozen=True)(cls)
    lines = [cleandoc(cls.__doc__ or ""), *["", "Parameters", "----------"] * bool(fields(cls))]
    for item in fields(cls):
        lines += [f"{item.name} : {item.type}, optional", f"    {item.metadata['help']}"]
    cls.__doc__ = "\n".join(lines)
    return cls


@dataclass(frozen=True)
class Section:
    """Base of the sections: converts and checks each field when it is made."""

    kind: ClassVar[str] = ""  # name of the section in files, where a field may hold one of several
    shorthands: ClassVar[Mapping[str, Mapping[str, Any]]] = {}
    """Other texts that may stand for the section, and the fields that each of them sets."""

    def __post_init__(self) -> None:
        for item in fields(self):
            value = _converted(item, hints_of(type(self))[item.name], getattr(self, item.name))
            # The dataclass is frozen; its own __post_init__ has no other way to set a field.
            object.__setattr__(self, item.name, value)
        self.check()

    def check(self) -> None:
        """Raise ValueError or TypeError unless the fields fit together."""

    def to_json(self) -> dict[str, Any]:
        """Return the settings as values that JSON can hold."""
        return by_path(values_of(self))


# Code of your own:

PATH = re.compile(r"[^\W\d]\w*(\.[^\W\d]\w*)*:[^\W\d]\w*(\.[^\W\d]\w*)*")
"""``module:object``, both with dots or without."""


class PluginError(RuntimeError):
    """Code of your own cannot be imported or made, or does not keep a promise of its base.

    The message names it; the cause is the original error, if there is one.
    """


@contextmanager
def no_exit(where: str) -> Iterator[None]:
    """Raise PluginError where code of your own exits: the program would end as if all was well."""
    try:
        yield
    except SystemExit as error:
        raise PluginError(f"{where}: code of your own called exit") from error


@section
class OwnCode(Section):
    """Base of what stands for a section of your own: its name, and its settings.

    Only `load` imports, when a run is made or goes on.
    """

    kind: ClassVar[str] = "own"
    base: ClassVar[type]  # what it has to be derived from

    code: str = setting("", "module:object")
    settings: Mapping[str, Any] = setting({}, "its settings: numbers, text, true or false")

    @classmethod
    def named(cls, own: Any) -> dict[str, Any]:
        """Return the kind and the fields that stand for an object of your own."""
        settings = {n: v for n, v in values_of(own).items() if v is not None}
        return {"kind": name_of(type(own)), "settings": settings}

    def check(self) -> None:
        """Raise ValueError unless a name is given."""
        checks.expect(PATH.fullmatch(self.code), "code", "module:object", checks.shown(self.code))

    def load(self) -> Any:
        """Return the section of your own; ValueError if it refuses its settings, or PluginError."""
        cls = imported(self.code)
        # Before it is called: the files of a stranger's run must not name any function at all.
        derived = isinstance(cls, type) and issubclass(cls, self.base)
        expected = f"a class derived from {self.base.__name__}"
        checks.expect(derived, self.code, expected, checks.shown(cls))
        try:
            check_names(self.settings, [item.name for item in fields(cls)])
            return cls(**self.settings)
        except (TypeError, ValueError) as error:
            raise ValueError(f"{self.code}: {error}") from error
        except (Exception, SystemExit) as error:
            raise PluginError(f"{self.code}: {type(error).__name__}: {error}") from error


def imported(code: str) -> Any:
    """Return the object of a name; ValueError if there is none, PluginError if its module fails."""
    module, _, attribute = code.partition(":")
    # An installed command looks for modules where it lies itself, not where the user is.
    if os.getcwd() not in sys.path:
        sys.path.append(os.getcwd())
    try:
        return attrgetter(attribute)(import_module(module))
    except AttributeError as error:
        raise ValueError(f"{code}: expected the name of an object in {module}") from error
    except (Exception, SystemExit) as error:
        # A module that exists may fail to import another one: then the error names that one.
        missing = isinstance(error, ModuleNotFoundError) and error.name
        if missing and f"{module}.".startswith(f"{missing}."):
            raise ValueError(
                f"{code}: expected a module that can be imported ({error}); install the package "
                f"that has it, or put its folder on PYTHONPATH"
            ) from error
        raise PluginError(f"{code}: import: {type(error).__name__}: {error}") from error


def name_of(code: Any) -> str:
    """Return ``module:object`` of a class; ValueError if an import cannot find it."""
    name = f"{getattr(code, '__module__', '')}:{getattr(code, '__qualname__', '')}"
    found = PATH.fullmatch(name)  # unless it is inside a function
    checks.expect(found, "code", "a class of a module", checks.shown(code))
    return name


def check_own_settings(name: str, given: Any) -> dict[str, Any]:
    """Return settings of own code by name; TypeError or ValueError if files cannot keep them."""
    if not isinstance(given, Mapping):
        raise TypeError(f"{name}: expected values by name, such as {{'sigma': 0.1}}, got {given!r}")
    values = {key: v.item() if isinstance(v, np.generic) else v for key, v in given.items()}
    for key, value in values.items():
        is_name = isinstance(key, str) and key.isidentifier()
        checks.expect(is_name, name, "names such as sigma", repr(key))
        fits = isinstance(value, bool | int | str)
        fits = fits or (isinstance(value, float) and math.isfinite(value))
        expected = f"a finite number, text, True or False as {key}"
        checks.expect(fits, name, expected, checks.shown(value), TypeError)
    return dict(sorted(values.items()))


# Fields:


hints_of: Callable[[Any], dict[str, Any]] = cache(get_type_hints)
"""Returns the types of a section's fields by name."""


@cache
def sections_in(hint: Any) -> dict[str, type[Section]]:
    """Return the sections that a field of this type may hold, by kind and shorthand."""
    found: dict[str, type[Section]] = {}
    for cls in (hint, *get_args(hint)):
        if isinstance(cls, type) and issubclass(cls, Section):
            found |= dict.fromkeys([cls.kind, *cls.shorthands], cls)
    return found


def kinds_in(hint: Any) -> list[str]:
    """Return the texts that may stand for a section of this type, but for names of own code."""
    return [name for name in sections_in(hint) if name not in ("", "own")]


@contextmanager
def inside(path: str) -> Iterator[None]:
    """Begin the messages of errors with the path of the section that they speak of."""
    try:
        yield
    except (TypeError, ValueError) as error:
        # Words, such as "more agents than free cells", are no field of the section.
        words = " " in str(error).partition(":")[0]
        kind = TypeError if isinstance(error, TypeError) else ValueError
        raise kind(f"{path}{': ' if words else '.'}{error}") from error


def _converted(item: Field[Any], hint: Any, value: Any) -> Any:
    """Return the value of a field as its type has it; TypeError or ValueError for a bad one."""
    name, accepted = item.name, {hint, *get_args(hint)}
    # A class of your own may declare its fields without `setting`.
    least, most, positive = item.metadata.get("limits", (-math.inf, math.inf, False))
    # NumPy's numbers as Python's, which files can hold; a bool of NumPy is refused as everywhere.
    if isinstance(value, np.number):
        value = value.item()
    if value is None and (NoneType in accepted or item.metadata.get("by_race")):
        return None
    if sections_in(hint):
        return _section(item, hint, None, value)
    if hint in PLAIN:
        value = {"kind": value} if isinstance(value, str) else value
        if isinstance(value, Mapping):
            with inside(name):
                value = PLAIN[hint].read(value)
        checks.check_instance(name, value, hint)
        return value
    if get_origin(hint) is tuple and int in accepted:
        is_one = isinstance(value, int) and not isinstance(value, bool)  # such as a single layer
        return checks.check_sizes(name, (value,) if is_one else value)
    if get_origin(hint) is tuple:  # worlds are read by `RaceSettings`
        parts = checks.check_sequence(name, value, "texts" if str in accepted else "mappings")
        fits = str not in accepted or all(isinstance(part, str) for part in parts)
        checks.expect(fits, name, "a sequence of texts", checks.shown(value), TypeError)
        return parts
    if get_origin(hint) is Mapping:
        return check_own_settings(name, value)
    if bool in accepted:
        return checks.check_bool(name, value)
    if int in accepted:
        return checks.check_integer(
            name, value, least, checks.INT_MAX if most == math.inf else int(most)
        )
    if float in accepted:
        return checks.check_number(name, value, least=least, most=most, positive=positive)
    if item.metadata.get("choices"):
        checks.check_choice(name, value, item.metadata["choices"])
    elif str in accepted and not isinstance(value, str):
        raise TypeError(f"{name}: expected a text, got {checks.shown(value)}")
    return value


def _section(item: Field[Any], hint: Any, before: Any, given: Any) -> Section:
    """Return the section of a field from a section, a text, a mapping, or a class of your own.

    What is not given stays as in the section `before`, or is as in the default one.
    """
    known = sections_in(hint)
    if isinstance(given, Section) and type(given) in known.values():  # derived ones are own code
        return given
    own: Any = known.get("own")
    if own is not None and isinstance(given, own.base):
        given = own.named(given)
    changes = dict(given) if isinstance(given, Mapping) else {"kind": given}
    usual = before or item.metadata["default"]
    if "kind" in changes or usual is None:
        cls, sets = _named(item.name, hint, changes.pop("kind", None))
    else:
        cls, sets, before = type(usual), {}, usual
    # The settings of other code of your own mean nothing to this one.
    start = vars(before) if type(before) is cls and "code" not in sets else {}
    with inside(item.name):
        return cls(**merged(cls, merged(cls, start, sets), changes))


def _named(name: str, hint: Any, kind: Any) -> tuple[type[Section], Mapping[str, Any]]:
    """Return the section of a kind, a shorthand or own code, and the fields that this sets."""
    known: Any = sections_in(hint)
    names = kinds_in(hint)
    if isinstance(kind, str) and kind in known:
        return known[kind], known[kind].shorthands.get(kind, {})
    if "own" in known:
        if isinstance(kind, type) and issubclass(kind, Section):
            kind = name_of(kind)
        if isinstance(kind, str) and PATH.fullmatch(kind):
            return known["own"], {"code": kind}
        names.append("or module:object" if names else "module:object")
        if not isinstance(kind, str):
            base = known["own"].base.__name__
            names.append(f"or a class derived from {base} (docs/how_to_add.md)")
    expected = f"{'one of ' * (len(names) > 1)}{', '.join(names) or known[''].__name__}"
    error = ValueError if isinstance(kind, str) else TypeError
    raise error(f"{name}: expected {expected}, got {checks.shown(kind)}")


def filled(section: AnySection, usual: Mapping[str, Any], path: str) -> AnySection:
    """Return a section in which fields `by_race` have their usual values, by path, or defaults."""
    empty = {
        item.name: usual.get(f"{path}.{item.name}", item.metadata["default"])
        for item in fields(section)
        if item.metadata.get("by_race") and getattr(section, item.name) is None
    }
    return replace(section, **empty)


# Sections as values that JSON and TOML can hold:


def merged(
    cls: type[Section], before: Mapping[str, Any], changes: Mapping[str, Any]
) -> dict[str, Any]:
    """Return the fields of a section with changes; ValueError for an unknown one.

    A section in it that stays of its class keeps what is not changed.
    """
    known, values = {item.name: item for item in fields(cls)}, dict(before)
    check_names(changes.keys(), known)
    for name, change in changes.items():
        hint, earlier = hints_of(cls)[name], before.get(name)
        values[name] = change
        if sections_in(hint) and change is not None:
            values[name] = _section(known[name], hint, earlier, change)
        elif isinstance(change, Mapping):
            values[name] = _joined(earlier, change)
    return values


def _joined(before: Any, change: Any) -> Any:
    """Return a value, or of mappings both together; one with a kind stands for itself."""
    if type(before) in PLAIN:
        before = before.to_json()
    elif isinstance(before, str) and isinstance(change, Mapping):
        before = {"kind": before}
    if not isinstance(before, Mapping) or not isinstance(change, Mapping) or "kind" in change:
        return change
    return {**before, **{name: _joined(before.get(name), each) for name, each in change.items()}}


def check_names(given: Iterable[str], known: Collection[str]) -> None:
    """Raise ValueError for a name that is unknown."""
    for name in given:
        if name not in known:
            raise ValueError(f"{name}: expected one of the settings {', '.join(known)}")


def by_path(values: Mapping[str, Any]) -> dict[str, Any]:
    """Return values by path, such as ``"learner.sigma"``, as nested settings."""
    if not isinstance(values, Mapping) or not all(isinstance(path, str) for path in values):
        raise TypeError(f"settings: expected values by name, got {checks.shown(values)}")
    plain: dict[str, Any] = {}
    for path, value in values.items():
        *parents, name = path.split(".")
        inner = plain
        for parent in parents:
            before = inner.get(parent, {})
            inner[parent] = dict(before) if isinstance(before, Mapping) else {"kind": before}
            inner = inner[parent]
        is_section = isinstance(inner.get(name), Mapping) and not isinstance(value, Mapping)
        inner[name] = {**inner[name], "kind": value} if is_section else value
    return plain


def paths_in(cls: type[Section], path: str = "") -> Iterator[str]:
    """Yield the paths of all settings in a section, of every kind that a field may hold."""
    for item in fields(cls):
        hint, here = hints_of(cls)[item.name], f"{path}{item.name}"
        yield here
        if hint in PLAIN:
            yield from (f"{here}.{name}" for name in PLAIN[hint].help)
        for kind in dict.fromkeys(sections_in(hint).values()):
            yield from paths_in(kind, f"{here}.")


def leaves(section: Section, path: str = "") -> Iterator[tuple[str, Any, str]]:
    """Yield path, value as JSON holds it, and help of every setting; of sections their kind."""
    for item in fields(section):
        value, here = getattr(section, item.name), f"{path}{item.name}"
        text = item.metadata.get("help", "")
        if isinstance(value, Section):
            if value.kind:
                yield here, value.kind, text
            yield from leaves(value, f"{here}.")
        elif type(value) in PLAIN:
            for name, each in value.to_json().items():
                yield f"{here}.{name}", each, PLAIN[type(value)].help[name]
        else:
            if isinstance(value, tuple):
                value = [each.to_json() if type(each) in PLAIN else each for each in value]
            yield here, value, text


def values_of(section: Section) -> dict[str, Any]:
    """Return every single setting of a section by its path."""
    return {path: value for path, value, _ in leaves(section)}


def different_settings(one: Section, other: Section) -> list[str]:
    """Return the paths of the settings in which two sections differ."""
    first, second = values_of(one), values_of(other)
    return [path for path in first | second if first.get(path) != second.get(path)]
