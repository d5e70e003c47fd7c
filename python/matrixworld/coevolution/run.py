"""A run: stages of learning, each saved at its end, and then an evaluation.

A kind of race says what a stage is and how teams learn in it (`race`); a `RunInMemory` is what its
loop works with, and a `Run` is one in a directory. Everything that a stage changes (states of
learners and samplers, archive, counters, log) is saved at its end. A run that is stopped within a
stage, even by a power cut, repeats that stage when it goes on, and ends bit for bit as if it had
never been stopped.
"""

from __future__ import annotations

import sys
import warnings
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from matrixworld._util import checks
from matrixworld.analysis import disengagements
from matrixworld.analysis.progress import PATIENCE, Disengagement
from matrixworld.coevolution import storage, types
from matrixworld.coevolution.evaluation.tournament import tournament
from matrixworld.coevolution.fitness import Table
from matrixworld.coevolution.game import Game, Scores
from matrixworld.coevolution.learners.learner import Learner, Results, check_genomes
from matrixworld.coevolution.opponents import Opponents
from matrixworld.coevolution.progress import LOG, OnEpoch, Progress, Report, silent
from matrixworld.coevolution.pursuit import SCRIPTS, Pursuit, WorldConfig
from matrixworld.coevolution.race import Against, OfGenerations
from matrixworld.coevolution.sections import different_settings, no_exit
from matrixworld.coevolution.seeding import Phase, Purpose, keyed_generator, training_seeds
from matrixworld.coevolution.settings import RaceSettings
from matrixworld.coevolution.types import TEAMS, FloatArray, Genomes, Indices, Matches, Seeds, Team

GIVEN = "given as genomes"
"""Value of the settings `opponent` and `start` if these were given as arrays."""


class DisengagementWarning(UserWarning):
    """One team wins nearly everything, so that neither team has much to learn from."""


# New runs:


@no_exit("create")
def create(
    settings: RaceSettings,
    directory: str | Path,
    *,
    opponents: Any = None,
    start: ArrayLike | None = None,
) -> storage.SavedRun:
    """Make the directory of a run, as of its stage 0: nothing is played yet.

    Parameters
    ----------
    settings : RaceSettings
        Settings of the run.
    directory : str or Path
        A new or empty directory; one that holds a run of the same settings is left as it is.
    opponents : population, optional
        Opponents of a team that learns alone, in place of `schedule.opponent`.
    start : array_like of float32, optional
        Genome (genes,) that such a team starts from, in place of `schedule.start`.

    Returns
    -------
    SavedRun
        The run.

    Raises
    ------
    FileExistsError, ValueError, PluginError
        If the directory holds anything else, opponents do not fit the world, or code of your own
        fails or refuses its settings. Nothing is written then.
    """
    checks.check_instance("settings", settings, RaceSettings)
    path, schedule = Path(directory), settings.schedule
    given = [n for n, value in (("opponent", opponents), ("start", start)) if value is not None]
    if storage.SavedRun(path).exists and not given:
        check_same(storage.SavedRun(path), settings)
        return storage.SavedRun(path)
    # Everything that can be wrong is checked before the directory is made.
    begin: types.Genome | None = None
    archive: dict[Team, Any] = {team: [] for team in TEAMS}
    config: dict[str, Any] = {}
    if isinstance(schedule, Against):
        rivals, begin = check_sources(settings, opponents, start)
        if not isinstance(rivals, str):
            archive[types.other(schedule.team)] = rivals.genomes
            if shape := settings.evaluation_game.shape_of(rivals):
                config["opponent_policy"] = shape
        # config.json must not name opponents that were not used.
        settings = settings.changed({f"schedule.{name}": GIVEN for name in given})
    learned, states = settings.beginning(begin)
    archive |= learned
    with storage.new_directory(path) as place:
        storage.RunWriter(place).begin(settings.to_json(), archive, states, **config)
    return storage.SavedRun(path)


