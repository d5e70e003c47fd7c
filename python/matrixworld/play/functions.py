"""Functions as players: how they are asked, in episodes and for all that they may see.

What a function reads and remembers is told by its parameters (see `Function`). It answers with an
action, or with the probabilities of all actions.
"""

from __future__ import annotations

import inspect
import pickle
import sys
import traceback
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from matrixworld._util import checks
from matrixworld._util.alarms import TooSlowError, alarm
from matrixworld.play.draws import FollowedDraws, NotExactError, branches
from matrixworld.world.arrays import CHANNEL
from matrixworld.world.config import WorldConfig
from matrixworld.world.masks import MASKS, Mask
from matrixworld.world.policy import Team
from matrixworld.world.rating import INPUTS, allowed_moves
from matrixworld.world.world import World

ASKED_AGAIN = 64
"""Of so many views, evenly spread, a function is asked twice: what it keeps or draws by itself, and
not by its arguments, shows in its answers."""

Floats: TypeAlias = NDArray[np.float64]

_BY_STEP = "must_yield"
_DRAWN = ("ahead", "search")
_ROUNDING = 1e-6
"""By how much probabilities may differ from a sum of 1."""


class PlayerError(ValueError):
    """A function fails, or its answer is no action. The message says where, and what came."""


class Function:
    """A function that plays for a team.

    ==========================  ====================================================================
    ``f(views)``                views of n agents, uint8 (n, 3, fov, fov), to n answers
    ``f(view)``                 the view of one agent, uint8 (3, fov, fov), to one answer
    ``f(view, rng)``            with a `numpy.random.Generator` for all random numbers
    ``f(view, rng, memory)``    with a dict of this agent, empty at the start of an episode
    ``f(x, allowed, rng)``      with the named inputs of the moves, ``x[name]`` float32 (moves,),
                                and which moves its ``MASK`` allows, bool (moves,): the function
                                ``choose`` that `RatingPolicy.to_python` writes
    ==========================  ====================================================================

    The first two are told apart by asking. Parameters named ``rng`` and ``memory`` get these
    wherever they stand; other parameters without defaults count by their order. An answer is an
    action, or the probabilities of all actions, float (n_actions,). A module of torch gets views as
    float32; its outputs are actions (n,), or numbers (n, n_actions) of which the largest is taken.

    Parameters
    ----------
    function : callable
        The function.
    name : str, optional
        What it is called in messages. The default is its own name.
    fov : int, optional
        Side of the view that it gets, odd: the middle of a larger one. The default is the world's.
    seconds : float, optional
        Longest time of one call, in the main thread of systems with alarm signals. The default is
        none.

    Raises
    ------
    TypeError, ValueError
        If it takes other arguments, or has an unknown ``MASK``.
    """

    def __init__(
        self,
        function: Callable[..., Any],
        *,
        name: str = "",
        fov: int | None = None,
        seconds: float | None = None,
    ) -> None:
        self.function = function
        self.name = name or getattr(function, "__name__", type(function).__name__)
        self.fov = None if fov is None else checks.check_integer("fov", fov, 1)
        if fov is not None and fov % 2 == 0:
            raise ValueError(f"fov: expected an odd number, got {fov}")
        self.seconds = seconds
        self.is_module = _is_module(function)
        given = {"": "view"} if self.is_module else _arguments_of(function, self.name)
        self._parameters = given
        self.arguments = tuple(given.values())
        mask = getattr(function, "__globals__", {}).get("MASK", "obstacles")
        if self.reads == "inputs":
            checks.check_choice(f"{self.name}: MASK", mask, MASKS)
        self.mask: Mask = mask
        self.has_read_step = False
        """Whether it has ever read an input that depends on the step, as by right of way."""
        self.tables: dict[Any, Any] = {}
        """What it became in the last worlds of few states, by team and world."""
        self.told: set[str] = set()
        """The reasons, of which a warning has told, why it did not."""
        self._at_once: bool | None = None

    def __repr__(self) -> str:
        return f"Function({self.name}: {self.form})"

    def __getstate__(self) -> dict[str, Any]:
        """Leave out tables, which other processes make themselves."""
        return {**vars(self), "tables": {}}

    @property
    def form(self) -> str:
        """What it is, in words."""
        if self.is_module:
            return "torch module"
        words = {"view": "views", "x": "inputs", "allowed": "a mask", "rng": "random numbers"}
        read = [words.get(name, name) for name in self.arguments]
        return f"function of {' and '.join([', '.join(read[:-1]), read[-1]] if read[1:] else read)}"

    @property
    def reads(self) -> str:
        """The array of a world that it is asked about: "views" or "inputs"."""
        return "inputs" if "x" in self.arguments else "views"

    @property
    def remembers(self) -> bool:
        """Whether it gets a memory."""
        return "memory" in self.arguments

    # In episodes:

    def actions(
        self,
        seen: NDArray[Any],
        n_actions: int,
        rngs: Sequence[np.random.Generator],
        memories: Sequence[dict[Any, Any]],
    ) -> NDArray[np.int64]:
        """Return the actions (n,) of n agents by what they see, their generators and memories.

        `seen` are views or inputs, as `reads` says. The function gets copies. PlayerError if it
        fails, or returns no actions.
        """
        answers = self._answers(seen, rngs, memories, n_actions)
        chosen = answers.argmax(axis=1)
        for i in np.flatnonzero(answers.max(axis=1) < 1).tolist():  # probabilities
            chosen[i] = rngs[i].choice(n_actions, p=answers[i])
        return np.asarray(chosen)

    def check(self, config: WorldConfig, team: Team) -> None:
        """Raise PlayerError if it fails at the start of an episode of a world."""
        world = World(config)
        world.reset(0)
        agents = (
            range(config.n_pursuers)
            if team == "pursuer"
            else range(config.n_pursuers, config.n_agents)
        )
        seen = world.inputs() if self.reads == "inputs" else world.views()
        rngs = [np.random.default_rng(0)] * len(agents)
        self.actions(seen[agents.start : agents.stop], config.n_actions, rngs, [{} for _ in agents])

    # Exactly:

    def probabilities(self, seen: NDArray[Any], n_actions: int) -> Floats:
        """Return the probabilities, float64 (n, n_actions), with which it chooses.

        Parameters
        ----------
        seen : ndarray
            Views, uint8 (n, 3, fov, fov), or inputs, float32 (n, n_actions, inputs).
        n_actions : int
            The number of moves.

        Raises
        ------
        NotExactError
            If it has a memory; if it uses random numbers other than ``integers``, ``choice``,
            ``permutation``, ``shuffle`` and comparisons of ``random()``, or too many of them; if it
            reads inputs that each episode draws; or if it answers differently when it is asked
            again, of some of the views, because it remembers or draws by itself.
        PlayerError
            If it fails, or returns no action.
        """
        if self.remembers:
            raise NotExactError(f"{self.name}: it has a memory, which is no part of what it sees")

        def ask(some: NDArray[Any]) -> Floats:
            if "rng" not in self.arguments:
                return self._answers(some, [None] * len(some), [{}] * len(some), n_actions)
            means = np.zeros((len(some), n_actions))
            for mean, one in zip(means, some, strict=True):
                for answer, _, share in self.followed(one, b"", n_actions):
                    mean += share * answer
            return means

        found = ask(seen)
        again = np.linspace(0, len(seen) - 1, min(len(seen), ASKED_AGAIN), dtype=np.intp)
        if not np.array_equal(ask(seen[again]), found[again]):
            raise NotExactError(
                f"{self.name}: it answers differently when it is asked again: it remembers, or "
                "draws other random numbers than those of rng"
            )
        return found

    def followed(
        self, seen: NDArray[Any], memory: bytes, n_actions: int
    ) -> list[tuple[Floats, bytes, float]]:
        """Return its answer to what one agent sees and remembers, after all results of its draws.

        With each answer (n_actions,) come what it remembers then and how likely this is. Memories
        are the pickled dicts, empty ones no bytes.
        """

        def ask(draws: FollowedDraws) -> tuple[Floats, bytes]:
            kept = pickle.loads(memory) if memory else {}  # noqa: S301, from the line below
            answer = self._asked(self._cropped(seen), draws, kept, n_actions)
            try:
                return answer, pickle.dumps(kept) if kept else b""
            except Exception as error:
                raise NotExactError(f"{self.name}: its memory cannot be copied: {error}") from error

        merged: dict[tuple[bytes, bytes], tuple[Floats, bytes, float]] = {}
        for (answer, kept), share in branches(ask):  # many results of draws may lead to one answer
            key = answer.tobytes(), kept
            before = merged[key][2] if key in merged else 0.0
            merged[key] = answer, kept, before + share
        return [*merged.values()]

    def sampled(self, seen: NDArray[Any], n_actions: int, rng: np.random.Generator) -> Floats:
        """Return answers (n, n_actions) of one draw for each view, where they cannot be exact."""
        return self._answers(seen, [rng] * len(seen), [{}] * len(seen), n_actions)

    # How it is asked:

    def _cropped(self, seen: NDArray[Any]) -> NDArray[Any]:
        if self.fov is None or self.reads == "inputs":
            return seen
        edge = (seen.shape[-1] - self.fov) // 2
        if edge < 0:
            raise ValueError(
                f"{self.name}: expected a world with fov {self.fov} or more, got {seen.shape[-1]}"
            )
        return seen[..., edge : edge + self.fov, edge : edge + self.fov]

    def _answers(
        self, seen: NDArray[Any], rngs: Sequence[Any], memories: Sequence[Any], n_actions: int
    ) -> Floats:
        """Return the answers (n, n_actions) of n agents."""
        seen = self._cropped(seen)
        if self.is_module:
            with self._blamed(None):
                outputs = _outputs(self.function, seen)
                return _checked(outputs, (len(seen),), n_actions, any_sum=True)
        if self.arguments == ("view",) and self._at_once is not False:
            given = self._given_many(seen, n_actions)
            if self._at_once:
                with self._blamed(None):
                    return _checked(given, (len(seen),), n_actions)
        each = zip(seen, rngs, memories, strict=True)
        return np.array([self._asked(*one, n_actions) for one in each]).reshape(-1, n_actions)

    def _given_many(self, views: NDArray[Any], n_actions: int) -> Any:
        """Return what it gives for n views at once. The first time tells whether it takes them."""
        try:
            with alarm(self.seconds):
                given = self.function(views.copy())
                array = np.asarray(given)
        except (Exception, SystemExit, TooSlowError) as error:
            if self._at_once is None and self._takes_one(views[0], error):
                self._at_once = False
                return None
            raise self._error(error, None) from error
        if self._at_once is None:
            shapes = {"f": (len(views), n_actions)}
            self._at_once = array.shape == shapes.get(array.dtype.kind, (len(views),))
        return given

    def _takes_one(self, view: NDArray[Any], first: BaseException) -> bool:
        """Return whether it takes one view, after it has failed with several.

        A function that fails with one view, too, is told by that error, unless the name of its
        parameter is a plural.
        """
        try:
            with alarm(self.seconds):
                self.function(view.copy())
        except (Exception, SystemExit, TooSlowError) as error:
            if not next(iter(self._parameters)).endswith("s"):
                raise self._error(error, view) from error
            return False
        return True

    def _asked(self, seen: NDArray[Any], rng: Any, memory: Any, n_actions: int) -> Floats:
        """Return the answer (n_actions,) of one agent."""
        values = {"view": seen.copy(), "rng": rng, "memory": memory}
        if self.reads == "inputs":
            x = _Inputs(seen, exact=not isinstance(rng, np.random.Generator))
            values |= {"x": x, "allowed": allowed_moves(seen, self.mask)}
        with self._blamed(seen):
            by_name = {name: values[meant] for name, meant in self._parameters.items() if name}
            by_place = [values["view"]] if "" in self._parameters else []
            given = self.function(*by_place, **by_name)
            answer = _checked(given, (), n_actions)
        if self.reads == "inputs":
            self.has_read_step |= x.has_read_step or self.mask == "right-of-way"
        return answer

    @contextmanager
    def _blamed(self, seen: NDArray[Any] | None) -> Iterator[None]:
        """Raise what goes wrong in the function as a PlayerError that says where, and for what."""
        try:
            with alarm(self.seconds):
                yield
        except NotExactError as error:
            raise NotExactError(f"{self.name}: {error}") from error
        except (Exception, SystemExit, TooSlowError) as error:
            raise self._error(error, seen) from error

    def _error(self, error: BaseException, seen: NDArray[Any] | None) -> PlayerError:
        what = f"{type(error).__name__}: {error}"
        if isinstance(error, _AnswerError):
            what = str(error)
        elif isinstance(error, TooSlowError):
            what = f"expected an answer within {self.seconds:g} s, got none"
        code = getattr(self.function, "__code__", None)
        where = ""
        if code is not None:
            frames = traceback.extract_tb(error.__traceback__)
            lines = [each.lineno for each in frames if each.filename == code.co_filename]
            file, line = Path(code.co_filename).name, (lines or [code.co_firstlineno])[-1]
            where = f", line {line}" if file == self.name else f" ({file}, line {line})"
        asked = "" if seen is None or self.reads == "inputs" else f", for the view\n{picture(seen)}"
        return PlayerError(f"{self.name}{where}: {what}{asked}")


