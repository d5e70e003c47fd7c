"""The built engine is that of the sources, and plays as the extension does, bit for bit."""

import hashlib
import json
import runpy
from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest

import matrixworld as mw
from matrixworld._util.readable import plain_values
from matrixworld.world.arrays import WORLD_FIELDS
from matrixworld.world.conflicts import conflict_of
from node import Commands, policy_json, run_node
from rows import NAMES, config_of, random_actions, random_genome

ROOT = Path(__file__).parents[2]


def program(file):
    return SimpleNamespace(**runpy.run_path(str(ROOT / file)))


def test_the_built_engine_is_not_older_than_its_sources():
    """If this fails, run ``python web/build_engine.py``."""
    build = program("web/build_engine.py")
    assert build.digest_of(build.BUILT) == build.digest()
    names = {path.relative_to(ROOT).as_posix() for path in build.sources()}
    assert {"cpp/game/world.cpp", "cpp/kernels/multiply_add.hpp", "web/engine/engine.cpp"} <= names


def test_the_tables_are_those_of_the_package():
    """If this fails, run ``python web/write_tables.py``."""
    tables = program("web/write_tables.py")
    assert tables.TABLES.read_text(encoding="utf-8") == tables.text()


def game(number, config, expected):
    shape = expected.STEPS, expected.N_WORLDS, config.n_agents
    network = mw.Network.for_config(config, (9, 7))
    return {
        "config": config.to_json(),
        "actions": random_actions(number, config.n_actions, *shape).tolist(),
        "team": policy_json(mw.Population(random_genome(network, 1), network)),
        "matches": [[str(seed), 2] for seed in range(6)],
    }


@pytest.mark.nightly
def test_the_built_engine_has_the_fingerprint_of_the_extension():
    expected = program("tests/contract/test_fingerprint.py")
    moments = [name for name in expected.ARRAYS if WORLD_FIELDS[name].written == "moment"]
    given = {
        "worlds": expected.N_WORLDS,
        "steps": expected.STEPS,
        "cents": expected.CENTS,
        "arrays": {
            "all": expected.ARRAYS,
            "of_moment": moments,
            "of_step": [name for name in expected.ARRAYS if name not in moments],
        },
        "scores": expected.SCORES,
        "games": [game(*numbered, expected) for numbered in enumerate(expected.configs())],
    }
    assert run_node("fingerprint.mjs", given) == expected.FILE.read_text(encoding="ascii").strip()


SEED = 2**64 - 3  # no double holds it
ARRAYS = (
    *("positions", "last_positions", "alive", "captured", "ever_captured", "actions", "rewards"),
    *("involved", "fault", "map"),
)
READ = ("positions", "alive", "rewards", "captors", "involved", "fault", "views", "capture_rate")


@pytest.fixture(scope="module")
def run_command():
    commands = Commands()
    yield commands
    commands.close()


def team(config, hidden, seed, **more):
    network = mw.Network.for_config(config, hidden, **more)
    return mw.Population(random_genome(network, seed), network)


RATING = mw.Rating(tuple(mw.INPUTS), mask="right-of-way")
PROGRAMS = [
    "min(unclaimed - 0.3 * room, teammate) - 3 * must_yield if 0.5 < adversary else ahead",
    "where(0.5 - exits, max(-teammate, pressure * 2), less(open_side, 0.4) + room * room)",
]
RATED = {
    "a weighted sum, right of way": ("SB", RATING, {"obstacles": 0.1}),
    "a sum of some inputs, turns": (
        "TO", mw.Rating(("room", "unclaimed", "ahead"), mask="none"), {"obstacles": 0.1},
    ),
    "a network": ("D", mw.Rating(hidden=(9, 6)), {"diagonal": True, "n_pursuers": 9}),
    "programs": ("O", mw.Program(), {"obstacles": 0.15}),
    "programs, right of way": ("swarm-SD", mw.Program(mask="right-of-way"), {"diagonal": True}),
}  # fmt: skip


