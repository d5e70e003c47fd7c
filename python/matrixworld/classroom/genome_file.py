"""A single genome with its network as an npz file: what students hand in, never code."""

from __future__ import annotations

import os
from pathlib import Path

import numpy as np

from matrixworld._util.checks import check_choice
from matrixworld._util.files import save_arrays
from matrixworld._util.reading import DamagedFileError
from matrixworld.classroom.untrusted import read_arrays, read_content
from matrixworld.coevolution.types import TEAMS, Team
from matrixworld.play import NetworkPolicy
from matrixworld.world.policy import Network, Population

MOST_LAYERS = 16
"""The most hidden layers: a million layers of one unit would fit into a file, and take hours."""

_FORMS = {
    "genome": ("f", 1),
    "hidden": ("iuf", 1),  # an empty list is an array of floats
    "activation": ("U", 0),
    "fov": ("iu", 0),
    "n_actions": ("iu", 0),
    "sampled": ("b", 0),
    "team": ("U", 0),
}


def save_genome(path: str | os.PathLike[str], team: Team, policy: NetworkPolicy) -> None:
    """Write a policy as a file that `matrixworld class` plays.

    Parameters
    ----------
    path : str or path
        The file, which is replaced if it exists.
    team : {"pursuer", "evader"}
        The team for which it plays.
    policy : NetworkPolicy
        The policy, such as ``open_run(directory).policy("pursuer")``.

    Raises
    ------
    ValueError
        If there is no such team.
    """
    check_choice("team", team, TEAMS)
    network = policy.network
    save_arrays(
        Path(path),
        {
            "genome": policy.genome,
            "hidden": np.array(network.hidden, np.int64),
            "activation": network.activation,
            "fov": network.fov,
            "n_actions": network.n_actions,
            "sampled": network.sampled,
            "team": team,
        },
    )


def load_genome(path: str | os.PathLike[str]) -> tuple[Team, Population]:
    """Return the team of a genome's file, and the genome as a population of one.

    Parameters
    ----------
    path : str or path
        A file as `save_genome` writes it; ``numpy.savez`` with the same keys can make one, too.

    Returns
    -------
    team : {"pursuer", "evader"}
        The team.
    population : Population
        The genome with its network.

    Raises
    ------
    DamagedFileError
        If the file is damaged, too large, or not of this form.
    OSError
        If it cannot be read.
    """
    file = Path(path)
    return genome_of(file, read_content(file, "genome"))


def genome_of(path: Path, content: bytes) -> tuple[Team, Population]:
    """Return team and genome in the content of a file, as `load_genome`."""
    arrays = read_arrays(path, content, _FORMS)
    team, layers = str(arrays["team"]), len(arrays["hidden"])
    if layers > MOST_LAYERS:
        raise DamagedFileError(path, f"hidden: expected at most {MOST_LAYERS} layers, got {layers}")
    try:
        check_choice("team", team, TEAMS)
        network = Network(
            tuple(int(size) for size in arrays["hidden"]),
            activation=str(arrays["activation"]),  # type: ignore[arg-type]
            fov=int(arrays["fov"]),
            n_actions=int(arrays["n_actions"]),
            sampled=bool(arrays["sampled"]),
        )
        return team, Population(arrays["genome"], network)  # type: ignore[return-value]
    except (OverflowError, TypeError, ValueError) as error:
        raise DamagedFileError(path, str(error)) from error