class _AnswerError(ValueError):
    """An answer is none. Its message needs no name of its class."""


class _Inputs(dict[str, NDArray[np.float32]]):
    """Named inputs of the moves of one agent. It notes whether those are read that steps decide."""

    def __init__(self, inputs: NDArray[np.float32], *, exact: bool) -> None:
        columns = dict(zip(INPUTS, inputs.T.copy(), strict=True))
        self._exact = exact
        self._noted = {name: columns.pop(name) for name in (_BY_STEP, *_DRAWN)}
        self.has_read_step = False
        super().__init__(columns)

    def get(self, name: str, default: Any = None) -> Any:
        """Return an input, as ``x[name]`` does."""
        return self[name] if name in INPUTS else default

    def __missing__(self, name: str) -> NDArray[np.float32]:
        if name not in self._noted:
            raise KeyError(f"expected one of {', '.join(INPUTS)}, got {name!r}")
        if self._exact and name in _DRAWN:
            raise NotExactError(f"x[{name!r}]: each episode draws it")
        self.has_read_step |= name == _BY_STEP
        noted: NDArray[np.float32] = self._noted[name]
        return noted


def _is_module(function: Any) -> bool:
    torch = sys.modules.get("torch")
    return torch is not None and isinstance(function, torch.nn.Module)


