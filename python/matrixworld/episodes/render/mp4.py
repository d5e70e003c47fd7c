"""MP4 films, written frame by frame."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import BinaryIO

import numpy as np
from numpy.typing import NDArray

from matrixworld.episodes.render.gif import check_timing
from matrixworld.version import install_hint

FORMAT = (
    "-f",
    "mp4",
    "-movflags",
    "+faststart",
)  # a browser can start before it has the whole file
QUALITY = ("-crf", "16", "-tune", "animation")
# Without these tags browsers guess the colour space from the height of the film.
COLOURS = (
    "-vf",
    "scale=out_color_matrix=bt709:out_range=tv,"
    "setparams=colorspace=bt709:color_primaries=bt709:color_trc=bt709",
)


def write_mp4(
    file: BinaryIO,
    draw: Callable[[int], NDArray[np.uint8]],
    times: Sequence[int],
    *,
    fps: float,
    hold: float,
) -> None:
    """Write a film (H.264, yuv420p) into a file on disk.

    Parameters
    ----------
    file : binary file
        An open file with a name; ffmpeg writes to that name.
    draw : callable
        Takes a time and returns a frame, uint8 of shape (height, width, 3). All frames have the
        same size, and both sides are even.
    times : sequence of int
        One frame is drawn for each.
    fps : float
        Frames per second, 0.1 to 50.
    hold : float
        Seconds for which the last frame is shown longer, 0 to 600.

    Raises
    ------
    ImportError
        If imageio-ffmpeg is not installed.
    ValueError
        If there are no times, or `fps` or `hold` is out of range.
    """
    check_timing(times, fps=fps, hold=hold)
    try:
        import imageio_ffmpeg
    except ImportError as error:
        raise ImportError(f"MP4 needs the extra 'video': {install_hint('video')}") from error
    last = draw(times[-1])
    height, width, _ = last.shape
    writer = imageio_ffmpeg.write_frames(
        file.name,
        (width, height),
        fps=fps,
        quality=None,
        macro_block_size=2,  # the least that yuv420p needs; a larger one would rescale frames
        ffmpeg_log_level="error",
        output_params=[*FORMAT, *QUALITY, *COLOURS],
    )
    writer.send(None)
    try:
        for time in times:
            writer.send(draw(time).tobytes())
        for _ in range(round(hold * fps)):
            writer.send(last.tobytes())
    finally:
        writer.close()
