"""Many runs on many machines: the executor of a Dask cluster.

Only this package imports Dask (the extra ``cluster``). What hands out work knows an
``concurrent.futures.Executor`` and no cluster, so that other executors serve as well.

=================  ===============================================================================
module             contents
=================  ===============================================================================
connection         `cluster`: an executor on a cluster that exists, or on this machine's cores
executor           `ClusterExecutor`: hands out work, checks workers, says what went wrong
worker             `perform`: what a worker does with a piece of work
probe              `Probe`: whether another process can share work with equal results
=================  ===============================================================================
"""

from __future__ import annotations

from matrixworld.cluster.connection import check_where, cluster
from matrixworld.cluster.executor import (
    ClusterExecutor,
    ClusterLostError,
    UnfitWorkerError,
)
from matrixworld.cluster.probe import Probe, Traits

__all__ = [
    "ClusterExecutor",
    "ClusterLostError",
    "Probe",
    "Traits",
    "UnfitWorkerError",
    "check_where",
    "cluster",
]
