"""# -SDB: Surround and remove, without collisions

A pack of solid bodies: as in [-SB](sb.md) no two agents may be on one cell, as in [-SD](sd.md) a
surrounded evader is removed and its cell becomes free.

It has all the constraints at once: cooperation to surround, safety on the way, and a population
of evaders that shrinks. Choose it where all of these matter.

To observe: after a capture its captors stand around an empty cell: who enters it together
bounces.

| | |
|---|---|
| Import | `from matrixworld.envs import pursuit_evasion_sdb_v0` |
| Make | `pettingzoo.make("parallel", "matrixworld/pursuit_evasion_sdb_v0")` |
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
| a captured evader | disappears |

Observations, actions, rewards, infos and arguments are those of all nine: see `matrixworld.envs`.

Versions: v0, the first.
"""

from __future__ import annotations

from matrixworld.envs import makers

__all__ = ["env", "parallel_env", "raw_env"]

env, raw_env, parallel_env = makers("SDB")
