"""The table of output arrays: its descriptions, and that arrays are written in full."""

import inspect
import re

import numpy as np
import pytest

import matrixworld as mw
from matrixworld.world.arrays import BATCH_FIELDS, WORLD_FIELDS
from rows import config_of, random_actions

SIZES = {"agents": "A", "evaders": "E", "kinds": "3", "teams": "2", "row_col": "2", "channels": "3"}
ROW = re.compile(r"^(\w+) +\((.*?)\) +(\w+) +\S", re.MULTILINE)
N_WORLDS = 3


@pytest.mark.parametrize(
    ("specs", "table"), [(mw.array_specs, WORLD_FIELDS), (mw.episode_specs, BATCH_FIELDS)]
)
def test_fields_are_described(specs, table):
    described = {name: rest for name, *rest in ROW.findall(inspect.getdoc(specs) or "")}
    assert list(described) == list(table)
    for name, (shape, dtype) in described.items():
        axes = tuple(SIZES.get(axis, axis) for axis in table[name].axes)
        assert tuple(re.findall(r"\w+", shape)) == axes
        assert dtype == table[name].dtype


@pytest.mark.parametrize("views", [np.uint8, np.float32])
def test_arrays_are_written_in_full_and_nothing_else_is(views):
    config = config_of("SB", obstacles=0.1, max_steps=3)
    specs = mw.array_specs(config) | mw.episode_specs(config)
    written = []
    for fill in (0x00, 0xEE):  # what is not written would differ
        blocks = {}
        for name, (shape, dtype) in specs.items():
            chosen = np.dtype(views if name.endswith("views") else dtype)
            size = int(np.prod((N_WORLDS, *shape))) * chosen.itemsize
            block = np.full(size + 16, fill, np.uint8)  # 8 bytes of margin on each side
            blocks[name] = block, block[8:-8].view(chosen).reshape(N_WORLDS, *shape)
        buffers = {name: array for name, (_, array) in blocks.items()}
        batch = mw.Batch(N_WORLDS, config, buffers=buffers)
        assert batch.reset(4) is batch.buffers is buffers
        for actions in random_actions(1, config.n_actions, 3, N_WORLDS, config.n_agents):
            assert batch.step(actions) is buffers
        assert buffers["ended"].all()
        for block, _ in blocks.values():
            assert (block[:8] == fill).all()
            assert (block[-8:] == fill).all()
        written.append(buffers)
    for name, array in written[0].items():
        np.testing.assert_array_equal(array, written[1][name], name)
