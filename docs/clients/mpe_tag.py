"""Simple tag of the multi-agent particle environments, in which both teams learn.

``pip install mpe2``. Tried with mpe2 1.1.1, PettingZoo 1.27.0 and NumPy 2.4.6. An episode takes
about ten milliseconds, so the game is slow: processes play its matches.
"""

import numpy as np
from mpe2 import simple_tag_v3

import matrixworld as mw

env = simple_tag_v3.parallel_env(max_cycles=25)
SEEN = {agent: env.observation_space(agent).shape[0] for agent in env.possible_agents}


def action(genome, seen):
    """Return the action that a linear function of what an agent sees rates best."""
    weights = genome.reshape(5, -1)
    return np.argmax(weights[:, :-1] @ seen + weights[:, -1])


def play(chasers, runners, rng):
    """Return the mean cost of a step for the runner, at most that of a hit; outside costs, too."""
    genomes = {agent: (runners if agent == "agent_0" else chasers)[0] for agent in SEEN}
    seen, _ = env.reset(seed=int(rng.integers(2**31)))
    costs = []
    while env.agents:
        seen, rewards, *_ = env.step({agent: action(genomes[agent], seen[agent]) for agent in seen})
        costs.append(min(1, -rewards["agent_0"] / 10))
    return [np.mean(costs)]


genes = tuple(5 * (SEEN[agent] + 1) for agent in ("adversary_0", "agent_0"))
tag = mw.Game(play, genes, teams=("chasers", "runners"), slow=True)
if __name__ == "__main__":
    mw.check_game(tag, 4)
    settings = {"learner": "ga", "population": 16, "schedule": "hall-of-fame", "joint_epochs": 5}
    run = mw.evolve(game=tag, generations=6, **settings)
    print(mw.judge(run), *(run.genomes(team, -1) for team in tag.teams), sep="\n")
