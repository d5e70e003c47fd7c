"""Games of two populations: all that co-evolution knows of what it races.

The teams of a game are called pursuers and evaders wherever its names do not matter: in settings
and keys of random numbers. `games.pursuit` is the game of the package, `games.own_game` stands for
one of the user's.
"""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Callable, Mapping
from dataclasses import KW_ONLY, dataclass, field
from functools import cached_property
from itertools import product
from typing import Any, ClassVar, cast

import numpy as np
from numpy.typing import ArrayLike, NDArray

from matrixworld._util import checks
from matrixworld._util.callers import calling_modules
from matrixworld._util.plugins import no_exit
from matrixworld._util.sections import Section, section
from matrixworld.coevolution.games.digest import digest_of
from matrixworld.coevolution.games.draws import MatchDraws, episode_seeds
from matrixworld.coevolution.games.operators import PAIRED, Operators, are_texts, as_genome
from matrixworld.coevolution.games.pictures import Picture, picture_of
from matrixworld.coevolution.games.workers import Part, play_in_processes
from matrixworld.coevolution.types import (
    LOGGED,
    TEAMS,
    FloatArray,
    Genome,
    Genomes,
    Matches,
    Rng,
    Seeds,
    Team,
)

TAKEN = ("scores", "others", "score", "other_score", "mean", "std", "matches", *LOGGED)
"""Names that files of a run have for something else than the extras of a game."""

FILES = ("config", "summary", "payoff", "log")
"""Names of files of a run, which no team can have: its genomes lie beside them."""

Play = Callable[..., Any]
"""Both genomes, or those of M matches, and perhaps random numbers -> scores of the first team."""


@dataclass(frozen=True, eq=False)
class Scores:
    """Scores (M, N) of the first team, in [0, 1], in M matches of N episodes.

    The second team has the scores `others`; without any it has 1 - score. What else the game tells
    are `extras`, by name, each (M, N, ...).
    """

    scores: NDArray[Any]
    extras: Mapping[str, NDArray[Any]] = field(default_factory=dict)
    others: NDArray[Any] | None = None

    def of(self, team: Team) -> FloatArray:
        """Return the scores (M, N) of a team."""
        if team == "evader" and self.others is not None:
            return np.asarray(self.others, dtype=np.float64)
        first = np.asarray(self.scores, dtype=np.float64)
        return first if team == "pursuer" else 1.0 - first

    def some(self, chosen: NDArray[np.bool_]) -> Scores:
        """Return the matches of some of M."""
        extras = {name: values[chosen] for name, values in self.extras.items()}
        others = None if self.others is None else self.others[chosen]
        return Scores(self.scores[chosen], extras, others)

    def from_both_sides(self) -> Scores:
        """Return the matches (2 M) as their first player sees them, and then as the second does."""
        sides = self.of("pursuer"), self.of("evader")
        extras = {name: np.concatenate([values] * 2) for name, values in self.extras.items()}
        return Scores(np.concatenate(sides), extras, np.concatenate(sides[::-1]))


def _numbers(name: str, calls: list[Any], shape: tuple[int, ...]) -> NDArray[np.float32]:
    """Return numbers that calls returned, each of a shape, one after the other; or an error."""
    for returned in calls:
        if isinstance(returned, float | int) and not shape:
            continue
        if isinstance(returned, tuple) and any(isinstance(part, Mapping) for part in returned):
            raise ValueError(f"{name}: expected numbers alone without `extras`, got a dict, too")
        got = checks.unmasked(name, returned).shape
        if got != shape:
            expected = f"shape {shape}" if shape else "a number"
            raise ValueError(f"{name}: expected {expected}, got {got or returned}")
    joined = np.concatenate(calls) if shape else np.asarray(calls)
    return checks.check_floats(name, joined, np.float32)


@dataclass(frozen=True, eq=False)
class Strategies:
    """Genomes (n, genes) of a team, which can play."""

    genomes: Genomes


def clipped(genomes: Genomes, bounds: tuple[ArrayLike, ArrayLike] | None) -> Genomes:
    """Return genomes inside some bounds of their genes, if there are any."""
    return genomes if bounds is None else np.clip(genomes, *bounds)


