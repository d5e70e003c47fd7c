"""What should a team look at? The solver finds it: inputs for pursuers in worlds with turns.

    python evolution/look_for_inputs.py             about ten minutes of one core
    python evolution/look_for_inputs.py --quick     two worlds and a small grammar, some seconds

Pursuers rate each move by a weighted sum of inputs. Today they have nine, of which seven can be
searched exactly (`direct_search.TODAY`). The worlds are those of `mw.SUITE` in turns, 1 to 12. A
share is what weights guarantee, divided by what perfect play does; the weights are searched on it
directly, without opponents. Inputs are found so:

1. *Positions*: where the best policy found so far gets against the best response to it, and takes a
   move that the solver values less than the best one. A position weighs how often it comes about,
   times what the move loses.
2. *A grammar* of some hundred inputs: distances of pursuers from the cells on which evaders stand,
   may stand after a move or two, or flee to; as they are, thresholds, odd or even; means, least and
   largest ones over cells, sums and least ones over evaders. All hold after the pursuer's own move.
3. An input *separates* in as far as it is larger for the best moves than for the moves taken in
   their place, or always smaller: 1 if always, 0 if as often as not.
4. *Forward selection*: each of the ten that separate best joins the inputs, the weights are
   searched again, and the one with the highest mean share stays, if this rises by `LEAST`. Five
   rounds, so that there are at most twelve weights.

Stated before the runs:

- Worlds with odd numbers choose the inputs, those with even ones are held out. Further worlds are
  those in turns of ``league_worlds.py``, which chose nothing either.
- The goal: on held-out worlds the mean share of at most twelve weights gets from that of today's
  seven halfway to 1, once with weights of each world's own, and once with one set of weights for
  all worlds, learned in those that choose.
- Expected: of the inputs `escapes`, `opposite` and `parity`, which trials had found by hand, the
  first two or their like are among the ten of the first round; the goal is met with weights of each
  world's own, and missed with one set of weights.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import cache, partial
from itertools import product
from typing import Any, NamedTuple

import numpy as np
from tqdm import tqdm

import league_worlds
import matrixworld as mw
from common import kept, markdown, mean, script_parser, write_json
from direct_search import FAR, TODAY, Floats, Place, by_weights, scaled, search
from matrixworld.solver import best_response
from matrixworld.solver.suite import SuiteWorld
from matrixworld.solver.visits import visits

IN_TURNS = range(1, 13)
CANDIDATES, ROUNDS, LEAST = 10, 5, 0.002
"""Inputs of a round that are tried, rounds, and the least rise of the mean share."""
TRIED, MEASURED, TOGETHER = 600, 3000, 2000
"""Evaluations of a search: of a candidate, of a result, and of one set of weights for all."""


# ---- The grammar ---------------------------------------------------------------------------------


class Input(NamedTuple):
    """An input of a move: what holds after it, as words of the grammar."""

    what: str  # of the distance of a pursuer from a cell
    who: str  # which pursuer
    path: str  # whether distances go around obstacles
    cells: str  # which cells of an evader
    over_cells: str
    over_evaders: str

    @property
    def name(self) -> str:
        """A short name."""
        return " ".join(part for part in self if part)

    @property
    def sentence(self) -> str:
        """What it is, in plain English."""
        what = WHAT[self.what].format(who=WHO[self.who], path=PATH[self.path])
        over = f"{OVER_CELLS[self.over_cells]} the cells {CELLS[self.cells]}, of"
        where = "from the evader" if self.cells == "now" else f"{over}"
        begin = f"{OVER_EVADERS[self.over_evaders]}: "
        if self.cells == "now":
            return f"{begin}{what} {where}."
        return f"{begin}{where} {what} from the cell."


WHO = {
    "me": "this pursuer", "mate": "its nearest teammate", "nearest": "the nearest of all pursuers",
    "second": "the second nearest pursuer", "sum": "all pursuers, summed,",
}  # fmt: skip
PATH = {"free": "", "path": " around obstacles"}
WHAT = {
    "distance": "the distance{path} of {who}",
    "out": "whether more than one move{path} separates {who}",
    "out2": "whether more than two moves{path} separate {who}",
    "near": "1 / (1 + distance)^2{path} of {who}",
    "odd": "whether the distance{path} is odd of {who}",
    "there": "whether no distance separates {who}",
}
CELLS = {
    "now": "", "next": "where the evader may be after its next move",
    "two": "where the evader may be after two moves",
    "flight": "to which it flees: of those after its next move the farthest from all pursuers",
}  # fmt: skip
OVER_CELLS = {
    "mean": "the mean, over",
    "most": "the largest, over",
    "least": "the least, over",
    "": "",
}
OVER_EVADERS = {"sum": "Summed over evaders", "least": "Of the evader for which it is least"}

Values = Callable[[Place], Floats]


def grammar(quick: bool) -> list[Input]:
    """Return all inputs of the grammar."""
    places = [("now", ""), *product(("next", "two"), ("mean", "most", "least")), ("flight", "mean")]
    whats = ("out", "odd") if quick else tuple(WHAT)
    paths = ("path",) if quick else tuple(PATH)
    return [
        Input(what, who, path, cells, over, evaders)
        for what, who, path, (cells, over), evaders in product(
            whats, WHO, paths, places, OVER_EVADERS
        )
        if what != "there" or path == paths[0]  # with obstacles or without, nobody is elsewhere
    ]


class Looks:
    """What inputs of the grammar are made of, in a place."""

    def __init__(self, place: Place) -> None:
        self.place = place
        n = len(place.own)
        pursuers = place.cells[:, : place.n_pursuers]
        self.evaders = place.cells[:, place.n_pursuers :]
        self.gone = self.evaders < 0
        own = np.arange(place.n_pursuers) == place.own[:, None]
        self.mates = np.where(own | (pursuers < 0), -1, pursuers)
        count = len(place.neighbours)
        near = np.eye(count, dtype=bool)
        near[np.arange(count)[:, None], place.neighbours] = True
        two = (near.astype(int) @ near) > 0
        here = np.maximum(self.evaders, 0)
        self.sets = {"now": np.eye(count, dtype=bool)[here], "next": near[here], "two": two[here]}
        # Farthest of the next cells from all pursuers: (n, moves, evaders, cells).
        apart = self.apart("nearest", "path")[:, :, None]
        reached = np.where(self.sets["next"][:, None], apart, -1)
        flight = reached == reached.max(axis=3, keepdims=True)
        self.sets = {name: each[:, None] for name, each in self.sets.items()} | {"flight": flight}
        assert flight.shape[:2] == (n, place.after.shape[1])

    @cache  # noqa: B019, as long-lived as the place
    def apart(self, who: str, path: str) -> Floats:
        """Return the distance of pursuers from each cell after each move, (n, moves, cells)."""
        distances = self.place.distances[path].astype(float)
        mine = distances[self.place.after]
        others = np.where((self.mates >= 0)[..., None], distances[self.mates], FAR)[:, None]
        every = np.concatenate(
            [mine[:, :, None], np.broadcast_to(others, (*mine.shape[:2], *others.shape[2:]))],
            axis=2,
        )
        if who == "me":
            return mine
        if who == "mate":
            return np.broadcast_to(others.min(axis=2), mine.shape)
        if who == "sum":
            return np.where(every < FAR, every, 0).sum(axis=2)
        ordered = np.sort(every, axis=2)
        return np.asarray(ordered[:, :, 0 if who == "nearest" else min(1, ordered.shape[2] - 1)])

    def values(self, one: Input) -> Floats:
        """Return an input, (n, moves)."""
        apart = self.apart(one.who, one.path)
        most = sum(self.place.board.shape)
        apart = np.minimum(apart, most)
        found: Floats = {
            "distance": lambda: apart,
            "out": lambda: (apart > 1).astype(float),
            "out2": lambda: (apart > 2).astype(float),
            "near": lambda: 1 / (1 + apart) ** 2,
            "odd": lambda: (apart % 2).astype(float),
            "there": lambda: (apart == 0).astype(float),
        }[one.what]()
        inside = self.sets[one.cells]  # (n, 1 or moves, evaders, cells)
        of_cells = found[:, :, None]
        if one.over_cells in ("mean", ""):
            of_evaders = (of_cells * inside).sum(axis=3) / inside.sum(axis=3)
        elif one.over_cells == "most":
            of_evaders = np.where(inside, of_cells, -np.inf).max(axis=3)
        else:
            of_evaders = np.where(inside, of_cells, np.inf).min(axis=3)
        gone = self.gone[:, None]
        if one.over_evaders == "sum":
            return np.asarray(np.where(gone, 0.0, of_evaders).sum(axis=2))
        least = np.where(gone, np.inf, of_evaders).min(axis=2)
        return np.asarray(np.where(np.isfinite(least), least, 0.0))


def opposite(place: Place) -> Floats:
    """Return whether two pursuers stand on opposite sides of an evader, (n, moves), 0 to 1.

    It is (1 - cosine) / 2 of the directions from the nearest evader to this pursuer and to the
    teammate that is nearest to the evader; 1 / 2 if one stands on it, 0 without a pair.
    """
    looks = Looks(place)
    cols = place.board.shape[1]
    found = np.zeros(place.after.shape)
    for view, cell in np.ndindex(*found.shape):
        me = np.array(divmod(place.after[view, cell], cols))
        evaders = [np.array(divmod(e, cols)) for e in looks.evaders[view] if e >= 0]
        mates = [np.array(divmod(m, cols)) for m in looks.mates[view] if m >= 0]
        if not evaders or not mates:
            continue
        evader = min(evaders, key=lambda e: np.abs(e - me).sum())
        mate = min(mates, key=lambda m: np.abs(m - evader).sum())
        length = np.linalg.norm(me - evader) * np.linalg.norm(mate - evader)
        cosine = (me - evader) @ (mate - evader) / length if length else 0.0
        found[view, cell] = (1 - np.clip(cosine, -1, 1)) / 2
    return found


BY_HAND: Mapping[str, Input | Values] = {
    "escapes": Input("out", "nearest", "free", "next", "mean", "least"),
    "opposite": opposite,
    "parity": Input("odd", "me", "free", "now", "", "least"),
}
"""What trials had found by hand."""


# ---- Positions and separation --------------------------------------------------------------------


def mistakes(place: Place, ratings: Floats) -> Floats:
    """Return what a policy loses by a move (t) in place of a best one (g): (n, moves g, moves t).

    Each position weighs how often it comes about against the best response to the policy.
    """
    states, perfect = place.states, place.perfect
    table = place.table(place.play(ratings))
    response = best_response(states, table, "pursuer")
    n, moves = place.after.shape
    found = np.zeros((n, moves, moves))
    play = place.play(ratings)
    for visit in visits(perfect, table, response, "pursuer"):
        of_turn = place.places[visit.turn]
        if not of_turn.shape[1]:
            continue
        [met] = np.nonzero(visit.reach)
        after = perfect.after(visit.rounds, visit.turn)[states.successors(visit.turn)[met]]
        values = after.min(axis=2).reshape(len(met), *[moves] * of_turn.shape[1])
        for column, views in enumerate(of_turn[met].T):
            others = tuple(axis for axis in range(1, values.ndim) if axis != 1 + column)
            of_moves = np.where(place.allowed[views], values.max(axis=others), -np.inf)
            of_moves = of_moves if others else of_moves.reshape(len(met), moves)
            best = of_moves.max(axis=1, keepdims=True)
            good = of_moves >= best - 1e-9
            lost = play[views] * np.where(good, 0.0, np.nan_to_num(best - of_moves, posinf=0.0))
            share = good / good.sum(axis=1, keepdims=True)
            weights = visit.reach[met][:, None, None] * share[:, :, None] * lost[:, None]
            np.add.at(found, views[views >= 0], weights[views >= 0])
    return found


def separation(wrong: Floats, values: Floats) -> float:
    """Return how far an input (n, moves) tells best moves from those taken, -1 to 1."""
    total = wrong.sum()
    if not total:
        return 0.0
    signs = np.sign(np.round(values[:, :, None] - values[:, None], 9))
    return float((wrong * signs).sum() / total)


# ---- Forward selection ---------------------------------------------------------------------------


class Pool:
    """The worlds that choose, and all inputs in them, without those that are equal to others."""

    def __init__(self, places: Sequence[Place], inputs: Sequence[Input]) -> None:
        self.places = places
        self.looks = [Looks(place) for place in places]
        self.values: dict[Input, list[Floats]] = {}
        known = set()
        for one in tqdm(inputs, desc="grammar", unit=" inputs", disable=None):
            values = [looks.values(one) for looks in self.looks]
            varies = any(np.ptp(each, axis=1).any() for each in values)
            key = b"".join(np.round(each, 6).tobytes() for each in values)
            if varies and key not in known:
                known.add(key)
                self.values[one] = values

    def columns(self, number: int, chosen: Sequence[Input]) -> list[Floats]:
        """Return today's inputs and the chosen ones in a world."""
        place = self.places[number]
        return [place.today[name] for name in TODAY] + [self.values[one][number] for one in chosen]


