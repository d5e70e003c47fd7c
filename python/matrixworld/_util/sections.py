"""Sections of settings: frozen dataclasses that names stand for, and that paths change.

There is one idea. A section in a file or an option is the *name* of one that exists, and changes to
its fields: ``{"learner": "ga", "learner.mutation": 0.1}`` is the genetic algorithm with another
mutation. `NAMES` says what names stand for, `build` makes a section of names and changes.

A field is declared once, by `setting`: its default, its help text and its constraint. Fields hold
numbers, texts, other sections, or what has names without being a section, such as a world.
"""

from __future__ import annotations

from abc import ABC
from collections import defaultdict
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import MISSING, Field, dataclass, field, fields
from functools import cache
from inspect import cleandoc
from pathlib import Path
from types import NoneType
from typing import Any, ClassVar, NamedTuple, TypeVar, cast, get_args, get_origin, get_type_hints

import numpy as np
from typing_extensions import dataclass_transform

from matrixworld._util import constraints, plugins
from matrixworld._util.checks import INT_MAX, shown
from matrixworld._util.constraints import Constraint

AnyClass = TypeVar("AnyClass", bound=type)


class Named(NamedTuple):
    """What a name stands for: a class, and the fields that the name sets."""

    make: Callable[..., Any]
    sets: Mapping[str, Any] = {}


NAMES: dict[type, dict[str, Named]] = {}
"""What names stand for, by the type of the field that takes them."""
HELP: dict[type, Mapping[str, str]] = {}
"""What the fields of named types mean that are no sections, such as worlds."""
OWN = "own"
"""The name of code of your own, where a field takes it."""


class SettingError(ValueError, TypeError):
    """A setting is wrong: its `path`, what was `expected`, and what came (`got`).

    `fits` is a value that would fit, if one is known.
    """

    def __init__(self, path: str, expected: str, got: str = "", fits: str = "") -> None:
        super().__init__(path, expected, got, fits)
        self.path = path
        self.expected = expected
        self.got = got
        self.fits = fits

    def __str__(self) -> str:
        """Return the sentence of it."""
        got = f", got {self.got}" if self.got else ""
        return f"{self.path}: expected {self.expected}{got}"

    def at(self, path: str) -> SettingError:
        """Return the same error of another path."""
        return type(self)(path, self.expected, self.got, self.fits)

    def below(self, path: str) -> SettingError:
        """Return the same error of a setting in the section at `path`."""
        return self.at(f"{path}.{self.path}" if path and self.path else path or self.path)


class UnknownSettingError(SettingError):
    """There is no setting of this path."""


@contextmanager
def below(path: str) -> Iterator[None]:
    """Raise errors of settings with the path of the section that they speak of."""
    try:
        yield
    except SettingError as error:
        raise error.below(path) from error.__cause__
    except (TypeError, ValueError) as error:
        raise _of_other_code(error).below(path) from error


def _of_other_code(error: Exception) -> SettingError:
    """Return the error of code that raises plain texts, such as the engine, which checks worlds.

    A text that reads ``name: expected this, got that`` is taken apart.
    """
    name, begins, problem = str(error).partition(": expected ")
    if not begins:
        return SettingError("", "values that fit", str(error))
    expected = problem
    got = ""
    if ", got " in problem:
        expected, _, got = problem.rpartition(", got ")
    if not all(part.isidentifier() for part in name.split(".")):  # words, and no field
        return SettingError("", f"{expected} ({name})", got)
    return SettingError(name, expected, got)


def setting(default: Any, text: str, constraint: Constraint | None = None) -> Any:
    """Return a field of a section: its default, what it means, and what it may be.

    Without a constraint, numbers are at least 0.
    """
    metadata = {"help": text, "constraint": constraint}
    if isinstance(default, Mapping):
        # A mapping has no hash, so that of its section is of the other fields.
        return field(default_factory=lambda: dict(default), hash=False, metadata=metadata)
    return field(default=default, metadata=metadata)


