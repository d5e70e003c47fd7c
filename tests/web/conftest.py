"""One process of the built engine serves all tests here."""

from collections.abc import Iterator

import pytest

from node import Commands


@pytest.fixture(scope="session")
def run_command() -> Iterator[Commands]:
    """Carry out a command in the built engine."""
    commands = Commands()
    yield commands
    commands.close()
