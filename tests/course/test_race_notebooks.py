"""Notebooks 3 to 9: what their texts say of learning, races and results that are kept is true."""

import ast
import inspect
import runpy
from itertools import combinations, permutations, product
from typing import Any

import numpy as np
import pytest

import matrixworld as mw
from course import UnansweredError, chapter_3, chapter_10, check, kept, toys
from course.chapter_5 import four_races, noisy_race
from course.chapter_6 import ROCK_PAPER_SCISSORS, WELL
from course.chapter_7 import UNKNOWN, is_disengaged, reveal, unknown_races, verdict_of
from course.chapter_8 import verdict_on
from course.chapter_9 import (
    BRISK,
    WEIGHTS,
    WORLD,
    break_even,
    mask_of,
    pack,
    play_masked,
    right_of_way,
)
from course.synthetic_races import play_episodes
from matrixworld import analysis, coevolution, plots
from matrixworld.coevolution import competitive_sharing, reduced_virulence
from notebooks import NOTEBOOKS, TUTORIALS, cells, source
from student_functions import STEPS, gains, last_beats_first, left_waits
from student_functions import right_of_way as as_on_a_road

# ---- Notebook 3 ----------------------------------------------------------------------------------


@pytest.mark.parametrize("seed", range(3))
@pytest.mark.parametrize(
    "size", [{}, {"rows": 5, "cols": 5, "max_steps": 30}, {"n_pursuers": 1, "n_evaders": 9}]
)
def test_the_match_step_by_step_is_that_of_rollout(seed: int, size: dict) -> None:
    """For other networks and other worlds than those of the notebook."""
    fields = {"rows": 12, "cols": 12, "n_pursuers": 3, "n_evaders": 6, "fov": 5, "max_steps": 60}
    world = mw.WorldConfig("O", **{**fields, **size})
    network = mw.Network.for_config(world, (8,), sampled=False)
    names = {"mw": mw, "world": world, "network": network}
    for text in map(source, cells(NOTEBOOKS[2], "code")):
        if text.startswith("def play("):
            exec(text, names)
    genome = network.initial(np.random.default_rng(seed), 0.3, 0.5)
    team = mw.Population(genome, network)
    matches = mw.Matches.of(0, 0, np.arange(12))
    statistics = mw.rollout(world, team, "random", matches)
    for match in range(12):
        moves = mw.record(world, team, "random", seed=match).actions[:, world.n_pursuers :]
        found = names["play"](genome, match, moves)
        assert found == (statistics.capture_rate[match, 0], statistics.length[match, 0])


@pytest.mark.parametrize("function", [chapter_3.make_toolbox, chapter_3.evolve])
def test_the_notebook_shows_what_the_package_does(function: Any) -> None:
    """Its text has the code of the package, without the types."""
    begin = f"def {function.__name__}("
    text = "".join(source(cell) for cell in cells(NOTEBOOKS[2], "markdown"))
    shown = begin + text.split(begin)[1].split("```")[0]
    assert without_types(shown) == without_types(inspect.getsource(function))


def without_types(code: str) -> str:
    tree = ast.parse(code)
    for node in ast.walk(tree):
        if isinstance(node, ast.FunctionDef):
            node.returns = None
        elif isinstance(node, ast.arg):
            node.annotation = None
    return ast.unparse(tree)


# ---- Notebook 4 ----------------------------------------------------------------------------------


def test_the_red_queen_in_the_kept_races() -> None:
    saved = kept("chapter_4")
    races = saved["captured"] / saved["evaders_met"]
    when = saved["generations"].tolist()
    assert races.shape == (10, 25, 25)
    assert (races.min(), races.max()) >= (0, 0)
    assert races.max() <= 1
    diagonal = np.array([np.diag(race) for race in races])[:, when]

    def change(scores: np.ndarray, begin: int, end: int) -> analysis.Estimate:
        found = scores[:, when.index(end)] - scores[:, when.index(begin)]
        return analysis.interval_over_runs(found.astype(float))

    whole = change(diagonal, 0, 24)
    assert whole.low < 0 < whole.high
    assert change(diagonal, 0, 6).high < 0 < change(diagonal, 6, 24).low
    assert change(saved["pursuer"], 0, 24).low > 0
    assert change(saved["evader"], 0, 24).low > 0
    assert change(saved["evader"], 0, 6).low > 0
    later = change(saved["evader"], 6, 24)
    assert later.low < 0 < later.high
    assert change(saved["pursuer"], 6, 24).low > 0
    assert (saved["evader"][:, -1] > saved["evader"][:, 0]).all()


