"""Actor-critic: the policy gradient of the paper, with generalized advantage estimation.

One actor and one critic for a team, shared by all of its agents. PyTorch is needed, and imported
when a learner is made.

References
----------
Schulman et al. 2016, "High-dimensional continuous control using generalized advantage estimation",
ICLR. Schulman et al. 2017, "Proximal policy optimization algorithms", arXiv:1707.06347. Ray et al.
2019, "Benchmarking safe exploration in deep reinforcement learning" (PPO-Lagrangian).
"""

from __future__ import annotations

from collections.abc import Callable
from itertools import chain, cycle, islice
from typing import Any, ClassVar, NamedTuple, TypeAlias

import numpy as np
from numpy.typing import NDArray

from matrixworld._util.checks import shown
from matrixworld._util.constraints import Range, Whole
from matrixworld._util.sections import SettingError, section, setting
from matrixworld.coevolution import seeding, types
from matrixworld.coevolution.games.game import Game
from matrixworld.coevolution.games.policies import Cells
from matrixworld.coevolution.games.pursuit import (
    CHANNELS,
    Experience,
    Interaction,
    Network,
    Pursuit,
    Reals,
    Views,
)
from matrixworld.coevolution.learners import learner
from matrixworld.coevolution.learners.networks import (
    Inputs,
    Perceptron,
    Tensor,
    Trained,
    orthogonal,
)
from matrixworld.coevolution.learners.optimizers import annealed
from matrixworld.coevolution.types import TEAMS, BoolArray, Genome, Genomes, Indices, Rng, Team
from matrixworld.version import imported

CHUNK = 2**20
"""Outputs of the widest layer that are computed at one time: larger ones leave a core's cache.
Gradients are sums over all chunks."""
COST_RATE = 0.05  # learning rate of the multiplier, unless another one is given
SMALL = 1e-8  # added to a standard deviation by which is divided


def advantages(
    acted: types.BoolArray, rewards: Reals, values: Reals, discount: float, trace: float
) -> Reals:
    """Return generalized advantage estimates (T, W, A), 0 where no agent acted.

    `values` (T + 1, W, A) are those before each step, and after the last one; 0 for agents that are
    gone. Schulman et al. 2016, equations 11 and 16.
    """
    # d_t = r_t + discount * V(s_{t+1}) - V(s_t);  A_t = d_t + discount * trace * A_{t+1}
    estimates = np.zeros_like(rewards)
    following = np.zeros_like(rewards[0])
    for t in range(len(rewards) - 1, -1, -1):
        change = rewards[t] + discount * values[t + 1] - values[t]
        following = np.where(acted[t], change + discount * trace * following, 0.0)
        estimates[t] = following
    return estimates


def dense_values(e: Experience, before: Reals, after: Reals) -> Reals:
    """Return a critic's values of its rows as (T + 1, W, A)."""
    steps, worlds, agents = e.acted.shape
    if e.states is not None:
        # The value of a state is that of all agents in it.
        before = before.reshape(steps, worlds)[np.nonzero(e.acted)[:2]]
        after = after[np.nonzero(e.last)[1]]
    # What follows an agent's last step is 0, unless only its time was over.
    dense = np.zeros((steps + 1, worlds, agents), np.float32)
    dense[:-1][e.acted] = before
    dense[1:][e.last] = after
    return dense


def critic_targets(e: Experience, returns: Reals) -> Reals:
    """Return what a critic should say of the rows that it learns from, of returns (T, W, A)."""
    if e.states is None:
        return returns[e.acted]
    # One value for all agents of the team: the mean of what they earn.
    agents = np.maximum(e.acted.sum(axis=2), 1)
    means: NDArray[Any] = returns.sum(axis=2, where=e.acted) / agents
    return means[e.acted.any(axis=2)]


def normalised(values: Reals) -> Reals:
    """Return values with mean 0 and standard deviation 1."""
    centred = values - values.mean(dtype=np.float64)
    return np.asarray(centred / (centred.std() + SMALL), np.float32)


