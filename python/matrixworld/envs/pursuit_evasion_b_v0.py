"""# -B: Path finding: teammates must not collide

Multi-agent path finding: two teammates may neither enter one cell nor swap their cells. Who
would, stays where it is, and so does the queue behind it. Evaders are the places to go to:
pursuers and evaders do not stop each other.

Choose it to study congestion, priorities and deadlocks in one team while the other merely moves
about. It is [-R](r.md) with the vertex and edge conflicts of path finding ruled out among
teammates. The other team does not help to block: for that see [-SB](sb.md).

To observe: two teammates head to head in a corridor wait for each other for ever, and both are at
fault.

| | |
|---|---|
| Import | `from matrixworld.envs import pursuit_evasion_b_v0` |
| Make | `pettingzoo.make("parallel", "matrixworld/pursuit_evasion_b_v0")` |
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
| an agent that collides with a teammate | bounces back |
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

env, raw_env, parallel_env = makers("B")
