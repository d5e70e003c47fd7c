"""Comparison with other libraries of evolution, by the same co-evolution; and the forms of a game.

    python benchmarks/bench_libraries.py [--seconds 1] [--repeats 5] [--matches 100000]

Two populations play Colonel Blotto, one match at a time in plain Python, with the operators of
`blotto.py`; `blotto_races.py` has the race by each library. A match takes less than a microsecond,
so that nearly all of the time is that of the libraries and operators. Times are compared by CPU
time, which other programs change least. The second part plays matches of one game in all forms that
`Game` has for it. The process is bound to one core if the system supports it. Before the
measurement, the game and all races are checked.
"""

from __future__ import annotations

import inspect
from collections.abc import Callable, Mapping
from importlib.metadata import PackageNotFoundError, version
from typing import Any

import click
import numpy as np

import matrixworld as mw
from blotto import (
    FIELDS,
    SOLDIERS,
    Plan,
    decoded,
    initial,
    lottery,
    lottery_all,
    mate,
    mutate,
    play,
    play_all,
)
from blotto_races import LIBRARIES, Library, Work
from matrixworld.coevolution import TEAMS, uniforms
from timing import Clock, Rate, bind, print_table

PEER = "DEAP by hand"
LEAN = f"{PEER}, shallow copies"
SIZE, STAGES = 50, 20
INSTALL = {
    "deap": "pip install deap",
    "leap_ec": "pip install leap_ec",
    "evosax": "pip install evosax",
    "ribs": "pip install ribs",
    "modular-coevolution": "pip install git+https://github.com/SeanNHarris/modular-coevolution, "
    "in Python 3.12 or newer",
}


# ---- Checks before the measurement -------------------------------------------------------------


def check_game() -> None:
    """Check the game by hand and against the vectorized one, and that operators keep soldiers."""
    even = [10] * FIELDS
    assert play(even, even) == 0.5
    assert play([100, *[0] * 9], even) == 0.1
    assert play([11] * 9 + [1], even) == 0.9
    assert play([20, 10, *[0] * 6, 35, 35], even) == 0.35
    assert lottery(even, even, [0.4, 0.6] * 5) == 0.5
    assert lottery([100, *[0] * 9], even, [0.9] * FIELDS) == 0.1
    rng = np.random.default_rng(0)
    ones, others = plans_of(500, rng), plans_of(500, rng)
    draws = rng.random((500, FIELDS))
    pairs = [*zip(ones, others, strict=True)]
    assert play_all(ones, others).tolist() == [play(*pair) for pair in pairs]
    assert lottery_all(ones, others, draws).tolist() == [
        lottery(*pair, each) for pair, each in zip(pairs, draws.tolist(), strict=True)
    ]
    made = [mate(*pair, rng) for pair in pairs] + [mutate([*one], rng) for one in ones]
    for plan in (*ones, *made, *decoded(rng.standard_normal((500, FIELDS)))):
        assert_plan(plan)
    assert decoded(np.zeros((1, FIELDS))) == [even]


def assert_plan(plan: Plan) -> None:
    assert len(plan) == FIELDS
    assert sum(plan) == SOLDIERS
    assert min(plan) >= 0


def plans_of(count: int, rng: np.random.Generator) -> list[Plan]:
    return [initial(rng) for _ in range(count)]


def check_race(library: Library) -> None:
    """Check that both champions are plans, and better than untrained ones."""
    work = Work(SIZE, 5, 2, 20)
    matches, champions = library.race(work, 0)
    # Of modular-coevolution, the first population is half as large.
    assert abs(matches - work.matches) <= SIZE * work.contemporaries
    rivals = plans_of(300, np.random.default_rng(1))
    for champion in champions:
        assert_plan(champion)
        assert np.mean([play(champion, rival) for rival in rivals]) > 0.5


# ---- Libraries ---------------------------------------------------------------------------------


def is_installed(library: Library) -> bool:
    """Return whether a race runs here, after a check of it."""
    try:
        check_race(library)
    except (ImportError, SyntaxError):  # one of them has the syntax of a newer Python
        return False
    return True


