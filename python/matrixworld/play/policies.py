"""Genomes as policies that act outside of the engine, and in files."""

from __future__ import annotations

import os
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any, cast

import numpy as np
from numpy.typing import ArrayLike, NDArray

from matrixworld._util import checks
from matrixworld._util.files import DamagedFileError, load_arrays, save_arrays
from matrixworld.world.policy import CHANNELS, TEAMS, Layers, Network, Policy, Population, Team
from matrixworld.world.program import Program
from matrixworld.world.rating import Rating, allowed_moves


class GenomePolicy:
    """Base of what acts by a genome, `policy` being its shape."""

    policy: Any

    def __init__(self, policy: Policy, genome: NDArray[np.float32], seed: int | None) -> None:
        genomes = Population(genome, policy).genomes
        if len(genomes) != 1:
            raise ValueError(f"genome: expected a single one, got {len(genomes)}")
        self.genome = genomes[0].copy()
        self.policy = policy
        self._rng = np.random.default_rng(seed)

    def __repr__(self) -> str:
        """Return the shape of the policy without its genome."""
        return f"{type(self).__name__}({self.policy!r})"

    def population(self) -> Population:
        """Return the genome as a population of one, which rollouts and environments take."""
        return Population(self.genome, self.policy)


class NetworkPolicy(GenomePolicy):
    """A policy network with its weights, to act on observations outside of the engine.

    Call it with observations to get actions. `SavedRun.policy` returns one for a generation of a
    run. It keeps no state of agents: a policy with memory takes their states and returns the next.

    Parameters
    ----------
    policy : Network
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
    """

    policy: Network

    def __init__(
        self,
        policy: Network,
        genome: NDArray[np.float32],
        *,
        sampled: bool | None = None,
        seed: int | None = None,
    ) -> None:
        checks.check_instance("policy", policy, Network)
        super().__init__(policy, genome, seed)
        if sampled is not None:
            self.policy = replace(policy, sampled=checks.check_bool("sampled", sampled))

    def __call__(self, observations: ArrayLike, states: ArrayLike | None = None) -> Any:
        """Return actions for observations: an int for one, int64 of the leading axes for several.

        An observation is (3, fov, fov) or flattened; further axes may stand in front of it. With
        memory it is a pair, actions and next states: `states`, float32 (..., state_size), are those
        of the agents before, by default zeros, as at the start of an episode.
        """
        logits, following, leading = self._advance(observations, states)
        if self.policy.sampled:
            # The action is the number of cumulated weights that do not exceed unit * total.
            cumulated = np.exp(logits - logits.max(axis=1, keepdims=True)).cumsum(axis=1)
            threshold = self._rng.random(len(logits), np.float32) * cumulated[:, -1]
            actions = (cumulated[:, :-1] <= threshold[:, None]).sum(axis=1)
        else:
            actions = logits.argmax(axis=1)
        chosen = actions.reshape(leading) if leading else int(actions[0])
        return (chosen, following) if self.policy.state_size else chosen

    def logits(
        self, observations: ArrayLike, states: ArrayLike | None = None
    ) -> NDArray[np.float32]:
        """Return the outputs of the network, (..., n_actions), for arguments as in a call."""
        logits, _, leading = self._advance(observations, states)
        return logits.reshape(*leading, self.policy.n_actions)

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
        shape = *leading, self.policy.state_size
        if states is not None:
            if np.shape(states) != shape or not self.policy.state_size:
                expected = f"shape {shape}" if self.policy.state_size else "none without memory"
                raise ValueError(f"states: expected {expected}, got shape {np.shape(states)}")
            states = (
                checks.unmasked("states", states).astype(np.float32).reshape(len(views), shape[-1])
            )
            checks.check_finite("states", states)
        logits, following = self.policy.advance(self.genome, views, states)
        return logits, following.reshape(shape), leading

    def _views(self, observations: ArrayLike) -> tuple[NDArray[Any], tuple[int, ...]]:
        """Return observations as (n, 3, fov, fov), and the axes in front of an observation."""
        array = checks.unmasked("observations", observations)
        if array.dtype.kind not in "buif":
            raise TypeError(f"observations: expected numbers, got dtype {array.dtype}")
        checks.check_finite("observations", array)
        view = (CHANNELS, self.policy.fov, self.policy.fov)
        size = self.policy.sizes[0]
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
        return [(w.copy(), b.copy()) for w, b in self.policy.layers(self.genome)]


