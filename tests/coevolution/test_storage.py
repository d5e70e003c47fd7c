"""Run directories: stages, checkpoints, readers beside a writer; damage is repaired or reported."""

import itertools
import multiprocessing
import shutil
import sys
import time
from pathlib import Path

import numpy as np
import pytest

from matrixworld import coevolution as co
from matrixworld._util import files
from matrixworld.coevolution.runs.stored_files import FORMAT
from matrixworld.coevolution.runs.writer import RunWriter
from scripts import wait_until
from tiny_race import StopAt, begun, played, results, tiny_race, tiny_single

SETTINGS = {
    "race": tiny_race(),
    "hall-of-fame": tiny_race(schedule="hall-of-fame", contemporaries=1, hall_sample=1),
    "single": tiny_single(team="evader", learner="ga"),
}


def archive(generations):
    """One genome of five genes per generation, all equal to the generation."""
    genomes = np.repeat(np.arange(generations, dtype=np.float32)[:, None], 5, axis=1)
    return {"pursuer": genomes, "evader": -genomes}  # told apart by their signs


def save(files_of_run, stage):
    """Save a stage with one generation and one row of the log."""
    values = {int: stage - 1, float: stage / 3, str: "evader"}
    rows = [{name: values[kind] for name, kind in files_of_run.columns.items()}]
    files_of_run.save(stage, archive(1 + stage), rows, {"matches": stage}, state(stage))


def state(stage):
    return {"pursuer": {"mean": np.array([stage])}, "pursuer.opponents": {"wins": np.zeros(2)}}


def new_run(path):
    path.mkdir()
    made = RunWriter(path)
    made.begin(tiny_race(seed=1), archive(1), state(0))
    return made


def cut(path):
    path.write_bytes(path.read_bytes()[:-10])


@pytest.mark.parametrize("name", ["stage-0002.npz", "checkpoint-0002.npz"])
def test_the_stage_before_is_used_if_the_newest_one_is_damaged(tmp_path, name):
    run = new_run(tmp_path / "run")
    save(run, 1)
    save(run, 2)
    cut(run.path / name)
    reopened = RunWriter(run.path)
    with pytest.warns(UserWarning, match=f"{name}: cut.*; continuing from the stage"):
        _, genomes, states = reopened.restore()
    assert states["pursuer.mean"].tolist() == [1]
    assert len(genomes["evader"]) == 2
    save(reopened, 2)  # played again, so that no warning, which is an error here, comes
    assert len(RunWriter(run.path).restore()[0]) == len(run.archive()["evader"]) == 3
    assert (run.path / f"{name}.damaged").exists()
    cut(run.path / "checkpoint-0002.npz")
    cut(run.path / "checkpoint-0001.npz")  # now neither of the two states can be read
    with pytest.raises(
        co.DamagedFileError, match=r"checkpoint-0002.npz: .*checkpoint-0001.npz: cut"
    ):
        RunWriter(run.path).restore()


def test_a_checkpoint_that_lacks_a_part_of_a_state_is_damaged(tmp_path):
    settings = tiny_race(learner="es", generations=2)
    run = played(settings, tmp_path / "run")
    newest = f"checkpoint-{settings.schedule.n_stages:04}.npz"
    arrays = files.load_arrays(run.path / newest)
    # Runs of earlier versions lack the count of `RoundRobin`, and go on.
    counted = "pursuer.opponents.met"
    of_states = [name for name in arrays if name.startswith("pursuer.") and name != counted]
    assert len(of_states) > 3
    for number, name in enumerate(of_states):
        copy = Path(shutil.copytree(run.path, tmp_path / str(number)))
        others = {other: array for other, array in arrays.items() if other != name}
        files.save_arrays(copy / newest, others)
        with pytest.raises(co.DamagedFileError, match=f"{newest}: expected an array '{name}'"):
            co.open_run(copy).extend(3)


def test_a_stage_costs_the_same_in_every_generation(tmp_path):
    """A stage writes two files of the same size, removes one, and touches no other."""
    run = new_run(tmp_path / "run")
    sizes = []
    for stage in range(1, 30):  # enough for a cost that grows to show
        before = {path: path.stat() for path in run.path.iterdir()}
        save(run, stage)
        after = {path: path.stat() for path in run.path.iterdir()}
        changed = [path for path in after if after[path] != before.get(path)]
        assert {path.name.split("-")[0] for path in changed} == {"stage", "checkpoint"}
        assert len(changed) == 2
        assert len(before.keys() - after.keys()) == (stage > 1)
        sizes.append(sum(path.stat().st_size for path in changed))
    assert max(sizes) - min(sizes) < 100  # numbers in the log have one digit or more


@pytest.fixture(scope="module", params=SETTINGS)
def life(request, tmp_path_factory):
    parent = tmp_path_factory.mktemp(request.param)
    run = begun(SETTINGS[request.param], parent / "run", threads=1)
    copies = [Path(shutil.copytree(parent / "run", parent / "0"))]
    save_stage = run.files.save

    def save_and_copy(*args):
        save_stage(*args)
        copies.append(Path(shutil.copytree(parent / "run", parent / str(len(copies)))))

    run.files.save = save_and_copy
    run.run()
    return [*copies, parent / "run"]


def seen(directory):
    """Return what readers see of a run: its genomes and its log."""
    run = co.open_run(directory)
    log = {name: column.tolist() for name, column in run.log().items()}
    return {team: each.tolist() for team, each in run.archive().items()}, log


