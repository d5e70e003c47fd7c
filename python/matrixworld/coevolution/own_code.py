"""Learners and opponent samplers from outside the package: by name, made, with checked results.

Settings name one as an entry point of an installed package (`LEARNER`, `OPPONENT`) or as
``module:object``. The object is a class with the methods of the interface, or a function whose
return annotation is such a class. It is called with keyword arguments: those that the run gives, as
far as its signature names them, and its own settings.

In settings a name is data: they are checked, saved and read without an import. Only `find` imports,
when a run starts or continues.
"""

from __future__ import annotations

import inspect
import re
from collections.abc import Callable, Collection, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass
from importlib import import_module
from importlib.metadata import entry_points
from typing import Any, get_type_hints

import numpy as np
from numpy.typing import ArrayLike, DTypeLike

from matrixworld._util.checks import shown
from matrixworld.coevolution.types import Genome, Genomes, Indices, State

PATH = re.compile(r"[^\W\d]\w*(\.[^\W\d]\w*)*:[^\W\d]\w*(\.[^\W\d]\w*)*")
"""``module:object``, both with dots or without."""

ANY_NAME = inspect.Parameter.VAR_KEYWORD
UNNAMED = (inspect.Parameter.VAR_POSITIONAL, ANY_NAME)


class PluginError(RuntimeError):
    """Code from outside the package failed or returned what its interface does not allow.

    The message names the learner or sampler and its method; the cause is the original error.
    """


# Names:


@dataclass(frozen=True)
class Interface:
    """What a class from outside the package has to be.

    Entry points of `group` name such classes; of the `attributes` that it must have, methods are
    last. Messages call it `what`.
    """

    what: str
    group: str
    attributes: tuple[str, ...]

    @property
    def methods(self) -> tuple[str, ...]:
        """The methods that the class must have."""
        return self.attributes[-4:]


LEARNER = Interface(
    "learner",
    "matrixworld.learners",
    ("genome", "seed_groups", "ask", "tell", "state", "restore"),
)
OPPONENT = Interface(
    "opponent sampler", "matrixworld.opponents", ("sample", "tell", "state", "restore")
)


def installed(interface: Interface) -> dict[str, list[str]]:
    """Return entry points by name: ``module:object`` in each package that has the name."""
    found: dict[str, set[str]] = {}
    for point in entry_points(group=interface.group):
        found.setdefault(point.name, set()).add(f"{point.module}:{point.attr}")
    return {name: sorted(paths) for name, paths in sorted(found.items())}


def check_code(field: str, name: Any) -> None:
    """Raise ValueError unless a text may name own code; imports nothing.

    An entry point need not be installed here: a run is read where its code is missing, too.
    """
    if not isinstance(name, str) or not (PATH.fullmatch(name) or re.fullmatch(r"[\w.-]+", name)):
        raise ValueError(f"{field}: expected module:object or an installed name, got {shown(name)}")


def check_known(field: str, name: str, kinds: Collection[str], interface: Interface) -> None:
    """Raise ValueError unless a text that a user writes is ``module:object`` or installed here."""
    # Entry points last: to list them reads the files of all installed packages.
    if not (PATH.fullmatch(name) or name in installed(interface)):
        names = ", ".join([*kinds, *installed(interface)])
        raise ValueError(f"{field}: expected one of {names}, or module:object, got {shown(name)}")


# Classes and functions:


@dataclass(frozen=True)
class Plugin:
    """A class from outside the package, or a function that returns an instance, and its name."""

    interface: Interface
    name: str
    factory: Callable[..., Any]

    @property
    def title(self) -> str:
        """What messages call it, such as "learner hill:HillClimber"."""
        return f"{self.interface.what} {self.name}"

    @property
    def parameters(self) -> Mapping[str, inspect.Parameter]:
        """The parameters of the class or function."""
        try:
            return inspect.signature(self.factory).parameters
        except (TypeError, ValueError) as error:
            raise ValueError(
                f"{self.title}: expected a class or function with a signature"
            ) from error

    def make(self, run: Mapping[str, Any], own: Mapping[str, Any]) -> Any:
        """Return a new instance.

        `run` are the arguments that the run has for it, of which those are passed that its
        signature names; `own` are settings of its own. ValueError if it does not have these
        settings, or refuses their values; PluginError on any other error.
        """
        self._check(run, own)
        given = {name: run[name] for name in self.parameters if name in run}
        try:
            made = self.factory(**given, **own)
        except ValueError as error:
            raise ValueError(
                f"{self.title}: expected settings that it accepts, got {own} ({error})"
            ) from error
        except Exception as error:
            raise PluginError(f"{self.title}: {_described(error)}") from error
        for name in self.interface.attributes:
            # Not by hasattr, which would compute a property.
            if inspect.getattr_static(made, name, None) is None and not hasattr(made, name):
                expected = ", ".join(self.interface.attributes)
                raise PluginError(f"{self.title}: expected {expected}, got no {name}")
        return made

    def _check(self, run: Mapping[str, Any], own: Mapping[str, Any]) -> None:
        """Raise ValueError unless the settings are those that the signature declares."""
        parameters = self.parameters
        named = {
            name: parameter
            for name, parameter in parameters.items()
            if parameter.kind not in UNNAMED and name not in run
        }
        takes_any = any(parameter.kind is ANY_NAME for parameter in parameters.values())
        for name in own:
            if name not in named and (name in run or not takes_any):
                known = ", ".join(named) or "it has none"
                raise ValueError(f"{self.title}: expected its settings ({known}), got {name!r}")
        for name, parameter in named.items():
            if parameter.default is parameter.empty and name not in own:
                raise ValueError(
                    f"{self.title}: expected a value of the setting {name}, which has no default, "
                    f"got none"
                )


