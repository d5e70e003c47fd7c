"""Runs as users hold them: judged, replayed, extended, explained; their best policies."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cached_property
from pathlib import Path
from typing import Any, cast

from matrixworld._util.checks import check_choice
from matrixworld._util.imports import no_attribute
from matrixworld._util.readable import html_of
from matrixworld.analysis import Judgement, judge
from matrixworld.coevolution.evaluation import explanation, scores
from matrixworld.coevolution.evaluation.explanation import Explanation
from matrixworld.coevolution.evaluation.imitation import DEPTH
from matrixworld.coevolution.evaluation.standing import Standing, standing
from matrixworld.coevolution.evaluation.trials import EPISODES
from matrixworld.coevolution.games.own_game import OwnGame
from matrixworld.coevolution.games.pursuit import PursuitSettings
from matrixworld.coevolution.progress import OnEpoch, Report, silent
from matrixworld.coevolution.runs import play
from matrixworld.coevolution.runs.places import runs_in
from matrixworld.coevolution.runs.stored import StoredRun
from matrixworld.coevolution.seeding import evaluation_seed
from matrixworld.coevolution.types import TEAMS, Team

OTHER_NAMES: Mapping[str, str] = {
    **dict.fromkeys(("payoff_matrix", "payoffs", "matrix"), "run.payoff()"),
    **dict.fromkeys(("resume", "continue_run", "train"), "run.extend(generations=60)"),
    **dict.fromkeys(("champion", "get_best"), 'run.best("pursuer")'),
}
"""What people call the parts of a run, and the right calls."""


class SavedRun(StoredRun):
    """A run in a directory, finished or still training.

    `open_run` returns one whose files are checked. Its directory is the `path`. The keys of `teams`
    are ``pursuer`` and ``evader``, or the names that a game of your own has.

    `archive`, `log`, `payoff`, `summary` and `judge` return what the files hold at that moment.
    `settings` and `teams` stay as they were first read, and with them all that plays: `policy`,
    `last`, `best`, `record` and `explain`. Of a run that trains, open it again to see what has
    come since; `extend` returns it so.
    """

    def __getattr__(self, name: str) -> Any:
        raise no_attribute(self, "a run", name, OTHER_NAMES)

    def _sizes(self) -> dict[str, str]:
        """Return the size of each team's archive by the team's name, or its script."""
        script = getattr(self.settings.schedule, "opponent", "")
        names = dict.fromkeys(self.facts.teams)  # one of a symmetric game
        archive = zip(names, self.archive().values(), strict=True)
        return {name: str(len(genomes) or script) for name, genomes in archive}

    def __repr__(self) -> str:
        """Return directory, kind and seed of the run, and the size of each team's archive."""
        sizes = ", ".join(f"{name}: {size}" for name, size in self._sizes().items())
        kind = self.settings.schedule.name
        seed = self.settings.seed
        return f"{type(self).__name__}({str(self.path)!r}, {kind}, seed {seed}, {sizes})"

    def _repr_html_(self) -> str:
        game = self.settings.game
        name = game.variant
        if isinstance(game, PursuitSettings):
            name += f", {game.world.rows} x {game.world.cols} cells"
        rows = [
            ("run", f"{self.title}, {'finished' if self.finished else 'not finished'}"),
            ("game", name),
            *((f"generations of the {name}", size) for name, size in self._sizes().items()),
        ]
        if self.finished:
            payoff = self.payoff()
            rate = f"{payoff.matrix[-1, -1]:.2f}"
            rows.append((f"{payoff.words} of the last generations", rate))
        return html_of([("", str(self.path)), *rows])

    def genomes(self, team: str, generation: int | None = None) -> Any:
        """Return the genome of a generation, or those of all generations.

        A game of your own is imported, and its function `read` makes objects of what the files
        hold; `archive` returns the texts themselves, and runs no code of the game.

        Parameters
        ----------
        team : str
            Key or name of the team.
        generation : int, optional
            Its generation; negative numbers count from the end. The default is all of them.

        Returns
        -------
        object, or list of objects
            Genomes as `read` of the game returns them. Vectors are arrays (genes,) of float32, and
            all of them one array (generations, genes).

        Raises
        ------
        IndexError, ValueError
            If there is no such generation or team, or a script plays for it.
        """
        key = self.key_of(team)
        population = self.teams[key]
        if not hasattr(population, "genomes"):
            raise ValueError(f"team: expected one with genomes, got {team}: {population} plays")
        genomes = population.genomes
        if generation is not None:
            genomes = genomes[self.generation(team, generation, "generation")]
        if not self.game.texts:
            return genomes
        read = self.game.operators[TEAMS[self.settings.keys.index(key)]].genome
        texts = genomes.ravel().tolist()
        return [*map(read, texts)] if generation is None else read(texts[0])

    def judge(self) -> Judgement:
        """Return the judgement of a race; FileNotFoundError while the run is not finished."""
        return judge(self.payoff().payoffs())

    def record(self, pursuer: int = -1, evader: int = -1, episode: int = 0) -> Any:
        """Play one episode of the evaluation again and record every step.

        Of a game of your own it returns what the game shows of a match of two generations.

        Parameters
        ----------
        pursuer, evader : int, optional
            Generations; negative numbers count from the end. A script ignores them.
        episode : int, optional
            Number of the episode; without effect in a game of your own.

        Returns
        -------
        Episode, or str or Picture
            The episode; of a game of your own a text, or an image or film to save or to display.

        Raises
        ------
        IndexError, ValueError
            If there is no such generation, or a game of your own shows nothing.
        """
        if isinstance(self.settings.game, OwnGame):
            sides = zip(self.facts.keys, self.sides, (pursuer, evader), strict=True)
            genomes = [side.genomes[self.generation(key, g)] for key, side, g in sides]
            return self.game.shown(*genomes)
        pursuit = self.pursuit
        g = self.generation("pursuer", pursuer)
        h = self.generation("evader", evader)
        seed = evaluation_seed(self.settings.seed, g, h)
        return pursuit.record(*self.teams.values(), seed=seed, pursuer=g, evader=h, episode=episode)

    def extend(
        self, generations: int, *, threads: int | None = None, report: Report = silent
    ) -> SavedRun:
        """Return the run of a race that goes on until it has so many generations.

        It is the same, bit for bit, as if the race had had them from the beginning. A run that is
        stopped goes on by the same call, or as any other.

        Parameters
        ----------
        generations : int
            Generations of the whole race.
        threads, report
            As in `evolve`.

        Returns
        -------
        SavedRun
            The finished run.

        Raises
        ------
        ValueError
            If it cannot go on: fewer generations than it has, one team alone, a learner that
            anneals over the whole run, no checkpoint, or a game that has changed.
        """
        play.lengthen(self.path, generations)
        return finish(self.path, threads=threads, report=report)

    def best(self, team: str, *, sampled: bool | None = None, seed: int | None = None) -> Any:
        """Return the policy of a team that is best against held-out opponents.

        It is chosen by episodes of its own, which no score is from, in rounds: each plays fewer
        generations in more episodes. They are played once.

        Parameters
        ----------
        team, sampled, seed
            As in `policy`.

        Returns
        -------
        NetworkPolicy or RatingPolicy
            What plays. In a game of your own, which has no held-out opponents, it is the last
            generation, as `last` returns it.
        """
        if isinstance(self.settings.game, OwnGame):
            return self.last(team)
        check_choice("team", team, TEAMS)
        checked = cast("Team", team)
        generation = self._best.get(checked, -1)
        return self.policy(checked, generation, sampled=sampled, seed=seed)

    @cached_property
    def _best(self) -> dict[Team, int]:
        return scores.best_generations(self)

    def explain(
        self,
        team: str,
        generation: int = -1,
        *,
        episodes: int = EPISODES,
        seed: int = 0,
        depth: int = DEPTH,
        threads: int | None = None,
        report: Report = silent,
    ) -> Explanation | Standing:
        """Return what a generation of a team does, in words and numbers.

        Of a policy that rates moves it tells what its inputs do and cost; of a network over cells
        it has a decision tree that imitates it (extra ``explain``). Of a game of your own it tells
        the genome, and whom it wins and loses against; other arguments have no effect there.

        Parameters
        ----------
        team, generation
            As in `policy`.
        episodes : int, optional
            Episodes against each held-out opponent, at least 2.
        seed : int, optional
            Seed of the matches, which no other call plays.
        depth : int, optional
            Depth of a tree, 3 to 6.
        threads, report
            As in `evolve`.

        Returns
        -------
        Explanation or Standing
            What the team does; it prints as sentences and a table.

        Raises
        ------
        IndexError, ValueError, MissingExtraError
            If there is no such generation or team, a script plays for it, it has memory, a number
            is too small or too large, or a tree needs scikit-learn.
        """
        if isinstance(self.settings.game, OwnGame):
            return standing(self, team, generation)
        member = cast("Team", team)  # as `policy` checks
        policy = self.policy(member, generation, seed=seed)
        world = self.pursuit.world
        opponents, _ = scores.opponents_in(self, member, world)
        return explanation.explain(
            policy,
            member,
            world,
            opponents=opponents,
            generation=self.generation(team, generation),
            episodes=episodes,
            seed=seed,
            depth=depth,
            threads=threads,
            report=report,
        )