def selected(pool: Pool, budget: int, rounds: int) -> dict[str, Any]:
    """Return the inputs that forward selection chooses, and what was seen in each round."""
    chosen: list[Input] = []
    rows: list[dict[str, Any]] = []

    def searched(inputs: Sequence[Input]) -> tuple[list[float], list[Floats]]:
        pairs = [
            by_weights(place, pool.columns(number, inputs), budget, seed=number)
            for number, place in enumerate(pool.places)
        ]
        return [share for share, _ in pairs], [weights for _, weights in pairs]

    shares, weights = searched(chosen)
    ranks: dict[str, int] = {}
    for number in range(rounds):
        wrong = [
            mistakes(place, scaled(pool.columns(n, chosen)) @ weights[n])
            for n, place in enumerate(pool.places)
        ]
        told = {
            one: float(np.mean([separation(w, v) for w, v in zip(wrong, values, strict=True)]))
            for one, values in pool.values.items()
            if one not in chosen
        }
        order = sorted(told, key=lambda one: -abs(told[one]))
        if not number:
            ranks = {name: rank_of(pool, order, one) for name, one in BY_HAND.items()}
        tried = {one: searched([*chosen, one]) for one in order[:CANDIDATES]}
        best = max(tried, key=lambda one: np.mean(tried[one][0]))
        risen = float(np.mean(tried[best][0]) - np.mean(shares))
        rows.append(
            {
                "positions": int(sum((each.sum(axis=(1, 2)) > 0).sum() for each in wrong)),
                "of": int(sum(len(each) for each in wrong)),
                "input": best.name,
                "sentence": best.sentence,
                "separates": told[best],
                "share": float(np.mean(tried[best][0])),
                "risen": risen,
                "others": {
                    one.name: [told[one], float(np.mean(found))]
                    for one, (found, _) in tried.items()
                },
            }
        )
        if risen < LEAST:
            break
        chosen.append(best)
        shares, weights = tried[best]
    return {
        "inputs": [list(one) for one in chosen],
        "rounds": rows,
        "ranks": ranks,
        "grammar": len(pool.values),
        "begin": float(np.mean(searched([])[0])),
    }


