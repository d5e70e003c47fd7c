"""The loops of training: what happens in one stage of each kind of schedule.

`k` is the generation that learns (from 1), `i` the epoch inside it (from 0). The archives begin
with the untrained `p[0]` and `e[0]`. A loop asks the learners for candidates, plays them, tells the
learners their fitness, and archives champions, all by the methods of a `Training`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from functools import partial

import numpy as np

from matrixworld._util.checks import check_choice, check_integer
from matrixworld.coevolution import seeding, types
from matrixworld.coevolution.settings.schedules import Against, AtOnce, InTurns, Schedule, SelfPlay
from matrixworld.coevolution.training.training import Played, Training
from matrixworld.coevolution.types import (
    TEAMS,
    FloatArray,
    Genome,
    Genomes,
    Indices,
    Seeds,
    Team,
    other,
)

# In turns:


def learn_in_turns(training: Training, stage: int) -> None:
    """Let one team learn for the epochs of a generation, and archive its genome."""
    schedule = training.settings.schedule
    assert isinstance(schedule, InTurns)
    # Pursuers in even stages, evaders in odd ones; generation 0 is untrained.
    generation = 1 + stage // 2
    team = TEAMS[stage % 2]
    training.update_sampler(team, generation, available(team, generation))
    epochs = range(schedule.epochs(team))
    activity = f"generation {generation}: {training.name_of(team)}"
    genome = improve(training, team, generation, schedule.opponents, epochs, activity)
    training.archive_genome(team, genome)


def available(team: Team, k: int) -> int:
    """Return how many generations of the other team are archived when `team` learns, in turns.

    `k` is the generation that the team learns, at least 1: generation 0 is untrained.
    """
    check_choice("team", team, TEAMS)
    check_integer("k", k, 1)
    # The pursuers learn first, so the evaders can play against generation k already.
    return k if team == "pursuer" else k + 1


def improve(
    training: Training,
    team: Team,
    generation: int,
    count: int,
    epochs: Iterable[int],
    activity: str,
    scripts: Sequence[str] = (),
) -> Genome:
    """Let a team learn for some epochs against `count` opponents each; return its genome.

    It meets the opponents of its training, or if there are any `scripts`, these in turn.
    """
    rivals = training.opponents(team)
    n = len(training.learners[team].seed_groups)

    def table(values: FloatArray) -> FloatArray:
        return values.reshape(n, -1)

    for epoch in epochs:
        training.begin_epoch(team, generation, epoch)
        candidates = training.ask(team, generation, epoch)
        rng = training.generator(seeding.Purpose.OPPONENTS, team, generation, epoch)
        opponents = scripts[epoch % len(scripts)] if scripts else rivals
        met = training.sample(team, types.team_size(opponents), count, epoch, rng)
        seeds = match_seeds(training, team, generation, epoch, met)
        scores = training.play_candidates(team, candidates, opponents, met, seeds)
        # Win rates, not fitness: samplers expect numbers in [0, 1].
        training.tell_sampler(team, met, table(scores.of(team).mean(axis=1)))
        opponent = int(met[0]) if len(met) == 1 else types.SEVERAL
        fitness = training.log_fitness(team, scores, table, generation, epoch, opponent)
        training.on_activity(activity)
        training.tell(team, fitness, opponents, np.tile(met, n), seeds.ravel())
    return training.champion(team, generation, candidates, Played(fitness, opponents, met))


def match_seeds(training: Training, team: Team, generation: int, epoch: int, met: Indices) -> Seeds:
    """Return the seeds (n, c) of n candidates against the opponents (c,) of an epoch."""
    # Candidates of the same match, such as a mirrored pair, differ in nothing but their genes.
    groups = training.learners[team].seed_groups
    n_groups = int(groups.max()) + 1
    phase = seeding.Phase.PURSUERS_LEARN if team == "pursuer" else seeding.Phase.EVADERS_LEARN
    columns = []
    for opponent in map(int, met):
        # They depend on both generations, so that no two phases play the same episodes.
        pair = (generation, opponent) if team == "pursuer" else (opponent, generation)
        seeds = seeding.training_seeds(training.settings.seed, *pair, phase, epoch, n_groups)
        columns.append(seeds[groups])
    return np.stack(columns, axis=1)


# At the same time:


def learn_at_once(training: Training, stage: int) -> None:
    """Let both teams evolve for the epochs of a generation, and archive their champions."""
    schedule = training.settings.schedule
    assert isinstance(schedule, AtOnce)
    generation = 1 + stage
    if training.settings.game.symmetric:
        _learn_within(training, schedule, generation)
        return
    for team in TEAMS:
        training.update_sampler(team, generation, generation)
    for epoch in range(schedule.joint_epochs):
        training.begin_epoch("pursuer", generation, epoch)
        populations = {team: training.ask(team, generation, epoch) for team in TEAMS}
        played = _play_epoch(training, schedule, generation, epoch, populations)
        training.on_activity(f"generation {generation}: both")
    # Both teams before either archive grows, so that the order of the teams does not matter.
    genomes = {
        team: training.champion(team, generation, populations[team], played[team]) for team in TEAMS
    }
    for team in TEAMS:
        training.archive_genome(team, genomes[team])


def _play_epoch(
    training: Training,
    schedule: AtOnce,
    generation: int,
    epoch: int,
    populations: Mapping[Team, Genomes],
) -> dict[Team, Played]:
    """Play the matches of an epoch, and let both teams learn from them."""
    # One generator for both teams: their matches are drawn together.
    rng = training.generator(seeding.Purpose.OPPONENTS, "pursuer", generation, epoch)
    sampled = _sampled_from_halls(training, schedule, epoch, rng)
    halls = {team: training.genomes(team)[sampled[other(team)]] for team in TEAMS}
    hall_sizes = len(halls["pursuer"]), len(halls["evader"])
    # Both teams have the same learner, and with it the same groups.
    groups = training.learners["pursuer"].seed_groups
    pursuers, evaders, seed_indices = pairings(groups, schedule.contemporaries, hall_sizes, rng)
    everyone = {
        team: training.population(team, np.concatenate([populations[team], halls[team]]))
        for team in TEAMS
    }
    key = (training.settings.seed, generation, generation, seeding.Phase.BOTH_LEARN, epoch)
    seeds = seeding.training_seeds(*key, int(seed_indices.max()) + 1)[seed_indices]
    scores = training.play(everyone["pursuer"], everyone["evader"], (pursuers, evaders, seeds))
    players = {"pursuer": pursuers, "evader": evaders}
    played: dict[Team, Played] = {}
    for team in TEAMS:
        own = players[team]
        opponents = players[other(team)]
        rivals = everyone[other(team)]
        n = len(populations[team])
        table = partial(table_of_individuals, own, opponents, n)
        fitness = training.log_fitness(team, scores, table, generation, epoch, types.SEVERAL)
        if len(sampled[team]):
            # Columns from n on are the hall of fame.
            won = table(scores.of(team).mean(axis=1))[:, n:]
            training.tell_sampler(team, sampled[team], won)
        played[team] = Played(fitness, rivals, met=opponents[own == np.argmax(fitness)])
        living = own < n
        training.tell(team, fitness, rivals, opponents[living], seeds[living])
    return played


def _sampled_from_halls(
    training: Training, schedule: AtOnce, epoch: int, rng: types.Rng
) -> dict[Team, Indices]:
    """Return the generations of the other team whom each team meets in an epoch."""
    if not schedule.hall_sample:
        return dict.fromkeys(TEAMS, np.zeros(0, dtype=np.intp))
    size = len(training.archive["pursuer"])
    return {
        team: training.sample(team, size, schedule.hall_sample, epoch, rng)
        for team in training.learners
    }


def pairings(
    seed_groups: Indices, contemporaries: int, hall: tuple[int, int], rng: types.Rng
) -> tuple[Indices, Indices, Indices]:
    """Return pursuers, evaders and indices of seeds (M,) of matches.

    Numbers below n are individuals, others members of the `hall` of fame, whose sizes are given.
    Individuals of the same group of `seed_groups` (n,) have the same seeds.

    Groups meet groups in random order, and their members meet in turn. Between mirrored samples the
    strength of the opponents then cancels out, as the luck of the match seed does. Where all
    individuals are one group, each meets single opponents in random order.
    """
    n = len(seed_groups)
    n_groups = int(seed_groups.max()) + 1
    blocks = _blocks(seed_groups)
    _, size = blocks.shape
    individuals = blocks.ravel()
    rounds = []
    for first in range(0, contemporaries, size):
        opponents = blocks[rng.permutation(len(blocks))]
        shifts = range(min(size, contemporaries - first))
        rounds += [(individuals, np.roll(opponents, shift, axis=1).ravel()) for shift in shifts]
    rounds += [(individuals, np.full(n, n + member)) for member in range(hall[1])]
    rounds += [(np.full(n, n + member), individuals) for member in range(hall[0])]
    pursuers, evaders = zip(*rounds, strict=True)
    # Other seeds in each round.
    first_seeds = np.arange(len(rounds))[:, np.newaxis] * n_groups
    seeds = first_seeds + seed_groups[individuals]
    return np.concatenate(pursuers), np.concatenate(evaders), seeds.ravel()


def table_of_individuals(
    own: Indices, opponents: Indices, n: int, values: FloatArray
) -> FloatArray:
    """Return the values (M,) of matches as a table (n, m): means of pairs, NaN without a match."""
    # Matches of hall members themselves are not needed: they do not evolve any more.
    living = own < n
    m = int(opponents.max()) + 1
    pair = own[living] * m + opponents[living]
    count = np.bincount(pair, minlength=n * m)
    table = np.full(n * m, np.nan)
    np.divide(np.bincount(pair, values[living], n * m), count, out=table, where=count > 0)
    return table.reshape(n, m)


# One population:


def _learn_within(training: Training, schedule: AtOnce, generation: int) -> None:
    """Let a population evolve for the epochs of a generation, and archive its champion."""
    team = TEAMS[0]
    activity = f"generation {generation}: {training.name_of(team)}"
    training.update_sampler(team, generation, generation)
    for epoch in range(schedule.joint_epochs):
        training.begin_epoch(team, generation, epoch)
        population = training.ask(team, generation, epoch)
        played = _play_within(training, schedule, generation, epoch, population)
        training.on_activity(activity)
    training.archive_genome(team, training.champion(team, generation, population, played))


def _play_within(
    training: Training, schedule: AtOnce, generation: int, epoch: int, population: Genomes
) -> Played:
    """Play the matches of an epoch among a population and its hall of fame, and let it learn."""
    team = TEAMS[0]
    n = len(population)
    rng = training.generator(seeding.Purpose.OPPONENTS, team, generation, epoch)
    sampled = _sampled_from_halls(training, schedule, epoch, rng)[team]
    hall = training.genomes(team)[sampled]
    groups = training.learners[team].seed_groups
    first, second, seed_indices = pairings_within(groups, schedule.contemporaries, len(hall), rng)
    everyone = training.population(team, np.concatenate([population, hall]))
    key = (training.settings.seed, generation, generation, seeding.Phase.BOTH_LEARN, epoch)
    seeds = seeding.training_seeds(*key, int(seed_indices.max()) + 1)[seed_indices]
    played = training.play(everyone, everyone, (first, second, seeds))
    # Among contemporaries one wins what the other loses: the log has the matches with the hall.
    with_hall = second >= n
    told = played.some(with_hall) if with_hall.any() else None
    scores = played.from_both_sides()
    own = np.concatenate([first, second])
    opponents = np.concatenate([second, first])
    table = partial(table_of_individuals, own, opponents, n)
    fitness = training.log_fitness(team, scores, table, generation, epoch, types.SEVERAL, told)
    if len(sampled):
        # Columns from n on are the hall of fame.
        training.tell_sampler(team, sampled, table(scores.of(team).mean(axis=1))[:, n:])
    living = own < n
    training.tell(team, fitness, everyone, opponents[living], np.tile(seeds, 2)[living])
    return Played(fitness, everyone, met=opponents[own == np.argmax(fitness)])


def pairings_within(
    seed_groups: Indices, contemporaries: int, hall: int, rng: types.Rng
) -> tuple[Indices, Indices, Indices]:
    """Return first players, second ones and indices of seeds (M,) of matches in a population.

    Numbers below n are individuals, others `hall` members of the hall of fame. In a round each
    individual plays once on either side, against another one, never itself. Groups meet groups as
    in `pairings`.
    """
    n = len(seed_groups)
    blocks = _blocks(seed_groups)
    _, size = blocks.shape
    rounds = []
    for begin in range(0, contemporaries, size):
        order = rng.permutation(len(blocks))
        players = blocks[order].ravel()
        opponents = blocks[np.roll(order, 1)]  # in a circle, so that no group meets itself
        shifts = range(min(size, contemporaries - begin))
        rounds += [(players, np.roll(opponents, shift, axis=1).ravel()) for shift in shifts]
    rounds += [(blocks.ravel(), np.full(n, n + member)) for member in range(hall)]
    first, second = map(np.concatenate, zip(*rounds, strict=True))
    # Other seeds in each round.
    first_seeds = np.repeat(np.arange(len(rounds)) * (int(seed_groups.max()) + 1), n)
    return first, second, first_seeds + seed_groups[first]


def _blocks(seed_groups: Indices) -> Indices:
    """Return the individuals of each group (groups, size); where all are one, each is a group."""
    n_groups = int(seed_groups.max()) + 1
    size = len(seed_groups) // n_groups if n_groups > 1 else 1
    return np.argsort(seed_groups, kind="stable").reshape(-1, size)


def learn_by_self_play(training: Training, stage: int) -> None:
    """Let a population learn against its past for the epochs of a generation."""
    schedule = training.settings.schedule
    assert isinstance(schedule, SelfPlay)
    team = TEAMS[0]
    generation = 1 + stage
    training.update_sampler(team, generation, generation)
    epochs = range(schedule.self_play_epochs)
    activity = f"generation {generation}: {training.name_of(team)}"
    genome = improve(training, team, generation, schedule.opponents, epochs, activity)
    training.archive_genome(team, genome)


# Against fixed opponents:


def learn_against(training: Training, stage: int) -> None:
    """Let one team learn until the next entry of the archive."""
    schedule = training.settings.schedule
    assert isinstance(schedule, Against)
    first = stage * schedule.archive_every
    epochs = range(first, first + schedule.epochs_in(stage))
    activity = f"{training.name_of(schedule.team)} against {' and '.join(schedule.met)}"
    scripts = schedule.training_opponents
    genome = improve(training, schedule.team, 1 + stage, 1, epochs, activity, scripts)
    training.archive_genome(schedule.team, genome)


LOOPS: dict[type[Schedule], Callable[[Training, int], None]] = {
    InTurns: learn_in_turns,
    AtOnce: learn_at_once,
    SelfPlay: learn_by_self_play,
    Against: learn_against,
}
"""What runs a stage of each kind of schedule."""


def run_stage(training: Training) -> None:
    """Run the next stage: improve learners, extend the archive, log each epoch."""
    training.begin_stage()
    LOOPS[type(training.settings.schedule)](training, training.stage)
    training.end_stage()


def train(training: Training) -> Training:
    """Run all stages that are left.

    Parameters
    ----------
    training : Training
        A race in memory.

    Returns
    -------
    Training
        The same, after its last stage.

    Examples
    --------
    >>> from matrixworld import coevolution as co
    >>> race = co.Training(co.RaceSettings.of(generations=1, pursuer_epochs=1, evader_epochs=1))
    >>> len(co.train(race).archive["pursuer"])
    2
    """
    while training.stage < training.settings.schedule.n_stages:
        run_stage(training)
    return training