# ---- Notebook 5 ----------------------------------------------------------------------------------

SCHEDULES = ("specialist_specialist", "generalist_specialist", "generalist_generalist")


@pytest.fixture(scope="module")
def scores() -> dict[str, np.ndarray]:
    races = kept("paper_races")
    return {name: races[name] / int(races["evaders"]) for name in SCHEDULES}


def test_the_four_races_are_what_the_solution_says() -> None:
    rises = {
        letter: [curve[-6:].mean() - curve[-15:-9].mean() > 0.05 for curve in curves]
        for letter, race in four_races().items()
        if (curves := analysis.generalization(race.mean(axis=2)))
    }
    assert rises == {
        "A": [False, True], "B": [False, False], "C": [True, True], "D": [False, False]
    }  # fmt: skip


def test_generalists_of_the_package_meet_these_opponents() -> None:
    sampler = coevolution.SCHEDULES["generalist-generalist"].new_sampler("evader")
    rng = np.random.default_rng(0)

    def met(k: int, i: int) -> int:
        return int(sampler.sample(coevolution.available("evader", k), i, rng)[0])

    assert check("5.2", met).right


def verdict(scores: np.ndarray, condition: str) -> str:
    return analysis.judge(scores, per_episode=True).headline[condition].verdict


def test_specialists_beat_the_newest_evaders_and_forget() -> None:
    lost = gains("specialist_specialist")
    assert np.count_nonzero(lost < -0.04) == 8
    assert np.count_nonzero(np.abs(lost) < 0.01) == 2
    assert (gains("generalist_generalist") > 0.0).all()


@pytest.mark.parametrize(
    ("schedule", "race", "cycling"),
    [
        ("specialist_specialist", "cannot tell", "present"),
        ("generalist_specialist", "present", "absent"),
        ("generalist_generalist", "present", "absent"),
    ],
)
def test_verdicts_on_ten_seeds(
    scores: dict[str, np.ndarray], schedule: str, race: str, cycling: str
) -> None:
    found = analysis.judge(scores[schedule], per_episode=True).headline
    assert (found["arms race"].verdict, found["cycling"].verdict) == (race, cycling)
    if schedule == "generalist_specialist":
        assert found["arms race"].by_run.count("present") == 1
        assert found["arms race"].by_run.count("cannot tell") == 9
    if schedule == "specialist_specialist":
        assert found["intransitivity"].by_run.count("present") == 9
        assert found["cycling"].by_run.count("present") == 5
        assert found["forgetting"].by_run.count("present") == 10


def test_three_seeds_could_not_tell(scores: dict[str, np.ndarray]) -> None:
    assert verdict(scores["generalist_generalist"][:3], "arms race") == "cannot tell"
    assert verdict(scores["generalist_generalist"][:5], "arms race") == "present"
    assert verdict(scores["generalist_generalist"][:5], "intransitivity") == "cannot tell"


def test_the_simple_rule_is_fooled_by_one_race_of_four() -> None:
    alarms = [last_beats_first(noisy_race("noise only, .5", seed)) for seed in range(200)]
    assert 0.15 < np.mean(alarms) < 0.35  # the text says: one of four


def test_specialists_have_more_checkerboards(scores: dict[str, np.ndarray]) -> None:
    measure = analysis.MEASURES["checkerboards"].of
    specialists, mixed = (
        [measure(matrix).value for matrix in scores[name].mean(axis=3)] for name in SCHEDULES[:2]
    )
    difference = analysis.difference_of_runs(mixed, specialists)
    assert difference.high < 0.0


# ---- Notebook 6 ----------------------------------------------------------------------------------


def test_noise_lowers_the_transitive_share_and_the_correction_removes_the_bias() -> None:
    strength = np.linspace(-1, 1, 16)
    truth = 0.5 + 0.2 * np.subtract.outer(strength, strength)
    shares = []
    for seed in range(20):
        race = play_episodes(truth, 1, np.random.default_rng(seed))
        shares.append(analysis.transitive_share(race.mean(axis=2)))
    assert np.mean(shares) < 0.4  # though the truth is 1: a single episode is nearly all noise
    corrected = [
        analysis.transitive_share_over_episodes(
            play_episodes(truth, 10, np.random.default_rng(seed))
        ).value
        for seed in range(20)
    ]
    assert np.mean(corrected) == pytest.approx(1.0, abs=0.06)


