"""One learned team of pursuers for every crowd, beside a script and published pursuers.

    python evolution/one_team.py           learns and tests: an hour of one core
    python evolution/one_team.py --quick   two epochs and the smallest level, some seconds

Teams are runs of ``one_team.toml``, which meet evaders that move at random, and of
``one_team_still.toml``, which mostly meet evaders that stand still. They play the levels of
`scripted_pursuit` in both of its settings, also without their given plan of search, whose weights
are 0 then, and at five levels meet evaders that stand still, flee or dodge. Look at the captures in
the last step, the steps, the episodes that freeze or are in a livelock (`liveness`), and the
agent-steps of pursuers at fault.

``--results`` receives the numbers, the table and the teams. Rows that are there are not played
again. The first runs of ``one_team.toml`` were not kept: only their captures, steps and faults.
"""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from tqdm import tqdm

import matrixworld as mw
import scripted_pursuit as scripted
from common import finish_all, markdown, mean, script_parser, slug, write_json
from liveness import Looked
from matrixworld._util.files import load_toml, replacing
from matrixworld.coevolution import RaceSettings
from matrixworld.world.policy import TeamPolicy
from scripted_pursuit import BEST, FIRST_SEED, SOME, STEPS, Level, Played

QUICK = {"schedule.epochs": 2, "match_episodes": 1, "train_steps": 20}
LEARNED, STILL = "learned", "learned, still evaders too"
SETTINGS = {LEARNED: ("one_team.toml", 5), STILL: ("one_team_still.toml", 3)}
"""Files of settings, and numbers of seeds."""
SHORT = {"random": LEARNED, "still": STILL}
"""Names of kinds on the command line, by the evaders of which they learn."""
AUTHORS, SB = "the authors' setting", "SB"
EVADERS = "random", "still", "fleer", "dodger"


class Row(NamedTuple):
    """Episodes of some pursuers in a setting, against some evaders, at a level."""

    pursuers: str
    setting: str
    evaders: str
    level: Level
    captured: list[float]
    """Share of the evaders that is captured in the last step, of each episode."""
    steps: list[int]
    faults: int
    """Agent-steps of pursuers at fault, in all episodes."""
    teams: int = 1
    """Learned teams, which play the episodes in turn."""
    freezes: int | None = None
    livelocks: int | None = None

    @property
    def key(self) -> tuple[Any, ...]:
        """What is played, and where."""
        return self[:4]


def episodes_of(level: Level) -> int:
    """Return how many episodes of a level are played."""
    return 90 if level.pursuers < 512 else 24 if level.pursuers < scripted.MANY else 12


def without_plan(kind: str) -> str:
    """Return what teams of a kind are called without the plan of search."""
    return f"{kind}, no plan"


def cases(kinds: Iterable[str]) -> list[tuple[str, str, str, Level]]:
    """Return pursuers, setting, evaders and level of each row."""
    every = tuple(scripted.published())
    # In crowds evaders are always in view.
    small = tuple(at for at in every if at.side == SOME[0].side and at.pursuers <= 256)
    found = [(BEST, SB, evaders, at) for evaders in EVADERS for at in SOME]
    for kind in kinds:
        found += [(kind, setting, "random", at) for setting in (AUTHORS, SB) for at in every]
        found += [(kind, SB, evaders, at) for evaders in EVADERS[1:] for at in SOME]
        no_plan = without_plan(kind)
        found += [(no_plan, setting, "random", at) for setting in (AUTHORS, SB) for at in small]
    return sorted(found, key=lambda case: case[3])


def play(case: tuple[str, str, str, Level], teams: Sequence[TeamPolicy], episodes: int) -> Row:
    """Play the episodes of a row."""
    _, setting, evaders, level = case
    captured, steps, faults, freezes, livelocks = [], [], 0, 0, 0
    for k in range(episodes):
        one = episode_of(setting, evaders, level, teams[k % len(teams)], FIRST_SEED + k)
        looked = Looked.of(one.positions, np.zeros((level.side, level.side)), level.pursuers)
        captured.append(round(one.captured, 6))
        steps.append(one.steps)
        faults += one.faults
        freezes += looked.freezes
        livelocks += looked.livelocks
    return Row(*case, captured, steps, faults, len(teams), freezes, livelocks)


def episode_of(setting: str, evaders: str, level: Level, team: TeamPolicy, seed: int) -> Played:
    """Play an episode in a setting."""
    if setting == AUTHORS:
        return scripted.authors_episode(level, team, seed)
    played = mw.record(scripted.world_of(level), team, evaders, seed=seed)
    faults = int(played.fault[:, : level.pursuers].any(-1).sum())
    return Played(float(played.capture_rate), len(played.positions) - 1, faults, played.positions)


