"""Cases of which a plain call of pytest tries some, and an option all."""

import pytest


def quickly(parameter, cases, is_quick, name=str, *, others=pytest.mark.nightly):
    """Parametrize a test by cases; those that are not quick are marked as `others`."""
    marked = [pytest.param(x, id=name(x), marks=() if is_quick(x) else others) for x in cases]
    return pytest.mark.parametrize(parameter, marked)
