"""A self-contained page: template, engine, script, style sheet and data in one file.

The page loads nothing: its content security policy allows the scripts and the style sheet that it
holds, named by their digests, and nothing from elsewhere. A page is a directory of ``web/src`` in
the repository; ``npm ci && npm run build`` in ``web/`` writes its script and its style sheet anew.
"""

from __future__ import annotations

import base64
import hashlib
import html
import os
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from matrixworld._util.files import replacing
from matrixworld.version import __version__

if TYPE_CHECKING:
    from markupsafe import Markup

BUILT = Path(__file__).parent / "built"
PAGES = tuple(sorted(path.stem for path in BUILT.glob("*.css")))  # all pages by name
ENGINE = "engine"  # name of the script that holds the engine as WebAssembly, which all pages share
ENGINE_PLACE = "/* the engine */"
"""What stands for the engine in a page without it; the page's script looks for the same."""


def render_page(
    page: str,
    title: str,
    data: Mapping[str, Any],
    blobs: Mapping[str, bytes] | None = None,
    *,
    opens: Sequence[str] = (),
    works: bool = False,
    engine: bool = True,
    folder: Path = BUILT,
) -> str:
    """Return a page as HTML: one of `PAGES`, or one whose script and style sheet are in `folder`.

    Its script reads `data` and of `blobs` what it needs. Pages that it `opens` are under its
    policy, too; one that `works` computes in a worker, which it makes of its own scripts.
    """
    # Jinja takes 0.1 s to import, which commands without pages need not wait for.
    from jinja2 import Environment, PackageLoader, StrictUndefined

    environment = Environment(
        loader=PackageLoader("matrixworld.explorer"),
        autoescape=True,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
    )
    # The filter `tojson` escapes <, > and &, so that no text can end the element that holds it.
    environment.policies["json.dumps_kwargs"] = {"allow_nan": False, "separators": (",", ":")}
    folders = {page: folder, **dict.fromkeys(opens, BUILT)}
    styles = {name: built(name, "css", place) for name, place in folders.items()}
    scripts = {name: built(name, "js", place) for name, place in {ENGINE: BUILT, **folders}.items()}
    policy = _policy([*scripts.values()], [*styles.values()], works=works)
    return environment.get_template("page.html").render(
        title=title,
        version=__version__,
        policy=policy,
        scripts={name: scripts[name] for name in (*([ENGINE] if engine else []), page)},
        style=styles[page],
        data=data,
        blobs={name: base64.b64encode(blob).decode() for name, blob in (blobs or {}).items()},
    )


def built(page: str, suffix: str, folder: Path = BUILT) -> Markup:
    """Return a built file as it stands in a page."""
    from markupsafe import Markup

    # The first line names the sources of all pages: a page changes only with its own.
    text = (folder / f"{page}.{suffix}").read_text(encoding="utf-8").partition("\n")[2]
    return Markup(text)  # not escaped: browsers read scripts and style sheets as they are


def without_engine(page: str) -> str:
    """Return a page whose engine is left out; a page that opens it has the engine already."""
    return page.replace(built(ENGINE, "js"), ENGINE_PLACE)


def _policy(scripts: Sequence[str], styles: Sequence[str], *, works: bool) -> str:
    """Return the content security policy: these scripts and styles, and pictures made here."""
    rules = [
        "default-src 'none'",
        # Compiling the engine needs a permission of its own; `eval` of text stays forbidden.
        f"script-src {_digests(scripts)} 'wasm-unsafe-eval'",
        f"style-src {_digests(styles)}",
        "img-src data: blob:",
    ]
    return "; ".join(
        [*rules, *["worker-src blob:"] * works, "base-uri 'none'", "form-action 'none'"]
    )


def _digests(texts: Sequence[str]) -> str:
    digests = [base64.b64encode(hashlib.sha256(text.encode()).digest()) for text in texts]
    return " ".join(f"'sha256-{digest.decode()}'" for digest in digests)


def write_page(path: str | os.PathLike[str], page: str, *, force: bool = True) -> None:
    """Write a page, complete or not at all; FileExistsError if a file is there, without `force`."""
    if Path(path).exists() and not force:
        raise FileExistsError(f"{os.fspath(path)}: exists; force=True replaces it")
    with replacing(path) as file:
        file.write(page.encode())


def mime_bundle(page: str, title: str, picture: bytes) -> dict[str, str]:
    """Return a page as a notebook keeps it: in a frame, and as a picture, a PNG file or nothing.

    The picture is for pages of exported notebooks, from which the frame is removed.
    """
    # The page travels inside the frame: notebooks do not serve files from elsewhere.
    bundle = {
        "text/html": f'<iframe srcdoc="{html.escape(page, quote=True)}" '
        'style="width: 100%; height: 860px; border: 0" '
        f'title="{html.escape(title, quote=True)}"></iframe>'
    }
    if picture:
        bundle["image/png"] = base64.b64encode(picture).decode("ascii")
    return bundle
