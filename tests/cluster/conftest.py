"""A Dask cluster for the tests of a module, each of which asks for its workers."""

from collections.abc import Iterator

import pytest

from dask_cluster import DaskCluster, dask_cluster


@pytest.fixture(scope="module")
def dask(tmp_path_factory: pytest.TempPathFactory) -> Iterator[DaskCluster]:
    with dask_cluster(tmp_path_factory.mktemp("dask"), workers=0) as running:
        yield running
