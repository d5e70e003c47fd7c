"""Settings: everything that defines a run. Runs with equal settings are equal bit for bit.

=================  ===============================================================================
module             contents
=================  ===============================================================================
training           `TrainingSettings`: world, policy, learner and budget; settings as JSON values
race               `RaceSettings`: both teams learn
single             `SingleSettings`: one team learns against fixed opponents
memory             memory that a run needs, estimated before it starts
effects            when each setting has an effect; elsewhere it is refused
=================  ===============================================================================

Each field carries its help text (``dataclasses.fields(RaceSettings)[i].metadata["help"]``). The
options of the command line and the docstrings of the classes are made from it. The number of
threads is not a setting, because results do not depend on it.
"""

from __future__ import annotations

from matrixworld.coevolution.settings.effects import NoEffectError
from matrixworld.coevolution.settings.race import ALL_SCHEDULES, RaceSettings
from matrixworld.coevolution.settings.single import SINGLE_DEFAULTS, SingleSettings
from matrixworld.coevolution.settings.training import (
    TrainingSettings,
    settings_from_json,
    settings_to_json,
)

__all__ = [
    "ALL_SCHEDULES",
    "SINGLE_DEFAULTS",
    "NoEffectError",
    "RaceSettings",
    "SingleSettings",
    "TrainingSettings",
    "settings_from_json",
    "settings_to_json",
]
