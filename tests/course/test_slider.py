"""Sliders of the notebooks: a picture for each value, by keyboard, one without scripts; films."""

from pathlib import Path

import matplotlib.pyplot as plt
import pytest

from browser import Browser, browser  # noqa: F401  # a fixture
from course import Slider
from course.shown import film


@pytest.mark.slow
def test_a_slider_shows_the_picture_of_its_value(tmp_path: Path, browser: Browser) -> None:  # noqa: F811
    figures = {n: (plt.figure(figsize=(n, 1)), f'<"{n}"> & more') for n in (1, 2, 5, 4)}
    shown = Slider("seeds </script>", figures)
    assert not plt.get_fignums()  # the cell shows no figure beside it
    page, metadata = shown._repr_mimebundle_()
    assert metadata["image/png"]["alt"] == '<"5"> & more'
    (tmp_path / "page.html").write_text(page["text/html"])
    browser.driver.get((tmp_path / "page.html").as_uri())
    image = "[document.images[0].alt, document.images[0].naturalWidth]"
    assert browser.js(image) == ['<"5"> & more', 450]
    browser.press("\t", "\ue012")  # an arrow to the left
    assert browser.js(image) == ['<"2"> & more', 180]
    value = "[document.querySelector('label').textContent, document.images.length]"
    assert browser.js(value) == ["seeds </script>2", 1]
    assert not browser.errors()
    # What a viewer keeps that removes scripts.
    picture = page["text/html"].partition("<script>")[0]
    assert page["image/png"] in picture
    assert "<input" not in picture


def test_a_film_has_its_words() -> None:
    shown = film(plt.figure(figsize=(1, 1)), lambda frame: None, range(2), 2, '<"5"> & more')
    assert 'alt="&lt;&quot;5&quot;&gt; &amp; more"' in shown._repr_html_()
    plt.close()
