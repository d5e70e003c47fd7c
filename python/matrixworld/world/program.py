"""Policies that rate moves by programs of named inputs.

A program is stored as code for a stack: a sequence of tokens, which a genome holds. Here it is
parsed into a tree, and all that is told of a program is a fold over its nodes.
"""

from __future__ import annotations

import ast
import operator
from collections import deque
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any, ClassVar, NamedTuple, TypeAlias, TypeVar

import numpy as np
from numpy.typing import ArrayLike

from matrixworld import _core
from matrixworld._util import checks
from matrixworld.world.masks import Mask
from matrixworld.world.rating import CHOICE, LOWEST, PRESENT, Floats, RatesMoves

OPERATIONS: dict[str, int] = {
    name: n for name, n in _core.operations() if name not in ("end", "input", "constant")
}
"""Operations of programs, and how many arguments each takes."""

_NUMBERS = {name: number for number, (name, _) in enumerate(_core.operations())}
_MAX_LENGTH = 2**16


class _Meaning(NamedTuple):
    """What an operation does, and its text for numbers and, where that differs, for arrays."""

    compute: Callable[..., Any]
    text: str
    of_arrays: str = ""


_MEANINGS: Mapping[str, _Meaning] = {
    "add": _Meaning(operator.add, "({}) + ({})"),
    "subtract": _Meaning(operator.sub, "({}) - ({})"),
    "multiply": _Meaning(operator.mul, "({}) * ({})"),
    "min": _Meaning(lambda a, b: np.where(a < b, a, b), "min({}, {})", "np.minimum({}, {})"),
    "max": _Meaning(lambda a, b: np.where(a < b, b, a), "max({}, {})", "np.maximum({}, {})"),
    "negate": _Meaning(operator.neg, "-({})"),
    "less": _Meaning(lambda a, b: (a < b).astype(np.float32), "({}) < ({})"),
    "where": _Meaning(
        lambda a, b, c: np.where(a > 0, b, c), "({1}) if {0} else ({2})", "np.where({}, {}, {})"
    ),
}

Token: TypeAlias = str | float
"""A name of `INPUTS` or `OPERATIONS`, or a constant."""


# ---- Trees --------------------------------------------------------------------------------------


@dataclass(frozen=True, eq=False)
class Input:
    """An input of a move, by name."""

    name: str


@dataclass(frozen=True, eq=False)
class Constant:
    """A number."""

    value: float


@dataclass(frozen=True, eq=False)
class Call:
    """An operation on the values of other nodes."""

    operation: str
    arguments: tuple[Node, ...]

    def with_argument(self, place: int, argument: Node) -> Call:
        """Return the call with one argument replaced."""
        before, after = self.arguments[:place], self.arguments[place + 1 :]
        return Call(self.operation, (*before, argument, *after))


Node: TypeAlias = Input | Constant | Call
Folded = TypeVar("Folded")
Terms: TypeAlias = dict[str, float]
"""Weights of inputs by their names, and a number that is added, by the name ""."""


def _nodes(tree: Node) -> list[Node]:
    """Return all nodes of a tree, arguments before their operation, as code for a stack has them.

    Nothing here is recursive, since a sum of a thousand terms is a thousand nodes deep.
    """
    backwards: list[Node] = []
    left = [tree]
    while left:
        node = left.pop()
        backwards.append(node)
        if isinstance(node, Call):
            left.extend(node.arguments)
    return backwards[::-1]


def fold(
    tree: Node,
    of_leaf: Callable[[Input | Constant], Folded],
    of_call: Callable[[Call, list[Folded]], Folded],
) -> Folded:
    """Return what `of_call` makes of a tree, from the results for the arguments of each call."""
    results: list[Folded] = []
    for node in _nodes(tree):
        if isinstance(node, Call):
            first = len(results) - len(node.arguments)
            results[first:] = [of_call(node, results[first:])]
        else:
            results.append(of_leaf(node))
    return results[0]


