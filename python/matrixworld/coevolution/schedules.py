"""Schedules: which opponents a team meets while it learns, and for how many epochs.

`k` is the generation that learns (from 1), `i` the epoch inside it (from 0). The archives begin
with the untrained `p[0]` and `e[0]`. In each generation of an alternating race the pursuers learn
first, then the evaders: the opponents of the pursuers of generation `k` are among `e[0..k-1]`,
those of the evaders among `p[0..k]`. The paper's three schedules (Sun et al. 2023, "MatrixWorld",
arXiv:2307.14854):

==========================  =========================  =========================
schedule                    opponents of the pursuers  opponents of the evaders
==========================  =========================  =========================
specialist-specialist       ``e[k - 1]``               ``p[k]``
generalist-specialist       ``e[i mod k]``             ``p[k]``
generalist-generalist       ``e[i mod k]``             ``p[i mod (k + 1)]``
==========================  =========================  =========================

The opponents of specialists are the `Latest`, those of generalists all by `RoundRobin`. A fourth
one, `psro`, draws them by meta-strategies (`opponents.MetaStrategy`). With `Maps` the maps on which
both teams learn evolve, too.
"""

from __future__ import annotations

import re
from abc import abstractmethod
from collections.abc import Callable, Mapping
from dataclasses import dataclass, fields
from pathlib import Path
from typing import Any, ClassVar, TypeAlias

import numpy as np

from matrixworld._util.checks import check_choice, check_integer
from matrixworld.analysis.games import META_SOLVERS
from matrixworld.coevolution import opponents
from matrixworld.coevolution.maps import BOTH, MAP_FITNESS, MAP_TEAMS, NONE, MapTeam
from matrixworld.coevolution.opponents import OpponentSampler
from matrixworld.coevolution.own_code import OPPONENT, made
from matrixworld.coevolution.sections import OwnCode, Section, documented, setting
from matrixworld.coevolution.types import TEAMS, Team
from matrixworld.world.policy import SCRIPTS

Fields = Mapping[str, Mapping[str, Any]]
"""Texts that stand for a section, and the fields that each of them sets."""

# Opponents of a team:

