"""Play a class tournament: ``python tutorials/class_tournament SUBMISSIONS``."""

import sys
from pathlib import Path

# The folder as a package, behind all that is installed.
sys.path[0:1] = []
sys.path.append(str(Path(__file__).resolve().parents[1]))

from class_tournament.command import main

if __name__ == "__main__":
    main(prog_name="python tutorials/class_tournament")
