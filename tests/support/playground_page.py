"""The playground in a browser: scenes are loaded by the address and played by its controls."""

from __future__ import annotations

import time
from collections.abc import Sequence
from pathlib import Path
from typing import Any
from urllib.parse import quote, unquote

import numpy as np

import matrixworld as mw
from browser import Browser
from matrixworld.explorer import Playground

SHOW = """
const done = arguments[1], loaded = () => setTimeout(() => done(true));
history.replaceState(null, "", "#");  // or an address that does not change would load nothing
addEventListener("hashchange", loaded, { once: true });
location.hash = arguments[0];
"""
"""Show a scene, as a click on a link to it does."""

PLAY = """
const [commands, places] = arguments;
document.querySelectorAll(".agents select").forEach((choice, agent) => {
  if (choice.disabled || commands === null) return;
  choice.value = String(commands[agent]);
  choice.dispatchEvent(new Event("change"));
});
document.getElementById("step").click();
const kinds = ["obstacle", "teammate", "adversary"].map((kind) => `.line-${kind} .line-text`);
return places.map((place) => {
  const game = playground.games[place], part = document.querySelectorAll(".story-part")[place];
  const moment = game.recording.moments.at(-1), outcome = game.outcomes.at(-1);
  const read = (selector) => [...part.querySelectorAll(selector)].map((each) => each.textContent);
  return {
    positions: [...moment.positions], alive: [...moment.alive].map(Boolean),
    captured: [...moment.captured].map(Boolean), ever: [...moment.everCaptured].map(Boolean),
    captors: [...outcome.captors], rewards: [...outcome.rewards],
    ended: outcome.terminated, truncated: outcome.truncated,
    sentences: read(kinds.join(", ")), blame: read(".line-blame"),
  };
});
"""
"""Choose what agents do next in their table, press Step, and return what the page then shows."""


class PlaygroundPage:
    """The page in a browser."""

    def __init__(self, browser: Browser, file: Path) -> None:
        self.browser = browser
        Playground().save(file)
        browser.open(file)

    def load(self, scene: str) -> None:
        """Show a scene as a click on a link to it does."""
        self.browser.driver.execute_async_script(SHOW, f"#{quote(scene, safe='=&._,x+-')}")

    def play(self, commands: Sequence[int | str] | None = None, boards: int = 1) -> list[Any]:
        """Play a step and return what each board and its words then show."""
        return self.browser.driver.execute_script(PLAY, commands, list(range(boards)))

    def press(self, name: str) -> None:
        """Press the button of this name."""
        self.browser.js(
            "[...document.querySelectorAll('button')]"
            ".find((each) => each.textContent === arguments[0]).click()",
            name,
        )

    def message(self) -> str:
        """Return what the page tells its reader."""
        return self.browser.js("document.querySelector('.message').textContent")

    def scene(self) -> str:
        """Return the scene in the address, which follows the page after 0.1 s."""
        time.sleep(0.25)
        return unquote(self.browser.js("location.hash.slice(1)"))


def state_of(world: mw.World) -> dict[str, Any]:
    """Return the same of a world whose last step kept its conflicts."""
    conflicts = world.conflicts
    return {
        "positions": world.last_positions.ravel().tolist(),
        "alive": world.alive.tolist(),
        "captured": world.captured.tolist(),
        "ever": world.ever_captured.tolist(),
        "captors": world.captors.tolist(),
        "rewards": world.rewards.tolist(),
        "ended": world.terminated,
        "truncated": world.truncated,
        "sentences": [f"{conflict}." for conflict in conflicts],
        "blame": [blame(world, conflict) for conflict in conflicts],
    }


def blame(world: mw.World, conflict: mw.Conflict) -> str:
    """Return the sentence about the agents at fault."""
    names = [world.config.agent_name(agent) for agent in conflict.at_fault]
    return f"At fault: {' and '.join(names)}." if names else "Nobody is at fault."


def decided(world: mw.World, commands: list[int | str]) -> np.ndarray:
    """Return the actions that commands lead to, as scripts decide at this moment."""
    actions = np.array([0 if isinstance(each, str) else each for each in commands])
    first = world.config.n_pursuers
    for agent, command in enumerate(commands):
        if isinstance(command, str):
            team = range(first) if agent < first else range(first, len(commands))
            chosen = actions.copy()
            world.decide(command, team, chosen)
            actions[agent] = chosen[agent]
    return actions
