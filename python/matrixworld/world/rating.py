"""Policies that rate moves by named inputs: small networks, and programs."""

from __future__ import annotations

import ast
import operator
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise
from types import MappingProxyType
from typing import Any, ClassVar, TypeAlias

import numpy as np
from numpy.typing import ArrayLike, NDArray

from matrixworld import _core
from matrixworld._util import checks
from matrixworld.world.masks import LEAST_FOV, MASKS, Mask
from matrixworld.world.policy import Layers, Network, Policy, layers_of

_Floats: TypeAlias = NDArray[np.float32]


def _texts() -> Iterator[tuple[str, str]]:
    for name, definition, unit, most in _core.inputs():
        limits = f"0 to {most:g}" if most else "0 or more"
        yield name, f"{definition} ({limits}{', in ' * bool(unit)}{unit})"


INPUTS: Mapping[str, str] = MappingProxyType(dict(_texts()))
"""The named inputs of a move, and what they are.

All are of the cell that the move leads to, for the same agents: those in view. Distances are least
numbers of moves, as if there were no obstacles, in units of half a view, ``fov / 2``; 2 where there
is nothing in view. A cell that holds several agents of a team counts once, and a cell out of view
as free. Both teams have the same inputs. Only three depend on the step: ``must_yield``, as right of
way has another order in each; ``ahead``, as an agent draws a direction for each 12 steps; and
``search``, which follows a plan. Only this one also depends on what is not in view: the size of the
grid and of the team, whether there are obstacles, and the number of the agent.
"""

# With the plan, episodes in O take more than twice as long.
_PRESENT = tuple(name for name in INPUTS if name != "search")

_LOWEST = np.finfo(np.float32).min
_MAX_LENGTH = 2**16


class _Rates(Policy):
    """What rates moves: the same function of the inputs for each move of an agent."""

    inputs: tuple[str, ...]
    hidden: tuple[int, ...] = ()
    length: int = 0
    mask: Mask

    def __post_init__(self) -> None:
        given = checks.check_sequence("inputs", self.inputs, "names of inputs")
        for name in given:
            checks.check_choice("inputs", name, INPUTS)
        different = 0 < len(set(given)) == len(given)
        checks.expect(different, "inputs", "different ones", checks.shown(given))
        object.__setattr__(self, "inputs", given)
        checks.check_choice("mask", self.mask, MASKS)
        self._check_world()
        if self.fov < LEAST_FOV[self.mask]:
            least = f"at least {LEAST_FOV[self.mask]} for the mask {self.mask}"
            raise ValueError(f"fov: expected {least}, got {self.fov}")

    @cached_property
    def core(self) -> _core.Rating:
        """The engine's form of this policy."""
        return _core.Rating(
            fov=self.fov,
            n_actions=self.n_actions,
            inputs=[list(INPUTS).index(name) for name in self.inputs],
            hidden=list(self.hidden),
            length=self.length,
            mask=self.mask,
        )

    def checked(self, inputs: ArrayLike) -> _Floats:
        """Return inputs (..., n_actions, all inputs), or raise a ValueError or TypeError."""
        array, shape = checks.unmasked("inputs", inputs), (self.n_actions, len(INPUTS))
        if array.dtype != np.float32 or array.shape[-2:] != shape:
            expected = f"float32 of shape (..., {str(shape)[1:]}"
            raise ValueError(f"inputs: expected {expected}, got {array.dtype} {array.shape}")
        checks.check_finite("inputs", array)
        return array

    def _columns(self, inputs: ArrayLike) -> dict[str, _Floats]:
        """Return arrays (..., n_actions) of the inputs of this policy by their names."""
        array = self.checked(inputs)
        return {name: array[..., list(INPUTS).index(name)] for name in self.inputs}