def rated_teams(config, policy):
    """Return two teams whose policy has this shape, in the world's views and moves."""
    policy = replace(policy, fov=config.fov, n_actions=config.n_actions)
    if isinstance(policy, mw.Program):
        genomes = [policy.genome(text) for text in PROGRAMS]
    else:
        genomes = [policy.initial(np.random.default_rng(n), 1.0) for n in range(2)]
    return [mw.Population(genome, policy) for genome in genomes]


def asked(config, pursuers, evaders, seed, **more):
    return {
        "config": config.to_json(),
        "pursuers": policy_json(pursuers),
        "evaders": policy_json(evaders),
        "seed": str(seed),
        **more,
    }


MATCHES = {
    "one hidden layer": ("O", (32,), {"activation": "relu"}, {}),
    "two, tanh": ("SB", (64, 64), {"activation": "tanh"}, {"diagonal": True}),
    "no hidden layer, largest output": ("B", (), {"sampled": False}, {"obstacles": 0.1}),
    "largest output of two layers": ("R", (40, 30), {"sampled": False, "activation": "tanh"}, {}),
    "agents take turns": ("TO", (16,), {"activation": "tanh"}, {"obstacles": 0.15}),
    "teams take turns": ("swarm-SD", (7,), {}, {"n_pursuers": 9}),
    "gated memory": ("D", (32,), {"memory": "gru"}, {"n_pursuers": 9, "n_evaders": 9}),
    "memory, team by team": ("swarm-SD", (9, 4), {"memory": "gru"}, {"obstacles": 0.1}),
    "a crowd": ("O", (32,), {}, {"rows": 20, "cols": 20, "n_pursuers": 70, "n_evaders": 80}),
}