@dataclass_transform(frozen_default=True)
def section(kind: str = "") -> Callable[[AnyClass], AnyClass]:
    """Make a class a frozen dataclass with the help texts in its docstring; `kind` is its name."""

    def decorated(cls: AnyClass) -> AnyClass:
        made: Any = dataclass(frozen=True)(cls)
        lines = [cleandoc(made.__doc__ or "")]
        if settings_of(made):
            lines += ["", "Parameters", "----------"]
        for item in settings_of(made):
            lines += [f"{item.name} : {item.type}, optional", f"    {item.metadata['help']}"]
        made.__doc__ = "\n".join(lines)
        if kind:
            made.kind = kind
            name_section(kind, made)
        return cast(AnyClass, made)

    return decorated


def name_section(name: str, cls: Any, **sets: Any) -> None:
    """Let a name stand for a section of a class, with these fields."""
    NAMES.setdefault(base_of(cls), {})[name] = Named(cls, sets)


def base_of(cls: Any) -> Any:
    """Return the base of a section's kind, such as that of all learners."""
    return next(ancestor for ancestor in cls.__mro__ if Section in ancestor.__bases__)


@dataclass(frozen=True)
class Section(ABC):  # noqa: B024, bases of kinds have abstract methods
    """Base of the sections: checks each field when it is made."""

    kind: ClassVar[str] = ""  # its name in files

    def __post_init__(self) -> None:
        for item in settings_of(type(self)):
            value = _checked(item, hints_of(type(self))[item.name], getattr(self, item.name))
            # The dataclass is frozen; its own __post_init__ has no other way to set a field.
            object.__setattr__(self, item.name, value)
        self.check()

    def check(self) -> None:  # noqa: B027, most have nothing more to check
        """Raise ValueError or TypeError unless the fields fit together."""

    def leaves(self, path: str = "") -> Iterator[tuple[str, Any, str]]:
        """Yield path, value as JSON holds it, and help of every setting; of sections their kind.

        The paths begin with `path`.
        """
        for item in settings_of(type(self)):
            value = getattr(self, item.name)
            here = f"{path}{item.name}"
            text = item.metadata.get("help", "")
            if isinstance(value, Section):
                if value.kind:
                    yield here, value.kind, text
                yield from value.leaves(f"{here}.")
            elif type(value) in HELP:
                for name, part in value.to_json().items():
                    yield f"{here}.{name}", part, HELP[type(value)][name]
            elif isinstance(value, tuple):
                yield here, [part.to_json() if type(part) in HELP else part for part in value], text
            else:
                yield here, value, text

    def values(self) -> dict[str, Any]:
        """Return every single setting by its path, as values that JSON can hold."""
        return {path: value for path, value, _ in self.leaves()}

    def to_json(self) -> dict[str, Any]:
        """Return the settings as nested values that JSON can hold; a ``kind`` names a section."""
        plain: dict[str, Any] = {}
        for path, value in self.values().items():
            *parents, name = path.split(".")
            inner = plain
            for parent in parents:
                before = inner.get(parent, {})
                inner[parent] = before if isinstance(before, dict) else {"kind": before}
                inner = inner[parent]
            inner[name] = value
        return plain


# Fields:

hints_of: Callable[[Any], dict[str, Any]] = cache(get_type_hints)
"""Returns the types of a section's fields by name."""


def settings_of(cls: Any) -> list[Field[Any]]:
    """Return the fields of a section that are settings: those by which sections are compared."""
    return [item for item in fields(cls) if item.compare]


def named_type(hint: Any) -> Any:
    """Return the type of a field whose values have names; None of other fields."""
    if get_origin(hint) is tuple:
        return None
    return next((part for part in (hint, *get_args(hint)) if part in NAMES), None)


def classes_of(base: Any) -> list[Any]:
    """Return the classes of all sections of a kind."""
    return [*dict.fromkeys(named.make for named in NAMES[base].values())]


def names_in(base: Any) -> list[str]:
    """Return the names of a type, but that of own code, which is any ``module:object``."""
    return [name for name in NAMES[base] if name != OWN]


def constraint_of(item: Field[Any], hint: Any) -> Constraint:
    """Return what a field may be that holds no section."""
    accepted = {hint, *get_args(hint)}
    declared: Constraint | None = item.metadata.get("constraint")
    if declared is not None:
        return declared
    if get_origin(hint) is tuple:
        return constraints.SIZES if int in accepted else constraints.TEXTS
    if get_origin(hint) is Mapping:
        return constraints.Plain()
    if bool in accepted:
        return constraints.BOOL
    # A class of your own may declare its fields without `setting`.
    least = 0 if "help" in item.metadata else -INT_MAX
    if int in accepted:
        return constraints.Whole(least)
    if float in accepted:
        return constraints.Range(least if "help" in item.metadata else -np.inf)
    return constraints.TEXT


