"""Sections of settings: frozen dataclasses whose fields check themselves, and their JSON.

A section is a part of `RaceSettings`, such as the settings of one learner. Each field is declared
once, by `setting`: its default, its help text and its limits. A field may hold one of several
sections, as a type such as ``EvolutionStrategySettings | GeneticAlgorithmSettings`` says; in files
the ``kind`` of a section tells them apart. A setting that would have no effect has no place there.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import Field, dataclass, field, fields
from functools import cache
from inspect import cleandoc
from types import NoneType
from typing import Any, ClassVar, NamedTuple, TypeVar, get_args, get_origin, get_type_hints

import numpy as np

from matrixworld._util.checks import (
    INT_MAX,
    check_bool,
    check_choice,
    check_instance,
    check_integer,
    check_number,
    shown,
)
from matrixworld.coevolution.own_code import (
    Interface,
    OwnSettings,
    check_code,
    check_known,
    own_settings,
)
from matrixworld.world.config import WorldConfig
from matrixworld.world.rules import REWARDS, VARIANTS, Rewards, Rules

AnySection = TypeVar("AnySection", bound="Section")

WORLD_HELP = {
    "rules": "game variant, a name such as O, or its rules one by one",
    "rows": "rows of the grid; default: those of the obstacle map, or 40, in solve 6",
    "cols": "columns of the grid; default: those of the obstacle map, or 40, in solve 6",
    "n_pursuers": "number of pursuers; default: depends on rules and command",
    "n_evaders": "number of evaders; default: depends on rules and command",
    "fov": "side of an agent's square field of view, in cells; odd",
    "diagonal": "allow diagonal moves (9 actions instead of 5)",
    "max_steps": "maximum steps of an evaluation episode",
    "obstacles": "obstacles: a density in [0, 1), rows of text, or a MovingAI .map file",
    "rewards": f"rewards: {' or '.join(REWARDS)}, or one by one",
}
"""What the fields of a `WorldConfig` mean in the settings of a run."""


def setting(
    default: Any,
    text: str,
    *,
    by: Mapping[str, Any] | None = None,
    choices: Collection[str] = (),
    least: float = 0,
    most: float = math.inf,
    positive: bool = False,
) -> Any:
    """Return a field of a section: its default, what it means, and its legal texts or numbers.

    `by` has other defaults, by the kind of learner or schedule that has them: the field is then
    None until `RaceSettings` knows the kinds. A default that follows from other settings is a
    function of them, whose docstring says in a line what it returns. With `positive`, 0 is refused.
    """
    metadata = {
        "help": text,
        "default": default,
        "by": by or {},
        "choices": choices,
        "limits": (least, most, positive),
    }
    return field(default=None if by else default, metadata=metadata)


def documented(cls: type[AnySection]) -> type[AnySection]:
    """Add the help texts of the fields to a docstring, as its section of parameters."""
    lines = [cleandoc(cls.__doc__ or ""), "", "Parameters", "----------"]
    for item in fields(cls):
        lines += [f"{item.name} : {item.type}, optional", f"    {item.metadata['help']}"]
    cls.__doc__ = "\n".join(lines)
    return cls


@dataclass(frozen=True)
class Section:
    """Base of the sections: checks each field by its type and limits when it is made."""

    kind: ClassVar[str] = ""
    """Name of the section in files, where a field may hold one of several."""
    shorthands: ClassVar[Mapping[str, Mapping[str, Any]]] = {}
    """Other texts that may stand for the section, and the fields that each of them sets."""

    def __post_init__(self) -> None:
        hints = hints_of(type(self))
        for item in fields(self):
            value = _checked(item, hints[item.name], getattr(self, item.name))
            # The dataclass is frozen; its own __post_init__ has no other way to set a field.
            object.__setattr__(self, item.name, value)
        self.check()

    def check(self) -> None:
        """Raise ValueError or TypeError unless the fields fit together."""


@dataclass(frozen=True)
class OwnCode(Section):
    """Base of the settings of a class from outside the package."""

    kind: ClassVar[str] = "own"
    interface: ClassVar[Interface]

    code: str = setting("", "module:object, or the name of an installed one")
    settings: OwnSettings = setting(OwnSettings(), "its settings: numbers, text, true or false")

    def check(self) -> None:
        """Raise ValueError unless a name is given."""
        check_code("code", self.code)


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


def named(path: str, text: Any, hint: Any) -> tuple[type[Section], Mapping[str, Any]]:
    """Return the section that a text stands for, and the fields that the text sets.

    Where a section may be own code, any text that is no kind is the name of own code.
    """
    known = sections_in(hint)
    if not isinstance(text, str) or (text not in known and "own" not in known):
        raise ValueError(f"{path}: expected one of {', '.join(kinds_in(hint))}, got {shown(text)}")
    if text in known:
        return known[text], known[text].shorthands.get(text, {})
    own: Any = known["own"]
    check_known(path, text, kinds_in(hint), own.interface)
    return own, {"code": text}


@contextmanager
def inside(path: str) -> Iterator[None]:
    """Begin the messages of errors with the path of the section that they speak of."""
    try:
        yield
    except (TypeError, ValueError) as error:
        # Words, such as "more agents than free cells", are no field of the section.
        words = " " in str(error).partition(":")[0]
        begin = f"{path[:-1]}: " if path and words else path
        kind = TypeError if isinstance(error, TypeError) else ValueError
        raise kind(f"{begin}{error}") from error


def _checked(item: Field[Any], hint: Any, value: Any) -> Any:
    """Return the value of a field as its type has it; TypeError or ValueError for a bad one."""
    name, accepted = item.name, {hint, *get_args(hint)}
    least, most, positive = item.metadata["limits"]
    # NumPy's numbers as Python's, which files can hold; a bool of NumPy is refused as everywhere.
    if isinstance(value, np.number):
        value = value.item()
    if value is None and (NoneType in accepted or item.metadata["by"]):
        return None
    if sections := sections_in(hint):
        if isinstance(value, str) and kinds_in(hint):
            cls, given = named(name, value, hint)
            with inside(f"{name}."):
                return cls(**given)
        if not isinstance(value, tuple(sections.values())):
            classes = " or ".join(dict.fromkeys(each.__name__ for each in sections.values()))
            raise TypeError(f"{name}: expected {classes}, got {shown(value)}")
        return value
    if hint is WorldConfig:
        check_instance(name, value, WorldConfig)
    elif hint is OwnSettings:
        return own_settings(name, value)
    elif get_origin(hint) is tuple:
        if isinstance(value, int) and not isinstance(value, bool):
            value = (value,)  # a single layer
        if not isinstance(value, Iterable) or isinstance(value, str | bytes | Mapping):
            raise TypeError(f"{name}: expected a sequence of ints, got {shown(value)}")
        return tuple(check_integer(name, size, 1) for size in value)
    elif bool in accepted:
        check_bool(name, value)
    elif int in accepted:
        return int(check_integer(name, value, least, INT_MAX if most == math.inf else int(most)))
    elif float in accepted:
        return check_number(name, value, least=least, most=most, positive=positive)
    elif item.metadata["choices"]:
        check_choice(name, value, item.metadata["choices"])
    elif not isinstance(value, str):
        raise TypeError(f"{name}: expected a text, got {shown(value)}")
    return value


# Sections as values that JSON and TOML can hold:


def from_plain(
    cls: type[AnySection], plain: Mapping[str, Any], path: str = "", *, complete: bool = False
) -> AnySection:
    """Return a section from nested values, which are all there if `complete`.

    Code is named only, and not imported. TypeError or ValueError if a field is missing, unknown or
    has a bad value; the message begins with its path, `path` included.
    """
    items = {item.name: item for item in fields(cls)}
    check_names(plain, items, path)
    missing = [name for name in items if name not in plain]
    if complete and missing:
        raise ValueError(f"{path}{missing[0]}: expected a value, got none")
    hints = hints_of(cls)
    values = {
        name: _restored(items[name], hints[name], value, f"{path}{name}", complete=complete)
        for name, value in plain.items()
    }
    with inside(path):
        return cls(**values)


def check_names(given: Iterable[str], known: Collection[str], path: str) -> None:
    """Raise ValueError for a name that is unknown at a path."""
    for name in given:
        if name not in known:
            raise ValueError(f"{path}{name}: expected one of the settings {', '.join(known)}")


def _restored(item: Field[Any], hint: Any, plain: Any, path: str, *, complete: bool) -> Any:
    """Return the value of a field from nested values; the section checks what is none of them."""
    if not isinstance(plain, Mapping):
        return plain
    if hint is WorldConfig:
        return WorldConfig.from_json(plain) if complete else _world(plain, path)
    if not sections_in(hint):
        return plain
    values, default = dict(plain), item.metadata["default"]
    kind = values.pop("kind", None)
    if kind is not None:
        cls, given = named(f"{path}.kind" if complete else path, kind, hint)
    elif complete and kinds_in(hint):
        raise ValueError(f"{path}.kind: expected a value, got none")
    else:
        # A part of the default section: its other fields stay.
        cls, given = type(default), {} if complete else vars(default)
    for name, part in values.items():
        # A part of a section that the shorthand names: its other fields stay.
        if isinstance(part, Mapping) and isinstance(given.get(name), str):
            values[name] = {"kind": given[name], **part}
    return from_plain(cls, {**given, **values}, f"{path}.", complete=complete)


def _world(plain: Mapping[str, Any], path: str) -> WorldConfig:
    """Return the world of some fields; rules and rewards may be names, or both given one by one."""
    check_names(plain, WORLD_HELP, f"{path}.")
    values = dict(plain)
    rows: Any = (("rules", VARIANTS, "O"), ("rewards", REWARDS, "paper"))
    for name, kinds, usual in rows:
        given = plain.get(name)
        if given is None or isinstance(given, Rules | Rewards):
            continue
        parts = dict(given) if isinstance(given, Mapping) else {"kind": given}
        kind = parts.pop("kind", usual)
        check_choice(f"{path}.{name}", kind, kinds)
        # Those that are not given are as in the row of that kind.
        base: Any = WorldConfig(**{name: kinds[kind]}).to_json()
        world = WorldConfig.from_json({**base, name: {**base[name], **parts}})
        values[name] = getattr(world, name)
    with inside(f"{path}."):
        return WorldConfig(**values)


def by_path(values: Mapping[str, Any]) -> dict[str, Any]:
    """Return values by path, such as ``"learner.sigma"``, as nested settings."""
    plain: dict[str, Any] = {}
    for path, value in values.items():
        put(plain, path, value)
    return plain


def put(plain: dict[str, Any], path: str, value: Any) -> None:
    """Set the value of a path in nested settings; a text names the kind of a section."""
    first, dot, rest = path.partition(".")
    before: Any = plain.get(first)
    is_section = isinstance(before, Mapping)
    if not dot:
        plain[first] = {**before, "kind": value} if is_section else value
        return
    # A text stands for a whole section, of which a part is now given, too.
    plain[first] = dict(before or {}) if is_section or before is None else {"kind": before}
    put(plain[first], rest, value)


def merged(cls: Any, plain: Mapping[str, Any], changes: Mapping[str, Any]) -> dict[str, Any]:
    """Return the nested settings of a class with changes.

    A section of another class starts from its defaults; of the same class, it keeps what is not
    changed.
    """
    found = dict(plain)
    items = {item.name: item for item in fields(cls)} if cls else {}
    for name, change in changes.items():
        known = sections_in(hints_of(cls)[name]) if name in items else {}
        before, after = (
            {"kind": each} if known and isinstance(each, str) else each
            for each in (found.get(name), change)
        )
        found[name] = after
        if isinstance(before, Mapping) and isinstance(after, Mapping):
            usual = items[name].metadata["default"].kind if known else ""
            old = str(before.get("kind", usual))
            new = str(after.get("kind", old))
            inner = known.get(new)
            if new == old or (inner and inner is known.get(old)):
                sets = inner.shorthands.get(new, {}) if inner else {}
                kind = {"kind": old} if old else {}
                found[name] = merged(inner, {**before, **sets}, {**after, **kind})
    return found


class Leaf(NamedTuple):
    """A single setting: its path, its value as JSON holds it, and its help text.

    The leaf of a section has the path of the section and its kind.
    """

    path: str
    value: Any
    help: str


def leaves(section: Section, path: str = "") -> Iterator[Leaf]:
    """Yield every single setting of a section and of those in it, in order."""
    for item in fields(section):
        value, here, text = getattr(section, item.name), f"{path}{item.name}", item.metadata["help"]
        if isinstance(value, Section):
            if value.kind:
                yield Leaf(here, value.kind, text)
            yield from leaves(value, f"{here}.")
        elif isinstance(value, WorldConfig):
            for name, plain in value.to_json().items():
                yield Leaf(f"{here}.{name}", plain, WORLD_HELP[name])
        else:
            plain = dict(value) if isinstance(value, OwnSettings) else value
            yield Leaf(here, list(plain) if isinstance(plain, tuple) else plain, text)


def different_settings(one: Section, *others: Section) -> list[str]:
    """Return the paths of the settings in which sections differ."""
    values = [{leaf.path: leaf.value for leaf in leaves(each)} for each in (one, *others)]
    paths = dict.fromkeys(path for each in values for path in each)
    missing = object()
    return [
        path
        for path in paths
        if any(each.get(path, missing) != values[0].get(path, missing) for each in values)
    ]
