"""Cases of which a plain call of pytest tries some, and an option all."""

from collections.abc import Callable, Iterable
from typing import Any

import pytest


def quickly(
    parameter: str,
    cases: Iterable[Any],
    is_quick: Callable[[Any], bool],
    name: Callable[[Any], str] = str,
    *,
    others: pytest.MarkDecorator = pytest.mark.nightly,
) -> Any:
    """Parametrize a test by cases; those that are not quick are marked as `others`."""
    marked = [pytest.param(x, id=name(x), marks=() if is_quick(x) else others) for x in cases]
    return pytest.mark.parametrize(parameter, marked)
