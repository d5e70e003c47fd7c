"""A page in a notebook: a frame, and a picture where no frame can be shown."""

from __future__ import annotations

import base64
import html


def frame(page: str, title: str) -> str:
    """Return a frame that shows a page.

    Parameters
    ----------
    page : str
        The page as HTML, complete in itself.
    title : str
        What the frame shows, for readers that do not see it.

    Returns
    -------
    str
        The frame as HTML.
    """
    # The page travels inside the frame: notebooks do not serve files from elsewhere.
    return (
        f'<iframe srcdoc="{html.escape(page, quote=True)}" '
        'style="width: 100%; height: 860px; border: 0" '
        f'title="{html.escape(title, quote=True)}"></iframe>'
    )


def mime_bundle(page: str, title: str, picture: bytes) -> dict[str, str]:
    """Return a page as a notebook keeps it: in a frame, and as a picture.

    Notebooks show the frame. Where scripts do not run, such as on a page of exported notebooks, the
    picture is shown if the frame is removed from the output.

    Parameters
    ----------
    page, title : str
        As for `frame`.
    picture : bytes
        A PNG file; empty if there is none.

    Returns
    -------
    dict of str to str
        The output by MIME type.
    """
    bundle = {"text/html": frame(page, title)}
    if picture:
        bundle["image/png"] = base64.b64encode(picture).decode("ascii")
    return bundle
