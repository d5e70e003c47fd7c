"""The judgement of races: verdicts on races whose truth is known, windows, runs and bad input."""

import json
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra import numpy as arrays
from scipy.special import expit

from matrices import circular, logistic
from matrixworld import analysis
from matrixworld.analysis import CONDITIONS, Judgement, judge
from matrixworld.analysis.intervals import Estimate
from matrixworld.analysis.judge import RULES
from matrixworld.analysis.judgement import ABSENT, CANNOT_TELL, PRESENT, Finding
from matrixworld.analysis.measures import Lead, leads_of
from matrixworld.analysis.reasons import Reason


def drawn(chance, episodes=10, seed=0, *, evaders=1):
    """Draw episodes: the share of some evaders that is captured, each with these chances."""
    rng = np.random.default_rng(seed)
    chances = np.repeat(np.clip(chance, 0, 1)[..., None], episodes, axis=-1)
    return rng.binomial(evaders, chances) / evaders


def race(pursuers, evaders):
    """Return the capture rates of teams of these strengths."""
    return expit(np.subtract.outer(pursuers, evaders))


def of_scores(scores):
    return judge(scores, per_episode=True)


def verdicts(judgement, window=None):
    findings = judgement.windows[window or "last half"]
    return {name: finding.verdict for name, finding in findings.items()}


def gain(judgement, team, window=None):
    return judgement.windows[window or "last half"]["arms race"].estimates[f"{team}_gain"]


CIRCLES = ("intransitivity", "cycling")
STILL_OR_CIRCLES = {*CIRCLES, "stagnation", "one-sided progress"}
PROGRESS = ("arms race", "one-sided progress", "rise")
G = np.arange(31.0)  # 30 generations and the untrained one, as in races
STEADY = race(0.3 * G, 0.3 * G)
SLOW = race(0.1 * G, 0.1 * G)
FLAT = np.full((31, 31), 0.5)
EARLY_STOP = race(0.4 * np.minimum(G, 10), 0.4 * np.minimum(G, 10))  # before the last half begins
LATE_STOP = race(0.3 * np.minimum(G, 23), 0.3 * np.minimum(G, 23))  # within the last half
PURSUERS_ONLY = race(0.15 * G - 2, 0 * G)
# After generation 20 they lose what they had.
PURSUERS_FADE = race(0.3 * np.minimum(G, 40 - G), 0.3 * G)


@pytest.mark.parametrize(
    ("chance", "present", "absent"),
    [
        (STEADY, {"arms race", "rise"}, {*STILL_OR_CIRCLES, "disengagement"}),
        (FLAT, {"stagnation"}, {*CIRCLES, *PROGRESS, "disengagement"}),
        (EARLY_STOP, {"stagnation"}, {"arms race", "rise", *CIRCLES}),
        (PURSUERS_ONLY, {"one-sided progress", "rise"}, {"arms race", "stagnation", *CIRCLES}),
        (PURSUERS_FADE, {"rise", "forgetting"}, {*CIRCLES}),
        (circular(31), {*CIRCLES, "forgetting"}, {"stagnation"}),
        (np.full((31, 31), 0.99), {"disengagement"}, set()),
    ],
)
def test_races_of_known_truth(chance, present, absent):
    found = verdicts(of_scores(drawn(chance, 20, evaders=30)))
    assert {name for name in CONDITIONS if found[name] == PRESENT} == present
    assert absent <= {name for name in CONDITIONS if found[name] == ABSENT}


@pytest.mark.parametrize("chance", [SLOW, LATE_STOP, np.full((31, 31), 0.1)])
def test_noise_of_wins_and_losses_is_no_cycle(chance):
    scores = drawn(chance, 10)
    for judgement in (of_scores(scores), judge(scores.mean(axis=2), episodes=10)):
        for window in judgement.windows:
            found = verdicts(judgement, window)
            assert PRESENT not in (found["intransitivity"], found["cycling"])
            assert found["forgetting"] != PRESENT


