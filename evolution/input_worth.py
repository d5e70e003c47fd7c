"""Does "What evolved" name the inputs that are worth something? Its verdicts beside the truth.

    python evolution/input_worth.py --threads 1   ten minutes of one core
    python evolution/input_worth.py --quick       two seeds of short races, some seconds

`matrixworld evolve` ends with what the best generation of each team loses without each of its
inputs, in 100 episodes against each held-out opponent, the same with the input and without. An
input is *named* if the interval of its loss lies above 0, or below ("scores better without"); the
intervals are adjusted for the number of inputs. Two seeds of three schedules in each of the
worlds with names, raced as `matrixworld evolve` does.

The *true loss* is that in 400 other episodes against each opponent. Counted are inputs named whose
true loss has the other sign, and named ones by the size of the true loss.

Inputs that do nothing: the same team plays without its input, which changes nothing but chance, in
other episodes of the same number. Nine such losses are judged as those of nine inputs are, with the
same score beside all of them. At most 5 % of such teams should have one named. What is lost without
an input of weight 0 is exactly 0, and it is never named.
"""

from __future__ import annotations

from functools import partial
from itertools import pairwise
from typing import Any

import numpy as np
from scipy import stats

from balanced_races import kinds
from common import Numbers, Runs, by_seed, experiment, kept, markdown
from matrixworld._util.teams import PLURALS
from matrixworld.analysis.intervals import level_of_each
from matrixworld.coevolution import TEAMS, SavedRun, Team
from matrixworld.coevolution.evaluation.effects import inputs_seen, terms_of, without_each
from matrixworld.coevolution.evaluation.scores import opponents_in
from matrixworld.coevolution.evaluation.trials import EPISODES, Trials, difference

SEEDS, FIRST_SEED = 2, 500
TRUTH, QUICK_EPISODES, QUICK_TRUTH = 400, 4, 8
OTHER = 10**6
"""Seed of the episodes of the truth."""
NULLS = 3
"""Sets of nine inputs that do nothing, for each team."""
SIZES = (-1.0, -0.02, -0.005, 0.005, 0.01, 0.02, 0.05, 1.0)
"""Ends of the classes of true losses."""


def of_team(run: SavedRun, team: Team, quick: bool) -> dict[str, Any]:
    """Return effects, losses and true losses of the inputs, and how many nothings are named."""
    policy = run.best(team)
    world = run.settings.game.world
    opponents, _ = opponents_in(run, team, world)
    episodes, many = (QUICK_EPISODES, QUICK_TRUTH) if quick else (EPISODES, TRUTH)
    trials = Trials(policy, team, world, opponents, episodes=episodes, threads=1)
    others = Trials(policy, team, world, opponents, OTHER, many, threads=1)
    terms = terms_of(policy, inputs_seen(trials))
    _, judged = without_each(trials, terms)
    _, true = without_each(others, terms)
    told = {term.input: term.lost for term in judged}
    truth = {term.input: term.lost for term in true}
    names = sorted(told)
    return {
        "names": names,
        "effect": [max(t.rises, t.falls) for t in sorted(terms, key=lambda t: t.input)],
        "lost": [[told[name].value, *told[name].ends] for name in names],
        "truth": [[truth[name].value, *truth[name].ends] for name in names],
        "nothings": [nothings_named(trials, len(names), number) for number in range(NULLS)],
    }


def nothings_named(trials: Trials, count: int, number: int) -> int:
    """Return how many of so many inputs that do nothing are named."""
    first = 2 + number * (count + 1)
    own, *others = (trials.scores(trials.policy, first + k)[0] for k in range(count + 1))
    level = level_of_each(count)
    return sum(difference(own, rates, level).sign != 0 for rates in others)


def numbers_of(run: SavedRun, quick: bool) -> dict[str, Any]:
    """Return the numbers of both teams of a run."""
    found = {}
    for team in TEAMS:
        file = run.path.with_suffix(f".{team}.json")
        of_one = kept(file, partial(of_team, run, team, quick))
        found |= {f"{team} {name}": np.array(values) for name, values in of_one.items()}
    return found


def measured(runs: Runs, quick: bool) -> dict[str, Any]:
    """Return the numbers of all runs; files beside them keep the numbers."""
    return by_seed(runs, partial(numbers_of, quick=quick))


def stacked(numbers: Numbers, name: str, teams: tuple[Team, ...] = TEAMS) -> np.ndarray:
    """Return a number of all runs and of some teams: (teams of runs, ...)."""
    ends = tuple(f" / {team} {name}" for team in teams)
    return np.concatenate([values for key, values in numbers.items() if key.endswith(ends)])


def signs(ends: np.ndarray) -> np.ndarray:
    """Return 1, -1 or 0 of intervals (..., 3), a value and both ends, above, below or around 0."""
    return (ends[..., 1] > 0).astype(int) - (ends[..., 2] < 0).astype(int)


