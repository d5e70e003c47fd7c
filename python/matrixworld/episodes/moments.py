"""Moments of a recorded episode, as scenes to be drawn."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from matrixworld._util.checks import check_instance, check_integer
from matrixworld.episodes.episode import Episode, moment
from matrixworld.episodes.render import MARK_STEPS, Scene


def scene(episode: Episode, step: int = -1, *, trail: int = 6, title: str | None = None) -> Scene:
    """Return one moment of an episode, to be drawn.

    Parameters
    ----------
    episode : Episode
        The recording.
    step : int, optional
        The number of steps played before the moment. Negative numbers count from the end; the
        default is the end.
    trail : int, optional
        Steps back that the trails of the agents go.
    title : str, optional
        A line of text. By default the step and the share of the evaders that are captured.

    Returns
    -------
    Scene
        The arrays to draw.

    Raises
    ------
    IndexError
        If the step is outside the episode.
    TypeError, ValueError
        If `step` or `trail` is not an integer, or `trail` is negative.
    """
    check_instance("episode", episode, Episode)
    now = moment(check_integer("step", step), episode.length)
    check_integer("trail", trail, 0)
    captures, deaths = _marks(episode, now)
    return Scene(
        positions=episode.last_positions[now],
        alive=episode.alive[now],
        captured=episode.captured[now],
        map=episode.map,
        n_pursuers=episode.n_pursuers,
        involved=episode.involved[now - 1] if now else None,
        fault=episode.fault[now - 1] if now else None,
        trail=episode.positions[max(0, now - trail) : now],
        captures=captures,
        deaths=deaths,
        title=capture_title(episode, now, f"step {now} of {episode.length}")
        if title is None
        else title,
    )


def capture_title(episode: Episode, now: int, start: str) -> str:
    """Return a line of text: `start`, and how many of the evaders are captured."""
    caught, of = int(episode.counted[now].sum()), episode.n_evaders
    share = f" ({caught / of:.0%})" if of else ""
    return f"{start}    captured {caught} of {of}{share}"


def _marks(episode: Episode, now: int) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """Return row, column and age of the captures and of the other deaths of the last steps."""
    captures: list[tuple[int, int, int]] = []
    deaths: list[tuple[int, int, int]] = []
    for step in range(max(1, now - MARK_STEPS + 1), now + 1):
        caught = _newly_captured(episode, step)
        # An evader that disappears in its capture is marked as captured, not as dead.
        gone = episode.alive[step - 1] & ~episode.alive[step]
        for marks, agents in ((captures, caught), (deaths, gone & ~caught)):
            last_positions = episode.last_positions[step, agents].tolist()
            marks.extend((row, col, now - step) for row, col in last_positions)
    return np.array(captures, int).reshape(-1, 3), np.array(deaths, int).reshape(-1, 3)


def _newly_captured(episode: Episode, step: int) -> NDArray[np.bool_]:
    """Return which agents were captured for the first time in this step, shape (A,)."""
    evaders = episode.ever_captured[step] & ~episode.ever_captured[step - 1]
    return np.concatenate([np.zeros(episode.n_pursuers, bool), evaders])
