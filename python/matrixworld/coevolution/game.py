"""Games of two populations: all that co-evolution knows of what it races.

The teams of a game are called pursuers and evaders wherever its names do not matter: in settings
and keys of random numbers. `matrixworld.coevolution.pursuit` is the game of the package.
"""

from __future__ import annotations

import inspect
import io
import sys
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from functools import partial
from hashlib import sha256
from itertools import product
from pathlib import Path
from types import CodeType, FunctionType, ModuleType
from typing import Any, ClassVar

import numpy as np
from numpy.typing import ArrayLike, NDArray
from PIL import Image

from matrixworld._util import checks
from matrixworld.coevolution.sections import PATH, Section, imported, no_exit, section, setting
from matrixworld.coevolution.types import TEAMS, FloatArray, Genome, Genomes, Matches, Rng, Team

Play = Callable[[Genomes, Genomes, Rng], ArrayLike]


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


@dataclass(frozen=True, eq=False)
class Strategies:
    """Genomes (n, genes) of a team, which can play."""

    genomes: Genomes


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
        If the number of genes or teams is another one, or bounds are no intervals.

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
            given = getattr(self, name)
            is_function = callable(given) or (given is None and name != "play")
            checks.expect(is_function, name, "a function", checks.shown(given), TypeError)
        genes = self.genes if isinstance(self.genes, tuple | list) else (self.genes, self.genes)
        sizes = tuple(checks.check_integer("genes", n, 1) for n in genes)
        object.__setattr__(self, "genes", sizes)
        names = checks.check_sequence("teams", self.teams, "str")
        for given, name in ((sizes, "genes"), (names, "teams")):
            checks.expect(len(given) == 2, name, "those of two teams", len(given))
        words = all(isinstance(name, str) and name.isidentifier() for name in names)
        two = words and names[0] != names[1]
        checks.expect(two, "teams", "two different words", checks.shown(self.teams))
        checks.check_bool("deterministic", self.deterministic)
        if self.bounds is not None:
            count = len(checks.check_sequence("bounds", self.bounds, "numbers"))
            checks.expect(count == 2, "bounds", "the least and the largest value", count)
            low, high = (checks.check_floats("bounds", each, np.float32) for each in self.bounds)
            for each in (low, high):
                fits = not each.ndim or {each.shape} == {(size,) for size in sizes}
                expected = f"one value, or one for each gene of both teams, {sizes}"
                checks.expect(fits, "bounds", expected, each.size)
            ordered, got = (low < high).all(), f"{low} and {high}"
            checks.expect(ordered, "bounds", "least < largest value", got)
            object.__setattr__(self, "bounds", (low, high))

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
            fits = genome.shape == (size,) and np.isfinite(genome).all()
            checks.expect(fits, "initial", f"{size} finite genes", genome)
        return self.clipped(genome)

    def clipped(self, genomes: Genomes) -> Genomes:
        """Return genomes inside the bounds."""
        return genomes if self.bounds is None else np.clip(genomes, *self.bounds)

    def population(self, team: Team, genomes: Genomes) -> Any:
        """Return genomes (n, genes) as what plays; ValueError unless they are finite."""
        shape, expected = np.shape(genomes), (len(genomes), self.genome_size(team))
        fit = shape == expected and np.isfinite(genomes).all()
        checks.expect(fit, "genomes", f"finite ones {expected}", shape)
        return Strategies(self.clipped(genomes))

    def scores(
        self, first: Any, second: Any, matches: Matches, *, episodes: int, threads: int | None
    ) -> Scores:
        """Play M matches, each a number of the first team, one of the second, and a seed."""
        a, b, seeds = matches
        one, other = first.genomes[a], second.genomes[b]
        if self.deterministic:
            found = self._checked([self.play(one, other, np.random.default_rng(0))], len(a))
            return Scores(np.repeat(found[:, np.newaxis], episodes, axis=1))
        calls = []
        for (m, seed), episode in product(enumerate(seeds.tolist()), range(episodes)):
            rng = np.random.Generator(np.random.Philox(key=[seed, episode]))
            calls.append(self.play(one[m : m + 1], other[m : m + 1], rng))
        return Scores(self._checked(calls, 1).reshape(len(a), episodes))

    def _checked(self, calls: list[ArrayLike], matches: int) -> NDArray[np.float32]:
        """Return the scores of all calls, each of so many matches."""
        for found in calls:
            shape = checks.unmasked("scores of the game", found).shape
            fits = shape == (matches,)
            checks.expect(fits, "scores of the game", f"shape ({matches},)", shape)
        scores = checks.check_floats("scores of the game", np.concatenate(calls), np.float32)
        wrong = scores[~((scores >= 0.0) & (scores <= 1.0))]  # NaN, too
        got = wrong[0] if wrong.size else ""
        checks.expect(not wrong.size, "scores of the game", "numbers in [0, 1]", got)
        return scores

    def values(self, scores: Scores, team: Team, measure: str, *, raw: bool = False) -> FloatArray:
        """Return what a team is selected by, (M, N); with `raw` in [0, 1], without any penalty."""
        return scores.of(team)

    def costs(self, scores: Scores, team: Team) -> FloatArray:
        """Return what a `cost_limit` is about, (M,); ValueError without costs."""
        raise ValueError("cost_limit: expected no value in a game without collisions")

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
        fits = image.dtype == np.uint8 and image.ndim == 3 and image.shape[2] == 3
        expected, got = "text or an image of uint8 (rows, cols, 3)", f"{image.dtype} {image.shape}"
        checks.expect(fits, "show", expected, got)
        buffer = io.BytesIO()
        Image.fromarray(image).save(buffer, "PNG")
        return buffer.getvalue()

    # What only some games have:

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