@pytest.mark.parametrize("exact", [False, True])
@pytest.mark.parametrize("turns", [2, 3, 6])
def test_strategies_that_turn_cycle_and_do_not_improve(turns, exact):
    """Each beats those that are up to half a turn older. One turn or less looks like a rise."""
    angles = 2 * np.pi * turns * np.arange(40) / 40
    chance = 0.5 + 0.45 * np.sin(np.subtract.outer(angles, angles))
    exactly = analysis.read_payoffs(chance, exact=True)
    judgement = judge(exactly) if exact else of_scores(drawn(chance))
    assert {*CIRCLES} <= {*judgement.present("whole")}
    for window in judgement.windows:
        assert not {*PROGRESS} & {*judgement.present(window)}


def test_a_walk_may_rise_without_a_trend():
    # Two questions: did it become stronger; does a random walk explain that?
    walk = np.random.default_rng(18).normal(0, 0.25, 31).cumsum()
    found = of_scores(drawn(race(walk, 0 * G), 10, evaders=30)).windows["whole"]
    assert (found["rise"].verdict, found["one-sided progress"].verdict) == (PRESENT, CANNOT_TELL)


def test_few_or_unknown_episodes_give_no_verdict_on_what_noise_can_fake():
    few = of_scores(drawn(logistic(15, 0.3), 2)).findings
    assert {few[name].verdict for name in (*CIRCLES, "forgetting")} == {CANNOT_TELL}
    matrix = drawn(circular(31), 10, evaders=30).mean(axis=2)
    assert verdicts(judge(matrix))["intransitivity"] == CANNOT_TELL
    known = verdicts(judge(matrix, episodes=10))
    assert known["intransitivity"] == PRESENT
    # These need the single episodes.
    assert known["cycling"] == known["forgetting"] == CANNOT_TELL


def test_a_wave_in_the_first_half_is_reported():
    chance = STEADY.copy()
    chance[:15, :15] = circular(15)  # the pairs of the first half only
    judgement = of_scores(drawn(chance, 20, evaders=30))
    assert verdicts(judgement)["cycling"] == ABSENT
    assert verdicts(judgement, "first half")["cycling"] == PRESENT


@pytest.mark.parametrize("shape", [(40, 12), (31, 6)])
def test_sides_of_different_length(shape):
    rows, columns = (np.arange(size) for size in shape)
    judgement = of_scores(drawn(race(0.1 * rows, 0.1 * columns), 10, evaders=30))
    assert verdicts(judgement, "whole")["disengagement"] == ABSENT
    assert verdicts(judgement, "whole")["arms race"] == PRESENT


@pytest.mark.parametrize("chance", [circular(31), PURSUERS_ONLY])
def test_swapping_the_teams_swaps_the_gains_and_keeps_the_verdicts(chance):
    scores = drawn(chance, 10, evaders=30)
    one, other = of_scores(scores), of_scores(1 - scores.transpose(1, 0, 2))
    assert verdicts(one) == verdicts(other)
    for window in one.windows:
        pursuers, evaders = (gain(one, team, window) for team in ("pursuer", "evader"))
        assert pursuers.value == pytest.approx(gain(other, "evader", window).value, abs=1e-6)
        assert evaders.low == pytest.approx(gain(other, "pursuer", window).low, abs=1e-6)


def test_several_runs_are_judged_over_runs():
    scores = np.stack([drawn(STEADY, 10, seed, evaders=30) for seed in range(5)])
    judgement = of_scores(scores)
    assert judgement.runs == 5
    found = gain(judgement, "pursuer")
    assert (found.across, found.samples) == ("runs", 5)
    assert verdicts(judgement)["arms race"] == PRESENT
    assert judgement.findings["arms race"].by_run == (PRESENT,) * 5
    # Runs that differ give no verdict.
    kinds = (STEADY, circular(31), STEADY, circular(31))
    differ = of_scores(np.stack([drawn(chance, 20, evaders=30) for chance in kinds]))
    found = differ.findings["intransitivity"]
    assert (found.verdict, found.by_run) == (CANNOT_TELL, (ABSENT, PRESENT, ABSENT, PRESENT))


def test_a_disengaged_run_is_left_out_of_other_conditions():
    won = np.full((31, 31), 0.995)  # so one-sided that learning has nothing to go by
    chances = [won, *(STEADY for _ in range(4))]
    scores = np.stack([drawn(each, 20, seed, evaders=30) for seed, each in enumerate(chances)])
    judgement = of_scores(scores)
    assert verdicts(judgement)["disengagement"] != PRESENT
    assert gain(judgement, "pursuer").samples == 4
    assert verdicts(judgement)["arms race"] == PRESENT


