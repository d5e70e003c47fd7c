"""Exercises of notebook 9, "Fast and safe?", and its packs of pursuers with six weights."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from functools import cache
from itertools import combinations, permutations
from typing import Any

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.figure import Figure
from numpy.typing import ArrayLike, NDArray

import matrixworld as mw
from course.checks import Mistake, array, function, near, number, whole
from matrixworld import analysis
from matrixworld.coevolution import EvolutionStrategy, Task
from matrixworld.coevolution.states import State
from matrixworld.world.arrays import MOVES

# ---- Packs ---------------------------------------------------------------------------------------

WORLD = mw.WorldConfig("S", rows=10, cols=10, n_pursuers=6, n_evaders=1, max_steps=60)
"""Six pursuers have to surround one evader. In S pursuers may share a cell; it is a collision."""

WEIGHTS = ("approach", "hold", "wall", "teammate", "crowd", "stay")
"""What a pack weighs. The wish for an action is the sum of each weight times what it counts:

approach    for a move: how much it leads towards the evaders in view, -1 to 1 each
hold        for staying: evaders on the four cells around
wall        for a move: 1 if an obstacle or the border is there
teammate    for a move: teammates on that cell
crowd       for a move: teammates on the other three cells around that cell
stay        for staying: always 1
"""

_EVADERS, _PURSUERS, _OBSTACLES = range(3)  # channels of views
MOVE = {1: "north", 2: "east", 3: "south", 4: "west"}

Mask = Callable[[NDArray[np.uint8]], ArrayLike]
"""Takes views, (n, 3, fov, fov), and returns which actions are allowed, (n, n_actions)."""


def pack(weights: ArrayLike) -> mw.Population:
    """Return packs as a population of networks; weights are (6,) or (n, 6), as in `WEIGHTS`.

    A network without a hidden layer: its genome is linear in the weights.
    """
    given = np.atleast_2d(np.asarray(weights, np.float64))
    if given.ndim != 2 or given.shape[1] != len(WEIGHTS):
        raise ValueError(f"weights: expected shape (6,) or (n, 6), got {np.shape(weights)}")
    network = mw.Network.for_config(WORLD, hidden=())
    return mw.Population((given @ _genomes(network)).astype(np.float32), network)


def idle_pack(learner: EvolutionStrategy, seed: int) -> State:
    """Return the state of a learner whose six weights are 0, with the noise of a seed."""
    weights = np.zeros(len(WEIGHTS), np.float32)
    # Of the game a learner wants to know how long genomes are; who plays it scores them.
    game = mw.Game(np.subtract, len(WEIGHTS), ("packs", "evaders"))
    return learner.start(Task(seed, 0, 0, lambda rng: weights, weights, game))


def _genomes(network: mw.Network) -> NDArray[np.float32]:
    """Return the genome of each weight alone, (6, genome_size)."""
    half = network.fov // 2
    cells = np.indices((network.fov, network.fov)) - half
    distance = abs(cells).sum(axis=0)
    genomes = np.zeros((len(WEIGHTS), network.genome_size), np.float32)
    shape = (3, network.fov, network.fov, network.n_actions)
    layers = [network.layers(genome)[0] for genome in genomes]
    approach, hold, wall, teammate, crowd, _ = (inputs.reshape(shape) for inputs, _ in layers)
    for action, step in enumerate(MOVES[1:5], start=1):
        along = np.tensordot(step, cells, axes=1)
        from_target = abs(cells - step[:, None, None]).sum(axis=0)
        approach[_EVADERS, ..., action] = along / np.maximum(distance, 1)
        wall[_OBSTACLES, ..., action] = from_target == 0
        teammate[_PURSUERS, ..., action] = from_target == 0
        crowd[_PURSUERS, ..., action] = (from_target == 1) & (distance > 0)
    hold[_EVADERS, ..., 0] = distance == 1
    layers[-1][1][0] = 1.0
    return genomes


def draw_front(crowds: Sequence[int], played: mw.EpisodeStatistics) -> Figure:
    """Draw how fast and how safe packs are that differ in the weight `crowd`."""
    figure, axes = plt.subplots(figsize=(7, 4), layout="constrained")
    unsafe = (played.faults[:, :, 0].sum(axis=2) > 0).astype(float)
    for crowd, *measured in zip(crowds, unsafe, played.length, strict=True):
        x, y = (analysis.interval_over_runs(each) for each in measured)
        across, up = ([[each.value - each.low], [each.high - each.value]] for each in (x, y))
        axes.errorbar(x.value, y.value, up, across, "o")
        axes.annotate(f" {crowd}", (x.value, y.value), va="bottom")
    axes.set(xlabel="share of episodes with a collision at fault", ylabel="steps until capture")
    axes.set(title="a mark for each `crowd`; lines: 95% intervals over episodes", xlim=(0, 1))
    plt.close(figure)  # the cell shows it once
    return figure


def play_masked(
    weights: ArrayLike, mask: Mask, *, episodes: int, seed: int = 0
) -> tuple[mw.SafetyMonitor, NDArray[np.int64]]:
    """Play a pack in `WORLD` that never chooses an action that a mask forbids.

    A pursuer that is allowed nothing stays. Returns what happened, and the steps of each episode.
    """
    population = pack(weights)
    envs = mw.VectorEnv(WORLD, n_worlds=episodes, evaders="random", autoreset_mode="Disabled")
    views, _ = envs.reset(seed=seed)
    rng, safety = np.random.default_rng(seed), mw.SafetyMonitor()
    steps, running = np.zeros(episodes, np.int64), np.ones(episodes, bool)
    while running.any():
        actions = np.zeros((episodes, WORLD.n_pursuers), np.int64)
        seen = views[running].reshape(-1, *views.shape[2:])
        allowed, expected = np.array(mask(seen), bool), (len(seen), WORLD.n_actions)
        if allowed.shape != expected:
            raise ValueError(f"mask: expected shape {expected}, got {allowed.shape}")
        allowed[~allowed.any(axis=1), 0] = True
        wishes = population.policy.logits(population.genomes[0], seen)
        wishes[~allowed] = -np.inf
        # The largest of wishes with Gumbel noise is a draw with their softmax.
        chosen = (wishes + rng.gumbel(size=wishes.shape)).argmax(axis=1)
        actions[running] = chosen.reshape(-1, WORLD.n_pursuers)
        views, *_, infos = envs.step(actions)
        safety.add_infos(infos)
        ended = running & infos["_episode"]
        steps[ended] = infos["episode"]["length"][ended]
        running &= ~ended
    return safety, steps


# ---- Exercises -----------------------------------------------------------------------------------

MOST_FAULTS, MOST_STEPS = 10.0, 15.0
TRIALS = 4000
"""Episodes that judge the answer: their mean number of steps has a standard error of 0.15."""


def exercise_1(answer: Any) -> None:
    """Find weights of a pack that is fast and careful."""
    kind = f"six numbers, one for each of {', '.join(WEIGHTS)}"
    weights = array(answer, kind, len(WEIGHTS))
    played = mw.rollout(WORLD, pack(weights), "random", mw.Matches.of(0, 0, 91), episodes=TRIALS)
    faults = 1000 * played.faults[:, :, 0].sum() / played.agent_steps[:, :, 0].sum()
    steps = played.length.mean()
    too_many, too_slow = bool(faults >= MOST_FAULTS), bool(steps > MOST_STEPS)
    if too_many or too_slow:
        told = {
            (True, True): "Both numbers are too large: it gets in its own way.",
            (True, False): "It is fast enough. Now make it more careful.",
            (False, True): "It is careful enough. Now make it more determined.",
        }
        raise Mistake(
            f"In {TRIALS} new episodes it is at fault in {faults:.1f} of 1000 agent-steps and "
            f"needs {steps:.1f} steps. {told[too_many, too_slow]}"
        )


BRISK, IDLE = (4, 10, -10, -8, -2, 0), (0, 0, 0, 0, 0, 20)
LARGER = (
    "At this penalty the return of the {} pack is larger. Look for the penalty at which both are "
    "equal."
)


@cache
def brisk_and_idle() -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return rewards without penalties, and collisions at fault, of both packs in an episode."""
    free = replace(WORLD, rewards=mw.Rewards(pursuer_collide=0))
    matches = mw.Matches.of([0, 1], 0, 2)
    played = mw.rollout(free, pack([BRISK, IDLE]), "random", matches, episodes=400)
    return played.pursuer_return.mean(axis=1), played.faults[:, :, 0].sum(axis=2).mean(axis=1)