# Games of your own, by name:


@section
class OwnGame(Section):
    """A game of your own: its name, and what a run must know of it without an import."""

    kind: ClassVar[str] = "own"
    base: ClassVar[type] = Game

    code: str = setting("", "module:object")
    genes: tuple[int, int] = setting((), "length of the genomes of each team")
    teams: tuple[str, str] = setting((), "names of the teams")
    deterministic: bool = setting(False, "whether equal genomes always have equal scores")
    digest: str = setting("", "digest of its source")

    @classmethod
    def named(cls, game: Game) -> dict[str, Any]:
        """Return the fields of a game, a global of the module of its function."""
        module = sys.modules.get(getattr(game.play, "__module__", ""))
        names = [name for name, value in vars(module).items() if value is game] if module else []
        if module is None or not names:
            raise ValueError(
                "game: expected a global variable of the module of its function, so that a run can "
                f"find it again, got one that is none of {getattr(module, '__name__', 'a module')}"
            )
        return {"kind": f"{_file_of(module) or module.__name__}:{names[0]}"}

    def check(self) -> None:
        """Import a game that is given by its name alone; errors as those of `load`."""
        checks.expect(PATH.fullmatch(self.code), "code", "module:object", checks.shown(self.code))
        if not self.digest:
            game = self._imported()
            facts = {"genes": game.genes, "teams": game.teams, "deterministic": game.deterministic}
            for name, value in {**facts, "digest": digest_of(game)}.items():
                object.__setattr__(self, name, value)

    @property
    def known(self) -> Game:
        """What is known of the game without an import: all but its functions."""
        return Game(_not_imported, self.genes, self.teams, deterministic=self.deterministic)

    def load(self) -> Game:
        """Return the game; ValueError if there is none of this name, or another one."""
        game = self._imported()
        for name in ("genes", "teams", "deterministic"):
            expected, found = getattr(self, name), getattr(game, name)
            checks.expect(found == expected, self.code, f"a game with {name} {expected}", found)
        return game

    def changed(self) -> str:
        """Return in words that the source of the game has changed; empty if it has not."""
        if digest_of(self.load()) == self.digest:
            return ""
        return f"{self.code}: expected the source of the game as it was, got a changed one"

    def _imported(self) -> Game:
        module, _, name = self.code.partition(":")
        main = sys.modules["__main__"]
        # Imported once more, a script that runs would begin anew.
        running = main if module in ("__main__", _file_of(main)) else None
        game = getattr(running, name, None) or imported(self.code)
        if not isinstance(game, Game):
            raise ValueError(f"{self.code}: expected a Game, got {checks.shown(game)}")
        return game


def _not_imported(a: Genomes, b: Genomes, rng: Rng) -> ArrayLike:
    raise TypeError("play: expected a game that is imported")


def _file_of(module: ModuleType) -> str:
    """Return by what name other processes import a script that runs; empty without such a name."""
    if module.__name__ not in MAIN:
        return ""
    spec = getattr(module, "__spec__", None)  # python -m package.module
    name: str = spec.name if spec else Path(getattr(module, "__file__", None) or "").stem
    return name if all(part.isidentifier() for part in name.split(".")) else ""


