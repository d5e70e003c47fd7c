"""Tables of bad input: the call, the exception, and the message."""

from collections.abc import Callable
from typing import Any

import pytest

import matrixworld as mw
from rows import random_genome

SMALL = {"rows": 3, "cols": 4, "n_pursuers": 2, "n_evaders": 1}
CONFIG = mw.WorldConfig(**SMALL, fov=5)
NETWORK = mw.Network.for_config(CONFIG, (4,))
GENOME = random_genome(NETWORK, 0)


def value(call: Any, says: str) -> Any:
    """Return a case of a wrong value; `says` is ``"expected part | got part"`` of the message."""
    return pytest.param(call, ValueError, says, id=says)


def kind(call: Any, says: str) -> Any:
    """Return a case of a value of a wrong type."""
    return pytest.param(call, TypeError, says, id=says)


def table(cases: list[Any]) -> pytest.MarkDecorator:
    return pytest.mark.parametrize(("call", "error", "says"), cases)


def assert_refuses(call: Callable[[], Any], error: type[Exception], says: str) -> None:
    """Check the type of the exception, and both parts of its message."""
    expected, received = says.split(" | ")
    with pytest.raises(error) as caught:
        call()
    message = str(caught.value)
    # A subclass could be an accident, such as UnicodeDecodeError.
    assert type(caught.value) is error
    assert f"expected {expected}" in message, message
    assert received in message, message
