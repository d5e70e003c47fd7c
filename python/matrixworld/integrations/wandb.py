"""Weights & Biases: curves of runs while they train."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from contextlib import ExitStack, contextmanager
from functools import cache
from typing import Any

from matrixworld.coevolution.progress import OnEpoch
from matrixworld.integrations import scalars
from matrixworld.version import imported

__all__ = ["epoch_writer"]


@contextmanager
def epoch_writer(**settings: Any) -> Iterator[OnEpoch]:
    """Log the epochs of a run, or of the runs of a job, to Weights & Biases.

    In a ``with`` statement it gives a callback for `matrixworld.coevolution.finish` and `evolve`.
    Each run is one of Weights & Biases, with its name and seed. Curves are columns of ``log.csv``,
    in a group for each team, over the training matches.

    Parameters
    ----------
    **settings
        Arguments of ``wandb.init``, such as ``project="races"`` or ``mode="offline"``.
    """
    init: Any = imported("wandb", "wandb").init
    with ExitStack() as open_runs:

        @cache
        def logged(run: str, seed: int) -> Any:
            named = {"name": run, "config": {"seed": seed}, "reinit": "create_new", **settings}
            made = open_runs.enter_context(init(**named))
            made.define_metric("*", step_metric="matches")
            return made

        def write(row: Mapping[str, Any]) -> None:
            logged(row["run"], row["seed"]).log({"matches": row["matches"], **scalars(row)})

        yield write
