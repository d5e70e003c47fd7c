"""Settings as plain JSON values and back."""

from __future__ import annotations

from dataclasses import fields
from enum import Enum
from typing import Any, TypeVar

import numpy as np

from matrixworld import Capture, Interaction, Outcome
from matrixworld.coevolution.settings import RaceSettings, SingleSettings, TrainingSettings
from matrixworld.rules import Rules

Settings = TypeVar("Settings", bound=TrainingSettings)

SETTINGS_OF_KIND: dict[str, type[RaceSettings] | type[SingleSettings]] = {
    "race": RaceSettings,
    "hall-of-fame": RaceSettings,
    "single": SingleSettings,
}

RULE_ENUMS: dict[str, Any] = {
    "interaction": Interaction,
    "obstacle": Outcome,
    "teammate": Outcome,
    "evader": Outcome,
    "pursuer": Outcome,
    "capture": Capture,
}


def settings_to_json(settings: TrainingSettings) -> dict[str, Any]:
    """Return the settings as values that JSON can hold."""
    return {item.name: _plain(getattr(settings, item.name)) for item in fields(settings)}


def settings_from_json(kind: type[Settings], values: dict[str, Any]) -> Settings:
    """Return settings of class `kind`; ValueError names fields that are missing or unknown."""
    expected = {item.name for item in fields(kind)}
    if expected != set(values):
        missing, unknown = sorted(expected - set(values)), sorted(set(values) - expected)
        raise ValueError(f"{kind.__name__}: missing fields {missing}, unknown fields {unknown}")
    return kind(**{name: _restored(name, value) for name, value in values.items()})


def settings_of(config: dict[str, Any]) -> RaceSettings | SingleSettings:
    """Return the settings that a run's config.json holds; ValueError on an unknown kind of run."""
    kind = config["kind"]
    if kind not in SETTINGS_OF_KIND:
        known = ", ".join(SETTINGS_OF_KIND)
        raise ValueError(f"kind of run: expected one of {known}, got {kind!r}")
    return settings_from_json(SETTINGS_OF_KIND[kind], config["settings"])


def _plain(value: Any) -> Any:
    if isinstance(value, Rules):
        return {item.name: _plain(getattr(value, item.name)) for item in fields(value)}
    if isinstance(value, Enum):
        return value.name
    if isinstance(value, np.generic):
        return value.item()
    return list(value) if isinstance(value, tuple) else value


def _restored(name: str, value: Any) -> Any:
    if name == "variant" and isinstance(value, dict):
        return Rules(**{key: _rule(key, item) for key, item in value.items()})
    return tuple(value) if isinstance(value, list) else value


def _rule(name: str, value: Any) -> Any:
    return RULE_ENUMS[name][value] if name in RULE_ENUMS else value
