"""Sections of settings: frozen dataclasses whose fields check themselves, and their JSON.

A section is a part of `RaceSettings`, such as the settings of one learner. Each field is declared
once, by `setting`: its default, its help text and its limits. A field may hold one of several
sections, as a type such as ``EvolutionStrategySettings | GeneticAlgorithmSettings`` says; in files
the ``kind`` of a section tells them apart. A setting that would have no effect has no place there.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping
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
from matrixworld.world.config import WorldConfig
from matrixworld.world.rules import Rewards

AnySection = TypeVar("AnySection", bound="Section")

REWARDS = {"paper": Rewards.paper, "published": Rewards.published}
"""Rewards by the names that files and options take."""

WORLD_HELP = {
    "rules": "game variant, a name such as O, or its rules one by one",
    "rows": "rows of the grid; default: those of the obstacle map, or 40",
    "cols": "columns of the grid; default: those of the obstacle map, or 40",
    "n_pursuers": "number of pursuers; default: depends on the rules",
    "n_evaders": "number of evaders; default: depends on the rules",
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
    """Return a field of a section.

    Parameters
    ----------
    default : object
        The default.
    text : str
        What the setting means, for help texts.
    by : mapping of str to object, optional
        Other defaults, by the kind of learner or schedule that has them. The field is then None
        until `RaceSettings` knows the kinds.
    choices : collection of str, optional
        The legal texts.
    least, most : float, optional
        The smallest and the largest legal number.
    positive : bool, optional
        Whether 0 is refused.
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


class OwnSettings(Mapping[str, Any]):
    """Settings of code from outside the package, by name; they never change."""

    def __init__(self, values: Mapping[str, Any] | None = None) -> None:
        # The order of the names does not matter.
        self._values = dict(sorted((values or {}).items()))

    def __getitem__(self, name: str) -> Any:
        return self._values[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._values)

    def __len__(self) -> int:
        return len(self._values)

    def __hash__(self) -> int:
        return hash(tuple(self._values.items()))

    def __repr__(self) -> str:
        return repr(self._values)


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


# Fields:


def unfilled(section: Section) -> list[Field[Any]]:
    """Return the fields that wait for a default, which goes with learner and schedule."""
    return [
        item
        for item in fields(section)
        if item.metadata["by"] and getattr(section, item.name) is None
    ]


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


def section_named(name: str, text: str, hint: Any) -> Section:
    """Return the section that a text stands for; any other text is the name of own code."""
    known = sections_in(hint)
    if text in kinds_in(hint):
        return known[text](**known[text].shorthands.get(text, {}))
    if "own" not in known:
        raise ValueError(f"{name}: expected one of {', '.join(kinds_in(hint))}, got {shown(text)}")
    own: Any = known["own"]
    section: Section = own.named(name, text, kinds_in(hint))
    return section


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
        found = section_named(name, value, hint) if isinstance(value, str) else value
        if not isinstance(found, tuple(sections.values())):
            classes = " or ".join(dict.fromkeys(each.__name__ for each in sections.values()))
            raise TypeError(f"{name}: expected {classes}, got {shown(value)}")
        return found
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


def own_settings(name: str, given: Any) -> OwnSettings:
    """Return settings of own code; TypeError or ValueError if files cannot keep them."""
    if not isinstance(given, Mapping):
        raise TypeError(f"{name}: expected values by name, such as {{'sigma': 0.1}}, got {given!r}")
    values = {key: v.item() if isinstance(v, np.generic) else v for key, v in given.items()}
    for key, value in values.items():
        if not isinstance(key, str) or not key.isidentifier():
            raise ValueError(f"{name}: expected names such as sigma, got {key!r}")
        if not isinstance(value, bool | int | float | str):
            raise TypeError(
                f"{name}: expected a number, text, True or False as {key}, got {value!r}"
            )
        if isinstance(value, float) and not math.isfinite(value):
            raise ValueError(f"{name}: expected a finite number as {key}, got {value}")
    return OwnSettings(values)


# Sections as values that JSON and TOML can hold:


def to_plain(value: Any) -> Any:
    """Return a section, or the value of a field, as values that JSON can hold."""
    if isinstance(value, Section):
        kind = {"kind": value.kind} if value.kind else {}
        return kind | {item.name: to_plain(getattr(value, item.name)) for item in fields(value)}
    if isinstance(value, WorldConfig):
        return value.to_json()
    if isinstance(value, OwnSettings):
        return dict(value)
    return list(value) if isinstance(value, tuple) else value


def from_plain(
    cls: type[AnySection], plain: Mapping[str, Any], path: str = "", *, complete: bool = False
) -> AnySection:
    """Return a section from what `to_plain` returned for it, or from a part of that.

    Parameters
    ----------
    cls : type
        Class of the section.
    plain : mapping of str to object
        Values of its fields. Code is named only, and not imported.
    path : str, optional
        Where the section stands, for messages, such as ``"learner."``.
    complete : bool, optional
        Whether all fields must be there, as in the files of a run.

    Raises
    ------
    TypeError, ValueError
        If a field is missing, unknown or has a bad value; the message begins with its path.
    """
    items = {item.name: item for item in fields(cls)}
    check_names(plain, items, path)
    missing = [name for name in items if name not in plain]
    if complete and missing:
        raise ValueError(f"{path}{missing[0]}: expected a value, got none")
    hints = hints_of(cls)
    values = {
        name: _restored(items[name], hints[name], value, path, complete=complete)
        for name, value in plain.items()
    }
    try:
        return cls(**values)
    except ValueError as error:
        raise ValueError(f"{path}{error}") from error
    except TypeError as error:
        raise TypeError(f"{path}{error}") from error


