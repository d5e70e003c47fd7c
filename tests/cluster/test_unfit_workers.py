"""Workers that cannot share the work are refused, and get none if they join later."""

import operator
import re
import shutil
from collections.abc import Callable
from pathlib import Path

import pytest

import matrixworld
from dask_cluster import DaskCluster
from matrixworld.cluster import UnfitWorkerError, cluster
from scripts import wait_until
from slow import quickly

pytest.importorskip("distributed")

BLIND = """
import sys
def refuse(event, args):
    if event == "open" and str(args[0]).startswith({place!r}):
        raise FileNotFoundError(2, "No such file or directory", args[0])
sys.addaudithook(refuse)
"""
EMPTY = """
import sys
class Finder:
    def find_spec(self, name, path=None, target=None):
        if name.partition(".")[0] == "matrixworld":
            raise ModuleNotFoundError("No module named 'matrixworld'")
sys.meta_path.insert(0, Finder())
"""


def other_version(place: Path) -> Path:
    """A directory with another version of the package."""
    source = Path(matrixworld.__file__).parent
    shutil.copytree(source, place / "matrixworld", ignore=shutil.ignore_patterns("__pycache__"))
    (place / "matrixworld" / "version.py").write_text(
        (source / "version.py").read_text().replace('__version__ = "', '__version__ = "9')
    )
    return place


def customized(place: Path, code: str) -> Path:
    """A directory whose code every Python process runs first."""
    place.mkdir()
    (place / "sitecustomize.py").write_text(code)
    return place


KINDS: dict[str, tuple[Callable[[Path, Path], Path], str]] = {
    "another version": (
        lambda place, out: other_version(place),
        r"it has another version of matrixworld \(expected .*, got 9",
    ),
    "no package": (
        lambda place, out: customized(place, EMPTY),
        ".*No module named .*matrixworld",
    ),
    "another file system": (
        lambda place, out: customized(place, BLIND.format(place=str(out))),
        "it does not see the files in .*out; the directory must be shared",
    ),
}


@pytest.mark.parametrize("kind", KINDS)
def test_an_unfit_worker_is_refused(dask: DaskCluster, tmp_path: Path, kind: str) -> None:
    dask.workers(0)
    make, problem = KINDS[kind]
    out = tmp_path / "out"
    dask.add_worker(make(tmp_path / "code", out))
    wait_until(lambda: len(dask.known()) == 1, "worker")
    expected = f"cluster: worker tcp://.* cannot take part: {problem}"
    with pytest.raises(UnfitWorkerError, match=expected), cluster(dask.address, directory=out):
        pytest.fail("expected a refusal")
    assert not out.exists()


@quickly("kind", ["another version", "no package"], lambda kind: kind == "another version")
def test_an_unfit_worker_that_joins_later_gets_no_work(
    dask: DaskCluster, tmp_path: Path, kind: str
) -> None:
    dask.workers(1)
    make, problem = KINDS[kind]
    told: list[str] = []
    with cluster(dask.address, tell=told.append) as executor:
        dask.add_worker(make(tmp_path / "code", tmp_path))
        wait_until(lambda: bool(told), "refusal")
        sums = [executor.submit(operator.add, 1, number) for number in range(12)]
        assert [each.result() for each in sums] == list(range(1, 13))
    [sentence] = told
    assert re.match(f"Worker tcp://.* gets no work: {problem}", sentence)
