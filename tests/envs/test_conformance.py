"""PettingZoo's own tests, for every variant and some other rows of rules."""

import io
import itertools
import warnings
from contextlib import redirect_stdout
from types import SimpleNamespace

import numpy as np
import pytest

import matrixworld as mw
from matrixworld.envs.single import MatrixWorldAEC
from rows import NAMES, config_of

with warnings.catch_warnings():  # with pygame installed, PettingZoo imports outdated environments
    warnings.simplefilter("ignore", DeprecationWarning)
    import pettingzoo.test as official

pytestmark = [
    # PettingZoo's tests warn of it, but it is right here: an agent that is gone, or alone in the
    # open, observes zeros.
    pytest.mark.filterwarnings("ignore:Observation numpy array is all zeros"),
    # Two named inputs have no bound.
    pytest.mark.filterwarnings("ignore:Agent's maximum observation space value is infinity"),
    # Both API tests reset with an option that no environment knows.
    pytest.mark.filterwarnings("ignore:options. expected some of .*ignored 'options'"),
]
OPPONENTS = ["chaser", "random"]
SETTINGS = [
    {"action_mask": True},
    {"pursuers": OPPONENTS, "observation": "named"},
    {"evaders": OPPONENTS, "dtype": "float32", "flatten": True},
]


@pytest.fixture(autouse=True)
def _quiet():
    with redirect_stdout(io.StringIO()):
        yield


@pytest.mark.parametrize(
    ("name", "given"),
    [
        *((name, {}) for name in NAMES),
        *itertools.product(("SDB", "TO", "swarm-D", "agents-SD"), SETTINGS),
    ],
)
def test_api_and_seeds(name, given):
    config = config_of(name, obstacles=0.1)
    official.api_test(mw.aec_env(config, **given), num_cycles=30)
    official.parallel_api_test(mw.parallel_env(config, **given), num_cycles=30)
    official.seed_test(lambda: mw.aec_env(config, **given), num_cycles=20)
    official.parallel_seed_test(lambda: mw.parallel_env(config, **given), num_cycles=20)


@pytest.mark.parametrize("name", mw.VARIANTS)
def test_max_cycles(name):
    made = {
        "env": lambda max_cycles: mw.aec_env(name, max_steps=max_cycles),
        "parallel_env": lambda max_cycles: mw.parallel_env(name, max_steps=max_cycles),
    }
    with warnings.catch_warnings():
        # It steps a parallel environment until max_cycles, whether or not agents are gone.
        warnings.simplefilter("error")
        official.max_cycles_test(SimpleNamespace(**made))


@pytest.mark.parametrize("name", NAMES)
def test_rendering(name, monkeypatch):
    monkeypatch.setattr("time.sleep", lambda seconds: None)  # which "human" does to be seen
    drawn = {"ansi": lambda text: "captured" in text, "human": lambda nothing: nothing is None}
    official.render_test(lambda **mode: mw.aec_env(config_of(name), **mode), custom_tests=drawn)


def test_each_agent_s_action_space_has_its_own_seed():
    env = MatrixWorldAEC("O")
    first, second = (env.action_space(agent) for agent in env.possible_agents[:2])
    second.seed(1)
    expected = [int(second.sample()) for _ in range(20)]
    second.seed(1)
    first.seed(2)
    assert [int(second.sample()) for _ in range(20)] == expected
    assert np.unique(expected).size > 1
