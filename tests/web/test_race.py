"""The race of the page: with draws of NumPy it has the genomes of Python, and its matches."""

import base64
from collections import defaultdict
from functools import partialmethod
from pathlib import Path

import numpy as np
import pytest

from browser import data_of
from command_line import matrixworld_command, run_together
from matrixworld._util.files import read_json
from matrixworld.analysis import CONDITIONS, judge
from matrixworld.cli.options import unpacked
from matrixworld.coevolution import RaceSettings, create, evolve, open_run, seeding
from matrixworld.coevolution.evaluation.effects import PHRASES, WORDS, Effect, deed, sentence
from matrixworld.coevolution.games.tournament import tournament
from matrixworld.coevolution.learners import learner as learner_module
from matrixworld.coevolution.learners import noise as noise_module
from matrixworld.coevolution.runs.facts import Facts
from matrixworld.coevolution.runs.places import CONFIG
from matrixworld.coevolution.training import training as training_module
from matrixworld.coevolution.types import TEAMS
from matrixworld.explorer.evolve_page import evolve_data, masks_of, plain_race
from matrixworld.explorer.runs_page import explorer_page
from node import run_node
from page_races import against_scripts
from slow import quickly

SMALL = {
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
RACES = {
    "es": {"schedule": "generalist-generalist", "policy.hidden": [6], **TURNS},
    "ga": {"schedule": "generalist-specialist", "learner": "ga", "policy.hidden": [], **TURNS},
    "mask": {**SPECIALISTS, "policy.mask": "right-of-way", "policy.hidden": [5]},
    "mask without hidden layers": {"policy.mask": "right-of-way", "policy.hidden": [], **TURNS},
    "weights of named inputs": {"policy": "rating", **TURNS},
    "more opponents than epochs": {
        "policy": "rating", "schedule": "generalist-generalist",
        "schedule.pursuer_epochs": 1, "schedule.evader_epochs": 2,
    },
    "es, both at once": {**HALL, "policy.hidden": []},
    "ga, both at once": {**HALL, "learner": "ga", "policy.hidden": [4]},
    "many at once": {**HALL, "learner.population": 160, "policy.hidden": []},
}  # fmt: skip


needs_packages = pytest.mark.skipif(
    not (Path(__file__).parents[2] / "web" / "node_modules" / "fflate").exists(),
    reason="expected packages in web/node_modules (npm ci in web/), found none",
)


class Recorder(np.random.Generator):
    """A generator that keeps what it gives, by the names of its methods."""

    def __init__(self, rng, given):
        super().__init__(rng.bit_generator)
        self._given = given

    def _kept(self, name, *args, **options):
        found = getattr(np.random.Generator, name)(self, *args, **options)
        self._given[name].append(np.ravel(found).tolist())
        return found

    standard_normal = partialmethod(_kept, "standard_normal")
    integers = partialmethod(_kept, "integers")
    permutation = partialmethod(_kept, "permutation")
    choice = partialmethod(_kept, "choice")


@pytest.mark.parametrize("changes", RACES.values(), ids=RACES)
def test_with_the_draws_of_numpy_genomes_and_matches_are_those_of_python(
    changes, tmp_path, monkeypatch
):
    draws = defaultdict(lambda: defaultdict(list))

    def recorded(seed, purpose, *key):
        name = " ".join([purpose.name.lower(), *map(str, key)])
        return Recorder(seeding.keyed_generator(seed, purpose, *key), draws[name])

    for module in (training_module, learner_module, noise_module):
        monkeypatch.setattr(module, "keyed_generator", recorded)
    noise_module._table.cache_clear()  # or its numbers would not be drawn again
    settings = RaceSettings.of({**SMALL, **changes})
    run = evolve(settings, tmp_path, threads=1)
    given = {
        "settings": plain_race(settings),
        "masks": masks_of(settings.game.world),
        "draws": draws,
    }
    told = run_node("race.mjs", given)
    for team in TEAMS:
        genomes = run.archive()[team]
        np.testing.assert_allclose(told["archive"][team], genomes, rtol=1e-6, atol=1e-6)
    payoff = run.payoff()
    for cell in told["cells"]:
        place = cell["pursuer"], cell["evader"]
        assert cell["capture_rates"] == payoff.scores[place].tolist()
        assert cell["lengths"] == payoff.extras["lengths"][place].tolist()
        assert cell["means"]["faults"] == payoff.extras["faults"][place].ravel().tolist()
    log = run.log()
    for name in ("opponent", "matches", "steps"):
        assert [row[name] for row in told["rows"]] == log[name].tolist()
    np.testing.assert_allclose([row["fitness_std"] for row in told["rows"]], log["fitness_std"])


MAP = ["........", ".##.....", "........", "...#....", "...#....", ".....#..", "........"]
FORMAT = {name: evolve_data()[name] for name in ("format", "version", "game")}
"""What the page knows of the files of a run."""
SAVED = {
    "as it began": [{}],
    "in another world": [{"policy.hidden": [4]}, {"world.obstacles": MAP, "world.n_pursuers": 3}],
    "with other eyes": [{"world.fov": 7}, {"world.fov": 5, "policy.mask": "right-of-way"}],
    "without a mask": [{"policy.mask": "right-of-way", "policy.hidden": [4]}, {"world.fov": 3}],
    "weights of named inputs": [{"policy": "rating"}, {"policy": "rating", "world.fov": 7}],
    "inputs of each team": [
        {
            "policy": "rating",
            "policy.inputs": [["adversary", "escapes"], ["adversary", "room", "parity"]],
        }
    ],
    "with another schedule": [
        {"learner": "ga"},
        {**HALL, "learner": "ga", "learner.population": 8, "train_steps": 9},
    ],
}


@pytest.mark.slow
@needs_packages
@pytest.mark.parametrize("parts", SAVED.values(), ids=SAVED)
def test_a_saved_race_is_a_run_that_python_reads_and_plays_again_bit_for_bit(parts, tmp_path):
    """Also of a race whose settings changed on the way: its matches are those of the last ones."""
    turns = [{} if "schedule" in part else TURNS for part in parts]
    each = [RaceSettings.of({**SMALL, **a, **b}) for a, b in zip(turns, parts, strict=True)]
    last = each[-1]
    given = {
        "settings": plain_race(each[0]),
        "changes": {"2": plain_race(last)} if len(each) > 1 else {},
        "masks": masks_of(last.game.world),
        "format": FORMAT,
    }
    told = run_node("race.mjs", given)
    archive = tmp_path / "race.zip"
    archive.write_bytes(base64.b64decode(told["saved"]))
    run = open_run(unpacked(archive))
    assert run.finished
    assert run.settings == last
    assert read_json(create(last, tmp_path / "of python").path / CONFIG).keys() <= run.config.keys()
    assert run.facts == Facts.of(last.game, last.known)
    payoff = run.payoff()
    teams = run.teams["pursuer"], run.teams["evader"]
    again = tournament(last.game.world, *teams, seed=last.seed, episodes=3, threads=1)
    for name, found in again.arrays().items():
        np.testing.assert_array_equal(payoff.arrays()[name], found)
    assert run.record(1, 3, episode=2).length == payoff.extras["lengths"][1, 3, 2]
    for team in TEAMS:
        assert np.mean(told["scores"][team]) == pytest.approx(against_scripts(run, team))
    assert judge(payoff.scores, per_episode=True).runs == 1
    assert "pursuer" in explorer_page([run])
    log = run.log()
    assert len(log["epoch"]) == len(told["rows"])
    assert run.newest() == log["stage"].max() == last.schedule.n_stages
    assert run.summary()["training_matches"] == log["matches"][-1]
    assert evolve(last, unpacked(archive), threads=1).summary() == run.summary()  # as it is


@pytest.mark.slow
@needs_packages
def test_commands_read_a_saved_race(tmp_path):
    settings = RaceSettings.of({**SMALL, **TURNS})
    given = {
        "settings": plain_race(settings),
        "masks": masks_of(settings.game.world),
        "format": {**FORMAT, "version": "1"},
    }
    archive = tmp_path / "race.zip"
    archive.write_bytes(base64.b64decode(run_node("race.mjs", given)["saved"]))
    told = matrixworld_command("judge", archive).output
    assert "1 run, 4 generations of pursuers and 4 of evaders" in told
    assert "captured" in matrixworld_command("replay", archive, "--step", -1).output
    page = tmp_path / "page.html"
    matrixworld_command("explore", archive, "--no-open", "-o", page)
    assert data_of(page)["runs"][0]["schedule"] == "generalist-generalist"
    (tmp_path / "race" / "payoff.npz").unlink()
    told = matrixworld_command("judge", archive, code=2).output
    assert "got other files" in run_together(told)
    assert not (tmp_path / "race" / "payoff.npz").exists()  # the directory is not changed


UP = ("arms race", "one-sided progress", "rise")


def courses(kind, rng, n):
    """Return strengths of both teams by generation, and how far they turn in a circle."""
    t = np.linspace(0.0, 1.0, n)
    walks = rng.normal(0.0, 0.5, (2, n)).cumsum(axis=1)
    both = [
        (3 * t, 3 * t), (3 * t, 0 * t), (0 * t, 3 * t), (0 * t, 0 * t), tuple(walks),
        (2.0 * (t > 0.01), 3.0 * (t > 0.1)), (-2 * t, 2 * t), (0 * t, 0 * t), (6 * t + 4, 0 * t),
        (4 * np.sin(np.pi * t),) * 2,
    ][kind % 10]  # fmt: skip
    return both[0], both[1], 2.0 * (kind % 10 == 7)


@pytest.mark.slow
@quickly("count", [40, 200], (40).__eq__)
def test_the_sentence_of_a_race_never_contradicts_its_judgement(count):
    """The page says that a team became better, or weaker; in races of every verdict."""
    rng, n, races = np.random.default_rng(0), 14, []
    for kind in range(count):
        pursuers, evaders, circle = courses(kind, rng, n)
        one_sided = kind % 10 in (1, 2)  # which takes many matches to tell
        strength = rng.normal(0.0, 0.0 if one_sided else 0.15, (2, n))
        phase = 4 * np.pi * np.linspace(0, 1, n)
        ahead = (pursuers + strength[0])[:, None] - (evaders + strength[1])
        odds = ahead + circle * np.sin(phase[:, None] - phase)
        races.append(
            rng.binomial(4, 1 / (1 + np.exp(-odds[..., None])), (n, n, 40 if one_sided else 8)) / 4
        )
    told = run_node("outcome.mjs", {"races": [r.tolist() for r in races], "told": [], "data": {}})
    said, present = set(), set()
    for race, outcome in zip(races, told["outcomes"], strict=True):
        found = judge(race, per_episode=True).windows["whole"]
        present |= {name for name, each in found.items() if each.verdict == "present"}
        rose = {t for name in UP if found[name].verdict == "present" for t in found[name].teams}
        still = found["stagnation"].verdict == "present"
        one_sided = found["one-sided progress"].verdict == "present"
        none = all(found[name].verdict == "absent" for name in UP)
        won = found["disengagement"].verdict == "present"  # which hides the rest
        for team, its in outcome["teams"].items():
            said.add(verdict := its["verdict"])
            denied = still or none or (one_sided and f"{team}s" not in rose)
            assert not (verdict.startswith("better") and denied)
            assert verdict != "better" or won or f"{team}s" in rose  # or "no clear progress"
            assert verdict != "weaker" or not (still or f"{team}s" in rose)
    assert present == set(CONDITIONS)
    assert said == {"better", "better by a jump", "weaker", "cannot tell"}


def test_what_agents_do_is_told_as_by_explain():
    rng = np.random.default_rng(1)
    told = [
        (team, dict(zip(PHRASES, (rng.normal(size=len(PHRASES)) ** 3).tolist(), strict=True)))
        for team in TEAMS
        for _ in range(20)
    ]
    data = {"phrases": PHRASES, "words": WORDS}
    given = {"races": [], "told": told, "data": data}
    # Of a weighted sum, each effect goes one way.
    expected = [
        sentence(
            team, deed({name: Effect(max(x, 0.0), max(-x, 0.0)) for name, x in effects.items()})
        )
        for team, effects in told
    ]
    assert run_node("outcome.mjs", given)["sentences"] == expected
