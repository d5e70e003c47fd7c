"""The page of finished runs: payoff matrices whose matches it plays, and all that belongs to them.

>>> from matrixworld.explorer import explore
>>> explore("runs/O-seed0/generalist-generalist")  # doctest: +SKIP
"""

from __future__ import annotations

import io
import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from matrixworld.analysis import Judgement
from matrixworld.coevolution.storage.saved_run import SavedRun, open_run
from matrixworld.episodes import replay
from matrixworld.explorer.page import mime_bundle, render_page, without_engine, write_page
from matrixworld.explorer.playground import Playground, page_data
from matrixworld.explorer.run_data import archives_of, run_data
from matrixworld.version import __version__

PAGE = "explorer.html"
"""Name of the page in a run directory, or beside several."""
MOST_RUNS = 12
"""The most runs of a page."""

Path_ = str | os.PathLike[str]


@dataclass(frozen=True, repr=False)
class Explorer:
    """A page that was written; notebooks show it in a frame.

    Parameters
    ----------
    path : Path
        The file.
    picture : bytes, optional
        A match as a PNG file: what a notebook shows where it shows no frame. The
        default is none.
    """

    path: Path
    picture: bytes = b""

    def __repr__(self) -> str:
        return f"<Explorer: {self.path}>"

    def _repr_mimebundle_(self, include: object = None, exclude: object = None) -> dict[str, str]:
        """Return the frame, and the picture for places that show no frame."""
        return mime_bundle(self.path.read_text(encoding="utf-8"), self.path.name, self.picture)


def explore(*runs: Path_, file: Path_ | None = None, force: bool = False) -> Explorer:
    """Write the page of finished runs.

    Parameters
    ----------
    *runs : str or path
        Run directories, at least one and at most 12.
    file : str or path, optional
        The page. The default is ``explorer.html`` in the run directory, or in the directory that
        holds all of the runs.
    force : bool, optional
        Whether to replace a file that exists. The default is False.

    Returns
    -------
    Explorer
        The page; the last expression of a notebook's cell shows it.

    Raises
    ------
    ValueError
        If the number of runs is another one.
    FileNotFoundError
        If a directory holds no run, or its run is not finished.
    FileExistsError
        If the file exists.
    DamagedFileError
        If a file of a run is cut or altered.
    """
    if not 1 <= len(runs) <= MOST_RUNS:
        raise ValueError(f"runs: expected 1 to {MOST_RUNS} run directories, got {len(runs)}")
    paths = [Path(run) for run in runs]
    # By default beside what it shows.
    common = Path(os.path.commonpath([path.absolute() for path in paths]))
    page = common / PAGE if file is None else Path(file)
    if page.exists() and not force:
        raise FileExistsError(f"{page}: exists; force=True replaces it")
    saved = [open_run(path) for path in paths]
    write_page(page, explorer_page(saved))
    # Three moments of the match of the last generations.
    picture = io.BytesIO()
    replay.contact_sheet(saved[0].record(), rows=1).save(picture, "PNG")
    return Explorer(page, picture.getvalue())


def explorer_page(
    runs: Sequence[SavedRun],
    *,
    held_out: Mapping[Path, Mapping[str, Any]] | None = None,
    judgements: Mapping[Path, Judgement] | None = None,
    note: str = "",
) -> str:
    """Return the page of finished runs as HTML, in this order.

    By run directory, `held_out` has scores against held-out opponents (see `run_data`), and
    `judgements` those that are known; other races are judged here. A `note` says what the page does
    not show, such as further runs of the job. FileNotFoundError if a run is not finished.
    """
    paths = [run.files.path.absolute() for run in runs]
    common = Path(os.path.commonpath(paths))
    # Each by its path below the directory that holds all of them.
    names = [path.name if path == common else path.relative_to(common).as_posix() for path in paths]
    archives = archives_of(runs)
    scores, known = held_out or {}, judgements or {}
    plain = [
        {
            **run_data(name, run, scores.get(run.files.path), known.get(run.files.path)),
            "teams": teams,
        }
        for name, run, teams in zip(names, runs, archives.teams, strict=True)
    ]
    title = names[0] if len(names) == 1 else common.name
    data = {
        "version": __version__,
        "title": title,
        "note": note,
        "step": archives.step,
        "playground": page_data(),
        "runs": plain,
    }
    playground = without_engine(Playground().html()).encode()
    blobs = {**archives.blobs, "playground": playground}
    return render_page("explorer", f"{title} - matrixworld", data, blobs, opens=["playground"])
