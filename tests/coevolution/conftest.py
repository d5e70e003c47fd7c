"""Directories of runs, for all tests of co-evolution."""

from collections.abc import Iterator
from pathlib import Path

import pytest

from tiny_race import directory_in_memory


@pytest.fixture
def tmp_path() -> Iterator[Path]:
    """A directory in memory: runs have many files, which are all synced."""
    with directory_in_memory() as directory:
        yield directory