def release_of(package: str) -> str:
    try:
        return version(package)
    except PackageNotFoundError:
        return mw.__version__ if package == "matrixworld" else "?"


def lines_of(written: tuple[Callable[..., Any], ...]) -> int:
    """Return the lines of functions and classes that are not blank."""
    texts = map(inspect.getsource, written)
    return sum(1 for text in texts for line in text.splitlines() if line.strip())


def print_libraries(work: Work, clock: Clock) -> None:
    here = {name: library for name, library in LIBRARIES.items() if is_installed(library)}
    rates = {name: clock.measure(runs_of(library, work)) for name, library in here.items()}
    rows = [
        (
            name,
            release_of(here[name].package),
            f"{rate.per_second:,.0f}",
            f"{1e6 * rate.cpu:.2f}",
            f"{relative(rates, name):.2f}",
            lines_of(here[name].written),
        )
        for name, rate in rates.items()
    ]
    what = f"{work.matches:,} matches, {work.contemporaries} of each individual a generation"
    print_table(
        (what, "version", "matches/s", "CPU, μs a match", f"times {PEER}", "lines of the user"),
        rows,
    )
    gets = [
        (name, each.resumes, each.judgement, each.page, each.files)
        for name, each in here.items()
        if name != LEAN
    ]
    print_table(("what one gets", "resumes bit for bit", "judgement", "page", "files"), gets)
    for name, library in LIBRARIES.items():
        if name not in here:
            print(f"{name} is left out: {INSTALL[library.package]}\n")


def runs_of(library: Library, work: Work) -> Callable[[int], float]:
    """Return a function that plays a race with a seed, and returns its matches."""
    return lambda seed: library.race(work, seed)[0]


def relative(rates: Mapping[str, Rate], name: str) -> float:
    """Return how many times the CPU time of a match by the peer one takes."""
    return rates[name].cpu / rates[PEER].cpu


# ---- Forms of a game ---------------------------------------------------------------------------


def vector(rng: np.random.Generator) -> Any:
    return np.array(initial(rng), np.float32)


def with_draws(one: Plan, other: Plan, rng: np.random.Generator) -> float:
    return lottery(one, other, rng.random(FIELDS).tolist())


def vectors_with_draws(ones: Any, others: Any, rng: np.random.Generator) -> Any:
    return lottery_all(ones, others, rng.random((len(ones), FIELDS)))


def vectors_by_seeds(ones: Any, others: Any, seeds: Any) -> Any:
    return lottery_all(ones, others, uniforms(seeds, FIELDS))


def objects_by_seeds(ones: list[Plan], others: list[Plan], seeds: Any) -> list[float]:
    draws = uniforms(seeds, FIELDS).tolist()
    return [lottery(*match) for match in zip(ones, others, draws, strict=True)]


def vectors_exactly(ones: Any, others: Any, rng: np.random.Generator) -> Any:
    return play_all(ones, others)


SIDES = ("attackers", "defenders")
OBJECTS: dict[str, Any] = {"teams": SIDES, "initial": initial, "mutate": mutate}
VECTORS: dict[str, Any] = {"teams": SIDES, "initial": vector, "genes": FIELDS}
FORMS = {
    "with chance: vectors, one match at a time": mw.Game(vectors_with_draws, **VECTORS),
    "with chance: vectors, `many`": mw.Game(vectors_by_seeds, **VECTORS, many=True),
    "with chance: objects, one match at a time": mw.Game(with_draws, **OBJECTS),
    "with chance: objects, `many`": mw.Game(objects_by_seeds, **OBJECTS, many=True),
    "exact: vectors, all at once": mw.Game(vectors_exactly, **VECTORS, deterministic=True),
    "exact: objects, one match at a time": mw.Game(play, **OBJECTS, deterministic=True),
}


def teams_of(game: mw.Game) -> tuple[Any, Any]:
    """Return populations of both teams, the same plans for every form."""
    rng = np.random.default_rng(0)
    one, other = (
        game.population(team, np.stack([game.untrained(team, rng) for _ in range(SIZE)]))
        for team in TEAMS
    )
    return one, other


