"""The sentences that users meet first: what commands refuse, before anything is written."""

import re
import shutil
from pathlib import Path

import numpy as np
import pytest

from command_line import matrixworld_command, run_together
from matrices import circular
from matrixworld.cli.evolve import evolve_command, job_of
from matrixworld.cli.options import given
from matrixworld.coevolution import Run, create, evolve, open_run
from matrixworld.play import save_genome
from rows import archive, random_walks
from scripts import python
from tiny_race import StopAt, playing, tiny_race, tiny_single

# fmt: off
JUDGE = [
    (["empty"], 2, "expected run directories, or .csv or .npz files, got 'empty'"),
    (["bad.csv"], 2, "expected a capture rate in [0, 1], got '2'"),
    (["small.npz", "large.npz"], 2, "expected the shape of small.npz, (12, 12), got (14, 14)"),
    (["one.npz", "--all"], 2, "--all: expected at least 2 x 2 generations, got 1 x 3"),
    (["scores.npz", "--episodes", 6], 2, "expected the 5 episodes of each cell that the payoffs"),
    (["race", "--episodes", 6], 2, "--episodes: expected a FILE"),
    (["race", "copy"], 2, "runs: expected different seeds, got the same run twice: race, copy"),
    (["alone"], 2, "alone: expected a race, got a run of one team"),
    (["stopped"], 2, "expected a finished run; matrixworld evolve --resume stopped"),
    (["damaged"], 1, "payoff.npz: cut, altered or not an npz file"),
    (["bomb.zip"], 1, "bomb.zip: cut, altered or not an archive of a race (expected at most "),
    *(([file], 2, f"{file}: expected an archive of a race, got none of its files")
      for file in ("other.zip", "outside.zip")),
]
REPLAY = [
    (["nothing"], 2, "nothing: no such file or directory; expected the directory of a run"),
    (["several", "--race", "3"], 2, "several: expected --race with one of its races, 1, 2, got 3"),
    (["race", "--race", "x"], 2, "race: expected --race with one of its races, ., got x"),
    (["race", "--pursuer", "3"], 2, "a generation from 0 to 2, got 3"),
    (["race/log.csv"], 1, "cut, altered or not an npz file"),
    (["race/log.csv", "--episode", "1"], 2, "is a single episode: expected no --episode beside it"),
    (["race", "--evader", "fleer"], 2, "a generation of the run, got"),
    (["race", "--evader", "pursuer.npz"], 2, "--evader: expected a file of evaders, got one of pu"),
    (["race", "--seed", "1"], 2, "is a run: expected no --seed beside it"),
    (["O", "--pursuer", "3"], 2, "--pursuer: expected one of random, still, chaser, fleer, "),
    (["O", "--obstacles", "many"], 2, "expected a density in [0, 1) or a .map file"),
    (["O", "--numbers", "--out", "x.npz"], 2, "--out writes no picture: expected no --numbers"),
    (["O", "--step", "3", "--out", "x.gif"], 2, "--out writes no .png: expected no --step"),
    (["O", "--steps", "5", "--step", "6"], 2, "--step: expected -6 to 5, got 6"),
    (["O", "--out", "x.avi"], 2, "ends in .gif, .mp4, .png, .npz: x.avi"),
    (["walks.npz", "--explain"], 2, "expected a recording with conflicts, got none"),
]
EXPLORE = [
    ([], 2, "Missing argument 'RUN...'"),
    (["race", "--each"], 2, "--each: expected --figures beside it"),
    (["race", "--figures", "--out", "x.svg"], 2, "--out: expected no --figures beside it"),
]
ALONE = ["--schedule", "against"]
EVOLVE = [
    (["--cluster", "scheduler.json"], 1, "scheduler.json: expected a scheduler file of Dask"),
    (["--paper", "--n-pursuers", 30, "--rows", 6, "--cols", 6], 2, "--rows: expected at least "),
    (["--variant", "Q"], 2, "--variant: expected one of O, D, R, B, S, SB, SD, SDB, TO, got 'Q'"),
    (["--config", "q.toml"], 2, "--variant: expected one of O, D, R, B, S, SB, SD, SDB, TO, got "),
    (["--set", "learner.sigma"], 2, "expected PATH=VALUE, such as learner.sigma=0.1, got 'learner"),
    (["--set", "learner.sigmma=1"], 2, "; did you mean learner.sigma?"),
    (["--learner", "gaa"], 2, "learner: expected one of es, ga, cma, gp, actor-critic, breeding"),
    (["--set", "learner.mutation=0.1"], 2, "; it is a setting of learner=ga"),
    (["--set", "fitness.measure=rewards"], 2, "; did you mean learner.measure?"),
    (["--set", "evader_learner=ga"], 2, "; did you mean schedule.evader_learner?"),
    (["--set", "schedule=1,2"], 2, "--schedule: expected one of alternating, hall-of-fame, self"),
    (["--learner", "actor-critic"], 2,
     "policy: expected cells with the learner actor-critic, got rating; give --paper, too"),
    (["--config", "rating.toml", "--learner", "actor-critic"], 2,
     "the learner actor-critic, got rating; give --set policy=cells, too"),
    (["--set", "learner.sigma=nan"], 2, "learner.sigma: expected a finite number, got nan"),
    (["--set", "learner.sigma=-Infinity"], 2, "sigma: expected a finite number, got -inf"),
    (["--set", "learner.sigma=0"], 2, "learner.sigma: expected a number above 0, got 0"),
    (["--set", "seed=-1"], 2, "--seed: expected an integer of at least 0, got -1"),
    (["--seed", -1], 2, "'--seed': expected an integer of at least 0, got -1"),
    (["--seed", 2**63], 2, f"'--seed': expected an integer of at most {2**63 - 1}, got {2**63}"),
    (["--set", "world=lake"], 2, "--world: expected one of courtyard, thicket, park, got 'lake'"),
    (["--learner", "gp"], 2, "got rating; give --set policy=program, too"),
    (["--paper", "--set", "game=games:nim"], 2, "--paper: expected no --game beside it"),
    ([*ALONE, "--generations", 3], 2, "--generations: expected one of the settings te"),
    ([*ALONE, "--set", "schedule.opponent=nobody"], 2,
     "schedule.opponent: expected one of random, still, chaser, "),
    ([*ALONE, "--set", "schedule.start=nobody"], 2, "schedule.start: nobody: no such file or dire"),
    ([*ALONE, "--set", "schedule.opponent=several"], 2, "expected one run, got a directory of sev"),
    (["--seeds", "0-3", "--seed", 1], 2, "--seeds: expected it without --seed, got both"),
    (["SB"], 2, "unexpected extra argument (SB)"),
    (["--resume", "race", "--seeds", 3], 2, "--resume: expected no --out, --seeds beside it: a "),
    (["--resume", "race", "--set", "seed=1"], 2, "expected no --out, --set beside it"),
    *(([flag, "--seed", 3], 2, f"{flag}: expected no --out, --seed beside it")
      for flag in ("--page", "--variants", "--worlds", "--help-all")),
    (["--worlds", "--variants"], 2, "--variants: expected no --out, --worlds beside it"),
    *((words, 2, "expected one value of a setting, got several")
      for words in (["--rows", 5, "--set", "world.rows=7"], ["--seed", 2, "--set", "seed=1"],
                    ["--seeds", "2-3", "--set", "seed=1"], ["--set", "seed=1", "--set", "seed=1"],
                    ["--schedule", "psro", "--set", "schedule=against"])),
    (["--resume", "empty"], 2, "--resume: expected a directory that holds a run, got 'empty'"),
]
OTHERS = [
    (["evolve", "--out", "race"], 2, "expected a new or empty directory, got 'race'; matrixworld"),
    (["score", "race", "--generation", "x"], 2, "expected a generation or all, got 'x'"),
    (["score", "race", "--json", "no/a.json"], 2, "no/a.json: expected a directory in which files"),
    (["score", "race", "--json", "empty", "--force"], 2, "empty: expected a file, got a directory"),
    (["solve", "--rows", 4, "--cols", 4, "--obstacles", 0.1], 2, "expected none or a map"),
    (["solve", "--run", "race", "--rows", 4], 2, "--run: expected no --rows beside it"),
    (["solve", "--run", "race"], 2, "states: expected at most "),
    (["tournament", "race", "--cluster", "nowhere"], 2, "expected auto, an address such as tcp://"),
    (["tournament", "race", "--cluster", "auto", "--threads", 2], 2, "expected it without --clust"),
    (["tournament", "race", "--cluster", "scheduler.json"], 1, "scheduler.json: expected a sched"),
    (["playground", "--out", "bad.csv"], 2, "bad.csv: exists; give --force to replace it"),
]
# fmt: on
TABLE = [
    *((["judge", *words, "--json", "x.json"], *rest) for words, *rest in JUDGE),
    *((["replay", *words], *rest) for words, *rest in REPLAY),
    *((["explore", *words], *rest) for words, *rest in EXPLORE),
    *((["evolve", "--out", "out", *words], *rest) for words, *rest in EVOLVE),
    *OTHERS,
]


