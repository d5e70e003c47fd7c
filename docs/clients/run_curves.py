"""Curves of runs while they train, for TensorBoard or Weights & Biases: copy this file.

``pip install tensorboard tensorboardX`` or ``pip install wandb``. Curves are the columns of
``log.csv``, in a group for each team, over the training matches.
"""

from contextlib import ExitStack, contextmanager
from functools import cache
from pathlib import Path

PLACES = {"run", "seed", "stage", "team", "epoch", "opponent", "matches"}


def scalars(row):
    """Return what a row of an epoch measures, by names such as ``pursuer/capture_rate``."""
    return {f"{row['team']}/{key}": value for key, value in row.items() if key not in PLACES}


@contextmanager
def tensorboard_writer(directory="tensorboard"):
    """Give a callback ``on_epoch``, which writes each run into a directory with its name."""
    from tensorboardX import SummaryWriter

    with ExitStack() as open_writers:

        @cache
        def writer(run):
            return open_writers.enter_context(SummaryWriter(str(Path(directory) / run)))

        def write(row):
            for name, value in scalars(row).items():
                writer(row["run"]).add_scalar(name, value, row["matches"])

        yield write


@contextmanager
def wandb_writer(**settings):
    """Give a callback ``on_epoch``, which logs each run to a run of Weights & Biases.

    `settings` are arguments of ``wandb.init``, such as ``project="races"`` or ``mode="offline"``.
    """
    import wandb

    with ExitStack() as open_runs:

        @cache
        def logged(name, seed):
            own = {"name": name, "config": {"seed": seed}, "reinit": "create_new", **settings}
            run = open_runs.enter_context(wandb.init(**own))
            run.define_metric("*", step_metric="matches")
            return run

        def write(row):
            logged(row["run"], row["seed"]).log({"matches": row["matches"], **scalars(row)})

        yield write
