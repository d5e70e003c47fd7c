"""Two builds of matrixworld against each other: equal results, and CPU time of the same work.

    python benchmarks/compare_builds.py OTHER/python [THIS/python] [--rounds 8]

OTHER/python is the folder of another build with its compiled extension, for example of a Git
worktree. The builds take turns, each time in a new process on the same cores, and the least CPU
time of each counts, since other programs can only add to it. Results are compared before times are.
"""

from __future__ import annotations

import hashlib
import inspect
import os
import subprocess
import sys
import time
from collections.abc import Callable
from dataclasses import fields, is_dataclass
from pathlib import Path
from typing import Any

import click
import numpy as np

Play = Callable[[int], tuple[int, Any]]
"""Does some work, given its number; returns agent-steps and the result."""

HERE = Path(__file__).resolve()
STEPS = 64  # steps of worlds in one piece of work


def rollouts(
    hidden: tuple[int, ...], worlds: int, *, rounds: int = 200, obstacles: float = 0.0
) -> Callable[[int], Play]:
    """Return a case: matches of genomes against one opponent, 48 episodes a thread."""

    def prepare(threads: int) -> Play:
        import matrixworld as mw

        config = mw.WorldConfig("O", max_steps=rounds, obstacles=obstacles)
        network = mw.Network.for_config(config, hidden)
        n = max(48 // worlds, 1) if hidden[0] < 100 else 1
        rng = np.random.default_rng(0)
        genomes = rng.standard_normal((n, network.genome_size), dtype=np.float32)
        team = mw.Population(np.float32(0.1) * genomes, network)
        each = np.tile(np.arange(n), threads)

        def play(number: int) -> tuple[int, Any]:
            matches = mw.Matches.of(each, 0, number * len(each) + np.arange(len(each)))
            scores = mw.rollout(config, team, team, matches, episodes=worlds, threads=threads)
            return int(scores.agent_steps.sum()), scores

        return play

    return prepare


def views(n_worlds: int) -> Callable[[int], Play]:
    """Return a case: steps of a batch, with views."""

    def prepare(threads: int) -> Play:
        import matrixworld as mw
        from matrixworld.world.batch import Batch

        shape = (n_worlds, 38)
        buffers = {
            "views": np.zeros((*shape, 3, 11, 11), np.uint8),
            "alive": np.zeros(shape, bool),
        }
        reset = mw.Autoreset.NEXT_STEP
        batch = Batch(n_worlds, "O", threads=threads, autoreset=reset, buffers=buffers)
        return stepped(batch.step, buffers["alive"], lambda: list(buffers.values()))

    return prepare


def vector_env(n_worlds: int) -> Callable[[int], Play]:
    """Return a case: steps of a vector environment, without copies."""

    def prepare(threads: int) -> Play:
        import matrixworld as mw

        known = inspect.signature(mw.VectorEnv.__init__).parameters
        extra = {"copy": False} if "copy" in known else {}
        env = mw.VectorEnv("O", n_worlds, threads=threads, **extra)
        _, infos = env.reset(seed=1)
        last: list[Any] = []

        def step(actions: np.ndarray) -> None:
            last[:] = env.step(actions)[:4]

        return stepped(step, infos["alive"], lambda: last)

    return prepare


def stepped(step: Callable[[Any], Any], alive: np.ndarray, result: Callable[[], Any]) -> Play:
    actions = np.random.default_rng(0).integers(0, 5, (STEPS, *alive.shape))

    def play(number: int) -> tuple[int, Any]:
        agent_steps = 0
        for each in actions:
            step(each)
            agent_steps += int(np.count_nonzero(alive))
        return agent_steps, result()

    return play


CASES: dict[str, Callable[[int], Play]] = {
    "[32], 16 worlds a match": rollouts((32,), 16),
    "[32], 1 world a match": rollouts((32,), 1),
    "[64, 64]": rollouts((64, 64), 16, rounds=100),
    "[400, 300]": rollouts((400, 300), 4, rounds=40),
    "[32], obstacles 0.1, 20 rounds": rollouts((32,), 1, rounds=20, obstacles=0.1),
    "[32], obstacles 0.1, 500 rounds": rollouts((32,), 16, rounds=500, obstacles=0.1),
    "step and views, 64 worlds": views(64),
    "step and views, 1024 worlds": views(1024),
    "VectorEnv, 64 worlds": vector_env(64),
    "VectorEnv, 1024 worlds": vector_env(1024),
}


def digest_of(result: Any) -> str:
    """Return a digest of arrays, or of the arrays of a dataclass, without their names."""
    values = (
        [getattr(result, item.name) for item in fields(result)] if is_dataclass(result) else result
    )
    total = hashlib.sha256()
    for value in values:
        total.update(np.ascontiguousarray(value).tobytes())
    return total.hexdigest()[:16]


def measure(case: str, threads: int, seconds: float) -> None:
    """Print a digest of results, and nanoseconds of CPU and wall time an agent-step."""
    play = CASES[case](threads)
    digest = digest_of(play(0)[1])
    least, fastest, passed, number = np.inf, np.inf, 0.0, 1
    while passed < seconds:
        wall, cpu = time.perf_counter(), time.process_time()
        work, _ = play(number)
        cpu, wall = time.process_time() - cpu, time.perf_counter() - wall
        least, fastest = min(least, cpu / work), min(fastest, wall / work)
        passed, number = passed + cpu, number + 1
    sys.stdout.write(f"{digest} {1e9 * least} {1e9 * fastest}\n")


def run(python: Path, case: str, threads: int, seconds: float) -> tuple[str, float, float]:
    """Measure a case of one build, in a process of its own."""
    cores = sorted(os.sched_getaffinity(0))[-threads:]
    command = [sys.executable, str(HERE), "--child", case, str(threads), str(seconds)]
    done = subprocess.run(
        ["taskset", "--cpu-list", ",".join(map(str, cores)), *command],
        env=os.environ | {"PYTHONPATH": str(python)},
        capture_output=True,
        text=True,
        check=True,
    )
    digest, cpu, wall = done.stdout.split()
    return digest, float(cpu), float(wall)


@click.command()
@click.argument("builds", nargs=-1, required=True, type=click.Path(exists=True, path_type=Path))
@click.option("--rounds", default=8, show_default=True, help="processes of each build and case")
@click.option("--seconds", default=0.5, show_default=True, help="CPU time of one process")
@click.option("--threads", default=1, show_default=True, help="threads, each on its own core")
@click.option("--only", default="", help="measure cases whose names contain this text")
def main(builds: tuple[Path, ...], rounds: int, seconds: float, threads: int, only: str) -> None:
    """Print a table in Markdown: CPU and wall time an agent-step of OTHER and of this build."""
    pair = [builds[0], builds[1] if len(builds) > 1 else HERE.parents[1] / "python"]
    click.echo("| ns an agent-step | CPU, other | CPU, this | ratio | wall, other | wall, this |")
    click.echo("|---|---|---|---|---|---|")
    for case in (case for case in CASES if only in case):
        found = [[run(build, case, threads, seconds) for build in pair] for _ in range(rounds)]
        digests = {digest for each in found for digest, _, _ in each}
        if len(digests) > 1:
            raise click.ClickException(f"{case}: expected equal results, got {sorted(digests)}")
        cpu = [min(each[i][1] for each in found) for i in range(2)]
        wall = [min(each[i][2] for each in found) for i in range(2)]
        click.echo(
            f"| {case} | {cpu[0]:.1f} | {cpu[1]:.1f} | {cpu[0] / cpu[1]:.2f} "
            f"| {wall[0]:.1f} | {wall[1]:.1f} |"
        )


if __name__ == "__main__":
    if sys.argv[1:2] == ["--child"]:
        measure(sys.argv[2], int(sys.argv[3]), float(sys.argv[4]))
    else:
        main()
