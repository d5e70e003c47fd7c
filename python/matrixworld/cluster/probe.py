"""Whether another process can share the work of this one with equal results.

A `Probe` is made where work is handed out and checked in each process that is to do it, on the same
or on another machine. It compares the package, the engine and, where it matters, the linear
algebra; and it tries whether the other process sees a directory, and the locks in it.
"""

from __future__ import annotations

import hashlib
import importlib
import secrets
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from threadpoolctl import threadpool_info

import matrixworld
from matrixworld._util.checks import processor_name
from matrixworld._util.files import TEMPORARY, LockedError, locked
from matrixworld.play.rollout import Matches, rollout
from matrixworld.version import __version__
from matrixworld.world.config import WorldConfig
from matrixworld.world.policy import Network, Population

CENTS = 100
"""Rewards are counted in hundredths: whole numbers, which every machine writes the same."""

DIFFERENT = {
    "version": "another version of matrixworld",
    "code": "other Python code of matrixworld",
    "engine": "another engine fingerprint",
    "numpy": "another version of NumPy",
    "algebra": "another processor or linear algebra, which CMA-ES and PyTorch round differently",
}
"""What is wrong if a trait differs."""


def traits_here() -> dict[str, str]:
    """Return what results of this process depend on, besides settings and seeds."""
    return {
        "version": __version__,
        "code": code_fingerprint(),
        "engine": engine_fingerprint(),
        "numpy": np.__version__,
        "algebra": linear_algebra(),
    }


def code_fingerprint() -> str:
    """Return a digest of the package's Python files: versions between releases have one number."""
    root = Path(matrixworld.__file__).parent
    digest = hashlib.sha256()
    for file in sorted(root.rglob("*.py")):
        digest.update(file.relative_to(root).as_posix().encode() + file.read_bytes())
    return digest.hexdigest()[:8]


def engine_fingerprint() -> str:
    """Return a digest of a few short episodes in the engine, which take some milliseconds."""
    digest = hashlib.sha256()
    for variant in ("O", "SB", "TO"):
        config = WorldConfig(variant, rows=12, cols=12, obstacles=0.1, max_steps=30)
        network = Network.for_config(config, (9,))
        # No generator, whose numbers are another version's to choose.
        genome = np.sin(np.arange(network.genome_size)).astype(np.float16).astype(np.float32)
        team = Population(genome[None], network)
        matches = Matches.of(0, 0, np.arange(6))
        for played in (
            rollout(config, team, "fleer", matches, threads=1),
            rollout(config, "hunter", team, matches, threads=1),
        ):
            for name in ("length", "capture_rate", "pursuer_return", "collisions", "agent_steps"):
                values = CENTS * np.asarray(getattr(played, name), np.float64)
                digest.update(np.rint(values).astype("<i8").tobytes())
    return digest.hexdigest()[:8]


def linear_algebra() -> str:
    """Return the libraries of linear algebra, and the processors that they compute for."""
    # SciPy may bring a library of its own, which a process has loaded only once it has used it.
    importlib.import_module("scipy.linalg")
    blas = [library for library in threadpool_info() if library["user_api"] == "blas"]
    return ", ".join(
        # A library that does not say which processor it has chosen may have chosen any.
        f"{one['internal_api']} {one['version']} {one.get('architecture') or processor_name()}"
        for one in sorted(blas, key=lambda one: str(one["filepath"]))
    )


@dataclass(frozen=True)
class Probe:
    """What another process must have to share work."""

    traits: dict[str, str]
    same_processors: bool = False
    """Whether the linear algebra must be the same, too."""
    sign: Path | None = None
    """A locked file in the directory that both must see; None if the work needs no files."""
    token: str = ""
    """Content of that file."""

    def problem(self) -> str:
        """Return why this process cannot share the work, or an empty string."""
        here = traits_here()
        for name, different in DIFFERENT.items():
            expected, found = self.traits[name], here[name]
            if found != expected and (self.same_processors or name != "algebra"):
                return f"it has {different} (expected {expected}, got {found})"
        return "" if self.sign is None else self._problem_of_files(self.sign)

    def _problem_of_files(self, sign: Path) -> str:
        try:
            seen = sign.read_text(encoding="ascii") == self.token
        except (OSError, UnicodeDecodeError):
            seen = False
        if not seen:
            return f"it does not see the files in {sign.parent}; the directory must be shared"
        try:
            with locked(sign):
                return f"locks in {sign.parent} do not hold between its machine and this one"
        except LockedError:
            return ""
        except OSError as error:
            return f"it cannot lock files in {sign.parent} ({error.strerror})"


@contextmanager
def posted(directory: Path | None, *, same_processors: bool = False) -> Iterator[Probe]:
    """Yield a probe for work on files in a directory; None if the work needs no files.

    The directory is made if it does not exist, and removed again if it stays empty. The probe can
    be checked as long as the block lasts: it needs a file that is removed at the end.
    """
    traits = traits_here()
    if directory is None:
        yield Probe(traits, same_processors)
        return
    # Absolute: another process may have another working directory.
    place = directory.resolve()
    made = [each for each in (place, *place.parents) if not each.exists()]
    place.mkdir(parents=True, exist_ok=True)
    token = secrets.token_hex(16)
    # The name of a file that is being written: the directory still counts as empty.
    sign = place / f".{token}{TEMPORARY}"
    try:
        sign.write_text(token, encoding="ascii")
        with locked(sign):
            yield Probe(traits, same_processors, sign, token)
    finally:
        sign.unlink(missing_ok=True)
        # The directories that this made, unless they are used by now.
        with suppress(OSError):
            for each in made:
                each.rmdir()