_CHOICE = '''

def choose(x, allowed, rng):
    """Return the best of the allowed moves; of equal ones any, all equally likely."""
    ratings = np.where(allowed, rate(x), -np.inf)
    return rng.choice(np.flatnonzero(ratings == ratings.max()))
'''


@dataclass(frozen=True)
class Rating(_Rates):
    """A policy that rates each move of an agent by a small network of named inputs.

    The same network rates all moves, so what is learned for one direction holds for all. The agent
    takes the best move that the mask allows; of equal ones any, all equally likely. It describes
    the shape only; a genome holds the weights.

    Parameters
    ----------
    inputs : sequence of str, optional
        Names of `INPUTS`, in the order of the genome. The default is all but ``search``.
    hidden : sequence of int, optional
        Sizes of the hidden layers, with the activation relu. By default there is none: the rating
        is a weighted sum, and a genome has one weight for each input.
    mask : {"none", "obstacles", "right-of-way"}, optional
        Moves that are never taken: none, those into an obstacle or the border, or those that right
        of way forbids in this step.
    fov : int, optional
        Side of the view, odd; at least 3 for the mask obstacles, 5 for right-of-way.
    n_actions : int, optional
        Moves: 5, or 9 with diagonal ones.

    Notes
    -----
    A genome is a flat array of float32. It holds, for each hidden layer, the weights as an (inputs,
    outputs) matrix in row-major order and then the biases; at the end the weights of the last sum,
    which has no bias, as it would change no choice. Sums are added in this order, in float32. What
    is no number counts as the lowest rating.

    Examples
    --------
    >>> import numpy as np
    >>> from matrixworld import Matches, Population, Rating, rollout
    >>> chaser = Rating(inputs=("adversary",))
    >>> team = Population(np.float32([-1]), chaser)
    >>> played = rollout("O", team, "random", Matches.of(0, 0, range(50)))
    >>> print(f"{played.capture_rate.mean():.2f}")
    0.99
    """

    kind: ClassVar[str] = "rating"

    inputs: tuple[str, ...] = _PRESENT
    hidden: tuple[int, ...] = ()
    mask: Mask = "obstacles"
    fov: int = 11
    n_actions: int = 5

    def __post_init__(self) -> None:
        super().__post_init__()
        object.__setattr__(self, "hidden", checks.check_sizes("hidden", self.hidden, 2**20))

    @property
    def sizes(self) -> tuple[int, ...]:
        """Sizes of all layers: inputs, hidden layers, the rating."""
        return (len(self.inputs), *self.hidden, 1)

    @property
    def genome_size(self) -> int:
        """Number of weights and biases in a genome."""
        return sum((n_in + 1) * n_out for n_in, n_out in pairwise(self.sizes)) - 1

    def layers(self, genome: _Floats) -> Layers:
        """Return weights (inputs, outputs) and biases (outputs,) of each layer, views of a genome.

        The last layer has the outputs 1 and no bias. Changing an array changes the genome.
        """
        checks.check_shape("genome", genome, self.genome_size)
        return layers_of(genome, pairwise(self.sizes))

    def without(self, genome: _Floats, name: str) -> _Floats:
        """Return a genome that does not read an input: all weights that it enters by are 0."""
        checks.check_choice("name", name, self.inputs)
        changed: _Floats = genome.copy()
        self.layers(changed)[0][0][self.inputs.index(name)] = 0
        return changed

    def initial(self, rng: np.random.Generator, weight: float = 0.5) -> _Floats:
        """Return a random genome, float32 (genome_size,): weights from N(0, weight²), biases 0."""
        checks.check_instance("rng", rng, np.random.Generator)
        weight = checks.check_number("weight", weight, least=0.0)
        genome = np.zeros(self.genome_size, np.float32)
        for weights, _ in self.layers(genome):
            weights[:] = weight * rng.standard_normal(weights.shape, dtype=np.float32)
        return genome

    def rate(self, genome: _Floats, inputs: ArrayLike) -> _Floats:
        """Return ratings, float32 (..., n_actions), of finite inputs (..., n_actions, all inputs).

        They are computed in NumPy. The numbers are those of the engine, bit by bit.
        """
        x = list(self._columns(inputs).values())
        *hidden, (last, _) = self.layers(genome)
        with np.errstate(over="ignore", invalid="ignore"):
            for weights, biases in hidden:
                x = [
                    np.fmax(_sum(x, column, bias), np.float32(0))
                    for column, bias in zip(weights.T, biases, strict=True)
                ]
            return np.asarray(np.fmax(_sum(x, last[:, 0], np.float32(0)), _LOWEST))

    def to_python(self, genome: _Floats) -> str:
        """Return a genome as lines of Python that play the same, with weights that are not 0.

        They define ``rate(x)``, where ``x[name]`` is the input of all moves of an agent, float32
        (moves,), and ``choose(x, allowed, rng)``, which returns a move.
        """
        terms = [f'x["{name}"]' for name in self.inputs]
        lines = ["import numpy as np", "", "", "def rate(x):"]
        lines.append('    """Return the rating of each move by its inputs."""')
        *hidden, (last, _) = self.layers(genome)
        for number, (weights, biases) in enumerate(hidden, start=1):
            for unit, (column, bias) in enumerate(zip(weights.T, biases, strict=True)):
                total = _sum_text(column, terms, str(bias))
                lines.append(f"    h{number}_{unit} = np.maximum({total}, 0)")
            terms = [f"h{number}_{unit}" for unit in range(len(biases))]
        lines.append(f"    return {_sum_text(last[:, 0], terms)}")
        return "\n".join(lines) + "\n" + _CHOICE


