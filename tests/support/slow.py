"""Cases of which a plain call of pytest tries some, and an option all; parts of nightly tests."""

from hashlib import sha256

import pytest

PARTS = 10
"""Of the nightly tests; `.ci/run` plays one."""


def part_of(name):
    """Return the part that a test belongs to, by its name (pytest's node id), on every machine."""
    return int(sha256(name.encode()).hexdigest(), 16) % PARTS


def quickly(parameter, cases, is_quick, name=str, *, others=pytest.mark.nightly):
    """Parametrize a test by cases; those that are not quick are marked as `others`."""
    marked = [pytest.param(x, id=name(x), marks=() if is_quick(x) else others) for x in cases]
    return pytest.mark.parametrize(parameter, marked)
