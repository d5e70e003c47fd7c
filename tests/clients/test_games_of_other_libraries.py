"""Recipes in docs/clients whose games other libraries play or whose genomes they make."""

import importlib
import re
import shutil

import pytest

import matrixworld as mw
from pages import ROOT, read
from scripts import python
from tiny_race import results

RECIPES = {"deap_trees": "deap", "neat_networks": "neat", "mpe_tag": "mpe2"}
GAMES = {"deap_trees": "trees", "neat_networks": "ring"}  # whose genomes are objects
CLIENTS = ROOT / "docs" / "clients"
SHORT = {
    "schedule": "hall-of-fame", "generations": 4, "joint_epochs": 4, "population": 12, "seed": 1,
}  # fmt: skip

pytestmark = pytest.mark.filterwarnings("ignore::matrixworld.coevolution.DisengagementWarning")


def lines(name):
    return [line for line in (CLIENTS / f"{name}.py").read_text("utf-8").splitlines() if line]


@pytest.mark.parametrize("name", [*RECIPES, "neat_genomes"])
def test_a_recipe_is_short_and_on_the_page(name):
    assert len(lines(name)) <= 40
    assert f"](clients/{name}.py)" in read("docs/clients.md")


@pytest.mark.slow
@pytest.mark.parametrize("name", RECIPES)
def test_a_recipe_runs_with_few_generations(name, tmp_path):
    pytest.importorskip(RECIPES[name], exc_type=ImportError)
    short, count = re.subn(r"generations=\d+", "generations=2", "\n".join(lines(name)))
    assert count == 1  # else the program would take its full time
    (tmp_path / f"{name}.py").write_text(short, "utf-8")
    for settings in CLIENTS.glob(f"{name}.cfg"):
        shutil.copy(settings, tmp_path)
    done = python(f"{name}.py", cwd=tmp_path)
    assert done.returncode == 0, done.stderr
    assert "arms race" in done.stdout
    (run,) = (tmp_path / "runs").iterdir()
    assert [*map(len, mw.coevolution.open_run(run).archive().values())] == [3, 3]


def test_the_lines_of_deap_in_the_readme_follow_its_toolbox(tmp_path):
    """The first page continues the recipe, from its toolbox on."""
    code = (CLIENTS / "deap_trees.py").read_text("utf-8").partition("text = {")[0]
    block = re.search(r"```python no-run\n(operators = .*?)```", read("README.md"), re.S)
    lines_of_block = block[1].splitlines()
    assert len(lines_of_block) <= 6
    short = block[1].replace("generations=10", "generations=2")
    assert short != block[1]
    (tmp_path / "trees.py").write_text(f"{code}\n{short}", "utf-8")
    done = python("trees.py", cwd=tmp_path)
    assert done.returncode == 0, done.stderr


@pytest.mark.parametrize("name", GAMES)
def test_a_race_of_objects_goes_on_as_if_it_had_not_been_stopped(name, tmp_path):
    pytest.importorskip(RECIPES[name], exc_type=ImportError)
    game = getattr(importlib.import_module(name), GAMES[name])
    left = 27  # rows of epochs, until networks have new nodes

    def stop(row):
        nonlocal left
        left -= 1
        if not left:
            raise mw.coevolution.StopRun

    straight = mw.evolve(out=tmp_path / "straight", game=game, **SHORT)
    with pytest.raises(mw.coevolution.StopRun):
        mw.evolve(out=tmp_path / "stopped", game=game, on_epoch=stop, **SHORT)
    resumed = mw.evolve(out=tmp_path / "stopped", game=game, **SHORT)
    assert results(resumed.path) == results(straight.path)