def table(numbers: Numbers) -> str:
    """Return how often inputs are named, by their true loss, in Markdown."""
    return "\n\n".join([by_size(numbers), errors(numbers), by_input(numbers), by_effect(numbers)])


def by_size(numbers: Numbers) -> str:
    """Return how many inputs are named of each class of true losses."""
    truth, named = stacked(numbers, "truth")[..., 0], signs(stacked(numbers, "lost"))
    rows = []
    for low, high in pairwise(SIZES):
        inside = named[(truth >= low) & (truth < high)]
        counts = [int((inside == each).sum()) for each in (1, 0, -1)]
        rows.append([f"{low:+g} to {high:+g}", str(len(inside)), *map(str, counts)])
    heads = ["true loss", "inputs", "named: worth something", "not named"]
    return markdown([*heads, "named: better without"], rows)


def errors(numbers: Numbers) -> str:
    """Return how often inputs are named that should not be."""
    lost, truth, nothings = (stacked(numbers, name) for name in ("lost", "truth", "nothings"))
    named = signs(lost)
    wrong = (named != 0) & (named * truth[..., 0] <= 0)
    outside = (truth[..., 0] < lost[..., 1]) | (truth[..., 0] > lost[..., 2])
    inputs = lost.shape[1]
    reach = stats.t.isf((1.0 - level_of_each(inputs)) / 2, EPISODES - 1)
    expected = 2 * stats.norm.sf(reach / np.sqrt(1 + EPISODES / TRUTH)) * outside.size
    of_nothings = nothings.size * inputs
    rows = [
        ["named, and the true loss has the other sign", wrong.sum(), (named != 0).sum()],
        ["intervals without the true loss", outside.sum(), outside.size],
        ["nine inputs that do nothing, one of them named", (nothings > 0).sum(), nothings.size],
        ["inputs that do nothing, named", nothings.sum(), of_nothings],
    ]
    told = (
        f"{expected:.1f} intervals without the true loss are expected, which has an error, too. "
        f"Half of the intervals reach less than {half_width(numbers):.3f} to either side."
    )
    cells = [[name, f"{count} of {of}", f"{count / of:.1%}"] for name, count, of in rows]
    return f"{markdown(['', 'count', 'share'], cells)}\n\n{told}"


def by_input(numbers: Numbers) -> str:
    """Return how much each input is worth to each team, and in how many teams it is named."""
    rows = []
    for team in TEAMS:
        names = stacked(numbers, "names", (team,))[0]
        truth = stacked(numbers, "truth", (team,))[..., 0]
        named = signs(stacked(numbers, "lost", (team,)))
        for place in np.argsort(-truth.mean(axis=0)):
            of_one = truth[:, place]
            ends = f"{of_one.min():+.3f} to {of_one.max():+.3f}"
            counts = [str((named[:, place] == each).sum()) for each in (1, -1)]
            row = [PLURALS[team], str(names[place]), f"{of_one.mean():+.3f}", ends]
            rows.append([*row, str(len(truth)), *counts])
    heads = ["", "input", "mean true loss", "least to most", "teams", "worth something"]
    return markdown([*heads, "better without"], rows)


def half_width(numbers: Numbers) -> float:
    """Return how far half of the intervals reach to either side, at most."""
    lost = stacked(numbers, "lost")
    return float(np.median(lost[..., 2] - lost[..., 1])) / 2


def order_of_effects(numbers: Numbers) -> float:
    """Return the rank correlation of the effects of all inputs on ratings and their true losses."""
    effects, truth = stacked(numbers, "effect"), stacked(numbers, "truth")[..., 0]
    return float(stats.spearmanr(effects.ravel(), truth.ravel()).statistic)


def first_unnamed(numbers: Numbers) -> tuple[int, int]:
    """Return in how many teams the input of the largest effect is not worth something, of all."""
    named, effects = signs(stacked(numbers, "lost")), stacked(numbers, "effect")
    first = named[np.arange(len(named)), np.argmax(effects, axis=1)]
    return int((first <= 0).sum()), len(first)


def by_effect(numbers: Numbers) -> str:
    """Return what the effect of an input on ratings says of its worth."""
    count, teams = first_unnamed(numbers)
    return (
        f"Effect on ratings and true loss: rank correlation {order_of_effects(numbers):.2f} over "
        f"{stacked(numbers, 'effect').size} inputs. The input of the largest effect is not worth "
        f"something in {count} of {teams} teams."
    )


if __name__ == "__main__":
    experiment(
        __doc__,
        kinds=kinds,
        measure=measured,
        table=table,
        seeds=SEEDS,
        first_seed=dict.fromkeys(kinds(False), FIRST_SEED),
    )
