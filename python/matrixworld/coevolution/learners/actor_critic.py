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

import warnings
from collections.abc import Callable, Mapping
from functools import partial
from itertools import chain, cycle, islice, pairwise
from math import sqrt
from typing import Any, ClassVar, TypeAlias

import numpy as np

from matrixworld._util import checks
from matrixworld.coevolution import pursuit, seeding, types
from matrixworld.coevolution.game import Game
from matrixworld.coevolution.learners import learner
from matrixworld.coevolution.pursuit import Cells, Experience, Network, Pursuit, Reals, Views
from matrixworld.coevolution.sections import section, setting
from matrixworld.coevolution.types import Genome, Genomes, Indices, Rng, State, Team
from matrixworld.version import imported

CHUNK = 2**20
"""Outputs of the widest layer that are computed at one time: larger ones leave a core's cache.
Gradients are sums over all chunks."""
COST_RATE = 0.05  # learning rate of the multiplier, unless another one is given
SMALL = 1e-8  # added to a standard deviation by which is divided

Tensor: TypeAlias = Any  # a ``torch.Tensor``: PyTorch may be missing where types are checked


def advantages(
    acted: types.BoolArray, rewards: Reals, values: Reals, discount: float, trace: float
) -> Reals:
    """Return generalized advantage estimates (T, W, A), 0 where no agent acted.

    `values` (T + 1, W, A) are those before each step, and after the last one; 0 for agents that are
    gone. Schulman et al. 2016, equations 11 and 16.
    """
    # d_t = r_t + discount * V(s_{t+1}) - V(s_t);  A_t = d_t + discount * trace * A_{t+1}
    found = np.zeros_like(rewards)
    following = np.zeros_like(rewards[0])
    for t in range(len(rewards) - 1, -1, -1):
        change = rewards[t] + discount * values[t + 1] - values[t]
        following = np.where(acted[t], change + discount * trace * following, 0.0)
        found[t] = following
    return found


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


def lessons(e: Experience, rows: Views, returns: Reals) -> tuple[Views, Reals]:
    """Return the rows (k, inputs) that a critic learns from, and its targets (k,)."""
    if e.states is None:
        return rows, returns[e.acted]
    # One value for all agents of the team: the mean of what they earn.
    going, agents = e.acted.any(axis=2), np.maximum(e.acted.sum(axis=2), 1)
    return rows[going.ravel()], (returns.sum(axis=2, where=e.acted) / agents)[going]


def normalised(values: Reals) -> Reals:
    """Return values with mean 0 and standard deviation 1."""
    centred = values - values.mean(dtype=np.float64)
    return np.asarray(centred / (centred.std() + SMALL), np.float32)


class Inputs:
    """Rows (n, in) of zeros and ones that a network sees; ``inputs(weights)`` multiplies them."""

    # A view has few ones. The processor multiplies these alone, and keeps them sorted by row for
    # the products and by column for the gradient; PyTorch's own gradient sorts them each time.
    def __init__(self, rows: Views, torch: Any, device: Any) -> None:
        self.rows: int = len(rows)
        if device.type != "cpu":
            kept = torch.from_numpy(np.ascontiguousarray(rows)).to(device)
            self._product: Callable[[Tensor], Tensor] = lambda weights: kept.float() @ weights
            return
        by_row, by_column = _sparse(rows, torch), _sparse(rows.T, torch)

        class Product(torch.autograd.Function):  # type: ignore[misc]  # PyTorch may be missing
            @staticmethod
            def forward(_: Any, weights: Tensor) -> Tensor:
                return by_row @ weights

            @staticmethod
            def backward(_: Any, gradient: Tensor) -> Tensor:
                return by_column @ gradient

        self._product = Product.apply

    def __call__(self, weights: Tensor) -> Tensor:
        """Return the products (n, out) with weights (in, out)."""
        return self._product(weights)


Part: TypeAlias = list[tuple[Inputs, slice]]
"""Transitions of one update, in chunks: what the network sees, and which transitions they are."""
Objective = Callable[[Tensor, Inputs, slice], Tensor]
"""Takes the weights and a chunk of a part; returns a sum to maximise."""