@pytest.mark.parametrize("name", [*MATCHES, *RATED])
def test_a_match_equals_the_recorded_one(run_command, name):
    """Positions, actions, rewards, captures and the texts of conflicts of every step."""
    if name in RATED:
        row, policy, changes = RATED[name]
        config = config_of(row, max_steps=60, **changes)
        pursuers, evaders = rated_teams(config, policy)
    else:
        row, hidden, more, changes = MATCHES[name]
        config = config_of(row, max_steps=60, **changes)
        pursuers, evaders = team(config, hidden, 1, **more), team(config, hidden, 2, **more)
    wanted = mw.record(config, pursuers, evaders, seed=SEED, episode=3)
    # Forwards, backwards, and twice the same.
    seek = [wanted.length, 0, wanted.length // 2, wanted.length]
    got = run_command(do="match", **asked(config, pursuers, evaders, SEED, episode=3, seek=seek))
    assert got["length"] == wanted.length
    for array in ARRAYS:
        expected = getattr(wanted, array)
        values = np.array(got[array], expected.dtype).reshape(expected.shape)
        np.testing.assert_array_equal(values, expected, err_msg=array)
    texts = [[each["text"] for each in conflicts] for conflicts in got["conflicts"]]
    steps = range(1, wanted.length + 1)
    assert texts == [[], *([str(each) for each in wanted.explain(step)] for step in steps)]
    sought = [np.array(moment).reshape(-1, 2).tolist() for moment in got["sought"]]
    assert sought == [wanted.positions[step].tolist() for step in seek]


@pytest.mark.parametrize("script", mw.SCRIPTS)
def test_every_script_plays_as_in_the_extension(run_command, script):
    config = config_of("SB", max_steps=40, obstacles=0.1, fov=7)
    wanted = mw.record(config, script, "dodger", seed=5)
    got = run_command(do="match", **asked(config, script, "dodger", 5, episode=0, seek=[]))
    assert got["positions"] == wanted.positions.ravel().tolist()


def played_in_python(config, start, actions, turns):
    world = mw.World(config)
    world.keeps_conflicts = True
    world.reset(**start)
    moments = []
    for row in [None, *actions]:
        if row is not None and turns:
            world.play_turn(row)
        elif row is not None:
            world.step(row)
        told = {name: array.ravel().tolist() for name, array in world.read(*READ).items()}
        conflicts = [] if row is None else plain_values(world.conflicts)
        over = world.terminated or world.truncated
        moments.append({**told, "conflicts": conflicts, "turn": world.turn, "over": over})
        if over and not world.turn:
            break
    return moments


@pytest.mark.parametrize("row", NAMES)
def test_a_world_plays_as_in_the_extension(run_command, row):
    """All arrays and conflicts, round by round; turn by turn where the rules have turns."""
    rewards = mw.Rewards(pursuer_collide=(-1, -2, -3), blame=mw.Blame.INVOLVED, evader_step=0.3)
    config = config_of(row, obstacles=0.1, max_steps=9, rewards=rewards)
    turns = config.rules.interaction is not mw.Interaction.SIMULTANEOUS
    start = {"seed": SEED, "episode": 2}
    actions = random_actions(7, config.n_actions, 12, config.n_agents)
    wanted = played_in_python(config, start, actions, turns)
    got = run_command(
        do="play",
        config=config.to_json(),
        start={"seed": str(SEED), "episode": 2},
        actions=actions[: len(wanted) - 1].tolist(),
        turns=turns,
        read=READ,
    )
    assert got["moments"] == wanted


def test_a_snapshot_goes_on_in_another_world(run_command):
    """Also in the middle of a round, and with cells changed by hand: two agents on one cell."""
    config = config_of("swarm-S", max_steps=30)
    actions = random_actions(3, config.n_actions, 9, config.n_agents).tolist()
    world, twin = (
        run_command(
            do="resume",
            config=config.to_json(),
            start={"seed": "4"},
            before=actions[:5],
            after=actions[5:],
            edit=edit,
            read=READ,
        )
        for edit in ([], [["cells", 0, 8], ["cells", 1, 8]])
    )
    original = mw.World(config)
    original.keeps_conflicts = True
    original.reset(4)
    for row in actions:
        original.play_turn(row)
    wanted = {name: array.ravel().tolist() for name, array in original.read(*READ).items()}
    for told in world:
        assert {name: told[name] for name in READ} == wanted
        assert told["turn"] == original.turn
    assert twin[0] == twin[1]  # the two ways of going on agree
    assert twin[0] != world[0]


@pytest.mark.parametrize(("sampled", "memory"), [(True, "none"), (False, "gru")])
def test_what_a_network_answers(run_command, sampled, memory):
    config = config_of("O", obstacles=0.1)
    policy = team(config, (16, 8), 4, sampled=sampled, activation="tanh", memory=memory)
    actions = random_actions(2, config.n_actions, 3, config.n_agents)
    world = mw.World(config)
    world.reset(11)
    for row in actions:
        for agents in (range(config.n_pursuers), range(config.n_pursuers, config.n_agents)):
            world.decide(policy, agents, row.copy())
        world.step(row)
    alive = np.flatnonzero(world.alive)
    chosen = np.full(config.n_agents, 9)
    world.decide(policy, range(config.n_pursuers), chosen)
    got = run_command(
        do="decide",
        config=config.to_json(),
        start={"seed": "11"},
        actions=actions.tolist(),
        policy=policy_json(policy),
        team="pursuer",
        agents=alive.tolist(),
    )
    assert got["chosen"] == chosen.tolist()
    logits = np.array([answer["logits"] for answer in got["answers"]], np.float32)
    expected = world._core.logits(policy.policy.core, policy.genomes[0])
    np.testing.assert_array_equal(logits, expected)
    weights = np.exp(logits.astype(float) - logits.max(axis=1, keepdims=True))
    shares = [answer["probabilities"] for answer in got["answers"]]
    np.testing.assert_allclose(shares, weights / weights.sum(axis=1, keepdims=True), rtol=1e-6)
    by_agent = dict(zip(alive.tolist(), got["answers"], strict=True))
    for agent in alive[alive < config.n_pursuers]:
        assert by_agent[agent]["action"] == chosen[agent]
    # What agents remembered before their last decision, which the pursuers made in this step.
    kept = world._core.snapshot()["memories"].reshape(len(alive), 2, policy.policy.state_size)
    remembered = np.where(alive[:, None] < config.n_pursuers, kept[:, 0], kept[:, 1])
    assert [answer["memory"] for answer in got["answers"]] == remembered.tolist()
    assert got["view"] == world.views()[alive[0]].ravel().tolist()


@pytest.mark.parametrize("name", RATED)
def test_why_a_move(run_command, name):
    """Inputs and ratings of the moves of all agents, and which moves the mask forbids."""
    row, policy, changes = RATED[name]
    config = config_of(row, **changes)
    population, _ = rated_teams(config, policy)
    policy, (genome,) = population.policy, population.genomes
    world = mw.World(config)
    world.reset(7)
    actions = random_actions(2, config.n_actions, 3, config.n_agents)
    for played in actions:
        world.step(played)
    alive, inputs = np.flatnonzero(world.alive), world.inputs()
    got = run_command(
        do="rate",
        config=config.to_json(),
        start={"seed": "7"},
        actions=actions.tolist(),
        policy=policy_json(population),
        agents=alive.tolist(),
    )
    read = [list(mw.INPUTS).index(each) for each in policy.inputs]
    middle = config.fov // 2
    moves = [(0, 0), (-1, 0), (0, 1), (1, 0), (0, -1), (-1, 1), (1, 1), (1, -1), (-1, -1)]
    moves = moves[: config.n_actions]
    for agent, told in zip(alive, got, strict=True):
        assert np.float32(told["inputs"]).T.tolist() == inputs[agent][:, read].tolist()
        assert told["ratings"] == policy.rate(genome, inputs[agent]).tolist()
        obstacles = world.views()[agent, 2]
        refused = {
            "none": np.zeros(config.n_actions),
            "obstacles": np.array([obstacles[middle + r, middle + c] for r, c in moves]),
            "right-of-way": inputs[agent][:, list(mw.INPUTS).index("must_yield")],
        }
        assert told["refused"] == refused[policy.mask].astype(int).tolist()


DRAWN = ("escapes", "opposite", "open_side", "exits", "room")


@pytest.mark.parametrize(
    ("row", "changes"),
    [
        ("O", {"obstacles": 0.15}),
        ("SB", {"obstacles": 0.1, "diagonal": True, "n_pursuers": 12, "n_evaders": 9}),
        ("R", {"n_evaders": 1, "fov": 11}),
    ],
)
def test_what_a_board_draws_of_inputs_are_their_numbers(run_command, row, changes):
    """Cells that are counted, and distances to cells, of all moves of all agents."""
    config = config_of(row, max_steps=30, **changes)
    seen = set()
    for seed in range(6):
        world = mw.World(config)
        world.reset(seed)
        actions = random_actions(seed, config.n_actions, 2, config.n_agents)
        for played in actions:
            world.step(played)
        alive, inputs, views = np.flatnonzero(world.alive), world.inputs(), world.views()
        got = run_command(
            do="shown",
            config=config.to_json(),
            start={"seed": str(seed)},
            actions=actions.tolist(),
            agents=alive.tolist(),
            inputs=DRAWN,
        )
        unit = np.float32(2) / np.float32(config.fov)
        for agent, moves in zip(alive, got, strict=True):
            channel = 0 if agent < config.n_pursuers else 1  # of its adversaries
            for move, shown in enumerate(moves):
                there = np.array(shown["to"])

                def moves_to(cell, there=there):
                    by = np.abs(np.array(cell) - there)
                    return by.max() if config.diagonal else by.sum()

                ways = len(shown["escape"]) / config.n_actions
                alone = agent < config.n_pursuers and not views[agent, channel].any()
                drawn = {
                    "escapes": 1 if alone else ways,
                    "opposite": shown["opposition"] or 0,
                    "open_side": unit * moves_to(shown["openSide"]) if shown["openSide"] else 2,
                    "exits": len(shown["exits"]) / (config.n_actions - 1),
                    "room": unit * (moves_to(shown["wall"]) if shown["wall"] else config.fov // 2),
                }
                own = dict(zip(mw.INPUTS, inputs[agent, move], strict=True))
                assert drawn == pytest.approx({name: own[name] for name in DRAWN}, abs=1e-6)
                seen |= {name for name in DRAWN if 0 < drawn[name] < 1}
    assert seen == {*DRAWN}


def test_conflicts_have_the_words_of_python(run_command):
    """All kinds, forms and outcomes, with all agents at fault, held and doomed."""
    bits = range(4)
    rows = [
        (turn, kind, form, first, second, 3, 0, fault, held, doomed)
        for turn, first, second in [(0, 0, 4), (2, 1, 0), (1, 5, 3), (0, 2, -1), (0, 3, -1)]
        for kind in range(3)
        for form in range(3)
        for fault in bits
        for held in bits
        for doomed in bits
    ]
    table = [number for row in rows for number in (1, *row)]
    got = run_command(do="texts", table=table, n_pursuers=3)
    assert got == plain_values([conflict_of(row, 3) for row in rows])


OPEN = config_of("O").to_json()


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"n_pursuers": 40}, "more agents than free cells: expected at most 42 agents"),
        ({"obstacles": ["?" * 6] * 7}, "map, row 0: expected '.GS' (free) or '#@OTW'"),
        ({"rules": {**OPEN["rules"], "evader": "EXPLODE"}}, "evader: expected one of DISAPPEAR"),
    ],
)
def test_settings_are_refused(run_command, changes, message):
    got = run_command(do="refuse", config={**OPEN, **changes})
    assert got["kind"] == "EngineError"
    assert got["error"].startswith(message)