def _tree_of(tokens: list[Token]) -> Node:
    """Return the tree of a program's tokens."""
    stack: list[Node] = []
    for token in tokens:
        if isinstance(token, float):
            stack.append(Constant(token))
        elif token in OPERATIONS:
            first = len(stack) - OPERATIONS[token]
            stack[first:] = [Call(token, tuple(stack[first:]))]
        else:
            stack.append(Input(token))
    return stack[0]


def _tokens_of(tree: Node) -> list[Token]:
    """Return the tokens of a tree."""
    return [_token_of(node) for node in _nodes(tree)]


def _token_of(node: Node) -> Token:
    match node:
        case Input(name):
            return name
        case Constant(value):
            return value
        case Call(operation):
            return operation


# ---- Programs -----------------------------------------------------------------------------------


@dataclass(frozen=True)
class Program(RatesMoves):
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

    inputs: tuple[str, ...] = PRESENT
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

    def check_genomes(self, genomes: Floats) -> None:
        """Raise ValueError unless all genomes (n, genome_size) are programs."""
        self.core.check(genomes)

    def encode(self, tokens: list[Token]) -> Floats:
        """Return the genome of a sequence of tokens; ValueError if they are no program."""
        if len(tokens) > self.length:
            raise ValueError(f"tokens: expected at most {self.length}, got {len(tokens)}")
        genome = np.zeros((self.length, 2), np.float32)
        for row, token in zip(genome, tokens, strict=False):
            if not isinstance(token, str):
                row[:] = _NUMBERS["constant"], checks.check_real("token", token)
                continue
            checks.check_choice("token", token, (*self.inputs, *OPERATIONS))
            if token in self.inputs:
                row[:] = _NUMBERS["input"], self.inputs.index(token)
            else:
                row[:] = _NUMBERS[token], 0
        self.check_genomes(genome.reshape(1, -1))
        return genome.ravel()

    def tokens(self, genome: Floats) -> list[Token]:
        """Return the tokens of a genome."""
        checks.check_shape("genome", genome, self.genome_size)
        self.check_genomes(genome[None])
        names = list(_NUMBERS)
        tokens: list[Token] = []
        for number, operand in genome.reshape(-1, 2):
            name = names[int(number)]
            if name == "end":
                break
            if name == "constant":
                tokens.append(float(str(operand)))  # the shortest text, as a person would write it
            elif name == "input":
                tokens.append(self.inputs[int(operand)])
            else:
                tokens.append(name)
        return tokens

    def tree(self, genome: Floats) -> Node:
        """Return a genome as a tree, of which `genome_of` makes the same program."""
        return _tree_of(self.tokens(genome))

    def genome_of(self, tree: Node) -> Floats:
        """Return the genome of a tree; ValueError if it is no program."""
        return self.encode(_tokens_of(tree))

    def genome(self, expression: str) -> Floats:
        """Return the genome of an expression in the syntax of Python.

        It has names of inputs, numbers, ``+``, ``-``, ``*``, ``a < b``, ``b if a > 0 else c``,
        ``b if a < d else c`` and calls of `OPERATIONS`, such as ``min(a, b)``. So a tree of DEAP
        with these names is one, as text.
        """
        try:
            parsed = ast.parse(expression, mode="eval").body
        except SyntaxError as error:
            raise ValueError(f"expression: expected one of Python, got {expression!r}") from error
        return self.genome_of(_node_of(parsed))

    def initial(self, rng: np.random.Generator, depth: int = 3) -> Floats:
        """Return the genome of a random program, a tree of at most this depth."""
        checks.check_instance("rng", rng, np.random.Generator)
        depth = checks.check_integer("depth", depth, 0, 20)
        tree = self._grown(rng, depth)
        while len(_nodes(tree)) > self.length:
            tree = self._grown(rng, depth)
        return self.genome_of(tree)

    def _grown(self, rng: np.random.Generator, depth: int) -> Node:
        """Return a random tree of at most this depth."""
        if depth == 0 or rng.random() < 0.3:
            place = int(rng.integers(len(self.inputs) + 1))
            constant = float(np.round(rng.normal(), 2))
            return Constant(constant) if place == len(self.inputs) else Input(self.inputs[place])
        name = list(OPERATIONS)[rng.integers(len(OPERATIONS))]
        return Call(name, tuple(self._grown(rng, depth - 1) for _ in range(OPERATIONS[name])))

    def simplified(self, genome: Floats) -> Floats:
        """Return the genome of a shorter program with the same ratings, in float32.

        Operations on numbers become numbers; twice negated, least and greatest of the same, and
        choices that are known vanish; so do 0 in sums and 1 in products.
        """
        return self.genome_of(_simplified(self.tree(genome)))

    def shorter(self, genome: Floats) -> list[Floats]:
        """Return the programs in which one operation is replaced by one of its arguments.

        All are simplified and different, the shortest ones first.
        """
        programs: dict[bytes, Floats] = {}
        for tree in _shortened(self.tree(genome)):
            program = self.genome_of(_simplified(tree))
            programs[program.tobytes()] = program
        return sorted(programs.values(), key=lambda program: len(self.tokens(program)))

    def rate(self, genome: Floats, inputs: ArrayLike) -> Floats:
        """Return ratings, as `Rating.rate` does."""
        return self.values(self.tree(genome), inputs)

    def values(self, tree: Node, inputs: ArrayLike) -> Floats:
        """Return the values of a tree, float32 (..., n_actions), for inputs as `rate` has them."""
        columns = self.columns(inputs)
        shape = np.shape(inputs)[:-1]

        def of_leaf(leaf: Input | Constant) -> Floats:
            if isinstance(leaf, Input):
                return columns[leaf.name]
            return np.full(shape, leaf.value, np.float32)

        def of_call(call: Call, arguments: list[Floats]) -> Floats:
            values: Floats = _MEANINGS[call.operation].compute(*arguments)
            return values

        with np.errstate(over="ignore", invalid="ignore"):
            return np.asarray(np.fmax(fold(tree, of_leaf, of_call), LOWEST))

    def weights(self, genome: Floats) -> dict[str, float] | None:
        """Return weights by input, but those of 0, if the rating is a weighted sum, else None.

        A number that is added to the ratings of all moves does not count.
        """
        return _weights_of(self.tree(genome))

    def expression(self, genome: Floats) -> str:
        """Return a genome as an expression, of which `genome` makes the same program."""
        return expression_of(self.tree(genome))

    def to_python(self, genome: Floats) -> str:
        """Return a genome as lines of Python that play the same: see `Rating.to_python`."""
        forms = {name: meaning.of_arrays or meaning.text for name, meaning in _MEANINGS.items()}
        text = _text_of(self.tree(genome), _Forms("x['{}']", "f({})", "f({})", forms))
        head = "import numpy as np\n\nf = np.float32\n\n\ndef rate(x):\n"
        docstring = '    """Return the rating of each move by its inputs."""\n'
        return f"{head}{docstring}    return {text}\n{CHOICE.format(mask=self.mask)}"