def check_sources(
    settings: RaceSettings, opponents: Any = None, start: ArrayLike | None = None
) -> tuple[Any, types.Genome | None]:
    """Return the opponents and the genome to start from, those given or those of the settings."""
    schedule, game = settings.schedule, settings.evaluation_game
    assert isinstance(schedule, Against)
    policy: Any = opponents
    if opponents is None and schedule.opponent in SCRIPTS and isinstance(game, Pursuit):
        policy = schedule.opponent
    elif opponents is None:
        policy = _last(settings, schedule.opponent, types.other(schedule.team))
    game.check_opponents(types.other(schedule.team), policy)
    if start is None and schedule.start is not None:
        population = _last(settings, schedule.start, schedule.team)
        game.check_start(population)
        start = population.genomes[0]
    if start is None:
        return policy, None
    genome, size = checks.check_floats("start", start, np.float32), game.genome_size(schedule.team)
    fits = genome.shape == (size,) and np.isfinite(genome).all()
    checks.expect(fits, "start", f"{size} finite genes", f"shape {genome.shape}")
    return policy, genome


def _last(settings: RaceSettings, directory: str, team: Team) -> Any:
    """Return the last genome of a team in a run of the same game; ValueError for another one."""
    found, expected = storage.open_run(directory).settings.game, settings.game
    wanted, got = (each.code if each else "pursuit" for each in (expected, found))
    checks.expect(got == wanted, directory, f"a run of {wanted}", f"one of {got}")
    return storage.last_generation(directory, team)


def check_same(run: storage.SavedRun, expected: RaceSettings) -> None:
    """Raise ValueError if a run has other settings than expected."""
    different = different_settings(run.settings, expected)
    if different:
        raise ValueError(f"{run.path}: holds a run with other settings: {', '.join(different)}")


# Runs in memory:


