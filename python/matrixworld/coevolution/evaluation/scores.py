"""Held-out opponents, and scores against them: of genomes, of the teams of a run, of any policy.

No run trains against these opponents: scripts, and genomes from the package. A race measures its
teams against each other, which does not show it when both get worse together. Opponents that are
the same for every run show it, and make runs comparable.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from concurrent.futures import Executor
from dataclasses import dataclass, replace
from functools import cache, partial
from importlib import resources
from typing import Any, cast

import numpy as np
from numpy.typing import NDArray

from matrixworld import analysis
from matrixworld._util import checks, files, readable
from matrixworld.analysis import Estimate
from matrixworld.coevolution import race, seeding
from matrixworld.coevolution.evaluation.tournament import each_genome, play_blocks
from matrixworld.coevolution.progress import Progress, Report, part_of, silent
from matrixworld.coevolution.pursuit import Network, Pursuit
from matrixworld.coevolution.storage import SavedRun
from matrixworld.coevolution.types import TEAMS, Team, other, team_size
from matrixworld.play.matches import Callback, Plays, capture_rates
from matrixworld.play.policies import GenomePolicy
from matrixworld.play.rollout import Matches, rollout
from matrixworld.version import __version__
from matrixworld.world.config import WorldConfig
from matrixworld.world.masks import LEAST_FOV
from matrixworld.world.policy import CAREFUL, SCRIPTS, Population, Script, TablePolicy, TeamPolicy
from matrixworld.world.rules import Capture, Rules, rules_of, variant_name

FILE = "held_out.npz"
SCORE = dict(zip(TEAMS, Pursuit.score_words, strict=True))  # what the score of a team is called
NETWORK = Network()
"""Network of the evolved opponents: views of 11 x 11, 5 actions, one hidden layer of 32."""

CAREFUL_FOV = LEAST_FOV["right-of-way"]
OCCUPIERS: tuple[Script, ...] = ("random", "clumsy-chaser", "chaser", "hunter")
SURROUNDERS: tuple[Script, ...] = (*OCCUPIERS, "surrounder", "careful-team-surrounder")
ESCAPERS: tuple[Script, ...] = ("random", "still", "clumsy-fleer", "fleer", "dodger")
HELD_OUT_VERSION = 2
"""Version of the set of opponents: scores of different versions cannot be compared. In version 1
the variants with capture by surrounding had no ``careful-team-surrounder``."""
SCORES = "scores.json"
"""File in the run directory: scores of the last generations, played once and kept."""
EPISODES, SEED = 100, 0  # episodes of each pair, and their seed, if nothing else is asked for
CHOICE_EPISODES = 20
"""Episodes of each pair by which the best is chosen of many, and of what stands beside scores."""
SCORED_BY = {
    "matrixworld": __version__,
    "held_out": HELD_OUT_VERSION,
    "episodes": EPISODES,
    "seed": SEED,
    "beside": ["untrained", "best script"],
}
"""What kept scores were played by. Scores by anything else are played anew."""


# The opponents:


def held_out_scripts(team: Team, variant: Rules | str) -> tuple[Script, ...]:
    """Return the scripts of a team that make sense under the rules of a variant."""
    rules = rules_of(variant)
    checks.check_choice("team", team, TEAMS)
    if team == "evader":
        return ESCAPERS
    return SURROUNDERS if rules.capture is Capture.SURROUND else OCCUPIERS


def held_out(team: Team, variant: Rules | str) -> dict[str, TeamPolicy]:
    """Return the held-out opponents of a variant by name.

    Parameters
    ----------
    team : {"pursuer", "evader"}
        Team that they play for.
    variant : Rules or str
        Rules under which they play.

    Returns
    -------
    dict of str to policy
        First the scripts, then genomes, each a population of one and named ``evolved-1`` and so on.
        Genomes are from ``evolution/evolve_held_out.py``, rounded to float16; rules that are none
        of the package's variants have none.

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
    with resources.as_file(resources.files(__package__) / FILE) as path:
        return files.load_arrays(path)


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
    return bool(opponent.policy.fits(config))


# Scores of genomes and runs:


@dataclass(frozen=True, repr=False)
class HeldOutScores(readable.Readable):
    """Scores of G genomes of a team against N held-out opponents, by their names."""

    team: Team
    generations: tuple[int, ...]
    opponents: tuple[str, ...]
    rates: NDArray[np.float64]
    """Share of evaders captured, or for evaders 1 minus it, shape (G, N, episodes)."""
    left_out: str = ""  # which opponents of the variant are left out, and why; empty if none is

    def _parts(self) -> readable.Parts:
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
        return analysis.mean_over_episodes(self.rates[row, self.opponents.index(opponent)])

    def mean(self, row: int = -1) -> Estimate:
        """Return the mean of one genome over the opponents, with an interval over episodes."""
        # Episode e against each opponent is one independent sample of the mean.
        return analysis.mean_over_episodes(self.rates[row].mean(axis=0))

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
    """Return the means of one generation of a team by opponent, over the runs of several seeds.

    Intervals are over the runs, those of a single run over its episodes.
    """
    if len(scores) == 1:
        [one] = scores
        # The mean has its own interval: it is narrower than those of its parts.
        return {**{n: one.against(n, row) for n in one.opponents}, "mean": one.mean(row)}
    rates = np.array([each.rates[row].mean(axis=1) for each in scores])
    columns = {**dict(zip(scores[0].opponents, rates.T, strict=True)), "mean": rates.mean(axis=1)}
    over_runs = partial(analysis.interval_over_runs, bounds=(0.0, 1.0))
    found = {name: over_runs(each) for name, each in columns.items()}
    return {**found, "interquartile mean": analysis.interquartile_mean(rates)}


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