def test_alpha_rank_looks_at_directions_and_nash_at_stakes() -> None:
    weighted = ROCK_PAPER_SCISSORS.copy()
    weighted[2, 1], weighted[1, 2] = 0.6, 0.4
    assert analysis.alpha_rank(weighted).pursuers == pytest.approx(np.full(3, 1 / 3), abs=1e-3)
    assert analysis.nash_averaging(weighted).pursuers[0] < 0.1
    assert analysis.nash_averaging(WELL).pursuers[0] == pytest.approx(0.0, abs=1e-6)
    assert analysis.alpha_rank(WELL).pursuers[0] > 0.1


def test_what_halls_of_fame_changed() -> None:
    ends = {
        name: analysis.difference_of_runs(with_halls, without, paired=True)
        for name, (without, with_halls) in kept("halls").items()
    }
    for name in ("pursuer_forgetting", "evader_forgetting", "checkerboards"):
        assert ends[name].high < 0.0
    assert ends["pursuer_score"].low > 0.0
    assert ends["evader_score"].low < 0.0 < ends["evader_score"].high


def test_the_numbers_game_shows_no_help() -> None:
    living, with_hall = kept("numbers_game")["ones"]
    difference = analysis.difference_of_runs(with_hall, living)
    assert difference.low < 0.0 < difference.high


def test_what_the_small_races_show() -> None:
    cures = kept("cures")
    names = [str(name) for name in cures["samplers"]]
    rates = dict(zip(names, cures["captured"] / int(cures["evaders"]), strict=True))
    specialists = analysis.judge(rates["latest"], per_episode=True).headline
    assert specialists["forgetting"].verdict == "present"
    assert specialists["cycling"].verdict == "cannot tell"
    generalists = analysis.judge(rates["round-robin"], per_episode=True).headline
    assert generalists["cycling"].verdict == "absent"
    # Beyond those of training: archives play matches of their own.
    extra = cures["matches"].mean(axis=1) / 38_400 - 1
    assert (extra[:3] == 0.0).all()
    assert (extra[3:] > 0.01).all()
    assert (extra[3:] < 0.04).all()


def test_the_specialists_evaders_escape_most_often() -> None:
    cures = kept("cures")
    cross = cures["cross_play"] / int(cures["cross_evaders"])
    others = ~np.eye(len(cross), dtype=bool)  # nobody is examined by those it learned with
    escape = [1 - cross[others[i], :, i].mean(axis=(0, 1)) for i in range(len(cross))]
    ends = [analysis.interval_over_runs(each) for each in escape]
    assert np.argmax([each.value for each in ends]) == 0
    assert all(ends[i].high < ends[0].low for i in (1, 2))


# ---- Notebook 7 ----------------------------------------------------------------------------------


def test_four_of_five_wins_are_as_good_as_five_up_to_nine_tenths() -> None:
    four, five = reduced_virulence([4, 5], 0.9)
    assert four == pytest.approx(five)
    same = [toys.hosts_and_parasites(v, 0, generations=60).ones for v in (1.0, 0.95)]
    assert np.array_equal(*same)


def test_a_rare_winner_is_rarely_a_parent() -> None:
    wins = np.zeros((20, 10))
    wins[:19, :9], wins[19, 9] = 1.0, 1.0
    for fitness, chance in ((wins.sum(axis=1), 0.11), (competitive_sharing(wins), 0.88)):
        assert 1 - (1 - fitness[19] / fitness.sum()) ** 20 == pytest.approx(chance, abs=0.005)


def test_the_races_to_judge_are_of_both_sorts_and_need_many_episodes() -> None:
    truths = [is_disengaged(*each) for each in UNKNOWN]
    assert sum(truths) == 4
    few, many = ([verdict_of(race) for race in unknown_races(episodes)] for episodes in (10, 50))
    assert "present" not in few
    assert [verdict == "present" for verdict in many] == truths