DRAWN: dict[str, Callable[[int], OpponentSampler]] = {
    "latest": opponents.Latest,
    "uniform": opponents.Uniform,
    "round-robin": opponents.RoundRobin,
    "hall-of-fame": lambda n: opponents.HallOfFame(newest=n // 2, sampled=n - n // 2),
    "prioritized-hard": lambda n: opponents.Prioritized(opponents.hard(), count=n),
    "prioritized-even": lambda n: opponents.Prioritized(opponents.even, count=n),
    "shared-sampling": opponents.SharedSampling,
}
"""Name -> factory: opponents an epoch -> a new sampler.

Half of the opponents of `hall-of-fame` are the newest; the other half, or one more, are drawn from
the older ones. With one opponent it draws from all, as `uniform` does.
"""
ARCHIVES: dict[str, Callable[[int], opponents.Archive]] = {
    "maxsolve": opponents.MaxSolve,
    "ipca": lambda size: opponents.IPCA(),
    "lapca": opponents.LAPCA,
    # All members are generation 0 at the start.
    "generalist": lambda size: opponents.Generalist(
        np.zeros(size, dtype=np.intp), sample_size=size
    ),
}
"""Name -> factory: size -> a new archive."""
ARCHIVE_SIZE = 10

SAMPLERS = (*DRAWN, *ARCHIVES, *META_SOLVERS)
"""Names of the opponent samplers of the package."""


@documented
@dataclass(frozen=True)
class DrawnOpponents(Section):
    """Opponents drawn from all generations of the other team."""

    kind: ClassVar[str] = "drawn"
    shorthands: ClassVar[Fields] = {name: {"rule": name} for name in DRAWN}

    rule: str = setting("uniform", f"how: {', '.join(DRAWN)}", choices=DRAWN)

    def new(self, count: int) -> OpponentSampler:
        """Return a new sampler of up to `count` opponents an epoch."""
        return DRAWN[self.rule](count)


@documented
@dataclass(frozen=True)
class ArchivedOpponents(Section):
    """The newest opponent and those that an archive keeps (`ArchiveSampler`)."""

    kind: ClassVar[str] = "archived"
    shorthands: ClassVar[Fields] = {name: {"archive": name} for name in ARCHIVES}

    archive: str = setting("maxsolve", f"which one: {', '.join(ARCHIVES)}", choices=ARCHIVES)
    size: int | None = setting(
        None,
        "maxsolve: candidates kept; lapca: layers; generalist: opponents kept; default: "
        f"{ARCHIVE_SIZE}",
        least=1,
    )
    episodes: int = setting(3, "matches of each pair that it compares", least=1)

    def check(self) -> None:
        """Raise ValueError if an archive without a size has one."""
        if self.archive == "ipca" and self.size is not None:
            raise ValueError(f"size: expected no value with ipca, got {self.size}")

    def new(self, count: int) -> OpponentSampler:
        """Return a new sampler of up to `count` opponents an epoch."""
        return opponents.ArchiveSampler(ARCHIVES[self.archive](self.size or ARCHIVE_SIZE), count)


@documented
@dataclass(frozen=True)
class MetaOpponents(Section):
    """Opponents drawn from a meta-strategy of all generations of the other team: PSRO."""

    kind: ClassVar[str] = "meta"
    shorthands: ClassVar[Fields] = {name: {"solver": name} for name in META_SOLVERS}

    solver: str = setting("nash", f"which one: {', '.join(META_SOLVERS)}", choices=META_SOLVERS)
    episodes: int = setting(10, "matches of each pair in the payoff matrix", least=1)

    def new(self, count: int) -> OpponentSampler:
        """Return a new sampler of up to `count` opponents an epoch."""
        return opponents.MetaStrategy(META_SOLVERS[self.solver], count)


@documented
@dataclass(frozen=True)
class OwnOpponents(OwnCode):
    """Opponents by a sampler of your own (see `OpponentSampler`)."""

    def new(self, count: int) -> OpponentSampler:
        """Return a new sampler of up to `count` opponents an epoch; imports its code."""
        sampler: OpponentSampler = made(self.code, OPPONENT, {"count": count}, self.settings)
        return sampler


Opponents: TypeAlias = DrawnOpponents | ArchivedOpponents | MetaOpponents | OwnOpponents


# Schedules:


@dataclass(frozen=True)
class Schedule(Section):
    """Base of the schedules."""

    @property
    def name(self) -> str:
        """What the schedule is called, such as in directories."""
        return self.kind

    @property
    def conditions(self) -> tuple[str, ...]:
        """Names under which a setting may have another default with this schedule."""
        return (*(f"{self.kind} {team}" for team in self.learning_teams), self.kind)

    @property
    def learning_teams(self) -> tuple[Team, ...]:
        """Teams that learn."""
        return TEAMS

    @property
    def opponents_met(self) -> int:
        """Most opponents of a candidate in an epoch."""
        return 1

    @property
    def limits(self) -> str:
        """What races with so few epochs may hide, in a sentence; empty if nothing is known."""
        return ""

    @property
    @abstractmethod
    def entries(self) -> int:
        """Genomes in the archive of a learning team at the end of a run."""

    @abstractmethod
    def total_epochs(self, team: Team) -> int:
        """Return the epochs of the whole run in which `team` learns."""

    @abstractmethod
    def new_sampler(self, team: Team) -> OpponentSampler:
        """Return a new opponent sampler of a team that learns."""


@dataclass(frozen=True)
class RaceSchedule(Schedule):
    """Base of the schedules in which both teams learn."""

    generations: int = setting(30, "generations after the untrained generation 0", least=1)
    pursuers_meet: Opponents = setting(
        DrawnOpponents(), f"which evaders pursuers meet: {', '.join(SAMPLERS)} or module:object"
    )
    evaders_meet: Opponents = setting(
        DrawnOpponents(), "which pursuers evaders meet; as for the pursuers"
    )
    retention_episodes: int = setting(
        0,
        "matches of the new and of the previous genome of a team against each archived opponent; "
        "the new one is discarded if it is worse; 0: each new genome is kept",
    )

    @property
    def sampled_opponents(self) -> int:
        """Most archived opponents of a candidate in an epoch."""
        return self.opponents_met

    @abstractmethod
    def epochs(self, team: Team) -> int:
        """Return the epochs of a generation in which `team` learns."""

    @property
    def entries(self) -> int:
        """Genomes in the archive of a team at the end of a race."""
        return 1 + self.generations

    def total_epochs(self, team: Team) -> int:
        """Return the epochs of the whole run in which `team` learns."""
        return self.generations * self.epochs(team)

    def opponents_of(self, team: Team) -> Opponents:
        """Return which opponents `team` meets."""
        return self.pursuers_meet if team == "pursuer" else self.evaders_meet

    def archive_episodes(self, team: Team) -> int:
        """Return the matches of each pair that a team's archive compares."""
        return int(getattr(self.opponents_of(team), "episodes", ArchivedOpponents().episodes))

    def new_sampler(self, team: Team) -> OpponentSampler:
        """Return a new opponent sampler of a team.

        Raises ValueError if own code cannot be imported or refuses its settings, PluginError if it
        fails.
        """
        # A hall-of-fame race without sampled opponents has samplers, too, but never asks them.
        return self.opponents_of(team).new(max(1, self.sampled_opponents))


PAPER: dict[str, dict[str, str]] = {
    "specialist-specialist": {"pursuers_meet": "latest", "evaders_meet": "latest"},
    "generalist-specialist": {"pursuers_meet": "round-robin", "evaders_meet": "latest"},
    "generalist-generalist": {"pursuers_meet": "round-robin", "evaders_meet": "round-robin"},
}
PSRO = "psro"
"""Name of a schedule in which both teams meet meta-strategies."""
ENOUGH_EPOCHS = 60
HIDES_CYCLING = (
    "Short races of specialists may hide cycling: with 28 and 58 epochs in a generation it was "
    f"found in 5 of 20 races, with {ENOUGH_EPOCHS} and 120 in 12 of 20."
)
"""By ``evolution/race_budgets.py``; epochs of pursuers and of evaders."""


@documented
@dataclass(frozen=True)
class Alternating(RaceSchedule):
    """The teams learn in turns, against archived opponents."""

    kind: ClassVar[str] = "alternating"
    shorthands: ClassVar[Fields] = {
        **PAPER,
        PSRO: {"pursuers_meet": "nash", "evaders_meet": "nash"},
    }

    opponents: int = setting(1, "opponents of each candidate in an epoch", least=1)
    pursuer_epochs: int = setting(
        28, "epochs per generation in which pursuers learn", by={"gradients": 400}, least=1
    )
    evader_epochs: int = setting(
        58, "epochs per generation in which evaders learn", by={"gradients": 400}, least=1
    )

    @property
    def name(self) -> str:
        """The name in the paper of a schedule that has one, "psro", or "alternating"."""
        if all(isinstance(self.opponents_of(team), MetaOpponents) for team in TEAMS):
            return PSRO
        rules = tuple(getattr(self.opponents_of(team), "rule", None) for team in TEAMS)
        names = [name for name, each in PAPER.items() if rules == tuple(each.values())]
        return names[0] if names and self.opponents == 1 else self.kind

    @property
    def limits(self) -> str:
        """What races with so few epochs may hide, in a sentence; empty if nothing is known."""
        specialists = self.name == "specialist-specialist"
        return HIDES_CYCLING if specialists and self.pursuer_epochs < ENOUGH_EPOCHS else ""

    @property
    def opponents_met(self) -> int:
        """Most opponents of a candidate in an epoch."""
        return self.opponents

    def epochs(self, team: Team) -> int:
        """Return the epochs of a generation in which `team` learns."""
        return self.pursuer_epochs if team == "pursuer" else self.evader_epochs


@documented
@dataclass(frozen=True)
class Yoked(Alternating):
    """As an alternating race, but the opponents are those of a race that another seed has finished.

    They change from generation to generation as in that race, and never in answer to the team that
    learns: a yoked control (Held and Hein 1963).
    """

    kind: ClassVar[str] = "yoked"
    shorthands: ClassVar[Fields] = {}

    race: str = setting("", "run directory of a finished race with another seed, to be replayed")

    def check(self) -> None:
        """Raise ValueError without a race, or if a team's results would choose its opponents."""
        if not self.race:
            raise ValueError("race: expected a run directory, got none")
        for team in TEAMS:
            met = self.opponents_of(team)
            drawn = isinstance(met, DrawnOpponents)
            if not (drawn and isinstance(met.new(1), opponents.Stateless)):
                raise ValueError(
                    f"{team}s_meet: expected a sampler without scores in a yoked race, such as "
                    f"uniform, got {next(iter(vars(met).values()))}"
                )

    @property
    def name(self) -> str:
        """The name of the replayed schedule after "yoked"."""
        return f"{self.kind}-{self.replayed.name}"

    @property
    def replayed(self) -> Alternating:
        """The schedule of the race that is replayed."""
        return Alternating(**{each.name: getattr(self, each.name) for each in fields(Alternating)})


@documented
@dataclass(frozen=True)
class Simultaneous(RaceSchedule):
    """Both teams learn at the same time, from living opponents and a hall of fame."""

    kind: ClassVar[str] = "hall-of-fame"

    joint_epochs: int = setting(
        43, "epochs per generation, in which both teams learn", by={"gradients": 400}, least=1
    )
    contemporaries: int = setting(2, "living opponents of each individual")
    hall_sample: int = setting(1, "opponents of each individual from the hall of fame")

    def check(self) -> None:
        """Raise ValueError without opponents, or if a sampler is named that draws none."""
        if not self.opponents_met:
            raise ValueError("contemporaries and hall_sample: expected at least 1 opponent, got 0")
        for name in ("pursuers_meet", "evaders_meet"):
            if not self.hall_sample and getattr(self, name) != DrawnOpponents():
                raise ValueError(f"{name}: expected no value with a hall_sample of 0")

    @property
    def opponents_met(self) -> int:
        """Most opponents of a candidate in an epoch."""
        return self.contemporaries + self.hall_sample

    @property
    def sampled_opponents(self) -> int:
        """Most archived opponents of a candidate in an epoch."""
        return self.hall_sample

    def epochs(self, team: Team) -> int:
        """Return the epochs of a generation, in which both teams learn."""
        return self.joint_epochs


@documented
@dataclass(frozen=True)
class Against(Schedule):
    """One team learns alone, against fixed opponents."""

    kind: ClassVar[str] = "against"

    team: Team = setting("pursuer", "team that learns: pursuer or evader", choices=TEAMS)
    opponent: str = setting(
        "random", f"{', '.join(SCRIPTS)}, or a run directory (its last generation)"
    )
    start: str | None = setting(
        None, "run directory; start from its last generation instead of an untrained genome"
    )
    epochs: int = setting(
        6000,
        "epochs of the run",
        by={"gradients": 1200, "against pursuer": 6000, "against evader": 4000},
        least=1,
    )
    archive_every: int = setting(
        100, "epochs between entries of the archive; each is a checkpoint", least=1
    )

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

    def total_epochs(self, team: Team) -> int:
        """Return the epochs of the run."""
        return self.epochs

    def new_sampler(self, team: Team) -> OpponentSampler:
        """Return a new opponent sampler of the team that learns: each opponent in turn."""
        return opponents.RoundRobin()


@documented
@dataclass(frozen=True)
class Maps(Alternating):
    """As an alternating race, but on maps that evolve: each epoch on a map of an archive."""

    kind: ClassVar[str] = "maps"
    shorthands: ClassVar[Fields] = {f"maps-{name}": {"map_fitness": name} for name in MAP_FITNESS}

    map_fitness: str = setting(
        "learnability", f"what maps are selected by: {', '.join(MAP_FITNESS)}", choices=MAP_FITNESS
    )
    map_team: MapTeam = setting(
        BOTH, f"whose regret is computed or estimated: {', '.join(MAP_TEAMS)}", choices=MAP_TEAMS
    )
    maps: int = setting(16, "maps in the archive", least=1)
    children: int = setting(12, "maps in each generation that are edits of archived ones")
    fresh: int = setting(4, "maps in each generation that are drawn anew")
    edits: int = setting(3, "edits of each child: a wall added, removed or moved", least=1)
    walls: float = setting(0.2, "share of walls in maps that are drawn", most=1.0)
    map_matches: int = setting(
        16, "matches of the newest genomes on each map in a generation, by which it is scored",
        least=1,
    )  # fmt: skip

    def check(self) -> None:
        """Raise ValueError for a value that has no effect with this fitness."""
        fitness = MAP_FITNESS[self.map_fitness]
        idle = {
            "map_team": not fitness.by_team,
            "map_matches": not fitness.plays,
            **dict.fromkeys(("children", "fresh", "edits"), self.map_fitness == NONE),
        }
        for item in fields(self):
            value, usual = getattr(self, item.name), item.metadata["default"]
            if idle.get(item.name) and value != usual:
                raise ValueError(
                    f"{item.name}: expected {usual}, got {value!r}; it has no effect with "
                    f"{self.map_fitness}"
                )

    @property
    def name(self) -> str:
        """The name of the fitness after "maps"."""
        return f"{self.kind}-{self.map_fitness}"

    @property
    def scored_matches(self) -> int:
        """Matches in a generation by which maps are scored."""
        plays = MAP_FITNESS[self.map_fitness].plays
        return plays * self.map_matches * (self.maps + self.children + self.fresh)


SCHEDULES: dict[str, Alternating] = {
    name: Alternating(**samplers)  # type: ignore[arg-type]  # a text stands for a section
    for name, samplers in PAPER.items()
}
"""The paper's schedules by name."""
ALTERNATING, HALL_OF_FAME = Alternating.kind, Simultaneous.kind
ALL_SCHEDULES = (*SCHEDULES, PSRO, ALTERNATING, HALL_OF_FAME)
"""Names of all schedules of races."""


def curve_window(schedule: Schedule) -> int:
    """Return the epochs of the moving average of a training curve, the same for both teams."""
    if isinstance(schedule, RaceSchedule):
        return max(1, min(schedule.epochs(team) for team in TEAMS) // 4)
    return max(1, schedule.total_epochs("pursuer") // 100)


def available(team: Team, k: int) -> int:
    """Return how many generations of the other team are archived when a team learns, in turns.

    Parameters
    ----------
    team : {"pursuer", "evader"}
        The team that learns.
    k : int
        The generation that it learns, at least 1: generation 0 is untrained.
    """
    check_choice("team", team, TEAMS)
    check_integer("k", k, 1)
    # The pursuers learn first, so the evaders can play against generation k already.
    return k if team == "pursuer" else k + 1
