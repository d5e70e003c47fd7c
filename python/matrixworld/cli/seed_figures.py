"""The figures of a job of several seeds."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path

from matrixworld.cli.figures import save_figure
from matrixworld.cli.held_out import Scores
from matrixworld.cli.race_groups import Group
from matrixworld.cli.seed_tables import held_out
from matrixworld.coevolution.types import TEAMS

BANDS, VERDICTS, SCORES = "seeds.png", "verdicts.png", "held_out.png"
"""Bands over generations, verdicts on each seed, and scores against held-out opponents."""


def seed_figure_files(root: Path) -> list[Path]:
    """Return the files that `draw_seeds` writes."""
    return [root / name for name in (BANDS, VERDICTS, SCORES)]


def draw_seeds(groups: Sequence[Group], scores: Mapping[Path, Scores], root: Path) -> list[Path]:
    """Draw the figures of groups of races that differ in their seed only.

    Parameters
    ----------
    groups : sequence of Group
        The groups.
    scores : mapping of Path to dict
        Held-out scores by run directory.
    root : Path
        Where the figures go.

    Returns
    -------
    list of Path
        The files.
    """
    from matrixworld import plots

    named = short_names(groups, root)
    payoffs = {name: group.payoffs.matrices for name, group in named.items()}
    judgements = {name: group.judgement for name, group in named.items()}
    figures = (
        plots.seed_bands(payoffs, judgements),
        plots.verdict_strip(
            judgements,
            {name: group.seeds for name, group in named.items()},
            {name: group.missing for name, group in named.items()},
        ),
        plots.seed_scores(
            {n: {team: held_out(g, scores, team) for team in TEAMS} for n, g in named.items()}
        ),
    )
    files = seed_figure_files(root)
    return [save_figure(figure, file) for figure, file in zip(figures, files, strict=True)]


def short_names(groups: Sequence[Group], root: Path) -> dict[str, Group]:
    """Return the groups by their names in figures: without the directory of the job."""
    return {_short(group, root): group for group in groups}


def _short(group: Group, root: Path) -> str:
    path, folder = Path(group.name).absolute(), root.absolute()
    if path == folder:
        return path.name
    return path.relative_to(folder).as_posix() if path.is_relative_to(folder) else group.name