def rank_of(pool: Pool, order: Sequence[Input], one: Input | Values) -> int:
    """Return the place of an input in an order, from 1; 0 if it is not in the grammar."""
    if not isinstance(one, Input):
        return 0
    values = [looks.values(one) for looks in pool.looks]
    for number, each in enumerate(order, 1):
        if all(np.allclose(a, b) for a, b in zip(values, pool.values[each], strict=True)):
            return number
    return 0


# ---- Measures ------------------------------------------------------------------------------------


def columns_of(place: Place, inputs: Sequence[Input | Values]) -> list[Floats]:
    """Return today's inputs and others in a world."""
    looks = Looks(place)
    more = [looks.values(one) if isinstance(one, Input) else one(place) for one in inputs]
    return [*(place.today[name] for name in TODAY), *more]


def sets_of(found: Sequence[Input]) -> dict[str, Sequence[Input | Values]]:
    """Return the sets of inputs that are measured, by name."""
    sets: dict[str, Sequence[Input | Values]] = {"today's 7": ()}
    for count in range(1, len(found) + 1):
        sets[f"7 + {count} found"] = found[:count]
    return {**sets, "7 + 3 by hand": tuple(BY_HAND.values())}


def share_in(world: SuiteWorld, inputs: Sequence[Input | Values], budget: int) -> dict[str, Any]:
    """Return the share that weights of a world's own guarantee, and the weights."""
    place = Place(world)
    share, weights = by_weights(place, columns_of(place, inputs), budget, seed=0)
    return {"share": share, "weights": weights.tolist()}


