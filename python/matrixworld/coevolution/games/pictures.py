"""Pictures of a match, as the function `show` of a game returns them."""

from __future__ import annotations

import base64
import io
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray
from PIL import Image

from matrixworld._util import checks
from matrixworld._util.files import replacing

FRAME = 120  # milliseconds of a frame


class Picture(NamedTuple):
    """The content of a file of an image, or of a film."""

    suffix: str  # ".png" or ".gif"
    content: bytes

    def save(self, path: str | Path) -> None:
        """Write the file, whose suffix has to be that of its kind; ValueError for another one."""
        if Path(path).suffix.lower() != self.suffix:
            raise ValueError(f"path: expected one that ends with {self.suffix}, got {path}")
        with replacing(path) as file:
            file.write(self.content)

    def _repr_html_(self) -> str:
        encoded = base64.b64encode(self.content).decode()
        return f'<img src="data:{self.kind};base64,{encoded}" alt="a match">'

    @property
    def kind(self) -> str:
        """What browsers call its kind."""
        return f"image/{self.suffix.removeprefix('.')}"


def picture_of(shown: Any) -> Picture:
    """Return an image (rows, columns, 3) of uint8, or a film of such frames; ValueError of others.

    Frames are a list, or an array (frames, rows, columns, 3).
    """
    is_film = isinstance(shown, list | tuple) or np.ndim(shown) == 4
    images = [_image(each) for each in shown] if is_film else [_image(shown)]
    if len({image.size for image in images}) != 1:
        sizes = sorted({image.size for image in images})
        raise ValueError(f"show: expected frames of one size, got {sizes or 'none'}")
    buffer = io.BytesIO()
    first, *others = images
    if not is_film:
        first.save(buffer, "PNG")
        return Picture(".png", buffer.getvalue())
    first.save(buffer, "GIF", save_all=True, append_images=others, duration=FRAME, loop=0)
    return Picture(".gif", buffer.getvalue())


def _image(shown: Any) -> Image.Image:
    array: NDArray[Any] = checks.unmasked("show", shown)
    if array.dtype != np.uint8 or array.ndim != 3 or array.shape[2] != 3 or not array.size:
        raise ValueError(
            "show: expected text, an image of uint8 (rows, cols, 3) or a list of such frames, "
            f"got {array.dtype} {array.shape}"
        )
    return Image.fromarray(array)