Part: TypeAlias = list[tuple[Inputs, slice]]
"""Transitions of one update, in chunks: what the network sees, and which transitions they are."""
Objective = Callable[[Tensor, Inputs, slice], Tensor]
"""Takes the weights and a chunk of a part; returns a sum to maximise."""


class CriticRows(NamedTuple):
    """What critics see in an epoch: views of agents, or states of the world."""

    before: list[Part]  # the steps
    after: list[Part]  # the last steps
    learned: list[Part]  # those before the steps in which an agent acts, from which they learn


class State(NamedTuple):
    """Actor and critics, and what is known of them: sizes of layers, and the activation."""

    actor: Trained
    critic: Trained
    cost_critic: Trained | None
    multiplier: NDArray[np.float64]
    sizes: NDArray[np.int64]  # of the layers of the actor
    value_sizes: NDArray[np.int64]  # of the layers of the critics
    tanh: NDArray[np.bool_]  # whether this is the activation, and not relu
    fixed: BoolArray | None  # weights of the actor that its mask fixes
    epochs: NDArray[np.int64] | None  # in which the learning rates fall


@section("actor-critic")
class ActorCritic(learner.Learner):
    """Actor-critic: policy gradient with generalized advantage estimation.

    ::

        play:    matches of the actor, whose agents' transitions are collected
        critic:  V = critic(view);  returns R = rewards to go, with V at the end of the time
        actor:   ascend  mean( log p(action | view) * A ),  A normalised over all transitions
        critic:  descend mean( (V - R)^2 )

    With `clip`, the actor ascends the clipped objective of PPO. With `cost_limit` a second critic
    estimates advantages C of costs, and the actor follows (A - m C) / (1 + m), where the multiplier
    m >= 0 rises while there are more collisions than the limit. Defaults are those of the published
    implementation.
    """

    policies: ClassVar[tuple[str, ...]] = ("cells",)
    any_game: ClassVar[bool] = False
    keeps_mask: ClassVar[bool] = True
    replays: ClassVar[bool] = True
    learning_time: ClassVar[float] = 40.0
    steps: ClassVar[tuple[str, ...]] = ("actor_rate", "critic_rate")

    population: int = setting(1, "matches per epoch", Whole(1))
    actor_rate: float = setting(3e-4, "learning rate of the actor", Range(open=True))
    critic_rate: float = setting(1e-3, "learning rate of the critic", Range(open=True))
    discount: float = setting(0.99, "discount factor of rewards (gamma)", Range(most=1.0))
    trace: float = setting(0.97, "discount factor of advantages (lambda)", Range(most=1.0))
    actor_updates: int = setting(1, "updates of the actor in an epoch", Whole(1))
    critic_updates: int = setting(5, "updates of the critic in an epoch", Whole(1))
    minibatches: int = setting(
        1, "parts of an epoch's transitions; each update takes the next one", Whole(1)
    )
    clip: float = setting(0.0, "clip range of PPO; 0: plain policy gradient")
    entropy: float = setting(0.0, "weight of the entropy bonus")
    anneal: bool = setting(False, "reduce the learning rates linearly to a tenth over the run")
    central_critic: bool = setting(False, "let the critic see the whole world")
    cost_limit: float | None = setting(
        None,
        "collisions at fault per 1000 agent-steps, approached by a Lagrangian multiplier; "
        "default: no limit",
    )
    cost_rate: float | None = setting(
        None,
        f"learning rate of the multiplier, with a cost_limit; default: {COST_RATE}",
        Range(open=True),
    )
    device: str = setting("cpu", "device of PyTorch, such as cuda")

    def check(self) -> None:
        """Raise SettingError for a multiplier that nothing uses, or parts that nothing learns."""
        updates = min(self.actor_updates, self.critic_updates)
        if self.minibatches > updates:
            expected = f"at most {updates}, as many as updates of actor and critic in an epoch"
            raise SettingError("minibatches", expected, str(self.minibatches))
        if self.cost_rate is not None and self.cost_limit is None:
            raise SettingError("cost_rate", "no value without cost_limit", f"{self.cost_rate:g}")

    def check_fits(self, path: str, game: Game) -> None:
        """Raise SettingError for networks with memory, or one critic for agents that take turns."""
        assert isinstance(game, Pursuit)  # as its `any_game` says
        interaction = game.world.rules.interaction
        # In turns, each agent learns from the world before its own one.
        if self.central_critic and interaction is not Interaction.SIMULTANEOUS:
            raise SettingError(
                f"{path}.central_critic",
                "false where agents take turns",
                f"true in a world of {interaction.name}",
            )
        memory = getattr(game.settings, "memory", "none")
        if memory != "none":
            expected = "none with actor-critic, which learns from each step by itself"
            raise SettingError("policy.memory", expected, memory)

    def untrained(self, game: Game, team: Team, rng: Rng) -> Genome:
        """Return orthogonal weights: gradients vanish or explode from other beginnings."""
        assert isinstance(game, Pursuit)  # as checked
        network = game.policies[team]
        assert isinstance(network, Network)
        assert isinstance(game.settings, Cells)
        return orthogonal(network.sizes, rng, head=game.settings.initial_head)

    @property
    def seed_groups(self) -> Indices:
        """Each match has a seed of its own."""
        return np.arange(self.population)

    def check_machine(self) -> None:
        """Raise an error if PyTorch is not installed, or lacks the device here."""
        _usable_device(self.device)

    def start(self, task: learner.Task) -> State:
        """Return the multiplier, and weights and averages of Adam of actor and critics."""
        self.check_machine()
        assert isinstance(task.game, Pursuit)  # as checked
        world = task.game.world
        network = task.game.policies[TEAMS[task.team]]
        assert isinstance(network, Network)
        cells = world.rows * world.cols
        seen = CHANNELS * cells if self.central_critic else network.sizes[0]
        sizes = (seen, *network.hidden, 1)
        rng = seeding.keyed_generator(task.seed, seeding.Purpose.NOISE, task.team)
        critic = orthogonal(sizes, rng)
        return State(
            actor=Trained.start(np.array(task.genomes(1)[0], np.float32)),
            critic=Trained.start(critic),
            cost_critic=None if self.cost_limit is None else Trained.start(orthogonal(sizes, rng)),
            multiplier=np.array(0.0),
            sizes=np.array(network.sizes),
            value_sizes=np.array(sizes),
            tanh=np.array(network.activation == "tanh"),
            fixed=None if task.mask is None else task.mask.fixed,
            epochs=np.array(task.epochs) if self.anneal else None,
        )

    def genome(self, state: State) -> Genome:
        """Return the weights of the actor."""
        return state.actor.weights

    def ask(self, state: State, rng: Rng) -> tuple[Genomes, State]:
        """Return the actor once for each match."""
        return np.repeat(self.genome(state)[np.newaxis], self.population, axis=0), state

    def tell(self, state: State, results: learner.Results) -> State:
        """Learn from the transitions of the matches; their fitness is for the log alone."""
        update = Update(self, state)
        update.learn(results.experience(states=self.central_critic))
        return update.state()