SOLVED = {
    "O": mw.WorldConfig("O", rows=4, cols=4, n_pursuers=2, n_evaders=1, max_steps=6),
    "TO": mw.WorldConfig("TO", rows=3, cols=4, n_pursuers=2, n_evaders=1, max_steps=6),
    "teams": mw.WorldConfig(
        replace(mw.VARIANTS["O"], interaction=mw.Interaction.SWARM_TURNS),
        obstacles=np.array([[0, 0, 1], [0, 0, 0], [0, 0, 0]], dtype=bool),
        diagonal=True,
        n_pursuers=1,
        n_evaders=2,
        max_steps=4,
    ),
}


PLAY = {
    ("O", "capture-rate"): "dabae113", ("O", "capture-time"): "138bd9b2",
    ("TO", "capture-rate"): "69f2995a", ("TO", "capture-time"): "b027ab4f",
    ("teams", "capture-rate"): "37a7488e", ("teams", "capture-time"): "3ceb3389",
}  # fmt: skip
"""Digests of values, strategies and losses in each moment of a match. They were those of `solve` in
a test that stood here at commit 8e1a8000."""


@pytest.mark.parametrize(("name", "payoff"), PLAY)
def test_pages_know_perfect_play(run_command, name, payoff):
    config, rng = SOLVED[name], np.random.default_rng(3)
    world, actions = mw.World(config), []
    world.reset(2)
    while not (world.terminated or world.truncated):
        actions.append(rng.integers(config.n_actions, size=config.n_agents).tolist())
        world.play_turn(actions[-1])
    given = {"config": config.to_json(), "start": {"seed": "2"}, "payoff": payoff}
    told = json.dumps(run_command(do="solve", actions=actions, **given), sort_keys=True)
    rounded = json.loads(told, parse_float=lambda number: round(float(number), 9) + 0.0)
    digest = hashlib.sha256(json.dumps(rounded).encode()).hexdigest()
    assert digest[:8] == PLAY[name, payoff]
