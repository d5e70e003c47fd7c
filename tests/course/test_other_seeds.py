"""Headline claims of the notebooks hold for seeds that no notebook shows."""

import runpy
import sys
from functools import cache
from typing import Any

import pytest

from course import kept
from matrixworld import analysis
from notebooks import TUTORIALS

MORE, LESS = 1, -1
EXAMINERS = ("scripts", "evolved strangers", "co-evolved")
"""Of notebook 8."""

CLAIMS = {
    # notebook and claim: source, effect, sign
    "3: a champion loses most of its gain in new matches": (
        "chase", "lost in new matches, less what is left", MORE,
    ),
    "3: so does the best of random genomes": ("chase", "curse of random search", MORE),
    "3: children only beat parents and children": (
        "chase", "children only minus parents and children", MORE,
    ),
    "3: evolution finds more than random search": (
        "chase", "children only minus random search", MORE,
    ),
    "3: without a penalty evaders overlap": ("crowding", "overlap", MORE),
    "3: without a penalty a few more escape": ("crowding", "escape rate", MORE),
    "3: and their matches differ more": ("crowding", "spread of the escape rate", MORE),
    "4: the scalar game climbs highest": ("numbers games", "scalar minus focusing", MORE),
    "4: the intransitive game stays lowest": ("numbers games", "focusing minus intransitive", MORE),
    "4: on average the tournament finds a better generation": (
        "tournament", "ones of the picked generation", MORE,
    ),
    "4: the diagonal falls at first": ("red queen", "diagonal at first", LESS),
    "4: and rises later": ("red queen", "diagonal later", MORE),
    "4: pursuers get worse at first": ("red queen", "pursuers at first", LESS),
    "4: and better later": ("red queen", "pursuers later", MORE),
    "4: pursuers improve in the whole race": ("red queen", "pursuers, whole race", MORE),
    "4: evaders improve at first": ("red queen", "evaders at first", MORE),
    "4: and in the whole race": ("red queen", "evaders, whole race", MORE),
    "5: specialists forget within five generations": (
        "paper", "specialists: lag 5 minus lag 1", LESS,
    ),
    "5: generalists add to what they know": ("paper", "generalists: lag 5 minus lag 1", MORE),
    **{
        f"5: {team} still rise in {name} races": (
            "paper", f"{name}: rise of {team} in the last half", MORE,
        )
        for name, teams in {
            "specialist-specialist": ("evaders",),
            "generalist-specialist": ("pursuers", "evaders"),
            "generalist-generalist": ("pursuers", "evaders"),
        }.items()
        for team in teams
    },
    "5: fewer checkerboards with generalist pursuers": (
        "paper", "checkerboards: specialists minus mixed", MORE,
    ),
    "5: a simple rule is fooled in far more than one of twenty": (
        "noise", "false alarm, less one in ten", MORE,
    ),
    "5: and in fewer than one of two": ("noise", "four in ten, less it", MORE),
    "6: one match in a cell makes a share below one half": (
        "chance", "one half minus the share of one match", MORE,
    ),
    "6: and checkerboards": ("chance", "checkerboards of one match", MORE),
    "6: the correction raises the share": ("chance", "correction of ten matches", MORE),
    "6: specialists are the least transitive": (
        "paper", "transitive share: specialists minus mixed", LESS,
    ),
    "6b: answers to the newest hand never become safe": (
        "toy cures", "latest, less 0.2", MORE,
    ),
    "6b: answers to a hall of fame become safer": ("toy cures", "0.2 less hall", MORE),
    "6b: and those to the Nash mixture safest": ("toy cures", "hall less Nash", MORE),
    "6b: races against random earlier opponents are more transitive": (
        "cures", "transitive share of uniform", MORE,
    ),
    "6b: but the evaders of specialists escape more often": (
        "cures", "escapes of round-robin", LESS,
    ),
    "6b: pursuers with halls of fame forget less": ("halls", "pursuers forget", LESS),
    "7: hosts of greedy parasites drift": ("hosts", "60 minus the hosts of greedy ones", MORE),
    "7: hosts of restrained ones climb": ("hosts", "hosts, restrained minus greedy", MORE),
    "7: and so do the parasites": ("hosts", "parasites, restrained minus greedy", MORE),
    "7: a virulence of 0.95 is no restraint": ("hosts", "hosts, 0.85 minus 0.95", MORE),
    "7: most races with few evader epochs disengage": (
        "restraint", "few evader epochs, less one half", MORE,
    ),
    "7: and so do many with restrained pursuers": (
        "restraint", "restrained, less four in ten", MORE,
    ),
    "7: but fewer": ("restraint", "few evader epochs minus restrained", MORE),
    "8: who met hunters only escapes best from hunters": (
        "schools", "evaders, hunter: hardest only minus easy to hard", MORE,
    ),
    "8: and less often from random walkers": (
        "schools", "evaders, random: hardest only minus easy to hard", LESS,
    ),
    **{
        f"8: easy to hard against hard to easy, {script}": (
            "schools", f"evaders, {script}: easy to hard minus hard to easy", sign,
        )
        for script, sign in {"random": LESS, "clumsy-chaser": MORE, "chaser": MORE}.items()
    },
    "8: on their ladder pursuers lose what they had": (
        "schools", "pursuers, random: last stage minus first", LESS,
    ),
    **{
        f"8: {one} against {other}, {team}, {examiner}": (
            "schools", f"{team}, {examiner}: {one} minus {other}", sign,
        )
        for team, one, other, signs in (
            ("evaders", "co-evolution", "easy to hard", (LESS, LESS, MORE)),
            ("evaders", "easy to hard", "random only", (MORE, MORE)),
            ("pursuers", "co-evolution", "easy to hard", (MORE, MORE, MORE)),
            ("pursuers", "easy to hard", "random only", (LESS, LESS, LESS)),
        )
        for examiner, sign in zip(EXAMINERS, signs, strict=False)
    },
    "8: co-evolved pursuers catch more evolved strangers than those of random opponents": (
        "schools", "pursuers, evolved strangers: co-evolution minus random only", MORE,
    ),
    "9: a polite pack is faster": ("polite", "steps, polite minus greedy", LESS),
    "9: at the penalty of the paper some packs capture nothing": (
        "penalty", "captures nothing", MORE,
    ),
    "9: others capture": ("penalty", "captures", MORE),
    "9: and still collide": ("penalty", "captures and collides", MORE),
    "9: under a mask of free cells collisions are left": ("masked", "left", MORE),
    "9: fewer than without it": ("masked", "left, minus without a mask", LESS),
    "9: packs that evolve under a mask capture more than those that get it later": (
        "masks", "captures", MORE,
    ),
    "9: and faster": ("masks", "steps", LESS),
}  # fmt: skip


