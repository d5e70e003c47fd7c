"""The right of way: an independent reading, and worlds in which teams keep to it.

python tests/support/right_of_way.py 1e8    # agent-steps; exits with 1 if an agent is at fault
"""

import itertools
import sys
import warnings

import numpy as np

import matrixworld as mw
from matrixworld.coevolution.types import TEAMS
from matrixworld.world.masks import forbidding_cells, mask_weights, masked_network
from reference import MOVES

EVADERS, PURSUERS, OBSTACLES = range(3)
MASK = "right-of-way"
ROWS = [
    mw.Rules(*row)
    for row in itertools.product(
        mw.Interaction, *[mw.Outcome] * 4, mw.Capture, (False, True)
    )
]  # fmt: skip
"""All 972 rows of rules."""


def from_the_right(own, other):
    """Return whether a traveller by the move `other` meets one by `own` from its right."""
    right = np.array([own[1], -own[0]])  # of north (-1, 0) it is east (0, 1)
    return bool(np.dot(other, -right) > 0)


def forbidden_in_s(view, team, n_actions):
    """Return which actions right of way forbids in S, from one view (3, fov, fov)."""
    own, foreign = (PURSUERS, EVADERS) if team == "pursuer" else (EVADERS, PURSUERS)
    middle = view.shape[-1] // 2
    agents = {
        channel: {(r - middle, c - middle) for r, c in np.argwhere(view[channel])}
        for channel in (own, foreign)
    }
    walls = {(r - middle, c - middle) for r, c in np.argwhere(view[OBSTACLES])}
    found = [False]
    for number, move in enumerate(MOVES[1:n_actions], start=1):
        answer = move in walls or move in agents[own] or move in agents[foreign]
        for other_number, other in enumerate(MOVES[1:n_actions], start=1):
            there = (move[0] - other[0], move[1] - other[1])  # from where it comes
            faces = other == (-move[0], -move[1])
            first = other_number < number if faces else from_the_right(move, other)
            answer |= there in agents[own] and first
            # A pursuer gets the cell that an evader enters, too; the evader is at fault.
            answer |= team == "evader" and there in agents[foreign]
        found.append(answer)
    return found


def random_teams(config, rng, genomes, **shape):
    """Return both teams with random networks that have the mask."""
    network = masked_network(mw.Network.for_config(config, **shape))
    teams = []
    for team in TEAMS:
        weights = mask_weights(network, forbidding_cells(config, MASK, team))
        free = rng.normal(0, 0.5, (genomes, network.genome_size)).astype(np.float32)
        teams.append(mw.Population(weights.write(free), network))
    return teams


def play(agent_steps, seed=0):
    """Play dense worlds of random rows and networks; return agent-steps, faults, captures."""
    rng, played, faults, captures = np.random.default_rng(seed), 0, 0, 0
    while played < agent_steps:
        rows, cols = (int(n) for n in rng.integers(4, 16, 2))
        density = rng.choice([0.0, 0.05, 0.15])
        room = int(rows * cols * (1 - density)) - 1
        pursuers = int(rng.integers(1, max(2, room // 2)))
        evaders = int(rng.integers(1, max(2, min(room - pursuers, room // 3))))
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", UserWarning)  # rows in which nobody can be captured
            config = mw.WorldConfig(
                ROWS[rng.integers(len(ROWS))], rows=rows, cols=cols, n_pursuers=pursuers,
                n_evaders=evaders, obstacles=density, max_steps=100,
                fov=int(rng.choice([5, 7, 11])), diagonal=bool(rng.integers(2)),
            )  # fmt: skip
            hidden = [(), (8,), (8, 6)][rng.integers(3)]
            memory = str(rng.choice(["none", "gru"])) if hidden else "none"
            teams = random_teams(config, rng, 4, hidden=hidden, memory=memory)
            matches = mw.Matches.of(range(4), range(4), rng.integers(2**62, size=4))
            found = mw.rollout(config, *teams, matches, episodes=4)
        played += int(found.agent_steps.sum())
        faults += int(found.faults.sum())
        captures += round(float(found.ever_capture_rate.sum()) * evaders)
    return played, faults, captures


if __name__ == "__main__":
    steps, at_fault, captured = play(float(sys.argv[1]))
    told = f"{steps:,} agent-steps, {at_fault} at fault, {captured:,} evaders captured\n"
    sys.stdout.write(told)
    sys.exit(at_fault > 0)
