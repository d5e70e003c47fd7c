"""The data of the explorer are those of the run, and so are its matches in a real browser."""

import base64
import json
import re
import shlex
import shutil
import sys
import zlib

import numpy as np
import pytest

from browser import READY
from matrixworld import Rating, WorldConfig, analysis
from matrixworld._util.files import DamagedFileError
from matrixworld._util.teams import PLURALS
from matrixworld.cli.evolve import evolve_command, job_of
from matrixworld.cli.options import given
from matrixworld.coevolution import TEAMS, RaceSettings, create, default_race, evolve, open_run
from matrixworld.coevolution.evaluation.kept_scores import kept_scores
from matrixworld.coevolution.seeding import evaluation_seed
from matrixworld.explorer import Explorer, explore
from matrixworld.explorer.page import write_page
from matrixworld.explorer.runs_page import (
    command_of,
    explorer_page,
    plain_settings,
    run_data,
    runs_data,
)  # fmt: skip
from matrixworld.explorer.teams import kept_generations, packed
from slow import quickly
from tiny_race import tiny_race

PLAYED = "document.querySelector('#match').dataset.played"
MATCHES = [(0, 2, 1, 0), (0, 0, 2, 2), (1, 1, 1, 1), (1, 2, 0, 0), (2, 0, 3, 2)]
"""Run, generations, episode."""
MATCH = """(() => {
  const match = window.matrixworldExplorer.match;
  const at = match.length * match.n_agents;
  return {
    length: match.length,
    last: Array.from(match.last_positions.subarray(2 * at)),
    captured: Array.from(match.ever_captured.subarray(match.length * match.config.n_evaders)),
    conflicts: Array.from({length: match.length}, (_, i) => match.conflicts(i + 1))
      .map((step) => step.map((conflict) => conflict.text)),
  };
})()"""
"""What a test reads of the match that is shown."""
CELL = """(() => {
  const [g, h] = arguments, canvas = document.querySelector('#matrix canvas');
  const [rows, columns] = window.matrixworldExplorer.shape;
  canvas.scrollIntoView({block: 'center', behavior: 'instant'});
  const { left, top, width, height } = canvas.getBoundingClientRect();
  return [left + (h + .5) / columns * width, top + (rows - g - .5) / rows * height];
})()"""
"""Where the cell of a pair is in the window."""


@pytest.fixture
def page(browser, job, tmp_path):
    shown = explore(*(run.path for run in job.values()), file=tmp_path / "page.html")
    browser.open(shown.path)
    browser.wait(PLAYED)
    return browser


# ---- In a real browser ---------------------------------------------------------------------------


@pytest.mark.nightly
def test_the_page_plays_the_matches_of_the_runs(page, job):
    """Clicks show the package's steps and words for conflicts, and the page confirms the cell."""
    assert page.js("document.querySelector('h1').textContent") == "3 runs of pursuers and evaders"
    seen = 0
    for number, g, h, episode in MATCHES:
        page.click(f".race:nth-child({number + 1})")
        page.drag(page.js(CELL, g, h))
        page.press(*"n" * episode)
        page.wait(f"{PLAYED} === '{number} {g} {h} {episode} '")
        played = page.js(MATCH)
        expected = [*job.values()][number].record(g, h, episode)
        assert played["length"] == expected.length
        assert played["last"] == expected.last_positions[-1].ravel().tolist()
        assert played["captured"] == expected.ever_captured[-1].astype(int).tolist()
        for step, texts in enumerate(played["conflicts"], 1):
            assert texts == [conflict.text for conflict in expected.explain(step)]
            seen += len(texts)
    assert seen > 10
    race = as_read(job["race"])["findings"]
    assert page.js("document.querySelector('.told').textContent") == ""  # of one team alone
    page.js("location.hash = '#run=0&pursuers=2&evaders=1&episode=0'")
    page.wait(f"document.querySelector('.told').textContent === {json.dumps(race['sentence'])}")
    page.wait(f"{PLAYED} === '0 2 1 0 ' && document.querySelector('.check').dataset.equal")
    payoff = job["race"].payoff()
    assert page.js("document.querySelector('.check').title") == (
        f"Played here: capture rate {payoff.scores[2, 1, 0]:.3f} in "
        f"{payoff.extras['lengths'][2, 1, 0]} steps. The cell says {payoff.matrix[2, 1]:.3f}."
    )
    # An address leads to a match and its step, also when it is loaded again; a bad one nowhere.
    page.js("location.hash = '#run=1&pursuers=2&evaders=0&episode=1&step=4'")
    page.wait(f"{PLAYED} === '1 2 0 1 ' && matrixworldExplorer.step === 4")
    page.press("\ue014")  # to the right
    assert page.js("location.hash") == "#run=1&pursuers=2&evaders=0&episode=1&step=5"
    page.reload()
    page.wait(f"{PLAYED} === '1 2 0 1 ' && matrixworldExplorer.step === 5")
    # Back leads to the match before; each pair that was chosen is a view.
    page.js("location.hash = '#run=0&pursuers=2&evaders=1&episode=0'")
    page.wait(f"{PLAYED} === '0 2 1 0 '")
    page.js("new Promise((done) => setTimeout(done, 900))")
    page.drag(page.js(CELL, 0, 0))
    page.wait(f"{PLAYED} === '0 0 0 0 '")
    page.driver.back()
    page.wait(f"{PLAYED} === '0 2 1 0 '")
    page.driver.forward()
    page.wait(f"{PLAYED} === '0 0 0 0 '")
    page.js("location.hash = '#run=1&pursuers=2&evaders=0&episode=1&step=5'")
    page.wait(f"{PLAYED} === '1 2 0 1 ' && matrixworldExplorer.step === 5")
    page.js("location.hash = '#run=7&pursuers=-1&evaders=%3Cimg%3E&seed=x'")
    page.wait("location.hash.startsWith('#run=1&pursuers=2&evaders=0')")
    assert page.errors() == []


