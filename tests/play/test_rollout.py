"""Episode statistics against the recorded episodes, counted in plain NumPy."""

from dataclasses import fields
from typing import Any

import numpy as np
import pytest

import matrixworld as mw
from rows import NAMES, config_of, random_team

FIELDS = [item.name for item in fields(mw.EpisodeStatistics)]


def statistics_of(episode: mw.Episode, config: mw.WorldConfig) -> dict[str, Any]:
    """Statistics of a recorded episode."""
    n_pursuers, n_evaders = config.n_pursuers, config.n_evaders
    ever = config.rules.capture is mw.Capture.OCCUPATION
    counted = episode.ever_captured if ever else episode.captured
    share = [row.mean() for row in counted[1:]]
    share += [share[-1]] * (config.max_steps - episode.length)
    statistics: dict[str, Any] = {
        "capture_rate": counted[-1].mean(),
        "ever_capture_rate": episode.ever_captured[-1].mean(),
        "captured_fraction": np.mean(share),
        "length": episode.length,
    }
    teams = {"pursuer": slice(0, n_pursuers), "evader": slice(n_pursuers, None)}
    for name, team in teams.items():
        size = {"pursuer": n_pursuers, "evader": n_evaders}[name]
        statistics[f"{name}_return"] = episode.rewards[:, team].astype(float).sum()
        statistics[f"{name}_survivors"] = episode.alive[-1, team].sum()
        overlap = [
            alive.sum() - len({tuple(cell) for cell in cells[alive]})
            for alive, cells in zip(
                episode.alive[1:, team], episode.positions[1:, team], strict=True
            )
        ]
        statistics[f"{name}_overlap"] = sum(overlap) / size / config.max_steps
    for name, flags in (("collisions", episode.involved), ("faults", episode.fault)):
        statistics[name] = [flags[:, team].sum(axis=(0, 1)) for team in teams.values()]
    statistics["agent_steps"] = [episode.alive[:-1, team].sum() for team in teams.values()]
    return statistics


def assert_same_bits(
    one: mw.EpisodeStatistics, other: mw.EpisodeStatistics, rows: Any = slice(None)
) -> None:
    for name in FIELDS:
        expected, found = getattr(one, name)[rows], getattr(other, name)
        assert expected.dtype == found.dtype
        np.testing.assert_array_equal(expected, found, name)


@pytest.mark.parametrize("name", NAMES)
def test_statistics_are_those_of_the_recorded_episodes(name: str) -> None:
    config = config_of(name, max_steps=25, obstacles=0.1)
    team = random_team(config, 0, 1)
    both, one = [0, 1, 1], [0, 0, 0]
    seeds = [5, 6, 2**64 - 1]  # up to the largest seed
    for pursuers, evaders, matches in (
        (team, team, mw.Matches.of(both, both[::-1], seeds)),
        (team, "random", mw.Matches.of(both, one, seeds)),
        ("chaser", team, mw.Matches.of(one, both, seeds)),
    ):
        statistics = mw.rollout(config, pursuers, evaders, matches, episodes=2)
        for m, (pursuer, evader, seed) in enumerate(zip(*matches, strict=True)):
            chosen = {"pursuer": int(pursuer), "evader": int(evader), "seed": int(seed)}
            for world in range(2):
                episode = mw.record(config, pursuers, evaders, episode=world, **chosen)
                for field, expected in statistics_of(episode, config).items():
                    found = getattr(statistics, field)[m, world]
                    np.testing.assert_allclose(found, expected, rtol=1e-6, atol=1e-6, err_msg=field)


@pytest.mark.parametrize("name", ["O", "SB", "TO", "swarm-D"])
def test_a_match_depends_on_its_genomes_and_seed_alone(name: str) -> None:
    config = config_of(name, obstacles=0.1)
    team = random_team(config, *range(4))
    matches = mw.Matches.of([0, 1, 2, 3, 0, 1, 2, 3, 3], [0, 0, 1, 1, 2, 2, 3, 3, 3], np.arange(9))
    whole = mw.rollout(config, team, team, matches, episodes=20, threads=1)
    for threads in (3, None):
        again = mw.rollout(config, team, team, matches, episodes=20, threads=threads)
        assert_same_bits(whole, again)
    for m, (pursuer, evader, seed) in enumerate(zip(*matches, strict=True)):
        pair = (mw.Population(team.genomes[each], team.policy) for each in (pursuer, evader))
        alone = mw.rollout(config, *pair, mw.Matches.of(0, 0, seed), episodes=20)
        assert_same_bits(whole, alone, [m])
    order = [8, 3, 0, 2, 2]
    some = mw.Matches(*(column[order] for column in matches))
    assert_same_bits(whole, mw.rollout(config, team, team, some, episodes=20), order)
