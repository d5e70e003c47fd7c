"""What is said of a race: sentences, reasons, tables and groups agree, on many races and groups."""

import re
from functools import cache
from itertools import product

import numpy as np
import pytest
from scipy.special import expit

from matrices import circular
from matrixworld import analysis
from matrixworld.analysis import judge, sentence
from matrixworld.analysis.judgement import (
    ABSENT,
    BOTH_HALVES,
    CANNOT_TELL,
    HALVES,
    PRESENT,
    PROGRESS,
    WHOLE,
)
from matrixworld.analysis.measures import MEASURES

TEAMS = ("pursuers", "evaders")
T = np.linspace(0.0, 1.0, 16)


def race(pursuers, evaders):
    """Return the capture rates of teams of these strengths."""
    return expit(np.subtract.outer(pursuers, evaders))


def drawn(chance, episodes, rng):
    """Return the shares of ten evaders that are captured, each with these chances."""
    chances = np.repeat(np.clip(chance, 0.0, 1.0)[..., None], episodes, axis=-1)
    return rng.binomial(10, chances) / 10.0


def steep(at):
    return 4.0 * expit((T - at) / 0.04) + T


def failing(rng):
    return 4.0 * T - 3.0 * (rng.random(len(T)) < 0.15)


def walk(rng):
    return rng.normal(0.0, 0.25, len(T)).cumsum()


KINDS = {
    "race": lambda rng: race(3.0 * T, 3.0 * T),
    "slow race": lambda rng: race(0.6 * T, 2.0 * T),
    "steep and even": lambda rng: race(steep(rng.uniform(0.4, 0.6)), 2.0 * T),
    "steep at times": lambda rng: race(steep(rng.uniform(0.2, 0.8)), steep(rng.uniform(0.2, 0.8))),
    "one team": lambda rng: race(2.0 * T, 0.0 * T),
    "still": lambda rng: np.full((16, 16), 0.4),
    "walks": lambda rng: race(walk(rng), walk(rng)),
    "failing": lambda rng: race(failing(rng), failing(rng)),
    "circle": lambda rng: circular(16),
    "circle on a climb": lambda rng: np.clip(circular(16) + race(2.0 * T, 2.0 * T) - 0.5, 0.0, 1.0),
    "race, then still": lambda rng: race(4.0 * np.minimum(T, 0.5), 4.0 * np.minimum(T, 0.5)),
    "rise and fall": lambda rng: race(np.minimum(4.0 * T, 4.0 - 4.0 * T), 2.0 * T),
    "won": lambda rng: np.full((16, 16), 0.995),
    "random cells": lambda rng: rng.random((16, 16)),
    "short": lambda rng: race(2.0 * T, 2.0 * T)[:7, :7],
    "too short": lambda rng: race(2.0 * T, 2.0 * T)[:5, :5],
    "ones and zeros": lambda rng: rng.integers(0, 2, (16, 16)).astype(float),
    "long and short side": lambda rng: race(3.0 * T, 3.0 * T)[:, :8],
}
EPISODES = {"few": 2, "many": 60}


def scores_of(kind, episodes, runs, seed):
    rng = np.random.default_rng([seed, runs])
    return np.stack([drawn(KINDS[kind](rng), EPISODES[episodes], rng) for _ in range(runs)])


def of_scores(scores):
    return judge(scores[0] if len(scores) == 1 else scores, per_episode=True)


@cache
def judged(group):
    return of_scores(scores_of(*group))


GROUPS = [
    (*each, seed) for seed, each in enumerate(product(KINDS, EPISODES, (1, 1, 2, 3, 5)))
]  # fmt: skip


def explained(judgement):
    """Return the reasons of conditions by condition and window."""
    found = {}
    for line in analysis.explain(judgement).splitlines():
        head, told = line.split(": ", 1)
        name, _, half = head.lower().removesuffix(")").partition(" (")
        found[name, half or WHOLE] = told
    return found