def for_all(
    learn: Sequence[SuiteWorld],
    test: Sequence[SuiteWorld],
    inputs: Sequence[Input | Values],
    budget: int,
) -> dict[str, Any]:
    """Return the shares of one set of weights, learned in some worlds, in these and in others."""
    places = [Place(world) for world in learn]
    arrays = [np.stack(columns_of(place, inputs), axis=2) for place in places]
    spread = np.concatenate([each.reshape(-1, each.shape[2]) for each in arrays]).std(axis=0)
    spread = np.where(spread > 0, spread, 1.0)
    arrays = [each / spread for each in arrays]

    def value(weights: Floats) -> float:
        shares = [p.guarantee(x @ weights) for p, x in zip(places, arrays, strict=True)]
        return float(np.mean(shares))

    best, weights = search(value, len(spread), budget, np.random.default_rng(0))
    others = []
    for world in test:
        place = Place(world)
        others.append(
            place.guarantee(np.stack(columns_of(place, inputs), axis=2) @ (weights / spread))
        )
    return {"learned": best, "held out": others, "weights": (weights / spread).tolist()}


def further(quick: bool) -> list[SuiteWorld]:
    """Return the worlds in turns of the experiment on leagues."""
    names = league_worlds.draw_worlds()[::2][: 1 if quick else None]
    return [SuiteWorld.of(league_worlds.config_of(name)) for name in names]


