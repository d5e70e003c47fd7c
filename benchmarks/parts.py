"""Wall time of the parts of a program, measured by wrapping its functions."""

from __future__ import annotations

import time
from collections import defaultdict
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import ExitStack, contextmanager
from functools import wraps
from typing import Any
from unittest.mock import patch

Functions = Sequence[tuple[object, str]]
"""Functions by owner (a module or a class) and name."""


class Parts:
    """Seconds by part.

    If a wrapped function calls another wrapped function, the time of the inner one counts for the
    inner one only. Therefore the parts add up to the total.
    """

    def __init__(self) -> None:
        self.seconds: defaultdict[str, float] = defaultdict(float)
        self._inside: list[str] = []
        self._since = 0.0

    @contextmanager
    def timed(self, part: str) -> Iterator[None]:
        """Count the time of the block for `part`."""
        self._enter(part)
        try:
            yield
        finally:
            self._leave()

    @contextmanager
    def wrapping(self, functions: Mapping[str, Functions]) -> Iterator[None]:
        """Time these functions by part within the block, then restore them."""
        with ExitStack() as stack:
            for part, members in functions.items():
                for owner, name in members:
                    stack.enter_context(patch.object(owner, name, self._wrapped(part, owner, name)))
            yield

    def _wrapped(self, part: str, owner: object, name: str) -> Any:
        function: Callable[..., Any] = getattr(owner, name)

        @wraps(function)
        def timed(*args: Any, **options: Any) -> Any:
            self._enter(part)
            try:
                return function(*args, **options)
            finally:
                self._leave()

        # A bound class method has its class already; as a plain function it would get an instance.
        return staticmethod(timed) if hasattr(function, "__self__") else timed

    def _enter(self, part: str) -> None:
        self._count()
        self._inside.append(part)

    def _leave(self) -> None:
        self._count()
        self._inside.pop()

    # Time since the last call belongs to the innermost part.
    def _count(self) -> None:
        now = time.perf_counter()
        if self._inside:
            self.seconds[self._inside[-1]] += now - self._since
        self._since = now
