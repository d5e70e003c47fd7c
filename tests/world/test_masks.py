"""Action masks: the right of way, and networks that never play what a mask forbids."""

import itertools
import warnings

import numpy as np
import pytest

import matrixworld as mw
from matrixworld.coevolution.learners.learner import DivergedError
from matrixworld.coevolution.types import TEAMS
from matrixworld.play.experience import experience
from matrixworld.world import masks
from matrixworld.world.arrays import new_arrays
from matrixworld.world.config import WorldConfig
from matrixworld.world.policy import FORBIDDEN, Network, Population
from matrixworld.world.rules import VARIANTS
from reference import MOVES
from right_of_way import MASK, OBSTACLES, ROWS, forbidden_in_s, play, random_teams
from slow import quickly
from tiny_race import played, tiny_race

UNUSUAL = (
    mw.Rules(evader=mw.Outcome.DISAPPEAR, pursuer=mw.Outcome.BOUNCE),
    mw.Rules(evader=mw.Outcome.REACH, pursuer=mw.Outcome.REACH, capture=mw.Capture.SURROUND),
    mw.Rules(evader=mw.Outcome.BOUNCE, pursuer=mw.Outcome.BOUNCE, capture=mw.Capture.SURROUND),
    mw.Rules(mw.Interaction.SWARM_TURNS, evader=mw.Outcome.BOUNCE, capture=mw.Capture.SURROUND),
    mw.Rules(mw.Interaction.AGENT_TURNS, evader=mw.Outcome.BOUNCE, pursuer=mw.Outcome.REACH),
    mw.Rules(
        obstacle=mw.Outcome.REACH, teammate=mw.Outcome.DISAPPEAR, evader=mw.Outcome.REACH,
        pursuer=mw.Outcome.DISAPPEAR, capture=mw.Capture.SURROUND,
    ),
)  # fmt: skip


def world_of(rules, **changes):
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", UserWarning)  # rows in which nobody can be captured
        usual = {"rows": 7, "cols": 7, "n_pursuers": 9, "n_evaders": 8, "max_steps": 40, "fov": 5}
        return mw.WorldConfig(rules, **{**usual, **changes})


WALL = np.zeros((3, 3), bool)
WALL[1, 1] = True


def faults_of(config, team):
    cells = masks.forbidding_cells(config, MASK, team)
    return faults_of_all_choices(config, team, cells)


@pytest.mark.parametrize("team", TEAMS)
@pytest.mark.parametrize("rules", UNUSUAL, ids=str)
def test_no_choice_on_a_small_board_is_at_fault(rules, team):
    config = world_of(rules, rows=2, cols=3, n_pursuers=2, n_evaders=2)
    assert faults_of(config, team) == 0


@pytest.mark.slow
@pytest.mark.parametrize("team", TEAMS)
@quickly("rules", [*VARIANTS, *ROWS[::200], *UNUSUAL], lambda rules: rules == "SB")
def test_no_choice_of_four_agents_is_at_fault(rules, team):
    for n, m, walls in ((3, 1, {}), (2, 2, {}), (1, 3, {}), (2, 2, {"obstacles": WALL})):
        config = world_of(rules, rows=3, cols=3, n_pursuers=n, n_evaders=m, **walls)
        assert faults_of(config, team) == 0
    config = world_of(rules, rows=3, cols=3, n_pursuers=2, n_evaders=1, diagonal=True)
    assert faults_of(config, team) == 0


@pytest.mark.slow
@pytest.mark.parametrize("team", TEAMS)
@quickly("rules", ["S", "SB", "B", UNUSUAL[1]], lambda rules: rules == "SB")
def test_the_mask_forbids_no_more_than_it_must(rules, team):
    # Without any one of its cells, some choice of two teammates and an adversary is at fault.
    sizes = {"n_pursuers": 2, "n_evaders": 1} if team == "pursuer" else {}
    config = world_of(rules, rows=3, cols=3, **{"n_pursuers": 1, "n_evaders": 2, **sizes})
    cells = masks.forbidding_cells(config, MASK, team)
    assert faults_of_all_choices(config, team, cells) == 0
    centre = {channel * 25 + 12 for channel in range(3)}
    for move, named in enumerate(cells):
        for cell in set(named.tolist()) - centre:  # agents begin on cells of their own
            fewer = cells.copy()
            left = named[named != cell]
            fewer[move] = np.resize(left, len(named))
            assert faults_of_all_choices(config, team, fewer) > 0, (move, cell)


