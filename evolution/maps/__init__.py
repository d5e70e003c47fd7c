"""Races on maps that evolve, and held-out maps; `map_races.py` asks which maps help."""
