"""Draw the pictures of the README: a match before and after learning, and the explorer.

    python docs/make_pictures.py      half a minute; needs Chromium

Both show the same race, which is played for them: generalists of `matrixworld evolve`.
`.ci/release` runs this before it builds the site.
"""

from __future__ import annotations

import shutil
import subprocess
import tempfile
from pathlib import Path

import numpy as np

import matrixworld as mw
from matrixworld import coevolution
from matrixworld._util.files import replacing
from matrixworld.coevolution import RaceSettings, SavedRun, default_race
from matrixworld.episodes.episode import scene
from matrixworld.episodes.frames import write_gif
from matrixworld.explorer import explore
from matrixworld.world.render import rgb

DOCS = Path(__file__).parent
RACE = RaceSettings.of(default_race("generalist-generalist"))
SEED, STEPS, CELL = 4, 60, 20
"""Of the match; cells in pixels."""
ADDRESS = "pursuers=30&evaders=30&episode=7&step=40"
"""The match that the explorer shows."""
SIZE = (1600, 1110)
BROWSERS = ("chromium", "chromium-browser", "google-chrome")


def draw_chase(run: SavedRun, file: Path) -> None:
    """Draw the match of the first and of the last generation of both teams, four at once.

    All begin at the same places. A row has the same pursuers, a column the same evaders.
    """
    last = run.settings.schedule.generations
    names = {0: "untrained", last: "evolved"}
    matches = {
        (pursuers, evaders): mw.record(
            run.settings.game.world,
            run.policy("pursuer", pursuers),
            run.policy("evader", evaders),
            seed=SEED,
        )
        for pursuers in names
        for evaders in names
    }

    def picture(step: int) -> np.ndarray:
        found = []
        for (pursuers, evaders), match in matches.items():
            now = min(step, match.length)
            caught = int(match.counted[now].sum())
            title = f"{names[pursuers]} pursuers, {names[evaders]} evaders: {caught} caught"
            found.append(rgb(scene(match, now, title=title), cell=CELL))
        return np.vstack([np.hstack(found[:2]), np.hstack(found[2:])])

    with replacing(file) as out:
        write_gif(out, picture, range(STEPS + 1), fps=6, hold=4.0)


def draw_explorer(run: SavedRun, file: Path) -> None:
    """Take a picture of the explorer's page, by a browser without a window."""
    browser = next(filter(None, map(shutil.which, BROWSERS)), None)
    if browser is None:
        raise SystemExit(f"docs/explorer.png: expected one of {', '.join(BROWSERS)} on the path")
    page = explore(run.path, force=True).path
    options = [
        "--headless", "--no-sandbox", "--hide-scrollbars", f"--screenshot={file}",
        f"--window-size={SIZE[0]},{SIZE[1]}", "--virtual-time-budget=10000",
    ]  # fmt: skip
    subprocess.run([browser, *options, f"{page.as_uri()}#{ADDRESS}"], check=True)


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as folder:
        run = coevolution.evolve(RACE, Path(folder, "run"))
        draw_chase(run, DOCS / "chase.gif")
        draw_explorer(run, DOCS / "explorer.png")