def test_words_and_json():
    assert {*RULES} == {*CONDITIONS}
    judgement = of_scores(drawn(circular(31), 10, evaders=30))
    heads, *rows = analysis.judgement_table(judgement)
    assert heads[:2] == ("condition", "verdict")
    assert [row[0] for row in rows[: len(CONDITIONS)]] == list(CONDITIONS)
    told = analysis.explain(judgement)
    assert "Cycling: present, because both teams went back to old strategies: generations" in told
    plain = judgement.to_json()
    assert json.loads(json.dumps(plain, allow_nan=False)) == plain
    assert plain["windows"]["last half"]["cycling"]["verdict"] == PRESENT


BOTH = ("pursuers", "evaders")
WINDOWS = ("whole", "first half", "last half")


def with_verdicts(found):
    windows = {
        window: {name: Finding(verdict, Reason(), teams) for name, (verdict, teams) in one.items()}
        for window, one in found.items()
    }
    return Judgement(1, (31, 31), 20, 0.95, windows)


def when(teams=BOTH, **found):
    """Return a judgement in which conditions are present in the windows of these letters."""
    said = {name: found.get(name.split()[0], "") for name in CONDITIONS}
    return with_verdicts({
        window: {
            name: (PRESENT, teams) if window[0] in at
            else (CANNOT_TELL if "?" in at else ABSENT, ())
            for name, at in said.items()
        }
        for window in WINDOWS
    })  # fmt: skip


def test_a_sentence_is_about_the_whole_race_and_a_half_that_differs():
    only = ("evaders",)
    said = {
        "Both teams improved.": when(arms="wfl", rise="w"),
        "In generations 0 to 14, both teams improved. From generation 15 on, neither team ended "
        "stronger or weaker, but both teams lost old skills ().": when(
            arms="wf", stagnation="l", forgetting="l"
        ),
        "Only the evaders improved. From generation 15 on, the evaders lost old skills ().": when(
            only, **{"one-sided": "w?"}, forgetting="l"
        ),
        "No clear progress: both teams lost old skills (). In both halves, both teams went back to "
        "old strategies.": when(arms="?", intransitivity="wfl", cycling="fl", forgetting="w"),
        "The evaders ended stronger.": when(only, rise="w?", arms="?"),
        "One team won nearly all matches.": when((), disengagement="w", arms="?"),
        "No clear progress.": when(arms="?"),
        "Neither team improved.": when(),
    }
    assert [*map(analysis.sentence, said.values())] == [*said]
    assert analysis.sentence(judge(logistic(5))).startswith("Too short to be judged: it takes")
    named = analysis.read_payoffs(
        drawn(PURSUERS_ONLY, 20, evaders=30), per_episode=True, teams=("foxes", "hens")
    )
    assert analysis.sentence(judge(named)) == "Only the foxes improved."


def learned_at_once(generations, by, seed=0, episodes=20):
    """Return a race whose teams learn all in their first generations, in equal steps."""
    strengths = np.minimum(np.arange(generations) / by, 1.0) * 2.0
    return drawn(race(strengths, strengths), episodes, seed)


@pytest.mark.parametrize("by", [1, 3])
def test_teams_that_learn_at_once_are_told_from_teams_that_learn_nothing(by):
    judgement = of_scores(learned_at_once(31, by))
    assert analysis.sentence(judgement).startswith("Both teams learned ")
    for lead in judgement.leads.values():
        assert lead.size.low > 0.2
        assert lead.reached in (by, by + 1)
    named = "in generation 1" if by == 1 else "by generation "
    assert named in analysis.sentence(judgement)
    nothing = of_scores(drawn(np.full((31, 31), 0.5)))
    assert "learned" not in analysis.sentence(nothing)
    together = of_scores(np.stack([learned_at_once(31, 2, seed) for seed in range(5)]))
    assert analysis.sentence(together).startswith("On average over 5 runs, both teams learned by ")


def learned(lead):
    return lead.reached is not None and lead.size.low > 0.05