def open_run(directory: str | Path) -> SavedRun:
    """Return the run in a directory, whether it is finished or not.

    Parameters
    ----------
    directory : str or Path
        Directory of the run.

    Returns
    -------
    SavedRun
        The run, whose files have been checked.

    Raises
    ------
    FileNotFoundError, DamagedFileError, OtherVersionError
        If the directory holds no run, a cut or altered one, or one of another version.
    """
    run = SavedRun(directory)
    # Damage and other versions are told here. A game of your own is not imported yet.
    if isinstance(run.settings.game, OwnGame):
        run.archive()
    else:
        run.teams  # noqa: B018, they are read now
    return run


def open_runs(directory: str | Path) -> list[SavedRun]:
    """Return the finished runs in a directory, by schedule and seed.

    Parameters
    ----------
    directory : str or Path
        Directory of a run, or of runs up to two levels below.

    Returns
    -------
    list of SavedRun
        The runs that are finished.

    Raises
    ------
    FileNotFoundError
        If the directory holds no run; other errors are those of `open_run`.
    """
    return [open_run(path) for path in runs_in(Path(directory)) if StoredRun(path).finished]


def finish(
    directory: str | Path,
    *,
    threads: int | None = None,
    report: Report = silent,
    on_epoch: OnEpoch | None = None,
) -> SavedRun:
    """Return the finished run of a directory: play what is left of it.

    An executor can call it wherever the directory has the same path. Errors are those of `Run` and
    of `Run.run`.

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
    play.go_on(directory, threads=threads, report=report, on_epoch=on_epoch)
    return SavedRun(directory)
