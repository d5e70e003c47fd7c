"""A network or a rating as a PyTorch module, which can be trained: copy this file.

``pip install torch``
"""

import numpy as np
import torch

from matrixworld import INPUTS


def to_torch(policy):
    """Return the network of a `NetworkPolicy` as a module of observations (n, ...) to logits.

    It is Flatten, then Linear and activation in turn; inputs are float32. With memory it maps
    observations and states (n, state_size) to logits and next states, by a GRUCell.
    """
    activation = torch.nn.ReLU if policy.policy.activation == "relu" else torch.nn.Tanh
    size, modules = policy.policy.state_size, [torch.nn.Flatten()]
    for number, (weights, bias) in enumerate(policy.layers()):
        # PyTorch keeps weights as (outputs, inputs).
        rows, numbers = torch.from_numpy(weights.T.copy()), torch.from_numpy(bias)
        if number == 1 and size:
            modules.append(torch.nn.GRUCell(size, size))
            parts = rows[:, :size], rows[:, size:], numbers, torch.zeros_like(numbers)
            names = "weight_ih", "weight_hh", "bias_ih", "bias_hh"
            modules[-1].load_state_dict(dict(zip(names, parts, strict=True)))
            continue
        modules += [torch.nn.Linear(*weights.shape), activation()]
        modules[-2].load_state_dict({"weight": rows, "bias": numbers})
    modules.pop()
    return WithStates(modules) if size else torch.nn.Sequential(*modules)


def rating_to_torch(policy):
    """Return the rating of a `RatingPolicy` as a module of all inputs (..., moves, inputs).

    It returns ratings (..., moves). Inputs that the policy does not use have weights 0.
    """
    modules = []
    for number, (weights, bias) in enumerate(policy.policy.layers(policy.genome)):
        rows = weights.T
        if number == 0:
            rows = np.zeros((weights.shape[1], len(INPUTS)), np.float32)
            rows[:, [list(INPUTS).index(name) for name in policy.policy.inputs]] = weights.T
        linear = torch.nn.Linear(*rows.T.shape, bias=len(bias) > 0)
        values = {"weight": rows.copy(), "bias": bias}
        linear.load_state_dict({n: torch.from_numpy(values[n]) for n in linear.state_dict()})
        modules += [linear, torch.nn.ReLU()]
    return torch.nn.Sequential(*modules[:-1], torch.nn.Flatten(-2))


class WithStates(torch.nn.Module):
    """A module of (observations, states) from its parts, of which the fourth is a cell."""

    def __init__(self, modules):
        super().__init__()
        self.first, self.cell = torch.nn.Sequential(*modules[:3]), modules[3]
        self.rest = torch.nn.Sequential(*modules[4:])

    def forward(self, observations, states):
        """Return logits and next states."""
        following = self.cell(self.first(observations), states)
        return self.rest(following), following
