"""Results as plain values that JSON can represent; shared by all results with `to_json`."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import fields, is_dataclass
from typing import Any

import numpy as np


def plain_values(value: Any) -> Any:
    """Return a result as dictionaries, lists, numbers, strings and None, nested as needed.

    Dataclasses and named tuples become dictionaries by field, arrays and tuples lists. Numbers that
    are not finite become None, since JSON cannot represent them.
    """
    if is_dataclass(value):
        return {item.name: plain_values(getattr(value, item.name)) for item in fields(value)}
    if hasattr(value, "_asdict"):  # a named tuple; before tuples, which lose the names
        return plain_values(value._asdict())
    if isinstance(value, Mapping):
        return {key: plain_values(item) for key, item in value.items()}
    if isinstance(value, np.ndarray):
        return plain_values(value.tolist())
    if isinstance(value, (list, tuple)):
        return [plain_values(item) for item in value]
    return None if isinstance(value, float) and not math.isfinite(value) else value
