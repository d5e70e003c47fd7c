"""Counts of judgements whose truth is known, and tables of them: false alarms, hits, open cases."""

from __future__ import annotations

import csv
from collections import Counter
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import Any

import matplotlib.pyplot as plt
import numpy as np
from scipy.stats import beta

from common import markdown
from judgement_races import ALL_KINDS, OUTLIERS
from judgement_truths import WINDOWS
from matrixworld.analysis import CONDITIONS

Row = dict[str, str]
VERDICTS = PRESENT, ABSENT, CANNOT_TELL = "present", "absent", "cannot tell"
DEVELOPMENT, HELD_BACK = "development", "held back"

GAINS = (0.02, 0.05, 0.1, 0.2, 0.3, 0.5)
"""Edges of the bins of the figure: the smaller gain of both teams. The last has no upper end."""


# ---- Counts --------------------------------------------------------------------------------------


def sample(judgement: dict[str, Any]) -> str:
    """Return the part of the benchmark that a race belongs to."""
    if judgement["source"] not in ("synthetic", "hard", "outliers", "limits"):
        return str(judgement["source"])
    return _sample_of(judgement["kind"])


def count_verdicts(judgements: Iterable[dict[str, Any]]) -> list[Row]:
    """Return verdicts by sample, kind, condition, window and truth, where it is known."""
    return _wide(
        ("sample", "kind", "condition", "window", "truth"),
        (
            ((sample(one), one["kind"], condition, window, str(holds)), verdict)
            for one in judgements
            for window, condition, holds, _, verdict in one["found"]
            if holds is not None
        ),
    )


def count_races(judgements: Iterable[dict[str, Any]]) -> list[Row]:
    """Return how many races are said to make progress, by kind, size of the group and truth.

    A race counts once. Said falsely: an arms race or one-sided progress in any window that has
    none; falsely in any way: any condition that is not there. "With outliers": of judgements that
    do not leave out outlying generations.
    """
    counts: Counter[tuple[str, ...]] = Counter()
    for one in judgements:
        runs = int(one["setting"].get("runs", 1))
        size = next(name for most, name in GROUPS.items() if runs <= most)
        found = [(window, name, holds, verdict) for window, name, holds, _, verdict in one["found"]]
        [holds] = [h for w, name, h, _ in found if (w, name) == ("whole", "arms race")]
        key = (one["kind"], size, str(holds))
        counts[(*key, "races")] += 1
        counts[(*key, "false")] += bool(_alarms(found))
        for ending, each in (("", found), (WITH_OUTLIERS, one["with_outliers"])):
            counts[(*key, f"hits{ending}")] += bool(holds) and (
                ("whole", "arms race", True, PRESENT) in map(tuple, each)
            )
            counts[(*key, f"false progress{ending}")] += bool(_alarms(each) & {*PROGRESS})
    numbers = (
        "races", "hits", "false progress", "false", f"hits{WITH_OUTLIERS}",
        f"false progress{WITH_OUTLIERS}",
    )  # fmt: skip
    return [
        dict(zip(("kind", "runs", "truth"), key, strict=True))
        | {name: str(counts[(*key, name)]) for name in numbers}
        for key in sorted({key[:3] for key in counts})
    ]


def _alarms(found: Iterable[Sequence[Any]]) -> set[str]:
    """Return the conditions that are present in any window, and not there."""
    return {name for _, name, holds, verdict in found if verdict == PRESENT and holds is False}


def count_by_setting(judgements: Iterable[dict[str, Any]]) -> list[Row]:
    """Return verdicts on synthetic races, whole race, by each setting alone."""
    return _wide(
        ("setting", "value", "condition", "truth"),
        (
            ((setting, value, condition, str(holds)), verdict)
            for one in judgements
            for setting, value in one["setting"].items()
            for window, condition, holds, _, verdict in one["found"]
            if holds is not None and window == "whole"
        ),
    )


def count_by_gain(judgements: Iterable[dict[str, Any]]) -> list[Row]:
    """Return verdicts "arms race" on the last half of such races, by noise and true gain."""
    counted = []
    for one in judgements:
        for window, condition, holds, gain, verdict in one["found"]:
            if holds and (window, condition) == ("last half", "arms race"):
                # Gains beyond the last edge belong to the last bin.
                place = min(int(np.searchsorted(GAINS, gain, "right")), len(GAINS) - 1)
                ends = (f"{GAINS[place - 1]:g}", f"{GAINS[place]:g}")
                counted.append(((one["setting"]["noise"], *ends), verdict))
    return _wide(("noise", "from", "to"), counted)


