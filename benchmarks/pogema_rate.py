"""World-steps per second of POGEMA: prints ``<rate> <version>``.

    python benchmarks/pogema_rate.py 1 5

The arguments are the seconds of a repeat and the number of repeats. The world has 40 x 40 cells
without obstacles and 38 agents with views of 3 x 11 x 11; an agent that reaches its target gets a
new one; episodes have 500 steps. POGEMA needs an older Gymnasium than matrixworld, so a separate
interpreter runs this script.
"""

from __future__ import annotations

import sys

import numpy as np
import pogema

from timing import Clock

AGENTS = 38


def main() -> None:
    config = pogema.GridConfig(
        size=40,
        num_agents=AGENTS,
        obs_radius=5,
        density=0.0,
        on_target="restart",
        max_episode_steps=500,
        seed=0,
    )
    env = pogema.pogema_v0(config)
    env.reset()
    # Lists, as POGEMA's interface takes them: converting arrays would count as its time.
    rows = np.random.default_rng(0).integers(5, size=(4093, AGENTS)).tolist()

    def play(i: int) -> int:
        _, _, terminated, truncated, _ = env.step(rows[i % len(rows)])
        if all(terminated) or all(truncated):
            env.reset()
        return 1

    clock = Clock(float(sys.argv[1]), int(sys.argv[2]))
    print(clock.rate(play), pogema.__version__)


if __name__ == "__main__":
    main()
