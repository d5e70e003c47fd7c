"""Headline claims of the notebooks hold for seeds that no notebook shows."""

import runpy
import sys
from functools import cache
from typing import Any

import pytest

from course import kept
from matrixworld import analysis
from notebooks import TUTORIALS

TABLE = """
3  | chosen | lost in new matches, less what is left | +
3  | race by hand | captured by first pursuers, last evaders minus first | -
4  | numbers games | scalar minus intransitive | +
4  | nim | in the race minus outside | +
4  | tournament | ones of the picked generation | +
4  | red queen | diagonal at first | -
4  | red queen | diagonal later | +
4  | red queen | pursuers at first | -
4  | red queen | pursuers later | +
4  | red queen | pursuers, whole race | +
4  | red queen | evaders at first | +
4  | red queen | evaders, whole race | +
5  | paper | specialists: lag 5 minus lag 1 | -
5  | paper | generalists: lag 5 minus lag 1 | +
5  | paper | specialist-specialist: rise of evaders in the last half | +
5  | paper | generalist-specialist: rise of pursuers in the last half | +
5  | paper | generalist-specialist: rise of evaders in the last half | +
5  | paper | generalist-generalist: rise of pursuers in the last half | +
5  | paper | generalist-generalist: rise of evaders in the last half | +
5  | paper | checkerboards: specialists minus mixed | +
5  | noise | false alarm, less one in ten | +
5  | noise | four in ten, less it | +
6  | paper | transitive share: specialists minus mixed | -
6  | cures | transitive share of uniform | +
6  | cures | escapes of round-robin | -
6  | halls | pursuers forget | -
7  | restraint | few evader epochs, less one half | +
7  | restraint | restrained, less four in ten | +
7  | restraint | few evader epochs minus restrained | +
9  | penalty | captures nothing | +
9  | penalty | captures | +
9  | penalty | captures and collides | +
9  | masks | captures | +
9  | masks | steps | -
"""
"""Notebook, source in ``tutorials/make/other_seeds.py``, effect, and the sign that is claimed."""
CLAIMS = [tuple(map(str.strip, line.split(" | "))) for line in TABLE.strip().splitlines()]
NAMES = sorted({source for _, source, _, _ in CLAIMS})


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
@pytest.mark.parametrize("name", NAMES)
def test_claims_hold_for_other_seeds(name: str) -> None:
    found, failed = effects(name), {}
    for _, source, effect, sign in CLAIMS:
        if source == name:
            assert len(found[effect]) == len(sources()[name].others), effect
            mean = analysis.interval_over_runs(found[effect])
            # Seeds that all agree have no interval.
            low, high = (mean.value if end is None else end for end in (mean.low, mean.high))
            if (low if sign == "+" else -high) <= 0.0:
                failed[effect] = low, high
    assert not failed
