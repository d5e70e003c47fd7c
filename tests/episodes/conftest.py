"""A terminal that keeps what is written to it, and a clock that stands still."""

import sys

import pytest


@pytest.fixture
def naps(monkeypatch: pytest.MonkeyPatch) -> list[float]:
    """Collect the pauses instead of taking them."""
    taken: list[float] = []
    monkeypatch.setattr("time.sleep", taken.append)
    monkeypatch.setattr("time.monotonic", lambda: 5.0)
    return taken


@pytest.fixture
def terminal(
    naps: list[float], monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> pytest.CaptureFixture[str]:
    """What is printed goes to a terminal of 100 columns, 50 lines and 256 colours."""
    variables = {"COLUMNS": "100", "LINES": "50", "COLORTERM": "", "TERM": "xterm"}
    for name, value in variables.items():
        monkeypatch.setenv(name, value)
    monkeypatch.delenv("NO_COLOR", raising=False)
    monkeypatch.setattr(type(sys.stdout), "isatty", lambda stream: True)
    return capsys