def begun(config, placed):
    specs, n = mw.array_specs(config), len(placed["pursuers"])
    buffers = new_arrays({name: specs[name] for name in ("views", "fault")}, n)
    batch = mw.Batch(n, config, threads=1, buffers=buffers)
    batch.reset(np.arange(n, dtype=np.uint64), **placed)
    return batch


def faults_of_all_choices(config, team, cells):
    """Play a round from each placement, with each choice that the mask leaves to a team; return how
    often one of its agents is at fault, whatever the other team does."""
    free = np.argwhere(~np.broadcast_to(config.obstacles != 0, (config.rows, config.cols)))
    placed = np.array(list(itertools.permutations(free, config.n_agents)))
    n = config.n_pursuers
    everyone = {"pursuers": placed[:, :n], "evaders": placed[:, n:]}
    own = slice(0, n) if team == "pursuer" else slice(n, None)
    allowed = np.ones((*placed.shape[:2], config.n_actions), np.int8)
    allowed[:, own] = masks.action_masks(begun(config, everyone).buffers["views"][:, own], cells)
    found = 0
    for choice in itertools.product(range(config.n_actions), repeat=config.n_agents):
        # The placements in which everybody may act so.
        may = allowed[:, np.arange(config.n_agents), choice].all(axis=1)
        if may.any():
            batch = begun(config, {name: cells[may] for name, cells in everyone.items()})
            batch.step(np.tile(choice, (batch.n_worlds, 1)))
            found += int(batch.buffers["fault"][:, own].sum())
    return found


@pytest.mark.parametrize("diagonal", [False, True])
def test_careful_scripts_are_never_at_fault_in_any_row(diagonal):
    for number, rules in enumerate(ROWS[::5]):
        config = world_of(rules, obstacles=0.1, diagonal=diagonal)
        players = ("careful-random", "careful-random", "random", "careful-clumsy-chaser")
        for pursuers, evaders in itertools.pairwise(players):
            played = mw.rollout(config, pursuers, evaders, mw.Matches.of(0, 0, number))
            keep = [name.startswith("careful-") for name in (pursuers, evaders)]
            assert not played.faults[:, :, keep].any(), rules


@pytest.mark.slow
def test_masked_networks_are_never_at_fault():
    # A dozen worlds, whose networks capture nobody with some seeds and hundreds with others.
    played, faults, captures = play(3e5, seed=1)
    assert played >= 3e5
    assert faults == 0
    assert captures > 100


@pytest.mark.parametrize("variant", ["S", "B", "O", "TO"])
def test_environments_offer_the_mask_of_each_team(variant):
    config = world_of(variant, obstacles=0.05)
    rng = np.random.default_rng(3)

    def draw(mask):
        return int(rng.choice(np.flatnonzero(mask)))

    for team, settings in (("pursuer", {}), ("evader", {"pursuers": "random"})):
        envs = mw.VectorEnv(config, n_worlds=4, action_mask=MASK, **settings)
        seen, infos = envs.reset(seed=1)
        n = getattr(config, f"n_{team}s")  # both teams, or the evaders alone
        expected = masks.action_masks(seen[:, :n], masks.forbidding_cells(config, MASK, team))
        np.testing.assert_array_equal(infos["action_mask"][:, :n], expected)
    env = mw.parallel_env(config, action_mask=MASK)
    _, infos = env.reset(seed=1)
    while env.agents:
        *_, infos = env.step({name: draw(infos[name]["action_mask"]) for name in env.agents})
        assert not env.unwrapped.status.fault.any()
    turns = mw.aec_env(config, action_mask=MASK)
    turns.reset(seed=1)
    for _ in turns.agent_iter():
        *_, over, cut, info = turns.last()
        assert not turns.unwrapped.status.fault.any()
        turns.step(None if over or cut else draw(info["action_mask"]))


