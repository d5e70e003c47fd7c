"""What the migration table names on this package's side is there."""

from __future__ import annotations

import inspect
import re
from pathlib import Path

import click
import pytest

import matrixworld as mw
from matrixworld.cli import main
from matrixworld.coevolution import SCHEDULES
from matrixworld.envs import INFO_KEYS, Status

TEXT = (Path(__file__).parents[2] / "docs" / "migration.md").read_text(encoding="utf-8")


def test_names_of_the_package() -> None:
    named = set(re.findall(r"`?mw\.(\w+(?:\.\w+)?)", TEXT))
    assert len(named) > 12
    for name in named:
        place = mw
        for part in name.split("."):
            place = getattr(place, part)


def test_infos_and_status() -> None:
    infos = TEXT.split("## Infos")[1].split("## Experiments")[0]
    told = [row.strip("|").split("|") for row in infos.splitlines() if row.startswith("| ")][1:]
    keys = {key for row in told for key in re.findall(r"`(\w+)`", row[1])}
    assert keys <= set(INFO_KEYS)
    # Every key of today; outputs that are added later have no counterpart in the published code.
    assert len(keys) == 14
    assert not keys & {"cost", "evader_survival_rate", "pursuer_survival_rate"}
    fields = {name for row in told for name in re.findall(r"`(\w+)[`\[]", row[2])}
    assert fields <= set(Status.__dataclass_fields__)


def test_options_of_the_commands() -> None:
    evolve = main.get_command(click.Context(main), "evolve")
    assert evolve is not None
    known = {flag for param in evolve.params for flag in param.opts}
    ours = {row.split("|")[2] for row in TEXT.splitlines() if row.count("|") == 3}
    told = {flag for cell in ours for flag in re.findall(r"--[a-z][a-z-]+", cell)}
    assert len(told) > 8
    assert told <= known
    for schedule in SCHEDULES:
        assert schedule in TEXT


def test_arguments() -> None:
    named = {"rows", "cols", "n_pursuers", "n_evaders", "fov", "diagonal", "max_steps", "obstacles"}
    assert named <= set(inspect.signature(mw.WorldConfig).parameters)
    assert all(f"`{name}" in TEXT or f" {name}" in TEXT for name in named)
    for name in re.findall(r"`((?:pursuer|evader)_(?:capture|neighbor|collide|step))", TEXT):
        assert name in mw.Rewards.__dataclass_fields__


@pytest.mark.parametrize("size", [267_405])
def test_the_published_network(size: int) -> None:
    assert mw.Network.for_config(mw.WorldConfig("O"), (400, 300)).genome_size == size
