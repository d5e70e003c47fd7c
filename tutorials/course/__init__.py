"""What the notebooks of the course in ``tutorials/`` need besides the package itself.

>>> from course import check
>>> check("1.1", ...)
No answer yet. Replace the dots with your answer, run the cell, and check again.
"""

from __future__ import annotations

import sys

from course.questions import BANNER, UnansweredError, check, hint, kept, outcome, predict, size
from course.shown import Slider

__all__ = ["Slider", "UnansweredError", "check", "hint", "kept", "outcome", "predict", "size"]

sys.stdout.write(size(full="", quick=BANNER))  # the first cell of every notebook imports this