@pytest.mark.nightly
def test_a_step_opens_in_the_playground(page, job):
    page.js("location.hash = '#run=0&pursuers=1&evaders=2&episode=0&step=3'")
    page.wait(f"{PLAYED} === '0 1 2 0 ' && matrixworldExplorer.step === 3")
    page.press("g")
    page.driver.switch_to.frame(page.driver.find_element("css selector", ".what-if iframe"))
    try:
        page.wait(READY)
        scene = page.js(
            "(({pursuers, evaders, next}) => ({cells: [...pursuers, ...evaders].map((a) => a.cell),"
            " next}))(window.playground.scene)"
        )
        episode = job["race"].record(1, 2)
        assert scene["cells"] == episode.last_positions[2].tolist()
        assert scene["next"] == episode.actions[2].tolist()
        # The networks of the match come along: they decide as in the match.
        page.js("document.querySelector('.agents-card > button').click()")
        page.js("playground.step()")
        cells = page.js("Array.from(playground.game.recording.moments.at(-1).positions)")
        assert cells == episode.last_positions[3].ravel().tolist()
        assert page.errors() == []
    finally:
        page.driver.switch_to.default_content()
    page.click(".what-if > .leave")
    assert page.js("document.querySelector('.what-if')") is None
    assert page.js("matrixworldExplorer.step") == 3


@pytest.fixture(scope="module")
def rated(tmp_path_factory):
    """Runs of policies that rate moves: weights of inputs, programs, and inputs of each team."""
    inputs = (("adversary", "escapes", "opposite"), ("adversary", "room"))
    settings = {
        "weights": tiny_race(policy="rating", hidden=(), obstacles=0.15),
        "programs": tiny_race(policy="program", learner="gp", obstacles=0.15),
        "teams": tiny_race(policy="rating", hidden=(), inputs=inputs, rows=4, cols=4, fov=7),
    }
    out = tmp_path_factory.mktemp("rated")
    return [evolve(each, out / name, threads=1) for name, each in settings.items()]


INPUTS = "window.matrixworldExplorer.inputs"
BESIDE = """(() => {
  const canvas = document.querySelector('#match canvas.board'), { rows, cols } = arguments[0];
  canvas.scrollIntoView({block: 'center', behavior: 'instant'});
  const { left, top, width, height } = canvas.getBoundingClientRect();
  const cell = Math.floor(Math.min(width / (cols + 0.24), height / (rows + 0.24)));
  const at = (size, side, n, place) => side + (size - n * cell) / 2 + (place + 0.5) * cell;
  return [at(width, left, cols, arguments[1][1]), at(height, top, rows, arguments[1][0])];
})()"""
"""Where a cell of the board is in the window."""
MOVES = [(0, 0), (-1, 0), (0, 1), (1, 0), (0, -1)]