def _outputs(module: Any, views: NDArray[np.uint8]) -> NDArray[Any]:
    """Return the outputs of a module of torch."""
    import torch

    with torch.no_grad():
        outputs = module(torch.from_numpy(views.astype(np.float32)))
    found: NDArray[Any] = outputs.cpu().numpy()
    return found


def _arguments_of(function: Callable[..., Any], name: str) -> dict[str, str]:
    """Return what each parameter of a function gets; TypeError for others.

    A parameter without a name, "", gets the view by its place.
    """
    try:
        signature = inspect.signature(function)
    except (TypeError, ValueError):  # some functions of C have none
        return {"": "view"}
    parameters = signature.parameters.values()
    named = [each.name for each in parameters if each.name in ("rng", "memory")]
    needed = [
        each
        for each in parameters
        if each.default is each.empty and each.name not in named and each.kind < each.KEYWORD_ONLY
    ]
    names = [each.name for each in needed if each.kind is not each.VAR_POSITIONAL]
    kinds = ["x", "allowed", "rng"] if names[:2] == ["x", "allowed"] else ["view", "rng", "memory"]
    free = [kind for kind in kinds if kind not in named]
    others = any(
        each.kind is each.KEYWORD_ONLY and each.default is each.empty and each.name not in named
        for each in parameters
    )
    by_place = (inspect.Parameter.VAR_POSITIONAL, inspect.Parameter.POSITIONAL_ONLY)
    if len(needed) == 1 and needed[0].kind in by_place and not named and not others:
        return {"": "view"}
    by_name = all(each.kind is each.POSITIONAL_OR_KEYWORD for each in needed)
    if not 0 < len(names) <= len(free) or others or not by_name:
        raise TypeError(
            f"{name}: expected f(views), f(view), f(view, rng), f(view, rng, memory) or "
            f"f(x, allowed, rng), got {name}{signature}"
        )
    return dict(zip(names, free, strict=False)) | {each: each for each in named}


