"""Scripts of this folder import this first, and then what the experiments share (`common`)."""

import sys
from pathlib import Path

sys.path.append(str(Path(__file__).parents[1]))
