"""Learners and opponent samplers of your own: by name, made, checked.

In settings and in files one is named as ``module:object``. The object is a class with the methods
of the interface, or a function whose return annotation is such a class. It is called with keyword
arguments: those that the run gives, as far as its signature names them, and its own settings.

A name is data: settings are checked, saved and read without an import. Only `find` imports, when a
run starts or continues. A run trusts what is made; `check_learner` and `check_sampler` check it,
before the first run.
"""

from __future__ import annotations

import inspect
import io
import math
import os
import re
import sys
from collections.abc import Callable, Mapping
from copy import deepcopy
from importlib import import_module
from operator import attrgetter
from typing import Any, get_type_hints

import numpy as np

from matrixworld._util.checks import check_integer, shown
from matrixworld.coevolution.types import State

PATH = re.compile(r"[^\W\d]\w*(\.[^\W\d]\w*)*:[^\W\d]\w*(\.[^\W\d]\w*)*")
"""``module:object``, both with dots or without."""


class PluginError(RuntimeError):
    """Code of your own cannot be imported or made, or does not keep a promise of its interface.

    The message names the learner or sampler; the cause is the original error, if there is one.
    """


LEARNER, OPPONENT = "learner", "opponent sampler"
METHODS = {
    LEARNER: ("ask", "tell", "state", "restore"),
    OPPONENT: ("sample", "tell", "state", "restore"),
}
"""What a class of your own has to have, by what messages call it."""

Code = str | Callable[..., Any]
"""A class or function of your own, or its name."""


def name_of(code: Callable[..., Any]) -> str:
    """Return ``module:object`` for a class or function; ValueError if an import cannot find it."""
    name = f"{getattr(code, '__module__', '')}:{getattr(code, '__qualname__', '')}"
    if not PATH.fullmatch(name):  # such as what is inside a function
        raise ValueError(f"code: expected a class or function of a module, got {shown(code)}")
    return name


def check_own_settings(name: str, given: Any) -> dict[str, Any]:
    """Return settings of own code by name; TypeError or ValueError if files cannot keep them."""
    if not isinstance(given, Mapping):
        raise TypeError(f"{name}: expected values by name, such as {{'sigma': 0.1}}, got {given!r}")
    values = {key: v.item() if isinstance(v, np.generic) else v for key, v in given.items()}
    for key, value in values.items():
        if not isinstance(key, str) or not key.isidentifier():
            raise ValueError(f"{name}: expected names such as sigma, got {key!r}")
        is_number = isinstance(value, float) and math.isfinite(value)
        if not is_number and not isinstance(value, bool | int | str):
            expected = "a finite number, text, True or False"
            raise TypeError(f"{name}: expected {expected} as {key}, got {value!r}")
    return dict(sorted(values.items()))


def find(code: Code, what: str) -> Callable[..., Any]:
    """Return a class or function; import it if `code` is its name.

    Raises ValueError if there is no such module or object, PluginError if the module itself fails.
    """
    if not isinstance(code, str):
        if not callable(code):
            raise TypeError(f"{what}: expected a class or function, or its name, got {shown(code)}")
        return code
    module, _, attribute = code.partition(":")
    # An installed command looks for modules where it lies itself, not where the user is.
    if os.getcwd() not in sys.path:
        sys.path.append(os.getcwd())
    try:
        imported = import_module(module)
    except (Exception, SystemExit) as error:
        # A module that exists may fail to import another one: then the error names that one.
        missing = isinstance(error, ModuleNotFoundError) and error.name
        if missing and f"{module}.".startswith(f"{missing}."):
            raise ValueError(
                f"{what}: expected a module that can be imported, got {code!r} "
                f"({error}); install the package that has it, or put its folder on PYTHONPATH"
            ) from error
        raise _failed(f"{what} {code}: import", error) from error
    try:
        found: Callable[..., Any] = attrgetter(attribute)(imported)
    except AttributeError as error:
        raise ValueError(
            f"{what}: expected the name of an object in {module}, got {attribute!r}"
        ) from error
    # Before it is called: the files of a stranger's run must not name any function at all.
    kind = get_type_hints(found).get("return") if inspect.isroutine(found) else found
    if not inspect.isclass(kind) or not all(hasattr(kind, method) for method in METHODS[what]):
        raise ValueError(
            f"{what}: expected a class with {', '.join(METHODS[what])}, or a function whose return "
            f"annotation is one, got {code}"
        )
    return found


