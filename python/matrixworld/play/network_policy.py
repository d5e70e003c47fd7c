"""A genome as a policy that acts on observations outside of the engine, and in a file."""

from __future__ import annotations

import os
from dataclasses import asdict, replace
from pathlib import Path
from typing import Any, TypeAlias, cast

import numpy as np
from numpy.typing import ArrayLike, NDArray

from matrixworld._util.checks import check_bool, check_choice, check_instance
from matrixworld._util.files import DamagedFileError, load_arrays, save_arrays
from matrixworld.world.config import WorldConfig
from matrixworld.world.policy import CHANNELS, TEAMS, Network, Policy, Population, Team

Layers: TypeAlias = list[tuple[NDArray[np.float32], NDArray[np.float32]]]
"""Weights (inputs, outputs) and biases (outputs,) of each layer."""


def fits(network: Policy, config: WorldConfig) -> bool:
    """Return whether a policy has the views and actions of a world."""
    return (network.fov, network.n_actions) == (config.fov, config.n_actions)


def check_fits(name: str, network: Policy, config: WorldConfig) -> None:
    """Raise ValueError unless a policy has the views and actions of a world."""
    if not fits(network, config):
        raise ValueError(
            f"{name}: expected a network for fov {config.fov} and {config.n_actions} actions, "
            f"got fov {network.fov} and {network.n_actions} actions"
        )


class NetworkPolicy:
    """A policy network with its weights, to act on observations outside of the engine.

    Call it with observations to get actions. `SavedRun.policy` returns one for a generation of a
    run. It keeps no state of agents: a policy with memory takes their states and returns the next.

    Parameters
    ----------
    network : Network
        The network.
    genome : ndarray of float32, shape (genome_size,)
        Its weights and biases.
    sampled : bool, optional
        Whether actions are drawn from the probabilities, or are those with the largest one. The
        default is what the network says.
    seed : int, optional
        Seed of the draws. The default is one from the operating system.

    Examples
    --------
    >>> import numpy as np
    >>> from matrixworld import Network, NetworkPolicy, parallel_env
    >>> network = Network(hidden=(16,), fov=5)
    >>> policy = NetworkPolicy(network, network.initial(np.random.default_rng(0)), seed=1)
    >>> env = parallel_env("O", rows=8, cols=8, n_pursuers=2, n_evaders=2, fov=5)
    >>> observations, infos = env.reset(seed=0)
    >>> actions = {agent: policy(seen) for agent, seen in observations.items()}
    >>> policy.probabilities(np.stack(list(observations.values()))).shape
    (4, 5)

    With memory, each agent has a state:

    >>> network = Network(hidden=(16,), fov=5, memory="gru")
    >>> policy = NetworkPolicy(network, network.initial(np.random.default_rng(0)), seed=1)
    >>> states = dict.fromkeys(observations)
    >>> for agent, seen in observations.items():
    ...     actions[agent], states[agent] = policy(seen, states[agent])
    """

    def __init__(
        self,
        network: Network,
        genome: NDArray[np.float32],
        *,
        sampled: bool | None = None,
        seed: int | None = None,
    ) -> None:
        check_instance("network", network, Network)
        genomes = Population(genome, network).genomes
        if len(genomes) != 1:
            raise ValueError(f"genome: expected a single one, got {len(genomes)}")
        self.genome = genomes[0].copy()
        self.network = network
        if sampled is not None:
            self.network = replace(network, sampled=check_bool("sampled", sampled))
        self._rng = np.random.default_rng(seed)

    def __repr__(self) -> str:
        """Return the network without its weights."""
        return f"NetworkPolicy({self.network!r})"

    def __call__(self, observations: ArrayLike, states: ArrayLike | None = None) -> Any:
        """Return actions for observations: an int for one, int64 of the leading axes for several.

        An observation is (3, fov, fov) or flattened; further axes may stand in front of it. With
        memory it is a pair, actions and next states: `states`, float32 (..., state_size), are those
        of the agents before, by default zeros, as at the start of an episode.
        """
        logits, following, leading = self._advance(observations, states)
        if self.network.sampled:
            # The action is the number of cumulated weights that do not exceed unit * total.
            cumulated = np.exp(logits - logits.max(axis=1, keepdims=True)).cumsum(axis=1)
            threshold = self._rng.random(len(logits), np.float32) * cumulated[:, -1]
            actions = (cumulated[:, :-1] <= threshold[:, None]).sum(axis=1)
        else:
            actions = logits.argmax(axis=1)
        chosen = actions.reshape(leading) if leading else int(actions[0])
        return (chosen, following) if self.network.state_size else chosen

    def logits(
        self, observations: ArrayLike, states: ArrayLike | None = None
    ) -> NDArray[np.float32]:
        """Return the outputs of the network, (..., n_actions), for arguments as in a call."""
        logits, _, leading = self._advance(observations, states)
        return logits.reshape(*leading, -1)

    def probabilities(
        self, observations: ArrayLike, states: ArrayLike | None = None
    ) -> NDArray[np.float32]:
        """Return the probability of each action, (..., n_actions): the softmax of the outputs.

        A policy that does not sample takes the largest.
        """
        logits = self.logits(observations, states)
        weights = np.exp(logits - logits.max(axis=-1, keepdims=True))
        return np.asarray(weights / weights.sum(axis=-1, keepdims=True))

    def _advance(
        self, observations: ArrayLike, states: ArrayLike | None
    ) -> tuple[NDArray[np.float32], NDArray[np.float32], tuple[int, ...]]:
        """Return outputs (n, n_actions), next states (..., state_size) and the leading axes."""
        views, leading = self._views(observations)
        shape = *leading, self.network.state_size
        if states is not None:
            if np.shape(states) != shape or not self.network.state_size:
                expected = f"shape {shape}" if self.network.state_size else "none without memory"
                raise ValueError(f"states: expected {expected}, got shape {np.shape(states)}")
            states = np.asarray(states, np.float32).reshape(len(views), -1)
        logits, following = self.network.advance(self.genome, views, states)
        return logits, following.reshape(shape), leading

    def _views(self, observations: ArrayLike) -> tuple[NDArray[Any], tuple[int, ...]]:
        """Return observations as (n, 3, fov, fov), and the axes in front of an observation."""
        array = np.asarray(observations)
        if array.dtype.kind not in "buif":
            raise TypeError(f"observations: expected numbers, got dtype {array.dtype}")
        view = (CHANNELS, self.network.fov, self.network.fov)
        size = self.network.sizes[0]
        for tail in (view, (size,)):
            if array.shape[-len(tail) :] == tail:
                return array.reshape(-1, *view), array.shape[: -len(tail)]
        raise ValueError(
            f"observations: expected shape (..., {str(view)[1:]} or (..., {size}), "
            f"got {array.shape}"
        )

    def layers(self) -> Layers:
        """Return a copy of the weights (inputs, outputs) and biases (outputs,) of each layer.

        An observation is flattened in its own order: channel, row, column. The activation follows
        every layer but the last, whose outputs are the logits, and a recurrent one (see `Network`).
        """
        return [(w.copy(), b.copy()) for w, b in self.network.layers(self.genome)]

    def population(self) -> Population:
        """Return the genome as a population of one, which rollouts and environments take."""
        return Population(self.genome, self.network)