def count_changes(judgements: Iterable[dict[str, Any]]) -> list[Row]:
    """Return how many intervals of single races contain the true change of strength."""
    counts = Counter(
        (setting, value, window, "covered" if low <= true <= high else "missed")
        for one in judgements
        for window, _, true, low, high in one["changes"]
        for setting, value in one["setting"].items()
        if setting in ("noise", "episodes known", "generations")
    )
    keys = dict.fromkeys(key[:3] for key in counts)
    heads = ("setting", "value", "window")
    return [
        dict(zip(heads, key, strict=True))
        | {name: str(counts[(*key, name)]) for name in ("covered", "missed")}
        for key in sorted(keys)
    ]


def _wide(heads: Sequence[str], counted: Iterable[tuple[tuple[str, ...], str]]) -> list[Row]:
    """Return a row for each key, with the number of each verdict."""
    counts = Counter(counted)
    return [
        dict(zip(heads, key, strict=True)) | {name: str(counts[key, name]) for name in VERDICTS}
        for key in sorted({key for key, _ in counts})
    ]


def totals(rows: Iterable[Row], **wanted: str) -> dict[str, int]:
    """Return the number of each verdict, over the rows that have the wanted values."""
    of = [row for row in rows if wanted.items() <= row.items()]
    return {verdict: sum(int(row[verdict]) for row in of) for verdict in VERDICTS}


PROGRESS = ("arms race", "one-sided progress")
WITH_OUTLIERS = ", with outliers"
GROUPS = {1: "1", 3: "2 or 3", 10: "4 to 10"}
"""Sizes of groups by their most runs."""
LEAST = 8
"""Fewest races of a kind that may be the worst one."""
ALLOWED = 0.05
"""False alarms that a judgement may have, as a share."""


# ---- Rates ---------------------------------------------------------------------------------------


def upper_bound(count: int, of: int) -> float:
    """Return the upper end of a 95 % one-sided interval of a rate; 1 without any trial.

    References
    ----------
    Clopper and Pearson (1934), "The use of confidence or fiducial limits illustrated in the case of
    the binomial".
    """
    return float(beta.ppf(0.95, count + 1, of - count)) if count < of else 1.0


def _rates(found: dict[str, int]) -> list[str]:
    """Return the number of races, and the share of each verdict."""
    races = sum(found.values())
    return [str(races), *(_share(found[name], races) for name in VERDICTS)]


def _share(count: int, of: int) -> str:
    return f"{count / of:.1%}" if of else "-"


def _bound(found: dict[str, int]) -> str:
    races = sum(found.values())
    return f"{upper_bound(found[PRESENT], races):.1%}" if races else "-"


# ---- Tables --------------------------------------------------------------------------------------


RATE_HEADS = (
    "has it: races", "hits", "false absents", "cannot tell",
    "has it not: races", "false alarms", "at most", "right absents", "cannot tell",
)  # fmt: skip


def errors_of(rows: Sequence[Row], **wanted: str) -> list[str]:
    """Return the cells below `RATE_HEADS`."""
    hits = totals(rows, truth="True", **wanted)
    alarms = totals(rows, truth="False", **wanted)
    races, alarm, *others = _rates(alarms)
    return [*_rates(hits), races, alarm, _bound(alarms), *others]


def _known(rows: Sequence[Row], *heads: str) -> list[tuple[str, ...]]:
    """Return the combinations of values that occur, in the order of the conditions."""
    # A kind may be named like a condition, which comes first.
    order = {
        name: place for place, name in enumerate(dict.fromkeys((*CONDITIONS, *WINDOWS, *ALL_KINDS)))
    }
    keys = {tuple(row[head] for head in heads) for row in rows}
    return sorted(keys, key=lambda key: [(order.get(part, 99), part) for part in key])