@pytest.mark.parametrize("variant", ["SB", "O"])
def test_an_agent_among_careful_teammates_has_their_order(variant):
    """Scripts and ratings know the step, and so does the environment; networks do not."""
    config = world_of(variant, n_pursuers=12, n_evaders=1)
    rng = np.random.default_rng(2)
    network, _ = random_teams(config, rng, 1)
    rating = mw.Rating(fov=5, mask="right-of-way")
    rated = mw.Population(rating.initial(rng), rating)
    env = mw.AgentEnv(config, pursuers=["careful-random", network, rated], action_mask=MASK)
    orders = set()
    for episode in range(12):
        _, info = env.reset(seed=episode)
        over = False
        while not over:
            np.testing.assert_array_equal(info["action_mask"] > 0, env.action_masks())
            choices = np.flatnonzero(info["action_mask"])
            *_, ended, cut, info = env.step(int(rng.choice(choices)))
            over = ended or cut
            assert not env.env.status.fault[: config.n_pursuers].any()
        orders.add(env._mates.yields_in_turn)
    assert orders == {True, False}


def test_networks_with_the_mask_of_other_rules_or_teams_are_refused():
    """If it allows more than the right of way in this world does, and only then."""
    match, rng = mw.Matches.of(0, 0, 0), np.random.default_rng(4)
    teams = {each: random_teams(world_of(each), rng, 2) for each in ("O", "TO", "B", "S", "SB")}
    leaking = [("O", "S"), ("O", "SB"), ("TO", "S"), ("B", "SB")]
    for one, other in itertools.product(teams, repeat=2):
        world = world_of(other)
        if (one, other) in leaking or (one in ("O", "TO", "B") and other in ("S", "SB")):
            with pytest.raises(ValueError, match="^pursuers: expected networks that keep"):
                mw.rollout(world, teams[one][0], "random", match)
        else:
            assert not mw.rollout(world, *teams[one], match).faults.any()
    actions = np.zeros(17, np.int64)
    for call in (
        lambda: mw.rollout(world_of("S"), "random", teams["S"][0], match),  # pursuers' mask
        lambda: mw.World(world_of("S")).decide(teams["O"][0], range(9), actions),
        lambda: mw.record(world_of("S"), teams["O"][0], "random"),
        lambda: mw.VectorEnv(world_of("S"), pursuers=teams["O"][0]),
    ):
        with pytest.raises(ValueError, match="got a mask of other rules or of the other team$"):
            call()


@pytest.mark.parametrize("hidden", [(), (32,), (16, 8)])
def test_weights_that_would_outweigh_the_mask_are_refused(hidden):
    config, rng = world_of("SB"), np.random.default_rng(5)
    [(team, _)] = [random_teams(config, rng, 4, hidden=hidden)]
    fixed = masks.mask_weights(team.policy, masks.forbidding_cells(config, MASK, "pursuer"))
    signs = np.sign(team.genomes)
    with pytest.raises(
        ValueError, match="^genomes: expected weights of at most .* got 1.0e.38$"
    ) as told:
        Population(fixed.write(signs * np.float32(1e38)), team.policy)
    most = np.float32(float(str(told.value).split()[6]) * 0.95)  # it is rounded
    largest = Population(fixed.write(signs * most), team.policy)
    found = mw.rollout(config, largest, "random", mw.Matches.of(range(4), 0, range(4)))
    assert not found.faults[:, :, 0].any()
    unmasked = Population(signs * np.float32(1e38), team.policy)  # of no mask
    assert not unmasked.forbids.any()


def test_what_needs_a_wide_view_is_refused_without():
    for mask, fov in (("right-of-way", 3), ("obstacles", 1), ("occupied", 5)):  # no such mask
        with pytest.raises(ValueError, match="^action_mask: expected"):
            masks.ActionMasks(mask, world_of("S", fov=fov))
    config = world_of("S", fov=3)
    with pytest.raises(ValueError, match=r"^pursuers: expected a fov of at least 5 for careful-"):
        mw.rollout(config, "careful-chaser", "random", mw.Matches.of(0, 0, 0))
    for make in (mw.parallel_env, mw.VectorEnv):  # when they are made, not in the first step
        with pytest.raises(
            ValueError, match=r"^evaders: careful-fleer: expected a fov of at least 5"
        ):
            make(config, evaders="careful-fleer")


def forbidden(views, mask, team, n_actions):
    """Return which actions (n, n_actions) a mask forbids in S, in views (n, 3, fov, fov)."""
    if mask == "right-of-way":
        return np.array([forbidden_in_s(view, team, n_actions) for view in views])
    found = np.zeros((len(views), n_actions), bool)
    middle = views.shape[-1] // 2
    for action, (row, col) in enumerate(MOVES[1:n_actions], start=1):
        found[:, action] = views[:, OBSTACLES, middle + row, middle + col] == 1
    return found


