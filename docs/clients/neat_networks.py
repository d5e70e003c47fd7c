"""Networks of neat-python, whose shapes evolve, too: catchers stay near runners on a ring.

``pip install neat-python``. Tried with neat-python 2.0.0. Settings are in `neat_networks.cfg`.
"""

from pathlib import Path

import neat

import matrixworld as mw
from neat_genomes import operators

KINDS = neat.DefaultGenome, neat.DefaultReproduction, neat.DefaultSpeciesSet, neat.DefaultStagnation
config = neat.Config(*KINDS, Path(__file__).with_suffix(".cfg"))
SPEEDS, STEPS = (0.10, 0.08), 20  # in parts of the ring


def play(catcher, runner, rng):
    """Return how near the catcher is, on average: 1 at the same place, 0 on the other side."""
    networks = [neat.nn.FeedForwardNetwork.create(each, config) for each in (catcher, runner)]
    places, near = rng.random(2), 0.0
    for step in range(STEPS):
        ahead = (places[1] - places[0] + 0.5) % 1 - 0.5  # of the catcher, from -1/2 to 1/2
        for team, network in enumerate(networks):
            places[team] += SPEEDS[team] * network.activate((ahead, abs(ahead), step / STEPS))[0]
        near += 1 - 2 * abs((places[1] - places[0] + 0.5) % 1 - 0.5)
    return near / STEPS


ring = mw.Game(play, teams=("catchers", "runners"), **operators(config))

if __name__ == "__main__":
    mw.check_game(ring)
    run = mw.evolve(game=ring, schedule="hall-of-fame", generations=6)
    print(mw.judge(run), *(run.genomes(team, -1) for team in ring.teams), sep="\n")
