"""The stop mark: a small file in the directory of a job, by which tasks know that they shall end.

The file holds the token of the start that plays the job. A task carries the token of its own start,
and ends when the file holds another one, or is gone. Stopping is to remove it. It therefore works
wherever tasks see the directory, an earlier stop never stops a later start, and tasks that a killed
program has left on other machines end when the job is started again.
"""

from __future__ import annotations

import secrets
from pathlib import Path

from matrixworld._util.files import replacing

MARK = ".start"
"""Name of the file."""


class StoppedError(RuntimeError):
    """A task has ended because its job was stopped, or started again."""


class StopMark:
    """The mark of one start of a job.

    Parameters
    ----------
    directory : Path
        Directory of the job.
    token : str
        Token of the start.
    """

    def __init__(self, directory: Path, token: str) -> None:
        self.path: Path = directory / MARK
        self.token: str = token

    @classmethod
    def start(cls, directory: Path) -> StopMark:
        """Return the mark of a new start; tasks of earlier starts end from now on."""
        mark = cls(directory, secrets.token_hex(8))
        with replacing(mark.path) as file:
            file.write(mark.token.encode())
        return mark

    def stop(self) -> None:
        """Let the tasks of this start end."""
        # Another program may play the job by now: its mark stays.
        if self.stands():
            self.path.unlink(missing_ok=True)

    def stands(self) -> bool:
        """Return whether tasks of this start shall go on."""
        # Opened at each look, because network file systems ask the server when a file is opened.
        try:
            return self.path.read_bytes() == self.token.encode()
        except FileNotFoundError:
            return False

    def check(self) -> None:
        """Raise StoppedError unless tasks of this start shall go on."""
        if not self.stands():
            raise StoppedError(f"{self.path.parent}: the job was stopped, or started again")
