"""Policies and matches: whole episodes in the engine, and matches in which functions play."""

from __future__ import annotations

from matrixworld.play.matches import capture_rates
from matrixworld.play.policies import NetworkPolicy, RatingPolicy, read_genome, save_genome

__all__ = ["NetworkPolicy", "RatingPolicy", "capture_rates", "read_genome", "save_genome"]
