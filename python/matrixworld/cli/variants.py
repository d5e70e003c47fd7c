"""``matrixworld variants``: the table of rules."""

from __future__ import annotations

import click

from matrixworld import VARIANTS, Capture, Interaction, Outcome, Rules

HEADS = (
    "variant",
    "moves",
    "obstacle",
    "teammate",
    "adversary: evader / pursuer",
    "capture by",
    "the captured",
)
MOVES = {
    Interaction.SIMULTANEOUS: "all at once",
    Interaction.SWARM_TURNS: "team by team",
    Interaction.AGENT_TURNS: "one at a time",
}
OUTCOMES = {Outcome.DISAPPEAR: "disappears", Outcome.REACH: "reaches", Outcome.BOUNCE: "bounces"}
CAPTURES = {Capture.OCCUPATION: "occupation", Capture.SURROUND: "surrounding"}
LEGEND = """\
What becomes of an agent that collides with an obstacle or the border, with a teammate, with an
adversary: it reaches the cell, bounces back to where it was, or disappears.
Occupation: an evader is captured by a pursuer that reaches it. Surrounding: by pursuers, obstacles
and the border on all four sides. Any other row can be made in Python: matrixworld.Rules(...)."""


@click.command("variants")
def variants_command() -> None:
    """Print the nine variants of the game as a table of rules."""
    rows = [HEADS, *(_row(name, rules) for name, rules in VARIANTS.items())]
    widths = [max(map(len, column)) for column in zip(*rows, strict=True)]
    for number, row in enumerate(rows):
        cells = (f"{cell:{width}}" for cell, width in zip(row, widths, strict=True))
        click.secho("  ".join(cells).rstrip(), bold=number == 0)
    click.echo(f"\n{LEGEND}")


def _row(name: str, rules: Rules) -> tuple[str, ...]:
    gone = rules.captured_disappear or rules.evader is Outcome.DISAPPEAR
    return (
        name,
        MOVES[rules.interaction],
        OUTCOMES[rules.obstacle],
        OUTCOMES[rules.teammate],
        f"{OUTCOMES[rules.evader]} / {OUTCOMES[rules.pursuer]}",
        CAPTURES[rules.capture],
        "disappear" if gone else "stay",
    )
