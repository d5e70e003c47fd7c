"""Evaluation: payoff matrices and held-out opponents."""
