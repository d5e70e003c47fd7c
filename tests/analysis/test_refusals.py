"""Arguments that are wrong are refused in one sentence: what was expected and what came."""

from collections.abc import Callable
from functools import partial

import numpy as np
import pytest

from matrices import ROCK_PAPER_SCISSORS, logistic
from matrixworld import analysis
from matrixworld.analysis.payoffs import check_payoff
from rliable_numbers import ONE, TASK

PENNIES = np.eye(2)
HIDDEN = np.ma.array([[0.9, 0.5], [0.2, 0.3]], mask=[[0, 1], [0, 0]])

MATRICES = [
    (np.zeros((2, 2, 2)), ValueError, r"2 dimension.*got shape \(2, 2, 2\)"),
    (np.array(0.5), ValueError, r"got shape \(\)"),
    ([[0.1, 0.2], [0.3]], ValueError, r"got \[0.1, 0.2\] at \(0\)"),
    ([[0.0, np.nan]], ValueError, r"got nan at index \(0, 1\)"),
    ([[1.5, 0.0]], ValueError, r"\[0, 1\], got 1.5 at index \(0, 0\)"),
    ([[0.5, 10**400]], ValueError, "that float64 holds"),
    ([["0.5", "0.6"]], TypeError, "an array of numbers, got"),
    ([[0.5, 1j]], TypeError, "an array of numbers, got"),
    ([[0.5, object()]], TypeError, r"got <object.*> at \(0, 1\)"),
    ({0.5, 0.6}, TypeError, "an array of numbers, got"),
    ((row for row in PENNIES), TypeError, "an array of numbers, got <generator"),
    (HIDDEN, ValueError, r"a masked cell at \(0, 1\)"),
    ([HIDDEN[0], HIDDEN[1]], ValueError, r"a masked cell at \(0, 1\)"),
]


@pytest.mark.parametrize(("bad", "error", "message"), MATRICES)
def test_bad_matrices_are_refused(bad: object, error: type[Exception], message: str) -> None:
    with pytest.raises(error, match=message):
        check_payoff(bad)  # type: ignore[arg-type]


def test_rounding_is_clipped_and_more_is_refused() -> None:
    found = check_payoff([[1 + 1e-12, -1e-12, 0.5]])
    assert found.tolist() == [[1.0, 0.0, 0.5]]
    for rate in (1.01, 1 + 1e-6, -0.01):
        with pytest.raises(ValueError, match=r"in \[0, 1\], got"):
            check_payoff([[rate]])


HIDDEN_VALUES = np.ma.array([0.5, 0.6, 0.7], mask=[0, 1, 0])
HIDDEN_CURVES = np.ma.array(np.full((3, 4), 0.5), mask=np.eye(3, 4))
HIDDEN_SCORES = np.ma.array(np.full((7, 7, 4), 0.5), mask=np.eye(7)[..., None] * np.ones(4))
HIDDEN_CROSS = np.ma.array(np.full((2, 2, 3, 3), 0.5), mask=np.ones((2, 2, 3, 3)))


@pytest.mark.parametrize(
    ("function", "hidden"),
    [
        *((getattr(analysis, name), HIDDEN) for name in (
            "alpha_rank", "checkerboards", "ciao", "effective_diversity", "elo", "forgetting",
            "generalization", "historical_progress", "judge", "lag_profile", "last_half",
            "local_progress", "measure_all", "measure_table", "nash_averaging", "read_payoffs",
            "replicator_dynamics", "team_phase_rates", "transitive_share", "two_way_parts",
        )),
        (partial(analysis.log_loss, PENNIES), HIDDEN),
        (partial(analysis.exploitability, np.eye(3), evaders=[1, 0, 0]), HIDDEN_VALUES),
        (analysis.disengagements, HIDDEN_CURVES[:, :2]),
        (analysis.global_progress, HIDDEN_CROSS),
        (partial(analysis.read_payoffs, np.full((2, 3, 3), 0.5)), HIDDEN_CROSS),
        *((getattr(analysis, name), HIDDEN_SCORES) for name in (
            "dominance_tournament", "elo_over_episodes", "spinning_top",
            "transitive_share_over_episodes",
        )),
        (partial(analysis.judge, per_episode=True), HIDDEN_SCORES),
        *((getattr(analysis, name), HIDDEN_VALUES) for name in (
            "interval_over_runs", "mean_over_episodes",
        )),
        (partial(analysis.difference_of_runs, [0.1, 0.2]), HIDDEN_VALUES),
        (analysis.band_over_runs, HIDDEN_CURVES),
        (partial(analysis.band_over_runs, np.ones((2, 3)), places=HIDDEN_VALUES), None),
        *((getattr(analysis, name), HIDDEN_CURVES) for name in (
            "interquartile_mean", "performance_profile",
        )),
        (partial(analysis.performance_profile, np.ones((2, 3))), HIDDEN_VALUES),
        (partial(analysis.probability_of_improvement, np.ones((3, 4))), HIDDEN_CURVES),
    ],
)  # fmt: skip
def test_what_a_mask_hides_is_never_used(function: Callable[..., object], hidden: object) -> None:
    arguments: dict[str, object] = {}
    if getattr(function, "func", None) is analysis.read_payoffs:
        arguments, hidden = {"cross": hidden}, None
    with pytest.raises(ValueError, match="masked cell at"):
        function(*([] if hidden is None else [hidden]), **arguments)