def teams_of(kind: str, runs: Path, threads: int | None, quick: bool) -> list[mw.Population]:
    """Return the teams of a kind, which learn first where they have not."""
    file, seeds = SETTINGS[kind]
    settings = RaceSettings.of(load_toml(Path(__file__).with_name(file)))
    settings = settings.changed(QUICK if quick else {})
    planned = {
        f"{slug(kind)}/seed-{seed}": settings.changed({"seed": seed})
        for seed in range(1 if quick else seeds)
    }
    return [run.last("pursuer") for run in finish_all(planned, runs, threads=threads).values()]


def without(team: mw.Population) -> mw.Population:
    """Return a team whose ratings do not read the plan of search."""
    return mw.Population(team.policy.without(team.genomes[0], "search"), team.policy)


# What the rows say:


def table(rows: Iterable[Row]) -> str:
    """Return what all pursuers reach: at every level in both settings, and with other evaders."""
    known = {row.key: row for row in rows}
    named = [name for kind in SETTINGS for name in (kind, without_plan(kind))]
    kinds = [name for name in named if any(row.pursuers == name for row in known.values())]
    looked = [row for row in known.values() if row.freezes is not None]
    parts = [
        "Both settings side by side, 40 x 40 cells, evaders at random: captured in the last step / "
        "steps. The best learner is that of actor-critic, IPPO and MAPPO which captures most.",
        side_by_side(known),
        "Evaders captured in the last step / steps [95 % over episodes]; in brackets the worst of "
        f"several teams, or published collisions in an episode. Evaders at random, {AUTHORS}:",
        of_setting(AUTHORS, kinds, known),
        f"Evaders at random, {SB}; the published numbers, of the other setting, again:",
        of_setting(SB, kinds, known),
    ]
    if looked:
        parts += [
            "Episodes that freeze, and that are in a livelock, of all:",
            of_episodes(looked),
            f"Other evaders, {SB}, 40 x 40 cells: captured / steps; episodes that freeze, and that "
            "are in a livelock, of all:",
            of_crowds(looked),
        ]
    parts += [
        "Pursuers at fault, in all episodes of these tables:",
        markdown(["", "agent-steps at fault", "agent-steps"], faults(known.values())),
    ]
    return "\n\n".join(parts).replace("|  |", "| |").replace("|  |", "| |")


def side_by_side(known: Mapping[tuple[Any, ...], Row]) -> str:
    """Return what is published beside learned teams in both settings, at the nine levels."""
    ours = [(kind, setting) for kind in SETTINGS for setting in (AUTHORS, SB)]
    lines = []
    for at in nine():
        values = scripted.published()[at]
        _, best = max((told[0], name) for name, told in values.items() if name != "FSC2")
        told = [f"{values[name][0]:.3g} / {values[name][1]:.0f}" for name in ("FSC2", best)]
        found = [known.get((kind, setting, "random", at)) for kind, setting in ours]
        lines.append([str(at), told[0], f"{told[1]} ({best})", *map(cell, found)])
    heads = ["", "FSC2, published", "best learner, published"]
    return markdown([*heads, *(f"{kind}; {setting}" for kind, setting in ours)], lines)


def nine() -> list[Level]:
    """Return the levels at which learners are published."""
    return [at for at, values in scripted.published().items() if len(values) > 1]


def of_setting(setting: str, kinds: Sequence[str], known: Mapping[tuple[Any, ...], Row]) -> str:
    """Return what all reach at every level in a setting, against evaders at random."""
    theirs, script = scripted.published(), scripts()
    methods = list(dict.fromkeys(name for each in theirs.values() for name in each))
    lines = []
    for at, values in theirs.items():
        told = [scripted.published_cell(values[name]) if name in values else "" for name in methods]
        ours = [known.get((kind, setting, "random", at)) for kind in kinds]
        lines.append([str(at), *told, *map(cell, [script.get((setting, at)), *ours])])
    return markdown(["", *(f"{name}, published" for name in methods), BEST, *kinds], lines)


def of_episodes(rows: Sequence[Row]) -> str:
    """Return how many episodes against evaders at random freeze or are in a livelock."""
    found = {row.key: row for row in rows if row.evaders == "random"}
    kinds = list(dict.fromkeys((row.pursuers, row.setting) for row in found.values()))
    lines = [
        [str(at), *(of_stuck(found.get((*kind, "random", at))) for kind in kinds)]
        for at in scripted.published()
    ]
    return markdown(["", *map(", ".join, kinds)], lines)