def break_even() -> float:
    """Return the penalty at which the returns of the brisk and of the idle pack are equal."""
    gain, collisions = brisk_and_idle()
    return float((gain[0] - gain[1]) / (collisions[0] - collisions[1]))


def exercise_2(answer: Any) -> None:
    """Find the penalty at which the brisk and the idle pack are equally good."""
    penalty = number(answer, "one number: the penalty at which both returns are equal")
    right = break_even()
    # Rewards are negative where penalties are positive: both signs are understood.
    near(abs(penalty), right, 0.02 * right, low=LARGER.format("brisk"), high=LARGER.format("idle"))


FEWEST_EPISODES = 299  # 0.99^299 = 0.0495, and 0.99^298 = 0.05004


def exercise_3(answer: Any) -> None:
    """Say how many episodes without a collision show that collisions are rare."""
    near(
        whole(answer, "a whole number of episodes"),
        FEWEST_EPISODES,
        0,
        low=lambda n: (
            f"A pack with p = 0.01 would pass {n} episodes with a probability of {0.99**n:.3%}. "
            "That is more than 5%."
            if n > 0
            else "At least one episode has to be played."
        ),
        high=lambda n: f"That is enough, but a smaller number is, too: {0.99**n:.2%} is below 5%.",
    )


def exercise_4(answer: Any) -> None:
    """Write a convention: who goes first in all pairs, and then in all groups, around a cell."""
    first = {pair: _goes_first(function(answer), *pair) for pair in permutations(MOVE, 2)}
    for one, other in combinations(MOVE, 2):
        if first[one, other] == first[other, one]:
            both = "both go first, and collide" if first[one, other] else "neither goes first"
            raise Mistake(
                f"One moves {MOVE[one]} into a cell, the other {MOVE[other]} into the same: {both}."
            )
    for group in (*combinations(MOVE, 3), tuple(MOVE)):
        if not any(all(first[one, other] for other in group if other != one) for one in group):
            *moves, last = (MOVE[move] for move in group)
            raise Mistake(
                "Of any two exactly one goes first, so nobody collides. But where pursuers move "
                f"{', '.join(moves)} and {last} into one cell, each waits for another one."
            )


def _goes_first(convention: Callable[[int, int], Any], own: int, other: int) -> bool:
    found = [convention(own, other) for _ in range(9)]
    where = f"For own = {own} and other = {other} it returns"
    if not all(isinstance(each, bool | np.bool_) for each in found):
        raise Mistake(f"{where} {found[0]!r}; expected True or False.")
    if len({*found}) > 1:
        raise Mistake(f"{where} now True, now False. Both pursuers must come to the same decision.")
    return bool(found[0])