class Update:
    """One epoch of learning: the networks of a state, which move, and their new state."""

    def __init__(self, settings: ActorCritic, state: State) -> None:
        self.settings = settings
        self._torch = imported("torch", "torch")
        self._device = _usable_device(settings.device)
        self._before = state
        activation = "tanh" if state.tanh else "relu"
        self._actor = Perceptron(
            state.actor, state.sizes, activation, settings.actor_rate, state.fixed
        )
        rate = settings.critic_rate
        self._critic = Perceptron(state.critic, state.value_sizes, activation, rate)
        self._cost_critic: Perceptron | None = None
        if state.cost_critic is not None:
            self._cost_critic = Perceptron(state.cost_critic, state.value_sizes, activation, rate)
        self.multiplier = float(state.multiplier)
        self._share = 1.0  # of the learning rates that is left in this epoch
        if state.epochs is not None:
            updates = int(state.actor.adam.updates) // settings.actor_updates
            self._share = annealed(updates, int(state.epochs))

    def state(self) -> State:
        """Return the state after the update."""
        return self._before._replace(
            actor=self._actor.trained,
            critic=self._critic.trained,
            cost_critic=None if self._cost_critic is None else self._cost_critic.trained,
            multiplier=np.array(self.multiplier),
        )

    @np.errstate(over="ignore", invalid="ignore")  # a run reports genes that are not finite
    def learn(self, experience: Experience) -> None:
        """Improve actor and critics by the transitions of one epoch."""
        # With more threads PyTorch adds in another order: results would depend on the machine's
        # cores.
        before = self._torch.get_num_threads()
        self._torch.set_num_threads(1)
        try:  # also where a caller has switched gradients off
            with self._torch.inference_mode(mode=False), self._torch.enable_grad():
                self._learn(experience)
        finally:
            self._torch.set_num_threads(before)

    def _learn(self, e: Experience) -> None:
        rows = self._critic_rows(e)
        advantage = self._advantage_and_fit(self._critic, e, e.rewards, rows)
        if self._cost_critic is not None:
            cost_advantage = self._advantage_and_fit(self._cost_critic, e, e.costs, rows)
            self._adapt_multiplier(e.costs)
            m = self.multiplier
            advantage = np.asarray((advantage - m * cost_advantage) / (1.0 + m), np.float32)
        views = rows.before if e.states is None else self._parts(e.views)
        self._improve(views, e.actions, advantage)

    def _critic_rows(self, e: Experience) -> CriticRows:
        """Return what critics see: views of the agents that act, or with a central one states."""
        if e.states is None or e.last_states is None:
            views = self._parts(e.views)
            return CriticRows(views, self._parts(e.last_views), views)
        states = e.states.reshape(-1, e.states.shape[-1])
        acted = e.acted.any(axis=2).ravel()
        return CriticRows(
            self._parts(states), self._parts(e.last_states), self._parts(states[acted])
        )

    def _advantage_and_fit(
        self, critic: Perceptron, e: Experience, signal: Reals, rows: CriticRows
    ) -> Reals:
        """Return normalised advantages (n,) of rewards or costs (n,), and let the critic learn."""
        earned = np.zeros(e.acted.shape, np.float32)
        earned[e.acted] = signal
        before = self._values(critic, rows.before)
        values = dense_values(e, before, self._values(critic, rows.after))
        discount = self.settings.discount
        estimates = advantages(e.acted, earned, values, discount, self.settings.trace)
        # With a trace of 1 an advantage is the return minus the value.
        returns = advantages(e.acted, earned, values, discount, 1.0) + values[:-1]
        self._fit(critic, rows.learned, critic_targets(e, returns))
        return normalised(estimates[e.acted])

    def _adapt_multiplier(self, costs: Reals) -> None:
        """Raise the multiplier if there are more collisions than the limit, else lower it."""
        limit = self.settings.cost_limit
        assert limit is not None  # since there is a critic of costs
        # As a share of the limit, so that the rate means the same for all limits; at most 1: it
        # would rise in the first epochs by more than it can fall in the rest of a run.
        excess = min((1000.0 * float(costs.mean()) - limit) / max(limit, 1.0), 1.0)
        rate = self.settings.cost_rate or COST_RATE
        self.multiplier = max(0.0, self.multiplier + rate * excess)

    def _improve(self, views: list[Part], taken: types.IntArray, advantage: Reals) -> None:
        """Let the actor learn from the actions (n,) that were taken, and their advantages (n,)."""
        torch = self._torch
        clip = self.settings.clip
        entropy = self.settings.entropy
        actions = torch.from_numpy(taken).to(self._device)
        weight = torch.from_numpy(advantage).to(self._device)
        before = torch.empty_like(weight)  # log p of the actions before the first update

        def logs_of(weights: Tensor, inputs: Inputs, part: slice) -> tuple[Tensor, Tensor]:
            logs = self._actor.outputs(weights, inputs).log_softmax(dim=1)
            return logs, logs.gather(1, actions[part, None])[:, 0]

        def objective(weights: Tensor, inputs: Inputs, part: slice) -> Tensor:
            logs, own = logs_of(weights, inputs, part)
            # Without a clip this is the gradient of log p; with it, of PPO's objective.
            ratio = (own - before[part]).exp() if clip else own
            gain = ratio * weight[part]
            if clip:
                gain = torch.minimum(gain, ratio.clamp(1 - clip, 1 + clip) * weight[part])
            return gain.sum() - entropy * (logs.exp() * logs).sum()

        if clip:
            with torch.no_grad():
                weights = torch.from_numpy(self._actor.weights).to(self._device)
                for inputs, part in chain.from_iterable(views):
                    before[part] = logs_of(weights, inputs, part)[1]
        self._ascend(self._actor, views, self.settings.actor_updates, objective)

    def _fit(self, critic: Perceptron, rows: list[Part], targets: Reals) -> None:
        """Let a critic learn to say the targets (n,) of its rows."""
        target = self._torch.from_numpy(targets.astype(np.float32)).to(self._device)

        def objective(weights: Tensor, inputs: Inputs, part: slice) -> Tensor:
            values = critic.outputs(weights, inputs)[:, 0]
            return -((values - target[part]) ** 2).sum()

        self._ascend(critic, rows, self.settings.critic_updates, objective)

    def _ascend(
        self, network: Perceptron, parts: list[Part], updates: int, objective: Objective
    ) -> None:
        """Make so many steps up the gradient of the mean objective, each over the next part."""
        for part in islice(cycle(parts), updates):
            weights = self._torch.from_numpy(network.weights).to(self._device).requires_grad_()
            n = sum(inputs.rows for inputs, _ in part)
            for inputs, place in part:
                (objective(weights, inputs, place) / n).backward()
            network.ascend(weights.grad.cpu().numpy(), self._share)

    def _values(self, critic: Perceptron, parts: list[Part]) -> Reals:
        """Return what a critic says of rows."""
        values = np.empty(sum(inputs.rows for inputs, _ in chain.from_iterable(parts)), np.float32)
        with self._torch.no_grad():
            weights = self._torch.from_numpy(critic.weights).to(self._device)
            for inputs, place in chain.from_iterable(parts):
                values[place] = critic.outputs(weights, inputs)[:, 0].cpu().numpy()
        return values

    def _parts(self, rows: Views) -> list[Part]:
        """Return the minibatches of rows: every m-th row, in chunks."""
        m = self.settings.minibatches
        n = len(rows)
        step = m * max(1, CHUNK // max(self._actor.sizes[1:]))
        parts: list[Part] = []
        for first in range(min(m, n)):
            places = [slice(at, min(at + step, n), m) for at in range(first, n, step)]
            parts.append([(Inputs(rows[at], self._torch, self._device), at) for at in places])
        return parts


def _usable_device(name: str) -> Any:
    """Return a device of PyTorch; ValueError if this machine lacks it."""
    torch = imported("torch", "torch")
    try:
        # A device has a name even if PyTorch cannot compute there.
        torch.zeros(1, device=name).cpu()
    except (AssertionError, NotImplementedError, RuntimeError) as error:
        expected = "expected a device that PyTorch has on this machine, such as 'cpu'"
        raise ValueError(f"device: {expected}, got {shown(name)}") from error
    return torch.device(name)
