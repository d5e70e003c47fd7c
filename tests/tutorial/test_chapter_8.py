"""Notebook 8: what it replies to wrong answers, and whether what it keeps is current and true."""

from __future__ import annotations

import runpy
from pathlib import Path

import numpy as np
import pytest

from matrixworld import analysis, plots
from matrixworld.tutorial import check, kept
from matrixworld.tutorial.chapter_8 import CASES, verdict_on

MAKE = Path(__file__).parents[2] / "tutorials" / "make"


def unpaired(one, other):
    found = analysis.difference_of_runs(one, other)
    return "better" if found.low > 0 else "worse" if found.high < 0 else "cannot tell"


def by_the_means(one, other):
    return "better" if one.mean() > other.mean() else "worse"


@pytest.mark.parametrize(
    ("name", "answer", "says"),
    [
        ("8.1", 2, "function itself"),
        ("8.1", lambda stage, escaped: stage + 1, "Up if more"),
        ("8.1", lambda s, e: s + (e > 0.6) - (e < 0.2), "stages 0 to 3"),
        ("8.1", lambda s, e: min(max(s + int(e >= 0.6) - int(e < 0.2), 0), 3), "Exactly 60%"),
        ("8.1", lambda stage, escaped: "hunter", "number of a stage"),
        ("8.2", 32000, "a pair"),
        ("8.2", "32000, 250", "a pair"),
        ("8.2", (None, 250), "a pair"),
        ("8.2", (64000, 250), "both teams"),
        ("8.2", (1000, 250), "These are epochs"),
        ("8.2", (32000, 1000), "whole curriculum"),
        ("8.2", (32000, 50), "equally long"),
        ("8.3", 0.5, "function itself"),
        ("8.3", lambda rates: rates.mean(axis=1), "own one included"),
        ("8.3", np.diag, "to leave out"),
        ("8.3", lambda r: (r * (1 - np.eye(len(r)))).mean(axis=1), "divide by 6"),
        ("8.3", lambda r: (r.sum(axis=0) - np.diag(r)) / 5, "columns"),
        ("8.3", lambda rates: rates.mean(), "one number for each"),
        ("8.4", "autocurriculum", "a dict"),
        ("8.4", {**CASES, "A": "self play"}, "got 'self play'"),
        ("8.4", {**CASES, "D": "autocurriculum"}, "1 of 5 do not fit"),
        ("8.4", {**CASES, "A": "co-evolution"}, "does the classifier learn"),
        ("8.5", "better", "function itself"),
        ("8.5", lambda one, other: True, "Expected one of 'better'"),
        ("8.5", by_the_means, "contains 0"),
        ("8.5", unpaired, "belong together"),
        ("8.5", lambda one, other: verdict_on(other, one), "swapped"),
    ],
)
def test_replies_to_wrong_answers(name: str, answer: object, says: str) -> None:
    reply = check(name, answer)
    assert reply.right is False
    assert says in reply.text


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