def test_the_truth_is_shown_beside_the_verdicts() -> None:
    races = unknown_races(episodes=4)
    right = ["yes" if is_disengaged(*each) else "no" for each in UNKNOWN]
    assert "0 false alarms" in reveal(right, races)
    assert "and 0 of 4 disengaged ones missed" in reveal(right, races)
    swapped = ["no" if each == "yes" else "yes" for each in right]
    assert "4 false alarms" in reveal(swapped, races)
    assert "and 4 of 4" in reveal(swapped, races)
    for wrong in (..., "yes", ["yes"], ["maybe"] * 8):
        with pytest.raises(UnansweredError):
            reveal(wrong, races)


def test_the_kept_races_show_what_the_notebook_says() -> None:
    stored = kept("chapter_7")
    shape = (10, 15, 15, 30)
    kinds = ("even", "few evader epochs", "no overlap penalty", "restrained pursuers")
    assert all(stored[f"captured: {kind}"].shape == shape for kind in kinds)
    present = {}
    for kind in kinds:
        found = analysis.judge(stored[f"captured: {kind}"] / stored["evaders"], per_episode=True)
        verdicts = found.windows["last half"]["disengagement"].by_run
        present[kind] = verdicts.count("present")
    assert present["few evader epochs"] >= 7  # of 10 seeds
    assert 5 <= present["restrained pursuers"] <= 8
    assert max(present["even"], present["no overlap penalty"]) <= 2
    assert stored["has not: disengagement"][0] == 0


# ---- Notebook 8 ----------------------------------------------------------------------------------


def test_the_numbers_of_the_paper_are_those_of_the_results() -> None:
    """Run ``tutorials/make/chapter_8_paper.py`` and ``tutorials/run.py 08`` if it fails."""
    derived = runpy.run_path(str(TUTORIALS / "make" / "chapter_8_paper.py"))["derived"]()
    stored = kept("chapter_8_paper")
    assert set(stored) == set(derived)
    for name, values in derived.items():
        assert np.array_equal(stored[name], values), name


def test_one_seed_decides_nothing() -> None:
    assert verdict_on([0.9], [0.1]) == "cannot tell"


def test_the_kept_teams_show_what_the_predictions_say() -> None:
    stored = kept("chapter_8")
    kinds = list(stored["evaders: kinds"])
    hunter = list(stored["evaders: opponents"]).index("hunter")
    against_hunters = dict(zip(kinds, stored["evaders: scores"][..., hunter] / 1000, strict=True))
    for other in ("easy to hard", "hard to easy", "random only"):
        assert verdict_on(against_hunters["hardest only"], against_hunters[other]) == "better"
    against_walkers = stored["pursuers: ladder"][:, :, 0] / 1000
    assert verdict_on(against_walkers[:, 4], against_walkers[:, 1]) == "worse"


def test_who_is_better_depends_on_the_examiner() -> None:
    stored = kept("chapter_8")
    one, other = (list(stored["evaders: kinds"]).index(n) for n in ("co-evolution", "easy to hard"))
    scripts = stored["evaders: scores"][..., :4].mean(axis=2) / 1000
    races = stored["evaders: against races"] / 1000
    others = ~np.eye(races.shape[1], dtype=bool)
    strangers = np.array(
        [[row[own].mean() for row, own in zip(r, others, strict=True)] for r in races]
    )
    assert verdict_on(scripts[one], scripts[other]) == "worse"
    assert verdict_on(strangers[one], strangers[other]) == "better"


def test_the_concepts_are_drawn() -> None:
    texts = {text.get_text() for text in plots.learning_concepts().axes[0].texts}
    assert {"co-evolution", "curriculum learning", "arms race", "adversarial learning"} <= texts


# ---- Notebook 9: safety --------------------------------------------------------------------------


def everything(views: np.ndarray) -> np.ndarray:
    return np.ones((len(views), WORLD.n_actions), bool)


def test_the_brisk_pack_captures_and_is_safe_in_most_episodes() -> None:
    played = play_masked(BRISK, everything, episodes=300, seed=5)
    assert played.captured.mean() > 0.95
    assert (played.safety.summary().safe_share[0] > 0.6).all()
    assert 8 < break_even() < 12


def test_conventions_that_stop_no_group_are_the_orders_of_the_moves() -> None:
    """Of the 64 in which exactly one of two goes first."""
    moves = range(1, 5)
    pairs = [*combinations(moves, 2)]
    orders = {tuple(o.index(a) < o.index(b) for a, b in pairs) for o in permutations(moves)}
    for firsts in product((True, False), repeat=len(pairs)):
        table = dict(zip(pairs, firsts, strict=True))
        table |= {(b, a): not first for (a, b), first in table.items()}
        reply = check("9.4", lambda own, other, table=table: table[own, other])
        assert reply.right is (firsts in orders)
        assert reply.right or "exactly one goes first, so nobody collides" in reply.text