def scores_of(game: mw.Game, first: Any, second: Any, matches: tuple[Any, Any, Any]) -> Any:
    """Return the scores (M,) of the first team."""
    return game.rollout(first, second, matches, episodes=1, threads=1).scores[:, 0]


def matches_of(count: int) -> tuple[Any, Any, Any]:
    """Return matches: individuals of both teams in turn, and seeds."""
    numbers = np.arange(count)
    return numbers % SIZE, numbers // SIZE % SIZE, numbers.astype(np.uint64)


def form_rate(game: mw.Game, count: int, clock: Clock) -> float:
    first, second = teams_of(game)

    def match(_: int) -> int:
        scores_of(game, first, second, matches_of(count))
        return count

    return clock.rate(match)


def loop_rate(count: int, clock: Clock, *, chance: bool) -> float:
    """Return matches per second of a plain loop over the same matches."""
    rng = np.random.default_rng(0)
    ones, others = plans_of(SIZE, rng), plans_of(SIZE, rng)
    a, b, _ = matches_of(count)
    pairs = [(ones[i], others[j]) for i, j in zip(a.tolist(), b.tolist(), strict=True)]

    def match(_: int) -> int:
        if chance:
            scores = [with_draws(one, other, rng) for one, other in pairs]
        else:
            scores = [play(one, other) for one, other in pairs]
        return len(scores)

    return clock.rate(match)


def check_forms() -> None:
    """Check that exact forms have the scores of a loop, and those with chance its mean."""
    count = 2500
    a, b, _ = matches_of(count)
    rng = np.random.default_rng(0)
    ones, others = plans_of(SIZE, rng), plans_of(SIZE, rng)
    pairs = [(ones[i], others[j]) for i, j in zip(a.tolist(), b.tolist(), strict=True)]
    chances = [
        (mine + 1) / (mine + theirs + 2)
        for one, other in pairs
        for mine, theirs in zip(one, other, strict=True)
    ]
    expected = {"exact": [play(*pair) for pair in pairs], "with chance": chances}
    for name, game in FORMS.items():
        kind = name.partition(":")[0]
        scores = scores_of(game, *teams_of(game), matches_of(count))
        assert abs(scores.mean() - np.mean(expected[kind])) < 0.02
        if kind == "exact":
            np.testing.assert_allclose(scores, expected[kind], rtol=1e-6)


def print_forms(count: int, clock: Clock) -> None:
    loops = {
        "with chance": loop_rate(count, clock, chance=True),
        "exact": loop_rate(count, clock, chance=False),
    }
    rows = [(f"{kind}: a plain loop", f"{rate:,.0f}", "1.00") for kind, rate in loops.items()]
    for name, game in FORMS.items():
        rate = form_rate(game, count, clock)
        rows.append((name, f"{rate:,.0f}", f"{loops[name.partition(':')[0]] / rate:.2f}"))
    rows.sort(key=lambda row: row[0].partition(":")[0], reverse=True)
    print_table((f"{count:,} matches", "matches/s", "times the plain loop"), rows)


@click.command()
@click.option("--seconds", default=1.0, show_default=True, help="time of one repeat")
@click.option("--repeats", default=5, show_default=True, help="repeats of which the median counts")
@click.option("--matches", default=100_000, show_default=True, help="matches of a race, about")
@click.option("--contemporaries", default=5, show_default=True, help="opponents in a generation")
@click.option("--calls", default=20_000, show_default=True, help="matches of a call, by form")
def main(seconds: float, repeats: int, matches: int, contemporaries: int, calls: int) -> None:
    """Print three tables in Markdown: speed of libraries, what one gets, and forms of a game."""
    clock = Clock(seconds, repeats)
    bind(1)  # before the libraries start threads
    check_game()
    check_forms()
    epochs = max(1, round(matches / (SIZE * contemporaries * STAGES)))
    print_libraries(Work(SIZE, contemporaries, STAGES, epochs), clock)
    print_forms(calls, clock)


if __name__ == "__main__":
    main()