def of_crowds(rows: Sequence[Row]) -> str:
    """Return what the script and learned teams reach against other evaders."""
    found = {row.key: row for row in rows}
    lines = [
        [evaders, kind, *(of_crowd(found.get((kind, SB, evaders, at))) for at in SOME)]
        for evaders in EVADERS
        for kind in (BEST, *SETTINGS)
        if any(row.pursuers == kind for row in rows)
    ]
    return markdown(["evaders", "pursuers", *map(str, SOME)], lines)


def scripts() -> dict[tuple[str, Level], scripted.Row]:
    """Return the kept rows of the script with evaders at random, by setting and level."""
    kept = scripted.read_rows((scripted.RESULTS / "numbers.json").read_text(encoding="utf-8"))
    names = {AUTHORS: "the authors' setting", SB: "SB, evaders at random"}
    return {(setting, at): row for setting, name in names.items() for at, row in kept[name].items()}


def captured_of(row: Row | scripted.Row) -> str:
    """Return the captures of a row as text."""
    told, teams = f"{np.mean(row.captured):.3g}", getattr(row, "teams", 1)
    if teams == 1:
        return told
    worst = min(np.mean(row.captured[team::teams]) for team in range(teams))
    return f"{told} ({worst:.3g})"


def cell(row: Row | scripted.Row | None) -> str:
    """Return captures and steps of a row as text."""
    if row is None:
        return ""
    return f"{captured_of(row)} / {mean(row.steps, 0, bounds=(0.0, float(STEPS)))}"


def of_stuck(row: Row | None) -> str:
    """Return how many episodes of a row freeze and are in a livelock, as text."""
    return "" if row is None else f"{row.freezes}, {row.livelocks} of {len(row.steps)}"


def of_crowd(row: Row | None) -> str:
    """Return captures, steps and episodes that are stuck of a row as text."""
    return "" if row is None else f"{cell(row)}; {of_stuck(row)}"


def faults(rows: Iterable[Row]) -> list[list[str]]:
    """Return pursuers, their agent-steps at fault, and all of these, as lines of a table."""
    found: dict[str, list[int]] = {}
    for row in rows:
        counts = found.setdefault(row.pursuers, [0, 0])
        counts[0] += row.faults
        counts[1] += row.level.pursuers * sum(row.steps)
    return [[name, *(f"{count:,}" for count in counts)] for name, counts in found.items()]


def without_fault(kept: Iterable[Mapping[str, Any]], pursuers: str) -> int:
    """Return the agent-steps of pursuers in rows as a file keeps them.

    Raises
    ------
    ValueError
        if one of them was at fault.
    """
    rows = [row for row in kept if row["pursuers"] == pursuers]
    if at_fault := sum(row["faults"] for row in rows):
        raise ValueError(f"expected no fault of {pursuers}, got {at_fault}")
    return sum(row["level"][1] * sum(row["steps"]) for row in rows)


# Files:


def read_rows(text: str) -> list[Row]:
    """Return the rows that a file keeps."""
    return [Row(**{**row, "level": Level(*row["level"])}) for row in json.loads(text)]


def kept_rows(file: Path) -> dict[tuple[Any, ...], Row]:
    """Return the rows in a file by their keys; none without one."""
    rows = read_rows(file.read_text(encoding="utf-8")) if file.exists() else []
    return {row.key: row for row in rows}


def main() -> None:
    """Let the teams learn, play all rows, and write them."""
    parser = script_parser(__doc__, quick="two epochs and the smallest level", runs=True)
    parser.add_argument("--threads", type=int, help="for training; default: one for each core")
    parser.add_argument("--kinds", nargs="+", choices=SHORT, default=[*SHORT], help="default: all")
    args = parser.parse_args()
    args.results.mkdir(parents=True, exist_ok=True)
    teams: dict[str, Sequence[TeamPolicy]] = {BEST: [BEST]}
    for name in args.kinds:
        kind = SHORT[name]
        learned = teams_of(kind, args.runs, args.threads, args.quick)
        teams |= {kind: learned, without_plan(kind): [without(team) for team in learned]}
        np.save(args.results / f"{name}.npy", np.concatenate([team.genomes for team in learned]))
    file = args.results / "numbers.json"
    rows = kept_rows(file)
    kinds = [SHORT[name] for name in args.kinds]
    chosen = [case for case in cases(kinds) if not args.quick or case[3] == SOME[0]]
    for case in tqdm([case for case in chosen if case not in rows], disable=None):
        row = play(case, teams[case[0]], 2 if args.quick else episodes_of(case[3]))
        rows[row.key] = row
        with replacing(file) as whole:
            whole.write(json.dumps([each._asdict() for each in rows.values()]).encode())
    write_json(args.results, [row._asdict() for row in rows.values()], table(rows.values()))


if __name__ == "__main__":
    main()
