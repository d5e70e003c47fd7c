"""Actor-critic: the policy gradient of the paper, with generalized advantage estimation.

One actor and one critic for a team, shared by all of its agents. PyTorch is needed, and imported
when a learner is made.

References
----------
Schulman, J., Moritz, P., Levine, S., Jordan, M. and Abbeel, P. (2016). High-dimensional continuous
control using generalized advantage estimation. ICLR.
Schulman, J., Wolski, F., Dhariwal, P., Radford, A. and Klimov, O. (2017). Proximal policy
optimization algorithms. arXiv:1707.06347.
Ray, A., Achiam, J. and Amodei, D. (2019). Benchmarking safe exploration in deep reinforcement
learning. (PPO-Lagrangian.)
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, fields
from functools import partial
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from matrixworld._util.checks import (
    check_bool,
    check_floats,
    check_integer,
    check_number,
    shown,
)
from matrixworld.coevolution.learners.advantages import (
    advantages,
    as_dense,
    critic_rows,
    normalised,
)
from matrixworld.coevolution.learners.experience import Experience, Reals
from matrixworld.coevolution.learners.learner import LearnerEntry, RunSettings
from matrixworld.coevolution.learners.perceptron import Perceptron, Tensor, orthogonal
from matrixworld.coevolution.types import BoolArray, Genome, Genomes, Indices, State, Team
from matrixworld.version import MissingExtraError, install_hint
from matrixworld.world.policy import CHANNELS, Network
from matrixworld.world.rules import Interaction

CHUNK = 16_384
"""Experience that are in the networks at one time. Gradients are sums over all chunks."""


@dataclass(frozen=True)
class Hyperparameters:
    """Settings of an actor-critic learner. The defaults are those of the published implementation.

    Parameters
    ----------
    actor_rate, critic_rate : float, optional
        Learning rates of Adam.
    discount, trace : float, optional
        Gamma and lambda of the advantages.
    actor_updates, critic_updates : int, optional
        Updates an epoch, each with all transitions.
    clip : float, optional
        Range of the clipped probability ratio of PPO; 0 is the plain policy gradient.
    entropy : float, optional
        Weight of the entropy bonus.
    central_critic : bool, optional
        Whether the critics see the whole world instead of an agent's view.
    cost_limit : float, optional
        Collisions at fault per 1000 agent-steps that are allowed. A Lagrangian multiplier weighs
        costs against rewards so that they approach the limit. By default costs are ignored.
    cost_rate : float, optional
        Learning rate of the multiplier.
    device : str, optional
        Device of PyTorch, such as "cpu" or "cuda".
    """

    actor_rate: float = 3e-4
    critic_rate: float = 1e-3
    discount: float = 0.99
    trace: float = 0.97
    actor_updates: int = 1
    critic_updates: int = 5
    clip: float = 0.0
    entropy: float = 0.0
    central_critic: bool = False
    cost_limit: float | None = None
    cost_rate: float = 0.05
    device: str = "cpu"


class ActorCritic:
    """Actor-critic: policy gradient with generalized advantage estimation.

    ::

        play:    matches of the actor, whose agents' transitions are collected
        critic:  V = critic(view);  returns R = rewards to go, with V at the end of the time
        actor:   ascend  mean( log p(action | view) * A ),  A normalised over all transitions
        critic:  descend mean( (V - R)^2 )

    With `clip`, the actor ascends the clipped objective of PPO. With `cost_limit` a second critic
    estimates advantages C of costs, and the actor follows (A - m C) / (1 + m), where the multiplier
    m >= 0 rises while there are more collisions than the limit.

    Parameters
    ----------
    genome : array_like of float32, shape (genes,)
        Weights of the actor to start from.
    network : Network
        The actor.
    samples : int
        Matches of an epoch.
    rng : numpy.random.Generator
        Draws the first weights of the critics.
    chosen : Hyperparameters, optional
        All other settings.
    state_size : int, optional
        Numbers in a state of the world, which a central critic sees.
    fixed : ndarray of bool, shape (genes,), optional
        Weights of the actor that do not change, such as those of a mask. By default none.

    Attributes
    ----------
    genome : ndarray of float32, shape (genes,)
        Weights of the actor.
    multiplier : float
        The Lagrangian multiplier.

    Raises
    ------
    MissingExtraError
        If PyTorch is not installed.
    ValueError
        If PyTorch cannot use the device.
    """

    def __init__(
        self,
        genome: ArrayLike,
        network: Network,
        samples: int,
        rng: np.random.Generator,
        chosen: Hyperparameters | None = None,
        state_size: int = 0,
        fixed: BoolArray | None = None,
    ) -> None:
        self.chosen = Hyperparameters() if chosen is None else chosen
        self._device = _usable_device(self._torch, self.chosen.device)
        self._actor = Perceptron(
            check_floats("genome", genome, np.float32),
            network.sizes,
            network.activation,
            self.chosen.actor_rate,
            fixed,
        )
        inputs = state_size if self.chosen.central_critic else network.sizes[0]
        sizes = (inputs, *network.hidden, 1)
        names = ["critic"] if self.chosen.cost_limit is None else ["critic", "cost_critic"]
        self._critics = {
            name: Perceptron(
                orthogonal(sizes, rng), sizes, network.activation, self.chosen.critic_rate
            )
            for name in names
        }
        self.samples = samples
        self.multiplier = 0.0

    @property
    def _torch(self) -> Any:
        # Not an attribute: a module cannot be pickled.
        return _import_torch()

    @property
    def genome(self) -> Genome:
        """Weights of the actor, (genes,)."""
        return self._actor.weights

    @property
    def match_of_candidate(self) -> Indices:
        """Each match has a seed of its own."""
        return np.arange(self.samples)

    @property
    def sees_states(self) -> bool:
        """Whether the critic needs the states of the worlds."""
        return self.chosen.central_critic

    def ask(self, rng: np.random.Generator) -> Genomes:
        """Return the actor once for each match."""
        return np.repeat(self.genome[np.newaxis], self.samples, axis=0)

    def tell(self, fitness: ArrayLike) -> None:
        """Do nothing: this learner has learned from the transitions, and fitness is for the log."""

    def learn(self, experience: Experience) -> None:
        """Improve actor and critics by the transitions of one epoch."""
        # With more threads PyTorch adds in another order: results would depend on the machine's
        # cores.
        before = self._torch.get_num_threads()
        self._torch.set_num_threads(1)
        try:
            self._learn(experience)
        finally:
            self._torch.set_num_threads(before)

    def _learn(self, experience: Experience) -> None:
        chosen, acted = self.chosen, experience.acted
        rows = critic_rows(experience, central=chosen.central_critic)
        signals = {"critic": experience.rewards, "cost_critic": experience.costs}
        estimates = {}
        for name, critic in self._critics.items():
            values = rows.dense(self._values(critic, rows.inputs))
            signal = as_dense(acted, signals[name])
            estimate = partial(advantages, acted, signal, values, chosen.discount)
            estimates[name] = normalised(estimate(chosen.trace)[acted])
            returns = rows.targets(estimate(1.0) + values[:-1])
            self._fit(critic, rows.learned, returns)
        advantage: Any = estimates["critic"]
        if chosen.cost_limit is not None:
            self._weigh(1000.0 * float(experience.costs.mean()))
            advantage = (advantage - self.multiplier * estimates["cost_critic"]) / (
                1.0 + self.multiplier
            )
        self._improve(experience, advantage.astype(np.float32))

    def _weigh(self, collisions: float) -> None:
        """Move the multiplier by the distance of the collisions from their limit."""
        limit = float(self.chosen.cost_limit or 0.0)
        # As a share of the limit, so that the rate means the same for all limits; at most 1, or the
        # multiplier rises in the first epochs by more than it can fall in the rest of a run.
        excess = min((collisions - limit) / max(limit, 1.0), 1.0)
        self.multiplier = max(0.0, self.multiplier + self.chosen.cost_rate * excess)

    def _improve(self, experience: Experience, advantage: Reals) -> None:
        """Update the actor."""
        torch, clip, entropy = self._torch, self.chosen.clip, self.chosen.entropy
        actions = torch.from_numpy(experience.actions).to(self._device)
        weight = torch.from_numpy(advantage).to(self._device)
        before: list[Tensor] = []

        def objective(weights: Tensor, part: slice, number: int) -> Tensor:
            logits = self._actor.outputs(weights, self._tensor(experience.views[part]))
            logs = logits.log_softmax(dim=1)
            taken = logs.gather(1, actions[part, None])[:, 0]
            if number == len(before):
                before.append(taken.detach())
            # Without a clip this is the gradient of log p; with it, of PPO's objective.
            ratio = (taken - before[number]).exp() if clip else taken
            gain = ratio * weight[part]
            if clip:
                gain = torch.minimum(gain, ratio.clamp(1 - clip, 1 + clip) * weight[part])
            return gain.sum() - entropy * (logs.exp() * logs).sum()

        for _ in range(self.chosen.actor_updates):
            self._actor.ascend(self._gradient(self._actor, len(advantage), objective))

    def _fit(self, critic: Perceptron, inputs: NDArray[np.uint8], returns: Reals) -> None:
        """Update a critic."""
        target = self._torch.from_numpy(returns.astype(np.float32)).to(self._device)

        def objective(weights: Tensor, part: slice, number: int) -> Tensor:
            values = critic.outputs(weights, self._tensor(inputs[part]))[:, 0]
            return -((values - target[part]) ** 2).sum()

        for _ in range(self.chosen.critic_updates):
            critic.ascend(self._gradient(critic, len(returns), objective))

    def _gradient(self, part: Perceptron, n: int, objective: Objective) -> Genome:
        """Return the gradient of the mean objective over n transitions."""
        weights = self._torch.from_numpy(part.weights).to(self._device).requires_grad_()
        for number, start in enumerate(range(0, n, CHUNK)):
            (objective(weights, slice(start, start + CHUNK), number) / n).backward()
        gradient: Genome = weights.grad.cpu().numpy()
        return gradient

    def _values(self, critic: Perceptron, inputs: NDArray[np.uint8]) -> Reals:
        with self._torch.no_grad():
            weights = self._torch.from_numpy(critic.weights).to(self._device)
            parts = [
                critic.outputs(weights, self._tensor(inputs[start : start + CHUNK]))[:, 0].cpu()
                for start in range(0, len(inputs), CHUNK)
            ]
            values: Reals = self._torch.cat(parts).numpy()
        return values

    def _tensor(self, rows: NDArray[np.uint8]) -> Tensor:
        return self._torch.from_numpy(rows).to(self._device).float()

    def state(self) -> State:
        """Return the weights, the averages of Adam, and the multiplier."""
        parts = {"actor": self._actor, **self._critics}
        return {
            "multiplier": np.array(self.multiplier),
            **{f"{name}_weights": part.weights for name, part in parts.items()},
            **{
                f"{name}_{key}": value
                for name, part in parts.items()
                for key, value in part.adam.state().items()
            },
        }

    def restore(self, state: State) -> None:
        """Restore a state returned by `state()`."""
        self.multiplier = float(state["multiplier"])
        for name, part in {"actor": self._actor, **self._critics}.items():
            part.weights = state[f"{name}_weights"].astype(np.float32)
            part.adam.restore({key: state[f"{name}_{key}"] for key in part.adam.state()})


Objective = Callable[..., Any]
"""Takes the weights, a slice of the transitions and its number; returns a sum to maximise."""


def _import_torch() -> Any:
    try:
        import torch
    except ImportError as error:
        needed = "The learner actor-critic needs PyTorch"
        raise MissingExtraError(f"{needed}: {install_hint('torch')}") from error
    return torch


def _usable_device(torch: Any, name: str) -> Any:
    """Return a device of PyTorch; ValueError if this machine lacks it."""
    try:
        # A device has a name even if PyTorch cannot compute there.
        torch.zeros(1, device=name).cpu()
    except (AssertionError, NotImplementedError, RuntimeError) as error:
        expected = "expected a device that PyTorch has on this machine, such as 'cpu'"
        raise ValueError(f"device: {expected}, got {shown(name)}") from error
    return torch.device(name)


def _check(settings: RunSettings) -> None:
    interaction = settings.rules.interaction
    if interaction is not Interaction.SIMULTANEOUS:
        raise ValueError(
            f"variant: expected one whose agents act at the same time with actor-critic, got "
            f"{interaction.name}"
        )


def _check_device(name: str, value: Any) -> None:
    if not isinstance(value, str):
        raise TypeError(f"{name}: expected the name of a device of PyTorch, got {shown(value)}")


def _new(
    settings: RunSettings, team: Team, genomes: Genomes, rng: np.random.Generator
) -> ActorCritic:
    world = settings.world(settings.train_steps)
    chosen = {item.name: getattr(settings, item.name) for item in fields(Hyperparameters)}
    return ActorCritic(
        genomes[0],
        settings.network,
        settings.population,
        rng,
        Hyperparameters(**chosen),
        state_size=CHANNELS * world.rows * world.cols,
        fixed=settings.fixed_genes(team),
    )


_positive = partial(check_number, least=0.0, positive=True)
_count = partial(check_integer, low=1)

ENTRY = LearnerEntry(
    title="policy gradients, needs PyTorch",
    settings={
        "actor_rate": _positive,
        "critic_rate": _positive,
        "discount": partial(check_number, least=0.0, most=1.0),
        "trace": partial(check_number, least=0.0, most=1.0),
        "actor_updates": _count,
        "critic_updates": _count,
        "clip": partial(check_number, least=0.0),
        "entropy": partial(check_number, least=0.0),
        "central_critic": check_bool,
        "cost_rate": _positive,
        "device": _check_device,
    },
    check=_check,
    new=_new,
    keeps_fixed_genes=True,
    by_gradients=True,
    like_processors=True,
    # Networks and epochs of the published experiments: an epoch is one episode of 500 steps.
    defaults={
        "hidden": (400, 300),
        "population": 1,
        "train_steps": 500,
        "pursuer_epochs": 400,
        "evader_epochs": 400,
        "joint_epochs": 400,
        "epochs": 1200,
    },
)
