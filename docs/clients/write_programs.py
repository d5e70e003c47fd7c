"""A loop that writes programs: who proposes them is up to you, and their grades are exact.

    python docs/clients/write_programs.py pursuer archive.jsonl --minutes 10

`propose` here edits lines at random. Put a language model, yourself or `deap.gp` in its place. The
archive keeps all programs, one line of JSON each, and the loop goes on from there.
"""

import argparse
import json
import random
import re
import time
from pathlib import Path

import matrixworld as mw

START = {"pursuer": "-adversary", "evader": "adversary"}
INPUTS = [name for name in mw.Rating.inputs if name not in ("must_yield", "ahead")]
PARENTS, LONGEST = 12, 100


def propose(parents: list[str], grades: list[float], losses: list[list[str]]) -> str:
    """Return a new program: of the best ones, their grades, and the positions they lose most in."""
    text, other = random.choices(parents, k=2)
    place = random.choice([*re.finditer(r"\d+\.?\d*|" + "|".join(INPUTS), text)])
    number, name = f"{random.lognormvariate(-0.5, 1):.2g}", random.choice(INPUTS)
    edits = [
        text[: place.start()] + random.choice([number, name]) + text[place.end() :],
        f"{text} {random.choice('+-')} {number} * {name}",
        f"{random.choice(['min', 'max'])}({text}, {other})",
        f"{text} if {name} < {number} else {other}",
        random.choice(re.split(r" [+-] ", text)),
    ]
    return random.choice(edits)


def graded(text: str, team: str) -> dict:
    """Return a program with its grade, or with the reason why it has none."""
    try:
        found = mw.grade(text, team).teams[team]
    except ValueError as error:
        return {"program": text, "error": str(error)}
    return {"program": text, "grade": found.share, "losses": [str(loss) for loss in found.losses]}


def main() -> None:
    """Propose, grade and archive until the time is over."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("team", choices=START)
    parser.add_argument("archive", type=Path)
    parser.add_argument("--minutes", type=float, default=10)
    args = parser.parse_args()
    kept = args.archive.read_text() if args.archive.exists() else ""
    kept = kept[: kept.rfind("\n") + 1]  # without a line that was cut off
    archive = {each["program"]: each for each in map(json.loads, kept.splitlines())}
    end = time.monotonic() + 60 * args.minutes
    with args.archive.open("a") as file:
        file.truncate(len(kept))  # JSON is ASCII
        while time.monotonic() < end:
            known = sorted((e for e in archive.values() if "grade" in e), key=lambda e: -e["grade"])
            best = [[e[key] for e in known[:PARENTS]] for key in ("program", "grade", "losses")]
            text = propose(*best) if known else START[args.team]
            if text in archive or len(text) > LONGEST:
                continue
            archive[text] = graded(text, args.team)
            file.write(json.dumps(archive[text]) + "\n")
            file.flush()
            if archive[text].get("grade", 0) > max(best[1], default=0):
                print(f"{archive[text]['grade']:.3f}  {text}", flush=True)


if __name__ == "__main__":
    main()
