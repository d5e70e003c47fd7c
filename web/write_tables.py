"""Write web/src/engine/tables.ts: what the page has in common with the Python package, as data.

    python web/write_tables.py

A test compares the file with what this writes.
"""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import matrixworld as mw
from matrixworld.world import config, conflicts, policy

LINE = 80  # characters
TABLES = Path(__file__).parent / "src/engine/tables.ts"


def numbers(enumeration: Any) -> dict[str, int]:
    """Return the numbers that the engine has for the names of an enumeration."""
    return {member.name: member.value for member in enumeration}


def tables() -> dict[str, Any]:
    """Return all tables by their names in TypeScript."""
    return {
        "INTERACTIONS": numbers(mw.Interaction),
        "OUTCOMES": numbers(mw.Outcome),
        "CAPTURES": numbers(mw.Capture),
        "BLAMES": numbers(mw.Blame),
        "ACTIONS": [action.name for action in mw.Action],
        "KINDS": conflicts.COLLISION_KINDS,
        "FORMS": conflicts.FORMS,
        "CONFLICT_COLUMNS": conflicts.CONFLICT_COLUMNS,
        "AGENT_NAMES": conflicts.AGENT_NAMES,
        "CONFLICT_EVENTS": conflicts.EVENTS,
        "CONFLICT_OUTCOMES": conflicts.OUTCOMES,
        "CONFLICT_SENTENCE": conflicts.SENTENCE,
        "SCRIPTS": policy.SCRIPT_TEXTS,
        "INPUTS": dict(mw.INPUTS),
        "MAP_CHARACTERS": {"free": config.FREE, "blocked": config.BLOCKED},
    }


COMMENTS = {
    "INTERACTIONS": "The numbers that the engine has for the names of enumerations.",
    "ACTIONS": "The actions by their numbers; the last four are diagonal.",
    "KINDS": "The texts of conflicts: templates that Python fills, too.",
    "SCRIPTS": "What each script does.",
    "INPUTS": "The named inputs of a move, in the order of the engine, and what they are.",
    "MAP_CHARACTERS": "Characters of passable and of impassable cells in a map.",
}


def literal(table: Any) -> str:
    """Return a table on one line, or on several if it is long."""
    line = json.dumps(table)
    return line if len(line) < LINE else json.dumps(table, indent=2)


def text() -> str:
    """Return the file."""
    lines = ["// Written by web/write_tables.py from the Python package; do not edit."]
    for name, table in tables().items():
        if name in COMMENTS:
            lines += ["", f"/** {COMMENTS[name]} */"]
        lines += [f"export const {name} = {literal(table)} as const;"]
    return "\n".join(lines) + "\n"


if __name__ == "__main__":
    TABLES.write_text(text(), encoding="utf-8")
