"""# -D: Drones: every contact destroys

A swarm of drones or vehicles in the open. Nothing survives a collision: who flies into a wall,
into a teammate or into an adversary is lost, and so is whoever it hits. An evader counts as
captured when a pursuer takes it down with itself, so a team of pursuers shrinks with every
success.

It is the only variant in which a mistake cannot be made good: there is no bouncing off a wall.
Choose it where safety means survival, and look at `survival_rate` and at the episodes without a
collision. Against [-R](r.md) it shows what the same policy costs when the world does not forgive.

To observe: random walkers die out: nine in ten of them within an episode, most by walls and
teammates.

| | |
|---|---|
| Import | `from matrixworld.envs import pursuit_evasion_d_v0` |
| Make | `pettingzoo.make("parallel", "matrixworld/pursuit_evasion_d_v0")` |
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
| who runs into an obstacle or the border | disappears |
| an agent that collides with a teammate | disappears |
| an evader that collides with a pursuer | disappears |
| a pursuer that collides with an evader | disappears |
| an evader is captured when | a pursuer reaches it |
| a captured evader | disappears |

Observations, actions, rewards, infos and arguments are those of all nine: see `matrixworld.envs`.

Versions: v0, the first.
"""

from __future__ import annotations

from matrixworld.envs import makers

__all__ = ["env", "parallel_env", "raw_env"]

env, raw_env, parallel_env = makers("D")
