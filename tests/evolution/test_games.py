"""Games that come with the package: races of them are resumed, and judged as their answers say."""

from itertools import chain

import numpy as np
import pytest

from games.nim import nim
from games.numbers_game import focusing, numbers, relativism
from games.rock_paper_scissors import rock_paper_scissors
from games.tic_tac_toe import tic_tac_toe
from matrixworld.analysis import judge, read_payoffs
from matrixworld.analysis.judgement import ABSENT
from matrixworld.coevolution import RaceSettings, RunGroup, check_game, create, finish
from tiny_race import directory_in_memory

pytestmark = pytest.mark.filterwarnings("ignore::matrixworld.coevolution.DisengagementWarning")

GAMES = (rock_paper_scissors, numbers, focusing, relativism, nim, tic_tac_toe)
IN_TURNS = {
    "schedule": "specialist-specialist", "schedule.pursuer_epochs": 5, "schedule.evader_epochs": 5,
    "schedule.generations": 20,
}  # fmt: skip
LEARNERS = {
    "ga": {"learner": "ga", "learner.mutation": 0.5, "learner.population": 12},
    "es": {"learner": "es", "learner.learning_rate": 0.5, "learner.population": 12},
}
CLAIMS = {"arms race", "one-sided progress"}


def race(game, learner, schedule, seed):
    return RaceSettings.of({"game": game, "seed": seed, **LEARNERS[learner], **schedule})


@pytest.mark.parametrize("game", GAMES, ids=lambda game: game.play.__name__)
def test_games_keep_their_promises(game):
    check_game(game)


def raced(*parts):
    """Return the payoff matrix, both archives and the judgement of a race."""
    with directory_in_memory() as place:
        create(race(*parts), place / "run")
        run = finish(place / "run")
        judgement = RunGroup((run.path,), (run,)).judgement
        return run.payoff().matrix, [*run.archive().values()], judgement


def test_teams_that_play_hands_cycle_and_do_not_improve():
    races = [raced(rock_paper_scissors, "ga", IN_TURNS, seed) for seed in range(3)]
    together = judge(read_payoffs(np.stack([matrix for matrix, _, _ in races]), exact=True))
    for judgement in (together, *(judgement for _, _, judgement in races)):
        assert {"intransitivity", "cycling"} <= {*judgement.present("whole")}
        assert not CLAIMS & {*chain(*map(judgement.present, judgement.windows))}
    for matrix, (left, right), _ in races:
        assert np.ptp(matrix) > 0.5
        # Nobody beats the equilibrium, whatever has evolved.
        scores = rock_paper_scissors.play(np.zeros_like(left), right, None)
        np.testing.assert_allclose(scores, 0.5, atol=1e-6)


@pytest.mark.parametrize("learner", LEARNERS)
def test_larger_numbers_are_an_arms_race_unless_one_team_runs_away(learner):
    matrix, archives, judgement = raced(numbers, learner, IN_TURNS, 0)
    if learner == "ga":  # its mutants differ so much that one team leads, and wins nearly all
        assert judgement.present() == ("disengagement",)
    for window, findings in judgement.windows.items() if learner == "es" else ():
        assert "arms race" in judgement.present(window)
        for condition in ("intransitivity", "cycling", "forgetting", "stagnation"):
            assert findings[condition].verdict == ABSENT
    hosts, parasites = (archive.sum(axis=1) for archive in archives)
    assert (matrix[1:, 1:] > 0.5).tolist() == np.greater.outer(hosts, parasites)[1:, 1:].tolist()
    assert min(hosts[-1], parasites[-1]) > 50
