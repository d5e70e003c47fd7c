"""PettingZoo's conformance tests, imported without the warnings of its own environments."""

from __future__ import annotations

import warnings

with warnings.catch_warnings():  # with pygame installed, PettingZoo imports outdated environments
    warnings.simplefilter("ignore", DeprecationWarning)
    from pettingzoo.test import (
        api_test,
        max_cycles_test,
        parallel_api_test,
        parallel_seed_test,
        render_test,
        seed_test,
    )

__all__ = [
    "api_test",
    "max_cycles_test",
    "parallel_api_test",
    "parallel_seed_test",
    "render_test",
    "seed_test",
]
