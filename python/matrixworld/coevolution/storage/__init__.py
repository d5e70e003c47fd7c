"""Storage: run directories, to write while a run trains and to read at any time.

`run_directory` holds the files of a run and says which of them a stage writes; `saved_run` opens a
run to look at it. Atomic writes, checksums and locks of single files are in
`matrixworld._util.files`.
"""

from __future__ import annotations

from matrixworld.coevolution.storage.run_directory import (
    COLUMNS,
    SEVERAL,
    OtherVersionError,
    RunDirectory,
)
from matrixworld.coevolution.storage.saved_run import SavedRun, last_generation, open_run

__all__ = [
    "COLUMNS",
    "SEVERAL",
    "OtherVersionError",
    "RunDirectory",
    "SavedRun",
    "last_generation",
    "open_run",
]
