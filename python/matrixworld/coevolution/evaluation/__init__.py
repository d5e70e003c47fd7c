"""Evaluation: what trained genomes score, against each other and against held-out opponents."""
