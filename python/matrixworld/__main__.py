"""``python -m matrixworld``: the command line."""

from __future__ import annotations

from matrixworld.cli import main

main(prog_name="matrixworld")
