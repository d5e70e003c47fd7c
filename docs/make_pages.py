"""Write the pages of the variants, the pictures, the playground, the race and the lesson.

    python docs/make_pages.py

The lesson keeps the races of the page that it replaces. New ones, of the default job, are made in
some minutes and handed over; look then whether ``lesson.toml`` still says what they show:

    matrixworld evolve --seed 0 --out runs/lesson
    python docs/make_pages.py runs/lesson
"""

from __future__ import annotations

import sys
import textwrap
from dataclasses import dataclass
from pathlib import Path

import matrixworld as mw
from matrixworld.envs import VARIANT_TEXTS
from matrixworld.episodes import replay
from matrixworld.explorer import Playground
from matrixworld.explorer.evolve_page import PAGE, evolve_page
from matrixworld.explorer.page import write_page
from matrixworld.plots import save_figure
from matrixworld.world.rules import INTERACTION_TEXTS, OUTCOME_TEXTS

DOCS = Path(__file__).parent
FOLDER = DOCS / "variants"
CELL = 30  # pixels
SIZE = {"rows": 12, "cols": 16, "obstacles": 0.06, "max_steps": 200}


@dataclass(frozen=True)
class Moment:
    """A moment, in a game between two scripts, that shows the rule of a variant.

    A game that ends before the step is drawn at its end.
    """

    text: str  # caption of the picture
    step: int
    seed: int = 0
    pursuers: str = "chaser"
    evaders: str = "fleer"
    n_pursuers: int = 8
    n_evaders: int = 8

    def episode(self, variant: str) -> mw.Episode:
        """Play the whole game."""
        sizes = {"n_pursuers": self.n_pursuers, "n_evaders": self.n_evaders}
        config = mw.WorldConfig(variant, **SIZE, **sizes)
        return mw.record(config, self.pursuers, self.evaders, seed=self.seed)


CAPTURES = {
    mw.Capture.OCCUPATION: "a pursuer reaches it",
    mw.Capture.SURROUND: "pursuers, obstacles or the border are on its four sides",
}
CLOSING = """\
All variants share their observations, actions, rewards, infos and arguments:
see [`matrixworld.envs`](../../python/matrixworld/envs/__init__.py).

Versions: v0, the first.
"""

PACK = {"n_pursuers": 14, "n_evaders": 4}
DEFAULT = Moment("Chasers against fleers, after a few steps.", 15)
"""The picture of a variant without an entry in `MOMENTS`."""

MOMENTS = {
    "D": Moment("Stars: evaders taken down by the pursuers that died with them.", 9, 36),
    "R": Moment("Hollow: evaders that were reached, with their pursuers on the cell.", 15, 32),
    "B": Moment("Rings: agents that would have entered a teammate's cell, and waited.", 38, 22),
    "O": Moment("Stars: where evaders were caught in the last steps.", 11, 30),
    "S": Moment("Hollow: evaders that pursuers and walls surround.", 15, 24, **PACK),
    "SB": Moment("A ring closes; agents that pressed on bounced off each other.", 103, 10, **PACK),
    "SD": Moment("Stars: where evaders were surrounded and removed.", 12, 10, **PACK),
    "SDB": Moment("A step after a capture: its captors stand around the cell.", 146, 20, **PACK),
    "TO": Moment("Stars: evaders caught in their pursuers' turns.", 16, 24),
}


def moment_of(variant: str) -> Moment:
    """Return the moment that the picture of a variant shows."""
    return MOMENTS.get(variant, DEFAULT)


def page(variant: str) -> str:
    """Return a page in Markdown: the picture, texts, facts and rules."""
    letter, text, config = variant.lower(), VARIANT_TEXTS[variant], mw.WorldConfig(variant)
    caption = moment_of(variant).text
    observe = f"To observe: {text['observe']}"
    parts = [
        f"# {variant}: {text['title']}",
        f"![{caption}]({letter}.png)",
        f"*{caption}*",
        *map(filled, (text["models"], text["choose"], observe)),
        table(facts(variant, config)),
        table(rule_texts(config.rules), head="rule"),
        CLOSING,
    ]
    return "\n\n".join(parts)


