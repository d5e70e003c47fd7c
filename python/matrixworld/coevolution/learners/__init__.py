"""Learners: algorithms that improve the genome of one team from the fitness of its candidates.

`learner` has the interface, `Learner`; each other file an algorithm with its settings. To add one
to the package, write a class with that interface and a subclass of `LearnerSettings` in a file of
its own, and name the settings in the type of `RaceSettings.learner`. Everywhere here, a value out
of range or of another shape raises a ValueError that names it.
"""