def report(
    races: Sequence[Row],
    counts: Sequence[Row],
    settings: Sequence[Row],
    changes: Sequence[Row],
    limits: Sequence[Row],
) -> str:
    """Return all tables from the rows of the functions that count."""
    parts = [
        INTRODUCTION,
        "## By race",
        BY_RACE,
        _by_race(races),
        "### Kinds",
        _kinds(races),
        "## Outlying generations",
        OUTLYING,
        _outlying(races),
        "## Limits",
        LIMIT,
        _limits(limits),
        "## By sample",
        _by(counts, "condition", "sample"),
        "## By window",
        _by(counts, "condition", "window"),
        f"## Kinds with more than {ALLOWED:.0%} false alarms",
        _breaches(counts),
        "## By setting, one at a time",
        SETTINGS,
        _by_setting(settings),
        "## Intervals of changes",
        COVERAGE,
        _coverage(changes),
        "## By kind and window",
        _by(counts, "condition", "sample", "kind", "window"),
    ]
    return "\n\n".join(parts) + "\n"


INTRODUCTION = (
    "# Errors of the judgement\n\n"
    "Races whose truth is known, and what the judgement says of them. A *false alarm* is the "
    'verdict "present" on a race that does not have the condition, a *false absent* the verdict '
    '"absent" on a race that has it. "At most" is the upper end of a one-sided 95 % interval '
    "(Clopper and Pearson) of the rate of false alarms. Kinds marked *development* may have served "
    "to set constants, with other seeds; all others are *held back*. Races of which the "
    "definitions (`evolution/validation/judgement_truths.py`) leave the truth open are not counted."
)
BY_RACE = (
    "Each race or group counts once. *Progress*: an arms race or one-sided progress is said of a "
    "window that has none. *Anything*: any condition that is not there. The worst kind stands "
    "beside the count over races. Found: arms races over the whole race."
)
OUTLYING = (
    "A judgement of progress leaves out generations that are far from their neighbours. The same "
    "races judged with them: arms races over the whole race that are found, and races with an arms "
    "race or one-sided progress said falsely of any window. Single kinds are those about outliers."
)
LIMIT = "Races that no payoff matrix tells from an arms race; they do not count above and below."
SETTINGS = (
    "Synthetic races, whole race: hits, of races that have the condition / false alarms, of "
    "those that do not."
)
COVERAGE = (
    "Share of the 95 % intervals of a team's change that contain the true change of its strength; "
    "single synthetic races, where the usual readings of the change agree within .005. Gains are "
    "about a trend, not about this change."
)


def _counted(rows: Iterable[Row], name: str) -> int:
    return sum(int(row[name]) for row in rows)


def _by_race(rows: Sequence[Row]) -> str:
    found = []
    for size in GROUPS.values():
        of = [row for row in rows if row["runs"] == size]
        races = _counted(of, "races")
        cells = [size]
        for name in ("false progress", "false"):
            by_kind = {
                kind: (_counted(k, name), _counted(k, "races"))
                for kind in sorted({row["kind"] for row in of})
                if _counted(k := [row for row in of if row["kind"] == kind], "races") >= LEAST
            }
            worst = max(by_kind, key=lambda kind: by_kind[kind][0] / by_kind[kind][1], default="")
            count, most = by_kind.get(worst, (0, 0))
            cells += [f"{_counted(of, name)} of {races}"]
            cells += [f"{worst}, {count} of {most}" if count else "none"]
        true = [row for row in of if row["truth"] == "True"]
        found.append([*cells, f"{_counted(true, 'hits')} of {_counted(true, 'races')}"])
    heads = ("runs", "progress, falsely", "worst kind", "anything, falsely", "worst kind ",
             "arms races found")  # fmt: skip
    return markdown(heads, found)


def _kinds(rows: Sequence[Row]) -> str:
    found = []
    for (kind,) in _known(rows, "kind"):
        for size in GROUPS.values():
            of = [row for row in rows if (row["kind"], row["runs"]) == (kind, size)]
            true = [row for row in of if row["truth"] == "True"]
            races = _counted(of, "races")
            alarms = _counted(of, "false progress")
            if races:
                found.append([
                    kind, size, str(races), _share(alarms, races),
                    f"{upper_bound(alarms, races):.1%}", _share(_counted(of, "false"), races),
                    _share(_counted(true, "hits"), _counted(true, "races")),
                ])  # fmt: skip
    heads = ("kind", "runs", "races", "progress, falsely", "at most", "anything, falsely", "hits")
    return markdown(heads, found)


