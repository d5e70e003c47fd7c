"""Learners: what improves a team from the fitness of its candidates."""