# ---- What is made of trees ----------------------------------------------------------------------


def _simplified(tree: Node) -> Node:
    """Return a shorter tree with the same values."""
    return fold(tree, lambda leaf: leaf, _simplified_call)


def _simplified_call(call: Call, arguments: list[Node]) -> Node:
    """Return a call of these arguments, which are simplified, or a shorter node."""
    numbers = [node.value for node in arguments if isinstance(node, Constant)]
    if len(numbers) == len(arguments):
        with np.errstate(over="ignore", invalid="ignore"):
            value = float(_MEANINGS[call.operation].compute(*map(np.float32, numbers)))
        if np.isfinite(value):
            return Constant(value)
    match call.operation, arguments:
        case "negate", [Call("negate", [twice_negated])]:
            return twice_negated
        case "min" | "max", [one, other] if _is_same(one, other):
            return one
        case "add" | "subtract", [one, Constant(0.0)]:
            return one
        case "add", [Constant(0.0), other]:
            return other
        case "multiply", [one, Constant(1.0)]:
            return one
        case "multiply", [Constant(1.0), other]:
            return other
        case "where", [_, yes, no] if _is_same(yes, no):
            return yes
        case "where", [Constant(test), yes, no]:
            return yes if test > 0 else no
    return Call(call.operation, tuple(arguments))


