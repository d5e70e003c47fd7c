"""Training in memory: what learners, samplers and matches do in the stages of a run."""
