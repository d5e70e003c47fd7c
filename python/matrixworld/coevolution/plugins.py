"""Learners and opponent samplers from outside the package, by name.

Settings name a learner and its samplers: a built-in one, an entry point of an installed package
(see `LEARNER` and `OPPONENT`), or ``module:object``. The object is a class with the methods of the
interface, or a function whose return annotation is such a class. It is called with keyword
arguments: those that the run gives, as far as its signature names them, and its own settings.

In settings a name is data: they are checked, saved and read without an import. Only `find` imports,
when a run starts or continues.
"""

from __future__ import annotations

import inspect
import math
import re
from collections.abc import Callable, Collection, Iterator, Mapping
from dataclasses import dataclass
from importlib import import_module
from importlib.metadata import entry_points
from typing import Any, get_type_hints

import numpy as np

from matrixworld.coevolution.plugin_checks import PluginError, described

PATH = re.compile(r"[^\W\d]\w*(\.[^\W\d]\w*)*:[^\W\d]\w*(\.[^\W\d]\w*)*")
"""``module:object``, both with dots or without."""

ANY_NAME = inspect.Parameter.VAR_KEYWORD
UNNAMED = (inspect.Parameter.VAR_POSITIONAL, ANY_NAME)


@dataclass(frozen=True)
class Interface:
    """What a class from outside the package has to be.

    Parameters
    ----------
    group : str
        Group of entry points that name such classes.
    methods : tuple of str
        Methods that the class must have.
    """

    group: str
    methods: tuple[str, ...]


LEARNER = Interface("matrixworld.learners", ("ask", "tell", "state", "restore"))
OPPONENT = Interface("matrixworld.opponents", ("sample", "tell", "state", "restore"))


class SavedName(str):
    """A name from the files of a run: data, whether or not such a learner is known here."""

    __slots__ = ()


class OwnSettings(Mapping[str, Any]):
    """Settings of a learner or sampler of one's own: a mapping that never changes.

    Parameters
    ----------
    values : mapping of str to bool, int, float or str, optional
        Values by name. The order of the names does not matter.
    """

    def __init__(self, values: Mapping[str, Any] | None = None) -> None:
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


def own_settings(field: str, given: Any) -> OwnSettings:
    """Return settings as they are kept in files; TypeError or ValueError if they cannot be kept."""
    if not isinstance(given, Mapping):
        raise TypeError(
            f"{field}: expected values by name, such as {{'sigma': 0.1}}, got {given!r}"
        )
    # NumPy's numbers as Python's, which JSON can hold.
    values = {name: v.item() if isinstance(v, np.generic) else v for name, v in given.items()}
    for name, value in values.items():
        if not isinstance(name, str) or not name.isidentifier():
            raise ValueError(f"{field}: expected names such as sigma, got {name!r}")
        if not isinstance(value, bool | int | float | str):
            raise TypeError(
                f"{field}: expected a number, text, True or False as {name}, got {value!r}"
            )
        if isinstance(value, float) and not math.isfinite(value):
            raise ValueError(f"{field}: expected a finite number as {name}, got {value}")
    return OwnSettings(values)


def installed(interface: Interface) -> dict[str, list[str]]:
    """Return entry points by name: ``module:object`` in each package that has the name."""
    found: dict[str, set[str]] = {}
    for point in entry_points(group=interface.group):
        found.setdefault(point.name, set()).add(f"{point.module}:{point.attr}")
    return {name: sorted(paths) for name, paths in sorted(found.items())}


def check_name(field: str, name: str, builtin: Collection[str], interface: Interface) -> None:
    """Raise ValueError unless a name may be one of a learner or sampler; imports nothing.

    Parameters
    ----------
    field : str
        Field of the settings.
    name : str
        Its value. A `SavedName` is always accepted.
    builtin : collection of str
        Names in the package.
    interface : Interface
        `LEARNER` or `OPPONENT`.
    """
    if isinstance(name, SavedName):
        return
    # Entry points last: to list them reads the files of all installed packages.
    if not isinstance(name, str) or not (
        name in builtin or PATH.fullmatch(name) or name in installed(interface)
    ):
        raise ValueError(_unknown(field, name, builtin, interface))


def _unknown(field: str, name: Any, builtin: Collection[str], interface: Interface) -> str:
    names = ", ".join([*builtin, *installed(interface)])
    return f"{field}: expected one of {names}, or module:object, got {name!r}"