def _is_same(one: Node, other: Node) -> bool:
    return _tokens_of(one) == _tokens_of(other)


def _shortened(tree: Node) -> list[Node]:
    """Return the trees in which one operation is replaced by one of its arguments."""

    def of_leaf(leaf: Input | Constant) -> list[Node]:
        return []

    def of_call(call: Call, shortened: list[list[Node]]) -> list[Node]:
        trees: list[Node] = []
        for place, arguments in enumerate(shortened):
            trees += [call.with_argument(place, argument) for argument in arguments]
        return [*trees, *call.arguments]

    return fold(tree, of_leaf, of_call)


def _weights_of(tree: Node) -> dict[str, float] | None:
    """Return the weights of the inputs whose weighted sum a tree is; None if it is none."""

    def of_leaf(leaf: Input | Constant) -> Terms | None:
        return {leaf.name: 1.0} if isinstance(leaf, Input) else {"": leaf.value}

    def of_call(call: Call, arguments: list[Terms | None]) -> Terms | None:
        match call.operation, arguments:
            case "negate", [dict() as one]:
                return scaled(one, -1.0)
            case ("add" | "subtract") as sign, [dict() as one, dict() as other]:
                other = scaled(other, 1.0 if sign == "add" else -1.0)
                return {name: one.get(name, 0.0) + other.get(name, 0.0) for name in one | other}
            case "multiply", [{"": number, **rest}, dict() as other] if not rest:
                return scaled(other, number)
            case "multiply", [dict() as one, {"": number, **rest}] if not rest:
                return scaled(one, number)
        return None

    def scaled(terms: Terms, number: float) -> Terms:
        return {name: number * weight for name, weight in terms.items()}

    terms = fold(tree, of_leaf, of_call)
    greatest = float(np.finfo(np.float32).max)
    if terms is None or not all(abs(weight) <= greatest for weight in terms.values()):
        return None
    return {name: weight for name, weight in terms.items() if name and weight}


class Case(NamedTuple):
    """What rates a move for which all tests are more than 0, unless an earlier case holds."""

    tests: tuple[Node, ...]
    tree: Node


def cases_of(tree: Node, most: int) -> list[Case]:
    """Return a tree as at most so many cases, of which the first one that holds rates a move.

    They are made from the top of the tree: ``where(a, b, c)`` is one case in which a > 0, and
    another one; ``min(a, b)`` is ``where(less(a, b), a, b)``, ``max(a, b)`` is ``where(less(a, b),
    b, a)``, and ``less(a, b)`` as a number is ``where(less(a, b), 1, 0)``. The last case holds for
    all moves.
    """
    cases = [Case((), tree)]
    while len(cases) < most:
        choices = {place: _first_choice(case.tree) for place, case in enumerate(cases)}
        # First where the fewest tests have been made.
        places = [place for place, choice in choices.items() if choice is not None]
        if not places:
            break
        place = min(places, key=lambda each: len(cases[each].tests))
        choice, (tests, split) = choices[place], cases[place]
        assert choice is not None
        test, yes, no = _parts_of(choice)
        cases[place : place + 1] = [
            Case((*tests, test), _replaced(split, choice, yes)),
            Case(tests, _replaced(split, choice, no)),
        ]
    return cases


def _first_choice(tree: Node) -> Call | None:
    """Return a call that chooses between values, none of which is nearer to the top, or None."""
    left: deque[Node] = deque([tree])
    while left:
        node = left.popleft()
        if isinstance(node, Call):
            if node.operation in ("where", "min", "max", "less"):
                return node
            left.extend(node.arguments)
    return None


