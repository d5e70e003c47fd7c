"""Malformed values of every parameter of public constructors: ValueError or TypeError, no files.

Those of settings are in test_declared.py.
"""

import inspect
import re
from functools import partial

import numpy as np
import pytest

import matrixworld as mw
from matrixworld import analysis, coevolution, plots, solver
from matrixworld.coevolution.seeding import match_seed
from matrixworld.episodes import replay
from matrixworld.play import capture_rates
from matrixworld.world import render
from rows import random_genome, random_walks
from tiny_race import tiny_race

MALFORMED = {
    "a huge integer": 10**400,
    "an integer that Python does not write": -(10**5000),
    "below all limits": -(2**70),
    "nan": float("nan"),
    "infinity": float("inf"),
    "an unhashable list": [[]],
    "a dict": {},
    "an array of objects": np.array([None, {}], object),
    "an object": object(),
    "text with a null": "\0",
    "a NumPy bool": np.True_,
    "a set": {1},
    "a masked array": np.ma.array([0.5, 1.0], mask=[False, True]),
}
SAID = "expected|iterable|null byte|string conversion|truth value|missing|update sequence"
"""What messages say: what was expected, or in Python's words what a value cannot do."""

CONFIG = mw.WorldConfig(rows=3, cols=4, n_pursuers=2, n_evaders=1, fov=5)
NETWORK = mw.Network.for_config(CONFIG, (4,))
GENOME = random_genome(NETWORK, 0)
TEAM = mw.Population(GENOME, NETWORK)
MATCH = mw.Matches.of(0, 0, 0)
EPISODE = random_walks(steps=3)
MONITOR = mw.SafetyMonitor()
MONITOR.add_episode(EPISODE)
JUDGED = mw.judge(np.eye(8))
SMALL = {"rows": 6, "cols": 6, "n_pursuers": 2, "n_evaders": 3}

TEAMS = {"config": CONFIG, "pursuers": TEAM, "evaders": TEAM}
PICTURE = {"episode": EPISODE, "cell": 4, "trail": 2, "fov": 3}


def with_all(call):
    """Return a call in which every parameter is tried; None stands for its default."""
    return partial(call, **dict.fromkeys(inspect.signature(call).parameters))


PLAIN = CONFIG.to_json()
WORLD = mw.World(CONFIG)
MOMENT = WORLD._core.snapshot()
ACTIONS = np.zeros(CONFIG.n_agents, np.int64)
ROWS = ACTIONS[None].copy()
ENV, TURNS = mw.parallel_env(CONFIG), mw.aec_env(CONFIG).unwrapped
ENV.reset(seed=0)
TURNS.reset(seed=0)
STATES = solver.States(mw.WorldConfig(rows=2, cols=2, n_pursuers=1, n_evaders=1))


def from_json(part, /, **changes):
    plain = {part: PLAIN[part] | changes} if part else changes
    return mw.WorldConfig.from_json(PLAIN | plain)