def test_the_copies_at_the_end_hold_what_the_stages_hold(life):
    *_, before, finished = life
    assert seen(before) == seen(finished)
    for team, genomes in co.open_run(finished).archive().items():
        if len(genomes):
            assert np.array_equal(np.load(finished / f"{team}s.npy"), genomes)
        else:
            assert not (finished / f"{team}s.npy").exists()
    header, *rows = (finished / "log.csv").read_text().splitlines()
    assert header == ",".join(co.open_run(finished).columns)
    assert len(rows) == len(seen(finished)[1]["epoch"])


@pytest.mark.parametrize("count", [1, 2])
def test_a_partial_copy_is_refused_or_a_whole_moment(life, tmp_path, count):
    moments = [seen(copy) for copy in life]
    for copy in life:
        names = [path.name for path in copy.glob("*-*.npz")]
        for missing in itertools.combinations(names, min(count, len(names))):
            partial = Path(shutil.copytree(copy, tmp_path / "partial"))
            for name in missing:
                (partial / name).unlink()
            try:
                assert seen(partial) in moments
            except co.DamagedFileError as error:
                assert error.path.name in missing  # noqa: PT017, others are not refused
            shutil.rmtree(partial)


def save_all_the_time(path):
    run = new_run(path)
    for stage in itertools.count(1):
        time.sleep(0.02)  # so that the reader is faster than the run grows
        save(run, stage)


@pytest.mark.skipif(sys.platform == "win32", reason="Windows does not replace open files")
def test_a_reader_beside_a_writer_never_fails(tmp_path):
    writer = multiprocessing.get_context("spawn").Process(
        target=save_all_the_time, args=(tmp_path / "run",), daemon=True
    )
    writer.start()
    generations = 0
    try:
        wait_until((tmp_path / "run/stage-0000.npz").exists, "a run")
        while generations < 20:
            run = RunWriter(tmp_path / "run")
            found, log = run.archive(), run.log()
            assert np.array_equal(found["pursuer"], archive(len(found["pursuer"]))["pursuer"])
            assert len(found["pursuer"]) == len(found["evader"]) >= generations
            generations = len(found["pursuer"])
            assert log["epoch"].tolist() == list(range(len(log["epoch"])))
            assert len(log["epoch"]) >= generations - 1
            assert writer.is_alive()
    finally:
        writer.kill()
        writer.join()


FILES = {
    "race": (
        ".lock", "config.json", "stage-0000.npz", "stage-0003.npz", "stage-0004.npz",
        "checkpoint-0003.npz", "checkpoint-0004.npz", "payoff.npz", "summary.json",
    ),
    "stopped": (
        ".lock", "config.json", "stage-0000.npz", "stage-0001.npz", "stage-0002.npz",
        "checkpoint-0001.npz", "checkpoint-0002.npz",
    ),
}  # fmt: skip
"""Files of a finished run, and of a run that was stopped in its third stage."""
OF_EITHER = [(run, name) for run, names in FILES.items() for name in names]
PREVIOUS = ("checkpoint-0003.npz", "checkpoint-0001.npz")
"""The state before the newest one, which is needed only if the newest one is damaged."""


@pytest.fixture(scope="module")
def stopped(tmp_path_factory):
    directory = tmp_path_factory.mktemp("stopped") / "run"
    with pytest.raises(KeyboardInterrupt):
        played(tiny_race(), directory, play=StopAt(6))
    return directory


@pytest.fixture(params=FILES)
def copy(request, tmp_path):
    return Path(shutil.copytree(request.getfixturevalue(request.param), tmp_path / "run"))


@pytest.mark.filterwarnings("ignore::UserWarning")  # of damage
@pytest.mark.parametrize("damage", ["half", "deleted"])
@pytest.mark.parametrize(("copy", "name"), OF_EITHER, indirect=["copy"])
def test_damage_is_repaired_or_reported(copy, race, name, damage):
    whole = (copy / name).read_bytes()
    (copy / name).unlink()
    if damage == "half":
        (copy / name).write_bytes(whole[: len(whole) // 2])
    elif name == "config.json":
        with pytest.raises(FileNotFoundError, match="holds no run"):
            co.Run(copy)
        with pytest.raises(FileExistsError):
            co.create(tiny_race(), copy)
        return
    try:
        co.finish(copy, threads=1)
    except co.DamagedFileError as error:
        assert f"{copy / name}: " in str(error)  # noqa: PT017, it may be repaired as well
        repaired = False
    else:
        found, expected = results(copy), results(race)
        if name in PREVIOUS:
            found.pop(name, None)
            expected.pop(name, None)
        assert found == expected
        repaired = True
    # A stage can be played again if the one before it has its checkpoint.
    if name.startswith("stage"):
        assert repaired != (name in ("stage-0000.npz", "stage-0001.npz", "stage-0003.npz"))
    assert repaired or name != ".lock"


@pytest.mark.parametrize(
    ("change", "message"),
    [
        (
            lambda config: config.update(format=99, matrixworld="9.9"),
            r"which matrixworld 9.9 has written",
        ),
        (lambda config: config.pop("format"), rf"expected format {FORMAT}, got None"),
        (lambda config: config["settings"].update(speed=1), "speed: expected one of the settings"),
        (lambda config: config["settings"]["world"].update(rows="many"), "rows"),
    ],
)
def test_another_version_s_files(copy, change, message):
    before = {path: path.read_bytes() for path in copy.iterdir() if path.name != "config.json"}
    config = files.read_json(copy / "config.json")
    change(config)
    files.save_json(copy / "config.json", config)
    for read in (co.Run, co.open_run):
        with pytest.raises(co.OtherVersionError, match=rf"config\.json: .*{message}"):
            read(copy)
    assert all(path.read_bytes() == content for path, content in before.items())
