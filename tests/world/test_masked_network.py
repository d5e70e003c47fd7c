"""Action masks as fixed weights: forbidden moves are never played, and no learner changes them."""

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from matrixworld.coevolution.learners.transitions import experience
from matrixworld.coevolution.types import TEAMS, Team
from matrixworld.world.config import WorldConfig
from matrixworld.world.masks import FORBIDDEN, forbidding_cells, mask_weights, masked_network
from matrixworld.world.policy import Network, Population
from reference import MOVES
from right_of_way import OBSTACLES, forbidden_in_s
from tiny_race import played, tiny_race


def forbidden(views: np.ndarray, mask: str, team: Team, n_actions: int) -> np.ndarray:
    """Return which actions (n, n_actions) a mask forbids in S, in views (n, 3, fov, fov)."""
    if mask == "right-of-way":
        return np.array([forbidden_in_s(view, team, n_actions) for view in views])
    found = np.zeros((len(views), n_actions), bool)
    middle = views.shape[-1] // 2
    for action, (row, col) in enumerate(MOVES[1:n_actions], start=1):
        found[:, action] = views[:, OBSTACLES, middle + row, middle + col] == 1
    return found


SIMPLE: tuple[Any, ...] = (6,), "relu", "none"


@pytest.mark.parametrize(
    ("mask", "team", "hidden", "activation", "memory", "diagonal"),
    [
        ("obstacles", "evader", *SIMPLE, True),
        ("right-of-way", "pursuer", *SIMPLE, True),
        ("right-of-way", "evader", (), "relu", "none", False),
        ("obstacles", "pursuer", (6,), "relu", "gru", True),
        ("right-of-way", "evader", (6, 5), "tanh", "gru", False),
    ],
)  # fmt: skip
def test_the_engine_never_plays_a_forbidden_move(
    mask: str, team: Team, hidden: tuple[int, ...], activation: Any, memory: Any, diagonal: bool
) -> None:
    config = WorldConfig(
        "S", rows=7, cols=7, n_pursuers=8, n_evaders=8, obstacles=0.15, fov=5, max_steps=40,
        diagonal=diagonal,
    )  # fmt: skip
    bare_network = Network.for_config(config, hidden, activation=activation, memory=memory)
    network = masked_network(bare_network)
    weights = mask_weights(network, forbidding_cells(config, mask, team))
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
def test_learners_leave_the_mask_as_it_is(learner: str, tmp_path: Path) -> None:
    if learner == "actor-critic":
        pytest.importorskip("torch")
    settings = tiny_race(mask="obstacles", learner=learner)
    run = played(settings, tmp_path)
    for team in TEAMS:
        weights, genomes = settings.mask_weights(team), run.teams[team].genomes
        assert weights is not None
        np.testing.assert_array_equal(weights.write(genomes), genomes)
        learned = (genomes[0] != genomes[-1])[~weights.fixed]
        # The others did learn; a genetic algorithm changes a part of them.
        assert learned.mean() > 0.3
    # A unit for each direction beside those of the settings.
    assert run.teams["pursuer"].network.hidden == (4 + 4,)


@pytest.mark.parametrize("learner", ["es", "ga"])
def test_nobody_is_at_fault_in_training_with_any_weights(learner: str, tmp_path: Path) -> None:
    settings = tiny_race(mask="right-of-way", learner=learner, fov=5, rules="S")
    large: dict[str, Any] = {"policy.initial_head": 1e5}
    if learner == "es":  # samples that spread with the genome must not spread with the mask
        large |= {"learner.relative_sigma": 0.4, "learner.sigma": 1000.0}
    for number, changes in enumerate(({}, large, {**large, "policy.hidden": ()})):
        run = played(settings.changed(changes), tmp_path / str(number))
        log = run.log()
        assert log["matches"][-1] > 0
        assert not log["pursuer_faults"].any()
        assert not log["evader_faults"].any()
