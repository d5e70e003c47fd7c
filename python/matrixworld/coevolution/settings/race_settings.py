"""Settings: everything that defines a run. Runs with equal settings are equal bit for bit.

The number of threads is not a setting, because results do not depend on it.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping
from dataclasses import field, replace
from difflib import get_close_matches
from functools import cache, cached_property, partial
from operator import attrgetter
from pathlib import Path
from typing import Any

from matrixworld._util import checks, sections
from matrixworld._util.checks import INT_MAX, shown
from matrixworld._util.constraints import Whole
from matrixworld._util.sections import (
    NAMES,
    OWN,
    Section,
    SettingError,
    UnknownSettingError,
    setting,
)
from matrixworld.coevolution.games.game import Game, GameSettings
from matrixworld.coevolution.games.guarantee import Guaranteed, check_guarantee
from matrixworld.coevolution.games.own_game import OwnGame
from matrixworld.coevolution.games.policies import Cells, PolicySettings
from matrixworld.coevolution.games.pursuit import (
    BEST_RESPONSE,
    GUARANTEE,
    SCRIPTS,
    PursuitSettings,
    is_path,
)
from matrixworld.coevolution.learners import ActorCritic, EvolutionStrategy, OwnLearner
from matrixworld.coevolution.learners.learner import Learner, Task
from matrixworld.coevolution.opponents import NashOpponents
from matrixworld.coevolution.settings.schedules import (
    GIVEN,
    SCHEDULES,
    Against,
    AtOnce,
    InTurns,
    OfGenerations,
    Schedule,
    SelfPlay,
)
from matrixworld.coevolution.settings.usual import (
    COURTYARD,
    DEFAULTS,
    EPOCHS,
    GUARANTEED,
    HALL,
    PAPER,
    POLICY,
    SCHEDULE,
    Kinds,
    usual,
    usual_learner,
    usual_of_learner,
)
from matrixworld.coevolution.types import TEAMS, Genome, Team

MOST_SEED = 2**63 - 1  # largest seed: the largest integer of 64 bits with a sign

OF_PURSUIT = tuple(item.name for item in sections.settings_of(PursuitSettings))
"""Settings of pursuit, whose paths are written without ``game.``: ``world.rows``."""
SHORT = {"variant": ("world.rules",), "size": ("world.rows", "world.cols")}
"""Names of settings that are not the last part of their path."""


def _full(path: str) -> str:
    """Return the path of a setting among the fields of `RaceSettings`."""
    return f"game.{path}" if path.partition(".")[0] in OF_PURSUIT else path


def _short(path: str) -> str:
    """Return the path of a setting as users write it."""
    inner = path.removeprefix("game.")
    return inner if inner.partition(".")[0] in OF_PURSUIT else path


@sections.section()
class RaceSettings(Section):
    """Settings of a run: a race, in which both teams learn, or one team `Against` fixed opponents.

    `RaceSettings.of` makes them of names and changes, with the defaults that follow from these. The
    constructor takes whole sections instead, and its defaults are always the same:
    ``RaceSettings(schedule=Against())`` has the learner of a race.

    `chosen` has what was chosen, by path; all else follows from it. It is no setting: settings with
    equal values are equal. What a constructor was given counts as chosen.
    """

    game: GameSettings = setting(
        PursuitSettings(),
        "a game of your own, as module:object; default: pursuit and evasion in the world",
    )
    learner: Learner | OwnLearner = setting(
        EvolutionStrategy(),
        f"how teams learn: {', '.join(sections.names_in(Learner))} or module:object",
    )
    schedule: Schedule = setting(
        SCHEDULES[SCHEDULE], "whom teams meet while they learn, and for how long"
    )
    match_episodes: int = setting(1, "episodes of each training match", Whole(1))
    retest_episodes: int = setting(
        0,
        "new matches, at the end of a generation, of the learner's genome and of the two fittest "
        "candidates against each of the last opponents, those of the fittest one; the best enters "
        "the archive; 0: the learner's genome does",
    )
    evaluation_episodes: int = setting(10, "evaluation episodes of each pair", Whole(1))
    seed: int = setting(0, "seed of the run", Whole(0, MOST_SEED))
    chosen: Mapping[str, Any] | None = field(default=None, compare=False, repr=False)

    # From choices to settings:

    @classmethod
    def of(cls, *values: Mapping[str, Any], **named: Any) -> RaceSettings:
        """Return settings from what is chosen, by path, such as ``{"learner.sigma": 0.2}``.

        All other settings have the defaults that follow from it. A section is chosen by its name,
        as in ``{"learner": "ga"}``; it may be a nested mapping, or a section, which is then chosen
        as a whole. None takes a choice back. Later mappings change earlier ones. `named` are
        settings by the last part of their path, such as ``sigma=0.2``, or by the names in `SHORT`.
        Code of your own is named only, and not imported.

        Raises
        ------
        SettingError
            If a path is unknown, or its value bad or without effect; the message begins with it.
            It is a ValueError and a TypeError.
        TypeError
            If a name is none of a setting, or of several.
        """
        chosen: dict[str, Any] = {}
        for mapping in (*values, _by_path(named)):
            new = {_short(path): value for path, value in sections.flat(mapping).items()}
            if "game" in new and new["game"] != chosen.get("game"):
                # What is known of another game.
                chosen = {path: v for path, v in chosen.items() if not path.startswith("game.")}
            chosen |= new
        if chosen.get("game") == PursuitSettings.kind:
            del chosen["game"]
        if chosen.get("game") is not None:
            chosen |= _facts_of_game(chosen)
        in_effect = {path: value for path, value in chosen.items() if value is not None}
        _check_taken_back(chosen.keys() - in_effect.keys())
        with sections.below(""):
            checks.check_choice(DEFAULTS, in_effect.get(DEFAULTS, PAPER), (PAPER, COURTYARD))
        settings = _built({**usual(kinds_of(in_effect)), **in_effect}, chosen)
        settings._check_effect(in_effect.keys())
        if isinstance(chosen.get("world.obstacles"), str):  # a file, which may change
            chosen["world.obstacles"] = settings.values()["world.obstacles"]
        return settings

    def changed(self, changes: Mapping[str, Any]) -> RaceSettings:
        """Return the settings with some changes: those `of` what was chosen and of the changes.

        Parameters
        ----------
        changes : mapping of str to any
            Values by their paths, as for `of`.

        Raises
        ------
        SettingError
            As in `of`.

        Examples
        --------
        >>> from matrixworld.coevolution import RaceSettings
        >>> settings = RaceSettings().changed({"learner": "ga", "schedule.generations": 5})
        >>> settings.learner.kind, settings.schedule.generations
        ('ga', 5)
        """
        chosen = self.choices()
        try:
            return RaceSettings.of(chosen, changes)
        except UnknownSettingError as error:
            if error.path not in chosen or error.path in sections.flat(changes):
                raise
            got = f"{shown(chosen[error.path])}, which was chosen before; None takes it back"
            raise UnknownSettingError(error.path, error.expected, got) from None

    def choices(self) -> dict[str, Any]:
        """Return what was chosen, by path, and what is other than it would follow from that.

        Such are the fields that a constructor or `dataclasses.replace` was given, and the settings
        of a run whose version had other defaults.
        """
        values = self.values()
        for path, _ in self._without_effect():
            values.pop(path, None)  # chosen by nobody: it would be refused
        # `dataclasses.replace` may have put another section in the place of one that was chosen.
        chosen = {path: v for path, v in (self.chosen or {}).items() if self._has_place(path)}
        while True:
            try:
                following = RaceSettings.of(chosen).values()
            except SettingError:  # what was chosen fits only beside the others
                following = {}
            others = {
                path: value
                for path, value in values.items()
                if path not in following or value != following[path]
            }
            if others.items() <= chosen.items():
                return chosen
            chosen |= others  # other defaults may follow from them

    def _has_place(self, path: str) -> bool:
        """Return whether a path is that of a setting, of a section, or of a setting of own code."""
        values = self.values()
        section_of_path, _, _ = path.rpartition(".")
        is_section = any(other.startswith(f"{path}.") for other in values)
        is_of_own_code = isinstance(values.get(section_of_path), Mapping)
        return path in values or path == DEFAULTS or is_section or is_of_own_code

    def values(self) -> dict[str, Any]:
        """Return every single setting by its path, as values that JSON can hold."""
        values = {_short(path): value for path, value, _ in self.leaves()}
        if isinstance(self.game, PursuitSettings):
            del values["game"]  # the only one of its kind
        return values

    def help(self) -> dict[str, str]:
        """Return what every single setting means, by its path."""
        return {_short(path): text for path, _, text in self.leaves()}

    def to_json(self) -> dict[str, Any]:
        """Return the settings as nested values that JSON can hold, and what was ``chosen``."""
        return {"chosen": self.choices(), **super().to_json()}

    @classmethod
    def from_json(cls, plain: Mapping[str, Any]) -> RaceSettings:
        """Return the settings of `to_json`: each as it was, whatever would follow today."""
        values = {name: value for name, value in plain.items() if name != "chosen"}
        chosen = plain.get("chosen")
        return _built(sections.flat(values), None if chosen is None else sections.flat(chosen))

    # What fits together:

    def check(self) -> None:
        """Raise SettingError unless all sections fit together."""
        if self.chosen is None:
            self._check_effect(self.values().keys())
        # One of your own is not imported yet.
        known = {self.learner_path(t): self.learner_settings(t) for t in self.learning_teams}
        learners = {path: each for path, each in known.items() if isinstance(each, Learner)}
        for path, learner in learners.items():
            self._check_measure(path, getattr(learner, "measure", ""))
        if isinstance(self.game, PursuitSettings):
            self._check_pursuit(self.game)
        else:
            self._check_own_game()
        for path, learner in learners.items():
            learner.check_race(path, self.game)

    def _check_effect(self, chosen: Collection[str]) -> None:
        """Raise SettingError for a value of a path in `chosen` that has no effect."""
        for path, why in self._without_effect():
            *parents, name = _full(path).split(".")
            section = attrgetter(".".join(parents))(self)
            defaults = {item.name: item.default for item in sections.settings_of(type(section))}
            value = getattr(section, name, None)
            if path in chosen and name in defaults and value != defaults[name]:
                raise SettingError(path, "no value", f"{value!r}; it has no effect {why}")

    def _without_effect(self) -> Iterator[tuple[str, str]]:
        """Yield the paths of settings that have no effect here, and why."""
        learners = {self.learner_path(t): self.learner_settings(t) for t in self.learning_teams}
        if self.schedule.opponents_met < 2:
            for path in learners:
                yield f"{path}.sharing", "with one opponent an epoch"
        if self.game.symmetric:
            yield "schedule.evaders_meet", "in a game of one population"
        if not isinstance(self.game, PursuitSettings):
            yield "schedule.training_opponents", "in a game of your own"
            for path in learners:
                yield f"{path}.measure", "in a game of your own"
                yield f"{path}.cost_limit", "in a game of your own"
            return
        if self.exact:
            costs = (f"{path}.cost_limit" for path in learners)
            for name in ("train_steps", "schedule.training_opponents", *costs):
                yield name, f"with the measure {GUARANTEE}"
        policy = self.game.policy
        if isinstance(policy, Cells) and not policy.hidden:
            for name in ("activation", "memory", "initial_weight"):
                yield f"policy.{name}", "without hidden layers"
        if isinstance(self.schedule, Against) and self.schedule.start is not None:
            for name in ("initial_weight", "initial_head"):
                yield f"policy.{name}", "with a genome to start from"
        if all(isinstance(learner, ActorCritic) for learner in learners.values()):
            yield "policy.initial_weight", "with actor-critic, whose hidden weights are orthogonal"

    def _check_pursuit(self, game: PursuitSettings) -> None:
        if isinstance(self.schedule, SelfPlay):
            raise SettingError("schedule", "a race of two teams in pursuit", SelfPlay.kind)
        if isinstance(self.schedule, Against):
            game.check_script("schedule.opponent", self.schedule.opponent)
            for script in self.schedule.training_opponents:
                game.check_script("schedule.training_opponents", script)
        if self.exact:
            check_guarantee(game)
            self._check_one_episode(f"with the measure {GUARANTEE}")
        game.check_learning(pursuers_learn="pursuer" in self.learning_teams)
        learners = map(self.learner_settings, self.learning_teams)
        is_rewarded = any(getattr(learner, "rewarded", True) for learner in learners)
        if not game.usual_rewards and not is_rewarded:
            expected = "the default without the measure rewards or the learner actor-critic"
            raise SettingError("world.rewards", expected, str(game.world.rewards))

    def _check_own_game(self) -> None:
        name = self.game.variant
        self._check_population(name)
        if isinstance(self.schedule, Against) and self.schedule.opponent in SCRIPTS:
            expected = f"a run directory of the game {name}"
            raise SettingError(
                "schedule.opponent", expected, f"the script {self.schedule.opponent}"
            )
        if self.game.deterministic:
            self._check_one_episode(f"in a game that is deterministic ({name})")

    def _check_one_episode(self, where: str) -> None:
        """Raise SettingError for several episodes where all of them are equal."""
        for path in ("match_episodes", "evaluation_episodes"):
            if (episodes := getattr(self, path)) != 1:
                raise SettingError(path, f"no value {where}", str(episodes))

    def _check_measure(self, path: str, measure: str) -> None:
        """Raise SettingError unless who learns on a guarantee meets the best response alone."""
        guaranteed = measure == GUARANTEE
        if guaranteed == self.exact or not isinstance(self.game, PursuitSettings):
            return
        if not guaranteed:
            expected = f"another one without the measure {GUARANTEE}"
            raise SettingError("schedule.opponent", expected, BEST_RESPONSE)
        why = f"with {path}.measure {GUARANTEE}"
        if isinstance(self.schedule, Against):
            got = self.schedule.opponent
            raise SettingError("schedule.opponent", f"{BEST_RESPONSE} {why}", got)
        raise SettingError("schedule", f"{Against.kind} {why}", self.schedule.name)

    def _check_population(self, name: str) -> None:
        """Raise SettingError for a schedule that needs other populations, or constant sums."""
        schedule = self.schedule
        one_population = isinstance(schedule, AtOnce | SelfPlay)
        if self.game.symmetric and not one_population:
            expected = f"{AtOnce.kind} or {SelfPlay.kind} in a game of one population ({name})"
            raise SettingError("schedule", expected, schedule.kind)
        if isinstance(schedule, SelfPlay) and not self.game.symmetric:
            expected = f"a schedule of two teams in a game that has two ({name})"
            raise SettingError("schedule", expected, schedule.kind)
        if self.game.general and isinstance(schedule, OfGenerations):
            met = [schedule.meets(team) for team in self.learning_teams]
            if any(isinstance(each, NashOpponents) for each in met):
                expected = f"no Nash mixtures in a game with the scores of both teams ({name})"
                raise SettingError("schedule", expected, schedule.name)

    # What follows from the settings:

    @property
    def is_race(self) -> bool:
        """Whether both teams learn."""
        return self.schedule.is_race

    @property
    def exact(self) -> bool:
        """Whether a team alone meets the best response: what it guarantees is its score."""
        schedule = self.schedule
        meets_it = isinstance(schedule, Against) and schedule.opponent == BEST_RESPONSE
        return meets_it and isinstance(self.game, PursuitSettings)

    @property
    def known(self) -> Game:
        """What is known of the game that is raced without an import."""
        return self.evaluation_game if self.exact else self.game.known

    @property
    def learning_teams(self) -> tuple[Team, ...]:
        """Teams that learn; the one population of a symmetric game is the first one."""
        return TEAMS[:1] if self.game.symmetric else self.schedule.learning_teams

    @property
    def teams(self) -> tuple[str, str]:
        """What the teams are called."""
        return self.game.teams

    @property
    def keys(self) -> tuple[str, str]:
        """Names of the teams in logs and mappings."""
        return self.game.keys

    @property
    def method(self) -> RaceSettings:
        """The settings without what tells one seed from another."""
        return replace(self, seed=0)

    def with_absolute_paths(self) -> RaceSettings:
        """Return settings whose paths mean the same in another current directory."""
        if not isinstance(self.schedule, Against):
            return self
        paths = {"schedule.opponent": self.schedule.opponent, "schedule.start": self.schedule.start}
        absolute = {
            name: str(Path(path).absolute())
            for name, path in paths.items()
            if path is not None and path != GIVEN and (name != "schedule.opponent" or is_path(path))
        }
        return self.changed(absolute) if absolute else self

    def learner_path(self, team: Team) -> str:
        """Return the path of the setting that says how a team learns."""
        own = isinstance(self.schedule, InTurns) and self.schedule.evader_learner is not None
        return "schedule.evader_learner" if own and team == "evader" else "learner"

    def learner_settings(self, team: Team) -> Learner | OwnLearner:
        """Return the section that says how a team learns; a learner of your own is not imported."""
        section: Learner | OwnLearner = attrgetter(self.learner_path(team))(self)
        return section

    def learner_of(self, team: Team) -> Learner:
        """Return how a team learns.

        Raises ValueError if own code cannot be imported or refuses its settings, PluginError if it
        fails.
        """
        learner = self._learners[self.learner_path(team)]
        if learner.texts:
            return replace(learner, operators=self.evaluation_game.operators[team])
        return learner

    @cached_property
    def _learners(self) -> dict[str, Learner]:
        """Learners by the paths of their settings; those of your own are imported once."""
        learners = {}
        for team in self.learning_teams:
            path = self.learner_path(team)
            learner = self.learner_settings(team)
            if isinstance(learner, OwnLearner) and path not in learners:
                kinds = kinds_of(self.values())
                own: Learner = learner.load(partial(_usual_of_own_learner, kinds))
                own.check_race(path, self.game)
                self._check_measure(path, getattr(own, "measure", ""))
                learners[path] = own
            elif isinstance(learner, Learner):
                learners[path] = learner
        return learners

    def task(self, team: Team, begin: Genome | None = None) -> Task:
        """Return what the learner of a team starts from: untrained genomes, or `begin`."""
        game = self.evaluation_game
        return Task(
            seed=self.seed,
            team=TEAMS.index(team),
            epochs=self.schedule.total_epochs(team),
            untrained=partial(self.learner_of(team).untrained, game, team),
            begin=begin,
            game=game,
        )

    def in_epochs(self, evaluated: int) -> int:
        """Return how many epochs take about as long as so many matches of the evaluation."""
        learners = map(self.learner_of, self.learning_teams)
        matches = max(learner.population * learner.learning_time for learner in learners)
        matches *= self.schedule.opponents_met * self.match_episodes
        return round(evaluated / matches)

    @cached_property
    def evaluation_game(self) -> Game:
        """The game that is raced, as it is evaluated; imports a game of your own."""
        if self.exact:
            game: Any = self.game
            [team] = self.learning_teams
            return Guaranteed(world=game.world, settings=game.policy, team=team)
        return self.game.evaluation()

    @cached_property
    def training_game(self) -> Game:
        """The game in which teams learn; imports a game of your own."""
        if self.exact:
            return self.evaluation_game
        alone = isinstance(self.schedule, Against) and self.schedule.start is None
        return self.game.training(alone=alone)


# Choices:


def _by_path(named: Mapping[str, Any]) -> dict[str, Any]:
    """Return settings by their paths, of those by the last part of their path."""
    return {path: value for name, value in named.items() for path in paths_of(name)}


def _check_taken_back(paths: Iterable[str]) -> None:
    """Raise UnknownSettingError unless settings have these paths, whose choices None takes back."""
    for path in paths:
        of_own_code = ".settings." in path  # has settings of any name
        if path not in all_paths() and path != DEFAULTS and not of_own_code:
            raise _unknown(path)


def _built(values: Mapping[str, Any], chosen: Mapping[str, Any] | None) -> RaceSettings:
    """Return settings of values by path; SettingError with the path as users write it."""
    for path in values:
        if path.partition(".")[0] not in _first_names():
            raise _unknown(path)
    full = {_full(path): value for path, value in values.items() if path != DEFAULTS}
    try:
        with sections.below(""):
            settings: RaceSettings = sections.build(RaceSettings, full, RaceSettings, chosen=chosen)
    except SettingError as error:
        raise error.at(_short(error.path)) from error.__cause__
    return settings


def _facts_of_game(chosen: Mapping[str, Any]) -> dict[str, Any]:
    """Return what is known of a game of your own without an import; it is imported once."""
    code = chosen["game"]
    for path, value in chosen.items():
        if path.partition(".")[0] in OF_PURSUIT:
            raise SettingError(path, f"no value in a game of your own ({code})", shown(value))
    parts = {
        path.removeprefix("game").removeprefix("."): value
        for path, value in chosen.items()
        if path == "game" or path.startswith("game.")
    }
    with sections.below("game"):
        game: OwnGame = sections.build(GameSettings, parts)
    return {f"game.{name}": value for name, value in game.values().items() if name != "code"}


def kinds_of(chosen: Mapping[str, Any]) -> Kinds:
    """Return of what was chosen, by path, what other defaults follow from.

    A bad choice is refused elsewhere.
    """
    defaults = chosen.get(DEFAULTS) or PAPER
    texts = bool(chosen.get("game.texts"))
    symmetric = bool(chosen.get("game.one_population"))
    team: Team = "evader" if chosen.get("schedule.team") == "evader" else "pursuer"
    exact = {"learner.measure": GUARANTEE, "schedule.opponent": BEST_RESPONSE}
    guarantee = any(chosen.get(path) == value for path, value in exact.items())
    usual_epochs = GUARANTEED["schedule.epochs"] if guarantee else EPOCHS[team]
    epochs: Any = chosen.get("schedule.epochs")
    policy = _class_of(PolicySettings, chosen.get("policy"), POLICY[defaults])
    learner = usual_learner(defaults, policy, texts=texts)
    return Kinds(
        defaults,
        schedule=_class_of(Schedule, chosen.get("schedule"), HALL if symmetric else SCHEDULE),
        learner=_class_of(Learner, chosen.get("learner", learner), OWN),
        policy=policy,
        team=team,
        epochs=epochs if isinstance(epochs, int) and 0 < epochs <= INT_MAX else usual_epochs,
        has_map=isinstance(chosen.get("world.obstacles"), str | list),
        own_game=chosen.get("game") is not None,
        exact=bool(chosen.get("game.exact")),
        texts=texts,
        symmetric=symmetric,
        guarantee=guarantee,
    )


def _class_of(base: Any, name: Any, otherwise: str) -> Any:
    """Return the class that a name stands for; of none, or a bad one, that of another name."""
    names = NAMES[base]
    return names[name if isinstance(name, str) and name in names else otherwise].make


def _usual_of_own_learner(kinds: Kinds, learner: Any) -> dict[str, Any]:
    """Return the defaults of what a learner of your own, a class, may inherit.

    They are those of the paper: settings with equal values must have equal learners.
    """
    return usual_of_learner(kinds._replace(learner=learner))


def default_race(schedule: str) -> dict[str, Any]:
    """Return what the command ``matrixworld evolve`` starts from, for `RaceSettings.of`.

    Policies that one can read race in a balanced world, and a race takes seconds.
    ``RaceSettings()`` and ``evolve --paper`` have the paper's world and networks.

    Parameters
    ----------
    schedule : str
        A schedule, such as ``"hall-of-fame"`` or ``"against"``.

    Returns
    -------
    dict
        Values by the paths of settings.

    Examples
    --------
    >>> from matrixworld.coevolution import RaceSettings, default_race
    >>> RaceSettings.of(default_race("hall-of-fame"), seed=1).game.policy.kind
    'rating'
    """
    checks.check_choice("schedule", schedule, sections.names_in(Schedule))
    return {"schedule": schedule, DEFAULTS: COURTYARD}


def _unknown(path: str) -> UnknownSettingError:
    return UnknownSettingError(path, f"one of the settings {', '.join(_first_names())}")


@cache
def _first_names() -> tuple[str, ...]:
    """Return the names with which paths of settings begin."""
    return tuple(dict.fromkeys(path.partition(".")[0] for path in (*all_paths(), DEFAULTS)))


@cache
def all_paths() -> tuple[str, ...]:
    """Return the paths of all settings, of every kind of section."""
    return tuple(dict.fromkeys(map(_short, sections.paths_in(RaceSettings))))


def paths_of(name: str) -> tuple[str, ...]:
    """Return the paths of the settings that a name or path sets; TypeError unless it is clear."""
    if name in SHORT or "." in name:
        return SHORT.get(name, (name,))
    if name in all_paths() or name == DEFAULTS:
        return (name,)
    # Those of `learner` are those of both teams.
    paths = [path for path in all_paths() if not path.startswith("schedule.evader_learner.")]
    same = [path for path in paths if path.rpartition(".")[2] == name]
    if len(same) == 1:
        return (same[0],)
    known = [*SHORT, *(path.rpartition(".")[2] for path in paths)]
    expected = " or ".join(same or get_close_matches(name, known, 1)) or ", ".join(known)
    got = f"got an unexpected keyword argument {name!r}"
    raise TypeError(f"{got}; expected a setting, such as {expected}")
