"""Stand-ins for what Python lacks in a browser (Pyodide), where there are no processes.

Gymnasium and `concurrent.futures` import locks and memory between processes, and DEAP a compiled
package for several objectives. Nothing here calls them: there are no processes to start, and one
objective.
"""

from __future__ import annotations

import sys
from importlib.util import find_spec
from types import ModuleType
from typing import Any

HAS_PROCESSES = find_spec("_multiprocessing") is not None

STAND_INS: dict[str, dict[str, Any]] = {
    "_multiprocessing": {
        "SemLock": type("SemLock", (), {"SEM_VALUE_MAX": 1}),
        "sem_unlink": None,
    },
    "_posixshmem": {"shm_unlink": None},
    "moocore": {},
}

if not HAS_PROCESSES:
    for name in filter(lambda name: find_spec(name) is None, STAND_INS):
        sys.modules[name] = ModuleType(name)
        vars(sys.modules[name]).update(STAND_INS[name])