def _checked(given: Any, leading: tuple[int, ...], n_actions: int, any_sum: bool = False) -> Floats:
    """Return answers (*leading, n_actions), of actions as 0 and 1; _AnswerError for others.

    With `any_sum` numbers are no probabilities, and the largest is taken.
    """
    array = checks.unmasked("answer", given)
    kind, expected = array.dtype.kind, f"expected an action, an integer from 0 to {n_actions - 1}"
    if leading:
        expected = f"expected actions, integers from 0 to {n_actions - 1} of shape {leading}"
    if kind in "iu" and array.shape == leading:
        wrong = array[(array < 0) | (array >= n_actions)]
        if wrong.size:
            raise _AnswerError(f"{expected}, got {wrong.flat[0]}")
        return np.asarray(np.eye(n_actions)[array])
    if kind != "f" or array.shape != (*leading, n_actions):
        got = checks.shown(given) if kind not in "iufb" else f"{array.dtype} of shape {array.shape}"
        if array.ndim == 0:
            got = checks.shown(given)
        probabilities = f"probabilities, floats of shape {(*leading, n_actions)}"
        if any_sum:
            probabilities = f"outputs of shape {(*leading, n_actions)}"
        raise _AnswerError(f"{expected}, or {probabilities}, got {got}")
    if any_sum:
        return np.asarray(np.eye(n_actions)[array.argmax(axis=-1)])
    found = array.astype(np.float64)
    sums = found.sum(axis=-1)
    if not ((found >= 0).all() and (np.abs(sums - 1) <= _ROUNDING).all()):
        row = found.reshape(-1, n_actions)[~(np.abs(sums.ravel() - 1) <= _ROUNDING)]
        shown = (row if len(row) else found[(found < 0).any(axis=-1)].reshape(-1, n_actions))[0]
        text = ", ".join(f"{number:.4g}" for number in shown)
        raise _AnswerError(
            f"expected probabilities of at least 0 that sum to 1, got {text}, sum {shown.sum():.4g}"
        )
    return np.asarray(found / sums[..., np.newaxis])


