"""Runs: races of two teams, and one team against fixed opponents."""