def _scores(
    config: WorldConfig,
    team: Team,
    policy: Plays,
    generations: Sequence[int],
    opponents: Mapping[str, Plays],
    left_out: str = "",
    *,
    episodes: int,
    seed: int,
    threads: int | None = None,
    report: Report = silent,
    executor: Executor | None = None,
) -> HeldOutScores:
    """Play the generations of a team against its opponents, one opponent at a time."""
    blocks = []
    for number, opponent in enumerate(opponents.values()):
        # The generation is not part of the key: all genomes play the same episodes.
        match = seeding.match_seed(seed, TEAMS.index(team), number, int(seeding.Phase.HELD_OUT))
        blocks.append(partial(_played, config, team, policy, opponent, match, episodes))
    rates, done = np.empty((len(generations), len(opponents), episodes)), 0
    for number, found in play_blocks(blocks, threads, executor):
        rates[:, number] = found if team == "pursuer" else 1.0 - found
        done += found.size
        report(Progress(f"{team}s against held-out opponents", done, rates.size))
    return HeldOutScores(team, tuple(generations), tuple(opponents), rates, left_out)


def _played(
    config: WorldConfig,
    team: Team,
    policy: Plays,
    opponent: Plays,
    seed: int,
    episodes: int,
    *,
    threads: int | None,
) -> NDArray[np.float64]:
    """Return the capture rates (G, episodes) of the genomes of a team against an opponent."""

    def sides(own: Any, others: Any) -> tuple[Any, Any]:
        return (own, others) if team == "pursuer" else (others, own)

    if callable(policy) or callable(opponent):
        every = (sides(each, opponent) for each in each_genome(policy))
        played = [capture_rates(config, *each, seed=seed, episodes=episodes) for each in every]
        return np.stack(played)
    own = np.arange(team_size(policy))
    matches = Matches.of(*sides(own, 0), np.full(len(own), seed, np.uint64))
    both = sides(policy, opponent)
    statistics = rollout(config, *both, matches, episodes=episodes, threads=threads)
    return statistics.capture_rate.astype(np.float64)


