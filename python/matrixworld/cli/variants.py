"""``matrixworld evolve --variants``: the table of rules."""

from __future__ import annotations

import click

from matrixworld.cli.console import print_table
from matrixworld.world.rules import CAPTURE_TEXTS, INTERACTION_TEXTS, OUTCOME_TEXTS, VARIANTS, Rules

HEADS = (
    "variant",
    "moves",
    "obstacle",
    "teammate",
    "adversary: evader / pursuer",
    "capture by",
    "the captured",
)
OUTCOMES = {outcome: text.split()[0] for outcome, text in OUTCOME_TEXTS.items()}
LEGEND = """\
Obstacle, teammate, adversary: what happens to an agent that collides with an obstacle or the
border, with a teammate, with an adversary. It reaches the cell, bounces back to its own cell, or
disappears.
Occupation: a pursuer captures an evader by reaching its cell. Surrounding: pursuers, obstacles and
the border on all four sides capture an evader.
Other rules can be made in Python: matrixworld.Rules(...)."""


def _print_variants(ctx: click.Context, param: click.Parameter, value: bool) -> None:
    if value:
        rows = [HEADS, *(_row(name, rules) for name, rules in VARIANTS.items())]
        print_table(rows, "<" * len(HEADS))
        click.echo(f"\n{LEGEND}")
        ctx.exit()


variants_option = click.option(
    "--variants",
    is_flag=True,
    is_eager=True,
    expose_value=False,
    callback=_print_variants,
    help="print the nine variants of the game as a table of rules",
)


def _row(name: str, rules: Rules) -> tuple[str, ...]:
    return (
        name,
        INTERACTION_TEXTS[rules.interaction],
        OUTCOMES[rules.obstacle],
        OUTCOMES[rules.teammate],
        f"{OUTCOMES[rules.evader]} / {OUTCOMES[rules.pursuer]}",
        CAPTURE_TEXTS[rules.capture],
        "disappear" if rules.removes_captured else "stay",
    )