def made(code: Code, what: str, run: Mapping[str, Any], own: Mapping[str, Any]) -> Any:
    """Return a new learner or sampler of your own.

    `run` are the arguments that the run has for it, of which those are passed that its signature
    names; `own` are settings of its own. ValueError if it cannot be found, does not have these
    settings or refuses their values; PluginError on any other error.
    """
    factory = find(code, what)
    title = f"{what} {code if isinstance(code, str) else code.__qualname__}"
    signature = inspect.signature(factory)
    given = {name: run[name] for name in signature.parameters if name in run}
    try:
        signature.bind(**given, **own)
    except TypeError as error:
        known = [name for name in signature.parameters if name not in run]
        raise ValueError(
            f"{title}: expected its settings ({', '.join(known) or 'it has none'}), got {own} "
            f"({error})"
        ) from error
    try:
        return factory(**given, **own)
    except ValueError as error:
        raise ValueError(
            f"{title}: expected settings that it accepts, got {own} ({error})"
        ) from error
    except (Exception, SystemExit) as error:
        raise _failed(title, error) from error


def _failed(where: str, error: BaseException) -> PluginError:
    return PluginError(f"{where}: {type(error).__name__}: {error}")


# Checks before the first run:

Step = Callable[[Any, int], list[np.ndarray[Any, Any]]]
"""Plays one epoch with a part of a run, and returns copies of what the part decided."""

EPOCHS, GENES = 6, 20
"""Epochs of a check, at the end of which states are restored, and genes of its candidates."""


def check_learner(
    learner: Code, settings: Mapping[str, Any] | None = None, *, samples: int = 8
) -> None:
    """Check that a learner of your own has the interface `Learner` and keeps its promises.

    Shapes, dtypes and names; equal results from equal generators; a state that, written to a file
    and restored in a new or in a used learner, continues bit for bit. In some epochs all fitness
    values are equal. An error in the learner's own code is raised as it is.

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
    own = check_own_settings("settings", settings or {})
    check_integer("samples", samples, 1)
    genomes, target = np.random.default_rng(0).normal(size=(2, samples, GENES)).astype(np.float32)

    def new() -> Any:
        run = {
            "genome": genomes[0].copy(),
            "genomes": genomes.copy(),
            "samples": samples,
            "epochs": EPOCHS,
            "rng": np.random.default_rng([0, EPOCHS]),
        }
        return made(learner, LEARNER, run, own)

    groups = np.array(new().seed_groups)
    numbers, sizes = np.unique(groups, return_counts=True)
    _expect(
        groups.shape == (samples,)
        and groups.dtype.kind in "iu"
        and 0 <= numbers[0] <= numbers[-1] < samples
        and len(set(sizes)) == 1,
        f"seed_groups: expected {samples} numbers of groups from 0, all of one size, got {groups}",
    )

    def step(part: Any, epoch: int) -> list[np.ndarray[Any, Any]]:
        asked = part.ask(np.random.default_rng([0, epoch]))
        candidates = _genomes("ask", asked, (samples, GENES))
        # Equal values are usual at the start of a race, and a learner may then take another path.
        distance = ((candidates - target[0]) ** 2).mean(axis=1, dtype=np.float64)
        part.tell(np.zeros(samples) if epoch % 3 == 1 else -distance)
        same = np.array_equal(part.seed_groups, groups)
        _expect(same, f"seed_groups: expected {groups} in all epochs, got {part.seed_groups}")
        return [candidates, _genomes("genome", part.genome, (GENES,))]

    _check_part(new, step)


def check_sampler(
    sampler: Code, settings: Mapping[str, Any] | None = None, *, count: int = 2
) -> None:
    """Check that a sampler of your own has the interface `OpponentSampler` and keeps its promises.

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
    own = check_own_settings("settings", settings or {})
    check_integer("count", count, 1)

    def step(part: Any, epoch: int) -> list[np.ndarray[Any, Any]]:
        rng = np.random.default_rng([0, epoch])
        # Several epochs with the same opponents, then one more, as in a race.
        available = 1 + epoch // 2
        most, chosen = min(count, available), part.sample(available, epoch, rng)
        _expect(
            isinstance(chosen, np.ndarray)
            and chosen.dtype.kind in "iu"
            and chosen.ndim == 1
            and 1 <= len(chosen) <= most
            and len({*chosen.tolist()} & {*range(available)}) == len(chosen),
            f"sample: expected 1 to {most} different opponents from 0 to {available - 1}, got "
            f"{chosen}",
        )
        part.tell(chosen, rng.random((4, len(chosen))))
        return [chosen.copy()]

    _check_part(lambda: made(sampler, OPPONENT, {"count": count}, own), step)


