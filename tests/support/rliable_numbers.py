"""Numbers of the package `rliable` 1.2.0 for the scores below, to compare ours with.

The tests do not install it, because it needs pandas, seaborn and an old arch, which fails to import
beside pandas 3. ``iqm`` is `metrics.aggregate_iqm` of ONE, OTHER and TASK, and ``iqm_ends`` are
those of `library.get_interval_estimates` of TASK with 200,000 samples, `RandomState(0)` and this
LEVEL.
"""

import numpy as np


def scores(runs, tasks, seed):
    """Scores (runs, tasks) in [0, 1] with two decimals, so that some are equal."""
    rng = np.random.default_rng(seed)
    values = np.linspace(0.2, 0.8, tasks) + rng.normal(0, 0.15, (runs, 1))
    return np.round(np.clip(values + rng.normal(0, 0.1, (runs, tasks)), 0, 1), 2)


ONE, OTHER, TASK = scores(9, 5, 1), scores(7, 5, 2), scores(12, 1, 3)
LEVEL = 0.978486770166895
"""Level of the plain percentile interval of `TASK` that equals the expanded one of level 95 %."""

NUMBERS = {
    "iqm": [0.5243478260869565, 0.4989473684210526, 0.135],
    "iqm_ends": [0.06333333333333334, 0.32],
}