def test_the_mask_of_the_package_is_that_of_right_before_left() -> None:
    views = (np.random.default_rng(0).random((2000, 3, 11, 11)) < 0.1).astype(np.uint8)
    np.testing.assert_array_equal(right_of_way(views), mask_of(as_on_a_road)(views))


def test_nobody_is_at_fault_where_one_of_two_goes_first() -> None:
    greedy = [6, 20, 0, 0, 0, 0]
    for convention in (
        as_on_a_road,
        lambda own, other: own < other,
        lambda own, other: own > other,
    ):
        masked = play_masked(greedy, mask_of(convention), episodes=100, seed=92)
        assert not masked.safety.summary().fault_rate[0].any()
    both_go = play_masked(greedy, mask_of(left_waits), episodes=100, seed=92)
    assert both_go.safety.summary().fault_rate[0, 1] > 0


@pytest.fixture(scope="module")
def runs() -> dict[str, np.ndarray]:
    return dict(kept("safe_packs"))


def shares(runs: dict[str, np.ndarray], name: str) -> tuple[np.ndarray, np.ndarray]:
    """Return the shares of episodes with a capture, and of unsafe ones, of each run."""
    episodes = runs["episodes"]
    return runs[f"{name}_captured"] / episodes, 1 - runs[f"{name}_safe"] / episodes


def test_at_every_penalty_runs_that_capture_collide(runs: dict[str, np.ndarray]) -> None:
    for number in range(len(runs["penalties"])):
        captured, unsafe = shares(runs, f"penalty{number}")
        assert (unsafe[captured > 0.5] > 0).all()


def test_a_high_penalty_makes_two_kinds_of_runs(runs: dict[str, np.ndarray]) -> None:
    captured, _ = shares(runs, "penalty5")
    assert runs["penalties"][5] == 12
    assert (captured < 0.05).sum() >= 3
    assert (captured > 0.9).sum() >= 3
    without, _ = shares(runs, "penalty0")
    assert (without > 0.5).all()


def test_masks_rule_collisions_out(runs: dict[str, np.ndarray]) -> None:
    for name in ("mask", "late_mask"):
        assert not runs[f"{name}_faults"].any()
    assert not runs["mask_training_faults"].any()
    from_the_start, _ = shares(runs, "mask")
    afterwards, _ = shares(runs, "late_mask")
    assert from_the_start.min() > 0.9
    # A mask on what has learned without it costs captures.
    assert afterwards.mean() < from_the_start.mean() - 0.1


def test_a_limit_is_kept_at_the_end(runs: dict[str, np.ndarray]) -> None:
    rates = 1000 * runs["limit_faults"].sum(axis=1) / runs["limit_agent_steps"]
    assert (rates < 20).all()


# ---- Notebook 10 ---------------------------------------------------------------------------------


def test_the_kept_truth_is_that_of_the_results_and_what_the_notebook_says() -> None:
    """Run ``tutorials/make/chapter_10.py`` and ``tutorials/run.py 10`` if it fails."""
    stored = kept("chapter_10")
    derived = runpy.run_path(str(TUTORIALS / "make" / "chapter_10.py"))["derived"]()
    assert set(stored) == set(derived)
    assert all(np.array_equal(stored[name], values) for name, values in derived.items())
    last = {team: stored[f"{team}: truth"][:, :, -1] for team in ("pursuer", "evader")}
    conv = dict(zip(stored["schedules"], (1 - sum(last.values())).mean(axis=1), strict=True))
    assert conv["hall-of-fame"] == pytest.approx(chapter_10.HALLS, abs=1e-4)
    assert conv["generalist-generalist"] == pytest.approx(chapter_10.GENERALISTS, abs=1e-4)
    # Scores of the race come near the value, in every schedule, and what is guaranteed does not.
    for race, truth in zip(stored["pursuer: current"], stored["pursuer: truth"], strict=True):
        assert race[:, -1].mean() > 0.3
        assert truth[:, -1].max() < 0.2


