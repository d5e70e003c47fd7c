"""Storage: run directories, to write while a run trains and to read afterwards.

=================  ===============================================================================
module             contents
=================  ===============================================================================
run_files          `RunFiles`: the files of a run, their checksums, and how they are read
consistency        which of them may stand beside each other
run_directory      `RunDirectory`: the same files to write; checkpoints and the lock
appended_file      `AppendedFile`: a file that grows, with a checksum of what a checkpoint counts
genome_file        `GenomeFile`: pursuers.npy and evaders.npy, one genome per generation
run_log            `RunLog`, `read_log`: log.csv, one row per epoch
saved_run          `open_run`: a run to look at, finished or not; `SavedRun`
=================  ===============================================================================

Atomic writes, checksums and locks of single files are in `matrixworld._util.files`, limits of what
is read in `matrixworld._util.reading`.
"""

from __future__ import annotations

from matrixworld.coevolution.storage.run_directory import RunDirectory
from matrixworld.coevolution.storage.run_files import OtherVersionError
from matrixworld.coevolution.storage.run_log import COLUMNS, SEVERAL, RunLog, read_log
from matrixworld.coevolution.storage.saved_run import SavedRun, last_generation, open_run

__all__ = [
    "COLUMNS",
    "SEVERAL",
    "OtherVersionError",
    "RunDirectory",
    "RunLog",
    "SavedRun",
    "last_generation",
    "open_run",
    "read_log",
]
