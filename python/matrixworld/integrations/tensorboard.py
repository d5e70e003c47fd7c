"""TensorBoard: curves of runs while they train."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from contextlib import ExitStack, contextmanager
from functools import cache
from pathlib import Path
from typing import Any

from matrixworld.coevolution.progress import OnEpoch
from matrixworld.integrations import scalars
from matrixworld.version import imported

__all__ = ["epoch_writer"]


@contextmanager
def epoch_writer(directory: str | Path = "tensorboard") -> Iterator[OnEpoch]:
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
            for name, value in scalars(row).items():
                writer(row["run"]).add_scalar(name, value, row["matches"])

        yield write