# ---- Table ---------------------------------------------------------------------------------------


def table(found: Mapping[str, Any]) -> str:
    """Return what was found, in Markdown."""
    chosen = found["selected"]
    lines = [
        f"The grammar has {chosen['grammar']} different inputs. Where the ten best of a round by "
        "separation were tried, the best stayed. *Positions*: views in which the policy before it "
        "loses something, of all views of the worlds that choose.",
        "",
    ]
    rows = [
        [str(n), row["input"], f"{row['separates']:+.2f}", f"{row['positions']} of {row['of']}",
         f"{row['share']:.3f}", f"{row['risen']:+.3f}"]
        for n, row in enumerate(chosen["rounds"], 1)
    ]  # fmt: skip
    heads = ["", "input", "separates", "positions", "mean share", "rise"]
    lines += [markdown(heads, rows), ""]
    lines += [f"{n}. {row['sentence']}" for n, row in enumerate(chosen["rounds"], 1)]
    ranks = ", ".join(
        f"`{name}` {rank}" if rank else f"`{name}` is not in it"
        for name, rank in chosen["ranks"].items()
    )
    lines += ["", f"Places of what trials found by hand in the first order: {ranks}.", ""]
    shares = {
        kind: {where: np.array(of_kind[where]) for where in of_kind}
        for kind, of_kind in found["shares"].items()
    }
    first = shares["today's 7"]
    rows = []
    for kind, of_kind in shares.items():
        cells = [mean(of_kind[where], bounds=(0, 1)) for where in first]
        gain = of_kind["held out"] - first["held out"]
        rows.append([kind, *cells, "" if kind == "today's 7" else mean(gain, sign="+")])
    heads = ["weights of each world's own", *first, "gain, held out"]
    lines += [markdown(heads, rows), "", "Mean share of perfect play [95 % over worlds].", ""]
    rows = []
    for kind, one in found["for all"].items():
        held_out = mean(one["held out"], bounds=(0, 1))
        gain = np.array(one["held out"]) - found["for all"]["today's 7"]["held out"]
        more = "" if kind == "today's 7" else mean(gain, sign="+")
        rows.append([kind, f"{one['learned']:.3f}", held_out, more])
    heads = ["one set of weights for all worlds", "in those that choose", "held out", "gain"]
    lines += [markdown(heads, rows), ""]
    last = list(shares)[-2]
    for words, before, after in (
        ("weights of each world's own", first["held out"], shares[last]["held out"]),
        ("one set of weights", found["for all"]["today's 7"]["held out"],
         found["for all"][last]["held out"]),
    ):  # fmt: skip
        goal = (1 + np.mean(before)) / 2
        met = "met" if np.mean(after) >= goal else "not met"
        lines.append(
            f"Goal with {words}, held out: {goal:.3f}; {last}: {np.mean(after):.3f}, {met}."
        )
    return "\n".join(lines)


def main() -> None:
    """Look for inputs, and write what they are worth."""
    args = script_parser(__doc__, quick="two worlds and a small grammar", runs=True).parse_args()
    worlds = [mw.SUITE.worlds[number - 1] for number in IN_TURNS]
    if args.quick:
        worlds = worlds[:2]
    choose, held_out = worlds[::2], worlds[1::2]
    tried, measured, together = (24, 24, 24) if args.quick else (TRIED, MEASURED, TOGETHER)
    rounds = 1 if args.quick else ROUNDS

    def select() -> dict[str, Any]:
        pool = Pool([Place(world) for world in choose], grammar(args.quick))
        return selected(pool, tried, rounds)

    chosen = kept(args.runs / "selected.json", select)
    inputs = [Input(*words) for words in chosen["inputs"]]
    places = {"choosing": choose, "held out": held_out, "further": further(args.quick)}
    shares: dict[str, dict[str, list[float]]] = {}
    for kind, of_kind in sets_of(inputs).items():
        shares[kind] = {}
        for where, given in places.items():
            files = [args.runs / f"{kind} {where} {n}.json" for n in range(len(given))]
            one = [
                kept(file, partial(share_in, world, of_kind, measured))
                for file, world in zip(files, given, strict=True)
            ]
            shares[kind][where] = [each["share"] for each in one]
    together_by_kind = {
        kind: kept(
            args.runs / f"{kind} for all.json",
            partial(for_all, choose, held_out, of_kind, together),
        )
        for kind, of_kind in sets_of(inputs).items()
    }
    found = {"selected": chosen, "shares": shares, "for all": together_by_kind}
    write_json(args.results, found, table(found))


if __name__ == "__main__":
    main()