class RunInMemory:
    """A race in memory, with all that its loop works with.

    The `settings` are those of a race; `threads` play its matches, by default one per usable core,
    which results do not depend on. Its parts are the `game` in which teams learn, the genomes of
    each team by generation (`archive`), the `states` of learners by team and of their samplers as
    ``<team>.opponents``, the log as dicts (`rows`), the number of finished stages (`stage`), and
    `counts` of training episodes, ``matches``; of pursuit also ``steps`` and ``agent_steps``.
    """

    def __init__(self, settings: RaceSettings, *, threads: int | None = None) -> None:
        checks.check_instance("settings", settings, RaceSettings)
        checks.check_threads(threads)
        self.settings: RaceSettings = settings
        self.threads: int | None = threads
        teams = settings.learning_teams
        self.learners: dict[Team, Learner] = {team: settings.learner_of(team) for team in teams}
        self.samplers: dict[Team, Opponents] = {
            team: settings.schedule.sampler(team) for team in teams
        }
        self.game: Game = settings.training_game
        self.rows: list[storage.Row] = []
        self.stage: int = 0
        self.counts: dict[str, int] = dict.fromkeys(("matches", *self.game.counters), 0)
        self.archive: dict[Team, list[types.Genome]]
        self.states: dict[str, types.State]
        self._begin()

    def _begin(self) -> None:
        got = "those of one team alone"
        checks.expect(self.settings.is_race, "settings", "those of a race", got)
        self.archive, self.states = self.settings.beginning()

    def train(self) -> None:
        """Run all stages that are left."""
        while self.stage < self.settings.schedule.n_stages:
            self.learn(self.stage)
            self.end_stage()

    def learn(self, stage: int) -> None:
        """Run one stage, as the kind of race says."""
        if isinstance(self.settings.training_game, Pursuit):
            self.play_in(self.settings.training_game.world)  # until an epoch draws another one
        self.settings.schedule.learn(self, stage)

    def end_stage(self) -> None:
        """Count a stage."""
        self.stage += 1

    # What the loop of a race works with:

    def genomes(self, team: Team) -> Genomes:
        """Return a team's archive as one array (generations, genes) float32."""
        archive, size = self.archive[team], self.game.genome_size(team)
        return np.stack(archive) if archive else np.empty((0, size), np.float32)

    def name_of(self, team: Team) -> str:
        """Return what the game calls a team."""
        return self.settings.teams[TEAMS.index(team)]

    def population(self, team: Team, genomes: Genomes) -> Any:
        """Return genomes (n, genes) of a team as what plays; DivergedError for too large ones."""
        try:
            return self.game.population(team, genomes)
        except ValueError as error:
            if np.shape(genomes)[1:] != (self.game.genome_size(team),):  # by a learner of your own
                raise
            path = self.settings.learner_path(team)
            raise self.learners[team].diverged(path, str(error)) from error

    def opponents(self, team: Team) -> Any:
        """Return whom a team can meet now: all generations of the other team."""
        return self.population(types.other(team), self.genomes(types.other(team)))

    def generator(self, purpose: Purpose, team: Team, generation: int, epoch: int) -> types.Rng:
        """Return the random numbers of a team in an epoch."""
        return keyed_generator(self.settings.seed, purpose, TEAMS.index(team), generation, epoch)

    def begin_epoch(self, team: Team, generation: int, epoch: int) -> None:
        """Draw the world of an epoch; where both teams learn at once, `team` is the first."""
        if self.settings.training_worlds:
            rng = self.generator(Purpose.WORLD, team, generation, epoch)
            self.play_in(self.settings.drawn_world(rng))

    def play_in(self, world: WorldConfig) -> None:
        """Play the matches that follow in another world."""
        self.game = replace(self.game, world=world)  # type: ignore[call-arg]  # of pursuit

    def ask(self, team: Team, generation: int, epoch: int) -> Genomes:
        """Return the candidates (n, genes) of a team."""
        rng = self.generator(Purpose.LEARN, team, generation, epoch)
        learner = self.learners[team]
        candidates, self.states[team] = learner.ask(self.states[team], rng)
        expected = len(learner.seed_groups), self.game.genome_size(team)
        name = f"ask of {self.settings.learner_path(team)} {learner.kind or type(learner).__name__}"
        check_genomes(name, candidates, expected)
        return candidates

    def tell(
        self, team: Team, fitness: FloatArray, opponents: Any, met: Indices, seeds: Seeds
    ) -> None:
        """Let a team learn from the fitness (n,) of its candidates.

        `met` and `seeds` (M,) are its matches against `opponents`; the learner may play them again.
        """

        def again(*, states: bool = False) -> Any:
            genome = self.learners[team].genome(self.states[team])
            return self.game.experience(
                team, self.population(team, genome[np.newaxis]), opponents, met, seeds,
                worlds=self.settings.match_episodes, states=states, threads=self.threads,
            )  # fmt: skip

        state, results = self.states[team], Results(fitness, again)
        self.states[team] = self.learners[team].tell(state, results)

    def update_sampler(self, team: Team, own: int, available: int) -> None:
        """Tell a sampler at the begin of a generation how many generations of both teams exist."""
        name, payoff = f"{team}.opponents", partial(self._payoff, team)
        updated = self.samplers[team].update(self.states[name], own, available, payoff)
        self.states[name] = updated

    def sample(self, team: Team, available: int, count: int, epoch: int, rng: types.Rng) -> Indices:
        """Return the opponents (c,) of a team in an epoch."""
        state = self.states[f"{team}.opponents"]
        return self.samplers[team].sample(state, available, count, epoch, rng)

    def tell_sampler(self, team: Team, met: Indices, rates: FloatArray) -> None:
        """Tell a sampler the win rates (n, c) of n candidates against the opponents (c,)."""
        name = f"{team}.opponents"
        self.states[name] = self.samplers[team].tell(self.states[name], met, rates)

    def archive_genome(self, team: Team, genome: types.Genome) -> None:
        """Add a genome to the archive of a team; DivergedError if it is not finite."""
        self.archive[team].extend(self.population(team, genome[np.newaxis].copy()).genomes)

    def report(self, activity: str, evaluated: int = 0) -> None:
        """Report the current activity, and evaluation episodes played so far: to nobody."""

    # Matches:

    def play(self, pursuers: Any, evaders: Any, matches: Matches) -> Scores:
        """Play and count M matches; the arrays of the result have shape (M, episodes, ...)."""
        episodes, threads = self.settings.match_episodes, self.threads
        scores = self.game.scores(pursuers, evaders, matches, episodes=episodes, threads=threads)
        for name, count in {"matches": scores.scores.size, **self.game.counted(scores)}.items():
            self.counts[name] += count
        return scores

    def play_candidates(
        self, team: Team, candidates: Genomes, opponents: Any, met: Indices, seeds: Seeds
    ) -> Scores:
        """Play each candidate (n, genes) of a team against the opponents of some indices (c,).

        Returns the statistics of n * c matches in the order of ``seeds.ravel()``, seeds (n, c): the
        matches of a candidate are adjacent. A script has no indices, and ignores them.
        """
        n, c = seeds.shape
        rivals = np.full((n, c), 0 if isinstance(opponents, str) else met, np.int32)
        own = np.repeat(np.arange(n, dtype=np.int32), c)
        learning = self.population(team, candidates)
        if team == "pursuer":
            return self.play(learning, opponents, (own, rivals.ravel(), seeds.ravel()))
        return self.play(opponents, learning, (rivals.ravel(), own, seeds.ravel()))

    def fitness(self, team: Team, scores: Scores, table: Table) -> FloatArray:
        """Return the fitness (n,) of a team's individuals, as the settings define it."""
        return self.settings.fitness.fitness(self.game, scores, team, table)

    def log_fitness(
        self, team: Team, scores: Scores, table: Table, generation: int, epoch: int, opponent: int
    ) -> FloatArray:
        """Return the fitness (n,) of a team's individuals, and log the epoch (see `COLUMNS`)."""
        fitness = self.fitness(team, scores, table)
        row: storage.Row = {
            "stage": self.stage + 1,
            "generation": generation,
            "team": self.settings.keys[TEAMS.index(team)],
            "epoch": epoch,
            "opponent": opponent,
            "fitness_mean": float(fitness.mean()),
            "fitness_std": float(fitness.std()),
            "fitness_best": float(fitness.max()),
            **self.game.row(scores),
            **self._logged_counts(),
        }
        self.log(row)
        return fitness

    def log(self, row: storage.Row) -> None:
        """Add an epoch to the log."""
        self.rows.append(row)

    def champion(
        self,
        team: Team,
        generation: int,
        candidates: Genomes,
        fitness: FloatArray,
        opponents: Any,
        met: Indices,
    ) -> types.Genome:
        """Return the genome that enters the archive, from the last epoch of a generation.

        It is the learner's. With `retest_episodes` it is the best of that one and the two fittest
        candidates in new matches: the fittest candidate of the epoch may be the luckiest one.
        """
        genome = self.learners[team].genome(self.states[team])
        episodes = self.settings.retest_episodes
        if not episodes:
            return genome
        best = np.argsort(-fitness, kind="stable")[:2]
        genomes = np.stack([genome, *candidates[best]])
        n, c = len(genomes), len(met)
        key = (self.settings.seed, generation, generation, Phase.RETEST, TEAMS.index(team))
        seeds = np.tile(training_seeds(*key, c * episodes), (n, 1))
        scores = self.play_candidates(team, genomes, opponents, np.repeat(met, episodes), seeds)
        self._count_in_last_epoch()
        again = self.fitness(
            team, scores, lambda values: np.asarray(values.reshape(n, c, episodes).mean(axis=2))
        )
        champion: types.Genome = genomes[np.argmax(again)]
        return champion

    def _count_in_last_epoch(self) -> None:
        """Count matches after an epoch in its rows: two where both teams learn at once."""
        last = self.rows[-1]["matches"]
        for row in self.rows:
            if row["matches"] == last:
                row |= self._logged_counts()

    def _logged_counts(self) -> dict[str, int]:
        """Return what the log has of the counts."""
        return {name: n for name, n in self.counts.items() if name in self.game.columns}

    def _payoff(self, team: Team, own: Indices, rivals: Indices) -> FloatArray:
        """Play generations (n,) of a team against opponents (m,), and return the payoffs (n, m)."""
        met = {team: own, types.other(team): rivals}
        episodes = getattr(self.samplers[team], "episodes", 1)
        # The order of the seeds: all episodes of a pair, which have seeds of their own, then the
        # next pair.
        pairs = [(int(g), int(h)) for g in met["pursuer"] for h in met["evader"]]
        seeds = [
            training_seeds(self.settings.seed, g, h, Phase.ARCHIVE, 0, episodes) for g, h in pairs
        ]
        pursuers, evaders = (self.population(each, self.genomes(each)) for each in TEAMS)
        g, h = np.repeat(pairs, episodes, axis=0).T
        scores = self.play(pursuers, evaders, (g, h, np.concatenate(seeds)))
        rates = scores.scores.mean(axis=1, dtype=np.float64)
        shape = len(met["pursuer"]), len(met["evader"]), episodes
        captured = np.asarray(rates.reshape(shape).mean(axis=2))
        return captured if team == "pursuer" else 1.0 - captured.T