MAIN = ("__main__", "__mp_main__")
"""Names of the script that runs, and of its copy in processes that it has started."""


def digest_of(game: Game) -> str:
    """Return a digest of a game's fields, and of the source of its functions and what they name."""
    parts: dict[str, str] = {}
    fields = {name: getattr(game, name) for name in ("genes", "teams", "bounds", "deterministic")}
    for name in ("play", "initial", "show"):
        function = getattr(game, name)
        fields[name] = _text_of(function, getattr(function, "__module__", ""), parts)
    facts = _text_of(fields, "", parts)
    text = "\n".join([facts, *(f"{name}\n{parts[name]}" for name in sorted(parts))])
    return sha256(text.encode()).hexdigest()[:16]


def _text_of(value: Any, module: str, parts: dict[str, str]) -> str:
    """Return a text of a value, the same in every process; sources go to `parts`."""
    if isinstance(value, np.ndarray | np.generic):
        value = value.tolist()
    if isinstance(value, Mapping):
        return _text_of(list(value.items()), module, parts)
    if isinstance(value, tuple | list):
        return f"[{', '.join(_text_of(each, module, parts) for each in value)}]"
    if isinstance(value, int | float | str | None):
        return repr(value)
    if isinstance(value, partial):
        inner = getattr(value.func, "__module__", "")
        return _text_of([value.func, value.args, value.keywords], inner, parts)
    function = inspect.unwrap(getattr(value, "__func__", value))
    if not isinstance(function, FunctionType):
        called = getattr(type(value), "__call__", None)  # noqa: B004, of its class
        if not isinstance(called, FunctionType):
            return type(value).__qualname__
        return _text_of([called, vars(value)], module, parts)  # an object that plays
    name = function.__qualname__
    if function.__module__ == module and name not in parts:
        code = function.__code__
        try:
            parts[name] = inspect.getsource(function)
        except OSError:  # typed at a prompt that keeps no source
            parts[name] = f"{code.co_code.hex()} {code.co_consts} {code.co_names}"
        for used in {*_names(code)} & {*function.__globals__}:
            found = function.__globals__[used]
            if not isinstance(found, ModuleType | type):
                text = _text_of(found, module, parts)
                parts.setdefault(used, text)
    return name


def _names(code: CodeType) -> Iterator[str]:
    """Yield the names that a function uses, with those of the functions inside it."""
    yield from code.co_names
    for constant in code.co_consts:
        if isinstance(constant, CodeType):
            yield from _names(constant)


CHECKED = 64  # matches of a check


@no_exit("check_game")
def check_game(game: Game) -> None:
    """Check that a `game` keeps the promises of `Game`.

    Untrained genomes have their shape and lie within the bounds; scores are finite numbers in
    [0, 1], one of each match; they do not depend on the order of the matches, nor on which others
    are played; equal generators give equal scores, whatever other random numbers are drawn
    meanwhile. ValueError says which is broken; an error in the game's own code is raised as it is.

    Examples
    --------
    >>> import matrixworld as mw
    >>> larger = mw.Game(lambda a, b, rng: (a > b).mean(1), genes=3, teams=("ones", "others"))
    >>> mw.coevolution.check_game(larger)
    """
    checks.check_instance("game", game, Game)
    rng = np.random.default_rng(0)
    first, second = (
        game.population(team, np.stack([game.untrained(team, rng) for _ in range(CHECKED)]))
        for team in TEAMS
    )
    everyone = np.arange(CHECKED)
    matches = everyone, everyone[::-1], everyone.astype(np.uint64)

    def played(matches: Matches, state: int) -> FloatArray:
        before = np.random.get_state()  # noqa: NPY002, to find games that use this generator
        np.random.seed(state)  # noqa: NPY002
        try:
            return game.scores(first, second, matches, episodes=2, threads=1).of("pursuer")
        finally:
            np.random.set_state(before)  # noqa: NPY002

    scores = played(matches, 1)
    checks.expect(
        np.array_equal(scores, played(matches, 2)), "play", "equal scores from equal generators",
        "others; random numbers must come from the rng that is passed, and nothing may change from "
        "call to call",
    )  # fmt: skip
    order = rng.permutation(CHECKED)[: CHECKED // 2]
    a, b, seeds = matches
    alone = np.array_equal(scores[order], played((a[order], b[order], seeds[order]), 1))
    got = "some that depend on other matches or their order"
    checks.expect(alone, "play", "scores of each match alone", got)