def _sum(x: list[_Floats], weights: _Floats, start: np.float32) -> _Floats:
    total = np.full_like(x[0], start)
    for each, weight in zip(x, weights, strict=True):
        total = total + weight * each
    return total


def _sum_text(weights: _Floats, terms: list[str], start: str = "") -> str:
    used = [
        f"{weight!s} * {term}" for weight, term in zip(weights, terms, strict=True) if weight != 0
    ]
    parts = [start] * bool(start) + used
    return " + ".join(parts or [f"0 * {terms[0]}"]).replace("+ -", "- ")


# ---- Programs -----------------------------------------------------------------------------------

OPERATIONS: dict[str, int] = {
    name: n for name, n in _core.operations() if name not in ("end", "input", "constant")
}
"""Operations of programs, and how many arguments each takes."""

_NUMBERS = {name: number for number, (name, _) in enumerate(_core.operations())}
_SIGNS: dict[type[ast.operator], str] = {
    ast.Add: "add", ast.Sub: "subtract", ast.Mult: "multiply",
}  # fmt: skip


_MEANINGS: dict[str, tuple[Any, ...]] = {
    "add": (operator.add, "({}) + ({})"),
    "subtract": (operator.sub, "({}) - ({})"),
    "multiply": (operator.mul, "({}) * ({})"),
    "min": (lambda a, b: np.where(a < b, a, b), "min({}, {})", "np.minimum({}, {})"),
    "max": (lambda a, b: np.where(a < b, b, a), "max({}, {})", "np.maximum({}, {})"),
    "negate": (operator.neg, "-({})"),
    "less": (lambda a, b: (a < b).astype(np.float32), "({}) < ({})"),
    "where": (
        lambda a, b, c: np.where(a > 0, b, c),
        "({1}) if {0} else ({2})",
        "np.where({}, {}, {})",
    ),
}
"""What each operation does, its text in Python and, where that differs, its text for arrays."""

Token: TypeAlias = str | float
"""A name of `INPUTS` or `OPERATIONS`, or a constant."""