def _expect(kept: bool, promise: str) -> None:
    """Raise PluginError unless a promise is kept."""
    if not kept:
        raise PluginError(promise)


def _genomes(name: str, found: Any, shape: tuple[int, ...]) -> np.ndarray[Any, Any]:
    """Return a copy of what a learner gave; PluginError unless it is finite float32 (shape)."""
    array = np.array(found)
    _expect(
        isinstance(found, np.ndarray) and array.shape == shape and array.dtype == np.float32,
        f"{name}: expected an array of float32 {shape}, got {array.dtype} {array.shape}",
    )
    _expect(bool(np.isfinite(array).all()), f"{name}: expected finite numbers, got {array}")
    return array


def _check_part(new: Callable[[], Any], step: Step) -> None:
    """Check that results repeat, that states restore them, and that states stay as they were."""
    first = new()
    expected, states, kept = [], [_saved(first)], [first.state()]
    for epoch in range(EPOCHS):
        expected.append(step(first, epoch))
        states.append(_saved(first))
        kept.append(first.state())
    unchanged = all(map(_equal, states, kept))
    _expect(unchanged, "state: expected copies, got arrays that change afterwards")
    _check_equal(step, new(), 0, expected, "from equal generators and results")
    for epoch, state in enumerate(states):
        # `first` has gone further: a run that is interrupted restores its learners in place.
        for part, which in ((new(), "new"), (first, "used")):
            part.restore(deepcopy(state))
            when = f"after restore in a {which} one"
            _expect(_equal(state, _saved(part)), f"state: expected an equal one {when}")
            _check_equal(step, part, epoch, expected, when)


def _check_equal(step: Step, part: Any, start: int, expected: list[Any], when: str) -> None:
    for epoch in range(start, EPOCHS):
        _expect(
            all(map(np.array_equal, step(part, epoch), expected[epoch])),
            f"expected equal results {when}, got others in epoch {epoch}; random numbers must "
            f"come from the generator that is passed, and state() must return all that changes",
        )


def _equal(one: State, other: State) -> bool:
    return one.keys() == other.keys() and all(np.array_equal(one[n], other[n]) for n in one)


def _saved(part: Any) -> State:
    """Return the state of a part as it comes back from a file."""
    state = part.state()
    for name, value in state.items():
        # A checkpoint holds the arrays of all parts of a run, as part.name.
        _expect(name.isidentifier(), f"state: expected names such as sigma, got {name!r}")
        is_plain = isinstance(value, np.ndarray) and not value.dtype.hasobject
        _expect(is_plain, f"state: expected an array of numbers or text as {name}, got {value!r}")
    buffer = io.BytesIO()
    np.savez(buffer, **state)
    buffer.seek(0)
    with np.load(buffer, allow_pickle=False) as arrays:
        return {name: arrays[name] for name in arrays.files}
