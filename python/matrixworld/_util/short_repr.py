"""The text of results that hold arrays: shapes and dtypes instead of numbers."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import fields
from typing import Any

import numpy as np

LONGEST = 60
"""Characters of a value that is shown as it is."""


def short_repr(self: Any) -> str:
    """Return the ``repr`` of a dataclass in one line, for ``__repr__ = short_repr`` in its body.

    Arrays appear as dtype and shape, other long values as type and size.
    """
    shown = (f"{item.name}={_short(getattr(self, item.name))}" for item in fields(self))
    return f"{type(self).__name__}({', '.join(shown)})"


def _short(value: Any) -> str:
    if isinstance(value, np.ndarray):
        return f"<{value.dtype} {value.shape}>"
    text = repr(value)
    if len(text) <= LONGEST:
        return text
    name = type(value).__name__
    if isinstance(value, Mapping):
        return f"<{name} of {', '.join(map(str, value))}>"
    if isinstance(value, list | tuple):
        return f"<{name} of {len(value)}>"
    return f"<{name}>"