def teams_in(text):
    return {team for team in TEAMS if team in text or "both teams" in text.lower()}


SUBJECT = r"(only the (?:pursuers|evaders)|the (?:pursuers|evaders)|both teams|neither team) "


def told_of(said, did):
    """Return the windows and teams of which a sentence says that they did something."""
    found = []
    for clause in re.split(r"\. ?", said.lower()):
        part = BOTH_HALVES if "in both halves" in clause else WHOLE
        half = re.search(r"(?:^|runs, )(until|from|in generations 0 to) ", clause)
        if half:
            part = HALVES[half[1] == "from"]
        who = None
        # Who did what first is the subject of what follows.
        for subject, verb in re.findall(rf"(?:{SUBJECT})?(improved|ended stronger(?! or))", clause):
            who = subject or who
            if verb == did and who != "neither team":
                found.append((part, teams_in(who)))
    return found


@pytest.mark.parametrize("kind", KINDS)
def test_sentences_reasons_and_tables_agree(kind):
    for group in (one for one in GROUPS if one[0] == kind):
        judgement = judged(group)
        said, reasons = sentence(judgement), explained(judgement)
        for name, verdict, numbers, window in analysis.judgement_table(judgement)[1:]:
            if verdict == "told":
                continue
            window = WHOLE if window == "whole race" else window
            assert reasons[name, window].startswith(f"{verdict}, because ")
            finding = judgement.windows[window][name]
            assert verdict == finding.verdict
            if verdict == ABSENT:
                assert CANNOT_TELL not in numbers
            if verdict == PRESENT and finding.teams:
                assert teams_in(reasons[name, window]) >= {*finding.teams}
        for part, teams in told_of(said, "improved"):
            for window in HALVES if part == BOTH_HALVES else [part]:
                findings = judgement.windows[window]
                improved = [findings[name].teams for name in PROGRESS if name in findings]
                assert {team for one in improved for team in one} == teams
                if ("rise", window) in reasons:
                    assert teams_in(reasons["rise", window]) >= teams
        for part, teams in told_of(said, "ended stronger"):
            for window in HALVES if part == BOTH_HALVES else [part]:
                assert {*judgement.windows[window]["rise"].teams} == teams


@pytest.mark.parametrize("kind", KINDS)
def test_each_of_a_few_runs_shows_what_the_group_is_said_to_show(kind):
    for group in (one for one in GROUPS if one[0] == kind and 1 < one[2] < 4):
        together = judged(group)
        singles = [of_scores(run[None]) for run in scores_of(*group)]
        for window, findings in together.windows.items():
            for name, finding in findings.items():
                alone = [single.windows[window][name] for single in singles]
                assert finding.by_run == tuple(one.verdict for one in alone)
                if finding.verdict != CANNOT_TELL:
                    assert {one.verdict for one in alone} == {finding.verdict}
                assert all({*finding.teams} <= {*one.teams} for one in alone)
                assert bool(finding.teams) == (
                    finding.verdict == PRESENT and all(one.teams for one in alone)
                )


def test_the_verdict_on_a_seed_is_that_of_its_own_card():
    scores = np.concatenate([scores_of("race, then still", "many", 3, 1)] * 2)
    together = of_scores(scores)
    for run, scores_of_run in enumerate(scores):
        alone = of_scores(scores_of_run[None])
        for window, findings in together.windows.items():
            assert {n: f.by_run[run] for n, f in findings.items()} == {
                name: finding.verdict for name, finding in alone.windows[window].items()
            }


def test_a_team_that_improved_unevenly_is_named_in_the_reason():
    rng = np.random.default_rng(0)
    judgement = of_scores(drawn(race(steep(0.5), 2.0 * T), 60, rng)[None])
    assert sentence(judgement) == "Both teams improved."
    assert explained(judgement)["rise", WHOLE].startswith(
        "present, because both teams ended stronger: by more than 0.05"
    )


