"""Games whose right answer is known."""
