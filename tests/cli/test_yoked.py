"""``matrixworld evolve --yoked``: whom each seed replays, how it is shown, what is refused."""

import re
from pathlib import Path

import pytest

from command_line import evolved, matrixworld_command, run_together
from matrixworld.cli.evolve import _default_directory, _new_job
from matrixworld.coevolution import evolve, finish, open_runs
from tiny_race import hall_of_fame, tiny_race

NAME = "yoked-generalist-generalist"


@pytest.fixture(scope="module")
def real(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A job of three seeds, and a hall of fame beside it."""
    root = tmp_path_factory.mktemp("jobs")
    evolve([tiny_race(seed=seed) for seed in (1, 4, 9)], root / "real")
    finish(hall_of_fame(), root / "hall")
    return root / "real"


@pytest.mark.usefixtures("undrawn")
def test_each_seed_replays_the_race_of_the_next_one(real: Path) -> None:
    said = evolved("--out", "out", "--yoked", real, "--seeds", "1,9,2").stdout
    races = {run.settings.seed: run.settings.schedule.race for run in open_runs("out")}
    replayed = {seed: Path(race).name for seed, race in races.items()}
    assert replayed == {1: "seed-4", 2: "seed-4", 9: "seed-1"}
    assert f"\n{NAME} " in said
    # Seeds are judged together, and apart from the races that they replay.
    judged = matrixworld_command("judge", "out", real).stdout
    assert f"out/{NAME}\n" in judged
    assert judged.count("3 runs, 3 pursuer and 3 evader generations") == 2


def test_all_seeds_of_a_job_are_the_default(real: Path) -> None:
    job = _new_job({"yoked": real / "generalist-generalist"})
    assert [*job] == [f"{NAME}/seed-{seed}" for seed in (1, 4, 9)]
    assert _default_directory(job) == Path(f"runs/O-{NAME}-seeds1,4,9")


@pytest.mark.parametrize(
    ("place", "options", "says"),
    [
        ("real", ["--rows", 7], "no settings beside it but seeds, .* got --rows"),
        ("real/generalist-generalist/seed-4", [], "a race of another seed than 4, got"),
        ("hall", ["--seed", 3], "expected races in turns, got .*hall"),
    ],
)
def test_what_cannot_be_replayed_is_refused(
    real: Path, place: str, options: list[object], says: str
) -> None:
    where = ["--out", "out", "--yoked", real.parent / place]
    error = evolved(*where, *options, code=2).stderr
    assert re.search(rf"--yoked: .*{says}", run_together(error)), error
    assert not Path("out").exists()
