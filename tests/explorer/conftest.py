"""What tests of pages share: the browser, and runs of different worlds."""

import pytest

from browser import browser, friend
from firefox import firefox
from matrixworld.coevolution import evolve
from tiny_race import tiny_race, tiny_single

__all__ = ["browser", "firefox", "friend"]


@pytest.fixture(scope="module")
def job(tmp_path_factory):
    """Runs of different worlds: obstacles, diagonal moves and turns, and a single team."""
    settings = {
        "race": tiny_race(obstacles=0.15, max_steps=30),
        "turns": tiny_race(rules="TO", diagonal=True, max_steps=20, schedule="hall-of-fame"),
        "single": tiny_single(team="evader", opponent="chaser"),
    }
    runs = evolve(settings, tmp_path_factory.mktemp("job"), threads=1)
    return dict(zip(settings, runs, strict=True))