def find(name: str, interface: Interface) -> Plugin:
    """Import a class or function.

    Raises ValueError if there is no such module or object, PluginError if the module itself fails.
    """
    path = name if PATH.fullmatch(name) else _path_of(name, interface)
    module, _, attribute = path.partition(":")
    found: Any = _imported(name, module, interface)
    try:
        for part in attribute.split("."):
            found = getattr(found, part)
    except AttributeError as error:
        raise ValueError(
            f"{interface.what}: expected the name of an object in {module}, got {attribute!r}"
        ) from error
    # Before it is called: the files of a stranger's run must not name any function at all.
    made = found if inspect.isclass(found) else _returned(found)
    if not all(hasattr(made, method) for method in interface.methods):
        raise ValueError(
            f"{interface.what}: expected a class with {', '.join(interface.methods)}, or a "
            f"function whose return annotation is one, got {path}"
        )
    return Plugin(interface, name, found)


def _returned(found: Any) -> Any:
    """Return the class in a function's return annotation; None if there is none."""
    try:
        return get_type_hints(found).get("return")
    except (AttributeError, NameError, SyntaxError, TypeError):
        return None


def _path_of(name: str, interface: Interface) -> str:
    paths = installed(interface).get(name, [])
    if not paths:
        known = "".join(f"{each}, " for each in installed(interface))
        raise ValueError(
            f"{interface.what}: expected {known}one of the package or module:object, got {name!r}; "
            f"install the package of it"
        )
    if len(paths) > 1:
        raise ValueError(
            f"{interface.what}: expected one installed package with {name!r}, got "
            f"{', '.join(paths)}"
        )
    return paths[0]


def _imported(name: str, module: str, interface: Interface) -> Any:
    try:
        return import_module(module)
    except ModuleNotFoundError as error:
        # A module that exists may fail to import another one: then the error names that one.
        if error.name and f"{module}.".startswith(f"{error.name}."):
            raise ValueError(
                f"{interface.what}: expected a module that can be imported, got {name!r} "
                f"({error}); install the package that has it, or put its folder on PYTHONPATH"
            ) from error
        raise PluginError(f"{interface.what} {name}: import: {_described(error)}") from error
    except Exception as error:
        raise PluginError(f"{interface.what} {name}: import: {_described(error)}") from error


# Instances whose results are checked:


def _described(error: Exception) -> str:
    return f"{type(error).__name__}: {error}"


@contextmanager
def _errors_of(title: str, method: str) -> Iterator[None]:
    """Turn errors of a plugin's method into `PluginError`, which names both."""
    try:
        yield
    except PluginError:
        raise
    except Exception as error:
        raise PluginError(f"{title}: {method}: {_described(error)}") from error


class Checked:
    """What learners and samplers from outside the package share: a state that files can hold.

    Errors of their methods become `PluginError`, as does what their interface does not allow.
    """

    def __init__(self, plugin: Plugin, made: Any) -> None:
        self.title: str = plugin.title
        self.made: Any = made

    def state(self) -> State:
        """Return its state."""
        with _errors_of(self.title, "state"):
            state = self.made.state()
        if not isinstance(state, dict):
            got = type(state).__name__
            raise PluginError(f"{self.title}: state: expected arrays by name, got {got}")
        for name, value in state.items():
            # A checkpoint holds the arrays of all parts of a run, as part.name.
            if not isinstance(name, str) or not name.isidentifier():
                raise PluginError(
                    f"{self.title}: state: expected names such as sigma, got {name!r}"
                )
            if not isinstance(value, np.ndarray) or value.dtype.hasobject:
                raise PluginError(
                    f"{self.title}: state: expected an array of numbers or text as {name}, got "
                    f"{value!r}"
                )
        # Copies: a run may restore a state of before a generation, which must not have changed.
        return {name: value.copy() for name, value in state.items()}

    def restore(self, state: State) -> None:
        """Restore a state returned by `state()`."""
        with _errors_of(self.title, "restore"):
            self.made.restore(state)


