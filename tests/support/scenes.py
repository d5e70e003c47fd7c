"""Small dense worlds with the actions of a few steps, for random tests."""

import string
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from hypothesis import strategies as st

import matrixworld as mw
from drawing import ARROWS, CAPTURES, INTERACTIONS, OUTCOMES, UNITS, draw, quiet_config, rules
from reference import Cell, ReferenceWorld

MAX_SIDE, MAX_AGENTS, MAX_STEPS = 6, 10, 6
FIELDS = {
    "interaction": list(INTERACTIONS),
    "obstacle": list(OUTCOMES),
    "teammate": list(OUTCOMES),
    "adversary": [evader + pursuer for evader in OUTCOMES for pursuer in OUTCOMES],
    "capture": list(CAPTURES),
    "disappear": [False, True],
}
TOGETHER = ["simultaneous", "swarm turns"]


@dataclass(frozen=True)
class Scene:
    """A start, and the actions of all agents in each step."""

    fields: dict[str, Any]
    config: mw.WorldConfig
    pursuers: list[Cell]
    evaders: list[Cell]
    obstacles: np.ndarray
    actions: list[list[int]]

    def reference(self):
        world = ReferenceWorld(self.config)
        world.place(self.pursuers, self.evaders, self.obstacles)
        return world

    def engine(self):
        world = mw.World(self.config)
        world.reset(seed=0, pursuers=self.pursuers, evaders=self.evaders, obstacles=self.obstacles)
        return world

    def __str__(self):
        """Return the scene in the form of a hand-written case."""
        letters = [*string.ascii_uppercase[: len(self.pursuers)]]
        letters += string.ascii_lowercase[: len(self.evaders)]
        cells = dict(zip(letters, [*self.pursuers, *self.evaders], strict=True))
        arrow = {number: mark for mark, number in ARROWS.items()}
        moves = [
            " ".join(who + arrow[a] for who, a in zip(letters, step, strict=True) if a)
            for step in self.actions
        ]
        return f"rules(**{self.fields})\n{self.config}{draw(cells, self.obstacles)}\n{moves}"


def scene(fields, shape, cells, n_pursuers, n_agents, n_obstacles, actions, **changes):
    """Return a scene; the first of the shuffled cells are for agents, the next for obstacles."""
    obstacles = np.zeros(shape, bool)
    for cell in cells[n_agents : n_agents + n_obstacles]:
        obstacles[cell] = True
    config = quiet_config(
        rules=rules(**fields),
        rows=shape[0],
        cols=shape[1],
        n_pursuers=n_pursuers,
        n_evaders=n_agents - n_pursuers,
        **changes,
    )
    pursuers, evaders = list(cells[:n_pursuers]), list(cells[n_pursuers:n_agents])
    return Scene(fields, config, pursuers, evaders, obstacles, actions)


def any_rules(**limits):
    """Return a strategy for rows of rules within ``limits``."""
    return st.fixed_dictionaries(
        {name: st.sampled_from(values) for name, values in {**FIELDS, **limits}.items()}
    )


@st.composite
def scenes(pick, **limits):
    """Draw a scene on a grid of 1 x 2 to 6 x 6, with rules within ``limits``."""
    rows = pick(st.integers(1, MAX_SIDE))
    cols = pick(st.integers(2 if rows == 1 else 1, MAX_SIDE))
    cells = pick(st.permutations(list(np.ndindex(rows, cols))))
    n_agents = pick(st.integers(2, min(MAX_AGENTS, len(cells))))
    diagonal = pick(st.booleans())
    action = st.integers(0, 8 if diagonal else 4)
    step = st.lists(action, min_size=n_agents, max_size=n_agents)
    return scene(
        pick(any_rules(**limits)),
        (rows, cols),
        cells,
        pick(st.integers(1, n_agents - 1)),
        n_agents,
        # At most half of the free cells, so that there is room to move.
        pick(st.integers(0, (len(cells) - n_agents) // 2)),
        pick(st.lists(step, min_size=1, max_size=MAX_STEPS)),
        diagonal=diagonal,
        fov=pick(st.sampled_from([1, 3, 5])),
        max_steps=pick(st.sampled_from([2, 500])),  # ended by time, or by captures only
        rewards=replace(UNITS, capture_repeats=pick(st.booleans())),
    )


def random_scene(fields, rng):
    """Return a scene of given rules that is often nearly full, without Hypothesis."""
    rows, cols = (int(side) for side in rng.integers(1, 5, size=2))
    rows += rows * cols == 1  # two agents need two cells
    n_cells = rows * cols
    cells = [(int(k) // cols, int(k) % cols) for k in rng.permutation(n_cells)]
    n_agents = int(rng.integers(2, 1 + min(MAX_AGENTS, n_cells)))
    diagonal = bool(rng.integers(2))
    actions = rng.integers(0, 9 if diagonal else 5, size=(MAX_STEPS, n_agents))
    return scene(
        fields,
        (rows, cols),
        cells,
        int(rng.integers(1, n_agents)),
        n_agents,
        int(rng.integers(0, 1 + (n_cells - n_agents) // 2)),
        actions.tolist(),
        diagonal=diagonal,
        fov=3,
        rewards=replace(UNITS, capture_repeats=bool(rng.integers(2))),
    )