@pytest.mark.slow
def test_the_board_draws_the_inputs_of_a_move(browser, rated, tmp_path):
    """By keys, and where the pointer is."""
    from selenium.webdriver import ActionChains

    shown = explore(*(run.path for run in rated), file=tmp_path / "page.html")
    browser.open(shown.path)
    browser.wait(PLAYED)
    world = rated[0].settings.game.world
    browser.js("location.hash = '#run=0&pursuers=2&evaders=1&episode=0&step=2'")
    browser.wait(f"{PLAYED} === '0 2 1 0 ' && matrixworldExplorer.step === 2")
    assert browser.js("document.querySelectorAll('.signs li').length") == 3
    assert browser.js(INPUTS) is None
    browser.press("a")
    match = rated[0].record(2, 1)
    row, col = match.positions[2][0].tolist()
    taken = MOVES[match.actions[2][0]]
    assert browser.js(f"{INPUTS}.to") == [row + taken[0], col + taken[1]]
    # All moves that lead into no obstacle, by the key.
    free = {
        (row + r, col + c)
        for r, c in MOVES
        if 0 <= row + r < world.rows and 0 <= col + c < world.cols
        if not match.map[row + r, col + c]
    }
    asked = "document.querySelector('.why .asked').ariaLabel"
    cells, names = set(), set()
    for _ in range(len(free)):
        browser.press("i")
        cells.add(tuple(browser.js(f"{INPUTS}.to")))
        names.add(browser.js(asked))
    assert cells == free
    assert len(names) == len(free)
    # The pointer on a cell beside it; away from the board the move that was asked about is back.
    last = browser.js(f"{INPUTS}.to")
    other = next(cell for cell in free if [*cell] != last and cell != (row, col))
    size = {"rows": world.rows, "cols": world.cols}

    def point(x, y):
        mouse = ActionChains(browser.driver, duration=20)
        mouse.w3c_actions.pointer_action.move_to_location(round(x), round(y))
        mouse.perform()

    point(*browser.js(BESIDE, size, other))
    browser.wait(f"String({INPUTS}.to) === '{other[0]},{other[1]}'")
    point(2, 2)
    browser.wait(f"String({INPUTS}.to) === '{last[0]},{last[1]}'")
    browser.press("\ue00c")  # Esc
    assert browser.js(INPUTS) is None
    # Nobody is chosen: the pointer on an agent tells of the move that it takes.
    point(*browser.js(BESIDE, size, (row, col)))
    browser.wait(f"{INPUTS} !== null")
    # Each team has its own inputs, and pursuers have an evader in view.
    browser.js("location.hash = '#run=2&pursuers=2&evaders=1&episode=0&step=0'")
    browser.wait(f"{PLAYED} === '2 2 1 0 ' && matrixworldExplorer.step === 0")
    assert browser.js("document.querySelectorAll('.signs li').length") == 4
    counts = "(({ escape, held, sides, exits }) => [[...escape, ...held].length, !sides, exits])"
    browser.press("a")
    cells, alone, exits = browser.js(f"{counts}({INPUTS})")
    assert 3 <= cells <= 5  # on a grid without obstacles
    assert not alone
    assert exits == []
    browser.press(*"aa")  # an evader
    assert browser.js(f"{counts}({INPUTS})") == [0, True, []]
    assert browser.violations() == browser.errors() == []


@quickly("damage", ["missing", "cut", "no base64", "a NaN"], lambda damage: damage == "cut")
@pytest.mark.slow
def test_damaged_genomes_are_told_where_the_match_would_be(browser, job, tmp_path, damage):
    start, genomes, end = re.split(
        r'(?<=id="genomes-0-evader">)([^<]+)', explorer_page([job["race"]]), maxsplit=1
    )
    nan = packed(np.full_like(job["race"].teams["evader"].genomes, np.nan))
    damaged = {
        "missing": "",
        "cut": genomes[:-40],
        "no base64": f"!{genomes[1:]}",
        "a NaN": base64.b64encode(nan).decode(),
    }
    write_page(tmp_path / "page.html", start + damaged[damage] + end)
    browser.open(tmp_path / "page.html")
    problem = browser.js("document.querySelector('#match .problem').textContent")
    assert problem.startswith("The page is damaged: it does not hold the ")
    assert browser.errors() == []


