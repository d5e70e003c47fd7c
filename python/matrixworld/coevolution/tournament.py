"""All against all: the payoff matrix of two archives."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, fields
from typing import Any

import numpy as np
from numpy.typing import NDArray

from matrixworld.coevolution.keys import evaluation_seed
from matrixworld.config import WorldConfig
from matrixworld.policy import Population, Script
from matrixworld.rollout import Matches, Scores, rollout

Rollout = Callable[..., Scores]
"""Scores matches, with the arguments of `matrixworld.rollout` and, like it, a pure function.

This is the seam of every run: threads work behind it today, a cluster's `map` can tomorrow.
"""

Opponents = Population | Script
"""One team in matches: genomes, or the name of a scripted policy."""


@dataclass(frozen=True)
class Payoff:
    """What G pursuers and H evaders score against each other in `n` episodes a pair.

    Row g is pursuer g, column h evader h.

    Attributes
    ----------
    capture_rates : (G, H, n) float32, share of evaders captured in each episode.
    lengths : (G, H, n) int32, steps of each episode.
    collisions, faults : (G, H, 2, 3) float64, mean agent-steps an episode in which an agent was
        involved, or at fault, in a collision; by team (pursuers, evaders) and kind (obstacle,
        teammate, adversary).
    agent_steps : (G, H, 2) float64, mean steps an episode by agents that were alive, by team.
    pursuer_survivors, evader_survivors : (G, H) float64, mean number alive at the end.
    """

    capture_rates: NDArray[np.float32]
    lengths: NDArray[np.int32]
    collisions: NDArray[np.float64]
    faults: NDArray[np.float64]
    agent_steps: NDArray[np.float64]
    pursuer_survivors: NDArray[np.float64]
    evader_survivors: NDArray[np.float64]

    @property
    def capture_rate(self) -> NDArray[np.float64]:
        """The payoff matrix (G, H): mean capture rate, the evaders' payoff being one minus it."""
        return np.asarray(self.capture_rates.mean(axis=2, dtype=np.float64))

    @property
    def capture_rate_std(self) -> NDArray[np.float64]:
        """(G, H) standard deviation of the capture rate over episodes."""
        return np.asarray(self.capture_rates.std(axis=2, dtype=np.float64))

    @property
    def length(self) -> NDArray[np.float64]:
        """(G, H) mean steps of an episode."""
        return np.asarray(self.lengths.mean(axis=2))

    @property
    def length_std(self) -> NDArray[np.float64]:
        """(G, H) standard deviation of the steps over episodes."""
        return np.asarray(self.lengths.std(axis=2))

    def arrays(self) -> dict[str, NDArray[Any]]:
        """Return fields, means and deviations by name, as payoff.npz holds them."""
        derived = ("capture_rate", "capture_rate_std", "length", "length_std")
        return {name: getattr(self, name) for name in (*(f.name for f in fields(self)), *derived)}

    @classmethod
    def from_arrays(cls, arrays: Mapping[str, NDArray[Any]]) -> Payoff:
        """Return the payoff that `arrays` came from."""
        return cls(**{item.name: arrays[item.name] for item in fields(cls)})


def tournament(
    config: WorldConfig,
    pursuers: Opponents,
    evaders: Opponents,
    *,
    seed: int,
    episodes: int,
    threads: int | None = None,
    play: Rollout = rollout,
    first: tuple[int, int] = (0, 0),
    on_row: Callable[[int], None] = lambda played: None,
) -> Payoff:
    """Play every pursuer against every evader: the master tournament of Floreano & Nolfi 1997.

    Parameters
    ----------
    config : the world.
    pursuers, evaders : populations of G and H genomes, or scripted teams (then 1).
    seed : run seed. A cell's match seed is ``evaluation_seed(seed, pursuer generation, evader
        generation)`` whatever else is played: it can be replayed on its own.
    episodes : per cell.
    first : generations of the first pursuer and the first evader, which enter the seeds.
    on_row : called after each row with the episodes played so far.
    """
    rows = []
    n_evaders = _count(evaders)
    for g in range(_count(pursuers)):
        seeds = [evaluation_seed(seed, first[0] + g, first[1] + h) for h in range(n_evaders)]
        matches = Matches.of(g, np.arange(n_evaders), np.array(seeds, dtype=np.uint64))
        rows.append(play(config, pursuers, evaders, matches, worlds=episodes, threads=threads))
        on_row(len(rows) * n_evaders * episodes)
    return _payoff(rows)


def _count(team: Opponents) -> int:
    return 1 if isinstance(team, str) else len(team.genomes)


def _payoff(rows: list[Scores]) -> Payoff:
    def stacked(name: str) -> NDArray[Any]:
        return np.stack([getattr(row, name) for row in rows])

    return Payoff(
        capture_rates=stacked("capture_rate").astype(np.float32),
        lengths=stacked("length").astype(np.int32),
        collisions=stacked("collisions").mean(axis=2),
        faults=stacked("faults").mean(axis=2),
        agent_steps=stacked("agent_steps").mean(axis=2),
        pursuer_survivors=stacked("pursuer_survivors").mean(axis=2),
        evader_survivors=stacked("evader_survivors").mean(axis=2),
    )
