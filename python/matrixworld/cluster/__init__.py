"""Many runs on many machines: the executor of a Dask cluster.

Only this package imports Dask (the extra ``cluster``). What hands out work knows an
``concurrent.futures.Executor`` and no cluster, so that other executors serve as well.
"""

from __future__ import annotations

from matrixworld.cluster.executor import ClusterLostError, UnfitWorkerError, check_where, cluster

__all__ = ["ClusterLostError", "UnfitWorkerError", "check_where", "cluster"]
