"""Files of genomes: a policy network with its weights as one npz file of numbers, never code."""

from __future__ import annotations

import os
from dataclasses import asdict
from pathlib import Path
from typing import cast

import numpy as np

from matrixworld._util.checks import check_choice
from matrixworld._util.files import DamagedFileError, parse_npz, read_content, save_arrays
from matrixworld.play.network_policy import NetworkPolicy
from matrixworld.world.policy import TEAMS, Network, Population, Team

FORMS = {
    "genome": ("f", 1),
    "hidden": ("iuf", 1),  # an empty list is an array of floats
    "activation": ("U", 0),
    "memory": ("U", 0),
    "fov": ("iu", 0),
    "n_actions": ("iu", 0),
    "sampled": ("b", 0),
    "team": ("U", 0),
}
"""Kinds of dtypes, as ``dtype.kind``, and number of dimensions of each array."""


def save_genome(path: str | os.PathLike[str], team: Team, policy: NetworkPolicy) -> None:
    """Write a policy as a file that `read_genome` reads and that a class tournament plays.

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
    arrays = asdict(policy.network) | {"genome": policy.genome, "team": team}
    arrays["hidden"] = np.array(policy.network.hidden, np.int64)
    save_arrays(Path(path), arrays)


def read_genome(path: str | os.PathLike[str]) -> tuple[Team, Population]:
    """Return the team of a genome's file, and the genome as a population of one.

    Parameters
    ----------
    path : str or path
        The file, of `save_genome`, or of ``numpy.savez`` with the same keys.

    Returns
    -------
    team : {"pursuer", "evader"}
        The team for which it plays.
    population : Population
        The genome with its network.

    Raises
    ------
    OSError
        If the file cannot be read.
    DamagedFileError
        If it is damaged or not of this form.
    """
    return parse_genome(Path(path), read_content(Path(path)))


def parse_genome(path: Path, content: bytes) -> tuple[Team, Population]:
    """Return what `read_genome` returns, from the content of the file `path`."""
    arrays = parse_npz(path, content)
    for name, (kinds, ndim) in FORMS.items():
        if name not in arrays:
            raise DamagedFileError(path, f"expected an array {name!r}, got {', '.join(arrays)}")
        if arrays[name].dtype.kind not in kinds or arrays[name].ndim != ndim:
            expected = f"expected dtype of kind {kinds} and {ndim} dimensions"
            got = f"dtype {arrays[name].dtype} and shape {arrays[name].shape}"
            raise DamagedFileError(path, f"{name}: {expected}, got {got}")
    try:
        team = str(arrays["team"])
        check_choice("team", team, TEAMS)
        network = Network(
            tuple(int(size) for size in arrays["hidden"]),
            activation=str(arrays["activation"]),  # type: ignore[arg-type]
            memory=str(arrays["memory"]),  # type: ignore[arg-type]
            fov=int(arrays["fov"]),
            n_actions=int(arrays["n_actions"]),
            sampled=bool(arrays["sampled"]),
        )
        return cast(Team, team), Population(arrays["genome"], network)
    except (OverflowError, TypeError, ValueError) as error:
        raise DamagedFileError(path, str(error)) from error