def _outlying(rows: Sequence[Row]) -> str:
    kinds: dict[str, tuple[str, list[Row]]] = {
        kind: (_sample_of(kind), [row for row in rows if row["kind"] == kind]) for kind in OUTLIERS
    }
    races = {row["kind"] for row in rows if row["truth"] == "True"}
    without = [row for row in rows if row["kind"] in OUTLIERS and row["kind"] not in races]
    others = [row for row in rows if row["kind"] not in OUTLIERS]
    kinds |= {"kinds without a trend": ("both", without), "all other kinds": ("both", others)}
    found = []
    for kind, (part, of_kind) in kinds.items():
        for size in (*GROUPS.values(), "all"):
            of = [row for row in of_kind if size in (row["runs"], "all")]
            true = _counted([row for row in of if row["truth"] == "True"], "races")
            counts = [
                f"{_counted(of, f'{name}{ending}')} of {most}" if most else "-"
                for name, most in (("hits", true), ("false progress", _counted(of, "races")))
                for ending in ("", WITH_OUTLIERS)
            ]
            found.append([kind, size, part, *counts])
    heads = ("kind", "runs", "sample", "found", "found with outliers", "falsely",
             "falsely with outliers")  # fmt: skip
    return markdown(heads, found)


def _limits(rows: Sequence[Row]) -> str:
    found = []
    for (kind,) in _known(rows, "kind"):
        for size in (*GROUPS.values(), "all"):
            of = [row for row in rows if row["kind"] == kind and size in (row["runs"], "all")]
            races = _counted(of, "races")
            found.append([kind, size, f"{_counted(of, 'false progress')} of {races}"])
    return markdown(("kind", "runs", "progress, falsely"), found)


def _sample_of(kind: str) -> str:
    if kind not in ALL_KINDS:
        return "both"
    return DEVELOPMENT if ALL_KINDS[kind].development else HELD_BACK


def _by(rows: Sequence[Row], *heads: str) -> str:
    found = [
        [*key, *errors_of(rows, **dict(zip(heads, key, strict=True)))]
        for key in _known(rows, *heads)
    ]
    return markdown((*heads, *RATE_HEADS), found)


def _breaches(rows: Sequence[Row]) -> str:
    found = []
    heads = ("condition", "sample", "kind", "window")
    for key in _known(rows, *heads):
        alarms = totals(rows, truth="False", **dict(zip(heads, key, strict=True)))
        races = sum(alarms.values())
        if races and alarms[PRESENT] > ALLOWED * races:
            counted = f"{alarms[PRESENT]} of {races}"
            # The rate is surely too high if 5 % would hardly ever give so many.
            surely = 1.0 - upper_bound(races - alarms[PRESENT], races) > ALLOWED
            found.append([*key, counted, _bound(alarms), "yes" if surely else "no"])
    heads = (*heads, "false alarms", "at most", f"surely above {ALLOWED:.0%}")
    return markdown(heads, found) if found else "None."


def _by_setting(rows: Sequence[Row]) -> str:
    found = []
    for setting, value in sorted(_known(rows, "setting", "value"), key=_natural):
        cells = []
        for condition in CONDITIONS:
            of = {"setting": setting, "value": value, "condition": condition}
            both = (totals(rows, truth=truth, **of) for truth in ("True", "False"))
            cells.append(" / ".join(_count(found) for found in both))
        found.append([setting, value, *cells])
    return markdown(("setting", "value", *CONDITIONS), found)


def _natural(key: tuple[str, ...]) -> tuple[object, ...]:
    """Sort by the words first, and then by the numbers, of a value."""
    words = [word for word in key[-1].split(", ") if not _is_number(word)]
    numbers = [float(word) for word in key[-1].split(", ") if _is_number(word)]
    return (key[:-1], words, numbers)


def _is_number(word: str) -> bool:
    return word.replace(".", "", 1).isdigit()


def _count(found: dict[str, int]) -> str:
    races = sum(found.values())
    return f"{found[PRESENT]} of {races}" if races else "-"


