"""Recorded episodes as a data set of Minari, with costs: copy this file.

``pip install 'minari[hdf5]'``
"""

import inspect

import minari
import numpy as np
from gymnasium import spaces

import matrixworld as mw


def to_minari(episodes, dataset_id, *, team="pursuer", **metadata):
    """Write recorded episodes of one world as a data set, and return it.

    An episode is one of the world for the agents of a team; the other team belongs to their
    environment, as in ``parallel_env(config, evaders="fleer")``. Rewards are sums over the team.
    Observations, actions and infos are by agent: ``reward``, ``alive``, and the costs ``cost``,
    ``cost_obstacle``, ``cost_teammate`` and ``cost_adversary``. Infos begin with the reset: entry
    t + 1 belongs to action t. Agents that are gone observe zeros and stay.

    The metadata holds the settings as ``world``, for `WorldConfig.from_json`, and `metadata`:
    arguments of ``minari.create_dataset_from_buffers``, and other values that JSON can hold. The
    options of an episode are those with which `reset` starts it again.
    """
    episodes = list(episodes)
    if any(episode.config != episodes[0].config for episode in episodes):
        raise ValueError("episodes: expected those of one world, got several")
    world = mw.World(mw.WorldConfig.from_json(episodes[0].config))
    config = world.config
    names = {config.agent_name(agent): agent for agent in range(config.n_agents)}
    agents = {name: agent for name, agent in names.items() if name.startswith(team)}
    view = spaces.Box(0, 1, (3, config.fov, config.fov), np.uint8)
    actions = spaces.Discrete(config.n_actions)
    known = inspect.signature(minari.create_dataset_from_buffers).parameters
    data = minari.create_dataset_from_buffers(
        dataset_id,
        [buffer_of(episode, world, agents) for episode in episodes],
        observation_space=spaces.Dict(dict.fromkeys(agents, view)),
        action_space=spaces.Dict(dict.fromkeys(agents, actions)),
        **{key: value for key, value in metadata.items() if key in known},
    )
    others = {key: value for key, value in metadata.items() if key not in known}
    data.storage.update_metadata({"world": config.to_json(), **others})
    return data


def buffer_of(episode, world, agents):
    """Return an episode in Minari's form; the world plays it again, for the observations."""
    n_pursuers = episode.n_pursuers
    start = {"pursuers": episode.positions[0, :n_pursuers]}
    start["evaders"] = episode.positions[0, n_pursuers:]
    if world.config.map is None and episode.map.any():
        start["obstacles"] = episode.map
    world.reset(0, **start)
    views = np.stack([world.views()] * (episode.length + 1))
    for seen, actions in zip(views, episode.actions, strict=False):
        for _ in range(world.n_turns):  # where agents take turns, they see what others did before
            acting = world.actors
            seen[acting] = world.views()[acting]
            world.play_turn(actions)
    views[-1] = world.views()
    if not np.array_equal(world.positions, episode.positions[-1]):
        raise ValueError(f"episodes: expected one that plays as it was recorded, got {episode}")
    fault = np.pad(episode.fault, ((1, 0), (0, 0), (0, 0))).astype(np.float32)
    infos = {"alive": episode.alive, "cost": fault.sum(axis=-1)}
    infos |= {f"cost_{kind}": fault[..., k] for k, kind in enumerate(mw.COLLISION_KINDS)}
    infos["reward"] = np.pad(episode.rewards, ((1, 0), (0, 0)))
    actions = np.where(episode.alive[:-1], episode.actions, 0).astype(np.int64)
    last = np.arange(episode.length) == episode.length - 1

    def by_agent(array):
        return {name: array[:, agent] for name, agent in agents.items()}

    return minari.data_collector.EpisodeBuffer(
        options=start,
        observations=by_agent(views),
        actions=by_agent(actions),
        rewards=episode.rewards[:, [*agents.values()]].sum(axis=1),
        terminations=last & world.terminated,
        truncations=last & (not world.terminated),
        infos={key: by_agent(array) for key, array in infos.items()},
    )
