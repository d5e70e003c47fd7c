"""# -TO: Cops and robbers: one after the other

Agents take turns: pursuers by number, then evaders by number, each on the board that the others
have left. It is the game of cops and robbers, or vertex pursuit, on a grid (Quilliot 1978;
Nowakowski and Winkler 1983; Bonato and Nowakowski 2011), and the interaction of PettingZoo's
pursuit. Contact is as in [-O](o.md): the evader is gone.

No two agents move at the same time, so nobody can swap cells with anybody, and the later sees
what the earlier did. Choose it for games on graphs and to see what simultaneous moves change. Its
own form is the AEC environment; the parallel one plays a round with actions that were all
committed before it.

To observe: the scripts chaser and fleer make more captures here than in [-O](o.md): in its turn a
chaser reaches the cell that its prey is on, where moving at once it reaches the one that its prey
has left.

| | |
|---|---|
| Import | `from matrixworld.envs import pursuit_evasion_to_v0` |
| Make | `pettingzoo.make("parallel", "matrixworld/pursuit_evasion_to_v0")` |
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
| agents move | one after the other |
| who runs into an obstacle or the border | bounces back |
| an agent that collides with a teammate | goes on |
| an evader that collides with a pursuer | disappears |
| a pursuer that collides with an evader | goes on |
| an evader is captured when | a pursuer reaches it |
| a captured evader | disappears |

Observations, actions, rewards, infos and arguments are those of all nine: see `matrixworld.envs`.

Versions: v0, the first.
"""

from __future__ import annotations

from matrixworld.envs import makers

__all__ = ["env", "parallel_env", "raw_env"]

env, raw_env, parallel_env = makers("TO")
