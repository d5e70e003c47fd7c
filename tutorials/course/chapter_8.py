"""Exercises of notebook 8, "Read what evolution wrote", and its evolved teams."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import Any

import numpy as np

from course.chapter_9 import WORLD
from course.checks import Mistake, comparison, described
from matrixworld import Matches, Population, Program, rollout
from matrixworld.coevolution import RaceSettings, Results, Task
from matrixworld.coevolution.types import FloatArray, Genome, Genomes
from matrixworld.world.policy import Policy

PROGRAM = Program(fov=WORLD.fov)
LEARNERS = {"program": {"kind": "gp", "population": 48}, "rating": {"kind": "es", "population": 32}}
"""Learners by kind of policy."""
MATCHES = 4
"""Matches of each candidate in an epoch."""


def score(teams: Genomes, seeds: Iterable[int], policy: Policy = PROGRAM) -> FloatArray:
    """Return the captured share, a mean over steps and matches, of each team (n, genes)."""
    luck = np.array([*seeds])
    who, each = np.repeat(range(len(teams)), len(luck)), np.tile(luck, len(teams))
    played = rollout(WORLD, Population(teams, policy), "fleer", Matches.of(who, 0, each))
    return np.asarray(played.captured_fraction.reshape(len(teams), -1).mean(axis=1))


def evolve(
    seed: int, kind: str = "program", *, epochs: int = 32
) -> tuple[Any, Genome, list[tuple[Genomes, FloatArray]]]:
    """Return a policy of a kind, the genome that it learned, and the candidates of each epoch.

    Candidates are genomes and their scores.
    """
    settings = RaceSettings.of({"world": WORLD, "policy": kind, "learner": LEARNERS[kind]})
    game, learner, rng = settings.training_game, settings.learner, np.random.default_rng(seed)
    policy = game.policies["pursuer"]
    state = learner.start(
        Task(seed, 0, epochs, lambda rng: game.untrained("pursuer", rng), None, game)
    )
    history = []
    for _ in range(epochs):
        candidates, state = learner.ask(state, rng)
        found = score(candidates, rng.integers(2**62, size=MATCHES), policy)
        state = learner.tell(state, Results(found))
        history.append((candidates, found))
    return policy, learner.genome(state), history


def lengths(history: list[tuple[Genomes, FloatArray]]) -> list[float]:
    """Return the mean number of tokens of the programs of each epoch."""
    return [float(np.mean([len(PROGRAM.tokens(each)) for each in found])) for found, _ in history]


# ---- Exercises -----------------------------------------------------------------------------------

MEANINGS: dict[str, Callable[[float, float], float]] = {
    "add": lambda a, b: a + b,
    "subtract": lambda a, b: a - b,
    "multiply": lambda a, b: a * b,
    "min": min,
    "max": max,
}
"""Operations of the first exercise."""


def _rated(tokens: Sequence[str | float], inputs: Mapping[str, float]) -> float:
    stack: list[float] = []
    for token in tokens:
        if token in MEANINGS:
            b, a = stack.pop(), stack.pop()
            stack.append(MEANINGS[str(token)](a, b))
        else:
            stack.append(inputs[token] if isinstance(token, str) else token)
    return stack[0]


INPUTS = {"room": 0.8, "adversary": 0.6, "teammate": 1.4, "exits": 0.25}
TEXTS = (
    "room",
    "room + 0.5",
    "room - adversary",
    "room - 2 * adversary",
    "min(exits, room - 2 * adversary) + teammate",
    "max(room * teammate, exits) - (adversary - 0.1 * teammate)",
)

exercise_1 = comparison(
    _rated,
    [(PROGRAM.tokens(PROGRAM.genome(text)), INPUTS) for text in TEXTS],
    case="For the tokens {tokens}",
    otherwise="Expected the number that is left on the stack at the end.",
)
"""Run a program."""


def _shortened(
    program: Any,
    shorter: Callable[[Any], Iterable[Any]],
    score: Callable[[Any], float],
    least: float,
) -> Any:
    for other in shorter(program):
        if score(other) >= least:
            return _shortened(other, shorter, score, least)
    return program


def _without_a_letter(word: str) -> list[str]:
    return [word[:place] + word[place + 1 :] for place in range(len(word))]


def _count_of_a(word: str) -> int:
    return word.count("a")


exercise_2 = comparison(
    _shortened,
    [(word, _without_a_letter, _count_of_a, least) for word, least in
     (("aa", 2), ("xa", 1), ("xxa", 1), ("axbxa", 2), ("bananas", 2), ("xyz", 0))],
    lambda value: value,
    case="For the word {program!r}, words without one of its letters, the number of a as score and "
    "least = {least}",
    clues={
        "That is one step. Begin again with the shorter program, until none is left.": (
            lambda program, shorter, score, least: next(
                (other for other in shorter(program) if score(other) >= least), program
            )
        ),
    },
    otherwise="Expected the word that is left when no shorter one has the score `least`.",
)  # fmt: skip
"""Shorten a program as long as it plays as well."""

MOST_TOKENS, FEWEST_CAPTURED = 7, 0.85
TRIALS = range(2_000, 3_000)


def exercise_3(answer: Any) -> None:
    """Write a short program that is fast and never at fault."""
    if not isinstance(answer, str):
        raise Mistake(f"Expected a text such as '-adversary', got {described(answer)}.")
    try:
        genome = PROGRAM.genome(answer)
    except ValueError as error:
        raise Mistake(f"This is no program. {error}.") from None
    tokens = PROGRAM.tokens(genome)
    if len(tokens) > MOST_TOKENS:
        raise Mistake(f"It has {len(tokens)} tokens, and at most {MOST_TOKENS} are allowed.")
    matches = Matches.of(0, 0, TRIALS)
    played = rollout(WORLD, Population(genome, PROGRAM), "fleer", matches)
    share = float(played.captured_fraction.mean())
    faults = 1000 * played.faults[:, :, 0].sum() / played.agent_steps[:, :, 0].sum()
    told = (
        f"In {len(TRIALS)} new matches it scores {share:.3f}, and is at fault in {faults:.1f} of "
    )
    told += "1000 agent-steps."
    if faults > 0.0:
        raise Mistake(f"{told} One input knows who has to give way.")
    if share < FEWEST_CAPTURED:
        raise Mistake(f"{told} Nobody collides. Now spread the team: not all from one side.")
