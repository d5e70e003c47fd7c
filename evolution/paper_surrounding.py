"""Do pursuers learn to capture, and safely, at the paper's size? -S as published, and masked.

    python evolution/paper_surrounding.py                        ten runs: four hours of one core
    python evolution/paper_surrounding.py --kinds right-of-way   five runs: 40 minutes of one core
    python evolution/paper_surrounding.py --quick                a small world: some seconds

Twenty pursuers learn by actor-critic to surround five evaders that move at random, on 40 x 40
cells, in episodes of 500 steps (-S). Three kinds of training:

published     settings and rewards of the code that the paper's authors published, 5,000 epochs
no mask       other settings; rewards of the paper without penalties for collisions, 2,500 epochs
right of way  the same, with the mask `policy.mask=right-of-way`

Look at the captures in an episode's last step, and at the collisions: the log of the authors'
training (every tenth epoch) stands beside the first kind. With the mask no pursuer is at fault in
any step of training. Runs resume where they were interrupted. ``--results`` receives the numbers,
the tables and a figure; numbers of other kinds that are there already are kept. ``--device cuda``
learns on a GPU.

Method: Sun et al. (2023), section on Pursuit-Evasion-S; policy gradients with the clipped objective
of PPO (Schulman et al., 2017). Needs PyTorch.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any

import numpy as np
from matplotlib.figure import Figure
from numpy.typing import NDArray

import matrixworld as mw
from common import finish_all, script_parser, written
from matrixworld._util import colors
from matrixworld.analysis import interval_over_runs
from matrixworld.coevolution import RaceSettings, SavedRun
from matrixworld.world.rules import COLLISION_KINDS

Numbers = dict[str, NDArray[Any]]
"""By ``"<kind> / <number>"``: see `of_run`; the first axis is that of the seeds."""

LOG = Path(__file__).parent / "results" / "paper_surrounding" / "published_log.csv"
"""Every tenth epoch of the authors' log (github.com/LijunSun90/MatrixWorld, directory
data/s_train_pursuit_vs_random_evasion): reward of a pursuer, evaders captured in the last step, and
collisions of the pursuers by kind, in one episode each."""
WINDOW = 100
"""Epochs of a mean, and between two archived generations."""
CURVE_EPISODES, LAST_EPISODES = 20, 400
"""Test episodes of each archived generation, and of the last one."""
FIRST_TEST_SEED = 10**6
"""Test episodes have seeds of their own; those of training are hashes."""

WORLD = {"world.rules": "S", "world.n_pursuers": 20, "world.n_evaders": 5}
SMALL = {
    "world.rows": 6, "world.cols": 6, "world.n_pursuers": 4, "world.n_evaders": 1, "world.fov": 5,
    "world.max_steps": 10, "train_steps": 10, "policy.hidden": (8,), "schedule.epochs": 4,
    "schedule.archive_every": 2,
}  # fmt: skip
PUBLISHED = {
    "world.rewards": "published", "schedule.epochs": 5000, "policy.initial_head": 2**0.5,
}  # fmt: skip
FREE = {
    "world.rewards": mw.Rewards(pursuer_collide=0.0),
    "schedule.epochs": 2500, "policy.hidden": (64,), "learner.population": 2, "learner.clip": 0.2,
    "learner.actor_updates": 12, "learner.critic_updates": 12, "learner.minibatches": 4,
    "learner.actor_rate": 1e-3, "learner.critic_rate": 2e-3, "learner.anneal": True,
    "learner.discount": 0.97, "learner.entropy": 0.01,
}  # fmt: skip
KINDS: Mapping[str, tuple[Mapping[str, Any], int]] = {
    "published": (PUBLISHED, 2),
    "no mask": (FREE, 3),
    "right of way": ({**FREE, "policy.mask": "right-of-way"}, 5),
}
"""Settings of each kind, and its seeds."""
DRAWN = {"published": colors.BLUE, "no mask": colors.VERMILLION, "right of way": colors.GREEN}


def settings_of(kinds: Iterable[str], *, quick: bool, device: str) -> dict[str, RaceSettings]:
    """Return the settings of each run of some kinds, by the path of its directory."""
    base = RaceSettings.of(
        {
            "schedule": "against",
            "schedule.team": "pursuer",
            "learner": "actor-critic",
            "learner.device": device,
            "schedule.archive_every": WINDOW,
            **WORLD,
        }
    )
    return {
        directory(kind, seed): base.changed(
            {**KINDS[kind][0], **(SMALL if quick else {}), "seed": seed}
        )
        for kind in kinds
        for seed in range(min(KINDS[kind][1], 2) if quick else KINDS[kind][1])
    }


def directory(kind: str, seed: int) -> str:
    """Return the path of a run."""
    return f"{kind.replace(' ', '-')}/{seed}"


def of_run(run: SavedRun) -> Numbers:
    """Return the numbers of a run.

    Returns
    -------
    dict of str to ndarray
        Over epochs of training ``captured`` (in the last step) and ``fault`` (agent-steps of the
        pursuers at fault in an episode); over archived generations ``reward`` (of a pursuer in an
        episode) and ``test captured``, and ``test fault`` (generations, kinds of collision); of the
        last generation in new episodes ``last captured``, ``last length`` and, in all of them,
        ``last fault`` (kinds) and ``last agent-steps``.
    """
    log, own, world = run.log(), run.teams["pursuer"], run.settings.world

    def play(generations: Any, episodes: int, seed: int) -> mw.EpisodeStatistics:
        matches = mw.Matches.of(generations, 0, seed)
        return mw.rollout(world, own, run.settings.schedule.opponent, matches, episodes=episodes)

    last = len(own.genomes) - 1
    curve = play(np.arange(last + 1), CURVE_EPISODES, FIRST_TEST_SEED)
    final = play(last, LAST_EPISODES, FIRST_TEST_SEED + 1)
    return {
        "captured": log["capture_rate"],
        "fault": log["pursuer_faults"],
        "reward": curve.pursuer_return.mean(axis=1) / world.n_pursuers,
        "test captured": curve.capture_rate.mean(axis=1),
        "test fault": curve.faults[:, :, 0].mean(axis=1),
        "last captured": final.capture_rate.mean(),
        "last length": final.length.mean(),
        "last fault": final.faults[:, :, 0].sum(axis=(0, 1)),
        "last agent-steps": final.agent_steps[:, :, 0].sum(),
    }


def measured(runs: Mapping[str, SavedRun]) -> Numbers:
    """Return the numbers of all runs."""
    numbers: Numbers = {}
    for kind in KINDS:
        each = [
            of_run(run) for name, run in runs.items() if name == directory(kind, run.settings.seed)
        ]
        if not each:
            continue
        numbers |= {f"{kind} / {key}": np.stack([one[key] for one in each]) for key in each[0]}
    return numbers


def kinds_of(numbers: Mapping[str, Any]) -> list[str]:
    """Return the kinds that have been measured."""
    return [kind for kind in KINDS if f"{kind} / captured" in numbers]


def published_log() -> dict[str, NDArray[np.float64]]:
    """Return the columns of the authors' log: `epoch`, `reward`, `captured` and the collisions."""
    names = LOG.read_text(encoding="utf-8").splitlines()[0].split(",")
    return dict(zip(names, np.loadtxt(LOG, delimiter=",", skiprows=1).T, strict=True))


