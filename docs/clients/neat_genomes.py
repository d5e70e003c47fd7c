"""Genomes of neat-python as those of a game: copy this file, as `neat_networks.py` uses it.

The library numbers nodes and connections by counters, a state that no file of a run holds. Here the
number of a connection follows from its ends, so that a race that was stopped goes on unchanged.
"""

import json
import random
import zlib

import neat
from neat.genes import DefaultConnectionGene, DefaultNodeGene


def operators(config):
    """Return functions that make genomes and turn them into text, as arguments of a `Game`."""
    rules, kind = config.genome_config, neat.DefaultGenome
    rules.get_new_node_key = lambda nodes: max(nodes) + 1
    rules.innovation_tracker = neat.InnovationTracker()
    rules.innovation_tracker.get_innovation_number = lambda i, o, _: zlib.crc32(b"%d %d" % (i, o))

    def made(rng, genome, change, *parents):
        random.seed(int(rng.integers(2**32)))  # the library draws from the global generator
        change(genome, *parents, rules)
        return genome

    return {
        "initial": lambda rng: made(rng, kind(0), kind.configure_new),
        "mutate": lambda genome, rng: made(rng, genome, kind.mutate),
        "mate": lambda a, b, rng: made(rng, kind(0), kind.configure_crossover, a, b),
        "write": lambda a: json.dumps([*a.nodes.values(), *a.connections.values()], default=vars),
        "read": read,
    }


def read(text):
    """Return the genome of a text, which is a list of its genes."""
    genome = neat.DefaultGenome(0)
    genome.fitness = 0.0
    for fields in json.loads(text):
        key = fields["key"]
        node = isinstance(key, int)
        gene = DefaultNodeGene(key) if node else DefaultConnectionGene(tuple(key), 0)
        vars(gene).update({**fields, "key": gene.key})
        (genome.nodes if node else genome.connections)[gene.key] = gene
    return genome