def test_answers_to_the_newest_never_improve_and_those_to_the_nash_mixture_do() -> None:
    """In games that the notebook does not play."""
    names: dict[str, Any] = {"np": np, "analysis": analysis}
    for text in map(source, cells(NOTEBOOKS[-1], "code")):
        if text.startswith("def newest"):
            exec(text, names)
    for seed in (100, 101):
        own, other = np.random.default_rng(seed).normal(size=(2, 200, 3))
        game = 1 / (1 + np.exp(-own @ other.T))
        newest, nash = (names["respond"](game, names[n], 12)[-1] for n in ("newest", "nash"))
        assert newest > 0.95
        assert nash < 0.4


EVADERS, PURSUERS, OBSTACLES = range(3)


def wishes(view: np.ndarray, weights: np.ndarray) -> list[float]:
    """Return the wishes for the five actions, cell by cell as the table says."""
    of = dict(zip(WEIGHTS, weights, strict=True))
    found = [of["stay"]]
    evaders = [(r - 5, c - 5) for r, c in np.argwhere(view[EVADERS])]
    found[0] += of["hold"] * sum(abs(r) + abs(c) == 1 for r, c in evaders)
    for row, col in STEPS[1:]:
        wish = of["wall"] * view[OBSTACLES, 5 + row, 5 + col]
        wish += of["teammate"] * view[PURSUERS, 5 + row, 5 + col]
        for r, c in evaders:
            wish += of["approach"] * (r * row + c * col) / max(abs(r) + abs(c), 1)
        for down, right in STEPS[1:]:
            r, c = row + down, col + right
            if (r, c) != (0, 0):
                wish += of["crowd"] * view[PURSUERS, 5 + r, 5 + c]
        found.append(wish)
    return found


def test_the_network_wishes_what_the_table_says() -> None:
    rng = np.random.default_rng(0)
    # A few agents in each view, as in play.
    views = (rng.random((20, 3, 11, 11)) < 0.1).astype(np.uint8)
    weights = rng.normal(size=6)
    own = pack(weights)
    found = own.network.logits(own.genomes[0], views)
    expected = [wishes(view, weights) for view in views]
    np.testing.assert_allclose(found, expected, atol=1e-4)


def test_several_packs_are_one_population() -> None:
    both = pack([[1, 2, 3, 4, 5, 6], [0, 0, 0, 0, 0, 1]])
    np.testing.assert_array_equal(both.genomes[0], pack([1, 2, 3, 4, 5, 6]).genomes[0])
    assert len(both.genomes) == 2


@pytest.mark.parametrize("weights", [1.0, [1, 2], np.zeros((2, 7)), np.zeros((1, 1, 6))])
def test_other_shapes_are_refused(weights: Any) -> None:
    with pytest.raises(ValueError, match=r"weights: expected shape \(6,\) or \(n, 6\), got \("):
        pack(weights)


def test_without_a_mask_it_plays_like_a_rollout() -> None:
    weights = [6, 20, -10, -10, -2, 0]
    masked = play_masked(weights, everything, episodes=400, seed=1)
    played = mw.rollout(WORLD, pack(weights), "random", mw.Matches.of(0, 0, 2), episodes=400)
    # Means of 400 episodes each; the standard error of their difference is below 0.5 steps.
    assert abs(masked.steps.mean() - played.length.mean()) < 2
    assert abs(masked.captured.mean() - played.capture_rate.mean()) < 0.05
    assert masked.safety.episodes == 400
    assert masked.steps.max() <= WORLD.max_steps  # it keeps the time limit itself


def test_a_forbidden_action_is_never_chosen() -> None:
    def no_moves(views: np.ndarray) -> np.ndarray:
        return np.tile([True, False, False, False, False], (len(views), 1))

    def nothing(views: np.ndarray) -> np.ndarray:
        return np.zeros((len(views), 5), bool)

    for mask in (no_moves, nothing):  # where nothing is allowed, pursuers stay
        stayed = play_masked([6, 0, 0, 0, 0, 0], mask, episodes=20)
        assert not stayed.captured.any()
        assert (stayed.steps == WORLD.max_steps).all()
        assert stayed.safety.summary().fault_rate[0].sum() == 0


def test_a_mask_of_another_shape_is_refused() -> None:
    with pytest.raises(ValueError, match=r"mask: expected shape \(30, 5\), got \(30,\)"):
        play_masked([0] * 6, lambda views: np.ones(len(views), bool), episodes=5)
