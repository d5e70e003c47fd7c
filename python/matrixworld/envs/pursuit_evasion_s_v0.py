"""# -S: Surround it: the pursuit of Benda

The classical pursuit problem of Benda, Jagannathan and Dodhiawala (1986), in the form of Sun et
al. (2023): prey is caught when it cannot move, with a pursuer, an obstacle or the border on each
of its four sides. It takes coordination: four pursuers in the open, three at the border, two in a
corner.

Pursuers may stand on one cell, so they do not stand in each other's way, but the prey cannot be
entered: who tries bounces off. Captures last only as long as the ring is closed, and the evader
is free again when it opens. Choose it to study cooperation. [-SB](sb.md) forbids collisions of
teammates, [-SD](sd.md) removes captured evaders.

To observe: `capture_rate` can fall again: it counts who is surrounded at this moment,
`ever_capture_rate` who ever was.

| | |
|---|---|
| Import | `from matrixworld.envs import pursuit_evasion_s_v0` |
| Make | `pettingzoo.make("parallel", "matrixworld/pursuit_evasion_s_v0")` |
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
| an agent that collides with a teammate | goes on |
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

env, raw_env, parallel_env = makers("S")