# Files, one npz of numbers each, never code:

FORMS = {
    "genome": ("f", 1),
    "hidden": ("iuf", 1),  # an empty list is an array of floats
    "activation": ("U", 0),
    "memory": ("U", 0),
    "fov": ("iu", 0),
    "n_actions": ("iu", 0),
    "sampled": ("b", 0),
    "team": ("U", 0),
}
"""Kinds of dtypes, as ``dtype.kind``, and number of dimensions of each array."""


def save_genome(path: str | os.PathLike[str], team: Team, policy: NetworkPolicy) -> None:
    """Write a policy as a file that `read_genome` reads and that a class tournament plays.

    An older file at `path` is replaced. `policy` plays for `team`, such as
    ``open_run(directory).policy("pursuer")``.
    """
    check_choice("team", team, TEAMS)
    arrays = asdict(policy.network) | {"genome": policy.genome, "team": team}
    arrays["hidden"] = np.array(policy.network.hidden, np.int64)
    save_arrays(Path(path), arrays)


def read_genome(path: str | os.PathLike[str]) -> tuple[Team, Population]:
    """Return the team of a genome's file, and the genome as a population of one.

    The file at `path` is one of `save_genome`, or of ``numpy.savez`` with the same keys;
    DamagedFileError, a ValueError, if it is not of this form.
    """
    return parse_genome(Path(path))


def parse_genome(path: Path, content: bytes | None = None) -> tuple[Team, Population]:
    """Return what `read_genome` returns, from the file or from its content."""
    arrays = load_arrays(path, content)
    for name, (kinds, ndim) in FORMS.items():
        if name not in arrays:
            raise DamagedFileError(path, f"expected an array {name!r}, got {', '.join(arrays)}")
        if arrays[name].dtype.kind not in kinds or arrays[name].ndim != ndim:
            expected = f"expected dtype of kind {kinds} and {ndim} dimensions"
            got = f"dtype {arrays[name].dtype} and shape {arrays[name].shape}"
            raise DamagedFileError(path, f"{name}: {expected}, got {got}")
    try:
        team = str(arrays["team"])
        check_choice("team", team, TEAMS)
        network = Network(
            tuple(int(size) for size in arrays["hidden"]),
            activation=str(arrays["activation"]),  # type: ignore[arg-type]
            memory=str(arrays["memory"]),  # type: ignore[arg-type]
            fov=int(arrays["fov"]),
            n_actions=int(arrays["n_actions"]),
            sampled=bool(arrays["sampled"]),
        )
        return cast(Team, team), Population(arrays["genome"], network)
    except (OverflowError, TypeError, ValueError) as error:
        raise DamagedFileError(path, str(error)) from error
