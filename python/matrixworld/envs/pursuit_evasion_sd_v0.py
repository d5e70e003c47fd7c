"""# -SD: Surround and remove

Hunting in a pack: prey that is surrounded is taken off the grid, and the pack goes on to the
next. As in [-S](s.md) teammates may share a cell and the prey cannot be entered.

A capture is final, so success is counted once and the pursuers are set free for more. Choose it
where an episode should come to an end by the pursuers' work. It differs from [-S](s.md) in that
alone; [-SDB](sdb.md) forbids collisions of teammates, too.

To observe: captures are judged all at once: two evaders side by side do not count as walls for
each other.

| | |
|---|---|
| Import | `from matrixworld.envs import pursuit_evasion_sd_v0` |
| Make | `pettingzoo.make("parallel", "matrixworld/pursuit_evasion_sd_v0")` |
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
| a captured evader | disappears |

Observations, actions, rewards, infos and arguments are those of all nine: see `matrixworld.envs`.

Versions: v0, the first.
"""

from __future__ import annotations

from matrixworld.envs import makers

__all__ = ["env", "parallel_env", "raw_env"]

env, raw_env, parallel_env = makers("SD")