@dataclass(frozen=True)
class Plugin:
    """A class from outside the package, or a function that returns an instance.

    Parameters
    ----------
    field : str
        Field of the settings that names it, such as "learner".
    name : str
        Its name, for messages.
    factory : callable
        The class or function.
    """

    field: str
    name: str
    factory: Callable[..., Any]

    @property
    def title(self) -> str:
        """What messages call it, such as "learner hill:HillClimber"."""
        return f"{self.field} {self.name}"

    @property
    def parameters(self) -> Mapping[str, inspect.Parameter]:
        """The parameters of the class or function."""
        try:
            return inspect.signature(self.factory).parameters
        except (TypeError, ValueError) as error:
            raise ValueError(
                f"{self.field}: expected a class or function with a signature, got {self.name!r}"
            ) from error

    def make(self, run: Mapping[str, Any], own: OwnSettings) -> Any:
        """Return a new instance.

        Parameters
        ----------
        run : mapping of str to object
            Arguments that the run has for it; those that its signature names are passed.
        own : OwnSettings
            Settings of its own.

        Raises
        ------
        ValueError
            If it does not have these settings, or refuses their values.
        PluginError
            On any other error.
        """
        self._check(run, own)
        given = {name: run[name] for name in self.parameters if name in run}
        try:
            return self.factory(**given, **own)
        except ValueError as error:
            raise ValueError(
                f"{self.field}: expected settings that {self.name} accepts, got {own} ({error})"
            ) from error
        except Exception as error:
            raise PluginError(f"{self.title}: {described(error)}") from error

    def _check(self, run: Mapping[str, Any], own: OwnSettings) -> None:
        """Raise ValueError unless the settings are those that the signature declares."""
        field, parameters = f"{self.field}_settings", self.parameters
        named = {
            name: parameter
            for name, parameter in parameters.items()
            if parameter.kind not in UNNAMED and name not in run
        }
        takes_any = any(parameter.kind is ANY_NAME for parameter in parameters.values())
        for name in own:
            if name not in named and (name in run or not takes_any):
                known = ", ".join(named) or "it has none"
                raise ValueError(
                    f"{field}: expected settings of {self.name} ({known}), got {name!r}"
                )
        for name, parameter in named.items():
            if parameter.default is parameter.empty and name not in own:
                raise ValueError(
                    f"{field}: expected a value of {name}, without which there is no {self.name}, "
                    f"got none"
                )


def find(field: str, name: str, builtin: Collection[str], interface: Interface) -> Plugin:
    """Import a class or function.

    Parameters
    ----------
    field, name, builtin, interface
        As in `check_name`.

    Returns
    -------
    Plugin
        What the name stands for.

    Raises
    ------
    ValueError
        If there is no such module or object.
    PluginError
        If the module itself fails.
    """
    path = str(name) if PATH.fullmatch(name) else _path_of(field, name, builtin, interface)
    module, _, attribute = path.partition(":")
    found: Any = _imported(field, name, module)
    try:
        for part in attribute.split("."):
            found = getattr(found, part)
    except AttributeError as error:
        raise ValueError(
            f"{field}: expected the name of an object in {module}, got {attribute!r}"
        ) from error
    # Before it is called: the files of a stranger's run must not name any function at all.
    made = found if inspect.isclass(found) else _returned(found)
    if not all(hasattr(made, method) for method in interface.methods):
        raise ValueError(
            f"{field}: expected a class with {', '.join(interface.methods)}, or a function whose "
            f"return annotation is one, got {path}"
        )
    return Plugin(field, str(name), found)


def _returned(found: Any) -> Any:
    """Return the class in a function's return annotation; None if there is none."""
    try:
        return get_type_hints(found).get("return")
    except (AttributeError, NameError, SyntaxError, TypeError):
        return None


def _path_of(field: str, name: str, builtin: Collection[str], interface: Interface) -> str:
    paths = installed(interface).get(name, [])
    if not paths:
        raise ValueError(
            f"{_unknown(field, str(name), builtin, interface)}; install the package of it"
        )
    if len(paths) > 1:
        raise ValueError(
            f"{field}: expected one installed package with {str(name)!r}, got {', '.join(paths)}"
        )
    return paths[0]


def _imported(field: str, name: str, module: str) -> Any:
    try:
        return import_module(module)
    except ModuleNotFoundError as error:
        # A module that exists may fail to import another one: then the error names that one.
        if error.name and f"{module}.".startswith(f"{error.name}."):
            raise ValueError(
                f"{field}: expected a module that can be imported, got {str(name)!r} ({error}); "
                f"install the package that has it, or put its folder on PYTHONPATH"
            ) from error
        raise PluginError(f"{field} {name}: import: {described(error)}") from error
    except Exception as error:
        raise PluginError(f"{field} {name}: import: {described(error)}") from error
