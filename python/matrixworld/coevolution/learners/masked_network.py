"""Action masks as fixed weights of a network: whatever plays the genome keeps to the mask.

A mask forbids a move where certain numbers of an agent's view are 1, so a mask is a network itself:
one unit for each move, active if the move is forbidden, with a large negative weight to the output
of that move. These units stand beside the others in each hidden layer. No learner changes their
weights.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from matrixworld.coevolution.types import BoolArray, Genome, Genomes, IntArray
from matrixworld.world.policy import Network

FORBIDDEN = -(2.0**100)
"""Added to the output of a forbidden move. Its probability is 0: e^x is 0 in float32 below -104,
and other outputs are smaller than this number by far, whatever is learned. Its sums are finite."""


@dataclass(frozen=True, eq=False)
class FixedWeights:
    """Weights (genes,) of a network that no learner changes, and their values; 0 elsewhere."""

    fixed: BoolArray
    values: Genome

    def write(self, genomes: Genomes) -> Genomes:
        """Return genomes (n, genes) with the fixed weights in their places."""
        return np.where(self.fixed, self.values, genomes)


def masked_network(network: Network) -> Network:
    """Return a network with room for a mask: one more unit for each move in each hidden layer."""
    return replace(network, hidden=tuple(size + network.n_actions - 1 for size in network.hidden))


def mask_weights(network: Network, cells: IntArray) -> FixedWeights:
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
                biases.reshape(shape[2:])[1, -moves:] = FORBIDDEN  # nothing is kept
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
        weights[sources, targets] = FORBIDDEN if number == last else 1.0
    return FixedWeights(marks != 0.0, values)