def _checked(item: Field[Any], hint: Any, value: Any) -> Any:
    """Return the value of a field as its type has it; SettingError for a bad one."""
    if value is None and NoneType in get_args(hint):
        return None
    base = named_type(hint)
    if base is not None:
        is_named = isinstance(value, base) and not issubclass(base, Section)
        is_section = type(value) in classes_of(base)
        return value if is_named or is_section else _own_section(item.name, base, value)
    if isinstance(value, np.number):  # files hold those of Python
        value = value.item()
    elif isinstance(value, Mapping):
        numbers = {n: v.item() if isinstance(v, np.number) else v for n, v in value.items()}
        value = dict(sorted(numbers.items(), key=str))
    elif get_origin(hint) is tuple:
        value = _as_tuple(value)
    constraint = constraint_of(item, hint)
    expected = constraint.expected(value)
    if expected:
        raise SettingError(item.name, expected, shown(value))
    return float(value) if isinstance(constraint, constraints.Range) else value


def _as_tuple(value: Any) -> Any:
    """Return a sequence as a tuple, and a single number, such as one layer, as one of one."""
    if isinstance(value, list | tuple):
        return tuple(_as_part(part) for part in value)
    is_number = isinstance(value, int | float) and not isinstance(value, bool)
    return (value,) if is_number else value


def _as_part(part: Any) -> Any:
    """Return a part of a sequence as files hold it; one that is a sequence itself as a tuple."""
    if isinstance(part, np.number):
        return part.item()
    return _as_tuple(part) if isinstance(part, list | tuple) else part


def _own_section(name: str, base: Any, value: Any) -> Any:
    """Return what stands for code of your own in a field; SettingError for anything else."""
    if is_own(base, value):
        with below(name):
            return NAMES[base][OWN].make(**of_own(base, value))
    hint = "; only `of` takes names" if isinstance(value, str) else ""
    raise SettingError(name, f"a section derived from {base.__name__}", f"{shown(value)}{hint}")


# Code of your own:


def is_own(base: Any, value: Any) -> bool:
    """Return whether a value is code of your own for a field: a class or an object of one."""
    if OWN not in NAMES[base]:
        return False
    cls = value if isinstance(value, type) else type(value)
    own: Any = NAMES[base][OWN].make
    return issubclass(cls, own.base) and cls not in classes_of(base)


def of_own(base: Any, value: Any) -> dict[str, Any]:
    """Return the fields of the section that stands for code of your own."""
    own: Any = NAMES[base][OWN].make
    fields: dict[str, Any] = own.named(value)
    return fields


# Sections from names and changes:


def flat(values: Mapping[str, Any], path: str = "") -> dict[str, Any]:
    """Return settings by path, as values that JSON can hold, of nested ones and of sections.

    A ``kind`` is the name of its section. What is no value of a setting stays as it is.
    """
    if not isinstance(values, Mapping) or not all(isinstance(name, str) for name in values):
        raise SettingError("settings", "values by name", shown(values))
    plain: dict[str, Any] = {}
    for name, value in values.items():
        here = f"{path}{name}".removesuffix(".kind")
        if isinstance(value, Mapping):
            plain |= flat(value, f"{here}.") if value else {here: value}
        elif isinstance(value, list | tuple):
            plain[here] = [_fields_of(part) if type(part) in NAMES else part for part in value]
        elif isinstance(value, np.ndarray | np.number):
            plain[here] = value.tolist()
        elif isinstance(value, Path):
            plain[here] = str(value)
        elif type(value) in NAMES:
            plain |= flat(_fields_of(value), f"{here}.")
        elif isinstance(value, int | float | str | None):
            plain[here] = value
        else:
            plain |= _flat_object(value, here)
    return plain


def _fields_of(value: Any) -> dict[str, Any]:
    """Return the fields of what has names without being a section, such as a world or rules."""
    if type(value) in HELP:
        fields: dict[str, Any] = value.to_json()
        return fields
    return {name: getattr(part, "name", part) for name, part in vars(value).items()}


