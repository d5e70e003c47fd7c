"""The command line as ``python -m matrixworld``."""

from __future__ import annotations

from matrixworld.cli import main

main(prog_name="matrixworld")
