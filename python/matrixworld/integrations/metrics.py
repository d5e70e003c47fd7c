"""TensorBoard, and Weights & Biases: curves of runs while they train."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from contextlib import ExitStack, contextmanager
from functools import cache
from pathlib import Path
from typing import Any

from matrixworld.coevolution.progress import OnEpoch
from matrixworld.version import imported

__all__ = ["tensorboard_writer", "wandb_writer"]


def _scalars(row: Mapping[str, Any]) -> dict[str, float]:
    """Return what a row of an epoch measures, by names such as ``pursuer/capture_rate``."""
    places = {"run", "seed", "stage", "team", "epoch", "opponent", "matches"}
    return {f"{row['team']}/{key}": value for key, value in row.items() if key not in places}


@contextmanager
def tensorboard_writer(directory: str | Path = "tensorboard") -> Iterator[OnEpoch]:
    """Write the epochs of a run, or of the runs of a job, for TensorBoard.

    In a ``with`` statement it gives a callback for `matrixworld.coevolution.finish` and `evolve`.
    Curves are columns of ``log.csv``, in a group for each team, over the training matches.

    Parameters
    ----------
    directory : str or Path, optional
        Gets a directory for each run, with its name. The default is ``"tensorboard"``.
    """
    new: Any = imported("tensorboardX", "tensorboard").SummaryWriter
    with ExitStack() as open_writers:

        @cache
        def writer(run: str) -> Any:
            return open_writers.enter_context(new(str(Path(directory) / run), flush_secs=5))

        def write(row: Mapping[str, Any]) -> None:
            for name, value in _scalars(row).items():
                writer(row["run"]).add_scalar(name, value, row["matches"])

        yield write


@contextmanager
def wandb_writer(**settings: Any) -> Iterator[OnEpoch]:
    """Log the epochs of a run, or of the runs of a job, to Weights & Biases.

    As `tensorboard_writer`. Each run is one of Weights & Biases, with its name and seed.

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
            logged(row["run"], row["seed"]).log({"matches": row["matches"], **_scalars(row)})

        yield write