def _flat_object(value: Any, path: str) -> dict[str, Any]:
    """Return what stands for a section, for the class of one, or for code of your own."""
    for base in NAMES:
        if is_own(base, value):
            own = of_own(base, value)
            return {path: own["code"], **flat(own.get("settings", {}), f"{path}.settings.")}
    if isinstance(value, Section):
        return {path: value.kind, **{here: part for here, part, _ in value.leaves(f"{path}.")}}
    is_kind = isinstance(value, type) and issubclass(value, Section)
    return {path: getattr(value, "kind", value) if is_kind else value}


def build(base: Any, changes: Mapping[str, Any], start: Any = None, **more: Any) -> Any:
    """Return what a name stands for, with changes to its fields by path.

    The name is at the path ``""``. Without one the changes are to `start`: a section, the name of
    one, or the class of one that has its defaults. `more` are arguments that are no settings.

    ``build(Learner, {"": "ga", "mutation": 0.1})`` is the genetic algorithm with a mutation of 0.1;
    ``build(RaceSettings, {"learner": "ga", "learner.mutation": 0.1}, RaceSettings)`` a race of it.
    """
    name = changes.get("")
    named = _named(base, start if name is None else name)
    items = {item.name: item for item in settings_of(named.make)}
    by_field = defaultdict[str, dict[str, Any]](dict)  # and then by the rest of the path
    for path in filter(None, changes):
        field_name, dot, rest = path.partition(".")
        if dot and not rest:
            raise UnknownSettingError(path, "names with dots between them")
        by_field[field_name][rest] = changes[path]
    values = dict(named.sets)
    for field_name, inner in by_field.items():
        if field_name not in items:
            known = f"one of the settings {', '.join(items)}" if items else "no setting"
            raise UnknownSettingError(field_name, known)
        before = values.get(field_name, items[field_name].default)
        with below(field_name):
            values[field_name] = _changed(hints_of(named.make)[field_name], before, inner)
    return named.make(**values, **more)


def _changed(hint: Any, before: Any, changes: Mapping[str, Any]) -> Any:
    """Return the value of a field of a type after changes; at the path ``""`` is the field's own.

    SettingError for changes inside a single value.
    """
    is_single = changes.keys() == {""}
    base = named_type(hint)
    if base is not None and not (is_single and changes[""] is None):
        return build(base, changes, before)
    if is_single:
        return changes[""]
    if get_origin(hint) is Mapping and "" not in changes:
        return changes
    raise SettingError("", "a single value", shown(dict(changes)))


def _named(base: Any, name: Any) -> Named:
    """Return what a name stands for, or what a section, or a class, is as a start of changes."""
    if name is MISSING:  # such as the rules of a world, which begin from the first ones
        return next(iter(NAMES[base].values()))
    if isinstance(name, str):
        names = NAMES[base]
        if name in names:
            return names[name]
        if OWN in names and plugins.PATH.fullmatch(name):
            return Named(names[OWN].make, {"code": name})
    elif isinstance(name, type) and issubclass(name, base):
        return Named(name)
    elif isinstance(name, base):
        # A world, whose numbers of agents follow from its rules, begins from none of its fields.
        items = [] if base in HELP else settings_of(type(name))
        return Named(type(name), {item.name: getattr(name, item.name) for item in items})
    expected = _names_in_words(base)
    if OWN in NAMES[base] and not isinstance(name, str):
        expected += f", or a class derived from {base.__name__} (docs/how_to_add.md)"
    raise SettingError("", expected, shown(name))


def _names_in_words(base: Any) -> str:
    names = names_in(base)
    if OWN in NAMES[base]:
        names.append("or module:object" if names else "module:object")
    return f"one of {', '.join(names)}" if len(names) > 1 else names[0]


# All settings:


def paths_in(cls: Any, path: str = "") -> Iterator[str]:
    """Yield the paths of all settings in a section, of every kind that a field may hold."""
    for item in settings_of(cls):
        here = f"{path}{item.name}"
        yield here
        base = named_type(hints_of(cls)[item.name])
        if base in HELP:
            yield from (f"{here}.{name}" for name in HELP[base])
        elif base is not None:
            for kind in dict.fromkeys(named.make for named in NAMES[base].values()):
                yield from paths_in(kind, f"{here}.")