SIMPLE = (6,), "relu", "none"


@pytest.mark.parametrize(("mask", "team", "hidden", "activation", "memory", "diagonal"), [
    ("obstacles", "evader", *SIMPLE, True),
    ("right-of-way", "pursuer", *SIMPLE, True),
    ("right-of-way", "pursuer", *SIMPLE, False),
    ("right-of-way", "evader", *SIMPLE, True),
    ("right-of-way", "evader", (), "relu", "none", False),
    ("obstacles", "pursuer", (6,), "relu", "gru", True),
    ("right-of-way", "evader", (6, 5), "tanh", "gru", False),
])  # fmt: skip
def test_the_engine_never_plays_a_forbidden_move(mask, team, hidden, activation, memory, diagonal):
    config = WorldConfig(
        "S", rows=7, cols=7, n_pursuers=8, n_evaders=8, obstacles=0.15, fov=5, max_steps=40,
        diagonal=diagonal,
    )  # fmt: skip
    bare_network = Network.for_config(config, hidden, activation=activation, memory=memory)
    network = masks.masked_network(bare_network)
    weights = masks.mask_weights(network, masks.forbidding_cells(config, mask, team))
    free = np.random.default_rng(1).normal(0, 0.5, (1, network.genome_size)).astype(np.float32)
    genomes = weights.write(free)
    played = experience(
        config, team, Population(genomes, network), "random", np.zeros(8, int),
        np.arange(8, dtype=np.uint64), threads=1,
    )  # fmt: skip
    views = played.views.reshape(-1, 3, 5, 5)
    refused = forbidden(views, mask, team, config.n_actions)
    each = np.arange(len(played))
    assert refused.any(axis=0)[1:].all()  # each move was forbidden somewhere
    assert not refused[each, played.actions].any()
    # No other move is forbidden, and none is more or less likely than without the mask.
    without = np.where(weights.values == FORBIDDEN, np.float32(0), genomes[0])
    # Agents remember anything, but not what was forbidden.
    states = np.random.default_rng(2).uniform(-1, 1, (len(views), network.state_size))
    states = states.astype(np.float32)
    (logits, _), (bare, _) = (network.advance(g, views, states) for g in (genomes[0], without))
    np.testing.assert_array_equal(logits[~refused], bare[~refused])
    assert (logits[refused] < FORBIDDEN / 2).all()  # whatever the other weights add
    assert len(np.unique(played.actions)) == config.n_actions


@pytest.mark.parametrize("learner", ["es", "ga", "actor-critic"])
def test_learners_leave_the_mask_as_it_is(learner, tmp_path):
    if learner == "actor-critic":
        pytest.importorskip("torch")
    settings = tiny_race(mask="obstacles", learner=learner)
    run = played(settings, tmp_path)
    for team in TEAMS:
        weights, genomes = settings.evaluation_game.mask(team), run.teams[team].genomes
        assert weights is not None
        np.testing.assert_array_equal(weights.write(genomes), genomes)
        learned = (genomes[0] != genomes[-1])[~weights.fixed]
        # The others did learn; a genetic algorithm changes a part of them.
        assert learned.mean() > 0.3
    # A unit for each direction beside those of the settings.
    assert run.teams["pursuer"].policy.hidden == (4 + 4,)


@pytest.mark.parametrize("learner", ["es", "ga"])
def test_nobody_is_at_fault_in_training_with_any_weights(learner, tmp_path):
    settings = tiny_race(mask="right-of-way", learner=learner, fov=5, rules="S")
    large = {"policy.initial_head": 1e5}
    if learner == "es":  # samples that spread with the genome must not spread with the mask
        large |= {"learner.relative_sigma": 0.4, "learner.sigma": 1000.0}
    for number, changes in enumerate(({}, large, {**large, "policy.hidden": ()})):
        run = played(settings.changed(changes), tmp_path / str(number))
        log = run.log()
        assert log["matches"][-1] > 0
        assert not log["pursuer_faults"].any()
        assert not log["evader_faults"].any()
    if learner == "es":
        huge = settings.changed({"learner.sigma": 1e16, "policy.hidden": (8, 8)})
        with pytest.raises(DivergedError, match=r"beside a mask.*lower .*learner\.sigma \(now 1e"):
            played(huge, tmp_path / "huge")
