"""Policies and matches: whole episodes in the engine, and matches in which functions play."""

from __future__ import annotations

from matrixworld.play.matches import Callback, Plays, ask, capture_rates
from matrixworld.play.network_policy import NetworkPolicy, check_fits

__all__ = ["Callback", "NetworkPolicy", "Plays", "ask", "capture_rates", "check_fits"]
