"""Policies that rate moves by named inputs: what they share, and small networks."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise
from types import MappingProxyType
from typing import ClassVar, TypeAlias

import numpy as np
from numpy.typing import ArrayLike, NDArray

from matrixworld import _core
from matrixworld._util import checks
from matrixworld.world.masks import LEAST_FOV, MASKS, Mask
from matrixworld.world.policy import Layers, Policy, layers_of

Floats: TypeAlias = NDArray[np.float32]


def _text_of(definition: str, unit: str, most: float) -> str:
    limits = f"0 to {most:g}" if most else "0 or more"
    if unit:
        limits += f", in {unit}"
    return f"{definition} ({limits})"


INPUTS: Mapping[str, str] = MappingProxyType(
    {name: _text_of(definition, unit, most) for name, definition, unit, most in _core.inputs()}
)
"""The named inputs of a move, and what they are.

All are of the cell that the move leads to, for the same agents: those in view. Distances are least
numbers of moves, as if there were no obstacles, in units of half a view, ``fov / 2``; 2 where there
is nothing in view. A cell that holds several agents of a team counts once, and a cell out of view
as free. Both teams have the same inputs. Only three depend on the step: ``must_yield``, as right of
way has another order in each; ``ahead``, as an agent draws a direction for each 12 steps; and
``search``, which follows a plan. Only this one also depends on what is not in view: the size of the
grid and of the team, whether there are obstacles, and the number of the agent. Which adversary is
nearest is judged before the move; of several, ``escapes`` is the least and ``opposite`` the most.
Without one, ``escapes`` is 1 for a pursuer; ``parity``, and ``opposite`` without a pair, are 0.
"""

# The plan of search takes more time than all of these. The three after it help some teams, and make
# races of others lopsided.
PRESENT = tuple(INPUTS)[:9]

LOWEST = np.finfo(np.float32).min


class RatesMoves(Policy):
    """What rates moves: the same function of the inputs for each move of an agent."""

    inputs: tuple[str, ...]
    hidden: tuple[int, ...] = ()
    length: int = 0
    mask: Mask

    def __post_init__(self) -> None:
        names = checks.check_sequence("inputs", self.inputs, "names of inputs")
        for name in names:
            checks.check_choice("inputs", name, INPUTS)
        if not names or len(set(names)) < len(names):
            raise ValueError(f"inputs: expected different ones, got {checks.shown(names)}")
        object.__setattr__(self, "inputs", names)
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

    def checked(self, inputs: ArrayLike) -> Floats:
        """Return inputs (..., n_actions, all inputs), or raise a ValueError or TypeError."""
        array = checks.unmasked("inputs", inputs)
        shape = (self.n_actions, len(INPUTS))
        if array.dtype != np.float32 or array.shape[-2:] != shape:
            expected = f"float32 of shape (..., {str(shape)[1:]}"
            raise ValueError(f"inputs: expected {expected}, got {array.dtype} {array.shape}")
        checks.check_finite("inputs", array)
        return array

    def columns(self, inputs: ArrayLike) -> dict[str, Floats]:
        """Return arrays (..., n_actions) of the inputs of this policy by their names."""
        array = self.checked(inputs)
        return {name: array[..., list(INPUTS).index(name)] for name in self.inputs}


def allowed_moves(inputs: Floats, mask: Mask) -> NDArray[np.bool_]:
    """Return which moves a mask allows, bool (..., n_actions), by inputs (..., n_actions, all)."""
    names = list(INPUTS)
    free: NDArray[np.bool_] = {
        "none": np.ones(inputs.shape[:-1], np.bool_),
        "obstacles": inputs[..., names.index("room")] > 0,
        "right-of-way": inputs[..., names.index("must_yield")] == 0,
    }[mask]
    free[..., 0] = True  # agents may always stay
    return free


CHOICE = '''

MASK = "{mask}"


def choose(x, allowed, rng):
    """Return the best of the allowed moves; of equal ones any, all equally likely."""
    ratings = np.where(allowed, rate(x), -np.inf)
    return rng.choice(np.flatnonzero(ratings == ratings.max()))
'''


@dataclass(frozen=True)
class Rating(RatesMoves):
    """A policy that rates each move of an agent by a small network of named inputs.

    The same network rates all moves, so what is learned for one direction holds for all. The agent
    takes the best move that the mask allows; of equal ones any, all equally likely. It describes
    the shape only; a genome holds the weights.

    Parameters
    ----------
    inputs : sequence of str, optional
        Names of `INPUTS`, in the order of the genome. The default is all up to
        ``ahead``.
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

    inputs: tuple[str, ...] = PRESENT
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

    def layers(self, genome: Floats) -> Layers:
        """Return weights (inputs, outputs) and biases (outputs,) of each layer, views of a genome.

        The last layer has the outputs 1 and no bias. Changing an array changes the genome.
        """
        checks.check_shape("genome", genome, self.genome_size)
        return layers_of(genome, pairwise(self.sizes))

    def without(self, genome: Floats, name: str) -> Floats:
        """Return a genome that does not read an input: all weights that it enters by are 0."""
        checks.check_choice("name", name, self.inputs)
        changed: Floats = genome.copy()
        self.layers(changed)[0][0][self.inputs.index(name)] = 0
        return changed

    def initial(self, rng: np.random.Generator, weight: float = 0.5) -> Floats:
        """Return a random genome, float32 (genome_size,): weights from N(0, weight²), biases 0."""
        checks.check_instance("rng", rng, np.random.Generator)
        weight = checks.check_number("weight", weight, least=0.0)
        genome = np.zeros(self.genome_size, np.float32)
        for weights, _ in self.layers(genome):
            weights[:] = weight * rng.standard_normal(weights.shape, dtype=np.float32)
        return genome

    def rate(self, genome: Floats, inputs: ArrayLike) -> Floats:
        """Return ratings, float32 (..., n_actions), of finite inputs (..., n_actions, all inputs).

        They are computed in NumPy. The numbers are those of the engine, bit by bit.
        """
        x = list(self.columns(inputs).values())
        *hidden, (last, _) = self.layers(genome)
        with np.errstate(over="ignore", invalid="ignore"):
            for weights, biases in hidden:
                x = [
                    np.fmax(_sum(x, column, bias), np.float32(0))
                    for column, bias in zip(weights.T, biases, strict=True)
                ]
            return np.asarray(np.fmax(_sum(x, last[:, 0], np.float32(0)), LOWEST))

    def to_python(self, genome: Floats) -> str:
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
        return "\n".join(lines) + "\n" + CHOICE.format(mask=self.mask)


def _sum(x: list[Floats], weights: Floats, start: np.float32) -> Floats:
    total = np.full_like(x[0], start)
    for column, weight in zip(x, weights, strict=True):
        total = total + weight * column
    return total


def _sum_text(weights: Floats, terms: list[str], start: str = "") -> str:
    parts = [start] if start else []
    for weight, term in zip(weights, terms, strict=True):
        if weight != 0:
            parts.append(f"{weight!s} * {term}")
    if not parts:
        parts = [f"0 * {terms[0]}"]
    return " + ".join(parts).replace("+ -", "- ")
