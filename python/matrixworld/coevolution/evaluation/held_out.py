"""TeamPolicy that no run has met: scripts, and genomes that come with the package.

A race measures its teams against each other: both may get worse together and nobody would see it.
TeamPolicy that stay the same for every run tell, and make runs comparable.
"""

from __future__ import annotations

from functools import cache
from importlib.resources import as_file, files

import numpy as np
from numpy.typing import NDArray

from matrixworld import Capture
from matrixworld.coevolution.storage.files import load_arrays
from matrixworld.coevolution.types import TEAMS, Genomes, Team, other
from matrixworld.config import WorldConfig
from matrixworld.policy import Network, Population, Script, TeamPolicy
from matrixworld.rules import VARIANTS, Rules, rules_of

FILE = "held_out.npz"
NETWORK = Network()
"""Of the evolved opponents: views of 11 x 11, 5 actions, one hidden layer of 32."""

OCCUPIERS: tuple[Script, ...] = ("random", "clumsy-chaser", "chaser", "hunter")
SURROUNDERS: tuple[Script, ...] = (*OCCUPIERS, "surrounder")
ESCAPERS: tuple[Script, ...] = ("random", "still", "clumsy-fleer", "fleer", "dodger")


def held_out_scripts(team: Team, variant: Rules | str) -> tuple[Script, ...]:
    """Return the scripts that play for `team`, which make sense under these rules.

    ValueError for another team or an unknown variant.
    """
    rules = rules_of(variant)
    if team not in TEAMS:
        raise ValueError(f"team: expected one of {', '.join(TEAMS)}, got {team!r}")
    if team == "evader":
        return ESCAPERS
    return SURROUNDERS if rules.capture is Capture.SURROUND else OCCUPIERS


def held_out_genomes(team: Team, variant: Rules | str) -> Genomes:
    """Return the shipped genomes (n, genes) float32 of `NETWORK`.

    n is 0 for rules of one's own and for a variant without shipped genomes. They come from
    ``evolution/evolve_held_out.py`` and are rounded to float16.
    """
    genomes = _shipped().get(f"{_variant_name(rules_of(variant))}.{team}s")
    if genomes is None:
        return np.empty((0, NETWORK.genome_size), np.float32)
    return genomes.astype(np.float32)


def held_out(team: Team, variant: Rules | str) -> dict[str, TeamPolicy]:
    """Return the held-out opponents that play for `team`, by name: scripts, then genomes.

    Each genome is a population of one, called ``evolved-1`` and so on. ValueError as in
    `held_out_scripts`.
    """
    opponents: dict[str, TeamPolicy] = {name: name for name in held_out_scripts(team, variant)}
    for number, genome in enumerate(held_out_genomes(team, variant), start=1):
        opponents[f"evolved-{number}"] = Population(genome, NETWORK)
    return opponents


@cache
def _shipped() -> dict[str, NDArray[np.float16]]:
    with as_file(files("matrixworld.coevolution.evaluation") / FILE) as path:
        return load_arrays(path)


def _variant_name(rules: Rules) -> str | None:
    return next((name for name, row in VARIANTS.items() if row == rules), None)


def fitting_opponents(team: Team, config: WorldConfig) -> tuple[dict[str, TeamPolicy], str]:
    """Return the held-out opponents of `team` in a world, and which of them it leaves out."""
    every = held_out(other(team), config.rules)
    fitting = {name: each for name, each in every.items() if _fits(each, config)}
    name = _variant_name(config.rules)
    if name is None:
        return fitting, "no evolved opponents: these rules are of one's own"
    if f"{name}.{other(team)}s" not in _shipped():
        return fitting, f"no evolved opponents: none are shipped for variant {name}"
    if len(fitting) == len(every):
        return fitting, ""
    return fitting, (
        f"no evolved opponents: they see {NETWORK.fov} x {NETWORK.fov} cells and know "
        f"{NETWORK.n_actions} actions, here it is {config.fov} x {config.fov} and "
        f"{config.n_actions}"
    )


def _fits(opponent: TeamPolicy, config: WorldConfig) -> bool:
    if isinstance(opponent, str):
        return True
    network = opponent.network
    return (network.fov, network.n_actions) == (config.fov, config.n_actions)
