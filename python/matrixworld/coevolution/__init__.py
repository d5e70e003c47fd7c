"""Co-evolution of pursuers and evaders: races, learners, opponents, evaluation and storage.

A race in a few lines::

    from matrixworld import coevolution

    with coevolution.ProgressBar() as bar:
        run = coevolution.evolve("O", "my-race", learner="es", seed=1, report=bar)

The same call continues after an interruption. ``coevolution.evolve("O", "my-races", seeds=[1, 2])``
does so for many, side by side. ``coevolution.open_run("my-race").record(pursuer=30, evader=10)``
plays an episode again.

All matches are played by one pure function with the arguments of `matrixworld.rollout`. Games are
in `games`, a learner is its settings and three functions of its state (`learners`), and so is a
sampler of opponents (`opponents`). Races are `settings`, which are data; `training` runs their
stages in memory, `runs` keeps them in files, `saved_run` is what users hold, and `jobs` play many.
"""

from __future__ import annotations

from matrixworld._util.imports import lazy

__getattr__, __dir__, __all__ = lazy(__name__, __file__, {})
__all__.remove("Game")  # documented as `matrixworld.Game`