def test_a_jump_is_named_beside_a_steady_rise():
    rng = np.random.default_rng(0)
    jump = np.where(T > 0.5, 2.0, 0.0)
    judgement = of_scores(drawn(race(jump, 2.0 * T), 60, rng)[None])
    assert sentence(judgement).startswith(
        "The evaders ended stronger (the pursuers, too, but mostly in a jump or with a setback)."
    )
    assert explained(judgement)["rise", WHOLE].startswith(
        "present, because the evaders ended stronger (the pursuers, too, but mostly in a jump or "
        "with a setback): by more than 0.05 in this race"
    )


@pytest.mark.parametrize("runs", [1, 5])
def test_a_last_generation_that_fails_is_told(runs):
    rng = np.random.default_rng(1)
    weak = np.r_[3.0 * T[:-1], 0.0]
    scores = np.stack([drawn(race(weak, 3.0 * T), 60, rng) for _ in range(runs)])
    said = sentence(of_scores(scores))
    where = "The" if runs == 1 else "In 5 of 5 runs, the"
    assert f"{where} last generation of the pursuers is far weaker than those before." in said
    assert "last generation of the evaders" not in said


def test_intervals_stay_inside_the_bounds_of_their_measures():
    for group in GROUPS:
        judgement = judged(group)
        for findings in judgement.windows.values():
            for finding in findings.values():
                for name, estimate in finding.estimates.items():
                    least, most = MEASURES[name].bounds
                    if estimate.low is not None:
                        assert least <= estimate.low <= estimate.high <= most, (name, estimate)
        for lead in judgement.leads.values():
            assert lead.size.low is None or -1.0 <= lead.size.low <= lead.size.high <= 1.0


def test_a_team_that_learned_to_beat_one_opponent_is_named():
    rng = np.random.default_rng(3)
    chance = np.full((40, 40), 0.2)
    chance[20:, 7] = 0.65
    judgement = of_scores(drawn(chance, 60, rng)[None])
    said = (
        "neither team ended stronger or weaker, but the pursuers learned to beat the evaders of "
        "generation 7"
    )
    assert said in sentence(judgement).lower()
    assert said in explained(judgement)["stagnation", WHOLE]
    chance[20:, 9] = 0.65
    scores = np.stack([drawn(chance, 60, rng) for _ in range(3)])
    for one, team, opponents in (
        (scores[:1], "pursuers", "evaders"),
        (1.0 - scores[:1].swapaxes(1, 2), "evaders", "pursuers"),
        (scores, "pursuers", "evaders"),
    ):
        beaten = f"the {team} learned to beat 2 generations of {opponents}"
        assert beaten in sentence(of_scores(one))


@pytest.mark.parametrize("episodes", [10, 60])
def test_teams_are_seldom_said_to_learn_to_beat_one_opponent_by_chance(episodes):
    told = 0
    for seed in range(60):
        rng = np.random.default_rng(seed)
        luck = rng.normal(0.0, 0.03, (2, 16))
        chance = race(*luck) + rng.normal(0.0, 0.05, (16, 16))
        told += "learned to beat" in sentence(of_scores(drawn(chance, episodes, rng)[None]))
    assert told <= 2


def test_what_is_present_in_both_halves_is_not_said_of_the_whole_race():
    rng = np.random.default_rng(0)
    jump = np.where(np.arange(24) < 12, 0.0, 1.0)
    judgement = of_scores(drawn(race(jump, 0.0 * jump), 60, rng)[None])
    assert judgement.findings["stagnation"].verdict == ABSENT
    assert "In both halves, neither team ended stronger or weaker" in sentence(judgement)


def test_words_for_one_idea():
    """Teams improved, or ended stronger; nothing else says so."""
    for group in GROUPS:
        judgement = judged(group)
        text = f"{sentence(judgement)} {analysis.explain(judgement)}"
        for word in ("became", "trend", "not known", "rises", "rose"):
            assert word not in text, (group, text)
