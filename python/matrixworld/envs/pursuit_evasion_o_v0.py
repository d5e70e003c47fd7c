"""# -O: Predators and prey: reached is caught

Predators hunt prey that is weaker than they are: on contact the prey is gone and the predator is
not. Teammates may share a cell, walls stop everybody. It also models a search for targets
scattered in space.

This is the standard game of the nine and the default of this package: fast captures, many
evaders, an arms race that can be measured within minutes. Choose it for co-evolution and for
first experiments. [-TO](to.md) is the same game by turns, [-D](d.md) the same with pursuers that
die on contact.

To observe: a fleeing evader is as fast as its pursuer: alone it is seldom caught in the open, but
against the border.

| | |
|---|---|
| Import | `from matrixworld.envs import pursuit_evasion_o_v0` |
| Make | `pettingzoo.make("parallel", "matrixworld/pursuit_evasion_o_v0")` |
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

env, raw_env, parallel_env = makers("O")
