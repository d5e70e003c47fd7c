"""Notebook 8: whether what it keeps is current and true."""

from __future__ import annotations

import runpy
from pathlib import Path

import numpy as np

from matrixworld import plots
from matrixworld.tutorial import kept
from matrixworld.tutorial.chapter_8 import verdict_on

MAKE = Path(__file__).parents[2] / "tutorials" / "make"


def test_the_numbers_of_the_paper_are_those_of_the_results() -> None:
    """Run ``tutorials/make/chapter_8_paper.py`` and ``tutorials/run.py 08`` if it fails."""
    derived = runpy.run_path(str(MAKE / "chapter_8_paper.py"))["derived"]()
    stored = kept("chapter_8_paper")
    assert set(stored) == set(derived)
    for name, values in derived.items():
        assert np.array_equal(stored[name], values), name


def test_one_seed_decides_nothing() -> None:
    assert verdict_on([0.9], [0.1]) == "cannot tell"


def test_the_kept_teams_show_what_the_predictions_say() -> None:
    stored = kept("chapter_8")
    kinds = list(stored["evaders: kinds"])
    hunter = list(stored["evaders: opponents"]).index("hunter")
    against_hunters = dict(zip(kinds, stored["evaders: scores"][..., hunter] / 1000, strict=True))
    for other in ("easy to hard", "hard to easy", "random only"):
        assert verdict_on(against_hunters["hardest only"], against_hunters[other]) == "better"
    against_walkers = stored["pursuers: ladder"][:, :, 0] / 1000
    assert verdict_on(against_walkers[:, 4], against_walkers[:, 1]) == "worse"


def test_who_is_better_depends_on_the_examiner() -> None:
    stored = kept("chapter_8")
    one, other = (list(stored["evaders: kinds"]).index(n) for n in ("co-evolution", "easy to hard"))
    scripts = stored["evaders: scores"][..., :4].mean(axis=2) / 1000
    races = stored["evaders: against races"] / 1000
    others = ~np.eye(races.shape[1], dtype=bool)
    strangers = np.array(
        [[row[own].mean() for row, own in zip(r, others, strict=True)] for r in races]
    )
    assert verdict_on(scripts[one], scripts[other]) == "worse"
    assert verdict_on(strangers[one], strangers[other]) == "better"


def test_the_concepts_are_drawn() -> None:
    texts = {text.get_text() for text in plots.learning_concepts().axes[0].texts}
    assert {"co-evolution", "curriculum learning", "arms race", "adversarial learning"} <= texts
