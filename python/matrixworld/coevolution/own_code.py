"""Learners and opponent samplers from outside the package: by name, made, checked.

Settings name one as an entry point of an installed package (`LEARNER`, `OPPONENT`) or as
``module:object``. The object is a class with the methods of the interface, or a function whose
return annotation is such a class. It is called with keyword arguments: those that the run gives, as
far as its signature names them, and its own settings.

In settings a name is data: they are checked, saved and read without an import. Only `find` imports,
when a run starts or continues. What it returns is checked in every call of a run; `check_learner`
and `check_sampler` check more, before the first run.
"""

from __future__ import annotations

import inspect
import io
import math
import os
import re
import sys
from collections.abc import Callable, Collection, Iterator, Mapping
from copy import deepcopy
from dataclasses import dataclass
from importlib import import_module
from importlib.metadata import entry_points
from operator import attrgetter
from typing import Any, TypeVar, get_type_hints

import numpy as np
from numpy.typing import ArrayLike

from matrixworld._util.checks import shown
from matrixworld.coevolution.types import FloatArray, Genome, Genomes, Indices, State

PATH = re.compile(r"[^\W\d]\w*(\.[^\W\d]\w*)*:[^\W\d]\w*(\.[^\W\d]\w*)*")
"""``module:object``, both with dots or without."""


class PluginError(RuntimeError):
    """Code from outside the package failed or returned what its interface does not allow.

    The message names the learner or sampler and its method; the cause is the original error.
    """


class ExitError(PluginError):
    """Code from outside the package wanted to end the process."""


# Names and settings, as data:


@dataclass(frozen=True)
class Interface:
    """What a class from outside the package has to be.

    Entry points of `group` name such classes, messages call one `what`. It has the `methods`; its
    instances have the `attributes`, too.
    """

    what: str
    group: str
    methods: tuple[str, ...]
    attributes: tuple[str, ...] = ()


