"""Races on maps that evolve: what is played where, what is kept, resume, and refusals."""

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from matrixworld import coevolution, rollout
from matrixworld.coevolution import RaceSettings
from matrixworld.coevolution.maps import MAP_FITNESS, NONE, playable, symmetric
from matrixworld.solve import guarantees
from tiny_race import StopAt, check_resumes, results, straight, tiny_race

SMALL: dict[str, Any] = {
    "rules": "TO", "rows": 4, "cols": 4, "n_pursuers": 2, "n_evaders": 1, "fov": 7,
    "max_steps": 6, "train_steps": 6, "match_episodes": 3,
    "maps": 4, "children": 3, "fresh": 2,
}  # fmt: skip
N_NEW = SMALL["maps"] + SMALL["children"] + SMALL["fresh"]
CALLS = 10
"""Calls of `rollout` in the epochs of a tiny race."""


def map_race(fitness: str = "learnability", **changes: Any) -> RaceSettings:
    small = SMALL | ({"map_matches": 2} if MAP_FITNESS[fitness].plays else {})
    if fitness == NONE:  # which selects no maps
        small = {name: value for name, value in small.items() if name not in ("children", "fresh")}
    return tiny_race(**{**small, "schedule": f"maps-{fitness}", **changes})


def played_and_kept(settings: RaceSettings, directory: Any) -> tuple[list[Any], Any]:
    """Return the world, teams and matches of each call of `rollout`, and the finished run."""
    calls: list[Any] = []

    def play(config: Any, pursuers: Any, evaders: Any, matches: Any, **options: Any) -> Any:
        scores = rollout(config, pursuers, evaders, matches, **options)
        calls.append((config, pursuers, evaders, scores))
        return scores

    coevolution.start(settings, directory, play=play).run()
    return calls, coevolution.open_run(directory)


@pytest.mark.parametrize("fitness", MAP_FITNESS)
def test_teams_learn_on_archived_maps_and_are_evaluated_in_the_world(tmp_path, fitness):
    calls, run = played_and_kept(map_race(fitness, obstacles=0.1), tmp_path / "run")
    found = run.maps()
    assert found["maps"].shape == (3, 4, 4, 4)
    assert all(playable(walls, 3) for generation in found["maps"] for walls in generation)
    per_map = N_NEW if MAP_FITNESS[fitness].plays else 0
    generation = 5 + per_map
    for number in range(2):
        epochs = calls[number * generation :][:5]
        archived = [walls.tobytes() for walls in found["maps"][number]]
        assert all(world.map.tobytes() in archived for world, *_ in epochs)
        # Each generation is played on more maps than one: the draws differ by epoch.
        assert number or len({world.map.tobytes() for world, *_ in epochs}) > 1
    assert len(calls) == 2 * generation + 3
    assert {world.density for world, *_ in calls[-3:]} == {0.1}
    assert sum(scores.length.size for *_, scores in calls[:-3]) == run.log()["matches"][-1]


def slow_scores(fitness: str, world: Any, champions: Any, played: Any, best: Any) -> float:
    """Return the score of a map, written down once more from episodes or perfect play."""
    if fitness == "regret":
        exact = guarantees(world, dict(zip(coevolution.TEAMS, champions, strict=True)))
        return float(exact.exploitability["pursuer"][0] + exact.exploitability["evader"][0])
    captured = [float(each) for each in played.captured_fraction.ravel()]
    returns = [captured, [1.0 - each for each in captured]]
    means = [sum(each) / len(each) for each in returns]
    if fitness == "value-loss":
        losses = [
            sum(max(one - mean, 0.0) for one in each) / len(each)
            for each, mean in zip(returns, means, strict=True)
        ]
        return sum(losses)
    if fitness == "max-monte-carlo":
        highest = [max([*each, *before]) for each, before in zip(returns, best, strict=True)]
        best[0].append(highest[0])
        best[1].append(highest[1])
        return sum(high - mean for high, mean in zip(highest, means, strict=True))
    rate = played.capture_rate.mean()
    return float(rate * (1.0 - rate))


