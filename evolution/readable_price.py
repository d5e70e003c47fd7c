"""What does a policy that one can read cost? Shares of perfect play against what one must read.

    python evolution/readable_price.py             about ten minutes of one core
    python evolution/readable_price.py --quick     two worlds and small budgets, some seconds

Pursuers in the 25 solved worlds of `mw.SUITE`. What a team guarantees is exact, and a *share* is
that of perfect play. For each representation the best policy of each world is searched

- *directly* on the guarantee, without opponents: what is missing to 1 then is the price of the
  representation, up to what the search misses;
- by *races*, halls of fame as in ``policies.py``: what they have less is the price of learning.

Representations, and what one must read of them:

- *weights*, 1 to 12: the inputs of today (seven, see `direct_search.TODAY`), and these with what
  ``look_for_inputs.py`` found. All weights are searched, then the one that costs least is left out
  and the others are searched again, and so on: k numbers, and which inputs they belong to;
- *8 hidden* units over today's inputs: 72 numbers;
- *decision lists* of k lines: ``if adversary <= 2: -adversary``, ..., ``else: room``. A condition
  is of an input where the agent stands, a move is rated by one input: 3 k - 2 words;
- *programs* of at most k symbols over today's inputs, by genetic programming on the guarantee;
- *tables*: for each view a move, improved one row after the other: as many rows as views.

At once the bound of whatever does not draw its moves is what pursuers guarantee who plan together
and tell their joint action before the evaders choose theirs.

Stated before the runs: in turns seven weights cost .10 or less, twelve half of it, lists of four
lines as much as three weights, programs of ten symbols as much as seven weights; a table costs
least. Races cost .02 to .05 more. At once the found inputs do not help, the bound is the larger
part of the price, and races cost more than in turns. A difference counts if its 95 % interval over
worlds excludes 0.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import partial
from pathlib import Path
from typing import Any

import matplotlib.pyplot as plt
import numpy as np

import matrixworld as mw
from common import kept, markdown, mean, script_parser, write_json
from direct_search import TIE, TODAY, Floats, Place, scaled, search
from look_for_inputs import Input, columns_of
from matrixworld._util.files import read_json
from matrixworld.analysis import interval_over_runs
from matrixworld.coevolution import RaceSettings, Training, train
from matrixworld.plots import save_figure
from matrixworld.solver import States, best_response
from matrixworld.solver.suite import SuiteWorld
from policies import KINDS, RACE

FOUND = Path(__file__).parent / "results" / "look_for_inputs" / "numbers.json"
BUDGET, AGAIN, LISTS, PROGRAMS, ROWS = 1200, 100, 600, 720, 500
"""Evaluations: of a first search, of one after a weight is left out, of a list, a program, rows."""
LINES, SYMBOLS = (1, 2, 4, 8), (5, 10, 20, 40)
HIDDEN = 8
RACED = {"rating": "7 weights", "rating, 8 hidden": "8 hidden", "program": "40 symbols"}
"""Kinds of ``policies.py`` that race, and what their direct search is called."""
SEEDS = 2


def found_inputs() -> list[Input]:
    """Return the inputs that were found."""
    return [Input(*words) for words in read_json(FOUND)["selected"]["inputs"]]


# ---- Direct search -------------------------------------------------------------------------------


def weights(place: Place, columns: list[Floats], budget: int, again: int) -> dict[str, Any]:
    """Return shares of k weights, k from all to 1, and which of the inputs these are."""
    inputs = scaled(columns)
    rng = np.random.default_rng(0)
    left = [*range(len(columns))]
    share, best = search(lambda w: place.guarantee(inputs @ w), len(left), budget, rng)
    found = {len(left): {"share": share, "inputs": [*left], "weights": best.tolist()}}
    first = best
    while len(left) > 1:
        without = [
            place.guarantee(inputs[:, :, [i for i in left if i != gone]] @ np.delete(best, at))
            for at, gone in enumerate(left)
        ]
        at = int(np.argmax(without))
        best = np.delete(best, at)
        del left[at]
        value = partial(_guarantee, place, inputs[:, :, left])
        share, best = search(value, len(left), again, rng, start=best, sigma=0.3)
        found[len(left)] = {"share": share, "inputs": [*left], "weights": best.tolist()}
    found = {str(k): one for k, one in sorted(found.items())}
    # Fewer weights are more weights, some of which are 0.
    for few, more in zip([*found], [*found][1:], strict=False):
        found[more]["share"] = max(found[more]["share"], found[few]["share"])
    return {"by number": found, "play": place.play(inputs @ first).tolist()}


def _guarantee(place: Place, inputs: Floats, weights: Floats) -> float:
    return place.guarantee(inputs @ weights)


def hidden(place: Place, columns: list[Floats], budget: int) -> float:
    """Return the share of networks with a hidden layer that rate moves."""
    inputs = scaled(columns)
    n = len(columns)

    def value(genes: Floats) -> float:
        first, bias, last = np.split(genes, [n * HIDDEN, (n + 1) * HIDDEN])
        units = np.maximum(inputs @ first.reshape(n, HIDDEN) + bias, 0.0)
        return place.guarantee(units @ last)

    return search(value, (n + 2) * HIDDEN, budget, np.random.default_rng(0))[0]


def decision_list(place: Place, columns: list[Floats], lines: int, budget: int) -> dict[str, Any]:
    """Return the best list of so many lines that mutations find, in one climb after another."""
    inputs = np.stack(columns, axis=2)
    here = inputs[:, 0]
    rng = np.random.default_rng(lines)

    def line() -> list[Any]:
        about = int(rng.integers(len(columns)))
        limits = np.unique(np.round(here[:, about], 6))
        return [about, float(rng.choice(limits)), int(rng.integers(len(columns))),
                int(rng.choice([-1, 1]))]  # fmt: skip

    def value(rules: Sequence[list[Any]]) -> float:
        _, _, rated, sign = rules[-1]
        ratings = sign * inputs[:, :, rated]
        for about, limit, rated, sign in reversed(rules[:-1]):
            holds = here[:, about] <= limit + 1e-9
            ratings = np.where(holds[:, None], sign * inputs[:, :, rated], ratings)
        return place.guarantee(ratings)

    best, found = -1.0, []
    left = budget
    while left > 0 and best < 1 - TIE:
        rules = [line() for _ in range(lines)]
        share, stalled = value(rules), 0
        left -= 1
        while stalled < 60 * lines and left > 0 and share < 1 - TIE:
            other = [[*each] for each in rules]
            at, part, new = int(rng.integers(lines)), int(rng.integers(5)), line()
            if part == 4:
                other[at] = new
            elif part == 0:
                other[at][:2] = new[:2]
            else:
                other[at][part] = new[part] if part != 1 else _limit(here[:, other[at][0]], rng)
            tried = value(other)
            left -= 1
            stalled = 0 if tried > share else stalled + 1
            if tried >= share:
                rules, share = other, tried
        if share > best:
            best, found = share, rules
    return {"share": best, "lines": found}


def _limit(values: Floats, rng: np.random.Generator) -> float:
    """Return one of the values that an input takes."""
    return float(rng.choice(np.unique(np.round(values, 6))))


def program(world: SuiteWorld, symbols: int, budget: int) -> dict[str, Any]:
    """Return the best program of at most so many symbols that genetic programming finds."""
    settings = RaceSettings.of(
        {
            "schedule": "against", "learner": "gp", "learner.measure": "guarantee",
            "policy": "program", "policy.length": symbols, "world": world.config,
            "schedule.epochs": max(1, budget // 24), "schedule.archive_every": max(1, budget // 24),
        }
    )  # fmt: skip
    training = train(Training(settings, threads=1, rivals=lambda team: "best-response"))
    return share_of_last(training, world)


def share_of_last(training: Training, world: SuiteWorld) -> dict[str, Any]:
    """Return the share that the last pursuers of a training guarantee, and how long they are."""
    genome = training.archive["pursuer"][-1]
    policy = training.settings.evaluation_game.policies["pursuer"]
    pursuers = mw.Population(genome[None], policy)
    share = best_response(States(world.config, threads=1), pursuers, "pursuer").value / world.value
    words = policy.expression(genome) if policy.kind == "program" else ""
    return {"share": share, "words": words}


def rows(place: Place, plays: Sequence[Floats], budget: int) -> dict[str, Any]:
    """Return the share of a table of moves for views, improved row by row, and its rows."""
    perfect, states = place.perfect, place.states
    moves = place.after.shape[1]
    # What moves are worth to perfect play, with all rounds left and with fewer.
    worth = np.zeros(place.after.shape)
    for turn, of_turn in enumerate(place.places):
        for column in range(of_turn.shape[1]):
            views = of_turn[:, column]
            for left in range(1, perfect.steps + 1):
                after = perfect.after(left, turn)[states.successors(turn)].min(axis=2)
                shaped = after.reshape(len(after), moves**column, moves, -1)
                np.add.at(worth, views[views >= 0], shaped.max(axis=(1, 3))[views >= 0])
    plays = [*plays, place.play(worth)]
    shares = [table_share(place, play) for play in plays]
    play, share = plays[int(np.argmax(shares))].copy(), max(shares)
    left, rng = budget, np.random.default_rng(0)
    while left > 0 and share < 1 - TIE:
        risen = False
        for view in rng.permutation(len(play)):
            for move in np.flatnonzero(place.allowed[view]):
                if left <= 0 or play[view, move] == 1.0:
                    continue
                other = play.copy()
                other[view] = np.eye(moves)[move]
                left -= 1
                if (tried := table_share(place, other)) > share + 1e-12:
                    play, share, risen = other, tried, True
        if not risen:
            break
    return {"share": share, "rows": len(play)}


def table_share(place: Place, play: Floats) -> float:
    """Return the share of perfect play that moves with probabilities (n, moves) guarantee."""
    return best_response(place.states, place.table(play), "pursuer").value / place.world.value


def told_first(world: SuiteWorld) -> float:
    """Return the share of pursuers who tell their joint action before the evaders choose theirs."""
    states = States(world.config, threads=1)
    values = states.captured().mean(axis=1)
    for _ in range(world.config.max_steps):
        for turn in reversed(range(states.n_turns)):
            values = values[states.successors(turn)].min(axis=2).max(axis=1)
    return float(values[states.starts].mean()) / world.value


def direct(world: SuiteWorld, quick: bool) -> dict[str, Any]:
    """Return what direct search finds in a world, of each representation."""
    share = 0.02 if quick else 1.0
    budget, again, of_list, of_program, of_rows = (
        max(12, int(share * each)) for each in (BUDGET, AGAIN, LISTS, PROGRAMS, ROWS)
    )
    place = Place(world)
    today = [place.today[name] for name in TODAY]
    every = columns_of(place, found_inputs())
    by_today, by_every = (weights(place, each, budget, again) for each in (today, every))
    plays = [np.array(each.pop("play")) for each in (by_today, by_every)]
    return {
        "today": by_today["by number"],
        "with found": by_every["by number"],
        "8 hidden": hidden(place, today, budget),
        "lists": {str(k): decision_list(place, every, k, of_list) for k in LINES},
        "programs": {str(k): program(world, k, of_program) for k in SYMBOLS},
        "table": rows(place, plays, of_rows),
        "told first": told_first(world),
    }


# ---- Races ---------------------------------------------------------------------------------------


def race(world: SuiteWorld, kind: str, seed: int, quick: bool) -> dict[str, Any]:
    """Return the share that the last pursuers of a race guarantee."""
    small = {"schedule.generations": 2, "schedule.joint_epochs": 2} if quick else {}
    settings = RaceSettings.of(
        RACE | KINDS[kind] | small,
        {
            "world": world.config, "train_steps": world.config.max_steps, "match_episodes": 32,
            "policy.inputs": TODAY, "seed": seed,
        },
    )  # fmt: skip
    training = train(Training(settings, threads=1))
    return {**share_of_last(training, world), "matches": training.counts["matches"]}


# ---- Table and figure ----------------------------------------------------------------------------


def curves(found: Sequence[Mapping[str, Any]]) -> dict[str, dict[float, list[float]]]:
    """Return the shares of worlds by representation and what one must read of it."""
    of: dict[str, dict[float, list[float]]] = {}
    for kind, of_kind in (
        ("weights of today's inputs", "today"),
        ("... with found ones", "with found"),
    ):
        numbers = found[0]["direct"][of_kind]
        of[kind] = {int(k): [w["direct"][of_kind][k]["share"] for w in found] for k in numbers}
    of["8 hidden"] = {(len(TODAY) + 2) * HIDDEN: [w["direct"]["8 hidden"] for w in found]}
    of["decision lists"] = {
        3 * k - 2: [w["direct"]["lists"][str(k)]["share"] for w in found] for k in LINES
    }
    of["programs"] = {k: [w["direct"]["programs"][str(k)]["share"] for w in found] for k in SYMBOLS}
    size = float(np.exp(np.mean([np.log(w["direct"]["table"]["rows"]) for w in found])))
    of["table"] = {size: [w["direct"]["table"]["share"] for w in found]}
    return of


def direct_of(world: Mapping[str, Any], kind: str) -> float:
    """Return the share of the direct search of what races as a kind."""
    of = world["direct"]
    shares = {
        "rating": of["today"][str(len(TODAY))]["share"],
        "rating, 8 hidden": of["8 hidden"],
        "program": of["programs"][str(SYMBOLS[-1])]["share"],
    }
    return float(shares[kind])


def raced(world: Mapping[str, Any], kind: str) -> float:
    """Return the mean share of the races of a kind."""
    return float(np.mean([each["share"] for each in world["races"][kind]]))


def halves(found: Sequence[Mapping[str, Any]]) -> dict[str, list[Mapping[str, Any]]]:
    """Return the worlds in turns and at once."""
    split = {
        "in turns": [w for w in found if w["in turns"]],
        "at once": [w for w in found if not w["in turns"]],
    }
    return {name: worlds for name, worlds in split.items() if worlds}


def shares_of(world: Mapping[str, Any]) -> dict[str, float]:
    """Return the shares of a world that are compared, by name."""
    of = world["direct"]
    today, with_found = of["today"], of["with found"]
    return {
        "3 weights": today["3"]["share"],
        "7 weights": today[str(len(TODAY))]["share"],
        "3 weights with found inputs": with_found["3"]["share"],
        "all weights with found inputs": with_found[str(len(with_found))]["share"],
        "8 hidden": of["8 hidden"],
        "a list of 4 lines": of["lists"]["4"]["share"],
        "a program of 10 symbols": of["programs"]["10"]["share"],
        "a table": of["table"]["share"],
        "the bound": of["told first"],
        "perfect play": 1.0,
    }


COMPARED = (
    ("all weights with found inputs", "7 weights"),
    ("3 weights with found inputs", "7 weights"),
    ("8 hidden", "7 weights"),
    ("a list of 4 lines", "3 weights with found inputs"),
    ("a program of 10 symbols", "7 weights"),
    ("a table", "all weights with found inputs"),
    ("the bound", "a table"),
    ("the bound", "7 weights"),
    ("perfect play", "the bound"),
)
"""Pairs whose difference is told."""


def table(found: Sequence[Mapping[str, Any]]) -> str:
    """Return shares by representation, and what representation and learning cost, in Markdown."""
    apart = halves(found)
    heads = ["representation", "to read", *(f"{name} ({len(w)})" for name, w in apart.items())]
    of = {name: curves(worlds) for name, worlds in apart.items()}
    rows = []
    for kind, by_size in next(iter(of.values())).items():
        for place in range(len(by_size)):
            sizes = [[*each[kind]][place] for each in of.values()]
            shares = [[*each[kind].values()][place] for each in of.values()]
            told = " and ".join(dict.fromkeys(f"{n:.0f}" for n in sizes))
            rows.append([kind, told, *(mean(each, bounds=(0, 1)) for each in shares)])
    if "at once" in apart:
        bound = [world["direct"]["told first"] for world in apart["at once"]]
        blank = [""] * (len(apart) - 1)
        rows.append(["bound without draws", "", *blank, mean(bound, bounds=(0, 1))])
    lines = ["Mean share of perfect play, by direct search [95 % over worlds].", ""]
    lines += [markdown(heads, rows), ""]
    rows = []
    for one, other in COMPARED:
        gains = [
            [shares_of(world)[one] - shares_of(world)[other] for world in worlds]
            for worlds in apart.values()
        ]
        rows.append([f"{one} minus {other}", *(mean(each, sign="+") for each in gains)])
    lines += [markdown(["differences, paired by world", *apart], rows), ""]
    rows = []
    for kind, words in RACED.items():
        for name, worlds in apart.items():
            best = np.array([direct_of(world, kind) for world in worlds])
            learned = np.array([raced(world, kind) for world in worlds])
            rows.append(
                [words, name, mean(1 - best), mean(best - learned), mean(learned, bounds=(0, 1))]
            )
    heads = ["", "worlds", "price of the representation", "price of learning", "share of races"]
    matches = {kind: found[0]["races"][kind][0]["matches"] for kind in RACED}
    told = ", ".join(f"{matches[kind]:,} of {words}" for kind, words in RACED.items())
    seeds = len(found[0]["races"]["rating"])
    lines += [markdown(heads, rows), "", f"{seeds} races a kind and world; matches: {told}.", ""]
    if "at once" in apart:
        second = [world["second"] / world["value"] for world in apart["at once"]]
        lines.append(
            "At once it is worth to the pursuers, in shares of perfect play, to move second: "
            f"{mean(second)}."
        )
    return "\n".join(lines)


STYLES = (
    ("tab:blue", "o-"), ("tab:orange", "s-"), ("black", "^"), ("tab:gray", "v--"),
    ("tab:purple", "P:"), ("black", "D"),
)  # fmt: skip
"""Colors and lines of the representations, which differ without colors, too."""


def figure(found: Sequence[Mapping[str, Any]]) -> Any:
    """Return the curves of shares against what one must read."""
    apart = halves(found)
    drawn, axes = plt.subplots(1, len(apart), figsize=(9, 3.8), sharey=True, squeeze=False)
    for axis, (name, worlds) in zip(axes[0], apart.items(), strict=True):
        for (kind, by_size), (color, style) in zip(curves(worlds).items(), STYLES, strict=True):
            means = [np.mean(each) for each in by_size.values()]
            found_ends = [interval_over_runs(each, bounds=(0, 1)) for each in by_size.values()]
            ends = [[m if end is None else end for end in (e.low, e.high)]
                    for m, e in zip(means, found_ends, strict=True)]  # fmt: skip
            bars = np.abs(np.array(ends).T - means)
            look = {"color": color, "fmt": style, "ms": 4, "lw": 1, "capsize": 2}
            axis.errorbar([*by_size], means, bars, label=kind, **look)
        sizes = {"rating": len(TODAY), "rating, 8 hidden": 72, "program": SYMBOLS[-1]}
        shares = [np.mean([raced(world, kind) for world in worlds]) for kind in RACED]
        axis.plot([sizes[kind] for kind in RACED], shares, "kx", label="races: 7 weights, 72, 40")
        if name == "at once":
            bound = np.mean([world["direct"]["told first"] for world in worlds])
            axis.axhline(bound, color="gray", ls="--", lw=1, label="bound without draws")
        axis.set(xscale="log", xlabel="numbers, words or rows to read", title=name, ylim=(0, 1.02))
    axes[0][0].set_ylabel("share of perfect play")
    axes[0][-1].legend(fontsize=7)
    drawn.tight_layout()
    return drawn


def main() -> None:
    """Search and race in all worlds, and write what a readable policy costs."""
    args = script_parser(__doc__, quick="two worlds and small budgets", runs=True).parse_args()
    numbers = (2, 13) if args.quick else range(1, len(mw.SUITE.worlds) + 1)
    found = []
    for number in numbers:
        world = mw.SUITE.worlds[number - 1]
        place = args.runs / str(number)
        of_races = {
            kind: [
                kept(place / f"{kind} {seed}.json", partial(race, world, kind, seed, args.quick))
                for seed in range(SEEDS)
            ]
            for kind in RACED
        }
        found.append(
            {
                "name": world.name,
                "in turns": world.in_turns,
                "value": world.value,
                "second": world.second,
                "direct": kept(place / "direct.json", partial(direct, world, args.quick)),
                "races": of_races,
            }
        )
    write_json(args.results, found, table(found))
    save_figure(figure(found), args.results / "figure.png")


if __name__ == "__main__":
    main()
