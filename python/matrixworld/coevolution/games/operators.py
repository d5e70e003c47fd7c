"""Genomes of any kind: text for the package, and an object for the functions of a game.

The operators of a team make genomes, and turn them into text and back. An operator always gets an
object that was read from its text just now: so it may change it in place, and a race that was
stopped, whose objects are gone, goes on as one that was not.
"""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import dataclass, fields
from typing import Any

import numpy as np

from matrixworld._util.callers import warn_caller
from matrixworld._util.checks import shown
from matrixworld.coevolution.types import Genome, Genomes, Rng

LONG = 10**6  # characters of a genome, above which a warning tells of it

to_json = json.JSONEncoder(allow_nan=False).encode
"""The default of `write`: other programs cannot read NaN."""
_parse = json.JSONDecoder().raw_decode  # in half of the time, without a look for white space


def from_json(text: str) -> Any:
    """Return what a text of JSON stands for; the default of `read`."""
    try:
        value, end = _parse(text)
    except ValueError:
        return json.loads(text)
    return value if end == len(text) else json.loads(text)


@dataclass(frozen=True)
class Operators:
    """What makes the genomes of a team, and turns them into text and back.

    Parameters
    ----------
    initial : callable
        ``initial(rng)`` returns a new genome, an object.
    mutate : callable
        ``mutate(genome, rng)`` returns a mutant; it may change the genome in place.
    mate : callable, optional
        ``mate(one, other, rng)`` returns a child of both. By default a child has one parent.
    write, read : callable, optional
        Genome to text, and text to genome. The defaults are those of JSON.
    """

    initial: Callable[[Rng], Any]
    mutate: Callable[[Any, Rng], Any]
    mate: Callable[[Any, Any, Rng], Any] | None = None
    write: Callable[[Any], str] | None = None
    read: Callable[[str], Any] | None = None

    def genome(self, text: str) -> Any:
        """Return the object that a text stands for, a new one; ValueError if it cannot be read."""
        try:
            return (self.read or from_json)(text)
        except (TypeError, ValueError) as error:
            raise ValueError(f"read: expected to read {shown(text)}: {error}") from error

    def written(self, genome: Any) -> str:
        """Return the text of a genome."""
        return (self.write or to_json)(genome)

    def text(self, genome: Any, source: str) -> str:
        """Return the text of a genome that `source` has made.

        Raises
        ------
        TypeError
            If there is no genome, but None or a tuple of one, or `write` makes no text of it.
        ValueError
            If no file can hold the text.
        """
        _check_one(genome, source)
        try:
            text = self.written(genome)
        except (TypeError, ValueError) as error:
            made = f"of what {source} made, {shown(genome)}"
            raise TypeError(f"write: expected to make text {made}: {error}") from error
        if type(text) is not str:
            made = f"of what {source} made, {shown(genome)}"
            raise TypeError(f"write: expected text, a str, {made}, got {shown(text)}")
        if "\0" in text or not _is_unicode(text):
            raise ValueError(f"write: expected text that a file holds in UTF-8, got {shown(text)}")
        if len(text) > LONG:
            warn_caller(f"{source}: has made a genome of {len(text):,} characters")
        return text

    def check_read(self, text: str, source: str) -> None:
        """Raise ValueError if what is read of a text that `source` made has another text."""
        again = self.written(self.genome(text))
        if again != text:
            raise ValueError(
                f"write: expected the same text of what read(text) returns, got {shown(again)} of "
                f"{shown(text)}, which {source} made"
            )

    def untrained(self, rng: Rng) -> str:
        """Return the text of a new genome."""
        text = self.text(self.initial(rng), "initial")
        self.check_read(text, "initial")
        return text

    def child(self, parents: Genomes, rng: Rng, *, mutates: bool) -> str:
        """Return the text of a child of one parent, a mutant, or of two (1 or 2, 1).

        Without `mate`, or with one parent, it is always a mutant.
        """
        child, *others = map(self.genome, parents[:, 0].tolist())
        if not others or self.mate is None:
            return self.text(self.mutate(child, rng), "mutate")
        child = self.mate(child, others[0], rng)
        if not mutates:
            return self.text(child, "mate")
        _check_one(child, "mate")
        return self.text(self.mutate(child, rng), "mutate")


def _check_one(genome: Any, source: str) -> None:
    """Raise TypeError if an operator returns no genome: None, or a tuple of one as in DEAP."""
    if genome is None or (isinstance(genome, tuple) and len(genome) == 1):
        raise TypeError(
            f"{source}: expected a genome, got {shown(genome)}; return the genome itself, also if "
            f"it was changed in place"
        )


PAIRED = tuple(each.name for each in fields(Operators))
"""Functions of a game of which each team may have its own."""


def _is_unicode(text: str) -> bool:
    """Return whether a text has no half of a pair of surrogates."""
    try:
        text.encode()
    except UnicodeEncodeError:
        return False
    return True


def as_genome(text: str) -> Genome:
    """Return a text as a genome (1,)."""
    return np.array([text])


def as_genomes(texts: list[str]) -> Genomes:
    """Return texts as genomes (n, 1)."""
    return np.array(texts, np.str_).reshape(-1, 1)


def are_texts(genomes: Any, shape: tuple[int, ...]) -> bool:
    """Return whether these are genomes of some shape that are text."""
    is_array = isinstance(genomes, np.ndarray) and not isinstance(genomes, np.ma.MaskedArray)
    return is_array and genomes.dtype.kind == "U" and genomes.shape == shape
