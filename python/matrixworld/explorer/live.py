"""The explorer of runs that are still going on, served to the browsers of this machine.

Readers beside a run see whole stages and take no lock, so a run has the same bytes with this page
and without. The payoff matrix is made at the end of a run only: a thread here plays the first
episodes of the evaluation of all generations that there are, and plays on when a stage is sealed,
as long as a browser asks: a page at which nobody looks costs nothing.
"""

from __future__ import annotations

import html
import json
import secrets
import socket
import threading
import time
from collections import deque
from collections.abc import Callable, Sequence
from contextlib import suppress
from functools import partial
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from typing import Any

import numpy as np
from tqdm import tqdm

from matrixworld._util.files import DamagedFileError
from matrixworld.coevolution.evaluation.tournament import team_size, tournament
from matrixworld.coevolution.progress import LINE, Progress
from matrixworld.coevolution.storage import SavedRun, open_run
from matrixworld.coevolution.types import TEAMS, Payoff
from matrixworld.explorer.runs_page import Live, explorer_page
from matrixworld.world.policy import Population, TeamPolicy

HOST = "127.0.0.1"
EPISODES = 2
"""Episodes of each cell while runs go on, the first ones of the evaluation."""
SECONDS = 1.0
"""Time between two looks at the files; the page asks as often."""
LEFT = 5.0
"""Seconds for which a browser that has just asked counts as one that looks."""
MOST_CONNECTIONS = 16
PROGRESS = f"{LINE}, {{rate_fmt}}"
NOTE = (
    f"The runs go on. Each cell has {EPISODES} episodes so far; new generations appear when the "
    "match that is shown has ended. The judgement comes at the end."
)
WAITING = (
    '<!doctype html><meta charset="utf-8"><meta http-equiv="refresh" content="1">'
    "<title>matrixworld</title><p>The first run begins.</p><p>{}</p>"
)


class LivePage:
    """A server of one page, at an address with a random token, and the thread that plays for it.

    The runs are named by their directories inside `root`, which need not exist yet.
    """

    def __init__(self, root: Path, names: Sequence[str]) -> None:
        self._root, self._names = root, names
        self._runs: dict[str, tuple[SavedRun, Payoff]] = {}
        self._stages: dict[str, int] = {}
        self._version = 0
        self._finished: Path | None = None
        self._asked = -LEFT
        self._began = time.monotonic()
        self._progress: dict[str, float | str] = {"share": 0.0, "text": ""}
        self._taken, self._closed = threading.Event(), threading.Event()
        self._place = f"/{secrets.token_urlsafe(16)}/"
        self._server = _Server((HOST, 0), partial(_Handler, self))
        self.url: str = f"http://{HOST}:{self._server.server_port}{self._place}"
        self._threads = [
            threading.Thread(target=work, daemon=True)
            for work in (self._server.serve_forever, self._follow)
        ]

    def __enter__(self) -> LivePage:
        for thread in self._threads:
            thread.start()
        return self

    def __exit__(self, *error: object) -> None:
        self._closed.set()
        self._server.shutdown()
        self._server.server_close()
        for thread in self._threads:
            thread.join()

    def finish(self, page: Path) -> None:
        """Serve the page of the finished runs, if a browser is there to take it."""
        self._finished = page
        if self._is_looked_at():
            self._taken.wait(LEFT)

    def report(self, progress: Progress) -> None:
        """Tell phases, share, time left and rate to the page."""
        what = [progress.what, *(f"{name}: {each.what}" for name, each in progress.runs.items())]
        text = tqdm.format_meter(
            progress.done, progress.total, time.monotonic() - self._began, prefix=", ".join(what),
            unit=" matches", unit_scale=True, bar_format=PROGRESS, initial=progress.before,
        )  # fmt: skip
        self._progress = {"share": progress.share, "text": text}

    # What a browser gets:

    def answer(self, path: str) -> str | None:
        """Return what is at an address; None if nothing is."""
        if path.startswith(self._place):
            self._asked = time.monotonic()
        if path == f"{self._place}progress":
            version = "end" if self._finished else str(self._version)
            return json.dumps({"version": version, **self._progress})
        return self._page() if path == self._place else None

    def sent(self, path: str) -> None:
        """Note that a browser has got what is at an address."""
        if self._finished and path == self._place:
            self._taken.set()

    def _is_looked_at(self) -> bool:
        return time.monotonic() - self._asked < LEFT

    def _page(self) -> str:
        if self._finished:
            return self._finished.read_text(encoding="utf-8")
        version, known = str(self._version), {**self._runs}
        found = [known[name] for name in self._names if name in known]
        if not found:
            return WAITING.format(html.escape(str(self._progress["text"])))
        runs, payoffs = zip(*found, strict=True)
        return explorer_page(runs, note=NOTE, live=Live(payoffs, version))

    # What is played for it:

    def _follow(self) -> None:
        while not self._closed.wait(SECONDS):
            for name in self._names if self._is_looked_at() else ():
                # The run is being made or mended, or too many files are open: the next look may
                # succeed, and the end of the job tells what is damaged.
                with suppress(OSError, DamagedFileError):
                    self._look(name)

    def _look(self, name: str) -> None:
        """Play what a run has added since the last look."""
        stages = len([*(self._root / name).glob("stage-*.npz")])
        if stages == self._stages.get(name, 0) or self._finished:
            return
        run = open_run(self._root / name)
        known = self._runs[name][1] if name in self._runs else None
        self._runs[name] = run, extended(run, known, self._check)
        self._stages[name] = stages
        self._version += 1

    def _check(self, played: int) -> None:
        if self._closed.is_set() or self._finished:
            raise SystemExit  # of this thread