CALLS = [
    partial(from_json, None, **PLAIN, unknown=None),
    *(partial(from_json, part, **PLAIN[part]) for part in ("rules", "rewards")),
    with_all(mw.Rules),
    with_all(mw.Rewards),
    partial(
        mw.WorldConfig, **SMALL, rules="O", fov=3, diagonal=False, max_steps=5, obstacles=0.1,
        rewards=None,
    ),
    partial(mw.World, config=CONFIG),
    partial(
        mw.World(CONFIG).reset, seed=1, episode=0, pursuers=None, evaders=None, obstacles=None
    ),
    partial(mw.World(CONFIG).step, actions=ACTIONS),
    partial(mw.Batch(2, CONFIG).reset, seed=1, episode=0, mask=None, pursuers=None),
    partial(mw.Batch(1, CONFIG).step, actions=ROWS),
    partial(mw.Batch, n_worlds=2, config=CONFIG, threads=1, autoreset=None, buffers=None),
    partial(
        mw.VectorEnv, config=CONFIG, n_worlds=2, threads=1, copy=True, action_mask=False,
        autoreset_mode="NextStep", flatten=False, state=False, render_mode=None,
    ),
    partial(mw.parallel_env, config=CONFIG),
    partial(
        mw.Network, hidden=(4,), activation="relu", fov=3, n_actions=5, sampled=True, memory="gru"
    ),
    partial(mw.Population, genomes=GENOME, policy=NETWORK),
    partial(mw.Matches.of, pursuer=0, evader=0, seed=0),
    partial(mw.rollout, **TEAMS, matches=MATCH, episodes=1, threads=1),
    partial(mw.record, **TEAMS, seed=0, pursuer=0, evader=0, episode=0),
    partial(match_seed, run_seed=0),
    partial(mw.Episode, **vars(EPISODE)),
    partial(MONITOR.summary, seed=0),
    partial(coevolution.create, settings=tiny_race(), directory="new"),
    partial(coevolution.evolve, settings=tiny_race(), out="new", threads=1),
    partial(coevolution.check_learner, learner=coevolution.CmaEs(sigma=0.1)),
    partial(coevolution.check_sampler, sampler=coevolution.opponents.Uniform(), count=1),
    partial(coevolution.available, team="pursuer", k=1),
    partial(
        coevolution.Game, play=np.dot, genes=2, teams=("cats", "mice"), initial=None, bounds=(0, 1),
        deterministic=True, show=None,
    ),
    partial(coevolution.tournament, **TEAMS, seed=0, episodes=1, threads=1),
    partial(
        coevolution.score_policy, policy=TEAM, team="pursuer", config=CONFIG, episodes=2,
        seed=0, threads=1,
    ),
    partial(replay.scene, episode=EPISODE, step=0, trail=2),
    partial(replay.save, **PICTURE, path="new.gif", fps=10.0, every=1, step=-1),
    partial(replay.animation, **PICTURE, fps=10.0, every=1),
    partial(render.rgb, scene=WORLD.scene(), cell=4, numbers=False),
    partial(render.ansi, scene=WORLD.scene(), color=True, compact=False),
    partial(EPISODE.explain, step=1),
    partial(mw.Recorder, world=WORLD),
    partial(mw.Recorder(mw.World(CONFIG)).scene, trail=2),
    partial(mw.record_actions, config=CONFIG, actions=[ACTIONS], seed=0, episode=0),
    partial(WORLD.decide, policy="random", agents=range(1), actions=ACTIONS),
    partial(mw.World.at, config=CONFIG, moment=MOMENT),
    partial(mw.Batch(1, CONFIG).decide, policies=[None], chosen=[0], agents=range(1), actions=ROWS),
    partial(ENV.reset, seed=1, options=None),
    partial(ENV.step, actions=dict.fromkeys(ENV.possible_agents, 0)),
    partial(ENV.action_space, agent="pursuer_0"),
    partial(TURNS.observe, agent="pursuer_0"),
    partial(mw.AgentEnv(CONFIG).reset, seed=1, options=None),
    partial(NETWORK.initial, rng=np.random.default_rng(0), weight=0.1, head=0.1),
    partial(NETWORK.advance, genome=GENOME, views=WORLD.views(), states=None),
    partial(mw.Network.for_config, config=CONFIG),
    partial(capture_rates, **TEAMS, seed=0, episodes=1),
    partial(mw.array_specs, config=CONFIG),
    partial(mw.read_map, source=["..", ".#"]),
    partial(MONITOR.add_episode, episode=EPISODE),
    partial(MONITOR.add_infos, infos=None),
    partial(MONITOR.add_statistics, statistics=None),
    partial(analysis.interval_over_runs, values=[0.1, 0.2], level=0.9, bounds=(0, 1)),
    partial(analysis.sentence, judgement=JUDGED),
    partial(analysis.judgement_table, judgement=JUDGED),
    partial(analysis.explain, judgement=JUDGED),
    partial(plots.payoff_heatmap, payoff=np.eye(3)),
    partial(plots.comparison, payoffs={"a": np.eye(3)}),
    partial(plots.ciao_triangles, payoff=np.eye(3), every=1),
    partial(plots.verdict_strip, judgements={}, seeds={}, missing={}),
    partial(plots.save_figure, figure=plots.payoff_heatmap(np.eye(3)), path="new.png"),
    partial(solver.States, config=STATES.config, threads=1),
    partial(STATES.cells, turn=0),
    partial(STATES.decisions, policy="still", team="pursuer"),
    partial(solver.solve, world=STATES, steps=1, payoff="capture-rate"),
    partial(solver.best_response, world=STATES, champion="still", team="pursuer", steps=1),
    partial(solver.solve(STATES).probabilities, team="pursuer", rounds=1, turn=0),
]  # fmt: skip
"""Calls with legal arguments, each of which is tried."""
ACCEPTED = {
    ("Batch", "buffers", "a dict"): "no arrays are written",
    ("MatrixWorldParallel.reset", "options", "a dict"): "no options",
    ("AgentEnv.reset", "options", "a dict"): "no options",
    ("Episode", "config", "a dict"): "no settings",
}
"""Values of the table that are legal, each with what they mean."""


def parameters():
    for call in CALLS:
        for parameter in sorted(call.keywords):
            name = call.func.__qualname__
            yield pytest.param(call, parameter, id=f"{name}({parameter})")


@pytest.mark.filterwarnings("ignore::UserWarning", "ignore::RuntimeWarning")
@pytest.mark.parametrize(("call", "parameter"), list(parameters()))
def test_a_malformed_value_is_a_value_or_type_error(call, parameter, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    name = call.func.__qualname__
    # None: as if it were not given.
    others = {key: value for key, value in call.keywords.items() if value is not None}
    for what, wrong in MALFORMED.items():
        reward = what == "below all limits" and parameter.startswith(("pursuer_", "evader_"))
        if reward or (name, parameter, what) in ACCEPTED:
            continue
        with pytest.raises((TypeError, ValueError)) as caught:
            call.func(*call.args, **{**others, parameter: wrong})
        assert re.search(SAID, str(caught.value)), (what, caught.value)
        # `create` and `save` write files if they are not refused.
        assert list(tmp_path.iterdir()) == [], what


@pytest.mark.parametrize("steps", [2**70, float("inf"), "x", None])
def test_a_moment_of_other_values_is_refused(steps):
    with pytest.raises(TypeError, match="^moment: expected that of a copied world"):
        mw.World.at(CONFIG, {**MOMENT, "steps": steps})
