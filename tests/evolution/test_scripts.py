"""The scripts in evolution/ run, go on where they stopped, and their numbers are correct."""

import random
import re

import pytest

import readable
from evolution_scripts import SCRIPTS, read, run_quickly

LIBRARIES = {"common", "paper_runs", "tabular"}
NAMES = sorted({path.stem for path in SCRIPTS.glob("*.py")} - LIBRARIES)
WITH_TORCH = re.compile("actor_critic|convergence|paper_surrounding|safe_learning")
ONCE = {"evolve_held_out", "scripted_pursuit"}
"""Scripts that tell the time that they took, or keep no runs."""


@pytest.mark.nightly
@pytest.mark.parametrize("name", NAMES)
def test_a_script_says_the_same_again_from_what_it_keeps(name, tmp_path):
    if WITH_TORCH.match(name):
        pytest.importorskip("torch")
    told = run_quickly(name, tmp_path)
    for file in tmp_path.rglob("table.md"):
        assert told.startswith(read(file))
    runs = {path: path.stat().st_mtime_ns for path in tmp_path.rglob("runs/**/payoff.npz")}
    if name not in ONCE:
        assert run_quickly(name, tmp_path) == told
    assert runs == {path: path.stat().st_mtime_ns for path in runs}


def test_the_readable_example_evolves_programs_that_beat_untrained_ones():
    random.seed(2)
    champions = readable.co_evolve(3, 3, 20)
    for team, other in (readable.TEAMS, readable.TEAMS[::-1]):
        first, *_, last = champions[team]
        rivals = {"rivals": champions[other], "seeds": range(100, 116)}
        before, after = readable.play(team, [first, last], **rivals)
        assert after > before + 0.1
        assert len(last) <= readable.PROGRAM.length
