"""Which of the paper's claims hold for policy gradients? Its own learner, over ten training seeds.

    python evolution/actor_critic_claims.py             ten seeds, 40 minutes on two cores
    python evolution/actor_critic_claims.py --quick     a small world and two seeds, a minute

`paper_claims.py` asks the same of teams that evolve. These learn by policy gradients (actor-critic
with GAE and PPO's clip), as the paper's do, in its world of 40 x 40 cells, for far fewer epochs:
races of 30 generations, and baselines with as many epochs as their team has in a race. The claims,
their thresholds and their tests are those of `paper_claims.py`.
"""

from __future__ import annotations

import paper_claims
from common import PPO, Numbers, Runs, experiment, play_with_penalty_of_races
from matrixworld.coevolution import RaceSettings
from paper_claims import OPPONENTS, PARTS
from paper_runs import (
    EVADERS_ALONE,
    GENERALISTS,
    PURSUERS_ALONE,
    RACES,
    TINY,
    alone,
    captured,
    generalization,
)

RACE = RaceSettings.of({
    **PPO, "schedule": GENERALISTS, "train_steps": 200, "schedule.generations": 30,
    "schedule.pursuer_epochs": 6, "schedule.evader_epochs": 9,
})  # fmt: skip
QUICK = {
    **TINY, "learner.population": 2, "policy.hidden": (4,), "world.n_pursuers": 3,
    "world.n_evaders": 6, "schedule.generations": 6, "schedule.pursuer_epochs": 2,
    "schedule.evader_epochs": 2, "evaluation_episodes": 4,
}  # fmt: skip


def kinds(quick: bool) -> dict[str, RaceSettings]:
    """Return the settings of the races, and of the baselines that build on nothing."""
    race = RACE.changed(QUICK if quick else {})
    return {
        **{schedule: race.changed({"schedule": schedule}) for schedule in RACES},
        PURSUERS_ALONE: alone(race, "pursuer"),
        EVADERS_ALONE: alone(race, "evader"),
    }


def measured(runs: Runs, quick: bool) -> Numbers:
    """Return captures of the races, and the cross-play of all candidates."""
    evaders = runs[GENERALISTS][0].settings.game.world.n_evaders
    return {"evaders": evaders, **captured(runs, quick), **generalization(runs, quick)}


def tables(numbers: Numbers) -> str:
    """Return the claims, and the scores of all candidates, as tables in Markdown."""
    claims = [
        paper_claims.table(PARTS, paper_claims.on_races(numbers)),
        paper_claims.table(OPPONENTS, paper_claims.on_generalization(numbers)),
        paper_claims.table(("found",), paper_claims.on_swings(numbers)),
    ]
    return "\n\n".join([
        "# Claims of the paper, by policy gradients",
        paper_claims.CELLS,
        *claims,
        paper_claims.counted(claims),
        paper_claims.returns(numbers),
        paper_claims.scores(numbers),
    ])  # fmt: skip


if __name__ == "__main__":
    experiment(
        __doc__,
        kinds=kinds,
        play=play_with_penalty_of_races,
        measure=measured,
        table=tables,
        seeds=10,
        fewest=2,
    )