class RatingPolicy(GenomePolicy):
    """A policy that rates moves, with its genome, to act on named inputs outside of the engine.

    Call it with inputs to get actions: the best of the allowed moves, of equal ones any.
    `SavedRun.policy` returns one for a generation of a run. `World.inputs` returns inputs.

    Parameters
    ----------
    policy : Rating or Program
        What rates.
    genome : ndarray of float32, shape (genome_size,)
        Its weights, or its code.
    seed : int, optional
        Seed of the draws among equal moves. The default is one from the operating system.

    Examples
    --------
    >>> import numpy as np
    >>> from matrixworld import Rating, RatingPolicy, World
    >>> chaser = RatingPolicy(Rating(inputs=("adversary",)), np.float32([-1]), seed=0)
    >>> world = World("O", rows=8, cols=8, n_pursuers=2, n_evaders=2)
    >>> chaser(world.inputs()[:2]).shape
    (2,)
    """

    def __init__(
        self, policy: Policy, genome: NDArray[np.float32], *, seed: int | None = None
    ) -> None:
        checks.check_instance("policy", policy, Policy)
        if isinstance(policy, Network):
            raise TypeError(f"policy: expected one that rates moves, got {policy}")
        super().__init__(policy, genome, seed)

    def __call__(self, inputs: ArrayLike) -> Any:
        """Return actions for inputs: an int for one agent, int64 of the leading axes for several.

        The inputs of an agent are all of `INPUTS`, float32 (n_actions, inputs), whichever it uses.
        """
        ratings = np.where(self.allowed(inputs), self.rate(inputs), -np.inf)
        best = ratings == ratings.max(axis=-1, keepdims=True)
        # The largest of random numbers is at any of the best moves, all equally likely.
        actions = np.where(best, self._rng.random(best.shape), -1.0).argmax(axis=-1)
        return actions if actions.ndim else int(actions)

    def rate(self, inputs: ArrayLike) -> NDArray[np.float32]:
        """Return the ratings of all moves, float32 (..., n_actions), for inputs as in a call."""
        return cast("NDArray[np.float32]", self.policy.rate(self.genome, inputs))

    def allowed(self, inputs: ArrayLike) -> NDArray[np.bool_]:
        """Return which moves the mask allows, bool (..., n_actions), for inputs as in a call."""
        return allowed_moves(self.policy.checked(inputs), self.policy.mask)

    def to_python(self) -> str:
        """Return lines of Python that play the same; see `Rating.to_python`."""
        return str(self.policy.to_python(self.genome))


def acting(
    policy: Policy,
    genome: NDArray[np.float32],
    *,
    sampled: bool | None = None,
    seed: int | None = None,
) -> Any:
    """Return a genome of any policy as what acts by it."""
    if isinstance(policy, Network):
        return NetworkPolicy(policy, genome, sampled=sampled, seed=seed)
    if sampled is not None:
        raise ValueError(f"sampled: expected no value for a {policy.kind} policy, got {sampled}")
    return RatingPolicy(policy, genome, seed=seed)


# Files, one npz of numbers each, never code:


def save_genome(path: str | os.PathLike[str], team: Team, policy: GenomePolicy) -> None:
    """Write a policy as a file that `read_genome` reads and that a class tournament plays.

    Parameters
    ----------
    path : str or path
        The file. An older one is replaced.
    team : {"pursuer", "evader"}
        The team that it plays for.
    policy : GenomePolicy
        Such as ``open_run(directory).policy("pursuer")``.
    """
    checks.check_choice("team", team, TEAMS)
    checks.check_instance("policy", policy, GenomePolicy)
    save_arrays(Path(path), {"genome": policy.genome, "team": team, **policy.policy.to_json()})


def read_genome(
    path: str | os.PathLike[str], content: bytes | None = None
) -> tuple[Team, Population]:
    """Return the team of a genome's file, and the genome as a population of one.

    Parameters
    ----------
    path : str or path
        A file of `save_genome`, or of ``numpy.savez`` with the same keys.
    content : bytes, optional
        What the file holds. The default is to read it.

    Raises
    ------
    DamagedFileError
        A ValueError: if the file is not of this form.
    """
    path = Path(path)
    arrays = load_arrays(path, content)
    genome = arrays["genome"]
    if genome.dtype.kind != "f" or genome.ndim != 1:
        expected = "expected an array 'genome' of floats with 1 dimension"
        got = f"got dtype {genome.dtype} and shape {genome.shape}"
        raise DamagedFileError(path, f"{expected}, {got}")
    team = arrays["team"].tolist()
    plain = {"kind": arrays["kind"].tolist()}
    for name, array in arrays.items():
        if name not in ("genome", "team"):
            plain[name] = array.tolist()
    try:
        checks.check_choice("team", team, TEAMS)
        policy = policy_of(plain)
        missing = policy.to_json().keys() - plain
        if missing:
            raise ValueError(f"expected an array {min(missing)!r}, got {', '.join(arrays)}")
        return cast(Team, team), Population(genome, policy)
    except (OverflowError, TypeError, ValueError) as error:
        raise DamagedFileError(path, str(error)) from error


def policy_of(plain: Mapping[str, Any]) -> Policy:
    """Return the policy whose `to_json` is given; ValueError or TypeError for other values."""
    kinds: dict[str, type[Policy]] = {kind.kind: kind for kind in (Network, Rating, Program)}
    values = {
        name: tuple(value) if isinstance(value, list) else value for name, value in plain.items()
    }
    kind: Any = values.pop("kind", Network.kind)
    checks.check_choice("kind", kind, kinds)
    return kinds[kind](**values)
