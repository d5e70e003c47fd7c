"""Minari: recorded episodes as a data set for offline learning, with costs."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import numpy as np
from gymnasium import spaces
from numpy.typing import NDArray

from matrixworld._util.checks import check_choice, check_instance, check_sequence
from matrixworld.envs.opponents import own_and_other
from matrixworld.episodes.episode import Episode
from matrixworld.episodes.record import Recorder
from matrixworld.version import DISTRIBUTION, __version__, imported
from matrixworld.world.config import WorldConfig
from matrixworld.world.policy import TEAMS, Team
from matrixworld.world.rules import COLLISION_KINDS
from matrixworld.world.world import World

__all__ = ["to_minari"]


def to_minari(
    episodes: Iterable[Episode], dataset_id: str, *, team: Team = "pursuer", **metadata: Any
) -> Any:
    """Write recorded episodes as a data set of Minari, which ``minari.load_dataset`` loads.

    An episode is one of the world for the agents of a team; the other team belongs to their
    environment, as in ``parallel_env(config, evaders="fleer")``. Rewards are sums over the team.
    Observations, actions and infos are by agent: ``reward``, ``alive``, and as in infos of the
    environment ``cost``, ``cost_obstacle``, ``cost_teammate`` and ``cost_adversary``. Agents that
    are gone observe zeros and stay. Infos begin with the reset: entry t + 1 belongs to action t.

    Parameters
    ----------
    episodes : iterable of Episode
        Recordings of one world, which plays their actions again for the observations.
    dataset_id : str
        The name of a new data set, such as ``"pursuit/o/chaser-v0"``.
    team : {"pursuer", "evader"}, optional
        The team. The default is ``"pursuer"``.
    **metadata
        More metadata, as JSON, such as Minari's ``algorithm_name`` and ``author``, or a seed.

    Returns
    -------
    minari.MinariDataset
        With the settings as ``world`` in its metadata, for `WorldConfig.from_json`. The options of
        an episode are those with which `reset` starts it again.

    Raises
    ------
    ValueError, TypeError
        For other names, and unless there are whole episodes of one world that play as recorded.
        FileExistsError if the data set exists. Nothing is written then.
    """
    library, _ = imported("minari", "minari"), imported("h5py", "minari")
    check_choice("team", team, TEAMS)
    try:
        namespace, *_ = library.dataset.minari_dataset.parse_dataset_id(dataset_id)
    except (TypeError, ValueError) as error:  # a TypeError without a version
        expected = "a name such as 'pursuit/o/chaser-v0'"
        raise ValueError(f"dataset_id: expected {expected}, got {dataset_id!r}") from error
    path: Path = library.storage.get_dataset_path(dataset_id)
    if path.exists():
        raise FileExistsError(f"dataset_id: expected a new name, got {dataset_id!r}: {path}")
    recorded = check_sequence("episodes", episodes, "episodes")
    for episode in recorded:
        check_instance("episodes", episode, Episode)
        if episode.config != recorded[0].config or not episode.length:
            raise ValueError(f"episodes: expected steps in one world, got {episode}")
    if not recorded:
        raise ValueError("episodes: expected at least one, got none")
    world = World(WorldConfig.from_json(recorded[0].config))
    config = world.config
    agents = {config.agent_name(agent): agent for agent in own_and_other(team, config)[0]}
    view = spaces.Box(0, 1, (3, config.fov, config.fov), np.uint8)
    single = view, spaces.Discrete(config.n_actions)
    own = {"dataset_id": dataset_id, "minari_version": library.__version__}
    own |= {"requirements": [f"{DISTRIBUTION}=={__version__}"], "world": config.to_json()}
    authors = {key: {text} for key, text in metadata.items() if key in ("author", "author_email")}
    root = library.storage.get_dataset_path().resolve()
    # A data set has its name when it is complete; Minari lists no hidden directories.
    with TemporaryDirectory(prefix=".", dir=root) as directory:
        written = Path(directory, path.name)
        written.mkdir()
        joint = (spaces.Dict(dict.fromkeys(agents, space)) for space in single)
        storage = library.dataset.minari_storage.MinariStorage.new(written / "data", *joint)
        storage.update_metadata(own | metadata | authors)
        new = library.data_collector.EpisodeBuffer
        storage.update_episodes(new(**_data(each, world, agents)) for each in recorded)
        if namespace not in (None, *library.namespace.list_local_namespaces()):
            library.namespace.create_namespace(namespace)
        written.rename(path)
    return library.load_dataset(dataset_id)


def _data(episode: Episode, world: World, agents: dict[str, int]) -> dict[str, Any]:
    """Return the fields of Minari's `EpisodeBuffer`, for which the world plays the episode."""
    start: dict[str, Any] = {"pursuers": episode.positions[0, : episode.n_pursuers]}
    start["evaders"] = episode.positions[0, episode.n_pursuers :]
    if world.config.map is None and episode.map.any():
        start["obstacles"] = episode.map
    world.reset(0, **start)
    recorder, views = Recorder(world), np.stack([world.views()] * (episode.length + 1))
    for seen, actions in zip(views, episode.actions, strict=False):
        for _ in range(world.n_turns):  # where agents take turns, they see what others did before
            acting = world.actors
            seen[acting] = world.views()[acting]
            world.play_turn(actions)
        recorder.note(actions)
    views[-1] = world.views()
    again = recorder.episode()
    pairs = ((again.positions, episode.positions), (again.rewards, episode.rewards))
    if not all(np.array_equal(ours, theirs) for ours, theirs in pairs):
        raise ValueError(f"episodes: expected to play again as recorded, got {again}, {episode}")
    fault = np.pad(episode.fault, ((1, 0), (0, 0), (0, 0))).astype(np.float32)
    infos: dict[str, NDArray[Any]] = {"alive": episode.alive, "cost": fault.sum(axis=-1)}
    infos |= {f"cost_{kind}": fault[..., k] for k, kind in enumerate(COLLISION_KINDS)}
    infos["reward"] = np.pad(episode.rewards, ((1, 0), (0, 0)))
    actions = np.where(episode.alive[:-1], episode.actions, 0).astype(np.int64)
    last = np.arange(episode.length) == episode.length - 1
    of = agents.items()
    return {
        "options": start,
        "observations": {name: views[:, agent] for name, agent in of},
        "actions": {name: actions[:, agent] for name, agent in of},
        "rewards": episode.rewards[:, [*agents.values()]].sum(axis=1),
        "terminations": last & world.terminated,
        "truncations": last & (not world.terminated),
        "infos": {key: {name: each[:, agent] for name, agent in of} for key, each in infos.items()},
    }
