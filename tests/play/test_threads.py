"""The default number of threads."""

import os
from pathlib import Path

import pytest

from matrixworld._util import checks
from scripts import run


@pytest.mark.skipif(not hasattr(os, "sched_setaffinity"), reason="the system binds no processes")
def test_the_default_follows_the_affinity() -> None:
    """A batch starts a thread for each core of the process but one; the caller works, too."""
    output = run("""
from pathlib import Path
from matrixworld._util.checks import usable_cores

def threads_of(*cores):
    os.sched_setaffinity(0, cores)
    before = len(list(Path("/proc/self/task").iterdir()))
    batch = mw.Batch(100)
    return len(list(Path("/proc/self/task").iterdir())) - before, usable_cores()

cores = sorted(os.sched_getaffinity(0))
print(threads_of(cores[0]))
if len(cores) > 1:
    print(threads_of(*cores[:2]))
""")
    assert output.splitlines() in ([str((0, 1))], [str((0, 1)), str((1, 2))])


@pytest.mark.parametrize(
    ("own", "limits", "cores"),
    [
        (None, {}, 1024),
        ("0::/\n", {".": "150000 100000\n"}, 1.5),
        ("1:cpu:/x\n0::/a/b\n", {"a": "400000 100000\n", "a/b": "max 100000\n"}, 4),
    ],
)
def test_control_groups_limit_cores(
    own: str | None,
    limits: dict[str, str],
    cores: float,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(checks, "_OWN_GROUP", tmp_path / "own")
    monkeypatch.setattr(checks, "_GROUPS", tmp_path / "groups")
    if own is not None:
        (tmp_path / "own").write_text(own)
    for folder, limit in limits.items():
        (tmp_path / "groups" / folder).mkdir(parents=True, exist_ok=True)
        (tmp_path / "groups" / folder / "cpu.max").write_text(limit)
    assert checks.control_group_cores.__wrapped__() == cores