def _sparse(rows: Views, torch: Any) -> Tensor:
    """Return rows (n, m) of zeros and ones as a sparse tensor of float32."""
    row, column = np.divmod(np.flatnonzero(np.ascontiguousarray(rows)), rows.shape[1])
    starts = np.searchsorted(row, np.arange(len(rows) + 1))
    parts = (starts, column, np.ones(len(column), np.float32))
    with warnings.catch_warnings():  # PyTorch calls this form a beta
        warnings.simplefilter("ignore", UserWarning)
        return torch.sparse_csr_tensor(*map(torch.from_numpy, parts), size=rows.shape)


class Perceptron:
    """A network that learns by Adam, of the entries of a state whose names begin with `name`.

    Its weights are one vector, in the layout of a genome.
    """

    def __init__(
        self, name: str, state: State, sizes: tuple[int, ...], activation: str, rate: float
    ) -> None:
        self.sizes, self.activation, self.rate, self._prefix = sizes, activation, rate, f"{name}_"
        self.state: State = {n: each for n, each in state.items() if n.startswith(self._prefix)}
        self.fixed: types.BoolArray | None = state.get("fixed") if name == "actor" else None

    @property
    def weights(self) -> Genome:
        """The weights (genes,)."""
        return self.state[f"{self._prefix}weights"]

    def outputs(self, weights: Tensor, inputs: Inputs) -> Tensor:
        """Return the outputs (n, out) for inputs (n, in); `weights` is a tensor of the vector."""
        start, last, rows = 0, len(self.sizes) - 2, None
        for number, (n_in, n_out) in enumerate(pairwise(self.sizes)):
            middle, end = start + n_in * n_out, start + (n_in + 1) * n_out
            matrix = weights[start:middle].view(n_in, n_out)
            rows = (inputs(matrix) if rows is None else rows @ matrix) + weights[middle:end]
            if number < last:
                rows = rows.relu() if self.activation == "relu" else rows.tanh()
            start = end
        return rows

    def ascend(self, gradient: Genome, share: float = 1.0) -> None:
        """Make one step of Adam, at a share of the learning rate."""
        if self.fixed is not None:
            gradient = np.where(self.fixed, np.float32(0.0), gradient)
        change, averages = learner.adam(self.state, gradient, share * self.rate, self._prefix)
        self.state = {**averages, f"{self._prefix}weights": self.weights + change}


def orthogonal(sizes: tuple[int, ...], rng: Rng, *, head: float = 1.0) -> Genome:
    """Return orthogonal matrices and biases of 0, in the layout of a genome: Saxe et al. 2014.

    The last layer is scaled by `head`, the others by the square root of 2.
    """
    parts = []
    for number, (n_in, n_out) in enumerate(pairwise(sizes)):
        large, small = max(n_in, n_out), min(n_in, n_out)
        q, r = np.linalg.qr(rng.standard_normal((large, small)))
        q *= np.sign(np.diag(r))
        matrix = q if n_in >= n_out else q.T
        scale = head if number == len(sizes) - 2 else sqrt(2.0)
        parts += [scale * matrix.ravel(), np.zeros(n_out)]
    return np.concatenate(parts).astype(np.float32)


