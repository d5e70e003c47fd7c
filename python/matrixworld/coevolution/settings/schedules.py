"""Schedules: which opponents a team meets while it learns, and for how many epochs.

`k` is the generation that learns (from 1), `i` the epoch inside it (from 0). The archives begin
with the untrained `p[0]` and `e[0]`. The paper's three schedules (Sun et al. 2023, "MatrixWorld",
arXiv:2307.14854) are races in turns:

==========================  =========================  =========================
schedule                    opponents of the pursuers  opponents of the evaders
==========================  =========================  =========================
specialist-specialist       ``e[k - 1]``               ``p[k]``
generalist-specialist       ``e[i mod k]``             ``p[k]``
generalist-generalist       ``e[i mod k]``             ``p[i mod (k + 1)]``
==========================  =========================  =========================

The opponents of specialists are the `Latest`, those of generalists all by `RoundRobin`. A fourth
one, `psro`, draws them from Nash mixtures (`NashOpponents`). Each class here is data alone: the
loops that train by it are in `training.loops`.
"""

from __future__ import annotations

import re
from abc import abstractmethod
from pathlib import Path
from typing import ClassVar

from matrixworld._util.constraints import Items, OneOf, Whole
from matrixworld._util.sections import (
    Section,
    SettingError,
    name_section,
    names_in,
    section,
    setting,
)
from matrixworld.coevolution import opponents as samplers
from matrixworld.coevolution.games.pursuit import BEST_RESPONSE, SCRIPTS
from matrixworld.coevolution.learners import OwnLearner
from matrixworld.coevolution.learners.learner import Learner
from matrixworld.coevolution.types import TEAMS, Team