@pytest.mark.parametrize("episodes", [2, 5])
def test_races_in_which_nobody_learns_are_seldom_said_to_learn(episodes):
    draws = np.random.default_rng(5)
    wrong = 0
    for seed in range(200):
        # Generations differ, and so do pairs; generation 0 is like all others.
        strengths = draws.normal(0.0, 0.7, (2, 12))
        chance = expit(np.subtract.outer(*strengths) + draws.normal(0.0, 0.3, (12, 12)))
        payoffs = analysis.read_payoffs(drawn(chance, episodes, seed), per_episode=True)
        wrong += any(learned(lead) for lead in leads_of(payoffs).values())
    assert wrong <= 6  # of 200


@pytest.mark.parametrize("step", [0.1, 0.3])
@pytest.mark.parametrize("generations", [12, 31])
def test_a_walk_is_seldom_said_to_have_learned_early(step, generations):
    draws, wrong = np.random.default_rng(7), 0
    for seed in range(100):
        walks = draws.normal(0.0, step, (2, generations)).cumsum(axis=1)
        payoffs = analysis.read_payoffs(drawn(race(*walks), 10, seed), per_episode=True)
        wrong += any(learned(lead) for lead in leads_of(payoffs).values())
    assert wrong <= 15  # 3 to 9 of 100 are usual


def test_leads_in_words():
    def said(reached, low=0.4, **found):
        lead = Lead(Estimate(0.5, low, 0.6), reached)
        leads = {"pursuers": lead, "evaders": lead}
        return analysis.sentence(replace(when(**found), leads=leads))

    better = "No clear progress, but both teams are better than in generation 0 (0.50 and 0.50)."
    learned = "Both teams learned by generation 3 (0.50 and 0.50 better than generation 0)"
    assert said(None, arms="?") == better
    assert said(None, 0.04, arms="?") == "No clear progress."
    assert said(3, arms="?") == f"{learned}; after that no clear progress."
    still = "neither team ended stronger or weaker."
    assert said(3, stagnation="w") == f"{learned}; after that {still}"
    assert said(3, stagnation="l", arms="?") == f"{learned}. From generation 15 on, {still}"
    assert said(3, stagnation="f", arms="?") == f"{learned}; after that no clear progress."
    assert said(3, arms="wfl", rise="w") == "Both teams improved."


def test_of_few_runs_each_has_to_show_what_was_learned():
    flat = drawn(np.full((31, 31), 0.5), 20, 1)
    one, two = learned_at_once(31, 1), learned_at_once(31, 4, seed=2)
    assert analysis.sentence(of_scores(np.stack([one, two]))).startswith(
        "In each of 2 runs, both teams learned by generation "
    )
    assert "learned" not in analysis.sentence(of_scores(np.stack([one, flat])))


def test_a_team_that_falls_after_it_has_learned_did_not_stand_still():
    strengths = np.r_[0.0, np.full(15, 2.0), np.full(15, 1.4)]
    said = analysis.sentence(of_scores(drawn(race(strengths, strengths), 40)))
    assert "Until" not in said


FIRST, LAST = "first half", "last half"
TEAMS = {"arms race": [BOTH], "one-sided progress": [BOTH[:1], BOTH[1:]]}
TEAMS |= {name: [BOTH, BOTH[:1], BOTH[1:]] for name in ("rise", "cycling", "forgetting")}
ANY_FINDINGS = st.fixed_dictionaries({
    name: st.sampled_from(
        [(ABSENT, ()), (CANNOT_TELL, ()), *((PRESENT, who) for who in TEAMS.get(name, [()]))]
    )
    for name in CONDITIONS
})  # fmt: skip
TOLD = {
    "disengagement": "won nearly all", "stagnation": "stronger or weaker",
    "rise": "ended stronger", "arms race": "both teams improved", "one-sided progress": "only ",
    "cycling": "went back", "intransitivity": "no order", "forgetting": "lost old skills",
}  # fmt: skip


