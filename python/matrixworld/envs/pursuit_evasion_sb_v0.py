"""# -SB: Surround it, without collisions

Predators as solid bodies. Prey is caught by being surrounded, as in [-S](s.md), and no two agents
may ever be on one cell: teammates that would collide bounce back, and so do pursuer and evader.

It is the strictest game of coordination: the ring has to be closed by agents that block each
other on the way. Choose it to study safe cooperation: after a step no two living agents share a
cell and none have swapped. In [-SDB](sdb.md) a captured evader makes room.

To observe: where several agents follow an agent that has to stay, all of them bounce: a chain,
which a step explained in words spells out.

| | |
|---|---|
| Import | `from matrixworld.envs import pursuit_evasion_sb_v0` |
| Make | `pettingzoo.make("parallel", "matrixworld/pursuit_evasion_sb_v0")` |
| Actions | Discrete |
| Parallel API | Yes |
| AEC API | Yes |
| Agents | `25` |
| Agents | `pursuer_0` ... `pursuer_19`, `evader_0` ... `evader_4` |
| Action Shape | `()` |
| Action Values | `Discrete(5)` |
| Observation Shape | `(3, 11, 11)` |
| Observation Values | `0, 1` |
| State Shape | `(3, 40, 40)` |
| State Values | `0, 1` |

| rule | |
|---|---|
| agents move | all at once |
| who runs into an obstacle or the border | bounces back |
| an agent that collides with a teammate | bounces back |
| an evader that collides with a pursuer | bounces back |
| a pursuer that collides with an evader | goes on |
| an evader is captured when | pursuers, obstacles or the border are on its four sides |
| a captured evader | stays, and is free again when the ring opens |

Observations, actions, rewards, infos and arguments are those of all nine: see `matrixworld.envs`.

Versions: v0, the first.
"""

from __future__ import annotations

from matrixworld.envs import makers

__all__ = ["env", "parallel_env", "raw_env"]

env, raw_env, parallel_env = makers("SB")