class CheckedLearner(Checked):
    """A learner from outside the package; `Learner` says what it has to return.

    It starts from the first of `genomes` (n, genes), or from all of them if its signature names
    `genomes`.
    """

    def __init__(
        self,
        plugin: Plugin,
        genomes: Genomes,
        rng: np.random.Generator,
        *,
        samples: int,
        epochs: int,
        settings: Mapping[str, Any],
    ) -> None:
        # Copies: a learner that changes its genome in place must not change generation 0.
        run = {
            "genome": genomes[0].copy(),
            "genomes": genomes.copy(),
            "samples": samples,
            "epochs": epochs,
            "rng": rng,
        }
        super().__init__(plugin, plugin.make(run, settings))
        self.samples, self.genes = samples, genomes.shape[1]

    @property
    def genome(self) -> Genome:
        """The genome of the learner."""
        with _errors_of(self.title, "genome"):
            genome = self.made.genome
        self._check("genome", genome, (self.genes,), np.float32)
        # A copy: the archive keeps it, and the learner may change its own array in place.
        return np.array(genome)

    @property
    def seed_groups(self) -> Indices:
        """The groups of its candidates."""
        with _errors_of(self.title, "seed_groups"):
            groups = np.asarray(self.made.seed_groups)
        numbers = groups.shape == (self.samples,) and groups.dtype.kind in "iu"
        within = numbers and groups.min() >= 0 and groups.max() < self.samples
        if not within or len(set(np.bincount(groups).tolist())) != 1:
            raise PluginError(
                f"{self.title}: seed_groups: expected {self.samples} numbers of groups from 0, all "
                f"of one size, got {groups.tolist()}"
            )
        return groups

    def ask(self, rng: np.random.Generator) -> Genomes:
        """Return its candidates."""
        with _errors_of(self.title, "ask"):
            candidates: Genomes = self.made.ask(rng)
        self._check("ask", candidates, (self.samples, self.genes), np.float32)
        return candidates

    def tell(self, fitness: ArrayLike) -> None:
        """Tell it the fitness of its candidates."""
        with _errors_of(self.title, "tell"):
            self.made.tell(fitness)

    def _check(self, what: str, found: Any, shape: tuple[int, ...], dtype: DTypeLike) -> None:
        """Raise PluginError unless it returned an array of this shape and dtype, all finite."""
        wanted, is_array = np.dtype(dtype), isinstance(found, np.ndarray)
        if not is_array or (found.shape, found.dtype) != (shape, wanted):
            got = f"{found.dtype} {found.shape}" if is_array else type(found).__name__
            raise PluginError(
                f"{self.title}: {what}: expected an array of {wanted} {shape}, got {got}"
            )
        if not np.isfinite(found).all():
            raise PluginError(f"{self.title}: {what}: expected finite numbers, got NaN or infinity")


class CheckedSampler(Checked):
    """A sampler from outside the package; `OpponentSampler` says what it has to return."""

    def __init__(self, plugin: Plugin, count: int, settings: Mapping[str, Any]) -> None:
        super().__init__(plugin, plugin.make({"count": count}, settings))
        self.count = count

    def sample(self, available: int, epoch: int, rng: np.random.Generator) -> Indices:
        """Return the opponents of an epoch."""
        with _errors_of(self.title, "sample"):
            found = np.asarray(self.made.sample(available, epoch, rng))
        most = min(self.count, available)
        numbers = found.dtype.kind in "iu" and found.ndim == 1 and 1 <= len(found) <= most
        within = numbers and found.min() >= 0 and found.max() < available
        if not within or len(np.unique(found)) < len(found):
            raise PluginError(
                f"{self.title}: sample: expected 1 to {most} different opponents from 0 to "
                f"{available - 1}, got {found.tolist()}"
            )
        return found.astype(np.intp)

    def tell(self, opponents: Indices, scores: ArrayLike) -> None:
        """Tell it the scores of the candidates."""
        with _errors_of(self.title, "tell"):
            self.made.tell(opponents.copy(), scores)


def plugin_of(code: str | Callable[..., Any], interface: Interface) -> Plugin:
    """Return the plugin of a name, or of a class or function itself."""
    if isinstance(code, str):
        return find(code, interface)
    name = f"{code.__module__}:{getattr(code, '__qualname__', type(code).__qualname__)}"
    return Plugin(interface, name, code)
