"""Tournaments: the payoff matrix of two archives, each genome against each."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import Executor, as_completed
from dataclasses import replace
from functools import partial
from typing import Any, TypeVar

import numpy as np
from numpy.typing import NDArray

from matrixworld._util.checks import check_instance, check_integer, check_threads
from matrixworld.coevolution.games.game import Game, Scores
from matrixworld.coevolution.games.pursuit import Pursuit, WorldConfig
from matrixworld.coevolution.progress import Progress, Report, silent
from matrixworld.coevolution.seeding import evaluation_seed
from matrixworld.coevolution.types import Indices, Payoff, Seeds, team_size

Block = TypeVar("Block")


def tournament(
    game: Game | WorldConfig,
    first: Any,
    second: Any,
    *,
    seed: int,
    episodes: int,
    threads: int | None = None,
    generations: tuple[int, int] = (0, 0),
    known: Payoff | None = None,
    report: Report = silent,
    executor: Executor | None = None,
) -> Payoff:
    """Play every member of the first team against every member of the second.

    It is the "master tournament" of Floreano and Nolfi 1997, "God save the red queen! Competition
    in co-evolutionary robotics".

    Parameters
    ----------
    game : Game or WorldConfig
        What is played; a world stands for pursuit in it.
    first, second : population or str
        What `Game.population` returns of G and H genomes; in pursuit also names of scripts.
    seed : int
        Seed of the run. That of a pair is ``evaluation_seed(seed, pursuer generation, evader
        generation)``, which does not depend on the other pairs: each can be replayed alone. Of a
        population that plays itself, the pairs below the diagonal are those above it, seen from the
        other side.
    episodes : int
        Episodes of each pair.
    threads : int, optional
        Threads, on which results do not depend. By default one per core, with an executor one.
    generations : tuple of two int, optional
        Generations of the first members of both teams.
    known : Payoff, optional
        Results of the first members of both teams, which are not played again.
    report : callable, optional
        Called after each row of the matrix with a `Progress` in episodes.
    executor : concurrent.futures.Executor, optional
        Plays the rows, each with `threads` threads. By default they are played here.

    Returns
    -------
    Payoff
        Scores (G, H, episodes) of the first team, and what else the game tells.

    Raises
    ------
    ValueError
        If a team has no members.
    """
    game = game if isinstance(game, Game) else Pursuit(world=game)
    episodes = check_integer("episodes", episodes, 1)
    check_threads(threads)
    members = each_genome(first)
    shape = (len(members), team_size(second))
    if 0 in shape:
        raise ValueError(f"tournament: expected members of both teams, got {shape}")
    # One row at a time, so that the progress can be reported.
    is_half = _is_one_population(game, first, second)
    unplayed = _unplayed(shape, known)
    if is_half:  # the other half are the same matches from the other side
        least = 0 if game.plays_itself(len(members)) else 1
        unplayed = [(row, columns[columns >= row + least]) for row, columns in unplayed]
        unplayed = [(row, columns) for row, columns in unplayed if len(columns)]
    plays = []
    for row, columns in unplayed:
        seeds = _seeds(game, seed, generations[0] + row, generations[1] + columns)
        matches = np.zeros_like(columns), columns, seeds
        plays.append(partial(game.rollout, members[row], second, matches, episodes=episodes))
    arrays = {} if known is None else _enlarged(known, shape)
    done = 0
    total = episodes * sum(len(columns) for _, columns in unplayed)
    report(Progress("tournament", done, total))  # the first row may take minutes
    for number, scores in play_blocks(plays, threads, executor):
        row, columns = unplayed[number]
        for name, values in _row_arrays(game, scores).items():
            if name not in arrays:
                arrays[name] = np.zeros((*shape, *values.shape[1:]), values.dtype)
            arrays[name][row, columns] = values
            if is_half:
                arrays[name][columns, row] = values
        if is_half:
            beyond = columns > row
            arrays["scores"][columns[beyond], row] = scores.of("evader")[beyond]
            if scores.others is not None:
                arrays["others"][columns[beyond], row] = scores.scores[beyond]
        done += scores.scores.size
        report(Progress("tournament", done, total))
    rates = arrays.pop("scores")
    others = arrays.pop("others", None)
    if is_half:  # both sides of a match against itself are one member
        itself = np.arange(len(members))
        own = 0.5 if others is None else (rates[itself, itself] + others[itself, itself]) / 2.0
        for each in (rates, others):
            if each is not None:
                each[itself, itself] = own
    words = game.score_words[0]
    return Payoff(rates, arrays, game.teams, game.deterministic, words, others)


def _is_one_population(game: Game, first: Any, second: Any) -> bool:
    """Return whether both sides of a symmetric game have the same members."""
    return game.symmetric and np.array_equal(first.genomes, second.genomes)


def _unplayed(shape: tuple[int, int], known: Payoff | None) -> list[tuple[int, Indices]]:
    """Return the rows of the payoff with columns that are not known, and these columns."""
    known_rows, known_columns = (0, 0) if known is None else known.matrix.shape
    unplayed = []
    for row in range(shape[0]):
        columns = np.arange(known_columns if row < known_rows else 0, shape[1])
        if len(columns):
            unplayed.append((row, columns))
    return unplayed


def _seeds(game: Game, run_seed: int, generation: int, others: Indices) -> Seeds:
    """Return the seeds of the pairs of a generation of the first team and those of the second."""
    # A game without chance needs no seeds, which take longer than many a game.
    if game.deterministic:
        return np.zeros(len(others), np.uint64)
    return np.array([evaluation_seed(run_seed, generation, int(h)) for h in others], np.uint64)


def _enlarged(known: Payoff, shape: tuple[int, int]) -> dict[str, NDArray[Any]]:
    """Return the arrays of a payoff of the first members, with room for those of all members."""
    rows, columns = known.matrix.shape
    arrays = {}
    others = {} if known.others is None else {"others": known.others}
    for name, values in {"scores": known.scores, **others, **known.extras}.items():
        arrays[name] = np.zeros((*shape, *values.shape[2:]), values.dtype)
        arrays[name][:rows, :columns] = values
    return arrays


def _row_arrays(game: Game, scores: Scores) -> dict[str, NDArray[Any]]:
    """Return what a payoff holds of the matches of a row, by name."""
    # Scores and lengths keep single episodes, from which intervals are computed.
    arrays = {"scores": scores.scores.astype(np.float32)}
    if scores.others is not None:
        arrays["others"] = scores.others.astype(np.float32)
    for name in game.single:
        arrays[f"{name}s"] = scores.extras[name]
    for name in game.means:
        arrays[name] = scores.extras[name].mean(axis=1)
    return arrays


def play_blocks(
    blocks: Sequence[Callable[..., Block]], threads: int | None, executor: Executor | None
) -> Iterator[tuple[int, Block]]:
    """Yield the number of each block, a function of its threads, and what it has returned."""
    if executor is None:
        for number, play in enumerate(blocks):
            yield number, play(threads=threads)
        return
    check_instance("executor", executor, Executor)
    futures = {
        executor.submit(play, threads=threads or 1): number for number, play in enumerate(blocks)
    }
    try:
        for future in as_completed(futures):
            # Popped, so that the statistics are not held twice.
            yield futures.pop(future), future.result()
    finally:
        # After an error or Ctrl-C.
        for future in futures:
            future.cancel()


def each_genome(team: Any) -> list[Any]:
    """Return each genome of a team as a population, or what else plays for it."""
    if not hasattr(team, "genomes"):
        return [team]
    return [replace(team, genomes=genome[np.newaxis]) for genome in team.genomes]
