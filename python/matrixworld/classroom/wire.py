"""Messages between the process that plays and a process that holds a policy: bytes, no objects.

A message is its kind (one byte), its length (four bytes, little-endian) and its content. A reader
knows which kinds may come and how long they may be; anything else ends the connection. Nothing is
unpickled or evaluated.
"""

from __future__ import annotations

import struct
from collections.abc import Callable, Mapping

# To the policy:
SETTINGS, CODE, VIEWS = b"S", b"C", b"V"
# From the policy:
READY, ACTIONS, ERROR = b"R", b"A", b"E"

HEAD = struct.Struct("<cI")
LONGEST_ERROR = 2000
"""Most bytes of a text that a policy's process may send."""
NUMBER = "<u4"
"""Dtype of the numbers of agents in a message of views."""


class WireError(Exception):
    """The other side sent something that is no message, or ended the connection."""


def message(kind: bytes, content: bytes) -> bytes:
    """Return a message as bytes."""
    return HEAD.pack(kind, len(content)) + content


def receive(read: Callable[[int], bytes], longest: Mapping[bytes, int]) -> tuple[bytes, bytes]:
    """Return kind and content of the next message.

    Parameters
    ----------
    read : callable
        Returns at most so many bytes, and none at the end of the connection.
    longest : mapping of bytes to int
        The kinds that are expected, and the most bytes of their content.

    Raises
    ------
    EOFError
        If the connection has ended.
    WireError
        If the message is of another kind, or longer. Its content is not read.
    """
    kind, size = HEAD.unpack(_exactly(read, HEAD.size))
    if size > longest.get(kind, -1):
        raise WireError(f"expected {sorted(longest)}, got {kind!r} with {size} bytes")
    return kind, _exactly(read, size)


def _exactly(read: Callable[[int], bytes], size: int) -> bytes:
    parts, left = [], size
    while left:
        part = read(min(left, 1 << 20))
        if not part:
            raise EOFError
        parts.append(part)
        left -= len(part)
    return b"".join(parts)
