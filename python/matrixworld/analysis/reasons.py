"""Reasons: why a number has no interval or no value, and why a verdict is what it is.

Code asks which reason it is by its member of `Why`. Its words are made when they are printed, with
the names that a game gives its teams. Of a condition that is present they say how much, not who did
what: `judgement.Words` says that, in sentences and before the reason.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum, unique

from matrixworld._util.readable import Worded
from matrixworld._util.teams import BOTH
from matrixworld.analysis.payoffs import EPISODES_TO_JUDGE, EPISODES_TO_RECUR, GENERATIONS_TO_JUDGE
from matrixworld.analysis.teams import listed, names_of


@unique
class Why(Enum):
    """Reasons; the value is a clause after "because", or after who did what.

    It may name the `{number}` and the `{teams}` of a `Reason`, and the `{score}` of a game.
    """

    NOTHING = ""

    # A number has no interval, or one that is wide.
    SINGLE_RUN = "a single run has no interval over runs"
    FEW_RUNS = "{number} runs only: the interval is wide"
    TOO_FEW_RUNS = "no interval below {number} runs"
    EQUAL_RUNS = "no interval: all {number} runs are equal"
    EQUAL_EPISODES = "no interval: all episodes are equal"
    NOISE_SUBTRACTED = "episode noise subtracted: no interval"
    # Noise shifts these by an unknown amount, such as maxima of cells.
    BIASED = "biased by episode noise: no interval"
    BIASED_BY_FEW_EPISODES = "biased by episode noise: no interval below {number} episodes"
    BIASED_AND_EQUAL = "biased by episode noise: no interval, no variation beyond it"

    # A number has no value.
    NO_RUN_HAS_IT = "not defined for any run"
    NOT_OF_THIS_MATRIX = "not defined for this matrix"
    ONE_GENERATION = "it takes at least 2 generations of each team"
    TOO_SHORT = f"it takes at least {GENERATIONS_TO_JUDGE} generations of each team"
    EPISODES_UNKNOWN = (
        f"it takes the number of episodes of each pair, at least {EPISODES_TO_JUDGE}, to tell it "
        "from noise"
    )
    NO_SINGLE_EPISODES = (
        f"it takes the single episodes of each pair, at least {EPISODES_TO_JUDGE}, to tell it from "
        "noise"
    )
    TOO_FEW_TO_RECUR = (
        f"it takes the single episodes of each pair, at least {EPISODES_TO_RECUR}, to see whether "
        "strategies return"
    )
    ONLY_NOISE = "the {score}s vary no more than episode noise does"

    # What to know about a number.
    NOT_SUSTAINED = "not sustained: a jump or a setback makes much of the change"
    FALLS_BACK = "loses again, against some opponents, what it had gained"

    # Verdicts on any condition.
    MARGIN_INSIDE = "the interval contains the margin"
    HIDDEN = "one team wins nearly all matches, which hides this condition"
    FEW_ENGAGED = "fewer than {number} of the runs are engaged, the others hide this condition"
    EACH_RUN = "each run by itself says so"
    RUNS_DIFFER = "the runs do not all show the same"

    # Disengagement:
    ONE_SIDED = "more than {number:.0%} of the payoff in half of the generations"
    NOT_ONE_SIDED = "neither team gets {number:.0%} of its payoff in half of the generations"

    # Arms race, one-sided progress, and progress:
    BOTH_IMPROVED = (
        "each by more than a random walk with such steps would; whether they need each other for "
        "it, no matrix tells"
    )
    ONE_IMPROVED = "by more than a random walk with such steps would; the other team stands still"
    IMPROVED = "by more than a random walk with such steps would"
    NOT_IMPROVED = "{teams} did not improve: their gain is not above 0, and below {number}"
    BOTH_DID = "both teams improved"
    RANDOM_WALK = "a random walk may explain the gain of {teams}"
    MAY_FALL = "{teams} did not stand still: it may be a loss of {number}"
    CIRCLE = "both teams lose again what they gain, as in a circle, whose end is not seen"
    ONE_HALF = "what improves in this half does not improve in the same way over the whole race"

    # The mean of both sides:
    JOINT_CHANGE = "surely by more than {number}, and not mostly in a jump"
    NO_JOINT_RISE = "the mean of both sides did not rise by {number} against contemporaries"
    NO_JOINT_FALL = "the mean of both sides did not fall by {number} against contemporaries"
    JOINT_JUMP = "the mean of both sides changed, but mostly in a jump or with a setback"

    # A condition has no meaning:
    NOT_CONSTANT_SUM = "what one team wins is not what the other loses"
    ONE_POPULATION = "one population plays both sides"
    NOTHING_TO_RACE_WITH = "one population has no other one to race with"

    # Rise:
    STRONGER = "by more than {number} in this race"
    STRONGER_BUT = "by more than {number} in this race, without a setback"
    STRONGER_IN_A_JUMP = (
        "{teams} ended more than {number} stronger, but mostly in a jump or with a setback"
    )
    NOT_STRONGER = "neither team ended {number} stronger"

    # Intransitivity and cycling:
    NO_ORDER = "episode noise does not, either"
    ORDER = "an order of strength and episode noise explain the {score}s"
    FEW_CHECKERBOARDS = "no order of strength explains the {score}s, but checkerboards are rare"
    RETURN = "generations are like earlier ones again, after others that were not"
    NO_RETURN = "no strategies return"
    RETURN_IN_ORDER = "strategies return, but an order of strength may explain them"
    NO_INTERACTION = (
        "scores differ by less than {number} from what the strengths of both sides explain"
    )
    NO_CIRCLE = "generations do not beat each other in a circle"

    # Forgetting:
    FORGETS = "more than {number} below the best ancestors"
    NOT_FORGETS = "neither team falls {number} below its best ancestors"

    # Stagnation:
    NO_CHANGE = "no change of {number} in the mean over all opponents, nor in who beats whom"
    CHANGES = "the strength of a team changes by {number} or more"
    MAY_CHANGE = "a change of {number} cannot be ruled out"
    MAY_BE_INTRANSITIVE = "neither team ended stronger, but the race may be intransitive"
    PROGRESS = "progress is present"
    ARMS_RACE = "arms race is present"
    ONE_SIDED_PROGRESS = "one-sided progress is present"
    INTRANSITIVITY = "intransitivity is present"


OF_ONE_POPULATION: dict[Why, str] = {
    Why.TOO_SHORT: f"it takes at least {GENERATIONS_TO_JUDGE} generations",
    Why.ONE_GENERATION: "it takes at least 2 generations",
    Why.CIRCLE: "the population loses again what it gains, as in a circle, whose end is not seen",
    Why.NOT_STRONGER: "the population did not end {number} stronger",
    Why.NOT_FORGETS: "the population does not fall {number} below its best ancestors",
    Why.CHANGES: "the strength of the population changes by {number} or more",
    Why.MAY_BE_INTRANSITIVE: (
        "the population did not end stronger, but the race may be intransitive"
    ),
}
"""What reasons are called that would speak of two teams."""


@dataclass(frozen=True, repr=False)
class Reason(Worded):
    """A reason, with the number and the teams that its words name.

    It is false if there is nothing to say. Printed, it has the words of pursuit.
    """

    why: Why = Why.NOTHING
    number: float | None = None
    teams: tuple[str, ...] = ()

    def __bool__(self) -> bool:
        return self.why is not Why.NOTHING

    def __str__(self) -> str:
        return self.in_words()

    def __repr__(self) -> str:
        return repr(self.in_words())

    def in_words(self, teams: tuple[str, str] = BOTH) -> str:
        """Return the reason in the words of a game whose teams have these names."""
        names = {**names_of(teams), "teams": listed(self.teams, teams)}
        clause = self.why.value
        if teams[0] == teams[1]:
            clause = OF_ONE_POPULATION.get(self.why, clause)
        return clause.format(number=self.number, **names)


NOTHING = Reason()
"""The note of a number about which nothing has to be known."""
