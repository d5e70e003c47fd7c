"""Exit codes of the program."""

INTERRUPTED = 130
"""Ctrl-C has ended it: 128 + SIGINT, as shells report it."""