def _parts_of(choice: Call) -> tuple[Node, Node, Node]:
    """Return the test of a choice, its value if that is more than 0, and its value if not."""
    match choice:
        case Call("where", (test, yes, no)):
            return test, yes, no
        case Call("min", (one, other)):
            return Call("less", (one, other)), one, other
        case Call("max", (one, other)):
            return Call("less", (one, other)), other, one
        case _:
            return choice, Constant(1.0), Constant(0.0)


def _replaced(tree: Node, node: Node, by: Node) -> Node:
    """Return a tree with one of its nodes replaced."""
    return fold(
        tree,
        lambda leaf: leaf,
        lambda call, arguments: by if call is node else Call(call.operation, tuple(arguments)),
    )


def expression_of(tree: Node) -> str:
    """Return a tree as an expression, of which `Program.genome` makes the same program."""
    forms = {name: meaning.text for name, meaning in _MEANINGS.items()}
    return _text_of(tree, _Forms("{}", "{}", "{}", forms))


class _Forms(NamedTuple):
    """How a text writes inputs, constants, comparisons as numbers, and operations."""

    input: str
    constant: str
    truth: str
    operations: Mapping[str, str]


def _text_of(tree: Node, forms: _Forms) -> str:
    """Return a tree as a Python expression."""

    def of_leaf(leaf: Input | Constant) -> str:
        if isinstance(leaf, Input):
            return forms.input.format(leaf.name)
        return forms.constant.format(leaf.value)

    def of_call(call: Call, texts: list[str]) -> str:
        numbers = [as_number(*pair) for pair in zip(call.arguments, texts, strict=True)]
        if call.operation == "where":
            is_test = _is_comparison(call.arguments[0])
            numbers[0] = texts[0] if is_test else f"({texts[0]}) > 0"
        return forms.operations[call.operation].format(*numbers)

    def as_number(node: Node, text: str) -> str:
        return forms.truth.format(text) if _is_comparison(node) else text

    text = as_number(tree, fold(tree, of_leaf, of_call))
    return ast.unparse(ast.parse(text, mode="eval"))  # without parentheses that are not needed


def _is_comparison(node: Node) -> bool:
    return isinstance(node, Call) and node.operation == "less"


_SIGNS: dict[type[ast.operator], str] = {ast.Add: "add", ast.Sub: "subtract", ast.Mult: "multiply"}


def _node_of(parsed: ast.expr) -> Node:
    """Return the tree of an expression of Python; its names are not checked yet."""
    match parsed:
        case ast.Constant(value=int() | float() as value):
            return Constant(float(value))
        case ast.Name(id=name):
            return Input(name)
        case ast.UnaryOp(op=ast.USub(), operand=ast.Constant(value=int() | float() as value)):
            return Constant(-float(value))
        case ast.UnaryOp(op=ast.USub(), operand=operand):
            return _call("negate", operand)
        case ast.BinOp(left=left, op=ast.Add() | ast.Sub() | ast.Mult() as sign, right=right):
            return _call(_SIGNS[type(sign)], left, right)
        case ast.Compare(left=left, ops=[ast.Lt()], comparators=[right]):
            return _call("less", left, right)
        case ast.IfExp(
            test=ast.Compare(left=test, ops=[ast.Gt()], comparators=[ast.Constant(value=0)])
            | (ast.Compare(ops=[ast.Lt()]) as test),
            body=body,
            orelse=other,
        ):
            return _call("where", test, body, other)
        case ast.Call(func=ast.Name(id=name), args=arguments, keywords=[]):
            return _call(name, *arguments)
        case _:
            expected = "inputs, numbers, +, -, *, <, `b if a > 0 else c` and operations"
            raise ValueError(f"expression: expected {expected}, got {ast.unparse(parsed)!r}")


def _call(operation: str, *arguments: ast.expr) -> Call:
    return Call(operation, tuple(map(_node_of, arguments)))
