"""The race of the page: with draws of NumPy it has the genomes of Python, and its matches."""

import base64
from collections import defaultdict
from functools import partialmethod
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from browser import data_of
from command_line import matrixworld_command, run_together
from matrixworld._util.files import DamagedFileError
from matrixworld.analysis import judge
from matrixworld.analysis.strength import late_forgetting
from matrixworld.cli.options import unpacked
from matrixworld.coevolution import RaceSettings, evolve, open_run, seeding
from matrixworld.coevolution import run as run_module
from matrixworld.coevolution.evaluation.tournament import tournament
from matrixworld.coevolution.learners import learner as learner_module
from matrixworld.coevolution.storage import FORMAT
from matrixworld.coevolution.types import TEAMS
from matrixworld.explorer.evolve_page import masks_of
from matrixworld.explorer.runs_page import explorer_page
from matrixworld.version import __version__
from node import run_node
from page_races import against_scripts

SMALL: dict[str, Any] = {
    "world.rows": 7,
    "world.cols": 8,
    "world.n_pursuers": 2,
    "world.n_evaders": 3,
    "world.fov": 5,
    "world.max_steps": 20,
    "train_steps": 12,
    "evaluation_episodes": 3,
    "learner.population": 6,
    "schedule.generations": 3,
    "seed": 2**40 + 3,
}
TURNS = {"schedule.pursuer_epochs": 3, "schedule.evader_epochs": 4}
SPECIALISTS = {"schedule": "specialist-specialist", **TURNS}
HALL = {"schedule": "hall-of-fame", "schedule.joint_epochs": 3}
RACES: dict[str, dict[str, Any]] = {
    "es": {"schedule": "generalist-generalist", "policy.hidden": [6], **TURNS},
    "ga": {"schedule": "generalist-specialist", "learner": "ga", "policy.hidden": [], **TURNS},
    "mask": {**SPECIALISTS, "policy.mask": "right-of-way", "policy.hidden": [5]},
    "mask without hidden layers": {"policy.mask": "right-of-way", "policy.hidden": [], **TURNS},
    "weights of named inputs": {"policy": "rating", **TURNS},
    "es, both at once": {**HALL, "policy.hidden": []},
    "ga, both at once": {**HALL, "learner": "ga", "policy.hidden": [4]},
    "many at once": {**HALL, "learner.population": 160, "policy.hidden": []},
}


needs_packages = pytest.mark.skipif(
    not (Path(__file__).parents[2] / "web" / "node_modules" / "fflate").exists(),
    reason="expected packages in web/node_modules (npm ci in web/), found none",
)


class Recorder(np.random.Generator):
    """A generator that keeps what it gives, by the names of its methods."""

    def __init__(self, rng: np.random.Generator, given: dict[str, list[Any]]) -> None:
        super().__init__(rng.bit_generator)
        self._given = given

    def _kept(self, name: str, *args: Any, **options: Any) -> Any:
        found = getattr(np.random.Generator, name)(self, *args, **options)
        self._given[name].append(np.ravel(found).tolist())
        return found

    standard_normal = partialmethod(_kept, "standard_normal")
    integers = partialmethod(_kept, "integers")
    permutation = partialmethod(_kept, "permutation")
    choice = partialmethod(_kept, "choice")


