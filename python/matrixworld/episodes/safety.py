"""Safety of a team: collisions over many episodes, by kind and by fault."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from matrixworld._util import checks
from matrixworld._util.readable import Parts, Readable, plain_values
from matrixworld._util.teams import BOTH
from matrixworld.analysis.intervals import rate_intervals
from matrixworld.episodes.episode import Episode
from matrixworld.play.rollout import EpisodeStatistics
from matrixworld.world.rules import COLLISION_KINDS

_COUNTED = ("collisions", "faults", "agent_steps", "capture_rate")


@dataclass(frozen=True, eq=False, repr=False)
class SafetySummary(Readable):
    """Collisions of several `episodes`, by team (pursuers, evaders) and kind (`COLLISION_KINDS`).

    An agent-step is one step of one agent that was alive as the step began; there are `agent_steps`
    of each team, (2,). A rate is the number of agent-steps with at least one collision of a kind,
    per 1000 agent-steps of the team; it does not count conflicts. Under occupation a contact of
    adversaries is nobody's fault, because contact is the aim of the game. Safety means little
    without success at the task: the `capture_rate` is the mean over the episodes.

    By team and kind, (2, 3), agents are involved in a collision (`involved_rate`), and at fault in
    one (`fault_rate`). The ends (2, 3, 2) of 95% intervals by the bootstrap-t over episodes are
    `involved_interval` and `fault_interval`; NaN without an interval, see
    `matrixworld.analysis.intervals.rate_intervals`. Agent-steps at fault in an episode are
    `fault_median`, `fault_mean` and `fault_max`, (2, 3). The share of the episodes without an agent
    at fault is `safe_share`, (2, 3), and of any team in any kind `safe_episodes`.
    """

    episodes: int
    agent_steps: NDArray[np.int64]
    capture_rate: float
    involved_rate: NDArray[np.float64]
    involved_interval: NDArray[np.float64]
    fault_rate: NDArray[np.float64]
    fault_interval: NDArray[np.float64]
    safe_share: NDArray[np.float64]
    safe_episodes: float
    fault_median: NDArray[np.float64]
    fault_mean: NDArray[np.float64]
    fault_max: NDArray[np.float64]

    def to_json(self) -> dict[str, Any]:
        """Return the summary as values that JSON can hold; ends of no interval are None."""
        plain: dict[str, Any] = plain_values(self)
        return plain

    def _parts(self) -> Parts:
        plural = "" if self.episodes == 1 else "s"
        kinds = np.ndindex(len(BOTH), len(COLLISION_KINDS))
        return [
            f"{self.episodes} episode{plural}, capture rate {self.capture_rate:.2f}, "
            f"{self.safe_episodes:.0%} without anybody at fault",
            "Agent-steps in collision, per 1000 (95% interval), and at fault in an episode:",
            [
                ("", "", "involved", "at fault", "median", "mean", "max", "none in"),
                *(self._row(t, k) for t, k in kinds),
            ],
        ]

    def _row(self, t: int, k: int) -> tuple[str, ...]:
        return (
            BOTH[t],
            COLLISION_KINDS[k],
            _printed(self.involved_rate[t, k], self.involved_interval[t, k]),
            _printed(self.fault_rate[t, k], self.fault_interval[t, k]),
            f"{self.fault_median[t, k]:.0f}",
            f"{self.fault_mean[t, k]:.1f}",
            f"{self.fault_max[t, k]:.0f}",
            f"{self.safe_share[t, k]:.0%}",
        )


def _printed(rate: float, ends: NDArray[np.float64]) -> str:
    return f"{rate:.1f}" + ("" if np.isnan(ends[0]) else f" ({ends[0]:.1f} to {ends[1]:.1f})")


class SafetyMonitor:
    """Collects collisions of episodes and summarizes them.

    Episodes come from a rollout (`add_statistics`), a `VectorEnv` (`add_infos` after each step), a
    recording such as ``env.recorded`` (`add_episode`), or as arrays (`add`).
    """

    def __init__(self) -> None:
        # Collisions (n, 2, 3), faults (n, 2, 3), agent-steps (n, 2) and capture rates (n,).
        self._parts: list[tuple[NDArray[Any], ...]] = []

    @property
    def episodes(self) -> int:
        """Number of episodes collected so far."""
        return sum(len(rates) for *_, rates in self._parts)

    def add(
        self,
        collisions: ArrayLike,
        faults: ArrayLike,
        agent_steps: ArrayLike,
        capture_rate: ArrayLike,
    ) -> None:
        """Collect episodes given as arrays, as those of `EpisodeStatistics`; they are copied.

        Parameters
        ----------
        collisions, faults : array_like of int, shape (..., 2, 3)
            Agent-steps in collision and at fault, by team and kind.
        agent_steps : array_like of int, shape (..., 2)
            Steps of living agents, by team.
        capture_rate : array_like, shape (...)
            Captured shares of the evaders, in [0, 1].

        Raises
        ------
        ValueError
            Unless faults <= collisions <= agent_steps.
        """
        rates = checks.check_floats("capture_rate", capture_rate)
        if not ((rates >= 0) & (rates <= 1)).all():
            raise ValueError(f"capture_rate: expected shares, 0 to 1, got {rates.tolist()}")
        involved = _counts("collisions", collisions, *rates.shape, 2, 3)
        at_fault = _counts("faults", faults, *rates.shape, 2, 3)
        steps = _counts("agent_steps", agent_steps, *rates.shape, 2)
        if (at_fault > involved).any() or (involved > steps[..., np.newaxis]).any():
            raise ValueError("safety: expected faults <= collisions <= agent_steps everywhere")
        by_kind = involved.reshape(-1, 2, 3), at_fault.reshape(-1, 2, 3)
        self._parts.append((*by_kind, steps.reshape(-1, 2), rates.reshape(-1)))

    def add_statistics(self, statistics: EpisodeStatistics) -> None:
        """Collect all episodes of a `rollout`."""
        checks.check_instance("statistics", statistics, EpisodeStatistics)
        self.add(*(getattr(statistics, name) for name in _COUNTED))

    def add_infos(self, infos: Mapping[str, Any]) -> None:
        """Collect the episodes that ended in a step of a `VectorEnv`, if any did."""
        if not isinstance(infos, Mapping) or not {"_episode", "episode"} <= infos.keys():
            expected = "those of a matrixworld.VectorEnv"
            raise TypeError(f"infos: expected {expected}, got {checks.shown(infos)}")
        ended = infos["_episode"]
        statistics = infos["episode"]
        if ended.any():
            self.add(*(statistics[name][ended] for name in _COUNTED))

    def add_episode(self, episode: Episode) -> None:
        """Collect a recorded episode."""
        checks.check_instance("episode", episode, Episode)

        def by_team(array: NDArray[np.bool_]) -> NDArray[np.int64]:
            """Count in an array (T, A, ...) for pursuers and evaders, (2, ...)."""
            pursuers, evaders = array[:, : episode.n_pursuers], array[:, episode.n_pursuers :]
            return np.stack([pursuers.sum(axis=(0, 1)), evaders.sum(axis=(0, 1))])

        collisions = by_team(episode.involved)
        faults = by_team(episode.fault)
        self.add(collisions, faults, by_team(episode.alive[:-1]), episode.capture_rate)

    def summary(self, *, seed: int = 0) -> SafetySummary:
        """Summarize all episodes so far; `seed` is that of the bootstrap of intervals."""
        seed = checks.check_integer("seed", seed, 0, checks.SEED_MAX)
        if not self.episodes:
            raise ValueError("safety: expected at least one whole episode, got none")
        collisions, faults, steps, rates = map(np.concatenate, zip(*self._parts, strict=True))
        intervals = rate_intervals(np.stack([collisions, faults], axis=1), steps, seed)
        return SafetySummary(
            episodes=self.episodes,
            agent_steps=steps.sum(axis=0),
            capture_rate=float(rates.mean()),
            involved_rate=_rate(collisions.sum(axis=0), steps.sum(axis=0)),
            involved_interval=intervals[0],
            fault_rate=_rate(faults.sum(axis=0), steps.sum(axis=0)),
            fault_interval=intervals[1],
            safe_share=(faults == 0).mean(axis=0),
            safe_episodes=float((faults == 0).all(axis=(1, 2)).mean()),
            fault_median=np.median(faults, axis=0),
            fault_mean=faults.mean(axis=0),
            fault_max=faults.max(axis=0),
        )


def _counts(name: str, counts: ArrayLike, *shape: int) -> NDArray[np.int64]:
    array = checks.check_integers(name, counts, np.int64)
    checks.check_shape(name, array, *shape)
    return array


def _rate(counts: NDArray[Any], agent_steps: NDArray[Any]) -> NDArray[np.float64]:
    """Return counts per 1000 agent-steps, ``(..., 2, 3)`` from ``(..., 2, 3)`` and ``(..., 2)``."""
    # A team without agent-steps has no collisions either: its rate is 0 and not NaN.
    return np.asarray(1000 * counts / np.maximum(agent_steps, 1)[..., np.newaxis])
