"""What the notebooks of the course in ``tutorials/`` need besides the package itself.

>>> from matrixworld.tutorial import check, hint
>>> check("1.1", ...)
No answer yet. Replace the dots with your answer, run the cell, and check again.

=============  ==================================================================
exercises.py   exercises: `check` an answer, ask for a `hint`
boards.py      small worlds: a step as a picture, and pursuers alone on a square
chapter_*.py   the exercises of each notebook
packs.py       teams of six weights, for the notebook on safety
kept.py        results that were computed before, and the setting of the notebooks
=============  ==================================================================
"""

from __future__ import annotations

from matrixworld.tutorial.exercises import (
    Exercise,
    Feedback,
    Hint,
    Prediction,
    check,
    exercises,
    hint,
)
from matrixworld.tutorial.kept import kept, size

__all__ = [
    "Exercise",
    "Feedback",
    "Hint",
    "Prediction",
    "check",
    "exercises",
    "hint",
    "kept",
    "size",
]
