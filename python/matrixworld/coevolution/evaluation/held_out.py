"""Held-out opponents: scripts and shipped genomes that no run trains against.

A race measures its teams against each other, which does not show it when both get worse together.
Opponents that are the same for every run show it, and make runs comparable.
"""

from __future__ import annotations

from functools import cache
from importlib import resources

import numpy as np
from numpy.typing import NDArray

from matrixworld._util import checks, files
from matrixworld._util.teams import PLURALS
from matrixworld.coevolution.games.pursuit import Network
from matrixworld.coevolution.types import TEAMS, Team, other
from matrixworld.world.config import WorldConfig
from matrixworld.world.masks import LEAST_FOV
from matrixworld.world.policy import CAREFUL, SCRIPTS, Population, Script, TeamPolicy
from matrixworld.world.rules import Capture, Rules, rules_of, variant_name

FILE = "held_out.npz"
NETWORK = Network()
"""Network of the evolved opponents: views of 11 x 11, 5 actions, one hidden layer of 32."""

CAREFUL_FOV = LEAST_FOV["right-of-way"]
OCCUPIERS: tuple[Script, ...] = ("random", "clumsy-chaser", "chaser", "hunter")
SURROUNDERS: tuple[Script, ...] = (*OCCUPIERS, "surrounder", "careful-team-surrounder")
ESCAPERS: tuple[Script, ...] = ("random", "still", "clumsy-fleer", "fleer", "dodger")
HELD_OUT_VERSION = 2
"""Version of the set of opponents: scores of different versions cannot be compared. In version 1
the variants with capture by surrounding had no ``careful-team-surrounder``."""


# The opponents:


def held_out_scripts(team: Team, variant: Rules | str) -> tuple[Script, ...]:
    """Return the scripts that play for a team and make sense under the rules of a variant."""
    rules = rules_of(variant)
    checks.check_choice("team", team, TEAMS)
    if team == "evader":
        return ESCAPERS
    return SURROUNDERS if rules.capture is Capture.SURROUND else OCCUPIERS


def scripts_for(team: Team, config: WorldConfig) -> tuple[Script, ...]:
    """Return all scripts that make sense for a team in a world: careful ones, too."""
    usual = [name.removeprefix(CAREFUL) for name in held_out_scripts(team, config.rules)]
    sensible = (name for name in SCRIPTS if name.removeprefix(CAREFUL) in usual)
    return tuple(name for name in sensible if plays_in(name, config))


def held_out(team: Team, variant: Rules | str) -> dict[str, TeamPolicy]:
    """Return the held-out opponents of a variant by name.

    Parameters
    ----------
    team : {"pursuer", "evader"}
        Team that they play for.
    variant : Rules or str
        Rules under which they play.

    Returns
    -------
    dict of str to policy
        First the scripts, then genomes, each a population of one and named ``evolved-1`` and so on.
        Genomes are from ``evolution/evolve_held_out.py``, rounded to float16; rules that are none
        of the package's variants have none.

    Raises
    ------
    ValueError
        If there is no such team or variant.
    """
    opponents: dict[str, TeamPolicy] = {name: name for name in held_out_scripts(team, variant)}
    genomes = _shipped().get(f"{variant_name(rules_of(variant))}.{PLURALS[team]}", ())
    for number, genome in enumerate(genomes, start=1):
        opponents[f"evolved-{number}"] = Population(genome.astype(np.float32), NETWORK)
    return opponents


# Read once: scores of many runs need it.
@cache
def _shipped() -> dict[str, NDArray[np.float16]]:
    with resources.as_file(resources.files(__package__) / FILE) as path:
        return files.load_arrays(path)


def opponents_of(scored_team: Team, config: WorldConfig) -> tuple[dict[str, TeamPolicy], str]:
    """Return the held-out opponents of a team that fit a world, and in words which do not.

    They play for the other team.
    """
    team = other(scored_team)
    every = held_out(team, config.rules)
    fitting = {name: policy for name, policy in every.items() if plays_in(policy, config)}
    blind = [name for name in every if name.startswith(CAREFUL) and name not in fitting]
    why = [
        f"no {script}: it needs a view of {CAREFUL_FOV} x {CAREFUL_FOV} cells" for script in blind
    ]
    name = variant_name(config.rules)
    if not name:
        why.append("no evolved opponents: they exist for the variants of the package only")
    elif f"{name}.{PLURALS[team]}" not in _shipped():
        why.append(f"no evolved opponents: none are shipped for variant {name}")
    elif len(fitting) + len(blind) < len(every):
        why.append(
            f"no evolved opponents: they have a view of {NETWORK.fov} x {NETWORK.fov} cells and "
            f"{NETWORK.n_actions} actions, this world has {config.fov} x {config.fov} and "
            f"{config.n_actions}"
        )
    return fitting, "; ".join(why)


def plays_in(opponent: TeamPolicy, config: WorldConfig) -> bool:
    """Return whether an opponent sees what it needs in a world."""
    if isinstance(opponent, str):
        return config.fov >= CAREFUL_FOV or not opponent.startswith(CAREFUL)
    return bool(opponent.policy.fits(config))