@dataclass(frozen=True)
class Program(_Rates):
    """A policy that rates each move of an agent by a program of named inputs.

    The same program rates all moves. The agent takes the best move that the mask allows; of equal
    ones any, all equally likely. A genome is the code.

    Parameters
    ----------
    inputs, mask, fov, n_actions
        As in `Rating`.
    length : int, optional
        The most instructions of a program.

    Notes
    -----
    A program is a sequence of tokens for a stack of at most 32 numbers: a name of an input or a
    constant puts a number on it, an operation of `OPERATIONS` replaces its arguments by a result.
    One number is left, the rating. All is float32. ``less(a, b)`` is 1 if a < b, else 0;
    ``where(a, b, c)`` is b if a > 0, else c.

    A genome, float32, has two numbers for each instruction: the operation (1 an input, 2 a
    constant, from 3 on those of `OPERATIONS`), and the place of the input in `inputs`, the
    constant, or 0. Behind the last instruction there are zeros.

    Examples
    --------
    >>> from matrixworld import Matches, Population, Program, rollout
    >>> program = Program(inputs=("adversary", "room"))
    >>> genome = program.genome("room - 2 * adversary")
    >>> program.tokens(genome)
    ['room', 2.0, 'adversary', 'multiply', 'subtract']
    >>> print(program.expression(genome))
    room - 2.0 * adversary
    """

    kind: ClassVar[str] = "program"

    inputs: tuple[str, ...] = _PRESENT
    length: int = 40
    mask: Mask = "obstacles"
    fov: int = 11
    n_actions: int = 5

    def __post_init__(self) -> None:
        super().__post_init__()
        length = checks.check_integer("length", self.length, 1, _MAX_LENGTH)
        object.__setattr__(self, "length", length)

    @property
    def genome_size(self) -> int:
        """Numbers in a genome."""
        return 2 * self.length

    def check_genomes(self, genomes: _Floats) -> None:
        """Raise ValueError unless all genomes (n, genome_size) are programs."""
        self.core.check(genomes)

    def encode(self, tokens: list[Token]) -> _Floats:
        """Return the genome of a sequence of tokens; ValueError if they are no program."""
        checks.expect(len(tokens) <= self.length, "tokens", f"at most {self.length}", len(tokens))
        genome = np.zeros((self.length, 2), np.float32)
        for row, token in zip(genome, tokens, strict=False):
            if isinstance(token, str):
                checks.check_choice("token", token, (*self.inputs, *OPERATIONS))
                named = token in self.inputs
                row[0] = _NUMBERS["input" if named else token]
                row[1] = self.inputs.index(token) if named else 0
            else:
                row[:] = _NUMBERS["constant"], checks.check_real("token", token)
        self.check_genomes(genome.reshape(1, -1))
        return genome.ravel()

    def tokens(self, genome: _Floats) -> list[Token]:
        """Return the tokens of a genome."""
        checks.check_shape("genome", genome, self.genome_size)
        self.check_genomes(genome[None])
        names = list(_NUMBERS)
        found: list[Token] = []
        for number, operand in genome.reshape(-1, 2):
            name = names[int(number)]
            if name == "end":
                break
            constant = name == "constant"
            found.append(
                float(str(operand)) if constant
                else self.inputs[int(operand)] if name == "input" else name
            )  # fmt: skip
        return found

    def genome(self, expression: str) -> _Floats:
        """Return the genome of an expression in the syntax of Python.

        It has names of inputs, numbers, ``+``, ``-``, ``*``, ``a < b``, ``b if a > 0 else c``,
        ``b if a < d else c`` and calls of `OPERATIONS`, such as ``min(a, b)``. So a tree of DEAP
        with these names is one, as text.
        """
        try:
            tree = ast.parse(expression, mode="eval").body
        except SyntaxError as error:
            raise ValueError(f"expression: expected one of Python, got {expression!r}") from error
        return self.encode(list(_tokens_of(tree)))

    def initial(self, rng: np.random.Generator, depth: int = 3) -> _Floats:
        """Return the genome of a random program, a tree of at most this depth."""
        checks.check_instance("rng", rng, np.random.Generator)

        def grow(left: int) -> list[Token]:
            if left == 0 or rng.random() < 0.3:
                place = int(rng.integers(len(self.inputs) + 1))
                constant = float(np.round(rng.normal(), 2))
                return [constant if place == len(self.inputs) else self.inputs[place]]
            name = list(OPERATIONS)[rng.integers(len(OPERATIONS))]
            parts = [grow(left - 1) for _ in range(OPERATIONS[name])]
            return [*(token for part in parts for token in part), name]

        tokens: list[Token] = grow(checks.check_integer("depth", depth, 0, 20))
        while len(tokens) > self.length:
            tokens = grow(depth)
        return self.encode(tokens)

    def simplified(self, genome: _Floats) -> _Floats:
        """Return the genome of a shorter program with the same ratings, in float32.

        Operations on numbers become numbers; twice negated, least and greatest of the same, and
        choices that are known vanish; so do 0 in sums and 1 in products.
        """
        shortest: list[Token] = self._folded(genome, lambda token: [token], _shorter)
        return self.encode(shortest)

    def shorter(self, genome: _Floats) -> list[_Floats]:
        """Return the programs in which one operation is replaced by one of its arguments.

        All are simplified and different, the shortest ones first.
        """
        tokens, found = self.tokens(genome), dict[bytes, _Floats]()
        starts: list[int] = []  # where the arguments on the stack begin
        for place, token in enumerate(tokens):
            first = len(starts) - OPERATIONS.get(str(token), 0)
            parts = zip(starts[first:], [*starts[first + 1 :], place], strict=True)
            start = starts[first] if first < len(starts) else place
            for begin, end in parts if first < len(starts) else ():
                code = [*tokens[:start], *tokens[begin:end], *tokens[place + 1 :]]
                each = self.simplified(self.encode(code))
                found[each.tobytes()] = each
            starts[first:] = [start]
        return sorted(found.values(), key=lambda code: len(self.tokens(code)))

    def rate(self, genome: _Floats, inputs: ArrayLike) -> _Floats:
        """Return ratings, as `Rating.rate` does."""
        named: dict[Any, _Floats] = {**self._columns(inputs)}
        room = np.shape(inputs)[:-1]
        with np.errstate(over="ignore", invalid="ignore"):
            ratings = self._folded(
                genome,
                lambda token: named[token] if token in named else np.full(room, token, np.float32),
                lambda name, parts: _MEANINGS[name][0](*parts),
            )
            return np.asarray(np.fmax(ratings, _LOWEST))

    def expression(self, genome: _Floats) -> str:
        """Return a genome as an expression, of which `genome` makes the same program."""
        return self._text(genome, "{}", "{}", "{}")

    def to_python(self, genome: _Floats) -> str:
        """Return a genome as lines of Python that play the same: see `Rating.to_python`."""
        text = self._text(genome, "x['{}']", "f({})", "f({})", of_arrays=True)
        head = "import numpy as np\n\nf = np.float32\n\n\ndef rate(x):\n"
        told = '    """Return the rating of each move by its inputs."""\n'
        return f"{head}{told}    return {text}\n{_CHOICE}"

    def _text(
        self, genome: _Floats, name: str, constant: str, truth: str, *, of_arrays: bool = False
    ) -> str:
        """Return an expression by the forms of inputs, constants and comparisons."""

        def leaf(token: Token) -> tuple[str, bool]:  # text; whether it is a comparison
            return (constant if isinstance(token, float) else name).format(token), False

        def joined(operation: str, parts: list[tuple[str, bool]]) -> tuple[str, bool]:
            texts = [truth.format(text) if less else text for text, less in parts]
            if operation == "where":
                text, less = parts[0]
                texts[0] = text if less else f"({text}) > 0"
            _, *forms = _MEANINGS[operation]
            return forms[-1 if of_arrays else 0].format(*texts), operation == "less"

        text, less = self._folded(genome, leaf, joined)
        whole = ast.parse(truth.format(text) if less else text, mode="eval")
        return ast.unparse(whole)  # without the parentheses that are not needed

    def _folded(
        self, genome: _Floats, leaf: Callable[[Token], Any], joined: Callable[[str, list[Any]], Any]
    ) -> Any:
        """Return what a program leaves on a stack of leaves, and of parts that operations join."""
        stack: list[Any] = []
        for token in self.tokens(genome):
            if token in OPERATIONS:
                first = len(stack) - OPERATIONS[token]
                stack[first:] = [joined(token, stack[first:])]
            else:
                stack.append(leaf(token))
        return stack[0]