@cache
def sources() -> dict[str, Any]:
    make = TUTORIALS / "make"
    sys.path.append(str(make))  # scripts of one directory import each other
    return runpy.run_path(str(make / "other_seeds.py"))["SOURCES"]


def effects(name: str) -> dict[str, list[float]]:
    """Return the effects of a source for all of its seeds: kept ones, or played here."""
    source, start = sources()[name], f"{name}: "
    if source.kept:
        arrays = kept("other_seeds")
        return {k.removeprefix(start): [*arrays[k]] for k in arrays if k.startswith(start)}
    rows = [source.effects(seed) for seed in source.others]
    return {key: [row[key] for row in rows] for key in rows[0]}


# All claims on a source in one test, so that its races are played once.
@pytest.mark.nightly
@pytest.mark.parametrize("name", sorted({name for name, _, _ in CLAIMS.values()}))
def test_claims_hold_for_other_seeds(name: str) -> None:
    found, failed = effects(name), {}
    for claim, (source, effect, sign) in CLAIMS.items():
        if source == name:
            assert len(found[effect]) == len(sources()[name].others), claim
            mean = analysis.interval_over_runs(found[effect])
            # Seeds that all agree have no interval.
            low, high = (mean.value if end is None else end for end in (mean.low, mean.high))
            if (low if sign == MORE else -high) <= 0.0:
                failed[claim] = low, high
    assert not failed


def test_claims_rest_on_seeds_that_no_notebook_shows() -> None:
    claimed = {name for name, _, _ in CLAIMS.values()}
    assert claimed == set(sources())
    assert not [s for s in sources().values() if set(s.shown) & set(s.others)]
