"""Settings: everything that defines a run. Runs with equal settings are equal bit for bit.

The number of threads is not a setting, because results do not depend on it.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import fields, replace
from difflib import get_close_matches
from functools import cached_property, partial
from typing import Any

import numpy as np

from matrixworld._util import checks
from matrixworld.coevolution import pursuit, sections
from matrixworld.coevolution.fitness import FitnessSettings
from matrixworld.coevolution.game import Game, OwnGame
from matrixworld.coevolution.learners import BuiltInLearner, OwnLearner
from matrixworld.coevolution.learners.evolution_strategy import EvolutionStrategy
from matrixworld.coevolution.learners.learner import Learner, Task
from matrixworld.coevolution.race import SCHEDULES, Against, AtOnce, InTurns
from matrixworld.coevolution.sections import Section, by_race, setting
from matrixworld.coevolution.types import TEAMS, Genome, Rng, Team

MOST_SEED = 2**63 - 1  # largest seed: the largest integer of 64 bits with a sign
OF_PURSUIT = ("world", "policy", "train_steps", "training_worlds")
"""Settings that a game of your own has not."""


@sections.section
class RaceSettings(Section):
    """Settings of a run: a race, in which both teams learn, or one team `Against` fixed opponents.

    A text stands for the section of that kind with its defaults, as in ``learner="ga"`` or
    ``schedule="hall-of-fame"``. A field that is None takes the default that goes with the learner
    and the schedule. ValueError or TypeError on a bad field.
    """

    game: OwnGame | None = setting(
        None, "a game of your own, as module:object; default: pursuit and evasion in the world"
    )
    world: pursuit.WorldConfig = by_race(
        pursuit.WorldConfig(), "the world; its max_steps are those of evaluation"
    )
    policy: pursuit.AnyPolicy = by_race(
        pursuit.Cells(), f"what decides: {', '.join(sections.kinds_in(pursuit.AnyPolicy))}"
    )
    learner: BuiltInLearner | OwnLearner = setting(
        EvolutionStrategy(),
        f"how teams learn: {', '.join(sections.kinds_in(BuiltInLearner))} or module:object",
    )
    evader_learner: BuiltInLearner | OwnLearner | None = setting(
        None, "how the evaders learn, where it differs; learner is then that of the pursuers"
    )
    schedule: InTurns | AtOnce | Against = setting(
        SCHEDULES["generalist-generalist"], "whom teams meet while they learn, and for how long"
    )
    fitness: FitnessSettings = setting(FitnessSettings(), "what candidates are selected by")
    train_steps: int = by_race(200, "maximum steps of a training episode", least=1)
    training_worlds: tuple[pursuit.WorldConfig, ...] = setting(
        (),
        "worlds in which teams learn, each by what it has other than the world; an epoch plays one "
        "of them, drawn at random; none: they learn in the world",
    )
    training_shares: tuple[int, ...] = setting(
        (), "of how many epochs each training world is one, in the mean; none: of equally many"
    )
    match_episodes: int = setting(1, "episodes of each training match", least=1)
    retest_episodes: int = setting(
        0,
        "new matches, at the end of a generation, of the learner's genome and of the two fittest "
        "candidates against each of their last opponents; the best one enters the archive; 0: the "
        "learner's genome does",
    )
    evaluation_episodes: int = by_race(10, "evaluation episodes of each pair", least=1)
    seed: int = setting(0, "seed of the run", most=MOST_SEED)

    def check(self) -> None:
        """Fill in defaults, and raise ValueError unless all sections fit together."""
        if self.game is not None:
            self._check_own_game()
        # First the schedule: the steps of a learner may follow from its epochs.
        for item in sorted(fields(self), key=lambda item: item.name != "schedule"):
            value = getattr(self, item.name)
            if value is None and not (self.game and item.name in OF_PURSUIT):
                value = self._defaults().get(item.name, item.metadata["default"])
            if isinstance(value, Section):
                value = self._filled(item.name, value)
            object.__setattr__(self, item.name, value)
        if self.game is None:
            if isinstance(self.schedule, Against):
                pursuit.check_script("schedule.opponent", self.schedule.opponent, self.world)
            pursuit.check_mask(self.policy.mask, self.world, "pursuer" in self.learning_teams)
            self._read_training_worlds()
        self._check_idle()
        if self.evader_learner:
            expected = f"no value with the schedule {self.schedule.kind}, which is not in turns"
            in_turns, got = isinstance(self.schedule, InTurns), self.evader_learner.kind
            checks.expect(in_turns, "evader_learner", expected, got)
        for team in self.learning_teams:
            learner = getattr(self, self.learner_path(team))
            if not isinstance(learner, sections.OwnCode):  # which is not imported yet
                self._check_fits(self.learner_path(team), learner)

    def _read_training_worlds(self) -> None:
        """Make worlds of what they have other than `world`; ValueError if genomes fit no world."""
        usual = {**self.world.to_json(), "max_steps": self.train_steps}
        with sections.inside("training_worlds"):
            worlds = tuple(pursuit.world_of(each, usual) for each in self.training_worlds)
            for world in worlds:
                for name in ("rules", "fov", "diagonal"):
                    expected, got = getattr(self.world, name), getattr(world, name)
                    checks.expect(got == expected, name, f"{expected}, as in world", got)
        object.__setattr__(self, "training_worlds", worlds)
        shares, expected = len(self.training_shares), f"{len(worlds)} or none"
        checks.expect(shares in (0, len(worlds)), "training_shares", expected, shares)

    def _check_fits(self, path: str, learner: Learner) -> None:
        """Raise ValueError if a learner cannot learn here, or would change what a mask fixes."""
        name = learner.kind or type(learner).__name__
        if self.game:
            expected = "es, ga, cma or your own in a game of your own"
            checks.expect(learner.any_game, path, expected, name)
        else:
            kind, mask = self.policy.kind, self.policy.mask
            expected = f"{' or '.join(learner.policies)} with the learner {name}"
            checks.expect(kind in learner.policies, "policy", expected, kind)
            idle = kind == "cells" and mask != "none" and "policy.mask" in learner.ignores
            checks.expect(not idle, "policy.mask", f"'none' with {name}", repr(mask))
        # A run is read without an import of its game.
        learner.check_fits(path, self.game.known if self.game else self.evaluation_game)

    def _defaults(self, learner: Section | None = None) -> dict[str, Any]:
        """Return the defaults that the kind of race and a learner state, by default `learner`."""
        once = {"evaluation_episodes": 1} if self.game and self.game.deterministic else {}
        return {
            **self.schedule.defaults, **getattr(learner or self.learner, "defaults", {}), **once
        }  # fmt: skip

    def _filled(self, name: str, section: sections.AnySection) -> sections.AnySection:
        """Return a section with its defaults; ValueError if these do not fit the rest of it."""
        is_learner = isinstance(section, Learner)
        usual = self._defaults(section if is_learner else None)
        with sections.inside(name):
            return sections.filled(section, usual, "learner" if is_learner else name)

    def _check_own_game(self) -> None:
        """Raise ValueError for settings that a game of your own has not."""
        assert self.game is not None
        given = [name for name in OF_PURSUIT if getattr(self, name) not in (None, ())]
        if self.fitness.measure != FitnessSettings().measure:
            given.append("fitness.measure")
        if self.fitness.cost_limit is not None:
            given.append("fitness.cost_limit")
        if isinstance(self.schedule, Against) and self.schedule.opponent in pursuit.SCRIPTS:
            expected = f"a run directory of the game {self.game.code}"
            got = f"the script {self.schedule.opponent}"
            raise ValueError(f"schedule.opponent: expected {expected}, got {got}")
        once = ("match_episodes", "evaluation_episodes") if self.game.deterministic else ()
        given += [name for name in once if getattr(self, name) not in (None, 1)]
        if given:
            why = "that is deterministic" if given[0] in once else "of your own"
            raise ValueError(f"{given[0]}: expected no value in a game {why} ({self.game.code})")

    def _check_idle(self) -> None:
        """Raise ValueError for a value without effect where another section is the reason."""
        learners = [getattr(self, self.learner_path(team)) for team in self.learning_teams]
        ignored = set.intersection(*({*getattr(each, "ignores", ())} for each in learners))
        kinds = " and ".join(dict.fromkeys(each.kind for each in learners))
        idle = dict.fromkeys(sorted(ignored), f"with {kinds}")
        if self.schedule.opponents_met < 2:
            idle["fitness.sharing"] = "with one opponent an epoch"
        if isinstance(self.policy, pursuit.Cells) and not self.policy.hidden:
            shallow = ("policy.activation", "policy.memory", "policy.initial_weight")
            idle |= dict.fromkeys(shallow, "without hidden layers")
        if isinstance(self.schedule, Against) and self.schedule.start is not None:
            scales = ("policy.initial_weight", "policy.initial_head")
            idle |= dict.fromkeys(scales, "with a genome to start from")
        for path, why in idle.items():
            section, _, name = path.partition(".")
            part = getattr(self, section)
            if part is None or (path in ignored and section == "policy" and part.kind != "cells"):
                continue
            for item in fields(part):
                here, value = f"{section}.{item.name}", getattr(part, item.name)
                usual = self._defaults().get(here, item.metadata["default"])
                # Settings that were made from others may have the default of these.
                chosen = value not in (usual, item.metadata["default"], DEFAULT_RACE.get(here))
                expected = "no value" if usual is None else f"{usual!r}, the default"
                got = f"{value!r}; it has no effect {why}"
                checks.expect(not chosen or name not in ("", item.name), here, expected, got)
        rewarded = "fitness" in ignored or self.fitness.measure == "rewards"
        if self.game is None and not rewarded:
            expected = "the default without the fitness rewards or the learner actor-critic"
            usual = self.world.rewards == pursuit.Rewards()
            checks.expect(usual, "world.rewards", expected, self.world.rewards)

    # What follows from the settings:

    @property
    def is_race(self) -> bool:
        """Whether both teams learn."""
        return self.learning_teams == TEAMS

    @property
    def method(self) -> RaceSettings:
        """The settings without what tells one seed from another."""
        return replace(self, seed=0)

    @property
    def variant(self) -> str:
        """Name of the variant whose rules these are, or "own-rules", or the name of the game."""
        if self.game is not None:
            return self.game.code.partition(":")[2]
        return pursuit.variant_name(self.world.rules) or "own-rules"

    @property
    def learning_teams(self) -> tuple[Team, ...]:
        """Teams that learn."""
        return self.schedule.learning_teams

    def learner_path(self, team: Team) -> str:
        """Return the name of the setting that says how a team learns."""
        own = team == "evader" and self.evader_learner is not None
        return "evader_learner" if own else "learner"

    def learner_of(self, team: Team) -> Learner:
        """Return how a team learns.

        Raises ValueError if own code cannot be imported or refuses its settings, PluginError if it
        fails.
        """
        return self._learners[self.learner_path(team)]

    @cached_property
    def _learners(self) -> dict[str, Learner]:
        learners = {}
        for path in ("learner", "evader_learner"):
            learner = getattr(self, path)
            if isinstance(learner, sections.OwnCode):
                learner = self._filled(path, learner.load())
                self._check_fits(path, learner)
            learners[path] = learner
        return learners

    def in_epochs(self, evaluated: int) -> int:
        """Return how many epochs take about as long as so many matches of the evaluation."""
        learners = map(self.learner_of, self.learning_teams)
        matches = max(each.population * each.learning_time for each in learners)
        matches *= self.schedule.opponents_met * self.match_episodes
        return round(evaluated / matches)

    @cached_property
    def evaluation_game(self) -> Game:
        """The game that is raced, as it is evaluated; imports a game of your own."""
        if self.game is not None:
            return self.game.load()
        return pursuit.Pursuit(world=self.world, settings=self.policy)

    @cached_property
    def training_game(self) -> Game:
        """The game in which teams learn: of pursuit with episodes of `train_steps`."""
        if self.game is not None:
            return self.evaluation_game
        alone = isinstance(self.schedule, Against) and self.schedule.start is None
        penalty = pursuit.overlap_penalty(self.world, self.fitness.measure, alone)
        world = replace(self.world, max_steps=self.train_steps)
        return pursuit.Pursuit(world=world, settings=self.policy, penalty=penalty)

    def drawn_world(self, rng: Rng) -> pursuit.WorldConfig:
        """Return the world of an epoch, one of `training_worlds`."""
        shares = self.training_shares or (1,) * len(self.training_worlds)
        return self.training_worlds[rng.choice(len(shares), p=np.divide(shares, sum(shares)))]

    @property
    def teams(self) -> tuple[str, str]:
        """What the teams are called."""
        return pursuit.Pursuit.teams if self.game is None else self.game.teams

    @property
    def keys(self) -> tuple[str, str]:
        """Names of the teams in logs and mappings."""
        return TEAMS if self.game is None else self.teams

    @property
    def kind_of_game(self) -> type[Game]:
        """What logs and payoffs of the game hold, without an import."""
        return pursuit.Pursuit if self.game is None else Game

    def task(self, team: Team, begin: Genome | None = None) -> Task:
        """Return what the learner of a team starts from: untrained genomes, or `begin`."""
        game = self.evaluation_game
        untrained = partial(self.learner_of(team).untrained, game, team)
        return Task(
            seed=self.seed, team=TEAMS.index(team), epochs=self.schedule.total_epochs(team),
            untrained=untrained, begin=begin, game=game,
        )  # fmt: skip

    def beginning(self, begin: Genome | None = None) -> tuple[dict[Team, Any], dict[str, Any]]:
        """Return generation 0 of all that learn, and the states of learners and samplers."""
        archive: dict[Team, Any] = {}
        states: dict[str, Any] = {}
        for team in self.learning_teams:
            learner = self.learner_of(team)
            states[team] = learner.start(self.task(team, begin))
            states[f"{team}.opponents"] = self.schedule.sampler(team).start()
            archive[team] = [learner.genome(states[team])]
        return archive, states

    def changed(self, changes: Mapping[str, Any]) -> RaceSettings:
        """Return the settings with some changes.

        Parameters
        ----------
        changes : mapping of str to any
            Values by their paths; a section of another kind starts from its defaults.

        Raises
        ------
        TypeError, ValueError
            If a path is unknown or has a bad value; the message begins with it.

        Examples
        --------
        >>> from matrixworld.coevolution import RaceSettings
        >>> settings = RaceSettings().changed({"learner": "ga", "schedule.generations": 5})
        >>> settings.learner.kind, settings.schedule.generations
        ('ga', 5)
        """
        values = {item.name: getattr(self, item.name) for item in fields(self)}
        return RaceSettings(**sections.merged(RaceSettings, values, sections.by_path(changes)))

    @classmethod
    def of(cls, *values: Mapping[str, Any], **named: Any) -> RaceSettings:
        """Return settings from values by their paths, such as ``{"learner.sigma": 0.2}``.

        All other settings have their defaults; sections may be nested mappings, as `to_json`
        returns them, or texts that name their kinds, rules and rewards names. Later mappings change
        earlier ones. `named` are settings by the last part of their path, such as ``sigma=0.2``, or
        by the names in `SHORT`. Code of your own is named only, and not imported. TypeError or
        ValueError as in `changed`; the message begins with the path.
        """
        given: dict[str, Any] = {}
        last = {path: value for name, value in named.items() for path in paths_of(name)}
        for each in (*values, last):
            given = sections.merged(cls, given, sections.by_path(each))
        return cls(**given)


DEFAULT_RACE: Mapping[str, Any] = {
    "world": "courtyard", "policy": "rating", "policy.initial_weight": 0.2,
    "learner.population": 12, "learner.sigma": 0.3, "learner.learning_rate": 0.0025,
    "schedule.pursuer_epochs": 20, "schedule.evader_epochs": 20, "schedule.joint_epochs": 10,
}  # fmt: skip
SHORT = {"variant": ("world.rules",), "size": ("world.rows", "world.cols")}
"""Names of settings that are not the last part of their path."""


def default_race(schedule: str) -> dict[str, Any]:
    """Return what the command ``matrixworld evolve`` starts from, for `RaceSettings.of`.

    Policies that one can read race in a world in which good teams win about half, and a race takes
    seconds. ``RaceSettings()`` and ``evolve --paper`` have the paper's world and networks.

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
    >>> RaceSettings.of(default_race("hall-of-fame"), seed=1).policy.kind
    'rating'
    """
    known = sections.sections_in(sections.hints_of(RaceSettings)["schedule"])
    checks.check_choice("schedule", schedule, known)
    paths = {f"schedule.{item.name}" for item in fields(known[schedule])}
    usual = {p: v for p, v in DEFAULT_RACE.items() if p in paths or not p.startswith("schedule.")}
    return {"schedule": schedule, **usual}


def paths_of(name: str) -> tuple[str, ...]:
    """Return the paths of the settings that a name or path sets; TypeError unless it is clear."""
    if name in SHORT or "." in name:
        return SHORT.get(name, (name,))
    every = dict.fromkeys(sections.paths_in(RaceSettings))
    # Those of `learner` are those of both teams.
    short = [path for path in every if not path.startswith("evader_learner.")]
    found = [name] if name in every else [p for p in short if p.rpartition(".")[2] == name]
    if len(found) != 1:
        known = [*SHORT, *(path.rpartition(".")[2] for path in short)]
        expected = " or ".join(found or get_close_matches(name, known, 1)) or ", ".join(known)
        got = f"got an unexpected keyword argument {name!r}"
        raise TypeError(f"{got}; expected a setting, such as {expected}")
    return (found[0],)