def filled(paragraph: str) -> str:
    """Return a paragraph in lines."""
    words = " ".join(paragraph.split())
    return textwrap.fill(words, 98, break_long_words=False, break_on_hyphens=False)


def facts(variant: str, config: mw.WorldConfig) -> dict[str, str]:
    """Return what PettingZoo's pages state first of an environment."""
    name = f"pursuit_evasion_{variant.lower()}_v0"
    teams = (("pursuer", config.n_pursuers), ("evader", config.n_evaders))
    return {
        "Make": f'`matrixworld.parallel_env("{variant}")`',
        "By its name": f'`pettingzoo.make("parallel", "matrixworld/{name}")`',
        "Actions": "Discrete",
        "Parallel API": "Yes",
        "AEC API": "Yes",
        "Number of agents": f"`{config.n_agents}`",
        "Agents": ", ".join(f"`{team}_0` ... `{team}_{n - 1}`" for team, n in teams),
        "Action Shape": "`()`",
        "Action Values": f"`Discrete({config.n_actions})`",
        "Observation Shape": f"`(3, {config.fov}, {config.fov})`",
        "Observation Values": "`0, 1`",
        "State Shape": f"`(3, {config.rows}, {config.cols})`",
        "State Values": "`0, 1`",
    }


def rule_texts(rules: mw.Rules) -> dict[str, str]:
    """Return what the rules say, as it stands in a table."""
    if rules.removes_captured:
        captured = "disappears"
    elif rules.capture is mw.Capture.SURROUND:
        captured = "stays, and is free again when the ring opens"
    else:
        captured = "stays and moves on"
    return {
        "agents move": INTERACTION_TEXTS[rules.interaction],
        "an agent that runs into an obstacle or the border": OUTCOME_TEXTS[rules.obstacle],
        "an agent that collides with a teammate": OUTCOME_TEXTS[rules.teammate],
        "an evader that collides with a pursuer": OUTCOME_TEXTS[rules.evader],
        "a pursuer that collides with an evader": OUTCOME_TEXTS[rules.pursuer],
        "an evader is captured when": CAPTURES[rules.capture],
        "a captured evader": captured,
    }


def table(rows: dict[str, str], head: str = "") -> str:
    """Return rows of two cells in Markdown."""
    first = f"| {head} | |" if head else "| | |"
    return "\n".join([first, "|---|---|", *(f"| {key} | {value} |" for key, value in rows.items())])


def draw(variant: str, path: Path) -> None:
    """Write the picture of a variant."""
    moment = moment_of(variant)
    episode = moment.episode(variant)
    replay.save(episode, path, step=min(moment.step, episode.length), cell=CELL)


def write(folder: Path) -> None:
    """Write every page and picture into a folder."""
    folder.mkdir(exist_ok=True)
    for variant in mw.VARIANTS:
        name = variant.lower()
        (folder / f"{name}.md").write_text(page(variant), encoding="utf-8")
        draw(variant, folder / f"{name}.png")


if __name__ == "__main__":
    write(FOLDER)
    Playground().save(DOCS / "playground.html", force=True)
    write_page(DOCS / PAGE, evolve_page())
    sys.path.append(str(DOCS.parent / "tutorials"))
    from interaction_figure import interaction_models  # beside this file
    from lesson_page import write_lesson

    from course import figures

    pictures = {
        "conflicts": figures.conflict_outcomes,
        "interaction": interaction_models,
        "right_of_way": figures.right_of_way,
    }
    for name, picture in pictures.items():
        save_figure(picture(), DOCS / "figures" / f"{name}.png")
    write_lesson(Path(sys.argv[1]) if len(sys.argv) > 1 else None)