@dataclass(frozen=True, eq=False)
class Game:
    """A game of two populations of genomes: vectors of float32, or objects of any kind.

    An object has no `genes`, but an operator that mutates it. The package holds it as text, and
    each function of the game gets what `read` makes of this text; so does a race that goes on from
    files. With the same `seed` a race is the same on every machine if all functions draw from the
    `rng` that they get: `check_game` tells.

    Parameters
    ----------
    play : callable
        Returns scores of the first team in [0, 1]; the second has 1 - score, unless the game has
        both `scores`. Of vectors, ``play(a, b, rng)`` returns the scores (M,) of the genomes a (M,
        genes) against the genomes b (M, genes). Of objects, ``play(one, other, rng)`` returns the
        score of one match, a number, and without chance it is ``play(one, other)``. It must not
        change the objects.
    genes : int or tuple of two ints, optional
        Length of the genomes, of both teams or of each, if they are vectors.
    teams : tuple of str
        Names of both teams, in the plural; of a `symmetric` game the name of its population.
    initial : callable, optional
        ``initial(rng)`` returns an untrained genome; of vectors of different lengths it is
        ``initial(rng, team)``. By default the genes of vectors are drawn from N(0, 1). This and the
        following functions may be tuples of two, the functions of each team.
    mutate : callable, optional
        ``mutate(genome, rng)`` returns a mutant of an object. It may change the genome in place.
    mate : callable, optional
        ``mate(one, other, rng)`` returns a child of two objects. By default children have one
        parent.
    write, read : callable, optional
        ``write(genome)`` returns an object as text, and ``read(text)`` the object. By default these
        are `json.dumps`, without NaN, and `json.loads`. `read` gets what a file holds: a parser is
        safe with the files of others, and `eval` is not.
    bounds : tuple of two float or arrays of float, optional
        Least and largest value of the genes of vectors. Learners clip genomes, and the game never
        sees one outside. By default there are no bounds.
    deterministic : bool, optional
        Whether equal genomes always have equal scores. Then each pair is evaluated once, and the
        judgement takes the scores as exact; vectors are played all at once. Other vectors are
        played one match at a time, M = 1, and each match has a generator of its own: so a result
        does not depend on which other matches are played. The default is False.
    many : bool, optional
        Whether ``play(a, b, seeds)`` plays M matches at once: a and b are arrays (M, genes), or
        lists of M objects, and it returns scores (M,). Random numbers come from the `seeds` (M,) of
        uint64 alone, as by `uniforms`. The default is False.
    slow : bool, optional
        Whether a match takes so long, from some milliseconds on, that it pays to play matches side
        by side: the `threads` of a race are then processes, which import the game by its name and
        give equal scores for any number. The default is False.
    scores : {"one", "both"}, optional
        ``"both"`` if what one team wins is not what the other loses: then `play` returns the scores
        of both teams, of one match a pair and of M an array (M, 2). The judgement then speaks of
        each team's own score, and of the mean of both. The default is ``"one"``.
    symmetric : bool, optional
        Whether both sides are played by one population: an individual meets others of it, and its
        past. Which side it plays must make no difference. The default is False.
    extras : tuple of str, optional
        Names of numbers that `play` returns beside the scores, which log, payoff and page hold: it
        then returns ``scores, {"moves": number}``; of M matches (M,) numbers.
    show : callable, optional
        ``show(a, b)`` returns text, an image (rows, columns, 3) of uint8, or frames of a film, a
        list of such images, of two genomes: what `matrixworld replay` prints or writes and pages
        show. By default it is both texts, of vectors nothing.

    Raises
    ------
    ValueError, TypeError
        If genes or teams are not those of two teams, bounds are no intervals, or functions are
        missing, or have no effect.

    Examples
    --------
    >>> import numpy as np
    >>> import matrixworld as mw
    >>> def beats(a, b, rng):
    ...     return 1 / (1 + np.exp(b.sum(1) - a.sum(1)))
    >>> numbers = mw.Game(beats, genes=5, teams=("hosts", "parasites"))

    Genomes are words, which JSON holds:

    >>> def same(one, other):
    ...     return sum(a == b for a, b in zip(one, other)) / 4
    >>> def word(rng):
    ...     return "".join(rng.choice(["a", "b"], 4))
    >>> def change(text, rng):
    ...     at = rng.integers(4)
    ...     return text[:at] + str(rng.choice(["a", "b"])) + text[at + 1 :]
    >>> words = mw.Game(
    ...     same, teams=("seekers", "hiders"), initial=word, mutate=change, deterministic=True
    ... )
    >>> mw.coevolution.check_game(words)
    """

    play: Play
    genes: int | tuple[int, int] | None = None
    teams: tuple[str, str] = ()  # type: ignore[assignment]  # checked: a field needs a default here
    initial: Any = None
    _: KW_ONLY
    mutate: Any = None
    mate: Any = None
    write: Any = None
    read: Any = None
    bounds: tuple[ArrayLike, ArrayLike] | None = None
    deterministic: bool = False
    many: bool = False
    slow: bool = False
    scores: str = "one"
    symmetric: bool = False
    extras: tuple[str, ...] = ()
    show: Callable[[Any, Any], Any] | None = None
    made_in: tuple[str, ...] = field(default=(), init=False, repr=False)
    """Names of the modules in which it was made, the innermost first: a run looks for it there."""
    found_as: str = field(default="", init=False, repr=False)
    """The name by which a run has found it."""

    score_words: ClassVar[tuple[str, str]] = ("score", "score")
    """What the scores of both teams are called."""
    single: ClassVar[tuple[str, ...]] = ()
    """Extras of which a payoff holds single episodes."""
    counters: ClassVar[tuple[str, ...]] = ()  # what a run counts beside its matches

    def __post_init__(self) -> None:
        self._check_functions()
        for name in ("deterministic", "many", "slow", "symmetric"):
            checks.check_bool(name, getattr(self, name))
        checks.check_choice("scores", self.scores, ("one", "both"))
        self._check_extras()
        if not self.texts:
            object.__setattr__(self, "genes", self._checked_genes())
        self._check_teams()
        if self.bounds is not None:
            object.__setattr__(self, "bounds", self._checked_bounds())
        object.__setattr__(self, "made_in", calling_modules())

    def _check_functions(self) -> None:
        """Raise TypeError unless all functions that genomes of this kind need are there."""
        for name in ("play", "show", *PAIRED):
            given = getattr(self, name)
            each = given if isinstance(given, tuple) and name in PAIRED else (given,)
            for function in each:
                if not callable(function) and (function is not None or name == "play"):
                    raise TypeError(f"{name}: expected a function, got {checks.shown(function)}")
            if isinstance(given, tuple) and name in PAIRED and len(given) != 2:
                raise TypeError(f"{name}: expected a function of each team, got {len(given)}")
        if self.genes is None:
            for name, number in product(("initial", "mutate"), (0, 1)):
                if self._of_team(name, number) is None:
                    missing = f"{name}: expected a function of genomes that are objects, got none"
                    raise TypeError(f"{missing}; vectors have genes in its place")
            if self.bounds is not None:
                got = checks.shown(self.bounds)
                raise TypeError(
                    f"bounds: expected no value for genomes that are objects, got {got}"
                )
            return
        for name in PAIRED[1:]:
            if getattr(self, name) is not None:
                got = f"{name} and genes {checks.shown(self.genes)}"
                raise TypeError(
                    f"{name}: expected no value for vectors, which have genes, got {got}"
                )

    def _of_team(self, name: str, number: int) -> Any:
        """Return a function of the team of a number, or None."""
        given = getattr(self, name)
        return given[number] if isinstance(given, tuple) else given

    def _checked_genes(self) -> tuple[int, ...]:
        """Return the number of genes of each team; ValueError unless these are two."""
        genes = self.genes if isinstance(self.genes, tuple | list) else (self.genes, self.genes)
        sizes = tuple(checks.check_integer("genes", n, 1) for n in genes)
        if len(sizes) != 2:
            raise ValueError(f"genes: expected those of two teams, got {len(sizes)}")
        return sizes

    def _check_teams(self) -> None:
        """Name the population of a symmetric game twice; ValueError unless names are words."""
        names = checks.check_sequence("teams", self.teams, "str")
        words = all(isinstance(name, str) and name.isidentifier() for name in names)
        for name in names:
            if name in FILES:
                raise ValueError(
                    f"teams: expected other words than {', '.join(FILES)}, got {name!r}"
                )
        if self.symmetric:
            if not words or len({*names}) != 1 or len(names) > 2:
                got = checks.shown(self.teams)
                raise ValueError(f"teams: expected one word in a symmetric game, got {got}")
            if self.genome_size("pursuer") != self.genome_size("evader"):
                raise ValueError(
                    f"genes: expected one number in a symmetric game, got {self.genes}"
                )
            pairs = [name for name in PAIRED if isinstance(getattr(self, name), tuple)]
            if pairs:
                raise TypeError(f"{pairs[0]}: expected one function in a symmetric game, got two")
            object.__setattr__(self, "teams", (names[0], names[0]))
            return
        if len(names) != 2:
            more = "; one population has symmetric=True" if len(names) == 1 else ""
            raise ValueError(f"teams: expected those of two teams, got {len(names)}{more}")
        if not words or names[0] == names[1]:
            raise ValueError(f"teams: expected two different words, got {checks.shown(self.teams)}")

    def _check_extras(self) -> None:
        """Raise ValueError unless the names of extras are words that a log does not have."""
        names = checks.check_sequence("extras", self.extras, "str")
        for name in names:
            if not (isinstance(name, str) and name.isidentifier()) or name in TAKEN:
                raise ValueError(
                    f"extras: expected words other than {', '.join(TAKEN)}, got {name!r}"
                )
        object.__setattr__(self, "extras", names)

    def _checked_bounds(self) -> tuple[NDArray[Any], NDArray[Any]]:
        """Return the bounds as arrays; ValueError unless they are intervals of the genes."""
        ends = checks.check_sequence("bounds", self.bounds, "numbers")
        if len(ends) != 2:
            raise ValueError(f"bounds: expected the least and the largest value, got {len(ends)}")
        low, high = (checks.check_floats("bounds", end, np.float32) for end in ends)
        for end in (low, high):
            if end.ndim and {end.shape} != {(size,) for size in self.sizes}:
                raise ValueError(
                    f"bounds: expected one value, or one for each gene of both teams, "
                    f"{self.sizes}, got {end.size}"
                )
        if not (low < high).all():
            raise ValueError(f"bounds: expected least < largest value, got {low} and {high}")
        return low, high

    # What a run asks for:

    @cached_property
    def digest(self) -> str:
        """A digest of what the game is made of; see `games.digest`."""
        return digest_of(self)

    @property
    def general(self) -> bool:
        """Whether both teams have scores of their own, as in a general-sum game."""
        return self.scores == "both"

    def pairs_of(self, rows: int, columns: int) -> int:
        """Return how many pairs of so many members are played: of one population half of them."""
        if not self.symmetric or rows != columns:
            return rows * columns
        diagonal = rows if self.plays_itself(rows) else 0
        return rows * (rows - 1) // 2 + diagonal

    def plays_itself(self, members: int) -> bool:
        """Return whether so many members of a symmetric game play against themselves.

        What one wins against itself it loses: without anything else to tell, nobody plays that.
        """
        return members == 1 or self.general or bool(self.extras)

    @property
    def columns(self) -> Mapping[str, type]:
        """Columns that logs have of an epoch, the first team's score first, and their types."""
        other = {"other_score": float} if self.general else {}
        return {"score": float, **other, **dict.fromkeys(self.extras, float), "matches": int}

    @property
    def means(self) -> tuple[str, ...]:
        """Extras of which a payoff holds means over the episodes of a pair."""
        return self.extras

    @property
    def texts(self) -> bool:
        """Whether genomes are objects, which the package holds as text: arrays (n, 1) of str."""
        return self.mutate is not None

    @cached_property
    def operators(self) -> Mapping[Team, Operators]:
        """What makes the genomes of each team, if they are objects."""
        return {
            team: Operators(**{name: self._of_team(name, number) for name in PAIRED})
            for number, team in enumerate(TEAMS)
        }

    @property
    def sizes(self) -> tuple[int, int]:
        """Length of the genomes of each team; a text is one gene."""
        return (1, 1) if self.texts else cast("tuple[int, int]", self.genes)

    def genome_size(self, team: Team) -> int:
        """Return the number of genes of a team; a text is one."""
        return self.sizes[TEAMS.index(team)]

    def untrained(self, team: Team, rng: Rng) -> Genome:
        """Return a new untrained genome, (genes,) float32 or (1,) text.

        Raises TypeError or ValueError if the game makes something else.
        """
        if self.texts:
            return as_genome(self.operators[team].untrained(rng))
        size = self.genome_size(team)
        initial = self._of_team("initial", TEAMS.index(team))
        if initial is None:
            genome: Genome = rng.standard_normal(size, dtype=np.float32)
        else:
            one = isinstance(self.initial, tuple) or len({*map(self.genome_size, TEAMS)}) == 1
            drawn = initial(rng) if one else initial(rng, self.teams[TEAMS.index(team)])
            genome = checks.check_floats("initial", drawn, np.float32)
            if genome.shape != (size,) or not np.isfinite(genome).all():
                got = checks.shown(genome)
                raise ValueError(f"initial: expected {size} finite genes, got {got}")
        return clipped(genome, self.bounds)

    def population(self, team: Team, genomes: Genomes) -> Any:
        """Return genomes (n, genes) as what plays; ValueError unless they are finite, or text."""
        expected = (len(genomes), self.genome_size(team))
        if np.shape(genomes) != expected:
            raise ValueError(f"genomes: expected shape {expected}, got {np.shape(genomes)}")
        if self.texts:
            if not are_texts(genomes, expected):
                raise ValueError(f"genomes: expected text, got {checks.shown(genomes)}")
            return Strategies(genomes)
        checks.check_finite("genomes", genomes)
        return Strategies(clipped(genomes, self.bounds))

    # Matches:

    def rollout(
        self, first: Any, second: Any, matches: Matches, *, episodes: int, threads: int | None
    ) -> Scores:
        """Play M matches, each a number of the first team, one of the second, and a seed.

        A game of your own plays in one thread, whatever `threads` says; a slow one has that many
        processes.
        """
        self.digest  # noqa: B018, taken before a match changes what the game holds
        a, b, seeds = matches
        times = 1 if self.deterministic else episodes
        asked = Part(first.genomes[a], second.genomes[b], seeds, range(times))
        played = play_in_processes(self, asked, threads) if self.slow else self.played(*asked)
        repeated = {
            name: np.repeat(values, episodes // times, axis=1) for name, values in played.items()
        }
        return Scores(repeated.pop("scores"), others=repeated.pop("others", None), extras=repeated)

    def played(
        self, ones: Genomes, others: Genomes, seeds: Seeds, episodes: range
    ) -> dict[str, NDArray[np.float32]]:
        """Return what N episodes of matches of genomes (M, genes) have, each (M, N).

        That is ``scores``, perhaps ``others``, those of the second team, and extras by name.
        """
        shape = len(ones), len(episodes)
        if not self.texts:
            results = self._results(ones, others, seeds, episodes)
            return {name: values.reshape(shape) for name, values in results.items()}
        first, second = (
            {
                text: self.operators[team].genome(text)
                for text in dict.fromkeys(genomes[:, 0].tolist())
            }
            for team, genomes in zip(TEAMS, (ones, others), strict=True)
        )
        results = self._results(
            [first[text] for text in ones[:, 0].tolist()],
            [second[text] for text in others[:, 0].tolist()],
            seeds,
            episodes,
        )
        for team, genomes in zip(TEAMS, (first, second), strict=True):
            for text, genome in genomes.items():
                if (after := self.operators[team].written(genome)) != text:
                    self.operators[team].check_read(text, "an operator")
                    got = f"{checks.shown(after)} of {checks.shown(text)}"
                    raise ValueError(f"play: expected genomes that stay as they were, got {got}")
        return {name: values.reshape(shape) for name, values in results.items()}

    def _results(
        self, ones: Any, others: Any, seeds: Seeds, episodes: range
    ) -> dict[str, NDArray[np.float32]]:
        """Return what matches have, all episodes of one after the other, as `play` returns it."""
        if self.many:
            repeated = np.repeat(np.arange(len(seeds)), len(episodes)).tolist()
            if self.texts:
                ones, others = ([side[m] for m in repeated] for side in (ones, others))
            else:
                ones, others = ones[repeated], others[repeated]
            calls = [self.play(ones, others, episode_seeds(seeds, episodes))]
            return self._checked(calls, (len(repeated),))
        if self.deterministic and self.texts:
            return self._checked([self.play(a, b) for a, b in zip(ones, others, strict=True)], ())
        if self.deterministic:
            calls = [self.play(ones, others, np.random.default_rng(0))]
            return self._checked(calls, (len(seeds),))
        draws = MatchDraws()
        each = product(enumerate(seeds.tolist()), episodes)
        if self.texts:
            calls = [self.play(ones[m], others[m], draws.of(seed, n)) for (m, seed), n in each]
            return self._checked(calls, ())
        calls = [
            self.play(ones[m : m + 1], others[m : m + 1], draws.of(seed, n))
            for (m, seed), n in each
        ]
        return self._checked(calls, (1,))

    def _checked(self, calls: list[Any], shape: tuple[int, ...]) -> dict[str, NDArray[np.float32]]:
        """Return what calls of `play` returned of matches of a shape, () or (M,), by name."""
        extras: dict[str, NDArray[np.float32]] = {}
        if self.extras:
            for returned in calls:
                self._check_returned(returned)
            for name in self.extras:
                extras[name] = _numbers(name, [told[name] for _, told in calls], shape)
                checks.check_finite(name, extras[name])
            calls = [scores for scores, _ in calls]
        wanted = (*shape, 2) if self.general else shape
        scores = _numbers("scores of the game", calls, wanted)
        wrong = scores[~((scores >= 0.0) & (scores <= 1.0))]  # NaN, too
        if wrong.size:
            raise ValueError(f"scores of the game: expected numbers in [0, 1], got {wrong[0]}")
        if self.general:
            one, other = scores.reshape(-1, 2).T
            return {"scores": one, "others": other, **extras}
        return {"scores": scores, **extras}

    def _check_returned(self, returned: Any) -> None:
        """Raise ValueError unless these are scores, and a mapping with all extras."""
        is_pair = isinstance(returned, tuple) and len(returned) == 2
        told = returned[1] if is_pair else None
        if not isinstance(told, Mapping) or {*told} != {*self.extras}:
            raise ValueError(
                f"play: expected scores, and a dict of {', '.join(self.extras)}, "
                f"got {checks.shown(returned)}"
            )

    def values(self, scores: Scores, team: Team, measure: str, *, raw: bool = False) -> FloatArray:
        """Return what a team is selected by, (M, N); with `raw` in [0, 1], without any penalty."""
        return scores.of(team)

    def row(self, scores: Scores) -> dict[str, float]:
        """Return the values of an epoch in `columns`, without what is counted."""
        means = {"score": scores.scores, **scores.extras}
        if scores.others is not None:
            means["other_score"] = scores.others
        return {
            name: float(means[name].mean(dtype=np.float64))
            for name, kind in self.columns.items()
            if kind is float
        }

    def counted(self, scores: Scores) -> dict[str, int]:
        """Return what matches add to `counters`."""
        return {}

    @property
    def shows(self) -> bool:
        """Whether the game shows a match of two genomes."""
        return self.show is not None or self.texts

    @no_exit("show")
    def shown(self, a: Genome, b: Genome) -> str | Picture:
        """Return what the game shows of two genomes: text, or a picture."""
        if not self.shows:
            raise ValueError("show: expected a function of the game that shows a match, got none")
        if self.show is None:
            texts = zip(self.teams, (a[0], b[0]), strict=True)
            return "\n".join(f"{team}: {text}" for team, text in texts)
        players: Any = (a, b)
        if self.texts:
            each = zip(TEAMS, (a, b), strict=True)
            players = [self.operators[team].genome(str(genome[0])) for team, genome in each]
        shown = self.show(*players)
        return shown if isinstance(shown, str) else picture_of(shown)

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

    def check_start(self, team: Team, population: Any) -> None:
        """Raise ValueError if a genome that a team starts from does not fit the game."""

    def experience(self, team: Team, *matches: Any, **options: Any) -> Any:
        """Play matches again for a learner by gradients."""
        raise TypeError("experience: expected pursuit and evasion, got a game without views")


# What a race states of its game:


@section()
class GameSettings(Section):
    """Base of what is raced: pursuit and evasion, or a game of your own.

    A run is read with these settings alone, without an import of its game.
    """

    in_threads: ClassVar[bool] = False
    """Whether threads of the engine play its matches."""

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
    def symmetric(self) -> bool:
        """Whether one population plays both sides."""
        return self.known.symmetric

    @property
    def general(self) -> bool:
        """Whether both teams have scores of their own."""
        return self.known.general

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
