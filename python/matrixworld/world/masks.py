"""Masks: which moves of an agent are never chosen, as cells of its own view that forbid them."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import Any, Literal, TypeAlias, get_args

import numpy as np
from numpy.typing import NDArray

from matrixworld import _core
from matrixworld._util.checks import check_choice, shown
from matrixworld._util.teams import PLURALS
from matrixworld.world import policy
from matrixworld.world.arrays import CHANNEL, MOVES
from matrixworld.world.config import WorldConfig
from matrixworld.world.rules import Action, Capture

Mask: TypeAlias = Literal["none", "obstacles", "right-of-way"]

MASKS: tuple[Mask, ...] = get_args(Mask)
"""Names of masks: no move is forbidden; moves into an obstacle or the border; besides these, moves
that could put the agent at fault (`docs/safety.md#right-of-way`)."""

LEAST_FOV: dict[Mask, int] = {"none": 1, "obstacles": 3, "right-of-way": 5}
"""The smallest field of view in which an agent sees all that a mask looks at."""


def check_mask(name: str, mask: str, config: WorldConfig, user: str = "") -> None:
    """Raise ValueError unless a mask exists and agents see enough for it."""
    check_choice(name, mask, MASKS)
    least = LEAST_FOV[mask]  # type: ignore[index]  # one of the choices
    if config.fov < least:
        user = user or f"the mask {mask}"
        raise ValueError(f"{name}: expected a fov of at least {least} for {user}, got {config.fov}")


def check_script(name: str, player: str, config: WorldConfig) -> None:
    """Raise ValueError if a player is a careful script and agents see too little for it."""
    if player in policy.SCRIPTS and player.startswith(policy.CAREFUL):
        check_mask(name, "right-of-way", config, player)


def right_of_way_cells(
    config: WorldConfig, team: policy.Team, step: int | None = None
) -> list[list[tuple[int, int, int]]]:
    """Return the cells of a view in which an agent forbids each move, without staying, of a team.

    They are (channel, rows down, columns to the right) from the middle of the view. Scripts and
    ratings have another order than networks, by the `step`.
    """
    _, *cells = _core.right_of_way(config.setup, team == "evader", step)
    return cells


def forbidding_cells(
    config: WorldConfig, mask: str, team: policy.Team, step: int | None = None
) -> NDArray[np.intp]:
    """Return which numbers of a view forbid each move: indices (n_actions - 1, k) of a flat view.

    A move is forbidden where one of its k numbers is 1; a number may be named twice. `step` is as
    for `right_of_way_cells`.
    """
    fov = config.fov
    moves = range(1, config.n_actions)
    if mask == "none":
        return np.empty((len(moves), 0), np.intp)
    if mask == "obstacles":
        cells = [[(CHANNEL["obstacle"], *MOVES[move])] for move in moves]
    else:
        cells = right_of_way_cells(config, team, step)
    most = max(map(len, cells))
    # The first number of a move is repeated, so that all moves have equally many.
    of_moves = [numbers + numbers[:1] * (most - len(numbers)) for numbers in cells]
    channels, rows, cols = np.moveaxis(np.array(of_moves), -1, 0)
    indices: NDArray[np.intp] = (channels * fov + rows + fov // 2) * fov + cols + fov // 2
    return indices


class ActionMasks:
    """The masks of both teams: none for False, obstacles for True, or those of a name."""

    def __init__(self, chosen: bool | str, config: WorldConfig) -> None:
        names = {False: "none", True: "obstacles"}
        mask = names[chosen] if isinstance(chosen, bool) else chosen
        check_mask("action_mask", mask, config)
        self._config = config
        self._mask = mask
        self._cells: dict[int | None, list[NDArray[np.intp]]] = {}
        self.given: bool = mask != "none"

    def of(self, views: NDArray[Any], first: int = 0, step: int | None = None) -> NDArray[np.int8]:
        """Return what the agents from `first` on may do, (..., A, n_actions), by their views.

        `step` is as for `right_of_way_cells`.
        """
        if step not in self._cells:
            self._cells[step] = [
                forbidding_cells(self._config, self._mask, team, step) for team in policy.TEAMS
            ]
        pursuers = max(0, self._config.n_pursuers - first)
        parts = views[..., :pursuers, :, :, :], views[..., pursuers:, :, :, :]
        masks = map(action_masks, parts, self._cells[step])
        return np.concatenate([*masks], axis=-2)


def action_masks(views: NDArray[Any], cells: NDArray[np.intp]) -> NDArray[np.int8]:
    """Return which actions are allowed, int8 (..., n_actions), in views (..., 3, fov, fov).

    `cells` are `forbidding_cells`. All actions of an agent that is gone are allowed.
    """
    flat = views.reshape(*views.shape[:-3], math.prod(views.shape[-3:]))
    masks = np.ones((*flat.shape[:-1], 1 + len(cells)), np.int8)
    masks[..., Action.STAY + 1 :] = ~(flat[..., cells] != 0).any(axis=-1)
    return masks


def check_team(name: str, given: Any, config: WorldConfig, team: policy.Team) -> Any:
    """Return the engine's form of a team policy.

    ValueError for networks with the right of way of the other team, or of rules under which more is
    allowed: they would be at fault.
    """
    player = given.population() if hasattr(given, "population") else given
    if isinstance(player, policy.Population):
        if isinstance(player.policy, policy.Network) and player.policy.fits(config):
            _check_right_of_way(name, player.forbids, config, team)
        return player.policy.core, player.genomes
    if isinstance(player, policy.TablePolicy):
        return player.core
    if not isinstance(player, str):
        expected = "a Population, a TablePolicy or the name of a script"
        raise TypeError(f"{name}: expected {expected}, got {shown(player)}")
    check_choice(name, player, policy.SCRIPTS)
    return player


def _check_right_of_way(
    name: str, forbids: NDArray[np.bool_], config: WorldConfig, team: policy.Team
) -> None:
    # The channels of agents come first: without them a mask is that of obstacles.
    masked = forbids[:, : CHANNEL["obstacle"] * config.fov**2].any(axis=(1, 2))
    if masked.any():
        cells = forbidding_cells(config, "right-of-way", team)
        if not forbids[masked][:, cells, np.arange(len(cells))[:, np.newaxis]].all():
            raise ValueError(
                f"{name}: expected networks that keep the right of way of {PLURALS[team]} under "
                "these rules, got a mask of other rules or of the other team"
            )


def leaves_captures(config: WorldConfig) -> bool:
    """Return whether pursuers with right of way can capture by a move of their own.

    Where contact captures, they must be allowed to enter the cell of an evader; otherwise a cell
    beside an evader, which the evader could enter, too.
    """
    north, *_ = right_of_way_cells(config, "pursuer")
    evaders = {(row, col) for channel, row, col in north if channel == CHANNEL["evader"]}
    entered = tuple(MOVES[Action.NORTH])
    if config.rules.capture is Capture.OCCUPATION:
        return entered not in evaders
    return evaders <= {entered}


# Masks of a network: fixed weights, so that whatever plays the genome keeps to the mask. A mask
# forbids a move where certain numbers of a view are 1, so it is a network itself: one unit for each
# move, active if the move is forbidden, with a large negative weight to the output of that move.
# These units stand beside the others in each hidden layer.


@dataclass(frozen=True, eq=False)
class FixedWeights:
    """Weights (genes,) of a network that no learner changes, and their values; 0 elsewhere."""

    fixed: NDArray[np.bool_]
    values: NDArray[np.float32]

    def write(self, genomes: NDArray[np.float32]) -> NDArray[np.float32]:
        """Return genomes (n, genes) with the fixed weights in their places."""
        return np.where(self.fixed, self.values, genomes)


def masked_network(network: policy.Network) -> policy.Network:
    """Return a network with room for a mask: one more unit for each move in each hidden layer."""
    return replace(network, hidden=tuple(size + network.n_actions - 1 for size in network.hidden))


def mask_weights(network: policy.Network, cells: NDArray[np.intp]) -> FixedWeights:
    """Return the weights of a mask in a `masked_network`, from its `forbidding_cells`.

    Staying is never forbidden. Without hidden layers, the weights from the cells to the outputs are
    fixed. With tanh, a unit of the mask is not 1 but at least tanh(tanh(...(1))), which is enough;
    recurrent units of the mask remember nothing. On masks in learning: Huang & Ontañón 2022, "A
    closer look at invalid action masking in policy gradient algorithms".
    """
    marks, values = np.zeros((2, network.genome_size), np.float32)
    moves, last = network.n_actions - 1, len(network.shapes) - 1
    layers = zip(network.layers(values), network.layers(marks), strict=True)
    for number, ((weights, biases), (fixed_weights, fixed_biases)) in enumerate(layers):
        if number == 1 and network.state_size:
            shape = 2, network.state_size, -1, network.state_size  # inputs and states; gates
            by_gate, fixed = weights.reshape(shape), fixed_weights.reshape(shape)
            fixed[:, -moves:] = fixed[..., -moves:] = 1.0
            fixed_biases.reshape(shape[2:])[:, -moves:] = 1.0
            by_gate[0, -moves:, -1, -moves:] = np.eye(moves)
            if network.memory == "gru":
                biases.reshape(shape[2:])[1, -moves:] = policy.FORBIDDEN  # nothing is kept
            continue
        sources = cells.T if number == 0 else np.arange(len(weights) - moves, len(weights))[None]
        # A unit of the mask hears of nothing else, and nothing else hears of it.
        if number > 0:
            fixed_weights[-moves:] = 1.0
        if number < last:
            fixed_weights[:, -moves:] = 1.0
            fixed_biases[-moves:] = 1.0
        targets = np.arange(1, 1 + moves) if number == last else np.arange(-moves, 0)
        fixed_weights[sources, targets] = 1.0
        weights[sources, targets] = policy.FORBIDDEN if number == last else 1.0
    return FixedWeights(marks != 0.0, values)