def _shorter(name: str, parts: list[list[Token]]) -> list[Token]:
    """Return the tokens of an operation on these parts, which are simplified, or shorter ones."""
    alone = [part[0] if len(part) == 1 else None for part in parts]
    numbers = [each if isinstance(each, float) else None for each in alone]
    if None not in numbers:
        with np.errstate(over="ignore", invalid="ignore"):
            value = float(_MEANINGS[name][0](*map(np.float32, numbers)))
        if np.isfinite(value):
            return [value]
    first, *others = parts
    match name, others:
        case "negate", [] if first[-1] == "negate":
            return first[:-1]
        case (("min" | "max"), [other]) if first == other:
            return first
        case (("add" | "subtract"), [[0.0]]):
            return first
        case "multiply", [[1.0]]:
            return first
        case "add", [other] if first == [0.0]:
            return other
        case "multiply", [other] if first == [1.0]:
            return other
        case "where", [yes, no] if yes == no or numbers[0] is not None:
            return yes if yes == no or numbers[0] > 0 else no  # type: ignore[operator]
    return [*(token for part in parts for token in part), name]


def _tokens_of(node: ast.expr) -> Iterator[Token]:
    match node:
        case ast.Constant(value=int() | float() as value):
            yield float(value)
        case ast.Name(id=name):
            yield name
        case ast.UnaryOp(op=ast.USub(), operand=ast.Constant(value=int() | float() as value)):
            yield -float(value)
        case ast.UnaryOp(op=ast.USub(), operand=operand):
            yield from (*_tokens_of(operand), "negate")
        case ast.BinOp(left=left, op=ast.Add() | ast.Sub() | ast.Mult() as sign, right=right):
            yield from (*_tokens_of(left), *_tokens_of(right), _SIGNS[type(sign)])
        case ast.Compare(left=left, ops=[ast.Lt()], comparators=[right]):
            yield from (*_tokens_of(left), *_tokens_of(right), "less")
        case ast.IfExp(
            test=ast.Compare(left=test, ops=[ast.Gt()], comparators=[ast.Constant(value=0)])
            | (ast.Compare(ops=[ast.Lt()]) as test),
            body=body, orelse=other,
        ):  # fmt: skip
            yield from (*_tokens_of(test), *_tokens_of(body), *_tokens_of(other), "where")
        case ast.Call(func=ast.Name(id=name), args=parts, keywords=[]):
            yield from (*(token for part in parts for token in _tokens_of(part)), name)
        case _:
            expected = "inputs, numbers, +, -, *, <, `b if a > 0 else c` and operations"
            raise ValueError(f"expression: expected {expected}, got {ast.unparse(node)!r}")


def policy_of(plain: Mapping[str, Any]) -> Policy:
    """Return the policy whose `to_json` is given; ValueError or TypeError for other values."""
    kinds: dict[str, type[Policy]] = {each.kind: each for each in (Network, Rating, Program)}
    values = {name: tuple(v) if isinstance(v, list) else v for name, v in plain.items()}
    kind: Any = values.pop("kind", Network.kind)
    checks.check_choice("kind", kind, kinds)
    return kinds[kind](**values)
