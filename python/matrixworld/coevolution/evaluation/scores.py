"""Held-out opponents, and scores against them: of genomes, of the teams of a run, of any policy.

No run trains against these opponents: scripts, and genomes from the package. A race measures its
teams against each other, which does not show it when both get worse together. Opponents that are
the same for every run show it, and make runs comparable.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import Executor
from dataclasses import dataclass, replace
from functools import cache, partial
from importlib.resources import as_file, files
from typing import Any, cast

import numpy as np
from numpy.typing import NDArray

from matrixworld._util.checks import (
    EPISODE_BYTES,
    SEED_MAX,
    check_choice,
    check_integer,
    check_memory,
    check_threads,
)
from matrixworld._util.files import (
    DamagedFileError,
    load_arrays,
    load_json,
    save_json,
)
from matrixworld._util.readable import Parts, Readable
from matrixworld.analysis import (
    Estimate,
    interquartile_mean,
    interval_over_runs,
    mean_over_episodes,
)
from matrixworld.coevolution.evaluation.tournament import (
    play_blocks,
    team_size,
    tournament,
)
from matrixworld.coevolution.progress import Progress, Report, silent
from matrixworld.coevolution.schedules import Against
from matrixworld.coevolution.seeding import Phase
from matrixworld.coevolution.storage import SavedRun
from matrixworld.coevolution.types import SCORE, TEAMS, Team, other
from matrixworld.play import NetworkPolicy
from matrixworld.play.matches import Callback, Plays, capture_rates
from matrixworld.play.network_policy import fits
from matrixworld.play.rollout import Matches, match_seed, rollout
from matrixworld.version import __version__
from matrixworld.world.config import WorldConfig
from matrixworld.world.masks import LEAST_FOV
from matrixworld.world.policy import (
    CAREFUL,
    SCRIPTS,
    Network,
    Population,
    Script,
    TablePolicy,
    TeamPolicy,
)
from matrixworld.world.rules import Capture, Rules, rules_of, variant_name

FILE = "held_out.npz"
NETWORK = Network()
"""Network of the evolved opponents: views of 11 x 11, 5 actions, one hidden layer of 32."""

CAREFUL_FOV = LEAST_FOV["right-of-way"]
OCCUPIERS: tuple[Script, ...] = ("random", "clumsy-chaser", "chaser", "hunter")
SURROUNDERS: tuple[Script, ...] = (*OCCUPIERS, "surrounder", "careful-team-surrounder")
ESCAPERS: tuple[Script, ...] = ("random", "still", "clumsy-fleer", "fleer", "dodger")
HELD_OUT_VERSION = 2
"""Version of the set of opponents: scores of different versions cannot be compared. In version 1
the variants with capture by surrounding had no ``careful-team-surrounder``."""
RATE = 8
"""Bytes of a float64."""
SCORES = "scores.json"
"""File in the run directory: scores of the last generations, played once and kept."""
EPISODES, SEED = 100, 0
"""Episodes of each pair, and their seed, if nothing else is asked for."""
SCORED_BY = {
    "matrixworld": __version__,
    "held_out": HELD_OUT_VERSION,
    "episodes": EPISODES,
    "seed": SEED,
}
"""What kept scores were played by. Scores by anything else are played anew."""


# The opponents:


def held_out_scripts(team: Team, variant: Rules | str) -> tuple[Script, ...]:
    """Return the scripts of a team that make sense under the rules of a variant."""
    rules = rules_of(variant)
    if team not in TEAMS:
        raise ValueError(f"team: expected one of {', '.join(TEAMS)}, got {team!r}")
    if team == "evader":
        return ESCAPERS
    return SURROUNDERS if rules.capture is Capture.SURROUND else OCCUPIERS


def held_out(team: Team, variant: Rules | str) -> dict[str, TeamPolicy]:
    """Return the held-out opponents of a variant by name.

    First the scripts, then genomes, each a population of one and named ``evolved-1`` and so on.
    Genomes are from ``evolution/evolve_held_out.py``, rounded to float16. There are none for other
    rules than those of `VARIANTS`, and for a variant without shipped ones.

    Parameters
    ----------
    team : {"pursuer", "evader"}
        Team that the opponents play for.
    variant : Rules or str
        The variant.

    Raises
    ------
    ValueError
        If there is no such team or variant.
    """
    opponents: dict[str, TeamPolicy] = {name: name for name in held_out_scripts(team, variant)}
    genomes = _shipped().get(f"{variant_name(rules_of(variant))}.{team}s", ())
    for number, genome in enumerate(genomes, start=1):
        opponents[f"evolved-{number}"] = Population(genome.astype(np.float32), NETWORK)
    return opponents


# Read once: scores of many runs need it.
@cache
def _shipped() -> dict[str, NDArray[np.float16]]:
    with as_file(files("matrixworld.coevolution.evaluation") / FILE) as path:
        return load_arrays(path)


def opponents_of(team: Team, config: WorldConfig) -> tuple[dict[str, TeamPolicy], str]:
    """Return the held-out opponents of a team that fit a world, and in words which do not."""
    every = held_out(other(team), config.rules)
    fitting = {n: p for n, p in every.items() if _plays_in(p, config)}
    blind = [name for name in every if name.startswith(CAREFUL) and name not in fitting]
    told = [f"no {each}: it needs a view of {CAREFUL_FOV} x {CAREFUL_FOV} cells" for each in blind]
    name = variant_name(config.rules)
    if not name:
        told.append("no evolved opponents: they exist for the variants of the package only")
    elif f"{name}.{other(team)}s" not in _shipped():
        told.append(f"no evolved opponents: none are shipped for variant {name}")
    elif len(fitting) + len(blind) < len(every):
        told.append(
            f"no evolved opponents: they have a view of {NETWORK.fov} x {NETWORK.fov} cells and "
            f"{NETWORK.n_actions} actions, this world has {config.fov} x {config.fov} and "
            f"{config.n_actions}"
        )
    return fitting, "; ".join(told)


def _plays_in(opponent: TeamPolicy, config: WorldConfig) -> bool:
    """Return whether an opponent sees what it needs in a world."""
    if isinstance(opponent, str):
        return config.fov >= CAREFUL_FOV or not opponent.startswith(CAREFUL)
    return fits(opponent.network, config)


# Scores of genomes and runs:


@dataclass(frozen=True, repr=False)
class HeldOutScores(Readable):
    """Scores of G genomes of a team against N held-out opponents, by their names."""

    team: Team
    generations: tuple[int, ...]
    opponents: tuple[str, ...]
    rates: NDArray[np.float64]
    """Share of evaders captured, or for evaders 1 minus it, shape (G, N, episodes)."""
    left_out: str = ""
    """Which opponents of the variant are left out, and why; empty if none is."""

    def _parts(self) -> Parts:
        head, rows = _rows([self])
        first = "opponent" if len(self.generations) == 1 else "generation"
        cells = ((name.strip(), str(score)) for name, score in rows.items())
        return [head, [(first, SCORE[self.team]), *cells]]

    @property
    def matches(self) -> int:
        """The number of episodes played."""
        return self.rates.size

    @property
    def means(self) -> NDArray[np.float64]:
        """Mean (G,) over the opponents, with equal weights."""
        return np.asarray(self.rates.mean(axis=(1, 2)))

    def against(self, opponent: str, row: int = -1) -> Estimate:
        """Return the mean of one genome against one opponent, with an interval over episodes."""
        return self._estimate(row, [self.opponents.index(opponent)])

    def mean(self, row: int = -1) -> Estimate:
        """Return the mean of one genome over the opponents, with an interval over episodes."""
        return self._estimate(row, range(len(self.opponents)))

    def estimates(self, row: int = -1) -> dict[str, Estimate]:
        """Return the means of one genome against each opponent by name, and their mean."""
        # The mean has its own interval: it is narrower than those of its parts.
        return {**{n: self.against(n, row) for n in self.opponents}, "mean": self.mean(row)}

    def _estimate(self, row: int, chosen: Sequence[int]) -> Estimate:
        # Episode e against each opponent is one independent sample of the mean.
        return mean_over_episodes(self.rates[row][list(chosen)].mean(axis=0))

    def to_json(self) -> dict[str, Any]:
        """Return everything except the single episodes as values that JSON can hold."""
        rows = range(len(self.generations))
        return {
            "team": self.team,
            "score": SCORE[self.team],
            "episodes": self.rates.shape[2],
            "matches": self.matches,
            "generations": list(self.generations),
            "against": {n: [_plain(self.against(n, r)) for r in rows] for n in self.opponents},
            "mean": [_plain(self.mean(row)) for row in rows],
            "left_out": self.left_out,
        }


def _plain(estimate: Estimate) -> dict[str, float | None]:
    return {"value": estimate.value, "low": estimate.low, "high": estimate.high}


def estimates_of(scores: Sequence[HeldOutScores], row: int = -1) -> dict[str, Estimate]:
    """Return the means of one generation of a team, over the runs of several seeds.

    By the name of the opponent, then ``"mean"`` and, of several runs, ``"interquartile mean"``.
    Intervals are over the runs, those of a single run over its episodes.
    """
    if len(scores) == 1:
        return scores[0].estimates(row)
    rates = np.array([each.rates[row].mean(axis=1) for each in scores])
    columns = {**dict(zip(scores[0].opponents, rates.T, strict=True)), "mean": rates.mean(axis=1)}
    found = {name: interval_over_runs(each, bounds=(0.0, 1.0)) for name, each in columns.items()}
    return {**found, "interquartile mean": interquartile_mean(rates)}


def score_table(scores: Sequence[HeldOutScores]) -> str:
    """Return `estimates_of` as lines: of one generation all of them, of several the means."""
    head, rows = _rows(scores)
    width = max(map(len, rows))
    return "\n".join([head, *(f"  {name:{width}}  {each}" for name, each in rows.items())])


def _rows(scores: Sequence[HeldOutScores]) -> tuple[str, dict[str, Estimate]]:
    team, generations = scores[0].team, scores[0].generations
    if len(generations) == 1:
        return f"{team}s of generation {generations[0]}: {SCORE[team]}", estimates_of(scores, 0)
    means = {f"{g:10}": estimates_of(scores, row)["mean"] for row, g in enumerate(generations)}
    return f"{team}s by generation: mean {SCORE[team]}", means


def _by_engine(
    config: WorldConfig,
    team: Team,
    policy: TeamPolicy,
    opponents: Mapping[str, TeamPolicy],
    *,
    episodes: int,
    seed: int,
    threads: int | None,
    on_row: Callable[[int], None],
    executor: Executor | None = None,
) -> NDArray[np.float64]:
    """Return the scores (G, N, episodes) of the genomes of a team against opponents.

    `on_row` gets the number of episodes played so far.
    """
    count = team_size(policy)
    # Rates of the opponents so far, and the statistics of one more.
    check_memory("scores", rates=count * episodes * (EPISODE_BYTES + 2 * RATE * len(opponents)))
    blocks = []
    for number, opponent in enumerate(opponents.values()):
        sides = (policy, opponent) if team == "pursuer" else (opponent, policy)
        # All genomes play the same episodes.
        seeds = np.full(count, held_out_seed(seed, team, number), np.uint64)
        own = np.arange(count)
        matches = Matches.of(own, 0, seeds) if team == "pursuer" else Matches.of(0, own, seeds)
        blocks.append(partial(rollout, config, *sides, matches, episodes=episodes))
    captured = np.empty((count, len(opponents), episodes))
    played = 0
    for number, statistics in play_blocks(blocks, threads, executor):
        captured[:, number] = statistics.capture_rate
        played += statistics.capture_rate.size
        on_row(played)
    return captured if team == "pursuer" else 1.0 - captured


def held_out_seed(seed: int, team: Team, number: int) -> int:
    """Return the seed of the matches of a team against held-out opponent `number`."""
    # The generation is not part of the key: all genomes play the same episodes.
    return match_seed(seed, TEAMS.index(team), number, int(Phase.HELD_OUT))


def score(
    run: SavedRun,
    *,
    generation: int | None = -1,
    episodes: int = EPISODES,
    steps: int | None = None,
    seed: int = SEED,
    threads: int | None = None,
    report: Report = silent,
    executor: Executor | None = None,
) -> dict[Team, HeldOutScores]:
    """Score each team that learned in a run against the held-out opponents of its variant.

    Parameters
    ----------
    run : SavedRun
        The run, finished or not.
    generation : int or None, optional
        Generation to score; negative numbers count from the end, None means all generations. The
        default is the last one.
    episodes : int, optional
        Episodes of each pair, at least 2.
    steps : int, optional
        Maximum steps of an episode. By default as in the run's evaluation.
    seed : int, optional
        Seed of the episodes, by default the same for all runs.
    threads, executor
        As in `tournament`.
    report : callable, optional
        Called with the progress, as in `Run.run`.

    Raises
    ------
    IndexError
        If there is no such generation.

    Notes
    -----
    The world is that of the run. A script that the run trained against is left out, and so are
    evolved opponents that do not fit the world; see `HeldOutScores.left_out`.
    """
    episodes = check_integer("episodes", episodes, 2)
    check_threads(threads)
    world = run.settings.world if steps is None else replace(run.settings.world, max_steps=steps)
    chosen = {team: _chosen(run, team, generation) for team in run.settings.learning_teams}
    unseen = {team: _unseen(run, team, world) for team in chosen}
    total = sum(len(chosen[team][1]) * len(unseen[team][0]) * episodes for team in chosen)
    scores: dict[Team, HeldOutScores] = {}

    def report_row(team: Team, done: int) -> None:
        before = sum(each.matches for each in scores.values())
        report(Progress(f"{team}s against held-out opponents", before + done, total))

    for team, (population, generations) in chosen.items():
        opponents, left_out = unseen[team]
        rates = _by_engine(
            world, team, population, opponents, episodes=episodes, seed=seed, threads=threads,
            on_row=partial(report_row, team), executor=executor,
        )  # fmt: skip
        scores[team] = HeldOutScores(team, tuple(generations), tuple(opponents), rates, left_out)
    return scores


def score_runs(
    runs: Sequence[SavedRun], *, report: Report = silent, **options: Any
) -> list[dict[Team, HeldOutScores]]:
    """Return the scores of several runs, with one progress for all; options as those of `score`."""
    found = []
    for number, run in enumerate(runs):
        # Runs of a job play about equally many matches.
        def part(one: Progress, number: int = number) -> None:
            place = f"[{number + 1}/{len(runs)}] " if len(runs) > 1 else ""
            done = number * one.total + one.done
            report(Progress(place + one.what, done, len(runs) * one.total))

        # A reader of its own: the archives of all runs together may be large.
        found.append(score(SavedRun(run.path), report=part, **options))
    return found


def kept_scores(
    runs: Sequence[SavedRun], *, threads: int | None = None, report: Report = silent
) -> list[dict[str, Any]]:
    """Return the scores of the last generations as values of JSON, by "pursuers" and "evaders".

    They are those of `score` without options, played once and kept in the directories of the runs.
    """
    missing = [run for run in runs if _kept(run) is None]
    if missing:
        played = score_runs(missing, report=report, threads=threads)
        for run, teams in zip(missing, played, strict=True):
            plain = {f"{team}s": each.to_json() for team, each in teams.items()}
            save_json(run.path / SCORES, {**SCORED_BY, **plain}, owner=run.owner(SCORES))
    return [_kept(run) or {} for run in runs]


def _kept(run: SavedRun) -> dict[str, Any] | None:
    """Return the scores in a run directory; None if none are kept there, or other ones."""
    try:
        kept = load_json(run.path / SCORES, owner=run.owner(SCORES))
    except (FileNotFoundError, DamagedFileError):
        return None
    return kept if kept.items() >= SCORED_BY.items() else None


def _chosen(run: SavedRun, team: Team, generation: int | None) -> tuple[Population, list[int]]:
    archive = cast(Population, run.teams[team])  # never a script, because the team learned
    numbers = list(range(len(archive.genomes)))
    if generation is not None:
        numbers = [run.generation(team, generation, "generation")]
    return Population(archive.genomes[numbers], archive.network), numbers


def _unseen(run: SavedRun, team: Team, world: WorldConfig) -> tuple[dict[str, TeamPolicy], str]:
    """Return the opponents that the run did not train against, and which are left out."""
    opponents, left_out = opponents_of(team, world)
    schedule = run.settings.schedule
    seen = schedule.opponent if isinstance(schedule, Against) else None
    if seen not in opponents:
        return opponents, left_out
    unseen = {name: each for name, each in opponents.items() if name != seen}
    return unseen, "; ".join(filter(None, [f"not {seen}: the run trained against it", left_out]))


# Policies that learned elsewhere, and teams that learned in another way:


def score_policy(
    policy: Callback | NetworkPolicy | Population | TablePolicy,
    team: Team,
    config: WorldConfig | Rules | str = "O",
    *,
    opponents: Mapping[str, Plays] | None = None,
    episodes: int = 100,
    seed: int = 0,
    threads: int | None = None,
    report: Report = silent,
) -> HeldOutScores:
    """Play a policy of one team against every held-out opponent, as ``matrixworld score`` does.

    In the result the policy is generation 0; the genomes of a population are generations 0, 1, ...

    Parameters
    ----------
    policy : callable, NetworkPolicy, Population, or what `solve.Solution.policy` returns
        A function from observations, uint8 (n, 3, fov, fov), of n living agents of the team to
        their actions, integers (n,). The agents may be of several episodes. What is no function is
        played inside the engine.
    team : {"pursuer", "evader"}
        Team that it plays for.
    config : WorldConfig, Rules or str, optional
        The world. The default is "O".
    opponents : mapping of str to policy, optional
        N opponents by name. By default the held-out opponents of the world's rules that fit its
        views and actions.
    episodes : int, optional
        Episodes against each opponent, at least 2. The default is 100.
    seed, threads, report
        As in `score`.

    Raises
    ------
    ValueError, TypeError
        If there are fewer than 2 episodes, if a network does not fit the world, and if the policy
        returns something else than a legal action for each observation.

    Notes
    -----
    The opponents, the episodes and the random numbers of scripts are those of `score`: with the
    same world, seed and number of episodes, scores of policies and of runs can be compared. A
    function that chooses what a genome would choose gets the scores of the genome.

    All episodes against an opponent are played side by side. Where the rules take turns, functions
    are played turn by turn in Python, which is slower.

    Examples
    --------
    >>> import matrixworld as mw
    >>> config = mw.WorldConfig("O", rows=8, cols=8, n_pursuers=3, n_evaders=3, max_steps=20)
    >>> scores = mw.score_policy(lambda seen: [1] * len(seen), "pursuer", config, episodes=4)
    >>> scores.opponents
    ('random', 'still', 'clumsy-fleer', 'fleer', 'dodger', 'evolved-1', 'evolved-2')
    """
    config = WorldConfig.of(config)
    check_choice("team", team, TEAMS)
    episodes = check_integer("episodes", episodes, 2)
    seed = check_integer("seed", seed, 0, SEED_MAX)
    check_threads(threads)
    left_out = ""
    if opponents is None:
        opponents, left_out = opponents_of(team, config)
    mine = _plays("policy", policy)
    theirs = {name: _plays("opponents", each, most=1) for name, each in opponents.items()}
    if not theirs:
        raise ValueError("opponents: expected at least one, got none")
    total = team_size(mine) * len(theirs) * episodes

    def on_row(played: int) -> None:
        report(Progress(f"{team}s against held-out opponents", played, total))

    if any(map(callable, [mine, *theirs.values()])):
        rates = _by_functions(config, team, mine, theirs, episodes, seed, on_row)
    else:
        rates = _by_engine(
            config, team, mine, theirs, episodes=episodes, seed=seed, threads=threads,
            on_row=on_row,
        )  # fmt: skip
    return HeldOutScores(team, tuple(range(len(rates))), tuple(theirs), rates, left_out)


def _by_functions(
    config: WorldConfig,
    team: Team,
    policy: Plays,
    opponents: Mapping[str, Plays],
    episodes: int,
    seed: int,
    on_row: Callable[[int], None],
) -> NDArray[np.float64]:
    """Return what `_by_engine` does, where functions decide for a team."""
    mine: list[Plays] = [policy]
    if isinstance(policy, Population):
        mine = [Population(genome, policy.network) for genome in policy.genomes]
    captured = np.empty((len(mine), len(opponents), episodes))
    for number, opponent in enumerate(opponents.values()):
        match = held_out_seed(seed, team, number)
        for row, one in zip(captured, mine, strict=True):
            sides = (one, opponent) if team == "pursuer" else (opponent, one)
            row[number] = capture_rates(config, *sides, seed=match, episodes=episodes)
        on_row((number + 1) * len(mine) * episodes)
    return captured if team == "pursuer" else 1.0 - captured


def _plays(name: str, policy: Any, most: int | None = None) -> Any:
    """Return a policy in the form that is played, of so many genomes at most."""
    if isinstance(policy, NetworkPolicy):
        return policy.population()
    if isinstance(policy, str):
        check_choice(name, policy, SCRIPTS)
    elif not callable(policy) and not isinstance(policy, Population | TablePolicy):
        expected = "a function, a NetworkPolicy or a Population"
        raise TypeError(f"{name}: expected {expected}, got {policy!r}")
    elif most is not None and team_size(policy) > most:
        raise ValueError(f"{name}: expected a single genome, got {team_size(policy)}")
    return policy


def scores_in_race(race: SavedRun, team: Team, policy: TeamPolicy) -> NDArray[np.float64]:
    """Return the mean scores (generations,) of a policy against a race's other team.

    Capture rates, or for evaders 1 minus them; `policy` is one genome or a script. There are as
    many episodes as in the race's evaluation. ValueError if the run is not a race.
    """
    check_choice("team", team, TEAMS)
    settings = race.settings
    if not settings.is_race:
        raise ValueError(f"race: expected a race, got a run of one team: {race.path}")
    sides = {**race.teams, team: policy}
    payoff = tournament(
        settings.world,
        sides["pursuer"],
        sides["evader"],
        seed=settings.seed,
        episodes=settings.evaluation_episodes,
    )
    # A row or a column of generations.
    rates = payoff.capture_rate.ravel()
    return rates if team == "pursuer" else 1 - rates


def trained_team(run: SavedRun) -> tuple[Team, Population]:
    """Return the team that learned in a run of one team, and its last genome."""
    schedule = run.settings.schedule
    if not isinstance(schedule, Against):
        raise ValueError(f"{run.path}: expected a run of one team, got a race")
    last = run.last(schedule.team)
    assert isinstance(last, Population)  # the team that learned has genomes
    return schedule.team, last