def extended(run: SavedRun, known: Payoff | None, on_row: Callable[[int], None]) -> Payoff:
    """Return the payoff of all generations of a run; what is known of them is not played again."""
    pursuers, evaders = (run.teams[team] for team in TEAMS)
    episodes = min(EPISODES, run.settings.evaluation_episodes)
    seed = run.settings.seed
    play = partial(
        tournament, run.settings.world, seed=seed, episodes=episodes, threads=1, on_row=on_row
    )
    if known is None:
        return play(pursuers, evaders)
    g, h = known.capture_rate.shape
    if h < team_size(evaders):
        known = _joined(known, play(_part(pursuers, 0, g), _part(evaders, h), first=(0, h)), 1)
    if g < team_size(pursuers):
        known = _joined(known, play(_part(pursuers, g), evaders, first=(g, 0)), 0)
    return known


def _joined(known: Payoff, new: Payoff, axis: int) -> Payoff:
    old, more = known.arrays(), new.arrays()
    return Payoff.from_arrays(
        {name: np.concatenate([old[name], more[name]], axis=axis) for name in old}
    )


def _part(team: TeamPolicy, first: int, last: int | None = None) -> TeamPolicy:
    return team if isinstance(team, str) else Population(team.genomes[first:last], team.network)


class _Server(ThreadingHTTPServer):
    """A server with a few connections: a new one ends the oldest, as the run needs its files, too.

    Any user of this machine can connect, with the token or without.
    """

    request_queue_size = MOST_CONNECTIONS

    def __init__(self, *given: Any) -> None:
        self._open: deque[socket.socket] = deque()
        super().__init__(*given)

    def process_request(self, request: Any, client_address: Any) -> None:
        """Answer in a thread of its own."""
        self._open.append(request)
        while len(self._open) > MOST_CONNECTIONS:
            with suppress(OSError):  # it is closed already
                self._open.popleft().shutdown(socket.SHUT_RDWR)
        super().process_request(request, client_address)

    def shutdown_request(self, request: Any) -> None:
        """Close a connection."""
        with suppress(ValueError, IndexError):  # another thread has removed one
            self._open.remove(request)
        super().shutdown_request(request)

    def handle_error(self, request: Any, client_address: Any) -> None:
        """Print nothing: a page that fails is no error of the run."""


class _Handler(BaseHTTPRequestHandler):
    """Answers the addresses of the page, to browsers that name this machine; nothing else."""

    timeout = LEFT

    def __init__(self, page: LivePage, *connection: Any) -> None:
        self._page = page
        super().__init__(*connection)

    def do_GET(self) -> None:
        host = "{}:{}".format(*self.connection.getsockname())
        # Another name would be that of a web site which points to this machine.
        text = self._page.answer(self.path) if self.headers["Host"] == host else None
        if text is None:
            self.send_error(404)
            return
        content = text.encode()
        with suppress(ConnectionError):  # the tab may be closed meanwhile
            self.send_response(200)
            self.send_header("Content-Type", "text/html; charset=utf-8")
            self.send_header("Content-Length", str(len(content)))
            self.send_header("Cache-Control", "no-store")
            self.end_headers()
            self.wfile.write(content)
            self._page.sent(self.path)

    def log_message(self, *args: object) -> None:
        """Print nothing: the progress has the terminal."""
