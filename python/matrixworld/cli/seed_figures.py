"""The figures of a job of several seeds."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path

from matrixworld.cli.baselines import baseline_scores
from matrixworld.cli.figures import save_figure
from matrixworld.cli.held_out import Scores
from matrixworld.cli.race_groups import Group
from matrixworld.cli.seed_tables import held_out
from matrixworld.coevolution.storage.saved_run import SavedRun
from matrixworld.coevolution.types import TEAMS, Team

BANDS, VERDICTS, SCORES = "seeds", "verdicts", "held_out"
"""Bands over generations, verdicts on each seed, and scores against held-out opponents."""


def seed_figure_files(root: Path, suffix: str = "png") -> list[Path]:
    """Return the files that `draw_seeds` writes."""
    return [root / f"{name}.{suffix}" for name in (BANDS, VERDICTS, SCORES)]


def generalization_file(root: Path, suffix: str) -> Path:
    """Return the file of generalisation over seeds."""
    return root / f"generalization.{suffix}"


def draw_generalization(
    groups: Sequence[Group], baselines: Mapping[str, Sequence[SavedRun]], path: Path
) -> Path:
    """Draw generalisation of groups of races, with intervals over seeds, beside baselines.

    Parameters
    ----------
    groups : sequence of Group
        Races that differ in their seed only.
    baselines : mapping of str to list of SavedRun
        Runs of one team, one for each seed or one in all, by the name of the baseline.
    path : Path
        The file.

    Returns
    -------
    Path
        The file.
    """
    from matrixworld import plots

    named = short_names(groups, path.parent)
    scores = {name: _scores_over_seeds(group, baselines) for name, group in named.items()}
    figure = plots.generalization_over_seeds(
        {name: group.payoffs.matrices for name, group in named.items()},
        pursuer_baselines={name: each["pursuer"] for name, each in scores.items()},
        evader_baselines={name: each["evader"] for name, each in scores.items()},
    )
    return save_figure(figure, path)


def _scores_over_seeds(
    group: Group, baselines: Mapping[str, Sequence[SavedRun]]
) -> dict[Team, dict[str, list[float]]]:
    """Return the score of each baseline for each seed of a group, by team and name."""
    seeds = [baseline_scores(run, baselines) for run in group.runs]
    scores: dict[Team, dict[str, list[float]]] = {}
    for team in TEAMS:
        scores[team] = {name: [seed[team][name] for seed in seeds] for name in seeds[0][team]}
        for name, values in scores[team].items():
            # One run for all seeds tells nothing about other runs: its mean has no interval.
            if len(baselines[name]) == 1:
                scores[team][name] = [sum(values) / len(values)]
    return scores


def draw_seeds(
    groups: Sequence[Group], scores: Mapping[Path, Scores], root: Path, suffix: str = "png"
) -> list[Path]:
    """Draw the figures of groups of races that differ in their seed only.

    Parameters
    ----------
    groups : sequence of Group
        The groups.
    scores : mapping of Path to dict
        Held-out scores by run directory.
    root : Path
        Where the figures go.
    suffix : str, optional
        Format of the figures.

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
    files = seed_figure_files(root, suffix)
    return [save_figure(figure, file) for figure, file in zip(figures, files, strict=True)]


def short_names(groups: Sequence[Group], root: Path) -> dict[str, Group]:
    """Return the groups by their names in figures: without the directory of the job."""
    return {_short(group, root): group for group in groups}


def _short(group: Group, root: Path) -> str:
    path, folder = Path(group.name).absolute(), root.absolute()
    if path == folder:
        return path.name
    return path.relative_to(folder).as_posix() if path.is_relative_to(folder) else group.name
