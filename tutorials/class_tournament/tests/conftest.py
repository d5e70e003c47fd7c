"""Options, settings and fixtures as in ``tests/``."""

pytest_plugins = ["shared"]
