"""Results that were computed before, and the size at which notebooks compute.

What takes longer than a notebook should is kept in the package, in ``tutorial/data``. The scripts
in ``tutorials/make`` make it anew.
"""

from __future__ import annotations

import os
from pathlib import Path
from typing import TypeVar

from matrixworld._util.checks import shown
from matrixworld._util.files import load_arrays
from matrixworld._util.reading import Arrays

DATA = Path(__file__).parent / "data"
QUICK = "MATRIXWORLD_QUICK"
"""Environment variable: if it is 1, notebooks compute at the smaller size."""

T = TypeVar("T")


def kept(name: str) -> Arrays:
    """Return arrays that were computed before.

    Parameters
    ----------
    name : str
        Name of the file without its ending.

    Returns
    -------
    mapping of str to ndarray
        The arrays.

    Raises
    ------
    ValueError
        If nothing is kept under this name.
    """
    names = sorted(path.stem for path in DATA.glob("*.npz"))
    if name not in names:
        raise ValueError(f"name: expected one of {', '.join(names)}, got {shown(name)}")
    return load_arrays(DATA / f"{name}.npz")


def size(full: T, quick: T) -> T:
    """Return the size of an experiment: smaller where notebooks only have to prove that they run.

    Parameters
    ----------
    full : object
        The value for a reader.
    quick : object
        The value if the environment variable ``MATRIXWORLD_QUICK`` is 1.

    Returns
    -------
    object
        One of them.
    """
    return quick if os.environ.get(QUICK) == "1" else full
