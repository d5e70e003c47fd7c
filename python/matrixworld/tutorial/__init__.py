"""What the notebooks of the course in ``tutorials/`` need besides the package itself.

>>> from matrixworld.tutorial import check, hint
>>> check("1.1", ...)
No answer yet. Replace the dots with your answer, run the cell, and check again.
"""

from __future__ import annotations

from matrixworld.tutorial.course import check, hint, kept, size

__all__ = ["check", "hint", "kept", "size"]