# ---- The data of a page -----------------------------------------------------------------------


@pytest.fixture(scope="module")
def race(job):
    return job["turns"]


def as_read(run):
    """Return the data of a run as the page reads them."""
    return json.loads(json.dumps(run_data("a run", run), allow_nan=False))


def test_results_seeds_and_world_are_those_of_the_evaluation(race):
    data, payoff, settings = as_read(race), race.payoff(), race.settings
    assert data["payoff"]["first"] == [0, 0]
    assert data["payoff"]["capture_rate"] == payoff.matrix.tolist()
    rates = np.array(data["payoff"]["capture_rates"], np.float32)
    np.testing.assert_array_equal(rates, payoff.scores)
    np.testing.assert_array_equal(data["payoff"]["lengths"], payoff.extras["lengths"])
    assert [[int(seed) for seed in row] for row in data["seeds"]] == [
        [evaluation_seed(settings.seed, g, h) for h in range(3)] for g in range(3)
    ]
    assert WorldConfig.from_json(data["world"]).to_json() == settings.game.world.to_json()
    shown = {each["name"]: each["value"] for each in data["settings"]}
    assert shown["world.rows"] == "6"
    assert shown["learner"] == "es"  # which was chosen, and is the usual one
    # The sigma follows from what was chosen; schedule and seed are told elsewhere.
    assert not {"learner.sigma", "schedule", "seed"} & shown.keys()


def test_the_command_of_the_settings_plays_the_same_race(job):
    """Also of a team alone, with values that a shell would split, and of other kinds."""
    every = {run.settings: as_read(run)["command"] for run in job.values()}
    for start, changes in (
        (default_race("against"), {"learner": "ga", "learner.population": 12}),
        (default_race("hall-of-fame"), {"policy": "cells", "policy.mask": "obstacles"}),
        ({}, {"learner": "actor-critic", "policy.hidden": 32, "train_steps": 200}),
    ):
        changed = RaceSettings.of(start, changes)
        every[changed] = command_of(changed)
    whole = RaceSettings.of(world=WorldConfig("TO", rows=9, cols=9, n_pursuers=2, n_evaders=2))
    of_values = whole.to_json()
    del of_values["chosen"]  # as of a race that a page has saved
    for settings in (whole, RaceSettings.from_json(of_values)):
        every[settings] = command_of(settings)
        assert "world.rules=TO" in every[settings]
    for expected, typed in every.items():
        program, command, *options = shlex.split(typed)
        assert (program, command) == ("matrixworld", "evolve")
        with evolve_command.make_context("evolve", options) as context:
            [settings] = job_of(given(context.params)).values()
        assert settings == expected
    usual = RaceSettings.of(default_race("hall-of-fame"), seed=3)
    assert plain_settings(usual) == []
    assert command_of(usual) == "matrixworld evolve --schedule hall-of-fame --seed 3"


def test_verdicts_are_those_of_the_commands(race):
    found, rates = as_read(race)["findings"], race.payoff().scores
    judgement = analysis.judge(rates, per_episode=True)
    assert found["sentence"] == analysis.sentence(judgement)
    assert [tuple(row) for row in found["table"]] == analysis.judgement_table(judgement)
    assert found["reasons"] == analysis.explain(judgement).splitlines()
    ratings = analysis.elo_over_episodes(rates).pursuers
    assert found["ratings"]["pursuers"]["high"] == ratings.high.tolist()


def test_genomes_are_exact(race):
    runs, blobs = runs_data([("a", race), ("b", race)])
    for team in TEAMS:
        for number, run in enumerate(runs):
            assert run["teams"][team]["kept"] == [0, 1, 2]
            assert run["teams"][team]["genomes"] == f"genomes-{number}-{team}"
            genomes = race.teams[team].genomes
            planes = zlib.decompress(blobs[f"genomes-{number}-{team}"])
            places = np.frombuffer(planes, np.uint8).reshape(4, -1).T
            joined = np.ascontiguousarray(places).view("<u4").reshape(genomes.shape)
            bits = np.bitwise_xor.accumulate(joined, axis=0)
            np.testing.assert_array_equal(bits, genomes.view("<u4"))
    # With room for two of the three generations of both teams:
    [few], _ = runs_data([("a", race)], most=4 * race.teams["pursuer"].genomes[0].nbytes)
    assert [few["teams"][team]["kept"] for team in TEAMS] == [[0, 2], [0, 2]]
    assert kept_generations(6, 2) == [0, 2, 4, 5]  # the last one, too


