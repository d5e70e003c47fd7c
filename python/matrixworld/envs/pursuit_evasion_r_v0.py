"""# -R: Targets to be reached, cells to be shared

Agents that may stand on one cell, as in multi-agent path finding with common goals and in the
predator-prey task of the multi-agent particle environments: evaders are targets, and reaching one
is what counts. Nobody disappears; a target that was reached stays on the grid and moves on.

It is the gentlest variant: a collision of agents stops nobody and only obstacles make anybody
bounce. Choose it for coverage, search and assignment of targets, or as a baseline without safety
constraints. [-B](b.md) is the same game with collisions among teammates forbidden; in [-O](o.md)
a reached evader is removed.

To observe: `capture_rate` counts every evader that was ever reached; the episode ends when all
have been.

| | |
|---|---|
| Import | `from matrixworld.envs import pursuit_evasion_r_v0` |
| Make | `pettingzoo.make("parallel", "matrixworld/pursuit_evasion_r_v0")` |
| Actions | Discrete |
| Parallel API | Yes |
| AEC API | Yes |
| Agents | `38` |
| Agents | `pursuer_0` ... `pursuer_7`, `evader_0` ... `evader_29` |
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
| an agent that collides with a teammate | goes on |
| an evader that collides with a pursuer | goes on |
| a pursuer that collides with an evader | goes on |
| an evader is captured when | a pursuer reaches it |
| a captured evader | stays and moves on |

Observations, actions, rewards, infos and arguments are those of all nine: see `matrixworld.envs`.

Versions: v0, the first.
"""

from __future__ import annotations

from matrixworld.envs import makers

__all__ = ["env", "parallel_env", "raw_env"]

env, raw_env, parallel_env = makers("R")
