"""Held-out opponents, which no run trains against: scripts, and genomes from the package.

A race measures its teams against each other, which does not show it when both get worse together.
Opponents that are the same for every run show it, and make runs comparable.
"""

from __future__ import annotations

from functools import cache
from importlib.resources import as_file, files

import numpy as np
from numpy.typing import NDArray

from matrixworld._util.files import load_arrays
from matrixworld.coevolution.types import TEAMS, Genomes, Team, other
from matrixworld.world.config import WorldConfig
from matrixworld.world.policy import Network, Population, Script, TeamPolicy
from matrixworld.world.rules import VARIANTS, Capture, Rules, rules_of

FILE = "held_out.npz"
NETWORK = Network()
"""Network of the evolved opponents: views of 11 x 11, 5 actions, one hidden layer of 32."""

OCCUPIERS: tuple[Script, ...] = ("random", "clumsy-chaser", "chaser", "hunter")
SURROUNDERS: tuple[Script, ...] = (*OCCUPIERS, "surrounder")
ESCAPERS: tuple[Script, ...] = ("random", "still", "clumsy-fleer", "fleer", "dodger")


def held_out_scripts(team: Team, variant: Rules | str) -> tuple[Script, ...]:
    """Return the scripts of a team that make sense under the rules of a variant."""
    rules = rules_of(variant)
    if team not in TEAMS:
        raise ValueError(f"team: expected one of {', '.join(TEAMS)}, got {team!r}")
    if team == "evader":
        return ESCAPERS
    return SURROUNDERS if rules.capture is Capture.SURROUND else OCCUPIERS


def held_out_genomes(team: Team, variant: Rules | str) -> Genomes:
    """Return the genomes of `NETWORK` (n, genes) of a team that come with the package.

    They are from ``evolution/evolve_held_out.py``, rounded to float16; none (n = 0) for other rules
    than those of `VARIANTS`, and for a variant without shipped ones.
    """
    genomes = _shipped().get(f"{_variant_name(rules_of(variant))}.{team}s")
    if genomes is None:
        return np.empty((0, NETWORK.genome_size), np.float32)
    return genomes.astype(np.float32)


def held_out(team: Team, variant: Rules | str) -> dict[str, TeamPolicy]:
    """Return the held-out opponents of a variant.

    Parameters
    ----------
    team : {"pursuer", "evader"}
        Team that the opponents play for.
    variant : Rules or str
        The variant.

    Returns
    -------
    dict of str to Population or str
        Opponents by name: scripts, then genomes, each a population of one and named
        ``evolved-1`` and so on.

    Raises
    ------
    ValueError
        If there is no such team or variant.
    """
    opponents: dict[str, TeamPolicy] = {name: name for name in held_out_scripts(team, variant)}
    for number, genome in enumerate(held_out_genomes(team, variant), start=1):
        opponents[f"evolved-{number}"] = Population(genome, NETWORK)
    return opponents


# Read once: scores of many runs need it.
@cache
def _shipped() -> dict[str, NDArray[np.float16]]:
    with as_file(files("matrixworld.coevolution.evaluation") / FILE) as path:
        return load_arrays(path)


def _variant_name(rules: Rules) -> str | None:
    return next((name for name, row in VARIANTS.items() if row == rules), None)


def opponents_of(team: Team, config: WorldConfig) -> tuple[dict[str, TeamPolicy], str]:
    """Return the held-out opponents of a team that fit a world, and in words which do not."""
    every = held_out(other(team), config.rules)
    fitting = {name: each for name, each in every.items() if _fits(each, config)}
    name = _variant_name(config.rules)
    if name is None:
        return fitting, "no evolved opponents: they exist for the variants of the package only"
    if f"{name}.{other(team)}s" not in _shipped():
        return fitting, f"no evolved opponents: none are shipped for variant {name}"
    if len(fitting) == len(every):
        return fitting, ""
    return fitting, (
        f"no evolved opponents: they have a view of {NETWORK.fov} x {NETWORK.fov} cells and "
        f"{NETWORK.n_actions} actions, this world has {config.fov} x {config.fov} and "
        f"{config.n_actions}"
    )


def _fits(opponent: TeamPolicy, config: WorldConfig) -> bool:
    if isinstance(opponent, str):
        return True
    network = opponent.network
    return (network.fov, network.n_actions) == (config.fov, config.n_actions)
