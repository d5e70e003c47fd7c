"""Operators of a DEAP toolbox as those of a game."""

from __future__ import annotations

import random
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

import numpy as np
from deap import base

from matrixworld._util.checks import check_instance
from matrixworld.coevolution.types import Rng


@contextmanager
def global_draws(seed: int) -> Iterator[None]:
    """Seed the global random numbers of Python and NumPy in a block; restore them after it."""
    before = random.getstate(), np.random.get_state()  # noqa: NPY002, what other code draws from
    random.seed(seed)
    np.random.seed(seed)  # noqa: NPY002
    try:
        yield
    finally:
        random.setstate(before[0])
        np.random.set_state(before[1])  # noqa: NPY002


def by_toolbox(toolbox: base.Toolbox) -> dict[str, Callable[..., Any]]:
    """Return the operators of a DEAP toolbox as arguments of a `Game`.

    DEAP's operators draw from the global random numbers of Python and of NumPy. These are seeded
    from the generator of a call, and afterwards are what they were before. Of the two children of
    `mate` the first one lives. Selection is that of the learner, such as `Breeding`.

    Parameters
    ----------
    toolbox : deap.base.Toolbox
        It has `individual` and `mutate`, and perhaps `mate`, registered as usual in DEAP.

    Returns
    -------
    dict
        ``initial``, ``mutate`` and perhaps ``mate``.

    Raises
    ------
    TypeError, ValueError
        If it is no toolbox, or lacks an operator.

    Examples
    --------
    >>> import random
    >>> from deap import base, tools
    >>> import matrixworld as mw
    >>> toolbox = base.Toolbox()
    >>> toolbox.register("individual", tools.initRepeat, list, random.random, 5)
    >>> toolbox.register("mutate", tools.mutGaussian, mu=0, sigma=0.1, indpb=0.5)
    >>> larger = mw.Game(
    ...     lambda a, b: float(sum(a) > sum(b)),
    ...     teams=("hosts", "parasites"),
    ...     **mw.coevolution.by_toolbox(toolbox),
    ...     deterministic=True,
    ... )
    """
    check_instance("toolbox", toolbox, base.Toolbox)
    missing = [name for name in ("individual", "mutate") if not hasattr(toolbox, name)]
    if missing:
        raise ValueError(f"toolbox: expected {missing[0]} to be registered, got none")

    def initial(rng: Rng) -> Any:
        with global_draws(int(rng.integers(2**32))):
            return toolbox.individual()

    def mutate(genome: Any, rng: Rng) -> Any:
        with global_draws(int(rng.integers(2**32))):
            return toolbox.mutate(genome)[0]

    def mate(one: Any, other: Any, rng: Rng) -> Any:
        with global_draws(int(rng.integers(2**32))):
            return toolbox.mate(one, other)[0]

    operators: dict[str, Callable[..., Any]] = {"initial": initial, "mutate": mutate}
    return operators | ({"mate": mate} if hasattr(toolbox, "mate") else {})
