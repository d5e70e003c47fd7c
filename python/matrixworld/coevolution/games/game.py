"""Games of two populations: all that co-evolution knows of what it races.

The teams of a game are called pursuers and evaders wherever its names do not matter: in settings
and keys of random numbers. `games.pursuit` is the game of the package, `games.own_game` stands for
one of the user's.
"""

from __future__ import annotations

import io
from abc import abstractmethod
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from itertools import product
from typing import Any, ClassVar

import numpy as np
from numpy.typing import ArrayLike, NDArray
from PIL import Image

from matrixworld._util import checks
from matrixworld._util.plugins import no_exit
from matrixworld._util.sections import Section, section
from matrixworld.coevolution.types import TEAMS, FloatArray, Genome, Genomes, Matches, Rng, Team

Play = Callable[[Genomes, Genomes, Rng], ArrayLike]
"""Genomes (M, genes) of both teams, and a generator -> scores (M,) of the first team."""


@dataclass(frozen=True, eq=False)
class Scores:
    """Scores (M, N) of the first team, in [0, 1], in M matches of N episodes; the other has 1 - s.

    What else the game tells are `extras`, by name, each (M, N, ...).
    """

    scores: NDArray[Any]
    extras: Mapping[str, NDArray[Any]] = field(default_factory=dict)

    def of(self, team: Team) -> FloatArray:
        """Return the scores (M, N) of a team."""
        first = np.asarray(self.scores, dtype=np.float64)
        return first if team == "pursuer" else 1.0 - first


class _MatchDraws:
    """Generators of matches: one that is set anew, in a tenth of the time that a new one takes.

    Both words of a key have 64 bits.
    """

    def __init__(self) -> None:
        self._bits = np.random.Philox(key=np.zeros(2, np.uint64))
        self._rng = np.random.Generator(self._bits)
        self._begin: Any = self._bits.state

    def of(self, seed: int, episode: int) -> Rng:
        """Return the generator of a match and episode, which the next call sets anew."""
        key = np.array([seed, episode], np.uint64)
        state: Any = {**self._begin, "state": {**self._begin["state"], "key": key}}
        self._bits.state = state
        return self._rng


@dataclass(frozen=True, eq=False)
class Strategies:
    """Genomes (n, genes) of a team, which can play."""

    genomes: Genomes


def clipped(genomes: Genomes, bounds: tuple[ArrayLike, ArrayLike] | None) -> Genomes:
    """Return genomes inside some bounds of their genes, if there are any."""
    return genomes if bounds is None else np.clip(genomes, *bounds)


