"""The explorer shows perfect play of small worlds, and it is that of `Solution`."""

import numpy as np
import pytest

from browser import Browser
from matrixworld import World
from matrixworld.coevolution import SavedRun, open_run, start
from matrixworld.explorer import explore
from matrixworld.solve import solve
from perfect_play import solved_moment
from tiny_race import tiny_race

# For each of the named agents, chosen by keys: both columns of probabilities, and the note.
INSPECTED = """((names) => {
  const press = (key) => document.dispatchEvent(new KeyboardEvent("keydown", { key }));
  const text = (selector) => document.querySelector(selector).textContent;
  const told = names.map((name) => {
    for (let tried = 0; tried < 9 && text(".inspector h3") !== name; tried++) press("a");
    const rows = Array.from(document.querySelectorAll(".action:not(.muted)"));
    const shares = (row) => Array.from(row.querySelectorAll(".numbers"), (e) => +e.textContent);
    return [rows.map(shares), text(".answers p")];
  });
  return told;
})(arguments[0])"""


@pytest.fixture(scope="module")
def run(tmp_path_factory: pytest.TempPathFactory) -> SavedRun:
    directory = tmp_path_factory.mktemp("small") / "race"
    world = {"rows": 4, "cols": 4, "n_pursuers": 2, "n_evaders": 1, "max_steps": 6, "fov": 7}
    start(tiny_race(rules="TO", **world), directory, threads=1).run()
    return open_run(directory)


@pytest.mark.nightly
def test_the_explorer_shows_perfect_play_and_what_was_lost(browser: Browser, run: SavedRun) -> None:
    config, solution = run.settings.world, solve(run.settings.world)
    # The match from which most can be read.
    g, h, episode = max(
        ((g, h, run.record(g, h)) for g in range(3) for h in range(3)), key=lambda m: m[2].length
    )
    browser.open(explore(run.path, force=True).path)
    browser.wait("document.querySelector('#match').dataset.played")
    browser.driver.execute_script(f"location.hash = 'run=0&pursuers={g}&evaders={h}'")
    browser.wait(f"document.querySelector('#match').dataset.played === '0 {g} {h} 0 '")
    browser.wait("document.querySelector('.losses i')")
    lost: list[str] = []
    world = World(config)
    world.reset(0, pursuers=episode.positions[0][:2], evaders=episode.positions[0][2:])
    for step, row in enumerate(episode.actions.astype(np.int64)):
        of_step = np.zeros(2)
        browser.driver.execute_script(f"location.hash = 'pursuers={g}&evaders={h}&step={step}'")
        browser.wait(f"matrixworldExplorer.step === {step}")
        while world.steps == step and not world.terminated:
            moment = solved_moment(solution, world, row)
            of_step += moment.lost
            names = [config.agent_name(agent) for agent in world.actors]
            found = browser.js(INSPECTED, names)
            for agent, (shares, told) in zip(world.actors, found, strict=True):
                shown = np.array(shares)[:, 1]
                assert shown == pytest.approx(np.array(moment.marginals[agent]), abs=0.0051)
                assert f"Value {moment.value:.2f} under" in told
            world.play_turn(row)
        for team, part in zip(("pursuers", "evaders"), of_step, strict=True):
            if part >= 0.005:
                told = f"The {team} lose {part:.2f} of the capture rate against a perfect opponent"
                lost.append(f"Step {step + 1}: {told}")
    titles = browser.js("Array.from(document.querySelectorAll('.losses i'), (each) => each.title)")
    assert titles == lost
    assert lost
    assert browser.errors() == []