judge, over_runs = analysis.judge, analysis.interval_over_runs
exploit = partial(analysis.exploitability, ROCK_PAPER_SCISSORS, evaders=[1 / 3] * 3)
judged = judge(logistic(8))

CALLS: list[tuple[Callable[[], object], str]] = [
    (lambda: analysis.checkerboards(PENNIES, margin=-0.1), r"margin in \[0, 1\), got -0.1"),
    (lambda: analysis.alpha_rank(PENNIES, population=1), "population: expected at least 2, got 1"),
    (lambda: analysis.alpha_rank(np.zeros((65, 65))), "at most 4096 pairs .*, got 4225"),
    (lambda: exploit([0.5, 0.5]), "3 weights of the pursuers, got 2"),
    (lambda: exploit([0.5, 0.5, 0.5]), "weights of the pursuers with sum 1, got 1.5"),
    (lambda: analysis.global_progress(np.zeros((1, 1, 4, 4))), "at least 2 runs, got 1"),
    (lambda: analysis.dominance_tournament(np.zeros((2, 2, 1))), "at least 2 episodes a cell"),
    (lambda: analysis.disengagements([[0.5] * 3]), r"shape \(K, 2\), got \(1, 3\)"),
    (lambda: analysis.elo(ROCK_PAPER_SCISSORS, cycles=2), "cycles: expected 0 to 1, got 2"),
    (lambda: over_runs([]), r"values of runs with 1 dimension.* got shape \(0,\)"),
    (lambda: analysis.difference_of_runs([0.1], [0.1, 0.2], paired=True), "1 paired runs, got 2"),
    (lambda: analysis.interquartile_mean([0.1]), r"scores \(runs, opponents\) with 2 dimension"),
    (lambda: analysis.probability_of_improvement(ONE, TASK), "the same 5 opponents, got 1"),
    (lambda: analysis.measure_table(np.zeros((1, 5))), r"at least 2 x 2 generations, got \(1, 5\)"),
    (lambda: analysis.MEASURES["swing"].of(PENNIES, "x"), "^window: expected one of whole, first"),
    (lambda: judged.present("early"), "^window: expected one of whole, first half"),
    (lambda: judge(logistic(8), level=1.5), r"level in \(0, 1\), got 1.5"),
    (lambda: judge(logistic(8), episodes=0), "episodes: expected"),
    (lambda: judge(np.zeros((8, 8, 3)), per_episode=True, episodes=5), "the 3 episodes of each"),
    (lambda: over_runs([0.1, 0.2], bounds=(1, 0)), r"bounds \(low, high\), got \(1, 0\)"),
]


@pytest.mark.parametrize(("call", "message"), CALLS)
def test_a_wrong_argument_is_refused(call: Callable[[], object], message: str) -> None:
    with pytest.raises(ValueError, match=message):
        call()


@pytest.mark.parametrize(
    "call",
    [
        lambda: over_runs([0.1, 0.2], level="0.9"),
        lambda: over_runs(["0.1", "0.2"]),
        lambda: over_runs(np.array([0.1 + 1j, 0.2])),
        lambda: over_runs([0.1, 0.2], bounds={0, 1}),
        lambda: analysis.elo(ROCK_PAPER_SCISSORS, cycles=0.5),
        lambda: analysis.alpha_rank(PENNIES, alpha="1"),
        lambda: analysis.replicator_dynamics(PENNIES, time="1"),
        lambda: analysis.lag_profile(PENNIES).at(0.5),
        lambda: analysis.headline(PENNIES),
        lambda: analysis.judgement_table(None),
        lambda: analysis.explain("judgement"),
        lambda: analysis.read_payoffs({}),
    ],
)
def test_a_wrong_type_is_refused(call: Callable[[], object]) -> None:
    with pytest.raises(TypeError, match=r"expected .* got "):
        call()