@settings(max_examples=150, deadline=None)
@given(st.fixed_dictionaries(dict.fromkeys(WINDOWS, ANY_FINDINGS)))
def test_a_sentence_tells_what_is_present_and_nothing_else(found):
    said = analysis.sentence(with_verdicts(found)).lower()
    present = {n for each in found.values() for n, one in each.items() if one[0] == PRESENT}
    improved = {t for each in found.values() for n in PROGRESS[:2] for t in each[n][1]}
    if present & {*PROGRESS[:2]} and all(improved >= {*each["rise"][1]} for each in found.values()):
        present.discard("rise")
    if present & {"cycling", "forgetting"}:
        present.discard("intransitivity")
    told = said.replace("ended stronger or weaker", "stronger or weaker")
    assert {name for name, words in TOLD.items() if words in told} == present
    if "in generations 0 to 14, both teams improved" in said:
        assert found[FIRST]["arms race"][0] == PRESENT
        assert found[LAST]["arms race"][0] != PRESENT
    assert ("no clear progress" in said) <= (not present & {"arms race", "one-sided progress"})


# ---- What a judgement must not be fooled by ----------------------------------------------------


@pytest.mark.parametrize("runs", [2, 3])
@pytest.mark.parametrize("others", [FLAT, race(-0.015 * G, -0.015 * G)])
def test_one_seed_does_not_decide_for_two_or_three(runs, others):
    chances = [STEADY, *[others] * (runs - 1)]
    group = of_scores(np.stack([drawn(each, 10, s, evaders=30) for s, each in enumerate(chances)]))
    for findings in group.windows.values():
        assert PRESENT not in [findings[name].verdict for name in PROGRESS]
    assert f"that all {runs} runs share (in 1 of them, both" in analysis.sentence(group)
    alike = of_scores(np.stack([drawn(STEADY, 10, seed, evaders=30) for seed in range(runs)]))
    assert analysis.sentence(alike) == f"In each of {runs} runs, both teams improved."


@pytest.mark.parametrize("episodes", [2, 5, 10, 20])
def test_a_race_that_one_team_wins_is_disengaged_at_any_number_of_episodes(episodes):
    judgement = of_scores(np.ones((16, 16, episodes)))
    assert analysis.sentence(judgement) == "The pursuers won nearly all matches."
    for window in WINDOWS:
        assert judgement.present(window) == ("disengagement",)


@pytest.mark.parametrize("turns", [0.5, 0.75, 1.0, 1.5])
def test_a_circle_that_is_not_complete_is_no_progress(turns):
    """Two equal episodes, or one matrix of a game without chance."""
    angles = 2 * np.pi * turns * np.arange(31) / 30
    disc = 0.5 + 0.45 * np.sin(np.subtract.outer(angles, angles))
    for judgement in (of_scores(np.repeat(disc[..., None], 2, 2)), judge(disc)):
        for window in WINDOWS:
            assert not {*PROGRESS[:2]} & {*judgement.present(window)}


def test_every_episode_twice_changes_nothing():
    for chance in (STEADY, circular(31), SLOW):
        scores = drawn(chance, 6)
        once, twice = of_scores(scores), of_scores(np.concatenate([scores, scores], axis=2))
        assert once.episodes == twice.episodes == 6
        assert [*map(verdicts, [once] * 3, WINDOWS)] == [*map(verdicts, [twice] * 3, WINDOWS)]


def test_smooth_curves_are_seldom_called_progress():
    """Single runs: no more than one in ten, over all windows."""
    times, called = np.arange(31) / 30, 0
    spread = np.exp(-0.5 * (np.subtract.outer(times, times) / 0.4) ** 2) + 1e-9 * np.eye(31)
    for seed in range(20):
        curves = np.linalg.cholesky(spread) @ np.random.default_rng(seed).normal(size=(31, 2))
        judgement = of_scores(drawn(race(*curves.T), 10, seed, evaders=30))
        called += any({*PROGRESS[:2]} & {*judgement.present(window)} for window in WINDOWS)
    assert called <= 2


@settings(max_examples=10, deadline=None)
@given(
    arrays.arrays(
        np.float64,
        arrays.array_shapes(min_dims=3, max_dims=3, min_side=1, max_side=14),
        elements=st.integers(0, 4).map(lambda n: n / 4),
    )
)
def test_every_matrix_has_a_judgement(scores):
    judgement = of_scores(scores)
    for part in judgement.windows.values():
        assert set(part) == set(CONDITIONS)
        for finding in part.values():
            assert finding.verdict in (PRESENT, ABSENT, CANNOT_TELL)
            for estimate in finding.estimates.values():
                assert estimate.low is None or estimate.low <= estimate.high
    json.dumps(judgement.to_json(), allow_nan=False)
