"""Pages that show runs and play their matches, with the engine inside.

==============  ====================================================================================
runs_page.py    ``explore``: write the page of finished runs
run_data.py     a run as plain values: settings, training, results
findings.py     what the analysis says of a race, as plain values
archives.py     the teams of a run: networks, and genomes within a limit of size
playground.py   ``Playground``: the page on which conflicts are played by hand
gallery.py      the examples of the playground
links.py        scenes of the playground as text in a link
frame.py        a page in a notebook: a frame, and a picture where no frame is shown
page.py         a self-contained page: template, script, style sheet and data
built.py        the built scripts and style sheets
==============  ====================================================================================
"""

from __future__ import annotations

from matrixworld.explorer.playground import Playground
from matrixworld.explorer.runs_page import Explorer, explore, explorer_page

__all__ = ["Explorer", "Playground", "explore", "explorer_page"]