@section
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

    kind: ClassVar[str] = "actor-critic"
    policies: ClassVar[tuple[str, ...]] = ("cells",)
    any_game: ClassVar[bool] = False
    ignores: ClassVar[tuple[str, ...]] = ("fitness", "policy.initial_weight")
    defaults: ClassVar[Mapping[str, Any]] = {
        "policy.hidden": (400, 300),
        "train_steps": 500,
        "schedule.pursuer_epochs": 400,
        "schedule.evader_epochs": 400,
        "schedule.joint_epochs": 400,
        "schedule.epochs": 1200,
    }
    learning_time: ClassVar[float] = 40.0
    steps: ClassVar[tuple[str, ...]] = ("actor_rate", "critic_rate")

    population: int = setting(1, "matches per epoch", least=1)
    actor_rate: float = setting(3e-4, "learning rate of the actor", positive=True)
    critic_rate: float = setting(1e-3, "learning rate of the critic", positive=True)
    discount: float = setting(0.99, "discount factor of rewards (gamma)", most=1.0)
    trace: float = setting(0.97, "discount factor of advantages (lambda)", most=1.0)
    actor_updates: int = setting(1, "updates of the actor in an epoch", least=1)
    critic_updates: int = setting(5, "updates of the critic in an epoch", least=1)
    minibatches: int = setting(
        1, "parts of an epoch's transitions; each update takes the next one", least=1
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
        None, "learning rate of the multiplier, with a cost_limit; default: 0.05", positive=True
    )
    device: str = setting("cpu", "device of PyTorch, such as cuda")

    def check(self) -> None:
        """Raise ValueError for a multiplier that nothing uses, or parts that nothing learns."""
        updates = min(self.actor_updates, self.critic_updates)
        parts, rate = self.minibatches, self.cost_rate
        expected = f"at most {updates}, as many as updates of actor and critic in an epoch"
        checks.expect(parts <= updates, "minibatches", expected, parts)
        used = rate is None or self.cost_limit is not None
        checks.expect(used, "cost_rate", "no value without cost_limit", rate)

    def check_fits(self, path: str, game: Game) -> None:
        """Raise ValueError for networks with memory, or one critic for agents that take turns."""
        assert isinstance(game, Pursuit)  # as its `any_game` says
        interaction, policy = game.world.rules.interaction, game.policy
        # In turns, each agent learns from the world before its own one.
        at_once = interaction is pursuit.Interaction.SIMULTANEOUS
        expected, got = "false where agents take turns", f"true in a world of {interaction.name}"
        checks.expect(at_once or not self.central_critic, f"{path}.central_critic", expected, got)
        expected = "none with actor-critic, which learns from each step by itself"
        checks.expect(policy.memory == "none", "policy.memory", expected, policy.memory)

    def untrained(self, game: Game, team: Team, rng: Rng) -> Genome:
        """Return orthogonal weights: gradients vanish or explode from other beginnings."""
        assert isinstance(game, Pursuit)  # as checked
        network, settings = game.policy, game.settings
        assert isinstance(network, Network)
        assert isinstance(settings, Cells)
        return orthogonal(network.sizes, rng, head=settings.initial_head)

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
        world, network = task.game.world, task.game.policy
        assert isinstance(network, Network)
        cells = world.rows * world.cols
        seen = pursuit.CHANNELS * cells if self.central_critic else network.sizes[0]
        sizes = (seen, *network.hidden, 1)
        rng = seeding.keyed_generator(task.seed, seeding.Purpose.NOISE, task.team)
        weights = {"actor": np.array(task.genomes(1)[0], np.float32)}
        for name in ("critic",) if self.cost_limit is None else ("critic", "cost_critic"):
            weights[name] = orthogonal(sizes, rng)
        state = {
            "multiplier": np.array(0.0),
            **({"epochs": np.array(task.epochs)} if self.anneal else {}),
            "sizes": np.array(network.sizes),
            "value_sizes": np.array(sizes),
            "tanh": np.array(network.activation == "tanh"),
        }
        if task.mask is not None:
            state["fixed"] = task.mask.fixed
        for name, vector in weights.items():
            state |= {f"{name}_weights": vector, **learner.adam_state(vector.size, f"{name}_")}
        return state

    def genome(self, state: State) -> Genome:
        """Return the weights of the actor."""
        return state["actor_weights"]

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

    def __init__(self, chosen: ActorCritic, state: State) -> None:
        self.chosen = chosen
        self._torch, self._device = imported("torch", "torch"), _usable_device(chosen.device)
        activation = "tanh" if state["tanh"] else "relu"
        self._kept = {name: value for name, value in state.items() if "_weights" not in name}
        self._actor = Perceptron(
            "actor", state, tuple(map(int, state["sizes"])), activation, chosen.actor_rate
        )
        sizes = tuple(map(int, state["value_sizes"]))
        names = ["critic"] if chosen.cost_limit is None else ["critic", "cost_critic"]
        self._critics = {
            name: Perceptron(name, state, sizes, activation, chosen.critic_rate) for name in names
        }
        self.multiplier = float(state["multiplier"])
        updates = int(state["actor_updates"]) // chosen.actor_updates
        # Of the learning rates, in this epoch.
        self._share = learner.annealed(updates, int(state["epochs"])) if chosen.anneal else 1.0

    def state(self) -> State:
        """Return the state after the update."""
        networks = (self._actor, *self._critics.values())
        moved = {name: value for each in networks for name, value in each.state.items()}
        return {**self._kept, **moved, "multiplier": np.array(self.multiplier)}

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

    def _learn(self, seen: Experience) -> None:
        chosen, acted = self.chosen, seen.acted
        # What a critic sees before steps, and after the last ones: views, or all states.
        before, after = seen.views, seen.last_views
        if seen.states is not None and seen.last_states is not None:
            before, after = seen.states.reshape(-1, seen.states.shape[-1]), seen.last_states
        known, ends = self._parts(before), self._parts(after)
        estimates = []
        for critic, signal in zip(self._critics.values(), (seen.rewards, seen.costs), strict=False):
            earned = np.zeros(acted.shape, np.float32)
            earned[acted] = signal
            values = dense_values(seen, self._values(critic, known), self._values(critic, ends))
            estimate = partial(advantages, acted, earned, values, chosen.discount)
            estimates.append(normalised(estimate(chosen.trace)[acted]))
            rows, targets = lessons(seen, before, estimate(1.0) + values[:-1])
            self._fit(critic, known if rows is before else self._parts(rows), targets)
        advantage: Any = estimates[0]
        if (limit := chosen.cost_limit) is not None:
            # As a share of the limit, so that the rate means the same for all limits; at most 1: it
            # would rise in the first epochs by more than it can fall in the rest of a run.
            excess = min((1000.0 * float(seen.costs.mean()) - limit) / max(limit, 1.0), 1.0)
            self.multiplier += (chosen.cost_rate or COST_RATE) * excess
            self.multiplier = max(0.0, self.multiplier)
            advantage = (advantage - self.multiplier * estimates[1]) / (1.0 + self.multiplier)
        views = known if seen.states is None else self._parts(seen.views)
        self._improve(views, seen.actions, advantage.astype(np.float32))

    def _improve(self, views: list[Part], taken: types.IntArray, advantage: Reals) -> None:
        torch, clip, entropy = self._torch, self.chosen.clip, self.chosen.entropy
        actions = torch.from_numpy(taken).to(self._device)
        weight = torch.from_numpy(advantage).to(self._device)

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

        before = torch.empty_like(weight)
        if clip:
            with torch.no_grad():
                weights = torch.from_numpy(self._actor.weights).to(self._device)
                for inputs, part in chain.from_iterable(views):
                    before[part] = logs_of(weights, inputs, part)[1]
        self._ascend(self._actor, views, self.chosen.actor_updates, objective)

    def _fit(self, critic: Perceptron, rows: list[Part], returns: Reals) -> None:
        target = self._torch.from_numpy(returns.astype(np.float32)).to(self._device)

        def objective(weights: Tensor, inputs: Inputs, part: slice) -> Tensor:
            values = critic.outputs(weights, inputs)[:, 0]
            return -((values - target[part]) ** 2).sum()

        self._ascend(critic, rows, self.chosen.critic_updates, objective)

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
        found = np.empty(sum(inputs.rows for inputs, _ in chain.from_iterable(parts)), np.float32)
        with self._torch.no_grad():
            weights = self._torch.from_numpy(critic.weights).to(self._device)
            for inputs, place in chain.from_iterable(parts):
                found[place] = critic.outputs(weights, inputs)[:, 0].cpu().numpy()
        return found

    def _parts(self, rows: Views) -> list[Part]:
        """Return the minibatches of rows: every m-th row, in chunks."""
        m, n = self.chosen.minibatches, len(rows)
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
        raise ValueError(f"device: {expected}, got {checks.shown(name)}") from error
    return torch.device(name)