@pytest.mark.parametrize("changes", RACES.values(), ids=RACES)
def test_with_the_draws_of_numpy_genomes_and_matches_are_those_of_python(
    changes: dict[str, Any], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    draws: defaultdict[str, defaultdict[str, list[Any]]] = defaultdict(lambda: defaultdict(list))

    def recorded(seed: int, purpose: seeding.Purpose, *key: int) -> Any:
        name = " ".join([purpose.name.lower(), *map(str, key)])
        return Recorder(seeding.keyed_generator(seed, purpose, *key), draws[name])

    for module in (run_module, learner_module):
        monkeypatch.setattr(module, "keyed_generator", recorded)
    learner_module._table.cache_clear()  # or its numbers would not be drawn again
    settings = RaceSettings.of({**SMALL, **changes})
    run = evolve(settings, tmp_path, threads=1)
    given = {"settings": settings.to_json(), "masks": masks_of(settings.world), "draws": draws}
    told = run_node("race.mjs", given)
    for team in TEAMS:
        genomes = run.archive()[team]
        np.testing.assert_allclose(told["archive"][team], genomes, rtol=1e-6, atol=1e-6)
    payoff = run.payoff()
    for cell in told["cells"]:
        place = cell["pursuer"], cell["evader"]
        assert cell["capture_rates"] == payoff.scores[place].tolist()
        assert cell["lengths"] == payoff.extras["lengths"][place].tolist()
        assert (
            np.reshape(cell["means"]["faults"], (2, 3)).tolist()
            == payoff.extras["faults"][place].tolist()
        )
    log = run.log()
    for name in ("opponent", "matches", "steps"):
        assert [row[name] for row in told["rows"]] == log[name].tolist()
    np.testing.assert_allclose([row["fitness_std"] for row in told["rows"]], log["fitness_std"])


MAP = ["........", ".##.....", "........", "...#....", "...#....", ".....#..", "........"]
SAVED: dict[str, list[dict[str, Any]]] = {
    "as it began": [{}],
    "in another world": [{"policy.hidden": [4]}, {"world.obstacles": MAP, "world.n_pursuers": 3}],
    "with other eyes": [{"world.fov": 7}, {"world.fov": 5, "policy.mask": "right-of-way"}],
    "without a mask": [{"policy.mask": "right-of-way", "policy.hidden": [4]}, {"world.fov": 3}],
    "weights of named inputs": [{"policy": "rating"}, {"policy": "rating", "world.fov": 7}],
    "with another schedule": [
        {"learner": "ga"},
        {**HALL, "learner": "ga", "learner.population": 8, "train_steps": 9},
    ],
}


@pytest.mark.slow
@needs_packages
@pytest.mark.parametrize("parts", SAVED.values(), ids=SAVED)
def test_a_saved_race_is_a_run_that_python_reads_and_plays_again_bit_for_bit(
    parts: list[dict[str, Any]], tmp_path: Path
) -> None:
    """Also of a race whose settings changed on the way: its matches are those of the last ones."""
    turns = [{} if "schedule" in part else TURNS for part in parts]
    each = [RaceSettings.of({**SMALL, **a, **b}) for a, b in zip(turns, parts, strict=True)]
    last = each[-1]
    given = {
        "settings": each[0].to_json(),
        "changes": {"2": last.to_json()} if len(each) > 1 else {},
        "masks": masks_of(last.world),
        "format": {"format": FORMAT, "version": __version__},
    }
    told = run_node("race.mjs", given)
    archive = tmp_path / "race.zip"
    archive.write_bytes(base64.b64decode(told["saved"]))
    run = open_run(unpacked(archive))
    assert run.finished
    assert run.settings == last
    payoff = run.payoff()
    again = tournament(
        last.world, run.teams["pursuer"], run.teams["evader"], seed=last.seed, episodes=3, threads=1
    )
    for name, found in again.arrays().items():
        np.testing.assert_array_equal(payoff.arrays()[name], found)
    assert run.record(1, 3, episode=2).length == payoff.extras["lengths"][1, 3, 2]
    matrix = payoff.matrix
    expected = [
        [side[-1].mean(), late_forgetting(side, slice(0, len(side)))]
        for side in (matrix, 1.0 - matrix.T)
    ]
    np.testing.assert_allclose(told["measures"], expected, atol=1e-12)
    for team in TEAMS:
        assert np.mean(told["scores"][team]) == pytest.approx(against_scripts(run, team))
    assert judge(payoff.scores, per_episode=True).runs == 1
    assert "pursuer" in explorer_page([run])
    log = run.log()
    assert len(log["epoch"]) == len(told["rows"])
    assert run.newest() == log["stage"].max() == last.schedule.n_stages
    assert run.matches() == log["matches"][-1]
    with pytest.raises(DamagedFileError):  # Python does not continue it
        evolve(last, unpacked(archive), threads=1)


@pytest.mark.slow
@needs_packages
def test_commands_read_a_saved_race(tmp_path: Path) -> None:
    settings = RaceSettings.of({**SMALL, **TURNS}).to_json()
    masks = masks_of(RaceSettings.of(SMALL).world)
    given = {"settings": settings, "masks": masks, "format": {"format": FORMAT, "version": "1"}}
    archive = tmp_path / "race.zip"
    archive.write_bytes(base64.b64decode(run_node("race.mjs", given)["saved"]))
    told = matrixworld_command("judge", archive).output
    assert "1 run, 4 pursuer and 4 evader generations" in told
    assert "captured" in matrixworld_command("replay", archive, "--step", -1).output
    page = tmp_path / "page.html"
    matrixworld_command("explore", archive, "--no-open", "-o", page)
    assert data_of(page)["runs"][0]["schedule"] == "generalist-generalist"
    (tmp_path / "race" / "payoff.npz").unlink()
    told = matrixworld_command("judge", archive, code=2).output
    assert "got another payoff.npz there, or none" in run_together(told)
    assert not (tmp_path / "race" / "payoff.npz").exists()  # the directory is not changed
    (tmp_path / "race" / "config.json").write_text("{}")
    assert "config.json" in matrixworld_command("judge", archive, code=2).output
