"""Synthetic races: capture rates without noise, by formula, so that the truth about them is known.

A kind of race is a function of the number of generations, an effect size and nuisance parameters
(levels, slopes, phases, differences between the teams), which are drawn from a seed. It returns the
true capture rates ``M[g, h]`` and the strength that each team has *by design*, which leaves out
what chance adds. `matrixworld.toys.race_truths` says what is true of a race, and plays it.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import partial
from typing import NamedTuple

from matrixworld.toys import race_formulas as formulas
from matrixworld.toys.race_formulas import Draws, SyntheticRace

Make = Callable[[int, float, Draws], SyntheticRace]


class Kind(NamedTuple):
    """A kind of race.

    Parameters
    ----------
    make : callable
        (Generations, effect size, `Draws`) -> `SyntheticRace`.
    development : bool
        Whether constants of a judgement may be set on it. Kinds that are held back are for
        measuring only.
    """

    make: Make
    development: bool = False


KINDS: Mapping[str, Kind] = {
    "pure race": Kind(partial(formulas.race, total=4.0), development=True),
    "slow race": Kind(formulas.slow_race),
    "steep race": Kind(partial(formulas.race, total=15.0)),
    "uneven pace": Kind(formulas.uneven_pace),
    "saturating race": Kind(formulas.saturating),
    "two skills": Kind(formulas.two_skills),
    "only pursuers rise": Kind(partial(formulas.one_sided, pursuers=True), development=True),
    "only evaders rise": Kind(partial(formulas.one_sided, pursuers=False), development=True),
    "cycle": Kind(partial(formulas.cycle, periods=(2.0, 4.0)), development=True),
    "cycle, uneven periods": Kind(partial(formulas.cycle, periods=(1.3, 2.7, 3.4))),
    "rock-paper-scissors": Kind(formulas.hands),
    "cycle on a climb": Kind(partial(formulas.cycle, periods=(2.0, 3.0, 4.0), climb=2.0)),
    "wave, then race": Kind(partial(formulas.wave_then, late=False)),
    "race, then wave": Kind(partial(formulas.wave_then, late=True)),
    "noise only, .1": Kind(partial(formulas.constant, rate=0.1), development=True),
    "noise only, .5": Kind(partial(formulas.constant, rate=0.5), development=True),
    "noise only, .8": Kind(partial(formulas.constant, rate=0.8), development=True),
    "drift": Kind(formulas.drift, development=True),
    "fluctuation": Kind(formulas.fluctuation),
    "early stagnation": Kind(partial(formulas.stagnation, until=1 / 3), development=True),
    "late stagnation": Kind(partial(formulas.stagnation, until=3 / 4)),
    "single jump": Kind(formulas.jump),
    "forgetting": Kind(formulas.forgetting, development=True),
    "decline": Kind(formulas.decline),
    "collapse": Kind(formulas.collapse),
    "disengagement, .95": Kind(partial(formulas.disengagement, rate=0.95)),
    "disengagement, .985": Kind(partial(formulas.disengagement, rate=0.985)),
    "disengagement, .995": Kind(partial(formulas.disengagement, rate=0.995)),
}
"""Kinds of races by name."""


def synthetic_races(
    kind: str, n: int, seed: int, *, effect: float = 1.0, runs: int = 1
) -> list[SyntheticRace]:
    """Return the runs of a group: races of one kind, with parameters that vary between runs.

    Parameters
    ----------
    kind : str
        Name in `KINDS`.
    n : int
        Generations of each team.
    seed : int
        Seed of the nuisance parameters.
    effect : float, optional
        Size of what the kind is about (a rise, an amplitude, a loss); 1 is plain to see.
    runs : int, optional
        Number of runs. The default is 1.

    Returns
    -------
    list of SyntheticRace
        The runs.

    Raises
    ------
    ValueError
        If there is no such kind, or n is below 4.
    """
    if kind not in KINDS:
        raise ValueError(f"kind: expected one of {'; '.join(KINDS)}, got {kind!r}")
    if n < 4:
        raise ValueError(f"n: expected at least 4 generations, got {n}")
    return [KINDS[kind].make(n, effect, Draws(seed, run)) for run in range(runs)]
