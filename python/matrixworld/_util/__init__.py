"""What every room uses: checks of input and sizes, files, texts of results, colors.

A browser (Pyodide) has no processes, and so no locks or memory between them, which Gymnasium and
`concurrent.futures` import. DEAP imports a compiled package for several objectives. Stand-ins make
these imports work; nothing calls them there.
"""

from __future__ import annotations

import sys
from importlib.util import find_spec
from types import ModuleType
from typing import Any

HAS_PROCESSES = find_spec("_multiprocessing") is not None

_STAND_INS: dict[str, dict[str, Any]] = {
    "_multiprocessing": {
        "SemLock": type("SemLock", (), {"SEM_VALUE_MAX": 1}),
        "sem_unlink": None,
    },
    "_posixshmem": {"shm_unlink": None},
    "moocore": {},
}

if not HAS_PROCESSES:
    for _name in filter(lambda name: find_spec(name) is None, _STAND_INS):
        sys.modules[_name] = ModuleType(_name)
        vars(sys.modules[_name]).update(_STAND_INS[_name])