@pytest.fixture(scope="module")
def place(race, tmp_path_factory):
    """A directory with runs and files of all kinds."""
    root = tmp_path_factory.mktemp("refusals") / "here"
    for name in ("race", "copy", "damaged"):
        shutil.copytree(race, root / name)
    payoff = root / "damaged" / "payoff.npz"
    payoff.write_bytes(payoff.read_bytes()[:99])
    (root / "empty").mkdir()
    for name, settings in (
        ("several/1", tiny_race(seed=1)),
        ("several/2", tiny_race(seed=2)),
        ("stopped", tiny_race()),
    ):
        create(settings, root / name)
    evolve(tiny_single(), root / "alone", threads=1)
    with pytest.raises(KeyboardInterrupt):
        playing(Run(root / "stopped", threads=1), StopAt(2)).run()
    (root / "scheduler.json").write_text('{"address": 3}')
    (root / "q.toml").write_text('seed = 3\n[learner]\nkind = "ga"\n[world]\nrules = "Q"\n')
    (root / "rating.toml").write_text('policy = "rating"\n')
    (root / "bad.csv").write_text("0.5,2\n0.5,0.5\n")
    for name, size in (("small", 12), ("large", 14)):
        np.savez(root / f"{name}.npz", payoff=circular(size))
    np.savez(root / "one.npz", payoff=np.full((1, 3), 0.5))
    np.savez(root / "scores.npz", scores=np.full((13, 13, 5), 0.5))
    random_walks().save(root / "walks.npz")
    for name, part in (
        ("bomb", {"config.json": bytes(2**27)}),
        ("other", {"a.txt": b"x"}),
        ("outside", {"config.json": b"{}", "../a": b"x"}),
    ):
        (root / f"{name}.zip").write_bytes(archive(part))
    save_genome(root / "pursuer.npz", "pursuer", open_run(race).policy("pursuer"))
    return root


