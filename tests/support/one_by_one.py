"""Rollouts whose worlds play one after the other: the reference of matches in lockstep."""

from dataclasses import fields
from functools import partial
from typing import Any
from unittest import mock

import numpy as np

import matrixworld as mw
from matrixworld import _core


def assert_same_one_by_one(*args: Any, **kwargs: Any) -> None:
    """Play a rollout in both ways, and compare every bit."""
    fast = mw.rollout(*args, **kwargs)
    with mock.patch.object(_core, "rollout", partial(_core.rollout, one_by_one=True)):
        plain = mw.rollout(*args, **kwargs)
    for item in fields(fast):
        found, expected = getattr(fast, item.name), getattr(plain, item.name)
        assert found.dtype == expected.dtype
        assert found.tobytes() == expected.tobytes(), (item.name, np.nonzero(found != expected))
