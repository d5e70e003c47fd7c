"""Scores against held-out opponents: what they are, and those of the teams of a run."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from concurrent.futures import Executor
from dataclasses import dataclass, replace
from functools import cache, partial
from typing import Any, NamedTuple, cast

import numpy as np
from numpy.typing import NDArray

from matrixworld import analysis
from matrixworld._util import checks, readable
from matrixworld._util.teams import PLURALS
from matrixworld.analysis import Estimate
from matrixworld.coevolution.evaluation.held_out import opponents_of, scripts_for
from matrixworld.coevolution.evaluation.held_out_matches import play_held_out
from matrixworld.coevolution.games.pursuit import Pursuit
from matrixworld.coevolution.progress import Report, part_of, silent
from matrixworld.coevolution.runs.stored import StoredRun
from matrixworld.coevolution.settings.schedules import Against
from matrixworld.coevolution.types import TEAMS, Team
from matrixworld.world.config import WorldConfig
from matrixworld.world.policy import CAREFUL, Policy, Population, Script, TeamPolicy

SCORE = dict(zip(TEAMS, Pursuit.score_words, strict=True))  # what the score of a team is called
EPISODES = 100  # episodes of each pair, if nothing else is asked for
SEED = 0  # seed of the episodes, if nothing else is asked for
BESIDE_EPISODES = 20
"""Episodes of each pair of what stands beside scores: untrained teams."""
CHOICE = ((8, 1.0), (16, 0.4), (100, 0.15))
LEAST_LEFT = 4
"""How the best generation is chosen: in each round so many more episodes against each opponent, and
the share of the generations that plays them, the best ones so far, at least `LEAST_LEFT`
(sequential halving: Karnin, Koren and Somekh 2013, "Almost optimal exploration in multi-armed
bandits", ICML)."""


@dataclass(frozen=True, eq=False, repr=False)
class HeldOutScores(readable.Readable):
    """Scores of G genomes of a team against N held-out opponents, by their names."""

    team: Team
    generations: tuple[int, ...]
    opponents: tuple[str, ...]
    rates: NDArray[np.float64]
    """Share of evaders captured, or for evaders 1 minus it, shape (G, N, episodes)."""
    left_out: str = ""  # which opponents of the variant are left out, and why; empty if none is

    def _parts(self) -> readable.Parts:
        title, estimates = _titled_estimates([self])
        first = "opponent" if len(self.generations) == 1 else "generation"
        rows = [(name.strip(), str(score)) for name, score in estimates.items()]
        return [title, [(first, SCORE[self.team]), *rows]]

    @property
    def matches(self) -> int:
        """The number of episodes played."""
        return self.rates.size

    @property
    def means(self) -> NDArray[np.float64]:
        """Mean (G,) over the opponents, with equal weights."""
        return np.asarray(self.rates.mean(axis=(1, 2)))

    def against(self, opponent: str, row: int = -1) -> Estimate:
        """Return the mean of one genome against one opponent, with an interval over episodes.

        ValueError if there is no such opponent, IndexError if there is no such row.
        """
        return analysis.mean_over_episodes(self.rates[row, self.opponents.index(opponent)])

    def mean(self, row: int = -1) -> Estimate:
        """Return the mean of one genome over the opponents, with an interval over episodes."""
        # Episode e against each opponent is one independent sample of the mean.
        return analysis.mean_over_episodes(self.rates[row].mean(axis=0))

    def to_json(self) -> dict[str, Any]:
        """Return everything except the single episodes as values that JSON can hold."""
        rows = range(len(self.generations))
        against = {}
        for name in self.opponents:
            against[name] = [_ends(self.against(name, row)) for row in rows]
        return {
            "team": self.team,
            "score": SCORE[self.team],
            "episodes": self.rates.shape[2],
            "matches": self.matches,
            "generations": list(self.generations),
            "against": against,
            "mean": [_ends(self.mean(row)) for row in rows],
            "left_out": self.left_out,
        }


def _ends(estimate: Estimate) -> dict[str, float | None]:
    """Return an estimate and the ends of its interval as values of JSON."""
    return {"value": estimate.value, "low": estimate.low, "high": estimate.high}


def estimates_of(scores: Sequence[HeldOutScores], row: int = -1) -> dict[str, Estimate]:
    """Return the means of one generation of a team by opponent, over the runs of several seeds.

    Intervals are over the runs, those of a single run over its episodes.
    """
    opponents = scores[0].opponents
    if len(scores) == 1:
        [one] = scores
        estimates = {name: one.against(name, row) for name in opponents}
        # The mean has its own interval: it is narrower than those of its parts.
        return {**estimates, "mean": one.mean(row)}
    rates = np.array([each.rates[row].mean(axis=1) for each in scores])  # (runs, opponents)
    over_runs = partial(analysis.interval_over_runs, bounds=(0.0, 1.0))
    estimates = {name: over_runs(rates[:, n]) for n, name in enumerate(opponents)}
    return {
        **estimates,
        "mean": over_runs(rates.mean(axis=1)),
        "interquartile mean": analysis.interquartile_mean(rates),
    }


def score_table(scores: Sequence[HeldOutScores]) -> str:
    """Return `estimates_of` as lines: of one generation all of them, of several the means."""
    title, estimates = _titled_estimates(scores)
    width = max(map(len, estimates))
    return "\n".join([title, *(f"  {name:{width}}  {each}" for name, each in estimates.items())])


def _titled_estimates(scores: Sequence[HeldOutScores]) -> tuple[str, dict[str, Estimate]]:
    """Return the estimates of one generation by opponent, of several by generation; a title."""
    team = scores[0].team
    generations = scores[0].generations
    if len(generations) == 1:
        title = f"{PLURALS[team]} of generation {generations[0]}: {SCORE[team]}"
        return title, estimates_of(scores, 0)
    means = {
        f"{generation:10}": estimates_of(scores, row)["mean"]
        for row, generation in enumerate(generations)
    }
    return f"{PLURALS[team]} by generation: mean {SCORE[team]}", means


# Of runs:


def score(
    run: StoredRun,
    *,
    generation: int | Mapping[Team, int] | None = -1,
    episodes: int = EPISODES,
    steps: int | None = None,
    seed: int = SEED,
    world: WorldConfig | None = None,
    threads: int | None = None,
    report: Report = silent,
    executor: Executor | None = None,
) -> dict[Team, HeldOutScores]:
    """Score each team that learned in a run against the held-out opponents of its variant.

    Parameters
    ----------
    run : StoredRun
        The run, which need not be finished.
    generation : int or mapping of str to int, optional
        The generation, or that of each team; negative numbers count from the end, None means all.
        By default the last.
    episodes, seed : int, optional
        Episodes of each pair, at least 2, and their seed, by default the same for all runs.
    world : WorldConfig, optional
        A world with another size or map, or other numbers of agents. By default that of the run.
    steps : int, optional
        The most steps of an episode. By default those of the world.
    threads, executor, report
        As in `tournament` and `evolve`.

    Returns
    -------
    dict of {"pursuer", "evader"} to HeldOutScores
        The scores of each team that learned.

    Raises
    ------
    IndexError
        If there is no such generation.
    TypeError
        If `run` is no `StoredRun`, or a number is no integer.
    ValueError
        If the run is of a game of your own, or a number is too small or too large.
    """
    checks.check_instance("run", run, StoredRun)
    episodes = checks.check_integer("episodes", episodes, 2)
    checks.check_threads(threads)
    if isinstance(generation, Mapping) and {*generation} != {*run.settings.learning_teams}:
        expected = f"a number of each of {', '.join(run.settings.learning_teams)}"
        raise ValueError(f"generation: expected {expected}, got {dict(generation)}")
    run.check_pursuit(
        "it has no held-out opponents, and `judge` says how its generations do against each other"
    )
    if world is None:
        world = run.pursuit.world
    if steps is not None:
        world = replace(world, max_steps=steps)
    scores: dict[Team, HeldOutScores] = {}
    teams = run.settings.learning_teams
    for number, team in enumerate(teams):
        archive = cast(Population, run.teams[team])  # never a script, because the team learned
        if generation is None:
            chosen = [*range(len(archive.genomes))]
        else:
            asked = generation[team] if isinstance(generation, Mapping) else generation
            chosen = [run.generation(team, asked, "generation")]
        genomes = Population(archive.genomes[chosen], archive.policy)
        opponents, left_out = opponents_in(run, team, world)
        rates = play_held_out(
            world,
            team,
            genomes,
            opponents,
            episodes=episodes,
            seed=seed,
            threads=threads,
            report=part_of(report, number, len(teams)),
            executor=executor,
        )
        scores[team] = HeldOutScores(team, tuple(chosen), tuple(opponents), rates, left_out)
    return scores


def opponents_in(
    run: StoredRun, scored_team: Team, world: WorldConfig
) -> tuple[dict[str, TeamPolicy], str]:
    """Return what `opponents_of` returns, without an opponent that the run trained against."""
    opponents, left_out = opponents_of(scored_team, world)
    met = met_in_training(run)
    for name in (name for name in met if name in opponents):
        seen = f"not {name}: the run trained against it"
        left_out = f"{seen}; {left_out}" if left_out else seen
    return _without(opponents, met), left_out


def met_in_training(run: StoredRun) -> tuple[str, ...]:
    """Return the opponents that one team learned against; none of a race."""
    schedule = run.settings.schedule
    return schedule.met if isinstance(schedule, Against) else ()


def _without(opponents: Mapping[str, TeamPolicy], names: tuple[str, ...]) -> dict[str, TeamPolicy]:
    return {name: opponent for name, opponent in opponents.items() if name not in names}


def best_generations(
    run: StoredRun, *, threads: int | None = None, report: Report = silent
) -> dict[Team, int]:
    """Return the generation of each team with the highest mean score, the latest of equal ones."""
    run.check_pursuit("it has no held-out opponents by which the best generation is chosen")
    world = run.pursuit.world
    best: dict[Team, int] = {}
    teams = run.settings.learning_teams
    for place, team in enumerate(teams):
        archive = cast(Population, run.teams[team])
        opponents, _ = opponents_in(run, team, world)
        of_team = part_of(report, place, len(teams))
        left = np.arange(len(archive.genomes))
        sums = np.zeros(len(left))
        for number, (episodes, share) in enumerate(CHOICE):
            count = min(len(sums), max(LEAST_LEFT, round(share * len(sums))))
            left = np.sort(left[np.argsort(sums[left], kind="stable")[-count:]])
            genomes = Population(archive.genomes[left], archive.policy)
            # Other episodes than those of any score that is asked for.
            seed = checks.SEED_MAX - number
            rates = play_held_out(
                world,
                team,
                genomes,
                opponents,
                episodes=episodes,
                seed=seed,
                threads=threads,
                report=part_of(of_team, number, len(CHOICE)),
            )
            sums[left] += rates.mean(axis=1).sum(axis=1)
        best[team] = int(left[np.flatnonzero(sums[left] == sums[left].max())[-1]])
    return best


class BestScript(NamedTuple):
    """The script of a team with the highest mean score in a world, of so many that can play."""

    name: Script
    score: float
    among: int


@cache
def best_scripts(
    config: WorldConfig,
    without: tuple[str, ...] = (),
    *,
    episodes: int,
    seed: int = SEED,
    threads: int | None = None,
) -> dict[Team, BestScript]:
    """Return the best script of each team in a world, against held-out opponents.

    `without` are names of opponents that are left out, as those that a run trained against.

    All scripts that make sense are asked, careful ones, too. The best of several is partly luck: of
    equally good scripts, the score tends to be too high.
    """
    best: dict[Team, BestScript] = {}
    for team in TEAMS:
        opponents = _without(opponents_of(team, config)[0], without)
        means: dict[Script, float] = {}
        for script in scripts_for(team, config):
            rates = play_held_out(
                config, team, script, opponents, episodes=episodes, seed=seed, threads=threads
            )
            means[script] = float(rates.mean(axis=(1, 2))[0])
        script = max(means, key=lambda name: means[name])
        best[team] = BestScript(script, means[script], len(means))
    return best


RIGHT_OF_WAY, COURSE, PLAN = "right of way", "a direction for 12 steps", "a plan of their team"
BEYOND_VIEW: dict[str, str] = {
    "must_yield": RIGHT_OF_WAY,
    "ahead": COURSE,
    "search": PLAN,
    "hunter": COURSE,
    "surrounder": COURSE,
    "team-surrounder": PLAN,
}
"""What inputs and scripts know beyond a view; right of way takes the step and numbers of agents."""


def knows(player: Script | Policy) -> tuple[str, ...]:
    """Return what a script or a policy knows beyond the view of its agents, in words.

    >>> knows("careful-hunter")
    ('right of way', 'a direction for 12 steps')
    """
    found = []
    if isinstance(player, str):
        if player.startswith(CAREFUL):
            found.append(RIGHT_OF_WAY)
        found.append(BEYOND_VIEW.get(player.removeprefix(CAREFUL), ""))
    else:
        if getattr(player, "mask", "") == "right-of-way":
            found.append(RIGHT_OF_WAY)
        found += [BEYOND_VIEW.get(name, "") for name in getattr(player, "inputs", ())]
        found.append("their past" if player.memory != "none" else "")
    return tuple(dict.fromkeys(filter(None, found)))


def score_runs(
    runs: Sequence[StoredRun], *, report: Report = silent, **options: Any
) -> list[dict[Team, HeldOutScores]]:
    """Return the scores of runs, with the options of `score`, and one progress for all."""
    scores = []
    for number, run in enumerate(runs):
        place = f"[{number + 1}/{len(runs)}] " if len(runs) > 1 else ""
        part = part_of(report, number, len(runs), place)
        # A reader of its own: the archives of all runs together may be large.
        scores.append(score(StoredRun(run.path), report=part, **options))
    return scores
