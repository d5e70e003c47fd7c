"""Writers of curves get one of each measure and team, in a group for each run."""

import sys
from types import SimpleNamespace

import pytest

from run_curves import tensorboard_writer, wandb_writer
from tiny_race import played, tiny_race


class Kept:
    """What stands for a writer of TensorBoard and for a run of Weights & Biases."""

    def __init__(self, *name, **settings):
        self.name, self.settings, self.calls, self.ended = name, settings, [], False
        self.made.append(self)

    def __enter__(self):
        return self

    def __exit__(self, *error):
        self.ended = True

    def add_scalar(self, *call):
        self.calls.append(call)

    def log(self, values):
        self.calls += [(k, v, values["matches"]) for k, v in values.items() if k != "matches"]

    def define_metric(self, name, step_metric):
        assert (name, step_metric) == ("*", "matches")


@pytest.fixture
def made(monkeypatch):
    Kept.made = []
    monkeypatch.setitem(sys.modules, "tensorboardX", SimpleNamespace(SummaryWriter=Kept))
    monkeypatch.setitem(sys.modules, "wandb", SimpleNamespace(init=Kept))
    return Kept.made


def test_writers_get_a_curve_of_each_measure_and_team(made, tmp_path):
    job = {"a/seed-1": tiny_race(seed=1), "b/seed-2": tiny_race(seed=2)}
    with tensorboard_writer(tmp_path / "curves") as write, wandb_writer(project="races") as log:
        for name, settings in job.items():
            run = played(settings, tmp_path / name, on_epoch=write)
            for row in run.rows(0):
                log({"run": name, "seed": settings.seed, **row})
        assert not any(each.ended for each in made)
    columns = run.log()
    own = columns["team"] == "evader"
    for kept in made:
        curve = [call[1:] for call in kept.calls if call[0] == "evader/capture_rate"]
        assert len(curve) == own.sum() > 2
        assert not {name for name, *_ in kept.calls} & {"evader/epoch", "evader/seed"}
        assert kept.ended
    assert curve == list(zip(columns["capture_rate"][own], columns["matches"][own], strict=True))
    of_wandb = [each.settings for each in made if each.settings.get("project")]
    assert [(each["name"], each["config"]) for each in of_wandb] == [
        ("a/seed-1", {"seed": 1}), ("b/seed-2", {"seed": 2}),
    ]  # fmt: skip
