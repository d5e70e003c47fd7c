"""Tournaments: the payoff matrix of two archives, each genome against each."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import Executor, as_completed
from dataclasses import replace
from functools import partial
from itertools import product
from typing import Any, TypeVar

import numpy as np
from numpy.typing import NDArray

from matrixworld._util.checks import check_instance, check_integer, check_threads
from matrixworld.coevolution.game import Game
from matrixworld.coevolution.progress import Progress, Report, silent
from matrixworld.coevolution.pursuit import Pursuit, WorldConfig
from matrixworld.coevolution.seeding import evaluation_seed
from matrixworld.coevolution.types import Payoff, team_size

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
        generation)``, which does not depend on the other pairs: each can be replayed alone.
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
    """
    game = game if isinstance(game, Game) else Pursuit(world=game)
    episodes = check_integer("episodes", episodes, 1)
    check_threads(threads)
    size = team_size(first), team_size(second)
    numbers = (range(start, start + n) for start, n in zip(generations, size, strict=True))
    # A game without chance needs no seeds, which take longer than many a game.
    exact, pairs = game.deterministic, product(*numbers)
    seeds = np.array([0 if exact else evaluation_seed(seed, g, h) for g, h in pairs], np.uint64)
    columns, part = np.arange(size[1]), known.matrix.shape if known else (0, 0)
    # One row at a time, so that the progress can be reported.
    blocks, places = [], []
    for g, (one, row) in enumerate(zip(each_genome(first), seeds.reshape(size), strict=True)):
        new = columns[part[1] if g < part[0] else 0 :]
        if len(new):
            matches = np.zeros_like(new), new, row[new]
            blocks.append(partial(game.scores, one, second, matches, episodes=episodes))
            places.append((g, new))
    kept: dict[str, NDArray[Any]] = {}
    if known:
        for name, values in {"scores": known.scores, **known.extras}.items():
            kept[name] = np.zeros((*size, *values.shape[2:]), values.dtype)
            kept[name][: part[0], : part[1]] = values
    played, total = 0, episodes * sum(len(new) for _, new in places)
    report(Progress("tournament", played, total))  # the first row may take minutes
    for number, scores in play_blocks(blocks, threads, executor):
        # Scores and lengths keep single episodes, from which intervals are computed.
        found = {"scores": scores.scores.astype(np.float32)}
        found |= {f"{name}s": scores.extras[name] for name in game.single}
        found |= {name: scores.extras[name].mean(axis=1) for name in game.means}
        for name, values in found.items():
            if name not in kept:
                kept[name] = np.zeros((*size, *values.shape[1:]), values.dtype)
            kept[name][places[number]] = values
        played += scores.scores.size
        report(Progress("tournament", played, total))
    rates, extras = kept.pop("scores"), kept
    return Payoff(rates, extras, game.teams, game.deterministic, game.score_words[0])


def play_blocks(
    blocks: Sequence[Callable[..., Block]], threads: int | None, executor: Executor | None
) -> Iterator[tuple[int, Block]]:
    """Yield the number of each block, a function of its threads, and what it returned."""
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
