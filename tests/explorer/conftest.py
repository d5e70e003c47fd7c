"""The browser is a fixture of all tests here."""

from browser import browser

__all__ = ["browser"]
