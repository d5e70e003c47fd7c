"""Worlds that several tests play in: all variants, and other rows of rules."""

import io
import warnings
import zipfile
from dataclasses import replace

import numpy as np

import matrixworld as mw

D, R, B = mw.Outcome.DISAPPEAR, mw.Outcome.REACH, mw.Outcome.BOUNCE
TOGETHER = mw.Interaction.SIMULTANEOUS
SWARM = mw.Interaction.SWARM_TURNS
AGENTS = mw.Interaction.AGENT_TURNS
OCCUPATION, SURROUND = mw.Capture.OCCUPATION, mw.Capture.SURROUND

#              interaction, obstacle, teammate, evader, pursuer, capture, captured disappear
CUSTOM = {
    "swarm-D": mw.Rules(SWARM, D, D, D, D, OCCUPATION),
    "swarm-R": mw.Rules(SWARM, R, R, R, R, OCCUPATION),
    "swarm-S": mw.Rules(SWARM, B, B, B, R, SURROUND),
    "swarm-SD": mw.Rules(SWARM, R, D, R, B, SURROUND, True),
    "agents-D": mw.Rules(AGENTS, D, B, D, D, OCCUPATION),
    "agents-R": mw.Rules(AGENTS, R, B, R, R, OCCUPATION),
    "agents-S": mw.Rules(AGENTS, B, R, B, R, SURROUND),
    "agents-SD": mw.Rules(AGENTS, R, R, B, B, SURROUND, True),
    "wall-R": mw.Rules(TOGETHER, R, B, D, B, OCCUPATION),
    "pursuer-D": mw.Rules(TOGETHER, B, D, R, D, SURROUND),
    "both-B": mw.Rules(TOGETHER, D, B, B, B, SURROUND, True),
    "nobody": mw.Rules(TOGETHER, B, R, B, R, OCCUPATION),
}
NAMES = [*mw.VARIANTS, *CUSTOM]


def config_of(name, **changes):
    """Return the settings of a small, dense world with a variant or a row above."""
    surround = (CUSTOM | dict(mw.VARIANTS))[name].capture is SURROUND
    small = {
        "rows": 7,  # not square, so that rows and columns cannot be swapped unseen
        "cols": 6,
        "n_pursuers": 6 if surround else 3,
        "n_evaders": 2 if surround else 4,
        "fov": 5,
        "max_steps": 20,
    }
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # the row "nobody" can never capture an evader
        return mw.WorldConfig(CUSTOM.get(name, name), **(small | changes))


def raw_numbers(seed, *shape):
    """Return random 64-bit numbers; unlike those of a Generator they never change with NumPy."""
    raw = np.random.Philox(key=[seed, 0]).random_raw(int(np.prod(shape)))
    return np.asarray(raw, np.uint64).reshape(shape)


def random_actions(seed, n_actions, *shape):
    """Return random actions, the same with every version of NumPy."""
    return (raw_numbers(seed, *shape) >> np.uint64(32)).astype(np.int64) % n_actions


def random_genome(network, seed, scale=0.3):
    """Return uniform numbers in [-scale, scale), the same with every version of NumPy."""
    # 24 bits: all that a float32 holds exactly.
    bits = raw_numbers(seed, network.genome_size) >> np.uint64(40)
    units = bits.astype(np.float32) / np.float32(2**24)
    return (scale * (2 * units - 1)).astype(np.float32)


def random_team(config, *seeds, hidden=(8,), **fields):
    """Return a population for a world with one random genome for each seed."""
    network = mw.Network.for_config(config, hidden, **fields)
    return mw.Population(np.stack([random_genome(network, seed, 0.7) for seed in seeds]), network)


def random_walks(rows=12, cols=16, pursuers=5, evaders=7, steps=30):
    """Return an episode in which met evaders disappear, recorded without conflicts."""
    rules = mw.Rules(TOGETHER, B, R, D, R, OCCUPATION)
    config = mw.WorldConfig(
        rules, rows=rows, cols=cols, n_pursuers=pursuers, n_evaders=evaders, obstacles=0.1
    )
    episode = mw.record_actions(config, random_actions(0, 5, steps, pursuers + evaders))
    assert episode.length == steps  # it has not ended before
    return replace(episode, conflict_table=None)


def by_name(env, row):
    """Return the actions of a parallel environment's living agents, from those of all agents."""
    actions = dict(zip(env.possible_agents, row.tolist(), strict=True))
    return {agent: actions[agent] for agent in env.agents}


def play_turns(env, choose):
    """Play an episode of an AEC environment, and return what each agent was paid.

    `choose` gets the agent and its info.
    """
    paid = dict.fromkeys(env.possible_agents, 0.0)
    for agent in env.agent_iter():
        _, reward, terminated, truncated, info = env.last()
        paid[agent] += reward
        env.step(None if terminated or truncated else choose(agent, info))
    return paid


def assert_same_worlds(one, other):
    """Compare all arrays of two worlds, and whose turn it is."""
    for name, value in one.read(*mw.array_specs(one.config)).items():
        np.testing.assert_array_equal(value, other.read(name)[name], name)
    assert one.turn == other.turn


def archive(parts, *, method=zipfile.ZIP_DEFLATED):
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w", method) as made:
        for name, content in parts.items():
            made.writestr(name, content)
    return buffer.getvalue()