# Runs that go on:


class Run(RunInMemory):
    """A run that goes on in its directory, from its last finished stage.

    The `directory` is one that `create` has made; `threads` are as for `RunInMemory`.

    FileNotFoundError, OtherVersionError or DamagedFileError if the directory holds no run of this
    version, or no intact stage with a checkpoint; ValueError if its game cannot be imported, is
    another one, or has changed; LockedError if another process runs it.
    """

    def __init__(self, directory: str | Path, *, threads: int | None = None) -> None:
        self.files: storage.RunWriter = storage.RunWriter(directory)
        check_source(self.files)
        self._report: Report = silent
        self._on_epoch: OnEpoch | None = None
        super().__init__(self.files.settings, threads=threads)

    def _begin(self) -> None:
        with self.files.lock():
            self._restore()

    def run(self, report: Report = silent, on_epoch: OnEpoch | None = None) -> storage.SavedRun:
        """Go on to the end; `report` and `on_epoch` are called as by `evolve`.

        After any error the files hold the last finished stage, from which the run goes on.
        """
        self._report, self._on_epoch = report, on_epoch
        schedule, path = self.settings.schedule, self.files.path
        with self.files.lock():
            # Also if this object has just been made: an interrupted stage has changed states, and
            # another process may have continued the run.
            self._restore()
            LOG.info("%s: goes on from stage %d of %d", path, self.stage, schedule.n_stages)
            self._before = schedule.epochs_until(self.stage)
            self._total = total_epochs(self.settings)
            self.train()
            if self.files.finished:
                self.files.summary()  # only to raise an error if one of them is damaged
                self.files.payoff()
            else:
                with no_exit(f"evaluation of the run {path}"):
                    payoff = self.evaluate()
                self.files.save_results(payoff.arrays(), self.summary(payoff))
                LOG.info("%s: ended", path)
        return storage.SavedRun(path)

    def learn(self, stage: int) -> None:
        """Run one stage, as the kind of race says; errors tell which one."""
        where = f"stage {stage + 1} of the run {self.files.path}"
        try:
            with no_exit(where):
                super().learn(stage)
        except Exception as error:
            if sys.version_info >= (3, 11):
                error.add_note(f"in {where}")
            raise

    def evaluate(self) -> types.Payoff:
        """Play the finalists of one team against those of the other, on episodes of their own."""
        finalists = self.settings.schedule.finalists(self)
        (pursuers, g), (evaders, h) = (finalists[team] for team in TEAMS)
        known = self.files.payoff() if (self.files.path / storage.PAYOFF).exists() else None
        return tournament(
            self.settings.evaluation_game, pursuers, evaders, seed=self.settings.seed,
            episodes=self.settings.evaluation_episodes, threads=self.threads, generations=(g, h),
            known=known, report=lambda now: self.report(now.what, now.done),
        )  # fmt: skip

    def summary(self, payoff: types.Payoff) -> dict[str, Any]:
        """Return the most important numbers of the run, which summary.json holds."""
        counters = {f"training_{name}": count for name, count in self.counts.items()}
        return {
            "stages": self.stage,
            **counters,
            "evaluation_matches": payoff.scores.size,
            **self.settings.schedule.summary(self, payoff),
        }

    # Stages:

    def end_stage(self) -> None:
        """Count and save a finished stage; warn once of each disengagement."""
        # In the second half of the epochs the team has mostly adapted to its opponents.
        score, *_ = self.game.columns
        rates = [row[score] for row in self.rows[len(self.rows) // 2 :]]
        self.stage_scores.append(float(np.mean(rates)))
        super().end_stage()
        counters = {**self.counts, "score": self.stage_scores[-1]}
        self.files.save(self.stage, self.archive, self.rows, counters, self.states)
        path, schedule = self.files.path, self.settings.schedule
        LOG.info("%s: saved stage %d of %d", path, self.stage, schedule.n_stages)
        self.rows = []
        generation, left = divmod(self.stage, schedule.stages_per_generation)
        for stretch in self.disengagements() if not left else ():
            # Equal, not at least: a longer stretch has been reported before.
            if stretch.last == generation and len(stretch) == PATIENCE:
                told = stretch.in_words(self.settings.teams)
                warnings.warn(told, DisengagementWarning, stacklevel=4)

    def disengagements(self) -> tuple[Disengagement, ...]:
        """Return the stretches of finished generations in which one team won everything."""
        if not self.settings.is_race:
            return ()
        stages = self.settings.schedule.stages_per_generation
        finished = self.stage // stages
        rates = np.array(self.stage_scores[: finished * stages]).reshape(finished, stages)
        # If a stage is a generation, both phases have its rate.
        return disengagements(np.broadcast_to(rates, (finished, 2)))

    def _restore(self) -> None:
        stages, archive, self.states = self.files.restore()
        self.stage = len(stages) - 1  # stage 0 is before training
        self.stage_scores: list[float] = [float(each["score"]) for each in stages[1:]]
        self.counts = {name: int(stages[-1][name]) for name in ("matches", *self.game.counters)}
        self.archive = {team: [*archive[team]] for team in TEAMS}
        self.rows = []

    # Where the loop meets the directory:

    def opponents(self, team: Team) -> Any:
        """Return whom a team can meet now: all generations of the other team, or its script."""
        return self.files.as_policy(types.other(team), self.genomes(types.other(team)))

    def log(self, row: storage.Row) -> None:
        """Add an epoch to the log, and report it."""
        super().log(row)
        if self._on_epoch is not None:
            name = self.files.path.absolute().name
            self._on_epoch({"run": name, "seed": self.settings.seed, **row})

    def report(self, activity: str, evaluated: int = 0) -> None:
        """Report the progress: the current activity, and evaluation episodes played so far."""
        done = self.settings.schedule.epochs_until(self.stage)
        done += len({row["epoch"] for row in self.rows}) + self.settings.in_epochs(evaluated)
        # A team alone may be evaluated against several opponents.
        self._report(Progress(activity, min(done, self._total), self._total, self._before))


def check_source(run: storage.SavedRun) -> None:
    """Raise ValueError if a game of your own has changed since a run began."""
    if run.settings.game and (changed := run.settings.game.changed()):
        raise ValueError(f"{run.path}: {changed}; evolve --resume with --force goes on with it")


def accept_source(directory: str | Path) -> None:
    """Let a run go on with the game as it is now, whose source has changed."""
    files = storage.RunWriter(directory)
    with files.lock():
        game = files.settings.game
        if game is not None and game.changed():
            files.change(replace(files.settings, game=replace(game, digest="")))


def lengthen(directory: str | Path, generations: int, *, only_check: bool = False) -> None:
    """Let a race have more generations; it then goes on as if it had had them from the beginning.

    ValueError if that cannot be; see `SavedRun.extend`.
    """
    files = storage.RunWriter(directory)
    with files.lock():
        settings, path = files.settings, files.path
        schedule = settings.schedule
        check_source(files)
        if not isinstance(schedule, OfGenerations):
            raise ValueError(f"{path}: expected a race, got a run of one team")
        longer = checks.check_integer("generations", generations, 1) >= schedule.generations
        expected = f"at least the {schedule.generations} of {path}"
        checks.expect(longer, "generations", expected, generations)
        for team in settings.learning_teams:
            name = f"{path}: {settings.learner_path(team)}.anneal"
            falls = getattr(settings.learner_of(team), "anneal", False)
            got = "true: its rates depend on the number of all epochs"
            checks.expect(not falls, name, "false in a race that becomes longer", got)
        expected, got = "the checkpoint of its last stage", "none, as in a race that a page saved"
        checks.expect(files.newest() in files.numbers("checkpoint"), str(path), expected, got)
        if not only_check:
            files.change(settings.changed({"schedule.generations": generations}))


def total_epochs(settings: RaceSettings) -> int:
    """Return the epochs of a run, and those that take as long as its evaluation."""
    schedule = settings.schedule
    pairs = schedule.entries**2 if settings.is_race else 1
    evaluation = settings.in_epochs(pairs * settings.evaluation_episodes)
    return schedule.epochs_until(schedule.n_stages) + evaluation


def finish(
    directory: str | Path,
    *,
    threads: int | None = None,
    report: Report = silent,
    on_epoch: OnEpoch | None = None,
) -> storage.SavedRun:
    """Return the finished run of a directory: play what is left of it.

    An executor can call it wherever the directory has the same path. Errors are those of `Run`.

    Parameters
    ----------
    directory : str or Path
        A directory that `create` has made, of a run which may have begun.
    threads : int, optional
        As in `Run`.
    report, on_epoch : callable, optional
        As in `evolve`.

    Returns
    -------
    SavedRun
        The finished run.
    """
    files = storage.RunWriter(directory)
    if files.exists and files.finished and not [*files.path.glob("checkpoint-*")]:  # of a page
        files.payoff()
        return storage.SavedRun(directory)
    return Run(directory, threads=threads).run(report, on_epoch)