def check_names(given: Iterable[str], known: Collection[str], path: str) -> None:
    """Raise ValueError for a name that is unknown at a path."""
    for name in given:
        if name not in known:
            raise ValueError(f"{path}{name}: expected one of the settings {', '.join(known)}")


def _restored(item: Field[Any], hint: Any, plain: Any, path: str, *, complete: bool) -> Any:
    """Return the value of a field from what `to_plain` returned for it."""
    here = f"{path}{item.name}."
    if not isinstance(plain, Mapping):
        return plain
    if hint is WorldConfig:
        return WorldConfig.from_json(plain) if complete else _world(plain, here)
    known = sections_in(hint)
    if not known:
        return plain
    values, default = dict(plain), item.metadata["default"]
    kind = values.pop("kind", None)
    if kind is None:
        if complete and kinds_in(hint):
            raise ValueError(f"{here}kind: expected a value, got none")
        # A part of the default section: its other fields stay.
        kept = {each.name: getattr(default, each.name) for each in fields(default)}
        changed = from_plain(type(default), values, here, complete=complete)
        return type(default)(**{**kept, **{name: getattr(changed, name) for name in values}})
    if not complete and isinstance(kind, str) and kind not in known and "own" in known:
        # The name of own code in place of a kind.
        section_named(f"{path}{item.name}", kind, hint)
        kind, values = "own", {"code": kind, **values}
    if not isinstance(kind, str) or kind not in known:
        raise ValueError(
            f"{here}kind: expected one of {', '.join(kinds_in(hint))}, got {shown(kind)}"
        )
    return from_plain(
        known[kind], {**known[kind].shorthands.get(kind, {}), **values}, here, complete=complete
    )


def _world(plain: Mapping[str, Any], path: str) -> WorldConfig:
    """Return the world of some fields; the rules may be the name of a variant."""
    values = dict(plain)
    check_names(values, [item.name for item in fields(WorldConfig)], path)
    rules, rewards = values.pop("rules", "O"), values.get("rewards", "paper")
    # Rules and rewards one by one: those that are not given are as in the variant of that kind.
    if isinstance(rules, Mapping):
        parts = dict(rules)
        base = WorldConfig(parts.pop("kind", "O")).to_json()
        rules = WorldConfig.from_json({**base, "rules": {**base["rules"], **parts}}).rules
    if "rewards" in values and not isinstance(rewards, Rewards):
        parts = dict(rewards) if isinstance(rewards, Mapping) else {"kind": rewards}
        kind = parts.pop("kind", "paper")
        check_choice(f"{path}rewards", kind, REWARDS)
        base = WorldConfig(rewards=REWARDS[kind]()).to_json()
        world = WorldConfig.from_json({**base, "rewards": {**base["rewards"], **parts}})
        values["rewards"] = world.rewards
    try:
        return WorldConfig(rules, **values)
    except ValueError as error:
        raise ValueError(f"{path}{error}") from error
    except TypeError as error:
        raise TypeError(f"{path}{error}") from error


def by_path(values: Mapping[str, Any]) -> dict[str, Any]:
    """Return values by path, such as ``"learner.sigma"``, as nested settings."""
    plain: dict[str, Any] = {}
    for path, value in values.items():
        put(plain, path, value)
    return plain


def put(plain: dict[str, Any], path: str, value: Any) -> None:
    """Set the value of a path in nested settings; a text names the kind of a section."""
    first, dot, rest = path.partition(".")
    inside = plain.get(first)
    if dot:
        # A text stands for a whole section, of which a part is now given, too.
        inner = inside if isinstance(inside, dict) else {} if inside is None else {"kind": inside}
        plain[first] = inner
        put(inner, rest, value)
    else:
        plain[first] = {**inside, "kind": value} if isinstance(inside, dict) else value


def merged(cls: Any, plain: Mapping[str, Any], changes: Mapping[str, Any]) -> dict[str, Any]:
    """Return the nested settings of a class with changes.

    A section of another class starts from its defaults; of the same class, it keeps what is not
    changed.
    """
    found = dict(plain)
    hints = hints_of(cls) if cls else {}
    for name, value in changes.items():
        before, known = found.get(name), sections_in(hints.get(name))
        change = {"kind": value} if known and isinstance(value, str) else value
        if not isinstance(before, Mapping) or not isinstance(change, Mapping):
            found[name] = change
            continue
        old = str(before.get("kind", ""))
        new = str(change.get("kind", old))
        inner = known.get(old)
        if known.get(new) is inner:
            shorthand = inner.shorthands.get(new, {}) if inner else {}
            kind = {"kind": old} if old else {}
            found[name] = merged(inner, {**before, **shorthand}, {**change, **kind})
        else:
            found[name] = change
    return found


class Leaf(NamedTuple):
    """A single setting of a section and of those in it.

    Parameters
    ----------
    path : str
        Where it stands, such as ``"learner.sigma"``; for a section its kind.
    value : object
        Its value, as JSON holds it.
    help : str
        What it means.
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
            yield Leaf(here, to_plain(value), text)


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