def windows(values: NDArray[Any], length: int = WINDOW) -> NDArray[np.float64]:
    """Return the means of windows of so many numbers along the last axis, without a rest."""
    whole = values.shape[-1] // length * length
    parts = values[..., :whole].reshape(*values.shape[:-1], -1, length)
    return np.asarray(parts.mean(axis=-1, dtype=np.float64))


def tables(numbers: Numbers) -> str:
    """Return the ends of all runs, and the course of the published training, in Markdown."""
    missing = [kind for kind in KINDS if kind not in kinds_of(numbers)]
    told = [f"Not measured: {', '.join(missing)} (`--kinds`)."] if missing else []
    return "\n\n".join([ends(numbers), course(numbers), *told])


def ends(numbers: Numbers) -> str:
    """Return how the runs ended, in Markdown."""
    lines = [
        f"Ends of the runs, {LAST_EPISODES} new episodes each: evaders captured in the last step, "
        "steps, and collisions\nof the pursuers (agent-steps at fault in an episode); in training, "
        "all of them. Mean over seeds [95% interval].\n",
        f"| training | seeds | captured | steps | {' | '.join(COLLISION_KINDS)} "
        "| agent-steps | collisions in training |",
        "|---" * 9 + "|",
    ]
    for kind in kinds_of(numbers):
        captured, length, faults, steps = (
            numbers[f"{kind} / last {key}"]
            for key in ("captured", "length", "fault", "agent-steps")
        )
        matches = KINDS[kind][0].get("learner.population", 1)
        cells = (
            kind,
            f"{len(captured)}",
            written(interval_over_runs(captured, bounds=(0.0, 1.0)), 3),
            written(interval_over_runs(length, bounds=(0.0, np.inf)), 0),
            *(f"{each:.1f}" for each in faults.mean(axis=0) / LAST_EPISODES),
            f"{steps.sum() / 1e6:.1f} million",
            f"{matches * numbers[f'{kind} / fault'].sum(axis=1).mean():,.0f}",
        )
        lines.append(f"| {' | '.join(cells)} |")
    return "\n".join(lines)