@pytest.mark.parametrize("fitness", ["regret", "value-loss", "max-monte-carlo", "learnability"])
def test_the_best_of_old_and_new_maps_are_kept(tmp_path, fitness):
    calls, run = played_and_kept(map_race(fitness), tmp_path / "run")
    found, known = run.maps(), {}
    for number in (1, 2):
        maps, scores = found["maps"][number], found["scores"][number]
        assert (np.diff(scores) <= 0).all()
        champions = [run.teams[team] for team in coevolution.TEAMS]
        champions = [
            type(each)(each.genomes[number : number + 1], each.network) for each in champions
        ]
        if fitness == "regret":
            world = run.settings.training_world
            worlds = [replace(world, obstacles=walls) for walls in maps]
            slow = [slow_scores(fitness, each, champions, None, None) for each in worlds]
            assert np.allclose(scores, slow)
            continue
        start = (number - 1) * (5 + N_NEW) + 5
        scored = calls[start : start + N_NEW]
        assert all((call[1].genomes == champions[0].genomes).all() for call in scored)
        every = {}
        for world, _, _, played in scored:
            key = world.map.tobytes()
            best = known.setdefault(key, ([], []))
            every[key] = slow_scores(fitness, world, champions, played, best)
        slow = sorted(every.values(), reverse=True)[: len(scores)]
        assert np.allclose(scores, slow)
        assert np.allclose([every[walls.tobytes()] for walls in maps], scores)


def test_novelty_is_the_distance_to_the_nearest_copies(tmp_path):
    _, run = played_and_kept(map_race("novelty", fresh=0, children=0), tmp_path / "run")
    maps, scores = (each[1] for each in run.maps().values())
    for walls, score in zip(maps, scores, strict=True):
        distances = [
            min(int((copy != other).sum()) for copy in symmetric(walls))
            for other in maps
            if other is not walls
        ]
        assert score == pytest.approx(np.mean(sorted(distances)[1:4]))


@pytest.mark.parametrize(("fitness", "call"), [("learnability", 7), ("regret", 9), ("none", 6)])
def test_a_stopped_race_ends_as_if_never_stopped(tmp_path, fitness, call):
    check_resumes(map_race(fitness, retention_episodes=1), call, tmp_path / "run")


def test_the_same_object_continues_after_a_stop_among_scored_maps(tmp_path):
    settings = map_race("max-monte-carlo", pursuers_meet="maxsolve")
    run = coevolution.start(settings, tmp_path / "run", play=StopAt(12))
    with pytest.raises(KeyboardInterrupt):
        run.run()
    run.training.rollout = rollout
    run.run()
    assert results(tmp_path / "run") == straight(settings)


@pytest.mark.parametrize("fitness", ["learnability", "regret"])
def test_threads_change_nothing(tmp_path, fitness):
    coevolution.start(map_race(fitness), tmp_path / "run", threads=3).run()
    assert results(tmp_path / "run") == straight(map_race(fitness))


@pytest.mark.parametrize(
    ("changes", "says"),
    [
        ({"map_fitness": "regrets"}, r"schedule\.map_fitness: expected one of regret, value-loss"),
        ({"map_team": "evaders"}, r"schedule\.map_team: expected one of pursuer, evader, both"),
        ({"map_team": "evader"}, r"schedule\.map_team: expected both, got 'evader'; .* learnab"),
        ({"fitness": "none", "fresh": 1}, r"schedule\.fresh: expected 4, got 1; it has no .* none"),
        ({"fitness": "none", "children": 0}, r"schedule\.children: expected 12, got 0; it has no"),
        ({"fitness": "none", "edits": 5}, r"schedule\.edits: expected 3, got 5; it has no .* none"),
        ({"fitness": "novelty", "map_matches": 2}, r"map_matches: expected 16, got 2; .* novelty"),
        ({"walls": 0.9}, r"schedule\.walls: expected at most 0\.812, .* 3 agents, got 0\.9"),
    ],
)  # fmt: skip
def test_wrong_settings_are_refused(changes, says):
    with pytest.raises(ValueError, match=says):
        map_race(**changes)


@pytest.mark.parametrize(
    ("changes", "says"),
    [
        ({"rows": 40, "cols": 40, "fov": 79}, r"is exact: states: .* 40 x 40 .* cells would fit"),
        ({"memory": "gru"}, "is exact: champion: expected a network without memory"),
    ],
)
def test_worlds_that_cannot_be_solved_are_refused_at_once(tmp_path, changes, says):
    settings = map_race("regret", **changes)
    calls: list[Callable[[], object]] = [
        lambda: coevolution.start(settings, tmp_path / "run"),
        lambda: coevolution.evolve([settings], tmp_path / "job"),
    ]
    for call in calls:
        with pytest.raises(ValueError, match=rf"^schedule\.map_fitness: regret {says}"):
            call()
    assert not list(tmp_path.iterdir())


def test_only_races_on_maps_have_maps(tmp_path):
    run = coevolution.finish(tiny_race(), tmp_path / "run")
    with pytest.raises(ValueError, match="expected a race with the schedule maps, got alternating"):
        run.maps()