LEARNER = Interface(
    "learner",
    "matrixworld.learners",
    ("ask", "tell", "state", "restore"),
    ("genome", "seed_groups"),
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
    def signature(self) -> inspect.Signature:
        """The signature of the class or function; ValueError if it has none."""
        return inspect.signature(self.factory)

    def make(self, run: Mapping[str, Any], own: Mapping[str, Any]) -> Any:
        """Return a new instance.

        `run` are the arguments that the run has for it, of which those are passed that its
        signature names; `own` are settings of its own. ValueError if it does not have these
        settings, or refuses their values; PluginError on any other error.
        """
        parameters = self.signature.parameters
        given = {name: run[name] for name in parameters if name in run}
        try:
            self.signature.bind(**given, **own)
        except TypeError as error:
            unnamed = (inspect.Parameter.VAR_POSITIONAL, inspect.Parameter.VAR_KEYWORD)
            known = [
                n for n, each in parameters.items() if n not in run and each.kind not in unnamed
            ]
            raise ValueError(
                f"{self.title}: expected its settings ({', '.join(known) or 'it has none'}), got "
                f"{own} ({error})"
            ) from error
        try:
            made = self.factory(**given, **own)
        except ValueError as error:
            raise ValueError(
                f"{self.title}: expected settings that it accepts, got {own} ({error})"
            ) from error
        except (Exception, SystemExit) as error:
            raise plugin_error(self.title, error) from error
        expected = (*self.interface.attributes, *self.interface.methods)
        for name in expected:
            # Not by hasattr, which would compute a property.
            if inspect.getattr_static(made, name, None) is None and not hasattr(made, name):
                raise PluginError(f"{self.title}: expected {', '.join(expected)}, got no {name}")
        return made


def find(code: str | Callable[..., Any], interface: Interface) -> Plugin:
    """Return a class or function; import it if `code` is its name.

    Raises ValueError if there is no such module or object, PluginError if the module itself fails.
    """
    if not isinstance(code, str):
        name = f"{code.__module__}:{getattr(code, '__qualname__', type(code).__qualname__)}"
        return Plugin(interface, name, code)
    name = code
    path = name if PATH.fullmatch(name) else _path_of(name, interface)
    module, _, attribute = path.partition(":")
    try:
        found = attrgetter(attribute)(_imported(name, module, interface))
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
    if len(paths) != 1:
        raise ValueError(
            f"{interface.what}: expected one installed package with {name!r}, got "
            f"{', '.join(paths) or 'none; install the package of it'}"
        )
    return paths[0]


def _imported(name: str, module: str, interface: Interface) -> Any:
    # An installed command looks for modules where it lies itself, not where the user is.
    if os.getcwd() not in sys.path:
        sys.path.append(os.getcwd())
    try:
        return import_module(module)
    except (Exception, SystemExit) as error:
        # A module that exists may fail to import another one: then the error names that one.
        missing = isinstance(error, ModuleNotFoundError) and error.name
        if missing and f"{module}.".startswith(f"{missing}."):
            raise ValueError(
                f"{interface.what}: expected a module that can be imported, got {name!r} "
                f"({error}); install the package that has it, or put its folder on PYTHONPATH"
            ) from error
        raise plugin_error(f"{interface.what} {name}: import", error) from error


def plugin_error(where: str, error: BaseException) -> PluginError:
    """Return what stands for an error of code from outside the package."""
    if isinstance(error, SystemExit):
        return ExitError(f"{where}: expected code that returns, got sys.exit({error.code!r})")
    return PluginError(f"{where}: {type(error).__name__}: {error}")


# Instances whose results are checked:


class Checked:
    """What learners and samplers from outside the package share: a state that files can hold.

    Errors of their methods become `PluginError`, as does what their interface does not allow.
    """

    def __init__(self, plugin: Plugin, made: Any) -> None:
        self.title: str = plugin.title
        self.made: Any = made

    def asked(self, name: str, *args: Any) -> Any:
        """Return an attribute, or the result of a method."""
        try:
            found = getattr(self.made, name)
            return found(*args) if callable(found) else found
        except PluginError:
            raise
        except (Exception, SystemExit) as error:
            raise plugin_error(f"{self.title}: {name}", error) from error

    def refused(self, name: str, expected: str, got: Any) -> PluginError:
        """Return the error for what an attribute or a method has given."""
        return PluginError(f"{self.title}: {name}: expected {expected}, got {got}")

    def state(self) -> State:
        """Return its state."""
        state = self.asked("state")
        if not isinstance(state, dict):
            raise self.refused("state", "arrays by name", type(state).__name__)
        for name, value in state.items():
            # A checkpoint holds the arrays of all parts of a run, as part.name.
            if not isinstance(name, str) or not name.isidentifier():
                raise self.refused("state", "names such as sigma", repr(name))
            if not isinstance(value, np.ndarray) or value.dtype.hasobject:
                raise self.refused("state", f"an array of numbers or text as {name}", repr(value))
        # Copies: a run may restore a state of before a generation, which must not have changed.
        return {name: value.copy() for name, value in state.items()}

    def restore(self, state: State) -> None:
        """Restore a state returned by `state()`."""
        self.asked("restore", state)


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
        # A copy: the archive keeps it, and the learner may change its own array in place.
        return np.array(self._checked("genome", self.asked("genome"), (self.genes,)))

    @property
    def seed_groups(self) -> Indices:
        """The groups of its candidates."""
        groups = np.asarray(self.asked("seed_groups"))
        numbers = groups.shape == (self.samples,) and groups.dtype.kind in "iu"
        within = numbers and groups.min() >= 0 and groups.max() < self.samples
        if not within or len(set(np.bincount(groups).tolist())) != 1:
            expected = f"{self.samples} numbers of groups from 0, all of one size"
            raise self.refused("seed_groups", expected, groups.tolist())
        return groups

    def ask(self, rng: np.random.Generator) -> Genomes:
        """Return its candidates."""
        return self._checked("ask", self.asked("ask", rng), (self.samples, self.genes))

    def tell(self, fitness: ArrayLike) -> None:
        """Tell it the fitness of its candidates."""
        self.asked("tell", fitness)

    def _checked(self, name: str, found: Any, shape: tuple[int, ...]) -> Genomes:
        """Return what it gave; PluginError unless it is finite float32 of this shape."""
        is_array = isinstance(found, np.ndarray)
        if not is_array or (found.shape, found.dtype) != (shape, np.float32):
            got = f"{found.dtype} {found.shape}" if is_array else type(found).__name__
            raise self.refused(name, f"an array of float32 {shape}", got)
        if not np.isfinite(found).all():
            raise self.refused(name, "finite numbers", "NaN or infinity")
        genomes: Genomes = found
        return genomes


class CheckedSampler(Checked):
    """A sampler from outside the package; `OpponentSampler` says what it has to return."""

    def __init__(self, plugin: Plugin, count: int, settings: Mapping[str, Any]) -> None:
        super().__init__(plugin, plugin.make({"count": count}, settings))
        self.count = count

    def sample(self, available: int, epoch: int, rng: np.random.Generator) -> Indices:
        """Return the opponents of an epoch."""
        found = np.asarray(self.asked("sample", available, epoch, rng))
        most = min(self.count, available)
        numbers = found.dtype.kind in "iu" and found.ndim == 1 and 1 <= len(found) <= most
        within = numbers and found.min() >= 0 and found.max() < available
        if not within or len(np.unique(found)) < len(found):
            expected = f"1 to {most} different opponents from 0 to {available - 1}"
            raise self.refused("sample", expected, found.tolist())
        return found.astype(np.intp)

    def tell(self, opponents: Indices, scores: ArrayLike) -> None:
        """Tell it the scores of the candidates."""
        self.asked("tell", opponents.copy(), scores)


# Checks before the first race:

Part = TypeVar("Part", CheckedLearner, CheckedSampler)
Step = Callable[[Part, int], list[np.ndarray[Any, Any]]]
"""Plays one epoch with a part of a run, and returns copies of what the part decided."""

EPOCHS, GENES = 6, 20
"""Epochs of a check, at the end of which states are restored, and genes of its candidates."""


def check_learner(
    learner: str | Callable[..., Any],
    settings: Mapping[str, Any] | None = None,
    *,
    samples: int = 8,
) -> None:
    """Check that a learner of one's own has the interface `Learner` and keeps its promises.

    Shapes, dtypes and names; equal results from equal generators; a state that, written to a file
    and restored in a new or in a used learner, continues bit for bit. In some epochs all fitness
    values are equal.

    Parameters
    ----------
    learner : str or callable
        A class, a function that returns a learner, or its name as in the settings.
    settings : mapping of str to bool, int, float or str, optional
        Settings of its own.
    samples : int, optional
        Candidates per epoch.

    Raises
    ------
    PluginError
        If a check fails; the message says which.
    ValueError
        If the learner cannot be imported, or refuses its settings.

    Examples
    --------
    >>> from matrixworld import coevolution
    >>> coevolution.check_learner(coevolution.CmaEs, {"sigma": 0.1})
    """
    plugin, own = find(learner, LEARNER), own_settings("settings", settings or {})
    genomes, target = np.random.default_rng(0).normal(size=(2, samples, GENES))

    def new() -> CheckedLearner:
        rng, start = np.random.default_rng([0, EPOCHS]), genomes.astype(np.float32)
        return CheckedLearner(plugin, start, rng, samples=samples, epochs=EPOCHS, settings=own)

    groups = new().seed_groups.copy()

    def step(part: CheckedLearner, epoch: int) -> list[np.ndarray[Any, Any]]:
        candidates = part.ask(np.random.default_rng([0, epoch])).copy()
        # Equal values are usual at the start of a race, and a learner may then take another path.
        distance: FloatArray = ((candidates - target[0]) ** 2).mean(axis=1)
        part.tell(np.zeros(samples) if epoch % 3 == 1 else -distance)
        if not np.array_equal(part.seed_groups, groups):
            raise part.refused("seed_groups", "equal groups in all epochs", f"others after {epoch}")
        return [candidates, part.genome]

    _check_part(new, step)


def check_sampler(
    sampler: str | Callable[..., Any],
    settings: Mapping[str, Any] | None = None,
    *,
    count: int = 2,
) -> None:
    """Check that a sampler of one's own has the interface `OpponentSampler` and keeps its promises.

    Numbers in range and without repetition; equal results from equal generators; a state that
    continues bit for bit. Raises as `check_learner` does.

    Parameters
    ----------
    sampler : str or callable
        A class, a function that returns a sampler, or its name as in the settings.
    settings : mapping of str to bool, int, float or str, optional
        Settings of its own.
    count : int, optional
        Opponents an epoch.

    Examples
    --------
    >>> from matrixworld import coevolution
    >>> coevolution.check_sampler(coevolution.opponents.Prioritized, {"decay": 0.9})
    """
    plugin, own = find(sampler, OPPONENT), own_settings("settings", settings or {})

    def step(part: CheckedSampler, epoch: int) -> list[np.ndarray[Any, Any]]:
        rng = np.random.default_rng([0, epoch])
        # Several epochs with the same opponents, then one more, as in a race.
        chosen = part.sample(1 + epoch // 2, epoch, rng)
        part.tell(chosen, rng.random((4, len(chosen))))
        return [chosen]

    _check_part(lambda: CheckedSampler(plugin, count, own), step)


def _check_part(new: Callable[[], Part], step: Step[Part]) -> None:
    """Check that results repeat, and that states restore them."""
    first = new()
    expected, states = [], [_saved(first)]
    for epoch in range(EPOCHS):
        expected.append(step(first, epoch))
        states.append(_saved(first))
    _check_equal(step, new(), 0, expected, "from equal generators and results")
    for epoch, state in enumerate(states):
        # `first` has gone further: a run that is interrupted restores its learners in place.
        for part, which in ((new(), "new"), (first, "used")):
            part.restore(deepcopy(state))
            when, saved = f"after restore in a {which} one", _saved(part)
            if state.keys() != saved.keys() or not all(
                np.array_equal(array, saved[name]) for name, array in state.items()
            ):
                raise part.refused("state", f"an equal one {when}", "another")
            _check_equal(step, part, epoch, expected, when)


def _check_equal(step: Step[Part], part: Part, start: int, expected: list[Any], when: str) -> None:
    for epoch in range(start, EPOCHS):
        found = step(part, epoch)
        same = (np.array_equal(a, b) for a, b in zip(found, expected[epoch], strict=True))
        if not all(same):
            raise PluginError(
                f"{part.title}: expected equal results {when}, got others in epoch {epoch}; random "
                f"numbers must come from the generator that is passed, and state() must return "
                f"all that changes"
            )


def _saved(part: CheckedLearner | CheckedSampler) -> State:
    """Return the state of a part as it comes back from a file."""
    buffer = io.BytesIO()
    np.savez(buffer, **part.state())  # type: ignore[arg-type]
    buffer.seek(0)
    with np.load(buffer, allow_pickle=False) as arrays:
        return {name: arrays[name] for name in arrays.files}
