"""Firefox without a window, for the pages: driven by WebDriver BiDi, which needs no other program.

Debian has Firefox and no geckodriver, which Selenium would want.
"""

import json
import re
import shutil
import subprocess
import tempfile
import time
from itertools import count
from pathlib import Path
from threading import Thread

import pytest

NAMES = ("firefox-esr", "firefox")
LISTENS = re.compile(r"WebDriver BiDi listening on (ws://\S+)")


class Firefox:
    """A browser with one tab and a profile of its own."""

    def __init__(self, program, profile):
        import websocket

        command = [program, "--headless", "--profile", str(profile), "--remote-debugging-port", "0"]
        self._process = subprocess.Popen(command, stderr=subprocess.PIPE, text=True)
        assert self._process.stderr
        found = next(filter(None, map(LISTENS.search, self._process.stderr)))
        # Nobody reads what it writes later, which must not fill the pipe.
        Thread(target=self._process.stderr.read, daemon=True).start()
        self._socket = websocket.create_connection(f"{found[1]}/session", suppress_origin=True)
        self._numbers = count()
        self._ask("session.new", capabilities={})
        self._tab = self._ask("browsingContext.getTree")["contexts"][0]["context"]

    def _ask(self, method, **params):
        number = next(self._numbers)
        self._socket.send(json.dumps({"id": number, "method": method, "params": params}))
        while True:
            told = json.loads(self._socket.recv())
            if told.get("id") == number:
                assert told["type"] == "success", told
                return told["result"]

    def open(self, address):
        """Load a page, as if it had not been loaded before."""
        self._ask("browsingContext.navigate", context=self._tab, url="about:blank", wait="complete")
        self._ask("browsingContext.navigate", context=self._tab, url=address, wait="complete")

    def js(self, expression):
        told = self._ask(
            "script.evaluate",
            expression=f"JSON.stringify({expression})",
            target={"context": self._tab},
            awaitPromise=True,
        )
        assert told["type"] == "success", told
        return json.loads(told["result"].get("value", "null"))

    def wait(self, expression, seconds=60.0):
        until = time.monotonic() + seconds
        while not self.js(f"Boolean({expression})"):
            assert time.monotonic() < until, f"{expression} in {seconds} s"
            time.sleep(0.05)

    def close(self):
        self._socket.close()
        self._process.terminate()
        self._process.communicate()


@pytest.fixture(scope="module")
def firefox():
    """Firefox for the tests of one file, which are skipped where there is none."""
    pytest.importorskip("websocket")  # which Selenium brings
    program = next(filter(None, map(shutil.which, NAMES)), None)
    if program is None:
        pytest.skip("expected the program firefox-esr or firefox, found none")
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as profile:
        started = Firefox(program, Path(profile))
        try:
            yield started
        finally:
            started.close()
