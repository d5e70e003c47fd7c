"""Options, settings and fixtures as in ``tests/``."""

import pytest


def pytest_addoption(pluginmanager: pytest.PytestPluginManager) -> None:
    # Not `pytest_plugins`, which is an error where pytest finds this file late.
    pluginmanager.import_plugin("shared")
