"""The registry of learners: settings, checks and factories."""

from __future__ import annotations

import re
from dataclasses import fields, replace

import numpy as np
import pytest

from matrixworld.coevolution import RaceSettings, TrainingSettings
from matrixworld.coevolution.learners import LEARNERS, LearnerEntry, new_learner, untrained
from matrixworld.coevolution.learners.registry import starting_genomes

HELP = {field.name: field.metadata["help"] for field in fields(TrainingSettings)}
SMALL = RaceSettings(rows=8, cols=8, fov=5, hidden=(), population=6)


def test_the_help_of_each_setting_names_the_learners_that_read_it():
    named = {
        (learner, setting)
        for setting, text in HELP.items()
        for learner in LEARNERS
        if re.search(rf"\b{learner}: ", text)
    }
    registered = {(name, setting) for name in LEARNERS for setting in LEARNERS[name].settings}
    assert named == registered


@pytest.mark.parametrize("name", LEARNERS)
def test_the_help_names_all_learners(name):
    assert f"{name} ({LEARNERS[name].title.split(',')[0]}" in HELP["learner"]


@pytest.mark.parametrize(("name", "count"), [("es", 1), ("ga", 6), ("cma", 1)])
def test_new_learner(name, count):
    settings = replace(SMALL, learner=name)
    assert starting_genomes(settings) == count
    genomes = untrained(settings, "evader", count)
    learner = new_learner(settings, "evader", genomes)
    assert np.array_equal(learner.genome, genomes[0])
    assert learner.ask(np.random.default_rng(0)).shape == (6, settings.network.genome_size)


@pytest.mark.parametrize("name", LEARNERS)
def test_settings_of_all_learners_are_checked(name):
    with pytest.raises(ValueError, match="crossover: expected a number at least 0 and at most 1"):
        replace(SMALL, learner=name, crossover=2.0)


class StandingStill:
    """A learner that proposes its first genome again and again."""

    def __init__(self, genome, count):
        self.genome = genome
        self.match_of_candidate = np.zeros(count, dtype=np.intp)

    def ask(self, rng):
        return np.tile(self.genome, (len(self.match_of_candidate), 1))


def test_a_row_adds_a_learner(monkeypatch):
    def check(settings):
        if settings.population > 100:
            raise ValueError(f"population: expected at most 100, got {settings.population}")

    entry = LearnerEntry(
        title="standing still",
        settings={},
        check=check,
        new=lambda settings, team, genomes, rng: StandingStill(genomes[0], settings.population),
    )
    monkeypatch.setitem(LEARNERS, "still", entry)
    settings = replace(SMALL, learner="still")
    learner = new_learner(settings, "pursuer", untrained(settings, "pursuer", 1))
    assert (learner.ask(np.random.default_rng(0)) == learner.genome).all()
    with pytest.raises(ValueError, match="population: expected at most 100, got 101"):
        replace(settings, population=101)
