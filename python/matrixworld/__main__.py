"""The command line as ``python -m matrixworld``."""

from __future__ import annotations

import sys

from matrixworld._util.exit_codes import INTERRUPTED


def main() -> None:
    """Run the command line; Ctrl-C ends it without a traceback while it is still imported, too."""
    try:
        from matrixworld.cli import main as command

        command(prog_name="matrixworld")
    except KeyboardInterrupt:
        sys.exit(INTERRUPTED)


if __name__ == "__main__":
    main()