@dataclass(frozen=True, eq=False)
class Game:
    """A game of two populations of genomes, vectors of float32.

    Parameters
    ----------
    play : callable
        ``play(a, b, rng)`` returns the scores (M,) of the genomes a (M, genes) against the genomes
        b (M, genes), in [0, 1]; b has 1 - score. Random numbers come from `rng` alone.
    genes : int or tuple of two ints
        Length of the genomes, of both teams or of each.
    teams : tuple of two str
        Names of the teams, in the plural.
    initial : callable, optional
        ``initial(rng)`` returns an untrained genome, with teams of different lengths
        ``initial(rng, team)``. By default the genes are drawn from N(0, 1).
    bounds : tuple of two float or arrays of float, optional
        Least and largest value of the genes. Learners clip genomes, and the game never sees one
        outside. By default there are no bounds.
    deterministic : bool, optional
        Whether equal genomes always have equal scores. Such a game is called with all matches at
        once, each pair is evaluated once, and the judgement takes the scores as exact. Any other
        game is called with one match at a time, M = 1, and a generator of this match and episode:
        so a result does not depend on which other matches are played. The default is False.
    show : callable, optional
        ``show(a, b)`` returns text, or an image (rows, columns, 3) of uint8, of the genomes a and b
        (genes,): what `matrixworld replay` prints and pages show.

    Raises
    ------
    ValueError, TypeError
        If genes or teams are not those of two teams, or bounds are no intervals.

    Examples
    --------
    >>> import numpy as np
    >>> import matrixworld as mw
    >>> def beats(a, b, rng):
    ...     return 1 / (1 + np.exp(b.sum(1) - a.sum(1)))
    >>> numbers = mw.Game(beats, genes=5, teams=("hosts", "parasites"))
    """

    play: Play
    genes: int | tuple[int, int]
    teams: tuple[str, str]
    initial: Callable[..., ArrayLike] | None = None
    bounds: tuple[ArrayLike, ArrayLike] | None = None
    deterministic: bool = False
    show: Callable[[Genome, Genome], Any] | None = None

    columns: ClassVar[Mapping[str, type]] = {"score": float, "matches": int}
    """Columns that logs have of an epoch, the score of the first team first, and their types."""
    score_words: ClassVar[tuple[str, str]] = ("score", "score")
    """What the scores of both teams are called."""
    single: ClassVar[tuple[str, ...]] = ()
    means: ClassVar[tuple[str, ...]] = ()
    """Extras that a payoff holds: those of single episodes, and those of which it holds means."""
    counters: ClassVar[tuple[str, ...]] = ()  # what a run counts beside its matches

    def __post_init__(self) -> None:
        for name in ("play", "initial", "show"):
            function = getattr(self, name)
            if not callable(function) and (function is not None or name == "play"):
                raise TypeError(f"{name}: expected a function, got {checks.shown(function)}")
        sizes = self._checked_genes()
        object.__setattr__(self, "genes", sizes)
        self._check_teams()
        checks.check_bool("deterministic", self.deterministic)
        if self.bounds is not None:
            object.__setattr__(self, "bounds", self._checked_bounds(sizes))

    def _checked_genes(self) -> tuple[int, ...]:
        """Return the number of genes of each team; ValueError unless these are two."""
        genes = self.genes if isinstance(self.genes, tuple | list) else (self.genes, self.genes)
        sizes = tuple(checks.check_integer("genes", n, 1) for n in genes)
        if len(sizes) != 2:
            raise ValueError(f"genes: expected those of two teams, got {len(sizes)}")
        return sizes

    def _check_teams(self) -> None:
        """Raise ValueError unless the names of the teams are two different words."""
        names = checks.check_sequence("teams", self.teams, "str")
        if len(names) != 2:
            raise ValueError(f"teams: expected those of two teams, got {len(names)}")
        words = all(isinstance(name, str) and name.isidentifier() for name in names)
        if not words or names[0] == names[1]:
            raise ValueError(f"teams: expected two different words, got {checks.shown(self.teams)}")

    def _checked_bounds(self, sizes: tuple[int, ...]) -> tuple[NDArray[Any], NDArray[Any]]:
        """Return the bounds as arrays; ValueError unless they are intervals of the genes."""
        ends = checks.check_sequence("bounds", self.bounds, "numbers")
        if len(ends) != 2:
            raise ValueError(f"bounds: expected the least and the largest value, got {len(ends)}")
        low, high = (checks.check_floats("bounds", end, np.float32) for end in ends)
        for end in (low, high):
            if end.ndim and {end.shape} != {(size,) for size in sizes}:
                raise ValueError(
                    f"bounds: expected one value, or one for each gene of both teams, {sizes}, "
                    f"got {end.size}"
                )
        if not (low < high).all():
            raise ValueError(f"bounds: expected least < largest value, got {low} and {high}")
        return low, high

    # What a run asks for:

    def genome_size(self, team: Team) -> int:
        """Return the number of genes of a team."""
        size: int = self.genes[TEAMS.index(team)]  # type: ignore[index]  # two, see above
        return size

    def untrained(self, team: Team, rng: Rng) -> Genome:
        """Return a new untrained genome (genes,) float32; ValueError if it has another shape."""
        size = self.genome_size(team)
        if self.initial is None:
            genome: Genome = rng.standard_normal(size, dtype=np.float32)
        else:
            same = self.genome_size("pursuer") == self.genome_size("evader")
            name = self.teams[TEAMS.index(team)]
            drawn = self.initial(rng) if same else self.initial(rng, name)
            genome = checks.check_floats("initial", drawn, np.float32)
            if genome.shape != (size,) or not np.isfinite(genome).all():
                got = checks.shown(genome)
                raise ValueError(f"initial: expected {size} finite genes, got {got}")
        return clipped(genome, self.bounds)

    def population(self, team: Team, genomes: Genomes) -> Any:
        """Return genomes (n, genes) as what plays; ValueError unless they are finite."""
        expected = (len(genomes), self.genome_size(team))
        if np.shape(genomes) != expected:
            raise ValueError(f"genomes: expected shape {expected}, got {np.shape(genomes)}")
        checks.check_finite("genomes", genomes)
        return Strategies(clipped(genomes, self.bounds))

    def scores(
        self, first: Any, second: Any, matches: Matches, *, episodes: int, threads: int | None
    ) -> Scores:
        """Play M matches, each a number of the first team, one of the second, and a seed.

        A game of your own plays in one thread, whatever `threads` says.
        """
        a, b, seeds = matches
        ones = first.genomes[a]
        others = second.genomes[b]
        if self.deterministic:
            scores = self._checked([self.play(ones, others, np.random.default_rng(0))], len(a))
            return Scores(np.repeat(scores[:, np.newaxis], episodes, axis=1))
        calls = []
        draws = _MatchDraws()
        for (m, seed), episode in product(enumerate(seeds.tolist()), range(episodes)):
            rng = draws.of(seed, episode)
            calls.append(self.play(ones[m : m + 1], others[m : m + 1], rng))
        return Scores(self._checked(calls, 1).reshape(len(a), episodes))

    def _checked(self, calls: list[ArrayLike], matches: int) -> NDArray[np.float32]:
        """Return the scores of all calls, each of so many matches."""
        for returned in calls:
            shape = checks.unmasked("scores of the game", returned).shape
            if shape != (matches,):
                raise ValueError(f"scores of the game: expected shape ({matches},), got {shape}")
        scores = checks.check_floats("scores of the game", np.concatenate(calls), np.float32)
        wrong = scores[~((scores >= 0.0) & (scores <= 1.0))]  # NaN, too
        if wrong.size:
            raise ValueError(f"scores of the game: expected numbers in [0, 1], got {wrong[0]}")
        return scores

    def values(self, scores: Scores, team: Team, measure: str, *, raw: bool = False) -> FloatArray:
        """Return what a team is selected by, (M, N); with `raw` in [0, 1], without any penalty."""
        return scores.of(team)

    def row(self, scores: Scores) -> dict[str, float]:
        """Return the values of an epoch in `columns`, without what is counted."""
        return {"score": float(scores.scores.mean(dtype=np.float64))}

    def counted(self, scores: Scores) -> dict[str, int]:
        """Return what matches add to `counters`."""
        return {}

    @no_exit("show")
    def shown(self, a: Genome, b: Genome) -> str | bytes:
        """Return what the game shows of two genomes: text, or the bytes of a PNG file."""
        if self.show is None:
            raise ValueError("show: expected a function of the game that shows a match, got none")
        shown = self.show(a, b)
        if isinstance(shown, str):
            return shown
        image = checks.unmasked("show", shown)
        if image.dtype != np.uint8 or image.ndim != 3 or image.shape[2] != 3:
            raise ValueError(
                "show: expected text or an image of uint8 (rows, cols, 3), "
                f"got {image.dtype} {image.shape}"
            )
        buffer = io.BytesIO()
        Image.fromarray(image).save(buffer, "PNG")
        return buffer.getvalue()

    # What only pursuit has: collisions, policies with a mask and a shape, opponents from elsewhere,
    # and rewards. Settings refuse what asks for these in a game of vectors.

    def costs(self, scores: Scores, team: Team) -> FloatArray:
        """Return what a `cost_limit` is about, (M,); ValueError without costs."""
        raise ValueError("cost_limit: expected no value in a game without collisions")

    def mask(self, team: Team) -> Any:
        """Return genes that do not change, and their values; None without any."""
        return None

    def shape_of(self, opponents: Any) -> dict[str, Any]:
        """Return what config.json keeps of opponents beside their genomes."""
        return {}

    def opponents(self, team: Team, genomes: Genomes, shape: Mapping[str, Any]) -> Any:
        """Return genomes of opponents whose `shape_of` is given."""
        return self.population(team, genomes)

    def check_opponents(self, team: Team, opponents: Any) -> None:
        """Raise ValueError if opponents do not fit the game."""

    def check_start(self, population: Any) -> None:
        """Raise ValueError if a genome to start from does not fit the game."""

    def experience(self, team: Team, *matches: Any, **options: Any) -> Any:
        """Play matches again for a learner by gradients."""
        raise TypeError("experience: expected pursuit and evasion, got a game without views")


# What a race states of its game:


@section()
class GameSettings(Section):
    """Base of what is raced: pursuit and evasion, or a game of your own.

    A run is read with these settings alone, without an import of its game.
    """

    game_class: ClassVar[type[Game]] = Game
    """What logs and payoffs of the game hold."""

    @property
    @abstractmethod
    def variant(self) -> str:
        """What the game is called."""

    @property
    @abstractmethod
    def source(self) -> str:
        """Where the game is found: pursuit in the package, or a ``module:object``."""

    @property
    @abstractmethod
    def known(self) -> Game:
        """What is known of the game without an import."""

    @property
    def teams(self) -> tuple[str, str]:
        """What the teams are called, in the plural."""
        return self.known.teams

    @property
    def keys(self) -> tuple[str, str]:
        """Names of the teams in logs and mappings."""
        return self.teams

    @property
    def deterministic(self) -> bool:
        """Whether equal genomes always have equal scores."""
        return self.known.deterministic

    @abstractmethod
    def evaluation(self) -> Game:
        """Return the game as it is evaluated; a game of your own is imported."""

    @abstractmethod
    def training(self, *, alone: bool) -> Game:
        """Return the game in which teams learn; `alone`: one team, from untrained genomes."""