def test_programs_are_there_as_expressions(rated):
    (weights, programs, teams), _ = runs_data([(run.path.name, run) for run in rated])
    team = rated[1].teams["evader"]
    assert programs["teams"]["evader"]["expressions"] == [
        team.policy.expression(genome) for genome in team.genomes
    ]
    weights_of_programs = [team.policy.weights(genome) for genome in team.genomes]
    assert programs["teams"]["evader"]["weights"] == weights_of_programs
    shape = weights["teams"]["pursuer"]["policy"]
    found = [shape[name] for name in ("kind", "inputs", "genome_size")]
    assert found == ["rating", [*Rating.inputs], len(Rating.inputs)]
    inputs = [teams["teams"][team]["policy"]["inputs"] for team in TEAMS]
    assert inputs == [["adversary", "escapes", "opposite"], ["adversary", "room"]]


def test_what_evolved_is_told_once_scores_are_kept(rated, tmp_path):
    """Of the generation and in the words of the kept scores; the page plays none of these."""
    runs = [open_run(shutil.copytree(run.path, tmp_path / run.path.name)) for run in rated]
    named = [(run.path.name, run) for run in runs]
    plain, _ = runs_data(named)
    assert not any("evolved" in one["teams"][team] for one in plain for team in TEAMS)
    kept = kept_scores(runs, threads=1)
    plain, _ = runs_data(named)
    for one, scores in zip(plain, kept, strict=True):
        for team in TEAMS:
            evolved = scores[PLURALS[team]]["evolved"]
            assert evolved["generation"] == scores[PLURALS[team]]["best generation"][0]
            told = {name: evolved[name] for name in ("generation", "sentence")}
            assert one["teams"][team]["evolved"] == told


def test_a_single_team_has_one_cell_at_its_last_generation(job):
    data, payoff = as_read(job["single"]), job["single"].payoff()
    assert (data["payoff"]["shape"], data["payoff"]["first"]) == ([1, 4], [0, 3])
    assert data["payoff"]["capture_rate"] == payoff.matrix.tolist()
    assert data["findings"] is None
    [run], _ = runs_data([("alone", job["single"])])
    assert [run["teams"][team]["script"] for team in TEAMS] == ["chaser", None]


def test_a_notebook_writes_and_shows_the_page(job):
    run = job["race"].path
    page = explore(run)
    assert page.path == run.absolute() / "explorer.html"
    bundle = page._repr_mimebundle_()
    assert bundle.keys() == {"text/html", "image/png"}
    assert "<iframe srcdoc=" in bundle["text/html"]
    assert Explorer(page.path)._repr_mimebundle_().keys() == {"text/html"}
    before = page.path.read_bytes()
    with pytest.raises(FileExistsError, match="force=True replaces it"):
        explore(run)
    assert page.path.read_bytes() == before
    explore(run, force=True)
    for runs in ([], [run] * 13):
        with pytest.raises(ValueError, match=f"expected 1 to 12 finished runs, got {len(runs)}"):
            explore(*runs)


def test_an_unfinished_or_damaged_run_leaves_no_page(job, tmp_path):
    create(tiny_race(), tmp_path / "unfinished")
    shutil.copytree(job["turns"].path, tmp_path / "damaged")
    genomes = tmp_path / "damaged" / "stage-0001.npz"
    genomes.write_bytes(genomes.read_bytes()[:-80])
    for name, error in (("unfinished", FileNotFoundError), ("damaged", DamagedFileError)):
        with pytest.raises(error):
            explore(tmp_path / name)
        assert not (tmp_path / name / "explorer.html").exists()


def test_reading_a_run_imports_no_code_of_its_learner(tmp_path, monkeypatch):
    settings = tiny_race(learner="own_code:HillClimber", **{"learner.settings": {"sigma": 0.2}})
    evolve(settings, tmp_path / "run", threads=1)
    monkeypatch.delitem(sys.modules, "own_code")
    explore(tmp_path / "run")
    assert "own_code" not in sys.modules