def score(
    run: SavedRun,
    *,
    generation: int | None = -1,
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
    run : SavedRun
        The run, which need not be finished.
    generation : int, optional
        The generation; negative numbers count from the end, None means all. By default the last.
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
    """
    checks.check_instance("run", run, SavedRun)
    episodes = checks.check_integer("episodes", episodes, 2)
    checks.check_threads(threads)
    world = world or run.pursuit.world
    world = world if steps is None else replace(world, max_steps=steps)
    found, teams = {}, run.settings.learning_teams
    for number, team in enumerate(teams):
        archive = cast(Population, run.teams[team])  # never a script, because the team learned
        chosen = [*range(len(archive.genomes))]
        if generation is not None:
            chosen = [run.generation(team, generation, "generation")]
        genomes = Population(archive.genomes[chosen], archive.policy)
        found[team] = _scores(
            world, team, genomes, chosen, *opponents_in(run, team, world), episodes=episodes,
            seed=seed, threads=threads, report=part_of(report, number, len(teams)),
            executor=executor,
        )  # fmt: skip
    return found


def opponents_in(
    run: SavedRun, team: Team, world: WorldConfig
) -> tuple[dict[str, TeamPolicy], str]:
    """Return what `opponents_of` returns, without an opponent that the run trained against."""
    opponents, left_out = opponents_of(team, world)
    schedule = run.settings.schedule
    if isinstance(schedule, race.Against) and schedule.opponent in opponents:
        del opponents[schedule.opponent]
        seen = f"not {schedule.opponent}: the run trained against it"
        left_out = f"{seen}; {left_out}" if left_out else seen
    return opponents, left_out


def best_generations(run: SavedRun) -> dict[Team, int]:
    """Return the generation of each team with the highest mean score, the latest of equal ones."""
    found = score(run, generation=None, episodes=CHOICE_EPISODES, seed=checks.SEED_MAX)
    best = {team: np.flatnonzero(one.means == one.means.max())[-1] for team, one in found.items()}
    return {team: int(generation) for team, generation in best.items()}


@cache
def best_scripts(config: WorldConfig, *, episodes: int) -> dict[Team, tuple[Script, float]]:
    """Return the script of each team with the highest mean score in a world, and this score.

    The best of several is partly luck: of equally good scripts, the score tends to be too high.
    """
    best = {}
    for team in TEAMS:
        opponents, _ = opponents_of(team, config)
        fitting = [n for n in held_out_scripts(team, config.rules) if _plays_in(n, config)]
        means = {
            script: _scores(config, team, script, [0], opponents, episodes=episodes, seed=SEED)
            for script in fitting
        }
        found = [(script, float(each.means[0])) for script, each in means.items()]
        best[team] = max(found, key=lambda pair: pair[1])
    return best


def score_runs(
    runs: Sequence[SavedRun], *, report: Report = silent, **options: Any
) -> list[dict[Team, HeldOutScores]]:
    """Return the scores of runs, with the options of `score`, and one progress for all."""
    found = []
    for number, run in enumerate(runs):
        place = f"[{number + 1}/{len(runs)}] " if len(runs) > 1 else ""
        part = part_of(report, number, len(runs), place)
        # A reader of its own: the archives of all runs together may be large.
        found.append(score(SavedRun(run.path), report=part, **options))
    return found


def kept_scores(
    runs: Sequence[SavedRun], *, threads: int | None = None, report: Report = silent
) -> list[dict[str, Any]]:
    """Return the scores of the last generations as values of JSON, by "pursuers" and "evaders".

    They are played once and kept beside those of generation 0 and of each team's best script.
    """
    missing = [run for run in runs if _kept(run) is None]
    if missing:
        played = score_runs(missing, report=report, threads=threads)
        for run, teams in zip(missing, played, strict=True):
            best = best_scripts(run.pursuit.world, episodes=CHOICE_EPISODES)
            first = score(run, generation=0, episodes=CHOICE_EPISODES, threads=threads)
            plain = {
                f"{team}s": {
                    **each.to_json(),
                    "untrained": float(first[team].means[0]),
                    "best script": [*best[team]],
                }
                for team, each in teams.items()
            }
            files.save_json(run.path / SCORES, {**SCORED_BY, **plain})
    return [_kept(run) or {} for run in runs]


def _kept(run: SavedRun) -> dict[str, Any] | None:
    """Return the scores in a run directory; None if none are kept there, or other ones."""
    try:
        kept = files.read_json(run.path / SCORES)
    except (FileNotFoundError, files.DamagedFileError):
        return None
    # A race that has gone on has other last generations.
    teams = {team: kept.get(f"{team}s", {}) for team in run.settings.learning_teams}
    last = {team: len(genomes) - 1 for team, genomes in run.archive().items()}
    same = all(e.get("generations") == [last[run.key_of(t)]] for t, e in teams.items())
    return kept if same and kept.items() >= SCORED_BY.items() else None


# Policies that learned elsewhere:


def score_policy(
    policy: Callback | GenomePolicy | Population | TablePolicy,
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
    policy : callable, NetworkPolicy, RatingPolicy, Population, or a policy of `solver.Solution`
        A function from observations, uint8 (n, 3, fov, fov), of n living agents of the team to
        their actions, integers (n,); or from the observation of one agent to its action. The agents
        may be of several episodes. What is no function is played inside the engine.
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
        If a network does not fit the world, or a function returns no legal actions.

    Notes
    -----
    The opponents, the episodes and the random numbers of scripts are those of `score`: with the
    same world, seed and number of episodes, scores of policies and of runs can be compared. Where
    the rules take turns, functions are played turn by turn in Python, which is slower.

    Examples
    --------
    >>> import matrixworld as mw
    >>> config = mw.WorldConfig("O", rows=8, cols=8, n_pursuers=3, n_evaders=3, max_steps=20)
    >>> scores = mw.score_policy(lambda seen: [1] * len(seen), "pursuer", config, episodes=4)
    >>> scores.opponents
    ('random', 'still', 'clumsy-fleer', 'fleer', 'dodger', 'evolved-1', 'evolved-2')
    """
    config = WorldConfig.of(config)
    checks.check_choice("team", team, TEAMS)
    episodes = checks.check_integer("episodes", episodes, 2)
    seed = checks.check_integer("seed", seed, 0, checks.SEED_MAX)
    checks.check_threads(threads)
    left_out = ""
    if opponents is None:
        opponents, left_out = opponents_of(team, config)
    checks.check_instance("opponents", opponents, Mapping)
    mine = _plays("policy", policy)
    theirs = {name: _plays("opponents", each, most=1) for name, each in opponents.items()}
    checks.expect(theirs, "opponents", "at least one", "none")
    return _scores(
        config, team, mine, range(team_size(mine)), theirs, left_out, episodes=episodes, seed=seed,
        threads=threads, report=report,
    )  # fmt: skip


def _plays(name: str, policy: Any, most: int | None = None) -> Any:
    """Return a policy in the form that is played, of so many genomes at most."""
    if isinstance(policy, GenomePolicy):
        return policy.population()
    if isinstance(policy, str):
        checks.check_choice(name, policy, SCRIPTS)
    elif not callable(policy) and not isinstance(policy, Population | TablePolicy):
        expected = "a function, a NetworkPolicy or a Population"
        raise TypeError(f"{name}: expected {expected}, got {policy!r}")
    elif most is not None and team_size(policy) > most:
        raise ValueError(f"{name}: expected a single genome, got {team_size(policy)}")
    return policy