def picture(view: NDArray[np.uint8]) -> str:
    """Return a view as lines of text: the agent @ in the middle, P, E, # and . for the others."""
    middle = view.shape[-1] // 2
    signs = np.full(view.shape[1:], ".")
    signs[view[CHANNEL["obstacle"]] != 0] = "#"
    signs[view[CHANNEL["pursuer"]] != 0] = "P"
    signs[view[CHANNEL["evader"]] != 0] = "E"
    signs[middle, middle] = "@"
    # What lies beyond the border is left out, but for one line of it.
    open_cells = np.argwhere(signs != "#")
    first = np.maximum(open_cells.min(axis=0) - 1, 0)
    last = open_cells.max(axis=0) + 2
    return "\n".join(" ".join(row) for row in signs[first[0] : last[0], first[1] : last[1]])


class Seats:
    """A function that plays in W worlds: its random numbers and memories in each of them."""

    def __init__(self, function: Function, n_actions: int, team: int, n_worlds: int = 1) -> None:
        self.function = function
        self.reads = function.reads
        self._n_actions = n_actions
        self._team = team
        self._keys: list[tuple[int, int]] = [(0, 0)] * n_worlds
        self._rngs: list[np.random.Generator | None] = [None] * n_worlds
        self._memories: list[dict[int, dict[Any, Any]]] = [{} for _ in range(n_worlds)]

    def begin(self, world: int, seed: int, episode: int) -> None:
        """Begin an episode of a world: its random numbers are of its seed and number."""
        self._keys[world] = seed, episode
        self._rngs[world] = None
        self._memories[world] = {}

    def __call__(self, asked: NDArray[np.bool_], seen: NDArray[Any]) -> NDArray[np.int64]:
        """Return the actions (n,) of the n agents of a mask (W, A), by what they see."""
        places = np.argwhere(asked).tolist()
        rngs = [self._rng(world) for world, _ in places]
        memories = [self._memories[world].setdefault(agent, {}) for world, agent in places]
        return self.function.actions(seen, self._n_actions, rngs, memories)

    def _rng(self, world: int) -> np.random.Generator:
        rng = self._rngs[world]
        if rng is None:
            rng = self._rngs[world] = np.random.default_rng([*self._keys[world], self._team])
        return rng
