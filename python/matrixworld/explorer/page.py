"""A self-contained page: template, script, style sheet and data in one file.

The page loads nothing: its content security policy allows the two scripts (the engine and the
page's own) and the style sheet that it holds, named by their digests, and nothing from elsewhere.
"""

from __future__ import annotations

import base64
import hashlib
import os
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

from matrixworld._util.files import replacing
from matrixworld.explorer.built import ENGINE, KINDS, built_text
from matrixworld.version import __version__

if TYPE_CHECKING:
    from jinja2 import Environment
    from markupsafe import Markup

# Markup that would end or change an element; the bundler writes none of it.
_ENDS = {"js": ("</script", "<!--", "<script"), "css": ("</style",)}

ENGINE_PLACE = "/* the engine */"
"""What stands for the engine in a page without it; the page's script looks for the same."""


def render_page(
    page: str,
    title: str,
    data: Mapping[str, Any],
    blobs: Mapping[str, bytes] | None = None,
    *,
    opens: Sequence[str] = (),
) -> str:
    """Return a page as HTML.

    Parameters
    ----------
    page : {"explorer", "playground", "class"}
        Name of its built files and of its template.
    title : str
        Title of the page; any text.
    data : mapping
        Plain values that JSON can hold, which the script reads.
    blobs : mapping of str to bytes, optional
        Large data by identifier, apart from the JSON so that the script decodes what it needs.
    opens : sequence of str, optional
        Names of pages that this one makes and opens: they are under its policy, too.

    Returns
    -------
    str
        The page.

    Raises
    ------
    ValueError
        If a number is not finite, or a built file holds markup that would end it.
    """
    scripts = {name: _inline(name, "js") for name in (ENGINE, page)}
    style = _inline(page, "css")
    more_scripts, more_styles = ([_inline(name, kind) for name in opens] for kind in KINDS)
    return (
        _environment()
        .get_template(f"{page}.html")
        .render(
            title=title,
            version=__version__,
            policy=_policy([*scripts.values(), *more_scripts], [style, *more_styles]),
            scripts=scripts,
            style=style,
            data=data,
            blobs={
                name: base64.b64encode(content).decode() for name, content in (blobs or {}).items()
            },
        )
    )


def write_page(path: str | os.PathLike[str], html: str) -> None:
    """Write a page, complete or not at all."""
    with replacing(path) as file:
        file.write(html.encode())


def _environment() -> Environment:
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
    return environment


def _inline(page: str, kind: str) -> Markup:
    """Return a built file as it stands in a page."""
    from markupsafe import Markup

    # The first line names the sources of all pages: a page changes only with its own.
    text = built_text(page, kind).partition("\n")[2]
    found = [markup for markup in _ENDS[kind] if markup in text.lower()]
    if found:
        raise ValueError(f"built file: expected no {found[0]!r}, which would end its element")
    return Markup(text)  # not escaped: browsers read scripts and style sheets as they are


def without_engine(page: str) -> str:
    """Return a page whose engine is left out; a page that opens it has the engine already."""
    return page.replace(_inline(ENGINE, "js"), ENGINE_PLACE)


def _policy(scripts: Sequence[str], styles: Sequence[str]) -> str:
    """Return the content security policy: these scripts and styles, and pictures made here."""
    return "; ".join(
        (
            "default-src 'none'",
            # Compiling the engine needs a permission of its own; `eval` of text stays forbidden.
            f"script-src {_digests(scripts)} 'wasm-unsafe-eval'",
            f"style-src {_digests(styles)}",
            "img-src data: blob:",
            "base-uri 'none'",
            "form-action 'none'",
        )
    )


def _digests(texts: Sequence[str]) -> str:
    digests = [base64.b64encode(hashlib.sha256(text.encode()).digest()) for text in texts]
    return " ".join(f"'sha256-{digest.decode()}'" for digest in digests)
