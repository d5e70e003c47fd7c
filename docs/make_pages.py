"""Writes the pages of the variants, and their pictures, from the modules of `matrixworld.envs`.

python docs/make_pages.py
"""

from __future__ import annotations

from dataclasses import dataclass
from importlib import import_module
from pathlib import Path

import matrixworld as mw
from matrixworld import replay

FOLDER = Path(__file__).parent / "variants"
CELL = 30  # pixels
SIZE = {"rows": 12, "cols": 16, "obstacles": 0.06, "max_steps": 200}


@dataclass(frozen=True)
class Moment:
    """A moment of a game of scripts in which the variant's own rule is to be seen."""

    text: str
    step: int
    seed: int = 0
    pursuers: str = "chaser"
    evaders: str = "fleer"
    n_pursuers: int = 8
    n_evaders: int = 8

    def episode(self, variant: str) -> mw.Episode:
        """The game up to its end."""
        sizes = {"n_pursuers": self.n_pursuers, "n_evaders": self.n_evaders}
        config = mw.WorldConfig(variant, **SIZE, **sizes)
        return mw.record(config, self.pursuers, self.evaders, seed=self.seed)


PACK = {"n_pursuers": 14, "n_evaders": 4}
MOMENTS = {
    "D": Moment("Stars: evaders taken down by the pursuers that died with them.", 9, 36),
    "R": Moment("Evaders that were reached, hollow, with their pursuers on the cell.", 15, 32),
    "B": Moment("Rings: agents that would have entered a teammate's cell, and waited.", 38, 22),
    "O": Moment("Stars: where evaders were caught in the last steps.", 15, 32),
    "S": Moment("Hollow: evaders that pursuers and walls surround.", 15, 24, **PACK),
    "SB": Moment("A ring closes; those who pressed on bounced off each other.", 103, 10, **PACK),
    "SD": Moment("Stars: where evaders were surrounded, and are gone.", 12, 10, **PACK),
    "SDB": Moment("A step after a capture: its captors stand around the cell.", 146, 20, **PACK),
    "TO": Moment("Stars: evaders caught in their pursuers' turns.", 16, 24),
}


def page(variant: str) -> str:
    """A page in Markdown: the module's docstring with the picture below its title."""
    letter = variant.lower()
    module = import_module(f"matrixworld.envs.pursuit_evasion_{letter}_v0")
    title, rest = (module.__doc__ or "").strip().split("\n", 1)
    moment = MOMENTS[variant]
    picture = f"![{moment.text}]({letter}.png)\n\n*{moment.text}*\n"
    common = "see [`matrixworld.envs`](../../python/matrixworld/envs/__init__.py)"
    return f"{title}\n\n{picture}{rest.replace('see `matrixworld.envs`', common)}\n"


def write(folder: Path) -> None:
    """Write every page and picture into a folder."""
    folder.mkdir(exist_ok=True)
    for variant, moment in MOMENTS.items():
        name = variant.lower()
        (folder / f"{name}.md").write_text(page(variant), encoding="utf-8")
        replay.save(moment.episode(variant), folder / f"{name}.png", step=moment.step, cell=CELL)


if __name__ == "__main__":
    write(FOLDER)