def _coverage(rows: Sequence[Row]) -> str:
    found = []
    for setting, value in sorted(_known(rows, "setting", "value"), key=_natural):
        of = [row for row in rows if (row["setting"], row["value"]) == (setting, value)]
        found.append([setting, value, *(_covered(of, window) for window in WINDOWS)])
    return markdown(("setting", "value", *WINDOWS), found)


def _covered(rows: Sequence[Row], window: str) -> str:
    """Return the share of intervals that contain the truth, and their number."""
    of = [row for row in rows if row["window"] == window]
    covered, missed = (sum(int(row[name]) for row in of) for name in ("covered", "missed"))
    return f"{_share(covered, covered + missed)} of {covered + missed}"


# ---- Files ---------------------------------------------------------------------------------------


def write_counts(rows: Sequence[Row], file: Path) -> None:
    """Write rows to a CSV file."""
    with file.open("w", newline="", encoding="utf-8") as out:
        writer = csv.DictWriter(out, list(rows[0]) if rows else [], lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)


def read_counts(file: Path) -> list[Row]:
    """Return the rows of one of the files of counts."""
    with file.open(newline="", encoding="utf-8") as rows:
        return list(csv.DictReader(rows))


COUNTS = {
    "races": count_races, "counts": count_verdicts, "settings": count_by_setting,
    "changes": count_changes, "limits": count_races,
}  # fmt: skip
"""Files of counts, from which the tables follow."""


def report_of(results: Path) -> str:
    """Return the tables that follow from the counts in a directory."""
    return report(*(read_counts(results / f"{name}.csv") for name in COUNTS))


def write_tables(judgements: Sequence[dict[str, Any]], results: Path) -> str:
    """Write counts, tables and figure to a directory, and return the tables."""
    gains = count_by_gain(one for one in judgements if one["source"] == "power")
    # Gains of the power curves are small on purpose, and would hide those of the other races.
    others = [one for one in judgements if one["source"] not in ("power", "limits")]
    limits = [one for one in judgements if one["source"] == "limits"]
    files = {name: count(limits if name == "limits" else others) for name, count in COUNTS.items()}
    for name, rows in (files | {"power": gains}).items():
        write_counts(rows, results / f"{name}.csv")
    text = report_of(results)
    (results / "errors.md").write_text(text, encoding="utf-8")
    draw_power(gains, results / "power.png")
    return text


def draw_power(rows: Sequence[Row], file: Path, least: int = 5) -> None:
    """Draw at which gain half of the arms races are found, a bar for each number of episodes.

    A bin of gains needs `least` races; a number of episodes without bins has no bar.
    """
    points = {noise: _points(rows, noise, least) for noise in {row["noise"] for row in rows}}
    found = {noise: _half_found(each) for noise, each in points.items() if each}
    noises = sorted(found, key=found.__getitem__, reverse=True)
    figure, axis = plt.subplots(figsize=(7, 2.8), constrained_layout=True)
    bars = axis.barh([_in_words(noise) for noise in noises], [found[n] for n in noises])
    axis.bar_label(bars, fmt="{:.2f}", padding=4)
    axis.margins(x=0.1)
    figure.suptitle("With few episodes only large arms races are found", x=0.0, ha="left")
    axis.set_xlabel("smaller gain of the two teams at which half are found")
    axis.spines[["top", "right", "left"]].set_visible(False)
    axis.tick_params(left=False)
    figure.savefig(file, dpi=120)
    plt.close(figure)


def _half_found(points: Sequence[tuple[float, float]]) -> float:
    """Return the size of an effect at which half are found, between the bins of the counts."""
    sizes, shares = np.array(points).T
    return float(np.interp(0.5, np.maximum.accumulate(shares), sizes))


def _in_words(noise: str) -> str:
    evaders, episodes = noise.split(", ")
    return f"{episodes} episodes a pair, {evaders if evaders[0] == '3' else 'one evader'}"


def _points(rows: Sequence[Row], noise: str, least: int) -> list[tuple[float, float]]:
    """Return middles of the bins of size, and shares of "present"."""
    found = []
    for row in rows:
        races = sum(int(row[verdict]) for verdict in VERDICTS)
        if row["noise"] == noise and races >= least:
            middle = (float(row["from"]) + float(row["to"])) / 2.0
            found.append((middle, int(row[PRESENT]) / races))
    return sorted(found)