def course(numbers: Numbers) -> str:
    """Return the published training beside its log, by windows of epochs, in Markdown."""
    log = published_log()
    theirs = windows(
        np.stack([log["reward"], log["captured"], sum(log[kind] for kind in COLLISION_KINDS)]),
        WINDOW // 10,
    )
    columns = [*theirs[[1, 2, 0]]]
    if "published" in kinds_of(numbers):
        captured, faults = (windows(numbers[f"published / {key}"]) for key in ("captured", "fault"))
        rewards = numbers["published / reward"][:, 1:]  # the first generation is untrained
        for of_seed in zip(captured, faults, rewards, strict=True):
            columns += of_seed
    heads = ["epochs", "log: captured", "collisions", "reward"]
    for seed in range(len(columns) // 3 - 1):
        heads += [f"seed {seed}: captured", "collisions", "reward"]
    lines = [
        f"The published training by windows of {WINDOW} epochs: means of an episode (the log: "
        f"every tenth epoch); rewards of a pursuer,\nours in {CURVE_EPISODES} test episodes at the "
        "end of the window.\n",
        f"| {' | '.join(heads)} |",
        "|---" * len(heads) + "|",
    ]
    for w in range(theirs.shape[1]):
        if w >= 10 and w % 5 != 4:  # later windows change slowly
            continue
        cells = [
            f"{column[w]:.{0 if k % 3 else 2}f}" if w < len(column) else ""
            for k, column in enumerate(columns)
        ]
        lines.append(f"| {w * WINDOW} to {(w + 1) * WINDOW - 1} | {' | '.join(cells)} |")
    return "\n".join(lines)


def figure(numbers: Numbers) -> Figure:
    """Draw reward, captures and collisions over epochs of all runs and of the authors' log."""
    drawn = Figure(figsize=(13.0, 4.2), dpi=130, layout="constrained")
    log, panels = published_log(), drawn.subplots(1, 3)
    collided = sum(log[kind] for kind in COLLISION_KINDS)
    middles = windows(log["epoch"], WINDOW // 10)
    for axes, values in zip(panels, (log["captured"], collided, log["reward"]), strict=True):
        line = windows(values, WINDOW // 10)
        axes.plot(middles, line, color=colors.INK, linestyle="--", label="the authors' log")
        axes.set_xlabel("epoch")
        axes.grid(color=colors.GRID)
    for kind in kinds_of(numbers):
        color = DRAWN[kind]
        curves = {
            panels[0]: windows(numbers[f"{kind} / captured"]),
            panels[1]: windows(numbers[f"{kind} / fault"]),
        }
        if kind == "published":  # the other kinds have other rewards
            curves[panels[2]] = numbers[f"{kind} / reward"][:, 1:]
        for axes, seeds in curves.items():
            epochs = WINDOW * (0.5 + np.arange(seeds.shape[1]))
            for number, seed in enumerate(seeds):
                label = f"{kind}, {len(seeds)} seeds" if number == 0 else None
                axes.plot(epochs, seed, color=color, linewidth=1.2, label=label)
    panels[0].set(title="evaders captured in the last step", ylim=(-0.02, 1.02))
    panels[1].set(title="collisions of the pursuers in an episode")
    panels[1].set_yscale("symlog", linthresh=10.0)
    panels[1].set_ylim(-1.0, 30_000.0)
    panels[2].set(title="reward of a pursuer in an episode")
    panels[2].set_yscale("symlog", linthresh=100.0)
    panels[0].legend(loc="lower right", fontsize="small")
    return drawn


def main() -> None:
    """Play missing runs; print and write the tables, and draw the figure."""
    parser = script_parser(__doc__, quick="a small world and two seeds")
    names = {kind.replace(" ", "-"): kind for kind in KINDS}
    parser.add_argument("--kinds", nargs="+", choices=names, default=[*names], help="default: all")
    parser.add_argument("--device", default="cpu", help="device of PyTorch, such as cuda")
    parser.add_argument("--runs", type=Path, default=Path("runs/paper_surrounding"))
    parser.add_argument("--results", type=Path, default=Path("paper_surrounding"))
    args = parser.parse_args()
    kinds = [names[name] for name in args.kinds]
    runs = finish_all(settings_of(kinds, quick=args.quick, device=args.device), args.runs)
    file = args.results / "numbers.npz"
    kept = dict(np.load(file)) if file.exists() else {}
    numbers = {**kept, **measured(runs)}
    text = tables(numbers)
    print(text)
    args.results.mkdir(parents=True, exist_ok=True)
    (args.results / "table.md").write_text(text + "\n", encoding="utf-8")
    np.savez_compressed(file, **numbers)
    figure(numbers).savefig(args.results / "training.png")
    print(f"\nWritten: table.md, numbers.npz and training.png in {args.results}")


if __name__ == "__main__":
    main()
