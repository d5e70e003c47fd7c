"""What a worker of a cluster does with a piece of work."""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from dataclasses import dataclass
from functools import cache
from typing import Any

from matrixworld.cluster.probe import Probe


@dataclass(frozen=True)
class Call:
    """A function with its arguments. Not a tuple: older versions of Dask would call it."""

    function: Callable[..., Any]
    args: tuple[Any, ...]
    options: dict[str, Any]


@dataclass(frozen=True)
class Outcome:
    """What became of a piece of work that a worker could read."""

    value: Any = None
    error: BaseException | None = None
    unfit: str = ""
    worker: str = ""


def perform(probe: Probe, call: Call) -> Outcome:
    """Do a piece of work in this process, a worker, if it is fit for it."""
    unfit = _problem(probe)
    if unfit:
        from distributed import get_worker

        return Outcome(unfit=unfit, worker=get_worker().address)
    # Errors of the work travel as values: all others are errors of the cluster.
    try:
        return Outcome(call.function(*call.args, **call.options))
    except Exception as error:  # noqa: BLE001, raised again where the work comes from
        return Outcome(error=error)


async def check(probe: Probe) -> str:
    """Return `Probe.problem` of this process, a worker."""
    # Not in the thread that tells the scheduler that the worker lives.
    return await asyncio.to_thread(_problem, probe)


@cache
def _problem(probe: Probe) -> str:
    """Return `Probe.problem`, which a process finds out once."""
    return probe.problem()
