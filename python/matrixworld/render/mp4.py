"""Pictures as an MP4 film, written frame by frame."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import BinaryIO

import numpy as np
from numpy.typing import NDArray

from matrixworld.render.gif import check_timing

FORMAT = ("-f", "mp4", "-movflags", "+faststart")  # a browser can begin before it has all
QUALITY = ("-crf", "16", "-tune", "animation")
# Browsers guess the colours of a film that does not tell them, by its height.
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
    """Write a film (H.264, yuv420p) into a file on disk, whose frames are ``draw(t)``.

    Every ``draw(t)`` gives ``(height, width, 3)`` uint8 of one size, both sides even. The last
    frame is shown `hold` seconds longer. Raises ImportError without imageio-ffmpeg, ValueError for
    no times, and for fps and hold out of range.
    """
    check_timing(times, fps=fps, hold=hold)
    try:
        import imageio_ffmpeg
    except ImportError as error:
        raise ImportError(
            "MP4 needs the extra 'video': pip install 'matrixworld[video]'"
        ) from error
    last = draw(times[-1])
    height, width, _ = last.shape
    writer = imageio_ffmpeg.write_frames(
        file.name,
        (width, height),
        fps=fps,
        quality=None,
        macro_block_size=2,  # what yuv420p needs, so that nothing is rescaled
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
