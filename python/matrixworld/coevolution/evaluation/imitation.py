"""A decision tree that imitates a network over cells, also where only the tree would go.

Ross, Gordon and Bagnell 2011, "A reduction of imitation learning and structured prediction to
no-regret online learning" (DAgger).
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from matrixworld import version
from matrixworld.analysis import Estimate
from matrixworld.coevolution.evaluation.trials import Trials, difference, mean_score
from matrixworld.coevolution.types import Team
from matrixworld.play.policies import NetworkPolicy
from matrixworld.world.rules import Action

DEPTHS = range(3, 7)  # depths of trees that can be read, and still imitate something
DEPTH = 4
STATES = 10_000  # about the most states that are kept of a rollout
ROUNDS = 2  # rollouts of a tree whose states the next tree learns, too
PARTS = ROUNDS + 4  # about equally long: rollouts, and the scores of network and tree


class Tree(NamedTuple):
    """A decision tree that imitates a network."""

    depth: int
    leaves: int
    agreement: float
    """Share of the states in new matches of the network in which both like the same move best."""
    score: Estimate
    cost: Estimate  # score of the network minus that of the tree


def features(views: NDArray[Any], team: Team) -> dict[str, NDArray[np.float32]]:
    """Return what a tree knows of views (n, 3, fov, fov): by name one number of each, (n,).

    Without anybody in view places are 0, and the moves are as many as the view is wide.
    """
    own, foes = (1, 0) if team == "pursuer" else (0, 1)
    n = len(views)
    fov = views.shape[-1]
    half = fov // 2
    south, east = (axis.ravel() for axis in np.mgrid[-half : half + 1, -half : half + 1])
    moves = abs(south) + abs(east)
    table: dict[str, NDArray[Any]] = {}
    for channel, name, many in ((foes, "adversary", "adversaries"), (own, "teammate", "teammates")):
        seen = views[:, channel].reshape(n, -1) > 0
        if channel == own:
            seen &= moves > 0  # without the agent itself
        nearest = np.where(seen, moves, fov).argmin(axis=1)
        in_view = seen.any(axis=1)
        table[f"{name} south"] = south[nearest] * in_view
        table[f"{name} east"] = east[nearest] * in_view
        table[f"{name} moves"] = np.where(in_view, moves[nearest], fov)
        table[many] = seen.sum(axis=1)
    walls = views[:, 2] > 0
    rays = {
        "north": walls[:, :half, half][:, ::-1],
        "east": walls[:, half, half + 1 :],
        "south": walls[:, half + 1 :, half],
        "west": walls[:, half, :half][:, ::-1],
    }
    for direction, ray in rays.items():
        ends = np.pad(ray, ((0, 0), (0, 1)), constant_values=True)  # where the view does
        table[f"free cells {direction}"] = ends.argmax(axis=1)
    return {name: column.astype(np.float32) for name, column in table.items()}


class Imitation:
    """A tree that learns what a network does in its trials, and draws moves as the network does."""

    def __init__(self, trials: Trials, depth: int) -> None:
        assert isinstance(trials.policy, NetworkPolicy)
        if trials.policy.policy.memory != "none":
            raise ValueError("policy: expected one without memory, which no tree imitates, got gru")
        trees: Any = version.imported("sklearn.tree", "explain")
        self.tree = trees.DecisionTreeClassifier(
            max_depth=depth, min_samples_leaf=20, random_state=0
        )
        self.network = trials.policy
        self.trials = trials
        self._rng = np.random.default_rng(trials.seed_of(1))

    def learn(self) -> None:
        """Learn from states of the network, and then from those in which the tree comes."""
        states = self.states(self.network, 0)
        for number in range(1, ROUNDS + 1):
            self._fit(states)
            states = np.concatenate([states, self.states(self, number)])
        self._fit(states)

    def __call__(self, views: NDArray[Any]) -> NDArray[np.int64]:
        """Return the moves (n,) of agents with some views."""
        chances = self.tree.predict_proba(self._table(views))
        if not self.network.policy.sampled:
            return np.asarray(chances.argmax(axis=1))
        drawn = chances.cumsum(axis=1) < self._rng.random((len(chances), 1))
        return np.asarray(drawn.sum(axis=1).clip(0, self.trials.world.n_actions - 1))

    def states(self, policy: Callable[..., Any], number: int) -> NDArray[Any]:
        """Return some views that agents have when a policy plays a set of matches."""
        world = self.trials.world
        agents = world.n_pursuers if self.trials.team == "pursuer" else world.n_evaders
        # Of each rollout about as many states are kept, whatever the size of the world.
        share = STATES / (2 * len(self.trials.opponents) * world.max_steps * agents)
        sampled = []

        def watched(views: NDArray[Any]) -> Any:
            sampled.append(views[self._rng.random(len(views)) < share])
            return policy(views)

        self.trials.part(number, PARTS).scores(watched, 1 + number, episodes=2)
        return np.concatenate(sampled)

    def agreement(self) -> float:
        """Return the share of states, in new matches, in which both like the same move best."""
        views = self.states(self.network, ROUNDS + 1)
        likeliest = self.tree.predict_proba(self._table(views)).argmax(axis=1)
        return float((likeliest == self._wanted(views).argmax(axis=1)).mean())

    def rules(self) -> str:
        """Return the likeliest moves of the tree in words, with their shares."""
        fov = self.trials.world.fov
        names = [*features(np.zeros((1, 3, fov, fov)), self.trials.team)]
        lines, _ = _rules(self.tree.tree_, names)
        return "\n".join(lines)

    def _fit(self, views: NDArray[Any]) -> None:
        n_actions = self.trials.world.n_actions
        rows = np.repeat(self._table(views), n_actions, axis=0)
        moves = np.tile(np.arange(n_actions), len(views))
        self.tree.fit(rows, moves, sample_weight=self._wanted(views).ravel())

    def _wanted(self, views: NDArray[Any]) -> NDArray[Any]:
        """Return the probability (n, actions) with which the network takes each move."""
        chances: NDArray[Any] = self.network.probabilities(views)
        if self.network.policy.sampled:
            return chances
        return np.asarray(np.eye(self.trials.world.n_actions)[chances.argmax(axis=1)])

    def _table(self, views: NDArray[Any]) -> NDArray[np.float32]:
        return np.stack([*features(views, self.trials.team).values()], axis=1)


def imitated(trials: Trials, depth: int) -> tuple[Estimate, Tree, str]:
    """Return the score of a network, a tree that imitates it, and the rules of the tree."""
    imitation = Imitation(trials, depth)
    imitation.learn()
    agreement = imitation.agreement()
    [own] = trials.part(PARTS - 2, PARTS).scores(trials.policy, 0)
    [of_tree] = trials.part(PARTS - 1, PARTS).scores(imitation, 0)
    tree = Tree(
        depth=int(imitation.tree.get_depth()),
        leaves=int(imitation.tree.get_n_leaves()),
        agreement=agreement,
        score=mean_score(of_tree),
        cost=difference(own, of_tree),
    )
    return mean_score(own), tree, imitation.rules()


def _rules(tree: Any, names: Sequence[str], node: int = 0) -> tuple[list[str], set[int]]:
    """Return the likeliest moves of a tree as lines, with their shares, and as a set."""
    # Splits that do not change the likeliest move are left out.
    chances = tree.value[node][0]
    best = int(chances.argmax())
    share = chances[best] / chances.sum()
    leaf = [f"{Action(best).name.lower()} ({share:.2f})"]
    left = int(tree.children_left[node])
    if left < 0:  # no split
        return leaf, {best}
    low, low_moves = _rules(tree, names, left)
    high, high_moves = _rules(tree, names, int(tree.children_right[node]))
    moves = low_moves | high_moves
    if len(moves) == 1:
        return leaf, moves
    lines = [f"if {names[tree.feature[node]]} <= {tree.threshold[node]:g}:"]
    lines += [f"    {line}" for line in low]
    if len(high) > 1:
        lines += [f"el{high[0]}", *high[1:]]
    else:
        lines += ["else:", f"    {high[0]}"]
    return lines, moves