@section()
class Schedule(Section):
    """Base of the schedules."""

    stages_per_generation: ClassVar[int] = 1
    """Stages of a generation; a run is saved after each of them."""
    at_once: ClassVar[bool] = False
    """Whether both teams learn from the same matches."""
    is_race: ClassVar[bool] = True
    """Whether both teams learn."""

    @property
    def name(self) -> str:
        """What the race is called, such as in directories."""
        return self.kind

    @property
    def learning_teams(self) -> tuple[Team, ...]:
        """Teams that learn."""
        return TEAMS

    @property
    def opponents_met(self) -> int:
        """Most opponents of a candidate in an epoch."""
        return 1

    @property
    @abstractmethod
    def entries(self) -> int:
        """Genomes in the archive of a learning team at the end of a run."""

    def total_epochs(self, team: Team) -> int:
        """Return the epochs of the whole run in which `team`, one that learns, does so."""
        return self.epochs_until(self.n_stages)

    @abstractmethod
    def epochs_in(self, stage: int) -> int:
        """Return the epochs of a stage."""

    def epochs_until(self, stage: int) -> int:
        """Return the epochs of all stages before one."""
        return sum(map(self.epochs_in, range(stage)))

    def sampler(self, team: Team) -> samplers.Opponents:
        """Return how a team chooses opponents; imports code of your own."""
        return samplers.RoundRobin()

    @property
    def n_stages(self) -> int:
        """The number of stages of the run, which add all entries but the untrained one."""
        return self.stages_per_generation * (self.entries - 1)

    @property
    def curve_window(self) -> int:
        """Epochs of the moving average of a training curve, the same for both teams."""
        return max(1, min(map(self.epochs_in, range(self.stages_per_generation))) // 4)


@section()
class OfGenerations(Schedule):
    """Base of the races."""

    generations: int = setting(30, "generations after the untrained generation 0", Whole(1))

    @property
    def entries(self) -> int:
        """Genomes in the archive of a team at the end of a race."""
        return 1 + self.generations

    @abstractmethod
    def meets(self, team: Team) -> samplers.Opponents | samplers.OwnOpponents:
        """Return the setting that says whom a team meets."""

    def sampler(self, team: Team) -> samplers.Opponents:
        """Return how a team chooses opponents; imports code of your own."""
        return samplers.loaded(self.meets(team))


@section()
class OfTwoTeams(OfGenerations):
    """Base of the races in which both teams learn."""

    pursuers_meet: samplers.Opponents | samplers.OwnOpponents = setting(
        samplers.Uniform(),
        f"whom pursuers meet: {', '.join(names_in(samplers.Opponents))} or module:object",
    )
    evaders_meet: samplers.Opponents | samplers.OwnOpponents = setting(
        samplers.Uniform(), "whom evaders meet; as for the pursuers"
    )

    def meets(self, team: Team) -> samplers.Opponents | samplers.OwnOpponents:
        """Return the setting that says whom a team meets."""
        return self.pursuers_meet if team == "pursuer" else self.evaders_meet


# In turns:

PSRO = "psro"  # name of a schedule in which both teams meet Nash mixtures


@section("alternating")
class InTurns(OfTwoTeams):
    """The teams learn in turns, against archived opponents that their samplers choose.

    ::

        p[0], e[0] untrained
        for k in 1 .. generations:
            p[k] = p[k-1], improved for some epochs against evaders among e[0 .. k-1]
            e[k] = e[k-1], improved for some epochs against pursuers among p[0 .. k]
        payoff[g, h] = capture rate of p[g] against e[h]

    A stage is a team phase: one team's epochs of one generation. Learners keep their state from
    generation to generation.
    """

    stages_per_generation: ClassVar[int] = 2

    opponents: int = setting(1, "opponents of each candidate in an epoch", Whole(1))
    pursuer_epochs: int = setting(28, "epochs per generation in which pursuers learn", Whole(1))
    evader_epochs: int = setting(58, "epochs per generation in which evaders learn", Whole(1))
    evader_learner: Learner | OwnLearner | None = setting(
        None, "how the evaders learn, where it differs; learner is then that of the pursuers"
    )

    @property
    def name(self) -> str:
        """The name in the paper of a schedule that has one, "psro", or "alternating"."""
        met = type(self.pursuers_meet), type(self.evaders_meet)
        for name, (pursuers, evaders) in MEET.items():
            if met == (type(pursuers), type(evaders)) and (self.opponents == 1 or name == PSRO):
                return name
        return self.kind

    @property
    def opponents_met(self) -> int:
        """Most opponents of a candidate in an epoch."""
        return self.opponents

    def epochs(self, team: Team) -> int:
        """Return the epochs of a generation in which `team` learns."""
        return self.pursuer_epochs if team == "pursuer" else self.evader_epochs

    def total_epochs(self, team: Team) -> int:
        """Return the epochs of the whole run in which `team` learns."""
        return self.generations * self.epochs(team)

    def epochs_in(self, stage: int) -> int:
        """Return the epochs of a stage, of the pursuers if it is even."""
        return self.epochs(TEAMS[stage % 2])


# At the same time:


@section("hall-of-fame")
class AtOnce(OfTwoTeams):
    """Both teams learn at the same time, from living opponents and a hall of fame.

    ::

        in each epoch:
            both populations breed
            each individual plays against some living opponents, and against members of the
            opponents' hall of fame that its team's sampler chooses
            its fitness is the mean over its matches, or the result of fitness sharing
        at the end of a generation the champion of each team enters its hall of fame

    The halls of fame are the archive, so that payoff and analysis are those of races in turns. A
    stage is a generation. Any learner can take part: the individuals of an evolution strategy are
    its samples, and its mean is the champion.

    In a symmetric game there is one population, whose individuals meet each other, never
    themselves, and its hall of fame.

    Rosin & Belew 1997, "New methods for competitive coevolution", Evolutionary Computation 5(1).
    """

    at_once: ClassVar[bool] = True

    joint_epochs: int = setting(43, "epochs per generation, in which both teams learn", Whole(1))
    contemporaries: int = setting(2, "living opponents of each individual")
    hall_sample: int = setting(1, "opponents of each individual from the hall of fame")

    def check(self) -> None:
        """Raise SettingError without opponents, or if a sampler is named that draws none."""
        if not self.opponents_met:
            raise SettingError("hall_sample", "at least 1 opponent, with the contemporaries", "0")
        for name in ("pursuers_meet", "evaders_meet"):
            if not self.hall_sample and getattr(self, name) != samplers.Uniform():
                raise SettingError(name, "no value with a hall_sample of 0")

    @property
    def opponents_met(self) -> int:
        """Most opponents of a candidate in an epoch."""
        return self.contemporaries + self.hall_sample

    def epochs_in(self, stage: int) -> int:
        """Return the epochs of a stage, in which both teams learn."""
        return self.joint_epochs


# One population:


@section("self-play")
class SelfPlay(OfGenerations):
    """The population of a symmetric game learns against its own past.

    ::

        p[0] untrained
        for k in 1 .. generations:
            p[k] = p[k-1], improved for some epochs against opponents among p[0 .. k-1]
        payoff[g, h] = score of p[g] against p[h]

    A stage is a generation. Heinrich, Lanctot and Silver 2015, "Fictitious self-play in
    extensive-form games", ICML, for opponents drawn evenly from all of the past.
    """

    meet: samplers.Opponents | samplers.OwnOpponents = setting(
        samplers.Uniform(), "whom candidates meet of their past; as for the pursuers"
    )
    opponents: int = setting(3, "opponents of each candidate in an epoch", Whole(1))
    self_play_epochs: int = setting(43, "epochs per generation", Whole(1))

    @property
    def opponents_met(self) -> int:
        """Most opponents of a candidate in an epoch."""
        return self.opponents

    def epochs_in(self, stage: int) -> int:
        """Return the epochs of a stage."""
        return self.self_play_epochs

    def meets(self, team: Team) -> samplers.Opponents | samplers.OwnOpponents:
        """Return the setting that says whom candidates meet."""
        return self.meet


# Against fixed opponents:


GIVEN = "given as genomes"
"""Value of `Against.opponent` and `Against.start` if `create` was given genomes in their place."""


@section("against")
class Against(Schedule):
    """One team learns alone, against fixed opponents, one of them in each epoch.

    ::

        for k in 1 .. epochs / archive_every:
            g[k] = g[k-1], improved for `archive_every` epochs against each opponent in turn, or
                   each of the training opponents
        payoff = capture rate of the last genome against, or of, each opponent

    With the learner's measure ``guarantee`` the opponent is the best response to each candidate, in
    a world that can be solved, and the payoff has the guarantee of each g[k].

    The archive holds the opponents' genomes, too, if they have any, and config.json the program of
    a file of Python, so that a run does not depend on other files.
    """

    is_race: ClassVar[bool] = False

    team: Team = setting("pursuer", "team that learns: pursuer or evader", OneOf(TEAMS))
    opponent: str = setting(
        "random",
        f"{', '.join(SCRIPTS)}, a run directory (its last generation), or another player: a file "
        f"(.py, .npz, .txt), solved, or a line such as -adversary; {BEST_RESPONSE} with the "
        "measure guarantee",
    )
    training_opponents: tuple[str, ...] = setting(
        (),
        "scripts against which the team learns, in each epoch the next one, while it is evaluated "
        "against the opponent; none: it learns against the opponent",
        Items(OneOf(SCRIPTS), "a sequence of names of scripts"),
    )
    start: str | None = setting(
        None, "run directory; start from its last generation instead of an untrained genome"
    )
    epochs: int = setting(6000, "epochs of the run", Whole(1))
    archive_every: int = setting(
        100, "epochs between entries of the archive; each is a checkpoint", Whole(1)
    )

    @property
    def met(self) -> tuple[str, ...]:
        """Against whom the team learns: the training opponents in turn, or the opponent."""
        return self.training_opponents or (self.opponent,)

    @property
    def name(self) -> str:
        """What the run is called, such as ``evader-against-random``."""
        path = Path(self.opponent)
        # Runs of a job are called after their seeds, which says nothing: their folder does.
        name = path.parent.name if re.fullmatch(r"seed-\d+", path.name) else path.name
        name = re.sub(r"[^\w.=+-]", "-", name)
        return f"{self.team}-against-{name}"

    @property
    def learning_teams(self) -> tuple[Team, ...]:
        """The one team that learns."""
        return (self.team,)

    @property
    def entries(self) -> int:
        """Genomes in the archive at the end of the run."""
        return 1 + -(-self.epochs // self.archive_every)

    def epochs_in(self, stage: int) -> int:
        """Return the epochs until the next entry of the archive."""
        return min(self.archive_every, self.epochs - stage * self.archive_every)

    @property
    def curve_window(self) -> int:
        """Epochs of the moving average of a training curve."""
        return max(1, self.total_epochs("pursuer") // 100)


# Names:

MEET: dict[str, tuple[samplers.Opponents, samplers.Opponents]] = {
    "specialist-specialist": (samplers.Latest(), samplers.Latest()),
    "generalist-specialist": (samplers.RoundRobin(), samplers.Latest()),
    "generalist-generalist": (samplers.RoundRobin(), samplers.RoundRobin()),
    PSRO: (samplers.NashOpponents(), samplers.NashOpponents()),
}
"""Whom pursuers and evaders meet in races in turns that have a name."""
for _name, (_pursuers, _evaders) in MEET.items():
    name_section(_name, InTurns, pursuers_meet=_pursuers, evaders_meet=_evaders)

SCHEDULES: dict[str, InTurns] = {
    name: InTurns(pursuers_meet=pursuers, evaders_meet=evaders)
    for name, (pursuers, evaders) in MEET.items()
    if name != PSRO
}
"""The paper's schedules by name."""
ALL_SCHEDULES = (
    "specialist-specialist",
    "generalist-specialist",
    AtOnce.kind,
    "generalist-generalist",
    PSRO,
    InTurns.kind,
)
"""Names of the schedules of races, in the order in which a job plays them: from the newest
opponents only to those of all generations."""
