"""Command-line options and matches that several experiments share."""

from __future__ import annotations

import argparse

import numpy as np
from numpy.typing import ArrayLike

import matrixworld as mw
from matrixworld.coevolution import Team


def script_parser(doc: str | None, *, quick: str) -> argparse.ArgumentParser:
    """Return a parser with the first line of a script's docstring and the option ``--quick``.

    Parameters
    ----------
    doc : str or None
        Docstring of the script.
    quick : str
        Help text of ``--quick``.

    Returns
    -------
    argparse.ArgumentParser
        The parser, for further options.
    """
    # Docstrings are None under python -OO.
    parser = argparse.ArgumentParser(description=(doc or "").split("\n", 1)[0])
    parser.add_argument("--quick", action="store_true", help=quick)
    return parser


def play(
    world: mw.WorldConfig,
    team: Team,
    own: mw.Population,
    opponents: mw.Population,
    seeds: ArrayLike,
    *,
    own_genomes: ArrayLike | None = None,
    opponent_genomes: ArrayLike = 0,
) -> mw.EpisodeStatistics:
    """Play matches of one team's genomes, whichever team it is.

    Parameters
    ----------
    world : WorldConfig
        World of the matches.
    team : {"pursuer", "evader"}
        Team of `own`.
    own : Population
        Genomes of the team.
    opponents : Population
        Genomes of the other team.
    seeds : array_like of int, shape (matches,)
        Seed of each match.
    own_genomes : array_like of int, shape (matches,), optional
        Genome of `own` in each match. The default is one match of each genome.
    opponent_genomes : array_like of int, shape (matches,) or (), optional
        Genome of `opponents` in each match.

    Returns
    -------
    EpisodeStatistics
        One episode of each match.
    """
    each = np.arange(len(own.genomes)) if own_genomes is None else own_genomes
    # The engine takes pursuers first, in the populations and in the matches.
    if team == "pursuer":
        return mw.rollout(world, own, opponents, mw.Matches.of(each, opponent_genomes, seeds))
    return mw.rollout(world, opponents, own, mw.Matches.of(opponent_genomes, each, seeds))