MISSING = [
    *("judge no.csv", "explore no", "replay no.npz", "score no", "tournament no"),
    *("evolve --resume no", "evolve --config no", "evolve --cluster no", "solve --run no"),
    *("replay O --pursuer no.npz", "solve --obstacles no.map"),
    "evolve --set world.obstacles=no.map",
]


@pytest.mark.parametrize("words", MISSING)
def test_a_missing_file_is_no_such_file(place, monkeypatch, words):
    monkeypatch.chdir(place)
    told = run_together(matrixworld_command(*words.split(), code=2).stderr)
    assert re.search(r"\bno(\.\w+)?(: no such file or directory|' does not exist)", told)


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="needs a device that is full")
@pytest.mark.parametrize("words", ["evolve --variants", "solve --rows 3 --cols 3"])
def test_output_that_cannot_be_written_is_an_error(words):
    with open("/dev/full", "w") as full:
        done = python("-m", "matrixworld", *words.split(), stdout=full)
    assert done.returncode == 1
    assert re.fullmatch(r"Error: (standard output: )?no space left on device\n", done.stderr)


@pytest.mark.parametrize(
    ("words", "code", "message"), TABLE, ids=[" ".join(map(str, row[0])) for row in TABLE]
)
def test_it_is_refused_in_a_sentence(place, monkeypatch, words, code, message):
    monkeypatch.chdir(place)
    before = sorted(place.rglob("*"))
    refused = matrixworld_command(*words, code=code)
    assert message in run_together(refused.stderr)
    assert refused.stdout == ""
    assert sorted(place.rglob("*")) == before


@pytest.mark.parametrize(("learner", "advice"), [
    ("actor-critic", ["--paper"]), ("gp", ["--set", "policy=program"]),
])  # fmt: skip
def test_what_a_refusal_says_to_give_too_is_enough(learner, advice):
    """In the world of the command, and in another one."""
    for world in ([], ["--world", "park"]):
        told = matrixworld_command("evolve", "--out", "out", "--learner", learner, *world, code=2)
        assert f"give {' '.join(advice)}, too" in run_together(told.stderr)
        typed = ["--schedule", "psro", "--learner", learner, *advice, *world]
        with evolve_command.make_context("evolve", typed) as context:
            [settings] = job_of(given(context.params)).values()
        assert settings.learner.kind == learner
